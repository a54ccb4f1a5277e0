/* The reader of expressions. A value is finite, and the text of a number has the same bits when it is read again.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "../../src/core/clean.h"
#include "../../src/input/expression.h"
#include "fuzz.h"

static const char before[] = "let x = ";

/* Reads the expression of the line `let x = …` of the page. False: it is wrong, and *mistakes says why. */
static bool read_line(struct nb_page *page, bool unitless, struct nb_binding *value, struct nb_mistakes *mistakes) {
  static struct nb_binding values[] = {{.name = "a", .text = "2", .value = 2},
                                       {.name = "b_1", .text = "3 mm", .value = 3e-3, .dimension = {60, 0, 0}},
                                       {.name = "word", .text = "word", .value = NAN}};
  static struct nb_reader reader;
  const char *line = page->lines[0];
  reader.page = page, reader.mistakes = mistakes, reader.unitless = unitless;
  reader.bindings = values, reader.binding_count = sizeof values / sizeof *values;
  nb_line_begin(&reader, 1);
  return nb_expression(&reader, line, line + strlen(before), line + strcspn(line, "#"), value);
}

static bool read_expression(const unsigned char *bytes, size_t size) {
  char line[NB_LINE_MAX], path[] = "fuzz.md", *lines[] = {line};
  unsigned char kind = NB_BLOCK_SCENE;
  unsigned byte;
  struct nb_page page = {.path = path, .lines = lines, .line_count = 1, .kind_of = &kind};
  struct nb_mistakes mistakes = {0};
  struct nb_binding value, again;
  const bool unitless = size % 8 == 0;
  if (memchr(bytes, '\n', size) || memchr(bytes, 0, size))
    return false; /* not a part of a line */
  snprintf(line, sizeof line, "%s%.*s", before, (int)size, (const char *)bytes);
  nb_clean(line, strlen(line), &byte);
  const bool valid = read_line(&page, unitless, &value, &mistakes);
  fuzz_hold_mistakes(&mistakes, valid ? NB_OK : NB_BAD_USE);
  if (valid) {
    fuzz_hold(isfinite(value.value), "a value is finite");
    fuzz_hold(memchr(value.text, 0, sizeof value.text) != NULL, "a value has a text");
  }
  if (valid && !value.dimension.m && !value.dimension.kg && !value.dimension.s) {
    snprintf(line, sizeof line, "%s%s", before, value.text);
    fuzz_hold(read_line(&page, unitless, &again, &mistakes), "the text of a number can be read");
    fuzz_hold(again.value == value.value, "the text of a number has the same bits when it is read again");
  }
  nb_mistakes_free(&mistakes);
  return valid;
}

static size_t seed(size_t k, char *text) {
  static const char *const seeds[] = {"2",
                                      "-0.3 mm",
                                      "1e-320",
                                      "a",
                                      "2*b_1 + 1 um",
                                      "-(a - 1)^2/3",
                                      "sqrt(2 N/m * 3 kg) s",
                                      "(1 + 2) kN/m2",
                                      "atan2(b_1, 2 mm) * 180/pi",
                                      "hypot(3, 4) - max(1, min(2, a))",
                                      "sin(pi/4)^2 + cos(30 deg)",
                                      "exp(log(2)) ^ -a",
                                      "2^3^2 # a comment",
                                      "abs(-1 J) / (1 N.m)",
                                      "asin(1)+acos(0)*tan(0)-atan(1)",
                                      "word + 1",
                                      "50 rpm",
                                      "3 %"};
  return k < sizeof seeds / sizeof *seeds ? (size_t)sprintf(text, "%s", seeds[k]) : 0;
}

const struct fuzz_reader fuzz_expressions = {"expressions", 256, 10000, read_expression, seed};
