/* Runs the CUnit suites and reports in TAP: one line per test, `ok 3 - suite: test`, after the lines `# file:line:
 * condition` of its failed assertions. After a test that crashes there are fewer lines than planned, which is a failure
 * too.
 *
 * Arguments select suites: `tests/unit motion damping`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "suites.h"

#include <CUnit/CUnit.h>
#include <CUnit/TestRun.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void suite_cannot_start(const CU_pSuite suite) {
  printf("not ok - %s: the suite cannot be set up\n", suite->pName);
}

static void test_done(const CU_pTest test, const CU_pSuite suite, const CU_pFailureRecord failures) {
  for (const CU_FailureRecord *failure = failures; failure; failure = failure->pNext)
    printf("# %s:%u: %s\n", failure->strFileName, failure->uiLineNumber, failure->strCondition);
  printf("%s %u - %s: %s\n", failures ? "not ok" : "ok", CU_get_number_of_tests_run(), suite->pName, test->pName);
}

/* Selects all suites, or those that are named; returns their number of tests. A name that no suite has ends the program. */
static unsigned choose(int count, char *names[]) {
  unsigned tests = 0;
  for (int k = 0; k < count; k++)
    if (!CU_get_suite(names[k])) {
      printf("Bail out! there is no suite %s\n", names[k]);
      exit(1);
    }
  CU_set_fail_on_inactive(CU_FALSE);
  for (CU_pSuite suite = CU_get_registry()->pSuite; suite; suite = suite->pNext) {
    CU_BOOL wanted = count == 0;
    for (int k = 0; k < count; k++)
      wanted = wanted || strcmp(suite->pName, names[k]) == 0;
    CU_set_suite_active(suite, wanted);
    tests += wanted ? suite->uiNumberOfTests : 0;
  }
  return tests;
}

int main(int argc, char *argv[]) {
  setvbuf(stdout, NULL, _IOLBF, 0); /* output before a crash is not lost */
  if (CU_initialize_registry() != CUE_SUCCESS) {
    printf("Bail out! %s\n", CU_get_error_msg());
    return 1;
  }
#define NB_SUITE(name) suite_##name();
#include "suites-register.h"
#undef NB_SUITE
  if (CU_get_error() != CUE_SUCCESS) {
    printf("Bail out! a suite could not be registered: %s\n", CU_get_error_msg());
    return 1;
  }
  printf("1..%u\n", choose(argc - 1, argv + 1));
  CU_set_suite_init_failure_handler(suite_cannot_start);
  CU_set_test_complete_handler(test_done);
  CU_run_all_tests();
  const unsigned failed = CU_get_number_of_tests_failed() + CU_get_number_of_suites_failed();
  CU_cleanup_registry();
  return failed ? 1 : 0;
}
