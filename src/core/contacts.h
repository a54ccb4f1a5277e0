/* The list of contacts, and which of them a body has: contacts.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_CONTACTS_H
#define NB_CONTACTS_H

#include "block.h"
#include "tensor.h"

/* For the motion half: which contacts a body has. */
struct nb_incidence {
  int *first;  /* slot -> its first entry; one more than bodies */
  int *middle; /* slot -> the first entry in which it is the contact's first body */
  int *entry;  /* contact */
};

/* Every pair that is near: touching, or closer than the skin. Sorted by pairing, then number of a, then of b. */
struct nb_contacts {
  struct nb_owner owner; /* of the arrays, and of the blocks that they are cut into */
  size_t count;
  int *a, *b;         /* slots; a has the smaller number; b a wall's index where the pairing is with walls */
  int *material_pair; /* index */
  int *suppressed;    /* 1 where another wall's contact with this body stands for it (wall_vertices.c); NULL: nowhere */
  struct nb_vec *image;    /* m: the second body is met at x + H m, H the cell's sides; NULL without a cell */
  struct nb_vec *force;    /* on the first body, dashpots included, N */
  double *kept[NB_FIELDS]; /* the fields that outlive their block, else NULL */
  size_t wall_from;        /* the first contact with a wall: they are the last ones */
  struct nb_incidence of;  /* which of them a body has */
  struct nb_history normal_history, shear_history,
      slip_sum; /* slid: m, since each stage that a snapshot is from, configuration.c */
};

/* Those of one body, in the order in which forces are summed: of its partners' numbers, walls last. */
struct nb_contact_range {
  const int *first, *middle, *end;
};
static inline struct nb_contact_range nb_contact_range(const struct nb_incidence *all, size_t slot) {
  return (struct nb_contact_range){all->entry + all->first[slot], all->entry + all->middle[slot],
                                   all->entry + all->first[slot + 1]};
}

/* Two bodies, or a body and a wall, that are near; before they are contacts. */
struct nb_neighbour_pair {
  int a, b, material_pair; /* as in struct nb_contacts */
};
struct nb_neighbour_pairs {
  struct nb_neighbour_pair *list; /* owned by who searches */
  size_t count;
};
/* The place of b among the partners of a: its number, walls last. */
int nb_partner_rank(const struct nb_model *model, struct nb_neighbour_pair pair);
/* The order of the list; < 0, 0, > 0: by pairing, then number of a, then of b. */
int nb_contacts_order(const struct nb_model *model, struct nb_neighbour_pair p, struct nb_neighbour_pair q);
/* Takes over a new list, sorted by the number of a, then by partners; contacts that were there before keep their memory. False: out of
 * memory, nothing changed. */
bool nb_contacts_renew(struct nb_model *model, const struct nb_neighbour_pairs *pairs);
static inline bool nb_touches(const struct nb_contacts *contacts, size_t contact) {
  return contacts->kept[NB_OVERLAP][contact] > 0;
}
static inline int nb_coordination_number(const struct nb_contacts *contacts,
                                         size_t slot) { /* how many contacts a body has */
  const struct nb_contact_range range = nb_contact_range(&contacts->of, slot);
  int count = 0;
  for (const int *c = range.first; c < range.end; c++)
    count += nb_touches(contacts, (size_t)*c);
  return count;
}

long nb_contacts_find(const struct nb_model *model, int a, int b, bool wall); /* of two slots; -1: not near */
/* Of two bodies: from the centre of the first to that of the second, or of the copy of it that is met, m. */
struct nb_vec nb_contacts_branch(const struct nb_model *model, size_t contact);
struct nb_tensor nb_contacts_virial(const struct nb_model *model); /* of pairs of bodies: -sum f_i l_j, N m */
double nb_overlap(const struct nb_model *model,
                  size_t contact); /* of positions as they are; < 0 where they are apart, m */
/* What the laws of a contact are given: the constants of its pairing, and those of its own. */
struct nb_pair nb_contact_constants(const struct nb_model *model, size_t contact, struct nb_pair values);

#endif
