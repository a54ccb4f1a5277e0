/* Loading in special cases: centripetal gravity, `rotation off`, a boundary that is released, strained again or defined
 * again, one strain after another, and affine strain that is added twice.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>

#include "suites.h"
#include "written.h"

static const double pi = 3.14159265358979323846;

static double column(const struct nb_result *result, size_t row, size_t column) {
  return result->table.values[row * result->table.column_count + column];
}

static void run(struct nb_result *result, const char *statements) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\n%s", statements);
  written_scene(&it, &page);
  written_run(result, &it, NULL);
  written_free(&it);
}

/* A particle starts from rest at the distance d from the point and oscillates through it along a line. The acceleration
 * is G, towards the point, so the period is 4 (2d/G)^(1/2). With d = G dt^2 ((N + 1/2)^2 + 1/4)/2 the point lies in the
 * middle of a step. In the scheme the particle is then at rest at -d after 2N + 1 steps, and at d after as many further
 * steps, to rounding. The period of the scheme, 4N + 2 steps, differs from the exact one by the fraction 1/(8 N^2). At
 * the distance r gravity has done the work m G (d - r). */
static void a_particle_oscillates_through_the_point(void) {
  enum { N = 100 };
  const double dt = 0.01, g = 0.5, d = g * dt * dt / 2 * ((N + 0.5) * (N + 0.5) + 0.25), mass = 2 * pi;
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page,
            "units none\nmaterial m density 2 kn 1\nstep %g\ndisc %.17g 4 radius 1 m\nmonitor D disc 1\n"
            "record D.x D.y D.vx energy.gravity work.balance energy.balance\n"
            "stage s\ngravity centripetal %g about 3 4\ncycles %d\n",
            dt, 3 + d, g, 4 * N + 2);
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  for (size_t n = 0; n <= N; n++) {
    const double t = (double)n * dt;
    CU_ASSERT_DOUBLE_EQUAL(column(&result, n, 0), 3 + d - g * t * t / 2, 1e-13);
    CU_ASSERT_DOUBLE_EQUAL(column(&result, n, 3), mass * g * (g * t * t / 2), 1e-13);
    CU_ASSERT_DOUBLE_EQUAL(column(&result, n, 4), 0, 1e-13);
  }
  CU_ASSERT_DOUBLE_EQUAL(column(&result, 2 * N + 1, 0), 3 - d, 1e-13);
  CU_ASSERT_DOUBLE_EQUAL(column(&result, 2 * N + 1, 2), 0, 1e-13);
  CU_ASSERT_DOUBLE_EQUAL(column(&result, 4 * N + 2, 0), 3 + d, 1e-13);
  CU_ASSERT_DOUBLE_EQUAL(column(&result, 4 * N + 2, 2), 0, 1e-13);
  CU_ASSERT_DOUBLE_EQUAL(column(&result, 4 * N + 2, 3), 0, 1e-13);
  CU_ASSERT_DOUBLE_EQUAL((4 * N + 2) * dt, 4 * sqrt(2 * d / g), 2e-5 * 4);
  nb_result_free(&result);
  written_free(&it);
}

/* A circular orbit, v^2 = G r. The leapfrog scheme changes the angle by the fraction (v dt/r)^2/24 and keeps the
 * radius. */
static void a_circular_orbit(void) {
  struct nb_result result;
  run(&result,
      "material m density 2 kn 1\nstep 0.001\ndisc 2 0 radius 0.5 m velocity 0 1\nmonitor D disc 1\n"
      "record D.x D.y energy.kinetic energy.balance\nstage s\ngravity centripetal 0.5 about 0 0\ncycles 6283\n");
  const double angle = 6.283 / 2;
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "D.x"), 2 * cos(angle), 1e-6);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "D.y"), 2 * sin(angle), 1e-6);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "energy.balance"), 0, 1e-7);
  nb_result_free(&result);
}

/* Two discs that gravity presses together with m G each are in equilibrium: unbalanced.max and unbalanced.mean
 * include the weight. */
