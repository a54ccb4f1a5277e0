/* The interface of a contact law: a function of values for one contact. It does not depend on steps, particles, loops
 * or files.
 *
 *   struct nb_normal normal_NAME(struct nb_pair p, double overlap, double dn, double m[])
 *   struct nb_shear  shear_NAME(struct nb_pair p, struct nb_normal n, double ds, double m[])
 *
 * `overlap`, in metres, is never negative. It is 0 without contact; force and stiffness must then be 0. A law with
 * plastic flow may return the force 0 while the particles overlap, if the overlap was larger before. `dn` and `ds` are
 * the normal and the tangential increment of this step, in metres. The array `m` is the history of this contact. It has
 * as many doubles as the law declares; a history of up to four doubles is 0 at first touch, and a longer one has m[0] =
 * 0. The law updates the history for the next step. Forces are elastic; the dashpots are added later, from the
 * stiffnesses that the laws return.
 *
 * A straight-line law has no branches. It uses only sums, products, quotients, sqrt, fabs, copysign, ?: and nb_where,
 * so that the compiler vectorises its loop.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <math.h>
#include <stdint.h>

#include "core/block.h"

/* x if the condition holds, else 0, computed as the bitwise `and` of x and a mask. A law uses it where one `?:` would
 * depend on another one, because gcc would then compute every combination of their cases. The mask is a double, so that
 * SSE2 vectorises the comparison. */
static inline double nb_where(bool condition, double x) {
  union {
    int64_t bits;
    double x;
  } value = {.x = x}, all = {.bits = -1}, mask = {.x = condition ? all.x : 0};
  value.bits &= mask.bits;
  return value.x;
}

struct nb_normal {
  double force;     /* F_n >= 0, N; above 0 at the largest overlap so far, unless the law is incremental */
  double stiffness; /* dF_n/d(overlap) in the direction of this step, loading or unloading, N/m; 0 without force */
  double radius;    /* a, radius of the contact circle, m; 0 for laws without one */
  double overlap;   /* alpha, m, which shear laws read; set by the caller of a normal law, not by the law */
  /* The greatest slope that the force can have when the overlap changes from here, N/m, for the stable step
   * (measure/stable_step.c); 0: equal to `stiffness`. This member must be the last one: if it came before members that
   * shear laws read, R89's laws would take 1.6 times as long. */
  double max_stiffness;
};

struct nb_shear {
  double force;      /* F_s, with the sign of the displacement that caused it, N */
  double stiffness;  /* dF_s/ds while sticking, with R89's laws times theta, N/m; 0 without contact */
  double sliding;    /* 1 when the force is at its limit, else 0 */
  double dissipated; /* energy lost to micro-slip and sliding in this step, J; only laws that declare DISSIPATIVE */
};

/* An entry of the register; law_batch.h defines one for each law. */
struct nb_law {
  const char *kind;       /* "normal" or "shear" */
  const char *name;       /* "linear" */
  const char *title;      /* one line for `nineball laws` */
  const char *source;     /* tags of the equations: "[CS79 17-19]" */
  const char *parameters; /* material properties on which the force depends: "ks, friction, cohesion" */
  int history;            /* doubles per contact, without those of the pieces */
  int piece, pieces;      /* doubles for each piece; default number of pieces */
  unsigned needs;         /* set of fields that the law reads besides overlap, normal force and normal stiffness */
  bool elastic;           /* for elastic spheres: uses E*, G* and R* instead of k_n and k_s */
  bool constant;          /* the stiffness is k_n or k_s of the pair, or 0; so dashpots can store sqrt(M* k) */
  bool branching;         /* has loops or calls: its loop need not vectorise */
  bool cohesionless;      /* does not support cohesion: a page with cohesion is invalid */
  bool dissipative;       /* dissipates energy before gross sliding, and returns this energy */
  bool non_conservative;  /* may create energy in a closed path; its file says how much */
  /* Adds an increment to the previous force: the returned stiffness is the one of the next step, and the force may be 0
   * although the particles overlap. */
  bool incremental;
  nb_run_pass *run[NB_ISAS]; /* the law's loop over a block, for each instruction set */
  /* The law itself, for contact tests, the stable step, energies and unit tests. */
  struct nb_normal (*normal)(struct nb_pair, double overlap, double dn, double m[]);
  struct nb_shear (*shear)(struct nb_pair, struct nb_normal, double ds, double m[]);
  double (*stored)(struct nb_pair, struct nb_normal, const double m[]); /* elastic energy, J; NULL: none defined */
  int (*used)(const double m[]); /* number of doubles in use in a contact's row; NULL: all */
  /* True if these doubles, read from a file, are a valid row with at most `pieces` pieces. NULL: any row of the
   * declared length is valid. */
  bool (*valid)(const double m[], int doubles, int pieces);
  /* For contact tests: sets x to the overlaps at which the pieces of a contact's history end, m, in ascending order up
   * to the present overlap, and d to the value of the memory diagram D on each piece, 1. Returns the number of pieces,
   * at most p.pieces. NULL: the law has no pieces. */
  int (*pieces_of)(struct nb_pair, struct nb_normal, const double m[], double x[], double d[]);
};

/* The greatest slope that the normal force can have when the overlap changes from here, N/m. */
static inline double nb_normal_max_stiffness(struct nb_normal n) {
  return n.max_stiffness > n.stiffness ? n.max_stiffness : n.stiffness;
}

/* The number of pieces: `given`, from the page; the law's default if `given` is 0; 0 if the law has no pieces. */
static inline double nb_law_pieces(const struct nb_law *law, double given) {
  return !law || law->piece == 0 ? 0 : given > 0 ? given : law->pieces;
}
/* Number of doubles of history per contact of a material pair; 0 if `law` is NULL. */
static inline int nb_law_history(const struct nb_law *law, struct nb_pair p) {
  return law ? law->history + law->piece * (int)p.pieces : 0;
}

/* ---- register.c: the register, generated from LAWS in build-aux/lists.mk ---- */

const struct nb_law *nb_law_find(const char *kind, const char *name); /* "normal", "linear"; NULL: no such law */
const struct nb_law *const *nb_laws(void);                            /* NULL-terminated */

/* properties.c: contact parameters of two materials at time 0 */
struct nb_pair nb_scene_pair(const struct nb_scene *scene, int material_a, int material_b);
