/* Expressions with units.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "reader.h"

/* Computes the value of the expression from `at` to `end`, a part of a line of the page. False with a message, or
 * without one if it has a suppressed name. A value that is one literal keeps its text. */
bool nb_expression(struct nb_reader *reader, const char *line, const char *at, const char *end,
                   struct nb_binding *value);
/* Sets *value to a number and its unit, which may be NULL. The text of the value is the number and its unit as written
 * or, if it was computed, that of nb_binding_write. NB_NO_NUMBER also if the unit is unknown or the text is too
 * long. */
enum nb_reading nb_literal(struct nb_binding *value, const char *number, const char *unit, bool computed);
/* Writes the text of a value: the number with as many of 15 to 17 digits as it needs to read back to the same bits, and
 * the SI unit of its dimension. */
void nb_binding_write(struct nb_binding *value);
/* True if two values of a sweep are the same number or the same word. */
bool nb_binding_same(const struct nb_binding *a, const struct nb_binding *b);
/* True if a name is a function or pi. */
bool nb_name_reserved(const char *name);
/* The hint for arithmetic with quantities; NULL: no quantity belongs on this line. */
const char *nb_arithmetic_hint(const struct nb_reader *reader);
extern const char nb_function_names[]; /* for the manual: "sqrt, sin, …" */
