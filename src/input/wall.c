/* Walls, in the scene and in stages: `wall`, `box`, `walls`, `remove wall`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "core/clean.h"
#include "loading/loading.h"
#include "statement.h"

enum { AT_NAME, AT_X, AT_Y, AT_X1, AT_Y1, AT_MATERIAL, AT_ABOUT_X, AT_ABOUT_Y, AT_VX, AT_VY, AT_SPIN };
enum { AT_INWARD, AT_STOP };

/* clang-format off */
static const struct nb_argument box_fields[] = {CORNERS(AT_X, AT_X1), MATERIAL(AT_MATERIAL), END};
static const struct nb_argument wall_fields[] = {
  NAME(AT_NAME, "a name for the wall"),
  VALUE("X", NB_UNIT_LENGTH, NB_ANY, AT_X, "x of the first end."),
  VALUE("Y", NB_UNIT_LENGTH, NB_ANY, AT_Y, "y of the first end."),
  CLAUSE("to", "X Y", NB_UNIT_LENGTH, NB_ANY, AT_X1, 2, NULL, "Second end."),
  MATERIAL(AT_MATERIAL),
  CLAUSE("about", "X Y", NB_UNIT_LENGTH, NB_ANY, AT_ABOUT_X, 2, "the middle of the wall",
         "The point P of the wall [CS79 figure 4]: the wall rotates about P, and `velocity` is the velocity of P. P need not be on the wall."),
  VELOCITY(AT_VX, "0 0"),
  CLAUSE("spin", "W", NB_UNIT_SPIN, NB_ANY, AT_SPIN, 1, "0", "Angular velocity about P, counterclockwise."),
  END
};
static const struct nb_argument walls_fields[] = {
  CLAUSE("inward", "V", NB_UNIT_VELOCITY, NB_ANY, AT_INWARD, 1, "|`stop`",
         "Each wall of the box moves along its normal to the inside with this speed."),
  FLAG("stop", AT_STOP, "|`inward`", "Stops all walls, those outside the box too."),
  END
};
static const struct nb_argument wall_motion_fields[] = {
  WORD("NAME", AT_NAME, "the name of a wall"),
  VELOCITY(AT_VX, "|as before"),
  CLAUSE("spin", "W", NB_UNIT_SPIN, NB_ANY, AT_SPIN, 1, "|as before", "Angular velocity about P, counterclockwise."),
  END
};
/* clang-format on */

/* The hint for an unknown name of a wall: the walls that the scene has. */
static const char *walls_hint(char hint[NB_HINT_SIZE], const struct nb_scene *scene, const struct nb_reader *reader) {
  static const char *const sides[] = {" (bottom)", " (right)", " (top)", " (left)"};
  const int first = nb_box_first_wall(scene);
  if (reader->starts && first < 0)
    return "a page that starts from another has the walls of that page only";
  const size_t shown = scene->wall_count < 8 ? scene->wall_count : 8;
  char list[NB_HINT_SIZE / 2] = "";
  for (size_t k = 0; k < shown; k++) {
    const int side = (int)k - first;
    nb_append_item(list, sizeof list, scene->walls[k].name, false);
    nb_append(list, sizeof list, "%s", first >= 0 && side >= 0 && side < NB_BOX_SIDES ? sides[side] : "");
  }
  snprintf(hint, NB_HINT_SIZE, "%s%s%s%s", shown ? "the scene has the walls " : "", list,
           shown < scene->wall_count ? ", …" : "",
           first >= 0 ? ""
           : shown    ? "; define it above with `wall NAME …` or `box …`"
                      : "define it above with `wall NAME …` or `box …`");
  return hint;
}

int nb_wall_of(const struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *token) {
  char hint[NB_HINT_SIZE];
  const bool known = token && NB_FIND(scene->walls, scene->wall_count, token->text) >= 0;
  if (!known && nb_statement_suppressed(reader->mistakes, "box")) /* a bad `box`, which would define four walls */
    nb_fail_silently(reader);
  return NB_NAMED(reader, token, scene->walls, scene->wall_count, "the name of a wall",
                  walls_hint(hint, scene, reader));
}

