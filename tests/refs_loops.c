/* The reference `mindlin_loops` for laws without micro-slip: the spring and slider by hand, the contact test with these
 * laws, and the paths that the reference refuses.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "refs_scenes.h"
#include "suites.h"
#include "written.h"

static const char *const laws[] = {"mindlin", "mindlin_scaled"};
static const double radius = 0.01, young = 210e9, poisson = 0.3, friction = 0.3, normal = 88; /* m, Pa, 1, 1, N */

enum { SEGMENTS = 8 };
struct segment {
  const char *name;
  double normal; /* N; 0: held */
  char kind;     /* 's': slip over the slip at which sliding begins; 't': T/(mu N); 'h': slip is held */
  double target;
  unsigned long steps;
};

/* a, the limit mu N and the slip at which sliding begins, for two equal spheres. */
static double contact_radius(void) {
  return cbrt(3 * normal * (radius / 2) / (4 * young / (2 * (1 - poisson * poisson))));
}
static double first_slide(void) {
  const double shear = young / (2 * (1 + poisson)) / (2 * (2 - poisson)); /* G* */
  return friction * normal / (8 * shear * contact_radius());
}

/* A contact test with these segments; `stages` has one stage for each of them. */
static struct refs_scene loaded(const char *law, const struct segment segments[], size_t count,
                                struct nb_stage stages[]) {
  struct refs_scene it = {0};
  strcpy(it.scene.normal, "hertz"), strcpy(it.scene.shear, law);
  it.materials[0] = (struct nb_material){.name = "a", .young = young, .poisson = poisson, .friction = friction};
  it.particles[0] = it.particles[1] = (struct nb_particle){.shape = NB_SPHERE, .radius = radius};
  for (size_t s = 0; s < count; s++) {
    const struct segment *from = &segments[s];
    struct nb_stage *to = &stages[s];
    *to = (struct nb_stage){.cycles = from->steps};
    strcpy(to->name, from->name);
    to->segment.normal =
        (struct nb_target){.force = true, .relative = !(from->normal > 0), .value = from->normal * normal};
    to->segment.shear = (struct nb_target){from->kind == 't', from->kind == 'h',
                                           from->target * (from->kind == 't' ? friction * normal : first_slide())};
  }
  it.scene.contact_test = true;
  it.scene.material_count = 1, it.scene.particle_count = 2, it.scene.stage_count = count;
  return it;
}

/* Solves the scene of `loaded`. False: it is refused. */
static bool solved(struct nb_solution *solution, const char *law, const struct segment segments[], size_t count) {
  struct nb_stage stages[SEGMENTS];
  struct nb_error error = {0};
  struct refs_scene it = loaded(law, segments, count, stages);
  it.scene.materials = it.materials, it.scene.particles = it.particles, it.scene.stages = stages;
  *solution = (struct nb_solution){0};
  const enum nb_status status = nb_reference_solve(nb_reference_find("mindlin_loops"), solution, &it.scene, &error);
  CU_ASSERT(status == NB_OK || (status == NB_BAD_USE && strstr(error.text, "a normal force that is constant")));
  return status == NB_OK;
}

/* With T in mu N and slip in units of the slip at which sliding begins, T d(slip) is (T d(T)) in the spring and
 * |d(slip)| in the slider. The second half of the runs has the opposite direction. */
