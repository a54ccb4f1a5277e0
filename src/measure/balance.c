/* The two balances of a run: what has been done since the start, each term from its own definition.
 *
 * work      K_(N-1/2) - K_0 = sum over kicks of all forces' work. A kick changes a body's velocity from v- to v+ by
 *           the impulse J = F tau and what global damping takes, so its kinetic energy by J.(v- + v+)/2: force times
 *           the way at the mean of the half-step velocities. That holds for any step, the half first kick too
 *           (tau = dt/2, v- = v_0); the residual is rounding.
 *
 * energy    K + U - (K + U)_0 + frictional + damped + removed - walls - gravity - driven - changed, all at t_N. U is a state function
 *           (energy.c). Forces that depend on velocity or are given act at t_N, at the velocity of t_N, over the kick
 *           around it; what slides does so over the step from t_N to t_(N+1), at the mean of the two forces:
 *
 *             damped      D_n dn + D_s ds  of dashpots, C v.v tau of global damping, over kicks      [CS79 26-36]
 *             walls       F.V tau  of walls, and of fixed bodies that move, over kicks
 *             gravity     m g.(v + c) tau  over kicks
 *             driven      what carries bodies along (balance_carry.c), and stress on a boundary times v tau, over kicks
 *             frictional  F_s (ds - dF_s/k_s)  of contacts that slide, or part with their spring bent, over steps
 *                         what a law says that knows micro-slip
 *             sliding     the part of that in which a contact slides as a whole
 *             shear       F_s ds  over steps
 *
 *           The residual is the error of the integration. A kick reaches half a step beyond t_N: a term that is
 *           asked for at t_N has only the half behind it in it (tail).
 *
 * A shear law without stored energy has its shear work in the residual where the others have U_s and frictional.
 * Sums run over bodies in the order of numbers and over contacts in theirs, by one thread, and carry what rounding
 * cuts off (Neumaier 1974): the same bits on any number of threads.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "balance.h"

/* ---- set up ---- */

/* The first law of the scene that stores no energy; NULL: all do. */
static const struct nb_law *not_stored(const struct nb_model *model, bool normal) {
  for (size_t p = 0; p < model->pairing_count; p++) {
    const struct nb_law *law = normal ? model->pairings[p].normal : model->pairings[p].shear;
    if (law && !law->stored)
      return law;
  }
  return NULL;
}

enum nb_status nb_balance_create(struct nb_model *model, struct nb_error *error) {
  const unsigned asked = model->plan.asked;
  const struct nb_law *normal = not_stored(model, true), *shear = not_stored(model, false);
  normal = normal ? normal : nb_laws_unstored(model->scene, true);
  shear = shear ? shear : nb_laws_unstored(model->scene, false);
  if (asked & NB_ASKS_STORED && (normal || shear))
    return nb_error_set(error, NB_BAD_USE,
                        "`%s %s` has no stored energy: record `energy.shear`, not `energy.stored` and "
                        "`energy.frictional`",
                        normal ? "normal" : "shear", normal ? normal->name : shear->name);
  if (asked & NB_ASKS_ENERGY && normal)
    return nb_error_set(error, NB_BAD_USE, "`normal %s` has no stored energy, so energies do not balance",
                        normal->name);
  if (!(asked & (NB_ASKS_WORK | NB_ASKS_ENERGY)))
    return NB_OK;
  const size_t bodies = model->bodies.count, walls = model->walls.count, pairings = model->pairing_count;
  struct nb_balance *b = model->balance = calloc(1, sizeof *b);
  if (b) {
    b->works = asked & NB_ASKS_WORK, b->energies = asked & NB_ASKS_ENERGY;
    b->before = nb_array(bodies, sizeof *b->before), b->now = nb_array(bodies, sizeof *b->now);
    b->position = nb_array(bodies, sizeof *b->position), b->pivot = nb_array(walls, sizeof *b->pivot);
    b->wall_velocity = nb_array(walls, sizeof *b->wall_velocity), b->wall_spin = nb_array(walls, sizeof(double));
    b->values = nb_array(pairings, sizeof *b->values);
  }
  if (!b || !nb_balance_carry_create(b, model) || !b->before || !b->now || !b->position || !b->pivot ||
      !b->wall_velocity || !b->wall_spin || !b->values)
    return nb_error_memory(error);
  b->kinetic = nb_energy_kinetic_half(model);
  if (b->energies)
    b->level = nb_energy_kinetic(model) + nb_energy_stored(model);
  memcpy(b->wall_velocity, model->walls.velocity, walls * sizeof *b->wall_velocity);
  memcpy(b->wall_spin, model->walls.spin, walls * sizeof *b->wall_spin);
  if (b->energies) /* a state's last step is none of this run's */
    nb_balance_since(model);
  return NB_OK;
}

