/* The guaranteed stable step, which must never exceed the true limit of the cycle: lattices with closed forms, and
 * many random networks with every kind of damping.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/measure/step.h"
#include "chance.h"
#include "limit.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

/* The steps of one scene by the program and by the references. */
struct steps {
  double safe, critical; /* of the program: guaranteed stable step, single-contact step */
  double parts, modes;   /* of the references: bound from the contacts, limit of the modes */
  double cycle;          /* limit from the eigenvalues of the cycle; 0: not computed */
};

/* Adds the last statements to the page, and finds the steps of its scene. `cycle`: also the limit of the cycle. */
static struct steps find_steps(struct words *page, bool cycle) {
  struct written it;
  struct limit limit;
  struct nb_error error;
  words_add(page, "step 1\nallow unstable\nrecord step.stable step.single-contact\nstage s\ncycles 1\n");
  written_scene(&it, page);
  struct nb_model *model = written_model(&it, NULL);
  struct steps answer = {.safe = written_now(model, "step.stable"),
                         .critical = written_now(model, "step.single-contact")};
  CU_ASSERT_EQUAL_FATAL(limit_build(&limit, &it.scene, &it.scene.damping, model->search.skin, &error), NB_OK);
  CU_ASSERT_EQUAL(limit.lattice.contact_count, model->contacts.count);
  answer.parts = limit_of_contacts(&limit, &it.scene), answer.modes = limit_of_modes(&limit);
  if (cycle)
    answer.cycle = limit_of_cycle(&limit);
  NEAR(answer.critical, limit.single_contact, 1e-14);
  limit_free(&limit);
  nb_model_free(model);
  written_free(&it);
  return answer;
}

/* Tests relations between the steps that hold for each scene. */
static void in_order(const struct steps *it) {
  NEAR(it->safe, it->parts, 1e-11);
  CU_ASSERT(it->safe <= it->modes * (1 + 1e-12));
  if (it->cycle > 0)
    NEAR(it->cycle, it->modes, 3e-6); /* limit_of_cycle counts |z| > 1 + 1e-6 as growth */
}

static void lattices_equal_closed_forms(void) {
  static const struct {
    const char *name, *statements;
    double safe, limit; /* over the single-contact step */
  } cases[] = {
      {"a free pair, without shear", "lattice discs 2 by 1 radius 1 smooth\n", 0.7071067811865476, 0.7071067811865476},
      {"a free pair", "lattice discs 2 by 1 radius 1 rough\n", 0.40824829046386301, 0.40824829046386301},
      {"a disc between two walls",
       "lattice discs 1 by 1 radius 1 smooth\nwall w 0 -1 to 0 3 smooth\nwall e 2 -1 to 2 3 smooth\n",
       0.7071067811865476, 0.7071067811865476},
      {"nine discs", "box 0 0 to 6 6 rough\nlattice discs 3 by 3 radius 1 rough\n", 0.20412414523193151,
       0.26709262251211030},
      {"nine discs, without shear", "box 0 0 to 6 6 smooth\nlattice discs 3 by 3 radius 1 smooth\n",
       0.35355339059327379, 0.54119610014619698}, /* rows of three: omega^2 = (2 + sqrt 2) k/m */
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    struct words page = {0};
    words_add(&page,
              "units none\nshear linear\nmaterial rough density 3 kn 100 ks 100 friction 1\n"
              "material smooth density 3 kn 100 ks 100\n%s",
              cases[k].statements);
    const struct steps it = find_steps(&page, true);
    in_order(&it);
    NEAR(it.safe / it.critical, cases[k].safe, 1e-13);
    NEAR(it.modes / it.critical, cases[k].limit, 1e-12);
  }
}

/* The largest fractions by which the guaranteed stable step is below the true limit: the two numbers in the text of
 * cases/5-numerics/step-limit.md, to their printed digits. */
