/* Units: each unit has exactly the power of ten and the dimension that its name says.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../src/core/guess.h"
#include "../src/input/units.h"
#include "chance.h"
#include "suites.h"

#define COUNT(list) (sizeof list / sizeof *list)

static void units(void) {
  static const struct {
    const char *number, *unit;
    double si;
    int m, kg, s, angle;
  } all[] = {{"0.3", "mm", 0.0003, 1, 0, 0, 0},
             {"3.3", "N/mm", 3300, 0, 1, -2, 0},
             {"2.7", "g/cm3", 2700, -3, 1, 0, 0},
             {"0.1", "%", 0.001, 0, 0, 0, 0},
             {"10", "ppm", 1e-5, 0, 0, 0, 0},
             {"180", "deg", 3.14159265358979323846, 0, 0, 0, 1},
             {"7", "rad/s", 7, 0, 0, -1, 1},
             {"7", "1/s", 7, 0, 0, -1, 0},
             {"7", "1/ms2", 7e6, 0, 0, -2, 0},
             {"0.0000000000000000000000000000000000000000", "m", 0, 1, 0, 0, 0}, /* 0 is not too small */
             {"30", "um", 30e-6, 1, 0, 0, 0},
             {"30", "\u00B5m", 30e-6, 1, 0, 0, 0}, /* the sign micro */
             {"30", "\u03BCm", 30e-6, 1, 0, 0, 0}, /* the letter mu */
             {"4", "N.m", 4, 2, 1, -2, 0},
             {"4", "kg.m/s", 4, 1, 1, -1, 0},
             {"4", "kg/m/s2", 4, -1, 1, -2, 0},
             {"4", "kg/m.s2", 4, -1, 1, 2, 0}, /* from left to right */
             {"4", "MPa", 4e6, -1, 1, -2, 0},
             {"4", "nJ", 4e-9, 2, 1, -2, 0},
             {"4", "cm", 0.04, 1, 0, 0, 0},
             {"4", "km", 4000, 1, 0, 0, 0},
             {"4", "GPa", 4e9, -1, 1, -2, 0},
             {"4", "mrad", 0.004, 0, 0, 0, 1},
             {"4", "Mg/m3", 4000, -3, 1, 0, 0},
             {"4", "m9", 4, 9, 0, 0, 0}};
  static const char *const none[] = {"",     "1",     "m/", "/s",  "m//s", "kg.", "mdeg", "k%",    "M",
                                     "kppm", "mmm",   "m0", "m10", "2/s",  "N m", "m^2",  "1.s",   "mn/m",
                                     "N-m",  "meter", "pm", "1/",  "µ",    ".m",  "rad/", "m\xC2", "gm/s"};
  struct nb_unit unit;
  for (size_t i = 0; i < COUNT(all); i++) {
    double value = NAN;
    CU_ASSERT_FATAL(nb_unit_read(&unit, all[i].unit));
    CU_ASSERT_EQUAL(nb_number_read(&value, all[i].number, unit.shift), NB_READ);
    CU_ASSERT_EQUAL(value * unit.factor, all[i].si); /* to the last bit */
    CU_ASSERT(nb_dimension_same(unit.dimension, (struct nb_dimension){60 * all[i].m, 60 * all[i].kg, 60 * all[i].s}));
    CU_ASSERT_EQUAL(unit.angle, all[i].angle);
  }
  for (size_t i = 0; i < COUNT(none); i++)
    CU_ASSERT_FALSE(nb_unit_read(&unit, none[i]));
}

static void kinds(void) { /* every unit that a message lists exists, and has the dimension of the first one */
  enum nb_unit_kind kind = NB_UNIT_LENGTH;
  for (int k = 1; k < NB_UNIT_KINDS; k++) {
    struct nb_unit first = {0}, unit;
    char list[256], words[128];
    snprintf(list, sizeof list, "%s", nb_unit_list((enum nb_unit_kind)k));
    CU_ASSERT_EQUAL(strlen(list), strlen(nb_unit_list((enum nb_unit_kind)k)));
    for (char *name = strtok(list, ","); name; name = strtok(NULL, ",")) {
      name += strspn(name, " ");
      if (strcmp(name, NB_PER_CYCLE) == 0)
        continue;
      CU_ASSERT(nb_unit_read(&unit, name));
      if (name == list)
        first = unit;
      CU_ASSERT(nb_dimension_same(first.dimension, unit.dimension) && first.angle == unit.angle);
    }
    CU_ASSERT(first.shift == 0 && first.factor == 1);
    nb_dimension_unit(words, sizeof words, first.dimension); /* the text of the unit can be read again */
    CU_ASSERT(k == NB_UNIT_ANGLE ? !*words
                                 : nb_unit_read(&unit, words) && nb_dimension_same(unit.dimension, first.dimension));
  }
  CU_ASSERT(nb_unit_kind_of(&kind, "1") && kind == NB_UNIT_NUMBER);
  CU_ASSERT(nb_unit_kind_of(&kind, "N") && kind == NB_UNIT_FORCE);
  CU_ASSERT_FALSE(nb_unit_kind_of(&kind, "kN")); /* not an SI unit */
}

