/* Random paths of one contact after the other. Each contact has its own random numbers and opens at the end of its
 * path; then the next contact begins.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "paths.h"

static const double turn = 6.283185307179586;

const char *const kind_names[KINDS] = {"walk", "impact", "ringing", "both", "ratchet", "rolling", "decades"};
const char *const kind_titles[KINDS] = {
    "random walk of overlap and displacement; the contact opens now and then",
    "oblique impacts: the overlap is half a sine, the displacement a drift and an oscillation",
    "oscillation of the displacement with decreasing amplitude at constant overlap, then sliding forward and back",
    "as ringing, while the overlap also oscillates with decreasing amplitude",
    "ratcheting: cycles of overlap and displacement with a phase between them, in half of the contacts a drift",
    "rolling with micro-slip: the overlap grows and falls once, the displacement creeps and vibrates",
    "jumps of overlap and displacement over twelve decades",
};

struct path path_of(int kind, unsigned seed) {
  return (struct path){.kind = kind, .chance = chance_begin(seed * 16 + (unsigned)kind + 1)};
}

static int count_by(struct chance *chance, double low, double high) { return (int)chance_scale(chance, low, high); }

/* Draws the random numbers of a contact. */
static void begin(struct path *path) {
  struct chance *chance = &path->chance;
  const bool rings = path->kind == KIND_RINGING || path->kind == KIND_BOTH;
  path->x = 1, path->u = 0;
  path->amplitude = chance_scale(chance, 0.03, 1.5);
  path->period = count_by(chance, 8, 64);
  path->decay = chance_scale(chance, 3e-3, 0.5); /* relative decrease of the amplitude in a period */
  path->depth = path->kind == KIND_RINGING ? 0 : chance_between(chance, 0.05, 0.8);
  path->frequency = chance_scale(chance, 0.3, 3);
  path->phase = chance_between(chance, 0, turn);
  path->drift = chance_between(chance, -1, 1) < 0 ? 0 : chance_scale(chance, 1e-3, 1) * path->amplitude;
  switch (path->kind) {
  case KIND_IMPACT:
    path->count = count_by(chance, 10, 200);
    break;
  case KIND_RATCHET:
    path->count = (int)path->period * count_by(chance, 3, 100);
    break;
  default:
    path->count = count_by(chance, 100, 5000);
  }
  if (rings) /* until a thousandth of the amplitude is left */
    path->count = (int)fmin(path->period * log(1e-3) / log(1 - path->decay), 20000);
  path->left = path->count + (rings ? 120 : 0); /* the last 120 points: slide_both_ways */
}

static double drawn(struct path *path, double size) { return chance_between(&path->chance, -size, size); }

/* One of the last 120 points. In the first half of them the contact moves until it slides, in the second half it moves
 * back until it slides the other way. */
static void slide_both_ways(struct path *path) {
  path->u += (path->left >= 60 ? 1 : -2) * 1.5 / 60 * path->x * (path->phase < turn / 2 ? 1 : -1);
}

static void move(struct path *path, int step) {
  const double t = turn * step / path->period, of_all = (double)(step + 1) / path->count;
  double left = 1;
  switch (path->kind) {
  case KIND_WALK:
    path->x *= chance_scale(&path->chance, 0.8, 1.25);
    path->x = path->x < 0.1 ? 0.1 : path->x > 10 ? 10 : path->x;
    path->u += drawn(path, path->amplitude);
    break;
  case KIND_IMPACT:
    path->x = sin(turn / 2 * of_all);
    path->u = path->amplitude * (sin(turn * path->frequency * of_all + path->phase) - sin(path->phase)) +
              path->drift * of_all;
    break;
  case KIND_RINGING:
  case KIND_BOTH:
    if (path->left < 120) {
      slide_both_ways(path);
      break;
    }
    left = pow(1 - path->decay, step / path->period);
    path->x = 1 + path->depth * left * cos(path->frequency * t + path->phase);
    path->u = path->amplitude * left * sin(t);
    break;
  case KIND_RATCHET:
    path->x = 1 + path->depth * cos(t + path->phase);
    path->u = path->amplitude * sin(t) + path->drift * t / turn;
    break;
  case KIND_ROLLING:
    path->x = sin(turn / 2 * of_all) * (1 + 0.05 * path->depth * cos(path->frequency * t));
    path->u = path->amplitude * (of_all + 0.1 * sin(t) + 0.05 * sin(2.618 * t + path->phase));
    break;
  default:
    path->x = chance_scale(&path->chance, 1e-6, 1e6);
    path->u = drawn(path, 1) * chance_scale(&path->chance, 1e-6, 1e6);
  }
}

struct point path_next(struct path *path) {
  const bool first = path->left == 0;
  if (first)
    begin(path);
  path->left--;
  if (path->left == 0 || (path->kind == KIND_WALK && chance_between(&path->chance, 0, 1) < 0.002))
    return (struct point){0, path->u, first};
  move(path, path->count - path->left + (path->kind == KIND_RINGING || path->kind == KIND_BOTH ? 120 : 0));
  return (struct point){path->x, path->u, first};
}
