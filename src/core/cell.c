/* The periodic cell.                                                                         [R89 sec. 2.3, sec. 4.5.2]
 *
 *   H <- (1 + L dt) H                    H  the two sides of the cell as columns, m;  L  velocity gradient c_ij, 1/s
 *                                                                                                  [R89 4.43, 4.44]
 *   c_i = L (x_i - x_0)                  affine velocity of a particle, besides its own velocity v_i (affine.h)
 *   x_i <- x_i + (v_i + c_i) dt          if v_i = 0, s in x_i - x_0 = H s is constant: the strain is uniform
 *   x_j + H m,   v_j + c_j + L H m       position and velocity of the image of j that i touches, m two integers
 *
 * Forces change v only. v is the same for all images of a particle; their total velocities differ by L H m.
 *
 * Particles are never moved back into the cell. A contact stores two integers that identify the image of its second
 * particle. So positions and velocities never jump, contact histories stay valid, and the time of a search changes no
 * bit of the results. Figures show the image inside the cell.
 *
 * A pair has at most one contact if all images of a particle are farther apart than twice the range of a contact. The
 * range is the largest diameter plus the skin. A sheared cell has the same images as its reduced cell, the one with the
 * shortest sides (Lagrange, Gauss). So the smaller height of the reduced cell must be at least twice the range.
 *
 * Let d (m) be the vector between two particles at the last search, which did not list them, F the deformation gradient
 * since that search, and D (m) the largest diameter. The vector is now F d plus the difference of the displacements of
 * the two particles relative to the affine motion. So strain alone requires a search only when ||F - 1|| (D + skin)
 * reaches the skin.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "affine.h"

static const struct nb_tensor one = {1, 0, 0, 1};

bool nb_cell_create(struct nb_model *model) {
  const struct nb_scene_cell *from = &model->scene->cell;
  if (!from->line)
    return true;
  struct nb_cell *cell = model->cell = nb_own(&model->owner, 1, sizeof *cell);
  if (!cell)
    return false;
  cell->centre = vec(from->x, from->y);
  cell->h = cell->initial_h = tensor(from->h[0], from->h[1], from->h[2], from->h[3]);
  for (size_t i = 0; i < model->particles.count; i++)
    cell->largest_radius = fmax(cell->largest_radius, model->particles.radius[i]);
  nb_cell_reset_travel(cell, model->search.skin);
  return true;
}

void nb_cell_reset_travel(struct nb_cell *cell, double skin) {
  cell->deformation = one;
  cell->travel_limit = skin / 2;
}

int nb_cell_move(struct nb_model *model) {
  struct nb_cell *cell = model->cell;
  const struct nb_tensor rate = model->affine->rate[NB_AFFINE_CELL], step = tensor_scale(model->step, rate);
  cell->strain = tensor_size(step);
  cell->image_velocity = tensor_product(rate, cell->h);
  cell->h = tensor_add(cell->h, tensor_product(step, cell->h));
  cell->deformation = tensor_add(cell->deformation, tensor_product(step, cell->deformation));
  const struct nb_tensor change = tensor_sub(cell->deformation, one);
  const double left = model->search.skin - tensor_size(change) * (2 * cell->largest_radius + model->search.skin);
  cell->travel_limit = left / 2; /* if it is not above 0, a search follows in this cycle, which resets it */
  return left <= 0;
}

/* ---- images ---- */

/* The reduction ends when the square of a side shrinks by less than this fraction. With 0 instead, rounding (1e-16)
 * could repeat the reduction without end. */
static const double reduction_tolerance = 1e-12;

struct nb_wrap nb_cell_wrap(const struct nb_cell *cell) {
  struct nb_wrap wrap = {.centre = cell->centre};
  struct nb_vec a = vec(cell->h.xx, cell->h.yx), b = vec(cell->h.xy, cell->h.yy), na = vec(1, 0), nb = vec(0, 1);
  for (bool on = true; on;) { /* subtract multiples of the shorter side from the longer one, until neither shrinks */
    const bool second = vec_dot(b, b) >= vec_dot(a, a);
    struct nb_vec *longer = second ? &b : &a, *shorter = second ? &a : &b;
    const double n = floor(vec_dot(*longer, *shorter) / vec_dot(*shorter, *shorter) + 0.5);
    const double before = vec_dot(*longer, *longer);
    const struct nb_vec to = vec_sub(*longer, vec_scale(n, *shorter));
    on = vec_dot(to, to) < before * (1 - reduction_tolerance);
    if (!on)
      break;
    *longer = to;
    *(second ? &nb : &na) = vec_sub(second ? nb : na, vec_scale(n, second ? na : nb));
  }
  wrap.h = tensor(a.x, b.x, a.y, b.y), wrap.multiples = tensor(na.x, nb.x, na.y, nb.y);
  wrap.inverse = tensor_inverse(wrap.h);
  return wrap;
}

double nb_wrap_width(const struct nb_wrap *wrap) {
  const double a = vec_length(vec(wrap->h.xx, wrap->h.yx)), b = vec_length(vec(wrap->h.xy, wrap->h.yy));
  return fabs(tensor_determinant(wrap->h)) / (a > b ? a : b);
}

/* Returns the integers m for which `apart` + h m, with the sides h of `wrap`, lies in the cell around the origin. It is
 * then the vector to the nearest image, if that image is closer than half the smaller height. */
static struct nb_vec nearest_image(const struct nb_wrap *wrap, struct nb_vec apart) {
  const struct nb_vec s = tensor_times(wrap->inverse, apart);
  return vec(-floor(s.x + 0.5), -floor(s.y + 0.5));
}

struct nb_vec nb_wrapped(const struct nb_wrap *wrap, struct nb_vec x) {
  return vec_add(x, tensor_times(wrap->h, nearest_image(wrap, vec_sub(x, wrap->centre))));
}

struct nb_vec nb_wrap_image(const struct nb_wrap *wrap, struct nb_vec apart) {
  return tensor_times(wrap->multiples, nearest_image(wrap, apart));
}

struct nb_vec nb_cell_wrapped_position(const struct nb_model *model, size_t slot) {
  if (!model->cell)
    return model->particles.position[slot];
  const struct nb_wrap wrap = nb_cell_wrap(model->cell);
  return nb_wrapped(&wrap, model->particles.position[slot]);
}

enum nb_status nb_cell_check_width(const struct nb_model *model, struct nb_error *error) {
  const struct nb_wrap wrap = nb_cell_wrap(model->cell);
  const double width = nb_wrap_width(&wrap), least = 2 * (2 * model->cell->largest_radius + model->search.skin);
  if (width >= least)
    return NB_OK;
  const char *m = nb_unit(model->scene, " m"), *s = nb_unit(model->scene, " s");
  nb_error_set(
      error, model->cycle ? NB_BROKEN : NB_BAD_USE,
      "the cell is %g%s wide at cycle %lu, at time %g%s: a particle could have two images of another particle as "
      "neighbours. "
      "Expected at least twice the sum of the largest diameter and the skin, %g%s: make the cell wider, or the skin "
      "smaller",
      width, m, model->cycle, model->time, s, least, m);
  error->line = model->scene->cell.line;
  return error->status;
}

/* ---- measures ---- */

double nb_cell_area(const struct nb_cell *cell) { return fabs(tensor_determinant(cell->h)); }
double nb_cell_area_first(const struct nb_cell *cell) { return fabs(tensor_determinant(cell->initial_h)); }

struct nb_tensor nb_cell_strain(const struct nb_cell *cell) {
  return tensor_symmetric(tensor_sub(tensor_product(cell->h, tensor_inverse(cell->initial_h)), one));
}
