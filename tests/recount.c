/* The measures of a region, computed again from the snapshot of the same time. Every sum over the region is computed
 * from the tables of particles and contacts, by its definition and not by the code of the simulator.
 *
 * Tolerance: 1e-11 of the size of the sum, which has about a hundred terms rounded to 1e-16.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "recount.h"
#include "suites.h"

/* Compares the last value of a measure of region B with the value that is wanted. `size` is the size of the sum. */
static void near_(const struct nb_result *result, const char *name, double wanted, double size) {
  char text[128];
  snprintf(text, sizeof text, "B.%s", name);
  const double seen = written_last(result, text);
  if (!(fabs(seen - wanted) <= 1e-11 * (size + fabs(wanted))))
    printf("# %s: %.17g, wanted %.17g\n", text, seen, wanted);
  CU_ASSERT(fabs(seen - wanted) <= 1e-11 * (size + fabs(wanted)));
}

/* ---- sums over the region ---- */

/* Sums over directions e: of their weights, and of the weights times e_i e_j and e_i e_j e_k e_l. */
struct sums {
  double weight, second[4], fourth[5];
};

static void add_direction(struct sums *sums, double weight, double ex, double ey) {
  const double e[] = {ex, ey};
  sums->weight += weight;
  for (int i = 0; i < 2; i++)
    for (int j = 0; j < 2; j++)
      sums->second[2 * i + j] += weight * e[i] * e[j];
  for (int k = 0; k < 5; k++)
    sums->fourth[k] += weight * pow(ex, 4 - k) * pow(ey, k);
}

static void tensor_near(const struct nb_result *result, const char *stem, const double t[], double size) {
  static const char *const parts[] = {"xx", "xy", "yx", "yy"};
  for (int k = 0; k < 4; k++) {
    char name[64];
    snprintf(name, sizeof name, "%s.%s", stem, parts[k]);
    near_(result, name, t[k], size);
  }
}

static void directions_near(const struct nb_result *result, const char *stem, struct sums *sums) {
  CU_ASSERT(sums->weight > 0);
  for (int k = 0; k < 4; k++)
    sums->second[k] /= sums->weight;
  tensor_near(result, stem, sums->second, 1);
}

static void fourth_near(const struct nb_result *result, const char *stem, const struct sums *sums) {
  static const char *const parts[] = {"xxxx", "xxxy", "xxyy", "xyyy", "yyyy"};
  for (int k = 0; k < 5; k++) {
    char name[64];
    snprintf(name, sizeof name, "%s.fourth.%s", stem, parts[k]);
    near_(result, name, sums->fourth[k] / sums->weight, 1);
  }
}

static double mean_of(const double values[], int count) {
  double sum = 0;
  for (int k = 0; k < count; k++)
    sum += values[k];
  return sum / count;
}

static void spread_near(const struct nb_result *result, const char *stem, const double values[], int count) {
  double low = INFINITY, high = -INFINITY, square = 0;
  const double mean = mean_of(values, count);
  for (int k = 0; k < count; k++)
    low = fmin(low, values[k]), high = fmax(high, values[k]), square += (values[k] - mean) * (values[k] - mean);
  const double wanted[] = {mean, high, low, sqrt(square / count)};
  static const char *const parts[] = {"mean", "max", "min", "std"};
  for (int k = 0; k < 4; k++) {
    char name[64];
    snprintf(name, sizeof name, "%s.%s", stem, parts[k]);
    near_(result, name, wanted[k], fabs(mean));
  }
}

/* The end of a contact at a particle inside the region. */
struct end {
  double ex, ey; /* contact normal, outward from the particle */
  double arm;    /* distance from the centre to the contact */
  double total_normal, total_shear;
  double near; /* 1: at 0.99 of the friction limit or more */
};

/* Writes all contact ends in the region to `ends`, and returns their number. */
static int ends_of(struct end ends[], const struct nb_table *table, const struct particles *all) {
  int count = 0;
  for (size_t c = 0; c < table->row_count; c++)
    for (int second = 0; second < 2; second++) {
      const int particle = (int)of(table, c, second ? "b" : "a"), wall = (int)of(table, c, "wall");
      if (!particle || !all->of[particle].inside)
        continue;
      const double sign = second ? -1 : 1, overlap = of(table, c, "overlap");
      ends[count++] = (struct end){
          sign * of(table, c, "ex"), sign * of(table, c, "ey"), all->of[particle].r - (wall ? overlap : overlap / 2),
          of(table, c, "normal"),    of(table, c, "shear"),     of(table, c, "obliquity") >= 0.99};
    }
  return count;
}

