/* The references of Hertz's impact, compared with each other and with closed forms, and the scenes that they refuse.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_sf_gamma.h>
#include <math.h>
#include <string.h>

#include "hertz.h"
#include "refs_scenes.h"
#include "suites.h"

/* Head-on impact of sphere 1 on sphere 2, or on a wall, along a line that is not an axis. The two have different
 * materials, and the spheres different radii. `damping` is the damping ratio. */
static void make_impact(struct refs_scene *it, bool wall, double damping) {
  memset(it, 0, sizeof *it);
  it->materials[0] = (struct nb_material){.name = "a", .density = 7800, .young = 210e9, .poisson = 0.3};
  it->materials[1] = (struct nb_material){.name = "b", .density = 2650, .young = 70e9, .poisson = 0.25};
  const double ex = 0.6, ey = -0.8, gap = 1e-5;
  it->particles[0] = (struct nb_particle){.shape = NB_SPHERE, .radius = 0.01, .vx = ex, .vy = ey};
  it->particles[1] = (struct nb_particle){.shape = NB_SPHERE, .radius = 0.012, .material = 1, .vx = -ex, .vy = -ey};
  it->particles[1].x = (0.022 + gap) * ex, it->particles[1].y = (0.022 + gap) * ey;
  it->walls[0] =
      (struct nb_wall){.x = (0.01 + gap) * ex, .y = (0.01 + gap) * ey, .ex = -ey, .ey = ex, .h1 = -1, .h2 = 1};
  it->walls[0].vx = -ex, it->walls[0].vy = -ey, it->walls[0].material = 1;
  strcpy(it->scene.normal, "hertz"), strcpy(it->scene.shear, "none");
  it->monitors[0] =
      (struct nb_monitor){.name = "C", .kind = wall ? NB_MONITOR_PARTICLE_WALL : NB_MONITOR_PARTICLE_PARTICLE};
  it->monitors[0].b = wall ? 0 : 1;
  it->scene.materials = it->materials, it->scene.material_count = 2;
  it->scene.particles = it->particles, it->scene.particle_count = wall ? 1 : 2;
  it->scene.walls = it->walls, it->scene.wall_count = wall ? 1 : 0;
  it->scene.monitors = it->monitors, it->scene.monitor_count = 1;
  it->scene.step = (struct nb_step){.kind = NB_STEP_TIME, .value = 1e-7};
  if (damping > 0)
    it->scene.damping = (struct nb_damping){.contact_kind = NB_CONTACT_RATIO, .contact = damping};
  it->stages[0] = (struct nb_stage){.name = "s", .cycles = 300, .step = it->scene.step, .damping = it->scene.damping};
  it->scene.stages = it->stages, it->scene.stage_count = 1;
}

static double at(const struct nb_solution *solution, const char *name, double t) {
  const struct nb_solution_curve *curve = solution_find_curve(solution, name, "time");
  CU_ASSERT_PTR_NOT_NULL_FATAL(curve);
  return curve->at(curve->data, t);
}

/* The formulas with the numbers of the scene: m*, R*, E*, alpha*, N*, T_c [R89 5.4, 5.5, 5.9, 5.12]. */
static void values_of_the_formulas(void) {
  for (int wall = 0; wall < 2; wall++) {
    struct refs_scene it;
    make_impact(&it, wall, 0);
    struct nb_solution solution = refs_solution("hertz_impact", &it);
    const double m1 = 4 * M_PI / 3 * 1e-6 * 7800, m2 = 4 * M_PI / 3 * 1.728e-6 * 2650;
    const double m = wall ? m1 : m1 * m2 / (m1 + m2), r = wall ? 0.01 : 0.01 * 0.012 / 0.022;
    const double young = 1 / (0.91 / 210e9 + 0.9375 / 70e9);
    const double depth = pow(15 * m * 4 / (16 * sqrt(r) * young), 0.4);
    REFS_NEAR(refs_value(&solution, "C.overlap max"), depth, 1e-13, depth);
    REFS_NEAR(refs_value(&solution, "C.normal max"), 1.25 * m * 4 / depth, 1e-13, m * 4 / depth);
    REFS_NEAR(refs_value(&solution, "impact.duration"), 2.9432751843247047 * depth / 2, 1e-13, depth);
    REFS_NEAR(refs_value(&solution, "impact.duration"), 2.8682656991953314 * pow(m * m / (r * young * young * 2), 0.2),
              1e-13, depth);
    CU_ASSERT_EQUAL(refs_value(&solution, "impact.restitution"), 1);
    solution_free(&solution);
  }
}

/* The time t from first touch to the overlap s alpha* is an incomplete beta function: 2 t/T_c = I(s^(5/2); 2/5, 1/2). The
 * spheres cross the gap of 1e-5 m in 5 us, because they approach at 2 m/s. */
