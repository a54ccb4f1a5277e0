/* The references wedge, wall_end and hertz_row: solutions that are known without their formulas, and scenes that they
 * refuse.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "refs_scenes.h"
#include "suites.h"
#include "written.h"

static const double pi = 3.14159265358979324;

static void read_page(struct written *it, struct refs_scene *scene, const char *text) {
  struct words page = {0};
  words_add(&page, "%s", text);
  written_scene(it, &page);
  scene->scene = it->scene;
}

/* A disc of weight pi in a right angle exerts the force pi/sqrt(2) on each wall, wherever the points P of the walls are. */
static void a_disc_in_a_right_angle(void) {
  static const char *const about[] = {"", " about 3 1", " about -5 -2"};
  const double force = pi / sqrt(2);
  for (int k = 0; k < 9; k++) {
    struct written it;
    struct refs_scene scene;
    char text[512];
    snprintf(
        text, sizeof text,
        "units none\nmaterial m density 1 kn 100\nnormal linear\nshear none\ngravity 0 -1\ndisc 0 1.5 radius 1 m\n"
        "wall a 0 0 to -9 9 m%s\nwall b 0 0 to 9 9 m%s\nmonitor C disc 1 with wall a\nmonitor D disc 1\nstep 0.001\n"
        "stage s\ncycles 1\n",
        about[k % 3], about[k / 3]);
    read_page(&it, &scene, text);
    struct nb_solution solution = refs_solution("wedge", &scene);
    CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "C.normal in s"), force, 1e-14);
    CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "D.x in s"), 0, 1e-14);
    CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "D.y in s"), sqrt(2) * (1 - force / 100), 1e-14);
    CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "step.stable in s"), 2 * sqrt(pi / 200), 1e-15);
    solution_free(&solution);
    written_free(&it);
  }
}

/* A disc that hits the end of a wall head-on with the relative speed v oscillates for half a period on the contact
 * spring. The largest overlap is v (m/k)^(1/2), and the relative velocity is reversed. */
static void the_end_of_a_wall_returns_a_disc(void) {
  struct written it;
  struct refs_scene scene;
  read_page(&it, &scene,
            "units none\nmaterial m density 1 kn (pi*10000)\nnormal linear\nshear none\n"
            "disc -2 0 radius 1 m velocity 3 0\nwall a 0 0 to 9 0 m velocity 1 0\nmonitor C disc 1 with wall a\n"
            "monitor D disc 1\nstep 0.001\nstage s\ncycles 1\n");
  struct nb_solution solution = refs_solution("wall_end", &scene);
  CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "D.vx"), -1, 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "D.vy"), 0, 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "C.overlap max"), 0.02, 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "energy.walls"), pi / 2 * (1 - 9), 1e-13);
  solution_free(&solution);
  written_free(&it);
}

/* The stiff end of a wall deflects a disc by pi - 2 arcsin b, where b is the distance of its path from the end, divided by
 * its radius. With b = 1/2 this is 120 degrees. The error is of the order of v (m/k)^(1/2)/R = 1e-5. */
static void a_stiff_end_reflects_as_a_rigid_one(void) {
  struct written it;
  struct refs_scene scene;
  read_page(
      &it, &scene,
      "units none\nmaterial m density 1 kn (pi*10000000000)\nnormal linear\nshear none\n"
      "disc -2 0.5 radius 1 m velocity 1 0\nwall a 0 0 to 9 0 m\nmonitor D disc 1\nstep 0.001\nstage s\ncycles 1\n");
  struct nb_solution solution = refs_solution("wall_end", &scene);
  CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "D.vx"), cos(2 * pi / 3), 1e-4);
  CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "D.vy"), sin(2 * pi / 3), 1e-4);
  solution_free(&solution);
  written_free(&it);
}

