/* What happens: stages, the motion of walls in them, how long they last, and what is recorded.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "scene.h"

enum { CYCLES_MAX = 1000000000 };

struct nb_stage *nb_stage_now(const struct nb_scene *scene) {
  return scene->stage_count ? &scene->stages[scene->stage_count - 1] : NULL;
}

/* A stage begins with the step and damping of the one before it, the first one with those of the scene. */
NB_APPLY(nb_apply_stage) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  const struct nb_token *name = record->value[AT_NAME].token;
  const struct nb_stage *before = nb_stage_now(scene);
  struct nb_stage stage = {.record = 1, .look = 1, .snapshot_from = -1};
  stage.step = before ? before->step : scene->step;
  stage.damping = before ? before->damping : scene->damping;
  if (reading->opening) { /* what was said behind `start` is said in this one */
    stage = scene->stages[--scene->stage_count];
    reading->opening = false;
  }
  stage.line = (int)reader->line;
  if (name)
    nb_stage_name(&stage, reading, name);
  for (size_t i = 0; i < scene->stage_count; i++)
    if (name && strcmp(scene->stages[i].name, stage.name) == 0)
      nb_token_mistake(reader, name, NULL, "there is a stage `%s` already, on line %d", stage.name,
                       scene->stages[i].line);
  if (nb_too_many(reader, scene->stage_count, NB_NAMED_MAX, "stages"))
    return;
  struct nb_stage *stages = nb_room(scene->stages, scene->stage_count, 1, sizeof *stages);
  if (!stages) {
    nb_no_memory(reader);
    return;
  }
  scene->stages = stages;
  stages[scene->stage_count++] = stage;
  reading->here = NB_IN_STAGE;
}

/* What a wall does by now, as the page has it: `reverse` has turned round what it was told before. */
static struct nb_wall_motion wall_so_far(const struct nb_scene *scene, size_t wall) {
  const struct nb_wall *it = &scene->walls[wall];
  struct nb_wall_motion motion = {.wall = (int)wall, .vx = it->vx, .vy = it->vy, .spin = it->spin};
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    if (stage->reverse) /* + 0.0 makes a -0 a plain 0 */
      motion.vx = -motion.vx + 0.0, motion.vy = -motion.vy + 0.0, motion.spin = -motion.spin + 0.0;
    for (size_t i = 0; i < stage->motion_count; i++)
      if (stage->motions[i].wall == (int)wall)
        motion = stage->motions[i];
  }
  return motion;
}

/* A second motion of the same wall in a stage takes the place of the first: `walls inward 1 mm/s`, but one of them
 * stands. */
static void move_wall(struct nb_scene *scene, struct nb_reader *reader, struct nb_wall_motion motion) {
  struct nb_stage *stage = nb_stage_now(scene);
  motion.line = (int)reader->line, motion.ramp = false;
  for (size_t i = 0; i < stage->motion_count; i++) {
    if (stage->motions[i].wall != motion.wall)
      continue;
    stage->motions[i] = motion;
    return;
  }
  struct nb_wall_motion *motions = nb_room(stage->motions, stage->motion_count, 1, sizeof *motions);
  if (!motions) {
    nb_no_memory(reader);
    return;
  }
  stage->motions = motions;
  motions[stage->motion_count++] = motion;
}

NB_APPLY(nb_apply_walls) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_value *inward = &record->value[AT_INWARD], *stop = &record->value[AT_STOP];
  size_t moved = 0;
  if (!inward->token == !stop->token) {
    reader->next = reader->count;
    if (inward->token)
      nb_token_mistake(reader, &reader->tokens[0], NULL, "expected one of `inward V` and `stop`, found both");
    else
      nb_expected(reader, NULL, "`inward V` or `stop`");
    return;
  }
  for (size_t i = 0; i < scene->wall_count; i++) {
    const struct nb_wall *wall = &scene->walls[i];
    bool of_box = wall->inx != 0 || wall->iny != 0;
    if (inward->token && !of_box)
      continue;
    struct nb_wall_motion motion = wall_so_far(scene, i);
    motion.vx = stop->token ? 0 : wall->inx * inward->number + 0.0; /* which makes the -0 of a product a plain 0 */
    motion.vy = stop->token ? 0 : wall->iny * inward->number + 0.0;
    motion.spin = stop->token ? 0 : motion.spin;
    move_wall(scene, reader, motion);
    moved++;
  }
  if (moved == 0)
    nb_token_mistake(reader, &reader->tokens[0], inward->token ? "define it before the stages with `box …`" : NULL,
                     "expected a scene with %s, found none", inward->token ? "a box" : "walls");
}

