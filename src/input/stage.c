/* Stages: `stage`, `cycles`, `until`, `ramp`, `zero velocities`, `reverse velocities`, `rotation`; and `repeat from
 * NAME N times`, which reads the lines of stages again.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "core/clean.h"
#include "core/names.h"
#include "loading/loading.h"
#include "statement.h"

enum { AT_NAME };
enum { AT_CYCLES };
static const struct nb_argument no_fields[] = {END};
static const struct nb_argument stage_fields[] = {NAME(AT_NAME, "a name for the stage"), END};
static const struct nb_argument cycles_fields[] = {COUNT(NULL, "N", AT_CYCLES, NULL, "Number of cycles."), END};

struct nb_stage *nb_current_stage(const struct nb_scene *scene) {
  return scene->stage_count ? &scene->stages[scene->stage_count - 1] : NULL;
}

void nb_stage_name(struct nb_stage *stage, const struct nb_scene_reading *reading, const struct nb_token *name) {
  char number[24] = "";
  if (reading->repeat.now)
    snprintf(number, sizeof number, "-%lu", reading->repeat.now);
  const size_t most = sizeof stage->name - 1 - strlen(number), length = strlen(name->text);
  snprintf(stage->name, sizeof stage->name, "%.*s%s", (int)(length < most ? length : most), name->text, number);
}

/* A stage begins with the step and the damping of the previous stage; the first stage begins with those of the scene. A
 * line with a mistake also begins a stage, because the lines below belong to this stage. */
NB_APPLY(apply_stage) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  const struct nb_token *name = record->value[AT_NAME].token;
  const struct nb_stage *before = nb_current_stage(scene);
  struct nb_stage one = {.record_interval = 1, .check_interval = 1, .snapshot_from = -1};
  one.step = before ? before->step : scene->step;
  one.damping = before ? before->damping : scene->damping;
  if (reading->before_first_stage) { /* the statements after `start` belong to this stage */
    one = scene->stages[--scene->stage_count];
    reading->before_first_stage = false;
  }
  one.line = (int)reader->line;
  if (name)
    nb_stage_name(&one, reading, name);
  const int same = NB_FIND(scene->stages, scene->stage_count, one.name);
  if (name)
    nb_exists(reader, name, "stage", same < 0 ? 0 : scene->stages[same].line);
  nb_too_many(reader, scene->stage_count, NB_NAMED_MAX, "stages");
  if (scene->stage_count < NB_NAMED_MAX && NB_APPEND(reader, scene->stages, scene->stage_count, one))
    reading->here = scene->contact_test ? NB_IN_SEGMENT : NB_IN_STAGE; /* a `stage` in a contact test is a mistake */
}

/* ---- end of a stage: either `cycles` or one `until` ---- */

static bool ends_twice(const struct nb_stage *stage, struct nb_reader *reader) {
  if (stage->cycles != 0)
    nb_token_mistake(reader, &reader->tokens[0], NULL,
                     "expected one `cycles` or one `until` in the stage `%s`, found a second one", stage->name);
  return stage->cycles != 0;
}

NB_APPLY(apply_cycles) {
  struct nb_stage *stage = nb_current_stage(((struct nb_scene_reading *)subject)->scene);
  if (!ends_twice(stage, reader))
    stage->cycles = (unsigned long)record->value[AT_CYCLES].number;
}

/* True if the next tokens are a fraction of something, such as `1e-6 of max`. */
static bool is_fraction(const struct nb_reader *reader) {
  const struct nb_token *const token = &reader->tokens[reader->next];
  const size_t left = reader->count - reader->next;
  return (left > 1 && strcmp(token[1].text, "of") == 0) ||
         (left > 2 && strcmp(token[1].text, "%") == 0 && strcmp(token[2].text, "of") == 0);
}

/* The strain rate of the size in this stage, if it leads to this fraction of the size, 1/s; 0: there is none, or a servo
 * changes it. `size`: the width and height of the box, 0 and 1, or the sides of the cell, 2 and 3. */
static double rate_to(const struct nb_stage *stage, int size, double fraction) {
  int line;
  const struct nb_strain_rate *const given = nb_affine_given(stage, size < 2 ? NB_AFFINE_BOX : NB_AFFINE_CELL, &line);
  const double rate = size % 2 ? given->yy : given->xx;
  const struct nb_strain_rate along = {.xx = size % 2 ? 0 : rate, .yy = size % 2 ? rate : 0};
  const bool changes = (size < 2 ? stage->servo.box : stage->servo.cell) && nb_servo_opposes(&stage->servo, &along);
  return !given->per_cycle && !changes && rate * log(fraction) > 0 ? rate : 0;
}

