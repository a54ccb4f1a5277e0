/* Snapshots: tables of all particles, walls and contacts at one time, and of the rings of regions.
 *
 *   rings   porosity of each ring about the region's centre, and of the circle inside its outer radius [R89 figure 6.5]
 *
 * Each table is a list of columns with name, unit and value.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "snapshot.h"

#include <string.h>

#include "areas.h"
#include "boundary.h"
#include "configuration.h"
#include "region.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

bool nb_snapshot_table(struct nb_table *table, const struct nb_scene *scene, const struct nb_table_column columns[],
                       size_t count) {
  if (!nb_table_create(table, count))
    return false;
  for (size_t c = 0; c < count; c++) {
    strcpy(table->names[c], columns[c].name);
    table->units[c] = scene->unitless ? "-" : columns[c].unit;
  }
  return true;
}

bool nb_snapshot_row(struct nb_table *table, const struct nb_model *model, int stage, const double values[]) {
  double *row = nb_table_row(table, stage, (double)model->cycle, model->time);
  if (row)
    memcpy(row, values, table->column_count * sizeof *row);
  return row;
}

/* The columns of particles. The last three exist only with `from`. */
#define PARTICLE(COLUMN)                                                                                               \
  COLUMN("particle", "1", (double)k + 1)                                                                               \
  COLUMN("x", "m", x.x)                                                                                                \
  COLUMN("y", "m", x.y)                                                                                                \
  COLUMN("radius", "m", particles->radius[i])                                                                          \
  COLUMN("angle", "rad", particles->angle ? particles->angle[i] : 0)                                                   \
  COLUMN("vx", "m/s", v.x)                                                                                             \
  COLUMN("vy", "m/s", v.y)                                                                                             \
  COLUMN("fx", "N", force.force.x)                                                                                     \
  COLUMN("fy", "N", force.force.y)                                                                                     \
  COLUMN("moment", "N.m", force.moment)                                                                                \
  COLUMN("spin", "rad/s", nb_velocity_now(model, i).spin)                                                              \
  COLUMN("contacts", "1", nb_coordination_number(&model->contacts, i))                                                 \
  COLUMN("fixed", "1", !(particles->inverse_mass[i] > 0))                                                              \
  COLUMN("moved_x", "m", moved.x)                                                                                      \
  COLUMN("moved_y", "m", moved.y)                                                                                      \
  COLUMN("turned", "rad", from < 0 ? 0 : nb_configuration_rotation(model, from, i))

static bool particles_table(struct nb_table *table, const struct nb_model *model, int stage) {
  static const struct nb_table_column columns[] = {PARTICLE(NB_TABLE_COLUMN)};
  const int from = model->scene->stages[stage].snapshot_from;
  const struct nb_particles *particles = &model->particles;
  bool complete = nb_snapshot_table(table, model->scene, columns, COUNT(columns) - (from < 0 ? 3 : 0));
  for (size_t k = 0; complete && k < particles->count; k++) {
    const size_t i = (size_t)particles->slot[k];
    if (nb_removed(model, i))
      continue;
    const struct nb_vec x = nb_cell_wrapped_position(model, i), v = nb_velocity_total(model, i);
    const struct nb_force force = nb_force_on(model, i);
    const struct nb_vec moved = from < 0 ? vec(0, 0) : nb_configuration_displacement(model, from, i);
    complete = nb_snapshot_row(table, model, stage, (const double[]){PARTICLE(NB_VALUE)});
  }
  return complete;
}

static bool walls_table(struct nb_table *table, const struct nb_model *model, int stage) {
  static const struct nb_table_column columns[] = {{"wall", "1"}, {"x1", "m"}, {"y1", "m"}, {"x2", "m"}, {"y2", "m"}};
  bool complete = nb_snapshot_table(table, model->scene, columns, COUNT(columns));
  for (size_t w = 0; complete && w < model->walls.count; w++) {
    if (nb_wall_removed(&model->walls, w))
      continue;
    const struct nb_vec from = nb_wall_end(&model->walls, (int)w, 0), to = nb_wall_end(&model->walls, (int)w, 1);
    complete = nb_snapshot_row(table, model, stage, (const double[]){(double)w + 1, from.x, from.y, to.x, to.y});
  }
  return complete;
}

