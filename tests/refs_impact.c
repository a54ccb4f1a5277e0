/* The reference of oblique impact: convergence, and published values of Maw's curve.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../cases/refs/impact_springs.h"
#include "refs_scenes.h"
#include "suites.h"
#include "written.h"

/* The impact parameter chi of solid spheres with nu = 0.28 and 0.30 [R89 5.14, sec. 5.4]. */
static const double chi28 = 0.72 / 1.72 * 3.5, chi30 = 0.7 / 1.7 * 3.5;

/* psi2 of the exact contact (law NULL), or of a simplified law. */
static double rebound(const char *law, double chi, double psi1, int steps) {
  struct impact_path path;
  CU_ASSERT(law ? impact_law(&path, law, 1.5, chi, psi1, steps) : impact_exact(&path, chi, psi1, steps));
  const double psi2 = path.psi2;
  impact_path_free(&path);
  return psi2;
}

/* Duration and symmetry of the approach [R89 5.10-5.12]. */
static void approach_is_hertz(void) {
  double *xi = impact_approach(1000), most = 0;
  CU_ASSERT_PTR_NOT_NULL_FATAL(xi);
  CU_ASSERT(fabs(xi[500] - 1) < 1e-12 && xi[0] == 0 && xi[1000] == 0);
  /* the second difference is the acceleration at k dt, except for an error of dt^2/12 times its second derivative */
  const double dt = IMPACT_DURATION / 1000;
  for (int k = 2; k < 999; k++)
    most = fmax(most, fabs((xi[k + 1] - 2 * xi[k] + xi[k - 1]) / (dt * dt) + 1.25 * pow(xi[k], 1.5)));
  CU_ASSERT(most < 2e-5);
  free(xi);
}

static void springs_converge(void) {
  static const double psi1[] = {0.02, 0.2, 0.5, 0.9075, 1, 1.2, 2, 2.7, 3.3, 3.6, 4, 4.5, 4.86, 5, 5.86, 8, 20};
  for (size_t k = 0; k < sizeof psi1 / sizeof *psi1; k++) {
    CU_ASSERT(fabs(rebound(NULL, chi28, psi1[k], 2000) - rebound(NULL, chi28, psi1[k], 4000)) < 1.5e-6);
    CU_ASSERT(fabs(rebound(NULL, chi30, psi1[k], 2000) - rebound(NULL, chi30, psi1[k], 4000)) < 1.5e-6);
  }
}

/* The psi1 at which psi2 changes its sign. */
static double sign_change(double chi) {
  double low = 0.6, high = 1.1;
  for (int n = 0; n < 20; n++) {
    const double middle = (low + high) / 2;
    *(rebound(NULL, chi, middle, 1000) > 0 ? &low : &high) = middle;
  }
  return low;
}

static void springs_give_maws_curve(void) {
  CU_ASSERT(fabs(sign_change(chi28) - 0.9075) < 5e-5);
  CU_ASSERT(fabs(sign_change(chi30) - 0.8099) < 5e-5);
  const double chi[] = {chi28, chi30}, least[] = {-1.49, -1.48};
  for (int c = 0; c < 2; c++) {
    double min = 0, where = 0, max = 0;
    for (double psi1 = 0.1; psi1 < 4.85; psi1 += 0.05) {
      const double psi2 = rebound(NULL, chi[c], psi1, 500);
      where = psi2 < min ? psi1 : where, min = fmin(min, psi2), max = fmax(max, psi2);
    }
    CU_ASSERT(fabs(min - least[c]) < 0.006 && where > 3.5 && where < 3.8);
    CU_ASSERT(max > 0.04 && max < 0.07);
    CU_ASSERT(fabs(rebound(NULL, chi[c], 4 * chi[c] - 1, 2000) + 1) < 1e-6);
    CU_ASSERT(fabs(rebound(NULL, chi[c], 4 * chi[c], 2000)) < 1e-6);
    CU_ASSERT(fabs(rebound(NULL, chi[c], 9, 2000) - 9 + 4 * chi[c]) < 1e-6);
  }
}

/* The largest error of a law in psi2, for psi1 from this value to 6. */
static double error_of(const char *law, double psi1) {
  double most = 0;
  for (; psi1 < 6; psi1 += 0.1)
    most = fmax(most, fabs(rebound(law, chi28, psi1, 4000) - rebound(NULL, chi28, psi1, 400)));
  return most;
}

