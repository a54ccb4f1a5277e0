/* Measures of a region: a part of the plane, and averages over the bodies whose centres lie in it.
 *
 *   region.c        which bodies are inside, its area, volume and porosity; contacts end by end
 *   region_quantities.c  the quantities that can be asked for
 *   areas.c         how much of an outline is inside
 *   stress.c        stress, by particles and by contacts, and its parts
 *   fabric.c        directions of contacts, of those that are lost and new too
 *   coordination.c  contacts of a body, rattlers
 *   loads.c         what contacts carry: forces, contact stresses, sliding, out-of-balance
 *   strain.c        how the bodies have moved, and how fast they go
 *   chains.c        force chains
 *
 * Each is worked out at most once a cycle, when somebody asks; a scene without regions has none of this.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_REGION_H
#define NB_REGION_H

#include "core/contacts.h"
#include "core/names.h"
#include "core/tensor.h"

enum nb_stress_part { NB_STRESS_NORMAL, NB_STRESS_SHEAR, NB_STRESS_FABRIC, NB_STRESS_VARIATION, NB_STRESS_PARTS_COUNT };
struct nb_stress {
  struct nb_tensor total, contacts; /* by particles, by contacts, Pa */
  double sinphi, residual;          /* of the whole, 1; Pa */
  struct {
    struct nb_tensor stress; /* by particles, Pa */
    double fraction;         /* of the whole deviator */
  } part[NB_STRESS_PARTS_COUNT];
};
struct nb_anisotropy {
  struct nb_tensor second;             /* Phi_ij: of trace 1, or 0 where nothing touches */
  double xxxx, xxxy, xxyy, xyyy, yyyy; /* Phi_ijkl */
};
struct nb_fabric {
  struct nb_anisotropy plain, normal, shear, sliding; /* all contacts alike; weighted by F_n; by |F_s|; near sliding */
  double kk;                                          /* F_kk, 1/m2 */
};
struct nb_changed_contacts {
  double count, ends;   /* contacts; their ends on bodies inside */
  struct nb_tensor phi; /* of trace 1, or 0 of none */
};
struct nb_porosity {
  double areal, volume, void_ratio;
};
struct nb_coordination {
  double particles, contacts; /* inside; theirs, each once */
  double mean, mechanical;    /* contacts of a body: of all, of those that are no rattlers */
  double rattlers;            /* bodies */
};
struct nb_statistics {
  double mean, max, min, std; /* 0 of nothing; std: root of the mean square of what is off the mean */
};
struct nb_loads {
  struct nb_statistics normal, shear;       /* F_n, |F_s|, N */
  struct nb_statistics pressure, traction;  /* F_n/(pi a^2), |F_s|/(pi a^2), Pa */
  struct nb_statistics ratio;               /* a over the smaller radius */
  struct nb_statistics obliquity;           /* |F_s|/(mu F_n + c) */
  double sliding, near_sliding;             /* shares of the contacts */
  double unbalanced_force, unbalanced_mean; /* mean |sum of the forces on a free body|, N; over mean F_n */
};
struct nb_strain {
  struct nb_tensor strain;
  double volumetric, rotation; /* 1, rad */
};
struct nb_speeds {
  double mean, max, imposed, ratio; /* m/s, m/s, m/s, 1 */
};
struct nb_chains {
  double count, length, fraction; /* chains; bodies of one; of the free bodies, those in chains */
  double bend;                    /* mean angle between successive links, rad */
};
/* The measures: each has a function nb_measure_NAME, called by nb_region_measured alone. */
#define NB_MEASURE_ROWS(ROW)                                                                                           \
  ROW(NB_STRESS, stress)                                                                                               \
  ROW(NB_STRESS_PARTS, stress_parts)                                                                                   \
  ROW(NB_FABRIC, fabric)                                                                                               \
  ROW(NB_POROSITY, porosity)                                                                                           \
  ROW(NB_COORDINATION, coordination)                                                                                   \
  ROW(NB_LOADS, loads)                                                                                                 \
  ROW(NB_STRAIN, strain)                                                                                               \
  ROW(NB_SPEEDS, speeds)                                                                                               \
  ROW(NB_CHANGED_CONTACTS, changed_contacts)                                                                           \
  ROW(NB_CHAINS, chains)
#define NB_MEASURE_NUMBER(number, name) number,
enum nb_measure { NB_MEASURE_ROWS(NB_MEASURE_NUMBER) NB_MEASURES };

/* A region as it is in a cycle. */
struct nb_region_state {
  const struct nb_region *it;
  struct nb_vec centre;
  double radius;              /* of a circle, m; 0: it is a box, */
  struct nb_vec corners[4];   /* counterclockwise, m */
  double area, thickness;     /* m2, m */
  unsigned long placed_cycle; /* the cycle in which it was so, plus 1; likewise */
  unsigned long measured[NB_MEASURES];
  struct nb_stress stress;
  struct nb_fabric fabric;
  struct nb_porosity porosity;
  struct nb_coordination coordination;
  struct nb_loads loads;
  struct nb_speeds speeds;
  struct nb_strain strain;
  struct nb_chains chains;
  struct nb_changed_contacts lost, gained;
  struct nb_neighbour_pairs reference_pairs; /* then; none: nobody asks */
  struct nb_vec *
      reference_position; /* per body number, less 1: where it was when strain began, NAN: outside, m; NULL: nobody asks */
};
struct nb_regions {
  struct nb_region_state *list;              /* as many as the scene has */
  int *touching, *queue;                     /* coordination.c: room, per slot */
  struct nb_chain_particle *chain_particles; /* chains.c: likewise; NULL: nobody asks */
};

