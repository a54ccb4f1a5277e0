/* The current materials and pairs: those of the scene at time 0, with all changes that stages have made.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "laws_now.h"

/* The stiffness of two springs in series, 2a and 2b, one for each side of the contact, N/m: 2ab/(a+b). It is a if a =
 * b, and 0 if one of them is 0. */
static double series(double a, double b) { return a == b ? a : 2 * a * b / (a + b); }

static double smaller(double a, double b) { return a < b ? a : b; }

/* (2 - nu)/G with the shear modulus G = E/(2(1 + nu)), 1/Pa [R89 4.9, 4.10]. */
static double shear_compliance(const struct nb_material *a) {
  return 2 * (1 + a->poisson) * (2 - a->poisson) / a->young;
}

static bool matches(const struct nb_pair_rule *rule, int a, int b) {
  return (rule->a == a && rule->b == b) || (rule->a == b && rule->b == a);
}

/* The number that the rule of a pair gives; `otherwise`, the value combined from the two materials, if the rule gives
 * none (NaN). */
static double given(double number, double otherwise) { return isnan(number) ? otherwise : number; }

/* The contact parameters of two materials: those that a rule of the pair gives, the others from both materials. */
static struct nb_pair pair_of(const struct nb_material *materials, const struct nb_pair_rule *rules, size_t rule_count,
                              int material_a, int material_b) {
  const struct nb_material *a = &materials[material_a], *b = &materials[material_b];
  struct nb_pair pair = {
#define ROW(name, shown, unit, range, otherwise, rule, ...) .name = rule(a->name, b->name),
      NB_PAIR_ROWS(ROW)
#undef ROW
  };
  if (a->young > 0 && b->young > 0) { /* 1/infinity is 0: a rigid material adds no compliance */
    pair.young = 1 / ((1 - a->poisson * a->poisson) / a->young + (1 - b->poisson * b->poisson) / b->young);
    pair.shear = 1 / (shear_compliance(a) + shear_compliance(b));
  }
  for (size_t i = 0; i < rule_count; i++) {
    const struct nb_pair_rule *rule = &rules[i];
    if (!matches(rule, material_a, material_b))
      continue;
#define ROW(name, ...) pair.name = given(rule->name, pair.name);
    NB_PAIR_ROWS(ROW)
#undef ROW
  }
  return pair;
}

struct nb_pair nb_scene_pair(const struct nb_scene *scene, int material_a, int material_b) {
  return pair_of(scene->materials, scene->pair_rules, scene->pair_rule_count, material_a, material_b);
}

struct nb_pair nb_properties_pair(const struct nb_properties *now, int material_a, int material_b) {
  struct nb_pair pair = pair_of(now->materials, now->rules, now->rule_count, material_a, material_b);
  pair.pieces = now->pieces;
  return pair;
}

bool nb_properties_create(struct nb_properties *now, const struct nb_scene *scene) {
  size_t most = scene->pair_rule_count;
  for (size_t s = 0; s < scene->stage_count; s++)
    most += scene->stages[s].change_count;
  now->materials = calloc(scene->material_count + 1, sizeof *now->materials);
  now->rules = calloc(most + 1, sizeof *now->rules);
  if (!now->materials || !now->rules) {
    nb_properties_free(now);
    return false;
  }
  if (scene->material_count > 0)
    memcpy(now->materials, scene->materials, scene->material_count * sizeof *now->materials);
  if (scene->pair_rule_count > 0)
    memcpy(now->rules, scene->pair_rules, scene->pair_rule_count * sizeof *now->rules);
  now->rule_count = scene->pair_rule_count;
  now->pieces = nb_law_pieces(nb_law_find("shear", scene->shear), scene->pieces);
  return true;
}

void nb_properties_free(struct nb_properties *now) {
  free(now->materials), free(now->rules);
  *now = (struct nb_properties){0};
}

struct nb_pair nb_properties_before(const struct nb_properties *now, const struct nb_change *change) {
  if (change->b >= 0)
    return nb_properties_pair(now, change->a, change->b);
  const struct nb_material *material = &now->materials[change->a];
#define ROW(name, ...) .name = material->name,
  return (struct nb_pair){NB_PAIR_ROWS(ROW)};
#undef ROW
}

/* The rule of a pair. If there is none, adds a rule without values; nb_properties_create has allocated enough of them
 * for all stages. */
static struct nb_pair_rule *rule_of(struct nb_properties *now, int a, int b) {
  for (size_t i = 0; i < now->rule_count; i++)
    if (matches(&now->rules[i], a, b))
      return &now->rules[i];
  struct nb_pair_rule *rule = &now->rules[now->rule_count++];
#define ROW(name, ...) .name = NAN,
  *rule = (struct nb_pair_rule){.a = a, .b = b, NB_PAIR_ROWS(ROW)};
#undef ROW
  return rule;
}

/* Sets *value between `from` and `to`, the number of the page; at fraction 1 it is exactly `to`. Does nothing if `to`
 * is NaN: the page does not change this value. */
static void interpolate(double *value, double from, double to, double fraction) {
  if (!isnan(to))
    *value = fraction < 1 ? from + (to - from) * fraction : to;
}

void nb_properties_change(struct nb_properties *now, const struct nb_change *to, struct nb_pair from, double fraction) {
  struct nb_material *material = &now->materials[to->a];
  struct nb_pair_rule *rule = to->b >= 0 ? rule_of(now, to->a, to->b) : NULL;
#define ROW(name, ...) interpolate(rule ? &rule->name : &material->name, from.name, to->name, fraction);
  NB_PAIR_ROWS(ROW)
#undef ROW
}

void nb_properties_end_stage(struct nb_properties *now, const struct nb_stage *stage) {
  for (size_t k = 0; k < stage->change_count; k++)
    nb_properties_change(now, &stage->changes[k], nb_properties_before(now, &stage->changes[k]), 1);
}

void nb_properties_apply(struct nb_model *model) {
  for (size_t p = 0; p < model->material_pair_count; p++) {
    struct nb_material_pair *pair = &model->material_pairs[p];
    pair->values = nb_properties_pair(&model->properties, pair->a, pair->b);
  }
}