static void loading_is_a_beta_function(void) {
  struct refs_scene it;
  make_impact(&it, false, 0);
  struct nb_solution solution = refs_solution("hertz_impact", &it);
  const double depth = refs_value(&solution, "C.overlap max"), duration = refs_value(&solution, "impact.duration");
  const double begin = 5e-6;
  for (double s = 0.05; s < 1; s += 0.05) {
    const double t = duration / 2 * gsl_sf_beta_inc(0.4, 0.5, pow(s, 2.5));
    REFS_NEAR(at(&solution, "C.overlap", begin + t), s * depth, 1e-12, depth);
    REFS_NEAR(at(&solution, "C.overlap", begin + duration - t), s * depth, 1e-12, depth);
  }
  REFS_NEAR(at(&solution, "C.overlap", begin + duration / 2), depth, 1e-14, depth);
  CU_ASSERT_EQUAL(at(&solution, "C.overlap", begin / 2), 0);
  CU_ASSERT_EQUAL(at(&solution, "C.overlap", begin + 1.001 * duration), 0);
  REFS_NEAR(refs_value(&solution, "C.overlap in s"), at(&solution, "C.overlap", 3e-5), 0, 1.);
  solution_free(&solution);
}

/* Without damping, the solution of the ODE (hertz_damped) equals the quadrature (hertz_impact). With damping, its
 * restitution equals the closed form. */
static void ode_equals_closed_forms(void) {
  struct refs_scene it;
  make_impact(&it, true, 0);
  struct nb_solution free = refs_solution("hertz_impact", &it), ode = refs_solution("hertz_damped", &it);
  static const char *const same[] = {"C.overlap max", "C.normal max", "impact.duration", "impact.restitution"};
  for (int k = 0; k < 4; k++)
    REFS_NEAR(refs_value(&free, same[k]), refs_value(&ode, same[k]), 1e-12, refs_value(&free, same[k]));
  for (double t = 0; t < 1.2e-4; t += 7e-7)
    REFS_NEAR(at(&free, "C.normal", t), at(&ode, "C.normal", t), 1e-11, refs_value(&free, "C.normal max"));
  solution_free(&free), solution_free(&ode);
  for (double beta = 0.05; beta < 0.9; beta += 0.05) {
    make_impact(&it, true, beta);
    ode = refs_solution("hertz_damped", &it);
    REFS_NEAR(refs_value(&ode, "impact.restitution"), hertz_restitution(beta), 1e-11, 1.);
    CU_ASSERT(fabs(hertz_ratio(hertz_restitution(beta)) - beta) < 1e-13);
    solution_free(&ode);
  }
  make_impact(&it, true, 1);
  ode = refs_solution("hertz_damped", &it);
  CU_ASSERT_EQUAL(refs_value(&ode, "impact.restitution"), 0);
  CU_ASSERT_PTR_NULL(solution_find(&ode, "impact.duration"));
  solution_free(&ode);
}

/* The curve of the overlap obeys m* alpha'' = -N - D, with the dashpot force D of [R89 4.13]. */
static void dashpot_is_that_of_r89(void) {
  struct refs_scene it;
  make_impact(&it, true, 0.3);
  struct nb_solution ode = refs_solution("hertz_damped", &it);
  const double m = 4 * M_PI / 3 * 1e-6 * 7800, young = 1 / (0.91 / 210e9 + 0.9375 / 70e9), h = 2e-8;
  for (double t = 1e-5; t < 5e-5; t += 5e-6) {
    const double before = at(&ode, "C.overlap", t - h), here = at(&ode, "C.overlap", t),
                 after = at(&ode, "C.overlap", t + h);
    const double pull = at(&ode, "C.dashpot.normal", t), force = at(&ode, "C.normal", t);
    const double v = (after - before) / (2 * h), a = sqrt(0.01 * here);
    REFS_NEAR(pull, 0.6 * sqrt(m * 2 * young * a) * v, 1e-5, refs_value(&ode, "C.normal max"));
    REFS_NEAR(m * (after - 2 * here + before) / (h * h), -force - pull, 1e-4, refs_value(&ode, "C.normal max"));
  }
  solution_free(&ode);
}

/* The time step causes an error of the restitution e, which contains Hurwitz's zeta(-3/2, a) of the phase a
 * (hertz_corner.h). The error is the same at the phases 0 and 1, because the impact then begins at a whole step. From
 * a = 0 to 1, zeta(-3/2, a) lies between -0.0316 and 0.0242. */
