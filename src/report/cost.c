/* The expected cost of a run.
 *
 * The number of cycles of a stage is fixed by `cycles`, or by conditions that read only the clock, such as `until time
 * above 2 ms`: the program evaluates such conditions at the times of later cycles, without running these cycles. Any
 * other condition gives only bounds of the number. The cost of a cycle is measured by a trial: a run whose stages end
 * after 1 ms to 50 ms each. A trial tests conditions and records rows as the run does, but its later stages begin from
 * the state that the shortened stages before them have reached. Its rows and snapshots are written and checked, which
 * measures the cost of tables and verdict.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include "commands.h"
#include "core/model.h"
#include "core/names.h"
#include "measure/snapshot.h"
#include "run/restart.h"
#include "run/result.h"

static const double trial_seconds = 0.05, least_stage_seconds = 1e-3;

double nb_cost_clock(void) {
  struct timespec t = {0};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* ---- lengths of the stages ---- */

/* The clock when a stage begins: earliest and latest. */
struct clock {
  double cycle[2], time[2]; /* number of the cycle; time, s */
};

static bool is_clock(const struct nb_condition *condition) {
  return condition->relation == NB_ABOVE && condition->quantity.kind->fields & NB_REQUEST_CLOCK;
}

/* The first cycle of the stage in which its conditions on the clock are tested and hold; if there is no such cycle, the
 * largest number of cycles of the stage + 1. The stage begins at the earliest time if `which` is 0, at the latest if it
 * is 1. */
static unsigned long first_cycle(struct nb_model *model, const struct nb_stage *stage, const struct clock *begin,
                                 int which, double step) {
  const unsigned long most = stage->cycles, every = stage->check_interval, tests = (most - 1) / every + 1;
  unsigned long from = 1, to = tests + 1;
  while (from < to) {
    const unsigned long middle = from + (to - from) / 2, n = middle < tests ? middle * every : most;
    bool met = true;
    model->cycle = (unsigned long)begin->cycle[which] + n, model->stage_cycle = n, model->step = step;
    model->time = begin->time[which] + (double)n * step;
    for (size_t k = 0; k < stage->condition_count; k++)
      met = met && (!is_clock(&stage->conditions[k]) || nb_condition_met(&stage->conditions[k], model));
    if (met)
      to = middle;
    else
      from = middle + 1;
  }
  return from < tests ? from * every : from == tests ? most : most + 1;
}

/* True if the step of the stage is known before the run: the stage is the first one, the page gives the step as a time,
 * or the step depends neither on contacts and velocities nor on what an earlier stage changes or removes. */
static bool step_is_known(const struct nb_scene *scene, size_t index) {
  const enum nb_step_kind kind = scene->stages[index].step.kind;
  bool changes = false;
  for (size_t s = scene->start.stages; s < index; s++)
    changes = changes || scene->stages[s].change_count > 0 || scene->stages[s].removal_count > 0;
  return index == scene->start.stages || kind == NB_STEP_TIME ||
         (kind != NB_STEP_STABLE && kind != NB_STEP_COLLISION && !changes);
}

/* Sets the lengths of the stages with the steps of the trial. If it did not reach a stage, the step is the one that the
 * page gives, or about that of the stage before. The clock and the step of the model are changed. */
static void find_lengths(struct nb_cost *cost, const struct nb_scene *scene, struct nb_model *model,
                         const struct nb_result *trial) {
  struct clock now = {{(double)model->cycle, (double)model->cycle}, {model->time, model->time}};
  double step = model->step;
  bool about = false;
  for (size_t s = scene->start.stages; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    struct nb_length *length = &cost->lengths[s];
    bool decided = true, clock = false;
    const bool reached = trial->stages && trial->stages[s].step > 0, given = stage->step.kind == NB_STEP_TIME;
    step = reached ? trial->stages[s].step : given ? stage->step.value : step;
    about = about || !step_is_known(scene, s) || !(reached || given || s == scene->start.stages);
    for (size_t k = 0; k < stage->condition_count; k++) {
      const bool is = is_clock(&stage->conditions[k]);
      decided = decided && is, clock = clock || is;
    }
    if (stage->condition_count > 0) {
      length->cycles.from = (double)first_cycle(model, stage, &now, 1, step);
      length->cycles.to = decided ? (double)first_cycle(model, stage, &now, 0, step) : length->cycles.to;
      length->about = about && clock;
      length->endless = length->cycles.from > (double)stage->cycles;
      length->cycles.from = fmin(length->cycles.from, (double)stage->cycles);
      length->cycles.to = fmin(length->cycles.to, (double)stage->cycles);
    }
    now.cycle[0] += length->cycles.from, now.cycle[1] += length->cycles.to;
    now.time[0] += length->cycles.from * step, now.time[1] += length->cycles.to * step;
  }
}

/* ---- the trial ---- */

