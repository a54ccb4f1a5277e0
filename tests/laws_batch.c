/* The forms of a law that go over a block of contacts: the same bits as the law itself, one contact at a time,
 * whatever the instruction set and the number of contacts; nothing is written past the end;
 * memory ends with the contact.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <stdlib.h>
#include <string.h>

#include "../src/model.h"
#include "chance.h"
#include "suites.h"

/* A law of the tests alone: it fills all the memory there is and never empties it, touching or not. */
static inline struct nb_shear shear_scribble(struct nb_pair p, struct nb_normal n, double slip, double m[]) {
  for (int k = 0; k < NB_MEMORY; k++)
    m[k] += (k + 1) * slip;
  return (struct nb_shear){
      .force = p.ks * (m[0] + m[NB_MEMORY - 1]) * n.radius, .stiffness = n.stiffness, .sliding = m[1]};
}
#define LAW shear_scribble
#define SHEAR
#define TITLE "scribbles into its memory"
#define SOURCE "-"
#define MEMORY 4
#define BRANCHING
#include "../src/laws/law_batch.h"

/* All of the register, then that one; NULL past the last. */
static const struct nb_law *law_number(int k) {
  for (const struct nb_law *const *law = nb_laws(); *law; law++, k--)
    if (k == 0)
      return *law;
  return k == 0 ? &law_shear_scribble : NULL;
}

enum { ROOM = NB_BLOCK + 8 }; /* what lies past the block is seen */

/* All that a law reads and writes, as the plan would lay it out. */
struct fields {
  _Alignas(64) double f[NB_FIELDS][ROOM];
  _Alignas(64) double memory[NB_MEMORY][ROOM];
};

static void fill(struct fields *fields, struct chance *chance) {
  for (size_t c = 0; c < ROOM; c++) {
    for (int f = 0; f < NB_FIELDS; f++)
      fields->f[f][c] = chance_between(chance, -1, 1);
    for (int m = 0; m < NB_MEMORY; m++)
      fields->memory[m][c] = chance_between(chance, -1, 1) * 1e-3;
    const bool touching = chance_between(chance, 0, 1) < 0.7;
    fields->f[NB_OVERLAP][c] = touching ? chance_scale(chance, 1e-9, 1e-2) : 0;
    fields->f[NB_NORMAL][c] = touching ? chance_scale(chance, 1e-6, 1e2) : 0;
    fields->f[NB_STIFFNESS][c] = touching ? chance_scale(chance, 1, 1e5) : 0;
    fields->f[NB_RADIUS][c] = touching ? chance_scale(chance, 1e-9, 1e-3) : 0;
    fields->f[NB_SLIP][c] = chance_between(chance, -1, 1) * chance_scale(chance, 1e-12, 1e-2);
    fields->f[NB_CLOSING][c] = chance_between(chance, -1, 1) * chance_scale(chance, 1e-12, 1e-2);
  }
}

/* One contact at a time, as law_batch.h promises. */
static void by_hand(const struct nb_law *law, const struct nb_pair *pair, struct fields *fields, size_t n) {
  for (size_t c = 0; c < n; c++) {
    double m[NB_MEMORY] = {0};
    for (int k = 0; k < law->memory; k++)
      m[k] = fields->memory[k][c];
    if (law->normal) {
      const struct nb_normal out = law->normal(*pair, fields->f[NB_OVERLAP][c], fields->f[NB_CLOSING][c], m);
      fields->f[NB_NORMAL][c] = out.force, fields->f[NB_STIFFNESS][c] = out.stiffness;
      fields->f[NB_RADIUS][c] = out.radius;
    } else {
      const struct nb_normal n_ = {fields->f[NB_NORMAL][c], fields->f[NB_STIFFNESS][c], fields->f[NB_RADIUS][c]};
      const struct nb_shear out = law->shear(*pair, n_, fields->f[NB_SLIP][c], m);
      fields->f[NB_SHEAR][c] = out.force, fields->f[NB_SHEAR_STIFFNESS][c] = out.stiffness;
      fields->f[NB_SLIDING][c] = out.sliding;
    }
    for (int k = 0; k < law->memory; k++)
      fields->memory[k][c] = fields->f[NB_OVERLAP][c] > 0 ? m[k] : 0;
  }
}

static void by_block(const struct nb_law *law, const struct nb_pairing *pairing, struct fields *fields, size_t n,
                     enum nb_isa isa) {
  struct nb_view view = {.n = n, .pairing = pairing};
  for (int f = 0; f < NB_FIELDS; f++)
    view.f[f] = fields->f[f];
  for (int m = 0; m < law->memory; m++) { /* the others are NULL, as the plan leaves them */
    if (law->normal)
      view.normal_memory[m] = fields->memory[m];
    else
      view.shear_memory[m] = fields->memory[m];
  }
  law->run[isa](NULL, &view);
}

static bool runs_here(enum nb_isa isa) {
#if defined __x86_64__ && defined __GNUC__
  if (isa == NB_AVX512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
  if (isa == NB_AVX2)
    return __builtin_cpu_supports("avx2");
#endif
  return true;
}

static void same_bits(void) {
  static const size_t sizes[] = {0, 1, 7, 8, 9, 255, 256};
  static const char *const isas[] = {"plain", "avx2", "avx512"};
  static struct fields given, wanted, seen; /* too large for some stacks */
  struct chance chance = chance_begin(2);
  const struct nb_law *law;
  for (int l = 0; (law = law_number(l)) != NULL; l++)
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
      const struct nb_pairing pairing = {
          .values = {.kn = 1e5, .ks = 7e4, .friction = 0.4, .cohesion = k % 2 ? 1e-3 : 0}};
      fill(&given, &chance);
      wanted = given;
      by_hand(law, &pairing.values, &wanted, sizes[k]);
      for (enum nb_isa isa = NB_PLAIN; isa < NB_ISAS; isa = (enum nb_isa)(isa + 1)) {
        if (!runs_here(isa))
          continue;
        seen = given;
        by_block(law, &pairing, &seen, sizes[k], isa);
        const bool same = memcmp(&seen, &wanted, sizeof seen) == 0;
        if (!same)
          printf("# %s %s differs, %zu contacts, %s\n", law->kind, law->name, sizes[k], isas[isa]);
        CU_ASSERT(same);
      }
    }
}

static void memory_ends_with_the_contact(void) {
  static struct fields fields;
  struct chance chance = chance_begin(3);
  const struct nb_pairing pairing = {.values = {.kn = 1e5, .ks = 7e4, .friction = 0.4, .cohesion = 1}};
  const struct nb_law *law;
  for (int l = 0; (law = law_number(l)) != NULL; l++) {
    fill(&fields, &chance);
    by_block(law, &pairing, &fields, NB_BLOCK, NB_PLAIN);
    int ended = 0, lasting = 0;
    for (size_t c = 0; c < NB_BLOCK; c++)
      for (int m = 0; m < law->memory; m++) {
        if (!(fields.f[NB_OVERLAP][c] > 0))
          CU_ASSERT_EQUAL(fields.memory[m][c], 0);
        ended += !(fields.f[NB_OVERLAP][c] > 0), lasting += fields.memory[m][c] != 0;
      }
    if (law->memory > 0)
      CU_ASSERT(ended > 0 && lasting > 0);
  }
}

void suite_laws_batch(void) {
  CU_pSuite suite = CU_add_suite("laws_batch", NULL, NULL);
  CU_add_test(suite, "same bits as one contact at a time", same_bits);
  CU_add_test(suite, "memory ends with the contact", memory_ends_with_the_contact);
}