/* The columns of contacts that touch. For a contact with a wall, b is 0 and `wall` is the number of the wall, from 1.
 * x, y is the point half-way between the two outlines [CS79 figure 1]. ra, rb are the radii (0 for a wall), fx, fy the
 * elastic force on the first particle, and angle is the direction of e. radius is the radius of the contact circle, and
 * ratio this radius over that of the smaller particle. limit is mu F_n + c, and obliquity is |F_s| over limit. The last
 * column exists only with `from`. */
#define CONTACT(COLUMN)                                                                                                \
  COLUMN("a", "1", particles->number[i])                                                                               \
  COLUMN("b", "1", wall ? 0 : particles->number[b])                                                                    \
  COLUMN("wall", "1", wall ? b + 1 : 0)                                                                                \
  COLUMN("x", "m", x.x + arm * e.x)                                                                                    \
  COLUMN("y", "m", x.y + arm * e.y)                                                                                    \
  COLUMN("ra", "m", particles->radius[i])                                                                              \
  COLUMN("rb", "m", wall ? 0 : particles->radius[b])                                                                   \
  COLUMN("ex", "1", e.x)                                                                                               \
  COLUMN("ey", "1", e.y)                                                                                               \
  COLUMN("overlap", "m", overlap)                                                                                      \
  COLUMN("normal", "N", normal)                                                                                        \
  COLUMN("shear", "N", shear)                                                                                          \
  COLUMN("sliding", "1", load.sliding)                                                                                 \
  COLUMN("fx", "N", -(normal * e.x + shear * t.x))                                                                     \
  COLUMN("fy", "N", -(normal * e.y + shear * t.y))                                                                     \
  COLUMN("angle", "rad", atan2(e.y, e.x))                                                                              \
  COLUMN("radius", "m", load.radius)                                                                                   \
  COLUMN("normal_stress", "Pa", load.pressure)                                                                         \
  COLUMN("shear_stress", "Pa", load.traction)                                                                          \
  COLUMN("ratio", "1", load.ratio)                                                                                     \
  COLUMN("limit", "N", load.limit)                                                                                     \
  COLUMN("obliquity", "1", load.obliquity)                                                                             \
  COLUMN("slid", "m", from < 0 ? 0 : nb_configuration_slip(model, from, c))

static bool contacts_table(struct nb_table *table, const struct nb_model *model, int stage) {
  static const struct nb_table_column columns[] = {CONTACT(NB_TABLE_COLUMN)};
  const int from = model->scene->stages[stage].snapshot_from;
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_particles *particles = &model->particles;
  bool complete = nb_snapshot_table(table, model->scene, columns, COUNT(columns) - (from < 0));
  for (size_t c = 0; complete && c < contacts->count; c++) {
    if (!nb_touches(contacts, c))
      continue;
    const double overlap = contacts->kept[NB_OVERLAP][c], normal = contacts->kept[NB_NORMAL][c];
    const bool wall = nb_with_wall(model, c);
    const int i = contacts->a[c], b = contacts->b[c];
    const struct nb_vec e = vec(contacts->kept[NB_EX][c], contacts->kept[NB_EY][c]), t = vec_clockwise(e);
    const double shear = model->material_pairs[contacts->material_pair[c]].shear ? contacts->kept[NB_SHEAR][c] : 0;
    const struct nb_contact_load load = nb_contact_load(model, c);
    const struct nb_vec x = nb_cell_wrapped_position(model, (size_t)i);
    const double arm = particles->radius[i] - overlap / 2;
    complete = nb_snapshot_row(table, model, stage, (const double[]){CONTACT(NB_VALUE)});
  }
  return complete;
}