static void spring_and_slider(void) {
  struct segment segments[] = {{"press", 1, 'h', 0, 1},     {"part", 0, 's', 0.5, 2},  {"over", 0, 's', 3, 5},
                               {"back", 0, 's', 0, 1},      {"force", 0, 't', 0.5, 4}, {"edge", 0, 't', 1 + 5e-14, 1},
                               {"inside", 0, 's', 1.75, 1}, {"rest", 0, 'h', 0, 1}};
  static const struct {
    const char *name;
    double slip, shear, work, lost;
    bool sticks;
  } ends[] = {{"press", 0, 0, 0, 0, true},
              {"part", 0.5, 0.5, 0.125, 0, true},
              {"over", 3, 1, 2.5, 2, false},
              {"back", 0, -1, 3.5, 3, false},
              {"force", 1.5, 0.5, 3.125, 3, true},
              {"edge", 2, 1, 3.5, 3, false},
              {"inside", 1.75, 0.75, 3.28125, 3, true},
              {"rest", 1.75, 0.75, 3.28125, 3, true}};
  const double limit = friction * normal, slide = first_slide(), a = contact_radius();
  for (int run = 0; run < 4; run++) {
    struct nb_solution solution;
    const double sign = run < 2 ? 1 : -1;
    for (int k = 0; k < SEGMENTS && run == 2; k++)
      segments[k].target *= -1;
    CU_ASSERT_FATAL(solved(&solution, laws[run % 2], segments, SEGMENTS));
    for (int k = 0; k < SEGMENTS; k++) {
      char name[64];
#define AT_END(quantity) (snprintf(name, sizeof name, quantity " in %s", ends[k].name), refs_value(&solution, name))
      REFS_NEAR(AT_END("slip"), sign * ends[k].slip * slide, 1e-12, slide);
      REFS_NEAR(AT_END("shear"), sign * ends[k].shear * limit, 1e-12, limit);
      REFS_NEAR(AT_END("work.shear"), ends[k].work * limit * slide, 1e-12, limit * slide);
      REFS_NEAR(AT_END("dissipated"), ends[k].lost * limit * slide, 1e-12, limit * slide);
      REFS_NEAR(AT_END("radius.stick"), ends[k].sticks ? a : 0, 1e-12, a);
#undef AT_END
    }
    solution_free(&solution);
  }
}

/* Runs a path with shear forces, relative to mu N, or with the slips `slips` at the ends of its segments. The last
 * segment holds the slip. Sets `slips`, and the values at the end. */
enum { VALUES = 5 };
static void loop(const char *law, const double forces[4], double sign, bool by_slip, double slips[4],
                 double values[VALUES]) {
  static const char *const names[VALUES] = {"slip", "shear", "radius.stick", "dissipated", "work.shear"};
  static const char *const segment_names[] = {"first", "second", "third", "fourth"};
  struct segment segments[6] = {{"press", 1, 'h', 0, 1}};
  struct nb_solution solution;
  size_t count = 1;
  for (int k = 0; k < 4 && forces[k] != 0; k++, count++)
    segments[count] = (struct segment){segment_names[k], 0, by_slip ? 's' : 't',
                                       by_slip ? slips[k] / first_slide() : sign * forces[k], 2};
  segments[count++] = (struct segment){"rest", 0, 'h', 0, 1};
  CU_ASSERT_FATAL(solved(&solution, law, segments, count));
  for (size_t k = 0; k + 2 < count; k++) {
    char name[32];
    snprintf(name, sizeof name, "slip in %s", segment_names[k]);
    slips[k] = refs_value(&solution, name);
  }
  for (int k = 0; k < VALUES; k++)
    values[k] = refs_value(&solution, names[k]);
  solution_free(&solution);
}

/* A loop from -0.6 mu N to 0.4 mu N and back is erased: the curve continues as if the contact had gone from 0.8 mu N to
 * -0.7 mu N at once. `randall` stores two reversals, so it goes back on the same curve, without dissipation. */
static void erased_loops(void) {
  static const double direct[4] = {0.8, -0.7}, through[4] = {0.8, -0.6, 0.4, -0.7};
  const double force = friction * normal, slide = first_slide(), work = force * slide;
  for (int k = 0; k < 8; k++) {
    const bool randall = k % 2, by_slip = k / 4;
    const double sign = k / 2 % 2 ? -1 : 1, scales[VALUES] = {slide, force, contact_radius(), work, work};
    const char *const law = randall ? "randall" : "mindlin_deresiewicz";
    double slips[2][4], values[2][VALUES];
    for (int slip = 0; slip <= by_slip; slip++) {
      loop(law, direct, sign, slip, slips[0], values[0]);
      loop(law, through, sign, slip, slips[1], values[1]);
    }
    for (int v = 0; v < (randall ? VALUES : 3); v++)
      REFS_NEAR(values[1][v], values[0][v], 1e-12, scales[v]);
    REFS_NEAR(values[1][1], sign * -0.7 * force, 1e-12, force);
    /* c/a = (1 - (0.8 + 0.7)/2)^(1/3) [R89 3.24] */
    REFS_NEAR(values[1][2], contact_radius() * cbrt(0.25), 1e-12, contact_radius());
  }
}