static void errors_of_simplified_laws(void) {
  CU_ASSERT(fabs(error_of("mindlin", 0.1) - 0.49) < 0.005);
  CU_ASSERT(fabs(error_of("mindlin_scaled", 0.1) - 0.44) < 0.005);
  CU_ASSERT(fabs(error_of("randall", 0.1) - 0.15) < 0.002);
  CU_ASSERT(error_of("randall", 3) < 0.001);
  CU_ASSERT(fabs(error_of("linear", 0.1) - 0.618) < 0.002); /* k_s = 8 G* a at alpha_max */
  CU_ASSERT_EQUAL(rebound("none", chi28, 0.7, 100), 0.7);
  CU_ASSERT(fabs(rebound("mindlin", chi28, 8, 20000) - 8 + 4 * chi28) < 1e-5);
  for (double psi1 = 0.3; psi1 < 6; psi1 += 0.3) /* the limit of small steps has been reached */
    for (int k = 0; k < 4; k++) {
      static const char *const laws[] = {"linear", "mindlin", "mindlin_scaled", "randall"};
      const double limit[] = {1e-6, 1e-6, 1e-6, 3e-4};
      CU_ASSERT(fabs(rebound(laws[k], chi28, psi1, 20000) - rebound(laws[k], chi28, psi1, 10000)) < limit[k]);
    }
}

/* If the contact slides during the whole impact, the dissipation (psi1^2 - psi2^2)/(5 chi) is all caused by gross
 * sliding; otherwise only a part of it is. */
static void gross_sliding_is_part_of_dissipation(void) {
  for (double psi1 = 0.25; psi1 < 8; psi1 += 0.25) {
    struct impact_path path;
    CU_ASSERT(impact_exact(&path, chi28, psi1, 2000));
    const double lost = (psi1 * psi1 - path.psi2 * path.psi2) / (5 * chi28);
    CU_ASSERT(path.slid > 0 && path.slid < lost * (1 + 1e-6));
    if (psi1 > 4 * chi28 - 1)
      CU_ASSERT(fabs(path.slid - lost) < 1e-5 * lost);
    impact_path_free(&path);
  }
}

/* Gross sliding in either direction, with t in units of alpha_max/V_N. From f = xi^(3/2) and xi'' = -(5/4) xi^(3/2) follow
 * psi = psi1 - 2 chi (1 - xi'), so that d = psi1 t - 2 chi (t - xi) and psi2 = psi1 - 4 chi. Gross sliding dissipates
 * (psi1^2 - psi2^2)/(5 chi). Without a shear force d = psi1 t. In `randall` the law itself reduces the force to the limit
 * while the normal force decreases. The tolerances are two to three times the errors, which for d and for the exact f
 * are of second order in the step, for psi2 and for the dissipation between second and third. The force of a law is the
 * limit itself, to rounding. */
static void gross_sliding_of_every_law(void) {
  static const struct errors {
    double psi2, slid, f, d;
  } exact = {3e-8, 6e-7, 3e-7, 4e-8}, simple = {5e-10, 3e-10, 1e-14, 2e-8};
  static const char *const laws[] = {NULL, "linear", "mindlin", "mindlin_scaled", "randall", "none"};
  enum { STEPS = 20000 };
  for (int k = 0; k < 6; k++)
    for (int sign = -1; sign <= 1; sign += 2) {
      struct impact_path path;
      const double psi1 = 8 * sign, slides = k < 5, chi = chi28 * slides, psi2 = psi1 - 4 * sign * chi;
      const int steps = k ? STEPS : 2000;
      const struct errors error = k ? simple : exact;
      CU_ASSERT(k ? impact_law(&path, laws[k], 1.5, chi28, psi1, steps) : impact_exact(&path, chi28, psi1, steps));
      CU_ASSERT(fabs(path.psi2 - psi2) < error.psi2);
      if (k < 3 || k == 5) /* the others have micro-slip, which is not counted as gross sliding */
        CU_ASSERT(fabs(path.slid - slides * (psi1 * psi1 - psi2 * psi2) / (5 * chi28)) < error.slid);
      CU_ASSERT_EQUAL(path.steps, steps);
      for (int i = 2; i < steps; i += 2) {
        const double t = IMPACT_DURATION * i / steps, xi = path.xi[i];
        const bool right = fabs(path.f[i] - sign * slides * pow(xi, 1.5)) < error.f &&
                           ((k == 4 && i > steps / 2) || path.slides[i] == (k < 5)) &&
                           fabs(path.d[i] - psi1 * t + 2 * sign * chi * (t - xi)) < error.d;
        CU_ASSERT(right);
        if (!right)
          break;
      }
      impact_path_free(&path);
    }
}

