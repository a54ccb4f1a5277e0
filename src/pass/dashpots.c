/* Contact dashpots: added to the contact force, never to the contact history.       [CS79 24-28; R89 4.3, 4.13]
 *
 *   D_n = c_n dn/dt,   D_s = c_s ds/dt                                  [CS79 26, 27]
 *   c = beta k                  `damping stiffness`, beta a time       [CS79 28]
 *   c = beta k t_c/2            `damping r89-fraction`: dN beta/(2 FRAC) is this, since dt = FRAC t_c  [R89 4.3, 4.4]
 *   c = beta 2 sqrt(M* k)       `damping ratio`, a fraction of critical  [R89 4.13, 4.19]
 *   c = 2 sqrt(M* k)            instead of these for a deep contact with `critical beyond overlap` [R89 6.4.3]
 *
 * k is k_n for c_n and k_s for c_s; for elastic spheres 2 E* a and 8 G* a. Contacts with walls may have their own beta.
 *
 * Scenes without damping ratios keep no M* and take no roots.
 *
 * The stiffnesses are those that the laws returned in this cycle. D_s is 0 while the contact slides [CS79, Damping];
 * F_n + D_n may be tensile. ds/dt is the mean over the whole last step, even if the contact began in it and the law
 * used only a part of ds. The friction limit of F_s was computed from F_n alone, before this pass.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "pass.h"

struct nb_dashpot nb_dashpot(const struct nb_model *model, bool wall) {
  double beta;
  switch (nb_damping_at(&model->damping, wall, &beta)) {
  case NB_CONTACT_STIFFNESS:
    return (struct nb_dashpot){.time = beta};
  case NB_CONTACT_R89_FRACTION:
    return (struct nb_dashpot){.time = beta * model->critical / 2};
  case NB_CONTACT_RATIO:
    return (struct nb_dashpot){.ratio = 2 * beta};
  case NB_CONTACT_UNDAMPED:
    break;
  }
  return (struct nb_dashpot){0};
}

/* The coefficients of a block. */
struct dashpots {
  struct nb_dashpot dashpot;
  bool uses_damping_ratio, critical; /* some use sqrt(M* k); some contacts may be too deep */
  const double *mass, *deep;
};

static inline NB_FORM double coefficient(const struct dashpots *spec, double stiffness, size_t c) {
  const double oscillation = spec->uses_damping_ratio ? sqrt(spec->mass[c] * stiffness) : 0; /* sqrt(M* k) */
  return spec->critical && spec->deep[c] > 0 ? 2 * oscillation
                                             : spec->dashpot.time * stiffness + spec->dashpot.ratio * oscillation;
}

static inline NB_FORM void add_dashpots(const struct nb_model *model, const struct nb_block *block,
                                        enum nb_dashpot_kind form) {
  const struct dashpots spec = {.dashpot = nb_dashpot(model, block->material_pair->wall),
                                .uses_damping_ratio = form >= NB_DASHPOTS_RATIO,
                                .critical = form == NB_DASHPOTS_DEEP && model->damping.deep > 0,
                                .mass = block->f[NB_MASS],
                                .deep = block->f[NB_DEEP]};
  const double *normal = block->f[NB_NORMAL], *stiffness = block->f[NB_STIFFNESS];
  const double *dn = block->f[NB_NORMAL_INCREMENT];
  double *total_normal = block->f[NB_TOTAL_NORMAL];
  const double rate = model->previous_step > 0 ? 1 / model->previous_step : 0;
  NB_WIDE
  for (size_t c = 0; c < block->n; c++) {
    total_normal[c] = normal[c] + coefficient(&spec, stiffness[c], c) * (dn[c] * rate);
  }
  if (!block->material_pair->shear)
    return;
  const double *shear = block->f[NB_SHEAR], *shear_stiffness = block->f[NB_SHEAR_STIFFNESS];
  const double *ds = block->f[NB_TANGENTIAL_INCREMENT], *sliding = block->f[NB_SLIDING],
               *overlap = block->f[NB_OVERLAP];
  double *total_shear = block->f[NB_TOTAL_SHEAR];
  unsigned long began = 0;
  NB_WIDE
  for (size_t c = 0; c < block->n; c++) {
    total_shear[c] = shear[c] + (1 - sliding[c]) * (coefficient(&spec, shear_stiffness[c], c) * (ds[c] * rate));
    began += nb_touch_began(overlap[c], dn[c]);
  }
  for (size_t c = 0; c < block->n && began > 0; c++) { /* new contacts, whose ds is not that of the whole step */
    const double fraction = nb_touch_fraction(overlap[c], dn[c]),
                 displacement = fraction > 0 ? ds[c] / fraction : ds[c];
    if (nb_touch_began(overlap[c], dn[c]))
      total_shear[c] =
          shear[c] + (1 - sliding[c]) * (coefficient(&spec, shear_stiffness[c], c) * (displacement * rate));
  }
}

static inline NB_FORM void stiffness_proportional(const struct nb_model *model, const struct nb_block *block) {
  add_dashpots(model, block, NB_DASHPOTS_TIME);
}
static inline NB_FORM void ratio_of_critical(const struct nb_model *model, const struct nb_block *block) {
  add_dashpots(model, block, NB_DASHPOTS_RATIO);
}
static inline NB_FORM void critical_if_deep(const struct nb_model *model, const struct nb_block *block) {
  add_dashpots(model, block, NB_DASHPOTS_DEEP);
}
NB_FORMS(stiffness_proportional)
NB_FORMS(ratio_of_critical)
NB_FORMS(critical_if_deep)

const struct nb_pass nb_pass_dashpots[] = {
    {"no dashpots", {NULL}},
    {"dashpots", NB_FORMS_LIST(stiffness_proportional)},
    {"dashpots, damping ratio", NB_FORMS_LIST(ratio_of_critical)},
    {"dashpots, critical beyond overlap", NB_FORMS_LIST(critical_if_deep)},
};
