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
  for (int k = 0; k < 2; k++)
    it->particles[k].x += 0.003, it->particles[k].y -= 0.002;
  it->walls[0].x += 0.003 + 0.004 * -ey, it->walls[0].y += -0.002 + 0.004 * ex; /* P is not at the point of impact */
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

/* zeta(-3/2, a) by the Euler-Maclaurin formula after a hundred terms. */
static double hurwitz(double a) {
  const long double x = 100 + (long double)a;
  long double sum = 0;
  for (int k = 0; k < 100; k++)
    sum += powl(k + (long double)a, 1.5L);
  return (double)(sum - powl(x, 2.5L) / 2.5L + powl(x, 1.5L) / 2 - sqrtl(x) / 8 - powl(x, -1.5L) / 1920);
}

/* The formulas of hertz_corner.h for twenty steps per collision: the first contact is 2.3 + phase steps after the start. */
static void restitution_and_duration_in_steps(void) {
  for (int k = 0; k < 4; k++) {
    struct refs_scene it;
    const double phase = 0.2 * k;
    make_impact(&it, k % 2, 0);
    struct nb_solution exact = refs_solution("hertz_impact", &it);
    const double duration = refs_value(&exact, "impact.duration"), depth = refs_value(&exact, "C.overlap max");
    const double dt = duration / 20.4, f = 2 * dt / depth; /* the speed is 2 */
    it.scene.step.value = it.stages[0].step.value = dt;
    it.scene.impact = (struct nb_impact){.phase = phase, .line = k};
    struct nb_solution solution = refs_solution("hertz_phase", &it);
    const double shorter = 11. / 96 * tgamma(1.6) * tgamma(0.5) / tgamma(2.1) * f;
    const double in = 5e-6 / dt + (k ? phase : 0), out = in + 20.4 - shorter;
    const double error = 1.25 * pow(f, 2.5) * (hurwitz(out - floor(out)) - hurwitz(ceil(in) - in));
    REFS_NEAR(refs_value(&solution, "impact.duration"), duration - shorter * dt, 1e-9, dt);
    REFS_NEAR(refs_value(&solution, "impact.restitution") - 1, error, 1e-7, pow(f, 2.5));
    solution_free(&solution), solution_free(&exact);
  }
}

/* The damping ratio is that of `damping walls` at a wall and the other one between spheres. */
static void dashpots_at_walls(void) {
  for (int wall = 0; wall < 2; wall++) {
    struct refs_scene it;
    make_impact(&it, wall, 0.3);
    it.scene.damping.walls_separate = true, it.scene.damping.walls_kind = NB_CONTACT_RATIO,
    it.scene.damping.walls = 0.1, it.stages[0].damping = it.scene.damping;
    struct nb_solution solution = refs_solution("hertz_damped", &it);
    REFS_NEAR(refs_value(&solution, "impact.restitution"), hertz_restitution(wall ? 0.1 : 0.3), 1e-11, 1.);
    solution_free(&solution);
  }
  /* without a rebound: z = 1, and the inverse of e = 0 */
  CU_ASSERT(hertz_restitution(sqrt(5. / 6) * 1.0001) == 0 && hertz_restitution(2) == 0);
  NEAR(hertz_ratio(0), sqrt(5. / 6), 1e-15);
}

/* Critical damping beyond the overlap 0.1 of the smaller diameter: the equation of motion by the midpoint rule. */
static void critical_damping_beyond_an_overlap(void) {
  for (int k = 0; k < 5; k++) { /* a wall; a smaller, a larger and a fixed second sphere; a limit that is not reached */
    struct refs_scene it;
    make_impact(&it, k == 0, 0.2);
    it.particles[1].radius = k == 1 ? 0.008 : 0.012, it.particles[1].fixed = k == 3;
    it.particles[1].x = 0.003 + (0.01 + it.particles[1].radius) * 0.6;
    it.particles[1].y = -0.002 - (0.01 + it.particles[1].radius) * 0.8;
    it.walls[0].x -= 1e-5 * 0.6, it.walls[0].y += 1e-5 * 0.8; /* without a gap */
    const double r2 = it.particles[1].radius, smaller = k == 1 ? 0.008 : 0.01;
    const double m1 = 4 * M_PI / 3 * 1e-6 * 7800, m2 = 4 * M_PI / 3 * r2 * r2 * r2 * 2650;
    const double m = k == 0 || k == 3 ? m1 : m1 * m2 / (m1 + m2), r = k == 0 ? 0.01 : 0.01 * r2 / (0.01 + r2);
    const double young = 1 / (0.91 / 210e9 + 0.9375 / 70e9), stiffness = 4. / 3 * young * sqrt(r);
    const double deep = pow(5 * m * 4 / (4 * stiffness), 0.4), limit = (k == 4 ? 2 : 0.4) * deep, dt = 1e-5 * deep;
    it.scene.damping.deep = limit / (2 * smaller), it.scene.damping.deep_line = 1;
    it.stages[0].damping = it.scene.damping;
    double s = 0, v = 2, t = 0, largest = 0;
    while (s >= 0 && t < 1) {
      double speed = v, at = s;
      for (int half = 0; half < 2; half++) {
        const double beta = at > limit ? 1 : 0.2, root = sqrt(fmax(at, 0));
        const double a =
            -(stiffness * fmax(at, 0) * root + 2 * beta * sqrt(m * 2 * young * sqrt(r) * root) * speed) / m;
        at = s + (half ? dt : dt / 2) * (half ? speed : v), speed = v + (half ? dt : dt / 2) * a;
      }
      s = at, v = speed, t += dt, largest = fmax(largest, s);
    }
    struct nb_solution solution = refs_solution("hertz_deep", &it);
    REFS_NEAR(refs_value(&solution, "C.overlap max"), largest, 1e-4, deep);
    REFS_NEAR(refs_value(&solution, "impact.duration"), t, 1e-4, deep);
    REFS_NEAR(refs_value(&solution, "impact.restitution"), -v / 2, 1e-4, 1.);
    CU_ASSERT_EQUAL(solution.value_count, 3);
    solution_free(&solution);
  }
}

