/* `servo`: stress control.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */

#include <ctype.h>
#include <string.h>

#include "core/clean.h"
#include "core/model.h"
#include "core/names.h"
#include "laws/laws_now.h"
#include "loading/loading.h"
#include "statement.h"

enum { AT_ISOTROPIC, AT_MEAN, AT_XX, AT_YY, AT_XY, AT_ON, AT_THROUGH, AT_AFFINE, AT_MOST };
#define PLACE "a region, `boundary`, `cell`, `box` or `walls`"
#define TARGET(word, at, help) CLAUSE(word, "P", NB_UNIT_PRESSURE, NB_ANY, at, 1, "|not controlled", help)

/* clang-format off */
static const struct nb_argument servo_fields[] = {
  TARGET("isotropic", AT_ISOTROPIC, "Target of xx and yy; the target of xy is 0 [R89 sec. 4.1]. Through a box xy is not controlled, because its walls do not rotate. Compression is positive."),
  TARGET("mean", AT_MEAN, "Target of (xx + yy)/2. The servo changes the area only, so that the shape follows the stage's own strain rates."),
  TARGET("xx", AT_XX, "Target of this component. Give one or more of xx, yy and xy."),
  TARGET("yy", AT_YY, "Target of this component."),
  TARGET("xy", AT_XY, "Target of this component."),
  {"on", "REGION|boundary|cell|box|walls", NB_ARGUMENT_WORD, NB_UNIT_NUMBER, NB_ANY, AT_ON, 1, NULL, PLACE},
  CHOICE("through", "boundary|cell|box", AT_THROUGH, NULL, "what the added strain rate moves: the boundary, the cell or the walls of the box"),
  FLAG("affine", AT_AFFINE, "the boundary alone", "With `through boundary`: the added strain rate is also imposed as an affine motion on the particles inside."),
  CLAUSE("at most", "RATE", NB_UNIT_STRAIN_RATE, NB_POSITIVE, AT_MOST, 1, NULL, "Largest magnitude of the added strain rate."),
  END
};
/* clang-format on */

/* ---- a line that works in this page ---- */

const char *nb_page_place(const struct nb_page *page) {
  static const struct {
    const char *verb, *place;
  } rows[] = {{"periodic", "cell"}, {"box", "box"}, {"boundary", "boundary"}};
  const char *rest;
  for (size_t p = 0; p < 3; p++)
    for (size_t k = 1; k <= page->line_count; k++) {
      if (!nb_page_statement(page, k, rows[p].verb, &rest))
        continue;
      rest += strspn(rest, " \t");
      if (p == 0 || (p == 1 ? !isalpha((unsigned char)*rest) : strncmp(rest, "circle", strlen("circle")) == 0))
        return rows[p].place;
    }
  return NULL;
}

/* Writes the target of a servo as the line means it: for `servo wall west stress 50 kPa` "xx 50 kPa". *number: the index
 * of the number. False: the line has no number. */
static bool target_of(char *text, size_t size, const struct nb_reader *reader, const char **component, size_t *number) {
  static const struct {
    const char *words, *component;
  } meanings[] = {{" xx x sxx sigma_xx stress_xx west east left right lateral horizontal sides ", "xx"},
                  {" yy y syy sigma_yy stress_yy north south top bottom vertical axial ", "yy"},
                  {" xy sxy sigma_xy stress_xy ", "xy"},
                  {" mean ", "mean"}};
  char word[NB_NAME_SIZE + 2];
  double value;
  struct nb_unit unit;
  *component = "isotropic";
  for (*number = 1; *number < reader->count; ++*number) {
    const char *const token = reader->tokens[*number].text, *const dot = strrchr(token, '.');
    if (strcmp(token, "at") == 0) /* the limit is no target */
      return false;
    if (nb_number_read(&value, token, 0) == NB_READ)
      break;
    snprintf(word, sizeof word, " %.60s ", dot ? dot + 1 : token);
    for (size_t k = 0; k < sizeof meanings / sizeof *meanings; k++)
      if (strstr(meanings[k].words, word))
        *component = meanings[k].component;
  }
  if (*number >= reader->count)
    return false;
  const struct nb_token *const token = &reader->tokens[*number];
  const bool has_unit = *number + 1 < reader->count && nb_unit_read(&unit, token[1].text);
  snprintf(text, size, "%s %.40s%s%.10s", *component, token->text, has_unit ? " " : "", has_unit ? token[1].text : "");
  return true;
}

