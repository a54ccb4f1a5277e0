/* The plan: the passes that the contacts of each material pair need in a stage, and no others.
 *
 * The forces at the beginning of a stage are those of the previous stage. A stage that needs another plan makes it
 * between the motion and the force calculation (stage.c): in its first cycle, or, if a ramp takes a friction to 0, in
 * its last cycle.
 *
 * A contact without friction and cohesion has no tangential increment and no shear force. If it has no dashpots either,
 * it has no normal increment, unless its normal law needs it. A field that nothing reads later is not kept. `nineball
 * explain` prints the plan.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "laws/law.h"
#include "laws/laws_now.h"
#include "measure/configuration.h"
#include "pass/pass.h"
#include "plan.h"
#include "state.h"

static void add_pass(struct nb_material_pair *material_pair, nb_run_pass *run, int line, const char *kind,
                     const char *name) {
  struct nb_planned *planned = &material_pair->passes[material_pair->pass_count++];
  planned->run = run, planned->line = line;
  snprintf(planned->name, sizeof planned->name, "%s%s", kind, name);
}

static bool uses_damping_ratio(const struct nb_damping *damping) {
  double value;
  return nb_damping_at(damping, false, &value) == NB_CONTACT_RATIO ||
         nb_damping_at(damping, true, &value) == NB_CONTACT_RATIO;
}

static enum nb_dashpot_kind dashpot_kind(const struct nb_damping *damping) {
  return damping->deep > 0                      ? NB_DASHPOTS_DEEP
         : uses_damping_ratio(damping)          ? NB_DASHPOTS_RATIO
         : nb_damping_contact_line(damping) > 0 ? NB_DASHPOTS_TIME
                                                : NB_DASHPOTS_NONE;
}

static bool affine_twice(const struct nb_model *model) { return model->affine && model->affine->twice; }

/* True if the normal stiffness depends only on the overlap and grows with it, and the shear stiffness is at most a
 * fixed multiple of the normal stiffness. This holds for the laws of elastic spheres, except for the normal law by
 * increments. */
static bool stiffens(const struct nb_law *normal, const struct nb_law *shear) {
  return normal->elastic && !normal->incremental && (shear->elastic || strcmp(shear->name, "none") == 0);
}

/* What the geometry pass must compute for the other passes of the material pair. */
static enum nb_approach needed_approach(const struct nb_model *model, const struct nb_material_pair *material_pair) {
  const bool dn = model->plan.dashpots || (material_pair->normal->needs & NB_BIT(NB_NORMAL_INCREMENT));
  return material_pair->shear ? NB_APPROACH_TANGENTIAL : dn ? NB_APPROACH_NORMAL : NB_APPROACH_OVERLAP;
}

static const struct nb_pass *geometry_pass(const struct nb_model *model, const struct nb_material_pair *material_pair) {
  const enum nb_approach approach = needed_approach(model, material_pair);
  return material_pair->wall ? &nb_pass_disc_wall[approach]
         : model->cell       ? &nb_pass_periodic[approach]
                             : &nb_pass_disc_disc[approach];
}

/* Adds the pass of `affine strain … accumulated-twice`, if another pass reads the increments. It adds the imposed
 * velocity a second time to the increments of contacts between particles. */
static void add_affine_twice(struct nb_model *model, struct nb_material_pair *material_pair) {
  const enum nb_approach approach = needed_approach(model, material_pair);
  const struct nb_pass *again = &nb_pass_affine_twice[approach == NB_APPROACH_TANGENTIAL];
  if (model->plan.affine_twice && !material_pair->wall && approach != NB_APPROACH_OVERLAP)
    add_pass(material_pair, again->run[model->machine.isa], 0, "", again->name);
}

