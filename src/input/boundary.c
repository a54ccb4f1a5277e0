/* Loading of an assembly: its boundary, imposed affine motion, strain of a box of walls.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "loading/loading.h"

#include <string.h>

#include "statement.h"

enum { AT_X, AT_Y, AT_RADIUS };
enum { AT_SXX, AT_SYY, AT_SXY };
enum { AT_APART = NB_AT_AFTER_STRAIN, AT_ACCUMULATED, AT_TWICE };

/* clang-format off */
static const struct nb_argument no_fields[] = {END};
static const struct nb_argument circle_fields[] = {
  VALUE("X", NB_UNIT_LENGTH, NB_ANY, AT_X, "x of the centre."),
  VALUE("Y", NB_UNIT_LENGTH, NB_ANY, AT_Y, "y of the centre."),
  RADIUS(AT_RADIUS),
  END
};
static const struct nb_argument stress_fields[] = {
  VALUE("SXX", NB_UNIT_PRESSURE, NB_ANY, AT_SXX, "Normal stress in x; compression is positive."),
  VALUE("SYY", NB_UNIT_PRESSURE, NB_ANY, AT_SYY, "Normal stress in y."),
  CLAUSE("shear", "SXY", NB_UNIT_PRESSURE, NB_ANY, AT_SXY, 1, "0", "Shear stress, s_xy = s_yx."),
  END
};
static const struct nb_argument strain_fields[] = {STRAIN, END};
static const struct nb_argument box_strain_fields[] = {STRAIN_SIDES, END};
static const struct nb_argument affine_fields[] = {
  STRAIN,
  FLAG("apart", AT_APART, "apart, unless one of the next two is given", "The imposed velocity is not part of the particle's own velocity [R89 4.41]."),
  FLAG("accumulated", AT_ACCUMULATED, "apart",
       "The imposed velocity is added to the particle's own velocity in every cycle and accumulates there, as in R89's program."),
  FLAG("accumulated-twice", AT_TWICE, "apart",
       "As `accumulated`, and the imposed velocity is also added to the relative velocity of two particles in contact, which already contains it, as in R89's program [R89 4.43]."),
  END
};
/* clang-format on */

/* ---- strain rates ---- */

bool nb_value_per_cycle(const struct nb_reader *reader, const struct nb_value *value) {
  const struct nb_token *unit = value->token ? value->token + 1 : NULL;
  return unit && unit < reader->tokens + reader->count && strcmp(unit->text, NB_PER_CYCLE) == 0;
}

struct nb_strain_rate nb_strain_rate_of(struct nb_reader *reader, const struct nb_value value[]) {
  const bool shear = value[NB_AT_XY].token;
  const struct nb_strain_rate rate = {.xx = value[NB_AT_XX].number,
                                      .xy = value[shear ? NB_AT_XY : NB_AT_C12].number,
                                      .yx = value[shear ? NB_AT_XY : NB_AT_C21].number,
                                      .yy = value[NB_AT_YY].number,
                                      .per_cycle = nb_value_per_cycle(reader, &value[NB_AT_XX])};
  if (shear && (value[NB_AT_C12].token || value[NB_AT_C21].token))
    nb_token_mistake(reader, value[NB_AT_XY].token,
                     "remove `shear`, or `c12` and `c21`: `shear G` means `c12 G  c21 G`",
                     "expected `shear`, or `c12` and `c21`, found both");
  for (int k = NB_AT_YY; k <= NB_AT_C21; k++)
    if (value[k].token && nb_value_per_cycle(reader, &value[k]) != rate.per_cycle)
      nb_token_mistake(
          reader, value[k].token, NULL,
          "expected all strain rates of a statement in one kind of unit, `per cycle` or `1/s`, found both");
  return rate;
}

/* ---- the boundary ---- */

NB_APPLY(apply_circle) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  struct nb_stage *stage = nb_current_stage(scene);
  const struct nb_value *value = record->value;
  struct nb_circle *it = stage ? &stage->circle : &scene->circle;
  if (!nb_given_twice(reader, it->line))
    *it = (struct nb_circle){value[AT_X].number, value[AT_Y].number, value[AT_RADIUS].number, (int)reader->line};
}

