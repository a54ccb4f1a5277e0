/* `step`, of the scene and of stages; `allow unstable`; `skin`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "core/clean.h"
#include "statement.h"

enum { AT_SKIN };
static const struct nb_argument no_fields[] = {END};
static const struct nb_argument skin_fields[] = {
    VALUE("LENGTH", NB_UNIT_LENGTH, NB_POSITIVE, AT_SKIN, "Largest distance of the surfaces of a listed pair."), END};

/* The reference steps; `step F of NAME` is a fraction of one of them. */
#define STEP_KINDS "stable|collision|single-contact|rayleigh|rayleigh-mean|rayleigh-fit|rayleigh-fit-mean"
static const enum nb_step_kind kinds[] = {NB_STEP_STABLE,           NB_STEP_COLLISION,     NB_STEP_SINGLE_CONTACT,
                                          NB_STEP_RAYLEIGH,         NB_STEP_RAYLEIGH_MEAN, NB_STEP_RAYLEIGH_FIT,
                                          NB_STEP_RAYLEIGH_FIT_MEAN};

/* True if the text is one of `words`, which `|` separates. */
static bool is_one_of(const char *text, const char *words) {
  size_t length = strcspn(words, "|");
  while (words[length] && !(strlen(text) == length && strncmp(words, text, length) == 0))
    words += length + 1, length = strcspn(words, "|");
  return strlen(text) == length && strncmp(words, text, length) == 0;
}

/* True if one of `words` follows the next number, such as `0.2` or `20 %`. */
static bool follows(const struct nb_reader *reader, const char *words) {
  size_t behind = reader->next + 1;
  behind += behind < reader->count && strcmp(reader->tokens[behind].text, "%") == 0;
  return is_one_of(behind < reader->count ? reader->tokens[behind].text : "|", words);
}

/* Writes the hint for an incomplete fraction of a reference step, with the number of the page if a step can be this
 * fraction, and with the reference step that the page names in the last word of the line: "write `step 0.3 of
 * stable`". */
static const char *fraction_hint(char *hint, const struct nb_reader *reader) {
  static const double least = 1e-3; /* a smaller number is hardly a fraction: it may be meant as a time in s */
  const struct nb_token *const number = &reader->tokens[1], *const last = &reader->tokens[reader->count - 1];
  const bool percent = reader->count > 2 && strcmp(number[1].text, "%") == 0;
  const double whole = percent ? 100 : 1;
  double value;
  char text[NB_NAME_SIZE] = "0.2";
  if (nb_number_read(&value, number->text, 0) == NB_READ && value >= least * whole && value <= whole)
    snprintf(text, sizeof text, "%.10g%s", value, percent ? " %" : "");
  if (is_one_of(last->text, STEP_KINDS))
    snprintf(hint, NB_HINT_SIZE, "write `step %s of %s`", text, last->text);
  else
    snprintf(hint, NB_HINT_SIZE, "write `step %s of stable`, with elastic spheres `step %s of rayleigh`", text, text);
  return hint;
}

/* Refuses several steps in one line, `step 5 % 10 %`. True: they are refused. */
static bool refuse_several(struct nb_reader *reader) {
  const struct nb_token *const number = nb_token_peek(reader);
  const size_t percent = reader->count > 2 && strcmp(number[1].text, "%") == 0, at = reader->next + 1 + percent;
  double value;
  char hint[NB_HINT_SIZE];
  if (at >= reader->count || nb_number_read(&value, number->text, 0) != NB_READ ||
      nb_number_read(&value, reader->tokens[at].text, 0) != NB_READ)
    return false;
  const char *const sign = percent ? " %" : "";
  snprintf(
      hint, sizeof hint,
      "a run for each of several steps is `sweep f %.40s%s %.40s%s`, and below it `step $f of stable`, with elastic "
      "spheres `step $f of rayleigh`",
      number->text, sign, reader->tokens[at].text, sign);
  return !nb_token_mistake(reader, &reader->tokens[at], hint, "expected one time step, found several");
}

/* Refuses `step 0.3` and `step 30 %`, numbers without a unit and without a reference step; another statement may follow
 * in the line. True: it is refused. */
static bool refuse_number(struct nb_reader *reader) {
  const struct nb_token *const number = nb_token_peek(reader);
  const size_t count = reader->count - reader->next;
  const bool percent = count > 1 && strcmp(number[1].text, "%") == 0;
  const char *const next = count > 1u + percent ? number[1 + percent].text : "";
  const bool statement = is_one_of(next, "skin|allow");
  char hint[NB_HINT_SIZE];
  double value;
  if (!(count == 1u + percent || statement) || (reader->unitless && !percent) ||
      nb_number_read(&value, number->text, 0) != NB_READ)
    return false;
  struct nb_token both = *number;
  if (percent)
    both.length = number[1].column + number[1].length - number->column;
  fraction_hint(hint, reader);
  nb_append(hint, sizeof hint,
            reader->unitless ? "; a time is a number: `step 1e-05`" : "; a time has a unit: `step 10 us`");
  if (statement)
    nb_append(hint, sizeof hint, "; `%s` begins a line of its own", next);
  return !nb_token_mistake(reader, &both, hint, "expected a time%s, or a fraction `F of stable`, found `%s%s`",
                           reader->unitless ? "" : " and its unit", number->text, percent ? " %" : "");
}

