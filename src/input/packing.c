/* `packing`: particles from a file.
 *
 * The file is a saved state (docs/STATE.md), of which only the particles are used, or a list of columns `x/m`, `y/m`
 * and `radius/m`. The numbers are read to the last bit.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "columns.h"
#include "hash.h"
#include "state_file.h"
#include "statement.h"

enum { AT_FILE, AT_OF, AT_SORTED = AT_OF + 2 }; /* AT_OF: material of discs; the slot after it: material of spheres */
#define ALL_OF(shapes, shape)                                                                                          \
  {                                                                                                                    \
    shapes, "MATERIAL", NB_ARGUMENT_WORD, NB_UNIT_NUMBER, NB_ANY, AT_OF + shape, 1, "as in the file",                  \
        "the name of a material"                                                                                       \
  }
#define SORTED                                                                                                         \
  "Numbers the particles in rows as high as the largest of them: from the smallest y, and in a row from the smallest " \
  "x. Large packings then run faster (docs/PERFORMANCE.md)."
static const struct nb_argument packing_fields[] = {WORD("FILE", AT_FILE, "the name of a file"),
                                                    ALL_OF("discs", NB_DISC), ALL_OF("spheres", NB_SPHERE),
                                                    FLAG("sorted", AT_SORTED, "in the order of the file", SORTED), END};

static bool is_state(const char *path) {
  struct nb_error error;
  FILE *file = nb_file_open(path, &error);
  const bool is = file && nb_saved_is(file);
  if (file)
    fclose(file);
  return is;
}

/* Index of the page's material with this name; -1 with a message. A material of free particles needs a density. */
static int material_named(const struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *file,
                          const char *name, bool fixed) {
  const int m = NB_FIND(scene->materials, scene->material_count, name);
  if (m < 0)
    nb_token_mistake(reader, file, "define it above, or give all particles one material: `packing FILE discs MATERIAL`",
                     "expected all materials of the file in the page, found that `%s` is missing", name);
  else if (scene->materials[m].density == 0 && !fixed)
    nb_token_mistake(reader, file, "give the material a `density`",
                     "expected a material with a density for free particles, found that `%s` has none", name);
  return m;
}

/* Adds the particles of a saved state, except removed ones. If `all` is not NULL, it gives the shape and the material
 * of each particle, and all particles become free. */
static void from_state(struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *file, const char *path,
                       const struct nb_particle *all) {
  struct nb_saved saved;
  struct nb_error error = {NB_OK, ""};
  if (nb_saved_read(&saved, path, &error) == NB_NO_MEMORY)
    nb_no_memory(reader);
  else if (error.status)
    nb_token_mistake(reader, file, NULL, "cannot read the particles of the file: %s", error.text);
  else if (saved.unitless != reader->unitless)
    nb_token_mistake(reader, file,
                     "write this page in the units of the file, or save a file from a page in these units",
                     "expected a file from a page with the same `units`, found one from a page with `units %s`",
                     saved.unitless ? "none" : "si");
  else if (!nb_too_many_particles(reader, scene, saved.particle_count))
    for (size_t k = 0; k < saved.particle_count && !reader->bad; k++) {
      const struct nb_saved_particle *it = &saved.particles[k];
      struct nb_particle particle = {.shape = it->shape, .fixed = it->mobility == NB_FIXED};
      if (it->mobility == NB_REMOVED)
        continue;
      if (all)
        particle = *all;
      else
        particle.material = material_named(scene, reader, file, saved.materials[it->material].name, particle.fixed);
      particle.x = it->position.x, particle.y = it->position.y, particle.radius = it->radius,
      particle.line = (int)reader->line;
      if (!reader->bad)
        NB_APPEND(reader, scene->particles, scene->particle_count, particle);
    }
  nb_saved_free(&saved);
}

static void from_list(struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *file, const char *path,
                      const struct nb_particle *all) {
  static const struct nb_wanted_column wanted[] = {{"x", NULL, false}, {"y", NULL, false}, {"radius", NULL, true}};
  double *lengths;
  size_t rows;
  if (!all) {
    nb_token_mistake(reader, file, "a list of particles needs a material: `packing FILE discs MATERIAL`",
                     "expected a file of `nineball state`, found another kind of file");
    return;
  }
  if (!nb_columns_read(&lengths, &rows, path, wanted, 3, reader->unitless, reader->mistakes))
    nb_fail_silently(reader);
  nb_too_many_particles(reader, scene, rows);
  for (size_t k = 0; k < rows && !reader->bad; k++) {
    struct nb_particle particle = *all;
    particle.x = lengths[3 * k], particle.y = lengths[3 * k + 1], particle.radius = lengths[3 * k + 2];
    NB_APPEND(reader, scene->particles, scene->particle_count, particle);
  }
  free(lengths);
}

/* A particle of a packing that is sorted, and its row, counted from y = 0. */
struct in_row {
  double row;
  struct nb_particle particle;
};

