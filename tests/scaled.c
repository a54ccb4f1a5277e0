/* Every page is run again with lengths, masses and times scaled by 2^l, 2^m and 2^t. Powers of two change no digit of a
 * product, a sum or a quotient. They change no digit of a square root or a cube root either, because the exponents are
 * multiples of 6. So every result must scale with its unit, to the bit.
 *
 * The second run also stores particles in another order and uses no vector instructions, which changes no bit either.
 *
 * A disc is 1 m thick at any scale: its density scales like a mass per area, and its stress like a force per length.
 * Only masses and times are scaled in a scene with discs that also has a Young's modulus or spheres, and in a scene
 * that needs the duration of an impact, which contains a fifth root.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/core/names.h"
#include "../src/input/units.h"
#include "../src/measure/snapshot.h"
#include "every_page.h"
#include "suites.h"

/* The unit of a quantity as powers of length, mass and time. In a scene with discs `thick` is added to the power of
 * length, because the thickness, 1 m at any scale, takes the place of a length. */
struct power {
  int l, m, t, thick;
};
static const struct power of_kind[NB_UNIT_KINDS] = {
    [NB_UNIT_NUMBER] = {0, 0, 0, 0},    [NB_UNIT_LENGTH] = {1, 0, 0, 0},     [NB_UNIT_TIME] = {0, 0, 1, 0},
    [NB_UNIT_VELOCITY] = {1, 0, -1, 0}, [NB_UNIT_STIFFNESS] = {0, 1, -2, 0}, [NB_UNIT_DENSITY] = {-3, 1, 0, 1},
    [NB_UNIT_FORCE] = {1, 1, -2, 0},    [NB_UNIT_RATE] = {0, 0, -1, 0},      [NB_UNIT_STRAIN_RATE] = {0, 0, -1, 0},
    [NB_UNIT_SPIN] = {0, 0, -1, 0},     [NB_UNIT_ANGLE] = {0, 0, 0, 0},      [NB_UNIT_ENERGY] = {2, 1, -2, 0},
    [NB_UNIT_MOMENT] = {2, 1, -2, 0},   [NB_UNIT_PRESSURE] = {-1, 1, -2, 1}, [NB_UNIT_ACCELERATION] = {1, 0, -2, 0},
};
/* Units that only tables have. */
static const struct {
  const char *unit;
  struct power power;
} of_tables[] = {{"m2", {2, 0, 0, 0}}, {"kg.m/s", {1, 1, -1, 0}}, {"kg.m2/s", {2, 1, -1, 0}}, {"1/m2", {-2, 0, 0, 1}}};

static struct {
  int l, m, t;
  bool discs;
} by; /* exponents of the factors 2^l, 2^m, 2^t of the present scene; whether the scene has discs */

static double times(double value, struct power p) {
  return ldexp(value, by.l * (p.l + (by.discs ? p.thick : 0)) + by.m * p.m + by.t * p.t);
}

static double as(double value, enum nb_unit_kind kind) { return times(value, of_kind[kind]); }

static double in_unit(double value, const char *unit) {
  enum nb_unit_kind kind;
  for (size_t k = 0; k < sizeof of_tables / sizeof *of_tables; k++)
    if (strcmp(unit, of_tables[k].unit) == 0)
      return times(value, of_tables[k].power);
  if (!nb_unit_kind_of(&kind, unit)) {
    printf("# a unit without a power: %s\n", unit);
    CU_FAIL("a unit of a table is not known");
    return value;
  }
  return as(value, kind);
}

#define SCALE(kind, value) ((value) = as(value, NB_UNIT_##kind))
#define SCALE_ROW(name, shown, kind, ...) SCALE(kind, of->name);

static void scale_matter(struct nb_scene *scene) {
  for (size_t k = 0; k < scene->material_count; k++) {
    struct nb_material *of = &scene->materials[k];
    NB_PAIR_ROWS(SCALE_ROW)
    SCALE(DENSITY, of->density), SCALE(PRESSURE, of->young);
  }
  for (size_t k = 0; k < scene->pair_rule_count; k++) {
    struct nb_pair_rule *of = &scene->pair_rules[k];
    NB_PAIR_ROWS(SCALE_ROW)
  }
}

static void scale_gravity(struct nb_gravity *gravity) {
  SCALE(ACCELERATION, gravity->x), SCALE(ACCELERATION, gravity->y), SCALE(ACCELERATION, gravity->central);
  SCALE(LENGTH, gravity->about_x), SCALE(LENGTH, gravity->about_y);
}

static void scale_damping(struct nb_damping *damping) {
  if (damping->contact_kind == NB_CONTACT_STIFFNESS)
    SCALE(TIME, damping->contact);
  if (damping->walls_kind == NB_CONTACT_STIFFNESS)
    SCALE(TIME, damping->walls);
  if (damping->global_kind == NB_GLOBAL_MASS)
    SCALE(RATE, damping->global);
}

static void scale_circle(struct nb_circle *circle) {
  SCALE(LENGTH, circle->x), SCALE(LENGTH, circle->y), SCALE(LENGTH, circle->radius);
}

