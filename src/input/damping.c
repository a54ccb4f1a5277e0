/* `damping`, of the scene and of stages.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "statement.h"

static const struct nb_argument no_fields[] = {END};

static const struct damping_word {
  enum nb_contact_damping contact_kind; /* damping of contacts */
  enum nb_global_damping global_kind;   /* damping of all particles */
  enum nb_unit_kind unit;
  enum nb_range range;
} kinds[] = {
    {NB_CONTACT_STIFFNESS, NB_GLOBAL_UNDAMPED, NB_UNIT_TIME, NB_NOT_NEGATIVE},
    {NB_CONTACT_R89_FRACTION, NB_GLOBAL_UNDAMPED, NB_UNIT_NUMBER, NB_NOT_NEGATIVE},
    {NB_CONTACT_RATIO, NB_GLOBAL_UNDAMPED, NB_UNIT_NUMBER, NB_NOT_NEGATIVE},
    {NB_CONTACT_UNDAMPED, NB_GLOBAL_MASS, NB_UNIT_RATE, NB_NOT_NEGATIVE},
    {NB_CONTACT_UNDAMPED, NB_GLOBAL_CON1_VELOCITY, NB_UNIT_NUMBER, NB_FRACTION},
};
#define CONTACT_WORDS "stiffness|r89-fraction|ratio"
enum { WALLS = 3, CRITICAL, GLOBAL, CON1, CENTRED, LATE, NONE }; /* indices of the words after CONTACT_WORDS */

/* What one statement sets. */
struct given {
  bool all, walls;   /* it sets the damping of all contacts; only of contacts with walls */
  bool global, deep; /* it sets the damping of all particles; of deep contacts */
  bool timing;       /* it sets `centred` */
  bool centred;      /* dashpots use the velocity at the time of the force */
  struct damping_word of;
  double value;
  bool meant; /* the value has a `%` or a name, so a large one is meant */
};

static enum nb_global_damping take_con1(struct nb_reader *reader) {
  static const enum nb_global_damping variants[] = {NB_GLOBAL_CON1_CS79, NB_GLOBAL_CON1_VELOCITY, NB_GLOBAL_CON1_ALL};
  if (!nb_token_skip(reader, "as"))
    nb_expected(reader, "docs/METHOD.md, section Mass-proportional damping, explains the three interpretations",
                "`as cs79`, `as velocity` or `as all`");
  const int variant = nb_take_choice(reader, "cs79|velocity|all");
  return variants[variant < 0 ? 0 : variant];
}

/* True if the value that begins at `number` and has just been taken has a name or ends with `%`. */
static bool is_explicit(const struct nb_reader *reader, const struct nb_token *number) {
  return number->name || strcmp(reader->tokens[reader->next - 1].text, "%") == 0;
}

static void take_damping(struct nb_reader *reader, struct given *given) {
  reader->otherwise = "a fraction of critical damping is `damping ratio 0.2`";
  int word = nb_take_choice(reader, CONTACT_WORDS "|walls|critical|mass|con1|centred|late|none");
  if (word == WALLS) {
    given->walls = true;
    reader->otherwise =
        "`damping walls` damps contacts with walls only; a fraction of critical damping is `damping walls ratio 0.2`";
    word = nb_take_choice(reader, CONTACT_WORDS "|none");
    word = word == WALLS ? NONE : word;
  }
  if (word == NONE)
    given->all = given->global = given->deep = !given->walls;
  given->timing = word >= CENTRED && !given->walls, given->centred = word == CENTRED;
  if (word == CRITICAL)
    reader->otherwise =
        "a fraction of critical damping is `damping ratio 0.2`; contacts that overlap deeply are damped "
        "critically by `damping critical beyond overlap 7 %`";
  if (word == CRITICAL) { /* `beyond overlap 7 %` of the smaller diameter */
    given->deep = nb_take_word(reader, "beyond") && nb_take_word(reader, "overlap");
    nb_take_number(reader, NB_UNIT_NUMBER, NB_POSITIVE, &given->value);
  }
  if (word < 0 || word == CRITICAL || word >= CENTRED)
    return;
  reader->otherwise = NULL;
  given->of = kinds[word < WALLS ? word : WALLS + word - GLOBAL];
  given->global = word >= GLOBAL, given->all = !given->global && !given->walls;
  const struct nb_token *const number = nb_token_peek(reader);
  given->meant = nb_take_number(reader, given->of.unit, given->of.range, &given->value) && is_explicit(reader, number);
  if (word == CON1)
    given->of.global_kind = take_con1(reader);
}

static void take_setting(struct nb_reader *reader, struct given *given) {
  reader->otherwise = "to set another kind from here, give its value a name in the page, `let zeta = 0.1` and `damping "
                      "ratio $zeta`, then write `--set zeta=0.2`";
  const int word = nb_take_choice(reader, "centred|late");
  given->timing = word >= 0, given->centred = word == 0;
}

