/* Contact dashpots: their coefficients, the forces that include the dashpot forces, and the limits that must not
 * include them. [CS79 24-28; R89 4.3, 4.13]
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/core/model.h"
#include "../src/measure/step.h"
#include "../src/run/plan.h"
#include "continued.h"
#include "suites.h"
#include "written.h"

static const double pi = 3.14159265358979323846;

/* Two discs of different size and density, the first moving towards the second; `second` is the statement of disc 2. */
static struct nb_model *two_discs(struct written *it, const char *damping, const char *second, double friction) {
  struct words page = {0};
  words_add(
      &page,
      "units none\nmaterial a density 3 kn 400 ks 250 friction %g\nmaterial b density 5 kn 400 ks 250 friction %g\n"
      "shear linear\ndisc 0 0 radius 1 a velocity 0.5 0.25 spin 0.5\n%s\ndamping %s\nstep 0.001\n",
      friction, friction, second, damping);
  words_add(&page,
            "monitor A disc 1\nmonitor B disc 2\nmonitor C disc 1 with disc 2\nrecord A.vx.half A.vy.half A.spin.half "
            "B.vx.half B.vy.half B.spin.half A.x A.y B.x B.y A.fx A.fy C.normal C.shear C.sliding C.dashpot.normal "
            "C.dashpot.shear\nstage s\ncycles 100\n");
  written_scene(it, &page);
  return written_model(it, NULL);
}

/* The rates dn/dt and ds/dt of the contact C over the last step [CS79 14, 15]. */
static void rates(const struct nb_model *model, double *dn, double *slip) {
  const double dx = written_now(model, "B.x") - written_now(model, "A.x"),
               dy = written_now(model, "B.y") - written_now(model, "A.y");
  const double e1 = dx / hypot(dx, dy), e2 = dy / hypot(dx, dy);
  const double vx = written_now(model, "A.vx.half") - written_now(model, "B.vx.half");
  const double vy = written_now(model, "A.vy.half") - written_now(model, "B.vy.half");
  *dn = vx * e1 + vy * e2;
  *slip = vx * e2 - vy * e1 - (written_now(model, "A.spin.half") + 2 * written_now(model, "B.spin.half"));
}

/* Two dampings are equal if every number and every kind is equal. */
static void equal_dampings(void) {
  const struct nb_damping a = {.contact_kind = NB_CONTACT_RATIO,
                               .contact = 2,
                               .walls_separate = true,
                               .walls_kind = NB_CONTACT_RATIO,
                               .walls = 3,
                               .global_kind = NB_GLOBAL_MASS,
                               .global = 4,
                               .deep = 5};
  struct nb_damping b = a;
  b.centred = true;
  CU_ASSERT(!nb_damping_equal(&a, &b));
  b.centred = false;
  double *numbers[] = {&b.contact, &b.walls, &b.global, &b.deep};
  CU_ASSERT(nb_damping_equal(&a, &b));
  for (size_t n = 0; n < sizeof numbers / sizeof *numbers; n++)
    for (int more = -1; more <= 1; more += 2) {
      *numbers[n] += more;
      CU_ASSERT(!nb_damping_equal(&a, &b));
      *numbers[n] -= more;
    }
  b.contact_kind = NB_CONTACT_STIFFNESS;
  CU_ASSERT(!nb_damping_equal(&a, &b));
  b.contact_kind = a.contact_kind, b.walls_kind = NB_CONTACT_STIFFNESS;
  CU_ASSERT(!nb_damping_equal(&a, &b));
  b.walls_kind = a.walls_kind, b.global_kind = NB_GLOBAL_UNDAMPED;
  CU_ASSERT(!nb_damping_equal(&a, &b));
  CU_ASSERT(!nb_damping_none(&a) && nb_damping_none(&(struct nb_damping){0}));
}