static void scale_step(struct nb_step *step) {
  if (step->kind == NB_STEP_TIME)
    SCALE(TIME, step->value);
}

static void scale_places(struct nb_scene *scene) {
  for (size_t k = 0; k < scene->particle_count; k++) {
    struct nb_particle *of = &scene->particles[k];
    SCALE(LENGTH, of->x), SCALE(LENGTH, of->y), SCALE(LENGTH, of->radius);
    SCALE(VELOCITY, of->vx), SCALE(VELOCITY, of->vy), SCALE(SPIN, of->spin);
  }
  for (size_t k = 0; k < scene->wall_count; k++) {
    struct nb_wall *of = &scene->walls[k];
    SCALE(LENGTH, of->x), SCALE(LENGTH, of->y), SCALE(LENGTH, of->h1), SCALE(LENGTH, of->h2), SCALE(LENGTH, of->h0);
    SCALE(VELOCITY, of->vx), SCALE(VELOCITY, of->vy), SCALE(SPIN, of->spin);
  }
  for (size_t k = 0; k < scene->region_count; k++) {
    struct nb_region *of = &scene->regions[k];
    SCALE(LENGTH, of->x), SCALE(LENGTH, of->y), SCALE(LENGTH, of->half_x), SCALE(LENGTH, of->half_y);
    if (of->kind != NB_REGION_INSIDE)
      SCALE(LENGTH, of->radius);
  }
  for (size_t k = 0; k < scene->grading_count; k++)
    for (size_t s = 0; s < scene->gradings[k].size_count; s++)
      SCALE(LENGTH, scene->gradings[k].sizes[s].radius);
  for (int k = 0; k < 4; k++)
    SCALE(LENGTH, scene->cell.h[k]);
  SCALE(LENGTH, scene->cell.x), SCALE(LENGTH, scene->cell.y);
  SCALE(LENGTH, scene->origin_x), SCALE(LENGTH, scene->origin_y), SCALE(LENGTH, scene->skin);
  SCALE(VELOCITY, scene->impact.speed);
}

static void scale_strain(struct nb_strain_rate *strain) {
  if (!strain->per_cycle)
    SCALE(RATE, strain->xx), SCALE(RATE, strain->xy), SCALE(RATE, strain->yx), SCALE(RATE, strain->yy);
}

static void scale_segment(struct nb_segment *segment) {
  struct nb_target *const aims[] = {&segment->normal, &segment->shear};
  for (int k = 0; k < 2; k++)
    aims[k]->value = as(aims[k]->value, aims[k]->force ? NB_UNIT_FORCE : NB_UNIT_LENGTH);
  for (size_t k = 0; k < segment->point_count; k++)
    SCALE(LENGTH, segment->points[k].approach), SCALE(LENGTH, segment->points[k].slip);
}

static void scale_servo(struct nb_servo *servo) {
  for (int k = 0; k < 3; k++)
    SCALE(PRESSURE, servo->stress[k]);
  if (!servo->per_cycle)
    SCALE(RATE, servo->max_rate);
}

static void scale_stage(struct nb_stage *stage) {
  for (size_t k = 0; k < stage->motion_count; k++) {
    struct nb_wall_motion *of = &stage->motions[k];
    SCALE(VELOCITY, of->vx), SCALE(VELOCITY, of->vy), SCALE(SPIN, of->spin);
  }
  for (size_t k = 0; k < stage->change_count; k++) {
    struct nb_change *of = &stage->changes[k];
    NB_PAIR_ROWS(SCALE_ROW)
  }
  for (size_t k = 0; k < stage->condition_count; k++)
    stage->conditions[k].value = in_unit(stage->conditions[k].value, nb_quantity_unit(stage->conditions[k].quantity));
  SCALE(PRESSURE, stage->boundary.sxx), SCALE(PRESSURE, stage->boundary.syy), SCALE(PRESSURE, stage->boundary.sxy);
  scale_strain(&stage->boundary.strain), scale_strain(&stage->affine.strain);
  scale_strain(&stage->cell), scale_strain(&stage->box);
  scale_servo(&stage->servo), scale_circle(&stage->circle), scale_gravity(&stage->gravity);
  scale_step(&stage->step), scale_damping(&stage->damping), scale_segment(&stage->segment);
}

/* True if the scene needs the duration of an impact, in which a power 0.4 does not scale exactly. */
static bool requests_duration(const struct nb_scene *scene) {
  bool asks = scene->impact.line || scene->step.kind == NB_STEP_COLLISION;
  for (size_t s = 0; s < scene->stage_count; s++)
    asks = asks || scene->stages[s].step.kind == NB_STEP_COLLISION;
  return asks;
}

static void choose(const struct nb_scene *scene) {
  bool young = false, spheres = false;
  by.discs = false;
  for (size_t k = 0; k < scene->particle_count; k++) {
    spheres = spheres || scene->particles[k].shape == NB_SPHERE;
    by.discs = by.discs || scene->particles[k].shape == NB_DISC;
  }
  for (size_t k = 0; k < scene->material_count; k++)
    young = young || scene->materials[k].young > 0;
  by.l = (by.discs && (young || spheres)) || requests_duration(scene) ? 0 : 6, by.m = -12, by.t = 18;
}

