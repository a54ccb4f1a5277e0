/* Geometry of two discs, or of a disc and a copy of one: the loop of disc_disc.c and periodic.c.        [CS79 8-15]
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_DISC_DISC_H
#define NB_DISC_DISC_H

#include "pass.h"

/* What the loop of square roots needs, fetched body by body first: bodies lie anywhere, a block's vectors side by side. */
struct fetched {
  struct nb_vec apart[NB_BLOCK], approach[NB_BLOCK]; /* y - x, v_x - v_y */
  double rolling[NB_BLOCK];                          /* w_x R_x + w_y R_y */
};

/* `copies`: the second disc is the copy x_j + H m of a periodic cell, which is L H m faster. */
static inline NB_FORM void nb_disc_disc(const struct nb_model *model, const struct nb_view *view,
                                        enum nb_approach approach, bool copies) {
  const struct nb_vec *position = model->bodies.position, *velocity = model->bodies.velocity, *rim = model->bodies.rim;
  struct fetched here;
  for (size_t c = 0; c < view->n; c++) {
    const int i = view->a[c], j = view->b[c];
    vec_put(&here.apart[c], vec_both(&position[j]) - vec_both(&position[i]));
    if (approach >= NB_APPROACH_SLIP)
      here.rolling[c] = rim[i].y + rim[j].y;
    if (approach >= NB_APPROACH_CLOSING)
      vec_put(&here.approach[c], vec_both(&velocity[i]) - vec_both(&velocity[j]));
    if (copies)
      here.apart[c] = vec_add(here.apart[c], tensor_times(model->cell->h, view->image[c]));
    if (copies && approach >= NB_APPROACH_CLOSING)
      here.approach[c] = vec_sub(here.approach[c], tensor_times(model->cell->parting, view->image[c]));
  }
  double *overlap = view->f[NB_OVERLAP], *ex = view->f[NB_EX], *ey = view->f[NB_EY];
  const double *reach = view->f[NB_REACH];
  double *closing = view->f[NB_CLOSING], *slip = view->f[NB_SLIP];
  const double dt = model->previous_step;
  unsigned long met = 0;
  NB_WIDE
  for (size_t c = 0; c < view->n; c++) {
    const double distance = vec_length(here.apart[c]);
    const double alpha = reach[c] - distance;
    const struct nb_vec e = vec_scale(1 / distance, here.apart[c]);
    overlap[c] = alpha > 0 ? alpha : 0;
    ex[c] = e.x;
    ey[c] = e.y;
    if (approach >= NB_APPROACH_CLOSING)
      closing[c] = vec_dot(here.approach[c], e) * dt;
    if (approach >= NB_APPROACH_SLIP) {
      slip[c] = (vec_dot(here.approach[c], vec_clockwise(e)) - here.rolling[c]) * dt;
      met += nb_met(alpha, closing[c]);
    }
  }
  if (met)
    nb_slip_since_met(view);
}

#endif
