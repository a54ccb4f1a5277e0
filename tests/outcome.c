/* Runs of a page: progress and notes during the runs, warnings, units of the results, and memory, files and locks of
 * results.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../src/core/clock.h"
#include "report/outcome.h"
#include "suites.h"
#include "written.h"

/* The number of progress reports and of notes, and the last text of each. */
struct reports {
  int calls, notes;
  char stage[512], note[1024];
  double fraction;
};

static void call(void *data, const char *stage, double fraction, double seconds) {
  struct reports *reports = data;
  CU_ASSERT(seconds >= 0 && seconds < nb_clock()); /* since the runs began; the clock began earlier */
  CU_ASSERT(fraction > 0 && fraction <= 1);
  snprintf(reports->stage, sizeof reports->stage, "%s", stage);
  CU_ASSERT_DOUBLE_EQUAL(40 * fraction, round(40 * fraction), 1e-9); /* ten cycles in each of at most four runs */
  reports->fraction = fraction, reports->calls++;
}

static void note(void *data, const char *text) {
  struct reports *reports = data;
  snprintf(reports->note, sizeof reports->note, "%s", text);
  reports->notes++;
}

/* Creates a temporary page with these statements and these expectations. `path` is the template of its name, and becomes
 * the name. */
static void write_page(char path[], const char *scene, const char *expectations) {
  FILE *file = written_file(path);
  fprintf(file, "```scene\n%s\n```\n```expect\n%s\n```\n", scene, expectations);
  fclose(file);
}

/* Runs a page with these statements and these expectations. */
static void carry_out_with(struct nb_outcome *outcome, const char *scene, const char *expectations,
                           const struct nb_options *options, const struct nb_progress *progress) {
  char path[] = "/tmp/nineball-outcome-XXXXXX";
  write_page(path, scene, expectations);
  nb_outcome_make(outcome, path, NULL, options, progress);
  unlink(path);
  if (outcome->mistakes.text)
    printf("# %s", outcome->mistakes.text);
}

static void carry_out(struct nb_outcome *outcome, const char *scene, const char *expectations,
                      const struct nb_progress *progress) {
  carry_out_with(outcome, scene, expectations, NULL, progress);
}

/* Runs a page with one disc, another shear law in its second stage, these sweeps and these expectations. */
static void make(struct nb_outcome *outcome, const char *sweep, const char *expectations,
                 const struct nb_progress *progress) {
  char scene[512];
  snprintf(scene, sizeof scene,
           "%s\nmaterial m density 1 kg/m3 kn 1 N/m ks 1 N/m friction 0.5\nshear linear\ndisc 0 m 0 m radius 1 m m "
           "velocity 1 m/s 0 m/s\nmonitor A disc 1\nstep 1 ms\nrecord time cycle A.x\nstage one\ncycles 5\nstage "
           "two\nshear none\ncycles 5",
           sweep);
  carry_out(outcome, scene, expectations, progress);
}

/* The fraction in a progress report is the finished part of all runs together. Progress reports and notes name the run
 * if there are several runs. */
static void progress(void) {
  static const struct {
    const char *sweep, *stage, *note;
    int calls, runs;
    double fraction;
  } rows[] = {
      {"", "one",
       "stage `two` begins with empty histories of the shear force, because its law is `shear none` instead of "
       "`linear`",
       1, 1, 0},
      {"sweep v 1 2\nsweep w 3 4", "one of v=2, w=4",
       "stage `two` begins with empty histories of the shear force, because its law is `shear none` instead of "
       "`linear`, run v=2, "
       "w=4",
       4, 4, 0.75},
  };
  for (size_t k = 0; k < 2; k++) {
    struct reports reports = {0};
    const struct nb_progress both = {call, note, &reports}, neither = {NULL, NULL, &reports};
    struct nb_outcome outcome;
    make(&outcome, rows[k].sweep, "A.x expected 10 mm within 1e-12 m [t]", &both);
    CU_ASSERT_EQUAL(outcome.status, NB_OK);
    CU_ASSERT_EQUAL(outcome.check_count, (size_t)rows[k].runs);
    CU_ASSERT(reports.calls >= rows[k].calls);
    CU_ASSERT_STRING_EQUAL(reports.stage, rows[k].stage);
    CU_ASSERT(reports.fraction > rows[k].fraction && reports.fraction <= rows[k].fraction + 0.5 / rows[k].runs);
    CU_ASSERT_EQUAL(reports.notes, rows[k].runs);
    CU_ASSERT_STRING_EQUAL(reports.note, rows[k].note);
    nb_outcome_free(&outcome);
    reports = (struct reports){0};
    make(&outcome, rows[k].sweep, "A.x expected 10 mm within 1e-12 m [t]", &neither);
    CU_ASSERT(outcome.status == NB_OK && reports.calls == 0 && reports.notes == 0);
    nb_outcome_free(&outcome);
  }
}

/* A stage has the same law as the stage before, with another number of pieces. The note names this number, because
 * nothing else changes. */
static void note_of_memory_size(void) {
  static const char scene[] = "material m density 1 kg/m3 young 1 Pa poisson 0.25 friction 0.5\nnormal hertz\n"
                              "shear mindlin_deresiewicz%s\nsphere 0 m 0 m radius 1 m m velocity 1 m/s 0 m/s\n"
                              "monitor A sphere 1\nstep 1 ms\nrecord time A.x\nstage one\ncycles 5\nstage two\n"
                              "shear mindlin_deresiewicz memory 6\ncycles 5";
  for (int given = 0; given < 2; given++) {
    struct reports reports = {0};
    const struct nb_progress progress = {call, note, &reports};
    struct nb_outcome outcome;
    char text[sizeof scene + 32], expected[256];
    snprintf(text, sizeof text, scene, given ? " memory 9" : "");
    snprintf(expected, sizeof expected,
             "stage `two` begins with empty histories of the shear force, because its law is `shear "
             "mindlin_deresiewicz memory 6` "
             "instead of `memory %d`",
             given ? 9 : 64);
    carry_out(&outcome, text, "A.x expected 10 mm within 1e-12 m [t]", &progress);
    CU_ASSERT_EQUAL(reports.notes, 1);
    CU_ASSERT_STRING_EQUAL(reports.note, expected);
    nb_outcome_free(&outcome);
  }
}

/* Each law that changes has a note, the normal law first. A stage that names the laws of the stage before has none. */
static void notes_of_other_laws(void) {
  static const struct {
    const char *laws, *last; /* of the second stage; the last note */
    int notes;
  } rows[] = {
      {"normal linear\nshear none\n", "", 0},
      {"normal hertz\n",
       "stage `two` begins with empty histories of the normal force, because its law is `normal hertz` instead "
       "of `linear`",
       1},
      {"shear linear\nnormal hertz\n",
       "stage `two` begins with empty histories of the shear force, because its law is `shear linear` instead of "
       "`none`",
       2}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct reports reports = {0};
    const struct nb_progress progress = {call, note, &reports};
    struct nb_outcome outcome;
    char text[512];
    snprintf(text, sizeof text,
             "material m density 1 kg/m3 kn 1 N/m ks 1 N/m young 1 Pa poisson 0.25 friction 0.5\nshear none\n"
             "sphere 0 m 0 m radius 1 m m velocity 1 m/s 0 m/s\nmonitor A sphere 1\nstep 1 ms\nrecord time A.x\n"
             "stage one\ncycles 5\nstage two\n%scycles 5",
             rows[k].laws);
    carry_out(&outcome, text, "A.x expected 10 mm within 1e-12 m [t]", &progress);
    CU_ASSERT_EQUAL(outcome.status, NB_OK);
    CU_ASSERT_EQUAL(reports.notes, rows[k].notes);
    CU_ASSERT_STRING_EQUAL(reports.note, rows[k].last);
    nb_outcome_free(&outcome);
  }
}

/* Drops the warnings of overlaps at the start, which some of the following scenes need. */
static void drop_overlaps(struct nb_warnings *warnings) {
  size_t kept = 0;
  for (size_t k = 0; k < warnings->count; k++)
    if (!strstr(warnings->list[k].text, "too much at the start"))
      warnings->list[kept++] = warnings->list[k];
  warnings->count = kept;
}

/* Warnings of stages that end too early: without contact forces, where `unbalanced.max` is 0, or because their
 * conditions were met before the stage began. In other scenes there is no warning. */
static void warnings_of_ends(void) {
  static const char one[] = "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m fixed\n"
                            "disc %s 0 radius 1 m velocity 1 0\nmonitor A disc 2\nrecord time A.x\nstep 0.1\n"
                            "stage one\ncycles 2\nstage two\nuntil %s";
  static const struct {
    const char *x, *condition, *warning;
  } rows[] = {
      {"5", "unbalanced.max below 1  at most 4 cycles",
       "stage `two` ended in cycle 1 without a contact force, where `unbalanced.max` is 0; add a condition such as "
       "`and "
       "contacts above 0`"},
      {"5", "time above 0.1 and unbalanced.max below 1  at most 4 cycles",
       "stage `two` ended in cycle 1 without a contact force, where `unbalanced.max` is 0; add a condition such as "
       "`and contacts above 0`"},
      {"5", "unbalanced.max below 1 and time above 0.1  at most 4 cycles",
       "stage `two` ended in cycle 1 without a contact force, where `unbalanced.max` is 0; add a condition such as "
       "`and contacts above 0`"},
      {"1.5", "unbalanced.max above 0.5  at most 4 cycles",
       "stage `two` ended in cycle 1, because its condition was met before the stage began: unbalanced.max is 1, above "
       "0.5"},
      {"5", "time above 0.1  at most 4 cycles",
       "stage `two` ended in cycle 1, because its condition was met before the stage began: time is 0.3, above 0.1; "
       "`time` "
       "counts from the start of the run, `stage.time` from the start of the stage"},
      {"5", "time above 0.1 and A.x below 6  at most 4 cycles",
       "stage `two` ended in cycle 1, because its condition was met before the stage began: time is 0.3, above 0.1, "
       "A.x is "
       "5.3, "
       "below 6; `time` counts from the start of the run, `stage.time` from the start of the stage"},
      {"5", "A.x below 6 and time above 0.1  at most 4 cycles",
       "stage `two` ended in cycle 1, because its condition was met before the stage began: A.x is 5.3, below 6, time "
       "is 0.3, above 0.1; `time` counts from the start of the run, `stage.time` from the start of the stage"},
      {"5", "stage.time below 1  at most 4 cycles", /* counts from the start of the stage as it is */
       "stage `two` ended in cycle 1, because its condition was met before the stage began: stage.time is 0.1, below "
       "1"},
      {"5", "time above 0.25  at most 4 cycles", NULL}, /* met in the first cycle, but not before */
      {"5", "time above 0.1 and A.x above 5.25  at most 4 cycles", NULL},
      {"5", "time above 0.1  every 2 cycles  at most 4 cycles",
       "stage `two` ended in cycle 2, because its condition was met before the stage began: time is 0.4, above 0.1; "
       "`time` "
       "counts from the start of the run, `stage.time` from the start of the stage"},
      {"5", "time above 0.1 and A.x above 5.45  every 2 cycles  at most 4 cycles", NULL},
      {"5", "time above 0.35  at most 4 cycles", NULL},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_outcome outcome;
    char text[sizeof one + 96];
    snprintf(text, sizeof text, one, rows[k].x, rows[k].condition);
    carry_out(&outcome, text, "report A.x", NULL);
    drop_overlaps(&outcome.warnings);
    if (outcome.status)
      printf("# %zu: %s\n", k, outcome.error.text);
    CU_ASSERT_EQUAL(outcome.status, NB_OK);
    CU_ASSERT_EQUAL_FATAL(outcome.warnings.count, rows[k].warning ? 1 : 0);
    if (rows[k].warning) {
      CU_ASSERT_STRING_EQUAL(outcome.warnings.list[0].text, rows[k].warning);
      CU_ASSERT_EQUAL(outcome.warnings.list[0].line, 11);
    }
    nb_outcome_free(&outcome);
  }
}

