/* Every page of PAGES in build-aux/lists.mk.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "every_page.h"
#include "../src/core/names.h"

#include <CUnit/CUnit.h>
#include <stdlib.h>
#include <string.h>

static const char *const pages[] = {
#define NB_PAGE(path) path,
#include "pages-register.h"
#undef NB_PAGE
};

/* Shortens the stages. A shortened stage may never meet its `until` conditions, so it ends after its cycles. */
static void shorten(struct nb_scene *scene, double budget) {
  const double each = budget / (double)((scene->particle_count + 10) * scene->stage_count);
  const unsigned long most = each > 20 ? (unsigned long)each : 20;
  for (size_t s = 0; s < scene->stage_count && !scene->contact_test; s++) {
    struct nb_stage *stage = &scene->stages[s];
    if (stage->cycles > most)
      stage->cycles = most, stage->condition_count = 0;
    stage->record_interval = stage->cycles / 20 + 1;
  }
}

/* Adds a column. In a contact test some columns need fields that not all laws have, so only columns that need no other
 * fields than those of the page are added. */
static void add_column(struct nb_scene *scene, const char *name, size_t room, unsigned allowed) {
  struct nb_column *column = &scene->columns[scene->column_count];
  if (scene->column_count >= room || !nb_quantity_find(&column->quantity, scene, name) ||
      (scene->contact_test && column->quantity.kind->fields & ~allowed))
    return;
  snprintf(column->name, sizeof column->name, "%.120s", name);
  scene->column_count++;
}

/* Adds all quantities as columns; `energies` is false if a law has no stored energy. */
static void record_everything(struct nb_scene *scene, bool energies) {
  enum { ROOM = 20000 };
  struct nb_quantity_row row;
  unsigned allowed = 0;
  char name[3 * NB_NAME_SIZE];
  for (size_t c = 0; c < scene->column_count; c++)
    allowed |= scene->columns[c].quantity.kind->fields;
  free(scene->columns);
  scene->columns = calloc(ROOM, sizeof *scene->columns);
  scene->column_count = 0;
  CU_ASSERT_PTR_NOT_NULL_FATAL(scene->columns);
  for (size_t k = 0; nb_quantity_row(&row, k); k++) {
    if (!energies && strncmp(row.name, "energy.", 7) == 0)
      continue;
    add_column(scene, row.name, ROOM, allowed);
    for (size_t w = 0; w < scene->monitor_count; w++) {
      snprintf(name, sizeof name, "%s.%s", scene->monitors[w].name, row.name);
      add_column(scene, name, ROOM, allowed);
    }
  }
}

static bool can_run(const struct nb_scene *scene) {
  struct nb_error error;
  struct nb_model *model = nb_model_create(scene, &(struct nb_options){.threads = 1}, &error);
  nb_model_free(model);
  return model != NULL;
}

void every_page(void (*look)(struct nb_scene *scene, const char *name), double budget) {
  for (size_t p = 0; p < sizeof pages / sizeof *pages; p++) {
    char path[4096], name[4200];
    struct nb_mistakes mistakes = {0};
    struct nb_page page = {0};
    snprintf(path, sizeof path, "%s/%s", NB_SRCDIR, pages[p]);
    CU_ASSERT_EQUAL_FATAL(nb_page_read(&page, path, &mistakes), NB_OK);
    for (size_t run = 0, runs = 1; run < runs && !mistakes.count; run += runs > 1 ? runs - 1 : 1) {
      struct nb_scene scene = {0};
      nb_scene_read(&scene, &page, run, NULL, &mistakes);
      runs = scene.runs;
      snprintf(name, sizeof name, "%s, run %zu", page.name, run + 1);
      if (!mistakes.count) {
        shorten(&scene, budget);
        record_everything(&scene, true);
        if (!scene.contact_test && !can_run(&scene))
          record_everything(&scene, false);
        look(&scene, name);
      }
      nb_scene_free(&scene);
    }
    if (mistakes.count)
      printf("# %s: %s", path, mistakes.text);
    CU_ASSERT_EQUAL_FATAL(mistakes.count, 0);
    nb_mistakes_free(&mistakes), nb_page_free(&page);
  }
}
