/* What a shear law costs: nanoseconds for each contact update of a dense packing of spheres that is squeezed and sheared, on one
 * core, for every shear law there is. A contact update is one listed contact through one whole cycle, motion included, as in
 * speed.c; so is the ratio, to the law without micro-slip: what a whole run takes longer, not what the law alone does.
 *
 * Laws take turns, so that whatever else the machine does falls on all of them alike; medians of eleven. Prints the line `price` of
 * cases/contact-ladder.md. Not a test: compare the ratios of one run.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "laws/law.h"

enum { RUNS = 11, SIDE = 32, CYCLES = 1200, LAWS_MAX = 64 };

static void make_scene(struct nb_scene *scene, const char *shear) {
  const double r = 1e-3, width = 2 * r * SIDE + r, height = 2 * r + sqrt(3) * r * (SIDE - 1);
  *scene = (struct nb_scene){.material_count = 1, .body_count = SIDE * SIDE, .wall_count = 4, .stage_count = 1};
  scene->materials = calloc(1, sizeof *scene->materials);
  scene->bodies = calloc(scene->body_count, sizeof *scene->bodies);
  scene->walls = calloc(4, sizeof *scene->walls);
  scene->stages = calloc(1, sizeof *scene->stages);
  if (!scene->materials || !scene->bodies || !scene->walls || !scene->stages)
    exit(NB_BROKEN);
  scene->materials[0] = (struct nb_material){
      .density = 7800, .young = 210e9, .poisson = 0.28, .friction = 0.3, .kn = 1e7, .ks = 1e7}; /* `linear` wants k_s */
  for (int k = 0; k < SIDE * SIDE; k++)
    scene->bodies[k] = (struct nb_body){.shape = NB_SPHERE,
                                        .x = r + 2 * r * (k % SIDE) + (k / SIDE % 2 ? r : 0),
                                        .y = r + sqrt(3) * r * (k / SIDE),
                                        .radius = r};
  const double dt = 2e-7,
               v = 2e-4 * r * SIDE / (CYCLES * dt); /* each wall by 0.02 % of the packing, north aside as well */
  const double w = width / 2, h = height / 2;
  scene->walls[0] = (struct nb_wall){.x = w, .ex = 1, .h1 = -w, .h2 = w, .vy = v};
  scene->walls[1] = (struct nb_wall){.x = width, .y = h, .ey = 1, .h1 = -h, .h2 = h, .vx = -v};
  scene->walls[2] = (struct nb_wall){.x = w, .y = height, .ex = -1, .h1 = -w, .h2 = w, .vx = v, .vy = -v};
  scene->walls[3] = (struct nb_wall){.y = h, .ey = -1, .h1 = -h, .h2 = h, .vx = v};
  snprintf(scene->normal, sizeof scene->normal, "hertz");
  snprintf(scene->shear, sizeof scene->shear, "%s", shear);
  scene->step = (struct nb_step){.kind = NB_STEP_TIME, .value = dt};
  scene->stages[0] = (struct nb_stage){.name = "squeeze", .cycles = CYCLES, .step = scene->step};
}

static int by_size(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* ns for each contact update. */
static double measure(const struct nb_scene *scene) {
  struct nb_result result;
  struct nb_error error;
  const struct nb_options options = {.threads = 1};
  if (nb_run(&result, scene, &options, NULL, &error)) {
    fprintf(stderr, "shear %s: %s\n", scene->shear, error.text);
    exit(NB_BROKEN);
  }
  const double ns = 1e9 * result.seconds / (double)result.updates;
  nb_result_free(&result);
  return ns;
}

int main(void) {
  struct nb_scene scenes[LAWS_MAX];
  double ns[LAWS_MAX][RUNS];
  int count = 0, base = 0;
  for (const struct nb_law *const *law = nb_laws(); *law && count < LAWS_MAX; law++)
    if ((*law)->shear)
      make_scene(&scenes[count++], (*law)->name);
  for (int run = 0; run < RUNS; run++)
    for (int k = 0; k < count; k++)
      ns[k][run] = measure(&scenes[k]);
  for (int k = 0; k < count; k++) {
    qsort(ns[k], RUNS, sizeof(double), by_size);
    base = strcmp(scenes[k].shear, "mindlin") == 0 ? k : base;
  }
  printf("ns a contact update:");
  for (int k = 0; k < count; k++)
    printf(" %s %.1f", scenes[k].shear, ns[k][RUNS / 2]);
  printf("\nprice = '");
  for (int k = 0; k < count; k++) {
    printf("%s%s %.2f", k ? "  " : "", scenes[k].shear, ns[k][RUNS / 2] / ns[base][RUNS / 2]);
    nb_scene_free(&scenes[k]);
  }
  puts("'");
  return 0;
}
