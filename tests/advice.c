/* The search for advice on pages whose values follow from their statements: a quantity that every step gives exactly, and
 * the step itself, which has an error of first order. So errors, tolerances and numbers of updates are known.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../src/laws/law.h"
#include "../src/report/advise.h"
#include "suites.h"

static const char *const no_settings[] = {NULL};

struct asked {
  char path[64];
  struct nb_advise_query query;
  struct nb_advice advice;
  struct nb_error error;
  enum nb_status status;
};

/* Writes a page with a block of this kind and asks for advice on it; `over` is NULL for a single run. */
static void ask(struct asked *it, const char *kind, const char *text, const char *quantity, const char *within,
                const char *over) {
  *it = (struct asked){.path = "/tmp/nineball-advice-XXXXXX.md"};
  const int descriptor = mkstemps(it->path, 3);
  CU_ASSERT_FATAL(descriptor >= 0);
  FILE *file = fdopen(descriptor, "w");
  CU_ASSERT_PTR_NOT_NULL_FATAL(file);
  fprintf(file, "# A page\n\n```%s\nunits none\n%s```\n", kind, text);
  fclose(file);
  it->query = (struct nb_advise_query){.path = it->path,
                                       .settings = no_settings,
                                       .options = {.threads = 1, .jobs = 1},
                                       .quantity = quantity,
                                       .within = within,
                                       .over = over,
                                       .realizations = NB_REALIZATIONS_MIN,
                                       .budget = 6000};
  it->status = nb_advise(&it->advice, &it->query, &it->error);
}

static void finish(struct asked *it) {
  nb_advice_free(&it->advice);
  unlink(it->path);
}

/* A disc that flies with the velocity v; 1, 2, 4 or 8 cycles are possible. */
#define FLIGHT(names, v)                                                                                               \
  names "material m density 1 kn 1\ndisc 0 0 radius 1 m velocity " v " 0\nmonitor D disc 1\nrecord D.vx\n"             \
        "step 0.01\nstage a\ncycles 8\n"

/* Two discs of which nothing but the step is recorded, with `e` times the step of the page and this number of cycles. */
#define STEPS(names, cycles)                                                                                           \
  names "material m density 1 kn 1000\ndisc 0 0 radius 1 m\ndisc 9 0 radius 1 m\nrecord step\n"                        \
        "step (0.016*e)\nstage a\ncycles " cycles "\n"

/* The uncertainty of the anchor may be half the tolerance. At level 3 it is 3 times the step of this level, 0.006. Of
 * two runs with the same errors the first one counts as the worst; of three others that with the largest error. */
static void the_anchor_may_have_half_the_tolerance(void) {
  for (int k = 0; k < 2; k++) {
    struct asked it;
    ask(&it, "scene", STEPS("let e = 1\ntrade laws none\nsweep u 1 2\nlet w = u\n", "64"), "step",
        k ? "0.0119" : "0.0121", NULL);
    CU_ASSERT_EQUAL_FATAL(it.status, NB_OK);
    CU_ASSERT_EQUAL(it.advice.anchor, k ? 4 : 3);
    for (size_t s = 0; s < it.advice.setting_count; s++)
      CU_ASSERT(it.advice.settings[s].ratio > 0 && it.advice.settings[s].worst == 0);
    finish(&it);
  }
  struct asked it;
  ask(&it, "scene", STEPS("trade laws none\nsweep e 1 2 1.5\n", "64"), "step", "0.05", NULL);
  CU_ASSERT_EQUAL_FATAL(it.status, NB_OK);
  for (size_t s = 0; s < it.advice.setting_count; s++)
    CU_ASSERT_EQUAL(it.advice.settings[s].worst, 1);
  finish(&it);
}

