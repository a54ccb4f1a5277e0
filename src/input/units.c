/* The closed table of units, and numbers.
 *
 * All units but the degree are powers of ten of the SI unit, so the power is put into the number's own exponent before
 * it is turned into a double: `0.3 mm` is the double nearest to 0.0003, as if the page had said so, and not 0.3 *
 * 0.001.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef _POSIX_C_SOURCE
#define _POSIX_C_SOURCE 200809L /* newlocale, uselocale */
#endif
#include "units.h"
#include "core/vec.h"

#include <ctype.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The first of each kind is the SI unit itself. */
/* clang-format off */
static const struct nb_unit table[] = {
  {NB_UNIT_NUMBER, "1", 0, 1},       {NB_UNIT_NUMBER, "%", -2, 1},      {NB_UNIT_NUMBER, "ppm", -6, 1},
  {NB_UNIT_LENGTH, "m", 0, 1},       {NB_UNIT_LENGTH, "mm", -3, 1},     {NB_UNIT_LENGTH, "um", -6, 1},
  {NB_UNIT_LENGTH, "nm", -9, 1},     {NB_UNIT_LENGTH, "cm", -2, 1},     {NB_UNIT_LENGTH, "km", 3, 1},
  {NB_UNIT_TIME, "s", 0, 1},         {NB_UNIT_TIME, "ms", -3, 1},       {NB_UNIT_TIME, "us", -6, 1},
  {NB_UNIT_TIME, "ns", -9, 1},
  {NB_UNIT_VELOCITY, "m/s", 0, 1},   {NB_UNIT_VELOCITY, "mm/s", -3, 1}, {NB_UNIT_VELOCITY, "cm/s", -2, 1},
  {NB_UNIT_VELOCITY, "um/s", -6, 1},
  {NB_UNIT_ACCELERATION, "m/s2", 0, 1}, {NB_UNIT_ACCELERATION, "mm/s2", -3, 1},
  {NB_UNIT_STIFFNESS, "N/m", 0, 1},  {NB_UNIT_STIFFNESS, "kN/m", 3, 1}, {NB_UNIT_STIFFNESS, "MN/m", 6, 1},
  {NB_UNIT_STIFFNESS, "GN/m", 9, 1}, {NB_UNIT_STIFFNESS, "N/mm", 3, 1},
  {NB_UNIT_DENSITY, "kg/m3", 0, 1},  {NB_UNIT_DENSITY, "g/cm3", 3, 1},  {NB_UNIT_DENSITY, "Mg/m3", 3, 1},
  {NB_UNIT_FORCE, "N", 0, 1},        {NB_UNIT_FORCE, "kN", 3, 1},       {NB_UNIT_FORCE, "MN", 6, 1},
  {NB_UNIT_FORCE, "mN", -3, 1},      {NB_UNIT_FORCE, "uN", -6, 1},
  {NB_UNIT_RATE, "1/s", 0, 1},       {NB_UNIT_RATE, "1/ms", 3, 1},
  {NB_UNIT_STRAIN_RATE, "1/s", 0, 1}, {NB_UNIT_STRAIN_RATE, "1/ms", 3, 1}, {NB_UNIT_STRAIN_RATE, NB_PER_CYCLE, 0, 1},
  {NB_UNIT_SPIN, "rad/s", 0, 1},
  {NB_UNIT_ANGLE, "rad", 0, 1},      {NB_UNIT_ANGLE, "deg", 0, NB_PI / 180},
  {NB_UNIT_ENERGY, "J", 0, 1},       {NB_UNIT_ENERGY, "mJ", -3, 1},     {NB_UNIT_ENERGY, "uJ", -6, 1},
  {NB_UNIT_ENERGY, "nJ", -9, 1},
  {NB_UNIT_MOMENT, "N.m", 0, 1},
  {NB_UNIT_PRESSURE, "Pa", 0, 1},    {NB_UNIT_PRESSURE, "kPa", 3, 1},   {NB_UNIT_PRESSURE, "MPa", 6, 1},
  {NB_UNIT_PRESSURE, "GPa", 9, 1},
  {NB_UNIT_NUMBER, NULL, 0, 0},
};
/* clang-format on */

