/* A packing from a file: bodies where somebody else has put them.
 *
 * The file is a saved state (docs/STATE.md), of which only the bodies are taken, or a list of columns `x/m`, `y/m` and `radius/m`.
 * Either way a number comes to the page as the file has it, to the last bit.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "columns.h"
#include "scene.h"
#include "state_file.h"

static bool is_state(const char *path) {
  struct nb_error error;
  FILE *file = nb_file_open(path, &error);
  const bool is = file && nb_saved_is(file);
  if (file)
    fclose(file);
  return is;
}

/* Room for so many more; false with a message. */
static bool make_room(struct nb_scene *scene, struct nb_reader *reader, size_t count) {
  if (nb_too_many_bodies(reader, scene, count))
    return false;
  struct nb_body *bodies = nb_room(scene->bodies, scene->body_count, count, sizeof *bodies);
  if (!bodies)
    return nb_no_memory(reader), false;
  scene->bodies = bodies;
  return true;
}

/* The word of the statement that names the file. */
static const struct nb_token *file_of(const struct nb_reader *reader, bool all) { return &reader->tokens[all ? 2 : 1]; }

/* Index of the page's material of this name, for a body that is free or fixed; -1 with a message. */
static int material_named(const struct nb_scene *scene, struct nb_reader *reader, const char *name, bool fixed) {
  const struct nb_token *file = file_of(reader, false);
  int m = (int)scene->material_count - 1;
  while (m >= 0 && strcmp(scene->materials[m].name, name) != 0)
    m--;
  if (m < 0)
    nb_token_mistake(reader, file, "define it above, or give all the same one: `discs packing FILE MATERIAL`",
                     "expected the page to have all materials of the file, `%s` is missing", name);
  else if (scene->materials[m].density == 0 && !fixed)
    nb_token_mistake(reader, file, NULL, "expected materials with mass for free bodies, `%s` has no `density`", name);
  return reader->bad ? -1 : m;
}

/* Those that are not gone; with `all` of its shape and material, and free. */
static bool from_state(struct nb_scene *scene, struct nb_reader *reader, const char *path, const struct nb_body *all) {
  struct nb_saved saved;
  struct nb_error error = {NB_OK, ""};
  if (nb_saved_read(&saved, path, &error) == NB_NO_MEMORY)
    nb_no_memory(reader);
  else if (error.status)
    nb_token_mistake(reader, file_of(reader, all), NULL, "no bodies can be taken from the file: %s", error.text);
  else if (saved.unitless != reader->unitless)
    nb_token_mistake(reader, file_of(reader, all), NULL, "expected a file from a page with the same `units`");
  else if (make_room(scene, reader, saved.body_count))
    for (size_t k = 0; k < saved.body_count && !reader->bad; k++) {
      const struct nb_saved_body *it = &saved.bodies[k];
      struct nb_body body = {.shape = it->shape, .fixed = it->mobility == NB_FIXED};
      if (it->mobility == NB_GONE)
        continue;
      if (all)
        body = *all;
      else
        body.material = material_named(scene, reader, saved.materials[it->material].name, body.fixed);
      body.x = it->position.x, body.y = it->position.y, body.radius = it->radius, body.line = (int)reader->line;
      if (!reader->bad)
        scene->bodies[scene->body_count++] = body;
    }
  nb_saved_free(&saved);
  return !reader->bad;
}

static bool from_list(struct nb_scene *scene, struct nb_reader *reader, const char *path, const struct nb_body *all) {
  static const struct nb_wanted wanted[] = {{"x", NULL, false}, {"y", NULL, false}, {"radius", NULL, true}};
  double *lengths;
  size_t rows;
  if (!all) {
    nb_token_mistake(reader, file_of(reader, all), "say it of all: `discs packing FILE MATERIAL`",
                     "expected a file of `nineball state`: a list does not tell what its bodies are");
    return false;
  }
  const bool whole = nb_columns_read(&lengths, &rows, path, wanted, 3, reader->unitless, reader->mistakes) &&
                     make_room(scene, reader, rows);
  for (size_t k = 0; k < rows && whole; k++) {
    struct nb_body *body = &scene->bodies[scene->body_count++];
    *body = *all;
    body->x = lengths[3 * k], body->y = lengths[3 * k + 1], body->radius = lengths[3 * k + 2];
  }
  free(lengths);
  return whole;
}

/* What a state of this page depends on: not the name of the file but what has come from it. */
static void hash_bodies(struct nb_scene_reading *reading, size_t first) {
  for (size_t k = first; k < reading->scene->body_count; k++) {
    const struct nb_body *body = &reading->scene->bodies[k];
    const double numbers[] = {body->x, body->y, body->radius};
    const int words[] = {(int)body->shape, body->material, body->fixed};
    reading->hash = nb_hash(nb_hash(reading->hash, numbers, sizeof numbers), words, sizeof words);
  }
}

static bool keep(struct nb_scene *scene, struct nb_reader *reader, const char *path, size_t first) {
  struct nb_packing *packings = nb_room(scene->packings, scene->packing_count, 1, sizeof *packings);
  char *own = malloc(strlen(path) + 1);
  if (packings)
    scene->packings = packings;
  if (!packings || !own) {
    free(own);
    return nb_no_memory(reader), false;
  }
  packings[scene->packing_count++] =
      (struct nb_packing){strcpy(own, path), first, scene->body_count - first, (int)reader->line};
  return true;
}

/* variant: enum nb_shape of all, or -1: as the file has them. */
NB_APPLY(nb_apply_packing) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  const size_t first = scene->body_count;
  const bool said = record->keyword->variant >= 0;
  char path[NB_PATH_SIZE];
  struct nb_body all = {0};
  bool whole = !reader->bad && nb_file_named(reader, record->value[AT_NAME].token, path) &&
               (!said || nb_body_of(&all, scene, reader, record, 0));
  if (whole)
    whole = (is_state(path) ? from_state : from_list)(scene, reader, path, said ? &all : NULL);
  whole = whole && keep(scene, reader, path, first);
  hash_bodies(reading, first);
  reading->bodies_unsure = reading->bodies_unsure || !whole;
}
