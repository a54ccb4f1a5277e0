/* Walls that move, rotate and have common ends [CS79, Input parameters; figure 4], and particles that cross them.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/core/model.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

static const double pi = 3.14159265358979323846;

/* One wall rotates about its middle, one about a moving point off its line, through two stages with different spins. */
static void rotation_is_exact(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 1\nstep 0.01\ndisc 90 90 radius 1 m\n"
                   "wall blade -3 0 to 5 0 m spin 2\nwall arm 4 -1 to 4 2 m about -3 -5 velocity 0.25 -0.5 spin -0.75\n"
                   "monitor W wall arm\nrecord W.x W.y W.angle W.spin\nstage s\ncycles 100000\nstage t\nwall arm spin "
                   "0.5\ncycles 100000\n"
                   "stage u\nwalls stop\ncycles 10\n");
  written_scene(&it, &page);
  CU_ASSERT(it.scene.walls[0].x == 1 && it.scene.walls[0].h1 == -4 && it.scene.walls[0].h0 == 0);
  CU_ASSERT(it.scene.walls[1].h0 == -7 && it.scene.walls[1].h1 == 4 && it.scene.walls[1].h2 == 7);
  CU_ASSERT(it.scene.stages[1].motions[0].vx == 0.25 && it.scene.stages[1].motions[0].vy == -0.5); /* not changed */
  CU_ASSERT(it.scene.stages[2].motions[1].spin == 0);
  struct nb_model *model = written_model(&it, NULL);
  const struct nb_walls *walls = &model->walls;
  struct nb_error error;
  double spin = -0.75, angle = 0;
  for (int s = 0; s < 2; s++) {
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[s], &error), NB_OK);
    written_cycles(model, 100000);
    const double t = 1000 * (s + 1);
    angle += spin * 1000, spin = 0.5;
    CU_ASSERT_DOUBLE_EQUAL(vec_length(walls->along[0]), 1, 1e-15);
    CU_ASSERT_DOUBLE_EQUAL(walls->along[0].x, cos(2 * t), 1e-10);
    CU_ASSERT_DOUBLE_EQUAL(walls->along[0].y, sin(2 * t), 1e-10);
    CU_ASSERT(walls->point[0].x == 1 && walls->point[0].y == 0);
    /* The first end of the arm, at (4, -1) at time 0, has rotated about the moving point (x, y). */
    const double x = -3 + 0.25 * t, y = -5 - 0.5 * t;
    const struct nb_vec end = nb_wall_end(walls, 1, 0);
    CU_ASSERT_DOUBLE_EQUAL(end.x, x + 7 * cos(angle) - 4 * sin(angle), 1e-9);
    CU_ASSERT_DOUBLE_EQUAL(end.y, y + 7 * sin(angle) + 4 * cos(angle), 1e-9);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "W.x"), x, 1e-8);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "W.y"), y, 1e-8);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "W.angle"), angle, 1e-8);
    CU_ASSERT_EQUAL(written_now(model, "W.spin"), s == 0 ? -0.75 : 0.5);
  }
  nb_model_free(model);
  written_free(&it);
}

/* The velocity of a wall at a point is the displacement of this point of the wall in the step, divided by the step,
 * even if the wall rotates. */
static void velocity_of_a_point(void) {
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial m density 1 kn 1\nstep 0.5\ndisc 90 90 radius 1 m\n"
            "wall arm 4 -1 to 4 2 m about -3 -5 velocity 0.25 -0.5 spin -0.75\nrecord cycle\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  const struct nb_vec before = nb_wall_end(&model->walls, 0, 1);
  written_cycles(model, 1);
  const struct nb_vec after = nb_wall_end(&model->walls, 0, 1), v = nb_wall_velocity(&model->walls, 0, after);
  CU_ASSERT_DOUBLE_EQUAL((after.x - before.x) / 0.5, v.x, 1e-14);
  CU_ASSERT_DOUBLE_EQUAL((after.y - before.y) / 0.5, v.y, 1e-14);
  nb_model_free(model);
  written_free(&it);
}

