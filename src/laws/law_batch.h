/* The loop of a law over a block, for each instruction set, and the entry of the law in the register. The last line of
 * a law's file includes this file, after the definitions
 *
 *   #define LAW     shear_linear            name of the law's function and of its file
 *   #define SHEAR   or  #define NORMAL      the kind of law
 *   #define TITLE   "..."                   one line
 *   #define SOURCE  "[CS79 17-19]"          source of the equations
 *   #define PARAMETERS "ks, friction"       properties on which the force depends; young, poisson: E* and G*
 *   #define HISTORY 1                       doubles of history per contact, without those of the pieces
 *   #define PIECE   4, #define PIECES  16   doubles for each piece of the history; default number of pieces (optional)
 *   #define NEEDS   NB_BIT(NB_NORMAL_INCREMENT)   fields that the law reads besides those every law gets (optional)
 *   #define STORED  shear_linear_stored     function that returns the stored elastic energy, J (optional)
 *   #define ELASTIC                         for elastic spheres: reads p.young, p.shear and p.radius (optional)
 *   #define CONSTANT                        returns the stiffness p.kn, or p.ks for a shear law, or 0 (optional)
 *   #define DISSIPATIVE                     returns the energy lost to micro-slip and sliding (optional)
 *   #define COHESIONLESS                    does not support cohesion (optional)
 *   #define PREFETCH  ..._prefetch          function that prefetches the part of a row which the law reads (optional)
 *   #define USED  ..._used                  function that returns the number of doubles in use in a row (optional)
 *   #define VALID ..._valid                 function that tests whether doubles from a file are a valid row (optional)
 *   #define PIECES_OF  ..._pieces           function that returns the pieces of a history (optional)
 *   #define STAGED                          split into three functions, see law_stages.h (optional; for laws with rows)
 *   #define BRANCHING, NON_CONSERVATIVE, INCREMENTAL   (optional, see law.h)
 *
 * If a law has more than four doubles of history, m[0] is 0 when the history is empty, and the other doubles are then
 * undefined. Such a shear law is not called without contact; such a normal law is called with overlap 0 and m[0] = 0.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */

#define LAW_JOIN_(a, b) a##b
#define LAW_JOIN(a, b) LAW_JOIN_(a, b)
#define LAW_TEXT_(a) #a
#define LAW_TEXT(a) LAW_TEXT_(a)
#define LAW_FORMS(name) NB_FORMS(name)
#define LAW_LIST(name) NB_FORMS_LIST(name)
#define LAW_BLOCK LAW_JOIN(LAW, _block)
#define LAW_LOOP LAW_JOIN(LAW, _loop)

#ifndef NEEDS
#define NEEDS 0
#endif
#ifndef PIECES
#define PIECE 0
#define PIECES 0
#endif
#define LAW_ROWS (HISTORY + PIECE * PIECES > NB_HISTORY)

#ifdef NORMAL
#define LAW_HISTORY block->normal_history
#else
#define LAW_HISTORY block->shear_history
#endif

#ifdef STAGED
#include "law_stages.h"
#else
/* `counts`: the loop also stores the energy that each contact loses. The compiler makes two loops, because few runs
 * need this energy and its computation may be expensive. */
