/* Statements of a page, in cases in which no other test would detect a small error in the code that reads them.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../src/core/clean.h"
#include "../src/core/names.h"
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

/* If the point after `about` is on the line of the wall, its distance h0 from the line is exactly 0, in spite of
 * rounding. If the point is beside the line, h0 is its distance. Both hold for walls of any size. */
static void a_wall_turns_about_a_point(void) {
  static const double sizes[] = {1e-6, 1e-3, 1, 1e3, 1e6};
  for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++)
    for (int n = -9; n <= 9; n++) {
      const double s = sizes[k], fraction = 0.37 * n;
      char text[256];
      snprintf(text, sizeof text, "wall w %.17g %.17g to %.17g %.17g rock about %.17g %.17g", 0.1 * s, 0.3 * s, 3.1 * s,
               1.3 * s, (0.1 + 3 * fraction) * s, (0.3 + fraction) * s);
      const struct nb_wall on = wall_of(text);
      CU_ASSERT_EQUAL(on.h0, 0);
      CU_ASSERT_DOUBLE_EQUAL(on.h1, -fraction * sqrt(10) * s, 1e-14 * s * (1 + fabs(fraction)));
      CU_ASSERT_DOUBLE_EQUAL(on.h2, (1 - fraction) * sqrt(10) * s, 1e-14 * s * (1 + fabs(fraction)));
      snprintf(text, sizeof text, "wall w %.17g %.17g to %.17g %.17g rock about %.17g %.17g", 0.1 * s, 0.3 * s, 3.1 * s,
               1.3 * s, (0.1 + 3 * fraction + 1e-9) * s, (0.3 + fraction - 3e-9) * s);
      const struct nb_wall beside = wall_of(text);
      CU_ASSERT_DOUBLE_EQUAL(beside.h0, sqrt(10) * 1e-9 * s, 1e-15 * s * (1 + fabs(fraction)));
    }
}

/* Of two materials that may touch, one must be elastic: a single rigid sphere may touch an elastic wall. */
static void one_rigid_sphere(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial hard density 1 rigid\nmaterial soft young 1 poisson 0.3\nnormal hertz\n"
                   "sphere 0 1 radius 1 hard\nwall w -9 0 to 9 0 soft\nstep 1e-3\nrecord cycle\nstage go\ncycles 1\n");
  written_scene(&it, &page);
  CU_ASSERT(isinf(it.scene.materials[0].young));
  written_free(&it);
}

/* Reads the columns `a` (or `b`) and `c` of a file with this text, for a scene without units if `unitless`; c must be
 * above 0. Returns the number of rows. *sum becomes the sum of a + 1000 c, and *mistakes the number of errors. */
