/* Two particles x and y in a row between two walls: contacts A (wall and x), B (x and y), C (wall and y).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "lattice.h"

struct lattice_row {
  struct lattice lattice;
  size_t contact[3];    /* A, B, C: indices in the lattice */
  double k[3];          /* k_n of A, B, C, N/m */
  double m[2];          /* of x and y, kg */
  double v;             /* initial speed of both walls, m/s */
  unsigned long steady; /* number of cycles from the start with this v, the first step and no damping */
  double compression;   /* approach of the walls in the whole run, m */
};

/* NB_BAD_USE when the scene is not such a row. */
enum nb_status lattice_row_build(struct lattice_row *row, const struct nb_scene *scene, struct nb_error *error);
void lattice_row_free(struct lattice_row *row);
/* The place of the contact with this index in the lattice: 0, 1, 2 for A, B, C; -1 for any other contact and for -1. */
int lattice_row_place(const struct lattice_row *row, int contact);
