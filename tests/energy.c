/* The work balance and the energy balance: each source and sink of energy alone is compared with a hand calculation;
 * then both balances must close with all of them together. [CS79 20-36]
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/measure/balance.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

static const double pi = 3.14159265358979323846;

#define RECORD                                                                                                         \
  "record energy.kinetic energy.stored energy.friction energy.shear energy.damped energy.walls energy.gravity "        \
  "energy.changed energy.balance work.balance momentum.x momentum.y momentum.angular\n"

/* A box with six discs, a fixed disc that moves, friction, cohesion, gravity and `damping`; `format` has two stages
 * with `cycles` cycles each. Returns the largest work residual over the largest kinetic energy; *energy is the last
 * energy residual. */
static double busy(double *energy, const char *damping, double step, const char *format, int cycles,
                   const struct nb_options *options) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page,
            "units none\nmaterial m density 3 kn 4000 ks 2500 friction 0.3 cohesion 0.1\nshear linear\n"
            "box 0 0 to 6 4 m\nlattice discs 3 by 2 m radius 0.98 spacing 1.99 from 1 1\n"
            "disc 6.84 1.1 radius 0.9 m fixed velocity -0.1 0 spin 0.5\ngravity 0.1 -0.4\n%sstep %g\n" RECORD,
            damping, step);
  words_add(&page, format, cycles, cycles);
  written_scene(&it, &page);
  written_run(&result, &it, options);
  double worst = 0, kinetic = 0;
  const struct nb_table *table = &result.table;
  for (size_t r = 0; r < table->row_count; r++) {
    const double *row = table->values + r * table->column_count;
    kinetic = row[0] > kinetic ? row[0] : kinetic;
    worst = fabs(row[9]) > worst ? fabs(row[9]) : worst;
  }
  *energy = fabs(written_last(&result, "energy.balance"));
  nb_result_free(&result);
  written_free(&it);
  return worst / kinetic;
}

#define PRESS "stage a\nwall west velocity 0.2 0.1\nwall south velocity 0 0.3 spin 0.02\ncycles %d\n"

static void work_closes(void) {
  static const char *const dampings[] = {
      "",
      "damping stiffness 0.002\n",
      "damping r89-fraction 0.2\n",
      "damping ratio 0.1\n",
      "damping mass 0.7\n",
      "damping con1 0.99 as cs79\n",
      "damping con1 0.98 as velocity\n",
      "damping con1 0.97 as all\n",
      "damping stiffness 0.002\ndamping con1 0.97 as all\n",
  };
  for (size_t n = 0; n < sizeof dampings / sizeof *dampings; n++) {
    double energy;
    CU_ASSERT(busy(&energy, dampings[n], 0.002, PRESS "stage b\ncycles %d\n", 300, NULL) < 1e-13);
    CU_ASSERT(busy(&energy, dampings[n], 0.002, PRESS "stage b\nstep 0.0007\ncycles %d\n", 300, NULL) < 1e-13);
    CU_ASSERT(busy(&energy, dampings[n], 0.002, PRESS "stage b\nzero velocities\ngravity 1 0\ncycles %d\n", 300, NULL) <
              1e-13);
    CU_ASSERT(busy(&energy, dampings[n], 0.002, PRESS "stage b\nreverse velocities\ndamping mass 2\ncycles %d\n", 300,
                   NULL) < 1e-13);
    CU_ASSERT(busy(&energy, dampings[n], 0.002, PRESS "stage b\nremove discs 5 to 7\ncycles %d\n", 300, NULL) < 1e-13);
    CU_ASSERT(busy(&energy, dampings[n], 0.002, PRESS "stage b\nramp material m kn 6000 ks 900\ncycles %d\n", 300,
                   NULL) < 1e-13);
  }
}

/* The work balance is exact also if a force or an imposed velocity depends on the position of a particle, because the
 * balance uses the position at the kick. Each disc moves by many times its radius. */
