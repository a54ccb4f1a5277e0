/* Measures the cost of shear laws: spheres in a box, a dense triangular lattice that is compressed by 1e-4 of the
 * diameter and shaken. Contacts load and unload, stick, slip partly and slide, and a few open. Prints for each shear
 * law, in two sizes, the nanoseconds of a contact update, the millions of updates per second, and the time over that of
 * the law `mindlin`. A contact update is one cycle of one pair of the neighbour list, including the motion of the
 * particles.
 *
 * Times are processor times, and each is the median of eleven runs. The laws take turns, so other processes affect all
 * of them equally. This is not a test: compare the ratios of one run.
 *
 *   tests/bench/laws [ISA [LAW]]
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../chance.h"
#include "laws/law.h"

enum { RUNS = 11, LAWS_MAX = 64 };

static struct nb_wall wall(double x, double y, double ex, double ey, double half) {
  return (struct nb_wall){.x = x, .y = y, .ex = ex, .ey = ey, .h1 = -half, .h2 = half};
}

static void make_scene(struct nb_scene *scene, int side, const char *shear, unsigned long cycles) {
  const double radius = 5e-3, overlap = 1e-6, pitch = 2 * radius - overlap; /* m */
  const double width = pitch * side + pitch / 2, height = 2 * radius - overlap + sqrt(0.75) * pitch * (side - 1);
  const double young = 70e9, poisson = 0.22, density = 2500, mass = density * 4.18879 * radius * radius * radius;
  const double stiffness = young / (1 - poisson * poisson) * sqrt(radius / 2 * overlap); /* 2 E* a */
  const double rate = sqrt(stiffness / mass), speed = 0.5 * overlap * rate;
  struct chance chance = chance_begin(9);
  *scene = (struct nb_scene){.material_count = 1, .wall_count = 4, .stage_count = 1};
  scene->particle_count = (size_t)side * (size_t)side;
  scene->materials = calloc(1, sizeof *scene->materials);
  scene->particles = calloc(scene->particle_count, sizeof *scene->particles);
  scene->walls = calloc(4, sizeof *scene->walls);
  scene->stages = calloc(1, sizeof *scene->stages);
  if (!scene->materials || !scene->particles || !scene->walls || !scene->stages)
    exit(NB_BROKEN);
  scene->materials[0] = (struct nb_material){
      .density = density, .kn = stiffness, .ks = 0.8 * stiffness, .young = young, .poisson = poisson, .friction = 0.3};
  for (int k = 0; k < side * side; k++)
    scene->particles[k] = (struct nb_particle){.shape = NB_SPHERE,
                                               .x = pitch / 2 + pitch * (k % side) + (k / side % 2 ? pitch / 2 : 0),
                                               .y = pitch / 2 + sqrt(0.75) * pitch * (k / side),
                                               .radius = radius,
                                               .vx = speed * chance_between(&chance, -1, 1),
                                               .vy = speed * chance_between(&chance, -1, 1),
                                               .spin = speed / radius * chance_between(&chance, -1, 1)};
  scene->walls[0] = wall(width / 2, 0, 1, 0, width / 2);
  scene->walls[1] = wall(width, height / 2, 0, 1, height / 2);
  scene->walls[2] = wall(width / 2, height, -1, 0, width / 2);
  scene->walls[3] = wall(0, height / 2, 0, -1, height / 2);
  snprintf(scene->normal, sizeof scene->normal, "hertz");
  snprintf(scene->shear, sizeof scene->shear, "%s", shear);
  scene->step = (struct nb_step){NB_STEP_TIME, 0.1 / rate, 0, false};
  scene->allow_unstable = true;
  scene->stages[0] = (struct nb_stage){
      .name = "shake", .cycles = cycles, .snapshot_from = -1, .step = scene->step, .allow_unstable = true};
}

static int by_size(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* The time of a contact update, ns. */
static double measure(int side, const char *shear, const char *isa) {
  struct nb_scene scene;
  struct nb_result result;
  struct nb_error error;
  const struct nb_options options = {.threads = 1, .isa = isa};
  make_scene(&scene, side, shear, (unsigned long)(1e7 / (3.0 * side * side)) + 1);
  const clock_t start = clock();
  if (nb_run(&result, &scene, &options, NULL, &error)) {
    fprintf(stderr, "shear %s: %s\n", shear, error.text);
    exit(NB_BROKEN);
  }
  const double ns = 1e9 * (double)(clock() - start) / CLOCKS_PER_SEC / (double)result.updates;
  nb_result_free(&result);
  nb_scene_free(&scene);
  return ns;
}

static void compare(int side, const char *isa, const char *only) {
  const char *laws[LAWS_MAX];
  double ns[LAWS_MAX][RUNS];
  int count = 0, base = 0;
  for (const struct nb_law *const *law = nb_laws(); *law && count < LAWS_MAX; law++)
    if ((*law)->shear && (!only || strcmp((*law)->name, only) == 0 || strcmp((*law)->name, "mindlin") == 0))
      laws[count++] = (*law)->name;
  for (int run = 0; run < RUNS; run++)
    for (int k = 0; k < count; k++)
      ns[k][run] = measure(side, laws[k], isa);
  for (int k = 0; k < count; k++) {
    qsort(ns[k], RUNS, sizeof(double), by_size);
    base = strcmp(laws[k], "mindlin") == 0 ? k : base;
  }
  for (int k = 0; k < count; k++) {
    const double median = ns[k][RUNS / 2];
    printf("%8d %20s %8.2f %8.1f %8.2f\n", side * side, laws[k], median, 1e3 / median, median / ns[base][RUNS / 2]);
  }
  fflush(stdout);
}

int main(int argc, char **argv) {
  static const int sides[] = {32, 100};
  const char *isa = argc > 1 && strcmp(argv[1], "widest") != 0 ? argv[1] : NULL, *only = argc > 2 ? argv[2] : NULL;
  printf("%8s %20s %8s %8s %8s\n", "spheres", "shear", "ns", "M/s", "mindlin");
  for (size_t s = 0; s < sizeof sides / sizeof *sides; s++)
    compare(sides[s], isa, only);
  return 0;
}
