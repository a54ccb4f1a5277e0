/* Reference: a square lattice of n_x by n_y equal discs in a box, at rest, without friction or gravity.
 *
 * All contacts of a row carry the force F_x, and all contacts of a column F_y, including those with the walls:
 *
 *   W = 2 R n_x - (n_x + 1) F_x/k_n,   F_x = s_xx H/n_y          H = 2 R n_y - (n_y + 1) F_y/k_n,   F_y = s_yy W/n_x
 *
 *   W, H  width and height of the box, m      s  its stress, compression positive, Pa (discs are 1 m thick)
 *   R     radius of the discs, m              k_n  normal stiffness, N/m
 *
 * These are two equations for W, H and the two stresses. Each stage gives two more equations. A stage starts from the
 * end of the previous stage:
 *
 *   servo xx S              s_xx = S; likewise yy
 *   box strain              W <- W (1 + L_xx dt)^N in N cycles at the strain rate L, unless the servo controls s_xx;
 *                           likewise H
 *   servo isotropic P       s_xx = s_yy = P
 *   servo mean P            s_xx + s_yy = 2 P; W/H is constant
 *
 * Returns, for each stage:
 *   box.width, box.height, box.stress.xx, box.stress.yy     at its end
 *   M.fx, M.fy                                              for M that monitors a wall
 * Exact if everything is at rest at the end of each stage and a servo has reached its target. Solved in closed form.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "reference.h"

struct state {
  double w, h, sx, sy; /* m, Pa */
};
struct lattice {
  double nx, ny, r, k;
};
enum control { WIDTH_HEIGHT, STRESS_HEIGHT, WIDTH_STRESS, STRESSES, MEAN_SHAPE };

/* Solves the two equations for the two of w, h, sx and sy that the stage does not prescribe. For a mean stress `s` has
 * the previous w and h, whose ratio does not change. False: a contact opens. */
static bool solve_equilibrium(const struct lattice *it, enum control control, struct state *s) {
  const double full_w = 2 * it->r * it->nx, cx = (it->nx + 1) / (it->ny * it->k); /* w = full_w - cx sx h */
  const double full_h = 2 * it->r * it->ny, cy = (it->ny + 1) / (it->nx * it->k); /* h = full_h - cy sy w */
  const double shape = s->w / s->h;
  if (control == STRESSES)
    s->h = (full_h - cy * s->sy * full_w) / (1 - cx * s->sx * cy * s->sy);
  if (control == MEAN_SHAPE)
    s->h = (full_w / cx + full_h / (cy * shape)) / (s->sx + s->sy + shape / cx + 1 / (cy * shape));
  if (control == STRESSES || control == STRESS_HEIGHT)
    s->w = full_w - cx * s->sx * s->h;
  if (control == WIDTH_STRESS)
    s->h = full_h - cy * s->sy * s->w;
  if (control == MEAN_SHAPE)
    s->w = shape * s->h;
  s->sx = (full_w - s->w) / (cx * s->h), s->sy = (full_h - s->h) / (cy * s->w);
  return s->w <= full_w && s->h <= full_h;
}

/* Whether the wall is a side of a box, at the place of a side of the lattice. */
static bool is_side(const struct lattice *it, const struct nb_particle *first, const struct nb_wall *wall) {
  const bool level = wall->iny != 0;
  const double inward = level ? wall->iny : wall->inx;
  const double begin = (level ? first->y : first->x) - it->r, across = 2 * it->r * (level ? it->ny : it->nx);
  const double place = (level ? wall->y : wall->x) - begin - (inward < 0 ? across : 0);
  return inward != 0 && fabs(place) < 1e-9 * it->r;
}

/* Reads the lattice: equal touching discs, listed row by row in the order of y, and a box of the stiffness of the discs
 * that they fill. False: the scene is another one. */
static bool find_lattice(struct lattice *it, const struct nb_scene *scene) {
  const struct nb_particle *first = scene->particles;
  size_t nx = 1;
  while (nx < scene->particle_count && scene->particles[nx].y == first->y)
    nx++;
  *it = (struct lattice){(double)nx, (double)(scene->particle_count / nx), first->radius,
                         matter_pair(scene, first->material, first->material).kn};
  bool right = scene->particle_count % nx == 0;
  for (size_t k = 0; k < scene->particle_count; k++) {
    const struct nb_particle *particle = &scene->particles[k];
    const double x = first->x + 2 * it->r * (double)(k % nx), y = first->y + 2 * it->r * (double)(k / nx);
    right = right && particle->radius == it->r && particle->material == first->material &&
            fabs(particle->x - x) + fabs(particle->y - y) < 1e-12 * it->r * it->nx * it->ny;
  }
  for (size_t w = 0; w < scene->wall_count; w++)
    right = right && is_side(it, first, &scene->walls[w]) &&
            matter_pair(scene, first->material, scene->walls[w].material).kn == it->k;
  return right;
}

