/* A contact test: `contact`, and the prescribed displacements or forces of each `segment`. Its particles, wall and
 * stages (the segments) are stored as in other scenes. A segment, or `--set follow=FILE`, may take its points from a
 * file with columns `approach` (or `overlap`, as in tables of the program) and `slip`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "columns.h"
#include "contact_test_quantities.h"
#include "core/clean.h"
#include "core/names.h"
#include "laws/law.h"
#include "statement.h"

enum { STEPS_DEFAULT = 100 };

enum { AT_NAME };
static const struct nb_argument no_fields[] = {END};
static const struct nb_argument segment_fields[] = {NAME(AT_NAME, "a name for the segment"), END};

/* ---- contact ---- */

static int take_material(const struct nb_scene *scene, struct nb_reader *reader) {
  return nb_material_of(scene, reader, nb_take_token(reader, "the name of a material"));
}

/* Takes a particle, `sphere R MATERIAL` or `disc R MATERIAL`. A contact test has no positions. */
static void take_particle(struct nb_scene *scene, struct nb_reader *reader) {
  const bool sphere = nb_token_skip(reader, "sphere");
  if (!sphere && !nb_token_skip(reader, "disc"))
    nb_expected(reader, NULL,
                scene->particle_count ? "`sphere R MATERIAL`, `disc R MATERIAL` or `wall MATERIAL`"
                                      : "`sphere R MATERIAL` or `disc R MATERIAL`");
  struct nb_particle one = {.shape = sphere ? NB_SPHERE : NB_DISC, .line = (int)reader->line};
  nb_take_number(reader, NB_UNIT_LENGTH, NB_POSITIVE, &one.radius);
  one.material = take_material(scene, reader);
  if (!reader->bad)
    NB_APPEND(reader, scene->particles, scene->particle_count, one);
}

static void take_wall(struct nb_scene *scene, struct nb_reader *reader) {
  const double half = scene->particles[0].radius;
  const struct nb_wall one = {.name = "wall",
                              .ey = 1,
                              .h1 = -half,
                              .h2 = half,
                              .material = take_material(scene, reader),
                              .line = (int)reader->line};
  if (!reader->bad)
    NB_APPEND(reader, scene->walls, scene->wall_count, one);
}

NB_APPLY(apply_contact) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  if (nb_given_twice(reader, reading->contact_line))
    return;
  reading->contact_line = (int)reader->line;
  take_particle(scene, reader);
  if (!nb_take_word(reader, "with"))
    return;
  if (nb_token_skip(reader, "wall"))
    take_wall(scene, reader);
  else
    take_particle(scene, reader);
}

/* ---- segments ---- */

static bool read_points(struct nb_segment *it, const char *path, bool unitless, struct nb_mistakes *mistakes) {
  static const struct nb_wanted_column wanted[] = {{"approach", "overlap", false}, {"slip", NULL, false}};
  double *lengths;
  size_t rows;
  const bool whole = nb_columns_read(&lengths, &rows, path, wanted, 2, unitless, mistakes);
  it->points = calloc(rows + 1, sizeof *it->points);
  for (size_t k = 0; k < rows && it->points; k++)
    it->points[it->point_count++] = (struct nb_path_point){.approach = lengths[2 * k], .slip = lengths[2 * k + 1]};
  free(lengths);
  return whole;
}

static bool take_target(struct nb_reader *reader, struct nb_target *target, bool force, bool normal) {
  target->force = force;
  target->relative = nb_token_skip(reader, "by");
  if (!target->relative && !nb_token_skip(reader, "to")) {
    char hint[NB_HINT_SIZE];
    const struct nb_token *const token = nb_token_peek(reader);
    const char *const word = reader->tokens[reader->next - 1].text;
    snprintf(hint, sizeof hint, "write `%s to VALUE`, or for a change `%s by VALUE`", word, word);
    return token ? nb_token_mistake(reader, token, hint, "expected `to` or `by`, found `%.80s`", token->text)
                 : nb_expected(reader, hint, "`to` or `by`");
  }
  const bool no_tension = normal && force && !target->relative; /* the normal force is compressive */
  return nb_take_number(reader, force ? NB_UNIT_FORCE : NB_UNIT_LENGTH, no_tension ? NB_NOT_NEGATIVE : NB_ANY,
                        &target->value);
}

