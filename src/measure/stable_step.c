/* The guaranteed stable step.
 *
 * A free vibration x_n = z^n u of the cycle [CS79 20-36], with the factors `keep` and `impulse` of mass-proportional
 * damping (motion.c), obeys
 *
 *   z^2 - (1 + keep) z + keep  +  impulse dt^2 k z  +  impulse dt c (z - 1)  = 0,   k = u'K u/u'M u,  c = u'C u/u'M u
 *
 * z is the growth factor per cycle, 1, and u the mode of the vibration. M, K and C are the matrices of the masses, of
 * the springs and of the dashpots, whose forces lag by half a step; u' is u transposed. No z leaves the unit circle as
 * long as, for all u,
 *
 *   dt^2 k + 2 dt c <= L,      L = 2 (1 + keep)/impulse
 *
 * If the left side exceeds L, a z leaves the unit circle at z = -1: a motion that changes its sign in every cycle. So a
 * dashpot acts like an additional spring 2 c/dt. L is 4 without mass-proportional damping. It is also 4 with the
 * mass-proportional damping of [CS79 34-36], which is centred in time.
 *
 * Centred dashpots (pass/dashpots.c) use the velocity 3/2 v_(N+1/2) - 1/2 v_(N-1/2). With C = impulse dt c and K =
 * impulse dt^2 k the equation becomes
 *
 *   z^3 - (1 + keep - K - 3/2 C) z^2 + (keep - 2 C) z + C/2 = 0
 *
 * At z = -1 centred dashpots count twice: dt^2 k + 4 dt c <= L. Below this limit no z leaves the unit circle (Jury's
 * criterion).
 *
 * The mass of each particle may be distributed over its contacts in any way. Each contact with its part of the masses
 * is then a system of its own. The largest k of the scene is at most the largest k of these systems, because Rayleigh's
 * quotient of the scene is a weighted mean of the quotients of the systems. The masses are distributed in proportion to
 * k_n, and the moments of inertia in proportion to k_s R^2. Then k of a single contact has a closed form. With
 *
 *   S = sum k_n,  Q = sum k_s R^2  over the contacts of a particle
 *   A = S_i/m_i + S_j/m_j,  with zero terms for a wall or a fixed particle
 *   omega^2 = max over contacts of  A  and  (k_s/k_n) A + Q_i/I_i + Q_j/I_j
 *
 *   dt = (2/omega) (sqrt(1 + xi^2) - xi),   xi = beta omega/2           for dashpots of beta k
 *
 * For other dashpots dt is the largest step with dt^2 k + 2 dt c <= L in all contacts, which has no closed form.
 *
 * All listed pairs count, touching or not. So with constant stiffnesses the bound holds until the next search, whichever
 * contacts open or close. Pairs that do not touch count as if they were just touching. When a stage begins, pairs that
 * could collide later count as well: the lightest two particles of each pair of materials, however far apart. Otherwise
 * the step could be too long for the first contact that forms. The bound neglects two effects: the rotation of contacts,
 * which is of the order of overlap over radius, and the smaller stiffness of sliding contacts.
 *
 * The computation of the bound costs as much as some ten cycles (docs/COST.md).
 * stability.c decides when to compute it.
 *
 * Source     the element bound of finite elements (Irons and Treharne 1971).
 * Range      k_n > 0. A law with variable stiffness counts with the largest stiffness at the current overlap, on
 *            loading or unloading (law.h); stability.c finds the overlap up to which the step then stays stable.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "laws/laws_now.h"
#include "step.h"

bool nb_stability_create(struct nb_model *model) {
  struct nb_stability *it = model->stability = nb_own(&model->owner, 1, sizeof *it);
  struct nb_particle_sums *sums = nb_own(&model->owner, model->particles.count, sizeof *sums);
  const bool stiffens = nb_laws_initial(model->scene).normal && nb_laws_elastic(model->scene);
  double *remainder = stiffens ? nb_own(&model->owner, model->particles.count, sizeof *remainder) : NULL;
  if (model->owner.failed)
    return false;
  *it = (struct nb_stability){.step_line = -1, .sums = sums, .remainder = remainder};
  return true;
}

/* Computes the parameters of all material pairs for the next force calculation: a stage may have changed properties and
 * laws since the last one. */
