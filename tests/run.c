/* Runs of scenes from the first stage to the last: the times at which rows are recorded, the values that stages keep,
 * aborted runs, repeated stages, the hash of a page, threads.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#ifdef _OPENMP
#include <omp.h>
#endif
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "core/model.h"
#include "core/team.h"
#include "input/scene.h"
#include "report/outcome.h"
#include "run/restart.h"
#include "run/state.h"
#include "suites.h"
#include "written.h"

#define SCENE                                                                                                          \
  "units none\nmaterial m density 1 kn 100\nstep 0.25\nbox 0 0 to 8 8 m\ndisc 4 4 radius 1 m\nmonitor W wall west\n"   \
  "monitor D disc 1\nmonitor C disc 1 with wall west\nrecord cycle time W.x W.y\n"

static void rows_are_recorded_as_requested(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, SCENE "stage a\nrecord every 4 cycles\ncycles 10\nstage b\nrecord none\ncycles 3\nstage c\n"
                         "step 0.5\nallow unstable\ncycles 2\nstage d\nstep 0.25\nrecord every 4 cycles\ncycles 7\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  /* Stage a: the start, every fourth cycle and the last one; b: none; c: both cycles; d: every fourth cycle, counted
   * from the beginning of the stage, and the last one. */
  static const double cycle[] = {0, 4, 8, 10, 14, 15, 19, 22};
  static const double time[] = {0, 1, 2, 2.5, 3.75, 4.25, 5.25, 6};
  static const int stage[] = {0, 0, 0, 0, 2, 2, 3, 3};
  CU_ASSERT_EQUAL_FATAL(result.table.row_count, 8);
  for (size_t r = 0; r < 8; r++) {
    CU_ASSERT(result.table.values[4 * r] == cycle[r] && result.table.values[4 * r + 1] == time[r]);
    CU_ASSERT(result.table.cycle[r] == cycle[r] && result.table.time[r] == time[r] &&
              result.table.stage[r] == stage[r]);
  }
  CU_ASSERT(result.cycles == 22 && result.stages[0].cycles == 10 && result.stages[1].cycles == 3 &&
            result.stages[2].cycles == 2 && result.stages[3].cycles == 7);
  nb_result_free(&result);
  written_free(&it);
}

/* Two discs touch and rest: one contact update in each cycle. */
static void contact_updates_of_a_stage(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page,
            "units none\nmaterial m density 1 kn 100\nstep 0.001\ndisc 0 0 radius 1 m fixed\ndisc 2 0 radius 1 m\n"
            "record time\nstage a\ncycles 10\nstage b\ncycles 3\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT(result.stages[0].updates == 10 && result.stages[1].updates == 3);
  CU_ASSERT_EQUAL(result.updates, 14);                                           /* also at time 0 */
  const double seconds[] = {result.stages[0].seconds, result.stages[1].seconds}; /* of the processor */
  CU_ASSERT(seconds[0] >= 0 && seconds[1] >= 0 && seconds[0] + seconds[1] <= result.seconds + 1e-3);
  nb_result_free(&result);
  written_free(&it);
}

/* A trial ends each stage when its time is over, here after the first cycle. It shortens a stage of two cycles, but not
 * one of a single cycle, and adds no warning about the end of a stage. The stage has its snapshot. */
static void a_trial_shortens_stages(void) {
  static const struct nb_progress progress = {.stage_seconds = 1e-9};
  for (int cycles = 1; cycles < 3; cycles++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    struct nb_error error = {0};
    words_add(&page,
              SCENE "stage a\ncycles 1\nstage b\nuntil time above 0.1 at most 9 cycles\nsnapshot\nstage c\ncycles %d\n"
                    "stage d\ncycles 1\n",
              cycles);
    written_scene(&it, &page);
    CU_ASSERT_EQUAL(nb_run(&result, &it.scene, NULL, &progress, &error), NB_OK);
    CU_ASSERT_EQUAL(result.cycles, 4);
    for (int s = 0; s < 4; s++)
      CU_ASSERT_EQUAL(result.stages[s].cycles, 1);
    CU_ASSERT_EQUAL(result.shortened, cycles > 1);
    CU_ASSERT(result.warnings.count == 0 && result.snapshot_count == 1);
    nb_result_free(&result);
    written_free(&it);
  }
}

