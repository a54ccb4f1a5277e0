/* A box of four walls that follow a strain rate.
 *
 *   v_P = (n.L n) (n.(P - x_0)) n         dh = (e.L e) h dt
 *
 *   P    middle of a wall, m
 *   v_P  velocity of P, m/s               dh   change of h in a step, m
 *   x_0  the middle between opposite walls, m
 *   n, e unit vectors normal to the wall and along it
 *   h    distance of an end of the wall from P, m
 *   L    strain rate, extension positive, 1/s
 *
 * As long as L has no shear in the axes of the box, the corners move as x_(N+1) - x_0 = (1 + L dt)(x_N - x_0), so they
 * stay closed. The walls grow or shrink at their ends; a contact with a wall uses only the velocity v_P.
 *
 * The stress of the box is computed from the forces F of its walls on particles, at the points of contact X:
 *
 *   s_ij = -(1/V) sum F_i (X - x_0)_j        compression positive, V the box's area times the thickness, m3
 *
 * At rest and without gravity this equals the mean stress of the assembly inside. The stress of the walls uses the foot
 * of the perpendicular from x_0 to the wall's line instead of X, and is the mean traction of opposite walls: s_xx is
 * the mean of the forces of the east and the west wall, along their normals, over height and thickness. Without
 * friction at the walls, the stress of the box and the stress of the walls have the same s_xx and s_yy.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "loading.h"

#include "core/affine.h"
#include "measure/region.h"

int nb_box_first_wall(const struct nb_scene *scene) {
  for (size_t w = 0; w + NB_BOX_SIDES <= scene->wall_count; w++)
    if (scene->walls[w].inx != 0 || scene->walls[w].iny != 0)
      return (int)w;
  return -1;
}

bool nb_box_strained_in(const struct nb_scene *scene, size_t stage) {
  const int first = nb_box_first_wall(scene);
  bool follows = false;
  for (size_t s = 0; s <= stage; s++) {
    const struct nb_stage *it = &scene->stages[s];
    for (size_t m = 0; m < it->motion_count; m++)
      if (it->motions[m].wall >= first && it->motions[m].wall < first + NB_BOX_SIDES)
        follows = false;
    follows = follows || it->box_line || it->servo.box;
  }
  return follows;
}

bool nb_box_is_strained(const struct nb_model *model) {
  return model->stage && nb_box_strained_in(model->scene, (size_t)(model->stage - model->scene->stages));
}

/* The middle between opposite walls. */
static struct nb_vec centre(const struct nb_walls *walls, int first) {
  struct nb_vec sum = {0, 0};
  for (int w = first; w < first + NB_BOX_SIDES / 2; w++) {
    const struct nb_vec n = vec_clockwise(walls->along[w]);
    sum = vec_add(sum, vec_scale(vec_dot(n, vec_add(walls->pivot[w], walls->pivot[w + 2])) / 2, n));
  }
  return sum;
}

void nb_box_set_velocities(struct nb_model *model) {
  struct nb_walls *walls = &model->walls;
  const int first = nb_box_first_wall(model->scene);
  const struct nb_tensor rate = model->affine->rate[NB_AFFINE_BOX];
  const struct nb_vec middle = centre(walls, first);
  for (int w = first; w < first + NB_BOX_SIDES; w++) {
    const struct nb_vec e = walls->along[w], n = vec_clockwise(e);
    const double distance = vec_dot(n, vec_sub(walls->pivot[w], middle));
    const double stretch = 1 + model->step * vec_dot(e, tensor_times(rate, e));
    walls->velocity[w] = vec_scale(distance * vec_dot(n, tensor_times(rate, n)), n);
    walls->h1[w] *= stretch, walls->h2[w] *= stretch;
  }
}

struct nb_vec nb_box_sides(const struct nb_model *model) {
  const struct nb_walls *walls = &model->walls;
  const int first = nb_box_first_wall(model->scene);
  double sides[2];
  for (int k = 0; k < 2; k++)
    sides[k] = fabs(
        vec_dot(vec_clockwise(walls->along[first + k]), vec_sub(walls->pivot[first + k + 2], walls->pivot[first + k])));
  return vec(sides[1], sides[0]);
}

struct nb_vec nb_box_initial_sides(const struct nb_scene *scene) {
  const struct nb_wall *south = &scene->walls[nb_box_first_wall(scene)], *east = south + 1;
  return vec(south->h2 - south->h1, east->h2 - east->h1);
}

double nb_box_porosity(const struct nb_model *model) {
  const struct nb_particles *particles = &model->particles;
  const struct nb_vec sides = nb_box_sides(model);
  double area = 0;
  for (size_t k = 0; k < particles->count; k++) {
    const size_t i = (size_t)particles->slot[k];
    const double radius = particles->radius[i];
    area += nb_removed(model, i) ? 0 : NB_PI * radius * radius;
  }
  return 1 - area / (sides.x * sides.y);
}

enum box_sides { SOUTH_AND_NORTH, EAST_AND_WEST, ALL_SIDES };

/* -sum F_i X_j over the contacts with the walls `which` of the box, N m; F is the force on the particle and X the
 * vector from the middle of the box to the contact. `at_middle`: X ends at the foot of the perpendicular to the wall's
 * line. */
static struct nb_tensor virial(const struct nb_model *model, enum box_sides which, bool at_middle) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_walls *walls = &model->walls;
  const int first = nb_box_first_wall(model->scene);
  const struct nb_vec middle = centre(walls, first);
  struct nb_tensor sum = {0, 0, 0, 0};
  for (size_t c = model->contacts.wall_from; c < contacts->count; c++) {
    const int w = contacts->b[c];
    if (w < first || w >= first + NB_BOX_SIDES || (which != ALL_SIDES && (w - first) % 2 != (int)which))
      continue;
    const struct nb_vec at = nb_wall_nearest(walls, w, model->particles.position[contacts->a[c]]);
    const struct nb_vec n = vec_clockwise(walls->along[w]), x = vec_sub(at, middle);
    sum = tensor_sub(sum, tensor_outer(nb_contact_force(contacts, c), at_middle ? vec_scale(vec_dot(n, x), n) : x));
  }
  return sum;
}

static double volume(const struct nb_model *model) {
  const struct nb_vec sides = nb_box_sides(model);
  return sides.x * sides.y * nb_thickness(model);
}

struct nb_tensor nb_box_stress(const struct nb_model *model) {
  return tensor_scale(1 / volume(model), virial(model, ALL_SIDES, false));
}

struct nb_tensor nb_walls_stress(const struct nb_model *model) {
  return tensor_scale(1 / volume(model), virial(model, ALL_SIDES, true));
}

/* The trace of `virial` over two opposite walls is their mean normal force times their distance, whatever the direction
 * of the box. */
double nb_walls_ratio(const struct nb_model *model) {
  const struct nb_tensor vertical = virial(model, SOUTH_AND_NORTH, true),
                         horizontal = virial(model, EAST_AND_WEST, true);
  const struct nb_vec sides = nb_box_sides(model);
  const double v = vertical.xx + vertical.yy, h = horizontal.xx + horizontal.yy;
  return v != 0 ? h * sides.y / (v * sides.x) : 0;
}

double nb_walls_residual(const struct nb_model *model) {
  const int first = nb_box_first_wall(model->scene);
  struct nb_vec sum = vec(0, 0);
  for (size_t c = model->contacts.wall_from; c < model->contacts.count; c++)
    if (model->contacts.b[c] >= first && model->contacts.b[c] < first + NB_BOX_SIDES)
      sum = vec_add(sum, nb_contact_force(&model->contacts, c));
  return vec_length(sum);
}