/* ---- one contact at a common end ---- */

/* A disc that rolls on a floor of one or several walls under gravity: its position and moment in each cycle, and the
 * number of cycles with two contacts. */
struct rolled {
  double x[2000], moment[2000], both;
};

/* Runs the disc on a floor of these walls. `skin` is a statement or empty. `turn`, rad, rotates the scene, so that
 * coordinates are not round numbers. */
static void roll(struct rolled *seen, const char *floor, const char *skin, double turn) {
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial m density 1 kn 4000 ks 3000 friction 0.5\nshear linear\ngravity 0.3 -1\nstep 0.004\n"
            "%s\ndisc -1 0.999 radius 1 m velocity 0.2 0\ntransform rotate %.17g\nmonitor D disc 1\n%s"
            "record D.x D.moment contacts\nstage s\ncycles 2000\n",
            floor, turn, skin);
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  seen->both = 0;
  for (int n = 0; n < 2000; n++) {
    written_cycles(model, 1);
    seen->x[n] = written_now(model, "D.x"), seen->moment[n] = written_now(model, "D.moment");
    seen->both += written_now(model, "contacts") > 1;
  }
  nb_model_free(model);
  written_free(&it);
}

/* A disc beside the common end of two walls. The second wall has no contact with the disc as long as the ends coincide.
 * This wall gets its contact in the first cycle in which it moves away. */
static void a_wall_that_moves_away_has_a_contact_at_once(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1e12 kn 400\nstep 0.01\nskin 1e-5\ndisc -0.2 0.95 radius 1 m\n"
                   "wall a -9 0 to 0 0 m\nwall b 0 0 to 9 0 m velocity 0 0\nmonitor A disc 1 with wall a\n"
                   "monitor B disc 1 with wall b\nrecord A.normal B.normal\nstage rest\ncycles 5\nstage up\n"
                   "wall b velocity 0 2\ncycles 5\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  struct nb_error error;
  for (int n = 0; n < 10; n++) {
    if (n % 5 == 0)
      CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[n / 5], &error), NB_OK);
    written_cycles(model, 1);
    const double high = n < 5 ? 0 : 0.02 * (n - 4);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.normal"), 400 * 0.05, 1e-9);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "B.normal"), n < 5 ? 0 : 400 * (1 - hypot(0.2, 0.95 - high)), 1e-9);
  }
  nb_model_free(model);
  written_free(&it);
}

/* Tests the normal force of wall b on a disc near the end (0, 0) of wall a after each of two stages: it must be
 * wanted[k] after stage k. In stage k the end of b moves to (to[k], 0) in cycles[k] cycles; it begins at (from, 0). The
 * walls c and d, far away, have a common end. */
static void move_end(double from, const double to[2], const int cycles[2], const double wanted[2], const char *skin) {
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial m density 1e12 kn 400\nstep 0.01\n%sdisc -0.2 0.95 radius 1 m\nwall a -9 0 to 0 0 m\n"
            "wall b %g 0 to 9 0 m\nwall c 50 0 to 60 0 m\nwall d 60 0 to 60 9 m\nmonitor B disc 1 with wall b\n"
            "record B.normal\nstage one\nwall b velocity %g 0\ncycles %d\nstage two\nwall b velocity %g 0\ncycles %d\n",
            skin, from, (to[0] - from) / (0.01 * cycles[0]), cycles[0], (to[1] - to[0]) / (0.01 * cycles[1]),
            cycles[1]);
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  struct nb_error error;
  for (int k = 0; k < 2; k++) {
    CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[k], &error), NB_OK);
    written_cycles(model, cycles[k]);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "B.normal"), wanted[k], 1e-9);
  }
  nb_model_free(model);
  written_free(&it);
}

