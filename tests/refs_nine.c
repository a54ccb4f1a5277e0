/* The references of the nine discs, compared with each other, with closed forms, with a leapfrog scheme and with a
 * general ODE solver.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_odeiv2.h>
#include <string.h>

#include "../src/core/model.h"
#include "lattice.h"
#include "refs_scenes.h"
#include "suites.h"

static const double kn = 1.35e9;

/* k_n d, where d is the displacement of a wall at the end of the first stage. */
static double force_unit(const struct refs_scene *it) {
  double mass = nb_particle_mass(&it->scene, &it->particles[0]);
  return kn * 0.12 * (double)it->stages[0].cycles * 0.12 * 2 * sqrt(mass / kn);
}

/* Compares the normal forces of the four monitors with these fractions of `unit`; two of the shear forces are 0. */
static void check_forces(const struct nb_solution *solution, double unit, double c, double d, double s, double m) {
  REFS_NEAR(refs_value(solution, "C.normal"), c * unit, 1e-12, unit);
  REFS_NEAR(refs_value(solution, "D.normal"), d * unit, 1e-12, unit);
  REFS_NEAR(refs_value(solution, "S.normal"), s * unit, 1e-12, unit);
  REFS_NEAR(refs_value(solution, "M.normal"), m * unit, 1e-12, unit);
  REFS_NEAR(refs_value(solution, "C.shear"), 0, 1e-12, unit);
  REFS_NEAR(refs_value(solution, "M.shear"), 0, 1e-12, unit);
}

/* The forces over k_n d in closed form. */
static void static_forces_equal_closed_forms(void) {
  struct refs_scene it;
  refs_nine_discs(&it, kn, 1, 40, 400);
  double unit = force_unit(&it);
  struct nb_solution solution = refs_solution("nine_discs_statics", &it);
  check_forces(&solution, unit, 3. / 7, 5. / 14, 9. / 14, 4. / 7);
  REFS_NEAR(fabs(refs_value(&solution, "S.shear")), 5. / 14 * unit, 1e-12, unit);
  REFS_NEAR(fabs(refs_value(&solution, "D.shear")), 1. / 14 * unit, 1e-12, unit);
  REFS_NEAR(refs_value(&solution, "C.normal in load"), 3. / 7 * unit, 1e-12, unit);
  REFS_NEAR(refs_value(&solution, "C.normal mean in rest"), 3. / 7 * unit, 1e-12, unit);
  CU_ASSERT_PTR_NULL(solution_find(&solution, "C.normal mean in load"));
  solution_free(&solution);

  refs_nine_discs(&it, kn * 2 / 3, 1, 40, 400);
  solution = refs_solution("nine_discs_statics", &it);
  check_forces(&solution, unit, 21. / 46, 9. / 23, 14. / 23, 25. / 46);
  solution_free(&solution);

  refs_nine_discs(&it, kn, 0, 40, 400); /* without friction nothing resists a rotation */
  solution = refs_solution("nine_discs_statics", &it);
  check_forces(&solution, unit, 0.5, 0.5, 0.5, 0.5);
  solution_free(&solution);

  refs_nine_discs(&it, kn, 2, 40, 400); /* without friction at the walls the discs can rotate like gears */
  it.materials[1] = it.materials[0];
  it.materials[1].friction = 0;
  for (size_t i = 0; i < 4; i++)
    it.walls[i].material = 1;
  for (int i = 0; i < 2; i++) {
    solution = refs_solution(i == 0 ? "nine_discs_statics" : "nine_discs", &it);
    REFS_NEAR(refs_value(&solution, "C.normal mean"), 0.5 * unit, 1e-12, unit);
    REFS_NEAR(refs_value(&solution, "D.shear mean"), 0, 1e-12, unit);
    solution_free(&solution);
  }
}

/* Corner discs that slide on the walls, with r = k_s/k_n and the friction coefficient f. The two equations at the head of
 * nine_discs_slip.c are solved by Cramer's rule. */
static void check_slip(double r, double f) {
  struct refs_scene it;
  refs_nine_discs(&it, r * kn, f, 40, 400);
  double unit = force_unit(&it), det = (2 - f + r) * (2 + 2 * r) - 2 * r * r;
  double d_c = ((1 - f) * (2 + 2 * r) + r) / det, d_m = ((2 - f + r) + 2 * r * (1 - f)) / det;
  struct nb_solution solution = refs_solution("nine_discs_slip", &it);
  check_forces(&solution, unit, d_m, d_c, 1 - d_c, 1 - d_m);
  REFS_NEAR(fabs(refs_value(&solution, "S.shear")), f * refs_value(&solution, "S.normal"), 1e-12, unit);
  solution_free(&solution);
}

