/* The expected cost of a run (cost.c), and its plan (explain.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <math.h>

#include "nineball.h"

struct nb_page_run;
struct nb_outcome; /* outcome.h */

struct nb_bounds {
  double from, to;
};
struct nb_length {
  struct nb_bounds cycles;
  bool about;   /* a condition on the clock needs a step, of this stage or an earlier one, that is not known yet */
  bool endless; /* the conditions of the stage do not hold within the largest number of cycles */
};
struct nb_cost {
  struct nb_bounds cycles, updates; /* contact updates */
  struct nb_bounds seconds;  /* processor time, s, with reading, reference, tables and verdict, without the figure */
  struct nb_bounds measured; /* the part of `seconds` that the cycles take; 0: could not be measured */
  bool aborts;               /* the trial was aborted before it shortened any stage, so the run will be, too */
  struct nb_error reference; /* the error of the reference, with which the run is aborted; NB_OK: none */
  double reading;            /* time per run to start the program and to read the page, s; the caller sets it */
  struct nb_length *lengths; /* for each stage; owned */
};
/* Finds the expected cost of a run. The model is at the beginning of the run, and its clock is changed; for a contact
 * test it is NULL. If the time of a cycle cannot be measured, returns NB_OK with the reason in error->text. The caller
 * frees cost->lengths in any case. */
enum nb_status nb_cost_expect(struct nb_cost *cost, const struct nb_page_run *run, struct nb_model *model,
                              const struct nb_options *options, struct nb_error *error);
/* Finds only the bounds of the cycles, without a model. A stage with conditions lasts from the first cycle in which they
 * are tested to its largest number of cycles, because the clock is not known. */
enum nb_status nb_cost_bounds(struct nb_cost *cost, const struct nb_scene *scene, struct nb_error *error);
void nb_cost_add(struct nb_cost *sum, const struct nb_cost *cost);
void nb_cost_print(FILE *out, const struct nb_cost *cost, const char *cycles); /* " cycles" or " steps" */
void nb_cost_print_length(FILE *out, const struct nb_length *length, const struct nb_stage *stage);
/* True if a time differs from the expected time by more than a fifth of the expected time. */
static inline bool nb_time_differs(double seconds, double expected) {
  return fabs(seconds - expected) > 0.2 * expected;
}
/* Prints one line: the cost of the runs of an outcome, with the processor time `seconds` of the whole page. If a stage
 * has a condition other than one on the clock, the line also has the bounds of the number of cycles, unless they are
 * equal. Otherwise, for a long run whose time differs from the expected time by more than a fifth, it also has the
 * expected time. For a contact test it has neither. */
void nb_cost_print_actual(FILE *out, const struct nb_outcome *outcome, double seconds,
                          const struct nb_options *options);
/* Processor time of the program since its start, of all threads, s. */
double nb_cost_clock(void);
/* Processor time to write an empty file, s; 0 if no temporary folder can be made. */
double nb_cost_file(void);

/* Prints the plan and the lines of the page that require it, memory, the step and its limit, stages and cost; for a
 * contact test the contact, its laws and its segments. Adds the warnings of the plan, and adds the cost to `sum`. */
enum nb_status nb_explain(FILE *out, const struct nb_scene *scene, const struct nb_page_run *run,
                          const struct nb_options *options, struct nb_warnings *warnings, struct nb_cost *sum,
                          struct nb_error *error);
