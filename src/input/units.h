/* The closed table of units: which a page may write, and which kind of number each belongs to.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_UNITS_H
#define NB_UNITS_H

#include <stdbool.h>
#include <stddef.h>

/* NB_UNIT_NUMBER is dimensionless: bare, or with % or ppm. */
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

struct nb_unit {
  enum nb_unit_kind kind;
  const char *name; /* as a page writes it: "mm" */
  int shift;        /* its power of ten in the SI unit: -3 */
  double factor;    /* and what else it holds of it: pi/180 for deg, otherwise 1 */
};

const struct nb_unit *nb_units(void); /* the table; ends in a row without a name */
/* Two words that are one unit: strain of one cycle, divided by the step when it is used. The table has it as 1/s. */
#define NB_PER_CYCLE "per cycle"

const struct nb_unit *nb_unit_find(const char *name); /* NULL: no such unit */
const struct nb_unit *nb_unit_of(const char *name,
                                 enum nb_unit_kind kind);           /* of that kind if there is one, or another */
const char *nb_unit_kind_name(enum nb_unit_kind kind);              /* "a length" */
void nb_unit_list(char *list, size_t size, enum nb_unit_kind kind); /* "m, mm, um, nm, cm, km" */
/* The kind whose SI unit is written so: "N" gives NB_UNIT_FORCE, "1" gives NB_UNIT_NUMBER. False: a unit that is not in
 * the table. */
bool nb_unit_kind_of(enum nb_unit_kind *kind, const char *si);

enum nb_reading { NB_READ, NB_NO_NUMBER, NB_TOO_LARGE, NB_TOO_SMALL };
/* The double nearest to text times 10^shift. The whole text must be a decimal number, such as `-1.5e3`: no hex, no inf,
 * no nan, nothing behind it. The decimal point is a point whatever the program's locale. */
enum nb_reading nb_number_read(double *value, const char *text, int shift);

#endif
