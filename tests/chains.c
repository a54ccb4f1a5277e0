/* Force chains with known measures: rows, zigzags and hexagonal lattices.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>

#include "../src/core/model.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

static const double pi = 3.14159265358979323846;

/* Tests the measures of the chains of all particles on this page. `bend` is the mean angle between links. */
static void is(struct words *page, double chains, double length, double fraction, double bend) {
  struct written it;
  words_add(page, "region A all\nrecord A.chains A.chains.length A.chains.fraction A.chains.bend\nstage s\ncycles 1\n");
  written_scene(&it, page);
  for (int shuffle = 0; shuffle < 2; shuffle++) {
    struct nb_model *model = written_model(&it, &(struct nb_options){.shuffle = shuffle});
    CU_ASSERT_EQUAL(written_now(model, "A.chains"), chains);
    CU_ASSERT_EQUAL(written_now(model, "A.chains.length"), length);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.chains.fraction"), fraction, 1e-15);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.chains.bend"), bend, 1e-12);
    nb_model_free(model);
  }
  written_free(&it);
}

static const char *transform = ""; /* the statement of that name, for all pages */
static struct words begin(void) {
  struct words page = {0};
  words_add(&page, "units none\n%smaterial m density 1 kn 10\nstep 0.001\nallow unstable\n", transform);
  return page;
}

/* Two rows between walls, one of five discs and one of two spheres, and three discs without contacts. Two particles are
 * no chain. */
static void rows(void) {
  struct words page = begin();
  words_add(&page, "lattice discs 1 by 5 from 0 0 radius 1 spacing 1.99 m\nwall s -1 -0.99 to 5 -0.99 m\n"
                   "wall n -1 8.95 to 5 8.95 m\nsphere 4 0 radius 1 m\nsphere 4 1.99 radius 1 m\n"
                   "wall t 3 2.98 to 5 2.98 m\nlattice discs 1 by 3 from 20 0 radius 1 spacing 3 m\n");
  is(&page, 1, 5, 0.5, 0);
}

/* A row of four discs. A fifth disc touches the end of the row at 30 degrees to it, but its stress is too small for the
 * chain, so the chain has no bend. The fifth disc has the smallest number, then the largest one. */
static void a_weak_neighbour_is_no_link(void) {
  for (int last = 0; last < 2; last++) {
    struct words page = begin();
    char weak[80];
    snprintf(weak, sizeof weak, "disc %.17g %.17g radius 1 m\n", -1.99 * sin(pi / 6), -1.99 * cos(pi / 6));
    words_add(&page,
              "%slattice discs 1 by 4 from 0 0 radius 1 spacing 1.9 m\n%s"
              "lattice discs 1 by 3 from 20 0 radius 1 spacing 3 m\n",
              last ? "" : weak, last ? weak : "");
    is(&page, 1, 4, 0.5, 0);
  }
}

/* Fixed particles are in no chain; without free particles the fraction is 0. */
static void all_fixed(void) {
  struct words page = begin();
  words_add(&page, "disc 0 0 radius 1 m fixed\ndisc 1.99 0 radius 1 m fixed\n");
  is(&page, 0, 0, 0, 0);
}

/* A zigzag of nine discs between walls, with links at the angle phi to the axis; a disc without contacts lowers the
 * mean stress. Below 30 degrees cos 2 phi > sin phi: the major principal stress of each disc is along the zigzag, and
 * successive links form the angle 2 phi. Above 30 degrees the side walls cause the larger stress, and there is no
 * chain. */
