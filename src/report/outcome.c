/* Reads a page, runs its runs, solves their references, and checks the expectations.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "outcome.h"

#ifdef _OPENMP
#include <omp.h>
#endif
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "core/clock.h"
#include "core/names.h"
#include "input/hash.h"
#include "input/reader.h"
#include "loading/loading.h"
#include "run/checkpoint.h"
#include "run/output_file.h"

static void add_warnings(struct nb_outcome *outcome, const struct nb_warnings *warnings) {
  for (size_t k = 0; k < warnings->count; k++)
    nb_warnings_add(&outcome->warnings, &warnings->list[k]);
}

/* The largest number of particles of all runs of a page that stay in memory. Further runs are read again when they run,
 * so the memory of a sweep is bounded. */
enum { PARTICLES_KEPT = 1000000 };

static void release_particles(struct nb_page_run *run) {
  for (struct nb_scene *scene = &run->scene; scene; scene = scene->start.scene)
    free(scene->particles), scene->particles = NULL;
  run->released = true;
}

/* True if an expectation on a single run uses the largest or the smallest of the rows. */
static bool uses_extreme(const struct nb_expectation *e) {
  const bool single = e->kind == NB_WITHIN || e->kind == NB_EXPECTED || e->kind == NB_LESS || e->kind == NB_GREATER;
  return single && !e->sample[0] && nb_is_extreme(e->measure.reducer);
}

/* Tracks the columns of particles and contacts of which an expectation uses the largest or the smallest value: a
 * collision may lie between two rows. Their values take little time; other quantities, which are sums over many
 * contacts, are not tracked. */
static void track_columns(struct nb_page_run *run) {
  const struct nb_scene *const scene = &run->scene;
  for (size_t k = 0; k < run->expectations.count; k++) {
    const struct nb_expectation *const e = &run->expectations.list[k];
    struct nb_column *const column = &scene->columns[e->measure.column];
    const int monitor = column->quantity.monitor;
    const enum nb_monitor_kind kind = monitor < 0 ? NB_MONITOR_REGION : scene->monitors[monitor].kind;
    const bool quick =
        kind == NB_MONITOR_PARTICLE || kind == NB_MONITOR_PARTICLE_PARTICLE || kind == NB_MONITOR_PARTICLE_WALL;
    column->tracked = column->tracked || (quick && uses_extreme(e));
  }
}

static void read_again(const struct nb_outcome *outcome, struct nb_page_run *run) {
  struct nb_mistakes mistakes = {0};
  nb_scene_free(&run->scene);
  nb_scene_read(&run->scene, &outcome->page, (size_t)(run - outcome->runs), outcome->settings, &mistakes);
  run->status = nb_mistakes_status(&mistakes, 0);
  if (!run->status)
    track_columns(run);
  if (run->status == NB_NO_MEMORY)
    nb_error_memory(&run->error);
  else if (run->status)
    nb_error_set(&run->error, run->status, "a file that the page names has changed during its runs");
  nb_mistakes_free(&mistakes);
}

/* ---- quantities of removed particles and walls ---- */

/* The removal of a particle or a wall. */
struct removal {
  int stage;        /* its index; -1: no stage removes it */
  int line;         /* of the statement `remove` */
  const char *what; /* "particle" or "wall" */
  const char *wall; /* its name */
};

/* The removal of particle `i`. */
static struct removal removal_of(const struct nb_scene *scene, int i) {
  for (size_t s = 0; s < scene->stage_count; s++)
    for (size_t k = 0; k < scene->stages[s].removal_count; k++) {
      const struct nb_removal *it = &scene->stages[s].removals[k];
      if (it->from <= (size_t)i && (size_t)i <= it->to)
        return (struct removal){(int)s, it->line, "particle", NULL};
    }
  return (struct removal){.stage = -1};
}