const struct nb_unit *nb_units(void) { return table; }

/* "1" is how a table heads a dimensionless column; on a page it would be a number. */
const struct nb_unit *nb_unit_find(const char *name) {
  for (const struct nb_unit *unit = table + 1; unit->name; unit++)
    if (strcmp(unit->name, name) == 0)
      return unit;
  return NULL;
}

const struct nb_unit *nb_unit_of(const char *name, enum nb_unit_kind kind) {
  for (const struct nb_unit *unit = table + 1; unit->name; unit++)
    if (unit->kind == kind && strcmp(unit->name, name) == 0)
      return unit;
  return nb_unit_find(name);
}

const char *nb_unit_kind_name(enum nb_unit_kind kind) {
  static const char *const names[NB_UNIT_KINDS] = {
      [NB_UNIT_NUMBER] = "a number",
      [NB_UNIT_LENGTH] = "a length",
      [NB_UNIT_TIME] = "a time",
      [NB_UNIT_VELOCITY] = "a velocity",
      [NB_UNIT_STIFFNESS] = "a stiffness",
      [NB_UNIT_DENSITY] = "a density",
      [NB_UNIT_FORCE] = "a force",
      [NB_UNIT_RATE] = "a rate",
      [NB_UNIT_STRAIN_RATE] = "a strain rate",
      [NB_UNIT_SPIN] = "a spin",
      [NB_UNIT_ANGLE] = "an angle",
      [NB_UNIT_ENERGY] = "an energy",
      [NB_UNIT_MOMENT] = "a moment",
      [NB_UNIT_PRESSURE] = "a pressure",
      [NB_UNIT_ACCELERATION] = "an acceleration",
  };
  return names[kind];
}

void nb_unit_list(char *list, size_t size, enum nb_unit_kind kind) {
  size_t used = 0;
  list[0] = '\0';
  for (const struct nb_unit *unit = table + 1; unit->name; unit++) {
    if (unit->kind != kind || used >= size)
      continue;
    int n = snprintf(list + used, size - used, "%s%s", used ? ", " : "", unit->name);
    if (n > 0)
      used += (size_t)n;
  }
}

bool nb_unit_kind_of(enum nb_unit_kind *kind, const char *si) {
  for (const struct nb_unit *unit = table; unit->name; unit++) {
    bool first = unit == table || unit->kind != (unit - 1)->kind;
    if (!first || strcmp(unit->name, si) != 0)
      continue;
    *kind = unit->kind;
    return true;
  }
  return false;
}

/* [+-] digits [. digits] [e [+-] digits], at least one digit before the exponent. Says where the exponent begins, and
 * whether any digit before it is other than 0. */
static bool is_decimal(const char *text, size_t *mantissa, bool *nonzero) {
  const char *c = text;
  size_t digits = 0;
  *nonzero = false;
  if (*c == '+' || *c == '-')
    c++;
  for (; isdigit((unsigned char)*c) || *c == '.'; c++) {
    if (*c == '.' && strchr(c + 1, '.'))
      return false;
    if (*c != '.')
      digits++;
    if (*c != '.' && *c != '0')
      *nonzero = true;
  }
  *mantissa = (size_t)(c - text);
  if (digits == 0)
    return false;
  if (*c == '\0')
    return true;
  if (*c != 'e' && *c != 'E')
    return false;
  c++;
  if (*c == '+' || *c == '-')
    c++;
  if (!isdigit((unsigned char)*c))
    return false;
  while (isdigit((unsigned char)*c))
    c++;
  return *c == '\0';
}

enum nb_reading nb_number_read(double *value, const char *text, int shift) {
  enum { LONGEST = 1024 };
  char shifted[LONGEST + 32];
  size_t mantissa;
  bool nonzero;
  if (!is_decimal(text, &mantissa, &nonzero) || mantissa > LONGEST)
    return NB_NO_NUMBER;
  long exponent = text[mantissa] ? strtol(text + mantissa + 1, NULL, 10) : 0;
  if (exponent > 100000)
    exponent = 100000; /* far out of reach of a double, far from overflow of a long */
  if (exponent < -100000)
    exponent = -100000;
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
