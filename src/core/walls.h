/* Walls: position and motion of the segments, and the point of a wall nearest to a particle.          [CS79 figure 4]
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stddef.h>

#include "vec.h"

struct nb_walls {
  size_t count;
  struct nb_vec *pivot; /* P, m [CS79 figure 4] */
  struct nb_vec *point; /* point of the wall's line nearest to P, m; P itself if h0 = 0 */
  struct nb_vec *along; /* unit vector along the wall */
  double *h0, *h1, *h2; /* point is h0 to the left of P; the wall's ends are point + h1 along and point + h2 along, m */
  struct nb_vec *velocity;        /* velocity of P in the last step, m/s; a change sets the velocity of the next step */
  double *spin;                   /* angular velocity about P in that step, counterclockwise, rad/s */
  struct nb_vec *turn;            /* (1 - cos phi)/dt and sin phi/dt, phi the rotation in the last step, 1/s */
  double *angle;                  /* rotation since the start, rad */
  struct nb_vec *search_position; /* the two ends of each wall at the last search, m */
  bool *removed;                  /* removed from the scene (loading/remove.c); NULL when no stage removes any */
};

/* Velocity of the wall's point that is at q now, m/s: its displacement in the last step over the step. A particle's
 * half-step velocity is defined in the same way, so both belong to the same time. */
static inline struct nb_vec nb_wall_velocity(const struct nb_walls *walls, int wall, struct nb_vec q) {
  const struct nb_vec arm = vec_sub(q, walls->pivot[wall]), turn = walls->turn[wall];
  return vec_add(walls->velocity[wall], vec(turn.x * arm.x - turn.y * arm.y, turn.y * arm.x + turn.x * arm.y));
}
static inline struct nb_vec nb_wall_end(const struct nb_walls *walls, int wall, int end) {
  return vec_add(walls->point[wall], vec_scale(end ? walls->h2[wall] : walls->h1[wall], walls->along[wall]));
}

/* s limited to the range from h1 to h2. */
static inline double nb_wall_clamp(double s, double h1, double h2) {
  const double past_first = s > h1 ? s : h1;
  return past_first < h2 ? past_first : h2;
}
/* The distance along the wall from `point` to the wall's point nearest to x, m; and the nearest point itself. */
static inline double nb_wall_projection(const struct nb_walls *walls, int wall, struct nb_vec x) {
  const double s = vec_dot(vec_sub(x, walls->point[wall]), walls->along[wall]);
  return nb_wall_clamp(s, walls->h1[wall], walls->h2[wall]);
}
static inline struct nb_vec nb_wall_nearest(const struct nb_walls *walls, int wall, struct nb_vec x) {
  return vec_add(walls->point[wall], vec_scale(nb_wall_projection(walls, wall, x), walls->along[wall]));
}
/* The vector from the nearest point to x, m. It is computed relative to `point`, so a wall far from the origin loses no
 * digits. */
static inline struct nb_vec nb_wall_separation(const struct nb_walls *walls, int wall, struct nb_vec x) {
  return vec_sub(vec_sub(x, walls->point[wall]), vec_scale(nb_wall_projection(walls, wall, x), walls->along[wall]));
}
