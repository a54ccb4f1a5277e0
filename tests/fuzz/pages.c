/* The reader of pages. For any bytes it must return either a scene or errors, and a second reading must return the
 * same.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "fuzz.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../../src/input/reader.h"
#include "../../src/report/outcome.h"

static bool finite_all(const double *values, size_t count) {
  for (size_t k = 0; k < count; k++)
    if (!isfinite(values[k]))
      return false;
  return true;
}

static void hold_scene(const struct nb_scene *scene) {
  fuzz_hold(scene->particle_count > 0 && scene->stage_count > 0, "there are particles and stages");
  for (size_t k = 0; k < scene->particle_count; k++) {
    const struct nb_particle *particle = &scene->particles[k];
    const double numbers[] = {particle->x, particle->y, particle->radius, particle->vx, particle->vy, particle->spin};
    fuzz_hold(finite_all(numbers, 6) && particle->radius > 0, "a particle has a finite position and a size");
    fuzz_hold(particle->material >= 0 && (size_t)particle->material < scene->material_count,
              "a particle has a material");
  }
  for (size_t k = 0; k < scene->wall_count; k++) {
    const struct nb_wall *wall = &scene->walls[k];
    const double numbers[] = {wall->x, wall->y, wall->ex, wall->ey, wall->h1, wall->h2, wall->vx, wall->vy};
    fuzz_hold(finite_all(numbers, 8) && fabs(hypot(wall->ex, wall->ey) - 1) < 1e-12, "a wall has a direction");
    fuzz_hold(wall->material >= 0 && (size_t)wall->material < scene->material_count, "a wall has a material");
  }
  for (size_t k = 0; k < scene->monitor_count; k++) {
    const struct nb_monitor *monitor = &scene->monitors[k];
    const size_t first = monitor->kind == NB_MONITOR_WALL ? scene->wall_count : scene->particle_count;
    const size_t second = monitor->kind == NB_MONITOR_PARTICLE_WALL ? scene->wall_count : scene->particle_count;
    fuzz_hold(monitor->a >= 0 && (size_t)monitor->a < first, "the object of a monitor exists");
    fuzz_hold(monitor->b < 0 || (size_t)monitor->b < second, "the second object of a monitor exists");
  }
  for (size_t k = 0; k < scene->column_count; k++)
    fuzz_hold(scene->columns[k].quantity.kind && nb_quantity_unit(scene->columns[k].quantity),
              "a column is a quantity");
  for (size_t k = 0; k < scene->stage_count; k++)
    fuzz_hold(scene->stages[k].cycles > 0, "a stage ends");
}

static void hold_same(const struct nb_scene *a, const struct nb_scene *b) {
  fuzz_hold(a->particle_count == b->particle_count && a->wall_count == b->wall_count &&
                a->stage_count == b->stage_count && a->column_count == b->column_count &&
                a->monitor_count == b->monitor_count && a->binding_count == b->binding_count &&
                a->material_count == b->material_count,
            "a second reading has the same counts");
  for (size_t k = 0; k < a->particle_count; k++) {
    const struct nb_particle *one = &a->particles[k], *other = &b->particles[k];
    fuzz_hold(one->x == other->x && one->y == other->y && one->radius == other->radius && one->vx == other->vx &&
                  one->material == other->material && one->line == other->line,
              "a second reading has the same particles");
  }
}

static void read_again(const struct nb_page *page, size_t run, nb_settings settings, const struct nb_scene *scene,
                       const struct nb_mistakes *mistakes, enum nb_status status) {
  struct nb_scene again;
  struct nb_mistakes same = {0};
  fuzz_hold(nb_scene_read(&again, page, run, settings, &same) == status, "a second reading has the same status");
  fuzz_hold(mistakes->count == same.count && (!mistakes->text || strcmp(mistakes->text, same.text) == 0),
            "a second reading has the same errors");
  hold_same(scene, &again);
  nb_mistakes_free(&same), nb_scene_free(&again);
}

/* Reads one run of the page, with its expectations. *runs becomes the number of runs. True if the run is valid. */
static bool read_run(const struct nb_page *page, size_t run, nb_settings settings, size_t *runs) {
  struct nb_scene scene;
  struct nb_mistakes mistakes = {0};
  const enum nb_status status = nb_scene_read(&scene, page, run, settings, &mistakes);
  fuzz_hold_mistakes(&mistakes, status);
  fuzz_hold(scene.runs > 0 && scene.runs <= NB_RUNS_MAX, "the number of runs is within the limit");
  *runs = scene.runs;
  if (fuzz_one_of(16))
    read_again(page, run, settings, &scene, &mistakes, status);
  if (status == NB_OK)
    hold_scene(&scene);
  struct nb_expectations expectations;
  const enum nb_status expected = nb_expectations_read(&expectations, page, &scene, &mistakes);
  fuzz_hold_mistakes(&mistakes, status ? status : expected);
  fuzz_hold(expected == NB_OK || (!expectations.list && !expectations.count), "no expectations with errors");
  nb_expectations_free(&expectations);
  nb_mistakes_free(&mistakes), nb_scene_free(&scene);
  return !status && !expected;
}