/* The first removal of one of the `count` walls from index w on. */
static struct removal removal_of_walls(const struct nb_scene *scene, int w, int count) {
  for (size_t s = 0; s < scene->stage_count; s++)
    for (size_t k = 0; k < scene->stages[s].motion_count; k++) {
      const struct nb_wall_motion *it = &scene->stages[s].motions[k];
      if (it->removed && it->wall >= w && it->wall < w + count)
        return (struct removal){(int)s, it->line, "wall", scene->walls[it->wall].name};
    }
  return (struct removal){.stage = -1};
}

/* True if the page expects 0 of the column, so its author knows that the value is 0. */
static bool is_expected_0(const struct nb_expectations *expectations, size_t column) {
  for (size_t k = 0; k < expectations->count; k++) {
    const struct nb_expectation *it = &expectations->list[k];
    if (it->kind == NB_EXPECTED && it->number == 0 && it->measure.column == column)
      return true;
  }
  return false;
}

/* The removal of what a monitor observes; of a contact that of the side that is removed first. None for the monitor of
 * a region or a grading. */
static struct removal removal_of_monitor(const struct nb_scene *scene, const struct nb_monitor *monitor) {
  struct removal a = {.stage = -1}, b = {.stage = -1};
  switch (monitor->kind) {
  case NB_MONITOR_PARTICLE:
    return removal_of(scene, monitor->a);
  case NB_MONITOR_WALL:
    return removal_of_walls(scene, monitor->a, 1);
  case NB_MONITOR_PARTICLE_PARTICLE:
    a = removal_of(scene, monitor->a), b = removal_of(scene, monitor->b);
    break;
  case NB_MONITOR_PARTICLE_WALL:
    a = removal_of(scene, monitor->a), b = removal_of_walls(scene, monitor->b, 1);
    break;
  default:
    break;
  }
  return b.stage < 0 || (a.stage >= 0 && a.stage <= b.stage) ? a : b;
}

/* Warns that a column is 0 from a stage on. The warning is about the line of the statement `remove`. If the page from
 * which this one starts removes the particle, it is about the line of `start`. */
static void warn_of_0(struct nb_warnings *warnings, const struct nb_scene *scene, const char *column,
                      struct removal it) {
  const size_t stage = (size_t)it.stage;
  const char *const name = scene->stages[stage].name;
  if (stage < scene->start.stages)
    nb_warn(warnings, scene->start.line, "`%s` is 0, because stage `%s` of `%s` removes its %s", column, name,
            scene->start.page->name, it.what);
  else if (stage > scene->start.stages)
    nb_warn(warnings, it.line,
            "`%s` is 0 from stage `%s` on, because this line removes its %s; for a value before, write `%s in %s`",
            column, name, it.what, column, scene->stages[stage - 1].name);
  else
    nb_warn(warnings, it.line, "`%s` is 0 in all stages, because this line removes its %s in the first one", column,
            it.what);
}

/* Warns that a quantity of the box is computed as if a removed wall were in its place, without forces. */
static void warn_of_box(struct nb_warnings *warnings, const struct nb_scene *scene, const char *column,
                        struct removal it) {
  const bool before = (size_t)it.stage < scene->start.stages;
  nb_warn(warnings, it.line, /* in an earlier page it is the line of `start` */
          "`%s` is computed from stage `%s` on as if wall `%s` were still in its place, without forces on it: %s "
          "removes it",
          column, scene->stages[it.stage].name, it.wall, before ? "that stage" : "this line");
}

/* Warns of recorded quantities that are 0 because a stage removes their particle or wall, and of those of a box that
 * has lost a wall. Position and angle keep their last values, so there is no warning of them. */
static void warn_removed(struct nb_outcome *outcome, const struct nb_page_run *run) {
  const struct nb_scene *const scene = &run->scene;
  const int box = nb_box_first_wall(scene);
  for (size_t c = 0; c < scene->column_count; c++) {
    const struct nb_quantity *const quantity = &scene->columns[c].quantity;
    const char *const name = quantity->kind->name, *const column = scene->columns[c].name;
    const bool kept = strcmp(name, "x") == 0 || strcmp(name, "y") == 0 || strcmp(name, "angle") == 0;
    const bool of_box = quantity->kind->monitors == NB_OF_BOX;
    struct removal it = {.stage = -1};
    if (of_box)
      it = removal_of_walls(scene, box, NB_BOX_SIDES);
    else if (quantity->monitor >= 0)
      it = removal_of_monitor(scene, &scene->monitors[quantity->monitor]);
    if (it.stage < 0 || kept || is_expected_0(&run->expectations, c))
      continue;
    (of_box ? warn_of_box : warn_of_0)(&outcome->warnings, scene, column, it);
  }
}

