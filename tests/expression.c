/* Expressions: values, precedence, dimensions, rounding, and errors.
 *
 * Values must agree to the last bit. Functions are those of the C library, so the tests compare with its results.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../src/input/expression.h"
#include "suites.h"

static const double pi = 3.14159265358979323846;

#define COUNT(list) (sizeof list / sizeof *list)

#define LONGEST "abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyzabcdefghijk" /* 63 letters */

static struct nb_binding names[] = {{.name = LONGEST, .value = 1},
                                    {.name = "a", .value = 3},
                                    {.name = "N", .value = 7},
                                    {.name = "R", .value = 0.5, .dimension = {60, 0, 0}},
                                    {.name = "m", .value = 4, .dimension = {0, 60, 0}},
                                    {.name = "law", .text = "linear", .value = NAN}};

/* The value of the text, or NaN; *given has the messages, which the next call frees. `unitless`: the page has `units
 * none`. */
static struct nb_binding value_of(const char *text, bool unitless, const char **given) {
  static struct nb_mistakes mistakes;
  char path[] = "p", *lines[1];
  unsigned char kinds[] = {1};
  struct nb_page page = {.path = path, .lines = lines, .line_count = 1, .kind_of = kinds};
  struct nb_reader *reader = calloc(1, sizeof *reader);
  struct nb_binding value;
  lines[0] = malloc(strlen(text) + 1);
  CU_ASSERT_FATAL(reader && lines[0]);
  strcpy(lines[0], text);
  nb_mistakes_free(&mistakes);
  reader->page = &page, reader->mistakes = &mistakes, reader->unitless = unitless;
  reader->bindings = names, reader->binding_count = COUNT(names);
  nb_line_begin(reader, 1);
  const bool is = nb_expression(reader, lines[0], lines[0], lines[0] + strlen(text), &value);
  CU_ASSERT_EQUAL(is, mistakes.total == 0);
  if (!is)
    value = (struct nb_binding){.value = NAN};
  *given = mistakes.text ? mistakes.text : "";
  free(lines[0]);
  free(reader);
  return value;
}