/* Reads the first run of the page and the last one. *runs becomes their number. True if the first one is valid. */
static bool read_runs(const struct nb_page *page, nb_settings settings, size_t *runs) {
  const bool valid = read_run(page, 0, settings, runs);
  if (*runs > 1)
    read_run(page, *runs - 1, settings, runs);
  return valid;
}

/* Reads the page with `--set`: with a law, a step or an invalid setting, and with a name of the page. */
static void read_set(const struct nb_page *page, size_t chance) {
  static const char *const values[] = {"0", "-1", "1e300", "1e-300", "nan", "3 mm", "1 2", "", "$a", "a"};
  static const char *const more[] = {
      "normal=hertz", "shear=linear", "shear=mindlin_deresiewicz pieces 4", "step=1e-300 s",
      "normal=",      "shear",        "step=1e9 of single-contact",         "step=1 of",
      "a=$b"};
  char name[NB_NAME_SIZE], own[2 * NB_NAME_SIZE];
  const char *texts[3] = {more[chance % (sizeof more / sizeof *more)]};
  for (size_t k = 0; k < page->line_count && !texts[1]; k++)
    if (sscanf(page->lines[k], "let %63s", name) == 1 || sscanf(page->lines[k], "sweep %63s", name) == 1) {
      snprintf(own, sizeof own, "%s=%s", name, values[chance % (sizeof values / sizeof *values)]);
      texts[1] = own;
    }
  size_t runs;
  read_runs(page, texts, &runs);
  if (texts[1])
    read_runs(page, texts + 1, &runs);
}

/* Reads all runs of a page with few runs as `nineball check` does, with the warnings about its expectations. */
static void read_outcome(const unsigned char *bytes, size_t size, size_t runs) {
  struct nb_outcome outcome = {0};
  if (runs <= 8 && nb_page_read_bytes(&outcome.page, "fuzz.md", (const char *)bytes, size, &outcome.mistakes) == NB_OK)
    nb_outcome_read_runs(&outcome, SIZE_MAX);
  nb_outcome_free(&outcome);
}

static bool read_page(const unsigned char *bytes, size_t size) {
  struct nb_page page;
  struct nb_mistakes mistakes = {0};
  bool valid = false;
  const enum nb_status status = nb_page_read_bytes(&page, "fuzz.md", (const char *)bytes, size, &mistakes);
  fuzz_hold_mistakes(&mistakes, status);
  fuzz_hold(status == NB_OK || (!page.lines && !page.kind_of), "no page with errors");
  if (status == NB_OK) {
    size_t runs;
    valid = read_runs(&page, NULL, &runs);
    if (fuzz_one_of(4))
      read_outcome(bytes, size, runs);
    if (fuzz_one_of(4))
      read_set(&page, size);
  }
  nb_mistakes_free(&mistakes);
  nb_page_free(&page);
  return valid;
}

static size_t no_seed(size_t k, char *text) { /* replay.c takes the pages of the tree */
  (void)k, (void)text;
  return 0;
}

const struct fuzz_reader fuzz_pages = {"pages", 64 << 10, 1000, read_page, no_seed};