static const char no_box_shear[] = "the servo does not rotate the walls of a box, so it cannot control a shear stress";
static bool shears_box(const char *place, const char *component) {
  return strcmp(place, "box") == 0 && strcmp(component, "xy") == 0;
}

bool nb_servo_hint(char *hint, const struct nb_reader *reader) {
  const char *const place = nb_page_place(reader->page), *const unit = reader->unitless ? "" : " 1/s", *component;
  char target[NB_NAME_SIZE + 2];
  size_t number;
  if (!place || !target_of(target, sizeof target, reader, &component, &number))
    return false;
  if (shears_box(place, component)) {
    snprintf(hint, NB_HINT_SIZE, "%s; components are `xx P` and `yy P`, and `mean P` controls (xx + yy)/2",
             no_box_shear);
    return true;
  }
  snprintf(hint, NB_HINT_SIZE,
           "write `servo %s on %s through %s at most 1e-6 per cycle`; %s control components, and `mean P` controls "
           "(xx + yy)/2",
           target, strcmp(place, "box") == 0 ? "walls" : place, place,
           strcmp(place, "box") == 0 ? "`xx P` and `yy P`" : "`xx P`, `yy P` and `xy P`");
  if (strcmp(place, "box") == 0 && *component != 'i')
    nb_append(hint, NB_HINT_SIZE, ". The servo strains the whole box, so opposite walls move by equal distances");
  if (strcmp(place, "box") == 0 && (*component == 'x' || *component == 'y'))
    nb_append(hint, NB_HINT_SIZE, "; the other direction may have `box strain %s%s %s%s`",
              *component == 'x' ? "0" : "-0.01", unit, *component == 'x' ? "-0.01" : "0", unit);
  return true;
}

/* Notes the condition on the stress that a line with a mistake wants to control, for the hint of an `until` below. */
static void note_wanted(struct nb_scene_reading *reading, const struct nb_reader *reader) {
  const char *const place = nb_page_place(reader->page), *component;
  char target[NB_NAME_SIZE + 2];
  double value;
  size_t number;
  if (!place || !target_of(target, sizeof target, reader, &component, &number) || shears_box(place, component) ||
      nb_number_read(&value, reader->tokens[number].text, 0) != NB_READ)
    return;
  const char *const unit = strrchr(target, ' '); /* or the number */
  const char *const parts[] = {*component == 'i' ? "xx" : component, "yy"};
  *reading->servo_wanted = '\0';
  for (int k = 0; k < (*component == 'i' ? 2 : 1); k++)
    nb_append(reading->servo_wanted, sizeof reading->servo_wanted, "%s%s.stress.%s above %g%.12s", k ? " and " : "",
              strcmp(place, "box") == 0 ? "walls" : place, parts[k], NB_SERVO_NEAR * value,
              isalpha((unsigned char)unit[1]) ? unit : "");
  reading->servo_wanted_line = (int)reader->line;
}

const char *nb_servo_wanted(char *text, size_t size, const struct nb_scene_reading *reading) {
  const struct nb_stage *const stage = nb_current_stage(reading->scene);
  return nb_servo_condition(text, size, reading->scene, &stage->servo, reading->reader.unitless) ? text
         : reading->servo_wanted_line > stage->line                                              ? reading->servo_wanted
                                                                                                 : NULL;
}

