/* The stability check of contacts of elastic spheres. No cycle runs with a step that is not guaranteed stable, not even
 * between two checks.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../src/measure/step.h"
#include "chance.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

/* Runs the first stage for `cycles` cycles, or until the stability check stops it. Tests after each cycle whether the
 * check should have stopped it. Returns the number of completed cycles. */
static int run_until_stopped(struct nb_model *model, const struct written *it, int cycles, struct nb_error *error) {
  enum nb_status status = nb_stage_begin(model, &it->scene.stages[0], error);
  int done = 0;
  double least = INFINITY;
  while (!status && done < cycles) {
    status = nb_cycle(model, error);
    done += !status;
    const double safe = nb_stable_step(model).step;
    least = !status && safe < least ? safe : least;
    if (status && !strstr(error->text, "overlap by")) /* guard.c may stop the run first */
      CU_ASSERT(safe < model->step);
  }
  CU_ASSERT(least >= model->step * (1 - 1e-12));
  return done;
}

/* A light sphere of mass 1 touches a wall. A heavy sphere, which is hardly slowed down, pushes it towards the wall for
 * longer than half a period of the light sphere. So the light sphere is close to equilibrium, and the force F is the
 * same at both contacts. E* is 1/2, and R* is 1/2 between the spheres and 1 at the wall. By Hertz's law
 *
 *   F = 4/3 E* (R*)^(1/2) alpha^(3/2),    k = 2 E* (R* alpha)^(1/2) = (6 F E*^2 R*)^(1/3)
 *
 * omega^2 is the sum of both stiffnesses k, plus 1e-6 of the one between the spheres because of the heavy sphere. The
 * run stops when 2/omega has fallen to the step. */
