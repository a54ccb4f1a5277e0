/* Long runs of one particle and of one contact: the growth of rounding errors over up to 1e9 cycles.
 *
 * endurance -o TABLE [CYCLES]   writes the drifts against the number of cycles, 1e9 by default (`make extremes`)
 * endurance                     tests the first million cycles, also with planted errors that must be detected
 *
 *   oscillation  A disc between two walls that never opens a contact. The scheme then has the exact solution
 *           x_n = A cos(n theta), v_n = -(A sin(theta)/dt) sin(n theta), with 2 sin(theta/2) = omega dt.
 *           Phase: the angle of (x_n, -v_n dt/sin(theta)), minus n theta. Amplitude: the sum of their squares over
 *           A^2, minus 1.
 *   bounce  A disc that bounces on a floor. The error of the energy in a bounce is the error of the scheme; it
 *           depends on the moments, within a step, at which the contact begins and ends, and it changes its sign. The
 *           work balance has only rounding errors.
 *   loop    A closed loop of the tangential displacement of two spheres, 40 steps, under constant normal force, by the
 *           exact and by the linear law: the force at the end of each loop, over mu N, minus that of the first.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../src/core/model.h"
#include "../src/laws/law.h"
#include "run/plan.h"

enum { PERIOD = 40, MOST = 4096 };

static void fail(const char *what) {
  fprintf(stderr, "endurance: %s\n", what);
  exit(2);
}

static double planted; /* a relative error of step, velocities and displacements that must be detected */

/* ---- a run of a page, cycle by cycle ---- */

struct run {
  struct nb_page page;
  struct nb_scene scene;
  struct nb_model *model;
};

static void run_begin(struct run *run, const char *name) {
  static const struct nb_options options = {.threads = 1};
  const char *top = getenv("srcdir");
  char path[4096];
  struct nb_mistakes mistakes = {0};
  struct nb_error error = {0};
  snprintf(path, sizeof path, "%s/tests/pages/%s.md", top ? top : ".", name);
  *run = (struct run){0};
  if (nb_page_read(&run->page, path, &mistakes) || nb_scene_read(&run->scene, &run->page, 0, NULL, &mistakes))
    fail(mistakes.text);
  nb_mistakes_free(&mistakes);
  run->model = nb_model_create(&run->scene, &options, &error);
  if (!run->model || nb_stage_begin(run->model, &run->scene.stages[0], &error))
    fail(error.text);
  run->model->step *= 1 + planted;
}
static void run_cycles(struct run *run, unsigned long count) {
  struct nb_error error = {0};
  for (unsigned long k = 0; k < count; k++) {
    if (nb_cycle(run->model, &error))
      fail(error.text);
    run->model->particles.velocity[0] = vec_scale(1 + planted, run->model->particles.velocity[0]);
  }
}
static void run_end(struct run *run) {
  nb_model_free(run->model);
  nb_scene_free(&run->scene);
  nb_page_free(&run->page);
}
static double column(const struct run *run, int c) {
  return nb_quantity_value(run->scene.columns[c].quantity, run->model);
}

/* ---- the systems: each returns two drifts after a number of cycles ---- */

enum { DRIFTS = 2 };
static const double amplitude = 0.1, height = 2, stiffness = 1e4; /* of the two pages */

static void oscillate(struct run *run, double drift[DRIFTS]) {
  const long double h = run->scene.step.value, theta = 2 * asinl(h / 2); /* omega = 1 */
  const double x = column(run, 0) / amplitude, y = column(run, 1) * (double)(h / sinl(theta)) / amplitude;
  drift[0] = (double)remainderl(atan2l(-y, x) - theta * run->model->cycle, 2 * acosl(-1));
  drift[1] = x * x + y * y - 1;
}

/* The drifts of the bouncing disc, measured in flight, where the energy of the discrete motion is exact. */
static void bounce(struct run *run, double drift[DRIFTS]) {
  while (column(run, 2) > 0)
    run_cycles(run, 1);
  const double v = column(run, 1);
  drift[0] = (column(run, 0) + v * v / 2) / height - 1;
  drift[1] = column(run, 3) / height; /* the mass is 1 */
}

/* Two contacts, of the exact and of the linear law. */
struct loop {
  struct contact {
    const struct nb_law *law;
    struct nb_pair pair;
    struct nb_normal n;
    double m[12 + 5 * 64], first, scale;
    struct nb_shear s;
  } contact[DRIFTS];
  double ds[PERIOD];
};

static void loop_begin(struct loop *loop) {
  const struct nb_pair pair = {
      .friction = 0.25, .young = 4e9, .shear = 1e9, .radius = 1, .pieces = 64, .kn = 1e9, .ks = 1e9};
  const double overlap = 1e-3,
               limit = 0.25 * overlap; /* tangential displacement at which the exact contact slides, m */
  *loop = (struct loop){0};
  for (int k = 0; k < PERIOD; k++)
    loop->ds[k] = limit / 2 * (sin(2 * NB_PI * (k + 1) / PERIOD) - sin(2 * NB_PI * k / PERIOD));
  for (int c = 0; c < DRIFTS; c++) {
    struct contact *it = &loop->contact[c];
    it->law = nb_law_find("shear", c ? "linear" : "mindlin_deresiewicz");
    it->pair = pair;
    it->n = nb_law_find("normal", c ? "linear" : "hertz")->normal(pair, overlap, 0, (double[8]){0});
    it->n.overlap = overlap;
    it->scale = pair.friction * it->n.force;
    it->s = it->law->shear(it->pair, it->n, 0, it->m);
  }
}
static void loop_cycles(struct loop *loop, unsigned long count) {
  for (unsigned long k = 0; k < count; k++)
    for (int c = 0; c < DRIFTS; c++) {
      struct contact *it = &loop->contact[c];
      const double ds = loop->ds[k % PERIOD];
      it->s = it->law->shear(it->pair, it->n, ds > 0 ? ds * (1 + planted) : ds, it->m);
    }
}
static void loop_drifts(struct loop *loop, double drift[DRIFTS]) {
  for (int c = 0; c < DRIFTS; c++)
    drift[c] = (loop->contact[c].s.force - loop->contact[c].first) / loop->contact[c].scale;
}

