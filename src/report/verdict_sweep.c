/* Expectations over a sweep: what rises, falls, stays, or has an order. Those over samples: verdict_sample.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "input/reader.h"
#include "verdict.h"

/* There is one: expectations name only what is swept. */
const struct nb_binding *nb_sweep_binding(const struct nb_page_run *run, const char *name) {
  size_t k = 0;
  while (k + 1 < run->scene.binding_count && strcmp(run->scene.bindings[k].name, name) != 0)
    k++;
  return &run->scene.bindings[k];
}

bool nb_sweep_same_but(const struct nb_page_run *a, const struct nb_page_run *b, const char *name, const char *other) {
  const int sweep = name[0] ? nb_sweep_binding(a, name)->sweep : -1;
  const int second = other[0] ? nb_sweep_binding(a, other)->sweep : -1;
  for (size_t k = 0; k < a->scene.binding_count; k++) {
    const struct nb_binding *binding = &a->scene.bindings[k];
    const bool fixed = binding->sweep >= 0 && binding->sweep != sweep && binding->sweep != second; /* a `let` follows */
    if (fixed && strcmp(binding->text, b->scene.bindings[k].text) != 0)
      return false;
  }
  return true;
}

void nb_check_sweep(struct nb_check *check, const struct nb_outcome *outcome, size_t first, size_t index) {
  const struct nb_expectation *e = &outcome->runs[first].expectations.list[index];
  double smallest = INFINITY, largest = -INFINITY, before = 0, sum = 0, count = 0;
  bool ordered = true;
  char values[sizeof check->words] = "";
  for (size_t r = first; r < outcome->run_count; r++) {
    double seen;
    if (!nb_sweep_same_but(&outcome->runs[first], &outcome->runs[r], e->along, ""))
      continue;
    if (!nb_check_value(&seen, check, &outcome->runs[r], &outcome->runs[r].expectations.list[index]))
      return;
    if (count > 0)
      ordered = ordered && (e->kind == NB_RISES ? seen > before : seen < before);
    smallest = fmin(smallest, seen), largest = fmax(largest, seen);
    sum += seen, count++, before = seen;
    const size_t length = strlen(values);
    snprintf(values + length, sizeof values - length, "%s%.6g at %s", length ? ", " : "seen ", seen,
             nb_sweep_binding(&outcome->runs[r], e->along)->text);
  }
  const bool same = nb_excess(&e->tolerance, largest, smallest, sum / count) <= 1;
  nb_check_say(check, e->kind == NB_SAME ? same : ordered, "%s", values);
}

/* Slope of the straight line nearest to log(error) over log(value) of all runs in a sweep. */
void nb_check_slope(struct nb_check *check, const struct nb_outcome *outcome, size_t first, size_t index) {
  const struct nb_expectation *e = &outcome->runs[first].expectations.list[index];
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  char errors[256] = "";
  for (size_t r = first; r < outcome->run_count; r++) {
    const struct nb_page_run *run = &outcome->runs[r];
    const struct nb_measure *measure = &run->expectations.list[index].measure;
    double seen;
    if (!nb_sweep_same_but(&outcome->runs[first], run, e->along, ""))
      continue;
    const double *known = nb_check_known(run, measure);
    const struct nb_binding *binding = nb_sweep_binding(run, e->along);
    const double value = nb_value_number(binding->text);
    if (!known || !(value > 0)) {
      nb_check_say(check, false, known ? "`%s` is not a number above 0" : "the reference does not know `%s`",
                   known ? binding->text : measure->label);
      return;
    }
    if (!nb_check_value(&seen, check, run, &run->expectations.list[index]))
      return;
    const double off = fabs(seen - *known), lx = log(value), ly = log(off);
    if (!isfinite(ly)) {
      nb_check_say(check, false, "the error at %s is %g, which has no logarithm", binding->text, off);
      return;
    }
    n++, x += lx, y += ly, xx += lx * lx, xy += lx * ly;
    const size_t length = strlen(errors);
    snprintf(errors + length, sizeof errors - length, "%s%.3g at %s", n > 1 ? ", " : "", off, binding->text);
  }
  const double slope = (n * xy - x * y) / (n * xx - x * x);
  nb_check_say(check, nb_excess(&e->tolerance, slope, e->stated, e->stated) <= 1, "seen order %.4g: errors %s", slope,
               errors);
}

static bool along_sweep(enum nb_expectation_kind kind) {
  return kind == NB_RISES || kind == NB_FALLS || kind == NB_SAME || kind == NB_ORDER;
}

bool nb_over_sweep(const struct nb_expectation *e) { return along_sweep(e->kind) || e->among[0]; }

bool nb_sweep_leads(const struct nb_outcome *outcome, size_t run, const struct nb_expectation *e) {
  const char *along = along_sweep(e->kind) ? e->along : "";
  for (size_t r = 0; r < run; r++)
    if (nb_sweep_same_but(&outcome->runs[r], &outcome->runs[run], along, e->among))
      return false;
  return true;
}

static bool same_value(const struct nb_binding *a, const struct nb_binding *b) {
  return nb_value_number(a->text) == nb_value_number(b->text) || strcmp(a->text, b->text) == 0;
}

const char *nb_sweep_constant(const struct nb_outcome *outcome, size_t first, const struct nb_expectation *e) {
  const char *const names[] = {along_sweep(e->kind) ? e->along : "", e->among};
  const struct nb_page_run *one = &outcome->runs[first];
  for (int k = 0; k < 2; k++) {
    bool varies = !names[k][0];
    for (size_t r = first + 1; r < outcome->run_count && !varies; r++)
      varies = nb_sweep_same_but(one, &outcome->runs[r], names[k], "") &&
               !same_value(nb_sweep_binding(one, names[k]), nb_sweep_binding(&outcome->runs[r], names[k]));
    if (!varies)
      return names[k];
  }
  return NULL;
}

void nb_sweep_group(char *text, size_t size, const struct nb_page_run *run, const struct nb_expectation *e) {
  const int along = along_sweep(e->kind) ? nb_sweep_binding(run, e->along)->sweep : -1;
  const int among = e->among[0] ? nb_sweep_binding(run, e->among)->sweep : -1;
  text[0] = 0;
  for (size_t k = 0; k < run->scene.binding_count; k++) {
    const struct nb_binding *binding = &run->scene.bindings[k];
    const size_t length = strlen(text);
    if (binding->swept && binding->sweep != along && binding->sweep != among)
      snprintf(text + length, size - length, "%s%s=%s", length ? ", " : "", binding->name, binding->text);
  }
}
