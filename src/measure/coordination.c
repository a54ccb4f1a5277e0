/* Coordination number of a region.
 *
 *   coordination               2M/N     number of contact ends on particles inside, over the number of these particles
 *   coordination.mechanical             the same without rattlers and their contacts
 *   constraint_ratio           constraints over degrees of freedom of the free particles   [Cundall and Strack 1983]
 *
 * The constraint ratio counts the free particles inside that are not rattlers, and once each of their contacts with
 * walls and with particles that are not rattlers. A particle has two degrees of freedom, or three if any of the counted
 * contacts has friction. A contact is one constraint, or two if it has friction and does not slide. If the ratio is
 * below 1, the particles are a mechanism; if it is 1, statics alone determines the forces.
 *
 * A rattler has fewer than two contacts, not counting contacts with other rattlers. Rattlers are found by removing
 * particles with fewer than two contacts, inside the region or not, until none is left. A fixed particle is not a
 * rattler. A particle with two contacts that are not opposite is not a rattler either, although without friction the
 * two forces cannot balance.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "region.h"

/* Slot of the other particle of the contact; -1: a wall. */
static int partner(const struct nb_model *model, size_t contact, size_t slot) {
  const struct nb_contacts *contacts = &model->contacts;
  if (nb_with_wall(model, contact))
    return -1;
  return (size_t)contacts->a[contact] == slot ? contacts->b[contact] : contacts->a[contact];
}

static bool is_free(const struct nb_model *model, size_t slot) { return model->particles.inverse_mass[slot] > 0; }

static bool is_rattler(const struct nb_model *model, size_t slot) {
  return is_free(model, slot) && model->regions->touching[slot] < 2;
}

/* Sets `touching` of each rattler to -1, and of each other particle to the number of its contacts with walls and with
 * particles that are not rattlers. */
static void find_rattlers(const struct nb_model *model) {
  int *touching = model->regions->touching, *queue = model->regions->queue;
  size_t queued = 0;
  for (size_t i = 0; i < model->particles.count; i++)
    touching[i] = nb_coordination_number(&model->contacts, i);
  for (size_t i = 0; i < model->particles.count; i++)
    if (is_rattler(model, i))
      queue[queued++] = (int)i;
  for (size_t k = 0; k < queued; k++)
    touching[queue[k]] = -1;
  while (queued > 0) {
    const size_t i = (size_t)queue[--queued];
    const struct nb_contact_range range = nb_contact_range(&model->contacts.incidence, i);
    for (const int *entry = range.first; entry < range.end; entry++) {
      const size_t c = (size_t)*entry;
      const int other = nb_touches(&model->contacts, c) ? partner(model, c, i) : -1;
      if (other < 0 || touching[other] < 0)
        continue;
      touching[other]--;
      if (is_rattler(model, (size_t)other))
        touching[other] = -1, queue[queued++] = other;
    }
  }
}

struct constraints {
  double particles, constraints;
  bool friction;
};

/* Adds one end of a load-carrying contact, at a free particle inside. `both`: the other end is at such a particle
 * too. */
static void add_constraint(struct constraints *it, const struct nb_model *model, size_t contact, bool both) {
  const bool friction = model->material_pairs[model->contacts.material_pair[contact]].shear;
  const bool sticks = friction && !(model->contacts.kept[NB_SLIDING][contact] > 0);
  it->friction = it->friction || friction;
  it->constraints += (sticks ? 2 : 1) / (both ? 2. : 1.);
}

/* True for a wall, which has the slot -1, and for a particle that is not a rattler. */
static bool is_loaded(const struct nb_model *model, int slot) {
  return slot < 0 || model->regions->touching[slot] >= 0;
}

void nb_measure_constraints(const struct nb_model *model, struct nb_region_state *region) {
  struct constraints it = {0};
  find_rattlers(model);
  for (size_t k = 0, i; nb_region_next(model, region, &k, &i);) {
    if (!is_free(model, i) || !is_loaded(model, (int)i))
      continue;
    it.particles++;
    const struct nb_contact_range range = nb_contact_range(&model->contacts.incidence, i);
    for (const int *entry = range.first; entry < range.end; entry++) {
      const int other = partner(model, (size_t)*entry, i);
      if (nb_touches(&model->contacts, (size_t)*entry) && is_loaded(model, other))
        add_constraint(&it, model, (size_t)*entry,
                       other >= 0 && is_free(model, (size_t)other) && nb_region_contains(model, region, (size_t)other));
    }
  }
  region->constraint_ratio = it.particles > 0 ? it.constraints / ((it.friction ? 3 : 2) * it.particles) : 0;
}

void nb_measure_coordination(const struct nb_model *model, struct nb_region_state *region) {
  struct nb_coordination *it = &region->coordination;
  *it = (struct nb_coordination){0};
  find_rattlers(model);
  const int *touching = model->regions->touching;
  double loaded = 0; /* number of particles that are not rattlers */
  for (size_t k = 0, i; nb_region_next(model, region, &k, &i);) {
    it->particles++;
    it->rattlers += touching[i] < 0, loaded += touching[i] >= 0;
    it->mechanical += touching[i] >= 0 ? touching[i] : 0;
    const struct nb_contact_range range = nb_contact_range(&model->contacts.incidence, i);
    for (const int *entry = range.first; entry < range.end; entry++) {
      const size_t c = (size_t)*entry;
      if (!nb_touches(&model->contacts, c))
        continue;
      const int other = partner(model, c, i);
      it->mean++;
      it->contacts +=
          other < 0 || !nb_region_contains(model, region, (size_t)other) || i == (size_t)model->contacts.a[c];
    }
  }
  it->mean /= it->particles > 0 ? it->particles : 1;
  it->mechanical /= loaded > 0 ? loaded : 1;
}
