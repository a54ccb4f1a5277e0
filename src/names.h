/* Rows of the table of quantities: what names.c and the files with rows of their own share.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_NAMES_H
#define NB_NAMES_H

#include "model.h"

struct nb_quantity_kind {
  const char *name;
  unsigned watches; /* set of watch kinds it belongs to; 0: the whole scene; NB_OF_IMPACT: one with an impact */
  const char *unit;
  unsigned fields; /* contact fields it reads, to be kept */
  double (*value)(const struct nb_model *model, const struct nb_watch *watch);
  const char *help;
};
#define NB_OF_IMPACT (1u << 31)

extern const struct nb_quantity_kind nb_impact_kinds[]; /* impact.c; the last row has no name */

#endif