bool nb_lacks_box(const struct nb_scene *scene, struct nb_reader *reader) {
  const bool none = nb_box_first_wall(scene) < 0;
  if (none && nb_statement_suppressed(reader->mistakes, "box"))
    nb_fail_silently(reader);
  if (none)
    nb_token_mistake(reader, &reader->tokens[0],
                     reader->starts ? "the page from which this page starts has none"
                                    : NB_DEFINE(reader, "define it before the stages with `box X Y to X Y MATERIAL`"),
                     "expected a scene with a box of walls, found none");
  return reader->bad;
}

bool nb_open_box_hint(char *hint, const struct nb_reader *reader, const struct nb_token *token) {
  char value[4][NB_NAME_SIZE + 12]; /* the corners, each number with its unit */
  struct nb_unit unit;
  double number;
  int count = 0;
  for (size_t k = 1; &reader->tokens[k + 1] < token && count < 4; k++) {
    const struct nb_token *const it = &reader->tokens[k];
    const bool has_unit = nb_unit_read(&unit, it[1].text);
    if (nb_number_read(&number, it->text, 0) == NB_READ)
      snprintf(value[count++], sizeof *value, "%.40s%s%.10s", it->text, has_unit ? " " : "",
               has_unit ? it[1].text : "");
  }
  const char *const material = token[-1].text;
  if (count < 4 || !nb_is_name(material))
    return false;
  const char *const x = value[0], *const y = value[1], *const x1 = value[2], *const y1 = value[3];
  snprintf(hint, NB_HINT_SIZE,
           "a box has four walls; open at the top it is three lines: `wall floor %.24s %.24s to %.24s %.24s %.32s`, "
           "`wall left "
           "%.24s %.24s to %.24s %.24s %.32s` and `wall right %.24s %.24s to %.24s %.24s %.32s`",
           x, y, x1, y, material, x, y1, x, y, material, x1, y, x1, y1, material);
  return true;
}

/* ---- in the scene ---- */

static bool is_of_box(const struct nb_wall *wall) { return wall->inx != 0 || wall->iny != 0; }

/* Adds a wall from the end at wall.x, wall.y to the end at x1, y1; messages point at `place`. */
static void add_wall(struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *place, const char *name,
                     struct nb_wall wall, double x1, double y1) {
  const int same = NB_FIND(scene->walls, scene->wall_count, name);
  const double length = hypot(x1 - wall.x, y1 - wall.y);
  const struct nb_wall *const other = same < 0 ? NULL : &scene->walls[same];
  if (other && (place == reader->tokens || is_of_box(other)))
    nb_token_mistake(reader, place,
                     "`box` makes the walls `south`, `east`, `north` and `west`: a scene has one box, and no other "
                     "wall with one of these names",
                     "there is a wall `%s` already, on line %d", name, other->line);
  else
    nb_exists(reader, place, "wall", other ? other->line : 0);
  if (!isfinite(length))
    nb_token_mistake(reader, place, NULL, "expected a wall of finite length; this one is too long");
  if (!isnormal(length)) /* the vector e would not have the length 1 */
    nb_token_mistake(reader, place, NULL,
                     "expected a wall with a length above 0; its two ends are the same point, or too close");
  if (reader->bad || nb_too_many(reader, scene->wall_count, NB_NAMED_MAX, "walls"))
    return;
  wall.ex = (x1 - wall.x) / length;
  wall.ey = (y1 - wall.y) / length;
  wall.x = wall.x + (x1 - wall.x) / 2;
  wall.y = wall.y + (y1 - wall.y) / 2;
  wall.h1 = -length / 2;
  wall.h2 = length / 2;
  wall.line = (int)reader->line;
  snprintf(wall.name, sizeof wall.name, "%s", name);
  NB_APPEND(reader, scene->walls, scene->wall_count, wall);
}

