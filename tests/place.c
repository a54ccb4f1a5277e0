/* `transform`: every statement that has a direction is mirrored and rotated with the scene.
 *
 * For each such statement there is a short scene in which the statement matters: without its line the page has an
 * error, or particles move differently. The scene is run as it is and with several transforms; particles and walls must
 * end at the transformed places of the first run.
 *
 * Every keyword of a scene except `transform` must be in one of two lists: `rows` has the statements with a direction,
 * `scalars` the keywords without one. The test fails if a keyword is in neither of them, or if `scalars` has a keyword
 * that takes values with a direction.
 *
 * Tolerance: a transformed scene differs only by rounding, 1e-16 of coordinates below 20, and the runs are so short
 * that contacts amplify this to at most 1e-10; the tolerance is 1e-9. The effect of each line is above 1e-6.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../src/input/scene.h"
#include "suites.h"
#include "written.h"

/* A page consists of HEAD, a transform, `before`, the line under test and `after`. */
#define HEAD                                                                                                           \
  "units none\nmaterial m density 2 kn 1000 ks 700 friction 0.3\nshear linear\ndamping ratio 0.1\nstep "               \
  "0.004\n"
#define FEW "disc 1 2 radius 0.6 m velocity 1 -2\ndisc 2.1 2.3 radius 0.7 m spin 3\ndisc 1.7 3.4 radius 0.5 m\n"
#define MANY "lattice discs hexagonal 7 by 7 from 0.3 0.2 radius 0.5 spacing 0.97 m\n"
#define RING MANY "boundary circle 3.2 2.9 radius 2.1\n"
#define GO "stage go\ncycles 30\nsnapshot\n"
#define STAGE "stage go\n"
#define END "cycles 30\nsnapshot\n"
#define BOX "box 0 0 to 6 7 m\n"
#define WALL "wall floor 0 1.5 to 5 1.2 m about 1 -3\n"
#define CELL "periodic cell -0.2 -0.1 to 6.8 6.2\n"
#define BY " through boundary at most 1e-4 per cycle every 3 cycles\n"

struct row {
  const char *word;
  unsigned where; /* the place of the statement, one bit NB_IN_… */
  const char *before, *line, *after;
};

