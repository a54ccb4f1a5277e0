/* R89's time step: the speed of the Rayleigh wave, its fit, and the step of one sphere and of several different
 * spheres.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../src/measure/step.h"
#include "suites.h"
#include "written.h"

static const double pi = 3.14159265358979323846;

/* The root alpha is the speed of the Rayleigh wave over that of the shear wave. It must have the published digits, the
 * fit must have the known relative error, and the root must satisfy Rayleigh's equation in the squared form of the
 * thesis. */
static void the_root(void) {
  const struct {
    double nu, alpha, fit;
  } expected[] = {{0, 0.874032, 0.0029}, {0.25, 0.919402, -0.0022}, {0.5, 0.955313, 0.0030}};
  for (size_t k = 0; k < 3; k++) {
    const double alpha = nb_rayleigh_root(expected[k].nu);
    CU_ASSERT(fabs(alpha - expected[k].alpha) < 0.5e-6);
    CU_ASSERT(fabs(nb_rayleigh_fit(expected[k].nu) / alpha - 1 - expected[k].fit) < 0.5e-4);
  }
  for (double nu = 0; nu <= 0.5; nu += 0.01) {
    const double alpha = nb_rayleigh_root(nu), x = alpha * alpha, q = (1 - 2 * nu) / (2 * (1 - nu));
    CU_ASSERT(alpha > 0.87 && alpha < 0.96);
    CU_ASSERT(fabs(pow(2 - x, 4) - 16 * (1 - x) * (1 - x * q)) < 1e-14);
  }
}

/* Writes the four Rayleigh steps of a scene: the shortest and the mean step with the exact root, then both with the
 * fit. */
static void steps_of(const char *statements, double steps[4]) {
  static const char *const names[] = {"step.rayleigh", "step.rayleigh-mean", "step.rayleigh-fit",
                                      "step.rayleigh-fit-mean"};
  for (int k = 0; k < 4; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page, "%sstep 0.5 of %s\nrecord step %s\nstage s\ncycles 1\n", statements, names[k] + strlen("step."),
              names[k]);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    steps[k] = written_now(model, names[k]);
    CU_ASSERT(written_now(model, "step") == 0.5 * steps[k]);
    nb_model_free(model);
    written_free(&it);
  }
}

static void the_step_of_steel(void) {
  double steps[4];
  steps_of("material m density 7800 kg/m3 young 210 GPa poisson 0.28\nsphere 0 m 0 m radius 1 mm m\n", steps);
  CU_ASSERT(fabs(steps[2] - 1.050e-6) < 0.5e-9);
  CU_ASSERT(fabs(steps[0] / steps[2] * nb_rayleigh_root(0.28) / nb_rayleigh_fit(0.28) - 1) < 1e-14);
  CU_ASSERT(steps[1] == steps[0] && steps[3] == steps[2]);
  /* a collision with a wall at 0.4 m/s takes 7.9 of these steps */
  struct words page = {0};
  struct written it;
  words_add(&page, "material m density 7800 kg/m3 young 210 GPa poisson 0.28\nnormal hertz\nsphere 0 m 0 m radius 1 mm "
                   "m velocity 0.4 m/s 0 m/s\nwall w 3 mm -1 m to 3 mm 1 m m\nstep 1 of rayleigh\nrecord time\n"
                   "stage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  struct nb_collision shortest;
  CU_ASSERT_EQUAL_FATAL(nb_step_collision(&shortest, model, NULL), NB_OK);
  CU_ASSERT(fabs(shortest.duration / nb_step_rayleigh(model, true, true) - 7.9) < 0.05);
  nb_model_free(model);
  written_free(&it);
}

/* Different spheres, in either order: the smallest one need not have the shortest step. The mean step is that of a
 * sphere with the mean R, rho, G and nu. Fixed and rigid particles do not count. */
static void different_spheres(void) {
  static const char *const pairs[] = {"sphere 9 0 radius 1 b\nsphere 0 0 radius 0.5 a",
                                      "sphere 0 0 radius 0.5 a\nsphere 9 0 radius 1 b"};
  for (int k = 0; k < 2; k++) {
    double steps[4];
    char statements[512];
    snprintf(statements, sizeof statements,
             "units none\nmaterial a density 2 young 3 poisson 0\nmaterial b density 1 young 30 poisson 0.5\n"
             "material r density 1 rigid\n%s\nsphere 19 0 radius 0.01 a fixed\nsphere 30 0 radius 0.01 r\n",
             pairs[k]);
    steps_of(statements, steps);
    const double shortest = pi * sqrt(1 / 10.), mean = pi * 0.75 * sqrt(1.5 / 5.75);
    CU_ASSERT(fabs(steps[0] * nb_rayleigh_root(0.5) / shortest - 1) < 1e-14);
    CU_ASSERT(fabs(steps[1] * nb_rayleigh_root(0.25) / mean - 1) < 1e-14);
    CU_ASSERT(fabs(steps[2] * nb_rayleigh_fit(0.5) / shortest - 1) < 1e-14);
    CU_ASSERT(fabs(steps[3] * nb_rayleigh_fit(0.25) / mean - 1) < 1e-14);
  }
}

/* None of the four steps exists without a free particle that has elastic moduli. */
static void without_elastic_moduli(void) {
  static const char *const kinds[] = {"rayleigh", "rayleigh-mean", "rayleigh-fit", "rayleigh-fit-mean"};
  static const char *const spheres[] = {"material m density 1 kn 1\nsphere 0 0 radius 1 m",
                                        "material m density 1 young 1 poisson 0.2\nsphere 0 0 radius 1 m fixed"};
  for (int k = 0; k < 4; k++)
    for (int n = 0; n < 2; n++) {
      struct words page = {0};
      struct written it;
      struct nb_error error = {0};
      words_add(&page, "units none\n%s\nstep 1 of %s\nstage s\ncycles 1\n", spheres[n], kinds[k]);
      written_scene(&it, &page);
      CU_ASSERT_PTR_NULL(nb_model_create(&it.scene, NULL, &error));
      CU_ASSERT_EQUAL(error.status, NB_BAD_USE);
      CU_ASSERT_PTR_NOT_NULL(strstr(error.text, "no free particle has `young`"));
      CU_ASSERT_EQUAL(error.line, 5);
      written_free(&it);
    }
}

void suite_rayleigh(void) {
  CU_pSuite suite = CU_add_suite("rayleigh", NULL, NULL);
  CU_add_test(suite, "the speed of the Rayleigh wave and its fit", the_root);
  CU_add_test(suite, "the step of steel", the_step_of_steel);
  CU_add_test(suite, "shortest and mean step of different spheres", different_spheres);
  CU_add_test(suite, "a particle without elastic moduli", without_elastic_moduli);
}
