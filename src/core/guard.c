/* Guards: conditions that a run must satisfy. If one of them is violated, the run stops, because particles could then
 * pass through each other, or through walls, without a force.
 *
 *   displacement  no particle moves by more than its radius in one step
 *   overlap       no two particles overlap by more than the smaller radius: their distance d is at least max(R_i, R_j)
 *   rotation      no wall rotates so far in one step that the arc of its far end departs from the chord by more than
 *                 the smallest radius r: angle^2 h/8 <= r, where h is the larger of r and the bound
 *                 |h0| + max(|h1|, |h2|) of the distance from the centre of rotation to the far end (walls.h)
 *   translation   no wall moves by more than 1e9 r in one step: its place before the step, which walls.c computes from
 *                 its place after it, then has an error of at most 1e9 r 2^-52 < 1e-6 r
 *   strain        no periodic cell is strained by more than ||L|| dt = 1/2 in one step: the strain then moves two
 *                 touching particles of radius R by at most R relative to each other, and the cell cannot invert
 *
 * The first two guards prevent two particles from passing through each other. A step begins with a distance d >=
 * max(R_i, R_j), and the two particles approach by at most R_i + R_j. If one passed through the other, their distance
 * is then at most R_i + R_j - d <= min(R_i, R_j). Such an overlap is too large, and the run stops. For walls, walls.c
 * tests whether a particle's centre crossed one. It compares the sides of the wall on which the centre is at the
 * beginning and at the end of the step. This is valid while the wall rotates by less than pi per step; the guard allows
 * at most 8^(1/2) rad.
 *
 * The guards cost almost nothing in a safe run. The motion reports the particles that have moved by more than half the
 * skin since the last search. As long as no radius is smaller than the skin, these include all particles that moved by
 * more than their radius in one step. So the displacements of a step are tested only at a search. If the skin is wider
 * than the smallest radius, they are tested in every cycle. A search computes the distances of all neighbours, and two
 * particles approach by at most the skin before the next search. So the overlaps of listed pairs are tested in every
 * cycle only if the last search found a pair whose overlap was less than the skin below its limit.
 *
 * An overlap is a difference of positions, and each coordinate is rounded to a multiple of its ulp, which grows with
 * the distance from the origin. The program warns when the ulp exceeds a thousandth of the mean overlap, because the
 * error of the forces may then exceed about 0.1 %. Overlaps below 1e-9 of a radius come from rounding and do not count.
 * Without any contact, a thousandth of the smallest radius is used as the expected overlap.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "model.h"

static int line_of(const struct nb_model *model, int number) { return model->scene->particles[number - 1].line; }

/* Displacement of the particle in slot i in the last step, m; without the affine motion of a cell, because that also
 * moves the images. */
static double displacement_of(const struct nb_model *model, int i) {
  const struct nb_vec v = model->particles.velocity[i];
  return model->previous_step * vec_length(model->cell ? vec_sub(v, model->particles.imposed[i]) : v);
}

enum nb_status nb_guard_positions(const struct nb_model *model, struct nb_error *error) {
  for (size_t k = 0; k < model->particles.count; k++) {
    const struct nb_vec x = model->particles.position[model->particles.slot[k]];
    const char *s = nb_unit(model->scene, " s");
    if (!(x.x - x.x == 0 && x.y - x.y == 0)) /* x - x is NaN if x is NaN or infinite */
      return nb_error_set(error, NB_BROKEN,
                          "particle %zu (line %d): its position is NaN or infinite after cycle %lu, at time %g%s; the "
                          "step is %g%s, the single-contact step is %g%s: try a smaller step",
                          k + 1, line_of(model, (int)k + 1), model->cycle, model->time, s, model->step, s,
                          model->critical, s);
  }
  return NB_OK;
}

