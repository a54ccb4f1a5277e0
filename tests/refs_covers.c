/* Every reference with every feature of a scene: a reference must refuse the features that it does not list, and name
 * the feature and its line.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <string.h>

#include "refs_scenes.h"
#include "suites.h"

enum {
  LINE = 12, /* line of the page that asks for the feature */
  NEEDS = sizeof((struct nb_reference *)0)->needs / sizeof(enum nb_feature)
};

static bool lists(const enum nb_feature list[], size_t size, enum nb_feature feature) {
  for (size_t k = 0; k < size && list[k] != HAS_NOTHING; k++)
    if (list[k] == feature)
      return true;
  return false;
}

static bool covered(const struct nb_reference *it, enum nb_feature feature) {
  return lists(it->accepts, NB_FEATURES, feature) || lists(it->needs, NEEDS, feature);
}

static void first_word(char to[NB_NAME_SIZE], const char *words, const char *any) {
  if (strcmp(words, NB_ANY_LAW) == 0)
    words = any;
  snprintf(to, NB_NAME_SIZE, "%.*s", (int)strcspn(words, " "), words);
}

/* One particle and two stages. The first stage gets the features that the reference needs, the second one the tested
 * feature. */
static void plain(struct refs_scene *it, const struct nb_reference *reference) {
  memset(it, 0, sizeof *it);
  first_word(it->scene.normal, reference->normal, "linear");
  first_word(it->scene.shear, reference->shear, "none");
  it->scene.materials = it->materials, it->scene.material_count = 1;
  it->scene.particles = it->particles, it->scene.particle_count = 1;
  it->scene.walls = it->walls;
  it->scene.stages = it->stages, it->scene.stage_count = 2;
  it->particles[0].radius = 1;
  it->particles[0].shape = covered(reference, HAS_SPHERES) ? NB_SPHERE : NB_DISC;
}

static void add_to_stage(struct nb_stage *stage, enum nb_feature feature);
static void add_damping(struct nb_damping *it, enum nb_feature feature);

/* Adds a feature to the scene, or to the stage with this index if it is a feature of stages. */
static void add(struct refs_scene *it, enum nb_feature feature, int stage) {
  struct nb_scene *scene = &it->scene;
  struct nb_particle *particle = &it->particles[0];
  switch (feature) {
  case HAS_DISCS:
  case HAS_SPHERES:
    it->particles[1] = *particle, it->particles[1].shape = feature == HAS_DISCS ? NB_DISC : NB_SPHERE,
    it->particles[1].line = LINE;
    scene->particle_count = 2;
    break;
  case HAS_FIXED_PARTICLES:
    particle->fixed = 1, particle->line = LINE;
    break;
  case HAS_VELOCITIES:
    particle->vy = -1, particle->line = LINE;
    break;
  case HAS_SPINS:
    particle->spin = -1, particle->line = LINE;
    break;
  case HAS_IMPACT:
    scene->impact.line = LINE;
    break;
  case HAS_WALLS:
    it->walls[0].line = LINE, scene->wall_count = 1;
    break;
  case HAS_OFFSET_WALLS:
    it->walls[0].h0 = -1, it->walls[0].line = LINE, scene->wall_count = 1;
    break;
  case HAS_CELL:
    scene->cell.line = LINE;
    break;
  case HAS_CONTACT_TEST:
    scene->contact_test = true, it->stages[0].line = LINE; /* of its first segment */
    break;
  case HAS_FRICTION:
  case HAS_COHESION:
    *(feature == HAS_FRICTION ? &it->materials[0].friction : &it->materials[0].cohesion) = 1;
    it->materials[0].line = LINE;
    if (strcmp(scene->shear, "none") == 0)
      strcpy(scene->shear, "linear");
    it->particles[1] = *particle, scene->particle_count = 2;
    break;
  case HAS_MEMORY:
    scene->pieces = 1, scene->shear_line = LINE;
    break;
  case HAS_GRAVITY:
    scene->gravity.y = -1, scene->gravity.line = LINE;
    break;
  case HAS_CENTRIPETAL_GRAVITY:
    scene->gravity.central = 1, scene->gravity.line = LINE;
    break;
  case HAS_BOUNDARY:
    scene->circle.line = LINE;
    break;
  case HAS_START:
    scene->start.stages = 1, scene->start.line = LINE;
    break;
  case HAS_STIFFNESS_DAMPING:
  case HAS_R89_FRACTION_DAMPING:
  case HAS_RATIO_DAMPING:
  case HAS_WALL_DAMPING:
  case HAS_CRITICAL_DAMPING:
  case HAS_CENTRED_DASHPOTS:
  case HAS_MASS_DAMPING:
  case HAS_CON1_CS79:
  case HAS_CON1_VELOCITY:
  case HAS_CON1_ALL:
    /* The scene and all stages get the same damping, because a stage with another damping would have the feature
     * HAS_DAMPING_CHANGE. The exception is a reference that needs a global damping: a CON1 in the scene would replace it,
     * so only one stage gets the CON1. */
    if (scene->damping.global_kind && feature > HAS_MASS_DAMPING) {
      add_damping(&it->stages[stage].damping, feature);
      break;
    }
    add_damping(&scene->damping, feature);
    it->stages[0].damping = it->stages[1].damping = scene->damping;
    break;
  default:
    it->stages[stage].motions = it->motions + stage;
    add_to_stage(&it->stages[stage], feature);
  }
}

