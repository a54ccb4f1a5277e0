/* Networks of springs (lattice*.c in cases/refs): the motion of the walls, contacts at the ends of walls, the limits of
 * gaps, forces and steps, and the waves. Expected values come from equilibrium, from a loop over the calculation cycle,
 * or from the formulas of waves.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "lattice.h"
#include "limit.h"
#include "refs_scenes.h"
#include "refs_tables.h"
#include "suites.h"
#include "written.h"

/* ---- the motion of the walls ----------------------------------------------------------------------------------------- */

/* A disc between two walls. Wall w moves from the start; wall e turns about (5, 1), which is 3 from its line. */
#define TURNS(particles, ends, spin)                                                                                   \
  "material m density 2 kn 20\nmaterial a kn 60\nmaterial h density 1 kn 500\nnormal linear\ndisc 0 0 radius 2 "       \
  "m\n" particles "\nwall w -2 -9 to -2 9 a velocity 0.01 0.004\nwall e " ends " a about 5 1 velocity 0.002 -0.003 "   \
  "spin 0.001\nstep 0.25 of "                                                                                          \
  "single-contact\nstage s\ncycles 4\nstage t\nwall e velocity -0.02 0.03 spin " spin "\ncycles 3\nstage u\n"          \
  "wall w velocity -0.05 0\nwall e velocity 0 0 spin 0\ndamping mass 4\ncycles 5\nstage v\nwalls stop\n"               \
  "damping none\ncycles 2\nstage w\nstep 0.5 of single-contact\ncycles 7\n"
static void check_walls(const char *page, size_t w, double dt, double spin, double largest) {
  struct words words = {0};
  struct written it;
  struct lattice lattice;
  struct nb_error error = {0};
  words_add(&words, "units none\n%s", page);
  written_scene(&it, &words);
  CU_ASSERT_EQUAL_FATAL(lattice_build(&lattice, &it.scene, &error), NB_OK);
  /* the velocities of wall w, whose index is given, and of e: x, y and spin of each, in the stages s to w */
  const double velocity[5][6] = {
      {0.01, 0.004, 0, 0.002, -0.003, 0.001}, {0.01, 0.004, 0, -0.02, 0.03, spin}, {-0.05}, {0}, {0},
  };
  const unsigned long cycles[5] = {4, 3, 5, 2, 7};
  double travel[6] = {0};
  unsigned long first = 0;
  CU_ASSERT_EQUAL(lattice.stage_count, 5);
  CU_ASSERT_EQUAL_FATAL(lattice.change_count, 4); /* none in stage w */
  for (size_t s = 0; s < 5; s++) {
    for (size_t j = 0; j < 6; j++) {
      travel[j] += (double)cycles[s] * (s == 4 ? 2 : 1) * dt * velocity[s][j];
      REFS_NEAR(gsl_vector_get(lattice.travel[s], LATTICE_WALL * w + j), travel[j], 1e-14, 1.);
      if (s < 4)
        REFS_NEAR(gsl_vector_get(lattice.changes[s].change, LATTICE_WALL * w + j),
                  velocity[s][j] - (s > 0 ? velocity[s - 1][j] : 0), 1e-15, 1.);
    }
    if (s < 4)
      CU_ASSERT_EQUAL(lattice.changes[s].cycle, first);
    first += cycles[s];
  }
  REFS_NEAR(lattice.step, dt, 1e-15, dt);
  REFS_NEAR(lattice.largest_travel, largest, 1e-14, largest);
  CU_ASSERT(!lattice.one_step);
  CU_ASSERT_EQUAL(lattice.undamped, 7); /* up to the first damping, although it ends */
  CU_ASSERT_EQUAL(lattice.cycles, 21);
  CU_ASSERT_EQUAL(lattice_first_at_rest(&lattice, &it.scene), 3);
  lattice_free(&lattice);
  written_free(&it);
}

/* The single-contact step is that of the lightest free particle and of the stiffest pair of materials, although these
 * belong to other particles, or to a wall. Wall e turns by at most 0.056 dt, and its farthest end is (12^2 + 3^2)^(1/2)
 * from its point P, whichever end comes first; wall w moves by 0.18 dt to the left. */
static void walls_of_stages(void) {
  const double light = 0.5 * sqrt(2 * pi / (2 * 20 * 500 / 520.)), heavy = 0.5 * sqrt(8 * pi / 500);
  check_walls(
      TURNS("disc 90 90 radius 1 m\ndisc 90 -90 radius 0.5 m fixed\nwall f 50 -3 to 50 5 h", "2 -11 to 2 7", "-0.02"),
      1, light, -0.02, 0.056 * light * hypot(12, 3));
  check_walls(
      TURNS("disc 90 90 radius 1 m\ndisc 90 -90 radius 0.5 m fixed\nwall f 50 -3 to 50 5 h", "2 7 to 2 -11", "-0.02"),
      1, light, -0.02, 0.056 * light * hypot(12, 3));
  check_walls(TURNS("disc 90 90 radius 2 m\ndisc 90 -90 radius 0.5 h fixed\ndisc 90 -99 radius 0.5 h fixed",
                    "2 -11 to 2 7", "0.002"),
              0, heavy, 0.002, 0.18 * heavy);
}

