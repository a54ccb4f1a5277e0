/* Motion of walls, and the test that no particle passes through one.      [CS79, Input parameters; figure 4]
 *
 *   P <- P + v_P dt,    e_w <- e_w rotated by the angle w dt
 *
 *   P    point about which the wall rotates, m, with the velocity v_P, m/s
 *   e_w  unit vector along the wall      w  angular velocity, rad/s, counterclockwise (CS79: dalpha/dt)
 *
 * The rotation is exact: e_w is rotated by the angle and normalised, so a wall neither grows nor drifts. Contacts use
 * the mean velocity of the wall's point Q over the last step, its displacement divided by the step (nb_wall_velocity).
 * For a small rotation it is v_P + w x (Q - P). The particle's velocity is a mean over the same step.
 *
 * A wall pushes a disc towards the side on which the disc's centre is. If the centre crosses to the other side, the
 * wall pushes the disc through: the disc was too fast for the step, or its overlap exceeded its radius. The test
 * compares the sides of the wall on which the centre is at the beginning and at the end of the step, in the frame of
 * the wall. Each search tests all pairs of a particle and a wall. Between searches a particle and a wall approach by at
 * most the skin. So listed pairs are tested in every cycle only if a centre was within the skin of a wall at the last
 * search.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */

#include "model.h"

/* e rotated counterclockwise; `rotation`: cosine and sine of the angle. */
static struct nb_vec rotated(struct nb_vec e, struct nb_vec rotation) {
  const double c = rotation.x, s = rotation.y;
  const struct nb_vec to = vec(c * e.x - s * e.y, s * e.x + c * e.y);
  return vec_scale(1 / vec_length(to), to);
}

/* True if the arc of the wall's far end departs from its chord by more than the smallest radius; see guard.c. */
bool nb_rotates_too_far(const struct nb_model *model, size_t w, double angle) {
  const struct nb_walls *walls = &model->walls;
  const double end = fabs(walls->h0[w]) + fmax(fabs(walls->h1[w]), fabs(walls->h2[w]));
  return angle * angle * fmax(end, model->search.smallest_radius) > 8 * model->search.smallest_radius;
}

/* Returns the number of walls with an end that moved by more than half the skin since the last search, or that
 * rotated too far. */
int nb_motion_walls(struct nb_model *model) {
  struct nb_walls *walls = &model->walls;
  int out = 0;
  for (size_t w = 0; w < walls->count; w++) {
    const double angle = walls->spin[w] * model->step;
    walls->pivot[w] = vec_add(walls->pivot[w], vec_scale(model->step, walls->velocity[w]));
    walls->turn[w] = vec(0, 0);
    if (angle != 0) {
      const double half = sin(angle / 2);
      walls->along[w] = rotated(walls->along[w], vec(cos(angle), sin(angle)));
      walls->turn[w] = vec(2 * half * half / model->step, sin(angle) / model->step);
    }
    walls->angle[w] += angle;
    walls->point[w] = vec_add(walls->pivot[w], vec_scale(-walls->h0[w], vec_clockwise(walls->along[w])));
    bool far = angle != 0 && nb_rotates_too_far(model, w, angle); /* after a full turn the ends are where they were */
    for (int end = 0; end < 2; end++) {
      const struct nb_vec d = vec_sub(nb_wall_end(walls, (int)w, end), walls->search_position[2 * w + (size_t)end]);
      far = far || !(4 * vec_dot(d, d) <= model->search.skin * model->search.skin);
    }
    out += far;
  }
  return out;
}

void nb_walls_reset_travel(struct nb_walls *walls) {
  for (size_t w = 0; w < walls->count; w++)
    for (int end = 0; end < 2; end++)
      walls->search_position[2 * w + (size_t)end] = nb_wall_end(walls, (int)w, end);
}

/* Coordinates of a point relative to a wall: along it, and to its left, m. */
static struct nb_vec wall_coordinates(struct nb_vec x, struct nb_vec pivot, struct nb_vec along, double h0) {
  const struct nb_vec from_p = vec_sub(x, pivot);
  return vec(vec_dot(from_p, along), -vec_dot(from_p, vec_clockwise(along)) - h0);
}

/* False when particle i is farther from the line of wall w than both together can have moved in the last step. This is
 * the common case. */