/* The spring of the law `linear` stores no energy at the end, so gross sliding dissipates all that is missing, to rounding.
 * A law has no preferred direction. */
static void sliding_of_the_linear_law(void) {
  for (double psi1 = 0.3; psi1 < 6; psi1 += 0.7) {
    struct impact_path path, back;
    CU_ASSERT(impact_law(&path, "linear", 1.5, chi28, psi1, 20000));
    CU_ASSERT(fabs(path.slid - (psi1 * psi1 - path.psi2 * path.psi2) / (5 * chi28)) < 1e-12);
    impact_path_free(&path);
    static const char *const laws[] = {"linear", "mindlin", "mindlin_scaled", "randall"};
    for (int k = 0; k < 4; k++) {
      CU_ASSERT(impact_law(&path, laws[k], 1.5, chi28, psi1, 1000));
      CU_ASSERT(impact_law(&back, laws[k], 1.5, chi28, -psi1, 1000));
      CU_ASSERT(fabs(path.psi2 + back.psi2) < 1e-12 && fabs(path.slid - back.slid) < 1e-12);
      impact_path_free(&path), impact_path_free(&back);
    }
  }
}

/* The mean of the restitution over angles of incidence from 0 to `to` degrees, in steps of `by` degrees, for mu = 0.12
 * [R89 sec. 5.4]. At 0 and 90 degrees the restitution is 1. */
static double average(int by, int to) {
  const double pi = 3.14159265358979323846, slope = 0.12 * 1.72 / 1.44;
  double sum = 0;
  int count = 0;
  for (int angle = 0; angle <= to; angle += by, count++) {
    const double vt = tan(angle * pi / 180), psi1 = vt / slope;
    const double after = vt - (psi1 - rebound(NULL, chi28, psi1, 400)) * slope / 3.5;
    sum += angle == 90 ? 1 : hypot(1, after) / hypot(1, vt);
  }
  return sum / count;
}

static void mean_restitution(void) {
  CU_ASSERT(fabs(average(1, 90) - 0.9371) < 5e-5);
  CU_ASSERT(fabs(average(5, 85) - 0.9365) < 5e-5);
  CU_ASSERT(fabs(average(10, 60) - 0.9356) < 5e-5);
}

/* The solution for a sphere that strikes a wall with this spin, in a stage with this end. */
static struct nb_solution impact_on_wall(double spin, const char *end) {
  struct words page = {0};
  struct written it;
  struct refs_scene scene;
  words_add(&page,
            "units none\nmaterial m density 1 young 1e6 poisson 0.28 friction 0.2\nnormal hertz\n"
            "shear mindlin_deresiewicz\nsphere 0 1 radius 1 m spin %g\nwall w -9 0 to 9 0 m\n"
            "monitor C sphere 1 with wall w\nimpact C speed 1 angle 0.4\nstep 40 per collision\n"
            "record impact.angle impact.time C.overlap C.normal C.sliding\nstage s\n%s\n",
            spin, end);
  written_scene(&it, &page);
  scene.scene = it.scene;
  const struct nb_solution solution = refs_solution("oblique_impact", &scene);
  written_free(&it);
  return solution;
}

/* The angle of incidence is that between the velocity of the centre and the normal. It is not below 0 if a spin reverses
 * the velocity of the point of contact. */
static void angle_of_incidence_with_spin(void) {
  static const double spins[] = {-3, -0.1, 0, 0.1, 3};
  for (size_t k = 0; k < sizeof spins / sizeof *spins; k++) {
    struct nb_solution solution = impact_on_wall(spins[k], "cycles 40");
    NEAR(refs_value(&solution, "impact.angle"), 0.4, 1e-14);
    solution_free(&solution);
  }
}

/* The impulse J against the velocity vx + R w of the point of contact changes psi by 7/2 J/(m mu kappa V_N), and by J/m
 * and 5/2 J/(m R) the velocities vx = sin 0.4 and w, also if the point of contact moves against the centre. Here R = 1,
 * V_N = cos 0.4, m = 4 pi/3 and kappa = 1.72/1.44. Before the impact there is no shear force. */