/* ---- the imposed work ---- */

static bool is_rate(const struct nb_strain_rate *rate) {
  return rate->xx != 0 || rate->xy != 0 || rate->yx != 0 || rate->yy != 0;
}

/* True if a stage imposes a motion or a stress on particles, so that the imposed work is not 0. */
static bool imposes(const struct nb_scene *scene) {
  bool found = false;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *const stage = &scene->stages[s];
    found = found || (stage->servo.line && !stage->servo.box) || is_rate(&stage->affine.strain) ||
            is_rate(&stage->boundary.strain) || is_rate(&stage->cell) ||
            (stage->boundary.line && stage->boundary.control == NB_CONTROL_STRESS);
  }
  return found;
}

/* True if walls or fixed particles move. */
static bool moves_walls(const struct nb_scene *scene) {
  bool found = false;
  for (size_t w = 0; w < scene->wall_count; w++)
    found = found || scene->walls[w].vx != 0 || scene->walls[w].vy != 0 || scene->walls[w].spin != 0;
  for (size_t k = 0; k < scene->particle_count; k++) {
    const struct nb_particle *const it = &scene->particles[k];
    found = found || (it->fixed && (it->vx != 0 || it->vy != 0 || it->spin != 0));
  }
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *const stage = &scene->stages[s];
    found = found || stage->motion_count > 0 || is_rate(&stage->box) || (stage->servo.line && stage->servo.box);
  }
  return found;
}

/* Warns of a recorded imposed work that is 0, because only walls and fixed particles move. A page that records the work
 * of the walls, too, records the balance of energy and has no warning. */
static void warn_imposed(struct nb_outcome *outcome, const struct nb_page_run *run) {
  const struct nb_scene *const scene = &run->scene;
  const int imposed = NB_FIND(scene->columns, scene->column_count, "energy.imposed");
  if (imposed >= 0 && NB_FIND(scene->columns, scene->column_count, "energy.walls") < 0 &&
      !is_expected_0(&run->expectations, (size_t)imposed) && !imposes(scene) && moves_walls(scene))
    nb_warn(&outcome->warnings, scene->columns[imposed].line,
            "`energy.imposed` is 0, because only walls and fixed particles move: their work is `energy.walls`");
}

/* Warns of a negative normal force, which the laws of this program cannot give. */
static void warn_of_tension(struct nb_scene *scene, const struct nb_expectation *it) {
  const struct nb_column *column = &scene->columns[it->measure.column];
  const unsigned bounds = nb_quantity_bounds(column->quantity) & (NB_AT_LEAST_0 | NB_AT_LEAST_0_BY_LAW);
  if (it->number < 0 && bounds == NB_AT_LEAST_0_BY_LAW)
    nb_warn(&scene->warnings, it->line,
            "`%s` is 0 or more with all laws of nineball: there are no bonds and no tension, and `cohesion` in "
            "`material` is added to the limit of the shear force%s",
            column->name, it->kind == NB_GREATER ? ". So this expectation always holds" : "");
}

/* True if the expectation compares a value with a number, and not with another measure. */
static bool is_with_number(const struct nb_expectation *it) {
  return (it->kind == NB_EXPECTED && !it->has_scale) || it->has_number;
}

