/* The batch forms of a law compute a block of contacts. They must give the same bits as the law computed for one
 * contact at a time, with every instruction set and every number of contacts. They must write nothing past the last
 * contact of the block. When a contact opens, they must reset its history.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../src/core/model.h"
#include "chance.h"
#include "laws/laws_now.h"
#include "suites.h"

/* A law for these tests only: it writes to all history slots and never resets them, whether the particles touch or
 * not. */
static inline struct nb_shear shear_scribble(struct nb_pair p, struct nb_normal n, double slip, double m[]) {
  for (int k = 0; k < NB_HISTORY; k++)
    m[k] += (k + 1) * slip;
  return (struct nb_shear){
      .force = p.ks * (m[0] + m[NB_HISTORY - 1]) * n.radius, .stiffness = n.stiffness, .sliding = m[1]};
}
#define LAW shear_scribble
#define SHEAR
#define TITLE "writes to its whole history"
#define SOURCE "-"
#define PARAMETERS ""
#define HISTORY 4
#define BRANCHING
#include "../src/laws/law_batch.h"

/* Law number k: the registered laws, then shear_scribble; NULL after the last. */
static const struct nb_law *law_number(int k) {
  for (const struct nb_law *const *law = nb_laws(); *law; law++, k--)
    if (k == 0)
      return *law;
  return k == 0 ? &law_shear_scribble : NULL;
}

enum { ROOM = NB_BLOCK_SIZE + 8 }; /* more than a block, to detect writes past its end */

enum { MOST = 16 + 5 * 64 }; /* doubles per contact of a law with more than NB_HISTORY history variables */

/* Fills a row with random numbers. If the law keeps its history in rows, the row then gets a random history, which the
 * law itself makes. */
static void row_of_chance(double *row, const struct nb_law *law, struct nb_pair pair, struct chance *chance) {
  row[0] = 0;
  for (int m = 1; m < MOST; m++)
    row[m] = chance_between(chance, -1, 1);
  pair.radius = 1e-2;
  for (int k = 0; nb_law_history(law, pair) > NB_HISTORY && k < 6; k++) {
    struct nb_normal n = {.overlap = chance_scale(chance, 1e-9, 1e-3)};
    n.radius = sqrt(pair.radius * n.overlap), n.stiffness = 2 * pair.young * n.radius;
    n.force = n.stiffness * n.overlap / 1.5;
    law->shear(pair, n, chance_between(chance, -1, 1) * n.overlap, row);
  }
}

/* All fields that a law reads and writes, in the layout of the plan. */
struct fields {
  _Alignas(64) double f[NB_FIELDS][ROOM];
  _Alignas(64) double memory[NB_HISTORY][ROOM];
  double rows[ROOM][MOST]; /* for laws with more than NB_HISTORY history variables */
};

static void fill(struct fields *fields, const struct nb_law *law, struct nb_pair pair, struct chance *chance) {
  for (size_t c = 0; c < ROOM; c++) {
    for (int f = 0; f < NB_FIELDS; f++)
      fields->f[f][c] = chance_between(chance, -1, 1);
    for (int m = 0; m < NB_HISTORY; m++)
      fields->memory[m][c] = chance_between(chance, -1, 1) * 1e-3;
    fields->f[NB_REDUCED][c] = chance_scale(chance, 1e-4, 1e-1);
    row_of_chance(fields->rows[c], law, pair, chance);
    const bool touching = chance_between(chance, 0, 1) < 0.7;
    fields->f[NB_OVERLAP][c] = touching ? chance_scale(chance, 1e-9, 1e-2) : 0;
    fields->f[NB_NORMAL][c] = touching ? chance_scale(chance, 1e-6, 1e2) : 0;
    fields->f[NB_STIFFNESS][c] = touching ? chance_scale(chance, 1, 1e5) : 0;
    fields->f[NB_RADIUS][c] = touching ? chance_scale(chance, 1e-9, 1e-3) : 0;
    fields->f[NB_TANGENTIAL_INCREMENT][c] = chance_between(chance, -1, 1) * chance_scale(chance, 1e-12, 1e-2);
    fields->f[NB_NORMAL_INCREMENT][c] = chance_between(chance, -1, 1) * chance_scale(chance, 1e-12, 1e-2);
  }
}

/* Computes one contact at a time, as law_batch.h specifies. */
static void by_hand(const struct nb_law *law, struct nb_pair pair, struct fields *fields, size_t n) {
  const bool rows = nb_law_history(law, pair) > NB_HISTORY;
  for (size_t c = 0; c < n; c++) {
    const bool touching = fields->f[NB_OVERLAP][c] > 0;
    double own[NB_HISTORY] = {0}, *m = rows ? fields->rows[c] : own;
    for (int k = 0; k < law->history && !rows; k++)
      m[k] = fields->memory[k][c];
    pair.radius = fields->f[NB_REDUCED][c];
    if (law->normal) {
      const struct nb_normal out = law->normal(pair, fields->f[NB_OVERLAP][c], fields->f[NB_NORMAL_INCREMENT][c], m);
      fields->f[NB_NORMAL][c] = out.force, fields->f[NB_STIFFNESS][c] = out.stiffness;
      fields->f[NB_RADIUS][c] = out.radius;
    } else {
      const struct nb_normal n_ = {.force = fields->f[NB_NORMAL][c],
                                   .stiffness = fields->f[NB_STIFFNESS][c],
                                   .radius = fields->f[NB_RADIUS][c],
                                   .overlap = fields->f[NB_OVERLAP][c]};
      struct nb_shear out = {0};
      if (touching || !rows)
        out = law->shear(pair, n_, fields->f[NB_TANGENTIAL_INCREMENT][c], m);
      fields->f[NB_SHEAR][c] = out.force, fields->f[NB_SHEAR_STIFFNESS][c] = out.stiffness;
      fields->f[NB_SLIDING][c] = out.sliding;
      if (law->dissipative)
        fields->f[NB_DISSIPATED][c] = out.dissipated;
    }
    for (int k = 0; k < law->history && !rows; k++)
      fields->memory[k][c] = touching ? m[k] : 0;
    if (rows && !touching)
      m[0] = 0;
  }
}

