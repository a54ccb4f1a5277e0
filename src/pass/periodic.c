/* Geometry of a disc and an image of a disc, in a periodic cell.                         [CS79 8-15; R89 sec. 4.5.2]
 *
 *   y + H m - x   instead of y - x,      v_y + L H m   instead of v_y
 *
 *   v_y  velocity of y, including the affine motion, m/s      L  strain rate of the cell in the last step, 1/s
 *   H    sides of the cell as columns, in metres              m  two integers: the image is m sides away
 *
 * The rest is the same as in disc_disc.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "disc_disc.h"

NB_DISC_FORMS(overlap_only, NB_APPROACH_OVERLAP, true)
NB_DISC_FORMS(with_normal_increment, NB_APPROACH_NORMAL, true)
NB_DISC_FORMS(with_tangential_increment, NB_APPROACH_TANGENTIAL, true)

const struct nb_pass nb_pass_periodic[] = {
    {"disc-image, overlap", NB_FORMS_LIST(overlap_only)},
    {"disc-image, overlap and normal increment", NB_FORMS_LIST(with_normal_increment)},
    {"disc-image, overlap and both increments", NB_FORMS_LIST(with_tangential_increment)},
};
