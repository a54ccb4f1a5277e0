/* Contacts that the bodies of a region have lost and made, and which way they point.                     [R89 figure 6.35]
 *
 *   Phi_ij = <n_i n_j>   mean over the ends of such contacts on bodies inside, as that of all contacts is in fabric.c
 *
 *   lost   touched as the region's `from` stage began, or the run, and does not now
 *   new    touches now and did not then: what has parted and met again in between is neither
 *   n      unit vector between the centres of now, or to the nearest point of the wall, 1
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "region.h"
#include "since.h"

enum nb_status nb_parted_begin(struct nb_model *model, int stage, struct nb_error *error) {
  const struct nb_scene *scene = model->scene;
  if (!(model->plan.asked & NB_ASKS_PARTED))
    return NB_OK;
  for (size_t r = 0; r < scene->region_count; r++)
    if ((stage < 0 || scene->regions[r].stage == stage) && !nb_since_touching(&model->regions->list[r].touched, model))
      return nb_error_memory(error);
  return NB_OK;
}

static double ends_inside(const struct nb_model *model, const struct nb_region_now *region, struct nb_near_pair pair) {
  const bool wall = model->pairings[pair.pairing].wall;
  return nb_region_holds(model, region, (size_t)pair.a) + (!wall && nb_region_holds(model, region, (size_t)pair.b));
}

static void add(struct nb_parted *it, double ends, struct nb_vec line) {
  const double square = vec_dot(line, line); /* 0: a centre on a wall */
  it->count += ends > 0, it->ends += ends;
  it->phi = tensor_add(it->phi, tensor_scale(square > 0 ? ends / square : 0, tensor_outer(line, line)));
}
static void divide(struct nb_parted *it) { it->phi = tensor_scale(it->ends > 0 ? 1 / it->ends : 0, it->phi); }

static const struct nb_region_now *parted_of(const struct nb_model *model, const struct nb_watch *watch) {
  struct nb_region_now *region = nb_region_now(model, watch->a);
  if (!nb_region_due(model, region, NB_PARTED))
    return region;
  region->lost = region->made = (struct nb_parted){0};
  struct nb_since_walk walk = {.model = model, .then = &region->touched};
  struct nb_near_pair pair;
  for (int kind; nb_since_next(&walk, &pair, &kind);)
    if (kind)
      add(kind < 0 ? &region->lost : &region->made, ends_inside(model, region, pair), nb_since_line(model, pair));
  divide(&region->lost), divide(&region->made);
  return region;
}

NB_QUANTITY(lost_count, parted_of(model, watch)->lost.count)
NB_QUANTITY(made_count, parted_of(model, watch)->made.count)
NB_TENSOR_QUANTITIES(lost, parted_of(model, watch)->lost.phi)
NB_TENSOR_QUANTITIES(made, parted_of(model, watch)->made.phi)

enum { READS = NB_READS_TOUCH | NB_ASKS_PARTED };
const struct nb_quantity_kind nb_parted_kinds[] = {
    {"contacts.lost", NB_OF_REGION, "1", READS, lost_count,
     "how many contacts its bodies have lost since the stage that `from` names, else the start"},
    {"contacts.new", NB_OF_REGION, "1", READS, made_count, "how many they have made since"},
    NB_TENSOR_ROWS("fabric.lost", NB_OF_REGION, "1", READS, lost, "anisotropy", "Phi of contacts lost since"),
    NB_TENSOR_ROWS("fabric.new", NB_OF_REGION, "1", READS, made, "anisotropy", "Phi of contacts made since"),
    {NULL, 0, NULL, 0, NULL, NULL},
};
