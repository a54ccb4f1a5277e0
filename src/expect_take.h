/* The parts of an expectation, taken from a line: false when a mistake has been said.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_EXPECT_TAKE_H
#define NB_EXPECT_TAKE_H

#include "expect.h"
#include "reader.h"

/* The column of the scene's table that the token names. */
bool nb_find_column(struct nb_reader *reader, const struct nb_scene *scene, const struct nb_token *token,
                    size_t *column);
/* `in STAGE`, or nothing. */
bool nb_take_stage(struct nb_reader *reader, const struct nb_scene *scene, struct nb_measure *measure);
/* QUANTITY {reducer} {in STAGE} */
bool nb_take_measure(struct nb_reader *reader, const struct nb_scene *scene, struct nb_measure *measure);
/* `within 0.1 %`, `within 2 nm`, `within 1e-12`, `within 0.5 % of peak` */
bool nb_take_tolerance(struct nb_reader *reader, const char *unit, struct nb_tolerance *tolerance);

#endif
