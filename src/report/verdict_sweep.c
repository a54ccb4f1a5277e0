/* Expectations about several runs of a sweep.
 *
 *   increases, decreases with N      from each value of N to the next larger one; words count in the order of the sweep
 *   constant with N within           largest minus smallest value; a percentage refers to the mean
 *   order P in N within              P is the slope of the least-squares line of log(error) against log(N)
 *
 * `over S` names a sweep S whose runs are realizations of one case, such as assemblies with different seeds:
 *
 *   expected X over S                percentile of X: fraction of the runs below X, plus half of those equal to X
 *   increases, decreases             d is the difference from one value of N to the next, for each run of S: the 95 %
 *     with N over S                  confidence interval mean(d) -+ t s/sqrt(n) lies above 0, or below 0
 *   constant with N over S within    this interval, for any two values of N, lies within -+ the tolerance
 *
 * s is the standard deviation of the n differences, t the 0.975 quantile of Student's distribution with n - 1 degrees
 * of freedom. Runs are paired because two runs with the same seed share most of their scatter.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "core/array.h"
#include "core/clean.h"
#include "input/expression.h"
#include "student.h"
#include "verdict.h"

/* ---- runs and sweeps ---- */

static bool is_trend(enum nb_expectation_kind kind) {
  return kind == NB_INCREASES || kind == NB_DECREASES || kind == NB_CONSTANT || kind == NB_ORDER;
}

bool nb_is_over_sweep(const struct nb_expectation *e) { return is_trend(e->kind) || e->sample[0]; }

static const char *trend_name(const struct nb_expectation *e) { return is_trend(e->kind) ? e->against : ""; }

/* The value of a name in a run. There always is one, because expectations can name only sweeps. */
static const struct nb_binding *binding_of(const struct nb_page_run *run, const char *name) {
  size_t k = 0;
  while (k + 1 < run->scene.binding_count && strcmp(run->scene.bindings[k].name, name) != 0)
    k++;
  return &run->scene.bindings[k];
}

/* True if two runs differ only in the sweeps to which these two names belong. A name may be empty. */
static bool same_except(const struct nb_page_run *a, const struct nb_page_run *b, const char *name, const char *other) {
  const int sweep = name[0] ? binding_of(a, name)->sweep : -1;
  const int second = other[0] ? binding_of(a, other)->sweep : -1;
  for (size_t k = 0; k < a->scene.binding_count; k++) {
    const struct nb_binding *binding = &a->scene.bindings[k];
    /* a `let` is not compared, because its value follows from the sweeps */
    const bool fixed = binding->sweep >= 0 && binding->sweep != sweep && binding->sweep != second;
    if (fixed && strcmp(binding->text, b->scene.bindings[k].text) != 0)
      return false;
  }
  return true;
}

bool nb_sweep_is_first(const struct nb_outcome *outcome, size_t run, const struct nb_expectation *e) {
  for (size_t r = 0; r < run; r++)
    if (same_except(&outcome->runs[r], &outcome->runs[run], trend_name(e), e->sample))
      return false;
  return true;
}

const char *nb_sweep_single_value(const struct nb_outcome *outcome, size_t first, const struct nb_expectation *e) {
  const char *const names[] = {trend_name(e), e->sample};
  const struct nb_page_run *one = &outcome->runs[first];
  for (int k = 0; k < 2; k++) {
    bool varies = !names[k][0];
    for (size_t r = first + 1; r < outcome->run_count && !varies; r++)
      varies = same_except(one, &outcome->runs[r], names[k], "") &&
               !nb_binding_same(binding_of(one, names[k]), binding_of(&outcome->runs[r], names[k]));
    if (!varies)
      return names[k];
  }
  return NULL;
}

