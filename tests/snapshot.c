/* Snapshots: the columns of their tables, porosity ring by ring, the boundary, and a periodic cell.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/measure/areas.h"
#include "suites.h"
#include "written.h"

static const double pi = 3.14159265358979323846;

/* A large sphere in contact with two small ones, one of them of another material; a fourth sphere without contacts. */
static void run(struct nb_result *result, struct written *it) {
  struct words page = {0};
  words_add(&page, "units none\nmaterial a density 1 young 1000 poisson 0.25\nmaterial b density 1 young 1000 poisson "
                   "0.25\npair a b friction 0.5\nnormal hertz\nshear mindlin\nstep 1e-9\n"
                   "sphere 0 0 radius 2 a\nsphere 2.99 0 radius 1 a fixed spin 3\nsphere 0 2.98 radius 1 b fixed\n"
                   "sphere -9 0 radius 1 a velocity 0 -2\nregion B all\nregion A circle 0 0 radius 3.5 rings 7\n"
                   "record time\nstage s\ncycles 1\nsnapshot\n");
  written_scene(it, &page);
  written_run(result, it, NULL);
}

/* Hertz: N = 4/3 E* sqrt(R* alpha) alpha, a = sqrt(R* alpha), R* = 2/3, E* = E/(2 (1 - nu^2)) */
static void columns(void) {
  struct nb_result result;
  struct written it;
  run(&result, &it);
  const struct nb_table *particles = &result.snapshots[0].particles, *contacts = &result.snapshots[0].contacts;
  CU_ASSERT_FATAL(particles->row_count == 4 && contacts->row_count == 2);
  static const double touching[] = {2, 1, 1, 0}, fixed[] = {0, 1, 1, 0}, vy[] = {0, 0, 0, -2}, spin[] = {0, 3, 0, 0};
  for (size_t k = 0; k < 4; k++) {
    CU_ASSERT(written_cell(particles, k, "contacts") == touching[k] && written_cell(particles, k, "fixed") == fixed[k]);
    CU_ASSERT_DOUBLE_EQUAL(written_cell(particles, k, "vy"), vy[k], 1e-8); /* the large sphere has begun to move */
    CU_ASSERT_DOUBLE_EQUAL(written_cell(particles, k, "spin"), spin[k], 1e-8);
  }
  const double E = 1000 / (2 * (1 - 0.0625));
  for (size_t k = 0; k < 2; k++) {
    const double overlap = k ? 0.02 : 0.01, a = sqrt(2. / 3 * overlap), n = 4. / 3 * E * a * overlap;
    const struct {
      const char *name;
      double expected;
    } rows[] = {{"overlap", overlap},
                {"normal", n},
                {"radius", a},
                {"normal_stress", n / (pi * a * a)},
                {"ratio", a},
                {"angle", k ? pi / 2 : 0},
                {"limit", k ? 0.5 * n : 0}}; /* no friction between a and a */
    for (size_t r = 0; r < sizeof rows / sizeof *rows; r++)
      CU_ASSERT_DOUBLE_EQUAL(written_cell(contacts, k, rows[r].name), rows[r].expected, 1e-12 * (1 + rows[r].expected));
  }
  nb_result_free(&result);
  written_free(&it);
}

