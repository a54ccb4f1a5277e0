/* A saved state: all variables of a model, at the end of a stage, that the next stage needs. docs/STATE.md describes
 * the file, record by record. run/state.h copies a state from a model and into a model.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/affine.h"
#include "core/block.h"
#include "core/store.h"
#include "hash.h"

/* Saved fields of a contact, with their names in the file and their ranges. Other fields are computed from these
 * fields, from particles and materials, or concern only the last step. */
#define NB_SAVED_FIELDS(X)                                                                                             \
  X(NB_OVERLAP, "overlap", FROM_0)                                                                                     \
  X(NB_NORMAL_INCREMENT, "closing", FINITE)                                                                            \
  X(NB_TANGENTIAL_INCREMENT, "slip", FINITE)                                                                           \
  X(NB_EX, "ex", FINITE)                                                                                               \
  X(NB_EY, "ey", FINITE)                                                                                               \
  X(NB_NORMAL, "normal", FROM_0)                                                                                       \
  X(NB_STIFFNESS, "stiffness", FROM_0)                                                                                 \
  X(NB_RADIUS, "radius", FROM_0)                                                                                       \
  X(NB_SHEAR, "shear", FINITE)                                                                                         \
  X(NB_SHEAR_STIFFNESS, "shear_stiffness", FROM_0)                                                                     \
  X(NB_SLIDING, "sliding", FROM_0)                                                                                     \
  X(NB_TOTAL_NORMAL, "push", FINITE)                                                                                   \
  X(NB_TOTAL_SHEAR, "drag", FINITE)
#define NB_SAVED_BIT(field, name, range) NB_BIT(field) |
enum { NB_SAVED_MASK = NB_SAVED_FIELDS(NB_SAVED_BIT) 0 };

enum nb_mobility { NB_FREE, NB_FIXED, NB_REMOVED };

struct nb_saved_particle {
  enum nb_shape shape;
  enum nb_mobility mobility;
  int material;                     /* index of the material */
  double radius;                    /* m */
  struct nb_vec position, velocity; /* position, m; velocity at the last half step, m/s */
  double spin, angle;               /* angular velocity at the last half step, rad/s; rotation, rad */
  bool member;                      /* belongs to the boundary; set while reading */
};

struct nb_saved_wall {
  char name[NB_NAME_SIZE];
  int material;
  struct nb_vec pivot, along, velocity, turn; /* as in struct nb_walls */
  double h0, h1, h2, spin, angle;
};

struct nb_saved_contact {
  int a, b; /* index of the particle with the smaller number; index of the other particle, or of the wall */
  bool wall, suppressed;
  struct nb_vec force;     /* force on the first particle, N */
  double field[NB_FIELDS]; /* the fields of NB_SAVED_FIELDS; others are 0 */
  struct nb_saved_history {
    int count; /* number of history variables of a law; 0: none */
    size_t at; /* index of the first of them in `history` */
  } normal, shear;
};

/* A source of imposed motion, one of enum nb_affine_source. */
struct nb_saved_affine {
  struct nb_strain_rate requested; /* strain rate that the page requests */
  struct nb_tensor rate;           /* strain rate over the last step, 1/s */
  bool accumulated;                /* the imposed velocity stays in the particles' own velocity */
  bool twice;                      /* the imposed velocity is added to the relative velocities too */
};

/* The imposed motion of a particle. */
struct nb_saved_imposed {
  enum nb_affine_source by;
  struct nb_vec along; /* imposed part c of the particle's velocity, m/s */
};

struct nb_saved_cell {
  bool is;                            /* the state has a cell */
  struct nb_tensor h, image_velocity; /* as in struct nb_cell; the page gives the rest */
};

struct nb_saved_ring {
  bool is, held, pressing; /* the state has a boundary; it follows its strain rate; a stress acts on it */
  double radius;
  struct nb_tensor shape, stress;
  int *members; /* indices of its particles, counterclockwise */
  size_t member_count;
};

struct nb_saved {
  char program[NB_NAME_SIZE], page[NB_NAME_SIZE], stage[NB_NAME_SIZE]; /* version, page and stage that made the state */
  unsigned long long hash;            /* hash of the page up to the end of the stage; 0: no page */
  char (*settings)[2 * NB_NAME_SIZE]; /* settings of the page, "v=0.1 m/s" */
  size_t setting_count;
  unsigned long cycle, stage_cycle;
  double time, step; /* current time, s; last step, s */
  bool unitless;
  struct nb_vec gravity; /* m/s2 */
  struct nb_central central;
  struct {
    bool is;
    double contact_time; /* time of the first contact, s */
  } impact;
  bool rotates;         /* `rotation on` */
  struct nb_vec centre; /* centre of the strain rates, m */
  struct nb_saved_affine sources[NB_AFFINE_SOURCES];
  struct nb_saved_cell cell;
  struct nb_saved_ring ring;
  char normal[NB_NAME_SIZE], shear[NB_NAME_SIZE]; /* laws */
  int pieces; /* most pieces of a contact's history that the shear law keeps; 0: the law has no pieces */
  struct nb_material *materials;
  size_t material_count;
  struct nb_pair_rule *rules;
  size_t rule_count;
  struct nb_saved_particle *particles;
  size_t particle_count;
  struct nb_saved_imposed *imposed; /* one for each particle */
  size_t imposed_count;             /* 0: no imposed motion */
  struct nb_saved_wall *walls;
  size_t wall_count;
  struct nb_saved_contact *contacts;
  size_t contact_count;
  double *history; /* the numbers of all contact histories */
  size_t history_count;
  struct nb_store store; /* of a checkpoint: the other data of a run; else empty */
};

/* Number of bytes of a field with its terminating zero, and of the last line: "end ", 16 digits and the line end. */
enum { NB_STATE_FIELD = 2 * NB_NAME_SIZE, NB_STATE_END = 21 };

void nb_saved_free(struct nb_saved *saved);
/* Appends a setting of the page. */
enum nb_status nb_saved_setting(struct nb_saved *saved, const char *text, struct nb_error *error);
bool nb_saved_is(FILE *file); /* true if the file begins as a state of any version; reads its first bytes */
/* The text of the file, which the caller frees; NULL: out of memory. Equal states give equal bytes. */
char *nb_saved_text(const struct nb_saved *saved, size_t *size);
/* Reads a state. Every deviation from docs/STATE.md is an error with file, line, column and what was expected. After an
 * error `saved` owns nothing. */
enum nb_status nb_saved_read_text(struct nb_saved *saved, const char *path, const char *text, size_t size,
                                  struct nb_error *error);
enum nb_status nb_saved_read(struct nb_saved *saved, const char *path, struct nb_error *error);
