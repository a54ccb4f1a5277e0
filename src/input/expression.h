/* Expressions with units.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_EXPRESSION_H
#define NB_EXPRESSION_H

#include "reader.h"

/* The value of an expression, a piece of a line of the page; false with a message. A literal with or without its unit keeps its text. */
bool nb_expression(struct nb_reader *reader, const char *line, const char *at, const char *end,
                   struct nb_binding *value);
/* The same of a number and its unit, which may be NULL; of a computed number the value is written anew. */
enum nb_reading nb_literal(struct nb_binding *value, const char *number, const char *unit, bool computed);
/* Writes the value anew: shortest decimal number that reads back to its bits, in the SI unit of its dimension. */
void nb_value_write(struct nb_binding *value);
/* Whether a name means something in every expression: a function or pi. */
bool nb_name_reserved(const char *name);
extern const char nb_function_names[]; /* for the manual: "sqrt, sin, …" */

#endif
