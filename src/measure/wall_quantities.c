/* Quantities of a wall.
 *
 *   eccentricity   (sum s F_n/sum F_n)/(L/2)      s    position of a contact along the wall, from its middle, m
 *                                                 F_n  force of the particle on the wall along the wall's normal, N
 *                                                 L    length of the wall, m           e/(L/2) of [CS79 tables 1-3]
 *   obliquity      the largest |F_s|/(mu F_n + c) of the wall's contacts, dimensionless, with friction mu and
 *                  cohesion c, N; here F_s and F_n are without dashpots (loads.c)
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "region.h"

struct sums {
  struct nb_vec force; /* N */
  double moment;       /* moment of the force about P, N m */
  double normal, arm;  /* sum F_n, N; sum s F_n, N m */
  double obliquity;
};

/* Sums over the contacts of a wall. `loads`: the obliquity, too. */
static struct sums sums(const struct nb_model *model, const struct nb_monitor *monitor, bool loads) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_walls *walls = &model->walls;
  const int wall = monitor->a;
  const double middle = (walls->h1[wall] + walls->h2[wall]) / 2;
  struct sums sum = {.force = vec(0, 0)};
  for (size_t c = contacts->wall_from; c < contacts->count; c++) {
    if (contacts->b[c] != wall)
      continue;
    const struct nb_vec x = model->particles.position[contacts->a[c]],
                        force = vec_scale(-1, nb_contact_force(contacts, c));
    const double normal = vec_dot(force, vec_clockwise(walls->along[wall]));
    sum.force = vec_add(sum.force, force);
    sum.moment += vec_cross(vec_sub(nb_wall_nearest(walls, wall, x), walls->pivot[wall]), force);
    sum.normal += normal;
    sum.arm += (nb_wall_projection(walls, wall, x) - middle) * normal;
    if (loads && nb_touches(contacts, c))
      sum.obliquity = fmax(sum.obliquity, nb_contact_load(model, c).obliquity);
  }
  return sum;
}

static double half_length(const struct nb_model *model, const struct nb_monitor *monitor) {
  return (model->walls.h2[monitor->a] - model->walls.h1[monitor->a]) / 2;
}

NB_QUANTITY(wall_x, model->walls.pivot[monitor->a].x)
NB_QUANTITY(wall_y, model->walls.pivot[monitor->a].y)
NB_QUANTITY(wall_angle, model->walls.angle[monitor->a])
NB_QUANTITY(wall_spin, model->walls.spin[monitor->a])
NB_QUANTITY(wall_fx, sums(model, monitor, false).force.x)
NB_QUANTITY(wall_fy, sums(model, monitor, false).force.y)
NB_QUANTITY(wall_moment, sums(model, monitor, false).moment)
NB_QUANTITY(wall_obliquity, sums(model, monitor, true).obliquity)

static double wall_eccentricity(const struct nb_model *model, const struct nb_monitor *monitor) {
  const struct sums sum = sums(model, monitor, false);
  return sum.normal != 0 ? sum.arm / sum.normal / half_length(model, monitor) : 0;
}

enum { WALL = 1 << NB_MONITOR_WALL };
const struct nb_quantity_kind nb_wall_kinds[] = {
    {"x", WALL, "m", 0, wall_x, "position of the wall's point P"},
    {"y", WALL, "m", 0, wall_y, "position of the wall's point P"},
    {"angle", WALL, "rad", 0, wall_angle, "rotation since the start, counterclockwise"},
    {"spin", WALL, "rad/s", 0, wall_spin, "angular velocity over the last step"},
    {"fx", WALL, "N", 0, wall_fx, "force of the particles on the wall"},
    {"fy", WALL, "N", 0, wall_fy, "force of the particles on the wall"},
    {"moment", WALL, "N.m", 0, wall_moment, "moment of the particles' forces about P, counterclockwise"},
    {"eccentricity", WALL, "1", 0, wall_eccentricity,
     "distance of the resultant normal force from the wall's middle, over half the wall's length; positive towards the "
     "wall's second end: e/(L/2) of [CS79 tables 1-3]"},
    {"obliquity", WALL, "1", NB_READS_LOADS, wall_obliquity,
     "shear force over its limit, the largest of the wall's contacts; 0 without friction", NB_AT_LEAST_0},
    {.name = NULL},
};
