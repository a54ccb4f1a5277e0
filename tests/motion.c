/* The motion of particles, compared with solutions of the difference equations [CS79 20-23a, 29-36], [R89 sec. 6.5.1].
 *
 * A disc between two walls with the stiffness k, each of which overlaps it by p, moves exactly like a mass m on a spring
 * with the stiffness 2 k as long as its displacement is less than p.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>

#include "../src/core/model.h"
#include "chance.h"
#include "suites.h"
#include "written.h"

static const double press = 0.125 /* p */, k = 300, pi = 3.14159265358979323846;

static double mass(void) { return pi * 2; } /* of a disc with radius 1 and density 2 */
static double omega(void) { return sqrt(2 * k / mass()); }

/* Writes a page with the two walls, the disc at the position x with the velocity v, and these statements. */
static void oscillator(struct written *it, double x, double v, const char *statements) {
  struct words page = {0};
  words_add(&page, "units none\nmaterial m density 2 kn %g\n", k);
  words_add(&page, "wall west %.17g -9 to %.17g 9 m\nwall east %.17g -9 to %.17g 9 m\n", press - 1, press - 1,
            1 - press, 1 - press);
  words_add(&page, "disc %.17g 0 radius 1 m velocity %.17g 0\nmonitor D disc 1\n", x, v);
  words_add(&page, "record D.x D.vx D.vx.half D.fx time energy.kinetic\n%s", statements);
  written_scene(it, &page);
}

static void free_flight_is_exact(void) {
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial m density 1 kn 1 ks 1 friction 1\nshear linear\nstep 0.0009765625\n"
            "disc 1 2 radius 0.5 m velocity 0.5 -0.25 spin 3\ndisc 9 9 radius 0.5 m fixed velocity 0.25 1 spin -1\n"
            "disc 30 9 radius 0.5 m fixed velocity -4 0\ndisc 20 9.9 radius 0.5 m velocity 0 0\n"
            "monitor A disc 1\nmonitor B disc 2\nmonitor C disc 3\nrecord A.x A.y A.angle A.vx A.spin B.x B.y B.angle "
            "C.x C.y\n"
            "damping con1 0.5 as all\nstage s\ndamping none\ncycles 1024\nstage t\ndamping con1 0.5 as all\n"
            "cycles 3072\n");
  written_scene(&it, &page);
  struct nb_result result;
  written_run(&result, &it, NULL);
  const double *first = result.table.values + 1024 * result.table.column_count; /* at the end of the first stage */
  CU_ASSERT(first[0] == 1.5 && first[1] == 1.75 && first[2] == 3 && first[3] == 0.5 && first[4] == 3);
  /* Fixed discs keep their velocity, damped or not, and pass through other discs. */
  CU_ASSERT(written_last(&result, "B.x") == 10 && written_last(&result, "B.y") == 13);
  CU_ASSERT(written_last(&result, "B.angle") == -4);
  CU_ASSERT(written_last(&result, "C.x") == 14 && written_last(&result, "C.y") == 9);
  nb_result_free(&result);
  written_free(&it);
}

/* The first update of the velocity lasts half a step. So the position after N steps is x_N = x_0 cos(phi N) +
 * v_0 dt sin(phi N)/sin(phi) with sin(phi/2) = w dt/2, where w is the angular frequency. The velocity at the time t_N
 * is the central difference of the positions. */
static void one_mass_on_a_spring(void) {
  static const double start[][2] = {{0.05, 0}, {0, 0.4}, {-0.03, 0.2}};
  for (size_t s = 0; s < sizeof start / sizeof *start; s++)
    for (double fraction = 0.01; fraction < 1; fraction += 0.13) {
      struct written it;
      char text[128];
      const double dt = fraction * 2 / omega(), phi = 2 * asin(fraction);
      const double x0 = start[s][0] * sqrt(1 - fraction * fraction), v0 = start[s][1] * (1 - fraction * fraction);
      snprintf(text, sizeof text, "step %.17g\nstage s\ncycles 200\n", dt);
      oscillator(&it, x0, v0, text);
      struct nb_model *model = written_model(&it, NULL);
      for (int n = 0; n <= 200; n++) {
        const double sine = sin(phi * n) / sin(phi), cosine = cos(phi * n);
        CU_ASSERT_DOUBLE_EQUAL(written_now(model, "D.x"), x0 * cosine + v0 * dt * sine, 1e-13);
        CU_ASSERT_DOUBLE_EQUAL(written_now(model, "D.vx"), v0 * cosine - x0 * sin(phi) * sin(phi * n) / dt, 1e-11);
        written_cycles(model, 1);
      }
      nb_model_free(model);
      written_free(&it);
    }
}

