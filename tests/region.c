/* Measures of regions: assemblies whose measures are known from hand calculations.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/core/names.h"
#include "../src/measure/region.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

static const double pi = 3.14159265358979323846;

#define CLOSE(model, name, wanted)                                                                                     \
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, name), wanted, 2e-14 * (1 + fabs((double)(wanted))))

static struct nb_model *model_of(struct written *it, struct words *page) {
  written_scene(it, page);
  return written_model(it, NULL);
}
static void done(struct written *it, struct nb_model *model) {
  nb_model_free(model);
  written_free(it);
}

/* The fractions of the deviator that normal and shear forces carry sum to 1, at the start and after nine cycles,
 * even if the page requests no other quantity of the stress. */
static void fractions_without_the_stress(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 7 ks 5 friction 0.5\nshear linear\nstep 0.001\n"
                   "disc 2 3 radius 1 m\ndisc 3.9 3.2 radius 1 m velocity 0 1\nregion A all\nrecord "
                   "A.stress.normal.fraction A.stress.shear.fraction\nstage s\ncycles 9\n");
  struct nb_model *model = model_of(&it, &page);
  CLOSE(model, "A.stress.normal.fraction", 1);
  written_cycles(model, 9);
  CU_ASSERT(written_now(model, "A.stress.shear.fraction") > 1e-3);
  CLOSE(model, "A.stress.normal.fraction", 1 - written_now(model, "A.stress.shear.fraction"));
  done(&it, model);
}

/* A disc with n other discs at equal angles around it, so that the normals are at 2 pi k/n + turn. */
static void contacts_at_equal_angles(void) {
  for (int n = 1; n <= 6; n++) {
    struct words page = {0};
    struct written it;
    double turn = 0.3, fourth[5] = {0}, second[3] = {0};
    words_add(&page, "units none\nmaterial m density 1 kn 7\nstep 0.001\ndisc 2 3 radius 1 m\n");
    for (int k = 0; k < n; k++) {
      const double c = cos(2 * pi * k / n + turn), s = sin(2 * pi * k / n + turn);
      words_add(&page, "disc %.17g %.17g radius 0.98 m\n", 2 + 1.97 * c, 3 + 1.97 * s); /* larger ones would overlap */
      const double parts[] = {c * c * c * c, c * c * c * s, c * c * s * s, c * s * s * s, s * s * s * s};
      for (int p = 0; p < 5; p++)
        fourth[p] += parts[p] / n;
      second[0] += c * c / n, second[1] += c * s / n, second[2] += s * s / n;
    }
    words_add(&page,
              "region A circle 2 3 radius 0.5\nrecord A.fabric.xx A.fabric.xy A.fabric.yy A.fabric.normal.xx "
              "A.fabric.shear.xx A.fabric.fourth.xxxx A.fabric.fourth.xxxy A.fabric.fourth.xxyy A.fabric.fourth.xyyy "
              "A.fabric.fourth.yyyy A.fabric.anisotropy A.fabric.kk A.particles A.contacts "
              "A.coordination A.stress.xx A.stress.yy A.area A.fabric.major A.fabric.angle\nstage s\ncycles 1\n");
    struct nb_model *model = model_of(&it, &page);
    CLOSE(model, "A.particles", 1);
    CLOSE(model, "A.contacts", n);
    CLOSE(model, "A.coordination", n);
    CLOSE(model, "A.fabric.xx", second[0]);
    CLOSE(model, "A.fabric.xy", second[1]);
    CLOSE(model, "A.fabric.yy", second[2]);
    CLOSE(model, "A.fabric.normal.xx", second[0]);
    CLOSE(model, "A.fabric.shear.xx", 0);
    CLOSE(model, "A.fabric.fourth.xxxx", fourth[0]);
    CLOSE(model, "A.fabric.fourth.xxxy", fourth[1]);
    CLOSE(model, "A.fabric.fourth.xxyy", fourth[2]);
    CLOSE(model, "A.fabric.fourth.xyyy", fourth[3]);
    CLOSE(model, "A.fabric.fourth.yyyy", fourth[4]);
    if (n > 2) { /* isotropic in second order; in fourth order too, except for n = 4 */
      CLOSE(model, "A.fabric.xx", 0.5);
      CLOSE(model, "A.fabric.anisotropy", 0);
      CLOSE(model, "A.fabric.fourth.xxxx", n == 4 ? 3. / 8 + cos(4 * turn) / 8 : 3. / 8);
    } else {
      CLOSE(model, "A.fabric.major", 1);
      CLOSE(model, "A.fabric.angle", turn);
    }
    CLOSE(model, "A.fabric.kk", n / (pi / 4)); /* mean radius 1, thickness 1 */
    const double overlap = 1.98 - 1.97, l = 1 - overlap / 2;
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.stress.xx"), n * 7 * overlap * l * second[0] / (pi / 4), 1e-13);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.stress.yy"), n * 7 * overlap * l * second[2] / (pi / 4), 1e-13);
    done(&it, model);
  }
}

/* The rattlers of chains, of a loop and of a single disc. Four discs in a square loop are no rattlers; the discs of a
 * tail attached to the loop are rattlers. Only the particles that a rattler touches lose a contact with it. */
