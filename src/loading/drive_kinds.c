/* Quantities of what moves an assembly: of its boundary, and of what carries it along. They are 0 where there is none.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "core/names.h"
#include "drive.h"
#include "measure/boundary.h"
#include "measure/energy.h"
#include "measure/region.h"

#define OF_RING(function, expression)                                                                                  \
  static double function(const struct nb_model *model, const struct nb_watch *watch) {                                 \
    (void)watch;                                                                                                       \
    return model->drive && model->drive->ring.begun ? expression : 0;                                                  \
  }
OF_RING(bodies, (double)model->drive->ring.count)
OF_RING(radius, nb_ring_radius(model))
OF_RING(area, nb_ring_area(model))
OF_RING(unevenness, nb_ring_unevenness(model))
/* The largest component of the difference to the stress by contacts. */
static double differs(const struct nb_model *model) {
  const double volume = nb_ring_area(model) * nb_thickness(model);
  if (!(volume > 0))
    return 0;
  return tensor_largest(tensor_sub(nb_ring_stress(model), tensor_scale(1 / volume, nb_contacts_virial(model))));
}
OF_RING(stress_residual, differs(model))

static struct nb_tensor stress_of(const struct nb_model *model) {
  return model->drive && model->drive->ring.begun ? nb_ring_stress(model) : tensor(0, 0, 0, 0);
}
NB_TENSOR_QUANTITIES(stress, stress_of(model))
NB_QUANTITY(stress_mean, tensor_mean(stress_of(model)))

static double whole(const struct nb_model *model, const struct nb_watch *watch) {
  (void)watch;
  return nb_energy_kinetic_whole(model);
}

const struct nb_quantity_kind nb_drive_kinds[] = {
    {"boundary.bodies", 0, "1", 0, bodies, "how many bodies are the boundary"},
    {"boundary.radius", 0, "m", 0, radius, "mean distance of their centres from that of the circle"},
    {"boundary.area", 0, "m2", 0, area, "of the polygon through their centres"},
    {"boundary.unevenness", 0, "1", 0, unevenness,
     "root of the mean square of their distances' deviations from boundary.radius, over it [R89 6.4.1]"},
    NB_TENSOR_ROWS("boundary.stress", 0, "Pa", 0, stress, "deviator",
                   "from the contact forces on the boundary's bodies, sum F_i X_j over the polygon's area and the "
                   "thickness, compression positive"),
    {"boundary.stress.mean", 0, "Pa", 0, stress_mean, "(xx + yy)/2"},
    {"boundary.stress.residual", 0, "Pa", 0, stress_residual,
     "largest difference between it and the stress by all contacts over the same volume: sum F_i X_j of the bodies "
     "inside, "
     "0 at rest"},
    {"energy.kinetic.whole", 0, "J", 0, whole,
     "kinetic energy of bodies that are free with what carries them along, where they are; spin included"},
    {NULL, 0, NULL, 0, NULL, NULL},
};
