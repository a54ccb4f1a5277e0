/* Reference: a square lattice of springs in a periodic cell with a servo, for small strains.
 *
 * The strain rate is l + L, 1/s: l is given on the page, L is that of the servo. All discs follow the cell without
 * rotation, and discs are 1 m thick, so k_n and k_s are also the stiffnesses of the lattice in Pa. rho is the mass of
 * the discs over the volume of the cell.
 *
 *   s_xx' = -k_n (l_xx + L_xx),   s_yy' = -k_n (l_yy + L_yy),   s_xy' = -k_s (l_xy + L_xy)
 *   B = k_n/2,   T = W (rho/B)^(1/2),   W = (area of the cell)^(1/2)
 *
 * The error of a controlled stress s with target s0 is e = s - s0. A ramp changes s0 at the rate q. Z is the integral
 * term of the servo. With f = 1 for xx and yy, and f = k_s/k_n for xy:
 *
 *   e' = -f e/T - f k_n Z - c,   Z' = e/(16 k_n T^2),   c = f k_n l + q,   so   e'' + f e'/T + f e/(16 T^2) = 0
 *   e  = a exp(-u t) + b exp(-v t),   u, v = f (1 -+ (1 - 1/(4f))^(1/2))/(2T)
 *
 * a and b follow from e(0) and e'(0) at the beginning of the stage. At this time the servo sets Z = -g e/(k_n T),
 * g = (1 - (3/4)^(1/2))/2 (src/loading/servo.c). While |e| exceeds k_n T r, where r is the `at most` rate, the servo
 * limits e/(k_n T) to r and sets Z = -g r in each of its steps, so e' = -f k_n r (1 - g) - c for e > 0. A stress that
 * is not controlled follows s' = -k_n l or -k_s l. `servo mean` controls (xx + yy)/2; the difference xx - yy then
 * follows l.
 *
 * Returns   cell.stress.xx, cell.stress.yy, cell.stress.xy versus time, Pa
 * Error     relative, of the order of s/k_n and dt/T
 * Range     the rate of one component only may be limited, or those of xx and yy if they are equal
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reference.h"

struct lattice {
  double kn, ks, wave; /* k_n and k_s, Pa; T, s */
  double step;         /* s */
};

/* One stress component during one stage. */
struct piece {
  double begin;              /* s */
  double from, rate;         /* controlled: s0 at the beginning, Pa, and q, Pa/s; not controlled: s and s' */
  double initial;            /* e at the beginning, Pa; 0 if not controlled, as the values below */
  double slope, limited;     /* e' while the rate is limited, Pa/s; the time for which it is limited, s */
  double complex a, b, u, v; /* Pa, 1/s */
};

/* One stress component during all stages. */
struct course {
  size_t count;
  struct piece piece[];
};

static double value(const struct piece *it, double time) {
  const double t = time - it->begin, unlimited = t - it->limited;
  const double e = unlimited < 0 ? it->initial + it->slope * t
                                 : creal(it->a * cexp(-it->u * unlimited) + it->b * cexp(-it->v * unlimited));
  return it->from + it->rate * t + e;
}

static double at(const void *data, double time) {
  const struct course *course = data;
  size_t k = course->count - 1;
  while (k > 0 && course->piece[k].begin > time)
    k--;
  return value(&course->piece[k], time);
}

/* Solves for the error e of a controlled stress from its initial value. `max_rate` is r. */
static void solve_equations(struct piece *it, const struct lattice *lattice, double f, double initial, double c,
                            double max_rate) {
  const double t = lattice->wave, g = (1 - sqrt(0.75)) / 2, largest = copysign(lattice->kn * t * max_rate, initial);
  const double complex root = csqrt(1 - 1 / (4 * f));
  it->initial = initial;
  it->u = f * (1 - root) / (2 * t), it->v = f * (1 + root) / (2 * t);
  it->slope = -copysign(f * lattice->kn * max_rate * (1 - g), initial) - c;
  it->limited = fabs(initial) > fabs(largest) ? (largest - initial) / it->slope : 0;
  const double e = fabs(initial) > fabs(largest) ? largest : initial;
  it->a = (it->v * e - f * (1 - g) * e / t - c) / (it->v - it->u); /* e' is -f (1 - g) e/T - c */
  it->b = e - it->a;
}

