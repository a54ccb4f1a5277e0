/* One body on one straight wall at rest, linear springs: what the references of falling, sliding and rolling share.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_SINGLE_H
#define NB_SINGLE_H

#include "reference.h"

struct single {
  double m, q;             /* mass, kg; m R^2/I: 2 for a disc, 5/2 for a sphere */
  double radius;           /* m */
  struct matter_pair pair; /* of body and wall */
  double height;           /* of the centre above the wall at time 0, m */
  double gravity_n;        /* toward the wall, m/s2 */
  double cn, cs;           /* of the dashpots, N s/m */
  double step;             /* of the scene, s */
  const char *particle;    /* names of the watches; NULL: not watched */
  const char *contact;
};

/* The wall must lie along x, below the body. */
enum nb_status single_read(struct single *single, const struct nb_scene *scene, struct nb_error *error);
/* `WATCH.WHAT` {` in STAGE`}; nothing when it is not watched. */
void single_add(struct nb_solution *solution, const char *monitor, const char *what, const char *stage, double value);
void single_curve(struct nb_solution *solution, const char *monitor, const char *what,
                  double (*at)(const void *data, double t), const void *data, size_t size);

#endif