/* The line of the statement that gives a page dashpots; 0: none. A statement without a dashpot does not count. */
static void lines(void) {
  static const struct {
    struct nb_damping damping;
    int line;
  } rows[] = {
      {{.contact_line = 3, .walls_line = 4, .deep_line = 5}, 0},
      {{.contact_kind = NB_CONTACT_RATIO, .contact_line = 3, .walls_separate = true, .walls_line = 4}, 3},
      {{.walls_separate = true, .walls_kind = NB_CONTACT_STIFFNESS, .walls_line = 4, .contact_line = 3}, 4},
      {{.walls_separate = true, .walls_line = 4, .contact_line = 3, .deep_line = 5}, 0},
      {{.walls_separate = true, .walls_line = 4, .deep = 0.1, .deep_line = 5}, 5},
      {{.walls_kind = NB_CONTACT_RATIO, .walls_line = 4}, 0}, /* the walls have no damping of their own */
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    CU_ASSERT_EQUAL(nb_damping_contact_line(&rows[k].damping), rows[k].line);
}

/* In the step of first touch the spring takes only the fraction overlap/dn of the tangential increment, while the
 * dashpot has the full rate. */
static void first_touch(void) {
  struct written it;
  struct nb_model *model = two_discs(&it, "stiffness 0.02", "disc 2.96 0.5 radius 2 b velocity -1 0", 10);
  CU_ASSERT_EQUAL(written_now(model, "C.normal"), 0);
  double dn, slip;
  do
    written_cycles(model, 1);
  while (!(written_now(model, "C.normal") > 0));
  rates(model, &dn, &slip);
  const double overlap = written_now(model, "C.normal") / 400, fraction = overlap / (dn * 0.001);
  CU_ASSERT(fraction > 0.1 && fraction < 0.9 && fabs(slip) > 0.1);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.shear"), 250 * fraction * slip * 0.001, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.dashpot.shear"), 0.02 * 250 * slip, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.dashpot.normal"), 0.02 * 400 * dn, 1e-12);
  nb_model_free(model);
  written_free(&it);
}

static void coefficients(void) {
  const double a = pi * 3, b = pi * 4 * 5, critical = 2 * sqrt(a / 400);
  static const char free_[] = "disc 2.9 0.5 radius 2 b spin 0.25", fixed[] = "disc 2.9 0.5 radius 2 b spin 0.25 fixed";
  const struct {
    const char *damping, *second;
    double normal, shear; /* c, N s/m */
  } kinds[] = {
      {"stiffness 0.02", free_, 0.02 * 400, 0.02 * 250},
      {"r89-fraction 0.3", free_, 0.3 * 400 * critical / 2, 0.3 * 250 * critical / 2},
      {"ratio 0.1", free_, 0.2 * sqrt(a * b / (a + b) * 400), 0.2 * sqrt(a * b / (a + b) * 250)},
      {"ratio 0.1", fixed, 0.2 * sqrt(a * 400), 0.2 * sqrt(a * 250)}, /* a fixed disc has infinite mass */
  };
  for (size_t n = 0; n < sizeof kinds / sizeof *kinds; n++) {
    struct written it;
    struct nb_model *model = two_discs(&it, kinds[n].damping, kinds[n].second, 10);
    CU_ASSERT_EQUAL(written_now(model, "C.dashpot.normal"), 0); /* nothing has moved yet */
    for (int cycle = 0; cycle < 20; cycle++) {
      double dn, slip;
      written_cycles(model, 1);
      rates(model, &dn, &slip);
      CU_ASSERT(fabs(dn) > 0.1 && fabs(slip) > 0.1);
      CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.dashpot.normal"), kinds[n].normal * dn, 1e-12);
      CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.dashpot.shear"), kinds[n].shear * slip, 1e-12);
    }
    const double normal = written_now(model, "C.dashpot.normal"), shear = written_now(model, "C.dashpot.shear");
    model->step *= 3; /* rates are over the last step, whatever the next step is */
    nb_forces(model);
    CU_ASSERT(written_now(model, "C.dashpot.normal") == normal);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.dashpot.shear"), shear, 1e-12);
    nb_model_free(model);
    written_free(&it);
  }
}

/* The coefficients of `damping ratio` follow the stiffness in a stage whose ramp changes k_n (`of_kn`) or k_s in every
 * cycle. */
