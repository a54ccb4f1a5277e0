/* Makes a model of a scene: particles, walls, material pairs, the plan, the first search, the forces at time 0.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "core/team.h"
#include "laws/laws_now.h"
#include "loading/loading.h"
#include "measure/configuration.h"
#include "measure/energy.h"
#include "measure/impact.h"
#include "measure/region.h"
#include "measure/step.h"
#include "plan.h"
#include "restart.h"
#include "result.h"
#include "state.h"

#include <stdlib.h>

/* The slot of the particle with this index. `shuffle`, for tests: particles with even indices are stored from the
 * front, the others from the back. Results must not depend on the order of the slots. */
static size_t slot_of(size_t index, size_t count, bool shuffle) {
  if (!shuffle)
    return index;
  return index % 2 == 0 ? index / 2 : count - 1 - index / 2;
}

/* True if a particle may rotate at some time: because it has a spin at the start, or because of friction. Friction
 * causes no rotation if `rotation off` holds in all stages. */
static bool has_spin(const struct nb_scene *scene) {
  bool spin = false, rotates = scene->stages[0].rotation != NB_ROTATION_OFF;
  for (size_t k = 0; k < scene->particle_count; k++)
    spin = spin || scene->particles[k].spin != 0;
  for (size_t s = 0; s < scene->stage_count; s++)
    rotates = rotates || scene->stages[s].rotation == NB_ROTATION_ON;
  return spin || (rotates && nb_laws_shear(scene) && nb_laws_friction(scene));
}

static bool removes_particles(const struct nb_scene *scene) {
  for (size_t s = 0; s < scene->stage_count; s++)
    if (scene->stages[s].removal_count > 0)
      return true;
  return false;
}

static bool removes_walls(const struct nb_scene *scene) {
  bool removes = false;
  for (size_t s = 0; s < scene->stage_count; s++)
    for (size_t m = 0; m < scene->stages[s].motion_count; m++)
      removes = removes || scene->stages[s].motions[m].removed;
  return removes;
}

static bool has_centred_dashpots(const struct nb_scene *scene) {
  for (size_t s = 0; s < scene->stage_count; s++)
    if (scene->stages[s].damping.centred && nb_damping_contact_line(&scene->stages[s].damping) > 0)
      return true;
  return false;
}

static void fill_particles(struct nb_particles *particles, const struct nb_scene *scene, bool shuffle) {
  for (size_t k = 0; k < particles->count; k++) {
    const struct nb_particle *particle = &scene->particles[k];
    const size_t i = slot_of(k, particles->count, shuffle);
    particles->slot[k] = (int)i, particles->number[i] = (int)k + 1;
    particles->position[i] = vec(particle->x, particle->y), particles->velocity[i] = vec(particle->vx, particle->vy);
    particles->radius[i] = particle->radius, particles->surface_speed[i] = particle->spin * particle->radius;
    if (particles->spin)
      particles->spin[i] = particle->spin;
    particles->mass[i] = nb_particle_mass(scene, particle),
    particles->inertia[i] = nb_particle_inertia(scene, particle);
    particles->inverse_mass[i] = particle->fixed ? 0 : 1 / particles->mass[i];
    particles->inverse_inertia[i] = particle->fixed ? 0 : 1 / particles->inertia[i];
    particles->material[i] = particle->material;
  }
}

static void fill_walls(struct nb_walls *walls, const struct nb_scene *scene) {
  for (size_t w = 0; w < walls->count; w++) {
    const struct nb_wall *wall = &scene->walls[w];
    walls->pivot[w] = vec(wall->x, wall->y), walls->along[w] = vec(wall->ex, wall->ey);
    walls->point[w] = vec_add(walls->pivot[w], vec_scale(-wall->h0, vec_clockwise(walls->along[w])));
    walls->h0[w] = wall->h0, walls->h1[w] = wall->h1, walls->h2[w] = wall->h2;
    walls->velocity[w] = vec(wall->vx, wall->vy);
    walls->spin[w] = wall->spin;
  }
}

static double *numbers(struct nb_owner *owner, size_t n) { return nb_own(owner, n, sizeof(double)); }
static struct nb_vec *vectors(struct nb_owner *owner, size_t n) { return nb_own(owner, n, sizeof(struct nb_vec)); }
static int *integers(struct nb_owner *owner, size_t n) { return nb_own(owner, n, sizeof(int)); }

