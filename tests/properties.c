/* The properties of contacts between two materials: the rules for different materials, `pair`, and changes by
 * stages.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>

#include "../src/core/model.h"
#include "laws/laws_now.h"
#include "suites.h"

/* Numbers such that no product or mean of two of them equals another one. */
static struct nb_material materials[] = {
    {.name = "a", .kn = 3, .ks = 5, .friction = 0.25, .cohesion = 7},
    {.name = "b", .kn = 11, .ks = 13, .friction = 0.5, .cohesion = 2},
};
static const struct nb_pair both = {.kn = 2 * 3. * 11 / 14, .ks = 2 * 5. * 13 / 18, .friction = 0.25, .cohesion = 2};

static struct nb_scene scene_of(struct nb_pair_rule *rules, size_t count) {
  return (struct nb_scene){.materials = materials, .material_count = 2, .pair_rules = rules, .pair_rule_count = count};
}

static void same(struct nb_pair seen, struct nb_pair wanted) {
  CU_ASSERT_EQUAL(seen.kn, wanted.kn);
  CU_ASSERT_EQUAL(seen.ks, wanted.ks);
  CU_ASSERT_EQUAL(seen.friction, wanted.friction);
  CU_ASSERT_EQUAL(seen.cohesion, wanted.cohesion);
}

static void rules_for_two_materials(void) {
  const struct nb_scene scene = scene_of(NULL, 0);
  same(nb_scene_pair(&scene, 0, 1), both);
  same(nb_scene_pair(&scene, 1, 0), both);
  same(nb_scene_pair(&scene, 1, 1), (struct nb_pair){.kn = 11, .ks = 13, .friction = 0.5, .cohesion = 2});
  /* Springs in series: without stiffness if one of them has none, also if both have none. */
  struct nb_material soft[] = {{.name = "c", .ks = 5}, {.name = "d"}};
  const struct nb_scene none = {.materials = soft, .material_count = 2};
  for (int a = 0; a < 2; a++)
    for (int b = 0; b < 2; b++)
      same(nb_scene_pair(&none, a, b), (struct nb_pair){.kn = 0, .ks = a + b == 0 ? 5 : 0});
}

/* `pair` may give any of the four properties. The rules give the others. */
static void pair_replaces_the_rules(void) {
  for (int which = 0; which < 16; which++) {
    struct nb_pair_rule rule = {
        .a = which % 2, .b = 1 - which % 2, .kn = NAN, .ks = NAN, .friction = NAN, .cohesion = NAN};
    const struct nb_scene scene = scene_of(&rule, 1);
    struct nb_pair wanted = both;
    if (which & 1)
      wanted.kn = rule.kn = 17;
    if (which & 2)
      wanted.ks = rule.ks = 19;
    if (which & 4)
      wanted.friction = rule.friction = 0.75;
    if (which & 8)
      wanted.cohesion = rule.cohesion = 23;
    same(nb_scene_pair(&scene, 0, 1), wanted);
    same(nb_scene_pair(&scene, 0, 0), (struct nb_pair){.kn = 3, .ks = 5, .friction = 0.25, .cohesion = 7});
  }
}

/* A stage changes a pair that has a `pair` statement and a pair that has none, at half of a ramp and at its end. */
static void stages_change_pairs(void) {
  struct nb_pair_rule rule = {.a = 0, .b = 0, .kn = 17, .ks = NAN, .friction = NAN, .cohesion = NAN};
  struct nb_change changes[] = {{.a = 0, .b = 0, .kn = 19, .ks = 25, .friction = NAN, .cohesion = NAN},
                                {.a = 1, .b = 0, .kn = NAN, .ks = NAN, .friction = 0.75, .cohesion = 6}};
  struct nb_stage stage = {.changes = changes, .change_count = 2};
  struct nb_scene scene = scene_of(&rule, 1);
  struct nb_properties now = {0};
  scene.stages = &stage, scene.stage_count = 1;
  CU_ASSERT_FATAL(nb_properties_create(&now, &scene));
  const struct nb_pair first = nb_properties_before(&now, &changes[0]),
                       second = nb_properties_before(&now, &changes[1]);
  same(first, (struct nb_pair){.kn = 17, .ks = 5, .friction = 0.25, .cohesion = 7});
  same(second, both);
  nb_properties_change(&now, &changes[0], first, 0.5);
  nb_properties_change(&now, &changes[1], second, 0.5);
  same(nb_properties_pair(&now, 0, 0), (struct nb_pair){.kn = 18, .ks = 15, .friction = 0.25, .cohesion = 7});
  same(nb_properties_pair(&now, 0, 1), (struct nb_pair){.kn = both.kn, .ks = both.ks, .friction = 0.5, .cohesion = 4});
  CU_ASSERT_EQUAL(now.rule_count, 2);
  CU_ASSERT_EQUAL(now.materials[0].kn, 3);
  nb_properties_change(&now, &changes[1], second, 1);
  same(nb_properties_pair(&now, 1, 0), (struct nb_pair){.kn = both.kn, .ks = both.ks, .friction = 0.75, .cohesion = 6});
  CU_ASSERT_EQUAL(now.rule_count, 2);
  nb_properties_free(&now);
  CU_ASSERT_PTR_NULL(now.materials);
  CU_ASSERT_PTR_NULL(now.rules);
}

