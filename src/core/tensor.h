/* Second-order tensors in the plane, by value: stress, fabric, velocity gradient.
 *
 * The principal values T_1, T_2 and the direction theta, rad, of a tensor T are those of its symmetric part, from
 * Mohr's circle [R89 figure 4.1]:
 *   T_1,2 = (T_xx + T_yy)/2 +- r                        major and minor               [R89 4.52, 4.53]
 *   r = sqrt((T_xy + T_yx)^2 + (T_xx - T_yy)^2)/2       radius of the circle
 *   theta = 1/2 arctan((T_xy + T_yx)/(T_xx - T_yy))     from x to the major axis, counterclockwise [R89 4.54]
 * The arctangent of the quotient may give the minor axis; atan2 gives the major one, -pi/2 < theta <= pi/2.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "vec.h"

struct nb_tensor {
  double xx, xy, yx, yy;
};

static inline struct nb_tensor tensor(double xx, double xy, double yx, double yy) {
  return (struct nb_tensor){xx, xy, yx, yy};
}
static inline struct nb_tensor tensor_add(struct nb_tensor a, struct nb_tensor b) {
  return tensor(a.xx + b.xx, a.xy + b.xy, a.yx + b.yx, a.yy + b.yy);
}
static inline struct nb_tensor tensor_sub(struct nb_tensor a, struct nb_tensor b) {
  return tensor(a.xx - b.xx, a.xy - b.xy, a.yx - b.yx, a.yy - b.yy);
}
static inline struct nb_tensor tensor_scale(double s, struct nb_tensor a) {
  return tensor(s * a.xx, s * a.xy, s * a.yx, s * a.yy);
}
/* A_ij v_j, such as the velocity at the position v if A is a velocity gradient. */
static inline struct nb_vec tensor_times(struct nb_tensor a, struct nb_vec v) {
  return vec(a.xx * v.x + a.xy * v.y, a.yx * v.x + a.yy * v.y);
}
static inline struct nb_tensor tensor_product(struct nb_tensor a, struct nb_tensor b) { /* A_ij B_jk */
  return tensor(a.xx * b.xx + a.xy * b.yx, a.xx * b.xy + a.xy * b.yy, a.yx * b.xx + a.yy * b.yx,
                a.yx * b.xy + a.yy * b.yy);
}
static inline struct nb_tensor tensor_transpose(struct nb_tensor a) { return tensor(a.xx, a.yx, a.xy, a.yy); }
static inline struct nb_tensor tensor_turned(struct nb_tensor q, struct nb_tensor a) { /* Q A Q^T */
  return tensor_product(q, tensor_product(a, tensor_transpose(q)));
}
static inline double tensor_determinant(struct nb_tensor a) { return a.xx * a.yy - a.xy * a.yx; }
static inline struct nb_tensor tensor_inverse(struct nb_tensor a) {
  return tensor_scale(1 / tensor_determinant(a), tensor(a.yy, -a.xy, -a.yx, a.xx));
}
/* a_i b_j: the contribution of one contact to a stress, or of one normal to a fabric. */
static inline struct nb_tensor tensor_outer(struct nb_vec a, struct nb_vec b) {
  return tensor(a.x * b.x, a.x * b.y, a.y * b.x, a.y * b.y);
}
static inline struct nb_tensor tensor_symmetric(struct nb_tensor a) {
  const double mixed = (a.xy + a.yx) / 2;
  return tensor(a.xx, mixed, mixed, a.yy);
}
static inline double tensor_trace(struct nb_tensor a) { return a.xx + a.yy; }
static inline double tensor_size(struct nb_tensor a) { /* root of the sum of squares of the components */
  return sqrt(a.xx * a.xx + a.xy * a.xy + a.yx * a.yx + a.yy * a.yy);
}
static inline double tensor_largest(struct nb_tensor a) { /* largest absolute value of a component */
  const double parts[] = {fabs(a.xx), fabs(a.xy), fabs(a.yx), fabs(a.yy)};
  double most = 0;
  for (int k = 0; k < 4; k++)
    most = parts[k] > most ? parts[k] : most;
  return most;
}

static inline double tensor_mean(struct nb_tensor a) { return (a.xx + a.yy) / 2; } /* centre of Mohr's circle */
static inline double tensor_radius(struct nb_tensor a) {
  const double mixed = a.xy + a.yx, apart = a.xx - a.yy;
  return sqrt(mixed * mixed + apart * apart) / 2;
}
static inline double tensor_major(struct nb_tensor a) { return tensor_mean(a) + tensor_radius(a); }
static inline double tensor_minor(struct nb_tensor a) { return tensor_mean(a) - tensor_radius(a); }
static inline double tensor_angle(struct nb_tensor a) { /* rad; 0 for an isotropic tensor */
  const double angle = atan2(a.xy + a.yx, a.xx - a.yy) / 2;
  return angle > -1.57079632679489661923 ? angle
                                         : 1.57079632679489661923; /* atan2 gives -pi if its first argument is -0 */
}
