/* The features of a scene: each statement about particles, laws, loading and stages that gives a scene a feature.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <string.h>

#include "refs_scenes.h"
#include "suites.h"

enum { LINE = 12, LATER = 13 }; /* lines of the page */

/* A scene with two materials, one disc of the first material, and two stages. */
static struct refs_scene plain(void) {
  struct refs_scene it = {0};
  strcpy(it.scene.normal, "linear"), strcpy(it.scene.shear, "linear");
  for (int m = 0; m < 3; m++)
    it.materials[m].line = LINE;
  it.scene.material_count = 2, it.scene.particle_count = 1, it.scene.stage_count = 2;
  it.particles[1].shape = it.particles[0].shape = NB_DISC;
  return it;
}

/* Asserts that the scene has exactly the expected features, each from LINE; HAS_NOTHING ends their list. HAS_DISCS, which
 * all scenes have, is from line 0 unless it is listed. */
static void check_features(struct refs_scene *it, const char *what, const enum nb_feature expected[]) {
  int lines[NB_FEATURES];
  struct nb_scene *scene = &it->scene;
  scene->materials = it->materials, scene->particles = it->particles, scene->walls = it->walls,
  scene->stages = it->stages;
  nb_features(lines, scene);
  for (enum nb_feature f = HAS_NOTHING + 1; f < NB_FEATURES; f++) {
    int wanted = f == HAS_DISCS ? 0 : -1;
    for (int k = 0; expected[k] != HAS_NOTHING; k++)
      wanted = expected[k] == f ? LINE : wanted;
    if (lines[f] != wanted)
      printf("# %s: `%s` on line %d, expected %d\n", what, nb_feature_name(f), lines[f], wanted);
    CU_ASSERT_EQUAL(lines[f], wanted);
  }
}
/* Changes a plain scene, in which `stage` is the second stage, and checks its features. */
#define HAS(change, ...)                                                                                               \
  do {                                                                                                                 \
    struct refs_scene it = plain();                                                                                    \
    struct nb_particle *const particle = &it.particles[0];                                                             \
    struct nb_scene *const scene = &it.scene;                                                                          \
    struct nb_stage *const stage = &it.stages[1];                                                                      \
    (void)particle, (void)scene, (void)stage;                                                                          \
    change;                                                                                                            \
    check_features(&it, #change, (const enum nb_feature[]){__VA_ARGS__});                                              \
  } while (0)

static void features_of_particles_and_walls(void) {
  HAS((void)0, HAS_NOTHING);
  for (int sign = -1; sign < 2; sign += 2) {
    HAS((particle->vx = sign, particle->line = LINE), HAS_DISCS, HAS_VELOCITIES, HAS_NOTHING);
    HAS((particle->vy = sign, particle->line = LINE), HAS_DISCS, HAS_VELOCITIES, HAS_NOTHING);
    HAS((particle->spin = sign, particle->line = LINE), HAS_DISCS, HAS_SPINS, HAS_NOTHING);
    HAS((it.walls->vx = sign, it.walls->line = LINE, scene->wall_count = 1), HAS_WALLS, HAS_MOVING_WALLS, HAS_NOTHING);
    HAS((it.walls->vy = sign, it.walls->line = LINE, scene->wall_count = 1), HAS_WALLS, HAS_MOVING_WALLS, HAS_NOTHING);
    HAS((it.walls->h0 = sign, it.walls->line = LINE, scene->wall_count = 1), HAS_WALLS, HAS_OFFSET_WALLS, HAS_NOTHING);
    HAS((it.walls->spin = sign, it.walls->line = LINE, scene->wall_count = 1), HAS_WALLS, HAS_TURNING_WALLS,
        HAS_NOTHING);
  }
  HAS((particle[1].line = LATER, scene->particle_count = 2), HAS_NOTHING); /* the first disc is from line 0 */
  /* If two particles have a feature, the line of the first one counts. */
  HAS((particle[0].fixed = particle[1].fixed = 3, particle[0].line = LINE, particle[1].line = LATER,
       scene->particle_count = 2),
      HAS_DISCS, HAS_FIXED_PARTICLES, HAS_NOTHING);
}

/* Friction and cohesion are features only of pairs that can touch, and only with a shear law. */
static void features_of_contacts(void) {
  struct nb_change has_friction = {.friction = 1, .line = LINE}, sticks = {.cohesion = 1, .line = LINE};
  struct nb_change swells = {.friction = 0, .cohesion = 0, .ramp = true, .line = LINE};
  HAS(it.materials[0].friction = 1, HAS_FRICTION, HAS_NOTHING);
  HAS(it.materials[0].cohesion = 1, HAS_COHESION, HAS_NOTHING);
  HAS((it.materials[0].friction = 1, strcpy(scene->shear, "none")), HAS_NOTHING);
  HAS((it.materials[0].friction = 1, scene->shear[0] = 0), HAS_NOTHING);
  HAS((it.materials[0].friction = 1, scene->shear[0] = 0, strcpy(it.stages[0].laws.shear, "linear"),
       it.stages[0].laws.shear_line = LINE),
      HAS_LAW_CHANGE, HAS_FRICTION, HAS_NOTHING);
  HAS((it.materials[0].friction = it.materials[0].cohesion = 1, particle->material = 1), HAS_NOTHING);
  HAS((it.materials[0].friction = it.materials[0].cohesion = it.materials[1].friction = it.materials[1].cohesion = 1,
       scene->walls = it.walls, it.walls[0].material = 1, it.walls[0].line = LINE, scene->wall_count = 1),
      HAS_WALLS, HAS_FRICTION, HAS_COHESION, HAS_NOTHING);
  HAS((stage->changes = &has_friction, stage->change_count = 1), HAS_MATERIAL_CHANGE, HAS_FRICTION, HAS_NOTHING);
  HAS((stage->changes = &sticks, stage->change_count = 1), HAS_MATERIAL_CHANGE, HAS_COHESION, HAS_NOTHING);
  HAS((stage[-1].changes = &sticks, stage[-1].change_count = 1), HAS_MATERIAL_CHANGE, HAS_COHESION, HAS_NOTHING);
  HAS((stage->changes = &swells, stage->change_count = 1), HAS_MATERIAL_CHANGE, HAS_RAMP, HAS_NOTHING);
  /* A change of stiffness alone, as the first or the second of two */
  struct nb_change several[2] = {{.friction = NAN, .cohesion = NAN, .line = LINE},
                                 {.friction = NAN, .cohesion = NAN, .line = LATER}};
  HAS((stage->changes = several, stage->change_count = 2), HAS_MATERIAL_CHANGE, HAS_NOTHING);
  several[1] = swells;
  HAS((stage->changes = several, stage->change_count = 2), HAS_MATERIAL_CHANGE, HAS_RAMP, HAS_NOTHING);
  HAS((strcpy(stage->laws.normal, "linear"), stage->laws.normal_line = LINE), HAS_LAW_CHANGE, HAS_NOTHING);
  HAS((stage->laws.pieces = 8, stage->laws.shear_line = LINE), HAS_MEMORY, HAS_NOTHING);
}

/* A rule for two materials applies to two particles, or to a particle and a wall. It does not apply to two walls, which
 * do not touch each other. */
static void features_of_pairs(void) {
  const struct nb_pair_rule rule = {.a = 0, .b = 1, .kn = NAN, .ks = NAN, .friction = 1, .cohesion = 1};
#define BETWEEN(first, second, walled, ...)                                                                            \
  HAS((scene->pair_rules = it.rules, scene->pair_rule_count = 1, it.rules[0] = rule, particle[0].material = first,     \
       particle[1].material = it.walls[0].material = second, scene->particle_count = walled ? 1 : 2,                   \
       scene->wall_count = walled, it.walls[0].line = LINE),                                                           \
      __VA_ARGS__)
  BETWEEN(0, 1, 0, HAS_FRICTION, HAS_COHESION, HAS_NOTHING);
  BETWEEN(0, 0, 0, HAS_NOTHING);
  BETWEEN(1, 1, 0, HAS_NOTHING);
  BETWEEN(0, 1, 1, HAS_WALLS, HAS_FRICTION, HAS_COHESION, HAS_NOTHING);
  BETWEEN(1, 0, 1, HAS_WALLS, HAS_FRICTION, HAS_COHESION, HAS_NOTHING);
  BETWEEN(1, 1, 1, HAS_WALLS, HAS_NOTHING);
  /* A third particle, or a second wall, of a material without friction changes nothing. */
#define AND_OTHERS(walled)                                                                                             \
  scene->material_count = 3, scene->pair_rules = it.rules, scene->pair_rule_count = 1, it.rules[0] = rule,             \
  particle[1].material = it.walls[0].material = 1, particle[2].material = it.walls[1].material = 2,                    \
  particle[2].shape = NB_DISC, scene->particle_count = (walled) ? 1 : 3, scene->wall_count = (walled) ? 2 : 0,         \
  it.walls[0].line = LINE, it.walls[1].line = LATER
  HAS((AND_OTHERS(false)), HAS_FRICTION, HAS_COHESION, HAS_NOTHING);
  HAS((AND_OTHERS(true)), HAS_WALLS, HAS_FRICTION, HAS_COHESION, HAS_NOTHING);
}

static void features_of_damping(void) {
  for (int kind = 0; kind < 3; kind++) {
    const enum nb_contact_damping kinds[] = {NB_CONTACT_STIFFNESS, NB_CONTACT_R89_FRACTION, NB_CONTACT_RATIO};
    const enum nb_feature feature = (enum nb_feature)(HAS_STIFFNESS_DAMPING + kind);
    struct nb_damping damps = {.contact_kind = kinds[kind], .contact = 0.1, .contact_line = LINE};
    HAS(scene->damping = stage[-1].damping = stage->damping = damps, feature, HAS_NOTHING);
    HAS((stage->damping = damps, stage->line = LINE), feature, HAS_DAMPING_CHANGE, HAS_NOTHING);
    HAS((scene->damping = damps, stage[-1].line = LINE), feature, HAS_DAMPING_CHANGE, HAS_NOTHING);
    HAS((scene->damping = stage[-1].damping = damps, stage->line = LINE), feature, HAS_DAMPING_CHANGE, HAS_NOTHING);
    damps.contact = 0;
    HAS(scene->damping = stage[-1].damping = stage->damping = damps, HAS_NOTHING);
    damps = (struct nb_damping){.walls_separate = true, .walls_kind = kinds[kind], .walls = 0.1, .walls_line = LINE};
    HAS(scene->damping = stage[-1].damping = stage->damping = damps, HAS_WALL_DAMPING, feature, HAS_NOTHING);
  }
  const struct nb_damping none = {.global_kind = NB_GLOBAL_MASS, .global_line = LINE};
  HAS(scene->damping = stage[-1].damping = stage->damping = none, HAS_NOTHING);
}

static void features_of_loading(void) {
  struct nb_wall_motion motion = {.line = LINE}, moves[2] = {{.line = LATER}, {.vx = 1, .removed = true, .line = LINE}};
  struct nb_removal gone[2] = {{.line = LINE}, {.line = LATER}};
  HAS((stage->motions = moves, stage->motion_count = 2), HAS_MOVING_WALLS, HAS_REMOVE_WALL, HAS_NOTHING);
  HAS((stage->removals = gone, stage->removal_count = 2), HAS_REMOVE, HAS_NOTHING);
  for (int sign = -1; sign < 2; sign += 2) {
    for (int k = 0; k < 4; k++) {
      const struct nb_strain_rate strain = {sign * (k == 0), sign * (k == 1), sign * (k == 2), sign * (k == 3), false};
      HAS((stage->affine.strain = strain, stage->affine.line = LINE), HAS_AFFINE_STRAIN, HAS_NOTHING);
      HAS((stage->cell = strain, stage->cell_line = LINE), HAS_CELL_STRAIN, HAS_NOTHING);
      HAS((stage->box = strain, stage->box_line = LINE), HAS_BOX_STRAIN, HAS_NOTHING);
    }
    HAS((scene->gravity.x = sign, scene->gravity.line = LINE), HAS_GRAVITY, HAS_NOTHING);
    HAS((scene->gravity.y = sign, scene->gravity.line = LINE), HAS_GRAVITY, HAS_NOTHING);
    HAS((scene->gravity.central = sign, scene->gravity.line = LINE), HAS_CENTRIPETAL_GRAVITY, HAS_NOTHING);
    HAS((stage->gravity.y = sign, stage->gravity.line = LINE), HAS_GRAVITY_CHANGE, HAS_GRAVITY, HAS_NOTHING);
    HAS((stage->motions = &motion, stage->motion_count = 1, motion.vx = sign), HAS_MOVING_WALLS, HAS_NOTHING);
    HAS((stage->motions = &motion, stage->motion_count = 1, motion.vx = 0, motion.vy = sign), HAS_MOVING_WALLS,
        HAS_NOTHING);
    HAS((stage->motions = &motion, stage->motion_count = 1, motion.vy = 0, motion.spin = sign), HAS_TURNING_WALLS,
        HAS_NOTHING);
    motion.spin = 0;
    HAS((stage->step.value = sign, stage->step.line = LINE), HAS_STEP_CHANGE, HAS_NOTHING);
  }
  HAS((stage->step.kind = (enum nb_step_kind)1, stage->step.line = LINE), HAS_STEP_CHANGE, HAS_NOTHING);
  HAS((scene->step.line = LINE, stage->step.line = LINE), HAS_NOTHING);
  HAS((scene->step.kind = it.stages[0].step.kind = (enum nb_step_kind)1, stage->step.line = LINE), HAS_STEP_CHANGE,
      HAS_NOTHING);
  HAS((stage->gravity.ramp = true, stage->gravity.line = LINE), HAS_GRAVITY_CHANGE, HAS_RAMP, HAS_NOTHING);
  HAS((stage->servo.ramp = true, stage->servo.line = LINE), HAS_SERVO, HAS_RAMP, HAS_NOTHING);
  HAS(stage->cell_line = LINE, HAS_NOTHING); /* a strain of 0 */
  HAS(stage->box_line = LINE, HAS_NOTHING);
  HAS(stage->affine.line = LINE, HAS_NOTHING);
  HAS((stage->affine.accumulated = true, stage->affine.line = LINE), HAS_AFFINE_ACCUMULATED, HAS_NOTHING);
  HAS((stage->affine.twice = true, stage->affine.line = LINE), HAS_AFFINE_TWICE, HAS_NOTHING);
  HAS(stage->circle.line = LINE, HAS_BOUNDARY, HAS_NOTHING);
  HAS(scene->circle.line = LINE, HAS_BOUNDARY, HAS_NOTHING);
  HAS(stage->boundary.line = LINE, HAS_BOUNDARY_STRAIN, HAS_NOTHING);
}

void suite_refs_features(void) {
  CU_pSuite suite = CU_add_suite("refs_features", NULL, NULL);
  CU_add_test(suite, "features of particles and walls", features_of_particles_and_walls);
  CU_add_test(suite, "friction and cohesion, from the start or from a stage", features_of_contacts);
  CU_add_test(suite, "rules for two materials", features_of_pairs);
  CU_add_test(suite, "damping, also of walls and in stages; 0 is no damping", features_of_damping);
  CU_add_test(suite, "strains, gravity, moving walls, steps and ramps", features_of_loading);
}