/* Moves P from the middle of the wall to x, y. A point that is on the wall's line within rounding counts as on the
 * line. */
static void move_pivot(struct nb_wall *wall, double x, double y) {
  const double dx = wall->x - x, dy = wall->y - y, along = dx * wall->ex + dy * wall->ey;
  const double left = dy * wall->ex - dx * wall->ey;
  wall->h0 = fabs(left) > 1e-12 * (wall->h2 + hypot(dx, dy)) ? left : 0;
  wall->h1 += along;
  wall->h2 += along;
  wall->x = x;
  wall->y = y;
}

NB_APPLY(apply_wall) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_value *value = record->value;
  const struct nb_token *name = value[AT_NAME].token;
  const struct nb_wall one = {.x = value[AT_X].number,
                              .y = value[AT_Y].number,
                              .vx = value[AT_VX].number,
                              .vy = value[AT_VY].number,
                              .spin = value[AT_SPIN].number,
                              .material = nb_material_of(scene, reader, value[AT_MATERIAL].token)};
  add_wall(scene, reader, name, name->text, one, value[AT_X1].number, value[AT_Y1].number);
  if (reader->bad)
    return;
  struct nb_wall *const wall = &scene->walls[scene->wall_count - 1];
  wall->has_about = value[AT_ABOUT_X].token != NULL;
  if (wall->has_about)
    move_pivot(wall, value[AT_ABOUT_X].number, value[AT_ABOUT_Y].number);
}

bool nb_corners_swapped(struct nb_reader *reader, double x, double y, double x1, double y1) {
  if (isinf(x1 - x) || isinf(y1 - y))
    nb_token_mistake(reader, &reader->tokens[0], NULL,
                     "expected two corners at a finite distance; these are too far apart");
  else if (!(x1 > x && y1 > y))
    nb_token_mistake(reader, &reader->tokens[0], "write the smaller x and the smaller y before `to`",
                     "expected a second corner with larger x and larger y than the first corner");
  return reader->bad;
}

/* Adds the four walls counterclockwise from the corner with the smallest x and y, so that the inside is to the left of
 * e. */
NB_APPLY(apply_box) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_value *value = record->value;
  const double x0 = value[AT_X].number, y0 = value[AT_Y].number, x1 = value[AT_X1].number, y1 = value[AT_Y1].number;
  const struct nb_token *verb = &reader->tokens[0];
  const int m = nb_material_of(scene, reader, value[AT_MATERIAL].token);
  if (nb_corners_swapped(reader, x0, y0, x1, y1))
    return;
  add_wall(scene, reader, verb, "south", (struct nb_wall){.x = x0, .y = y0, .iny = 1, .material = m}, x1, y0);
  add_wall(scene, reader, verb, "east", (struct nb_wall){.x = x1, .y = y0, .inx = -1, .material = m}, x1, y1);
  add_wall(scene, reader, verb, "north", (struct nb_wall){.x = x1, .y = y1, .iny = -1, .material = m}, x0, y1);
  add_wall(scene, reader, verb, "west", (struct nb_wall){.x = x0, .y = y1, .inx = 1, .material = m}, x0, y0);
}

void nb_outside_check(struct nb_scene *scene) {
  const int first_wall = nb_box_first_wall(scene);
  size_t outside = 0, first = 0;
  for (size_t k = scene->particle_count; k-- > 0 && first_wall >= 0;) {
    const struct nb_particle *particle = &scene->particles[k];
    bool inside = true;
    for (int w = first_wall; w < first_wall + NB_BOX_SIDES; w++) {
      const struct nb_wall *wall = &scene->walls[w];
      inside = inside && (particle->x - wall->x) * wall->inx + (particle->y - wall->y) * wall->iny >= 0;
    }
    if (!inside && !particle->fixed)
      outside++, first = k;
  }
  if (outside == 1)
    nb_warn(&scene->warnings, scene->particles[first].line, "particle %zu begins outside the box", first + 1);
  else if (outside > 0)
    nb_warn(&scene->warnings, scene->particles[first].line,
            "%zu particles begin outside the box; the first is particle %zu", outside, first + 1);
}