/* Warns of a strain of a cell or a box that is compared with a number in a page with `start`. */
static void warn_of_origin(struct nb_scene *scene, const struct nb_expectation *it) {
  const char *const name = scene->columns[it->measure.column].name, *const dot = strrchr(name, '.');
  const bool cell = strncmp(name, "cell.strain.", 12) == 0, box = strncmp(name, "box.strain.", 11) == 0;
  if (scene->start.stages == 0 || !is_with_number(it) || !(cell || box))
    return;
  nb_warn(
      &scene->warnings, it->line,
      "`%s` counts from the start of the first page; the strain of the particles since stage `%s` is `S.strain.%s`, "
      "with `region S all from %s`",
      name, scene->stages[scene->start.stages].name,
      cell                         ? dot + 1
      : strcmp(dot, ".width") == 0 ? "xx"
                                   : "yy",
      scene->stages[scene->start.stages].name);
}

/* Warns of expectations on a negative pressure, and on a stress other than the one that the servo of their stage
 * controls. `above` may have a negative value, as the lower bound of a magnitude. False: out of memory. */
static bool warn_of_stresses(struct nb_page_run *run) {
  struct nb_scene *const scene = &run->scene;
  for (size_t k = 0; k < run->expectations.count; k++) {
    const struct nb_expectation *it = &run->expectations.list[k];
    const struct nb_column *column = &scene->columns[it->measure.column];
    const size_t stage = it->measure.stage >= 0 ? (size_t)it->measure.stage : scene->stage_count - 1;
    warn_of_origin(scene, it);
    if (is_with_number(it) && it->kind != NB_GREATER)
      nb_tension_warn(scene, &column->quantity, column->name, it->kind == NB_LESS ? "below" : "expected", it->number,
                      it->line);
    if (is_with_number(it))
      warn_of_tension(scene, it);
    if (it->kind == NB_EXPECTED && !it->has_scale &&
        !nb_servo_compare(scene, stage, column->quantity, column->name, "expectation", it->line))
      return false;
  }
  return true;
}

/* True if a line of the page uses one of the names of a sweep. */
static bool is_sweep_used(const struct nb_scene *scene, int sweep) {
  bool used = false;
  for (size_t k = 0; k < scene->binding_count; k++)
    used = used || (scene->bindings[k].sweep == sweep && scene->bindings[k].used);
  return used;
}

/* Warns of a `let` that no line uses, and of a `sweep`, because its runs are equal. */
static void warn_unused_names(struct nb_outcome *outcome, const struct nb_scene *scene) {
  for (size_t k = 0; k < scene->binding_count && outcome->mistakes.total == 0; k++) {
    const struct nb_binding *const it = &scene->bindings[k];
    const bool first = k == 0 || scene->bindings[k - 1].sweep != it->sweep;
    if (it->sweep < 0 && !it->used)
      nb_warn(&outcome->warnings, it->line, "no line uses `$%s`: write `$%s` where the value belongs", it->name,
              it->name);
    if (it->swept && first && !is_sweep_used(scene, it->sweep))
      nb_warn(&outcome->warnings, it->line,
              "no line uses `$%s`, so the runs of this `sweep` are equal: write `$%s` where the value belongs",
              it->name, it->name);
  }
}

void nb_outcome_read_runs(struct nb_outcome *outcome, size_t particles_kept) {
  const nb_settings settings = outcome->settings;
  size_t particles = 0;
  struct nb_scene first;
  nb_scene_read(&first, &outcome->page, 0, settings, &outcome->mistakes);
  outcome->runs = calloc(first.runs, sizeof *outcome->runs);
  if (!outcome->runs) {
    nb_mistake_memory(&outcome->mistakes);
    nb_scene_free(&first);
    return;
  }
  outcome->runs[0].scene = first;
  for (size_t r = 0; r < first.runs && (r == 0 || outcome->mistakes.total == 0); r++) {
    struct nb_page_run *run = &outcome->runs[outcome->run_count++];
    if (r > 0)
      nb_scene_read(&run->scene, &outcome->page, r, settings, &outcome->mistakes);
    nb_expectations_read(&run->expectations, &outcome->page, &run->scene, &outcome->mistakes);
    track_columns(run);
    /* a scene with mistakes may have no stage */
    if (outcome->mistakes.total == 0 && !warn_of_stresses(run))
      nb_mistake_memory(&outcome->mistakes);
    nb_sweep_label(run->label, sizeof run->label, run, NULL);
    add_warnings(outcome, &run->scene.warnings);
    warn_removed(outcome, run);
    warn_imposed(outcome, run);
    if (r == 0)
      warn_unused_names(outcome, &run->scene);
    particles += run->scene.particle_count;
    if (particles > particles_kept)
      release_particles(run);
  }
}