/* Area that particles cover inside a circle about the region's centre, m2. */
static double covered_area(const struct nb_model *model, const struct nb_region_state *region, double radius) {
  double area = 0;
  for (size_t k = 0; k < model->particles.count; k++) {
    const size_t i = (size_t)model->particles.slot[k];
    if (!nb_removed(model, i))
      area += nb_area_of_lens(model->particles.radius[i], radius,
                              vec_length(vec_sub(nb_region_position(model, region, i), region->centre)));
  }
  return area;
}

static bool rings_table(struct nb_table *table, const struct nb_model *model, int stage) {
  static const struct nb_table_column columns[] = {
      {"region", "1"}, {"inner", "m"}, {"outer", "m"}, {"porosity", "1"}, {"within", "1"}};
  bool complete = nb_snapshot_table(table, model->scene, columns, COUNT(columns));
  for (size_t r = 0; r < model->scene->region_count; r++) {
    const struct nb_region_state *region = nb_region_state(model, (int)r);
    const int rings = region->definition->rings;
    double inner = 0, before = 0;
    for (int k = 1; complete && k <= rings; k++) {
      const double outer = region->radius * k / rings, now = covered_area(model, region, outer);
      const double all = nb_area_of_disc(outer), ring = all - nb_area_of_disc(inner);
      complete = nb_snapshot_row(
          table, model, stage, (const double[]){(double)r + 1, inner, outer, 1 - (now - before) / ring, 1 - now / all});
      inner = outer, before = now;
    }
  }
  return complete;
}

static bool boundary_table(struct nb_table *table, const struct nb_model *model, int stage) {
  static const struct nb_table_column columns[] = {{"particle", "1"}, {"x", "m"}, {"y", "m"}};
  const struct nb_ring *ring = &model->boundary->ring;
  bool complete = nb_snapshot_table(table, model->scene, columns, COUNT(columns));
  for (size_t k = 0; complete && k < ring->count; k++) {
    const size_t i = (size_t)ring->member[k];
    const struct nb_vec x = model->particles.position[i];
    complete = nb_snapshot_row(table, model, stage, (const double[]){model->particles.number[i], x.x, x.y});
  }
  return complete;
}

bool nb_snapshot_take(struct nb_snapshot *snapshot, const struct nb_model *model, int stage) {
  const int from = model->scene->stages[stage].snapshot_from;
  *snapshot = (struct nb_snapshot){.stage = stage};
  return particles_table(&snapshot->particles, model, stage) && walls_table(&snapshot->walls, model, stage) &&
         contacts_table(&snapshot->contacts, model, stage) &&
         (!nb_boundary_exists(model) || boundary_table(&snapshot->boundary, model, stage)) &&
         (from < 0 || nb_configuration_lattice(&snapshot->lattice, model, stage, from)) &&
         (!model->regions || rings_table(&snapshot->rings, model, stage));
}

static const struct {
  const char *name;
  size_t at;
} parts[] = {
    {"particles", offsetof(struct nb_snapshot, particles)}, {"walls", offsetof(struct nb_snapshot, walls)},
    {"contacts", offsetof(struct nb_snapshot, contacts)},   {"rings", offsetof(struct nb_snapshot, rings)},
    {"boundary", offsetof(struct nb_snapshot, boundary)},   {"lattice", offsetof(struct nb_snapshot, lattice)},
    {"traction", offsetof(struct nb_snapshot, traction)},   {"pieces", offsetof(struct nb_snapshot, pieces)},
};

struct nb_table *nb_snapshot_table_at(struct nb_snapshot *snapshot, size_t index) {
  return index < COUNT(parts) ? (struct nb_table *)(void *)((char *)snapshot + parts[index].at) : NULL;
}

void nb_snapshot_free(struct nb_snapshot *snapshot) {
  struct nb_table *table;
  for (size_t k = 0; (table = nb_snapshot_table_at(snapshot, k)); k++)
    nb_table_free(table);
}

bool nb_snapshot_part(const struct nb_snapshot *snapshot, int part, const char **name, const struct nb_table **table) {
  for (size_t k = 0; k < COUNT(parts); k++) {
    *table = (const struct nb_table *)(const void *)((const char *)snapshot + parts[k].at), *name = parts[k].name;
    if ((*table)->names && part-- == 0)
      return true;
  }
  return false;
}
