/* The calculation cycle [CS79, The calculation cycle].
 *
 *   Motion     Newton's second law gives, from the forces at t_N, the velocities at t_(N+1/2) and the positions at
 *              t_(N+1); walls move with their given velocities.
 *   Contacts   If a particle or a wall has moved far enough since the last search, a search renews the list of
 *              contacts.
 *   Forces     The force-displacement laws give the forces at t_(N+1) from positions and velocities.
 *
 * Forces and positions of a cycle belong to the same time. A team of threads (team.c) shares the particles of the
 * motion, then the blocks of the forces. Each particle and each contact is computed by one thread alone. So neither the
 * number of threads nor the choice of the thread changes a bit of the results.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "model.h"
#include "team.h"

static void forces_of_block(const struct nb_model *model, const struct nb_block *block) {
  const struct nb_material_pair *material_pair = block->material_pair;
  for (int p = 0; p < material_pair->pass_count; p++) {
    nb_rounding_begin(&model->machine.rounding, material_pair->passes[p].name);
    material_pair->passes[p].run(model, block);
  }
}

static void forces_part(void *data, int part) {
  const struct nb_model *model = data;
  const size_t parts = nb_parts(model->machine.threads_used);
  const size_t n = model->blocks.count;
  for (size_t v = n * (size_t)part / parts; v < n * ((size_t)part + 1) / parts; v++)
    forces_of_block(model, &model->blocks.list[v]);
  nb_rounding_begin(&model->machine.rounding, NULL);
}

void nb_forces(struct nb_model *model) {
  if (model->vertices.count)
    nb_vertices_suppress(model);
  nb_team_run(model->machine.team, (int)nb_parts(model->machine.threads_used), forces_part, model);
  model->updates += model->contacts.count;
}

struct moved {
  struct nb_model *model;
  int out[NB_MOST_PARTS]; /* of each part: number of particles that require a new search */
};

static void motion_part(void *data, int part) {
  struct moved *moved = data;
  struct nb_model *model = moved->model;
  nb_rounding_begin(&model->machine.rounding, "motion");
  moved->out[part] = nb_motion_part(model, part, (int)nb_parts(model->machine.threads_used));
  nb_rounding_begin(&model->machine.rounding, NULL);
}

/* Returns the number of particles and walls that require a new search, plus 1 if the strain of the cell requires
 * one. */
static int motion(struct nb_model *model) {
  nb_rounding_begin(&model->machine.rounding, "motion");
  int out = model->walls.count ? nb_motion_walls(model) : 0;
  if (model->all_affine && model->cell)
    out += nb_cell_move(model);
  nb_rounding_begin(&model->machine.rounding, NULL);
  struct moved moved;
  moved.model = model;
  nb_team_run(model->machine.team, (int)nb_parts(model->machine.threads_used), motion_part, &moved);
  for (int part = 0; part < (int)nb_parts(model->machine.threads_used); part++)
    out += moved.out[part];
  return out;
}

static enum nb_status hooks(struct nb_model *model, enum nb_when when, struct nb_error *error) {
  const struct nb_hooks *all = &model->hooks[when];
  enum nb_status status = NB_OK;
  for (size_t h = 0; h < all->count && !status; h++) {
    nb_rounding_begin(&model->machine.rounding, all->list[h].name);
    status = all->list[h].run(model, error);
    nb_rounding_begin(&model->machine.rounding, NULL);
  }
  return status;
}

static enum nb_status rounded_search(struct nb_model *model, struct nb_error *error) {
  nb_rounding_begin(&model->machine.rounding, "search");
  const enum nb_status status = nb_neighbours_search(model, error);
  nb_rounding_begin(&model->machine.rounding, NULL);
  return status;
}

/* Runs the search if something requires it (`out`) and no hook has run it in this cycle. Otherwise tests the guards. */
static enum nb_status search(struct nb_model *model, bool out, struct nb_error *error) {
  if (out && model->search.last_cycle != model->cycle)
    return rounded_search(model, error);
  return nb_guard_cycle(model, error);
}

enum nb_status nb_cycle(struct nb_model *model, struct nb_error *error) {
  if (hooks(model, NB_BEFORE_MOTION, error))
    return error->status;
  const int out = motion(model); /* [CS79 20-23] */
  if (hooks(model, NB_AFTER_MOTION, error))
    return error->status;
  model->cycle++;
  model->stage_cycle++;
  model->time = model->stage_time + (double)model->stage_cycle * model->step;
  model->previous_step = model->step;
  if (hooks(model, NB_BEFORE_SEARCH, error) || search(model, out > 0, error) || hooks(model, NB_BEFORE_FORCES, error))
    return error->status;
  nb_forces(model); /* [CS79 8-19, 26-28] */
  return hooks(model, NB_AFTER_FORCES, error);
}