static void make_particles(struct nb_particles *b, const struct nb_scene *scene, struct nb_owner *owner) {
  const size_t n = b->count = scene->particle_count;
  b->number = integers(owner, n), b->slot = integers(owner, n), b->material = integers(owner, n);
  b->position = vectors(owner, n), b->velocity = vectors(owner, n);
  b->radius = numbers(owner, n), b->surface_speed = numbers(owner, n), b->search_position = vectors(owner, n);
  b->mass = numbers(owner, n), b->inertia = numbers(owner, n);
  b->inverse_mass = numbers(owner, n), b->inverse_inertia = numbers(owner, n);
  if (has_spin(scene))
    b->spin = numbers(owner, n), b->angle = numbers(owner, n);
  if (has_centred_dashpots(scene))
    b->ahead = nb_own(owner, n, sizeof *b->ahead);
  if (removes_particles(scene))
    b->removed = nb_own(owner, n, sizeof(bool));
}

static void make_walls(struct nb_walls *w, const struct nb_scene *scene, struct nb_owner *owner) {
  const size_t n = w->count = scene->wall_count;
  w->pivot = vectors(owner, n), w->point = vectors(owner, n), w->along = vectors(owner, n);
  w->velocity = vectors(owner, n), w->turn = vectors(owner, n), w->search_position = vectors(owner, 2 * n);
  w->h0 = numbers(owner, n), w->h1 = numbers(owner, n), w->h2 = numbers(owner, n);
  w->spin = numbers(owner, n), w->angle = numbers(owner, n);
  if (removes_walls(scene))
    w->removed = nb_own(owner, n, sizeof(bool));
}

/* Makes a material pair for any two materials of particles, equal or not, and for each material of particles with each
 * material of walls. False: out of memory. */
static bool make_material_pairs(struct nb_model *model) {
  const struct nb_scene *scene = model->scene;
  const size_t n = scene->material_count;
  bool *on_particle = calloc(n + 1, sizeof *on_particle), *on_wall = calloc(n + 1, sizeof *on_wall);
  model->material_pairs = nb_own(&model->owner, n * (n + 1) / 2 + n * n, sizeof *model->material_pairs);
  const bool allocated = on_particle && on_wall && model->material_pairs;
  if (allocated) {
    for (size_t k = 0; k < scene->particle_count; k++)
      on_particle[scene->particles[k].material] = true;
    for (size_t k = 0; k < scene->wall_count; k++)
      on_wall[scene->walls[k].material] = true;
    for (int wall = 0; wall < 2; wall++)
      for (int a = 0; a < (int)n; a++)
        for (int b = wall ? 0 : a; b < (int)n; b++) {
          if (!on_particle[a] || !(wall ? on_wall[b] : on_particle[b]))
            continue;
          model->material_pairs[model->material_pair_count++] = (struct nb_material_pair){
              .values = nb_properties_pair(&model->properties, a, b), .a = a, .b = b, .wall = wall};
        }
  }
  free(on_particle), free(on_wall);
  return allocated;
}

/* The skin of the neighbour list, m: the value of the page, or else a tenth of the mean radius. With a tenth, searches
 * are rare and most listed pairs touch. The skin is infinite if all particles are fixed, or if there is only one
 * particle and no wall, because then no search is needed. In a cell there are always searches: they test its width,
 * because a single particle could touch its own image. */
static double skin_of(const struct nb_model *model) {
  const struct nb_particles *particles = &model->particles;
  double sum = 0;
  bool free = false;
  for (size_t i = 0; i < particles->count; i++)
    sum += particles->radius[i], free = free || particles->inverse_mass[i] > 0;
  if (!model->scene->cell.line && (!free || particles->count + model->walls.count < 2))
    return INFINITY;
  return model->scene->skin > 0 ? model->scene->skin : 0.1 * sum / (double)particles->count;
}

static bool make_parts(struct nb_model *model, const struct nb_scene *scene, bool shuffle) {
  make_particles(&model->particles, scene, &model->owner);
  make_walls(&model->walls, scene, &model->owner);
  if (model->owner.failed)
    return false;
  fill_particles(&model->particles, scene, shuffle);
  fill_walls(&model->walls, scene);
  if (!nb_properties_create(&model->properties, scene) || !make_material_pairs(model) || !nb_stability_create(model) ||
      !nb_changes_create(model))
    return false;
  model->search.skin = skin_of(model);
  model->search.smallest_radius = INFINITY;
  for (size_t k = 0; k < scene->particle_count; k++)
    model->search.smallest_radius = fmin(model->search.smallest_radius, scene->particles[k].radius);
  return nb_cell_create(model) && nb_configuration_create(model);
}