/* Values at the end of each stage, until a stage ends with a condition or has another step. */
static void values_of_stages(void) {
  static struct nb_condition condition;
  for (int k = 0; k < 4; k++) {
    struct refs_scene it;
    struct nb_stage stages[4];
    char name[32];
    make_impact(&it, false, 0);
    struct nb_solution whole = refs_solution("hertz_impact", &it);
    /* the largest overlap is at 5 us + T_c/2, in the middle of the second stage; each stage is 0.6 of that time */
    const double middle = 5e-6 + refs_value(&whole, "impact.duration") / 2;
    it.scene.step.value = it.stages[0].step.value = 0.06 * middle, it.stages[0].cycles = 10;
    for (int s = 0; s < 4; s++)
      stages[s] = it.stages[0], snprintf(stages[s].name, sizeof stages[s].name, "s%d", s);
    if (k == 1)
      stages[2].conditions = &condition, stages[2].condition_count = 1;
    if (k == 2)
      stages[2].step.value *= 1.001;
    if (k == 3)
      stages[2].step.kind = NB_STEP_STABLE;
    it.scene.stages = stages;
    struct nb_solution solution = {0};
    struct nb_error error = {0};
    it.scene.stage_count = 3;
    /* Steps in stages are no features of these references, so `solve` is called without the comparison of features. */
    CU_ASSERT_EQUAL(nb_reference_find("hertz_impact")->solve(&solution, &it.scene, &error), NB_OK);
    const int last = k ? 2 : 3;
    for (int s = 0; s < 4; s++) {
      snprintf(name, sizeof name, "C.overlap in s%d", s);
      CU_ASSERT_EQUAL(solution_find(&solution, name) != NULL, s < last);
      if (s < last)
        REFS_NEAR(refs_value(&solution, name), at(&whole, "C.overlap", (s + 1) * 0.6 * middle), 1e-11, middle);
      snprintf(name, sizeof name, "C.normal in s%d", s);
      if (s < last)
        NEAR(refs_value(&solution, name), at(&whole, "C.normal", (s + 1) * 0.6 * middle), 1e-9);
      snprintf(name, sizeof name, "C.overlap max in s%d", s);
      CU_ASSERT_EQUAL(solution_find(&solution, name) != NULL, s == 1);
    }
    NEAR(refs_value(&solution, "C.normal max in s1"), refs_value(&whole, "C.normal max"), 1e-12);
    NEAR(refs_value(&solution, "C.overlap max in s1"), refs_value(&whole, "C.overlap max"), 1e-12);
    solution_free(&solution), solution_free(&whole);
  }
}

/* Two spheres of different size between two walls, which move towards each other with equal speeds. When the upper wall
 * has moved from y0 down to y, the walls have approached by s = 2 (y0 - y). */
