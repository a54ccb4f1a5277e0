/* Materials and pairs of materials, in the scene and in stages: `material`, `pair`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "statement.h"

/* ---- arguments ---- */

enum {
  AT_NAME,
  AT_OTHER,
  AT_DENSITY,
#define ROW(name, ...) AT_##name,
  NB_PAIR_ROWS(ROW)
#undef ROW
      AT_YOUNG,
  AT_POISSON,
  AT_RIGID
};

/* clang-format off */
#define PAIR_CLAUSE(name, shown, unit, range, otherwise, help) \
  CLAUSE(#name, shown, NB_UNIT_##unit, NB_##range, AT_##name, 1, otherwise, help),
#define OF_MATERIAL(name, shown, unit, range, otherwise, rule, help) PAIR_CLAUSE(name, shown, unit, range, otherwise, help ALSO_##rule)
#define ALSO_series " Between two materials: 2ab/(a+b)."
#define ALSO_smaller " Between two materials: the smaller value."
#define OF_PAIR(name, shown, unit, range, otherwise, rule, help) PAIR_CLAUSE(name, shown, unit, range, MAKES_##rule, help)
#define OF_CHANGE(name, shown, unit, range, otherwise, rule, help) PAIR_CLAUSE(name, shown, unit, range, "|as it was", help)
#define MAKES_series "2ab/(a+b) of the two values a and b, which is a if they are equal"
#define MAKES_smaller "the smaller of the two values"
#define TWO MATERIAL(AT_NAME), MATERIAL(AT_OTHER)

static const struct nb_argument material_fields[] = {
  NAME(AT_NAME, "a name for the material"),
  CLAUSE("density", "D", NB_UNIT_DENSITY, NB_NOT_NEGATIVE, AT_DENSITY, 1, "0",
         "Mass per volume; a free particle needs it. A disc is 1 m thick, so its mass is D pi R^2 times 1 m; that of a sphere is D 4/3 pi R^3."),
  NB_PAIR_ROWS(OF_MATERIAL)
  CLAUSE("young", "E", NB_UNIT_PRESSURE, NB_POSITIVE, AT_YOUNG, 1, "none",
         "Young's modulus, for the laws of elastic spheres [R89 4.7]."),
  CLAUSE("poisson", "NU", NB_UNIT_NUMBER, NB_HALF, AT_POISSON, 1, "0", "Poisson's ratio."),
  FLAG("rigid", AT_RIGID, "elastic", "Infinite Young's modulus: only the other particle or wall is deformed."),
  END
};
static const struct nb_argument pair_fields[] = {TWO, NB_PAIR_ROWS(OF_PAIR) END};
static const struct nb_argument material_change_fields[] = {
  WORD("NAME", AT_NAME, "the name of a material"), NB_PAIR_ROWS(OF_CHANGE) END
};
static const struct nb_argument pair_change_fields[] = {TWO, NB_PAIR_ROWS(OF_CHANGE) END};
/* clang-format on */

/* ---- in the scene ---- */

int nb_material_of(const struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *token) {
  return NB_NAMED(reader, token, scene->materials, scene->material_count, "the name of a material",
                  reader->starts ? "a page that starts from another has the materials of that page only"
                                 : "define it above with `material NAME …`");
}

NB_APPLY(apply_material) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_value *value = record->value;
  const struct nb_token *name = value[AT_NAME].token;
  const int same = NB_FIND(scene->materials, scene->material_count, name->text);
  if (nb_exists(reader, name, "material", same < 0 ? 0 : scene->materials[same].line) ||
      nb_too_many(reader, scene->material_count, NB_MATERIALS_MAX, "materials"))
    return;
  struct nb_material one = {
      .density = value[AT_DENSITY].number,
#define ROW(name, ...) .name = value[AT_##name].number,
      NB_PAIR_ROWS(ROW)
#undef ROW
          .young = value[AT_RIGID].token ? INFINITY : value[AT_YOUNG].number,
      .poisson = value[AT_POISSON].number,
      .line = (int)reader->line,
  };
  snprintf(one.name, sizeof one.name, "%s", name->text);
  if (value[AT_RIGID].token && value[AT_YOUNG].token)
    nb_token_mistake(reader, value[AT_RIGID].token, NULL, "expected `rigid` or `young`, found both");
  else
    NB_APPEND(reader, scene->materials, scene->material_count, one);
}

static double given(const struct nb_value *value) { return value->token ? value->number : NAN; }