static void values(void) {
  const struct {
    const char *text;
    double value;
    int m, kg, s; /* dimension */
  } all[] = {
      /* every pair of operators, in both orders */
      {"2 + 3 * 4", 14, 0, 0, 0},
      {"2 * 3 + 4", 10, 0, 0, 0},
      {"20 - 12 / 4", 17, 0, 0, 0},
      {"12 / 4 - 1", 2, 0, 0, 0},
      {"2 * 3 ^ 2", 18, 0, 0, 0},
      {"2 ^ 3 * 2", 16, 0, 0, 0},
      {"18 / 3 ^ 2", 2, 0, 0, 0},
      {"2 ^ 3 / 4", 2, 0, 0, 0},
      {"1 + 2 ^ 3", 9, 0, 0, 0},
      {"2 ^ 3 - 1", 7, 0, 0, 0},
      {"-2^2", -4, 0, 0, 0},
      {"(-2)^2", 4, 0, 0, 0},
      {"2^-1", 0.5, 0, 0, 0},
      {"-2*3", -6, 0, 0, 0},
      {"2*-3", -6, 0, 0, 0},
      {"2--3", 5, 0, 0, 0},
      {"2 - +3", -1, 0, 0, 0},
      {"--2", 2, 0, 0, 0},
      {"-2 m + 3 m", 1, 60, 0, 0},
      {"(2 m)^2", 4, 120, 0, 0},
      {"(1 m)^99", 1, 5940, 0, 0}, /* the largest powers */
      {"(1 kg)^-99", 1, 0, -5940, 0},
      {"(1 s)^99", 1, 0, 0, 5940},
      {"2 * 3 m", 6, 60, 0, 0},
      {"6 m / 2 s", 3, 60, 0, -60},
      /* from left to right, and powers from right to left */
      {"10 - 4 - 3", 3, 0, 0, 0},
      {"24 / 4 / 2", 3, 0, 0, 0},
      {"24 / 4 * 2", 12, 0, 0, 0},
      {"10 - 4 + 3", 9, 0, 0, 0},
      {"2^3^2", 512, 0, 0, 0},
      {"(2^3)^2", 64, 0, 0, 0},
      {"10 - (4 - 3)", 9, 0, 0, 0},
      /* functions with values in closed form */
      {"sqrt(2)", sqrt(2), 0, 0, 0},
      {"sqrt(9 m2)", 3, 60, 0, 0},
      {"sin(pi/2)", 1, 0, 0, 0},
      {"sin(30 deg)", sin(30 * (pi / 180)), 0, 0, 0},
      {"cos(0)", 1, 0, 0, 0},
      {"tan(0)", 0, 0, 0, 0},
      {"4*atan(1)", pi, 0, 0, 0},
      {"asin(1)*2", pi, 0, 0, 0},
      {"acos(-1)", pi, 0, 0, 0},
      {"atan2(0, -1)", pi, 0, 0, 0},
      {"atan2(1 mm, 1 m / 1000)", pi / 4, 0, 0, 0},
      {"hypot(3, 4)", 5, 0, 0, 0},
      {"hypot(3 m/s, 4 m/s)", 5, 60, 0, -60},
      {"exp(0)", 1, 0, 0, 0},
      {"exp(1)", exp(1), 0, 0, 0},
      {"log(exp(1))", 1, 0, 0, 0},
      {"log(1)", 0, 0, 0, 0},
      {"abs(-2 N)", 2, 60, 60, -120},
      {"min(2, -3)", -3, 0, 0, 0},
      {"max(2 s, 3 s)", 3, 0, 0, 60},
      {"pi", pi, 0, 0, 0},
      /* dimensions */
      {"2 m * 3 s", 6, 60, 0, 60},
      {"1 kg.m/s / 1 s - 1 N", 0, 60, 60, -120},
      {"(8 m3)^(1/3)", 2, 60, 0, 0},
      {"(32 s5)^(1/5)", 2, 0, 0, 60},
      {"sqrt(4 m)", 2, 30, 0, 0},
      {"sqrt(4 m)*sqrt(9 m)", 6, 60, 0, 0},
      {"1 N/m / 1 Pa", 1, 60, 0, 0},
      {"8 m/(2*2 s)", 2, 60, 0, -60},
      {"(8) m/s/ 2", 4, 60, 0, -60},
      {"1 rad/s * 1 s", 1, 0, 0, 0},
      {"90 deg", 1.5707963267948966, 0, 0, 0},
      {"50 %", 0.5, 0, 0, 0},
      {"(1 + 1) ppm", 2e-6, 0, 0, 0},
      /* units and names: a word after a number is a unit, after an operator a name */
      {"2 N", 2, 60, 60, -120},
      {"2*N", 14, 0, 0, 0},
      {"2 m", 2, 60, 0, 0},
      {"2*m", 8, 0, 60, 0},
      {"2 m*m", 8, 60, 60, 0},
      {"2 / m", 0.5, 0, -60, 0},
      {"2/m", 0.5, 0, -60, 0},
      {"6 N/m", 6, 0, 60, -120},
      {"(a) mm", 0.003, 60, 0, 0},
      {"(1+a) N", 4, 60, 60, -120},
      {"5 1/s", 5, 0, 0, -60},
      {"(2*a) 1/s", 6, 0, 0, -60},
      {"a^2 + R^2/1 m2", 9.25, 0, 0, 0},
      /* rounding: once for a literal and its unit; then one operation after the other */
      {"0.3 mm", 0.0003, 60, 0, 0},
      {"(0.3 mm)", 0.0003, 60, 0, 0},
      {"(0.1 + 0.2) mm", (0.1 + 0.2) / 1000, 60, 0, 0},
      {"0.1 + 0.2", 0.1 + 0.2, 0, 0, 0},
      {"1/3", 1.0 / 3, 0, 0, 0},
      {"0.1*3 - 0.3", 0.1 * 3 - 0.3, 0, 0, 0}, /* 0 if the product were not rounded */
      {"1e16 + 1 - 1e16", 0, 0, 0, 0},
      {"30 \u00B5m", 30e-6, 60, 0, 0},
      {" \t2 ", 2, 0, 0, 0},
  };
  for (size_t k = 0; k < COUNT(all); k++) {
    const char *given;
    const struct nb_binding it = value_of(all[k].text, false, &given);
    const bool right = it.value == all[k].value &&
                       nb_dimension_same(it.dimension, (struct nb_dimension){all[k].m, all[k].kg, all[k].s});
    if (!right)
      printf("# %s is %.17g, wanted %.17g %s\n", all[k].text, it.value, all[k].value, given);
    CU_ASSERT(right);
    if (!it.computed)
      continue;
    char number[NB_NAME_SIZE]; /* the text reads back to the same bits */
    double back = NAN;
    snprintf(number, sizeof number, "%.*s", (int)strcspn(it.text, " "), it.text);
    CU_ASSERT(nb_number_read(&back, number, 0) == NB_READ && back == it.value);
  }
}

