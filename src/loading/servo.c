/* The servo: feedback control of the strain rate until a measured stress has its target value.   [R89 sec. 4.1, sec. 6.4.2]
 *
 *   L_ij = P_ij + Z_ij                       added to the strain rate of the stage, in the controlled components
 *   P_ij = (s_ij - s0_ij)/(2 B T),           dZ_ij/dt = P_ij/(16 T)
 *
 *   s, s0  measured and target stress, compression positive, Pa
 *   L      added strain rate, 1/s; P and Z  its proportional and its integral part, 1/s
 *   B      stiffness against a change of area if all particles follow the strain, Pa: the mean stress p changes by
 *          dp = -B tr(L) dt. B = sum k_n l^2/(4 A h) over the contacts that touch; k_n normal stiffness, N/m; l
 *          distance of the centres, for a box also from a centre to a wall, m; A area of boundary, cell or box, m2; h
 *          thickness, m
 *   T      time in which a pressure wave crosses the assembly, s: 2 R (rho/B)^(1/2); R mean radius of the boundary, m;
 *          rho mass of all particles over A h, kg/m3; for a cell or a box A^(1/2) replaces 2 R
 *
 * If the particles do not follow the strain exactly, the assembly is softer: its stiffness is f B with 0 < f <= 1, and
 * the error e of the stress obeys
 *
 *   e'' + f e'/T + f e/(16 T^2) = 0          with decay rates r = f (1 -+ (1 - 1/(4f))^(1/2))/(2T)
 *
 * This is stable for each f and does not oscillate for f >= 1/4. In the time T a wave reaches the middle and returns to
 * the boundary. P alone would leave the error B T e_v at a steady dilatation rate e_v, 1/s; Z removes this error. Z
 * begins at -a P with a = (1 - (3/4)^(1/2))/2, which selects the faster decay for f = 1, exp(-0.93 t/T), so that Z does
 * not overshoot.
 *
 * Controlled components and the bound `at most` refer to the servo's own axes, which `transform` rotates and mirrors
 * with the scene.
 *
 * When the assembly is unloaded, B decreases to 0, and P would grow without bound. So no component of the added strain
 * rate exceeds `at most`: all components are scaled by one factor, and Z is set to -a P again.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "core/clean.h"
#include "core/names.h"
#include "loading.h"
#include "measure/boundary.h"
#include "measure/region.h"

/* B, Pa. `volume`: A h, m3. */
static double stiffness(const struct nb_model *model, const struct nb_servo *servo, double volume) {
  const struct nb_contacts *contacts = &model->contacts;
  double sum = 0;
  for (size_t c = 0; c < contacts->count; c++) {
    const bool wall = nb_with_wall(model, c);
    if (wall && !servo->box)
      continue;
    const struct nb_vec l =
        wall ? nb_wall_separation(&model->walls, contacts->b[c], model->particles.position[contacts->a[c]])
             : nb_contacts_branch(model, c);
    sum += contacts->kept[NB_STIFFNESS][c] * vec_dot(l, l); /* 0 without contact */
  }
  return sum / (4 * volume);
}

/* rho, kg/m3. `volume`: A h, m3. */
static double density(const struct nb_model *model, double volume) {
  double sum = 0;
  for (size_t k = 0; k < model->particles.count; k++)
    if (!nb_removed(model, (size_t)model->particles.slot[k]))
      sum += model->particles.mass[model->particles.slot[k]];
  return sum / volume;
}

/* The matrix whose columns are the axes of the servo. */
static struct nb_tensor axes(const struct nb_servo *servo) {
  return tensor(servo->axis_x[0], servo->axis_y[0], servo->axis_x[1], servo->axis_y[1]);
}

/* Measured stress in the axes of the servo, Pa. */
static struct nb_tensor stress(const struct nb_model *model, const struct nb_servo *servo) {
  double measured[4];
  for (int k = 0; k < 4; k++)
    measured[k] = nb_quantity_now(servo->quantity[k], model);
  return tensor_turned(tensor_transpose(axes(servo)), tensor(measured[0], measured[1], measured[2], measured[3]));
}

/* s - s0 in the axes of the servo, Pa; 0 in components that are not controlled. With a ramp, s0 changes from the stress
 * at the beginning of the servo (`fraction` 0) to the target (`fraction` 1). */
static struct nb_tensor stress_error(const struct nb_model *model, const struct nb_servo *servo, double fraction) {
  const struct nb_servo_state *state = &model->affine->servo_state;
  const struct nb_tensor measured = stress(model, servo);
  double error[3] = {measured.xx, measured.yy, measured.xy};
  for (int k = 0; k < 3; k++)
    error[k] -= state->stress[k] + fraction * (servo->stress[k] - state->stress[k]);
  if (servo->mean)
    return tensor((error[0] + error[1]) / 2, 0, 0, (error[0] + error[1]) / 2);
  const double shear = servo->controlled[2] ? error[2] : 0;
  return tensor(servo->controlled[0] ? error[0] : 0, shear, shear, servo->controlled[1] ? error[1] : 0);
}

bool nb_servo_opposes(const struct nb_servo *servo, const struct nb_strain_rate *rate) {
  const struct nb_tensor l =
      tensor_turned(tensor_transpose(axes(servo)), tensor(rate->xx, rate->xy, rate->yx, rate->yy));
  const double least = 1e-9 * tensor_largest(l); /* a rotation by `transform` rounds */
  const bool xx = fabs(l.xx) > least, yy = fabs(l.yy) > least, xy = fabs(l.xy + l.yx) > least;
  return servo->mean ? fabs(l.xx + l.yy) > least
                     : (servo->controlled[0] && xx) || (servo->controlled[1] && yy) || (servo->controlled[2] && xy);
}