static void coefficients_under(const char *ramp, bool of_kn) {
  struct words page = {0};
  struct written it;
  words_add(
      &page,
      "units none\nmaterial m density 3 kn 400 ks 250 friction 10\nshear linear\ndisc 0 0 radius 1 m velocity "
      "0.5 0.25 spin 0.5\ndisc 2.9 0.5 radius 2 m spin 0.25\ndamping ratio 0.1\nstep 0.001\nmonitor A disc 1\n"
      "monitor B disc 2\nmonitor C disc 1 with disc 2\nrecord A.vx.half A.vy.half A.spin.half B.vx.half B.vy.half "
      "B.spin.half A.x A.y B.x B.y C.dashpot.normal C.dashpot.shear\nstage s\nramp material m %s\ncycles 20\n",
      ramp);
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  struct nb_error error;
  const double a = pi * 3, b = pi * 4 * 3, mass = a * b / (a + b);
  double kn = 400, ks = 250;
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  for (int cycle = 0; cycle < 20; cycle++) {
    double dn, slip;
    written_cycles(model, 1);
    rates(model, &dn, &slip);
    const struct nb_pair *pair = &model->material_pairs[model->contacts.material_pair[0]].values;
    CU_ASSERT((pair->kn > kn) == of_kn && (pair->ks < ks) != of_kn && fabs(dn) > 0.1 && fabs(slip) > 0.1);
    kn = pair->kn, ks = pair->ks;
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.dashpot.normal"), 0.2 * sqrt(mass * kn) * dn, 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.dashpot.shear"), 0.2 * sqrt(mass * ks) * slip, 1e-12);
  }
  nb_model_free(model);
  written_free(&it);
}
static void coefficients_under_a_ramp(void) {
  coefficients_under("kn 500", true);
  coefficients_under("ks 200", false);
}

/* `damping centred`: the dashpot force at t_N is that of the velocity at t_(N-1/2) plus half of its last change. At
 * time 0 the velocity is that of the page. The dashpot force is multiplied by a weight only in the steps in which a
 * contact begins or ends, so not here. */
static void centred(void) {
  struct written it;
  struct nb_model *model = two_discs(&it, "stiffness 0.02\ndamping centred", "disc 2.9 0.5 radius 2 b spin 0.25", 10);
  const double e1 = 2.9 / hypot(2.9, 0.5), e2 = 0.5 / hypot(2.9, 0.5);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.dashpot.normal"), 0.02 * 400 * (0.5 * e1 + 0.25 * e2), 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.dashpot.shear"), 0.02 * 250 * (0.5 * e2 - 0.25 * e1 - (0.5 + 2 * 0.25)),
                         1e-12);
  static const char *const names[] = {"A.vx.half", "A.vy.half", "A.spin.half", "B.vx.half", "B.vy.half", "B.spin.half"};
  for (int cycle = 0; cycle < 20; cycle++) {
    double before[6], v[6];
    for (int k = 0; k < 6; k++)
      before[k] = written_now(model, names[k]);
    written_cycles(model, 1);
    /* the first change of the velocity is that of half a step */
    for (int k = 0; k < 6; k++)
      v[k] = written_now(model, names[k]) + (cycle == 0 ? 1 : 0.5) * (written_now(model, names[k]) - before[k]);
    const double dx = written_now(model, "B.x") - written_now(model, "A.x"),
                 dy = written_now(model, "B.y") - written_now(model, "A.y"), d = hypot(dx, dy);
    const double dn = ((v[0] - v[3]) * dx + (v[1] - v[4]) * dy) / d;
    const double slip = ((v[0] - v[3]) * dy - (v[1] - v[4]) * dx) / d - (v[2] + 2 * v[5]);
    CU_ASSERT(fabs(dn) > 0.1 && fabs(slip) > 0.1);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.dashpot.normal"), 0.02 * 400 * dn, 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.dashpot.shear"), 0.02 * 250 * slip, 1e-12);
  }
  nb_model_free(model);
  written_free(&it);
}

/* Two discs so heavy that the contact does not accelerate them have only the affine motion. Their relative velocity is
 * then E times the distance of their centres when the step began, and its predicted change is 0. */
