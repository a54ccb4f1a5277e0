/* Captures the state of a model, and restores it in another one.
 *
 * The forces and the histories of the contacts are saved, not computed again: the laws have already used the
 * increments of the last step. A model that continues from a state searches for neighbours, restores forces and
 * histories, and begins with the motion. Its results equal those of an uninterrupted run to the bit.
 *
 * The saved strain rates are those of the last step, because the first row of the next stage records them. The strain
 * rates that the page requests apply until a stage requests others; the contribution of a servo ends with its stage.
 * The search positions, and the particles that may cross the boundary before the next search, are not saved, because
 * they do not affect results; a checkpoint saves the search positions (checkpoint.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "state.h"

#include <stdlib.h>
#include <string.h>

#include "input/reader.h"
#include "laws/laws_now.h"
#include "loading/loading.h"
#include "measure/step.h"
#include "output_file.h"

/* ---- capture ---- */

static void capture_particles(struct nb_saved *saved, const struct nb_model *model) {
  const struct nb_particles *particles = &model->particles;
  for (size_t k = 0; k < particles->count; k++) {
    const size_t i = (size_t)particles->slot[k];
    const struct nb_particle *particle = &model->scene->particles[k];
    saved->particles[k] = (struct nb_saved_particle){
        .shape = particle->shape,
        .mobility = nb_removed(model, i) ? NB_REMOVED
                    : particle->fixed    ? NB_FIXED
                                         : NB_FREE,
        .material = particle->material,
        .radius = particles->radius[i],
        .position = particles->position[i],
        .velocity = particles->velocity[i],
        .spin = particles->spin ? particles->spin[i] : 0,
        .angle = particles->angle ? particles->angle[i] : 0,
    };
  }
  saved->particle_count = particles->count;
}

/* Members that struct nb_saved_wall and struct nb_walls share. */
#define WALL_MEMBERS(X) X(pivot) X(along) X(velocity) X(turn) X(h0) X(h1) X(h2) X(spin) X(angle)

static void capture_walls(struct nb_saved *saved, const struct nb_model *model) {
  for (size_t w = 0; w < model->walls.count; w++) {
    struct nb_saved_wall *it = &saved->walls[w];
    memcpy(it->name, model->scene->walls[w].name, sizeof it->name);
    it->material = model->scene->walls[w].material;
#define CAPTURE(member) it->member = model->walls.member[w];
    WALL_MEMBERS(CAPTURE)
  }
  saved->wall_count = model->walls.count;
}

/* Appends the history of contact `c` to the saved histories. Appends nothing if the history is empty: its first double
 * is 0 in a history stored by rows, all its doubles are 0 otherwise. */
static struct nb_saved_history capture_history(struct nb_saved *saved, const struct nb_history *history,
                                               const struct nb_law *law, size_t c) {
  double buffer[NB_HISTORY];
  const double *m = nb_history_read(history, c, buffer);
  struct nb_saved_history it = {.at = saved->history_count};
  for (int k = 0; k < (history->rows ? 1 : history->doubles); k++)
    if (m[k] != 0)
      it.count = law->used ? law->used(m) : history->doubles;
  memcpy(saved->history + it.at, m, (size_t)it.count * sizeof *m);
  saved->history_count += (size_t)it.count;
  return it;
}

static void capture_contacts(struct nb_saved *saved, const struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_particles *particles = &model->particles;
  for (size_t c = 0; c < contacts->count; c++) {
    const bool wall = nb_with_wall(model, c);
    struct nb_saved_contact it = {.a = particles->number[contacts->a[c]] - 1,
                                  .b = wall ? contacts->b[c] : particles->number[contacts->b[c]] - 1,
                                  .wall = wall,
                                  .suppressed = nb_is_suppressed(contacts, c),
                                  .force = nb_contact_force(contacts, c)};
#define CAPTURE_FIELD(which, name, range) it.field[which] = contacts->kept[which] ? contacts->kept[which][c] : 0;
    NB_SAVED_FIELDS(CAPTURE_FIELD)
    if (!model->plan.dashpots) /* without dashpots the total force is not kept: it equals the force of the law */
      it.field[NB_TOTAL_NORMAL] = it.field[NB_NORMAL];
    it.field[NB_TOTAL_SHEAR] = contacts->force[c].shear;
    it.normal = capture_history(saved, &contacts->normal_history, model->laws.normal, c);
    it.shear = capture_history(saved, &contacts->shear_history, model->laws.shear, c);
    const bool loaded = it.force.x != 0 || it.force.y != 0; /* a checkpoint may have none of the fields below */
    if (it.field[NB_OVERLAP] > 0 || loaded || it.suppressed || it.normal.count || it.shear.count)
      saved->contacts[saved->contact_count++] = it;
  }
}

