/* A path of the bench, for references: the contact's constants, what its legs go to, and the tables of what is known.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_PATH_H
#define NB_PATH_H

#include "reference.h"

/* Of two elastic spheres, or of one at a wall. */
struct path_contact {
  double radius;   /* R*, m */
  double young;    /* E*, Pa */
  double shear;    /* G*, Pa */
  double friction; /* mu, 1 */
  double kappa;    /* E* / 4 G* */
};
/* NB_BAD_USE when the page has no path, or its normal law is not `hertz`. */
enum nb_status path_contact(struct path_contact *contact, const struct nb_scene *scene, const char *reference,
                            struct nb_error *error);
double path_normal(const struct path_contact *contact, double overlap); /* N [R89 3.13] */
double path_overlap(const struct path_contact *contact, double normal); /* and back, m */

/* What a step of a leg goes to: places or forces, as the leg says. */
struct path_aim {
  int segment;
  bool normal_force, shear_force;
  double normal, shear; /* m or N */
};
/* Where a path has come. */
struct path_place {
  double approach, slip, normal, shear; /* m, N */
};

/* The aims of a path one after the other, asked for with the place that the steps so far have led to. */
struct path_walk {
  const struct nb_scene *scene;
  int segment;
  unsigned long step;      /* of the leg, the next one, from 1 */
  struct path_place begin; /* of the leg */
};
struct path_walk path_walk(const struct nb_scene *scene);
bool path_next(struct path_walk *walk, struct path_place now, struct path_aim *aim); /* false: that was the last one */
size_t path_steps(const struct nb_scene *scene);                                     /* of all legs */

/* What is known at each step, 0 to path_steps: of one quantity. */
struct path_column {
  size_t count;
  double values[];
};
struct path_column *path_column(const struct nb_scene *scene); /* of zeros; NULL: no memory */
/* A curve along `step`, and the value at the end of each leg, `NAME in LEG`. Takes the column; NAN is not known. */
void path_add(struct nb_solution *solution, const struct nb_scene *scene, const char *name, struct path_column *column);

#endif