/* Without dashpots the forces of the contacts on a particle, with their shear parts, sum to the force on it. */
static void forces_of_the_contacts(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page,
            "units none\nmaterial m density 1 kn 10 ks 5 friction 0.5\nshear linear\nstep 0.01\n"
            "disc 0 0 radius 1 m\ndisc 1.6 1 radius 1 m fixed spin 2\ndisc -1 1.6 radius 1 m fixed velocity 1 0\n"
            "record time\nstage s\ncycles 3\nsnapshot\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  const struct nb_table *particles = &result.snapshots[0].particles, *contacts = &result.snapshots[0].contacts;
  CU_ASSERT_EQUAL_FATAL(contacts->row_count, 2);
  double fx = 0, fy = 0;
  for (size_t k = 0; k < 2; k++) {
    CU_ASSERT_NOT_EQUAL(written_cell(contacts, k, "shear"), 0);
    fx += written_cell(contacts, k, "fx"), fy += written_cell(contacts, k, "fy");
  }
  CU_ASSERT_DOUBLE_EQUAL(fx, written_cell(particles, 0, "fx"), 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(fy, written_cell(particles, 0, "fy"), 1e-14);
  nb_result_free(&result);
  written_free(&it);
}

/* Every column has its unit in SI, or `-` on a page without units. */
static void units(void) {
  static const char *const pages[] = {"units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nstep 0.1\n",
                                      "material m density 1 kg/m3 kn 1 N/m\ndisc 0 m 0 m radius 1 m m\nstep 0.1 s\n"};
  for (int si = 0; si < 2; si++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page, "%srecord time\nstage s\ncycles 1\nsnapshot\n", pages[si]);
    written_scene(&it, &page);
    written_run(&result, &it, NULL);
    CU_ASSERT_EQUAL(written_cell(&result.snapshots[0].particles, 0, "angle"), 0); /* the scene has no rotation */
    const struct nb_table *tables[] = {&result.snapshots[0].particles, &result.snapshots[0].walls,
                                       &result.snapshots[0].contacts};
    static const char *const of_particles[] = {"1", "m", "m",   "m",     "rad", "m/s", "m/s",
                                               "N", "N", "N.m", "rad/s", "1",   "1"};
    CU_ASSERT_EQUAL_FATAL(tables[0]->column_count, sizeof of_particles / sizeof *of_particles);
    for (size_t c = 0; c < tables[0]->column_count; c++)
      CU_ASSERT_STRING_EQUAL(tables[0]->units[c], si ? of_particles[c] : "-");
    for (size_t t = 0; t < 3; t++)
      for (size_t c = 0; c < tables[t]->column_count; c++)
        CU_ASSERT_EQUAL(strcmp(tables[t]->units[c], "-") == 0, !si);
    nb_result_free(&result);
    written_free(&it);
  }
}

/* Two discs without contacts: the free one is a rattler, the fixed one is not. */
static void a_fixed_particle_is_no_rattler(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page,
            "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 2 m fixed\ndisc 9 0 radius 1 m\nregion A all\n"
            "step 0.1\nrecord A.rattlers\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_EQUAL(written_last(&result, "A.rattlers"), 1);
  nb_result_free(&result);
  written_free(&it);
}

static void rings(void) {
  struct nb_result result;
  struct written it;
  run(&result, &it);
  const struct nb_table *table = &result.snapshots[0].rings;
  CU_ASSERT_EQUAL_FATAL(table->row_count, 7);
  for (size_t k = 0; k < 7; k++) {
    const double inner = 0.5 * (double)k, outer = inner + 0.5, all = pi * outer * outer;
    double area[2];
    for (int e = 0; e < 2; e++) {
      const double r = e ? outer : inner;
      area[e] = pi * fmin(4, r * r) + nb_area_of_lens(1, r, 2.99) + nb_area_of_lens(1, r, 2.98);
    }
    CU_ASSERT_EQUAL(written_cell(table, k, "region"), 2); /* in the order of the page */
    CU_ASSERT_DOUBLE_EQUAL(written_cell(table, k, "inner"), inner, 1e-15);
    CU_ASSERT_DOUBLE_EQUAL(written_cell(table, k, "outer"), outer, 1e-15);
    CU_ASSERT_DOUBLE_EQUAL(written_cell(table, k, "within"), 1 - area[1] / all, 1e-14);
    CU_ASSERT_DOUBLE_EQUAL(written_cell(table, k, "porosity"), 1 - (area[1] - area[0]) / (all - pi * inner * inner),
                           1e-14);
  }
  CU_ASSERT_DOUBLE_EQUAL(written_cell(table, 3, "porosity"), 0,
                         0.02); /* the ring is inside the large sphere, and the areas of its overlaps count twice */
  nb_result_free(&result);
  written_free(&it);
}

/* Six discs on a boundary around a seventh one, in scrambled order: the table of the boundary has the six,
 * counterclockwise, at their places, whatever the storage order. A scene without a boundary has no such table. */