static bool allocate(struct nb_saved *saved, const struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  const size_t doubles = (size_t)(contacts->normal_history.doubles + contacts->shear_history.doubles);
  saved->materials = calloc(model->scene->material_count + 1, sizeof *saved->materials);
  saved->rules = calloc(model->properties.rule_count + 1, sizeof *saved->rules);
  saved->particles = calloc(model->particles.count + 1, sizeof *saved->particles);
  saved->walls = calloc(model->walls.count + 1, sizeof *saved->walls);
  saved->contacts = calloc(contacts->count + 1, sizeof *saved->contacts);
  saved->history = calloc(contacts->count * doubles + 1, sizeof *saved->history);
  return saved->materials && saved->rules && saved->particles && saved->walls && saved->contacts && saved->history;
}

static bool capture_affine(struct nb_saved *saved, const struct nb_model *model) {
  const struct nb_affine *affine = model->affine;
  const struct nb_particles *particles = &model->particles;
  saved->centre = affine->centre;
  for (int c = 0; c < NB_AFFINE_SOURCES; c++)
    saved->sources[c] = (struct nb_saved_affine){affine->requested[c], affine->rate[c], !(affine->separate[c] > 0),
                                                 affine->twice && c == NB_AFFINE_FREE};
  saved->imposed = calloc(particles->count + 1, sizeof *saved->imposed);
  if (!saved->imposed)
    return false;
  saved->imposed_count = particles->count;
  for (size_t k = 0; k < particles->count; k++) {
    const size_t i = (size_t)particles->slot[k];
    saved->imposed[k] = (struct nb_saved_imposed){(enum nb_affine_source)affine->source[i], particles->imposed[i]};
  }
  return true;
}

static bool capture_ring(struct nb_saved *saved, const struct nb_model *model) {
  const struct nb_boundary_state *boundary = model->boundary;
  const struct nb_ring *ring = &boundary->ring;
  saved->ring = (struct nb_saved_ring){.is = true,
                                       .held = ring->held,
                                       .pressing = model->particles.boundary_force != NULL,
                                       .radius = ring->radius,
                                       .shape = ring->shape,
                                       .stress = boundary->stress};
  saved->ring.members = calloc(ring->count + 1, sizeof *saved->ring.members);
  if (!saved->ring.members)
    return false;
  saved->ring.member_count = ring->count;
  for (size_t k = 0; k < ring->count; k++)
    saved->ring.members[k] = model->particles.number[ring->member[k]] - 1;
  return true;
}

static enum nb_status capture_loading(struct nb_saved *saved, const struct nb_model *model, struct nb_error *error) {
  saved->central = model->central;
  saved->rotates = model->rotates;
  if (model->cell)
    saved->cell = (struct nb_saved_cell){true, model->cell->h, model->cell->image_velocity};
  if ((model->affine && !capture_affine(saved, model)) ||
      (model->boundary && model->boundary->ring.exists && !capture_ring(saved, model)))
    return nb_error_memory(error);
  return NB_OK;
}

/* True if the page, or a page from which it starts, has `impact`. */
static bool has_impact(const struct nb_scene *scene) {
  return scene->impact.line > 0 || (scene->start.scene && has_impact(scene->start.scene));
}

enum nb_status nb_saved_capture(struct nb_saved *saved, const struct nb_model *model, struct nb_error *error) {
  const struct nb_scene *scene = model->scene;
  *saved = (struct nb_saved){
      .program = NB_VERSION,
      .cycle = model->cycle,
      .stage_cycle = model->stage_cycle,
      .time = model->time,
      .step = model->previous_step,
      .unitless = scene->unitless,
      .gravity = model->gravity,
      .impact = {has_impact(scene), model->impact_time},
      .pieces = (int)model->laws.pieces,
      .material_count = scene->material_count,
      .rule_count = model->properties.rule_count,
  };
  snprintf(saved->page, sizeof saved->page, "%s", scene->page ? scene->page->name : "-");
  snprintf(saved->stage, sizeof saved->stage, "%s", model->stage ? model->stage->name : "-");
  snprintf(saved->normal, sizeof saved->normal, "%s", model->laws.normal->name);
  snprintf(saved->shear, sizeof saved->shear, "%s", model->laws.shear->name);
  if (!allocate(saved, model))
    return nb_error_memory(error);
  memcpy(saved->materials, model->properties.materials, saved->material_count * sizeof *saved->materials);
  memcpy(saved->rules, model->properties.rules, saved->rule_count * sizeof *saved->rules);
  capture_particles(saved, model);
  capture_walls(saved, model);
  capture_contacts(saved, model);
  return capture_loading(saved, model, error);
}

