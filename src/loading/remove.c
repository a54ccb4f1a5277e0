/* Removal of particles and walls when a stage begins, at the time t_0.
 *
 * A removed particle keeps its number, its last position and its angle. From t_0 on it does not move, has no contacts
 * and no weight: its mass counts as infinite, and the search that follows at once lists none of its contacts. A removed
 * wall stays where it is, without contacts.
 *
 * The kick around t_0 lasts from half a step before t_0 to half a step after t_0. The forces of the removed particle or
 * wall act only during the first half. The impulse of this half is applied to its neighbours at once (core/velocity.c),
 * so the velocities at t_0 do not change and the next kick does not contain these forces. This keeps the motion of
 * second order in the step.
 *
 * energy.removed receives the particle's kinetic energy at t_0 and the energy stored in the contacts, which the state
 * functions of the laws give. At a vertex a removed wall may leave a contact with the other wall that was suppressed.
 * Its spring appears loaded, and energy.changed receives its energy.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "core/contacts.h"
#include "loading.h"
#include "measure/energy.h"

/* Applies the half kick before t_0 of contact c to its one or two particles, and opens the contact: its fields are set
 * to 0. */
static void end_contact(struct nb_model *model, size_t c) {
  struct nb_contacts *contacts = &model->contacts;
  const struct nb_particles *particles = &model->particles;
  const size_t a = (size_t)contacts->a[c], b = (size_t)contacts->b[c];
  const struct nb_vec force = nb_contact_force(contacts, c);
  const double shear = contacts->force[c].shear;
  nb_motion_offset_force(model, a, (struct nb_force){force, shear * particles->radius[a]});
  if (!nb_with_wall(model, c))
    nb_motion_offset_force(model, b, (struct nb_force){vec_scale(-1, force), shear * particles->radius[b]});
  contacts->force[c] = (struct nb_contact_force){.shear = 0};
  for (int f = 0; f < NB_FIELDS; f++)
    if (contacts->kept[f])
      contacts->kept[f][c] = 0;
}

static void remove_particle(struct nb_model *model, size_t i) {
  struct nb_particles *particles = &model->particles;
  if (model->terms)
    nb_sum_add(&model->terms[NB_TERM_REMOVED], nb_energy_of_particle(model, i));
  const struct nb_contact_range range = nb_contact_range(&model->contacts.incidence, i);
  for (const int *c = range.first; c < range.end; c++)
    end_contact(model, (size_t)*c);
  if (model->boundary)
    nb_boundary_remove(model, i);
  if (model->affine)
    nb_affine_remove(model, i);
  particles->removed[i] = true;
  particles->inverse_mass[i] = particles->inverse_inertia[i] = 0;
  particles->velocity[i] = vec(0, 0);
  if (particles->spin)
    particles->spin[i] = 0;
}

static void remove_wall(struct nb_model *model, int w) {
  for (size_t c = model->contacts.wall_from; c < model->contacts.count; c++)
    if (model->contacts.b[c] == w) {
      if (model->terms)
        nb_sum_add(&model->terms[NB_TERM_REMOVED], nb_energy_of_contact(model, c));
      end_contact(model, c);
    }
  model->walls.removed[w] = true;
}

enum nb_status nb_pairs_changed(struct nb_model *model, struct nb_error *error) {
  if (nb_neighbours_search_again(model, error))
    return error->status;
  if (model->vertices.any)
    nb_vertices_suppress(model); /* of two new contacts at a vertex, only one counts */
  if (nb_balance_new_overlaps(model, error))
    return error->status;
  nb_balance_exclude(model, false);
  return NB_OK;
}

enum nb_status nb_remove(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error) {
  bool removes = stage->removal_count > 0;
  for (size_t m = 0; m < stage->motion_count; m++)
    removes = removes || stage->motions[m].removed;
  if (!removes)
    return NB_OK;
  nb_balance_exclude(model, true);
  for (size_t r = 0; r < stage->removal_count; r++)
    for (size_t k = stage->removals[r].from; k <= stage->removals[r].to; k++)
      remove_particle(model, (size_t)model->particles.slot[k]);
  for (size_t m = 0; m < stage->motion_count; m++)
    if (stage->motions[m].removed)
      remove_wall(model, stage->motions[m].wall);
  return nb_pairs_changed(model, error);
}