static void margins_stated_in_step_limit(void) {
  static const int rows[4][4] = {{5, 1, 10, 2}, {2, 2, 4, 4}, {3, 3, 6, 6}, {4, 4, 8, 8}};
  double free = 0, damped = 0;
  for (size_t k = 0; k < 4; k++)
    for (int ratio = 0; ratio < 2; ratio++) {
      struct words page = {0};
      words_add(&page,
                "units none\nshear linear\nmaterial m density 1 kn 1 ks 1 friction 1\nbox 0 0 to %d %d m\n"
                "lattice discs %d by %d radius 1 m\ndamping ratio %d\n",
                rows[k][2], rows[k][3], rows[k][0], rows[k][1], 2 * ratio);
      const struct steps it = find_steps(&page, false);
      double *most = ratio ? &damped : &free;
      *most = fmax(*most, 1 - it.safe / it.modes);
    }
  CU_ASSERT_DOUBLE_EQUAL(free, 0.30, 0.005);
  CU_ASSERT_DOUBLE_EQUAL(damped, 0.56, 0.005);
}

/* Nine discs that cannot rotate: omega^2 = 2 (2 + sqrt 2) k/m, of which rows and columns contribute half each. With
 * rotation omega^2 is 2.05 times as large. */
static void rotation_lowers_the_limit(void) {
  struct words page = {0};
  struct written it;
  struct limit limit;
  struct nb_error error;
  words_add(&page, "units none\nshear linear\nmaterial rough density 3 kn 100 ks 100 friction 1\nbox 0 0 to 6 6 rough\n"
                   "lattice discs 3 by 3 radius 1 rough\nstep 0.1 of stable\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  CU_ASSERT_EQUAL_FATAL(limit_build(&limit, &it.scene, &it.scene.damping, 1e-9, &error), NB_OK);
  NEAR(limit_of_modes(&limit) / limit.single_contact, 0.267092622512110, 1e-13);
  for (size_t spin = 2; spin < 27; spin += 3) {
    gsl_vector_view column = gsl_matrix_column(limit.lattice.stretch, spin);
    gsl_vector_set_zero(&column.vector);
  }
  NEAR(limit_of_modes(&limit) / limit.single_contact, 1 / sqrt(2 * (2 + sqrt(2))), 1e-13);
  NEAR(limit_of_cycle(&limit) / limit.single_contact, 1 / sqrt(2 * (2 + sqrt(2))), 3e-6);
  limit_free(&limit);
  written_free(&it);
}

/* The limit of a pair with dashpots of the coefficient beta k is (2/omega)(sqrt(1 + xi^2) - xi), with xi = beta omega/2
 * and omega^2 = 2 k/m [CS79 28]. */
static void damping_has_its_formula(void) {
  for (double xi = 0; xi < 2.3; xi += 0.25) {
    struct words page = {0};
    const double mass = 3.14159265358979323846 * 3, omega = sqrt(2 * 100 / mass);
    words_add(&page,
              "units none\nmaterial m density 3 kn 100\nlattice discs 2 by 1 radius 1 m\ndamping stiffness %.17g\n",
              2 * xi / omega);
    const struct steps it = find_steps(&page, true);
    in_order(&it);
    NEAR(it.safe, 2 / omega * (sqrt(1 + xi * xi) - xi), 1e-12);
    NEAR(it.modes, it.safe, 1e-12); /* for a pair the bound is the limit */
  }
}

/* A row of three discs between two walls. A dashpot of the coefficient beta k acts like an additional spring 2 beta k/dt,
 * so at the limit the row with the springs a between discs and b at the walls, a = k dt^2 + 2 beta k dt and b likewise,
 * has the eigenvalue 4 m. It belongs to the symmetric mode in which the outer discs move against the middle one. The
 * dashpots are at the walls, at the other contacts, or differ. */
static void walls_have_their_own_damping(void) {
  static const double betas[][2] = {{0, 0.5}, {0.5, 0}, {0.1, 0.4}};
  for (size_t k = 0; k < sizeof betas / sizeof *betas; k++) {
    struct words page = {0};
    words_add(&page,
              "units none\nmaterial m density 3 kn 100\nbox 0 0 to 6 4 m\nlattice discs 3 by 1 from 1 2 radius 1 "
              "spacing 2 m\nskin 0.1\ndamping stiffness %g\ndamping walls stiffness %g\n",
              betas[k][0], betas[k][1]);
    const struct steps it = find_steps(&page, true);
    in_order(&it);
    const double mass = 3.14159265358979323846 * 3, dt = it.modes;
    const double a = 100 * dt * (dt + 2 * betas[k][0]), b = 100 * dt * (dt + 2 * betas[k][1]);
    NEAR((b + 3 * a + sqrt((a - b) * (a - b) + 8 * a * a)) / 2, 4 * mass, 1e-11);
  }
}

/* ---- random networks ---- */

/* Particles of different size, density and shape near the sites of a distorted lattice: some overlap, some are within
 * the skin, and some are apart. Some particles are fixed. There are four materials of different stiffness, and walls on
 * two sides or no walls. */
static void network(struct words *page, struct chance *chance, size_t nx, size_t ny) {
  words_add(page, "units none\nshear linear\nskin 0.2\n");
  for (int m = 0; m < 4; m++) {
    const double kn = chance_scale(chance, 10, 1e4);
    words_add(page, "material m%d density %g kn %g ks %g friction %d\n", m, chance_scale(chance, 0.3, 30), kn,
              kn * chance_scale(chance, 0.05, 3), m != 3);
  }
  for (size_t y = 0; y < ny; y++)
    for (size_t x = 0; x < nx; x++) {
      const double stray = 0.1, high = (double)y + (x % 2 ? 0.5 : 0);
      words_add(page, "%s %.17g %.17g radius %.17g m%d%s\n", chance_between(chance, 0, 1) < 0.5 ? "disc" : "sphere",
                0.9 * (double)x + chance_between(chance, -stray, stray), high + chance_between(chance, -stray, stray),
                chance_between(chance, 0.35, 0.6), (int)chance_between(chance, 0, 4),
                chance_between(chance, 0, 1) < 0.1 && x + y > 0 ? " fixed" : "");
    }
  if (chance_between(chance, 0, 1) < 0.7)
    words_add(page, "wall south -1 -0.5 to 9 -0.5 m1\nwall west -0.5 -1 to -0.5 9 m2\n");
}

/* Adds random damping: contact damping up to twice the critical one, or a time of `damping stiffness` up to 2, mostly
 * between a fraction of 1/omega of the stiffest contact and a hundred times 1/omega; or mass-proportional damping. */
static void damping(struct words *page, struct chance *chance) {
  const double size = chance_between(chance, 0, 2);
  switch ((int)chance_between(chance, 0, 4)) {
  case 1:
    words_add(page, "damping stiffness %.17g\n", size * chance_scale(chance, 0.01, 1));
    break;
  case 2:
    words_add(page, "damping r89-fraction %.17g\n", size);
    break;
  case 3:
    words_add(page, "damping ratio %.17g\n", size);
    break;
  default:
    break;
  }
  static const char *const readings[] = {"cs79", "velocity", "all"};
  const int which = (int)chance_between(chance, 0, 5);
  if (which < 3)
    words_add(page, "damping con1 %.17g as %s\n", chance_between(chance, 0.05, 1), readings[which]);
  else if (which == 3)
    words_add(page, "damping mass %.17g\n", chance_scale(chance, 0.01, 10));
}

/* Tests `seeds` random networks of nx by ny particles. The guaranteed stable step must exceed `least` times the limit
 * in each of them. `cycle`: also compares the limit of the modes with that of the cycle. */
static void random_networks(unsigned seeds, size_t nx, size_t ny, bool cycle, double least) {
  double sum = 0, lowest = 1;
  for (unsigned seed = 1; seed <= seeds; seed++) {
    struct chance chance = chance_begin(seed);
    struct words page = {0};
    network(&page, &chance, nx, ny);
    damping(&page, &chance);
    const struct steps it = find_steps(&page, cycle);
    in_order(&it);
    const double fraction = it.safe / it.modes;
    sum += fraction;
    lowest = fraction < lowest ? fraction : lowest;
  }
  printf("# %zu by %zu: stable step over limit is %.3f in the mean of %u, %.3f at least\n", nx, ny, sum / seeds, seeds,
         lowest);
  CU_ASSERT(lowest > least); /* the bound is not much too small */
}

static void random_networks_stay_below_the_limit(void) {
  random_networks(40, 3, 2, true, 0.3);
  random_networks(60, 5, 5, false, 0.3);
}

/* The result of a run has the largest step over the stable one. */
static void largest_ratio_is_kept(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 1 kn 100\ndisc 0 0.99 radius 1 m\nwall w -9 0 to 9 0 m\n"
                   "step 0.5 of stable\nrecord time\nstage s\ncycles 3\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_DOUBLE_EQUAL(result.stability, 0.5, 1e-12);
  nb_result_free(&result);
  written_free(&it);
}

static void storage_changes_no_bit(void) {
  struct chance chance = chance_begin(7);
  struct words page = {0};
  struct written it;
  network(&page, &chance, 6, 6);
  words_add(&page, "damping ratio 0.3\nstep 1 of stable\nrecord step\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL), *other = written_model(&it, &(struct nb_options){.shuffle = true});
  CU_ASSERT(written_now(model, "step") == written_now(other, "step"));
  nb_model_free(model), nb_model_free(other);
  written_free(&it);
}

/* The program keeps the coefficients of contacts during a computation of the stable step. If there are too many
 * contacts, or no memory, it computes the coefficients at each use instead. Both give the same bits. */
static void kept_coefficients_are_those_computed(void) {
  struct chance chance = chance_begin(11);
  struct words page = {0};
  struct written it;
  network(&page, &chance, 6, 6);
  words_add(&page, "damping ratio 0.3\nstep 1 of stable\nrecord step\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  struct nb_element kept[1000];
  const size_t n = model->contacts.count;
  CU_ASSERT_FATAL(n > 30 && n < sizeof kept / sizeof *kept);
  nb_stable_step_begin(model);
  CU_ASSERT_PTR_NOT_NULL(model->stability->coefficients);
  for (size_t c = 0; c < n; c++)
    kept[c] = nb_element_of(model, c);
  nb_stable_step_end(model);
  CU_ASSERT_PTR_NULL(model->stability->coefficients);
  for (size_t c = 0; c < n; c++) {
    const struct nb_element computed = nb_element_of(model, c);
    CU_ASSERT_EQUAL(computed.own.kn, kept[c].own.kn);
    CU_ASSERT_EQUAL(computed.own.ks, kept[c].own.ks);
    CU_ASSERT_EQUAL(computed.own.cn, kept[c].own.cn);
    CU_ASSERT_EQUAL(computed.own.cs, kept[c].own.cs);
  }
  nb_model_free(model);
  written_free(&it);
}

/* A law that may unload forty times as stiffly as it loads. */
static struct nb_normal yields(struct nb_pair p, double overlap, double dn, double m[]) {
  (void)dn, (void)m;
  return (struct nb_normal){.force = p.kn * overlap, .stiffness = p.kn, .max_stiffness = 40 * p.kn};
}

/* The largest stiffness of a law counts, for discs that touch, that are within the skin and that are far apart. */
static void stiffer_unloading_counts(void) {
  static const double places[] = {0.99, 1.001, 50};
  const struct nb_law law = {.kind = "normal", .name = "yields", .normal = yields};
  for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1 kn 100\nnormal linear\ndisc 0 %g radius 1 m\nwall w -9 0 to 9 0 "
              "m\nstep 1e-9\n",
              places[k]);
    words_add(&page, "record time\nstage s\ncycles 1\n");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    const double before = nb_stable_step(model).step;
    model->next_laws.normal = &law;
    CU_ASSERT_DOUBLE_EQUAL(nb_stable_step(model).step, before / sqrt(40), 1e-12 * before);
    nb_model_free(model);
    written_free(&it);
  }
}

/* A law that stiffens with the overlap: F = k (alpha + alpha^2). */
static struct nb_normal stiffens(struct nb_pair p, double overlap, double dn, double m[]) {
  (void)dn, (void)m;
  return (struct nb_normal){.force = p.kn * (overlap + overlap * overlap), .stiffness = p.kn * (1 + 2 * overlap)};
}

/* A disc and a wall that do not touch, within the skin or far apart, count with the stiffness that the law has at first
 * touch, here k. At an overlap of 0.01 the stiffness is 1.02 k. */
static void discs_apart_count_as_they_touch(void) {
  static const struct { double place, factor; } rows[] = {{0.99, 1.02}, {1.001, 1}, {50, 1}};
  const struct nb_law law = {.kind = "normal", .name = "stiffens", .normal = stiffens};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1 kn 100\nnormal linear\ndisc 0 %g radius 1 m\nwall w -9 0 to 9 0 "
              "m\nstep 1e-9\nrecord time\nstage s\ncycles 1\n",
              rows[k].place);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    const double before = nb_stable_step(model).step;
    model->next_laws.normal = &law;
    CU_ASSERT_DOUBLE_EQUAL(nb_stable_step(model).step, before / sqrt(rows[k].factor), 1e-12 * before);
    nb_model_free(model);
    written_free(&it);
  }
}