static inline NB_FORM void LAW_LOOP(const struct nb_block *block, bool counts) {
  (void)counts;
  /* The first member of a material pair is its struct nb_pair, so the cast is valid. */
  const struct nb_pair pair = *(const struct nb_pair *)block->material_pair;
  const double *overlap = block->f[NB_OVERLAP];
#ifdef ELASTIC
  const double *reduced = block->f[NB_REDUCED];
#endif
#ifdef NORMAL
  const double *dn = block->f[NEEDS & NB_BIT(NB_NORMAL_INCREMENT) ? NB_NORMAL_INCREMENT : NB_OVERLAP];
  double *force = block->f[NB_NORMAL], *stiffness = block->f[NB_STIFFNESS], *radius = block->f[NB_RADIUS];
#else
  const double *ds = block->f[NB_TANGENTIAL_INCREMENT], *normal = block->f[NB_NORMAL],
               *normal_stiffness = block->f[NB_STIFFNESS];
  const double *radius = block->f[NB_RADIUS];
  double *force = block->f[NB_SHEAR], *stiffness = block->f[NB_SHEAR_STIFFNESS], *sliding = block->f[NB_SLIDING];
  double *dissipated = block->f[NB_DISSIPATED];
#endif
#if LAW_ROWS
  double *rows = LAW_HISTORY.rows;
  const size_t row = (size_t)LAW_HISTORY.doubles;
#else
  double *const m0 = LAW_HISTORY.field[0], *const m1 = LAW_HISTORY.field[1];
  double *const m2 = LAW_HISTORY.field[2], *const m3 = LAW_HISTORY.field[3];
#endif
#ifndef BRANCHING
  NB_WIDE
#endif
  for (size_t c = 0; c < block->n; c++) {
    struct nb_pair p = pair;
#ifdef ELASTIC
    p.radius = reduced[c];
#endif
#if LAW_ROWS
    double *m = rows + c * row;
#ifdef PREFETCH
    if (c + 2 * NB_PREFETCH_DISTANCE < block->n)
      __builtin_prefetch(rows + (c + 2 * NB_PREFETCH_DISTANCE) * row, 1);
    if (c + NB_PREFETCH_DISTANCE < block->n)
      PREFETCH(rows + (c + NB_PREFETCH_DISTANCE) * row);
#endif
#else
    double m[NB_HISTORY];
    m[0] = HISTORY > 0 ? m0[c] : 0, m[1] = HISTORY > 1 ? m1[c] : 0, m[2] = HISTORY > 2 ? m2[c] : 0,
    m[3] = HISTORY > 3 ? m3[c] : 0;
#endif
    const bool touching = overlap[c] > 0; /* the history ends with the contact */
#if LAW_ROWS
    if (!touching)
      m[0] = 0;
#endif
#ifdef NORMAL
    const struct nb_normal out = LAW(p, overlap[c], dn[c], m);
    radius[c] = out.radius;
#else
    const struct nb_normal n = {
        .force = normal[c], .stiffness = normal_stiffness[c], .radius = radius[c], .overlap = overlap[c]};
#if LAW_ROWS
    const struct nb_shear out = touching ? LAW(p, n, ds[c], m) : (struct nb_shear){0};
#else
    const struct nb_shear out = LAW(p, n, ds[c], m);
#endif
    sliding[c] = out.sliding;
    if (counts)
      dissipated[c] = out.dissipated;
#endif
    force[c] = out.force;
    stiffness[c] = out.stiffness;
#if !LAW_ROWS
    if (HISTORY > 0)
      m0[c] = touching ? m[0] : 0;
    if (HISTORY > 1)
      m1[c] = touching ? m[1] : 0;
    if (HISTORY > 2)
      m2[c] = touching ? m[2] : 0;
    if (HISTORY > 3)
      m3[c] = touching ? m[3] : 0;
#endif
  }
}
#endif

static inline NB_FORM void LAW_BLOCK(const struct nb_model *model, const struct nb_block *block) {
  (void)model;
#ifdef DISSIPATIVE
  if (block->f[NB_DISSIPATED]) {
    LAW_LOOP(block, true);
    return;
  }
#endif
  LAW_LOOP(block, false);
}

LAW_FORMS(LAW_BLOCK)

extern const struct nb_law LAW_JOIN(law_, LAW);
const struct nb_law LAW_JOIN(law_, LAW) = {
#ifdef NORMAL
    .kind = "normal",
    .name = &LAW_TEXT(LAW)[sizeof "normal_" - 1],
    .normal = LAW,
#else
    .kind = "shear",
    .name = &LAW_TEXT(LAW)[sizeof "shear_" - 1],
    .shear = LAW,
#endif
#ifdef ELASTIC
    .elastic = true,
#endif
#ifdef CONSTANT
    .constant = true,
#endif
#ifdef BRANCHING
    .branching = true,
#endif
#ifdef COHESIONLESS
    .cohesionless = true,
#endif
#ifdef USED
    .used = USED,
#endif
#ifdef VALID
    .valid = VALID,
#endif
#ifdef PIECES_OF
    .pieces_of = PIECES_OF,
#endif
#ifdef DISSIPATIVE
    .dissipative = true,
#endif
#ifdef NON_CONSERVATIVE
    .non_conservative = true,
#endif
#ifdef INCREMENTAL
    .incremental = true,
#endif
#ifdef STORED
    .stored = STORED,
#endif
    .title = TITLE,
    .source = SOURCE,
    .parameters = PARAMETERS,
    .history = HISTORY,
    .piece = PIECE,
    .pieces = PIECES,
    .needs = NEEDS,
    .run = LAW_LIST(LAW_BLOCK),
};
