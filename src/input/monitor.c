/* Monitors: `monitor`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */

#include "statement.h"

enum { AT_NAME };
static const struct nb_argument monitor_fields[] = {NAME(AT_NAME, "a name for what is monitored"), END};

/* Takes `disc N` or `sphere N`. Returns the index of the particle; -1 with a message, or without one if numbers of
 * particles cannot be checked. */
static int take_numbered(const struct nb_scene_reading *reading, struct nb_reader *reader, const char *what) {
  const struct nb_scene *scene = reading->scene;
  const struct nb_token *word = nb_token_peek(reader);
  const bool disc = nb_token_skip(reader, "disc"), incomplete = nb_particles_incomplete(reading);
  unsigned long number = 0;
  if (!disc && !nb_token_skip(reader, "sphere"))
    nb_expected(reader, NULL, "%s", what);
  nb_take_count(reader, 1, incomplete || !scene->particle_count ? NB_PARTICLES_MAX : scene->particle_count, &number);
  if (scene->particle_count == 0 && !incomplete)
    nb_token_mistake(reader, word, "write this line below the particles",
                     "expected a particle that is defined above, found none");
  if (reader->bad || incomplete)
    return -1;
  const bool is_disc = scene->particles[number - 1].shape == NB_DISC;
  if (is_disc != disc)
    nb_token_mistake(reader, word, NULL, "expected `%s`, because particle %lu is one, found `%s`",
                     is_disc ? "disc" : "sphere", number, word->text);
  return (int)number - 1;
}

static int take_wall(const struct nb_scene *scene, struct nb_reader *reader) {
  return nb_wall_of(scene, reader, nb_take_token(reader, "the name of a wall"));
}

bool nb_monitor_add(struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *name,
                    struct nb_monitor one) {
  const int same = NB_FIND(scene->monitors, scene->monitor_count, name->text);
  one.line = (int)reader->line;
  const bool region = same >= 0 && scene->monitors[same].kind == NB_MONITOR_REGION;
  if (nb_exists(reader, name, region ? "region" : "monitor", same < 0 ? 0 : scene->monitors[same].line) ||
      nb_too_many(reader, scene->monitor_count, NB_NAMED_MAX, "monitors"))
    return false;
  snprintf(one.name, sizeof one.name, "%s", name->text);
  return NB_APPEND(reader, scene->monitors, scene->monitor_count, one);
}

/* Takes the word between the two objects of a contact: `disc 5 with wall south`. */
static bool take_with(struct nb_reader *reader) {
  const bool forgotten = nb_token_is(reader, "disc") || nb_token_is(reader, "sphere") || nb_token_is(reader, "wall");
  return nb_token_skip(reader, "with") ||
         nb_expected(reader,
                     forgotten ? "write `with` between the two partners of the contact: `disc 1 with wall south`"
                               : "write `with` between the two partners of the contact: `disc 1 with disc 2`",
                     "`with`");
}

/* Warns of a contact that never has a force: a `fixed` particle has none with a wall or another fixed particle. */
static void warn_of_fixed(struct nb_scene *scene, const struct nb_monitor *one, int line) {
  const bool wall = one->kind == NB_MONITOR_PARTICLE_WALL;
  if ((wall || one->kind == NB_MONITOR_PARTICLE_PARTICLE) && scene->particles[one->a].fixed &&
      (wall || scene->particles[one->b].fixed))
    nb_warn(&scene->warnings, line, "this contact has no force: a `fixed` particle has no contact with %s",
            wall ? "a wall" : "another fixed one");
}

NB_APPLY(apply_monitor) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  struct nb_monitor one = {.b = -1};
  if (nb_token_skip(reader, "grading")) {
    one.a = nb_take_grading(scene, reader, &one.b);
    one.kind = one.b < 0 ? NB_MONITOR_GRADING : NB_MONITOR_SIZE;
  } else if (nb_token_skip(reader, "wall")) {
    one.kind = NB_MONITOR_WALL;
    one.a = take_wall(scene, reader);
  } else {
    one.a = take_numbered(reading, reader, "`disc N`, `sphere N`, `wall NAME` or `grading NAME`");
    if (nb_token_peek(reader) && take_with(reader)) {
      const bool wall = nb_token_skip(reader, "wall");
      one.kind = wall ? NB_MONITOR_PARTICLE_WALL : NB_MONITOR_PARTICLE_PARTICLE;
      one.b = wall ? take_wall(scene, reader) : take_numbered(reading, reader, "`disc N`, `sphere N` or `wall NAME`");
      if (!wall && one.a == one.b && one.a >= 0)
        nb_token_mistake(reader, &reader->tokens[reader->count - 1], NULL,
                         "expected two different particles, found the same one twice");
    }
  }
  if (nb_token_peek(reader)) /* nb_statement_read reports the token */
    return;
  if (one.a < 0)
    nb_fail_silently(reader);
  if (!reader->bad && nb_monitor_add(scene, reader, record->value[AT_NAME].token, one))
    warn_of_fixed(scene, &one, (int)reader->line);
}

/* clang-format off */
NB_STATEMENTS(monitor) = {
  {"monitor", NB_IN_SCENE | NB_IN_START, monitor_fields,
   "disc N | disc N with disc M | disc N with wall NAME | wall NAME | grading NAME {radius R}", 0, false, apply_monitor,
   "Names a particle, a contact, a wall, a grading or one size of a grading, so that its quantities can be recorded: `C.normal`.\n"
   "disc N: the particle with this number, a disc; `sphere N` for a sphere. Particles are numbered from 1, discs and spheres together, in the order of the statements that add them.\n"
   "disc N with disc M: the contact of two particles, whether they touch or not; likewise for spheres.\n"
   "disc N with wall NAME: the contact of a particle with a wall; likewise for spheres.\n"
   "wall NAME: a wall.\n"
   "grading NAME: a grading; with `radius R`, a length, the size with this radius.",
   "monitor   A  disc 1\nmonitor   C  disc 1 with sphere 2\nmonitor   F  sphere 9 with wall shelf\nmonitor   S  wall shelf\nmonitor   G  grading mixed\nmonitor   H  grading mixed radius 5 mm"},
  {0},
};
/* clang-format on */