NB_APPLY(nb_apply_wall_motion) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_value *value = record->value;
  int wall = nb_wall_of(scene, reader, value[AT_NAME].token);
  if (wall < 0)
    return;
  if (!value[AT_VX].token && !value[AT_SPIN].token) {
    nb_expected(reader, NULL, "`velocity VX VY`, `spin W` or both");
    return;
  }
  struct nb_wall_motion motion = wall_so_far(scene, (size_t)wall);
  if (value[AT_VX].token)
    motion.vx = value[AT_VX].number, motion.vy = value[AT_VY].number;
  if (value[AT_SPIN].token)
    motion.spin = value[AT_SPIN].number;
  move_wall(scene, reader, motion);
}

/* A stage lasts once: `cycles` or one `until`. The wrong statement counts, so that the stage is not said to have
 * none. */
static bool ends_twice(struct nb_stage *stage, struct nb_reader *reader) {
  bool twice = stage->cycles != 0;
  if (twice)
    nb_token_mistake(reader, &reader->tokens[0], NULL,
                     "the stage `%s` has an end already: `cycles` or `until`, and once", stage->name);
  else
    stage->cycles = 1;
  return twice || reader->bad;
}

NB_APPLY(nb_apply_cycles) {
  struct nb_stage *stage = nb_stage_now(((struct nb_scene_reading *)subject)->scene);
  if (!stage || ends_twice(stage, reader))
    return;
  stage->cycles = (unsigned long)record->value[AT_CYCLES].number;
}

/* The name at the next token, with its place. */
static bool take_asked(struct nb_reader *reader, struct nb_asked *asked) {
  const struct nb_token *token = nb_take(reader, "a quantity, such as `C.normal`");
  if (!token || token->hollow)
    return false;
  if (strlen(token->text) >= sizeof asked->name) {
    nb_token_mistake(reader, token, NULL, "expected a name shorter than %zu bytes", sizeof asked->name);
    return false;
  }
  *asked = (struct nb_asked){.line = reader->line, .column = token->column, .length = token->length};
  snprintf(asked->name, sizeof asked->name, "%s", token->text);
  return true;
}

/* QUANTITY above|below VALUE */
static bool take_condition(struct nb_scene_reading *reading, struct nb_reader *reader, struct nb_condition *condition) {
  struct nb_asked asked;
  condition->line = (int)reader->line;
  if (!take_asked(reader, &asked))
    return false;
  if (!nb_asked_find(reading, &condition->quantity, &asked))
    return reader->bad = true, false;
  snprintf(condition->name, sizeof condition->name, "%s", asked.name);
  condition->relation = nb_token_is(reader, "above") ? NB_ABOVE : NB_BELOW;
  if (!nb_token_skip(reader, "above") && !nb_token_skip(reader, "below"))
    return nb_expected(reader, NULL, "`above` or `below`"), false;
  return nb_take_in(reader, nb_quantity_unit(condition->quantity), &condition->value);
}

/* N cycles */
static bool take_cycles(struct nb_reader *reader, unsigned long *count) {
  return nb_take_count(reader, 1, CYCLES_MAX, count) &&
         (nb_token_skip(reader, "cycle") || nb_take_word(reader, "cycles"));
}

