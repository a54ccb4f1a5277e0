/* Tests a team with late threads. A late thread has seen that a round begins, and is then delayed until the team ends.
 * The team of this file is that of core/team.c, but its threads sleep after they have read whether the team ends.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "suites.h"

static bool load_late(atomic_bool *object) {
  const bool value = atomic_load_explicit(object, memory_order_seq_cst);
  nanosleep(&(struct timespec){.tv_nsec = 2000000}, NULL);
  return value;
}
static unsigned load_unsigned(atomic_uint *object) { return atomic_load_explicit(object, memory_order_seq_cst); }
static int load_int(atomic_int *object) { return atomic_load_explicit(object, memory_order_seq_cst); }
#undef atomic_load
#define atomic_load(object)                                                                                            \
  _Generic((object), atomic_bool * : load_late, atomic_uint * : load_unsigned, atomic_int * : load_int)(object)
#define nb_team_sized late_team_sized
#define nb_team_free late_team_free
#define nb_team_run late_team_run
#include "../src/core/team.c"

static void work(void *data, int part) { (void)data, (void)part; }

/* The caller does all parts of the round, because the others sleep, and ends the team. The test does this in a child
 * process, which is killed if it waits forever. */
static void a_team_ends_although_its_threads_are_late(void) {
  const pid_t child = fork();
  CU_ASSERT_FATAL(child >= 0);
  if (child == 0) {
    alarm(60);
    for (int k = 0; k < 50; k++) {
      struct nb_team *team = nb_team_sized(NULL, 4);
      nb_team_run(team, 4, work, NULL);
      nb_team_free(team);
    }
    _exit(0);
  }
  int status = 1;
  waitpid(child, &status, 0);
  CU_ASSERT_EQUAL(status, 0);
}

void suite_team_late(void) {
  CU_pSuite suite = CU_add_suite("team_late", NULL, NULL);
  CU_ADD_TEST(suite, a_team_ends_although_its_threads_are_late);
}
