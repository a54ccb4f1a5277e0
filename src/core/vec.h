/* Vectors in the plane, by value; and pi.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <math.h>

#define NB_PI 3.14159265358979323846

struct nb_vec {
  _Alignas(2 * sizeof(double)) double x;
  double y;
};

static inline struct nb_vec vec(double x, double y) { return (struct nb_vec){x, y}; }
static inline struct nb_vec vec_add(struct nb_vec a, struct nb_vec b) { return vec(a.x + b.x, a.y + b.y); }
static inline struct nb_vec vec_sub(struct nb_vec a, struct nb_vec b) { return vec(a.x - b.x, a.y - b.y); }
static inline struct nb_vec vec_scale(double s, struct nb_vec a) { return vec(s * a.x, s * a.y); }
static inline double vec_dot(struct nb_vec a, struct nb_vec b) { return a.x * b.x + a.y * b.y; }
static inline double vec_cross(struct nb_vec a, struct nb_vec b) { return a.x * b.y - a.y * b.x; }
static inline double vec_length(struct nb_vec a) { return sqrt(a.x * a.x + a.y * a.y); }
/* e rotated clockwise by 90 degrees: t = (e2, -e1) [CS79 10]. */
static inline struct nb_vec vec_clockwise(struct nb_vec e) { return vec(e.y, -e.x); }
/* The components of an array of vectors as one array. */
static inline double *vec_flat(struct nb_vec *first) { return (double *)(void *)first; }

/* Both components in one register, for loops that gather vectors: the same sums with half the instructions. */
typedef double nb_both __attribute__((vector_size(2 * sizeof(double)), may_alias));
static inline nb_both vec_both(const struct nb_vec *at) { return *(const nb_both *)(const void *)at; }
static inline void vec_put(struct nb_vec *at, nb_both both) { *(nb_both *)(void *)at = both; }