static void add_damping(struct nb_damping *it, enum nb_feature feature) {
  static const enum nb_contact_damping contact[] = {NB_CONTACT_STIFFNESS, NB_CONTACT_R89_FRACTION, NB_CONTACT_RATIO};
  static const enum nb_global_damping global[] = {NB_GLOBAL_MASS, NB_GLOBAL_CON1_CS79, NB_GLOBAL_CON1_VELOCITY,
                                                  NB_GLOBAL_CON1_ALL};
  if (feature == HAS_WALL_DAMPING)
    it->walls_separate = true, it->walls_line = LINE;
  else if (feature == HAS_CRITICAL_DAMPING)
    it->deep = 0.1, it->deep_line = LINE;
  else if (feature == HAS_CENTRED_DASHPOTS)
    it->centred = true, it->centred_line = LINE;
  else if (feature < HAS_WALL_DAMPING)
    it->contact_kind = contact[feature - HAS_STIFFNESS_DAMPING], it->contact = 0.1, it->contact_line = LINE;
  else
    it->global_kind = global[feature - HAS_MASS_DAMPING], it->global = 0.1, it->global_line = LINE;
}

static void add_to_stage(struct nb_stage *stage, enum nb_feature feature) {
  static struct nb_change change = {.b = -1, .line = LINE};
  static struct nb_removal removal = {.line = LINE};
  static struct nb_condition condition = {.line = LINE};
  const struct nb_strain_rate strain = {.yx = -1};
  stage->line = LINE;
  switch (feature) {
  case HAS_BOUNDARY_STRAIN:
  case HAS_BOUNDARY_STRESS:
  case HAS_BOUNDARY_NONE:
    stage->boundary.control = feature == HAS_BOUNDARY_STRAIN   ? NB_CONTROL_STRAIN
                              : feature == HAS_BOUNDARY_STRESS ? NB_CONTROL_STRESS
                                                               : NB_CONTROL_NONE;
    stage->boundary.line = LINE;
    break;
  case HAS_AFFINE_STRAIN:
    stage->affine.strain = strain, stage->affine.line = LINE;
    break;
  case HAS_AFFINE_ACCUMULATED:
    stage->affine.accumulated = true, stage->affine.line = LINE;
    break;
  case HAS_AFFINE_TWICE:
    stage->affine.twice = true, stage->affine.line = LINE;
    break;
  case HAS_CELL_STRAIN:
    stage->cell = strain, stage->cell_line = LINE;
    break;
  case HAS_BOX_STRAIN:
    stage->box = strain, stage->box_line = LINE;
    break;
  case HAS_SERVO:
    stage->servo.line = LINE;
    break;
  case HAS_MOVING_WALLS:
    stage->motions[0] = (struct nb_wall_motion){.vx = -1, .line = LINE}, stage->motion_count = 1;
    break;
  case HAS_TURNING_WALLS:
    stage->motions[0] = (struct nb_wall_motion){.spin = -1, .line = LINE}, stage->motion_count = 1;
    break;
  case HAS_ROTATION_OFF:
    stage->rotation = NB_ROTATION_OFF, stage->rotation_line = LINE;
    break;
  case HAS_ZERO_VELOCITIES:
    stage->zero_velocities = true;
    break;
  case HAS_REVERSE_VELOCITIES:
    stage->reverse_velocities = true;
    break;
  case HAS_REMOVE:
    stage->removals = &removal, stage->removal_count = 1;
    break;
  case HAS_REMOVE_WALL:
    stage->motions[0] = (struct nb_wall_motion){.removed = true, .line = LINE}, stage->motion_count = 1;
    break;
  case HAS_UNTIL:
    stage->conditions = &condition, stage->condition_count = 1;
    break;
  case HAS_RAMP:
    stage->motions[0] = (struct nb_wall_motion){.ramp = true, .line = LINE}, stage->motion_count = 1;
    break;
  case HAS_STEP_CHANGE:
    stage->step.value = 1, stage->step.line = LINE;
    break;
  case HAS_DAMPING_CHANGE: /* another kind of damping with the value 0 */
    stage->damping.contact_kind = NB_CONTACT_STIFFNESS;
    break;
  case HAS_LAW_CHANGE:
    strcpy(stage->laws.normal, "linear"), stage->laws.normal_line = LINE;
    break;
  case HAS_GRAVITY_CHANGE:
    stage->gravity.line = LINE;
    break;
  case HAS_MATERIAL_CHANGE:
    stage->changes = &change, stage->change_count = 1;
    break;
  default:
    CU_FAIL("a feature that this test does not know");
  }
}

