/* The values and curves of a solution, and the register of all references.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_errno.h>
#include <stdlib.h>
#include <string.h>

#include "reference.h"

/* The array with space for one more element of `size` bytes. The space doubles when the count reaches a power of two.
 * NULL: out of memory; the old array is still valid. */
static void *one_more(void *array, size_t count, size_t size) {
  if (count & (count - 1))
    return array;
  return realloc(array, (count ? 2 * count : 1) * size);
}

static void copy_text(char *to, const char *from, size_t size) {
  strncpy(to, from, size - 1);
  to[size - 1] = '\0';
}

void solution_value(struct nb_solution *solution, double value, const char *name) {
  struct nb_solution_value *values = one_more(solution->values, solution->value_count, sizeof *values);
  if (!values) {
    solution->incomplete = true;
    return;
  }
  solution->values = values;
  values += solution->value_count++;
  copy_text(values->name, name, sizeof values->name);
  values->value = value;
}

void solution_curve(struct nb_solution *solution, const char *name, const char *along,
                    double (*at)(const void *data, double x), void *data) {
  struct nb_solution_curve *curves = data ? one_more(solution->curves, solution->curve_count, sizeof *curves) : NULL;
  if (!curves) {
    solution->incomplete = true;
    free(data);
    return;
  }
  solution->curves = curves;
  curves += solution->curve_count++;
  copy_text(curves->name, name, sizeof curves->name);
  copy_text(curves->along, along, sizeof curves->along);
  curves->at = at;
  curves->data = data;
}

enum nb_status solution_status(const struct nb_solution *solution, struct nb_error *error) {
  if (solution->incomplete)
    return nb_error_memory(error);
  return NB_OK;
}

const double *solution_find(const struct nb_solution *solution, const char *name) {
  for (size_t i = 0; i < solution->value_count; i++)
    if (!strcmp(solution->values[i].name, name))
      return &solution->values[i].value;
  return NULL;
}

const struct nb_solution_curve *solution_find_curve(const struct nb_solution *solution, const char *name,
                                                    const char *along) {
  for (size_t i = 0; i < solution->curve_count; i++)
    if (!strcmp(solution->curves[i].name, name) && !strcmp(solution->curves[i].along, along))
      return &solution->curves[i];
  return NULL;
}

void solution_free(struct nb_solution *solution) {
  for (size_t i = 0; i < solution->curve_count; i++)
    free(solution->curves[i].data);
  free(solution->curves);
  free(solution->values);
  *solution = (struct nb_solution){0};
}

/* make writes references-register.h. It has a line such as NB_REFERENCE(nine_discs) for each file of REFERENCES in
 * build-aux/lists.mk. */
#define NB_REFERENCE(name) extern const struct nb_reference reference_##name;
#include "references-register.h"
#undef NB_REFERENCE

static const struct nb_reference *const register_of_references[] = {
#define NB_REFERENCE(name) &reference_##name,
#include "references-register.h"
#undef NB_REFERENCE
    NULL,
};

const struct nb_reference *const *nb_references(void) { return register_of_references; }

const struct nb_reference *nb_reference_find(const char *name) {
  for (const struct nb_reference *const *reference = register_of_references; *reference; reference++)
    if (!strcmp((*reference)->name, name))
      return *reference;
  return NULL;
}

static void handle(const char *reason, const char *file, int line, int status) {
  struct nb_error error;
  (void)reason, (void)file, (void)line;
  if (status != GSL_ENOMEM)
    return;
  nb_error_memory(&error);
  fprintf(stderr, "error: a reference is %s\n", error.text);
  exit(NB_NO_MEMORY);
}

void nb_references_prepare(void) { gsl_set_error_handler(handle); }

enum nb_status nb_reference_solve(const struct nb_reference *reference, struct nb_solution *solution,
                                  const struct nb_scene *scene, struct nb_error *error) {
  const enum nb_status status = nb_reference_covers(reference, scene, error);
  return status ? status : reference->solve(solution, scene, error);
}