/* Writes the hint for `until box.height below 0.95 of box.height`: an end at a strain. A stage with a constant strain
 * rate e reaches the fraction F of its size after the time log(F)/e, because e refers to the present size. The hint has
 * the rate of the stage, or an example. False: the quantity is no size of a box or a cell. */
static bool strain_hint(char *hint, const struct nb_reader *reader, const struct nb_stage *stage,
                        const struct nb_condition *condition) {
  static const struct { char name[NB_NAME_SIZE]; } sizes[] = {{"box.width"}, {"box.height"}, {"cell.xx"}, {"cell.yy"}};
  const struct nb_token *const number = nb_token_peek(reader);
  const int size = NB_FIND(sizes, 4, condition->name);
  double fraction;
  if (size < 0 || nb_number_read(&fraction, number->text, 0) != NB_READ)
    return false;
  fraction *= strcmp(number[1].text, "%") == 0 ? 0.01 : 1;
  if (!(fraction > 0) || fraction == 1)
    return false;
  const double own = rate_to(stage, size, fraction), rate = own != 0 ? own : copysign(0.01, log(fraction));
  const char *const unit = reader->unitless ? "" : " 1/s";
  snprintf(
      hint, NB_HINT_SIZE,
      "with a constant strain rate, %s %g%s, the stage ends at a time: `until stage.time above (log(%g)/(%g%s)) at "
      "most 1000000 cycles`, with more cycles if the step is short. Or write a value: `until %s %s (%g*L) at most "
      "1000000 cycles`, where `let L = …` in the scene is the %s at the beginning of the stage",
      own != 0 ? "here" : "for example", rate, unit, fraction, rate, unit, condition->name,
      condition->relation == NB_BELOW ? "below" : "above", fraction, size % 2 ? "height" : "width");
  return true;
}

/* Refuses `until QUANTITY below 1e-6 of max`: the largest value is not known before the end of the run. */
static bool fraction_mistake(struct nb_reader *reader, const struct nb_stage *stage,
                             const struct nb_condition *condition, const char *unit) {
  char hint[NB_HINT_SIZE];
  const bool number = reader->unitless || strcmp(unit, "1") == 0;
  if (!strain_hint(hint, reader, stage, condition))
    snprintf(
        hint, sizeof hint,
        "write the value, `until %s %s 1e-9%s%s at most 1000000 cycles`; to wait for rest, write `until unbalanced.max "
        "below 1e-4 and contacts above 0 at most 1000000 cycles`",
        condition->name, condition->relation == NB_BELOW ? "below" : "above", number ? "" : " ", number ? "" : unit);
  return nb_token_mistake(reader, nb_token_peek(reader), hint, "expected a number%s, found a fraction of another value",
                          number ? "" : " with its unit");
}

/* Takes a condition: QUANTITY above|below VALUE. */
static bool take_condition(struct nb_scene_reading *reading, struct nb_reader *reader, struct nb_condition *condition) {
  struct nb_requested requested;
  condition->line = (int)reader->line;
  if (!nb_take_requested(reading, reader, &requested))
    return false;
  if (!nb_requested_find(reading, &condition->quantity, &requested))
    return nb_fail_silently(reader);
  snprintf(condition->name, sizeof condition->name, "%s", requested.name);
  char hint[NB_HINT_SIZE];
  snprintf(hint, sizeof hint, "a condition has `above` or `below`: `until %s above VALUE at most 1000000 cycles`",
           condition->name);
  reader->otherwise = hint;
  condition->relation = nb_take_choice(reader, "above|below") == 0 ? NB_ABOVE : NB_BELOW;
  reader->otherwise = NULL;
  struct nb_comparison comparison = {.name = condition->name, .token = nb_token_peek(reader)};
  comparison.relation = condition->relation, comparison.unit = nb_quantity_unit(condition->quantity);
  comparison.bounds = nb_quantity_bounds(condition->quantity);
  if (is_fraction(reader))
    return fraction_mistake(reader, nb_current_stage(reading->scene), condition, comparison.unit);
  if (!nb_take_in_unit(reader, comparison.unit, &condition->value))
    return false;
  comparison.value = condition->value;
  if (reading->scene->start.stages > 0 && strcmp(condition->name, "time") == 0)
    nb_warn(&reading->scene->warnings, condition->line,
            "`time` counts from the start of the first page, `stage.time` from that of the stage");
  if (reading->scene->start.stages > 0 &&
      (strncmp(condition->name, "cell.strain", 11) == 0 || strncmp(condition->name, "box.strain", 10) == 0))
    nb_warn(&reading->scene->warnings, condition->line,
            "`%s` counts from the start of the first page; a small strain of this stage alone is its rate times "
            "`stage.time`",
            condition->name);
  nb_comparison_warn(&reading->scene->warnings, condition->line, &comparison);
  nb_tension_warn(reading->scene, &condition->quantity, condition->name,
                  condition->relation == NB_BELOW ? "below" : "above", condition->value, condition->line);
  return nb_comparison_is_open(reader, &comparison, "a condition");
}

