/* A program that uses the library: it runs a page and prints the last row of its table, one column per line.
 *
 *   cc -std=c11 example.c $(pkg-config --cflags --libs nineball) -o example
 *   ./example two-wall-compression.md ks=0        settings, as for --set, follow the page
 *
 * nineball.h describes each function and the owner of its results. `make installcheck` compiles this file and runs it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <nineball.h>

static void print_last_row(const struct nb_table *table) {
  for (size_t column = 0; column < table->column_count && table->row_count > 0; column++)
    printf("%s %.17g %s\n", table->names[column], table->values[(table->row_count - 1) * table->column_count + column],
           table->units[column]);
}

static enum nb_status run(const struct nb_scene *scene) {
  struct nb_result result = {.cycles = 0};
  struct nb_error error;
  const enum nb_status status = nb_run(&result, scene, NULL, NULL, &error);
  print_last_row(&result.table); /* also of an aborted run */
  if (status)
    fprintf(stderr, "%s\n", error.text);
  nb_result_free(&result);
  return status;
}

int main(int count, char **words) {
  struct nb_mistakes mistakes = {NULL};
  struct nb_page page;
  struct nb_scene scene;
  if (count < 2)
    return fprintf(stderr, "usage: example PAGE NAME=VALUE ...\n"), NB_BAD_USE;
  enum nb_status status = nb_page_read(&page, words[1], &mistakes);
  if (!status) {
    status = nb_scene_read(&scene, &page, 0, (nb_settings)(words + 2), &mistakes); /* run 0: the first one of a sweep */
    if (!status)
      status = run(&scene);
    nb_scene_free(&scene);
    nb_page_free(&page);
  }
  if (mistakes.text)
    fputs(mistakes.text, stderr);
  nb_mistakes_free(&mistakes);
  return (int)status;
}
