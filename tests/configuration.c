/* Changes since the beginning of a stage: lost and new contacts, displacement and rotation of particles, slid
 * distance of contacts.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/measure/configuration.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

/* No table depends on the storage order of the particles. */
static const struct nb_options shuffled = {.threads = 1, .shuffle = true};

/* Tests a row of the table `lattice`: its particles or wall, the ends of the line, and its kind (-1: lost contact, 0:
 * kept, 1: new). */
static void line(const struct nb_table *lattice, size_t row, const double wanted[8]) {
  static const char *const names[] = {"a", "b", "wall", "x1", "y1", "x2", "y2", "kind"};
  for (int k = 0; k < 8; k++)
    CU_ASSERT_DOUBLE_EQUAL(written_cell(lattice, row, names[k]), wanted[k], 1e-12);
}

/* Disc 1 leaves disc 2 and reaches disc 3, disc 4 stays with disc 5, disc 6 leaves a wall, disc 7 reaches it, and disc
 * 8 is removed. The springs are so soft that velocities do not change: 4 m in 4 s. */
static void goes_over(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 1 kn 1e-14\nstep 0.01\n"
                   "disc 0 0 radius 1 m velocity 1 0\ndisc -1.9 0 radius 1 m fixed\ndisc 5.9 0 radius 1 m fixed\n"
                   "disc 0 9 radius 1 m velocity 1 0\ndisc 0 10.9 radius 1 m velocity 1 0\n"
                   "disc 20 0.9 radius 1 m velocity 0 1 spin 0.5\ndisc 30 4.9 radius 1 m velocity 0 -1\n"
                   "disc 40 0 radius 1 m\ndisc 41.9 0 radius 1 m\nwall w 19 0 to 31 0 m\nskin 0.2\nrecord time\n"
                   "stage a\ncycles 400\nsnapshot from a\nstage b\nremove disc 8\ncycles 1\nsnapshot from a\n"
                   "stage c\ncycles 1\nsnapshot\n");
  written_scene(&it, &page);
  written_run(&result, &it, &shuffled);
  CU_ASSERT(result.searches > 10);
  const struct nb_table *lattice = &result.snapshots[0].lattice, *particles = &result.snapshots[0].particles;
  CU_ASSERT_EQUAL_FATAL(lattice->row_count, 6);
  line(lattice, 0, (double[]){1, 2, 0, 4, 0, -1.9, 0, -1});
  line(lattice, 1, (double[]){1, 3, 0, 4, 0, 5.9, 0, 1});
  line(lattice, 2, (double[]){4, 5, 0, 4, 9, 4, 10.9, 0});
  line(lattice, 3, (double[]){8, 9, 0, 40, 0, 41.9, 0, 0});
  line(lattice, 4, (double[]){6, 0, 1, 20, 4.9, 20, 0, -1});
  line(lattice, 5, (double[]){7, 0, 1, 30, 0.9, 30, 0, 1});
  CU_ASSERT_DOUBLE_EQUAL(written_cell(particles, 0, "moved_x"), 4, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_cell(particles, 5, "moved_y"), 4, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_cell(particles, 5, "turned"), 0.5 * 4, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_cell(particles, 6, "moved_y"), -4, 1e-12);
  CU_ASSERT(written_cell(particles, 1, "moved_x") == 0 && written_cell(particles, 0, "turned") == 0);
  CU_ASSERT_EQUAL(result.snapshots[1].lattice.row_count, 5); /* no line to a removed particle */
  CU_ASSERT_PTR_NULL(result.snapshots[2].lattice.names);
  CU_ASSERT_EQUAL(result.snapshots[2].particles.column_count + 3, particles->column_count);
  CU_ASSERT_EQUAL(result.snapshots[2].contacts.column_count + 1, result.snapshots[0].contacts.column_count);
  nb_result_free(&result);
  written_free(&it);
}