/* The sign of a - b for the first difference: of the rows, of x, of y. */
static int by_row(const void *one, const void *other) {
  const struct in_row *a = one, *b = other;
  const double d = a->row != b->row                 ? a->row - b->row
                   : a->particle.x != b->particle.x ? a->particle.x - b->particle.x
                                                    : a->particle.y - b->particle.y;
  return (d > 0) - (d < 0);
}

/* Sorts n particles into rows as high as the largest of them. */
static void sort_in_rows(struct nb_reader *reader, struct nb_particle *particles, size_t n) {
  struct in_row *sorted = calloc(n, sizeof *sorted);
  double height = 0;
  if (!sorted && n) {
    nb_no_memory(reader);
    return;
  }
  for (size_t k = 0; k < n; k++)
    height = fmax(height, 2 * particles[k].radius);
  for (size_t k = 0; k < n; k++)
    sorted[k] = (struct in_row){floor(particles[k].y / height), particles[k]};
  qsort(sorted, n, sizeof *sorted, by_row);
  for (size_t k = 0; k < n; k++)
    particles[k] = sorted[k].particle;
  free(sorted);
}

/* Adds the particles of the file, which begin with the index `first`, to the hash that identifies the saved states of
 * the page. The hash has the name of the file, too, because that is a word of the statement. */
static void hash_particles(struct nb_scene_reading *reading, size_t first) {
  for (size_t k = first; k < reading->scene->particle_count; k++) {
    const struct nb_particle *particle = &reading->scene->particles[k];
    const double numbers[] = {particle->x, particle->y, particle->radius};
    const int words[] = {(int)particle->shape, particle->material, particle->fixed};
    reading->hash = nb_hash(nb_hash(reading->hash, numbers, sizeof numbers), words, sizeof words);
  }
}

/* The hint for a FILE that may be a mistake: a number of particles, `packing discs 25 rock`, asks for a random packing, and
 * a material alone has no file. NULL: neither. */
static const char *not_a_file(const struct nb_scene *scene, const struct nb_reader *reader, const char *file) {
  for (size_t k = 1; k < reader->count; k++)
    if (strspn(reader->tokens[k].text, "0123456789") == strlen(reader->tokens[k].text))
      return NB_RANDOM_PACKING;
  return NB_FIND(scene->materials, scene->material_count, file) >= 0
             ? "this is a material; the statement is `packing FILE discs MATERIAL`"
             : NULL;
}

NB_APPLY(apply_packing) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  struct nb_packing one = {.first = scene->particle_count, .line = (int)reader->line};
  const struct nb_token *file = record->value[AT_FILE].token, *of = NULL;
  char path[NB_PATH_SIZE];
  struct nb_particle all = {0};
  nb_file_named(reader, file, not_a_file(scene, reader, file->text), path);
  for (enum nb_shape shape = NB_DISC; shape <= NB_SPHERE; shape++) {
    const struct nb_token *material = record->value[AT_OF + shape].token;
    if (of && material)
      nb_token_mistake(reader, material - 1, "all particles have the same shape and the same material",
                       "expected `discs` or `spheres`, found both");
    else if (material)
      of = material, all = nb_particle_of(reader, scene, shape, material, false, 0);
  }
  if (!reader->bad)
    (is_state(path) ? from_state : from_list)(scene, reader, file, path, of ? &all : NULL);
  one.count = scene->particle_count - one.first;
  if (!reader->bad && record->value[AT_SORTED].token)
    sort_in_rows(reader, scene->particles + one.first, one.count);
  one.path = reader->bad ? NULL : malloc(strlen(path) + 1);
  if (!one.path) {
    if (!reader->bad)
      nb_no_memory(reader);
    return;
  }
  strcpy(one.path, path);
  if (!NB_APPEND(reader, scene->packings, scene->packing_count, one))
    free(one.path);
  hash_particles(reading, one.first);
}

/* clang-format off */
NB_STATEMENTS(packing) = {
  {"packing", NB_IN_SCENE | NB_OWN_EXAMPLE, packing_fields, NULL, 0, false, apply_packing,
   "Adds the particles of a file, in the order of the file. They are at rest, and their contacts have no history. `nineball --help start` says where the program searches for the file. There are two kinds of files. A file that `nineball state` has written (docs/STATE.md) gives shape, position, radius, material by its name, and whether a particle is fixed, to the last bit. With `discs` or `spheres` all its particles are free, of that shape and that material. The other kind is a list, which needs `discs` or `spheres`. It has a head line with columns `x/m`, `y/m` and `radius/m`, in any unit of length, and a line for each particle. Columns are separated by tabs or by spaces. Other columns, and lines that begin with `#`, are ignored. The file STAGE-particles.tsv of a stage with `snapshot` is such a list.",
   "material  rock  density 2000 kg/m3  kn 1 MN/m\npacking   heap.state\npacking   heap.tsv discs rock sorted\npacking   heap.tsv spheres rock"},
  {0},
};
/* clang-format on */