static void rattlers(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 10\nstep 0.001\n"
                   "lattice discs 2 by 2 from 0 0 radius 1 spacing 1.99 m\n" /* 1-4: a loop */
                   "disc 3.98 0 radius 1 m\ndisc 5.97 0 radius 1 m\n"        /* 5, 6: its tail */
                   "disc 0 4 radius 1 m\n" /* 7: a neighbour of the loop without contact */
                   "disc 30 0 radius 1 m fixed\ndisc 31.99 0 radius 1 m\n" /* 8 is fixed */
                   "wall w 32.98 -1 to 32.98 1 m\n"                        /* 9 touches 8 and this wall: no rattler */
                   "disc 50 0 radius 1 m fixed\n" /* 10 is fixed: no rattler, although it has no contact */
                   "region A all\nregion B box -2 -2 to 3 3\n"
                   "record A.particles A.contacts A.coordination A.coordination.mechanical A.rattlers "
                   "A.constraint_ratio B.constraint_ratio "
                   "B.particles B.contacts B.coordination B.coordination.mechanical B.rattlers\nstage s\ncycles 1\n");
  struct nb_model *model = model_of(&it, &page);
  CLOSE(model, "A.particles", 10);
  CLOSE(model, "A.contacts", 4 + 2 + 2);
  CLOSE(model, "A.coordination", (3 + 2 + 2 + 2 + 2 + 1 + 0 + 1 + 2 + 0) / 10.);
  CLOSE(model, "A.rattlers", 3);
  CLOSE(model, "A.coordination.mechanical", (2 + 2 + 2 + 2 + 1 + 2 + 0) / 7.);
  CLOSE(model, "B.particles", 4);
  CLOSE(model, "B.contacts", 5);
  CLOSE(model, "B.coordination", 9 / 4.);
  CLOSE(model, "B.coordination.mechanical", 2);
  CLOSE(model, "B.rattlers", 0);
  CLOSE(model, "A.constraint_ratio", (4 + 2) / (2 * 5.)); /* the loop and 9, which are free and no rattlers */
  CLOSE(model, "B.constraint_ratio", 4 / (2 * 4.));
  done(&it, model);
}

static void volumes(void) {
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial m density 1 kn 10\nstep 0.001\n"
            "sphere 0 0 radius 1 m\nsphere 10 0 radius 3 m\n"
            "region A circle 0 0 radius 2\nregion B box -1 0 to 1 3\nregion C all\n"
            "record A.porosity A.porosity.volume A.void_ratio A.area B.porosity B.porosity.volume C.area C.porosity "
            "C.porosity.volume\nstage s\ncycles 1\n");
  struct nb_model *model = model_of(&it, &page);
  CLOSE(model, "A.area", 4 * pi);
  CLOSE(model, "A.porosity", 0.75);
  CLOSE(model, "A.void_ratio", 3);
  CLOSE(model, "A.porosity.volume",
        1 - 4 * pi / 3 / (4 * pi * 4)); /* 4: the thickness of all particles, not of those inside */
  CLOSE(model, "B.porosity", 1 - pi / 2 / 6);
  CLOSE(model, "B.porosity.volume", 1 - 4 * pi / 3 / 2 / (6 * 4)); /* half of the sphere */
  CLOSE(model, "C.area", 14 * 6);
  CLOSE(model, "C.porosity", 1 - 10 * pi / 84);
  CLOSE(model, "C.porosity.volume", 1 - 4 * pi / 3 * 28 / (84 * 4));
  done(&it, model);
}

/* A centre on the edge of a region is inside. All numbers are exact. */
static void centres_on_the_edge(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 1\ndisc 3 4 radius 0.5 m\ndisc -5 0 radius 0.5 m\n"
                   "disc 0 -5.0625 radius 0.5 m\ndisc 6 1 radius 0.5 m\ndisc 2 -2 radius 0.5 m\n"
                   "disc 6.0625 -2 radius 0.5 m\nregion A circle 0 0 radius 5\nregion B box 2 -2 to 6 4\n"
                   "record A.particles B.particles\nstep 1\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL(written_now(model, "A.particles"), 3); /* the discs 1, 2 and 5 */
  CU_ASSERT_EQUAL(written_now(model, "B.particles"), 3); /* the discs 1, 4 and 5 */
  nb_model_free(model);
  written_free(&it);
}

/* A box, two of whose edges halve a disc each, is rotated and mirrored with the scene. */
static void a_rotated_box(void) {
  static const char *const places[] = {"", "transform rotate 0.5\n", "transform mirror x rotate 2 translate 3 -2\n"};
  for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\n%smaterial m density 1 kn 10\nstep 0.001\ndisc 0 0 radius 1 m\ndisc 3 2 radius 1 m\n"
              "region B box 0 -1 to 3 3\nrecord B.porosity B.area B.particles\nstage s\ncycles 1\n",
              places[k]);
    struct nb_model *model = model_of(&it, &page);
    CLOSE(model, "B.area", 12);
    CLOSE(model, "B.porosity", 1 - pi / 12); /* half of each */
    done(&it, model);
  }
}

/* If particles move with a constant velocity gradient, their strain is this gradient times the time, to rounding. */
static void strain(void) {
  const struct nb_tensor rate = tensor(0.2, -0.3, 0.7, -0.5);
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, "units none\nmaterial m density 1 kn 10\nstep 0.01\n");
  for (int k = 0; k < 12; k++) {
    const double x = 5 * (k % 4), y = 4 * (k / 4) + 0.3 * k;
    words_add(&page, "disc %.17g %.17g radius 0.3 m velocity %.17g %.17g\n", x, y, 3 + rate.xx * x + rate.xy * y,
              1 + rate.yx * x + rate.yy * y);
  }
  words_add(&page, "region A all\nregion B circle 6 6 radius 6 from b\nrecord A.strain.xx A.strain.xy A.strain.yx "
                   "A.strain.yy A.strain.volumetric A.strain.rotation A.strain.deviator B.strain.xx B.strain.yy\n"
                   "stage a\ncycles 20\nstage b\ncycles 10\n");
  struct nb_model *model = model_of(&it, &page);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  written_cycles(model, 20);
  CLOSE(model, "A.strain.xx", 0.2 * rate.xx);
  CLOSE(model, "A.strain.xy", 0.2 * (rate.xy + rate.yx) / 2);
  CLOSE(model, "A.strain.yx", 0.2 * (rate.xy + rate.yx) / 2);
  CLOSE(model, "A.strain.yy", 0.2 * rate.yy);
  CLOSE(model, "A.strain.volumetric", 0.2 * (rate.xx + rate.yy));
  CLOSE(model, "A.strain.rotation", 0.2 * (rate.yx - rate.xy) / 2);
  CLOSE(model, "A.strain.deviator", 0.2 * sqrt(0.7 * 0.7 + 0.4 * 0.4));
  CLOSE(model, "B.strain.xx", 0.2 * rate.xx); /* since the start, until stage b begins */
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[1], &error), NB_OK);
  CU_ASSERT(written_now(model, "B.strain.xx") == 0);
  written_cycles(model, 10);
  /* with the velocity gradient L, relative to the strained lengths: (1 + 0.3 L)(1 + 0.2 L)^-1 - 1 = 0.1 L (1 + 0.2 L)^-1 */
  const struct nb_tensor f = tensor(1 + 0.2 * rate.xx, 0.2 * rate.xy, 0.2 * rate.yx, 1 + 0.2 * rate.yy);
  const double det = f.xx * f.yy - f.xy * f.yx;
  CLOSE(model, "B.strain.xx", 0.1 * (rate.xx * f.yy - rate.xy * f.yx) / det);
  CLOSE(model, "B.strain.yy", 0.1 * (rate.yy * f.xx - rate.yx * f.xy) / det);
  CLOSE(model, "A.strain.xx", 0.3 * rate.xx);
  done(&it, model);
}