/* A variant is left out if its value differs from that of the page by more than twice the tolerance, or if it is the
 * same as that of an earlier variant. The velocity is |v| or -|v|, with v = 1 in the page, and the tolerance 0.01. A claim, the estimated error, is
 * 1.25 times the difference. Of two equal runs the first one is named. The variants that stay have all errors but no error of the step, and are not tried with a
 * second step, which has more updates than the page with its longest step, one. */
static void variants_near_and_far(void) {
  static const struct {
    double value;
    const char *reason;
  } rows[] = {{1, ""},
              {1.019, ""},
              {1.5, "its value differs from that of the page by 50 times the tolerance, in run u=1"},
              {1.021, "its value differs from that of the page by 2.1 times the tolerance, in run u=1"},
              {1.021, "it gives the same values as a variant before it"},
              {1, "it gives the same values as the page"},
              {0.981, ""}};
  for (int sign = 0; sign < 2; sign++) {
    struct asked it;
    size_t setting = 0;
    ask(&it, "scene",
        sign ? FLIGHT("sweep u 1 2\nlet w = u\nlet v = 1\ntrade v 1.019 1.5 1.021 -1.021 1.0 0.981\ntrade laws none\n",
                      "(-sqrt(v*v))")
             : FLIGHT("sweep u 1 2\nlet w = u\nlet v = 1\ntrade v 1.019 1.5 1.021 -1.021 1.0 0.981\ntrade laws none\n",
                      "(sqrt(v*v))"),
        "D.vx", "1 %", NULL);
    CU_ASSERT_EQUAL_FATAL(it.status, NB_OK);
    NEAR(it.advice.allowed[0], 0.01, 1e-12);
    CU_ASSERT_EQUAL_FATAL(it.advice.variant_count, 7);
    for (size_t k = 0; k < 7; k++) {
      const struct nb_variant *variant = &it.advice.variants[k];
      CU_ASSERT_STRING_EQUAL(variant->reason, rows[k].reason);
      if (rows[k].reason[0])
        continue;
      CU_ASSERT_FATAL(setting < it.advice.setting_count);
      const struct nb_setting *found = &it.advice.settings[setting++];
      CU_ASSERT(found->variant == k && found->level == -3);
      CU_ASSERT_DOUBLE_EQUAL(found->ratio, 1.25 * fabs(rows[k].value - 1) / 0.01, 1e-9);
      CU_ASSERT_EQUAL(found->step_ratio, 0);
    }
    CU_ASSERT_EQUAL(it.advice.setting_count, setting);
    CU_ASSERT_EQUAL(it.advice.chosen, 0);
    finish(&it);
  }
}

/* A variant that differs in one of two runs alone is neither equal to the page nor near it, whichever run this is. */
static void a_variant_that_differs_in_one_run(void) {
  for (int last = 0; last < 2; last++) {
    struct asked it;
#define ONE_RUN(values) FLIGHT("sweep u " values "\nlet w = 1\ntrade w 1.5\ntrade laws none\n", "(1 + (w - 1)*(2 - u))")
    ask(&it, "scene", last ? ONE_RUN("2 1") : ONE_RUN("1 2"), "D.vx", "1 %", NULL);
    CU_ASSERT_EQUAL_FATAL(it.status, NB_OK);
    CU_ASSERT_EQUAL_FATAL(it.advice.variant_count, 2);
    CU_ASSERT_STRING_EQUAL(it.advice.variants[1].reason,
                           "its value differs from that of the page by 50 times the tolerance, in run u=1");
    finish(&it);
  }
}

/* The tolerance of the step is 0.0124. The page needs level 2, which has 2*4*64 = 512 updates, and its anchor is at
 * level 3. The variant has three times the step and is within the tolerance at level 3. With 68 cycles level 2 of the
 * variant is still tried, because 0.9 of its updates are fewer than 512; level 3 is not. With 16 cycles level 3, with
 * 256 updates, is tried and chosen. */
