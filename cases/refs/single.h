/* One particle on one straight wall at rest, with linear springs: shared by the references of falling, sliding and
 * rolling.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "reference.h"

struct single {
  double m, q;             /* mass, kg; m R^2/I: 2 for a disc, 5/2 for a sphere */
  double radius;           /* m */
  struct matter_pair pair; /* of particle and wall */
  double height;           /* of the centre above the wall at time 0, m */
  double gravity_n;        /* toward the wall, m/s2 */
  double cn, cs;           /* of the dashpots, N s/m */
  double step;             /* of the scene, s */
  const char *particle;    /* names of the monitors; NULL: none */
  const char *contact;
};

/* NB_BAD_USE, with the name of the reference, unless there are one particle and one wall along x below its centre, and
 * the step is given as a time or as a fraction of single-contact. */
enum nb_status single_read(struct single *single, const char *reference, const struct nb_scene *scene,
                           struct nb_error *error);
/* Whether the foot of the perpendicular from (x, y) to the line of the wall is inside the wall. */
bool single_faces(const struct nb_wall *wall, double x, double y);
/* Adds `MONITOR.WHAT`, with ` in STAGE` if there is one; nothing without a monitor. */
void single_add(struct nb_solution *solution, const char *monitor, const char *what, const char *stage, double value);
/* Adds the curve `MONITOR.WHAT` versus time; nothing without a monitor. Its data are a copy of the `size` bytes at
 * `data`. */
void single_curve(struct nb_solution *solution, const char *monitor, const char *what,
                  double (*at)(const void *data, double t), const void *data, size_t size);
