/* The features of a scene, and their comparison with those that a reference accepts.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "coverage.h"

#include <string.h>

#include "core/clean.h"
#include "reference.h"

static const char *const names[NB_FEATURES] = {
    [HAS_NOTHING] = "",
    [HAS_DISCS] = "disc",
    [HAS_SPHERES] = "sphere",
    [HAS_FIXED_PARTICLES] = "fixed",
    [HAS_VELOCITIES] = "velocity",
    [HAS_SPINS] = "spin",
    [HAS_IMPACT] = "impact",
    [HAS_WALLS] = "wall",
    [HAS_MOVING_WALLS] = "wall velocity",
    [HAS_TURNING_WALLS] = "wall spin",
    [HAS_OFFSET_WALLS] = "wall about a point off its line",
    [HAS_CELL] = "periodic cell",
    [HAS_CONTACT_TEST] = "contact",
    [HAS_FRICTION] = "friction",
    [HAS_COHESION] = "cohesion",
    [HAS_MEMORY] = "memory",
    [HAS_GRAVITY] = "gravity",
    [HAS_CENTRIPETAL_GRAVITY] = "gravity centripetal",
    [HAS_STIFFNESS_DAMPING] = "damping stiffness",
    [HAS_R89_FRACTION_DAMPING] = "damping r89-fraction",
    [HAS_RATIO_DAMPING] = "damping ratio",
    [HAS_WALL_DAMPING] = "damping walls",
    [HAS_CRITICAL_DAMPING] = "damping critical beyond overlap",
    [HAS_CENTRED_DASHPOTS] = "damping centred",
    [HAS_MASS_DAMPING] = "damping mass",
    [HAS_CON1_CS79] = "damping con1 as cs79",
    [HAS_CON1_VELOCITY] = "damping con1 as velocity",
    [HAS_CON1_ALL] = "damping con1 as all",
    [HAS_BOUNDARY] = "boundary circle",
    [HAS_BOUNDARY_STRAIN] = "boundary strain",
    [HAS_BOUNDARY_STRESS] = "boundary stress",
    [HAS_BOUNDARY_NONE] = "boundary none",
    [HAS_AFFINE_STRAIN] = "affine strain",
    [HAS_AFFINE_ACCUMULATED] = "affine strain accumulated",
    [HAS_AFFINE_TWICE] = "affine strain accumulated-twice",
    [HAS_CELL_STRAIN] = "cell strain",
    [HAS_BOX_STRAIN] = "box strain",
    [HAS_SERVO] = "servo",
    [HAS_START] = "start",
    [HAS_ROTATION_OFF] = "rotation off",
    [HAS_ZERO_VELOCITIES] = "zero velocities",
    [HAS_REVERSE_VELOCITIES] = "reverse velocities",
    [HAS_REMOVE] = "remove",
    [HAS_REMOVE_WALL] = "remove wall",
    [HAS_UNTIL] = "until",
    [HAS_RAMP] = "ramp",
    [HAS_STEP_CHANGE] = "step in a stage",
    [HAS_DAMPING_CHANGE] = "damping in a stage",
    [HAS_LAW_CHANGE] = "normal or shear in a stage",
    [HAS_GRAVITY_CHANGE] = "gravity in a stage",
    [HAS_MATERIAL_CHANGE] = "material or pair in a stage",
};

const char *nb_feature_name(enum nb_feature feature) { return names[feature]; }

/* Keeps the first line that asks for the feature. */
static void note(int lines[], enum nb_feature feature, bool has, int line) {
  if (has && lines[feature] < 0)
    lines[feature] = line;
}

static bool has_law(const char *law) { return law[0] && strcmp(law, "none") != 0; }

