/* Measures of a region: averages over the particles whose centres are in a part of the plane.
 *
 *   region.c        particles inside, area, volume and porosity; contact ends
 *   region_quantities.c   the quantities
 *   areas.c         area of a particle inside a circle or a polygon
 *   stress.c        stress, by particles and by contacts, and its parts
 *   fabric.c        directions of all contacts, and of lost and new contacts
 *   directions.c    distributions of contacts and forces over the directions
 *   moduli.c        moduli for a uniform strain
 *   coordination.c  coordination number, rattlers
 *   loads.c         contact forces, contact stresses, sliding, unbalanced forces
 *   strain.c        strain, and speeds
 *   chains.c        force chains
 *
 * A measure is computed when it is first needed in a cycle, and again after a stage has begun in that cycle. A scene
 * without regions has none of this data.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/contacts.h"
#include "core/names.h"
#include "core/tensor.h"

enum nb_stress_part { NB_STRESS_NORMAL, NB_STRESS_SHEAR, NB_STRESS_FABRIC, NB_STRESS_VARIATION, NB_STRESS_PARTS_COUNT };
struct nb_stress {
  struct nb_tensor total, contacts; /* stress by particles, Pa; stress by contacts, Pa */
  double sinphi, residual;          /* sin Phi of the total, 1; residual of stress.c, Pa */
  struct {
    struct nb_tensor stress; /* part of the stress by particles, Pa */
    double fraction;         /* fraction of the total deviator, 1 */
  } part[NB_STRESS_PARTS_COUNT];
};
struct nb_anisotropy {
  struct nb_tensor second;             /* Phi_ij, of trace 1; 0 without contacts */
  double xxxx, xxxy, xxyy, xyyy, yyyy; /* Phi_ijkl */
};
struct nb_fabric {
  struct nb_anisotropy plain;         /* of all contacts */
  struct nb_anisotropy normal, shear; /* weighted by F_n, by |F_s| */
  struct nb_anisotropy sliding;       /* of contacts near sliding */
  double kk;                          /* F_kk, 1/m2 */
};
struct nb_directions {
  double contacts, normal, shear; /* the coefficients a, a_n, a_t of Rothenburg and Bathurst */
  double sinphi;                  /* sin Phi that follows from them */
};
struct nb_moduli {
  double bulk, shear, bulk_lower; /* two upper bounds and a lower one, Pa (moduli.c) */
};
struct nb_changed_contacts {
  double count, ends;   /* number of contacts; number of their ends on particles inside */
  struct nb_tensor phi; /* Phi_ij, of trace 1; 0 without contacts */
};
struct nb_porosity {
  double areal, volume, void_ratio; /* n by area, n by volume, and e, 1: region.c */
};
struct nb_coordination {
  double particles, contacts; /* number of particles inside; number of their contacts, each counted once */
  double mean, mechanical;    /* coordination number of all particles inside; without rattlers */
  double rattlers;            /* number of rattlers */
};
struct nb_statistics {
  double mean, max, min, std; /* 0 without values; std: standard deviation */
};
struct nb_loads {
  struct nb_statistics normal, shear;       /* F_n, |F_s|, N */
  struct nb_statistics pressure, traction;  /* F_n/(pi a^2), |F_s|/(pi a^2), Pa */
  struct nb_statistics ratio;               /* a over the smaller radius */
  struct nb_statistics obliquity;           /* |F_s|/(mu F_n + c) */
  double sliding, near_sliding;             /* fractions of the contacts */
  double unbalanced_force, unbalanced_mean; /* mean magnitude of the force on a free particle, N; over mean F_n, 1 */
};
struct nb_strain {
  struct nb_tensor strain;
  double volumetric, rotation; /* 1, rad */
};
struct nb_speeds {
  double mean, max, imposed, ratio; /* m/s, m/s, m/s, 1 */
};
struct nb_chains {
  double count, length, fraction; /* number of chains; particles per chain; fraction of free particles in chains */
  double bend;                    /* mean angle between successive links, rad */
};
/* Each measure has a function nb_measure_NAME, which only nb_region_measured calls. */
#define NB_MEASURE_ROWS(ROW)                                                                                           \
  ROW(NB_STRESS, stress)                                                                                               \
  ROW(NB_STRESS_PARTS, stress_parts)                                                                                   \
  ROW(NB_FABRIC, fabric)                                                                                               \
  ROW(NB_DIRECTIONS, directions)                                                                                       \
  ROW(NB_MODULI, moduli)                                                                                               \
  ROW(NB_POROSITY, porosity)                                                                                           \
  ROW(NB_COORDINATION, coordination)                                                                                   \
  ROW(NB_CONSTRAINTS, constraints)                                                                                     \
  ROW(NB_LOADS, loads)                                                                                                 \
  ROW(NB_STRAIN, strain)                                                                                               \
  ROW(NB_SPEEDS, speeds)                                                                                               \
  ROW(NB_CHANGED_CONTACTS, changed_contacts)                                                                           \
  ROW(NB_CHAINS, chains)
