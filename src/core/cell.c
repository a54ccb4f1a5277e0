/* The periodic cell.                                                      [R89 2.3, 4.5.2]
 *
 *   H <- (1 + L dt) H                    L = c_ij, the strain rate tensor                    [R89 4.43, 4.44]
 *   c_i = L (x_i - x_0)                  imposed velocity of a particle, besides its own velocity v_i (affine.c)
 *   x_i <- x_i + (v_i + c_i) dt          so x_i - x_0 = H s keeps its s when v = 0: a uniform strain
 *   x_j + H m,   v_j + c_j + L H m       place and velocity of the copy of j that i meets
 *
 * v is what forces change. It is the same of all copies of a body, whose whole velocities differ by L H m.
 *
 * Nothing is ever put back into the cell: a body goes where it goes, and a contact knows by two whole numbers which copy of its
 * second body the first one meets. So no position and no velocity jumps, contacts remember what they remember, and when contacts
 * are looked for changes no bit. What is drawn is wrapped: the copy inside the cell.
 *
 * A body near another has one copy there and no more as long as every copy of a body is farther from it than twice the reach of
 * a contact, the largest diameter and the skin. A cell that has been sheared far is as good as an upright one with the same
 * copies (Lagrange, Gauss); the height of that one is what must be twice as much.
 *
 * A pair that was apart by d at the last search, and not listed, is apart by F d + what the two have gone since besides being
 * carried by F. So straining alone costs a search only when ||F - 1|| (D + skin) comes to the skin.
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
    cell->largest_radius = fmax(cell->largest_radius, model->particles.surface[i].radius);
  nb_cell_reset_travel(cell, model->search.skin);
  return true;
}

void nb_cell_reset_travel(struct nb_cell *cell, double skin) {
  cell->deformation = one;
  cell->travel_limit = skin / 2;
}

int nb_cell_move(struct nb_model *model) {
  struct nb_cell *cell = model->cell;
  if (!(model->search.skin < INFINITY))
    cell->deformation = one; /* nothing is searched for */
  const struct nb_tensor rate = model->affine->rate[NB_AFFINE_CELL], step = tensor_scale(model->step, rate);
  cell->image_velocity = tensor_product(rate, cell->h);
  cell->h = tensor_add(cell->h, tensor_product(step, cell->h));
  cell->deformation = tensor_add(cell->deformation, tensor_product(step, cell->deformation));
  const struct nb_tensor change = tensor_sub(cell->deformation, one);
  const double strained =
      sqrt(change.xx * change.xx + change.xy * change.xy + change.yx * change.yx + change.yy * change.yy);
  const double left = strained > 0 ? model->search.skin - strained * (2 * cell->largest_radius + model->search.skin)
                                   : model->search.skin;
  cell->travel_limit = left > 0 ? left / 2 : 0;
  return left <= 0;
}

/* ---- which copy ---- */

/* A side that becomes shorter by less than this share of its square, 1, is as short as rounding, 1e-16, can tell: so the search for
 * the shortest sides ends. */
static const double reduction_tolerance = 1e-12;

struct nb_wrap nb_cell_wrap(const struct nb_cell *cell) {
  struct nb_wrap wrap = {.centre = cell->centre};
  struct nb_vec a = vec(cell->h.xx, cell->h.yx), b = vec(cell->h.xy, cell->h.yy), na = vec(1, 0), nb = vec(0, 1);
  for (bool on = true; on;) { /* the longer less whole numbers of the shorter, until it is as short as can be */
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
  wrap.h = tensor(a.x, b.x, a.y, b.y), wrap.whole = tensor(na.x, nb.x, na.y, nb.y);
  wrap.inverse = tensor_inverse(wrap.h);
  return wrap;
}

double nb_wrap_width(const struct nb_wrap *wrap) {
  const double a = vec_length(vec(wrap->h.xx, wrap->h.yx)), b = vec_length(vec(wrap->h.xy, wrap->h.yy));
  return fabs(tensor_determinant(wrap->h)) / (a > b ? a : b);
}

/* H m of the nearest copy: m of `wrap`. */
static struct nb_vec sides(const struct nb_wrap *wrap, struct nb_vec apart) {
  const struct nb_vec s = tensor_times(wrap->inverse, apart);
  return vec(-floor(s.x + 0.5), -floor(s.y + 0.5));
}

struct nb_vec nb_wrapped(const struct nb_wrap *wrap, struct nb_vec x) {
  return vec_add(x, tensor_times(wrap->h, sides(wrap, vec_sub(x, wrap->centre))));
}

struct nb_vec nb_wrap_image(const struct nb_wrap *wrap, struct nb_vec apart) {
  return tensor_times(wrap->whole, sides(wrap, apart));
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
  return nb_error_set(error, model->cycle ? NB_BROKEN : NB_BAD_USE,
                      "line %d: the cell is %g m wide at cycle %lu, at %g s: a body would meet another in two places. "
                      "The least is twice the largest diameter and the skin, %g m",
                      model->scene->cell.line, width, model->cycle, model->time, least);
}

/* ---- what is asked for ---- */

double nb_cell_area(const struct nb_cell *cell) { return fabs(tensor_determinant(cell->h)); }
double nb_cell_area_first(const struct nb_cell *cell) { return fabs(tensor_determinant(cell->initial_h)); }

struct nb_tensor nb_cell_strain(const struct nb_cell *cell) {
  return tensor_symmetric(tensor_sub(tensor_product(cell->h, tensor_inverse(cell->initial_h)), one));
}
