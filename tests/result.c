/* What a run records (result.c): the empty table, the extremes of all cycles, the fields that the scene requests, and the
 * reports of progress.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "run/result.h"

#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>
#include <time.h>

#include "core/names.h"
#include "suites.h"
#include "written.h"

#define DISC "density 1 kg/m3  kn 100 N/m\ndisc 4 m 4 m radius 1 m m velocity 3 m/s 0 m/s\nstep 1 s\n"
#define UNITLESS "units none\nmaterial m density 1 kn 100\ndisc 4 4 radius 1 m velocity 3 0\nstep 1\n"

/* A table has the columns in their order, with their units. */
static void an_empty_table(void) {
  static const char *const pages[] = {"material m " DISC, UNITLESS}, *const units[][2] = {{"m", "s"}, {"-", "-"}};
  for (int k = 0; k < 2; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result = {0};
    words_add(&page, "%smonitor D disc 1\nrecord D.x time\nstage a\ncycles 1\n", pages[k]);
    written_scene(&it, &page);
    CU_ASSERT_TRUE_FATAL(nb_result_begin(&result, &it.scene));
    CU_ASSERT_EQUAL_FATAL(result.table.column_count, 2);
    CU_ASSERT_EQUAL(result.table.row_count, 0);
    CU_ASSERT_STRING_EQUAL(result.table.names[0], "D.x");
    CU_ASSERT_STRING_EQUAL(result.table.names[1], "time");
    for (int c = 0; c < 2; c++)
      CU_ASSERT_STRING_EQUAL(result.table.units[c], units[k][c]);
    nb_result_free(&result), written_free(&it);
  }
}

/* The extremes of a tracked column begin with the empty interval in each stage and grow with the values of this stage.
 * Those of another column are the infinite interval. */
static void extremes_of_tracked_columns(void) {
  static const bool tracked[] = {true, false, true};
  struct words page = {0};
  struct written it;
  struct nb_result result = {0};
  words_add(&page, UNITLESS "monitor D disc 1\nrecord D.x time D.vx\nstage a\ncycles 1\nstage b\ncycles 1\n");
  written_scene(&it, &page);
  for (int c = 0; c < 3; c++)
    it.scene.columns[c].tracked = tracked[c];
  CU_ASSERT_TRUE_FATAL(nb_result_begin(&result, &it.scene));
  for (int k = 0; k < 6; k++) {
    CU_ASSERT_EQUAL(result.extremes[k].smallest, tracked[k % 3] ? INFINITY : -INFINITY);
    CU_ASSERT_EQUAL(result.extremes[k].largest, tracked[k % 3] ? -INFINITY : INFINITY);
  }
  struct nb_model *model = written_model(&it, NULL);
  nb_result_track(&result, model, 1);
  written_cycles(model, 2); /* from x = 4 to 10 */
  nb_result_track(&result, model, 1);
  nb_result_forget_extremes(&result, &it.scene);
  for (int k = 0; k < 6; k++) {
    const bool now = k == 3 || k == 5;
    CU_ASSERT_EQUAL(result.extremes[k].smallest, k == 3 ? 4 : now ? 3 : tracked[k % 3] ? INFINITY : -INFINITY);
    CU_ASSERT_EQUAL(result.extremes[k].largest, k == 3 ? 10 : now ? 3 : tracked[k % 3] ? -INFINITY : INFINITY);
  }
  it.scene.columns[0].tracked = false;
  nb_result_forget_extremes(&result, &it.scene);
  for (int k = 0; k < 6; k += 3)
    CU_ASSERT(result.extremes[k].smallest == -INFINITY && result.extremes[k].largest == INFINITY);
  CU_ASSERT_EQUAL(result.extremes[5].largest, 3);
  nb_model_free(model), nb_result_free(&result), written_free(&it);
}

