/* What a law is: a function of values, one contact at a time. It knows no step, no body, no loop, no file.
 *
 *   struct nb_normal normal_NAME(struct nb_pair p, double overlap, double closing, double m[])
 *   struct nb_shear  shear_NAME(struct nb_pair p, struct nb_normal n, double slip, double m[])
 *
 * overlap is never negative, and is 0 where nothing touches: the force and stiffness must then be 0. A law that yields may have no force
 * at an overlap, once that has been larger; a stable step is found from the greatest stiffness that can follow (step/stable.c). closing and slip are lengths over
 * this step. m is the law's own memory of this contact, as many doubles as it declares, 0 at first touch; the law writes
 * there what it wants to find next step. Forces are elastic; dashpots come after, from the stiffnesses answered here.
 *
 * Straight-line laws use + - x / sqrt fabs copysign and ?: only, so that the compiler makes their loop wide.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_LAW_H
#define NB_LAW_H

#include <math.h>

#include "core/block.h"

struct nb_normal {
  double force;     /* F_n >= 0, N; > 0 where the overlap is the largest so far, maybe 0 where it has been larger */
  double stiffness; /* dF_n/d(overlap) as this step went, N/m; 0 where there is no force */
  double radius;    /* a of the contact circle, m; 0 for a law that knows none */
  double overlap;   /* alpha that was given, for shear laws, m; a normal law need not say it */
  /* The greatest slope that can follow at this overlap, N/m; 0: the stiffness. It stands last: in front of what shear laws
   * read it makes R89's laws take 1.6 times as long. */
  double max_stiffness;
};

struct nb_shear {
  double force;      /* F_s, in the sense of the slip that made it, N */
  double stiffness;  /* dF_s/d(slip) while sticking, N/m; 0 where nothing touches */
  double sliding;    /* 1 when the force is at its limit, else 0 */
  double dissipated; /* in this step to micro-slip, gross sliding included, J; of a law that declares LOSES */
};

/* One row of the register; law_batch.h writes it. */
struct nb_law {
  const char *kind;       /* "normal" or "shear" */
  const char *name;       /* "linear" */
  const char *title;      /* one line for `nineball laws` */
  const char *source;     /* equation tags */
  const char *parameters; /* of the materials, on which its force depends: "ks, friction, cohesion" */
  int history, piece,
      pieces; /* doubles per contact: `history`, and `piece` more for each of `pieces`, or of as many as a page says */
  unsigned needs;        /* set of fields, besides overlap, normal and its stiffness, that it reads */
  bool elastic;          /* of elastic spheres: works with E*, G* and R*, not with k_n and k_s */
  bool branching;        /* has loops or calls: its loop is not asked to be wide */
  bool cohesionless;     /* knows no cohesion: a page that gives it some is wrong */
  bool dissipative;      /* loses energy before it slides as a whole, and says how much */
  bool non_conservative; /* may create energy over a closed path, and says so in its file */
  bool incremental;      /* adds to the force before: its stiffness is the slope to come; parts before overlap does */
  nb_run_pass *run[NB_ISAS];                                                         /* over a block */
  struct nb_normal (*normal)(struct nb_pair, double overlap, double dn, double m[]); /* for the bench and the tests */
  struct nb_shear (*shear)(struct nb_pair, struct nb_normal, double ds, double m[]);
  double (*stored)(struct nb_pair, struct nb_normal, const double m[]); /* elastic energy, J; NULL: the law has none */
  int (*used)(const double m[]); /* how many doubles of a contact's row mean something; NULL: all */
  /* Whether so many doubles can be such a row, with at most so many pieces: asked of what a file says. NULL: as many as it declares. */
  bool (*valid)(const double m[], int doubles, int pieces);
  /* What a contact's history is made of, for the bench: up to p.pieces overlaps x, m, ascending to alpha, and the D of the piece
   * that ends there, 1. Answers how many; NULL: the law keeps no such thing. */
  int (*pieces_of)(struct nb_pair, struct nb_normal, const double m[], double x[], double d[]);
};

/* The greatest slope of the normal force that can follow. */
static inline double nb_normal_max_stiffness(struct nb_normal n) {
  return n.max_stiffness > n.stiffness ? n.max_stiffness : n.stiffness;
}

/* Pieces of a contact's history that it keeps: as many as a page says, or, where that is 0, as it likes best. */
static inline double nb_law_pieces(const struct nb_law *law, double given) {
  return !law || law->piece == 0 ? 0 : given > 0 ? given : law->pieces;
}
/* Doubles that it remembers of a contact of such a pair; 0 for no law. */
static inline int nb_law_history(const struct nb_law *law, struct nb_pair p) {
  return law ? law->history + law->piece * (int)p.pieces : 0;
}

/* ---- register.c: the register that LAWS in build-aux/lists.mk makes ---- */

const struct nb_law *nb_law_find(const char *kind, const char *name); /* "normal", "linear"; NULL: no such law */
const struct nb_law *const *nb_laws(void);                            /* NULL-terminated */

/* properties.c */
struct nb_pair nb_scene_pair(const struct nb_scene *scene, int material_a, int material_b);

#endif
