/* The hooks of a cycle: what a scene does in it besides motion, search and forces. What it does not use is not in the list.
 *
 * The order of the table is that of the cycle. It matters: the balances read the forces before the motion and after it, the
 * boundary is moved before the particles, and a stage changes properties before anything is searched for.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <assert.h>

#include "laws/laws_now.h"
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
HOOK(move_walls, nb_stage_drive(model))
HOOK(follow_stress, nb_servo_apply(model))
HOOK(strain_box, nb_box_set_velocities(model))
HOOK(account_before, nb_balance_before_motion(model))
HOOK(account_kick, nb_balance_after_motion(model))
HOOK(account_forces, nb_balance_after_forces(model))
HOOK(press, nb_boundary_after_motion(model))
HOOK(count_deep, nb_deep_record_first(model))
HOOK(find_fracc, nb_fracc_after_forces(model))
HOOK(count_slid, nb_configuration_add_slip(model))

/* Where the step does not carry all particles, those of the boundary are. */
static enum nb_status affine_along(struct nb_model *model, struct nb_error *error) {
  (void)error;
  if (!nb_affine_step(model) && model->boundary)
    nb_boundary_set_velocities(model);
  return NB_OK;
}

static enum nb_status change(struct nb_model *model, struct nb_error *error) {
  if (model->balance)
    nb_balance_change(model, true);
  const enum nb_status status = nb_stage_change(model, error);
  if (model->balance && !status)
    nb_balance_change(model, false);
  return status;
}

/* After each search, and now and then without one. */
static enum nb_status monitor(struct nb_model *model, struct nb_error *error) {
  if (model->search.last_cycle != model->cycle && model->cycle % NB_STABILITY_CYCLES != 0)
    return NB_OK;
  if (nb_stability_check(model, error))
    return error->status;
  nb_guard_resolution(model);
  return NB_OK;
}

static enum nb_status check_stiffening(struct nb_model *model, struct nb_error *error) {
  return nb_stability_overlaps(model) ? NB_OK : nb_stability_check(model, error);
}

/* Which of them the scene needs now. */
#define WANTED(name, condition)                                                                                        \
  static bool name(const struct nb_model *model) { return condition; }
WANTED(ramps_walls, nb_stage_ramps_walls(model))
WANTED(has_boundary, model->boundary != NULL)
WANTED(has_servo, model->affine && model->stage && model->stage->servo.line)
WANTED(strains_box, nb_box_is_strained(model))
WANTED(balances, model->balance != NULL)
WANTED(carries, model->affine != NULL)
WANTED(changes, nb_stage_changes(model))
WANTED(stiffens, model->blocks.stable_overlap != NULL)
WANTED(elastic, model->plan.elastic)
WANTED(requests_fracc, model->fracc != NULL)
WANTED(has_reference, model->configuration != NULL)

static const struct {
  enum nb_when when;
  const char *name;
  bool (*wanted)(const struct nb_model *model); /* NULL: by every scene */
  enum nb_status (*run)(struct nb_model *model, struct nb_error *error);
} table[] = {
    {NB_BEFORE_MOTION, "walls ramp", ramps_walls, move_walls},
    {NB_BEFORE_MOTION, "boundary takes in particles", has_boundary, nb_boundary_before_motion},
    {NB_BEFORE_MOTION, "servo", has_servo, follow_stress},
    {NB_BEFORE_MOTION, "walls of the box follow its strain rate", strains_box, strain_box},
    {NB_BEFORE_MOTION, "energy balance", balances, account_before},
    {NB_BEFORE_MOTION, "affine motion", carries, affine_along},
    {NB_AFTER_MOTION, "energy balance", balances, account_kick},
    {NB_AFTER_MOTION, "stress on the boundary", has_boundary, press},
    {NB_BEFORE_SEARCH, "changes of the stage", changes, change},
    {NB_BEFORE_FORCES, "stability check", NULL, monitor},
    {NB_AFTER_FORCES, "stability check of stiffening contacts", stiffens, check_stiffening},
    {NB_AFTER_FORCES, "count of deep overlaps", elastic, count_deep},
    {NB_AFTER_FORCES, "FRACC", requests_fracc, find_fracc},
    {NB_AFTER_FORCES, "sliding since a stage", has_reference, count_slid},
    {NB_AFTER_FORCES, "energy balance", balances, account_forces},
};

void nb_hooks_plan(struct nb_model *model) {
  for (int when = 0; when < NB_WHENS; when++)
    model->hooks[when].count = 0;
  for (size_t k = 0; k < sizeof table / sizeof *table; k++) {
    struct nb_hooks *all = &model->hooks[table[k].when];
    if (table[k].wanted && !table[k].wanted(model))
      continue;
    assert(all->count < NB_HOOKS);
    all->list[all->count++] = (struct nb_hook){table[k].name, table[k].run};
  }
}
