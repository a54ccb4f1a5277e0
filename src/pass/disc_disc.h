/* Relative motion of two discs, or of a disc and an image of a disc.                                  [CS79 8-15]
 *
 * disc_disc.c and periodic.c share this loop.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "geometry.h"

/* `copies`: the second disc is an image in a periodic cell: H m is added to its position, and L H m to its velocity
 * (periodic.c). */
static inline NB_FORM void nb_disc_disc(const struct nb_model *model, const struct nb_block *block,
                                        enum nb_approach approach, bool copies) {
  const struct nb_vec *position = model->particles.position, *velocity = model->particles.velocity;
  const double *surface_speed = model->particles.surface_speed;
  struct relative_motion relative;
  for (size_t c = 0; c < block->n; c++) {
    const int i = block->a[c], j = block->b[c];
    vec_put(&relative.apart[c], vec_both(&position[j]) - vec_both(&position[i]));
    if (approach >= NB_APPROACH_TANGENTIAL)
      relative.rotation[c] = surface_speed[i] + surface_speed[j];
    if (approach >= NB_APPROACH_NORMAL)
      vec_put(&relative.approach[c], vec_both(&velocity[i]) - vec_both(&velocity[j]));
    if (copies)
      relative.apart[c] = vec_add(relative.apart[c], tensor_times(model->cell->h, block->image[c]));
    if (copies && approach >= NB_APPROACH_NORMAL)
      relative.approach[c] = vec_sub(relative.approach[c], tensor_times(model->cell->image_velocity, block->image[c]));
  }
  nb_geometry(model, block, approach, &relative);
}

#ifdef NB_X86
#include <immintrin.h>
#define W 4
#include "disc_disc_wide.h"
#define W 8
#include "disc_disc_wide.h"

/* The forms of a pass. Those for AVX2 and AVX-512 compute 4 and 8 contacts at a time. */
#define NB_DISC_FORMS(name, approach, copies)                                                                          \
  static void name##_plain(const struct nb_model *model, const struct nb_block *block) {                               \
    nb_disc_disc(model, block, approach, copies);                                                                      \
  }                                                                                                                    \
  NB_TARGET_AVX2 static void name##_avx2(const struct nb_model *model, const struct nb_block *block) {                 \
    nb_disc_disc_4(model, block, approach, copies);                                                                    \
  }                                                                                                                    \
  NB_TARGET_AVX512 static void name##_avx512(const struct nb_model *model, const struct nb_block *block) {             \
    nb_disc_disc_8(model, block, approach, copies);                                                                    \
  }
#else
#define NB_DISC_FORMS(name, approach, copies) NB_PASS_FORM(name, nb_disc_disc(model, block, approach, copies))
#endif