static void scale(struct nb_scene *scene) {
  choose(scene);
  scale_matter(scene), scale_places(scene);
  scale_gravity(&scene->gravity), scale_damping(&scene->damping), scale_circle(&scene->circle),
      scale_step(&scene->step);
  for (size_t s = 0; s < scene->stage_count; s++)
    scale_stage(&scene->stages[s]);
}

/* False, with a message, if a number does not scale with its unit. `name`: of the page; `what`: of the table. */
static bool scales(const struct nb_table *small, const struct nb_table *large, const char *name, const char *what) {
  if (small->row_count != large->row_count || small->column_count != large->column_count) {
    printf("# %s, %s: another number of rows\n", name, what);
    return false;
  }
  for (size_t n = 0; n < small->row_count * small->column_count; n++) {
    const size_t c = n % small->column_count;
    const double wanted = in_unit(small->values[n], small->units[c]), found = large->values[n];
    if (wanted == found || (isnan(wanted) && isnan(found)))
      continue;
    printf("# %s, %s: %s in row %zu, %.17g %s, becomes %.17g instead of %.17g\n", name, what, small->names[c],
           n / small->column_count, small->values[n], small->units[c], found, wanted);
    return false;
  }
  return true;
}

static bool snapshots_scale(const struct nb_snapshot *small, const struct nb_snapshot *large, const char *name) {
  const struct nb_table *a, *b;
  const char *what;
  bool held = true;
  for (int part = 0; nb_snapshot_part(small, part, &what, &a); part++)
    held = nb_snapshot_part(large, part, &what, &b) && scales(a, b, name, what) && held;
  return held;
}

static bool met[1024]; /* met[k]: some page records the quantity of row k */

static void note_quantities(const struct nb_scene *scene) {
  struct nb_quantity_row row;
  for (size_t k = 0; k < sizeof met && nb_quantity_row(&row, k); k++)
    for (size_t c = 0; c < scene->column_count && !met[k]; c++) {
      const char *name = scene->columns[c].name;
      const size_t length = strlen(name), ends = strlen(row.name);
      met[k] = length >= ends && strcmp(name + length - ends, row.name) == 0 &&
               (length == ends || name[length - ends - 1] == '.');
    }
}

/* True if every recorded value is within the bounds that its quantity states. Prints the columns that are not. */
static bool within_bounds(const struct nb_scene *scene, const struct nb_table *table, const char *name) {
  size_t outside = 0;
  for (size_t c = 0; c < table->column_count; c++) {
    const unsigned bounds = nb_quantity_bounds(scene->columns[c].quantity);
    const bool from_0 = bounds & (NB_AT_LEAST_0 | NB_AT_LEAST_0_BY_LAW), up_to_1 = bounds & NB_AT_MOST_1;
    for (size_t r = 0; r < table->row_count; r++) {
      const double value = table->values[r * table->column_count + c];
      if (!((from_0 && value < 0) || (up_to_1 && value > 1)))
        continue;
      printf("# %s: %s is %g at cycle %.0f\n", name, scene->columns[c].name, value, table->cycle[r]);
      outside++;
      break;
    }
  }
  return outside == 0;
}

static void same_in_other_units(struct nb_scene *scene, const char *name) {
  struct nb_result small, large;
  struct nb_error error = {NB_OK, ""};
  if (scene->start.stages > 0) /* a saved state is not scaled */
    return;
  const struct nb_options as_ever = {.threads = 1}, otherwise = {.threads = 1, .shuffle = true, .isa = "plain"};
  note_quantities(scene);
  scene->unitless = false; /* so that tables have units */
  const enum nb_status first = nb_run(&small, scene, &as_ever, NULL, &error);
  CU_ASSERT(within_bounds(scene, &small.table, name));
  scale(scene);
  const enum nb_status second = nb_run(&large, scene, &otherwise, NULL, &error);
  if (first || second)
    printf("# %s: %d and %d: %s\n", name, first, second, error.text);
  CU_ASSERT_EQUAL(first, second);
  CU_ASSERT(scales(&small.table, &large.table, name, "table"));
  CU_ASSERT_EQUAL(small.snapshot_count, large.snapshot_count);
  for (size_t k = 0; k < small.snapshot_count && k < large.snapshot_count; k++)
    CU_ASSERT(snapshots_scale(&small.snapshots[k], &large.snapshots[k], name));
  nb_result_free(&small), nb_result_free(&large);
}

static void every_page_in_other_units(void) {
  struct nb_quantity_row row;
  every_page(same_in_other_units, 6e4);
  for (size_t k = 0; nb_quantity_row(&row, k); k++) {
    CU_ASSERT_FATAL(k < sizeof met);
    if (!met[k])
      printf("# no page records the quantity %s\n", row.name);
    CU_ASSERT(met[k]);
  }
}

void suite_scaled(void) {
  CU_pSuite suite = CU_add_suite("scaled", NULL, NULL);
  CU_add_test(suite, "every page in other units", every_page_in_other_units);
}
