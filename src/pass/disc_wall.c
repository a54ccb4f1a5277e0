/* Geometry of a disc and a wall.                                     [CS79 figure 1, figure 4]
 *
 * The wall is the segment from P + h1 e_w to P + h2 e_w, moved by h0 to the left of e_w. P is the point about which the
 * wall rotates, and e_w a unit vector along the wall; h0, h1 and h2 are lengths, m. The disc touches the wall's nearest point Q,
 * inside the segment or at an end. v_Q is the velocity of the wall at Q, averaged over the step (core/walls.c). With D
 * = |Q - x|:
 *
 *   e = (Q - x)/D,   alpha = R - D,   dn = (v - v_Q).e dt,   ds = ((v - v_Q).t - w R) dt        [CS79 12-15, R_y = 0]
 *
 * x, R, v and w are position, radius, velocity and angular velocity of the disc.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "geometry.h"

static inline NB_FORM void disc_wall(const struct nb_model *model, const struct nb_block *block,
                                     enum nb_approach approach) {
  const struct nb_particles *particles = &model->particles;
  const struct nb_walls *walls = &model->walls;
  struct relative_motion relative;
  for (size_t c = 0; c < block->n; c++) {
    const int i = block->a[c], w = block->b[c];
    const struct nb_vec q = nb_wall_nearest(walls, w, particles->position[i]);
    relative.apart[c] = vec_sub(q, particles->position[i]);
    if (approach >= NB_APPROACH_NORMAL)
      relative.approach[c] = vec_sub(particles->velocity[i], nb_wall_velocity(walls, w, q));
    if (approach >= NB_APPROACH_TANGENTIAL)
      relative.rotation[c] = particles->surface_speed[i];
  }
  nb_geometry(model, block, approach, &relative);
}

NB_PASS_FORM(overlap_only, disc_wall(model, block, NB_APPROACH_OVERLAP))
NB_PASS_FORM(with_normal_increment, disc_wall(model, block, NB_APPROACH_NORMAL))
NB_PASS_FORM(with_tangential_increment, disc_wall(model, block, NB_APPROACH_TANGENTIAL))

const struct nb_pass nb_pass_disc_wall[] = {
    {"disc-wall, overlap", NB_FORMS_LIST(overlap_only)},
    {"disc-wall, overlap and normal increment", NB_FORMS_LIST(with_normal_increment)},
    {"disc-wall, overlap and both increments", NB_FORMS_LIST(with_tangential_increment)},
};