static void zigzags(void) {
  for (int degrees = 0; degrees <= 40; degrees += 4) {
    const double phi = degrees * pi / 180, s = 1.999, wall = 2 * 0.001 * sin(phi); /* overlap at a side wall */
    struct words page = begin();
    for (int k = 0; k < 9; k++)
      words_add(&page, "disc %.17g %.17g radius 1 m\n", k % 2 ? s * sin(phi) : 0, k * s * cos(phi));
    words_add(&page, "wall w %.17g -2 to %.17g 18 m\nwall e %.17g -2 to %.17g 18 m\n", -1 + wall, -1 + wall,
              s * sin(phi) + 1 - wall, s * sin(phi) + 1 - wall);
    words_add(&page, "wall s -2 %.17g to 4 %.17g m\nwall n -2 %.17g to 4 %.17g m\n", -1 + 0.001 * cos(phi),
              -1 + 0.001 * cos(phi), 8 * s * cos(phi) + 1 - 0.001 * cos(phi), 8 * s * cos(phi) + 1 - 0.001 * cos(phi));
    words_add(&page, "disc 40 0 radius 1 m\n");
    if (degrees < 30)
      is(&page, 1, 9, 0.9, 2 * phi);
    else
      is(&page, 0, 0, 0, 0);
  }
}

/* A hexagonal lattice in a periodic cell that is shortened by a thousandth along one axis. If it is shortened across
 * the rows, every particle has two links ahead and two behind: half of the pairs of links are straight, and half
 * bend from one side to the other. If it is shortened along the rows, the chains are straight. A small disc in a
 * void has no contacts. */
static void hexagonal(void) {
  const double squeezed = 0.999, high = sqrt(3) * squeezed;
  struct words page = begin(), other = begin();
  words_add(&page, "periodic cell 0 0 to 8 %.17g\n", 4 * high),
      words_add(&other, "periodic cell 0 0 to %.17g %.17g\n", 8 * squeezed, 4 * sqrt(3));
  for (int row = 0; row < 4; row++)
    for (int k = 0; k < 4; k++) {
      words_add(&page, "disc %.17g %.17g radius 1 m\n", 2 * k + row % 2 + 0.25, (row + 0.5) * high);
      words_add(&other, "disc %.17g %.17g radius 1 m\n", squeezed * (2 * k + row % 2 + 0.25), (row + 0.5) * sqrt(3));
    }
  words_add(&page, "disc 1.25 %.17g radius 0.1 m\n", 0.5 * high + high / 3);
  words_add(&other, "disc %.17g %.17g radius 0.1 m\n", 1.25 * squeezed, (0.5 + 1. / 3) * sqrt(3));
  is(&page, 1, 16, 16. / 17, atan2(1, high));
  is(&other, 4, 4, 16. / 17, 0);
}

/* `page`: a particle is pressed against a row from the side. Its contact lies along the major principal stress of the
 * particle, but not along that of the disc of the row. A second row has a stress below the mean. So only the first row
 * is a chain. `leaning`: an inclined row. */
static void along_and_above(void) {
  struct words page = begin(), leaning = begin();
  words_add(&page, "lattice discs 3 by 1 from 0 0 radius 1 spacing 1.99 m\nwall w -0.99 -0.8 to -0.99 0.8 m\n"
                   "wall e 4.97 -0.8 to 4.97 0.8 m\ndisc 1.99 1.992 radius 1 m\nwall n 1 2.984 to 3 2.984 m\n"
                   "wall s 1 -0.992 to 3 -0.992 m\n"
                   "lattice discs 3 by 1 from 20 0 radius 1 spacing 1.998 m\nwall ww 19.002 -1 to 19.002 1 m\n"
                   "wall ee 24.994 -1 to 24.994 1 m\nlattice discs 4 by 1 from 40 0 radius 1 spacing 3 m\n");
  is(&page, 1, 3, 3. / 11, 0);
  for (int k = 0; k < 5; k++)
    words_add(&leaning, "disc %.17g %.17g radius 1 m%s\n", 1.99 * k * cos(pi / 6), 1.99 * k * sin(pi / 6),
              k % 4 ? "" : " fixed");
  words_add(&leaning, "disc 40 0 radius 1 m\n");
  is(&leaning, 1, 3, 0.75, 0);
}

/* Two equal rows; in one of them the middle disc rotates. Shear forces T = 3 N then increase the major stress of this
 * row by the factor (1 + sqrt(1 + (T/N)^2))/2, so the stress of the other row is below the mean. */