/* A falling disc is not in equilibrium: no contact balances its weight. Without gravity no force acts. */
static void imbalance_without_contacts(void) {
  for (int falls = 0; falls < 2; falls++) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1 kn 100\nstep 1e-3\ndisc 0 0 radius 1 m velocity 1 0\nregion A all\n%s"
              "record unbalanced.max A.unbalanced.mean\nstage s\ncycles 3\n",
              falls ? "gravity 0 -1\n" : "");
    struct nb_model *model = model_of(&it, &page);
    const double expected = falls ? INFINITY : 0;
    CU_ASSERT_EQUAL(written_now(model, "unbalanced.max"), expected);
    CU_ASSERT_EQUAL(written_now(model, "A.unbalanced.mean"), expected);
    done(&it, model);
  }
}

/* Measures of two scenes from a hand calculation: discs that lie on fixed discs, with linear springs, and spheres
 * with Hertz's law. */
static void loads(void) {
  struct words page = {0};
  struct written it;
  words_add(
      &page,
      "units none\nmaterial m density 1 kn 100\nstep 1e-6\ngravity 0 -0.5\n"
      "disc 0 0 radius 1 m fixed\ndisc 0 1.98 radius 1 m\ndisc 9 0 radius 1 m fixed\n"
      "disc 9 1.46 radius 0.5 m\ndisc 20 0 radius 1 m\nregion A all\nregion B circle 0 2 radius 1\n"
      "region F circle 0 0 radius 1\n"
      "record A.normal.mean A.normal.max A.normal.min A.normal.std A.unbalanced.mean B.unbalanced.mean "
      "F.unbalanced.mean F.normal.mean A.contact_stress.mean "
      "A.obliquity.max A.sliding A.sliding.near A.contacts B.contacts B.particles B.normal.mean\nstage s\ncycles 1\n");
  struct nb_model *model = model_of(&it, &page);
  CLOSE(model, "A.normal.mean", 3);
  CLOSE(model, "A.normal.max", 4);
  CLOSE(model, "A.normal.min", 2);
  CLOSE(model, "A.normal.std", 1);
  CLOSE(model, "A.unbalanced.mean", ((2 - pi / 2) + (4 - pi / 8) + pi / 2) / 3 / 3);
  CLOSE(model, "B.unbalanced.mean", (2 - pi / 2) / 2);
  CLOSE(model, "F.normal.mean", 2);
  CLOSE(model, "F.unbalanced.mean", 0); /* its only particle is fixed */
  CLOSE(model, "B.normal.mean", 2);
  CLOSE(model, "A.sliding.near", 0); /* without friction a contact has no limit, so it is not near its limit */
  CLOSE(model, "A.sliding", 0);
  CLOSE(model, "B.contacts", 1);
  done(&it, model);

  words_add(&page, "units none\nmaterial m density 1 young 1000 poisson 0.25\nnormal hertz\nstep 1e-6\n"
                   "sphere 0 0 radius 2 m fixed\nsphere 2.99 0 radius 1 m\nsphere 9 0 radius 2 m\n"
                   "wall w 7.02 -1 to 7.02 1 m\nregion A all\nrecord A.contact_stress.mean A.contact_stress.max "
                   "A.contact_stress.min A.contact_stress.std A.contact_ratio.max A.contact_ratio.min "
                   "A.contact_shear.max\nstage s\ncycles 1\n");
  model = model_of(&it, &page);
  /* N/(pi a^2) = 4 E* sqrt(alpha/R*)/(3 pi), a = sqrt(R* alpha), E* = E/(2 (1 - nu^2)) */
  const double E = 1000 / (2 * (1 - 0.0625)), one = 4 * E * sqrt(0.01 / (2. / 3)) / (3 * pi);
  const double two = 4 * E * sqrt(0.02 / 2) / (3 * pi);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.contact_stress.mean"), (one + two) / 2, 1e-12 * one);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.contact_stress.max"), fmax(one, two), 1e-12 * one);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.contact_stress.min"), fmin(one, two), 1e-12 * one);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.contact_stress.std"), fabs(one - two) / 2, 1e-12 * one);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.contact_ratio.max"), sqrt(2 * 0.02) / 2, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.contact_ratio.min"), sqrt(2. / 3 * 0.01), 1e-12);
  CLOSE(model, "A.contact_shear.max", 0);
  done(&it, model);

  /* the mean of three forces of 0.1 N is rounded to 0.1 (1 + 2^-52) N; the standard deviation is still 0, not NaN */
  words_add(&page, "units none\nmaterial m density 1 kn 0.4\nstep 1e-6\nlattice discs 4 by 1 radius 1 spacing 1.75 m\n"
                   "region A all\nrecord A.normal.mean A.normal.std\nstage s\ncycles 1\n");
  model = model_of(&it, &page);
  CU_ASSERT(written_now(model, "A.normal.mean") > 0.1);
  CU_ASSERT_EQUAL(written_now(model, "A.normal.std"), 0);
  done(&it, model);
}