/* The measures of regions. Disc 1 goes from disc 2 to disc 3, which it touches at 45 degrees; discs 4 and 5 stay in
 * contact; disc 6 leaves the wall. The fabric of lost and new contacts uses the current positions. */
static void of_regions(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, "units none\nmaterial m density 1 kn 1e-14\nstep 0.01\n"
                   "disc 0 0 radius 1 m velocity 1 0\ndisc -1.9 0 radius 1 m fixed\ndisc 5.4 1.4 radius 1 m fixed\n"
                   "disc 0 9 radius 1 m\ndisc 0 10.9 radius 1 m\ndisc 20 0.9 radius 1 m velocity 0 1\n"
                   "wall w 19 0 to 31 0 m\nregion A all\nregion B all from b\nregion C circle 4 0 radius 1\n"
                   "record A.contacts.lost A.contacts.new A.fabric.lost.xx A.fabric.lost.xy A.fabric.lost.yy "
                   "A.fabric.new.xx A.fabric.new.xy A.fabric.new.anisotropy B.contacts.lost B.contacts.new "
                   "B.fabric.lost.yy C.contacts.lost C.contacts.new C.fabric.lost.xx\nstage a\ncycles 200\n"
                   "stage b\ncycles 200\n");
  written_scene(&it, &page);
  struct nb_model *model = nb_model_create(&it.scene, NULL, &error);
  CU_ASSERT_PTR_NOT_NULL_FATAL(model);
  CU_ASSERT(written_now(model, "A.contacts.lost") == 0 && written_now(model, "A.fabric.new.xx") == 0);
  for (int s = 0; s < 2; s++) {
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[s], &error), NB_OK);
    written_cycles(model, 200);
    if (s == 0) { /* until stage b begins, B refers to the start */
      CU_ASSERT_EQUAL(written_now(model, "B.contacts.lost"), 2);
      CU_ASSERT_EQUAL(written_now(model, "B.contacts.new"), 0);
    }
  }
  CU_ASSERT_EQUAL(written_now(model, "A.contacts.lost"), 2);
  CU_ASSERT_EQUAL(written_now(model, "A.contacts.new"), 1);
  /* contact ends: two of the discs along x, one of the disc above the wall along y */
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.fabric.lost.xx"), 2. / 3, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.fabric.lost.yy"), 1. / 3, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.fabric.lost.xy"), 0, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.fabric.new.xx"), 0.5, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.fabric.new.xy"), 0.5, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.fabric.new.anisotropy"), 1, 1e-12);
  CU_ASSERT_EQUAL(written_now(model, "B.contacts.lost"), 0); /* both had opened before stage b */
  CU_ASSERT_EQUAL(written_now(model, "B.contacts.new"), 1);
  CU_ASSERT_EQUAL(written_now(model, "B.fabric.lost.yy"), 0);
  CU_ASSERT_EQUAL(written_now(model, "C.contacts.lost"), 1); /* only disc 1 is inside */
  CU_ASSERT_EQUAL(written_now(model, "C.contacts.new"), 1);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.fabric.lost.xx"), 1, 1e-12);
  nb_model_free(model);
  written_free(&it);
}

/* A disc moves until its centre is exactly on a removed wall. The lost contact then has no direction: it counts, but
 * adds nothing to the fabric. */
static void a_centre_on_a_wall(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 1 kn 1e-300\nstep 0.5\ndisc 0 0.5 radius 1 m velocity 0 -0.5\n"
                   "wall w -5 0 to 5 0 m\nregion A all\nrecord A.contacts.lost A.fabric.lost.xx A.fabric.lost.yy\n"
                   "stage a\nremove wall w\ncycles 2\n");
  written_scene(&it, &page);
  written_run(&result, &it, &shuffled);
  CU_ASSERT_EQUAL(written_last(&result, "A.contacts.lost"), 1);
  CU_ASSERT_EQUAL(written_last(&result, "A.fabric.lost.xx"), 0);
  CU_ASSERT_EQUAL(written_last(&result, "A.fabric.lost.yy"), 0);
  nb_result_free(&result);
  written_free(&it);
}