bool nb_lacks_boundary(const struct nb_scene *scene, struct nb_reader *reader) {
  bool begun = scene->circle.line > 0;
  int removed = 0; /* the line that has removed the last boundary */
  for (size_t s = 0; s < scene->stage_count; s++) {
    begun = begun || scene->stages[s].circle.line > 0;
    if (scene->stages[s].boundary.line && scene->stages[s].boundary.control == NB_CONTROL_NONE)
      begun = false, removed = scene->stages[s].boundary.line;
  }
  if (!begun && nb_statement_suppressed(reader->mistakes, "boundary"))
    nb_fail_silently(reader);
  if (begun)
    return reader->bad;
  if (removed)
    nb_token_mistake(reader, &reader->tokens[0], "begin a new one above this line with `boundary circle X Y radius R`",
                     "expected a boundary in this stage, found that line %d has removed it", removed);
  else
    nb_token_mistake(reader, &reader->tokens[0],
                     NB_DEFINE(reader, "define it above with `boundary circle X Y radius R`"),
                     "expected a scene with a boundary, found none");
  return reader->bad;
}

/* variant 0: strain, 1: stress, 2: fixed, 3: none */
NB_APPLY(apply_boundary) {
  static const enum nb_control controls[] = {NB_CONTROL_STRAIN, NB_CONTROL_STRESS, NB_CONTROL_STRAIN, NB_CONTROL_NONE};
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  struct nb_stage *stage = nb_current_stage(scene);
  const struct nb_value *value = record->value;
  const int variant = record->keyword->variant;
  struct nb_boundary boundary = {.control = controls[variant], .line = (int)reader->line};
  if (variant == 0)
    boundary.strain = nb_strain_rate_of(reader, value);
  if (variant == 1)
    boundary.sxx = value[AT_SXX].number, boundary.syy = value[AT_SYY].number, boundary.sxy = value[AT_SXY].number;
  if (!nb_set_twice(reader, "the control of the boundary", stage->boundary.line) && !nb_lacks_boundary(scene, reader))
    stage->boundary = boundary;
}

/* ---- affine motion, and the box ---- */

/* variant 1: none */
NB_APPLY(apply_affine) {
  struct nb_stage *stage = nb_current_stage(((struct nb_scene_reading *)subject)->scene);
  const struct nb_value *value = record->value;
  const bool accumulated = value[AT_ACCUMULATED].token, twice = value[AT_TWICE].token;
  struct nb_affine_motion affine = {.line = (int)reader->line, .accumulated = accumulated || twice, .twice = twice};
  if (record->keyword->variant == 0)
    affine.strain = nb_strain_rate_of(reader, value);
  if ((value[AT_APART].token != NULL) + accumulated + twice > 1)
    nb_token_mistake(reader, value[accumulated ? AT_ACCUMULATED : AT_TWICE].token, NULL,
                     "expected one of `apart`, `accumulated` and `accumulated-twice`, found several");
  if (!nb_given_twice(reader, stage->affine.line))
    stage->affine = affine;
}

NB_APPLY(apply_box_strain) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  struct nb_stage *stage = nb_current_stage(scene);
  if (nb_lacks_box(scene, reader) || nb_set_twice(reader, "`box strain`", stage->box_line))
    return;
  stage->box = nb_strain_rate_of(reader, record->value);
  stage->box_line = (int)reader->line;
}

/* ---- checks of all stages ---- */

static void report(struct nb_scene_reading *reading, int line, const char *hint, const char *what) {
  nb_line_mistake(&reading->reader, (size_t)line, hint, "%s", what);
}

/* Writes the hint for stage s, in which `wall` moves walls of the box and a servo strains it: a `box strain` with the
 * strain rates that the velocities of the walls mean. */
