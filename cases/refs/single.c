/* One particle on one straight wall at rest: read from the scene.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "single.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* c of a dashpot beside a spring k on a mass m, N s/m, by the statement of the page [CS79 28; R89 4.3, 4.13].
 * `critical` is the single-contact step, s. */
static double dashpot(const struct nb_damping *damping, double k, double m, double critical) {
  double value;
  switch (nb_damping_at(damping, true, &value)) {
  case NB_CONTACT_STIFFNESS:
    return value * k;
  case NB_CONTACT_R89_FRACTION:
    return value * k * critical / 2;
  case NB_CONTACT_RATIO:
    return value * 2 * sqrt(m * k);
  case NB_CONTACT_UNDAMPED:
    break;
  }
  return 0;
}

static enum nb_status refuse(struct nb_error *error, const char *reference, const char *what) {
  return nb_error_set(error, NB_BAD_USE, "the reference `%s` is for %s", reference, what);
}

bool single_faces(const struct nb_wall *wall, double x, double y) {
  const double s = (x - wall->x) * wall->ex + (y - wall->y) * wall->ey;
  return s > wall->h1 && s < wall->h2;
}

enum nb_status single_read(struct single *single, const char *reference, const struct nb_scene *scene,
                           struct nb_error *error) {
  if (scene->particle_count != 1 || scene->wall_count != 1)
    return refuse(error, reference, "one particle and one wall");
  const struct nb_particle *particle = &scene->particles[0];
  const struct nb_wall *wall = &scene->walls[0];
  if (wall->ey != 0 || !(particle->y > wall->y) || !single_faces(wall, particle->x, particle->y))
    return refuse(error, reference, "a wall along x, below the particle");
  const double m = matter_mass(scene, particle);
  const struct matter_pair pair = matter_pair(scene, particle->material, wall->material);
  /* of the stiffest pair of materials: with the wall, or of two such particles [CS79, Motion] */
  const double critical = 2 * sqrt(m / fmax(pair.kn, matter_pair(scene, particle->material, particle->material).kn));
  *single = (struct single){
      .m = m,
      .q = m * particle->radius * particle->radius / matter_inertia(scene, particle),
      .radius = particle->radius,
      .pair = pair,
      .height = particle->y - wall->y,
      .gravity_n = -scene->gravity.y,
      .cn = dashpot(&scene->damping, pair.kn, m, critical),
      .cs = dashpot(&scene->damping, pair.ks, m, critical),
  };
  if (scene->step.kind == NB_STEP_TIME)
    single->step = scene->step.value;
  else if (scene->step.kind == NB_STEP_SINGLE_CONTACT)
    single->step = scene->step.value * critical;
  else
    return refuse(error, reference, "a step given as a time or as a fraction of single-contact");
  for (size_t w = 0; w < scene->monitor_count; w++) {
    if (scene->monitors[w].kind == NB_MONITOR_PARTICLE)
      single->particle = scene->monitors[w].name;
    if (scene->monitors[w].kind == NB_MONITOR_PARTICLE_WALL)
      single->contact = scene->monitors[w].name;
  }
  return NB_OK;
}

void single_add(struct nb_solution *solution, const char *monitor, const char *what, const char *stage, double value) {
  char name[3 * NB_NAME_SIZE];
  if (!monitor)
    return;
  snprintf(name, sizeof name, "%s.%s%s%s", monitor, what, stage ? " in " : "", stage ? stage : "");
  solution_value(solution, value, name);
}

void single_curve(struct nb_solution *solution, const char *monitor, const char *what,
                  double (*at)(const void *data, double t), const void *data, size_t size) {
  char name[2 * NB_NAME_SIZE];
  if (!monitor)
    return;
  snprintf(name, sizeof name, "%s.%s", monitor, what);
  void *copy = malloc(size);
  if (copy)
    memcpy(copy, data, size);
  solution_curve(solution, name, "time", at, copy);
}
