/* Scenes that a test writes in the page language.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "written.h"
#include "../src/measure/snapshot.h"

#include <CUnit/CUnit.h>
#include <fcntl.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../src/core/model.h"

FILE *written_file(char path[]) {
  const int descriptor = mkstemp(path);
  CU_ASSERT_FATAL(descriptor >= 0);
  FILE *file = fdopen(descriptor, "w");
  CU_ASSERT_PTR_NOT_NULL_FATAL(file);
  return file;
}

void written_text(const char *path, const char *text) {
  FILE *file = fopen(path, "w");
  CU_ASSERT_PTR_NOT_NULL_FATAL(file);
  fputs(text, file);
  fclose(file);
}

bool written_is(const char *path, const char *text) {
  char found[64] = "";
  FILE *file = fopen(path, "r");
  CU_ASSERT_PTR_NOT_NULL_FATAL(file);
  found[fread(found, 1, sizeof found - 1, file)] = '\0';
  fclose(file);
  return strcmp(found, text) == 0;
}

int written_open_files(void) {
  int count = 0;
  for (int file = 0; file < 1024; file++)
    count += fcntl(file, F_GETFD) != -1;
  return count;
}

void words_add(struct words *words, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int more = vsnprintf(NULL, 0, format, arguments);
  va_end(arguments);
  words->text = realloc(words->text, words->length + (size_t)more + 1);
  CU_ASSERT_PTR_NOT_NULL_FATAL(words->text);
  va_start(arguments, format);
  vsnprintf(words->text + words->length, (size_t)more + 1, format, arguments);
  va_end(arguments);
  words->length += (size_t)more;
}

void written_scene(struct written *written, struct words *words) { written_scene_set(written, words, NULL); }

void written_scene_set(struct written *written, struct words *words, nb_settings settings) {
  char path[] = "/tmp/nineball-written-XXXXXX";
  struct nb_mistakes mistakes = {0};
  FILE *file = written_file(path);
  /* Contact tests have a kind of block of their own. */
  const bool contact_test = strncmp(words->text, "path\n", 5) == 0;
  fprintf(file, "```%s\n%s\n```\n", contact_test ? "contact-test" : "scene", words->text + (contact_test ? 5 : 0));
  fclose(file);
  free(words->text);
  *words = (struct words){0};
  *written = (struct written){0};
  nb_page_read(&written->page, path, &mistakes);
  nb_scene_read(&written->scene, &written->page, 0, settings, &mistakes);
  unlink(path);
  if (mistakes.text)
    printf("# %s", mistakes.text);
  CU_ASSERT_EQUAL_FATAL(mistakes.count, 0);
  nb_mistakes_free(&mistakes);
}

void written_free(struct written *written) {
  nb_scene_free(&written->scene);
  nb_page_free(&written->page);
}

struct nb_model *written_model(const struct written *written, const struct nb_options *options) {
  struct nb_error error = {0};
  struct nb_model *model = nb_model_create(&written->scene, options, &error);
  if (!model)
    printf("# %s\n", error.text);
  CU_ASSERT_PTR_NOT_NULL_FATAL(model);
  return model;
}

void written_cycles(struct nb_model *model, int count) {
  struct nb_error error = {0};
  for (int k = 0; k < count; k++) {
    if (nb_cycle(model, &error))
      printf("# %s\n", error.text);
    CU_ASSERT_EQUAL_FATAL(error.status, NB_OK);
  }
}

double written_now(const struct nb_model *model, const char *name) {
  const struct nb_scene *scene = model->scene;
  for (size_t c = 0; c < scene->column_count; c++)
    if (strcmp(scene->columns[c].name, name) == 0)
      return nb_quantity_value(scene->columns[c].quantity, model);
  printf("# not recorded: %s\n", name);
  CU_FAIL("a quantity is not recorded");
  return NAN;
}

void written_run(struct nb_result *result, const struct written *written, const struct nb_options *options) {
  struct nb_error error = {0};
  const enum nb_status status = nb_run(result, &written->scene, options, NULL, &error);
  if (status)
    printf("# %s\n", error.text);
  CU_ASSERT_EQUAL_FATAL(status, NB_OK);
}

double written_cell(const struct nb_table *table, size_t row, const char *name) {
  for (size_t c = 0; c < table->column_count && row < table->row_count; c++)
    if (strcmp(table->names[c], name) == 0)
      return table->values[row * table->column_count + c];
  printf("# not recorded: %s in row %zu\n", name, row);
  CU_FAIL("a quantity is not recorded");
  return NAN;
}

double written_last(const struct nb_result *result, const char *name) {
  return written_cell(&result->table, result->table.row_count - 1, name);
}

bool written_same_table(const struct nb_table *a, const struct nb_table *b) {
  const size_t rows = a->row_count, numbers = rows * a->column_count;
  if (rows != b->row_count || a->column_count != b->column_count)
    return false;
  return rows == 0 || ((numbers == 0 || memcmp(a->values, b->values, numbers * sizeof *a->values) == 0) &&
                       memcmp(a->cycle, b->cycle, rows * sizeof *a->cycle) == 0 &&
                       memcmp(a->time, b->time, rows * sizeof *a->time) == 0 &&
                       memcmp(a->stage, b->stage, rows * sizeof *a->stage) == 0);
}

bool written_same_snapshots(const struct nb_result *a, const struct nb_result *b) {
  bool same = a->snapshot_count == b->snapshot_count;
  for (size_t k = 0; same && k < a->snapshot_count; k++) {
    const char *name, *other;
    const struct nb_table *one, *two;
    bool more = true;
    same = a->snapshots[k].stage == b->snapshots[k].stage;
    for (int part = 0; same && more; part++) {
      more = nb_snapshot_part(&a->snapshots[k], part, &name, &one);
      same = nb_snapshot_part(&b->snapshots[k], part, &other, &two) == more && (!more || written_same_table(one, two));
    }
  }
  return same;
}