static const struct row rows[] = {
    {"gravity", NB_IN_SCENE, FEW, "gravity 3 -5\n", GO},
    {"gravity", NB_IN_STAGE, FEW STAGE, "gravity 3 -5\n", END},
    {"gravity", NB_IN_RAMP, FEW STAGE, "ramp gravity 3 -5\n", END},
    {"gravity centripetal", NB_IN_STAGE, FEW STAGE, "gravity centripetal 10 about 4 1\n", END},
    {"gravity centripetal", NB_IN_RAMP, FEW STAGE, "ramp gravity centripetal 10 about 4 1\n", END},
    {"disc", NB_IN_SCENE, FEW, "disc 3 3 radius 0.9 m velocity -4 1 spin 2\n", GO},
    {"sphere", NB_IN_SCENE, FEW, "sphere 3 3 radius 0.9 m velocity -4 1 spin 2\n", GO},
    {"lattice", NB_IN_SCENE, FEW, "lattice discs 2 by 3 from 3 3 radius 0.5 spacing 0.9 m\n", GO},
    {"lattice", NB_IN_SCENE, FEW, "lattice spheres hexagonal 2 by 3 from 3 3 radius 0.5 spacing 0.9 m\n", GO},
    {"fill", NB_IN_SCENE, FEW "grading g 0.4 3\n",
     "fill spheres circle 4 5 radius 1.5 g m seed 1 attempts 1000 else stop\n"
     "fill discs box 4 7 to 6 9 g m seed 1 attempts 1000 else stop\n",
     GO},
    {"box", NB_IN_SCENE, FEW, "box 0.5 1.5 to 2.7 3.8 m\n", GO},
    {"wall", NB_IN_SCENE, FEW, "wall floor 0 1.5 to 5 1.2 m about 1 -3 velocity 0.3 1 spin 0.2\n", GO},
    {"wall", NB_IN_STAGE, FEW WALL STAGE, "wall floor velocity 0.3 1 spin 0.2\n", END},
    {"wall", NB_IN_RAMP, FEW WALL STAGE, "ramp wall floor velocity 0.3 1 spin 0.2\n", END},
    {"walls", NB_IN_STAGE, MANY BOX STAGE, "walls inward 2\n", END},
    {"walls", NB_IN_RAMP, MANY BOX STAGE, "ramp walls inward 2\n", END},
    {"periodic cell", NB_IN_SCENE, MANY, CELL, GO},
    {"cell strain", NB_IN_STAGE, MANY CELL STAGE, "cell strain -0.1 0.05 shear 0.02\n", END},
    {"cell strain", NB_IN_STAGE, MANY CELL STAGE, "cell strain -0.1 0.05 c12 0.1 c21 -0.04\n", END},
    {"perturb wave", NB_IN_SCENE, MANY CELL, "perturb wave 0.3 1 periods 1 2\n", GO},
    {"impact", NB_IN_SCENE, FEW "disc 9 9 radius 0.5 m spin 2\nmonitor C disc 4 with disc 2\n",
     "impact C speed 3 angle 0.7\n", GO},
    {"region", NB_IN_SCENE, RING, "region A circle 2.6 2.5 radius 1.3\n", STAGE "servo xx 90 on A" BY END},
    {"region", NB_IN_SCENE, RING, "region A box 2 2 to 4.2 3\n", STAGE "servo xx 90 xy 10 on A" BY END},
    {"region", NB_IN_SCENE, RING, "region A inside 0.8\n", STAGE "servo yy 90 on A" BY END},
    {"region", NB_IN_SCENE, RING, "region A all\n", STAGE "servo yy 90 xy 20 on A" BY END},
    {"boundary circle", NB_IN_SCENE, MANY, "boundary circle 3.2 2.9 radius 2.1\n", GO},
    {"boundary circle", NB_IN_STAGE, MANY STAGE, "boundary circle 3.2 2.9 radius 2.1\n", END},
    {"boundary strain", NB_IN_STAGE, RING STAGE, "boundary strain -0.1 0.05 shear 0.02\n", END},
    {"boundary strain", NB_IN_STAGE, RING STAGE, "boundary strain -0.1 0.05 c12 0.1 c21 -0.04\n", END},
    {"boundary strain", NB_IN_STAGE, RING STAGE,
     "boundary strain -1e-3 per cycle 5e-4 per cycle shear 2e-4 per cycle\n", END},
    {"boundary stress", NB_IN_STAGE, RING STAGE, "boundary stress 90 30 shear 20\n", END},
    {"affine strain", NB_IN_STAGE, RING STAGE, "affine strain -0.1 0.05 shear 0.02\n", END},
    {"affine strain", NB_IN_STAGE, RING STAGE, "affine strain -0.1 0.05 c12 0.1 c21 -0.04\n", END},
    {"affine strain", NB_IN_STAGE, MANY STAGE, "affine strain -0.01 0.005 c12 0.01 accumulated\n", END},
    {"affine strain", NB_IN_STAGE, MANY STAGE, "affine strain -0.01 0.005 c12 0.01 accumulated-twice\n", END},
    {"servo", NB_IN_STAGE, RING STAGE, "servo isotropic 90 on boundary" BY, END},
    {"servo", NB_IN_STAGE, MANY CELL STAGE, "servo isotropic 90 on cell through cell at most 1e-4 per cycle\n", END},
    {"servo", NB_IN_STAGE, MANY BOX STAGE, "servo isotropic 90 on box through box at most 1e-4 per cycle\n", END},
    {"servo", NB_IN_RAMP, RING STAGE, "ramp servo isotropic 90 on boundary" BY, END},
    {"servo", NB_IN_STAGE, RING STAGE "boundary strain 0.1 -0.1\n", "servo mean 90 on boundary" BY, END},
    {"servo", NB_IN_RAMP, RING STAGE "boundary strain 0.1 -0.1\n", "ramp servo mean 90 on boundary" BY, END},
    {"servo", NB_IN_STAGE, RING STAGE, "servo xx 90 on boundary" BY, END},
    {"servo", NB_IN_STAGE, RING STAGE, "servo yy 90 on boundary through boundary affine at most 1e-4 per cycle\n", END},
    {"servo", NB_IN_STAGE, RING STAGE, "servo xy 20 on boundary" BY, END},
    {"servo", NB_IN_STAGE, RING STAGE, "servo xx 90 yy 40 on boundary" BY, END},
    {"servo", NB_IN_STAGE, RING STAGE, "servo xx 90 yy 40 xy 5 on boundary" BY, END},
    {"servo", NB_IN_STAGE, MANY CELL STAGE, "servo xx 90 xy 20 on cell through cell at most 1e-4 per cycle\n", END},
    {"servo", NB_IN_STAGE, MANY BOX STAGE, "servo xx 90 yy 40 on box through box at most 1e-4 per cycle\n", END},
    {"servo", NB_IN_RAMP, RING STAGE, "ramp servo xx 90 yy 50 xy 20 on boundary" BY, END},
    {"box strain", NB_IN_STAGE, MANY BOX STAGE, "box strain -1e-3 per cycle 5e-4 per cycle\n", END},
};
enum { ROWS = sizeof rows / sizeof *rows };

