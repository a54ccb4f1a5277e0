/* A block: up to NB_BLOCK contacts of one pairing, the unit of work of the force half of a cycle.
 *
 * Whatever a contact has is a field: one double per contact, in an array of its own, so that the loops over a block are
 * wide. A field that only the passes of this cycle read lives in a few kilobytes that stay in the first-level cache; one
 * that somebody reads later (the motion half, a watch, a snapshot) is kept for all contacts. A pass need not know which.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_BLOCK_H
#define NB_BLOCK_H

#include "array.h"
#include "error.h"
#include "vec.h"

enum { NB_BLOCK_SIZE = 64 };

/* What two materials make of a contact at time 0: the harmonic mean 2ab/(a+b) of the stiffnesses (which is k between like
 * ones), the smaller friction and cohesion [CS79 19], and what the page's `pair` says over both. */
struct nb_pair {
  NB_PAIR_ROWS(NB_PAIR_MEMBER)
  double young;  /* E* = 1/((1 - nu_x^2)/E_x + (1 - nu_y^2)/E_y), Pa; 0 where a material has none [R89 4.7] */
  double shear;  /* G* = 1/((2 - nu_x)/G_x + (2 - nu_y)/G_y), Pa [R89 4.8-4.10] */
  double radius; /* R* = 1/(1/R_x + 1/R_y), R_y infinite for a wall, m: of one contact, 0 here */
  double pieces; /* most pieces of a contact's history that the shear law keeps; 0: it keeps none */
};

enum nb_field {
  NB_OVERLAP,              /* alpha >= 0, m */
  NB_NORMAL_INCREMENT,     /* dn, approach over the last step, m [CS79 14] */
  NB_TANGENTIAL_INCREMENT, /* ds, tangential displacement over the last step, m [CS79 15] */
  NB_EX,
  NB_EY,                     /* e, unit vector from the first body to the second [CS79 9] */
  NB_NORMAL,                 /* F_n >= 0, elastic, N */
  NB_STIFFNESS,              /* dF_n/d(alpha), N/m; 0 where nothing touches */
  NB_RADIUS,                 /* a, of the contact circle, m; 0 for laws that know none */
  NB_SHEAR,                  /* F_s, elastic, on the first body along -t, N */
  NB_SHEAR_STIFFNESS,        /* dF_s/ds, N/m; 0 where nothing touches */
  NB_SLIDING,                /* 1 where F_s is at its limit [CS79 19], else 0 */
  NB_DISSIPATED,             /* lost in the step behind to micro-slip and sliding, by a law that says it, J */
  NB_TOTAL_NORMAL,           /* F_n + D_n, N: what is felt; may pull while damped */
  NB_TOTAL_SHEAR,            /* F_s + D_s, N */
  NB_RADIUS_SUM,             /* R_x + R_y, m; these three stay what they are while a pair is listed */
  NB_MASS,                   /* M*, reduced mass, kg [R89 4.6] */
  NB_REDUCED,                /* R*, reduced radius, m [R89 4.5] */
  NB_DEEP,                   /* 1 where the overlap is more than a Hertz contact is good for, else 0 */
  NB_STABLE_OVERLAP,         /* overlap up to which the step is sure to be stable, m: stability.c */
  NB_SHEAR_BEFORE,           /* F_s a step ago, N, for the energy balance alone; */
  NB_SHEAR_STIFFNESS_BEFORE, /* its stiffness then, N/m */
  NB_FIELDS
};

/* A set of fields. */
#define NB_BIT(field) (1u << (field))

/* What a law remembers of its contacts. Up to four doubles are an array each, so that its loop is wide; a law that remembers
 * more has a row for each contact, of which the first double is 0 as long as there is nothing to remember: the rest is then
 * whatever it was. */
#define NB_HISTORY 4 /* no enum: the preprocessor asks */
enum { NB_PIECES_MAX = 256, NB_HISTORY_MAX = 12 + 5 * NB_PIECES_MAX };
enum { NB_PREFETCH_DISTANCE = 6 }; /* contacts between fetching what is remembered of one and its turn */
struct nb_history {
  int doubles;               /* for each contact */
  double *field[NB_HISTORY]; /* of up to four doubles; else NULL */
  double *rows;              /* of more; else NULL */
};

