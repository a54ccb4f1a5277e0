/* Walls: segments, where they are, how they move, and which of their points is nearest.                  [CS79 figure 4]
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_WALLS_H
#define NB_WALLS_H

#include <stddef.h>

#include "vec.h"

struct nb_walls {
  size_t count;
  struct nb_vec *pivot;    /* P, m [CS79 figure 4] */
  struct nb_vec *point;    /* the point of the wall's line that is nearest to P: P itself, unless h0 is not 0; m */
  struct nb_vec *along;    /* unit vector along the wall */
  double *h0, *h1, *h2;    /* point = P + h0 left of along; its ends are point + h1 along and point + h2 along, m */
  struct nb_vec *velocity; /* of P over the step behind; over the one ahead once a stage has begun, m/s */
  double *spin;            /* about P, counterclockwise, as old as the velocity, rad/s */
  struct nb_vec *turn;     /* (1 - cos phi)/dt and sin phi/dt, phi the angle of the step behind, 1/s */
  double *angle;           /* turned since the start, rad */
  struct nb_vec *search_position; /* two for each wall: its ends at the last search */
};

/* Velocity of the wall where it meets a body: how far its point that is at q now has come over the step behind, by the step;
 * m/s. A body's velocity at the half step is the same of its centre, so the two are of one time. */
static inline struct nb_vec nb_wall_velocity(const struct nb_walls *walls, int wall, struct nb_vec q) {
  const struct nb_vec arm = vec_sub(q, walls->pivot[wall]), turn = walls->turn[wall];
  return vec_add(walls->velocity[wall], vec(turn.x * arm.x - turn.y * arm.y, turn.y * arm.x + turn.x * arm.y));
}
static inline struct nb_vec nb_wall_end(const struct nb_walls *walls, int wall, int end) {
  return vec_add(walls->point[wall], vec_scale(end ? walls->h2[wall] : walls->h1[wall], walls->along[wall]));
}

/* s, but not beyond the ends of a wall. */
static inline double nb_wall_clamp(double s, double h1, double h2) {
  const double past_first = s > h1 ? s : h1;
  return past_first < h2 ? past_first : h2;
}
/* How far along the wall from its `point` the nearest one to x lies, m; and that one. */
static inline double nb_wall_projection(const struct nb_walls *walls, int wall, struct nb_vec x) {
  const double s = vec_dot(vec_sub(x, walls->point[wall]), walls->along[wall]);
  return nb_wall_clamp(s, walls->h1[wall], walls->h2[wall]);
}
static inline struct nb_vec nb_wall_nearest(const struct nb_walls *walls, int wall, struct nb_vec x) {
  return vec_add(walls->point[wall], vec_scale(nb_wall_projection(walls, wall, x), walls->along[wall]));
}
/* From there to x, rounded from `point` and not from the origin: a wall may lie far from it. */
static inline struct nb_vec nb_wall_separation(const struct nb_walls *walls, int wall, struct nb_vec x) {
  return vec_sub(vec_sub(x, walls->point[wall]), vec_scale(nb_wall_projection(walls, wall, x), walls->along[wall]));
}

#endif