NB_APPLY(apply_until) {
  struct nb_scene_reading *reading = subject;
  struct nb_stage *stage = nb_current_stage(reading->scene);
  const struct nb_token *const token = nb_token_peek(reader);
  double number;
  char hint[NB_HINT_SIZE];
  if (ends_twice(stage, reader))
    return;
  if (nb_foreign_hint(hint, reader)) { /* `until separation` */
    nb_expected(reader, hint, "a quantity");
    return;
  }
  if (token && nb_number_read(&number, token->text, 0) == NB_READ) {
    nb_token_mistake(
        reader, token,
        "a number of cycles is `cycles 1000`, and a time `until stage.time above 0.1 s at most 1000000 cycles`",
        "expected a quantity, found `%.80s`", token->text);
    return;
  }
  do {
    struct nb_condition condition = {0};
    if (take_condition(reading, reader, &condition))
      NB_APPEND(reader, stage->conditions, stage->condition_count, condition);
  } while (nb_token_skip(reader, "and"));
  if (reader->bad)
    nb_line_needs(reader, "most", "add a limit: `at most 1000000 cycles`", "`at most N cycles`");
  if (nb_token_skip(reader, "every"))
    nb_take_count_of(reader, "cycle", &stage->check_interval);
  if (!nb_token_skip(reader, "at"))
    nb_expected(reader, "add a limit: `at most 1000000 cycles`", "`and`, `every N cycles` or `at most N cycles`");
  else if (nb_take_word(reader, "most"))
    nb_take_count_of(reader, "cycle", &stage->cycles);
}

/* ---- changes, gradual and sudden ---- */

/* Reads the tokens after `ramp` as a statement, which marks its changes as ramps. */
NB_APPLY(apply_ramp) {
  struct nb_scene_reading *reading = subject;
  if (!nb_take_token(reader, "a statement that can ramp: `wall`, `walls`, `material`, `pair`, `gravity` or `servo`"))
    return;
  memmove(reader->tokens, reader->tokens + 1, --reader->count * sizeof *reader->tokens);
  reading->ramping = true;
  nb_statement_read(reader, nb_keywords(), NB_IN_RAMP, subject);
  reading->ramping = false;
}

/* The line of a ramp of the stage; 0: none. */
static int ramp_of(const struct nb_stage *it) {
  for (size_t i = 0; i < it->motion_count; i++)
    if (it->motions[i].ramp)
      return it->motions[i].line;
  for (size_t i = 0; i < it->change_count; i++)
    if (it->changes[i].ramp)
      return it->changes[i].line;
  return it->servo.ramp ? it->servo.line : it->gravity.ramp ? it->gravity.line : 0;
}

bool nb_is_repeated(const struct nb_scene *scene, size_t s) {
  size_t before = s;
  while (before > scene->start.stages && scene->stages[before - 1].line != scene->stages[s].line)
    before--;
  return before > scene->start.stages;
}

void nb_ramps_check(struct nb_scene_reading *reading) {
  for (size_t i = 0; i < reading->scene->stage_count; i++) {
    const struct nb_stage *it = &reading->scene->stages[i];
    const int line = ramp_of(it);
    if (!line || it->condition_count == 0 || nb_is_repeated(reading->scene, i))
      continue;
    nb_line_mistake(&reading->reader, (size_t)line, "a ramp lasts as long as its stage: give the stage `cycles N`",
                    "expected a stage with `cycles N` for a ramp, found `until` in `%s`", it->name);
  }
}