/* A scene with the features that the reference needs and `feature`. */
static void scene_with(struct refs_scene *it, const struct nb_reference *reference, enum nb_feature feature) {
  plain(it, reference);
  for (int k = 0; k < NEEDS; k++)
    if (reference->needs[k] != HAS_NOTHING && reference->needs[k] != feature)
      add(it, reference->needs[k], 0);
  if (feature != HAS_NOTHING)
    add(it, feature, 1);
}

/* Writes the features that a reference covers, in the order of enum nb_feature. The message cuts a list of more than 200
 * bytes; this list is whole. */
static void list_features(char *list, size_t size, const struct nb_reference *reference) {
  size_t used = 0;
  *list = '\0';
  for (enum nb_feature f = HAS_NOTHING + 1; f < NB_FEATURES; f++)
    if (covered(reference, f))
      used += (size_t)snprintf(list + used, size - used, "%s`%s`", used ? ", " : "", nb_feature_name(f));
}

/* True if the text between "does not cover" and "; it covers" names the feature; with its line unless `line` is 0. */
static bool names_feature(const char *text, enum nb_feature feature, int line) {
  char item[128];
  const char *const begin = strstr(text, " does not cover "), *const end = strstr(text, "; it covers ");
  snprintf(item, sizeof item, "`%s`%s", nb_feature_name(feature), line ? " (line 12)" : "");
  const char *const at = begin ? strstr(begin, item) : NULL;
  return at && end && at < end;
}

/* The features that the reference covers, in its message: after its laws, if the message has them. */
static const char *shown_features(const char *text) {
  const char *at = strstr(text, "; it covers ");
  at = at ? at + strlen("; it covers ") : NULL;
  while (at && strncmp(at, "`normal or", strlen("`normal or")) != 0 &&
         (strncmp(at, "`normal ", strlen("`normal ")) == 0 || strncmp(at, "`shear ", strlen("`shear ")) == 0)) {
    at = strstr(at, ", ");
    at = at ? at + strlen(", ") : NULL;
  }
  return at ? at : "";
}