/* Before a loop over a block: its arrays do not overlap, so it can be made wide. */
#ifdef __clang__
#define NB_WIDE _Pragma("clang loop vectorize(assume_safety)")
#define NB_UNROLLED _Pragma("clang loop unroll(full)")
#else
#define NB_WIDE _Pragma("GCC ivdep")
#define NB_UNROLLED _Pragma("GCC unroll 64")
#endif

/* Instruction sets. A pass is written once, as `static inline NB_FORM void NAME(model, view)`, and NB_FORMS(NAME) makes a
 * function of it for each: NAME_plain, NAME_avx2, NAME_avx512. The values are the same, only the loops are wider. */
enum nb_isa { NB_PLAIN, NB_AVX2, NB_AVX512, NB_ISAS };
struct nb_model;
struct nb_block;
typedef void nb_run_pass(const struct nb_model *model, const struct nb_block *block); /* C has no other word for it */

#define NB_FORM __attribute__((always_inline))
#define NB_COLD __attribute__((noinline)) /* out of the way of a loop that seldom wants it */
#define NB_FORM_OF(name, isa, target)                                                                                  \
  target static void name##_##isa(const struct nb_model *model, const struct nb_block *block) { name(model, block); }
#if defined __x86_64__ && defined __GNUC__
#define NB_X86 1
#define NB_TARGET_AVX2 __attribute__((target("avx2")))
#define NB_TARGET_AVX512 __attribute__((target("avx512f,avx512dq,avx512vl")))
#define NB_FORMS(name)                                                                                                 \
  NB_FORM_OF(name, plain, )                                                                                            \
  NB_FORM_OF(name, avx2, NB_TARGET_AVX2)                                                                               \
  NB_FORM_OF(name, avx512, NB_TARGET_AVX512)
#define NB_FORMS_LIST(name)                                                                                            \
  { name##_plain, name##_avx2, name##_avx512 }
#else
#define NB_FORMS(name) NB_FORM_OF(name, plain, )
#define NB_FORMS_LIST(name)                                                                                            \
  { name##_plain, name##_plain, name##_plain }
#endif

/* Whether a pair has met in the step behind: it was apart a step ago when it has overlapped by less than it has closed. And the
 * share of that step in which it touched. Slip counts while they touch, or the first step would be of first order in a law's slip. */
static inline bool nb_touch_began(double overlap, double dn) { return overlap > 0 && overlap < dn; }
static inline double nb_touch_fraction(double overlap, double dn) {
  return nb_touch_began(overlap, dn) ? overlap / dn : 1;
}

/* ---- memory.c ---- */
/* Nothing remembered of so many contacts; the owner knows whether memory was out. */
struct nb_history nb_history_create(struct nb_owner *owner, int doubles, size_t contacts);
struct nb_history nb_history_from(const struct nb_history *memory,
                                  size_t first); /* that of the contacts from `first` on */
void nb_history_copy(struct nb_history *to, size_t there, const struct nb_history *from,
                     size_t here); /* of one contact */
void nb_history_forget(struct nb_history *memory, size_t contact);
/* What a contact's law would be given, in `room` or where it is. */
const double *nb_history_read(const struct nb_history *memory, size_t contact, double room[NB_HISTORY]);

struct nb_material_pair;

/* What a pass is given. All arrays have n entries, except where the plan has no use for a field: then NULL. */
struct nb_block {
  size_t n;
  const int *a, *b; /* slots of the two bodies; b is a wall's index where the pairing is with walls */
  double *f[NB_FIELDS];
  const struct nb_vec *image; /* of struct nb_contacts */
  struct nb_vec *force;       /* on the first body, N */
  struct nb_history normal_history, shear_history;
  unsigned long *deep;                      /* how often an overlap was too deep, to be added to */
  struct nb_stable_overlap *stable_overlap; /* stability.c */
  const struct nb_material_pair *material_pair;
};

/* Of pairs that have met in the step behind slip is what there was of it since then. Few have, so it is no part of a wide loop. */
static inline void nb_tangential_since_touch(const struct nb_block *block) {
  const double *overlap = block->f[NB_OVERLAP], *dn = block->f[NB_NORMAL_INCREMENT];
  double *slip = block->f[NB_TANGENTIAL_INCREMENT];
  for (size_t c = 0; c < block->n; c++)
    if (nb_touch_began(overlap[c], dn[c]))
      slip[c] *= overlap[c] / dn[c];
}

#endif
