/* What a shear law costs: contact updates a second of a dense packing of elastic spheres, Hertz's contact with one shear law
 * after the other, on one core. A triangular packing a little too large for its box; every sphere sets out with a chance velocity
 * and spin, so that contacts load and unload, stick, slip a little and slide, and a few part. A contact update is one listed
 * contact through one whole cycle, the motion of the bodies included. In seconds of the processor, the best of several rounds in
 * each of which every law has its turn: what else runs on the machine disturbs that least. Compare columns of one run.
 *
 * Not a test: it prints, and never fails.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../chance.h"
#include "nineball.h"

enum { ROUNDS = 7, LAWS = 4 };

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
  scene->body_count = (size_t)side * (size_t)side;
  scene->materials = calloc(1, sizeof *scene->materials);
  scene->bodies = calloc(scene->body_count, sizeof *scene->bodies);
  scene->walls = calloc(4, sizeof *scene->walls);
  scene->stages = calloc(1, sizeof *scene->stages);
  if (!scene->materials || !scene->bodies || !scene->walls || !scene->stages)
    exit(NB_BROKEN);
  scene->materials[0] = (struct nb_material){
      .density = density, .kn = stiffness, .ks = 0.8 * stiffness, .young = young, .poisson = poisson, .friction = 0.3};
  for (int k = 0; k < side * side; k++)
    scene->bodies[k] = (struct nb_body){.shape = NB_SPHERE,
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
  strcpy(scene->normal, strcmp(shear, "linear") == 0 ? "linear" : "hertz");
  strcpy(scene->shear, shear);
  scene->step = (struct nb_step){NB_STEP_TIME, 0.1 / rate, 0, false};
  scene->allow_unstable = true;
  scene->stages[0] = (struct nb_stage){.name = "shake", .cycles = cycles, .step = scene->step, .allow_unstable = true};
}

/* Millions of updates in a second of the processor; below 0 when it cannot be run. */
static double measure(int side, const char *shear, const char *isa) {
  struct nb_scene scene;
  struct nb_result result;
  struct nb_error error;
  const struct nb_options options = {.threads = 1, .isa = isa};
  make_scene(&scene, side, shear, (unsigned long)(1e7 / (3.0 * side * side)) + 1);
  const clock_t start = clock();
  const enum nb_status status = nb_run(&result, &scene, &options, NULL, &error);
  const double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
  const double rate = status ? -1 : 1e-6 * (double)result.updates / seconds;
  nb_result_free(&result);
  nb_scene_free(&scene);
  return rate;
}

int main(void) {
  static const char *const laws[LAWS] = {"linear", "none", "mindlin", "mindlin_deresiewicz"};
  static const int sides[] = {32, 100};
  puts("million contact updates in a second of one core, best of several");
  printf("%8s %8s", "spheres", "isa");
  for (int l = 0; l < LAWS; l++)
    printf(" %20s", laws[l]);
  printf(" %20s\n", "mindlin by the exact");
  for (size_t s = 0; s < sizeof sides / sizeof *sides; s++)
    for (int isa = 0; isa < 2; isa++) {
      double best[LAWS] = {0};
      for (int round = 0; round < ROUNDS; round++)
        for (int l = 0; l < LAWS; l++) {
          const double rate = measure(sides[s], laws[l], isa ? NULL : "plain");
          best[l] = rate > best[l] || best[l] == 0 ? rate : best[l];
        }
      printf("%8d %8s", sides[s] * sides[s], isa ? "widest" : "plain");
      for (int l = 0; l < LAWS; l++)
        printf(" %20.1f", best[l]);
      printf(" %20.2f\n", best[2] / best[3]);
      fflush(stdout);
    }
  return 0;
}
