/* Words of a command that a shell reads, and characters that a terminal may show.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <stdio.h>
#include <string.h>

#include "core/clean.h"
#include "suites.h"

static const char *quoted(const char *word) {
  static char text[64];
  strcpy(text, "x ");
  nb_append_word(text, sizeof text, word);
  return text + 2;
}

static void plain_words(void) {
  CU_ASSERT_STRING_EQUAL(quoted("refine=0.25"), "refine=0.25");
  CU_ASSERT_STRING_EQUAL(quoted("cases/2-hertz/a_b+C,%@:.md"), "cases/2-hertz/a_b+C,%@:.md");
}

static void quoted_words(void) {
  static const char special[] = " \t\n\"\\$`*?[]{}()<>|&;!#~^";
  char word[] = "a.b", expected[] = "'a.b'";
  for (const char *c = special; *c; c++) {
    word[1] = expected[2] = *c;
    CU_ASSERT_STRING_EQUAL(quoted(word), expected);
  }
  CU_ASSERT_STRING_EQUAL(quoted(""), "''");
  CU_ASSERT_STRING_EQUAL(quoted("E=7 GPa"), "'E=7 GPa'");
  CU_ASSERT_STRING_EQUAL(quoted("µ=1"), "'µ=1'");
}

static void apostrophes(void) {
  CU_ASSERT_STRING_EQUAL(quoted("it's"), "'it'\\''s'");
  CU_ASSERT_STRING_EQUAL(quoted("'"), "''\\'''");
}

/* The first and the last character of each length in UTF-8 that a terminal may show. Control characters, and bytes that
 * are no character (RFC 3629), are replaced: in each `text` the second byte is the first one that is replaced. */
static void characters(void) {
  static const char *const shown[] = {"\t",
                                      "~",
                                      "\xC2\xA0",
                                      "\xDF\xBF",
                                      "\xE0\xA0\x80",
                                      "\xED\x9F\xBF",
                                      "\xEE\x80\x80",
                                      "\xEF\xBF\xBF",
                                      "\xF0\x90\x80\x80",
                                      "\xF4\x8F\xBF\xBF"};
  static const char *const replaced[] = {"\x1F",
                                         "\x7F",
                                         "\x80",
                                         "\xC1\xBF",
                                         "\xC2\x80",
                                         "\xC2\x9F",
                                         "\xC2",
                                         "\xE0\x9F\xBF",
                                         "\xE0\xA0",
                                         "\xED\xA0\x80",
                                         "\xED\xBF\xBF",
                                         "\xF0\x8F\xBF\xBF",
                                         "\xF4\x90\x80\x80",
                                         "\xF8\x88\x80\x80"};
  char text[8];
  unsigned byte = 0;
  for (size_t k = 0; k < sizeof shown / sizeof *shown; k++) {
    snprintf(text, sizeof text, "a%sz", shown[k]);
    CU_ASSERT_EQUAL(nb_clean(text, strlen(text), &byte), 0);
    CU_ASSERT(strncmp(text + 1, shown[k], strlen(shown[k])) == 0);
  }
  for (size_t k = 0; k < sizeof replaced / sizeof *replaced; k++) {
    snprintf(text, sizeof text, "a%sz", replaced[k]);
    CU_ASSERT_EQUAL(nb_clean(text, strlen(text), &byte), 2);
    CU_ASSERT_EQUAL(byte, (unsigned char)replaced[k][0]);
    CU_ASSERT(text[0] == 'a' && text[1] == '?' && text[strlen(text) - 1] == 'z');
  }
}

/* A column counts characters, not bytes: after one character of any length, the next one is in column 2. The byte that
 * is reported is the first one that is replaced. */
static void columns(void) {
  static const char *const first[] = {"a", "\xC2\xB5", "\xE2\x82\xAC", "\xF0\x9F\x8E\xB1"};
  for (size_t k = 0; k < sizeof first / sizeof *first; k++) {
    char text[16];
    unsigned byte = 0;
    snprintf(text, sizeof text, "%s\xFFz\xFE", first[k]);
    CU_ASSERT_EQUAL(nb_clean(text, strlen(text), &byte), 2);
    CU_ASSERT_EQUAL(byte, 0xFF);
    CU_ASSERT(strncmp(text, first[k], strlen(first[k])) == 0 && strcmp(text + strlen(first[k]), "?z?") == 0);
  }
}

void suite_words(void) {
  CU_pSuite suite = CU_add_suite("words", NULL, NULL);
  CU_add_test(suite, "plain words", plain_words);
  CU_add_test(suite, "words with special characters", quoted_words);
  CU_add_test(suite, "apostrophes", apostrophes);
  CU_add_test(suite, "characters of one to four bytes", characters);
  CU_add_test(suite, "columns after characters of one to four bytes", columns);
}