static void levels_of_a_variant_that_costs_as_much(void) {
  for (int cheap = 0; cheap < 2; cheap++) {
    struct asked it;
    ask(&it, "scene",
        cheap ? STEPS("let e = 1\ntrade e 3\ntrade laws none\n", "(88 - 24*e)")
              : STEPS("let e = 1\ntrade e 3\ntrade laws none\n", "(62 + 2*e)"),
        "step", "0.0124", NULL);
    CU_ASSERT_EQUAL_FATAL(it.status, NB_OK);
    CU_ASSERT_FATAL(it.advice.chosen >= 0);
    const struct nb_setting *last = &it.advice.settings[it.advice.setting_count - 1],
                            *chosen = &it.advice.settings[it.advice.chosen];
    CU_ASSERT(last->variant == 1 && last->level == (cheap ? 3 : 2));
    CU_ASSERT(chosen->variant == (cheap ? 1 : 0) && chosen->level == (cheap ? 3 : 2));
    CU_ASSERT_EQUAL(nb_point_at(&it.advice, chosen)->updates, cheap ? 256 : 512);
    finish(&it);
  }
}

/* Without `trade laws none` the variants have each other pair of laws. A contact test has neither softer contacts nor
 * dashpots, and no time. */
static void a_contact_test_trades_its_laws(void) {
  struct asked it;
  size_t normals = 0, shears = 0;
  ask(&it, "contact-test",
      "material m young 100 poisson 0 friction 1\ncontact sphere 1 m with wall m\nnormal hertz\nshear mindlin\n"
      "record normal\nsegment p overlap to 0.1 in 4 steps\n",
      "normal", "1 %", NULL);
  CU_ASSERT_EQUAL_FATAL(it.status, NB_OK);
  for (const struct nb_law *const *law = nb_laws(); *law; law++)
    normals += strcmp((*law)->kind, "normal") == 0, shears += strcmp((*law)->kind, "shear") == 0;
  CU_ASSERT_EQUAL(it.advice.variant_count, normals * shears);
  for (size_t k = 1; k < it.advice.variant_count; k++) {
    const struct nb_variant *variant = &it.advice.variants[k];
    CU_ASSERT(variant->normal[0] && variant->soften == 0 && !variant->centred);
    CU_ASSERT(strcmp(variant->normal, "hertz") != 0 || strcmp(variant->shear, "mindlin") != 0);
  }
  CU_ASSERT_FATAL(it.advice.chosen >= 0);
  CU_ASSERT_EQUAL(nb_point_at(&it.advice, &it.advice.settings[it.advice.chosen])->step, 0);
  finish(&it);
}

/* The mean over eight realizations is known well enough if the claim of the page, whose anchor has half the step, is at
 * most the tolerance. Realization k has the gravity k, with k = 1 to 8. With the step 0.02 its stage ends at 1, with half
 * the step at 0.99. So the velocities differ by 0.01 k: by 0.045 in the mean, with the standard deviation 0.01 6^(1/2).
 * The quantile of Student's distribution is 2.3646. The second run has twice this claim, 0.13096. */
static void a_mean_must_be_known_as_well_as_the_tolerance(void) {
  for (int k = 0; k < 2; k++) {
    struct asked it;
    ask(&it, "scene",
        "let seed = 1\nsweep c 1 2\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m velocity 0 0\nmonitor D disc 1\n"
        "gravity 0 (c*seed)\nrecord D.vy\nstep 0.02\nstage a\nuntil time above 0.985 at most 1000 cycles\n",
        "D.vy", k ? "0.130" : "0.132", "seed");
    CU_ASSERT_EQUAL(it.status, k ? NB_FAILED : NB_OK);
    if (k)
      CU_ASSERT_PTR_NOT_NULL(strstr(it.error.text,
                                    "by up to 1 times the tolerance, in run c=2. Choose more --realizations, "
                                    "at most 32"));
    finish(&it);
  }
}

/* A page that cannot be run with half its step names the reason, and so does a page with a mistake in its first
 * realization, which is not called a mistake of --over. */
