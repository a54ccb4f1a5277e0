/* A saved state from a model, and into one.
 *
 * What is saved of a contact is what it has at t_N: its force and what its laws remember of it. Worked out anew they would be
 * something else, since a law has taken up the slip of the step behind already. So a model that goes on from a state lists what
 * is near, takes these over and begins with the motion; it comes to the very same bits as the one that was not interrupted.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "state.h"
#include "laws/laws_now.h"
#include "measure/step.h"

#include <stdlib.h>
#include <string.h>

#include "input/reader.h"

void nb_saved_free(struct nb_saved *saved) {
  free(saved->settings), free(saved->materials), free(saved->rules), free(saved->bodies), free(saved->walls);
  free(saved->contacts), free(saved->memory), free(saved->carried), free(saved->ring.members);
  *saved = (struct nb_saved){0};
}

enum nb_status nb_saved_setting(struct nb_saved *saved, const char *text, struct nb_error *error) {
  if (strlen(text) >= sizeof *saved->settings)
    return nb_error_set(error, NB_BAD_USE, "a state keeps settings shorter than %zu bytes, found `%.40s…`",
                        sizeof *saved->settings, text);
  void *more = nb_room(saved->settings, saved->setting_count, 1, sizeof *saved->settings);
  if (!more)
    return nb_error_memory(error);
  saved->settings = more;
  snprintf(saved->settings[saved->setting_count++], sizeof *saved->settings, "%s", text);
  return NB_OK;
}

/* ---- from a model ---- */

static void take_bodies(struct nb_saved *saved, const struct nb_model *model) {
  const struct nb_bodies *bodies = &model->bodies;
  for (size_t k = 0; k < bodies->count; k++) {
    const size_t i = (size_t)bodies->slot[k];
    const struct nb_body *body = &model->scene->bodies[k];
    saved->bodies[k] = (struct nb_saved_body){
        .shape = body->shape,
        .mobility = nb_gone(model, i) ? NB_GONE
                    : body->fixed     ? NB_FIXED
                                      : NB_FREE,
        .material = body->material,
        .radius = bodies->rim[i].x,
        .position = bodies->position[i],
        .velocity = bodies->velocity[i],
        .spin = bodies->spin ? bodies->spin[i] : 0,
        .angle = bodies->angle ? bodies->angle[i] : 0,
    };
  }
  saved->body_count = bodies->count;
}

static void take_walls(struct nb_saved *saved, const struct nb_model *model) {
  const struct nb_walls *walls = &model->walls;
  for (size_t w = 0; w < walls->count; w++) {
    struct nb_saved_wall *it = &saved->walls[w];
    *it = (struct nb_saved_wall){
        .material = model->scene->walls[w].material,
        .pivot = walls->pivot[w],
        .along = walls->along[w],
        .velocity = walls->velocity[w],
        .turn = walls->turn[w],
        .h0 = walls->h0[w],
        .h1 = walls->h1[w],
        .h2 = walls->h2[w],
        .spin = walls->spin[w],
        .angle = walls->angle[w],
    };
    memcpy(it->name, model->scene->walls[w].name, sizeof it->name);
  }
  saved->wall_count = walls->count;
}

/* What a law remembers of a contact, at the end of what is remembered so far; how many doubles, 0: nothing but zeros. */
static int take_memory(struct nb_saved *saved, const struct nb_memory *memory, const struct nb_law *law, size_t c,
                       size_t *at) {
  double room[NB_MEMORY], any = 0;
  const double *m = nb_memory_read(memory, c, room);
  *at = saved->memory_count;
  for (int k = 0; k < (memory->rows ? 1 : memory->doubles); k++)
    any = m[k] != 0 ? 1 : any;
  if (any == 0)
    return 0;
  const int used = law->used ? law->used(m) : memory->doubles;
  memcpy(saved->memory + saved->memory_count, m, (size_t)used * sizeof *m);
  saved->memory_count += (size_t)used;
  return used;
}

static void take_contacts(struct nb_saved *saved, const struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_bodies *bodies = &model->bodies;
  for (size_t c = 0; c < contacts->count; c++) {
    const bool wall = model->pairings[contacts->pairing[c]].wall;
    struct nb_saved_contact it = {.a = bodies->number[contacts->a[c]] - 1,
                                  .b = wall ? contacts->b[c] : bodies->number[contacts->b[c]] - 1,
                                  .wall = wall,
                                  .muted = contacts->muted && (contacts->muted[c] & 1),
                                  .force = contacts->force[c]};
#define TAKEN(which, name) it.field[which] = contacts->kept[which] ? contacts->kept[which][c] : 0;
    NB_SAVED_FIELDS(TAKEN)
    if (!model->plan.dashpots) /* what is felt is what the laws say */
      it.field[NB_PUSH] = it.field[NB_NORMAL], it.field[NB_DRAG] = it.field[NB_SHEAR];
    it.normal = take_memory(saved, &contacts->normal_memory, model->laws.normal, c, &it.normal_at);
    it.shear = take_memory(saved, &contacts->shear_memory, model->laws.shear, c, &it.shear_at);
    if (it.field[NB_OVERLAP] > 0 || it.muted || it.normal || it.shear)
      saved->contacts[saved->contact_count++] = it;
  }
}

