/* A block: up to NB_BLOCK_SIZE contacts of one material pair, the unit of work of the force calculation.
 *
 * Every contact variable is a field: one double per contact in an array of its own, so that the loops over a block
 * vectorise. Fields that only the passes of the same cycle read share a small scratch memory, which stays in the
 * first-level cache. Fields that are read later (by the integration of motion, a monitor, a snapshot) are kept for all
 * contacts. A pass uses both kinds of fields in the same way.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "array.h"
#include "error.h"
#include "vec.h"

enum { NB_BLOCK_SIZE = 128 };

/* The parameters that a contact law reads, for two materials x and y. Values of the page's `pair` take precedence.
 * Otherwise a stiffness is the harmonic mean 2ab/(a+b) of the stiffnesses a and b of the materials, and friction and
 * cohesion are the smaller ones [CS79 19]. R_x and R_y are the radii of the two particles, m. */
struct nb_pair {
  NB_PAIR_ROWS(NB_PAIR_MEMBER)
  double young;  /* E* = 1/((1 - nu_x^2)/E_x + (1 - nu_y^2)/E_y), Pa; 0 where a material has none [R89 4.7] */
  double shear;  /* G* = 1/((2 - nu_x)/G_x + (2 - nu_y)/G_y), Pa [R89 4.8-4.10] */
  double radius; /* R* = 1/(1/R_x + 1/R_y), R_y infinite for a wall, m; set for each contact, 0 for the pair */
  double pieces; /* most pieces of contact history that the shear law keeps; 0: none */
};
static inline bool nb_has_friction(struct nb_pair pair) { return pair.friction > 0 || pair.cohesion > 0; }

enum nb_field {
  NB_OVERLAP,              /* alpha >= 0, m */
  NB_NORMAL_INCREMENT,     /* dn, normal increment (approach) in the last step, m [CS79 14] */
  NB_TANGENTIAL_INCREMENT, /* ds, tangential increment in the last step, m [CS79 15] */
  NB_EX,
  NB_EY,              /* e, unit vector from the first particle to the second, or to the wall [CS79 9] */
  NB_NORMAL,          /* F_n >= 0, elastic, N */
  NB_STIFFNESS,       /* dF_n/d(alpha), N/m; 0 without contact */
  NB_RADIUS,          /* a, radius of the contact circle, m; 0 for laws without one */
  NB_SHEAR,           /* F_s, elastic, on the first particle along -t, N; t is e rotated clockwise by 90 degrees */
  NB_SHEAR_STIFFNESS, /* dF_s/ds, N/m; 0 without contact */
  NB_SLIDING,         /* 1 where F_s is at its limit [CS79 19], else 0 */
  NB_DISSIPATED,      /* energy lost to micro-slip and sliding in the last step, by dissipative laws, J */
  NB_TOTAL_NORMAL,    /* F_n + D_n, N, with the force D_n of the dashpot; may be tensile */
  NB_TOTAL_SHEAR,     /* F_s + D_s, N, with the force D_s of the dashpot */
  NB_RADIUS_SUM,      /* R_x + R_y, at a wall R_x, m; each search sets this field and the next two */
  NB_MASS,            /* M*, reduced mass, kg [R89 4.6] */
  NB_REDUCED,         /* R*, effective radius, m [R89 4.5] */
  NB_NORMAL_ROOT,     /* sqrt(M* k_n), kg/s, for the k_n of the material pair: pass/dashpots.c */
  NB_SHEAR_ROOT,      /* sqrt(M* k_s), kg/s */
  NB_DEEP,            /* 1 where the overlap is beyond the range of Hertz theory, else 0 */
  NB_STABLE_OVERLAP,  /* overlap up to which the step is guaranteed stable, m: stability.c */
  NB_SHEAR_BEFORE,    /* F_s one step earlier, N, for the energy balance only */
  NB_SHEAR_STIFFNESS_BEFORE, /* dF_s/ds one step earlier, N/m, for the energy balance only */
  NB_FIELDS
};

/* The set that contains one field; `|` joins sets. */
#define NB_BIT(field) (1u << (field))
/* Number of fields in a set. */
static inline size_t nb_bit_count(unsigned set) {
  size_t count = 0;
  for (; set; set &= set - 1)
    count++;
  return count;
}

/* The contact history of a law. A law with up to four doubles per contact has an array for each of them, so that the
 * law's loop vectorises. A law with more doubles has a row of them for each contact. The first double of a row is 0
 * when the history is empty; the others are then undefined. */
#define NB_HISTORY 4 /* most doubles with an array each; the preprocessor compares this number */
/* Largest number of pieces of a history, and the number of doubles of the longest row. The numbers 12 and 5 are HISTORY
 * and PIECE of shear_mindlin_deresiewicz.c. */
enum { NB_PIECES_MAX = 256, NB_HISTORY_MAX = 12 + 5 * NB_PIECES_MAX };
enum { NB_PREFETCH_DISTANCE = 6 }; /* a row is prefetched this many contacts before it is used */
struct nb_history {
  int doubles;               /* number of doubles for each contact */
  double *field[NB_HISTORY]; /* the arrays, if there are up to four doubles; else NULL */
  double *rows;              /* the rows, if there are more; else NULL */
};