/* Writes a table, or nothing, to a file in a temporary folder, as `run` does; returns the processor time, s. */
static double write_file(const struct nb_table *table) {
  char folder[] = P_tmpdir "/nineball-XXXXXX", path[sizeof folder + 8];
  struct nb_error error;
  struct nb_save save;
  if (!mkdtemp(folder))
    return 0;
  snprintf(path, sizeof path, "%s/table", folder);
  const double began = nb_processor_clock();
  bool good = !nb_save_begin(&save, path, &error);
  if (good && table)
    nb_table_write(save.file, table);
  good = good && !nb_save_end(&save, &error);
  const double seconds = nb_processor_clock() - began;
  if (good)
    remove(path);
  rmdir(folder);
  return seconds;
}

double nb_cost_file(void) { return write_file(NULL); }

/* Time to write one row of a table that has rows, and to check it against the expectations, s; *snapshots: time to write
 * all snapshots, s. */
static double time_tables(struct nb_page_run *trial, double *snapshots) {
  struct nb_outcome outcome = {.page = *trial->scene.page, .runs = trial, .run_count = 1};
  FILE *out = fopen("/dev/null", "w");
  const struct nb_table *table;
  const char *name;
  if (!out)
    return 0;
  const double began = nb_processor_clock();
  nb_table_write_run(out, trial);
  nb_verdict(&outcome), nb_values_write(out, &outcome), free(outcome.checks);
  const double rows = nb_processor_clock() - began;
  fclose(out), *snapshots = 0;
  for (size_t k = 0; k < trial->result.snapshot_count; k++)
    for (int part = 0; nb_snapshot_part(&trial->result.snapshots[k], part, &name, &table); part++)
      *snapshots += write_file(table);
  return rows / (double)trial->result.table.row_count;
}

static void add(struct nb_bounds *sum, struct nb_bounds range, double factor) {
  sum->from += range.from * factor, sum->to += range.to * factor;
}

/* Adds the costs of the stages, and of the forces at their beginnings, which belong to no cycle. A stage that the trial
 * did not reach is assumed to cost as much per cycle as the previous one. */
static void add_stages(struct nb_cost *cost, const struct nb_scene *scene, const struct nb_result *trial,
                       double row_seconds) {
  struct nb_stage_cost one = {0};
  double starts = (double)trial->updates;
  cost->cycles = (struct nb_bounds){0, 0};
  for (size_t s = scene->start.stages; s < scene->stage_count; s++) {
    const struct nb_bounds cycles = cost->lengths[s].cycles;
    const double every = (double)scene->stages[s].record_interval;
    if (trial->stages && trial->stages[s].cycles > 0 && trial->stages[s].seconds > 0)
      one = trial->stages[s];
    const double n = one.cycles ? (double)one.cycles : 1;
    starts -= trial->stages ? (double)trial->stages[s].updates : 0;
    add(&cost->cycles, cycles, 1);
    add(&cost->updates, cycles, (double)one.updates / n);
    add(&cost->seconds, cycles, one.seconds / n + (every > 0 ? row_seconds / every : 0));
    add(&cost->measured, cycles, one.seconds / n);
  }
  add(&cost->updates, (struct nb_bounds){starts, starts}, 1);
}

enum nb_status nb_cost_bounds(struct nb_cost *cost, const struct nb_scene *scene, struct nb_error *error) {
  *cost = (struct nb_cost){.lengths = calloc(scene->stage_count, sizeof *cost->lengths), .reading = cost->reading};
  if (!cost->lengths)
    return nb_error_memory(error);
  for (size_t s = scene->start.stages; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    const double most = (double)stage->cycles, least = fmin((double)stage->check_interval, most);
    cost->lengths[s].cycles = (struct nb_bounds){stage->condition_count ? least : most, most};
    add(&cost->cycles, cost->lengths[s].cycles, 1);
  }
  return NB_OK;
}

enum nb_status nb_cost_expect(struct nb_cost *cost, const struct nb_page_run *run, struct nb_model *model,
                              const struct nb_options *options, struct nb_error *error) {
  const struct nb_scene *scene = &run->scene;
  const double stages = (double)(scene->stage_count - scene->start.stages);
  const struct nb_progress progress = {.stage_seconds = fmax(trial_seconds / stages, least_stage_seconds)};
  struct nb_page_run trial = *run;
  double spent = 0, snapshots = 0, began = nb_processor_clock();
  if (nb_cost_bounds(cost, scene, error))
    return error->status;
  trial.result = (struct nb_result){0}, trial.solution = (struct nb_solution){0};
  *error = (struct nb_error){NB_OK, ""};
  enum nb_status status = NB_OK;
  if (run->expectations.reference)
    status = nb_reference_solve(run->expectations.reference, &trial.solution, scene, &cost->reference);
  cost->seconds.from = cost->reading + nb_processor_clock() - began, began = nb_processor_clock();
  if (status == NB_NO_MEMORY)
    *error = cost->reference;
  else
    status = nb_run(&trial.result, scene, options, &progress, error);
  cost->aborts = error->status && !trial.result.shortened;
  for (size_t s = scene->start.stages; s < scene->stage_count; s++)
    spent += trial.result.stages ? trial.result.stages[s].seconds : 0;
  cost->seconds.from += nb_processor_clock() - began - spent;
  if (model)
    find_lengths(cost, scene, model, &trial.result);
  const double row = trial.result.table.row_count ? time_tables(&trial, &snapshots) : 0;
  cost->seconds.to = cost->seconds.from += snapshots;
  add_stages(cost, scene, &trial.result, row);
  nb_result_free(&trial.result), solution_free(&trial.solution);
  return status == NB_NO_MEMORY ? status : NB_OK;
}