NB_APPLY(apply_pair) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_value *value = record->value;
  struct nb_pair_rule rule = {
      .a = nb_material_of(scene, reader, value[AT_NAME].token),
      .b = nb_material_of(scene, reader, value[AT_OTHER].token),
#define ROW(name, ...) .name = given(&value[AT_##name]),
      NB_PAIR_ROWS(ROW)
#undef ROW
          .line = (int)reader->line,
  };
  for (size_t i = 0; i < scene->pair_rule_count; i++) {
    const struct nb_pair_rule *other = &scene->pair_rules[i];
    if ((other->a == rule.a && other->b == rule.b) || (other->a == rule.b && other->b == rule.a))
      nb_token_mistake(reader, &reader->tokens[0], NULL, "this pair is defined already, on line %d", other->line);
  }
  if (!reader->bad)
    NB_APPEND(reader, scene->pair_rules, scene->pair_rule_count, rule);
}

/* ---- in a stage ---- */

/* The first property that both changes set; NULL: none. */
static const char *common_property(const struct nb_change *a, const struct nb_change *b) {
#define ROW(name, ...)                                                                                                 \
  if (!isnan(a->name) && !isnan(b->name))                                                                              \
    return #name;
  NB_PAIR_ROWS(ROW)
#undef ROW
  return NULL;
}

/* An earlier change of the same property in this stage; NULL: none. */
static const struct nb_change *changed_already(const struct nb_stage *stage, const struct nb_change *change) {
  for (size_t i = 0; i < stage->change_count; i++) {
    const struct nb_change *other = &stage->changes[i];
    const bool same = other->a == change->a && other->b == change->b;
    const bool swapped = other->a == change->b && other->b == change->a;
    if ((same || swapped) && common_property(other, change))
      return other;
  }
  return NULL;
}

/* variant 0: `material`, 1: `pair` */
NB_APPLY(apply_change) {
  const struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  struct nb_stage *stage = nb_current_stage(scene);
  const struct nb_value *value = record->value;
  struct nb_change change = {
      .a = nb_material_of(scene, reader, value[AT_NAME].token),
      .b = record->keyword->variant ? nb_material_of(scene, reader, value[AT_OTHER].token) : -1,
#define ROW(name, ...) .name = given(&value[AT_##name]),
      NB_PAIR_ROWS(ROW)
#undef ROW
          .ramp = reading->ramping,
      .line = (int)reader->line,
  };
  const struct nb_change *other = changed_already(stage, &change);
  if (other)
    nb_token_mistake(reader, &reader->tokens[0], "change each property at most once in a stage",
                     "this stage changes `%s` of this %s already, on line %d", common_property(other, &change),
                     record->keyword->variant ? "pair" : "material", other->line);
  if (!reader->bad)
    NB_APPEND(reader, stage->changes, stage->change_count, change);
}

/* clang-format off */
NB_STATEMENTS(material) = {
  {"material", NB_IN_SCENE | NB_IN_CONTACT_TEST, material_fields, NULL, 0, false, apply_material,
   "Defines a material of particles and walls. Stiffness, friction and cohesion are those of a contact between two particles of this material: the contact has the full `kn` and `ks`, not half of them as with two springs in series (PFC). A contact between two materials with the stiffnesses a and b has 2ab/(a+b), unless `pair` gives it. --set soften=S divides `kn`, `ks` and `young` of all materials and pairs by S.",
   "material  steel  density 7.8 g/cm3  kn 10 MN/m  ks 8 MN/m  friction $grip\nmaterial  glass  density 2.5 g/cm3  kn 5 MN/m   ks 4 MN/m  friction 0.2"},
  {"pair", NB_IN_SCENE | NB_IN_CONTACT_TEST, pair_fields, NULL, 0, false, apply_pair,
   "Defines properties of contacts between two materials. A property that is not given follows from the two materials: the stiffness is the harmonic mean of their stiffnesses, and friction and cohesion are the smaller of their values.",
   "pair      steel glass  friction 0.1"},
  {"material", NB_IN_STAGE | NB_IN_RAMP | NB_IN_START, material_change_fields, NULL, 0, false, apply_change,
   "Changes a material from this stage on. Properties that are not given keep their values.",
   "  material glass  friction 0.4"},
  {"pair", NB_IN_STAGE | NB_IN_RAMP | NB_IN_START, pair_change_fields, NULL, 1, false, apply_change,
   "Changes the contacts of two materials from this stage on. Properties that are not given keep their values.",
   "  pair    steel glass  cohesion 1 N"},
  {0},
};
/* clang-format on */
