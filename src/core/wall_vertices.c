/* One contact at a common end of two walls.
 *
 * A disc that rolls from one wall on to the next passes their common end E. There both walls are near: on one the nearest
 * point is E, on the other E or a point inside. Counted twice, the disc would be pushed twice. So, of two walls that meet,
 *
 *   a contact at E is muted (it counts as not touching) when the disc stands before the inside of the other wall,
 *   and of two contacts at E that of the wall which the page defines first stays.
 *
 * Two contacts before the insides of two walls, in a corner that a disc is pressed into, are two. Where a disc goes over from one
 * wall to the other, the contact that falls silent hands what its laws remember to the one that speaks up, so that neither
 * the normal nor the shear force jumps on a straight joint or around an outer corner.
 *
 * Two ends are a common one while they are closer than `coincidence_limit` and what rounding adds far from the origin. Ends that are apart at time 0 are never taken as one.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <float.h>
#include <stdlib.h>

#include "model.h"

enum { NOW = 1, BEFORE = 2 }; /* bits of what is muted: in these forces, and in the ones before */

/* Two ends nearer than this share of the disc's radius, 1, are one: the largest error that this makes in an overlap. */
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

/* ---- which there are ---- */

/* Contacts c and d of one body: do their walls meet where it may touch before the next search? */
static bool find_vertices(struct nb_model *model, int c, int d) {
  const struct nb_contacts *contacts = &model->contacts;
  const int i = contacts->a[c];
  const double radius = model->particles.surface[i].radius;
  for (int ends = 0; ends < 4; ends++) {
    const struct nb_vec one = nb_wall_end(&model->walls, contacts->b[c], ends & 1);
    const struct nb_vec other = nb_wall_end(&model->walls, contacts->b[d], ends >> 1);
    const double distance = vec_length(vec_sub(one, model->particles.position[i]));
    if (!coincident(one, other, radius) || !(distance < radius + model->search.skin))
      continue;
    struct nb_vertex *vertex = NB_ARRAY_APPEND(model->vertices.list, model->vertices.count);
    if (!vertex)
      return false;
    *vertex = (struct nb_vertex){c, d, ends & 1, ends >> 1};
  }
  return true;
}

/* Contacts that meet no other are heard; those that do go on as before. */
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
    const struct nb_contact_range own = nb_contact_range(&model->contacts.of, (size_t)contacts->a[c]);
    for (const int *d = own.middle; d < own.end; d++) /* walls in the order of the page */
      if (*d >= (int)model->contacts.wall_from && contacts->b[*d] > contacts->b[c] && !find_vertices(model, (int)c, *d))
        return false;
  }
  reset_other_contacts(model);
  return true;
}

/* ---- what they do ---- */

/* Whether the point of the wall that is nearest to the body is that end. */
static bool nearest_is_end(const struct nb_model *model, int contact, int end) {
  const struct nb_walls *walls = &model->walls;
  const int i = model->contacts.a[contact], w = model->contacts.b[contact];
  const struct nb_vec x = model->particles.position[i];
  const double s = vec_dot(vec_sub(x, walls->point[w]), walls->along[w]);
  const double tolerance = coincidence_distance(x, model->particles.surface[i].radius);
  return end ? s >= walls->h2[w] - tolerance : s <= walls->h1[w] + tolerance;
}

/* The contact that is muted; -1: neither. */
static int suppressed_contact(const struct nb_model *model, const struct nb_vertex *vertex) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_vec one = nb_wall_end(&model->walls, contacts->b[vertex->c], vertex->at_c);
  const struct nb_vec other = nb_wall_end(&model->walls, contacts->b[vertex->d], vertex->at_d);
  if (!coincident(one, other, model->particles.surface[contacts->a[vertex->c]].radius))
    return -1; /* the walls have parted */
  if (nearest_is_end(model, vertex->d, vertex->at_d))
    return vertex->d; /* there is nothing that the first wall's contact does not say, at E or before its inside */
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