/* Refuses `on box` or `through box` in a scene with a cell, and a cell in a scene with a box. True: the place is wrong. */
static bool wrong_place(struct nb_reader *reader, const struct nb_scene *scene, const struct nb_token *token) {
  const bool cell = strcmp(token->text, "cell") == 0,
             box = strcmp(token->text, "box") == 0 || strcmp(token->text, "walls") == 0;
  char hint[NB_HINT_SIZE];
  if (!(box && scene->cell.line) && !(cell && nb_box_first_wall(scene) >= 0))
    return false;
  nb_token_mistake(reader, token, nb_servo_hint(hint, reader) ? hint : NULL,
                   "expected `%s`, because the scene has a %s, found `%s`", box ? "cell" : "box",
                   box ? "periodic cell" : "box of walls", token->text);
  return true;
}

/* Finds the quantities of the measured stress components. */
static void find_stress(struct nb_scene_reading *reading, struct nb_reader *reader, const struct nb_token *place,
                        struct nb_servo *servo) {
  static const char *const parts[] = {"xx", "xy", "yx", "yy"};
  const bool cell = strcmp(place->text, "cell") == 0;
  const bool box = strcmp(place->text, "box") == 0 || strcmp(place->text, "walls") == 0;
  if ((cell && nb_lacks_cell(reading->scene, reader)) || (box && nb_lacks_box(reading->scene, reader)))
    return;
  for (int k = 0; k < 4; k++) {
    char name[3 * NB_NAME_SIZE];
    snprintf(name, sizeof name, "%.63s.stress.%s", place->text, parts[k]);
    if (!nb_quantity_find(&servo->quantity[k], reading->scene, name))
      nb_unknown_name(reader, place, NULL, PLACE);
  }
}

/* Takes the target: `isotropic`, `mean`, or components of the stress. */
static void take_target(struct nb_reader *reader, const struct nb_value *value, struct nb_servo *servo) {
  const bool isotropic = value[AT_ISOTROPIC].token,
             components = value[AT_XX].token || value[AT_YY].token || value[AT_XY].token;
  servo->mean = value[AT_MEAN].token;
  if (isotropic + servo->mean + components != 1)
    nb_token_mistake(reader, &reader->tokens[0], NULL,
                     "expected one target: `isotropic P`, `mean P`, or components `xx P`, `yy P`, `xy P`");
  for (int k = 0; k < 3; k++) {
    const int at = components ? AT_XX + k : isotropic ? AT_ISOTROPIC : AT_MEAN;
    servo->controlled[k] = value[at].token;
    servo->stress[k] = components || k < 2 ? value[at].number : 0;
  }
}

NB_APPLY(apply_servo) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  struct nb_stage *stage = nb_current_stage(scene);
  const struct nb_value *value = record->value;
  if (reader->bad || wrong_place(reader, scene, value[AT_ON].token) ||
      wrong_place(reader, scene, value[AT_THROUGH].token)) {
    note_wanted(reading, reader);
    return;
  }
  const int through = (int)value[AT_THROUGH].number;
  struct nb_servo servo = {.axis_x = {1, 0},
                           .axis_y = {0, 1},
                           .every = 10,
                           .max_rate = value[AT_MOST].number,
                           .per_cycle = nb_value_per_cycle(reader, &value[AT_MOST]),
                           .cell = through == 1,
                           .box = through == 2,
                           .affine = value[AT_AFFINE].token,
                           .ramp = reading->ramping,
                           .line = (int)reader->line};
  take_target(reader, value, &servo);
  find_stress(reading, reader, value[AT_ON].token, &servo);
  if (servo.affine && through != 0)
    nb_token_mistake(reader, value[AT_AFFINE].token, NULL, "expected `affine` only with `through boundary`");
  if (nb_token_skip(reader, "every"))
    nb_take_count_of(reader, "cycle", &servo.every);
  nb_given_twice(reader, stage->servo.line);
  if (servo.box && value[AT_XY].token)
    nb_token_mistake(reader, value[AT_XY].token, no_box_shear,
                     "expected `xx` or `yy` for a servo through a box, found `xy`");
  servo.controlled[2] = servo.controlled[2] && !servo.box;
  (servo.cell ? nb_lacks_cell : servo.box ? nb_lacks_box : nb_lacks_boundary)(scene, reader);
  for (int at = AT_ISOTROPIC; at <= AT_YY && !reader->bad; at++)
    nb_tension_warn(scene, NULL, "servo", servo_fields[at].word, value[at].number, servo.line);
  if (!reader->bad)
    stage->servo = servo;
}