static void moved_hint(char *hint, const struct nb_scene *scene, size_t s, int first, bool unitless) {
  const struct nb_wall *const walls = &scene->walls[first]; /* south, east, north, west */
  struct nb_wall_motion motion[NB_BOX_SIDES];
  for (size_t side = 0; side < NB_BOX_SIDES; side++)
    motion[side] = nb_wall_motion_after(scene, s + 1, (size_t)first + side);
  const double x = (motion[1].vx - motion[3].vx) / (walls[1].x - walls[3].x),
               y = (motion[2].vy - motion[0].vy) / (walls[2].y - walls[0].y);
  const char *const rate = unitless ? "" : " 1/s";
  if (scene->stages[s].box_line)
    snprintf(hint, NB_HINT_SIZE, "remove `wall` and `walls`, or this line: `box strain` moves opposite walls together");
  else
    snprintf(
        hint, NB_HINT_SIZE,
        "write `box strain %.4g%s %.4g%s` in place of `wall` and `walls`: it moves opposite walls together, and the "
        "servo adds to it what its stress needs",
        x, rate, y, rate);
}

/* What the stages up to the current one have done to the walls of the box. */
struct box_motions {
  bool moved, turned;                /* the current stage moves a wall; a wall has a spin */
  const struct nb_wall_motion *gone; /* the last removal of a wall; NULL: none */
};

static void note_motions(struct box_motions *box, const struct nb_stage *stage, int first) {
  box->moved = false;
  for (size_t m = 0; m < stage->motion_count; m++) {
    const struct nb_wall_motion *const motion = &stage->motions[m];
    if (motion->wall < first || motion->wall >= first + NB_BOX_SIDES)
      continue;
    box->moved = true, box->turned = box->turned || motion->spin != 0;
    box->gone = motion->removed ? motion : box->gone;
  }
}

/* Reports that a wall of a box that follows a strain has a motion of its own, or is removed. */
void nb_box_check(struct nb_scene_reading *reading) {
  const struct nb_scene *scene = reading->scene;
  const int first = nb_box_first_wall(scene);
  char hint[NB_HINT_SIZE];
  struct box_motions box = {.gone = NULL};
  for (size_t s = 0; s < scene->stage_count && first >= 0; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    const int line = stage->box_line ? stage->box_line : stage->servo.box ? stage->servo.line : 0;
    note_motions(&box, stage, first);
    if (!line)
      continue;
    if (box.gone) {
      nb_line_mistake(&reading->reader, (size_t)line, "to move the other walls write `wall NAME velocity VX VY`",
                      "expected a box of four walls, found that line %d has removed wall `%s`", box.gone->line,
                      scene->walls[box.gone->wall].name);
    } else if (box.moved) {
      moved_hint(hint, scene, s, first, reading->reader.unitless);
      report(reading, line, hint,
             "expected `box strain` and `servo`, or `wall` and `walls`, to move the box in this stage, found both");
    } else if (box.turned) {
      report(reading, line, NULL,
             "expected a box whose walls never rotate, found one with a `spin` in this stage or an earlier one");
    }
  }
}

/* Reports a boundary or an `affine` statement in a scene with a cell, because the cell imposes an affine motion on all
 * its particles. */
static void check_cell(struct nb_scene_reading *reading) {
  const struct nb_scene *scene = reading->scene;
  int line = scene->circle.line;
  for (size_t s = 0; s < scene->stage_count && !line; s++)
    line = scene->stages[s].circle.line ? scene->stages[s].circle.line : scene->stages[s].affine.line;
  if (scene->cell.line && line)
    nb_line_mistake(&reading->reader, (size_t)line, "a stage strains the cell with `cell strain`",
                    "expected no `boundary` and no `affine` statement, because the scene has a periodic cell (line %d)",
                    scene->cell.line);
}

/* The line of a stage that imposes motion on particles or walls, other than `cell strain`, or that ends it by `affine
 * none`; 0: none. */
static int imposed_motion_line(const struct nb_stage *stage) {
  const struct nb_strain_rate *rate = &stage->boundary.strain;
  if (rate->xx != 0 || rate->xy != 0 || rate->yx != 0 || rate->yy != 0)
    return stage->boundary.line;
  if (stage->affine.line)
    return stage->affine.line;
  return stage->box_line ? stage->box_line : stage->servo.box ? stage->servo.line : 0;
}

