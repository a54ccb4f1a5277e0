/* Units of the time step.
 *
 *   single-contact  t_c = 2 sqrt(m/k)                                                  [CS79, Motion]
 *              with the smallest mass m of a free particle and the largest normal stiffness k between materials of the
 *              scene: the limit of one mass on one spring; a particle with several contacts has a smaller limit
 *   stable     the guaranteed stable step for the contacts and the damping at the beginning of the stage:
 *              stable_step.c
 *   collision  duration of the shortest possible head-on collision of two particles, or of a particle and a wall,
 *              without damping:
 *              linear springs   pi sqrt(M* / k_n), half an oscillation of the reduced mass M* = m_x m_y/(m_x + m_y) on
 *                               the spring; the shortest for the lightest two particles of any pair of materials
 *              elastic spheres  2.943 alpha_m/v (hertz_impact.h), which depends on the speed v; the shortest of the
 *                               collisions predicted at the beginning of the stage that sets the step (collision.c)
 *   rayleigh   time in which a surface wave travels half round a sphere: rayleigh_step.c                [R89 4.33]
 *
 * The stiffness of elastic spheres depends on the overlap and is 0 without an overlap. So elastic spheres have no
 * single-contact step, and `stable` needs loaded contacts. A step that was set from predicted collisions is kept in
 * later stages.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "step.h"
#include "core/names.h"

double nb_step_single_contact(const struct nb_model *model) {
  double mass = INFINITY, stiffness = 0;
  for (size_t i = 0; i < model->particles.count; i++)
    if (model->particles.inverse_mass[i] > 0 && model->particles.mass[i] < mass)
      mass = model->particles.mass[i];
  for (size_t p = 0; p < model->material_pair_count; p++) {
    const double kn = nb_properties_pair(&model->properties, model->material_pairs[p].a, model->material_pairs[p].b).kn;
    stiffness = kn > stiffness ? kn : stiffness;
  }
  return 2 * sqrt(mass / stiffness);
}

/* True if a wall of the material has not been removed. */
static bool has_wall(const struct nb_model *model, int material) {
  bool has = false;
  for (size_t w = 0; w < model->walls.count; w++)
    has = has || (model->scene->walls[w].material == material && !nb_wall_removed(&model->walls, w));
  return has;
}

void nb_step_lightest(const struct nb_model *model, const struct nb_material_pair *material_pair, int lightest[2]) {
  const struct nb_particles *particles = &model->particles;
  lightest[0] = lightest[1] = -1;
  if (material_pair->wall && !has_wall(model, material_pair->b))
    return;
  for (int side = 0; side < (material_pair->wall ? 1 : 2); side++)
    for (size_t k = 0; k < particles->count; k++) {
      const int i = particles->slot[k], least = lightest[side];
      if (nb_removed(model, (size_t)i))
        continue;
      if (particles->material[i] == (side ? material_pair->b : material_pair->a) && i != lightest[0] &&
          (least < 0 || particles->inverse_mass[i] > particles->inverse_mass[least]))
        lightest[side] = i;
    }
}

enum nb_status nb_step_collision(struct nb_collision *shortest, const struct nb_model *model, struct nb_error *error) {
  if (nb_step_elastic(model))
    return nb_collision_shortest(shortest, model, error);
  const double *inverse = model->particles.inverse_mass;
  double square = 0; /* the largest k_n/M*, 1/s2 */
  for (size_t p = 0; p < model->material_pair_count; p++) {
    const struct nb_material_pair *material_pair = &model->material_pairs[p];
    int pair[2];
    nb_step_lightest(model, material_pair, pair);
    if (pair[0] < 0 || (!material_pair->wall && pair[1] < 0))
      continue;
    const double kn = nb_properties_pair(&model->properties, material_pair->a, material_pair->b).kn;
    const double here = kn * (inverse[pair[0]] + (material_pair->wall ? 0 : inverse[pair[1]]));
    square = here > square ? here : square;
  }
  *shortest = (struct nb_collision){NB_PI / sqrt(square), 0, -1, -1, false};
  return NB_OK;
}

bool nb_step_elastic(const struct nb_model *model) {
  return model->material_pair_count > 0 && model->next_laws.normal->elastic;
}

/* Largest overlap of elastic spheres, over the radius, that counts as rounding; the stiffness there is negligible. */
static const double rounding_overlap = 1e-9;

bool nb_step_loaded(const struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  for (size_t c = 0; c < contacts->count; c++)
    if (nb_overlap(model, c) > rounding_overlap * model->particles.radius[contacts->a[c]])
      return true;
  return false;
}

/* The reason why a step of this kind cannot be used; NULL: it can be used. `unit`: the time of which the step is a
 * fraction, s; infinite if there is none. */
