/* Contact dashpots, added to what is felt and never to what is remembered.       [CS79 24-28; R89 4.3, 4.13]
 *
 *   D_n = c_n dn/dt,   D_s = c_s ds/dt                                  [CS79 26, 27]
 *   c = beta k                  `damping stiffness`, beta a time       [CS79 28]
 *   c = beta k t_c/2            `damping r89-fraction`: dN beta/(2 FRAC) is this, since dt = FRAC t_c  [R89 4.3, 4.4]
 *   c = beta 2 sqrt(M* k)       `damping ratio`, a fraction of critical  [R89 4.13, 4.19]
 *   c = 2 sqrt(M* k)            in the place of these where a contact is deep and the page says `critical beyond overlap` [R89 6.4.3]
 *
 * k is k_n for c_n, k_s for c_s; between elastic spheres 2 E* a and 8 G* a. Contacts with walls may have their own beta.
 *
 * Where no stage says a share of critical, M* is not kept and no root taken.
 *
 * The stiffnesses are the ones that the laws answered this cycle. D_s is off while the contact slides [CS79, Damping]; F_n + D_n
 * may be tensile. ds/dt is that of the whole step behind, though the slip of the step in which two bodies meet counts for a part
 * of it only. The limit of F_s has been taken from F_n alone before this pass.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "pass.h"

struct nb_dashpot nb_dashpot(const struct nb_model *model, bool wall) {
  double beta;
  switch (nb_damping_at(&model->damping, wall, &beta)) {
  case NB_CONTACT_BETA:
    return (struct nb_dashpot){.time = beta};
  case NB_CONTACT_FRACTION:
    return (struct nb_dashpot){.time = beta * model->critical / 2};
  case NB_CONTACT_RATIO:
    return (struct nb_dashpot){.ratio = 2 * beta};
  case NB_CONTACT_UNDAMPED:
    break;
  }
  return (struct nb_dashpot){0};
}

/* What makes the coefficients of a block. */
struct dashpots {
  struct nb_dashpot pot;
  bool swings, critical; /* some go with sqrt(M* k); some contacts may be too deep */
  const double *mass, *deep;
};

static inline NB_FORM double coefficient(const struct dashpots *of, double stiffness, size_t c) {
  const double swing = of->swings ? sqrt(of->mass[c] * stiffness) : 0; /* sqrt(M* k) */
  return of->critical && of->deep[c] > 0 ? 2 * swing : of->pot.time * stiffness + of->pot.ratio * swing;
}

static inline NB_FORM void damp(const struct nb_model *model, const struct nb_view *view, enum nb_dashpots form) {
  const struct dashpots of = {.pot = nb_dashpot(model, view->pairing->wall),
                              .swings = form >= NB_DASHPOTS_SWING,
                              .critical = form == NB_DASHPOTS_DEEP && model->damping.deep > 0,
                              .mass = view->f[NB_MASS],
                              .deep = view->f[NB_DEEP]};
  const double *normal = view->f[NB_NORMAL], *stiffness = view->f[NB_STIFFNESS];
  const double *closing = view->f[NB_CLOSING];
  double *push = view->f[NB_PUSH];
  const double rate = model->previous_step > 0 ? 1 / model->previous_step : 0;
  NB_WIDE
  for (size_t c = 0; c < view->n; c++) {
    push[c] = normal[c] + coefficient(&of, stiffness[c], c) * (closing[c] * rate);
  }
  if (!view->pairing->shear)
    return;
  const double *shear = view->f[NB_SHEAR], *shear_stiffness = view->f[NB_SHEAR_STIFFNESS];
  const double *slip = view->f[NB_SLIP], *sliding = view->f[NB_SLIDING], *overlap = view->f[NB_OVERLAP];
  double *drag = view->f[NB_DRAG];
  unsigned long met = 0;
  NB_WIDE
  for (size_t c = 0; c < view->n; c++) {
    drag[c] = shear[c] + (1 - sliding[c]) * (coefficient(&of, shear_stiffness[c], c) * (slip[c] * rate));
    met += nb_met(overlap[c], closing[c]);
  }
  for (size_t c = 0; c < view->n && met > 0; c++) { /* the few of which `slip` is not that of the whole step */
    const double touched = nb_touched(overlap[c], closing[c]), moved = touched > 0 ? slip[c] / touched : slip[c];
    if (nb_met(overlap[c], closing[c]))
      drag[c] = shear[c] + (1 - sliding[c]) * (coefficient(&of, shear_stiffness[c], c) * (moved * rate));
  }
}

static inline NB_FORM void of_times(const struct nb_model *model, const struct nb_view *view) {
  damp(model, view, NB_DASHPOTS_TIME);
}
static inline NB_FORM void of_swings(const struct nb_model *model, const struct nb_view *view) {
  damp(model, view, NB_DASHPOTS_SWING);
}
static inline NB_FORM void critical_where_deep(const struct nb_model *model, const struct nb_view *view) {
  damp(model, view, NB_DASHPOTS_DEEP);
}
NB_FORMS(of_times)
NB_FORMS(of_swings)
NB_FORMS(critical_where_deep)

const struct nb_pass nb_pass_dashpots[] = {
    {"dashpots", NB_FORMS_LIST(of_times)},
    {"dashpots, shares of critical", NB_FORMS_LIST(of_swings)},
    {"dashpots, critical where too deep", NB_FORMS_LIST(critical_where_deep)},
};
