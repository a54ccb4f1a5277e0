/* Quantities of a boundary, a periodic cell and a box of walls. Quantities of a boundary are 0 if there is no boundary.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "core/names.h"
#include "loading.h"
#include "measure/boundary.h"

#define BOUNDARY_QUANTITY(function, expression) NB_QUANTITY(function, nb_boundary_exists(model) ? expression : 0)
BOUNDARY_QUANTITY(boundary_particles, (double)model->boundary->ring.count)
BOUNDARY_QUANTITY(boundary_radius, nb_boundary_radius(model))
BOUNDARY_QUANTITY(boundary_area, nb_boundary_area(model))
BOUNDARY_QUANTITY(boundary_roughness, nb_boundary_roughness(model))
NB_TENSOR_QUANTITY(boundary_stress, nb_boundary_exists(model) ? nb_boundary_stress(model) : tensor(0, 0, 0, 0))

/* The difference between the stress from boundary forces and the stress from all contacts: its largest component,
 * Pa. */
static double difference_from_contacts(const struct nb_model *model) {
  const double volume = nb_boundary_area(model) * nb_thickness(model);
  if (!(volume > 0))
    return 0;
  return tensor_largest(tensor_sub(nb_boundary_stress(model), tensor_scale(1 / volume, nb_contacts_virial(model))));
}
BOUNDARY_QUANTITY(boundary_residual, difference_from_contacts(model))

NB_TENSOR_QUANTITY(cell_sides, model->cell->h)
/* The stress of a cell, Pa, compression positive: -(1/V) sum f_i l_j over contacts. V is the volume of the cell, m3; f
 * is the force on the first particle, N; l is the vector from its centre to that of the second particle's image, m. */
NB_TENSOR_QUANTITY(cell_stress,
                   tensor_scale(1 / (nb_cell_area(model->cell) * nb_thickness(model)), nb_contacts_virial(model)))
NB_TENSOR_QUANTITY(cell_strain, nb_cell_strain(model->cell))
NB_QUANTITY(cell_strain_volume, nb_cell_area(model->cell) / nb_cell_area_first(model->cell) - 1)

NB_QUANTITY(box_width, nb_box_sides(model).x)
NB_QUANTITY(box_height, nb_box_sides(model).y)
NB_QUANTITY(box_porosity, nb_box_porosity(model))
NB_QUANTITY(box_void_ratio, nb_box_porosity(model) / (1 - nb_box_porosity(model)))
NB_QUANTITY(box_strain_width, nb_box_sides(model).x / nb_box_initial_sides(model->scene).x - 1)
NB_QUANTITY(box_strain_height, nb_box_sides(model).y / nb_box_initial_sides(model->scene).y - 1)
NB_TENSOR_QUANTITY(box_stress, nb_box_stress(model))
NB_TENSOR_QUANTITY(walls_stress, nb_walls_stress(model))
NB_QUANTITY(walls_ratio, nb_walls_ratio(model))
NB_QUANTITY(walls_residual, nb_walls_residual(model))

#define TENSOR(called, of, in, kind, tensor, what)                                                                     \
  { .name = called, .family = kind, .monitors = of, .unit = in, .parts = tensor, .help = what }