enum word { OVERLAP, NORMAL, SLIP, SHEAR, HOLD, IN, FOLLOW, WORDS };
enum part { PART_NORMAL, PART_SHEAR, PART_STEPS, PARTS }; /* the parts of a segment, each at most once */

static enum word take_segment_word(struct nb_reader *reader) {
  static const char *const words[] = {"overlap", "normal", "slip", "shear", "hold", "in", "follow"};
  enum word word = OVERLAP;
  while (word < WORDS && !nb_token_skip(reader, words[word]))
    word++;
  return word;
}

static enum part part_of(const struct nb_reader *reader, enum word word) {
  const bool normal = word == OVERLAP || word == NORMAL || (word == HOLD && nb_token_is(reader, "normal"));
  return word == IN ? PART_STEPS : normal ? PART_NORMAL : PART_SHEAR;
}

static bool take_points(struct nb_reader *reader, struct nb_segment *it) {
  char path[NB_PATH_SIZE];
  return (nb_file_named(reader, nb_take_token(reader, "the name of a file"), NULL, path) &&
          read_points(it, path, reader->unitless, reader->mistakes)) ||
         nb_fail_silently(reader);
}

static void take_part(struct nb_reader *reader, struct nb_stage *stage, enum word word, enum part part) {
  struct nb_target *target = part == PART_NORMAL ? &stage->segment.normal : &stage->segment.shear;
  if (word == IN)
    nb_take_count_of(reader, "step", &stage->cycles);
  else if (word == HOLD)
    reader->next++, target->force = true;
  else
    take_target(reader, target, word == NORMAL || word == SHEAR, part == PART_NORMAL);
}

/* Reports a word that cannot follow the given parts of a segment, or a line that ends without an overlap, a slip or a
 * force. */
static bool expected_part(struct nb_reader *reader, const bool given[PARTS]) {
  const bool ends = !nb_token_peek(reader), whole = given[PART_NORMAL] || given[PART_SHEAR];
  return nb_expected(reader, NULL,
                     whole ? "`overlap`, `normal`, `slip`, `shear`, `hold`, `in N steps` or the end of the line"
                     : given[PART_STEPS] ? "`overlap`, `normal`, `slip`, `shear` or `hold`"
                     : ends              ? "`overlap`, `normal`, `slip`, `shear`, `hold` or `follow FILE`"
                            : "`overlap`, `normal`, `slip`, `shear`, `hold`, `in N steps` or `follow FILE`");
}

/* Reports a word after `hold` that is no force. */
static bool cannot_hold(struct nb_reader *reader) {
  char hint[NB_HINT_SIZE];
  const struct nb_token *const token = nb_token_peek(reader);
  struct nb_guess guess = nb_guess_begin(token ? token->text : "");
  nb_guess_offer(&guess, "normal"), nb_guess_offer(&guess, "shear");
  return nb_expected(reader,
                     token && nb_guess_found(&guess)
                         ? nb_guess_hint(&guess, hint)
                         : "overlap and slip stay constant where the segment does not name them",
                     "`normal` or `shear`");
}