static void stress_and_fabric(void) {
  struct written it;
  struct nb_result result;
  struct particles all;
  struct end ends[200];
  struct sums plain = {0}, normal = {0}, shear = {0}, sliding = {0};
  double parts[4][4] = {{0}}, whole[4] = {0}, mean = 0; /* normal, shear, fabric, variation */
  made(&it, &result);
  read_particles(&all, &result.snapshots[0].particles);
  const double volume = pi * reach * reach * all.thickness;
  const int count = ends_of(ends, &result.snapshots[0].contacts, &all);
  for (int k = 0; k < count; k++)
    mean += ends[k].total_normal / count;
  for (int k = 0; k < count; k++) {
    const double e[] = {ends[k].ex, ends[k].ey}, t[] = {ends[k].ey, -ends[k].ex}, per = ends[k].arm / volume;
    for (int i = 0; i < 2; i++)
      for (int j = 0; j < 2; j++) {
        parts[0][2 * i + j] += ends[k].total_normal * e[i] * e[j] * per,
            parts[1][2 * i + j] += ends[k].total_shear * t[i] * e[j] * per;
        parts[2][2 * i + j] += mean * e[i] * e[j] * per,
            parts[3][2 * i + j] += (ends[k].total_normal - mean) * e[i] * e[j] * per;
        whole[2 * i + j] += (ends[k].total_normal * e[i] + ends[k].total_shear * t[i]) * e[j] * per;
      }
    add_direction(&plain, 1, e[0], e[1]), add_direction(&normal, ends[k].total_normal, e[0], e[1]);
    add_direction(&shear, fabs(ends[k].total_shear), e[0], e[1]), add_direction(&sliding, ends[k].near, e[0], e[1]);
  }
  static const char *const names[] = {"stress.normal", "stress.shear", "stress.fabric", "stress.variation"};
  const double apart = whole[0] - whole[3], mixed = whole[1] + whole[2], size = whole[0] + whole[3];
  tensor_near(&result, "stress", whole, size), tensor_near(&result, "stress.contacts", whole, size);
  for (int k = 0; k < 4; k++) {
    char name[64];
    const double along = (parts[k][0] - parts[k][3]) * apart + (parts[k][1] + parts[k][2]) * mixed;
    tensor_near(&result, names[k], parts[k], size);
    snprintf(name, sizeof name, "%s.fraction", names[k]);
    near_(&result, name, along / (apart * apart + mixed * mixed), 1);
  }
  near_(&result, "stress.mean", size / 2, size);
  near_(&result, "stress.sinphi", sqrt(apart * apart + mixed * mixed) / size, 1);
  directions_near(&result, "fabric", &plain), directions_near(&result, "fabric.normal", &normal);
  directions_near(&result, "fabric.shear", &shear), directions_near(&result, "fabric.sliding", &sliding);
  fourth_near(&result, "fabric", &plain), fourth_near(&result, "fabric.sliding", &sliding);
  near_(&result, "fabric.kk", count * all.radius / volume, 1);
  near_(&result, "area", pi * reach * reach, 1);
  near_(&result, "particles", all.count, 0);
  near_(&result, "coordination", count / all.count, 0);
  nb_result_free(&result), written_free(&it);
}

/* ---- distributions over the directions, moduli, constraints ---- */

/* The anisotropy coefficients by their definitions. The angles of the contacts give a and its direction, and thus the
 * fitted density of contacts. Each force is divided by the density at its angle; a_n and a_t are the Fourier coefficients
 * of these quotients. */
static void distributions(void) {
  struct written it;
  struct nb_result result;
  struct particles all;
  struct end ends[200];
  made(&it, &result);
  read_particles(&all, &result.snapshots[0].particles);
  const int count = ends_of(ends, &result.snapshots[0].contacts, &all);
  double ac = 0, as = 0, mean = 0, nc = 0, ns = 0, tc = 0, ts = 0;
  for (int k = 0; k < count; k++) {
    const double theta = atan2(ends[k].ey, ends[k].ex);
    ac += 2 * cos(2 * theta) / count, as += 2 * sin(2 * theta) / count;
  }
  const double a = hypot(ac, as), axis = atan2(as, ac) / 2;
  CU_ASSERT(count > 30 && a > 0.01 && a < 1);
  for (int k = 0; k < count; k++) {
    const double theta = atan2(ends[k].ey, ends[k].ex), density = 1 + a * cos(2 * (theta - axis));
    const double N = ends[k].total_normal / density / count, T = ends[k].total_shear / density / count;
    mean += N, nc += 2 * N * cos(2 * theta), ns += 2 * N * sin(2 * theta);
    tc += 2 * T * sin(2 * theta), ts -= 2 * T * cos(2 * theta);
  }
  nc /= mean, ns /= mean, tc /= mean, ts /= mean;
  CU_ASSERT(hypot(tc, ts) > 0.01);
  near_(&result, "anisotropy.contacts", a, 1), near_(&result, "anisotropy.normal", hypot(nc, ns), 1);
  near_(&result, "anisotropy.shear", hypot(tc, ts), 1);
  near_(&result, "anisotropy.sinphi", hypot(ac + nc + tc, as + ns + ts) / (2 + ac * nc + as * ns), 1);
  nb_result_free(&result), written_free(&it);
}

