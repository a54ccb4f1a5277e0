/* A reference: the judge of a page. It is handed the scene, constant, and answers what theory says should be seen,
 * under the same names as the page expects. It never sees a number that the simulator computed about itself.
 * One file each; closed forms, quadrature, roots, ODEs, eigenvalues; the only place where GSL is used.
 *
 * Adding one is two touches: the file, whose last lines define `const struct nb_reference reference_NAME`, and the
 * file's path in REFERENCES in Makefile.am.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_REFERENCE_H
#define NB_REFERENCE_H

#include "core/error.h"
#include "coverage.h"
#include "matter.h"

/* A curve: the known value at x; `data` is what the reference computed once. */
struct nb_solution_curve {
  char name[2 * NB_NAME_SIZE];  /* `C.normal` */
  char along[2 * NB_NAME_SIZE]; /* `time`, `cycle`: the quantity that x is, SI */
  double (*at)(const void *data, double x);
  void *data; /* owned: one allocation, freed with free() */
};

/* Everything a reference knows of one run. */
struct nb_solution {
  struct nb_solution_value {
    char name[4 * NB_NAME_SIZE]; /* quantity, reducer, stage as on the page: `C.normal mean`, `C.normal mean in rest` */
    double value;                /* SI */
  } * values;
  size_t value_count;
  struct nb_solution_curve *curves;
  size_t curve_count;
  bool lacking; /* memory ran out: not all that was told is here */
};

/* Both copy their texts and may run out of memory, which known_full tells at the end: the last line of `know`. */
void solution_value(struct nb_solution *solution, double value, const char *name);
void solution_curve(struct nb_solution *solution, const char *name, const char *along,
                    double (*at)(const void *data, double x), void *data);
enum nb_status solution_full(const struct nb_solution *solution, struct nb_error *error); /* NB_OK or NB_NO_MEMORY */
const double *solution_find(const struct nb_solution *solution,
                            const char *name); /* NULL: this reference does not know it */
const struct nb_solution_curve *solution_find_curve(const struct nb_solution *solution, const char *name,
                                                    const char *along);
void solution_free(struct nb_solution *solution);

#define NB_ANY_LAW "*"

struct nb_reference {
  const char *name;   /* the word after `reference`, and the name of the file */
  const char *title;  /* one line: what it computes and how */
  const char *source; /* equation tags: "[CS79 1-7]" */
  /* What its theory covers, and what it cannot do without; a list ends with HAS_NOTHING, as all that is left unsaid is,
   * and has room for it. */
  enum nb_feature accepts[NB_FEATURES], needs[4];
  const char *normal, *shear; /* names of laws, separated by blanks, or NB_ANY_LAW */
  /* NB_OK, or NB_BAD_USE with an error in words when the numbers of the scene are none this reference can judge. It is asked
   * about scenes that it covers alone. */
  enum nb_status (*solve)(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error);
};

/* GSL answers with a status from then on; as it comes it aborts the program. Where it finds no memory, which its functions tell by
 * a NULL, it ends the program, with NB_NO_MEMORY: so no reference asks for that. Before any reference is asked; may be said again. */
void nb_references_prepare(void);
/* What the reference knows of the scene, after comparing what it covers with what the scene has. known_free it in any case. */
enum nb_status nb_reference_ask(const struct nb_reference *reference, struct nb_solution *solution,
                                const struct nb_scene *scene, struct nb_error *error);
const struct nb_reference *nb_reference_find(const char *name); /* NULL: there is none of that name */
const struct nb_reference *const *nb_references(void);          /* NULL-terminated */

#endif