const struct nb_quantity_kind nb_loading_kinds[] = {
    {"boundary.particles", 0, "1", 0, boundary_particles, "number of particles of the boundary",
     NB_AT_LEAST_0 | NB_COUNTED},
    {"boundary.radius", 0, "m", 0, boundary_radius,
     "mean distance of the boundary particles' centres from the centre of the circle", NB_AT_LEAST_0},
    {"boundary.area", 0, "m2", 0, boundary_area, "area of the polygon through the boundary particles' centres",
     NB_AT_LEAST_0},
    {"boundary.roughness", 0, "1", 0, boundary_roughness,
     "standard deviation of the distances whose mean is boundary.radius, over boundary.radius [R89 sec. 6.4.1]",
     NB_AT_LEAST_0},
    TENSOR(
        "boundary.stress", 0, "Pa", NB_STRESSES, boundary_stress,
        "stress on the boundary, compression positive. It is the sum of F_i X_j over the boundary's particles (F "
        "contact force, X position relative to the circle's centre), divided by the polygon's area and the thickness"),
    {"boundary.stress.residual", 0, "Pa", 0, boundary_residual,
     "largest difference between boundary.stress and the stress from all contacts over the same volume; 0 while the "
     "particles inside are in equilibrium",
     NB_AT_LEAST_0},

    TENSOR(
        "cell", NB_OF_CELL, "m", NB_COMPONENTS, cell_sides,
        "vector of a side of the cell; xx and yx belong to the side along x on the page, xy and yy to the other side"),
    TENSOR(
        "cell.stress", NB_OF_CELL, "Pa", NB_STRESSES, cell_stress,
        "stress in the cell, compression positive: simple shear with `c12` above 0 makes xy negative. It is the sum "
        "of F_i l_j over the contacts (F force on the second particle with dashpots, l vector from the first centre to "
        "the second), divided by the volume. The volume is the area times 1 m for discs, times the mean diameter for "
        "spheres"),
    TENSOR(
        "cell.strain", NB_OF_CELL, "1", NB_COMPONENTS, cell_strain,
        "strain of the cell relative to its sides at time 0, also in later stages, extension positive. xy is 0 as long "
        "as the cell is strained along x and y only. The strain xx or yy of a later stage alone is then "
        "(1 + END)/(1 + BEGIN) - 1, where BEGIN and END are the values at the beginning and at the end of that stage. "
        "For small strains xy is half the engineering shear strain. In a "
        "cell that was compressed before the shear, the engineering shear strain is the change of cell.xy during the "
        "shear over cell.yy"),
    {"cell.strain.volumetric", NB_OF_CELL, "1", 0, cell_strain_volume,
     "relative change of the cell's area since time 0, expansion positive"},

    {"box.width", NB_OF_BOX, "m", 0, box_width, "distance from the box's wall `west` to `east`", NB_AT_LEAST_0},
    {"box.height", NB_OF_BOX, "m", 0, box_height, "distance from the box's wall `south` to `north`", NB_AT_LEAST_0},
    {"box.porosity", NB_OF_BOX, "1", 0, box_porosity,
     "areal porosity of the box: 1 minus the area of all particles over width times height; overlaps count twice",
     NB_AT_MOST_1},
    {"box.void_ratio", NB_OF_BOX, "1", 0, box_void_ratio, "void ratio e = n/(1 - n), n = box.porosity"},
    TENSOR("box.stress", NB_OF_BOX, "Pa", NB_STRESSES, box_stress,
           "stress on the box, compression positive. It is the sum of F_i X_j over wall contacts (F force on the wall "
           "with dashpots, X contact point relative to the middle of the box), divided by the volume"),
    {"box.strain.width", NB_OF_BOX, "1", 0, box_strain_width,
     "relative change of the box's width since time 0, extension positive"},
    {"box.strain.height", NB_OF_BOX, "1", 0, box_strain_height,
     "relative change of the box's height since time 0, extension positive"},
    TENSOR("walls.stress", NB_OF_BOX, "Pa", NB_STRESSES, walls_stress,
           "mean traction of opposite walls of the box, compression positive, dashpots included; xx is that of `east` "
           "and `west`"),
    {"walls.ratio", NB_OF_BOX, "1", 0, walls_ratio,
     "normal force on `east` and `west` over the normal force on `south` and `north`: F_H/F_V of [CS79 tables 1-3]"},
    {"walls.force.residual", NB_OF_BOX, "N", 0, walls_residual,
     "magnitude of the sum of the forces of the four walls; 0 at rest without gravity", NB_AT_LEAST_0},
    {.name = NULL},
};
