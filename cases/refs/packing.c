/* Reference: particles read from a packing file, and their state when it was written.
 *
 * Returns, for D that monitors a particle and C that monitors a contact, at 0 cycles:
 *   D.x, D.y       the numbers of the particle's record in the state
 *   C.normal       the force in the contact's record
 *   C.shear        0: a packing has no shear history
 *   contacts       the number of contact records
 *
 * The state is the file of the `packing` itself or, for a list, the file of the same name that ends in `.state`. It is
 * read here as text, without the simulator's reader of states.
 *
 * Exact to the last bit: nothing has moved at cycle 0, and a normal law without history computes the same force from
 * the same numbers.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "reference.h"

enum { LINE = 4096 };

/* Opens the state of the scene's packing; NULL: there is none. */
static FILE *open_state(const struct nb_scene *scene) {
  char path[LINE];
  const char *from = scene->packings[0].path, *dot = strrchr(from, '.'), *slash = strrchr(from, '/');
  const int stem = dot && (!slash || dot > slash) ? (int)(dot - from) : (int)strlen(from);
  if (snprintf(path, sizeof path, "%.*s.state", stem, from) >= LINE)
    return NULL;
  return fopen(path, "r");
}

/* The word with the given index, from 0, of a record. */
static const char *field(const char *line, int index) {
  for (; index > 0; index--)
    line += strcspn(line, " ") + 1;
  return line;
}

static bool begins(const char *line, const char *words) { return strncmp(line, words, strlen(words)) == 0; }

static void add_value(struct nb_solution *solution, const char *of, const char *what, double value) {
  char name[3 * NB_NAME_SIZE];
  snprintf(name, sizeof name, "%s.%s at 0 cycles", of, what);
  solution_value(solution, value, name);
}

/* The index of a name in the record `fields`, from 0 after the word `fields`; -1: not there. */
static int field_index(const char *fields, const char *name) {
  int place = 0;
  for (const char *at = field(fields, 1); *at && *at != '\n'; at += strcspn(at, " \n"), at += *at == ' ', place++)
    if (begins(at, name) && strchr(" \n", at[strlen(name)]))
      return place;
  return -1;
}

static void add_contact(struct nb_solution *solution, const struct nb_scene *scene, const char *line, int normal) {
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    char begin[3 * NB_NAME_SIZE];
    if (monitor->kind == NB_MONITOR_PARTICLE_PARTICLE)
      snprintf(begin, sizeof begin, "contact %d body %d ", monitor->a < monitor->b ? monitor->a + 1 : monitor->b + 1,
               monitor->a < monitor->b ? monitor->b + 1 : monitor->a + 1);
    else if (monitor->kind == NB_MONITOR_PARTICLE_WALL)
      snprintf(begin, sizeof begin, "contact %d wall %s ", monitor->a + 1, scene->walls[monitor->b].name);
    else
      continue;
    if (!begins(line, begin))
      continue;
    add_value(solution, monitor->name, "normal", strtod(field(line, 7 + normal), NULL));
    add_value(solution, monitor->name, "shear", 0);
  }
}

static void add_body(struct nb_solution *solution, const struct nb_scene *scene, const char *line) {
  const int number = atoi(field(line, 1));
  for (size_t w = 0; w < scene->monitor_count; w++)
    if (scene->monitors[w].kind == NB_MONITOR_PARTICLE && scene->monitors[w].a == number - 1) {
      add_value(solution, scene->monitors[w].name, "x", strtod(field(line, 6), NULL));
      add_value(solution, scene->monitors[w].name, "y", strtod(field(line, 7), NULL));
    }
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  char line[LINE];
  int normal = -1;
  double contacts = 0;
  if (scene->packing_count != 1 || scene->packings[0].count != scene->particle_count)
    return nb_error_set(error, NB_BAD_USE, "the reference `packing` is for one `packing`, and no other particles");
  FILE *file = open_state(scene);
  if (!file)
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `packing` needs the state that belongs to %.200s: a file of the same name that ends in .state",
        scene->packings[0].path);
  while (fgets(line, sizeof line, file)) {
    if (begins(line, "body "))
      add_body(solution, scene, line);
    if (begins(line, "fields "))
      normal = field_index(line, "normal");
    if (begins(line, "contact ") && normal >= 0)
      contacts++, add_contact(solution, scene, line, normal);
  }
  fclose(file);
  solution_value(solution, contacts, "contacts at 0 cycles");
  return solution_status(solution, error);
}

const struct nb_reference reference_packing = {
    .name = "packing",
    .title = "particles from a file: positions and forces as in the file",
    .source = "-",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_WALLS, HAS_FRICTION},
    .normal = "linear",
    .shear = "none linear",
    .solve = solve,
};
