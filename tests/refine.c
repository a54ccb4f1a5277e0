/* `--set refine=R` gives the tables of a page in which every number of cycles is multiplied by R, and the step and
 * every strain per cycle are divided by R. All numbers are powers of two or small whole numbers, so the tables are
 * equal to the last bit.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/report/expect.h"
#include "suites.h"
#include "written.h"

/* Adds a page in which the step, in seconds, is divided by r, the numbers of cycles are multiplied by r, and the
 * strains per cycle are divided by r. RATE(x, r) is a strain of x/8192 per cycle, divided by r. */
typedef void add_page(struct words *page, double r);

#define RATE(x, r) ((x) / 8192.0 / (r))

static void boundary_page(struct words *page, double r) {
  words_add(page,
            "units none\nmaterial m density 2 kn 1000\ndisc 3 2 radius 1 m\ndisc 10 0 radius 1 m\ndisc 6 8 radius 1 m\n"
            "disc -6 8 radius 1 m\ndisc 4.5 3 radius 1 m\nboundary circle 0 0 radius 10\nregion B inside 0.5\n"
            "monitor D disc 1\nrecord cycle time boundary.stress.mean B.stress.xx D.x D.vx boundary.radius\n"
            "step %.17g\n",
            1 / 1024.0 / r);
  words_add(page,
            "stage a\nboundary strain %.17g per cycle %.17g per cycle shear %.17g per cycle\n"
            "affine strain %.17g per cycle 0 per cycle c12 %.17g per cycle c21 %.17g per cycle\nrecord every %g "
            "cycles\ncycles %g\n",
            RATE(1, r), RATE(-1, r), RATE(0.25, r), RATE(2, r), RATE(0.5, r), RATE(-0.5, r), 4 * r, 12 * r);
  words_add(page,
            "stage b\naffine none\nboundary fixed\nservo mean 1e6 on boundary through boundary at most %.17g per cycle "
            "every %g cycles\nrecord every %g cycles\ncycles %g\n",
            RATE(1, r), 4 * r, 2 * r, 16 * r);
  words_add(page,
            "stage c\nservo mean 1e6 on boundary through boundary at most %.17g per cycle every %g cycles\n"
            "until cycle above %g and B.stress.xx above -1 every %g cycles at most %g cycles\nstep %.17g\n",
            RATE(1, r), 10 * r, 38 * r - 0.5, 4 * r, 100 * r, 1 / 2048.0 / r);
}

static void cell_page(struct words *page, double r) {
  words_add(
      page,
      "units none\nmaterial m density 3 kn 100 ks 100 friction 0.5\nperiodic cell 0 0 to 8 8\n"
      "lattice discs 3 by 3 from 1 1 radius 0.9 spacing 2 m\ndisc 7 7 radius 0.5 m velocity 3 -2\nmonitor D disc 10\n"
      "record D.vx D.vy cycle time cell.strain.xx cell.stress.xx cell.stress.xy\ndamping con1 %.17g as cs79\nstep "
      "%.17g\n",
      1 - 0.125 / r, 1 / 256.0 / r);
  words_add(page,
            "stage a\ncell strain %.17g per cycle %.17g per cycle c12 %.17g per cycle c21 %.17g per cycle\ncycles %g\n",
            RATE(-4, r), RATE(-1, r), RATE(2, r), RATE(0, r), 16 * r);
  words_add(page, "stage b\ndamping con1 %.17g as velocity\ncycles %g\n", r > 1 ? 0.5 : 0.25, 4 * r);
  words_add(page, "stage c\ndamping con1 %.17g as all\ncycles %g\n", r > 1 ? 0.25 : 0.0625, 4 * r);
}

static void box_page(struct words *page, double r) {
  words_add(page,
            "units none\nmaterial m density 3 kn 100\nbox 0 0 to 8 8 m\n"
            "lattice discs 4 by 4 from 1 1 radius 1 spacing 2 m\nrecord cycle box.width box.height box.stress.yy\nstep "
            "%.17g\n",
            1 / 256.0 / r);
  words_add(page, "stage a\nbox strain %.17g per cycle %.17g per cycle\nrecord none\ncycles %g\nstage b\ncycles %g\n",
            RATE(-4, r), RATE(-1, r), 16 * r, 3 * r);
}

static void contact_test_page(struct words *page, double r) {
  words_add(
      page,
      "path\nunits none\nmaterial rock young 1 poisson 0.25 friction 0.5\nnormal hertz\nshear mindlin\n"
      "contact sphere 1 rock with sphere 1 rock\nrecord step overlap slip normal shear\nsegment a overlap to 0.5 in %g "
      "steps\nsegment b slip to 0.25 in %g steps\nrecord every %g steps\n",
      8 * r, 16 * r, 4 * r);
}

