/* Units: each is the power of ten that its name says, and exact.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../src/input/units.h"
#include "suites.h"

#define COUNT(list) (sizeof list / sizeof *list)

/* The power of ten that the parts of a unit's name say, of kg, m and s: `N/mm` is 3. */
static int power_said(const char *name) {
  static const struct {
    char letter;
    int power;
  } prefixes[] = {{'n', -9}, {'u', -6}, {'m', -3}, {'c', -2}, {'k', 3}, {'M', 6}, {'G', 9}};
  static const char *const bases[] = {"m", "s", "g", "N", "Pa", "J"};
  int power = 0;
  for (int sign = 1; *name; name += *name != 0, sign = -1) {
    const size_t length = strcspn(name, "/23");
    for (size_t k = 0; k < COUNT(bases); k++)
      for (size_t p = 0; p <= COUNT(prefixes); p++) {
        char part[8];
        snprintf(part, sizeof part, "%.*s%s", p < COUNT(prefixes), &prefixes[p % COUNT(prefixes)].letter, bases[k]);
        if (strlen(part) != length || strncmp(part, name, length) != 0)
          continue;
        const int times = name[length] == '2' ? 2 : name[length] == '3' ? 3 : 1;
        power += sign * times * ((p < COUNT(prefixes) ? prefixes[p].power : 0) - (bases[k][0] == 'g' ? 3 : 0));
      }
    name += strcspn(name, "/");
  }
  return power;
}

static void units(void) {
  static const struct {
    const char *number, *unit;
    double si;
  } all[] = {{"0.3", "mm", 0.0003}, {"3.3", "N/mm", 3300}, {"2.7", "g/cm3", 2700},
             {"0.1", "%", 0.001},   {"10", "ppm", 1e-5},   {"180", "deg", 3.14159265358979323846}};
  for (size_t i = 0; i < COUNT(all); i++) {
    const struct nb_unit *unit = nb_unit_find(all[i].unit);
    double value = NAN;
    CU_ASSERT_PTR_NOT_NULL_FATAL(unit);
    CU_ASSERT_EQUAL(nb_number_read(&value, all[i].number, unit->shift), NB_READ);
    CU_ASSERT_EQUAL(value * unit->factor, all[i].si); /* to the last bit */
  }
  for (const struct nb_unit *unit = nb_units(); unit->name; unit++)
    if (!strpbrk(unit->name, "%p"))
      CU_ASSERT(unit->shift == power_said(unit->name) && (unit->factor == 1 || strcmp(unit->name, "deg") == 0));
  enum nb_unit_kind kind = NB_UNIT_LENGTH;
  CU_ASSERT(nb_unit_kind_of(&kind, "1") && kind == NB_UNIT_NUMBER);
  CU_ASSERT(nb_unit_kind_of(&kind, "N") && kind == NB_UNIT_FORCE);
  CU_ASSERT_FALSE(nb_unit_kind_of(&kind, "kN")); /* is no SI unit */
  CU_ASSERT_PTR_NULL(nb_unit_find("1"));         /* is a number */
}

void suite_units(void) {
  CU_pSuite suite = CU_add_suite("units", NULL, NULL);
  CU_add_test(suite, "exact powers of ten", units);
}
