/* The exact law with memories of several sizes (numbers of pieces), compared with by_hand.h, which keeps all rings.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "../by_hand.h"
#include "paths.h"

const int memories[MEMORIES] = {8, 16, 32, 64, 4096};
enum { ROW = 12 + 5 * 4096 };

struct replay {
  const struct nb_law *shear, *normal;
  double rows[MEMORIES][ROW];
  struct by_hand hand;
};

struct replay *replay_new(const struct nb_law *shear) {
  struct replay *replay = calloc(1, sizeof *replay);
  if (!replay)
    abort();
  replay->shear = shear, replay->normal = nb_law_find("normal", "hertz");
  return replay;
}

void replay_free(struct replay *replay) {
  if (replay)
    by_hand_free(&replay->hand);
  free(replay);
}

void replay_begin(struct replay *replay) {
  for (int k = 0; k < MEMORIES; k++)
    replay->rows[k][0] = 0; /* an empty history: law.h */
  replay->hand.count = 0;
}

void replay_go(struct replay *replay, struct nb_pair pair, double overlap, double ds, struct errors *errors) {
  struct nb_normal n = replay->normal->normal(pair, overlap, 0, NULL);
  n.overlap = overlap;
  const double wanted = by_hand_go(&replay->hand, overlap, ds / (pair.friction * pair.young / (4 * pair.shear)));
  for (int k = 0; k < MEMORIES; k++) {
    pair.pieces = memories[k];
    const struct nb_shear shear = replay->shear->shear(pair, n, ds, replay->rows[k]);
    const double error = fabs(shear.force / (pair.friction * n.force) - wanted);
    struct error *sum = &errors->of[k];
    sum->worst = error > sum->worst ? error : sum->worst, sum->square += error * error, sum->count++;
    sum->rings = replay->hand.count > sum->rings ? replay->hand.count : sum->rings;
  }
}

struct errors exact_on_paths(const struct nb_law *shear, int kind, long steps) {
  /* mu kappa = 1/4 (kappa: shear_mindlin_deresiewicz.c). The result depends only on u = slip/(mu kappa) and the
   * overlap. */
  static const struct nb_pair pair = {.friction = 0.25, .young = 4e9, .shear = 1e9, .radius = 1};
  struct errors errors = {0};
  struct path path = path_of(kind, 3);
  struct replay *replay = replay_new(shear);
  double at = 0;
  for (long k = 0; k < steps; k++) {
    const struct point point = path_next(&path);
    if (point.first)
      at = 0;
    if (point.x > 0)
      replay_go(replay, pair, point.x, (point.u - at) / 4, &errors);
    else
      replay_begin(replay);
    at = point.u;
  }
  replay_free(replay);
  return errors;
}
