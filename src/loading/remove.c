/* Bodies that are taken out of the scene when a stage begins.
 *
 * What is taken out keeps its number and its last place. From the stage's t_0 on it does not move, touches nothing and
 * weighs nothing: it stands still with no end of mass, and the search that follows at once lists none of its contacts.
 *
 * The kick around t_0 lasts from half a step before it to half a step after it. What the body pushed until t_0 is the half
 * before it: its neighbours are given that at once (motion.c), so that the velocities of t_0 are what they were, and the
 * kick to come is without it. So the error of the step stays of second order.
 *
 * It carries away its kinetic energy at t_0 and what the springs of its contacts hold then, by the laws' state functions.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "core/contacts.h"
#include "loading.h"
#include "measure/energy.h"

/* Contact c ends: what it did until now is done, and it reads as if it did not touch. */
static void let_go(struct nb_model *model, size_t c) {
  struct nb_contacts *contacts = &model->contacts;
  const struct nb_bodies *bodies = &model->bodies;
  const size_t a = (size_t)contacts->a[c], b = (size_t)contacts->b[c];
  const double *drag = contacts->kept[model->plan.drag];
  const struct nb_vec force = contacts->force[c];
  nb_motion_release(model, a, (struct nb_force){force, drag ? drag[c] * bodies->rim[a].x : 0});
  if (!model->pairings[contacts->pairing[c]].wall)
    nb_motion_release(model, b, (struct nb_force){vec_scale(-1, force), drag ? drag[c] * bodies->rim[b].x : 0});
  contacts->force[c] = vec(0, 0);
  for (int f = 0; f < NB_FIELDS; f++)
    if (contacts->kept[f])
      contacts->kept[f][c] = 0;
}

static void take_out(struct nb_model *model, size_t i) {
  struct nb_bodies *bodies = &model->bodies;
  if (model->terms)
    nb_sum_add(&model->terms[NB_TERM_REMOVED], nb_energy_of_body(model, i));
  const struct nb_contacts_of its = nb_contacts_of(&model->contacts.of, i);
  for (const int *c = its.first; c < its.end; c++)
    let_go(model, (size_t)*c);
  if (model->drive)
    nb_ring_drop(model, i);
  if (model->carry)
    nb_carry_drop(model, i);
  bodies->gone[i] = true;
  bodies->inverse_mass[i] = bodies->inverse_inertia[i] = 0;
  bodies->velocity[i] = vec(0, 0);
  if (bodies->spin)
    bodies->spin[i] = 0;
}

enum nb_status nb_remove(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error) {
  nb_balance_remove(model, true);
  for (size_t r = 0; r < stage->removal_count; r++)
    for (size_t k = stage->removals[r].from; k <= stage->removals[r].to; k++)
      take_out(model, (size_t)model->bodies.slot[k]);
  model->search.keeping = true;
  const enum nb_status status = nb_near(model, error);
  model->search.keeping = false;
  if (!status)
    nb_balance_remove(model, false);
  return status;
}
