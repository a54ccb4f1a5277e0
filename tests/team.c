/* The team of threads: each part of a round is done once, and a thread takes over parts of another thread. If the team
 * has lost time, its threads rest, and the caller does all parts for a while.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>

#include "../src/core/clock.h"
#include "../src/core/team.h"
#include "suites.h"

enum { PARTS = 24 };
static const double patience = 60; /* s, after which a test gives up: the machine may run many other programs */

struct round {
  atomic_int times[PARTS]; /* how often each part was done */
  bool by_caller[PARTS];   /* whether the caller has done it */
  atomic_int done;         /* number of parts that are done */
  atomic_int by_members;   /* number of those that other threads than the caller have done */
  pthread_t caller;
  int awaited;   /* part 0 waits until this number of parts is done */
  double member; /* duration of a part that a member does, s */
};

static void spend(double seconds) {
  for (const double begin = nb_clock(); nb_clock() - begin < seconds;)
    ;
}

static void work(void *data, int part) {
  struct round *round = data;
  round->by_caller[part] = pthread_equal(pthread_self(), round->caller);
  atomic_fetch_add(&round->times[part], 1);
  for (const double begin = nb_clock();
       part == 0 && atomic_load(&round->done) < round->awaited && nb_clock() - begin < patience;)
    ;
  if (!round->by_caller[part]) {
    atomic_fetch_add(&round->by_members, 1);
    spend(round->member);
  }
  atomic_fetch_add(&round->done, 1);
}

static void run(struct nb_team *team, int parts, struct round *round) {
  round->caller = pthread_self();
  nb_team_run(team, parts, work, round);
}

static void each_part_is_done_once(void) {
  for (int threads = 1; threads <= 5; threads++) {
    struct nb_team *team = nb_team_sized(NULL, threads);
    CU_ASSERT_PTR_NOT_NULL_FATAL(team);
    CU_ASSERT_PTR_EQUAL(nb_team_sized(team, threads), team);
    for (int k = 0; k < 2000; k++) {
      struct round round = {.done = 0};
      const int parts = 1 + k % PARTS;
      run(team, parts, &round);
      int once = 0;
      for (int part = 0; part < PARTS; part++)
        once += atomic_load(&round.times[part]) == (part < parts);
      CU_ASSERT_EQUAL(once, PARTS);
      CU_ASSERT_EQUAL(atomic_load(&round.done), parts);
    }
    nb_team_free(team);
  }
  struct round round = {.done = 0};
  run(NULL, PARTS, &round);
  CU_ASSERT_EQUAL(atomic_load(&round.done), PARTS);
}

/* Part 0 waits until all other parts are done. So the thread without part 0 must do all of them, even those that are
 * not its own. */
static void a_thread_takes_over_parts(void) {
  struct nb_team *team = nb_team_sized(NULL, 2);
  CU_ASSERT_PTR_NOT_NULL_FATAL(team);
  struct round round = {.awaited = PARTS - 1};
  const double begin = nb_clock();
  run(team, PARTS, &round);
  CU_ASSERT(nb_clock() - begin < patience);
  CU_ASSERT_EQUAL(atomic_load(&round.done), PARTS);
  nb_team_free(team);
}

/* Repeats rounds until both the caller and the other thread have done parts of one round. Returns the number of parts
 * that the other thread did, or 0 after `patience` seconds. `member` is the time that the other thread spends on a
 * part, s. */
static int shared_round(struct nb_team *team, double member) {
  for (const double begin = nb_clock(); nb_clock() - begin < patience;) {
    struct round round = {.member = member};
    run(team, PARTS, &round);
    const int by_members = atomic_load(&round.by_members);
    if (by_members > 0 && by_members < PARTS)
      return by_members;
  }
  return 0;
}

/* A member spends 50 ms on a part, and the caller almost nothing. This loses time, so for the next second the caller
 * does all parts. Then the member works again. */
static void the_team_rests(void) {
  struct nb_team *team = nb_team_sized(NULL, 2);
  CU_ASSERT_PTR_NOT_NULL_FATAL(team);
  CU_ASSERT(shared_round(team, 0.05) > 0);
  const double begin = nb_clock();
  struct round round = {.done = 0};
  run(team, PARTS, &round);
  CU_ASSERT(atomic_load(&round.by_members) == 0 ||
            nb_clock() - begin > 0.9); /* late: other programs have stopped this thread for most of the 1 s */
  CU_ASSERT(shared_round(team, 0) > 0);
  const double rest = nb_clock() - begin;
  CU_ASSERT(rest > 0.5); /* 1 s minus the time from the end of the shared round to `begin` */
  nb_team_free(team);
}

void suite_team(void) {
  CU_pSuite suite = CU_add_suite("team", NULL, NULL);
  CU_add_test(suite, "each part is done once", each_part_is_done_once);
  CU_add_test(suite, "a thread takes over parts of another", a_thread_takes_over_parts);
  CU_add_test(suite, "the team rests after it has lost time", the_team_rests);
}
