/* The verdict: compares every expectation of a page with the computed values.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/clean.h"
#include "core/names.h"
#include "input/reader.h"
#include "verdict.h"

static struct nb_check *add_check(struct nb_outcome *outcome) {
  struct nb_check *checks = nb_array_reserve(outcome->checks, outcome->check_count, 1, sizeof *checks);
  if (!checks)
    return NULL;
  outcome->checks = checks;
  outcome->checks[outcome->check_count] = (struct nb_check){.mark = NB_FAIL};
  return &outcome->checks[outcome->check_count++];
}

const char *nb_mark_word(enum nb_mark mark) {
  static const char *const words[NB_MARKS] = {
      [NB_FAIL] = "FAIL", [NB_PASS] = "pass", [NB_NOTE] = "note", [NB_SKIP] = "skip"};
  return words[mark];
}

void nb_check_result(struct nb_check *check, bool passed, const char *format, ...) {
  va_list arguments;
  check->message[0] = 0;
  memset(check->parts, 0, sizeof check->parts);
  check->mark = passed ? NB_PASS : NB_FAIL;
  va_start(arguments, format);
  nb_append_arguments(check->message, sizeof check->message, format, arguments);
  va_end(arguments);
}

static void append_part(struct nb_check *check, enum nb_part_kind kind, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
static void append_part(struct nb_check *check, enum nb_part_kind kind, const char *format, ...) {
  va_list arguments;
  const size_t at = strlen(check->message);
  va_start(arguments, format);
  nb_append_arguments(check->message, sizeof check->message, format, arguments);
  va_end(arguments);
  check->parts[kind] = (struct nb_part){(unsigned short)at, (unsigned short)(strlen(check->message) - at)};
}

double nb_error_ratio(const struct nb_tolerance *tolerance, double computed, double reference, double scale) {
  const double error = fabs(computed - reference);
  const double allowed = tolerance->value * (tolerance->kind == NB_ABSOLUTE ? 1 : fabs(scale));
  if (!isfinite(error) || !isfinite(allowed))
    return INFINITY;
  return error > 0 ? error / allowed : 0;
}

int nb_digit_count(double a, double b, int least) {
  const double error = fabs(a - b) / fmax(fabs(a), fabs(b));
  const int needed = error > 0 ? 2 - (int)floor(log10(error)) : 0;
  return needed < least ? least : needed > 17 ? 17 : needed;
}

void nb_check_error(struct nb_check *check, const char *what, double error, double scale,
                    const struct nb_tolerance *tolerance, const char *unit) {
  const bool relative = tolerance->kind != NB_ABSOLUTE;
  /* in per cent, unless the tolerance is above 1e7, or below 1e-7 and not 0 */
  const bool percent = relative && !(tolerance->value > 0 && (tolerance->value < 1e-7 || tolerance->value > 1e7));
  const double of = relative ? fabs(scale) : 1, factor = percent ? 100 : 1;
  const char *in = percent ? " %" : relative ? "" : unit;
  const double shown = error > 0 ? factor * error / of : 0, allowed = factor * tolerance->value;
  const int digits = check->mark == NB_FAIL ? nb_digit_count(shown, allowed, 3) : 3;
  char fraction[sizeof tolerance->of.label + 8] = "";
  if (tolerance->kind == NB_OF_PEAK || tolerance->kind == NB_OF_MEASURE)
    snprintf(fraction, sizeof fraction, " of %s", tolerance->kind == NB_OF_PEAK ? "peak" : tolerance->of.label);
  nb_append(check->message, sizeof check->message, ", %s ", what);
  append_part(check, NB_PART_ERROR, "%.*g%s", digits, shown, in);
  nb_append(check->message, sizeof check->message, ", tolerance ");
  append_part(check, NB_PART_TOLERANCE, "%.*g%s%s", digits, allowed, in, fraction);
}

/* Compares two numbers. The message has both numbers, the error and the tolerance, or the reason why there is no error.
 * `unit` begins with a space; `from` is the word before the reference value. */
