/* Quantities of a contact test. contact_test.c reads their names and units, run/contact_test_quantities.c computes
 * their values.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

/* What a quantity needs from the laws. */
enum { NB_REQUEST_STORE = 1, NB_REQUEST_LOSS = 2, NB_REQUEST_PIECES = 4 };

/* Function, name, unit, what it needs from the laws, bounds, and help. */
#define NB_CONTACT_TEST_QUANTITIES(X)                                                                                  \
  X(step, "step", "1", 0, NB_AT_LEAST_0, "steps made since the start")                                                 \
  X(approach, "approach", "m", 0, 0,                                                                                   \
    "decrease of the distance of the centres, or of centre and wall, since first touch; below 0: a gap")               \
  X(overlap, "overlap", "m", 0, NB_AT_LEAST_0,                                                                         \
    "overlap of the particles, or of particle and wall; 0 if there is a gap")                                          \
  X(slip, "slip", "m", 0, 0, "tangential displacement since the start")                                                \
  X(normal, "normal", "N", 0, NB_AT_LEAST_0_BY_LAW, "elastic normal force")                                            \
  X(shear, "shear", "N", 0, 0, "elastic shear force, positive for positive slip")                                      \
  X(limit, "limit", "N", 0, 0, "limit of the shear force: friction times the normal force, plus cohesion")             \
  X(sliding, "sliding", "1", 0, NB_AT_LEAST_0 | NB_AT_MOST_1, "1 while the shear force is at its limit, else 0")       \
  X(radius, "radius", "m", 0, NB_AT_LEAST_0, "radius a of the contact circle; 0 for laws without one")                 \
  X(stick_radius, "radius.stick", "m", NB_REQUEST_PIECES, 0,                                                           \
    "radius c of the part that sticks in the last step; for laws that keep pieces")                                    \
  X(work, "work", "J", 0, 0, "work done on the contact since the start")                                               \
  X(work_normal, "work.normal", "J", 0, 0,                                                                             \
    "work of the normal force: sum over the steps of the mean force times the normal increment")                       \
  X(work_shear, "work.shear", "J", 0, 0,                                                                               \
    "work of the shear force: sum over the steps of the mean force times the slip increment")                          \
  X(stored, "stored", "J", NB_REQUEST_STORE, 0, "stored elastic energy, by laws with a state function")                \
  X(stored_normal, "stored.normal", "J", NB_REQUEST_STORE, 0, "stored energy of the normal law")                       \
  X(stored_shear, "stored.shear", "J", NB_REQUEST_STORE, 0, "stored energy of the shear law")                          \
  X(dissipated, "dissipated", "J", NB_REQUEST_LOSS, 0,                                                                 \
    "energy dissipated by micro-slip and sliding since the start, by shear laws that report it")                       \
  X(pieces, "pieces", "1", NB_REQUEST_PIECES, NB_AT_LEAST_0, "number of pieces of history that the shear law keeps")   \
  X(traction, "traction.force", "N", NB_REQUEST_PIECES, 0,                                                             \
    "integral of the traction over the contact, by quadrature; it must equal the shear force")