static void the_boundary_is_listed_counterclockwise(void) {
  static const int sixths[] = {4, 1, 0, 5, 3, 2};
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\n");
  for (size_t k = 0; k < 6; k++)
    words_add(&page, "disc %.17g %.17g radius 1 m\n", 2 * cos(sixths[k] * pi / 3), 2 * sin(sixths[k] * pi / 3));
  words_add(&page, "boundary circle 0 0 radius 2\nstep 0.1\nrecord time\nstage s\ncycles 1\nsnapshot\n");
  written_scene(&it, &page);
  written_run(&result, &it, &(struct nb_options){.threads = 1, .shuffle = true});
  const struct nb_table *table = &result.snapshots[0].boundary;
  CU_ASSERT_EQUAL_FATAL(table->row_count, 6);
  for (size_t k = 0; k < 6; k++) {
    const size_t number = (size_t)written_cell(table, k, "particle"), next = (k + 1) % 6;
    CU_ASSERT_FATAL(number >= 2 && number <= 7);
    CU_ASSERT_DOUBLE_EQUAL(written_cell(table, k, "x"), 2 * cos(sixths[number - 2] * pi / 3), 1e-14);
    CU_ASSERT_DOUBLE_EQUAL(written_cell(table, k, "y"), 2 * sin(sixths[number - 2] * pi / 3), 1e-14);
    CU_ASSERT_EQUAL(sixths[(size_t)written_cell(table, next, "particle") - 2], (sixths[number - 2] + 1) % 6);
  }
  for (size_t k = 0; k < 7; k++) /* forces do not move the particles of a held boundary, as if they were fixed */
    CU_ASSERT_EQUAL(written_cell(&result.snapshots[0].particles, k, "fixed"), k > 0);
  nb_result_free(&result);
  written_free(&it);
  run(&result, &it);
  CU_ASSERT_PTR_NULL(result.snapshots[0].boundary.names);
  nb_result_free(&result);
  written_free(&it);
}

/* Particles of a boundary in the same direction are listed in the order of their numbers, whatever the storage order. A
 * later circle defines the boundary again, and `boundary none` ends it. */
static void the_boundary_in_one_direction(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 1 kn 1\n");
  for (int k = 0; k < 8; k++)
    words_add(&page, "disc %d 0 radius 1 m\n", 20 - 2 * k);
  words_add(&page,
            "boundary circle 0 0 radius 2\nstep 0.1\nrecord time\nstage s\ncycles 1\nsnapshot\n"
            "stage t\nboundary circle 0 0 radius 11\ncycles 1\nsnapshot\nstage u\nboundary none\ncycles 1\nsnapshot\n");
  written_scene(&it, &page);
  written_run(&result, &it, &(struct nb_options){.threads = 1, .shuffle = true});
  CU_ASSERT_EQUAL_FATAL(result.snapshots[0].boundary.row_count, 8);
  for (size_t k = 0; k < 8; k++)
    CU_ASSERT_EQUAL(written_cell(&result.snapshots[0].boundary, k, "particle"), (double)k + 1);
  CU_ASSERT_EQUAL(result.snapshots[1].boundary.row_count, 5); /* from 20 m to 12 m */
  CU_ASSERT_PTR_NULL(result.snapshots[2].boundary.names);
  nb_result_free(&result);
  written_free(&it);
}

/* For a disc that has left the cell, the table of rings counts the periodic image near the region's centre, as
 * A.porosity does. */
