/* Expectations that are not checked are reported with their line and the reason.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

#include "planted.h"
#include "suites.h"
#include "written.h"

/* An expectation without anything to compare is reported once, as neither passed nor failed. */
static void skipped(void) {
  static const struct planted_sweep list[] = {
      {"sweep v 1", "A.x increases with v", {1}, NB_SKIP, "`v` has one value only"},
      {"sweep v with w  1 5  1 6  1 7", "A.x constant with v within 0", {1, 1, 1}, NB_SKIP, "`v` has one value only"},
      {"sweep v with w  1 5  1.0 6", "A.x decreases with v", {2, 1}, NB_SKIP, "`v` has one value only"},
      {"sweep v with w  one 5  one 6", "A.x decreases with v", {2, 1}, NB_SKIP, "`v` has one value only"},
      {"sweep v with w  1 5  1 6  2 7", "A.x constant with v within 1", {1, 1, 2}, NB_PASS, ""},
      {"sweep v with w  1 % 5  10000 ppm 6", "A.x order 1 in v within 9", {1, 2}, NB_SKIP, "`v` has one value only"},
      {"sweep v 1", "A.x expected 1 over v [t]", {1}, NB_SKIP, "`v` has one value only"},
      {"sweep T 1 2\nsweep s 1", "A.x increases with T over s", {1, 2}, NB_SKIP, "`s` has one value only"},
      {"sweep T 1\nsweep s 1 2", "A.x increases with T over s", {1, 2}, NB_SKIP, "`T` has one value only"},
      {"sweep T 1\nsweep s 1", "A.x increases with T over s", {1}, NB_SKIP, "`T` has one value only"},
      {"sweep w 1 2 3\nsweep v 1", "A.x increases with v", {1, 2, 3}, NB_SKIP, "`v` has one value only"},
  };
  planted_sweeps(list, COUNT(list));
  struct nb_outcome outcome;
  planted_page(&outcome, "sweep v 1", "A.x increases with v\nA.x decreases with v\nA.x expected 1 within 0 [t]");
  planted_runs(&outcome, (double[]){1});
  planted_is(&outcome, NB_PASS);
  CU_ASSERT(outcome.check_count == 3 && outcome.mark_count[NB_SKIP] == 2 && outcome.mark_count[NB_PASS] == 1);
  CU_ASSERT_STRING_EQUAL(outcome.checks[2].label, "A.x decreases with v");
  nb_outcome_free(&outcome);
}

/* The values of a sweep may depend on those of another sweep. Then an expectation is checked for some values of the
 * other sweep, and skipped for values that leave nothing to compare. */
static void skipped_in_part(void) {
  struct nb_outcome outcome;
  planted_page(&outcome, "sweep s 2 1\nsweep v with w  1 5  $s 6", "A.x increases with v");
  CU_ASSERT_EQUAL_FATAL(outcome.run_count, 4);
  planted_runs(&outcome, (double[]){1, 2, 3, 3});
  planted_is(&outcome, NB_PASS);
  CU_ASSERT(outcome.check_count == 2 && outcome.checks[1].mark == NB_SKIP);
  CU_ASSERT_EQUAL(outcome.checks[1].line, outcome.checks[0].line);
  nb_outcome_free(&outcome);
  planted_page(&outcome, "sweep s 1 2\nsweep v with w  1 5  $s 6", "A.x increases with v"); /* first skipped */
  planted_runs(&outcome, (double[]){3, 3, 1, 2});
  planted_is(&outcome, NB_SKIP);
  CU_ASSERT(outcome.check_count == 2 && outcome.checks[1].mark == NB_PASS);
  nb_outcome_free(&outcome);
}

