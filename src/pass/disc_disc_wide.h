/* The loop of disc_disc.h in vector registers, with W contacts at a time: 4 with AVX2, 8 with AVX-512. disc_disc.h
 * includes this file once for each W. The results have the same bits as those of the loop in disc_disc.h, because each
 * contact has the same operations.
 *
 * Loading the vectors of W contacts takes about as long as their arithmetic, which waits for a square root and a
 * division. So the loop loads the next W contacts before it computes the previous ones; the processor can then do both
 * at once.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#if W == 8
#define TARGET NB_TARGET_AVX512
#define WIDE __m512d
#define NAME(name) name##_8
#define OF(operation) _mm512_##operation##_pd
#else
#define TARGET NB_TARGET_AVX2
#define WIDE __m256d
#define NAME(name) name##_4
#define OF(operation) _mm256_##operation##_pd
#endif

/* One number for each of W contacts. */
struct NAME(loaded) {
  WIDE x, y, distance; /* components and length of y - x, m */
  WIDE u, v;           /* components of v_x - v_y, m/s */
  WIDE rotation;       /* w R, m/s */
};

/* The vectors p[i[0]], p[i[2]], ...: those of every second one of W contacts. */
TARGET static inline NB_FORM WIDE NAME(vectors)(const struct nb_vec *p, const int *i) {
#if W == 8
  return _mm512_insertf64x4(_mm512_castpd256_pd512(vectors_4(p, i)), vectors_4(p, i + 4), 1);
#else
  return _mm256_insertf128_pd(_mm256_castpd128_pd256(vec_both(&p[i[0]])), vec_both(&p[i[2]]), 1);
#endif
}

/* The sums of the surface speeds of W contacts. A gather into a register that was set to 0 before does not wait for the
 * earlier result in this register. */
TARGET static inline NB_FORM WIDE NAME(rotations)(const double *speed, const int *a, const int *b) {
#if W == 8
  const __m256i i = _mm256_loadu_si256((const void *)a), j = _mm256_loadu_si256((const void *)b);
  const WIDE zero = _mm512_setzero_pd();
  return _mm512_mask_i32gather_pd(zero, 0xff, i, speed, 8) + _mm512_mask_i32gather_pd(zero, 0xff, j, speed, 8);
#else
  return _mm256_setr_pd(speed[a[0]] + speed[b[0]], speed[a[1]] + speed[b[1]], speed[a[2]] + speed[b[2]],
                        speed[a[3]] + speed[b[3]]);
#endif
}

/* True if one of W contacts began in the last step: nb_touch_began. */
TARGET static inline NB_FORM bool NAME(some_began)(WIDE alpha, WIDE dn) {
  const WIDE zero = OF(setzero)();
#if W == 8
  return _mm512_mask_cmp_pd_mask(_mm512_cmp_pd_mask(alpha, zero, _CMP_GT_OQ), alpha, dn, _CMP_LT_OQ);
#else
  return _mm256_movemask_pd(_mm256_cmp_pd(alpha, zero, _CMP_GT_OQ)) &
         _mm256_movemask_pd(_mm256_cmp_pd(alpha, dn, _CMP_LT_OQ));
#endif
}