void nb_balance_free(struct nb_balance *b) {
  if (!b)
    return;
  free(b->before), free(b->now), free(b->position), free(b->pivot), free(b->wall_velocity), free(b->wall_spin);
  free(b->values), free(b->entered), free(b->along), free(b);
}

/* ---- a kick: what bodies and contacts feel at t_N, over the time around it ---- */

/* Part of a kick: `behind` seconds before t_N and `ahead` seconds after it. Positions and velocities as they were. */
struct kick {
  const struct nb_vec *position, *pivot;
  const struct nb_state *now;
  double behind, ahead;
};

static struct nb_vec wall_way(const struct nb_model *model, const struct kick *kick, int w, struct nb_vec q) {
  const struct nb_balance *b = model->balance;
  const struct nb_vec arm = vec_sub(q, kick->pivot[w]), turned = vec(-arm.y, arm.x);
  const struct nb_vec was = vec_add(b->wall_velocity[w], vec_scale(b->wall_spin[w], turned));
  const struct nb_vec is = vec_add(model->walls.velocity[w], vec_scale(model->walls.spin[w], turned));
  return vec_add(vec_scale(kick->behind, was), vec_scale(kick->ahead, is));
}

/* Dashpots and walls. */
static void contacts_do(struct nb_sum terms[], const struct nb_model *model, const struct kick *kick) {
  const struct nb_contacts *contacts = &model->contacts;
  const double time = kick->behind + kick->ahead;
  for (size_t c = 0; c < contacts->count; c++) {
    const struct nb_pairing *pairing = &model->pairings[contacts->pairing[c]];
    if ((!model->plan.dashpots && !pairing->wall) || !(contacts->kept[NB_OVERLAP][c] > 0))
      continue;
    const int i = contacts->a[c], j = contacts->b[c];
    const struct nb_vec e = vec(contacts->kept[NB_EX][c], contacts->kept[NB_EY][c]);
    const double radius = model->bodies.rim[i].x;
    struct nb_vec way = vec_add(vec_scale(time, kick->now[i].velocity), nb_balance_carried(model, (size_t)i));
    double rolled = time * kick->now[i].spin * radius;
    if (pairing->wall) {
      const double reach = radius - contacts->kept[NB_OVERLAP][c];
      const struct nb_vec wall = wall_way(model, kick, j, vec_add(kick->position[i], vec_scale(reach, e)));
      nb_sum_add(&terms[NB_TERM_WALLS], vec_dot(contacts->force[c], wall));
      way = vec_sub(way, wall);
    } else {
      const struct nb_vec carried = vec_add(nb_balance_carried(model, (size_t)j), nb_balance_parted(model, c));
      way = vec_sub(way, vec_add(vec_scale(time, kick->now[j].velocity), carried));
      rolled += time * kick->now[j].spin * model->bodies.rim[j].x;
    }
    if (!model->plan.dashpots)
      continue;
    nb_sum_add(&terms[NB_TERM_DAMPED], (contacts->kept[NB_PUSH][c] - contacts->kept[NB_NORMAL][c]) * vec_dot(way, e));
    if (pairing->shear)
      nb_sum_add(&terms[NB_TERM_DAMPED], (contacts->kept[NB_DRAG][c] - contacts->kept[NB_SHEAR][c]) *
                                             (vec_dot(way, vec_clockwise(e)) - rolled));
  }
}

