/* Random packings: bodies of a grading, one after the other, each where none of those before it is.
 *
 * Largest first. A centre is drawn evenly over the places where the body lies wholly inside the circle or the box; when it
 * would overlap a body that is there, another one is drawn, up to `tries` for each body. When none will do, the old
 * generator stops (R89, section 6.4.1), and the new one goes on with the next smaller size (R89, section 4.4).
 *
 * No initial contacts (R89, section 6.4): d^2 >= (R_x + R_y)^2 as rounded, of the very positions that the scene gets. The root is
 * rounded correctly, so R_x + R_y - d is not above 0 there either.
 *
 * A circle is filled by drawing from the square about it and leaving out its corners, which takes + - x / alone. With
 * SplitMix64 the positions are the same bits on every machine.
 *
 * Bodies lie in layers by size, each with radii within a factor of two and a grid of its own, so that a cell never holds
 * many, however wide the grading.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>

#include "core/array.h"
#include "packing.h"
#include "random.h"

enum { LAYERS = 24 }; /* the last one has all that is smaller */

struct layer {
  double top;          /* m, the largest radius in it */
  size_t count;        /* of bodies that it may come to have; 0: there is no grid */
  size_t nx, ny;       /* cells */
  double per_x, per_y; /* cells a metre */
  int *first;          /* of each cell: the body that came last, 0: none; from there on by `next`; owned */
};

struct packing {
  double x, y, width, height; /* m, the south-west corner and the size of what the grids cover */
  double largest;             /* m */
  struct layer layers[LAYERS];
  int *next; /* of each body of the scene; owned */
};

static struct layer *layer_of(struct packing *packing, double radius) {
  size_t l = 0;
  for (double top = packing->largest / 2; l < LAYERS - 1 && radius <= top; top /= 2)
    l++;
  return &packing->layers[l];
}

/* Rises with x, so that what lies within a reach is found between the cells of its two ends, rounded as they may be. What
 * lies outside belongs to the cells at the edge. */
static size_t cell(double from, double per, size_t n, double x) {
  const double t = (x - from) * per;
  return !(t > 0) ? 0 : t < (double)n ? (size_t)t : n - 1;
}

static size_t column(const struct packing *packing, const struct layer *layer, double x) {
  return cell(packing->x, layer->per_x, layer->nx, x);
}
static size_t row(const struct packing *packing, const struct layer *layer, double y) {
  return cell(packing->y, layer->per_y, layer->ny, y);
}

static void add(struct packing *packing, const struct nb_body *body, size_t index) {
  struct layer *layer = layer_of(packing, body->radius);
  int *first = &layer->first[row(packing, layer, body->y) * layer->nx + column(packing, layer, body->x)];
  packing->next[index] = *first;
  *first = (int)index + 1;
}

static size_t cells(double x, size_t most) { return !(x > 1) ? 1 : x < (double)most ? (size_t)x : most; }

/* As many cells as bodies at most, none smaller than the largest of them. */
static bool make_grid(const struct packing *packing, struct layer *layer) {
  const double side = fmax(2 * layer->top, sqrt(packing->width * packing->height / (double)layer->count));
  layer->nx = cells(packing->width / side, layer->count);
  layer->ny = cells(packing->height / side, layer->count);
  layer->per_x = (double)layer->nx / packing->width, layer->per_y = (double)layer->ny / packing->height;
  return (layer->first = calloc(layer->nx * layer->ny, sizeof *layer->first)) != NULL;
}

static void count(struct packing *packing, double radius, size_t bodies) {
  struct layer *layer = layer_of(packing, radius);
  layer->count += bodies, layer->top = fmax(layer->top, radius);
}

static bool begin(struct packing *packing, const struct nb_scene *scene, const struct nb_fill *fill) {
  const struct nb_grading *grading = &scene->gradings[fill->grading];
  packing->x = fill->circle ? fill->x - fill->radius : fill->x;
  packing->y = fill->circle ? fill->y - fill->radius : fill->y;
  packing->width = fill->circle ? 2 * fill->radius : fill->x1 - fill->x;
  packing->height = fill->circle ? 2 * fill->radius : fill->y1 - fill->y;
  packing->largest = grading->sizes[0].radius;
  for (size_t k = 0; k < scene->body_count; k++)
    packing->largest = fmax(packing->largest, scene->bodies[k].radius);
  for (size_t k = 0; k < scene->body_count; k++)
    count(packing, scene->bodies[k].radius, 1);
  for (size_t s = 0; s < grading->size_count; s++)
    count(packing, grading->sizes[s].radius, grading->sizes[s].count);
  bool made = (packing->next = calloc(scene->body_count + grading->count, sizeof *packing->next)) != NULL;
  for (int l = 0; l < LAYERS && made; l++)
    made = packing->layers[l].count == 0 || make_grid(packing, &packing->layers[l]);
  for (size_t k = 0; k < scene->body_count && made; k++)
    add(packing, &scene->bodies[k], k);
  return made;
}

