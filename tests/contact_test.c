/* Contact tests: the steps of segments, prescribed forces, forces that cannot be reached, the traction over the
 * contact.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <signal.h>
#include <string.h>
#include <time.h>

#include "../src/measure/snapshot.h"
#include "../src/run/contact_test.h"
#include "suites.h"
#include "written.h"

#define STEEL                                                                                                          \
  "path\nmaterial steel young 210 GPa poisson 0.3 friction 0.3\nmaterial hard rigid friction 1\n"                      \
  "contact sphere 10 mm steel with sphere 30 mm steel\nnormal hertz\n"
#define EXACT STEEL "shear mindlin_deresiewicz\n"

/* Column c of row r. */
static double cell(const struct nb_result *result, size_t r, size_t c) {
  return result->table.values[r * result->table.column_count + c];
}

static void run(struct nb_result *result, struct written *it, const char *text) {
  struct words page = {0};
  words_add(&page, "%s", text);
  written_scene(it, &page);
  written_run(result, it, NULL);
}

static void done(struct nb_result *result, struct written *it) {
  nb_result_free(result);
  written_free(it);
}

/* Segments go along straight lines `to` a value or `by` a difference. The last step ends exactly at the target,
 * whatever the rounding errors of the steps before. */
static void segments_go_along_straight_lines(void) {
  struct written it;
  struct nb_result result;
  run(&result, &it,
      STEEL "segment a overlap to 3 um slip by 0.7 um in 3 steps\nsegment b overlap by -1 um in 1 step\nsegment c slip "
            "to -0.2 um "
            "in 2 steps\n");
  static const double overlap[] = {0, 1e-6, 2e-6, 3e-6, 2e-6, 2e-6, 2e-6};
  static const double slip[] = {0, 0.7e-6 / 3, 1.4e-6 / 3, 0.7e-6, 0.7e-6, 0.25e-6, -0.2e-6};
  CU_ASSERT_EQUAL_FATAL(result.table.row_count, 7);
  for (size_t r = 0; r < 7; r++) { /* columns are the usual ones: step, overlap, slip, normal, shear */
    CU_ASSERT(cell(&result, r, 0) == (double)r);
    CU_ASSERT_DOUBLE_EQUAL(cell(&result, r, 1), overlap[r], 1e-21);
    CU_ASSERT_DOUBLE_EQUAL(cell(&result, r, 2), slip[r], 1e-21);
  }
  CU_ASSERT(cell(&result, 3, 1) == 3e-6 && cell(&result, 3, 2) == 0.7e-6 && cell(&result, 6, 2) == -0.2e-6);
  CU_ASSERT(cell(&result, 4, 2) == 0.7e-6); /* slip is held */
  CU_ASSERT(result.cycles == 6 && result.stages[0].cycles == 3 && result.stages[2].cycles == 2);
  double seconds = 0; /* of the processor; the segments are parts of the test */
  for (int s = 0; s < 3; s++) {
    CU_ASSERT(result.stages[s].seconds >= 0);
    seconds += result.stages[s].seconds;
  }
  CU_ASSERT(seconds <= result.seconds + 1e-3);
  done(&result, &it);
}

/* A segment records each step, every N steps and the last one, or none. */
static void rows_of_segments(void) {
  struct written it;
  struct nb_result result;
  run(&result, &it,
      STEEL "segment a overlap to 3 um in 3 steps\nsegment b overlap to 4 um in 5 steps\nrecord none\n"
            "segment c overlap to 5 um in 5 steps\nrecord every 2 steps\n");
  static const double steps[] = {0, 1, 2, 3, 10, 12, 13};
  CU_ASSERT_EQUAL_FATAL(result.table.row_count, 7);
  for (size_t r = 0; r < 7; r++)
    CU_ASSERT_EQUAL(cell(&result, r, 0), steps[r]);
  done(&result, &it);
}

/* The work since the start is the sum of the stored and the dissipated energy, also over loops of the slip. The
 * dissipated energy never decreases. */