/* ---- restore ---- */

static bool same_names(const struct nb_saved *saved, const struct nb_scene *scene) {
  bool same = saved->material_count == scene->material_count && saved->wall_count == scene->wall_count;
  for (size_t m = 0; same && m < saved->material_count; m++)
    same = strcmp(saved->materials[m].name, scene->materials[m].name) == 0;
  for (size_t w = 0; same && w < saved->wall_count; w++)
    same = strcmp(saved->walls[w].name, scene->walls[w].name) == 0;
  return same;
}

static bool same_particle(const struct nb_saved_particle *it, const struct nb_particle *particle,
                          bool removal_allowed) {
  const bool same_mobility =
      it->mobility == NB_REMOVED ? removal_allowed : (it->mobility == NB_FIXED) == particle->fixed;
  return same_mobility && it->radius == particle->radius && it->shape == particle->shape &&
         it->material == particle->material;
}

/* Number of stages up to the one at whose end the state was saved, or in which the checkpoint was saved. */
static size_t stages_of(const struct nb_saved *saved, const struct nb_scene *scene) {
  const long found = saved->store.part_count ? NB_FIND(scene->stages, scene->stage_count, saved->stage) : -1;
  return found < 0 ? scene->start.stages : (size_t)found + 1;
}

static bool same_laws(const struct nb_saved *saved, struct nb_active_laws laws) {
  return laws.normal && laws.shear && strcmp(laws.normal->name, saved->normal) == 0 &&
         strcmp(laws.shear->name, saved->shear) == 0 && (int)laws.pieces == saved->pieces;
}

static enum nb_status check_stage(const struct nb_saved *saved, const struct nb_scene *scene, const char *path,
                                  struct nb_error *error) {
  const size_t stages = stages_of(saved, scene);
  struct nb_active_laws laws = nb_laws_initial(scene);
  if (stages == 0 && saved->store.part_count > 0)
    return nb_error_set(error, NB_BAD_USE, "%.200s: expected a stage of the page, found `%s`", path, saved->stage);
  for (size_t s = 0; s < stages; s++)
    laws = nb_laws_of(&scene->stages[s], laws);
  return same_laws(saved, laws)
             ? NB_OK
             : nb_error_set(error, NB_BAD_USE, "%.200s: expected the laws of the page, found normal %s and shear %s",
                            path, saved->normal, saved->shear);
}

enum nb_status nb_saved_fits(const struct nb_saved *saved, const struct nb_scene *scene, const char *path,
                             struct nb_error *error) {
  size_t rules = scene->pair_rule_count, k = 0;
  bool removes = false;
  for (size_t s = 0; s < scene->stage_count; s++) {
    rules += scene->stages[s].change_count;
    removes = removes || scene->stages[s].removal_count > 0;
  }
  if (check_stage(saved, scene, path, error))
    return error->status;
  const bool named = same_names(saved, scene);
  while (k < saved->particle_count && k < scene->particle_count &&
         same_particle(&saved->particles[k], &scene->particles[k], removes))
    k++;
  if (saved->impact.is != has_impact(scene))
    return nb_error_set(error, NB_BAD_USE, "%.200s: expected the state of a page %s `impact`, found one %s", path,
                        has_impact(scene) ? "with" : "without", has_impact(scene) ? "without" : "with");
  if (named && saved->rule_count <= rules && k == scene->particle_count && k == saved->particle_count)
    return NB_OK;
  return nb_error_set(error, NB_BAD_USE,
                      "%.200s: expected the state of %zu particles, %zu walls and %zu materials%s, found another one",
                      path, scene->particle_count, scene->wall_count, scene->material_count,
                      named ? " like those of the page" : " with the names of the page");
}

static void restore_particles(struct nb_particles *particles, const struct nb_saved *saved) {
  for (size_t k = 0; k < particles->count; k++) {
    const struct nb_saved_particle *it = &saved->particles[k];
    const size_t i = (size_t)particles->slot[k];
    particles->position[i] = it->position, particles->velocity[i] = it->velocity;
    particles->radius[i] = it->radius, particles->surface_speed[i] = it->spin * it->radius;
    if (particles->spin)
      particles->spin[i] = it->spin, particles->angle[i] = it->angle;
    if (it->mobility == NB_REMOVED)
      particles->removed[i] = true, particles->inverse_mass[i] = particles->inverse_inertia[i] = 0;
  }
}

