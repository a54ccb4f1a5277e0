/* References of contact tests (path_no_slip, path_springs, path_randall), compared with closed forms.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "refs_scenes.h"
#include "refs_tables.h"
#include "suites.h"
#include "written.h"

/* A contact of two spheres with R* = 1.2, mu = 0.8 and k_s = 15. */
#define TOUCHES(law, path)                                                                                             \
  "path\nmaterial a young 4 poisson 0.25 ks 30 friction 0.8\nmaterial b young 6 poisson 0.2 ks 10 friction 0.9\n"      \
  "contact sphere 2 a with sphere 3 b\nnormal hertz\nshear " law                                                       \
  "\nrecord step overlap slip normal shear work.shear\n"                                                               \
  "segment p overlap to 0.04 in 2 steps\n" path
static double hertz(double overlap) { return 4. / 3 / (0.9375 / 4 + 0.96 / 6) * sqrt(1.2) * pow(overlap, 1.5); }
/* 8 G* sqrt(R*), and mu kappa: the tangential displacement over the overlap at which a contact slides. */
static double mindlin_stiffness(void) { return 8 / (1.75 / 1.6 + 1.8 / 2.5) * sqrt(1.2); }
static double mindlin_limit(void) { return 0.8 * (1.75 / 1.6 + 1.8 / 2.5) / (0.9375 / 4 + 0.96 / 6) / 4; }

/* The stiffness is k_s, or 8 G* a. In segment r, alpha and delta change at once; in s the scaled law keeps T/a. */
static void path_no_slip(void) {
  static const char *const names[] = {"linear", "mindlin", "mindlin_scaled"};
  for (int law = 0; law < 3; law++) {
    char page[1024];
    const double k = mindlin_stiffness(), q = law ? k * sqrt(0.04) : 15, t = law ? k * sqrt(0.0625) : 15;
    const double mean = law ? k * 2 / 3 * (pow(0.09, 1.5) - pow(0.04, 1.5)) / 0.05 : 15;
    const double tq = -0.001 * q, tr = tq + mean * 0.003, ts = law == 2 ? tr * sqrt(0.0625 / 0.09) : tr, tt = -0.004;
    /* in segment r the force is T + c (alpha^(3/2) - 0.04^(3/2)) */
    const double c = k * 2 / 3 / 0.05 * 0.003;
    const double average =
        law ? tq - c * pow(0.04, 1.5) + c * 0.4 * (pow(0.09, 2.5) - pow(0.04, 2.5)) / 0.05 : (tq + tr) / 2;
    const double wq = tq * tq / q / 2, wr = wq + average * 0.003, wt = wr + (tt * tt - ts * ts) / t / 2;
    const double slip = 0.002 + (tt - ts) / t;
    snprintf(page, sizeof page,
             TOUCHES("%s", "segment q slip to -0.001 in 4 steps\nsegment r overlap to 0.09 slip by 0.003 in 1 step\n"
                           "segment s overlap to 0.0625 in 1 step\nsegment t shear to -0.004 hold normal in 2 steps\n"),
             names[law]);
    VALUES("path_no_slip", page, 1e3, {"slip in p", 0}, {"shear in p", 0}, {"work.shear in p", 0},
           {"slip in q", -0.001}, {"shear in q", tq}, {"work.shear in q", wq}, {"slip in r", 0.002}, {"shear in r", tr},
           {"work.shear in r", wr}, {"slip in s", 0.002}, {"shear in s", ts}, {"work.shear in s", wr},
           {"slip in t", slip}, {"shear in t", tt}, {"work.shear in t", wt}, {"slip", slip}, {"shear", tt},
           {"work.shear", wt}, {"slip", -0.00025, "step", 3}, {"shear", tq / 4, "step", 3},
           {"work.shear", wq / 16, "step", 2.6}, {"work.shear", wq / 16, "step", 3.4},
           {"shear", (ts + tt) / 2, "step", 9}, {"shear", 0, "step", 0});
    /* a contact that opens, also beyond the point where it touches, and closes again */
    for (int beyond = 0; beyond < 2; beyond++) {
      snprintf(page, sizeof page,
               TOUCHES("%s", "segment q slip to -0.001 in 1 step\nsegment o overlap to %s in 1 step\n"
                             "segment c overlap to 0.04 in 1 step\n"),
               names[law], beyond ? "-0.01" : "0");
      VALUES("path_no_slip", page, 1e3, {"slip in p", 0}, {"shear in p", 0}, {"work.shear in p", 0},
             {"slip in q", -0.001}, {"shear in q", tq}, {"work.shear in q", wq}, {"slip in o", -0.001},
             {"shear in o", 0}, {"work.shear in o", wq}, {"slip in c", -0.001}, {"shear in c", 0},
             {"work.shear in c", wq}, {"slip", -0.001}, {"shear", 0}, {"work.shear", wq}, {"slip", 0, "step", 1},
             {"shear", tq, "step", 3}, {"work.shear", wq, "step", 4});
    }
    /* the limit is mu N, also for T < 0 */
    const double largest = 0.8 * hertz(0.04) / (law ? k * sqrt(0.04) : 15);
    for (int over = 0; over < 2; over++)
      for (int sign = -1; sign < 2; sign += 2) {
        snprintf(page, sizeof page, TOUCHES("%s", "segment q slip to %.17g in 3 steps\n"), names[law],
                 sign * largest * (over ? 1.0001 : 0.9999));
        refs_check_message("path_no_slip", page, over ? "a path without sliding" : NULL);
      }
  }
}

