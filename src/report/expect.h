/* The expectations of a page: its `expect` blocks.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/error.h"

struct nb_reference;

/* The ways in which the rows of a stage become one number. */
enum nb_reducer { NB_LAST, NB_MAX, NB_MIN, NB_MEAN, NB_AMPLITUDE, NB_FREQUENCY, NB_AT_CYCLE, NB_AT_TIME };
/* True if the value depends only on the largest and the smallest row. */
static inline bool nb_is_extreme(enum nb_reducer reducer) {
  return reducer == NB_MAX || reducer == NB_MIN || reducer == NB_AMPLITUDE;
}

enum { NB_STAGE_ALL = -2 };

/* `C.normal mean in rest` */
struct nb_measure {
  char label[4 * NB_NAME_SIZE]; /* quantity, reducer, stage; references use the same labels */
  size_t bare_length;           /* length of the label without ` in STAGE` */
  size_t column;                /* index of the column of the table */
  const char *unit;             /* NULL: unknown, because of a mistake in the scene */
  unsigned bounds;              /* set of enum nb_bound (core/names.h) */
  enum nb_reducer reducer;
  double at;        /* for NB_AT_CYCLE the number of the cycle, for NB_AT_TIME the time, s */
  int stage;        /* index; NB_STAGE_ALL: `in all`; -1: not given (see nb_measure_rows) */
  bool is_residual; /* the quantity is a residual: it should be 0 and needs no reference */
};

enum nb_tolerance_kind { NB_ABSOLUTE, NB_RELATIVE, NB_OF_PEAK, NB_OF_MEASURE };
struct nb_tolerance {
  enum nb_tolerance_kind kind;
  double value;         /* SI, or a fraction */
  struct nb_measure of; /* NB_OF_MEASURE: the tolerance is a fraction of this measure, in the same run */
  char text[NB_NAME_SIZE];
};

enum nb_expectation_kind {
  NB_WITHIN,   /* agrees with the reference */
  NB_VERSUS,   /* a curve agrees with the reference at every row */
  NB_EXPECTED, /* agrees with a number of the page */
  NB_LESS,     /* less than another measure of the same run, or than a number */
  NB_GREATER,
  NB_INCREASES, /* increases from each value of a sweep to the next larger one */
  NB_DECREASES,
  NB_CONSTANT, /* differs between the values of a sweep by at most the tolerance */
  NB_ORDER,    /* the error is proportional to this power of the swept value */
  NB_REPORTED  /* nothing is expected */
};

struct nb_expectation {
  enum nb_expectation_kind kind;
  struct nb_measure measure;
  /* NB_LESS, NB_GREATER: the measure to compare with, unless `has_number`. NB_EXPECTED with `has_scale`: `number` is a
   * fraction of this measure. */
  struct nb_measure other;
  bool has_scale, has_number;
  struct nb_tolerance tolerance;
  double number; /* NB_EXPECTED, NB_LESS, NB_GREATER: SI; NB_ORDER: the power */
  /* NB_VERSUS: the independent variable, `time`; NB_INCREASES to NB_ORDER: the swept name */
  char against[2 * NB_NAME_SIZE];
  char sample[2 * NB_NAME_SIZE]; /* the sweep whose runs are realizations of the case; empty: none */
  size_t column;                 /* index of the column of the independent variable */
  int line;
};

struct nb_expectations {
  const struct nb_reference *reference; /* NULL: none */
  struct nb_expectation *list;          /* owned */
  size_t count;
};

/* A row of the words for reducers; the list ends in a row without a word. */
struct nb_reducer_row {
  const char *word;
  enum nb_reducer reducer;
  const char *help;
};
const struct nb_reducer_row *nb_reducer_rows(void);

struct nb_reader;
/* A row of the kinds of expectations; the list ends in a row without a word. */
struct nb_expectation_row {
  const char *word; /* the word after the measure */
  enum nb_expectation_kind kind;
  const char *syntax; /* syntax of the whole statement, for the manual */
  /* Reads the rest of the line after the word. The measure has been read before. False: there is a mistake. */
  bool (*take)(struct nb_reader *reader, const struct nb_scene *scene, struct nb_expectation *expectation);
  const char *help;
  const char *example; /* as in struct nb_keyword */
};
const struct nb_expectation_row *nb_expectation_rows(void);
struct nb_family;
/* The statements of expect blocks: `reference NAME`, `report MEASURE`, and expectations. */
const struct nb_family *nb_expect_keywords(void);

/* Reads the expect blocks of the page for one run. After a mistake `expectations` is empty; the function returns
 * NB_BAD_USE, or NB_NO_MEMORY. The scene may have mistakes. A name that is undefined because of such a mistake is not
 * reported again. */
enum nb_status nb_expectations_read(struct nb_expectations *expectations, const struct nb_page *page,
                                    const struct nb_scene *scene, struct nb_mistakes *mistakes);
/* Reads "MEASURE within TOLERANCE" from a text that is not a line of a page; messages call the text `name`. */
enum nb_status nb_expectation_read(struct nb_expectation *expectation, const char *name, const char *text,
                                   const struct nb_scene *scene, struct nb_mistakes *mistakes);
void nb_expectations_free(struct nb_expectations *expectations);