/* Asserts that the page for r = 1 with the setting `text` has the same tables as the page for r without a setting. */
static void same_tables(add_page *add, const char *text, double r) {
  const char *const settings[] = {text, NULL};
  struct words words = {0}, multiplied_words = {0};
  struct written refined, multiplied;
  struct nb_result result, expected;
  add(&words, 1), add(&multiplied_words, r);
  written_scene_set(&refined, &words, settings);
  written_scene(&multiplied, &multiplied_words);
  written_run(&result, &refined, NULL);
  written_run(&expected, &multiplied, NULL);
  CU_ASSERT_EQUAL_FATAL(result.table.row_count, expected.table.row_count);
  CU_ASSERT(result.table.row_count > 2);
  const size_t numbers = result.table.row_count * result.table.column_count;
  CU_ASSERT_EQUAL(memcmp(result.table.values, expected.table.values, numbers * sizeof *result.table.values), 0);
  CU_ASSERT_EQUAL(memcmp(result.table.stage, expected.table.stage, result.table.row_count * sizeof(int)), 0);
  nb_result_free(&result), nb_result_free(&expected);
  written_free(&refined), written_free(&multiplied);
}

static void tables_of_a_page_with_all_numbers_multiplied(void) {
  add_page *const pages[] = {boundary_page, cell_page, box_page, contact_test_page};
  for (size_t k = 0; k < sizeof pages / sizeof *pages; k++) {
    same_tables(pages[k], "refine=2", 2);
    same_tables(pages[k], "refine=1", 1);
  }
}

/* `at N cycles` in an expectation means cycle N of the page without the setting, which is cycle N R with it. */
static void expectations_at_a_cycle(void) {
  struct words words = {0};
  struct written written;
  static const char *const settings[] = {"refine=2.5", NULL};
  words_add(&words, "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m velocity 1 0\nmonitor D disc 1\n"
                    "record D.x\nstep 0.25\nstage a\ncycles 4\n");
  written_scene_set(&written, &words, settings);
  struct nb_mistakes mistakes = {0};
  struct nb_expectation expectation;
  nb_expectation_read(&expectation, "a test", "D.x at 4 cycles in a within 1", &written.scene, &mistakes);
  CU_ASSERT_EQUAL(mistakes.total, 0);
  CU_ASSERT_EQUAL(expectation.measure.reducer, NB_AT_CYCLE);
  CU_ASSERT_EQUAL(expectation.measure.at, 10);
  CU_ASSERT_STRING_EQUAL(expectation.measure.label, "D.x at 4 cycles in a");
  CU_ASSERT_EQUAL(nb_expectation_read(&expectation, "a test", "D.x at 3 cycles within 1", &written.scene, &mistakes),
                  NB_BAD_USE);
  CU_ASSERT(mistakes.text &&
            strstr(mistakes.text, "expected a whole number of cycles with --set refine=2.5, found 7.5"));
  nb_mistakes_free(&mistakes);
  written_free(&written);
}

/* An expectation that is not in a page, as the quantity of `advise`: its tolerance is in the unit of the measure. */
static void an_expectation_outside_a_page(void) {
  static const struct {
    const char *text, *message;
  } rows[] = {
      {"D.x in a within 1 mm", NULL},
      {"D.x in a within 1 ms", "expected a length and its unit (m, mm, um, nm, cm, km), or a percentage, found `1 ms`"},
      {"D.x in a within 1", "expected a length and its unit (m, mm, um, nm, cm, km), or a percentage, found `1`"}};
  struct words words = {0};
  struct written written;
  words_add(&words, "material m density 1 kg/m3 kn 1 N/m\ndisc 0 m 0 m radius 1 m m\nmonitor D disc 1\n"
                    "record D.x\nstep 0.25 s\nstage a\ncycles 4\n");
  written_scene_set(&written, &words, NULL);
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_mistakes mistakes = {0};
    struct nb_expectation expectation;
    const enum nb_status status = nb_expectation_read(&expectation, "a test", rows[k].text, &written.scene, &mistakes);
    CU_ASSERT_EQUAL(status, rows[k].message ? NB_BAD_USE : NB_OK);
    if (rows[k].message) {
      CU_ASSERT(mistakes.text && strstr(mistakes.text, rows[k].message));
    } else {
      CU_ASSERT_EQUAL(expectation.tolerance.value, 1e-3);
    }
    nb_mistakes_free(&mistakes);
  }
  written_free(&written);
}

/* With a longer step, intervals of one cycle do not change, and the number of `at most` is rounded up. */
static void a_longer_step(void) {
  struct words words = {0};
  struct written written;
  static const char *const settings[] = {"refine=(1/3)", NULL};
  words_add(&words, "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m velocity 1 0\nmonitor D disc 1\n"
                    "record D.x\nstep 0.25\nstage a\ncycles 3\nstage b\nuntil D.x above 3 at most 16 cycles\n"
                    "stage c\nrecord every 5 cycles\ncycles 12\nstage d\nrecord none\n"
                    "until D.x above 3 every 8 cycles at most 49 cycles\n");
  written_scene_set(&written, &words, settings);
  const struct nb_stage *stages = written.scene.stages;
  CU_ASSERT_EQUAL(stages[0].cycles, 1);
  CU_ASSERT_EQUAL(stages[0].record_interval, 1);
  CU_ASSERT_EQUAL(stages[1].cycles, 6);
  CU_ASSERT_EQUAL(stages[1].check_interval, 1);
  CU_ASSERT_EQUAL(stages[2].record_interval, 2);
  CU_ASSERT_EQUAL(stages[3].record_interval, 0);
  CU_ASSERT_EQUAL(stages[3].check_interval, 3);
  CU_ASSERT_EQUAL(stages[3].cycles, 17);
  NEAR(stages[2].step.value, 0.75, 1e-15);
  NEAR(written.scene.step.value, 0.75, 1e-15);
  written_free(&written);
}

