/* The path of a contact test, for references: the constants of the contact, the targets of the steps, and columns of
 * results.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "reference.h"

/* The constants of the contact of two elastic spheres, or of a sphere and a wall. */
struct path_contact {
  double radius;   /* R*, m */
  double young;    /* E*, Pa */
  double shear;    /* G*, Pa */
  double friction; /* mu, 1 */
  double kappa;    /* E* / (4 G*) */
};
struct path_contact path_contact(const struct nb_scene *scene);
double path_normal(const struct path_contact *contact, double overlap); /* normal force, N [R89 3.13] */
double path_overlap(const struct path_contact *contact, double normal); /* its inverse, m */

/* The target of a step: displacements or forces, as the segment prescribes. */
struct path_target {
  int segment;
  bool normal_force, shear_force;
  double normal, shear; /* m or N */
};
/* A point of the path. */
struct path_point {
  double approach, slip, normal, shear; /* m, N */
};

/* Iterates over the targets of a path. `now` is the point that the previous steps have reached. path_next uses it only
 * at the first step of a segment, where it becomes `begin`: the targets of the segment are interpolated from there. */
struct path_walk {
  const struct nb_scene *scene;
  int segment;
  unsigned long step;      /* the next step of the segment, counted from 1 */
  struct path_point begin; /* the point at which the segment began */
};
struct path_walk path_walk(const struct nb_scene *scene);
bool path_next(struct path_walk *walk, struct path_point now,
               struct path_target *target);      /* false: there are no more */
size_t path_steps(const struct nb_scene *scene); /* of all segments */

/* The values of one quantity at each step, 0 to path_steps. */
struct path_column {
  size_t count;
  double values[];
};
struct path_column *path_column(const struct nb_scene *scene); /* of zeros; NULL: out of memory */
/* Adds the value at the end of each segment, `NAME in SEGMENT`, the value at the end of the path, NAME, and the curve
 * versus `step`. NAN stands for "no value"; a column with a NAN gives no curve. Takes ownership of the column. */
void path_add(struct nb_solution *solution, const struct nb_scene *scene, const char *name, struct path_column *column);
