/* No shear force:                                          F_s = 0
 *
 * The plan of a scene with `shear none`, or without friction and cohesion, computes no tangential displacement, stores
 * no shear history, and never calls this law. A contact test without a shear law calls it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "law.h"

static inline struct nb_shear shear_none(struct nb_pair p, struct nb_normal n, double ds, double m[]) {
  (void)p, (void)n, (void)ds, (void)m;
  return (struct nb_shear){0};
}

static double shear_none_stored(struct nb_pair p, struct nb_normal n, const double m[]) {
  (void)p, (void)n, (void)m;
  return 0;
}

#define LAW shear_none
#define SHEAR
#define CONSTANT
#define TITLE "no shear force"
#define SOURCE "-"
#define PARAMETERS ""
#define HISTORY 0
#define STORED shear_none_stored
#include "law_batch.h"