/* Ends that are apart at time 0 never become common. Ends that coincide at time 0 are common when they meet again. In
 * the second call with the default skin the end of b is at x = 0.04 at the last search, so this search does not see that
 * the ends meet. */
static void common_ends_are_those_of_time_0(void) {
  const double at_end = 400 * (1 - hypot(0.2, 0.95));
  const int equal[2] = {10, 10}, unequal[2] = {15, 3};
  static const char *const skins[] = {"", "skin 1e-5\n"};
  for (int k = 0; k < 2; k++) {
    move_end(0.12, (const double[]){0, 0.12}, equal, (const double[]){at_end, 0}, skins[k]);
    move_end(0, (const double[]){0.12, 0}, unequal, (const double[]){0, 0}, skins[k]);
  }
}

static void no_jump_on_a_straight_vertex(void) {
  static struct rolled one, two;
  static const char *const joined[] = {
      "wall a -9 0 to 0.5 0 m\nwall b 0.5 0 to 9 0 m", /* also with either wall reversed, and in another order */
      "wall b 9 0 to 0.5 0 m\nwall a -9 0 to 0.5 0 m",
      "wall a 0.5 0 to -9 0 m\nwall b 0.5 0 to 9 0 m",
      "wall a -9 0 to 0.5 0 m about -3 5\nwall b 0.5 0 to 9 0 m about 2 -7", /* about points off the walls */
      "wall a -9 0 to -0.3 0 m\nwall b -0.3 0 to 0.3 0 m\nwall c 0.3 0 to 0.6 0 m\nwall d 0.6 0 to 9 0 m",
  };
  for (int t = 0; t < 4; t++) {
    const double turn = t * 0.6;
    const char *skin = t == 3 ? "skin 1e-5\n" : ""; /* a search in every cycle */
    roll(&one, "wall a -9 0 to 9 0 m", "", turn);
    CU_ASSERT(one.x[1999] > (t == 0 ? 1.5 : -9));
    double largest = 0;
    for (int n = 0; n < 2000; n++)
      largest = fmax(largest, fabs(one.moment[n]));
    CU_ASSERT(largest > 0.1);
    for (size_t j = 0; j < sizeof joined / sizeof *joined; j++) {
      roll(&two, joined[j], skin, turn);
      CU_ASSERT(two.both == 0);
      double off = 0;
      for (int n = 0; n < 2000; n++)
        off = fmax(off, fabs(two.moment[n] - one.moment[n]));
      if (off > 1e-9)
        printf("# floor %zu rotated by %g: moment differs by %g of %g\n", j, turn, off, largest);
      CU_ASSERT(off < 1e-9);
    }
  }
}

/* A sphere hits a floor obliquely, without friction, and passes the common end of its two walls during the impact. The
 * force in each cycle is that on a floor of one wall: with a normal law in increments, whose history is the force, and
 * with centred dashpots, which act for one more cycle when a contact ends. The suppressed contact ends before the other
 * one. */
static void an_impact_on_a_vertex(const char *laws) {
  static const char *const floors[] = {"wall a -9 0 to 9 0 m", "wall a -9 0 to 0 0 m\nwall b 0 0 to 9 0 m",
                                       "wall b 0 0 to 9 0 m\nwall a -9 0 to 0 0 m"};
  double force[200], most = 0;
  for (int k = 0; k < 3; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1 kn 1600 young 1e4 poisson 0.25\nstep 0.001\n%s\n%s\n"
              "sphere -0.16 1 radius 1 m velocity 2 -1\nmonitor D sphere 1\nrecord D.fy\nstage s\ncycles 1\n",
              laws, floors[k]);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    for (int n = 0; n < 200; n++) {
      written_cycles(model, 1);
      const double now = written_now(model, "D.fy");
      force[n] = k == 0 ? now : force[n], most = fmax(most, now);
      CU_ASSERT_DOUBLE_EQUAL(now, force[n], 1e-9);
    }
    nb_model_free(model);
    written_free(&it);
  }
  CU_ASSERT(most > 50);
}