static void work_closes_in_a_field(void) {
  static const char *const fields[] = {
      "affine strain 0.004 -0.008 c12 0.006\n",
      "affine strain 0.004 -0.008 c12 0.006 accumulated\n",
      "affine strain 0.004 -0.008 c12 0.006 accumulated\ndamping mass 0.3\n",
      "affine strain 0.004 -0.008 c12 0.006 accumulated\ndamping con1 0.99 as all\n",
      "gravity centripetal 4 about 1 2\n",
      "gravity centripetal 4 about 1 2\ndamping mass 0.3\n",
      "gravity centripetal 4 about 1 2\naffine strain 0.004 -0.008 c12 0.006 accumulated\n",
  };
  for (size_t n = 0; n < sizeof fields / sizeof *fields; n++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 2 kn 100\nstep 0.0125\ndisc 3 4 radius 1 m velocity 5 6\n"
              "disc -3 4 radius 1 m velocity -6 5\nrecord work.balance energy.kinetic\n"
              "stage a\n%scycles 60\nstage b\nstep 0.01\ncycles 40\n",
              fields[n]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    CU_ASSERT_EQUAL_FATAL(result.table.row_count, 101);
    for (size_t r = 0; r <= 100; r++)
      CU_ASSERT(fabs(result.table.values[2 * r]) < 1e-13 * result.table.values[2 * r + 1]);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* With a sixteenth of the step a residual of second order falls to 1/256, and one of first order to about 1/16. Here
 * contacts rotate, form, open and lose their friction, so the residual has parts of first order; the test requires less
 * than 1/8. With a wrong or missing term the residual does not fall. */
static void energy_closes(void) {
  static const struct {
    const char *damping, *stages;
  } kinds[] = {
      {"", PRESS "stage b\ncycles %d\n"},
      {"damping stiffness 0.002\n", PRESS "stage b\ncycles %d\n"},
      {"damping mass 0.7\n", PRESS "stage b\ncycles %d\n"},
      {"", PRESS "stage b\nzero velocities\ncycles %d\n"},
      {"", PRESS "stage b\nreverse velocities\ncycles %d\n"},
      {"", PRESS "stage b\ngravity 1 0\ncycles %d\n"},
      {"", PRESS "stage b\nramp gravity 1 0\ncycles %d\n"},
      {"", PRESS "stage b\nramp wall west velocity -0.1 0 spin 0.1\ncycles %d\n"},
      {"", PRESS "stage b\nramp material m kn 6000 ks 900\ncycles %d\n"},
      {"", PRESS "stage b\nmaterial m kn 6000 ks 900\ncycles %d\n"},
      {"", PRESS "stage b\nmaterial m friction 0 cohesion 0\ncycles %d\n"},
      {"", PRESS "stage b\nremove discs 4 to 5\ncycles %d\n"},
      {"damping stiffness 0.002\n", PRESS "stage b\nremove discs 4 to 5\ncycles %d\n"},
      {"damping mass 0.7\n", PRESS "stage b\nremove discs 5 to 7\ncycles %d\n"},
  };
  for (size_t n = 0; n < sizeof kinds / sizeof *kinds; n++) {
    double coarse, fine;
    busy(&coarse, kinds[n].damping, 0.0016, kinds[n].stages, 400, NULL);
    busy(&fine, kinds[n].damping, 0.0001, kinds[n].stages, 6400, NULL);
    CU_ASSERT(fine < coarse / 8);
  }
}

static void same_bits(void) {
  double first, other;
  const double one =
      busy(&first, "damping stiffness 0.002\n", 0.002, PRESS "stage b\nremove disc 4\ncycles %d\n", 300, NULL);
  const struct nb_options options[] = {{.threads = 2}, {.threads = 3, .shuffle = true}, {.threads = 1, .isa = "plain"}};
  for (size_t n = 0; n < sizeof options / sizeof *options; n++) {
    CU_ASSERT_EQUAL(
        busy(&other, "damping stiffness 0.002\n", 0.002, PRESS "stage b\nremove disc 4\ncycles %d\n", 300, &options[n]),
        one);
    CU_ASSERT_EQUAL(other, first);
  }
}

static struct nb_model *made(struct written *it, const char *text) {
  struct words page = {0};
  words_add(&page, "%s", text);
  written_scene(it, &page);
  return written_model(it, NULL);
}

/* A sum is its main part and the rounding errors that it has collected. */
static void rounding_errors_belong_to_the_sums(void) {
  struct written it;
  struct nb_model *model =
      made(&it, "units none\nmaterial m density 3\ndisc 0 0 radius 1 m\nstep 0.01\nrecord energy.friction "
                "energy.walls energy.balance work.balance\nstage s\ncycles 9\n");
  model->terms[NB_TERM_FRICTIONAL] = (struct nb_sum){8, 0.25};
  CU_ASSERT_EQUAL(written_now(model, "energy.friction"), 8.25);
  CU_ASSERT_EQUAL(written_now(model, "energy.balance"), 8.25);
  model->balance->work = (struct nb_sum){8, 0.25};
  CU_ASSERT_EQUAL(written_now(model, "work.balance"), -8.25); /* K - K_0 minus the work */
  model->terms[NB_TERM_WALLS] = (struct nb_sum){2, -0.125};
  CU_ASSERT_EQUAL(written_now(model, "energy.walls"), 1.875);
  CU_ASSERT_EQUAL(written_now(model, "energy.balance"), 6.375);
  model->balance->initial_energy = -1e16; /* 1e16 + 1 - 1e16: the 1 is a rounding error of the first sum */
  model->terms[NB_TERM_DAMPED].sum = 1, model->terms[NB_TERM_WALLS] = (struct nb_sum){1e16, 0};
  model->terms[NB_TERM_FRICTIONAL] = (struct nb_sum){0, 0};
  CU_ASSERT_EQUAL(written_now(model, "energy.balance"), 1);
  nb_model_free(model);
  written_free(&it);
}

/* Free fall: the work is m g times the displacement, whatever the step. */
static void by_gravity(void) {
  struct written it;
  struct nb_model *model = made(&it, "units none\nmaterial m density 3\ndisc 0 0 radius 1 m velocity 1 2\n"
                                     "gravity 0.5 -10\nstep 0.01\nmonitor A disc 1\nrecord A.x A.y energy.gravity "
                                     "energy.kinetic energy.balance\nstage s\ncycles 9\n");
  const double start = written_now(model, "energy.kinetic");
  for (int n = 0; n < 50; n++) {
    written_cycles(model, 1);
    const double supplied = written_now(model, "energy.gravity");
    CU_ASSERT_DOUBLE_EQUAL(supplied, 3 * pi * (0.5 * written_now(model, "A.x") - 10 * written_now(model, "A.y")),
                           1e-10);
    CU_ASSERT_DOUBLE_EQUAL(supplied, written_now(model, "energy.kinetic") - start, 1e-10);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "energy.balance"), 0, 1e-10);
  }
  nb_model_free(model);
  written_free(&it);
}

