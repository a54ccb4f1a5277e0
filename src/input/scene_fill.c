/* Gradings, and what is filled with them.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/vec.h"
#include "packing/packing.h"
#include "scene.h"

enum { TRIES_MAX = 1000000 }; /* a second or so for each size that does not fit */

static int find_grading(const struct nb_scene *scene, const char *name) {
  for (size_t i = 0; i < scene->grading_count; i++)
    if (strcmp(scene->gradings[i].name, name) == 0)
      return (int)i;
  return -1;
}

static int grading_of(const struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *token) {
  char hint[NB_HINT_SIZE];
  int index = find_grading(scene, token->text);
  if (index >= 0)
    return index;
  struct nb_guess guess = nb_guess_begin(token->text);
  for (size_t i = 0; i < scene->grading_count; i++)
    nb_guess_offer(&guess, scene->gradings[i].name);
  const char *did_you_mean = nb_guess_hint(&guess, hint);
  nb_not_known(reader, token, did_you_mean ? did_you_mean : "define it above with `grading NAME …`",
               "the name of a grading");
  return -1;
}

/* One more size, where it belongs: largest first. */
static void add_size(struct nb_grading *grading, struct nb_reader *reader, double radius, size_t count,
                     const struct nb_token *at) {
  size_t s = 0;
  while (s < grading->size_count && grading->sizes[s].radius > radius)
    s++;
  if (s < grading->size_count && grading->sizes[s].radius == radius) {
    nb_token_mistake(reader, at, NULL, "expected every radius once, found this one twice");
    return;
  }
  struct nb_size *sizes = nb_room(grading->sizes, grading->size_count, 1, sizeof *sizes);
  if (!sizes) {
    nb_no_memory(reader);
    return;
  }
  memmove(sizes + s + 1, sizes + s, (grading->size_count - s) * sizeof *sizes);
  sizes[s] = (struct nb_size){.radius = radius, .count = count};
  grading->sizes = sizes, grading->size_count++, grading->count += count;
}

NB_APPLY(nb_apply_grading) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_token *name = record->value[AT_NAME].token;
  if (!name)
    return;
  int same = find_grading(scene, name->text);
  if (same >= 0) {
    nb_token_mistake(reader, name, NULL, "there is a grading `%s` already, on line %d", name->text,
                     scene->gradings[same].line);
    return;
  }
  if (nb_too_many(reader, scene->grading_count, NB_NAMED_MAX, "gradings"))
    return;
  struct nb_grading *gradings = nb_room(scene->gradings, scene->grading_count, 1, sizeof *gradings);
  if (!gradings) {
    nb_no_memory(reader);
    return;
  }
  scene->gradings = gradings;
  struct nb_grading *grading = &gradings[scene->grading_count++];
  *grading = (struct nb_grading){.line = (int)reader->line};
  snprintf(grading->name, sizeof grading->name, "%s", name->text);
  do {
    const struct nb_token *at = nb_token_peek(reader);
    double radius;
    unsigned long count;
    if (!nb_take_number(reader, NB_UNIT_LENGTH, NB_POSITIVE, &radius) ||
        !nb_take_count(reader, 1, NB_BODIES_MAX, &count) || reader->bad)
      break;
    add_size(grading, reader, radius, count, at);
  } while (nb_token_peek(reader) && !reader->bad);
  if (reader->bad)
    grading->count = 0; /* which says: nothing can be filled with it */
}

/* Of the circle or the box, m2. */
static double area(const struct nb_fill *fill) {
  return fill->circle ? NB_PI * fill->radius * fill->radius : (fill->x1 - fill->x) * (fill->y1 - fill->y);
}

/* Bodies of that radius among those of the filling. */
static size_t placed(const struct nb_scene *scene, const struct nb_fill *fill, double radius) {
  size_t count = 0;
  for (size_t k = fill->first; k < scene->body_count; k++)
    count += scene->bodies[k].radius == radius;
  return count;
}

