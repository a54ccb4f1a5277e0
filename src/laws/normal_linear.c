/* The linear spring:                                      F_n = k_n alpha
 *
 *   alpha   overlap, m, >= 0
 *   k_n     normal stiffness of the pair, N/m
 *
 * Source     [CS79 16, 18]. CS79 adds dF_n = k_n dn in each step; this law computes F_n from the overlap. If the
 *            direction of the contact is constant, and in the step of first touch only the part of dn after the touch
 *            counts, the two agree except for rounding. If the direction rotates, the sum of the increments leaves a
 *            force when the discs separate; this law leaves none.
 * Range      any overlap; the paper requires overlaps that are small compared with the discs.
 * History    none.
 * Stores     F_n^2 / (2 k_n).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "law.h"

static inline struct nb_normal normal_linear(struct nb_pair p, double overlap, double dn, double m[]) {
  (void)dn, (void)m;
  return (struct nb_normal){.force = p.kn * overlap, .stiffness = overlap > 0 ? p.kn : 0};
}

static double normal_linear_stored(struct nb_pair p, struct nb_normal n, const double m[]) {
  (void)m;
  return n.force > 0 ? n.force * n.force / (2 * p.kn) : 0;
}

#define LAW normal_linear
#define NORMAL
#define CONSTANT
#define TITLE "linear spring, F_n = k_n overlap"
#define SOURCE "[CS79 16, 18]"
#define PARAMETERS "kn"
#define HISTORY 0
#define STORED normal_linear_stored
#include "law_batch.h"