static void walls_keep_their_velocity(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page,
            SCENE "stage a\nwalls inward 0.5\ncycles 2\nstage b\ncycles 2\nstage c\nwalls stop\ncycles 2\nstage d\n"
                  "wall west velocity -1 3\ncycles 2\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  static const double x[] = {0, 0.125, 0.25, 0.375, 0.5, 0.5, 0.5, 0.25, 0}, y[] = {4, 4, 4, 4, 4, 4, 4, 4.75, 5.5};
  CU_ASSERT_EQUAL_FATAL(result.table.row_count, 9);
  for (size_t r = 0; r < 9; r++)
    CU_ASSERT(result.table.values[4 * r + 2] == x[r] && result.table.values[4 * r + 3] == y[r]);
  nb_result_free(&result);
  written_free(&it);
}

/* Each row has the time since the start and the time since the beginning of the stage. The latter can end a stage. In
 * stage a it exceeds 1 after the fifth step of 0.25, and in stage b it exceeds 0.75 after the second step of 0.5. */
static void time_of_a_stage(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  static const double time[] = {0, 0.25, 0.5, 0.75, 1, 1.25, 1.75, 2.25},
                      stage_time[] = {0, 0.25, 0.5, 0.75, 1, 1.25, 0.5, 1};
  words_add(&page, "units none\nmaterial m density 1\ndisc 0 0 radius 1 m\nstep 0.25\nrecord time stage.time\n"
                   "stage a\nuntil stage.time above 1 at most 50 cycles\n"
                   "stage b\nstep 0.5\nuntil stage.time above 0.75 at most 50 cycles\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_EQUAL_FATAL(result.table.row_count, 8);
  for (size_t r = 0; r < 8; r++)
    CU_ASSERT(result.table.values[2 * r] == time[r] && result.table.values[2 * r + 1] == stage_time[r]);
  nb_result_free(&result);
  written_free(&it);
}

static void a_stage_ends_when_all_conditions_hold(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, SCENE "stage a\nrecord every 100 cycles\nuntil time above 1 and cycle above 2 at most 50 cycles\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_EQUAL(result.cycles, 5); /* time is 1 at cycle 4, and above it at 5 */
  CU_ASSERT_EQUAL_FATAL(result.table.row_count, 2);
  CU_ASSERT_EQUAL(result.table.cycle[1], 5); /* the last cycle has a row, although it is not the hundredth */
  nb_result_free(&result);
  written_free(&it);
}

/* Runs the scene of these statements, which must be aborted, and returns the error. *rows becomes the number of
 * recorded rows. */
static struct nb_error broken(const char *statements, size_t *rows) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  struct nb_error error = {0};
  words_add(&page, "%s", statements);
  written_scene(&it, &page);
  CU_ASSERT_EQUAL(nb_run(&result, &it.scene, NULL, NULL, &error), NB_BROKEN);
  CU_ASSERT_EQUAL(error.status, NB_BROKEN);
  *rows = result.table.row_count;
  nb_result_free(&result);
  written_free(&it);
  return error;
}

static void says(const struct nb_error *error, const char *words) {
  if (!strstr(error->text, words))
    printf("# `%s` is not in: %s\n", words, error->text);
  CU_ASSERT_PTR_NOT_NULL(strstr(error->text, words));
}

static void a_stage_that_never_ends(void) {
  size_t rows;
  const struct nb_error error =
      broken(SCENE "stage a\ncycles 1\nstage slow\nuntil time above 100 and cycle above 2 at most 7 cycles\n", &rows);
  says(&error, "stage `slow`");
  says(&error, "7 cycles");
  says(&error, "time is 2 and should be above 100");
  CU_ASSERT_EQUAL(rows, 9); /* rows recorded until then are kept */
}