static void texts(void) { /* a literal is kept as it is written; a computed value is in SI units */
  static const struct {
    const char *text, *written;
    bool computed;
  } all[] = {{"0.30 mm", "0.30 mm", false},
             {"-5", "-5", false},
             {" 17  deg ", "17 deg", false},
             {"+2 %", "+2 %", false},
             {"(0.30 mm)", "0.0003 m", true},
             {"2*a", "6", true},
             {"17 deg*1", "0.29670597283903605", true},
             {"2 N*3 m", "6 J", true},
             {"R/2 s", "0.25 m/s", true},
             {"- 5", "-5", true},
             {"1/3", "0.3333333333333333", true}}; /* with as few digits as the same bits need */
  for (size_t k = 0; k < COUNT(all); k++) {
    const char *given;
    const struct nb_binding it = value_of(all[k].text, false, &given);
    CU_ASSERT_STRING_EQUAL(it.text, all[k].written);
    CU_ASSERT_EQUAL(it.computed, all[k].computed);
  }
}

static void mistakes(void) { /* the column, from 1, and the message */
  static const struct {
    const char *text, *given;
    bool unitless;
  } all[] = {
      {"1 m + 1 s",
       "p:1:5: error: expected the same dimension on both sides of `+`, found a length (m) on the left and a time (s) "
       "on the right",
       false},
      {"1 N - 2",
       "p:1:5: error: expected the same dimension on both sides of `-`, found a force (N) on the left and a number on "
       "the right",
       false},
      {"2 ^ (1 m)", "p:1:3: error: expected a number as an exponent, found a length (m)", false},
      {"(2 m)^0.3333",
       "p:1:6: error: expected powers of units that are simple fractions, such as 1/2, up to 99, found the power "
       "0.3333",
       false},
      {"(2 m)^100",
       "p:1:6: error: expected powers of units that are simple fractions, such as 1/2, up to 99, found the power 100",
       false},
      {"(2 kg)^-100", "up to 99, found the power -100", false},
      {"(2 s)^100", "up to 99, found the power 100", false},
      {"sin(1 m)", "p:1:1: error: expected a number within `sin()`, found a length (m)", false},
      {"exp(1 s)", "expected a number within `exp()`", false},
      {"log(R)", "expected a number within `log()`", false},
      {"hypot(1 m, 1)",
       "p:1:1: error: expected two values of the same dimension in `hypot()`, found a length (m) and a number", false},
      {"atan2(1, 1 s)", "expected two values of the same dimension in `atan2()`", false},
      {"min(1, 1 s)", "expected two values of the same dimension in `min()`", false},
      {"1/0", "p:1:2: error: expected a finite value, found that `/` gives infinity", false},
      {"0/0", "p:1:2: error: expected a finite value, found that `/` gives NaN", false},
      {"sqrt(-1)", "p:1:1: error: expected a finite value, found that `sqrt` gives NaN", false},
      {"log(0)", "found that `log` gives infinity", false},
      {"asin(2)", "found that `asin` gives NaN", false},
      {"1e308 + 1e308", "p:1:7: error: expected a finite value, found that `+` gives infinity", false},
      {"1e308*10", "found that `*` gives infinity", false},
      {"10^309", "found that `^` gives infinity", false},
      {"(-8)^0.5", "found that `^` gives NaN", false},
      {"1e400", "p:1:1: error: expected a number that a double can hold in SI units, up to 1.7e308, found `1e400`",
       false},
      {"1 + 1e-400",
       "p:1:5: error: expected a number that a double can hold in SI units, from 4.9e-324, found `1e-400`", false},
      {"1e308 1/deg",
       "p:1:1: error: expected a number that a double can hold in SI units, up to 1.7e308, found `1e308`", false},
      {"1 + 5e-324 deg", "p:1:5: error: expected a number that a double can hold in SI units, from 4.9e-324", false},
      /* a name or unit that is too long is refused; its beginning is not used */
      {LONGEST "l + 1", "p:1:1: error: expected a name of at most 63 characters, found `" LONGEST "…`", false},
      {"2 m/m.m/m.m/m.m/m.m/m.m/m.m/m.m/m.m/m.m/m.m/m.m/m.m/m.m/m.m/m.m/m.mm", "p:1:3: error: expected a unit", false},
      {"(2) m/m.m/m.m/m.m/m.m/m.m/m.m/m.m/m.m/m.m/m.m/m.m/m.m/m.m/m.m/m.m/m.mm", "p:1:5: error: expected a unit",
       false},
      {"", "expected a number, a name or `(`, found the end of the expression", false},
      {"2 +", "p:1:4: error: expected a number, a name or `(`, found the end of the expression", false},
      {"(2 + 3", "p:1:7: error: expected an operator or `)`, found the end of the expression", false},
      {"2 + 3)", "p:1:6: error: expected an operator, found `)`", false},
      {"2 3", "p:1:3: error: expected an operator, found `3`", false},
      {"2 a", "p:1:3: error: expected a unit or an operator, found `a`", false},
      {"2a", "p:1:2: error: expected a unit or an operator, found `a`", false},
      {"2mm", "hint: put a space between the number and the unit `mm`", false},
      {"2 N/a", "hint: a unit is one word, such as `kg/m3`; to divide put spaces around `/`: `N / a`", false},
      {"2 N.a", "hint: a unit is one word, such as `kg/m3`; to divide put spaces around `/`", false},
      {"2 N/s/m/2", "to divide put spaces around `/`: `N/s/m / 2`", false},
      {"2 m/ / 3", "expected a number, a name or `(`, found `/`", false},
      {"a mm", "p:1:3: error: expected an operator, found `mm`", false},
      {"2 mm mm", "p:1:6: error: expected an operator, found `mm`", false},
      {"a b", "p:1:3: error: expected an operator, found `b`", false},
      {"2 ** 3", "p:1:4: error: expected a number, a name or `(`, found `*`\n      1 | 2 ** 3\n", false},
      {"b + 1", "p:1:1: error: expected a name that a `let` or `sweep` above defines, found `b`", false},
      {"mm", "hint: a unit follows a number", false},
      {"law", "p:1:1: error: expected the name of a number, found `law`, which stands for `linear`", false},
      {"$a + 1", "hint: inside an expression a name has no `$`: `a`; outside it is `$a`", false},
      {"foo(2)", "p:1:1: error: expected the name of a function, found `foo`", false},
      {"sin 2", "p:1:5: error: expected `(`, found `2`", false},
      {"sin(2", "expected an operator or `)`, found the end", false},
      {"hypot(2)", "p:1:8: error: expected `,` and a second value, found `)`", false},
      {"sin(2, 3)", "p:1:6: error: expected an operator or `)`, found `,`", false},
      {"1,5 + 2", "hint: the decimal point is `.`", false},
      {"1.2.3", "p:1:4: error: expected an operator, found `.3`", false},
      {"2 \u2212 1", "hint: this is not the minus sign", false},
      {"2 \u00D7 3", "hint: multiply with `*`", false},
      {"2 N", "p:1:3: error: expected a unit or an operator, found `N`", true},
      {"2 N", "hint: the scene has `units none`, so `N` is not a unit", true},
      {"30 deg", "hint: the scene has `units none`", true},
      {"(2*a) mm", "expected a unit or an operator, found `mm`", true},
  };
  const char *given;
  for (size_t k = 0; k < COUNT(all); k++) {
    const double value = value_of(all[k].text, all[k].unitless, &given).value;
    const char *wanted = strstr(all[k].text, "**") ? "expected a number, a name or `(`, found `*`" : all[k].given;
    if (!isnan(value) || !strstr(given, wanted))
      printf("# %s: %g, said %s", all[k].text, value, given);
    CU_ASSERT(isnan(value) && strstr(given, wanted));
  }
  CU_ASSERT_EQUAL(value_of("50 % + 1 ppm", true, &given).value, 0.5 + 1e-6);
  CU_ASSERT_EQUAL(value_of("2*N", true, &given).value, 14);
}

