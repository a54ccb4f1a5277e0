/* The results that runs record, and reports of progress (result.c). run.c and contact_test.c use them.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/model.h"

/* The first function makes an empty table with the columns of the scene, and the list of the costs of stages; the
 * second function adds a row. Both return false when out of memory. The caller frees the result, also then. */
bool nb_result_begin(struct nb_result *result, const struct nb_scene *scene);
bool nb_result_add_row(struct nb_table *table, const struct nb_model *model, int stage);
/* Updates the extremes of the tracked columns in this stage. */
void nb_result_track(struct nb_result *result, const struct nb_model *model, int stage);
/* Sets the extremes of columns that are not tracked to the infinite interval: they are unknown, and stay so. */
void nb_result_forget_extremes(struct nb_result *result, const struct nb_scene *scene);
/* The set of contact fields that columns, conditions, servos and snapshots of the scene read, and the NB_REQUEST_ bits
 * (model.h) of other data that they need. */
unsigned nb_fields_requested(const struct nb_scene *scene);

/* Reports the progress of a run, at most ten times a second. `progress` may be NULL. A trial, which has stage_seconds,
 * ends each stage after this time; nb_reporter_update then returns false. */
struct nb_reporter {
  const struct nb_progress *progress;
  double began, last_call; /* s */
  double stage_began;      /* value of nb_processor_clock when the stage began, s */
};
struct nb_reporter nb_reporter_begin(const struct nb_progress *progress);
bool nb_reporter_update(struct nb_reporter *reporter, const char *stage, double fraction);
/* Processor time of this thread, s. */
double nb_processor_clock(void);
