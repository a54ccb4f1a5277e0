/* The verdict: every expectation of a page against what was seen.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "outcome.h"

static struct nb_check *new_check(struct nb_outcome *outcome) {
  const size_t n = outcome->check_count;
  if ((n & (n - 1)) == 0) { /* room doubles at powers of two */
    struct nb_check *checks = realloc(outcome->checks, (n ? 2 * n : 1) * sizeof *checks);
    if (!checks)
      return NULL;
    outcome->checks = checks;
  }
  outcome->checks[n] = (struct nb_check){.passed = false};
  outcome->check_count++;
  return &outcome->checks[n];
}

static void __attribute__((format(printf, 3, 4))) say(struct nb_check *check, bool passed, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(check->words, sizeof check->words, format, arguments);
  va_end(arguments);
  check->passed = passed;
}

/* Off by so much, of at most so much; a value that is no number passes nothing. */
static void compare(struct nb_check *check, const struct nb_tolerance *tolerance, double seen, double known,
                    double peak, const char *unit, const char *from) {
  const double off = fabs(seen - known);
  const char *gap = unit[0] ? " " : "";
  if (tolerance->kind == NB_ABSOLUTE) {
    say(check, off <= tolerance->value, "seen %.12g%s%s, %s %.12g, off by %.3g", seen, gap, unit, from, known, off);
    return;
  }
  const double scale = tolerance->kind == NB_OF_PEAK ? peak : fabs(known);
  say(check, off <= tolerance->value * scale, "seen %.12g%s%s, %s %.12g, off by %.3g %%%s", seen, gap, unit, from,
      known, scale > 0 ? 100 * off / scale : 0, tolerance->kind == NB_OF_PEAK ? " of peak" : "");
}

static const char *unit_of(const struct nb_page_run *run, const char *unit) {
  return run->scene.unitless || strcmp(unit, "1") == 0 ? "" : unit;
}

static void check_within(struct nb_check *check, const struct nb_page_run *run, const struct nb_expectation *e) {
  struct nb_error error;
  double seen;
  const double *known = nb_measure_known(&e->measure, &run->scene, &run->known);
  if (!known)
    say(check, false, "the reference does not know `%s`", e->measure.label);
  else if (!nb_measure_seen(&seen, &e->measure, &run->result.table, &error))
    say(check, false, "%s", error.text);
  else
    compare(check, &e->tolerance, seen, *known, fabs(*known), unit_of(run, e->measure.unit), "known");
}

static void check_along(struct nb_check *check, const struct nb_page_run *run, const struct nb_expectation *e) {
  const struct nb_table *table = &run->result.table;
  const char *quantity = table->names[e->measure.column];
  const struct nb_known_curve *curve = known_find_curve(&run->known, quantity, e->along);
  size_t from, to;
  nb_measure_rows(&e->measure, table, &from, &to);
  if (!curve || from == to) {
    say(check, false, curve ? "no rows were recorded" : "the reference knows no curve of `%s` along `%s`", quantity,
        e->along);
    return;
  }
  double peak = 0, worst = -1;
  size_t where = from;
  for (size_t r = from; r < to; r++) {
    const double *row = table->values + r * table->column_count;
    const double known = curve->at(curve->data, row[e->along_column]), off = fabs(row[e->measure.column] - known);
    peak = fabs(known) > peak ? fabs(known) : peak;
    const double share = e->tolerance.kind == NB_RELATIVE ? off / fabs(known) : off;
    if (share > worst || share != share)
      worst = share, where = r;
  }
  const double *row = table->values + where * table->column_count;
  compare(check, &e->tolerance, row[e->measure.column], curve->at(curve->data, row[e->along_column]), peak,
          unit_of(run, e->measure.unit), "known");
  const size_t length = strlen(check->words);
  snprintf(check->words + length, sizeof check->words - length, ", worst of %zu rows at %s %.6g", to - from, e->along,
           row[e->along_column]);
}

static void check_stated(struct nb_check *check, const struct nb_page_run *run, const struct nb_expectation *e) {
  struct nb_error error;
  double seen, scale = 1;
  if (!nb_measure_seen(&seen, &e->measure, &run->result.table, &error) ||
      (e->has_scale && !nb_measure_seen(&scale, &e->other, &run->result.table, &error)))
    say(check, false, "%s", error.text);
  else
    compare(check, &e->tolerance, seen / scale, e->stated, fabs(e->stated),
            e->has_scale ? "" : unit_of(run, e->measure.unit), "stated");
}

static void check_order(struct nb_check *check, const struct nb_page_run *run, const struct nb_expectation *e) {
  struct nb_error error;
  double seen, other;
  if (!nb_measure_seen(&seen, &e->measure, &run->result.table, &error) ||
      !nb_measure_seen(&other, &e->other, &run->result.table, &error))
    say(check, false, "%s", error.text);
  else
    say(check, e->kind == NB_LESS ? seen < other : seen > other, "seen %.12g and %.12g", seen, other);
}

/* ---- expectations over a sweep ---- */