/* A disc between springs of 30 and 120/13 in the direction (0.6, 0.8). Wall p moves in stage s and wall q in stage u; the
 * force is that of springs in series. */
#define SLANTED(stages)                                                                                                \
  "material m density 1 kn 20\nmaterial a kn 60\nmaterial b kn 6\nnormal linear\ngrading g 1 5 0.5 2\n"                \
  "disc 3 4 radius 2 m\nwall p (1.8 - 8) (2.4 + 6) to (1.8 + 8) (2.4 - 6) a\n"                                         \
  "wall q (4.2 + 8) (5.6 - 6) to (4.2 - 8) (5.6 + 6) b\nmonitor D disc 1\nmonitor P disc 1 with wall p\nmonitor W "    \
  "wall p\nmonitor Q disc 1 with wall q\nmonitor G grading g radius 0.5\nstep 0.1\n" stages
#define P_MOVES "stage s\nwall p velocity 0.006 0.008\ncycles 4\n"
#define EACH(suffix, force)                                                                                            \
  {"P.normal" suffix, force}, {"P.shear" suffix, 0}, {"Q.normal" suffix, force}, { "Q.shear" suffix, 0 }
static void forces_of_stages(void) {
  const double spring = 1 / (1. / 30 + 13. / 120), s = 0.004 * spring, u = 0.024 * spring;
  VALUES("nine_discs_statics",
         SLANTED(P_MOVES "stage t\nwalls stop\ncycles 2\nstage u\nwall q velocity -0.012 -0.016\nstep 0.2\ncycles 5\n"
                         "stage v\nwalls stop\nuntil D.x above 9 at most 3 cycles\nstage w\ncycles 2\n"),
         1, EACH(" in s", s), EACH(" in t", s), EACH(" in u", u), EACH(" in v", u), EACH(" in w", u),
         EACH(" mean in v", u), EACH(" mean in w", u), EACH("", u), EACH(" mean", u));
  VALUES("nine_discs_statics", SLANTED(P_MOVES), 1, EACH(" in s", s), EACH("", s));
  VALUES("nine_discs_statics", SLANTED(P_MOVES "stage t\nwall p velocity -0.003 -0.004\ncycles 4\n"), 1,
         EACH(" in s", s), EACH(" in t", s / 2), EACH("", s / 2)); /* a wall that moves back is not at rest */
  for (int k = 0; k < 3; k++) {
    static const char *const references[] = {"nine_discs_statics", "nine_discs_slip", "nine_discs_distortion"};
    refs_check_error(references[k],
                     SLANTED(P_MOVES "stage t\nwalls stop\ncycles 2\nstage u\nwall q velocity -0.012 -0.016\n"
                                     "until D.x above 9 at most 3 cycles\nstage v\nwalls stop\ncycles 1\n"),
                     "this reference needs the displacements of the walls: stage u moves them until a condition holds");
    refs_check_error(references[k], SLANTED(P_MOVES "stage t\nwalls stop\nstep 0.1 of stable\ncycles 2\n"),
                     "this reference needs the step as a time or as a fraction of single-contact");
  }
}

/* In stage s of 10 cycles wall w moves by 0.01, and back in stage t. So a gap must be 0 or more than 0.02. */
#define BESIDE(more)                                                                                                   \
  "material m density 1 kn 20\nnormal linear\ndisc 0 0 radius 2 m\n" more "\nwall w -2 -1 to -2 1 m\nwall e 2 -1 to "  \
  "2 1 m\nmonitor W disc 1 with wall w\nstep 0.1\nstage s\nwall w velocity 0.01 0\ncycles 10\nstage t\n"               \
  "wall w velocity -0.01 0\ncycles 10\n"
#define GAP(which, other, gap) GAP_OF("1", which, other, gap)
#define GAP_OF(one, which, other, gap)                                                                                 \
  "this reference is for particles that just touch: the gap between particle " one " and " which " " other " is " gap  \
  " m; it must be 0, or more than twice the displacement of the walls"