static void an_impact_between_two_checks(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error = {0};
  words_add(&page,
            "units none\nmaterial m density 0.238732414637843 young 1 poisson 0\nmaterial heavy density "
            "238732.414637843 young 1 "
            "poisson 0\nnormal hertz\nskin 0.5\nsphere 1 0 radius 1 m\nsphere 3 0 radius 1 heavy velocity -1e-4 0\n"
            "wall w 0 -9 to 0 9 m\nmonitor C sphere 1 with sphere 2\nstep 3\nrecord C.normal\nstage s\ncycles 900\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  const int done = run_until_stopped(model, &it, 900, &error);
  CU_ASSERT(done > 50 && done < 900 && error.status == NB_BROKEN);
  CU_ASSERT_PTR_NOT_NULL(strstr(error.text, "the step 3 is above the guaranteed stable one"));
  CU_ASSERT_PTR_NOT_NULL(strstr(error.text, "particle 1 (line 7): at cycle "));
  const double force = written_now(model, "C.normal"), young = 0.5;
  const double square = cbrt(6 * force * young * young * 0.5) + cbrt(6 * force * young * young * 1);
  CU_ASSERT(fabs(2 / sqrt(square) - 3) < 0.15); /* the sphere oscillates a little about this equilibrium */
  CU_ASSERT(model->stability->checks < (unsigned long)done / 2 && model->search.count == 1);
  nb_model_free(model);
  written_free(&it);
}

/* Without a further search there is a check as the stage begins and one in each 1000th cycle: 3 in 2999 cycles and 4 in
 * 3000. At the speed 2e-4 particle 2 moves by 0.05, which is half the skin, in 625 cycles with the step 0.4. Then there
 * is a search, and a check follows it. */
static void searches_add_checks(void) {
  static const struct {
    const char *disc, *cycles;
    unsigned long searches, checks;
  } rows[] = {
      {"0", "2999", 1, 3}, {"0", "3000", 1, 4}, {"2e-4", "700", 2, 2}, {"2e-4", "999", 2, 2}, {"2e-4", "1000", 2, 3}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error = {0};
    words_add(&page,
              "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\ndisc 2.02 0 radius 1 m velocity %s 0\nstep "
              "0.4\nrecord time\nstage a\ncycles %s\n",
              rows[k].disc, rows[k].cycles);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    written_cycles(model, (int)it.scene.stages[0].cycles);
    CU_ASSERT_EQUAL(model->search.count, rows[k].searches);
    CU_ASSERT_EQUAL(model->stability->checks, rows[k].checks);
    nb_model_free(model);
    written_free(&it);
  }
}

/* ---- the stable-overlap limit ---- */

#define SPHERE "units none\nmaterial m density 0.238732414637843 young 1 poisson 0.3 friction 1\nnormal hertz\n"

/* The stable-overlap limit of a contact: the overlap up to which the step stays stable (measure/stability.c). */
static double overlap_stable(const struct nb_model *model, int contact) {
  return model->contacts.kept[NB_STABLE_OVERLAP][contact];
}

/* The limit of a contact with the first wall does not depend on the first particle, free or fixed, which is far away. */
static void walls_are_not_particles(void) {
  double limit[2];
  for (int fixed = 0; fixed < 2; fixed++) {
    struct words page = {0};
    struct written it;
    struct nb_error error = {0};
    words_add(&page,
              SPHERE
              "sphere 50 50 radius 1 m%s\nsphere 0.99 0 radius 1 m\nwall w 0 -9 to 0 9 m\nstep 0.5\nrecord time\n"
              "stage s\ncycles 9\n",
              fixed ? " fixed" : "");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    CU_ASSERT(model->contacts.count == 1 && nb_with_wall(model, 0));
    limit[fixed] = overlap_stable(model, 0);
    nb_model_free(model);
    written_free(&it);
  }
  CU_ASSERT(limit[0] > 0.01 && limit[0] < 1e9 && limit[0] == limit[1]);
}

/* A single pair may use up the whole limit: at its stable-overlap limit the guaranteed stable step equals the step.
 * With shear and dashpots the stable-overlap limit is slightly too small. A contact with a wall counts with the dashpots
 * of walls. */
static void a_pair_may_use_up_the_limit(void) {
  static const struct {
    const char *statements;
    double within; /* fraction of the step */
    bool wall;
  } cases[] = {
      {"shear none\n", 1e-9},
      {"shear mindlin\n", 1e-9},
      {"shear mindlin_deresiewicz\n", 1e-9},
      {"shear none\ndamping ratio 0.3\n", 1e-9},
      {"shear none\ndamping stiffness 0.2\n", 1e-9},
      {"shear none\ndamping ratio 0.3\ndamping centred\n", 1e-9},
      {"shear none\ndamping stiffness 0.2\ndamping centred\n", 1e-9},
      {"shear none\ndamping con1 0.8 as all\n", 1e-9},
      {"shear mindlin\ndamping ratio 0.3\n", 0.03},
      {"shear none\ndamping ratio 0.3\ndamping walls ratio 0.1\n", 1e-9, true},
      {"shear none\ndamping ratio 0.3\ndamping walls none\n", 1e-9, true},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    double overlap = 0.002, step = 0;
    for (int at_last = 0; at_last < 2; at_last++) {
      struct words page = {0};
      struct written it;
      struct nb_error error = {0};
      words_add(&page, SPHERE "%ssphere 0 0 radius 1 m\n", cases[k].statements);
      words_add(&page, cases[k].wall ? "wall w %.17g -9 to %.17g 9 m\n" : "sphere %.17g 0 radius 1 m\n",
                cases[k].wall ? 1 - overlap : 2 - overlap, 1 - overlap);
      words_add(&page, "step 2.4\nrecord step.stable\nstage s\ncycles 1\n");
      written_scene(&it, &page);
      struct nb_model *model = written_model(&it, NULL);
      nb_stage_begin(model, &it.scene.stages[0], &error);
      overlap = overlap_stable(model, 0), step = nb_stable_step(model).step;
      nb_model_free(model);
      written_free(&it);
    }
    CU_ASSERT(step >= 2.4 * (1 - 1e-9) && step <= 2.4 * (1 + cases[k].within));
    if (!(step <= 2.4 * (1 + cases[k].within)))
      printf("# with %s: step %.12g at the stable-overlap limit %g\n", cases[k].statements, step, overlap);
  }
}

/* Elastic spheres that unload twice as stiffly as they load. */
static struct nb_normal yields(struct nb_pair p, double overlap, double dn, double m[]) {
  struct nb_normal n = nb_law_find("normal", "hertz")->normal(p, overlap, dn, m);
  n.max_stiffness = 2 * n.stiffness;
  return n;
}

/* The stable-overlap limit follows from the largest stiffness of the law, which is here twice the stiffness of Hertz's
 * law. So the stiffness reaches the allowed value at a quarter of the overlap. The program finds this overlap by
 * halving. */
static void stiffer_unloading_lowers_the_limit(void) {
  struct nb_law law = *nb_law_find("normal", "hertz");
  double stable_overlap[2];
  law.normal = yields;
  for (int k = 0; k < 2; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error = {0};
    words_add(&page,
              SPHERE "shear none\nsphere 0 0 radius 1 m\nsphere 1.9999 0 radius 1 m\nstep 2.4\nrecord step.stable\n"
                     "stage s\ncycles 1\n");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    if (k == 1) {
      model->next_laws.normal = &law;
      for (size_t p = 0; p < model->material_pair_count; p++)
        model->material_pairs[p].normal = &law;
    }
    CU_ASSERT_EQUAL(nb_stability_check(model, &error), NB_OK);
    stable_overlap[k] = overlap_stable(model, 0);
    nb_model_free(model);
    written_free(&it);
  }
  CU_ASSERT_DOUBLE_EQUAL(stable_overlap[1], stable_overlap[0] / 4, 1e-5 * stable_overlap[0]);
}

/* Elastic spheres whose largest stiffness is `excess` times that of Hertz, or 1e9 at any overlap if `excess` is 0. */
static double excess;
static struct nb_normal stiffer(struct nb_pair p, double overlap, double dn, double m[]) {
  struct nb_normal n = nb_law_find("normal", "hertz")->normal(p, overlap, dn, m);
  n.max_stiffness = excess > 0 ? excess * n.stiffness : 1e9;
  return n;
}

/* The stiffness at the stable-overlap limit may exceed what the step allows by the fraction 1e-6, the tolerance of
 * measure/stability.c. So a law that is stiffer than Hertz's by the fraction 3e-7 has the limit of Hertz's law, and one
 * that is stiffer by 3e-6 has half of that limit. If the stiffness is too large at any overlap, the limit is 0. */
static void the_limit_is_kept_to_a_millionth(void) {
  static const double rows[][2] = {{1 + 3e-7, 1}, {1 + 3e-6, 0.5}, {0, 0}};
  struct nb_law law = *nb_law_find("normal", "hertz");
  law.normal = stiffer;
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error = {0};
    words_add(&page, SPHERE "shear none\nsphere 0 0 radius 1 m\nsphere 1.9999 0 radius 1 m\nstep 2.4\nrecord "
                            "step.stable\nstage s\ncycles 1\n");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL(nb_stability_check(model, &error), NB_OK);
    const double of_hertz = overlap_stable(model, 0);
    excess = rows[k][0];
    for (size_t p = 0; p < model->material_pair_count; p++)
      model->material_pairs[p].normal = &law;
    CU_ASSERT_EQUAL(nb_stability_check(model, &error), NB_OK);
    CU_ASSERT_EQUAL(overlap_stable(model, 0), rows[k][1] * of_hertz);
    nb_model_free(model);
    written_free(&it);
  }
}