static void plan_material_pair(struct nb_model *model, struct nb_material_pair *material_pair) {
  const struct nb_law *normal = model->laws.normal, *shear = model->laws.shear;
  material_pair->normal = normal;
  material_pair->shear = nb_has_friction(material_pair->values) && strcmp(shear->name, "none") != 0 ? shear : NULL;
  material_pair->pass_count = 0;
  if (stiffens(normal, shear))
    model->plan.kept |= NB_BIT(NB_STABLE_OVERLAP);
  if (model->plan.dashpots == NB_DASHPOTS_RATIO && normal->constant && shear->constant)
    model->plan.kept |= NB_BIT(NB_NORMAL_ROOT) | (material_pair->shear ? NB_BIT(NB_SHEAR_ROOT) : 0);
  else if (model->plan.dashpots >= NB_DASHPOTS_RATIO)
    model->plan.kept |= NB_BIT(NB_MASS);
  const struct nb_pass *geometry = geometry_pass(model, material_pair);
  const struct nb_pass *resolve = &nb_pass_resolve[material_pair->shear != NULL];
  const enum nb_isa isa = model->machine.isa;
  /* The line of `cell` is 0 for a pass of a wall, because a scene with a cell has no walls. */
  add_pass(material_pair, geometry->run[isa], model->scene->cell.line, "", geometry->name);
  if (material_pair->wall && model->vertices.any)
    add_pass(material_pair, nb_pass_vertices.run[isa], 0, "", nb_pass_vertices.name);
  add_affine_twice(model, material_pair);
  add_pass(material_pair, normal->run[isa], model->laws.normal_line, "normal ", normal->name);
  if (material_pair->shear)
    add_pass(material_pair, shear->run[isa], model->laws.shear_line, "shear ", shear->name);
  if (normal->elastic)
    add_pass(material_pair, nb_pass_deep.run[isa], model->damping.deep > 0 ? model->damping.deep_line : 0, "",
             nb_pass_deep.name);
  const struct nb_pass *dashpots = &nb_pass_dashpots[model->plan.centred][model->plan.dashpots];
  if (model->plan.dashpots)
    add_pass(material_pair, dashpots->run[isa], nb_damping_contact_line(&model->damping), "", dashpots->name);
  add_pass(material_pair, resolve->run[isa], 0, "", resolve->name);
}

/* The set `kept` without fields that nothing reads, and without fields that equal other fields. */
static unsigned needed_fields(unsigned kept, bool dissipative, const struct nb_plan *plan) {
  if (!plan->has_friction)
    kept &= ~(NB_BIT(NB_SHEAR_BEFORE) | NB_BIT(NB_SHEAR_STIFFNESS_BEFORE));
  if (!dissipative)
    kept &= ~NB_BIT(NB_DISSIPATED);
  if (!plan->dashpots && kept & NB_BIT(NB_TOTAL_NORMAL)) /* without dashpots the two fields are equal: one is enough */
    kept = (kept & ~NB_BIT(NB_TOTAL_NORMAL)) | NB_BIT(NB_NORMAL);
  return kept & ~NB_BIT(NB_TOTAL_SHEAR); /* the total shear force is stored in the contact force */
}

static int larger(int a, int b) { return a > b ? a : b; }

enum nb_status nb_plan(struct nb_model *model, struct nb_error *error) {
  const struct nb_scene *scene = model->scene;
  struct nb_plan *plan = &model->plan;
  model->vertices.any = nb_vertices_exist(scene);
  plan->elastic = model->laws.normal->elastic;
  plan->history.normal = plan->history.shear = 0;
  plan->history.slip_sum = (int)nb_configuration_count(model->configuration);
  plan->dashpots = dashpot_kind(&model->damping);
  plan->centred = model->damping.centred;
  plan->affine_twice = affine_twice(model);
  plan->kept =
      (plan->requested & (NB_BIT(NB_FIELDS) - 1)) | NB_BIT(NB_RADIUS_SUM) | (plan->keep_all ? NB_SAVED_MASK : 0);
  /* R* is kept if the normal law of any stage is for elastic spheres, because a change of the law computes the stored
   * energy of the old law from it. */
  if (nb_laws_elastic(scene))
    plan->kept |= NB_BIT(NB_REDUCED);
  bool dissipative = false;
  plan->has_friction = false;
  for (size_t p = 0; p < model->material_pair_count; p++) {
    struct nb_material_pair *material_pair = &model->material_pairs[p];
    plan_material_pair(model, material_pair);
    plan->has_friction = plan->has_friction || material_pair->shear;
    dissipative = dissipative || (material_pair->shear && material_pair->shear->dissipative);
    plan->history.normal = larger(plan->history.normal, nb_law_history(material_pair->normal, material_pair->values));
    plan->history.shear = larger(plan->history.shear, nb_law_history(material_pair->shear, material_pair->values));
  }
  plan->kept = needed_fields(plan->kept, dissipative, plan);
  free(model->blocks.scratch);
  model->blocks.scratch = nb_array(nb_most_parts(&model->machine) * NB_FIELDS * NB_BLOCK_SIZE, sizeof(double));
  return model->blocks.scratch ? NB_OK : nb_error_memory(error);
}

bool nb_plan_is_current(const struct nb_model *model) {
  const bool none = strcmp(model->laws.shear->name, "none") == 0;
  for (size_t p = 0; p < model->material_pair_count; p++)
    if (!none && nb_has_friction(model->material_pairs[p].values) != (model->material_pairs[p].shear != NULL))
      return false;
  return model->plan.dashpots == dashpot_kind(&model->damping) && model->plan.centred == model->damping.centred &&
         model->plan.affine_twice == affine_twice(model);
}