/* Values have the unit of their quantity, except numbers without a unit. */
static void units_of_conditions(void) {
  size_t rows;
  const struct nb_error error =
      broken("material m density 1 kg/m3 kn 1 N/m\ndisc 0 m 0 m radius 1 m m velocity 3 m/s 0 m/s\nstep 0.5 s\n"
             "monitor D disc 1\nrecord time\nstage a\nuntil D.vx below -250 mm/s and time above 9 s and contacts "
             "above 2 at most 2 cycles\n",
             &rows);
  CU_ASSERT_STRING_EQUAL(error.text,
                         "stage `a` (line 7) did not end within 2 cycles: D.vx is 3 m/s and should be below -0.25 m/s, "
                         "time is 1 s and should be above 9 s, contacts is 0 and should be above 2; no contact has a "
                         "force now: do gravity, walls and velocities bring the particles together, or apart?");
}

/* One scene has an infinite acceleration, the other one a very large velocity. */
static void a_position_that_is_nan_or_infinite(void) {
  size_t rows;
  struct nb_error error =
      broken("units none\nmaterial m density 0.05 kn 1e308\ndisc 9 9 radius 1 m\ndisc 1 1 radius 1 m\n"
             "disc 1 2.1 radius 1 m\nstep 1\nallow unstable\nmonitor D disc 1\nrecord D.x\nstage a\ncycles 9\n",
             &rows);
  says(&error, "particle 2 (line 5): its position is NaN or infinite");
  says(&error, "after cycle 1");
  says(&error, "7.92665e-155"); /* 2 sqrt(m/k) */
  CU_ASSERT_EQUAL(rows, 1);     /* the start */
  error = broken("units none\nmaterial m density 1 kn 100\ndisc 9 9 radius 1 m\ndisc 0 0 radius 1 m velocity 5e99 "
                 "0\nstep 1\nallow unstable\n"
                 "monitor D disc 1\nrecord D.x\nstage a\ncycles 9\n",
                 &rows);
  says(&error, "particle 2 (line 5): in cycle 1, at time 1, it moved by 5e+99 in one step of 1.");
  CU_ASSERT_EQUAL(rows, 1);
}

static void a_snapshot_has_the_touching_contacts(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page,
            "units none\nmaterial m density 1 kn 100\nstep 1e-6\nwall floor -9 0 to 9 0 m\ndisc 0 0.9 radius 1 m\n"
            "disc 0 2.9 radius 1.2 m\ndisc 8 5 radius 1 m\nstage a\nsnapshot\ncycles 1\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_EQUAL_FATAL(result.snapshot_count, 1);
  const struct nb_table *contacts = &result.snapshots[0].contacts;
  CU_ASSERT(result.snapshots[0].particles.row_count == 3 && result.snapshots[0].walls.row_count == 1);
  CU_ASSERT_EQUAL_FATAL(contacts->row_count, 2);
  for (size_t r = 0; r < 2; r++) {
    const double *values = contacts->values + r * contacts->column_count;
    const bool floor = values[2] == 1;
    CU_ASSERT(values[0] == 1 && values[1] == (floor ? 0 : 2));
    /* The contact is half-way between the two surfaces. These are at y = -0.1 and 0 for disc 1 and the floor, and at
     * 1.9 and 1.7 for the two discs. */
    CU_ASSERT_DOUBLE_EQUAL(values[3], 0, 1e-6);
    CU_ASSERT_DOUBLE_EQUAL(values[4], floor ? -0.05 : 1.8, 1e-6);
    CU_ASSERT_DOUBLE_EQUAL(values[10], floor ? 10 : 20, 1e-6);  /* normal */
    CU_ASSERT_DOUBLE_EQUAL(values[14], floor ? 10 : -20, 1e-6); /* fy on the first */
  }
  nb_result_free(&result);
  written_free(&it);
}

/* A stage that reaches its largest number of cycles before its conditions hold has a snapshot of its last cycle. A
 * stage in which a particle moves too far has none, even if this happens in the last cycle. */