/* Integral of 1 - (1 - x/L)^(3/2) from 0 to x. */
static double mindlin_work(double x, double length) { return x - 0.4 * length * (1 - pow(1 - x / length, 2.5)); }
static double mindlin_force(double x, double length) { return 1 - pow(1 - x / length, 1.5); }

/* The rows of a file are the steps of a segment. */
static void points_of_a_file(void) {
  char path[] = "/tmp/nineball-points-XXXXXX", page[1024];
  const int file = mkstemp(path);
  CU_ASSERT_FATAL(file >= 0);
  close(file);
  written_text(path, "slip/-\toverlap/-\n0.0001\t0.05\n-0.0002\t0.04\n0.0003\t0.06\n");
  snprintf(page, sizeof page, TOUCHES("linear", "segment f follow %s\n"), path);
  const double work = 15 * 0.0003 * 0.0003 / 2;
  VALUES("path_no_slip", page, 1, {"slip in p", 0}, {"shear in p", 0}, {"work.shear in p", 0}, {"slip in f", 0.0003},
         {"shear in f", 0.0045}, {"work.shear in f", work}, {"slip", 0.0003}, {"shear", 0.0045}, {"work.shear", work},
         {"slip", 0, "step", 2}, {"slip", 0.0001, "step", 3}, {"slip", -0.0002, "step", 4}, {"slip", 0.0003, "step", 5},
         {"shear", 0.0015, "step", 3}, {"shear", -0.003, "step", 4}, {"work.shear", 15 * 1e-8 / 2, "step", 3});
  snprintf(page, sizeof page, TOUCHES("mindlin_deresiewicz", "segment f follow %s\n"), path);
  struct nb_solution solution;
  struct nb_error error = {0};
  CU_ASSERT_EQUAL(refs_solve(&solution, "path_springs", page, &error), NB_OK);
  const double *overlap = solution_find(&solution, "overlap in f");
  const struct nb_solution_curve *curve = solution_find_curve(&solution, "overlap", "step");
  CU_ASSERT(overlap && *overlap == 0.06 && curve && curve->at(curve->data, 3) == 0.05 &&
            curve->at(curve->data, 4) == 0.04);
  solution_free(&solution);
  remove(path);
}

/* Loading, unloading and reloading at constant N in Mindlin and Deresiewicz's closed form, and gross sliding. In loading
 * a part of the contact at the distance y from the middle slips against l = mu kappa (alpha - y^2/R*) and dissipates
 * 4 G* l (delta - l) dy. */