/* ---- all of them ---- */

/* After N cycles a drift is below linear eps N + root eps N^(1/2) + scheme (omega dt)^(5/2) B^(1/2), where eps is
 * DBL_EPSILON and B the number of bounces. */
static const struct series {
  const char *name;
  double linear, root, scheme;
} all[] = {{"oscillation: phase", 0.5, 0, 0},
           {"oscillation: amplitude", 0.002, 10, 0},
           {"bounce: energy", 0, 0, 1},
           {"bounce: work balance", 0.002, 10, 0},
           {"loop: force of the exact law", 0.5, 0, 0},
           {"loop: force of the linear law", 0.5, 0, 0}};
enum { SERIES = sizeof all / sizeof *all };

static double bound(const struct series *series, double cycles) {
  static const double step = 1e-3;
  const double bounces = cycles * step / (2 * sqrt(2 * (height - 1)));
  return DBL_EPSILON * (series->linear * cycles + series->root * sqrt(cycles)) +
         series->scheme * pow(sqrt(stiffness) * step, 2.5) * sqrt(bounces);
}

struct sample {
  double cycles, drift[SERIES];
};

static void write_table(const char *path, const struct sample samples[], size_t count) {
  FILE *out = fopen(path, "w");
  if (!out)
    fail("cannot write the table");
  fprintf(out, "cycles");
  for (int k = 0; k < SERIES; k++)
    fprintf(out, "\t%s", all[k].name);
  for (size_t s = 0; s < count; s++) {
    fprintf(out, "\n%.0f", samples[s].cycles);
    for (int k = 0; k < SERIES; k++)
      fprintf(out, "\t%.3g", samples[s].drift[k]);
  }
  fprintf(out, "\n");
  fclose(out);
}

/* Samples the drifts up to `most` cycles, ten times per decade. Returns the number of samples. If there is a path,
 * writes the table after each sample, so that a run of hours may be stopped. */
static size_t sample_all(struct sample samples[MOST], double most, const char *path) {
  struct run runs[2];
  struct loop loop;
  size_t count = 0;
  unsigned long done = 0;
  run_begin(&runs[0], "oscillating");
  run_begin(&runs[1], "bouncing");
  loop_begin(&loop);
  loop_cycles(&loop, PERIOD);
  for (int c = 0; c < DRIFTS; c++)
    loop.contact[c].first = loop.contact[c].s.force;
  for (double wanted = 1e3; wanted < most * 1.01 && count < MOST; wanted *= pow(10, 0.1)) {
    const unsigned long more = ((unsigned long)(wanted + 0.5) - done) / PERIOD * PERIOD;
    struct sample *sample = &samples[count++];
    for (int r = 0; r < 2; r++)
      run_cycles(&runs[r], more);
    loop_cycles(&loop, more);
    done += more;
    sample->cycles = (double)done;
    oscillate(&runs[0], sample->drift), bounce(&runs[1], sample->drift + DRIFTS),
        loop_drifts(&loop, sample->drift + 2 * DRIFTS);
    if (path)
      write_table(path, samples, count);
  }
  run_end(&runs[0]), run_end(&runs[1]);
  return count;
}

/* ---- tests ---- */

static bool holds(const struct series *series, const struct sample samples[], size_t count) {
  const ptrdiff_t k = series - all;
  for (size_t s = 0; s < count; s++)
    if (!(fabs(samples[s].drift[k]) <= bound(series, samples[s].cycles)))
      return false;
  return true;
}

/* Prints `ok` for each drift within its bound or, with a planted error, beyond it, as tests from number `from` + 1 on.
 * Returns how many drifts exceed their bounds. */
static int report(const struct sample samples[], size_t count, int from) {
  int exceeded = 0;
  for (int k = 0; k < SERIES; k++) {
    const bool good = holds(&all[k], samples, count);
    exceeded += !good;
    printf("%s %d - %s%s\n", good == (planted == 0) ? "ok" : "not ok", from + k + 1, all[k].name,
           planted > 0 ? " with a planted error" : "");
  }
  return exceeded;
}

int main(int argc, char **words) {
  static struct sample samples[MOST];
  const bool writes = argc > 2 && strcmp(words[1], "-o") == 0;
  if (argc > 1 && !writes)
    fail("usage: endurance [-o TABLE [CYCLES]]");
  const double cycles = !writes ? 1e6 : argc > 3 ? atof(words[3]) : 1e9;
  size_t count = sample_all(samples, cycles, writes ? words[2] : NULL);
  if (!writes)
    printf("1..%d\n", 2 * SERIES);
  const int exceeded = report(samples, count, 0);
  if (writes)
    return exceeded > 0;
  planted = 1e-6;
  count = sample_all(samples, cycles, NULL);
  report(samples, count, SERIES);
  return 0;
}