/* Of two stages that end at their first check, only the condition of the first one was met before it began. */
static void warnings_of_ends_of_two_stages(void) {
  struct nb_outcome outcome;
  carry_out(&outcome,
            "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m fixed\ndisc 5 0 radius 1 m velocity 1 0\n"
            "monitor A disc 2\nrecord time A.x\nstep 0.1\nstage one\nuntil A.x above 4 at most 4 cycles\nstage two\n"
            "until time above 0.15 at most 4 cycles",
            "report A.x", NULL);
  CU_ASSERT_EQUAL(outcome.status, NB_OK);
  CU_ASSERT_EQUAL_FATAL(outcome.warnings.count, 1);
  CU_ASSERT_PTR_NOT_NULL(strstr(outcome.warnings.list[0].text, "stage `one` ended in cycle 1, because its condition"));
  nb_outcome_free(&outcome);
}

/* A region without a particle, at the start or at the end of a stage, causes a warning. So does a region without a
 * contact if its stress or a mean over its contacts is recorded. A negative porosity or void ratio causes a warning, too;
 * here they are -0.0521 and -0.0495, from the areas of the circles. Other regions cause no warning. */
static void warnings_of_regions(void) {
  static const char scene[] =
      "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m fixed\n"
      "disc %s 0 radius 1 m velocity 1 0\ndisc 0 50 radius 1 m velocity -1 0\nmonitor porosity disc 3\nstep 0.1\n"
      "region A circle %s\nrecord time %s porosity.y\nstage one\n"
      "cycles 2\nstage two\ncycles 2";
  static const struct {
    const char *x, *region, *column, *warning;
  } rows[] = {
      {"5", "9 9 radius 1", "A.stress.xx",
       "region `A` is empty: no particle centre is inside at the start, so its means and sums are 0"},
      {"5", "9 9 radius 1", "contacts",
       "region `A` is empty: no particle centre is inside at the start, so its means and sums are 0"},
      {"5", "5 0 radius 0.25", "contacts",
       "region `A` is empty: no particle centre is inside at the end of stage `two`, so its means and sums are 0"},
      {"5", "5 0 radius 2", "A.stress.xx",
       "region `A` has no contact: `A.stress.xx` depends on contacts, and there are none at the end of stage `one`"},
      {"5", "5 0 radius 2", "A.normal.mean",
       "region `A` has no contact: `A.normal.mean` depends on contacts, and there are none at the end of stage `one`"},
      {"1.5", "1 0 radius 60", "A.stress.xx", NULL},    /* the last disc inside has no contact, the others have */
      {"1.5", "1.5 0 radius 0.5", "A.stress.xx", NULL}, /* one disc is inside, with one contact */
      {"1.5", "0 50 radius 2\nregion B circle 0 0 radius 5", "B.stress.xx", NULL}, /* A's stress is not recorded */
      {"5", "5 0 radius 2", "A.porosity", NULL},
      {"5", "5 0 radius 2", "A.contacts", NULL},
      {"1", "0 0 radius 2", "A.stress.xx", NULL},
      {"1.5", "0.75 0 radius 0.8", "A.porosity",
       "`A.porosity` is negative: -0.052 at the end of stage `one`, because the overlaps of particles count twice"},
      {"1.5", "0.75 0 radius 0.8", "A.void_ratio",
       "`A.void_ratio` is negative: -0.050 at the end of stage `one`, because the overlaps of particles count twice"},
      {"1.5", "0.75 0 radius 0.8", "A.area", NULL},
      {"5", "0 0 radius 2", "porosity.vx", NULL}, /* a disc, not a porosity; its velocity is negative */
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_outcome outcome;
    char text[sizeof scene + 96];
    snprintf(text, sizeof text, scene, rows[k].x, rows[k].region, rows[k].column);
    carry_out(&outcome, text, "report time", NULL);
    drop_overlaps(&outcome.warnings);
    const struct nb_warning *const warning = outcome.warnings.list;
    CU_ASSERT_EQUAL(outcome.status, NB_OK);
    CU_ASSERT_EQUAL(outcome.warnings.count, rows[k].warning ? 1 : 0);
    for (size_t w = rows[k].warning ? 1 : 0; w < outcome.warnings.count; w++)
      printf("# %zu: %s\n", k, warning[w].text);
    if (rows[k].warning && outcome.warnings.count == 1)
      CU_ASSERT_STRING_EQUAL(warning->text, rows[k].warning);
    if (rows[k].warning &&
        outcome.warnings.count == 1) /* a porosity concerns the whole page; else the line `region A` */
      CU_ASSERT_EQUAL(warning->line, strstr(rows[k].warning, "is negative") ? 0 : 9);
    nb_outcome_free(&outcome);
  }
}

/* The warning of a stage with a servo proposes a condition on the controlled stress. The warning of a condition on a
 * strain says from which time this strain counts. */
static void warnings_of_ends_propose(void) {
  static const char scene[] =
      "units none\nmaterial m density 1 kn 1000\nperiodic cell 0 0 to 9 9\ndisc 1 1 radius 1 m\n"
      "disc 5 1 radius 1 m\ndisc 5 5 radius 1 m\nstep 0.001\nregion M all\nrecord time\nstage one\n"
      "cell strain 0 -1\ncycles 20\nstage two\n%s  at most 9 cycles";
  static const struct {
    const char *end, *warning;
  } rows[] = {
      {"cell strain 0 0\nservo isotropic 10 on cell through cell at most 1e-9 per cycle\nuntil unbalanced.max below 1",
       "add a condition such as `and cell.stress.xx above 9.9 and cell.stress.yy above 9.9`"},
      {"cell strain 0 0\nservo yy -10 on M through cell at most 1e-9 per cycle\nuntil unbalanced.max below 1",
       "add a condition such as `and M.stress.yy below -9.9`"},
      {"servo xy 10 on cell through cell at most 1e-9 per cycle\nuntil unbalanced.max below 1",
       "add a condition such as `and cell.stress.xy above 9.9`"},
      {"servo xy -10 on cell through cell at most 1e-9 per cycle\nuntil unbalanced.max below 1",
       "add a condition such as `and cell.stress.xy below -9.9`"}, /* a shear stress of either sign is no tension */
      {"until unbalanced.max below 1", "add a condition such as `and contacts above 0`"},
      {"until cell.strain.yy below -0.01",
       "; this strain counts from time 0, `stage.time` from the start of the stage"},
      {"until M.strain.yy below -0.01",
       "; this strain counts from the start of the run, or with `region … from STAGE` from the start of STAGE; "
       "`stage.time` counts from the start of each stage"},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_outcome outcome;
    char text[1024];
    snprintf(text, sizeof text, scene, rows[k].end);
    carry_out(&outcome, text, "report time", NULL);
    const size_t count = strstr(rows[k].end, "yy -10") ? 2 : 1; /* the first one is of a tension */
    const char *const last = outcome.warnings.list[count - 1].text;
    if (outcome.warnings.count != count)
      printf("# %zu: %zu warnings, %s\n", k, outcome.warnings.count, outcome.error.text);
    CU_ASSERT_EQUAL_FATAL(outcome.warnings.count, count);
    CU_ASSERT_PTR_NOT_NULL(strstr(last, rows[k].warning));
    if (!strstr(last, rows[k].warning))
      printf("# %zu: %s\n", k, last);
    nb_outcome_free(&outcome);
  }
}

/* A stage that ends while its stress differs from the target of its servo by more than 10 % causes a warning. There is
 * no warning if the next stage has a servo with the same target, or a servo with a ramp.
 *
 * The scene is a row of three discs in a periodic cell. Each of the three overlaps of 0.01 has the force 10, so the
 * stress along the row is 10 over the height of the cell, 4.5. With a rate of at most 1e-9 per cycle the servo hardly
 * changes the stress. */
static void warnings_of_servos(void) {
  static const char scene[] =
      "units none\nmaterial m density 1 kn 1000\nperiodic cell 0 0 to 5.97 4.5\ndisc 1 1 radius 1 m\n"
      "disc 2.99 1 radius 1 m\ndisc 4.98 1 radius 1 m\n"
      "step 0.001\nrecord time cell.stress.xx\nstage press\n"
      "servo xx %.17g on cell through cell at most 1e-9 per cycle\nuntil time above 0.0025  at most 9 "
      "cycles%s";
  static const char next[] = "\nstage rest\n%scycles 1";
  const double stress = 1000 * 0.01 / 4.5;
  static const struct {
    double target;     /* over the stress */
    const char *after; /* statements of the next stage; NULL: there is no next stage */
    bool warned;
  } rows[] = {{1.05, NULL, false},
              {0.95, NULL, false},
              {1.2, NULL, true},
              {0.8, NULL, true},
              {1.2, "", true},
              {1.2, "servo xx 2.25 on cell through cell at most 1e-9 per cycle\n", true},
              {1.2, "ramp servo xx 2.25 on cell through cell at most 1e-9 per cycle\n", false},
              {1.2, "servo xx 2.6666666666666665 on cell through cell at most 1e-9 per cycle\n", false},
              {1.2, "servo yy 2.6666666666666665 on cell through cell at most 1e-9 per cycle\n", true},
              {1.12, NULL, true},
              {1.10, NULL, false}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_outcome outcome;
    char text[1024], after[128] = "";
    if (rows[k].after)
      snprintf(after, sizeof after, next, rows[k].after);
    snprintf(text, sizeof text, scene, rows[k].target * stress, after);
    carry_out(&outcome, text, "report cell.stress.xx", NULL);
    CU_ASSERT_EQUAL(outcome.status, NB_OK);
    size_t found = 0; /* warnings of stage `press`; stage `rest` may have one, too */
    for (size_t w = 0; w < outcome.warnings.count; w++)
      found += strncmp(outcome.warnings.list[w].text, "stage `press` ", 14) == 0;
    if (found != rows[k].warned)
      printf("# %zu: %zu warnings\n", k, outcome.warnings.count);
    CU_ASSERT_EQUAL_FATAL(found, rows[k].warned ? 1 : 0);
    if (rows[k].warned) {
      char expected[320];
      snprintf(expected, sizeof expected,
               "stage `press` ended while a controlled stress differed from the target of the servo by %.3g %%; add a "
               "condition on this stress; its servo (line 11) ran at the largest rate in all cycles: raise `at most "
               "RATE` of the servo, or the number of cycles",
               100 * fabs(1 / rows[k].target - 1));
      CU_ASSERT_STRING_EQUAL(outcome.warnings.list[0].text, expected);
      CU_ASSERT_EQUAL(outcome.warnings.list[0].line, 10);
    }
    nb_outcome_free(&outcome);
  }
}

/* Stage `press` ends at a stress of 0, far from the target of its servo. There is no warning only if the servo of the
 * next stage controls the same components of the same stress towards the same target. */
static void servos_that_go_on(void) {
  static const struct {
    const char *press, *rest;
    bool warned;
  } rows[] = {{"xx 5 yy 6 on box", "xx 5 yy 6 on box", false}, {"xx 5 yy 6 on box", "xx 5 yy 6 on walls", true},
              {"xx 5 yy 6 on walls", "xx 5 yy 6 on M", true},  {"xx 5 yy 6 on M", "xx 5 yy 6 on M", false},
              {"xx 5 yy 6 on M", "xx 5 yy 6 on N", true},      {"xx 5 yy 6 on box", "xx 4 yy 6 on box", true},
              {"xx 5 yy 6 on box", "xx 5 yy 7 on box", true}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_outcome outcome;
    char text[1024];
    snprintf(text, sizeof text,
             "units none\nmaterial m density 1 kn 1000\nbox 0 0 to 9 9 m\ndisc 4 4 radius 1 m\nregion M all\n"
             "region N all\nstep 0.001\nrecord time\nstage press\nservo %s through box at most 1e-9\ncycles 2\n"
             "stage rest\nservo %s through box at most 1e-9\ncycles 2",
             rows[k].press, rows[k].rest);
    carry_out(&outcome, text, "report time", NULL);
    CU_ASSERT_EQUAL(outcome.status, NB_OK);
    bool warned = false;
    for (size_t w = 0; w < outcome.warnings.count; w++)
      warned = warned || strncmp(outcome.warnings.list[w].text, "stage `press` ended while", 25) == 0;
    if (warned != rows[k].warned)
      printf("# %s, then %s: %s\n", rows[k].press, rows[k].rest, outcome.error.text);
    CU_ASSERT_EQUAL(warned, rows[k].warned);
    nb_outcome_free(&outcome);
  }
}

/* With friction at the walls, an expectation causes a warning if its stress is not the one that the servo of its stage
 * controls. */
