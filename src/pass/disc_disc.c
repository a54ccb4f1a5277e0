/* Geometry of two discs.                                             [CS79 8-15]
 *
 *   D = |y - x|,   e = (y - x)/D,   t = (e2, -e1)                      8-10
 *   alpha = R_x + R_y - D,   in contact when it is positive            8
 *   dn = (v_x - v_y).e dt                                              14
 *   ds = ((v_x - v_y).t - (w_x R_x + w_y R_y)) dt                      15
 *
 *   x, y   centres of the two discs, m            R     radius, m
 *   D      distance of the centres, m             e, t  unit vectors along the normal and the tangent
 *   v, w   velocity, m/s, and angular velocity, rad/s, counterclockwise, over the last step
 *   alpha  overlap, m                             dn, ds  normal and tangential increment since the last forces, m
 *
 * Without friction and cohesion, no pass needs ds. Without dashpots as well, only a law by increments needs dn. So the
 * loop exists in three forms (run/plan.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "disc_disc.h"

NB_DISC_FORMS(overlap_only, NB_APPROACH_OVERLAP, false)
NB_DISC_FORMS(with_normal_increment, NB_APPROACH_NORMAL, false)
NB_DISC_FORMS(with_tangential_increment, NB_APPROACH_TANGENTIAL, false)

const struct nb_pass nb_pass_disc_disc[] = {
    {"disc-disc, overlap", NB_FORMS_LIST(overlap_only)},
    {"disc-disc, overlap and normal increment", NB_FORMS_LIST(with_normal_increment)},
    {"disc-disc, overlap and both increments", NB_FORMS_LIST(with_tangential_increment)},
};
