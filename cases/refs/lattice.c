/* Builds the network of springs of a scene: its contacts, and the matrices that give overlap and slip (lattice.h).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "lattice.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/vec.h"

/* The largest ratio of gap to radius at which two particles count as touching: pages round coordinates. */
static const double touch = 1e-9;

/* The unit vector from a particle to the nearest point of a wall, and the gap between them. */
static struct nb_vec direction_to_wall(const struct nb_particle *particle, const struct nb_wall *wall, double *gap) {
  struct nb_vec e = vec(wall->ex, wall->ey), left = vec(-wall->ey, wall->ex);
  struct nb_vec p = vec_sub(vec(particle->x - wall->x, particle->y - wall->y), vec_scale(wall->h0, left));
  double along = fmin(fmax(vec_dot(p, e), wall->h1), wall->h2);
  struct nb_vec d = vec_sub(vec_scale(along, e), p);
  double length = vec_length(d);
  *gap = length - particle->radius;
  return vec_scale(1 / length, d);
}

static struct matter_pair springs_of(const struct nb_scene *scene, int material_a, int material_b) {
  struct matter_pair pair = matter_pair(scene, material_a, material_b);
  if (!strcmp(scene->shear, "none") || (pair.friction == 0 && pair.cohesion == 0))
    pair.ks = 0;
  return pair;
}

enum contact_state { OPEN, CLOSED, MAY_CLOSE };

/* MAY_CLOSE: the gap may close in the run, or is an overlap. All arguments are in m. */
static enum contact_state contact_state(double gap, double radius, double largest_travel) {
  if (fabs(gap) <= touch * radius)
    return CLOSED;
  return gap > 2 * largest_travel ? OPEN : MAY_CLOSE;
}

/* The potential contact of particle a with b, which is a wall if `wall` is true, otherwise a particle. *gap: the gap
 * between them. */
static struct lattice_contact contact_between(const struct nb_scene *scene, int a, int b, bool wall, double *gap) {
  const struct nb_particle *particle = &scene->particles[a];
  struct nb_vec e;
  int other;
  if (wall) {
    e = direction_to_wall(particle, &scene->walls[b], gap);
    other = scene->walls[b].material;
  } else {
    struct nb_vec d = vec(scene->particles[b].x - particle->x, scene->particles[b].y - particle->y);
    double distance = vec_length(d);
    e = vec_scale(1 / distance, d);
    *gap = distance - particle->radius - scene->particles[b].radius;
    other = scene->particles[b].material;
  }
  return (struct lattice_contact){
      .a = a, .b = b, .wall = wall, .ex = e.x, .ey = e.y, .pair = springs_of(scene, particle->material, other)};
}

static enum nb_status add_contact(struct lattice *lattice, const struct nb_scene *scene, int a, int b, bool wall,
                                  struct nb_error *error) {
  double gap;
  struct lattice_contact contact = contact_between(scene, a, b, wall, &gap);
  enum contact_state state = contact_state(gap, scene->particles[a].radius, lattice->largest_travel);
  if (state == OPEN)
    return NB_OK;
  if (state == MAY_CLOSE)
    return nb_error_set(
        error, NB_BAD_USE,
        "this reference is for particles that just touch: the gap between particle %d and %s %d is %g m; "
        "it must be 0, or "
        "more than twice the displacement of the walls",
        a + 1, wall ? "wall" : "particle", b + 1, gap);
  lattice->contacts[lattice->contact_count++] = contact;
  return NB_OK;
}

static enum nb_status find_contacts(struct lattice *lattice, const struct nb_scene *scene, struct nb_error *error) {
  size_t most = scene->particle_count * (scene->particle_count + scene->wall_count);
  lattice->contacts = calloc(most + 1, sizeof *lattice->contacts);
  if (!lattice->contacts)
    return nb_error_memory(error);
  enum nb_status status = NB_OK;
  for (size_t a = 0; a < scene->particle_count; a++) {
    for (size_t b = a + 1; b < scene->particle_count && status == NB_OK; b++)
      status = add_contact(lattice, scene, (int)a, (int)b, false, error);
    for (size_t b = 0; b < scene->wall_count && status == NB_OK; b++)
      status = add_contact(lattice, scene, (int)a, (int)b, true, error);
  }
  if (status == NB_OK && lattice->contact_count == 0)
    return nb_error_set(error, NB_BAD_USE, "this reference is for particles in contact; there are no contacts");
  return status;
}

/* Sets the elements of `stretch` that give overlap and slip of contact c from x, y, theta of the particle `index` [CS79
 * 12, 13]. The sign is 1 if the particle is a of the contact, -1 if it is b. */
static void fill_stretch(struct lattice *lattice, const struct nb_scene *scene, size_t c, int index, double sign) {
  const struct nb_particle *particle = &scene->particles[index];
  if (particle->fixed)
    return;
  const struct lattice_contact *contact = &lattice->contacts[c];
  struct nb_vec e = vec(contact->ex, contact->ey), t = vec_clockwise(e);
  double root_m = sqrt(matter_mass(scene, particle)), root_i = sqrt(matter_inertia(scene, particle));
  size_t x = 3 * (size_t)index;
  gsl_matrix_set(lattice->stretch, 2 * c, x, sign * e.x / root_m);
  gsl_matrix_set(lattice->stretch, 2 * c, x + 1, sign * e.y / root_m);
  gsl_matrix_set(lattice->stretch, 2 * c + 1, x, sign * t.x / root_m);
  gsl_matrix_set(lattice->stretch, 2 * c + 1, x + 1, sign * t.y / root_m);
  gsl_matrix_set(lattice->stretch, 2 * c + 1, x + 2, -particle->radius / root_i);
}

