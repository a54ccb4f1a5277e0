/* The stability check compares the step with the guaranteed stable step when a stage begins, after each search, and
 * every NB_STABILITY_CYCLES cycles. It also does so when elastic spheres have stiffened so much that the step may have
 * become too long. stable_step.c defines the guaranteed stable step and L.
 *
 * The stiffness of a contact of elastic spheres increases with its overlap. So a check also computes how large each
 * overlap may become before the next check is needed. With
 *
 *   q = dt^2 k_n + 2 dt c_n        for a contact now, kg
 *   h >= (dt k_s + 2 c_s)/(dt k_n + 2 c_n)        for all contacts at all times, 1
 *   S = sum of q over the n listed contacts of a particle, touching or not, kg
 *
 * the step is stable as long as, for all contacts,
 *
 *   S_i/m_i + S_j/m_j  <=  L        and        h (S_i (1/m_i + R_i^2/I_i) + S_j (1/m_j + R_j^2/I_j))  <=  L
 *
 * L minus the larger of the two left sides is the remainder of a contact, where the second left side has the present sums
 * of dt^2 k_s + 2 dt c_s in place of h S with R^2/I. Each of its two particles gets half of the remainder; a particle at
 * a wall or at a fixed particle gets all of it. The smallest of the parts that a particle gets from its contacts is
 * divided equally among these contacts. So q of a contact may increase by
 *
 *   min over its free particles of  (smallest part)/n / max(1/m, h (1/m + R^2/I))
 *
 * and the step remains stable while every contact stays below its limit. NB_STABLE_OVERLAP is the overlap at which q
 * reaches this limit. pass/deep.c compares the overlaps with it. The first contact above its limit triggers a new
 * check, before its force has moved a particle.
 *
 * Without dashpots h is the largest k_s/k_n = 4 G* / E* of all pairs of materials. With dashpots, whose coefficients
 * are proportional to k or to sqrt(M* k) with the reduced mass M*, the quotient that h bounds lies between k_s/k_n,
 * which is at most 1, and sqrt(k_s/k_n). So h is then the largest sqrt(k_s/k_n).
 *
 * Range     normal laws whose stiffness increases with the overlap, except Hertz's law by increments, whose stiffness
 *           follows from the force; and shear laws of elastic spheres, or no shear law: k_s of other shear laws is not
 *           proportional to k_n. Contacts with other laws are checked like linear springs, whose stiffness is constant.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <float.h>
#include <stdlib.h>

#include "core/clean.h"
#include "step.h"

void nb_stable_text(char *text, size_t size, const struct nb_model *model, const struct nb_stable *stable) {
  const int *number = model->particles.number;
  const char *motion = stable->rotational ? "rotation" : "normal motion";
  if (stable->a < 0)
    snprintf(text, size, "no contact");
  else if (stable->material_pair->wall && stable->b < 0)
    snprintf(text, size, "%s of particle %d and a wall of %s", motion, number[stable->a],
             model->scene->materials[stable->material_pair->b].name);
  else if (stable->material_pair->wall)
    snprintf(text, size, "%s of particle %d and wall %s", motion, number[stable->a],
             model->scene->walls[stable->b].name);
  else
    snprintf(text, size, "%s of particles %d and %d", motion, number[stable->a], number[stable->b]);
  if (stable->apart && stable->a >= 0)
    nb_append(text, size, ", as if they touched");
}

/* ---- the overlaps up to which the step stays stable ---- */

bool nb_stability_overlaps(struct nb_model *model) {
  unsigned long above = 0;
  for (size_t v = 0; v < model->blocks.count; v++)
    above += model->blocks.stable_overlap[v].above, model->blocks.stable_overlap[v].above = 0;
  return above == 0;
}

/* h, defined at the top of this file, for all material pairs. */
static double max_stiffness_ratio(const struct nb_model *model) {
  double largest = 0;
  for (size_t p = 0; p < model->material_pair_count; p++) {
    const struct nb_material_pair *material_pair = &model->material_pairs[p];
    const bool has_stiffness = material_pair->next_shear && material_pair->next_shear->elastic;
    const double ratio = has_stiffness ? 4 * material_pair->next.shear / material_pair->next.young : 0;
    largest = ratio > largest ? ratio : largest;
  }
  return model->stability->damped ? sqrt(largest) : largest; /* largest <= 1, because nu >= 0 */
}

