/* Expectations over a sample: a sweep whose runs are draws of the same, as assemblies that differ in their seed are.
 *
 *   stated X among S              where X lies in the sample: the share of the runs below it, and half of those at it
 *   rises, falls with N among S   d, the difference from one value of N to the next, run by run of S: the interval
 *                                 mean d -+ t s/sqrt(n) of 95 % confidence lies above 0, or below
 *   same over N among S within    that interval, between every two values of N, lies within -+ the tolerance
 *
 * s is the standard deviation of the n differences, t the quantile 0.975 of Student's distribution of n - 1 degrees of freedom.
 * Runs are paired, since two that share a seed share most of what makes a sample scatter.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "student.h"
#include "verdict.h"

/* Of run r; false with words when it cannot be formed. */
static bool value_of(double *value, struct nb_check *check, const struct nb_outcome *outcome, size_t r, size_t index) {
  const struct nb_page_run *run = &outcome->runs[r];
  return nb_check_value(value, check, run, &run->expectations.list[index]);
}

struct sample {
  double count, mean, squares, smallest, largest; /* squares: of the distances from the mean (Welford 1962) */
};

static void add(struct sample *sample, double value) {
  const double off = value - sample->mean;
  sample->count++;
  sample->mean += off / sample->count;
  sample->squares += off * (value - sample->mean);
  sample->smallest = sample->count > 1 && sample->smallest < value ? sample->smallest : value;
  sample->largest = sample->count > 1 && sample->largest > value ? sample->largest : value;
}

static double deviation(const struct sample *sample) { return sqrt(sample->squares / (sample->count - 1)); }

static void check_stated(struct nb_check *check, const struct nb_outcome *outcome, size_t first, size_t index) {
  const struct nb_expectation *e = &outcome->runs[first].expectations.list[index];
  struct sample sample = {.count = 0};
  double below = 0;
  for (size_t r = first; r < outcome->run_count; r++) {
    double seen;
    if (!nb_sweep_same_but(&outcome->runs[first], &outcome->runs[r], "", e->among))
      continue;
    if (!value_of(&seen, check, outcome, r, index))
      return;
    add(&sample, seen);
    below += seen < e->stated ? 1 : seen == e->stated ? 0.5 : 0;
  }
  const bool inside = sample.smallest <= e->stated && e->stated <= sample.largest;
  nb_check_say(check, inside,
               "stated %.6g, %s %.0f of %s: %.4g to %.4g, mean %.4g, deviation %.2g; at the %.0f %% point", e->stated,
               inside ? "within" : "outside of", sample.count, e->among, sample.smallest, sample.largest, sample.mean,
               deviation(&sample), 100 * below / sample.count);
  check->mark = NB_NOTE;
}

/* The run that goes with `run` when the swept name has the value it has in `as`: the same but for that name. */
static size_t partner(const struct nb_outcome *outcome, size_t run, size_t as, const struct nb_expectation *e) {
  size_t r = 0; /* there is one: sweeps are combined with each other */
  while (!nb_sweep_same_but(&outcome->runs[r], &outcome->runs[run], e->along, "") ||
         !nb_sweep_same_but(&outcome->runs[r], &outcome->runs[as], "", e->among))
    r++;
  return r;
}

/* Differences from the runs that have the value of `from` to those that have the value of `to`. */
static bool differences(struct sample *sample, double *level, struct nb_check *check, const struct nb_outcome *outcome,
                        size_t from, size_t to, size_t index) {
  const struct nb_expectation *e = &outcome->runs[from].expectations.list[index];
  struct sample all = {.count = 0};
  *sample = (struct sample){.count = 0};
  for (size_t r = 0; r < outcome->run_count; r++) {
    double before, after;
    if (!nb_sweep_same_but(&outcome->runs[from], &outcome->runs[r], "", e->among))
      continue;
    if (!value_of(&before, check, outcome, r, index) ||
        !value_of(&after, check, outcome, partner(outcome, r, to, e), index))
      return false;
    add(sample, after - before);
    add(&all, (before + after) / 2);
  }
  *level = all.mean;
  return true;
}

/* One difference held against what is expected of it, and said. */
static bool holds(struct nb_check *check, const struct nb_outcome *outcome, size_t from, size_t to, size_t index,
                  bool *formed) {
  const struct nb_expectation *e = &outcome->runs[from].expectations.list[index];
  struct sample d;
  double level;
  *formed = differences(&d, &level, check, outcome, from, to, index);
  if (!*formed)
    return false;
  const double half = student_reach(d.count, 0.95) * deviation(&d) / sqrt(d.count);
  const double low = d.mean - half, high = d.mean + half;
  nb_check_add(check, "%sfrom %s to %s %+.4g (%.4g to %.4g) on %.4g", check->words[0] ? "; " : "",
               nb_sweep_binding(&outcome->runs[from], e->along)->text,
               nb_sweep_binding(&outcome->runs[to], e->along)->text, d.mean, low, high, level);
  if (e->kind == NB_SAME)
    return nb_excess(&e->tolerance, low, 0, level) <= 1 && nb_excess(&e->tolerance, high, 0, level) <= 1;
  return e->kind == NB_RISES ? low > 0 : high < 0;
}

static void check_differences(struct nb_check *check, const struct nb_outcome *outcome, size_t first, size_t index) {
  const struct nb_expectation *e = &outcome->runs[first].expectations.list[index];
  bool all = true;
  for (size_t from = first; from < outcome->run_count; from++) {
    if (!nb_sweep_same_but(&outcome->runs[first], &outcome->runs[from], e->along, ""))
      continue;
    for (size_t to = from + 1; to < outcome->run_count; to++) {
      bool formed;
      if (!nb_sweep_same_but(&outcome->runs[first], &outcome->runs[to], e->along, ""))
        continue;
      all = holds(check, outcome, from, to, index, &formed) && all;
      if (!formed)
        return;
      if (e->kind != NB_SAME)
        break; /* from each value to the next */
    }
  }
  check->mark = all ? NB_PASS : NB_FAIL;
}

void nb_check_sample(struct nb_check *check, const struct nb_outcome *outcome, size_t first, size_t index) {
  if (outcome->runs[first].expectations.list[index].kind == NB_STATED)
    check_stated(check, outcome, first, index);
  else
    check_differences(check, outcome, first, index);
}
