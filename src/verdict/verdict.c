/* The verdict: every expectation of a page against what was seen.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "verdict.h"

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

void nb_check_say(struct nb_check *check, bool passed, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(check->words, sizeof check->words, format, arguments);
  va_end(arguments);
  check->passed = passed;
}

/* Off by so much, of at most so much; a value that is no number passes nothing. */
static void compare(struct nb_check *check, const struct nb_tolerance *tolerance, double seen, double known,
                    double whole, const char *unit, const char *from) {
  const double off = fabs(seen - known);
  const char *gap = unit[0] ? " " : "";
  if (tolerance->kind == NB_ABSOLUTE) {
    nb_check_say(check, off <= tolerance->value, "seen %.12g%s%s, %s %.12g, off by %.3g", seen, gap, unit, from, known,
                 off);
    return;
  }
  const double scale = fabs(tolerance->kind == NB_RELATIVE ? known : whole);
  const char *of = tolerance->kind == NB_OF_PEAK ? " of peak" : tolerance->kind == NB_OF_MEASURE ? " of " : "";
  nb_check_say(check, off <= tolerance->value * scale, "seen %.12g%s%s, %s %.12g, off by %.3g %%%s%s", seen, gap, unit,
               from, known, scale > 0 ? 100 * off / scale : 0, of,
               tolerance->kind == NB_OF_MEASURE ? tolerance->of.label : "");
}

/* What a share is of, when that is a peak or another measure; false with words when it cannot be formed. */
static bool find_whole(double *whole, struct nb_check *check, const struct nb_page_run *run,
                       const struct nb_tolerance *tolerance) {
  struct nb_error error;
  const bool seen =
      tolerance->kind != NB_OF_MEASURE || nb_measure_seen(whole, &tolerance->of, &run->result.table, &error);
  if (!seen)
    nb_check_say(check, false, "%s", error.text);
  return seen;
}

/* Of the reference, or 0 for a residual. */
const double *nb_check_known(const struct nb_page_run *run, const struct nb_measure *measure) {
  static const double nothing = 0;
  const double *known = nb_measure_known(measure, &run->scene, &run->known);
  return known || !measure->vanishes ? known : &nothing;
}

static const char *unit_of(const struct nb_page_run *run, const char *unit) {
  return run->scene.unitless || strcmp(unit, "1") == 0 ? "" : unit;
}

static void check_within(struct nb_check *check, const struct nb_page_run *run, const struct nb_expectation *e) {
  struct nb_error error;
  double seen;
  const double *known = nb_check_known(run, &e->measure);
  double whole = known ? fabs(*known) : 0;
  if (!known)
    nb_check_say(check, false, "the reference does not know `%s`", e->measure.label);
  else if (!nb_measure_seen(&seen, &e->measure, &run->result.table, &error))
    nb_check_say(check, false, "%s", error.text);
  else if (find_whole(&whole, check, run, &e->tolerance))
    compare(check, &e->tolerance, seen, *known, whole, unit_of(run, e->measure.unit), "known");
}

static void check_along(struct nb_check *check, const struct nb_page_run *run, const struct nb_expectation *e) {
  const struct nb_table *table = &run->result.table;
  const char *quantity = table->names[e->measure.column];
  const struct nb_known_curve *curve = known_find_curve(&run->known, quantity, e->along);
  size_t from, to;
  nb_measure_rows(&e->measure, table, &from, &to);
  if (!curve || from == to) {
    nb_check_say(check, false, curve ? "no rows were recorded" : "the reference knows no curve of `%s` along `%s`",
                 quantity, e->along);
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
  if (!find_whole(&peak, check, run, &e->tolerance))
    return;
  compare(check, &e->tolerance, row[e->measure.column], curve->at(curve->data, row[e->along_column]), peak,
          unit_of(run, e->measure.unit), "known");
  const size_t length = strlen(check->words);
  snprintf(check->words + length, sizeof check->words - length, ", worst of %zu rows at %s %.6g", to - from, e->along,
           row[e->along_column]);
}

static void check_stated(struct nb_check *check, const struct nb_page_run *run, const struct nb_expectation *e) {
  struct nb_error error;
  double seen, scale = 1, whole = fabs(e->stated);
  if (!nb_measure_seen(&seen, &e->measure, &run->result.table, &error) ||
      (e->has_scale && !nb_measure_seen(&scale, &e->other, &run->result.table, &error)))
    nb_check_say(check, false, "%s", error.text);
  else if (find_whole(&whole, check, run, &e->tolerance))
    compare(check, &e->tolerance, seen / scale, e->stated, whole, e->has_scale ? "" : unit_of(run, e->measure.unit),
            "stated");
}

static void check_order(struct nb_check *check, const struct nb_page_run *run, const struct nb_expectation *e) {
  struct nb_error error;
  double seen, other;
  if (!nb_measure_seen(&seen, &e->measure, &run->result.table, &error) ||
      !nb_measure_seen(&other, &e->other, &run->result.table, &error))
    nb_check_say(check, false, "%s", error.text);
  else
    nb_check_say(check, e->kind == NB_LESS ? seen < other : seen > other, "seen %.12g and %.12g", seen, other);
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
  char group[256];
  nb_sweep_group(group, sizeof group, run, e);
  snprintf(check->label, sizeof check->label, "%s%s%s%s", text, group[0] ? " (" : "", group, group[0] ? ")" : "");
  check->line = e->line;
}

static void judge(struct nb_check *check, const struct nb_outcome *outcome, size_t r, size_t index) {
  const struct nb_page_run *run = &outcome->runs[r];
  const struct nb_expectation *e = &run->expectations.list[index];
  label(check, outcome, run, e);
  if (e->among[0]) {
    nb_check_sample(check, outcome, r, index);
    return;
  }
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
    nb_check_sweep(check, outcome, r, index);
    break;
  case NB_ORDER:
    nb_check_slope(check, outcome, r, index);
    break;
  }
}

enum nb_status nb_verdict(struct nb_outcome *outcome) {
  for (size_t r = 0; r < outcome->run_count; r++) {
    const struct nb_expectations *expectations = &outcome->runs[r].expectations;
    for (size_t k = 0; k < expectations->count; k++) {
      const struct nb_expectation *e = &expectations->list[k];
      if (nb_over_sweep(e) && !nb_sweep_leads(outcome, r, e))
        continue;
      struct nb_check *check = new_check(outcome);
      if (!check)
        return nb_error_memory(&outcome->error);
      judge(check, outcome, r, k);
      outcome->failed += !check->passed && !check->noted;
    }
  }
  return outcome->failed ? NB_FAILED : NB_OK;
}