static void note_particles(int lines[], const struct nb_scene *scene) {
  for (size_t k = 0; k < scene->particle_count; k++) {
    const struct nb_particle *it = &scene->particles[k];
    note(lines, it->shape == NB_DISC ? HAS_DISCS : HAS_SPHERES, true, it->line);
    note(lines, HAS_FIXED_PARTICLES, it->fixed, it->line);
    note(lines, HAS_VELOCITIES, it->vx != 0 || it->vy != 0, it->line);
    note(lines, HAS_SPINS, it->spin != 0, it->line);
  }
  for (size_t w = 0; w < scene->wall_count; w++) {
    const struct nb_wall *it = &scene->walls[w];
    note(lines, HAS_WALLS, true, it->line);
    note(lines, HAS_MOVING_WALLS, it->vx != 0 || it->vy != 0, it->line);
    note(lines, HAS_TURNING_WALLS, it->spin != 0, it->line);
    note(lines, HAS_OFFSET_WALLS, it->h0 != 0, it->line);
  }
  note(lines, HAS_IMPACT, scene->impact.line, scene->impact.line);
  note(lines, HAS_CELL, scene->cell.line, scene->cell.line);
  note(lines, HAS_CONTACT_TEST, scene->contact_test, scene->stage_count ? scene->stages[0].line : 0);
  note(lines, HAS_START, scene->start.stages > 0, scene->start.line);
}

/* Friction and cohesion, only of pairs of materials that can touch: a particle has the first material, and a particle
 * or a wall has the second. Changes in stages are noted for all pairs, whether or not they can touch. */
static void note_friction(int lines[], const struct nb_scene *scene) {
  for (size_t a = 0; a < scene->material_count; a++)
    for (size_t b = 0; b < scene->material_count; b++) {
      bool first = false, second = false;
      for (size_t k = 0; k < scene->particle_count; k++)
        first = first || scene->particles[k].material == (int)a,
        second = second || scene->particles[k].material == (int)b;
      for (size_t w = 0; w < scene->wall_count; w++)
        second = second || scene->walls[w].material == (int)b;
      const struct matter_pair pair = matter_pair(scene, (int)a, (int)b);
      note(lines, HAS_FRICTION, first && second && pair.friction > 0, scene->materials[a].line);
      note(lines, HAS_COHESION, first && second && pair.cohesion > 0, scene->materials[a].line);
    }
  for (size_t s = 0; s < scene->stage_count; s++)
    for (size_t k = 0; k < scene->stages[s].change_count; k++) {
      const struct nb_change *it = &scene->stages[s].changes[k];
      note(lines, HAS_FRICTION, it->friction > 0, it->line);
      note(lines, HAS_COHESION, it->cohesion > 0, it->line);
    }
}

static void note_contact_damping(int lines[], enum nb_contact_damping kind, double value, int line) {
  note(lines, HAS_STIFFNESS_DAMPING, kind == NB_CONTACT_STIFFNESS && value != 0, line);
  note(lines, HAS_R89_FRACTION_DAMPING, kind == NB_CONTACT_R89_FRACTION && value != 0, line);
  note(lines, HAS_RATIO_DAMPING, kind == NB_CONTACT_RATIO && value != 0, line);
}

static void note_damping(int lines[], const struct nb_damping *it) {
  note_contact_damping(lines, it->contact_kind, it->contact, it->contact_line);
  note_contact_damping(lines, it->walls_separate ? it->walls_kind : NB_CONTACT_UNDAMPED, it->walls, it->walls_line);
  note(lines, HAS_WALL_DAMPING, it->walls_separate, it->walls_line);
  note(lines, HAS_CRITICAL_DAMPING, it->deep > 0, it->deep_line);
  note(lines, HAS_CENTRED_DASHPOTS, it->centred, it->centred_line);
  note(lines, HAS_MASS_DAMPING, it->global_kind == NB_GLOBAL_MASS && it->global != 0, it->global_line);
  note(lines, HAS_CON1_CS79, it->global_kind == NB_GLOBAL_CON1_CS79, it->global_line);
  note(lines, HAS_CON1_VELOCITY, it->global_kind == NB_GLOBAL_CON1_VELOCITY, it->global_line);
  note(lines, HAS_CON1_ALL, it->global_kind == NB_GLOBAL_CON1_ALL, it->global_line);
}

static void note_gravity(int lines[], const struct nb_gravity *it) {
  note(lines, HAS_GRAVITY, it->x != 0 || it->y != 0, it->line);
  note(lines, HAS_CENTRIPETAL_GRAVITY, it->central != 0, it->line);
  note(lines, HAS_RAMP, it->ramp, it->line);
}

static bool strains(const struct nb_strain_rate *it) {
  return it->xx != 0 || it->xy != 0 || it->yx != 0 || it->yy != 0;
}

