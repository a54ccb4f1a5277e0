/* What can be asked of a periodic cell.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "names.h"

#define OF_CELL(function, expression)                                                                                  \
  static double function(const struct nb_model *model, const struct nb_watch *watch) {                                 \
    const struct nb_cell *cell = model->cell;                                                                          \
    (void)watch, (void)cell;                                                                                           \
    return expression;                                                                                                 \
  }
OF_CELL(h_xx, cell->h.xx)
OF_CELL(h_xy, cell->h.xy)
OF_CELL(h_yx, cell->h.yx)
OF_CELL(h_yy, cell->h.yy)
OF_CELL(area, nb_cell_area(cell))
OF_CELL(stress_xx, nb_cell_stress(model).xx)
OF_CELL(stress_xy, nb_cell_stress(model).xy)
OF_CELL(stress_yx, nb_cell_stress(model).yx)
OF_CELL(stress_yy, nb_cell_stress(model).yy)
OF_CELL(stress_mean, tensor_mean(nb_cell_stress(model)))
OF_CELL(stress_deviator, 2 * tensor_radius(nb_cell_stress(model)))
OF_CELL(strain_xx, nb_cell_strain(cell).xx)
OF_CELL(strain_xy, nb_cell_strain(cell).xy)
OF_CELL(strain_yy, nb_cell_strain(cell).yy)
OF_CELL(strain_volume, nb_cell_area(cell) / nb_cell_area_first(cell) - 1)

const struct nb_quantity_kind nb_cell_kinds[] = {
    {"cell.xx", NB_OF_CELL, "m", 0, h_xx, "side of the cell that was the southern one: to the east"},
    {"cell.yx", NB_OF_CELL, "m", 0, h_yx, "likewise, to the north"},
    {"cell.xy", NB_OF_CELL, "m", 0, h_xy, "side of the cell that was the western one: to the east"},
    {"cell.yy", NB_OF_CELL, "m", 0, h_yy, "likewise, to the north"},
    {"cell.area", NB_OF_CELL, "m2", 0, area, "of the cell"},
    {"cell.stress.xx", NB_OF_CELL, "Pa", 0, stress_xx,
     "by contacts, compression positive: forces times branches over the volume, 1 m thick with discs, the mean "
     "diameter with "
     "spheres; dashpots included"},
    {"cell.stress.xy", NB_OF_CELL, "Pa", 0, stress_xy, "likewise: force to the east, branch to the north"},
    {"cell.stress.yx", NB_OF_CELL, "Pa", 0, stress_yx, "likewise: force to the north, branch to the east"},
    {"cell.stress.yy", NB_OF_CELL, "Pa", 0, stress_yy, "likewise"},
    {"cell.stress.mean", NB_OF_CELL, "Pa", 0, stress_mean, "half the sum of the principal stresses"},
    {"cell.stress.deviator", NB_OF_CELL, "Pa", 0, stress_deviator, "difference of the principal stresses"},
    {"cell.strain.xx", NB_OF_CELL, "1", 0, strain_xx, "extension of the cell since time 0"},
    {"cell.strain.yy", NB_OF_CELL, "1", 0, strain_yy, "likewise"},
    {"cell.strain.xy", NB_OF_CELL, "1", 0, strain_xy, "half the change of the right angle since time 0, while small"},
    {"cell.strain.volume", NB_OF_CELL, "1", 0, strain_volume, "growth of its area since time 0, as a share"},
    {NULL, 0, NULL, 0, NULL, NULL},
};
