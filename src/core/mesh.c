/* All boxes of one width as an array: creation.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "mesh.h"

#include <stdlib.h>
#include <string.h>

#include "model.h"

/* The outermost boxes that contain a point. Their coordinates, in box widths, are integers that a double represents
 * exactly. */
struct extent {
  double left, right, bottom, top;
};

static struct extent extent_of(struct nb_mesh_points points, double width) {
  const struct nb_vec *x = points.x;
  struct extent it = {INFINITY, -INFINITY, INFINITY, -INFINITY};
  for (size_t i = 0; i < points.count; i++) {
    it.left = x[i].x < it.left ? x[i].x : it.left, it.right = x[i].x > it.right ? x[i].x : it.right;
    it.bottom = x[i].y < it.bottom ? x[i].y : it.bottom, it.top = x[i].y > it.top ? x[i].y : it.top;
  }
  return (struct extent){floor(it.left / width), floor(it.right / width), floor(it.bottom / width),
                         floor(it.top / width)};
}

/* Largest number of boxes per item; a search takes time for empty boxes too. */
static const double most_boxes = 4;
/* Largest coordinate, in box widths; it is far below 2^53, beyond which grid.h cannot distinguish boxes. */
static const double farthest = 0x1p50;

static bool fits(struct extent it, size_t items) {
  return it.left > -farthest && it.bottom > -farthest && it.right < farthest && it.top < farthest &&
         (it.right - it.left + 3) * (it.top - it.bottom + 3) <= most_boxes * (double)items;
}

/* Sorts the points into the boxes of the extent: counts the items of each box, sums the counts, and places the items.
 * `box`: memory for the box of each point. */
static void sort_items(struct nb_mesh *mesh, const struct nb_model *model, struct nb_mesh_points points, double width,
                       struct extent extent, size_t boxes, int box[]) {
  for (size_t i = 0; i < mesh->count; i++) {
    const struct nb_vec x = points.x[i];
    box[i] = ((int)(floor(x.y / width) - extent.bottom) + 1) * mesh->row + (int)(floor(x.x / width) - extent.left) + 1;
    mesh->start[box[i]]++;
  }
  int sum = 0;
  for (size_t b = 0; b <= boxes; b++) {
    const int here = mesh->start[b];
    mesh->start[b] = sum, sum += here;
  }
  for (size_t i = 0; i < mesh->count; i++) {
    const int slot = points.slot ? points.slot[i] : (int)i;
    const double radius = model->particles.radius[nb_mesh_particle(slot)];
    mesh->item[mesh->start[box[i]]++] = (struct nb_mesh_item){points.x[i], radius, slot, box[i]};
  }
  memmove(mesh->start + 1, mesh->start, boxes * sizeof *mesh->start);
  mesh->start[0] = 0;
}

bool nb_mesh_create(struct nb_mesh *mesh, const struct nb_model *model, struct nb_mesh_points points, double width) {
  const struct extent extent = extent_of(points, width);
  *mesh = (struct nb_mesh){0};
  if (!fits(extent, points.count))
    return true;
  mesh->count = points.count;
  mesh->row = (int)(extent.right - extent.left) + 3;
  const size_t boxes = (size_t)mesh->row * ((size_t)(extent.top - extent.bottom) + 3);
  mesh->start = nb_array(boxes + 1, sizeof *mesh->start);
  mesh->item = nb_array(mesh->count, sizeof *mesh->item);
  int *box = nb_array(mesh->count, sizeof *box);
  const bool made = mesh->start && mesh->item && box;
  if (made)
    sort_items(mesh, model, points, width, extent, boxes, box);
  free(box);
  return made;
}

void nb_mesh_free(struct nb_mesh *mesh) { free(mesh->start), free(mesh->item); }