/* Blocks in quotations, lists or indented text are prose for Markdown: their expectations are reported as skipped. */
static void hidden(void) {
  static const struct {
    const char *text;
    int skipped; /* line of the reported statement, counted from the first line of `text`; 0: none */
  } rows[] = {
      {"> ```expect\n> A.x expected 9 within 0 [t]\n> ```", 2},
      {">```expect\n>A.x expected 9 within 0 [t]\n>```", 2},
      {"> ```expect\n> # nothing\n> reference free_fall\n>\n> A.x expected 9 within 0 [t]", 5},
      {"    ```expect\n    A.x expected 9 within 0 [t]\n    ```", 2},
      {"\t~~~expect\n\tA.x expected 9 within 0 [t]", 2},
      {"- ```expect\n  A.x expected 9 within 0 [t]\n  ```", 2},
      {"> ```expect\n> ```\nA.x expected 9 within 0 [t]", 0},
      {"> ```expect\nA.x expected 9 within 0 [t]", 0},
      {"> ```expects\n> A.x expected 9 within 0 [t]", 0},
      {"> ```c\n> A.x expected 9 within 0 [t]", 0},
      {"> ``expect\n> A.x expected 9 within 0 [t]", 0},
      {"````\n> ```expect\n> A.x expected 9 within 0 [t]\n````", 0},
      {"> ````expect\n> A.x expected 9 within 0 [t]\n> ````", 2},
      {"> ```expect\n\n> A.x expected 9 within 0 [t]", 3},
      {"> ```expect\n> reference free_fall\n> report A.x", 3},
      {"> ```expect\n> reference free_fall\n> references expected 9", 3},
  };
  for (size_t k = 0; k < COUNT(rows); k++) {
    struct nb_outcome outcome;
    char text[256];
    snprintf(text, sizeof text, "A.x expected 1 within 0 [t]\n```\n\n%s\n\n```gnuplot", rows[k].text);
    planted_page(&outcome, "", text);
    planted_rows(&outcome, 0, 1, (double[]){1});
    planted_is(&outcome, NB_PASS);
    const int first = outcome.checks[0].line + 3; /* line of the planted text */
    CU_ASSERT_EQUAL(outcome.mark_count[NB_SKIP], rows[k].skipped ? 1 : 0);
    if (rows[k].skipped) {
      CU_ASSERT_EQUAL(outcome.checks[1].line, first + rows[k].skipped - 1);
      CU_ASSERT_STRING_EQUAL(outcome.checks[1].message,
                             "the block is in a quote, in a list or indented by four spaces, so it is not read");
      const char *const label = outcome.checks[1].label, *const at = strstr(rows[k].text, label);
      CU_ASSERT(strlen(label) >= strlen("report A.x") && at != NULL);
      CU_ASSERT(strchr("Ar", label[0]) != NULL);        /* without the sign of the quotation and the indent */
      CU_ASSERT(at && strchr("\n", at[strlen(label)])); /* the whole line */
    }
    nb_outcome_free(&outcome);
  }
}

/* Creates a temporary file with this text. */
static void write_file(char path[], const char *text) {
  FILE *file = written_file(path);
  fputs(text, file);
  fclose(file);
}

/* If a setting replaces the segments of a contact test, each expectation of the page is reported as skipped, and no
 * other line is. The contact then follows the points, and each is recorded. Without this setting the expectations are
 * checked. */
static void replaced_segments(void) {
  static const char text[] =
      "# A title\n```contact-test\nmaterial g young 70 GPa poisson 0.25 friction 0.3\nnormal hertz\nshear mindlin\n"
      "contact sphere 1 mm g with sphere 1 mm g\nsegment press overlap to 2 um in 10 steps\n```\n\nWords.\n\n"
      "```expect\n# the first one\n\noverlap expected 2 um within 1e-12 m [t]\nslip expected 0 m within 0 m [t]\n```\n"
      "> ```expect\n> slip expected 1 m within 0 m [t]\n> ```\n"
      "```gnuplot\nplot 1\n```\n";
  for (int followed = 0; followed < 2; followed++) {
    char page[] = "/tmp/nineball-verdict-XXXXXX", points[] = "/tmp/nineball-verdict-XXXXXX", follow[64];
    struct nb_outcome outcome;
    write_file(page, text), write_file(points, "overlap/um\tslip/um\n1\t0\n3\t1\n");
    snprintf(follow, sizeof follow, "follow=%s", points);
    nb_outcome_make(&outcome, page, (const char *const[]){followed ? follow : NULL, NULL}, NULL, NULL);
    CU_ASSERT_EQUAL(outcome.status, NB_OK);
    CU_ASSERT_EQUAL_FATAL(outcome.check_count, 3);
    CU_ASSERT_EQUAL(outcome.mark_count[NB_SKIP], followed ? 3 : 1);
    CU_ASSERT_EQUAL(outcome.mark_count[NB_PASS], followed ? 0 : 2);
    CU_ASSERT(outcome.checks[2].line == 19 && strstr(outcome.checks[2].message, "the block is in a quote"));
    for (int k = 0; k < 2; k++) {
      CU_ASSERT_EQUAL(outcome.checks[k].line, 15 + k);
      CU_ASSERT(!followed || strcmp(outcome.checks[k].message, "`follow` replaces the segments of the page") == 0);
    }
    const struct nb_table *const table = &outcome.runs[0].result.table;
    static const double overlaps[] = {0, 1e-6, 3e-6}, slips[] = {0, 0, 1e-6};
    CU_ASSERT_EQUAL_FATAL(table->row_count, followed ? 3 : 11);
    for (size_t row = 0; row < 3 && followed; row++) {
      CU_ASSERT_DOUBLE_EQUAL(written_cell(table, row, "overlap"), overlaps[row], 1e-18);
      CU_ASSERT_DOUBLE_EQUAL(written_cell(table, row, "slip"), slips[row], 1e-18);
    }
    nb_outcome_free(&outcome);
    unlink(page), unlink(points);
  }
}

void suite_verdict_skip(void) {
  CU_pSuite suite = CU_add_suite("verdict_skip", NULL, NULL);
  CU_add_test(suite, "expectations with nothing to compare are reported", skipped);
  CU_add_test(suite, "expectations with something to compare in a part of the runs", skipped_in_part);
  CU_add_test(suite, "expect blocks that are prose are reported", hidden);
  CU_add_test(suite, "expectations of replaced segments are reported", replaced_segments);
}
