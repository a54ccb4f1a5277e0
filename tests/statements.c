/* Statements of a page, one by one, where a small mistake in reading them would show nowhere else.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef _POSIX_C_SOURCE
#define _POSIX_C_SOURCE 200809L /* mkstemp */
#endif
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../src/input/columns.h"
#include "../src/input/reader.h"
#include "suites.h"
#include "written.h"

#define ROCK "units none\nmaterial rock density 1 kn 1\n"
#define END "disc 5 5 radius 1 rock\nstep 1e-3\nrecord cycle\nstage go\ncycles 1\n"

static struct nb_wall wall_of(const char *statement) {
  struct words page = {0};
  struct written it;
  words_add(&page, ROCK "%s\n" END, statement);
  written_scene(&it, &page);
  const struct nb_wall wall = it.scene.walls[0];
  written_free(&it);
  return wall;
}

/* A point on the wall's line is on it whatever rounding says; one beside it is not, on walls of any size. */
static void a_wall_turns_about_a_point(void) {
  static const double sizes[] = {1e-6, 1e-3, 1, 1e3, 1e6};
  for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++)
    for (int n = -9; n <= 9; n++) {
      const double s = sizes[k], share = 0.37 * n;
      char text[256];
      snprintf(text, sizeof text, "wall w %.17g %.17g to %.17g %.17g rock about %.17g %.17g", 0.1 * s, 0.3 * s, 3.1 * s,
               1.3 * s, (0.1 + 3 * share) * s, (0.3 + share) * s);
      const struct nb_wall on = wall_of(text);
      CU_ASSERT_EQUAL(on.h0, 0);
      CU_ASSERT_DOUBLE_EQUAL(on.h1, -share * sqrt(10) * s, 1e-14 * s * (1 + fabs(share)));
      CU_ASSERT_DOUBLE_EQUAL(on.h2, (1 - share) * sqrt(10) * s, 1e-14 * s * (1 + fabs(share)));
      snprintf(text, sizeof text, "wall w %.17g %.17g to %.17g %.17g rock about %.17g %.17g", 0.1 * s, 0.3 * s, 3.1 * s,
               1.3 * s, (0.1 + 3 * share + 1e-9) * s, (0.3 + share - 3e-9) * s);
      const struct nb_wall beside = wall_of(text);
      CU_ASSERT_DOUBLE_EQUAL(beside.h0, sqrt(10) * 1e-9 * s, 1e-15 * s * (1 + fabs(share)));
    }
}

/* Of two spheres that may touch one must give; a single rigid one may touch what gives. */
static void one_rigid_sphere(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial hard density 1 rigid\nmaterial soft young 1 poisson 0.3\nnormal hertz\n"
                   "sphere 0 1 radius 1 hard\nwall w -9 0 to 9 0 soft\nstep 1e-3\nrecord cycle\nstage go\ncycles 1\n");
  written_scene(&it, &page);
  CU_ASSERT(isinf(it.scene.materials[0].young));
  written_free(&it);
}

/* The columns `a`, or `b`, and `c` of a file, of which c must be above 0: what of them, and how many mistakes. */
static size_t columns(double *sum, size_t *mistakes, bool unitless, const char *text) {
  static const struct nb_wanted wanted[] = {{"a", "b", false}, {"c", NULL, true}};
  char path[] = "/tmp/nineball-columns-XXXXXX";
  struct nb_mistakes said = {0};
  double *values;
  size_t rows;
  const int file = mkstemp(path);
  CU_ASSERT_FATAL(file >= 0);
  CU_ASSERT_FATAL(write(file, text, strlen(text)) == (ssize_t)strlen(text));
  close(file);
  nb_columns_read(&values, &rows, path, wanted, 2, unitless, &said);
  unlink(path);
  *sum = 0, *mistakes = said.count;
  for (size_t k = 0; k < rows; k++)
    *sum += values[2 * k] + 1000 * values[2 * k + 1];
  free(values);
  nb_mistakes_free(&said);
  return rows;
}

