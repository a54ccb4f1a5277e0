/* Forces of the contacts of a region. A contact counts once if it touches and at least one of its particles is inside.
 *
 *   normal, shear      F_n and |F_s| of the laws, without dashpots, N
 *   contact_stress     F_n/(pi a^2), Pa        contact_shear   |F_s|/(pi a^2), Pa          [R89 sec. 4.6]
 *   contact_ratio      a over the radius of the smaller particle, 1                        [R89 sec. 4.6]
 *   obliquity          |F_s|/(mu F_n + c), dimensionless; its value is 1 if a contact slides     [R89 figure 6.18]
 *   sliding            fraction of the contacts whose law reports F_s at its limit         [CS79 19]
 *   sliding.near       fraction of the contacts with |F_s| at 0.99 of the limit mu F_n + c or above
 *   unbalanced.mean    mean magnitude of the sum of the forces on a free particle, including its weight and the force
 *                      of a boundary stress, over the mean of F_n
 *
 *   a      radius of the contact circle, m; for laws without one, such as `linear`, the contact stresses are 0
 *   mu, c  friction, 1, and cohesion, N, of the contact
 *
 * The two fractions of sliding contacts differ much, because any unloading in shear reduces the shear force below its
 * limit. A contact without friction has no limit and does not slide.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "region.h"

struct sums {
  double sum, count, max, min, first;
  double square; /* sum of squared deviations from the first value, which avoids cancellation */
};

static void add(struct sums *sums, double value) {
  sums->max = fmax(sums->max, value); /* no value is negative */
  sums->min = sums->count > 0 ? fmin(sums->min, value) : value;
  sums->first = sums->count > 0 ? sums->first : value;
  sums->square += (value - sums->first) * (value - sums->first);
  sums->sum += value, sums->count++;
}
static struct nb_statistics statistics(struct sums g) {
  const double mean = g.count > 0 ? g.sum / g.count : 0, offset = mean - g.first;
  const double variance = g.count > 0 ? g.square / g.count - offset * offset : 0;
  return (struct nb_statistics){mean, g.max, g.min, variance > 0 ? sqrt(variance) : 0};
}

static bool is_inside(const struct nb_model *model, const struct nb_region_state *region, size_t c) {
  const struct nb_contacts *contacts = &model->contacts;
  const bool wall = nb_with_wall(model, c);
  return nb_region_contains(model, region, (size_t)contacts->a[c]) ||
         (!wall && nb_region_contains(model, region, (size_t)contacts->b[c]));
}

static double mean_force_sum(const struct nb_model *model, const struct nb_region_state *region) {
  double sum = 0, count = 0;
  for (size_t k = 0, i; nb_region_next(model, region, &k, &i);)
    if (model->particles.inverse_mass[i] > 0)
      sum += vec_length(nb_unbalanced_force(model, i)), count++;
  return count > 0 ? sum / count : 0;
}

void nb_measure_loads(const struct nb_model *model, struct nb_region_state *region) {
  struct nb_loads *loads = &region->loads;
  const struct nb_contacts *contacts = &model->contacts;
  struct sums normal = {0}, shear = {0}, pressure = {0}, traction = {0}, ratio = {0}, obliquity = {0};
  double sliding = 0, near_sliding = 0;
  for (size_t c = 0; c < contacts->count; c++) {
    if (!nb_touches(contacts, c) || !is_inside(model, region, c))
      continue;
    const struct nb_contact_load load = nb_contact_load(model, c);
    add(&normal, load.normal), add(&shear, load.shear);
    add(&pressure, load.pressure), add(&traction, load.traction), add(&ratio, load.ratio);
    if (load.limit > 0)
      add(&obliquity, load.obliquity);
    sliding += load.sliding;
    near_sliding += load.near_sliding;
  }
  loads->normal = statistics(normal), loads->shear = statistics(shear);
  loads->pressure = statistics(pressure), loads->traction = statistics(traction), loads->ratio = statistics(ratio);
  loads->obliquity = statistics(obliquity);
  loads->sliding = normal.count > 0 ? sliding / normal.count : 0;
  loads->near_sliding = normal.count > 0 ? near_sliding / normal.count : 0;
  loads->unbalanced_force = mean_force_sum(model, region);
  loads->unbalanced_mean = loads->unbalanced_force > 0 ? loads->unbalanced_force / loads->normal.mean : 0;
}

/* A shear force of at least this fraction of its limit counts as near the limit. This is a convention, which the help
 * of the quantities states. With a fraction of 1, only contacts that have not been unloaded at all would count. */
static const double near_limit = 0.99;

struct nb_contact_load nb_contact_load(const struct nb_model *model, size_t contact) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_material_pair *material_pair = &model->material_pairs[contacts->material_pair[contact]];
  const bool has_friction = material_pair->shear;
  const double first = model->particles.radius[contacts->a[contact]];
  const double second = material_pair->wall ? first : model->particles.radius[contacts->b[contact]];
  const double a = contacts->kept[NB_RADIUS][contact], area = NB_PI * a * a;
  struct nb_contact_load load = {.normal = contacts->kept[NB_NORMAL][contact], .radius = a};
  load.shear = has_friction ? fabs(contacts->kept[NB_SHEAR][contact]) : 0;
  load.sliding = has_friction ? contacts->kept[NB_SLIDING][contact] : 0;
  load.limit = has_friction ? material_pair->values.friction * load.normal + material_pair->values.cohesion : 0;
  load.near_sliding = load.limit > 0 && load.shear >= near_limit * load.limit;
  load.obliquity = load.limit > 0 ? load.shear / load.limit : 0;
  load.pressure = a > 0 ? load.normal / area : 0;
  load.traction = a > 0 ? load.shear / area : 0;
  load.ratio = a / fmin(first, second);
  return load;
}
