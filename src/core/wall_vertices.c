/* A single contact at a vertex, the common end of two walls.
 *
 * A disc that rolls from one wall onto the next is near both walls at the vertex E. The nearest point of the first wall
 * is E; the nearest point of the second wall is E or a point inside that wall. Two contacts would push the disc twice.
 * Therefore
 *
 *   a contact at E is suppressed (counts as not touching) when the nearest point of the other wall is inside that wall;
 *   of two contacts at E, the contact with the wall that the page defines first is kept.
 *
 * A disc pressed into a corner touches points inside both walls and keeps two contacts. When a disc passes from one
 * wall to the other, the contact that becomes suppressed passes its history to the one that becomes active. So neither
 * the normal nor the shear force jumps at a vertex of a straight line or at an outer corner.
 *
 * Two ends form a vertex for a disc while their distance is at most `coincidence_limit` times its radius, plus the
 * rounding error of the coordinates. Two ends that are farther apart at time 0 never form a vertex.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <float.h>
#include <stdlib.h>

#include "model.h"

enum { NOW = 1, BEFORE = 2 }; /* bits of `suppressed`: now, and in the previous force calculation */

/* Ends closer than this fraction of the disc's radius form a vertex. The error of an overlap is then at most this
 * fraction of the radius. */
static const double coincidence_limit = 1e-9;

static double coincidence_distance(struct nb_vec end, double radius) {
  return coincidence_limit * radius + 8 * DBL_EPSILON * (fabs(end.x) + fabs(end.y));
}

static bool coincident(struct nb_vec one, struct nb_vec other, double radius) {
  return vec_length(vec_sub(one, other)) <= coincidence_distance(one, radius);
}

static struct nb_vec initial_end(const struct nb_wall *wall, int end) {
  const double h = end ? wall->h2 : wall->h1;
  return vec(wall->x + h * wall->ex - wall->h0 * wall->ey, wall->y + h * wall->ey + wall->h0 * wall->ex);
}

bool nb_vertices_exist(const struct nb_scene *scene) {
  double largest = 0;
  for (size_t k = 0; k < scene->particle_count; k++)
    largest = scene->particles[k].radius > largest ? scene->particles[k].radius : largest;
  for (size_t v = 0; v < scene->wall_count; v++)
    for (size_t w = v + 1; w < scene->wall_count; w++)
      for (int ends = 0; ends < 4; ends++)
        if (coincident(initial_end(&scene->walls[v], ends & 1), initial_end(&scene->walls[w], ends >> 1), largest))
          return true;
  return false;
}

/* ---- finding vertices ---- */

/* Adds the vertices that a particle may touch before the next search; c and d are its contacts with two walls. False:
 * out of memory. */
static bool find_vertices(struct nb_model *model, int c, int d) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_wall *first = &model->scene->walls[contacts->b[c]], *second = &model->scene->walls[contacts->b[d]];
  const int i = contacts->a[c];
  const double radius = model->particles.radius[i];
  for (int ends = 0; ends < 4; ends++) {
    const struct nb_vec end = nb_wall_end(&model->walls, contacts->b[c], ends & 1);
    const double distance = vec_length(vec_sub(end, model->particles.position[i]));
    if (!coincident(initial_end(first, ends & 1), initial_end(second, ends >> 1), radius) ||
        !(distance < radius + model->search.skin))
      continue;
    struct nb_vertex *vertex = NB_ARRAY_APPEND(model->vertices.list, model->vertices.count);
    if (!vertex)
      return false;
    *vertex = (struct nb_vertex){c, d, ends & 1, ends >> 1};
  }
  return true;
}

/* Makes the contacts without a vertex active. Contacts at a vertex keep their state. The bit BEFORE serves as their
 * mark here. */
static void reset_other_contacts(struct nb_model *model) {
  int *suppressed = model->contacts.suppressed;
  for (size_t c = model->contacts.wall_from; c < model->contacts.count; c++)
    suppressed[c] &= NOW;
  for (size_t j = 0; j < model->vertices.count; j++)
    suppressed[model->vertices.list[j].c] |= BEFORE, suppressed[model->vertices.list[j].d] |= BEFORE;
  for (size_t c = model->contacts.wall_from; c < model->contacts.count; c++)
    suppressed[c] = suppressed[c] & BEFORE ? suppressed[c] & NOW : 0;
}

bool nb_vertices_find(struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  model->vertices.count = 0;
  if (!contacts->suppressed)
    return true;
  for (size_t c = model->contacts.wall_from; c < contacts->count; c++) {
    const struct nb_contact_range own = nb_contact_range(&model->contacts.incidence, (size_t)contacts->a[c]);
    for (const int *d = own.middle; d < own.end; d++) /* walls in the order of the page */
      if (*d >= (int)model->contacts.wall_from && contacts->b[*d] > contacts->b[c] && !find_vertices(model, (int)c, *d))
        return false;
  }
  reset_other_contacts(model);
  return true;
}

/* ---- suppressing contacts ---- */

/* True if the wall's point nearest to the particle is its end number `end`. */
static bool nearest_is_end(const struct nb_model *model, int contact, int end) {
  const struct nb_walls *walls = &model->walls;
  const int i = model->contacts.a[contact], w = model->contacts.b[contact];
  const struct nb_vec x = model->particles.position[i];
  const double s = vec_dot(vec_sub(x, walls->point[w]), walls->along[w]);
  const double tolerance = coincidence_distance(x, model->particles.radius[i]);
  return end ? s >= walls->h2[w] - tolerance : s <= walls->h1[w] + tolerance;
}

/* Returns the contact at the vertex that is to be suppressed; -1: neither. */
static int suppressed_contact(const struct nb_model *model, const struct nb_vertex *vertex) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_vec one = nb_wall_end(&model->walls, contacts->b[vertex->c], vertex->at_c);
  const struct nb_vec other = nb_wall_end(&model->walls, contacts->b[vertex->d], vertex->at_d);
  if (!coincident(one, other, model->particles.radius[contacts->a[vertex->c]]))
    return -1; /* the walls have separated */
  if (nearest_is_end(model, vertex->d, vertex->at_d))
    return vertex->d; /* the contact with the first wall, at E or inside it, is kept */
  return nearest_is_end(model, vertex->c, vertex->at_c) ? vertex->c : -1;
}

static void transfer_history(struct nb_contacts *contacts, int from, int to) {
  nb_history_copy(&contacts->normal_history, (size_t)to, &contacts->normal_history, (size_t)from);
  nb_history_copy(&contacts->shear_history, (size_t)to, &contacts->shear_history, (size_t)from);
}

void nb_vertices_suppress(struct nb_model *model) {
  struct nb_contacts *contacts = &model->contacts;
  int *suppressed = contacts->suppressed;
  for (size_t c = model->contacts.wall_from; c < contacts->count; c++)
    suppressed[c] = suppressed[c] & NOW ? BEFORE : 0;
  for (size_t j = 0; j < model->vertices.count; j++) {
    const int c = suppressed_contact(model, &model->vertices.list[j]);
    if (c >= 0)
      suppressed[c] |= NOW;
  }
  for (size_t j = 0; j < model->vertices.count; j++) {
    const int c = model->vertices.list[j].c, d = model->vertices.list[j].d;
    if (suppressed[c] == NOW && suppressed[d] == BEFORE)
      transfer_history(contacts, c, d);
    if (suppressed[d] == NOW && suppressed[c] == BEFORE)
      transfer_history(contacts, d, c);
  }
}