/* ---- in a stage ---- */

struct nb_wall_motion nb_wall_motion_after(const struct nb_scene *scene, size_t stages, size_t index) {
  const struct nb_wall *it = &scene->walls[index];
  struct nb_wall_motion motion = {.wall = (int)index, .vx = it->vx, .vy = it->vy, .spin = it->spin};
  for (size_t s = 0; s < stages; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    if (stage->reverse_velocities) /* + 0.0 turns -0 into 0 */
      motion.vx = -motion.vx + 0.0, motion.vy = -motion.vy + 0.0, motion.spin = -motion.spin + 0.0;
    for (size_t i = 0; i < stage->motion_count; i++)
      if (stage->motions[i].wall == (int)index)
        motion = stage->motions[i];
  }
  return motion;
}

int nb_walls_strain_sign(const struct nb_scene *scene, size_t s, int axis) {
  double centre = 0;
  bool compresses = false, extends = false;
  for (size_t p = 0; p < scene->particle_count; p++)
    centre += (axis ? scene->particles[p].y : scene->particles[p].x) / (double)scene->particle_count;
  for (size_t w = 0; w < scene->wall_count; w++) {
    const struct nb_wall *const wall = &scene->walls[w];
    const struct nb_wall_motion motion = nb_wall_motion_after(scene, s + 1, w);
    const bool faces = axis ? fabs(wall->ex) > fabs(wall->ey) : fabs(wall->ey) > fabs(wall->ex);
    const double outward = ((axis ? wall->y : wall->x) - centre) * (axis ? motion.vy : motion.vx);
    compresses = compresses || (faces && outward < 0), extends = extends || (faces && outward > 0);
  }
  return extends - compresses;
}

/* Warns of a wall that rotates about its middle because its line does not say about which point. Opposite walls of a box
 * may rotate alike, because this distorts the box. */
static void warn_of_spin(struct nb_scene *scene, size_t stages, size_t index, double spin, int line) {
  const struct nb_wall *const wall = &scene->walls[index];
  if (spin == 0 || wall->has_about)
    return;
  const bool of_box = is_of_box(wall);
  if (of_box) {
    const size_t first = (size_t)nb_box_first_wall(scene), sides = NB_BOX_SIDES;
    const size_t opposite = first + (index - first + sides / 2) % sides;
    if (nb_wall_motion_after(scene, stages, opposite).spin == spin)
      return;
  }
  const char *const m = scene->unitless ? "" : " m";
  nb_warn(&scene->warnings, line,
          "wall `%s` rotates about its middle: %g%s %g%s; its line in the scene %s `about X Y`, which sets the centre",
          wall->name, wall->x, m, wall->y, m, of_box ? "is a `box`; only a line `wall` can have" : "has no");
}

void nb_spin_check(struct nb_scene *scene) {
  for (size_t w = 0; w < scene->wall_count; w++)
    warn_of_spin(scene, 0, w, scene->walls[w].spin, scene->walls[w].line);
  for (size_t s = 0; s < scene->stage_count; s++)
    for (size_t i = 0; i < scene->stages[s].motion_count; i++) {
      const struct nb_wall_motion *const motion = &scene->stages[s].motions[i];
      warn_of_spin(scene, s + 1, (size_t)motion->wall, motion->spin, motion->line);
    }
}

