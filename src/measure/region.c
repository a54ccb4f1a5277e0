/* Regions: particles inside, area, thickness, porosity, and contact ends.
 *
 * A particle is inside a region if its centre is. The thickness, normal to the plane, is the mean over all particles of
 * the scene: a sphere counts with its diameter [R89 sec. 4.4], a disc with 1 m.
 *
 *   areal       n = 1 - sum A_p/A                   A_p  exact area of a particle's part in the region, m2
 *                                               A    area of the region, m2
 *   volume      n = 1 - sum V_p (A_p/pi R^2)/(A s)  V_p  4/3 pi R^3 or pi R^2 times 1 m, m3; s  thickness, m
 *   void_ratio  e = n/(1 - n), of the areal porosity
 *
 * The area of an overlap counts for both particles, so with large overlaps the porosity is smaller than the uncovered
 * fraction of the plane. The volume of a sphere at the region's edge counts with the fraction of its area that is
 * inside.
 *
 * `inside F` is the circle about the boundary's centre with F times the boundary's current mean radius. `all` is the
 * periodic cell; without a cell it is the bounding box of all particles along the page's axes, which `transform`
 * rotates with the scene.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "region.h"

#include <stdlib.h>

#include "areas.h"
#include "boundary.h"

enum nb_status nb_regions_create(struct nb_model *model, struct nb_error *error) {
  const struct nb_scene *scene = model->scene;
  if (scene->region_count == 0)
    return NB_OK;
  struct nb_regions *regions = model->regions = calloc(1, sizeof *regions);
  if (regions) {
    regions->list = nb_array(scene->region_count, sizeof *regions->list);
    regions->touching = nb_array(model->particles.count, sizeof(int));
    regions->queue = nb_array(model->particles.count, sizeof(int));
  }
  const bool chains = model->plan.requested & NB_REQUEST_CHAINS;
  if (!regions || !regions->list || !regions->touching || !regions->queue || (chains && !nb_chains_create(model)))
    return nb_error_memory(error);
  for (size_t r = 0; r < scene->region_count; r++)
    regions->list[r].definition = &scene->regions[r];
  return NB_OK;
}

void nb_regions_free(struct nb_regions *regions, size_t count) {
  if (!regions)
    return;
  for (size_t r = 0; r < count && regions->list; r++)
    free(regions->list[r].reference_position), free(regions->list[r].reference_pairs.list);
  free(regions->list), free(regions->touching), free(regions->queue), free(regions->chain_particles);
  free(regions);
}

enum nb_status nb_regions_stage(struct nb_model *model, int stage, struct nb_error *error) {
  for (size_t r = 0; model->regions && r < model->scene->region_count; r++) {
    struct nb_region_state *region = &model->regions->list[r];
    region->placed_cycle = 0;
    for (int k = 0; k < NB_MEASURES; k++)
      region->measured[k] = 0;
  }
  if (!model->regions || nb_strain_begin(model, stage, error))
    return model->regions ? error->status : NB_OK;
  return nb_changed_contacts_begin(model, stage, error);
}

/* ---- geometry ---- */

/* Sets the geometry of a rectangle. `along`: unit vector along its width; `half`: half its width and height, m. */
static void box(struct nb_region_state *now, struct nb_vec centre, struct nb_vec along, struct nb_vec half) {
  const struct nb_vec left = vec(-along.y, along.x);
  const struct nb_vec east = vec_scale(half.x, along), north = vec_scale(half.y, left);
  now->centre = centre, now->radius = 0;
  now->corners[0] = vec_sub(vec_sub(centre, east), north);
  now->corners[1] = vec_sub(vec_add(centre, east), north);
  now->corners[2] = vec_add(vec_add(centre, east), north);
  now->corners[3] = vec_add(vec_sub(centre, east), north);
  now->area = 4 * half.x * half.y;
}