static void rings_in_a_cell(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page,
            "units none\nperiodic cell 0 0 to 10 10\nmaterial m density 1 kn 1\ndisc 9 5 radius 1 m velocity 9 0\n"
            "region A circle 5 5 radius 4 rings 1\nstep 0.1\nrecord A.porosity\nstage s\ncycles 5\nsnapshot\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_DOUBLE_EQUAL(written_last(&result, "A.porosity"), 15 / 16., 1e-14);
  CU_ASSERT_EQUAL_FATAL(result.snapshots[0].rings.row_count, 1);
  CU_ASSERT_DOUBLE_EQUAL(written_cell(&result.snapshots[0].rings, 0, "within"), 15 / 16., 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(written_cell(&result.snapshots[0].particles, 0, "x"), 3.5, 1e-14); /* 9 + 9 0.5 - 10 */
  nb_result_free(&result);
  written_free(&it);
}

/* Particles, walls and contacts of a scene in motion, from which particle 2 and wall 2 were removed. Columns equal
 * the recorded quantities of the same names, or known values. Two of the four variants store the particles in another
 * order, and two have an imposed motion. */
static void columns_are_the_quantities(void) {
  static const char *const of_particle[] = {"x", "y", "angle", "vx", "vy", "fx", "fy", "moment", "spin"};
  static const char *const of_contact[] = {"overlap", "normal", "shear", "sliding"};
  for (int variant = 0; variant < 4; variant++) {
    const int shuffle = variant % 2;
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1 kn 100 ks 80 friction 0.5\nshear linear\n"
              "disc 0 0 radius 1 m velocity 0.1 0 spin 1\ndisc 9 9 radius 1 m\ndisc 1.2 1.55 radius 1 m spin -2\n"
              "disc -9 3 radius 0.5 m velocity 0 0.2\nwall low -5 -0.99 to 5 -0.99 m\nwall gone 20 -3 to 20 5 m\n"
              "wall side 8 -3 to 8 5 m velocity 1 0.5\nmonitor P1 disc 1\nmonitor P2 disc 3\nmonitor P3 disc 4\n"
              "monitor C1 disc 1 with wall low\nmonitor C2 disc 1 with disc 3\nrecord");
    for (int k = 1; k <= 3; k++)
      for (size_t q = 0; q < sizeof of_particle / sizeof *of_particle; q++)
        words_add(&page, " P%d.%s", k, of_particle[q]);
    for (int k = 1; k <= 2; k++)
      for (size_t q = 0; q < sizeof of_contact / sizeof *of_contact; q++)
        words_add(&page, " C%d.%s", k, of_contact[q]);
    words_add(&page,
              "\nregion A circle 9 9 radius 2 rings 1\nstep 0.01\nstage s\nremove disc 2\nremove wall gone\n%scycles "
              "10\nsnapshot\n",
              variant < 2 ? "" : "affine strain 0.01 -0.02\n");
    written_scene(&it, &page);
    written_run(&result, &it, &(struct nb_options){.threads = 1, .shuffle = shuffle});
    const struct nb_table *particles = &result.snapshots[0].particles, *contacts = &result.snapshots[0].contacts,
                          *walls = &result.snapshots[0].walls;
    CU_ASSERT_FATAL(particles->row_count == 3 && contacts->row_count == 2 && walls->row_count == 2);
    static const double number[] = {1, 3, 4}, radius[] = {1, 1, 0.5}, touching[] = {2, 1, 0};
    char name[64];
    for (size_t k = 0; k < 3; k++) {
      CU_ASSERT_EQUAL(written_cell(particles, k, "particle"), number[k]);
      CU_ASSERT_EQUAL(written_cell(particles, k, "radius"), radius[k]);
      CU_ASSERT_EQUAL(written_cell(particles, k, "contacts"), touching[k]);
      for (size_t q = 0; q < sizeof of_particle / sizeof *of_particle; q++) {
        snprintf(name, sizeof name, "P%zu.%s", k + 1, of_particle[q]);
        CU_ASSERT_EQUAL(written_cell(particles, k, of_particle[q]), written_last(&result, name));
        CU_ASSERT(k == 2 || written_last(&result, name) != 0);
      }
    }
    for (size_t k = 0; k < 2; k++) { /* particles before walls */
      const size_t monitor = 2 - k;
      CU_ASSERT_EQUAL(written_cell(contacts, k, "a"), 1);
      CU_ASSERT_EQUAL(written_cell(contacts, k, "b"), k ? 0 : 3);
      CU_ASSERT_EQUAL(written_cell(contacts, k, "wall"), (double)k);
      CU_ASSERT_EQUAL(written_cell(contacts, k, "ra"), 1);
      CU_ASSERT_EQUAL(written_cell(contacts, k, "rb"), 1 - (double)k);
      for (size_t q = 0; q < sizeof of_contact / sizeof *of_contact; q++) {
        snprintf(name, sizeof name, "C%zu.%s", monitor, of_contact[q]);
        CU_ASSERT_EQUAL(written_cell(contacts, k, of_contact[q]), written_last(&result, name));
      }
      const double dx = written_last(&result, "P2.x") - written_last(&result, "P1.x"),
                   dy = written_last(&result, "P2.y") - written_last(&result, "P1.y");
      const double ex = k ? 0 : dx / hypot(dx, dy), ey = k ? -1 : dy / hypot(dx, dy);
      const double arm = 1 - written_cell(contacts, k, "overlap") / 2;
      CU_ASSERT_DOUBLE_EQUAL(written_cell(contacts, k, "ex"), ex, 1e-14);
      CU_ASSERT_DOUBLE_EQUAL(written_cell(contacts, k, "ey"), ey, 1e-14);
      CU_ASSERT_DOUBLE_EQUAL(written_cell(contacts, k, "x"), written_last(&result, "P1.x") + arm * ex, 1e-14);
      CU_ASSERT_DOUBLE_EQUAL(written_cell(contacts, k, "y"), written_last(&result, "P1.y") + arm * ey, 1e-14);
    }
    static const double ends[2][5] = {{1, -5, -0.99, 5, -0.99}, {3, 8.1, -2.95, 8.1, 5.05}}; /* at time 0.1 */
    static const char *const of_wall[] = {"wall", "x1", "y1", "x2", "y2"};
    for (size_t w = 0; w < 2; w++)
      for (size_t q = 0; q < 5; q++)
        CU_ASSERT_DOUBLE_EQUAL(written_cell(walls, w, of_wall[q]), ends[w][q], 1e-14);
    CU_ASSERT_EQUAL(written_cell(&result.snapshots[0].rings, 0, "within"), 1); /* the removed disc was there */
    nb_result_free(&result);
    written_free(&it);
  }
}

