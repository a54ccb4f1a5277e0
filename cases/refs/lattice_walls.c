/* The motion of the walls in the stages of a scene: when their velocities change, and their displacements. The motion
 * set in a stage acts from its first cycle and lasts until another stage changes it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "lattice.h"

#include <math.h>
#include <stdlib.h>

/* The step in s; NAN: it is neither a time nor a fraction of single-contact. A step `of single-contact` is a fraction of
 * 2 sqrt(m/k) [CS79, Motion], where m is the smallest mass of a free particle, and k the largest normal stiffness
 * between the materials of two particles or of a particle and a wall. */
static double step_length(const struct nb_scene *scene, const struct nb_step *step) {
  if (step->kind == NB_STEP_TIME)
    return step->value;
  if (step->kind != NB_STEP_SINGLE_CONTACT)
    return NAN;
  double lightest = INFINITY, max_stiffness = 0;
  for (size_t i = 0; i < scene->particle_count; i++) {
    const struct nb_particle *particle = &scene->particles[i];
    if (!particle->fixed)
      lightest = fmin(lightest, matter_mass(scene, particle));
    for (size_t j = 0; j < scene->particle_count + scene->wall_count; j++) {
      int other =
          j < scene->particle_count ? scene->particles[j].material : scene->walls[j - scene->particle_count].material;
      max_stiffness = fmax(max_stiffness, matter_pair(scene, particle->material, other).kn);
    }
  }
  return step->value * 2 * sqrt(lightest / max_stiffness);
}

static bool damped(const struct nb_damping *damping) { return !nb_damping_none(damping); }

static void wall_velocities(gsl_vector *velocity, const struct nb_scene *scene) {
  for (size_t i = 0; i < scene->wall_count; i++) {
    gsl_vector_set(velocity, LATTICE_WALL * i, scene->walls[i].vx);
    gsl_vector_set(velocity, LATTICE_WALL * i + 1, scene->walls[i].vy);
    gsl_vector_set(velocity, LATTICE_WALL * i + 2, scene->walls[i].spin);
  }
}

static void stage_motions(gsl_vector *velocity, const struct nb_stage *stage) {
  for (size_t i = 0; i < stage->motion_count; i++) {
    const struct nb_wall_motion *motion = &stage->motions[i];
    gsl_vector_set(velocity, LATTICE_WALL * (size_t)motion->wall, motion->vx);
    gsl_vector_set(velocity, LATTICE_WALL * (size_t)motion->wall + 1, motion->vy);
    gsl_vector_set(velocity, LATTICE_WALL * (size_t)motion->wall + 2, motion->spin);
  }
}

/* Adds a velocity change if the velocities differ from those before. */
static void note_change(struct lattice *lattice, const gsl_vector *before, const gsl_vector *now, unsigned long cycle) {
  if (gsl_vector_equal(before, now))
    return;
  gsl_vector *change = gsl_vector_alloc(now->size);
  gsl_vector_memcpy(change, now);
  gsl_vector_sub(change, before);
  lattice->changes[lattice->change_count++] = (struct lattice_velocity_change){.cycle = cycle, .change = change};
}

enum nb_status lattice_read_walls(struct lattice *lattice, const struct nb_scene *scene, struct nb_error *error) {
  lattice->changes = calloc(scene->stage_count, sizeof *lattice->changes);
  lattice->travel = calloc(scene->stage_count, sizeof *lattice->travel);
  if (!lattice->changes || !lattice->travel)
    return nb_error_memory(error);
  gsl_vector *before = gsl_vector_calloc(LATTICE_WALL * scene->wall_count),
             *now = gsl_vector_calloc(LATTICE_WALL * scene->wall_count);
  gsl_vector *travel = gsl_vector_calloc(LATTICE_WALL * scene->wall_count);
  lattice->step = step_length(scene, &scene->stages[0].step);
  lattice->one_step = true;
  bool still_undamped = true;
  enum nb_status status = NB_OK;
  wall_velocities(now, scene);
  for (size_t i = 0; i < scene->stage_count; i++) {
    const struct nb_stage *stage = &scene->stages[i];
    stage_motions(now, stage);
    note_change(lattice, before, now, lattice->cycles);
    gsl_vector_memcpy(before, now);
    if (stage->condition_count > 0 && !gsl_vector_isnull(now))
      status = nb_error_set(error, NB_BAD_USE,
                            "this reference needs the displacements of the walls: stage %s moves them until a "
                            "condition holds",
                            stage->name);
    double step = step_length(scene, &stage->step);
    if (isnan(step))
      status =
          nb_error_set(error, NB_BAD_USE, "this reference needs the step as a time or as a fraction of single-contact");
    if (step != lattice->step)
      lattice->one_step = false;
    if (damped(&stage->damping))
      still_undamped = false;
    lattice->cycles += stage->cycles;
    if (still_undamped)
      lattice->undamped = lattice->cycles;
    for (size_t j = 0; j < now->size; j++) {
      double distance = (double)stage->cycles * step * gsl_vector_get(now, j);
      gsl_vector_set(travel, j, gsl_vector_get(travel, j) + distance);
      const struct nb_wall *wall = &scene->walls[j / LATTICE_WALL];
      double arm = j % LATTICE_WALL < 2 ? 1 : hypot(wall->h0, fmax(fabs(wall->h1), fabs(wall->h2)));
      lattice->largest_travel = fmax(lattice->largest_travel, arm * fabs(gsl_vector_get(travel, j)));
    }
    lattice->travel[i] = gsl_vector_alloc(travel->size);
    gsl_vector_memcpy(lattice->travel[i], travel);
    lattice->stage_count++;
  }
  gsl_vector_free(before);
  gsl_vector_free(now);
  gsl_vector_free(travel);
  return status;
}

size_t lattice_first_at_rest(const struct lattice *lattice, const struct nb_scene *scene) {
  gsl_vector *velocity = gsl_vector_calloc(LATTICE_WALL * scene->wall_count);
  for (size_t i = 0; i < lattice->change_count; i++)
    gsl_vector_add(velocity, lattice->changes[i].change);
  double residual = fmax(gsl_vector_max(velocity), -gsl_vector_min(velocity)) * lattice->step;
  gsl_vector_free(velocity);
  if (residual > 1e-12 * lattice->largest_travel)
    return lattice->stage_count; /* the changes may not add up to 0 exactly */
  unsigned long begin = 0, last = lattice->change_count ? lattice->changes[lattice->change_count - 1].cycle : 0;
  for (size_t i = 0; i < scene->stage_count; i++) {
    if (begin >= last)
      return i;
    begin += scene->stages[i].cycles;
  }
  return lattice->stage_count;
}
