/* Sets the overlap of suppressed contacts at vertices of walls to 0. Bit 0 of `suppressed` marks the contacts that are
 * suppressed in the current forces (core/wall_vertices.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "pass.h"

static inline NB_FORM void suppress(const struct nb_model *model, const struct nb_block *block) {
  const int *suppressed = model->contacts.suppressed + (block->a - model->contacts.a);
  double *overlap = block->f[NB_OVERLAP];
  NB_WIDE
  for (size_t c = 0; c < block->n; c++)
    overlap[c] = suppressed[c] & 1 ? 0 : overlap[c];
}
NB_FORMS(suppress)

const struct nb_pass nb_pass_vertices = {"single contact at wall vertices", NB_FORMS_LIST(suppress)};
