/* Reference: R89's FRACC of one disc that oscillates between two walls that it touches, or moves on a circle between
 * four walls.
 *
 * FRACC is the time step over a critical step that R89 estimates from the change of the force on each particle.
 *
 * r = (x, y) is the position of the disc from the middle, r_n after n cycles; m is its mass and k_n the stiffness of a
 * contact. With w^2 = 2 k_n/m and h = w dt/2 the cycle is  r_(n+1) = 2 r_n - r_(n-1) - 4 h^2 r_n  in x and y
 * separately, with x_1 = x_0 (1 - 2 h^2) from rest and y_1 = v_y dt from the middle. The sum of forces is -2 k_n r, so
 * [R89 4.36-4.40] gives
 *
 *   FRACC = h (| |r_(n+1)| - |r_n| | / |r_(n+1) - r_n|)^(1/2)
 *
 * On a line this is h while x keeps its sign; on a circle it is 0. For h > 1 the motion becomes x_(n+1) = -g x_n with
 * g = (h + (h^2 - 1)^(1/2))^2, and
 *
 *   FRACC = (h (h^2 - 1)^(1/2))^(1/2)
 *
 * Returns step.fracc max, and D.x max for the disc monitored as D, from the recursion.
 * Accepts one disc, two walls normal to x that touch it, two normal to y that may or may not touch it, both pairs at
 * equal distances from the origin and not ending beside the disc, linear springs, no shear, no damping, `step F of
 * single-contact`, one stage, and a motion that neither opens nor closes a contact. Error: rounding.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "reference.h"

struct position {
  double x, y; /* m */
};

static double fracc(double h, struct position before, struct position now) {
  const double distance = hypot(now.x - before.x, now.y - before.y);
  return distance > 0 ? h * sqrt(fabs(hypot(now.x, now.y) - hypot(before.x, before.y)) / distance) : 0;
}

/* Distances of two walls along y and of two along x from the origin; NAN: they are not at equal distances on both sides.
 * ends[0], ends[1]: how far the walls along y, and those along x, extend at least in both directions from the origin.
 * False: a wall has another stiffness than the first one. */
static bool find_walls(const struct nb_scene *scene, double *beside, double *above, double ends[2]) {
  const int material = scene->particles[0].material;
  double low[2] = {0}, high[2] = {0}; /* x of the walls along y, y of the walls along x */
  bool same = true;
  for (int w = 0; w < 4; w++) {
    const struct nb_wall *wall = &scene->walls[w];
    const int axis = wall->ex == 0 ? 0 : 1;
    const double place = axis == 0 ? wall->x : wall->ey == 0 ? wall->y : NAN;
    *(place < 0 ? &low[axis] : &high[axis]) = place;
    const double middle = axis == 0 ? wall->y : wall->x, sign = axis == 0 ? wall->ey : wall->ex;
    const double from = middle + sign * wall->h1, to = middle + sign * wall->h2;
    ends[axis] = fmin(ends[axis], fmin(-fmin(from, to), fmax(from, to)));
    same = same &&
           matter_pair(scene, material, wall->material).kn == matter_pair(scene, material, scene->walls[0].material).kn;
  }
  *beside = high[0] > 0 && low[0] == -high[0] ? high[0] : NAN;
  *above = high[1] > 0 && low[1] == -high[1] ? high[1] : NAN;
  return same;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_stage *stage = &scene->stages[0];
  const struct nb_particle *disc = &scene->particles[0];
  if (scene->particle_count != 1 || scene->wall_count != 4 || stage->step.kind != NB_STEP_SINGLE_CONTACT ||
      scene->stage_count != 1 || disc->y != 0 || disc->vx != 0)
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `fracc` is for one disc between four walls, with `step F of single-contact`");
  const double kn = matter_pair(scene, disc->material, scene->walls[0].material).kn;
  const double h = stage->step.value * sqrt(2); /* two springs: w^2 = 2 k/m */
  const double dt = 2 * h / sqrt(2 * kn / matter_mass(scene, disc));
  double beside, above, ends[2] = {INFINITY, INFINITY};
  if (!find_walls(scene, &beside, &above, ends))
    return nb_error_set(error, NB_BAD_USE, "the reference `fracc` is for walls of one stiffness");
  const double hy = above < disc->radius ? h : 0;
  struct position before = {disc->x, 0}, now = {disc->x * (1 - 2 * h * h), disc->vy * dt};
  double largest_x = fmax(before.x, now.x), largest = fracc(h, before, now);
  double reach_x = fmax(fabs(before.x), fabs(now.x)), reach_y = fabs(now.y);
  for (unsigned long n = 1; n < stage->cycles; n++) {
    const struct position next = {2 * now.x - before.x - 4 * h * h * now.x, 2 * now.y - before.y - 4 * hy * hy * now.y};
    before = now, now = next;
    largest_x = fmax(largest_x, now.x), largest = fmax(largest, fracc(h, before, now));
    reach_x = fmax(reach_x, fabs(now.x)), reach_y = fmax(reach_y, fabs(now.y));
  }
  if (!(reach_x < disc->radius - beside) || !(reach_y < fabs(disc->radius - above)) || reach_y > ends[0] ||
      reach_x > ends[1])
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `fracc` is for two walls along y that the disc touches all the time and two along "
        "x that it touches all the time or never, at equal distances from the origin");
  solution_value(solution, largest, "step.fracc max");
  solution_value(solution, largest_x, "D.x max");
  return solution_status(solution, error);
}

const struct nb_reference reference_fracc = {
    .name = "fracc",
    .title =
        "FRACC of a disc that oscillates between two walls or circles between four, from the recursion of the cycle",
    .source = "[R89 4.35-4.40]",
    .accepts = {HAS_DISCS, HAS_VELOCITIES},
    .needs = {HAS_WALLS},
    .normal = "linear",
    .shear = "none",
    .solve = solve,
};
