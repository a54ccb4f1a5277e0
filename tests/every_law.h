/* Tests that every registered law must pass, with random material pairs.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <CUnit/CUnit.h>

#include "contact.h"

enum { PAIRS = 200 }; /* material pairs for each combination of laws */

/* Calls `test` with PAIRS random material pairs for each combination of laws. The combinations are all normal laws
 * alone, or if `shears`, all normal laws with all shear laws that can follow them. */
static inline void every_law(bool shears, void (*test)(struct contact it, struct chance *chance)) {
  int tried = 0;
  for (const struct nb_law *const *normal = nb_laws(); *normal; normal++) {
    if (!(*normal)->normal)
      continue;
    for (const struct nb_law *const *shear = nb_laws(); *shear; shear++) {
      if (shears ? !(*shear)->shear || ((*shear)->elastic && !(*normal)->elastic) : *shear != *normal)
        continue;
      const unsigned before = CU_get_number_of_failures();
      struct chance chance = chance_begin(1);
      for (int k = 0; k < PAIRS && CU_get_number_of_failures() == before; k++, tried++) /* stops at the first failure */
        test(contact_of(*normal, shears ? *shear : NULL, pair_by(&chance)), &chance);
      if (CU_get_number_of_failures() > before)
        printf("# failed for normal %s%s%s\n", (*normal)->name, shears ? " with shear " : "",
               shears ? (*shear)->name : "");
    }
  }
  CU_ASSERT(tried > 0);
}

/* Define the functions normal_NAME and shear_NAME, which call every_law with the function NAME, for normal laws alone
 * and with shear laws. */
#define OF_NORMAL(test)                                                                                                \
  static void normal_##test(void) { every_law(false, test); }
#define OF_SHEAR(test)                                                                                                 \
  static void shear_##test(void) { every_law(true, test); }