static void compare(struct nb_check *check, const struct nb_tolerance *tolerance, double computed, double reference,
                    double scale, const char *unit, const char *from) {
  const bool relative = tolerance->kind != NB_ABSOLUTE;
  const double error = fabs(computed - reference);
  const int precision = nb_digit_count(computed, reference, 6);
  nb_check_result(check, nb_error_ratio(tolerance, computed, reference, scale) <= 1, "computed ");
  append_part(check, NB_PART_COMPUTED, "%.*g%s", precision, computed, unit);
  nb_append(check->message, sizeof check->message, ", %s ", from);
  append_part(check, NB_PART_REFERENCE, "%.*g%s", precision, reference, unit);
  if (!isfinite(computed) || !isfinite(reference)) {
    nb_append(check->message, sizeof check->message, ": not a finite number");
  } else if (relative && !isfinite(tolerance->value * scale)) {
    nb_append(check->message, sizeof check->message, ": a fraction of %g is not a finite tolerance", scale);
  } else if (relative && scale == 0 && error > 0) {
    nb_append(check->message, sizeof check->message, ", error %.3g%s; a tolerance in %% of 0 allows no error", error,
              unit);
  } else {
    nb_check_error(check, "error", error, scale, tolerance, unit);
  }
}

/* Finds the value of which the tolerance is a fraction: the value of the measure that the tolerance names, or `own`.
 * False with a message if the value is undefined. */
static bool find_scale(double *scale, double own, struct nb_check *check, const struct nb_page_run *run,
                       const struct nb_tolerance *tolerance) {
  struct nb_error error;
  *scale = own;
  if (tolerance->kind != NB_OF_MEASURE || nb_measure_value(scale, &tolerance->of, nb_run_table(run), &error))
    return true;
  nb_check_result(check, false, "%s", error.text);
  return false;
}

/* Finds the value of the expectation's measure; `given` replaces it unless it is NULL. */
static bool find_value(double *value, const double *given, const struct nb_page_run *run,
                       const struct nb_expectation *e, struct nb_error *error) {
  if (given)
    *value = *given;
  return given || nb_measure_value(value, &e->measure, nb_run_table(run), error);
}

/* nb_check_computed, where `given` replaces the value of the measure unless it is NULL. */
static bool find_computed(double *value, struct nb_check *check, const struct nb_page_run *run,
                          const struct nb_expectation *e, const double *given) {
  struct nb_error error;
  double scale = 1;
  if (!find_value(value, given, run, e, &error) ||
      (e->has_scale && !nb_measure_value(&scale, &e->other, nb_run_table(run), &error))) {
    nb_check_result(check, false, "%s", error.text);
    return false;
  }
  const double numerator = *value;
  *value /= scale;
  if (!isfinite(*value))
    nb_check_result(check, false, "computed %.6g and %.6g: their ratio is not a finite number", numerator, scale);
  return isfinite(*value);
}

bool nb_check_computed(double *value, struct nb_check *check, const struct nb_page_run *run,
                       const struct nb_expectation *e) {
  return find_computed(value, check, run, e, NULL);
}

const double *nb_check_solution(const struct nb_page_run *run, const struct nb_measure *measure) {
  static const double zero = 0;
  const double *solution = nb_measure_solution(measure, &run->solution);
  return solution || !measure->is_residual ? solution : &zero;
}

/* Writes the unit after a number, with a space before it; empty for a dimensionless number. */
static const char *unit_suffix(char *text, const struct nb_page_run *run, const char *unit) {
  const bool unitless = run->scene.unitless || strcmp(unit, "1") == 0;
  snprintf(text, NB_NAME_SIZE, "%s%s", unitless ? "" : " ", unitless ? "" : unit);
  return text;
}

const char *nb_check_unit(char *text, const struct nb_page_run *run, const struct nb_expectation *e) {
  return unit_suffix(text, run, e->has_scale ? "1" : e->measure.unit);
}

/* Appends a note if the largest value of a residual passes and its smallest value would not, or the other way round.
 * Such a check says nothing about the error. */