/* With Hertz's law in increments the stiffness follows from the force that the contact keeps, not from the overlap:
 * k = (6 F E*^2 R*)^(1/3). After ten steps of an impact F is some per cent below the force of Hertz's law. */
static void the_kept_force_counts(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, "units none\nmaterial m density 0.238732414637843 young 1 poisson 0\nnormal hertz_increment\n"
                   "sphere 0 0 radius 1 m velocity 0.01 0\nsphere 2 0 radius 1 m\nmonitor C sphere 1 with sphere 2\n"
                   "step 0.2\nrecord C.normal C.overlap step.stable\nstage s\ncycles 9\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  written_cycles(model, 10);
  const double force = written_now(model, "C.normal"), overlap = written_now(model, "C.overlap");
  CU_ASSERT(force < 0.98 * 4. / 3 * 0.5 * sqrt(0.5) * pow(overlap, 1.5));
  NEAR(written_now(model, "step.stable"), 2 / sqrt(2 * cbrt(6 * force * 0.25 * 0.5)), 1e-12); /* both masses are 1 */
  nb_model_free(model);
  written_free(&it);
}

/* Each contact counts with its own history. The first pair of spheres has the larger force and slips, the second one is
 * smaller and stays at rest: with both the step is that of the second one alone, to the bit. */
