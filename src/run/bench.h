/* One contact on a bench: no bodies, no time. Its law is called as the simulator's passes call it, one step after the other.
 *
 *   bench.c           a contact, and one step of it
 *   bench_leg.c       a leg: places and forces to go to
 *   bench_run.c       a path from its first leg to its last, and what is seen
 *   bench_names.c     quantities
 *   bench_traction.c  the traction over the contact, of a law that keeps its history
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_BENCH_H
#define NB_BENCH_H

#include "laws/law.h"

/* A contact after a step, and what its laws remember. */
struct nb_bench_state {
  double approach; /* m; below 0 it is a gap */
  double slip;     /* since the start, m */
  struct nb_normal n;
  struct nb_shear s;
  double *normal_memory, *shear_memory;
};

struct nb_bench {
  const struct nb_scene *scene;
  struct nb_pair pair;
  const struct nb_law *normal, *shear;
  int normal_doubles, shear_doubles; /* of memory */
  struct nb_bench_state now, trial;  /* trial: a step tried and not yet made */
  double work_normal, work_shear;    /* of the forces at the mean of each step's two ends, J */
  double lost;                       /* by a law that says it, J */
  unsigned long step;                /* made so far */
};

enum nb_status nb_bench_create(struct nb_bench *bench, const struct nb_scene *scene, struct nb_error *error);
void nb_bench_free(struct nb_bench *bench);

/* bench.trial: the contact as it would be after a straight step from bench.now to this place. */
void nb_bench_try(struct nb_bench *bench, double approach, double slip);
/* Makes the step that was tried last. */
void nb_bench_go(struct nb_bench *bench);

/* bench_leg.c. Where a leg begins and ends, in its own terms. */
struct nb_bench_leg {
  const struct nb_stage *stage;
  double normal_from, normal_to; /* m or N, as the aims say */
  double shear_from, shear_to;
};
struct nb_bench_leg nb_bench_leg_begin(const struct nb_bench *bench, const struct nb_stage *stage);
/* Step number `step` of the leg, from 1; NB_BROKEN when a force cannot be reached. */
enum nb_status nb_bench_leg_step(struct nb_bench *bench, const struct nb_bench_leg *leg, unsigned long step,
                                 struct nb_error *error);

/* What a path's quantity asks of the laws: the fields of its row. */
enum { NB_ASKS_STORE = 1, NB_ASKS_LOSS = 2, NB_ASKS_PIECES = 4 };

/* bench_traction.c. What the shear law keeps of its history: D is D[i] from the overlap x[i-1] (0 at first) to x[i]. */
struct nb_history {
  int count;                                 /* 0: the law keeps none, or nothing touches */
  double x[NB_PIECES_MAX], D[NB_PIECES_MAX]; /* m, 1 */
};
struct nb_history nb_bench_history(const struct nb_bench *bench);
double nb_bench_stick_radius(const struct nb_bench *bench);                                         /* m */
double nb_bench_traction(const struct nb_bench *bench, const struct nb_history *history, double r); /* q at r, Pa */
double nb_bench_traction_force(const struct nb_bench *bench); /* its integral over the contact, by quadrature, N */
bool nb_bench_snapshot(struct nb_snapshot *snapshot, const struct nb_bench *bench, int stage); /* false: no memory */

/* bench_run.c: nb_run of a path */
enum nb_status nb_bench_run(struct nb_result *result, const struct nb_scene *scene, const struct nb_progress *progress,
                            struct nb_error *error);

#endif
