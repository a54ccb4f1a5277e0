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
 * Two ends are a common one while they are closer than `common_end` and what rounding adds far from the origin. Ends that are apart at time 0 are never taken as one.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <float.h>
#include <stdlib.h>

#include "model.h"

enum { NOW = 1, BEFORE = 2 }; /* bits of what is muted: in these forces, and in the ones before */

/* Two ends nearer than this share of the disc's radius, 1, are one: the largest error that this makes in an overlap. */
static const double common_end = 1e-9;

static double close_by(struct nb_vec end, double radius) {
  return common_end * radius + 8 * DBL_EPSILON * (fabs(end.x) + fabs(end.y));
}

static bool common(struct nb_vec one, struct nb_vec other, double radius) {
  return vec_length(vec_sub(one, other)) <= close_by(one, radius);
}

static struct nb_vec end_of(const struct nb_wall *wall, int end) {
  const double h = end ? wall->h2 : wall->h1;
  return vec(wall->x + h * wall->ex - wall->h0 * wall->ey, wall->y + h * wall->ey + wall->h0 * wall->ex);
}

bool nb_joints_meet(const struct nb_scene *scene) {
  double largest = 0;
  for (size_t k = 0; k < scene->body_count; k++)
    largest = scene->bodies[k].radius > largest ? scene->bodies[k].radius : largest;
  for (size_t v = 0; v < scene->wall_count; v++)
    for (size_t w = v + 1; w < scene->wall_count; w++)
      for (int ends = 0; ends < 4; ends++)
        if (common(end_of(&scene->walls[v], ends & 1), end_of(&scene->walls[w], ends >> 1), largest))
          return true;
  return false;
}

/* ---- which there are ---- */

/* Contacts c and d of one body: do their walls meet where it may touch before the next search? */
static bool find_between(struct nb_model *model, int c, int d) {
  const struct nb_contacts *contacts = &model->contacts;
  const int i = contacts->a[c];
  const double radius = model->bodies.rim[i].x;
  for (int ends = 0; ends < 4; ends++) {
    const struct nb_vec one = nb_wall_end(&model->walls, contacts->b[c], ends & 1);
    const struct nb_vec other = nb_wall_end(&model->walls, contacts->b[d], ends >> 1);
    const double away = vec_length(vec_sub(one, model->bodies.position[i]));
    if (!common(one, other, radius) || !(away < radius + model->search.skin))
      continue;
    struct nb_joint *joint = NB_MORE(model->joints.list, model->joints.count);
    if (!joint)
      return false;
    *joint = (struct nb_joint){c, d, ends & 1, ends >> 1};
  }
  return true;
}

/* Contacts that meet no other are heard; those that do go on as before. */
static void let_others_be_heard(struct nb_model *model) {
  int *muted = model->contacts.muted;
  for (size_t c = model->contacts.wall_from; c < model->contacts.count; c++)
    muted[c] &= NOW;
  for (size_t j = 0; j < model->joints.count; j++)
    muted[model->joints.list[j].c] |= BEFORE, muted[model->joints.list[j].d] |= BEFORE;
  for (size_t c = model->contacts.wall_from; c < model->contacts.count; c++)
    muted[c] = muted[c] & BEFORE ? muted[c] & NOW : 0;
}

bool nb_joints_find(struct nb_model *model) {
  const struct nb_contacts *contacts = &model->contacts;
  model->joints.count = 0;
  if (!contacts->muted)
    return true;
  for (size_t c = model->contacts.wall_from; c < contacts->count; c++) {
    const struct nb_contacts_of its = nb_contacts_of(&model->contacts.of, (size_t)contacts->a[c]);
    for (const int *d = its.middle; d < its.end; d++) /* walls in the order of the page */
      if (*d >= (int)model->contacts.wall_from && contacts->b[*d] > contacts->b[c] && !find_between(model, (int)c, *d))
        return false;
  }
  let_others_be_heard(model);
  return true;
}

/* ---- what they do ---- */

/* Whether the point of the wall that is nearest to the body is that end. */
static bool stands_at(const struct nb_model *model, int contact, int end) {
  const struct nb_walls *walls = &model->walls;
  const int i = model->contacts.a[contact], w = model->contacts.b[contact];
  const struct nb_vec x = model->bodies.position[i];
  const double s = vec_dot(vec_sub(x, walls->point[w]), walls->along[w]);
  const double slack = close_by(x, model->bodies.rim[i].x);
  return end ? s >= walls->h2[w] - slack : s <= walls->h1[w] + slack;
}

/* The contact that is muted; -1: neither. */
static int silent(const struct nb_model *model, const struct nb_joint *joint) {
  const struct nb_contacts *contacts = &model->contacts;
  const struct nb_vec one = nb_wall_end(&model->walls, contacts->b[joint->c], joint->at_c);
  const struct nb_vec other = nb_wall_end(&model->walls, contacts->b[joint->d], joint->at_d);
  if (!common(one, other, model->bodies.rim[contacts->a[joint->c]].x))
    return -1; /* the walls have parted */
  if (stands_at(model, joint->d, joint->at_d))
    return joint->d; /* there is nothing that the first wall's contact does not say, at E or before its inside */
  return stands_at(model, joint->c, joint->at_c) ? joint->c : -1;
}

static void hand_over(struct nb_contacts *contacts, int from, int to) {
  nb_memory_copy(&contacts->normal_memory, (size_t)to, &contacts->normal_memory, (size_t)from);
  nb_memory_copy(&contacts->shear_memory, (size_t)to, &contacts->shear_memory, (size_t)from);
}

void nb_joints_settle(struct nb_model *model) {
  struct nb_contacts *contacts = &model->contacts;
  int *muted = contacts->muted;
  for (size_t c = model->contacts.wall_from; c < contacts->count; c++)
    muted[c] = muted[c] & NOW ? BEFORE : 0;
  for (size_t j = 0; j < model->joints.count; j++) {
    const int c = silent(model, &model->joints.list[j]);
    if (c >= 0)
      muted[c] |= NOW;
  }
  for (size_t j = 0; j < model->joints.count; j++) {
    const int c = model->joints.list[j].c, d = model->joints.list[j].d;
    if (muted[c] == NOW && muted[d] == BEFORE)
      hand_over(contacts, c, d);
    if (muted[d] == NOW && muted[c] == BEFORE)
      hand_over(contacts, d, c);
  }
}