static void work_is_stored_or_dissipated(void) {
  struct written it;
  struct nb_result result;
  run(&result, &it,
      EXACT "record work work.normal work.shear stored dissipated\nsegment a overlap to 3 um in 400 steps\n"
            "segment b slip to 1 um in 400 steps\nsegment c slip to -1 um in 800 steps\nsegment d slip to 1.5 um in "
            "900 steps\nsegment e slip to 0 um in 400 steps\n");
  double before = 0;
  for (size_t r = 0; r < result.table.row_count; r++) {
    const double work = cell(&result, r, 0), dissipated = cell(&result, r, 4);
    CU_ASSERT_DOUBLE_EQUAL(work, cell(&result, r, 1) + cell(&result, r, 2), 1e-15 * fabs(work));
    CU_ASSERT_DOUBLE_EQUAL(work, cell(&result, r, 3) + dissipated, 1e-4 * fabs(work) + 1e-10);
    CU_ASSERT(dissipated >= before);
    before = dissipated;
  }
  CU_ASSERT(before > 0.01 * written_last(&result, "work"));
  done(&result, &it);
}

/* Prescribed forces are reached to rounding with any law; a force that is held stays constant. */
static void forces_are_reached(void) {
  static const char *const shears[] = {"mindlin_deresiewicz", "mindlin", "mindlin_scaled", "randall"};
  for (size_t k = 0; k < sizeof shears / sizeof *shears; k++) {
    char text[1024];
    struct written it;
    struct nb_result result;
    snprintf(text, sizeof text,
             STEEL "shear %s\nsegment a normal to 80 N in 7 steps\nsegment b shear to 10 N hold normal in 4 steps\n"
                   "segment c normal by -20 N hold shear in 5 steps\nsegment d shear by -25 N in 3 steps\n"
                   "segment e normal to 0 N in 1 step\nsegment f normal to 5 N in 1 step\n",
             shears[k]);
    run(&result, &it, text);
    for (size_t r = 0; r <= 7; r++)
      CU_ASSERT_DOUBLE_EQUAL(cell(&result, r, 3), 80. * (double)r / 7, 1e-12);
    for (size_t r = 7; r <= 11; r++)
      CU_ASSERT_DOUBLE_EQUAL(cell(&result, r, 4), 2.5 * (double)(r - 7), 1e-12);
    CU_ASSERT(cell(&result, 11, 1) == cell(&result, 7, 1));
    for (size_t r = 12; r <= 16; r++) {
      CU_ASSERT_DOUBLE_EQUAL(cell(&result, r, 3), 80 - 4 * (double)(r - 11), 1e-12);
      CU_ASSERT_DOUBLE_EQUAL(cell(&result, r, 4), 10, 1e-12);
    }
    CU_ASSERT_DOUBLE_EQUAL(cell(&result, 19, 4), -15, 1e-12);
    CU_ASSERT(cell(&result, 20, 3) < 1e-300 && fabs(cell(&result, 20, 4)) < 1e-300);
    CU_ASSERT_DOUBLE_EQUAL(cell(&result, 21, 3), 5, 1e-12);
    done(&result, &it);
  }
}

static void expect_stop(const char *text, const char *message) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  struct nb_error error = {0};
  words_add(&page, "%s", text);
  written_scene(&it, &page);
  CU_ASSERT_EQUAL(nb_run(&result, &it.scene, NULL, NULL, &error), NB_BROKEN);
  CU_ASSERT_STRING_EQUAL(error.text, message);
  if (strcmp(error.text, message) != 0)
    printf("# %s\n", error.text);
  done(&result, &it);
}

static void unreachable_forces_stop_the_run(void) {
  expect_stop(
      EXACT "segment a normal to 10 N in 1 step\nsegment b shear to 5 N in 5 steps\n",
      "segment `b` (line 8), step 4 of 5: a shear force of 4 N cannot be reached; the force is 3 N; friction times the "
      "normal force, plus cohesion, is 3 N");
  expect_stop(EXACT "segment a normal to 10 N in 1 step\nsegment b normal by -20 N in 4 steps\n",
              "segment `b` (line 8), step 3 of 4: a normal force of -5 N cannot be reached; the force is 0 N");
  expect_stop(STEEL "segment a normal to 10 N in 1 step\nsegment b shear to -1 N in 1 step\n",
              "segment `b` (line 7), step 1 of 1: a shear force of -1 N cannot be reached; the force is 0 N; friction "
              "times the normal force, plus cohesion, is 3 N");
  expect_stop("path\nunits none\nmaterial rock kn 100 ks 80 friction 0.25 cohesion 3\ncontact disc 1 rock with disc 1 "
              "rock\nnormal linear\nshear linear\nsegment press normal to 8\nsegment slide shear to -9 in 3 steps\n",
              "segment `slide` (line 8), step 2 of 3: a shear force of -6 cannot be reached; the force is -5; friction "
              "times the normal force, plus cohesion, is 5"); /* 0.25 x 8 + 3 */
  expect_stop(
      "path\nunits none\nmaterial rock kn 100 ks 80 friction 0.25\ncontact disc 1 rock with disc 1 rock\nnormal "
      "linear\nshear linear\nsegment press normal to 8\nsegment slide normal to 4 shear to 2 in 2 steps\n",
      "segment `slide` (line 8), step 2 of 2: a shear force of 2 cannot be reached; the force is 1; friction "
      "times the normal force, plus cohesion, is 1"); /* 0.25 x 4, with the normal force of this step */
}

