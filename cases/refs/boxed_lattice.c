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
 * Exact if everything is at rest at the end of each stage and a servo has reached its target. Solved by Newton's
 * method.
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

/* Residuals of the two equilibrium equations and of the two equations of the stage. `to` has the values that the stage
 * prescribes. */
static void residuals(double f[4], const struct lattice *it, const struct state *s, enum control control,
                      const struct state *to) {
  f[0] = 2 * it->r * it->nx - (it->nx + 1) * s->sx * s->h / (it->ny * it->k) - s->w;
  f[1] = 2 * it->r * it->ny - (it->ny + 1) * s->sy * s->w / (it->nx * it->k) - s->h;
  const bool wide = control == WIDTH_HEIGHT || control == WIDTH_STRESS,
             high = control == WIDTH_HEIGHT || control == STRESS_HEIGHT;
  f[2] = control == MEAN_SHAPE ? (s->sx + s->sy - to->sx - to->sy) / it->k
         : wide                ? s->w - to->w
                               : (s->sx - to->sx) / it->k;
  f[3] = control == MEAN_SHAPE ? s->w * to->h - s->h * to->w : high ? s->h - to->h : (s->sy - to->sy) / it->k;
}

/* Gaussian elimination with partial pivoting. */
static void solve_equations(double a[4][5], double x[4]) {
  for (int k = 0; k < 4; k++) {
    int p = k;
    for (int i = k + 1; i < 4; i++)
      p = fabs(a[i][k]) > fabs(a[p][k]) ? i : p;
    for (int j = 0; j < 5; j++) {
      const double swapped = a[k][j];
      a[k][j] = a[p][j], a[p][j] = swapped;
    }
    for (int i = k + 1; i < 4; i++)
      for (int j = 4; j >= k; j--)
        a[i][j] -= a[i][k] / a[k][k] * a[k][j];
  }
  for (int k = 3; k >= 0; k--) {
    x[k] = a[k][4];
    for (int j = k + 1; j < 4; j++)
      x[k] -= a[k][j] * x[j];
    x[k] /= a[k][k];
  }
}

/* Newton's method. Each residual is linear in each single unknown, so finite differences give the derivatives exactly,
 * except for rounding. */
static struct state equilibrium(const struct lattice *it, enum control control, const struct state *to) {
  struct state s = *to;
  const double delta[4] = {1e-6 * it->r, 1e-6 * it->r, 1e-6 * it->k, 1e-6 * it->k};
  for (int iteration = 0; iteration < 20; iteration++) {
    double f[4], g[4], a[4][5], x[4];
    residuals(f, it, &s, control, to);
    for (int j = 0; j < 4; j++) {
      struct state shifted = s;
      *(j == 0 ? &shifted.w : j == 1 ? &shifted.h : j == 2 ? &shifted.sx : &shifted.sy) += delta[j];
      residuals(g, it, &shifted, control, to);
      for (int i = 0; i < 4; i++)
        a[i][j] = g[i] - f[i], a[i][4] = -f[i];
    }
    solve_equations(a, x);
    s.w += x[0] * delta[0], s.h += x[1] * delta[1], s.sx += x[2] * delta[2], s.sy += x[3] * delta[3];
  }
  return s;
}

/* Reads the lattice: equal touching discs, listed row by row in the order of y, and four walls with the stiffness of
 * the discs. False: the scene is another one. */
static bool find_lattice(struct lattice *it, const struct nb_scene *scene) {
  const struct nb_particle *first = scene->particles;
  size_t nx = 1;
  while (nx < scene->particle_count && scene->particles[nx].y == first->y)
    nx++;
  *it = (struct lattice){(double)nx, (double)(scene->particle_count / nx), first->radius,
                         matter_pair(scene, first->material, first->material).kn};
  bool right = scene->wall_count == 4 && scene->particle_count % nx == 0;
  for (size_t k = 0; k < scene->particle_count; k++) {
    const struct nb_particle *particle = &scene->particles[k];
    const double x = first->x + 2 * it->r * (double)(k % nx), y = first->y + 2 * it->r * (double)(k / nx);
    right = right && particle->radius == it->r && particle->material == first->material &&
            fabs(particle->x - x) + fabs(particle->y - y) < 1e-12 * it->r * it->nx * it->ny;
  }
  for (size_t w = 0; w < scene->wall_count; w++)
    right = right && matter_pair(scene, first->material, scene->walls[w].material).kn == it->k;
  return right;
}

static double strained_length(double length, double rate, const struct nb_stage *stage) {
  const double one = stage->box.per_cycle ? rate : rate * stage->step.value;
  return stage->box_line ? length * exp((double)stage->cycles * log1p(one)) : length;
}

/* Reads what the stage controls. False: the reference does not cover it. */
static bool read_stage(enum control *control, struct state *to, const struct nb_stage *stage) {
  const struct nb_servo *servo = &stage->servo;
  const bool x = servo->line && servo->controlled[0], y = servo->line && servo->controlled[1],
             mean = servo->line && servo->mean;
  *control = mean ? MEAN_SHAPE : x && y ? STRESSES : x ? STRESS_HEIGHT : y ? WIDTH_STRESS : WIDTH_HEIGHT;
  if (x)
    to->sx = servo->stress[0];
  if (y)
    to->sy = servo->stress[1];
  if (!x || mean)
    to->w = strained_length(to->w, stage->box.xx, stage);
  if (!y || mean)
    to->h = strained_length(to->h, stage->box.yy, stage);
  return !stage->motion_count && (!servo->line || servo->box) &&
         (!mean || !stage->box_line || stage->box.xx == stage->box.yy) &&
         (!stage->box_line || stage->box.per_cycle || stage->step.kind == NB_STEP_TIME);
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
  struct state s = {scene->walls[0].h2 - scene->walls[0].h1, scene->walls[1].h2 - scene->walls[1].h1, 0, 0};
  for (size_t k = 0; k < scene->stage_count; k++) {
    enum control control;
    if (!read_stage(&control, &s, &scene->stages[k]))
      return nb_error_set(error, NB_BAD_USE,
                          "the reference `boxed_lattice` is for stages that move walls by `box strain` and `servo ... "
                          "through box` alone");
    s = equilibrium(&it, control, &s);
    add_stage(solution, scene, scene->stages[k].name, &s);
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