/* A wall moves towards a disc that touches the wall and a fixed disc. The whole work of the first step, k (v dt)^2/2,
 * is stored. */
static void by_walls_and_stored(void) {
  struct written it;
  struct nb_model *model =
      made(&it, "units none\nmaterial m density 3 kn 400\ndisc 2 1 radius 1 m\n"
                "disc 2 3 radius 1 m fixed\nwall w -5 0 to 5 0 m velocity 0 0.5\nstep 0.001\n"
                "record energy.walls energy.stored energy.kinetic momentum.y momentum.angular\nstage s\ncycles 9\n");
  CU_ASSERT_EQUAL(written_now(model, "energy.walls"), 0);
  written_cycles(model, 1);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "energy.stored"), 400 * 0.0005 * 0.0005 / 2, 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "energy.walls"), 400 * 0.0005 * 0.0005 / 2, 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "momentum.y"), 400 * 0.0005 * 0.0005, 1e-15); /* F dt/2 */
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "momentum.angular"), 2 * 400 * 0.0005 * 0.0005, 1e-15);
  nb_model_free(model);
  written_free(&it);
}

/* A disc too heavy to move overlaps by 0.1 with a wall that moves tangentially: F_n = 40, and the friction limit 12 is
 * reached at the slip 0.06. The last pair of materials has no friction and no contact. */
#define DRAG                                                                                                           \
  "units none\nmaterial m density 3 kn 400 ks 200 friction 0.3\nshear linear\ndisc 0 0.9 radius 1 m\n"                 \
  "material heavy density 1e12 kn 400 ks 200 friction 0.3\ndisc 20 0.9 radius 1 heavy\n"                               \
  "material smooth density 3 kn 400 ks 200 friction 0\ndisc 40 5 radius 1 smooth\n"                                    \
  "wall w 10 0 to 90 0 m velocity 1 0\nstep 0.001\n"                                                                   \
  "monitor C disc 2 with wall w\nrecord C.shear C.sliding energy.friction energy.shear energy.walls energy.stored\n"   \
  "stage s\ncycles 9\n"