/* At the end of a ramp the value is exactly the value of the page, whatever the earlier value was. */
static void stages_change_materials(void) {
  struct nb_change change = {.a = 1, .b = -1, .kn = 1e17, .ks = NAN, .friction = 1, .cohesion = 4};
  struct nb_stage stage = {.changes = &change, .change_count = 1};
  struct nb_scene scene = scene_of(NULL, 0);
  struct nb_properties now = {0};
  scene.stages = &stage, scene.stage_count = 1;
  CU_ASSERT_FATAL(nb_properties_create(&now, &scene));
  const struct nb_pair from = nb_properties_before(&now, &change);
  same(from, (struct nb_pair){.kn = 11, .ks = 13, .friction = 0.5, .cohesion = 2});
  nb_properties_change(&now, &change, from, 0.5);
  same(nb_properties_pair(&now, 1, 1),
       (struct nb_pair){.kn = 11 + (1e17 - 11) / 2, .ks = 13, .friction = 0.75, .cohesion = 3});
  nb_properties_change(&now, &change, from, 1);
  CU_ASSERT_EQUAL(now.materials[1].kn, 1e17);
  const struct nb_pair large = nb_properties_before(&now, &change);
  change.kn = 1.1;
  nb_properties_change(&now, &change, large, 1);
  CU_ASSERT_EQUAL(now.materials[1].kn, 1.1);
  CU_ASSERT_EQUAL(now.rule_count, 0);
  nb_properties_free(&now);
}

/* The number of rules is not limited. */
static void many_rules(void) {
  enum { MANY = 1200 };
  static struct nb_pair_rule rules[MANY];
  const struct nb_scene scene = scene_of(rules, MANY);
  struct nb_properties now = {0};
  CU_ASSERT_FATAL(nb_properties_create(&now, &scene));
  CU_ASSERT_EQUAL(now.rule_count, MANY);
  nb_properties_free(&now);
}

/* The number of pieces is the number that the page gives, or else the default of the law; it is 0 for a law without
 * pieces. */
static void pieces_of_history(void) {
  static const struct {
    const char *shear;
    int given;
    double pieces;
  } rows[] = {{"mindlin_deresiewicz", 0, 64}, {"mindlin_deresiewicz", 32, 32}, {"linear", 0, 0}, {"none", 0, 0}};
  for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
    struct nb_scene scene = scene_of(NULL, 0);
    struct nb_properties now = {0};
    snprintf(scene.shear, sizeof scene.shear, "%s", rows[n].shear);
    scene.pieces = rows[n].given;
    CU_ASSERT_FATAL(nb_properties_create(&now, &scene));
    CU_ASSERT_EQUAL(nb_properties_pair(&now, 0, 1).pieces, rows[n].pieces);
    nb_properties_free(&now);
  }
}

/* 1/E* = (1 - nu_a^2)/E_a + (1 - nu_b^2)/E_b;  1/G* = (2 - nu_a)/G_a + (2 - nu_b)/G_b, G = E/2(1 + nu) [R89
 * 4.7-4.10] */
static void elastic(void) {
  struct nb_material elastic[] = {
      {.young = 5, .poisson = 0.25}, {.young = 3, .poisson = 0.5}, {.young = INFINITY, .poisson = 0.4}, {.kn = 1}};
  const struct nb_scene scene = {.materials = elastic, .material_count = 4};
  const double a = (1 - 0.0625) / 5, b = (1 - 0.25) / 3, ga = 1.75 / (5 / 2.5), gb = 1.5 / (3 / 3.);
  CU_ASSERT_DOUBLE_EQUAL(nb_scene_pair(&scene, 0, 1).young, 1 / (a + b), 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(nb_scene_pair(&scene, 1, 0).shear, 1 / (ga + gb), 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(nb_scene_pair(&scene, 0, 2).young, 1 / a, 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(nb_scene_pair(&scene, 2, 1).shear, 1 / gb, 1e-14);
  CU_ASSERT_EQUAL(nb_scene_pair(&scene, 0, 3).young, 0);
  CU_ASSERT_EQUAL(nb_scene_pair(&scene, 3, 1).shear, 0);
}

void suite_properties(void) {
  CU_pSuite suite = CU_add_suite("properties", NULL, NULL);
  CU_add_test(suite, "rules for two materials", rules_for_two_materials);
  CU_add_test(suite, "pair replaces the rules", pair_replaces_the_rules);
  CU_add_test(suite, "stages change pairs", stages_change_pairs);
  CU_add_test(suite, "stages change materials", stages_change_materials);
  CU_add_test(suite, "many rules", many_rules);
  CU_add_test(suite, "pieces of history", pieces_of_history);
  CU_add_test(suite, "effective moduli", elastic);
}
