/* Two spheres between floor and ceiling: the ODE of the reference `stacked`, compared with the modes of two equal masses
 * on three equal springs.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

#include "refs_scenes.h"
#include "suites.h"

/* Two spheres with R = 1 and the densities 1 and `density`, between walls at y = 0 and 3.6, with k = 100. `damping` is
 * the damping ratio. */
static void stack(struct refs_scene *it, double density, double damping) {
  memset(it, 0, sizeof *it);
  it->materials[0] = (struct nb_material){.name = "a", .density = 1, .kn = 100};
  it->materials[1] = (struct nb_material){.name = "b", .density = density, .kn = 100};
  it->particles[0] = (struct nb_particle){.shape = NB_SPHERE, .radius = 1, .y = 0.9};
  it->particles[1] = (struct nb_particle){.shape = NB_SPHERE, .radius = 1, .y = 2.7, .material = 1};
  it->walls[0] = (struct nb_wall){.name = "floor", .ex = 1, .h1 = -2, .h2 = 2};
  it->walls[1] = (struct nb_wall){.name = "ceiling", .ex = 1, .y = 3.6, .h1 = -2, .h2 = 2};
  it->monitors[0] = (struct nb_monitor){.name = "A", .kind = NB_MONITOR_PARTICLE};
  it->monitors[1] = (struct nb_monitor){.name = "B", .kind = NB_MONITOR_PARTICLE, .a = 1};
  it->monitors[2] = (struct nb_monitor){.name = "C", .kind = NB_MONITOR_PARTICLE_PARTICLE, .b = 1};
  it->scene.materials = it->materials, it->scene.material_count = 2;
  it->scene.particles = it->particles, it->scene.particle_count = 2;
  it->scene.walls = it->walls, it->scene.wall_count = 2;
  it->scene.monitors = it->monitors, it->scene.monitor_count = 3;
  strcpy(it->scene.normal, "linear"), strcpy(it->scene.shear, "none");
  if (damping > 0)
    it->scene.damping = (struct nb_damping){.contact_kind = NB_CONTACT_RATIO, .contact = damping};
}

static double at(const struct nb_solution *solution, const char *name, double t) {
  const struct nb_solution_curve *curve = solution_find_curve(solution, name, "time");
  CU_ASSERT_PTR_NOT_NULL_FATAL(curve);
  return curve->at(curve->data, t);
}

/* The three springs share the total overlap 0.4. The spheres oscillate symmetrically, without damping with the angular
 * frequency w = (3 k/m)^(1/2). With the damping ratio b, the damping coefficient is c = 2 b sqrt(m k) at a wall and
 * c sqrt(1/2) between the spheres. So the symmetric mode has the coefficient c + 2 c sqrt(1/2). */
static void equal_spheres_oscillate_symmetrically(void) {
  for (int damped = 0; damped < 2; damped++) {
    struct refs_scene it;
    const double b = damped ? 0.1 : 0, m = 4 * M_PI / 3, w2 = 300 / m;
    stack(&it, 1, b);
    struct nb_solution solution = refs_solution("stacked", &it);
    const double decay = b * sqrt(100 / m) * (1 + M_SQRT2), beat = sqrt(w2 - decay * decay);
    for (double t = 0; t < 5; t += 0.1) {
      const double oscillation = (0.1 - 0.4 / 3) * exp(-decay * t) * (cos(beat * t) + decay / beat * sin(beat * t));
      const double overlap = 0.4 / 3;
      REFS_NEAR(at(&solution, "A.y", t), 1 - overlap - oscillation, 1e-11, 1.);
      REFS_NEAR(at(&solution, "B.y", t), 2.6 + overlap + oscillation, 1e-11, 1.);
      REFS_NEAR(at(&solution, "C.overlap", t), overlap - 2 * oscillation, 1e-11, 1.);
    }
    solution_free(&solution);
  }
}

/* In the equilibrium under gravity, which damping leads to, the springs carry F + (m_1 + m_2) g, F + m_2 g and F from
 * bottom to top. */
static void equilibrium_under_weight(void) {
  struct refs_scene it;
  stack(&it, 3, 0.5);
  it.scene.gravity = (struct nb_gravity){.y = -0.1, .line = 1};
  struct nb_solution solution = refs_solution("stacked", &it);
  const double m1 = 4 * M_PI / 3, m2 = 3 * m1, g = 0.1, force = (100 * 0.4 - (m1 + 2 * m2) * g) / 3;
  REFS_NEAR(at(&solution, "A.y", 60), 1 - (force + (m1 + m2) * g) / 100, 1e-10, 1.);
  REFS_NEAR(at(&solution, "B.y", 60), 2.6 + force / 100, 1e-10, 1.);
  REFS_NEAR(at(&solution, "A.vy", 60), 0, 1e-10, 1.);
  REFS_NEAR(at(&solution, "B.vy", 1), (at(&solution, "B.y", 1.001) - at(&solution, "B.y", 0.999)) / 0.002, 1e-5, 1.);
  REFS_NEAR(at(&solution, "A.vy", 1), (at(&solution, "A.y", 1.001) - at(&solution, "A.y", 0.999)) / 0.002, 1e-5, 1.);
  solution_free(&solution);
}

static void other_scenes_are_refused(void) {
  struct refs_scene it;
  stack(&it, 1, 0);
  it.particles[1].x = 0.1;
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("stacked", &it).text, "sphere 1 vertically below sphere 2"));
  stack(&it, 1, 0);
  strcpy(it.scene.normal, "hertz");
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("stacked", &it).text, "`normal hertz`"));
  stack(&it, 1, 0);
  it.scene.damping.contact_kind = NB_CONTACT_STIFFNESS, it.scene.damping.contact = 0.1;
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("stacked", &it).text, "`damping stiffness`"));
}

void suite_refs_stacked(void) {
  CU_pSuite suite = CU_add_suite("refs_stacked", NULL, NULL);
  CU_add_test(suite, "equal spheres oscillate symmetrically", equal_spheres_oscillate_symmetrically);
  CU_add_test(suite, "equilibrium under weight", equilibrium_under_weight);
  CU_add_test(suite, "other scenes are refused", other_scenes_are_refused);
}
