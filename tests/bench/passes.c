/* Measures the passes of a cycle one by one. The page runs for some cycles; then each pass is repeated alone on the
 * arrays of the run, and the least time of all repeats is taken, which other programs hardly disturb. The sums of
 * forces and the integration of motion are measured together. The whole cycle, without searches, is measured too.
 *
 *   tests/bench/passes PAGE [ISA]
 *
 * Prints a line for each pass: its name, and the clock cycles of the processor per contact. The duration of a clock
 * cycle is measured in the same process, by a chain of dependent additions. This is not a test: it checks
 * nothing. It fails only for wrong arguments, and for a page that does not run or has no contacts.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "core/model.h"
#include "run/plan.h"

enum { CYCLES = 200, REPEATS = 1000, CHAIN = 100000 };

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void fail(const char *text) {
  fprintf(stderr, "passes: %s\n", text);
  exit(NB_BROKEN);
}

/* The time of a clock cycle, s: the least of many chains of dependent additions. */
static double clock_cycle(void) {
  double least = 1;
  for (int r = 0; r < REPEATS; r++) {
    unsigned long x = 1, y = 3;
    __asm__ volatile("" : "+r"(y));
    const double start = now();
    /* Without unrolling, the branches may take more clock cycles than the additions. */
    _Pragma("GCC unroll 16") for (int s = 0; s < CHAIN; s++) {
      x += y;
      __asm__ volatile("" : "+r"(x));
    }
    const double time = now() - start;
    least = time < least ? time : least;
  }
  return least / CHAIN;
}

/* What is repeated: a cycle without a search, all passes of block after block, the motion, or one pass (its index) of
 * all blocks. */
enum { CYCLE = -3, ALL_PASSES, MOTION };

static void once(struct nb_model *model, int which) {
  struct nb_error error;
  if (which == MOTION)
    nb_motion_part(model, 0, 1);
  else if (which == ALL_PASSES)
    nb_forces(model);
  else if (which == CYCLE) {
    if (nb_cycle(model, &error))
      fail(error.text);
  } else
    for (size_t v = 0; v < model->blocks.count; v++) {
      const struct nb_block *block = &model->blocks.list[v];
      if (which < block->material_pair->pass_count)
        block->material_pair->passes[which].run(model, block);
    }
}

static void measure(struct nb_model *model, int which, const char *name, double clock) {
  double least = 1;
  for (int r = 0; r < REPEATS; r++) {
    const double start = now();
    once(model, which);
    const double time = now() - start;
    least = time < least ? time : least;
  }
  printf("%-50s %7.2f\n", name, least / clock / (double)model->contacts.count);
}

int main(int argc, char *argv[]) {
  struct nb_page page;
  struct nb_scene scene;
  struct nb_mistakes mistakes = {0};
  struct nb_error error = {0};
  if (argc < 2 || argc > 3)
    fail("usage: passes PAGE [ISA]");
  const struct nb_options options = {.threads = 1, .isa = argv[2]};
  if (nb_page_read(&page, argv[1], &mistakes) || nb_scene_read(&scene, &page, 0, NULL, &mistakes))
    fail(mistakes.text);
  struct nb_model *model = nb_model_create(&scene, &options, &error);
  if (!model || nb_stage_begin(model, &scene.stages[0], &error))
    fail(error.text);
  if (model->blocks.count == 0)
    fail("the page has no contacts");
  for (int k = 0; k < CYCLES; k++)
    once(model, CYCLE);
  const double clock = clock_cycle();
  fprintf(stderr, "%.2f GHz, %zu contacts, %zu particles\n", 1e-9 / clock, model->contacts.count,
          model->particles.count);
  measure(model, CYCLE, "cycle", clock);
  measure(model, ALL_PASSES, "all passes", clock);
  const struct nb_material_pair *pair = model->blocks.list[0].material_pair;
  for (int p = 0; p < pair->pass_count; p++)
    measure(model, p, pair->passes[p].name, clock);
  measure(model, MOTION, "motion", clock);
  nb_model_free(model);
  nb_scene_free(&scene);
  nb_page_free(&page);
  nb_mistakes_free(&mistakes);
  return 0;
}
