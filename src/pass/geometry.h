/* Geometry of the contacts of a block, from the positions and velocities of both sides.                   [CS79 8-15]
 *
 *   D = |y - x|,   e = (y - x)/D,   alpha = R - D,   dn = (v_x - v_y).e dt,   ds = ((v_x - v_y).t - (w R)) dt
 *
 *   x, y  centres of the two discs, or the centre of a disc and the nearest point of a wall, m
 *   R     sum of the radii, m             w R  sum of the products of angular velocity and radius, m/s; of a wall: 0
 *
 * disc_disc.c has the other symbols. Each kind of contact gathers its vectors in a loop of its own, so that this loop
 * with the square roots vectorises. disc_disc_wide.h repeats the arithmetic for discs; tests/kinematics.c compares the
 * bits.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "pass.h"

/* Vectors of a block. */
struct relative_motion {
  struct nb_vec apart[NB_BLOCK_SIZE], approach[NB_BLOCK_SIZE]; /* y - x, m; v_x - v_y, m/s */
  double rotation[NB_BLOCK_SIZE];                              /* w R, m/s */
};

/* Computes the fields that `approach` names, from the vectors of a block. */
static inline NB_FORM void nb_geometry(const struct nb_model *model, const struct nb_block *block,
                                       enum nb_approach approach, const struct relative_motion *relative) {
  double *overlap = block->f[NB_OVERLAP], *ex = block->f[NB_EX], *ey = block->f[NB_EY];
  const double *radius_sum = block->f[NB_RADIUS_SUM];
  double *dn = block->f[NB_NORMAL_INCREMENT], *ds = block->f[NB_TANGENTIAL_INCREMENT];
  const double dt = model->previous_step;
  unsigned long began = 0;
  NB_WIDE
  for (size_t c = 0; c < block->n; c++) {
    const double distance = vec_length(relative->apart[c]);
    const double alpha = radius_sum[c] - distance;
    const struct nb_vec e = vec_scale(1 / distance, relative->apart[c]);
    overlap[c] = alpha > 0 ? alpha : 0;
    ex[c] = e.x;
    ey[c] = e.y;
    if (approach >= NB_APPROACH_NORMAL)
      dn[c] = vec_dot(relative->approach[c], e) * dt;
    if (approach >= NB_APPROACH_TANGENTIAL) {
      ds[c] = (vec_dot(relative->approach[c], vec_clockwise(e)) - relative->rotation[c]) * dt;
      began += nb_touch_began(alpha, dn[c]);
    }
  }
  *block->began = began > 0;
  if (began)
    nb_tangential_since_touch(block);
}