static void sliding_equals_closed_form(void) {
  double f15 = tan(15 * M_PI / 180), f30 = tan(30 * M_PI / 180);
  check_slip(1, f15);
  check_slip(2. / 3, f15);
  check_slip(0.5, 0.1);
  /* At 30 degrees nothing slides. */
  struct refs_scene it;
  refs_nine_discs(&it, kn, f30, 40, 400);
  struct nb_solution slip = refs_solution("nine_discs_slip", &it), solution = refs_solution("nine_discs_statics", &it);
  REFS_NEAR(refs_value(&slip, "C.normal"), refs_value(&solution, "C.normal"), 1e-12, force_unit(&it));
  solution_free(&slip);
  solution_free(&solution);
  refs_nine_discs(&it, kn, f15, 40, 400);
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("nine_discs_statics", &it).text, "slips"));
  refs_nine_discs(&it, kn, f30, 40, 400); /* but contacts slip during the oscillation */
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("nine_discs", &it).text, "slips"));
}

/* The leapfrog scheme for the corner and middle discs, compared with the reference, which is a sum over the modes of 27
 * degrees of freedom. */
static void check_leapfrog(double r, unsigned long load) {
  struct refs_scene it;
  refs_nine_discs(&it, r * kn, 2, load, 4000);
  struct nb_solution solution = refs_solution("nine_discs", &it);
  const struct nb_solution_curve *centre = solution_find_curve(&solution, "C.normal", "cycle");
  const struct nb_solution_curve *wall = solution_find_curve(&solution, "S.shear", "time");
  CU_ASSERT_PTR_NOT_NULL_FATAL(centre);
  CU_ASSERT_PTR_NOT_NULL_FATAL(wall);
  double unit = force_unit(&it), f = 0.12, worst = 0, sign = refs_value(&solution, "S.shear mean") > 0 ? 1 : -1;
  double dt = f * 2 * sqrt(nb_particle_mass(&it.scene, &it.particles[0]) / kn);
  double d = 0, c = 0, m = 0, vc = 0, vm = 0; /* in units of the total displacement of the walls and of the step */
  for (unsigned long n = 0; n <= load + 4000; n++) {
    worst = fmax(worst, fabs(centre->at(centre->data, (double)n) / unit - m));
    worst = fmax(worst, fabs(sign * wall->at(wall->data, (double)n * dt) / unit - r * c));
    vc += 4 * f * f * (d - (2 + 2 * r) * c + r * m);
    vm += 4 * f * f * (d - (2 + 2 * r) * m + 2 * r * c);
    c += vc;
    m += vm;
    if (n < load)
      d += 1 / (double)load;
  }
  CU_ASSERT(worst < 1e-10);
  solution_free(&solution);
}

static void modes_equal_leapfrog(void) {
  check_leapfrog(1, 40);
  check_leapfrog(2. / 3, 120);
}

/* The two modes of the centre contact in closed form, and the mean from the static reference. */
static void mean_amplitude_and_frequency(void) {
  struct refs_scene it;
  refs_nine_discs(&it, kn, 2, 40, 4000);
  double unit = force_unit(&it), f = 0.12, sum = 0, rate = 0;
  for (int sign = -1; sign <= 1; sign += 2) {
    double square = 4 + sign * sqrt(2), phase = 2 * asin(sqrt(square) * f);
    double fraction = (1 - sign * sqrt(2)) / 2 / square; /* the part of the mode in the static force 3/7 */
    sum += fabs(fraction * 2 * sin(20 * phase) / sin(phase)) / 40;
    if (sign < 0)
      rate = phase / (2 * M_PI);
  }
  struct nb_solution solution = refs_solution("nine_discs", &it);
  struct nb_solution rest = refs_solution("nine_discs_statics", &it);
  double dt = f * 2 * sqrt(nb_particle_mass(&it.scene, &it.particles[0]) / kn);
  REFS_NEAR(refs_value(&solution, "C.normal amplitude"), sum * unit, 1e-11, unit);
  REFS_NEAR(refs_value(&solution, "C.normal amplitude in rest"), sum * unit, 1e-11, unit);
  REFS_NEAR(refs_value(&solution, "C.normal frequency"), rate / dt, 1e-11, rate / dt);
  REFS_NEAR(refs_value(&solution, "C.normal mean"), refs_value(&rest, "C.normal"), 1e-11, unit);
  REFS_NEAR(refs_value(&solution, "S.shear mean"), refs_value(&rest, "S.shear"), 1e-11, unit);
  REFS_NEAR(refs_value(&solution, "D.shear mean in rest"), refs_value(&rest, "D.shear"), 1e-11, unit);
  CU_ASSERT_PTR_NULL(solution_find(&solution, "C.normal mean in load"));

  /* The range of the curve, and the number of times that it rises through its mean. */
  const struct nb_solution_curve *curve = solution_find_curve(&solution, "C.normal", "cycle");
  CU_ASSERT_PTR_NOT_NULL_FATAL(curve);
  double high = 0, low = unit, mean = refs_value(&solution, "C.normal mean"), before = 0;
  int rises = 0;
  for (int n = 40; n <= 40 + 100000; n++) {
    double now = curve->at(curve->data, n);
    high = fmax(high, now);
    low = fmin(low, now);
    if (n > 40 && before < mean && now >= mean)
      rises++;
    before = now;
  }
  REFS_NEAR((high - low) / 2, sum * unit, 1e-4, sum * unit);
  REFS_NEAR(rises / 1e5, rate, 1e-5 / rate, rate);
  solution_free(&solution);
  solution_free(&rest);
}