static void by_friction(void) {
  struct written it;
  struct nb_model *model = made(&it, DRAG);
  const double normal = written_now(model, "energy.stored"); /* of the normal spring: 2 J */
  CU_ASSERT_DOUBLE_EQUAL(normal, 400 * 0.01 / 2, 1e-12);
  written_cycles(model, 59);
  CU_ASSERT_EQUAL(written_now(model, "C.sliding"), 0);
  CU_ASSERT_EQUAL(written_now(model, "energy.friction"), 0);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "energy.stored") - normal, 200 * 0.059 * 0.059 / 2, 1e-7);
  written_cycles(model, 101);
  CU_ASSERT_EQUAL(written_now(model, "C.sliding"), 1);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "energy.stored") - normal, 12 * 12 / 400., 1e-7);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "energy.friction"), 12 * 0.1, 1e-7);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "energy.shear"), 12 * 0.1 + 12 * 12 / 400., 1e-7);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "energy.walls"), 12 * 0.1 + 12 * 12 / 400., 1e-7);
  nb_model_free(model);
  written_free(&it);
}

/* Heavy particles keep their velocities, so a dashpot with the coefficients beta k_n and beta k_s takes beta (k_n
 * v_n^2 + k_s v_s^2) per second. v_n and v_s are the components along e and t of the velocity of the first surface
 * relative to the second one; a surface speed contains R w, and a wall rotates about P. A wall or a fixed particle
 * whose surface has the velocity V supplies -(N e + T t).V, where N = k_n 0.1 + beta k_n v_n and T = beta k_s v_s.
 * The displacements are of the order of 1e-7, and the shear force of the spring is as large as that of the dashpot if
 * beta is 1e-7. */
static void by_dashpots(void) {
  static const struct {
    const char *partner;
    bool supplies;
    double vx, vy; /* of its surface at the contact */
  } rows[] = {{"disc 3.4 0 radius 2 m velocity -0.4 0.3 spin 0.25", false, -0.4, 0.3 - 0.5},
              {"disc 3.4 0 radius 2 m velocity -0.4 0.3 spin 0.25 fixed", true, -0.4, 0.3 - 0.5},
              {"wall w 1.4 -9 to 1.4 9 m velocity -0.1 0.6", true, -0.1, 0.6},
              {"wall w 1.4 -9 to 1.4 9 m velocity -0.1 0.6 spin 0.4 about -1.6 1", true, -0.1 + 0.4, 0.6 + 1.2}};
  static const double betas[] = {5, 1e-7};
  for (size_t k = 0; k < 2 * sizeof rows / sizeof *rows; k++) {
    const size_t r = k / 2;
    const double beta = betas[k % 2], vn = 0.7 - rows[r].vx, vs = -(0.2 + 1.5 * 0.5 - rows[r].vy); /* t is (0, -1) */
    struct words page = {0};
    struct written it;
    words_add(
        &page,
        "units none\n%smaterial m density 1e12 kn 4 ks 3 friction 1e9\nshear linear\ndamping stiffness %g\n"
        "disc 0 0 radius 1.5 m velocity 0.7 0.2 spin 0.5\n%s\nstep 1e-8\nrecord energy.damped energy.walls\nstage s\n"
        "cycles 9\n",
        k / 2 % 2 ? "transform rotate 0.6\n" : "", beta, rows[r].partner);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    written_cycles(model, 2);
    const double damped = written_now(model, "energy.damped"), walls = written_now(model, "energy.walls");
    written_cycles(model, 8);
    NEAR(written_now(model, "energy.damped") - damped, 8e-8 * beta * (4 * vn * vn + 3 * vs * vs), 1e-6);
    const double power = -((0.4 + beta * 4 * vn) * rows[r].vx - beta * 3 * vs * rows[r].vy);
    if (beta > 1)
      CU_ASSERT_DOUBLE_EQUAL(written_now(model, "energy.walls") - walls, rows[r].supplies ? 8e-8 * power : 0, 1e-13);
    nb_model_free(model);
    written_free(&it);
  }
}

/* Gravity with an imposed motion: the work of gravity is m g times the displacement, which contains the imposed one.
 * The imposed motion supplies minus the work of gravity along it, so the kinetic energy of the particle's own
 * velocity changes by the sum. */
