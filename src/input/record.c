/* Output of a run: `record QUANTITY …`; in a stage `record every N cycles` and `snapshot`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "core/clean.h"
#include "core/names.h"
#include "old_words.h"
#include "statement.h"

static const struct nb_argument no_fields[] = {END};

static const char *quantity_words(const struct nb_scene *scene) {
  return scene->contact_test ? "a quantity, such as `normal`" : "a quantity, such as `C.normal`";
}

bool nb_take_requested(struct nb_scene_reading *reading, struct nb_reader *reader, struct nb_requested *requested) {
  char hint[NB_HINT_SIZE];
  struct nb_quantity quantity;
  const struct nb_token *token = nb_token_peek(reader);
  const bool known = token && nb_quantity_find(&quantity, reading->scene, token->text);
  if (!known && nb_phrase_hint(hint, reading->scene, &reader->tokens[reader->next], reader->count - reader->next))
    return nb_expected(reader, hint, "%s", quantity_words(reading->scene));
  if (token && strcmp(reader->tokens[0].text, "until") == 0 && !known && nb_pair_hint(hint, "until", token->text))
    return nb_expected(reader, hint, "%s", quantity_words(reading->scene));
  token = nb_take_token(reader, quantity_words(reading->scene));
  if (token && strlen(token->text) >= sizeof requested->name)
    nb_token_mistake(reader, token, NULL, "expected a name shorter than %zu bytes", sizeof requested->name);
  if (reader->bad)
    return false;
  *requested = (struct nb_requested){.line = reader->line, .column = token->column, .length = token->length};
  snprintf(requested->name, sizeof requested->name, "%s", token->text);
  return true;
}

/* Writes the condition for a wait for rest. Without a condition on a stress or on contacts the stage may end before any
 * contact has a force, and without a servo or a condition on the energy in motion. */
static void unbalanced_hint(char *hint, const struct nb_scene_reading *reading) {
  const struct nb_reader *const reader = &reading->reader;
  char text[4 * NB_NAME_SIZE];
  const char *const stress = nb_servo_wanted(text, sizeof text, reading);
  snprintf(hint, NB_HINT_SIZE, "write `until unbalanced.max below %.20s and %s", reader->tokens[3].text,
           stress ? stress : "energy.kinetic below ");
  if (!stress)
    nb_append(hint, NB_HINT_SIZE, "1%s and contacts above 0", reader->unitless ? "e-9" : " nJ");
  nb_append(hint, NB_HINT_SIZE,
            " at most 1000000 cycles`: %s the stage ends at once if no contact has a force. `unbalanced.max` is the "
            "largest unbalanced force over the largest contact force, and the ratio of the means is "
            "`M.unbalanced.mean`, with `region M all`",
            stress ? "without the conditions on the stress"
                   : "an oscillating force crosses zero in motion, so the second condition, an energy far below that "
                     "of the motion, waits for rest; without the last one");
}

/* Writes the hint for an `until` with a strain in a later stage; `strains`: the quantity, or a list that begins with it.
 * False: it is no strain, or the stage is the first one. */
static bool strain_hint(char *hint, const struct nb_scene *scene, const char *strains) {
  char strain[NB_NAME_SIZE];
  snprintf(strain, sizeof strain, "%.*s", (int)strcspn(strains, ","), strains); /* `shear_strain` is `strain.xy` */
  const bool shear = strcmp(strain, "strain.xy") == 0;
  if (scene->stage_count - scene->start.stages < 2 || strncmp(strain, "strain.", 7) != 0)
    return false;
  snprintf(hint, NB_HINT_SIZE,
           "write `region S all from %.63s` in the scene, and here `until S.%.30s %s at most 1000000 cycles`: the "
           "strain since the beginning of this stage, %s. The strains of a box and a cell count from time 0",
           nb_current_stage(scene)->name, strain, shear ? "above 0.05" : "below -0.05",
           shear ? "half of the engineering shear strain" : "negative in compression");
  return true;
}

/* Writes the hint for an `until` with a word for the unbalanced force, or with a strain in a later stage: it
 * counts from the start of a region. False: the line is another. */
static bool until_hint(char *hint, const struct nb_scene_reading *reading, const char *name) {
  const struct nb_reader *const reader = &reading->reader;
  const struct nb_scene *const scene = reading->scene;
  const struct nb_synonym *const synonym = nb_pair_synonym("quantity", name), *const other = nb_synonym(name);
  const char *const ours = synonym ? synonym->ours : other ? other->ours : "";
  if (strcmp(ours, "unbalanced.max") == 0 && reader->next == 2 && reader->count > 3 &&
      !(reader->count > 4 && strcmp(reader->tokens[4].text, "and") == 0)) {
    unbalanced_hint(hint, reading);
    return true;
  }
  return strain_hint(hint, scene, nb_is_quantity(name) ? name : ours);
}

