/* The negative controls of the calibration (counts.h): estimators from which a part is missing. They choose a setting
 * by a search like that of `nineball advise`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "runs.h"

/* Runs the trials that the estimate needs, at `phases` phases. False: one of them cannot be run. */
static bool run_control(struct nb_advice *advice, enum estimator control, struct nb_variant *variant, int level,
                        size_t phases) {
  const int finer = level + 2 > advice->anchor ? level + 2 : advice->anchor;
  for (int k = 0; k < (control == TWO_STEPS ? 2 : 3); k++)
    if (!run_trials(advice, variant, level + k, phases))
      return false;
  return control != ONE_PHASE ||
         (run_trials(advice, &advice->variants[0], finer - 1, 1) && run_trials(advice, &advice->variants[0], finer, 1));
}

/* The error that the control estimates for a setting, in run r. */
static double control_claim(const struct nb_advice *advice, enum estimator control, const struct nb_variant *variant,
                            int level, size_t r, size_t phases) {
  const struct nb_point *point = point_of(variant, level);
  const double *n = point[0].values + r * NB_TRIALS, *n2 = point[1].values + r * NB_TRIALS;
  const struct nb_ratios ratios = nb_level_ratios(advice, level);
  double largest = 0, step;
  if (control == TWO_STEPS)
    return fabs(n[0] - n2[0]);
  const double *n4 = point[2].values + r * NB_TRIALS;
  if (control == ONE_PHASE) {
    const struct nb_point *fine =
        point_of(&advice->variants[0], level + 2 > advice->anchor ? level + 2 : advice->anchor);
    return nb_estimate_error(&step, n, n2, n4, 1, ratios,
                             nb_estimate_anchor(fine[0].values + r * NB_TRIALS, fine[-1].values + r * NB_TRIALS, 1));
  }
  for (size_t phase = 0; phase < phases; phase++) {
    const size_t trial = phase * (advice->trials / phases);
    largest = fmax(largest, nb_estimate_step(n[trial], n2[trial], n4[trial], ratios));
  }
  return largest;
}

/* The largest estimated error (claim) over the tolerance, of all runs. Infinite: there is no estimate. */
static double control_ratio(struct nb_advice *advice, enum estimator control, struct nb_variant *variant, int level,
                            size_t phases) {
  double largest = 0;
  if (!run_control(advice, control, variant, level, phases))
    return INFINITY;
  for (size_t r = 0; r < advice->runs; r++) {
    const double claim = control_claim(advice, control, variant, level, r, phases);
    if (claim > 0)
      largest = fmax(largest, claim / advice->allowed[r]);
  }
  return largest;
}

/* Finds the coarsest level whose estimated error is within the tolerance. The control NO_ANCHOR tests a level at one
 * phase first, and then at all phases. False: there is no such level, or it costs `most` updates or more. */
static bool search_levels(struct chosen *chosen, struct nb_advice *advice, enum estimator control,
                          struct nb_variant *variant, double most) {
  const int highest = advice->anchor > FINEST ? advice->anchor : FINEST;
  for (int level = NB_LEVEL_LOW; level <= highest; level++) {
    if (!run_one(advice, variant, level, 0))
      continue;
    if (point_of(variant, level)->updates >= most)
      return false;
    double ratio = control_ratio(advice, control, variant, level, 1);
    if (ratio <= 1 && control == NO_ANCHOR)
      ratio = control_ratio(advice, control, variant, level, advice->trials);
    if (ratio <= 1) {
      *chosen = (struct chosen){variant, level, ratio};
      return true;
    }
  }
  return false;
}

/* The setting with the fewest updates of those that search_levels finds. */
static struct chosen search(struct nb_advice *advice, enum estimator control) {
  struct chosen chosen = {.variant = NULL};
  double most = INFINITY;
  for (size_t k = 0; k < advice->variant_count; k++) {
    struct nb_variant *variant = &advice->variants[k];
    if (!variant->equal && !(control == ONE_PHASE && variant->distance > 0) &&
        search_levels(&chosen, advice, control, variant, most))
      most = point_of(variant, chosen.level)->updates;
  }
  return chosen;
}

/* The largest difference, over the tolerance, of the page with these laws and this level from its own reference
 * solution. Infinite: there is no reference solution. */
static double reference_ratio(const struct nb_advice *advice, const struct nb_variant *variant, int level) {
  const char *settings[SETTINGS_MAX + 4];
  char texts[3][3 * NB_NAME_SIZE];
  size_t count = 0;
  while (advice->query->settings[count])
    settings[count] = advice->query->settings[count], count++;
  snprintf(texts[0], sizeof texts[0], "refine=%.17g",
           advice->page.runs[0].scene.refine * nb_level_refine(advice, level));
  snprintf(texts[1], sizeof texts[1], "normal=%s", variant->normal);
  snprintf(texts[2], sizeof texts[2], "shear=%s", variant->shear);
  for (int k = 0; k < (variant->normal[0] ? 3 : 1); k++)
    settings[count++] = texts[k];
  settings[count] = NULL;
  struct nb_outcome outcome;
  double largest = nb_outcome_make(&outcome, advice->query->path, settings, &advice->query->options, NULL) <= NB_FAILED
                       ? 0
                       : INFINITY;
  for (size_t r = 0; r < outcome.run_count && largest <= 1; r++) {
    struct nb_expectation wanted;
    struct nb_error error;
    double value;
    const struct nb_page_run *run = &outcome.runs[r];
    const bool known = !nb_expectation_read(&wanted, "quantity", advice->text, &run->scene, &outcome.mistakes) &&
                       nb_measure_value(&value, &wanted.measure, &run->result.table, &error);
    const double *solution = known ? nb_measure_solution(&wanted.measure, &run->solution) : NULL;
    largest =
        solution ? fmax(largest, fabs(value - *solution) / (advice->tolerance.value * fabs(*solution))) : INFINITY;
  }
  nb_outcome_free(&outcome);
  return largest;
}

/* The coarsest setting that agrees with its own reference solution. At each level the setting without shear forces is
 * tried first. */
static struct chosen search_references(struct nb_advice *advice) {
  size_t none = 0;
  for (size_t k = 1; k < advice->variant_count; k++)
    if (strcmp(advice->variants[k].shear, "none") == 0 &&
        strcmp(advice->variants[k].normal, advice->page.runs[0].scene.normal) == 0 && none == 0)
      none = k;
  for (int level = NB_LEVEL_LOW; level <= 0; level++)
    for (int own = none ? 0 : 1; own < 2; own++) {
      struct nb_variant *variant = &advice->variants[own ? 0 : none];
      const double ratio = reference_ratio(advice, variant, level);
      if (ratio <= 1)
        return (struct chosen){variant, level, ratio};
    }
  return (struct chosen){.variant = NULL};
}

struct chosen choose(struct nb_advice *advice, enum estimator estimator) {
  if (estimator == OWN_REFERENCE)
    return search_references(advice);
  if (estimator == ALWAYS_FINE)
    return (struct chosen){&advice->variants[0], FINEST, 1};
  if (estimator != WHOLE)
    return search(advice, estimator);
  const struct nb_setting *setting = &advice->settings[advice->chosen];
  return (struct chosen){&advice->variants[setting->variant], setting->level, setting->ratio};
}
