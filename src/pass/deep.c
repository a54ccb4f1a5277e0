/* Counts contacts with an overlap beyond the range of Hertz theory [R89 sec. 6.4.3], or beyond the stable overlap of
 * the step (stability.c).
 *
 *   alpha > s 2 min(R_x, R_y)       alpha overlap, m; s fraction of the smaller diameter, 0.07 unless the page gives it
 *   alpha > NB_STABLE_OVERLAP
 *
 * A deep contact counts once per cycle. If the page damps such contacts critically, the pass sets NB_DEEP to 1 for deep
 * contacts and to 0 for all others. A first loop compares the overlaps with the limit of the smallest particle and with
 * the smallest stable overlap of the block; for most blocks this is enough.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "pass.h"

static inline NB_FORM unsigned long count_above(const struct nb_block *block, double least) {
  const double *overlap = block->f[NB_OVERLAP];
  unsigned long count = 0;
  NB_WIDE
  for (size_t c = 0; c < block->n; c++) {
    count += overlap[c] > least ? 1 : 0;
  }
  return count;
}

static inline NB_FORM unsigned long count_above_stable(const struct nb_block *block) {
  const double *overlap = block->f[NB_OVERLAP], *stable_overlap = block->f[NB_STABLE_OVERLAP];
  unsigned long count = 0;
  NB_WIDE
  for (size_t c = 0; c < block->n; c++) {
    count += overlap[c] > stable_overlap[c] ? 1 : 0;
  }
  return count;
}

static inline NB_FORM void mark_deep(const struct nb_model *model, const struct nb_block *block) {
  const double *overlap = block->f[NB_OVERLAP];
  double *mark = block->f[NB_DEEP];
  const double *radius = model->particles.radius;
  const double fraction = 2 * nb_deep_fraction(model), least = fraction * model->search.smallest_radius;
  const double stable_overlap = block->stable_overlap ? block->stable_overlap->overlap : INFINITY;
  const unsigned long any = count_above(block, least < stable_overlap ? least : stable_overlap);
  const size_t marks = model->damping.deep > 0 ? block->n : 0;
  NB_WIDE
  for (size_t c = 0; c < marks; c++) {
    mark[c] = 0;
  }
  if (any == 0)
    return;
  if (block->stable_overlap)
    block->stable_overlap->above = count_above_stable(block);
  if (count_above(block, least) == 0)
    return;
  for (size_t c = 0; c < block->n; c++) {
    const double a = radius[block->a[c]], b = block->material_pair->wall ? a : radius[block->b[c]];
    mark[c] = overlap[c] > fraction * (a < b ? a : b) ? 1 : 0;
    *block->deep += mark[c] > 0 ? 1 : 0;
  }
}
NB_FORMS(mark_deep)

const struct nb_pass nb_pass_deep = {"large overlaps", NB_FORMS_LIST(mark_deep)};
