/* Units: any product of powers of base units, with prefixes; and decimal numbers.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_UNITS_H
#define NB_UNITS_H

#include "core/guess.h"

/* A kind of number: its dimension, whether it is an angle, and what it is called. NB_UNIT_NUMBER is dimensionless: bare, or with % or
 * ppm. */
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

/* The powers of metre, kilogram and second in the SI unit of a value, in sixtieths: roots have them too. */
struct nb_dimension {
  int m, kg, s;
};

struct nb_unit {
  struct nb_dimension dimension;
  int angle;     /* power of rad or deg that the name has */
  int shift;     /* its power of ten in the SI unit: -3 for mm */
  double factor; /* and what else it holds of it: pi/180 for deg, otherwise 1 */
};

/* Two words that are one unit: strain of one cycle, divided by the step when it is used. */
#define NB_PER_CYCLE "per cycle"

/* A unit by its name: `mm`, `kg/m3`, `N.m`, `1/s`. False: it is none. */
bool nb_unit_read(struct nb_unit *unit, const char *name);
/* Whether `units none` leaves it: % and ppm. */
bool nb_unit_bare(const char *name);
/* So many of that unit, in SI: value times or over the power of ten, and times the factor. */
double nb_unit_times(double value, const struct nb_unit *unit);
bool nb_dimension_same(struct nb_dimension a, struct nb_dimension b);
/* The SI unit of a dimension, "N/m"; "" for a number. */
void nb_dimension_unit(char *text, size_t size, struct nb_dimension dimension);
/* What a value of it is called, and its unit: "a length (m)". */
void nb_dimension_words(char *text, size_t size, struct nb_dimension dimension);

const char *nb_unit_kind_name(enum nb_unit_kind kind); /* "a length" */
/* Common units of a kind, the SI unit first: "m, mm, um, nm, cm, km"; others of the dimension are read as well. */
const char *nb_unit_list(enum nb_unit_kind kind);
/* The kind whose SI unit is written so: "N" gives NB_UNIT_FORCE, "1" gives NB_UNIT_NUMBER. False: it is the unit of no kind. */
bool nb_unit_kind_of(enum nb_unit_kind *kind, const char *si);
/* Offers the units of a list. */
void nb_unit_offer(struct nb_guess *guess, const char *list);

enum nb_reading { NB_READ, NB_NO_NUMBER, NB_TOO_LARGE, NB_TOO_SMALL };
/* The double nearest to text times 10^shift. The whole text must be a decimal number, such as `-1.5e3`: no hex, no inf,
 * no nan, nothing behind it. The decimal point is a point whatever the program's locale. */
enum nb_reading nb_number_read(double *value, const char *text, int shift);
/* A number with its unit, in SI. What is computed keeps its bits and is multiplied by the unit. */
enum nb_reading nb_quantity_read(double *value, const char *text, bool computed, const struct nb_unit *unit);
/* "a number that a double can hold, up to 1.7e308" */
const char *nb_reach(enum nb_reading reading);
/* How many bytes at the beginning of text are a decimal number without a sign; 0: none. */
size_t nb_number_length(const char *text);

#endif
