/* Directions of contacts: structural anisotropy and fabric.                                       [R89 4.45-4.54]
 *
 *   Phi_ij = <n_i n_j>,   Phi_ijkl = <n_i n_j n_k n_l>          mean over the contacts        [R89 4.47, 4.48]
 *   F_ij = F_kk Phi_ij,   F_kk = 2M R/V                                                       [R89 4.45, 4.46]
 *
 *   n     contact normal, 1         M  contacts: 2M of their ends are on the bodies inside
 *   R     mean radius of the bodies inside, m         V  area times thickness, m3
 *
 * The mean is over the ends of contacts on the bodies inside, so that a contact of two of them counts twice and one with a wall
 * or with a body outside once; in an assembly without walls that is R89's mean over contacts. Weighted by the normal
 * force F_n it is sum F_n n_i n_j over sum F_n, by the shear force sum |F_s| n_i n_j over sum |F_s|; of contacts that slide it is over those with |F_s| at 0.99 of its limit or above, as sliding.near
 * of loads.c. Traces are 1 all four times.
 *
 * n contacts evenly round a body give Phi_ij = delta_ij/2 for n of 3 or more, Phi_xxxx = 3/8 and Phi_xxyy = 1/8 for 3, 5 or more.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "region.h"

/* Adds an end with a weight. */
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

static double mean_radius(const struct nb_model *model, const struct nb_region_now *region) {
  double sum = 0, count = 0;
  for (size_t k = 0; k < model->bodies.count; k++) {
    const size_t i = (size_t)model->bodies.slot[k];
    if (nb_region_holds(model, region, i))
      sum += model->bodies.rim[i].x, count++;
  }
  return count > 0 ? sum / count : 0;
}

const struct nb_fabric *nb_fabric_of(const struct nb_model *model, const struct nb_watch *watch) {
  struct nb_region_now *region = nb_region_now(model, watch->a);
  struct nb_fabric *fabric = &region->fabric;
  if (!nb_region_due(model, region, NB_FABRIC))
    return fabric;
  *fabric = (struct nb_fabric){0};
  double ends_count = 0, normal = 0, shear = 0, sliding = 0;
  struct nb_end end;
  for (struct nb_ends ends = nb_ends_of(model, region); nb_ends_next(&ends, &end);) {
    const struct nb_contact_load load = nb_contact_load(model, end.contact);
    add(&fabric->plain, &ends_count, 1, end.e);
    add(&fabric->normal, &normal, load.normal, end.e);
    add(&fabric->shear, &shear, load.shear, end.e);
    add(&fabric->sliding, &sliding, load.near, end.e);
  }
  divide(&fabric->plain, ends_count), divide(&fabric->normal, normal), divide(&fabric->shear, shear);
  divide(&fabric->sliding, sliding);
  const double volume = region->area * region->thickness;
  fabric->kk = volume > 0 ? ends_count * mean_radius(model, region) / volume : 0;
  return fabric;
}

#define FABRIC nb_fabric_of(model, watch)
#define QUANTITIES(stem)                                                                                               \
  NB_TENSOR_QUANTITIES(stem, FABRIC->stem.second)                                                                      \
  NB_QUANTITY(stem##_xxxx, FABRIC->stem.xxxx)                                                                          \
  NB_QUANTITY(stem##_xxxy, FABRIC->stem.xxxy)                                                                          \
  NB_QUANTITY(stem##_xxyy, FABRIC->stem.xxyy)                                                                          \
  NB_QUANTITY(stem##_xyyy, FABRIC->stem.xyyy)                                                                          \
  NB_QUANTITY(stem##_yyyy, FABRIC->stem.yyyy)
QUANTITIES(plain)
QUANTITIES(normal)
QUANTITIES(shear)
QUANTITIES(sliding)
NB_QUANTITY(kk, FABRIC->kk)

enum { READS = NB_READS_ENDS | NB_READS_LOADS };
#define FOURTH(name, stem, index, what)                                                                                \
  { name ".fourth." #index, NB_OF_REGION, "1", READS, stem##_##index, what ", of fourth order" }
#define ROWS(name, stem, what)                                                                                         \
  NB_TENSOR_ROWS(name, NB_OF_REGION, "1", READS, stem, "anisotropy", what), FOURTH(name, stem, xxxx, what),            \
      FOURTH(name, stem, xxxy, what), FOURTH(name, stem, xxyy, what), FOURTH(name, stem, xyyy, what),                  \
      FOURTH(name, stem, yyyy, what)

const struct nb_quantity_kind nb_fabric_kinds[] = {
    ROWS("fabric", plain, "structural anisotropy Phi [R89 4.48]"),
    {"fabric.kk", NB_OF_REGION, "1/m2", READS, kk, "F_kk, ends of contacts times mean radius over volume [R89 4.46]"},
    ROWS("fabric.normal", normal, "Phi weighted by the normal force"),
    ROWS("fabric.shear", shear, "Phi weighted by the shear force's size"),
    ROWS("fabric.sliding", sliding, "Phi of contacts whose shear force is 0.99 of its limit or more"),
    {NULL, 0, NULL, 0, NULL, NULL},
};
