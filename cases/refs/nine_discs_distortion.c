/* Reference: touching discs between walls that approach slowly and then rotate, with friction
 * [CS79 16-19, figures 8, 9].
 *
 * The network of springs (lattice_path.c) follows the path of the walls in equilibrium; contacts slide and stick again.
 *
 * Returns, for C that monitors a contact:
 *   C.normal, C.shear versus cycle, linear between the points of the path, and at the end of each stage and of the run
 * Exact for small displacements and infinitely slow walls. The relative error of a run has three parts. The first is of
 * the order of the ratio of overlap to radius, the second of the order of the square of the angle of the walls, divided
 * by this ratio. The third is the effect of the speed of the walls.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "lattice_path.h"

/* One force along the path: one allocation, so that it can be the data of a curve. */
struct trace {
  size_t count, capacity;
  struct {
    double cycle, force;
  } points[];
};

/* The recorded forces, each with its trace. rows[k] is the index of force k in the vector `forces` of add_point: 2 c for
 * the normal force of contact c, 2 c + 1 for its shear force. */
struct recorder {
  const struct nb_scene *scene;
  size_t count;
  struct trace **traces;
  size_t *rows;
  double *begin; /* cycle at which each stage begins */
};

static void add_point(void *data, size_t stage, double fraction, const gsl_vector *forces) {
  const struct recorder *recorder = data;
  for (size_t k = 0; k < recorder->count; k++) {
    struct trace *trace = recorder->traces[k];
    if (trace->count == trace->capacity)
      continue;
    trace->points[trace->count].cycle =
        recorder->begin[stage] + fraction * (double)recorder->scene->stages[stage].cycles;
    trace->points[trace->count++].force = gsl_vector_get(forces, recorder->rows[k]);
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

static enum nb_status make_traces(struct recorder *recorder, const struct lattice *lattice, struct nb_error *error) {
  const struct nb_scene *scene = recorder->scene;
  const size_t capacity = 1001 * scene->stage_count; /* lattice_path adds 1001 points per stage */
  recorder->traces = calloc(2 * scene->monitor_count + 1, sizeof *recorder->traces);
  recorder->rows = calloc(2 * scene->monitor_count + 1, sizeof *recorder->rows);
  recorder->begin = calloc(scene->stage_count + 1, sizeof *recorder->begin);
  bool made = recorder->traces && recorder->rows && recorder->begin;
  for (size_t s = 0; s < scene->stage_count && made; s++)
    recorder->begin[s + 1] = recorder->begin[s] + (double)scene->stages[s].cycles;
  for (size_t w = 0; w < scene->monitor_count && made; w++) {
    const int contact = lattice_contact_of(lattice, &scene->monitors[w]);
    for (size_t k = 0; k < 2 && contact >= 0 && made; k++) {
      struct trace *trace = malloc(sizeof *trace + capacity * sizeof trace->points[0]);
      made = trace != NULL;
      if (made)
        trace->count = 0, trace->capacity = capacity, recorder->rows[recorder->count] = 2 * (size_t)contact + k,
        recorder->traces[recorder->count++] = trace;
    }
  }
  return made ? NB_OK : nb_error_memory(error);
}

/* Hands the traces over to the solution, in the order of make_traces. */
static void add_value(struct nb_solution *solution, struct recorder *recorder, const struct lattice *lattice) {
  static const char *const kinds[2] = {"normal", "shear"};
  const struct nb_scene *scene = recorder->scene;
  char name[2 * NB_NAME_SIZE], ends[4 * NB_NAME_SIZE];
  size_t trace = 0;
  for (size_t w = 0; w < scene->monitor_count; w++)
    for (size_t k = 0; k < 2 && lattice_contact_of(lattice, &scene->monitors[w]) >= 0; k++) {
      snprintf(name, sizeof name, "%s.%s", scene->monitors[w].name, kinds[k]);
      for (size_t s = 0; s < scene->stage_count; s++) {
        snprintf(ends, sizeof ends, "%s in %s", name, scene->stages[s].name);
        solution_value(solution, at(recorder->traces[trace], recorder->begin[s + 1]), ends);
      }
      solution_value(solution, at(recorder->traces[trace], recorder->begin[scene->stage_count]), name);
      solution_curve(solution, name, "cycle", at, recorder->traces[trace++]);
    }
  recorder->count = 0; /* the solution owns them now */
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct lattice lattice;
  struct recorder recorder = {.scene = scene};
  enum nb_status status = lattice_build(&lattice, scene, error);
  if (status != NB_OK)
    return status;
  status = make_traces(&recorder, &lattice, error);
  if (status == NB_OK)
    status = lattice_path(&lattice, add_point, &recorder, error);
  if (status == NB_OK)
    add_value(solution, &recorder, &lattice);
  for (size_t k = 0; k < recorder.count; k++)
    free(recorder.traces[k]);
  free(recorder.traces), free(recorder.rows), free(recorder.begin);
  lattice_free(&lattice);
  return status == NB_OK ? solution_status(solution, error) : status;
}

const struct nb_reference reference_nine_discs_distortion = {
    .name = "nine_discs_distortion",
    .title = "touching discs between walls that approach and turn slowly: the network in equilibrium along the path",
    .source = "[CS79 16-19]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_FIXED_PARTICLES, HAS_MOVING_WALLS, HAS_TURNING_WALLS, HAS_OFFSET_WALLS,
                HAS_FRICTION, HAS_ALL_DAMPING, HAS_DAMPING_CHANGE, HAS_STEP_CHANGE, HAS_UNTIL},
    .needs = {HAS_WALLS},
    .normal = "linear",
    .shear = "none linear",
    .solve = solve,
};