static void all_forces_count(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  const double depth = pi * 2 / 100; /* m G/k_n, G = 1 */
  words_add(
      &page,
      "units none\nmaterial m density 2 kn 100\nstep 0.001\ndisc %.17g 0 radius 1 m\ndisc %.17g 0 radius 1 m\n"
      "region A all\nrecord unbalanced.max A.unbalanced.mean\nstage s\ngravity centripetal 1 about 0 0\ncycles 5\n"
      "stage t\ngravity centripetal 1.5 about 0 0\ncycles 1\n",
      1 - depth / 2, depth / 2 - 1);
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT(column(&result, 5, 0) < 1e-12);
  CU_ASSERT(column(&result, 5, 1) < 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(column(&result, 6, 0), 0.5, 1e-4);
  CU_ASSERT_DOUBLE_EQUAL(column(&result, 6, 1), 0.5, 1e-4);
  nb_result_free(&result);
  written_free(&it);
}

/* A disc that cannot rotate slides with the deceleration mu g and keeps its angle. When it can rotate again, the
 * changes of its spin w and its velocity v satisfy I dw = R m dv to rounding. A fixed disc keeps its spin. */
static void rotation_off_and_on(void) {
  struct nb_result result;
  run(&result, "material m density 2 kn 1e4 ks 1e4 friction 0.25\nshear linear\nstep 0.001\nwall floor -9 0 to 90 0 m\n"
               "disc 0 0.9993716814692820 radius 1 m velocity 5 0 spin 3\nmonitor D disc 1\ngravity 0 -1\n"
               "disc 0 9 radius 1 m fixed spin 4\ndisc 0.5 10.9 radius 1 m fixed\nmonitor F disc 2\n"
               "record D.vx.half D.spin.half D.angle energy.changed work.balance F.spin.half\n"
               "stage a\nrotation off\ncycles 1000\nstage b\nrotation on\ncycles 1000\n");
  CU_ASSERT_DOUBLE_EQUAL(column(&result, 1000, 0), 5 - 0.25, 1e-3);
  CU_ASSERT_EQUAL(column(&result, 1000, 1), 0);
  CU_ASSERT_EQUAL(column(&result, 1000, 2), 0);
  CU_ASSERT_DOUBLE_EQUAL(column(&result, 1000, 3), -pi * 9 / 2, 1e-12); /* I w^2/2, I = pi R^2 rho R^2/2 */
  const double slower = column(&result, 1000, 0) - column(&result, 2000, 0);
  CU_ASSERT_DOUBLE_EQUAL(slower, 0.25, 1e-3);
  /* rotation begins at t_0, half a step after that velocity */
  CU_ASSERT_DOUBLE_EQUAL(column(&result, 2000, 1), -2 * (slower - 0.25 * 0.0005), 1e-11);
  CU_ASSERT_EQUAL(column(&result, 1000, 5), 4);
  CU_ASSERT_EQUAL(column(&result, 2000, 5), 4);
  CU_ASSERT_DOUBLE_EQUAL(column(&result, 2000, 4), 0, 1e-10); /* 2000 sums of about 78, rounded */
  nb_result_free(&result);
}

/* `rotation on` in the first stage, or together with `zero velocities`, changes nothing: the stored velocities are then
 * those at time 0, not those of half a step before. */
static void rotation_on_from_the_start(void) {
  static const char *const loadings[] = {"damping con1 0.9 as cs79\n", "damping con1 0.8 as velocity\n",
                                         "damping con1 0.7 as all\n",
                                         "affine strain 0.01 -0.02 shear 0.03 accumulated\n"};
  for (int k = 0; k < 8; k++) {
    struct nb_result results[2];
    for (int on = 0; on < 2; on++) {
      struct words page = {0};
      struct written it;
      words_add(&page, "units none\nmaterial m density 2 kn 1\nstep 0.001\ndisc 3 4 radius 1 m velocity 5 6 spin 7\n"
                       "monitor D disc 1\nrecord D.vx D.vy D.spin D.vx.half D.vy.half D.spin.half\n");
      words_add(&page, k < 4 ? "stage a\n" : "stage a\ncycles 3\nstage b\nzero velocities\n");
      words_add(&page, "%s%scycles 3\n", loadings[k % 4], on ? "rotation on\n" : "");
      written_scene(&it, &page);
      written_run(&results[on], &it, NULL);
      written_free(&it);
    }
    CU_ASSERT(written_same_table(&results[0].table, &results[1].table));
    nb_result_free(&results[0]), nb_result_free(&results[1]);
  }
}

/* When a boundary under stress is fixed again, the circle is the one through its particles, which have moved from 20
 * to 17.6: a disc at 16.5 is inside. If the earlier strain were applied again, the radius would be 15.6, and the
 * disc would join. */
static void a_boundary_is_fixed_again(void) {
  struct nb_result result;
  run(&result, "material m density 2 kn 100\nstep 0.125\ndisc 20 0 radius 1 m\ndisc 0 20 radius 1 m\n"
               "disc -20 0 radius 1 m\ndisc 0 -20 radius 1 m\ndisc 11.7 11.7 radius 1 m\n"
               "record boundary.particles boundary.radius\nboundary circle 0 0 radius 20\n"
               "stage a\nboundary strain -0.01 -0.01\ncycles 100\nstage b\nboundary stress 1e-9 1e-9\ncycles 1\n"
               "stage c\nboundary fixed\ncycles 2\n");
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "boundary.radius"), 17.6, 0.05);
  CU_ASSERT_EQUAL(written_last(&result, "boundary.particles"), 4);
  nb_result_free(&result);
}

