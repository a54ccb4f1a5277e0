/* What is looked at under a name of its own: `monitor`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "statement.h"

enum { AT_NAME };
static const struct nb_argument watch_fields[] = {NAME(AT_NAME, "a name for what is monitored"), END};

/* `disc N`: index of the body; -1 with a message. */
static int take_numbered(const struct nb_scene_reading *reading, struct nb_reader *reader, const char *what) {
  const struct nb_scene *scene = reading->scene;
  const struct nb_token *word = nb_token_peek(reader);
  const bool disc = nb_token_skip(reader, "disc"), unsure = nb_bodies_unsure(reading);
  unsigned long number = 0;
  if (!disc && !nb_token_skip(reader, "sphere"))
    nb_expected(reader, NULL, "%s", what);
  nb_take_count(reader, 1, unsure || !scene->body_count ? NB_BODIES_MAX : scene->body_count, &number);
  if (scene->body_count == 0 && !unsure)
    nb_token_mistake(reader, word, NULL, "expected a body that is defined above, found none yet");
  if (reader->bad || unsure)
    return -1;
  const bool is_disc = scene->bodies[number - 1].shape == NB_DISC;
  if (is_disc != disc)
    nb_token_mistake(reader, word, NULL, "expected `%s`, as body %lu is one, found `%s`", is_disc ? "disc" : "sphere",
                     number, word->text);
  return (int)number - 1;
}

static int take_wall(const struct nb_scene *scene, struct nb_reader *reader) {
  return nb_wall_of(scene, reader, nb_take(reader, "the name of a wall"));
}

bool nb_watch_add(struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *name, struct nb_watch one) {
  const int same = NB_FIND(scene->watches, scene->watch_count, name->text);
  one.line = (int)reader->line;
  if (nb_exists(reader, name, "monitor", same < 0 ? 0 : scene->watches[same].line) ||
      nb_too_many(reader, scene->watch_count, NB_NAMED_MAX, "monitors"))
    return false;
  snprintf(one.name, sizeof one.name, "%s", name->text);
  return NB_APPEND(reader, scene->watches, scene->watch_count, one);
}

NB_APPLY(apply_watch) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  struct nb_watch one = {.a = -1, .b = -1};
  if (nb_token_skip(reader, "grading")) {
    one.a = nb_take_grading(scene, reader, &one.b);
    one.kind = one.b < 0 ? NB_WATCH_GRADING : NB_WATCH_SIZE;
  } else if (nb_token_skip(reader, "wall")) {
    one.kind = NB_WATCH_WALL;
    one.a = take_wall(scene, reader);
  } else {
    one.a = take_numbered(reading, reader, "`disc N`, `sphere N`, `wall NAME` or `grading NAME`");
    if (nb_token_peek(reader) && nb_take_word(reader, "with")) {
      const bool wall = nb_token_skip(reader, "wall");
      one.kind = wall ? NB_WATCH_BODY_WALL : NB_WATCH_BODY_BODY;
      one.b = wall ? take_wall(scene, reader) : take_numbered(reading, reader, "`disc N`, `sphere N` or `wall NAME`");
      if (!wall && one.a == one.b && one.a >= 0)
        nb_token_mistake(reader, &reader->tokens[reader->count - 1], NULL,
                         "expected two bodies, found the same one twice");
    }
  }
  if (nb_token_peek(reader)) /* which the engine says */
    return;
  if (one.a < 0)
    nb_silent(reader);
  if (!reader->bad)
    nb_watch_add(scene, reader, record->value[AT_NAME].token, one);
}

/* clang-format off */
NB_STATEMENTS(watch) = {
  {"monitor", NB_IN_SCENE | NB_IN_START, watch_fields,
   "disc N | disc N with disc M | disc N with wall NAME | wall NAME | grading NAME {radius R}", 0, false, apply_watch,
   "Names a body, a contact, a wall, or a grading or one size of it, so that its quantities can be asked for: `C.normal`. Spheres are `sphere N`.",
   "monitor   A  disc 1\nmonitor   C  disc 1 with sphere 2\nmonitor   F  sphere 9 with wall shelf\nmonitor   S  wall shelf\nmonitor   G  grading mixed\nmonitor   H  grading mixed radius 5 mm"},
  {0},
};
/* clang-format on */