/* Computes n contacts as one block with an instruction set. If `counts`, the block requests the dissipation. */
static void by_block(const struct nb_law *law, const struct nb_material_pair *material_pair, struct fields *fields,
                     size_t n, enum nb_isa isa, bool counts) {
  struct nb_block block = {.n = n, .material_pair = material_pair};
  for (int f = 0; f < NB_FIELDS; f++)
    block.f[f] = fields->f[f];
  if (!counts)
    block.f[NB_DISSIPATED] = NULL; /* the block does not request it */
  struct nb_history *memory = law->normal ? &block.normal_history : &block.shear_history;
  memory->doubles = nb_law_history(law, material_pair->values);
  if (memory->doubles > NB_HISTORY)
    memory->doubles = MOST, memory->rows = fields->rows[0];
  for (int m = 0; m < memory->doubles && !memory->rows; m++) /* the other fields are NULL, as in a plan */
    memory->field[m] = fields->memory[m];
  law->run[isa](NULL, &block);
}

static bool runs_here(enum nb_isa isa) {
#if defined __x86_64__ && defined __GNUC__
  if (isa == NB_AVX512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
  if (isa == NB_AVX2)
    return __builtin_cpu_supports("avx2");
#endif
  return true;
}

static void same_bits(void) {
  static const size_t sizes[] = {0, 1, 7, 8, 9, NB_BLOCK_SIZE - 1, NB_BLOCK_SIZE};
  static const char *const isas[] = {"plain", "avx2", "avx512"};
  static struct fields given, wanted, seen; /* too large for some stacks */
  struct chance chance = chance_begin(2);
  const struct nb_law *law;
  for (int l = 0; (law = law_number(l)) != NULL; l++)
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
      const struct nb_material_pair material_pair = {.values = {.kn = 1e5,
                                                                .ks = 7e4,
                                                                .friction = 0.4,
                                                                .cohesion = k % 2 ? 1e-3 : 0,
                                                                .young = 1e9,
                                                                .shear = 3e8,
                                                                .pieces = law->pieces}};
      fill(&given, law, material_pair.values, &chance);
      wanted = given;
      by_hand(law, material_pair.values, &wanted, sizes[k]);
      for (int form = 0; form < 2 * NB_ISAS; form++) {
        const enum nb_isa isa = (enum nb_isa)(form / 2);
        const bool counts = form % 2;
        if (!runs_here(isa))
          continue;
        seen = given;
        by_block(law, &material_pair, &seen, sizes[k], isa, counts);
        if (!counts) {
          CU_ASSERT(memcmp(seen.f[NB_DISSIPATED], given.f[NB_DISSIPATED], sizeof seen.f[NB_DISSIPATED]) == 0);
          memcpy(seen.f[NB_DISSIPATED], wanted.f[NB_DISSIPATED], sizeof seen.f[NB_DISSIPATED]);
        }
        const bool same = memcmp(&seen, &wanted, sizeof seen) == 0;
        if (!same)
          printf("# %s %s differs, %zu contacts, %s\n", law->kind, law->name, sizes[k], isas[isa]);
        CU_ASSERT(same);
      }
    }
}

static void history_ends_with_the_contact(void) {
  static struct fields fields;
  struct chance chance = chance_begin(3);
  const struct nb_law *law;
  for (int l = 0; (law = law_number(l)) != NULL; l++) {
    const struct nb_material_pair material_pair = {
        .values = {
            .kn = 1e5, .ks = 7e4, .friction = 0.4, .cohesion = 1, .young = 1e9, .shear = 3e8, .pieces = law->pieces}};
    const bool rows = nb_law_history(law, material_pair.values) > NB_HISTORY;
    fill(&fields, law, material_pair.values, &chance);
    by_block(law, &material_pair, &fields, NB_BLOCK_SIZE, NB_PLAIN, true);
    int ended = 0, lasting = 0;
    for (size_t c = 0; c < NB_BLOCK_SIZE; c++)
      for (int m = 0; m < (rows ? 1 : law->history); m++) {
        const double kept = rows ? fields.rows[c][0] : fields.memory[m][c];
        if (!(fields.f[NB_OVERLAP][c] > 0))
          CU_ASSERT_EQUAL(kept, 0);
        ended += !(fields.f[NB_OVERLAP][c] > 0), lasting += kept != 0;
      }
    if (law->history > 0)
      CU_ASSERT(ended > 0 && lasting > 0);
  }
}

void suite_laws_batch(void) {
  CU_pSuite suite = CU_add_suite("laws_batch", NULL, NULL);
  CU_add_test(suite, "same bits as one contact at a time", same_bits);
  CU_add_test(suite, "the history ends with the contact", history_ends_with_the_contact);
}
