/* What a stage takes out of the scene: `remove disc N`, `remove discs N to M`, and the same of spheres.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "scene.h"

/* The line that takes out a body of that range already, and which; 0: none. */
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

/* The first body of that range that is of another shape; past its end: none. */
static size_t misnamed(const struct nb_scene *scene, struct nb_removal removal, enum nb_shape shape) {
  size_t k = removal.from;
  while (k <= removal.to && scene->bodies[k].shape == shape)
    k++;
  return k;
}

/* `disc N`: one word of four, and the numbers of the first body and the last one; false with a message. */
static bool take_range(const struct nb_scene_reading *reading, struct nb_reader *reader, enum nb_shape *shape,
                       struct nb_removal *removal) {
  const size_t count = reading->scene->body_count;
  const unsigned long most = reading->bodies_unsure || !count ? NB_BODIES_MAX : count;
  const bool disc = nb_token_is(reader, "disc"), discs = nb_token_is(reader, "discs");
  const bool sphere = nb_token_is(reader, "sphere"), spheres = nb_token_is(reader, "spheres");
  unsigned long from, to;
  if (!disc && !discs && !sphere && !spheres) {
    nb_expected(reader, NULL, "`disc N`, `discs N to M`, `sphere N` or `spheres N to M`");
    return false;
  }
  reader->next++;
  if (!nb_take_count(reader, 1, most, &from))
    return false;
  to = from;
  if ((discs || spheres) && !(nb_take_word(reader, "to") && nb_take_count(reader, from, most, &to)))
    return false;
  *shape = disc || discs ? NB_DISC : NB_SPHERE;
  *removal = (struct nb_removal){from - 1, to - 1, (int)reader->line};
  return !reader->bad && !reading->bodies_unsure && count > 0;
}

NB_APPLY(nb_apply_remove) {
  static const char *const names[] = {[NB_DISC] = "disc", [NB_SPHERE] = "sphere"};
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  struct nb_stage *stage = nb_stage_now(scene);
  struct nb_removal removal;
  enum nb_shape shape;
  size_t which, all = 0;
  (void)record;
  if (!stage || !take_range(reading, reader, &shape, &removal))
    return;
  for (size_t s = 0; s < scene->stage_count; s++)
    all += scene->stages[s].removal_count;
  const int line = removed_already(scene, removal, &which);
  const size_t other = misnamed(scene, removal, shape);
  if (nb_too_many(reader, all, NB_NAMED_MAX, "statements `remove`"))
    return;
  if (other <= removal.to) {
    nb_token_mistake(reader, &reader->tokens[1], NULL, "expected a %s of each number, but body %zu is a %s",
                     names[shape], other + 1, names[scene->bodies[other].shape]);
    return;
  }
  if (line) {
    nb_token_mistake(reader, &reader->tokens[1], NULL, "body %zu is taken out already, by line %d", which + 1, line);
    return;
  }
  struct nb_removal *removals = nb_room(stage->removals, stage->removal_count, 1, sizeof *removals);
  if (!removals) {
    nb_no_memory(reader);
    return;
  }
  stage->removals = removals;
  removals[stage->removal_count++] = removal;
}