/* The line of `reverse velocities` in a stage. */
static size_t line_of_reverse(const struct nb_page *page, const struct nb_stage *stage) {
  for (size_t line = (size_t)stage->line; line < page->line_count; line++)
    if (strncmp(page->lines[line] + strspn(page->lines[line], " \t"), "reverse", strlen("reverse")) == 0)
      return line + 1;
  return (size_t)stage->line;
}

/* Reports `reverse velocities` together with an imposed motion other than that of a cell, whose strain rate is
 * reversed, too. An imposed motion uses the positions at the beginning of a step, so its displacements are not
 * reversible. */
void nb_imposed_motion_check(struct nb_scene_reading *reading) {
  const struct nb_scene *scene = reading->scene;
  check_cell(reading);
  int line = 0;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    line = line ? line : imposed_motion_line(stage);
    if (stage->reverse_velocities && line)
      nb_line_mistake(
          &reading->reader, line_of_reverse(reading->reader.page, stage), NULL,
          "expected a stage without `reverse velocities`, because of line %d: an imposed motion is not reversible",
          line);
  }
}

/* The direction of a normal strain by the end of its name, 0 for x and 1 for y; -1: another quantity. */
static int strain_axis(const char *name) {
  static const char *const ends[] = {".strain.xx", ".strain.yy", ".strain.width", ".strain.height"};
  const size_t length = strlen(name);
  for (size_t k = 0; k < sizeof ends / sizeof *ends; k++)
    if (length > strlen(ends[k]) && strcmp(name + length - strlen(ends[k]), ends[k]) == 0)
      return (int)k % 2;
  return -1;
}

/* The strain rate of a source in x or y, as given in the stage or inherited; 0: none, or a servo changes it. */
static double rate_along(const struct nb_scene *scene, size_t s, enum nb_affine_source source, int axis) {
  const struct nb_servo *const servo = &scene->stages[s].servo;
  int line;
  nb_affine_given(&scene->stages[s], source, &line);
  const int from = line ? (int)s : nb_affine_inherited(scene, s, source, &line);
  if (from < 0)
    return 0;
  const struct nb_strain_rate *const rate = nb_affine_given(&scene->stages[from], source, &line);
  const struct nb_strain_rate along = {.xx = axis ? 0 : rate->xx, .yy = axis ? rate->yy : 0};
  return servo->line && nb_servo_opposes(servo, &along) ? 0 : along.xx + along.yy;
}

/* True if the strain of a condition counts from an earlier time than the beginning of stage s, so that an earlier stage
 * may have passed the value. */
static bool counts_from_before(const struct nb_scene *scene, size_t s, const struct nb_condition *condition) {
  const int monitor =
      condition->quantity.monitor; /* of a region, because only regions have strains; -1: of the scene */
  return s > 0 && (monitor < 0 || scene->regions[scene->monitors[monitor].a].stage < (int)s);
}

static void warn_of_other_sign(struct nb_scene *scene, size_t s, const struct nb_condition *condition, int axis) {
  const bool above = condition->relation == NB_ABOVE, before = counts_from_before(scene, s, condition);
  const double value = condition->value;
  nb_warn(&scene->warnings, condition->line,
          "stage `%s` %s in %c, and extension is positive: in place of `%s %s %g` write `%s %s %g`%s%s%s",
          scene->stages[s].name, above ? "compresses" : "extends", axis ? 'y' : 'x', condition->name,
          above ? "above" : "below", value,
          !before ? condition->name
          : axis  ? "S.strain.yy"
                  : "S.strain.xx",
          above ? "below" : "above", -value, before ? ", with `region S all from " : "",
          before ? scene->stages[s].name : "",
          before ? "` in the scene: the strain then counts from the beginning of this stage" : "");
}