static void an_aborted_cycle_has_no_snapshot(void) {
  for (int broken = 0; broken < 2; broken++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    struct nb_error error = {0};
    words_add(
        &page,
        "units none\nmaterial m density 1 kn 100\ndisc 0 0 radius 1 m\ndisc 9 0 radius 1 m velocity 0 %d\nstep 1\n"
        "allow unstable\nmonitor D disc 2\nrecord D.y\nstage a\nsnapshot\nuntil D.y below -1 at most 1 cycles\n",
        broken ? 3 : 0);
    written_scene(&it, &page);
    CU_ASSERT_EQUAL(nb_run(&result, &it.scene, NULL, NULL, &error), NB_BROKEN);
    CU_ASSERT_PTR_NOT_NULL(strstr(error.text, broken ? "it moved by" : "did not end within 1 cycles"));
    CU_ASSERT_EQUAL(result.snapshot_count, broken ? 0 : 1);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* A stage that waits in vain asks whether the particles move apart, if no contact has a force and a condition that is
 * not met has the value 0. */
static void waits_for_contacts_in_vain(void) {
  static const struct {
    const char *disc;      /* its position; it touches wall w if x is below 1, and wall v if y is below -8 */
    const char *condition; /* never met */
    bool asked;
  } rows[] = {
      {"3 0", "contacts above 0", true},
      {"3 0", "C.normal above 1", true},
      {"3 0", "M.stress.xx below -1", true},
      {"3 0", "time above 0 and M.stress.xx above 5", true},
      {"3 0", "M.stress.xx above 5 and D.x above 10", true},
      {"3 0", "D.x above 10", false},
      {"3 0", "time above 100 and contacts below 1", false},
      {"1.05 0", "C.normal above 1", true}, /* the contact is listed without a force */
      {"0.9 0", "M.stress.xy above 1", false},
      {"0.9 0", "D.x above 10", false},
      {"1.05 -8.1", "C.normal above 1", false}, /* the contact with w is listed without a force; v exerts one in y */
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    struct nb_error error = {0};
    words_add(&page,
              "units none\nmaterial m density 1 kn 1\nwall w 0 -9 to 0 9 m\nwall v -9 -9 to 9 -9 m\n"
              "disc %s radius 1 m\nmonitor D disc 1\nmonitor C disc 1 with wall w\nregion M all\nstep 1e-3\nrecord "
              "time\nstage s\n"
              "until %s at most 2 cycles\n",
              rows[k].disc, rows[k].condition);
    written_scene(&it, &page);
    CU_ASSERT_EQUAL(nb_run(&result, &it.scene, NULL, NULL, &error), NB_BROKEN);
    CU_ASSERT_PTR_NOT_NULL(strstr(error.text, "did not end within 2 cycles"));
    CU_ASSERT_EQUAL(strstr(error.text, "no contact has a force now") != NULL, rows[k].asked);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* The condition holds from cycle 10 on. It is checked every N cycles, and in the last allowed cycle. */
static void conditions_checked_every_n_cycles(void) {
  static const struct {
    const char *every;
    unsigned long most, wanted;
  } rows[] = {{"", 100, 10}, {"every 1 cycle", 100, 10}, {"every 7 cycles", 100, 14}, {"every 50 cycles", 12, 12}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1\ndisc 0 0 radius 1 m\nstep 1\nrecord time\nstage s\n"
              "until time above 9.5 %s at most %lu cycles\n",
              rows[k].every, rows[k].most);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    CU_ASSERT_EQUAL(result.cycles, rows[k].wanted);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* The hash of a page covers the particles of its packing: their positions, radii, shapes and materials, and which of
 * them are fixed. */
static void packings_change_the_hash(void) {
  static const char *const discs[] = {"disc 1 2 radius 3 m",   "disc 1 2 radius 3 m fixed", "sphere 1 2 radius 3 m",
                                      "disc 1.5 2 radius 3 m", "disc 1 2.5 radius 3 m",     "disc 1 2 radius 3.5 m",
                                      "disc 1 2 radius 3 o"};
  enum { COUNT = sizeof discs / sizeof *discs };
  unsigned long long hash[COUNT];
  char path[] = "/tmp/nineball-run-XXXXXX";
  const int file = mkstemp(path);
  CU_ASSERT_FATAL(file >= 0);
  close(file);
  for (size_t k = 0; k < COUNT; k++) {
    static const char materials[] = "units none\nmaterial m density 1 kn 1\nmaterial o density 1 kn 1\nstep 0.1\n";
    struct words first = {0}, second = {0};
    struct written it;
    struct nb_saved saved;
    struct nb_error error;
    words_add(&first, "%s%s\nstage s\ncycles 1\n", materials, discs[k]);
    written_scene(&it, &first);
    CU_ASSERT_EQUAL_FATAL(nb_run_to(&saved, &it.scene, NULL, NULL, &error), NB_OK);
    CU_ASSERT_EQUAL(nb_saved_write(&saved, path, &error), NB_OK);
    nb_saved_free(&saved), written_free(&it);
    words_add(&second, "%spacking %s\nstage s\ncycles 1\n", materials, path);
    written_scene(&it, &second);
    CU_ASSERT_EQUAL(it.scene.particle_count, 1);
    hash[k] = it.scene.stages[0].hash;
    for (size_t other = 0; other < k; other++)
      CU_ASSERT(hash[k] != hash[other]);
    written_free(&it);
  }
  unlink(path);
}

/* Stages that `repeat` makes are the same as stages that are written in full: laws, steps and damping continue from one
 * to the next. Successive stages have different hashes. */
static void repeated_stages(void) {
  static const char *const head =
      "units none\nmaterial m density 1 kn 1e3 ks 1e3 friction 0.3\nnormal linear\nshear linear\n"
      "disc 0 0 radius 1 m\ndisc 1.9 0.3 radius 1 m velocity -1 0.2\nbox -1.1 -1.1 to 3.2 1.5 m\n"
      "step 1e-3\nmonitor D disc 2\nrecord D.x D.y D.angle D.vx\n";
  static const char *const in = "walls inward 0.1\nmaterial m friction 0.2\ncycles 20\n";
  static const char *const out = "damping mass 3\nstep 2e-3\nwalls inward -0.1\ncycles 10\n";
  struct words shorter = {0}, longer = {0};
  struct written it, full;
  struct nb_result result, whole;
  words_add(&shorter, "%sstage a\ncycles 5\nstage in\n%sstage out\n%srepeat from in 2 more times\nstage z\ncycles 7\n",
            head, in, out);
  words_add(&longer, "%sstage a\ncycles 5\n", head);
  static const char *const names[] = {"a", "in", "out", "in-2", "out-2", "in-3", "out-3", "z"};
  for (int k = 0; k < 3; k++)
    words_add(&longer, "stage %s\n%sstage %s\n%s", names[1 + 2 * k], in, names[2 + 2 * k], out);
  words_add(&longer, "stage z\ncycles 7\n");
  written_scene(&it, &shorter);
  written_scene(&full, &longer);
  CU_ASSERT_EQUAL_FATAL(it.scene.stage_count, 8);
  for (size_t s = 0; s < 8; s++) {
    CU_ASSERT_STRING_EQUAL(it.scene.stages[s].name, names[s]);
    CU_ASSERT(s == 0 || it.scene.stages[s].hash != it.scene.stages[s - 1].hash);
  }
  written_run(&result, &it, NULL);
  written_run(&whole, &full, NULL);
  CU_ASSERT_EQUAL_FATAL(result.table.row_count, whole.table.row_count);
  const size_t count = result.table.row_count * result.table.column_count;
  CU_ASSERT(memcmp(result.table.values, whole.table.values, count * sizeof(double)) == 0);
  nb_result_free(&result), nb_result_free(&whole);
  written_free(&it), written_free(&full);
}

/* The number of a repeated stage replaces the end of a long name. */
static void repeated_stages_with_long_names(void) {
  char name[NB_NAME_SIZE] = "", second[NB_NAME_SIZE];
  struct words page = {0};
  struct written it;
  memset(name, 'x', sizeof name - 1);
  words_add(&page,
            "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nstep 1\nrecord time\nstage %s\ncycles 1\n"
            "repeat from %s 1 more times\n",
            name, name);
  written_scene(&it, &page);
  CU_ASSERT_EQUAL_FATAL(it.scene.stage_count, 2);
  snprintf(second, sizeof second, "%.*s-2", (int)sizeof name - 3, name);
  CU_ASSERT_STRING_EQUAL(it.scene.stages[0].name, name);
  CU_ASSERT_STRING_EQUAL(it.scene.stages[1].name, second);
  written_free(&it);
}

/* A saved state is valid for certain statements, and for the settings that replace statements. So each of these
 * settings has a hash of its own, which is also different from the hash without settings. */
static void settings_change_the_hash(void) {
  static const char *const settings[] = {"",           "normal=hertz", "shear=none", "step=2e-3", "damping=centred",
                                         "refine=0.5", "refine=2",     "refine=3",   "soften=10", "soften=100"};
  enum { SETTINGS = sizeof settings / sizeof *settings };
  unsigned long long hash[SETTINGS];
  for (int k = 0; k < SETTINGS; k++) {
    const char *const one[] = {settings[k], NULL};
    hash[k] = nb_hash_settings(k ? one : NULL);
    for (int other = 0; other < k; other++)
      CU_ASSERT(hash[k] != hash[other]);
  }
  /* A value for a `let` does not change this hash, because it changes the statements that use the `let`. */
  static const char *const value[] = {"speed=2", NULL};
  CU_ASSERT(nb_hash_settings(value) == hash[0]);
}

struct counted {
  int calls[5]; /* of each part */
};

static void count_call(void *data, int part) {
  struct counted *counted = data;
  counted->calls[part]++;
}

/* A call of nb_team_run (a round) does each part once, with more, fewer or as many parts as the team has threads, and
 * without a team. The pauses let the threads fall asleep between two rounds. nb_team_sized keeps a team that has the
 * right size. */
static void parts_of_a_team(void) {
  struct nb_team *team = NULL;
  for (int threads = 2; threads <= 4; threads++) {
    team = nb_team_sized(team, threads);
    CU_ASSERT_PTR_NOT_NULL_FATAL(team);
    CU_ASSERT_PTR_EQUAL(nb_team_sized(team, threads), team);
    for (int parts = 1; parts <= 5; parts++) {
      struct counted counted = {{0}};
      for (int round = 0; round < 500; round++) {
        if (round % 100 == 99)
          nanosleep(&(struct timespec){.tv_nsec = 1000000}, NULL);
        nb_team_run(round % 2 ? team : NULL, parts, count_call, &counted);
      }
      for (int part = 0; part < 5; part++)
        CU_ASSERT_EQUAL(counted.calls[part], part < parts ? 500 : 0);
    }
  }
  nb_team_free(team);
  nb_team_free(NULL);
}

/* A row of discs, each of which touches the next one. Each thread has at least 128 contacts, and each block at most
 * 128. */
static void threads_of_a_model(void) {
  static const struct {
    int contacts, given, used;
  } rows[] = {{0, 4, 1},   {127, 4, 1}, {128, 4, 1}, {255, 4, 1}, {256, 4, 2}, {256, 1, 1},
              {383, 4, 2}, {384, 4, 3}, {384, 2, 2}, {511, 4, 3}, {512, 4, 4}, {900, 4, 4}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1 kn 1\nlattice discs %d by 1 m radius 1 spacing 1.99 from 0 0\nstep "
              "1e-3\nrecord time\nstage a\ncycles 1\n",
              rows[k].contacts + 1);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, &(struct nb_options){.threads = rows[k].given});
    const int blocks = (rows[k].contacts + 127) / 128;
    CU_ASSERT_EQUAL(model->contacts.count, (size_t)rows[k].contacts);
    CU_ASSERT_EQUAL(model->machine.threads_used, rows[k].used);
    CU_ASSERT_EQUAL_FATAL(model->blocks.count, (size_t)blocks);
    for (int b = 0; b < blocks; b++) {
      CU_ASSERT_EQUAL(model->blocks.list[b].n, b + 1 < blocks ? 128 : (size_t)(rows[k].contacts - 128 * b));
      CU_ASSERT(model->blocks.list[b].a == model->contacts.a + 128 * b);
    }
    nb_model_free(model);
    written_free(&it);
  }
}

/* The number of threads is that of the options, but at most NB_THREADS. 0 stands for OpenMP's default. Without options
 * there is one thread. The options can name an instruction set that this machine has. If they name none, it is the
 * widest one of the machine. */
static void threads_and_instruction_set(void) {
  static const struct {
    int given, chosen;
  } rows[] = {{1, 1}, {3, 3}, {NB_THREADS, NB_THREADS}, {NB_THREADS + 1, NB_THREADS}};
  static const char *const names[] = {"plain", "avx2", "avx512", "mmx"};
  struct nb_model model;
  struct nb_error error;
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    CU_ASSERT_EQUAL(nb_machine_choose(&model, &(struct nb_options){.threads = rows[k].given}, &error), NB_OK);
    CU_ASSERT_EQUAL(model.machine.threads, rows[k].chosen);
  }
  int number = 1;
#ifdef _OPENMP
  const int before = omp_get_max_threads();
  omp_set_num_threads(5), number = 5;
#endif
  CU_ASSERT_EQUAL(nb_machine_choose(&model, &(struct nb_options){.threads = 0}, &error), NB_OK);
  CU_ASSERT_EQUAL(model.machine.threads, number);
  CU_ASSERT_EQUAL(nb_machine_choose(&model, NULL, &error), NB_OK);
  CU_ASSERT_EQUAL(model.machine.threads, 1);
#ifdef _OPENMP
  omp_set_num_threads(before);
#endif
  const int widest = (int)model.machine.isa;
  for (int isa = 0; isa < 4; isa++) {
    const enum nb_status status = nb_machine_choose(&model, &(struct nb_options){.isa = names[isa]}, &error);
    CU_ASSERT_EQUAL(status, isa <= widest ? NB_OK : NB_BAD_USE);
    CU_ASSERT(status || (int)model.machine.isa == isa);
    char wanted[160] = "expected `--isa plain`, `avx2` or `avx512`, found `mmx`";
    if (isa < 3)
      snprintf(wanted, sizeof wanted, "this machine does not run `--isa %s`; the widest that it runs is `%s`",
               names[isa], names[widest]);
    CU_ASSERT(!status || strcmp(error.text, wanted) == 0);
  }
  CU_ASSERT_STRING_EQUAL(error.text, "expected `--isa plain`, `avx2` or `avx512`, found `mmx`");
}

/* A saved state does not depend on the rounding mode of the run that needs it. In that run itself the disc moves 100
 * times by 0.01 * 0.3, which no double equals, and the modes differ. */
static void states_are_rounded_to_nearest(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  double state[2], run[2];
  words_add(&page, "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m velocity 0.3 0\nmonitor D disc 1\n"
                   "record D.x\nstep 0.01\nstage a\ncycles 100\n");
  written_scene(&it, &page);
  for (int up = 0; up < 2; up++) {
    const struct nb_options options = {.threads = 1, .rounding.mode = up ? NB_UPWARD : NB_TO_NEAREST};
    struct nb_saved saved = {0};
    struct nb_result result;
    CU_ASSERT_EQUAL(nb_run_to(&saved, &it.scene, &options, NULL, &error), NB_OK);
    state[up] = saved.particles[0].position.x;
    written_run(&result, &it, &options);
    run[up] = written_last(&result, "D.x");
    nb_saved_free(&saved), nb_result_free(&result);
  }
  CU_ASSERT(state[0] == state[1] && state[0] == run[0] && run[0] < run[1]);
  written_free(&it);
}

/* A state with the hash of the stage, but with a particle of another radius, does not fit the page. */
static void a_state_of_other_particles_is_refused(void) {
  char folder[] = "/tmp/nineball-run-XXXXXX", first[64], second[64], path[4096];
  CU_ASSERT_PTR_NOT_NULL_FATAL(mkdtemp(folder));
  snprintf(first, sizeof first, "%s/first.md", folder), snprintf(second, sizeof second, "%s/second.md", folder);
  static const char *const texts[] = {
      "```scene\nunits none\nmaterial m density 1 kn 1\ndisc 1 2 radius 3 m\nstep 0.1\nstage a\ncycles 1\n```\n",
      "```scene\nunits none\nstart first stage a\nrecord time\nstage b\ncycles 1\n```\n"};
  for (int k = 0; k < 2; k++) {
    FILE *file = fopen(k ? second : first, "w");
    CU_ASSERT_PTR_NOT_NULL_FATAL(file);
    fputs(texts[k], file), fclose(file);
  }
  struct nb_outcome outcome;
  struct nb_error error;
  struct nb_saved saved, again;
  const struct nb_options options = {.threads = 1, .states = folder};
  CU_ASSERT_EQUAL_FATAL(nb_outcome_read(&outcome, second, NULL), NB_OK);
  const struct nb_scene *scene = &outcome.runs[0].scene, *from = scene->start.scene;
  CU_ASSERT_EQUAL_FATAL(nb_start_path(path, sizeof path, scene, &options, &error), NB_OK);
  CU_ASSERT_EQUAL_FATAL(nb_run_to(&saved, from, &options, NULL, &error), NB_OK);
  saved.hash = from->stages[from->stage_count - 1].hash;
  for (int k = 0; k < 2; k++) {
    saved.particles[0].radius = k ? 2 : 3;
    CU_ASSERT_EQUAL(nb_saved_write(&saved, path, &error), NB_OK);
    CU_ASSERT_EQUAL(nb_start_obtain(&again, scene, &options, NULL, false, &error), k ? NB_BAD_USE : NB_OK);
    nb_saved_free(&again);
  }
  CU_ASSERT_PTR_NOT_NULL(strstr(error.text, "expected the state of 1 particles"));
  nb_saved_free(&saved), nb_outcome_free(&outcome);
  unlink(path), unlink(first), unlink(second);
  CU_ASSERT_EQUAL(rmdir(folder), 0);
}

void suite_run(void) {
  CU_pSuite suite = CU_add_suite("run", NULL, NULL);
  CU_add_test(suite, "rows are recorded as requested", rows_are_recorded_as_requested);
  CU_ADD_TEST(suite, contact_updates_of_a_stage);
  CU_ADD_TEST(suite, a_trial_shortens_stages);
  CU_add_test(suite, "walls keep their velocity until a stage changes it", walls_keep_their_velocity);
  CU_add_test(suite, "a stage ends when all conditions hold", a_stage_ends_when_all_conditions_hold);
  CU_add_test(suite, "the time of a stage begins with the stage", time_of_a_stage);
  CU_add_test(suite, "a stage that never ends", a_stage_that_never_ends);
  CU_ADD_TEST(suite, units_of_conditions);
  CU_add_test(suite, "a position that is NaN or infinite", a_position_that_is_nan_or_infinite);
  CU_add_test(suite, "a snapshot has the contacts that touch", a_snapshot_has_the_touching_contacts);
  CU_add_test(suite, "a stage that ends in an aborted cycle has no snapshot", an_aborted_cycle_has_no_snapshot);
  CU_add_test(suite, "a stage that waits in vain, without a contact force", waits_for_contacts_in_vain);
  CU_add_test(suite, "conditions that are checked every N cycles", conditions_checked_every_n_cycles);
  CU_add_test(suite, "repeated stages", repeated_stages);
  CU_ADD_TEST(suite, repeated_stages_with_long_names);
  CU_add_test(suite, "settings change the hash", settings_change_the_hash);
  CU_add_test(suite, "packings change the hash", packings_change_the_hash);
  CU_add_test(suite, "parts of a team", parts_of_a_team);
  CU_ADD_TEST(suite, threads_of_a_model);
  CU_add_test(suite, "threads and instruction set", threads_and_instruction_set);
  CU_ADD_TEST(suite, states_are_rounded_to_nearest);
  CU_ADD_TEST(suite, a_state_of_other_particles_is_refused);
}