static void path_springs(void) {
  const double n = 0.8 * hertz(0.04), length = mindlin_limit() * 0.04, d = 0.6 * length, back = 0.9 * length;
  const double tq = n * mindlin_force(d, length), wq = n * mindlin_work(d, length);
  const double tr = tq - 2 * n * mindlin_force(back, 2 * length);
  const double wr = wq - tq * back + 2 * n * mindlin_work(back, 2 * length);
  double lost = 0;
  for (int k = 0; k < 20000; k++) {
    const double y = sqrt(1.2 * 0.04) * (k + 0.5) / 20000, l = mindlin_limit() * (0.04 - y * y / 1.2);
    lost += l < d ? 2 * mindlin_stiffness() / sqrt(1.2) / 2 * l * (d - l) * sqrt(1.2 * 0.04) / 20000 : 0;
  }
  char page[1024];
  snprintf(page, sizeof page,
           TOUCHES("mindlin_deresiewicz",
                   "segment q slip to %.17g in 5 steps\nsegment r slip by %.17g in 5 steps\n"
                   "segment s shear to %.17g hold normal in 5 steps\n"
                   "segment t slip by %.17g in 5 steps\nsegment u overlap to -0.01 in 3 steps\n"),
           d, -back, tq, -9 * length);
#define AT(segment, delta, force, stored, dissipated)                                                                  \
  {"overlap in " segment, 0.04}, {"slip in " segment, delta}, {"normal in " segment, hertz(0.04)},                     \
      {"shear in " segment, force}, {"traction.force in " segment, force}, {"stored.shear in " segment, stored},       \
      {"dissipated in " segment, dissipated}, {                                                                        \
    "work.shear in " segment, (stored) + (dissipated)                                                                  \
  }
  /* unloading from T* dissipates the same as loading by half of it with twice the limits: the loop is that of twice lost */
  const double end = d - 9 * length;
  struct nb_solution solution;
  struct nb_error error = {0};
  CU_ASSERT_EQUAL(refs_solve(&solution, "path_springs", page, &error), NB_OK);
  const struct expected expected[] = {AT("p", 0, 0, 0, 0),     AT("q", d, tq, wq - lost, lost),
                                      {"slip in r", d - back}, {"shear in r", tr},
                                      {"work.shear in r", wr}, {"slip in s", d},
                                      {"shear in s", tq},      {"slip in t", end},
                                      {"shear in t", -n},      {"shear in u", 0},
                                      {"normal in u", 0},      {"overlap in u", 0},
                                      {"slip in u", end},      {"stored.shear in u", 0}};
  for (size_t k = 0; k < sizeof expected / sizeof *expected; k++) {
    const double *value = solution_find(&solution, expected[k].name);
    const bool right =
        value && fabs(*value - expected[k].value) <= 2e-6 * n * (strstr(expected[k].name, "shear") ? 1 : length);
    if (!right)
      printf("# %s is %.12g, expected %.12g\n", expected[k].name, value ? *value : NAN, expected[k].value);
    CU_ASSERT(right);
  }
  /* sliding at mu N: work and dissipation increase at the same rate, and the stored energy is that of full deflection */
  const struct nb_solution_curve *work = solution_find_curve(&solution, "work.shear", "step");
  const struct nb_solution_curve *dissipated = solution_find_curve(&solution, "dissipated", "step");
  const double slid = 9 * length / 5 * n;
  NEAR(work->at(work->data, 22) - work->at(work->data, 21), slid, 1e-6);
  NEAR(dissipated->at(dissipated->data, 22) - dissipated->at(dissipated->data, 21), slid, 1e-6);
  solution_free(&solution);
#undef AT
}