/* A disc that slides along a wall in x, and a disc that does not slide at another wall. */
static void fabric_of_sliding_contacts(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page,
            "units none\nmaterial m density 1 kn 100 ks 80 friction 0.1\nshear linear\nstep 0.01\n"
            "disc 0 0.98 radius 1 m velocity 1 0\nwall s -5 0 to 20 0 m\ndisc 50.98 0 radius 1 m\n"
            "wall w 50 -5 to 50 5 m\nregion A all\nrecord A.fabric.xx A.fabric.sliding.xx A.fabric.sliding.yy "
            "A.fabric.sliding.fourth.yyyy A.sliding.near A.obliquity.mean A.obliquity.min A.obliquity.max\nstage s\n"
            "cycles 9\n");
  struct nb_model *model = model_of(&it, &page);
  CU_ASSERT(written_now(model, "A.fabric.sliding.yy") == 0); /* before any slip */
  CLOSE(model, "A.obliquity.max", 0);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  written_cycles(model, 5);
  CLOSE(model, "A.fabric.xx", 0.5);
  CLOSE(model, "A.sliding.near", 0.5);
  CLOSE(model, "A.obliquity.max", 1);
  CLOSE(model, "A.obliquity.min", 0);
  CLOSE(model, "A.obliquity.mean", 0.5); /* a contact with a limit and without shear force counts */
  CLOSE(model, "A.fabric.sliding.xx", 0);
  CLOSE(model, "A.fabric.sliding.yy", 1);
  CLOSE(model, "A.fabric.sliding.fourth.yyyy", 1);
  done(&it, model);
}

static void inside_a_boundary(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 1 kn 100\nstep 1e-6\ndisc 1 2 radius 2 m\ndisc 5 2 radius 2.5 m\n");
  for (int k = 0; k < 8; k++)
    words_add(&page, "disc %.17g %.17g radius 1 m\n", 1 + 10 * cos(pi * k / 4), 2 + 10 * sin(pi * k / 4));
  words_add(&page, "boundary circle 1 2 radius 10\nregion A inside 0.7 rings 2\nregion B circle 1 2 radius 7\n"
                   "record A.area B.area A.particles B.particles A.porosity B.porosity A.stress.xx B.stress.xx\n"
                   "stage s\ncycles 1\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  static const char *const names[][2] = {{"A.area", "B.area"},
                                         {"A.particles", "B.particles"},
                                         {"A.porosity", "B.porosity"},
                                         {"A.stress.xx", "B.stress.xx"}};
  for (size_t k = 0; k < 4; k++) {
    const double wanted = written_last(&result, names[k][1]);
    CU_ASSERT(wanted > 0);
    CU_ASSERT_DOUBLE_EQUAL(written_last(&result, names[k][0]), wanted, 1e-8 * wanted); /* the discs have moved */
  }
  nb_result_free(&result);
  written_free(&it);
}

/* If only one particle of a contact is inside a region, the contact counts with the arm of this particle. So the stress
 * by contacts equals the stress by particles, also for discs of different sizes. */
static void the_arm_of_the_particle_inside(void) {
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial m density 1 kn 100\nstep 0.001\ndisc 0 0 radius 1 m\n"
            "disc 1.1 0.9 radius 0.45 m\ndisc -0.2 -1.65 radius 0.7 m\nregion A circle 0 0 radius 0.3\n"
            "region B circle 1.1 0.9 radius 0.3\nregion C circle -0.2 -1.65 radius 0.3\n"
            "region D circle 0.6 0.5 radius 1.2\nrecord A.stress.xx A.stress.xy A.stress.yy A.stress.contacts.xx "
            "A.stress.contacts.xy A.stress.contacts.yy B.stress.xx B.stress.xy B.stress.yy "
            "B.stress.contacts.xx B.stress.contacts.xy B.stress.contacts.yy C.stress.xx C.stress.xy C.stress.yy "
            "C.stress.contacts.xx C.stress.contacts.xy C.stress.contacts.yy D.stress.xx D.stress.xy D.stress.yy "
            "D.stress.contacts.xx D.stress.contacts.xy D.stress.contacts.yy\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  for (const char *region = "ABCD"; *region; region++)
    for (int k = 0; k < 3; k++) {
      char particles[64], contacts[64];
      static const char *const parts[] = {"xx", "xy", "yy"};
      snprintf(particles, sizeof particles, "%c.stress.%s", *region, parts[k]);
      snprintf(contacts, sizeof contacts, "%c.stress.contacts.%s", *region, parts[k]);
      CU_ASSERT(fabs(written_now(model, particles)) > 0.01);
      CU_ASSERT_DOUBLE_EQUAL(written_now(model, contacts), written_now(model, particles), 1e-12);
    }
  nb_model_free(model);
  written_free(&it);
}

/* In tension, here by dashpots, sin Phi is negative: the deviator over twice the mean stress. */
static void tension(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 1\ndamping ratio 0.5\nstep 0.001\n"
                   "disc 0 0 radius 1 m velocity -3 0\ndisc 1.9 0.2 radius 1 m velocity 3 0\nregion A all\n"
                   "record A.stress.sinphi A.stress.mean A.stress.deviator\nstage s\ncycles 3\n");
  written_scene(&it, &page);
  struct nb_result result;
  written_run(&result, &it, NULL);
  const double mean = written_last(&result, "A.stress.mean");
  CU_ASSERT(mean < 0);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "A.stress.sinphi"),
                         written_last(&result, "A.stress.deviator") / (2 * mean), 1e-14);
  nb_result_free(&result);
  written_free(&it);
}

