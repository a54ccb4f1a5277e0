/* Units: any product of powers of base units, with prefixes; and decimal numbers.
 *
 *   unit     factor or `1/` factor, then `.` factor (times) or `/` factor (over), from left to right: `kg.m/s`, `1/s`
 *   factor   {prefix} base unit {power from 1 to 9}
 *
 * All units except the degree are powers of ten of the SI unit. This power is added to the exponent of the decimal
 * number before the number is converted, so `0.3 mm` is the double nearest to 0.0003, not 0.3 * 0.001.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "units.h"
#include "core/clean.h"
#include "core/vec.h"

#include <ctype.h>
#include <float.h>
#include <locale.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- names ---- */

enum { SIXTIETHS = 60 }; /* number of sixtieths in a power of 1: see struct nb_dimension */

static const struct {
  const char *name;
  int m, kg, s, angle, shift;
  double factor;
  bool prefixed; /* may have a prefix */
} bases[] = {{"m", 1, 0, 0, 0, 0, 1, true},    {"s", 0, 0, 1, 0, 0, 1, true},
             {"g", 0, 1, 0, 0, -3, 1, true},   {"N", 1, 1, -2, 0, 0, 1, true},
             {"Pa", -1, 1, -2, 0, 0, 1, true}, {"J", 2, 1, -2, 0, 0, 1, true},
             {"rad", 0, 0, 0, 1, 0, 1, true},  {"deg", 0, 0, 0, 1, 0, NB_PI / 180, false},
             {"%", 0, 0, 0, 0, -2, 1, false},  {"ppm", 0, 0, 0, 0, -6, 1, false}};
static const struct {
  const char *name;
  int shift;
} prefixes[] = {{"", 0},   {"n", -9}, {"u", -6}, {"\xC2\xB5", -6}, {"\xCE\xBC", -6},
                {"m", -3}, {"c", -2}, {"k", 3},  {"M", 6},         {"G", 9}};

/* Multiplies *unit by the factor in `length` bytes of `text`, to the power `sign`, 1 or -1. False if the text is not a
 * factor. */
static bool multiply(struct nb_unit *unit, const char *text, size_t length, int sign) {
  const int power = length > 1 && isdigit((unsigned char)text[length - 1]) ? text[--length] - '0' : 1,
            times = sign * power;
  for (size_t p = 0; p < sizeof prefixes / sizeof *prefixes && power; p++)
    for (size_t b = 0; b < sizeof bases / sizeof *bases; b++) {
      const size_t before = strlen(prefixes[p].name);
      if (before + strlen(bases[b].name) != length || strncmp(text, prefixes[p].name, before) != 0 ||
          strncmp(text + before, bases[b].name, length - before) != 0 || (before && !bases[b].prefixed))
        continue;
      unit->dimension.m += SIXTIETHS * times * bases[b].m;
      unit->dimension.kg += SIXTIETHS * times * bases[b].kg;
      unit->dimension.s += SIXTIETHS * times * bases[b].s;
      unit->angle += times * bases[b].angle;
      unit->shift += times * (prefixes[p].shift + bases[b].shift);
      for (int k = 0; k < power; k++)
        unit->factor = sign > 0 ? unit->factor * bases[b].factor : unit->factor / bases[b].factor;
      return true;
    }
  return false;
}

bool nb_unit_read(struct nb_unit *unit, const char *name) {
  *unit = (struct nb_unit){.factor = 1};
  if (strlen(name) >= NB_NAME_SIZE)
    return false;
  const char *at = strncmp(name, "1/", 2) == 0 ? name + 1 : name;
  for (int sign = 1; at == name || *at;) {
    if (at > name && (*at == '.' || *at == '/'))
      sign = *at++ == '/' ? -1 : 1;
    const size_t length = strcspn(at, "./");
    if (!multiply(unit, at, length, sign))
      return false;
    at += length;
  }
  return true;
}

bool nb_unit_without_dimension(const char *name) { return strcmp(name, "%") == 0 || strcmp(name, "ppm") == 0; }