static void restore_walls(struct nb_walls *walls, const struct nb_saved *saved) {
  for (size_t w = 0; w < walls->count; w++) {
    const struct nb_saved_wall *it = &saved->walls[w];
#define RESTORE(member) walls->member[w] = it->member;
    WALL_MEMBERS(RESTORE)
#undef RESTORE
    walls->point[w] = vec_add(it->pivot, vec_scale(-it->h0, vec_clockwise(it->along)));
  }
}

/* Restores the last stage of the state, its laws, and which walls the stages up to it have removed. */
static void restore_stage(struct nb_model *model, size_t stages) {
  const struct nb_scene *scene = model->scene;
  for (size_t s = 0; s < stages; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    model->next_laws = nb_laws_of(stage, model->next_laws);
    for (size_t m = 0; m < stage->motion_count; m++)
      if (stage->motions[m].removed)
        model->walls.removed[stage->motions[m].wall] = true;
  }
  model->laws = model->next_laws;
  model->properties.pieces = model->laws.pieces;
  model->stage = &scene->stages[stages - 1];
  model->damping = model->stage->damping;
  /* for a stage of another page the line is not 0, because --set step applies only to stages of this page */
  model->stability->step_line = model->stage->step.line;
}

void nb_saved_restore(struct nb_model *model, const struct nb_saved *saved) {
  restore_stage(model, stages_of(saved, model->scene));
  restore_particles(&model->particles, saved);
  restore_walls(&model->walls, saved);
  memcpy(model->properties.materials, saved->materials, saved->material_count * sizeof *saved->materials);
  for (size_t r = 0; r < saved->rule_count; r++) /* not memcpy: without rules the array is NULL */
    model->properties.rules[r] = saved->rules[r];
  model->properties.rule_count = saved->rule_count;
  nb_properties_apply(model);
  model->gravity = saved->gravity;
  model->cycle = saved->cycle, model->stage_cycle = saved->stage_cycle;
  model->time = saved->time, model->impact_time = saved->impact.contact_time;
  model->critical = nb_step_single_contact(model);
  model->step = model->previous_step = saved->step;
}

static void restore_history(struct nb_history *history, size_t c, const double *values, struct nb_saved_history it) {
  const int n = it.count < history->doubles ? it.count : history->doubles;
  if (n > 0 && history->rows) /* without a history the array of values may be NULL */
    memcpy(history->rows + c * (size_t)history->doubles, values + it.at, (size_t)n * sizeof *values);
  for (int m = 0; m < n && !history->rows; m++)
    history->field[m][c] = values[it.at + (size_t)m];
}

static void restore_contact(struct nb_contacts *contacts, size_t c, const struct nb_saved_contact *it,
                            const double *history) {
  contacts->force[c] =
      (struct nb_contact_force){.x = it->force.x, .shear = it->field[NB_TOTAL_SHEAR], .y = it->force.y};
#define RESTORE(which, name, range)                                                                                    \
  if (contacts->kept[which])                                                                                           \
    contacts->kept[which][c] = it->field[which];
  NB_SAVED_FIELDS(RESTORE)
  if (contacts->kept[NB_SHEAR_BEFORE]) {
    contacts->kept[NB_SHEAR_BEFORE][c] = it->field[NB_SHEAR];
    contacts->kept[NB_SHEAR_STIFFNESS_BEFORE][c] = it->field[NB_SHEAR_STIFFNESS];
  }
  if (contacts->suppressed)
    contacts->suppressed[c] = it->suppressed;
  restore_history(&contacts->normal_history, c, history, it->normal);
  restore_history(&contacts->shear_history, c, history, it->shear);
}

enum nb_status nb_saved_restore_contacts(struct nb_model *model, const struct nb_saved *saved, struct nb_error *error) {
  for (size_t k = 0; k < saved->contact_count; k++) {
    const struct nb_saved_contact *it = &saved->contacts[k];
    const int *slot = model->particles.slot;
    const long c = nb_contacts_find(model, slot[it->a], it->wall ? it->b : slot[it->b], it->wall);
    if (c >= 0)
      restore_contact(&model->contacts, (size_t)c, it, saved->history);
    else if (it->field[NB_OVERLAP] > 0)
      return nb_error_set(error, NB_BAD_USE,
                          "the state has a contact of particle %d with %s %d, but these two do not touch", it->a + 1,
                          it->wall ? "wall" : "particle", it->b + 1);
  }
  return NB_OK;
}

