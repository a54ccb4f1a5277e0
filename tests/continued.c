/* Runs that continue from a saved state, compared with the uninterrupted run.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "continued.h"
#include "core/names.h"
#include "run/plan.h"

#include <CUnit/CUnit.h>
#include <stdlib.h>
#include <string.h>

void continued_stages(struct nb_model *model, size_t from, size_t to) {
  struct nb_error error = {NB_OK, ""};
  for (size_t s = from; s < to; s++) {
    const struct nb_stage *stage = &model->scene->stages[s];
    if (nb_stage_begin(model, stage, &error))
      printf("# %s\n", error.text);
    CU_ASSERT_EQUAL_FATAL(error.status, NB_OK);
    written_cycles(model, (int)stage->cycles);
  }
}

/* The state as text, which the caller frees. */
static char *text_of(const struct nb_model *model) {
  struct nb_saved saved;
  struct nb_error error;
  size_t size;
  CU_ASSERT_EQUAL_FATAL(nb_saved_capture(&saved, model, &error), NB_OK);
  char *text = nb_saved_text(&saved, &size);
  CU_ASSERT_PTR_NOT_NULL_FATAL(text);
  nb_saved_free(&saved);
  return text;
}

/* The present values of the columns of the page, which the caller frees. They are compared too, because a comparison of
 * states would not find a variable that every state stores as 0. */
static double *recorded(const struct nb_model *model) {
  const struct nb_scene *scene = model->scene;
  double *values = calloc(scene->column_count + 1, sizeof *values);
  CU_ASSERT_PTR_NOT_NULL_FATAL(values);
  for (size_t c = 0; c < scene->column_count; c++)
    values[c] = nb_quantity_value(scene->columns[c].quantity, model);
  return values;
}

static void compare_recorded(const struct nb_model *model, const double *wanted) {
  double *values = recorded(model);
  for (size_t c = 0; c < model->scene->column_count; c++) {
    const bool same = memcmp(&values[c], &wanted[c], sizeof *values) == 0;
    if (!same)
      printf("# %s: %.17g, uninterrupted %.17g\n", model->scene->columns[c].name, values[c], wanted[c]);
    CU_ASSERT(same);
  }
  free(values);
}

/* Reads the state and continues from stage `from` to the end, where the recorded quantities must be the wanted ones.
 * Returns the final state as text, which the caller frees. */
static char *interrupted(struct written *it, size_t from, const char *state, const double *wanted,
                         const struct nb_options *options) {
  struct nb_saved saved;
  struct nb_error error = {NB_OK, ""};
  size_t size;
  if (nb_saved_read_text(&saved, "a.state", state, strlen(state), &error))
    printf("# %s\n", error.text);
  CU_ASSERT_EQUAL_FATAL(error.status, NB_OK);
  char *again = nb_saved_text(&saved, &size);
  CU_ASSERT_STRING_EQUAL(again, state);
  free(again);
  it->scene.start.stages = from;
  CU_ASSERT_EQUAL(nb_saved_fits(&saved, &it->scene, "a.state", &error), NB_OK);
  struct nb_model *model = nb_model_resume(&it->scene, options, &saved, &error);
  if (!model)
    printf("# %s\n", error.text);
  CU_ASSERT_PTR_NOT_NULL_FATAL(model);
  nb_saved_free(&saved);
  char *same = text_of(model);
  CU_ASSERT_STRING_EQUAL(same, state);
  free(same);
  continued_stages(model, from, it->scene.stage_count);
  char *end = text_of(model);
  compare_recorded(model, wanted);
  nb_model_free(model);
  it->scene.start.stages = 0;
  return end;
}

void continued_same(struct written *it, const char *what) {
  static const struct nb_options ways[] = {{.threads = 1, .keep_all = true},
                                           {.threads = 1, .keep_all = true, .shuffle = true, .isa = "plain"},
                                           {.threads = 3, .keep_all = true}};
  const size_t last = it->scene.stage_count;
  struct nb_model *model = written_model(it, &ways[0]);
  char **states = calloc(last, sizeof *states);
  bool touched = false;
  for (size_t s = 0; s < last; s++) {
    continued_stages(model, s, s + 1);
    states[s] = text_of(model);
    touched = touched || strstr(states[s], "\ncontact ");
  }
  CU_ASSERT(touched);
  double *wanted = recorded(model);
  for (size_t s = 0; s + 1 < last; s++)
    for (size_t w = 0; w < sizeof ways / sizeof *ways; w++) {
      char *end = interrupted(it, s + 1, states[s], wanted, &ways[w]);
      if (strcmp(end, states[last - 1]) != 0)
        printf("# states differ: %s, continued from the end of stage `%s`, options %zu\n", what,
               it->scene.stages[s].name, w);
      CU_ASSERT_STRING_EQUAL(end, states[last - 1]);
      free(end);
    }
  for (size_t s = 0; s < last; s++)
    free(states[s]);
  free(states), free(wanted);
  nb_model_free(model);
}