static inline bool may_cross(const struct nb_model *model, size_t i, size_t w) {
  const struct nb_walls *walls = &model->walls;
  const struct nb_vec x = model->particles.position[i], v = vec_sub(model->particles.velocity[i], walls->velocity[w]);
  const struct nb_vec from_p = vec_sub(x, walls->pivot[w]);
  const double away = fabs(-vec_dot(from_p, vec_clockwise(walls->along[w])) - walls->h0[w]);
  const double turn = fabs(walls->spin[w]) * (fabs(from_p.x) + fabs(from_p.y));
  return !(away > 2 * model->previous_step * (fabs(v.x) + fabs(v.y) + turn));
}

/* A crossing beyond an end of a wall counts up to this fraction of the wall's length, so that no particle slips through
 * a vertex. The fraction is far above the rounding of a coordinate (1e-16) and far below any intended gap. */
static const double beyond_end = 1e-12;

/* True if the centre of particle i moved from one side of wall w to the other, or onto the wall, between the ends of
 * the wall. Sets `displacement` to the displacement of the centre relative to the wall in the last step, m. */
static bool crossed(const struct nb_model *model, size_t i, size_t w, double *displacement) {
  const struct nb_walls *walls = &model->walls;
  const double dt = model->previous_step, h0 = walls->h0[w];
  const struct nb_vec x = model->particles.position[i];
  const struct nb_vec now = wall_coordinates(x, walls->pivot[w], walls->along[w], h0);
  const struct nb_vec before = wall_coordinates(
      vec_sub(x, vec_scale(dt, model->particles.velocity[i])),
      vec_sub(walls->pivot[w], vec_scale(dt, walls->velocity[w])),
      walls->spin[w] != 0 ? rotated(walls->along[w], vec(cos(walls->spin[w] * dt), -sin(walls->spin[w] * dt)))
                          : walls->along[w],
      h0);
  *displacement = vec_length(vec_sub(now, before));
  if ((before.y > 0 && now.y > 0) || (before.y < 0 && now.y < 0) || (now.y != 0 && before.y == 0))
    return false;
  const double fraction = now.y == 0 ? 1 : before.y / (before.y - now.y);
  const double at = before.x + fraction * (now.x - before.x), slack = beyond_end * (walls->h2[w] - walls->h1[w]);
  return at >= walls->h1[w] - slack && at <= walls->h2[w] + slack;
}

static enum nb_status crossing_error(const struct nb_model *model, size_t i, size_t w, double displacement,
                                     struct nb_error *error) {
  const struct nb_scene *scene = model->scene;
  const int number = model->particles.number[i];
  const double radius = model->particles.radius[i];
  const char *m = nb_unit(model->scene, " m"), *s = nb_unit(model->scene, " s");
  if (model->cycle == 0)
    return nb_error_set(error, NB_BROKEN,
                        "particle %d (line %d) has its centre on wall `%s` (line %d), so the particle is on neither "
                        "side of the wall: move the particle",
                        number, scene->particles[number - 1].line, scene->walls[w].name, scene->walls[w].line);
  return nb_error_set(
      error, NB_BROKEN,
      "particle %d (line %d) passed through wall `%s` (line %d) in cycle %lu, at time %g%s: its centre is now on the "
      "other side. The limit of the overlap with a wall is the particle's radius, %g%s; in this step of %g%s it moved "
      "%g%s relative to the wall: try %s",
      number, scene->particles[number - 1].line, scene->walls[w].name, scene->walls[w].line, model->cycle, model->time,
      s, radius, m, model->previous_step, s, displacement, m,
      displacement > radius / 2 ? "a smaller step" : "a stiffer wall, or a smaller load");
}

static enum nb_status check_crossing(const struct nb_model *model, size_t i, size_t w, struct nb_error *error) {
  double displacement;
  if (!may_cross(model, i, w) || !(model->particles.inverse_mass[i] > 0) || !crossed(model, i, w, &displacement))
    return NB_OK; /* fixed particles may pass through walls */
  return crossing_error(model, i, w, displacement, error);
}

enum nb_status nb_walls_crossed(const struct nb_model *model, bool all, struct nb_error *error) {
  const struct nb_contacts *contacts = &model->contacts;
  enum nb_status status = NB_OK;
  if (all)
    for (size_t k = 0; k < model->particles.count && !status; k++)
      for (size_t w = 0; w < model->walls.count && !status; w++)
        status = nb_wall_removed(&model->walls, w) /* no listed pair has a removed wall */
                     ? NB_OK
                     : check_crossing(model, (size_t)model->particles.slot[k], w, error);
  else
    for (size_t c = model->contacts.wall_from; c < contacts->count && !status; c++)
      status = check_crossing(model, (size_t)contacts->a[c], (size_t)contacts->b[c], error);
  return status;
}
