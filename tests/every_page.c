/* Every page of the short list.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "every_page.h"

#include <CUnit/CUnit.h>
#include <stdlib.h>

static const char *const pages[] = {
#define NB_PAGE(path) path,
#include "pages-register.h"
#undef NB_PAGE
};

/* What a stage waits for may then not come: it ends after its cycles. */
static void shorten(struct nb_scene *scene, double budget) {
  const double each = budget / (double)((scene->body_count + 10) * scene->stage_count);
  const unsigned long most = each > 20 ? (unsigned long)each : 20;
  for (size_t s = 0; s < scene->stage_count && !scene->path; s++) {
    struct nb_stage *stage = &scene->stages[s];
    if (stage->cycles <= most)
      continue;
    stage->cycles = most;
    stage->condition_count = 0;
    stage->record = stage->record > most / 4 ? most / 4 : stage->record;
  }
}

void every_page(void (*look)(struct nb_scene *scene, const char *name), double budget) {
  const char *srcdir = getenv("srcdir");
  for (size_t p = 0; p < sizeof pages / sizeof *pages; p++) {
    char path[4096], name[4200];
    struct nb_mistakes mistakes = {0};
    struct nb_page page = {0};
    snprintf(path, sizeof path, "%s/%s", srcdir ? srcdir : ".", pages[p]);
    nb_page_read(&page, path, &mistakes);
    const size_t runs = nb_scene_runs(&page, NULL, &mistakes);
    for (size_t run = 0; run < runs && !mistakes.count; run += runs > 1 ? runs - 1 : 1) {
      struct nb_scene scene = {0};
      nb_scene_read(&scene, &page, run, NULL, &mistakes);
      snprintf(name, sizeof name, "%s, run %zu", page.name, run + 1);
      if (!mistakes.count) {
        shorten(&scene, budget);
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
