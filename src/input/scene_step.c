/* The step and the damping, of the scene and from a stage on.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "scene.h"

static void said_twice(struct nb_reader *reader, int line) {
  nb_token_mistake(reader, &reader->tokens[0], NULL, "`%s` is said twice: first on line %d", reader->tokens[0].text,
                   line);
}

/* What a step may be a share of. */
static bool take_share_of(struct nb_reader *reader, enum nb_step_kind *kind) {
  static const struct {
    const char *word;
    enum nb_step_kind kind;
  } steps[] = {{"critical", NB_STEP_CRITICAL},
               {"safe", NB_STEP_SAFE},
               {"contact", NB_STEP_CONTACT},
               {"rayleigh", NB_STEP_RAYLEIGH},
               {"rayleigh-mean", NB_STEP_RAYLEIGH_MEAN},
               {"rayleigh-fit", NB_STEP_RAYLEIGH_FIT},
               {"rayleigh-fit-mean", NB_STEP_RAYLEIGH_FIT_MEAN}};
  const struct nb_token *token = nb_token_peek(reader);
  char hint[NB_HINT_SIZE];
  struct nb_guess guess = nb_guess_begin(token ? token->text : "");
  for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
    if (nb_token_skip(reader, steps[i].word)) {
      *kind = steps[i].kind;
      return true;
    }
    nb_guess_offer(&guess, steps[i].word);
  }
  nb_expected(reader, nb_guess_hint(&guess, hint),
              "`safe`, `contact`, `critical`, `rayleigh`, `rayleigh-mean`, `rayleigh-fit` or `rayleigh-fit-mean`");
  return false;
}

static bool follows(const struct nb_reader *reader, const char *word) {
  return reader->next + 1 < reader->count && strcmp(reader->tokens[reader->next + 1].text, word) == 0;
}

/* TIME, F of something, or N per contact. */
NB_APPLY(nb_apply_step) {
  struct nb_scene_reading *reading = subject;
  struct nb_stage *stage = nb_stage_now(reading->scene);
  struct nb_step *here = stage ? &stage->step : &reading->scene->step;
  bool share = follows(reader, "of"), per = follows(reader, "per");
  bool setting = reader == &reading->setting;
  struct nb_step step = {.kind = NB_STEP_TIME, .line = setting ? 0 : (int)reader->line, .set = setting};
  (void)record;
  if (!nb_take_number(reader, share || per ? NB_UNIT_NUMBER : NB_UNIT_TIME, NB_POSITIVE, &step.value))
    return;
  if (share && (!nb_take_word(reader, "of") || !take_share_of(reader, &step.kind)))
    return;
  if (per) {
    if (!nb_take_word(reader, "per") || !nb_take_word(reader, "contact"))
      return;
    step.kind = NB_STEP_CONTACT, step.value = 1 / step.value;
  }
  if (nb_token_peek(reader))
    return; /* which the engine says */
  /* one that is inherited stands above the stage, or below when it is read again */
  if (!setting && here->line > (stage ? stage->line : 0) && here->line < (int)reader->line) {
    said_twice(reader, here->line);
    return;
  }
  if (setting)
    reading->step_set = true;
  else if (reading->step_set)
    step.kind = here->kind, step.value = here->value, step.set = true; /* said and checked, but overridden */
  *here = step;
}

/* `allow unstable`: in the scene for all stages, in a stage for this one. */
NB_APPLY(nb_apply_allow) {
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

NB_APPLY(nb_apply_skin) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  if (scene->skin > 0)
    nb_token_mistake(reader, &reader->tokens[0], NULL, "`skin` is said twice");
  scene->skin = record->value[AT_SKIN].number;
}

/* The word after `con1 X reading`. */
static bool take_reading(struct nb_reader *reader, enum nb_global_damping *kind) {
  static const struct {
    const char *word;
    enum nb_global_damping kind;
  } readings[] = {{"cs79", NB_GLOBAL_CON1_CS79}, {"velocity", NB_GLOBAL_CON1_VELOCITY}, {"all", NB_GLOBAL_CON1_ALL}};
  if (!nb_token_skip(reader, "reading")) {
    nb_expected(reader, NULL, "`reading cs79`, `reading velocity` or `reading all`");
    return false;
  }
  for (size_t i = 0; i < sizeof readings / sizeof *readings; i++) {
    if (!nb_token_skip(reader, readings[i].word))
      continue;
    *kind = readings[i].kind;
    return true;
  }
  nb_expected(reader, NULL, "`cs79`, `velocity` or `all`");
  return false;
}