/* The contact of a particle that the first stage removes is lost since the start of the run, but not since the
 * beginning of that stage. */
static void since_the_start_or_the_first_stage(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 1 kn 1e-14\nstep 0.01\ndisc 0 0 radius 1 m\ndisc 1.9 0 radius 1 m\n"
                   "region A all\nregion B all from a\nrecord A.contacts.lost A.fabric.lost.xx B.contacts.lost\n"
                   "stage a\nremove disc 1\ncycles 3\n");
  written_scene(&it, &page);
  written_run(&result, &it, &shuffled);
  CU_ASSERT_EQUAL(written_last(&result, "A.contacts.lost"), 1);
  CU_ASSERT_EQUAL(written_last(&result, "A.fabric.lost.xx"), 1);
  CU_ASSERT_EQUAL(written_last(&result, "B.contacts.lost"), 0);
  nb_result_free(&result);
  written_free(&it);
}

/* A sphere on an incline starts from rest, with the normal spring in equilibrium. The components of gravity are p along
 * the incline and n towards it, m/s2. While the contact slides, the acceleration of the slip is p - 7/2 mu n. */
static const double p = 3, n = 8, ks = 1e7, step = 2e-5;
static const int cycles = 25000, many = 5;

/* Runs two equal spheres on the incline, far apart: the stage `all` with one cycle, `many` equal stages, and the stage
 * `last` with one cycle. */
static void incline(struct nb_result *result, struct written *it, double friction) {
  const double mass = 2600 * 4 / 3. * 3.14159265358979323846 * 1e-3;
  struct words page = {0};
  words_add(&page,
            "units none\nmaterial m density 2600 kn 1e7 ks %g friction %g\nnormal linear\nshear linear\ngravity %g "
            "%g\nlattice spheres 2 by 1 from 0 %.17g radius 0.1 spacing 3 m\nwall w -1 0 to 9 0 m\nstep %g\n"
            "record time\n",
            ks, friction, p, -n, 0.1 - mass * n / 1e7, step);
  words_add(&page, "stage all\ncycles 1\nrecord none\n");
  for (int s = 0; s < many; s++)
    words_add(&page, "stage s%d\ncycles %d\nsnapshot from s%d\n", s, cycles / many, s);
  words_add(&page, "stage last\ncycles 1\nsnapshot from all\n");
  written_scene(it, &page);
  written_run(result, it, NULL);
}

static void slides(void) {
  const double friction = 0.1, mass = 2600 * 4 / 3. * 3.14159265358979323846 * 1e-3;
  /* first the shear spring takes up the displacement, which oscillates with w^2 = 7/2 k_s/m about p/w^2; at mu N/k_s
   * the contact begins to slide */
  const double w2 = 3.5 * ks / mass, spring = friction * mass * n / ks;
  const double begins = acos(1 - spring * w2 / p) / sqrt(w2), v = sqrt(spring * (2 * p - w2 * spring));
  const double t = (cycles + 2) * step - begins, way = v * t + (p - 3.5 * friction * n) * t * t / 2;
  struct nb_result result;
  struct written it;
  incline(&result, &it, friction);
  const struct nb_snapshot *last = &result.snapshots[many];
  const double slid = written_cell(&last->contacts, 0, "slid");
  CU_ASSERT(result.searches > 5);
  CU_ASSERT_DOUBLE_EQUAL(slid, way, 3e-4 * way);              /* 3 steps at the final speed, 0.1 m/s */
  NEAR(written_cell(&last->contacts, 1, "slid"), slid, 1e-6); /* the other sphere slides as far */
  /* the whole tangential displacement is that of the centre plus the radius times the rotation; the part of it that is
   * not sliding is the displacement of the spring, except for one step */
  const double slip = written_cell(&last->particles, 0, "moved_x") + 0.1 * written_cell(&last->particles, 0, "turned");
  CU_ASSERT(slip - slid <= spring * (1 + 1e-9) && slip - slid > 0.8 * spring);
  double sum = 0;
  for (int s = 0; s < many; s++) { /* with `all` there are six reference stages; each has its own sum of slip */
    const struct nb_table *particles = &result.snapshots[s].particles;
    const double part = written_cell(&result.snapshots[s].contacts, 0, "slid");
    sum += part;
    if (s > 0)
      CU_ASSERT_DOUBLE_EQUAL(part, written_cell(particles, 0, "moved_x") + 0.1 * written_cell(particles, 0, "turned"),
                             1e-12);
  }
  CU_ASSERT_DOUBLE_EQUAL(sum, slid, 1e-4 * way); /* without the cycles of `all` and `last` */
  CU_ASSERT(sum < slid);
  nb_result_free(&result);
  written_free(&it);
}

