/* Geometry of two discs, or of a disc and an image of one: the loop of disc_disc.c and periodic.c.        [CS79 8-15]
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "pass.h"

/* Vectors of a block. A first loop gathers them from the particles, so that the loop with the square roots
 * vectorises. */
struct relative_motion {
  struct nb_vec apart[NB_BLOCK_SIZE], approach[NB_BLOCK_SIZE]; /* y - x, m; v_x - v_y, m/s */
  double rotation[NB_BLOCK_SIZE];                              /* w_x R_x + w_y R_y, m/s */
};

/* `copies`: the second disc is the image at x_j + H m in a periodic cell, and L H m is added to its velocity. */
static inline NB_FORM void nb_disc_disc(const struct nb_model *model, const struct nb_block *block,
                                        enum nb_approach approach, bool copies) {
  const struct nb_vec *position = model->particles.position, *velocity = model->particles.velocity;
  const struct nb_surface *surface = model->particles.surface;
  struct relative_motion relative;
  for (size_t c = 0; c < block->n; c++) {
    const int i = block->a[c], j = block->b[c];
    vec_put(&relative.apart[c], vec_both(&position[j]) - vec_both(&position[i]));
    if (approach >= NB_APPROACH_TANGENTIAL)
      relative.rotation[c] = surface[i].speed + surface[j].speed;
    if (approach >= NB_APPROACH_NORMAL)
      vec_put(&relative.approach[c], vec_both(&velocity[i]) - vec_both(&velocity[j]));
    if (copies)
      relative.apart[c] = vec_add(relative.apart[c], tensor_times(model->cell->h, block->image[c]));
    if (copies && approach >= NB_APPROACH_NORMAL)
      relative.approach[c] = vec_sub(relative.approach[c], tensor_times(model->cell->image_velocity, block->image[c]));
  }
  double *overlap = block->f[NB_OVERLAP], *ex = block->f[NB_EX], *ey = block->f[NB_EY];
  const double *radius_sum = block->f[NB_RADIUS_SUM];
  double *dn = block->f[NB_NORMAL_INCREMENT], *ds = block->f[NB_TANGENTIAL_INCREMENT];
  const double dt = model->previous_step;
  unsigned long began = 0;
  NB_WIDE
  for (size_t c = 0; c < block->n; c++) {
    const double distance = vec_length(relative.apart[c]);
    const double alpha = radius_sum[c] - distance;
    const struct nb_vec e = vec_scale(1 / distance, relative.apart[c]);
    overlap[c] = alpha > 0 ? alpha : 0;
    ex[c] = e.x;
    ey[c] = e.y;
    if (approach >= NB_APPROACH_NORMAL)
      dn[c] = vec_dot(relative.approach[c], e) * dt;
    if (approach >= NB_APPROACH_TANGENTIAL) {
      ds[c] = (vec_dot(relative.approach[c], vec_clockwise(e)) - relative.rotation[c]) * dt;
      began += nb_touch_began(alpha, dn[c]);
    }
  }
  if (began)
    nb_tangential_since_touch(block);
}