static void written(void) {
  static const struct {
    int m, kg, s;
    const char *unit, *words;
  } all[] = {{60, 0, 0, "m", "a length (m)"},
             {0, 0, 0, "", "a number"},
             {0, 0, -60, "1/s", "a rate (1/s)"},
             {120, 60, -120, "J", "an energy (J)"},
             {60, 60, -60, "kg.m/s", "kg.m/s"},
             {-60, 60, -60, "kg/m/s", "kg/m/s"},
             {-120, 0, 0, "1/m2", "1/m2"},
             {30, 0, 0, "m^0.5", "m^0.5"},
             {-30, 60, -120, "kg/m^0.5/s2", "kg/m^0.5/s2"}};
  for (size_t i = 0; i < COUNT(all); i++) {
    char text[128];
    const struct nb_dimension dimension = {all[i].m, all[i].kg, all[i].s};
    nb_dimension_unit(text, sizeof text, dimension);
    CU_ASSERT_STRING_EQUAL(text, all[i].unit);
    *text = '\0';
    nb_dimension_words(text, sizeof text, dimension);
    CU_ASSERT_STRING_EQUAL(text, all[i].words);
  }
}

/* The length of the number at the beginning of a text, and that of the unit before the last operator of a word. */
static void lengths(void) {
  static const struct {
    const char *text;
    size_t length;
  } numbers[] = {{"12", 2},    {"1.5m", 3}, {".5", 2},  {"1.", 2},   {"1e5", 3},   {"1E+5x", 4},
                 {"1.e-5", 5}, {"1e", 1},   {"1e+", 1}, {".5e-", 2}, {"1.5.2", 3}, {"1f5", 1},
                 {"", 0},      {".", 0},    {".e5", 0}, {"-1", 0},   {"e5", 0},    {" 1", 0}},
    operators[] = {{"m/2", 1},    {"m*2", 1}, {"m+2", 1}, {"m-2", 1}, {"m^2", 1}, {"kg/m3/2", 5}, {"N/m/(2/3)", 3},
                   {"mm+m-2", 2}, {"m/", 0},  {"x/2", 0}, {"/2", 0},  {"m2", 0},  {"m(s/2)", 0},  {"m,2", 0}};
  for (size_t i = 0; i < COUNT(numbers); i++)
    CU_ASSERT_EQUAL(nb_number_length(numbers[i].text), numbers[i].length);
  for (size_t i = 0; i < COUNT(operators); i++)
    CU_ASSERT_EQUAL(nb_unit_before_operator(operators[i].text), operators[i].length);
}

/* Units of other systems, from their definitions: the inch, the foot, the pound (kg), the standard acceleration and
 * the standard atmosphere are exact by international agreement. The unit `lb` means the force of a pound. */