/* Nested parentheses, signs, powers and functions: a hundred levels, and more. */
static void deep(void) {
  static const struct {
    const char *open, *close;
  } kinds[] = {{"(", ")"}, {"-", ""}, {"2^", ""}, {"abs(", ")"}, {"max(1,", ")"}};
  for (size_t k = 0; k < COUNT(kinds); k++)
    for (int count = 98; count < 4000 / (int)strlen(kinds[k].open); count += count == 98 ? 4 : 700) {
      char text[9000] = "";
      const char *given;
      size_t used = 0;
      for (int i = 0; i < count; i++)
        used += (size_t)snprintf(text + used, sizeof text - used, "%s", kinds[k].open);
      used += (size_t)snprintf(text + used, sizeof text - used, "1");
      for (int i = 0; i < count; i++)
        used += (size_t)snprintf(text + used, sizeof text - used, "%s", kinds[k].close);
      const double value = value_of(text, false, &given).value;
      if (count == 98 && strcmp(kinds[k].open, "2^") != 0)
        CU_ASSERT_EQUAL(value, 1);
      if (count > 98)
        CU_ASSERT(strstr(given, "expected at most 100 levels of parentheses and signs") != NULL);
    }
  char text[NB_LINE_MAX] = "1", long_name[300] = "";
  const char *given;
  for (size_t used = 1; used + 3 < sizeof text; used += 2)
    strcpy(text + used, "+1");
  CU_ASSERT_EQUAL(value_of(text, false, &given).value, (double)(strlen(text) + 1) / 2);
  memset(text, '1', sizeof text - 1);
  CU_ASSERT(isnan(value_of(text, false, &given).value) && strstr(given, "expected a number"));
  memset(long_name, 'n', sizeof long_name - 1);
  CU_ASSERT(isnan(value_of(long_name, false, &given).value) && strstr(given, "expected a name"));
  value_of("", false, &given); /* frees the messages */
}

static void reserved(void) {
  CU_ASSERT(nb_name_reserved("pi") && nb_name_reserved("atan2") && nb_name_reserved("max"));
  CU_ASSERT_FALSE(nb_name_reserved("N") || nb_name_reserved("e") || nb_name_reserved("PI"));
  char list[256] = "";
  snprintf(list, sizeof list, "%s", nb_function_names);
  int count = 0; /* every function in the list of the manual is reserved */
  for (char *name = strtok(list, ", "); name; name = strtok(NULL, ", "), count++)
    CU_ASSERT(nb_name_reserved(name));
  CU_ASSERT_EQUAL(count, 14);
}

void suite_expression(void) {
  CU_pSuite suite = CU_add_suite("expression", NULL, NULL);
  CU_add_test(suite, "values and dimensions", values);
  CU_add_test(suite, "how a value is written", texts);
  CU_add_test(suite, "columns and messages of mistakes", mistakes);
  CU_add_test(suite, "nesting of a hundred levels, and more", deep);
  CU_add_test(suite, "reserved names", reserved);
}