/* Loads the contacts from `from` to `from` + W - 1. */
TARGET static inline NB_FORM struct NAME(loaded) NAME(load)(const struct nb_model *model, const struct nb_block *block,
                                                            size_t from, enum nb_approach approach, bool copies) {
  static const int consecutive[] = {0, 1, 2, 3, 4, 5, 6, 7};
  const struct nb_vec *position = model->particles.position, *velocity = model->particles.velocity;
  const int *a = block->a + from, *b = block->b + from;
  const bool moving = approach >= NB_APPROACH_NORMAL;
  const WIDE zero = OF(setzero)();
  /* Positions and velocities are loaded in turn, so that few indices are needed at a time. */
  const WIDE b0 = NAME(vectors)(position, b), vb0 = moving ? NAME(vectors)(velocity, b) : zero;
  const WIDE a0 = NAME(vectors)(position, a), va0 = moving ? NAME(vectors)(velocity, a) : zero;
  const WIDE b1 = NAME(vectors)(position, b + 1), vb1 = moving ? NAME(vectors)(velocity, b + 1) : zero;
  const WIDE a1 = NAME(vectors)(position, a + 1), va1 = moving ? NAME(vectors)(velocity, a + 1) : zero;
  struct NAME(loaded) it;
  it.x = OF(unpacklo)(b0 - a0, b1 - a1);
  it.y = OF(unpackhi)(b0 - a0, b1 - a1);
  it.u = OF(unpacklo)(va0 - vb0, va1 - vb1);
  it.v = OF(unpackhi)(va0 - vb0, va1 - vb1);
  if (copies) {
    const struct nb_vec *image = block->image + from;
    const WIDE m0 = NAME(vectors)(image, consecutive), m1 = NAME(vectors)(image, consecutive + 1);
    const WIDE mx = OF(unpacklo)(m0, m1), my = OF(unpackhi)(m0, m1);
    const struct nb_tensor h = model->cell->h, rate = model->cell->image_velocity;
    it.x += h.xx * mx + h.xy * my;
    it.y += h.yx * mx + h.yy * my;
    it.u -= rate.xx * mx + rate.xy * my;
    it.v -= rate.yx * mx + rate.yy * my;
  }
  it.rotation = approach >= NB_APPROACH_TANGENTIAL ? NAME(rotations)(model->particles.surface_speed, a, b) : zero;
  it.distance = OF(sqrt)(it.x * it.x + it.y * it.y);
  return it;
}

/* Computes the W contacts from c on. True if one of them began in the last step; false without ds. */
TARGET static inline NB_FORM bool NAME(compute)(const struct nb_block *block, size_t c, struct NAME(loaded) it,
                                                enum nb_approach approach, double dt) {
  const WIDE alpha = OF(loadu)(block->f[NB_RADIUS_SUM] + c) - it.distance, scale = 1 / it.distance;
  const WIDE e1 = scale * it.x, e2 = scale * it.y;
  OF(storeu)(block->f[NB_OVERLAP] + c, OF(max)(alpha, OF(setzero)()));
  OF(storeu)(block->f[NB_EX] + c, e1);
  OF(storeu)(block->f[NB_EY] + c, e2);
  if (approach == NB_APPROACH_OVERLAP)
    return false;
  const WIDE normal = (it.u * e1 + it.v * e2) * dt;
  OF(storeu)(block->f[NB_NORMAL_INCREMENT] + c, normal);
  if (approach == NB_APPROACH_NORMAL)
    return false;
  OF(storeu)(block->f[NB_TANGENTIAL_INCREMENT] + c, ((it.u * e2 - it.v * e1) - it.rotation) * dt);
  return NAME(some_began)(alpha, normal);
}

TARGET static inline NB_FORM void NAME(nb_disc_disc)(const struct nb_model *model, const struct nb_block *block,
                                                     enum nb_approach approach, bool copies) {
  if (block->n < W) {
    nb_disc_disc(model, block, approach, copies);
    return;
  }
  const double dt = model->previous_step;
  const size_t last = block->n - W; /* the last W contacts may include some that are computed already */
  bool began = false;
  struct NAME(loaded) one = NAME(load)(model, block, 0, approach, copies), other;
  size_t c = 0;
  for (; c + 2 * W <= last; c += 2 * W) { /* two steps of the loop at once, so that registers need no copies */
    other = NAME(load)(model, block, c + W, approach, copies);
    began |= NAME(compute)(block, c, one, approach, dt);
    one = NAME(load)(model, block, c + 2 * W, approach, copies);
    began |= NAME(compute)(block, c + W, other, approach, dt);
  }
  for (size_t next; c < last; c = next) {
    next = c + W < last ? c + W : last;
    other = NAME(load)(model, block, next, approach, copies);
    began |= NAME(compute)(block, c, one, approach, dt);
    one = other;
  }
  began |= NAME(compute)(block, last, one, approach, dt);
  *block->began = began;
  if (began)
    nb_tangential_since_touch(block);
}

#undef TARGET
#undef WIDE
#undef NAME
#undef OF
#undef W