static void update_next_properties(const struct nb_model *model) {
  model->stability->damped = nb_damping_contact_line(&model->damping) > 0;
  for (int wall = 0; wall < 2; wall++)
    model->stability->dashpots[wall] = nb_dashpot(model, wall);
  const struct nb_law *shear = strcmp(model->next_laws.shear->name, "none") == 0 ? NULL : model->next_laws.shear;
  for (size_t p = 0; p < model->material_pair_count; p++) {
    struct nb_material_pair *material_pair = &model->material_pairs[p];
    material_pair->next = nb_properties_pair(&model->properties, material_pair->a, material_pair->b);
    material_pair->next_shear = nb_has_friction(material_pair->next) ? shear : NULL;
  }
}

/* Stiffnesses and damping coefficients at an overlap, with these histories, which the laws change. `radius`: R*. */
static struct nb_coefficients coefficients_at(const struct nb_model *model,
                                              const struct nb_material_pair *material_pair, double overlap,
                                              double inverse_mass, double radius, bool deep, double normal_history[],
                                              double shear_history[]) {
  struct nb_pair values = material_pair->next;
  values.radius = radius;
  struct nb_normal normal = model->next_laws.normal->normal(values, overlap, 0, normal_history);
  normal.overlap = overlap;
  struct nb_coefficients k = {.kn = nb_normal_max_stiffness(normal)};
  if (material_pair->next_shear)
    k.ks = material_pair->next_shear->shear(values, normal, 0, shear_history).stiffness;
  if (!model->stability->damped)
    return k;
  static const struct nb_dashpot critical = {.ratio = 2}; /* c = 2 (m k)^(1/2) */
  const struct nb_dashpot dashpot = deep ? critical : model->stability->dashpots[material_pair->wall];
  const double mass = inverse_mass > 0 ? 1 / inverse_mass : 0;
  const double times = model->damping.centred ? 2 : 1; /* centred dashpots count twice */
  k.cn = times * (dashpot.time * k.kn + dashpot.ratio * sqrt(mass * k.kn));
  k.cs = times * (dashpot.time * k.ks + dashpot.ratio * sqrt(mass * k.ks));
  return k;
}

double nb_inverse_mass(const struct nb_model *model, size_t c) {
  const double *inverse = model->particles.inverse_mass;
  const bool wall = nb_with_wall(model, c);
  return inverse[model->contacts.a[c]] + (wall ? 0 : inverse[model->contacts.b[c]]);
}

/* The smallest normal number, as an overlap in metres. A pair that does not touch counts with this overlap, unless its
 * law is for elastic spheres: these count with the overlap 0. */
static const double smallest_overlap = DBL_MIN;

/* Copies the history of a contact, because laws write into it. If the law changes, the copy is empty: its first double
 * is 0. */
static void copy_history(double to[NB_HISTORY_MAX], const struct nb_history *history, size_t c, bool changes) {
  for (int m = 0; m < NB_HISTORY; m++)
    to[m] = !changes && history->field[m] ? history->field[m][c] : 0;
  if (!changes && history->rows)
    memcpy(to, history->rows + c * (size_t)history->doubles, (size_t)history->doubles * sizeof *to);
}

static struct nb_coefficients coefficients_of(const struct nb_model *model, size_t c) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_material_pair *material_pair = &model->material_pairs[contacts->material_pair[c]];
  double normal[NB_HISTORY_MAX], shear[NB_HISTORY_MAX];
  copy_history(normal, &contacts->normal_history, c, nb_laws_normal_changes(model));
  copy_history(shear, &contacts->shear_history, c, nb_laws_shear_changes(model));
  const double overlap = nb_overlap(model, c), least = model->next_laws.normal->elastic ? 0 : smallest_overlap;
  return coefficients_at(model, material_pair, overlap > least ? overlap : least, nb_inverse_mass(model, c),
                         nb_contact_constants(model, c, material_pair->next).radius,
                         model->damping.deep > 0 && nb_is_deep(model, c), normal, shear);
}

