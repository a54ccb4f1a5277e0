/* The largest step that is sure to be stable.
 *
 * A free vibration x_n = z^n u of the cycle [CS79 20-36], with the global damping's factors `keep` and `push` of
 * motion.c, obeys
 *
 *   z^2 - (1 + keep) z + keep  +  push dt^2 k z  +  push dt c (z - 1)  =  0,      k = u'K u/u'M u,  c = u'C u/u'M u
 *
 * K the springs, C the dashpots, which lag half a step. No z leaves the unit circle as long as, for every u,
 *
 *   dt^2 k + 2 dt c <= L,      L = 2 (1 + keep)/push = 4 undamped and with [CS79 34-36]
 *
 * and the first to leave it does so at z = -1: velocities that change their sign every cycle. So a dashpot acts as a
 * spring of 2 c/dt more, and CS79's global damping, which is centred, costs nothing.
 *
 * The largest k of a whole network is at most that of its stiffest part when the mass of each body is shared out among
 * its contacts, in any way: Rayleigh's quotient is a mean of those of the parts. Shared in the ratio of the normal
 * springs, the moments of inertia in the ratio of k_s R^2, the parts are single contacts in closed form: with
 *
 *   S = sum k_n,  Q = sum k_s R^2  over the contacts of a body,      A = S_i/m_i + S_j/m_j      (none of a wall)
 *   omega^2 = max over contacts of  A  and  (k_s/k_n) A + Q_i/I_i + Q_j/I_j
 *
 *   dt = (2/omega) (sqrt(1 + xi^2) - xi),   xi = beta omega/2           for dashpots of beta k
 *
 * and for other dashpots the root of the same with k + 2 c/dt in place of k, which one cannot write down.
 *
 * Every pair that is listed counts, touching or not, so that the bound holds until the next search whatever closes or
 * opens; what does not touch counts as if it just did. As a stage begins all pairs that could meet count as well: the lightest
 * particles of any two materials, however far they are apart. Else the step could be too long for the first contact there is. Left out: that contacts turn, of the order of overlap over
 * radius; a contact that slides is softer.
 *
 * To find it costs a few cycles' work, of elastic spheres up to a dozen. When a run does so: stability.c.
 *
 * Source     the element bound of finite elements (Irons and Treharne 1971).
 * Range      k_n > 0; laws whose stiffness changes are taken as stiff as they can get at this overlap, loading or unloading (law.h);
 *            stability.c knows until which overlap.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <float.h>
#include <string.h>

#include "laws/laws_now.h"
#include "step.h"

bool nb_stability_create(struct nb_model *model) {
  struct nb_stability *it = model->stability = nb_own(&model->owner, 1, sizeof *it);
  struct nb_load *loads = nb_own(&model->owner, model->particles.count, sizeof *loads);
  if (model->owner.failed)
    return false;
  *it = (struct nb_stability){.step_line = -1, .loads = loads};
  return true;
}

/* A stage may have changed properties and laws since the last forces. */
static void look_ahead(const struct nb_model *model) {
  const struct nb_law *shear = strcmp(model->next.shear->name, "none") == 0 ? NULL : model->next.shear;
  for (size_t p = 0; p < model->material_pair_count; p++) {
    struct nb_material_pair *material_pair = &model->material_pairs[p];
    material_pair->next = nb_properties_pair(&model->properties, material_pair->a, material_pair->b);
    material_pair->next_shear = material_pair->next.friction > 0 || material_pair->next.cohesion > 0 ? shear : NULL;
  }
}

