/* Tests the reader with random pages. For any bytes it must return either a scene or errors, and the same for a second
 * reading.
 *
 *   tests/fuzz/read [PAGE ...]   reads these pages, and random changes of them, a few thousand times; TAP
 *   make fuzz                    the same with libFuzzer (clang), for FUZZ_SECONDS, which searches for new paths
 *
 * Without pages: tests/fuzz/corpus, tests/bad and cases below $srcdir. An input that violates an invariant is written
 * to fuzz-broken.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "fuzz.h"

#include <dirent.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../src/input/reader.h"
#include "../../src/report/expect.h"

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

/* Reads one run of the page twice, with its expectations. */
static void read_run(const struct nb_page *page, size_t run, nb_settings settings, bool wrong) {
  struct nb_scene scene, again;
  struct nb_mistakes mistakes = {0}, same = {0};
  const enum nb_status status = nb_scene_read(&scene, page, run, settings, &mistakes);
  fuzz_hold_mistakes(&mistakes, status);
  fuzz_hold(!wrong || status != NB_OK, "a page with errors in its runs is invalid");
  fuzz_hold(nb_scene_read(&again, page, run, settings, &same) == status, "a second reading has the same status");
  fuzz_hold(mistakes.count == same.count && (!mistakes.text || strcmp(mistakes.text, same.text) == 0),
            "a second reading has the same errors");
  if (status == NB_OK)
    hold_scene(&scene);
  hold_same(&scene, &again);
  struct nb_expectations expectations;
  const enum nb_status expected = nb_expectations_read(&expectations, page, &scene, &mistakes);
  fuzz_hold_mistakes(&mistakes, status ? status : expected);
  fuzz_hold(expected == NB_OK || (!expectations.list && !expectations.count), "no expectations with errors");
  nb_expectations_free(&expectations);
  nb_mistakes_free(&mistakes), nb_mistakes_free(&same);
  nb_scene_free(&scene), nb_scene_free(&again);
}

/* The first run of the page and the last one. */
static void read_runs(const struct nb_page *page, nb_settings settings) {
  struct nb_mistakes mistakes = {0};
  const size_t runs = nb_scene_runs(page, settings, &mistakes);
  fuzz_hold_mistakes(&mistakes, mistakes.count ? NB_BAD_USE : NB_OK);
  fuzz_hold(runs > 0 && runs <= NB_RUNS_MAX, "the number of runs is within the limit");
  read_run(page, 0, settings, mistakes.count > 0);
  if (runs > 1)
    read_run(page, runs - 1, settings, false);
  nb_mistakes_free(&mistakes);
}

/* The same with `--set`: a law, a step or an invalid setting, and a name of the page. */
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
  read_runs(page, texts);
  if (texts[1])
    read_runs(page, texts + 1);
}

void fuzz_read(const unsigned char *bytes, size_t size) {
  struct nb_page page;
  struct nb_mistakes mistakes = {0};
  fuzz_begin(bytes, size);
  const enum nb_status status = nb_page_read_bytes(&page, "fuzz.md", (const char *)bytes, size, &mistakes);
  fuzz_hold_mistakes(&mistakes, status);
  fuzz_hold(status == NB_OK || (!page.lines && !page.kind_of), "no page with errors");
  if (status == NB_OK) {
    read_runs(&page, NULL);
    read_set(&page, size);
  }
  nb_mistakes_free(&mistakes);
  nb_page_free(&page);
}

#ifdef NB_LIBFUZZER

int LLVMFuzzerTestOneInput(const unsigned char *bytes, size_t size);
size_t LLVMFuzzerCustomMutator(unsigned char *bytes, size_t size, size_t most, unsigned seed);
size_t LLVMFuzzerMutate(unsigned char *bytes, size_t size, size_t most);

int LLVMFuzzerTestOneInput(const unsigned char *bytes, size_t size) {
  fuzz_read(bytes, size);
  return 0;
}

