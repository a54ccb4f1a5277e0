/* There is no global state: models that run alternately, or in threads, give the same bits as each of them alone.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>

#include "suites.h"
#include "written.h"

enum { MODELS = 4, CYCLES = 400 };

/* Scenes with the same statements; `which` changes the numbers in them. */
static void make(struct written *it, int which) {
  struct words page = {0};
  words_add(
      &page,
      "units none\nmaterial rock density %d kn 1e9 ks %de8 friction 0.%d\nshear linear\ndamping mass %d\n"
      "wall south 0 0 to 400 0 rock\nwall north 0 300 to 400 300 rock\nwall west 0 0 to 0 300 rock velocity 0.%d 0\n"
      "wall east 400 0 to 400 300 rock velocity -0.1 0\nlattice discs 4 by 3 radius 50 rock\nstep 0.1 of "
      "single-contact\nmonitor C disc 5 with disc 6\n"
      "monitor A disc 4\nrecord C.normal C.shear A.x A.angle\nstage squeeze\ncycles %d\n",
      1000 + 100 * which, 3 + which, 2 + which, which, 1 + which, CYCLES);
  written_scene(it, &page);
}

static void compare(const struct nb_model *a, const struct nb_model *b) {
  static const char *const names[] = {"C.normal", "C.shear", "A.x", "A.angle"};
  for (int k = 0; k < 4; k++)
    CU_ASSERT(written_now(a, names[k]) == written_now(b, names[k])); /* the same bits */
}

static void models_run_alternately(void) {
  struct written scenes[MODELS];
  struct nb_model *together[MODELS];
  for (int k = 0; k < MODELS; k++) {
    make(&scenes[k], k);
    together[k] = written_model(&scenes[k], NULL);
  }
  for (int cycle = 0; cycle < CYCLES; cycle++)
    for (int k = 0; k < MODELS; k++)
      written_cycles(together[k], 1);
  for (int k = 0; k < MODELS; k++) {
    struct nb_model *alone = written_model(&scenes[k], NULL);
    written_cycles(alone, CYCLES);
    compare(alone, together[k]);
    CU_ASSERT(k == 0 || written_now(alone, "A.x") != written_now(together[0], "A.x")); /* the scenes do differ */
    nb_model_free(alone);
  }
  for (int k = 0; k < MODELS; k++) {
    nb_model_free(together[k]);
    written_free(&scenes[k]);
  }
}

static void runs_in_threads(void) {
  struct written scenes[MODELS];
  struct nb_result alone[MODELS], together[MODELS];
  enum nb_status statuses[MODELS];
  for (int k = 0; k < MODELS; k++) {
    make(&scenes[k], k);
    written_run(&alone[k], &scenes[k], NULL);
  }
#pragma omp parallel for num_threads(MODELS) schedule(static, 1)
  for (int k = 0; k < MODELS; k++) {
    struct nb_error error;
    const struct nb_options options = {.threads = 1};
    statuses[k] = nb_run(&together[k], &scenes[k].scene, &options, NULL, &error);
  }
  for (int k = 0; k < MODELS; k++) {
    CU_ASSERT_EQUAL(statuses[k], NB_OK);
    CU_ASSERT_EQUAL_FATAL(together[k].table.row_count, alone[k].table.row_count);
    for (size_t i = 0; i < alone[k].table.row_count * alone[k].table.column_count; i++)
      CU_ASSERT(alone[k].table.values[i] == together[k].table.values[i]);
    nb_result_free(&alone[k]);
    nb_result_free(&together[k]);
    written_free(&scenes[k]);
  }
}

void suite_many(void) {
  CU_pSuite suite = CU_add_suite("many", NULL, NULL);
  CU_add_test(suite, "models run alternately", models_run_alternately);
  CU_add_test(suite, "runs in threads", runs_in_threads);
}
