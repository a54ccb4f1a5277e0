/* Random packings: `grading`, `fill`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/clean.h"
#include "core/vec.h"
#include "packing/packing.h"
#include "statement.h"

enum { ATTEMPTS_MAX = 1000000 }; /* a fraction of a second for each size that does not fit */

enum { AT_NAME };
enum { AT_SHAPE, AT_CIRCLE, AT_RADIUS = AT_CIRCLE + 2, AT_BOX, AT_TO = AT_BOX + 2, AT_GRADING = AT_TO + 2 };
enum { AT_MATERIAL = AT_GRADING + 1, AT_SEED, AT_ATTEMPTS, AT_ELSE, AT_CELL };

/* clang-format off */
static const struct nb_argument grading_fields[] = {NAME(AT_NAME, "a name for the grading"), END};
static const struct nb_argument fill_fields[] = {
  SHAPE(AT_SHAPE),
  CLAUSE("circle", "X Y", NB_UNIT_LENGTH, NB_ANY, AT_CIRCLE, 2, "|`box` or `cell`", "Fills a circle about this centre."),
  CLAUSE("radius", "R", NB_UNIT_LENGTH, NB_POSITIVE, AT_RADIUS, 1, "+`box` or `cell`", "Radius of the circle."),
  CLAUSE("box", "X Y", NB_UNIT_LENGTH, NB_ANY, AT_BOX, 2, "|`circle` or `cell`", "Fills a box: its corner with the smallest x and y. This box has no walls."),
  CLAUSE("to", "X Y", NB_UNIT_LENGTH, NB_ANY, AT_TO, 2, "+`circle` or `cell`", "The opposite corner of the box."),
  FLAG("cell", AT_CELL, "|`circle` or `box`", "Fills the periodic cell, across its edges, so that the packing has no wall effect."),
  WORD("GRADING", AT_GRADING, "the name of a grading, which gives radii and numbers of particles: `grading NAME RADIUS N …`; `radius R` is that of the circle"),
  MATERIAL(AT_MATERIAL),
  COUNT("seed", "N", AT_SEED, NULL, "Seed of the random numbers."),
  COUNT("attempts", "N", AT_ATTEMPTS, NULL, "Largest number of random positions that are tried for each particle, up to 1000000."),
  CHOICE("else", "stop|skip", AT_ELSE, NULL, "what follows if no position is found for a particle within the attempts. `stop` ends with an error, as the old generator of R89 does. `skip` continues with the next smaller size; the quantity `dropped` of a monitored grading counts the skipped particles."),
  END
};
/* clang-format on */

/* ---- gradings ---- */

static int grading_of(const struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *token) {
  return NB_NAMED(reader, token, scene->gradings, scene->grading_count, "the name of a grading",
                  reader->starts ? "a page that starts from another has the gradings of that page only"
                                 : "define it above with `grading NAME …`");
}

int nb_take_grading(const struct nb_scene *scene, struct nb_reader *reader, int *size) {
  double radius;
  const int index = grading_of(scene, reader, nb_take_token(reader, "the name of a grading"));
  *size = -1;
  if (index < 0 || !nb_token_peek(reader))
    return index;
  const struct nb_grading *it = &scene->gradings[index];
  const struct nb_token *at = nb_take_word(reader, "radius") ? nb_token_peek(reader) : NULL;
  nb_take_number(reader, NB_UNIT_LENGTH, NB_POSITIVE, &radius);
  for (size_t s = 0; s < it->size_count; s++)
    if (it->sizes[s].radius == radius)
      *size = (int)s;
  if (*size < 0) {
    char hint[NB_HINT_SIZE] = "the radii are";
    for (size_t s = 0; s < it->size_count && s < 10; s++)
      nb_append(hint, sizeof hint, "%s %g%s", s ? "," : "", it->sizes[s].radius, reader->unitless ? "" : " m");
    nb_token_mistake(reader, at, hint, "expected one of the radii of the grading `%s`, found another one", it->name);
  }
  return index;
}

/* Takes `RADIUS N` and inserts this size; the sizes are sorted, largest first. */
static void take_size(struct nb_grading *it, struct nb_reader *reader) {
  const struct nb_token *at = nb_token_peek(reader);
  struct nb_size size = {0};
  size_t s = 0;
  nb_take_number(reader, NB_UNIT_LENGTH, NB_POSITIVE, &size.radius);
  nb_take_count(reader, 1, NB_PARTICLES_MAX, &size.count);
  while (s < it->size_count && it->sizes[s].radius > size.radius)
    s++;
  if (s < it->size_count && it->sizes[s].radius == size.radius)
    nb_token_mistake(reader, at, NULL, "expected each radius once, found this one twice");
  if (reader->bad || !NB_APPEND(reader, it->sizes, it->size_count, size))
    return;
  memmove(it->sizes + s + 1, it->sizes + s, (it->size_count - 1 - s) * sizeof size);
  it->sizes[s] = size;
  it->count += size.count;
}

NB_APPLY(apply_grading) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_token *name = record->value[AT_NAME].token;
  const int same = NB_FIND(scene->gradings, scene->grading_count, name->text);
  struct nb_grading one = {.line = (int)reader->line};
  if (nb_exists(reader, name, "grading", same < 0 ? 0 : scene->gradings[same].line) ||
      nb_too_many(reader, scene->grading_count, NB_NAMED_MAX, "gradings"))
    return;
  snprintf(one.name, sizeof one.name, "%s", name->text);
  do
    take_size(&one, reader);
  while (nb_token_peek(reader));
  if (reader->bad || !NB_APPEND(reader, scene->gradings, scene->grading_count, one))
    free(one.sizes);
}

/* ---- filling ---- */