/* What two laws and the dashpots in force make of an overlap; memory as the contact has it, or none. */
static struct nb_stiff stiff_at(const struct nb_model *model, const struct nb_material_pair *material_pair,
                                double overlap, double inverse_mass, double radius, bool deep, double normal_history[],
                                double shear_history[]) {
  struct nb_pair values = material_pair->next;
  values.radius = radius;
  struct nb_normal normal = model->next.normal->normal(values, overlap, 0, normal_history);
  normal.overlap = overlap;
  struct nb_stiff k = {.kn = nb_normal_stiffest(normal)};
  if (material_pair->next_shear)
    k.ks = material_pair->next_shear->shear(values, normal, 0, shear_history).stiffness;
  if (!model->plan.dashpots)
    return k;
  const struct nb_dashpot pot = deep ? (struct nb_dashpot){.ratio = 2} : nb_dashpot(model, material_pair->wall);
  const double mass = inverse_mass > 0 ? 1 / inverse_mass : 0;
  k.cn = pot.time * k.kn + pot.ratio * sqrt(mass * k.kn);
  k.cs = pot.time * k.ks + pot.ratio * sqrt(mass * k.ks);
  return k;
}

static double inverse_mass(const struct nb_model *model, size_t c, bool wall) {
  const double *inverse = model->particles.inverse_mass;
  return inverse[model->contacts.a[c]] + (wall ? 0 : inverse[model->contacts.b[c]]);
}

/* The smallest overlap there is: what a pair that does not touch counts as. */
static const double just = DBL_MIN;

static struct nb_stiff stiff_of(const struct nb_model *model, size_t c) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_material_pair *material_pair = &model->material_pairs[contacts->material_pair[c]];
  double normal_history[NB_HISTORY], shear_history[NB_HISTORY_MAX];
  for (int shear = 0; shear < 2; shear++) { /* laws write into what they remember, and nothing has happened */
    const struct nb_history *memory = shear ? &contacts->shear_history : &contacts->normal_history;
    double room[NB_HISTORY], *to = shear ? shear_history : normal_history;
    const int doubles = memory->doubles > NB_HISTORY ? memory->doubles : NB_HISTORY;
    const bool forgets = shear ? nb_laws_shear_changes(model) : nb_laws_normal_changes(model);
    if (forgets)
      memset(to, 0, NB_HISTORY * sizeof *to); /* and of a row the first double is all that is looked at */
    else
      memcpy(to, nb_history_read(memory, c, room), (size_t)doubles * sizeof *to);
  }
  const double overlap = nb_overlap(model, c), least = model->next.normal->elastic ? 0 : just;
  return stiff_at(model, material_pair, overlap > least ? overlap : least, inverse_mass(model, c, material_pair->wall),
                  nb_contacts_values(model, c, material_pair->next).radius,
                  model->damping.deep > 0 && nb_deep_is(model, c), normal_history, shear_history);
}

double nb_safe_limit(const struct nb_damping *damping) {
  if (damping->global_kind == NB_GLOBAL_CON1_VELOCITY)
    return 2 * (1 + damping->global);
  if (damping->global_kind == NB_GLOBAL_CON1_ALL)
    return 2 * (1 + damping->global) / damping->global; /* without end when nothing moves */
  return 4;
}

static double shear_of(const struct nb_part *part, double dt) {
  const struct nb_stiff *k = &part->own;
  if (!(k->ks > 0))
    return 0;
  const double ratio = (dt * k->ks + 2 * k->cs) / (dt * k->kn + 2 * k->cn);
  return ratio * nb_part_normal(part, dt) + nb_part_turning(part, dt);
}

static double larger(double a, double b) { return a > b ? a : b; }

/* The largest dt with both below L, and none longer than without dashpots. Both grow with dt. */
static double root(const struct nb_part *part, double limit) {
  const double ratio = part->own.ks / part->own.kn;
  const double square = larger(part->a, part->own.ks > 0 ? ratio * part->a + part->q : 0);
  double low = 0, high = sqrt(limit / square);
  if (!(part->own.cn > 0 || part->d > 0 || part->p > 0) || !isfinite(high))
    return high;
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (!(middle > low && middle < high))
      return low;
    if (larger(nb_part_normal(part, middle), shear_of(part, middle)) <= limit)
      low = middle;
    else
      high = middle;
  }
}

static void add(struct nb_load *load, const struct nb_stiff *k, double radius) {
  const double square = radius * radius;
  load->kn += k->kn, load->cn += k->cn;
  load->ks += k->ks * square, load->cs += k->cs * square;
}