static void gaps_that_stay_open(void) {
  static const struct {
    const char *page, *message;
  } rows[] = {
      {BESIDE("disc 0 3.02001 radius 1 m"), NULL},
      {BESIDE("disc 0 3.01999 radius 1 m"), GAP("particle", "2", "0.01999")},
      {BESIDE("disc 0 -3.01999 radius 1 m"), GAP("particle", "2", "0.01999")},
      {BESIDE("disc 9 9 radius 1 m\ndisc 0 (-3 - 1.9e-9) radius 1 m"), NULL},
      {BESIDE("disc 9 9 radius 1 m\ndisc 0 (-3 - 2.1e-9) radius 1 m"), GAP("particle", "3", "2.1e-09")},
      {BESIDE("disc 0 (3 - 1.9e-9) radius 1 m"), NULL},
      {BESIDE("disc 0 (3 - 2.1e-9) radius 1 m"), GAP("particle", "2", "-2.1e-09")},
      {BESIDE("disc 9 9 radius 1 m\ndisc (12 + 0.9e-9) 9 radius 2 m"), NULL}, /* 1e-9 of the radius of disc 2 */
      {BESIDE("disc 9 9 radius 1 m\ndisc (12 + 1.1e-9) 9 radius 2 m"), GAP_OF("2", "particle", "3", "1.1e-09")},
      {BESIDE("wall n -9 2.02001 to 9 2.02001 m"), NULL},
      {BESIDE("wall n -9 2.01999 to 9 2.01999 m"), GAP("wall", "1", "0.01999")},
      {BESIDE("wall n -9 -2.01999 to 9 -2.01999 m"), GAP("wall", "1", "0.01999")},
      {BESIDE("wall n -9 2 to -0.3 2 m"), NULL}, /* (0.3^2 + 2^2)^(1/2) - 2 = 0.02237 */
      {BESIDE("wall n -9 2 to -0.28 2 m"), GAP("wall", "1", "0.0195049")},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    refs_check_error("nine_discs_statics", rows[k].page, rows[k].message);
  refs_check_error("nine_discs_statics",
                   "material m density 1 kn 20\nnormal linear\ndisc 0 0 radius 2 m\nwall w -9 -1 to -9 1 m\n"
                   "step 0.1\nstage s\nwall w velocity 0.01 0\ncycles 10\n",
                   "this reference is for particles in contact; there are no contacts");
}

/* A disc of radius 5 at (1, 2) on the ends of two walls, in the directions (-0.6, -0.8) and (0.6, -0.8), and under a
 * third wall. The force F at the third wall and N at the two ends are in equilibrium if F = 1.6 N, and the displacements
 * d of the wall at each contact, toward the disc, satisfy sum d F = sum F^2/k. Wall l turns by the angle a about (-4, 1),
 * so its end (-2, -2) moves by (3 a, 2 a). */
static void ends_of_walls(void) {
#define ON_ENDS(stages)                                                                                                \
  "material m density 1 kn 20\nmaterial a kn 60\nmaterial b kn 6\nnormal linear\ndisc 1 2 radius 5 m\n"                \
  "wall l -9 -2 to -2 -2 a about -4 1\nwall r 4 -2 to 9 -2 b about 5 9\nwall n -5 7 to 9 7 m\n"                        \
  "monitor L disc 1 with wall l\nmonitor R disc 1 with wall r\nmonitor N disc 1 with wall n\nstep 0.1\n" stages
  const double compliance = (1. / 30 + 13. / 120) / (1.6 * 1.6) + 1. / 20;
  const double s = 0.002 / compliance, t = (0.002 + (0.6 * 0.003 + 0.8 * 0.005) / 1.6) / compliance;
  const double u = t + (0.6 * 3 + 0.8 * 2) * 1e-4 / 1.6 / compliance,
               v = u + (0.6 * -0.002 + 0.8 * 0.003) / 1.6 / compliance;
#define AT_ENDS(suffix, force)                                                                                         \
  {"L.normal" suffix, force / 1.6}, {"R.normal" suffix, force / 1.6}, {"N.normal" suffix, force},                      \
      {"L.shear" suffix, 0}, {"R.shear" suffix, 0}, {"N.shear" suffix, 0}
  VALUES("nine_discs_statics",
         ON_ENDS("stage s\nwall n velocity 0.007 -0.002\ncycles 10\nstage t\nwall n velocity 0 0\n"
                 "wall l velocity 0.003 0.005\ncycles 10\nstage u\nwall l velocity 0 0 spin 1e-4\ncycles 10\n"
                 "stage v\nwall l velocity 0 0 spin 0\nwall r velocity 0.002 0.003\ncycles 10\n"),
         1, AT_ENDS(" in s", s), AT_ENDS(" in t", t), AT_ENDS(" in u", u), AT_ENDS(" in v", v), AT_ENDS("", v));
#undef ON_ENDS
#undef AT_ENDS
}

/* A disc between two plates, of k_n = 15 and k_s = 6, and beside a stop of k_n = 7.5. The plates press it with N and
 * move by 0.001 against the stop: springs of 12 and 7.5 in series, and the two shear forces T are equal. */
#define DRAGGED(friction, cohesion)                                                                                    \
  "material d density 1 kn 10 ks 4 friction 0.9 cohesion 9\nmaterial p kn 30 ks 12 friction " friction                 \
  " cohesion " cohesion "\nmaterial s kn 6\nnormal linear\nshear linear\ndisc 5 7 radius 2 d\nwall low 0 5 to 9 5 p\n" \
  "wall high 0 9 to 9 9 p\nwall stop 3 6 to 3 8 s\nmonitor L disc 1 with wall low\nmonitor H disc 1 with wall high\n"  \
  "monitor S disc 1 with wall stop\nstep 0.1\nstage s\nwall high velocity -0.001 -0.002\n"                             \
  "wall low velocity -0.001 0\ncycles 10\n"
static void friction_and_cohesion(void) {
  const double n = 15 * 0.001, t = 0.001 * 6 / (1 + 12 / 7.5); /* t/n = 0.153846 */
#define HELD(suffix)                                                                                                   \
  {"L.normal" suffix, n}, {"L.shear" suffix, -t}, {"H.normal" suffix, n}, {"H.shear" suffix, t},                       \
      {"S.normal" suffix, 2 * t}, {"S.shear" suffix, 0}
  VALUES("nine_discs_statics", DRAGGED("0", "0.002308"), 1, HELD(" in s"),
         HELD("")); /* cohesion of 0.00230769 holds it */
  VALUES("nine_discs_statics", DRAGGED("0.0539", "0.0015"), 1, HELD(" in s"), HELD("")); /* 0.0015 and 0.0538462 n */
  VALUES("nine_discs_statics", DRAGGED("0", "0"), 1, {"L.normal", n}, {"L.shear", 0}, {"H.normal", n}, {"H.shear", 0},
         {"S.normal", 0}, {"S.shear", 0}, {"L.normal in s", n}, {"L.shear in s", 0}, {"H.normal in s", n},
         {"H.shear in s", 0}, {"S.normal in s", 0}, {"S.shear in s", 0}); /* nothing holds it */
#define SLIPS                                                                                                          \
  "this reference is for contacts that do not slip; the contact of particle 1 with wall 1 slips at cycle 10 (shear "   \
  "over normal force 0.153846)"
  refs_check_error("nine_discs_statics", DRAGGED("0", "0.002307"), SLIPS);
  refs_check_error("nine_discs_statics", DRAGGED("0.0538", "0.0015"), SLIPS);
  refs_check_error("nine_discs_statics", DRAGGED("0.1538", "0"), SLIPS);
  VALUES("nine_discs_statics", DRAGGED("0.1539", "0"), 1, HELD(" in s"), HELD(""));
#undef HELD
#undef SLIPS
}

/* The disc between plates of other frictions and of the shear stiffnesses 6 and 4. Without sliding the shear forces t of
 * the plates are equal, so no moment acts on the disc: t/6 + t/4 = 2 (0.001 - 2 t/7.5), t = 0.14 n. A plate of less
 * friction slides, and the shear force at the other one is as large. */
#define PLATES(low, high, stop, stages)                                                                                \
  "material d density 1 kn 10 ks 4 friction 0.95\nmaterial p kn 30 ks 12 friction " low                                \
  "\nmaterial q kn 30 ks 4 friction " high "\nmaterial s kn 6 " stop                                                   \
  "\nnormal linear\nshear linear\ndisc 5 7 radius 2 d\nwall stop 3 6 to 3 8 s\nwall low 0 5 to 9 5 p\n"                \
  "wall high 0 9 to 9 9 q\nmonitor L disc 1 with wall low\nmonitor H disc 1 with wall high\n"                          \
  "monitor S disc 1 with wall stop\nstep 0.1\nstage s\n" stages
#define BOTH_MOVE "wall high velocity -0.001 -0.002\nwall low velocity -0.001 0\ncycles 10\n"
static void one_plate_slides(void) {
  const double n = 15 * 0.001, t = 0.1 * n;
#define SLIDES(suffix)                                                                                                 \
  {"L.normal" suffix, n}, {"L.shear" suffix, -t}, {"H.normal" suffix, n}, {"H.shear" suffix, t},                       \
      {"S.normal" suffix, 2 * t}, {"S.shear" suffix, 0}
  VALUES("nine_discs_slip", PLATES("0.1", "0.9", "", BOTH_MOVE), 1, SLIDES(" in s"), SLIDES(""));
  VALUES("nine_discs_slip", PLATES("0.9", "0.1", "", BOTH_MOVE), 1, SLIDES(" in s"), SLIDES(""));
  VALUES("nine_discs_slip", PLATES("0.1", "0.1", "", BOTH_MOVE), 1, SLIDES(" in s"), SLIDES(""));
#undef SLIDES
  /* Both forces exceed f n, and both contacts are taken to slide, although one of them holds: a moment remains. In the
   * forces along x and y, and the moment times 2^(1/2)/R, the load is 0.03 (-f_h, -1, 2^(1/2) f_h), and springs cannot
   * balance its component along (0, (f_l + f_h)/2^(1/2), 1). */
  const double l = 0.1, h = 0.12;
  char message[128];
  snprintf(message, sizeof message, "the network has no equilibrium: %g of its load remains",
           (h - l) / sqrt(2 * (1 + 3 * h * h) * (1 + (l + h) * (l + h) / 2)));
  refs_check_error("nine_discs_slip", PLATES("0.1", "0.12", "", BOTH_MOVE), message);
  /* A stop with a shear force takes the moment. Without sliding the fractions of the normal forces are 0.0593 at the lower
   * plate and 0.197 at the upper one. If the upper plate alone slides, 0.0026 remain at the lower one, which then holds. */
  refs_check_error("nine_discs_slip", PLATES("0.05", "0.01", "ks 4 friction 0.9", BOTH_MOVE),
                   "no equilibrium was found: a contact would have to slide against its shear force");
  refs_check_error("nine_discs_slip", PLATES("0.06", "0.01", "ks 4 friction 0.9", BOTH_MOVE), NULL);
}

/* A contact that has opened has no force and no stiffness: after the stop has moved away, the plates press the disc with
 * equal forces. */
static void a_contact_stays_open(void) {
  struct nb_solution solution;
  struct nb_error error = {0};
  CU_ASSERT_EQUAL(refs_solve(&solution, "nine_discs_distortion",
                             PLATES("0.9", "0.9", "ks 4 friction 0.9",
                                    "wall stop velocity -0.01 0\ncycles 10\nstage t\nwalls stop\n"
                                    "wall high velocity 0 -0.002\ncycles 10\n"),
                             &error),
                  NB_OK);
  static const struct expected rows[] = {{"L.normal", 0.015, NULL, 0}, {"H.normal", 0.015, NULL, 0},
                                         {"L.shear", 0, NULL, 0},      {"H.shear", 0, NULL, 0},
                                         {"S.normal", 0, NULL, 0},     {"S.shear", 0, NULL, 0}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    REFS_NEAR(refs_value(&solution, rows[k].name), rows[k].value, 1e-8, 0.015);
  CU_ASSERT_EQUAL(refs_value(&solution, "S.normal in s"), 0);
  solution_free(&solution);
}
#undef BOTH_MOVE
#undef PLATES

/* Without a shear law, cohesion has no effect. */
static void cohesion_without_a_shear_law(void) {
  static const char *const references[] = {"nine_discs", "nine_discs_slip", "nine_discs_distortion"};
  for (int k = 0; k < 3; k++)
    refs_check_error(references[k],
                     "material m density 1 kn 10 ks 4 friction 0.9 cohesion 3\nnormal linear\nshear none\n"
                     "disc 0 0 radius 2 m\nwall w -2 -1 to -2 1 m\nwall e 2 -1 to 2 1 m\nmonitor W disc 1 with wall w\n"
                     "step 0.1\nstage s\nwall w velocity 0.01 0\ncycles 1\n",
                     NULL);
}

/* Wall p is pushed for two cycles; then the disc oscillates. A loop over the calculation cycle gives the first cycle in
 * which the disc leaves wall p, which is at 0.002 from its first place. */
static void contacts_that_open(void) {
#define PUSHED(step, more)                                                                                             \
  "material m density (5/(4*pi)) kn 20\nmaterial a kn 60\nmaterial b kn 6\nnormal linear\ndisc 0 0 radius 2 m\n"       \
  "wall q 2 -9 to 2 9 b\nwall p -2 -9 to -2 9 a\nmonitor P disc 1 with wall p\nmonitor W wall p\nstep " step           \
  "\nstage s\n"                                                                                                        \
  "wall p velocity 0.01 0\ncycles " more
  double x = 0, v = 0;
  int n = 0;
  for (; x <= 0.002; n++)
    v += 0.1 / 5 * (30 * (0.001 * (n < 2 ? n : 2) - x) - 120. / 13 * x), x += 0.1 * v;
  char page[1024], message[256];
  for (int k = 0; k < 3; k++) {
    snprintf(page, sizeof page, PUSHED("0.1", "2\nstage t\nwalls stop\ncycles %d\n"), n - 3 + k * k);
    snprintf(message, sizeof message,
             "this reference is for contacts that stay closed; the contact of particle 1 with wall 2 opens at cycle %d",
             n);
    refs_check_error("nine_discs", page, k ? message : NULL);
  }
  /* While the wall moves there is only the course of the force; a monitor without a contact has no values. */
  VALUES("nine_discs", PUSHED("0.1", "2\n"), 1, {"P.normal", 0, "cycle", 0}, {"P.shear", 0, "cycle", 1},
         {"P.normal", 0, "time", 0}, {"P.shear", 0, "time", 0},
         {"P.normal", 0.06 - 30 * 0.1 * 0.1 / 5 * 0.03, "cycle", 2});
  /* omega^2 = (30 + 120/13)/5, so the longest stable step is 2/omega = 0.714006 */
  refs_check_error("nine_discs", PUSHED("0.714", "1\n"), NULL);
  refs_check_error("nine_discs", PUSHED("0.7141", "1\n"),
                   "the step 0.7141 s is too long for this network: the limit is 0.714006 s");
#undef PUSHED
}

/* ---- waves ----------------------------------------------------------------------------------------------------------- */

enum { MOST_TERMS = 4 };
static struct oscillation *waves(const struct oscillation_term terms[], size_t count) {
  struct oscillation *it = malloc(sizeof *it + MOST_TERMS * sizeof it->terms[0]);
  CU_ASSERT_PTR_NOT_NULL_FATAL(it);
  it->unit = 0.25, it->count = count;
  memcpy(it->terms, terms, count * sizeof *terms);
  return it;
}

/* A line and three waves, two of which have the same phase per cycle and begin at different cycles. Phases are the same if
 * they differ by less than 1e-9 of themselves; here they differ by 0.9e-9, so sums are known to about 1e-9 only. */
static void sums_of_waves(void) {
  const double s3 = sin(0.3), s5 = sin(0.5);
  struct oscillation_term terms[MOST_TERMS] = {
      {2, 3, 0, 0}, {2, 0.5, 0.3, s3}, {5, -0.7, 0.3 * (1 + 0.9e-9), s3}, {7, 0.2, 0.5, s5}};
  struct oscillation *it = waves(terms, MOST_TERMS);
  REFS_NEAR(oscillation_mean(it), -(2 * 3 + 2 * 0.5 - 5 * 0.7 + 7 * 0.2), 1e-14, 1.);
  const double x = 0.5 / s3 * cos(0.6) - 0.7 / s3 * cos(1.5), y = 0.5 / s3 * sin(0.6) - 0.7 / s3 * sin(1.5);
  REFS_NEAR(oscillation_amplitude(it), hypot(x, y) + 0.2 / s5, 1e-8, 1.);
  CU_ASSERT_EQUAL(oscillation_at(it, 0.5), 0);
  REFS_NEAR(oscillation_at(it, 1), 3 * 2 + 0.5 * (2 - sin(0.6) / s3), 1e-12, 1.); /* cycle 4 */
  REFS_NEAR(oscillation_at(it, 2),
            3 * 6 + 0.5 * (6 - sin(1.8) / s3) - 0.7 * (3 - sin(0.9) / s3) + 0.2 * (1 - sin(0.5) / s5), 1e-8, 1.);
  it->terms[2].phase = 0.3 * (1 + 1.1e-9); /* now it is another wave */
  REFS_NEAR(oscillation_amplitude(it), (0.5 + 0.7) / s3 + 0.2 / s5, 1e-12, 1.);
  free(it);
}

/* A wave of amplitude a and phase p dominates if a exceeds the sum of the others, and a p exceeds that of theirs. */
static void the_wave_that_dominates(void) {
  static const struct {
    double amplitude[3], phase[3], dominant;
  } rows[] = {
      {{1}, {0.3}, 0.3},
      {{0}, {0}, 0},
      {{2, 1}, {0.1, 0.3}, 0},              /* 0.3 is the steeper one */
      {{2, 1}, {0.1, 0.19}, 0.1},           /* 0.2 against 0.19 */
      {{1, 2}, {0.3, 0.2}, 0.2},            /* 0.4 against 0.3 */
      {{1, 0.9}, {0.1, 0.5}, 0},            /* each is larger in one respect */
      {{1, -2.1, 1}, {0.1, 0.2, 0.3}, 0.2}, /* 2.1 against 2, 0.42 against 0.4 */
      {{1, 1.9, 1}, {0.1, 0.3, 0.2}, 0},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct oscillation_term terms[MOST_TERMS] = {{0}};
    for (int i = 0; i < 3; i++)
      terms[i] = (struct oscillation_term){0, rows[k].amplitude[i] * 0.7, rows[k].phase[i], 0.7};
    struct oscillation *it = waves(terms, 3);
    REFS_NEAR(oscillation_frequency(it), rows[k].dominant / (2 * pi), 1e-15, 1.);
    free(it);
  }
}

/* ---- rows and sizes -------------------------------------------------------------------------------------------------- */

#define ROW(more, p, q, stages)                                                                                        \
  "material m density 1 kn 20 ks 5 friction 0.1\nmaterial f kn 20\nnormal linear\nshear linear\n"                      \
  "disc 0 0 radius 2 m\n" more "wall p " p " m\nwall q " q " m\nmonitor P disc 1 with wall p\n"                        \
  "step 0.1\nstage s\n" stages "cycles 2\n"
#define SECOND "disc 3 0 radius 1 m\n"
#define BEHIND "-2 -1 to -2 1"
#define AHEAD "4 -1 to 4 1"
#define APPROACH "wall p velocity 0.01 0\nwall q velocity -0.01 0\n"
#define IN_ROW "this reference is for two particles in a row"
#define IN_CONTACT                                                                                                     \
  "this reference is for two particles in contact, with one wall behind each; walls beside them must exert no shear "  \
  "force"
#define EQUAL_SPEEDS "this reference is for two walls that approach with equal speeds from the start"
static void rows_of_two_particles(void) {
  static const struct {
    const char *page, *message;
  } rows[] = {
      {ROW(SECOND, BEHIND, AHEAD, APPROACH), NULL},
      {ROW("", BEHIND, AHEAD, APPROACH), IN_ROW},
      {ROW(SECOND "disc 90 90 radius 1 m\n", BEHIND, AHEAD, APPROACH), IN_ROW},
      {ROW("disc 3.5 0 radius 1 m\n", BEHIND, "4.5 -1 to 4.5 1", APPROACH), IN_CONTACT},
      {ROW(SECOND, BEHIND, "4.5 -1 to 4.5 1", APPROACH), IN_CONTACT},
      {ROW(SECOND, "-2.5 -1 to -2.5 1", AHEAD, APPROACH), IN_CONTACT},
      {ROW(SECOND "wall n -9 2 to 0.5 2 f\nwall o -9 -2 to 0.5 -2 f\n", BEHIND, AHEAD, APPROACH), NULL},
      {ROW(SECOND "wall n -9 2 to 0.5 2 m\n", BEHIND, AHEAD, APPROACH), IN_CONTACT},
      {ROW(SECOND "wall n 2.5 -1 to 9 -1 m\n", BEHIND, AHEAD, APPROACH), IN_CONTACT},
      {ROW(SECOND "wall o -2 -1 to -2 1 m\n", BEHIND, AHEAD, APPROACH), IN_CONTACT},
      {ROW(SECOND "wall o 4 -1 to 4 1 m\n", BEHIND, AHEAD, APPROACH), IN_CONTACT},
      {ROW(SECOND, "(-2 - 1e-8 - 1e-4) -1 to (-2 - 1e-8 + 1e-4) 1", AHEAD, APPROACH), IN_CONTACT}, /* 1 - cos = 5e-9 */
      {ROW(SECOND, "(-2 - 2e-5) -1 to (-2 + 2e-5) 1", AHEAD, APPROACH), NULL},                     /* 2e-10 */
      {ROW(SECOND, BEHIND, "(4 + 5e-9 - 1e-4) -1 to (4 + 5e-9 + 1e-4) 1", APPROACH), IN_CONTACT},
      {ROW(SECOND, BEHIND, AHEAD, ""), EQUAL_SPEEDS},
      {ROW(SECOND, BEHIND, AHEAD, "cycles 1\nstage t\n" APPROACH), EQUAL_SPEEDS},
      {ROW(SECOND, BEHIND, AHEAD, "wall p velocity -0.01 0\nwall q velocity 0.01 0\n"), EQUAL_SPEEDS},
      {ROW(SECOND, BEHIND, AHEAD, "wall p velocity 0 0.01\nwall q velocity 0 -0.01\n"), EQUAL_SPEEDS},
      {ROW(SECOND, BEHIND, AHEAD, "wall p velocity 0.01 0\nwall q velocity -0.01000000002 0\n"), EQUAL_SPEEDS},
      {ROW(SECOND, BEHIND, AHEAD, "wall p velocity 0.01 0\nwall q velocity -0.00999999998 0\n"), EQUAL_SPEEDS},
      {ROW(SECOND, BEHIND, AHEAD, "wall p velocity 0.01 0\nwall q velocity -0.010000000005 0\n"), NULL},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    refs_check_error("two_wall_compression", rows[k].page, rows[k].message);
  for (int k = 0; k < 2; k++) {
    struct nb_solution solution;
    struct nb_error error = {0};
    CU_ASSERT_EQUAL(
        refs_solve(&solution, "two_wall_compression",
                   k ? ROW(SECOND, BEHIND, AHEAD, APPROACH "damping mass 1\ncycles 3\nstage t\nstep 0.2\n")
                     : ROW(SECOND, BEHIND, AHEAD, APPROACH "damping mass 1\ncycles 3\nstage t\ndamping none\n"),
                   &error),
        NB_OK);
    CU_ASSERT_EQUAL(solution.value_count + solution.curve_count, 0); /* damped from the start */
    solution_free(&solution);
  }
  /* One wall moves on alone, so the walls approach by 0.1 (2 * 0.02 + 3 * 0.03): three springs of 20 in series. */
  const double force = 0.013 * 20 / 3;
  VALUES("two_wall_statics",
         ROW(SECOND, BEHIND, AHEAD,
             APPROACH
             "cycles 2\nstage t\nwall p velocity 0.03 0\nwall q velocity 0 0\ncycles 3\nstage u\nwalls stop\n"),
         1, {"P.normal", force}, {"P.normal mean", force}, {"P.overlap", force / 20}, {"P.shear", 0});
  refs_check_message("two_wall_statics", ROW(SECOND, BEHIND, AHEAD, APPROACH), "walls that stop");
}

static void up_to_a_thousand_particles(void) {
#define MANY(one)                                                                                                      \
  "material m density 1 kn 20\nnormal linear\nlattice discs 40 by 25 from 0 0 radius 1 spacing 4 m\n" one              \
  "wall w -9 -9 to -9 -8 m\nstep 0.1\nstage s\ncycles 1\n"
  for (int k = 0; k < 2; k++) {
    const char *const reference = k ? "nine_discs_statics" : "step_limit";
    refs_check_error(reference, MANY(""), "this reference is for particles in contact; there are no contacts");
    refs_check_error(reference, MANY("disc 0 -5 radius 1 m\n"),
                     "this reference is for up to 1000 particles, not for 1001");
  }
#undef MANY
}

/* A fixed particle counts as a contact only of free ones, and a wall behind it changes nothing. Without springs, or if the
 * factor CON1 of forces is 0, no step is too long; with a dashpot of 1e309 N s/m every step is. */
static void steps_without_limit(void) {
#define ON_WALL(kn, damping, more)                                                                                     \
  "material m density 1 kn " kn "\nnormal linear\n" more "disc 0 0 radius 2 m\nwall p -2 -9 to -2 9 m\nstep 0.001\n"   \
  "damping " damping "\nstage s\ncycles 1\n"
#define NO_SPRING "no spring of this scene moves a particle, so no step is too long"
#define NO_STEP "the reference `step_limit` finds no step at which these springs and dashpots are stable"
  nb_references_prepare();
  refs_check_error("step_limit", ON_WALL("20", "none", ""), NULL);
  refs_check_error("step_limit", ON_WALL("0", "none", ""), NO_SPRING);
  refs_check_error("step_limit", ON_WALL("20", "con1 0 as all", ""), NO_SPRING);
  refs_check_error("step_limit", ON_WALL("20", "con1 0 as velocity", ""), NULL);
  refs_check_error("step_limit", ON_WALL("1e10", "stiffness 1e300", ""), NO_STEP);
  refs_check_error("step_limit", ON_WALL("20", "ratio 0.2", "disc -4 0 radius 2 m fixed\nwall q -6 -9 to -6 9 m\n"),
                   NULL);
  struct words words = {0};
  struct written it;
  struct limit limit;
  struct nb_error error = {0};
  words_add(&words, "units none\n%s", ON_WALL("1e10", "stiffness 1e300", ""));
  written_scene(&it, &words);
  CU_ASSERT_EQUAL_FATAL(limit_build(&limit, &it.scene, &it.scene.damping, 1e-9, &error), NB_OK);
  CU_ASSERT(isnan(limit_of_cycle(&limit)) && isnan(limit_of_modes(&limit)));
  CU_ASSERT(isnan(limit_of_contacts(&limit, &it.scene)));
  limit_free(&limit);
  written_free(&it);
#undef ON_WALL
#undef NO_SPRING
#undef NO_STEP
  /* the load is 1e160 * 3e154 N */
  refs_check_error("nine_discs_statics",
                   "material m density 1 kn 1e160\nnormal linear\ndisc 0 0 radius 2 m\nwall p -2 -9 to -2 9 m\n"
                   "wall q 2 -9 to 2 9 m\nstep 1\nstage s\nwall p velocity 1e154 0\ncycles 3\n",
                   "the network cannot be solved: its stiffnesses or masses differ too much or are too large");
}

/* A disc between walls in any direction: nothing resists its motion along the walls, or its rotation. */
static void walls_in_any_direction(void) {
  for (int k = 0; k < 100; k++) {
    const double c = cos(0.0628 * k), s = sin(0.0628 * k);
    char page[1024];
    snprintf(page, sizeof page,
             "material m density 1 kn 20\nnormal linear\ndisc 3 4 radius 2 m\nwall p %.17g %.17g to %.17g %.17g m\n"
             "wall q %.17g %.17g to %.17g %.17g m\nmonitor P disc 1 with wall p\nstep 0.1\nstage s\n"
             "wall p velocity %.17g %.17g\ncycles 4\n",
             3 - 2 * c - 9 * s, 4 - 2 * s + 9 * c, 3 - 2 * c + 9 * s, 4 - 2 * s - 9 * c, 3 + 2 * c + 9 * s,
             4 + 2 * s - 9 * c, 3 + 2 * c - 9 * s, 4 + 2 * s + 9 * c, 0.01 * c, 0.01 * s);
    VALUES("nine_discs_statics", page, 1, {"P.normal", 0.04}, {"P.shear", 0}, {"P.normal in s", 0.04},
           {"P.shear in s", 0});
  }
}

void suite_refs_networks(void) {
  CU_pSuite suite = CU_add_suite("refs_networks", NULL, refs_released);
  CU_ADD_TEST(suite, walls_of_stages);
  CU_ADD_TEST(suite, forces_of_stages);
  CU_ADD_TEST(suite, gaps_that_stay_open);
  CU_ADD_TEST(suite, ends_of_walls);
  CU_ADD_TEST(suite, friction_and_cohesion);
  CU_ADD_TEST(suite, one_plate_slides);
  CU_ADD_TEST(suite, a_contact_stays_open);
  CU_ADD_TEST(suite, cohesion_without_a_shear_law);
  CU_ADD_TEST(suite, contacts_that_open);
  CU_ADD_TEST(suite, sums_of_waves);
  CU_ADD_TEST(suite, the_wave_that_dominates);
  CU_ADD_TEST(suite, rows_of_two_particles);
  CU_ADD_TEST(suite, up_to_a_thousand_particles);
  CU_ADD_TEST(suite, steps_without_limit);
  CU_ADD_TEST(suite, walls_in_any_direction);
}