double nb_unit_to_si(double value, const struct nb_unit *unit) {
  double ten = 1; /* exact up to 10^22 */
  for (int k = abs(unit->shift); k > 0; k--)
    ten *= 10;
  return (unit->shift < 0 ? value / ten : value * ten) * unit->factor;
}

/* ---- dimensions and kinds ---- */

/* Kinds of numbers. The first of several kinds with the same dimension gives the dimension its name. */
static const struct {
  const char *name, *units;
} kinds[NB_UNIT_KINDS] = {
    [NB_UNIT_NUMBER] = {"a number", "1, %, ppm"},
    [NB_UNIT_LENGTH] = {"a length", "m, mm, um, nm, cm, km"},
    [NB_UNIT_TIME] = {"a time", "s, ms, us, ns"},
    [NB_UNIT_VELOCITY] = {"a velocity", "m/s, mm/s, cm/s, um/s"},
    [NB_UNIT_STIFFNESS] = {"a stiffness", "N/m, kN/m, MN/m, GN/m, N/mm"},
    [NB_UNIT_DENSITY] = {"a density", "kg/m3, g/cm3, Mg/m3"},
    [NB_UNIT_FORCE] = {"a force", "N, kN, MN, mN, uN"},
    [NB_UNIT_RATE] = {"a rate", "1/s, 1/ms"},
    [NB_UNIT_STRAIN_RATE] = {"a strain rate", "1/s, 1/ms, " NB_PER_CYCLE},
    [NB_UNIT_SPIN] = {"a spin", "rad/s, deg/s"},
    [NB_UNIT_ANGLE] = {"an angle", "rad, deg"},
    [NB_UNIT_ENERGY] = {"an energy", "J, mJ, uJ, nJ"},
    [NB_UNIT_MOMENT] = {"a moment", "N.m"},
    [NB_UNIT_PRESSURE] = {"a pressure", "Pa, kPa, MPa, GPa"},
    [NB_UNIT_ACCELERATION] = {"an acceleration", "m/s2, mm/s2"},
};

bool nb_dimension_same(struct nb_dimension a, struct nb_dimension b) {
  return a.m == b.m && a.kg == b.kg && a.s == b.s;
}

const struct nb_foreign_unit *nb_unit_foreign(const char *name, const struct nb_dimension *dimension) {
  static const struct nb_foreign_unit rows[] = {
      {"in, inch, inches", "mm", 25.4},
      {"ft, foot, feet", "m", 0.3048},
      {"lb, lbs, lbf", "N", 4.4482216152605},
      {"kgf", "N", 9.80665},
      {"lb/in", "N/m", 175.126835246477},
      {"lb/ft", "N/m", 14.5939029372064},
      {"psi", "kPa", 6.89475729316836},
      {"ksi", "MPa", 6.89475729316836},
      {"psf", "Pa", 47.8802589803358},
      {"bar", "kPa", 100},
      {"atm", "kPa", 101.325},
      {"pcf, lb/ft3", "kg/m3", 16.0184633739601},
      {"ft/s", "m/s", 0.3048},
      {"in/s", "mm/s", 25.4},
      {"km/h, kph", "m/s", 1 / 3.6},
      {"mph", "m/s", 0.44704},
      {"ft/s2", "m/s2", 0.3048},
      {"min", "s", 60},
      {"sec, second, seconds", "s", 1},
      {"msec", "ms", 1},
      {"usec", "us", 1},
      {"rpm", "rad/s", NB_PI / 30},
  };
  struct nb_unit unit;
  char item[NB_NAME_SIZE];
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    for (const char *list = rows[k].names; nb_item(&list, item);)
      if (strcmp(item, name) == 0 && nb_unit_read(&unit, rows[k].ours) &&
          (!dimension || nb_dimension_same(unit.dimension, *dimension)))
        return &rows[k];
  return NULL;
}