/* How many of which size there are when no place is found for one more. */
static void say_stopped(struct nb_reader *reader, const struct nb_scene *scene, const struct nb_fill *fill) {
  const struct nb_grading *grading = &scene->gradings[fill->grading];
  char list[1024] = "", hint[NB_HINT_SIZE];
  for (size_t s = 0; s < grading->size_count; s++) {
    const struct nb_size *size = &grading->sizes[s];
    const size_t used = strlen(list), n = placed(scene, fill, size->radius);
    snprintf(list + used, sizeof list - used, "%s%zu of %zu with radius %g%s", s ? ", " : "", n, size->count,
             size->radius, reader->unitless ? "" : " m");
    if (n < size->count)
      break;
  }
  snprintf(hint, sizeof hint, "fill more room, try oftener, or say `else skip`: smaller ones may still fit");
  nb_token_mistake(
      reader, &reader->tokens[0], hint,
      "expected room for all %zu bodies of `%s`, found no place for the next one with `tries %lu`; placed: %s",
      grading->count, grading->name, fill->tries, list);
}

/* The words and numbers of the row; false with a message. */
static bool take_fill(struct nb_fill *fill, const struct nb_scene *scene, struct nb_reader *reader,
                      const struct nb_record *record) {
  const struct nb_value *value = record->value;
  const struct nb_token *otherwise = value[AT_ELSE].token;
  if (reader->bad)
    return false;
  *fill = (struct nb_fill){
      .circle = value[AT_RADIUS].token != NULL,
      .x = value[AT_X].number,
      .y = value[AT_Y].number,
      .radius = value[AT_RADIUS].number,
      .x1 = value[AT_X1].number,
      .y1 = value[AT_Y1].number,
      .grading = grading_of(scene, reader, value[AT_GRADING].token),
      .seed = (unsigned long)value[AT_SEED].number,
      .tries = (unsigned long)value[AT_TRIES].number,
      .skip = strcmp(otherwise->text, "skip") == 0,
      .first = scene->body_count,
      .line = (int)reader->line,
  };
  if (!fill->skip && strcmp(otherwise->text, "stop") != 0)
    nb_not_known(reader, otherwise, NULL, "`stop` or `skip`");
  else if (fill->tries > TRIES_MAX)
    nb_token_mistake(reader, value[AT_TRIES].token, NULL, "expected at most %d tries for each body", TRIES_MAX);
  else if (!fill->circle && !(fill->x1 > fill->x && fill->y1 > fill->y))
    nb_token_mistake(reader, value[AT_X1].token, NULL,
                     "expected a north-east corner to the north and east of the first one");
  else if (!isfinite(area(fill)))
    nb_token_mistake(reader, &reader->tokens[0], NULL, "expected a place to fill that a double can hold the area of");
  return !reader->bad && scene->gradings[fill->grading].count > 0;
}

NB_APPLY(nb_apply_fill) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  struct nb_body like;
  struct nb_fill fill;
  const bool whole = take_fill(&fill, scene, reader, record);
  if (whole && nb_body_of(&like, scene, reader, record, scene->gradings[fill.grading].count)) {
    const enum nb_filled filled = nb_fill_random(scene, &fill, like);
    fill.count = scene->body_count - fill.first;
    struct nb_fill *fills = nb_room(scene->fills, scene->fill_count, 1, sizeof *fills);
    if (fills)
      scene->fills = fills, fills[scene->fill_count++] = fill;
    if (!fills || filled == NB_FILL_NO_MEMORY)
      nb_no_memory(reader);
    else if (filled == NB_FILL_STOPPED)
      say_stopped(reader, scene, &fill);
  }
  reading->bodies_unsure = reading->bodies_unsure || reader->bad || !whole;
}

int nb_take_grading(const struct nb_scene *scene, struct nb_reader *reader, int *size) {
  const struct nb_token *name = nb_take(reader, "the name of a grading");
  double radius;
  *size = -1;
  if (!name || name->hollow)
    return -1;
  const int index = grading_of(scene, reader, name);
  if (reader->bad || !nb_token_peek(reader))
    return index;
  const struct nb_grading *grading = &scene->gradings[index];
  if (!nb_take_word(reader, "radius"))
    return -1;
  const struct nb_token *at = nb_token_peek(reader);
  if (!nb_take_number(reader, NB_UNIT_LENGTH, NB_POSITIVE, &radius) || reader->bad)
    return -1;
  for (size_t s = 0; s < grading->size_count; s++)
    if (grading->sizes[s].radius == radius)
      *size = (int)s;
  if (*size < 0 && grading->count > 0)
    nb_token_mistake(reader, at, NULL, "expected a radius of the grading `%s`", grading->name);
  return grading->count > 0 && !reader->bad ? index : -1;
}