#define INCH 0.0254
#define FOOT (12 * INCH)
#define GRAVITY 9.80665
#define POUND 0.45359237
static void foreign(void) {
  static const struct {
    const char *names;
    double si;
    int m, kg, s;
  } all[] = {{"in, inch, inches", INCH, 1, 0, 0},
             {"ft, foot, feet", FOOT, 1, 0, 0},
             {"lb, lbs, lbf", POUND * GRAVITY, 1, 1, -2},
             {"kgf", GRAVITY, 1, 1, -2},
             {"lb/in", POUND * GRAVITY / INCH, 0, 1, -2},
             {"lb/ft", POUND * GRAVITY / FOOT, 0, 1, -2},
             {"psi", POUND * GRAVITY / (INCH * INCH), -1, 1, -2},
             {"ksi", 1000 * POUND * GRAVITY / (INCH * INCH), -1, 1, -2},
             {"psf", POUND * GRAVITY / (FOOT * FOOT), -1, 1, -2},
             {"bar", 1e5, -1, 1, -2},
             {"atm", 101325, -1, 1, -2},
             {"pcf, lb/ft3", POUND / (FOOT * FOOT * FOOT), -3, 1, 0},
             {"ft/s", FOOT, 1, 0, -1},
             {"in/s", INCH, 1, 0, -1},
             {"km/h, kph", 1000.0 / 3600, 1, 0, -1},
             {"mph", 5280 * FOOT / 3600, 1, 0, -1},
             {"ft/s2", FOOT, 1, 0, -2},
             {"min", 60, 0, 0, 1},
             {"sec, second, seconds", 1, 0, 0, 1},
             {"msec", 1e-3, 0, 0, 1},
             {"usec", 1e-6, 0, 0, 1},
             {"rpm", 2 * 3.14159265358979323846 / 60, 0, 0, -1}};
  for (size_t i = 0; i < COUNT(all); i++) {
    const struct nb_dimension dimension = {60 * all[i].m, 60 * all[i].kg, 60 * all[i].s};
    char name[64];
    for (const char *list = all[i].names; nb_item(&list, name);) {
      const struct nb_foreign_unit *const row = nb_unit_foreign(name, &dimension);
      struct nb_unit ours;
      CU_ASSERT_PTR_NOT_NULL_FATAL(row);
      CU_ASSERT_PTR_EQUAL(nb_unit_foreign(name, NULL), row);
      CU_ASSERT_FATAL(nb_unit_read(&ours, row->ours));
      CU_ASSERT_DOUBLE_EQUAL(nb_unit_to_si(row->factor, &ours) / all[i].si, 1, 1e-13);
      CU_ASSERT(nb_dimension_same(ours.dimension, dimension));
      for (int k = 0; k < 3; k++) { /* a number of another dimension gets no advice */
        struct nb_dimension other = dimension;
        *(k == 0 ? &other.m : k == 1 ? &other.kg : &other.s) += 60;
        CU_ASSERT_PTR_NULL(nb_unit_foreign(name, &other));
      }
    }
  }
  CU_ASSERT_PTR_NULL(nb_unit_foreign("furlong", NULL));
  CU_ASSERT_PTR_NULL(nb_unit_foreign("inc", NULL));
}

/* Numbers of 1 to 17 digits, with a point anywhere and exponents around the largest power of ten that a double holds
 * exactly: they are read with the same bits as by strtod. */
static void short_numbers(void) {
  enum { NUMBERS = 200000 };
  struct chance chance = chance_begin(3);
  int compared = 0;
  for (int k = 0; k < NUMBERS; k++) {
    char digits[32], text[64], shifted[64];
    const int length = snprintf(digits, sizeof digits, "%.0f", floor(chance_scale(&chance, 1, 1e17)));
    const int whole = (int)chance_between(&chance, 0, length + 1), exponent = (int)chance_between(&chance, -26, 26),
              shift = (int)chance_between(&chance, -6, 7);
    const char *const sign = k % 3 ? "" : "-";
    double value;
    snprintf(text, sizeof text, "%s%.*s.%se%d", sign, whole, digits, digits + whole, exponent);
    snprintf(shifted, sizeof shifted, "%s%.*s.%se%d", sign, whole, digits, digits + whole, exponent + shift);
    if (nb_number_read(&value, text, shift) != NB_READ)
      continue;
    const double wanted = strtod(shifted, NULL);
    compared += memcmp(&value, &wanted, sizeof value) == 0;
  }
  CU_ASSERT_EQUAL(compared, NUMBERS);
}

/* Numbers beyond a double, also with an exponent beyond a long, to which the power of ten of the unit is added. */
static void too_large_or_too_small(void) {
  static const struct {
    const char *number;
    int shift;
    enum nb_reading reading;
  } all[] = {{"1e200000", 3, NB_TOO_LARGE},
             {"-1e99999999999999999999", 3, NB_TOO_LARGE},
             {"1e-200000", -3, NB_TOO_SMALL},
             {"1e-99999999999999999999", -3, NB_TOO_SMALL},
             {"0e99999999999999999999", 3, NB_READ},
             {"1e306", 3, NB_TOO_LARGE},
             {"1e309", -3, NB_READ}};
  for (size_t i = 0; i < COUNT(all); i++) {
    double value;
    CU_ASSERT_EQUAL(nb_number_read(&value, all[i].number, all[i].shift), all[i].reading);
  }
}

void suite_units(void) {
  CU_pSuite suite = CU_add_suite("units", NULL, NULL);
  CU_add_test(suite, "powers of ten and dimensions of units, and words that are no units", units);
  CU_add_test(suite, "short numbers have the bits of strtod", short_numbers);
  CU_add_test(suite, "numbers that are too large or too small", too_large_or_too_small);
  CU_add_test(suite, "the units in messages exist, and have one dimension", kinds);
  CU_add_test(suite, "dimensions in words", written);
  CU_add_test(suite, "lengths of numbers, and of units before an operator", lengths);
  CU_add_test(suite, "units of other systems", foreign);
}
