/* A periodic cell: copies of it fill the plane, and it is strained as it stands.        [R89 2.3, 4.5.2]
 *
 * The two sides of the cell are the columns of H. There is a copy of every body at x + H m for every pair m of whole
 * numbers, which moves as the body does but for what straining puts between them. All else is in cell.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_CELL_H
#define NB_CELL_H

#include "tensor.h"

struct nb_cell {
  struct nb_vec centre;          /* the point that straining leaves where it is, m */
  struct nb_tensor h, initial_h; /* H now, and at time 0, m */
  struct nb_tensor
      image_velocity; /* L H over the step behind: a copy m sides on is faster than its body by this times m, m/s */
  struct nb_tensor deformation;        /* F since the last search, 1 */
  double travel_limit, largest_radius; /* how far a body may go from where that carries it, and the largest radius, m */
};

struct nb_model;
struct nb_error;

bool nb_cell_create(struct nb_model *model); /* leaves model->cell NULL where the scene has none; false: no memory */
/* Before the motion: H over the step ahead. Answers 1 when it has been strained too far for the list of contacts. */
int nb_cell_move(struct nb_model *model);
/* Before a search: whether the cell is wide enough for a pair to meet in one place alone. */
enum nb_status nb_cell_check_width(const struct nb_model *model, struct nb_error *error);
void nb_cell_reset_travel(struct nb_cell *cell, double skin);
/* The cell that is nearest to upright, of all whose copies fill the plane alike. */
struct nb_wrap {
  struct nb_vec centre;
  struct nb_tensor h, inverse; /* its sides; m, 1/m */
  struct nb_tensor whole;      /* they are H times these whole numbers */
};
struct nb_wrap nb_cell_wrap(const struct nb_cell *cell);
double nb_wrap_width(const struct nb_wrap *wrap);                      /* the smaller height of it, m */
struct nb_vec nb_wrapped(const struct nb_wrap *wrap, struct nb_vec x); /* the copy of x in it */
struct nb_vec nb_cell_wrapped_position(const struct nb_model *model,
                                       size_t slot); /* of a body; without a cell where it is */
/* m, in sides of H: that copy of what lies `apart` from a body is the nearest one to it. */
struct nb_vec nb_wrap_image(const struct nb_wrap *wrap, struct nb_vec apart);

double nb_cell_area(const struct nb_cell *cell),
    nb_cell_area_first(const struct nb_cell *cell);          /* now, at time 0; m2 */
struct nb_tensor nb_cell_strain(const struct nb_cell *cell); /* symmetric part of H H_0^-1 - 1 */

#endif