/* The ODE of the nine discs, with forces from [CS79 12, 13, 16, 17]. It has 27 degrees of freedom: x, y and R theta of
 * each disc. */
struct ode {
  double r, square;   /* k_s/k_n, k_n/m */
  double east, south; /* of two walls along x: velocities; for add_contact_force, displacements */
};

/* Adds the force of one contact, over k_n, to f. b is a disc, or -1 for a wall. */
static void add_contact_force(const struct ode *ode, const double u[27], double f[27], int a, int b, double ex,
                              double ey) {
  double wall = ex > 0.5 ? ode->east : ey < -0.5 ? ode->south : 0;
  double dx = u[3 * a] - (b < 0 ? wall : u[3 * b]), dy = u[3 * a + 1] - (b < 0 ? 0 : u[3 * b + 1]);
  double spin = u[3 * a + 2] + (b < 0 ? 0 : u[3 * b + 2]); /* R theta */
  double n = dx * ex + dy * ey, s = ode->r * (dx * ey - dy * ex - spin);
  f[3 * a] -= n * ex + s * ey;
  f[3 * a + 1] -= n * ey - s * ex;
  f[3 * a + 2] += 2 * s; /* R^2/I = 2/m */
  if (b < 0)
    return;
  f[3 * b] += n * ex + s * ey;
  f[3 * b + 1] += n * ey - s * ex;
  f[3 * b + 2] += 2 * s;
}

static int motion(double t, const double y[], double dy[], void *data) {
  const struct ode *ode = data;
  struct ode now = *ode;
  now.east *= t;
  now.south *= t;
  double f[27] = {0};
  for (int i = 0; i < 9; i++) {
    add_contact_force(&now, y, f, i, i % 3 < 2 ? i + 1 : -1, 1, 0);
    add_contact_force(&now, y, f, i, i / 3 < 2 ? i + 3 : -1, 0, 1);
    if (i % 3 == 0)
      add_contact_force(&now, y, f, i, -1, -1, 0);
    if (i / 3 == 0)
      add_contact_force(&now, y, f, i, -1, 0, -1);
  }
  for (int i = 0; i < 27; i++) {
    dy[i] = y[27 + i];
    dy[27 + i] = ode->square * f[i];
  }
  return GSL_SUCCESS;
}

/* One wall moves inward and one tangentially, so that all discs move and rotate; both solutions are in continuous
 * time and agree to 1e-12. */
