/* Random changes of a page: another word, a line twice, a number that is much too large, another byte.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdio.h>
#include <string.h>

#include "../../src/input/reader.h"
#include "../../src/report/expect.h"
#include "fuzz.h"

/* The generator xorshift64*: Vigna, An experimental exploration of Marsaglia's xorshift generators, ACM TOMS 42 (2016)
 * 30. */
unsigned long long fuzz_chance(unsigned long long *chance) {
  *chance ^= *chance >> 12;
  *chance ^= *chance << 25;
  *chance ^= *chance >> 27;
  return (*chance * 2685821657736338717ULL) >> 11;
}

static size_t below(unsigned long long *chance, size_t count) {
  return count ? (size_t)(fuzz_chance(chance) % count) : 0;
}

/* Replaces the bytes from `at` to `end` by the text; no change if the result is too long. */
static size_t replace(unsigned char *bytes, size_t size, size_t most, size_t at, size_t end, const char *text,
                      size_t length) {
  if (size - (end - at) + length > most)
    return size;
  char copy[NB_LINE_MAX + 2];
  if (length > sizeof copy)
    length = sizeof copy;
  memcpy(copy, text, length); /* the text may be a part of the page */
  memmove(bytes + at + length, bytes + end, size - end);
  memcpy(bytes + at, copy, length);
  return size - (end - at) + length;
}

/* Words of the page language, and others. */
static const char *const units[] = {"m",     "mm",  "\u00B5m", "s", "us",  "kg/m3", "kN/m", "N.m", "1/s",
                                    "rad/s", "rad", "deg",     "J", "kPa", "%",     "ppm",  "m/",  "kg.m/s"};
static const char *const odd[] = {"0",
                                  "-1",
                                  "1e308",
                                  "1e-320",
                                  "9999999999",
                                  "0x10",
                                  "nan",
                                  "$a",
                                  "$",
                                  "#",
                                  "1",
                                  "2",
                                  "3",
                                  "`",
                                  "```",
                                  "```scene",
                                  "~~~",
                                  "```expect",
                                  "\n",
                                  "rock",
                                  "%",
                                  "of",
                                  "at",
                                  "most",
                                  "1e400",
                                  "\xC3",
                                  "\t",
                                  "none",
                                  "critical",
                                  "with",
                                  "to",
                                  "by",
                                  "{",
                                  "[x]",
                                  "and",
                                  "every",
                                  "cycles",
                                  "in",
                                  "peak",
                                  "reading",
                                  "all",
                                  "load",
                                  "C.normal",
                                  "C",
                                  "contact-beta",
                                  "global",
                                  "con1",
                                  "mirror",
                                  "turn",
                                  "-$a",
                                  "$a$b",
                                  "=",
                                  "(2*a)",
                                  "(",
                                  ")",
                                  "-(a)",
                                  "(sqrt(a) m)",
                                  "v=(1/3)",
                                  "let a = (1 + 2) mm ^ a / pi"};

static const char *word(unsigned long long *chance) {
  const size_t kind = below(chance, 5);
  if (kind == 0) {
    size_t count = 0;
    while (nb_keyword_row(nb_keywords(), count))
      count++;
    const struct nb_keyword *row = nb_keyword_row(nb_keywords(), below(chance, count));
    size_t fields = 0;
    while (row->arguments[fields].count)
      fields++;
    const char *clause = fields ? row->arguments[below(chance, fields)].word : NULL;
    return clause && below(chance, 2) ? clause : row->word;
  }
  if (kind == 1) {
    return units[below(chance, sizeof units / sizeof *units)];
  }
  if (kind == 2) {
    const struct nb_expectation_row *rows = nb_expectation_rows();
    size_t count = 0;
    while (rows[count].word)
      count++;
    return rows[below(chance, count)].word;
  }
  return odd[below(chance, sizeof odd / sizeof *odd)];
}

static bool blank(unsigned char c) { return c == ' ' || c == '\n' || c == '\t'; }