static void fill_wall_stretch(struct lattice *lattice, const struct nb_scene *scene, size_t c) {
  const struct lattice_contact *contact = &lattice->contacts[c];
  const struct nb_wall *wall = &scene->walls[contact->b];
  const struct nb_particle *particle = &scene->particles[contact->a];
  struct nb_vec e = vec(contact->ex, contact->ey), t = vec_clockwise(e);
  struct nb_vec arm =
      vec(particle->x + particle->radius * e.x - wall->x, particle->y + particle->radius * e.y - wall->y);
  struct nb_vec turn = vec(-arm.y, arm.x);
  size_t x = LATTICE_WALL * (size_t)contact->b;
  gsl_matrix_set(lattice->wall_stretch, 2 * c, x, -e.x);
  gsl_matrix_set(lattice->wall_stretch, 2 * c, x + 1, -e.y);
  gsl_matrix_set(lattice->wall_stretch, 2 * c + 1, x, -t.x);
  gsl_matrix_set(lattice->wall_stretch, 2 * c + 1, x + 1, -t.y);
  gsl_matrix_set(lattice->wall_stretch, 2 * c, x + 2, -vec_dot(turn, e));
  gsl_matrix_set(lattice->wall_stretch, 2 * c + 1, x + 2, -vec_dot(turn, t));
}

/* Sets the matrices and the stiffnesses from the contacts. */
static void fill_matrices(struct lattice *lattice, const struct nb_scene *scene) {
  lattice->stretch = gsl_matrix_calloc(2 * lattice->contact_count, lattice->freedom_count);
  if (scene->wall_count > 0)
    lattice->wall_stretch = gsl_matrix_calloc(2 * lattice->contact_count, LATTICE_WALL * scene->wall_count);
  lattice->springs = gsl_vector_calloc(2 * lattice->contact_count);
  for (size_t c = 0; c < lattice->contact_count; c++) {
    const struct lattice_contact *contact = &lattice->contacts[c];
    fill_stretch(lattice, scene, c, contact->a, 1);
    if (contact->wall)
      fill_wall_stretch(lattice, scene, c);
    else
      fill_stretch(lattice, scene, c, contact->b, -1);
    gsl_vector_set(lattice->springs, 2 * c, contact->pair.kn);
    gsl_vector_set(lattice->springs, 2 * c + 1, contact->pair.ks);
  }
}

/* The matrices are dense: 1000 particles take several 100 MB and minutes. */
static enum nb_status check_size(const struct nb_scene *scene, struct nb_error *error) {
  enum { MOST = 1000 };
  return scene->particle_count <= MOST
             ? NB_OK
             : nb_error_set(error, NB_BAD_USE, "this reference is for up to %d particles, not for %zu", MOST,
                            scene->particle_count);
}

enum nb_status lattice_build(struct lattice *lattice, const struct nb_scene *scene, struct nb_error *error) {
  *lattice = (struct lattice){.freedom_count = 3 * scene->particle_count};
  enum nb_status status = check_size(scene, error);
  if (status == NB_OK)
    status = lattice_read_walls(lattice, scene, error);
  if (status == NB_OK)
    status = find_contacts(lattice, scene, error);
  if (status != NB_OK) {
    lattice_free(lattice);
    return status;
  }
  fill_matrices(lattice, scene);
  return NB_OK;
}

enum nb_status lattice_build_pairs(struct lattice *lattice, const struct nb_scene *scene, double largest_gap,
                                   struct nb_error *error) {
  size_t n = scene->particle_count, most = n * (n + scene->wall_count);
  *lattice = (struct lattice){.freedom_count = 3 * n};
  if (check_size(scene, error))
    return error->status;
  lattice->contacts = calloc(most + 1, sizeof *lattice->contacts);
  if (!lattice->contacts)
    return nb_error_memory(error);
  for (size_t a = 0; a < n; a++)
    for (size_t b = a + 1; b < n + scene->wall_count; b++) {
      bool wall = b >= n;
      double gap;
      struct lattice_contact contact = contact_between(scene, (int)a, (int)(wall ? b - n : b), wall, &gap);
      bool fixed = scene->particles[a].fixed && (wall || scene->particles[b].fixed);
      if (gap < largest_gap && !fixed)
        lattice->contacts[lattice->contact_count++] = contact;
    }
  if (lattice->contact_count == 0) {
    lattice_free(lattice);
    return nb_error_set(error, NB_BAD_USE, "this reference is for particles in contact; there are no contacts");
  }
  fill_matrices(lattice, scene);
  return NB_OK;
}

int lattice_contact_of(const struct lattice *lattice, const struct nb_monitor *monitor) {
  if (monitor->kind != NB_MONITOR_PARTICLE_PARTICLE && monitor->kind != NB_MONITOR_PARTICLE_WALL)
    return -1;
  bool wall = monitor->kind == NB_MONITOR_PARTICLE_WALL;
  for (size_t c = 0; c < lattice->contact_count; c++) {
    const struct lattice_contact *contact = &lattice->contacts[c];
    if (contact->wall != wall)
      continue;
    if (contact->a == monitor->a && contact->b == monitor->b)
      return (int)c;
    if (!wall && contact->a == monitor->b && contact->b == monitor->a)
      return (int)c;
  }
  return -1;
}

void lattice_free(struct lattice *lattice) {
  for (size_t i = 0; i < lattice->change_count; i++)
    gsl_vector_free(lattice->changes[i].change);
  for (size_t i = 0; i < lattice->stage_count; i++)
    gsl_vector_free(lattice->travel[i]);
  free(lattice->changes);
  free(lattice->travel);
  free(lattice->contacts);
  gsl_matrix_free(lattice->stretch);
  gsl_matrix_free(lattice->wall_stretch);
  gsl_vector_free(lattice->springs);
  *lattice = (struct lattice){0};
}
