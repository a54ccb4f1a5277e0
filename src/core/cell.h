/* A periodic cell that is strained affinely.        [R89 sec. 2.3, sec. 4.5.2]
 *
 * The two sides of the cell are the columns of H. Every particle has an image at x + H m for each pair m of integers.
 * An image has the velocity of its particle plus the velocity that the strain of the cell causes between them. See
 * cell.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "tensor.h"

struct nb_cell {
  struct nb_vec centre;          /* the point that the strain does not move, m */
  struct nb_tensor h, initial_h; /* H now and at time 0, m */
  double strain;                 /* ||L|| dt of the last step */
  /* L H in the last step, m/s: L H m is the velocity of the image at x + H m minus that of the particle at x. */
  struct nb_tensor image_velocity;
  struct nb_tensor deformation; /* F since the last search, 1 */
  double travel_limit;   /* a displacement relative to the affine motion beyond this limit requires a new search, m */
  double largest_radius; /* m */
};

struct nb_model;
struct nb_error;

bool nb_cell_create(struct nb_model *model); /* leaves model->cell NULL in a scene without one; false: no memory */
/* Advances H by one step; called before the motion. Returns 1 when the strain requires a new search, else 0. */
int nb_cell_move(struct nb_model *model);
/* Called before a search. NB_BROKEN or NB_BAD_USE when the cell is so narrow that a pair could have two contacts. */
enum nb_status nb_cell_check_width(const struct nb_model *model, struct nb_error *error);
/* Called after a search: sets F to 1 and the travel limit to half the skin. */
void nb_cell_reset_travel(struct nb_cell *cell, double skin);
/* The equivalent cell with the shortest sides; it has the same images. */
struct nb_wrap {
  struct nb_vec centre;
  struct nb_tensor h, inverse; /* the sides of the equivalent cell, m; inverse of h, 1/m */
  struct nb_tensor multiples;  /* integers: h = H multiples */
};
struct nb_wrap nb_cell_wrap(const struct nb_cell *cell);
double nb_wrap_width(const struct nb_wrap *wrap);                      /* smaller height of the equivalent cell, m */
struct nb_vec nb_wrapped(const struct nb_wrap *wrap, struct nb_vec x); /* the image of x inside the equivalent cell */
/* The image of a particle inside the cell; without a cell its position. */
struct nb_vec nb_cell_wrapped_position(const struct nb_model *model, size_t slot);
/* The integers m of the image x_j + H m that is nearest to x_i, for `apart` = x_j - x_i, if the nearest image is closer
 * than half the smaller height of the equivalent cell. */
struct nb_vec nb_wrap_image(const struct nb_wrap *wrap, struct nb_vec apart);

double nb_cell_area(const struct nb_cell *cell);             /* current area, m2 */
double nb_cell_area_first(const struct nb_cell *cell);       /* area at time 0, m2 */
struct nb_tensor nb_cell_strain(const struct nb_cell *cell); /* symmetric part of H H_0^-1 - 1 */