void nb_balance_before(struct nb_model *model) {
  struct nb_balance *b = model->balance;
  for (size_t i = 0; i < model->bodies.count; i++) {
    b->before[i] = nb_velocity_half(model, i), b->position[i] = model->bodies.position[i];
    if (b->energies)
      b->now[i] = nb_velocity_now(model, i);
  }
  memcpy(b->pivot, model->walls.pivot, model->walls.count * sizeof *b->pivot);
  nb_balance_carry(model, model->previous_step / 2, model->step / 2);
}

void nb_balance_kick(struct nb_model *model) {
  struct nb_balance *b = model->balance;
  const struct kick kick = {b->position, b->pivot, b->now, model->previous_step / 2, model->step / 2};
  nb_balance_work(&b->work, model, kick.behind + kick.ahead);
  if (!b->energies)
    return;
  nb_balance_bodies(b->terms, model, kick.behind + kick.ahead, 1);
  nb_balance_carrying(b->terms, model);
  contacts_do(b->terms, model, &kick);
  memcpy(b->wall_velocity, model->walls.velocity, model->walls.count * sizeof *b->wall_velocity);
  memcpy(b->wall_spin, model->walls.spin, model->walls.count * sizeof *b->wall_spin);
}

/* The half of the kick around t_N that lies behind it, as it will be when nothing else happens. */
void nb_balance_tail(struct nb_sum terms[], const struct nb_model *model) {
  struct nb_balance *b = model->balance;
  const struct kick kick = {model->bodies.position, model->walls.pivot, b->now, model->previous_step / 2, 0};
  if (!(kick.behind > 0))
    return;
  nb_balance_carry(model, kick.behind, 0);
  for (size_t i = 0; i < model->bodies.count; i++)
    b->before[i] = nb_velocity_half(model, i), b->now[i] = nb_velocity_now(model, i);
  memcpy(b->position, model->bodies.position, model->bodies.count * sizeof *b->position);
  nb_balance_bodies(terms, model, model->previous_step, 0.5);
  nb_balance_carrying(terms, model);
  contacts_do(terms, model, &kick);
}

/* ---- what is read ---- */

double nb_balance_term(const struct nb_model *model, enum nb_term term) {
  const struct nb_balance *b = model->balance;
  struct nb_sum now[NB_TERMS];
  memcpy(now, b->terms, sizeof now);
  nb_balance_tail(now, model);
  return now[term].sum + now[term].rest;
}

double nb_balance_work_residual(const struct nb_model *model) {
  struct nb_sum sum = model->balance->work;
  nb_sum_add(&sum, model->balance->kinetic);
  nb_sum_add(&sum, -nb_energy_kinetic_half(model));
  return -(sum.sum + sum.rest);
}

double nb_balance_energy_residual(const struct nb_model *model) {
  static const double sign[NB_TERMS] = {
      [NB_TERM_DAMPED] = 1,   [NB_TERM_WALLS] = -1,   [NB_TERM_GRAVITY] = -1, [NB_TERM_FRICTIONAL] = 1,
      [NB_TERM_UNSTORED] = 1, [NB_TERM_CHANGED] = -1, [NB_TERM_REMOVED] = 1,  [NB_TERM_DRIVEN] = -1};
  struct nb_sum now[NB_TERMS], sum = {0};
  memcpy(now, model->balance->terms, sizeof now);
  nb_balance_tail(now, model);
  nb_sum_add(&sum, nb_energy_kinetic(model));
  nb_sum_add(&sum, nb_energy_stored(model));
  nb_sum_add(&sum, -model->balance->level);
  for (int t = 0; t < NB_TERMS; t++)
    nb_sum_add(&sum, sign[t] * now[t].sum), nb_sum_add(&sum, sign[t] * now[t].rest);
  return sum.sum + sum.rest;
}