static enum nb_status check_displacement(const struct nb_model *model, int i, struct nb_error *error) {
  const int number = model->particles.number[i];
  const double displacement = displacement_of(model, i), radius = model->particles.radius[i];
  if (!(displacement > radius))
    return NB_OK;
  const char *m = nb_unit(model->scene, " m"), *s = nb_unit(model->scene, " s");
  return nb_error_set(
      error, NB_BROKEN,
      "particle %d (line %d): in cycle %lu, at time %g%s, it moved by %g%s in one step of %g%s. The "
      "limit is its radius, %g%s: beyond this limit it may pass through other particles. Try a smaller step",
      number, line_of(model, number), model->cycle, model->time, s, displacement, m, model->previous_step, s, radius,
      m);
}

static enum nb_status check_rotation(const struct nb_model *model, size_t w, struct nb_error *error) {
  const double angle = model->walls.spin[w] * model->previous_step;
  if (!nb_rotates_too_far(model, w, angle))
    return NB_OK;
  const char *m = nb_unit(model->scene, " m"), *s = nb_unit(model->scene, " s");
  return nb_error_set(error, NB_BROKEN,
                      "wall `%s` (line %d): in cycle %lu, at time %g%s, it turned by %g rad in one step of %g%s and "
                      "may have passed through a particle. The limit is the smallest radius, %g%s: the arc of the "
                      "wall's far end may deviate from its chord by at most this much. Try a smaller step",
                      model->scene->walls[w].name, model->scene->walls[w].line, model->cycle, model->time, s, angle,
                      model->previous_step, s, model->search.smallest_radius, m);
}

/* Largest displacement of a wall in one step, in smallest radii, and largest strain of a cell in one step. */
static const double largest_translation = 1e9, largest_strain = 0.5;

static enum nb_status check_translation(const struct nb_model *model, size_t w, struct nb_error *error) {
  const double displacement = vec_length(model->walls.velocity[w]) * model->previous_step;
  if (!(displacement > largest_translation * model->search.smallest_radius))
    return NB_OK;
  const char *m = nb_unit(model->scene, " m"), *s = nb_unit(model->scene, " s");
  return nb_error_set(error, NB_BROKEN,
                      "wall `%s` (line %d): in cycle %lu, at time %g%s, it moved by %g%s in one step of %g%s and may "
                      "have passed through a particle. The limit is %g times the smallest radius, %g%s. Try a smaller "
                      "step or a lower velocity",
                      model->scene->walls[w].name, model->scene->walls[w].line, model->cycle, model->time, s,
                      displacement, m, model->previous_step, s, largest_translation, model->search.smallest_radius, m);
}

static enum nb_status check_cell(const struct nb_model *model, struct nb_error *error) {
  if (!model->cell || !(model->cell->strain > largest_strain))
    return NB_OK;
  const char *s = nb_unit(model->scene, " s");
  return nb_error_set(
      error, NB_BROKEN,
      "the periodic cell (line %d): in cycle %lu, at time %g%s, it was strained by %g %% in one step of "
      "%g%s. The limit is %g %%: beyond this limit particles may pass through each other. Try a smaller "
      "step or a lower strain rate",
      model->scene->cell.line, model->cycle, model->time, s, 100 * model->cell->strain, model->previous_step, s,
      100 * largest_strain);
}

enum nb_status nb_guard_motion(const struct nb_model *model, struct nb_error *error) {
  if (!(model->search.skin < INFINITY))
    return NB_OK; /* no particle can touch anything */
  enum nb_status status = check_cell(model, error);
  for (size_t k = 0; k < model->particles.count && !status; k++)
    status = check_displacement(model, model->particles.slot[k], error);
  for (size_t w = 0; w < model->walls.count && !status; w++)
    if (!(status = check_translation(model, w, error)))
      status = check_rotation(model, w, error);
  return status;
}