static enum nb_status read_page(struct nb_outcome *outcome, const char *path, nb_settings settings,
                                size_t particles_kept) {
  *outcome = (struct nb_outcome){.settings = settings};
  if (!nb_page_read_kept(&outcome->page, path, &outcome->mistakes) || outcome->page.lines)
    nb_outcome_read_runs(outcome, particles_kept);
  outcome->status = nb_mistakes_status(&outcome->mistakes, 0);
  if (outcome->status == NB_NO_MEMORY)
    nb_error_memory(&outcome->error);
  return outcome->status;
}

enum nb_status nb_outcome_read(struct nb_outcome *outcome, const char *path, nb_settings settings) {
  return read_page(outcome, path, settings, SIZE_MAX);
}

/* Warns of overlaps beyond the theory of elastic spheres: their number in all runs, and the first one. */
static void warn_deep(struct nb_outcome *outcome) {
  unsigned long long count = 0;
  const struct nb_page_run *first = NULL;
  for (size_t r = 0; r < outcome->run_count; r++) {
    count += outcome->runs[r].result.deep;
    first = first || !outcome->runs[r].result.deep ? first : &outcome->runs[r];
  }
  if (first)
    nb_warn(
        &outcome->warnings, 0,
        "overlaps beyond the range of the theory of elastic spheres, in %llu contact updates; the first one is that of "
        "%s%s%s [R89 sec. 6.4.3]",
        count, first->result.deep_first, first->label[0] ? ", run " : "", first->label);
}

/* Callback data of one run. Progress is reported for all runs together; several of them may be running. */
struct run_progress {
  struct nb_outcome *outcome;
  const struct nb_progress *progress;
  double began; /* time at which the runs began, s */
  size_t run;
};

static void report_run_progress(void *data, const char *stage, double fraction, double seconds) {
  const struct run_progress *this = data;
  (void)seconds;
#pragma omp critical(nb_outcome_progress)
  {
    double sum = 0;
    char text[512];
    this->outcome->runs[this->run].done = fraction;
    for (size_t r = 0; r < this->outcome->run_count; r++)
      sum += this->outcome->runs[r].done;
    const char *label = this->outcome->runs[this->run].label;
    snprintf(text, sizeof text, "%s%s%s", stage, label[0] ? " of " : "", label);
    this->progress->call(this->progress->data, text, sum / (double)this->outcome->run_count, nb_clock() - this->began);
  }
}

static void report_run_note(void *data, const char *message) {
  const struct run_progress *this = data;
  const char *label = this->outcome->runs[this->run].label;
  char text[1024];
  snprintf(text, sizeof text, "%s%s%s", message, label[0] ? ", run " : "", label);
#pragma omp critical(nb_outcome_progress)
  this->progress->note(this->progress->data, text);
}

/* The options of a run. The key of its checkpoint is a hash of the settings and of the number of the run. */
static struct nb_options options_of_run(const struct nb_outcome *outcome, const struct nb_options *options,
                                        size_t run) {
  struct nb_options own = options ? *options : (struct nb_options){.threads = 1};
  unsigned long long key = nb_hash(NB_HASH_BEGIN, &run, sizeof run);
  for (size_t k = 0; outcome->settings && outcome->settings[k]; k++)
    key = nb_hash(key, outcome->settings[k], strlen(outcome->settings[k]) + 1);
  own.checkpoint.key = key;
  return own;
}

/* Acquires the lock of the checkpoints, so that only one process saves checkpoints of a page with these settings, from
 * its first run until they are removed. If the process does not resume, no run may have a checkpoint. */