/* A disc that leaves a boundary under stress joins the boundary when the boundary is fixed again: the circle has the
 * radius 20, and the disc is at (15.5, 15.5). An ellipse that is twice as wide would contain the disc. */
static void a_disc_joins_the_boundary_that_is_fixed_again(void) {
  struct nb_result result;
  run(&result, "material m density 2 kn 100\nstep 0.125\ndisc 20 0 radius 1 m\ndisc 0 20 radius 1 m\n"
               "disc -20 0 radius 1 m\ndisc 0 -20 radius 1 m\ndisc 11.7 11.7 radius 1 m velocity 0.5 0.5\n"
               "record boundary.particles boundary.radius\nboundary circle 0 0 radius 20\n"
               "stage a\nboundary fixed\ncycles 1\nstage b\nboundary stress 1e-9 1e-9\ncycles 60\n"
               "stage c\nboundary fixed\ncycles 1\n");
  CU_ASSERT_EQUAL(column(&result, 61, 0), 4);
  CU_ASSERT_DOUBLE_EQUAL(column(&result, 61, 1), 20, 1e-6);
  CU_ASSERT_EQUAL(written_last(&result, "boundary.particles"), 5);
  nb_result_free(&result);
}

/* A disc that moves outward joins a boundary that moves inward, in the same cycle whatever the skin is. So the list of
 * candidates must include all discs that can reach the boundary before the list is made again. */
static void no_disc_passes_a_boundary_that_comes_to_meet_it(void) {
  double joined[4];
  static const double skins[] = {0.02, 0.4, 1, 3};
  for (size_t k = 0; k < 4; k++) {
    struct nb_result result;
    char page[1024];
    snprintf(page, sizeof page,
             "material m density 2 kn 100\nskin %g\nstep 0.05\ndisc 20 0 radius 0.1 m\ndisc 0 20 radius 0.1 m\n"
             "disc -20 0 radius 0.1 m\ndisc 0 -20 radius 0.1 m\ndisc 8 0 radius 0.1 m velocity 0.7 0.7\n"
             "record cycle boundary.particles\nboundary circle 0 0 radius 20\nstage a\n"
             "boundary strain -0.04 -0.04\nuntil boundary.particles above 4 at most 400 cycles\n",
             skins[k]);
    run(&result, page);
    joined[k] = written_last(&result, "cycle");
    nb_result_free(&result);
  }
  CU_ASSERT(joined[0] > 50 && joined[0] < 300);
  for (size_t k = 1; k < 4; k++)
    CU_ASSERT_EQUAL(joined[k], joined[0]);
}

