/* The list of contacts, and the contacts of each particle: contacts.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "block.h"
#include "store.h"
#include "tensor.h"

/* The contacts of each particle, for the integration of motion: incidence.c. An entry is the index of a contact of a
 * particle. The entries of a particle are consecutive; the particles are in the order of `order`. */
struct nb_incidence {
  int *first;  /* for each slot, the index of its first entry */
  int *middle; /* for each slot, the index of its first entry in which it is the contact's first particle */
  int *end;    /* for each slot, the index after its last entry */
  int *entry;  /* indices of contacts */
  int *order;  /* slots in the order in which forces are summed: batch by batch, in groups */
  size_t batch_size, batches; /* particles in a batch (the last one may have fewer); number of batches */
  int *batch;                 /* for each batch the index of its first group; one element more than there are batches */
  struct nb_incidence_group {
    int particles, seconds, firsts; /* number of particles; entries of each particle as second and as first particle */
  } * group;
};

/* The force of a contact on its first particle, including dashpots, N. The order of the numbers suits the sums of
 * motion.h. */
struct nb_contact_force {
  double x;
  double shear; /* F_s + D_s, on the first particle along -t (block.h) */
  double y;
};
/* The three numbers of a contact, and the first number of the next contact, in one register. */
typedef double nb_lanes __attribute__((vector_size(4 * sizeof(double)), aligned(sizeof(double)), may_alias));

/* Every pair whose gap is smaller than the skin, touching or not; at least one particle of a pair is free. Sorted by
 * material pair, then by the number of a, then by the partner b (nb_partner_rank). */
struct nb_contacts {
  struct nb_owner owner; /* of these arrays, and of the blocks */
  size_t count;
  int *a, *b;           /* slots; a has the smaller number; b is a wall's index in a pair with walls */
  int *material_pair;   /* index of the material pair */
  int *suppressed;      /* bit 0: another wall's contact replaces this one (wall_vertices.c); NULL: nowhere */
  struct nb_vec *image; /* integers m: the second particle's image is at x + H m (cell.h); NULL without a cell */
  struct nb_contact_force *force;
  double *kept[NB_FIELDS];       /* fields that are kept after the force calculation; NULL: not kept */
  size_t wall_from;              /* first contact with a wall; all later ones are with walls */
  struct nb_incidence incidence; /* the contacts of each particle */
  struct nb_history normal_history, shear_history;
  struct nb_history slip_sum; /* sliding displacement since each reference stage, m: measure/configuration.c */
};

/* True if another wall's contact replaces this one. */
static inline bool nb_is_suppressed(const struct nb_contacts *contacts, size_t c) {
  return contacts->suppressed && contacts->suppressed[c] & 1;
}

/* The force on the first particle of a contact, N. */
static inline struct nb_vec nb_contact_force(const struct nb_contacts *contacts, size_t contact) {
  return vec(contacts->force[contact].x, contacts->force[contact].y);
}

/* The contacts of one particle in the order in which forces are summed: by the partner's number, walls last. */
struct nb_contact_range {
  const int *first, *middle, *end;
};
static inline struct nb_contact_range nb_contact_range(const struct nb_incidence *all, size_t slot) {
  return (struct nb_contact_range){all->entry + all->first[slot], all->entry + all->middle[slot],
                                   all->entry + all->end[slot]};
}

/* Two particles, or a particle and a wall, whose gap is smaller than the skin; not yet in the list of contacts. */
struct nb_neighbour_pair {
  int a, b, material_pair; /* as in struct nb_contacts */
};
struct nb_neighbour_pairs {
  struct nb_neighbour_pair *list; /* owned by the caller of the search */
  size_t count, capacity;         /* pairs in the list; pairs for which it has memory */
};
enum { NB_BATCH_SIZE = 128 }; /* most particles in a batch */
/* Lists the contacts of each particle; contact[p] is the index of the contact of pair p. False: out of memory. */
bool nb_incidence_fill(struct nb_contacts *contacts, const struct nb_neighbour_pairs *pairs, const int contact[],
                       const struct nb_model *model);
/* Saves or restores the pairs as the part `name`. A restored pair that the model cannot have sets store->failed. */
void nb_pairs_store(struct nb_store *store, const char *name, struct nb_neighbour_pairs *pairs,
                    const struct nb_model *model);
/* Makes a new list of contacts from `pairs`, which are sorted by the number of a, then by the partner b. Contacts that
 * were in the old list keep their history. Frees the list of pairs. False: out of memory, and there are no contacts any
 * more. */
bool nb_contacts_renew(struct nb_model *model, struct nb_neighbour_pairs *pairs);
static inline bool nb_touches(const struct nb_contacts *contacts, size_t contact) {
  return contacts->kept[NB_OVERLAP][contact] > 0;
}
/* Number of contacts of a particle that touch. */
static inline int nb_coordination_number(const struct nb_contacts *contacts, size_t slot) {
  const struct nb_contact_range range = nb_contact_range(&contacts->incidence, slot);
  int count = 0;
  for (const int *c = range.first; c < range.end; c++)
    count += nb_touches(contacts, (size_t)*c);
  return count;
}

/* Index of the contact of two slots, or of slot a with wall b; -1: the pair is not listed. */
long nb_contacts_find(const struct nb_model *model, int a, int b, bool wall);
/* -sum f_i l_j over the contacts between particles, N m: f is the force on the first particle, N, and l the branch
 * vector, m. */
struct nb_tensor nb_contacts_virial(const struct nb_model *model);
