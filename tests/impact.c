/* The statement `impact`: the initial motion of the sphere, the time of first touch, and the measured quantities, which
 * must not depend on the direction of the impact.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>

#include "../src/core/model.h"
#include "../src/input/reader.h"
#include "../src/measure/impact.h"
#include "suites.h"
#include "written.h"

static const double pi = 3.14159265358979323846;

/* A sphere with the mass m = 4 pi/3 R^3 rho and the moment of inertia I has q = m R^2/I = 5/2. With k_n = 400 and
 * k_s = 320, kappa = k_n/k_s = 1.25. */
#define BALL "units none\nnormal linear\nshear linear\nmaterial m density 0.25 kn 400 ks 320 friction 0.3\n"
#define RECORD                                                                                                         \
  "record time B.x B.y B.vx B.vy B.spin C.overlap C.normal C.shear impact.psi1 impact.psi2 impact.angle impact.time "  \
  "impact.duration impact.restitution impact.normal impact.shear impact.slip impact.energy.normal "                    \
  "impact.energy.tangential impact.energy.rotational energy.kinetic\nstage s\ncycles 1\n"
#define ON_FLOOR "sphere 0 3 radius 0.5 m\nwall f -9 0 to 9 0 m\nmonitor B sphere 1\nmonitor C sphere 1 with wall f\n"

/* Writes a page with the statements of the particle and of the impact. Returns its model at time 0. */
static struct nb_model *made(struct written *it, const char *particle, const char *impact) {
  struct words page = {0};
  words_add(&page, BALL "%s%s\nstep 0.001\n" RECORD, particle, impact);
  written_scene(it, &page);
  return written_model(it, NULL);
}

static void initial_motion(void) {
  struct written it;
  struct nb_model *model = made(&it, ON_FLOOR, "impact C speed 2 angle 0.5 phase 0.25");
  NEAR(written_now(model, "impact.angle"), 0.5, 1e-15);
  NEAR(written_now(model, "impact.psi1"), tan(0.5) / (0.3 * 1.25), 1e-14);
  NEAR(written_now(model, "impact.psi2"), tan(0.5) / (0.3 * 1.25), 1e-14);
  NEAR(written_now(model, "B.vx"), 2 * sin(0.5), 1e-15);
  NEAR(written_now(model, "B.vy"), -2 * cos(0.5), 1e-15);
  NEAR(written_now(model, "B.y"), 0.5 + 0.25e-3 * 2 * cos(0.5), 1e-15);
  NEAR(written_now(model, "B.x"), -0.25e-3 * 2 * sin(0.5), 1e-12);
  CU_ASSERT_EQUAL(written_now(model, "impact.slip"), 0);
  written_cycles(model, 1);
  NEAR(written_now(model, "C.overlap"), 0.75e-3 * 2 * cos(0.5), 1e-11);
  NEAR(written_now(model, "impact.slip"), 0.75e-3 * 2 * sin(0.5), 1e-11);
  NEAR(written_now(model, "impact.duration"), 0.75e-3, 1e-12);
  nb_model_free(model), written_free(&it);
}

/* psi1 is computed from the relative velocity at the point of contact. So it contains the velocities of the sphere and of
 * its partner, another sphere or a wall. It also contains the surface speed of each sphere, which is its radius times its
 * angular velocity. */