static bool make_room(struct nb_saved *saved, const struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  const size_t remembered = (size_t)(contacts->normal_memory.doubles + contacts->shear_memory.doubles);
  saved->materials = calloc(model->scene->material_count + 1, sizeof *saved->materials);
  saved->rules = calloc(model->properties.rule_count + 1, sizeof *saved->rules);
  saved->bodies = calloc(model->bodies.count + 1, sizeof *saved->bodies);
  saved->walls = calloc(model->walls.count + 1, sizeof *saved->walls);
  saved->contacts = calloc(contacts->count + 1, sizeof *saved->contacts);
  saved->memory = calloc(contacts->count * remembered + 1, sizeof *saved->memory);
  return saved->materials && saved->rules && saved->bodies && saved->walls && saved->contacts && saved->memory;
}

enum nb_status nb_saved_take(struct nb_saved *saved, const struct nb_model *model, struct nb_error *error) {
  const struct nb_scene *scene = model->scene;
  *saved = (struct nb_saved){
      .program = NB_VERSION,
      .cycle = model->cycle,
      .stage_cycle = model->stage_cycle,
      .time = model->time,
      .step = model->previous_step,
      .unitless = scene->unitless,
      .gravity = model->gravity,
      .pieces = (int)model->laws.pieces,
      .material_count = scene->material_count,
      .rule_count = model->properties.rule_count,
  };
  snprintf(saved->page, sizeof saved->page, "%s", scene->page ? scene->page->name : "-");
  snprintf(saved->stage, sizeof saved->stage, "%s", model->stage ? model->stage->name : "-");
  snprintf(saved->normal, sizeof saved->normal, "%s", model->laws.normal->name);
  snprintf(saved->shear, sizeof saved->shear, "%s", model->laws.shear->name);
  if (!make_room(saved, model))
    return nb_error_memory(error);
  memcpy(saved->materials, model->properties.materials, saved->material_count * sizeof *saved->materials);
  memcpy(saved->rules, model->properties.rules, saved->rule_count * sizeof *saved->rules);
  take_bodies(saved, model);
  take_walls(saved, model);
  take_contacts(saved, model);
  return nb_saved_take_driven(saved, model, error);
}

/* ---- into a model ---- */

enum nb_status nb_saved_fits(const struct nb_saved *saved, const struct nb_scene *scene, const char *path,
                             struct nb_error *error) {
  size_t rules = scene->pair_rule_count, removals = 0;
  for (size_t s = 0; s < scene->stage_count; s++)
    rules += scene->stages[s].change_count, removals += scene->stages[s].removal_count;
  bool named = saved->material_count == scene->material_count && saved->wall_count == scene->wall_count;
  for (size_t m = 0; named && m < saved->material_count; m++)
    named = strcmp(saved->materials[m].name, scene->materials[m].name) == 0;
  for (size_t w = 0; named && w < saved->wall_count; w++)
    named = strcmp(saved->walls[w].name, scene->walls[w].name) == 0;
  size_t k = 0;
  while (k < saved->body_count && k < scene->body_count && saved->bodies[k].radius == scene->bodies[k].radius &&
         saved->bodies[k].shape == scene->bodies[k].shape && saved->bodies[k].material == scene->bodies[k].material &&
         (saved->bodies[k].mobility == NB_GONE ? removals > 0
                                               : (saved->bodies[k].mobility == NB_FIXED) == scene->bodies[k].fixed))
    k++;
  struct nb_in_force laws = nb_laws_at_start(scene);
  for (size_t s = 0; s < scene->start.stages; s++)
    laws = nb_laws_of(&scene->stages[s], laws);
  if (!laws.normal || !laws.shear || strcmp(laws.normal->name, saved->normal) != 0 ||
      strcmp(laws.shear->name, saved->shear) != 0 || (int)laws.pieces != saved->pieces)
    return nb_error_set(error, NB_BAD_USE, "%.200s: expected the laws of the page, found normal %s and shear %s", path,
                        saved->normal, saved->shear);
  if (named && saved->rule_count <= rules && k == scene->body_count && k == saved->body_count)
    return NB_OK;
  return nb_error_set(error, NB_BAD_USE,
                      "%.200s: expected the state of %zu bodies, %zu walls and %zu materials%s, "
                      "found another one",
                      path, scene->body_count, scene->wall_count, scene->material_count,
                      named ? " as the page has them" : " of the page's names");
}