/* strain.c: strain begins with this stage for the regions that say so; -1: the start, for all of them. */
enum nb_status nb_strain_begin(struct nb_model *model, int stage, struct nb_error *error);
/* fabric.c: likewise, what contacts are counted from. */
enum nb_status nb_changed_contacts_begin(struct nb_model *model, int stage, struct nb_error *error);

enum nb_status nb_regions_create(struct nb_model *model, struct nb_error *error);
/* A stage begins, and may have changed what was measured in this cycle; -1: the run does. */
enum nb_status nb_regions_stage(struct nb_model *model, int stage, struct nb_error *error);
void nb_regions_free(struct nb_regions *regions, size_t count);

struct nb_region_state *nb_region_state(const struct nb_model *model, int region);
/* With that measure, worked out in this cycle. */
const struct nb_region_state *nb_region_measured(const struct nb_model *model, int region, enum nb_measure which);
bool nb_region_contains(const struct nb_model *model, const struct nb_region_state *region,
                        size_t slot); /* its centre */
/* for (size_t k = 0, i; nb_region_next(model, region, &k, &i);): slot i of each body inside, in the order of numbers. */
bool nb_region_next(const struct nb_model *model, const struct nb_region_state *region, size_t *k, size_t *slot);
double nb_region_volume(const struct nb_model *model, size_t slot); /* of a body, m3; a disc is 1 m thick */

/* Contacts end by end: on each body inside, in the order of their numbers, its contacts in that of its partners'. */
struct nb_end {
  size_t slot, contact;
  int partner;                      /* slot; -1: a wall */
  struct nb_vec e;                  /* unit vector from the body to what it touches */
  double arm;                       /* from its centre to where they touch, m */
  double total_normal, total_shear; /* N: the body feels -(push e + drag t), t = (e2, -e1), dashpots included */
};
static inline struct nb_vec nb_end_force(const struct nb_end *end) { /* from the body on what it touches, N */
  return vec_add(vec_scale(end->total_normal, end->e), vec_scale(end->total_shear, vec_clockwise(end->e)));
}
struct nb_ends {
  const struct nb_model *model;
  const struct nb_region_state *region; /* NULL: everywhere */
  size_t particle, slot;
  const int *next, *end;
};
/* From the centre of a body to where the contact is: half-way between two outlines, on the face of a wall; m. */
static inline double nb_contact_arm(const struct nb_model *model, size_t contact, size_t slot) {
  const bool wall = model->material_pairs[model->contacts.material_pair[contact]].wall;
  const double overlap = model->contacts.kept[NB_OVERLAP][contact];
  return model->particles.surface[slot].radius - (wall ? overlap : overlap / 2);
}
struct nb_ends nb_ends_begin(const struct nb_model *model, const struct nb_region_state *region);
bool nb_ends_next_particle(
    struct nb_ends *ends); /* goes on to the next body inside that has contacts listed; false: there is none */
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
    end->total_shear = material_pair->shear ? contacts->kept[model->plan.total_shear][c] : 0;
    ends->next++;
    return true;
  }
}

/* Fields of contacts that ends are made of. */
enum {
  NB_READS_TOUCH = NB_BIT(NB_OVERLAP),
  NB_READS_ENDS = NB_BIT(NB_OVERLAP) | NB_BIT(NB_EX) | NB_BIT(NB_EY) | NB_BIT(NB_TOTAL_NORMAL) | NB_BIT(NB_TOTAL_SHEAR),
  NB_READS_LOADS = NB_BIT(NB_OVERLAP) | NB_BIT(NB_NORMAL) | NB_BIT(NB_SHEAR) | NB_BIT(NB_SLIDING) | NB_BIT(NB_RADIUS)
};

/* loads.c: what one contact that touches carries. */
struct nb_contact_load {
  double normal, shear;         /* F_n, |F_s|, N */
  double sliding, near_sliding; /* 1 where F_s is at its limit; where it is near it */
  double limit, obliquity;      /* mu F_n + c, N; |F_s| over it; 0 where nothing rubs */
  double radius;                /* a, m; 0 where the law knows none; */
  double pressure, traction;    /* F_n/(pi a^2), |F_s|/(pi a^2), Pa; */
  double ratio;                 /* a over the smaller radius */
};
struct nb_contact_load nb_contact_load(const struct nb_model *model, size_t contact);

#define NB_REQUEST_CHAINS (1u << 26)           /* beside what model.h has: chains.c, */
#define NB_REQUEST_CHANGED_CONTACTS (1u << 25) /* contacts lost and new, fabric.c */
bool nb_chains_create(struct nb_model *model); /* room; false: no memory */

#define NB_MEASURE_FUNCTION(number, name)                                                                              \
  void nb_measure_##name(const struct nb_model *model, struct nb_region_state *region);
NB_MEASURE_ROWS(NB_MEASURE_FUNCTION)

#endif
