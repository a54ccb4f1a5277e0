/* The pages of tests/variants: scenes without symmetry, each with its reference. Radii, materials and speeds are
 * unequal, motion goes in both directions, and walls are not along the axes. The simulator and the reference compute
 * the values independently. The tolerances follow from the errors that the references state.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <glob.h>

#include "report/outcome.h"
#include "suites.h"

static void every_variant_agrees_with_its_reference(void) {
  glob_t pages;
  CU_ASSERT_EQUAL_FATAL(glob(NB_SRCDIR "/tests/variants/*.md", 0, NULL, &pages), 0);
  CU_ASSERT(pages.gl_pathc > 30);
  for (size_t p = 0; p < pages.gl_pathc; p++) {
    struct nb_outcome outcome;
    nb_outcome_make(&outcome, pages.gl_pathv[p], NULL, NULL, NULL);
    for (size_t k = 0; k < outcome.check_count; k++)
      if (outcome.checks[k].mark != NB_PASS)
        printf("# %s: %s: %s\n", pages.gl_pathv[p], outcome.checks[k].label, outcome.checks[k].message);
    if (outcome.status > NB_FAILED)
      printf("# %s: %s%s\n", pages.gl_pathv[p], outcome.error.text, outcome.mistakes.text ? outcome.mistakes.text : "");
    CU_ASSERT_EQUAL(outcome.status, NB_OK);
    CU_ASSERT(outcome.check_count > 0);
    nb_outcome_free(&outcome);
  }
  globfree(&pages);
}

void suite_refs_variants(void) {
  CU_pSuite suite = CU_add_suite("refs_variants", NULL, NULL);
  CU_ADD_TEST(suite, every_variant_agrees_with_its_reference);
}
