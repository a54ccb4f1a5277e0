/* What can be asked of a box of walls.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "box.h"
#include "core/names.h"

NB_QUANTITY(width, nb_box_sides(model).x)
NB_QUANTITY(height, nb_box_sides(model).y)
NB_QUANTITY(area, (nb_box_sides(model).x * nb_box_sides(model).y))
NB_QUANTITY(strain_width, nb_box_sides(model).x / nb_box_first(model->scene).x - 1)
NB_QUANTITY(strain_height, nb_box_sides(model).y / nb_box_first(model->scene).y - 1)
NB_TENSOR_QUANTITIES(stress, nb_box_stress(model))
NB_QUANTITY(stress_mean, tensor_mean(nb_box_stress(model)))

const struct nb_quantity_kind nb_box_kinds[] = {
    {"box.width", NB_OF_BOX, "m", 0, width, "from the box's wall `west` to `east`"},
    {"box.height", NB_OF_BOX, "m", 0, height, "from `south` to `north`"},
    {"box.area", NB_OF_BOX, "m2", 0, area, "of the box"},
    NB_TENSOR_ROWS("box.stress", NB_OF_BOX, "Pa", 0, stress, "deviator",
                   "from the forces on its walls, sum F_i X_j of the places where they act over the volume, 1 m thick "
                   "with discs, the mean diameter with spheres; compression positive, dashpots included"),
    {"box.stress.mean", NB_OF_BOX, "Pa", 0, stress_mean, "(xx + yy)/2"},
    {"box.strain.width", NB_OF_BOX, "1", 0, strain_width, "growth of the box's width since time 0, as a share"},
    {"box.strain.height", NB_OF_BOX, "1", 0, strain_height, "of its height"},
    {NULL, 0, NULL, 0, NULL, NULL},
};
