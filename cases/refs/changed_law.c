/* Reference: a contact of constant overlap alpha whose tangential displacement grows as v t, under laws that change
 * from stage to stage. A sphere of the radius R, too heavy to move, touches a wall that moves tangentially.
 *
 *   normal linear            N = k_n alpha
 *   normal hertz             N = (4/3) E* R^(1/2) alpha^(3/2),    a = (R alpha)^(1/2)                [R89 3.13]
 *   normal hertz_increment   N = 0: it adds up increments of the overlap, and there are none [R89 4.11]
 *   shear none               T = 0
 *   shear linear             T = k_s s                                                              [CS79 17]
 *   shear mindlin            T = 8 G* a s                                                           [R89 3.27]
 *   shear mindlin_deresiewicz
 *                            T = Int_0^y (s - s_1 x/alpha) dK + Int_y^alpha A (alpha - x) dK,  K(x) = 8 G* (R x)^(1/2)
 *                            A = 3 mu N/(2 alpha K(alpha)),    y = (A alpha - s)/(A - s_1/alpha)
 *
 *   s   tangential displacement since the shear law or its memory size changed, m. A stage that repeats the law, or
 *       changes the normal law alone, does not reset s. The laws of a stage from t_0 to t_N hold for t_0 < t <= t_N
 *   s_1 tangential displacement of the first step after that change, m. The law takes a contact without history as
 *       formed in that step, with overlap and s growing in proportion. The contact consists of springs side by side.
 *       The spring that begins to touch at the overlap x has the stiffness dK and is displaced by s - s_1 x/alpha,
 *       until it slides at the displacement A (alpha - x). The springs with x > y slide. With s_1 = 0 this is
 *       T = mu N (1 - (1 - s/(A alpha))^(3/2)) [R89 3.25]
 *
 * Returns, for C that monitors the contact:   C.normal, C.shear versus time, N
 * Accepts only T < mu N. Exact.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reference.h"

enum { STAGES = 32 };

struct course {
  struct matter_pair pair;
  double radius, overlap, v; /* m, m; tangential velocity, m/s */
  size_t count;
  struct part {
    const char *normal, *shear;
    double end, begin, step; /* end of the stage; beginning of the shear law and the step at that time; s */
  } parts[STAGES];
};

static const struct part *part_at(const struct course *it, double time) {
  size_t k = 0;
  while (k + 1 < it->count && time > it->parts[k].end * (1 + 1e-12))
    k++;
  return &it->parts[k];
}

static double contact_radius(const struct course *it) { return sqrt(it->radius * it->overlap); }

static double normal_at(const void *data, double time) {
  const struct course *it = data;
  const char *law = part_at(it, time)->normal;
  if (strcmp(law, "linear") == 0)
    return it->pair.kn * it->overlap;
  return strcmp(law, "hertz") == 0 ? 4. / 3 * it->pair.young * contact_radius(it) * it->overlap : 0;
}

static double stiffness(const struct course *it, double x) { return 8 * it->pair.shear * sqrt(it->radius * x); }

/* The integral of x' dK(x') from x' = 0 to x. */
static double moment(const struct course *it, double x) { return stiffness(it, x) * x / 3; }

static double exact(const struct course *it, const struct part *part, double s, double normal) {
  const double alpha = it->overlap, k = stiffness(it, alpha), slope = fabs(it->v) * part->step / alpha;
  const double a = 1.5 * it->pair.friction * normal / (alpha * k), y = (a * alpha - s) / (a - slope);
  if (!(normal > 0))
    return 0;
  return s * stiffness(it, y) - slope * moment(it, y) + a * alpha * (k - stiffness(it, y)) -
         a * (moment(it, alpha) - moment(it, y));
}

static double shear_at(const void *data, double time) {
  const struct course *it = data;
  const struct part *part = part_at(it, time);
  const double s = it->v * (time - part->begin);
  if (strcmp(part->shear, "linear") == 0)
    return it->pair.ks * s;
  if (strcmp(part->shear, "mindlin") == 0)
    return stiffness(it, it->overlap) * s;
  return strcmp(part->shear, "none") == 0 ? 0 : copysign(exact(it, part, fabs(s), normal_at(data, time)), s);
}

/* Reads the laws of the stages. False: a stage changes the motion of the wall, has a step that is not given as a time,
 * or makes the contact slide; or there are more than STAGES stages. */
