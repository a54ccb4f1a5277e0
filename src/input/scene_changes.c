/* What a stage changes besides walls: materials and pairs, gravity, `still`; and `ramp` before what shall come gradually.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "scene.h"

/* In the scene and in a stage. */
NB_APPLY(nb_apply_gravity) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  struct nb_stage *stage = nb_stage_now(scene);
  struct nb_gravity *gravity = stage ? &stage->gravity : &scene->gravity;
  if (gravity->line) {
    nb_token_mistake(reader, &reader->tokens[0], NULL, "`gravity` is said twice: first on line %d", gravity->line);
    return;
  }
  const struct nb_value *value = record->value;
  if (record->keyword->variant)
    *gravity = (struct nb_gravity){
        .inward = value[AT_SPEED].number, .about_x = value[AT_X].number, .about_y = value[AT_Y].number};
  else
    *gravity = (struct nb_gravity){.x = value[AT_X].number, .y = value[AT_Y].number};
  gravity->line = (int)reader->line;
}

/* Do two changes say one property? */
static bool overlap(const struct nb_change *a, const struct nb_change *b) {
  bool both = false;
#define ROW(name, ...) both = both || (!isnan(a->name) && !isnan(b->name));
  NB_PAIR_ROWS(ROW)
#undef ROW
  return both;
}

/* The change of the same thing that this stage makes already; NULL: none. */
static const struct nb_change *changed_already(const struct nb_stage *stage, const struct nb_change *change) {
  for (size_t i = 0; i < stage->change_count; i++) {
    const struct nb_change *other = &stage->changes[i];
    const bool same = other->a == change->a && other->b == change->b;
    const bool swapped = change->b >= 0 && other->a == change->b && other->b == change->a;
    if ((same || swapped) && overlap(other, change))
      return other;
  }
  return NULL;
}

static double said(const struct nb_value *value) { return value->token ? value->number : NAN; }

/* `material` and, as variant 1, `pair` in a stage. */
NB_APPLY(nb_apply_change) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  struct nb_stage *stage = nb_stage_now(scene);
  const struct nb_value *value = record->value;
  struct nb_change change = {
      .a = nb_material_of(scene, reader, value[AT_NAME].token),
      .b = -1,
#define ROW(name, ...) .name = said(&value[AT_##name]),
      NB_PAIR_ROWS(ROW)
#undef ROW
          .line = (int)reader->line,
  };
  if (record->keyword->variant && !reader->bad)
    change.b = nb_material_of(scene, reader, value[AT_NAME2].token);
  if (reader->bad || !stage)
    return;
  if (!overlap(&change, &change)) {
#define ROW(name, shown, ...) " `" #name " " shown "`"
    nb_expected(reader, NULL, "what changes, one of" NB_PAIR_ROWS(ROW));
#undef ROW
    return;
  }
  const struct nb_change *other = changed_already(stage, &change);
  if (other) {
    nb_token_mistake(reader, &reader->tokens[0], NULL, "this stage changes that already, on line %d", other->line);
    return;
  }
  struct nb_change *changes = nb_room(stage->changes, stage->change_count, 1, sizeof *changes);
  if (!changes) {
    nb_no_memory(reader);
    return;
  }
  stage->changes = changes;
  changes[stage->change_count++] = change;
}

NB_APPLY(nb_apply_still) {
  struct nb_stage *stage = nb_stage_now(((struct nb_scene_reading *)subject)->scene);
  if (stage && record->keyword->variant && stage->motion_count > 0)
    nb_token_mistake(reader, &reader->tokens[0], "it turns round what walls did until then",
                     "expected `reverse` above the statements that move walls, found it below");
  if (stage)
    *(record->keyword->variant ? &stage->reverse : &stage->still) = true;
}

/* What follows `ramp` is a statement of its own; whatever this line has said then is ramped. */
NB_APPLY(nb_apply_ramp) {
  struct nb_scene_reading *reading = subject;
  struct nb_stage *stage = nb_stage_now(reading->scene);
  const int line = (int)reader->line;
  (void)record;
  if (!stage || !nb_take(reader, "what shall change: `wall`, `walls`, `material`, `pair`, `gravity` or `servo`"))
    return;
  memmove(reader->tokens, reader->tokens + 1, --reader->count * sizeof *reader->tokens);
  nb_statement_read(reader, nb_keywords(), NB_IN_RAMP, subject);
  for (size_t i = 0; i < stage->motion_count; i++)
    stage->motions[i].ramp = stage->motions[i].ramp || stage->motions[i].line == line;
  for (size_t i = 0; i < stage->change_count; i++)
    stage->changes[i].ramp = stage->changes[i].ramp || stage->changes[i].line == line;
  stage->servo.ramp = stage->servo.ramp || stage->servo.line == line;
  stage->gravity.ramp = stage->gravity.ramp || stage->gravity.line == line;
}

/* The line of a ramp; 0: none. */
static int ramp_of(const struct nb_stage *stage) {
  for (size_t i = 0; i < stage->motion_count; i++)
    if (stage->motions[i].ramp)
      return stage->motions[i].line;
  for (size_t i = 0; i < stage->change_count; i++)
    if (stage->changes[i].ramp)
      return stage->changes[i].line;
  return stage->servo.ramp ? stage->servo.line : stage->gravity.ramp ? stage->gravity.line : 0;
}

void nb_ramps_check(struct nb_scene_reading *reading) {
  for (size_t i = 0; i < reading->scene->stage_count; i++) {
    const struct nb_stage *stage = &reading->scene->stages[i];
    const int line = ramp_of(stage);
    if (!line || stage->condition_count == 0)
      continue;
    nb_line_mistake(&reading->reader, line, "a ramp ends with its stage: say how long that is with `cycles N`",
                    "expected a ramp in a stage of `cycles N`, found `until` in `%s`", stage->name);
  }
}