void nb_sweep_label(char *text, size_t size, const struct nb_page_run *run, const struct nb_expectation *e) {
  const int trend = e && trend_name(e)[0] ? binding_of(run, e->against)->sweep : -1;
  const int sample = e && e->sample[0] ? binding_of(run, e->sample)->sweep : -1;
  text[0] = 0;
  for (size_t k = 0; k < run->scene.binding_count; k++) {
    const struct nb_binding *binding = &run->scene.bindings[k];
    if (binding->swept && binding->sweep != trend && binding->sweep != sample) /* a sweep has a number, 0 or more */
      nb_append(text, size, "%s%s=%s", text[0] ? ", " : "", binding->name, binding->text);
  }
}

/* ---- an expectation and its group of runs ---- */

struct group {
  struct nb_check *check;
  const struct nb_outcome *outcome;
  size_t first, index; /* index of the first run; index of the expectation in this run */
  const struct nb_expectation *e;
  bool has_words; /* the values of the sweep are words; a column of a sweep has words or numbers */
};

/* True if run r differs from run `as` only in these names. */
static bool matches(const struct group *group, size_t r, size_t as, const char *name, const char *other) {
  return same_except(&group->outcome->runs[as], &group->outcome->runs[r], name, other);
}

/* The swept value of the trend in run r, as the page writes it. */
static const char *swept_text(const struct group *group, size_t r) {
  return binding_of(&group->outcome->runs[r], group->e->against)->text;
}

/* True if run a comes before run b: by value, or in the order of the sweep if the values are words. */
static bool is_before(const struct group *group, size_t a, size_t b) {
  const double x = binding_of(&group->outcome->runs[a], group->e->against)->value;
  const double y = binding_of(&group->outcome->runs[b], group->e->against)->value;
  return group->has_words || x == y ? a < b : x < y;
}

/* The run of the group that follows run r in the order of is_before: the first run for r = run_count, and run_count
 * after the last run. */
static size_t next_run(const struct group *group, size_t r) {
  const size_t runs = group->outcome->run_count;
  size_t next = runs;
  for (size_t k = group->first; k < runs; k++)
    if (matches(group, k, group->first, group->e->against, "") && (r == runs || is_before(group, r, k)) &&
        (next == runs || is_before(group, k, next)))
      next = k;
  return next;
}

/* Finds the value of the measure in run r; false with a message if the value is undefined. */
static bool compute_value(double *value, const struct group *group, size_t r) {
  const struct nb_page_run *run = &group->outcome->runs[r];
  return nb_check_computed(value, group->check, run, &run->expectations.list[group->index]);
}

struct sample {
  double count, mean, squares, smallest, largest; /* squares: sum of squared deviations from the mean (Welford 1962) */
};

static void add(struct sample *sample, double value) {
  const double delta = value - sample->mean;
  sample->count++;
  sample->mean += delta / sample->count;
  sample->squares += delta * (value - sample->mean);
  sample->smallest = sample->count > 1 && sample->smallest < value ? sample->smallest : value;
  sample->largest = sample->count > 1 && sample->largest > value ? sample->largest : value;
}

static double standard_deviation(const struct sample *sample) { return sqrt(sample->squares / (sample->count - 1)); }

/* ---- trends ---- */

/* Adds a point to the picture in the report. If memory runs out, the picture has fewer points. */
static void add_point(const struct group *group, size_t r, double value) {
  struct nb_check *check = group->check;
  const double swept = binding_of(&group->outcome->runs[r], group->e->against)->value;
  double *points = nb_array_reserve(check->points, 2 * check->point_count, 2, sizeof *points);
  if (!points)
    return;
  points[2 * check->point_count] = group->has_words ? (double)check->point_count : swept;
  points[2 * check->point_count++ + 1] = value;
  check->points = points;
}