static void impacts_on_a_vertex(void) {
  an_impact_on_a_vertex("normal hertz_increment");
  an_impact_on_a_vertex("damping ratio 0.2\ndamping centred");
}

/* In one step a disc moves from the common end of two walls so far onto the first wall that the end is beyond the skin.
 * The first wall, whose contact was suppressed, then supports the disc. */
static void a_jump_away_from_a_vertex(void) {
  static const char *const floors[] = {"wall a -9 0 to 0 0 m\nwall b 0 0 to 9 0 m",
                                       "wall b 0 0 to 9 0 m\nwall a -9 0 to 0 0 m"};
  for (int k = 0; k < 4; k++) {
    const int way = k / 2 ? 1 : -1;
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1e12 kn 400\nstep 0.5\nskin 0.1\n%s\n"
              "disc %g 0.95 radius 1 m velocity %g 0\nmonitor D disc 1\nrecord D.fy contacts\nstage s\ncycles 1\n",
              floors[k % 2], -0.1 * way, 1.9 * way);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    for (int n = 0; n < 2; n++) { /* at x = 0.1 and 0.85 */
      CU_ASSERT_DOUBLE_EQUAL(written_now(model, "D.fy"), 400 * 0.05, 1e-9);
      CU_ASSERT_EQUAL(written_now(model, "contacts"), 1);
      written_cycles(model, 1);
    }
    nb_model_free(model);
    written_free(&it);
  }
}

/* The magnitude of the force on a disc of radius 1 at rest at (x, y), and its number of contacts. At (90, 90) the disc is
 * far smaller. */
static double push(const char *walls, double x, double y, double *contacts) {
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial m density 1 kn 100\nstep 1e-3\n%s\ndisc %.17g %.17g radius %g m\nmonitor D disc 1\n"
            "record D.fx D.fy contacts\nstage s\ncycles 1\n",
            walls, x, y, x < 90 || x > 90 ? 1 : 1e-3);
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  const double force = hypot(written_now(model, "D.fx"), written_now(model, "D.fy"));
  *contacts = written_now(model, "contacts");
  nb_model_free(model);
  written_free(&it);
  return force;
}