static void by_gravity_and_imposed_motion(void) {
  struct written it;
  struct nb_error error;
  struct nb_model *model =
      made(&it, "units none\nmaterial m density 3\ndisc 3 5 radius 1 m velocity 1 2\ndisc 50 60 radius 1 m fixed\n"
                "gravity 0.5 -10\nstep 0.01\nmonitor A disc 1\nrecord A.x A.y energy.gravity "
                "energy.kinetic energy.imposed work.balance\nstage s\n"
                "affine strain 0.2 -0.3 c12 0.1 c21 0.4\ncycles 9\n");
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  const double start = written_now(model, "energy.kinetic");
  for (int n = 0; n < 50; n++) {
    written_cycles(model, 1);
    const double supplied = written_now(model, "energy.gravity"), imposed = written_now(model, "energy.imposed");
    CU_ASSERT_DOUBLE_EQUAL(
        supplied, 3 * pi * (0.5 * (written_now(model, "A.x") - 3) - 10 * (written_now(model, "A.y") - 5)), 1e-10);
    CU_ASSERT(fabs(imposed) > 0.01);
    CU_ASSERT_DOUBLE_EQUAL(supplied + imposed, written_now(model, "energy.kinetic") - start, 1e-10);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "work.balance"), 0, 1e-10);
  }
  nb_model_free(model);
  written_free(&it);
}

/* In a kick the kinetic energy of a free particle changes from K- to K+ by the work of gravity minus the energy that
 * mass-proportional damping takes, exactly. At t_N half of the kick counts, so from one step to the next gravity -
 * damped changes by as much as (K- + K+)/2. Kicks whose halves differ are left out: the first one of each stage. */
static void by_damping_of_all_particles(void) {
  static const char *const dampings[] = {"damping mass 0.7\n", "damping con1 0.99 as cs79\n",
                                         "damping con1 0.98 as velocity\n", "damping con1 0.97 as all\n", ""};
  static const char *const loadings[] = {"", "affine strain 0.1 -0.2 c12 0.3 accumulated\n",
                                         "boundary stress 5 3 shear 1\n"};
  for (size_t n = 0; n < 3 * sizeof dampings / sizeof *dampings; n++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    const char *damping = dampings[n / 3], *loading = loadings[n % 3];
    words_add(&page,
              "units none\nmaterial m density 3\ndisc 5 0 radius 1 m velocity 3 4 spin 2\nsphere 0 5 radius 0.5 m "
              "velocity -1 2 spin -5\ndisc -5 1 radius 1 m\ndisc 0 -5 radius 1 m\ngravity 0.3 -0.4\n%s%sstep 0.01\n"
              "record energy.damped energy.gravity energy.imposed work.balance\nstage a\n%scycles 5\nstage b\nstep "
              "0.03\ncycles 5\n",
              n % 3 == 2 ? "boundary circle 0 0 radius 5\n" : "", damping, loading);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    double before = 0, last = 0, mean = 0;
    for (int k = 0; k < 10; k++) {
      if (k % 5 == 0)
        CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[k / 5], &error), NB_OK);
      const double supplied = written_now(model, "energy.gravity") + written_now(model, "energy.imposed") -
                              written_now(model, "energy.damped");
      written_cycles(model, 1);
      const double after = nb_energy_kinetic_half(model);
      if (k % 5 > 1)
        CU_ASSERT_DOUBLE_EQUAL(supplied - last, (before + after) / 2 - mean, 1e-11);
      CU_ASSERT_DOUBLE_EQUAL(written_now(model, "work.balance"), 0, 1e-11);
      mean = (before + after) / 2, before = after, last = supplied;
    }
    CU_ASSERT((written_now(model, "energy.damped") > 1e-3) == (*damping != 0));
    CU_ASSERT((fabs(written_now(model, "energy.imposed")) > 0.1) == (*loading != 0));
    nb_model_free(model);
    written_free(&it);
  }
}

/* Two heavy discs overlap by 0.2 in a cell that deforms: the imposed motion supplies f.(L l) per second, where f is
 * the force on the first disc and l the vector to the image of the second disc that it touches. The contact is inside
 * the cell, or across one or two of its sides. The displacements are of the order of 1e-7. */
