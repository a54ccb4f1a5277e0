/* Random packings: particles of a grading, placed one after the other without overlap.
 *
 * The largest size comes first. A centre is drawn from a uniform distribution over the positions at which the whole
 * particle is inside the circle or the box, or over the whole periodic cell. In a cell the particle may not overlap an
 * image of another particle either, so the packing has no edge. If the particle would overlap a placed particle,
 * another centre is drawn, up to `attempts` times per particle. If all attempts fail, `else stop` ends the filling,
 * like R89's old generator (R89, section 6.4.1), and `else skip` continues with the next smaller size, like R89's new
 * generator (R89, section 4.4).
 *
 * There are no initial contacts (R89, section 6.4): the distance d of two centres, m, and the radii R_x and R_y, m,
 * satisfy d^2 >= (R_x + R_y)^2 for the stored positions and in rounded arithmetic. The square root is correctly
 * rounded, so the overlap R_x + R_y - d that the force calculation computes is not positive either.
 *
 * A centre in a circle is drawn by rejection from the surrounding square, which needs only + - * /. So, with
 * SplitMix64, the positions have the same bits on every machine.
 *
 * The particles are in a grid with levels by size (core/grid.h). So no box of the grid contains many of them, however
 * wide the grading is.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "core/array.h"
#include "core/grid.h"
#include "packing.h"
#include "random_numbers.h"

/* x shifted by whole periods into the period that begins at `from`; x unchanged if the period is 0. */
static double wrapped(double x, double from, double period) {
  return period > 0 ? x - period * floor((x - from) / period) : x;
}

/* Adds a particle to the grid; in a periodic cell, its image in the cell. */
static void grid_add(struct nb_grid *grid, const struct nb_fill *fill, const struct nb_particle *particle,
                     size_t index) {
  const struct nb_vec at = {wrapped(particle->x, fill->x, fill->width), wrapped(particle->y, fill->y, fill->height)};
  nb_grid_add(grid, (int)index, at, 2 * particle->radius);
}

static bool grid_create(struct nb_grid *grid, const struct nb_fill *fill, const struct nb_scene *scene,
                        const struct nb_grading *grading) {
  double largest = grading->sizes[0].radius;
  for (size_t k = 0; k < scene->particle_count; k++)
    largest = fmax(largest, scene->particles[k].radius);
  if (!nb_grid_create(grid, scene->particle_count + grading->count, 2 * largest))
    return false;
  for (size_t k = 0; k < scene->particle_count; k++)
    grid_add(grid, fill, &scene->particles[k], k);
  return true;
}

/* True if a overlaps b or, in a cell, the nearest image of b. */
static bool overlap(const struct nb_fill *fill, const struct nb_particle *a, const struct nb_particle *b) {
  const double dx = wrapped(a->x - b->x, -fill->width / 2, fill->width),
               dy = wrapped(a->y - b->y, -fill->height / 2, fill->height), apart = a->radius + b->radius;
  return dx * dx + dy * dy < apart * apart;
}

/* True if the particle with the index `count`, not placed yet, overlaps no particle on one level of the grid. `at`: the
 * position of the particle, or of one of its images, around which to search. */
static bool no_overlap_on_level(const struct nb_grid *grid, int level, const struct nb_fill *fill, struct nb_vec at,
                                const struct nb_particle *particles, size_t count) {
  const struct nb_particle *particle = &particles[count];
  const double range = particle->radius + grid->width[level] / 2;
  const int64_t west = nb_grid_place(grid, level, at.x - range), east = nb_grid_place(grid, level, at.x + range);
  const int64_t south = nb_grid_place(grid, level, at.y - range), north = nb_grid_place(grid, level, at.y + range);
  /* A particle far larger than those of the level may cover more boxes than there are particles. Then all particles are
   * tested. */
  if ((double)(east - west) * (double)(north - south) > (double)count) {
    for (size_t k = 0; k < count; k++)
      if (overlap(fill, particle, &particles[k]))
        return false;
    return true;
  }
  for (int64_t y = south; y <= north; y++)
    for (int64_t x = west; x <= east; x++)
      NB_GRID_FOR_BOX(grid, other, ((struct nb_box){level, x, y}))
  if (overlap(fill, particle, &particles[other]))
    return false;
  return true;
}