/* A shear force at the friction limit that the page gives in decimal, 0.3 N, may exceed the product of the program by
 * rounding. It counts as reached, in both directions. */
static void a_limit_with_rounding_is_reached(void) {
  for (int k = 1; k <= 40; k++)
    for (int sign = -1; sign < 2; sign += 2) {
      char text[1024];
      struct written it;
      struct nb_result result;
      snprintf(text, sizeof text, EXACT "segment a normal to %d.%d N in 1 step\nsegment b shear to %g N in 1 step\n", k,
               k % 10, sign * 0.3 * (k + k % 10 / 10.));
      run(&result, &it, text);
      CU_ASSERT_DOUBLE_EQUAL(cell(&result, 2, 4), sign * 0.3 * (k + k % 10 / 10.), 1e-11);
      done(&result, &it);
    }
}

/* A force is sought within twice the smaller radius, here 2, of the present displacement, which is 0.1. The stiffness is
 * 1, so a force needs a displacement of the same number. */
static void forces_are_sought_within_the_smaller_diameter(void) {
  static const struct {
    const char *radii[2], *force;
    bool reached;
  } rows[] = {{{"10", "1"}, "5", false},  {{"1", "10"}, "5", false},   {{"10", "10"}, "5", true},
              {{"1", "10"}, "1.9", true}, {{"1", "10"}, "2.2", false}, {{"10", "1"}, "1.9", true}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    struct nb_error error = {0};
    words_add(&page,
              "path\nunits none\nmaterial a kn 1\ncontact disc %s a with disc %s a\nnormal linear\nrecord normal\n"
              "segment a normal to 0.1 in 1 step\nsegment b normal to %s in 1 step\n",
              rows[k].radii[0], rows[k].radii[1], rows[k].force);
    written_scene(&it, &page);
    CU_ASSERT_EQUAL(nb_run(&result, &it.scene, NULL, NULL, &error), rows[k].reached ? NB_OK : NB_BROKEN);
    CU_ASSERT(rows[k].reached || strstr(error.text, "cannot be reached; the force is "));
    done(&result, &it);
  }
}

/* The stiffness of two materials is 2ab/(a+b) of their stiffnesses, here 100 and 300. With `units none` a material may
 * have the name of a unit, `m`. */
static void a_contact_of_two_materials(void) {
  struct written it;
  struct nb_result result;
  run(&result, &it,
      "path\nunits none\nmaterial m kn 100\nmaterial s kn 300\ncontact disc 1 m with disc 1 s\nnormal linear\nrecord "
      "normal\nsegment press overlap to 0.5 in 2 steps\nsegment more overlap to 0.75 in 1 step\n");
  CU_ASSERT_DOUBLE_EQUAL(cell(&result, 2, 0), 150 * 0.5, 1e-12);
  CU_ASSERT(result.stages[0].cycles == 2 && result.stages[0].updates == 2);
  CU_ASSERT(result.stages[1].cycles == 1 && result.stages[1].updates == 1);
  CU_ASSERT(result.cycles == 3 && result.updates == 3);
  done(&result, &it);
}

/* Waits for longer than the time between two reports of progress, so that each step is reported. */
static void add_report(void *data, const char *segment, double fraction, double seconds) {
  char *text = data;
  CU_ASSERT(seconds >= 0);
  snprintf(text + strlen(text), 64 - strlen(text), "%s %g, ", segment, fraction);
  nanosleep(&(struct timespec){.tv_nsec = 110000000}, NULL);
}

