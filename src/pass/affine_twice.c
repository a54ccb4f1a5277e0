/* R89's second addition of the imposed velocity, in its subroutine FORD (`affine strain ... accumulated-twice`).
 *
 *   x' = x' + c_11 x + c_12 y,   y' = y' + c_22 y + c_21 x                           [R89 4.43, 4.44]
 *
 *   x', y'  relative velocity of two particles, m/s    x, y  vector between their centres, m    c_ij  L, 1/s
 *
 * R89 adds these terms in MOTION to the velocity of each particle, and in FORD to the relative velocity of two
 * particles. If MOTION stores the sum, as `accumulated` does, the relative velocity of two particles with separation z,
 * m, already contains L z, and FORD adds L z again. Cundall's equation [R89 4.42], the source of these terms, has L z
 * once.
 *
 *   dn += -(e.L e) D dt,   ds += -(t.L e) D dt,   D = R_x + R_y - alpha
 *
 *   dn, ds, e, t, alpha, R  as in disc_disc.c         D  distance of the centres, m
 *
 * L is the strain rate of `affine strain` for all contacts of two particles, also with a particle of the boundary,
 * because FORD has one tensor. Nothing is added in a contact with a wall. Nothing is added in the step of first touch
 * either, because laws then use the overlap as the normal increment. The overlap is computed from the positions and
 * does not change. So this pass changes only the forces of dashpots, the shear forces, and the forces of normal laws
 * that read dn.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "core/affine.h"
#include "pass.h"

/* `tangential`: changes ds, too. */
static inline NB_FORM void add_again(const struct nb_model *model, const struct nb_block *block, bool tangential) {
  const struct nb_tensor rate = model->affine->rate[NB_AFFINE_FREE];
  const double dt = model->previous_step;
  const double *overlap = block->f[NB_OVERLAP], *radius_sum = block->f[NB_RADIUS_SUM];
  const double *ex = block->f[NB_EX], *ey = block->f[NB_EY];
  double *dn = block->f[NB_NORMAL_INCREMENT], *ds = block->f[NB_TANGENTIAL_INCREMENT];
  *block->began = true; /* with the changed dn, nb_touch_began may be true for any contact */
  NB_WIDE
  for (size_t c = 0; c < block->n; c++) {
    const struct nb_vec e = vec(ex[c], ey[c]);
    const double length = nb_touch_began(overlap[c], dn[c]) ? 0 : radius_sum[c] - overlap[c];
    const struct nb_vec step = vec_scale(-length * dt, tensor_times(rate, e));
    dn[c] += vec_dot(step, e);
    if (tangential)
      ds[c] += vec_dot(step, vec_clockwise(e));
  }
}

NB_PASS_FORM(normal_again, add_again(model, block, false))
NB_PASS_FORM(both_again, add_again(model, block, true))

const struct nb_pass nb_pass_affine_twice[] = {
    {"affine motion again, normal increment", NB_FORMS_LIST(normal_again)},
    {"affine motion again, both increments", NB_FORMS_LIST(both_again)},
};