static void psi1_is_of_the_contact(void) {
  static const char *const particles[] = {
      "sphere 0 3 radius 0.5 m spin 0.8\nwall f -9 0 to 9 0 m\nmonitor B sphere 1\nmonitor C sphere 1 with wall f\n",
      "sphere 1 3 radius 0.5 m spin 0.8\nwall f 2 0 to 9 0 m velocity 0.2 -0.1\nmonitor B sphere 1\n"
      "monitor C sphere 1 with wall f\n",
      "sphere 0 3 radius 0.5 m spin 2\nsphere 1 -1 radius 1.5 m velocity 0.3 0.1 spin -0.4\nmonitor B sphere 1\n"
      "monitor C sphere 1 with sphere 2\n",
      "sphere 0 3 radius 1.5 m velocity 0.3 0.1 spin -0.4\nsphere 1 -1 radius 0.5 m spin 2\nmonitor B sphere 2\n"
      "monitor C sphere 2 with sphere 1\n"};
  for (int k = 0; k < 4; k++) {
    struct written it;
    struct nb_model *model = made(&it, particles[k], "impact C speed 2 psi1 1.5 phase 1");
    const double slope = 1.5 * 0.3 * 1.25, a = written_now(model, "impact.angle");
    NEAR(written_now(model, "impact.psi1"), 1.5, 1e-14);
    NEAR(written_now(model, "impact.psi2"), 1.5, 1e-14);
    NEAR(written_now(model, "impact.restitution"), 1., 1e-14);
    NEAR(2 * sin(a) + 0.4, slope * 2 * cos(a), 1e-14);
    written_cycles(model, 1);
    CU_ASSERT(fabs(written_now(model, "C.overlap")) < 1e-6);
    written_cycles(model, 1);
    NEAR(written_now(model, "C.overlap"), 1e-3 * 2 * cos(a), 2e-3);
    NEAR(written_now(model, "impact.slip"), 1e-3 * slope * 2 * cos(a), 1e-4);
    nb_model_free(model), written_free(&it);
  }
}

/* The surface of a sphere that rotates moves at 2 m/s, faster than the contact. So the centre moves backwards. The angle
 * of incidence is above 0 all the same. */
static void the_angle_has_no_sign(void) {
  struct written it;
  struct nb_model *model = made(&it,
                                "sphere 0 3 radius 0.5 m spin 4\nwall f -9 0 to 9 0 m\nmonitor B sphere 1\n"
                                "monitor C sphere 1 with wall f\n",
                                "impact C speed 2 psi1 1.5");
  const double a = written_now(model, "impact.angle");
  CU_ASSERT(a > 0.1);
  NEAR(2 - 2 * sin(a), 1.5 * 0.3 * 1.25 * 2 * cos(a), 1e-14);
  NEAR(written_now(model, "B.vx"), -2 * sin(a), 1e-14);
  nb_model_free(model), written_free(&it);
}

/* Spheres 2 and 3 collide. They differ in radius and material. A fixed sphere has infinite mass. */
#define TWO                                                                                                            \
  "units none\nnormal %s\nmaterial a density 0.25 kn 400 ks 320 friction 0.3 young 0.5 poisson 0.1\n"                  \
  "material b density 2 kn 100 ks 0.8 friction 0.2 young 7e3 poisson 0.4\n"                                            \
  "sphere 0 9 radius 0.5 a\nsphere 3 3 radius 0.7 b spin 0.5\nsphere 3 0 radius 1.1 a spin 0.6\n"                      \
  "monitor A sphere 1 with sphere 2\nmonitor B sphere 2\nmonitor C sphere 2 with sphere 3\nmonitor D sphere 3\n"       \
  "impact C speed 2 psi1 %g\nstep 1e-4\nrecord energy.kinetic impact.energy.normal impact.energy.tangential "          \
  "impact.energy.rotational impact.angle impact.psi1\nstage s\ncycles 1\n"