static void expectations_of_another_stress(void) {
  static const struct {
    const char *stress, *expectation;
    bool warned;
  } rows[] = {{"walls", "M.stress.xx in press expected 0 within 9 [t]", true},
              {"walls", "box.stress.xx in press expected 0 within 9 [t]", true},
              {"walls", "M.stress.xx expected 0 within 9 [t]", false}, /* of stage `rest`, without a servo */
              {"walls", "walls.stress.xx in press expected 0 within 9 [t]", false},
              {"box", "walls.stress.xx in press expected 0 within 9 [t]", true},
              {"box", "M.stress.xx in press expected 0 within 9 [t]", false},
              {"walls", "report M.stress.xx in press", false}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_outcome outcome;
    char text[512];
    snprintf(
        text, sizeof text,
        "units none\nmaterial m density 1 kn 1 ks 1 friction 0.5\nshear linear\nbox 0 0 to 9 9 m\ndisc 1 1 radius 1 "
        "m\nregion M all\nstep 1e-6\nrecord M.stress.xx box.stress.xx walls.stress.xx\nstage press\nservo "
        "isotropic 0 on %s through box at most 1e-9\ncycles 1\nstage rest\ncycles 1",
        rows[k].stress);
    carry_out(&outcome, text, rows[k].expectation, NULL);
    size_t found = 0;
    for (size_t w = 0; w < outcome.warnings.count; w++)
      found += strstr(outcome.warnings.list[w].text, ", and this expectation is on `") != NULL;
    if (found != rows[k].warned)
      printf("# %zu: %zu\n", k, found);
    CU_ASSERT_EQUAL(found, rows[k].warned ? 1 : 0);
    nb_outcome_free(&outcome);
  }
}

/* The row of discs of warnings_of_servos. If a servo ran at its largest rate in all cycles of a stage, a message says
 * so: the warning if the stage ends after a number of cycles, and the error if the condition of the stage is not met. */
static void servos_at_the_largest_rate(void) {
  static const struct {
    /* found: a part of the warning (first three rows) or of the error; NULL: the largest rate is not mentioned */
    const char *servo, *end, *found;
  } rows[] = {
      {"xx 4 on cell through cell at most 1e-9 per cycle", "cycles 5", "; its servo (line 11) ran at the largest rate"},
      {"xx 40 on cell through cell at most 1 per cycle", "cycles 2", "; end it by a condition on this stress"},
      {"xx 2.2 on cell through cell at most 1e-9 per cycle", "cycles 5", NULL},
      {"xx 4 on cell through cell at most 1e-9 per cycle", "until cell.stress.xx above 4 at most 5 cycles",
       "; its servo (line 11) ran at the largest rate"},
      {"xx 4 on cell through cell at most 1 per cycle", "until cell.stress.xx above 40 at most 5 cycles", NULL}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_outcome outcome;
    char text[1024];
    snprintf(text, sizeof text,
             "units none\nmaterial m density 1 kn 1000\nperiodic cell 0 0 to 5.97 4.5\ndisc 1 1 radius 1 m\ndisc 2.99 "
             "1 radius "
             "1 m\ndisc 4.98 1 radius 1 m\nstep 0.001\nrecord time cell.stress.xx\nstage press\nservo %s\n%s",
             rows[k].servo, rows[k].end);
    carry_out(&outcome, text, "report cell.stress.xx", NULL);
    const char *const said = outcome.status           ? outcome.error.text
                             : outcome.warnings.count ? outcome.warnings.list[0].text
                                                      : "";
    CU_ASSERT_EQUAL(outcome.status, k < 3 ? NB_OK : NB_BROKEN);
    CU_ASSERT_EQUAL(strstr(said, "at the largest rate in all cycles") != NULL,
                    rows[k].found != NULL && strstr(rows[k].found, "largest"));
    CU_ASSERT_PTR_NOT_NULL(strstr(said, rows[k].found ? rows[k].found : ""));
    nb_outcome_free(&outcome);
  }
}

/* Values with a dimension are reported in SI units. */
static void units(void) {
  struct nb_outcome outcome;
  make(&outcome, "",
       "A.x at 5 ms expected 5.5 mm within 1 mm [t]\ncycle expected 10 within 0 [t]\n"
       "cycle expected 2 of cycle at 5 cycles within 0 [t]\nA.x at 2 ms below A.x at 5 ms\n"
       "A.x at 6 ms expected 3 of A.x at 2 ms within 0.5 [t]",
       NULL);
  CU_ASSERT_EQUAL(outcome.status, NB_OK);
  CU_ASSERT_EQUAL_FATAL(outcome.check_count, 5);
  CU_ASSERT_STRING_EQUAL(outcome.checks[0].message,
                         "computed 0.005 m, expected 0.0055 m, error 0.0005 m, tolerance 0.001 m");
  CU_ASSERT_STRING_EQUAL(outcome.checks[1].message, "computed 10, expected 10, error 0, tolerance 0");
  CU_ASSERT_STRING_EQUAL(outcome.checks[2].message, "computed 2, expected 2, error 0, tolerance 0");
  CU_ASSERT_STRING_EQUAL(outcome.checks[3].message, "computed 0.002 m and 0.005 m");
  CU_ASSERT_STRING_EQUAL(outcome.checks[4].message, "computed 3, expected 3, error 0, tolerance 0.5"); /* a ratio */
  nb_outcome_free(&outcome);
}

/* The message about a moment without a row has a unit only if the moment is a time and the page has units. */
static void moments_without_rows(void) {
  static const char scene[] = "%smaterial m density 1%s kn 1%s\ndisc 0%s 0%s radius 1%s m\nmonitor A disc 1\nstep 1%s\n"
                              "record A.x\nstage one\ncycles 5";
  struct nb_outcome outcome;
  char text[512];
  snprintf(text, sizeof text, scene, "", " kg/m3", " N/m", " m", " m", " m", " ms");
  carry_out(&outcome, text, "report A.x at 7 ms\nreport A.x at 7 cycles", NULL);
  CU_ASSERT_EQUAL_FATAL(outcome.check_count, 2);
  CU_ASSERT_STRING_EQUAL(
      outcome.checks[0].message,
      "`A.x at 0.007 s` cannot be computed: no row was recorded at that moment, only from time 0 to 0.005 s");
  CU_ASSERT_STRING_EQUAL(
      outcome.checks[1].message,
      "`A.x at 7 cycles` cannot be computed: no row was recorded at that moment, only from cycle 0 to 5");
  nb_outcome_free(&outcome);
  snprintf(text, sizeof text, scene, "units none\n", "", "", "", "", "", "");
  carry_out(&outcome, text, "report A.x at 7", NULL);
  CU_ASSERT_EQUAL_FATAL(outcome.check_count, 1);
  CU_ASSERT_STRING_EQUAL(outcome.checks[0].message,
                         "`A.x at 7` cannot be computed: no row was recorded at that moment, only from time 0 to 5");
  nb_outcome_free(&outcome);
}

/* A stage may have the name `all`; then `in all` means this stage. */
static void a_stage_named_all(void) {
  struct nb_outcome outcome;
  carry_out(&outcome,
            "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nstep 1\nrecord cycle\nstage all\ncycles 2\n"
            "stage rest\ncycles 3",
            "cycle max in all expected 2 within 0 [t]\ncycle max in rest expected 5 within 0 [t]", NULL);
  CU_ASSERT_EQUAL(outcome.status, NB_OK);
  CU_ASSERT_EQUAL(outcome.mark_count[NB_PASS], 2);
  nb_outcome_free(&outcome);
}

/* The first stage records nothing. A reported value needs rows of its own stage only. A comparison with a stage without
 * rows fails. The message about a curve has the units of both quantities. */
static void stages_without_rows(void) {
  struct nb_outcome outcome;
  carry_out(&outcome,
            "material m density 1 kg/m3 kn 1 N/m\nwall floor -1 m 0 m to 1 m 0 m m\ndisc 0 m 5 m radius 1 m m\n"
            "gravity 0 m/s2 -10 m/s2\nmonitor D disc 1\nmonitor C disc 1 with wall floor\nstep 1 ms\nrecord D.y time\n"
            "stage one\nrecord none\ncycles 5\nstage two\ncycles 5",
            "reference free_fall\nreport D.y\nD.y in one below D.y\nD.y in two above D.y in one\n"
            "D.y versus time within 1 mm",
            NULL);
  CU_ASSERT_EQUAL(outcome.status, NB_FAILED);
  CU_ASSERT_EQUAL_FATAL(outcome.check_count, 4);
  CU_ASSERT_EQUAL(outcome.checks[0].mark, NB_NOTE);
  CU_ASSERT_STRING_EQUAL(outcome.checks[0].message, "computed 4.9995 m");
  for (int k = 1; k < 3; k++) {
    CU_ASSERT_EQUAL(outcome.checks[k].mark, NB_FAIL);
    CU_ASSERT_STRING_EQUAL(outcome.checks[k].message, "`D.y in one` cannot be computed: no row was recorded there");
  }
  CU_ASSERT_EQUAL(outcome.checks[3].mark, NB_PASS);
  const char *end = strstr(outcome.checks[3].message, "; the worst of 5 rows, at time = 0.0");
  CU_ASSERT(end && strcmp(end + strlen(end) - 2, " s") == 0);
  nb_outcome_free(&outcome);
}

/* Deep contacts are counted over all runs, in the 9 cycles of each run and at its start. The first one is named, with
 * its run if there are several runs. At a distance of 1.9 the contact is not deep. */
static void deep_overlaps_of_all_runs(void) {
  static const struct {
    const char *distances, *where;
    int updates; /* 0: no warning */
  } rows[] = {{"sweep d 1.9 1.8 1.7", ", run d=1.8", 20},
              {"sweep d 1.7 1.9 1.8", ", run d=1.7", 20},
              {"sweep d 1.9 1.95 1.7", ", run d=1.7", 10},
              {"let d = 1.7", "", 10},
              {"let d = 1.9", NULL, 0}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    char scene[512], expected[256];
    struct nb_outcome outcome;
    snprintf(scene, sizeof scene,
             "units none\n%s\nmaterial m density 0.24 young 1 poisson 0\nnormal hertz\nsphere 0 0 radius 1 m fixed\n"
             "sphere $d 0 radius 1 m\nstep 1e-9\nrecord cycle\nstage s\ncycles 9",
             rows[k].distances);
    carry_out(&outcome, scene, "cycle expected 9 within 0 [t]", NULL);
    CU_ASSERT_EQUAL(outcome.status, NB_OK);
    CU_ASSERT_EQUAL_FATAL(outcome.warnings.count, rows[k].where ? 1 : 0);
    snprintf(expected, sizeof expected,
             "overlaps beyond the range of the theory of elastic spheres, in %d contact updates; the first one is "
             "that of particle 1 and particle 2, in cycle 0, at time 0%s [R89 sec. 6.4.3]",
             rows[k].updates, rows[k].where ? rows[k].where : "");
    if (rows[k].where)
      CU_ASSERT_STRING_EQUAL(outcome.warnings.list[0].text, expected);
    nb_outcome_free(&outcome);
  }
}

/* The error of a run names the line of the particle, and the run if there are several runs. No run is started after the
 * error. */
static void error_of_a_run(void) {
  static const struct {
    const char *distances, *run;
    int line;
    size_t failed;
  } rows[] = {{"sweep d 0.1 1.9 1.8\n", " (run d=0.1)", 6, 0},
              {"sweep d 1.9 0.1 1.8\n", " (run d=0.1)", 6, 1},
              {"sweep d 1.9 1.8 0.1\n\n", " (run d=0.1)", 7, 2},
              {"let d = 0.1\n", "", 6, 0}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_outcome outcome;
    char scene[256], expected[256];
    snprintf(scene, sizeof scene,
             "units none\n%smaterial m density 1 kn 1\ndisc 0 0 radius 1 m\ndisc $d 0 radius 1 m\nstep 0.001\n"
             "record cycle\nstage one\ncycles 5",
             rows[k].distances);
    carry_out(&outcome, scene, "cycle expected 5 within 0 [t]", NULL);
    snprintf(
        expected, sizeof expected,
        "particle 2 overlaps particle 1 (line %d) by 1.9. Expected at most the smaller radius, 1: move the particles "
        "apart, or make them smaller%s",
        rows[k].line - 1, rows[k].run);
    CU_ASSERT_EQUAL(outcome.status, NB_BAD_USE);
    CU_ASSERT_STRING_EQUAL(outcome.error.text, expected);
    CU_ASSERT_EQUAL(outcome.error.line, rows[k].line);
    for (size_t r = 0; r < outcome.run_count; r++)
      CU_ASSERT_EQUAL(outcome.runs[r].done, r <= rows[k].failed ? 1 : 0);
    nb_outcome_free(&outcome);
  }
}

