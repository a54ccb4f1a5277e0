/* The rotation of particles by moments [CS79 23, 23a, 34-36], compared with an independent computation, with time steps
 * of two lengths.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>

#include "../src/core/model.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

static const double pi = 3.14159265358979323846;

/* The factors of a kick of the duration t: keep (lambda) for the old spin, push (eta) for the moment
 * (docs/METHOD.md). */
struct factors {
  double keep, push;
};
static struct factors undamped(double t) { return (void)t, (struct factors){1, 1}; }
static struct factors alpha(double t) { return (struct factors){(1 - 15 * t) / (1 + 15 * t), 1 / (1 + 15 * t)}; }
static struct factors con1_cs79(double t) { return (void)t, (struct factors){0.9 / 1.1, 1 / 1.1}; }
static struct factors con1_all(double t) { return (void)t, (struct factors){0.9, 0.9}; }

static const struct {
  const char *damping;
  struct factors (*over)(double t);
} kinds[] = {{"none", undamped}, {"mass 30", alpha}, {"con1 0.9 as cs79", con1_cs79}, {"con1 0.9 as all", con1_all}};

/* A rotating disc in contact with a sphere, with friction. */
static struct nb_model *gears(struct written *it, const char *damping) {
  struct words page = {0};
  words_add(
      &page,
      "units none\nmaterial a density 2 kn 1e4 ks 7e3 friction 5\nmaterial b density 3 kn 1e4 ks 7e3 friction 5\n"
      "shear linear\nstep 0.001\ndisc 0 0 radius 0.7 a spin 2\nsphere 1.2 1.55 radius 1.3 b spin 0.5\ndamping %s\n"
      "monitor A disc 1\nmonitor B sphere 2\n"
      "record A.moment A.spin A.spin.half A.angle B.moment B.spin B.spin.half B.angle\nstage s\ncycles 1\n",
      damping);
  written_scene(it, &page);
  return written_model(it, NULL);
}

static void moments_rotate_particles(void) {
  static const char *const names[2][4] = {{"A.moment", "A.spin", "A.spin.half", "A.angle"},
                                          {"B.moment", "B.spin", "B.spin.half", "B.angle"}};
  const double inertia[] = {0.5 * (pi * 0.7 * 0.7 * 2) * 0.7 * 0.7,
                            0.4 * (4. / 3 * pi * 1.3 * 1.3 * 1.3 * 3) * 1.3 * 1.3};
  for (size_t n = 0; n < sizeof kinds / sizeof *kinds; n++) {
    struct written it;
    struct nb_model *model = gears(&it, kinds[n].damping);
    double spin[2] = {2, 0.5}, angle[2] = {0, 0}, most = 0;
    for (int cycle = 0; cycle < 40; cycle++) {
      model->step = cycle < 20 ? 0.001 : 0.0003;
      const double before = model->previous_step, t = (before + model->step) / 2;
      const struct factors kick = kinds[n].over(t), now = kinds[n].over(before);
      for (int b = 0; b < 2; b++) {
        const double turning = written_now(model, names[b][0]) / inertia[b];
        const double next = now.keep * spin[b] + now.push * before * turning;
        CU_ASSERT_DOUBLE_EQUAL(written_now(model, names[b][1]), before > 0 ? (spin[b] + next) / 2 : spin[b], 1e-13);
        spin[b] = kick.keep * spin[b] + kick.push * t * turning;
        angle[b] += spin[b] * model->step;
        most = fmax(most, fabs(t * turning / spin[b]));
      }
      written_cycles(model, 1);
      for (int b = 0; b < 2; b++) {
        CU_ASSERT_DOUBLE_EQUAL(written_now(model, names[b][2]), spin[b], 1e-13);
        CU_ASSERT_DOUBLE_EQUAL(written_now(model, names[b][3]), angle[b], 1e-13);
      }
    }
    CU_ASSERT(most > 0.01); /* in some step the moment changes the spin by more than 1 % */
    nb_model_free(model);
    written_free(&it);
  }
}

/* The surface speed that contacts use is the current spin times the radius. */
static void surface_speed_of_the_particle(void) {
  struct written it;
  struct nb_model *model = gears(&it, "mass 30");
  for (int cycle = 0; cycle < 9; cycle++) {
    written_cycles(model, 1);
    for (size_t i = 0; i < 2; i++)
      CU_ASSERT_DOUBLE_EQUAL(model->particles.surface_speed[i], model->particles.spin[i] * model->particles.radius[i],
                             1e-15);
  }
  nb_model_free(model);
  written_free(&it);
}

