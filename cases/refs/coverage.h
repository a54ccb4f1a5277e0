/* What a scene may have that a reference must know of, and which of it a scene has.
 *
 * A reference says in `accepts` which of these its theory covers, and in `needs` those without which it has nothing to say.
 * Nothing else is accepted: what is new here is refused by every reference until one says otherwise.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_COVERAGE_H
#define NB_COVERAGE_H

#include "nineball.h"

enum nb_feature {
  HAS_NOTHING, /* ends a list */
  /* bodies and walls */
  HAS_DISCS,
  HAS_SPHERES,
  HAS_FIXED_PARTICLES,
  HAS_VELOCITIES, /* of bodies, at time 0 */
  HAS_SPINS,      /* likewise */
  HAS_IMPACT,
  HAS_WALLS,
  HAS_MOVING_WALLS,
  HAS_TURNING_WALLS,
  HAS_CELL,
  HAS_CONTACT_TEST, /* one contact, no bodies and no time */
  /* forces */
  HAS_FRICTION, /* where there is a shear law, and likewise: */
  HAS_COHESION,
  HAS_PIECES, /* of a contact's history no more than so many */
  HAS_GRAVITY,
  HAS_CENTRIPETAL_GRAVITY,
  HAS_CONTACT_BETA,
  HAS_CONTACT_FRACTION,
  HAS_CONTACT_RATIO,
  HAS_WALL_DAMPING, /* another one than that of contacts between bodies */
  HAS_DEEP_DAMPING,
  HAS_GLOBAL_DAMPING,
  HAS_CON1_CS79,
  HAS_CON1_VELOCITY,
  HAS_CON1_ALL,
  /* loading */
  HAS_BOUNDARY,
  HAS_BOUNDARY_STRAIN,
  HAS_BOUNDARY_STRESS,
  HAS_BOUNDARY_NONE,
  HAS_CONTINUUM,
  HAS_CONTINUUM_LITERAL,
  HAS_CELL_STRAIN,
  HAS_BOX_STRAIN,
  HAS_SERVO,
  /* what a stage changes */
  HAS_START, /* the first stages are those of another page */
  HAS_ROTATION_OFF,
  HAS_STILL,
  HAS_REVERSE,
  HAS_REMOVE,
  HAS_UNTIL, /* a stage whose length is not known before */
  HAS_RAMP,
  HAS_STEP_CHANGE,
  HAS_DAMPING_CHANGE,
  HAS_LAW_CHANGE,
  HAS_GRAVITY_CHANGE,
  HAS_MATERIAL_CHANGE,
  NB_FEATURES
};

#define HAS_CONTACT_DAMPING HAS_CONTACT_BETA, HAS_CONTACT_FRACTION, HAS_CONTACT_RATIO, HAS_WALL_DAMPING
#define HAS_ALL_DAMPING                                                                                                \
  HAS_CONTACT_DAMPING, HAS_DEEP_DAMPING, HAS_GLOBAL_DAMPING, HAS_CON1_CS79, HAS_CON1_VELOCITY, HAS_CON1_ALL

/* As a page writes it. */
const char *nb_feature_name(enum nb_feature feature);

/* lines[f]: where the page asks for the feature f, 0: not on a line; -1: the scene does not have it. */
void nb_features(int lines[NB_FEATURES], const struct nb_scene *scene);

/* NB_BAD_USE when the scene has what the reference does not accept, or lacks what it needs: names the first such and its line. */
struct nb_reference;
enum nb_status nb_reference_covers(const struct nb_reference *reference, const struct nb_scene *scene,
                                   struct nb_error *error);

#endif