/* A mistake that every run would report is reported once. If the reference does not cover the scene, the first run has
 * an error. */
static void mistakes_of_all_runs(void) {
  static const char scene[] =
      "sweep v 1 2\nmaterial m density 1 kg/m3 kn 1 N/m\ndisc 0 m 0 m radius 1 m %s velocity $v "
      "m/s 0 m/s\nmonitor D disc 1\nstep 1 ms\nrecord D.x\nstage one\ncycles 5";
  for (int wrong = 0; wrong < 2; wrong++) {
    struct nb_outcome outcome;
    char text[512];
    snprintf(text, sizeof text, scene, wrong ? "n" : "m");
    carry_out(&outcome, text, "reference free_fall\nD.x within 1 mm", NULL);
    CU_ASSERT_EQUAL(outcome.status, NB_BAD_USE);
    CU_ASSERT_EQUAL(outcome.mistakes.total, (size_t)wrong);
    CU_ASSERT_EQUAL(outcome.run_count, wrong ? 1 : 2);
    if (!wrong)
      CU_ASSERT_STRING_EQUAL(outcome.error.text,
                             "the reference `free_fall` does not cover `velocity` (line 4); it covers `disc`, "
                             "`sphere`, `wall`, `gravity`, `damping stiffness`, `damping r89-fraction`, `damping "
                             "ratio`, `damping walls`, `until` (run v=1)");
    nb_outcome_free(&outcome);
  }
}

/* The outcome has the warnings of all runs, about the page and about the motion, each once. */
static void warnings_of_all_runs(void) {
  static const char *const places[] = {"sweep x 1e13 0 0.5\n", "sweep x 0 1e13 0.5\n", "sweep x 0 0.5 1e13\n",
                                       "let x = 1e13\n"};
  for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
    struct nb_outcome outcome;
    char scene[256];
    snprintf(scene, sizeof scene,
             "units none\n%smaterial m density 1 kn 1 friction 0.5\ndisc $x 0 radius 1 m\ndisc $x 9 radius 1 m\n"
             "step 0.001\n"
             "record cycle\nstage one\ncycles 5",
             places[k]);
    carry_out(&outcome, scene, "cycle expected 5 within 0 [t]", NULL);
    CU_ASSERT_EQUAL(outcome.status, NB_OK);
    CU_ASSERT_EQUAL_FATAL(outcome.warnings.count, 2);
    CU_ASSERT_PTR_NOT_NULL(strstr(outcome.warnings.list[0].text, "friction between `m` and `m` has no effect"));
    CU_ASSERT_PTR_NOT_NULL(strstr(outcome.warnings.list[1].text, "particle 1: its coordinate 1e+13"));
    nb_outcome_free(&outcome);
  }
}

/* Quantities of a removed particle and of its contacts are 0. One warning says so, with the line that removes the
 * particle. There is no warning about the position and the angle, which keep their last values, and none if the page
 * expects 0. */
static void warnings_of_removed_particles(void) {
  static const struct {
    const char *quantity, *expectation, *wanted; /* the quantity of the warning; NULL: no warning */
    bool first;                                  /* the first stage removes the disc */
  } cases[] = {
      {"A.vx", "A.vx in one below 3", "`A.vx` is 0 from stage `three` on", false},
      {"C.normal", "report C.normal", "`C.normal` is 0 from stage `three` on", false},
      {"E.normal", "report E.normal", "`E.normal` is 0 from stage `three` on", false},
      {"F.normal", "report F.normal", "for a value before, write `F.normal in two`", false},
      {"A.vx", "report A.vx", "`A.vx` is 0 in all stages, because this line removes its particle in the first one",
       true},
      {"E.normal", "report E.normal", "`E.normal` is 0 in all stages", true},
      {"C.normal", "C.normal expected 0 within 0 [t]", NULL, false},
      {"A.vx B.vx", "B.vx expected 0 within 9 [t]", "`A.vx` is 0 from stage `three` on", false},
      {"A.x", "report A.x", NULL, false},
      {"A.y", "report A.y", NULL, false},
      {"A.angle", "report A.angle", NULL, false},
      {"B.vx", "report B.vx", NULL, false},
      {"W.fx", "report W.fx", NULL, false},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    struct nb_outcome outcome;
    static const char remove[] = "remove disc 2\n";
    char scene[512];
    snprintf(scene, sizeof scene,
             "units none\nsweep v 1 2\nmaterial m density 1 kn 1\nwall floor -9 0 to 9 0 m\ndisc 3 1 radius 1 m\n"
             "disc 0 1 radius 1 m velocity $v 0\nmonitor B disc 1\nmonitor A disc 2\nmonitor C disc 1 with disc 2\n"
             "monitor E disc 2 with disc 1\nmonitor F disc 2 with wall floor\nmonitor W wall floor\nstep 0.001\nrecord "
             "cycle %s\nstage one\n%scycles 5\n"
             "stage two\ncycles 5\nstage three\n%scycles 5",
             cases[k].quantity, cases[k].first ? remove : "", cases[k].first ? "" : remove);
    carry_out(&outcome, scene, cases[k].expectation, NULL);
    CU_ASSERT_EQUAL(outcome.status, NB_OK);
    CU_ASSERT_EQUAL_FATAL(outcome.warnings.count, cases[k].wanted ? 1 : 0);
    if (cases[k].wanted)
      CU_ASSERT_PTR_NOT_NULL(strstr(outcome.warnings.list[0].text, cases[k].wanted));
    nb_outcome_free(&outcome);
  }
}

/* The warning names the stage that removes the particle, the stage before it, and the line of the statement. Of a pair
 * the side that is removed first counts. The number of a wall is not that of a particle: disc 2 is removed, and wall
 * `left` is the second wall. Disc 1 and the walls `low` and `left` are not removed; stage three only sets the velocity of
 * `left`. */
static void stages_of_removed_particles(void) {
  static const struct {
    const char *monitor, *quantity, *stage, *before; /* NULL: no warning */
    int line;
  } rows[] = {
      {"disc 1", "vx", NULL, NULL, 0},
      {"disc 2", "vx", "three", "two", 24},
      {"disc 3", "vx", "two", "one", 21},
      {"disc 4", "vx", "two", "one", 21},
      {"disc 5", "vx", NULL, NULL, 0},
      {"disc 6", "vx", NULL, NULL, 0},
      {"disc 7", "vx", "two", "one", 20},
      {"disc 1 with disc 2", "normal", "three", "two", 24},
      {"disc 2 with disc 1", "normal", "three", "two", 24},
      {"disc 2 with disc 4", "normal", "two", "one", 21},
      {"disc 4 with disc 2", "normal", "two", "one", 21},
      {"disc 3 with disc 7", "normal", "two", "one", 21},
      {"disc 5 with disc 7", "normal", "two", "one", 20},
      {"disc 1 with disc 5", "normal", NULL, NULL, 0},
      {"disc 1 with wall left", "normal", NULL, NULL, 0},
      {"disc 2 with wall left", "normal", "three", "two", 24},
      {"disc 7 with wall low", "normal", "two", "one", 20},
      {"disc 1 with wall right", "normal", "three", "two", 25},
      {"disc 2 with wall right", "normal", "three", "two", 24},
      {"disc 3 with wall right", "normal", "two", "one", 21},
      {"wall left", "fx", NULL, NULL, 0},
      {"wall right", "fx", "three", "two", 25},
      {"wall right", "x", NULL, NULL, 0},
      {"wall right", "angle", NULL, NULL, 0},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_outcome outcome;
    char scene[1024], expected[256] = "";
    snprintf(scene, sizeof scene,
             "units none\nmaterial m density 1 kn 1\nwall low -99 0 to 99 0 m\nwall left -9 50 to -9 0 m\nwall right "
             "99 50 to 99 0 m\n"
             "disc 0 1 radius 1 m\ndisc 3 1 radius 1 m\ndisc 6 1 radius 1 m\ndisc 9 1 radius 1 m\n"
             "disc 12 1 radius 1 m\ndisc 15 1 radius 1 m\ndisc 18 1 radius 1 m\nmonitor M %s\nstep 0.001\n"
             "record cycle M.%s\nstage one\ncycles 1\nstage two\nremove disc 7\nremove discs 3 to 4\ncycles 1\n"
             "stage three\nremove disc 2\nremove wall right\nwall left velocity 0 0\ncycles 1",
             rows[k].monitor, rows[k].quantity);
    carry_out(&outcome, scene, "report cycle", NULL);
    CU_ASSERT_EQUAL(outcome.status, NB_OK);
    CU_ASSERT_EQUAL_FATAL(outcome.warnings.count, rows[k].stage ? 1 : 0);
    if (rows[k].stage) {
      snprintf(expected, sizeof expected,
               "`M.%s` is 0 from stage `%s` on, because this line removes its %s; for a value before, write "
               "`M.%s in %s`",
               rows[k].quantity, rows[k].stage, rows[k].line == 25 ? "wall" : "particle", rows[k].quantity,
               rows[k].before);
      CU_ASSERT_STRING_EQUAL(outcome.warnings.list[0].text, expected);
      CU_ASSERT_EQUAL(outcome.warnings.list[0].line, rows[k].line);
    }
    nb_outcome_free(&outcome);
  }
}

/* A quantity of a box that has lost a wall is computed as if the wall were in its place, and a warning says so. Another
 * wall is not part of the box. */
static void a_box_without_one_of_its_walls(void) {
  static const struct {
    const char *wall, *quantity;
    bool warned;
  } rows[] = {{"south", "box.stress.xx", true}, {"west", "box.porosity", true}, {"west", "walls.ratio", true},
              {"low", "box.stress.xx", false},  {"high", "box.width", false},   {"west", "energy.kinetic", false}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_outcome outcome;
    char scene[512], expected[256];
    snprintf(scene, sizeof scene,
             "units none\nmaterial m density 1 kn 1\nwall low -9 -9 to 19 -9 m\nbox 0 0 to 9 9 m\n"
             "wall high -9 19 to 19 19 m\ndisc 4 4 radius 1 m\nstep 0.001\nrecord cycle %s\nstage one\ncycles 1\n"
             "stage two\nremove wall %s\ncycles 1",
             rows[k].quantity, rows[k].wall);
    carry_out(&outcome, scene, "report cycle", NULL);
    CU_ASSERT_EQUAL(outcome.status, NB_OK);
    CU_ASSERT_EQUAL_FATAL(outcome.warnings.count, rows[k].warned);
    snprintf(expected, sizeof expected,
             "`%s` is computed from stage `two` on as if wall `%s` were still in its place, without forces on it: this "
             "line removes it",
             rows[k].quantity, rows[k].wall);
    if (rows[k].warned) {
      CU_ASSERT_STRING_EQUAL(outcome.warnings.list[0].text, expected);
      CU_ASSERT_EQUAL(outcome.warnings.list[0].line, 13);
    }
    nb_outcome_free(&outcome);
  }
}

/* A run tracks the columns of particles and contacts of which a check of one run uses the largest or the smallest
 * value, and no others. */