static enum nb_status lock(struct nb_outcome *outcome, const struct nb_options *options) {
  const unsigned long long key = options_of_run(outcome, options, outcome->run_count).checkpoint.key;
  if (!options || !(options->checkpoint.seconds > 0) || outcome->run_count == 0)
    return NB_OK;
  enum nb_status status = nb_checkpoint_lock(&outcome->lock, &outcome->runs[0].scene, options, key, &outcome->error);
  outcome->locked = !status;
  for (size_t r = 0; r < outcome->run_count && !status; r++) {
    const struct nb_options own = options_of_run(outcome, options, r);
    status = nb_checkpoint_absent(&outcome->runs[r].scene, &own, &outcome->error);
  }
  return status;
}

/* Acquires the lock of the output folder, so that only one process writes into it. */
static enum nb_status lock_folder(struct nb_outcome *outcome, const struct nb_options *options) {
  const struct nb_results_kept *results = options ? &options->results : NULL;
  char path[NB_STATE_PATH];
  if (!results || !results->folder || results->verdict_only)
    return NB_OK;
  if (snprintf(path, sizeof path, "%s/nineball", results->folder) >= (int)sizeof path)
    return nb_error_set(&outcome->error, NB_BAD_USE, "the name of the folder is too long: %.200s…", results->folder);
  enum nb_status status = nb_folder_create(results->folder, &outcome->error);
  if (!status)
    status = nb_lock_own(&outcome->output, path, "writes into this folder", "-o", &outcome->error);
  outcome->output_locked = !status;
  return status;
}

static void unlock(struct nb_outcome *outcome) {
  if (outcome->locked)
    nb_lock_release(&outcome->lock);
  if (outcome->output_locked)
    nb_lock_release(&outcome->output);
  outcome->locked = outcome->output_locked = false;
}

/* Keeps the parts of a result that are needed later. */
static void keep_result(struct nb_outcome *outcome, struct nb_page_run *run, const struct nb_results_kept *results,
                        const struct nb_progress *progress) {
  struct nb_error error = {NB_OK, ""};
  if (results->verdict_only)
    nb_result_free_snapshots(&run->result);
#pragma omp critical(nb_outcome_spool)
  if (results->folder && nb_spool_put(&outcome->spool, run, results, &error) && !outcome->noted)
    outcome->noted = true, nb_note(progress, error.text);
}

static void run_with(struct nb_outcome *outcome, struct nb_page_run *run, const struct nb_options *options,
                     const struct nb_progress *progress) {
  run->status = NB_OK;
  if (run->released)
    read_again(outcome, run);
  if (!run->status && run->expectations.reference)
    run->status = nb_reference_solve(run->expectations.reference, &run->solution, &run->scene, &run->error);
  if (!run->status)
    run->status = nb_run(&run->result, &run->scene, options, progress, &run->error);
  keep_result(outcome, run, &options->results, progress);
  if (run->released)
    release_particles(run);
}

int nb_job_count(const struct nb_options *options, size_t most) {
  int jobs = options ? options->jobs : 1;
#ifdef _OPENMP
  if (jobs <= 0)
    jobs = omp_get_num_procs() / (options->threads > 0 ? options->threads : 1);
#endif
  if (jobs > (int)most)
    jobs = (int)most;
  return jobs > 0 ? jobs : 1;
}

/* Runs the run with index `r`. `began`: time at which the runs began, s. */
static void run_one(struct nb_outcome *outcome, size_t r, const struct nb_options *options,
                    const struct nb_progress *progress, double began) {
  const struct nb_options own = options_of_run(outcome, options, r);
  struct run_progress run_progress = {outcome, progress, began, r};
  const struct nb_progress run_callbacks = {progress && progress->call ? report_run_progress : NULL,
                                            progress && progress->note ? report_run_note : NULL, &run_progress};
  run_with(outcome, &outcome->runs[r], &own, progress ? &run_callbacks : NULL);
  outcome->runs[r].done = 1;
}

