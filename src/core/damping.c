/* The contact damping of a page: one for all contacts, or a separate one for contacts with walls.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "nineball.h"

enum nb_contact_damping nb_damping_at(const struct nb_damping *damping, bool wall, double *value) {
  const bool apart = wall && damping->walls_separate;
  *value = apart ? damping->walls : damping->contact;
  return apart ? damping->walls_kind : damping->contact_kind;
}

int nb_damping_contact_line(const struct nb_damping *damping) {
  return damping->contact_kind                            ? damping->contact_line
         : damping->walls_separate && damping->walls_kind ? damping->walls_line
         : damping->deep > 0                              ? damping->deep_line
                                                          : 0;
}

bool nb_damping_equal(const struct nb_damping *a, const struct nb_damping *b) {
  double here, there;
  for (int wall = 0; wall < 2; wall++)
    if (nb_damping_at(a, wall, &here) != nb_damping_at(b, wall, &there) || here < there || here > there)
      return false;
  return a->centred == b->centred && a->global_kind == b->global_kind &&
         !(a->global < b->global || a->global > b->global) && !(a->deep < b->deep || a->deep > b->deep);
}

bool nb_damping_none(const struct nb_damping *damping) {
  static const struct nb_damping none = {0};
  return nb_damping_equal(damping, &none);
}