/* Another `boundary circle` replaces the boundary: particles inside the new circle no longer belong to it, and each
 * particle counts once. */
static void another_circle(void) {
  struct nb_result result;
  run(&result, "material m density 2 kn 100\nstep 0.125\ndisc 20 0 radius 1 m\ndisc 0 20 radius 1 m\n"
               "disc -20 0 radius 1 m\ndisc 0 -20 radius 1 m\ndisc 12 9 radius 1 m\n"
               "record boundary.particles boundary.radius boundary.area\nboundary circle 0 0 radius 20\n"
               "stage a\ncycles 1\nstage b\nboundary circle 0 0 radius 15\ncycles 1\n"
               "stage c\nboundary circle 45 0 radius 49\ncycles 1\n");
  static const double seen[][3] = {{4, 20, 800}, {5, (4 * 20 + 15) / 5., 810}, {3, 0, 400}};
  for (size_t k = 0; k < 3; k++) {
    CU_ASSERT_EQUAL(column(&result, k + 1, 0), seen[k][0]);
    if (k < 2)
      CU_ASSERT_DOUBLE_EQUAL(column(&result, k + 1, 1), seen[k][1], 1e-13);
    CU_ASSERT_DOUBLE_EQUAL(column(&result, k + 1, 2), seen[k][2], 1e-11);
  }
  nb_result_free(&result);
}

/* Two particles of a boundary are moved until they overlap by a, and are then released. Their spring has the energy
 * k a^2/2, which counts as supplied from outside (energy.changed). The energy residual is the error of the step, a
 * fraction of (k/m) dt^2. The same holds under a boundary stress. */
static void energy_of_released_springs(void) {
  static const char *const ends[] = {"boundary none\n", "boundary stress 1e-9 1e-9\n"};
  for (size_t k = 0; k < 2; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(
        &page,
        "units none\nmaterial m density 2 kn 1000\nstep 0.0005\ndisc 1 0 radius 1 m\ndisc -1 0 radius 1 m\n"
        "boundary circle 0 0 radius 1\nrecord energy.changed energy.kinetic energy.balance energy.stored\n"
        "stage s\nboundary strain -0.1 0\ncycles 1000\nstage h\nboundary fixed\ncycles 1\nstage t\n%scycles 1000\n",
        ends[k]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    const double depth = 2 - 2 * pow(1 - 0.1 * 0.0005, 1000), held = 1000 * depth * depth / 2;
    CU_ASSERT_EQUAL(column(&result, 1001, 0), 0);
    CU_ASSERT_DOUBLE_EQUAL(column(&result, 1002, 0), held, 1e-3 * held);
    double worst = 0;
    for (size_t n = 1002; n < result.table.row_count; n++)
      worst = fmax(worst, fabs(column(&result, n, 2)));
    CU_ASSERT(worst < 4e-4 * held); /* (k/m*) dt^2 = 8e-5, m* = m/2 */
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "energy.stored"), 0, 0);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "energy.kinetic"), held, 1e-3 * held);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* A particle that presses on a wall becomes part of a boundary, which has no contacts with walls, and is then released.
 * The energy of its spring is removed from the balance, and later supplied from outside. The residual is the error of
 * the step; without this account it would be the whole energy. The wall has the number of a particle of the boundary or of
 * another particle. Another wall presses on a particle inside: its energy stays. */