static void reasons_of_pages_that_cannot_be_run(void) {
  struct asked it;
  ask(&it, "scene",
      "material m density 1 kn 1\ndisc 0 0 radius 1 m velocity 1 0\nmonitor D disc 1\nrecord D.vx\nstep 0.02\nstage a\n"
      "until step above 0.015 at most 9 cycles\n",
      "D.vx", "1 %", NULL);
  CU_ASSERT_EQUAL(it.status, NB_FAILED);
  CU_ASSERT_PTR_NOT_NULL(
      strstr(it.error.text, "half of it: stage `a` (line 10) did not end within 18 cycles: step is 0.01 "));
  finish(&it);
  ask(&it, "scene", FLIGHT("let n = 2\n", "(1/(n-1))"), "D.vx", "1 %", "n");
  CU_ASSERT_EQUAL(it.status, NB_BAD_USE);
  CU_ASSERT_PTR_NULL(strstr(it.error.text, "after --over"));
  CU_ASSERT_PTR_NOT_NULL_FATAL(it.advice.page.mistakes.text);
  finish(&it);
}

/* The quantity is that of the first expectation of a single value: neither a curve nor a line `report`. */
static void the_quantity_of_the_page(void) {
  struct asked it;
  ask(&it, "scene",
      "material m density 1 kn 1000\nnormal linear\ngravity 0 -1\nsphere 0 5 radius 1 m\nwall floor -9 0 to 9 0 m\n"
      "monitor D sphere 1\nrecord time D.y D.vy\nstep 0.01\nstage a\ncycles 8\n```\n\n```expect\nreference free_fall\n"
      "D.y versus time within 1 % of peak\nreport D.y\nD.vy within 1 %\n",
      NULL, "2 %", NULL);
  CU_ASSERT_EQUAL(it.status, NB_OK);
  CU_ASSERT_STRING_EQUAL(it.advice.text, "D.vy within 2 %");
  finish(&it);
}

/* Realization k has 8 k cycles of one disc, with k = 1 to 8: 36 in the mean. */
static void updates_are_the_mean_over_the_trials(void) {
  struct asked it;
  ask(&it, "scene",
      "let seed = 1\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m velocity 1 0\nmonitor D disc 1\nrecord D.vx\n"
      "step 0.01\nstage a\ncycles (8*seed)\n",
      "D.vx", "1 %", "seed");
  CU_ASSERT_EQUAL_FATAL(it.status, NB_OK);
  NEAR(it.advice.variants[0].points[-NB_LEVEL_LOW].updates, 36.0, 1e-12);
  finish(&it);
}

/* Three runs of 8, 24 and 16 cycles, with the steps 0.01, 0.03 and 0.02, of two discs in contact. A cycle has three
 * updates, of two particles and of a contact, and the start of a run one of the contact. Each run records its start and
 * its end, in two columns. The ratio of the step to the stable step is dt (k/(2 m))^(1/2), and the second run has the
 * largest one. */
static void the_cost_of_all_runs(void) {
  struct asked it;
  ask(&it, "scene",
      "sweep c 1 3 2\ntrade laws none\nmaterial m density 1 kn 100\ndisc 0 0 radius 1 m\ndisc 1.999 0 radius 1 m\n"
      "monitor D disc 1\nrecord D.x D.y\nstep (0.01*c)\nstage a\nrecord every 1000 cycles\ncycles (8*c)\n",
      "D.y", "1", NULL);
  CU_ASSERT_EQUAL_FATAL(it.status, NB_OK);
  const struct nb_point *own = &it.advice.variants[0].points[-NB_LEVEL_LOW];
  CU_ASSERT_EQUAL(own->updates, 3 * (8 + 24 + 16) + 3);
  CU_ASSERT_EQUAL(own->recorded, 3 * 2 * 2);
  NEAR(own->step, 0.01, 1e-12);
  NEAR(own->stability[0], 0.03 * sqrt(100 / (2 * acos(-1))), 1e-9);
  finish(&it);
}