static void check_trend(const struct group *group) {
  const struct nb_expectation *e = group->e;
  struct sample sample = {.count = 0};
  double before = 0;
  bool ordered = true;
  char unit[NB_NAME_SIZE];
  nb_check_unit(unit, &group->outcome->runs[group->first], e);
  const size_t runs = group->outcome->run_count;
  for (size_t r = next_run(group, runs); r < runs; r = next_run(group, r)) {
    double computed;
    if (!compute_value(&computed, group, r))
      return;
    if (sample.count > 0)
      ordered = ordered && (e->kind == NB_INCREASES ? computed > before : computed < before);
    nb_append(group->check->message, sizeof group->check->message, "%s%.6g%s at %s%s%s",
              sample.count > 0 ? ", " : "computed ", computed, unit, sample.count > 0 ? "" : e->against,
              sample.count > 0 ? "" : " = ", swept_text(group, r));
    add_point(group, r, computed);
    add(&sample, computed);
    before = computed;
  }
  if (e->kind == NB_CONSTANT)
    ordered = nb_error_ratio(&e->tolerance, sample.largest, sample.smallest, sample.mean) <= 1;
  group->check->mark = ordered ? NB_PASS : NB_FAIL;
  if (e->kind == NB_CONSTANT)
    nb_check_error(group->check, "largest difference", sample.largest - sample.smallest, sample.mean, &e->tolerance,
                   unit);
}

/* Appends to the message of a failed `order` what may be the cause. */
static void explain_slope(struct nb_check *check, const struct nb_expectation *e, double slope) {
  if (slope * e->number < 0)
    nb_append(check->message, sizeof check->message,
              "; the error %s as `%s` grows: write `%s order %g in %s within %s`", slope < 0 ? "falls" : "grows",
              e->against, e->measure.label, -e->number, e->against, e->tolerance.text);
  else
    nb_append(check->message, sizeof check->message,
              "; a contact that begins or ends between two steps adds an error without an order: let the particles "
              "touch from the start to the end of the run");
}

static void check_slope(const struct group *group) {
  const struct nb_expectation *e = group->e;
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  char errors[256] = "", unit[NB_NAME_SIZE];
  nb_check_unit(unit, &group->outcome->runs[group->first], e);
  for (size_t r = group->first; r < group->outcome->run_count; r++) {
    const struct nb_page_run *run = &group->outcome->runs[r];
    const struct nb_measure *measure = &run->expectations.list[group->index].measure;
    double computed;
    if (!matches(group, r, group->first, e->against, ""))
      continue;
    const double *solution = nb_check_solution(run, measure), value = binding_of(run, group->e->against)->value;
    if (!solution || !(value > 0)) {
      nb_check_result(group->check, false,
                      solution ? "`%s` is not a number above 0" : "the reference does not return `%s`",
                      solution ? swept_text(group, r) : measure->label);
      return;
    }
    if (!compute_value(&computed, group, r))
      return;
    const double error = fabs(computed - *solution), lx = log(value), ly = log(error);
    if (!isfinite(ly)) {
      nb_check_result(group->check, false, "the error at %s is %g, so it has no logarithm", swept_text(group, r),
                      error);
      return;
    }
    n++, x += lx, y += ly, xx += lx * lx, xy += lx * ly;
    add_point(group, r, error);
    nb_append(errors, sizeof errors, "%s%.3g%s at %s%s%s", n > 1 ? ", " : "", error, unit, n > 1 ? "" : e->against,
              n > 1 ? "" : " = ", swept_text(group, r));
  }
  const double slope = (n * xy - x * y) / (n * xx - x * x);
  nb_check_result(group->check, nb_error_ratio(&e->tolerance, slope, e->number, e->number) <= 1,
                  "computed order %.4g, expected %.4g", slope, e->number);
  nb_check_error(group->check, "error", fabs(slope - e->number), e->number, &e->tolerance, "");
  nb_append(group->check->message, sizeof group->check->message, ": errors %s", errors);
  if (group->check->mark == NB_FAIL)
    explain_slope(group->check, e, slope);
}

/* ---- over a sample ---- */