static void note_loading(int lines[], const struct nb_stage *it) {
  const int boundary = it->boundary.line;
  note(lines, HAS_BOUNDARY, it->circle.line, it->circle.line);
  note(lines, HAS_BOUNDARY_STRAIN, boundary && it->boundary.control == NB_CONTROL_STRAIN, boundary);
  note(lines, HAS_BOUNDARY_STRESS, it->boundary.control == NB_CONTROL_STRESS, boundary);
  note(lines, HAS_BOUNDARY_NONE, it->boundary.control == NB_CONTROL_NONE, boundary);
  note(lines, HAS_AFFINE_STRAIN, strains(&it->affine.strain), it->affine.line);
  note(lines, HAS_AFFINE_ACCUMULATED, it->affine.accumulated, it->affine.line);
  note(lines, HAS_AFFINE_TWICE, it->affine.twice, it->affine.line);
  note(lines, HAS_CELL_STRAIN, strains(&it->cell), it->cell_line);
  note(lines, HAS_BOX_STRAIN, strains(&it->box), it->box_line);
  note(lines, HAS_SERVO, it->servo.line, it->servo.line);
  note(lines, HAS_RAMP, it->servo.ramp, it->servo.line);
}

static void note_changes(int lines[], const struct nb_scene *scene, const struct nb_stage *it) {
  const struct nb_step *step = &it->step;
  note(lines, HAS_ROTATION_OFF, it->rotation == NB_ROTATION_OFF, it->rotation_line);
  note(lines, HAS_ZERO_VELOCITIES, it->zero_velocities, it->line);
  note(lines, HAS_REVERSE_VELOCITIES, it->reverse_velocities, it->line);
  note(lines, HAS_UNTIL, it->condition_count > 0, it->condition_count ? it->conditions[0].line : 0);
  note(lines, HAS_REMOVE, it->removal_count > 0, it->removal_count ? it->removals[0].line : 0);
  note(lines, HAS_STEP_CHANGE, step->kind != scene->step.kind || step->value != scene->step.value, step->line);
  note(lines, HAS_DAMPING_CHANGE, !nb_damping_equal(&it->damping, &scene->damping), it->line);
  note(lines, HAS_GRAVITY_CHANGE, it->gravity.line, it->gravity.line);
  note(lines, HAS_MATERIAL_CHANGE, it->change_count > 0, it->change_count ? it->changes[0].line : 0);
  note(lines, HAS_LAW_CHANGE, it->laws.normal[0], it->laws.normal_line);
  note(lines, HAS_LAW_CHANGE, it->laws.shear[0], it->laws.shear_line);
  note(lines, HAS_MEMORY, it->laws.pieces, it->laws.shear_line);
  for (size_t k = 0; k < it->change_count; k++)
    note(lines, HAS_RAMP, it->changes[k].ramp, it->changes[k].line);
  for (size_t k = 0; k < it->motion_count; k++) {
    const struct nb_wall_motion *motion = &it->motions[k];
    note(lines, HAS_REMOVE_WALL, motion->removed, motion->line);
    note(lines, HAS_MOVING_WALLS, motion->vx != 0 || motion->vy != 0, motion->line);
    note(lines, HAS_TURNING_WALLS, motion->spin != 0, motion->line);
    note(lines, HAS_RAMP, motion->ramp, motion->line);
  }
}

void nb_features(int lines[NB_FEATURES], const struct nb_scene *scene) {
  bool shears = has_law(scene->shear);
  for (int f = 0; f < NB_FEATURES; f++)
    lines[f] = -1;
  note_particles(lines, scene);
  note_damping(lines, &scene->damping);
  note_gravity(lines, &scene->gravity);
  note(lines, HAS_BOUNDARY, scene->circle.line, scene->circle.line);
  note(lines, HAS_MEMORY, scene->pieces, scene->shear_line);
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    note_damping(lines, &stage->damping);
    note_gravity(lines, &stage->gravity);
    note_loading(lines, stage);
    note_changes(lines, scene, stage);
    shears = shears || has_law(stage->laws.shear);
  }
  if (shears)
    note_friction(lines, scene);
}

static bool lists(const enum nb_feature list[], enum nb_feature feature) {
  for (int k = 0; list[k] != HAS_NOTHING; k++)
    if (list[k] == feature)
      return true;
  return false;
}