static void rolls(void) {
  struct nb_result result;
  struct written it;
  incline(&result, &it, 0.3);
  const struct nb_snapshot *last = &result.snapshots[many];
  CU_ASSERT_EQUAL(written_cell(&last->contacts, 0, "slid"), 0);
  CU_ASSERT(written_cell(&last->particles, 0, "moved_x") > 0.25); /* it does move, by p/(1 + 2/5) t^2/2 */
  CU_ASSERT_DOUBLE_EQUAL(written_cell(&last->particles, 0, "moved_x"),
                         -0.1 * written_cell(&last->particles, 0, "turned"), 2e-5);
  nb_result_free(&result);
  written_free(&it);
}

/* A disc that bounces: during its second impact `slid` is the sliding distance of this impact alone, without that of
 * the first one. The lines of the lattice compare with the stage that each snapshot names. */
static void comes_back(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page,
            "units none\nmaterial m density 1 kn 1e4 ks 1e4 friction 0.05\nnormal linear\nshear linear\n"
            "gravity 0 -1\ndisc 0 1.01 radius 1 m velocity 9 0\nwall w -50 0 to 50 0 m\nmonitor C disc 1 with wall "
            "w\nstep 1e-4\nrecord time C.overlap C.sliding\nstage down\nuntil C.overlap above 1e-6 at most 100000 "
            "cycles\nsnapshot from down\nstage up\nuntil C.overlap below 1e-9 at most 100000 cycles\nstage "
            "down2\nuntil C.overlap above 1e-6 at most 100000 cycles\nstage in\ncycles 150\nsnapshot from down\n"
            "stage in2\ncycles 1\nsnapshot from down2\nstage in3\ncycles 1\nsnapshot from in2\n");
  written_scene(&it, &page);
  written_run(&result, &it, &shuffled);
  const double since_down = written_cell(&result.snapshots[1].contacts, 0, "slid");
  const double since_apart = written_cell(&result.snapshots[2].contacts, 0, "slid");
  CU_ASSERT(since_down > 0.05 && since_down < 9 * 152e-4); /* 150 steps of 1e-4 at nearly 9, and the first ones */
  CU_ASSERT(since_apart > since_down && since_apart < since_down + 1e-3);
  CU_ASSERT_EQUAL(result.snapshots[1].lattice.row_count, 1);
  CU_ASSERT_EQUAL(written_cell(&result.snapshots[1].lattice, 0, "kind"), 1);
  CU_ASSERT_EQUAL_FATAL(result.snapshots[3].lattice.row_count, 1);
  CU_ASSERT_EQUAL(written_cell(&result.snapshots[3].lattice, 0, "kind"), 0); /* it touched when `in2` began */
  nb_result_free(&result);
  written_free(&it);
}

/* The lattice has no line for a contact if its wall is removed, and the table of walls no row. Walls keep their
 * numbers. */
