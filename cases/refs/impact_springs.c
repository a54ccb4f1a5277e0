/* The exact contact in an oblique impact, as independent springs side by side.
 *
 * A Hertz contact has the same N, T and energy as a row of independent springs under a parabolic indenter (method of
 * dimensionality reduction, Popov and Hess). y is the distance of a spring from the middle of the contact, divided by
 * the largest contact radius. The spring touches while y^2 < xi. Its normal force is proportional to xi - y^2, and its
 * tangential force is proportional to its deflection u. Coulomb's law holds for each spring:
 *
 *   du = dd,   |u| <= xi - y^2,   u = 0 without contact,        f = (3/2) Int_0^sqrt(xi) u dy
 *
 * The state of the springs is the only history; Cattaneo's and Mindlin's solutions follow from it for any path of xi
 * and d. If both change linearly in a step, it is exact to limit u + dd once, at the end of the step. A spring that
 * begins to touch in the step takes only the part of dd that follows the first touch. The springs stand at the middles
 * of equal cells, and the integration is leapfrog: both errors are of second order.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "impact_springs.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdlib.h>

/* y is xi and xi'. */
static int accelerate(double t, const double y[], double dydt[], void *data) {
  (void)t, (void)data;
  const double xi = y[0] > 0 ? y[0] : 0;
  dydt[0] = y[1], dydt[1] = -1.25 * xi * sqrt(xi);
  return 0;
}

double *impact_approach(int steps) {
  double *xi = calloc((size_t)steps + 1, sizeof *xi), t = 0, y[2] = {0, 1};
  gsl_odeiv2_system system = {accelerate, NULL, 2, NULL};
  gsl_odeiv2_driver *driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3, 1e-14, 1e-13);
  for (int k = 1; xi && driver && 2 * k <= steps; k++) { /* separation is approach reversed in time */
    const bool solved = gsl_odeiv2_driver_apply(driver, &t, IMPACT_DURATION * k / steps, y) == GSL_SUCCESS;
    xi[k] = xi[steps - k] = solved ? y[0] : NAN;
  }
  if (driver)
    gsl_odeiv2_driver_free(driver);
  return xi;
}

bool impact_path_create(struct impact_path *path, int steps) {
  const size_t n = (size_t)steps + 1;
  *path = (struct impact_path){.steps = steps,
                               .xi = impact_approach(steps),
                               .f = calloc(n, sizeof(double)),
                               .d = calloc(n, sizeof(double)),
                               .slides = calloc(n, sizeof(bool))};
  return path->xi && path->f && path->d && path->slides;
}

void impact_path_free(struct impact_path *path) {
  free(path->xi), free(path->f), free(path->d), free(path->slides);
  *path = (struct impact_path){0};
}

static double clip(double u, double limit) { return u > limit ? limit : u < -limit ? -limit : u; }

/* The number of springs that touch at the overlap xi, of `springs` in all. */
static int touching(double xi, int springs) {
  const double count = ceil(sqrt(xi) * springs - 0.5);
  return count < springs ? (int)count : springs;
}

/* The innermost spring is the last to slip, so its slip is the gross sliding of the contact. Eight sums let the
 * compiler vectorise. */
double impact_press(double *u, const double *depth, int springs, double from, double to, double slip, double *sliding) {
  const int before = touching(from, springs), after = touching(to, springs), stay = before < after ? before : after;
  double sum[8] = {0}, all = 0;
  *sliding = stay > 0 ? u[0] + slip - clip(u[0] + slip, to - depth[0]) : 0;
  int i = 0;
  for (; i + 8 <= stay; i += 8)
    for (int k = 0; k < 8; k++)
      sum[k] += u[i + k] = clip(u[i + k] + slip, to - depth[i + k]);
  for (; i < after; i++)
    all += u[i] = clip(i < stay ? u[i] + slip : slip * (to - depth[i]) / (to - from), to - depth[i]);
  for (int k = 0; k < 8; k++)
    all += sum[k];
  return 1.5 * all / springs;
}

bool impact_springs(struct impact_path *path, double chi, double psi1, int steps) {
  const int springs = steps;
  const double dt = IMPACT_DURATION / steps;
  double *u = calloc((size_t)springs, sizeof *u), *depth = calloc((size_t)springs, sizeof *depth);
  const bool made = impact_path_create(path, steps) && u && depth;
  for (int i = 0; made && i < springs; i++)
    depth[i] = (i + 0.5) / springs * ((i + 0.5) / springs);
  double psi = psi1;
  for (int k = 0; made && k < steps; k++) {
    double sliding;
    psi -= 2.5 * chi * path->f[k] * (k ? dt : dt / 2);
    path->d[k + 1] = path->d[k] + psi * dt;
    path->f[k + 1] = impact_press(u, depth, springs, path->xi[k], path->xi[k + 1], psi * dt, &sliding);
    path->slid += sliding * (path->f[k] + path->f[k + 1]) / 2;
    path->slides[k + 1] = fabs(u[0]) >= path->xi[k + 1] - depth[0];
  }
  path->psi2 = psi; /* the half step that remains adds nothing: f is 0 at the end */
  free(u), free(depth);
  return made;
}

/* Richardson: with the results a and b of the coarse and the fine run, (4 b - a)/3 has no second-order error. */
static double extrapolated(double coarse, double fine) { return fine + (fine - coarse) / 3; }

bool impact_exact(struct impact_path *path, double chi, double psi1, int steps) {
  struct impact_path coarse;
  bool made = impact_springs(&coarse, chi, psi1, steps / 2);
  made = impact_springs(path, chi, psi1, steps / 2 * 2) && made;
  if (made) {
    path->psi2 = extrapolated(coarse.psi2, path->psi2);
    path->slid = extrapolated(coarse.slid, path->slid);
    for (int k = 0; k <= coarse.steps; k++) {
      path->f[2 * k] = extrapolated(coarse.f[k], path->f[2 * k]);
      path->d[2 * k] = extrapolated(coarse.d[k], path->d[2 * k]);
    }
  }
  impact_path_free(&coarse);
  return made;
}
