/* Measures of an impact, in Maw's dimensionless numbers.                         [R89 5.9, 5.11, 5.12, 5.15]
 *
 *   psi = V_T/(mu kappa V_N)       V_T current tangential velocity of the contact, m/s; V_N normal velocity at first
 *                                  touch, m/s; mu friction, 1; psi1 is psi at first touch, psi2 the current psi
 *   kappa = E* / (4 G*)            compliance ratio, 1: (2 - nu)/(2 (1 - nu)) of like materials; k_n/k_s of springs
 *   N_max = (5/4) M V_N^2/alpha_m  largest normal force, N; hertz_impact.h gives alpha_m, m, and the duration T_c, s,
 *                                  with the symbol t
 *   linear springs:  T_c = pi sqrt(M/k_n),   N_max = V_N sqrt(M k_n)
 *
 * M is the reduced mass, kg. The state at first touch follows from the scene; a run stores only the time of first
 * touch.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "impact.h"
#include "core/hertz_impact.h"
#include "core/names.h"
#include "laws/laws_now.h"

/* Computes N_max, T_c and kappa of the impact without dissipation. */
static void elastic(struct nb_impact_state *incidence, struct nb_pair pair) {
  const double v = incidence->normal_v, m = incidence->mass;
  if (pair.young > 0) {
    const double depth = nb_hertz_depth(pair.young, pair.radius, m, v);
    incidence->peak = 1.25 * m * v * v / depth;
    incidence->duration = nb_hertz_duration(depth, v);
    incidence->kappa = pair.young / (4 * pair.shear);
  } else {
    incidence->peak = v * sqrt(m * pair.kn);
    incidence->duration = NB_PI * sqrt(m / pair.kn);
    incidence->kappa = pair.ks > 0 ? pair.kn / pair.ks : 0;
  }
}

/* The point of a wall nearest to x at time 0. */
static struct nb_vec nearest(const struct nb_wall *wall, struct nb_vec x) {
  const struct nb_vec along = vec(wall->ex, wall->ey);
  const struct nb_vec point = vec_add(vec(wall->x, wall->y), vec_scale(-wall->h0, vec_clockwise(along)));
  return vec_add(point, vec_scale(nb_wall_clamp(vec_dot(vec_sub(x, point), along), wall->h1, wall->h2), along));
}

static double inverse_mass(const struct nb_scene *scene, const struct nb_particle *particle) {
  return particle->fixed ? 0 : 1 / nb_particle_mass(scene, particle);
}

struct nb_impact_state nb_impact_incidence(const struct nb_scene *scene) {
  const struct nb_monitor *monitor = &scene->monitors[scene->impact.monitor];
  const struct nb_particle *particle = &scene->particles[monitor->a];
  const struct nb_particle *other =
      monitor->kind == NB_MONITOR_PARTICLE_PARTICLE ? &scene->particles[monitor->b] : NULL;
  const struct nb_wall *wall = other ? NULL : &scene->walls[monitor->b];
  const struct nb_law *law = nb_law_find("normal", scene->normal);
  struct nb_pair pair = nb_scene_pair(scene, particle->material, other ? other->material : wall->material);
  pair.radius = other ? nb_reduced_radius(particle->radius, other->radius) : particle->radius;
  pair.young = law->elastic ? pair.young : 0;

  struct nb_impact_state incidence = {.friction = pair.friction};
  const struct nb_vec x = vec(particle->x, particle->y), v = vec(particle->vx, particle->vy);
  incidence.point = other ? vec(other->x, other->y) : nearest(wall, x);
  incidence.normal = vec_scale(1 / vec_length(vec_sub(x, incidence.point)), vec_sub(x, incidence.point));
  incidence.tangent = vec_clockwise(incidence.normal);
  incidence.velocity = vec_sub(v, other ? vec(other->vx, other->vy) : vec(wall->vx, wall->vy));
  incidence.surface = particle->spin * particle->radius + (other ? other->spin * other->radius : 0);
  incidence.normal_v = -vec_dot(incidence.velocity, incidence.normal);
  incidence.tangent_v = vec_dot(incidence.velocity, incidence.tangent) + incidence.surface;
  incidence.mass = 1 / (inverse_mass(scene, particle) + (other ? inverse_mass(scene, other) : 0));
  elastic(&incidence, pair);
  return incidence;
}

/* ---- the current state ---- */

struct progress {
  struct nb_impact_state incidence;
  double direction;              /* sign of V_T at incidence: 1 or -1 */
  double elapsed;                /* time since first touch, s */
  struct nb_vec displacement, v; /* relative to the other partner: displacement since first touch, m; velocity, m/s */
  double rolled, surface;        /* sum of R theta since first touch, m; sum of R w, m/s */
  double normal_f, shear_f;      /* F_n, F_s, N */
  double rotational_energy;      /* kinetic energy of the rotation, J */
};