static void each_history_counts(void) {
  static const char *const pairs[] = {
      "sphere 0 m 0 m radius 2 mm g velocity 0 m/s 100 m/s\nsphere 3.99 mm 0 m radius 2 mm g\n",
      "sphere 9 mm 0 m radius 1 mm g\nsphere 10.995 mm 0 m radius 1 mm g\n"};
  double steps[4];
  for (int which = 1; which <= 3; which++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    words_add(&page,
              "material g density 2500 kg/m3 young 70 GPa poisson 0.25 friction 0.3\nnormal hertz\nshear randall\n%s%s"
              "step 1e-8 s\nrecord step.stable\nstage s\ncycles 9\n",
              which & 1 ? pairs[0] : "", which & 2 ? pairs[1] : "");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    written_cycles(model, 3);
    steps[which] = written_now(model, "step.stable");
    nb_model_free(model);
    written_free(&it);
  }
  CU_ASSERT(steps[1] > steps[2]);
  CU_ASSERT(steps[3] == steps[2]);
}

void suite_stable(void) {
  CU_pSuite suite = CU_add_suite("stable", NULL, NULL);
  CU_add_test(suite, "lattices equal closed forms", lattices_equal_closed_forms);
  CU_add_test(suite, "margins stated in step-limit.md", margins_stated_in_step_limit);
  CU_add_test(suite, "rotation lowers the limit by thirty per cent", rotation_lowers_the_limit);
  CU_add_test(suite, "the limit of a damped pair equals its formula", damping_has_its_formula);
  CU_ADD_TEST(suite, each_history_counts);
  CU_ADD_TEST(suite, walls_have_their_own_damping);
  CU_add_test(suite, "random networks stay below the limit", random_networks_stay_below_the_limit);
  CU_ADD_TEST(suite, the_kept_force_counts);
  CU_add_test(suite, "stiffer unloading counts", stiffer_unloading_counts);
  CU_add_test(suite, "discs apart count as they touch", discs_apart_count_as_they_touch);
  CU_add_test(suite, "the largest step over the stable one is kept", largest_ratio_is_kept);
  CU_add_test(suite, "storage changes no bit", storage_changes_no_bit);
  CU_add_test(suite, "kept coefficients are those computed", kept_coefficients_are_those_computed);
}