/* Reports that the stage sets the motion of a wall, or a part of it, again. `given`: what is set again, NB_GIVEN_ bits. */
static void report_again(struct nb_reader *reader, const struct nb_wall *wall, unsigned given) {
  const bool walls = strcmp(reader->tokens[0].text, "walls") == 0;
  nb_token_mistake(reader, &reader->tokens[0],
                   walls ? "in a stage `wall` may stand below `walls`; `walls` then moves the other walls only"
                         : "keep one of the two lines",
                   "the %s of wall `%s` is given twice in this stage",
                   given == NB_GIVEN_SPIN ? "angular velocity" : "velocity", wall->name);
}

/* True, with a message, if the line changes suddenly what another one ramps, or the reverse. The motion of a wall in a
 * stage ramps as a whole. `kept`: what the earlier line has set and this one keeps, NB_GIVEN_ bits. */
static bool ramps_in_part(const struct nb_scene_reading *reading, struct nb_reader *reader,
                          const struct nb_wall_motion *before, unsigned kept) {
  if (!kept || before->ramp == reading->ramping)
    return false;
  nb_token_mistake(reader, &reader->tokens[0],
                   "one line has both: `wall NAME velocity VX VY  spin W`, with or without `ramp`",
                   "expected velocity and spin of wall `%s` with `ramp` or without it, found both in this stage",
                   reading->scene->walls[before->wall].name);
  return true;
}

/* Adds the motion of a wall. In a stage `wall` may follow `walls`, whose motion of this wall it changes. Anything else
 * that is set twice is a mistake. `sets`: what the line sets, NB_GIVEN_ bits. */
static void move_wall(const struct nb_scene_reading *reading, struct nb_reader *reader, struct nb_wall_motion motion,
                      unsigned sets) {
  const struct nb_scene *scene = reading->scene;
  struct nb_stage *stage = nb_current_stage(reading->scene);
  const unsigned given = sets & NB_GIVEN_WALLS ? NB_GIVEN_WALLS : sets;
  motion.line = (int)reader->line, motion.ramp = reading->ramping, motion.given = given;
  for (size_t i = 0; i < stage->motion_count; i++) {
    struct nb_wall_motion *const before = &stage->motions[i];
    const unsigned kept = (before->given & NB_GIVEN_WALLS ? NB_GIVEN_VELOCITY : before->given) & ~sets;
    if (before->wall != motion.wall)
      continue;
    motion.given |= before->given;
    if (before->given & sets)
      report_again(reader, &scene->walls[motion.wall], before->given & sets);
    else if (!ramps_in_part(reading, reader, before, kept))
      *before = motion;
    return;
  }
  NB_APPEND(reader, stage->motions, stage->motion_count, motion);
}

/* Reports that an earlier line has removed the wall. True: it has. */
static bool is_removed(const struct nb_scene *scene, struct nb_reader *reader, int wall) {
  const struct nb_wall_motion now = nb_wall_motion_after(scene, scene->stage_count, (size_t)wall);
  if (now.removed)
    nb_token_mistake(reader, &reader->tokens[0], NULL, "wall `%s` is removed already, on line %d",
                     scene->walls[wall].name, now.line);
  return now.removed;
}

void nb_wall_remove(const struct nb_scene_reading *reading, struct nb_reader *reader, const struct nb_token *name) {
  const struct nb_scene *scene = reading->scene;
  struct nb_stage *stage = nb_current_stage(reading->scene);
  const int wall = nb_wall_of(scene, reader, name);
  if (reader->bad || is_removed(scene, reader, wall))
    return;
  const struct nb_wall_motion removed = {.wall = wall, .removed = true, .line = (int)reader->line};
  for (size_t i = 0; i < stage->motion_count; i++) {
    struct nb_wall_motion *const before = &stage->motions[i];
    if (before->wall != wall)
      continue;
    if (before->given & NB_GIVEN_WALLS)
      *before = removed;
    else
      nb_token_mistake(reader, &reader->tokens[0], "a removed wall does not move: keep one of the two lines",
                       "wall `%s` is moved by this stage, on line %d", scene->walls[wall].name, before->line);
    return;
  }
  NB_APPEND(reader, stage->motions, stage->motion_count, removed);
}

