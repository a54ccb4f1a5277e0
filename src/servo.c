/* The servo: strain rates that bring a measured stress to where it should be.   [R89 4.1, 6.4.2]
 *
 *   L_ij = (s_ij - s0_ij)/(2 B T)            added to the rates that the stage asks for, of the components that are servoed
 *
 *   s, s0  stress, measured and wanted, compression positive, Pa
 *   B      stiffness against a change of area of an assembly all of whose bodies follow the strain, Pa
 *          dp = -B tr(L) dt,   B = sum k_n l^2/(4 A h): over contacts, k_n their normal stiffness, l the way from centre to centre
 *   T      2 R (rho/B)^(1/2), R the boundary's mean radius; of a cell A^(1/2) in the place of 2 R: a wave of pressure goes across
 *          the assembly in it, s
 *
 * So what is off goes as exp(-t/T) while B is right. Bodies that may give way are softer than B, then it goes slower, never faster: no
 * gain is too large. T is the shortest time in which the middle can have answered. As B falls to 0 with the load the
 * rates would go beyond all bounds: none of them is larger than `at most`, all are reduced alike. A steady disturbance e_v per second of
 * the volume leaves a stress that is off by B T e_v.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "servo.h"
#include "region.h"

/* B, Pa, and M/(A h), kg/m3: of all that is there. */
static double stiffness(const struct nb_model *model, double volume) {
  const struct nb_contacts *contacts = &model->contacts;
  double sum = 0;
  for (size_t c = 0; c < contacts->count; c++) {
    if (model->pairings[contacts->pairing[c]].wall || !(contacts->kept[NB_OVERLAP][c] > 0))
      continue;
    const struct nb_vec l = nb_contacts_branch(model, c);
    sum += contacts->kept[NB_STIFFNESS][c] * vec_dot(l, l);
  }
  return sum / (4 * volume);
}

static double density(const struct nb_model *model, double volume) {
  double sum = 0;
  for (size_t k = 0; k < model->bodies.count; k++)
    if (!nb_gone(model, (size_t)model->bodies.slot[k]))
      sum += model->bodies.mass[model->bodies.slot[k]];
  return sum / volume;
}

static double limited(double most, double value) { return fabs(value) > most ? fabs(value) : most; }

/* What is to be added to the strain rates now, 1/s. */
static struct nb_tensor correction(const struct nb_model *model, const struct nb_servo *servo, double share) {
  const double area = servo->cell ? nb_cell_area(model->cell) : nb_ring_area(model);
  const double width = servo->cell ? sqrt(area) : 2 * nb_ring_radius(model), volume = area * nb_thickness(model);
  const double most = servo->per_cycle ? servo->most / model->step : servo->most;
  const double b = stiffness(model, volume), t = width * sqrt(density(model, volume) / b);
  struct nb_tensor off = {0};
  double seen[3];
  for (int k = 0; k < 3; k++)
    seen[k] = servo->quantity[k].kind ? nb_quantity_value(servo->quantity[k], model) : 0;
  const double *from = model->carry->servo_from;
  const double want[3] = {from[0] + share * (servo->stress[0] - from[0]),
                          from[1] + share * (servo->stress[1] - from[1]),
                          from[2] + share * (servo->stress[2] - from[2])};
  if (servo->mean)
    off.xx = off.yy = (seen[0] + seen[1] - want[0] - want[1]) / 2;
  else
    off = tensor(servo->held[0] ? seen[0] - want[0] : 0, servo->held[2] ? seen[2] - want[2] : 0,
                 servo->held[2] ? seen[2] - want[2] : 0, servo->held[1] ? seen[1] - want[1] : 0);
  const double largest = limited(limited(fabs(off.xx), off.yy), off.xy);
  /* b may be 0, and then t has no end: what is left is the direction */
  const double rate = b > 0 ? 1 / (2 * b * t) : INFINITY;
  return largest > 0 ? tensor_scale(rate * largest <= most ? rate : most / largest, off) : off;
}

void nb_servo_begin(struct nb_model *model) {
  const struct nb_servo *servo = &model->stage->servo;
  for (int k = 0; k < 3; k++)
    model->carry->servo_from[k] = servo->ramp ? nb_quantity_value(servo->quantity[k], model) : servo->stress[k];
}

void nb_servo_set(struct nb_model *model) {
  struct nb_carry *carry = model->carry;
  const struct nb_servo *servo = &model->stage->servo;
  if (model->stage_cycle % servo->every != 0 || !(servo->cell || model->drive->ring.held))
    return;
  const double share = servo->ramp ? (double)(model->stage_cycle + 1) / (double)model->stage->cycles : 1;
  const struct nb_tensor more = correction(model, servo, share);
  const bool moved[NB_CARRIERS] = {
      [NB_CARRIER_CONTINUUM] = servo->continuum, [NB_CARRIER_BOUNDARY] = !servo->cell, [NB_CARRIER_CELL] = servo->cell};
  for (int c = 0; c < NB_CARRIERS; c++)
    carry->rate[c] = moved[c] ? tensor_add(carry->level[c], more) : carry->level[c];
}