static void note_other_sign(struct nb_check *check, const struct nb_page_run *run, const struct nb_expectation *e,
                            double allowed) {
  struct nb_measure other = e->measure;
  struct nb_error error;
  double value;
  other.reducer = other.reducer == NB_MAX ? NB_MIN : NB_MAX;
  for (size_t k = 0; k < run->expectations.count; k++) {
    const struct nb_measure *const its = &run->expectations.list[k].measure;
    if (its->column == other.column && its->reducer == other.reducer && its->stage == other.stage)
      return; /* the page checks the other extreme value, too */
  }
  if (check->mark != NB_PASS || !e->measure.is_residual || e->has_scale ||
      (e->measure.reducer != NB_MAX && e->measure.reducer != NB_MIN) ||
      !nb_measure_value(&value, &other, nb_run_table(run), &error) || !(fabs(value) > allowed))
    return;
  char unit[NB_NAME_SIZE];
  nb_append(check->message, sizeof check->message, "; but a residual has both signs: `%s` is %.3g%s, check it too",
            other.reducer == NB_MIN ? "min" : "max", value, nb_check_unit(unit, run, e));
}

/* True if something other than the rule for `kn` may cause a factor of 2: the overshoot of a weight that is laid on a
 * contact, or a `pair` that gives `kn`. */
static bool has_other_cause(const struct nb_scene *scene) {
  bool found = scene->gravity.line > 0;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *const stage = &scene->stages[s];
    found = found || stage->gravity.line > 0;
    for (size_t k = 0; k < stage->change_count; k++)
      found = found || (stage->changes[k].b >= 0 && !isnan(stage->changes[k].kn));
  }
  for (size_t r = 0; r < scene->pair_rule_count; r++)
    found = found || !isnan(scene->pair_rules[r].kn);
  return found;
}

/* Appends a note to a failed check of a contact with linear springs if the normal force is twice the expected one, or the
 * overlap half of it, to 1 %: the author may have expected the stiffness of two springs in series. A largest or smallest
 * value has no note, because a load that is applied suddenly has twice the force of the same load at rest. */
static void note_series(struct nb_check *check, const struct nb_page_run *run, const struct nb_expectation *e,
                        double computed) {
  static const double near = 0.01;
  const struct nb_quantity *const quantity = &run->scene.columns[e->measure.column].quantity;
  const double ratio = computed / e->number;
  const bool force = strcmp(quantity->kind->name, "normal") == 0,
             overlap = strcmp(quantity->kind->name, "overlap") == 0;
  const double series = force ? 2 : 0.5;
  if (check->mark == NB_FAIL && (force || overlap) && !nb_is_extreme(e->measure.reducer) &&
      strcmp(run->scene.normal, "linear") == 0 && fabs(ratio - series) <= near * series &&
      !has_other_cause(&run->scene))
    nb_append(
        check->message, sizeof check->message,
        "; the ratio is %g: if the expected value is that of two springs in series, note that a contact has the whole "
        "`kn` of its material, or 2ab/(a+b) of two materials, not half of it",
        series);
}

/* Compares a value with the reference, or with the number that the page gives. */
static void check_value(struct nb_check *check, const struct nb_page_run *run, const struct nb_expectation *e,
                        const double *given) {
  const bool expected = e->kind == NB_EXPECTED;
  const double *reference = expected ? &e->number : nb_check_solution(run, &e->measure);
  double computed = NAN, scale;
  char unit[NB_NAME_SIZE];
  if (!reference)
    nb_check_result(check, false, "the reference does not return `%s`", e->measure.label);
  else if (find_computed(&computed, check, run, e, given) && find_scale(&scale, *reference, check, run, &e->tolerance))
    compare(check, &e->tolerance, computed, *reference, scale, nb_check_unit(unit, run, e),
            expected ? "expected" : "reference");
  if (expected && !e->has_scale)
    note_series(check, run, e, computed);
  if (reference && *reference == 0 && check->mark == NB_PASS)
    note_other_sign(check, run, e, e->tolerance.value * (e->tolerance.kind == NB_ABSOLUTE ? 1 : fabs(scale)));
}