/* ---- words ---- */

static void print_bounds(FILE *out, struct nb_bounds range, int digits, const char *unit) {
  fprintf(out, "%.*g", digits, range.from);
  if (range.to > range.from)
    fprintf(out, " to %.*g", digits, range.to);
  fputs(unit, out);
}

void nb_cost_print(FILE *out, const struct nb_cost *cost, const char *cycles) {
  print_bounds(out, cost->cycles, 15, cycles);
  if (!(cost->measured.to > 0))
    return;
  fputs(", ", out);
  print_bounds(out, cost->updates, 3, " contact updates, ");
  print_bounds(out, cost->seconds, 3, " s");
}

void nb_cost_print_length(FILE *out, const struct nb_length *length, const struct nb_stage *stage) {
  const int line = stage->condition_count ? stage->conditions[0].line : 0;
  if (length->endless) {
    fprintf(out, "does not end: the condition on line %d does not hold within %lu cycles", line, stage->cycles);
    return;
  }
  fputs(length->about ? "about " : "", out);
  print_bounds(out, length->cycles, 15, " cycles");
  if (length->cycles.to > length->cycles.from)
    fprintf(out, ": the condition on line %d decides", line);
}

void nb_cost_add(struct nb_cost *sum, const struct nb_cost *cost) {
  add(&sum->cycles, cost->cycles, 1), add(&sum->updates, cost->updates, 1), add(&sum->seconds, cost->seconds, 1);
  add(&sum->measured, cost->measured, 1);
}

/* ---- after the runs ---- */

/* Adds the expected costs of the runs, without reference solutions. If `bounds` is true, it adds the bounds of the
 * numbers of cycles and the costs that follow from the steps and times of these runs; otherwise it adds all costs,
 * which it measures by trials. False: the cost is unknown. */
static bool expect_all(struct nb_cost *sum, const struct nb_outcome *outcome, bool bounds,
                       const struct nb_options *options) {
  struct nb_error error;
  bool known = outcome->status <= NB_FAILED;
  for (size_t r = 0; r < outcome->run_count && known; r++) {
    struct nb_page_run run = outcome->runs[r];
    struct nb_model *model = run.released ? NULL : nb_model_create(&run.scene, options, &error);
    struct nb_cost cost = {0};
    run.expectations.reference = NULL;
    known = model &&
            !(bounds ? nb_cost_bounds(&cost, &run.scene, &error) : nb_cost_expect(&cost, &run, model, options, &error));
    if (known && bounds) {
      find_lengths(&cost, &run.scene, model, &run.result);
      add_stages(&cost, &run.scene, &run.result, 0);
    }
    nb_cost_add(sum, &cost);
    free(cost.lengths), nb_model_free(model);
  }
  return known;
}

void nb_cost_print_actual(FILE *out, const struct nb_outcome *outcome, double seconds,
                          const struct nb_options *options) {
  const struct nb_scene *scene = &outcome->runs[0].scene;
  struct nb_cost actual = {0}, expected = {0};
  bool until = false;
  for (size_t r = 0; r < outcome->run_count; r++) {
    const struct nb_result *result = &outcome->runs[r].result;
    const double cycles = (double)result->cycles, updates = (double)result->updates, measured = result->seconds;
    nb_cost_add(
        &actual,
        &(struct nb_cost){.cycles = {cycles, cycles}, .updates = {updates, updates}, .measured = {measured, measured}});
  }
  actual.seconds = (struct nb_bounds){seconds, seconds};
  for (size_t s = scene->start.stages; s < scene->stage_count; s++)
    for (size_t k = 0; k < scene->stages[s].condition_count; k++)
      until = until || !is_clock(&scene->stages[s].conditions[k]);
  nb_cost_print(out, &actual, scene->contact_test ? " steps" : " cycles");
  const double rest = fmax(0, seconds - actual.measured.to);
  /* long: the trials would take less than a twentieth of the time */
  const bool is_long = seconds - rest > 20 * trial_seconds * (double)outcome->run_count;
  if (!scene->contact_test && (until || is_long) && expect_all(&expected, outcome, until, options)) {
    if (expected.cycles.to > expected.cycles.from)
      fputs("; expected ", out), print_bounds(out, expected.cycles, 15, " cycles");
    else if (is_long && nb_time_differs(seconds, expected.measured.to + rest))
      fprintf(out, "; expected %.3g s", expected.measured.to + rest);
  }
  fputc('\n', out);
}
