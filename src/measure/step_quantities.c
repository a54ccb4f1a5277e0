/* Quantities about the step.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "core/names.h"
#include "step.h"

#define OF_STEP(function, expression)                                                                                  \
  static double function(const struct nb_model *model, const struct nb_watch *watch) {                                 \
    (void)watch;                                                                                                       \
    return expression;                                                                                                 \
  }
OF_STEP(step, model->step)
OF_STEP(critical, model->critical)
OF_STEP(safe, nb_safe_step(model).step)
OF_STEP(fracc, model->fracc->largest)
OF_STEP(rayleigh, nb_step_rayleigh(model, false, false))
OF_STEP(rayleigh_mean, nb_step_rayleigh(model, false, true))
OF_STEP(rayleigh_fit, nb_step_rayleigh(model, true, false))
OF_STEP(rayleigh_fit_mean, nb_step_rayleigh(model, true, true))

const struct nb_quantity_kind nb_step_kinds[] = {
    {"step", 0, "s", 0, step, "the time step"},
    {"step.critical", 0, "s", 0, critical, "2 sqrt(m/k), smallest mass over largest stiffness [CS79, Motion]"},
    {"step.safe", 0, "s", 0, safe, "the largest step sure to be stable with the contacts and the damping of now"},
    {"step.fracc", 0, "1", NB_ASKS_FRACC, fracc,
     "FRACC, the largest of all bodies in the cycle behind: no bound for anything [R89 4.40]"},
    {"step.rayleigh", 0, "s", 0, rayleigh, "a surface wave's time half round the smallest sphere [R89 4.33]"},
    {"step.rayleigh-mean", 0, "s", 0, rayleigh_mean, "the same round the sphere that is the mean of all"},
    {"step.rayleigh-fit", 0, "s", 0, rayleigh_fit, "as step.rayleigh, with R89's fit of the wave's speed [R89 4.34]"},
    {"step.rayleigh-fit-mean", 0, "s", 0, rayleigh_fit_mean, "R89's step: the fit, and the mean sphere"},
    {.name = NULL},
};
