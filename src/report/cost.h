/* What a run is expected to cost: cost.c. And its plan: explain.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_COST_H
#define NB_COST_H

#include <math.h>

#include "nineball.h"

struct nb_page_run;
struct nb_outcome; /* outcome.h */

struct nb_bounds {
  double from, to;
};
struct nb_length {
  struct nb_bounds cycles;
  bool about;   /* the step of the stage depends on the state when it begins */
  bool endless; /* its conditions do not hold within the largest number of cycles */
};
struct nb_cost {
  struct nb_bounds cycles, updates; /* contact updates */
  struct nb_bounds seconds;         /* processor time, with reading, reference, tables and verdict, without figure; */
  struct nb_bounds measured;        /* its cycles with conditions and rows. 0: could not be measured */
  double reading;                   /* s of a run: start of the program, reading, files of a page; set by the caller */
  struct nb_length *lengths;        /* for each stage; owned */
};
/* The model is at the beginning of the run; its clock is changed. NULL: a contact test. NB_OK with error->text if the
 * time of a cycle cannot be measured. The caller frees cost->lengths in any case. */
enum nb_status nb_cost_expect(struct nb_cost *cost, const struct nb_page_run *run, struct nb_model *model,
                              const struct nb_options *options, struct nb_error *error);
/* Bounds of the cycles alone, without a model: the clock of the first stage is not known. */
enum nb_status nb_cost_bounds(struct nb_cost *cost, const struct nb_scene *scene, struct nb_error *error);
void nb_cost_add(struct nb_cost *sum, const struct nb_cost *cost);
void nb_cost_print(FILE *out, const struct nb_cost *cost, const char *cycles); /* " cycles" or " steps" */
void nb_cost_print_length(FILE *out, const struct nb_length *length, const struct nb_stage *stage);
/* Whether a time differs from the expected one by more than a fifth of it. */
static inline bool nb_time_differs(double seconds, double expected) {
  return fabs(seconds - expected) > 0.2 * expected;
}
/* Prints one line: what the runs of an outcome have cost, with the processor time `seconds` of the whole page. The
 * expected cost is beside it if a condition decides the length, or if the time differs by more than a fifth. */
void nb_cost_print_actual(FILE *out, const struct nb_outcome *outcome, double seconds,
                          const struct nb_options *options);
/* Processor time of the program since its start, of all threads, s. */
double nb_cost_clock(void);
/* Processor time to write an empty file, s. */
double nb_cost_file(void);

/* Prints the plan and the lines that require it, memory, the step and what limits it, stages and cost; for a contact
 * test the contact, its laws and its segments. Adds the warnings of the plan, and the cost to `sum`. */
enum nb_status nb_explain(FILE *out, const struct nb_scene *scene, const struct nb_page_run *run,
                          const struct nb_options *options, struct nb_warnings *warnings, struct nb_cost *sum,
                          struct nb_error *error);

#endif
