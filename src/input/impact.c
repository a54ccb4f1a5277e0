/* `impact`: position and velocity of a particle for an impact at a given speed and angle of incidence.
 *
 *   v = V (-cos(theta) n + sin(theta) t)
 *   psi1 = V_T/(mu kappa V_N),   V_N = V cos(theta),   V_T = V sin(theta) + S          [R89 5.15]
 *
 *   v, V     velocity of the particle's centre relative to the other particle or the wall, and its magnitude, m/s
 *   theta    angle of incidence, rad
 *   n, t     unit normal towards the particle; n rotated clockwise through 90 deg
 *   V_N, V_T normal and tangential relative velocity of the contact point, m/s
 *   S        sum of R w over the particles of the contact, m/s: R radius, w angular velocity
 *   mu       friction coefficient, 1
 *   kappa    compliance ratio, E* / (4 G*), 1; k_n/k_s for linear springs
 *
 * With m = psi1 mu kappa the angle is theta = atan(m) - asin(S / (V sqrt(1 + m^2))).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "core/vec.h"
#include "measure/impact.h"
#include "statement.h"

enum { AT_NAME, AT_SPEED, AT_ANGLE, AT_PSI1, AT_PHASE };

/* clang-format off */
static const struct nb_argument impact_fields[] = {
  WORD("MONITOR", AT_NAME, "the name of a monitored contact"),
  CLAUSE("speed", "V", NB_UNIT_VELOCITY, NB_POSITIVE, AT_SPEED, 1, NULL,
         "Speed of the particle's centre relative to the other particle or the wall."),
  CLAUSE("angle", "A", NB_UNIT_ANGLE, NB_NOT_NEGATIVE, AT_ANGLE, 1, "|from `psi1`",
         "Angle of incidence, between the velocity of the particle's centre and the contact normal, below 90 deg."),
  CLAUSE("psi1", "P", NB_UNIT_NUMBER, NB_NOT_NEGATIVE, AT_PSI1, 1, "|from `angle`",
         "Dimensionless angle of incidence V_T/(mu kappa V_N) [R89 5.15]. V_T and V_N are the tangential and the normal velocity of the contact point, spin included; kappa = E*/(4 G*), or k_n/k_s of linear springs."),
  CLAUSE("phase", "F", NB_UNIT_NUMBER, NB_FRACTION, AT_PHASE, 1, "0", "The contact begins after this fraction of the first step."),
  END
};
/* clang-format on */

NB_APPLY(apply_impact) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_value *value = record->value;
  const struct nb_token *name = value[AT_NAME].token, *angle = value[AT_ANGLE].token, *psi1 = value[AT_PSI1].token;
  const int monitor = NB_FIND(scene->monitors, scene->monitor_count, name->text);
  const enum nb_monitor_kind kind = monitor < 0 ? NB_MONITOR_PARTICLE : scene->monitors[monitor].kind;
  if (nb_given_twice(reader, scene->impact.line))
    return;
  if (kind != NB_MONITOR_PARTICLE_PARTICLE && kind != NB_MONITOR_PARTICLE_WALL)
    nb_unknown_name(reader, name, "define it above with `monitor NAME sphere N with wall NAME`",
                    "the name of a monitored contact");
  if (angle && psi1)
    nb_token_mistake(reader, &reader->tokens[0], NULL, "expected either `angle` or `psi1`, found both");
  if (value[AT_ANGLE].number >= NB_PI / 2)
    nb_expected_at(reader, angle, NULL, "an angle below 90 deg");
  if (reader->bad)
    return;
  scene->impact = (struct nb_impact){
      .monitor = monitor,
      .speed = value[AT_SPEED].number,
      .angle = angle ? value[AT_ANGLE].number : NAN,
      .psi1 = psi1 ? value[AT_PSI1].number : NAN,
      .phase = value[AT_PHASE].number,
      .line = (int)reader->line,
  };
}

/* Sets position and velocity of the particle. Returns the message of a mistake; NULL: there is none. */
static const char *set_incidence(struct nb_scene *scene) {
  struct nb_impact *it = &scene->impact;
  const struct nb_monitor *monitor = &scene->monitors[it->monitor];
  struct nb_particle *particle = &scene->particles[monitor->a];
  const struct nb_particle *other =
      monitor->kind == NB_MONITOR_PARTICLE_PARTICLE ? &scene->particles[monitor->b] : NULL;
  const struct nb_impact_state incidence = nb_impact_incidence(scene);
  if (particle->fixed)
    return "expected a contact whose first particle is free, found a fixed one";
  if (particle->vx != 0 || particle->vy != 0)
    return "expected a particle without `velocity`: `impact` gives it one";
  if (!isfinite(incidence.normal.x))
    return other ? "expected two particles with different centres, found them at the same point"
                 : "expected a particle beside the wall, found its centre on the wall";
  const double slope = it->psi1 > 0 ? it->psi1 * incidence.friction * incidence.kappa : 0;
  if (it->psi1 > 0 && !(slope > 0))
    return "expected a contact with friction and a shear stiffness for `psi1`: give its material both, or write `angle "
           "A`";
  if (isnan(it->angle))
    it->angle = atan(slope) - asin(incidence.surface / (it->speed * sqrt(1 + slope * slope)));
  if (!(cos(it->angle) > 0))
    return "expected a slower spin or a higher speed: no angle of incidence gives this `psi1`";
  const double distance = particle->radius + (other ? other->radius : 0);
  const double normal_velocity = -it->speed * cos(it->angle), tangential_velocity = it->speed * sin(it->angle);
  particle->x = incidence.point.x + distance * incidence.normal.x;
  particle->y = incidence.point.y + distance * incidence.normal.y;
  particle->vx +=
      normal_velocity * incidence.normal.x + tangential_velocity * incidence.tangent.x - incidence.velocity.x;
  particle->vy +=
      normal_velocity * incidence.normal.y + tangential_velocity * incidence.tangent.y - incidence.velocity.y;
  return NULL;
}

void nb_impact_set(struct nb_scene_reading *reading) {
  const char *message = set_incidence(reading->scene);
  if (message)
    nb_line_mistake(&reading->reader, (size_t)reading->scene->impact.line, NULL, "%s", message);
}

/* clang-format off */
NB_STATEMENTS(impact) = {
  {"impact", NB_IN_SCENE, impact_fields, NULL, 0, false, apply_impact,
   "Lets the first particle of a monitored contact hit the other particle or the wall. The program moves the first particle along the normal until it just touches, on the side where the page has placed it, and sets its velocity; its spin stays. Above a horizontal wall the tangential velocity points in x. The quantities of the impact are called `impact.NAME`.",
   "impact    F  speed 0.4 m/s  angle 20 deg  phase 0.5"},
  {0},
};
/* clang-format on */
