/* Force chains of a region: how many bodies are in them, and how straight they are.       (R89, section 6.4.3)
 *
 * As Peters, Muthuswamy, Wibowo and Tordesillas (2005, Phys. Rev. E 72, 041307) find them, from the stress of each body:
 *   sigma^p_ij = -(1/V_p) sum over its contacts f_i l_j                as in stress.c
 *   strong      its major principal stress is above the mean of those of all bodies inside
 *   link        a contact of two strong bodies that lies within 45 degrees of the major axes of both
 *   chain       three bodies or more that hang together by links
 *
 *   turn        angle between two successive links, one ahead and one behind of the body that they share: 0 goes straight on.
 *               Where several links go ahead or come from behind each pair of them counts, so no branch is chosen
 *   length      bodies of a chain          share      of the bodies inside, those in chains
 *
 * The bodies are those inside that are free. With d the angle from the major axis, d < 45 degrees is cos 2d > 0, which takes
 * neither axis nor angle; and then two links lie on different sides of the body where the angle between them is obtuse. A body
 * whose stress has no axis, the same all round, has no links. Where all bodies carry alike, rounding says which of them are above
 * the mean.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>

#include "region.h"

struct nb_chain_particle {
  struct nb_tensor stress; /* Pa */
  bool strong;
  int root, particles; /* slot of the body that stands for its chain; there: how many there are */
};

bool nb_chains_create(struct nb_model *model) {
  model->regions->chained = nb_array(model->particles.count, sizeof *model->regions->chained);
  return model->regions->chained != NULL;
}

/* Answers how many bodies there are. */
static double find_strong(const struct nb_model *model, const struct nb_region_now *region) {
  struct nb_chain_particle *chained = model->regions->chained;
  const struct nb_particles *particles = &model->particles;
  struct nb_end end;
  for (size_t i = 0; i < particles->count; i++)
    chained[i] = (struct nb_chain_particle){.root = (int)i, .particles = 1};
  for (struct nb_ends ends = nb_ends_of(model, region); nb_ends_next(&ends, &end);) {
    const struct nb_tensor part =
        tensor_outer(nb_end_force(&end), vec_scale(end.arm / nb_region_volume(model, end.slot), end.e));
    chained[end.slot].stress = tensor_add(chained[end.slot].stress, part);
  }
  double sum = 0, count = 0;
  for (size_t k = 0, i; nb_region_next(model, region, &k, &i);)
    if (particles->inverse_mass[i] > 0)
      sum += tensor_major(chained[i].stress), count++;
  for (size_t k = 0, i; nb_region_next(model, region, &k, &i);)
    chained[i].strong = particles->inverse_mass[i] > 0 && tensor_major(chained[i].stress) * count > sum;
  return count;
}

static bool is_along(struct nb_vec e, struct nb_tensor stress) {
  return (e.x * e.x - e.y * e.y) * (stress.xx - stress.yy) + 2 * e.x * e.y * (stress.xy + stress.yx) > 0;
}

static bool is_link(const struct nb_model *model, const struct nb_end *end) {
  const struct nb_chain_particle *chained = model->regions->chained;
  return end->partner >= 0 && chained[end->slot].strong && chained[end->partner].strong &&
         is_along(end->e, chained[end->slot].stress) && is_along(end->e, chained[end->partner].stress);
}

static int root_of(struct nb_chain_particle *chained, int i) {
  while (chained[i].root != i)
    i = chained[i].root = chained[chained[i].root].root;
  return i;
}

static void join(struct nb_chain_particle *chained, int i, int j) {
  const int a = root_of(chained, i), b = root_of(chained, j);
  if (a == b)
    return;
  chained[b].root = a;
  chained[a].particles += chained[b].particles;
}

/* The links of the body that come behind this one, each as a pair with it. */
static void add_turns(const struct nb_model *model, struct nb_ends ends, const struct nb_end *link, double *turns,
                      double *pairs) {
  struct nb_end other;
  while (nb_ends_next(&ends, &other) && other.slot == link->slot) {
    const double on = -vec_dot(link->e, other.e), aside = vec_dot(vec_clockwise(link->e), other.e);
    if (!is_link(model, &other) || !(on > 0))
      continue;
    *turns += atan2(fabs(aside), on);
    ++*pairs;
  }
}

void nb_measure_chains(const struct nb_model *model, struct nb_region_now *region) {
  struct nb_chain_particle *chained = model->regions->chained;
  const double particles = find_strong(model, region);
  double turns = 0, pairs = 0, in_chains = 0, count = 0;
  struct nb_end end;
  for (struct nb_ends ends = nb_ends_of(model, region); nb_ends_next(&ends, &end);) {
    if (!is_link(model, &end))
      continue;
    join(chained, (int)end.slot, end.partner);
    add_turns(model, ends, &end, &turns, &pairs);
  }
  for (size_t i = 0; i < model->particles.count; i++)
    if (chained[i].root == (int)i && chained[i].particles > 2)
      in_chains += chained[i].particles, count++;
  region->chains = (struct nb_chains){
      .count = count,
      .length = count > 0 ? in_chains / count : 0,
      .fraction = particles > 0 ? in_chains / particles : 0,
      .turn = pairs > 0 ? turns / pairs : 0,
  };
}