static void no_line_to_a_removed_wall(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 1 kn 1e-14\nstep 0.01\ndisc 0 0.9 radius 1 m\n"
                   "wall v -5 0 to 5 0 m\nwall w -5 1.8 to 5 1.8 m\nrecord time\nstage a\ncycles 2\nsnapshot from a\n"
                   "stage b\nremove wall v\ncycles 1\nsnapshot from a\n");
  written_scene(&it, &page);
  written_run(&result, &it, &shuffled);
  CU_ASSERT_EQUAL(result.snapshots[0].lattice.row_count, 2);
  CU_ASSERT_EQUAL(result.snapshots[0].walls.row_count, 2);
  CU_ASSERT_EQUAL_FATAL(result.snapshots[1].lattice.row_count, 1);
  line(&result.snapshots[1].lattice, 0, (double[]){1, 0, 2, 0, 0.9, 0, 1.8, 0});
  CU_ASSERT_EQUAL_FATAL(result.snapshots[1].walls.row_count, 1);
  CU_ASSERT_EQUAL(written_cell(&result.snapshots[1].walls, 0, "wall"), 2);
  nb_result_free(&result);
  written_free(&it);
}

/* The lattice has no line for a contact if one of its particles is removed, whichever of the two it is. */
static void no_line_to_a_removed_particle(void) {
  for (int removed = 1; removed <= 2; removed++) {
    struct words page = {0};
    struct written it;
    struct nb_result result;
    words_add(&page,
              "units none\nmaterial m density 1 kn 1e-14\nstep 0.01\ndisc 0 0 radius 1 m\ndisc 1.9 0 radius 1 m\n"
              "disc 9 0 radius 1 m\ndisc 10.9 0 radius 1 m\nrecord time\nstage a\ncycles 1\n"
              "stage b\nremove disc %d\ncycles 1\nsnapshot from a\n",
              removed);
    written_scene(&it, &page);
    written_run(&result, &it, &shuffled);
    CU_ASSERT_EQUAL_FATAL(result.snapshots[0].lattice.row_count, 1);
    line(&result.snapshots[0].lattice, 0, (double[]){3, 4, 0, 9, 0, 10.9, 0, 0});
    nb_result_free(&result), written_free(&it);
  }
}

/* Across the edge of a periodic cell the line goes to the image that is in contact. */
static void across_the_edge(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 1 kn 1e-14\nstep 0.01\nperiodic cell 0 0 to 10 10\n"
                   "disc 0.5 5 radius 1 m\ndisc 8.6 5 radius 1 m velocity 0 -1\ndisc 8.6 2 radius 1 m\n"
                   "record time\nstage a\ncycles 200\nsnapshot from a\n");
  written_scene(&it, &page);
  written_run(&result, &it, &shuffled);
  const struct nb_table *lattice = &result.snapshots[0].lattice;
  CU_ASSERT_EQUAL_FATAL(lattice->row_count, 2);
  line(lattice, 0, (double[]){1, 2, 0, 0.5, 5, -1.4, 3, -1});
  line(lattice, 1, (double[]){2, 3, 0, 8.6, 3, 8.6, 2, 1});
  nb_result_free(&result);
  written_free(&it);
}

void suite_configuration(void) {
  CU_pSuite suite = CU_add_suite("configuration", NULL, NULL);
  CU_add_test(suite, "a centre on a wall has no direction to it", a_centre_on_a_wall);
  CU_add_test(suite, "contacts lost, new and kept", goes_over);
  CU_add_test(suite, "contacts lost and new of a region, and their directions", of_regions);
  CU_add_test(suite, "a sphere slides down an incline", slides);
  CU_add_test(suite, "a rolling sphere does not slide", rolls);
  CU_add_test(suite, "slid begins at 0 when a contact closes again", comes_back);
  CU_ADD_TEST(suite, no_line_to_a_removed_particle);
  CU_ADD_TEST(suite, no_line_to_a_removed_wall);
  CU_add_test(suite, "lines across the edge of a cell", across_the_edge);
  CU_add_test(suite, "lost since the start, or since the first stage", since_the_start_or_the_first_stage);
}