/* The k_n at which a contact has the given q, N/m: the solution of dt^2 k + 2 dt (time k + ratio (M* k)^(1/2)) = q, a
 * quadratic equation in k^(1/2). Centred dashpots count twice (stable_step.c). */
static double stiffness_of(const struct nb_model *model, size_t c, double q) {
  const double dt = model->step, factor = (model->damping.centred ? 4 : 2) * dt;
  struct nb_dashpot dashpot = nb_dashpot(model, nb_with_wall(model, c));
  if (model->damping.deep > 0)
    dashpot.ratio = dashpot.ratio > 2 ? dashpot.ratio : 2; /* the contact may become deep */
  const double square = dt * dt + factor * dashpot.time;
  const double line = dashpot.ratio > 0 ? factor * dashpot.ratio * sqrt(1 / nb_inverse_mass(model, c)) : 0;
  const double root = 2 * q / (line + sqrt(line * line + 4 * square * q));
  return q > 0 ? root * root : 0;
}

static double smaller(double a, double b) { return a < b ? a : b; }

/* Sets `slots` to the slots of the free particles of a contact; returns their number, 1 or 2. */
static int free_particles(const struct nb_model *model, size_t c, int slots[2]) {
  const struct nb_contacts *contacts = &model->contacts;
  const double *inverse_mass = model->particles.inverse_mass;
  int n = 0;
  if (inverse_mass[contacts->a[c]] > 0)
    slots[n++] = contacts->a[c];
  if (!nb_with_wall(model, c) && inverse_mass[contacts->b[c]] > 0)
    slots[n++] = contacts->b[c];
  return n;
}

/* Tolerated relative excess of a law's stiffness over the required one, because roots are rounded (1e-16). The stable
 * step varies with the root of the stiffness, so the step exceeds it by at most half of this fraction. */
static const double rounding = 1e-6;

/* Overlap at which the normal law has this stiffness, m. It follows from Hertz's k_n = 2 E* (R* alpha)^(1/2), and is
 * smaller if the law is stiffer. */
static double overlap_with_stiffness(const struct nb_model *model, size_t c, double stiffness) {
  const struct nb_material_pair *material_pair = &model->material_pairs[model->contacts.material_pair[c]];
  const struct nb_pair values = nb_contact_constants(model, c, material_pair->next);
  double overlap = stiffness * stiffness / (4 * values.young * values.young * values.radius), history[NB_HISTORY] = {0};
  while (overlap > 0 && isfinite(overlap) &&
         nb_normal_max_stiffness(material_pair->normal->normal(values, overlap, 0, history)) >
             (1 + rounding) * stiffness)
    overlap /= 2;
  return overlap;
}

/* Sets NB_STABLE_OVERLAP of all contacts, and the smallest one of each block. */
static void set_update_limit(struct nb_model *model) {
  const struct nb_particles *particles = &model->particles;
  const struct nb_contacts *contacts = &model->contacts;
  const double dt = model->step, limit = nb_stability_limit(&model->damping), h = max_stiffness_ratio(model);
  double *stable_overlap = contacts->kept[NB_STABLE_OVERLAP], *remainder = model->stability->remainder;
  int slots[2];
  for (size_t i = 0; i < particles->count; i++)
    remainder[i] = INFINITY;
  for (size_t c = 0; c < contacts->count; c++) {
    const struct nb_element element = nb_element_of(model, c);
    const int n = free_particles(model, c, slots);
    const double normal = nb_element_normal(&element, dt), shear = h * normal + nb_element_rotational(&element, dt);
    const double left = limit - (shear > normal ? shear : normal);
    const bool apart = !(element.own.kn > 0) && !(left > 0); /* a check follows as soon as the pair touches */
    for (int k = 0; k < n && !apart; k++)
      remainder[slots[k]] = smaller(remainder[slots[k]], left > 0 ? left / n : 0);
    /* q; the next loop replaces it by the overlap */
    stable_overlap[c] = apart ? -INFINITY : dt * dt * element.own.kn + 2 * dt * element.own.cn;
  }
  for (size_t v = 0; v < model->blocks.count; v++)
    model->blocks.stable_overlap[v].overlap = INFINITY;
  for (size_t v = 0, c = 0; v < model->blocks.count; v++)
    for (const size_t end = c + model->blocks.list[v].n; c < end; c++) {
      const int n = free_particles(model, c, slots);
      double increase = INFINITY;
      for (int k = 0; k < n; k++) {
        const int i = slots[k];
        const double inverse = particles->inverse_mass[i], radius = particles->radius[i];
        const double shear_factor = h * (inverse + radius * radius * particles->inverse_inertia[i]);
        const double per_contact =
            remainder[i] / (double)(model->contacts.incidence.end[i] - model->contacts.incidence.first[i]);
        increase = smaller(increase, per_contact / (shear_factor > inverse ? shear_factor : inverse));
      }
      stable_overlap[c] = overlap_with_stiffness(model, c, stiffness_of(model, c, stable_overlap[c] + increase));
      model->blocks.stable_overlap[v].overlap = smaller(model->blocks.stable_overlap[v].overlap, stable_overlap[c]);
    }
}