static void one_contact_at_a_corner(void) {
  const char *corner = "wall a -9 0 to 0 0 m\nwall b 0 0 to 0 -9 m"; /* a disc outside the corner, then one inside */
  double contacts;
  for (double angle = -0.1; angle < pi / 2 + 0.1; angle += 0.05) { /* around the corner, from above to the right */
    const double x = 0.9 * sin(angle), y = 0.9 * cos(angle);
    const double alpha = x < 0 ? 1 - y : y < 0 ? 1 - x : 0.1;
    CU_ASSERT_DOUBLE_EQUAL(push(corner, x, y, &contacts), 100 * alpha, 1e-9);
    CU_ASSERT_EQUAL(contacts, 1);
  }
  CU_ASSERT_DOUBLE_EQUAL(push(corner, -0.9, -0.8, &contacts), 100 * hypot(0.1, 0.2), 1e-9); /* inside: two contacts */
  CU_ASSERT_EQUAL(contacts, 2);
  push("wall a -9 0 to 0 0 m\nwall b 0 0 to 9 0 m\nwall c 0 0 to 0 -9 m", 0, 0.9,
       &contacts); /* three walls with a common end */
  CU_ASSERT_EQUAL(contacts, 1);
  push("wall a -9 0 to -1e-10 0 m\nwall b 1e-10 0 to 9 0 m", 0, 0.9, &contacts); /* a gap below 1e-9 of the radius */
  CU_ASSERT_EQUAL(contacts, 1);
  push("wall a -9 0 to -1e-6 0 m\nwall b 1e-6 0 to 9 0 m", 0, 0.9, &contacts); /* a larger gap: two ends */
  CU_ASSERT_EQUAL(contacts, 2);
  push("wall a -9 0 to 1 0 m", 1.1, 0.9, &contacts); /* a wall and its end */
  CU_ASSERT_EQUAL(contacts, 1);
  /* The largest particle decides whether ends may be common, whatever its number. */
  push("disc 0 0.9 radius 1 m\nwall a -9 0 to -1e-10 0 m\nwall b 1e-10 0 to 9 0 m", 90, 90, &contacts);
  CU_ASSERT_EQUAL(contacts, 1);
  push("disc 0 0.9 radius 1 m\nwall a -9 0 to -1e-9 0 m\nwall b 1e-9 0 to 9 0 m\ndisc 50 50 radius 4 m", 90, 90,
       &contacts); /* each particle has its own limit */
  CU_ASSERT_EQUAL(contacts, 2);
  /* Far from the origin in x, in y and in both, where common ends differ by rounding, for all combinations of ends. */
  for (int k = 0; k < 80; k++) {
    char walls[512];
    const double x = (k % 3 > 0 ? 1e8 : 0) + 1.7 * k, y = (k % 3 < 2 ? -3e8 : 0) - 0.3 * k, ex = cos(0.3 * k),
                 ey = sin(0.3 * k);
    const double a[2][2] = {{x - 9.7 * ex, y - 9.7 * ey}, {x, y}}, b[2][2] = {{x, y}, {x + 85.7 * ex, y + 85.7 * ey}};
    const int from_a = k & 1, from_b = k >> 1 & 1;
    snprintf(walls, sizeof walls, "wall a %.17g %.17g to %.17g %.17g m\nwall b %.17g %.17g to %.17g %.17g m",
             a[from_a][0], a[from_a][1], a[!from_a][0], a[!from_a][1], b[from_b][0], b[from_b][1], b[!from_b][0],
             b[!from_b][1]);
    push(walls, x - 0.9 * ey, y + 0.9 * ex, &contacts); /* at the common end of two walls in line, */
    CU_ASSERT_EQUAL(contacts, 1);
    push(walls, x - 0.9 * ey + 0.1 * ex, y + 0.9 * ex + 0.1 * ey, &contacts); /* and a little beyond it */
    CU_ASSERT_EQUAL(contacts, 1);
  }
}