bool nb_unit_respelt(char ours[NB_NAME_SIZE], const char *text) {
  static const struct {
    const char *theirs, *ours;
  } powers[] = {{"^", ""}, {"\u00B2", "2"}, {"\u00B3", "3"}, {NULL, NULL}};
  struct nb_unit unit;
  bool other = false;
  ours[0] = '\0';
  while (*text) {
    size_t k = 0;
    while (powers[k].theirs && strncmp(text, powers[k].theirs, strlen(powers[k].theirs)) != 0)
      k++;
    if (powers[k].theirs)
      nb_append(ours, NB_NAME_SIZE, "%s", powers[k].ours), text += strlen(powers[k].theirs), other = true;
    else
      nb_append(ours, NB_NAME_SIZE, "%c", *text++);
  }
  return other && nb_unit_read(&unit, ours);
}

/* The kind of a dimension; -1: none. */
static int kind_of(struct nb_dimension dimension) {
  for (int kind = 0; kind < NB_UNIT_KINDS; kind++) {
    char si[NB_NAME_SIZE];
    struct nb_unit unit = {.factor = 1};
    snprintf(si, sizeof si, "%.*s", (int)strcspn(kinds[kind].units, ","), kinds[kind].units);
    if ((kind == NB_UNIT_NUMBER || nb_unit_read(&unit, si)) && nb_dimension_same(unit.dimension, dimension))
      return kind;
  }
  return -1;
}

void nb_dimension_unit(char *text, size_t size, struct nb_dimension dimension) {
  const int kind = kind_of(dimension), powers[] = {dimension.kg, dimension.m, dimension.s};
  static const char *const names[] = {"kg", "m", "s"};
  text[0] = '\0';
  if (kind > 0)
    snprintf(text, size, "%.*s", (int)strcspn(kinds[kind].units, ","), kinds[kind].units);
  for (int pass = 0; pass < 2 && kind < 0; pass++) /* positive powers, then negative ones */
    for (int k = 0; k < 3; k++) {
      const double power = (pass ? -1.0 : 1.0) * powers[k] / SIXTIETHS;
      if (power <= 0)
        continue;
      nb_append(text, size, "%s%s", pass ? (*text ? "/" : "1/") : *text ? "." : "", names[k]);
      if (power != 1)
        nb_append(text, size, power == floor(power) ? "%g" : "^%g", power);
    }
}

void nb_dimension_words(char *text, size_t size, struct nb_dimension dimension) {
  char unit[NB_NAME_SIZE];
  const int kind = kind_of(dimension);
  nb_dimension_unit(unit, sizeof unit, dimension);
  if (kind == NB_UNIT_NUMBER)
    snprintf(text, size, "a number");
  else if (kind > 0)
    snprintf(text, size, "%s (%s)", kinds[kind].name, unit);
  else
    snprintf(text, size, "%s", unit);
}

const char *nb_unit_kind_name(enum nb_unit_kind kind) { return kinds[kind].name; }

const char *nb_unit_list(enum nb_unit_kind kind) { return kinds[kind].units; }

bool nb_unit_kind_of(enum nb_unit_kind *kind, const char *si) {
  for (*kind = 0; *kind < NB_UNIT_KINDS; ++*kind)
    if (strcspn(kinds[*kind].units, ",") == strlen(si) && strncmp(kinds[*kind].units, si, strlen(si)) == 0)
      return true;
  return false;
}

void nb_unit_offer(struct nb_guess *guess, const char *list) {
  char name[NB_NAME_SIZE];
  while (nb_item(&list, name))
    if (strcmp(name, "1") != 0) /* the unit `1` is only in heads of tables */
      nb_guess_offer(guess, name);
}

/* ---- numbers ---- */

const char *nb_reading_words(enum nb_reading reading) {
  return reading == NB_TOO_LARGE   ? "a number that a double can hold in SI units, up to 1.7e308"
         : reading == NB_TOO_SMALL ? "a number that a double can hold in SI units, from 4.9e-324"
                                   : "a number";
}

size_t nb_unit_before_operator(const char *text) {
  char unit[NB_NAME_SIZE];
  struct nb_unit read;
  for (size_t k = strcspn(text, "("); k-- > 1;)
    if (strchr("*/+-^", text[k]) && text[k + 1] && snprintf(unit, sizeof unit, "%.*s", (int)k, text) == (int)k &&
        nb_unit_read(&read, unit))
      return k;
  return 0;
}