static void by_a_cell(void) {
  static const double places[][4] = {{5, 5, 6.44, 6.08}, {9, 5, 0.44, 6.08}, {5, 1, 6.44, 7.92},
                                     {9, 9, 0.44, 0.08}, {1, 5, 9.56, 3.92}, {1, 1, 9.56, 7.92}};
  for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page,
              "units none\nmaterial m density 1e12 kn 4\nperiodic cell 0 0 to 10 %d\ndisc %.17g %.17g radius 1 m\n"
              "disc %.17g %.17g radius 1 m\nstep 1e-8\nrecord energy.imposed\nstage s\n"
              "cell strain 0.2 -0.3 c12 0.7 c21 0.1\ncycles 20\n",
              k == 2 || k == 5 ? 8 : 10, places[k][0], places[k][1], places[k][2], places[k][3]);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    written_cycles(model, 2);
    const double before = written_now(model, "energy.imposed");
    written_cycles(model, 8);
    const double lx = k == 4 || k == 5 ? -1.44 : 1.44, ly = k == 2 || k >= 4 ? -1.08 : 1.08; /* |l| is 1.8 */
    const double force = 4 * 0.2 / 1.8;                                                      /* f = -force l */
    const double power = -force * (lx * (0.2 * lx + 0.7 * ly) + ly * (0.1 * lx - 0.3 * ly));
    NEAR(written_now(model, "energy.imposed") - before, 8e-8 * power, 1e-6);
    nb_model_free(model);
    written_free(&it);
  }
}

/* A shear law without stored energy is refused if the page records a quantity that needs it. `energy.balance` does not
 * need it: with such a law it uses the work of the shear forces, `energy.shear`, instead. */
static void a_law_without_stored_energy(void) {
  struct written it;
  struct nb_error error;
  struct nb_model *model = made(&it, DRAG);
  struct nb_law loose = *model->material_pairs[0].shear;
  loose.stored = NULL;
  for (size_t p = 0; p < model->material_pair_count; p++)
    model->material_pairs[p].shear = &loose;
  nb_balance_free(model);
  CU_ASSERT_EQUAL(nb_balance_create(model, &error), NB_BAD_USE);
  CU_ASSERT(strstr(error.text, "shear linear") && strstr(error.text, "energy.shear"));
  nb_model_free(model);
  written_free(&it);

  struct words page = {0};
  words_add(&page, "%.*srecord energy.balance energy.shear\nstage s\ncycles 9\n", (int)(strstr(DRAG, "record") - DRAG),
            DRAG);
  written_scene(&it, &page);
  model = written_model(&it, NULL);
  for (size_t p = 0; p < model->material_pair_count; p++)
    model->material_pairs[p].shear = &loose;
  written_cycles(model, 160);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "energy.shear"), 12 * 0.1 + 12 * 12 / 400., 1e-7);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "energy.balance"), 0, 1e-6);
  nb_model_free(model);
  written_free(&it);
}

/* Contacts that get friction from a stage have a shear law from then on, so its stored energy is needed. Without a
 * shear force there is no energy of it. */
static void a_law_without_stored_energy_later(void) {
  static const struct {
    const char *shear, *stage;
    bool refused;
  } rows[] = {{"mindlin", "material m friction 0", false},  {"mindlin", "material m friction 0.3", true},
              {"mindlin", "material m cohesion 1", true},   {"none", "material m friction 0.3", false},
              {"mindlin_deresiewicz", "shear none", false}, {"none", "shear mindlin", true}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error = {NB_OK, ""};
    words_add(&page,
              "units none\nmaterial m density 3 young 5000 poisson 0.2\nnormal hertz\nshear %s\n"
              "sphere 0 0 radius 1 m\nsphere 2 0 radius 1 m\nrecord energy.stored\nstep 0.001\n"
              "stage s\ncycles 9\nstage t\n%s\ncycles 9\n",
              rows[k].shear, rows[k].stage);
    written_scene(&it, &page);
    struct nb_model *model = nb_model_create(&it.scene, NULL, &error);
    CU_ASSERT_EQUAL(error.status, rows[k].refused ? NB_BAD_USE : NB_OK);
    CU_ASSERT_STRING_EQUAL(error.text, rows[k].refused ? "`shear mindlin` has no stored energy: record `energy.shear`, "
                                                         "not `energy.stored` and `energy.friction`"
                                                       : "");
    nb_model_free(model), written_free(&it);
  }
}

/* If the normal law has no stored energy, the energy balance cannot close, even on a page that does not record
 * `energy.stored`. The work balance closes. */