/* Finds the word, or the line with its end, that contains the byte `at`. */
static void around(const unsigned char *bytes, size_t size, size_t at, bool line, size_t *from, size_t *to) {
  for (*from = at; *from > 0 && (line ? bytes[*from - 1] != '\n' : !blank(bytes[*from - 1]));)
    --*from;
  for (*to = at; *to < size && (line ? bytes[*to] != '\n' : !blank(bytes[*to]));)
    ++*to;
  *to += line && *to < size;
}

size_t fuzz_change(unsigned char *bytes, size_t size, size_t most, unsigned long long *chance) {
  size_t at = below(chance, size), from, to, other_from, other_to;
  const size_t kind = below(chance, 9), other = below(chance, size);
  const bool line = kind == 3 || kind == 4 || kind == 5;
  around(bytes, size, at, line, &from, &to);
  around(bytes, size, other, line, &other_from, &other_to);
  const char *text = word(chance), *copy = (const char *)bytes + other_from;
  switch (kind) {
  case 0: /* another word */
  case 1:
    return replace(bytes, size, most, from, to, text, strlen(text));
  case 2: /* insert a word */
    size = replace(bytes, size, most, from, from, " ", 1);
    return replace(bytes, size, most, from, from, text, strlen(text));
  case 3: /* insert a line of this page, or replace another line by it */
    return replace(bytes, size, most, from, from, copy, other_to - other_from);
  case 4:
    return replace(bytes, size, most, from, to, copy, other_to - other_from);
  case 5: /* remove a line or a word */
  case 6:
    return replace(bytes, size, most, from, to, "", 0);
  case 7: /* replace a word by a word of this page */
    return replace(bytes, size, most, from, to, copy, other_to - other_from);
  default:
    if (size)
      bytes[at] = (unsigned char)fuzz_chance(chance);
    return size;
  }
}

/* Chooses a byte in some line. All lines have the same probability, so a short record is changed as often as a long
 * one. */
static size_t in_some_line(const unsigned char *bytes, size_t size, unsigned long long *chance) {
  size_t lines = 0, from = 0, to = 0;
  for (size_t k = 0; k < size; k++)
    lines += bytes[k] == '\n';
  for (size_t line = below(chance, lines);; line--) {
    for (from = to; to < size && bytes[to] != '\n';)
      to++;
    if (line == 0 || to == size)
      return from + below(chance, to - from);
    to++;
  }
}

size_t fuzz_change_number(unsigned char *bytes, size_t size, size_t most, unsigned long long *chance) {
  static const char *const numbers[] = {
      "0",      "-1",     "1",    "2",     "3",   "7",   "12",  "40", "1e300",       "-1e300",
      "1e-300", "1e-320", "1e-9", "-1e-9", "1e9", "0.5", "inf", "-",  "99999999999", "18446744073709551615"};
  const char *text = numbers[below(chance, sizeof numbers / sizeof *numbers)];
  for (int k = 0; k < 20; k++) {
    size_t from, to;
    around(bytes, size, in_some_line(bytes, size, chance), false, &from, &to);
    if (from < to && strchr("0123456789+-", bytes[from]))
      return replace(bytes, size, most, from, to, text, strlen(text));
  }
  return size;
}

/* ---- a dictionary ---- */

static void print_word(const char *word) {
  if (!word || !*word)
    return;
  putchar('"');
  for (const char *c = word; *c; c++)
    if (*c >= ' ' && *c <= '~' && *c != '"' && *c != '\\')
      putchar(*c);
    else
      printf("\\x%02X", (unsigned char)*c);
  puts("\"");
}

void fuzz_print_words(void) {
  const struct nb_expectation_row *rows = nb_expectation_rows();
  const struct nb_keyword *row;
  for (size_t k = 0; (row = nb_keyword_row(nb_keywords(), k)); k++) {
    print_word(row->word);
    for (size_t f = 0; row->arguments[f].count; f++)
      print_word(row->arguments[f].word);
  }
  for (size_t k = 0; rows[k].word; k++)
    print_word(rows[k].word);
  for (size_t k = 0; k < sizeof units / sizeof *units; k++)
    print_word(units[k]);
  for (size_t k = 0; k < sizeof odd / sizeof *odd; k++)
    print_word(odd[k]);
}
