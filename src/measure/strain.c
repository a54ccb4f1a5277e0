/* How the bodies of a region have moved: the strain that fits best.
 *
 *   u_i = a_i + G_ij X_j,   sum |u - a - G X|^2 least   =>   G = (sum u X')(sum X' X')^-1
 *
 *   X    where a body was when strain began: at the start, or as the stage begins that `from` names, m
 *   X'   from the mean of all X      u  how far it has come since, m      G  displacement gradient, 1
 *
 * The bodies are those that were inside then and are not gone; they are followed wherever they go. Strain is small strain of
 * that moment's lengths, e_ij = (G_ij + G_ji)/2; extension is positive, as in a rate of strain, while of a stress compression is.
 * Three bodies that do not lie in a line are the fewest that have one.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>

#include "region.h"

static void remember(const struct nb_model *model, struct nb_region_now *region) {
  const struct nb_bodies *bodies = &model->bodies;
  for (size_t k = 0; k < bodies->count; k++) {
    const size_t i = (size_t)bodies->slot[k];
    region->from[k] = nb_region_holds(model, region, i) ? bodies->position[i] : vec(NAN, NAN);
  }
}

enum nb_status nb_strain_begin(struct nb_model *model, int stage, struct nb_error *error) {
  const struct nb_scene *scene = model->scene;
  if (!(model->plan.asked & NB_ASKS_STRAIN))
    return NB_OK;
  for (size_t r = 0; r < scene->region_count; r++) {
    struct nb_region_now *region = nb_region_now(model, (int)r);
    if (!region->from && !(region->from = nb_array(model->bodies.count, sizeof *region->from)))
      return nb_error_memory(error);
    if (stage < 0 || scene->regions[r].stage == stage)
      remember(model, region);
  }
  return NB_OK;
}

static struct nb_tensor fit(const struct nb_model *model, const struct nb_vec from[]) {
  const struct nb_bodies *bodies = &model->bodies;
  struct nb_vec middle = vec(0, 0), moved = vec(0, 0);
  double count = 0;
  for (size_t k = 0; k < bodies->count; k++) {
    const size_t i = (size_t)bodies->slot[k];
    if (from[k].x != from[k].x || nb_gone(model, i))
      continue;
    middle = vec_add(middle, from[k]);
    moved = vec_add(moved, vec_sub(bodies->position[i], from[k]));
    count++;
  }
  if (count < 3)
    return tensor(0, 0, 0, 0);
  middle = vec_scale(1 / count, middle), moved = vec_scale(1 / count, moved);
  struct nb_tensor both = tensor(0, 0, 0, 0), square = both;
  for (size_t k = 0; k < bodies->count; k++) {
    const size_t i = (size_t)bodies->slot[k];
    if (from[k].x != from[k].x || nb_gone(model, i))
      continue;
    const struct nb_vec place = vec_sub(from[k], middle);
    const struct nb_vec u = vec_sub(vec_sub(bodies->position[i], from[k]), moved);
    both = tensor_add(both, tensor_outer(u, place));
    square = tensor_add(square, tensor_outer(place, place));
  }
  const double det = square.xx * square.yy - square.xy * square.yx;
  if (!(det > 1e-12 * square.xx * square.yy)) /* in a line: nothing is known of the strain across it */
    return tensor(0, 0, 0, 0);
  return tensor_scale(1 / det,
                      tensor(both.xx * square.yy - both.xy * square.yx, both.xy * square.xx - both.xx * square.xy,
                             both.yx * square.yy - both.yy * square.yx, both.yy * square.xx - both.yx * square.xy));
}

static struct nb_tensor strain_of(const struct nb_model *model, const struct nb_watch *watch) {
  struct nb_region_now *region = nb_region_now(model, watch->a);
  if (nb_region_due(model, region, NB_STRAIN))
    region->strain = fit(model, region->from);
  return region->strain;
}

#define STRAIN tensor_symmetric(strain_of(model, watch))
NB_TENSOR_QUANTITIES(strain, STRAIN)
NB_QUANTITY(volume, tensor_trace(STRAIN))
NB_QUANTITY(turn, (strain_of(model, watch).yx - strain_of(model, watch).xy) / 2)

const struct nb_quantity_kind nb_strain_kinds[] = {
    NB_TENSOR_ROWS("strain", NB_OF_REGION, "1", NB_ASKS_STRAIN, strain, "deviator",
                   "strain that fits the bodies' displacements best, extension positive"),
    {"strain.volume", NB_OF_REGION, "1", NB_ASKS_STRAIN, volume, "xx + yy: growth of the area"},
    {"strain.turn", NB_OF_REGION, "rad", NB_ASKS_STRAIN, turn,
     "how far the region has turned, counterclockwise, as small turns go"},
    {NULL, 0, NULL, 0, NULL, NULL},
};