/* `--set damping=centred` or `--set damping=late` overrides the same words of the page. */
static void take_given(const struct nb_scene_reading *reading, struct nb_reader *reader, struct given *given) {
  const bool setting = reader == &reading->setting;
  (setting ? take_setting : take_damping)(reader, given);
  given->timing = given->timing && (setting || nb_setting_find(reading, "damping") == 0);
}

/* A page may give five settings, with one statement each: the damping of all contacts, of contacts with walls, of deep
 * contacts and of all particles, and the time of the velocity that dashpots use. `none` sets all five. In a stage a
 * statement replaces the inherited setting. */
NB_APPLY(apply_damping) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  struct nb_stage *stage = nb_current_stage(scene);
  struct nb_damping *damping = stage ? &stage->damping : &scene->damping;
  const int line = (int)reader->line, stage_line = stage ? stage->line : 0;
  struct given given = {0};
  take_given(reading, reader, &given);
  const struct {
    const char *name;
    bool given;
    int *line;
  } parts[] = {{"the damping of contacts", given.all, &damping->contact_line},
               {"the damping of contacts with walls", given.walls, &damping->walls_line},
               {"the damping of all particles", given.global, &damping->global_line},
               {"`damping critical`", given.deep, &damping->deep_line},
               {"the time of the dashpots' velocity", given.timing, &damping->centred_line}};
  for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
    if (parts[k].given && *parts[k].line > stage_line && *parts[k].line < line)
      nb_set_twice(reader, parts[k].name, *parts[k].line);
  if (reader->bad)
    return;
  if (given.of.contact_kind == NB_CONTACT_RATIO && given.value > 1 && !given.meant)
    nb_warn(
        &scene->warnings, line,
        "a damping ratio above 1 is more than critical damping: %g is %g %% of it; if that is meant, write `ratio %g "
        "%%`, otherwise `ratio %g %%`",
        given.value, 100 * given.value, 100 * given.value, given.value);
  for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
    if (parts[k].given)
      *parts[k].line = line;
  if (given.all)
    damping->contact_kind = given.of.contact_kind, damping->contact = given.value;
  if (given.walls)
    damping->walls_separate = true, damping->walls_kind = given.of.contact_kind, damping->walls = given.value;
  if (given.all && given.global)
    damping->walls_separate = false;
  if (given.global)
    damping->global_kind = given.of.global_kind, damping->global = given.value;
  if (given.deep)
    damping->deep = given.value;
  if (given.timing)
    damping->centred = given.centred;
}

/* clang-format off */
NB_STATEMENTS(damping) = {
  {"damping", NB_IN_SCENE | NB_IN_STAGE | NB_IN_START, no_fields,
   "{walls} stiffness TIME|ratio X|r89-fraction X | walls none | critical beyond overlap F | mass RATE | "
   "con1 X as cs79|velocity|all | centred | late | none",
   0, false, apply_damping,
   "Sets the damping at contacts [CS79 28] [R89 4.3, 4.13], or of all particles [CS79 34] [R89 sec. 6.5.1]; one statement for each kind of damping; default none. In a stage the damping changes from this stage on.\n"
   "stiffness TIME: a time, 0 or more. Each dashpot has the coefficient c = TIME times the stiffness k of the contact [CS79 28].\n"
   "ratio X: a number, 0 or more. Damping ratio, the fraction of critical damping: c = 2 X sqrt(M* k), M* the reduced mass [R89 4.13].\n"
   "r89-fraction X: a number, 0 or more, for linear springs. c = X k t_c/2, t_c the single-contact step [R89 4.3, 4.4].\n"
   "walls: before one of the three words above, or before `none`: the damping of contacts with walls only; without it: they are damped like all other contacts.\n"
   "critical beyond overlap F: a fraction above 0, such as 7 %. Contacts that overlap by more than this fraction of the smaller diameter are damped critically [R89 sec. 6.4.3].\n"
   "mass RATE: a rate, 0 or more. Mass-proportional damping of all particles: a force RATE times mass times velocity against the motion, and likewise a moment against the rotation [CS79 34].\n"
   "con1 X as cs79|velocity|all: a number from 0 to 1. R89's factor CON1 per cycle; the last word selects what X multiplies: docs/METHOD.md, section Mass-proportional damping.\n"
   "centred: dashpots use the velocity at the time of the force, and act from first touch to the end of the contact. --set damping=centred overrides the page.\n"
   "late: the default: dashpots use the velocity of half a step before [CS79 26, 27]. --set damping=late overrides the page.\n"
   "none: no damping of any kind.",
   "damping   ratio 0.1\ndamping   walls ratio 0.3\ndamping   mass 2 1/s"},
  {0},
};
/* clang-format on */