#define INSIDE "wall v 2 0.95 to -2 0.95 m"
static void energy_of_springs_to_walls(void) {
  /* the second pair has a common end at the point of contact, where only one of its two contacts counts */
  static const char *const walls[] = {"wall w 5.95 -3 to 5.95 3 m\n" INSIDE,
                                      "wall w 5.95 -3 to 5.95 0 m\nwall u 5.95 0 to 5.95 3 m\n" INSIDE,
                                      INSIDE "\nwall w 5.95 -3 to 5.95 3 m"};
  const double energy = 1000 * 0.05 * 0.05 / 2, step = 4e-4 * energy; /* (k/m) dt^2 = 1.6e-4 */
  for (size_t k = 0; k < sizeof walls / sizeof *walls; k++) {
    struct nb_result result;
    char text[640];
    snprintf(
        text, sizeof text,
        "material m density 2 kn 1000\nstep 0.001\ndisc 5 0 radius 1 m\ndisc 0 0 radius 1 m\ndisc -5 0 radius 1 m\n"
        "%s\n"
        "record energy.stored energy.removed energy.changed energy.balance energy.kinetic\n"
        "stage a\ncycles 1\nstage b\nboundary circle 0 0 radius 4\nboundary fixed\ncycles 3\nstage c\nboundary none\n"
        "cycles 3\n",
        walls[k]);
    run(&result, text);
    CU_ASSERT_DOUBLE_EQUAL(column(&result, 1, 0), 2 * energy, step); /* both springs */
    CU_ASSERT_DOUBLE_EQUAL(column(&result, 2, 0), energy, 10 * step);
    CU_ASSERT_DOUBLE_EQUAL(column(&result, 2, 1), energy, 1e-4 * step);
    CU_ASSERT_DOUBLE_EQUAL(column(&result, 5, 2), energy, step);
    for (size_t n = 0; n < 8; n++)
      CU_ASSERT_DOUBLE_EQUAL(column(&result, n, 3), 0, n < 5 ? 1e-3 * step : step);
    nb_result_free(&result);
  }
}

/* The velocity that `accumulated` has added to v stays in v when `affine strain` without `accumulated` follows:
 * x_(N+1) = x_N + (v + L x_N) dt. */
static void affine_strain_after_accumulated(void) {
  const double dt = 0.125;
  struct nb_result result;
  double x = 13, y = -6, vx = 0, vy = 0;
  run(&result,
      "material m density 2 kn 100\nstep 0.125\ndisc 13 -6 radius 1 m\nmonitor D disc 1\nrecord D.x D.y\nstage s\n"
      "affine strain 0.08 -0.16 accumulated\ncycles 20\nstage t\naffine strain 0.08 -0.16\ncycles 20\n");
  for (size_t n = 0; n < 40; n++) {
    const double cx = 0.08 * x, cy = -0.16 * y;
    if (n < 20)
      vx += cx, vy += cy;
    x += dt * (n < 20 ? vx : vx + cx), y += dt * (n < 20 ? vy : vy + cy);
  }
  const size_t last = result.table.row_count - 1;
  CU_ASSERT_DOUBLE_EQUAL(column(&result, last, 0), x, 1e-12 * fabs(x));
  CU_ASSERT_DOUBLE_EQUAL(column(&result, last, 1), y, 1e-12 * fabs(y));
  nb_result_free(&result);
}

/* Runs two spheres on the x axis, at x and -x, which are too heavy to be moved by forces, with these laws and this
 * affine strain. `accumulated-twice` adds L z, with the vector z between the centres, to their relative velocity in
 * every cycle. */
static void twice(struct nb_result *result, double x, const char *law, const char *strain, int cycles) {
  char page[512];
  snprintf(page, sizeof page,
           "material m density 1e20 young 3 poisson 0.25 kn 7 ks 5 friction 1e6\n%s\nstep 0.5\n"
           "sphere %.17g 0 radius 1 m\nsphere %.17g 0 radius 1 m\nmonitor C sphere 1 with sphere 2\n"
           "record C.normal C.shear C.dashpot.normal\nstage s\naffine strain %s accumulated-twice\ncycles %d\n",
           law, x, -x, strain, cycles);
  run(result, page);
}