static void centred_in_affine_motion(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial a density 1e30 kn 400\ndisc 0.5 0 radius 1 a\ndisc 2.25 0 radius 1 a\n"
                   "damping stiffness 0.02\ndamping centred\nstep 0.125\nmonitor A disc 1\nmonitor B disc 2\n"
                   "monitor C disc 1 with disc 2\nrecord A.x B.x C.dashpot.normal\nstage s\naffine strain -0.1 0\n"
                   "cycles 3\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_EQUAL_FATAL(result.table.row_count, 4);
  for (size_t row = 1; row < 4; row++) {
    const double apart = written_cell(&result.table, row - 1, "B.x") - written_cell(&result.table, row - 1, "A.x");
    CU_ASSERT_DOUBLE_EQUAL(written_cell(&result.table, row, "C.dashpot.normal"), 0.02 * 400 * 0.1 * apart, 1e-12);
  }
  nb_result_free(&result);
  written_free(&it);
}

/* In a motion that changes its sign every cycle the predicted velocity is twice the velocity half a step before. So
 * centred dashpots have the stable step of late dashpots with twice the damping ratio. */
static void stable_step_of_centred_dashpots(void) {
  static const char *const dampings[] = {"ratio 0.2\ndamping centred", "ratio 0.4"};
  double step[2];
  for (int k = 0; k < 2; k++) {
    struct written it;
    struct nb_model *model = two_discs(&it, dampings[k], "disc 2.9 0.5 radius 2 b", 10);
    step[k] = model->stability->stable_step;
    nb_model_free(model);
    written_free(&it);
  }
  CU_ASSERT(step[0] > 0);
  CU_ASSERT_DOUBLE_EQUAL(step[0], step[1], 1e-12 * step[1]);
}

/* A run that continues from any cycle of an impact gives the same bits, also from the cycle in which the contact has
 * opened and the dashpot still acts. */
static void continued_impact(void) {
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial m density 3 kn 400\ndisc 0 0 radius 1 m velocity 0.25 0\nwall w 1.01 -9 to 1.01 9 "
            "m\ndamping ratio 0.3\ndamping centred\nstep 0.03\nmonitor C disc 1 with wall w\nrecord C.overlap\n");
  for (int k = 0; k < 24; k++)
    words_add(&page, "stage s%d\ncycles 1\n", k);
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  int ends = 0;
  for (int k = 0; k < 24; k++) {
    written_cycles(model, 1);
    ends += !(written_now(model, "C.overlap") > 0) && model->contacts.count > 0 && model->contacts.force[0].x != 0;
  }
  CU_ASSERT_EQUAL(ends, 1);
  nb_model_free(model);
  continued_same(&it, "centred dashpots");
  written_free(&it);
}

/* The last normal force of an impact whose first touch is in the second stage. */
static double force_after_change(const char *first, const char *second) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(
      &page,
      "units none\nmaterial m density 3 kn 400\nsphere 0 0 radius 1 m velocity 0.25 0\nwall w 1.01 -9 to 1.01 9 m\n"
      "damping ratio 0.3\nstep 0.01\nmonitor C sphere 1 with wall w\nrecord C.normal\nstage before\ndamping %s\n"
      "cycles 3\nstage touch\ndamping %s\ncycles 8\n",
      first, second);
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  const double force = written_last(&result, "C.normal");
  nb_result_free(&result), written_free(&it);
  return force;
}

/* No dashpot acts before the contact, so only the words of the stage with the contact count. */
static void a_stage_changes_the_time_of_the_velocity(void) {
  const double late = force_after_change("late", "late"), centred = force_after_change("centred", "centred");
  CU_ASSERT(fabs(late - centred) > 1e-3 * centred);
  CU_ASSERT_EQUAL(force_after_change("centred", "late"), late);
  CU_ASSERT_EQUAL(force_after_change("late", "centred"), centred);
}

/* First touch is at the end of a step, or at time 0. The dashpot then acts for the same time, whether the overlap is 0
 * or differs from 0 by rounding. The gaps differ by up to 1e-12 of the displacement in a step, which changes the
 * restitution by a fraction of this order; the test allows 1e-9. */