/* Two heavy discs that touch leave the cell together, from x = 9 to 13.5. The tables of contacts and of the space
 * lattice have them in the cell, at x = 3.5. */
static void contacts_in_a_cell(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page,
            "units none\nperiodic cell 0 0 to 10 10\nmaterial m density 2e15 kn 1\ndisc 9 5 radius 1 m velocity 9 0\n"
            "disc 9 6.9 radius 1 m velocity 9 0\nstep 0.05\nrecord time\nstage s\ncycles 10\nsnapshot from s\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  const struct nb_table *contacts = &result.snapshots[0].contacts, *lattice = &result.snapshots[0].lattice;
  CU_ASSERT_FATAL(contacts->row_count == 1 && lattice->row_count == 1);
  CU_ASSERT_DOUBLE_EQUAL(written_cell(contacts, 0, "x"), 3.5, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_cell(contacts, 0, "y"), 5.95, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_cell(lattice, 0, "x1"), 3.5, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_cell(lattice, 0, "x2"), 3.5, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_cell(lattice, 0, "y1"), 5, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_cell(lattice, 0, "y2"), 6.9, 1e-12);
  nb_result_free(&result);
  written_free(&it);
}

void suite_snapshot(void) {
  CU_pSuite suite = CU_add_suite("snapshot", NULL, NULL);
  CU_add_test(suite, "units of the columns", units);
  CU_add_test(suite, "the columns of particles and of contacts", columns);
  CU_add_test(suite, "the forces of the contacts of a particle", forces_of_the_contacts);
  CU_add_test(suite, "the columns are the quantities", columns_are_the_quantities);
  CU_add_test(suite, "porosity ring by ring", rings);
  CU_add_test(suite, "the boundary is listed counterclockwise", the_boundary_is_listed_counterclockwise);
  CU_add_test(suite, "the boundary in one direction", the_boundary_in_one_direction);
  CU_add_test(suite, "rings in a cell", rings_in_a_cell);
  CU_add_test(suite, "contacts in a cell", contacts_in_a_cell);
  CU_add_test(suite, "a fixed particle is no rattler", a_fixed_particle_is_no_rattler);
}
