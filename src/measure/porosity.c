/* Voids of a region.
 *
 *   areal     n = 1 - sum A_p/A              A_p  of each outline what is inside, exactly, m2; A  of the region, m2
 *   volume    n = 1 - sum V_p (A_p/pi R^2)/(A s)    V_p  volume, m3, 4/3 pi R^3 or pi R^2 times 1 m; s  thickness, m
 *   voids     e = n/(1 - n), void ratio, of the areal one
 *
 * Where outlines overlap that is counted for both bodies, so what is deep in itself has less porosity than the plane's uncovered
 * part. The volume of a sphere that the region's edge cuts is counted by the share of its outline that is inside.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "areas.h"
#include "region.h"
#include "snapshot.h"

double nb_region_volume(const struct nb_model *model, size_t slot) {
  const double r = model->bodies.rim[slot].x, area = nb_area_of_disc(r);
  return model->scene->bodies[model->bodies.number[slot] - 1].shape == NB_SPHERE ? 4 * area * r / 3 : area;
}

const struct nb_porosity *nb_porosity_of(const struct nb_model *model, const struct nb_watch *watch) {
  struct nb_region_now *region = nb_region_now(model, watch->a);
  if (!nb_region_due(model, region, NB_POROSITY))
    return &region->porosity;
  double area = 0, volume = 0;
  for (size_t k = 0; k < model->bodies.count; k++) {
    const size_t i = (size_t)model->bodies.slot[k];
    const double part = nb_region_part(model, region, i);
    area += part;
    volume += part > 0 ? nb_region_volume(model, i) * (part / nb_area_of_disc(model->bodies.rim[i].x)) : 0;
  }
  region->porosity.areal = region->area > 0 ? 1 - area / region->area : 0;
  region->porosity.volume = region->area > 0 ? 1 - volume / (region->area * region->thickness) : 0;
  return &region->porosity;
}

#define POROSITY nb_porosity_of(model, watch)
NB_QUANTITY(areal, POROSITY->areal)
NB_QUANTITY(volume, POROSITY->volume)
NB_QUANTITY(voids, POROSITY->areal / (1 - POROSITY->areal))
NB_QUANTITY(area, nb_region_now(model, watch->a)->area)
NB_QUANTITY(thickness, nb_region_now(model, watch->a)->thickness)

const struct nb_quantity_kind nb_porosity_kinds[] = {
    {"area", NB_OF_REGION, "m2", 0, area, "of the region"},
    {"thickness", NB_OF_REGION, "m", 0, thickness,
     "normal to the plane: mean diameter of all spheres, 1 m of discs [R89 4.4]"},
    {"porosity", NB_OF_REGION, "1", 0, areal,
     "areal: what outlines do not cover; those cut by the edge count by the part inside"},
    {"porosity.volume", NB_OF_REGION, "1", 0, volume, "the same of volumes, area times thickness"},
    {"voids", NB_OF_REGION, "1", 0, voids, "void ratio e = n/(1 - n), n the areal porosity"},
    {NULL, 0, NULL, 0, NULL, NULL},
};
