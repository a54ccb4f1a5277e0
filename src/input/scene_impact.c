/* `impact`: where a sphere begins, and how fast it goes, for it to strike something at a given angle.
 *
 *   v = V (-cos(theta) n + sin(theta) t)        n  unit normal from what is struck to the sphere, t  n turned clockwise
 *   psi1 = V_T/(mu kappa V_N)                   V_T = V sin(theta) + sum R w, of the point that touches [R89 5.15]
 *
 * With m = psi1 mu kappa the angle is atan(m) - asin( sum R w / (V sqrt(1 + m^2)) ).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "measure/impact.h"
#include "scene.h"

static const double right_angle = NB_PI / 2;

static int find_contact(const struct nb_scene *scene, const char *name) {
  for (size_t w = 0; w < scene->watch_count; w++)
    if (strcmp(scene->watches[w].name, name) == 0 && scene->watches[w].kind != NB_WATCH_BODY &&
        scene->watches[w].kind != NB_WATCH_WALL)
      return (int)w;
  return -1;
}

NB_APPLY(nb_apply_impact) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_value *value = record->value;
  const struct nb_token *name = value[AT_NAME].token, *angle = value[AT_ANGLE].token, *psi1 = value[AT_PSI1].token;
  const int watch = find_contact(scene, name->text);
  if (scene->impact.line) {
    nb_token_mistake(reader, &reader->tokens[0], NULL, "`%s` is said twice: first on line %d", reader->tokens[0].text,
                     scene->impact.line);
    return;
  }
  if (watch < 0) {
    nb_not_known(reader, name, "name it above: `watch NAME sphere N with wall NAME`", "the name of a watched contact");
    return;
  }
  if (!angle == !psi1) {
    nb_token_mistake(reader, &reader->tokens[0], NULL, "expected either `angle` or `psi1`, found %s",
                     angle ? "both" : "neither");
    return;
  }
  if (angle && !(value[AT_ANGLE].number < right_angle)) {
    nb_not_known(reader, angle, NULL, "an angle below 90 deg");
    return;
  }
  scene->impact = (struct nb_impact){
      .watch = watch,
      .speed = value[AT_SPEED].number,
      .angle = angle ? value[AT_ANGLE].number : NAN,
      .psi1 = psi1 ? value[AT_PSI1].number : NAN,
      .phase = value[AT_PHASE].number,
      .line = (int)reader->line,
  };
}

static const char *aim(struct nb_scene *scene) {
  struct nb_impact *impact = &scene->impact;
  const struct nb_watch *watch = &scene->watches[impact->watch];
  struct nb_body *body = &scene->bodies[watch->a];
  const struct nb_body *other = watch->kind == NB_WATCH_BODY_BODY ? &scene->bodies[watch->b] : NULL;
  const struct nb_strike strike = nb_impact_strike(scene);
  if (body->fixed)
    return "expected a contact whose first body is free, this one is fixed";
  if (body->vx != 0 || body->vy != 0)
    return "expected a particle without `velocity`: `impact` gives it one";
  if (!isfinite(strike.normal.x))
    return "expected a body beside what it strikes, this one is in its middle";
  const double slope = impact->psi1 > 0 ? impact->psi1 * strike.friction * strike.kappa : 0;
  if (impact->psi1 > 0 && !(slope > 0))
    return "expected friction and a shear stiffness in the contact of `psi1`, there is none";
  if (isnan(impact->angle))
    impact->angle = atan(slope) - asin(strike.rim / (impact->speed * sqrt(1 + slope * slope)));
  if (!(cos(impact->angle) > 0))
    return "expected a speed that makes this `psi1`, the spin is too fast for it";
  const double distance = body->radius + (other ? other->radius : 0);
  const double down = -impact->speed * cos(impact->angle), along = impact->speed * sin(impact->angle);
  body->x = strike.point.x + distance * strike.normal.x;
  body->y = strike.point.y + distance * strike.normal.y;
  body->vx += down * strike.normal.x + along * strike.tangent.x - strike.arrival.x;
  body->vy += down * strike.normal.y + along * strike.tangent.y - strike.arrival.y;
  return NULL;
}

void nb_impact_aim(struct nb_scene_reading *reading) {
  const char *wrong = aim(reading->scene);
  if (wrong)
    nb_line_mistake(&reading->reader, reading->scene->impact.line, NULL, "%s", wrong);
}