static const struct nb_binding *binding_of(const struct nb_page_run *run, const char *name) {
  for (size_t k = 0; k < run->scene.binding_count; k++)
    if (strcmp(run->scene.bindings[k].name, name) == 0)
      return &run->scene.bindings[k];
  return NULL;
}

/* Whether two runs differ in nothing but `name`, and in what goes with it in the same sweep. */
static bool same_but(const struct nb_page_run *a, const struct nb_page_run *b, const char *name) {
  const int sweep = binding_of(a, name)->sweep;
  for (size_t k = 0; k < a->scene.binding_count; k++)
    if (a->scene.bindings[k].sweep != sweep && strcmp(a->scene.bindings[k].text, b->scene.bindings[k].text) != 0)
      return false;
  return true;
}

static void check_sweep(struct nb_check *check, const struct nb_outcome *outcome, size_t first, size_t index) {
  const struct nb_expectation *e = &outcome->runs[first].expectations.list[index];
  double smallest = INFINITY, largest = -INFINITY, before = NAN, sum = 0, count = 0;
  bool ordered = true;
  check->words[0] = 0;
  for (size_t r = first; r < outcome->run_count; r++) {
    struct nb_error error;
    double seen;
    if (!same_but(&outcome->runs[first], &outcome->runs[r], e->along))
      continue;
    if (!nb_measure_seen(&seen, &outcome->runs[r].expectations.list[index].measure, &outcome->runs[r].result.table,
                         &error)) {
      say(check, false, "%s", error.text);
      return;
    }
    if (count > 0)
      ordered = ordered && (e->kind == NB_RISES ? seen > before : seen < before);
    smallest = seen < smallest ? seen : smallest, largest = seen > largest ? seen : largest;
    sum += seen, count++, before = seen;
    const size_t length = strlen(check->words);
    snprintf(check->words + length, sizeof check->words - length, "%s%.6g at %s", count > 1 ? ", " : "seen ", seen,
             binding_of(&outcome->runs[r], e->along)->text);
  }
  const double spread = largest - smallest, scale = e->tolerance.kind == NB_ABSOLUTE ? 1 : fabs(sum / count);
  check->passed = count > 1 && (e->kind == NB_SAME ? spread <= e->tolerance.value * scale : ordered);
}

/* A group of runs that differ in the swept name only is judged once, at its first run; one that --set has left a single value
 * has nothing to be judged by. */
static bool leads(const struct nb_outcome *outcome, size_t run, const char *name) {
  for (size_t r = 0; r < run; r++)
    if (same_but(&outcome->runs[r], &outcome->runs[run], name))
      return false;
  return binding_of(&outcome->runs[run], name)->swept;
}

static void label(struct nb_check *check, const struct nb_outcome *outcome, const struct nb_page_run *run,
                  const struct nb_expectation *e) {
  const char *line = outcome->page.lines[e->line - 1];
  char text[256];
  size_t n = 0;
  for (const char *c = line + strspn(line, " \t"); *c && *c != '#' && *c != '\r' && n + 1 < sizeof text; c++)
    if (!(strchr(" \t", *c) && (n == 0 || text[n - 1] == ' ')))
      text[n++] = *c == '\t' ? ' ' : *c;
  while (n > 0 && text[n - 1] == ' ')
    n--;
  text[n] = 0;
  const bool whole = e->kind == NB_RISES || e->kind == NB_FALLS || e->kind == NB_SAME;
  snprintf(check->label, sizeof check->label, "%s%s%s%s", text, run->label[0] && !whole ? " (" : "",
           whole ? "" : run->label, run->label[0] && !whole ? ")" : "");
  check->line = e->line;
}

static void judge(struct nb_check *check, const struct nb_outcome *outcome, size_t r, size_t index) {
  const struct nb_page_run *run = &outcome->runs[r];
  const struct nb_expectation *e = &run->expectations.list[index];
  label(check, outcome, run, e);
  switch (e->kind) {
  case NB_WITHIN:
    check_within(check, run, e);
    break;
  case NB_ALONG:
    check_along(check, run, e);
    break;
  case NB_STATED:
    check_stated(check, run, e);
    break;
  case NB_LESS:
  case NB_MORE:
    check_order(check, run, e);
    break;
  case NB_RISES:
  case NB_FALLS:
  case NB_SAME:
    check_sweep(check, outcome, r, index);
    break;
  }
}

enum nb_status nb_verdict(struct nb_outcome *outcome) {
  for (size_t r = 0; r < outcome->run_count; r++) {
    const struct nb_expectations *expectations = &outcome->runs[r].expectations;
    for (size_t k = 0; k < expectations->count; k++) {
      const struct nb_expectation *e = &expectations->list[k];
      if ((e->kind == NB_RISES || e->kind == NB_FALLS || e->kind == NB_SAME) && !leads(outcome, r, e->along))
        continue;
      struct nb_check *check = new_check(outcome);
      if (!check)
        return nb_error_set(&outcome->error, NB_BROKEN, "out of memory for the verdict");
      judge(check, outcome, r, k);
      outcome->failed += !check->passed;
    }
  }
  return outcome->failed ? NB_FAILED : NB_OK;
}