/* Whether the law is one of `laws`, names separated by spaces. An empty name stands for "unchanged". */
static bool lists_law(const char *laws, const char *law) {
  const size_t length = strlen(law);
  if (length == 0 || strcmp(laws, NB_ANY_LAW) == 0)
    return true;
  for (const char *at = laws; *at; at += strcspn(at, " "), at += strspn(at, " "))
    if (strcspn(at, " ") == length && strncmp(at, law, length) == 0)
      return true;
  return false;
}

/* Appends "`normal hertz`, `normal linear`" to a list, or the same for `shear`. */
static void append_laws(char *list, size_t size, const char *kind, const char *laws) {
  for (const char *at = laws; *at; at += strcspn(at, " "), at += strspn(at, " "))
    nb_append(list, size, "%s`%s%.*s`", *list ? ", " : "", kind, (int)strcspn(at, " "), at);
}

/* What a scene has and a reference does not cover. */
struct uncovered {
  char list[240];
  bool more, feature, normal, shear; /* `more`: some that the list has no room for; which kinds are in the list */
};

/* Appends "`until` (line 17)" unless the list has it. */
static void append_uncovered(struct uncovered *it, const char *kind, const char *what, int line) {
  char item[sizeof it->list];
  snprintf(item, sizeof item, "`%s%s`", kind, what);
  if (strstr(it->list, item) || it->more)
    return;
  if (line > 0)
    nb_append(item, sizeof item, " (line %d)", line);
  it->more = strlen(it->list) + strlen(item) + sizeof ", , …" > sizeof it->list;
  nb_append(it->list, sizeof it->list, "%s%s", *it->list ? ", " : "", it->more ? "…" : item);
}

static void find_laws(struct uncovered *it, const struct nb_reference *reference, const char *normal, int normal_line,
                      const char *shear, int shear_line) {
  if (!lists_law(reference->normal, normal))
    append_uncovered(it, "normal ", normal, normal_line), it->normal = true;
  if (!lists_law(reference->shear, shear))
    append_uncovered(it, "shear ", shear, shear_line), it->shear = true;
}

static void find_uncovered(struct uncovered *it, const struct nb_reference *reference, const int lines[NB_FEATURES],
                           const struct nb_scene *scene) {
  for (enum nb_feature f = HAS_NOTHING + 1; f < NB_FEATURES; f++)
    if (lines[f] >= 0 && !lists(reference->needs, f) && !lists(reference->accepts, f))
      append_uncovered(it, "", names[f], lines[f]), it->feature = true;
  find_laws(it, reference, scene->normal, scene->normal_line, scene->shear, scene->shear_line);
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_laws *laws = &scene->stages[s].laws;
    find_laws(it, reference, laws->normal, laws->normal_line, laws->shear, laws->shear_line);
  }
}

/* Lists what the reference covers, of the kinds of which the scene has something else. A list of features that does not
 * fit ends in "…". */
static void list_covered(char *list, size_t size, const struct nb_reference *reference, const struct uncovered *it) {
  *list = '\0';
  if (it->normal)
    append_laws(list, size, "normal ", reference->normal);
  if (it->shear)
    append_laws(list, size, "shear ", reference->shear);
  for (enum nb_feature f = HAS_NOTHING + 1; f < NB_FEATURES && it->feature; f++) {
    if (!lists(reference->needs, f) && !lists(reference->accepts, f))
      continue;
    if (strlen(list) + strlen(names[f]) + sizeof ", ``, …" > size) {
      nb_append(list, size, ", …");
      return;
    }
    nb_append(list, size, "%s`%s`", *list ? ", " : "", names[f]);
  }
}

enum nb_status nb_reference_covers(const struct nb_reference *reference, const struct nb_scene *scene,
                                   struct nb_error *error) {
  struct uncovered uncovered = {0};
  char covered[200];
  int lines[NB_FEATURES];
  nb_features(lines, scene);
  find_uncovered(&uncovered, reference, lines, scene);
  if (*uncovered.list) {
    list_covered(covered, sizeof covered, reference, &uncovered);
    return nb_error_set(error, NB_BAD_USE, "the reference `%s` does not cover %s; it covers %s", reference->name,
                        uncovered.list, covered);
  }
  for (enum nb_feature f = HAS_NOTHING + 1; f < NB_FEATURES; f++)
    if (lines[f] < 0 && lists(reference->needs, f))
      return nb_error_set(error, NB_BAD_USE, "the reference `%s` is for a scene with `%s`, and this one has none",
                          reference->name, names[f]);
  return NB_OK;
}