/* A shear force above mu N has no slip, with every law, in both directions. */
static void no_values_above_the_limit(void) {
  struct segment segments[] = {{"press", 1, 'h', 0, 1}, {"beyond", 0, 't', 1.01, 1}};
  static const char *const all[] = {"mindlin", "mindlin_scaled", "mindlin_deresiewicz", "randall"};
  for (int k = 0; k < 8; k++) {
    struct nb_solution solution;
    segments[1].target = k < 4 ? 1.01 : -1.01;
    CU_ASSERT_FATAL(solved(&solution, all[k % 4], segments, 2));
    CU_ASSERT_PTR_NOT_NULL(solution_find(&solution, "slip in press"));
    CU_ASSERT_PTR_NULL(solution_find(&solution, "slip in beyond"));
    CU_ASSERT_PTR_NULL(solution_find(&solution, "shear in beyond"));
    solution_free(&solution);
  }
}

/* The normal force may increase before there is shear, and not with it or after it. */
static void normal_force_under_shear(void) {
  static const struct segment paths[][3] = {
      {{"press", 0.5, 'h', 0, 3},
       {"more", 1, 'h', 0, 2},
       {"slide", 0, 's', 0.5, 1}}, /* the only one that is accepted */
      {{"press", 0.5, 'h', 0, 3}, {"less", 0.25, 'h', 0, 2}, {"slide", 0, 's', 0.5, 1}},
      {{"press", 0.5, 'h', 0, 3}, {"slide", 0, 's', 0.5, 1}, {"more", 1, 'h', 0, 2}},
      {{"press", 0.5, 'h', 0, 3}, {"slide", 0, 't', 0.5, 1}, {"more", 1, 'h', 0, 2}},
      {{"press", 0.5, 'h', 0, 3}, {"both", 1, 's', 0.5, 1}, {"slide", 0, 's', 0.5, 1}},
      {{"press", 0.5, 'h', 0, 3}, {"both", 1, 't', 0.5, 1}, {"slide", 0, 's', 0.5, 1}},
  };
  static const char *const all[] = {"mindlin", "mindlin_scaled", "mindlin_deresiewicz"};
  for (int law = 0; law < 3; law++)
    for (size_t k = 0; k < sizeof paths / sizeof *paths; k++) {
      struct nb_solution solution;
      CU_ASSERT_EQUAL(solved(&solution, all[law], paths[k], 3), k == 0);
      solution_free(&solution);
    }
}

/* Slip and shear force of the contact test in every step, with many and with few steps. */
static void contact_test_equals_reference(void) {
  static const char *const names[] = {"slip", "shear"};
  for (int k = 0; k < 4; k++) {
    struct words words = {0};
    struct written written;
    struct nb_result result;
    struct nb_solution solution = {0};
    struct nb_error error;
    const int steps = k % 2 ? 1 : 7;
    words_add(&words,
              "path\nmaterial m young 210 GPa poisson 0.3 friction 0.3\ncontact sphere 10 mm m with sphere 10 mm m\n"
              "normal hertz\nshear %s\nrecord step slip shear\nsegment press normal to 88 N in 1 step\n"
              "segment load shear to 20 N hold normal in %d steps\nsegment slide slip by 1 um in %d steps\n"
              "segment back slip by -3 um in %d steps\nsegment on shear to 10 N hold normal in %d steps\n",
              laws[k / 2], steps, steps, steps, steps);
    written_scene(&written, &words);
    written_run(&result, &written, NULL);
    CU_ASSERT_EQUAL_FATAL(nb_reference_solve(nb_reference_find("mindlin_loops"), &solution, &written.scene, &error),
                          NB_OK);
    CU_ASSERT_EQUAL(result.table.row_count, (size_t)(2 + 4 * steps));
    for (int c = 0; c < 2; c++) {
      const struct nb_solution_curve *curve = solution_find_curve(&solution, names[c], "step");
      CU_ASSERT_PTR_NOT_NULL_FATAL(curve);
      for (size_t row = 0; row < result.table.row_count; row++)
        REFS_NEAR(written_cell(&result.table, row, names[c]), curve->at(curve->data, (double)row), 1e-12,
                  c ? 26.4 : 3e-6);
    }
    CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "shear in slide"), 26.4, 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "shear in back"), -26.4, 1e-12);
    solution_free(&solution), nb_result_free(&result), written_free(&written);
  }
}

void suite_refs_loops(void) {
  CU_pSuite suite = CU_add_suite("refs_loops", NULL, NULL);
  CU_add_test(suite, "spring and slider", spring_and_slider);
  CU_add_test(suite, "erased loops", erased_loops);
  CU_add_test(suite, "no values above the limit", no_values_above_the_limit);
  CU_add_test(suite, "normal force under shear", normal_force_under_shear);
  CU_add_test(suite, "contact test equals reference", contact_test_equals_reference);
}