/* The row of springs is as long as the largest contact: that of an overlap, or of a change of the normal force. */
static void largest_contact_of_a_path(void) {
  const double high = pow(1.1 / hertz(1), 2. / 3), large[] = {0.4, high};
  static const char *const segments[] = {"segment q overlap to 0.4 in 1 step\n",
                                         "segment q normal to 0.1 in 1 step\nsegment q2 normal by 1 in 1 step\n"};
  for (int k = 0; k < 2; k++) {
    const double n = 0.8 * hertz(large[k]), length = mindlin_limit() * large[k];
    char page[1024];
    snprintf(page, sizeof page, TOUCHES("mindlin_deresiewicz", "%ssegment r slip to %.17g in 1 step\n"), segments[k],
             length / 2);
    struct nb_solution solution;
    struct nb_error error = {0};
    CU_ASSERT_EQUAL(refs_solve(&solution, "path_springs", page, &error), NB_OK);
    const double *shear = solution_find(&solution, "shear in r");
    CU_ASSERT(shear && fabs(*shear - n * mindlin_force(length / 2, length)) <= 2e-6 * n);
    solution_free(&solution);
  }
}

/* No slip leads to a shear force above mu N, so that segment has no values, and there is no curve. */
static void forces_above_the_limit(void) {
  for (int over = 0; over < 2; over++)
    for (int sign = -1; sign < 2; sign += 2) {
      struct nb_solution solution;
      struct nb_error error = {0};
      char page[1024];
      snprintf(page, sizeof page, TOUCHES("mindlin_deresiewicz", "segment q shear to %.17g hold normal in 3 steps\n"),
               sign * (over ? 1.001 : 0.999) * 0.8 * hertz(0.04));
      CU_ASSERT_EQUAL(refs_solve(&solution, "path_springs", page, &error), NB_OK);
      CU_ASSERT_PTR_NOT_NULL(solution_find(&solution, "shear in p"));
      CU_ASSERT_EQUAL(solution_find(&solution, "shear in q") != NULL, !over);
      CU_ASSERT_EQUAL(solution_find(&solution, "shear") != NULL, !over);
      CU_ASSERT_EQUAL(solution_find_curve(&solution, "shear", "step") != NULL, !over);
      solution_free(&solution);
    }
}

/* [R89 3.95-3.97] at constant N, then a constant T and a deficit while N increases, and N u = N(zeta) while it
 * decreases. */
