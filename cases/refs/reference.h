/* A reference solution: the values and curves that theory predicts for one run. They are computed from the scene alone
 * and have the names that the checks of the page use. A reference never uses a number that the simulator computed. The
 * methods are closed forms, quadrature, root finding, ordinary differential equations and eigenvalues. Outside tests/
 * only cases/refs uses GSL.
 *
 * To add one, write the file, whose last lines define `const struct nb_reference reference_NAME`, and add its path to
 * REFERENCES in build-aux/lists.mk.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/error.h"
#include "coverage.h"
#include "matter.h"

/* A curve: `at` returns the reference value at x. `data` holds what the reference computed in advance for `at`. */
struct nb_solution_curve {
  char name[2 * NB_NAME_SIZE];  /* `C.normal` */
  char along[2 * NB_NAME_SIZE]; /* `time`, `cycle`: the quantity that x is, SI */
  double (*at)(const void *data, double x);
  void *data; /* owned: one allocation, freed with free() */
};

/* All values and curves that a reference returns for one run. */
struct nb_solution {
  struct nb_solution_value {
    char name[4 * NB_NAME_SIZE]; /* quantity, reducer, stage as on the page: `C.normal mean`, `C.normal mean in rest` */
    double value;                /* SI */
  } * values;
  size_t value_count;
  struct nb_solution_curve *curves;
  size_t curve_count;
  bool incomplete; /* memory ran out: some values or curves are missing */
};

/* solution_value and solution_curve copy their texts. When memory runs out they set `incomplete`; solution_status
 * reports it in the last line of `solve`. */
void solution_value(struct nb_solution *solution, double value, const char *name);
void solution_curve(struct nb_solution *solution, const char *name, const char *along,
                    double (*at)(const void *data, double x), void *data);
enum nb_status solution_status(const struct nb_solution *solution, struct nb_error *error); /* NB_OK or NB_NO_MEMORY */
const double *solution_find(const struct nb_solution *solution, const char *name);          /* NULL: no such value */
const struct nb_solution_curve *solution_find_curve(const struct nb_solution *solution, const char *name,
                                                    const char *along);
void solution_free(struct nb_solution *solution);

#define NB_ANY_LAW "*"

struct nb_reference {
  const char *name;   /* the word after `reference`; also the name of the file */
  const char *title;  /* one line: what it computes and how */
  const char *source; /* equation tags: "[CS79 1-7]" */
  /* Features of scenes that its theory covers, and those that it needs. Unset elements are HAS_NOTHING, which ends a
   * list. */
  enum nb_feature accepts[NB_FEATURES], needs[4];
  const char *normal, *shear; /* names of laws, separated by spaces, or NB_ANY_LAW */
  /* NB_BAD_USE and an error in words when the reference does not cover the numbers or the geometry of the scene. It is
   * called only for scenes whose features and laws the reference accepts. */
  enum nb_status (*solve)(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error);
};

/* After this call GSL returns a status instead of aborting the program. If GSL cannot allocate memory, the program ends
 * with NB_NO_MEMORY, so references do not check its allocations. To be called before any reference; more than once is
 * allowed. */
void nb_references_prepare(void);
/* Compares the features and laws of the scene with those that the reference accepts, then solves. Call solution_free in
 * any case. */
enum nb_status nb_reference_solve(const struct nb_reference *reference, struct nb_solution *solution,
                                  const struct nb_scene *scene, struct nb_error *error);
const struct nb_reference *nb_reference_find(const char *name); /* NULL: no reference of that name */
const struct nb_reference *const *nb_references(void);          /* NULL-terminated */