static void unlisted_features_are_refused(void) {
  for (const struct nb_reference *const *it = nb_references(); *it; it++)
    for (enum nb_feature feature = HAS_NOTHING; feature < NB_FEATURES; feature++) {
      struct refs_scene scene;
      struct nb_error error = {0};
      char begin[128], features[512];
      scene_with(&scene, *it, feature);
      const enum nb_status status = nb_reference_covers(*it, &scene.scene, &error);
      const bool fits = feature == HAS_NOTHING || covered(*it, feature);
      list_features(features, sizeof features, *it);
      snprintf(begin, sizeof begin, "the reference `%s` does not cover ", (*it)->name);
      const char *const cut = strstr(error.text, ", …"), *const shown = shown_features(error.text);
      const size_t compared = cut ? (size_t)(cut - shown) : sizeof features;
      bool as_expected = strncmp(error.text, begin, strlen(begin)) == 0 && names_feature(error.text, feature, LINE) &&
                         strncmp(shown, features, compared) == 0 && (!cut || strlen(features) > 150);
      for (enum nb_feature f = HAS_NOTHING + 1; f < NB_FEATURES; f++)
        as_expected = as_expected && !(covered(*it, f) && names_feature(error.text, f, 0));
      if (status != (fits ? NB_OK : NB_BAD_USE) || (!fits && !as_expected))
        printf("# %s, %s: %s\n", (*it)->name, nb_feature_name(feature), error.text);
      CU_ASSERT_EQUAL(status, fits ? NB_OK : NB_BAD_USE);
      if (!fits)
        CU_ASSERT(as_expected);
    }
}

/* One message has all features and laws that the reference does not cover, each with its line and once. A list that is
 * too long ends in "…". */
static void all_uncovered_words_are_named(void) {
  const struct nb_reference *const reference = nb_reference_find("hertz_impact");
  struct refs_scene scene;
  struct nb_error error = {0};
  CU_ASSERT_PTR_NOT_NULL_FATAL(reference);
  scene_with(&scene, reference, HAS_NOTHING);
  add(&scene, HAS_CELL, 1);
  add(&scene, HAS_SERVO, 1);
  strcpy(scene.scene.normal, "linear");
  scene.scene.normal_line = 1;
  strcpy(scene.stages[0].laws.normal, "linear");
  CU_ASSERT_EQUAL(nb_reference_covers(reference, &scene.scene, &error), NB_BAD_USE);
  const char *const list =
      "`periodic cell` (line 12), `servo` (line 12), `normal or shear in a stage`, `normal linear` (line 1); it "
      "covers `normal hertz`, `normal hertz_increment`, `sphere`, ";
  if (!strstr(error.text, list))
    printf("# %s\n", error.text);
  CU_ASSERT_PTR_NOT_NULL(strstr(error.text, list));
  CU_ASSERT_PTR_NOT_NULL(strstr(error.text, "`impact`"));
  static const enum nb_feature more[] = {HAS_BOUNDARY_STRAIN, HAS_AFFINE_STRAIN, HAS_ROTATION_OFF,       HAS_BOX_STRAIN,
                                         HAS_REMOVE,          HAS_STEP_CHANGE,   HAS_REVERSE_VELOCITIES, HAS_RAMP};
  for (size_t k = 0; k < sizeof more / sizeof *more; k++)
    add(&scene, more[k], 1);
  CU_ASSERT_EQUAL(nb_reference_covers(reference, &scene.scene, &error), NB_BAD_USE);
  const char *const begin = strstr(error.text, "`periodic cell`"), *const end = strstr(
                                                                       error.text, "), …; it covers `normal hertz`, ");
  CU_ASSERT_FATAL(begin && end);
  CU_ASSERT(end - begin > 190 && end - begin < 240); /* at most 239 bytes; no item has more than 45 */
}

