/* What moves an assembly from outside: its boundary, and whether bodies turn.
 *
 *   drive.c   what stages do with it      ring.c   which bodies are the boundary, its polygon, its stress
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_DRIVE_H
#define NB_DRIVE_H

#include "core/carry.h"

struct nb_ring {
  bool begun, held;         /* there is one; its bodies follow the strain rate */
  double radius;            /* of the circle as it was when it began, m */
  struct nb_tensor shape;   /* what the circle has been carried to: x = centre + shape X, |X| = radius; 1 */
  int *member;              /* slots of its bodies, counterclockwise; room for all */
  size_t count;             /* how many */
  int *rim;                 /* slots of bodies that may come to cross it before they are looked for again, by number */
  size_t rim_count;         /* room for all */
  struct nb_tensor looked;  /* its shape then, */
  unsigned long long after; /* and after which search that was; 0: never */
};

struct nb_drive {
  struct nb_vec *pressed;  /* per slot: force of a stress on the boundary, N; NULL: no stage has one */
  bool pressing;           /* there is one now */
  struct nb_tensor stress; /* and which, Pa */
  bool turns;              /* `rotation on` */
  struct nb_ring ring;
};

/* ---- drive.c ---- */
enum nb_status nb_drive_create(struct nb_model *model, struct nb_error *error); /* before the first search */
void nb_drive_free(struct nb_drive *drive);
enum nb_status nb_drive_begin(struct nb_model *model, const struct nb_stage *stage, struct nb_error *error);
/* Before the motion and after it. */
enum nb_status nb_drive_before(struct nb_model *model, struct nb_error *error);
void nb_drive_after(struct nb_model *model);
void nb_drive_hold(struct nb_model *model, size_t slot);   /* makes a body one of the boundary's */
void nb_drive_let_go(struct nb_model *model, size_t slot); /* and free again, with the velocity that it has */

enum nb_status nb_drive_search(struct nb_model *model,
                               struct nb_error *error); /* contacts anew, with forces as they are */

/* ---- ring.c ---- */
void nb_ring_begin(struct nb_model *model, const struct nb_circle *circle);
void nb_ring_hold(struct nb_model *model); /* its bodies are held again: it is the circle of their mean radius */
void nb_ring_free(struct nb_model *model, bool dissolve);
void nb_ring_drop(struct nb_model *model, size_t slot); /* that is taken out of the scene */
/* Takes in who has crossed the circle since it was last asked; NB_OK. */
enum nb_status nb_ring_take_in(struct nb_model *model, struct nb_error *error);
void nb_ring_carry(struct nb_model *model);              /* before the motion, where nothing else is carried */
void nb_ring_press(struct nb_model *model);              /* sets drive->pressed for where the bodies are now */
double nb_ring_area(const struct nb_model *model);       /* of the polygon through the centres of its bodies, m2 */
double nb_ring_radius(const struct nb_model *model);     /* mean distance of their centres from the circle's, m */
double nb_ring_unevenness(const struct nb_model *model); /* root of the mean square of what is left, over the mean */
struct nb_tensor nb_ring_stress(const struct nb_model *model); /* from the forces on its bodies, Pa */

#endif
