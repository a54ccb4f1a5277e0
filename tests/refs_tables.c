/* The comparison of references with tables of expected values and messages.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "refs_tables.h"
#include "written.h"

/* An array with one more element. */
static void *one_more(const void *array, size_t count, size_t size, const void *more) {
  char *longer = malloc((count + 1) * size);
  CU_ASSERT_PTR_NOT_NULL_FATAL(longer);
  if (count)
    memcpy(longer, array, count * size);
  memcpy(longer + count * size, more, size);
  return longer;
}

/* The scene that was solved last. */
static struct {
  struct written it;
  struct nb_scene scene;
} solved;

static void release(void) {
  if (!solved.scene.particles)
    return;
  free(solved.scene.particles), free(solved.scene.walls), free(solved.scene.stages), free(solved.scene.monitors);
  solved.scene.particles = NULL;
  written_free(&solved.it);
}

/* The monitor of which a copy is added: the last one, or the first. */
static bool last_monitor;

/* A reference that forgets to set a variable does not find zeros on the stack. */
static void fill_stack(void) {
  volatile unsigned char bytes[1 << 16];
  for (size_t k = 0; k < sizeof bytes; k++)
    bytes[k] = 0xff;
}

/* An element is added behind the ends of the arrays of the scene, which a loop over one element too many would read. */
enum nb_status refs_solve(struct nb_solution *solution, const char *reference, const char *text,
                          struct nb_error *error) {
  struct words page = {0};
  release();
  const bool contact_test = strncmp(text, "path\n", 5) == 0;
  words_add(&page, "%sunits none\n%s", contact_test ? "path\n" : "", text + (contact_test ? 5 : 0));
  written_scene(&solved.it, &page);
  struct nb_scene *const scene = &solved.scene;
  *scene = solved.it.scene;
  const struct nb_particle particle = {.x = NAN, .y = NAN, .radius = 1e9, .shape = scene->particles[0].shape};
  const struct nb_wall wall = {.x = NAN, .y = NAN, .ex = NAN};
  struct nb_stage stage = scene->stages[scene->stage_count - 1];
  struct nb_monitor monitor = {0};
  if (scene->monitor_count)
    monitor = scene->monitors[last_monitor ? scene->monitor_count - 1 : 0];
  strcpy(stage.name, "beyond"), strcpy(monitor.name, "beyond");
  scene->particles = one_more(scene->particles, scene->particle_count, sizeof particle, &particle);
  scene->walls = one_more(scene->walls, scene->wall_count, sizeof wall, &wall);
  scene->stages = one_more(scene->stages, scene->stage_count, sizeof stage, &stage);
  scene->monitors = one_more(scene->monitors, scene->monitor_count, sizeof monitor, &monitor);
  *solution = (struct nb_solution){0};
  fill_stack();
  return nb_reference_solve(nb_reference_find(reference), solution, scene, error);
}

static void check_once(const char *reference, const char *page, double scale, const struct expected *expected,
                       size_t count) {
  struct nb_solution solution;
  struct nb_error error = {0};
  size_t named = 0;
  if (refs_solve(&solution, reference, page, &error) != NB_OK)
    printf("# %s: %s\n", reference, error.text);
  for (size_t k = 0; k < count; k++) {
    const struct expected *it = &expected[k];
    const double *value = it->along ? NULL : solution_find(&solution, it->name);
    const struct nb_solution_curve *curve = it->along ? solution_find_curve(&solution, it->name, it->along) : NULL;
    const double found = value ? *value : curve ? curve->at(curve->data, it->x) : NAN;
    const bool right = fabs(found - it->value) <= 1e-12 * fmax(fabs(it->value), scale);
    if (!right)
      printf("# %s: %s at %g is %.17g, expected %.17g\n", reference, it->name, it->x, found, it->value);
    CU_ASSERT(right);
    size_t same = 0; /* the first row of this name */
    while (strcmp(expected[same].name, it->name) != 0 || !expected[same].along != !it->along ||
           (it->along && strcmp(expected[same].along, it->along) != 0))
      same++;
    named += same == k;
  }
  if (named != solution.value_count + solution.curve_count)
    printf("# %s: %zu values and %zu curves\n", reference, solution.value_count, solution.curve_count);
  CU_ASSERT_EQUAL(named, solution.value_count + solution.curve_count);
  solution_free(&solution);
}

void refs_check(const char *reference, const char *page, double scale, const struct expected *expected, size_t count) {
  for (int last = 0; last < 2; last++) {
    last_monitor = last;
    check_once(reference, page, scale, expected, count);
  }
}

void refs_check_error(const char *reference, const char *page, const char *text) {
  struct nb_solution solution;
  struct nb_error error = {0};
  const enum nb_status status = refs_solve(&solution, reference, page, &error);
  const bool right = status == (text ? NB_BAD_USE : NB_OK) && (!text || strcmp(error.text, text) == 0);
  if (!right)
    printf("# %s, status %d\n# found:    %s\n# expected: %s\n# page: %s\n", reference, status, error.text,
           text ? text : "", page);
  CU_ASSERT(right);
  solution_free(&solution);
}

void refs_check_message(const char *reference, const char *page, const char *message) {
  char text[512];
  snprintf(text, sizeof text, "the reference `%s` is for %s", reference, message ? message : "");
  refs_check_error(reference, page, message ? text : NULL);
}

void refs_check_parts(const char *reference, const char *page, const struct part *parts, size_t count) {
  for (size_t k = 0; k < count; k++) {
    char text[4096];
    const char *const at = strchr(page, '@');
    snprintf(text, sizeof text, "%.*s%s%s", (int)(at - page), page, parts[k].text, at + 1);
    refs_check_message(reference, text, parts[k].message);
  }
}
int refs_released(void) {
  release();
  return 0;
}
