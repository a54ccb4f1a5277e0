/* `relax`: relaxation without time.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "laws/laws_now.h"
#include "statement.h"

enum { AT_ISOTROPIC, AT_ON, AT_THROUGH };

/* clang-format off */
static const struct nb_argument relax_fields[] = {
  CLAUSE("isotropic", "P", NB_UNIT_PRESSURE, NB_POSITIVE, AT_ISOTROPIC, 1, NULL, "Target of xx and yy; that of xy is 0. Compression is positive."),
  {"on", "REGION", NB_ARGUMENT_WORD, NB_UNIT_NUMBER, NB_ANY, AT_ON, 1, NULL, "the name of a region"},
  CHOICE("through", "boundary|cell", AT_THROUGH, NULL, "`boundary` or `cell`"),
  END
};
/* clang-format on */

/* Index of the region; -1 with a message if there is none. */
static int region_named(const struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *name) {
  const int m = NB_NAMED(reader, name, scene->monitors, scene->monitor_count, "the name of a region", NULL);
  if (m >= 0 && scene->monitors[m].kind != NB_MONITOR_REGION)
    nb_token_mistake(reader, name, NULL, "expected the name of a region, found `%s`", name->text);
  return m < 0 ? -1 : scene->monitors[m].a;
}

NB_APPLY(apply_relax) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  struct nb_stage *stage = nb_current_stage(scene);
  const struct nb_value *value = record->value;
  const int region = region_named(scene, reader, value[AT_ON].token);
  if (nb_stage_ends_twice(stage, reader) || !nb_take_word(reader, "at") || !nb_take_word(reader, "most") ||
      !nb_take_count_of(reader, "cycle", &stage->cycles))
    return;
  (value[AT_THROUGH].number > 0 ? nb_lacks_cell : nb_lacks_boundary)(scene, reader);
  if (!reader->bad)
    stage->relax = (struct nb_relax){region, value[AT_ISOTROPIC].number, (int)reader->line};
}

/* The line of a statement that a stage with `relax` cannot have; 0: none. */
static int line_of_other(const struct nb_stage *stage) {
  const int lines[] = {stage->servo.line,
                       stage->boundary.line,
                       stage->affine.line,
                       stage->cell_line,
                       stage->box_line,
                       stage->motion_count ? stage->motions[0].line : 0,
                       stage->change_count ? stage->changes[0].line : 0,
                       stage->gravity.line,
                       stage->laws.normal_line,
                       stage->laws.shear_line,
                       stage->reverse_velocities ? stage->line : 0};
  int line = 0;
  for (size_t k = 0; k < sizeof lines / sizeof *lines && !line; k++)
    line = lines[k];
  return line;
}

static bool has_friction(const struct nb_scene *scene, const struct nb_properties *now) {
  for (int a = 0; a < (int)scene->material_count; a++)
    for (int b = 0; b <= a; b++) {
      const struct nb_pair pair = nb_properties_pair(now, a, b);
      if (pair.friction > 0 || pair.cohesion > 0)
        return true;
    }
  return false;
}

/* What acts in the stage that does not follow from the positions; NULL: nothing. */
static const char *objection(const struct nb_scene *scene, const struct nb_properties *properties,
                             const struct nb_active_laws *laws, const struct nb_gravity *gravity) {
  if (scene->wall_count > 0)
    return "walls";
  if (gravity->x != 0 || gravity->y != 0 || gravity->central != 0)
    return "gravity";
  if (laws->normal && laws->normal->incremental)
    return "a normal law by increments";
  return laws->shear && strcmp(laws->shear->name, "none") != 0 && has_friction(scene, properties)
             ? "friction or cohesion"
             : NULL;
}

/* The stage also imposes that boundary and particles, or the cell, have no strain rate, and so do the next ones. */
static void check_stage(struct nb_scene_reading *reading, struct nb_stage *stage, const char *objection) {
  struct nb_reader *reader = &reading->reader;
  const int other = line_of_other(stage);
  if (other)
    nb_line_mistake(reader, (size_t)other, "give it a stage of its own",
                    "expected no other loading in the stage `%s`, which has `relax`", stage->name);
  else if (objection)
    nb_line_mistake(reader, (size_t)stage->relax.line,
                    "a relaxation has no time, so its forces must follow from the positions of the particles alone",
                    "expected a stage without %s for `relax`", objection);
  else if (reading->scene->cell.line)
    stage->cell_line = stage->relax.line;
  else
    stage->boundary.line = stage->affine.line = stage->relax.line;
}

void nb_relax_check(struct nb_scene_reading *reading) {
  struct nb_scene *scene = reading->scene;
  struct nb_properties properties;
  struct nb_active_laws laws = nb_laws_initial(scene);
  struct nb_gravity gravity = scene->gravity;
  if (!nb_properties_create(&properties, scene)) {
    nb_mistake_memory(reading->reader.mistakes);
    return;
  }
  for (size_t s = 0; s < scene->stage_count; s++) {
    struct nb_stage *stage = &scene->stages[s];
    laws = nb_laws_of(stage, laws);
    gravity = stage->gravity.line ? stage->gravity : gravity;
    for (size_t k = 0; k < stage->change_count; k++)
      nb_properties_change(&properties, &stage->changes[k], nb_properties_before(&properties, &stage->changes[k]), 1);
    if (stage->relax.line)
      check_stage(reading, stage, objection(scene, &properties, &laws, &gravity));
  }
  nb_properties_free(&properties);
}

/* clang-format off */
NB_STATEMENTS(relax) = {
  {"relax", NB_IN_STAGE, relax_fields, "at most N cycles", 0, false, apply_relax,
   "Moves the particles to equilibrium under an isotropic stress, without time, and ends the stage there. Each cycle is one force calculation; the method is FIRE, with equal masses and the strain of the boundary or the cell as further variables. "
   "The particles have no velocities, so dashpots do not act. The stage ends when all components of the region's stress are within 1e-4 of the target and `REGION.unbalanced.mean` is below 1e-5; if that takes more than N cycles, the run is aborted. "
   "Not with friction, cohesion, gravity, walls or a normal law by increments, and nothing else acts in the stage.",
   "stage     rest\n  relax   isotropic 100 kPa  on A  through boundary  at most 200000 cycles"},
  {0},
};
/* clang-format on */