/* The next velocity at a half step with each kind of mass-proportional damping, by the formula of its source. g is the
 * number in the statement, dt the step, u the previous velocity at a half step, and f the force over the mass. */
static double alpha(double g, double dt, double u, double f) {
  return (u * (1 - g * dt / 2) + f * dt) / (1 + g * dt / 2); /* [CS79 35] */
}
static double con1_cs79(double g, double dt, double u, double f) { return (g * u + f * dt) / (2 - g); }
static double con1_velocity(double g, double dt, double u, double f) { return g * u + f * dt; }
static double con1_all(double g, double dt, double u, double f) { return g * (u + f * dt); }

static const struct reading {
  const char *statement;
  double value;
  double (*next)(double g, double dt, double u, double f);
} readings[] = {
    {"mass 3", 3, alpha},
    {"mass 0.1", 0.1, alpha},
    {"con1 0.9 as cs79", 0.9, con1_cs79},
    {"con1 0.25 as cs79", 0.25, con1_cs79},
    {"con1 0.9 as velocity", 0.9, con1_velocity},
    {"con1 0 as velocity", 0, con1_velocity},
    {"con1 0.9 as all", 0.9, con1_all},
    {"con1 0 as all", 0, con1_all},
};

static void kinds_of_mass_damping(void) {
  for (size_t r = 0; r < sizeof readings / sizeof *readings; r++) {
    const struct reading *reading = &readings[r];
    struct written it;
    char text[160];
    const double dt = 0.2 / omega(), w2 = 2 * k / mass();
    snprintf(text, sizeof text, "damping %s\nstep %.17g\nstage s\ncycles 200\n", reading->statement, dt);
    oscillator(&it, 0.04, 0.1, text);
    struct nb_model *model = written_model(&it, NULL);
    double x = 0.04, u = 0.1;
    for (int n = 0; n < 200; n++) {
      u = reading->next(reading->value, n == 0 ? dt / 2 : dt, u, -w2 * x);
      x += u * dt;
      written_cycles(model, 1);
      CU_ASSERT_DOUBLE_EQUAL(written_now(model, "D.x"), x, 1e-13);
      CU_ASSERT_DOUBLE_EQUAL(written_now(model, "D.vx.half"), u, 1e-11);
      const double next = reading->next(reading->value, dt, u, -w2 * x);
      CU_ASSERT_DOUBLE_EQUAL(written_now(model, "D.vx"), (u + next) / 2, 1e-11); /* [CS79 31] */
    }
    nb_model_free(model);
    written_free(&it);
  }
}

static void spin_is_damped_like_the_velocity(void) {
  for (size_t r = 0; r < sizeof readings / sizeof *readings; r++) {
    const struct reading *reading = &readings[r];
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1 kn 1\nstep 0.125\ndisc 0 0 radius 1 m velocity 7 0 spin 7\n"
              "damping %s\nmonitor D disc 1\nrecord D.x D.angle\nstage s\ncycles 5\n",
              reading->statement);
    written_scene(&it, &page);
    struct nb_result result;
    written_run(&result, &it, NULL);
    double x = 0, u = 7;
    for (int n = 0; n < 5; n++) {
      u = reading->next(reading->value, n == 0 ? 0.0625 : 0.125, u, 0);
      x += 0.125 * u;
    }
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "D.x"), x, 1e-14);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "D.angle"), x, 1e-14);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* Three stages with the steps dt, dt/3, dt/2 are compared with the exact motion. With all steps halved, the errors of
 * position and velocity fall to a quarter, damped or not. They would fall only to a half if the first update of the
 * velocity lasted a whole step. They would also fall only to a half if the update between two stages lasted the whole new
 * step. It must last half of the old step and half of the new one. */