/* Discs at the places X move with the velocities L X. The strain and the rotation of the remaining discs follow from L t,
 * also after a disc inside the region has been removed, and then another one inside and one outside. */
static void strain_without_removed_particles(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  const double xx = 0.02, xy = 0.05, yx = -0.03, yy = -0.01;
  words_add(&page, "units none\nmaterial m density 1 kn 1\nstep 0.125\n");
  for (int k = 0; k < 6; k++) {
    const double x = 5 * (k % 3) + 0.3 * k * k, y = 7 * (k / 3) - 2 * k;
    words_add(&page, "disc %g %g radius 1 m velocity %.17g %.17g\n", x, y, xx * x + xy * y, yx * x + yy * y);
  }
  words_add(&page,
            "disc 90 0 radius 1 m velocity 0 1\nregion A circle 0 0 radius 50\nrecord time A.strain.xx A.strain.xy "
            "A.strain.yy A.strain.rotation A.porosity\nstage a\ncycles 8\nstage b\nremove disc 1\ncycles 8\n"
            "stage c\nremove discs 6 to 7\ncycles 8\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  for (size_t row = 0; row < result.table.row_count; row++) {
    const double t = written_cell(&result.table, row, "time");
    CU_ASSERT_DOUBLE_EQUAL(written_cell(&result.table, row, "A.strain.xx"), xx * t, 1e-13);
    CU_ASSERT_DOUBLE_EQUAL(written_cell(&result.table, row, "A.strain.xy"), (xy + yx) * t / 2, 1e-13);
    CU_ASSERT_DOUBLE_EQUAL(written_cell(&result.table, row, "A.strain.yy"), yy * t, 1e-13);
    CU_ASSERT_DOUBLE_EQUAL(written_cell(&result.table, row, "A.strain.rotation"), (yx - xy) * t / 2, 1e-13);
    const int discs = row < 9 ? 6 : row < 17 ? 5 : 4; /* inside; a removed disc covers no area */
    CU_ASSERT_DOUBLE_EQUAL(written_cell(&result.table, row, "A.porosity"), 1 - discs / 2500.0, 1e-13);
  }
  CU_ASSERT_EQUAL(result.table.row_count, 25);
  nb_result_free(&result);
  written_free(&it);
}

/* After a stage has removed all particles of a region, every quantity of the region is 0. Before, its stress, its moduli
 * and its fabric are above 0, although the area of the region is only 0.14. */
static void a_region_without_particles(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  struct nb_quantity_row row;
  words_add(&page,
            "units none\nmaterial m density 1 kn 10 ks 5 friction 0.5\nshear linear\nstep 0.001\nregion M all\n"
            "disc 0 0 radius 0.1 m velocity 0 0.01\ndisc 0.19 0 radius 0.1 m\ndisc 0.1 0.17 radius 0.1 m spin 1\n");
  for (size_t k = 0; nb_quantity_row(&row, k); k++)
    if (row.prefix && strcmp(row.prefix, "M.") == 0)
      words_add(&page, "record M.%s\n", row.name);
  words_add(&page, "stage a\ncycles 9\nstage b\nremove discs 1 to 3\ncycles 9\n");
  struct nb_model *model = model_of(&it, &page);
  written_cycles(model, 9);
  CU_ASSERT(it.scene.column_count > 50);
  CU_ASSERT(written_now(model, "M.stress.xx") > 0);
  CU_ASSERT(written_now(model, "M.modulus.bulk") > 0);
  CU_ASSERT(written_now(model, "M.fabric.xx") > 0);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[1], &error), NB_OK);
  for (int cycle = 0; cycle < 2; cycle++) {
    for (size_t c = 0; c < it.scene.column_count; c++) {
      const double value = nb_quantity_now(it.scene.columns[c].quantity, model);
      CU_ASSERT_EQUAL(value, 0);
      if (value != 0)
        printf("# %s is %g\n", it.scene.columns[c].name, value);
    }
    written_cycles(model, 1);
  }
  done(&it, model);
}

/* A disc between two walls. Each wall presses with F = k_n alpha on its face, at the distance R - alpha from the
 * centre. Both the stress by particles and the stress by contacts use this distance. */
static void the_arm_at_a_wall_ends_at_its_face(void) {
  static const char *const quantities[] = {"A.stress.xx", "B.stress.xx"};
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 100\ndisc 0 0 radius 1 m\nwall w -0.8 -3 to -0.8 3 m\n"
                   "wall e 0.8 -3 to 0.8 3 m\nregion A circle 0 0 radius 2\nregion B box -1 -1 to 1 1\nstep 1e-3\n"
                   "record A.stress.xx B.stress.xx\nstage s\ncycles 1\n");
  struct nb_model *model = model_of(&it, &page);
  for (int k = 0; k < 2; k++)
    NEAR(fabs(written_now(model, quantities[k])), 2 * 20 * 0.8 / (k ? 4 : 4 * pi), 1e-12);
  done(&it, model);
}

/* A circle and a fraction of the boundary may have rings. Without `rings` the number is 0. */
static void regions_with_rings(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 100\ndisc 0 0 radius 1 m\nboundary circle 0 0 radius 5\n"
                   "region A circle 0 0 radius 3 rings 7\nregion B inside 0.5 rings 4\nregion C inside 0.5\n"
                   "step 1e-3\nrecord time\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  static const int rings[] = {7, 4, 0};
  for (size_t k = 0; k < 3; k++)
    CU_ASSERT_EQUAL(it.scene.regions[k].rings, rings[k]);
  written_free(&it);
}

/* A contact that slides, one with friction but without a shear force, and one without friction, which has no limit. The
 * sliding fractions count all three contacts. The mean obliquity counts the two that have a limit. */