static double strained_length(double length, double rate, const struct nb_stage *stage, bool per_cycle) {
  return length * exp((double)stage->cycles * log1p(per_cycle ? rate : rate * stage->step.value));
}

/* Reads what the stage controls. `strain` is the last `box strain` of the page, which a stage inherits; NULL: none.
 * False: the reference does not cover the stage. */
static bool read_stage(enum control *control, struct state *to, const struct nb_stage *stage,
                       const struct nb_strain_rate *strain) {
  const struct nb_servo *servo = &stage->servo;
  const bool x = servo->controlled[0], y = servo->controlled[1];
  *control = servo->mean ? MEAN_SHAPE : x && y ? STRESSES : x ? STRESS_HEIGHT : y ? WIDTH_STRESS : WIDTH_HEIGHT;
  if (x)
    to->sx = servo->stress[0];
  else if (strain)
    to->w = strained_length(to->w, strain->xx, stage, strain->per_cycle);
  if (y)
    to->sy = servo->stress[1];
  else if (strain)
    to->h = strained_length(to->h, strain->yy, stage, strain->per_cycle);
  return !stage->motion_count && (!servo->line || servo->quantity[0].monitor < 0) &&
         (!servo->mean || !strain || strain->xx == strain->yy) &&
         (!strain || strain->per_cycle || stage->step.kind == NB_STEP_TIME);
}

static void add_value(struct nb_solution *solution, const char *of, const char *what, const char *stage, double value) {
  char name[3 * NB_NAME_SIZE];
  snprintf(name, sizeof name, "%s.%s in %s", of, what, stage);
  solution_value(solution, value, name);
}

static void add_stage(struct nb_solution *solution, const struct nb_scene *scene, const char *stage,
                      const struct state *s) {
  add_value(solution, "box", "width", stage, s->w), add_value(solution, "box", "height", stage, s->h);
  add_value(solution, "box", "stress.xx", stage, s->sx), add_value(solution, "box", "stress.yy", stage, s->sy);
  for (size_t w = 0; w < scene->monitor_count; w++) {
    if (scene->monitors[w].kind != NB_MONITOR_WALL)
      continue;
    const struct nb_wall *wall = &scene->walls[scene->monitors[w].a];
    add_value(solution, scene->monitors[w].name, "fx", stage, -wall->inx * s->sx * s->h);
    add_value(solution, scene->monitors[w].name, "fy", stage, -wall->iny * s->sy * s->w);
  }
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  struct lattice it;
  if (!find_lattice(&it, scene))
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `boxed_lattice` is for one `lattice discs` of touching discs in a box of the same stiffness");
  struct state s = {.w = 2 * it.r * it.nx, .h = 2 * it.r * it.ny};
  const struct nb_strain_rate *strain = NULL;
  for (size_t k = 0; k < scene->stage_count; k++) {
    const struct nb_stage *stage = &scene->stages[k];
    enum control control;
    strain = stage->box_line ? &stage->box : strain;
    if (!read_stage(&control, &s, stage, strain))
      return nb_error_set(error, NB_BAD_USE,
                          "the reference `boxed_lattice` is for stages that move walls by `box strain` and `servo ... "
                          "on box through box` alone");
    if (!solve_equilibrium(&it, control, &s))
      return nb_error_set(error, NB_BAD_USE, "the reference `boxed_lattice` is for compressed contacts");
    add_stage(solution, scene, stage->name, &s);
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_boxed_lattice = {
    .name = "boxed_lattice",
    .title = "a square lattice of discs in a box at rest: springs in rows and columns",
    .source = "-",
    .accepts = {HAS_DISCS, HAS_BOX_STRAIN, HAS_SERVO, HAS_RAMP, HAS_ZERO_VELOCITIES, HAS_STEP_CHANGE,
                HAS_DAMPING_CHANGE, HAS_ALL_DAMPING},
    .needs = {HAS_WALLS},
    .normal = "linear",
    .shear = "none",
    .solve = solve,
};