static void changes_of_the_step_keep_the_second_order(void) {
  for (int damped = 0; damped < 2; damped++) {
    const double rate = damped ? 2 : 0, w = omega(), turn = sqrt(w * w - rate * rate / 4), end = 6;
    const double decay = 0.05 * exp(-rate / 2 * end);
    const double x = decay * (cos(turn * end) + rate / 2 / turn * sin(turn * end));
    const double v = -decay * w * w / turn * sin(turn * end);
    double off[2][2];
    for (int fine = 0; fine < 2; fine++) {
      struct written it;
      char text[256];
      const int n = 100 << fine;
      snprintf(text, sizeof text,
               "damping mass %g\nstep %.17g\nstage a\ncycles %d\nstage b\nstep %.17g\ncycles %d\n"
               "stage c\nstep %.17g\ncycles %d\n",
               rate, 2.0 / n, n, 2.0 / n / 3, 3 * n, 2.0 / n / 2, 2 * n);
      oscillator(&it, 0.05, 0, text);
      struct nb_result result;
      written_run(&result, &it, NULL);
      CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "time"), end, 1e-12);
      off[fine][0] = written_last(&result, "D.x") - x, off[fine][1] = written_last(&result, "D.vx") - v;
      nb_result_free(&result);
      written_free(&it);
    }
    for (int q = 0; q < 2; q++) {
      const double order = log2(off[0][q] / off[1][q]);
      if (!(fabs(order - 2) < 0.1))
        printf("# order %g of %s, %s\n", order, q ? "velocity" : "position", damped ? "damped" : "undamped");
      CU_ASSERT(fabs(order - 2) < 0.1);
    }
  }
}

/* The energy that is computed with the velocity at full steps lies between the initial energy and the fraction
 * 1 - (w dt)^2/4 = 0.99 of it. It does not drift. */
static void energy_does_not_drift(void) {
  struct written it;
  char text[128];
  snprintf(text, sizeof text, "step %.17g\nstage s\nrecord every 1000 cycles\ncycles 100000\n", 0.2 / omega());
  oscillator(&it, 0.05, 0, text);
  struct nb_result result;
  written_run(&result, &it, NULL);
  const double whole = k * 0.05 * 0.05;
  for (size_t row = 0; row < result.table.row_count; row++) {
    const double *values = result.table.values + row * result.table.column_count;
    CU_ASSERT_DOUBLE_EQUAL((values[5] + k * values[0] * values[0]) / whole, 0.995, 0.005 + 1e-9);
  }
  CU_ASSERT_EQUAL(result.table.row_count, 101);
  nb_result_free(&result);
  written_free(&it);
}

/* More particles than fit into one block of the motion, each with its own mass, fall by the same distance. */
static void many_particles_fall(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 1\ngravity 0 -2\nskin 0.1\nstep 0.25\nrecord time\n");
  for (int i = 0; i < 600; i++)
    words_add(&page, "disc %d 0 radius %g m\n", 4 * i, 0.5 + 0.002 * i);
  words_add(&page, "stage s\ncycles 4\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  written_cycles(model, 4);
  for (int i = 0; i < 600; i++)
    CU_ASSERT_DOUBLE_EQUAL(model->particles.position[i].y, -1, 1e-14);
  nb_model_free(model);
  written_free(&it);
}

/* As many particles, all of one size, fall towards a point: each accelerates in its own direction. */
static void many_particles_fall_to_a_point(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 1 kn 1\nskin 0.1\nstep 0.25\nrecord time\n");
  for (int i = 0; i < 600; i++)
    words_add(&page, "disc %d 0 radius 0.5 m\n", 4 * i);
  words_add(&page, "stage s\ngravity centripetal 2 about 0 300\ncycles 1\nsnapshot\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  for (size_t i = 0; i < 600; i++) {
    const double x = 4 * (double)i, part = 2 * 0.25 * 0.25 / 2 / hypot(x, 300); /* distance moved, over the whole one */
    CU_ASSERT_DOUBLE_EQUAL(written_cell(&result.snapshots[0].particles, i, "x"), x - part * x, 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(written_cell(&result.snapshots[0].particles, i, "y"), part * 300, 1e-12);
  }
  nb_result_free(&result);
  written_free(&it);
}

void suite_motion(void) {
  CU_pSuite suite = CU_add_suite("motion", NULL, NULL);
  CU_add_test(suite, "free flight is exact, fixed discs keep their velocity", free_flight_is_exact);
  CU_add_test(suite, "one mass on a spring", one_mass_on_a_spring);
  CU_add_test(suite, "kinds of mass-proportional damping", kinds_of_mass_damping);
  CU_add_test(suite, "spin is damped like the velocity", spin_is_damped_like_the_velocity);
  CU_add_test(suite, "changes of the step keep the second order", changes_of_the_step_keep_the_second_order);
  CU_add_test(suite, "energy does not drift", energy_does_not_drift);
  CU_add_test(suite, "many particles fall", many_particles_fall);
  CU_add_test(suite, "many particles fall to a point", many_particles_fall_to_a_point);
}