/* Reports that the reference does not return a curve, and names the curves that it returns. */
static void lacks_curve(struct nb_check *check, const struct nb_solution *solution, const char *quantity,
                        const char *against) {
  nb_check_result(check, false, "the reference returns no curve of `%s` versus `%s`", quantity, against);
  for (size_t k = 0; k < solution->curve_count; k++)
    nb_append(check->message, sizeof check->message, "%s`%s versus %s`", k ? ", " : ", but ", solution->curves[k].name,
              solution->curves[k].along);
}

/* Compares a curve at every row. All rows must pass; the message is about the worst one. */
static void check_curve(struct nb_check *check, const struct nb_page_run *run, const struct nb_expectation *e) {
  const struct nb_table *table = nb_run_table(run);
  const char *quantity = table->names ? table->names[e->measure.column] : "";
  const struct nb_solution_curve *curve = solution_find_curve(&run->solution, quantity, e->against);
  char unit[NB_NAME_SIZE];
  size_t from, to;
  nb_measure_rows(&e->measure, table, &from, &to);
  if (!curve) {
    lacks_curve(check, &run->solution, quantity, e->against);
    return;
  }
  if (from == to) {
    nb_check_result(check, false, "no rows were recorded");
    return;
  }
  double peak = 0, scale, worst = -1;
  for (size_t r = from; r < to; r++)
    peak = fmax(peak, fabs(curve->at(curve->data, table->values[r * table->column_count + e->column])));
  if (!find_scale(&scale, peak, check, run, &e->tolerance))
    return;
  for (size_t r = from; r < to; r++) {
    const double *row = table->values + r * table->column_count, x = row[e->column];
    const double computed = row[e->measure.column], reference = curve->at(curve->data, x);
    const double base = e->tolerance.kind == NB_RELATIVE ? reference : scale;
    const double excess = nb_error_ratio(&e->tolerance, computed, reference, base);
    if (!(excess > worst))
      continue;
    worst = excess;
    compare(check, &e->tolerance, computed, reference, base, nb_check_unit(unit, run, e), "reference");
    nb_append(check->message, sizeof check->message, "; the worst of %zu rows, at %s = %.6g%s", to - from, e->against,
              x, unit_suffix(unit, run, table->units[e->column]));
  }
}

/* Compares a measure with another one of the same run or with a number, or reports it. */
static void check_measures(struct nb_check *check, const struct nb_page_run *run, const struct nb_expectation *e,
                           const double *given) {
  struct nb_error error;
  double one, other = e->number;
  char unit[NB_NAME_SIZE];
  const bool reported = e->kind == NB_REPORTED;
  if (!find_value(&one, given, run, e, &error) ||
      (!reported && !e->has_number && !nb_measure_value(&other, &e->other, nb_run_table(run), &error))) {
    nb_check_result(check, false, "%s", error.text);
    return;
  }
  nb_check_result(check, e->kind == NB_LESS ? one < other : one > other, "computed %.*g%s",
                  nb_digit_count(one, other, 6), one, nb_check_unit(unit, run, e));
  if (!reported) {
    nb_append(check->message, sizeof check->message, " and %.*g%s", nb_digit_count(one, other, 6), other, unit);
    note_other_sign(check, run, e, fabs(other));
  } else
    check->mark = NB_NOTE;
}

void nb_check_run(struct nb_check *check, const struct nb_page_run *run, const struct nb_expectation *e,
                  const double *given) {
  if (e->kind == NB_VERSUS)
    check_curve(check, run, e);
  else if (e->kind == NB_LESS || e->kind == NB_GREATER || e->kind == NB_REPORTED)
    check_measures(check, run, e, given);
  else
    check_value(check, run, e, given);
}

/* Sets the label: the statement of the page without its comment. */
static void set_label(struct nb_check *check, const struct nb_outcome *outcome, int line) {
  const char *c = outcome->page.lines[line - 1];
  size_t n = 0;
  for (c += strspn(c, " \t>"); *c && *c != '#' && n < 255; c++)
    if (!(strchr(" \t", *c) && check->label[n - 1] == ' '))
      check->label[n++] = *c == '\t' ? ' ' : *c;
  while (check->label[n - 1] == ' ')
    n--;
  check->label[n] = 0;
  check->line = line;
}