static size_t columns(double *sum, size_t *mistakes, bool unitless, const char *text) {
  static const struct nb_wanted_column wanted[] = {{"a", "b", false}, {"c", NULL, true}};
  char path[] = "/tmp/nineball-columns-XXXXXX";
  struct nb_mistakes found = {0};
  double *values;
  size_t rows;
  FILE *file = written_file(path);
  fputs(text, file);
  fclose(file);
  nb_columns_read(&values, &rows, path, wanted, 2, unitless, &found);
  unlink(path);
  *sum = 0, *mistakes = found.count;
  for (size_t k = 0; k < rows; k++)
    *sum += values[2 * k] + 1000 * values[2 * k + 1];
  free(values);
  nb_mistakes_free(&found);
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
      {"c/m\tx/-\ta/m\n2\t9\t1\n4\t9\t3\n", 2, 0, 6004, false},                   /* in any order, between others */
      {"a/mm\tc/um\n1\t2\n", 1, 0, 1e-3 + 2e-3, false},                           /* each in its own unit */
      {"b/km\tc/m\n1\t2\n", 1, 0, 3000, false},                                   /* the other name */
      {"# first\n\n  a/m  c/m\n 1 2\n# between\n\n  3   4\n", 2, 0, 6004, false}, /* spaces */
      {"a/-\tc/-\n1\t2\n", 1, 0, 2001, true},
      {"a/m\tc/m\n1\t2\n", 0, 1, 0, true}, /* not allowed in a scene without units */
      {"a/-\tc/-\n1\t2\n", 0, 1, 0, false},
      {"a/mm\ta/kN\tc/m\n1\t9\t2\n", 1, 0, 2000.001, false}, /* a second `a` with another kind of unit does not count */
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

/* In the collision prediction a wall moves with the velocity that the first stage gives it, unless this velocity ramps;
 * other walls keep their initial velocities. */
static void walls_of_the_first_stage(void) {
  const char *walls = "wall f -90 0 to 90 0 r\nwall g -90 90 to 90 90 r";
  const double slow = step_of("wall f -90 0 to 90 0 r velocity 0 0.1", "");
  const double fast = step_of("wall g -90 90 to 90 90 r velocity 0 -0.2", "");
  CU_ASSERT_DOUBLE_EQUAL(slow, pow(2, 0.2) * fast, 1e-14 * slow); /* proportional to v^(-1/5) */
  CU_ASSERT_EQUAL(step_of(walls, "wall g velocity 0 5\nwall f velocity 0 0.1\n"), slow);
  CU_ASSERT_EQUAL(step_of(walls, "wall f velocity 0 0.1\nramp wall g velocity 0 -5\n"), slow);
  CU_ASSERT_EQUAL(step_of(walls, "wall g velocity 0 -0.2\nramp wall f velocity 0 5\n"), fast);
}

/* ---- statements in the wrong place ---- */

/* Pages with a statement between the two texts. */
static const struct {
  unsigned here;
  const char *before, *behind;
} frames[] = {
    {NB_IN_SCENE, "```scene\nlet speed = 1 m/s\n", "\nstage go\ncycles 1\n```\n"},
    {NB_IN_STAGE, "```scene\nlet speed = 1 m/s\nstage go\n", "\ncycles 1\n```\n"},
    {NB_IN_CONTACT_TEST, "```contact-test\nlet speed = 1 m/s\n", "\nsegment go slip by 1 um\n```\n"},
    {NB_IN_SEGMENT, "```contact-test\nlet speed = 1 m/s\nsegment go slip by 1 um\n", "\n```\n"},
};

/* The words of the message about a statement in the place `here` that is allowed in the places `where`. */
static const char *rightly(unsigned where, unsigned here) {
  const unsigned test = NB_IN_CONTACT_TEST | NB_IN_SEGMENT, scene = NB_IN_SCENE | NB_IN_STAGE;
  if (!(where & (here & test ? test : scene)))
    return here & test ? "in a block of kind `scene`" : "in a block of kind `contact-test`";
  return here == NB_IN_SCENE          ? "in a stage: below a line `stage NAME`"
         : here == NB_IN_STAGE        ? "before the first `stage`"
         : here == NB_IN_CONTACT_TEST ? "in a segment: below a line `segment NAME …`"
                                      : "before the first `segment`";
}

/* Copies to `line` the line of the row's example that begins with the words of the row. The example may have any number
 * of spaces between the words. */
static void example_line(char *line, size_t size, const struct nb_keyword *row) {
  char words[128] = "";
  for (const char *at = row->example; *at && strcmp(words, row->word) != 0;
       at += strcspn(at, "\n"), at += *at == '\n') {
    const char *word = at;
    size_t used = 0;
    snprintf(line, size, "%.*s", (int)strcspn(at, "\n"), at);
    while (used < strlen(row->word)) {
      const size_t blanks = strspn(word, " "), length = strcspn(word + blanks, " \n");
      if (length == 0)
        break;
      used +=
          (size_t)snprintf(words + used, sizeof words - used, "%s%.*s", used ? " " : "", (int)length, word + blanks);
      word += blanks + length;
    }
  }
  CU_ASSERT_STRING_EQUAL(words, row->word);
}

/* Every statement in every place where it is not allowed: the message must say where it belongs. Statements that both
 * kinds of block have are left out. */
static void the_wrong_place(void) {
  static const char *const alike = "|material|pair|repeat|";
  const struct nb_keyword *row;
  size_t wrong = 0;
  for (size_t k = 0; (row = nb_keyword_row(nb_keywords(), k)); k++)
    for (size_t f = 0; f < sizeof frames / sizeof *frames; f++) {
      const unsigned here = frames[f].here;
      char line[256], name[64], expected[160];
      struct words words = {0};
      struct nb_mistakes mistakes = {0};
      struct nb_page page = {0};
      struct nb_scene scene = {0};
      snprintf(name, sizeof name, "|%s|", row->word);
      if (row->where & here || strstr(alike, name))
        continue;
      example_line(line, sizeof line, row);
      words_add(&words, "%s%s%s", frames[f].before, line, frames[f].behind);
      nb_page_read_bytes(&page, "wrong.md", words.text, words.length, &mistakes);
      nb_scene_read(&scene, &page, 0, NULL, &mistakes);
      snprintf(expected, sizeof expected, "belongs %s", rightly(row->where, here));
      if (!mistakes.text || !strstr(mistakes.text, expected)) {
        printf("# no `%s` in the message about `%s`:\n# %s\n", expected, line,
               mistakes.text ? mistakes.text : "nothing");
        CU_FAIL("the message does not say where a statement belongs");
      }
      wrong++;
      nb_mistakes_free(&mistakes), nb_scene_free(&scene), nb_page_free(&page), free(words.text);
    }
  CU_ASSERT(wrong > 100);
}

enum { NAMES_MAX = 400 };

static bool is_listed(char names[NAMES_MAX][2 * NB_NAME_SIZE], size_t count, const char *name) {
  size_t k = 0;
  while (k < count && strcmp(names[k], name) != 0)
    k++;
  return k < count;
}

/* Lists the quantities of a scene and its monitors A, S, C, G and M; returns their number. */
static size_t quantities_of(char names[NAMES_MAX][2 * NB_NAME_SIZE], const struct nb_scene *scene) {
  static const char *const owners[] = {"", "A.", "S.", "C.", "G.", "M."};
  struct nb_quantity_row row;
  struct nb_quantity quantity;
  size_t count = 0;
  for (size_t o = 0; o < sizeof owners / sizeof *owners; o++)
    for (size_t k = 0; nb_quantity_row(&row, k) && count < NAMES_MAX; k++) {
      snprintf(names[count], sizeof names[count], "%s%s", owners[o], row.name);
      count += nb_quantity_find(&quantity, scene, names[count]) && !is_listed(names, count, names[count]);
    }
  return count;
}

/* True if a list has a name, or `NAME.*` for a name of that family, or `*.NAME` for its last part. */
static bool has_name(const char *list, const char *name) {
  const char *const dot = strrchr(name, '.');
  char item[NB_NAME_SIZE], family[2 * NB_NAME_SIZE], suffix[2 * NB_NAME_SIZE];
  snprintf(family, sizeof family, "%.*s.*", dot ? (int)(dot - name) : 0, name);
  snprintf(suffix, sizeof suffix, "*%s", dot ? dot : "");
  while (nb_item(&list, item))
    if (strcmp(item, name) == 0 || strcmp(item, family) == 0 || strcmp(item, suffix) == 0)
      return true;
  return false;
}

/* The names that have each bound, in the order of enum nb_bound. A magnitude, a count, a distance and a kinetic energy are
 * never negative; a fraction of a whole is not above 1; a normal force is a compression with all laws of the program. */
static const char *const bounded[] = {
    "cycle, time, stage.time, contacts, contacts.deep, unbalanced.max, energy.kinetic, step, step.single-contact, "
    "step.stable, step.fracc, step.rayleigh, step.rayleigh-mean, step.rayleigh-fit, step.rayleigh-fit-mean, "
    "boundary.particles, boundary.radius, boundary.area, boundary.roughness, boundary.stress.residual, box.width, "
    "box.height, walls.force.residual, C.overlap, C.sliding, S.obliquity, G.wanted, G.placed, G.dropped, G.attempts, "
    "M.contacts, M.sliding, M.sliding.near, M.stress.residual, M.area, M.particles, M.coordination, "
    "M.coordination.mechanical, M.rattlers, M.constraint_ratio, M.shear.*, M.contact_shear.*, M.contact_ratio.*, "
    "M.obliquity.*, M.unbalanced.mean, M.unbalanced.force, M.speed.mean, M.speed.max, M.speed.imposed, M.speed.ratio, "
    "M.chains, M.chains.length, M.chains.fraction, M.chains.bend, M.contacts.lost, M.contacts.new, impact.angle, "
    "impact.restitution, impact.energy.normal, impact.energy.tangential, impact.energy.rotational, overlap, sliding, "
    "radius, pieces, *.deviator, *.anisotropy, *.std",
    "C.sliding, M.sliding, M.sliding.near, M.chains.fraction, M.porosity, M.porosity.volume, box.porosity, sliding",
    "C.normal, M.normal.*, M.contact_stress.*, impact.normal, normal",
    "contacts, M.contacts, M.particles, M.rattlers, M.chains, M.contacts.lost, M.contacts.new, boundary.particles",
};

static void bounds_of_quantities(void) {
  static char names[NAMES_MAX][2 * NB_NAME_SIZE];
  static const char *const scenes[] = {
      ROCK "box -9 -9 to 9 9 rock\ngrading g 0.1 1\nlattice discs 2 by 1 radius 1 rock\nmonitor A disc 1\n"
           "monitor S wall south\nmonitor C disc 1 with disc 2\nmonitor G grading g\nregion M all\n" END,
      ROCK "periodic cell -9 -9 to 9 9\n" END,
      ("units none\nmaterial m density 1 kn 1 ks 1 friction 1\nwall w -9 0 to 9 0 m\ndisc 0 1 radius 1 m\n"
       "monitor C disc 1 with wall w\nimpact C speed 1 angle (pi/6)\nrecord cycle\nstep 1e-3\nstage go\ncycles 1\n"),
      "path\nunits none\nmaterial m kn 1\ncontact disc 1 m with wall m\nsegment a slip by 1 in 1 steps\n",
  };
  size_t checked = 0;
  for (size_t k = 0; k < sizeof scenes / sizeof *scenes; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page, "%s", scenes[k]);
    written_scene(&it, &page);
    const size_t count = quantities_of(names, &it.scene);
    for (size_t n = 0; n < count; n++) {
      struct nb_quantity quantity;
      unsigned bounds = 0;
      CU_ASSERT_FATAL(nb_quantity_find(&quantity, &it.scene, names[n]));
      for (size_t b = 0; b < sizeof bounded / sizeof *bounded; b++)
        bounds |= has_name(bounded[b], names[n]) ? 1U << b : 0;
      if (nb_quantity_bounds(quantity) != bounds)
        printf("# the bounds of %s\n", names[n]);
      CU_ASSERT_EQUAL(nb_quantity_bounds(quantity), bounds);
    }
    checked += count;
    written_free(&it);
  }
  CU_ASSERT(checked > 300);
}