static void tracked_columns(void) {
  static const struct {
    const char *column, *expectation;
    bool tracked;
  } rows[] = {
      {"A.vx", "A.vx max expected 1 within 1 [t]", true},
      {"P.normal", "P.normal max below 1", true},
      {"W.normal", "W.normal min above 1", true},
      {"A.vx", "A.vx amplitude within 1", true},
      {"A.vx", "A.vx expected 1 within 1 [t]", false},
      {"A.vx", "A.vx mean below 1", false},
      {"A.vx", "A.vx frequency below 1", false},
      {"A.vx", "A.vx at 1 above 1", false},
      {"A.vx", "report A.vx max", false},
      {"A.vx", "A.vx versus time within 1", false},
      {"A.vx", "A.vx max increases with v", false},
      {"A.vx", "A.vx max decreases with v", false},
      {"A.vx", "A.vx max constant with v within 1", false},
      {"A.vx", "A.vx max order 1 in v within 1", false},
      {"A.vx", "A.vx max expected 1 over v [t]", false},
      {"A.vx", "A.vx max below 1\nA.vx mean below 1", true},
      {"A.vx", "A.vx mean below 1\nA.vx max below 1", true},
      {"A.vx", "P.normal max below 1", false},
      {"R.stress.mean", "R.stress.mean max below 1", false},
      {"L.fx", "L.fx max below 1", false},
      {"energy.kinetic", "energy.kinetic max below 1", false},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_outcome outcome;
    char path[] = "/tmp/nineball-outcome-XXXXXX", text[128];
    snprintf(text, sizeof text, "reference free_fall\n%s", rows[k].expectation);
    write_page(
        path,
        "units none\nsweep v 1 2\nmaterial m density 1 kn 1\nwall low -9 0 to 9 0 m\n"
        "disc 0 1 radius 1 m velocity $v 0\ndisc 3 1 radius 1 m\nmonitor A disc 1\nmonitor P disc 1 with disc 2\n"
        "monitor W disc 1 with wall low\nmonitor L wall low\nregion R all\nstep 0.001\n"
        "record time A.vx P.normal W.normal L.fx R.stress.mean energy.kinetic\nstage one\ncycles 1",
        text);
    nb_outcome_read(&outcome, path, NULL);
    unlink(path);
    if (outcome.mistakes.text)
      printf("# %s", outcome.mistakes.text);
    CU_ASSERT_EQUAL_FATAL(outcome.run_count, 2);
    for (size_t r = 0; r < 2; r++)
      for (size_t c = 0; c < outcome.runs[r].scene.column_count; c++) {
        const struct nb_column *const column = &outcome.runs[r].scene.columns[c];
        if (strcmp(column->name, rows[k].column) == 0) {
          if (column->tracked != rows[k].tracked)
            printf("# %s\n", rows[k].expectation);
          CU_ASSERT_EQUAL(column->tracked, rows[k].tracked);
        }
      }
    nb_outcome_free(&outcome);
  }
}

/* A negative normal stress in an expectation, and a negative normal force, which no law gives, cause a warning with the
 * line of the expectation. Other quantities, other relations, fractions of a measure, and values of 0 or more cause
 * none. The page has no units, so the proposed pressure has none. */
static void warnings_of_tension(void) {
  static const char force[] = "`C.normal` is 0 or more with all laws";
  static const struct {
    const char *expectation, *wanted; /* NULL: no warning */
  } rows[] = {
      {"R.stress.xx expected -1 within 9 [t]", "for a pressure write `R.stress.xx expected 1`"},
      {"R.stress.xx below -1", "for a pressure write `R.stress.xx above 1`"},
      {"R.stress.xx expected 1 within 9 [t]", NULL},
      {"R.stress.xx expected 0 within 9 [t]", NULL},
      {"R.stress.xx above -1", NULL},
      {"R.stress.xx expected -1 of R.stress.yy within 9 [t]", NULL},
      {"R.stress.xx below R.stress.yy", NULL},
      {"R.stress.yy below -1", "for a pressure write `R.stress.yy above 1`"},
      {"R.stress.mean expected -1 within 9 [t]", "for a pressure write `R.stress.mean expected 1`"},
      {"R.stress.major below -1", "for a pressure write `R.stress.major above 1`"},
      {"R.stress.minor below -1", "for a pressure write `R.stress.minor above 1`"},
      {"C.normal expected -1 within 9 [t]", force},
      {"C.normal below -1", force},
      {"C.normal above -1", force},
      {"C.normal above C.shear", NULL},
      {"C.normal expected 0 within 9 [t]", NULL},
      {"C.normal expected 1 within 9 [t]", NULL},
      {"C.normal below 0", NULL},
      {"C.normal expected -1 of C.shear within 9 [t]", NULL},
      {"C.shear expected -1 within 9 [t]", NULL},
      {"C.overlap expected -1 within 9 [t]", NULL}, /* never below 0, whatever the law */
      {"C.shear below -1", NULL},
      {"R.stress.xy expected -1 within 9 [t]", NULL},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_outcome outcome;
    char path[] = "/tmp/nineball-outcome-XXXXXX";
    write_page(path,
               "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\ndisc 2 0 radius 1 m\n"
               "monitor C disc 1 with disc 2\nregion R all\nstep 0.001\n"
               "record C.normal C.shear C.overlap R.stress.xx R.stress.yy R.stress.xy R.stress.mean R.stress.major "
               "R.stress.minor\nstage "
               "one\ncycles 1",
               rows[k].expectation);
    nb_outcome_read(&outcome, path, NULL);
    unlink(path);
    if (outcome.mistakes.text || outcome.warnings.count != (rows[k].wanted ? 1 : 0))
      printf("# %s: %zu, %s\n", rows[k].expectation, outcome.warnings.count, outcome.mistakes.text);
    CU_ASSERT_EQUAL_FATAL(outcome.warnings.count, rows[k].wanted ? 1 : 0);
    if (rows[k].wanted) {
      CU_ASSERT_PTR_NOT_NULL(strstr(outcome.warnings.list[0].text, rows[k].wanted));
      CU_ASSERT_EQUAL(outcome.warnings.list[0].line, 14);
    }
    nb_outcome_free(&outcome);
  }
}

/* The imposed work of a page in which only walls and fixed particles move is 0, which causes a warning, unless the page
 * expects 0 or records the work of the walls, too. There is no warning if nothing moves, or if a stage imposes a motion
 * or a stress on particles. */
static void warnings_of_the_imposed_work(void) {
  static const char box[] = "box 0 0 to 9 9 m",
                    cell[] = "periodic cell 0 0 to 9 9\ndisc 5 5 radius 1 m fixed velocity 1 0";
  static const char ring[] = "boundary circle 0 0 radius 1\ndisc 5 5 radius 1 m fixed velocity 1 0";
  static const char fixed[] = "disc 5 5 radius 1 m fixed velocity 1 0", wall[] = "wall w 0 0 to 9 0 m velocity 0 -1";
  static const struct {
    const char *scene, *first, *second, *expectation;
    bool warned;
  } cases[] = {
      {box, "", "walls inward 1e-3", "report energy.imposed", true},
      {box, "box strain 0 -1e-3", "", "report energy.imposed", true},
      {box, "", "servo isotropic 1 on box through box at most 1e-3", "report energy.imposed", true},
      {wall, "", "", "report energy.imposed", true},
      {fixed, "", "", "report energy.imposed", true},
      {"disc 5 5 radius 1 m fixed velocity 0 1", "", "", "report energy.imposed", true},
      {"disc 5 5 radius 1 m fixed spin 1", "", "", "report energy.imposed", true},
      {"wall w 0 0 to 9 0 m velocity 1 0", "", "", "report energy.imposed", true},
      {"wall w 0 0 to 9 0 m spin 1e-3 about 0 0", "", "", "report energy.imposed", true},
      {box, "box strain -1e-3 0", "", "report energy.imposed", true},
      {cell, "", "cell strain 0 1e-3", "report energy.imposed", false},
      {cell, "", "cell strain 0 0 c12 1e-3", "report energy.imposed", false},
      {cell, "", "cell strain 0 0 c21 1e-3", "report energy.imposed", false},
      {box, "", "walls inward 1e-3", "energy.imposed expected 0 within 0 [t]", false},
      {box, "", "walls inward 1e-3", "energy.imposed expected 1 within 2 [t]", true},
      {box, "", "walls inward 1e-3", "report time", true}, /* the page records the imposed work */
      {box, "", "walls inward 1e-3", "report energy.walls", false},
      {box, "", "", "report energy.imposed", false},
      {box, "walls inward 1e-3", "affine strain 1e-3 0", "report energy.imposed", false},
      {cell, "", "cell strain 1e-3 0", "report energy.imposed", false},
      {cell, "", "servo isotropic 1 on cell through cell at most 1e-3", "report energy.imposed", false},
      {ring, "boundary strain 0 0 c12 1e-3", "", "report energy.imposed", false},
      {ring, "boundary stress 1 1", "", "report energy.imposed", false},
      {ring, "boundary stress 1 1", "boundary stress 2 2", "report energy.imposed", false},
      {ring, "boundary strain 0 0", "", "report energy.imposed", true},
      {ring, "servo isotropic 1 on boundary through boundary at most 1e-3", "", "report energy.imposed", false},
      {cell, "", "", "report energy.imposed", true},
      {"wall w 0 0 to 9 0 m velocity 1 0\nwall v 0 9 to 9 9 m", "", "", "report energy.imposed", true},
      {"wall v 0 9 to 9 9 m\nwall w 0 0 to 9 0 m velocity 1 0", "", "", "report energy.imposed", true},
      {"disc 5 5 radius 1 m fixed spin 1\ndisc 8 8 radius 1 m fixed", "", "", "report energy.imposed", true},
      {"disc 5 5 radius 1 m fixed\ndisc 8 8 radius 1 m velocity 1 0", "", "", "report energy.imposed", false},
      {box, "walls inward 1e-3", "walls stop", "report energy.imposed", true},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    struct nb_outcome outcome;
    char scene[512];
    size_t found = 0;
    snprintf(scene, sizeof scene,
             "units none\nmaterial m density 1 kn 1\n%s\ndisc 2 2 radius 1 m\nstep 1e-4\nrecord time%s "
             "energy.imposed\nstage one\n%s\ncycles 1\nstage two\n%s\ncycles 1",
             cases[k].scene, strstr(cases[k].expectation, "walls") ? " energy.walls" : "", cases[k].first,
             cases[k].second);
    carry_out(&outcome, scene, cases[k].expectation, NULL);
    CU_ASSERT(outcome.status <= NB_FAILED);
    for (size_t w = 0; w < outcome.warnings.count; w++)
      if (strcmp(outcome.warnings.list[w].text, "`energy.imposed` is 0, because only walls and fixed particles move: "
                                                "their work is `energy.walls`") == 0) {
        found++;
        CU_ASSERT_EQUAL(outcome.warnings.list[w].line, strchr(cases[k].scene, '\n') ? 8 : 7); /* the line of `record` */
      }
    if (found != cases[k].warned)
      printf("# %zu: %zu warnings, %s\n", k, found, outcome.error.text);
    CU_ASSERT_EQUAL(found, cases[k].warned);
    nb_outcome_free(&outcome);
  }
}

