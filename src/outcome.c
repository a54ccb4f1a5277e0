/* A page carried out: read, run by run; asked of the reference; judged.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "outcome.h"

#include <stdlib.h>
#include <string.h>

enum { ENOUGH = 100000 }; /* mistakes, most of them the same ones of many runs: then the other runs are not read */

static void make_label(struct nb_page_run *run) {
  run->label[0] = 0;
  for (size_t k = 0; k < run->scene.binding_count; k++) {
    const struct nb_binding *binding = &run->scene.bindings[k];
    const size_t length = strlen(run->label);
    if (binding->swept)
      snprintf(run->label + length, sizeof run->label - length, "%s%s=%s", length ? ", " : "", binding->name,
               binding->text);
  }
}

enum nb_status nb_outcome_read(struct nb_outcome *outcome, const char *path, nb_settings settings) {
  *outcome = (struct nb_outcome){0};
  outcome->status = nb_page_read(&outcome->page, path, &outcome->mistakes);
  if (outcome->status)
    return outcome->status;
  const size_t runs = nb_scene_runs(&outcome->page, settings, &outcome->mistakes);
  outcome->runs = calloc(runs + 1, sizeof *outcome->runs);
  if (!outcome->runs)
    return outcome->status = nb_error_set(&outcome->error, NB_BROKEN, "out of memory for %zu runs", runs);
  for (size_t r = 0; r < runs && outcome->mistakes.made < ENOUGH; r++) {
    struct nb_page_run *run = &outcome->runs[outcome->run_count++];
    nb_scene_read(&run->scene, &outcome->page, r, settings, &outcome->mistakes);
    nb_expectations_read(&run->expectations, &outcome->page, &run->scene, &outcome->mistakes);
    make_label(run);
  }
  if (outcome->mistakes.count)
    outcome->status = NB_BAD_USE;
  return outcome->status;
}

static enum nb_status run_one(struct nb_outcome *outcome, struct nb_page_run *run, const struct nb_options *options,
                              const struct nb_progress *progress) {
  struct nb_error *error = &outcome->error;
  enum nb_status status = NB_OK;
  if (run->expectations.reference)
    status = run->expectations.reference->know(&run->known, &run->scene, error);
  if (!status)
    status = nb_run(&run->result, &run->scene, options, progress, error);
  if (status && run->label[0]) {
    const size_t length = strlen(error->text);
    snprintf(error->text + length, sizeof error->text - length, " (run %s)", run->label);
  }
  return status;
}

enum nb_status nb_outcome_make(struct nb_outcome *outcome, const char *path, nb_settings settings,
                               const struct nb_options *options, const struct nb_progress *progress) {
  nb_outcome_read(outcome, path, settings);
  for (size_t r = 0; r < outcome->run_count && !outcome->status; r++)
    outcome->status = run_one(outcome, &outcome->runs[r], options, progress);
  if (!outcome->status)
    outcome->status = nb_verdict(outcome);
  return outcome->status;
}

void nb_outcome_free(struct nb_outcome *outcome) {
  for (size_t r = 0; r < outcome->run_count; r++) {
    struct nb_page_run *run = &outcome->runs[r];
    nb_expectations_free(&run->expectations);
    known_free(&run->known);
    nb_result_free(&run->result);
    nb_scene_free(&run->scene);
  }
  free(outcome->runs);
  free(outcome->checks);
  nb_page_free(&outcome->page);
  nb_mistakes_free(&outcome->mistakes);
  *outcome = (struct nb_outcome){0};
}
