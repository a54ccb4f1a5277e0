/* What can be asked of a box of walls.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "box.h"
#include "names.h"

#define OF_BOX(function, expression)                                                                                   \
  static double function(const struct nb_model *model, const struct nb_watch *watch) {                                 \
    const struct nb_vec sides = nb_box_sides(model);                                                                   \
    (void)watch, (void)sides;                                                                                          \
    return expression;                                                                                                 \
  }
OF_BOX(width, sides.x)
OF_BOX(height, sides.y)
OF_BOX(area, sides.x *sides.y)
OF_BOX(stress_xx, nb_box_stress(model).xx)
OF_BOX(stress_xy, nb_box_stress(model).xy)
OF_BOX(stress_yx, nb_box_stress(model).yx)
OF_BOX(stress_yy, nb_box_stress(model).yy)
OF_BOX(stress_mean, tensor_mean(nb_box_stress(model)))
OF_BOX(stress_deviator, 2 * tensor_radius(nb_box_stress(model)))
OF_BOX(strain_width, sides.x / nb_box_first(model->scene).x - 1)
OF_BOX(strain_height, sides.y / nb_box_first(model->scene).y - 1)

const struct nb_quantity_kind nb_box_kinds[] = {
    {"box.width", NB_OF_BOX, "m", 0, width, "from the box's wall `west` to `east`"},
    {"box.height", NB_OF_BOX, "m", 0, height, "from `south` to `north`"},
    {"box.area", NB_OF_BOX, "m2", 0, area, "of the box"},
    {"box.stress.xx", NB_OF_BOX, "Pa", 0, stress_xx,
     "from the forces on its walls, times the places where they act, over the volume, 1 m thick with discs, the mean "
     "diameter with spheres; compression positive, dashpots included"},
    {"box.stress.xy", NB_OF_BOX, "Pa", 0, stress_xy, "likewise: force to the east, place to the north"},
    {"box.stress.yx", NB_OF_BOX, "Pa", 0, stress_yx, "likewise: force to the north, place to the east"},
    {"box.stress.yy", NB_OF_BOX, "Pa", 0, stress_yy, "likewise"},
    {"box.stress.mean", NB_OF_BOX, "Pa", 0, stress_mean, "(xx + yy)/2"},
    {"box.stress.deviator", NB_OF_BOX, "Pa", 0, stress_deviator, "major less minor principal stress"},
    {"box.strain.width", NB_OF_BOX, "1", 0, strain_width, "growth of the box's width since time 0, as a share"},
    {"box.strain.height", NB_OF_BOX, "1", 0, strain_height, "of its height"},
    {NULL, 0, NULL, 0, NULL, NULL},
};