static bool read_stages(struct course *it, const struct nb_scene *scene) {
  const char *normal = scene->normal, *shear = scene->shear;
  int pieces = scene->pieces;
  double time = 0, begin = 0, step = scene->stages[0].step.value;
  for (size_t s = 0; s < scene->stage_count && s < STAGES; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    const bool other = stage->laws.shear[0] && (strcmp(stage->laws.shear, shear) != 0 || stage->laws.pieces != pieces);
    if (stage->step.kind != NB_STEP_TIME || stage->motion_count)
      return false;
    if (other)
      shear = stage->laws.shear, pieces = stage->laws.pieces, begin = time, step = stage->step.value;
    if (stage->laws.normal[0])
      normal = stage->laws.normal;
    time += (double)stage->cycles * stage->step.value;
    it->parts[it->count++] = (struct part){normal, shear, time, begin, step};
    if (shear_at(it, time) != 0 && !(fabs(shear_at(it, time)) < it->pair.friction * normal_at(it, time)))
      return false;
  }
  return scene->stage_count <= STAGES;
}

static enum nb_status solve(struct nb_solution *solution, const struct nb_scene *scene, struct nb_error *error) {
  const struct nb_particle *particle = scene->particles;
  const struct nb_wall *wall = scene->walls;
  if (scene->particle_count != 1 || scene->wall_count != 1)
    return nb_error_set(error, NB_BAD_USE, "the reference `changed_law` is for one sphere and one wall");
  const double dx = particle->x - wall->x, dy = particle->y - wall->y, away = dy * wall->ex - dx * wall->ey;
  const double side = away > 0 ? 1 : -1; /* e points from the particle to the wall, t is e turned clockwise */
  struct course it = {.pair = matter_pair(scene, particle->material, wall->material),
                      .radius = particle->radius,
                      .overlap = particle->radius - fabs(away),
                      .v = side * (wall->vx * wall->ex + wall->vy * wall->ey)};
  /* Rounding leaves about 1e-16 of the speed; a normal velocity that the page gives is far above 1e-14 of it. */
  const bool along = fabs(wall->vy * wall->ex - wall->vx * wall->ey) <= 1e-14 * hypot(wall->vx, wall->vy);
  if (!(it.overlap > 0) || !along || !read_stages(&it, scene))
    return nb_error_set(
        error, NB_BAD_USE,
        "the reference `changed_law` is for up to %d stages, a wall that moves tangentially at a constant "
        "velocity, steps given as times, and a contact that does not slide",
        STAGES);
  const double end = it.parts[it.count - 1].end, mass = matter_mass(scene, particle);
  const double foot = dx * wall->ex + dy * wall->ey, moved = foot - side * it.v * end;
  if (!(fmin(foot, moved) > wall->h1 && fmax(foot, moved) < wall->h2))
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `changed_law` is for a wall so long that the sphere stays on it");
  const double most = fmax(it.pair.kn * it.overlap, 4. / 3 * it.pair.young * contact_radius(&it) * it.overlap);
  if (!(most * end * end / 2 < 1e-13 * mass * it.overlap))
    return nb_error_set(error, NB_BAD_USE,
                        "the reference `changed_law` is for a sphere so heavy that its contact does not move it");
  for (size_t w = 0; w < scene->monitor_count; w++) {
    if (scene->monitors[w].kind != NB_MONITOR_PARTICLE_WALL)
      continue;
    for (int shear = 0; shear < 2; shear++) {
      char name[2 * NB_NAME_SIZE];
      struct course *data = malloc(sizeof *data);
      if (data)
        *data = it;
      snprintf(name, sizeof name, "%s.%s", scene->monitors[w].name, shear ? "shear" : "normal");
      solution_curve(solution, name, "time", shear ? shear_at : normal_at, data);
    }
  }
  return solution_status(solution, error);
}

const struct nb_reference reference_changed_law = {
    .name = "changed_law",
    .title = "a contact of constant overlap that is sheared under one law after the other, in closed form",
    .source = "[CS79 17] [R89 3.13, 3.25, 3.27]",
    .accepts = {HAS_SPHERES, HAS_MOVING_WALLS, HAS_FRICTION, HAS_MEMORY, HAS_LAW_CHANGE, HAS_STEP_CHANGE},
    .needs = {HAS_WALLS},
    .normal = "linear hertz hertz_increment",
    .shear = "none linear mindlin mindlin_deresiewicz",
    .solve = solve,
};