/* Messages about calls, pages and values: 51 particles of a single run, but not of a mean; a value with an uncertainty of
 * 3 times its step, 0.016*2/4096, in the second run, for the tolerance 1e-6; a name of realizations that is nearly that
 * of the page. */
static void whole_messages(void) {
#define MANY                                                                                                           \
  "let seed = 1\nlet v = seed\nmaterial m density 1 kn 1\nlattice discs 51 by 1 from 1 1 radius 1 spacing 2 m\n"       \
  "step 0.01\nrecord time\nstage a\ncycles 8\n"
  static const struct {
    const char *text, *quantity, *within, *over, *message;
    enum nb_status status;
  } rows[] = {
      {MANY, "time", "1 %", NULL,
       "expected a page of at most 50 particles, found 51: the motion of many particles is chaotic, so the results of "
       "one run have no limit for a step towards zero. A mean over realizations has such a limit: name the seed of "
       "the random packing, `let seed = 1` and `seed $seed`, and add `--over seed`",
       NB_BAD_USE},
      {MANY, "time", "1 %", "seed", "", NB_OK},
      {MANY, "time", "1 %", "sed",
       "expected after --over a name that the page defines by `let` or `sweep`, found `sed`; did you mean `seed`?",
       NB_BAD_USE},
      {MANY, "time", "1 %", "other",
       "expected after --over a name that the page defines by `let` or `sweep`, found `other`", NB_BAD_USE},
      {FLIGHT("", "1"), NULL, "1 %", NULL,
       "the page has no expectation of a single value: name a quantity that it records, by --quantity", NB_BAD_USE},
      {FLIGHT("", "1"), "D.vx", "1 % of peak", NULL,
       "expected a tolerance like `1 %`, or a number in the unit of the quantity", NB_BAD_USE},
      {FLIGHT("", "1"), "D.vx", "0 %", NULL, "expected a tolerance above 0", NB_BAD_USE},
      {FLIGHT("let refine = 2\nlet w = refine\n", "1"), "D.vx", "1 %", NULL,
       "the page has a value named `refine`, which hides --set refine=R: rename this value", NB_BAD_USE},
      {STEPS("trade laws none\nsweep e 1 2 1.5\n", "64"), "step", "1e-6", NULL,
       "`step within 1e-6`: the value is not known well enough: with the step divided by 4096 its uncertainty is 23 "
       "times the tolerance, in run e=2. Choose a larger tolerance, an absolute tolerance if the value is near 0, or "
       "a larger --budget",
       NB_FAILED},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct asked it;
    ask(&it, "scene", rows[k].text, rows[k].quantity, rows[k].within, rows[k].over);
    CU_ASSERT_EQUAL(it.status, rows[k].status);
    CU_ASSERT_STRING_EQUAL(it.error.text, rows[k].message);
    finish(&it);
  }
}

void suite_advice(void) {
  CU_pSuite suite = CU_add_suite("advice", NULL, NULL);
  CU_ADD_TEST(suite, the_anchor_may_have_half_the_tolerance);
  CU_ADD_TEST(suite, variants_near_and_far);
  CU_ADD_TEST(suite, a_variant_that_differs_in_one_run);
  CU_ADD_TEST(suite, levels_of_a_variant_that_costs_as_much);
  CU_ADD_TEST(suite, a_contact_test_trades_its_laws);
  CU_ADD_TEST(suite, a_mean_must_be_known_as_well_as_the_tolerance);
  CU_ADD_TEST(suite, reasons_of_pages_that_cannot_be_run);
  CU_ADD_TEST(suite, the_quantity_of_the_page);
  CU_ADD_TEST(suite, updates_are_the_mean_over_the_trials);
  CU_ADD_TEST(suite, the_cost_of_all_runs);
  CU_ADD_TEST(suite, whole_messages);
}