/* Area to fill, m2. */
static double area(const struct nb_fill *fill) {
  return fill->circle ? NB_PI * fill->radius * fill->radius : (fill->x1 - fill->x) * (fill->y1 - fill->y);
}

/* Number of particles of this radius that the statement has placed. */
static size_t placed_count(const struct nb_scene *scene, const struct nb_fill *fill, double radius) {
  size_t count = 0;
  for (size_t k = fill->first; k < scene->particle_count; k++)
    count += scene->particles[k].radius == radius;
  return count;
}

/* Reports that there is no space for the next particle, and how many of each size are placed. */
static void report_no_space(struct nb_reader *reader, const struct nb_scene *scene, const struct nb_fill *fill) {
  const struct nb_grading *it = &scene->gradings[fill->grading];
  char list[1024] = "";
  for (size_t s = 0; s < it->size_count; s++) {
    const struct nb_size *size = &it->sizes[s];
    const size_t n = placed_count(scene, fill, size->radius);
    nb_append(list, sizeof list, "%s%zu of %zu with radius %g%s", s ? ", " : "", n, size->count, size->radius,
              reader->unitless ? "" : " m");
    if (n < size->count)
      break;
  }
  nb_token_mistake(
      reader, &reader->tokens[0],
      "fill a larger area, make more attempts, or write `else skip`, which leaves out the particles that do not fit",
      "expected space for all %zu particles of `%s`, found none for the next one in %lu attempts; placed: %s",
      it->count, it->name, fill->attempts, list);
}

/* Takes the place to fill: a circle, a box or the cell. */
static void take_place(struct nb_reader *reader, const struct nb_scene *scene, const struct nb_value *value,
                       struct nb_fill *fill) {
  const bool circle = value[AT_CIRCLE].token, box = value[AT_BOX].token, cell = value[AT_CELL].token;
  if (circle + box + cell != 1 || circle == !value[AT_RADIUS].token || box == !value[AT_TO].token)
    nb_token_mistake(reader, &reader->tokens[0], NULL,
                     "expected one place to fill: `circle X Y radius R`, `box X Y to X Y` or `cell`");
  if (cell && !nb_lacks_cell(scene, reader)) {
    fill->width = scene->cell.h[0], fill->height = scene->cell.h[3];
    fill->x = scene->cell.x - fill->width / 2, fill->y = scene->cell.y - fill->height / 2;
    fill->x1 = fill->x + fill->width, fill->y1 = fill->y + fill->height;
  }
  if (!circle)
    nb_corners_swapped(reader, fill->x, fill->y, fill->x1, fill->y1);
  if (!isfinite(area(fill)))
    nb_token_mistake(reader, &reader->tokens[0], NULL, "expected a finite area to fill; this one is too large");
}

NB_APPLY(apply_fill) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_value *value = record->value;
  const int at = value[AT_CIRCLE].token ? AT_CIRCLE : AT_BOX;
  struct nb_fill fill = {
      .circle = at == AT_CIRCLE,
      .x = value[at].number,
      .y = value[at + 1].number,
      .radius = value[AT_RADIUS].number,
      .x1 = value[AT_TO].number,
      .y1 = value[AT_TO + 1].number,
      .grading = grading_of(scene, reader, value[AT_GRADING].token),
      .seed = (unsigned long)value[AT_SEED].number,
      .attempts = (unsigned long)value[AT_ATTEMPTS].number,
      .skip = value[AT_ELSE].number == 1,
      .first = scene->particle_count,
      .line = (int)reader->line,
  };
  if (fill.attempts > ATTEMPTS_MAX)
    nb_token_mistake(reader, value[AT_ATTEMPTS].token, NULL,
                     "expected at most %d attempts for each particle, found %lu", ATTEMPTS_MAX, fill.attempts);
  take_place(reader, scene, value, &fill);
  const struct nb_particle like =
      nb_particle_of(reader, scene, (enum nb_shape)value[AT_SHAPE].number, value[AT_MATERIAL].token, false,
                     reader->bad ? 0 : scene->gradings[fill.grading].count);
  if (reader->bad)
    return;
  const enum nb_fill_result filled = nb_fill_random(scene, &fill, like);
  fill.count = scene->particle_count - fill.first;
  NB_APPEND(reader, scene->fills, scene->fill_count, fill);
  if (filled == NB_FILL_NO_MEMORY)
    nb_no_memory(reader);
  else if (filled == NB_FILL_STOPPED)
    report_no_space(reader, scene, &fill);
}

/* clang-format off */
NB_STATEMENTS(fill) = {
  {"grading", NB_IN_SCENE, grading_fields, "RADIUS N {RADIUS N …}", 0, false, apply_grading,
   "Defines the radii of the particles that `fill` places, and how many there are of each.\n"
   "RADIUS: a length above 0. Radius of a size.\n"
   "N: a whole number, 1 or more. Number of particles of this size.",
   "grading   mixed  8 mm 2  5 mm 6"},
  {"fill", NB_IN_SCENE, fill_fields, NULL, 0, false, apply_fill,
   "Places the discs or spheres of a grading at random in a circle, a box or the periodic cell (R89, sections 4.4 and 6.4). The largest are placed first, and they are numbered in this order. They lie wholly inside, and touch neither each other nor particles defined above; walls are ignored. With `cell` a particle may lie across the edges of the cell, and none touches an image of another one. A seed gives the same packing on every machine.",
   "fill      spheres circle 200 mm 40 mm radius 30 mm  mixed steel  seed 1  attempts 1000  else skip\n"
   "fill      discs box 250 mm 100 mm to 320 mm 180 mm  mixed glass  seed 4  attempts 1000  else stop"},
  {0},
};
/* clang-format on */