#define NB_MEASURE_NUMBER(number, name) number,
enum nb_measure { NB_MEASURE_ROWS(NB_MEASURE_NUMBER) NB_MEASURES };

/* A region in the current cycle. */
struct nb_region_state {
  const struct nb_region *definition;
  struct nb_vec centre;                /* m; zero for `all`, which needs only its area */
  double radius;                       /* radius of a circle, m; 0: a box, `all`, or `inside` without a boundary */
  struct nb_vec corners[4];            /* of a box, counterclockwise, m */
  double area, thickness;              /* m2; m */
  unsigned long placed_cycle;          /* number of the cycle of this geometry, plus 1; 0: not computed yet */
  unsigned long measured[NB_MEASURES]; /* number of the cycle in which each measure was computed, plus 1; 0: not yet */
  struct nb_stress stress;
  struct nb_fabric fabric;
  struct nb_directions directions;
  struct nb_moduli moduli;
  struct nb_porosity porosity;
  struct nb_coordination coordination;
  double constraint_ratio; /* constraints over degrees of freedom of the free particles */
  struct nb_loads loads;
  struct nb_speeds speeds;
  struct nb_strain strain;
  struct nb_chains chains;
  struct nb_changed_contacts lost, gained;
  struct nb_neighbour_pairs reference_pairs; /* pairs that touched when the reference stage began */
  /* Positions when the strain began, m, by particle number minus 1; NAN: the particle was outside. NULL: not needed. */
  struct nb_vec *reference_position;
};
struct nb_regions {
  struct nb_region_state *list;              /* one for each region of the scene */
  int *touching, *queue;                     /* workspace of coordination.c, per slot */
  struct nb_chain_particle *chain_particles; /* workspace of chains.c, per slot; NULL: not needed */
};

/* strain.c: sets the reference positions of the regions whose strain begins with this stage; stage -1: of all regions,
 * at the start of the run. */
enum nb_status nb_strain_begin(struct nb_model *model, int stage, struct nb_error *error);
/* fabric.c: sets the reference contacts of the same regions. */
enum nb_status nb_changed_contacts_begin(struct nb_model *model, int stage, struct nb_error *error);

enum nb_status nb_regions_create(struct nb_model *model, struct nb_error *error);
/* Called when a stage begins, or the run (stage -1): sets the references of the regions and discards what was measured
 * in this cycle. */
enum nb_status nb_regions_stage(struct nb_model *model, int stage, struct nb_error *error);
/* Warns of regions without a particle, at the end of the stage with the name `ended`, or at the start of the run if
 * `ended` is NULL. At the end of a stage the function also warns of regions without a contact, if a recorded quantity
 * of theirs depends on contact forces or directions. */
void nb_regions_warn(struct nb_model *model, const char *ended);
void nb_regions_free(struct nb_regions *regions, size_t count);

/* The region with this index, with its geometry in the current cycle. */
struct nb_region_state *nb_region_state(const struct nb_model *model, int region);
/* Computes the measure `which` of a region, unless it has been computed in this cycle. Returns the region's state. */
const struct nb_region_state *nb_region_measured(const struct nb_model *model, int region, enum nb_measure which);
/* Position of a particle, m; in a periodic cell, position of its image in the equivalent cell (core/cell.h) around the
 * region's centre. */
struct nb_vec nb_region_position(const struct nb_model *model, const struct nb_region_state *region, size_t slot);
/* True if the centre of a particle is inside. */
bool nb_region_contains(const struct nb_model *model, const struct nb_region_state *region, size_t slot);
/* Loops over the particles inside, in the order of their numbers: for (size_t k = 0, i; nb_region_next(model, region,
 * &k, &i);) sets i to the slot of each. */
bool nb_region_next(const struct nb_model *model, const struct nb_region_state *region, size_t *k, size_t *slot);
double nb_region_volume(const struct nb_model *model, size_t slot); /* volume of a particle, m3; a disc is 1 m thick */

/* A contact end: a contact of a particle inside, seen from this particle. Loops over the ends run in the order of
 * particles, then of partners. */
