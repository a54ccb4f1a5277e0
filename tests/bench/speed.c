/* Measures contact updates per second of a dense triangular lattice of discs in a box that is compressed: with
 * friction, with friction and dashpots of the coefficient beta k, and with neither. The sizes of the lattice fit into
 * different caches. Each size runs with all instruction sets of this machine, on one thread and on two; the medians of
 * five runs are printed. A contact update is one cycle of one pair of the neighbour list, including the motion of the
 * particles.
 *
 * This is not a test: it prints, and fails only if there is not enough memory. Compare only columns of one run.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "nineball.h"

enum { RUNS = 5 };

static void make_scene(struct nb_scene *scene, int side, double friction, double beta, unsigned long cycles) {
  const double radius = 50, width = 2 * radius * side + radius, height = 2 * radius + sqrt(3) * radius * (side - 1);
  *scene = (struct nb_scene){.unitless = true, .material_count = 1, .wall_count = 4, .stage_count = 1};
  scene->particle_count = (size_t)side * (size_t)side;
  scene->materials = calloc(1, sizeof *scene->materials);
  scene->particles = calloc(scene->particle_count, sizeof *scene->particles);
  scene->walls = calloc(4, sizeof *scene->walls);
  scene->stages = calloc(1, sizeof *scene->stages);
  if (!scene->materials || !scene->particles || !scene->walls || !scene->stages)
    exit(NB_BROKEN);
  scene->materials[0] = (struct nb_material){.density = 1000, .kn = 1.35e9, .ks = 1.35e9, .friction = friction};
  for (int k = 0; k < side * side; k++)
    scene->particles[k] = (struct nb_particle){.x = radius + 2 * radius * (k % side) + (k / side % 2 ? radius : 0),
                                               .y = radius + sqrt(3) * radius * (k / side),
                                               .radius = radius};
  const double v = 1 / (0.0076 * (double)cycles); /* the step is 0.0076, so each wall moves by 1 in all cycles */
  scene->walls[0] = (struct nb_wall){.x = width / 2, .ex = 1, .h1 = -width / 2, .h2 = width / 2, .vy = v};
  scene->walls[1] =
      (struct nb_wall){.x = width, .y = height / 2, .ey = 1, .h1 = -height / 2, .h2 = height / 2, .vx = -v};
  scene->walls[2] =
      (struct nb_wall){.x = width / 2, .y = height, .ex = -1, .h1 = -width / 2, .h2 = width / 2, .vy = -v};
  scene->walls[3] = (struct nb_wall){.y = height / 2, .ey = -1, .h1 = -height / 2, .h2 = height / 2, .vx = v};
  strcpy(scene->normal, "linear");
  strcpy(scene->shear, "linear");
  scene->step = (struct nb_step){.kind = NB_STEP_SINGLE_CONTACT, .value = 0.05};
  if (beta > 0)
    scene->damping = (struct nb_damping){.contact_kind = NB_CONTACT_STIFFNESS, .contact = beta, .contact_line = 1};
  scene->stages[0] = (struct nb_stage){
      .name = "squeeze", .cycles = cycles, .snapshot_from = -1, .step = scene->step, .damping = scene->damping};
}

static int by_size(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Millions of contact updates per second; -1 if this machine lacks the instruction set. */
static double measure(const struct nb_scene *scene, const char *isa, int threads) {
  double rates[RUNS];
  for (int k = 0; k < RUNS; k++) {
    struct nb_result result;
    struct nb_error error;
    const struct nb_options options = {.threads = threads, .isa = isa};
    const enum nb_status status = nb_run(&result, scene, &options, NULL, &error);
    rates[k] = status ? -1 : 1e-6 * (double)result.updates / result.seconds;
    nb_result_free(&result);
  }
  qsort(rates, RUNS, sizeof *rates, by_size);
  return rates[RUNS / 2];
}

int main(void) {
  static const char *const isas[] = {"plain", "avx2", "avx512"};
  static const int sides[] = {3, 32, 100, 316};
  static const struct {
    const char *name;
    double friction, beta; /* 1, s */
  } kinds[] = {{"yes", 1, 0}, {"dashpots", 1, 1e-4}, {"none", 0, 0}};
  puts("million contact updates a second, median of five");
  printf("%8s %9s", "discs", "friction");
  for (int isa = 0; isa < 3; isa++)
    printf(" %8s x1 %8s x2", isas[isa], isas[isa]);
  putchar('\n');
  for (size_t s = 0; s < sizeof sides / sizeof *sides; s++)
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
      struct nb_scene scene;
      const double contacts = 3.0 * sides[s] * sides[s];
      make_scene(&scene, sides[s], kinds[k].friction, kinds[k].beta, (unsigned long)(4e6 / contacts) + 1);
      printf("%8d %9s", sides[s] * sides[s], kinds[k].name);
      for (int isa = 0; isa < 3; isa++)
        for (int threads = 1; threads <= 2; threads++) {
          printf(" %11.1f", measure(&scene, isas[isa], threads));
          fflush(stdout);
        }
      putchar('\n');
      nb_scene_free(&scene);
    }
  return 0;
}
