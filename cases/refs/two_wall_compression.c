/* Reference: two discs in a row between two walls that approach with the speed v each: the first calculation cycles by
 * hand [CS79 1-7].
 *
 * At t_0 discs and walls just touch, without forces. X_n and Y_n are the displacements of the discs x and y at t_n,
 * positive from A to C, in units of v dt. The overlaps at A (wall and x), B (x and y) and C (y and wall) in the same
 * unit are
 *     a_n = n - X_n,    b_n = X_n - Y_n,    c_n = n + Y_n
 * With p = k_A dt^2/m_x, q = k_B dt^2/m_x, r = k_B dt^2/m_y, s = k_C dt^2/m_y the cycle is
 *     X_(n+1) = 2 X_n - X_(n-1) + p a_n - q b_n,    Y_(n+1) = 2 Y_n - Y_(n-1) + r b_n - s c_n,
 * X_0 = X_1 = Y_0 = Y_1 = 0, because the discs are at rest during the first step of the walls. So each displacement is
 * a polynomial in p, q, r, s with integer coefficients, which are computed exactly; the first are
 *     a_1 = 1, b_1 = 0                           CS79 (1)
 *     a_2 = 2 - p, b_2 = p + s, c_2 = 2 - s      CS79 (5) to (7), which give the increments since t_1
 * Rounding occurs only when a polynomial is evaluated. A program that stores positions x differs by the relative error
 * rounding(x)/overlap.
 *
 * Returns, for n = 1 ... 6 within the first undamped motion of the walls, for C that monitors a contact and D that
 * monitors a disc:
 *     C.normal, C.overlap at n cycles          k v dt a_n (or b_n, c_n) and v dt a_n
 *     D.fx, D.fy at n cycles                   the sum of forces, CS79 (2)
 *     D.vx.half, D.vy.half at n cycles         the velocity over the previous step, CS79 (4)
 * and, if all stages have the same step and no damping, and no contact opens or slips, C.normal versus cycle and
 * versus time, by normal modes.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>

#include "lattice_row.h"
#include "lattice_values.h"

/* Powers 0 to 5 of each variable: X_6 is of degree 5. */
enum { SIDE = 6, SIZE = SIDE * SIDE * SIDE * SIDE, LAST = 6 };
/* The stride of each variable in the array of coefficients. */
enum power { ONE = 0, P = 1, Q = SIDE, R = SIDE * SIDE, S = SIDE * SIDE * SIDE };

struct polynomial {
  long long of[SIZE]; /* integer coefficients */
};

/* sum += factor * power * other, where power is p, q, r, s or 1. */
static void add(struct polynomial *sum, long long factor, enum power power, const struct polynomial *other) {
  for (int i = 0; i + (int)power < SIZE; i++)
    sum->of[i + (int)power] += factor * other->of[i];
}

/* The value for p, q, r, s = at[0], …, at[3]. */
static long double evaluate(const struct polynomial *polynomial, const long double at[4]) {
  long double sum = 0, s = 1;
  for (int l = 0, i = 0; l < SIDE; l++, s *= at[3]) {
    long double r = s;
    for (int k = 0; k < SIDE; k++, r *= at[2]) {
      long double q = r;
      for (int j = 0; j < SIDE; j++, q *= at[1]) {
        long double p = q;
        for (int m = 0; m < SIDE; m++, p *= at[0])
          sum += (long double)polynomial->of[i++] * p;
      }
    }
  }
  return sum;
}

/* Overlaps of A, B, C and displacements of x and y at t_0 ... t_LAST, in units of v dt. */
struct hand {
  struct polynomial overlap[3][LAST + 1], displacement[2][LAST + 1];
};

static void calculate(struct hand *hand) {
  struct polynomial *x = hand->displacement[0], *y = hand->displacement[1];
  for (int n = 0; n <= LAST; n++) {
    struct polynomial *a = &hand->overlap[0][n], *b = &hand->overlap[1][n], *c = &hand->overlap[2][n];
    a->of[0] = c->of[0] = n;
    add(a, -1, ONE, &x[n]);
    add(b, 1, ONE, &x[n]);
    add(b, -1, ONE, &y[n]);
    add(c, 1, ONE, &y[n]);
    if (n == 0 || n == LAST)
      continue;
    add(&x[n + 1], 2, ONE, &x[n]);
    add(&x[n + 1], -1, ONE, &x[n - 1]);
    add(&x[n + 1], 1, P, a);
    add(&x[n + 1], -1, Q, b);
    add(&y[n + 1], 2, ONE, &y[n]);
    add(&y[n + 1], -1, ONE, &y[n - 1]);
    add(&y[n + 1], 1, R, b);
    add(&y[n + 1], -1, S, c);
  }
}

/* p, q, r, s, and v dt in m. */
struct numbers {
  long double at[4], unit;
};

static struct numbers numbers_of(const struct lattice_row *row) {
  long double square = (long double)row->lattice.step * row->lattice.step;
  return (struct numbers){.at = {row->k[0] * square / row->m[0], row->k[1] * square / row->m[0],
                                 row->k[1] * square / row->m[1], row->k[2] * square / row->m[1]},
                          .unit = (long double)row->v * row->lattice.step};
}