double nb_stability_limit(const struct nb_damping *damping) {
  if (damping->global_kind == NB_GLOBAL_CON1_VELOCITY)
    return 2 * (1 + damping->global);
  if (damping->global_kind == NB_GLOBAL_CON1_ALL)
    return 2 * (1 + damping->global) / damping->global; /* infinite if CON1 = 0: nothing moves */
  return 4;
}

/* The part of dt^2 k + 2 dt c that shear and rotation cause; 0 without a shear stiffness. */
static double element_shear(const struct nb_element *element, double dt) {
  const struct nb_coefficients *k = &element->own;
  if (!(k->ks > 0))
    return 0;
  const double ratio = (dt * k->ks + 2 * k->cs) / (dt * k->kn + 2 * k->cn);
  return ratio * nb_element_normal(element, dt) + nb_element_rotational(element, dt);
}

static double larger(double a, double b) { return a > b ? a : b; }

/* The largest dt at which neither the normal nor the shear term exceeds L, s. Both terms increase with dt. Dashpots
 * reduce the result. */
static double largest_step(const struct nb_element *element, double limit) {
  const double ratio = element->own.ks / element->own.kn;
  const double square = larger(element->a, element->own.ks > 0 ? ratio * element->a + element->q : 0);
  double low = 0, high = sqrt(limit / square);
  if (!(element->d > 0)) /* then no contact of the two particles has a dashpot, and p is 0 too */
    return high;
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (!(middle > low && middle < high))
      return low;
    if (larger(nb_element_normal(element, middle), element_shear(element, middle)) <= limit)
      low = middle;
    else
      high = middle;
  }
}

/* Adds a contact to the sums of one of its particles. `radius`: radius of this particle, m. */
static void add(struct nb_particle_sums *load, const struct nb_coefficients *k, double radius) {
  const double square = radius * radius;
  load->kn += k->kn, load->cn += k->cn;
  load->ks += k->ks * square, load->cs += k->cs * square;
}

/* Adds the terms of one particle of the contact to the element. */
static void add_particle(struct nb_element *element, const struct nb_particle_sums *load, double inverse_mass_,
                         double inverse_inertia) {
  element->a += load->kn * inverse_mass_, element->d += load->cn * inverse_mass_;
  element->q += load->ks * inverse_inertia, element->p += load->cs * inverse_inertia;
}

/* Replaces *stable by the stable step of this contact, if that is smaller. `limit`: L; `a`, `b`: as in struct
 * nb_stable. */
static void keep_smaller(struct nb_stable *stable, const struct nb_element *element, double limit, int a, int b,
                         const struct nb_material_pair *material_pair) {
  const double step = stable->step;
  /* Most contacts do not limit the step; this test shows it without solving for a root. */
  if (isfinite(step) && larger(nb_element_normal(element, step), element_shear(element, step)) <= limit)
    return;
  *stable = (struct nb_stable){.step = largest_step(element, limit), .a = a, .b = b, .material_pair = material_pair};
  stable->rotational = element_shear(element, stable->step) > nb_element_normal(element, stable->step);
}