/* Area of the smallest rectangle around all particles whose width is along `along`, m2. */
static double bounding_area(const struct nb_model *model, struct nb_vec along) {
  const struct nb_particles *particles = &model->particles;
  const struct nb_vec left = vec(-along.y, along.x);
  struct nb_vec low = vec(INFINITY, INFINITY), high = vec(-INFINITY, -INFINITY);
  for (size_t i = 0; i < particles->count; i++) {
    if (nb_removed(model, i))
      continue;
    const struct nb_vec x = vec(vec_dot(particles->position[i], along), vec_dot(particles->position[i], left));
    const double r = particles->radius[i];
    low = vec(x.x - r < low.x ? x.x - r : low.x, x.y - r < low.y ? x.y - r : low.y);
    high = vec(x.x + r > high.x ? x.x + r : high.x, x.y + r > high.y ? x.y + r : high.y);
  }
  return low.x <= high.x ? (high.x - low.x) * (high.y - low.y) : 0;
}

struct nb_region_state *nb_region_state(const struct nb_model *model, int region) {
  struct nb_region_state *now = &model->regions->list[region];
  const struct nb_region *definition = now->definition;
  if (now->placed_cycle == model->cycle + 1)
    return now;
  now->placed_cycle = model->cycle + 1;
  now->thickness = nb_thickness(model);
  switch (definition->kind) {
  case NB_REGION_CIRCLE:
    now->centre = vec(definition->x, definition->y), now->radius = definition->radius;
    now->area = nb_area_of_disc(definition->radius);
    break;
  case NB_REGION_INSIDE: /* the region is empty without a boundary */
    if (nb_boundary_exists(model))
      now->centre = model->affine->centre, now->radius = definition->radius * nb_boundary_radius(model);
    else
      now->centre = vec(0, 0), now->radius = 0;
    now->area = nb_area_of_disc(now->radius);
    break;
  case NB_REGION_BOX:
    box(now, vec(definition->x, definition->y), vec(definition->ex, definition->ey),
        vec(definition->half_x, definition->half_y));
    break;
  case NB_REGION_ALL:
    now->area = model->cell ? nb_cell_area(model->cell) : bounding_area(model, vec(definition->ex, definition->ey));
    break;
  }
  return now;
}

/* ---- particles inside ---- */

struct nb_vec nb_region_position(const struct nb_model *model, const struct nb_region_state *region, size_t slot) {
  if (!model->cell)
    return model->particles.position[slot];
  struct nb_wrap wrap = nb_cell_wrap(model->cell);
  wrap.centre = region->centre;
  return nb_wrapped(&wrap, model->particles.position[slot]);
}

bool nb_region_contains(const struct nb_model *model, const struct nb_region_state *region, size_t slot) {
  if (nb_removed(model, slot))
    return false;
  if (region->definition->kind == NB_REGION_ALL)
    return true;
  const struct nb_vec x = vec_sub(nb_region_position(model, region, slot), region->centre);
  if (region->radius > 0 || region->definition->kind == NB_REGION_INSIDE)
    return region->radius > 0 && vec_dot(x, x) <= region->radius * region->radius;
  const struct nb_vec along = vec(region->definition->ex, region->definition->ey);
  return fabs(vec_dot(x, along)) <= region->definition->half_x &&
         fabs(along.x * x.y - along.y * x.x) <= region->definition->half_y;
}

bool nb_region_next(const struct nb_model *model, const struct nb_region_state *region, size_t *k, size_t *slot) {
  while (*k < model->particles.count) {
    *slot = (size_t)model->particles.slot[(*k)++];
    if (nb_region_contains(model, region, *slot))
      return true;
  }
  return false;
}

/* The area of the part of a particle that is inside the region, m2. */
static double area_inside(const struct nb_model *model, const struct nb_region_state *region, size_t slot) {
  const double radius = model->particles.radius[slot];
  if (nb_removed(model, slot))
    return 0;
  if (region->definition->kind == NB_REGION_ALL)
    return nb_area_of_disc(radius);
  const struct nb_vec x = nb_region_position(model, region, slot);
  if (region->radius > 0)
    return nb_area_of_lens(radius, region->radius, vec_length(vec_sub(x, region->centre)));
  return nb_area_in_polygon(x, radius, region->corners, 4);
}