size_t nb_number_length(const char *text) {
  static const char digits[] = "0123456789";
  size_t whole = strspn(text, digits), part = text[whole] == '.' ? 1 + strspn(text + whole + 1, digits) : 0;
  const size_t mantissa = whole + part;
  if (whole == 0 && part < 2)
    return 0;
  if (text[mantissa] != 'e' && text[mantissa] != 'E')
    return mantissa;
  const size_t sign = text[mantissa + 1] == '+' || text[mantissa + 1] == '-';
  const size_t exponent = strspn(text + mantissa + 1 + sign, digits);
  return exponent ? mantissa + 1 + sign + exponent : mantissa;
}

/* Reads a decimal number with up to 15 significant digits: an integer below 1e15 times or over a power of ten up to
 * 1e22. Doubles hold both exactly, and a product or quotient is rounded once, so the value is that of strtod. False: the
 * number is not of this kind. `mantissa`: the characters before the exponent. */
static bool short_number(double *value, const char *text, size_t mantissa, long exponent) {
  static const double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                  1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  enum { MOST = sizeof powers / sizeof *powers - 1, DIGITS = 15 };
  const size_t sign = *text == '+' || *text == '-';
  long decimals = 0;
  int digits = 0;
  uint64_t whole = 0;
  bool point = false;
  for (size_t k = sign; k < mantissa && digits <= DIGITS; k++) {
    point = point || text[k] == '.';
    if (text[k] == '.')
      continue;
    whole = 10 * whole + (uint64_t)(text[k] - '0');
    digits += whole > 0, decimals += point;
  }
  exponent -= decimals;
  if (FLT_EVAL_METHOD != 0 || digits > DIGITS || exponent > MOST || exponent < -MOST)
    return false;
  const double size = exponent < 0 ? (double)whole / powers[-exponent] : (double)whole * powers[exponent];
  *value = *text == '-' ? -size : size;
  return true;
}

enum nb_reading nb_number_read(double *value, const char *text, int shift) {
  enum { LONGEST = 1024 };
  char shifted[LONGEST + 32];
  const size_t sign = *text == '+' || *text == '-', length = nb_number_length(text + sign);
  const size_t mantissa = sign + strspn(text + sign, "0123456789.");
  if (length == 0 || text[sign + length] || mantissa > LONGEST)
    return NB_NO_NUMBER;
  const bool nonzero = strcspn(text, "123456789") < mantissa;
  long exponent = text[mantissa] ? strtol(text + mantissa + 1, NULL, 10) : 0;
  if (exponent > 100000)
    exponent = 100000; /* beyond any double, but no overflow of a long */
  if (exponent < -100000)
    exponent = -100000;
  if (short_number(value, text, mantissa, exponent + shift))
    return NB_READ;
  snprintf(shifted, sizeof shifted, "%.*se%ld", (int)mantissa, text, exponent + shift);

  locale_t plain = newlocale(LC_NUMERIC_MASK, "C", (locale_t)0);
  if (!plain)
    return NB_NO_NUMBER;
  locale_t before = uselocale(plain);
  *value = strtod(shifted, NULL);
  uselocale(before);
  freelocale(plain);

  if (!isfinite(*value))
    return NB_TOO_LARGE;
  return *value == 0 && nonzero ? NB_TOO_SMALL : NB_READ;
}

enum nb_reading nb_quantity_read(double *value, const char *text, bool computed, const struct nb_unit *unit) {
  const enum nb_reading reading = nb_number_read(value, text, computed ? 0 : unit->shift);
  if (reading != NB_READ)
    return reading;
  const double number = *value;
  *value = computed ? nb_unit_to_si(number, unit) : number * unit->factor;
  return !isfinite(*value) ? NB_TOO_LARGE : *value == 0 && number != 0 ? NB_TOO_SMALL : NB_READ;
}