static void a_touch_at_the_end_of_a_step(void) {
  static const double offsets[] = {0, 1e-17, 1e-16, 1e-15, 1e-14, -1e-17, -1e-16, -1e-15, -1e-14};
  static const char *const laws[] = {"normal linear", "normal hertz"};
  for (int run = 0; run < 4; run++) {
    const int law = run % 2, steps = run < 2 ? 3 : 0; /* before first touch */
    double first = 0;
    for (size_t k = 0; k < sizeof offsets / sizeof *offsets; k++) {
      struct words page = {0};
      struct written it;
      struct nb_result result;
      words_add(
          &page,
          "units none\nmaterial m density 3 kn 400 young 4000 poisson 0.3\n%s\nsphere %.17g 0 radius 1 m velocity 0.25 "
          "0\n"
          "wall w 1 -9 to 1 9 m\ndamping ratio 0.3\ndamping centred\nstep 0.03125\nmonitor D sphere 1\n"
          "monitor C sphere 1 with wall w\nrecord D.vx C.overlap\nstage in\nrecord none\n"
          "until C.overlap above 1e-6 at most 100 cycles\nstage out\nuntil C.overlap below 1e-300 at most 1000 cycles\n"
          "stage free\nrecord every 2 cycles\ncycles 2\n",
          laws[law], -steps * 0.03125 * 0.25 + offsets[k]);
      written_scene(&it, &page);
      written_run(&result, &it, NULL);
      const double restitution = -written_last(&result, "D.vx") / 0.25;
      first = k ? first : restitution;
      /* as in `restitution` below; (w dt)^2 = dt^2 k/m = 0.031 */
      const double beta = 0.3, expected = exp(-pi * beta / sqrt(1 - beta * beta));
      CU_ASSERT(law || fabs(restitution / expected - 1) <= 3 * 2 * beta * 0.031 / 2);
      CU_ASSERT_DOUBLE_EQUAL(restitution, first, 1e-9);
      nb_result_free(&result), written_free(&it);
    }
  }
}

/* A sphere so heavy that no force changes its velocity touches a wall. At the first time after first touch the forces of
 * both centred dashpots are w(f) times coefficient times velocity (pass/dashpots.c), with w(f) = (f + 1/2)^(1+p)/((1+p)
 * f^p). The coefficient is proportional to the overlap to the power p: 0 for linear springs, 1/2 for the stiffness of
 * elastic spheres, 1/4 for its root. One cycle later w is 1. */
static void weights_at_first_touch(void) {
  const double dt = 0.03125, mass = 4. / 3 * pi * 1e30;
  for (int elastic = 0; elastic < 2; elastic++)
    for (int ratio = 0; ratio < 2; ratio++) {
      struct words page = {0};
      struct written it;
      words_add(
          &page,
          "units none\nmaterial m density 1e30 kn 400 ks 300 young 4000 poisson 0.25 friction 10\nnormal %s\nshear "
          "%s\nsphere %.17g 0 radius 1 m velocity 0.25 0.1 spin 0.2\nwall w 1 -9 to 1 9 m\ndamping %s\ndamping "
          "centred\nstep 0.03125\nmonitor C sphere 1 with wall w\nrecord C.overlap C.dashpot.normal "
          "C.dashpot.shear\nstage s\ncycles 2\n",
          elastic ? "hertz" : "linear", elastic ? "mindlin" : "linear", -0.6 * dt * 0.25,
          ratio ? "ratio 0.3" : "stiffness 0.02");
      written_scene(&it, &page);
      struct nb_model *model = written_model(&it, NULL);
      for (int cycle = 1; cycle <= 2; cycle++) {
        written_cycles(model, 1);
        const double f = cycle - 0.6, overlap = f * dt * 0.25, a = sqrt(overlap), p = elastic ? ratio ? 0.25 : 0.5 : 0;
        const double kn = elastic ? 4000 / (1 - 0.0625) * a : 400, ks = elastic ? 8 * 4000 / (2.5 * 2 * 1.75) * a : 300;
        const double w = cycle == 1 ? pow(f + 0.5, 1 + p) / ((1 + p) * pow(f, p)) : 1;
        const double cn = ratio ? 0.6 * sqrt(mass * kn) : 0.02 * kn, cs = ratio ? 0.6 * sqrt(mass * ks) : 0.02 * ks;
        CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.overlap"), overlap, 1e-15);
        CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.dashpot.normal") / (w * cn * 0.25), 1, 1e-12);
        CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.dashpot.shear") / (w * cs * -(0.1 + 0.2)), 1, 1e-12);
      }
      nb_model_free(model);
      written_free(&it);
    }
}

