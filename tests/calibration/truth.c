/* The limit of a page for a small step, true errors, and the exhaustive grid of settings.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../src/core/clock.h"
#include "runs.h"

static const double truth_fraction = 0.05; /* largest change of the truth when its step is halved, over the tolerance */

void allow_time(struct nb_advice *advice, struct nb_advise_query *query, double seconds) {
  query->budget = nb_clock() - advice->began + seconds;
  advice->query = query;
  advice->exhausted = false;
}

/* ---- the truth ---- */

bool take_truth(struct truth *truth, struct nb_advice *advice, int level) {
  struct nb_variant *page = &advice->variants[0];
  if (!run_one(advice, page, level - 1, 0) || !run_one(advice, page, level, 0))
    return false;
  truth->level = level, truth->change = 0;
  for (size_t r = 0; r < advice->runs; r++) {
    truth->values[r] = value_of(page, level, r, 0);
    const double change = fabs(truth->values[r] - value_of(page, level - 1, r, 0));
    if (change > 0)
      truth->change = fmax(truth->change, change / (truth->tolerance * fabs(truth->values[r])));
  }
  return true;
}

bool find_truth(struct truth *truth, struct nb_advice *advice) {
  for (int level = TRUTH_FIRST; level <= NB_LEVEL_HIGH && take_truth(truth, advice, level); level++)
    if (truth->change <= truth_fraction)
      return true;
  return false;
}

double true_error(struct nb_advice *advice, const struct truth *truth, struct nb_variant *variant, int level,
                  double most) {
  double largest = 0;
  for (size_t phase = 0; phase < NB_PHASES && (phase == 0 || largest <= most); phase += NB_PHASES / advice->trials) {
    if (!run_one(advice, variant, level, phase))
      return INFINITY;
    for (size_t r = 0; r < advice->runs; r++) {
      const double error = fabs(value_of(variant, level, r, phase) - truth->values[r]);
      if (error > 0)
        largest = fmax(largest, error / (truth->tolerance * fabs(truth->values[r])));
    }
  }
  return largest;
}

/* ---- the exhaustive grid ---- */

/* The number nearest to 2^(half/2) by which the step of the page can be divided so that all its stages have whole
 * numbers of cycles. */
static double refine_of(const struct nb_advice *advice, int half) {
  const double wanted = exp2(half / 2.0), divisor = (double)advice->divisor;
  return advice->divisor ? nearbyint(divisor * wanted) / divisor : wanted;
}

/* The fewest updates of a setting of the grid whose true error is within the tolerance; `most` if no setting has fewer.
 * The variants in `between` store the values at steps between two levels. Levels of a variant are tried from the
 * coarsest one on. */
static double search_grid(struct nb_advice *advice, const struct truth *truth, struct nb_variant *between,
                          double most) {
  double *refine = &advice->page.runs[0].scene.refine;
  const double own = *refine;
  for (size_t k = 0; k < advice->variant_count; k++)
    for (int half = 2 * NB_LEVEL_LOW; half < 2 * FINEST && !advice->variants[k].equal; half++) {
      const bool is_between = half % 2 != 0;
      const int level = (half - is_between) / 2;
      struct nb_variant *variant = is_between ? &between[k] : &advice->variants[k];
      if (is_between)
        *refine = own * refine_of(advice, half) / nb_level_refine(advice, level);
      bool done = run_one(advice, variant, level, 0);
      if (done && point_of(variant, level)->updates >= most)
        half = 2 * FINEST;
      else if (done && true_error(advice, truth, variant, level, 1) <= 1)
        most = fmin(most, point_of(variant, level)->updates), half = 2 * FINEST;
      *refine = own;
    }
  return most;
}

double cheapest(struct nb_advice *advice, const struct truth *truth, double most) {
  struct nb_variant *between = calloc(advice->variant_count, sizeof *between);
  for (size_t k = 0; k < advice->variant_count && between; k++) {
    between[k] = advice->variants[k];
    memset(between[k].points, 0, sizeof between[k].points);
  }
  if (between)
    most = search_grid(advice, truth, between, most);
  for (size_t k = 0; k < advice->variant_count && between; k++)
    for (size_t l = 0; l < NB_LEVELS; l++)
      free(between[k].points[l].values);
  free(between);
  return most;
}
