/* Reference: force chains of a zigzag of like discs between two walls, all links alike, and of discs that carry nothing.
 *
 * Each link makes the angle phi with the axis of the zigzag and carries F; each disc is held from aside by a wall with
 * 2 F sin phi. The stress of a disc is then, but for overlaps, F R over its volume times
 *
 *   along the axis    2 cos^2 phi                 across    2 sin^2 phi + 2 sin phi
 *
 * and the axis is the major one while cos 2 phi > sin phi, which is phi < 30 degrees. Then all contacts of discs are links, and
 * from one to the next the way turns by 2 phi. Beyond 30 degrees the discs carry more from wall to wall, no contact of two discs
 * lies within 45 degrees of that, and there is no chain. What presses the ends is fixed, and counts for nothing else.
 *
 * Known, of a region NAME that holds all: NAME.chains, NAME.chains.length, NAME.chains.fraction, NAME.chains.bend. Exact where
 * |phi - 30 degrees| is above the order of overlap over radius.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>

#include "reference.h"

static bool touch(const struct nb_body *a, const struct nb_body *b) {
  return hypot(a->x - b->x, a->y - b->y) < a->radius + b->radius;
}

/* The largest angle between the y axis and a link, rad; how many discs have links. All links must make it. */
static bool links_alike(const struct nb_scene *scene, double *phi, double *linked) {
  double least = INFINITY, most = 0;
  *linked = 0;
  for (size_t i = 0; i < scene->body_count; i++) {
    bool has = false;
    for (size_t j = 0; j < scene->body_count; j++) {
      const struct nb_body *a = &scene->bodies[i], *b = &scene->bodies[j];
      if (i == j || !touch(a, b))
        continue;
      const double angle = atan2(fabs(a->x - b->x), fabs(a->y - b->y));
      has = true, least = fmin(least, angle), most = fmax(most, angle);
    }
    *linked += has && !scene->bodies[i].fixed;
  }
  *phi = most;
  return *linked > 2 && most - least < 1e-9;
}

static void tell(struct nb_known *known, const char *region, const char *what, double value) {
  char name[3 * NB_NAME_SIZE];
  snprintf(name, sizeof name, "%s.%s", region, what);
  known_value(known, value, name);
}

static enum nb_status know(struct nb_known *known, const struct nb_scene *scene, struct nb_error *error) {
  double phi, linked;
  if (scene->region_count == 0 || !links_alike(scene, &phi, &linked))
    return nb_error_set(error, NB_BAD_USE,
                        "zigzag wants a region, and discs of which all that touch make one angle with y");
  double free_bodies = 0;
  for (size_t k = 0; k < scene->body_count; k++)
    free_bodies += !scene->bodies[k].fixed;
  const bool chain = cos(2 * phi) > sin(phi);
  for (size_t w = 0; w < scene->watch_count; w++) {
    const struct nb_watch *watch = &scene->watches[w];
    if (watch->kind != NB_WATCH_REGION || scene->regions[watch->a].kind != NB_REGION_ALL)
      continue;
    tell(known, watch->name, "chains", chain);
    tell(known, watch->name, "chains.length", chain ? linked : 0);
    tell(known, watch->name, "chains.fraction", chain ? linked / free_bodies : 0);
    tell(known, watch->name, "chains.bend", chain ? 2 * phi : 0);
  }
  return known_full(known, error);
}

const struct nb_reference reference_zigzag = {
    .name = "zigzag",
    .title = "force chains of a zigzag between two walls, from the balance of each disc",
    .source = "-",
    .accepts = {HAS_DISCS},
    .needs = {HAS_WALLS, HAS_FIXED_BODIES},
    .normal = "linear",
    .shear = "none",
    .know = know,
};