/* At a wall M* is the mass of the disc: [R89 4.6] with 1/M_wall = 0. */
static void a_wall_has_infinite_mass(void) {
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial m density 3 kn 400\ndisc 0 0 radius 1 m velocity 0.5 0\nwall w 0.9 -9 to 0.9 9 m\n"
            "damping ratio 0.1\nstep 0.001\nmonitor A disc 1\nmonitor C disc 1 with wall w\n"
            "record A.vx.half C.dashpot.normal\nstage s\ncycles 9\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  written_cycles(model, 3);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.dashpot.normal"),
                         0.2 * sqrt(pi * 3 * 400) * written_now(model, "A.vx.half"), 1e-12);
  nb_model_free(model);
  written_free(&it);
}

/* At time 0 the dashpot at a wall that moves with the velocity V and rotates about P uses the velocity V + w x (Q - P) of
 * the nearest point Q of the wall, also if P is not on the line of the wall. Q is (0, 0.9), and e points from the disc to Q, in +y. */
static void a_wall_that_rotates(void) {
  const double c = 0.2 * sqrt(pi * 3 * 400), spin = -0.5;
  for (int above = 0; above < 4; above++) { /* distance of P from the wall */
    const double u = 0.3 - spin * (0.9 - (0.9 + above)), v = -0.7 + spin * 2;
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 3 kn 400 ks 400 friction 9\nshear linear\ndisc 0 0 radius 1 m\n"
              "wall w -4 0.9 to 4 0.9 m about -2 %g velocity 0.3 -0.7 spin %g\ndamping ratio 0.1\ndamping "
              "centred\nstep 0.001\n"
              "monitor C disc 1 with wall w\nrecord C.dashpot.normal C.dashpot.shear\nstage s\ncycles 9\n",
              0.9 + above, spin);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.dashpot.normal"), -c * v, 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.dashpot.shear"), -c * u, 1e-12);
    nb_model_free(model);
    written_free(&it);
  }
}

/* When discs separate fast, the tension of the dashpot exceeds the force of the spring; the total normal force is
 * the sum. */
static void total_normal_force_may_be_tensile(void) {
  struct written it;
  struct nb_model *model = two_discs(&it, "stiffness 1", "disc 2.99 0 radius 2 b velocity 3 0.25", 0);
  written_cycles(model, 1);
  const double elastic = written_now(model, "C.normal"), damped = elastic + written_now(model, "C.dashpot.normal");
  CU_ASSERT(elastic > 0 && damped < 0);
  const double dx = written_now(model, "B.x") - written_now(model, "A.x"),
               dy = written_now(model, "B.y") - written_now(model, "A.y");
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.fx"), -damped * dx / hypot(dx, dy), 1e-9);
  CU_ASSERT(written_now(model, "A.fx") > 0);
  written_cycles(model, 99);
  CU_ASSERT_EQUAL(written_now(model, "C.normal"), 0);
  CU_ASSERT_EQUAL(written_now(model, "C.dashpot.normal"), 0); /* the dashpot force ends with the contact */
  CU_ASSERT_EQUAL(written_now(model, "A.fx"), 0);
  nb_model_free(model);
  written_free(&it);
}

/* The friction limit uses the elastic F_n alone, and a contact that slides has no shear dashpot. [CS79, Damping] */
static void sliding(void) {
  struct written it;
  struct nb_model *model = two_discs(&it, "stiffness 0.05", "disc 2.9 0.5 radius 2 b spin 9", 0.01);
  int slid = 0;
  for (int cycle = 0; cycle < 20; cycle++) {
    written_cycles(model, 1);
    if (written_now(model, "C.sliding") == 0)
      continue;
    slid++;
    CU_ASSERT(fabs(written_now(model, "C.dashpot.normal")) > 1); /* a limit with the dashpot force would differ */
    CU_ASSERT_DOUBLE_EQUAL(fabs(written_now(model, "C.shear")), 0.01 * written_now(model, "C.normal"), 1e-12);
    CU_ASSERT_EQUAL(written_now(model, "C.dashpot.shear"), 0);
  }
  CU_ASSERT(slid > 10);
  nb_model_free(model);
  written_free(&it);
}

/* A disc at a wall. The contact ends with the overlap, although the dashpot pulls before that. The contact lasts half a
 * period of the damped oscillation, so e = exp(-pi beta/sqrt(1 - beta^2)). First touch, separation and the half step of
 * the dashpot are each late by up to a step, which changes the velocity by up to the fraction c dt/m = 2 beta w dt.
 * With `damping centred` the error is of second order: (3/8) pi beta (w dt)^2 by the prediction of the velocity, and
 * terms in beta^2. */