static void step_error_is_periodic(void) {
  struct refs_scene it;
  double first = 0, least = 1, most = 1;
  for (int k = 0; k <= 64; k++) {
    make_impact(&it, true, 0);
    it.scene.impact = (struct nb_impact){.phase = k / 64., .line = 1};
    struct nb_solution solution = refs_solution("hertz_phase", &it);
    const double e = refs_value(&solution, "impact.restitution");
    first = k ? first : e, least = fmin(least, e), most = fmax(most, e);
    if (k == 64)
      CU_ASSERT(fabs(e - first) < 1e-9);
    solution_free(&solution);
  }
  make_impact(&it, true, 0);
  struct nb_solution solution = refs_solution("hertz_impact", &it);
  const double n = refs_value(&solution, "impact.duration") / 1e-7;
  CU_ASSERT(most - least > 0.5 * pow(n, -2.5) && most - least < 2.1 * pow(n, -2.5));
  solution_free(&solution);
}

/* With n steps per collision, 1 - e is (1/4) B(3/5, 3/2) 2.9432751843247047/n = 0.92797/n, where B is Euler's beta
 * function. With 400 steps the law itself gives e = 0.99769. The largest force is too small by the fraction 0.55678/n. */
static void energy_lost_by_increments(void) {
  struct refs_scene it;
  make_impact(&it, true, 0);
  strcpy(it.scene.normal, "hertz_increment");
  it.scene.step = it.stages[0].step = (struct nb_step){.kind = NB_STEP_COLLISION, .value = 1. / 400};
  struct nb_solution solution = refs_solution("hertz_increment", &it);
  REFS_NEAR(1 - refs_value(&solution, "impact.restitution"), 0.92797 / 400, 1e-5, 0.92797 / 400);
  CU_ASSERT(fabs(refs_value(&solution, "impact.restitution") - 0.9977) < 5e-5);
  strcpy(it.scene.normal, "hertz");
  struct nb_solution hertz = refs_solution("hertz_impact", &it);
  const double peak = refs_value(&hertz, "C.normal max");
  REFS_NEAR(peak - refs_value(&solution, "C.normal max in s"), 0.55678 / 400 * peak, 1e-5, 0.55678 / 400 * peak);
  solution_free(&hertz);
  solution_free(&solution);
  strcpy(it.scene.normal, "hertz");
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("hertz_increment", &it).text, "hertz_increment"));
}

/* Two spheres of different size between two walls, which move towards each other with equal speeds. When the upper wall
 * has moved from y0 down to y, the walls have approached by s = 2 (y0 - y). */
static void make_column(struct refs_scene *it) {
  memset(it, 0, sizeof *it);
  it->materials[0] = (struct nb_material){.name = "a", .density = 7800, .young = 210e9, .poisson = 0.3};
  it->materials[1] = (struct nb_material){.name = "b", .young = INFINITY};
  it->particles[0] = (struct nb_particle){.shape = NB_SPHERE, .radius = 1, .y = 1};
  it->particles[1] = (struct nb_particle){.shape = NB_SPHERE, .radius = 3, .y = 5};
  it->walls[0] = (struct nb_wall){.name = "low", .material = 1, .ex = 1, .vy = 1};
  it->walls[1] = (struct nb_wall){.name = "high", .material = 1, .ex = 1, .vy = -1, .y = 8};
  strcpy(it->scene.normal, "hertz"), strcpy(it->scene.shear, "none");
  it->monitors[0] = (struct nb_monitor){.name = "L", .kind = NB_MONITOR_PARTICLE_WALL, .b = 0};
  it->monitors[1] = (struct nb_monitor){.name = "C", .kind = NB_MONITOR_PARTICLE_PARTICLE, .b = 1};
  it->monitors[2] = (struct nb_monitor){.name = "U", .kind = NB_MONITOR_PARTICLE_WALL, .a = 1, .b = 1};
  it->monitors[3] = (struct nb_monitor){.name = "H", .kind = NB_MONITOR_WALL, .a = 1, .b = -1};
  it->scene.materials = it->materials, it->scene.material_count = 2;
  it->scene.particles = it->particles, it->scene.particle_count = 2;
  it->scene.walls = it->walls, it->scene.wall_count = 2;
  it->scene.monitors = it->monitors, it->scene.monitor_count = 4;
}

static double along(const struct nb_solution *solution, const char *name, const char *with, double x) {
  const struct nb_solution_curve *curve = solution_find_curve(solution, name, with);
  CU_ASSERT_PTR_NOT_NULL_FATAL(curve);
  return curve->at(curve->data, x);
}

/* Sneddon's integrals equal [R89 3.13]. All contacts of a column have the same force, and their overlaps add up to
 * s. */