/* Copies the error of the first run that failed to the outcome. False: no run has failed. */
static bool first_error(struct nb_outcome *outcome) {
  for (size_t r = 0; r < outcome->run_count; r++) {
    const struct nb_page_run *run = &outcome->runs[r];
    if (!run->status)
      continue;
    nb_error_set(&outcome->error, run->status, "%s%s%s%s", run->error.text, run->label[0] ? " (run " : "", run->label,
                 run->label[0] ? ")" : "");
    outcome->error.line = run->error.line;
    return true;
  }
  return false;
}

bool nb_is_stopped(const struct nb_options *options) {
  return options && options->checkpoint.stop && *options->checkpoint.stop;
}

/* `failed`: the smallest index of a run that has failed. True if run `r` has a smaller one. */
static bool comes_before(size_t r, const size_t *failed) {
  bool before;
#pragma omp critical(nb_outcome_failed)
  before = r < *failed;
  return before;
}

static void note_failure(size_t *failed, size_t r) {
#pragma omp critical(nb_outcome_failed)
  *failed = r < *failed ? r : *failed;
}

/* When a run has failed, only runs before it are still started. So the failed run that is reported is the first one, and
 * all runs before it have results. Neither depends on the number of jobs or on the speed of a thread. */
enum nb_status nb_outcome_run(struct nb_outcome *outcome, const struct nb_options *options,
                              const struct nb_progress *progress) {
  const size_t runs = outcome->run_count;
  const double began = nb_clock();
  const int jobs = nb_job_count(options, runs);
  size_t failed = runs;
  bool stopped = false;
  if (lock(outcome, options))
    return outcome->error.status;
  nb_references_prepare();
#pragma omp parallel for num_threads(jobs) schedule(dynamic, 1) reduction(|| : stopped)
  for (size_t r = 0; r < runs; r++) {
    stopped = stopped || nb_is_stopped(options);
    if (stopped || !comes_before(r, &failed))
      continue;
    run_one(outcome, r, options, progress, began);
    stopped = stopped || nb_is_stopped(options);
    if (outcome->runs[r].status)
      note_failure(&failed, r);
  }
  for (size_t r = 0; r < runs; r++)
    add_warnings(outcome, &outcome->runs[r].result.warnings);
  warn_deep(outcome);
  if (first_error(outcome))
    return outcome->error.status;
  return stopped ? nb_error_set(&outcome->error, NB_BROKEN, "stopped by a signal between two runs") : NB_OK;
}

void nb_outcome_remove_checkpoints(struct nb_outcome *outcome, const struct nb_options *options) {
  for (size_t r = 0; r < outcome->run_count; r++)
    nb_checkpoint_remove(&outcome->runs[r].scene, options, options_of_run(outcome, options, r).checkpoint.key);
  unlock(outcome);
}

enum nb_status nb_outcome_make(struct nb_outcome *outcome, const char *path, nb_settings settings,
                               const struct nb_options *options, const struct nb_progress *progress) {
  read_page(outcome, path, settings, PARTICLES_KEPT);
  if (!outcome->status)
    outcome->status = lock_folder(outcome, options);
  if (!outcome->status)
    outcome->status = nb_outcome_run(outcome, options, progress);
  if (!outcome->status)
    outcome->status = nb_verdict(outcome);
  return outcome->status;
}

void nb_outcome_free_runs(struct nb_outcome *outcome) {
  unlock(outcome);
  for (size_t r = 0; r < outcome->run_count; r++) {
    struct nb_page_run *run = &outcome->runs[r];
    nb_expectations_free(&run->expectations);
    solution_free(&run->solution);
    nb_result_free(&run->result);
    nb_scene_free(&run->scene);
  }
  nb_spool_free(&outcome->spool);
  free(outcome->runs);
  outcome->runs = NULL, outcome->run_count = 0;
}

void nb_outcome_free(struct nb_outcome *outcome) {
  nb_outcome_free_runs(outcome);
  for (size_t k = 0; k < outcome->check_count; k++)
    free(outcome->checks[k].points);
  free(outcome->checks);
  nb_page_free(&outcome->page);
  nb_mistakes_free(&outcome->mistakes);
  *outcome = (struct nb_outcome){0};
}