static void path_randall(void) {
  const double n = 0.8 * hertz(0.04), length = mindlin_limit() * 0.04, u = length / 10;
  const double tq = n * mindlin_force(5 * u, length), wq = n * mindlin_work(5 * u, length);
  const double tr = tq - 2 * n * mindlin_force(6 * u, 2 * length);
  const double wr = wq - tq * 6 * u + 2 * n * mindlin_work(6 * u, 2 * length);
  const double ts = tr + 2 * n * mindlin_force(3 * u, 2 * length);
  const double ws = wr + tr * 3 * u + 2 * n * mindlin_work(3 * u, 2 * length);
  const double tt = tr + 2 * n * mindlin_force(2 * u, 2 * length); /* re-unloading goes back along it */
  const double wt = wr + tr * 2 * u + 2 * n * mindlin_work(2 * u, 2 * length);
  const double stiff = mindlin_stiffness() * sqrt(0.05), deficit = mindlin_limit() * 0.01;
  const double tw = tq + stiff * deficit / 2, ww = wq + (tq + tw) / 2 * deficit / 2;
  char page[1024];
  snprintf(page, sizeof page,
           TOUCHES("randall", "segment q slip to %.17g in 5 steps\nsegment r slip by %.17g in 3 steps\n"
                              "segment s slip by %.17g in 1 step\nsegment t slip by %.17g in 2 steps\n"),
           5 * u, -6 * u, 3 * u, -u);
#define AT(segment, delta, force, work)                                                                                \
  {"slip in " segment, delta}, {"shear in " segment, force}, {"work.shear in " segment, work}
#define LAST(delta, force, work)                                                                                       \
  {"slip", delta}, {"shear", force}, {"work.shear", work}, {"slip", delta, "step", 13}, {"shear", force, "step", 13},  \
  {                                                                                                                    \
    "work.shear", work, "step", 13                                                                                     \
  }
  VALUES("path_randall", page, 1, AT("p", 0, 0, 0), AT("q", 5 * u, tq, wq), AT("r", -u, tr, wr), AT("s", 2 * u, ts, ws),
         AT("t", u, tt, wt), LAST(u, tt, wt));
  snprintf(page, sizeof page,
           TOUCHES("randall", "segment q slip to %.17g in 5 steps\nsegment v overlap to 0.05 in 4 steps\n"
                              "segment w slip by %.17g in 1 step\nsegment y slip by %.17g in 1 step\n"),
           5 * u, deficit / 2, deficit);
  /* the other half of the deficit, then the curve of loading, from x to x + deficit/2 */
  const double nv = 0.8 * hertz(0.05), wide = mindlin_limit() * 0.05, ta = tq + stiff * deficit;
  const double x = wide * (1 - pow(1 - ta / nv, 2. / 3)), tl = nv * mindlin_force(x + deficit / 2, wide);
  const double wl =
      ww + (tw + ta) / 2 * deficit / 2 + nv * (mindlin_work(x + deficit / 2, wide) - mindlin_work(x, wide));
  VALUES("path_randall", page, 1, AT("p", 0, 0, 0), AT("q", 5 * u, tq, wq), AT("v", 5 * u, tq, wq),
         AT("w", 5 * u + deficit / 2, tw, ww), AT("y", 5 * u + 1.5 * deficit, tl, wl),
         LAST(5 * u + 1.5 * deficit, tl, wl));
  const double td = tt - stiff * deficit / 2, wd = wt - (tt + td) / 2 * deficit / 2; /* the same in re-unloading */
  snprintf(page, sizeof page,
           TOUCHES("randall", "segment q slip to %.17g in 5 steps\nsegment r slip by %.17g in 3 steps\n"
                              "segment s slip by %.17g in 1 step\nsegment t slip by %.17g in 2 steps\n"
                              "segment v overlap to 0.05 in 1 step\nsegment w slip by %.17g in 1 step\n"),
           5 * u, -6 * u, 3 * u, -u, -deficit / 2);
  VALUES("path_randall", page, 1, AT("p", 0, 0, 0), AT("q", 5 * u, tq, wq), AT("r", -u, tr, wr), AT("s", 2 * u, ts, ws),
         AT("t", u, tt, wt), AT("v", u, tt, wt), AT("w", u - deficit / 2, td, wd), {"slip", u - deficit / 2},
         {"shear", td}, {"work.shear", wd}, {"slip", u, "step", 14}, {"shear", tt, "step", 14},
         {"work.shear", wt, "step", 14});
  /* zeta decreases with alpha in loading, and by half as much in unloading */
  const double zeta = 0.04 * pow(1 - tq / n, 2. / 3) - 0.005;
  const double half = 0.04 * pow(1 - (tq - tr) / (2 * n), 2. / 3) - 0.0025;
  const double m = 0.8 * hertz(0.035), tx = m - 0.8 * hertz(zeta);
  const double ty = tq - (n - m) - 2 * (m - 0.8 * hertz(half)); /* T* decreases by mu |dN| */
  snprintf(page, sizeof page,
           TOUCHES("randall", "segment q slip to %.17g in 5 steps\nsegment x overlap to 0.035 in 6 steps\n"), 5 * u);
  VALUES("path_randall", page, 1, AT("p", 0, 0, 0), AT("q", 5 * u, tq, wq), AT("x", 5 * u, tx, wq),
         LAST(5 * u, tx, wq));
  snprintf(page, sizeof page,
           TOUCHES("randall", "segment q slip to %.17g in 5 steps\nsegment r slip by %.17g in 3 steps\n"
                              "segment x overlap to 0.035 in 3 steps\n"),
           5 * u, -6 * u);
  VALUES("path_randall", page, 1, AT("p", 0, 0, 0), AT("q", 5 * u, tq, wq), AT("r", -u, tr, wr), AT("x", -u, ty, wr),
         LAST(-u, ty, wr));
}

/* The force on a curve of R89 after the displacement `slip`, and the work by Simpson's rule. T = from + sign size (1 - u),
 * and u^(2/3) falls by slip/scale; it is w at first. */
