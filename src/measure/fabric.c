/* Directions of contacts: structural anisotropy and fabric.                                       [R89 4.45-4.54]
 *
 *   Phi_ij = <n_i n_j>,   Phi_ijkl = <n_i n_j n_k n_l>          mean over the contacts        [R89 4.47, 4.48]
 *   F_ij = F_kk Phi_ij,   F_kk = 2M R/V                                                       [R89 4.45, 4.46]
 *
 *   n     contact normal, 1                           M  half the number of contact ends on particles inside
 *   R     mean radius of the particles inside, m      V  area times thickness, m3
 *
 * The mean is over the contact ends on particles inside: a contact of two particles inside counts twice, a contact with
 * a wall or with a particle outside once. If the region contains all particles and there are no walls, this is R89's
 * mean over contacts. Weighted by the normal force, Phi is sum F_n n_i n_j over sum F_n; weighted by the shear force,
 * sum |F_s| n_i n_j over sum |F_s|.
 * Phi of sliding contacts is the mean over contacts with |F_s| at 0.99 of its limit or above, as sliding.near of
 * loads.c. The trace of each of the four is 1, or 0 if there is no such contact.
 *
 * k contacts evenly spaced round a particle give Phi_ij = delta_ij/2 for k >= 3, and Phi_xxxx = 3/8 and Phi_xxyy = 1/8
 * for k = 3 and k >= 5.
 *
 * Phi of lost and of new contacts [R89 figure 6.35] is the mean over their ends. The reference time is the beginning of
 * the region's `from` stage, or of the run:
 *
 *   lost   a contact that touched at the reference time and does not touch now
 *   new    a contact that touches now and did not touch then; one that opened and closed again in between is neither
 *   n      unit vector between the current centres, or to the nearest point of the wall
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "configuration.h"
#include "region.h"

static void add(struct nb_anisotropy *phi, double *sum, double weight, struct nb_vec n) {
  phi->second = tensor_add(phi->second, tensor_scale(weight, tensor_outer(n, n)));
  phi->xxxx += weight * n.x * n.x * n.x * n.x;
  phi->xxxy += weight * n.x * n.x * n.x * n.y;
  phi->xxyy += weight * n.x * n.x * n.y * n.y;
  phi->xyyy += weight * n.x * n.y * n.y * n.y;
  phi->yyyy += weight * n.y * n.y * n.y * n.y;
  *sum += weight;
}

static void divide(struct nb_anisotropy *phi, double sum) {
  const double s = sum > 0 ? 1 / sum : 0;
  phi->second = tensor_scale(s, phi->second);
  phi->xxxx *= s, phi->xxxy *= s, phi->xxyy *= s, phi->xyyy *= s, phi->yyyy *= s;
}

static double mean_radius(const struct nb_model *model, const struct nb_region_state *region) {
  double sum = 0, count = 0;
  for (size_t k = 0, i; nb_region_next(model, region, &k, &i); count++)
    sum += model->particles.radius[i];
  return count > 0 ? sum / count : 0;
}

void nb_measure_fabric(const struct nb_model *model, struct nb_region_state *region) {
  struct nb_fabric *fabric = &region->fabric;
  *fabric = (struct nb_fabric){0};
  double ends_count = 0, normal = 0, shear = 0, sliding = 0;
  struct nb_end end;
  for (struct nb_ends ends = nb_ends_begin(model, region); nb_ends_next(&ends, &end);) {
    const struct nb_contact_load load = nb_contact_load(model, end.contact);
    add(&fabric->plain, &ends_count, 1, end.e);
    add(&fabric->normal, &normal, load.normal, end.e);
    add(&fabric->shear, &shear, load.shear, end.e);
    add(&fabric->sliding, &sliding, load.near_sliding, end.e);
  }
  divide(&fabric->plain, ends_count), divide(&fabric->normal, normal), divide(&fabric->shear, shear);
  divide(&fabric->sliding, sliding);
  const double volume = region->area * region->thickness;
  fabric->kk = volume > 0 ? ends_count * mean_radius(model, region) / volume : 0;
}

/* ---- lost and new contacts ---- */

enum nb_status nb_changed_contacts_begin(struct nb_model *model, int stage, struct nb_error *error) {
  const struct nb_scene *scene = model->scene;
  if (!(model->plan.requested & NB_REQUEST_CHANGED_CONTACTS))
    return NB_OK;
  for (size_t r = 0; r < scene->region_count; r++)
    if ((stage < 0 || scene->regions[r].stage == stage) &&
        !nb_touching_pairs(&model->regions->list[r].reference_pairs, model))
      return nb_error_memory(error);
  return NB_OK;
}

static double ends_inside(const struct nb_model *model, const struct nb_region_state *region,
                          struct nb_neighbour_pair pair) {
  const bool wall = model->material_pairs[pair.material_pair].wall;
  return nb_region_contains(model, region, (size_t)pair.a) +
         (!wall && nb_region_contains(model, region, (size_t)pair.b));
}

/* Adds a lost or a new contact with this number of ends inside. `line`: vector between the centres of its particles, or
 * from the centre to the wall. */
static void count(struct nb_changed_contacts *it, double ends, struct nb_vec line) {
  const double square = vec_dot(line, line); /* 0 if a centre is on a wall */
  it->count += ends > 0, it->ends += ends;
  it->phi = tensor_add(it->phi, tensor_scale(square > 0 ? ends / square : 0, tensor_outer(line, line)));
}
static void average(struct nb_changed_contacts *it) {
  it->phi = tensor_scale(it->ends > 0 ? 1 / it->ends : 0, it->phi);
}

void nb_measure_changed_contacts(const struct nb_model *model, struct nb_region_state *region) {
  region->lost = region->gained = (struct nb_changed_contacts){0};
  struct nb_configuration_walk walk = {.model = model, .reference = &region->reference_pairs};
  struct nb_neighbour_pair pair;
  for (int kind; nb_configuration_next(&walk, &pair, &kind);)
    if (kind)
      count(kind < 0 ? &region->lost : &region->gained, ends_inside(model, region, pair), nb_pair_branch(model, pair));
  average(&region->lost), average(&region->gained);
}
