/* Stress of a region and its parts; compression is positive.                          [R89 sec. 4.6]
 *
 * By particles: particle p, of the volume V_p, has the stress
 *   sigma^p_ij = -(1/V_p) sum over its contacts f_i l_j
 * and the stress of the region is the mean over its volume, with zero stress in the voids: the sum over p of
 * V_p sigma^p_ij, divided by V.
 *
 * By contacts:
 *   sigma_ij = -(1/V) sum over contacts f_i d_j
 * A contact of two particles inside counts once, with the whole branch from centre to centre; a contact with a wall or
 * a particle outside counts with the part of the branch inside. This sum is a check of the first one: it has another
 * order and uses other numbers. Its branch is the difference of two positions, and its force is the vector that moves
 * the particles.
 *
 * Parts, each summed separately. The contact force on the particle is -(N e + T t), where e is the contact normal
 * pointing out of the particle, and t = (e2, -e1):
 *   normal_ij  (1/V) sum N l e_i e_j      shear_ij     (1/V) sum T l t_i e_j          normal + shear = stress
 *   fabric_ij  (1/V) <N> sum l e_i e_j    variation_ij (1/V) sum (N - <N>) l e_i e_j  fabric + variation = normal
 * after Cundall and Strack (1983) and Barnes (1985). `fabric` is the stress that equal normal forces would cause, and
 * `variation` is the contribution of their deviations from the mean.
 *
 *   f      force on the particle at a contact, in sums over contacts on the first particle; with dashpots, N
 *   l_i    vector l e_i from the particle's centre to the contact, m; l its length, m
 *   d      vector from the centre of the contact's first particle to that of the second, only its part inside, m
 *   V      area of the region times thickness, m3
 *   <N>    mean of N over the contact ends on particles inside, in newtons
 *
 * Fraction of a part: its deviator in the principal directions of the total stress, over the total deviator. Fractions
 * of parts that add up to the total add up to 1. sin Phi = (sigma_1 - sigma_2)/(sigma_1 + sigma_2).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "region.h"

static double mean_normal(const struct nb_model *model, const struct nb_region_state *region) {
  double sum = 0, count = 0;
  struct nb_end end;
  for (struct nb_ends ends = nb_ends_begin(model, region); nb_ends_next(&ends, &end); count++)
    sum += end.total_normal;
  return count > 0 ? sum / count : 0;
}

static struct nb_tensor by_particles(const struct nb_model *model, const struct nb_region_state *region) {
  struct nb_tensor sum = {0, 0, 0, 0};
  struct nb_end end;
  for (struct nb_ends ends = nb_ends_begin(model, region); nb_ends_next(&ends, &end);)
    sum = tensor_add(sum, tensor_outer(nb_end_force(&end), vec_scale(end.arm, end.e)));
  return sum;
}

static void find_parts(struct nb_stress *stress, const struct nb_model *model, const struct nb_region_state *region) {
  const double mean = mean_normal(model, region);
  struct nb_tensor sum[NB_STRESS_PARTS_COUNT] = {{0, 0, 0, 0}};
  struct nb_end end;
  for (struct nb_ends ends = nb_ends_begin(model, region); nb_ends_next(&ends, &end);) {
    const struct nb_vec branch = vec_scale(end.arm, end.e);
    const struct nb_tensor along = tensor_outer(end.e, branch), across = tensor_outer(vec_clockwise(end.e), branch);
    sum[NB_STRESS_NORMAL] = tensor_add(sum[NB_STRESS_NORMAL], tensor_scale(end.total_normal, along));
    sum[NB_STRESS_SHEAR] = tensor_add(sum[NB_STRESS_SHEAR], tensor_scale(end.total_shear, across));
    sum[NB_STRESS_FABRIC] = tensor_add(sum[NB_STRESS_FABRIC], tensor_scale(mean, along));
    sum[NB_STRESS_VARIATION] = tensor_add(sum[NB_STRESS_VARIATION], tensor_scale(end.total_normal - mean, along));
  }
  for (int k = 0; k < NB_STRESS_PARTS_COUNT; k++)
    stress->part[k].stress = sum[k];
}

static struct nb_tensor by_contacts(const struct nb_model *model, const struct nb_region_state *region) {
  struct nb_tensor sum = {0, 0, 0, 0};
  const struct nb_contacts *contacts = &model->contacts;
  for (size_t c = 0; c < contacts->count; c++) {
    if (!nb_touches(contacts, c))
      continue;
    const size_t a = (size_t)contacts->a[c], b = (size_t)contacts->b[c];
    const bool wall = nb_with_wall(model, c);
    const bool a_in = nb_region_contains(model, region, a), b_in = !wall && nb_region_contains(model, region, b);
    const struct nb_vec e = vec(contacts->kept[NB_EX][c], contacts->kept[NB_EY][c]);
    struct nb_vec branch = vec(0, 0);
    if (a_in && b_in)
      branch = nb_contacts_branch(model, c);
    else if (a_in)
      branch = vec_scale(nb_contact_arm(model, c, a), e);
    else if (b_in)
      branch = vec_scale(nb_contact_arm(model, c, b), e);
    sum = tensor_sub(sum, tensor_outer(nb_contact_force(contacts, c), branch));
  }
  return sum;
}

static double per_volume(const struct nb_region_state *region) {
  const double volume = region->area * region->thickness;
  return volume > 0 ? 1 / volume : 0;
}

static double sin_phi(struct nb_tensor stress) {
  const double mean = tensor_mean(stress);
  return mean != 0 ? tensor_radius(stress) / mean : 0;
}

/* The deviators of the part and of the total are vectors in Mohr's plane. Returns the projection of the first on the
 * second, over the length of the second. */
