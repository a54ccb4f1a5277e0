/* Rows of the table of quantities, for names.c and the files that define quantities of their own.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_NAMES_H
#define NB_NAMES_H

#include "model.h"

/* Families of quantities NAME.SUFFIX computed from the same few numbers: tensors with their invariants, statistics of
 * a sample. */
enum nb_quantity_family {
  NB_SCALAR,     /* one quantity without a suffix */
  NB_COMPONENTS, /* components xx xy yx yy */
  NB_TENSOR,     /* with principal values, deviator, angle; */
  NB_STRESSES,   /* with the mean as well; */
  NB_FABRICS,    /* with the deviator called anisotropy */
  NB_FOURTH,     /* the five components of a symmetric fourth-order tensor */
  NB_STATISTICS, /* mean max min std */
};
enum { NB_COMPONENTS_MAX = 5 }; /* most numbers that a family is computed from */

/* A row of the table: one quantity, or a family. */
struct nb_quantity_kind {
  const char *name;
  /* Set of monitor kinds; 0: the whole scene; or NB_OF_IMPACT, NB_OF_CELL, NB_OF_BOX, NB_OF_CONTACT_TEST. */
  unsigned monitors;
  const char *unit;
  unsigned fields; /* contact fields it reads; in a contact test what it requires of the laws */
  double (*value)(const struct nb_model *model, const struct nb_monitor *monitor);
  const char *help;

  enum nb_quantity_family family; /* of a family, and of a region: value is NULL, and */
  void (*parts)(double parts[], const struct nb_quantity_kind *kind, const struct nb_model *model,
                const struct nb_monitor *monitor);
  int measure; /* of a region: measure/region.h; */
  size_t at;   /* and where in struct nb_region_state it is */
};
#define NB_OF_IMPACT (1u << 31)
#define NB_OF_CELL (1u << 29)         /* of a periodic cell */
#define NB_OF_BOX (1u << 28)          /* of a box of walls */
#define NB_OF_CONTACT_TEST (1u << 30) /* of a contact test */
enum { NB_OF_REGION = 1 << NB_MONITOR_REGION };

/* Fields that stored energies, and the terms of the energy balance, need. */
enum { NB_OF_STORED = NB_BIT(NB_OVERLAP) | NB_BIT(NB_NORMAL) | NB_BIT(NB_STIFFNESS) | NB_BIT(NB_RADIUS) };
#define NB_OF_BALANCE                                                                                                  \
  (NB_OF_STORED | NB_BIT(NB_EX) | NB_BIT(NB_EY) | NB_BIT(NB_TOTAL_NORMAL) | NB_BIT(NB_TANGENTIAL_INCREMENT) |          \
   NB_BIT(NB_SHEAR) | NB_BIT(NB_TOTAL_SHEAR) | NB_BIT(NB_SHEAR_STIFFNESS) | NB_BIT(NB_SLIDING) |                       \
   NB_BIT(NB_DISSIPATED) | NB_BIT(NB_SHEAR_BEFORE) | NB_BIT(NB_SHEAR_STIFFNESS_BEFORE) | NB_REQUEST_ENERGY)

/* Quantities of a contact test (run/contact_test_quantities.c); the last row has no name. */
extern const struct nb_quantity_kind nb_contact_test_kinds[];

/* input/names.c */
/* What to type instead of a name that is no quantity of the scene: the nearest name, or a list. */
const char *nb_quantity_hint(char *hint, const struct nb_scene *scene, const char *text);
bool nb_is_quantity(const char *name);                     /* of any monitor, or of a scene */
bool nb_quantity_is_residual(struct nb_quantity quantity); /* a residual, 0 by definition */
/* The k-th quantity, for the manual; false past the last one. */
struct nb_quantity_row {
  const void *key; /* identifies the quantity */
  char name[NB_NAME_SIZE], help[512];
  const char *unit, *of;          /* the kind of monitor */
  const char *statement, *prefix; /* "region M all", "M."; NULL: the scene's */
};
bool nb_quantity_row(struct nb_quantity_row *row, size_t k);

/* families.c */
struct nb_suffix {
  unsigned families; /* set of families that have it */
  const char *name, *help;
  int part;                                      /* index of the number; or */
  double (*function)(const struct nb_tensor *t); /* function of the tensor */
  const char *unit;                              /* NULL: the family's */
};
const struct nb_suffix *nb_suffix(enum nb_quantity_family family, size_t k);       /* NULL past the last one */
double nb_quantity_now(struct nb_quantity quantity, const struct nb_model *model); /* SI */

/* Defines a function for one quantity, or for one tensor. */
#define NB_QUANTITY(function, expression)                                                                              \
  static double function(const struct nb_model *model, const struct nb_monitor *monitor) {                             \
    (void)model, (void)monitor;                                                                                        \
    return expression;                                                                                                 \
  }
#define NB_TENSOR_QUANTITY(function, expression)                                                                       \
  static void function(double parts[], const struct nb_quantity_kind *kind, const struct nb_model *model,              \
                       const struct nb_monitor *monitor) {                                                             \
    (void)kind, (void)monitor;                                                                                         \
    const struct nb_tensor t = expression;                                                                             \
    parts[0] = t.xx, parts[1] = t.xy, parts[2] = t.yx, parts[3] = t.yy;                                                \
  }

#endif
