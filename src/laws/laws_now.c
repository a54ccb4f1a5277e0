/* The current contact laws: those of the scene, until a stage changes them.
 *
 * A new law starts with an empty contact history, because it cannot interpret the history of another law. A different
 * number of pieces counts as a new law. If a stage names the current law again, the law keeps its history.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "laws_now.h"

struct nb_active_laws nb_laws_initial(const struct nb_scene *scene) {
  const struct nb_law *shear = nb_law_find("shear", scene->shear);
  return (struct nb_active_laws){nb_law_find("normal", scene->normal), shear, scene->normal_line, scene->shear_line,
                                 nb_law_pieces(shear, scene->pieces)};
}

struct nb_active_laws nb_laws_of(const struct nb_stage *stage, struct nb_active_laws before) {
  const struct nb_laws *given = &stage->laws;
  struct nb_active_laws now = before;
  if (given->normal[0])
    now.normal = nb_law_find("normal", given->normal), now.normal_line = given->normal_line;
  if (given->shear[0]) {
    now.shear = nb_law_find("shear", given->shear), now.shear_line = given->shear_line;
    now.pieces = nb_law_pieces(now.shear, given->pieces);
  }
  return now;
}

bool nb_laws_elastic(const struct nb_scene *scene) {
  bool elastic = nb_laws_initial(scene).normal->elastic;
  for (size_t s = 0; s < scene->stage_count && !elastic; s++)
    elastic = scene->stages[s].laws.normal[0] && nb_law_find("normal", scene->stages[s].laws.normal)->elastic;
  return elastic;
}

bool nb_laws_shear(const struct nb_scene *scene) {
  bool shear = strcmp(scene->shear, "none") != 0;
  for (size_t s = 0; s < scene->stage_count && !shear; s++)
    shear = scene->stages[s].laws.shear[0] && strcmp(scene->stages[s].laws.shear, "none") != 0;
  return shear;
}

/* True if some stage sets a friction or a cohesion above 0. */
static bool friction_later(const struct nb_scene *scene) {
  for (size_t s = 0; s < scene->stage_count; s++)
    for (size_t k = 0; k < scene->stages[s].change_count; k++)
      if (scene->stages[s].changes[k].friction > 0 || scene->stages[s].changes[k].cohesion > 0)
        return true;
  return false;
}

bool nb_laws_friction(const struct nb_scene *scene) {
  bool friction = friction_later(scene);
  for (size_t m = 0; m < scene->material_count; m++)
    friction = friction || scene->materials[m].friction > 0 || scene->materials[m].cohesion > 0;
  for (size_t r = 0; r < scene->pair_rule_count; r++)
    friction = friction || scene->pair_rules[r].friction > 0 || scene->pair_rules[r].cohesion > 0;
  return friction;
}

static bool stores_no_energy(const struct nb_law *law) { return law && !law->stored; }

const struct nb_law *nb_laws_unstored(const struct nb_scene *scene, bool normal) {
  const struct nb_law *first = nb_laws_initial(scene).shear;
  if (!normal && friction_later(scene) && stores_no_energy(first))
    return first;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_laws *given = &scene->stages[s].laws;
    const struct nb_law *law = nb_law_find(normal ? "normal" : "shear", normal ? given->normal : given->shear);
    if (stores_no_energy(law))
      return law;
  }
  return NULL;
}

bool nb_laws_normal_changes(const struct nb_model *model) { return model->next_laws.normal != model->laws.normal; }

bool nb_laws_shear_changes(const struct nb_model *model) {
  return model->next_laws.shear != model->laws.shear || model->next_laws.pieces != model->laws.pieces;
}

void nb_laws_change(struct nb_model *model) {
  const bool normal = nb_laws_normal_changes(model), shear = nb_laws_shear_changes(model);
  for (size_t c = 0; c < model->contacts.count; c++) {
    if (normal)
      nb_history_forget(&model->contacts.normal_history, c);
    if (shear)
      nb_history_forget(&model->contacts.shear_history, c);
  }
  model->laws = model->next_laws;
}