static void evaluate(struct nb_check *check, const struct nb_outcome *outcome, size_t r, size_t index) {
  const struct nb_page_run *run = &outcome->runs[r];
  const struct nb_expectation *e = &run->expectations.list[index];
  char group[256];
  nb_sweep_label(group, sizeof group, run, e);
  if (group[0])
    nb_append(check->label, sizeof check->label, " (%s)", group);
  if (nb_is_over_sweep(e))
    nb_check_sweep(check, outcome, r, index);
  else
    nb_check_run(check, run, e, NULL);
}

static bool is_skipped(const struct nb_outcome *outcome, int line) {
  for (size_t k = 0; k < outcome->check_count; k++)
    if (outcome->checks[k].line == line && outcome->checks[k].mark == NB_SKIP)
      return true;
  return false;
}

/* Adds a skipped check with its reason, once for each line of the page. False when out of memory. */
static bool skip(struct nb_outcome *outcome, int line, const char *format, const char *name) {
  if (is_skipped(outcome, line))
    return true;
  struct nb_check *check = add_check(outcome);
  if (!check)
    return false;
  set_label(check, outcome, line);
  snprintf(check->message, sizeof check->message, format, name);
  check->mark = NB_SKIP;
  return true;
}

/* Adds a skipped check for each statement of an expect block that was not read, except `reference`. False when out of
 * memory. */
static bool skip_unread(struct nb_outcome *outcome) {
  const struct nb_page *page = &outcome->page;
  const bool followed = outcome->runs[0].scene.path_replaced;
  bool stored = true;
  for (size_t i = 0; i < page->line_count && stored; i++) {
    const char *statement = page->lines[i] + strspn(page->lines[i], " \t>");
    const bool hidden = page->kind_of[i] == 1 + NB_BLOCK_HIDDEN;
    if (!(hidden || (followed && page->kind_of[i] == 1 + NB_BLOCK_EXPECT)) || !*statement || *statement == '#' ||
        strncmp(statement, "reference ", strlen("reference ")) == 0)
      continue;
    stored = skip(outcome, (int)i + 1,
                  hidden ? "the block is in a quote, in a list or indented by four spaces, so it is not read"
                         : "`follow` replaces the segments of the page",
                  NULL);
  }
  return stored;
}

/* Evaluates the expectations of run r about this run alone, or, with `over`, those about a group of runs of which it is
 * the first one. */
static bool evaluate_run(struct nb_outcome *outcome, size_t r, bool over) {
  const struct nb_expectations *expectations = &outcome->runs[r].expectations;
  bool stored = true;
  for (size_t k = 0; k < expectations->count && stored; k++) {
    const struct nb_expectation *e = &expectations->list[k];
    if (nb_is_over_sweep(e) != over || (over && !nb_sweep_is_first(outcome, r, e)))
      continue;
    const char *single = nb_sweep_single_value(outcome, r, e);
    if (single) {
      stored = skip(outcome, e->line, "`%s` has one value only, so there is nothing to compare", single);
      continue;
    }
    struct nb_check *check = add_check(outcome);
    stored = check != NULL;
    if (check) {
      set_label(check, outcome, e->line);
      evaluate(check, outcome, r, k);
      if (!over)
        nb_check_rows(&outcome->warnings, &outcome->runs[r], e, check);
    }
  }
  return stored;
}

enum nb_status nb_verdict(struct nb_outcome *outcome) {
  bool stored = true;
  for (int over = 0; over < 2; over++) /* first expectations about single runs, then about groups of runs */
    for (size_t r = 0; r < outcome->run_count && stored; r++)
      stored = evaluate_run(outcome, r, over);
  if (!stored || !skip_unread(outcome))
    return nb_error_memory(&outcome->error);
  if (nb_spool_status(&outcome->spool, &outcome->error))
    return outcome->error.status;
  for (size_t k = 0; k < outcome->check_count; k++)
    outcome->mark_count[outcome->checks[k].mark]++;
  return outcome->mark_count[NB_FAIL] ? NB_FAILED : NB_OK;
}