static void end(struct packing *packing) {
  for (int l = 0; l < LAYERS; l++)
    free(packing->layers[l].first);
  free(packing->next);
}

static bool overlap(const struct nb_body *a, const struct nb_body *b) {
  const double dx = a->x - b->x, dy = a->y - b->y, apart = a->radius + b->radius;
  return dx * dx + dy * dy < apart * apart;
}

static bool is_free(const struct packing *packing, const struct nb_body *bodies, const struct nb_body *body) {
  for (int l = 0; l < LAYERS; l++) {
    const struct layer *layer = &packing->layers[l];
    if (layer->count == 0)
      continue;
    const double reach = body->radius + layer->top;
    const size_t west = column(packing, layer, body->x - reach), east = column(packing, layer, body->x + reach);
    const size_t south = row(packing, layer, body->y - reach), north = row(packing, layer, body->y + reach);
    for (size_t y = south; y <= north; y++)
      for (size_t x = west; x <= east; x++)
        for (int other = layer->first[y * layer->nx + x]; other; other = packing->next[other - 1])
          if (overlap(body, &bodies[other - 1]))
            return false;
  }
  return true;
}

/* Draws a centre; false when rounding has put the body across the edge. */
static bool draw(struct nb_body *body, const struct nb_fill *fill, struct nb_random *random) {
  const double r = body->radius;
  if (!fill->circle) {
    body->x = fill->x + r + nb_random_share(random) * (fill->x1 - fill->x - 2 * r);
    body->y = fill->y + r + nb_random_share(random) * (fill->y1 - fill->y - 2 * r);
    return body->x - fill->x >= r && fill->x1 - body->x >= r && body->y - fill->y >= r && fill->y1 - body->y >= r;
  }
  double u, v;
  do {
    u = 2 * nb_random_share(random) - 1, v = 2 * nb_random_share(random) - 1;
  } while (u * u + v * v > 1);
  const double within = fill->radius - r;
  body->x = fill->x + within * u, body->y = fill->y + within * v;
  const double dx = body->x - fill->x, dy = body->y - fill->y;
  return dx * dx + dy * dy <= within * within;
}

static bool fits(const struct nb_fill *fill, double radius) {
  return fill->circle ? fill->radius >= radius : fill->x1 - fill->x >= 2 * radius && fill->y1 - fill->y >= 2 * radius;
}

/* One more body, in the room that is there for it behind the last one. */
static bool place(struct nb_scene *scene, struct nb_fill *fill, struct packing *packing, struct nb_random *random,
                  const struct nb_body *like) {
  struct nb_body *body = &scene->bodies[scene->body_count];
  *body = *like;
  for (unsigned long tried = 0; tried < fill->tries; tried++) {
    fill->made++;
    if (!draw(body, fill, random) || !is_free(packing, scene->bodies, body))
      continue;
    add(packing, body, scene->body_count++);
    return true;
  }
  return false;
}

enum nb_filled nb_fill_random(struct nb_scene *scene, struct nb_fill *fill, struct nb_body like) {
  struct nb_grading *grading = &scene->gradings[fill->grading];
  struct packing packing = {0};
  struct nb_random random = {fill->seed};
  struct nb_body *bodies = nb_room(scene->bodies, scene->body_count, grading->count, sizeof *bodies);
  if (bodies)
    scene->bodies = bodies;
  enum nb_filled filled = bodies && begin(&packing, scene, fill) ? NB_FILLED : NB_FILL_NO_MEMORY;
  for (size_t s = 0; s < grading->size_count && filled == NB_FILLED; s++) {
    struct nb_size *size = &grading->sizes[s];
    const size_t before = scene->body_count;
    like.radius = size->radius;
    bool placed = fits(fill, like.radius);
    while (placed && scene->body_count - before < size->count)
      placed = place(scene, fill, &packing, &random, &like);
    size->wanted += size->count, size->placed += scene->body_count - before;
    if (!placed && !fill->skip)
      filled = NB_FILL_STOPPED;
  }
  end(&packing);
  return filled;
}