/* variant 1: reverse */
NB_APPLY(apply_velocities) {
  struct nb_stage *it = nb_current_stage(((struct nb_scene_reading *)subject)->scene);
  if (record->keyword->variant && it->motion_count > 0)
    nb_token_mistake(reader, &reader->tokens[0],
                     "`reverse velocities` reverses the velocities that the walls had before this stage",
                     "expected `reverse velocities` above the statements that move walls, found it below");
  *(record->keyword->variant ? &it->reverse_velocities : &it->zero_velocities) = true;
}

/* variant 1: off */
NB_APPLY(apply_rotation) {
  struct nb_stage *it = nb_current_stage(((struct nb_scene_reading *)subject)->scene);
  if (nb_given_twice(reader, it->rotation_line))
    return;
  it->rotation = record->keyword->variant ? NB_ROTATION_OFF : NB_ROTATION_ON;
  it->rotation_line = (int)reader->line;
}

/* ---- repeated stages or segments, which are called NAME-2, NAME-3, … ---- */

void nb_late_warn(struct nb_scene_reading *reading) {
  static const char *const changes[] = {"remove",  "zero",     "reverse", "rotation", "material", "pair",
                                        "gravity", "boundary", "box",     "cell",     "affine",   "wall",
                                        "walls",   "normal",   "shear",   "damping"};
  const struct nb_reader *reader = &reading->reader;
  const struct nb_stage *const stage = reading->here == NB_IN_STAGE ? nb_current_stage(reading->scene) : NULL;
  if (!stage || stage->cycles == 0 || reader->bad)
    return;
  for (size_t k = 0; k < sizeof changes / sizeof *changes; k++)
    if (strcmp(reader->tokens[0].text, changes[k]) == 0)
      nb_warn(&reading->scene->warnings, (int)reader->line,
              "`%s` stands below the `cycles` or `until` of stage `%s`, but acts when this stage begins: for a change "
              "at the "
              "end, begin a new stage above this line; for a change at the beginning, move this line above them",
              changes[k], stage->name);
}

bool nb_misplaced_after_repeat(struct nb_scene_reading *reading) {
  struct nb_reader *reader = &reading->reader;
  const struct nb_scene *scene = reading->scene;
  const char *begins = scene->contact_test ? "segment" : "stage", *verb = reader->tokens[0].text;
  if (reading->repeat.now || reading->repeat.until == 0 || strcmp(verb, begins) == 0 || strcmp(verb, "repeat") == 0 ||
      (size_t)nb_current_stage(scene)->line > reading->repeat.until)
    return false;
  char hint[NB_HINT_SIZE];
  snprintf(hint, sizeof hint,
           "move this statement above the `repeat`: there it belongs to each repeated %s, here only to the last one",
           begins);
  nb_token_mistake(reader, &reader->tokens[0], hint, "expected `%s` below the `repeat` of line %zu, found `%s`", begins,
                   reading->repeat.until, verb);
  return true;
}

/* Takes `N more times`. The word `more` says that the lines have run once before they are repeated. */
static bool take_times(struct nb_reader *reader, const char *from, unsigned long *times) {
  char hint[NB_HINT_SIZE];
  if (!nb_take_count(reader, 1, NB_NAMED_MAX, times))
    return false;
  snprintf(hint, sizeof hint, "write `repeat from %.80s %lu more time%s`", from, *times, *times > 1 ? "s" : "");
  if (*times > 1)
    nb_append(hint, sizeof hint,
              "; with the first run that makes %lu, so for %lu in all write `repeat from %.80s %lu more time%s`",
              *times + 1, *times, from, *times - 1, *times > 2 ? "s" : "");
  const struct nb_token *const token = nb_token_peek(reader);
  if (!nb_token_skip(reader, "more"))
    return token ? nb_token_mistake(reader, token, hint, "expected `more times`, found `%s`", token->text)
                 : nb_expected(reader, hint, "`more times`");
  return nb_token_skip(reader, "time") || nb_take_word(reader, "times");
}

NB_APPLY(apply_repeat) {
  struct nb_scene_reading *reading = subject;
  const struct nb_scene *scene = reading->scene;
  const size_t before = scene->start.stages;
  const char *what = scene->contact_test ? "the name of a segment" : "the name of a stage";
  unsigned long times;
  const struct nb_token *token = nb_take_word(reader, "from") ? nb_take_token(reader, what) : NULL;
  if (!token || nb_stage_before_start(scene, reader, token))
    return;
  const int s = NB_NAMED(reader, token, scene->stages + before, scene->stage_count - before,
                         scene->contact_test ? "the name of a segment above" : "the name of a stage above", NULL);
  const size_t from = s < 0 ? 0 : (size_t)scene->stages[before + (size_t)s].line;
  if (from < reading->repeat.until)
    nb_token_mistake(reader, token, NULL, "expected %s below the `repeat` of line %zu, found one above it",
                     scene->contact_test ? "a segment" : "a stage", reading->repeat.until);
  else if (take_times(reader, token->text, &times))
    reading->repeat = (struct nb_repeat){.from = from, .times = times, .until = reader->line};
}

