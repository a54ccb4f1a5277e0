/* Bodies that a page has not said one by one, in words: of gradings what was wanted, and what became of it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "explain.h"

static void explain_fill(FILE *out, const struct nb_scene *scene, const struct nb_fill *fill) {
  const struct nb_grading *grading = &scene->gradings[fill->grading];
  fprintf(out, "  %s %s, seed %lu: %zu of %zu bodies in %llu tries, bodies %zu to %zu (line %d)\n",
          fill->circle ? "circle with" : "box with", grading->name, fill->seed, fill->count, grading->count, fill->made,
          fill->first + 1, fill->first + fill->count, fill->line);
  for (size_t s = 0; s < grading->size_count; s++) {
    const struct nb_size *size = &grading->sizes[s];
    size_t placed = 0;
    for (size_t k = fill->first; k < fill->first + fill->count; k++)
      placed += scene->bodies[k].radius == size->radius;
    fprintf(out, "    radius %g%s: %zu", size->radius, scene->unitless ? "" : " m", placed);
    if (placed < size->count)
      fprintf(out, ", %zu dropped: no place found", size->count - placed);
    fputc('\n', out);
  }
}

void nb_explain_fills(FILE *out, const struct nb_scene *scene) {
  if (scene->fill_count > 0)
    fprintf(out, "filled\n");
  for (size_t f = 0; f < scene->fill_count; f++)
    explain_fill(out, scene, &scene->fills[f]);
  for (size_t p = 0; p < scene->packing_count; p++) {
    const struct nb_packing *packing = &scene->packings[p];
    fprintf(out, "%s  %s: %zu bodies, bodies %zu to %zu (line %d)\n", p ? "" : "packings\n", packing->path,
            packing->count, packing->first + 1, packing->first + packing->count, packing->line);
  }
}
