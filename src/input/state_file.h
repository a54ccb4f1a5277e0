/* A saved state, as its file has it: all that lives in a model at the end of a stage and that the next stage needs.
 * docs/STATE.md says what stands in it, record by record. How it comes from a model and into one: run/state.h.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_STATE_FILE_H
#define NB_STATE_FILE_H

#include "core/affine.h"
#include "core/block.h"
#include "hash.h"

/* Fields of a contact that a state holds, with the names that they have in the file and the values that they may have. The
 * constants of a contact follow from bodies and materials, what the balance compares with from these, and what was lost in the
 * step behind is done. */
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
  int material;                     /* index; */
  double radius;                    /* m */
  struct nb_vec position, velocity; /* m; at the half step behind, m/s */
  double spin, angle;               /* likewise, rad/s; rad */
  bool member;                      /* of the boundary: set while it is read */
};

struct nb_saved_wall {
  char name[NB_NAME_SIZE];
  int material;
  struct nb_vec pivot, along, velocity, turn; /* as in struct nb_walls */
  double h0, h1, h2, spin, angle;
};

struct nb_saved_contact {
  int a, b; /* index of the body with the smaller number; of the other, or of the wall */
  bool wall, suppressed;
  struct nb_vec force;     /* on the first body, N */
  double field[NB_FIELDS]; /* those of NB_SAVED_FIELDS */
  struct nb_saved_history {
    int count; /* doubles that a law remembers; 0: nothing */
    size_t at; /* where in `memory` they begin */
  } normal, shear;
};

/* One of enum nb_affine_source: what the page asks of it, and its strain rate over the step behind. */
struct nb_saved_carrier {
  struct nb_strain_rate requested;
  struct nb_tensor rate; /* 1/s */
  bool accumulated;      /* what it carries bodies along with stays in their own velocity */
};

/* Of a body: what carries it, and c, the part of its velocity that is so. */
struct nb_saved_imposed {
  enum nb_affine_source by;
  struct nb_vec along; /* m/s */
};

struct nb_saved_cell {
  bool is;                            /* there is one */
  struct nb_tensor h, image_velocity; /* as in struct nb_cell; the rest of it is the page's */
};

struct nb_saved_ring {
  bool is, held, pressing; /* there is one; likewise as in struct nb_ring and struct nb_boundary_state */
  double radius;
  struct nb_tensor shape, stress;
  int *members; /* indices of its bodies, counterclockwise */
  size_t member_count;
};

struct nb_saved {
  char program[NB_NAME_SIZE], page[NB_NAME_SIZE], stage[NB_NAME_SIZE]; /* which version; what it was made from */
  unsigned long long hash;            /* of the page up to the stage's end; 0: of no page */
  char (*settings)[2 * NB_NAME_SIZE]; /* that the page was given, "v=0.1 m/s" */
  size_t setting_count;
  unsigned long cycle, stage_cycle;
  double time, step; /* s; of the step behind */
  bool unitless;
  struct nb_vec gravity; /* m/s2 */
  struct nb_central central;
  struct {
    bool is;
    double contact_time; /* when what flies first touches, s */
  } impact;
  bool rotates;         /* `rotation on` */
  struct nb_vec centre; /* what strain rates are about, m */
  struct nb_saved_carrier carriers[NB_AFFINE_SOURCES];
  struct nb_saved_cell cell;
  struct nb_saved_ring ring;
  char normal[NB_NAME_SIZE], shear[NB_NAME_SIZE]; /* laws */
  int pieces; /* of a contact's history, as the shear law keeps them; 0: it keeps none */
  struct nb_material *materials;
  size_t material_count;
  struct nb_pair_rule *rules;
  size_t rule_count;
  struct nb_saved_particle *particles;
  size_t particle_count;
  struct nb_saved_imposed *imposed; /* of each body; */
  size_t imposed_count;             /* 0: nothing is carried along */
  struct nb_saved_wall *walls;
  size_t wall_count;
  struct nb_saved_contact *contacts;
  size_t contact_count;
  double *memory;
  size_t history_count;
};

/* Bytes of a field that is one word, with its end; and of the last line: "end ", 16 digits and the line's end. */
enum { NB_STATE_FIELD = 2 * NB_NAME_SIZE, NB_STATE_END = 21 };

void nb_saved_free(struct nb_saved *saved);
/* One more that the page was given. */
enum nb_status nb_saved_setting(struct nb_saved *saved, const char *text, struct nb_error *error);
bool nb_saved_is(FILE *file); /* whether it begins as a state does, of any version; reads its first bytes */
/* The file's text, to be freed; NULL: no memory. The same state makes the same bytes. */
char *nb_saved_text(const struct nb_saved *saved, size_t *size);
/* Whatever is not as docs/STATE.md says is an error with file, line, column and what was expected; then nothing is to be freed. */
enum nb_status nb_saved_read_text(struct nb_saved *saved, const char *path, const char *text, size_t size,
                                  struct nb_error *error);
enum nb_status nb_saved_read(struct nb_saved *saved, const char *path, struct nb_error *error);

#endif