/* A compression e per cycle. The distance D_0 = 1.9 becomes D_1 = (1 - e) D_0 and then D_2 = D_1 - e (D_0 + D_1). The
 * increments are D_0 - D_1 + e D_1 and D_1 - D_2 + e D_2. The first force is that of [R89 4.11], the second that of
 * [R89 4.12] with the contact radius a = (R* dn_1)^(1/2) of the first. The force of a linear spring follows from the
 * overlap and does not change. The force of its dashpot changes. */
static void normal_increment_with_affine_motion_twice(void) {
  const double e = 1e-3, d0 = 1.9, d1 = (1 - e) * d0, d2 = d1 - e * (d0 + d1);
  const double dn1 = d0 - d1 + e * d1, dn2 = d1 - d2 + e * d2;
  const double young = 3 / (2 * (1 - 0.0625)), radius = 0.5, a = sqrt(radius * dn1);
  const double first = 4. / 3 * young * sqrt(radius * dn1) * dn1;
  struct nb_result result;
  twice(&result, 0.95, "normal hertz_increment\nshear none", "-1e-3 per cycle 0 per cycle", 2);
  CU_ASSERT_DOUBLE_EQUAL(written_cell(&result.table, 1, "C.normal"), first, 1e-13 * first);
  CU_ASSERT_DOUBLE_EQUAL(written_cell(&result.table, 2, "C.normal"), first + 2 * young * a * dn2, 1e-12 * first);
  nb_result_free(&result);
  twice(&result, 0.95, "shear none\ndamping stiffness 0.2", "-1e-3 per cycle 0 per cycle", 1);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "C.normal"), 7 * (2 - d1), 1e-13);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "C.dashpot.normal"), 7 * 0.2 * dn1 / 0.5, 1e-13);
  nb_result_free(&result);
}

/* A shear c21 = g per cycle: the first sphere moves by g D_0 relative to the other one. The contact tangent is then t =
 * (g, -1)/(1 + g^2)^(1/2). Along t, L z adds the same component as this displacement once more. */
static void tangential_increment_with_affine_motion_twice(void) {
  const double g = 1e-3, d0 = 1.9;
  struct nb_result result;
  twice(&result, 0.95, "shear linear", "0 per cycle 0 per cycle c21 1e-3 per cycle", 1);
  CU_ASSERT_DOUBLE_EQUAL(fabs(written_last(&result, "C.shear")), 5 * 2 * g * d0 / sqrt(1 + g * g), 1e-14);
  nb_result_free(&result);
}

/* In the step of first touch only the displacement after the touch counts, and L z is not added. The distance vector
 * (D_0, 0) becomes ((1 - e) D_0, g D_0). */
static void first_touch_with_affine_motion_twice(void) {
  const double e = 1e-3, g = 5e-4, d0 = 2.0005, x = (1 - e) * d0, y = g * d0, d1 = sqrt(x * x + y * y);
  const double dn = (e * d0 * x - g * d0 * y) / d1, ds = (e * d0 * y + g * d0 * x) / d1;
  struct nb_result result;
  twice(&result, d0 / 2, "shear linear", "-1e-3 per cycle 0 per cycle c21 5e-4 per cycle", 1);
  CU_ASSERT(2 - d1 > 0 && 2 - d1 < dn);
  CU_ASSERT_DOUBLE_EQUAL(fabs(written_last(&result, "C.shear")), 5 * ds * (2 - d1) / dn, 1e-13);
  nb_result_free(&result);
}

/* A shear c12 dt N = 1 and then a compression by a = 0.995^140 deform the circle by S = diag(a, 1) (1 1; 0 1), in this
 * order. The disc at (7, 3) belongs to the boundary if S maps a point outside the radius 10 to (7, 3). This point is
 * (7/a - 3, 3), outside. With the factors in the other order it would be (7/a - 3/a, 3), inside. If `side` is -1, the
 * scene is mirrored at the y-axis. */