static void effective_constants_of_two_particles(void) {
  static const char *const laws[] = {"linear\nshear linear", "hertz\nshear none"};
  for (int k = 0; k < 4; k++) {
    struct written it;
    struct words page = {0};
    words_add(&page, TWO, laws[k / 2], 0.5);
    written_scene(&it, &page);
    it.scene.particles[2].fixed = k % 2;
    const double ma = pi * 4 / 3 * 0.7 * 0.7 * 0.7 * 2, mb = pi * 4 / 3 * 1.1 * 1.1 * 1.1 * 0.25;
    const double m = k % 2 ? ma : ma * mb / (ma + mb), radius = 0.7 * 1.1 / 1.8;
    const double young = 1 / ((1 - 0.01) / 0.5 + (1 - 0.16) / 7e3);
    const double shear = 1 / (2 * 1.1 * 1.9 / 0.5 + 2 * 1.4 * 1.6 / 7e3), kn = 160, ks = 2 * 320 * 0.8 / 320.8;
    const struct nb_impact_state strike = nb_impact_incidence(&it.scene);
    const double depth = pow(5 * m * strike.normal_v * strike.normal_v / (4 * (4. / 3 * young * sqrt(radius))), 0.4);
    const bool hertz = k / 2;
    NEAR(strike.mass, m, 1e-14);
    NEAR(strike.kappa, hertz ? young / (4 * shear) : kn / ks, 1e-14);
    NEAR(strike.peak, hertz ? 4. / 3 * young * sqrt(radius) * pow(depth, 1.5) : strike.normal_v * sqrt(m * kn), 1e-13);
    NEAR(strike.duration, hertz ? 2.9432751843247047 * depth / strike.normal_v : pi * sqrt(m / kn), 1e-13);
    NEAR(strike.tangent_v, 0.5 * 0.2 * strike.kappa * strike.normal_v, 1e-13);
    if (k % 2 == 0) {
      struct nb_model *model = written_model(&it, NULL);
      const double turning = 0.2 * (ma * 0.49 * 0.25 + mb * 1.21 * 0.36), angle = written_now(model, "impact.angle");
      NEAR(written_now(model, "impact.energy.rotational"), turning, 1e-13);
      NEAR(written_now(model, "impact.energy.normal"), m * 4 * cos(angle) * cos(angle) / 2, 1e-13);
      NEAR(written_now(model, "impact.energy.tangential"), m * 4 * sin(angle) * sin(angle) / 2, 1e-12);
      nb_model_free(model);
    }
    written_free(&it);
  }
}

/* The sphere touches the wall at the point that is nearest to its centre. The rows have the sphere on both sides of the
 * wall, each also with a pivot (`about`) off the wall, and beyond both ends of the wall. */
static void impact_on_a_wall_at_its_nearest_point(void) {
  static const struct {
    const char *wall;
    double x, y, nx, ny; /* nearest point, and direction from there to the centre of the sphere */
  } walls[] = {{"wall f -9 1.5 to 9 1.5 m", 2, 1.5, 0, 1},
               {"wall f -9 1.5 to 9 1.5 m about 1 7", 2, 1.5, 0, 1},
               {"wall f -9 5.5 to 9 5.5 m", 2, 5.5, 0, -1},
               {"wall f -9 5.5 to 9 5.5 m about 0 1", 2, 5.5, 0, -1},
               {"wall f -9 0.5 to -1 0.5 m", -1, 0.5, 0.76822127959737585, 0.64018439966447988},
               {"wall f 5 0.5 to 9 0.5 m", 5, 0.5, -0.76822127959737585, 0.64018439966447988}};
  for (int k = 0; k < 6; k++) {
    struct written it;
    char particle[256];
    snprintf(particle, sizeof particle,
             "sphere 2 3 radius 0.5 m\n%s\nmonitor B sphere 1\nmonitor C sphere 1 with wall f\n", walls[k].wall);
    struct nb_model *model = made(&it, particle, "impact C speed 2 psi1 0");
    NEAR(written_now(model, "B.x"), walls[k].x + 0.5 * walls[k].nx, 1e-14);
    NEAR(written_now(model, "B.y"), walls[k].y + 0.5 * walls[k].ny, 1e-14);
    CU_ASSERT(fabs(written_now(model, "B.vx") + 2 * walls[k].nx) < 1e-14);
    NEAR(written_now(model, "B.vy"), -2 * walls[k].ny, 1e-14);
    CU_ASSERT(fabs(written_now(model, "impact.psi1")) < 1e-14);
    nb_model_free(model), written_free(&it);
  }
}