NB_APPLY(apply_walls) {
  const struct nb_scene_reading *reading = subject;
  const struct nb_scene *scene = reading->scene;
  const struct nb_value *inward = &record->value[AT_INWARD], *stop = &record->value[AT_STOP];
  size_t found = 0;
  if (inward->token && stop->token) {
    nb_token_mistake(reader, &reader->tokens[0], NULL, "expected one of `inward V` and `stop`, found both");
    return;
  }
  for (size_t i = 0; i < scene->wall_count; i++) {
    const struct nb_wall *wall = &scene->walls[i];
    if (inward->token && !is_of_box(wall))
      continue;
    struct nb_wall_motion motion = nb_wall_motion_after(scene, scene->stage_count, i);
    found++;
    if (motion.removed)
      continue;
    motion.vx = stop->token ? 0 : wall->inx * inward->number + 0.0; /* + 0.0 turns -0 into 0 */
    motion.vy = stop->token ? 0 : wall->iny * inward->number + 0.0;
    motion.spin = stop->token ? 0 : motion.spin;
    move_wall(reading, reader, motion, NB_GIVEN_WALLS | NB_GIVEN_VELOCITY | (stop->token ? NB_GIVEN_SPIN : 0));
  }
  if (found == 0 && (nb_statement_suppressed(reader->mistakes, "box") ||
                     (stop->token && nb_statement_suppressed(reader->mistakes, "wall"))))
    nb_fail_silently(reader);
  if (found == 0)
    nb_token_mistake(reader, &reader->tokens[0],
                     reader->starts  ? "the page from which this page starts has none"
                     : inward->token ? "define it before the stages with `box X Y to X Y MATERIAL`"
                                     : NULL,
                     "expected a scene with %s, found none", inward->token ? "a box" : "walls");
}

NB_APPLY(apply_wall_motion) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_value *value = record->value;
  const int wall = nb_wall_of(scene, reader, value[AT_NAME].token);
  if (reader->bad || is_removed(scene, reader, wall))
    return;
  struct nb_wall_motion motion = nb_wall_motion_after(scene, scene->stage_count, (size_t)wall);
  unsigned sets = 0;
  if (value[AT_VX].token)
    motion.vx = value[AT_VX].number, motion.vy = value[AT_VY].number, sets |= NB_GIVEN_VELOCITY;
  if (value[AT_SPIN].token)
    motion.spin = value[AT_SPIN].number, sets |= NB_GIVEN_SPIN;
  move_wall(subject, reader, motion, sets);
}

/* clang-format off */
NB_STATEMENTS(wall) = {
  {"box", NB_IN_SCENE, box_fields, NULL, 0, false, apply_box,
   "Adds four walls along the sides of a box. Their names are south (smallest y), east (largest x), north (largest y) and west (smallest x).",
   "box       0 mm 0 mm to 80 mm 80 mm  steel"},
  {"wall", NB_IN_SCENE, wall_fields, NULL, 0, false, apply_wall,
   "Adds a straight wall between two ends. Particles touch it from both sides.",
   "wall      shelf  10 mm 48 mm to 60 mm 48 mm  glass"},
  {"walls", NB_IN_STAGE | NB_IN_RAMP, walls_fields, NULL, 0, false, apply_walls,
   "Moves the four walls of the box inward, or stops all walls, from this stage on.",
   "  walls   inward 1 mm/s"},
  {"wall", NB_IN_STAGE | NB_IN_RAMP, wall_motion_fields, NULL, 0, false, apply_wall_motion,
   "Changes the velocity of a wall's point P, the angular velocity about P, or both, from this stage on.",
   "  wall    shelf  velocity 0 m/s -2 mm/s  spin 0.1 rad/s"},
  {0},
};
/* clang-format on */
