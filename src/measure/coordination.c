/* How many contacts a body of a region has.
 *
 *   coordination          2M/N          ends of contacts on the bodies inside, over those bodies
 *   coordination.loaded                 the same without rattlers, and without their contacts
 *
 * A rattler has fewer than two contacts with bodies that are none, or with walls: what is left of all bodies, inside or not,
 * when those with fewer than two contacts are taken away until no more go. What is fixed is never a rattler. (Two contacts
 * that are not opposite each other do not hold a body either; nothing that is pressed has such ones without friction.)
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "region.h"

/* The body at the other end; -1: a wall. */
static int partner(const struct nb_model *model, size_t contact, size_t slot) {
  const struct nb_contacts *contacts = &model->contacts;
  if (model->material_pairs[contacts->material_pair[contact]].wall)
    return -1;
  return (size_t)contacts->a[contact] == slot ? contacts->b[contact] : contacts->a[contact];
}

static bool is_rattler(const struct nb_model *model, size_t slot) {
  return model->particles.inverse_mass[slot] > 0 && model->regions->touching[slot] < 2;
}

/* Leaves in `touching` how many contacts each body has with others that are no rattlers, -1 for a rattler. */
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
    const struct nb_contact_range its = nb_contact_range(&model->contacts.of, i);
    for (const int *entry = its.first; entry < its.end; entry++) {
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

void nb_measure_coordination(const struct nb_model *model, struct nb_region_state *region) {
  struct nb_coordination *it = &region->coordination;
  *it = (struct nb_coordination){0};
  find_rattlers(model);
  const int *touching = model->regions->touching;
  double loaded = 0; /* bodies */
  for (size_t k = 0, i; nb_region_next(model, region, &k, &i);) {
    it->particles++;
    it->rattlers += touching[i] < 0, loaded += touching[i] >= 0;
    it->mechanical += touching[i] >= 0 ? touching[i] : 0;
    const struct nb_contact_range its = nb_contact_range(&model->contacts.of, i);
    for (const int *entry = its.first; entry < its.end; entry++) {
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
