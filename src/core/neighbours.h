/* Between the search (neighbour_list.c) and the list it renews (contacts.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_NEAR_H
#define NB_NEAR_H

#include "model.h"

struct nb_near_pair {
  int a, b, pairing; /* as in struct nb_contacts */
};
struct nb_near_pairs {
  struct nb_near_pair *list; /* owned by who searches */
  size_t count, capacity;
};

/* neighbour_search.c: adds every pair that is near, once, in no order; false: out of memory. */
bool nb_near_find(struct nb_near_pairs *found, struct nb_model *model);
/* contacts.c: the order of the list; < 0, 0, > 0: by pairing, then number of a, then of b. */
int nb_contacts_order(const struct nb_model *model, struct nb_near_pair p, struct nb_near_pair q);
/* Takes over the new list; contacts that were there before keep their memory. False: out of memory, nothing changed. */
bool nb_contacts_renew(struct nb_model *model, const struct nb_near_pairs *pairs);

#endif
