/* Tables that a test gives to the runs of a page as their results.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "planted.h"

#include <CUnit/CUnit.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "written.h"

void planted_page(struct nb_outcome *outcome, const char *statements, const char *expectations) {
  char path[] = "/tmp/nineball-planted-XXXXXX";
  FILE *file = written_file(path);
  fprintf(file,
          "```scene\nunits none\n%s\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nmonitor A disc 1\nstep 0.1\n"
          "record time cycle A.x A.y A.vx energy.balance\nstage one\ncycles 1\nstage two\ncycles 1\n```\n"
          "```expect\nreference free_fall\n%s\n```\n",
          statements, expectations);
  fclose(file);
  nb_outcome_read(outcome, path, NULL);
  unlink(path);
  if (outcome->mistakes.text)
    printf("# %s", outcome->mistakes.text);
  CU_ASSERT_EQUAL_FATAL(outcome->status, NB_OK);
}

static size_t column(const struct nb_table *table, const char *name) {
  size_t c = 0;
  while (strcmp(table->names[c], name) != 0)
    c++;
  return c;
}

void planted_rows(struct nb_outcome *outcome, size_t run, int count, const double *x) {
  static const double y[PLANTED_MOST] = {1, 2, 4, 2, 1};
  const struct nb_scene *scene = &outcome->runs[run].scene;
  struct nb_table *table = &outcome->runs[run].result.table;
  CU_ASSERT_FATAL(nb_table_create(table, scene->column_count));
  for (size_t c = 0; c < scene->column_count; c++)
    strcpy(table->names[c], scene->columns[c].name);
  for (int r = 0; r < count; r++) {
    double *row = nb_table_row(table, r < 3 ? 0 : 1, 10 * r, r);
    CU_ASSERT_PTR_NOT_NULL_FATAL(row);
    row[column(table, "time")] = r;
    row[column(table, "cycle")] = 10 * r;
    row[column(table, "A.x")] = row[column(table, "energy.balance")] = x[r];
    row[column(table, "A.y")] = y[r];
    row[column(table, "A.vx")] = -4;
  }
}

void planted_runs(struct nb_outcome *outcome, const double *x) {
  for (size_t r = 0; r < outcome->run_count; r++)
    planted_rows(outcome, r, 1, &x[r]);
}

void planted_solution(struct nb_outcome *outcome, const char *name, double value) {
  for (size_t r = 0; r < outcome->run_count; r++)
    solution_value(&outcome->runs[r].solution, value, name);
}

static double at(const void *data, double x) { return ((const double *)data)[(int)x]; }

void planted_curve(struct nb_outcome *outcome, int count, const double *values) {
  double *data = malloc((size_t)count * sizeof *data);
  CU_ASSERT_PTR_NOT_NULL_FATAL(data);
  memcpy(data, values, (size_t)count * sizeof *data);
  solution_curve(&outcome->runs[0].solution, "A.x", "time", at, data);
}

void planted_is(struct nb_outcome *outcome, enum nb_mark mark) {
  const enum nb_status status = nb_verdict(outcome);
  CU_ASSERT_FATAL(outcome->check_count > 0);
  const struct nb_check *check = &outcome->checks[0];
  if (check->mark != mark)
    printf("# %s, wanted %s: %s: %s\n", nb_mark_word(check->mark), nb_mark_word(mark), check->label, check->message);
  CU_ASSERT_EQUAL(check->mark, mark);
  CU_ASSERT_EQUAL(status, outcome->mark_count[NB_FAIL] ? NB_FAILED : NB_OK);
  CU_ASSERT(check->message[0] != 0);
}

void planted_says(const struct nb_outcome *outcome, const char *text) {
  const bool given = strstr(outcome->checks[0].message, text) != NULL;
  if (!given)
    printf("# no `%s` in: %s\n", text, outcome->checks[0].message);
  CU_ASSERT(given);
}

void planted_parts(const struct nb_outcome *outcome, const char *const parts[NB_PARTS]) {
  const struct nb_check *check = &outcome->checks[0];
  for (int k = 0; k < NB_PARTS; k++) {
    char part[sizeof check->message];
    snprintf(part, sizeof part, "%.*s", check->parts[k].length, check->message + check->parts[k].at);
    if (strcmp(part, parts[k]) != 0)
      printf("# part %d is `%s`, wanted `%s`, in: %s\n", k, part, parts[k], check->message);
    CU_ASSERT_STRING_EQUAL(part, parts[k]);
    CU_ASSERT(check->parts[k].at + check->parts[k].length <= strlen(check->message));
  }
}

void planted_sweeps(const struct planted_sweep *list, size_t count) {
  for (size_t k = 0; k < count; k++) {
    struct nb_outcome outcome;
    planted_page(&outcome, list[k].statements, list[k].expectation);
    planted_runs(&outcome, list[k].x);
    planted_solution(&outcome, "A.x", 0);
    planted_is(&outcome, list[k].mark);
    planted_says(&outcome, list[k].words);
    CU_ASSERT_EQUAL(outcome.check_count, 1);
    nb_outcome_free(&outcome);
  }
}

void planted_one(const char *expectation, const char *name, double value, int count, const double *x, enum nb_mark mark,
                 const char *words) {
  struct nb_outcome outcome;
  planted_page(&outcome, "", expectation);
  planted_rows(&outcome, 0, count, x);
  if (name)
    planted_solution(&outcome, name, value);
  planted_is(&outcome, mark);
  planted_says(&outcome, words);
  nb_outcome_free(&outcome);
}