/* Hertz: k_n = 3/2 N/alpha = 2 G a/(1 - nu). Mindlin without slip: k_s = 4 G a/(2 - nu) = 2 (1 - nu)/(2 - nu) k_n. */
static void moduli(void) {
  struct written it;
  struct nb_result result;
  struct particles all;
  double bulk = 0, shear = 0, stress = 0, compliance = 0, at_walls = 0, unequal = 0;
  made(&it, &result);
  read_particles(&all, &result.snapshots[0].particles);
  const struct nb_table *table = &result.snapshots[0].contacts;
  for (size_t c = 0; c < table->row_count; c++) {
    const int a = (int)of(table, c, "a"), b = (int)of(table, c, "b"), wall = (int)of(table, c, "wall");
    const double overlap = of(table, c, "overlap"), kn = 1.5 * of(table, c, "normal") / overlap;
    const double twice = 2 * atan2(of(table, c, "ey"), of(table, c, "ex")), each = wall ? overlap : overlap / 2;
    const double arm_a = all.of[a].r - each, arm_b = wall ? 0 : all.of[b].r - each, l = arm_a + arm_b;
    const double inside = (all.of[a].inside ? arm_a : 0) + (!wall && all.of[b].inside ? arm_b : 0);
    at_walls += wall && all.of[a].inside;
    unequal += !wall && all.of[a].inside != all.of[b].inside && all.of[a].r != all.of[b].r;
    const double ks = kn * 2 * 0.75 / 1.75, N = of(table, c, "normal"), T = of(table, c, "shear");
    bulk += inside * l * kn;
    stress += inside * N / 2, compliance += inside / l * (N * N / kn + T * T / ks);
    shear += inside * l * kn * (pow(cos(twice), 2) + 2 * 0.75 / 1.75 * pow(sin(twice), 2));
  }
  const double volume = pi * reach * reach * all.thickness;
  CU_ASSERT(bulk > shear && shear > 0);
  CU_ASSERT(at_walls > 0 && unequal > 0);
  stress /= volume;
  CU_ASSERT(stress * stress * volume / compliance < bulk / (4 * volume));
  near_(&result, "modulus.bulk.lower", stress * stress * volume / compliance, 1);
  near_(&result, "modulus.bulk", bulk / (4 * volume), 1), near_(&result, "modulus.shear", shear / (4 * volume), 1);
  nb_result_free(&result), written_free(&it);
}

/* The constraint ratio is the number of constraints over the number of degrees of freedom. First, free particles with
 * fewer than two contacts are removed until none is left. All contacts have friction, so each of the other free particles
 * in the region has three degrees of freedom. Each of their contacts is one constraint if it slides, and two if not. */
static void constraints(void) {
  struct written it;
  struct nb_result result;
  struct particles all;
  bool out[PARTICLES] = {false};
  made(&it, &result);
  read_particles(&all, &result.snapshots[0].particles);
  const struct nb_table *table = &result.snapshots[0].contacts;
  for (bool more = true; more;) {
    int touching[PARTICLES] = {0};
    more = false;
    for (size_t c = 0; c < table->row_count; c++) {
      const int a = (int)of(table, c, "a"), b = (int)of(table, c, "b"); /* b is 0 for a wall */
      touching[a] += !b || !out[b], touching[b] += b && !out[a];
    }
    for (int n = 1; n < PARTICLES; n++)
      if (all.of[n].there && !all.of[n].fixed && !out[n] && touching[n] < 2)
        out[n] = more = true;
  }
  double degrees = 0, count = 0, rattlers = 0, sliding = 0;
  for (int n = 1; n < PARTICLES; n++) {
    const bool inside = all.of[n].inside && all.of[n].there && !all.of[n].fixed;
    degrees += inside && !out[n] ? 3 : 0, rattlers += inside && out[n];
  }
  for (size_t c = 0; c < table->row_count; c++) {
    const int a = (int)of(table, c, "a"), b = (int)of(table, c, "b");
    const bool one = all.of[a].inside && !all.of[a].fixed, two = b && all.of[b].inside && !all.of[b].fixed;
    if (out[a] || (b && out[b]) || (!one && !two))
      continue;
    sliding += of(table, c, "sliding"), count += of(table, c, "sliding") > 0 ? 1 : 2;
  }
  CU_ASSERT(sliding > 0 && rattlers > 0 && degrees > 20);
  near_(&result, "constraint_ratio", count / degrees, 1);
  nb_result_free(&result), written_free(&it);
}

