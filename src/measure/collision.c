/* Collision prediction: finds the pairs that would collide at their current velocities, and among these collisions the
 * one with the shortest duration by Hertz's law (hertz_impact.h).
 *
 * Two particles with the vector d = y - x between their centres, m, and the relative velocity w = v_x - v_y, m/s,
 * collide if w.d > 0 and their straight paths pass closer than s = R_x + R_y, m. The approach velocity along the line
 * of centres is then
 *
 *   v = sqrt(w^2 - (w x d)^2/s^2)
 *
 * A particle hits the face of a wall along the wall's normal, and an end of a wall like a particle without radius. A
 * pair that already touches approaches at v = w.d/|d|.
 *
 * Walls move as in the stage that sets the step; a step that the page gives before its first stage counts as one of the
 * first stage. The prediction neglects gravity, the rotation of walls before the collision, and particles in between.
 * It tests every moving particle with every other particle once, so a gas of a million particles takes long.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>

#include "core/hertz_impact.h"
#include "step.h"

struct approach {
  double speed; /* approach velocity along the line of centres, m/s; 0: no collision */
  double time;  /* time until first touch, s */
};

static struct approach no_collision(void) { return (struct approach){0, INFINITY}; }

/* The collision of two circles. `apart`: d, m; `relative`: w, m/s; `radius_sum`: s, m. */
static struct approach circles_approach(struct nb_vec apart, struct nb_vec relative, double radius_sum) {
  const double distance = vec_length(apart), along = vec_dot(relative, apart);
  if (!(along > 0))
    return no_collision();
  if (distance <= radius_sum)
    return (struct approach){along / distance, 0};
  const double size = vec_length(relative), aside = vec_cross(relative, apart) / radius_sum;
  const double square = (size - aside) * (size + aside);
  if (!(square > 0))
    return no_collision();
  const double speed = sqrt(square);
  return (struct approach){speed, (along / size - speed * radius_sum / size) / size};
}

/* Velocities of a wall in the stage that sets the step. When the step of the scene is set, the first stage has not
 * begun; the velocities then follow from its statements, except those with `ramp`. */
static struct nb_velocities wall_state(const struct nb_model *model, int wall) {
  struct nb_velocities state = {model->walls.velocity[wall], model->walls.spin[wall]};
  const struct nb_stage *first = &model->scene->stages[0];
  for (size_t k = 0; k < first->motion_count && !model->stage; k++)
    if (first->motions[k].wall == wall && !first->motions[k].ramp)
      state = (struct nb_velocities){vec(first->motions[k].vx, first->motions[k].vy), first->motions[k].spin};
  return state;
}

/* The velocity relative to wall w, m/s, at a point that moves as the wall does. `state`: the wall's velocities. */
static struct nb_vec relative_to_wall(const struct nb_walls *walls, int w, struct nb_velocities state,
                                      struct nb_vec velocity, struct nb_vec point) {
  const struct nb_vec arm = vec_sub(point, walls->pivot[w]);
  return vec_sub(velocity, vec_add(state.velocity, vec_scale(state.spin, vec(-arm.y, arm.x))));
}

/* The collision of a particle with wall w. */
static struct approach wall_approach(const struct nb_model *model, struct nb_vec position, struct nb_vec velocity,
                                     double radius, int w) {
  const struct nb_walls *walls = &model->walls;
  const struct nb_vec along = walls->along[w], from = vec_sub(position, walls->point[w]);
  const double s = vec_dot(from, along);
  const struct nb_velocities state = wall_state(model, w);
  const struct nb_vec relative = relative_to_wall(walls, w, state, velocity, position);
  /* The particle hits the face if, at first touch, the foot of the perpendicular from its centre is on the wall. */
  const double side = vec_cross(along, from), height = fabs(side),
               speed = -copysign(1, side) * vec_cross(along, relative);
  const double time = height > radius ? (height - radius) / speed : 0, foot = s + vec_dot(relative, along) * time;
  if (speed > 0 && foot >= walls->h1[w] && foot <= walls->h2[w])
    return (struct approach){speed, time};
  struct approach first = no_collision();
  for (int end = 0; end < 2; end++) {
    const struct nb_vec point = nb_wall_end(walls, w, end);
    const struct approach there =
        circles_approach(vec_sub(point, position), relative_to_wall(walls, w, state, velocity, point), radius);
    first = there.time < first.time ? there : first;
  }
  return first;
}