/* Runs a scene with two stages, which records the names from `from` to `to`, and gets their last values. */
static void last_values(double *values, char names[NAMES_MAX][2 * NB_NAME_SIZE], size_t from, size_t to,
                        const char *scene, const char *strain) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 1 kn 1e3 ks 5e2 friction 0.2\nstep 1e-3\ndamping stiffness 1e-3\n"
                   "damping mass 0.1\nshear linear\n");
  for (int k = 0; k < 9; k++) /* with velocities that compress and shear the contacts */
    words_add(&page, "disc %d %d radius 1.01 m velocity %g %g spin %d\n", 1 + k % 3 * 2, 1 + k / 3 * 2, 0.3 - 0.1 * k,
              k % 2 - 0.4, k % 4 - 1);
  words_add(&page, "%s", scene);
  for (size_t k = from; k < to; k++)
    words_add(&page, "record %s\n", names[k]);
  words_add(&page, "stage go\n%scycles 100\nstage b\nzero velocities\nremove disc 9\n%scycles 100\n", strain, strain);
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  for (size_t k = from; k < to; k++)
    values[k] = written_last(&result, names[k]);
  nb_result_free(&result), written_free(&it);
}

/* A quantity that is recorded alone has the value that it has beside all others: its row states all that it reads. */
static void quantities_alone(void) {
  static const char *const scenes[][2] = {
      {"box 0 0 to 6 6 m\ngravity 0.3 -1\ngrading g 0.1 1\nmonitor A disc 1\nmonitor S wall south\n"
       "monitor C disc 1 with disc 2\nmonitor G grading g\nregion M all from go\n",
       "wall south velocity 0.1 0.1 spin 0.01\n"},
      {"periodic cell 0 0 to 6 6\n", "cell strain -0.1 0.1\n"},
  };
  static char names[NAMES_MAX][2 * NB_NAME_SIZE];
  double alone[NAMES_MAX], among[NAMES_MAX];
  for (size_t k = 0; k < sizeof scenes / sizeof *scenes; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page, ROCK "material m\nlattice discs 2 by 1 radius 1 rock\n%s" END, scenes[k][0]);
    written_scene(&it, &page);
    const size_t count = quantities_of(names, &it.scene);
    written_free(&it);
    CU_ASSERT(count > 30 && count < NAMES_MAX);
    last_values(among, names, 0, count, scenes[k][0], scenes[k][1]);
    for (size_t c = 0; c < count; c++) {
      last_values(alone, names, c, c + 1, scenes[k][0], scenes[k][1]);
      const bool same = alone[c] == among[c] || (isnan(alone[c]) && isnan(among[c]));
      if (!same)
        printf("# %s: alone %.17g, among all %.17g\n", names[c], alone[c], among[c]);
      CU_ASSERT(same);
    }
  }
}