/* Writes the hint for an `until` with the name of a contact alone, `until C ends`; false: the line is another. */
static bool contact_hint(char *hint, const struct nb_scene_reading *reading, const char *name) {
  const struct nb_scene *const scene = reading->scene;
  const int w = NB_FIND(scene->monitors, scene->monitor_count, name);
  if (w < 0 ||
      (scene->monitors[w].kind != NB_MONITOR_PARTICLE_PARTICLE && scene->monitors[w].kind != NB_MONITOR_PARTICLE_WALL))
    return false;
  snprintf(
      hint, NB_HINT_SIZE,
      "to end a stage at the end of the contact, write `until %.63s.overlap below 1e-12 m at most 1000000 cycles` in a "
      "stage that begins during the contact; to end a stage at the first cycle of the contact, write `until "
      "%.63s.overlap above 0 m at most 1000000 cycles`",
      name, name);
  return true;
}

bool nb_requested_find(struct nb_scene_reading *reading, struct nb_quantity *quantity,
                       const struct nb_requested *requested) {
  char hint[NB_HINT_SIZE], bare[NB_HINT_SIZE];
  struct nb_mistakes *mistakes = reading->reader.mistakes;
  if (nb_quantity_find(quantity, reading->scene, requested->name))
    return true;
  if (nb_name_suppressed(mistakes, requested->name))
    return false;
  const bool until = requested->line == reading->reader.line && /* columns are found after the last line */
                     strcmp(reading->reader.tokens[0].text, "until") == 0;
  if (!nb_old_name(hint, requested->name) &&
      !(until && (until_hint(hint, reading, requested->name) || contact_hint(hint, reading, requested->name))))
    nb_quantity_hint(hint, reading->scene, requested->name);
  nb_mistake(mistakes, reading->reader.page, requested->line, requested->column, requested->length,
             reading->reader.unitless ? nb_hint_without_units(bare, hint) : hint, "expected a quantity, found `%s`",
             requested->name);
  return false;
}

/* Reads `record QUANTITY …` in the scene. The quantities are found later, when all monitors are known. */
NB_APPLY(apply_columns) {
  struct nb_scene_reading *reading = subject;
  const struct nb_token *every = NULL; /* in `record every 100 cycles time` the rest of the line is read, too */
  if (nb_token_is(reader, "every") && reader->count > 4) {
    every = nb_token_peek(reader);
    reader->next += 3;
  }
  do {
    struct nb_requested one;
    if (nb_token_is(reader, "every") || nb_token_is(reader, "none"))
      nb_expected(reader,
                  reading->scene->contact_test
                      ? "`record every N steps` or `record none` belongs in a segment: below a line `segment NAME …`"
                      : "`record every N cycles` or `record none` belongs in a stage: below a line `stage NAME`",
                  "%s", quantity_words(reading->scene));
    if (!nb_take_requested(reading, reader, &one) ||
        nb_too_many(reader, reading->requested_count, NB_NAMED_MAX, "columns"))
      return;
    const int same = NB_FIND(reading->requested, reading->requested_count, one.name);
    if (same >= 0)
      nb_token_mistake(reader, &reader->tokens[reader->next - 1], NULL, "`%s` is recorded already, on line %zu",
                       one.name, reading->requested[same].line);
    else
      NB_APPEND(reader, reading->requested, reading->requested_count, one);
  } while (nb_token_peek(reader));
  if (every)
    nb_expected_at(
        reader, every,
        reading->scene->contact_test
            ? "write two lines: `record QUANTITY …`, without `every`, here, and `record every N steps` below a "
              "line `segment`"
            : "write two lines: `record QUANTITY …`, without `every`, here, and `record every N cycles` in a stage",
        quantity_words(reading->scene));
}

/* Refuses an interval in a unit of time, `record every 1 ms`, with its number of cycles; false: it is another interval,
 * or the step is no time. */
static bool is_duration(struct nb_reader *reader, const struct nb_step *step) {
  const struct nb_token *const number = &reader->tokens[reader->next], *const text = number + 1;
  char hint[NB_HINT_SIZE];
  struct nb_unit unit;
  double time;
  if (reader->next + 1 >= reader->count || step->kind != NB_STEP_TIME || step->value <= 0 ||
      !nb_pair_synonym("record", text->text) || !nb_unit_read(&unit, text->text) ||
      nb_quantity_read(&time, number->text, number->computed, &unit) != NB_READ || round(time / step->value) < 2)
    return false;
  snprintf(hint, sizeof hint,
           "the interval is a number of cycles. With a step of %.6g s, %.40s %s is %.6g cycles: `record every %.0f "
           "cycles`",
           step->value, number->text, text->text, time / step->value, round(time / step->value));
  nb_token_mistake(reader, text, hint, "expected `cycles`, found `%.80s`", text->text);
  return true;
}