NB_APPLY(nb_apply_until) {
  struct nb_scene_reading *reading = subject;
  struct nb_stage *stage = nb_stage_now(reading->scene);
  (void)record;
  if (!stage || ends_twice(stage, reader))
    return;
  do {
    struct nb_condition condition = {0};
    if (!take_condition(reading, reader, &condition))
      return;
    struct nb_condition *conditions = nb_room(stage->conditions, stage->condition_count, 1, sizeof *conditions);
    if (!conditions) {
      nb_no_memory(reader);
      return;
    }
    stage->conditions = conditions;
    conditions[stage->condition_count++] = condition;
  } while (nb_token_skip(reader, "and"));
  if (nb_token_skip(reader, "every") && !take_cycles(reader, &stage->look))
    return;
  if (!nb_token_skip(reader, "at")) {
    nb_expected(reader, "a stage that may last for ever is not run", "`and`, `every N cycles` or `at most N cycles`");
    return;
  }
  if (nb_take_word(reader, "most"))
    take_cycles(reader, &stage->cycles);
}

/* `record QUANTITY …` in the scene: the names are looked up when all watches are known. */
NB_APPLY(nb_apply_columns) {
  struct nb_scene_reading *reading = subject;
  (void)record;
  do {
    struct nb_asked one;
    if (!take_asked(reader, &one))
      return;
    if (nb_too_many(reader, reading->asked_count, NB_NAMED_MAX, "columns"))
      return;
    struct nb_asked *asked = nb_room(reading->asked, reading->asked_count, 1, sizeof *asked);
    if (!asked) {
      nb_no_memory(reader);
      return;
    }
    reading->asked = asked;
    size_t i = 0;
    while (i < reading->asked_count && strcmp(asked[i].name, one.name) != 0)
      i++;
    if (i < reading->asked_count)
      nb_token_mistake(reader, &reader->tokens[reader->next - 1], NULL, "`%s` is recorded already, by line %zu",
                       one.name, asked[i].line);
    asked[reading->asked_count++] = one;
  } while (nb_token_peek(reader));
}

/* In a stage: `record every N cycles` or `record none`. */
NB_APPLY(nb_apply_record) {
  struct nb_stage *stage = nb_stage_now(((struct nb_scene_reading *)subject)->scene);
  unsigned long every = 0;
  (void)record;
  if (!nb_token_skip(reader, "none")) {
    if (!nb_token_skip(reader, "every")) {
      nb_expected(reader, "what to record is said before the first stage", "`every N cycles` or `none`");
      return;
    }
    if (!nb_take_count(reader, 1, CYCLES_MAX, &every))
      return;
    const bool path = ((struct nb_scene_reading *)subject)->scene->path;
    if (!nb_token_skip(reader, path ? "step" : "cycle") && !nb_take_word(reader, path ? "steps" : "cycles"))
      return;
  }
  if (stage)
    stage->record = every;
}

bool nb_stage_not_here(const struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *name) {
  size_t s = 0;
  while (s < scene->start.stages && strcmp(scene->stages[s].name, name->text) != 0)
    s++;
  if (s < scene->start.stages)
    nb_token_mistake(reader, name, "the first stage of this page begins with the state: name that one",
                     "expected a stage of this page: of `%s`, which is run before, the state has only how it ended",
                     name->text);
  return s < scene->start.stages;
}

/* `snapshot {from STAGE}`: that stage is this one or an earlier one, and runs: those of another page may not. */
NB_APPLY(nb_apply_snapshot) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  struct nb_stage *stage = nb_stage_now(scene);
  (void)record;
  if (!stage)
    return;
  stage->snapshot = true;
  if (scene->path || !nb_token_skip(reader, "from"))
    return;
  const struct nb_token *name = nb_take(reader, "the name of this stage or of an earlier one");
  for (size_t s = scene->start.stages; name && s < scene->stage_count; s++)
    if (strcmp(scene->stages[s].name, name->text) == 0)
      stage->snapshot_from = (int)s;
  if (name && stage->snapshot_from < 0 && !nb_stage_not_here(scene, reader, name))
    nb_token_mistake(reader, name, NULL, "expected the name of this stage or of an earlier one, found `%s`",
                     name->text);
}