/* Sets the values that hold before the first stage. */
static void set_initial_values(struct nb_model *model, const struct nb_scene *scene, const struct nb_options *options) {
  model->critical = nb_step_single_contact(model);
  model->damping = scene->stages[0].damping;
  model->gravity = vec(scene->gravity.x, scene->gravity.y);
  model->stability->allow_unstable = scene->allow_unstable || scene->stages[0].allow_unstable;
  model->rotates = true;
  model->plan.keep_all = options && options->keep_all;
  model->laws = model->next_laws = nb_laws_initial(scene);
}

/* Creates the imposed motion, the boundary, the plan and the first list of contacts. Sets the step, unless it comes
 * from a saved state. */
static enum nb_status create_contacts(struct nb_model *model, struct nb_saved *saved, struct nb_error *error) {
  const bool checkpoint = saved && saved->store.part_count;
  if (nb_affine_create(model, error) || nb_boundary_create(model, error) ||
      (saved && nb_saved_restore_loading(model, saved, error)) || nb_plan(model, error) ||
      (checkpoint ? nb_neighbours_restore(model, &saved->store, error) : nb_neighbours_search(model, error)))
    return error->status;
  model->stability->stable_step = nb_stable_step_stage(model).step;
  return saved ? NB_OK : nb_step_set(model, &model->scene->stages[0].step, error);
}

/* Moves the particle of `impact` back from the place of first touch, by its path in the fraction `phase` of a step. */
static void begin_impact(struct nb_model *model) {
  const struct nb_scene *scene = model->scene;
  const struct nb_impact_state incidence = nb_impact_incidence(scene);
  const int i = model->particles.slot[scene->monitors[scene->impact.monitor].a];
  model->impact_time = scene->impact.phase * model->step;
  model->particles.position[i] =
      vec_add(model->particles.position[i], vec_scale(-model->impact_time, incidence.velocity));
}

/* Sets the forces at the start: computes them, or takes them from the saved state. */
static enum nb_status initial_forces(struct nb_model *model, const struct nb_saved *saved, struct nb_error *error) {
  if (saved)
    return nb_saved_restore_contacts(model, saved, error);
  if (model->scene->impact.line)
    begin_impact(model);
  nb_forces(model), nb_deep_record_first(model);
  nb_deep_warn(model);
  return NB_OK;
}

/* Creates the measures that columns, conditions and snapshots request. */
static enum nb_status make_measures(struct nb_model *model, struct nb_error *error) {
  if (model->plan.requested & NB_REQUEST_FRACC && !nb_fracc_create(model))
    return nb_error_memory(error);
  if (nb_regions_create(model, error) || nb_regions_stage(model, -1, error))
    return error->status;
  return nb_balance_create(model, error);
}

static enum nb_status set_up(struct nb_model *model, const struct nb_options *options, struct nb_saved *saved,
                             struct nb_error *error) {
  const struct nb_scene *scene = model->scene;
  if (nb_machine_choose(model, options, error))
    return error->status;
  if (!make_parts(model, scene, options && options->shuffle))
    return nb_error_memory(error);
  set_initial_values(model, scene, options);
  if (!model->laws.normal || !model->laws.shear)
    return nb_error_set(error, NB_BAD_USE, "there is no law `%s %s`", model->laws.normal ? "shear" : "normal",
                        model->laws.normal ? scene->shear : scene->normal);
  if (saved)
    nb_saved_restore(model, saved);
  if (create_contacts(model, saved, error) || initial_forces(model, saved, error) || make_measures(model, error))
    return error->status;
  nb_guard_resolution(model);
  nb_regions_warn(model, NULL);
  nb_hooks_plan(model);
  return NB_OK;
}

struct nb_model *nb_model_resume(const struct nb_scene *scene, const struct nb_options *options, struct nb_saved *saved,
                                 struct nb_error *error) {
  struct nb_model *model = calloc(1, sizeof *model);
  if (!model) {
    nb_error_memory(error);
    return NULL;
  }
  model->scene = scene;
  model->plan.requested = nb_fields_requested(scene);
  if (set_up(model, options, saved, error)) {
    nb_model_free(model);
    return NULL;
  }
  return model;
}

struct nb_model *nb_model_create(const struct nb_scene *scene, const struct nb_options *options,
                                 struct nb_error *error) {
  if (scene->start.stages > 0)
    return nb_start_model(scene, options, error);
  return nb_model_resume(scene, options, NULL, error);
}

void nb_model_free(struct nb_model *model) {
  if (!model)
    return;
  nb_team_free(model->machine.team);
  free(model->vertices.list);
  free(model->blocks.scratch), free(model->deep.counts);
  nb_properties_free(&model->properties);
  nb_owner_free(&model->contacts.owner);
  nb_balance_free(model);
  nb_regions_free(model->regions, model->scene->region_count);
  nb_configuration_free(model->configuration);
  nb_owner_free(&model->owner);
  free(model);
}