/* ---- contact ends ---- */

struct nb_ends nb_ends_begin(const struct nb_model *model, const struct nb_region_state *region) {
  return (struct nb_ends){.model = model, .region = region};
}

bool nb_ends_next_particle(struct nb_ends *ends) {
  const struct nb_model *model = ends->model;
  while (nb_region_next(model, ends->region, &ends->particle, &ends->slot)) {
    const struct nb_contact_range range = nb_contact_range(&model->contacts.incidence, ends->slot);
    ends->next = range.first, ends->end = range.end;
    if (ends->next < ends->end)
      return true;
  }
  return false;
}

/* ---- porosity ---- */

double nb_region_volume(const struct nb_model *model, size_t slot) {
  const double r = model->particles.radius[slot], area = nb_area_of_disc(r);
  return model->scene->particles[model->particles.number[slot] - 1].shape == NB_SPHERE ? 4 * area * r / 3 : area;
}

void nb_measure_porosity(const struct nb_model *model, struct nb_region_state *region) {
  double area = 0, volume = 0;
  for (size_t k = 0; k < model->particles.count; k++) {
    const size_t i = (size_t)model->particles.slot[k];
    const double part = area_inside(model, region, i);
    area += part;
    volume += part > 0 ? nb_region_volume(model, i) * (part / nb_area_of_disc(model->particles.radius[i])) : 0;
  }
  region->porosity.areal = region->area > 0 ? 1 - area / region->area : 0;
  region->porosity.volume = region->area > 0 ? 1 - volume / (region->area * region->thickness) : 0;
  region->porosity.void_ratio = region->porosity.areal / (1 - region->porosity.areal);
}

/* ---- warnings ---- */

/* The first recorded quantity of the monitor that depends on contact forces or directions; NULL: there is none. */
static const char *read_from_forces(const struct nb_scene *scene, size_t monitor) {
  for (size_t c = 0; c < scene->column_count; c++)
    if (scene->columns[c].quantity.monitor == (int)monitor &&
        scene->columns[c].quantity.kind->fields & (NB_BIT(NB_TOTAL_NORMAL) | NB_BIT(NB_NORMAL)))
      return scene->columns[c].name;
  return NULL;
}

void nb_regions_warn(struct nb_model *model, const char *ended) {
  const struct nb_scene *scene = model->scene;
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    if (monitor->kind != NB_MONITOR_REGION)
      continue;
    const struct nb_region_state *now = nb_region_state(model, monitor->a);
    const char *const quantity = ended ? read_from_forces(scene, w) : NULL;
    size_t particles = 0, contacts = 0, slot;
    for (size_t k = 0; nb_region_next(model, now, &k, &slot); particles++)
      contacts += quantity ? (size_t)nb_coordination_number(&model->contacts, slot) : 0;
    if (particles == 0 && now->area > 0)
      nb_warn(&model->warnings, now->definition->line,
              "region `%s` is empty: no particle centre is inside at the %s%s%s, so its means and sums are 0",
              monitor->name, ended ? "end of stage `" : "start", ended ? ended : "", ended ? "`" : "");
    else if (quantity && contacts == 0)
      nb_warn(&model->warnings, now->definition->line,
              "region `%s` has no contact: `%s` depends on contacts, and there are none at the end of stage `%s`",
              monitor->name, quantity, ended);
  }
}

/* ---- measures ---- */

const struct nb_region_state *nb_region_measured(const struct nb_model *model, int region, enum nb_measure which) {
#define ROW(number, name) nb_measure_##name,
  static void (*const measures[])(const struct nb_model *, struct nb_region_state *) = {NB_MEASURE_ROWS(ROW)};
#undef ROW
  struct nb_region_state *now = nb_region_state(model, region);
  if (now->measured[which] != model->cycle + 1) {
    now->measured[which] = model->cycle + 1;
    measures[which](model, now);
  }
  return now;
}