static double fraction(struct nb_tensor part, struct nb_tensor whole) {
  const double difference = whole.xx - whole.yy, mixed = whole.xy + whole.yx,
               square = difference * difference + mixed * mixed;
  return square > 0 ? ((part.xx - part.yy) * difference + (part.xy + part.yx) * mixed) / square : 0;
}

/* The largest component of three differences that should be 0, Pa: stress by particles minus stress by contacts, and
 * the sums of parts minus their totals. */
static double residual(const struct nb_stress *stress) {
  const struct nb_tensor normal = stress->part[NB_STRESS_NORMAL].stress, shear = stress->part[NB_STRESS_SHEAR].stress;
  const struct nb_tensor fabric = stress->part[NB_STRESS_FABRIC].stress;
  const struct nb_tensor residuals[] = {
      tensor_sub(stress->total, stress->contacts),
      tensor_sub(tensor_add(normal, shear), stress->total),
      tensor_sub(tensor_add(fabric, stress->part[NB_STRESS_VARIATION].stress), normal),
  };
  double largest = 0;
  for (size_t k = 0; k < sizeof residuals / sizeof *residuals; k++)
    largest = fmax(largest, tensor_largest(residuals[k]));
  return largest;
}

void nb_measure_stress(const struct nb_model *model, struct nb_region_state *region) {
  region->stress.total = tensor_scale(per_volume(region), by_particles(model, region));
  region->stress.sinphi = sin_phi(region->stress.total);
}

void nb_measure_stress_parts(const struct nb_model *model, struct nb_region_state *region) {
  struct nb_stress *stress = &region->stress;
  const double per = per_volume(region);
  nb_region_measured(model, (int)(region - model->regions->list), NB_STRESS);
  find_parts(stress, model, region);
  for (int k = 0; k < NB_STRESS_PARTS_COUNT; k++) {
    stress->part[k].stress = tensor_scale(per, stress->part[k].stress);
    stress->part[k].fraction = fraction(stress->part[k].stress, stress->total);
  }
  stress->contacts = tensor_scale(per, by_contacts(model, region));
  stress->residual = residual(stress);
}