static const unsigned wheres[] = {NB_IN_SCENE, NB_IN_STAGE, NB_IN_RAMP};
/* Statements without a direction, in a scene, in a stage and after `ramp`. `packing` reads the places of particles,
 * which are transformed like all other particles; `until` waits for recorded quantities, which are not transformed
 * (docs/LANGUAGE.md). */
static const char *const scalars[] = {
    ("|packing|units|let|sweep|start|material|pair|normal|shear|damping|grading|skin|monitor|"
     "step|allow|record|stage|trade|"),
    ("|material|pair|normal|shear|damping|step|allow|record|stage|ramp|cycles|until|snapshot|zero velocities|reverse "
     "velocities|remove|"
     "boundary fixed|boundary none|affine none|rotation on|rotation off|repeat|"),
    "|material|pair|",
};

static const struct {
  const char *line;
  double flip_x, flip_y, angle, x, y;
} places[] = {{"transform mirror x\n", -1, 1, 0, 0, 0},
              {"transform mirror y rotate 1.5707963267948966\n", 1, -1, 1.5707963267948966, 0, 0},
              {"transform rotate 0.7 translate 3 -2\n", 1, 1, 0.7, 3, -2},
              {"transform mirror x rotate 2.5 translate -1 5\n", -1, 1, 2.5, -1, 5}};
enum { PLACES = sizeof places / sizeof *places };

/* Runs the page of a row with this line and this transform, each of which may be empty. Returns false if the page has an
 * error. */
static bool ran(struct nb_result *result, const struct row *row, const char *line, const char *place) {
  struct words words = {0};
  struct nb_mistakes mistakes = {0};
  struct nb_page page = {0};
  struct nb_scene scene = {0};
  struct nb_error error = {0};
  words_add(&words, "```scene\n" HEAD "%s%s%s%s```\n", place, row->before, line, row->after);
  nb_page_read_bytes(&page, "place.md", words.text, words.length, &mistakes);
  nb_scene_read(&scene, &page, 0, NULL, &mistakes);
  const bool right = mistakes.count == 0;
  if (right && nb_run(result, &scene, NULL, NULL, &error)) {
    printf("# %s: %s\n", row->line, error.text);
    CU_FAIL("a scene does not run");
  }
  if (!right && line[0])
    printf("# %s", mistakes.text);
  nb_mistakes_free(&mistakes), nb_scene_free(&scene), nb_page_free(&page);
  free(words.text);
  return right;
}

static double column(const struct nb_table *table, size_t row, const char *name) {
  for (size_t c = 0; c < table->column_count; c++)
    if (strcmp(table->names[c], name) == 0)
      return table->values[row * table->column_count + c];
  CU_FAIL("no such column");
  return NAN;
}

/* The largest difference between the vectors (`x`, `y`) of table b and the transformed vectors of table a. If `shifted`,
 * the vectors are positions, which are translated too. */
static double vectors_off(const struct nb_table *a, const struct nb_table *b, const char *x, const char *y, int place,
                          bool shifted) {
  const double angle = places[place].angle;
  double off = 0;
  for (size_t r = 0; r < a->row_count; r++) {
    const double u = places[place].flip_x * column(a, r, x), v = places[place].flip_y * column(a, r, y);
    const double to_x = cos(angle) * u - sin(angle) * v + shifted * places[place].x;
    const double to_y = sin(angle) * u + cos(angle) * v + shifted * places[place].y;
    off = fmax(off, hypot(column(b, r, x) - to_x, column(b, r, y) - to_y));
  }
  return off;
}

/* The same for angles, angular velocities or moments (`name`). Only a mirror changes them: it reverses their signs. */
static double turns_off(const struct nb_table *a, const struct nb_table *b, const char *name, int place) {
  double off = 0;
  for (size_t r = 0; r < a->row_count; r++)
    off = fmax(off, fabs(column(b, r, name) - places[place].flip_x * places[place].flip_y * column(a, r, name)));
  return off;
}

