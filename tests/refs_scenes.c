/* Scenes for the tests of references.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "refs_scenes.h"

#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

static void set_scene(struct refs_scene *it, size_t particles, size_t walls, size_t monitors) {
  struct nb_scene *scene = &it->scene;
  scene->unitless = true;
  scene->materials = it->materials;
  scene->pair_rules = it->rules;
  scene->particles = it->particles;
  scene->walls = it->walls;
  scene->monitors = it->monitors;
  scene->stages = it->stages;
  scene->particle_count = particles;
  scene->wall_count = walls;
  scene->monitor_count = monitors;
  scene->stage_count = 2;
  strcpy(scene->normal, "linear");
  strcpy(scene->shear, "linear");
}

/* Walls move inward in the first stage and are at rest in the second. */
static void set_stages(struct refs_scene *it, double v, struct nb_step step, unsigned long load, unsigned long rest) {
  size_t n = it->scene.wall_count;
  for (size_t i = 0; i < n; i++) {
    it->motions[i] = (struct nb_wall_motion){.wall = (int)i, .vx = v * it->walls[i].inx, .vy = v * it->walls[i].iny};
    it->motions[n + i] = (struct nb_wall_motion){.wall = (int)i};
  }
  it->scene.step = step;
  it->stages[0] = (struct nb_stage){
      .name = "load", .motions = it->motions, .motion_count = n, .cycles = load, .record_interval = 1, .step = step};
  it->stages[1] = (struct nb_stage){.name = "rest",
                                    .motions = it->motions + n,
                                    .motion_count = n,
                                    .cycles = rest,
                                    .record_interval = 1,
                                    .step = step};
}

static void monitor(struct refs_scene *it, size_t i, const char *name, int a, int b, bool wall) {
  it->monitors[i] =
      (struct nb_monitor){.kind = wall ? NB_MONITOR_PARTICLE_WALL : NB_MONITOR_PARTICLE_PARTICLE, .a = a, .b = b};
  strcpy(it->monitors[i].name, name);
}

void refs_nine_discs(struct refs_scene *it, double ks, double friction, unsigned long load, unsigned long rest) {
  *it = (struct refs_scene){0};
  set_scene(it, 9, 4, 4);
  it->scene.material_count = 1;
  it->materials[0] =
      (struct nb_material){.name = "rock", .density = 1000, .kn = 1.35e9, .ks = ks, .friction = friction};
  for (int i = 0; i < 9; i++)
    it->particles[i] =
        (struct nb_particle){.shape = NB_DISC, .x = 50 + 100 * (i % 3), .y = 50 + 100 * (i / 3), .radius = 50};
  static const double in[4][2] = {{0, 1}, {-1, 0}, {0, -1}, {1, 0}}; /* south, east, north, west */
  for (size_t i = 0; i < 4; i++) {
    double nx = in[i][0], ny = in[i][1];
    it->walls[i] = (struct nb_wall){
        .x = 150 - 150 * nx, .y = 150 - 150 * ny, .ex = ny, .ey = -nx, .h1 = -150, .h2 = 150, .inx = nx, .iny = ny};
  }
  monitor(it, 0, "C", 4, 5, false);
  monitor(it, 1, "D", 1, 0, false);
  monitor(it, 2, "S", 0, 0, true);
  monitor(it, 3, "M", 1, 0, true);
  set_stages(it, 0.12, (struct nb_step){.kind = NB_STEP_SINGLE_CONTACT, .value = 0.12}, load, rest);
}

void refs_row(struct refs_scene *it, const double k[3], const double m[2], double v, double step, unsigned long load,
              unsigned long rest) {
  *it = (struct refs_scene){0};
  set_scene(it, 2, 2, 5);
  it->scene.material_count = 3;
  it->scene.pair_rule_count = 3;
  static const int pairs[3][2] = {{2, 0}, {0, 1}, {1, 2}};
  for (size_t i = 0; i < 3; i++) {
    it->materials[i] = (struct nb_material){.kn = 1, .density = 1};
    it->rules[i] = (struct nb_pair_rule){
        .a = pairs[i][0], .b = pairs[i][1], .kn = k[i], .ks = NAN, .friction = NAN, .cohesion = NAN};
  }
  for (int i = 0; i < 2; i++) {
    double radius = 1 + i;
    it->particles[i] = (struct nb_particle){.shape = NB_DISC, .x = i == 0 ? 1 : 4, .radius = radius, .material = i};
    it->materials[i].density = m[i] / (3.14159265358979323846 * radius * radius);
    double in = i == 0 ? 1 : -1;
    it->walls[i] = (struct nb_wall){.x = i == 0 ? 0 : 6, .ey = 1, .h1 = -3, .h2 = 3, .inx = in, .material = 2};
  }
  monitor(it, 0, "A", 0, 0, true);
  monitor(it, 1, "B", 0, 1, false);
  monitor(it, 2, "C", 1, 1, true);
  for (int i = 0; i < 2; i++) {
    monitor(it, 3 + (size_t)i, i == 0 ? "X" : "Y", i, -1, false);
    it->monitors[3 + i].kind = NB_MONITOR_PARTICLE;
  }
  set_stages(it, v, (struct nb_step){.kind = NB_STEP_TIME, .value = step}, load, rest);
}

struct nb_solution refs_solution(const char *name, const struct refs_scene *it) {
  struct nb_solution solution = {0};
  struct nb_error error = {0};
  const struct nb_reference *reference = nb_reference_find(name);
  CU_ASSERT_PTR_NOT_NULL_FATAL(reference);
  enum nb_status status = nb_reference_solve(reference, &solution, &it->scene, &error);
  if (status != NB_OK)
    printf("# %s: %s\n", name, error.text);
  CU_ASSERT_EQUAL(status, NB_OK);
  return solution;
}

double refs_value(const struct nb_solution *solution, const char *name) {
  const double *value = solution_find(solution, name);
  if (!value)
    printf("# no such value: %s\n", name);
  CU_ASSERT_PTR_NOT_NULL(value);
  return value ? *value : NAN;
}

struct nb_error refs_refused(const char *name, const struct refs_scene *it) {
  struct nb_solution solution = {0};
  struct nb_error error = {0};
  const struct nb_reference *reference = nb_reference_find(name);
  CU_ASSERT_PTR_NOT_NULL_FATAL(reference);
  CU_ASSERT_EQUAL(nb_reference_solve(reference, &solution, &it->scene, &error), NB_BAD_USE);
  CU_ASSERT_EQUAL(error.status, NB_BAD_USE);
  solution_free(&solution);
  return error;
}