/* A body's contribution to its contact. */
static void fraction(struct nb_part *part, const struct nb_load *load, double inverse_mass_, double inverse_inertia) {
  part->a += load->kn * inverse_mass_, part->d += load->cn * inverse_mass_;
  part->q += load->ks * inverse_inertia, part->p += load->cs * inverse_inertia;
}

static void smaller(struct nb_safe *safe, const struct nb_part *part, double limit, int a, int b,
                    const struct nb_material_pair *material_pair) {
  const double step = safe->step;
  /* Most contacts are not the smallest, which is told without looking for a root. */
  if (isfinite(step) && larger(nb_part_normal(part, step), shear_of(part, step)) <= limit)
    return;
  *safe = (struct nb_safe){.step = root(part, limit), .a = a, .b = b, .material_pair = material_pair};
  safe->turning = shear_of(part, safe->step) > nb_part_normal(part, safe->step);
}

struct nb_safe nb_safe_apart(const struct nb_model *model) {
  const struct nb_particles *particles = &model->particles;
  const double limit = nb_safe_limit(&model->damping);
  struct nb_safe safe = {.step = INFINITY, .a = -1, .b = -1};
  look_ahead(model);
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
        curvature += 1 / particles->surface[lightest[side]].radius;
      }
    if (model->next.normal->elastic)
      continue; /* elastic spheres have no stiffness when they just touch */
    struct nb_part part = {.own = stiff_at(model, material_pair, just, inverse, 1 / curvature, false, normal, shear)};
    for (int side = 0; side < 2; side++) {
      const int i = lightest[side];
      struct nb_load load = {0};
      if (i < 0)
        continue;
      add(&load, &part.own, particles->surface[i].radius);
      fraction(&part, &load, particles->inverse_mass[i], particles->inverse_inertia[i]);
    }
    if (part.own.kn > 0)
      smaller(&safe, &part, limit, lightest[0], lightest[1], material_pair);
  }
  safe.apart = true;
  return safe;
}

struct nb_safe nb_safe_begin(const struct nb_model *model) {
  const struct nb_safe near = nb_safe_step(model), apart = nb_safe_apart(model);
  return apart.step < near.step ? apart : near;
}

struct nb_part nb_part_of(const struct nb_model *model, size_t c) {
  const struct nb_particles *particles = &model->particles;
  const int i = model->contacts.a[c], j = model->contacts.b[c];
  struct nb_part part = {.own = model->blocks.stiff[c]};
  fraction(&part, &model->stability->loads[i], particles->inverse_mass[i], particles->inverse_inertia[i]);
  if (!model->material_pairs[model->contacts.material_pair[c]].wall)
    fraction(&part, &model->stability->loads[j], particles->inverse_mass[j], particles->inverse_inertia[j]);
  return part;
}

struct nb_safe nb_safe_step(const struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_particles *particles = &model->particles;
  const double limit = nb_safe_limit(&model->damping);
  struct nb_safe safe = {.step = INFINITY, .a = -1, .b = -1};
  if (contacts->count == 0)
    return nb_safe_apart(model);
  look_ahead(model);
  memset(model->stability->loads, 0, particles->count * sizeof *model->stability->loads);
  for (size_t c = 0; c < contacts->count; c++) { /* in the order of numbers, whatever the storage */
    const int i = contacts->a[c], j = contacts->b[c];
    const struct nb_stiff k = model->blocks.stiff[c] = stiff_of(model, c);
    add(&model->stability->loads[i], &k, particles->surface[i].radius);
    if (!model->material_pairs[contacts->material_pair[c]].wall)
      add(&model->stability->loads[j], &k, particles->surface[j].radius);
  }
  for (size_t c = 0; c < contacts->count; c++) {
    const struct nb_part part = nb_part_of(model, c);
    if (part.own.kn > 0)
      smaller(&safe, &part, limit, contacts->a[c], contacts->b[c], &model->material_pairs[contacts->material_pair[c]]);
  }
  return safe;
}