static void velocities_with_spin(void) {
  static const double spins[] = {-3, -0.1, 0.1, 3};
  const double vx = sin(0.4), vn = cos(0.4), mass = 4. / 3 * acos(-1);
  for (size_t k = 0; k < sizeof spins / sizeof *spins; k++) {
    struct nb_solution solution = impact_on_wall(spins[k], "cycles 40");
    const double change = refs_value(&solution, "impact.psi1") - refs_value(&solution, "impact.psi2");
    const double by = copysign(change * 0.2 * (1.72 / 1.44) * vn / 3.5, vx + spins[k]);
    const double spin = spins[k] - 2.5 * by;
    NEAR(refs_value(&solution, "impact.restitution"), hypot(vn, vx - by), 1e-12);
    NEAR(refs_value(&solution, "impact.energy.tangential"), mass * (vx - by) * (vx - by) / 2, 1e-9);
    NEAR(refs_value(&solution, "impact.energy.rotational"), 0.4 * mass * spin * spin / 2, 1e-3);
    const struct nb_solution_curve *shear = solution_find_curve(&solution, "impact.shear", "impact.time");
    CU_ASSERT_FATAL(shear != NULL);
    CU_ASSERT(shear->at(shear->data, -0.5) == 0 && shear->at(shear->data, 0.5) != 0);
    solution_free(&solution);
  }
}

/* A stage has values if it ends at a time, a force or the sliding of the impact. It is not known when others end. */
static void stages_that_end_otherwise(void) {
  static const char *const conditions[] = {"impact.time above 0.3", "impact.shear above 0.3", "impact.normal above 0.3",
                                           "C.sliding above 0.5",   "C.overlap above 1e-9",   "C.normal above 1e-9"};
  for (int k = 0; k < 6; k++) {
    char end[64];
    snprintf(end, sizeof end, "until %s at most 40 cycles", conditions[k]);
    struct nb_solution solution = impact_on_wall(0, end);
    CU_ASSERT_EQUAL(solution_find(&solution, "impact.time in s") != NULL, k < 4);
    solution_free(&solution);
  }
}

/* `rebound` returns psi2 = psi1 - 4 chi from psi1 = 4 chi on, that of the springs below, and 0 for an impact along the
 * normal. psi1 = V_T/(mu kappa V_N) with kappa = (2 - nu)/(2 - 2 nu). */
static void psi2_of_the_reference_rebound(void) {
  const double psi1[] = {0, 0.5, 2, 3.2 * chi30, 3.3 * chi30, 4.01 * chi30, 5 * chi30}, mu = 0.1, kappa = 1.7 / 1.4;
  for (size_t k = 0; k < sizeof psi1 / sizeof *psi1; k++) {
    struct words page = {0};
    struct written it;
    struct refs_scene scene;
    words_add(&page,
              "units none\nmaterial a density 1 young 1e6 poisson 0.3 friction %g\nnormal hertz\n"
              "shear mindlin_deresiewicz\nsphere 0 1 radius 1 a\nwall w -9 0 to 9 0 a\nmonitor C sphere 1 with wall w\n"
              "impact C speed 0.5 angle %.17g\nstep 0.001\nrecord energy.kinetic\nstage s\ncycles 1\n",
              mu, atan(psi1[k] * mu * kappa));
    written_scene(&it, &page);
    scene.scene = it.scene;
    struct nb_solution solution = refs_solution("rebound", &scene);
    const double wanted = psi1[k] >= 4 * chi30 ? psi1[k] - 4 * chi30 : k == 0 ? 0 : rebound(NULL, chi30, psi1[k], 2000);
    CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "impact.psi2"), wanted, 1e-9);
    solution_free(&solution), written_free(&it);
  }
}

static void other_scenes_are_refused(void) {
  struct refs_scene it;
  refs_nine_discs(&it, 1e9, 2, 40, 400);
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("oblique_impact", &it).text, "impact"));
}

void suite_refs_impact(void) {
  CU_pSuite suite = CU_add_suite("refs_impact", NULL, NULL);
  CU_add_test(suite, "the approach is that of Hertz", approach_is_hertz);
  CU_add_test(suite, "psi2 converges with the number of steps", springs_converge);
  CU_add_test(suite, "psi2 has the values of Maw's curve", springs_give_maws_curve);
  CU_add_test(suite, "errors of simplified laws", errors_of_simplified_laws);
  CU_add_test(suite, "dissipation by gross sliding is a part of the total dissipation",
              gross_sliding_is_part_of_dissipation);
  CU_ADD_TEST(suite, gross_sliding_of_every_law);
  CU_ADD_TEST(suite, sliding_of_the_linear_law);
  CU_add_test(suite, "mean restitution over the angle of incidence", mean_restitution);
  CU_ADD_TEST(suite, angle_of_incidence_with_spin);
  CU_ADD_TEST(suite, velocities_with_spin);
  CU_ADD_TEST(suite, stages_that_end_otherwise);
  CU_ADD_TEST(suite, psi2_of_the_reference_rebound);
  CU_add_test(suite, "other scenes are refused", other_scenes_are_refused);
}
