/* What there is, second half: bodies, alone and in lattices, and what is watched.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "packing/packing.h"
#include "scene.h"

bool nb_too_many_bodies(struct nb_reader *reader, const struct nb_scene *scene, size_t more) {
  if (more <= NB_BODIES_MAX && scene->body_count + more <= NB_BODIES_MAX)
    return false;
  nb_token_mistake(reader, &reader->tokens[0], NULL, "expected at most %d bodies, with these there are %zu",
                   NB_BODIES_MAX, scene->body_count + more);
  return true;
}

bool nb_body_of(struct nb_body *body, const struct nb_scene *scene, struct nb_reader *reader,
                const struct nb_record *record, size_t count) {
  const struct nb_value *value = record->value;
  const struct nb_token *token = value[AT_MATERIAL].token;
  if (reader->bad)
    return false;
  int material = nb_material_of(scene, reader, token);
  if (material < 0)
    return false;
  *body = (struct nb_body){
      .shape = (enum nb_shape)record->keyword->variant,
      .x = value[AT_X].number,
      .y = value[AT_Y].number,
      .radius = value[AT_RADIUS].number,
      .vx = value[AT_VX].number,
      .vy = value[AT_VY].number,
      .spin = value[AT_SPIN].number,
      .material = material,
      .fixed = value[AT_FIXED].token != NULL,
      .line = (int)reader->line,
  };
  if (scene->materials[material].density == 0 && !body->fixed)
    nb_not_known(reader, token, "give the material a `density`, or hold the body with `fixed`",
                 "a material with mass for a free body");
  return !nb_too_many_bodies(reader, scene, count) && !reader->bad;
}

NB_APPLY(nb_apply_body) {
  struct nb_scene_reading *reading = subject;
  struct nb_lattice one = {1, 1, record->value[AT_X].number, record->value[AT_Y].number, 0, false};
  struct nb_body body;
  bool whole = nb_body_of(&body, reading->scene, reader, record, 1);
  if (whole && !nb_fill_lattice(reading->scene, one, body))
    nb_no_memory(reader);
  reading->bodies_unsure = reading->bodies_unsure || reader->bad;
}

NB_APPLY(nb_apply_lattice) {
  struct nb_scene_reading *reading = subject;
  const struct nb_value *value = record->value;
  double radius = value[AT_RADIUS].number;
  bool from = value[AT_X].token != NULL, spaced = value[AT_SPACING].token != NULL;
  struct nb_lattice lattice = {
      .nx = (size_t)value[AT_NX].number,
      .ny = (size_t)value[AT_NY].number,
      .x = from ? value[AT_X].number : radius,
      .y = from ? value[AT_Y].number : radius,
      .spacing = spaced ? value[AT_SPACING].number : 2 * radius,
      .hexagonal = value[AT_HEXAGONAL].token != NULL,
  };
  struct nb_body body;
  bool whole = nb_body_of(&body, reading->scene, reader, record, lattice.nx * lattice.ny);
  double far_x = lattice.x + lattice.spacing * (double)lattice.nx,
         far_y = lattice.y + lattice.spacing * (double)lattice.ny;
  if (value[AT_HEXAGONAL].token && value[AT_SQUARE].token)
    nb_token_mistake(reader, value[AT_HEXAGONAL].token, NULL, "expected `square` or `hexagonal`, not both");
  else if (whole && !(isfinite(far_x) && isfinite(far_y)))
    nb_token_mistake(reader, &reader->tokens[0], NULL,
                     "expected a lattice that a double can hold, this one is too large");
  else if (whole && !nb_fill_lattice(reading->scene, lattice, body))
    nb_no_memory(reader);
  reading->bodies_unsure = reading->bodies_unsure || reader->bad;
}

/* `disc N`: index of the body; -1 with a message. */
static int take_numbered(const struct nb_scene_reading *reading, struct nb_reader *reader, const char *what) {
  const struct nb_scene *scene = reading->scene;
  const struct nb_token *word = nb_token_peek(reader);
  unsigned long number = 0;
  bool disc = nb_token_skip(reader, "disc");
  if (!disc && !nb_token_skip(reader, "sphere")) {
    nb_expected(reader, NULL, "%s", what);
    return -1;
  }
  if (!nb_take_count(reader, 1, reading->bodies_unsure || !scene->body_count ? NB_BODIES_MAX : scene->body_count,
                     &number))
    return -1;
  if (reading->bodies_unsure || reader->bad)
    return -1;
  if (scene->body_count == 0) {
    nb_token_mistake(reader, word, NULL, "expected a body that is defined above, found none yet");
    return -1;
  }
  bool is_disc = scene->bodies[number - 1].shape == NB_DISC;
  if (is_disc == disc)
    return (int)number - 1;
  nb_token_mistake(reader, word, NULL, "expected `%s`, as body %lu is one, found `%s`", is_disc ? "disc" : "sphere",
                   number, word->text);
  return -1;
}

static int take_wall(const struct nb_scene *scene, struct nb_reader *reader) {
  const struct nb_token *name = nb_take(reader, "the name of a wall");
  return name && !name->hollow ? nb_wall_of(scene, reader, name) : -1;
}

bool nb_watch_add(struct nb_scene_reading *reading, struct nb_reader *reader, const struct nb_token *name,
                  struct nb_watch watch) {
  struct nb_scene *scene = reading->scene;
  watch.line = (int)reader->line;
  for (size_t i = 0; i < scene->watch_count; i++)
    if (strcmp(scene->watches[i].name, name->text) == 0) {
      nb_token_mistake(reader, name, NULL, "there is a watch `%s` already, on line %d", name->text,
                       scene->watches[i].line);
      return false;
    }
  if (nb_too_many(reader, scene->watch_count, NB_NAMED_MAX, "watches"))
    return false;
  struct nb_watch *watches = nb_room(scene->watches, scene->watch_count, 1, sizeof *watches);
  if (!watches) {
    nb_no_memory(reader);
    return false;
  }
  scene->watches = watches;
  if (reader->bad || reading->bodies_unsure)
    watch.a = -1; /* which says: nothing can be said of its quantities */
  snprintf(watch.name, sizeof watch.name, "%s", name->text);
  watches[scene->watch_count++] = watch;
  return true;
}

NB_APPLY(nb_apply_watch) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  const struct nb_token *name = record->value[AT_NAME].token;
  struct nb_watch watch = {.a = -1, .b = -1};
  if (!name)
    return;
  if (nb_token_skip(reader, "grading")) {
    watch.a = nb_take_grading(scene, reader, &watch.b);
    watch.kind = watch.b < 0 ? NB_WATCH_GRADING : NB_WATCH_SIZE;
  } else if (nb_token_skip(reader, "wall")) {
    watch.kind = NB_WATCH_WALL;
    watch.a = take_wall(scene, reader);
  } else {
    watch.a = take_numbered(reading, reader, "`disc N`, `sphere N`, `wall NAME` or `grading NAME`");
    if (!reader->bad && nb_token_peek(reader) && nb_take_word(reader, "with")) {
      bool wall = nb_token_skip(reader, "wall");
      watch.kind = wall ? NB_WATCH_BODY_WALL : NB_WATCH_BODY_BODY;
      watch.b = wall ? take_wall(scene, reader) : take_numbered(reading, reader, "`disc N`, `sphere N` or `wall NAME`");
      if (!wall && !reader->bad && watch.a == watch.b && watch.a >= 0)
        nb_token_mistake(reader, &reader->tokens[reader->count - 1], NULL,
                         "expected two bodies, found the same one twice");
    }
  }
  nb_watch_add(reading, reader, name, watch);
}