/* 49 (1/49) is 1 - 2^-53 in double precision. */
static void a_product_that_rounding_makes_no_whole_number(void) {
  struct words words = {0};
  struct written written;
  static const char *const settings[] = {"refine=(1/49)", NULL};
  words_add(&words, "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m velocity 1 0\nmonitor D disc 1\n"
                    "record D.x\nstep 0.25\nstage a\nrecord every 7 cycles\ncycles 49\nstage b\nuntil D.x above 3 at "
                    "most 49 cycles\n");
  written_scene_set(&written, &words, settings);
  CU_ASSERT_EQUAL(written.scene.stages[0].cycles, 1);
  CU_ASSERT_EQUAL(written.scene.stages[0].record_interval, 1);
  CU_ASSERT_EQUAL(written.scene.stages[1].cycles, 1);
  written_free(&written);
}

/* A page in which all stiffnesses are divided by r, including those of a pair and those that a stage changes. They and r
 * are powers of two, so the tables agree to the last bit. */
static void soft_page(struct words *page, double r) {
  words_add(
      page,
      "units none\nmaterial m density 2 kn %.17g ks %.17g friction 0.5\nmaterial n density 2 kn %.17g friction 0.5\n"
      "pair m n kn %.17g ks %.17g\ndisc 0 0 radius 1 m velocity 1 0.5\ndisc 1.875 0 radius 1 n\n"
      "disc 0 1.9375 radius 1 m\nmonitor C disc 1 with disc 2\nmonitor D disc 1\n",
      1024 / r, 512 / r, 256 / r, 2048 / r, 128 / r);
  words_add(page,
            "shear linear\nrecord C.normal C.shear D.vx D.vy D.spin\nstep 0.0078125\nstage a\ncycles 20\nstage b\n"
            "material m kn %.17g ks %.17g\npair m n kn %.17g\ncycles 20\n",
            4096 / r, 2048 / r, 8192 / r);
}

static void soft_spheres(struct words *page, double r) {
  words_add(page,
            "units none\nmaterial m density 2 young %.17g poisson 0.25 friction 0.5\nnormal hertz\nshear mindlin\n"
            "sphere 0 0 radius 1 m velocity 1 0.5\nsphere 1.875 0 radius 1 m\nmonitor C sphere 1 with sphere 2\n"
            "record C.normal C.shear\nstep 0.0078125\nstage a\ncycles 20\n",
            4096 / r);
}

static void tables_of_a_page_with_softer_contacts(void) {
  add_page *const pages[] = {soft_page, soft_spheres};
  for (size_t k = 0; k < sizeof pages / sizeof *pages; k++)
    for (double soften = 0.25; soften <= 16; soften *= 4) {
      char text[32];
      snprintf(text, sizeof text, "soften=%g", soften);
      same_tables(pages[k], text, soften);
    }
}

/* A page with `damping late` in the scene and in a stage (r = 1), or with `damping centred` in both places (r = 2). With
 * the setting damping=centred, the first page must have the tables of the second one. */
static void dashpots_page(struct words *page, double r) {
  static const char *const words[] = {"", "late", "centred"};
  words_add(page,
            "units none\nmaterial m density 2 kn 1024\ndisc 0 0 radius 1 m velocity 1 0\ndisc 1.99 0 radius 1 m\n"
            "monitor D disc 1\nrecord D.vx\ndamping ratio 0.25\ndamping %s\nstep 0.0078125\nstage a\ncycles 20\n"
            "stage b\ndamping %s\ncycles 20\n",
            words[(int)r], words[(int)r]);
}

static void tables_of_a_page_with_other_dashpots(void) { same_tables(dashpots_page, "damping=centred", 2); }

void suite_refine(void) {
  CU_pSuite suite = CU_add_suite("refine", NULL, NULL);
  CU_ADD_TEST(suite, tables_of_a_page_with_all_numbers_multiplied);
  CU_ADD_TEST(suite, expectations_at_a_cycle);
  CU_ADD_TEST(suite, an_expectation_outside_a_page);
  CU_ADD_TEST(suite, a_longer_step);
  CU_ADD_TEST(suite, tables_of_a_page_with_softer_contacts);
  CU_ADD_TEST(suite, tables_of_a_page_with_other_dashpots);
  CU_ADD_TEST(suite, a_product_that_rounding_makes_no_whole_number);
}