static void shear_counts(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, "units none\nmaterial m density 1 kn 10 ks 10 friction 3\nnormal linear\nshear linear\nstep 0.001\n"
                   "disc 0 0 radius 1 m\ndisc 1.99 0 radius 1 m spin 1000\ndisc 3.98 0 radius 1 m\n"
                   "wall w -0.99 -1 to -0.99 1 m\nwall e 4.97 -1 to 4.97 1 m\n"
                   "lattice discs 3 by 1 from 20 0 radius 1 spacing 1.99 m\nwall ww 19.01 -1 to 19.01 1 m\n"
                   "wall ee 24.97 -1 to 24.97 1 m\ndisc 40 0 radius 1 m\nregion A all\nrecord A.chains "
                   "A.chains.fraction\nstage s\ncycles 1\nstage t\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL(written_now(model, "A.chains"), 2);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  written_cycles(model, 1);
  CU_ASSERT_EQUAL(written_now(model, "A.chains"), 1);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.chains.fraction"), 3 / 7., 1e-15);
  nb_model_free(model);
  written_free(&it);
}

/* The stress of a particle is inversely proportional to its volume, 4/3 pi r^3 for a sphere and pi r^2 times 1 m for a
 * disc. Three spheres with 4/3 r times the overlap of four discs have the same stress as these discs. The spheres are
 * the chain if their overlap is larger by a thousandth; the discs are the chain if it is smaller by a thousandth. The
 * overlaps of about 1e-5 shorten the lever arms by much less. */
static void volumes_count(void) {
  for (int more = -1; more <= 1; more += 2) {
    struct words page = begin();
    const double radius = 1.5, disc = 1e-5, sphere = disc * 4 / 3 * radius * (1 + 1e-3 * more);
    const double tall = 2 * radius - disc, taller = 2 * radius - sphere;
    words_add(&page, "lattice discs 1 by 4 from 0 0 radius %.17g spacing %.17g m\n", radius, tall);
    words_add(&page, "wall s -2 %.17g to 2 %.17g m\n", disc - radius, disc - radius);
    words_add(&page, "wall n -2 %.17g to 2 %.17g m\n", 3 * tall + radius - disc, 3 * tall + radius - disc);
    for (int k = 0; k < 3; k++)
      words_add(&page, "sphere 20 %.17g radius %.17g m\n", k * taller, radius);
    words_add(&page, "wall ss 18 %.17g to 22 %.17g m\n", sphere - radius, sphere - radius);
    words_add(&page, "wall nn 18 %.17g to 22 %.17g m\n", 2 * taller + radius - sphere, 2 * taller + radius - sphere);
    is(&page, 1, more > 0 ? 3 : 4, more > 0 ? 3 / 7. : 4 / 7., 0);
  }
}

/* Fixed particles and particles outside the region are in no chain. */
static void fixed_and_outside_particles(void) {
  struct words page = begin();
  struct written it;
  words_add(
      &page,
      "lattice discs 1 by 4 from 0 0 radius 1 spacing 1.99 m\ndisc 0 7.96 radius 1 m fixed\n"
      "disc 0 -1.99 radius 1 m fixed\ndisc 40 0 radius 1 m\nregion B box -1 -1 to 50 5\nrecord B.chains.length\n");
  struct words copy = {0};
  words_add(&copy, "%s", page.text);
  is(&page, 1, 4, 0.8, 0);
  words_add(&copy, "stage s\ncycles 1\n");
  written_scene(&it, &copy);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL(written_now(model, "B.chains.length"), 3);
  nb_model_free(model);
  written_free(&it);
}

/* A fixed disc in the middle of a row has the same stress as the other discs, but it separates two chains. */
static void fixed_between(void) {
  struct words page = begin();
  for (int k = 0; k < 7; k++)
    words_add(&page, "disc 0 %.17g radius 1 m%s\n", 1.99 * k, k == 3 ? " fixed" : "");
  words_add(&page, "wall s -1 -0.99 to 1 -0.99 m\nwall n -1 12.93 to 1 12.93 m\ndisc 40 0 radius 1 m\n");
  is(&page, 2, 3, 6 / 7., 0);
}

/* Four discs in a row that bends by 10 degrees at the second disc and by 30 degrees at the third. The mean bend is 20
 * degrees. */
