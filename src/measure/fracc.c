/* FRACC, the fraction of a critical step that R89 estimates from the motion of each particle.        [R89 4.35-4.40]
 *
 *   K = dSF/dx,   dx = |v| dt                                          [R89 4.35, 4.36]
 *   dSF = |SF|_new - |SF|_old                                          [R89 4.38, 4.39]
 *   FRACC = dt/(2 (M dx/|dSF|)^(1/2))                                  [R89 4.37, 4.40]
 *
 *   SF   sum of the contact forces on a particle, N        M   mass of the particle, kg        dt  step, s
 *   v    velocity over the step between the two force calculations, m/s
 *
 * FRACC is the largest value of all free particles in the last cycle. R89 does not treat dSF < 0 and dx = 0: this file
 * uses the absolute value of dSF and leaves out particles with dx = 0.
 *
 * Range    FRACC is not a stability bound. dSF is a difference of magnitudes, so it misses forces that rotate or change
 *          their sign. But the oscillation that grows first when a step is too long changes its sign in every cycle. A
 *          particle that hardly moves while its neighbours do has an unbounded K. See cases/5-numerics/fracc.md and
 *          stable_step.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "step.h"

bool nb_fracc_create(struct nb_model *model) {
  model->fracc = nb_own(&model->owner, 1, sizeof *model->fracc);
  double *before = nb_own(&model->owner, model->particles.count, sizeof *before);
  if (model->owner.failed)
    return false;
  model->fracc->previous_force = before;
  for (size_t i = 0; i < model->particles.count; i++)
    model->fracc->previous_force[i] = vec_length(nb_force_on(model, i).force);
  return true;
}

void nb_fracc_after_forces(struct nb_model *model) {
  const struct nb_particles *particles = &model->particles;
  const double dt = model->previous_step;
  double largest = 0;
  for (size_t i = 0; i < particles->count; i++) {
    const double force = vec_length(nb_force_on(model, i).force),
                 change = fabs(force - model->fracc->previous_force[i]);
    const double distance = vec_length(particles->velocity[i]) * dt;
    model->fracc->previous_force[i] = force;
    if (!(distance > 0))
      continue;
    const double fraction = dt / 2 * sqrt(change * particles->inverse_mass[i] / distance);
    largest = fraction > largest ? fraction : largest;
  }
  model->fracc->largest = largest;
}
