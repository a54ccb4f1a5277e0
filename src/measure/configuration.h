/* What has changed since a stage began: for snapshots that say `from STAGE`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_CONFIGURATION_H
#define NB_CONFIGURATION_H

#include "core/contacts.h"
#include "snapshot.h"

bool nb_configuration_create(
    struct nb_model *model); /* leaves model->since NULL where no snapshot asks; false: no memory */
void nb_configuration_free(struct nb_configuration *configuration);
size_t
nb_configuration_count(const struct nb_configuration *configuration); /* how many such stages there are; 0 of NULL */
bool nb_configuration_begin(struct nb_model *model, int stage);       /* a stage begins; false: no memory */
void nb_configuration_add_slip(struct nb_model *model); /* after the forces: what has slid in the step behind */

/* A body or a contact since that stage began, which some snapshot is `from`. */
struct nb_vec nb_configuration_displacement(const struct nb_model *model, int stage, size_t slot); /* m */
double nb_configuration_rotation(const struct nb_model *model, int stage, size_t slot); /* rad, counterclockwise */
double nb_configuration_slip(const struct nb_model *model, int stage, size_t contact);  /* m, sizes added up */
bool nb_configuration_lattice(struct nb_table *table, const struct nb_model *model, int stage,
                              int from); /* false: no memory */

/* What touches now beside what touched then, in the order of contacts. kind: 0 both, 1 now alone, -1 then alone. */
struct nb_configuration_walk {
  const struct nb_model *model;
  const struct nb_neighbour_pairs *reference;
  size_t now, past; /* where it is in the contacts, and in `then` */
};
bool nb_configuration_next(struct nb_configuration_walk *walk, struct nb_neighbour_pair *pair, int *kind);
bool nb_touching_pairs(struct nb_neighbour_pairs *touching,
                       const struct nb_model *model); /* of now; false: no memory */
/* From the first centre to the second one, to the copy of it that is nearest, or to the nearest point of the wall; m. */
struct nb_vec nb_pair_branch(const struct nb_model *model, struct nb_neighbour_pair pair);

#endif
