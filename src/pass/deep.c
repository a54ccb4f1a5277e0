/* Contacts pressed more deeply than elastic spheres are good for [R89 6.4.3], or than the step was sure to be stable for (watch.c).
 *
 *   alpha > s 2 min(R_x, R_y)       s = 7 % of the smaller diameter, or what the page says
 *   alpha > NB_SURE
 *
 * Each cycle in which a contact is so deep counts once. Where the page damps such contacts critically, the pass says which they
 * are: 1 in NB_DEEP, else 0. A block with no overlap above that of the smallest body of all, nor the least sure of its contacts,
 * has none, which is told in one loop.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "pass.h"

static inline NB_FORM unsigned long above(const struct nb_view *view, double least) {
  const double *overlap = view->f[NB_OVERLAP];
  unsigned long count = 0;
  NB_WIDE
  for (size_t c = 0; c < view->n; c++) {
    count += overlap[c] > least ? 1 : 0;
  }
  return count;
}

static inline NB_FORM unsigned long unsure(const struct nb_view *view) {
  const double *overlap = view->f[NB_OVERLAP], *sure = view->f[NB_SURE];
  unsigned long count = 0;
  NB_WIDE
  for (size_t c = 0; c < view->n; c++) {
    count += overlap[c] > sure[c] ? 1 : 0;
  }
  return count;
}

static inline NB_FORM void deep(const struct nb_model *model, const struct nb_view *view) {
  const double *overlap = view->f[NB_OVERLAP];
  double *mark = view->f[NB_DEEP];
  const struct nb_vec *rim = model->bodies.rim;
  const double share = 2 * nb_deep_share(model), least = share * model->search.smallest;
  const double sure = view->sure ? view->sure->overlap : INFINITY;
  const unsigned long any = above(view, least < sure ? least : sure);
  const size_t marks = model->damping.deep > 0 ? view->n : 0;
  NB_WIDE
  for (size_t c = 0; c < marks; c++) {
    mark[c] = 0;
  }
  if (any == 0)
    return;
  if (view->sure)
    view->sure->above = unsure(view);
  if (above(view, least) == 0)
    return;
  for (size_t c = 0; c < view->n; c++) {
    const double a = rim[view->a[c]].x, b = view->pairing->wall ? a : rim[view->b[c]].x;
    mark[c] = overlap[c] > share * (a < b ? a : b) ? 1 : 0;
    *view->deep += mark[c] > 0 ? 1 : 0;
  }
}
NB_FORMS(deep)

const struct nb_pass nb_pass_deep = {"overlaps that are too deep", NB_FORMS_LIST(deep)};
