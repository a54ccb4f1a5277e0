/* The step, of the scene and from a stage on; and what belongs to it: `allow unstable`, `skin`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "statement.h"

enum { AT_SKIN };
static const struct nb_argument nothing[] = {END};
static const struct nb_argument skin_fields[] = {
    VALUE("LENGTH", NB_UNIT_LENGTH, NB_POSITIVE, AT_SKIN, "Distance between two surfaces."), END};

/* What a step may be a share of. */
#define SHARES "stable|collision|single-contact|rayleigh|rayleigh-mean|rayleigh-fit|rayleigh-fit-mean"
static const enum nb_step_kind kinds[] = {NB_STEP_STABLE,           NB_STEP_COLLISION,     NB_STEP_SINGLE_CONTACT,
                                          NB_STEP_RAYLEIGH,         NB_STEP_RAYLEIGH_MEAN, NB_STEP_RAYLEIGH_FIT,
                                          NB_STEP_RAYLEIGH_FIT_MEAN};

/* Whether that word stands behind the number, `0.2` or `20 %`. */
static bool follows(const struct nb_reader *reader, const char *word) {
  size_t behind = reader->next + 1;
  behind += behind < reader->count && strcmp(reader->tokens[behind].text, "%") == 0;
  return behind < reader->count && strcmp(reader->tokens[behind].text, word) == 0;
}

/* TIME, F of something, or N per collision. */
NB_APPLY(apply_step) {
  struct nb_scene_reading *reading = subject;
  struct nb_stage *stage = nb_stage_now(reading->scene);
  struct nb_step *here = stage ? &stage->step : &reading->scene->step;
  const bool fraction = follows(reader, "of"), per = follows(reader, "per"), setting = reader == &reading->setting;
  struct nb_step step = {.kind = NB_STEP_TIME, .line = setting ? 0 : (int)reader->line, .set = setting};
  (void)record;
  nb_take_number(reader, fraction || per ? NB_UNIT_NUMBER : NB_UNIT_TIME, NB_POSITIVE, &step.value);
  if (fraction && nb_take_word(reader, "of")) {
    const int kind = nb_take_choice(reader, SHARES);
    step.kind = kind < 0 ? NB_STEP_TIME : kinds[kind];
  } else if (per && nb_take_word(reader, "per") && nb_take_word(reader, "collision")) {
    step.kind = NB_STEP_COLLISION, step.value = 1 / step.value;
  }
  if (reader->bad || nb_token_peek(reader)) /* which the engine says */
    return;
  /* one that is inherited stands above the stage, or below when it is read again */
  if (!setting && here->line > (stage ? stage->line : 0) && here->line < (int)reader->line &&
      nb_given_twice(reader, here->line))
    return;
  if (setting)
    reading->step_set = true;
  else if (reading->step_set)
    step.kind = here->kind, step.value = here->value, step.set = true; /* said and checked, but overridden */
  *here = step;
}

/* `allow unstable`: in the scene for all stages, in a stage for this one. */
NB_APPLY(apply_allow) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  struct nb_stage *stage = nb_stage_now(scene);
  (void)record;
  if (!nb_take_word(reader, "unstable"))
    return;
  if (stage && ((struct nb_scene_reading *)subject)->here == NB_IN_STAGE)
    stage->allow_unstable = true;
  else
    scene->allow_unstable = true;
}

NB_APPLY(apply_skin) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  if (scene->skin > 0)
    nb_token_mistake(reader, &reader->tokens[0], NULL, "`skin` is given twice");
  scene->skin = record->value[AT_SKIN].number;
}

/* clang-format off */
NB_STATEMENTS(step) = {
  {"step", NB_IN_SCENE | NB_IN_STAGE | NB_IN_START, nothing, "TIME | N per collision | F of collision|stable|single-contact|rayleigh|rayleigh-mean|rayleigh-fit|rayleigh-fit-mean", 0, false, apply_step,
   "The time step: a time; or a fraction of the guaranteed stable step at the beginning of a stage, `stable`; of 2 sqrt(m/k) of the lightest particle and the stiffest contact [CS79, "
   "Motion], `single-contact`; or of the shortest collision, `collision`. `N per collision` is the N-th part of that. No default. "
   "The collision of elastic spheres takes Hertz's time, which depends on their speed: that of the pairs predicted to collide at their current velocities. "
   "`rayleigh` is a surface wave's time half round the smallest sphere, `rayleigh-mean` round the mean one, "
   "with `-fit` by R89's fit of its speed [R89 4.33, 4.34]. In a stage: from this stage on. --set step=... overrides it everywhere.",
   "step      0.1 of single-contact"},
  {"allow", NB_IN_SCENE | NB_IN_STAGE | NB_IN_START, nothing, "unstable", 0, false, apply_allow,
   "Lets a run go on whose step is longer than the guaranteed stable one; else it is aborted. In a stage: in this one only.",
   "allow     unstable"},
  {"skin", NB_IN_SCENE | NB_IN_START, skin_fields, NULL, 0, false, apply_skin,
   "Pairs closer than this are in the neighbour list [R89 TOL], which is rebuilt when a particle or wall "
   "has moved half of it; default a tenth of the mean radius. No result depends on it.",
   "skin      0.5 mm"},
  {0},
};
/* clang-format on */