static void modes_equal_ode(void) {
  struct refs_scene it;
  refs_nine_discs(&it, 0.7 * kn, 2, 40, 40);
  for (size_t i = 0; i < 4; i++)
    it.motions[i].vx = it.motions[i].vy = 0;
  it.motions[1].vx = -1;
  it.motions[0].vx = 0.3;
  struct lattice lattice;
  struct nb_error error = {0};
  CU_ASSERT_EQUAL_FATAL(lattice_build(&lattice, &it.scene, &error), NB_OK);
  struct oscillation_modes modes = oscillation_modes_create(&lattice);
  struct ode ode = {.r = 0.7, .square = kn / nb_particle_mass(&it.scene, &it.particles[0]), .east = -1, .south = 0.3};
  gsl_odeiv2_system system = {motion, NULL, 54, &ode};
  gsl_odeiv2_driver *driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-4, 1e-16, 1e-14);
  double y[54] = {0}, t = 0, worst = 0, spin = 0;
  size_t c = (size_t)lattice_contact_of(&lattice, &it.monitors[0]),
         d = (size_t)lattice_contact_of(&lattice, &it.monitors[1]);
  struct oscillation *normal = oscillation_create(&lattice, &modes, 2 * c, OSCILLATION_CONTINUOUS, 1, &error);
  struct oscillation *shear = oscillation_create(&lattice, &modes, 2 * d + 1, OSCILLATION_CONTINUOUS, 1, &error);
  CU_ASSERT_PTR_NOT_NULL_FATAL(normal);
  CU_ASSERT_PTR_NOT_NULL_FATAL(shear);
  double unit = kn * lattice.step * 40;
  for (int n = 1; n <= 40; n++) {
    CU_ASSERT_EQUAL_FATAL(gsl_odeiv2_driver_apply(driver, &t, n * lattice.step, y), GSL_SUCCESS);
    double f_n = kn * (y[12] - y[15]), f_s = 0.7 * kn * (-(y[1] - y[4]) - (y[2] + y[5]));
    worst = fmax(worst, fabs(oscillation_at(normal, n) - f_n) / unit);
    worst = fmax(worst, fabs(oscillation_at(shear, n) - f_s) / unit);
    spin = fmax(spin, fabs(y[2]) / (40 * lattice.step));
  }
  CU_ASSERT(worst < 1e-12);
  CU_ASSERT(spin > 1e-3); /* the discs do rotate */
  free(normal);
  free(shear);
  lattice.step *= 10; /* too long for the calculation cycle only */
  CU_ASSERT_PTR_NULL(oscillation_create(&lattice, &modes, 0, OSCILLATION_STEPS, 1, &error));
  normal = oscillation_create(&lattice, &modes, 0, OSCILLATION_CONTINUOUS, 1, &error);
  CU_ASSERT_PTR_NOT_NULL(normal);
  free(normal);
  gsl_odeiv2_driver_free(driver);
  oscillation_modes_free(&modes);
  lattice_free(&lattice);
}

/* Moves the point P of every wall by `h` to the right of the wall; the wall stays where it is. The velocity of the new
 * point is that of the rigid motion of the wall. */
static void move_points(struct refs_scene *it, double h) {
  for (size_t k = 0; k < 4; k++) {
    struct nb_wall *wall = &it->walls[k];
    wall->h0 = h, wall->x += h * wall->ey, wall->y -= h * wall->ex;
    it->motions[k].vx += it->motions[k].spin * h * wall->ex, it->motions[k].vy += it->motions[k].spin * h * wall->ey;
  }
}

/* The solution depends on the motion of the walls, not on the point that the page uses to describe it. */
static void walls_about_other_points(void) {
  static const char *const references[] = {"nine_discs_statics", "nine_discs_slip", "nine_discs_distortion",
                                           "nine_discs"};
  for (size_t k = 0; k < 4; k++)
    for (int spins = 0; spins < 2; spins++)
      for (double h = -200; h < 300; h += 400) {
        struct refs_scene it;
        refs_nine_discs(&it, kn, 2, 40, 400);
        it.motions[0].spin = spins * 1e-4;
        const double unit = force_unit(&it);
        struct nb_solution on = refs_solution(references[k], &it);
        move_points(&it, h);
        struct nb_solution off = refs_solution(references[k], &it);
        CU_ASSERT(on.value_count > 0);
        CU_ASSERT_EQUAL_FATAL(on.value_count, off.value_count);
        for (size_t v = 0; v < on.value_count; v++)
          if (strstr(on.values[v].name, "normal") || strstr(on.values[v].name, "shear"))
            REFS_NEAR(refs_value(&off, on.values[v].name), on.values[v].value, 1e-9, unit);
        solution_free(&on);
        solution_free(&off);
      }
}

void suite_refs_nine(void) {
  CU_pSuite suite = CU_add_suite("refs_nine", NULL, NULL);
  CU_add_test(suite, "static forces equal closed forms", static_forces_equal_closed_forms);
  CU_add_test(suite, "forces with sliding equal the closed form", sliding_equals_closed_form);
  CU_add_test(suite, "modes in steps equal the leapfrog scheme", modes_equal_leapfrog);
  CU_add_test(suite, "modes in continuous time equal the ODE", modes_equal_ode);
  CU_add_test(suite, "mean, amplitude, frequency", mean_amplitude_and_frequency);
  CU_add_test(suite, "walls given by points off their lines", walls_about_other_points);
}