/* The largest of these differences between two runs. */
static double farthest(const struct nb_result *one, const struct nb_result *other, int place) {
  const struct nb_table *a = &one->snapshots[0].particles, *b = &other->snapshots[0].particles;
  const struct nb_table *walls = &one->snapshots[0].walls, *there = &other->snapshots[0].walls;
  CU_ASSERT_EQUAL_FATAL(a->row_count, b->row_count);
  const double off[] = {vectors_off(a, b, "x", "y", place, true),
                        vectors_off(a, b, "vx", "vy", place, false),
                        vectors_off(a, b, "fx", "fy", place, false),
                        turns_off(a, b, "spin", place),
                        turns_off(a, b, "angle", place),
                        turns_off(a, b, "moment", place),
                        vectors_off(walls, there, "x1", "y1", place, true),
                        vectors_off(walls, there, "x2", "y2", place, true)};
  double most = 0;
  for (size_t k = 0; k < sizeof off / sizeof *off; k++)
    most = off[k] <= most ? most : off[k];
  return most;
}

/* True if the page needs the line, or if the line changes the positions of particles. */
static bool matters(const struct row *row, const struct nb_result *with) {
  struct nb_result without = {0};
  if (!ran(&without, row, "", ""))
    return true; /* the rest of the page needs the line */
  const struct nb_table *a = &with->snapshots[0].particles, *b = &without.snapshots[0].particles;
  double off = a->row_count == b->row_count ? 0 : 1;
  for (size_t r = 0; r < a->row_count && r < b->row_count; r++)
    off = fmax(off, hypot(column(a, r, "x") - column(b, r, "x"), column(a, r, "y") - column(b, r, "y")));
  nb_result_free(&without);
  return off > 1e-6;
}

static void scenes_are_transformed_as_a_whole(void) {
  for (int r = 0; r < ROWS; r++) {
    const struct row *row = &rows[r];
    struct nb_result here = {0};
    CU_ASSERT_FATAL(ran(&here, row, row->line, ""));
    if (!matters(row, &here)) {
      printf("# has no effect: %s", row->line);
      CU_FAIL("a line of the list has no effect");
    }
    for (int place = 0; place < PLACES; place++) {
      struct nb_result there = {0};
      CU_ASSERT_FATAL(ran(&there, row, row->line, places[place].line));
      const double off = farthest(&here, &there, place);
      if (!(off < 1e-9)) {
        printf("# off by %g: %s# %s", off, places[place].line, row->line);
        CU_FAIL("a scene is not transformed as a whole");
      }
      nb_result_free(&there);
    }
    nb_result_free(&here);
  }
}

/* The inward normal of a wall of the box, which references use, points to the middle of the box. */
static void normals_of_the_box_point_inward(void) {
  for (int place = 0; place < PLACES; place++) {
    struct words words = {0};
    struct written it;
    words_add(&words, HEAD FEW BOX "%s" GO, places[place].line);
    written_scene(&it, &words);
    const struct nb_wall *walls = it.scene.walls;
    for (int w = 0; w < 4; w++) {
      const struct nb_wall *wall = &walls[w], *other = &walls[(w + 2) % 4];
      CU_ASSERT_DOUBLE_EQUAL(wall->inx * wall->ex + wall->iny * wall->ey, 0, 1e-15);
      CU_ASSERT_DOUBLE_EQUAL((other->x - wall->x) * wall->inx + (other->y - wall->y) * wall->iny, w % 2 ? 6 : 7, 1e-12);
    }
    written_free(&it);
  }
}

/* ---- completeness of the lists ---- */

static bool one_of(const char *text, const char *const list[]) {
  for (; text && *list; list++)
    if (strcmp(text, *list) == 0)
      return true;
  return false;
}

/* True if the values of an argument depend on directions. */
static bool directed(const struct nb_argument *argument) {
  static const char *const values[] = {"X", "Y", "VX", "VY", "GX", "GY", "EXX", "EYY", "SXX", "SYY", NULL};
  static const char *const words[] = {"xx", "yy", "xy", "shear", "c12", "c21", "spin", "inward", "angle", NULL};
  return argument->count > 1 || one_of(argument->value, values) || one_of(argument->word, words);
}

/* Writes all lines of `rows` with this keyword in this place to `lines`, one after the other. */
static void lines_of(char *lines, size_t size, const char *word, unsigned where) {
  snprintf(lines, size, " ");
  for (int r = 0; r < ROWS; r++)
    if (strcmp(rows[r].word, word) == 0 && rows[r].where == where)
      snprintf(lines + strlen(lines), size - strlen(lines), "%s", rows[r].line);
}

