/* Reference: the shear laws along a path of tangential displacement at constant normal force, each in closed form.
 *
 * N and T are the normal and the shear force, delta is the tangential displacement, a the contact radius and mu the
 * friction coefficient. In dimensionless numbers t = T/mu N, d = delta/A, A = 3 mu N/(16 G* a), a branch that begins at
 * (t0, d0) in the direction s = 1 or -1 is
 *
 *   t = t0 + s (1 - (1 - |d - d0|)^(3/2))               virgin loading                                      [R89 3.25]
 *   t = t0 + 2 s (1 - (1 - |d - d0|/2)^(3/2))           any later branch                              [R89 3.40, 3.50]
 *
 * A branch that returns to where the previous branch began is erased together with the previous branch.
 * mindlin_deresiewicz keeps all branches; randall keeps three and moves back and forth on the third. So does
 * randall_literal, but [R89 4.24] as printed has T*, the T at which the second branch began, in place of T**, the T at
 * which the third one began. With t* = (T*)/(mu N), u = |t - t*|, and u0 the value of u at the beginning of the branch,
 * the third branch of randall_literal is
 *
 *   (1 + u/2)^(2/3) = (1 + u0/2)^(2/3) - |d - d0|/2     which is stiffer than a contact that sticks everywhere
 *
 * linear, mindlin and mindlin_scaled are t = k d between -1 and 1, with k = k_s A/(mu N) for `linear` and k = 3/2 for
 * the other two.
 *
 * Returns shear (N) and work.shear (J) at each step and at the end of each segment, and `psi2 error`. This is the
 * largest error of psi2, the normalized angle of rebound, that the law causes in an oblique impact (impact_laws.c,
 * impact_springs.c) for 0.1 <= psi1 <= 6, with the Poisson's ratio of the page. randall_literal has no `psi2 error`,
 * because it does not converge there. The work is integrated by Simpson's rule in 32 parts of a step.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "impact_springs.h"
#include "path.h"

enum { BRANCHES = 64 };

struct branch {
  double t, d, sense; /* t0, d0, s */
  double size;        /* 1: virgin loading; 2: any later branch */
};

struct law {
  const char *name;
  int branches;  /* number of branches that the law keeps; 0: the law is a spring */
  double spring; /* k */
  bool literal;  /* randall_literal */
};

struct state {
  struct law law;
  double t, d;
  int count;
  struct branch branches[BRANCHES];
};

/* ---- branches ---- */

static bool literal_third(const struct state *s) { return s->law.literal && s->count == 3; }

static double force_at(const struct state *s, double d) {
  const struct branch *b = &s->branches[s->count - 1];
  if (literal_third(s)) {
    const double star = b[-1].t, u = b->sense * (star - b->t);
    return star - b->sense * 2 * (pow(pow(1 + u / 2, 2. / 3) - b->sense * (d - b->d) / 2, 1.5) - 1);
  }
  return b->t + b->sense * b->size * (1 - pow(fmax(1 - b->sense * (d - b->d) / b->size, 0), 1.5));
}

/* The d at which the present branch ends if the motion continues in the direction of the branch. */
static double end_of(const struct state *s) {
  const struct branch *b = &s->branches[s->count - 1];
  if (literal_third(s))
    return b->d + b->sense * 2 * (pow(1 + b->sense * (b[-1].t - b->t) / 2, 2. / 3) - 1);
  return s->count == 1 ? b->d + b->sense : s->count == 2 ? 2 * b[-1].d - b->d : b[-1].d;
}

/* Moves beyond the end of a branch; `end` is the d of this end, `d` that of the target. After the first branch the
 * contact slides. After the second one, virgin loading in the other direction follows. After a later one, the path
 * continues on the branch before the previous one. The third branch of randall_literal need not end at the d at which
 * the second branch began. The first branch, on which the path continues, is then shifted by the difference. */
static void erase(struct state *s, double end, double d) {
  struct branch *b = &s->branches[s->count - 1];
  if (s->count == 1) {
    b->d = d - b->sense;
  } else if (s->count == 2) {
    b[-1].sense = b->sense, s->count = 1;
  } else {
    b[-2].d += end - b[-1].d, s->count -= 2;
  }
}

static void advance(struct state *s, double d) {
  if (s->law.branches == 0) {
    s->t = fmax(-1, fmin(1, s->t + s->law.spring * (d - s->d))), s->d = d;
    return;
  }
  while (d != s->d) {
    const double sense = d > s->d ? 1 : -1;
    struct branch *b = s->count ? &s->branches[s->count - 1] : NULL;
    const bool reversal = !b || sense != b->sense;
    if (reversal && s->count < s->law.branches) {
      b = &s->branches[s->count++];
      *b = (struct branch){s->t, s->d, sense, s->count == 1 ? 1 : 2};
    }
    const bool back = sense != b->sense; /* back along the last branch, elastically, up to T** */
    const double end = back ? b->d : end_of(s);
    const bool beyond = sense * (d - end) > 0;
    s->t = force_at(s, beyond ? end : d);
    s->d = beyond && s->count > 1 ? end : d;
    if (!beyond)
      return;
    if (back)
      s->count--;
    else
      erase(s, end, d);
  }
}

