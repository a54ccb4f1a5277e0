/* The features of a scene on which the validity of a reference depends.
 *
 * A reference lists in `accepts` the features that its theory covers, and in `needs` those without which it has no
 * solution. A scene with any other feature is refused. So a new feature is refused by every reference that does not yet
 * list it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "nineball.h"

enum nb_feature {
  HAS_NOTHING, /* ends a list */
  /* particles and walls */
  HAS_DISCS,
  HAS_SPHERES,
  HAS_FIXED_PARTICLES,
  HAS_VELOCITIES, /* of particles, at time 0 */
  HAS_SPINS,      /* angular velocities of particles, at time 0 */
  HAS_IMPACT,
  HAS_WALLS,
  HAS_MOVING_WALLS,
  HAS_TURNING_WALLS,
  HAS_OFFSET_WALLS, /* the point P of a wall is not on its line: h0 is not 0 */
  HAS_CELL,
  HAS_CONTACT_TEST, /* a single contact without motion */
  /* forces */
  HAS_FRICTION, /* only with a shear law */
  HAS_COHESION, /* only with a shear law */
  HAS_MEMORY,   /* a limited number of history pieces per contact */
  HAS_GRAVITY,
  HAS_CENTRIPETAL_GRAVITY,
  HAS_STIFFNESS_DAMPING,
  HAS_R89_FRACTION_DAMPING,
  HAS_RATIO_DAMPING,
  HAS_WALL_DAMPING, /* contacts with walls have other dashpots than contacts between particles */
  HAS_CRITICAL_DAMPING,
  HAS_CENTRED_DASHPOTS,
  HAS_MASS_DAMPING,
  HAS_CON1_CS79,
  HAS_CON1_VELOCITY,
  HAS_CON1_ALL,
  /* loading */
  HAS_BOUNDARY,
  HAS_BOUNDARY_STRAIN,
  HAS_BOUNDARY_STRESS,
  HAS_BOUNDARY_NONE,
  HAS_AFFINE_STRAIN,
  HAS_AFFINE_ACCUMULATED,
  HAS_AFFINE_TWICE,
  HAS_CELL_STRAIN,
  HAS_BOX_STRAIN,
  HAS_SERVO,
  /* what a stage changes */
  HAS_START, /* begins with the stages of another page */
  HAS_ROTATION_OFF,
  HAS_ZERO_VELOCITIES,
  HAS_REVERSE_VELOCITIES,
  HAS_REMOVE,
  HAS_REMOVE_WALL,
  HAS_UNTIL, /* a stage that ends with a condition */
  HAS_RAMP,
  HAS_STEP_CHANGE,
  HAS_DAMPING_CHANGE,
  HAS_LAW_CHANGE,
  HAS_GRAVITY_CHANGE,
  HAS_MATERIAL_CHANGE,
  NB_FEATURES
};

#define HAS_CONTACT_DAMPING HAS_STIFFNESS_DAMPING, HAS_R89_FRACTION_DAMPING, HAS_RATIO_DAMPING, HAS_WALL_DAMPING
#define HAS_ALL_DAMPING                                                                                                \
  HAS_CONTACT_DAMPING, HAS_CRITICAL_DAMPING, HAS_MASS_DAMPING, HAS_CON1_CS79, HAS_CON1_VELOCITY, HAS_CON1_ALL

/* The words of the page language for a feature, such as "damping mass". */
const char *nb_feature_name(enum nb_feature feature);

/* lines[f]: the line of the page that asks for feature f; 0: the scene has the feature, but no line asks for it; -1:
 * the scene does not have it. */
void nb_features(int lines[NB_FEATURES], const struct nb_scene *scene);

struct nb_reference;
/* NB_BAD_USE when the scene has a feature or a law that the reference does not accept, or lacks a feature that the
 * reference needs. The error names all features and laws that it does not accept, each with the line of the page that
 * asks for it, if there is one; or, if it accepts all, the first needed feature that is missing. */
enum nb_status nb_reference_covers(const struct nb_reference *reference, const struct nb_scene *scene,
                                   struct nb_error *error);
