/* Components of the contact forces.                                  [CS79, The force-displacement law, figure 3]
 *
 * F_n and F_s, which include the dashpot forces, act on the first particle along -e and -t, and on the second particle
 * along e and t. The components of the force on the first particle are
 *
 *   F_1 = -(F_n e1 + F_s t1),   F_2 = -(F_n e2 + F_s t2),   t = (e2, -e1)
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "core/contacts.h"
#include "pass.h"

static inline NB_FORM void normal_only(const struct nb_model *model, const struct nb_block *block) {
  (void)model;
  const double *total_normal = block->f[NB_TOTAL_NORMAL], *ex = block->f[NB_EX], *ey = block->f[NB_EY];
  struct nb_contact_force *force = block->force;
  NB_WIDE
  for (size_t c = 0; c < block->n; c++) {
    const struct nb_vec f = vec_scale(-total_normal[c], vec(ex[c], ey[c]));
    force[c] = (struct nb_contact_force){f.x, 0, f.y};
  }
}

static inline NB_FORM void with_shear(const struct nb_model *model, const struct nb_block *block) {
  (void)model;
  const double *total_normal = block->f[NB_TOTAL_NORMAL], *ex = block->f[NB_EX], *ey = block->f[NB_EY];
  const double *total_shear = block->f[NB_TOTAL_SHEAR];
  struct nb_contact_force *force = block->force;
  NB_WIDE
  for (size_t c = 0; c < block->n; c++) {
    const struct nb_vec e = vec(ex[c], ey[c]), t = vec_clockwise(e);
    const struct nb_vec f = vec_scale(-1, vec_add(vec_scale(total_normal[c], e), vec_scale(total_shear[c], t)));
    force[c] = (struct nb_contact_force){f.x, total_shear[c], f.y};
  }
}

NB_FORMS(normal_only)
NB_FORMS(with_shear)

const struct nb_pass nb_pass_resolve[] = {
    {"resolve, normal", NB_FORMS_LIST(normal_only)},
    {"resolve, normal and shear", NB_FORMS_LIST(with_shear)},
};