static const char *objection(const struct nb_model *model, enum nb_step_kind kind, double unit) {
  if (kind == NB_STEP_COLLISION && model->cell && nb_step_elastic(model))
    return "collisions of elastic spheres are not predicted in a periodic cell";
  if (kind >= NB_STEP_RAYLEIGH && !(unit < INFINITY))
    return "no free particle has `young`, so there are no waves";
  if (!nb_step_elastic(model))
    return NULL;
  if (kind == NB_STEP_SINGLE_CONTACT)
    return "elastic spheres have no single-contact step, because their stiffness increases with the load";
  if (kind == NB_STEP_STABLE && !nb_step_loaded(model))
    return "the stable step follows from the stiffness of the contacts, and elastic spheres without overlap have none";
  if (kind == NB_STEP_COLLISION && !(unit < INFINITY))
    return "no pair approaches, so there is no collision";
  return NULL;
}

enum nb_status nb_step_set(struct nb_model *model, const struct nb_step *step, struct nb_error *error) {
  const int line = step->set ? 0 : step->line;
  const char *const source = step->set ? "--set: " : "";
  double unit = 1;
  struct nb_collision shortest;
  if (step->kind == NB_STEP_COLLISION && nb_step_elastic(model) && line == model->stability->step_line)
    return NB_OK;
  switch (step->kind) {
  case NB_STEP_TIME:
    break;
  case NB_STEP_SINGLE_CONTACT:
    unit = model->critical;
    break;
  case NB_STEP_STABLE:
    unit = model->stability->stable_step;
    break;
  case NB_STEP_COLLISION:
    if (nb_step_collision(&shortest, model, error))
      return error->status;
    unit = shortest.duration;
    break;
  case NB_STEP_RAYLEIGH:
  case NB_STEP_RAYLEIGH_MEAN:
  case NB_STEP_RAYLEIGH_FIT:
  case NB_STEP_RAYLEIGH_FIT_MEAN:
    unit = nb_step_rayleigh(model, step->kind >= NB_STEP_RAYLEIGH_FIT,
                            step->kind == NB_STEP_RAYLEIGH_MEAN || step->kind == NB_STEP_RAYLEIGH_FIT_MEAN);
    break;
  }
  const char *reason = objection(model, step->kind, unit);
  if (reason) {
    nb_error_set(error, NB_BAD_USE, "%s%s: write %s", source, reason,
                 step->kind >= NB_STEP_RAYLEIGH ? "a time, or `step 0.2 of stable`"
                 : step->kind == NB_STEP_COLLISION
                     ? "a time, or `step 0.2 of rayleigh`"
                     : "`step 0.2 of rayleigh`, or with approaching pairs `step 200 per collision`");
    error->line = line;
    return NB_BAD_USE;
  }
  model->step = step->value * unit;
  model->stability->step_line = line;
  if (!(model->step > 0) || !isfinite(model->step)) {
    nb_error_set(error, NB_BAD_USE,
                 "%sthe step %s: a fraction needs a free particle, a partner that it could touch, and a material with "
                 "`kn`. Add what is missing, or write `step TIME`",
                 source, model->step > 0 ? "has no limit" : "is 0");
    error->line = line;
    return NB_BAD_USE;
  }
  return NB_OK;
}

/* ---- quantities ---- */

NB_QUANTITY(step, model->step)
NB_QUANTITY(critical, model->critical)
NB_QUANTITY(stable, nb_stable_step(model).step)
NB_QUANTITY(fracc, model->fracc->largest)
NB_QUANTITY(rayleigh, nb_step_rayleigh(model, false, false))
NB_QUANTITY(rayleigh_mean, nb_step_rayleigh(model, false, true))
NB_QUANTITY(rayleigh_fit, nb_step_rayleigh(model, true, false))
NB_QUANTITY(rayleigh_fit_mean, nb_step_rayleigh(model, true, true))

const struct nb_quantity_kind nb_step_kinds[] = {
    {"step", 0, "s", 0, step, "the time step", NB_AT_LEAST_0},
    {"step.single-contact", 0, "s", 0, critical,
     "2 sqrt(m/k) of the smallest mass and the largest stiffness [CS79, Motion]", NB_AT_LEAST_0},
    {"step.stable", 0, "s", 0, stable, "the largest step guaranteed stable with the present neighbour list and damping",
     NB_AT_LEAST_0},
    {"step.fracc", 0, "1", NB_REQUEST_FRACC, fracc,
     "FRACC, the largest of all particles in the last cycle: not a stability bound [R89 4.40]", NB_AT_LEAST_0},
    {"step.rayleigh", 0, "s", 0, rayleigh,
     "travel time of a Rayleigh wave over half the circumference of a sphere, the shortest over all spheres [R89 4.33]",
     NB_AT_LEAST_0},
    {"step.rayleigh-mean", 0, "s", 0, rayleigh_mean, "as step.rayleigh, for a sphere with the mean properties",
     NB_AT_LEAST_0},
    {"step.rayleigh-fit", 0, "s", 0, rayleigh_fit, "as step.rayleigh, with R89's fit of the wave's speed [R89 4.34]",
     NB_AT_LEAST_0},
    {"step.rayleigh-fit-mean", 0, "s", 0, rayleigh_fit_mean, "R89's step: as step.rayleigh-mean, with the fit",
     NB_AT_LEAST_0},
    {.name = NULL},
};
