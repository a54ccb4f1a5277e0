/* Strain and speeds of the particles of a region.
 *
 * The strain is fitted to the displacements by least squares:
 *
 *   d_i = a_i + G_ij X_j,   sum |d - a - G X|^2 least   =>   G = (sum d X')(sum X' X')^-1
 *
 *   X   position when the strain began: at the start, or at the beginning of the stage that `from` names, m
 *   X'  X minus the mean of all X, m      d  displacement since then, m
 *   a   common displacement, m            G  displacement gradient, 1
 *
 * The sum is over the particles that were inside when the strain began and have not been removed, wherever they are
 * now. The strain is the small strain relative to that time, e_ij = (G_ij + G_ji)/2, extension positive as in a strain
 * rate; stress is positive in compression. The strain is 0 unless there are three such particles that are not
 * collinear.
 *
 * Speeds are the speeds |v| of the free particles relative to the imposed motion:               [R89 sec. 6.5.1]
 *
 *   v = u - c,   c = L (x - x_0)
 *
 *   u   velocity at t_N, m/s      c   imposed velocity at t_N, the mean over both half steps, m/s; 0 if none
 *   L   imposed strain rate, 1/s  x, x_0  positions of the particle and of the centre of the motion, m (core/affine.h)
 *
 * R89 calls v the perturbation velocity and c the fixed imposed velocity. `speed.ratio` is mean |v| over mean |c|. R89
 * can be read in two ways: c is stored apart from the particle's own velocity, or c is added to that velocity in every
 * cycle (`accumulated`). In both readings v is u - c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "core/affine.h"
#include "region.h"

static void record_positions(const struct nb_model *model, struct nb_region_state *region) {
  const struct nb_particles *particles = &model->particles;
  for (size_t k = 0; k < particles->count; k++) {
    const size_t i = (size_t)particles->slot[k];
    region->reference_position[k] = nb_region_contains(model, region, i) ? particles->position[i] : vec(NAN, NAN);
  }
}

enum nb_status nb_strain_begin(struct nb_model *model, int stage, struct nb_error *error) {
  const struct nb_scene *scene = model->scene;
  if (!(model->plan.requested & NB_REQUEST_STRAIN))
    return NB_OK;
  for (size_t r = 0; r < scene->region_count; r++) {
    struct nb_region_state *region = nb_region_state(model, (int)r);
    if (!region->reference_position &&
        !(region->reference_position = nb_array(model->particles.count, sizeof *region->reference_position)))
      return nb_error_memory(error);
    if (stage < 0 || scene->regions[r].stage == stage)
      record_positions(model, region);
  }
  return NB_OK;
}

/* Particles count as collinear if 1 - r^2 is at most this, where r is the correlation of their x and y. The limit is
 * well above the rounding error of 1e-15 and far below the value of 1 - r^2 in any packing. */
static const double collinear = 1e-12;

/* G, defined at the top of this file. A `reference` of NaN marks a particle that was outside. */
static struct nb_tensor fit(const struct nb_model *model, const struct nb_vec reference[]) {
  const struct nb_particles *particles = &model->particles;
  struct nb_vec middle = vec(0, 0), mean_displacement = vec(0, 0);
  double count = 0;
  for (size_t k = 0; k < particles->count; k++) {
    const size_t i = (size_t)particles->slot[k];
    if (reference[k].x != reference[k].x || nb_removed(model, i))
      continue;
    middle = vec_add(middle, reference[k]);
    mean_displacement = vec_add(mean_displacement, vec_sub(particles->position[i], reference[k]));
    count++;
  }
  middle = vec_scale(1 / count, middle), mean_displacement = vec_scale(1 / count, mean_displacement);
  struct nb_tensor product = tensor(0, 0, 0, 0), square = product;
  for (size_t k = 0; k < particles->count; k++) {
    const size_t i = (size_t)particles->slot[k];
    if (reference[k].x != reference[k].x || nb_removed(model, i))
      continue;
    const struct nb_vec place = vec_sub(reference[k], middle);
    const struct nb_vec u = vec_sub(vec_sub(particles->position[i], reference[k]), mean_displacement);
    product = tensor_add(product, tensor_outer(u, place));
    square = tensor_add(square, tensor_outer(place, place));
  }
  const double det = square.xx * square.yy - square.xy * square.yx;
  if (!(det > collinear * square.xx * square.yy)) /* the strain at right angles to the line is undefined */
    return tensor(0, 0, 0, 0);
  return tensor_scale(1 / det, tensor(product.xx * square.yy - product.xy * square.yx,
                                      product.xy * square.xx - product.xx * square.xy,
                                      product.yx * square.yy - product.yy * square.yx,
                                      product.yy * square.xx - product.yx * square.xy));
}

void nb_measure_strain(const struct nb_model *model, struct nb_region_state *region) {
  const struct nb_tensor g = fit(model, region->reference_position);
  region->strain = (struct nb_strain){tensor_symmetric(g), tensor_trace(g), (g.yx - g.xy) / 2};
}

/* ---- speeds ---- */

/* c at t_N, the mean over both half steps, m/s. Sets `stored` to true if the particle's own velocity contains c. */
static struct nb_vec imposed(const struct nb_model *model, size_t i, bool *stored) {
  const struct nb_affine *affine = model->affine;
  *stored = affine && model->previous_step > 0 && affine->separate[affine->source[i]] == 0;
  if (!*stored)
    return affine ? nb_imposed_now(model, i) : vec(0, 0);
  const struct nb_vec back = vec_scale(model->previous_step / 2, nb_velocity_half(model, i).velocity);
  return nb_imposed_velocity(affine, i, vec_sub(model->particles.position[i], back));
}

void nb_measure_speeds(const struct nb_model *model, struct nb_region_state *region) {
  struct nb_speeds *it = &region->speeds;
  *it = (struct nb_speeds){0};
  double count = 0;
  for (size_t k = 0, i; nb_region_next(model, region, &k, &i);) {
    if (!(model->particles.inverse_mass[i] > 0))
      continue;
    bool stored;
    const struct nb_vec c = imposed(model, i, &stored), v = nb_velocity_now(model, i).velocity;
    const double own = vec_length(stored ? vec_sub(v, c) : v);
    it->max = own > it->max ? own : it->max;
    it->mean += own, it->imposed += vec_length(c), count++;
  }
  it->ratio = it->imposed > 0 ? it->mean / it->imposed : 0;
  it->mean /= count > 0 ? count : 1, it->imposed /= count > 0 ? count : 1;
}
