/* The loop of a law in three stages, for a law with a long row of history per contact. The first stage reads the row,
 * and resets parts of it where needed. The third one writes the result of the step. Both need branches. The second
 * stage, the computation, needs none, so its loop vectorises. Each stage is a loop over so few contacts that the parts of their rows which the law uses fit into the
 * first-level cache. The law's file defines
 *
 *   #define STAGED
 *   #define FETCHED  struct fetched         of doubles: what the first stage reads from the row
 *   #define SOLVED   struct piece           of doubles: the result of the second stage
 *
 *   FETCHED         LAW_fetch(p, n, m)
 *   struct nb_shear LAW_solve(p, n, ds, fetched, &solved)               straight-line (law.h); does not set `sliding`
 *   void            LAW_store(p, n, ds, m, solved, &out, counts)        may set out.sliding and replace out.force; if
 *                                                                       `counts`, computes the energy lost
 *
 * This file defines the function LAW, which calls the three in sequence.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */

#define LAW_FETCH LAW_JOIN(LAW, _fetch)
#define LAW_SOLVE LAW_JOIN(LAW, _solve)
#define LAW_STORE LAW_JOIN(LAW, _store)

static struct nb_shear LAW(struct nb_pair p, struct nb_normal n, double ds, double m[]) {
  SOLVED solved;
  struct nb_shear out = LAW_SOLVE(p, n, ds, LAW_FETCH(p, n, m), &solved);
  LAW_STORE(p, n, ds, m, solved, &out, true);
  return out;
}

/* In a block, a struct of doubles is stored as one array per member, so that the second loop vectorises. */
enum {
  LAW_STAGE = 32, /* contacts; more would not fit into the first-level cache */
  LAW_FETCHED = sizeof(FETCHED) / sizeof(double),
  LAW_SOLVED = sizeof(SOLVED) / sizeof(double)
};
union law_fetched {
  FETCHED it;
  double v[LAW_FETCHED];
};
union law_solved {
  SOLVED it;
  double v[LAW_SOLVED];
};

static inline NB_FORM void LAW_LOOP(const struct nb_block *block, bool counts) {
  /* The first member of a material pair is its struct nb_pair, so the cast is valid. */
  const struct nb_pair pair = *(const struct nb_pair *)block->material_pair;
  const double *overlap = block->f[NB_OVERLAP], *reduced = block->f[NB_REDUCED],
               *ds = block->f[NB_TANGENTIAL_INCREMENT];
  const double *normal = block->f[NB_NORMAL], *normal_stiffness = block->f[NB_STIFFNESS], *radius = block->f[NB_RADIUS];
  double *force = block->f[NB_SHEAR], *stiffness = block->f[NB_SHEAR_STIFFNESS], *sliding = block->f[NB_SLIDING];
  double *dissipated = block->f[NB_DISSIPATED], *rows = LAW_HISTORY.rows;
  const size_t row = (size_t)LAW_HISTORY.doubles;
  _Alignas(64) double found[LAW_FETCHED][LAW_STAGE], solved[LAW_SOLVED][LAW_STAGE];
#define LAW_GIVEN(c)                                                                                                   \
  struct nb_pair p = pair;                                                                                             \
  p.radius = reduced[c];                                                                                               \
  const struct nb_normal n = {                                                                                         \
    .force = normal[c],                                                                                                \
    .stiffness = normal_stiffness[c],                                                                                  \
    .radius = radius[c],                                                                                               \
    .overlap = overlap[c]                                                                                              \
  }
  for (size_t first = 0; first < block->n; first += LAW_STAGE) {
    const size_t end = first + LAW_STAGE < block->n ? first + LAW_STAGE : block->n;
    for (size_t c = first; c < end; c++) {
      LAW_GIVEN(c);
      double *m = &rows[c * row];
      const size_t soon = c + NB_PREFETCH_DISTANCE, later = soon + NB_PREFETCH_DISTANCE;
      __builtin_prefetch(&rows[later * row], 1); /* harmless if this row is beyond the block */
      if (soon < block->n)
        PREFETCH(&rows[soon * row]);
      union law_fetched f;
      if (overlap[c] > 0)
        f.it = LAW_FETCH(p, n, m);
      else
        f.it = (FETCHED){0}, m[0] = 0;
      NB_UNROLLED
      for (int k = 0; k < LAW_FETCHED; k++)
        found[k][c - first] = f.v[k];
    }
    NB_WIDE
    for (size_t c = first; c < end; c++) {
      LAW_GIVEN(c);
      union law_fetched f;
      NB_UNROLLED
      for (int k = 0; k < LAW_FETCHED; k++)
        f.v[k] = found[k][c - first];
      union law_solved s;
      const struct nb_shear out = LAW_SOLVE(p, n, ds[c], f.it, &s.it);
      NB_UNROLLED
      for (int k = 0; k < LAW_SOLVED; k++)
        solved[k][c - first] = s.v[k];
      const bool touching = overlap[c] > 0;
      force[c] = touching ? out.force : 0;
      stiffness[c] = touching ? out.stiffness : 0;
    }
    for (size_t c = first; c < end; c++) {
      LAW_GIVEN(c);
      struct nb_shear out = {.force = force[c], .dissipated = 0};
      if (overlap[c] > 0) {
        union law_solved s;
        NB_UNROLLED
        for (int k = 0; k < LAW_SOLVED; k++)
          s.v[k] = solved[k][c - first];
        LAW_STORE(p, n, ds[c], &rows[c * row], s.it, &out, counts);
        force[c] = out.force;
      }
      sliding[c] = out.sliding;
      if (counts)
        dissipated[c] = out.dissipated;
    }
  }
#undef LAW_GIVEN
}