/* A name that no line uses has no effect. A sweep of which no line uses a name makes equal runs. */
static void names_that_no_line_uses(void) {
  static const struct {
    const char *sweep, *step, *expectation, *setting,
        *unused; /* unused: the names, and the first names of the sweeps, with a warning */
  } cases[] = {
      {"sweep h 1e-3 2e-3", "step $h", "time above 0", NULL, ""},
      {"sweep h 1e-3 2e-3", "step (2*h)", "time above 0", NULL, ""},
      {"sweep h 1e-3 2e-3\nlet g = h", "step 1e-3", "time above 0", NULL, "g"},
      {"sweep h 1e-3 2e-3\nlet g = h", "step $g", "time above 0", NULL, ""},
      {"sweep step 1e-3 2e-3", "step 1e-3", "time above 0", NULL, "step"},
      {"sweep h 1e-3 2e-3", "step 1e-3", "time below (h + 1)", NULL, ""},
      {"sweep h 1e-3 2e-3", "step 1e-3", "time constant with h within 1 %", NULL, "h"},
      {"sweep h with k 1e-3 1 2e-3 2", "step $h", "time above 0", NULL, ""},
      {"sweep k with h 1 1e-3 2 2e-3", "step $h", "time above 0", NULL, ""},
      {"sweep k with h 1 1e-3 2 2e-3", "step 1e-3", "time above 0", NULL, "k"},
      {"sweep h 1e-3 2e-3\nsweep k 1 2", "step $h", "time above 0", NULL, "k"},
      {"sweep k 1 2\nsweep h 1e-3 2e-3", "step $h", "time above 0", NULL, "k"},
      {"sweep k 1 2\nsweep h 1e-3 2e-3", "step 1e-3", "time above 0", NULL, "kh"},
      {"sweep k 1 2", "step 1e-3", "time above 0", "k=1", ""}, /* one run */
      {"sweep k with h 1 1e-3 2 2e-3", "step $h", "time above 0", "k=1", ""},
      {"let k = 1", "step 1e-3", "time above 0", NULL, "k"},
      {"let k = 1", "step 1e-3", "time above 0", "k=2", "k"},
      {"let k = 1", "step 1e-3", "time below $k", NULL, ""},
      {"let k = 1e-3\nlet h = 1e-3", "step $h", "time above 0", NULL, "k"},
      {"let k = 1e-3\nlet h = 1e-3", "step $k", "time above 0", NULL, "h"},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    static const char before[] = "no line uses `$";
    struct nb_outcome outcome;
    char scene[512], unused[64] = "";
    snprintf(scene, sizeof scene,
             "units none\nmaterial m density 1 kn 1\n%s\ndisc 2 2 radius 1 m\n%s\nrecord time\nstage one\ncycles 1",
             cases[k].sweep, cases[k].step);
    const char *const settings[] = {cases[k].setting, NULL};
    char path[] = "/tmp/nineball-outcome-XXXXXX";
    write_page(path, scene, cases[k].expectation);
    nb_outcome_make(&outcome, path, cases[k].setting ? settings : NULL, NULL, NULL);
    unlink(path);
    CU_ASSERT(outcome.status <= NB_FAILED);
    if (outcome.mistakes.text)
      printf("# %s", outcome.mistakes.text);
    for (size_t w = 0; w < outcome.warnings.count; w++) {
      const char *const text = outcome.warnings.list[w].text;
      if (strncmp(text, before, strlen(before)) == 0) {
        const size_t length = strcspn(text + strlen(before), "`"), end = strlen(unused);
        snprintf(unused + end, sizeof unused - end, "%.*s", (int)length, text + strlen(before));
        CU_ASSERT(outcome.warnings.list[w].line == 4 || outcome.warnings.list[w].line == 5);
      }
    }
    if (strcmp(unused, cases[k].unused) != 0)
      printf("# %zu: `%s`, expected `%s`; %s\n", k, unused, cases[k].unused, outcome.error.text);
    CU_ASSERT_STRING_EQUAL(unused, cases[k].unused);
    nb_outcome_free(&outcome);
  }
}

/* A failed check of a normal force that is twice the expected force, or of an overlap that is half the expected
 * overlap, says which stiffness a contact has. With kn = 1 and the overlap 0.1 the force is 0.1. Other ratios have no
 * such note, nor has a ratio that may have another cause: the overshoot of a load, gravity, or a `pair` that gives
 * `kn`. */
static void stiffness_of_springs_in_series(void) {
  static const struct {
    const char *expectation;
    bool noted;
    const char *scene, *stage; /* more statements */
  } cases[] = {
      {"C.normal expected 0.05 within 1 % [t]", true},
      {"C.normal expected 0.0503 within 1 % [t]", true},
      /* the ratios 1.98 and 2.02 are the limits for a force, 0.495 and 0.505 for an overlap */
      {"C.normal expected (0.1/1.98001) within 1 % [t]", true},
      {"C.normal expected (0.1/1.97999) within 1 % [t]", false},
      {"C.normal expected (0.1/2.01999) within 1 % [t]", true},
      {"C.normal expected (0.1/2.02001) within 1 % [t]", false},
      {"C.overlap expected (0.1/0.495005) within 1 % [t]", true},
      {"C.overlap expected (0.1/0.494995) within 1 % [t]", false},
      {"C.overlap expected (0.1/0.504995) within 1 % [t]", true},
      {"C.overlap expected (0.1/0.505005) within 1 % [t]", false},
      {"C.normal expected 0.052 within 1 % [t]", false},
      {"C.normal expected 0.2 within 1 % [t]", false},
      {"C.overlap expected 0.2 within 1 % [t]", true},
      {"C.overlap expected 0.05 within 1 % [t]", false},
      {"C.normal expected 0.05 within 200 % [t]", false},
      {"B.x expected 3.8 within 1 % [t]", false},
      {"C.normal expected 0.5 of C.overlap within 1 % [t]", false},
      {"C.normal max expected 0.05 within 1 % [t]", false},
      {"C.overlap min expected 0.2 within 1 % [t]", false},
      {"C.normal mean expected 0.05 within 1 % [t]", true},
      {"C.normal expected 0.05 within 1 % [t]", false, "gravity 0 -1e-9\n", ""},
      {"C.normal expected 0.05 within 1 % [t]", false, "", "gravity 0 -1e-9\n"},
      {"C.normal expected 0.05 within 1 % [t]", false, "pair m m kn 1\n", ""},
      {"C.normal expected 0.05 within 1 % [t]", true, "pair m m friction 0\n", ""},
      {"C.normal expected 0.05 within 1 % [t]", false, "", "pair m m kn 1\n"},
      {"C.normal expected 0.05 within 1 % [t]", true, "", "pair m m friction 0\n"},
      {"C.normal expected 0.05 within 1 % [t]", false, "", "pair m m kn 1\npair m m friction 0\n"},
      {"C.normal expected 0.05 within 1 % [t]", true, "", "material m kn 1\n"},
      {"C.normal expected (0.1^1.5*0.5^0.5/3) within 1 % [t]", false, "normal hertz\n", ""}, /* E* 0.5, R* 0.5 */
      /* the cause may stand in any of several lines or stages */
      {"C.normal expected 0.05 within 1 % [t]", false,
       "material o density 1 kn 1\npair m m kn 1\npair m o friction 0\n", ""},
      {"C.normal expected 0.05 within 1 % [t]", false,
       "material o density 1 kn 1\npair m o friction 0\npair m m kn 1\n", ""},
      {"C.normal expected 0.05 within 1 % [t]", false, "", "gravity 0 -1e-9\ncycles 1\nstage two\n"},
      {"C.normal expected 0.05 within 1 % [t]", false, "", "cycles 1\nstage two\ngravity 0 -1e-9\n"}};
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    struct nb_outcome outcome;
    char scene[512];
    snprintf(scene, sizeof scene,
             "units none\nmaterial m density 1 kn 1 young 1 poisson 0\n%ssphere 0 0 radius 1 m\nsphere 1.9 0 radius 1 "
             "m\nmonitor B sphere "
             "2\nmonitor C sphere 1 with sphere 2\nstep 1e-6\nrecord C.normal C.overlap B.x\nstage one\n%scycles 1",
             cases[k].scene ? cases[k].scene : "", cases[k].stage ? cases[k].stage : "");
    carry_out(&outcome, scene, cases[k].expectation, NULL);
    CU_ASSERT_EQUAL_FATAL(outcome.check_count, 1);
    const char *const message = outcome.checks[0].message;
    const char *const note =
        strncmp(cases[k].expectation, "C.overlap", 9) == 0 ? "; the ratio is 0.5: if" : "; the ratio is 2: if";
    const bool noted = strstr(message, note) != NULL;
    CU_ASSERT(!noted || strstr(message, ": if the expected value is that of two springs in series, note that a contact "
                                        "has the whole `kn` of its material, or 2ab/(a+b) of two materials, not half "
                                        "of it"));
    if (noted != cases[k].noted)
      printf("# %s: %s\n", cases[k].expectation, message);
    CU_ASSERT_EQUAL(noted, cases[k].noted);
    nb_outcome_free(&outcome);
  }
}

/* A disc of mass 1 is laid on a wall under the gravity 1. It oscillates, and its largest normal force is 2, twice its
 * weight. That is no error of the stiffness. */
static void overshoot_of_a_weight(void) {
  struct nb_outcome outcome;
  carry_out(
      &outcome,
      "units none\nlet d = 1/pi\nmaterial m density $d kn 100\nwall w -9 0 to 9 0 m\ndisc 0 1 radius 1 m\nmonitor "
      "C disc 1 with wall w\ngravity 0 -1\nstep 0.001\nrecord C.normal\nstage fall\ncycles 630",
      "C.normal max expected 1 within 1 % [t]", NULL);
  CU_ASSERT_EQUAL_FATAL(outcome.check_count, 1);
  CU_ASSERT_PTR_NOT_NULL(strstr(outcome.checks[0].message, "computed 2"));
  CU_ASSERT_PTR_NULL(strstr(outcome.checks[0].message, "the ratio is"));
  nb_outcome_free(&outcome);
}

/* A disc of mass 1 hits a wall with the speed 1 and a stiffness of 1000, and leaves with the speed 1. The collision takes
 * pi/1000^(1/2) = 0.1 and lies between the rows at the times 0 and 1. The largest normal force of all cycles is 1000^(1/2)
 * = 31.6, the largest vy is 1. A check that passes or fails only because of the rows causes a warning. */
static void collisions_between_rows(void) {
  static const char passes[] = "so this check passes only because", fails[] = "so this check fails only because";
  static const struct {
    const char *every, *expectation, *wanted; /* NULL: no warning */
  } cases[] = {
      {"record every 1000 cycles", "C.normal max in one below 1", passes},
      {"record every 1000 cycles", "C.normal max in all below 31", passes},
      {"record every 1000 cycles", "C.normal max in two below 1", NULL},
      {"record every 1000 cycles", "C.normal max in one below 32", NULL},
      {"record every 1000 cycles", "C.normal max in one above 31", fails},
      {"record every 1000 cycles", "C.normal max in one above 32", NULL},
      {"record every 1000 cycles", "C.normal max in one below A.y max in one", passes},
      {"record every 1000 cycles", "C.normal max in one expected 31.62 within 1 % [t]", fails},
      {"record every 1000 cycles", "C.normal max in one expected 0 within 1 [t]", passes},
      {"record every 1000 cycles", "C.normal max in one expected 31 within 1.5 % [t]", NULL}, /* the error is 2 % */
      {"record every 1000 cycles", "C.normal max in one expected 31 within 50 % of A.y max in one [t]", fails},
      {"record every 1000 cycles", "A.vx max in one expected 1 within 1 [t]", NULL}, /* 0 is at the tolerance */
      {"record every 1000 cycles", "C.normal max in one expected 0 of A.y max in one within 1 [t]", passes},
      {"record every 1000 cycles", "C.normal max in one expected 21.07 of A.y max in one within 1 % [t]", fails},
      {"record every 1000 cycles", "C.normal max in one expected 31 within 1 of C.normal max in all [t]", NULL},
      {"record every 1000 cycles", "C.normal max in one expected 0 within 1 % of A.y max in one [t]", passes},
      {"record every 1000 cycles", "C.normal max in one expected 0 within 100 % of momentum.y max in one [t]", passes},
      /* a measure without a value, since there is no row then */
      {"record every 1000 cycles", "C.normal max in one below C.normal at 5000 cycles", NULL},
      {"record every 1000 cycles", "C.normal max in one expected 0 of C.normal at 5000 cycles within 1 [t]", NULL},
      {"record every 1000 cycles", "C.normal max in one expected 0 within 1 % of C.normal at 5000 cycles [t]", NULL},
      {"record none", "C.normal max in one below 1", NULL},
      {"record every 1000 cycles", "C.normal amplitude in one below 15", passes},
      {"record every 1000 cycles", "C.normal amplitude in one below 16", NULL},
      {"record every 1000 cycles", "A.y min in one above 1", passes},
      {"record every 1000 cycles", "A.y min in one above 0.9", NULL},
      {"record every 1000 cycles", "C.normal max below 1", NULL}, /* of the last stage */
      {"record every 1000 cycles", "C.normal mean in one below 1\nC.normal max in one below 32", NULL},
      {"record every 1000 cycles", "report C.normal max in one\nC.normal max in one below 32", NULL},
      {"record every 1000 cycles", "C.normal in one below 1", NULL},
      {"record every 1000 cycles", "C.normal mean in one below 1", NULL},
      {"record every 1000 cycles", "momentum.y max in one below 0", NULL},
      {"record every 1 cycle", "C.normal max in one below 1", NULL},
      {"# every cycle", "C.normal max in one below 1", NULL},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    struct nb_outcome outcome;
    char scene[512];
    snprintf(scene, sizeof scene,
             "units none\nlet pi1 = 1/pi\nmaterial m density $pi1 kn 1000\nwall w -9 0 to 9 0 m\ndisc 0 1.4 radius 1 m "
             "velocity 0 -1\nmonitor A disc 1\nmonitor C disc 1 with wall w\nstep 0.001\nrecord C.normal A.y A.vx "
             "momentum.y\nstage one\n%s\ncycles 1000\nstage two\n%s\ncycles 10",
             cases[k].every, cases[k].every);
    carry_out(&outcome, scene, cases[k].expectation, NULL);
    CU_ASSERT(outcome.status <= NB_FAILED);
    const char *const text = outcome.warnings.count ? outcome.warnings.list[0].text : "";
    const bool as_wanted = cases[k].wanted ? strstr(text, cases[k].wanted) != NULL : !outcome.warnings.count;
    if (!as_wanted)
      printf("# %s, %s: %s%s\n", cases[k].every, cases[k].expectation, text, outcome.error.text);
    CU_ASSERT(as_wanted);
    double largest = 0;
    if (k == 0) {
      CU_ASSERT_EQUAL(
          sscanf(text, "`C.normal max in one`: it is 0 in the recorded rows and %lf in all cycles", &largest), 1);
      CU_ASSERT_DOUBLE_EQUAL(largest, sqrt(1000), 0.01); /* (w dt)^2/8 of it is 0.004; four digits are printed */
    }
    if (cases[k].wanted && outcome.warnings.count)
      CU_ASSERT_EQUAL(outcome.warnings.list[0].line, 19);
    nb_outcome_free(&outcome);
  }
}