struct nb_end {
  size_t slot, contact;
  int partner;     /* slot of the other particle; -1: a wall */
  struct nb_vec e; /* unit vector from the particle to its partner */
  double arm;      /* distance from the particle's centre to the contact, m */
  /* Total forces, including dashpots, N: the force on the particle is -(total_normal e + total_shear t), t = (e2,
   * -e1). */
  double total_normal, total_shear;
};
static inline struct nb_vec nb_end_force(const struct nb_end *end) { /* force of the particle on its partner, N */
  return vec_add(vec_scale(end->total_normal, end->e), vec_scale(end->total_shear, vec_clockwise(end->e)));
}
struct nb_ends {
  const struct nb_model *model;
  const struct nb_region_state *region;
  size_t particle, slot;
  const int *next, *end;
};
/* Distance from the centre of a particle to the contact, m. The contact is half-way between the two outlines, or on the
 * face of a wall. */
static inline double nb_contact_arm(const struct nb_model *model, size_t contact, size_t slot) {
  const bool wall = nb_with_wall(model, contact);
  const double overlap = model->contacts.kept[NB_OVERLAP][contact];
  return model->particles.radius[slot] - (wall ? overlap : overlap / 2);
}
/* Loops over the ends: for (struct nb_ends ends = nb_ends_begin(model, region); nb_ends_next(&ends, &end);) sets `end`
 * to each. */
struct nb_ends nb_ends_begin(const struct nb_model *model, const struct nb_region_state *region);
bool nb_ends_next_particle(struct nb_ends *ends); /* goes to the next particle with listed contacts; false: no more */
static inline bool nb_ends_next(struct nb_ends *ends, struct nb_end *end) {
  const struct nb_model *model = ends->model;
  const struct nb_contacts *contacts = &model->contacts;
  for (;; ends->next++) {
    if (ends->next == ends->end && !nb_ends_next_particle(ends))
      return false;
    const size_t c = (size_t)*ends->next;
    if (!nb_touches(contacts, c))
      continue;
    const struct nb_material_pair *material_pair = &model->material_pairs[contacts->material_pair[c]];
    const bool first = (size_t)contacts->a[c] == ends->slot;
    const double sign = first ? 1 : -1;
    const enum nb_field total_normal = model->plan.dashpots ? NB_TOTAL_NORMAL : NB_NORMAL;
    end->slot = ends->slot, end->contact = c;
    end->partner = material_pair->wall ? -1 : first ? contacts->b[c] : contacts->a[c];
    end->e = vec(sign * contacts->kept[NB_EX][c], sign * contacts->kept[NB_EY][c]);
    end->arm = nb_contact_arm(model, c, ends->slot);
    end->total_normal = contacts->kept[total_normal][c];
    end->total_shear = contacts->force[c].shear;
    ends->next++;
    return true;
  }
}

/* Fields of contacts that measures need. */
enum {
  NB_READS_TOUCH = NB_BIT(NB_OVERLAP),
  NB_READS_ENDS = NB_BIT(NB_OVERLAP) | NB_BIT(NB_EX) | NB_BIT(NB_EY) | NB_BIT(NB_TOTAL_NORMAL),
  NB_READS_LOADS = NB_BIT(NB_OVERLAP) | NB_BIT(NB_NORMAL) | NB_BIT(NB_SHEAR) | NB_BIT(NB_SLIDING) | NB_BIT(NB_RADIUS)
};

/* loads.c: forces and stresses of a contact that touches. */
struct nb_contact_load {
  double normal, shear;         /* F_n, |F_s|, N */
  double sliding, near_sliding; /* 1 if F_s is at its limit, else 0; 1 if F_s is near its limit, else 0 */
  double limit, obliquity;      /* mu F_n + c, N; |F_s| over this limit, 1; both 0 without friction */
  double radius;                /* a, m; a and the next three are 0 if the law has no contact radius */
  double pressure, traction;    /* F_n/(pi a^2), |F_s|/(pi a^2), Pa */
  double ratio;                 /* a over the radius of the smaller particle, 1 */
};
struct nb_contact_load nb_contact_load(const struct nb_model *model, size_t contact);

/* Bits of model->plan.requested, besides those of model.h: */
#define NB_REQUEST_CHAINS (1u << 26)           /* force chains, chains.c */
#define NB_REQUEST_CHANGED_CONTACTS (1u << 25) /* lost and new contacts, fabric.c */
bool nb_chains_create(struct nb_model *model); /* false: no memory */

#define NB_MEASURE_FUNCTION(number, name)                                                                              \
  void nb_measure_##name(const struct nb_model *model, struct nb_region_state *region);
NB_MEASURE_ROWS(NB_MEASURE_FUNCTION)
