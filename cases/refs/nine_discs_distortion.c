/* Reference: discs that touch, between walls that slowly close in and then turn, with friction  [CS79 16-19; figures 8, 9].
 *
 * Known, for every watched contact: NAME.normal and NAME.shear along cycle (straight lines between the points of the path),
 * and their values at the end of each stage. The network of springs is led along the walls' path, at rest all the
 * time; contacts slide and stick again as they must. Exact for small displacements and infinitely slow walls: a run
 * misses by the ratio of overlap to radius, by the square of the angle over the overlap's share of the radius, and by
 * its speed.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "lattice_path.h"

/* One force along the path: one allocation, so that it can be the data of a curve. */
struct trace {
  size_t count, room;
  struct {
    double cycle, force;
  } points[];
};

/* What is looked at: a row of the forces for each trace. */
struct looked {
  const struct nb_scene *scene;
  size_t count;
  struct trace **traces;
  size_t *rows;
  double *begin; /* of each stage, cycles */
};

static void see(void *data, size_t stage, double fraction, const gsl_vector *forces) {
  const struct looked *looked = data;
  for (size_t k = 0; k < looked->count; k++) {
    struct trace *trace = looked->traces[k];
    if (trace->count == trace->room)
      continue;
    trace->points[trace->count].cycle = looked->begin[stage] + fraction * (double)looked->scene->stages[stage].cycles;
    trace->points[trace->count++].force = gsl_vector_get(forces, looked->rows[k]);
  }
}

static double at(const void *data, double x) {
  const struct trace *trace = data;
  size_t low = 0, high = trace->count - 1;
  while (high - low > 1) {
    const size_t middle = (low + high) / 2;
    if (trace->points[middle].cycle <= x)
      low = middle;
    else
      high = middle;
  }
  const double from = trace->points[low].cycle, to = trace->points[high].cycle;
  const double fraction = to > from ? (x - from) / (to - from) : 0;
  return trace->points[low].force + fraction * (trace->points[high].force - trace->points[low].force);
}

static enum nb_status look(struct looked *looked, const struct lattice *lattice, struct nb_error *error) {
  const struct nb_scene *scene = looked->scene;
  const size_t room = 1001 * scene->stage_count;
  looked->traces = calloc(2 * scene->monitor_count + 1, sizeof *looked->traces);
  looked->rows = calloc(2 * scene->monitor_count + 1, sizeof *looked->rows);
  looked->begin = calloc(scene->stage_count + 1, sizeof *looked->begin);
  bool made = looked->traces && looked->rows && looked->begin;
  for (size_t s = 0; s < scene->stage_count && made; s++)
    looked->begin[s + 1] = looked->begin[s] + (double)scene->stages[s].cycles;
  for (size_t w = 0; w < scene->monitor_count && made; w++) {
    const int contact = lattice_watched(lattice, &scene->monitors[w]);
    for (size_t k = 0; k < 2 && contact >= 0 && made; k++) {
      struct trace *trace = malloc(sizeof *trace + room * sizeof trace->points[0]);
      made = trace != NULL;
      if (made)
        trace->count = 0, trace->room = room, looked->rows[looked->count] = 2 * (size_t)contact + k,
        looked->traces[looked->count++] = trace;
    }
  }
  return made ? NB_OK : nb_error_memory(error);
}

/* Hands the traces over to what is known, in the order of `look`. */
static void add_value(struct nb_solution *solution, struct looked *looked, const struct lattice *lattice) {
  static const char *const kinds[2] = {"normal", "shear"};
  const struct nb_scene *scene = looked->scene;
  char name[2 * NB_NAME_SIZE], ends[4 * NB_NAME_SIZE];
  size_t trace = 0;
  for (size_t w = 0; w < scene->monitor_count; w++)
    for (size_t k = 0; k < 2 && lattice_watched(lattice, &scene->monitors[w]) >= 0; k++) {
      snprintf(name, sizeof name, "%s.%s", scene->monitors[w].name, kinds[k]);
      for (size_t s = 0; s < scene->stage_count; s++) {
        snprintf(ends, sizeof ends, "%s in %s", name, scene->stages[s].name);
        solution_value(solution, at(looked->traces[trace], looked->begin[s + 1]), ends);
      }
      solution_value(solution, at(looked->traces[trace], looked->begin[scene->stage_count]), name);
      solution_curve(solution, name, "cycle", at, looked->traces[trace++]);
    }
  looked->count = 0; /* they are not ours any more */
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct lattice lattice;
  struct looked looked = {.scene = scene};
  enum nb_status status = lattice_build(&lattice, scene, error);
  if (status != NB_OK)
    return status;
  for (size_t c = 0; c < lattice.contact_count; c++)
    if (lattice.contacts[c].pair.cohesion != 0)
      status = nb_error_set(error, NB_BAD_USE, "this reference is for friction without cohesion");
  if (status == NB_OK)
    status = look(&looked, &lattice, error);
  if (status == NB_OK)
    status = lattice_path(&lattice, see, &looked, error);
  if (status == NB_OK)
    add_value(solution, &looked, &lattice);
  for (size_t k = 0; k < looked.count; k++)
    free(looked.traces[k]);
  free(looked.traces), free(looked.rows), free(looked.begin);
  lattice_free(&lattice);
  return status == NB_OK ? solution_full(solution, error) : status;
}

const struct nb_reference reference_nine_discs_distortion = {
    .name = "nine_discs_distortion",
    .title = "touching discs between walls that close in and turn slowly: the network followed along its path",
    .source = "[CS79 16-19]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_MOVING_WALLS, HAS_TURNING_WALLS, HAS_FRICTION,
                HAS_ALL_DAMPING, HAS_DAMPING_CHANGE, HAS_STEP_CHANGE, HAS_UNTIL},
    .needs = {HAS_WALLS},
    .normal = "linear",
    .shear = "none linear",
    .solve = solve,
};