struct nb_stable nb_stable_step_apart(const struct nb_model *model) {
  const struct nb_particles *particles = &model->particles;
  const double limit = nb_stability_limit(&model->damping);
  struct nb_stable stable = {.step = INFINITY, .a = -1, .b = -1};
  update_next_properties(model);
  for (size_t p = 0; p < model->material_pair_count; p++) {
    const struct nb_material_pair *material_pair = &model->material_pairs[p];
    int lightest[2];
    nb_step_lightest(model, material_pair, lightest);
    if (lightest[0] < 0 || (!material_pair->wall && lightest[1] < 0))
      continue;
    double normal[NB_HISTORY] = {0}, shear[NB_HISTORY_MAX] = {0}, inverse = 0, curvature = 0;
    for (int side = 0; side < 2; side++)
      if (lightest[side] >= 0) {
        inverse += particles->inverse_mass[lightest[side]];
        curvature += 1 / particles->radius[lightest[side]];
      }
    if (model->next_laws.normal->elastic)
      continue; /* elastic spheres have no stiffness when they just touch */
    struct nb_element element = {
        .own = coefficients_at(model, material_pair, smallest_overlap, inverse, 1 / curvature, false, normal, shear)};
    for (int side = 0; side < 2; side++) {
      const int i = lightest[side];
      struct nb_particle_sums load = {0};
      if (i < 0)
        continue;
      add(&load, &element.own, particles->radius[i]);
      add_particle(&element, &load, particles->inverse_mass[i], particles->inverse_inertia[i]);
    }
    if (element.own.kn > 0)
      keep_smaller(&stable, &element, limit, lightest[0], lightest[1], material_pair);
  }
  stable.apart = true;
  return stable;
}

struct nb_stable nb_stable_step_stage(const struct nb_model *model) {
  const struct nb_stable listed = nb_stable_step(model), apart = nb_stable_step_apart(model);
  return apart.step < listed.step ? apart : listed;
}

struct nb_element nb_element_of(const struct nb_model *model, size_t c) {
  const struct nb_particles *particles = &model->particles;
  const int i = model->contacts.a[c], j = model->contacts.b[c];
  const struct nb_coefficients *kept = model->stability->coefficients;
  struct nb_element element = {.own = kept ? kept[c] : coefficients_of(model, c)};
  add_particle(&element, &model->stability->sums[i], particles->inverse_mass[i], particles->inverse_inertia[i]);
  if (!nb_with_wall(model, c))
    add_particle(&element, &model->stability->sums[j], particles->inverse_mass[j], particles->inverse_inertia[j]);
  return element;
}

/* The coefficients of elastic spheres are kept during the check, unless memory ran out. So are those of linear springs if
 * there are few contacts. With more contacts they are computed twice, because they would need a fifth of the memory. */
enum { MOST_KEPT = 300000 };
static void keep_coefficients(const struct nb_model *model) {
  struct nb_stability *stability = model->stability;
  nb_stable_step_end(model);
  const size_t n = model->contacts.count;
  if (n <= MOST_KEPT || model->next_laws.normal->elastic || model->next_laws.shear->elastic)
    stability->coefficients = nb_array(n, sizeof *stability->coefficients);
}

void nb_stable_step_end(const struct nb_model *model) {
  free(model->stability->coefficients);
  model->stability->coefficients = NULL;
}

struct nb_stable nb_stable_step_begin(const struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_particles *particles = &model->particles;
  const double limit = nb_stability_limit(&model->damping);
  struct nb_stable stable = {.step = INFINITY, .a = -1, .b = -1};
  if (contacts->count == 0)
    return nb_stable_step_apart(model);
  update_next_properties(model);
  keep_coefficients(model);
  memset(model->stability->sums, 0, particles->count * sizeof *model->stability->sums);
  for (size_t c = 0; c < contacts->count; c++) { /* in the order of particle numbers, whatever the storage order */
    const int i = contacts->a[c], j = contacts->b[c];
    const struct nb_coefficients k = coefficients_of(model, c);
    if (model->stability->coefficients)
      model->stability->coefficients[c] = k;
    add(&model->stability->sums[i], &k, particles->radius[i]);
    if (!nb_with_wall(model, c))
      add(&model->stability->sums[j], &k, particles->radius[j]);
  }
  for (size_t c = 0; c < contacts->count; c++) {
    const struct nb_element element = nb_element_of(model, c);
    if (element.own.kn > 0)
      keep_smaller(&stable, &element, limit, contacts->a[c], contacts->b[c],
                   &model->material_pairs[contacts->material_pair[c]]);
  }
  return stable;
}

struct nb_stable nb_stable_step(const struct nb_model *model) {
  const struct nb_stable stable = nb_stable_step_begin(model);
  nb_stable_step_end(model);
  return stable;
}