/* The progress of a contact test is the part of its segments that is done. */
static void progress_of_segments(void) {
  char text[64] = "";
  const struct nb_progress progress = {.call = add_report, .data = text};
  struct words page = {0};
  struct written it;
  struct nb_result result;
  struct nb_error error = {0};
  words_add(&page, STEEL "segment a overlap to 1 um in 2 steps\nsegment b overlap to 2 um in 1 step\n");
  written_scene(&it, &page);
  CU_ASSERT_EQUAL(nb_run(&result, &it.scene, NULL, &progress, &error), NB_OK);
  CU_ASSERT_STRING_EQUAL(text, "a 0.25, a 0.5, b 1, ");
  done(&result, &it);
}

static void ask_to_stop(void *data, const char *segment, double fraction, double seconds) {
  volatile sig_atomic_t *const stop = data;
  (void)fraction, (void)seconds;
  *stop = strcmp(segment, "b") == 0;
  nanosleep(&(struct timespec){.tv_nsec = 110000000}, NULL);
}

/* A signal after the first step of segment `b`, which is step 3 of the test, is seen after the next step. */
static void a_signal_stops_the_test(void) {
  volatile sig_atomic_t stop = 0;
  const struct nb_options options = {.threads = 1, .checkpoint = {.stop = &stop}};
  const struct nb_progress progress = {.call = ask_to_stop, .data = (void *)&stop};
  struct words page = {0};
  struct written it;
  struct nb_result result;
  struct nb_error error = {0};
  words_add(&page, STEEL "segment a overlap to 1 um in 2 steps\nsegment b overlap to 2 um in 9 steps\n");
  written_scene(&it, &page);
  CU_ASSERT_EQUAL(nb_run(&result, &it.scene, &options, &progress, &error), NB_BROKEN);
  CU_ASSERT_STRING_EQUAL(error.text,
                         "stopped by a signal after step 4; a contact test cannot be continued, so run it again");
  CU_ASSERT(result.cycles == 4 && result.stages[1].cycles == 2 && result.seconds >= 0.3);
  done(&result, &it);
}

/* A trial ends a segment when its time is over. It shortens a segment of two steps, but not one of a single step. */
static void a_trial_shortens_segments(void) {
  static const struct nb_progress progress = {.stage_seconds = 1e-9};
  for (int steps = 1; steps < 3; steps++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    struct nb_error error = {0};
    words_add(&page, STEEL "segment a overlap to 1 um in %d step\nsegment b overlap to 3 um in 1 step\n", steps);
    written_scene(&it, &page);
    CU_ASSERT_EQUAL(nb_run(&result, &it.scene, NULL, &progress, &error), NB_OK);
    CU_ASSERT(result.stages[0].cycles == 1 && result.stages[1].cycles == 1 && result.shortened == (steps > 1));
    CU_ASSERT_DOUBLE_EQUAL(cell(&result, 2, 1), 3e-6, 1e-20);
    done(&result, &it);
  }
}