enum nb_status nb_guard_pair(const struct nb_model *model, struct nb_close_pair pair, struct nb_error *error) {
  const struct nb_particles *particles = &model->particles;
  const double radius = fmin(particles->radius[pair.a], particles->radius[pair.b]);
  if (!(pair.overlap > radius))
    return NB_OK;
  const int a = particles->number[pair.a], b = particles->number[pair.b];
  const char *m = nb_unit(model->scene, " m"), *s = nb_unit(model->scene, " s");
  if (model->cycle == 0) {
    nb_error_set(error, NB_BAD_USE,
                 "particle %d overlaps particle %d (line %d) by %g%s. Expected at most the smaller radius, %g%s: move "
                 "the particles apart, or make them smaller",
                 b, a, line_of(model, a), pair.overlap, m, radius, m);
    error->line = line_of(model, b);
    return NB_BAD_USE;
  }
  return nb_error_set(
      error, NB_BROKEN,
      "particle %d (line %d) and particle %d (line %d): at cycle %lu, time %g%s, they overlap by %g%s. "
      "The limit is the smaller radius, %g%s: beyond this limit the particles pass through each other. Try a smaller "
      "step, a stiffer contact, or a smaller load",
      a, line_of(model, a), b, line_of(model, b), model->cycle, model->time, s, pair.overlap, m, radius, m);
}

static enum nb_status check_pairs(const struct nb_model *model, struct nb_error *error) {
  const struct nb_contacts *contacts = &model->contacts;
  enum nb_status status = NB_OK;
  for (size_t c = 0; c < contacts->wall_from && !status; c++)
    status = nb_guard_pair(model, (struct nb_close_pair){contacts->a[c], contacts->b[c], nb_overlap(model, c)}, error);
  return status;
}

enum nb_status nb_guard_cycle(const struct nb_model *model, struct nb_error *error) {
  if (model->search.check_walls && nb_walls_crossed(model, false, error))
    return error->status;
  if (model->search.skin > model->search.smallest_radius && nb_guard_motion(model, error))
    return error->status;
  return model->search.check_pairs ? check_pairs(model, error) : NB_OK;
}

static double coordinate(const struct nb_model *model, int i) {
  const struct nb_vec x = model->particles.position[i];
  return fmax(fabs(x.x), fabs(x.y));
}

static double ulp(double x) { return nextafter(x, INFINITY) - x; }

/* Largest ratio of the ulp of a coordinate to the mean overlap without a warning. At this ratio the error of the forces
 * is about 0.1 %. */
static const double resolution_limit = 1e-3;
/* An overlap of at most this fraction of the radius counts as a rounding error. */
static const double touch_limit = 1e-9;

void nb_guard_resolution(struct nb_model *model) {
  const struct nb_particles *particles = &model->particles;
  int farthest = 0, pressed = -1;
  for (int i = 0; i < (int)particles->count; i++)
    farthest = coordinate(model, i) > coordinate(model, farthest) ? i : farthest;
  if (model->search.coarse_warned || !(model->search.skin < INFINITY) ||
      ulp(coordinate(model, farthest)) <= resolution_limit * touch_limit * model->search.smallest_radius)
    return;
  double sum = 0, count = 0;
  for (size_t c = 0; c < model->contacts.count; c++) {
    const int i = model->contacts.a[c];
    const double overlap = nb_overlap(model, c);
    if (!(overlap > touch_limit * particles->radius[i]))
      continue;
    sum += overlap, count++;
    pressed = pressed < 0 || coordinate(model, i) > coordinate(model, pressed) ? i : pressed;
  }
  const int i = count > 0 ? pressed : farthest;
  const double overlap = count > 0 ? sum / count : model->search.smallest_radius / 1000, x = coordinate(model, i);
  model->search.coarse_warned = ulp(x) > resolution_limit * overlap;
  if (!model->search.coarse_warned)
    return;
  const char *m = nb_unit(model->scene, " m");
  nb_warn(&model->warnings, line_of(model, particles->number[i]),
          "particle %d: its coordinate %g%s has a resolution (ulp) of %g%s, that is %.2g %% of %s, %g%s, at cycle "
          "%lu. The relative error of the forces is of this size (limit: 0.1 %%): put the scene nearer to the origin",
          particles->number[i], x, m, ulp(x), m, 100 * ulp(x) / overlap,
          count > 0 ? "the mean overlap of all contacts" : "the expected overlap, a thousandth of the smallest radius",
          overlap, m, model->cycle);
}
