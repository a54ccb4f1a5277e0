/* Tables of expected values of references, and of their refusals, for pages without units.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "refs_scenes.h"

static const double pi = 3.14159265358979323846;

/* A value of a solution, or the value at x of a curve versus `along`. */
struct expected {
  const char *name;
  double value;
  const char *along;
  double x;
};

/* Solves the scene of a page without units, or of a contact test that begins with the line `path`. The scene is kept until
 * the next one is solved, because curves refer to it. */
enum nb_status refs_solve(struct nb_solution *solution, const char *reference, const char *text,
                          struct nb_error *error);
/* Frees the last scene, at the end of a suite. */
int refs_released(void);

/* The solution has the expected values, and no other ones. `scale`: a value of 0 may differ by 1e-12 of it. */
void refs_check(const char *reference, const char *page, double scale, const struct expected *expected, size_t count);
#define VALUES(reference, page, scale, ...)                                                                            \
  do {                                                                                                                 \
    const struct expected expected[] = {__VA_ARGS__};                                                                  \
    refs_check(reference, page, scale, expected, sizeof expected / sizeof *expected);                                  \
  } while (0)

/* The reference accepts the scene if `text` is NULL, or refuses it with this text. */
void refs_check_error(const char *reference, const char *page, const char *text);
/* The same; a message stands behind "the reference `NAME` is for". */
void refs_check_message(const char *reference, const char *page, const char *message);

/* The page with each text in place of `@`. */
struct part {
  const char *text, *message;
};
void refs_check_parts(const char *reference, const char *page, const struct part *parts, size_t count);
#define PARTS(reference, page, ...)                                                                                    \
  do {                                                                                                                 \
    static const struct part parts[] = {__VA_ARGS__};                                                                  \
    refs_check_parts(reference, page, parts, sizeof parts / sizeof *parts);                                            \
  } while (0)