/* Fraction of the stable step that a message proposes. More and stiffer contacts lower the stable step later. With 0.3 the
 * sum of the stiffnesses of a particle's contacts may increase to 1/0.3^2 = 11 times its value: a disc with one contact
 * may get six, the most that discs of one size have, and each may be nearly twice as stiff. */
static const double proposed_fraction = 0.3;

/* Writes a step below the stable one to `text`, in the form in which the page gives its step. */
static void proposed_step(char *text, size_t size, const struct nb_model *model, double stable_step) {
  static const char *const of[] = {[NB_STEP_TIME] = " s",
                                   [NB_STEP_SINGLE_CONTACT] = " of single-contact",
                                   [NB_STEP_STABLE] = " of stable",
                                   [NB_STEP_COLLISION] = " per collision",
                                   [NB_STEP_RAYLEIGH] = " of rayleigh",
                                   [NB_STEP_RAYLEIGH_MEAN] = " of rayleigh-mean",
                                   [NB_STEP_RAYLEIGH_FIT] = " of rayleigh-fit",
                                   [NB_STEP_RAYLEIGH_FIT_MEAN] = " of rayleigh-fit-mean"};
  const struct nb_step *step = model->stage ? &model->stage->step : &model->scene->step;
  const double value = proposed_fraction * step->value * stable_step / model->step;
  if (step->kind == NB_STEP_COLLISION)
    snprintf(text, size, "step %.0f%s", ceil(1 / value), of[step->kind]);
  else
    snprintf(text, size, "step %.2g%s", value, step->kind || !model->scene->unitless ? of[step->kind] : "");
}

/* NB_BROKEN if the step is longer than the stable one. With `step 1 of stable` it may be longer by rounding, which must
 * not count. */
static enum nb_status check_step(const struct nb_model *model, const struct nb_stable *stable, struct nb_error *error) {
  const double ratio = model->step / stable->step;
  model->stability->largest = ratio > model->stability->largest ? ratio : model->stability->largest;
  if (ratio <= 1 + 4 * DBL_EPSILON)
    return NB_OK;
  char cause[3 * NB_NAME_SIZE], proposal[NB_NAME_SIZE];
  const int number = model->particles.number[stable->a];
  const char *s = nb_unit(model->scene, " s");
  nb_stable_text(cause, sizeof cause, model, stable);
  proposed_step(proposal, sizeof proposal, model, stable->step);
  return nb_error_set(
      error, NB_BROKEN,
      "particle %d (line %d): at cycle %lu, time %g%s, the step %g%s is above the guaranteed stable "
      "one, %g%s, which is set by %s: write `%s`, or `allow unstable`; the proposal is %g of the stable step, "
      "because further contacts make it shorter",
      number, model->scene->particles[number - 1].line, model->cycle, model->time, s, model->step, s, stable->step, s,
      cause, proposal, proposed_fraction);
}

enum nb_status nb_stability_check(struct nb_model *model, struct nb_error *error) {
  if (model->stability->allow_unstable || model->contacts.count == 0)
    return NB_OK;
  const struct nb_stable stable = nb_stable_step_begin(model);
  model->stability->checks++;
  const enum nb_status status = check_step(model, &stable, error);
  if (!status && model->blocks.stable_overlap)
    set_update_limit(model);
  nb_stable_step_end(model);
  return status;
}

enum nb_status nb_stability_begin(struct nb_model *model, const struct nb_stable *apart, struct nb_error *error) {
  if (!model->stability->allow_unstable && check_step(model, apart, error))
    return error->status;
  return nb_stability_check(model, error);
}