/* True if a particle has friction with the walls of the box, which the scene has, with the properties `now`. */
static bool walls_have_friction(const struct nb_scene *scene, const struct nb_properties *now,
                                const struct nb_law *shear) {
  const int first = nb_box_first_wall(scene);
  bool found = false;
  for (size_t k = 0; k < scene->particle_count && strcmp(shear->name, "none") != 0; k++)
    found = found || nb_properties_pair(now, scene->particles[k].material, scene->walls[first].material).friction > 0;
  return found;
}

/* True if friction at the walls makes the quantity differ from the stress that the servo controls. */
static bool is_other(const char *controlled, struct nb_quantity quantity) {
  const char *const name = quantity.kind->name;
  const bool of_scene = quantity.monitor < 0, walls = strcmp(controlled, "walls.stress") == 0;
  return strcmp(name, !of_scene ? "stress" : walls ? "box.stress" : "walls.stress") == 0 && (of_scene || walls);
}

bool nb_servo_compare(struct nb_scene *scene, size_t s, struct nb_quantity quantity, const char *name, const char *what,
                      int line) {
  const struct nb_servo *const servo = &scene->stages[s].servo;
  const char *const controlled = servo->box && servo->quantity[0].monitor < 0 ? servo->quantity[0].kind->name : "";
  if (!*controlled || !is_other(controlled, quantity))
    return true;
  struct nb_active_laws laws = nb_laws_initial(scene);
  struct nb_properties now = {0};
  if (!nb_properties_create(&now, scene))
    return false;
  for (size_t k = 0; k <= s; k++) {
    laws = nb_laws_of(&scene->stages[k], laws);
    nb_properties_end_stage(&now, &scene->stages[k]);
  }
  if (walls_have_friction(scene, &now, laws.shear))
    nb_warn(&scene->warnings, line,
            "the servo of stage `%s` controls `%s`, and this %s is on `%s`: with friction at the walls the two differ, "
            "and the %s may never hold; write `on %.*s` in the servo",
            scene->stages[s].name, controlled, what, name, what, (int)strcspn(name, "."), name);
  nb_properties_free(&now);
  return true;
}

static enum nb_affine_source source_of(const struct nb_servo *servo) {
  return servo->cell ? NB_AFFINE_CELL : servo->box ? NB_AFFINE_BOX : NB_AFFINE_BOUNDARY;
}

static const char *actuator(const struct nb_servo *servo) {
  return servo->cell ? "cell" : servo->box ? "box" : "boundary";
}

/* Warns of a stage without servo if the strain rate that the servo of the stage before accompanied goes on in it. */
static void warn_of_ended(struct nb_scene *scene, size_t s) {
  if (s == 0 || scene->stages[s].servo.line || !scene->stages[s - 1].servo.line)
    return;
  const struct nb_servo *const ended = &scene->stages[s - 1].servo;
  int line;
  const int from = nb_affine_inherited(scene, s, source_of(ended), &line);
  if (from >= 0 && scene->stages[from].servo.line)
    nb_warn(&scene->warnings, scene->stages[s].line,
            "the servo of stage `%s` ended with it, and the `%s strain` of stage `%s` goes on in stage `%s`: write a "
            "`servo` in this stage, or, if the stress is to be free, the `%s strain` once more",
            scene->stages[s - 1].name, actuator(ended), scene->stages[from].name, scene->stages[s].name,
            actuator(ended));
}