/* After separation the duration does not change, and the forces are 0. */
static void an_impact_ends_at_separation(void) {
  struct written it;
  struct nb_model *model = made(&it, ON_FLOOR, "impact C speed 2 angle 0.5 phase 0.5");
  do {
    NEAR(written_now(model, "impact.duration"), written_now(model, "time") - 0.5e-3, 1e-9);
    written_cycles(model, 1);
  } while (written_now(model, "C.overlap") > 0);
  const double lasts = written_now(model, "impact.duration");
  CU_ASSERT(lasts < written_now(model, "time") - 0.5e-3 && lasts > written_now(model, "time") - 1.5e-3);
  for (int n = 0; n < 5; n++) {
    written_cycles(model, 100);
    NEAR(written_now(model, "impact.duration"), lasts, 1e-12);
    CU_ASSERT_EQUAL(written_now(model, "impact.normal"), 0);
    CU_ASSERT_EQUAL(written_now(model, "impact.shear"), 0);
  }
  nb_model_free(model), written_free(&it);
}

/* Errors in the statement are reported; tests/bad has the messages. */
static void wrong_impacts_are_refused(void) {
  static const char *const wrong[] = {"impact B speed 2 angle 0.5",
                                      "impact C speed 2",
                                      "impact C speed 2 angle 1.6",
                                      "impact C speed 2 angle 0.5 psi1 1",
                                      "impact C speed 0.1 psi1 0.5",
                                      "impact D speed 2 psi1 0.5",
                                      "impact C speed 1 angle 0\nimpact C speed 2 angle 0"};
  static const char *const right = "impact C speed 2 psi1 0.5";
  for (int k = -1; k < 7; k++) {
    struct words page = {0};
    struct nb_mistakes mistakes = {0};
    struct nb_page read = {0};
    struct nb_scene scene = {0};
    words_add(
        &page,
        "```scene\n" BALL "material ice density 1 kn 400\nsphere 0 3 radius 0.5 m spin 1\nwall f -9 0 to 9 0 m\n"
        "wall g -9 9 to 9 9 ice\nmonitor B sphere 1\nmonitor C sphere 1 with wall f\nmonitor D sphere 1 with wall g\n"
        "%s\nstep 0.001\nstage s\ncycles 1\n```\n",
        k < 0 ? right : wrong[k]);
    nb_page_read_bytes(&read, "impact.md", page.text, page.length, &mistakes);
    nb_scene_read(&scene, &read, 0, NULL, &mistakes);
    CU_ASSERT_EQUAL(mistakes.count, k < 0 ? 0 : 1);
    nb_mistakes_free(&mistakes), nb_scene_free(&scene), nb_page_free(&read);
    free(page.text);
  }
}

/* Gross sliding on linear springs: N(t) is half a sine wave, and T = mu N. So the tangential velocity V_T of the point
 * of contact falls by 2 mu (1 + q) V_N, where V_N is the normal velocity at first touch. The other values follow from
 * this. */
static void gross_sliding(void) {
  static const char *const places[] = {"", "\ntransform rotate 1.1 translate 3 4", "\ntransform mirror x",
                                       "\ntransform mirror y rotate 2.5"};
  static const char *const impacts[] = {"impact C speed 2 angle 1.2", "impact C speed 2 angle 1.2 phase 0.6"};
  for (int k = 0; k < 8; k++) {
    char impact[128];
    struct written it;
    snprintf(impact, sizeof impact, "%s%s", impacts[k / 4], places[k % 4]);
    struct nb_model *model = made(&it, ON_FLOOR, impact);
    const double m = pi / 6 * 0.25, vn = 2 * cos(1.2), vt = 2 * sin(1.2), lasts = pi * sqrt(m / 400);
    double normal = 0, shear = 0, slipped = 0;
    while (written_now(model, "impact.time") < 1.1) {
      written_cycles(model, 1);
      normal = fmax(normal, written_now(model, "impact.normal"));
      shear = fmax(shear, written_now(model, "impact.shear"));
      if (written_now(model, "C.overlap") > 0)
        slipped = written_now(model, "impact.slip");
    }
    NEAR(written_now(model, "impact.time"), (written_now(model, "time") - (k < 4 ? 0 : 0.6e-3)) / lasts, 1e-12);
    NEAR(normal, 1., 1e-3);
    NEAR(shear, 1., 1e-3);
    NEAR(written_now(model, "impact.duration"), lasts, 1e-3);
    NEAR(written_now(model, "impact.psi2"), written_now(model, "impact.psi1") - 2 * 3.5 / 1.25, 1e-3);
    const double after = vt - 2 * 0.3 * vn, spin = 2.5 * 2 * 0.3 * vn;
    NEAR(written_now(model, "impact.restitution"), hypot(vn, after) / 2, 1e-3);
    NEAR(written_now(model, "impact.energy.normal"), m * vn * vn / 2, 1e-3);
    NEAR(written_now(model, "impact.energy.tangential"), m * after * after / 2, 1e-3);
    NEAR(written_now(model, "impact.energy.rotational"), 0.4 * m * spin * spin / 2, 2e-3);
    /* by symmetry, the mean of V_T over the impact is the mean of its values at first touch and at separation */
    NEAR(slipped, (2 * vt - 2 * 0.3 * 3.5 * vn) / 2 * lasts, 0.1);
    nb_model_free(model), written_free(&it);
  }
}