static const struct damping_word {
  const char *word;
  bool global;
  int kind;
  enum nb_unit_kind unit;
  enum nb_range range;
} damping_words[] = {
    {"contact-beta", false, NB_CONTACT_BETA, NB_UNIT_TIME, NB_NOT_NEGATIVE},
    {"contact-fraction", false, NB_CONTACT_FRACTION, NB_UNIT_NUMBER, NB_NOT_NEGATIVE},
    {"contact-ratio", false, NB_CONTACT_RATIO, NB_UNIT_NUMBER, NB_NOT_NEGATIVE},
    {"global", true, NB_GLOBAL_ALPHA, NB_UNIT_RATE, NB_NOT_NEGATIVE},
    {"con1", true, NB_GLOBAL_CON1_VELOCITY, NB_UNIT_NUMBER, NB_SHARE},
};

static const struct damping_word *take_damping_word(struct nb_reader *reader, bool walls) {
  const struct nb_token *token = nb_token_peek(reader);
  char hint[NB_HINT_SIZE];
  struct nb_guess guess = nb_guess_begin(token ? token->text : "");
  for (size_t i = 0; i < sizeof damping_words / sizeof *damping_words; i++) {
    if (walls && damping_words[i].global)
      continue;
    if (nb_token_skip(reader, damping_words[i].word))
      return &damping_words[i];
    nb_guess_offer(&guess, damping_words[i].word);
  }
  if (walls)
    nb_expected(reader, nb_guess_hint(&guess, hint), "`contact-beta`, `contact-fraction`, `contact-ratio` or `none`");
  else
    nb_expected(reader, nb_guess_hint(&guess, hint),
                "`contact-beta`, `contact-fraction`, `contact-ratio`, `walls`, `critical`, `global`, `con1` or `none`");
  return NULL;
}

/* What one statement says. */
struct said {
  bool all, walls; /* of all contacts; of those with walls alone */
  bool global, deep;
  enum nb_contact_damping contact_kind;
  enum nb_global_damping global_kind;
  double value;
};

/* `critical above 7 %`: of the smaller diameter. */
static bool take_deep(struct nb_reader *reader, struct said *said) {
  said->deep = true;
  return nb_take_word(reader, "above") && nb_take_number(reader, NB_UNIT_NUMBER, NB_POSITIVE, &said->value);
}

static bool take_damping(struct nb_reader *reader, struct said *said) {
  said->walls = nb_token_skip(reader, "walls");
  if (nb_token_skip(reader, "none")) {
    said->all = said->global = said->deep = !said->walls;
    return true;
  }
  if (!said->walls && nb_token_skip(reader, "critical"))
    return take_deep(reader, said);
  const struct damping_word *word = take_damping_word(reader, said->walls);
  if (!word)
    return false;
  said->global = word->global, said->all = !word->global && !said->walls;
  if (word->global)
    said->global_kind = (enum nb_global_damping)word->kind;
  else
    said->contact_kind = (enum nb_contact_damping)word->kind;
  return nb_take_number(reader, word->unit, word->range, &said->value) &&
         (strcmp(word->word, "con1") != 0 || take_reading(reader, &said->global_kind));
}

/* One statement each for what contacts do, for contacts with walls, for those that are deep, and for all bodies; `none` is
 * all of them. In a stage each replaces what it inherits. */
NB_APPLY(nb_apply_damping) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  struct nb_stage *stage = nb_stage_now(scene);
  struct nb_damping *damping = stage ? &stage->damping : &scene->damping;
  const int line = (int)reader->line, since = stage ? stage->line : 0;
  struct said said = {0};
  (void)record;
  if (!take_damping(reader, &said))
    return;
  const struct {
    bool said;
    int *line;
  } parts[] = {{said.all, &damping->contact_line},
               {said.walls, &damping->walls_line},
               {said.global, &damping->global_line},
               {said.deep, &damping->deep_line}};
  for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
    if (parts[k].said && *parts[k].line > since && *parts[k].line < line) {
      said_twice(reader, *parts[k].line);
      return;
    }
  for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
    if (parts[k].said)
      *parts[k].line = line;
  const bool none = said.all && said.global;
  if (said.all)
    damping->contact_kind = said.contact_kind, damping->contact = said.value;
  if (said.walls)
    damping->walls_apart = true, damping->walls_kind = said.contact_kind, damping->walls = said.value;
  if (none)
    damping->walls_apart = false;
  if (said.global)
    damping->global_kind = said.global_kind, damping->global = said.value;
  if (said.deep)
    damping->deep = said.value;
}
