/* Force chains of a region: their number, length and straightness.       (R89, section 6.4.3)
 *
 * The definitions of Peters, Muthuswamy, Wibowo and Tordesillas (2005, Phys. Rev. E 72, 041307) use the stress of each
 * particle:
 *   sigma^p_ij = -(1/V_p) sum over its contacts f_i l_j, Pa            as in stress.c
 *   strong      a particle whose major principal stress is above the mean of all particles inside
 *   link        a contact of two strong particles, within 45 degrees of the major axes of both
 *   chain       three or more particles connected by links
 *
 *   bend        mean angle between two successive links, on opposite sides of the particle that they share, rad; 0: a
 *               straight chain. If more than two links meet in a particle, every pair on opposite sides counts
 *   length      mean number of particles of a chain
 *   fraction    number of particles in chains over the number of free particles inside
 *
 * Only free particles inside count. Let d be the angle of a contact from the major axis. The condition d < 45 degrees
 * is equivalent to cos 2d > 0, which can be computed without the axis and the angle. Two links are on opposite sides of
 * the particle if the angle between them is obtuse. A particle with isotropic stress has no links. If all particles
 * have the same stress, rounding decides which of them are above the mean.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>

#include "region.h"

struct nb_chain_particle {
  struct nb_tensor stress; /* Pa */
  bool strong;
  int root;      /* slot of the particle that represents the chain (union-find) */
  int particles; /* number of particles of the chain; valid in the particle that represents it */
};

bool nb_chains_create(struct nb_model *model) {
  model->regions->chain_particles = nb_array(model->particles.count, sizeof *model->regions->chain_particles);
  return model->regions->chain_particles != NULL;
}

/* Finds the strong particles. Returns the number of free particles inside. */
static double find_strong(const struct nb_model *model, const struct nb_region_state *region) {
  struct nb_chain_particle *chain_particles = model->regions->chain_particles;
  const struct nb_particles *particles = &model->particles;
  struct nb_end end;
  for (size_t i = 0; i < particles->count; i++)
    chain_particles[i] = (struct nb_chain_particle){.root = (int)i, .particles = 1};
  for (struct nb_ends ends = nb_ends_begin(model, region); nb_ends_next(&ends, &end);) {
    const struct nb_tensor part =
        tensor_outer(nb_end_force(&end), vec_scale(end.arm / nb_region_volume(model, end.slot), end.e));
    chain_particles[end.slot].stress = tensor_add(chain_particles[end.slot].stress, part);
  }
  double sum = 0, count = 0;
  for (size_t k = 0, i; nb_region_next(model, region, &k, &i);)
    if (particles->inverse_mass[i] > 0)
      sum += tensor_major(chain_particles[i].stress), count++;
  for (size_t k = 0, i; nb_region_next(model, region, &k, &i);)
    chain_particles[i].strong = particles->inverse_mass[i] > 0 && tensor_major(chain_particles[i].stress) * count > sum;
  return count;
}

static bool is_along_major_axis(struct nb_vec e, struct nb_tensor stress) {
  return (e.x * e.x - e.y * e.y) * (stress.xx - stress.yy) + 2 * e.x * e.y * (stress.xy + stress.yx) > 0;
}

static bool is_link(const struct nb_model *model, const struct nb_end *end) {
  const struct nb_chain_particle *chain_particles = model->regions->chain_particles;
  return end->partner >= 0 && chain_particles[end->slot].strong && chain_particles[end->partner].strong &&
         is_along_major_axis(end->e, chain_particles[end->slot].stress) &&
         is_along_major_axis(end->e, chain_particles[end->partner].stress);
}

static int root_of(struct nb_chain_particle *chain_particles, int i) {
  while (chain_particles[i].root != i)
    i = chain_particles[i].root = chain_particles[chain_particles[i].root].root;
  return i;
}

static void merge(struct nb_chain_particle *chain_particles, int i, int j) {
  const int a = root_of(chain_particles, i), b = root_of(chain_particles, j);
  if (a == b)
    return;
  chain_particles[b].root = a;
  chain_particles[a].particles += chain_particles[b].particles;
}

/* Adds the bends between this link and the later links of the same particle to *bends, and their number to *pairs. */
static void add_bends(const struct nb_model *model, struct nb_ends ends, const struct nb_end *link, double *bends,
                      double *pairs) {
  struct nb_end other;
  while (nb_ends_next(&ends, &other) && other.slot == link->slot) {
    const double ahead = -vec_dot(link->e, other.e), aside = vec_dot(vec_clockwise(link->e), other.e);
    if (!is_link(model, &other) || !(ahead > 0))
      continue;
    *bends += atan2(fabs(aside), ahead);
    ++*pairs;
  }
}

void nb_measure_chains(const struct nb_model *model, struct nb_region_state *region) {
  struct nb_chain_particle *chain_particles = model->regions->chain_particles;
  const double particles = find_strong(model, region);
  double bends = 0, pairs = 0, in_chains = 0, count = 0;
  struct nb_end end;
  for (struct nb_ends ends = nb_ends_begin(model, region); nb_ends_next(&ends, &end);) {
    if (!is_link(model, &end))
      continue;
    merge(chain_particles, (int)end.slot, end.partner);
    add_bends(model, ends, &end, &bends, &pairs);
  }
  for (size_t i = 0; i < model->particles.count; i++)
    if (chain_particles[i].root == (int)i && chain_particles[i].particles > 2)
      in_chains += chain_particles[i].particles, count++;
  region->chains = (struct nb_chains){
      .count = count,
      .length = count > 0 ? in_chains / count : 0,
      .fraction = particles > 0 ? in_chains / particles : 0,
      .bend = pairs > 0 ? bends / pairs : 0,
  };
}