/* clang-format off */
NB_STATEMENTS(stage) = {
  {"stage", NB_IN_SCENE | NB_IN_STAGE | NB_IN_START, stage_fields, NULL, 0, true, apply_stage,
   "Begins a stage. The statements below belong to it, up to the next `stage`.",
   "stage     strike"},
  {"ramp", NB_IN_STAGE, no_fields, "wall … | walls … | material … | pair … | gravity … | servo …", 0, false, apply_ramp,
   "Changes the values of one statement linearly over the cycles of the stage, from the present values to the given ones. The stage needs `cycles`. The statement follows the word `ramp`.",
   "  ramp    material steel  friction 0.5"},
  {"cycles", NB_IN_STAGE, cycles_fields, NULL, 0, false, apply_cycles,
   "Sets how many cycles the stage lasts. Each stage needs either `cycles` or `until`.",
   "  cycles  400"},
  {"until", NB_IN_STAGE, no_fields,
   "QUANTITY above|below VALUE {and QUANTITY above|below VALUE …} {every N cycles} at most N cycles", 0, false, apply_until,
   "Ends the stage as soon as all conditions hold. If they do not hold after N cycles, the run is aborted. All conditions must hold in the same cycle: after `box.stress.mean above 50 kPa and unbalanced.max below 1e-3` the stress may be far above 50 kPa, and only a servo holds it. Oscillating forces are balanced for a moment, so a wait for rest also needs `and energy.kinetic below VALUE`. `time` counts from the start of the run, `stage.time` from the start of the stage.\n"
   "QUANTITY above|below VALUE: a condition: a quantity, as in `record`, and a number with the unit of the quantity.\n"
   "every N cycles: a whole number, 1 or more; without it: 1. How often the conditions are checked.\n"
   "at most N cycles: a whole number, 1 or more. Largest length of the stage.",
   "stage     part\n  until   C.overlap below 1 nm and time above 1 ms  at most 10000 cycles"},
  {"zero velocities", NB_IN_STAGE, no_fields, NULL, 0, false, apply_velocities,
   "Sets the velocities and spins of all particles to 0 at the beginning of this stage. Walls keep their velocities.",
   "stage     halt\n  zero    velocities\n  cycles  10"},
  {"reverse velocities", NB_IN_STAGE, no_fields, NULL, 1, false, apply_velocities,
   "Changes the sign of all velocities and spins, also those of walls, at the beginning of this stage. Without friction and damping the particles then retrace their motion.",
   "stage     back\n  reverse velocities\n  cycles  10"},
  {"rotation off", NB_IN_STAGE, no_fields, NULL, 1, false, apply_rotation,
   "Stops the rotation of particles: their spins are set to 0, and moments have no effect from this stage on.",
   "stage     stiff\n  rotation off\n  cycles  10"},
  {"rotation on", NB_IN_STAGE, no_fields, NULL, 0, false, apply_rotation,
   "Lets particles rotate again, from this stage on.",
   "stage     roll\n  rotation on\n  cycles  10"},
  {"repeat", NB_IN_STAGE, no_fields, "from STAGE N more times", 0, false, apply_repeat,
   "Repeats the lines from the beginning of STAGE down to this line N times, after they have run once. The repeated stages are called STAGE-2, STAGE-3 and so on.\n"
   "from STAGE: the name of a stage above.\n"
   "N times: a whole number, 1 or more. How often the lines run in addition to the first time.",
   "stage     press\n  cycles  10\nrepeat    from press 2 more times"},
  {"repeat", NB_IN_SEGMENT, no_fields, "from SEGMENT N more times", 0, false, apply_repeat,
   "Repeats the lines from the beginning of SEGMENT down to this line N times, after they have run once. The repeated segments are called SEGMENT-2, SEGMENT-3 and so on.\n"
   "from SEGMENT: the name of a segment above.\n"
   "N times: a whole number, 1 or more. How often the lines run in addition to the first time.",
   "repeat    from load 2 more times"},
  {0},
};
/* clang-format on */