/* NB_WIDE is placed before a loop over a block. It tells the compiler that the arrays do not overlap, so that the
 * compiler can vectorise the loop. NB_UNROLLED is placed before a short loop of constant length, which the compiler
 * then unrolls. */
#ifdef __clang__
#define NB_WIDE _Pragma("clang loop vectorize(assume_safety)")
#define NB_UNROLLED _Pragma("clang loop unroll(full)")
#else
#define NB_WIDE _Pragma("GCC ivdep")
#define NB_UNROLLED _Pragma("GCC unroll 64")
#endif

/* Instruction sets. A pass is written once, as `static inline NB_FORM void NAME(model, block)`; NB_FORMS(NAME)
 * compiles it for each instruction set: NAME_plain, NAME_avx2, NAME_avx512. All return the same values. avx512vl is
 * left out: with it gcc fuses a product and a sum of two values into vfmaddsub, even with -ffp-contract=off. */
enum nb_isa { NB_PLAIN, NB_AVX2, NB_AVX512, NB_ISAS };
struct nb_model;
struct nb_block;
/* A pass for one instruction set: computes fields of the block from other fields. */
typedef void nb_run_pass(const struct nb_model *model, const struct nb_block *block);

/* NB_FORM inlines a function into the function of each instruction set. */
#define NB_FORM __attribute__((always_inline))
#define NB_COLD __attribute__((noinline)) /* rare code, kept out of the loop that calls it */
#define NB_FORM_OF(name, isa, target)                                                                                  \
  target static void name##_##isa(const struct nb_model *model, const struct nb_block *block) { name(model, block); }
#if defined __x86_64__ && defined __GNUC__
#define NB_X86 1
#define NB_TARGET_AVX2 __attribute__((target("avx2")))
#define NB_TARGET_AVX512 __attribute__((target("avx512f,avx512dq")))
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

/* True if the contact began in the last step: the overlap is then smaller than the normal increment dn. */
static inline bool nb_touch_began(double overlap, double dn) { return overlap > 0 && overlap < dn; }
/* The fraction of the last step after first touch; 1 if the contact is older. A law uses only the displacement after
 * first touch. With the displacement of the whole step, the shear force would have an error of first order in the
 * step. */
static inline double nb_touch_fraction(double overlap, double dn) {
  return nb_touch_began(overlap, dn) ? overlap / dn : 1;
}

/* ---- history.c ---- */
/* Creates an empty history of `contacts` contacts, with a number of doubles for each. A failed allocation is recorded
 * in the owner. */
struct nb_history nb_history_create(struct nb_owner *owner, int doubles, size_t contacts);
/* Returns the part of a history that begins with the contact `first`; it shares the memory. */
struct nb_history nb_history_from(const struct nb_history *history, size_t first);
/* Copies the history of contact `here` of `from` to contact `there` of `to`. */
void nb_history_copy(struct nb_history *to, size_t there, const struct nb_history *from, size_t here);
/* Copies the histories of the contacts that stay: from[c] is the old index of contact c, -1 if it is new. */
void nb_history_keep(struct nb_history *now, const struct nb_history *old, const int from[], size_t contacts);
/* Makes the history of a contact empty. */
void nb_history_forget(struct nb_history *history, size_t contact);
/* Returns the history of a contact as one array, which a law can read: the row itself, or a copy in `buffer`. */
const double *nb_history_read(const struct nb_history *history, size_t contact, double buffer[NB_HISTORY]);

struct nb_material_pair;
struct nb_contact_force;

/* The stiffnesses for which a block stores NB_NORMAL_ROOT and NB_SHEAR_ROOT, N/m; 0 in a new block, whose roots are
 * 0. */
struct nb_rooted {
  double kn, ks;
};

/* The arguments of a pass. The arrays of contacts have n entries. A field that is not kept is in the scratch memory;
 * NB_DISSIPATED is NULL if nothing reads it. */
struct nb_block {
  size_t n;
  const int *a, *b; /* slots of the two particles; b is a wall's index in a pair with walls */
  double *f[NB_FIELDS];
  const struct nb_vec *image; /* as in struct nb_contacts */
  struct nb_contact_force *force;
  struct nb_history normal_history, shear_history;
  /* The geometry sets it where it computes tangential increments. False: no contact of the block began in the last step
   * (nb_touch_began). */
  bool *began;
  unsigned long *deep;                      /* counter of deep contacts: pass/deep.c */
  struct nb_rooted *rooted;                 /* pass/dashpots.c; NULL: no roots are stored */
  struct nb_stable_overlap *stable_overlap; /* stability.c */
  const struct nb_material_pair *material_pair;
};

/* Reduces ds to the displacement after first touch in contacts that began in the last step. Such contacts are few, so
 * this loop is separate from the vectorised one. */
static inline void nb_tangential_since_touch(const struct nb_block *block) {
  const double *overlap = block->f[NB_OVERLAP], *dn = block->f[NB_NORMAL_INCREMENT];
  double *slip = block->f[NB_TANGENTIAL_INCREMENT];
  for (size_t c = 0; c < block->n; c++)
    if (nb_touch_began(overlap[c], dn[c]))
      slip[c] *= overlap[c] / dn[c];
}