/* Warns if the condition has the other sign than a strain rate of the stage. */
static void warn_of_sign(struct nb_scene *scene, size_t s, const struct nb_condition *condition) {
  const int axis = strain_axis(condition->name);
  const bool above = condition->relation == NB_ABOVE;
  const double value = condition->value;
  double rate = 0;
  for (int source = NB_AFFINE_FREE; source < NB_AFFINE_SOURCES && axis >= 0; source++)
    rate += rate_along(scene, s, source, axis);
  if (rate == 0 && axis >= 0 && !scene->stages[s].servo.line)
    rate = nb_walls_strain_sign(scene, s, axis);
  if (above ? value > 0 && rate < 0 : value < 0 && rate > 0)
    warn_of_other_sign(scene, s, condition, axis);
}

void nb_strain_check(struct nb_scene *scene) {
  for (size_t s = scene->start.stages; s < scene->stage_count; s++)
    for (size_t k = 0; k < scene->stages[s].condition_count && !nb_is_repeated(scene, s); k++)
      warn_of_sign(scene, s, &scene->stages[s].conditions[k]);
}

/* clang-format off */
NB_STATEMENTS(boundary) = {
  {"boundary circle", NB_IN_SCENE | NB_IN_STAGE, circle_fields, NULL, 0, false, apply_circle,
   "The particles whose centres are on this circle or outside it are the boundary of the assembly, from the start or from this stage on; at first they are fixed. While the boundary is fixed or strained, the circle moves with it, and a particle whose centre crosses the circle joins the boundary [R89 sec. 6.4.1].",
   "boundary  circle 40 mm 40 mm  radius 1 m"},
  {"boundary strain", NB_IN_STAGE, strain_fields, NULL, 0, false, apply_boundary,
   "Moves the centres of the boundary's particles with this strain rate about the circle's centre, from this stage on. The boundary's particles do not rotate, and there is no force between two of them.",
   "stage     squeeze\n  boundary strain -1e-6 per cycle -1e-6 per cycle\n  cycles  10"},
  {"boundary stress", NB_IN_STAGE, stress_fields, NULL, 1, false, apply_boundary,
   "Makes the boundary's particles free and applies a stress to them, from this stage on. The force on each is this stress times the part of the polygon through their centres that belongs to the particle.",
   "stage     load\n  boundary stress 1 kPa 1 kPa\n  cycles  10"},
  {"boundary fixed", NB_IN_STAGE, no_fields, NULL, 2, false, apply_boundary,
   "Fixes the boundary's particles from this stage on.",
   "stage     rest\n  boundary fixed\n  cycles  10"},
  {"boundary none", NB_IN_STAGE, no_fields, NULL, 3, false, apply_boundary,
   "Removes the boundary from this stage on: its particles are free and keep their velocities.",
   "stage     loose\n  boundary none\n  cycles  10"},
  {"box strain", NB_IN_STAGE, box_strain_fields, NULL, 0, false, apply_box_strain,
   "Moves the four walls of the box with this strain rate about the centre of the box, from this stage on. It ends when a stage moves one of the walls by `wall` or `walls`, or removes one; the other walls then stop. Opposite walls move at the same speed in opposite directions. The rate refers to the present width and height: after the time t the width is multiplied by exp(EXX t). The lengths of the walls change with the box, so that its corners stay closed.",
   "stage     narrow\n  box     strain -1e-6 per cycle 1e-7 per cycle\n  cycles  10"},
  {"affine strain", NB_IN_STAGE, affine_fields, NULL, 0, false, apply_affine,
   "Imposes an affine motion of this strain rate on all free particles inside the boundary, from this stage on. The centre of the motion is the centre of the boundary; without a boundary, the origin. Forces and damping change the velocities of the particles relative to the imposed motion [R89 4.41, 4.42].",
   "stage     carry\n  affine  strain -1e-6 per cycle 1e-6 per cycle  shear 1e-7 per cycle\n  cycles  10"},
  {"affine none", NB_IN_STAGE, no_fields, NULL, 1, false, apply_affine,
   "Ends the imposed affine motion of the particles inside the boundary, from this stage on.",
   "stage     stop\n  affine  none\n  cycles  10"},
  {0},
};
/* clang-format on */
