/* Scenes that a test writes as a page would, in its own words, and what comes of running them.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_WRITTEN_H
#define NB_WRITTEN_H

#include "../src/nineball.h"

struct written {
  struct nb_page page;
  struct nb_scene scene;
};

/* A page grows statement by statement; the text is owned, written_scene frees it. */
struct words {
  char *text;
  size_t length;
};
void words_add(struct words *words, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The only run of the page with these statements, those of a contact test if the first line is `path`; the test ends here when they hold a mistake. Free it in place. */
void written_scene(struct written *written, struct words *words);
/* Likewise, as by --set. */
void written_scene_set(struct written *written, struct words *words, nb_settings settings);
void written_free(struct written *written);

/* Of the scene at time 0; the test ends here when it cannot be made. nb_model_free it. */
struct nb_model *written_model(const struct written *written, const struct nb_options *options);
void written_cycles(struct nb_model *model, int count);
/* A quantity that the scene's page records, now. */
double written_now(const struct nb_model *model, const char *name);

/* All stages; the test ends here when the physics breaks. nb_result_free it. */
void written_run(struct nb_result *result, const struct written *written, const struct nb_options *options);
/* Column `name` of that row, and of the last one; a test with a row or a column that is not there fails. */
double written_cell(const struct nb_table *table, size_t row, const char *name);
double written_last(const struct nb_result *result, const char *name);

#endif