/* Half of the changes are of words, half are libFuzzer's own changes of bytes. */
size_t LLVMFuzzerCustomMutator(unsigned char *bytes, size_t size, size_t most, unsigned seed) {
  unsigned long long chance = seed * 2654435761ULL + 1;
  return seed % 2 ? fuzz_change(bytes, size, most, &chance) : LLVMFuzzerMutate(bytes, size, most);
}

#else

/* ---- the driver ---- */

enum { PAGES_MAX = 1000, LONGEST = 64 << 10, CHANGED = 3000, CHANGES_MAX = 6 };

struct corpus {
  unsigned char *bytes[PAGES_MAX];
  size_t size[PAGES_MAX], count;
};

static void take_file(struct corpus *corpus, const char *path) {
  FILE *file = fopen(path, "rb");
  unsigned char *bytes = malloc(LONGEST);
  if (!file || !bytes || corpus->count == PAGES_MAX) {
    printf("not ok 1 - %s can be read\n1..1\n", path);
    exit(1);
  }
  corpus->size[corpus->count] = fread(bytes, 1, LONGEST, file);
  corpus->bytes[corpus->count++] = bytes;
  fclose(file);
}

static int by_name(const void *a, const void *b) { return strcmp(a, b); }

/* Takes the files of a folder and its folders, sorted by name, so the random changes are the same on every machine. */
static void take_folder(struct corpus *corpus, const char *top, const char *folder) {
  char path[4096], names[PAGES_MAX][256];
  const bool corpora = strcmp(folder, "tests/fuzz/corpus") == 0; /* names without an extension */
  size_t count = 0;
  snprintf(path, sizeof path, "%s/%s", top, folder);
  DIR *directory = opendir(path);
  for (struct dirent *entry; directory && count < PAGES_MAX && (entry = readdir(directory));)
    if (entry->d_name[0] != '.' && (corpora || strstr(entry->d_name, ".md") || !strchr(entry->d_name, '.')))
      snprintf(names[count++], sizeof *names, "%s", entry->d_name);
  if (directory)
    closedir(directory);
  qsort(names, count, sizeof *names, by_name);
  for (size_t k = 0; k < count; k++) {
    if (!corpora && !strchr(names[k], '.')) {
      snprintf(path, sizeof path, "%s/%.255s", folder, names[k]);
      take_folder(corpus, top, path);
    } else if (snprintf(path, sizeof path, "%s/%s/%.255s", top, folder, names[k]) < (int)sizeof path) {
      take_file(corpus, path);
    }
  }
}

int main(int count, char **paths) {
  static struct corpus corpus;
  static unsigned char page[LONGEST];
  const char *top = getenv("srcdir");
  for (int k = 1; k < count; k++)
    take_file(&corpus, paths[k]);
  if (count == 1) {
    take_folder(&corpus, top ? top : ".", "tests/fuzz/corpus");
    take_folder(&corpus, top ? top : ".", "tests/bad");
    take_folder(&corpus, top ? top : ".", "cases");
  }
  for (size_t k = 0; k < corpus.count; k++)
    fuzz_read(corpus.bytes[k], corpus.size[k]);
  printf("%s 1 - %zu pages\n", corpus.count ? "ok" : "not ok", corpus.count);

  unsigned long long chance = 1;
  for (int n = 0; n < CHANGED && corpus.count; n++) {
    const size_t from = (size_t)(fuzz_chance(&chance) % corpus.count);
    size_t size = corpus.size[from];
    memcpy(page, corpus.bytes[from], size);
    for (unsigned long long more = 1 + fuzz_chance(&chance) % CHANGES_MAX; more > 0; more--)
      size = fuzz_change(page, size, sizeof page, &chance);
    fuzz_read(page, size);
  }
  printf("ok 2 - %d changed pages\n1..2\n", CHANGED);
  for (size_t k = 0; k < corpus.count; k++)
    free(corpus.bytes[k]);
  return corpus.count == 0;
}

#endif
