/* Counts of the calibration: fractions, quantiles and criteria.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "counts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../src/input/hash.h"

const double quantile_fractions[QUANTILES] = {0.05, 0.5, 0.9};
static const double least_within = 0.95, least_within_kind = 0.9, least_answered = 0.7;
static const double most_cost_median = 2, most_cost = 4, claim_low = 1, claim_high = 3;
const char *const criterion_names[CRITERIA] = {"within the tolerance in 95 %",
                                               "within the tolerance in 90 % of each kind",
                                               "70 % answered of those with a setting within the tolerance",
                                               "cost at most 2 in the median",
                                               "90 % quantile of the cost at most 4",
                                               "estimated over true error 1 to 3 in the median",
                                               "5 % quantile of estimated over true error at least 1"};

bool is_held_out(const char *page) { return nb_hash(NB_HASH_BEGIN, page, strlen(page)) >> 20 & 1; }

static int ascending(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

double quantile(double *values, size_t count, double fraction) {
  size_t known = 0;
  for (size_t k = 0; k < count; k++)
    if (!isnan(values[k]))
      values[known++] = values[k];
  for (size_t k = known; k < count; k++)
    values[k] = NAN;
  qsort(values, known, sizeof *values, ascending);
  return known ? values[(size_t)(fraction * (double)(known - 1) + 0.5)] : NAN;
}

static void add(struct score *score, const struct draw *draw, const struct choice *choice) {
  const bool answered = !isnan(choice->error);
  score->draws++;
  score->answered += answered;
  score->within += choice->error <= 1;
  score->met += draw->met;
  score->met_answered += draw->met && answered;
  score->costs += !isnan(choice->cost);
  score->claims += !isnan(choice->claim);
}

struct score score_of_kind(const struct draw draws[], size_t count, const char *kind) {
  struct score score = {.draws = 0};
  for (size_t k = 0; k < count; k++)
    if (strcmp(draws[k].kind, kind) == 0)
      add(&score, &draws[k], &draws[k].choices[WHOLE]);
  return score;
}

static bool is_in(const struct draw *draw, enum half half) {
  return half == BOTH_HALVES || draw->held_out == (half == HELD_OUT);
}

static double share(size_t part, size_t whole) { return whole ? (double)part / (double)whole : 1; }

/* The fraction of answers within the tolerance among the draws of one kind. */
static double kind_fraction(const struct draw draws[], size_t count, enum estimator estimator, enum half half,
                            const char *kind) {
  size_t answered = 0, within = 0;
  for (size_t k = 0; k < count; k++)
    if (is_in(&draws[k], half) && strcmp(draws[k].kind, kind) == 0) {
      answered += !isnan(draws[k].choices[estimator].error);
      within += draws[k].choices[estimator].error <= 1;
    }
  return share(within, answered);
}

struct score score_of(const struct draw draws[], size_t count, enum estimator estimator, enum half half) {
  struct score score = {.worst_fraction = 1};
  double *costs = calloc(2 * count + 1, sizeof *costs), *claims = costs + count;
  for (size_t k = 0; k < count && costs; k++) {
    const struct choice *choice = &draws[k].choices[estimator];
    costs[k] = claims[k] = NAN;
    if (!is_in(&draws[k], half))
      continue;
    add(&score, &draws[k], choice);
    costs[k] = choice->cost, claims[k] = choice->claim;
    const double here = kind_fraction(draws, count, estimator, half, draws[k].kind);
    if (here < score.worst_fraction)
      score.worst_fraction = here, snprintf(score.worst_kind, sizeof score.worst_kind, "%s", draws[k].kind);
  }
  for (int q = 0; q < QUANTILES && costs; q++) {
    score.cost[q] = quantile(costs, count, quantile_fractions[q]);
    score.claim[q] = quantile(claims, count, quantile_fractions[q]);
  }
  free(costs);
  return score;
}

bool is_enough(size_t within, size_t answered) { return share(within, answered) >= least_within; }

bool criterion_holds(const struct score *score, enum criterion criterion) {
  switch (criterion) {
  case WITHIN:
    return is_enough(score->within, score->answered);
  case WITHIN_KIND:
    return score->worst_fraction >= least_within_kind;
  case ANSWERS:
    return score->met > 0 && share(score->met_answered, score->met) >= least_answered;
  case COST_MEDIAN:
    return score->cost[1] <= most_cost_median;
  case COST_MOST:
    return score->cost[2] <= most_cost;
  case CLAIM_MEDIAN:
    return score->claim[1] >= claim_low && score->claim[1] <= claim_high;
  default:
    return score->claim[0] >= claim_low;
  }
}

size_t write_failures(FILE *out, const struct score *score) {
  size_t count = 0;
  for (int k = 0; k < CRITERIA; k++)
    if (!criterion_holds(score, (enum criterion)k)) {
      fprintf(out, "%s%s", count++ ? "; " : "", criterion_names[k]);
      if (k == WITHIN_KIND)
        fprintf(out, " (%s: %.0f %%)", score->worst_kind, 100 * score->worst_fraction);
    }
  return count;
}
