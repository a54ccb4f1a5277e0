/* What can be recorded and expected of the contact on the bench. The page knows names and units (contact_test.c), the bench
 * works them out (run/contact_test_quantities.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_CONTACT_TEST_QUANTITIES_H
#define NB_CONTACT_TEST_QUANTITIES_H

/* What a quantity asks of the laws. */
enum { NB_REQUEST_STORE = 1, NB_REQUEST_LOSS = 2, NB_REQUEST_PIECES = 4 };

/* Function, name, unit, what it asks of the laws, and help. */
#define NB_CONTACT_TEST_QUANTITIES(X)                                                                                  \
  X(step, "step", "1", 0, "steps made since the start")                                                                \
  X(approach, "approach", "m", 0, "how far the outlines have come together; below 0: a gap")                           \
  X(overlap, "overlap", "m", 0, "the same, 0 where there is a gap")                                                    \
  X(slip, "slip", "m", 0, "tangential displacement since the start")                                                   \
  X(normal, "normal", "N", 0, "elastic normal force")                                                                  \
  X(shear, "shear", "N", 0, "shear force, in the sense of the slip that makes it")                                     \
  X(limit, "limit", "N", 0, "friction times the normal force, and cohesion: what the shear force cannot exceed")       \
  X(sliding, "sliding", "1", 0, "1 while the shear force is at its limit, else 0")                                     \
  X(radius, "radius", "m", 0, "of the contact circle, a; 0 for laws that know none")                                   \
  X(stick_radius, "radius.stick", "m", NB_REQUEST_PIECES,                                                              \
    "within it nothing slipped in the step behind, c; for laws that keep pieces")                                      \
  X(work, "work", "J", 0, "done on the contact since the start, both sides")                                           \
  X(work_normal, "work.normal", "J", 0, "mean normal force of each step's two ends times its closing")                 \
  X(work_shear, "work.shear", "J", 0, "mean shear force of each step's two ends times its slip")                       \
  X(stored, "stored", "J", NB_REQUEST_STORE, "elastic energy, a state function of the laws that know theirs")          \
  X(stored_normal, "stored.normal", "J", NB_REQUEST_STORE, "that of the normal law")                                   \
  X(stored_shear, "stored.shear", "J", NB_REQUEST_STORE, "that of the shear law")                                      \
  X(dissipated, "dissipated", "J", NB_REQUEST_LOSS,                                                                    \
    "in micro-slip and sliding since the start, by shear laws that report it")                                         \
  X(pieces, "pieces", "1", NB_REQUEST_PIECES, "how many pieces of its history the shear law keeps")                    \
  X(traction, "traction.force", "N", NB_REQUEST_PIECES,                                                                \
    "the traction summed over the contact, by quadrature: the shear force, or it is wrong")

#endif