static void restitution(void) {
  const double m = pi * 3, w = sqrt(400 / m);
  static const double betas[] = {0.02, 0.1, 0.3};
  for (int n = 0; n < 12; n++) {
    const bool centred = n >= 6;
    const double beta = betas[n % 3], dt = (n % 6 < 3 ? 0.02 : 0.002) / w;
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(
        &page,
        "units none\nmaterial m density 3 kn 400\ndisc 0 0 radius 1 m velocity 0.25 0\nwall w 1.01 -9 to 1.01 9 m\n"
        "damping ratio %g\ndamping %s\nstep %.17g\nmonitor D disc 1\nmonitor C disc 1 with wall w\nrecord D.vx "
        "C.overlap\n"
        "stage in\nrecord none\nuntil C.overlap above 0 at most 100000 cycles\nstage out\nrecord every 100000 cycles\n"
        "until C.overlap below 1e-300 at most 100000 cycles\nstage free\nrecord every 2 cycles\ncycles 2\n",
        beta, centred ? "centred" : "late", dt);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    const double expected = exp(-pi * beta / sqrt(1 - beta * beta)), computed = -written_last(&result, "D.vx") / 0.25;
    const double tolerance = 3 * 2 * beta * w * dt * (centred ? w * dt / 2 : 1);
    if (!(fabs(computed / expected - 1) <= tolerance))
      printf("# e = %.9g, expected %.9g, at beta = %g\n", computed, expected, beta);
    CU_ASSERT(fabs(computed / expected - 1) <= tolerance);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* In a stage without damping the dashpot forces are 0, although the next stage has dashpots. */
static void a_stage_without_dashpots(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(
      &page,
      "units none\nmaterial m density 3 kn 400 ks 250 friction 9\nshear linear\ndisc 0 0 radius 1 m velocity 0.5 0.25\n"
      "disc 2.9 0.5 radius 2 m\nstep 0.001\nmonitor C disc 1 with disc 2\nrecord C.dashpot.normal C.dashpot.shear\n"
      "stage free\ncycles 9\nstage damped\ndamping stiffness 0.02\ncycles 9\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_EQUAL_FATAL(result.table.row_count, 19);
  for (size_t value = 0; value < 2 * 19; value++)
    CU_ASSERT(value < 2 * 10 ? result.table.values[value] == 0 : fabs(result.table.values[value]) > 0.1);
  nb_result_free(&result);
  written_free(&it);
}

void suite_damping(void) {
  CU_pSuite suite = CU_add_suite("damping", NULL, NULL);
  CU_add_test(suite, "equal dampings", equal_dampings);
  CU_add_test(suite, "in the step of first touch the dashpot has the full rate", first_touch);
  CU_add_test(suite, "coefficients of the three conventions", coefficients);
  CU_add_test(suite, "coefficients under a ramp of the stiffness", coefficients_under_a_ramp);
  CU_add_test(suite, "centred dashpots", centred);
  CU_ADD_TEST(suite, centred_in_affine_motion);
  CU_add_test(suite, "the stable step of centred dashpots", stable_step_of_centred_dashpots);
  CU_add_test(suite, "an impact with centred dashpots continues in any cycle", continued_impact);
  CU_add_test(suite, "a touch at the end of a step", a_touch_at_the_end_of_a_step);
  CU_ADD_TEST(suite, weights_at_first_touch);
  CU_ADD_TEST(suite, lines);
  CU_ADD_TEST(suite, a_stage_changes_the_time_of_the_velocity);
  CU_add_test(suite, "a wall has infinite mass", a_wall_has_infinite_mass);
  CU_add_test(suite, "a stage without dashpots", a_stage_without_dashpots);
  CU_add_test(suite, "the total normal force may be tensile", total_normal_force_may_be_tensile);
  CU_add_test(suite, "sliding: limit of the elastic force, no shear dashpot", sliding);
  CU_add_test(suite, "restitution of a disc on a wall", restitution);
  CU_ADD_TEST(suite, a_wall_that_rotates);
}