/* The rotation is exact for any angle, even for 1 rad in one step. */
static void one_radian(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 1\ndisc 9 9 radius 1 m\nwall w -3 0 to 3 0 m spin 1\nstep "
                   "1\nallow unstable\n"
                   "stage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  written_cycles(model, 1);
  CU_ASSERT_DOUBLE_EQUAL(model->walls.along[0].x, cos(1), 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(model->walls.along[0].y, sin(1), 1e-15);
  nb_model_free(model);
  written_free(&it);
}

/* ---- crossing a wall ---- */

/* Runs the statements for at most 1000 cycles. The run must be aborted with a message that contains `wanted`; NULL: it
 * must not be aborted. It must end after `cycle` cycles; -1: any number. */
static void through(const char *statements, const char *wanted, long cycle) {
  struct words page = {0};
  struct written it;
  struct nb_error error = {0};
  words_add(&page,
            "units none\nmaterial m density 1 kn 10\nstep 0.01\n%s\nmonitor D disc 1\nrecord D.x D.y\nallow "
            "unstable\nstage s\n"
            "cycles 1000\n",
            statements);
  written_scene(&it, &page);
  struct nb_model *model = nb_model_create(&it.scene, NULL, &error);
  enum nb_status status = model ? NB_OK : error.status;
  if (model) { /* the counters of the stage differ from those of the run, as in a later stage */
    status = nb_stage_begin(model, &it.scene.stages[0], &error);
    model->stage_cycle += 4, model->stage_time -= 4 * model->step;
  }
  for (int n = 0; n < 1000 && !status; n++)
    status = nb_cycle(model, &error);
  if ((status == NB_BROKEN) != (wanted != NULL) || (wanted && !strstr(error.text, wanted)))
    printf("# %s: status %d, %s\n", statements, status, error.text);
  CU_ASSERT((status == NB_BROKEN) == (wanted != NULL));
  CU_ASSERT(!wanted || strstr(error.text, wanted));
  CU_ASSERT(!model || cycle < 0 || (long)model->cycle == cycle);
  nb_model_free(model);
  written_free(&it);
}

static void every_crossing_stops_the_run(void) {
  const char *passed = "particle 1 (line 5) passed through wall `w` (line 6)";
  through("disc 0 1.45 radius 1 m velocity 0 -99\nwall w -5 0 to 5 0 m", passed, 2); /* touches after the first step */
  through("disc 0 0.95 radius 1 m velocity 0 -99\nwall w -5 0 to 5 0 m", passed, 1);
  through("disc 0 10.5 radius 1 m velocity 0 -1e6\nwall w -5 0 to 5 0 m", passed, 1); /* from afar, in one step */
  through("disc 0 3 radius 1 m velocity 0 -30\nwall w -5 0 to 5 0 m", passed, -1);    /* pressed through */
  through("material h density 1e9 kn 10\ndisc 0 0.5 radius 1e-3 h velocity 0 -0.09\nwall w -5 0 to 5 0 m\n"
          "disc 50 50 radius 30 m",
          "particle 1 (line 6) passed through wall `w` (line 7)", 556);
  through(
      "disc 0 3 radius 2 m\nwall w -5 0 to 5 0 m velocity 0 1000", /* the wall was too fast */
      "particle 1 (line 5) passed through wall `w` (line 6) in cycle 1, at time 0.01: its centre is now on the other "
      "side. The limit of the overlap with a wall is the particle's radius, 2; in this step of 0.01 it moved 10 "
      "relative to the wall: try a smaller step",
      1);
  through("disc 0 3 radius 1 m\nwall w -5 0 to 5 0 m spin 2000",
          "wall `w` (line 6): in cycle 1, at time 0.01, it turned by 20 rad", 1);
  through("material h density 1e9 kn 10\ndisc 0 0.5 radius 1e-3 h velocity 0 -0.09\nwall w -5 0 to 5 0 m about 1 -2\n"
          "disc 50 50 radius 30 m",
          "particle 1 (line 6) passed through wall `w` (line 7)", 556);
  through("disc 0 1e-3 radius 1e-6 m velocity 0 -30\nwall w -5 0 to 5 0 m about 1 -2\ndisc 50 50 radius 30 m", passed,
          1);
  /* The disc and the wall each move by less than half the skin, so there is no search. They are at the distance 3 at
   * first, and approach each other at the speed 1.8. */
  through("skin 4\nmaterial h density 1e9 kn 10\ndisc 0 3 radius 0.02 h velocity 0 -0.9\n"
          "wall w -5 0 to 5 0 m velocity 0 0.9\ndisc 50 50 radius 30 m",
          "particle 1 (line 7) passed through wall `w` (line 8)", 167);
  /* just beyond the wall, and moving away */
  through("disc 0 -1e-4 radius 1e-6 m velocity 0 -9e-5\nwall w -5 0 to 5 0 m\ndisc 50 50 radius 30 m", NULL, 1000);
  through("disc 0 -1e-4 radius 1e-6 m\nwall w -5 0 to 5 0 m velocity 0 30\ndisc 50 50 radius 30 m", NULL, 1000);
  through("disc 90 2 radius 1e-3 m\nwall w -100 0 to 100 0 m spin 5\ndisc 500 500 radius 30 m", passed,
          1); /* a long wall */
  through("disc 0 3 radius 1 m velocity 0 -999\nwall w -5 0 to 0 0 m\nwall v 0 0 to 5 0 m", "passed through wall", 1);
  through("disc 0 0 radius 1 m\nwall w -5 0 to 5 0 m", "on neither side", 0);
  through("disc 50 50 radius 1 m\ndisc 0 0 radius 1 m\nwall w -5 0 to 5 0 m",
          "particle 2 (line 6) has its centre on wall `w` (line 7)", 0);
  through("disc 50 50 radius 1 m\ndisc 0 3 radius 1 m velocity 0 -999\nwall w -5 0 to 5 0 m",
          "particle 2 (line 6) passed through wall `w` (line 7)", 1);
  through("disc 0 3 radius 1 m velocity 0 -1\nwall w -5 0 to 5 0 m", NULL, 1000);  /* bounces */
  through("disc 7 3 radius 1 m velocity 0 -99\nwall w -5 0 to 5 0 m", NULL, 1000); /* past the wall's end */
  through("disc 0 3 radius 1 m velocity 0 -999 fixed\nwall w -5 0 to 5 0 m", NULL,
          1000); /* fixed particles may cross */
  through("disc 0 3 radius 1 m velocity 5 -2\nwall w -5 0 to 5 0 m velocity 5 -2 spin 0.01", NULL, 1000);
}

/* A particle or a wall that is too fast is found in each of the four directions along x and y and on both sides of the
 * wall. In each scene the wall is on the x axis and the particle beside it at the place x, on the side y; all is then
 * mirrored and rotated by multiples of 90 degrees. */
static void crossings_in_all_directions(void) {
  static const struct {
    struct nb_vec x;
    double speed, wall_speed, spin; /* of the particle towards the wall, of the wall towards the particle */
  } rows[] = {{{1, 3}, 1000, 0, 0}, {{1, 3}, 0, 1000, 0}, {{90, 2}, 0, 0, 5}, {{-90, 2}, 0, 0, -5}};
  for (size_t r = 0; r < sizeof rows / sizeof *rows; r++)
    for (int k = 0; k < 8; k++) {
      static const int cosine[] = {1, 0, -1, 0}, sine[] = {0, 1, 0, -1};
      const int c = cosine[k % 4], s = sine[k % 4], side = k < 4 ? 1 : -1;
      const double x = rows[r].x.x, y = side * rows[r].x.y, v = -side * rows[r].speed, w = side * rows[r].wall_speed;
      char text[256];
      snprintf(text, sizeof text,
               "disc %g %g radius 1e-3 m velocity %g %g\nwall w %d %d to %d %d m velocity %g %g spin %g\n"
               "disc 500 500 radius 30 m",
               c * x - s * y, s * x + c * y, -s * v, c * v, -100 * c, -100 * s, 100 * c, 100 * s, -s * w, c * w,
               side * rows[r].spin);
      through(text, "particle 1 (line 5) passed through wall `w` (line 6) in cycle 1,", 1);
    }
}

void suite_walls(void) {
  CU_pSuite suite = CU_add_suite("walls", NULL, NULL);
  CU_add_test(suite, "rotation of a wall is exact", rotation_is_exact);
  CU_add_test(suite, "a rotation by 1 rad in one step is exact", one_radian);
  CU_add_test(suite, "velocity of a point of a wall", velocity_of_a_point);
  CU_ADD_TEST(suite, a_wall_that_moves_away_has_a_contact_at_once);
  CU_add_test(suite, "common ends are those of time 0", common_ends_are_those_of_time_0);
  CU_add_test(suite, "no jump at a vertex of a straight floor", no_jump_on_a_straight_vertex);
  CU_ADD_TEST(suite, impacts_on_a_vertex);
  CU_ADD_TEST(suite, a_jump_away_from_a_vertex);
  CU_add_test(suite, "one contact at a corner", one_contact_at_a_corner);
  CU_add_test(suite, "every crossing stops the run", every_crossing_stops_the_run);
  CU_ADD_TEST(suite, crossings_in_all_directions);
}
