/* Geometry of two discs.                                             [CS79 8-15]
 *
 *   D = |y - x|,   e = (y - x)/D,   t = (e2, -e1)                      8-10
 *   alpha = R_x + R_y - D,   in contact when it is positive            8
 *   dn = (v_x - v_y).e dt                                              14
 *   ds = ((v_x - v_y).t - (w_x R_x + w_y R_y)) dt                      15
 *
 * v, w are the velocities over the step behind, so dn and ds are what happened since the last forces. A scene without
 * dashpots needs no dn, one without friction no ds: three forms of one loop.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "../model.h"

/* What the loop of square roots needs, fetched body by body first: bodies lie anywhere, a block's vectors side by side. */
struct fetched {
  struct nb_vec apart[NB_BLOCK], approach[NB_BLOCK]; /* y - x, v_x - v_y */
  struct nb_vec rims[NB_BLOCK];                      /* R_x + R_y, w_x R_x + w_y R_y */
};

static inline NB_FORM void disc_disc(const struct nb_model *model, const struct nb_view *view,
                                     enum nb_approach approach) {
  const struct nb_vec *position = model->bodies.position, *velocity = model->bodies.velocity, *rim = model->bodies.rim;
  struct fetched here;
  for (size_t c = 0; c < view->n; c++) {
    const int i = view->a[c], j = view->b[c];
    vec_put(&here.apart[c], vec_both(&position[j]) - vec_both(&position[i]));
    vec_put(&here.rims[c], vec_both(&rim[i]) + vec_both(&rim[j]));
    if (approach >= NB_APPROACH_CLOSING)
      vec_put(&here.approach[c], vec_both(&velocity[i]) - vec_both(&velocity[j]));
  }
  double *overlap = view->f[NB_OVERLAP], *ex = view->f[NB_EX], *ey = view->f[NB_EY];
  double *closing = view->f[NB_CLOSING], *slip = view->f[NB_SLIP];
  const double dt = model->previous_step;
  NB_WIDE
  for (size_t c = 0; c < view->n; c++) {
    const double distance = vec_length(here.apart[c]);
    const double alpha = here.rims[c].x - distance;
    const struct nb_vec e = vec_scale(1 / distance, here.apart[c]);
    overlap[c] = alpha > 0 ? alpha : 0;
    ex[c] = e.x;
    ey[c] = e.y;
    if (approach >= NB_APPROACH_CLOSING)
      closing[c] = vec_dot(here.approach[c], e) * dt;
    if (approach >= NB_APPROACH_SLIP)
      slip[c] = nb_touched(alpha, closing[c]) * ((vec_dot(here.approach[c], vec_clockwise(e)) - here.rims[c].y) * dt);
  }
}

static inline NB_FORM void overlap_only(const struct nb_model *model, const struct nb_view *view) {
  disc_disc(model, view, NB_APPROACH_OVERLAP);
}
static inline NB_FORM void with_closing(const struct nb_model *model, const struct nb_view *view) {
  disc_disc(model, view, NB_APPROACH_CLOSING);
}
static inline NB_FORM void with_slip(const struct nb_model *model, const struct nb_view *view) {
  disc_disc(model, view, NB_APPROACH_SLIP);
}
NB_FORMS(overlap_only)
NB_FORMS(with_closing)
NB_FORMS(with_slip)

const struct nb_pass nb_pass_disc_disc[] = {
    {"disc-disc, overlap", NB_FORMS_LIST(overlap_only)},
    {"disc-disc, overlap and closing", NB_FORMS_LIST(with_closing)},
    {"disc-disc, overlap, closing and slip", NB_FORMS_LIST(with_slip)},
};