static void column_is_in_equilibrium(void) {
  static const char *const overlap[] = {"L.overlap", "C.overlap", "U.overlap"};
  static const char *const normal[] = {"L.normal", "C.normal", "U.normal"};
  const double radius[] = {1, 0.75, 3}, young[] = {210e9 / 0.91, 210e9 / 0.91 / 2, 210e9 / 0.91};
  struct refs_scene it;
  make_column(&it);
  struct nb_solution solution = refs_solution("hertz_curve", &it);
  for (double s = 1e-6; s < 1e-2; s *= 10) {
    double sum = 0;
    for (int c = 0; c < 3; c++) {
      const double alpha = along(&solution, overlap[c], "H.y", 8 - s / 2),
                   force = along(&solution, normal[c], "H.y", 8 - s / 2);
      const double hertz = 4. / 3 * young[c] * sqrt(radius[c]) * pow(alpha, 1.5);
      REFS_NEAR(force, hertz, 1e-12, hertz);
      REFS_NEAR(along(&solution, normal[c], overlap[c], alpha), hertz, 1e-12, hertz);
      REFS_NEAR(force, along(&solution, normal[0], "H.y", 8 - s / 2), 1e-8, force);
      sum += alpha;
    }
    REFS_NEAR(sum, s, 1e-8, s);
  }
  CU_ASSERT_EQUAL(along(&solution, "C.normal", "H.y", 8.1), 0);
  solution_free(&solution);
  it.particles[1].x = 0.1;
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("hertz_curve", &it).text, "one above the other"));
  make_column(&it);
  it.walls[1].vy = -2;
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("hertz_curve", &it).text, "approach with equal speeds"));
  make_column(&it);
  it.walls[1].y = 8.1;
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("hertz_curve", &it).text, "just touch"));
}

/* An overdamped contact does not end: its overlap decreases and stays positive as long as it is computed, even after
 * the last stored state. With less damping the contact ends. */
static void overdamped_contacts_at_late_times(void) {
  struct refs_scene it;
  make_impact(&it, true, 1);
  struct nb_solution solution = refs_solution("hertz_damped", &it);
  double before = INFINITY;
  int followed = 0;
  for (double t = 1e-4; t < 1e300; t *= t < 1 ? 1.5 : 1e10) {
    const double overlap = at(&solution, "C.overlap", t);
    CU_ASSERT(isnan(overlap) ? t > 1e-3 : overlap > 0 && overlap < before);
    before = overlap, followed += !isnan(overlap);
  }
  CU_ASSERT(followed > 8 && isnan(before));
  solution_free(&solution);
  make_impact(&it, true, 0.1);
  solution = refs_solution("hertz_damped", &it);
  for (double t = 1e-2; t < 1e300; t *= 1e10)
    CU_ASSERT(at(&solution, "C.overlap", t) == 0);
  solution_free(&solution);
}

static void other_impacts_are_refused(void) {
  struct refs_scene it;
  make_impact(&it, false, 0.1);
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("hertz_impact", &it).text, "`damping ratio`"));
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("hertz_phase", &it).text, "`damping ratio`"));
  make_impact(&it, false, 0);
  it.particles[0].vx += 0.01;
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("hertz_impact", &it).text, "head-on"));
  make_impact(&it, false, 0);
  it.particles[1].spin = 1;
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("hertz_damped", &it).text, "spin"));
  make_impact(&it, false, 0);
  it.scene.gravity = (struct nb_gravity){.y = -1, .line = 3};
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("hertz_impact", &it).text, "gravity"));
  make_impact(&it, false, 0);
  it.particles[1].shape = NB_DISC;
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("hertz_impact", &it).text, "`disc`"));
  make_impact(&it, false, 0);
  it.materials[1].young = 0;
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("hertz_impact", &it).text, "young"));
  make_impact(&it, true, 0);
  it.walls[0].h1 = 0.5;
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("hertz_impact", &it).text, "head-on"));
  make_impact(&it, false, 0);
  it.scene.damping = it.stages[0].damping = (struct nb_damping){.contact_kind = NB_CONTACT_STIFFNESS, .contact = 0.1};
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("hertz_damped", &it).text, "`damping stiffness`"));
}

void suite_refs_hertz(void) {
  CU_pSuite suite = CU_add_suite("refs_hertz", NULL, NULL);
  CU_add_test(suite, "values of the formulas of R89", values_of_the_formulas);
  CU_add_test(suite, "loading is an incomplete beta function", loading_is_a_beta_function);
  CU_add_test(suite, "the ODE equals quadrature and closed form", ode_equals_closed_forms);
  CU_add_test(suite, "the dashpot is that of R89 4.13", dashpot_is_that_of_r89);
  CU_add_test(suite, "the error of the step is periodic in the phase of first contact", step_error_is_periodic);
  CU_add_test(suite, "energy lost by increments of the force", energy_lost_by_increments);
  CU_add_test(suite, "a column is in equilibrium", column_is_in_equilibrium);
  CU_add_test(suite, "overdamped contacts at late times", overdamped_contacts_at_late_times);
  CU_add_test(suite, "other impacts are refused", other_impacts_are_refused);
}
