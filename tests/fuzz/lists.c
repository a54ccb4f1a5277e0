/* The readers of files that a page names: the points of a path, and the particles of a packing, which is a list or a
 * saved state.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../src/input/columns.h"
#include "../../src/input/reader.h"
#include "../../src/run/state.h"
#include "fuzz.h"

enum { LONGEST = 4096 };

static bool contains(const unsigned char *bytes, size_t size, const char *text) {
  const size_t length = strlen(text);
  for (size_t k = 0; k + length <= size; k++)
    if (memcmp(bytes + k, text, length) == 0)
      return true;
  return false;
}

/* Reads only the columns, because reading the whole page takes longer. */
static bool read_columns(const struct nb_wanted_column *wanted, int count, bool unitless) {
  struct nb_mistakes mistakes = {0};
  double *lengths;
  size_t rows;
  const bool valid = nb_columns_read(&lengths, &rows, fuzz_file(), wanted, count, unitless, &mistakes);
  fuzz_hold_mistakes(&mistakes, valid ? NB_OK : NB_BAD_USE);
  fuzz_hold(!valid || rows > 0, "a list has rows");
  for (size_t k = 0; valid && k < (size_t)count * rows; k++)
    fuzz_hold(isfinite(lengths[k]) && (lengths[k] > 0 || !wanted[k % (size_t)count].positive),
              "lengths are finite and in range");
  free(lengths), nb_mistakes_free(&mistakes);
  return valid;
}

/* Reads a page that names the file; `format` has its statements, with %s for the path. */
static bool read_with(struct nb_page *page, const char *format, struct nb_scene *scene) {
  struct nb_mistakes mistakes = {0};
  const char *const path = fuzz_file();
  if (!page->lines) {
    char statements[1500 + NB_PATH_SIZE];
    snprintf(statements, sizeof statements, format, path);
    fuzz_read_page(page, NULL, "fuzz.md", statements);
  }
  const enum nb_status status = nb_scene_read(scene, page, 0, NULL, &mistakes);
  fuzz_hold_mistakes(&mistakes, status);
  nb_mistakes_free(&mistakes);
  return status == NB_OK;
}

/* ---- paths ---- */

static bool read_path(const unsigned char *bytes, size_t size) {
  static const char *const formats[] = {
      "```contact-test\nmaterial m young 5 kPa poisson 0.2 friction 0.3\ncontact sphere 1 m m with wall m\n"
      "normal hertz\nshear mindlin_deresiewicz\nsegment a follow %s\n",
      "```contact-test\nunits none\nmaterial m kn 10 ks 5 friction 0.3\ncontact disc 1 m with disc 2 m\n"
      "segment a follow %s\n"};
  static struct nb_page pages[2];
  const bool unitless = contains(bytes, size, "/-");
  static const struct nb_wanted_column wanted[] = {{"approach", "overlap", false}, {"slip", NULL, false}};
  struct nb_scene scene;
  if (!fuzz_one_of(32))
    return read_columns(wanted, 2, unitless);
  const bool valid = read_with(&pages[unitless], formats[unitless], &scene);
  if (valid) {
    const struct nb_segment *segment = &scene.stages[0].segment;
    fuzz_hold(segment->point_count > 0 && scene.stages[0].cycles == segment->point_count, "a path has points");
    for (size_t k = 0; k < segment->point_count; k++)
      fuzz_hold(isfinite(segment->points[k].approach) && isfinite(segment->points[k].slip), "points are finite");
  }
  nb_scene_free(&scene);
  return valid;
}

static size_t seed_path(size_t k, char *text) {
  static const char *const seeds[] = {"# a comment\napproach/mm\tslip/um\n0.1\t0\n1e-1\t-20.5\n\n0\t0\n",
                                      "slip/m cycle overlap/cm\n0 1 1\n 0.5  2 -3e-2\n",
                                      "overlap/-\tslip/-\n0.1\t0\n0.2\t0.1\n", "approach/nm slip/km\r\n1 2\r\n"};
  return k < sizeof seeds / sizeof *seeds ? (size_t)sprintf(text, "%s", seeds[k]) : 0;
}

const struct fuzz_reader fuzz_paths = {"paths", LONGEST, 3000, read_path, seed_path};

/* ---- packings ---- */

static bool read_packing(const unsigned char *bytes, size_t size) {
  static const char *const formats[] = {
      "```scene\nmaterial m density 3 kg/m3 kn 10 N/m\npacking %s discs m\nstep 1 us\nstage a\ncycles 1\n",
      "```scene\nunits none\nmaterial m density 3 kn 10\npacking %s spheres m\nstep 1\nstage a\ncycles 1\n",
      "```scene\nunits none\nmaterial m density 3 kn 10\nmaterial n kn 1\npacking %s\nstep 1\nstage a\ncycles 1\n"};
  static struct nb_page pages[3];
  static const char head[] = "nineball state";
  char state[LONGEST + FUZZ_END];
  const bool is_state = size >= strlen(head) && memcmp(bytes, head, strlen(head)) == 0;
  const int kind = is_state ? 2 : contains(bytes, size, "/-");
  static const struct nb_wanted_column wanted[] = {{"x", NULL, false}, {"y", NULL, false}, {"radius", NULL, true}};
  struct nb_scene scene;
  if (!is_state && !fuzz_one_of(32))
    return read_columns(wanted, 3, kind);
  if (is_state) {
    memcpy(state, bytes, size);
    fuzz_begin(state, fuzz_seal(state, size));
  }
  const bool valid = read_with(&pages[kind], formats[kind], &scene);
  for (size_t k = 0; valid && k < scene.particle_count; k++) {
    const struct nb_particle *it = &scene.particles[k];
    fuzz_hold(isfinite(it->x) && isfinite(it->y) && isfinite(it->radius), "the numbers of a particle are finite");
    fuzz_hold(it->radius > 0 && (size_t)it->material < scene.material_count, "a particle has a size and a material");
  }
  fuzz_hold(!valid || scene.particle_count > 0, "a scene has particles");
  nb_scene_free(&scene);
  return valid;
}

static size_t seed_packing(size_t k, char *text) {
  static const char *const seeds[] = {"# made by hand\nx/mm\ty/mm\tradius/mm\n0\t0\t10\n20\t0\t10\n\n1e1\t17.3\t9.99\n",
                                      "radius/um z/um y/m x/m\n10 7 0 0\n  20  7 0.5 -0.25\n30 7 1e-3 2\n",
                                      "x/-\ty/-\tradius/-\n0\t0\t1\n2\t0\t1\n"};
  const size_t lists = sizeof seeds / sizeof *seeds;
  if (k < lists)
    return (size_t)sprintf(text, "%s", seeds[k]);
  return k == lists ? fuzz_states.seed(0, text) : 0;
}

const struct fuzz_reader fuzz_packings = {"packings", LONGEST, 3000, read_packing, seed_packing};
