/* Runs of a sweep on several threads: after a failed run, the runs before it are still done.
 *
 * The test delays a thread between the moment at which it takes a run and the moment at which it starts the run. For
 * this it replaces the functions of gcc's OpenMP library by which a thread takes a run. With another compiler there is
 * no delay, and the tests print that they do not test the order of the runs.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "report/outcome.h"
#include "suites.h"
#include "written.h"

#if defined _OPENMP && !defined __clang__
typedef unsigned long long run_index;

/* The thread that takes the run `run` waits until threads have asked `needed` times for another run; needed 0: no
 * thread waits. `asked`: how often they have asked. */
static struct {
  run_index run;
  atomic_int needed, asked;
} delay;

static bool wait_if_delayed(bool taken, run_index run) {
  for (int k = 0; taken && run == delay.run && atomic_load(&delay.asked) < atomic_load(&delay.needed) && k < 5000; k++)
    nanosleep(&(struct timespec){.tv_nsec = 1000000}, NULL); /* 5 s at most */
  return taken;
}

bool GOMP_loop_ull_dynamic_start(bool up, run_index from, run_index to, run_index step, run_index chunk,
                                 run_index *first, run_index *end);
bool GOMP_loop_ull_dynamic_next(run_index *first, run_index *end);
bool GOMP_loop_ull_nonmonotonic_dynamic_start(bool up, run_index from, run_index to, run_index step, run_index chunk,
                                              run_index *first, run_index *end);
bool GOMP_loop_ull_nonmonotonic_dynamic_next(run_index *first, run_index *end);

bool GOMP_loop_ull_nonmonotonic_dynamic_start(bool up, run_index from, run_index to, run_index step, run_index chunk,
                                              run_index *first, run_index *end) {
  const bool taken = GOMP_loop_ull_dynamic_start(up, from, to, step, chunk, first, end);
  return wait_if_delayed(taken, taken ? *first : 0);
}
bool GOMP_loop_ull_nonmonotonic_dynamic_next(run_index *first, run_index *end) {
  atomic_fetch_add(&delay.asked, 1);
  const bool taken = GOMP_loop_ull_dynamic_next(first, end);
  return wait_if_delayed(taken, taken ? *first : 0);
}

static void delay_run(run_index run, int needed) {
  delay.run = run;
  atomic_store(&delay.asked, 0), atomic_store(&delay.needed, needed);
}
static void end_delay(void) {
  CU_ASSERT(atomic_load(&delay.asked) >= atomic_load(&delay.needed));
  atomic_store(&delay.needed, 0);
}
#else
static void delay_run(unsigned long long run, int needed) {
  (void)run, (void)needed;
  printf("# skip: the order of the runs, because this compiler's threads cannot be delayed\n");
}
static void end_delay(void) {}
#endif

/* Runs a page with the velocities v = 1, 2, 3 and 4, in m/s, two runs at a time. The particle moves by v times 1 s in a
 * step. If this is more than its radius, `radius`, in m, the run is aborted. */
static void carry_out(struct nb_outcome *outcome, double radius) {
  char path[] = "/tmp/nineball-jobs-XXXXXX";
  FILE *file = written_file(path);
  fprintf(file,
          "```scene\nsweep v 1 2 3 4\nmaterial m density 1 kg/m3 kn 1 uN/m\ndisc 0 m 0 m radius %g m m velocity $v m/s "
          "0 m/s\ndisc 90 m 90 m radius 9 m m\nmonitor A disc 1\nstep 1 s\nrecord A.x\nstage one\ncycles 3\n```\n",
          radius);
  fclose(file);
  nb_outcome_make(outcome, path, NULL, &(struct nb_options){.threads = 1, .jobs = 2}, NULL);
  unlink(path);
  if (outcome->mistakes.text)
    printf("# %s", outcome->mistakes.text);
}

/* Runs 1 to 3 fail. The thread of run 1 is delayed until run 2 has failed: the thread of run 0 has then asked for run 2
 * and for another run. */
static void first_failure_is_reported(void) {
  struct nb_outcome outcome;
  delay_run(1, 2);
  carry_out(&outcome, 1.5);
  end_delay();
  CU_ASSERT_EQUAL(outcome.status, NB_BROKEN);
  CU_ASSERT_PTR_NOT_NULL(strstr(outcome.error.text, "it moved by 2 m in one step"));
  CU_ASSERT_PTR_NOT_NULL(strstr(outcome.error.text, "(run v=2)"));
  CU_ASSERT_EQUAL(nb_run_table(&outcome.runs[0])->row_count, 4);
  nb_outcome_free(&outcome);
}

/* Run 0 succeeds. Its thread is delayed until run 1 has failed and the thread of run 1 has asked for another
 * run. */
static void result_before_a_failure(void) {
  struct nb_outcome outcome;
  delay_run(0, 1);
  carry_out(&outcome, 1.5);
  end_delay();
  CU_ASSERT_PTR_NOT_NULL(strstr(outcome.error.text, "(run v=2)"));
  CU_ASSERT_EQUAL(nb_run_table(&outcome.runs[0])->row_count, 4);
  nb_outcome_free(&outcome);
}

void suite_outcome_jobs(void) {
  CU_pSuite suite = CU_add_suite("outcome_jobs", NULL, NULL);
  CU_add_test(suite, "the first failed run is reported", first_failure_is_reported);
  CU_add_test(suite, "a run before a failed run has its result", result_before_a_failure);
}