static void two_bends(void) {
  struct words page = begin();
  static const double directions[] = {0, 10, 40};
  double x = 0, y = 0;
  for (int n = 0; n < 4; n++) {
    words_add(&page, "disc %.17g %.17g radius 1 m\n", x, y);
    x += n < 3 ? 1.99 * cos(directions[n] * pi / 180) : 0, y += n < 3 ? 1.99 * sin(directions[n] * pi / 180) : 0;
  }
  words_add(&page, "lattice discs 1 by 3 from 20 0 radius 1 spacing 3 m\n");
  is(&page, 1, 4, 4 / 7., 20 * pi / 180);
}

/* In a cell, discs in a row, and in a square lattice with a small disc that has no contacts. All numbers are exact.
 * In the row all stresses are equal, so none is above the mean. In the square lattice the stress has no major axis. */
static void no_strong_particle_and_no_axis(void) {
  struct words row = begin(), square = begin();
  words_add(&row, "periodic cell 0 0 to 5.625 8\nlattice discs 3 by 1 from 1 1 radius 1 spacing 1.875 m\n");
  is(&row, 0, 0, 0, 0);
  words_add(&square, "periodic cell 0 0 to 5.625 5.625\nlattice discs 3 by 3 from 1 1 radius 1 spacing 1.875 m\n"
                     "disc 1.9375 1.9375 radius 0.0625 m\n");
  is(&square, 0, 0, 0, 0);
}

/* Three discs in a row at the angle phi to the vertical. Walls above and below each disc press with a hundred times
 * the force of the row's contacts, so the major axes are vertical. The contacts are links if phi is below 45 degrees.
 * The scene is rotated, so that all components of the stress count. */
static void links_within_45_degrees(void) {
  for (int k = 0; k < 16; k++) {
    const double phi = (k % 2 ? 47 : 43) * pi / 180, deep = 0.01;
    char rotation[64];
    snprintf(rotation, sizeof rotation, "transform rotate %.17g\n", k / 2 * pi / 8);
    transform = rotation;
    struct words page = begin();
    for (int n = 0; n < 3; n++) {
      const double x = 1.9999 * n * sin(phi), y = 1.9999 * n * cos(phi);
      words_add(&page, "disc %.17g %.17g radius 1 m\n", x, y);
      words_add(&page, "wall s%d %.17g %.17g to %.17g %.17g m\n", n, x - 0.3, y - 1 + deep, x + 0.3, y - 1 + deep);
      words_add(&page, "wall n%d %.17g %.17g to %.17g %.17g m\n", n, x - 0.3, y + 1 - deep, x + 0.3, y + 1 - deep);
    }
    words_add(&page, "disc 40 0 radius 1 m\n");
    if (k % 2)
      is(&page, 0, 0, 0, 0);
    else
      is(&page, 1, 3, 0.75, 0);
  }
  transform = "";
}

void suite_chains(void) {
  CU_pSuite suite = CU_add_suite("chains", NULL, NULL);
  CU_add_test(suite, "a row is straight, two particles are no chain", rows);
  CU_add_test(suite, "fixed particles alone are no chain", all_fixed);
  CU_add_test(suite, "a zigzag bends by twice its angle", zigzags);
  CU_add_test(suite, "hexagonal lattices, across the rows and along", hexagonal);
  CU_add_test(suite, "links along the major stress of both particles, stress above the mean", along_and_above);
  CU_add_test(suite, "shear forces count", shear_counts);
  CU_add_test(suite, "stress per volume of spheres and discs", volumes_count);
  CU_add_test(suite, "fixed particles and particles outside are in no chain", fixed_and_outside_particles);
  CU_add_test(suite, "a fixed particle separates two chains", fixed_between);
  CU_ADD_TEST(suite, two_bends);
  CU_ADD_TEST(suite, no_strong_particle_and_no_axis);
  CU_ADD_TEST(suite, links_within_45_degrees);
  CU_add_test(suite, "a weak neighbour is no link", a_weak_neighbour_is_no_link);
}