/* Prescribed shear forces at the friction limit are reached to rounding. */
static void the_limit_is_reached(void) {
  struct written it;
  struct nb_result result;
  run(&result, &it,
      EXACT "segment a normal to 77 N in 1 step\nsegment b shear to 23.1 N in 3 steps\nsegment c shear to -23.1 N in 3 "
            "steps\n");
  CU_ASSERT_DOUBLE_EQUAL(cell(&result, 4, 4), 23.1, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(cell(&result, 7, 4), -23.1, 1e-12);
  const double way = 3 * 23.1 / 16 / (1 / (2 * 2 * 1.3 * 1.7 / 210e9)); /* slip at the friction limit, times a */
  const double a = sqrt(7.5e-3 * cell(&result, 1, 1));
  CU_ASSERT_DOUBLE_EQUAL(cell(&result, 4, 2), way / a, 1e-9 * way / a);
  done(&result, &it);
}

static void repeated_segments_have_names(void) {
  struct written it;
  struct nb_result result;
  run(&result, &it,
      STEEL "segment a overlap to 1 um in 2 steps\nsegment b overlap by 1 um in 1 step\nsegment c slip by 1 um in 3 "
            "steps\nrepeat "
            "from b 2 more times\n");
  static const char *const names[] = {"a", "b", "c", "b-2", "c-2", "b-3", "c-3"};
  CU_ASSERT_EQUAL_FATAL(it.scene.stage_count, 7);
  for (size_t s = 0; s < 7; s++)
    CU_ASSERT_STRING_EQUAL(it.scene.stages[s].name, names[s]);
  CU_ASSERT_EQUAL(result.cycles, 14);
  CU_ASSERT_DOUBLE_EQUAL(cell(&result, 14, 1), 4e-6, 1e-20);
  CU_ASSERT_DOUBLE_EQUAL(cell(&result, 14, 2), 3e-6, 1e-20);
  done(&result, &it);
}

/* In a gap the overlap is 0 and slip has no effect. In the step that closes the gap, only the fraction of the slip
 * after first touch counts. */
static void a_gap_ends_the_history(void) {
  struct written it;
  struct nb_result result;
  run(&result, &it,
      STEEL
      "shear mindlin\nrecord approach overlap slip normal shear work.normal work.shear\nsegment a overlap to 1 um "
      "slip by 0.1 um in 1 step\n"
      "segment b overlap to -1 um in 1 step\nsegment c slip by 5 um in 1 step\nsegment d overlap to 1 um slip by 0.2 "
      "um in 1 "
      "step\n");
  CU_ASSERT(cell(&result, 2, 0) == -1e-6 && cell(&result, 2, 1) == 0 && cell(&result, 2, 4) == 0);
  CU_ASSERT(cell(&result, 3, 4) == 0 && cell(&result, 3, 6) == cell(&result, 2, 6));
  CU_ASSERT_DOUBLE_EQUAL(cell(&result, 4, 4), cell(&result, 1, 4), 1e-9); /* half of the step, twice the slip */
  CU_ASSERT_DOUBLE_EQUAL(cell(&result, 4, 6) - cell(&result, 3, 6), cell(&result, 1, 6), 1e-16);
  CU_ASSERT_DOUBLE_EQUAL(cell(&result, 1, 5), cell(&result, 1, 3) / 2 * 1e-6, 1e-18);
  CU_ASSERT_DOUBLE_EQUAL(cell(&result, 2, 5), 0, 1e-18);
  done(&result, &it);
}

/* After a gap the same approach and slip give the same forces, with every law that has a history. */
static void a_contact_after_a_gap_is_new(void) {
  static const char *const laws[] = {"mindlin", "mindlin_scaled", "mindlin_deresiewicz", "randall", "randall_literal"};
  for (size_t k = 0; k < sizeof laws / sizeof *laws; k++) {
    struct written it;
    struct nb_result result;
    char text[1024];
    snprintf(text, sizeof text,
             STEEL "shear %s\nrecord normal shear\nsegment a overlap to 1 um slip by 0.1 um in 1 step\n"
                   "segment b slip by -0.05 um in 1 step\nsegment c overlap to 0 um in 1 step\n"
                   "segment d overlap to 1 um slip by 0.1 um in 1 step\nsegment e slip by -0.05 um in 1 step\n",
             laws[k]);
    run(&result, &it, text);
    CU_ASSERT(cell(&result, 1, 1) > 0 && cell(&result, 2, 1) < cell(&result, 1, 1) && cell(&result, 3, 1) == 0);
    for (size_t r = 1; r < 3; r++)
      for (size_t c = 0; c < 2; c++)
        CU_ASSERT_DOUBLE_EQUAL(cell(&result, r + 3, c), cell(&result, r, c), 1e-9 * cell(&result, 1, 0));
    done(&result, &it);
  }
}

/* A normal law by increments keeps its force in the contact history. It loads with the radius before each step, so its
 * force is smaller than Hertz's 4/3 E* (R*)^(1/2) d^(3/2), by less than 2 % in 200 steps. A contact that has opened begins
 * again. A prescribed force is reached. */
static void increments_of_the_normal_force(void) {
  struct written it;
  struct nb_result result;
  run(&result, &it,
      "path\nmaterial steel young 210 GPa poisson 0.3 friction 0.3\n"
      "contact sphere 10 mm steel with sphere 30 mm steel\nnormal hertz_increment\nrecord normal overlap\nsegment a "
      "overlap to 1 um in 200 steps\nrecord every 200 steps\n"
      "segment b overlap to 0 um in 1 step\nsegment c overlap to 1 um in 200 steps\nrecord every 200 steps\n"
      "segment d normal by 5 N in 1 step\n");
  const double hertz = 4. / 3 * 210e9 / 0.91 / 2 * sqrt(7.5e-3 * 1e-18), first = cell(&result, 1, 0);
  CU_ASSERT(first < hertz && first > 0.98 * hertz);
  CU_ASSERT(cell(&result, 2, 0) == 0 && cell(&result, 3, 0) == first);
  CU_ASSERT_DOUBLE_EQUAL(cell(&result, 4, 0), first + 5, 1e-12);
  CU_ASSERT(cell(&result, 4, 1) > 1e-6);
  done(&result, &it);
}

/* The shear force of a contact with cohesion c stays at the limit mu N + c. */
static void cohesion_raises_the_limit(void) {
  struct nb_result result;
  struct written it;
  run(&result, &it,
      "path\nunits none\nmaterial rock kn 100 ks 80 friction 0.25 cohesion 3\ncontact disc 1 rock with disc 1 rock\n"
      "normal linear\nshear linear\nrecord step normal shear limit\nsegment press overlap to 0.08\nsegment slide slip "
      "by 0.4\n");
  const size_t last = result.table.row_count - 1;
  CU_ASSERT_DOUBLE_EQUAL(cell(&result, last, 1), 8, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(cell(&result, last, 3), 0.25 * 8 + 3, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(cell(&result, last, 2), cell(&result, last, 3), 1e-12);
  done(&result, &it);
}

/* A wall has no curvature, and a rigid material does not deform. E* and R* are computed by hand. */
static void a_wall_is_flat(void) {
  struct words page = {0};
  struct written it;
  struct nb_contact_test contact_test;
  struct nb_error error;
  words_add(&page, "path\nmaterial steel young 210 GPa poisson 0.3 friction 0.3\nmaterial hard rigid friction 1\n"
                   "contact sphere 10 mm steel with wall hard\nnormal hertz\nsegment a overlap to 1 um\n");
  written_scene(&it, &page);
  CU_ASSERT_EQUAL_FATAL(nb_contact_test_create(&contact_test, &it.scene, &error), NB_OK);
  CU_ASSERT(contact_test.pair.radius == 0.01 && contact_test.pair.friction == 0.3);
  CU_ASSERT_DOUBLE_EQUAL(contact_test.pair.young, 210e9 / 0.91, 1);
  nb_contact_test_free(&contact_test);
  written_free(&it);
}

/* Loading at constant N: q = (3 mu N/2 pi a^3) [(a^2 - r^2)^(1/2) - (c^2 - r^2)^(1/2)], with the second root only for
 * r < c [R89 3.23]. The table of the pieces gives D(x). */
static void the_traction_is_mindlins(void) {
  struct written it;
  struct nb_result result;
  run(&result, &it,
      EXACT "record normal shear radius radius.stick pieces traction.force\nsegment a normal to 60 N in 1 "
            "step\nsegment b shear to 9 N in 1 "
            "step\nsnapshot\n");
  const double n = cell(&result, 2, 0), t = cell(&result, 2, 1), a = cell(&result, 2, 2),
               c = a * cbrt(1 - t / (0.3 * n));
  CU_ASSERT_DOUBLE_EQUAL(cell(&result, 2, 3), c, 1e-9 * a);
  CU_ASSERT(cell(&result, 2, 4) == 2);
  CU_ASSERT_DOUBLE_EQUAL(cell(&result, 2, 5), t, 1e-9 * t);
  CU_ASSERT(result.seconds > 0 && result.stages[1].seconds > 0);
  CU_ASSERT_EQUAL_FATAL(result.snapshot_count, 1);
  const struct nb_table *table;
  const char *name;
  CU_ASSERT_FATAL(nb_snapshot_part(&result.snapshots[0], 0, &name, &table) && strcmp(name, "traction") == 0);
  CU_ASSERT(result.snapshots[0].stage == 1 && table->row_count == 401);
  const double pi = acos(-1), scale = 3 * 0.3 * n / (2 * pi * a * a * a);
  for (size_t r = 0; r < table->row_count; r++) {
    const double *row = table->values + 4 * r, s = row[0] * row[0];
    CU_ASSERT(table->stage[r] == 1 && table->cycle[r] == 2 && table->time[r] == 0);
    CU_ASSERT_DOUBLE_EQUAL(row[0], a * sin(pi / 2 * (double)r / 400), 1e-12 * a); /* from the centre to the edge */
    const double q = scale * (sqrt(fmax(a * a - s, 0)) - sqrt(fmax(c * c - s, 0)));
    CU_ASSERT_DOUBLE_EQUAL(row[2], q, 1e-6 * scale * a); /* (1e-12)^(1/2), from the root at r = c */
    CU_ASSERT_DOUBLE_EQUAL(row[3], scale * sqrt(fmax(a * a - s, 0)), 1e-6 * scale * a);
    CU_ASSERT_DOUBLE_EQUAL(0.3 * row[1], row[3], 1e-6 * scale * a);
  }
  CU_ASSERT_DOUBLE_EQUAL(table->values[4 * (table->row_count - 1)], a, 1e-12 * a);
  CU_ASSERT_FATAL(nb_snapshot_part(&result.snapshots[0], 1, &name, &table) && strcmp(name, "pieces") == 0);
  static const double D[] = {0, 0, 1, 1};
  CU_ASSERT_EQUAL_FATAL(table->row_count, 4);
  for (size_t r = 0; r < 4; r++) {
    const double radius[] = {0, c, c, a};
    CU_ASSERT(table->stage[r] == 1 && table->cycle[r] == 2 && table->time[r] == 0);
    CU_ASSERT_DOUBLE_EQUAL(table->values[3 * r + 1], radius[r], 1e-9 * a);
    CU_ASSERT_DOUBLE_EQUAL(table->values[3 * r], radius[r] * radius[r] / 7.5e-3, 1e-9 * a * a / 7.5e-3);
    CU_ASSERT_DOUBLE_EQUAL(table->values[3 * r + 2], D[r], 1e-9);
  }
  CU_ASSERT(!nb_snapshot_part(&result.snapshots[0], 2, &name, &table));
  done(&result, &it);
}

/* The radius within which nothing slips is the same for both senses of the shear force, also after it has reversed. */
static void the_stick_radius_in_both_senses(void) {
  static const char *const paths[][2] = {{"9 N", "-9 N"}, {"-9 N", "9 N"}};
  double stick[2][2];
  for (size_t k = 0; k < 2; k++) {
    struct written it;
    struct nb_result result;
    char text[1024];
    snprintf(text, sizeof text,
             EXACT
             "record normal shear radius radius.stick\nsegment a normal to 60 N in 1 step\nsegment b shear to %s in "
             "1 step\nsegment c shear to %s in 1 step\n",
             paths[k][0], paths[k][1]);
    run(&result, &it, text);
    const double n = cell(&result, 2, 0), a = cell(&result, 2, 2), c = a * cbrt(1 - 9 / (0.3 * n));
    CU_ASSERT_DOUBLE_EQUAL(cell(&result, 2, 3), c, 1e-9 * a);
    for (int r = 0; r < 2; r++)
      stick[k][r] = cell(&result, 2 + (size_t)r, 3);
    done(&result, &it);
  }
  for (int r = 0; r < 2; r++)
    CU_ASSERT_EQUAL(stick[0][r], stick[1][r]);
}

/* The stick radius of a contact that is open, or that slides as a whole, is 0. */
static void nothing_sticks(void) {
  struct written it;
  struct nb_result result;
  run(&result, &it,
      EXACT "record pieces radius.stick sliding traction.force\nsegment a normal to 60 N in 1 step\n"
            "segment b slip by 1 mm in 1 step\nsegment c slip by -1 mm in 1 step\nsegment d overlap to -1 um in 1 "
            "step\n");
  static const double pieces[] = {0, 1, 1, 1, 0}, sliding[] = {0, 0, 1, -1, 0};
  for (size_t r = 0; r < 5; r++) {
    CU_ASSERT_EQUAL(cell(&result, r, 0), pieces[r]);
    CU_ASSERT(r == 1 ? cell(&result, r, 1) > 0 : cell(&result, r, 1) == 0);
    CU_ASSERT_EQUAL(fabs(cell(&result, r, 2)), fabs(sliding[r]));
    CU_ASSERT_DOUBLE_EQUAL(cell(&result, r, 3), 18 * sliding[r], 1e-9);
  }
  done(&result, &it);
}

/* If N and T grow in proportion, nothing slips as long as T < mu N, however near T comes to mu N: the stick radius is
 * the radius of the contact. */
static void nothing_slips_below_the_limit(void) {
  static const double below[] = {1e-2, 1e-4, 1e-7};
  for (size_t k = 0; k < sizeof below / sizeof *below; k++) {
    struct written it;
    struct nb_result result;
    char text[512];
    snprintf(text, sizeof text,
             EXACT "record radius radius.stick\nsegment a normal to 60 N shear to %.17g N in 1 step\n",
             0.3 * 60 * (1 - below[k]));
    run(&result, &it, text);
    CU_ASSERT_DOUBLE_EQUAL(cell(&result, 1, 1), cell(&result, 1, 0), 1e-9 * cell(&result, 1, 0));
    done(&result, &it);
  }
}

/* With a wall there is one particle. The array of particles has room for more, and what is there must not limit the
 * displacements at which a force is sought. */
static void a_force_between_a_sphere_and_a_wall(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "path\nmaterial steel young 210 GPa poisson 0.3 friction 0.3\nmaterial hard rigid friction 1\n"
                   "contact sphere 10 mm steel with wall hard\nnormal hertz\nshear mindlin\n"
                   "segment press normal to 40 N in 2 steps\nsegment push shear to 3 N in 3 steps\n");
  written_scene(&it, &page);
  CU_ASSERT_EQUAL_FATAL(it.scene.particle_count, 1);
  it.scene.particles[1] = it.scene.particles[0];
  it.scene.particles[1].radius = 1e-15;
  written_run(&result, &it, NULL);
  /* N = 4/3 E* (R alpha^3)^(1/2) */
  const double alpha = pow(3 * 40 / (4 * (210e9 / 0.91) * sqrt(0.01)), 2. / 3);
  CU_ASSERT_DOUBLE_EQUAL(cell(&result, 2, 1) / alpha, 1, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(cell(&result, 5, 3), 40, 1e-9);
  CU_ASSERT_DOUBLE_EQUAL(cell(&result, 5, 4), 3, 1e-9);
  done(&result, &it);
}

void suite_contact_test(void) {
  CU_pSuite suite = CU_add_suite("contact_test", NULL, NULL);
  CU_add_test(suite, "work is stored or dissipated", work_is_stored_or_dissipated);
  CU_add_test(suite, "segments go along straight lines", segments_go_along_straight_lines);
  CU_ADD_TEST(suite, rows_of_segments);
  CU_add_test(suite, "forces are reached", forces_are_reached);
  CU_add_test(suite, "a force between a sphere and a wall", a_force_between_a_sphere_and_a_wall);
  CU_add_test(suite, "a force that cannot be reached stops the run", unreachable_forces_stop_the_run);
  CU_add_test(suite, "shear forces at the friction limit are reached", the_limit_is_reached);
  CU_ADD_TEST(suite, a_limit_with_rounding_is_reached);
  CU_ADD_TEST(suite, forces_are_sought_within_the_smaller_diameter);
  CU_ADD_TEST(suite, a_contact_of_two_materials);
  CU_ADD_TEST(suite, progress_of_segments);
  CU_ADD_TEST(suite, a_signal_stops_the_test);
  CU_ADD_TEST(suite, a_trial_shortens_segments);
  CU_ADD_TEST(suite, increments_of_the_normal_force);
  CU_add_test(suite, "cohesion raises the limit", cohesion_raises_the_limit);
  CU_add_test(suite, "repeated segments have names", repeated_segments_have_names);
  CU_add_test(suite, "a gap ends the history", a_gap_ends_the_history);
  CU_add_test(suite, "a wall is flat", a_wall_is_flat);
  CU_add_test(suite, "the traction is Mindlin's", the_traction_is_mindlins);
  CU_add_test(suite, "the stick radius in both senses", the_stick_radius_in_both_senses);
  CU_ADD_TEST(suite, nothing_sticks);
  CU_add_test(suite, "nothing slips below the limit", nothing_slips_below_the_limit);
  CU_add_test(suite, "a contact after a gap is new", a_contact_after_a_gap_is_new);
}