struct curve {
  double from, sign, size, scale, w;
};
static double on_curve(const struct curve *at, double slip) {
  return at->from + at->sign * at->size * (1 - pow(at->w - at->sign * slip / at->scale, 1.5));
}
static double curve_work(const struct curve *at, double slip) {
  double sum = 0;
  for (int k = 0; k < 1000; k++)
    sum += (on_curve(at, slip * k / 1000) + 4 * on_curve(at, slip * (k + 0.5) / 1000) +
            on_curve(at, slip * (k + 1) / 1000));
  return sum * slip / 6000;
}

/* Where zeta = alpha, unloading becomes loading, and reloading becomes unloading: at the overlap alpha (2 u^(2/3) - 1). And
 * re-unloading that has passed T** does not begin the next reloading in the wrong direction: its reversal leaves no deficit.
 */
static void path_randall_beyond_its_curves(void) {
  const double n = 0.8 * hertz(0.04), length = mindlin_limit() * 0.04, u = length / 10;
  const double tq = n * mindlin_force(5 * u, length), wq = n * mindlin_work(5 * u, length);
  const double tr = tq - 2 * n * mindlin_force(u, 2 * length), wr = wq - tq * u + 2 * n * mindlin_work(u, 2 * length);
  const double edge = 0.04 * (2 * (1 - 0.05) - 1), ne = 0.8 * hertz(edge), te = tq - (n - ne), m = 0.8 * hertz(0.034);
  const double ts = m - 0.8 * hertz(edge * pow(1 - te / ne, 2. / 3) - (edge - 0.034));
  char page[1024];
  snprintf(page, sizeof page,
           TOUCHES("randall", "segment q slip to %.17g in 5 steps\nsegment r slip by %.17g in 2 steps\n"
                              "segment s overlap to 0.034 in 4 steps\n"),
           5 * u, -u);
  VALUES("path_randall", page, 1, AT("p", 0, 0, 0), AT("q", 5 * u, tq, wq), AT("r", 4 * u, tr, wr),
         AT("s", 4 * u, ts, wr), LAST(4 * u, ts, wr));
  const double low = tq - 2 * n * mindlin_force(5 * u, 2 * length);
  const double wlow = wq - tq * 5 * u + 2 * n * mindlin_work(5 * u, 2 * length);
  const double tv = low + 2 * n * mindlin_force(u, 2 * length),
               wv = wlow + low * u + 2 * n * mindlin_work(u, 2 * length);
  const double lowest = low + (n - ne), star = tq - (n - ne); /* T** and T* at the edge */
  const double zeta = edge * pow(1 - (star - lowest) / (2 * ne), 2. / 3) - (edge - 0.034) / 2;
  const double tx = star - (ne - m) - 2 * (m - 0.8 * hertz(zeta));
  snprintf(page, sizeof page,
           TOUCHES("randall", "segment q slip to %.17g in 5 steps\nsegment r slip by %.17g in 1 step\n"
                              "segment v slip by %.17g in 1 step\nsegment x overlap to 0.034 in 4 steps\n"),
           5 * u, -5 * u, u);
  VALUES("path_randall", page, 1, AT("p", 0, 0, 0), AT("q", 5 * u, tq, wq), AT("r", 0, low, wlow), AT("v", u, tv, wv),
         AT("x", u, tx, wv), LAST(u, tx, wv));
  const double tz = tq - 2 * n * mindlin_force(7 * u, 2 * length); /* beyond the end of re-unloading, at T** = low */
  const double wz = wq - tq * 7 * u + 2 * n * mindlin_work(7 * u, 2 * length);
  const double ty = tz + 2 * n * mindlin_force(2 * u, 2 * length);
  const double wy = wz + tz * 2 * u + 2 * n * mindlin_work(2 * u, 2 * length);
  const double nv = 0.8 * hertz(0.05), from = tz - (nv - n), back = mindlin_limit() * 0.005;
  const struct curve returns = {from, 1, 2 * nv, 2 * mindlin_limit() * 0.05, pow(1 - (ty - from) / (2 * nv), 2. / 3)};
  const double tb = on_curve(&returns, -back), wb = wy + curve_work(&returns, -back);
  snprintf(page, sizeof page,
           TOUCHES("randall", "segment q slip to %.17g in 3 steps\nsegment r slip by %.17g in 1 step\n"
                              "segment v slip by %.17g in 1 step\nsegment z slip by %.17g in 2 steps\n"
                              "segment y slip by %.17g in 1 step\nsegment n overlap to 0.05 in 2 steps\n"
                              "segment b slip by %.17g in 1 step\n"),
           5 * u, -5 * u, u, -3 * u, 2 * u, -back);
  VALUES("path_randall", page, 1, AT("p", 0, 0, 0), AT("q", 5 * u, tq, wq), AT("r", 0, low, wlow), AT("v", u, tv, wv),
         AT("z", -2 * u, tz, wz), AT("y", 0, ty, wy), AT("n", 0, ty, wy), AT("b", -back, tb, wb), LAST(-back, tb, wb));
}