/* Takes the parts of a segment, in any order, each at most once. */
static bool take_segment(struct nb_reader *reader, struct nb_stage *stage) {
  static const char *const once[] = {[PART_NORMAL] = "only one of `overlap`, `normal` and `hold normal` in a segment",
                                     [PART_SHEAR] = "only one of `slip`, `shear` and `hold shear` in a segment",
                                     [PART_STEPS] = "only one `in N steps` in a segment"};
  bool given[PARTS] = {false}, any = false;
  for (; nb_token_peek(reader); any = true) {
    const enum word word = take_segment_word(reader);
    if (word == HOLD && !nb_token_is(reader, "normal") && !nb_token_is(reader, "shear"))
      return cannot_hold(reader);
    if (word == FOLLOW && any)
      reader->next--;
    if (word == WORDS || (word == FOLLOW && any))
      return expected_part(reader, given);
    if (word == FOLLOW)
      return take_points(reader, &stage->segment);
    const enum part part = part_of(reader, word);
    if (given[part]) {
      reader->next--;
      return nb_expected(reader, NULL, "%s", once[part]);
    }
    given[part] = true;
    take_part(reader, stage, word, part);
  }
  return given[PART_NORMAL] || given[PART_SHEAR] || expected_part(reader, given);
}

/* A line with a mistake also begins a segment, because the lines below belong to this segment. */
NB_APPLY(apply_segment) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  const struct nb_token *name = record->value[AT_NAME].token;
  struct nb_stage one = {.record_interval = 1, .cycles = STEPS_DEFAULT, .line = (int)reader->line};
  one.segment.normal.relative = one.segment.shear.relative = true;
  if (!scene->contact_test) /* a `segment` in a block of kind `scene`, which has been reported */
    return;
  if (name)
    nb_stage_name(&one, reading, name);
  const int same = NB_FIND(scene->stages, scene->stage_count, one.name);
  if (name)
    nb_exists(reader, name, "segment", same < 0 ? 0 : scene->stages[same].line);
  if (!reader->bad && take_segment(reader, &one) && one.segment.points)
    one.cycles = one.segment.point_count;
  nb_too_many(reader, scene->stage_count, NB_NAMED_MAX, "segments");
  if (scene->stage_count < NB_NAMED_MAX && NB_APPEND(reader, scene->stages, scene->stage_count, one))
    reading->here = NB_IN_SEGMENT;
  else
    free(one.segment.points);
}

/* ---- quantities ---- */

const struct nb_quantity_kind nb_contact_test_kinds[] = {
#define ROW(function, name, unit, needs, bounds, help) {name, NB_OF_CONTACT_TEST, unit, needs, NULL, help, bounds},
    NB_CONTACT_TEST_QUANTITIES(ROW)
#undef ROW
        {NULL, 0, NULL, 0, NULL, NULL, 0}};

/* ---- checks at the end of the page ---- */

/* Applies `--set follow=FILE`: one segment with the points of the file replaces the segments of the page. */
static void replace_segments(struct nb_scene_reading *reading) {
  struct nb_scene *scene = reading->scene;
  struct nb_stage one = {.name = "follow", .record_interval = 1, .check_interval = 1, .snapshot_from = -1};
  for (size_t s = 0; s < scene->stage_count; s++)
    one.snapshot = one.snapshot || scene->stages[s].snapshot;
  nb_stages_free(scene, 0);
  scene->path_replaced = true;
  const bool whole = read_points(&one.segment, reading->follow, reading->reader.unitless, reading->reader.mistakes);
  one.cycles = one.segment.point_count;
  if (!whole || !NB_APPEND(&reading->reader, scene->stages, scene->stage_count, one))
    free(one.segment.points);
}

void nb_contact_test_check(struct nb_scene_reading *reading) {
  struct nb_scene *scene = reading->scene;
  static const char *const default_columns[] = {"step", "overlap", "slip", "normal", "shear"};
  if (!reading->contact_line)
    nb_scene_mistake(reading, "contact", "add `contact sphere R MATERIAL with sphere R MATERIAL`",
                     "expected a contact test with a `contact`, found none");
  if (scene->stage_count == 0 && !reading->follow)
    nb_scene_mistake(reading, "segment",
                     reading->reader.unitless ? "add a line such as `segment NAME overlap to 1e-6 in 10 steps`"
                                              : "add a line such as `segment NAME overlap to 1 um in 10 steps`",
                     "expected a contact test with a `segment`, found none");
  if (reading->follow)
    replace_segments(reading);
  for (size_t k = 0; k < sizeof default_columns / sizeof *default_columns && reading->requested_count == 0; k++) {
    struct nb_column column = {.quantity = {NULL, -1}};
    strcpy(column.name, default_columns[k]);
    nb_quantity_find(&column.quantity, scene, default_columns[k]);
    NB_APPEND(&reading->reader, scene->columns, scene->column_count, column);
  }
}

