/* Rows of the table of quantities: what names.c and the files with rows of their own share.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_NAMES_H
#define NB_NAMES_H

#include "model.h"

struct nb_quantity_kind {
  const char *name;
  unsigned
      watches; /* set of watch kinds it belongs to; 0: the whole scene; NB_OF_IMPACT: one with an impact; NB_OF_CELL, NB_OF_BOX, or NB_OF_BENCH */
  const char *unit;
  unsigned fields; /* contact fields it reads, to be kept; on the bench what it asks of the laws */
  double (*value)(const struct nb_model *model, const struct nb_watch *watch);
  const char *help;
};
#define NB_OF_IMPACT (1u << 31)
#define NB_OF_CELL (1u << 29)  /* of a periodic cell */
#define NB_OF_BOX (1u << 28)   /* of a box of walls */
#define NB_OF_BENCH (1u << 30) /* of a path's contact */
enum { NB_OF_REGION = 1 << NB_WATCH_REGION };

/* What energies in springs, and the terms of the energy balance, are made of. */
enum { NB_OF_STORED = NB_BIT(NB_OVERLAP) | NB_BIT(NB_NORMAL) | NB_BIT(NB_STIFFNESS) | NB_BIT(NB_RADIUS) };
#define NB_OF_BALANCE                                                                                                  \
  (NB_OF_STORED | NB_BIT(NB_EX) | NB_BIT(NB_EY) | NB_BIT(NB_PUSH) | NB_BIT(NB_SLIP) | NB_BIT(NB_SHEAR) |               \
   NB_BIT(NB_DRAG) | NB_BIT(NB_SHEAR_STIFFNESS) | NB_BIT(NB_SLIDING) | NB_BIT(NB_LOST) | NB_BIT(NB_SHEAR_BEFORE) |     \
   NB_BIT(NB_SHEAR_STIFFNESS_BEFORE) | NB_ASKS_ENERGY)

/* Of the contact on the bench, which works out their values (run/bench_quantities.c); the last one has no name. */
extern const struct nb_quantity_kind nb_bench_kinds[];

static inline double nb_quantity_now(struct nb_quantity quantity, const struct nb_model *model) {
  return quantity.kind->value(model, quantity.watch < 0 ? NULL : &model->scene->watches[quantity.watch]);
}

/* Rows of quantities: a function for each, and the rows of a tensor, which all tensors have alike. */
#define NB_QUANTITY(function, expression)                                                                              \
  static double function(const struct nb_model *model, const struct nb_watch *watch) {                                 \
    (void)model, (void)watch;                                                                                          \
    return expression;                                                                                                 \
  }
#define NB_TENSOR_QUANTITIES(stem, expression)                                                                         \
  NB_QUANTITY(stem##_xx, (expression).xx)                                                                              \
  NB_QUANTITY(stem##_xy, (expression).xy)                                                                              \
  NB_QUANTITY(stem##_yx, (expression).yx)                                                                              \
  NB_QUANTITY(stem##_yy, (expression).yy)                                                                              \
  NB_QUANTITY(stem##_major, tensor_major(expression))                                                                  \
  NB_QUANTITY(stem##_minor, tensor_minor(expression))                                                                  \
  NB_QUANTITY(stem##_deviator, 2 * tensor_radius(expression))                                                          \
  NB_QUANTITY(stem##_angle, tensor_angle(expression))
#define NB_TENSOR_ROWS(name, of, unit, fields, stem, deviator, what)                                                   \
  {name ".xx", of, unit, fields, stem##_xx, what ", component"},                                                       \
      {name ".xy", of, unit, fields, stem##_xy, what ", component"},                                                   \
      {name ".yx", of, unit, fields, stem##_yx, what ", component"},                                                   \
      {name ".yy", of, unit, fields, stem##_yy, what ", component"},                                                   \
      {name ".major", of, unit, fields, stem##_major, what ", major principal value [R89 4.52]"},                      \
      {name ".minor", of, unit, fields, stem##_minor, what ", minor principal value [R89 4.53]"},                      \
      {name "." deviator, of, unit, fields, stem##_deviator, what ", major less minor principal value"}, {             \
    name ".angle", of, "rad", fields, stem##_angle, what ", from x to the major principal axis [R89 4.54]"             \
  }

#endif