static void sliding_fractions_are_of_all_contacts(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 100 ks 100 friction 0.1\nmaterial s density 1 kn 100\n"
                   "shear linear\nstep 0.001\nregion A all\ndisc 0 0 radius 1 m fixed\n"
                   "disc 1.9 0 radius 1 m velocity 0 1\ndisc 10 0 radius 1 m\ndisc 11.9 0 radius 1 m\n"
                   "disc 20 0 radius 1 s\ndisc 21.9 0 radius 1 s\nrecord A.sliding A.sliding.near A.obliquity.mean "
                   "A.contacts\nstage s\ncycles 50\n");
  struct nb_model *model = model_of(&it, &page);
  written_cycles(model, 50);
  CLOSE(model, "A.contacts", 3);
  CLOSE(model, "A.sliding", 1. / 3);
  CLOSE(model, "A.sliding.near", 1. / 3);
  CLOSE(model, "A.obliquity.mean", 0.5);
  done(&it, model);
}

/* With cohesion the limit of the shear force is mu F_n + c = 0.1 10 + 3. In a step of 0.004 at the speed 1 the shear force
 * becomes 0.4; the discs are so heavy that nothing else moves. */
static void obliquity_with_cohesion(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page,
            "units none\nmaterial m density 2e15 kn 100 ks 100 friction 0.1 cohesion 3\nshear linear\nstep 0.004\n"
            "region A all\nwall w 5 -9 to 5 9 m\nmonitor W wall w\ndisc 0 0 radius 1 m fixed\n"
            "disc 1.9 0 radius 1 m velocity 0 1\ndisc 4.1 0 radius 1 m velocity 0 1\n"
            "record A.obliquity.min A.obliquity.max W.obliquity\nstage s\ncycles 1\nsnapshot\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "A.obliquity.min"), 0.1, 1e-5); /* the contact normal rotates by 0.002 */
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "A.obliquity.max"), 0.1, 1e-5);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "W.obliquity"), 0.1, 1e-5);
  for (size_t k = 0; k < 2; k++)
    CU_ASSERT_DOUBLE_EQUAL(written_cell(&result.snapshots[0].contacts, k, "limit"), 4, 1e-4);
  nb_result_free(&result);
  written_free(&it);
}

/* Contacts in one direction alone have the anisotropy a = 2. The density 1 + a cos 2 theta of their directions would be
 * negative for some angles, so the anisotropies a_n and a_t of the forces are undefined. In a square lattice a = 0, and
 * without contacts all three are 0. */
static void directions_without_a_density(void) {
  static const struct {
    const char *lattice;
    double a, normal; /* A.anisotropy.contacts; each of the `others`, NAN: undefined */
  } rows[] = {{"2 by 1 m radius 1 spacing 1.9", 2, NAN},
              {"3 by 1 m radius 1 spacing 1.9", 2, NAN},
              {"2 by 2 m radius 1 spacing 1.9", 0, 0},
              {"2 by 2 m radius 1 spacing 2.1", 0, 0}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    static const char *const others[] = {"A.anisotropy.normal", "A.anisotropy.shear", "A.anisotropy.sinphi"};
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1 kn 100 ks 100 friction 1\nshear linear\nstep 0.001\nregion A all\n"
              "lattice discs %s\nrecord A.anisotropy.contacts A.anisotropy.normal A.anisotropy.shear "
              "A.anisotropy.sinphi\nstage s\ncycles 1\n",
              rows[k].lattice);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.anisotropy.contacts"), rows[k].a, 1e-15);
    for (size_t n = 0; n < 3; n++) {
      const double now = written_now(model, others[n]);
      CU_ASSERT(isnan(rows[k].normal) ? isnan(now) : fabs(now) < 1e-15);
    }
    nb_model_free(model);
    written_free(&it);
  }
}

/* The strain needs three particles that are not collinear. Otherwise it is 0, also on a line that is inclined. The
 * discs have the velocities L X. */
static void strain_of_few_particles(void) {
  static const struct {
    int count;
    double x[4], y[4];
    bool defined;
  } rows[] = {{1, {7}, {3}, false},
              {2, {0, 9}, {0, 0}, false},
              {2, {0, 9}, {0, 7}, false},
              {3, {0, 9, 30}, {0, 7, 70 / 3.}, false},
              {4, {0, -9, 18, 30}, {1, -6, 15, 73 / 3.}, false},
              {3, {0, 9, 30}, {0, 7, 25}, true},
              {3, {0, 9, 0}, {0, 0, 9}, true}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    const struct nb_tensor rate = tensor(0.2, -0.3, 0.7, -0.5);
    struct words page = {0};
    struct written it;
    words_add(&page, "units none\nmaterial m density 1 kn 1\nstep 0.01\n");
    for (int n = 0; n < rows[k].count; n++) {
      const struct nb_vec v = tensor_times(rate, vec(rows[k].x[n], rows[k].y[n]));
      words_add(&page, "disc %.17g %.17g radius 0.3 m velocity %.17g %.17g\n", rows[k].x[n], rows[k].y[n], v.x, v.y);
    }
    words_add(&page, "region A all\nrecord A.strain.xx A.strain.xy A.strain.yy A.strain.rotation\nstage a\ncycles 9\n");
    struct nb_model *model = model_of(&it, &page);
    written_cycles(model, 20);
    const double t = rows[k].defined ? 0.2 : 0;
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.strain.xx"), rate.xx * t, t * 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.strain.xy"), (rate.xy + rate.yx) / 2 * t, t * 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.strain.yy"), rate.yy * t, t * 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.strain.rotation"), (rate.yx - rate.xy) / 2 * t, t * 1e-12);
    done(&it, model);
  }
}

/* A circle without particles, and a circle with one disc that has no contact. Every mean, sum and fraction without
 * terms is 0; the porosity and the void ratio follow from the areas. A region `inside` is empty, and has no area, until
 * the boundary exists. */
