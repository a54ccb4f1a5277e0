/* Words of a command that a shell reads.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
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

void suite_words(void) {
  CU_pSuite suite = CU_add_suite("words of a command", NULL, NULL);
  CU_add_test(suite, "plain words", plain_words);
  CU_add_test(suite, "words with special characters", quoted_words);
  CU_add_test(suite, "apostrophes", apostrophes);
}
