/* What can be asked of a periodic cell.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "core/names.h"

NB_QUANTITY(h_xx, model->cell->h.xx)
NB_QUANTITY(h_xy, model->cell->h.xy)
NB_QUANTITY(h_yx, model->cell->h.yx)
NB_QUANTITY(h_yy, model->cell->h.yy)
NB_QUANTITY(area, nb_cell_area(model->cell))
NB_QUANTITY(strain_xx, nb_cell_strain(model->cell).xx)
NB_QUANTITY(strain_xy, nb_cell_strain(model->cell).xy)
NB_QUANTITY(strain_yy, nb_cell_strain(model->cell).yy)
NB_QUANTITY(strain_volume, nb_cell_area(model->cell) / nb_cell_area_first(model->cell) - 1)
/* By contacts, compression positive: -(1/V) sum f_i l_j, f on the first body, l from its centre to that of the copy; Pa. */
static struct nb_tensor stress_now(const struct nb_model *model) {
  return tensor_scale(1 / (nb_cell_area(model->cell) * nb_thickness(model)), nb_contacts_virial(model));
}

NB_TENSOR_QUANTITIES(stress, stress_now(model))
NB_QUANTITY(stress_mean, tensor_mean(stress_now(model)))

const struct nb_quantity_kind nb_cell_kinds[] = {
    {"cell.xx", NB_OF_CELL, "m", 0, h_xx, "side of the cell that was the southern one: to the east"},
    {"cell.yx", NB_OF_CELL, "m", 0, h_yx, "likewise, to the north"},
    {"cell.xy", NB_OF_CELL, "m", 0, h_xy, "side of the cell that was the western one: to the east"},
    {"cell.yy", NB_OF_CELL, "m", 0, h_yy, "likewise, to the north"},
    {"cell.area", NB_OF_CELL, "m2", 0, area, "of the cell"},
    NB_TENSOR_ROWS("cell.stress", NB_OF_CELL, "Pa", 0, stress, "deviator",
                   "by contacts, sum F_i l_j of forces and branches over the volume, 1 m thick with discs, the mean "
                   "diameter with spheres; compression positive, dashpots included"),
    {"cell.stress.mean", NB_OF_CELL, "Pa", 0, stress_mean, "(xx + yy)/2"},
    {"cell.strain.xx", NB_OF_CELL, "1", 0, strain_xx, "extension of the cell since time 0"},
    {"cell.strain.yy", NB_OF_CELL, "1", 0, strain_yy, "likewise"},
    {"cell.strain.xy", NB_OF_CELL, "1", 0, strain_xy, "half the change of the right angle since time 0, while small"},
    {"cell.strain.volume", NB_OF_CELL, "1", 0, strain_volume, "growth of its area since time 0, as a share"},
    {NULL, 0, NULL, 0, NULL, NULL},
};