static void a_normal_law_without_stored_energy(void) {
  static const struct {
    const char *record, *words; /* NULL: no error */
  } rows[] = {{"energy.stored", "`normal linear` has no stored energy: record `energy.shear`, not `energy.stored` and "
                                "`energy.friction`"},
              {"energy.friction",
               "`normal linear` has no stored energy: record `energy.shear`, not `energy.stored` and "
               "`energy.friction`"},
              {"energy.damped", "`normal linear` has no stored energy, so energies do not balance"},
              {"energy.balance", "`normal linear` has no stored energy, so energies do not balance"},
              {"work.balance", NULL},
              {"energy.kinetic", NULL}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct written it;
    struct words page = {0};
    struct nb_error error = {NB_OK, ""};
    words_add(&page,
              "units none\nmaterial m density 3 kn 400\ndisc 0 0 radius 1 m\ndisc 1.9 0 radius 1 m\nstep 0.001\n"
              "record %s\nstage s\ncycles 9\n",
              rows[k].record);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    struct nb_law loose = *model->material_pairs[0].normal;
    loose.stored = NULL;
    for (size_t p = 0; p < model->material_pair_count; p++)
      model->material_pairs[p].normal = &loose;
    nb_balance_free(model);
    CU_ASSERT_EQUAL(nb_balance_create(model, &error), rows[k].words ? NB_BAD_USE : NB_OK);
    CU_ASSERT_STRING_EQUAL(error.text, rows[k].words ? rows[k].words : "");
    nb_model_free(model), written_free(&it);
  }
}

/* A centred dashpot still acts in the step in which a contact ends. A disc that rebounds along x loses the same energy as
 * one along y, and in both runs the energies balance equally well. */
static void a_dashpot_ends_in_x_and_in_y(void) {
  static const char *const scenes[] = {"disc 1.01 0 radius 1 m velocity -1 0\nwall w 0 -9 to 0 9 m\n",
                                       "disc 0 1.01 radius 1 m velocity 0 -1\nwall w -9 0 to 9 0 m\n",
                                       "disc 0 0 radius 1 m velocity 1 0\ndisc 2.01 0 radius 1 m\n",
                                       "disc 0 0 radius 1 m velocity 0 1\ndisc 0 2.01 radius 1 m\n"};
  double damped[4], residual[4];
  for (int k = 0; k < 4; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 3 kn 400\ndamping ratio 0.2\ndamping centred\n%sstep 0.01\nrecord "
              "energy.damped energy.balance\nstage s\ncycles 100\n",
              scenes[k]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    damped[k] = written_last(&result, "energy.damped"), residual[k] = written_last(&result, "energy.balance");
    nb_result_free(&result), written_free(&it);
  }
  for (int k = 0; k < 4; k += 2) {
    CU_ASSERT(damped[k] > 0.1);
    CU_ASSERT_DOUBLE_EQUAL(damped[k], damped[k + 1], 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(residual[k], residual[k + 1], 1e-12);
  }
}

/* The dashpots of shear act on the velocity of the surfaces, v + R_1 w_1 + R_2 w_2, also if the radii and spins of the two
 * discs differ. The energies balance up to an error of the order (w dt)^2 with w^2 = 3 k_s/M* = 424: 4e-4. */
static void dashpots_of_different_discs(void) {
  static const char *const discs[] = {"disc 0 0 radius 1 m\ndisc 3.98 0 radius 3 m spin 0.1\n",
                                      "disc 0 0 radius 3 m spin 0.1\ndisc 3.98 0 radius 1 m\n",
                                      "disc 0 0 radius 3 m\ndisc 3.98 0 radius 1 m spin 0.1\n"};
  for (size_t k = 0; k < sizeof discs / sizeof *discs; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1 kn 400 ks 400 friction 1000\nshear linear\ndamping stiffness 0.01\n%s"
              "step 0.001\nrecord energy.damped energy.balance\nstage s\ncycles 100\n",
              discs[k]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    const double damped = written_last(&result, "energy.damped");
    CU_ASSERT(damped > 0.001);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "energy.balance"), 0, 1e-3 * damped);
    nb_result_free(&result), written_free(&it);
  }
}

/* A page that records no energy balance has neither the sums nor the fields for it. */
static void no_balance_unless_asked_for(void) {
  struct written it;
  struct nb_model *model = made(&it, "units none\nmaterial m density 3 kn 400 ks 200 friction 0.3\nshear linear\n"
                                     "disc 0 0 radius 1 m\ndisc 2 0 radius 1 m\nstep 0.001\n"
                                     "record time energy.kinetic momentum.x\nstage s\ncycles 9\n");
  CU_ASSERT_PTR_NULL(model->balance);
  CU_ASSERT_PTR_NULL(model->contacts.kept[NB_SHEAR_BEFORE]);
  CU_ASSERT_PTR_NULL(model->contacts.kept[NB_TANGENTIAL_INCREMENT]);
  CU_ASSERT_EQUAL(model->plan.kept >> NB_FIELDS, 0);
  nb_model_free(model);
  written_free(&it);
}

