/* What a stage removes: `remove disc N`, `remove discs N to M`, the same for spheres, and `remove wall NAME` (wall.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */

#include "statement.h"

static const struct nb_argument no_fields[] = {END};

/* The line that already removes a particle of the range; *which is that particle. 0: there is no such line. */
static int removed_already(const struct nb_scene *scene, struct nb_removal removal, size_t *which) {
  for (size_t s = 0; s < scene->stage_count; s++)
    for (size_t k = 0; k < scene->stages[s].removal_count; k++) {
      const struct nb_removal *other = &scene->stages[s].removals[k];
      *which = other->from > removal.from ? other->from : removal.from;
      if (*which <= other->to && *which <= removal.to)
        return other->line;
    }
  return 0;
}

/* The first particle of the range with another shape than `shape`; a value after the end of the range: there is
 * none. */
static size_t first_other_shape(const struct nb_scene *scene, struct nb_removal removal, enum nb_shape shape) {
  size_t k = removal.from;
  while (k <= removal.to && scene->particles[k].shape == shape)
    k++;
  return k;
}

/* Takes `disc`, `discs`, `sphere` or `spheres`, and the numbers of the first and the last particle. */
static struct nb_removal take_range(const struct nb_scene_reading *reading, struct nb_reader *reader,
                                    enum nb_shape *shape) {
  static const char *const words[] = {"disc", "discs", "sphere", "spheres"};
  const size_t count = reading->scene->particle_count;
  const bool incomplete = nb_particles_incomplete(reading);
  const unsigned long most = incomplete || !count ? NB_PARTICLES_MAX : count;
  unsigned long from, to;
  const struct nb_token *const token = nb_token_peek(reader);
  char hint[NB_HINT_SIZE] = "";
  int word = 0;
  while (word < 4 && !nb_token_skip(reader, words[word]))
    word++;
  if (word == 4 && token && NB_FIND(reading->scene->walls, reading->scene->wall_count, token->text) >= 0)
    snprintf(hint, NB_HINT_SIZE, "write `remove wall %s`", token->text);
  if (word == 4)
    nb_expected(reader, *hint ? hint : NULL, "`disc N`, `discs N to M`, `sphere N`, `spheres N to M` or `wall NAME`");
  nb_take_count(reader, 1, most, &from);
  to = from;
  if (word % 2 && nb_take_word(reader, "to"))
    nb_take_count(reader, from, most, &to);
  if (incomplete || count == 0)
    nb_fail_silently(reader);
  *shape = word < 2 ? NB_DISC : NB_SPHERE;
  return (struct nb_removal){from - 1, to - 1, (int)reader->line};
}

NB_APPLY(apply_remove) {
  static const char *const names[] = {[NB_DISC] = "disc", [NB_SPHERE] = "sphere"};
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  struct nb_stage *stage = nb_current_stage(scene);
  enum nb_shape shape;
  size_t which, all = 0;
  if (nb_token_skip(reader, "wall")) {
    const struct nb_token *const name = nb_token_peek(reader);
    if (!name)
      nb_expected(reader, "for example `remove wall east`", "the name of a wall");
    else if (nb_take_name(reader, "the name of a wall"))
      nb_wall_remove(reading, reader, name);
    return;
  }
  const struct nb_removal removal = take_range(reading, reader, &shape);
  for (size_t s = 0; s < scene->stage_count; s++)
    all += scene->stages[s].removal_count;
  if (reader->bad || nb_too_many(reader, all, NB_NAMED_MAX, "statements `remove`"))
    return;
  const int line = removed_already(scene, removal, &which);
  const size_t other = first_other_shape(scene, removal, shape);
  if (other <= removal.to)
    nb_token_mistake(reader, &reader->tokens[1], "`remove disc N` removes a disc, `remove sphere N` a sphere",
                     "expected only numbers of %ss, but particle %zu is a %s", names[shape], other + 1,
                     names[scene->particles[other].shape]);
  else if (line)
    nb_token_mistake(reader, &reader->tokens[1], NULL, "particle %zu is removed already, on line %d", which + 1, line);
  else
    NB_APPEND(reader, stage->removals, stage->removal_count, removal);
}

/* clang-format off */
NB_STATEMENTS(remove) = {
  {"remove", NB_IN_STAGE, no_fields, "disc N | discs N to M | wall NAME", 0, false, apply_remove,
   "Removes particles or a wall, and their energy, at the beginning of this stage. Removed particles no longer move or touch anything, and no snapshot shows them; the others keep their numbers. A removed particle keeps its last position and angle; its other quantities, and those of its contacts, are 0. A removed wall keeps its last position and angle; no later line can move it.\n"
   "disc N: the disc with this number; `sphere N` for a sphere.\n"
   "discs N to M: the discs with the numbers N to M; `spheres N to M` for spheres.\n"
   "wall NAME: the wall with this name, such as `east` of a box.",
   "stage     less\n  remove  disc 8\n  cycles  10"},
  {0},
};
/* clang-format on */
