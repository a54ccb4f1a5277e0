/* Bodies that are carried along.                                     [R89 4.5.2]
 *
 *   u = v + c,   c = L (x - x_0)                                                   [R89 4.41]
 *
 *   u    velocity of a body, m/s          v    its own part of it, which forces and damping change (motion.c)
 *   L    strain rate, 1/s                 x_0  the centre of the cell, of the boundary, or the origin of the page, m
 *
 * All bodies of a periodic cell have the cell's L (cell.c). Where there is none, the boundary's bodies have the boundary's, and no
 * v while it holds them (boundary.c); all others that are free have the continuum's. What is carried with v at rest stays so, as in
 * a continuum; v is damped as everything is. When L jumps at the begin of a stage, v stays what it was.
 *
 * R89 writes x' = x' + c_11 x + c_12 y [R89 4.43] and keeps the sum as the new velocity (`accumulated`): then c is added again in
 * every cycle, and is an acceleration L (x - x_0)/dt, under which what is at rest moves away as exp(sqrt(L/dt) t).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "loading.h"

static bool needed(const struct nb_scene *scene) {
  bool carries = scene->cell.line || scene->circle.line;
  for (size_t s = 0; s < scene->stage_count; s++)
    carries = carries || scene->stages[s].circle.line || scene->stages[s].boundary.line ||
              scene->stages[s].continuum.line || scene->stages[s].box_line || scene->stages[s].servo.box;
  return carries;
}

enum nb_status nb_affine_create(struct nb_model *model, struct nb_error *error) {
  const struct nb_scene *scene = model->scene;
  struct nb_particles *particles = &model->particles;
  if (!needed(scene))
    return NB_OK;
  struct nb_affine *affine = model->affine = nb_own(&model->owner, 1, sizeof *affine);
  unsigned char *by = nb_own(&model->owner, particles->count, sizeof *by);
  particles->imposed = nb_own(&model->owner, particles->count, sizeof *particles->imposed);
  if (model->owner.failed)
    return nb_error_memory(error);
  affine->by = by;
  affine->free_before = true; /* not known */
  affine->centre = model->cell ? model->cell->centre : vec(scene->origin_x, scene->origin_y);
  for (int c = 0; c < NB_CARRIERS; c++)
    affine->remembered[c] = 1;
  for (size_t i = 0; i < particles->count; i++)
    nb_affine_by(affine, i,
                 model->cell                      ? NB_CARRIER_CELL
                 : particles->inverse_mass[i] > 0 ? NB_CARRIER_CONTINUUM
                                                  : NB_CARRIER_NONE);
  return NB_OK;
}

/* In 1/s, with the step of this stage. */
static struct nb_tensor rate_of(const struct nb_model *model, const struct nb_strain_rate *strain) {
  return tensor_scale(strain->per_cycle ? 1 / model->step : 1, tensor(strain->xx, strain->xy, strain->yx, strain->yy));
}

void nb_affine_begin(struct nb_model *model, const struct nb_stage *stage) {
  struct nb_affine *affine = model->affine;
  struct nb_strain_rate *requested = affine->requested, *cell = &requested[NB_CARRIER_CELL];
  if (stage->reverse)
    cell->xx *= -1, cell->xy *= -1, cell->yx *= -1, cell->yy *= -1;
  if (stage->cell_line)
    *cell = stage->cell;
  if (stage->box_line)
    requested[NB_CARRIER_BOX] = stage->box;
  else if (!nb_box_strained_in(model->scene, (size_t)(stage - model->scene->stages)))
    requested[NB_CARRIER_BOX] = (struct nb_strain_rate){.xx = 0};
  if (stage->boundary.line)
    requested[NB_CARRIER_BOUNDARY] = stage->boundary.strain;
  if (stage->continuum.line) {
    requested[NB_CARRIER_CONTINUUM] = stage->continuum.strain;
    affine->remembered[NB_CARRIER_CONTINUUM] = stage->continuum.literal ? 0 : 1;
  }
  for (int c = 0; c < NB_CARRIERS; c++)
    affine->rate[c] = affine->level[c] = rate_of(model, &requested[c]);
}

/* Whether one rate, and one way to remember it, stands for those of all that are carried. */
static bool same_rate(const struct nb_affine *affine, enum nb_carrier one) {
  for (int c = 0; c < NB_CARRIERS; c++)
    if (affine->carries[c] && (tensor_largest(tensor_sub(affine->rate[c], affine->rate[one])) != 0 ||
                               affine->remembered[c] != affine->remembered[one]))
      return false;
  return true;
}

bool nb_affine_step(struct nb_model *model) {
  struct nb_affine *affine = model->affine;
  const bool free = tensor_largest(affine->rate[NB_CARRIER_CONTINUUM]) > 0 || model->cell;
  affine->all = free || affine->free_before;
  affine->free_before = free;
  affine->alike = same_rate(affine, model->cell ? NB_CARRIER_CELL : NB_CARRIER_CONTINUUM);
  return affine->all;
}

void nb_affine_clear(struct nb_model *model) {
  memset(model->particles.imposed, 0, model->particles.count * sizeof *model->particles.imposed);
}

void nb_affine_remove(struct nb_model *model, size_t slot) {
  nb_affine_by(model->affine, slot, NB_CARRIER_NONE);
  model->particles.imposed[slot] = vec(0, 0);
}
