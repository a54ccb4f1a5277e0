/* The words of expect blocks, and the parts of an expectation, taken from a line: false when a mistake has been said.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_EXPECT_TAKE_H
#define NB_EXPECT_TAKE_H

#include "expect.h"
#include "input/reader.h"

/* How the rows of a table become one number. */
struct nb_reducer_row {
  const char *word;
  enum nb_reducer reducer;
  const char *help;
};
const struct nb_reducer_row *nb_reducer_rows(void); /* ends in a row without a word */

/* What may be expected of a measure. */
struct nb_expectation_row {
  const char *word; /* that follows the measure */
  enum nb_expectation_kind kind;
  const char *syntax; /* of the whole statement, for the manual */
  /* Reads from the word on; what is measured is in place. */
  bool (*take)(struct nb_reader *reader, const struct nb_scene *scene, struct nb_expectation *expectation);
  const char *help;
  const char *example; /* as those of struct nb_keyword */
};
const struct nb_expectation_row *nb_expectation_rows(void); /* ends in a row without a word */
/* The statements of expect blocks: `reference NAME`, and all others. */
const struct nb_family *nb_expect_keywords(void);

/* The column of the scene's table that the token names, and its quantity. */
bool nb_find_column(struct nb_reader *reader, const struct nb_scene *scene, const struct nb_token *token,
                    size_t *column, struct nb_quantity *quantity);
/* `in STAGE`, or nothing. */
bool nb_take_stage(struct nb_reader *reader, const struct nb_scene *scene, struct nb_measure *measure);
/* QUANTITY {reducer} {in STAGE} */
bool nb_take_measure(struct nb_reader *reader, const struct nb_scene *scene, struct nb_measure *measure);
/* `within 0.1 %`, `within 2 nm`, `within 1e-12`, `within 0.5 % of peak`, `within 1e-9 of energy.kinetic max`: the last of a
 * measure of the scene, NULL where none is meant. */
bool nb_take_tolerance(struct nb_reader *reader, const struct nb_scene *scene, const char *unit,
                       struct nb_tolerance *tolerance);

#endif