/* A stage with `record none` has no rows, so the checks of all stages do not concern it. The disc is below 1 in stage one
 * only. */
static void checks_without_the_stage_that_records_no_rows(void) {
  static const char *const rows[] = {"record none", "record every 1000 cycles"};
  for (size_t k = 0; k < 2; k++) {
    struct nb_outcome outcome;
    char scene[512];
    snprintf(scene, sizeof scene,
             "units none\nlet pi1 = 1/pi\nmaterial m density $pi1 kn 1000\nwall w -9 0 to 9 0 m\ndisc 0 1.4 radius 1 m "
             "velocity 0 -1\nmonitor A disc 1\nstep 0.001\nrecord A.y\nstage one\n%s\ncycles 1000\nstage two\nrecord "
             "every 5 cycles\ncycles 10",
             rows[k]);
    carry_out(&outcome, scene, "A.y min in all above 1", NULL);
    CU_ASSERT_EQUAL(outcome.status, NB_OK);
    CU_ASSERT_EQUAL(outcome.warnings.count, k);
    nb_outcome_free(&outcome);
  }
}

/* The disc of collisions_between_rows, with units. Its least height is 1 - 1000^(-1/2) = 0.96838, and both rows are above
 * 1.39. The values of the warning have the unit of the quantity, although the check is of a ratio. */
static void units_of_values_between_rows(void) {
  struct nb_outcome outcome;
  carry_out(&outcome,
            "let rho = (1/pi) kg/m3\nmaterial m density $rho kn 1000 N/m\nwall w -9 m 0 m to 9 m 0 m m\n"
            "disc 1 m 1.4 m radius 1 m m velocity 0 m/s -1 m/s\nmonitor A disc 1\nstep 1 ms\nrecord A.x A.y\n"
            "stage one\nrecord every 1000 cycles\ncycles 1000",
            "A.y min above 1.2 m\nA.y min expected 1.4 of A.x max within 0.1 [t]", NULL);
  CU_ASSERT_EQUAL(outcome.status, NB_OK);
  CU_ASSERT_EQUAL_FATAL(outcome.warnings.count, 2);
  for (size_t w = 0; w < 2; w++)
    CU_ASSERT_STRING_EQUAL(
        outcome.warnings.list[w].text,
        "`A.y min`: it is 1.4 m in the recorded rows and 0.9684 m in all cycles, so this check passes "
        "only because `record every N cycles` leaves cycles out");
  nb_outcome_free(&outcome);
}

/* A disc is thrown up at the speed v, under the gravity 1, and is highest at the time v. The rows are at multiples of 0.5.
 * With v = 0.51 the height of the row at 0.5 is 1000.13, and the largest height is 0.01^2/2 = 5e-5 more. The warning
 * shows the difference, and names the run. With v = 0.1 both heights are below 1000.13. */
static void close_values_between_rows(void) {
  struct nb_outcome outcome;
  double row = 0, all = 0;
  char end[64] = "";
  carry_out(&outcome,
            "units none\nsweep v 0.1 0.51\nmaterial m density 1 kn 1\ndisc 0 1000 radius 1 m velocity 0 $v\nmonitor A "
            "disc 1\ngravity 0 -1\nstep 0.001\nrecord A.y\nstage one\nrecord every 500 cycles\ncycles 1000",
            "A.y max below 1000.130025\nA.y max increases with v", NULL); /* a trend has no such warning */
  CU_ASSERT_EQUAL(outcome.status, NB_OK);
  CU_ASSERT_EQUAL_FATAL(outcome.warnings.count, 1);
  const char *const text = outcome.warnings.list[0].text;
  CU_ASSERT_EQUAL(sscanf(text,
                         "`A.y max`: it is %lf in the recorded rows and %lf in all cycles, so this check passes only "
                         "because `record every N cycles` leaves cycles out (run %60s",
                         &row, &all, end),
                  3);
  CU_ASSERT_DOUBLE_EQUAL(all - row, 5e-5, 1e-6);
  CU_ASSERT_STRING_EQUAL(end, "v=0.51)");
  if (strcmp(end, "v=0.51)") != 0)
    printf("# %s\n", text);
  nb_outcome_free(&outcome);
}

/* 102 runs of 10,000 discs that fall freely, each with another gravity. To save memory only the first 100 runs keep
 * their particles after the page is read. The others read them again when they begin, and their results are correct. */
static void many_particles(void) {
  enum { RUNS = 102, KEPT = 100 };
  char scene[2048] = "units none\nsweep g";
  struct nb_outcome outcome;
  for (int g = 1; g <= RUNS; g++)
    snprintf(scene + strlen(scene), sizeof scene - strlen(scene), " %d", g);
  strcat(scene, "\nmaterial m density 1 kn 1\nlattice discs 100 by 100 m radius 1 spacing 3 from 0 0\nmonitor D disc "
                "10000\nrecord D.vy\ngravity 0 -$g\nstep 0.0625\nskin 0.1\nstage fall\ncycles 2");
  carry_out(&outcome, scene, "D.vy min above -100", NULL);
  if (outcome.status)
    printf("# %s\n", outcome.error.text);
  CU_ASSERT_EQUAL(outcome.status, NB_OK);
  CU_ASSERT_EQUAL_FATAL(outcome.run_count, RUNS);
  for (int r = 0; r < RUNS; r++) {
    CU_ASSERT(outcome.runs[r].scene.columns[0].tracked); /* also after its page was read again */
    const struct nb_table *table = &outcome.runs[r].result.table;
    CU_ASSERT_EQUAL_FATAL(table->row_count, 3);
    NEAR(table->values[2], -0.125 * (r + 1), 1e-14); /* rounding of the weight over the mass */
    CU_ASSERT((outcome.runs[r].scene.particles == NULL) == (r >= KEPT));
  }
  nb_outcome_free(&outcome);
}

/* Results that were written to a temporary file and read again equal those in memory. This holds in any order of
 * reading, and whether all three runs or only the last two are in the file. A file that cannot be written causes one
 * note, and the results stay in memory. A file that can no longer be read is an error. Two outcomes cannot use one
 * folder at a time. */
static void results_in_a_file(void) {
  static const char scene[] = "units none\nsweep v 1 2 3\nmaterial m density 1 kn 1 ks 1 friction 0.5\ndisc 0 0 radius "
                              "1 m velocity $v 0\nwall w 0.9 -9 to "
                              "0.9 9 m\nmonitor A disc 1\nregion R all\nstep 1e-3\nrecord time A.x\nstage one\ncycles "
                              "7\nsnapshot\nstage two\ncycles 4\n"
                              "snapshot from one";
  static const char expectations[] =
      "time expected 0.011 within 1e-12 [t]\nA.x increases with v\nA.x constant with v within 9";
  char folder[] = "/tmp/nineball-outcome-XXXXXX", other[sizeof folder + 8];
  struct nb_options options = {.threads = 1, .jobs = 1, .results = {.bytes = 1 << 20, .folder = mkdtemp(folder)}};
  struct nb_outcome memory, outcome;
  struct reports reports = {0};
  const struct nb_progress progress = {NULL, note, &reports};
  CU_ASSERT_PTR_NOT_NULL_FATAL(options.results.folder);
  carry_out_with(&memory, scene, expectations, &options, NULL);
  CU_ASSERT_FATAL(memory.status == NB_OK && memory.run_count == 3 && memory.check_count == 5);
  CU_ASSERT(memory.runs[2].result.snapshot_count == 2 && memory.runs[2].result.snapshots[1].contacts.row_count == 1);
  const size_t kept[] = {0, memory.spool.kept / 3};
  carry_out_with(&outcome, scene, expectations, &options, NULL);
  CU_ASSERT(outcome.status == NB_BAD_USE && outcome.runs[0].result.cycles == 0);
  CU_ASSERT_PTR_NOT_NULL(
      strstr(outcome.error.text, "nineball.lock: wait for its end, or choose another folder with -o"));
  nb_outcome_free(&outcome);
  snprintf(other, sizeof other, "%s/other", folder);
  options.results.folder = other;
  for (int first = 0; first < 2; first++) {
    options.results.bytes = kept[first];
    carry_out_with(&outcome, scene, expectations, &options, NULL);
    CU_ASSERT_FATAL(outcome.status == NB_OK && outcome.run_count == 3 && outcome.check_count == 5);
    CU_ASSERT_EQUAL(outcome.runs[0].spool == NULL, first == 1);
    CU_ASSERT_PTR_NOT_NULL(outcome.runs[1].spool);
    CU_ASSERT_EQUAL(outcome.runs[2].result.snapshot_count, 0);
    for (int k = 0; k < 9; k++) {
      const struct nb_page_run *run = &outcome.runs[k * k % 3], *same = &memory.runs[k * k % 3];
      CU_ASSERT(written_same_table(nb_run_table(run), &same->result.table));
      CU_ASSERT(k % 2 || written_same_snapshots(nb_run_result(run), &same->result));
    }
    for (size_t k = 0; k < 5; k++)
      CU_ASSERT_STRING_EQUAL(memory.checks[k].message, outcome.checks[k].message);
    CU_ASSERT_EQUAL(ftruncate(fileno(outcome.spool.file), 0), 0);
    CU_ASSERT_EQUAL(nb_verdict(&outcome), NB_BAD_USE);
    CU_ASSERT_STRING_EQUAL(outcome.error.text,
                           "cannot read the temporary file with the results of the runs: Input/output error");
    nb_outcome_free(&outcome);
  }
  nb_outcome_free(&memory);
  CU_ASSERT(rmdir(other) == 0 && rmdir(folder) == 0);
  options.results = (struct nb_results_kept){0, folder, true};
  carry_out_with(&outcome, scene, expectations, &options, &progress);
  CU_ASSERT(outcome.status == NB_OK && outcome.check_count == 5 && outcome.runs[2].result.table.row_count > 0);
  CU_ASSERT(outcome.runs[2].result.snapshot_count == 0 && reports.notes == 1);
  CU_ASSERT_PTR_NOT_NULL(
      strstr(reports.note, "the results stay in memory: cannot write a temporary file in /tmp/nineball-outcome-"));
  nb_outcome_free(&outcome);
}

/* Removes the file that `data` names, at the first report of progress. */
static void remove_file(void *data, const char *stage, double fraction, double seconds) {
  (void)stage, (void)fraction, (void)seconds;
  unlink(data);
}

/* 101 runs of 10,000 discs. The particles of the last run are not kept in memory; when they are to be read again, the
 * file is gone. */