static struct progress progress(const struct nb_model *model) {
  const struct nb_scene *scene = model->scene;
  const struct nb_particles *particles = &model->particles;
  const struct nb_monitor *monitor = &scene->monitors[scene->impact.monitor];
  const bool wall = monitor->kind == NB_MONITOR_PARTICLE_WALL;
  const int i = particles->slot[monitor->a], j = wall ? monitor->b : particles->slot[monitor->b];
  const long contact = nb_contacts_find(model, i, j, wall);
  const struct nb_velocities a = nb_velocity_now(model, (size_t)i);
  struct nb_velocities b = {.spin = 0};
  if (wall)
    b.velocity = model->walls.velocity[j];
  else
    b = nb_velocity_now(model, (size_t)j);
  const struct nb_particle *particle = &scene->particles[monitor->a],
                           *other = wall ? NULL : &scene->particles[monitor->b];
  struct progress it = {.incidence = nb_impact_incidence(scene), .elapsed = model->time - model->impact_time};
  const struct nb_vec at = wall ? model->walls.pivot[j] : particles->position[j];
  const struct nb_vec start = wall ? vec(scene->walls[j].x, scene->walls[j].y) : vec(other->x, other->y);
  it.direction = it.incidence.tangent_v < 0 ? -1 : 1;
  it.v = vec_sub(a.velocity, b.velocity);
  it.surface = a.spin * particle->radius + (wall ? 0 : b.spin * other->radius);
  it.displacement = vec_sub(vec_sub(particles->position[i], at), vec_sub(vec(particle->x, particle->y), start));
  if (particles->angle)
    it.rolled = particles->angle[i] * particle->radius + (wall ? 0 : particles->angle[j] * other->radius);
  it.rolled -= model->impact_time * it.incidence.surface;
  it.normal_f = nb_field_of(model, contact, NB_NORMAL), it.shear_f = nb_field_of(model, contact, NB_SHEAR);
  it.rotational_energy =
      (particles->inertia[i] * a.spin * a.spin + (wall ? 0 : particles->inertia[j] * b.spin * b.spin)) / 2;
  return it;
}

#define QUANTITY(function, expression)                                                                                 \
  static double function(const struct nb_model *model, const struct nb_monitor *monitor) {                             \
    const struct progress it = progress(model);                                                                        \
    const struct nb_impact_state *s = &it.incidence;                                                                   \
    (void)monitor, (void)s;                                                                                            \
    return expression;                                                                                                 \
  }
static double psi(const struct nb_impact_state *s, double v) { return v / (s->friction * s->kappa * s->normal_v); }
/* Tangential velocity of the contact, positive in the direction at incidence, m/s. */
static double along(const struct progress *it) {
  return it->direction * (vec_dot(it->v, it->incidence.tangent) + it->surface);
}
/* The duration of the contact so far, s. If the contact has opened, the time since then is subtracted: the gap divided
 * by the speed of separation. */
static double duration_now(const struct progress *it) {
  const double gap = vec_dot(it->displacement, it->incidence.normal), v = vec_dot(it->v, it->incidence.normal);
  return it->elapsed - (gap > 0 && v > 0 ? gap / v : 0);
}
static double square(double x) { return x * x; }

QUANTITY(psi_first, psi(s, it.direction * s->tangent_v))
QUANTITY(psi_now, psi(s, along(&it)))
QUANTITY(angle, atan2(fabs(vec_dot(s->velocity, s->tangent)), s->normal_v))
QUANTITY(elapsed, it.elapsed / s->duration)
QUANTITY(duration, duration_now(&it))
QUANTITY(restitution, vec_length(it.v) / vec_length(s->velocity))
QUANTITY(normal, it.normal_f / s->peak)
QUANTITY(shear, -it.direction *it.shear_f / (s->friction * s->peak))
QUANTITY(slip, it.elapsed > 0 ? it.direction * (vec_dot(it.displacement, s->tangent) + it.rolled) : 0)
QUANTITY(energy_normal, s->mass *square(vec_dot(it.v, s->normal)) / 2)
QUANTITY(energy_tangential, s->mass *square(vec_dot(it.v, s->tangent)) / 2)
QUANTITY(energy_rotational, it.rotational_energy)

const struct nb_quantity_kind nb_impact_kinds[] = {
    {"impact.psi1", NB_OF_IMPACT, "1", 0, psi_first, "V_T/(mu kappa V_N) of the contact at incidence [R89 5.15]"},
    {"impact.psi2", NB_OF_IMPACT, "1", 0, psi_now,
     "V_T/(mu kappa V_N) with the present V_T and the V_N of incidence; its last value is that of the rebound"},
    {"impact.angle", NB_OF_IMPACT, "rad", 0, angle,
     "angle between the relative velocity of the two centres, or of centre and wall, and the normal, at incidence [R89 "
     "5.16]",
     NB_AT_LEAST_0},
    {"impact.time", NB_OF_IMPACT, "1", NB_REQUEST_CLOCK, elapsed,
     "time since first touch, over the duration T_c of the elastic impact [R89 5.12]"},
    {"impact.duration", NB_OF_IMPACT, "s", 0, duration,
     "duration of the impact so far, from first touch to separation"},
    {"impact.restitution", NB_OF_IMPACT, "1", 0, restitution,
     "present speed of the centre relative to the other centre, or to the wall, over the same speed at incidence",
     NB_AT_LEAST_0},
    {"impact.normal", NB_OF_IMPACT, "1", NB_BIT(NB_NORMAL), normal,
     "normal force over its maximum in an elastic impact, N/N_max", NB_AT_LEAST_0_BY_LAW},
    {"impact.shear", NB_OF_IMPACT, "1", NB_BIT(NB_SHEAR), shear,
     "shear force against the motion at incidence, T/(mu N_max)"},
    {"impact.slip", NB_OF_IMPACT, "m", 0, slip, "tangential displacement of the contact since first touch"},
    {"impact.energy.normal", NB_OF_IMPACT, "J", 0, energy_normal,
     "present kinetic energy of the relative motion in the direction that the normal had at first touch",
     NB_AT_LEAST_0},
    {"impact.energy.tangential", NB_OF_IMPACT, "J", 0, energy_tangential,
     "present kinetic energy of the relative motion in the direction that the tangent had at first touch",
     NB_AT_LEAST_0},
    {"impact.energy.rotational", NB_OF_IMPACT, "J", 0, energy_rotational, "kinetic energy of rotation", NB_AT_LEAST_0},
    {.name = NULL},
};
