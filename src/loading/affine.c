/* Imposed affine motion.                                            [R89 sec. 4.5.2]
 *
 *   u = v + c,   c = L (x - x_0)                                                   [R89 4.41]
 *
 *   u    total velocity of a particle, m/s     v    own velocity, which forces and damping change (motion.c), m/s
 *   L    strain rate, 1/s                      x_0  centre of the cell or of the boundary, else the origin, m
 *
 * L depends on the particle. In a periodic cell all particles have the strain rate of the cell (cell.c). Without a cell
 * the particles of a held boundary have the strain rate of the boundary, and v = 0 (boundary.c). All other free
 * particles have the strain rate of `affine strain`. v does not change when L jumps at the beginning of a stage.
 *
 * R89 writes x' = x' + c_11 x + c_12 y [R89 4.43], where x' is a velocity, and stores the sum as the new velocity
 * (`accumulated`). Then c is added again in every cycle and acts as an acceleration L (x - x_0)/dt: in a direction of
 * extension a particle at rest moves away as exp(sqrt(L/dt) t), in a direction of compression it oscillates. R89 also
 * adds L z to the relative velocity of two particles with separation z (`accumulated-twice`, pass/affine_twice.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */

#include "loading.h"

static bool needed(const struct nb_scene *scene) {
  bool any = scene->cell.line || scene->circle.line;
  for (size_t s = 0; s < scene->stage_count; s++)
    any = any || scene->stages[s].circle.line || scene->stages[s].affine.line || scene->stages[s].box_line ||
          scene->stages[s].servo.box; /* statements of a boundary need its circle */
  return any;
}

enum nb_status nb_affine_create(struct nb_model *model, struct nb_error *error) {
  const struct nb_scene *scene = model->scene;
  struct nb_particles *particles = &model->particles;
  if (!needed(scene))
    return NB_OK;
  struct nb_affine *affine = model->affine = nb_own(&model->owner, 1, sizeof *affine);
  unsigned char *source = nb_own(&model->owner, particles->count, sizeof *source);
  particles->imposed = nb_own(&model->owner, particles->count, sizeof *particles->imposed);
  if (model->owner.failed)
    return nb_error_memory(error);
  affine->source = source;
  affine->centre = model->cell ? model->cell->centre : vec(scene->origin_x, scene->origin_y);
  for (int c = 0; c < NB_AFFINE_SOURCES; c++)
    affine->separate[c] = 1;
  for (size_t i = 0; i < particles->count; i++)
    nb_affine_assign(affine, i,
                     model->cell                      ? NB_AFFINE_CELL
                     : particles->inverse_mass[i] > 0 ? NB_AFFINE_FREE
                                                      : NB_AFFINE_NONE);
  return NB_OK;
}

/* The strain rate of a statement as a tensor L, 1/s. */
static struct nb_tensor rate_of(const struct nb_model *model, const struct nb_strain_rate *strain) {
  return tensor_scale(strain->per_cycle ? 1 / model->step : 1, tensor(strain->xx, strain->xy, strain->yx, strain->yy));
}

const struct nb_strain_rate *nb_affine_given(const struct nb_stage *stage, enum nb_affine_source source, int *line) {
  const struct {
    int line;
    const struct nb_strain_rate *rate;
  } given[NB_AFFINE_SOURCES] = {[NB_AFFINE_FREE] = {stage->affine.line, &stage->affine.strain},
                                [NB_AFFINE_BOUNDARY] = {stage->boundary.line, &stage->boundary.strain},
                                [NB_AFFINE_CELL] = {stage->cell_line, &stage->cell},
                                [NB_AFFINE_BOX] = {stage->box_line, &stage->box}};
  *line = given[source].line;
  return given[source].rate;
}

int nb_affine_inherited(const struct nb_scene *scene, size_t stage, enum nb_affine_source source, int *line) {
  for (size_t s = stage + 1; s-- > 0;) {
    const struct nb_stage *it = &scene->stages[s];
    const struct nb_strain_rate *rate = nb_affine_given(it, source, line);
    if (source == NB_AFFINE_BOX && !nb_box_strained_in(scene, s))
      return -1;
    if (*line)
      return s < stage && (rate->xx != 0 || rate->xy != 0 || rate->yx != 0 || rate->yy != 0) ? (int)s : -1;
  }
  return -1;
}

void nb_affine_begin(struct nb_model *model, const struct nb_stage *stage) {
  struct nb_affine *affine = model->affine;
  struct nb_strain_rate *requested = affine->requested, *cell = &requested[NB_AFFINE_CELL];
  if (stage->reverse_velocities)
    cell->xx *= -1, cell->xy *= -1, cell->yx *= -1, cell->yy *= -1;
  if (!nb_box_strained_in(model->scene, (size_t)(stage - model->scene->stages)))
    requested[NB_AFFINE_BOX] = (struct nb_strain_rate){.xx = 0};
  for (int line, c = NB_AFFINE_FREE; c < NB_AFFINE_SOURCES; c++) {
    const struct nb_strain_rate *rate = nb_affine_given(stage, c, &line);
    requested[c] = line ? *rate : requested[c];
  }
  if (stage->affine.line) {
    affine->separate[NB_AFFINE_FREE] = stage->affine.accumulated ? 0 : 1;
    affine->twice = stage->affine.twice;
  }
  for (int c = 0; c < NB_AFFINE_SOURCES; c++)
    affine->rate[c] = affine->base_rate[c] = rate_of(model, &requested[c]);
}

/* True if all particles with an imposed motion have the L of the source `reference`, and either all or none of them
 * accumulate c. */
static bool same_rate(const struct nb_affine *affine, enum nb_affine_source reference) {
  for (int c = 0; c < NB_AFFINE_SOURCES; c++)
    if (affine->used[c] && (tensor_largest(tensor_sub(affine->rate[c], affine->rate[reference])) != 0 ||
                            affine->separate[c] != affine->separate[reference]))
      return false;
  return true;
}

/* True if the strain rate of the source is not 0. */
static bool strains(const struct nb_affine *affine, enum nb_affine_source source) {
  return tensor_largest(affine->rate[source]) > 0;
}

/* True if some particle moves affinely in the next step, or a servo may make it move. */
static bool strains_now(const struct nb_model *model) {
  const struct nb_servo *servo = model->stage ? &model->stage->servo : NULL;
  return strains(model->affine, NB_AFFINE_FREE) || strains(model->affine, NB_AFFINE_BOUNDARY) ||
         strains(model->affine, NB_AFFINE_CELL) || (servo && servo->line && !servo->box);
}

bool nb_affine_moves(const struct nb_model *model) {
  return model->affine && (model->affine->any_before || strains_now(model));
}
bool nb_affine_ends(const struct nb_model *model) { return nb_affine_moves(model) && !strains_now(model); }

bool nb_affine_step(struct nb_model *model) {
  struct nb_affine *affine = model->affine;
  const bool free = strains(affine, model->cell ? NB_AFFINE_CELL : NB_AFFINE_FREE);
  model->all_affine = free || affine->free_before;
  affine->free_before = free, affine->any_before = strains_now(model);
  affine->uniform = same_rate(affine, model->cell ? NB_AFFINE_CELL : NB_AFFINE_FREE);
  return model->all_affine;
}

void nb_affine_clear(struct nb_model *model) {
  for (size_t i = 0; i < model->particles.count; i++)
    model->particles.imposed[i] = vec(0, 0);
}

void nb_affine_remove(struct nb_model *model, size_t slot) {
  nb_affine_assign(model->affine, slot, NB_AFFINE_NONE);
  model->particles.imposed[slot] = vec(0, 0);
}