static void scenes_of_other_kinds_are_refused(void) {
  static const struct {
    const char *reference, *page, *words;
  } refused[] = {
      {"wedge", "shear none\ngravity 0 -1\ndisc 0 1 radius 1 m\nwall a -9 0 to 9 0 m\nwall b 2 0 to 2 9 m\n",
       "rests on"},
      {"wedge", "shear none\ngravity 0 -1\ndisc 0 1 radius 1 m\nwall a -9 0 to 9 0 m\n", "two walls"},
      {"wall_end", "shear none\ndisc -2 1.5 radius 1 m velocity 1 0\nwall a 0 0 to 9 0 m\n", "toward the end"},
      {"wall_end", "shear none\ndisc 2 2 radius 1 m velocity 0 -1\nwall a 0 0 to 9 0 m\n", "the end"},
      {"wall_end", "shear none\ndisc 2 2 radius 1 m velocity 0 -1\nwall a 0 0 to 9 0 m\nwall b 0 -1 to 9 -1 m\n",
       "one wall"},
  };
  for (size_t k = 0; k < sizeof refused / sizeof *refused; k++) {
    struct written it;
    struct refs_scene scene;
    char page[512];
    snprintf(page, sizeof page,
             "units none\nmaterial m density 1 kn 100\nnormal linear\n%sstep 0.001\nstage s\ncycles 1\n",
             refused[k].page);
    read_page(&it, &scene, page);
    CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused(refused[k].reference, &scene).text, refused[k].words));
    written_free(&it);
  }
}

/* Two spheres between walls of the same material: R = 1 and E* = 2/3, because E = 1 and nu = 1/2. A contact has the force
 * K alpha^(3/2), with K = 8/9 at a wall and K = 8/9/sqrt(2) between the spheres. The three overlaps add up to 0.3. */
static void a_row_of_two_spheres(void) {
  static const char row[] =
      "units none\nmaterial m density 1 young 1 poisson 0.5\nnormal hertz\nshear none\n"
      "wall a 0 -9 to 0 9 m\nwall b %s -9 to %s 9 m\nsphere 1 0 radius 1 m\nsphere 2.7 %s radius 1 m\n"
      "monitor C sphere 1 with sphere 2\nstep 0.001\nstage s\ncycles 1\n";
  struct written it;
  struct refs_scene scene;
  char page[512];
  snprintf(page, sizeof page, row, "3.7", "3.7", "0");
  read_page(&it, &scene, page);
  struct nb_solution solution = refs_solution("hertz_row", &scene);
  const double force = refs_value(&solution, "C.normal");
  CU_ASSERT_DOUBLE_EQUAL(2 * pow(force * 9 / 8, 2 / 3.) + pow(force * 9 / 8 * sqrt(2), 2 / 3.), 0.3, 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(refs_value(&solution, "C.overlap"), pow(force * 9 / 8 * sqrt(2), 2 / 3.), 1e-14);
  solution_free(&solution);
  written_free(&it);
  snprintf(page, sizeof page, row, "5", "5", "0");
  read_page(&it, &scene, page);
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("hertz_row", &scene).text, "longer than"));
  written_free(&it);
  snprintf(page, sizeof page, row, "3.7", "3.7", "0.5");
  read_page(&it, &scene, page);
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("hertz_row", &scene).text, "along x"));
  written_free(&it);
}

void suite_refs_extremes(void) {
  CU_pSuite suite = CU_add_suite("refs_extremes", NULL, NULL);
  CU_add_test(suite, "a disc in a right angle", a_disc_in_a_right_angle);
  CU_add_test(suite, "the moving end of a wall returns a disc", the_end_of_a_wall_returns_a_disc);
  CU_add_test(suite, "a stiff end reflects as a rigid one", a_stiff_end_reflects_as_a_rigid_one);
  CU_add_test(suite, "two spheres between walls", a_row_of_two_spheres);
  CU_add_test(suite, "scenes of other kinds are refused", scenes_of_other_kinds_are_refused);
}