/* True if the particle with the index `count`, not placed yet, overlaps no placed particle. */
static bool no_overlap(const struct nb_grid *grid, const struct nb_fill *fill, const struct nb_particle *particles,
                       size_t count) {
  const int images = fill->width > 0; /* 1: also the images next to the cell */
  for (int level = 0; level < NB_GRID_LEVELS; level++)
    for (int x = -images; x <= images && grid->count[level]; x++)
      for (int y = -images; y <= images; y++) {
        const struct nb_vec at = {particles[count].x + x * fill->width, particles[count].y + y * fill->height};
        if (!no_overlap_on_level(grid, level, fill, at, particles, count))
          return false;
      }
  return true;
}

/* Draws the centre of a particle. False if rounding has put the particle across the edge of the box or circle. */
static bool draw_centre(struct nb_particle *particle, const struct nb_fill *fill, struct nb_random *random) {
  const double r = particle->radius;
  if (fill->width > 0) {
    particle->x = fill->x + nb_random_fraction(random) * fill->width;
    particle->y = fill->y + nb_random_fraction(random) * fill->height;
    return true;
  }
  if (!fill->circle) {
    particle->x = fill->x + r + nb_random_fraction(random) * (fill->x1 - fill->x - 2 * r);
    particle->y = fill->y + r + nb_random_fraction(random) * (fill->y1 - fill->y - 2 * r);
    return particle->x - fill->x >= r && fill->x1 - particle->x >= r && particle->y - fill->y >= r &&
           fill->y1 - particle->y >= r;
  }
  double u, v;
  do {
    u = 2 * nb_random_fraction(random) - 1, v = 2 * nb_random_fraction(random) - 1;
  } while (u * u + v * v > 1);
  const double within = fill->radius - r;
  particle->x = fill->x + within * u, particle->y = fill->y + within * v;
  const double dx = particle->x - fill->x, dy = particle->y - fill->y;
  return dx * dx + dy * dy <= within * within;
}

static bool fits(const struct nb_fill *fill, double radius) {
  return fill->circle ? fill->radius >= radius : fill->x1 - fill->x >= 2 * radius && fill->y1 - fill->y >= 2 * radius;
}

/* Places one more particle, a copy of `prototype`; memory for it is reserved. False if all attempts fail. */
static bool place(struct nb_scene *scene, struct nb_fill *fill, struct nb_grid *grid, struct nb_random *random,
                  const struct nb_particle *prototype) {
  struct nb_particle *particle = &scene->particles[scene->particle_count];
  *particle = *prototype;
  for (unsigned long attempt = 0; attempt < fill->attempts; attempt++) {
    fill->attempts_made++;
    if (!draw_centre(particle, fill, random) || !no_overlap(grid, fill, scene->particles, scene->particle_count))
      continue;
    grid_add(grid, fill, particle, scene->particle_count++);
    return true;
  }
  return false;
}

enum nb_fill_result nb_fill_random(struct nb_scene *scene, struct nb_fill *fill, struct nb_particle prototype) {
  struct nb_grading *grading = &scene->gradings[fill->grading];
  struct nb_grid grid = {0};
  struct nb_random random = {fill->seed};
  struct nb_particle *particles =
      nb_array_reserve(scene->particles, scene->particle_count, grading->count, sizeof *particles);
  if (particles)
    scene->particles = particles;
  enum nb_fill_result result = particles && grid_create(&grid, fill, scene, grading) ? NB_FILL_DONE : NB_FILL_NO_MEMORY;
  for (size_t s = 0; s < grading->size_count && result == NB_FILL_DONE; s++) {
    struct nb_size *size = &grading->sizes[s];
    const size_t before = scene->particle_count;
    prototype.radius = size->radius;
    bool placed = fits(fill, prototype.radius);
    while (placed && scene->particle_count - before < size->count)
      placed = place(scene, fill, &grid, &random, &prototype);
    size->wanted += size->count, size->placed += scene->particle_count - before;
    if (!placed && !fill->skip)
      result = NB_FILL_STOPPED;
  }
  nb_grid_free(&grid);
  return result;
}
