/* Contact dashpots, added to what is felt and never to what is remembered.       [CS79 24-28; R89 4.3, 4.13]
 *
 *   D_n = c_n dn/dt,   D_s = c_s ds/dt                                  [CS79 26, 27]
 *   c = beta k                  `contact-beta`, beta a time             [CS79 28]
 *   c = beta k t_c/2            `contact-fraction`: dN beta/(2 FRAC) is this, since dt = FRAC t_c    [R89 4.3, 4.4]
 *   c = beta 2 sqrt(M* k)       `contact-ratio`, a share of critical    [R89 4.13]
 *
 * The stiffnesses are the ones that the laws answered this cycle. D_s is off while the contact slides [CS79, Damping]; F_n + D_n
 * may be tensile; the limit of F_s has been taken from F_n alone before this pass.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "../model.h"

struct nb_dashpot nb_dashpot(const struct nb_model *model) {
  const double beta = model->damping.contact;
  switch (model->damping.contact_kind) {
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

static inline NB_FORM void dashpots(const struct nb_model *model, const struct nb_view *view) {
  const struct nb_dashpot pot = nb_dashpot(model);
  const double *normal = view->f[NB_NORMAL], *stiffness = view->f[NB_STIFFNESS];
  const double *closing = view->f[NB_CLOSING];
  const double *mass = view->f[NB_MASS];
  double *push = view->f[NB_PUSH];
  const double rate = model->previous_step > 0 ? 1 / model->previous_step : 0;
  NB_WIDE
  for (size_t c = 0; c < view->n; c++) {
    const double coefficient = pot.time * stiffness[c] + pot.ratio * sqrt(mass[c] * stiffness[c]);
    push[c] = normal[c] + coefficient * (closing[c] * rate);
  }
  if (!view->pairing->shear)
    return;
  const double *shear = view->f[NB_SHEAR], *shear_stiffness = view->f[NB_SHEAR_STIFFNESS];
  const double *slip = view->f[NB_SLIP], *sliding = view->f[NB_SLIDING];
  double *drag = view->f[NB_DRAG];
  NB_WIDE
  for (size_t c = 0; c < view->n; c++) {
    const double coefficient = pot.time * shear_stiffness[c] + pot.ratio * sqrt(mass[c] * shear_stiffness[c]);
    drag[c] = shear[c] + (1 - sliding[c]) * (coefficient * (slip[c] * rate));
  }
}

NB_FORMS(dashpots)

const struct nb_pass nb_pass_dashpots = {"dashpots", NB_FORMS_LIST(dashpots)};
