/* Units: any product of powers of base units, with prefixes; and decimal numbers.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/guess.h"

/* Kinds of numbers. A kind has a dimension and a name, and may be an angle. NB_UNIT_NUMBER is dimensionless: a number
 * without a unit, or with % or ppm. */
enum nb_unit_kind {
  NB_UNIT_NUMBER,
  NB_UNIT_LENGTH,
  NB_UNIT_TIME,
  NB_UNIT_VELOCITY,
  NB_UNIT_ACCELERATION,
  NB_UNIT_STIFFNESS,
  NB_UNIT_DENSITY,
  NB_UNIT_FORCE,
  NB_UNIT_RATE,
  NB_UNIT_STRAIN_RATE,
  NB_UNIT_SPIN,
  NB_UNIT_ANGLE,
  NB_UNIT_ENERGY,
  NB_UNIT_MOMENT,
  NB_UNIT_PRESSURE,
  NB_UNIT_KINDS
};

/* Powers of metre, kilogram and second, in sixtieths, because roots of a dimension have fractional powers. */
struct nb_dimension {
  int m, kg, s;
};

struct nb_unit {
  struct nb_dimension dimension;
  int angle;     /* power of rad or deg */
  int shift;     /* power of ten relative to the SI unit: -3 for mm */
  double factor; /* further factor: pi/180 for deg, otherwise 1 */
};

/* A unit of two words, for a strain per cycle, which the program divides by the step. */
#define NB_PER_CYCLE "per cycle"

/* Reads a unit: `mm`, `kg/m3`, `N.m`, `1/s`. False if the name is not a unit. */
bool nb_unit_read(struct nb_unit *unit, const char *name);
/* True if the unit is % or ppm, which `units none` allows. */
bool nb_unit_without_dimension(const char *name);
/* A unit that the program does not have, and its factor to a unit of the program: 1 in is 25.4 mm. */
struct nb_foreign_unit {
  const char *names, *ours; /* "in, inch, inches"; "mm" */
  double factor;
};
/* The foreign unit with this name and, if `dimension` is not NULL, this dimension; NULL: there is none. */
const struct nb_foreign_unit *nb_unit_foreign(const char *name, const struct nb_dimension *dimension);
/* Writes the unit that another spelling means: `m/s2` for `m/s^2` and `m/s²`. False: the text is no such spelling. */
bool nb_unit_respelt(char ours[NB_NAME_SIZE], const char *text);
/* Converts a value with this unit to SI. */
double nb_unit_to_si(double value, const struct nb_unit *unit);
bool nb_dimension_same(struct nb_dimension a, struct nb_dimension b);
/* Writes the SI unit of a dimension: "N/m"; "" if dimensionless. */
void nb_dimension_unit(char *text, size_t size, struct nb_dimension dimension);
/* Writes the name and the unit of a dimension: "a length (m)"; "a number" if dimensionless; only the unit if the
 * dimension has no name. */
void nb_dimension_words(char *text, size_t size, struct nb_dimension dimension);

const char *nb_unit_kind_name(enum nb_unit_kind kind); /* "a length" */
/* Common units of a kind for messages, the SI unit first: "m, mm, um, nm, cm, km". */
const char *nb_unit_list(enum nb_unit_kind kind);
/* Finds the kind with this SI unit: "N" gives NB_UNIT_FORCE, "1" gives NB_UNIT_NUMBER. False: there is none. */
bool nb_unit_kind_of(enum nb_unit_kind *kind, const char *si);
/* Offers all units of a list to a guess. */
void nb_unit_offer(struct nb_guess *guess, const char *list);

enum nb_reading { NB_READ, NB_NO_NUMBER, NB_TOO_LARGE, NB_TOO_SMALL };
/* Sets `value` to the double nearest to the number in `text` times 10^shift. The whole text must be a decimal number,
 * such as `-1.5e3`, not a hexadecimal number, inf or nan, with at most 1024 characters before the exponent. The decimal
 * point is `.` in every locale. */
enum nb_reading nb_number_read(double *value, const char *text, int shift);
/* Sets `value` to a number with its unit, in SI. A computed number is converted to a double first, then multiplied by
 * the unit. */
enum nb_reading nb_quantity_read(double *value, const char *text, bool computed, const struct nb_unit *unit);
/* What a message expects instead of a number that cannot be read: "a number that a double can hold in SI units, up to 1.7e308". */
const char *nb_reading_words(enum nb_reading reading);
/* Length of the decimal number at the beginning of a text, which has no sign; 0: there is none. */
size_t nb_number_length(const char *text);
/* Length of the longest unit at the beginning of a text, if an operator and an operand follow it: 1 for `m/a`; else 0. */
size_t nb_unit_before_operator(const char *text);