/* Four discs that touch nothing, under a boundary stress and damping of all particles. The work in a step is exact. The
 * kinetic energy at t_N is that of the mean of two velocities, and has an error of the order (dt/t)^2 = 4e-4. */
static void a_boundary_stress_with_damping(void) {
  static const char *const dampings[] = {"damping mass 0.7\n", "damping con1 0.99 as cs79\n",
                                         "damping con1 0.98 as velocity\n", "damping con1 0.97 as all\n"};
  for (size_t k = 0; k < sizeof dampings / sizeof *dampings; k++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(
        &page,
        "units none\nmaterial m density 1 kn 1\ndisc 9 0 radius 1 m\ndisc 0 9 radius 1 m\ndisc -9 0 radius 1 m\n"
        "disc 0 -8 radius 1 m\nboundary circle 0 0 radius 5\n%sgravity 0.3 -0.2\nstep 0.01\nrecord energy.imposed "
        "energy.damped energy.balance work.balance\nstage a\nboundary stress 5 3 shear 1\ncycles 50\n",
        dampings[k]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    const double supplied = written_last(&result, "energy.imposed");
    CU_ASSERT(supplied > 1 && written_last(&result, "energy.damped") > 1e-3 * supplied);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "energy.balance"), 0, 1e-3 * supplied);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "work.balance"), 0, 1e-12 * supplied);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* The momenta, with rotation and with centres away from the origin. The fixed disc does not count. */
static void momentum(void) {
  struct written it;
  struct nb_model *model = made(&it, "units none\nmaterial m density 3\ndisc 1 2 radius 1 m velocity 3 5 spin 7\n"
                                     "sphere 9 -4 radius 0.5 m velocity -1 2 spin 2\n"
                                     "disc 30 0 radius 1 m velocity 1 1 spin 1 fixed\nstep 0.01\n"
                                     "record momentum.x momentum.y momentum.angular\nstage s\ncycles 9\n");
  const double m = 3 * pi, s = 3 * pi * 4 / 3 * 0.125;
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "momentum.x"), 3 * m - s, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "momentum.y"), 5 * m + 2 * s, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "momentum.angular"),
                         m * (1 * 5 - 2 * 3) + m / 2 * 7 + s * (9 * 2 - 4) + s * 0.4 * 0.25 * 2, 1e-12);
  nb_model_free(model);
  written_free(&it);
}

void suite_energy(void);
void suite_energy(void) {
  CU_pSuite suite = CU_add_suite("energy", NULL, NULL);
  CU_add_test(suite, "rounding errors belong to the sums", rounding_errors_belong_to_the_sums);
  CU_add_test(suite, "the work of all forces equals the kinetic energy", work_closes);
  CU_add_test(suite, "the work balance is exact in a field that depends on the position", work_closes_in_a_field);
  CU_add_test(suite, "all terms of energy together", energy_closes);
  CU_add_test(suite, "storage, threads and instruction sets change no bit", same_bits);
  CU_add_test(suite, "supplied by gravity", by_gravity);
  CU_add_test(suite, "supplied by walls, and stored", by_walls_and_stored);
  CU_add_test(suite, "dissipated by friction", by_friction);
  CU_ADD_TEST(suite, by_dashpots);
  CU_ADD_TEST(suite, by_gravity_and_imposed_motion);
  CU_ADD_TEST(suite, by_damping_of_all_particles);
  CU_ADD_TEST(suite, by_a_cell);
  CU_add_test(suite, "a law without stored energy", a_law_without_stored_energy);
  CU_add_test(suite, "a law without stored energy in a later stage", a_law_without_stored_energy_later);
  CU_add_test(suite, "a normal law without stored energy", a_normal_law_without_stored_energy);
  CU_ADD_TEST(suite, a_dashpot_ends_in_x_and_in_y);
  CU_ADD_TEST(suite, dashpots_of_different_discs);
  CU_add_test(suite, "no balance unless it is asked for", no_balance_unless_asked_for);
  CU_add_test(suite, "a boundary stress with damping of all particles", a_boundary_stress_with_damping);
  CU_add_test(suite, "momentum", momentum);
}