/* Takes the words after the number of `step F of NAME`. */
static void take_reference(struct nb_reader *reader, struct nb_step *step) {
  char hint[NB_HINT_SIZE];
  reader->otherwise = fraction_hint(hint, reader);
  if (nb_take_word(reader, "of") && !nb_token_peek(reader)) {
    nb_expected(reader, hint, "`stable` or another reference step");
  } else if (!reader->bad) {
    const int kind = nb_take_choice(reader, STEP_KINDS);
    step->kind = kind < 0 ? NB_STEP_TIME : kinds[kind];
  }
  reader->otherwise = NULL;
}

/* Takes the words after the number of `step TIME` or `step N per collision`. */
static void take_rest(struct nb_reader *reader, struct nb_step *step, bool per) {
  char hint[NB_HINT_SIZE];
  if (!per && nb_token_is(reader, "of"))
    nb_expected(reader, fraction_hint(hint, reader), "the end of the line, because a fraction has no unit");
  else if (per && nb_take_word(reader, "per") &&
           (nb_token_skip(reader, "collision") ||
            nb_expected(reader, "for example `step 40 per collision`", "`collision`")))
    step->kind = NB_STEP_COLLISION, step->value = 1 / step->value;
}

/* Reads `step TIME`, `step F of NAME` or `step N per collision`. */
NB_APPLY(apply_step) {
  struct nb_scene_reading *reading = subject;
  struct nb_stage *stage = nb_current_stage(reading->scene);
  struct nb_step *here = stage ? &stage->step : &reading->scene->step;
  const bool fraction = follows(reader, "of|critical|" STEP_KINDS), per = follows(reader, "per"),
             setting = reader == &reading->setting;
  struct nb_step step = {.kind = NB_STEP_TIME, .line = setting ? 0 : (int)reader->line, .set = setting};
  if (refuse_number(reader) || refuse_several(reader) ||
      !nb_take_number(reader, fraction || per ? NB_UNIT_NUMBER : NB_UNIT_TIME, NB_POSITIVE, &step.value))
    return;
  if (fraction)
    take_reference(reader, &step);
  else
    take_rest(reader, &step, per);
  if (reader->bad || nb_token_peek(reader)) /* nb_statement_read reports the token */
    return;
  /* the line of an inherited step is above the stage, or below it if the stage is repeated */
  if (!setting && here->line > (stage ? stage->line : 0) && here->line < (int)reader->line &&
      nb_given_twice(reader, here->line))
    return;
  if (setting)
    reading->step_set = true;
  else if (reading->step_set)
    step.kind = here->kind, step.value = here->value, step.set = true; /* --set overrides the value */
  *here = step;
}

/* `allow unstable`: in the scene for all stages, in a stage for this one. */
NB_APPLY(apply_allow) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  struct nb_stage *stage = nb_current_stage(scene);
  if (!nb_take_word(reader, "unstable"))
    return;
  if (((struct nb_scene_reading *)subject)->here == NB_IN_STAGE)
    stage->allow_unstable = true;
  else
    scene->allow_unstable = true;
}

NB_APPLY(apply_skin) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  if (scene->skin > 0)
    nb_token_mistake(reader, &reader->tokens[0], NULL, "expected one `skin`, found a second one");
  scene->skin = record->value[AT_SKIN].number;
}

/* clang-format off */
NB_STATEMENTS(step) = {
  {"step", NB_IN_SCENE | NB_IN_STAGE | NB_IN_START, no_fields, "TIME | N per collision | F of collision|stable|single-contact|rayleigh|rayleigh-mean|rayleigh-fit|rayleigh-fit-mean", 0, false, apply_step,
   "Sets the time step: a time, or a fraction F of a reference time. There is no default. In a stage the step changes from this stage on. --set step=… overrides it everywhere. --set refine=R divides the step and strains per cycle by R and multiplies numbers of cycles by R, so that the stages last as long as before; `every 1 cycle` does not change.\n"
   "TIME: a time above 0.\n"
   "N per collision: a number above 0. N steps last as long as the shortest collision.\n"
   "F of collision: a number above 0, as are all F below. The duration of the shortest collision; for elastic spheres that of Hertz, at the speeds of the pairs predicted to collide at their current velocities.\n"
   "F of stable: the guaranteed stable step at the beginning of each stage.\n"
   "F of single-contact: 2 sqrt(m/k) of the smallest mass and the largest stiffness [CS79, Motion].\n"
   "F of rayleigh: the travel time of a surface wave from pole to pole of a sphere, the shortest over all spheres [R89 4.33].\n"
   "F of rayleigh-mean: the same for a sphere with the mean properties.\n"
   "F of rayleigh-fit, F of rayleigh-fit-mean: the same as the last two, with R89's fit of the wave speed [R89 4.34].",
   "step      0.2 of stable"},
  {"allow", NB_IN_SCENE | NB_IN_STAGE | NB_IN_START, no_fields, "unstable", 0, false, apply_allow,
   "Allows a step longer than the guaranteed stable one. Without this statement a run with such a step is aborted. In a stage it holds for this stage only.",
   "allow     unstable"},
  {"skin", NB_IN_SCENE | NB_IN_START, skin_fields, NULL, 0, false, apply_skin,
   "Sets the skin of the neighbour list: pairs closer than this distance are in the list [R89 TOL]. The list is rebuilt when a particle or wall has moved by half of this distance; default a tenth of the mean radius. At a given step the skin changes no force. `gap` and `step.stable`, and so a step in fractions of `stable`, depend on the pairs in the list.",
   "skin      0.5 mm"},
  {0},
};
/* clang-format on */