/* The fields are those of columns, conditions, servos and snapshots, in stages that this run computes. */
static void fields_that_a_scene_requests(void) {
  const unsigned normal = NB_BIT(NB_NORMAL), overlap = NB_BIT(NB_OVERLAP), sliding = NB_BIT(NB_SLIDING);
  const unsigned drawn =
      overlap | NB_BIT(NB_EX) | NB_BIT(NB_EY) | normal | NB_BIT(NB_SHEAR) | sliding | NB_BIT(NB_RADIUS);
  const struct {
    const char *stages;
    size_t start; /* the run continues from the end of this number of stages */
    unsigned fields;
  } rows[] = {{"record cycle\nstage a\ncycles 1\n", 0, 0},
              {"record C.sliding\nstage a\ncycles 1\n", 0, sliding},
              {"record C.sliding C.normal\nstage a\ncycles 1\n", 0, sliding | normal},
              {"record cycle\nstage a\nuntil C.sliding above 0.5 at most 9 cycles\n", 0, sliding},
              {"record cycle\nstage a\nuntil cycle above 1 and C.normal above 1 at most 9 cycles\n", 0, normal},
              {"record cycle\nstage a\nuntil C.sliding above 0.5 at most 9 cycles\nstage b\ncycles 1\n", 1, 0},
              {"record cycle\nstage a\ncycles 1\nstage b\nuntil C.sliding above 0.5 at most 9 cycles\n", 1, sliding},
              {"record cycle\nstage a\ncycles 1\nsnapshot\n", 0, drawn},
              {"record cycle\nstage a\ncycles 1\nsnapshot from a\n", 0, drawn | NB_BIT(NB_TANGENTIAL_INCREMENT)},
              {"record cycle\nstage a\nservo mean 1 on box through box at most 0.1\ncycles 1\n", 0,
               overlap | NB_BIT(NB_STIFFNESS)}};
  for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
    struct words page = {0};
    struct written it;
    words_add(&page, UNITLESS "disc 6 4 radius 1 m\nbox 0 0 to 9 9 m\nmonitor C disc 1 with disc 2\n%s",
              rows[r].stages);
    written_scene(&it, &page);
    it.scene.start.stages = rows[r].start;
    unsigned wanted = rows[r].fields | (strstr(rows[r].stages, "record cycle") ? NB_REQUEST_CLOCK : 0);
    for (int k = 0; k < 4 && it.scene.stages[0].servo.line; k++) /* and what the measured stress reads */
      wanted |= it.scene.stages[0].servo.quantity[k].kind->fields;
    if (nb_fields_requested(&it.scene) != wanted)
      printf("# row %zu: %x, expected %x\n", r, nb_fields_requested(&it.scene), wanted);
    CU_ASSERT_EQUAL(nb_fields_requested(&it.scene), wanted);
    it.scene.start.stages = 0;
    written_free(&it);
  }
}

struct called {
  int count;
  const char *stage;
  double fraction, seconds;
};

static void note_call(void *data, const char *stage, double fraction, double seconds) {
  struct called *called = data;
  *called = (struct called){called->count + 1, stage, fraction, seconds};
}

/* A report follows the last one after a tenth of a second. A trial ends a stage after stage_seconds of processor time. */
static void reports_of_progress(void) {
  struct called called = {0};
  struct nb_progress progress = {.call = note_call, .data = &called};
  struct nb_reporter reporter = nb_reporter_begin(NULL);
  CU_ASSERT_TRUE(nb_reporter_update(&reporter, "a", 0.5));
  reporter = nb_reporter_begin(&progress);
  CU_ASSERT_TRUE(nb_reporter_update(&reporter, "a", 0.25));
  CU_ASSERT_EQUAL_FATAL(called.count, 1);
  CU_ASSERT_STRING_EQUAL(called.stage, "a");
  CU_ASSERT_EQUAL(called.fraction, 0.25);
  CU_ASSERT(called.seconds >= 0 && called.seconds < 1);
  reporter.last_call += 3600; /* the last report was just now, whatever else this machine does */
  CU_ASSERT_TRUE(nb_reporter_update(&reporter, "b", 0.5));
  CU_ASSERT_EQUAL_FATAL(called.count, 1);
  reporter.last_call -= 3600.11, reporter.began -= 100;
  CU_ASSERT_TRUE(nb_reporter_update(&reporter, "b", 0.5));
  CU_ASSERT_EQUAL_FATAL(called.count, 2);
  CU_ASSERT_STRING_EQUAL(called.stage, "b");
  CU_ASSERT(called.seconds >= 100 && called.seconds < 101);
  progress.call = NULL, progress.stage_seconds = 1000;
  CU_ASSERT_TRUE(nb_reporter_update(&reporter, "b", 0.5));
  reporter.stage_began -= 999;
  CU_ASSERT_TRUE(nb_reporter_update(&reporter, "b", 0.5));
  reporter.stage_began -= 1;
  CU_ASSERT_FALSE(nb_reporter_update(&reporter, "b", 0.5));
  progress.stage_seconds = 0;
  CU_ASSERT_TRUE(nb_reporter_update(&reporter, "b", 0.5));
}

/* The processor clock counts seconds of computing, and not those of sleep. */
static void the_processor_clock(void) {
  const double began = nb_processor_clock();
  const clock_t first = clock();
  nanosleep(&(struct timespec){.tv_nsec = 30000000}, NULL);
  const double slept = nb_processor_clock() - began;
  CU_ASSERT(slept >= 0 && slept < 0.02);
  while (clock() - first < CLOCKS_PER_SEC / 20)
    ;
  CU_ASSERT_DOUBLE_EQUAL(nb_processor_clock() - began, 0.05, 0.01);
}

void suite_result(void) {
  CU_pSuite suite = CU_add_suite("result", NULL, NULL);
  CU_ADD_TEST(suite, an_empty_table);
  CU_ADD_TEST(suite, extremes_of_tracked_columns);
  CU_ADD_TEST(suite, fields_that_a_scene_requests);
  CU_ADD_TEST(suite, reports_of_progress);
  CU_ADD_TEST(suite, the_processor_clock);
}
