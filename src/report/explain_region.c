/* Regions in words: what they are, how many bodies are inside as the scene begins, and who looks at them.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "explain.h"
#include "measure/region.h"

static size_t inside(const struct nb_model *model, int region) {
  const struct nb_region_now *now = nb_region_now(model, region);
  size_t count = 0;
  for (size_t i = 0; i < model->bodies.count; i++)
    count += !nb_gone(model, i) && nb_region_holds(model, now, i);
  return count;
}

static void explain_shape(FILE *out, const struct nb_region *it, const char *unit) {
  switch (it->kind) {
  case NB_REGION_CIRCLE:
    fprintf(out, "circle of %g%s about %g, %g", it->radius, unit, it->x, it->y);
    break;
  case NB_REGION_BOX:
    fprintf(out, "box of %g by %g%s about %g, %g", 2 * it->half_x, 2 * it->half_y, unit, it->x, it->y);
    break;
  case NB_REGION_INSIDE:
    fprintf(out, "inside %g of the boundary's mean radius", it->radius);
    break;
  case NB_REGION_ALL:
    fputs("all there is", out);
    break;
  }
}

/* Columns, and the stages that end by it, are held by it, or keep its rings. */
static void explain_use(FILE *out, const struct nb_scene *scene, int watch, bool rings) {
  size_t columns = 0;
  for (size_t c = 0; c < scene->column_count; c++)
    columns += scene->columns[c].quantity.watch == watch;
  fprintf(out, "    %zu column%s", columns, columns == 1 ? "" : "s");
  for (size_t s = scene->start.stages; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    for (size_t k = 0; k < stage->condition_count; k++)
      if (stage->conditions[k].quantity.watch == watch)
        fprintf(out, ", the end of stage `%s`", stage->name);
    if (stage->servo.line && stage->servo.quantity[0].watch == watch)
      fprintf(out, ", the servo of stage `%s`", stage->name);
    if (stage->snapshot && rings)
      fprintf(out, ", the snapshot of stage `%s`", stage->name);
  }
  fputc('\n', out);
}

void nb_explain_regions(FILE *out, const struct nb_model *model) {
  const struct nb_scene *scene = model->scene;
  if (scene->region_count > 0)
    fputs("regions\n", out);
  for (size_t w = 0; w < scene->watch_count; w++) {
    const struct nb_watch *watch = &scene->watches[w];
    if (watch->kind != NB_WATCH_REGION)
      continue;
    const struct nb_region *it = &scene->regions[watch->a];
    fprintf(out, "  %s: ", watch->name);
    explain_shape(out, it, scene->unitless ? "" : " m");
    fprintf(out, ": %zu bodies now; strain since %s%s", inside(model, watch->a), it->stage < 0 ? "the start" : "stage ",
            it->stage < 0 ? "" : scene->stages[it->stage].name);
    if (it->rings)
      fprintf(out, "; %d rings", it->rings);
    fprintf(out, " (line %d)\n", it->line);
    explain_use(out, scene, (int)w, it->rings > 0);
  }
}