/* The energies of the impact sum to the kinetic energy if the partner does not move. */
static void energies_sum_to_the_kinetic_energy(void) {
  struct written it;
  struct nb_model *model = made(&it, ON_FLOOR, "impact C speed 2 angle 0.4");
  for (int n = 0; n < 20; n++) {
    written_cycles(model, 1);
    NEAR(written_now(model, "impact.energy.normal") + written_now(model, "impact.energy.tangential") +
             written_now(model, "impact.energy.rotational"),
         written_now(model, "energy.kinetic"), 1e-14);
  }
  nb_model_free(model), written_free(&it);
}

/* An elastic sphere: the duration and the peak force are those of [R89 5.9, 5.12], and kappa follows from Poisson's
 * ratio. */
static void elastic_spheres(void) {
  struct written it;
  struct words page = {0};
  words_add(&page, "normal hertz\nshear none\n"
                   "material m density 7800 kg/m3 young 210 GPa poisson 0.28 friction 0.12 kn 1 N/m ks 9 N/m\n"
                   "sphere 0 mm 3 mm radius 1 mm m\nwall f -9 mm 0 mm to 9 mm 0 mm m\nmonitor B sphere 1\n"
                   "monitor C sphere 1 with wall f\nimpact C speed 0.4 m/s angle 30 deg\nstep 10 ns\n" RECORD);
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  NEAR(written_now(model, "impact.psi1"), 2 * 0.72 / (0.12 * 1.72) * tan(pi / 6), 1e-12);
  double peak = 0;
  while (written_now(model, "impact.time") < 1.02) {
    written_cycles(model, 1);
    peak = fmax(peak, written_now(model, "impact.normal"));
  }
  NEAR(peak, 1., 1e-4);
  NEAR(written_now(model, "impact.duration"), written_now(model, "time") / written_now(model, "impact.time"), 1e-4);
  nb_model_free(model), written_free(&it);
}

void suite_impact(void) {
  CU_pSuite suite = CU_add_suite("impact", NULL, NULL);
  CU_add_test(suite, "initial motion", initial_motion);
  CU_add_test(suite, "psi1 is that of the point of contact", psi1_is_of_the_contact);
  CU_add_test(suite, "the angle of incidence has no sign", the_angle_has_no_sign);
  CU_add_test(suite, "effective constants of two particles", effective_constants_of_two_particles);
  CU_add_test(suite, "impact on a wall at its nearest point", impact_on_a_wall_at_its_nearest_point);
  CU_add_test(suite, "an impact ends at separation", an_impact_ends_at_separation);
  CU_add_test(suite, "wrong impacts are refused", wrong_impacts_are_refused);
  CU_add_test(suite, "gross sliding", gross_sliding);
  CU_add_test(suite, "energies sum to the kinetic energy", energies_sum_to_the_kinetic_energy);
  CU_add_test(suite, "duration and peak force of elastic spheres", elastic_spheres);
}
