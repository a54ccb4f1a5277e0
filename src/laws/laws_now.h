/* The current contact laws and material pairs, and their changes.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/model.h"
#include "law.h"

struct nb_active_laws nb_laws_initial(const struct nb_scene *scene);
/* The laws of a stage; `before` are those of the previous stage. */
struct nb_active_laws nb_laws_of(const struct nb_stage *stage, struct nb_active_laws before);
/* True if the normal law, or the shear law, changes at the next force calculation, which then discards the history of
 * this law. */
bool nb_laws_normal_changes(const struct nb_model *model);
bool nb_laws_shear_changes(const struct nb_model *model);
bool nb_laws_elastic(const struct nb_scene *scene);  /* in some stage the normal law is for elastic spheres */
bool nb_laws_shear(const struct nb_scene *scene);    /* in some stage there is a shear law */
bool nb_laws_friction(const struct nb_scene *scene); /* in some stage some material or pair has friction or cohesion */
/* The first law without stored energy that a stage makes active: by a change of the law, or by friction or cohesion for
 * contacts that had none. `normal`: among the normal laws; otherwise among the shear laws. NULL: no stage does. */
const struct nb_law *nb_laws_unstored(const struct nb_scene *scene, bool normal);
void nb_laws_change(struct nb_model *model); /* makes the next laws the current ones */

/* properties.c */
/* Sets the properties at time 0. False: out of memory. */
bool nb_properties_create(struct nb_properties *now, const struct nb_scene *scene);
void nb_properties_free(struct nb_properties *now);
/* The current contact parameters of two materials. */
struct nb_pair nb_properties_pair(const struct nb_properties *now, int material_a, int material_b);
/* The current values of the material or of the pair of materials that `change` names. */
struct nb_pair nb_properties_before(const struct nb_properties *now, const struct nb_change *change);
/* Sets the values of this material or pair by linear interpolation: to `from` at fraction 0, and to the values that
 * `change` gives at fraction 1. Values that `change` does not give stay as they are. */
void nb_properties_change(struct nb_properties *now, const struct nb_change *change, struct nb_pair from,
                          double fraction);
/* Sets all values that the stage changes to those at its end. */
void nb_properties_end_stage(struct nb_properties *now, const struct nb_stage *stage);
void nb_properties_apply(struct nb_model *model); /* gives each material pair its current values */
