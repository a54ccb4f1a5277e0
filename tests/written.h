/* Scenes that a test writes in the page language, and their results.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stdio.h>

#include "../src/nineball.h"

struct written {
  struct nb_page page;
  struct nb_scene scene;
};

/* A page is built statement by statement. words_add allocates the text, and written_scene frees it. */
struct words {
  char *text;
  size_t length;
};
void words_add(struct words *words, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Reads the only run of the page with these statements, or of the contact test if the first line is `path`. The test
 * ends if the statements have an error. Free the scene with written_free. */
void written_scene(struct written *written, struct words *words);
/* Does the same with settings, as given by --set. */
void written_scene_set(struct written *written, struct words *words, nb_settings settings);
void written_free(struct written *written);

/* The model of the scene at time 0; the test ends if it cannot be made. Free it with nb_model_free. */
struct nb_model *written_model(const struct written *written, const struct nb_options *options);
void written_cycles(struct nb_model *model, int count);
/* The current value of a quantity that the page records. */
double written_now(const struct nb_model *model, const char *name);

/* Runs all stages; the test ends if the run is aborted. Free the result with nb_result_free. */
void written_run(struct nb_result *result, const struct written *written, const struct nb_options *options);
/* Column `name` of the given row, and of the last row; the test fails if there is no such row or column. */
double written_cell(const struct nb_table *table, size_t row, const char *name);
double written_last(const struct nb_result *result, const char *name);

/* Creates a temporary file for writing; the test ends if this fails. `path` is the template of its name, which ends in
 * XXXXXX, and becomes the name. The caller closes the file and removes it. */
FILE *written_file(char path[]);

/* Writes a file with this text, of at most 63 bytes; and true if the file has this text. The test ends if the file cannot
 * be opened. */
void written_text(const char *path, const char *text);
bool written_is(const char *path, const char *text);

/* Number of files that this process has open. */
int written_open_files(void);

/* True if the rows of two tables, or all tables of the snapshots of two results, are the same to the last bit. */
bool written_same_table(const struct nb_table *a, const struct nb_table *b);
bool written_same_snapshots(const struct nb_result *a, const struct nb_result *b);
