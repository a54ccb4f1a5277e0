/* Which laws contacts follow, and when they change.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_LAWS_NOW_H
#define NB_LAWS_NOW_H

#include "core/model.h"
#include "law.h"

struct nb_active_laws nb_laws_initial(const struct nb_scene *scene);
struct nb_active_laws nb_laws_of(const struct nb_stage *stage, struct nb_active_laws before); /* from that stage on */
bool nb_laws_normal_changes(const struct nb_model *model);                                    /* in the forces ahead; */
bool nb_laws_shear_changes(const struct nb_model *model); /* then what is remembered is forgotten */
bool nb_laws_elastic(const struct nb_scene *scene);       /* some time the normal law is one of elastic spheres */
bool nb_laws_shear(const struct nb_scene *scene);         /* some time there is a shear law */
/* The first that stores no energy, of those that some stage says; NULL: all do. */
const struct nb_law *nb_laws_unstored(const struct nb_scene *scene, bool normal);
void nb_laws_change(struct nb_model *model); /* those ahead are those in force from now on */

/* properties.c */
bool nb_properties_create(struct nb_properties *now, const struct nb_scene *scene); /* as at time 0 */
void nb_properties_free(struct nb_properties *now);
struct nb_pair nb_properties_pair(const struct nb_properties *now, int material_a, int material_b);
/* What is now of the material or the pair that a change is about. */
struct nb_pair nb_properties_before(const struct nb_properties *now, const struct nb_change *change);
/* Makes what the change is about `share` (0 to 1) of its way from `from`. */
void nb_properties_change(struct nb_properties *now, const struct nb_change *change, struct nb_pair from,
                          double fraction);

#endif
