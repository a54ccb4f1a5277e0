/* The passes of which a plan consists.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/model.h"

/* Defines the pass NAME, which makes `call`, for all instruction sets. */
#define NB_PASS_FORM(name, call)                                                                                       \
  static inline NB_FORM void name(const struct nb_model *model, const struct nb_block *block) { call; }                \
  NB_FORMS(name)

/* What a geometry pass computes: the overlap; overlap and dn; overlap, dn and ds. */
enum nb_approach { NB_APPROACH_OVERLAP, NB_APPROACH_NORMAL, NB_APPROACH_TANGENTIAL };
/* The dashpots of the stage: none; coefficients from k; from k and sqrt(M* k); from k, sqrt(M* k) and NB_DEEP. */
enum nb_dashpot_kind { NB_DASHPOTS_NONE, NB_DASHPOTS_TIME, NB_DASHPOTS_RATIO, NB_DASHPOTS_DEEP };

extern const struct nb_pass nb_pass_disc_disc[3], nb_pass_periodic[3], nb_pass_disc_wall[3]; /* by enum nb_approach */
extern const struct nb_pass nb_pass_affine_twice[2]; /* without and with tangential increment */
extern const struct nb_pass nb_pass_vertices;
extern const struct nb_pass nb_pass_deep;
extern const struct nb_pass nb_pass_dashpots[2][4]; /* not centred and centred; by enum nb_dashpot_kind */
extern const struct nb_pass nb_pass_resolve[2];     /* without and with shear */

/* Dashpot coefficients of a contact, s and 1: D_n = (time k_n + ratio sqrt(M* k_n)) dn/dt, and D_s with k_s and ds. */
struct nb_dashpot {
  double time, ratio;
};
/* The coefficients for contacts of two particles, or for contacts with walls. */
struct nb_dashpot nb_dashpot(const struct nb_model *model, bool wall);