/* In a name of several words these words do not distinguish quantities, and any other word does. */
static void words_that_say_nothing(void) {
  const char *words =
      "of, the, mean, average, number, count, total, value, quantity, all, system, scene, assembly, sample, "
      "particle, particles, ball, balls, disc, discs, sphere, spheres, contact, contacts, fraction, component";
  const struct nb_scene scene = {0};
  char word[NB_NAME_SIZE], name[2 * NB_NAME_SIZE], hint[NB_HINT_SIZE];
  while (nb_item(&words, word)) {
    snprintf(name, sizeof name, "%s_rattlers", word);
    CU_ASSERT(nb_parts_hint(hint, &scene, name, -1));
    CU_ASSERT_PTR_NOT_NULL(strstr(hint, "`M.rattlers`"));
  }
  CU_ASSERT_FALSE(nb_parts_hint(hint, &scene, "purple_rattlers", -1));
}

/* No explanation of a quantity is cut at the size of its text. */
static void no_explanation_is_cut(void) {
  struct nb_quantity_row row;
  size_t longest = 0;
  for (size_t k = 0; nb_quantity_row(&row, k); k++)
    longest = strlen(row.help) > longest ? strlen(row.help) : longest;
  CU_ASSERT(longest > 0 && longest < sizeof row.help - 1);
}

void suite_statements(void) {
  CU_pSuite suite = CU_add_suite("statements", NULL, NULL);
  CU_add_test(suite, "a wall turns about a point, on its line or beside it", a_wall_turns_about_a_point);
  CU_add_test(suite, "a file of columns", a_file_of_columns);
  CU_add_test(suite, "walls that the first stage moves", walls_of_the_first_stage);
  CU_add_test(suite, "a statement in the wrong place", the_wrong_place);
  CU_add_test(suite, "one of two materials may be rigid", one_rigid_sphere);
  CU_add_test(suite, "the bounds of each quantity", bounds_of_quantities);
  CU_add_test(suite, "each quantity alone", quantities_alone);
  CU_ADD_TEST(suite, no_explanation_is_cut);
  CU_add_test(suite, "words that distinguish no quantities", words_that_say_nothing);
}
