/* What laws of elastic spheres ask of a scene, checked when all of it has been read.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "laws/law.h"
#include "scene.h"

/* At the first word of that line. */
static void say(struct nb_scene_reading *reading, int line, const char *hint, const char *what, const char *name) {
  if (nb_line_read(&reading->reader, (size_t)line))
    nb_token_mistake(&reading->reader, &reading->reader.tokens[0], hint, what, name);
}

static void check_material(struct nb_scene_reading *reading, int index, bool *said) {
  const struct nb_material *material = &reading->scene->materials[index];
  if (material->young == 0 && !said[index])
    say(reading, material->line, "add `young E  poisson NU`, or `rigid`",
        "expected a material with `young` for `normal %s`", reading->scene->normal);
  said[index] = true;
}

/* Of two that may touch one must give. */
static void check_rigid(struct nb_scene_reading *reading, const int *on_body, const int *on_wall) {
  const struct nb_scene *scene = reading->scene;
  for (size_t i = 0; i < scene->material_count; i++) {
    if (!isinf(scene->materials[i].young) || !on_body[i])
      continue;
    for (size_t k = 0; k < scene->material_count; k++)
      if (isinf(scene->materials[k].young) && (k == i ? on_body[i] > 1 || on_wall[i] : on_body[k] || on_wall[k])) {
        say(reading, scene->materials[i].line, "give one of them `young E  poisson NU`",
            "expected of two materials that may touch at most one that is rigid, both are: `%s`",
            scene->materials[k].name);
        return;
      }
  }
}

static void check_elastic(struct nb_scene_reading *reading) {
  const struct nb_scene *scene = reading->scene;
  bool said[NB_MATERIALS_MAX] = {false};
  int on_body[NB_MATERIALS_MAX] = {0}, on_wall[NB_MATERIALS_MAX] = {0};
  const struct nb_body *disc = NULL;
  for (size_t k = 0; k < scene->body_count; k++) {
    check_material(reading, scene->bodies[k].material, said);
    on_body[scene->bodies[k].material]++;
    if (!disc && scene->bodies[k].shape == NB_DISC)
      disc = &scene->bodies[k];
  }
  for (size_t w = 0; w < scene->wall_count; w++)
    if (scene->walls[w].material >= 0)
      check_material(reading, scene->walls[w].material, said), on_wall[scene->walls[w].material]++;
  if (disc)
    say(reading, disc->line, "`sphere` or `spheres`, or `normal linear`",
        "expected spheres for `normal %s`, found a disc", scene->normal);
  check_rigid(reading, on_body, on_wall);
}

/* The first line that gives something cohesion; 0: none does. */
static int cohesive_line(const struct nb_scene *scene) {
  for (size_t m = 0; m < scene->material_count; m++)
    if (scene->materials[m].cohesion > 0)
      return scene->materials[m].line;
  for (size_t r = 0; r < scene->pair_rule_count; r++)
    if (scene->pair_rules[r].cohesion > 0)
      return scene->pair_rules[r].line;
  for (size_t s = 0; s < scene->stage_count; s++)
    for (size_t c = 0; c < scene->stages[s].change_count; c++)
      if (scene->stages[s].changes[c].cohesion > 0)
        return scene->stages[s].changes[c].line;
  return 0;
}

/* The dashpots that such a normal law cannot have. */
static void check_damping(struct nb_scene_reading *reading, const struct nb_damping *damping, bool elastic) {
  if (!elastic && damping->deep > 0)
    say(reading, damping->deep_line, "`normal hertz`", "expected a normal law of elastic spheres for `%s`",
        "damping critical");
  if (elastic && damping->contact_kind == NB_CONTACT_FRACTION)
    say(reading, damping->contact_line, "elastic spheres have no critical step; `contact-ratio`",
        "expected no `contact-fraction` for `normal %s`", reading->scene->normal);
  if (elastic && damping->walls_apart && damping->walls_kind == NB_CONTACT_FRACTION)
    say(reading, damping->walls_line, "elastic spheres have no critical step; `contact-ratio`",
        "expected no `contact-fraction` for `normal %s`", reading->scene->normal);
}

void nb_laws_check(struct nb_scene_reading *reading) {
  const struct nb_scene *scene = reading->scene;
  const struct nb_law *normal = nb_law_find("normal", scene->normal), *shear = nb_law_find("shear", scene->shear);
  if (!normal || !shear)
    return;
  if (normal->elastic)
    check_elastic(reading);
  else if (shear->elastic)
    say(reading, scene->shear_line ? scene->shear_line : scene->normal_line, "`normal hertz`",
        "expected a normal law of elastic spheres for `shear %s`", scene->shear);
  check_damping(reading, &scene->damping, normal->elastic);
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_damping *before = s ? &scene->stages[s - 1].damping : &scene->damping;
    if (!nb_damping_alike(before, &scene->stages[s].damping)) /* each is said once */
      check_damping(reading, &scene->stages[s].damping, normal->elastic);
  }
  if (shear->cohesionless && cohesive_line(scene) > 0)
    say(reading, cohesive_line(scene), "its limit is mu N at every point of the contact",
        "expected no cohesion for `shear %s`", scene->shear);
}
