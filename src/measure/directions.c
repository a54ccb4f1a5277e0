/* Distributions of contacts and contact forces over the directions.                  [Rothenburg and Bathurst 1989]
 *
 * With the direction theta of the contact normal, rad, the distributions are, to second order,
 *
 *   E(theta)    = 1/(2 pi) (1 + a cos 2(theta - theta_a))       density of contacts
 *   N(theta)    = N_0 (1 + a_n cos 2(theta - theta_n))          mean normal force, N
 *   T(theta)    = N_0 a_t sin 2(theta - theta_t)                mean shear force along t = (n2, -n1), N
 *
 * The stress that follows from these distributions has
 *
 *   sin Phi = 1/2 |a + a_n + a_t| / (1 + 1/2 a.a_n)
 *
 * where each coefficient is a vector in Mohr's plane: a has the length a and the direction 2 theta_a, and a_n and a_t
 * have the directions 2 theta_n and 2 theta_t. The relation neglects higher harmonics, and any correlation of the
 * forces with the length of the branch.
 *
 * The coefficients are Fourier integrals, computed as sums over the M contact ends on particles inside. N and T are
 * means over the directions, not over the ends, so each end counts with the weight w = 1/(1 + a cos 2(theta -
 * theta_a)):
 *
 *   a = 2/M sum c,   N_0 = 1/M sum w N,   a_n = 2/(M N_0) sum w N c,   a_t = 2/(M N_0) sum w T s
 *   c = (cos 2 theta, sin 2 theta),   s = (sin 2 theta, -cos 2 theta)
 *
 * If a >= 1, the density of contacts would be negative in some directions, so w has no meaning and a_n and a_t are NaN.
 * All coefficients are 0 without contacts.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "region.h"

static struct nb_vec twice_the_angle(struct nb_vec n) { return vec(n.x * n.x - n.y * n.y, 2 * n.x * n.y); }

void nb_measure_directions(const struct nb_model *model, struct nb_region_state *region) {
  struct nb_directions *directions = &region->directions;
  struct nb_vec a = vec(0, 0), an = vec(0, 0), at = vec(0, 0);
  double count = 0, N0 = 0;
  struct nb_end end;
  *directions = (struct nb_directions){0};
  for (struct nb_ends ends = nb_ends_begin(model, region); nb_ends_next(&ends, &end); count++)
    a = vec_add(a, vec_scale(2, twice_the_angle(end.e)));
  if (count == 0)
    return;
  a = vec_scale(1 / count, a);
  for (struct nb_ends ends = nb_ends_begin(model, region); nb_ends_next(&ends, &end);) {
    const struct nb_vec c = twice_the_angle(end.e), s = vec(c.y, -c.x);
    const double w = vec_dot(a, a) < 1 ? 1 / (1 + vec_dot(a, c)) : NAN;
    N0 += w * end.total_normal / count;
    an = vec_add(an, vec_scale(2 * w * end.total_normal / count, c));
    at = vec_add(at, vec_scale(2 * w * end.total_shear / count, s));
  }
  an = vec_scale(1 / N0, an), at = vec_scale(1 / N0, at);
  directions->contacts = vec_length(a), directions->normal = vec_length(an), directions->shear = vec_length(at);
  directions->sinphi = vec_length(vec_add(a, vec_add(an, at))) / 2 / (1 + vec_dot(a, an) / 2);
}