double nb_servo_error(const struct nb_model *model) {
  const struct nb_servo *servo = &model->stage->servo;
  const double *s = servo->stress, target = fmax(fmax(fabs(s[0]), fabs(s[1])), fabs(s[2]));
  return target > 0 ? tensor_largest(stress_error(model, servo, 1)) / target : 0;
}

bool nb_servo_condition(char *text, size_t size, const struct nb_scene *scene, const struct nb_servo *servo,
                        bool unitless) {
  static const int part[] = {0, 3, 1}; /* indices of xx, yy and xy among the four measured components */
  *text = '\0';
  for (int k = 0; k < (servo->mean ? 1 : 3); k++) {
    const struct nb_quantity stress = servo->quantity[part[k]];
    if (servo->stress[k] == 0) /* as of components that are not controlled */
      continue;
    nb_append(text, size, "%s%s%s%s.%s %s %g%s", *text ? " and " : "",
              stress.monitor < 0 ? "" : scene->monitors[stress.monitor].name, stress.monitor < 0 ? "" : ".",
              stress.kind->name,
              servo->mean     ? "mean"
              : stress.suffix ? stress.suffix->name
                              : "",
              servo->stress[k] > 0 ? "above" : "below", NB_SERVO_NEAR * servo->stress[k], unitless ? "" : " Pa");
  }
  return *text;
}

bool nb_servo_scales(const struct nb_model *model, const struct nb_servo *servo, double *b, double *t) {
  const struct nb_vec sides = servo->box ? nb_box_sides(model) : vec(0, 0);
  *b = *t = 0;
  if (!servo->cell && !servo->box && !nb_boundary_exists(model))
    return false;
  const double area = servo->cell  ? nb_cell_area(model->cell)
                      : servo->box ? sides.x * sides.y
                                   : nb_boundary_area(model);
  const double width = servo->cell || servo->box ? sqrt(area) : 2 * nb_boundary_radius(model);
  const double volume = area * nb_thickness(model);
  *b = stiffness(model, servo, volume);
  *t = width * sqrt(density(model, volume) / *b); /* infinite if nothing touches */
  return *b > 0;
}

/* Strain rate to be added, in the axes of the servo, 1/s. Advances Z. `fraction`: see stress_error. */
static struct nb_tensor correction(struct nb_model *model, const struct nb_servo *servo, double fraction) {
  const double limit = servo->per_cycle ? servo->max_rate / model->step : servo->max_rate;
  double b, t;
  nb_servo_scales(model, servo, &b, &t);
  struct nb_servo_state *state = &model->affine->servo_state;
  const struct nb_tensor error = stress_error(model, servo, fraction);
  /* With b = 0, t is infinite, and only the direction of the error counts. */
  const double largest = tensor_largest(error), rate = b > 0 ? 1 / (2 * b * t) : INFINITY;
  const bool too_fast = largest > 0 && rate * largest > limit;
  const struct nb_tensor p = tensor_scale(too_fast ? limit / largest : largest > 0 ? rate : 0, error);
  const struct nb_tensor added = tensor_add(p, state->integral);
  const bool within = !too_fast && tensor_largest(added) <= limit, begins = state->phase == NB_SERVO_BEGINS;
  state->phase = within || state->phase == NB_SERVO_FREE ? NB_SERVO_FREE : NB_SERVO_LIMITED;
  if (!begins && within) {
    state->integral = tensor_add(state->integral, tensor_scale((double)servo->every * model->step / (16 * t), p));
    return added;
  }
  state->integral = tensor_scale(-(1 - sqrt(0.75)) / 2, p);
  return tensor_add(p, state->integral);
}

void nb_servo_begin(struct nb_model *model) {
  const struct nb_servo *servo = &model->stage->servo;
  struct nb_servo_state *state = &model->affine->servo_state;
  *state = (struct nb_servo_state){.phase = NB_SERVO_BEGINS};
  const struct nb_tensor now = stress(model, servo);
  const double first[3] = {now.xx, now.yy, now.xy};
  for (int k = 0; k < 3; k++)
    state->stress[k] = servo->ramp ? first[k] : servo->stress[k];
}

void nb_servo_apply(struct nb_model *model) {
  struct nb_affine *affine = model->affine;
  const struct nb_servo *servo = &model->stage->servo;
  if (model->stage_cycle % servo->every != 0 || !(servo->cell || servo->box || model->boundary->ring.held))
    return;
  const double fraction = servo->ramp ? (double)(model->stage_cycle + 1) / (double)model->stage->cycles : 1;
  const struct nb_tensor added = tensor_turned(axes(servo), correction(model, servo, fraction));
  const bool servoed[NB_AFFINE_SOURCES] = {
      [NB_AFFINE_FREE] = servo->affine,
      [NB_AFFINE_BOUNDARY] = !servo->cell && !servo->box,
      [NB_AFFINE_CELL] = servo->cell,
      [NB_AFFINE_BOX] = servo->box,
  };
  for (int c = NB_AFFINE_FREE; c < NB_AFFINE_SOURCES; c++)
    affine->rate[c] = servoed[c] ? tensor_add(affine->base_rate[c], added) : affine->base_rate[c];
}