/* ---- requirements of quantities and snapshots ---- */

/* True if the law reports what the quantities need; stored energies need it of both laws. */
static bool reports(const struct nb_law *law, unsigned needs) {
  const bool normal = strcmp(law->kind, "normal") == 0;
  const bool stored = law->stored || !(needs & NB_REQUEST_STORE);
  const bool loss = normal || law->dissipative || !(needs & NB_REQUEST_LOSS);
  const bool pieces = normal || law->pieces_of || !(needs & NB_REQUEST_PIECES);
  return stored && loss && pieces;
}

/* Reports a mistake at the name of a column, with the laws of the same kind that report it. */
static void report_law(struct nb_scene_reading *reading, const struct nb_requested *requested, const struct nb_law *law,
                       unsigned needs) {
  char hint[NB_HINT_SIZE] = "";
  for (const struct nb_law *const *other = nb_laws(); *other; other++)
    if (strcmp((*other)->kind, law->kind) == 0 && reports(*other, needs))
      nb_append(hint, sizeof hint, "%s`%s %s`", *hint ? ", " : "it is reported by ", law->kind, (*other)->name);
  nb_mistake(reading->reader.mistakes, reading->reader.page, requested->line, requested->column, requested->length,
             hint, "expected a law that reports `%s`; `%s %s` does not", requested->name, law->kind, law->name);
}

void nb_contact_test_laws_check(struct nb_scene_reading *reading) {
  const struct nb_scene *scene = reading->scene;
  const struct nb_law *const laws[] = {nb_law_find("normal", scene->normal), nb_law_find("shear", scene->shear)};
  for (size_t k = 0; k < reading->requested_count; k++)
    for (int shear = 0; shear < 2; shear++)
      if (!reports(laws[shear], scene->columns[k].quantity.kind->fields))
        report_law(reading, &reading->requested[k], laws[shear], scene->columns[k].quantity.kind->fields);
}

/* clang-format off */
NB_STATEMENTS(contact_test) = {
  {"contact", NB_IN_CONTACT_TEST, no_fields, "disc|sphere R MATERIAL with disc|sphere R MATERIAL | with wall MATERIAL", 0, false, apply_contact,
   "Defines the contact that is tested, between two particles or between a particle and a wall. At the start they just touch.\n"
   "disc|sphere R MATERIAL: a length above 0, the radius, and the name of a material.\n"
   "with wall MATERIAL: a wall of this material instead of a second particle.",
   "contact   disc 10 mm steel  with wall steel"},
  {"segment", NB_IN_CONTACT_TEST | NB_IN_SEGMENT, segment_fields, "{overlap|normal to|by X} {slip|shear to|by X} {hold normal|shear} {in N steps} | follow FILE",
   0, true, apply_segment,
   "Prescribes the overlap or the normal force, and the slip or the shear force. Each changes linearly over the segment. Overlap and slip stay constant unless the segment names them.\n"
   "overlap|slip to|by X: a length: `to` a value, or `by` a difference.\n"
   "normal|shear to|by X: a force: `to` a value, or `by` a difference; the normal force is compressive, 0 or more.\n"
   "hold normal|shear: keeps this force constant, in place of the overlap or the slip.\n"
   "in N steps: a whole number, 1 or more; without it: 100. Number of steps.\n"
   "follow FILE: one step to each point of a file. The file has the columns `approach/m` (or `overlap/m`) and `slip/m`, in any unit of length, separated by tabs or by spaces. `nineball --help start` says where the program searches for it.",
   "segment   press  overlap to 10 um  in 5 steps\nsegment   load   shear to 15 N  hold normal\n"
   "segment   back   slip by -2 um  overlap by -1 um  in 1 step"},
  {0},
};
/* clang-format on */