/* Warns of a strain rate of an earlier stage against which the servo of the stage works. */
static void warn_of_inherited(struct nb_scene *scene, size_t s) {
  const struct nb_servo *const servo = &scene->stages[s].servo;
  const enum nb_affine_source source = source_of(servo);
  const char *const word = actuator(servo), *rate = nb_unit(scene, " 1/s");
  int line;
  const int from = servo->line ? nb_affine_inherited(scene, s, source, &line) : -1;
  if (from >= 0 && nb_servo_opposes(servo, nb_affine_given(&scene->stages[from], source, &line)))
    nb_warn(&scene->warnings, servo->line,
            "the servo of stage `%s` works against the `%s strain` of stage `%s`, which goes on; end it by `%s strain "
            "0%s 0%s` in stage `%s`",
            scene->stages[s].name, word, scene->stages[from].name, word, rate, rate, scene->stages[s].name);
}

/* Reports a servo through a boundary on which a stress acts in stage s: its particles move freely, so the strain rate
 * that the servo adds would move nothing. */
static void check_held(struct nb_scene_reading *reading, size_t s) {
  const struct nb_scene *const scene = reading->scene;
  const struct nb_servo *const servo = &scene->stages[s].servo;
  int released = 0; /* the line of the stress; 0: the particles are held */
  for (size_t k = 0; k <= s; k++) {
    const struct nb_stage *const stage = &scene->stages[k];
    released = stage->boundary.line && stage->boundary.control == NB_CONTROL_STRESS ? stage->boundary.line
               : stage->boundary.line || stage->circle.line                         ? 0
                                                                                    : released;
  }
  if (servo->line && !servo->box && released) /* a scene with a cell has no boundary */
    nb_line_mistake(
        &reading->reader, (size_t)servo->line,
        scene->stages[s].boundary.line ? "a stage has either a stress on the boundary or a servo"
                                       : "add `boundary fixed` to this stage",
        "expected a boundary that follows a strain rate, because the servo adds one; since line %d a stress "
        "acts on the boundary, and its particles move freely",
        released);
}

void nb_servo_check(struct nb_scene_reading *reading) {
  struct nb_scene *const scene = reading->scene;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *const stage = &scene->stages[s];
    check_held(reading, s);
    warn_of_inherited(scene, s);
    warn_of_ended(scene, s);
    for (size_t k = 0; k < stage->condition_count; k++)
      if (!nb_servo_compare(scene, s, stage->conditions[k].quantity, stage->conditions[k].name, "condition",
                            stage->conditions[k].line))
        nb_no_memory(&reading->reader);
  }
}

/* clang-format off */
NB_STATEMENTS(servo) = {
  {"servo", NB_IN_STAGE | NB_IN_RAMP, servo_fields, "{every N cycles}", 0, true, apply_servo,
   "Controls a stress in this stage; a servo ends with its stage. It controls the stress of a region, on the boundary, in the cell or on the box, or the mean traction of the box's walls. The servo adds a strain rate to that of the boundary, the cell or the box. Components that are not named are not controlled. The stress of the box is computed from all forces on its walls, the traction of the walls from the normal forces: with friction at the walls the two differ. The program computes the gain from the stiffness of the contacts.\n"
   "every N cycles: a whole number, 1 or more; without it: 10. How often the added strain rate is updated.",
   "stage     walled\n  servo   isotropic 1 kPa  on box  through box  at most 1e-6 per cycle\n  cycles  10\n"
   "stage     even\n  servo   isotropic 1 kPa  on boundary  through boundary affine  at most 1e-6 per cycle\n  cycles  10\n"
   "stage     shear\n  servo   mean 1 kPa  on boundary  through boundary  at most 1e-6 per cycle  every 5 cycles\n  cycles  10\n"
   "stage     biaxial\n  servo   yy 2 kPa  on boundary  through boundary  at most 1e-6 per cycle\n  cycles  10"},
  {0},
};
/* clang-format on */