static double work(struct state s, double d) {
  enum { PARTS = 32 };
  const double from = s.d;
  double sum = s.t;
  for (int k = 1; k <= PARTS; k++) {
    advance(&s, from + (d - from) * k / PARTS);
    sum += (k == PARTS ? 1 : k % 2 ? 4 : 2) * s.t;
  }
  return sum / (3. * PARTS) * (d - from);
}

/* ---- the path ---- */

enum { SHEAR, WORK, COLUMNS };
static const char *const names[COLUMNS] = {"shear", "work.shear"};

/* Computes the shear force and its work at each step of the path. False: the normal force changes under shear, or a
 * segment prescribes a shear force. */
static bool walk_path(struct state *s, const struct path_contact *contact, double ks, const struct nb_scene *scene,
                      struct path_column *columns[]) {
  struct path_walk walk = path_walk(scene);
  struct path_point now = {0};
  struct path_target target;
  double limit = 0, scale = 0, done = 0; /* mu N in newtons; A in metres; work in units of mu N A */
  for (size_t k = 1; path_next(&walk, now, &target); k++) {
    const double approach = target.normal_force ? path_overlap(contact, target.normal) : target.normal;
    if (fabs(approach - now.approach) > 1e-9 * now.approach) {
      if (s->t != 0 || s->count || target.shear != 0)
        return false;
      now.approach = approach, now.normal = path_normal(contact, approach);
      limit = contact->friction * now.normal, scale = contact->friction * contact->kappa * approach;
      s->law.spring = strcmp(s->law.name, "linear") == 0 ? ks * scale / limit : 1.5;
    }
    if (target.shear_force)
      return false;
    done += work(*s, target.shear / scale);
    advance(s, target.shear / scale);
    now.slip = target.shear, now.shear = s->t * limit;
    columns[SHEAR]->values[k] = now.shear, columns[WORK]->values[k] = done * limit * scale;
  }
  return true;
}

/* ---- the impact ---- */

static double psi2_of(const char *law, double chi, double psi1) {
  struct impact_path path;
  const bool made = law ? impact_law(&path, law, 1.5, chi, psi1, 4000) : impact_exact(&path, chi, psi1, 400);
  const double psi2 = made ? path.psi2 : NAN;
  impact_path_free(&path);
  return psi2;
}

/* The largest error of psi2 for a solid sphere that strikes a wall of its own material [R89 5.14]. `linear` has the
 * stiffness k_s = 8 G* a at the largest overlap. law: the name of the shear law; kappa: the compliance ratio. */
static double psi2_error(const char *law, double kappa) {
  const double chi = 3.5 / (2 * kappa);
  double largest = 0;
  for (int k = 1; k <= 60; k++)
    largest = fmax(largest, fabs(psi2_of(law, chi, 0.1 * k) - psi2_of(NULL, chi, 0.1 * k)));
  return largest;
}

/* ---- */

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  static const struct law laws[] = {{.name = "linear"},
                                    {.name = "mindlin"},
                                    {.name = "mindlin_scaled"},
                                    {.name = "randall", .branches = 3},
                                    {.name = "randall_literal", .branches = 3, .literal = true},
                                    {.name = "mindlin_deresiewicz", .branches = BRANCHES}};
  size_t which = 0;
  while (strcmp(laws[which].name, scene->shear) != 0) /* one of the laws, or the reference would not be called */
    which++;
  const struct path_contact contact = path_contact(scene);
  const struct nb_particle *particles = scene->particles;
  const int other = scene->particle_count == 1 ? scene->walls[0].material : particles[1].material;
  struct path_column *columns[COLUMNS];
  bool made = true;
  for (int c = 0; c < COLUMNS; c++)
    made = (columns[c] = path_column(scene)) != NULL && made;
  struct state state = {.law = laws[which]};
  const bool solved =
      made && walk_path(&state, &contact, matter_pair(scene, particles[0].material, other).ks, scene, columns);
  for (int c = 0; c < COLUMNS; c++)
    if (solved)
      path_add(solution, scene, names[c], columns[c]);
    else
      free(columns[c]);
  if (made && !solved)
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `contact_ladder` is for segments of tangential displacement at one normal force");
  const bool exact = laws[which].branches == BRANCHES;
  if (!laws[which].literal)
    solution_value(solution, exact ? 0 : psi2_error(scene->shear, contact.kappa), "psi2 error");
  return made ? solution_status(solution, error) : nb_error_memory(error);
}

const struct nb_reference reference_contact_ladder = {
    .name = "contact_ladder",
    .title = "shear laws along a path of slip at constant normal force in closed form, and their errors in an impact",
    .source = "[R89 3.25, 3.40, 3.50]",
    .accepts = {HAS_SPHERES, HAS_WALLS, HAS_FRICTION},
    .needs = {HAS_CONTACT_TEST},
    .normal = "hertz",
    .shear = "linear mindlin mindlin_scaled mindlin_deresiewicz randall randall_literal",
    .solve = solve,
};
