/* Reference: a square lattice of n_x by n_y equal discs between the four walls of a box, at rest, without friction or gravity.
 *
 * All contacts of a row carry the same force F_x, those of a column F_y, and so do those with the walls:
 *
 *   W = 2 R n_x - (n_x + 1) F_x/k_n,   F_x = s_xx H/n_y          H = 2 R n_y - (n_y + 1) F_y/k_n,   F_y = s_yy W/n_x
 *
 *   W, H  width and height of the box, m      s  its stress, compression positive, Pa (discs are 1 m thick)
 *
 * Two equations of W, H and the two stresses. Each stage says two of the four, of which it begins where the one before it ended:
 *
 *   servo xx S              s_xx = S; likewise yy
 *   box strain              W <- W (1 + L_xx dt)^N, of what is not held; likewise H
 *   servo isotropic P       s_xx = s_yy = P
 *   servo mean P            s_xx + s_yy = 2 P; width and height grow by the same share, so W/H stays
 *
 * Known of a stage at whose end all is at rest: box.width, box.height, box.stress.xx, .yy in it, and of a watched wall fx and fy.
 * By Newton's method. Exact for servos that have come to their end.
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
enum hold { WIDTH_HEIGHT, STRESS_HEIGHT, WIDTH_STRESS, STRESSES, MEAN_SHAPE };

/* What is left of the two equations, and of the two that the stage says. */
static void left(double f[4], const struct lattice *it, const struct state *s, enum hold hold, const struct state *to) {
  f[0] = 2 * it->r * it->nx - (it->nx + 1) * s->sx * s->h / (it->ny * it->k) - s->w;
  f[1] = 2 * it->r * it->ny - (it->ny + 1) * s->sy * s->w / (it->nx * it->k) - s->h;
  const bool wide = hold == WIDTH_HEIGHT || hold == WIDTH_STRESS, high = hold == WIDTH_HEIGHT || hold == STRESS_HEIGHT;
  f[2] = hold == MEAN_SHAPE ? (s->sx + s->sy - to->sx - to->sy) / it->k
         : wide             ? s->w - to->w
                            : (s->sx - to->sx) / it->k;
  f[3] = hold == MEAN_SHAPE ? s->w * to->h - s->h * to->w : high ? s->h - to->h : (s->sy - to->sy) / it->k;
}

/* Gauss's elimination with the largest pivot. */
static void solve_equations(double a[4][5], double x[4]) {
  for (int k = 0; k < 4; k++) {
    int p = k;
    for (int i = k + 1; i < 4; i++)
      p = fabs(a[i][k]) > fabs(a[p][k]) ? i : p;
    for (int j = 0; j < 5; j++) {
      const double spare = a[k][j];
      a[k][j] = a[p][j], a[p][j] = spare;
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

/* The equations are of second degree at most, so a difference over any way is as good as a slope: Newton's method by secants. */
static struct state settle(const struct lattice *it, enum hold hold, const struct state *to) {
  struct state s = *to;
  const double way[4] = {1e-6 * it->r, 1e-6 * it->r, 1e-6 * it->k, 1e-6 * it->k};
  for (int turn = 0; turn < 20; turn++) {
    double f[4], g[4], a[4][5], x[4];
    left(f, it, &s, hold, to);
    for (int j = 0; j < 4; j++) {
      struct state near = s;
      *(j == 0 ? &near.w : j == 1 ? &near.h : j == 2 ? &near.sx : &near.sy) += way[j];
      left(g, it, &near, hold, to);
      for (int i = 0; i < 4; i++)
        a[i][j] = g[i] - f[i], a[i][4] = -f[i];
    }
    solve_equations(a, x);
    s.w += x[0] * way[0], s.h += x[1] * way[1], s.sx += x[2] * way[2], s.sy += x[3] * way[3];
  }
  return s;
}

/* The lattice of the page: rows from south to north, all touching. */
static bool find_lattice(struct lattice *it, const struct nb_scene *scene) {
  const struct nb_particle *first = scene->particles;
  size_t nx = 1;
  while (nx < scene->particle_count && scene->particles[nx].y == first->y)
    nx++;
  *it = (struct lattice){(double)nx, (double)(scene->particle_count / nx), first->radius,
                         matter_pair(scene, first->material, first->material).kn};
  bool is = scene->wall_count == 4 && scene->particle_count % nx == 0;
  for (size_t k = 0; k < scene->particle_count; k++) {
    const struct nb_particle *particle = &scene->particles[k];
    const double x = first->x + 2 * it->r * (double)(k % nx), y = first->y + 2 * it->r * (double)(k / nx);
    is = is && particle->radius == it->r && particle->material == first->material &&
         fabs(particle->x - x) + fabs(particle->y - y) < 1e-12 * it->r * it->nx * it->ny;
  }
  for (size_t w = 0; w < scene->wall_count; w++)
    is = is && matter_pair(scene, first->material, scene->walls[w].material).kn == it->k;
  return is;
}

static double grown(double length, double rate, const struct nb_stage *stage) {
  const double one = stage->box.per_cycle ? rate : rate * stage->step.value;
  return stage->box_line ? length * exp((double)stage->cycles * log1p(one)) : length;
}

/* What the stage holds; false when it is none of these. */
static bool held(enum hold *hold, struct state *to, const struct nb_stage *stage) {
  const struct nb_servo *servo = &stage->servo;
  const bool x = servo->line && servo->controlled[0], y = servo->line && servo->controlled[1],
             mean = servo->line && servo->mean;
  *hold = mean ? MEAN_SHAPE : x && y ? STRESSES : x ? STRESS_HEIGHT : y ? WIDTH_STRESS : WIDTH_HEIGHT;
  if (x)
    to->sx = servo->stress[0];
  if (y)
    to->sy = servo->stress[1];
  if (!x || mean)
    to->w = grown(to->w, stage->box.xx, stage);
  if (!y || mean)
    to->h = grown(to->h, stage->box.yy, stage);
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
    return nb_error_set(error, NB_BAD_USE,
                        "boxed_lattice wants one `lattice discs` in a box of the same stiffness, touching");
  struct state s = {scene->walls[0].h2 - scene->walls[0].h1, scene->walls[1].h2 - scene->walls[1].h1, 0, 0};
  for (size_t k = 0; k < scene->stage_count; k++) {
    enum hold hold;
    if (!held(&hold, &s, &scene->stages[k]))
      return nb_error_set(error, NB_BAD_USE, "boxed_lattice wants stages of `box strain` and `servo ... by box` alone");
    s = settle(&it, hold, &s);
    add_stage(solution, scene, scene->stages[k].name, &s);
  }
  return solution_full(solution, error);
}

const struct nb_reference reference_boxed_lattice = {
    .name = "boxed_lattice",
    .title = "a square lattice of discs between four walls at rest: springs in rows and columns",
    .source = "-",
    .accepts = {HAS_DISCS, HAS_BOX_STRAIN, HAS_SERVO, HAS_RAMP, HAS_STILL, HAS_STEP_CHANGE, HAS_DAMPING_CHANGE,
                HAS_ALL_DAMPING},
    .needs = {HAS_WALLS},
    .normal = "linear",
    .shear = "none",
    .solve = solve,
};