static void make_column(struct refs_scene *it) {
  memset(it, 0, sizeof *it);
  it->materials[0] = (struct nb_material){.name = "a", .density = 7800, .young = 210e9, .poisson = 0.3};
  it->materials[1] = (struct nb_material){.name = "b", .young = INFINITY};
  it->particles[0] = (struct nb_particle){.shape = NB_SPHERE, .radius = 1, .y = 1};
  it->particles[1] = (struct nb_particle){.shape = NB_SPHERE, .radius = 3, .y = 5};
  it->walls[0] = (struct nb_wall){.name = "low", .material = 1, .ex = 1, .h1 = -1, .h2 = 1, .vy = 1};
  it->walls[1] = (struct nb_wall){.name = "high", .material = 1, .ex = 1, .h1 = -1, .h2 = 1, .vy = -1, .y = 8};
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

/* The whole message of a scene with one change. */
static void check_message(const char *reference, const struct refs_scene *it, const char *what) {
  char text[256];
  snprintf(text, sizeof text, "the reference `%s` is for %s", reference, what);
  CU_ASSERT_STRING_EQUAL(refs_refused(reference, it).text, text);
}

/* Each condition of hertz_read at both edges. */
static void edges_of_impacts(void) {
  static const char head_on[] = "particles that collide head-on and do not overlap at first";
  struct refs_scene it;
#define HIT(wall, change, message)                                                                                     \
  do {                                                                                                                 \
    make_impact(&it, wall, 0);                                                                                         \
    change;                                                                                                            \
    const char *const refused = message;                                                                               \
    if (refused) {                                                                                                     \
      check_message("hertz_phase", &it, refused);                                                                      \
    } else {                                                                                                           \
      struct nb_solution solution = refs_solution("hertz_phase", &it);                                                 \
      solution_free(&solution);                                                                                        \
    }                                                                                                                  \
  } while (0)
  static const char other[] = "a free sphere that strikes another sphere or a wall";
  HIT(false, it.scene.particle_count = 1, other);
  HIT(false, it.scene.wall_count = 1, other);
  HIT(true, (it.scene.particle_count = 0, it.scene.wall_count = 2), other);
  HIT(false, it.particles[0].fixed = 3, other);
  HIT(false, it.particles[1].fixed = 3, NULL);
  HIT(true, (it.stages[0].motions = it.motions, it.stages[0].motion_count = 1),
      "a wall whose velocity no stage changes");
  HIT(true,
      (it.stages[1] = it.stages[0], it.scene.stage_count = 2, it.stages[1].motions = it.motions,
       it.stages[1].motion_count = 1),
      "a wall whose velocity no stage changes");
  HIT(false, it.materials[0].young = it.materials[1].young = INFINITY, "elastic spheres, whose materials have `young`");
  HIT(false, it.materials[0].young = 0, "elastic spheres, whose materials have `young`");
  HIT(false, it.particles[0].vx *= -3, head_on);
  HIT(false, (it.particles[0].vx *= -1, it.particles[0].vy *= -1), head_on); /* no relative velocity */
  HIT(false, (it.particles[0].vx *= -2, it.particles[0].vy *= -2), head_on); /* they separate */
  HIT(false, (it.particles[0].vx += 0.8e-11, it.particles[0].vy += 0.6e-11), head_on);
  HIT(false, (it.particles[0].vx -= 0.8e-11, it.particles[0].vy -= 0.6e-11), head_on);
  HIT(false, (it.particles[0].vx += 0.8e-12, it.particles[0].vy += 0.6e-12), NULL);
  HIT(false, (it.particles[0].x += 1.1e-5 * 0.6, it.particles[0].y -= 1.1e-5 * 0.8), head_on);
  HIT(false, (it.particles[0].x += 0.9e-5 * 0.6, it.particles[0].y -= 0.9e-5 * 0.8), NULL);
  HIT(false, (it.particles[0].x += 1e-5 * 0.6 + 3e-13, it.particles[0].y -= 1e-5 * 0.8 + 4e-13), head_on);
  HIT(false, (it.particles[0].x += 1e-5 * 0.6 + 3e-15, it.particles[0].y -= 1e-5 * 0.8 + 4e-15), NULL);
  HIT(false,
      (it.particles[0].vx *= 0.1, it.particles[0].vy *= 0.1, it.particles[1].vx *= 0.1, it.particles[1].vy *= 0.1),
      NULL);
  HIT(true, it.walls[0].h1 = -0.0041, NULL);
  HIT(true, it.walls[0].h1 = -0.0039, head_on);
  HIT(true, it.walls[0].h2 = -0.0039, NULL);
  HIT(true, it.walls[0].h2 = -0.0041, head_on);
  HIT(true,
      (it.scene.step.kind = it.stages[0].step.kind = NB_STEP_COLLISION, it.scene.step.value = 0.01,
       it.stages[0].step.value = 0.01),
      NULL);
  HIT(true, it.scene.step.kind = it.stages[0].step.kind = NB_STEP_SINGLE_CONTACT,
      "a step given as a time or as a fraction of the duration of the collision");
#undef HIT
  make_impact(&it, false, 0.1);
  it.scene.damping.deep_line = it.stages[0].damping.deep_line = 0;
  it.scene.damping.deep = it.stages[0].damping.deep = 0.1;
  it.particles[0].fixed = true;
  check_message("hertz_deep", &it, other);
  make_impact(&it, false, 0.1);
  it.particles[0].fixed = true;
  check_message("hertz_damped", &it, other);
  make_impact(&it, false, 0);
  it.particles[0].fixed = true;
  check_message("hertz_impact", &it, other);
  strcpy(it.scene.normal, "hertz_increment");
  check_message("hertz_increment", &it, other);
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
  CU_ADD_TEST(suite, edges_of_impacts);
  CU_ADD_TEST(suite, restitution_and_duration_in_steps);
  CU_ADD_TEST(suite, dashpots_at_walls);
  CU_ADD_TEST(suite, critical_damping_beyond_an_overlap);
  CU_ADD_TEST(suite, values_of_stages);
}
