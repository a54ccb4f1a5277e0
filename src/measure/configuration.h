/* Changes since the beginning of a stage, for snapshots with `from STAGE`: configuration.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/contacts.h"
#include "snapshot.h"

/* Creates model->configuration, or leaves it NULL if the scene has no snapshot with `from`. False: out of memory. */
bool nb_configuration_create(struct nb_model *model);
void nb_configuration_free(struct nb_configuration *configuration);
/* Number of stages that a `from` names; 0 for NULL. */
size_t nb_configuration_count(const struct nb_configuration *configuration);
void nb_configuration_store(struct nb_store *store, struct nb_model *model); /* saves or restores the references */
bool nb_configuration_begin(struct nb_model *model, int stage); /* called when a stage begins; false: out of memory */
void nb_configuration_add_slip(struct nb_model *model); /* adds the slip of the last step; called after the forces */

/* Displacement, rotation and slip since the beginning of a stage that some snapshot names after `from`. */
struct nb_vec nb_configuration_displacement(const struct nb_model *model, int stage, size_t slot); /* m */
double nb_configuration_rotation(const struct nb_model *model, int stage, size_t slot); /* rad, counterclockwise */
double nb_configuration_slip(const struct nb_model *model, int stage, size_t contact);  /* m */
/* Makes the table `lattice` of a snapshot of `stage`, with the changes since stage `from`. False: out of memory. */
bool nb_configuration_lattice(struct nb_table *table, const struct nb_model *model, int stage, int from);

/* A walk over the pairs that touch now or touched when the reference stage began, in the order of contacts. */
struct nb_configuration_walk {
  const struct nb_model *model;
  const struct nb_neighbour_pairs *reference;
  size_t now, past; /* indices in the contacts and in `reference` */
};
/* Goes to the next pair; false: no more. Sets *kind to 0 if the pair touches at both times, to 1 if only now, to -1 if
 * only then. */
bool nb_configuration_next(struct nb_configuration_walk *walk, struct nb_neighbour_pair *pair, int *kind);
/* Lists the pairs that touch now. False: out of memory. */
bool nb_touching_pairs(struct nb_neighbour_pairs *touching, const struct nb_model *model);
/* The vector from the centre of the first particle to that of the second, or of its nearest image in a cell, or to the
 * nearest point of the wall, m. */
struct nb_vec nb_pair_branch(const struct nb_model *model, struct nb_neighbour_pair pair);
