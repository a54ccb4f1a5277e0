/* How fast the free bodies of a region go beyond what carries them along.                                      [R89 6.5.1]
 *
 *   w = u - c,   c = L (x - x_0)
 *
 *   u   velocity of a body at t_N, m/s      c   what carries it along then, the mean over both half steps, m/s; 0 where nothing does
 *
 * R89's *perturbation velocities* are w, its *fixed imposed velocities* c. `speed.ratio` is mean |w| over mean |c|.
 * Where c is added to u for good (`literal`) w is still u - c, so that both codings are measured alike.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "core/carry.h"
#include "region.h"

/* c at t_N, the mean over both half steps; `stored`: it is a part of the body's own velocity. */
static struct nb_vec carried(const struct nb_model *model, size_t i, bool *stored) {
  const struct nb_carry *carry = model->carry;
  *stored = carry && model->previous_step > 0 && carry->remembered[carry->by[i]] == 0;
  if (!*stored)
    return carry ? nb_carried_now(model, i) : vec(0, 0);
  const struct nb_vec back = vec_scale(model->previous_step / 2, nb_velocity_half(model, i).velocity);
  return nb_carried_at(carry, i, vec_sub(model->bodies.position[i], back));
}

static const struct nb_speeds *speeds_of(const struct nb_model *model, const struct nb_watch *watch) {
  struct nb_region_now *region = nb_region_now(model, watch->a);
  struct nb_speeds *it = &region->speeds;
  if (!nb_region_due(model, region, NB_SPEEDS))
    return it;
  *it = (struct nb_speeds){0};
  double count = 0;
  for (size_t k = 0; k < model->bodies.count; k++) {
    const size_t i = (size_t)model->bodies.slot[k];
    if (!(model->bodies.inverse_mass[i] > 0) || !nb_region_holds(model, region, i))
      continue;
    bool stored;
    const struct nb_vec c = carried(model, i, &stored), v = nb_velocity_now(model, i).velocity;
    const double own = vec_length(stored ? vec_sub(v, c) : v);
    it->max = own > it->max ? own : it->max;
    it->mean += own, it->carried += vec_length(c), count++;
  }
  it->ratio = it->carried > 0 ? it->mean / it->carried : 0;
  it->mean /= count > 0 ? count : 1, it->carried /= count > 0 ? count : 1;
  return it;
}

#define SPEEDS speeds_of(model, watch)
NB_QUANTITY(mean, SPEEDS->mean)
NB_QUANTITY(max, SPEEDS->max)
NB_QUANTITY(carried_mean, SPEEDS->carried)
NB_QUANTITY(ratio, SPEEDS->ratio)

const struct nb_quantity_kind nb_speed_kinds[] = {
    {"speed.mean", NB_OF_REGION, "m/s", 0, mean,
     "speed of the free bodies inside beyond what carries them along, mean"},
    {"speed.max", NB_OF_REGION, "m/s", 0, max, "the same, the largest"},
    {"speed.carried", NB_OF_REGION, "m/s", 0, carried_mean, "speed at which they are carried along, mean"},
    {"speed.ratio", NB_OF_REGION, "1", 0, ratio, "speed.mean over speed.carried [R89 6.5.1]; 0: nothing is carried"},
    {NULL, 0, NULL, 0, NULL, NULL},
};