static void add_value(struct nb_solution *solution, const char *monitor, const char *quantity, unsigned long n,
                      long double value) {
  char text[3 * NB_NAME_SIZE];
  snprintf(text, sizeof text, "%s.%s at %lu cycles", monitor, quantity, n);
  solution_value(solution, (double)value, text);
}

/* The sum of forces at t_n and the velocity over the previous step, of disc x (0) or y (1) along the row. */
static void add_disc(struct nb_solution *solution, const char *monitor, const struct lattice_row *row,
                     const struct hand *hand, int disc, unsigned long n) {
  struct numbers numbers = numbers_of(row);
  const struct lattice_contact *between = &row->lattice.contacts[row->contact[1]];
  long double before = evaluate(&hand->overlap[disc][n], numbers.at) * row->k[disc];
  long double behind = evaluate(&hand->overlap[disc + 1][n], numbers.at) * row->k[disc + 1];
  long double force = (before - behind) * numbers.unit;
  struct polynomial step = {{0}};
  add(&step, 1, ONE, &hand->displacement[disc][n]);
  add(&step, -1, ONE, &hand->displacement[disc][n - 1]);
  long double speed = evaluate(&step, numbers.at) * row->v;
  add_value(solution, monitor, "fx", n, force * between->ex);
  add_value(solution, monitor, "fy", n, force * between->ey);
  add_value(solution, monitor, "vx.half", n, speed * between->ex);
  add_value(solution, monitor, "vy.half", n, speed * between->ey);
}

static enum nb_status add_contact(struct nb_solution *solution, const char *monitor, const struct lattice_row *row,
                                  const struct hand *hand, int place, unsigned long n, struct nb_error *error) {
  struct numbers numbers = numbers_of(row);
  long double overlap = numbers.unit * evaluate(&hand->overlap[place][n], numbers.at);
  if (overlap < 0)
    return nb_error_set(
        error, NB_BAD_USE,
        "the contact of monitor %s opens at cycle %lu: use a shorter step, with which no contact opens in "
        "%d cycles",
        monitor, n, (int)LAST);
  add_value(solution, monitor, "overlap", n, overlap);
  add_value(solution, monitor, "normal", n, overlap * row->k[place]);
  return NB_OK;
}

static enum nb_status add_cycles(struct nb_solution *solution, const struct nb_scene *scene,
                                 const struct lattice_row *row, const struct hand *hand, struct nb_error *error) {
  enum nb_status status = NB_OK;
  for (size_t i = 0; i < scene->monitor_count; i++) {
    const struct nb_monitor *monitor = &scene->monitors[i];
    int place = lattice_row_place(row, lattice_contact_of(&row->lattice, monitor));
    for (unsigned long n = 1; n <= LAST && n <= row->steady && status == NB_OK; n++) {
      if (place >= 0)
        status = add_contact(solution, monitor->name, row, hand, place, n, error);
      if (monitor->kind == NB_MONITOR_PARTICLE)
        add_disc(solution, monitor->name, row, hand, monitor->a, n);
    }
  }
  return status;
}

static enum nb_status add_curves(struct nb_solution *solution, const struct nb_scene *scene,
                                 const struct lattice *lattice, struct nb_error *error) {
  if (lattice->undamped < lattice->cycles || !lattice->one_step)
    return NB_OK;
  struct oscillation_modes modes = oscillation_modes_create(lattice);
  enum nb_status status = NB_OK;
  struct nb_error open;
  bool stays_closed = lattice_check_run(lattice, &modes, &open) == NB_OK;
  for (size_t i = 0; i < scene->monitor_count && stays_closed && status == NB_OK; i++) {
    int contact = lattice_contact_of(lattice, &scene->monitors[i]);
    char quantity[2 * NB_NAME_SIZE];
    snprintf(quantity, sizeof quantity, "%s.normal", scene->monitors[i].name);
    if (contact >= 0)
      status = lattice_add_curves(solution, lattice, &modes, quantity, 2 * (size_t)contact, error);
  }
  oscillation_modes_free(&modes);
  return status;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct lattice_row row;
  enum nb_status status = lattice_row_build(&row, scene, error);
  if (status != NB_OK)
    return status;
  struct hand *hand = calloc(1, sizeof *hand);
  if (!hand) {
    lattice_row_free(&row);
    return nb_error_memory(error);
  }
  calculate(hand);
  status = add_cycles(solution, scene, &row, hand, error);
  if (status == NB_OK)
    status = add_curves(solution, scene, &row.lattice, error);
  free(hand);
  lattice_row_free(&row);
  return status == NB_OK ? solution_status(solution, error) : status;
}

const struct nb_reference reference_two_wall_compression = {
    .name = "two_wall_compression",
    .title = "two discs between two approaching walls: the first cycles by hand, in integers",
    .source = "[CS79 1-7]",
    .accepts = {HAS_DISCS, HAS_SPHERES, HAS_MOVING_WALLS, HAS_OFFSET_WALLS, HAS_FRICTION, HAS_ALL_DAMPING,
                HAS_DAMPING_CHANGE, HAS_STEP_CHANGE},
    .needs = {HAS_WALLS},
    .normal = "linear",
    .shear = "none linear",
    .solve = solve,
};