/* At t_N a model has the velocities of t_(N-1/2). `reverse velocities` replaces them by minus the velocities of
 * t_(N+1/2), which the next kick would give; at the start, by minus the velocities of the page. If a stage changes the
 * damping at t_N, the next kick has the old damping before t_N and the new one after it. */
static void reversal(void) {
  static const struct nb_damping old = {.global_kind = NB_GLOBAL_MASS, .global = 80};
  for (size_t n = 0; n < sizeof kinds / sizeof *kinds; n++)
    for (int k = 0; k < 10; k++) {
      const int cycles = 7 * (k / 2);
      struct written it;
      struct nb_model *on = gears(&it, kinds[n].damping), *back = written_model(&it, NULL);
      written_cycles(on, cycles), written_cycles(back, cycles);
      on->step = back->step = 0.0004;
      if (k % 2)
        on->stage_cycle = back->stage_cycle = 0, on->previous_damping = back->previous_damping = old;
      if (cycles > 0)
        written_cycles(on, 1);
      nb_motion_reverse(back);
      for (size_t i = 0; i < 2; i++) {
        CU_ASSERT_DOUBLE_EQUAL(back->particles.velocity[i].x, -on->particles.velocity[i].x, 1e-15);
        CU_ASSERT_DOUBLE_EQUAL(back->particles.velocity[i].y, -on->particles.velocity[i].y, 1e-15);
        CU_ASSERT_DOUBLE_EQUAL(back->particles.spin[i], -on->particles.spin[i], 1e-15);
      }
      nb_model_free(on), nb_model_free(back);
      written_free(&it);
    }
}

/* `rotation on` does not change the spin at t_N, which is 0, although a moment acts at this time. The spin half a step
 * before and half a step after t_N are opposite. */
static void rotation_begins_under_a_moment(void) {
  for (size_t n = 0; n < sizeof kinds / sizeof *kinds; n++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(
        &page,
        "units none\nmaterial m density 2 kn 1e4 ks 7e3 friction 5\nshear linear\nstep 0.001\ndisc 0 0 radius 0.7 "
        "m velocity 0 0.4\ndisc 1.2 1.55 radius 1.3 m\ndamping %s\nmonitor A disc 1\nmonitor B disc 2\n"
        "record A.spin A.spin.half A.moment B.spin B.spin.half\nstage a\nrotation off\ncycles 9\nstage b\n"
        "rotation on\ncycles 1\n",
        kinds[n].damping);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    written_cycles(model, 9);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[1], &error), NB_OK);
    const double inertia = 0.5 * (pi * 0.7 * 0.7 * 2) * 0.7 * 0.7, push = kinds[n].over(0.001).push;
    const double after = push * 0.001 * written_now(model, "A.moment") / inertia; /* from 0 before */
    CU_ASSERT(fabs(after) > 1e-3);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.spin"), 0, 1e-15);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "B.spin"), 0, 1e-15);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.spin.half"), -after / (1 + kinds[n].over(0.001).keep), 1e-15);
    nb_model_free(model);
    written_free(&it);
  }
}

/* After `zero velocities`, discs that rotated in contact have no shear force when a later stage gives them a shear
 * law. */
static void surface_after_zero_velocities(void) {
  static const char *const still[] = {"", "zero velocities\n"};
  for (int k = 0; k < 2; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1 kn 100 ks 100 friction 1\nstep 0.001\ndisc 0 0 radius 1 m spin 3\n"
              "disc 1.9 0 radius 1 m spin 2\nmonitor C disc 1 with disc 2\nrecord C.shear\nstage a\ncycles 2\nstage b\n"
              "%scycles 2\nstage c\nshear linear\ncycles 1\n",
              still[k]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "C.shear"), k ? 0 : -100 * 0.001 * (3 + 2), 1e-12);
    nb_result_free(&result);
    written_free(&it);
  }
}

void suite_spin(void) {
  CU_pSuite suite = CU_add_suite("spin", NULL, NULL);
  CU_add_test(suite, "moments rotate particles, damped or not", moments_rotate_particles);
  CU_add_test(suite, "the surface speed is that of the particle", surface_speed_of_the_particle);
  CU_add_test(suite, "reversal of velocities and spins", reversal);
  CU_ADD_TEST(suite, rotation_begins_under_a_moment);
  CU_add_test(suite, "surface speed after zero velocities", surface_after_zero_velocities);
}