/* Without friction a disc on two others that are fixed has two contacts for its two degrees of freedom; a wall that
 * touches it is the third contact. With friction at the two contacts with discs, but not at the wall, there are five
 * constraints for three degrees of freedom. A rattler is the last disc, or the first one. */
static void constraints_of_a_disc(void) {
  static const char *const walls[] = {"", "wall w 9 3.6 to 0 3.6 m\n",
                                      ("material s density 1 kn 7\nwall w 9 3.6 to 0 3.6 s\npair m m friction 1\n"
                                       "shear linear\n")};
  static const double ratios[] = {1, 1.5, 5. / 3};
  static const char rattler[] = "disc 8 8 radius 1 m\n";
  for (size_t n = 0; n < 2 * sizeof walls / sizeof *walls; n++) {
    const size_t k = n / 2;
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(
        &page,
        "units none\nmaterial m density 1 kn 7 ks 7\nstep 0.001\n%sdisc 1 1 radius 1 m fixed\ndisc 3 1 radius 1 m "
        "fixed\ndisc 2 2.7 radius 1 m\n%s",
        n % 2 ? rattler : "", n % 2 ? "" : rattler);
    words_add(&page, "%sregion B all\nrecord B.constraint_ratio B.rattlers\nstage a\ncycles 1\n", walls[k]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    CU_ASSERT_EQUAL(written_last(&result, "B.constraint_ratio"), ratios[k]);
    CU_ASSERT_EQUAL(written_last(&result, "B.rattlers"), 1);
    nb_result_free(&result), written_free(&it);
  }
}

static void loads(void) {
  struct written it;
  struct nb_result result;
  struct particles all;
  static const char *const columns[] = {"normal", "shear", "normal_stress", "shear_stress", "ratio", "obliquity"};
  static const char *const names[] = {"normal",        "shear",         "contact_stress",
                                      "contact_shear", "contact_ratio", "obliquity"};
  double values[6][100], sliding = 0, near_limit = 0, force = 0, speed = 0, fastest = 0;
  int count = 0;
  made(&it, &result);
  read_particles(&all, &result.snapshots[0].particles);
  const struct nb_table *table = &result.snapshots[0].contacts, *particles = &result.snapshots[0].particles;
  for (size_t c = 0; c < table->row_count; c++) {
    const int a = (int)of(table, c, "a"), b = (int)of(table, c, "b");
    const bool one = all.of[a].inside, two = b && all.of[b].inside;
    if (!one && !two)
      continue;
    for (int k = 0; k < 6; k++)
      values[k][count] = fabs(of(table, c, columns[k]));
    count++;
    sliding += of(table, c, "sliding"), near_limit += of(table, c, "obliquity") >= 0.99;
  }
  for (int k = 0; k < 6; k++)
    spread_near(&result, names[k], values[k], count);
  for (size_t k = 0; k < particles->row_count; k++) {
    const struct particle *b = &all.of[(int)of(particles, k, "particle")];
    const double mass = 4. / 3 * pi * b->r * b->r * b->r * 3, v = hypot(of(particles, k, "vx"), of(particles, k, "vy"));
    if (b->inside && !b->fixed)
      force += hypot(b->fx + 3 * mass, b->fy - 9 * mass), speed += v, fastest = fmax(fastest, v);
  }
  CU_ASSERT(sliding > 1 && sliding < count && near_limit > sliding - 1);
  near_(&result, "sliding", sliding / count, 0), near_(&result, "sliding.near", near_limit / count, 0);
  near_(&result, "contacts", count, 0);
  near_(&result, "unbalanced.force", force / all.free, 0);
  near_(&result, "unbalanced.mean", force / all.free / mean_of(values[0], count), 0);
  near_(&result, "speed.mean", speed / all.free, 0), near_(&result, "speed.max", fastest, 0);
  nb_result_free(&result), written_free(&it);
}

void suite_recount(void) {
  CU_pSuite suite = CU_add_suite("recount", NULL, NULL);
  CU_ADD_TEST(suite, stress_and_fabric);
  CU_ADD_TEST(suite, distributions);
  CU_ADD_TEST(suite, moduli);
  CU_ADD_TEST(suite, constraints);
  CU_ADD_TEST(suite, constraints_of_a_disc);
  CU_ADD_TEST(suite, loads);
}
