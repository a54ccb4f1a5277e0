/* Changes a scene to one with a shorter step, or with softer contacts.
 *
 * `--set refine=R` divides the time step by R and keeps all times:
 *
 *   step                        divided by R, whatever its unit
 *   cycles N, in N steps        N R
 *   at most N cycles            N R, rounded up
 *   every N cycles              in record, until and servo: N R, rounded, at least 1; `every 1 cycle` stays
 *   until cycle above N         N R
 *   at N cycles                 in an expectation: N R (report/expect.c)
 *   strains per cycle           divided by R; so is the largest rate of a servo if it is per cycle
 *   damping con1 X as cs79      X becomes 1 - (1 - X)/R, so that alpha_g = 2 (1 - X)/dt stays [CS79 34-36]
 *   damping con1 X as velocity, and as all:  X becomes X^(1/R), so that free motion decays at the same rate in time
 *
 * If a page starts from another one, only its own stages are refined.
 *
 * `--set soften=S` divides kn, ks and young of all materials and pairs by S, and the values to which stages change
 * them. A damping ratio does not change. The time of `damping stiffness` does not change either, so its damping ratio
 * is divided by S^(1/2).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "core/names.h"
#include "scene.h"

static const double rounding = 1e-9; /* relative error of R, which is written with a limited number of digits */

bool nb_refined_is_whole(double product, double *whole) {
  *whole = nearbyint(product);
  return fabs(product - *whole) <= rounding * *whole;
}

/* Sets a count to `product`, the count times R; `what`: the plural noun of what is counted. False with a message if the
 * product is too large or not a whole number. */
static bool multiply(struct nb_scene_reading *reading, const struct nb_stage *stage, const char *what, double product,
                     unsigned long *count) {
  const double refine = reading->scene->refine;
  double whole;
  if (product > NB_COUNT_MAX)
    return nb_line_mistake(&reading->reader, (size_t)stage->line, NULL,
                           "expected at most %d %s in `%s` with --set refine=%.12g, found %.12g", NB_COUNT_MAX, what,
                           stage->name, refine, product);
  if (!nb_refined_is_whole(product, &whole)) /* a product that rounds to 0 is refused */
    return nb_line_mistake(&reading->reader, (size_t)stage->line, "choose another number for `refine`",
                           "expected a whole number of %s in `%s` with --set refine=%.12g, found %.12g", what,
                           stage->name, refine, product);
  *count = (unsigned long)whole;
  return true;
}

/* An interval is rounded, because rows and checks need not lie at the same times as those of the page. */
static unsigned long interval(unsigned long cycles, double refine) {
  const double product = nearbyint((double)cycles * refine);
  return cycles <= 1 || product < 1 ? (cycles > 0) : (unsigned long)fmin(product, NB_COUNT_MAX);
}

static void refine_rate(struct nb_strain_rate *rate, double refine) {
  if (rate->per_cycle)
    rate->xx /= refine, rate->xy /= refine, rate->yx /= refine, rate->yy /= refine;
}

static void refine_damping(struct nb_damping *damping, double refine) {
  if (damping->global_kind == NB_GLOBAL_CON1_CS79)
    damping->global = 1 - (1 - damping->global) / refine;
  else if (damping->global_kind == NB_GLOBAL_CON1_VELOCITY || damping->global_kind == NB_GLOBAL_CON1_ALL)
    damping->global = pow(damping->global, 1 / refine);
}

static void refine_servo(struct nb_servo *servo, double refine) {
  servo->every = interval(servo->every, refine);
  if (servo->per_cycle)
    servo->max_rate /= refine;
}

/* Multiplies the number of cycles at which the stage ends. */
static bool refine_end(struct nb_scene_reading *reading, struct nb_stage *stage) {
  const double refine = reading->scene->refine, cycles = (double)stage->cycles * refine;
  double whole;
  for (size_t k = 0; k < stage->condition_count; k++)
    if (strcmp(stage->conditions[k].quantity.kind->name, "cycle") == 0)
      stage->conditions[k].value *= refine;
  const bool rounded_up = stage->condition_count > 0 && !nb_refined_is_whole(cycles, &whole);
  return multiply(reading, stage, reading->scene->contact_test ? "steps" : "cycles", rounded_up ? ceil(cycles) : cycles,
                  &stage->cycles);
}

static bool refine_stage(struct nb_scene_reading *reading, struct nb_stage *stage) {
  const double refine = reading->scene->refine;
  stage->step.value /= refine;
  refine_rate(&stage->boundary.strain, refine), refine_rate(&stage->affine.strain, refine);
  refine_rate(&stage->cell, refine), refine_rate(&stage->box, refine);
  refine_damping(&stage->damping, refine);
  refine_servo(&stage->servo, refine);
  if (stage->segment.point_count > 0)
    return nb_line_mistake(&reading->reader, (size_t)stage->line, NULL,
                           "expected no `refine` with `follow`, whose file prescribes each step of `%s`", stage->name);
  stage->record_interval = interval(stage->record_interval, refine);
  stage->check_interval = interval(stage->check_interval, refine);
  return refine_end(reading, stage);
}

void nb_refine(struct nb_scene_reading *reading) {
  struct nb_scene *scene = reading->scene;
  const size_t first = scene->start.stages;
  if (scene->refine == 1)
    return;
  if (first > 0 && first < scene->stage_count && scene->stages[first].step.kind == NB_STEP_COLLISION &&
      scene->stages[first].step.line == scene->stages[first - 1].step.line) {
    nb_line_mistake(&reading->reader, (size_t)scene->stages[first].line, "give the stage a `step`",
                    "expected a stage with its own `step` for `refine`, found one that keeps the step of the stage "
                    "before, a fraction of the collision time");
    return;
  }
  scene->step.value /= scene->refine;
  refine_damping(&scene->damping, scene->refine);
  for (size_t s = first; s < scene->stage_count; s++)
    if (!refine_stage(reading, &scene->stages[s]))
      return;
}

void nb_soften(struct nb_scene_reading *reading) {
  struct nb_scene *scene = reading->scene;
  const double soften = scene->soften;
  if (soften != 1 && scene->start.stages > 0) {
    char hint[NB_HINT_SIZE];
    snprintf(hint, sizeof hint, "soften the other page: write `with soften=%g` in the line `start`", soften);
    nb_line_mistake(&reading->reader, (size_t)scene->start.line, hint,
                    "expected no `soften` with `start`, because the other page has computed the contacts");
    return;
  }
  for (size_t k = 0; k < scene->material_count; k++)
    scene->materials[k].kn /= soften, scene->materials[k].ks /= soften, scene->materials[k].young /= soften;
  for (size_t k = 0; k < scene->pair_rule_count; k++)
    scene->pair_rules[k].kn /= soften, scene->pair_rules[k].ks /= soften;
  for (size_t s = 0; s < scene->stage_count; s++)
    for (size_t k = 0; k < scene->stages[s].change_count; k++)
      scene->stages[s].changes[k].kn /= soften, scene->stages[s].changes[k].ks /= soften;
}