/* Duration of a collision of elastic spheres, s. `young`: E*, Pa; `radius`: R*, m; `mass`: M*, kg; `speed`: approach
 * velocity, m/s. */
static double duration(double young, double radius, double mass, double speed) {
  return nb_hertz_duration(nb_hertz_depth(young, radius, mass, speed), speed);
}

static bool moving(struct nb_vec velocity) { return velocity.x != 0 || velocity.y != 0; }

static void keep_shorter(struct nb_collision *shortest, struct nb_collision other) {
  if (other.duration < shortest->duration)
    *shortest = other;
}

/* E* of two materials, Pa. */
static double effective_young(const struct nb_model *model, int a, int b) {
  return nb_properties_pair(&model->properties, a, b).young;
}

/* Tries the collisions of the moving particle i with all other particles except moving ones with a smaller number: those
 * pairs have been tried already. `velocity`: the velocities of all particles. */
static void try_particles(struct nb_collision *shortest, const struct nb_model *model, const struct nb_vec *velocity,
                          size_t i) {
  const struct nb_particles *particles = &model->particles;
  for (size_t j = 0; j < particles->count; j++) {
    const double inverse = particles->inverse_mass[i] + particles->inverse_mass[j];
    if (j == i || nb_removed(model, j) || (moving(velocity[j]) && particles->number[j] < particles->number[i]))
      continue; /* the duration of a collision of two fixed particles is infinite */
    const double radius_sum = particles->radius[i] + particles->radius[j];
    const double speed = circles_approach(vec_sub(particles->position[j], particles->position[i]),
                                          vec_sub(velocity[i], velocity[j]), radius_sum)
                             .speed;
    if (speed > 0)
      keep_shorter(shortest,
                   (struct nb_collision){
                       duration(effective_young(model, particles->material[i], particles->material[j]),
                                nb_reduced_radius(particles->radius[i], particles->radius[j]), 1 / inverse, speed),
                       speed, (int)i, (int)j, false});
  }
}

static void try_walls(struct nb_collision *shortest, const struct nb_model *model, struct nb_vec velocity, size_t i) {
  const struct nb_particles *particles = &model->particles;
  for (int w = 0; w < (int)model->walls.count && particles->inverse_mass[i] > 0; w++) {
    const double speed = wall_approach(model, particles->position[i], velocity, particles->radius[i], w).speed;
    if (speed > 0 && !nb_wall_removed(&model->walls, (size_t)w))
      keep_shorter(shortest, (struct nb_collision){duration(effective_young(model, particles->material[i],
                                                                            model->scene->walls[w].material),
                                                            particles->radius[i], particles->mass[i], speed),
                                                   speed, (int)i, w, true});
  }
}

enum nb_status nb_collision_shortest(struct nb_collision *shortest, const struct nb_model *model,
                                     struct nb_error *error) {
  const size_t n = model->particles.count;
  struct nb_vec *velocity = nb_array(n, sizeof *velocity);
  *shortest = (struct nb_collision){INFINITY, 0, -1, -1, false};
  if (!velocity)
    return nb_error_memory(error);
  for (size_t i = 0; i < n; i++)
    velocity[i] = nb_velocity_total(model, i);
  for (size_t k = 0; k < n; k++) { /* in the order of numbers: of equal durations the first one is kept */
    const size_t i = (size_t)model->particles.slot[k];
    if (moving(velocity[i]))
      try_particles(shortest, model, velocity, i);
    try_walls(shortest, model, velocity[i], i);
  }
  free(velocity);
  return NB_OK;
}