static void a_file_that_is_removed(void) {
  char path[] = "/tmp/nineball-outcome-XXXXXX", scene[2048];
  FILE *file = written_file(path);
  fputs("x/-\ty/-\tradius/-\n", file);
  for (int k = 0; k < 10000; k++)
    fprintf(file, "%d\t%d\t1\n", 3 * (k % 100), 3 * (k / 100));
  fclose(file);
  snprintf(scene, sizeof scene, "units none\nsweep g");
  for (int g = 1; g <= 101; g++)
    snprintf(scene + strlen(scene), sizeof scene - strlen(scene), " %d", g);
  snprintf(scene + strlen(scene), sizeof scene - strlen(scene),
           "\nmaterial m density 1 kn 1\npacking %s discs m\nmonitor D disc 1\nrecord D.vy\ngravity 0 -$g\n"
           "step 0.0625\nskin 0.1\nstage fall\ncycles 2",
           path);
  const struct nb_progress progress = {remove_file, NULL, path};
  struct nb_outcome outcome;
  carry_out_with(&outcome, scene, "report D.vy", &(struct nb_options){.threads = 1, .jobs = 1}, &progress);
  CU_ASSERT_EQUAL(outcome.status, NB_BAD_USE);
  CU_ASSERT_STRING_EQUAL(outcome.error.text, "a file that the page names has changed during its runs (run g=101)");
  CU_ASSERT(outcome.run_count == 101 && outcome.runs[99].result.table.row_count == 3);
  CU_ASSERT(outcome.check_count == 0);
  nb_outcome_free(&outcome);
}

/* A folder for results that cannot be made ends a page before its first run. */
static void folders_that_cannot_be_made(void) {
  static const char scene[] = "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nstep 0.1\nrecord cycle\n"
                              "stage s\ncycles 1";
  char file[] = "/tmp/nineball-outcome-XXXXXX", inside[sizeof file + 8];
  char name[NB_STATE_PATH - sizeof "/nineball" + 2]; /* the shortest name that is too long */
  struct nb_outcome outcome;
  struct nb_options options = {.threads = 1, .jobs = 1};
  close(mkstemp(file));
  snprintf(inside, sizeof inside, "%s/folder", file);
  memset(name, 'n', sizeof name), name[sizeof name - 1] = 0;
  const struct {
    const char *folder, *words;
  } rows[] = {{name, "the name of the folder is too long: nnn"}, {inside, "Not a directory"}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    options.results.folder = rows[k].folder;
    carry_out_with(&outcome, scene, "cycle expected 1 within 0 [t]", &options, NULL);
    CU_ASSERT(outcome.status == NB_BAD_USE && outcome.check_count == 0 && outcome.runs[0].result.table.row_count == 0);
    CU_ASSERT_PTR_NOT_NULL(strstr(outcome.error.text, rows[k].words));
    nb_outcome_free(&outcome);
  }
  options.results.verdict_only = true; /* no results are kept, so the folder is not made */
  carry_out_with(&outcome, scene, "cycle expected 1 within 0 [t]", &options, NULL);
  CU_ASSERT(outcome.status == NB_OK && outcome.check_count == 1);
  nb_outcome_free(&outcome);
  unlink(file);
}

/* The data of `interrupt`, which ends the runs as a signal does when the second of two runs has begun. */
struct interruption {
  volatile sig_atomic_t stop;
};

static void interrupt(void *data, const char *stage, double fraction, double seconds) {
  struct interruption *this = data;
  (void)stage, (void)seconds;
  this->stop = fraction > 0.5;
}

/* A page with checkpoints and the settings `own` is interrupted in its second run. Until its outcome is freed, no other
 * outcome can run the page with these settings. After that, the page with these settings is refused unless it resumes,
 * because the checkpoint of the second run exists. With the settings `other` the page can be run at any time. */
static void interrupted_with(nb_settings own, nb_settings other) {
  static const char scene[] = "let w = 1 m\nlet x = 1\nlet mx = 1\nsweep v 1 m/s 2 m/s\n"
                              "material m density 1 kg/m3 kn 1 N/m\ndisc 0 m 0 m radius 1 m m velocity $v 0 m/s\n"
                              "monitor A disc 1\nstep 1 ms\nrecord A.x\nstage s\ncycles 40000";
  char path[] = "/tmp/nineball-outcome-XXXXXX", states[] = "/tmp/nineball-outcome-XXXXXX";
  struct nb_outcome first, second;
  struct interruption interruption = {0};
  const struct nb_progress progress = {interrupt, NULL, &interruption};
  write_page(path, scene, "A.x expected 80 m within 50 m [t]");
  struct nb_options options = {.threads = 1, .jobs = 1, .states = mkdtemp(states)};
  options.checkpoint.seconds = 1e9, options.checkpoint.stop = &interruption.stop;
  CU_ASSERT_EQUAL(nb_outcome_make(&first, path, own, &options, &progress), NB_BROKEN);
  CU_ASSERT_PTR_NOT_NULL(strstr(first.error.text, "stopped by a signal"));
  CU_ASSERT(first.runs[0].result.cycles == 40000 && first.runs[1].result.cycles < 40000 && first.check_count == 0);
  interruption.stop = 0;
  options.checkpoint.resume = true;
  CU_ASSERT_EQUAL(nb_outcome_make(&second, path, own, &options, NULL), NB_BAD_USE); /* the first one has not ended */
  CU_ASSERT_PTR_NOT_NULL(strstr(second.error.text, "runs this page with these settings and saves checkpoints"));
  nb_outcome_free(&second);
  CU_ASSERT_EQUAL(nb_outcome_make(&second, path, other, &options, NULL), NB_OK);
  nb_outcome_remove_checkpoints(&second, &options);
  const int later = open(path, O_RDONLY); /* has the descriptor that the lock had */
  nb_outcome_free(&second);
  CU_ASSERT_EQUAL(close(later), 0); /* the lock is released once: the end of the outcome closes no other file */
  nb_outcome_free(&first);
  options.checkpoint.resume = false;
  CU_ASSERT_EQUAL(nb_outcome_make(&second, path, own, &options, NULL), NB_BAD_USE);
  CU_ASSERT_PTR_NOT_NULL(strstr(second.error.text, "the run of this page was interrupted"));
  CU_ASSERT_EQUAL(second.runs[0].result.cycles, 0); /* the page is refused before the first run */
  nb_outcome_free(&second);
  options.checkpoint.resume = true;
  CU_ASSERT_EQUAL(nb_outcome_make(&second, path, own, &options, NULL), NB_OK);
  CU_ASSERT(second.check_count == 2 && second.mark_count[NB_PASS] == 2);
  nb_outcome_remove_checkpoints(&second, &options);
  nb_outcome_free(&second);
  options.checkpoint.resume = false; /* nothing is left to resume */
  CU_ASSERT_EQUAL(nb_outcome_make(&second, path, own, &options, NULL), NB_OK);
  nb_outcome_remove_checkpoints(&second, &options);
  nb_outcome_free(&second);
  CU_ASSERT_EQUAL(rmdir(states), 0);
  unlink(path);
}

/* A page with one run has a lock, too. */
static void lock_of_one_run(void) {
  char path[] = "/tmp/nineball-outcome-XXXXXX", states[] = "/tmp/nineball-outcome-XXXXXX";
  struct nb_outcome first, second;
  write_page(path,
             "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nmonitor A disc 1\nstep 1\nrecord A.x\n"
             "stage s\ncycles 1",
             "A.x expected 0 within 1 [t]");
  struct nb_options options = {.threads = 1, .jobs = 1, .states = mkdtemp(states)};
  options.checkpoint.seconds = 1e9;
  CU_ASSERT_EQUAL(nb_outcome_make(&first, path, NULL, &options, NULL), NB_OK);
  CU_ASSERT_EQUAL(nb_outcome_make(&second, path, NULL, &options, NULL), NB_BAD_USE);
  CU_ASSERT_PTR_NOT_NULL(strstr(second.error.text, "runs this page with these settings"));
  nb_outcome_free(&second);
  nb_outcome_remove_checkpoints(&first, &options);
  nb_outcome_free(&first);
  CU_ASSERT_EQUAL(rmdir(states), 0);
  unlink(path);
}

/* Locks and checkpoints depend on every setting, not only on the last one, and on where one ends and the next begins. */
static void locks_and_checkpoints(void) {
  interrupted_with(NULL, (const char *const[]){"w=2 m", NULL});
  interrupted_with((const char *const[]){"w=3 m", "refine=1", NULL}, (const char *const[]){"w=2 m", "refine=1", NULL});
  interrupted_with((const char *const[]){"w=1 m", "mx=2", NULL}, (const char *const[]){"w=1 mm", "x=2", NULL});
}

/* Without --jobs the number of runs at once is the number of processors divided by the threads of each run; it is at
 * least 1, and at most the number of runs. */
static void runs_at_once(void) {
  const int processors = nb_job_count(&(struct nb_options){.threads = 1}, 1000000);
  CU_ASSERT(processors >= 1);
  for (int threads = 0; threads < 9; threads++) {
    const int room = processors / (threads ? threads : 1);
    CU_ASSERT_EQUAL(nb_job_count(&(struct nb_options){.threads = threads}, 1000000), room > 1 ? room : 1);
  }
  CU_ASSERT_EQUAL(nb_job_count(&(struct nb_options){.threads = 3, .jobs = 5}, 7), 5);
  CU_ASSERT_EQUAL(nb_job_count(&(struct nb_options){.threads = 1, .jobs = 8}, 7), 7);
  CU_ASSERT_EQUAL(nb_job_count(&(struct nb_options){.threads = 1}, 1), 1);
  CU_ASSERT_EQUAL(nb_job_count(NULL, 7), 1);
}

void suite_outcome(void) {
  CU_pSuite suite = CU_add_suite("outcome", NULL, NULL);
  CU_add_test(suite, "progress and notes of several runs", progress);
  CU_add_test(suite, "a note of the memory size that changes", note_of_memory_size);
  CU_ADD_TEST(suite, notes_of_other_laws);
  CU_add_test(suite, "warnings of stages that end too early", warnings_of_ends);
  CU_add_test(suite, "ends of two stages", warnings_of_ends_of_two_stages);
  CU_add_test(suite, "warnings of stages that end too early propose a condition", warnings_of_ends_propose);
  CU_add_test(suite, "warnings of regions without particles or contacts, and of a negative porosity",
              warnings_of_regions);
  CU_add_test(suite, "warnings of stages that end far from the target of a servo", warnings_of_servos);
  CU_add_test(suite, "servos that go on in the next stage", servos_that_go_on);
  CU_add_test(suite, "warnings of expectations of another stress than the servo controls",
              expectations_of_another_stress);
  CU_add_test(suite, "messages about servos at their largest rate", servos_at_the_largest_rate);
  CU_add_test(suite, "units of reported values", units);
  CU_ADD_TEST(suite, moments_without_rows);
  CU_ADD_TEST(suite, a_stage_named_all);
  CU_add_test(suite, "stages without rows", stages_without_rows);
  CU_add_test(suite, "error of a run", error_of_a_run);
  CU_add_test(suite, "mistakes in all runs, and the error of a reference", mistakes_of_all_runs);
  CU_add_test(suite, "warnings of all runs", warnings_of_all_runs);
  CU_add_test(suite, "warnings of removed particles", warnings_of_removed_particles);
  CU_ADD_TEST(suite, stages_of_removed_particles);
  CU_ADD_TEST(suite, a_box_without_one_of_its_walls);
  CU_ADD_TEST(suite, tracked_columns);
  CU_ADD_TEST(suite, warnings_of_tension);
  CU_add_test(suite, "warnings of an imposed work that is 0", warnings_of_the_imposed_work);
  CU_add_test(suite, "names that no line uses", names_that_no_line_uses);
  CU_add_test(suite, "a check that expects springs in series", stiffness_of_springs_in_series);
  CU_ADD_TEST(suite, overshoot_of_a_weight);
  CU_add_test(suite, "collisions between two rows", collisions_between_rows);
  CU_ADD_TEST(suite, checks_without_the_stage_that_records_no_rows);
  CU_ADD_TEST(suite, units_of_values_between_rows);
  CU_ADD_TEST(suite, close_values_between_rows);
  CU_add_test(suite, "many particles in many runs", many_particles);
  CU_add_test(suite, "a file that is removed during the runs", a_file_that_is_removed);
  CU_add_test(suite, "folders that cannot be made", folders_that_cannot_be_made);
  CU_add_test(suite, "locks and checkpoints of all runs", locks_and_checkpoints);
  CU_add_test(suite, "the lock of a page with one run", lock_of_one_run);
  CU_add_test(suite, "number of runs at once", runs_at_once);
  CU_add_test(suite, "results of runs in a temporary file", results_in_a_file);
  CU_add_test(suite, "deep contacts of all runs together", deep_overlaps_of_all_runs);
}