static void restore_affine(struct nb_model *model, const struct nb_saved *saved) {
  struct nb_affine *affine = model->affine;
  struct nb_particles *particles = &model->particles;
  affine->centre = saved->centre;
  affine->free_before = affine->any_before = true; /* the state does not contain these two */
  for (int c = 0; c < NB_AFFINE_SOURCES; c++) {
    affine->requested[c] = saved->sources[c].requested;
    affine->rate[c] = saved->sources[c].rate;
    affine->separate[c] = saved->sources[c].accumulated ? 0 : 1;
  }
  affine->twice = saved->sources[NB_AFFINE_FREE].twice;
  for (size_t k = 0; k < saved->imposed_count; k++) {
    const size_t i = (size_t)particles->slot[k];
    nb_affine_assign(affine, i, saved->imposed[k].by);
    particles->imposed[i] = saved->imposed[k].along;
    if (affine->source[i] == NB_AFFINE_BOUNDARY)
      particles->inverse_mass[i] = particles->inverse_inertia[i] = 0;
  }
}

static void restore_ring(struct nb_model *model, const struct nb_saved_ring *saved) {
  struct nb_boundary_state *boundary = model->boundary;
  struct nb_ring *ring = &boundary->ring;
  ring->exists = true, ring->held = saved->held;
  ring->radius = saved->radius, ring->shape = saved->shape;
  ring->count = saved->member_count;
  for (size_t k = 0; k < ring->count; k++)
    ring->member[k] = model->particles.slot[saved->members[k]];
  boundary->stress = saved->stress;
  model->particles.boundary_force = saved->pressing ? boundary->boundary_force : NULL;
  if (model->particles.boundary_force)
    nb_boundary_set_forces(model);
}

/* True if the state fits the model. State and model must agree in whether there is a cell, and in whether particles
 * rotate. If the state has an imposed motion, a boundary or a stress on the boundary, the model must have it too. */
static bool same_loading(const struct nb_model *model, const struct nb_saved *saved) {
  enum nb_rotation rotation = NB_ROTATION_ON;
  for (const struct nb_stage *stage = model->scene->stages; stage <= model->stage; stage++)
    rotation = stage->rotation ? stage->rotation : rotation;
  if (saved->rotates != (rotation == NB_ROTATION_ON))
    return false;
  if (saved->imposed_count != 0 && (saved->imposed_count != model->particles.count || !model->affine))
    return false;
  return saved->cell.is == (model->cell != NULL) &&
         (model->boundary ? model->boundary->boundary_force || !saved->ring.pressing : !saved->ring.is);
}

enum nb_status nb_saved_restore_loading(struct nb_model *model, const struct nb_saved *saved, struct nb_error *error) {
  struct nb_particles *particles = &model->particles;
  if (!same_loading(model, saved))
    return nb_error_set(error, NB_BAD_USE,
                        "expected a state with the cell, the boundary, the imposed motion and the rotation of the "
                        "page, found another one");
  model->central = saved->central;
  if (saved->cell.is)
    model->cell->h = saved->cell.h, model->cell->image_velocity = saved->cell.image_velocity;
  if (saved->imposed_count > 0)
    restore_affine(model, saved);
  if (saved->ring.is)
    restore_ring(model, &saved->ring);
  model->rotates = saved->rotates;
  for (size_t i = 0; i < particles->count && !saved->rotates; i++)
    particles->inverse_inertia[i] = 0;
  return NB_OK;
}

/* ---- write ---- */

/* Reads the text of a state before it is written, so that every file can be read again. */
static enum nb_status check_text(const char *path, const char *text, size_t size, struct nb_error *error) {
  struct nb_saved again;
  const enum nb_status status = nb_saved_read_text(&again, path, text, size, error);
  nb_saved_free(&again);
  return status;
}

enum nb_status nb_saved_write(const struct nb_saved *saved, const char *path, struct nb_error *error) {
  struct nb_save file = {0};
  size_t size = 0;
  char *text = nb_saved_text(saved, &size);
  if (!text)
    return nb_error_memory(error);
  enum nb_status status = check_text(path, text, size, error);
  if (!status)
    status = nb_save_begin(&file, path, error);
  if (!status) {
    fwrite(text, 1, size, file.file); /* nb_save_end reports failures */
    status = nb_save_end(&file, error);
  }
  free(text);
  return status;
}