/* Reads `record every N cycles` or `record none` in a stage. */
NB_APPLY(apply_record) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  unsigned long every = 0;
  if (nb_token_skip(reader, "every") && !is_duration(reader, &nb_current_stage(scene)->step))
    nb_take_count_of(reader, scene->contact_test ? "step" : "cycle", &every);
  else if (!nb_token_skip(reader, "none"))
    nb_expected(reader,
                scene->contact_test ? "`record QUANTITY …` belongs before the first `segment`"
                                    : "`record QUANTITY …` belongs before the first `stage`",
                scene->contact_test ? "`every N steps` or `none`" : "`every N cycles` or `none`");
  if (every > 0 && nb_token_peek(reader))
    nb_expected(reader,
                scene->contact_test ? "`record QUANTITY …` is a line of its own, before the first `segment`"
                                    : "`record QUANTITY …` is a line of its own, before the first `stage`",
                "the end of the line");
  if (nb_given_twice(reader, nb_current_stage(scene)->record_line))
    return;
  nb_current_stage(scene)->record_interval = every;
  nb_current_stage(scene)->record_line = (int)reader->line;
  if (every > 0 && reading->requested_count == 0)
    nb_warn(&scene->warnings, (int)reader->line, "`record every` writes empty rows: no quantity is recorded");
}

bool nb_stage_before_start(const struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *name) {
  const bool before = NB_FIND(scene->stages, scene->start.stages, name->text) >= 0;
  if (before)
    nb_token_mistake(reader, name, "use the first stage of this page, which begins with the state",
                     "expected a stage of this page, found `%s` of the page from which this page starts: the saved "
                     "state holds only the end of its stage `%s`",
                     name->text, scene->stages[scene->start.stages - 1].name);
  return before;
}

/* Reads `snapshot {from STAGE}`. STAGE is this stage or an earlier one of this page. */
NB_APPLY(apply_snapshot) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  struct nb_stage *stage = nb_current_stage(scene);
  stage->snapshot = true;
  if (scene->contact_test || !nb_token_skip(reader, "from"))
    return;
  const struct nb_token *name = nb_take_token(reader, "the name of this stage or of an earlier one");
  if (!name)
    return;
  const int from = NB_FIND(scene->stages, scene->stage_count, name->text);
  if (from >= (int)scene->start.stages)
    stage->snapshot_from = from;
  else if (!nb_stage_before_start(scene, reader, name))
    nb_unknown_name(reader, name, NULL, "the name of this stage or of an earlier one");
}

/* clang-format off */
NB_STATEMENTS(record) = {
  {"record", NB_IN_SCENE | NB_IN_CONTACT_TEST | NB_IN_START, no_fields, "QUANTITY …", 0, false, apply_columns,
   "Names the quantities in the columns of the table. Default of a contact test: step, overlap, slip, normal and shear.\n"
   "QUANTITY …: quantities of the scene, or MONITOR.NAME; section Quantities lists them.",
   "record    time A.x A.vx C.overlap C.normal S.fy energy.kinetic"},
  {"record", NB_IN_STAGE | NB_IN_SEGMENT, no_fields, "every N cycles | none", 0, false, apply_record,
   "Sets how often the table gets a row, for this stage only. A stage or segment without this line gets a row every cycle or step. A peak between two rows is not in the table, so `max`, `min` and `amplitude` of an expectation do not contain it.\n"
   "every N cycles: a whole number, 1 or more; in a contact test `every N steps`.\n"
   "none: the table gets no rows in this stage.",
   "  record  every 10 cycles"},
  {"snapshot", NB_IN_STAGE | NB_IN_SEGMENT, no_fields, "{from STAGE}", 0, false, apply_snapshot,
   "Saves particles, walls and contacts at the end of the stage. In a contact test it saves the traction over the contact and the pieces of the contact's history, so the shear law must be one that stores pieces.\n"
   "from STAGE: this stage or an earlier one. The snapshot also has the changes since the beginning of that stage: displacements and rotations of particles, lost and new contacts, sliding displacements of contacts; without it: no changes.",
   "  snapshot from strike"},
  {0},
};
/* clang-format on */