static void regions_without_contacts(void) {
  static const struct {
    const char *name;
    double empty, lone;
  } others[] = {{"area", 4 * 3.14159265358979323846, 4 * 3.14159265358979323846},
                {"porosity", 1, 0.75},
                {"porosity.volume", 1, 0.75},
                {"void_ratio", INFINITY, 3},
                {"particles", 0, 1},
                {"rattlers", 0, 1}};
  struct words page = {0};
  struct written it;
  struct nb_quantity_row row;
  words_add(&page, "units none\nmaterial m density 1 kn 10 ks 5 friction 0.5\nshear linear\nstep 0.001\n"
                   "disc 0 0 radius 1 m fixed\ndisc 1.9 0 radius 1 m\ndisc 20 0 radius 1 m\n"
                   "region E circle 50 0 radius 2\n"
                   "region L circle 20 0 radius 2\nregion I inside 0.5\n");
  for (size_t k = 0; nb_quantity_row(&row, k); k++)
    if (row.prefix && strcmp(row.prefix, "M.") == 0)
      words_add(&page, "record E.%s L.%s I.%s\n", row.name, row.name, row.name);
  words_add(&page, "stage a\ncycles 9\nstage b\nboundary circle 0 0 radius 99\ncycles 1\n");
  struct nb_model *model = model_of(&it, &page);
  CU_ASSERT(it.scene.column_count > 200);
  written_cycles(model, 9);
  for (size_t c = 0; c < it.scene.column_count; c++) {
    const char *name = it.scene.columns[c].name;
    const double value = nb_quantity_now(it.scene.columns[c].quantity, model);
    double wanted = 0;
    for (size_t k = 0; k < sizeof others / sizeof *others; k++)
      wanted = strcmp(name + 2, others[k].name) ? wanted
               : *name == 'E'                   ? others[k].empty
               : *name == 'L'                   ? others[k].lone
                                                : 0;
    const bool right = value == wanted || fabs(value - wanted) < 1e-14;
    CU_ASSERT(right);
    if (!right)
      printf("# %s is %g, not %g\n", name, value, wanted);
  }
  done(&it, model);
}

/* The loads of a contact follow from its fields. Friction is 0.5 and cohesion 3, so with F_n = 10 the limit of the
 * shear force is 8. A shear force of at least 0.99 of the limit is near it. The contact is of two discs in both
 * orders of their radii, and of a disc and a wall. The radius of the smaller one is 1. */
static void loads_of_a_contact(void) {
  static const struct {
    double shear, near_sliding;
  } rows[] = {{0, 0}, {-4, 0}, {8 * 0.9895, 0}, {8 * 0.99, 1}, {-8 * 0.99, 1}, {8 * 0.9905, 1}, {-8, 1}};
  static const char *const pairs[] = {"disc 0 0 radius 2 m\ndisc 2.9 0 radius 1 m\n",
                                      "disc 0 0 radius 1 m\ndisc 2.9 0 radius 2 m\n",
                                      "disc 0 0 radius 1 m\nwall w 0.9 -9 to 0.9 9 m\ndisc 50 0 radius 0.5 m\n"};
  for (size_t k = 0; k < 3; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1 kn 10 ks 5 friction 0.5 cohesion 3\nshear linear\nstep 0.001\n%s"
              "region A all\nrecord A.contact_stress.mean\nstage a\ncycles 9\n",
              pairs[k]);
    struct nb_model *model = model_of(&it, &page);
    CU_ASSERT_EQUAL_FATAL(model->contacts.count, 1);
    double **kept = model->contacts.kept;
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
      const double shear = rows[n].shear, area = pi * 0.25, sliding = (double)(n % 2);
      kept[NB_NORMAL][0] = 10, kept[NB_SHEAR][0] = shear, kept[NB_SLIDING][0] = sliding, kept[NB_RADIUS][0] = 0.5;
      const struct nb_contact_load load = nb_contact_load(model, 0);
      CU_ASSERT_EQUAL(load.normal, 10);
      CU_ASSERT_EQUAL(load.shear, fabs(shear));
      CU_ASSERT_EQUAL(load.sliding, sliding);
      CU_ASSERT_EQUAL(load.limit, 8);
      CU_ASSERT_EQUAL(load.near_sliding, rows[n].near_sliding);
      CU_ASSERT_EQUAL(load.obliquity, fabs(shear) / 8);
      CU_ASSERT_EQUAL(load.radius, 0.5);
      CU_ASSERT_EQUAL(load.ratio, 0.5);
      NEAR(load.pressure, 10 / area, 1e-14);
      CU_ASSERT_DOUBLE_EQUAL(load.traction, fabs(shear) / area, 1e-13);
    }
    done(&it, model);
  }
}

/* `stress.residual` finds a force that belongs to one of the two sums alone. The contact of two discs of radius 1
 * along x with the overlap 0.1 has arms of 0.95. A normal force that is larger by 1 at both ends adds 2 0.95 to V
 * stress.xx, while the stress by contacts follows from the vector of the force, which is unchanged. */
static void the_residual_finds_a_wrong_force(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 10\nstep 0.001\ndisc 0 0 radius 1 m\ndisc 1.9 0 radius 1 m\n"
                   "region A circle 0 0 radius 5\nrecord A.stress.residual A.stress.xx\nstage a\ncycles 1\n");
  struct nb_model *model = model_of(&it, &page);
  model->contacts.kept[NB_NORMAL][0] += 1;
  NEAR(written_now(model, "A.stress.residual"), 2 * 0.95 / (25 * pi), 1e-12);
  done(&it, model);
}