static void check_position(const struct group *group) {
  const struct nb_expectation *e = group->e;
  struct sample sample = {.count = 0};
  double below = 0;
  char unit[NB_NAME_SIZE];
  nb_check_unit(unit, &group->outcome->runs[group->first], e);
  for (size_t r = group->first; r < group->outcome->run_count; r++) {
    double computed;
    if (!matches(group, r, group->first, "", e->sample))
      continue;
    if (!compute_value(&computed, group, r))
      return;
    add(&sample, computed);
    below += computed < e->number ? 1 : computed == e->number ? 0.5 : 0;
  }
  const bool inside = sample.smallest <= e->number && e->number <= sample.largest;
  nb_check_result(group->check, inside,
                  "expected %.6g%s, %s the range of %.0f runs over %s: %.4g to %.4g, mean %.4g, standard deviation "
                  "%.2g; percentile %.0f",
                  e->number, unit, inside ? "within" : "outside", sample.count, e->sample, sample.smallest,
                  sample.largest, sample.mean, standard_deviation(&sample), 100 * below / sample.count);
  group->check->mark = NB_NOTE;
}

/* The run paired with run r: it differs from r only in the swept name, which has the value of run `as`. */
static size_t paired_run(const struct group *group, size_t r, size_t as) {
  size_t other = 0; /* always found, because all combinations of sweeps are run */
  while (!matches(group, r, other, group->e->against, "") || !matches(group, as, other, "", group->e->sample))
    other++;
  return other;
}

/* True if the paired differences between runs with the value of `from` and runs with the value of `to` meet the
 * expectation. Appends the mean difference and its confidence interval to the message. *is_defined is false if a value is
 * undefined. */
static bool check_difference(const struct group *group, size_t from, size_t to, bool *is_defined) {
  const struct nb_expectation *e = group->e;
  struct sample d = {.count = 0}, level = {.count = 0};
  for (size_t r = 0; r < group->outcome->run_count; r++) {
    double before, after;
    if (!matches(group, r, from, "", e->sample))
      continue;
    *is_defined = compute_value(&before, group, r) && compute_value(&after, group, paired_run(group, r, to));
    if (!*is_defined)
      return false;
    add(&d, after - before);
    add(&level, (before + after) / 2);
  }
  const double half = student_quantile(d.count, 0.95) * standard_deviation(&d) / sqrt(d.count);
  const double low = d.mean - half, high = d.mean + half;
  char unit[NB_NAME_SIZE];
  nb_check_unit(unit, &group->outcome->runs[from], e);
  nb_append(group->check->message, sizeof group->check->message,
            "%sfrom %s to %s: mean difference %+.4g%s, 95 %% confidence %.4g to %.4g, mean %.4g",
            group->check->message[0] ? "; " : "", swept_text(group, from), swept_text(group, to), d.mean, unit, low,
            high, level.mean);
  if (e->kind == NB_CONSTANT)
    return nb_error_ratio(&e->tolerance, low, 0, level.mean) <= 1 &&
           nb_error_ratio(&e->tolerance, high, 0, level.mean) <= 1;
  return e->kind == NB_INCREASES ? low > 0 : high < 0;
}

static void check_differences(const struct group *group) {
  const size_t runs = group->outcome->run_count;
  bool passed = true, is_defined = true;
  for (size_t from = next_run(group, runs); from < runs; from = next_run(group, from)) {
    for (size_t to = next_run(group, from); to < runs; to = next_run(group, to)) {
      passed = check_difference(group, from, to, &is_defined) && passed;
      if (!is_defined)
        return;
      if (group->e->kind != NB_CONSTANT)
        break; /* only differences from each value to the next */
    }
  }
  group->check->mark = passed ? NB_PASS : NB_FAIL;
}

void nb_check_sweep(struct nb_check *check, const struct nb_outcome *outcome, size_t first, size_t index) {
  const struct nb_expectation *e = &outcome->runs[first].expectations.list[index];
  const bool has_words = is_trend(e->kind) && isnan(binding_of(&outcome->runs[first], e->against)->value);
  struct group group = {check, outcome, first, index, e, has_words};
  if (e->sample[0])
    (e->kind == NB_EXPECTED ? check_position : check_differences)(&group);
  else
    (e->kind == NB_ORDER ? check_slope : check_trend)(&group);
}