static void one_strain_after_another(void) {
  for (int side = -1; side < 2; side += 2) {
    struct nb_result result;
    char page[512];
    snprintf(page, sizeof page,
             "material m density 2 kn 100\nstep 0.125\ndisc %d 0 radius 1 m\ndisc %d 3 radius 1 m\nrecord "
             "boundary.particles\n"
             "boundary circle 0 0 radius 10\nstage s\nboundary strain 0 0 c12 %g c21 0\ncycles 100\nstage t\n"
             "boundary strain -0.04 0\ncycles 140\n",
             -12 * side, 7 * side, 0.08 * side);
    run(&result, page);
    CU_ASSERT_EQUAL(column(&result, 100, 0), 1);
    CU_ASSERT_EQUAL(column(&result, result.table.row_count - 1, 0), 2);
    nb_result_free(&result);
  }
}

/* The velocity at the end of a step is the mean of the velocities over the steps before and after this time, whatever
 * imposes a part of them. */
static void velocities_are_means_of_half_steps(void) {
  static const struct {
    const char *scene, *stage;
  } rows[] = {{"", "gravity 0.3 -1"},
              {"", "affine strain 0.1 -0.2 shear 0.05"},
              {"", "affine strain 0.1 -0.2 accumulated"},
              {"boundary circle 0 0 radius 3\n", "boundary strain 0.1 -0.2 shear 0.05"},
              {"periodic cell -20 -20 to 20 20\n", "cell strain 0.1 -0.2"}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1 kn 10\n%sdisc 5 2 radius 1 m velocity 0.3 -0.2\nmonitor D disc 1\n"
              "record D.vx D.vy D.vx.half D.vy.half\nstep 0.01\nstage s\n%s\ncycles 9\n",
              rows[k].scene, rows[k].stage);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    for (size_t r = 2; r + 1 < result.table.row_count; r++) {
      CU_ASSERT_DOUBLE_EQUAL(
          written_cell(&result.table, r, "D.vx"),
          (written_cell(&result.table, r, "D.vx.half") + written_cell(&result.table, r + 1, "D.vx.half")) / 2, 1e-14);
      CU_ASSERT_DOUBLE_EQUAL(
          written_cell(&result.table, r, "D.vy"),
          (written_cell(&result.table, r, "D.vy.half") + written_cell(&result.table, r + 1, "D.vy.half")) / 2, 1e-14);
    }
    CU_ASSERT(written_last(&result, "D.vx") != 0);
    nb_result_free(&result);
    written_free(&it);
  }
}

void suite_driven(void) {
  CU_pSuite suite = CU_add_suite("driven", NULL, NULL);
  CU_add_test(suite, "a particle oscillates through the point", a_particle_oscillates_through_the_point);
  CU_add_test(suite, "a circular orbit about the point", a_circular_orbit);
  CU_add_test(suite, "no disc passes a boundary that comes to meet it",
              no_disc_passes_a_boundary_that_comes_to_meet_it);
  CU_add_test(suite, "all forces count in the unbalanced force", all_forces_count);
  CU_add_test(suite, "rotation off and on", rotation_off_and_on);
  CU_add_test(suite, "rotation on from the start", rotation_on_from_the_start);
  CU_add_test(suite, "a boundary is fixed again", a_boundary_is_fixed_again);
  CU_add_test(suite, "a disc joins the boundary that is fixed again", a_disc_joins_the_boundary_that_is_fixed_again);
  CU_add_test(suite, "another circle is another boundary", another_circle);
  CU_add_test(suite, "energy of springs that a boundary releases", energy_of_released_springs);
  CU_add_test(suite, "energy of springs between a boundary and walls", energy_of_springs_to_walls);
  CU_add_test(suite, "affine strain after accumulated", affine_strain_after_accumulated);
  CU_add_test(suite, "affine motion twice: normal increment", normal_increment_with_affine_motion_twice);
  CU_add_test(suite, "affine motion twice: tangential increment", tangential_increment_with_affine_motion_twice);
  CU_add_test(suite, "affine motion twice: first touch", first_touch_with_affine_motion_twice);
  CU_add_test(suite, "strains one after another deform the circle in this order", one_strain_after_another);
  CU_add_test(suite, "velocities are means of half steps", velocities_are_means_of_half_steps);
}