/* `randall_literal`: a decrease of N leaves T unchanged, while T* decreases and T** increases by mu |dN|. If T is then
 * above T*, the next displacement loads the contact; if T is below T** in reloading, it unloads the contact. */
static void path_randall_literal(void) {
  const double n = 0.8 * hertz(0.04), length = mindlin_limit() * 0.04, u = length / 10;
  const double tq = n * mindlin_force(5 * u, length), wq = n * mindlin_work(5 * u, length);
  const double tr = tq - 2 * n * mindlin_force(u, 2 * length), wr = wq - tq * u + 2 * n * mindlin_work(u, 2 * length);
  const double m = 0.8 * hertz(0.034), narrow = mindlin_limit() * 0.034;
  CU_ASSERT(tq - (n - m) < tr);
  const struct curve loads = {0, 1, m, narrow, pow(1 - tr / m, 2. / 3)};
  const double tt = on_curve(&loads, u), wt = wr + curve_work(&loads, u);
  char page[1024];
  snprintf(page, sizeof page,
           TOUCHES("randall_literal", "segment q slip to %.17g in 5 steps\nsegment r slip by %.17g in 2 steps\n"
                                      "segment s overlap to 0.034 in 2 steps\nsegment t slip by %.17g in 2 steps\n"),
           5 * u, -u, u);
  VALUES("path_randall", page, 1, AT("p", 0, 0, 0), AT("q", 5 * u, tq, wq), AT("r", 4 * u, tr, wr),
         AT("s", 4 * u, tr, wr), AT("t", 5 * u, tt, wt), LAST(5 * u, tt, wt));
  /* reloading has u = 1 - (T - T*)/(2 mu N) [R89 4.24] */
  const double low = tq - 2 * n * mindlin_force(6 * u, 2 * length);
  const double wlow = wq - tq * 6 * u + 2 * n * mindlin_work(6 * u, 2 * length);
  const struct curve reloads = {tq, 1, 2 * n, 2 * length, pow(1 - (low - tq) / (2 * n), 2. / 3)};
  const double ts = on_curve(&reloads, 2 * u), ws = wlow + curve_work(&reloads, 2 * u);
  const double o = 0.8 * hertz(0.03), star = tq - (n - o);
  CU_ASSERT(low + (n - o) > ts && ts < star);
  const struct curve unloads = {star, -1, 2 * o, 2 * mindlin_limit() * 0.03, pow(1 - (star - ts) / (2 * o), 2. / 3)};
  const double tv = on_curve(&unloads, -u), wv = ws + curve_work(&unloads, -u);
  snprintf(page, sizeof page,
           TOUCHES("randall_literal", "segment q slip to %.17g in 5 steps\nsegment r slip by %.17g in 2 steps\n"
                                      "segment s slip by %.17g in 1 step\nsegment t overlap to 0.03 in 3 steps\n"
                                      "segment v slip by %.17g in 2 steps\n"),
           5 * u, -6 * u, 2 * u, -u);
  VALUES("path_randall", page, 1, AT("p", 0, 0, 0), AT("q", 5 * u, tq, wq), AT("r", -u, low, wlow), AT("s", u, ts, ws),
         AT("t", u, ts, ws), AT("v", 0, tv, wv), {"slip", 0}, {"shear", tv}, {"work.shear", wv},
         {"slip", -u, "step", 9}, {"shear", low, "step", 9}, {"work.shear", wlow, "step", 9});
#undef LAST
#undef AT
}