static void put_bodies(struct nb_bodies *bodies, const struct nb_saved *saved) {
  for (size_t k = 0; k < bodies->count; k++) {
    const struct nb_saved_body *it = &saved->bodies[k];
    const size_t i = (size_t)bodies->slot[k];
    bodies->position[i] = it->position, bodies->velocity[i] = it->velocity;
    bodies->rim[i] = vec(it->radius, it->spin * it->radius);
    if (bodies->spin)
      bodies->spin[i] = it->spin, bodies->angle[i] = it->angle;
    if (it->mobility == NB_GONE)
      bodies->gone[i] = true, bodies->inverse_mass[i] = bodies->inverse_inertia[i] = 0;
  }
}

static void put_walls(struct nb_walls *walls, const struct nb_saved *saved) {
  for (size_t w = 0; w < walls->count; w++) {
    const struct nb_saved_wall *it = &saved->walls[w];
    walls->pivot[w] = it->pivot, walls->along[w] = it->along;
    walls->velocity[w] = it->velocity, walls->turn[w] = it->turn;
    walls->h0[w] = it->h0, walls->h1[w] = it->h1, walls->h2[w] = it->h2;
    walls->spin[w] = it->spin, walls->angle[w] = it->angle;
    walls->point[w] = vec_add(it->pivot, vec_scale(-it->h0, vec_clockwise(it->along)));
  }
}

/* What the stage that has ended was, and its laws. */
static void put_stage(struct nb_model *model) {
  const struct nb_scene *scene = model->scene;
  for (size_t s = 0; s < scene->start.stages; s++)
    model->coming = nb_laws_of(&scene->stages[s], model->coming);
  model->laws = model->coming;
  model->properties.pieces = model->laws.pieces;
  model->stage = &scene->stages[scene->start.stages - 1];
  model->damping = model->stage->damping;
  model->stability->step_line = model->stage->step.set ? 0 : model->stage->step.line;
}

void nb_saved_put(struct nb_model *model, const struct nb_saved *saved) {
  put_stage(model);
  put_bodies(&model->bodies, saved);
  put_walls(&model->walls, saved);
  memcpy(model->properties.materials, saved->materials, saved->material_count * sizeof *saved->materials);
  for (size_t r = 0; r < saved->rule_count; r++) /* there may be none, and no array */
    model->properties.rules[r] = saved->rules[r];
  model->properties.rule_count = saved->rule_count;
  for (size_t p = 0; p < model->pairing_count; p++)
    model->pairings[p].values = nb_properties_pair(&model->properties, model->pairings[p].a, model->pairings[p].b);
  model->gravity = saved->gravity;
  model->cycle = saved->cycle, model->stage_cycle = saved->stage_cycle;
  model->time = saved->time;
  model->step = model->previous_step = saved->step;
}

static void put_memory(struct nb_memory *memory, size_t c, const double *from, int doubles) {
  const int n = doubles < memory->doubles ? doubles : memory->doubles;
  if (n > 0 && memory->rows)
    memcpy(memory->rows + c * (size_t)memory->doubles, from, (size_t)n * sizeof *from);
  for (int m = 0; m < n && !memory->rows; m++)
    memory->field[m][c] = from[m];
}

static void put_contact(struct nb_contacts *contacts, size_t c, const struct nb_saved_contact *it,
                        const double *memory) {
  contacts->force[c] = it->force;
#define PUT(which, name)                                                                                               \
  if (contacts->kept[which])                                                                                           \
    contacts->kept[which][c] = it->field[which];
  NB_SAVED_FIELDS(PUT)
  if (contacts->kept[NB_SHEAR_BEFORE]) {
    contacts->kept[NB_SHEAR_BEFORE][c] = it->field[NB_SHEAR];
    contacts->kept[NB_SHEAR_STIFFNESS_BEFORE][c] = it->field[NB_SHEAR_STIFFNESS];
  }
  if (contacts->muted)
    contacts->muted[c] = it->muted;
  put_memory(&contacts->normal_memory, c, memory + it->normal_at, it->normal);
  put_memory(&contacts->shear_memory, c, memory + it->shear_at, it->shear);
}

enum nb_status nb_saved_put_contacts(struct nb_model *model, const struct nb_saved *saved, struct nb_error *error) {
  for (size_t k = 0; k < saved->contact_count; k++) {
    const struct nb_saved_contact *it = &saved->contacts[k];
    const int *slot = model->bodies.slot;
    const long c = nb_contacts_find(model, slot[it->a], it->wall ? it->b : slot[it->b], it->wall);
    if (c >= 0)
      put_contact(&model->contacts, (size_t)c, it, saved->memory);
    else if (it->field[NB_OVERLAP] > 0)
      return nb_error_set(error, NB_BAD_USE, "the state has a contact of body %d with %s %d, which are apart in it",
                          it->a + 1, it->wall ? "wall" : "body", it->b + 1);
  }
  return NB_OK;
}