/* Solves one stage for xx, yy and xy; s has these stresses at its beginning, Pa. */
static void advance(struct piece *const now[3], const struct lattice *lattice, const struct nb_stage *stage,
                    struct nb_strain_rate strain, double begin, const double s[3]) {
  const struct nb_servo *servo = &stage->servo;
  const double length = (double)stage->cycles * lattice->step, l[3] = {strain.xx, strain.yy, strain.xy};
  for (int k = 0; k < 3; k++) {
    struct piece *it = now[k];
    const double f = k < 2 ? 1 : lattice->ks / lattice->kn;
    *it = (struct piece){.begin = begin, .from = s[k], .rate = -f * lattice->kn * l[k]};
    if (!servo->line || !servo->controlled[k] || (servo->mean && k == 2))
      continue;
    /* with `mean`, s is the controlled mean plus a deviation from it, which follows l */
    const double change = servo->mean ? (l[0] + l[1]) / 2 : l[k], begun = servo->mean ? (s[0] + s[1]) / 2 : s[k];
    const double target = servo->stress[k], q = servo->ramp ? (target - begun) / length : 0;
    const double from = servo->ramp ? begun : target;
    solve_equations(it, lattice, f, begun - from, f * lattice->kn * change + q, servo->max_rate);
    it->from = from + s[k] - begun, it->rate = q - f * lattice->kn * (l[k] - change);
  }
}

/* True: the scene is a square lattice of equal discs in a cell, and the reference covers its stages. */
static bool fits(const struct nb_scene *scene) {
  bool right = scene->step.kind == NB_STEP_TIME;
  for (size_t b = 0; b < scene->particle_count && right; b++) {
    const struct nb_particle *particle = &scene->particles[b], *first = &scene->particles[0];
    const double spacing = sqrt(scene->cell.h[0] * scene->cell.h[3] / (double)scene->particle_count);
    right = particle->radius == first->radius && particle->material == first->material &&
            fabs(remainder(particle->x - first->x, spacing)) < 1e-9 * spacing &&
            fabs(remainder(particle->y - first->y, spacing)) < 1e-9 * spacing;
  }
  for (size_t s = 0; s < scene->stage_count && right; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    right = !stage->cell.per_cycle && !stage->servo.per_cycle && stage->cell.xy == stage->cell.yx;
  }
  return right;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  if (!fits(scene))
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `servo_lattice` is for a square lattice of equal discs in a rectangular cell, a step given as a "
        "time, and stages that strain the cell without rotation, or control it with a servo, at rates in 1/s");
  const struct nb_particle *particle = &scene->particles[0];
  const double area = scene->cell.h[0] * scene->cell.h[3], n = (double)scene->particle_count;
  const struct matter_pair pair = matter_pair(scene, particle->material, particle->material);
  const double density = n * matter_mass(scene, particle) / area,
               first = pair.kn * (2 * particle->radius / sqrt(area / n) - 1);
  const struct lattice lattice = {pair.kn, pair.ks, sqrt(area * density / (pair.kn / 2)), scene->step.value};
  static const char *const names[] = {"cell.stress.xx", "cell.stress.yy", "cell.stress.xy"};
  double s[3] = {first, first, 0}, begin = 0;
  struct course *course[3];
  for (int c = 0; c < 3; c++)
    course[c] = calloc(1, sizeof **course + scene->stage_count * sizeof(struct piece));
  if (!course[0] || !course[1] || !course[2]) {
    free(course[0]), free(course[1]), free(course[2]);
    return nb_error_memory(error);
  }
  struct nb_strain_rate strain = {0};
  for (size_t i = 0; i < scene->stage_count; i++) {
    struct piece *const now[] = {&course[0]->piece[i], &course[1]->piece[i], &course[2]->piece[i]};
    if (scene->stages[i].cell_line)
      strain = scene->stages[i].cell;
    advance(now, &lattice, &scene->stages[i], strain, begin, s);
    begin += (double)scene->stages[i].cycles * lattice.step;
    for (int c = 0; c < 3; c++)
      s[c] = value(now[c], begin), course[c]->count++;
  }
  for (int c = 0; c < 3; c++)
    solution_curve(solution, names[c], "time", at, course[c]);
  return solution_status(solution, error);
}

const struct nb_reference reference_servo_lattice = {
    .name = "servo_lattice",
    .title = "a square lattice in a cell with a servo: the error of the stress in closed form",
    .source = "[R89 sec. 4.1]",
    .accepts = {HAS_DISCS, HAS_FRICTION, HAS_CELL_STRAIN, HAS_SERVO, HAS_RAMP},
    .needs = {HAS_CELL},
    .normal = "linear",
    .shear = "linear",
    .solve = solve,
};
