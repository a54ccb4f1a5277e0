/* Geometry of a disc and a wall.                                     [CS79 figure 1, figure 4]
 *
 * The wall is the segment from P + h1 e_w to P + h2 e_w; the disc meets its nearest point Q, inside the segment or one of
 * its ends, which moves with v_Q = v_P + (dalpha/dt) x (Q - P). With D = |Q - x| the contact is a disc's with that point:
 *
 *   e = (Q - x)/D,   alpha = R - D,   dn = (v - v_Q).e dt,   ds = ((v - v_Q).t - w R) dt        [CS79 12-15, R_y = 0]
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "pass.h"

static inline NB_FORM void disc_wall(const struct nb_model *model, const struct nb_view *view,
                                     enum nb_approach approach) {
  const struct nb_vec *position = model->bodies.position, *velocity = model->bodies.velocity, *rim = model->bodies.rim;
  const struct nb_walls *walls = &model->walls;
  double *overlap = view->f[NB_OVERLAP], *ex = view->f[NB_EX], *ey = view->f[NB_EY];
  double *closing = view->f[NB_CLOSING], *slip = view->f[NB_SLIP];
  const double dt = model->previous_step;
  unsigned long met = 0;
  NB_WIDE
  for (size_t c = 0; c < view->n; c++) {
    const int i = view->a[c], w = view->b[c];
    const struct nb_vec q = nb_wall_nearest(walls, w, position[i]);
    const struct nb_vec apart = vec_sub(q, position[i]);
    const double distance = vec_length(apart);
    const double alpha = rim[i].x - distance;
    const struct nb_vec e = vec_scale(1 / distance, apart);
    overlap[c] = alpha > 0 ? alpha : 0;
    ex[c] = e.x;
    ey[c] = e.y;
    const struct nb_vec v = vec_sub(velocity[i], nb_wall_velocity(walls, w, q));
    if (approach >= NB_APPROACH_CLOSING)
      closing[c] = vec_dot(v, e) * dt;
    if (approach >= NB_APPROACH_SLIP) {
      slip[c] = (vec_dot(v, vec_clockwise(e)) - rim[i].y) * dt;
      met += nb_met(alpha, closing[c]);
    }
  }
  if (met)
    nb_slip_since_met(view);
}

static inline NB_FORM void overlap_only(const struct nb_model *model, const struct nb_view *view) {
  disc_wall(model, view, NB_APPROACH_OVERLAP);
}
static inline NB_FORM void with_closing(const struct nb_model *model, const struct nb_view *view) {
  disc_wall(model, view, NB_APPROACH_CLOSING);
}
static inline NB_FORM void with_slip(const struct nb_model *model, const struct nb_view *view) {
  disc_wall(model, view, NB_APPROACH_SLIP);
}
NB_FORMS(overlap_only)
NB_FORMS(with_closing)
NB_FORMS(with_slip)

const struct nb_pass nb_pass_disc_wall[] = {
    {"disc-wall, overlap", NB_FORMS_LIST(overlap_only)},
    {"disc-wall, overlap and closing", NB_FORMS_LIST(with_closing)},
    {"disc-wall, overlap, closing and slip", NB_FORMS_LIST(with_slip)},
};
