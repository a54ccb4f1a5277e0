/* The hooks of a cycle: the actions of a scene besides motion, search and force calculation. The list has only the
 * hooks that the scene needs in its current stage.
 *
 * The hooks run in the order of the table. The order matters: the energy balance reads the forces before and after the
 * motion, the boundary gets its velocities before the particles move, and a stage changes properties before the search.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <assert.h>

#include "loading/loading.h"
#include "measure/configuration.h"
#include "measure/energy.h"
#include "measure/step.h"
#include "plan.h"

/* Hooks that cannot fail. */
#define HOOK(name, action)                                                                                             \
  static enum nb_status name(struct nb_model *model, struct nb_error *error) {                                         \
    (void)error;                                                                                                       \
    action;                                                                                                            \
    return NB_OK;                                                                                                      \
  }
HOOK(move_walls, nb_stage_set_wall_velocities(model))
HOOK(apply_servo, nb_servo_apply(model))
HOOK(strain_box, nb_box_set_velocities(model))
HOOK(balance_before_motion, nb_balance_before_motion(model))
HOOK(balance_after_motion, nb_balance_after_motion(model))
HOOK(balance_after_forces, nb_balance_after_forces(model))
HOOK(apply_boundary_stress, nb_boundary_after_motion(model))
HOOK(record_first_deep, nb_deep_record_first(model))
HOOK(update_fracc, nb_fracc_after_forces(model))
HOOK(add_slip, nb_configuration_add_slip(model))

/* Prepares the affine motion of the step. If it does not include all particles, sets the velocities of the boundary
 * separately. */
static enum nb_status move_affinely(struct nb_model *model, struct nb_error *error) {
  (void)error;
  if (!nb_affine_step(model) && model->boundary)
    nb_boundary_set_velocities(model);
  return NB_OK;
}

static enum nb_status make_changes(struct nb_model *model, struct nb_error *error) {
  const bool contacts = model->balance && nb_stage_changes_contacts(model);
  if (contacts)
    nb_balance_change(model, true);
  if (nb_stage_change(model, error))
    return error->status;
  if (contacts)
    nb_balance_change(model, false);
  return NB_OK;
}

/* Checks the stability of the step and the resolution of the coordinates after each search, and every
 * NB_STABILITY_CYCLES cycles. */
static enum nb_status check_stability(struct nb_model *model, struct nb_error *error) {
  if (model->search.last_cycle != model->cycle && model->cycle % NB_STABILITY_CYCLES != 0)
    return NB_OK;
  if (nb_stability_check(model, error))
    return error->status;
  nb_guard_resolution(model);
  return NB_OK;
}

/* Checks the stability of the step when a contact has stiffened with its overlap: measure/stability.c. */
static enum nb_status check_stiffening(struct nb_model *model, struct nb_error *error) {
  return nb_stability_overlaps(model) ? NB_OK : nb_stability_check(model, error);
}

/* Defines a function that is true if the scene needs a hook in its current stage. */
#define NEEDED(name, condition)                                                                                        \
  static bool name(const struct nb_model *model) { return condition; }
NEEDED(ramps_walls, nb_stage_ramps_walls(model))
NEEDED(holds_boundary, model->boundary && model->boundary->ring.held)
NEEDED(moves_boundary, model->particles.boundary_force || (holds_boundary(model) && nb_affine_moves(model)))
NEEDED(has_servo, model->affine && model->stage && model->stage->servo.line)
NEEDED(strains_box, nb_box_is_strained(model))
NEEDED(has_balance, model->balance != NULL)
NEEDED(has_affine, nb_affine_moves(model))
NEEDED(changes, nb_stage_changes(model) || !nb_plan_is_current(model) || nb_affine_ends(model))
NEEDED(stiffens, model->blocks.stable_overlap != NULL)
NEEDED(has_elastic_law, model->plan.elastic)
NEEDED(requests_fracc, model->fracc != NULL)
NEEDED(has_reference, model->configuration != NULL)

static const struct {
  enum nb_when when;
  const char *name;
  bool (*needed)(const struct nb_model *model); /* NULL: every stage needs it */
  enum nb_status (*run)(struct nb_model *model, struct nb_error *error);
} table[] = {
    {NB_BEFORE_MOTION, "walls ramp", ramps_walls, move_walls},
    {NB_BEFORE_MOTION, "boundary takes in particles", holds_boundary, nb_boundary_before_motion},
    {NB_BEFORE_MOTION, "servo", has_servo, apply_servo},
    {NB_BEFORE_MOTION, "walls of the box follow its strain rate", strains_box, strain_box},
    {NB_BEFORE_MOTION, "energy balance", has_balance, balance_before_motion},
    {NB_BEFORE_MOTION, "affine motion", has_affine, move_affinely},
    {NB_AFTER_MOTION, "energy balance", has_balance, balance_after_motion},
    {NB_AFTER_MOTION, "strain and stress of the boundary", moves_boundary, apply_boundary_stress},
    {NB_BEFORE_SEARCH, "changes of the stage", changes, make_changes},
    {NB_BEFORE_FORCES, "stability check", NULL, check_stability},
    {NB_AFTER_FORCES, "stability check of stiffening contacts", stiffens, check_stiffening},
    {NB_AFTER_FORCES, "count of deep overlaps", has_elastic_law, record_first_deep},
    {NB_AFTER_FORCES, "FRACC", requests_fracc, update_fracc},
    {NB_AFTER_FORCES, "sliding since a stage", has_reference, add_slip},
    {NB_AFTER_FORCES, "energy balance", has_balance, balance_after_forces},
};

/* True if some particle rotates or may begin to rotate. Without shear forces no particle begins to rotate. */
static bool rotates(const struct nb_model *model) {
  bool any = model->rotates && model->plan.has_friction;
  for (size_t i = 0; i < model->particles.count && model->particles.spin && !any; i++)
    any = model->particles.spin[i] != 0;
  return any && model->particles.spin;
}

void nb_hooks_plan(struct nb_model *model) {
  model->plan.rotates = rotates(model);
  for (int when = 0; when < NB_WHENS; when++)
    model->hooks[when].count = 0;
  for (size_t k = 0; k < sizeof table / sizeof *table; k++) {
    struct nb_hooks *list = &model->hooks[table[k].when];
    if (table[k].needed && !table[k].needed(model))
      continue;
    assert(list->count < NB_HOOKS);
    list->list[list->count++] = (struct nb_hook){table[k].name, table[k].run};
  }
}