/* The contact slides at a slip of mu kappa alpha, and the force is -T* at the slip -u after u [R89 3.95]. */
static void paths_that_randall_does_not_cover(void) {
  static const char *const covered = "overlap and slip, or normal force and slip, that change in turns, without gross "
                                     "sliding, and without unloading to -T*, where T* is the shear force at which "
                                     "unloading began";
  const double limit = mindlin_limit() * 0.04, u = limit / 2;
  const struct {
    const char *segments;
    double slip, back;
    bool is_covered;
  } rows[] = {
      {"segment q slip to %.17g in 1 step\nsegment r overlap to 0.05 in 2 steps\n", u, 0, true},
      {"segment q overlap to 0.05 slip to %.17g in 2 steps\n", u, 0, false},
      {"segment q overlap to 0.03 slip by %.17g in 1 step\n", -u / 2, 0, false},
      {"segment q slip to %.17g in 1 step\nsegment r normal to 0.09 in 2 steps\n", u, 0, true},
      {"segment q normal to 0.09 slip by %.17g in 1 step\n", u, 0, false},
      {"segment q slip to %.17g in 1 step\nsegment r shear to 0.001 hold normal in 2 steps\n", u, 0, false},
      {"segment q slip to %.17g in 1 step\nsegment r overlap to 0 in 2 steps\n", 0, 0, false},
      {"segment q slip to %.17g in 3 steps\n", 0.999 * limit, 0, true},
      {"segment q slip to %.17g in 3 steps\n", 1.001 * limit, 0, false},
      {"segment q slip to %.17g in 2 steps\nsegment r slip to %.17g in 3 steps\n", u, -0.999 * u, true},
      {"segment q slip to %.17g in 2 steps\nsegment r slip to %.17g in 3 steps\n", u, -1.001 * u, false},
      /* the limit decreases with the normal force */
      {"segment q slip to %.17g in 1 step\nsegment r overlap to 0.02 in 2 steps\n", 0.4 * limit, 0, true},
      {"segment q slip to %.17g in 1 step\nsegment r overlap to 0.02 in 2 steps\n", 0.6 * limit, 0, false},
      {"segment q slip to %.17g in 2 steps\nsegment r slip to %.17g in 3 steps\nsegment s overlap to 0.039 in 1 step\n",
       u, -0.9 * u, true},
      {"segment q slip to %.17g in 2 steps\nsegment r slip to %.17g in 3 steps\nsegment s overlap to 0.03 in 1 step\n",
       u, -0.9 * u, false},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    char segments[512], page[1024];
    snprintf(segments, sizeof segments, rows[k].segments, rows[k].slip, rows[k].back);
    snprintf(page, sizeof page, TOUCHES("randall", "%s"), segments);
    refs_check_message("path_randall", page, rows[k].is_covered ? NULL : covered);
  }
}

void suite_refs_paths(void) {
  CU_pSuite suite = CU_add_suite("refs_paths", NULL, refs_released);
  CU_ADD_TEST(suite, path_no_slip);
  CU_ADD_TEST(suite, points_of_a_file);
  CU_ADD_TEST(suite, path_springs);
  CU_ADD_TEST(suite, largest_contact_of_a_path);
  CU_ADD_TEST(suite, forces_above_the_limit);
  CU_ADD_TEST(suite, path_randall);
  CU_ADD_TEST(suite, path_randall_beyond_its_curves);
  CU_ADD_TEST(suite, path_randall_literal);
  CU_ADD_TEST(suite, paths_that_randall_does_not_cover);
}