/* The standard deviation of forces that are nearly equal has no cancellation: 1e9 - 1, 1e9 and 1e9 + 1. */
static void a_small_deviation_of_large_forces(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 10\nstep 0.001\nlattice discs 4 by 1 m radius 1 spacing 1.9\n"
                   "region A all\nrecord A.normal.mean A.normal.std\nstage a\ncycles 1\n");
  struct nb_model *model = model_of(&it, &page);
  CU_ASSERT_EQUAL_FATAL(model->contacts.count, 3);
  for (int c = 0; c < 3; c++)
    model->contacts.kept[NB_NORMAL][c] = 1e9 - 1 + c;
  CLOSE(model, "A.normal.mean", 1e9);
  CLOSE(model, "A.normal.std", sqrt(2. / 3));
  done(&it, model);
}

/* `inside F` is a fraction of the mean distance of the boundary's particles from its centre. Here the mean is 5.5 and
 * the radius of the circle 5, so the disc at the distance 2.6 is inside half of the mean, 2.75. A fixed disc is not part
 * of the boundary. The region exists as long as the boundary does, held or under a stress. */
static void inside_a_fraction_of_the_mean_radius(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, "units none\nmaterial m density 1 kn 10\nstep 0.001\ndisc 6 0 radius 0.5 m\ndisc 0 5 radius 0.5 m\n"
                   "disc -6 0 radius 0.5 m\ndisc 0 -5 radius 0.5 m\ndisc 2.6 0 radius 0.5 m\ndisc -2.8 0 radius 0.5 m\n"
                   "disc 9 0 radius 0.5 m fixed\n"
                   "boundary circle 0 0 radius 5\nregion A inside 0.5\nrecord A.particles A.area\nstage a\ncycles 1\n"
                   "stage b\nboundary stress 1 1\ncycles 1\nstage c\nboundary none\ncycles 1\n");
  struct nb_model *model = model_of(&it, &page);
  for (int stage = 0; stage < 3; stage++) {
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[stage], &error), NB_OK);
    CLOSE(model, "A.particles", stage < 2);
    CLOSE(model, "A.area", stage < 2 ? pi * 2.75 * 2.75 : 0);
  }
  done(&it, model);
}

/* The area of `all` is that of the periodic cell now, not at the start: the cell of 10 by 10 grows by a quarter along x. */
static void the_area_of_a_strained_cell(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 1 kn 1\nstep 0.5\nperiodic cell 0 0 to 10 10\n"
                   "disc 5 5 radius 1 m\nregion A all\nrecord A.area A.porosity\n"
                   "stage s\ncell strain 0.5 0\ncycles 1\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  NEAR(written_last(&result, "A.area"), 125.0, 1e-14);
  NEAR(written_last(&result, "A.porosity"), 1 - pi / 125, 1e-14);
  nb_result_free(&result);
  written_free(&it);
}

/* `fabric.normal` has the elastic forces as weights, without dashpots: here two equal ones, 10 0.1. With its dashpot the
 * first contact has the force 7. */
static void the_fabric_without_dashpots(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 10\ndamping stiffness 0.01\nstep 0.001\ndisc 0 0 radius 1 m\n"
                   "disc 1.9 0 radius 1 m\ndisc 0 1.9 radius 1 m\nregion A all\n"
                   "record A.fabric.normal.xx A.stress.xx A.stress.yy\nstage a\ncycles 1\n");
  struct nb_model *model = model_of(&it, &page);
  model->contacts.kept[NB_TOTAL_NORMAL][0] = 7;
  CLOSE(model, "A.fabric.normal.xx", 0.5);
  NEAR(written_now(model, "A.stress.xx"), 7 * written_now(model, "A.stress.yy"), 1e-12);
  done(&it, model);
}

void suite_region(void) {
  CU_pSuite suite = CU_add_suite("region", NULL, NULL);
  CU_add_test(suite, "sliding fractions are of all contacts", sliding_fractions_are_of_all_contacts);
  CU_add_test(suite, "the obliquity with cohesion", obliquity_with_cohesion);
  CU_add_test(suite, "anisotropy with a negative density, and without contacts", directions_without_a_density);
  CU_add_test(suite, "centres on the edge are inside", centres_on_the_edge);
  CU_add_test(suite, "fractions of the stress, which is not recorded", fractions_without_the_stress);
  CU_add_test(suite, "the arm of the particle inside", the_arm_of_the_particle_inside);
  CU_add_test(suite, "strain without removed particles", strain_without_removed_particles);
  CU_add_test(suite, "a region without particles", a_region_without_particles);
  CU_ADD_TEST(suite, strain_of_few_particles);
  CU_ADD_TEST(suite, regions_without_contacts);
  CU_ADD_TEST(suite, loads_of_a_contact);
  CU_ADD_TEST(suite, the_residual_finds_a_wrong_force);
  CU_ADD_TEST(suite, a_small_deviation_of_large_forces);
  CU_ADD_TEST(suite, inside_a_fraction_of_the_mean_radius);
  CU_ADD_TEST(suite, the_area_of_a_strained_cell);
  CU_ADD_TEST(suite, the_fabric_without_dashpots);
  CU_add_test(suite, "sin Phi in tension", tension);
  CU_add_test(suite, "contacts at equal angles: fabric of second and fourth order, stress", contacts_at_equal_angles);
  CU_add_test(suite, "rattlers, and coordination with and without them", rattlers);
  CU_add_test(suite, "porosity, thickness and areas", volumes);
  CU_add_test(suite, "a rotated box", a_rotated_box);
  CU_add_test(suite, "strain is the velocity gradient times the time", strain);
  CU_add_test(suite, "contact forces of springs and of Hertz, unbalanced force", loads);
  CU_add_test(suite, "unbalanced force without contacts", imbalance_without_contacts);
  CU_add_test(suite, "fabric of sliding contacts", fabric_of_sliding_contacts);
  CU_add_test(suite, "inside a fraction of the boundary", inside_a_boundary);
  CU_add_test(suite, "the regions that may have rings", regions_with_rings);
  CU_add_test(suite, "the arm at a wall ends at its face", the_arm_at_a_wall_ends_at_its_face);
}