static void missing_features_are_refused(void) {
  for (const struct nb_reference *const *it = nb_references(); *it; it++)
    for (int omitted = 0; omitted < NEEDS && (*it)->needs[omitted] != HAS_NOTHING; omitted++) {
      struct refs_scene scene;
      struct nb_error error = {0};
      char expected[512];
      plain(&scene, *it);
      for (int k = 0; k < NEEDS; k++)
        if ((*it)->needs[k] != HAS_NOTHING && k != omitted)
          add(&scene, (*it)->needs[k], 0);
      snprintf(expected, sizeof expected, "the reference `%s` is for a scene with `%s`, and this one has none",
               (*it)->name, nb_feature_name((*it)->needs[omitted]));
      CU_ASSERT_EQUAL(nb_reference_covers(*it, &scene.scene, &error), NB_BAD_USE);
      CU_ASSERT_STRING_EQUAL(error.text, expected);
    }
}

static void other_laws_are_refused(void) {
  for (const struct nb_reference *const *it = nb_references(); *it; it++)
    for (int shear = 0; shear < 2; shear++) {
      struct refs_scene scene;
      struct nb_error error = {0};
      const char *laws = shear ? (*it)->shear : (*it)->normal;
      scene_with(&scene, *it, HAS_NOTHING);
      CU_ASSERT_PTR_NOT_NULL_FATAL(laws);
      strcpy(shear ? scene.scene.shear : scene.scene.normal, "line"); /* the first letters of a name are not accepted */
      scene.scene.normal_line = scene.scene.shear_line = LINE;
      const enum nb_status any = strcmp(laws, NB_ANY_LAW) == 0 ? NB_OK : NB_BAD_USE;
      CU_ASSERT_EQUAL(nb_reference_covers(*it, &scene.scene, &error), any);
      if (any != NB_OK) {
        CU_ASSERT_PTR_NOT_NULL(strstr(error.text, shear ? "`shear line` (line 12)" : "`normal line` (line 12)"));
        CU_ASSERT_STRING_EQUAL(shown_features(error.text), ""); /* only laws are listed */
      }
    }
}

/* A law of any stage, from the line of the stage. */
static void other_laws_in_stages(void) {
  const struct nb_reference *const reference = nb_reference_find("changed_law");
  for (int k = 0; k < 4; k++) {
    struct refs_scene scene;
    struct nb_error error = {0};
    struct nb_laws *const laws = &scene.stages[k / 2].laws;
    scene_with(&scene, reference, HAS_NOTHING);
    strcpy(k % 2 ? laws->shear : laws->normal, "randall");
    laws->normal_line = LINE + k, laws->shear_line = LINE + k + 1;
    CU_ASSERT_EQUAL(nb_reference_covers(reference, &scene.scene, &error), NB_BAD_USE);
    char expected[64];
    snprintf(expected, sizeof expected, "`%s randall` (line %d); it", k % 2 ? "shear" : "normal", LINE + k + k % 2);
    CU_ASSERT_PTR_NOT_NULL(strstr(error.text, expected));
  }
}

static void every_feature_has_a_name(void) {
  for (enum nb_feature a = HAS_NOTHING; a < NB_FEATURES; a++) {
    CU_ASSERT_PTR_NOT_NULL_FATAL(nb_feature_name(a));
    for (enum nb_feature b = HAS_NOTHING; b < a; b++)
      CU_ASSERT_STRING_NOT_EQUAL(nb_feature_name(a), nb_feature_name(b));
  }
}

void suite_refs_covers(void) {
  CU_pSuite suite = CU_add_suite("refs_covers", NULL, NULL);
  CU_add_test(suite, "every feature has a name of its own", every_feature_has_a_name);
  CU_add_test(suite, "features that a reference does not list are refused", unlisted_features_are_refused);
  CU_add_test(suite, "scenes without a needed feature are refused", missing_features_are_refused);
  CU_add_test(suite, "other laws are refused", other_laws_are_refused);
  CU_ADD_TEST(suite, other_laws_in_stages);
  CU_add_test(suite, "one message names all that a reference does not cover", all_uncovered_words_are_named);
}