/* A very short step allows the stiffness (4/dt^2) M*. Its square is beyond the largest double, so the stable-overlap
 * limit is infinite. */
static void a_step_without_a_limit(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error = {0};
  words_add(&page, SPHERE "shear none\nsphere 0 0 radius 1 m\nsphere 1.9999 0 radius 1 m\nstep 1e-90\nrecord "
                          "step.stable\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL(nb_stability_check(model, &error), NB_OK);
  CU_ASSERT(isinf(overlap_stable(model, 0)));
  nb_model_free(model);
  written_free(&it);
}

/* A contact that may become deep must be stable with the critical dashpot of a deep contact. So its damping
 * coefficient is c = b k^(1/2), where b = max(2 ratio, 2) (M*)^(1/2) and the reduced mass M* is 1/2. q = dt^2 k + 2
 * dt c of the pair may be at most 2, so the largest stiffness k satisfies dt^2 k + 2 dt b k^(1/2) = 2. Centred
 * dashpots count twice. */
static void a_contact_may_become_deep(void) {
  static const double ratios[] = {0.3, 1.5};
  for (size_t n = 0; n < 4; n++) {
    struct words page = {0};
    struct written it;
    struct nb_error error = {0};
    words_add(&page,
              SPHERE "shear none\ndamping ratio %g\ndamping critical beyond overlap 0.5\n%ssphere 0 0 radius 1 m\n"
                     "sphere 1.999999 0 radius 1 m\nstep 0.25\nrecord step.stable\nstage s\ncycles 1\n",
              ratios[n % 2], n / 2 ? "damping centred\n" : "");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
    const double b = fmax(2 * ratios[n % 2], 2) * sqrt(0.5) * (n / 2 ? 2 : 1), dt = 0.25;
    const double root = (-b + sqrt(b * b + 2)) / dt;
    const double stiffness = root * root, young = 1 / (2 * 0.91),
                 expected = stiffness * stiffness / (4 * young * young * 0.5);
    CU_ASSERT_DOUBLE_EQUAL(overlap_stable(model, 0) / expected, 1, 1e-9);
    nb_model_free(model);
    written_free(&it);
  }
}

/* In a pair of a fixed and a free particle, the free one gets all of L (measure/stability.c). Each pair has its own
 * material. */
static void a_fixed_particle(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error = {0};
  words_add(&page, SPHERE "material n density 0.238732414637843 young 2 poisson 0.3\nshear none\n"
                          "sphere 0 0 radius 1 m fixed\nsphere 1.99 0 radius 1 m\nsphere 9 0 radius 1 n fixed\n"
                          "sphere 10.9999 0 radius 1 n\nstep 2.4\nrecord step.stable\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  const double stiffness = 4 / (2.4 * 2.4), young = 1 / (2 * 0.91);
  const double expected = stiffness * stiffness / (4 * young * young * 0.5);
  CU_ASSERT(fabs(overlap_stable(model, 0) - expected) < 1e-9 * expected);
  NEAR(overlap_stable(model, 1), expected / 4, 1e-9); /* twice as stiff */
  nb_model_free(model);
  written_free(&it);
}

/* The quotient h of measure/stability.c is an upper bound, so with dashpots and shear a stable contact may have no
 * remainder. Its stable-overlap limit is then its present overlap. */
static void a_contact_without_a_remainder(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error = {0};
  words_add(&page, SPHERE "shear mindlin\ndamping ratio 0.3\nsphere 0 0 radius 1 m\nsphere 1.99 0 radius 1 m\n"
                          "step 0.9999 of stable\nrecord step.stable\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  NEAR(overlap_stable(model, 0), 0.01, 1e-9);
  nb_model_free(model);
  written_free(&it);
}

/* A row of a wall, sphere A of mass 1 and sphere B of mass 8, with normal springs only. measure/stability.c defines q,
 * L and the remainder of a contact. q is q0 at the contact A-B and q1 at the wall, and L = 4. So the remainder at the
 * wall is 4 - (q0 + q1), and A gets all of it. The remainder at A-B is 4 - (q0 + q1) - q0/8, and A and B get half each.
 * The smaller one of the two parts that A gets is divided among the two contacts of A. B has only one contact. */
static void wall_and_two_spheres_share_the_limit(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error = {0};
  words_add(&page, SPHERE "shear none\nwall w 0 -9 to 0 9 m\nsphere 0.99 0 radius 1 m\nsphere 3.97 0 radius 2 m\n"
                          "step 1.5\nrecord step.stable\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  const double young = 1 / (2 * 0.91), radius[2] = {2. / 3, 1}, overlap[2] = {0.02, 0.01}; /* of A-B, of the wall */
  double q[2];
  for (int k = 0; k < 2; k++)
    q[k] = 2.25 * 2 * young * sqrt(radius[k] * overlap[k]);
  const double at_wall = 4 - q[0] - q[1], between = 4 - q[0] - q[1] - q[0] / 8;
  const double of_a = fmin(at_wall, between / 2) / 2, of_b = 8 * between / 2;
  const double most[2] = {q[0] + fmin(of_a, of_b), q[1] + of_a};
  for (int k = 0; k < 2; k++) {
    const double stiffness = most[k] / 2.25;
    const double expected = stiffness * stiffness / (4 * young * young * radius[k]);
    CU_ASSERT(fabs(overlap_stable(model, k) - expected) < 1e-9 * expected);
  }
  CU_ASSERT_EQUAL(model->blocks.stable_overlap[0].overlap, overlap_stable(model, 0));
  CU_ASSERT_EQUAL(model->blocks.stable_overlap[1].overlap, overlap_stable(model, 1));
  nb_model_free(model);
  written_free(&it);
}

/* ---- random assemblies ---- */

/* Moving spheres of two materials in a box, some in contact and some apart. */
static void crowd(struct words *page, struct chance *chance, const char *shear) {
  words_add(page, "units none\nnormal hertz\nshear %s\nskin 0.3\n", shear);
  for (int m = 0; m < 2; m++) { /* drawn one by one, because a compiler may evaluate arguments in any order */
    const double poisson = chance_between(chance, 0, 0.45);
    const double young = chance_scale(chance, 1, 30);
    const double density = chance_scale(chance, 0.1, 10);
    words_add(page, "material %c density %g young %g poisson %g friction %d\n", 'a' + m, density, young, poisson, m);
  }
  words_add(page, "box -1 -1 to 7 7 a\n");
  for (int k = 0; k < 16; k++) {
    const double spin = chance_between(chance, -0.1, 0.1);
    const double vy = chance_between(chance, -0.1, 0.1), vx = chance_between(chance, -0.1, 0.1);
    const double radius = chance_between(chance, 0.85, 1.1);
    const double y = chance_between(chance, -0.1, 0.1), x = chance_between(chance, -0.1, 0.1);
    words_add(page, "sphere %.17g %.17g radius %.17g %c velocity %.17g %.17g spin %.17g\n", 2 * (k % 4) + x,
              2 * (k / 4) + y, radius, k % 3 ? 'a' : 'b', vx, vy, spin);
  }
}

static void every_cycle_is_guaranteed_stable(void) {
  static const char *const shears[] = {"none", "mindlin", "mindlin_deresiewicz", "randall"};
  static const char *const damped[] = {"",
                                       "damping ratio 0.2\n",
                                       "damping ratio 0.2\ndamping centred\n",
                                       "damping stiffness 0.01\n",
                                       "damping critical beyond overlap 0.02\n",
                                       "damping con1 0.9 as all\n"};
  int ended = 0, went = 0;
  unsigned long looks = 0, cycles = 0;
  for (unsigned seed = 1; seed <= 60; seed++) {
    struct chance chance = chance_begin(seed);
    struct words page = {0};
    struct written it;
    struct nb_error error = {0};
    crowd(&page, &chance, shears[seed % 4]);
    words_add(&page, "%sstep %.17g of stable\nrecord time\nstage s\ncycles 400\n", damped[seed % 6],
              chance_scale(&chance, 0.1, 0.95));
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    const int done = run_until_stopped(model, &it, 400, &error);
    ended += done < 400, went += done == 400;
    looks += model->stability->checks, cycles += (unsigned long)done;
    nb_model_free(model);
    written_free(&it);
  }
  printf("# %d of 60 were stopped; a check every %.1f cycles\n", ended, (double)cycles / (double)looks);
  CU_ASSERT(ended > 10 && went > 10);
}

/* The number of steps per collision that a message proposes is rounded up, so the step is at most 0.3 of the stable
 * step. */
static void the_proposed_number_of_steps(void) {
  static const double stiffness[] = {20, 50, 75, 100, 160, 220}; /* k_s; k_n is 100 */
  int rounded_up = 0;
  for (size_t k = 0; k < sizeof stiffness / sizeof *stiffness; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    char proposal[64];
    words_add(&page,
              "units none\nmaterial m density 1 kn 100 ks %g friction 1\nshear linear\ndisc 0 0 radius 1 m\n"
              "disc 0 1.99 radius 1 m\nstep 1 per collision\nstage s\ncycles 1\n",
              stiffness[k]);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    const double wanted = model->step / (0.3 * nb_stable_step(model).step);
    CU_ASSERT_EQUAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_BROKEN);
    snprintf(proposal, sizeof proposal, "write `step %.0f per collision`", ceil(wanted));
    CU_ASSERT_PTR_NOT_NULL(strstr(error.text, proposal));
    rounded_up += ceil(wanted) - wanted > 0.5;
    nb_model_free(model);
    written_free(&it);
  }
  CU_ASSERT(rounded_up > 0);
}

/* A message proposes a step in the form in which the stage gives its step, or the scene if no stage has begun. It
 * proposes 0.3 of the stable step, with two digits. */
static void the_proposed_step_has_the_form_of_the_page(void) {
  static const struct {
    const char *step, *form;
  } rows[] = {{"300", ""},
              {"300 s", " s"},
              {"100 of rayleigh", " of rayleigh"},
              {"100 of rayleigh-mean", " of rayleigh-mean"},
              {"100 of rayleigh-fit", " of rayleigh-fit"},
              {"100 of rayleigh-fit-mean", " of rayleigh-fit-mean"},
              {"1.7 of stable", " of stable"},
              {"5 of single-contact", " of single-contact"}};
  for (size_t k = 0; k < 2 * sizeof rows / sizeof *rows; k++) {
    const size_t r = k / 2;
    const bool later = k % 2, units = r == 1, spring = strstr(rows[r].form, "single");
    struct words page = {0};
    struct written it;
    struct nb_error error = {0};
    char proposal[64], step[64];
    snprintf(step, sizeof step, "step %s\n", rows[r].step);
    words_add(&page,
              units ? "material m density 1 kg/m3 young 1 Pa poisson 0.3\nnormal hertz\nsphere 0 m 0 m radius 1 m m\n"
                      "sphere 1.9 m 0 m radius 1 m m\n"
                    : "units none\nmaterial m density 1 young 1 poisson 0.3 kn 1\n"
                      "sphere 0 0 radius 1 m\nsphere 1.9 0 radius 1 m\n");
    words_add(&page, "%s%sstage s\n%scycles 1\n",
              units    ? ""
              : spring ? "normal linear\n"
                       : "normal hertz\n",
              later ? (units ? "step 1 ms\n" : "step 1e-3\n") : step, later ? step : "");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL(later ? nb_stage_begin(model, &it.scene.stages[0], &error) : nb_stability_check(model, &error),
                    NB_BROKEN);
    const double given = strtod(rows[r].step, NULL);
    snprintf(proposal, sizeof proposal, "write `step %.2g%s`,", 0.3 * given * nb_stable_step(model).step / model->step,
             rows[r].form);
    CU_ASSERT_PTR_NOT_NULL(strstr(error.text, proposal));
    if (!strstr(error.text, proposal))
      printf("# %s is not in %s\n", proposal, error.text);
    nb_model_free(model);
    written_free(&it);
  }
}

/* Contacts with cohesion alone have a shear force, and the stable step counts its stiffness as with friction. */
static void cohesion_alone_counts(void) {
  static const char *const limits[] = {"", "friction 0.5", "cohesion 1e-3", "friction 0.5 cohesion 1e-3"};
  double stable[4], apart[4];
  for (int k = 0; k < 4; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1 kn 100 ks 300 %s\nshear linear\nwall w -9 0 to 9 0 m\n"
              "lattice discs 2 by 2 m radius 1 spacing 1.99 from 0 0.99\nstep 0.001\nstage s\ncycles 1\n",
              limits[k]);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    stable[k] = nb_stable_step(model).step, apart[k] = nb_stable_step_apart(model).step;
    nb_model_free(model);
    written_free(&it);
  }
  CU_ASSERT(stable[1] < 0.8 * stable[0] && apart[1] < 0.8 * apart[0]);
  for (int k = 2; k < 4; k++)
    CU_ASSERT(stable[k] == stable[1] && apart[k] == apart[1]);
}

/* The words of a message for the pair that limits the step: two particles, a particle and a wall, or a particle and the
 * material of walls. The words also say if the pair does not touch. */
static void what_limits_the_step_in_words(void) {
  struct words page = {0};
  struct written it;
  char text[256];
  words_add(&page,
            "units none\nmaterial ice density 1 kn 1\nmaterial rock density 1 kn 1\ndisc 0 0 radius 1 ice\n"
            "disc 9 0 radius 1 ice\ndisc 5 0 radius 1 ice\nwall one -9 -5 to 9 -5 rock\nwall two -9 5 to 9 5 rock\n"
            "step 0.01\nrecord time\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, &(struct nb_options){.shuffle = true});
  const struct nb_material_pair discs = {.a = 0, .b = 0}, walls = {.a = 0, .b = 1, .wall = true};
  const int *slot = model->particles.slot;
  const struct {
    struct nb_stable stable;
    const char *text;
  } rows[] = {
      {{.a = -1, .b = -1, .apart = true}, "no contact"},
      {{.a = slot[2], .b = -1, .material_pair = &walls}, "normal motion of particle 3 and a wall of rock"},
      {{.a = slot[0], .b = -1, .apart = true, .rotational = true, .material_pair = &walls},
       "rotation of particle 1 and a wall of rock, as if they touched"},
      {{.a = slot[1], .b = 1, .material_pair = &walls}, "normal motion of particle 2 and wall two"},
      {{.a = slot[1], .b = 0, .rotational = true, .material_pair = &walls}, "rotation of particle 2 and wall one"},
      {{.a = slot[2], .b = slot[1], .material_pair = &discs}, "normal motion of particles 3 and 2"},
      {{.a = slot[0], .b = slot[2], .apart = true, .material_pair = &discs},
       "normal motion of particles 1 and 3, as if they touched"},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    nb_stable_text(text, sizeof text, model, &rows[k].stable);
    CU_ASSERT_STRING_EQUAL(text, rows[k].text);
  }
  const struct nb_stable apart = nb_stable_step_apart(model);
  nb_stable_text(text, sizeof text, model, &apart);
  CU_ASSERT_STRING_EQUAL(text, "normal motion of particles 1 and 2, as if they touched");
  nb_model_free(model);
  written_free(&it);
}

/* The message about the step has the number and the line of a particle, whatever the order of storage is. */
static void the_particle_of_the_message(void) {
  for (int light = 1; light <= 5; light++) {
    struct words page = {0};
    struct written it;
    struct nb_error error;
    char wanted[60];
    words_add(&page, "units none\nmaterial m density 1 kn 1\n");
    for (int k = 1; k <= 5; k++)
      words_add(&page, "disc %d 0 radius %d m\n", 10 * k, k == light ? 1 : 3);
    words_add(&page, "step 90\nrecord time\nstage s\ncycles 1\n");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, &(struct nb_options){.shuffle = true});
    CU_ASSERT_EQUAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_BROKEN);
    snprintf(wanted, sizeof wanted, "particle %d (line %d): ", light, light + 3);
    CU_ASSERT_EQUAL(strncmp(error.text, wanted, strlen(wanted)), 0);
    nb_model_free(model);
    written_free(&it);
  }
}

/* A pair that touches sets the step, although the lightest two particles would give the same step. */
static void a_listed_pair_comes_first(void) {
  struct words page = {0};
  struct written it;
  char text[256];
  words_add(&page, "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\ndisc 1.9 0 radius 1 m\nstep 0.01\n"
                   "record time\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  const struct nb_stable stable = nb_stable_step_stage(model);
  nb_stable_text(text, sizeof text, model, &stable);
  CU_ASSERT_STRING_EQUAL(text, "normal motion of particles 1 and 2");
  nb_model_free(model);
  written_free(&it);
}

void suite_stability(void) {
  CU_pSuite suite = CU_add_suite("stability", NULL, NULL);
  CU_add_test(suite, "searches add checks", searches_add_checks);
  CU_add_test(suite, "the limit is kept to a millionth", the_limit_is_kept_to_a_millionth);
  CU_add_test(suite, "a very short step has an infinite stable-overlap limit", a_step_without_a_limit);
  CU_add_test(suite, "the proposed number of steps per collision", the_proposed_number_of_steps);
  CU_ADD_TEST(suite, the_proposed_step_has_the_form_of_the_page);
  CU_add_test(suite, "cohesion alone counts in the stable step", cohesion_alone_counts);
  CU_add_test(suite, "an impact between two checks", an_impact_between_two_checks);
  CU_add_test(suite, "the limit at a wall does not depend on the first particle", walls_are_not_particles);
  CU_add_test(suite, "a pair may use up the limit", a_pair_may_use_up_the_limit);
  CU_add_test(suite, "stiffer unloading lowers the stable-overlap limit", stiffer_unloading_lowers_the_limit);
  CU_add_test(suite, "a contact may become deep", a_contact_may_become_deep);
  CU_add_test(suite, "beside a fixed particle the free one gets the whole limit", a_fixed_particle);
  CU_ADD_TEST(suite, a_contact_without_a_remainder);
  CU_add_test(suite, "a wall and two spheres share the limit", wall_and_two_spheres_share_the_limit);
  CU_add_test(suite, "every cycle is guaranteed stable", every_cycle_is_guaranteed_stable);
  CU_add_test(suite, "what limits the step, in words", what_limits_the_step_in_words);
  CU_ADD_TEST(suite, a_listed_pair_comes_first);
  CU_ADD_TEST(suite, the_particle_of_the_message);
}