static void every_keyword_is_in_a_list(void) {
  const struct nb_keyword *keyword;
  for (size_t k = 0; (keyword = nb_keyword_row(nb_keywords(), k)); k++)
    for (int w = 0; w < 3; w++) {
      char lines[4096], clause[64], word[64];
      if (!(keyword->where & wheres[w]) || strcmp(keyword->word, "transform") == 0)
        continue;
      lines_of(lines, sizeof lines, keyword->word, wheres[w]);
      snprintf(word, sizeof word, "|%s|", keyword->word);
      bool listed = lines[1] || strstr(scalars[w], word);
      for (const struct nb_argument *argument = keyword->arguments; argument->count; argument++) {
        snprintf(clause, sizeof clause, " %s ", argument->word ? argument->word : "");
        if (directed(argument))
          listed = listed && lines[1] && (!argument->word || strstr(lines, clause));
      }
      if (!listed)
        printf("# in no list, or not with all clauses that have a direction: %s\n", keyword->word);
      CU_ASSERT(listed);
    }
}

/* A computed value has a dimension, and angles are dimensionless. So 1/s is accepted as a spin, rad/s as a rate, a number
 * as an angle, and an angle as a number. */
static void computed_angles_and_numbers(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "let w = 3 * 2 rad/s\nlet r = 2 / (0.25 s)\nlet a = pi / 6\nlet m = 1.5 * 1 rad\n"
                   "material m density 1 g/cm3 kn 1 kN/m friction $m\n"
                   "disc 0 m 0 m radius 1 m m spin $w\ndisc 3 m 0 m radius 1 m m spin (2 * r)\n"
                   "transform rotate $a\ndamping mass $w\nstep 1 ms\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  CU_ASSERT_EQUAL(it.scene.particles[0].spin, 6);
  CU_ASSERT_EQUAL(it.scene.particles[1].spin, 16);
  CU_ASSERT_DOUBLE_EQUAL(it.scene.particles[1].y, 1.5, 1e-15);
  CU_ASSERT_EQUAL(it.scene.damping.global, 6);
  CU_ASSERT_EQUAL(it.scene.materials[0].friction, 1.5);
  written_free(&it);
}

/* A servo through a box controls no shear stress, because the walls do not rotate. A servo through a cell can control
 * it. */
static void controlled_components(void) {
  static const struct {
    const char *place, *servo;
    bool controlled[3];
  } cases[] = {{"box 0 0 to 9 9 m", "isotropic 1 on box through box", {true, true, false}},
               {"box 0 0 to 9 9 m", "yy 1 on box through box", {false, true, false}},
               {"periodic cell 0 0 to 9 9", "isotropic 1 on cell through cell", {true, true, true}},
               {"periodic cell 0 0 to 9 9", "xx 1 xy 2 on cell through cell", {true, false, true}}};
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1 kn 1\n%s\nlattice discs 2 by 2 m radius 1 spacing 3\nstep 0.1\n"
              "stage s\nservo %s at most 1\ncycles 1\n",
              cases[k].place, cases[k].servo);
    written_scene(&it, &page);
    const struct nb_servo *servo = &it.scene.stages[0].servo;
    for (int c = 0; c < 3; c++)
      CU_ASSERT_EQUAL(servo->controlled[c], cases[k].controlled[c]);
    written_free(&it);
  }
}

/* The program rotates by multiples of 90 deg without rounding. It must not take multiples of 91 deg for these. */
static void quarter_turns_and_angles_near_them(void) {
  const double degree = 3.14159265358979323846 / 180;
  for (int n = -4; n <= 4; n++)
    for (int k = 0; k < 4; k++) {
      struct words page = {0};
      struct written it;
      const int unit = k / 2 ? 90 : 91; /* deg */
      const double angle = k % 2 ? n * (unit * degree) : unit * n * degree;
      words_add(&page,
                "units none\nmaterial m density 1 kn 1\ntransform rotate %.17g\ndisc 5 0 radius 1 m\nstep 1\n"
                "record time\nstage s\ncycles 1\n",
                angle);
      written_scene(&it, &page);
      CU_ASSERT_DOUBLE_EQUAL(it.scene.particles[0].x, 5 * cos(angle), 1e-14);
      CU_ASSERT_DOUBLE_EQUAL(it.scene.particles[0].y, 5 * sin(angle), 1e-14);
      written_free(&it);
    }
}

void suite_place(void) {
  CU_pSuite suite = CU_add_suite("place", NULL, NULL);
  CU_add_test(suite, "quarter turns and angles near them", quarter_turns_and_angles_near_them);
  CU_ADD_TEST(suite, scenes_are_transformed_as_a_whole);
  CU_ADD_TEST(suite, normals_of_the_box_point_inward);
  CU_ADD_TEST(suite, every_keyword_is_in_a_list);
  CU_ADD_TEST(suite, computed_angles_and_numbers);
  CU_ADD_TEST(suite, controlled_components);
}
