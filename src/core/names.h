/* The rows of the table of quantities. names.c and the files that define quantities include this file.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "model.h"

/* Families of quantities NAME.SUFFIX. The quantities of a family are computed from the same few numbers: a tensor with
 * its invariants, or the statistics of a sample. */
enum nb_quantity_family {
  NB_SCALAR,     /* one quantity without a suffix */
  NB_COMPONENTS, /* the suffixes xx xy yx yy */
  NB_TENSOR,     /* also major, minor, deviator, angle */
  NB_STRESSES,   /* as NB_TENSOR, and mean */
  NB_FABRICS,    /* as NB_TENSOR, with `anisotropy` instead of `deviator` */
  NB_FOURTH,     /* the five components of a symmetric fourth-order tensor */
  NB_STATISTICS, /* mean max min std */
};
enum { NB_COMPONENTS_MAX = 5 }; /* the most numbers from which a family is computed */

/* Bounds of a quantity, which its row or its suffix states. A condition or an expectation that such a bound always or
 * never fulfils is an error of the page, and so is a percentage that is compared with a count. */
enum nb_bound {
  NB_AT_LEAST_0 = 1,
  NB_AT_MOST_1 = 2,
  NB_AT_LEAST_0_BY_LAW = 4, /* 0 or more with all laws of this program; a law that a user adds may be tensile */
  NB_COUNTED = 8,           /* a number of particles or contacts: a percentage of it means nothing */
};

/* A row of the table: one quantity, or a family. */
struct nb_quantity_kind {
  const char *name;
  /* Set of monitor kinds; 0: the whole scene; or NB_OF_IMPACT, NB_OF_CELL, NB_OF_BOX, NB_OF_CONTACT_TEST. */
  unsigned monitors;
  const char *unit;
  unsigned fields; /* contact fields that the quantity reads; in a contact test, what it requires of the laws */
  double (*value)(const struct nb_model *model, const struct nb_monitor *monitor);
  const char *help;
  /* Set of enum nb_bound: valid in every state of every scene; of a family, valid for all its quantities. */
  unsigned bounds;

  enum nb_quantity_family family;
  /* Computes the numbers of a family, or of a quantity of a region; `value` is then NULL. */
  void (*parts)(double parts[], const struct nb_quantity_kind *kind, const struct nb_model *model,
                const struct nb_monitor *monitor);
  int measure; /* for a region: the measure that computes the quantity (measure/region.h) */
  size_t at;   /* for a region: offset of the quantity in struct nb_region_state */
};
#define NB_OF_IMPACT (1u << 31)
#define NB_OF_CELL (1u << 29)         /* quantity of a periodic cell */
#define NB_OF_BOX (1u << 28)          /* quantity of a box of walls */
#define NB_OF_CONTACT_TEST (1u << 30) /* quantity of a contact test */
enum { NB_OF_REGION = 1 << NB_MONITOR_REGION };

/* Fields that stored energies need, and those that the terms of the energy balance need. */
enum { NB_OF_STORED = NB_BIT(NB_OVERLAP) | NB_BIT(NB_NORMAL) | NB_BIT(NB_STIFFNESS) | NB_BIT(NB_RADIUS) };
#define NB_OF_BALANCE                                                                                                  \
  (NB_OF_STORED | NB_BIT(NB_EX) | NB_BIT(NB_EY) | NB_BIT(NB_TOTAL_NORMAL) | NB_BIT(NB_TANGENTIAL_INCREMENT) |          \
   NB_BIT(NB_SHEAR) | NB_BIT(NB_SHEAR_STIFFNESS) | NB_BIT(NB_SLIDING) | NB_BIT(NB_DISSIPATED) |                        \
   NB_BIT(NB_SHEAR_BEFORE) | NB_BIT(NB_SHEAR_STIFFNESS_BEFORE) | NB_REQUEST_ENERGY)

/* Quantities of a contact test (run/contact_test_quantities.c); the last row has no name. */
extern const struct nb_quantity_kind nb_contact_test_kinds[];

/* input/names.c */
/* Writes a hint what to type instead of a name that is no quantity of the scene: the nearest name, or a list. */
const char *nb_quantity_hint(char *hint, const struct nb_scene *scene, const char *text);
/* input/name_parts.c: does so for a name of several words in any order. `owner`: index of the monitor; -1: none. False:
 * no quantity has all these words. */
bool nb_parts_hint(char *hint, const struct nb_scene *scene, const char *text, int owner);
bool nb_is_quantity(const char *name);                     /* some quantity of a monitor or of a scene has this name */
bool nb_quantity_is_residual(struct nb_quantity quantity); /* the quantity is a residual, 0 by definition */
/* For the manual: nb_quantity_row fills a row with the k-th quantity. False past the last one. */
struct nb_quantity_row {
  const void *key; /* identifies the quantity */
  char name[NB_NAME_SIZE], help[1024];
  const char *unit, *of;          /* unit; the kind of monitor that has the quantity */
  const char *statement, *prefix; /* "region M all", "M."; NULL: a quantity of the scene */
};
bool nb_quantity_row(struct nb_quantity_row *row, size_t k);

/* families.c */
struct nb_suffix {
  unsigned families; /* set of families that have the suffix */
  const char *name, *help;
  int part;                                      /* index of the number that is the value, if `function` is NULL */
  double (*function)(const struct nb_tensor *t); /* computes the value from the tensor; NULL: see `part` */
  const char *unit;                              /* NULL: the unit of the family */
  unsigned bounds;                               /* as in struct nb_quantity_kind */
};
const struct nb_suffix *nb_suffix(enum nb_quantity_family family, size_t k); /* the k-th; NULL past the last one */
unsigned nb_quantity_bounds(struct nb_quantity quantity);                    /* set of enum nb_bound */
double nb_quantity_now(struct nb_quantity quantity, const struct nb_model *model); /* current value, SI */

/* Defines the function of a quantity, or of a family that is computed from a tensor. `expression` may use `model` and
 * `monitor`. */
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