static void a_file_of_columns(void) {
  static const struct {
    const char *text;
    size_t rows, mistakes;
    double sum;
    bool unitless;
  } files[] = {
      {"a/m\tc/m\n1\t2\n3\t4\n", 2, 0, 6004, false},
      {"c/m\tx/-\ta/m\n2\t9\t1\n4\t9\t3\n", 2, 0, 6004, false},                   /* in any order, among others */
      {"a/mm\tc/um\n1\t2\n", 1, 0, 1e-3 + 2e-3, false},                           /* each in a unit of its own */
      {"b/km\tc/m\n1\t2\n", 1, 0, 3000, false},                                   /* the other name */
      {"# first\n\n  a/m  c/m\n 1 2\n# between\n\n  3   4\n", 2, 0, 6004, false}, /* blanks */
      {"a/-\tc/-\n1\t2\n", 1, 0, 2001, true},
      {"a/m\tc/m\n1\t2\n", 0, 1, 0, true}, /* a scene without units wants none */
      {"a/-\tc/-\n1\t2\n", 0, 1, 0, false},
      {"a/mm\ta/kN\tc/m\n1\t9\t2\n", 1, 0, 2000.001, false}, /* `a` of another kind does not change the unit */
      {"a/N\tc/m\n1\t2\n", 0, 1, 0, false},
      {"a/m\n1\n", 0, 1, 0, false},
      {"aa/m\tc/m\n1\t2\n", 0, 1, 0, false},
      {"a/m\tc/m\n-1\t1\n", 1, 0, 999, false}, /* only c must be above 0 */
      {"a/m\tc/m\n1\t1e-300\n", 1, 0, 1, false},
  };
  for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
    double sum;
    size_t mistakes;
    const size_t rows = columns(&sum, &mistakes, files[k].unitless, files[k].text);
    if (rows != files[k].rows || mistakes != files[k].mistakes)
      printf("# %s: %zu rows, %zu mistakes\n", files[k].text, rows, mistakes);
    CU_ASSERT_EQUAL(rows, files[k].rows);
    CU_ASSERT_EQUAL(mistakes, files[k].mistakes);
    CU_ASSERT_DOUBLE_EQUAL(sum, files[k].sum, 1e-12);
  }
  double sum;
  size_t mistakes;
  columns(&sum, &mistakes, false, "a/m\tc/m\n1\t0\n");
  CU_ASSERT_EQUAL(mistakes, 1);
  columns(&sum, &mistakes, false, "a/m\tc/m\n1\n");
  CU_ASSERT_EQUAL(mistakes, 1);
  columns(&sum, &mistakes, false, "a/m\tc/m\nx\t1\n1\tx\n");
  CU_ASSERT_EQUAL(mistakes, 2);
}

static double step_of(const char *walls, const char *in_stage) {
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nnormal hertz\nmaterial m density 1 young 1 poisson 0\nmaterial r rigid\n"
            "sphere 0 3 radius 1 m\n%s\nstep 1 of collision\nrecord step\nstage s\n%scycles 1\n",
            walls, in_stage);
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  const double step = written_now(model, "step");
  nb_model_free(model), written_free(&it);
  return step;
}

/* For the step of a contact a wall moves as the first stage sets it going, unless that is a ramp; another wall moves its own way. */
static void walls_of_the_first_stage(void) {
  const char *walls = "wall f -90 0 to 90 0 r\nwall g -90 90 to 90 90 r";
  const double slow = step_of("wall f -90 0 to 90 0 r velocity 0 0.1", "");
  const double fast = step_of("wall g -90 90 to 90 90 r velocity 0 -0.2", "");
  CU_ASSERT_DOUBLE_EQUAL(slow, pow(2, 0.2) * fast, 1e-14 * slow); /* as v^(-1/5) */
  CU_ASSERT_EQUAL(step_of(walls, "wall g velocity 0 5\nwall f velocity 0 0.1\n"), slow);
  CU_ASSERT_EQUAL(step_of(walls, "wall f velocity 0 0.1\nramp wall g velocity 0 -5\n"), slow);
  CU_ASSERT_EQUAL(step_of(walls, "wall g velocity 0 -0.2\nramp wall f velocity 0 5\n"), fast);
}

void suite_statements(void) {
  CU_pSuite suite = CU_add_suite("statements", NULL, NULL);
  CU_add_test(suite, "a wall turns about a point, on its line or beside it", a_wall_turns_about_a_point);
  CU_add_test(suite, "a file of columns", a_file_of_columns);
  CU_add_test(suite, "walls that the first stage sets going", walls_of_the_first_stage);
  CU_add_test(suite, "one of two may be rigid", one_rigid_sphere);
}
