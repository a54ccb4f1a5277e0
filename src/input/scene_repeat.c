/* Stages or legs once more: `repeat from NAME N times`. Their lines are read again, as if they stood there so often, and what they
 * begin is called NAME-2, NAME-3, …
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "scene.h"

void nb_stage_name(struct nb_stage *stage, const struct nb_scene_reading *reading, const struct nb_token *name) {
  char number[24] = "";
  if (reading->repeat.now)
    snprintf(number, sizeof number, "-%lu", reading->repeat.now);
  const size_t most = sizeof stage->name - 1 - strlen(number), length = strlen(name->text);
  snprintf(stage->name, sizeof stage->name, "%.*s%s", (int)(length < most ? length : most), name->text, number);
}

bool nb_repeat_closed(struct nb_scene_reading *reading) {
  struct nb_reader *reader = &reading->reader;
  const struct nb_scene *scene = reading->scene;
  const char *begins = scene->path ? "leg" : "stage", *verb = reader->tokens[0].text;
  if (reading->repeat.now || reading->repeat.until == 0 || strcmp(verb, begins) == 0 || strcmp(verb, "repeat") == 0 ||
      (size_t)nb_stage_now(scene)->line > reading->repeat.until)
    return false;
  nb_token_mistake(reader, &reader->tokens[0],
                   "above the `repeat` it is said of all of them, here of the last one only",
                   "expected `%s` below the `repeat` of line %zu", begins, reading->repeat.until);
  return true;
}

NB_APPLY(nb_apply_repeat) {
  struct nb_scene_reading *reading = subject;
  const struct nb_scene *scene = reading->scene;
  const char *what = scene->path ? "the name of a leg above" : "the name of a stage above";
  unsigned long times;
  char hint[NB_HINT_SIZE];
  (void)record;
  if (!nb_take_word(reader, "from"))
    return;
  const struct nb_token *token = nb_take(reader, scene->path ? "the name of a leg" : "the name of a stage");
  if (!token || token->hollow || nb_stage_not_here(scene, reader, token))
    return;
  struct nb_guess guess = nb_guess_begin(token->text);
  size_t s = scene->start.stages;
  for (; s < scene->stage_count && strcmp(scene->stages[s].name, token->text) != 0; s++)
    nb_guess_offer(&guess, scene->stages[s].name);
  if (s == scene->stage_count)
    nb_not_known(reader, token, nb_guess_hint(&guess, hint), what);
  else if ((size_t)scene->stages[s].line < reading->repeat.until)
    nb_token_mistake(reader, token, NULL, "expected %s that stands below the last `repeat`, on line %zu",
                     scene->path ? "a leg" : "a stage", reading->repeat.until);
  else if (nb_take_count(reader, 1, NB_NAMED_MAX, &times) &&
           (nb_token_skip(reader, "time") || nb_take_word(reader, "times")))
    reading->repeat = (struct nb_repeat){.from = (size_t)scene->stages[s].line, .times = times, .until = reader->line};
}
