/* What a stage changes, in words: which values, and whether shear is switched on or off by it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "explain.h"

static void value(FILE *out, const char *word, double to) {
  if (!isnan(to))
    fprintf(out, " %s %g", word, to);
}

static void explain_change(FILE *out, const struct nb_scene *scene, const struct nb_change *change) {
  fprintf(out, "    %s%s", change->ramp ? "ramp " : "", change->b < 0 ? "material " : "pair ");
  fprintf(out, "%s%s%s", scene->materials[change->a].name, change->b < 0 ? "" : " ",
          change->b < 0 ? "" : scene->materials[change->b].name);
#define ROW(name, ...) value(out, #name, change->name);
  NB_PAIR_ROWS(ROW)
#undef ROW
  fprintf(out, " (line %d)\n", change->line);
}

static bool rubs(struct nb_pair pair) { return pair.friction > 0 || pair.cohesion > 0; }

/* What the stage leaves behind, and what that does to the plan. */
static void explain_shear(FILE *out, const struct nb_model *model, const struct nb_properties *before,
                          const struct nb_properties *after) {
  const struct nb_scene *scene = model->scene;
  for (size_t p = 0; p < model->pairing_count; p++) {
    const struct nb_pairing *pairing = &model->pairings[p];
    const bool had = rubs(nb_properties_pair(before, pairing->a, pairing->b));
    const bool has = rubs(nb_properties_pair(after, pairing->a, pairing->b));
    if (had != has && strcmp(model->laws.shear->name, "none") != 0)
      fprintf(out, "    %s with %s%s: shear %s is switched %s, %s\n", scene->materials[pairing->a].name,
              pairing->wall ? "wall of " : "", scene->materials[pairing->b].name, model->laws.shear->name,
              has ? "on" : "off", has ? "remembering nothing" : "and forgets");
  }
}

void nb_explain_gravity(FILE *out, const struct nb_gravity *gravity, const char *unit) {
  if (gravity->line && gravity->inward != 0)
    fprintf(out, "%sgravity centripetal %g%s about %g, %g (line %d)\n", gravity->ramp ? "ramp " : "", gravity->inward,
            unit, gravity->about_x, gravity->about_y, gravity->line);
  else if (gravity->line)
    fprintf(out, "%sgravity %g %g%s (line %d)\n", gravity->ramp ? "ramp " : "", gravity->x, gravity->y, unit,
            gravity->line);
}

static void explain_law(FILE *out, const char *kind, const struct nb_law *old, const struct nb_law *new, int line) {
  fprintf(out, "    %s %s instead of %s: contacts remember nothing of it (line %d)\n", kind, new->name,
          old == new ? "so many pieces" : old->name, line);
}

/* Which laws are in force before the stage, and which from it on. */
static void explain_laws(FILE *out, const struct nb_model *model, const struct nb_stage *stage) {
  struct nb_in_force old = nb_laws_at_start(model->scene);
  for (const struct nb_stage *s = model->scene->stages; s < stage; s++)
    old = nb_laws_of(s, old);
  const struct nb_in_force now = nb_laws_of(stage, old);
  if (now.normal != old.normal)
    explain_law(out, "normal", old.normal, now.normal, now.normal_line);
  if (now.shear != old.shear || now.pieces != old.pieces)
    explain_law(out, "shear", old.shear, now.shear, now.shear_line);
}

bool nb_explain_changes(FILE *out, const struct nb_model *model, const struct nb_stage *stage,
                        struct nb_properties *now) {
  struct nb_properties before = {0};
  explain_laws(out, model, stage);
  nb_explain_drive(out, model, stage);
  if (stage->still)
    fprintf(out, "    still: all bodies stop\n");
  for (size_t k = 0; k < stage->removal_count; k++) {
    const struct nb_removal *it = &stage->removals[k];
    fprintf(out, "    remove body %zu", it->from + 1);
    if (it->to > it->from)
      fprintf(out, " to %zu", it->to + 1);
    fprintf(out, " (line %d)\n", it->line);
  }
  if (stage->gravity.line)
    fprintf(out, "    ");
  nb_explain_gravity(out, &stage->gravity, model->scene->unitless ? "" : " m/s2");
  if (stage->change_count == 0)
    return true;
  if (!nb_properties_create(&before, model->scene))
    return false;
  memcpy(before.materials, now->materials, model->scene->material_count * sizeof *now->materials);
  memcpy(before.rules, now->rules, now->rule_count * sizeof *now->rules);
  before.rule_count = now->rule_count;
  for (size_t k = 0; k < stage->change_count; k++) {
    explain_change(out, model->scene, &stage->changes[k]);
    nb_properties_change(now, &stage->changes[k], nb_properties_before(now, &stage->changes[k]), 1);
  }
  explain_shear(out, model, &before, now);
  nb_properties_free(&before);
  return true;
}
