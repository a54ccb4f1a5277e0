/* Statements at the limits of their values: the last valid value and the first one that is refused.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../src/input/scene.h"
#include "suites.h"
#include "written.h"

struct row {
  const char *statements; /* `|` separates lines */
  const char *refused;    /* a part of the message; NULL: the statements are valid */
};

/* Reads a page of this head, the statements of a row and this end, and tests whether it is refused. */
static void read_rows(const struct row *rows, size_t count, const char *head, const char *end) {
  for (size_t k = 0; k < count; k++) {
    struct words words = {0};
    struct nb_mistakes mistakes = {0};
    struct nb_page page = {0};
    struct nb_scene scene = {0};
    words_add(&words, "%s%s%s```\n", head, rows[k].statements, end);
    for (char *c = words.text; (c = strchr(c, '|'));)
      *c = '\n';
    nb_page_read_bytes(&page, "limits.md", words.text, words.length, &mistakes);
    nb_scene_read(&scene, &page, 0, NULL, &mistakes);
    const bool as_wanted =
        rows[k].refused ? mistakes.count == 1 && strstr(mistakes.text, rows[k].refused) : mistakes.count == 0;
    if (!as_wanted)
      printf("# %s: %s\n", rows[k].statements, mistakes.text ? mistakes.text : "valid");
    CU_ASSERT(as_wanted);
    nb_mistakes_free(&mistakes), nb_scene_free(&scene), nb_page_free(&page), free(words.text);
  }
}
#define READ(rows, head, end) read_rows(rows, sizeof rows / sizeof *rows, head, end)

#define SCENE "```scene\nunits none\nmaterial m density 1 kn 1 ks 1 friction 1\n"
#define RUN "\nstep 1e-3\nrecord time\nstage a\ncycles 1\n"

/* The first corner has the smallest x and the smallest y. */
static void corners(void) {
  static const struct row rows[] = {
      {"cell 5 0 to 6 1", NULL},
      {"cell 1000 1000 to 1000.5 1000.5", NULL},
      {"cell 1000.5 1000 to 1000 1000.5", "corner"},
      {"cell 1000 1000.5 to 1000.5 1000", "corner"},
      {"cell 1000 1000 to 1000 1000.5", "corner"},
      {"cell 1000 1000 to 1000.5 1000", "corner"},
      {"grading g 0.1 1|fill discs box 5 0 to 6 1 g m seed 1 attempts 9 else skip", NULL},
      {"grading g 0.1 1|fill discs box 1000 1000 to 1000.5 1000.5 g m seed 1 attempts 9 else skip", NULL},
      {"grading g 0.1 1|fill discs box 1000.5 1000 to 1000 1000.5 g m seed 1 attempts 9 else skip", "corner"},
      {"grading g 0.1 1|fill discs box 1000 1000.5 to 1000.5 1000 g m seed 1 attempts 9 else skip", "corner"},
      {"region A box 5 0 to 6 1", NULL},
      {"region A box 1000 1000 to 1000.5 1000.5", NULL},
      {"region A box 1000.5 1000 to 1000 1000.5", "corner"},
      {"region A box 1000 1000.5 to 1000.5 1000", "corner"},
  };
  READ(rows, SCENE, "\ndisc 1 1 radius 0.1 m" RUN);
}

/* A side of the cell is at least 2 (2 R + skin), R the largest radius. The skin is a tenth of the mean radius. */
static void cells(void) {
  static const struct row rows[] = {
      {"cell 0 0 to 5 5|skin 0.5|disc 1 1 radius 1 m|disc 3 3 radius 1 m", NULL},
      {"cell 0 0 to 4.99 5|skin 0.5|disc 1 1 radius 1 m|disc 3 3 radius 1 m", "at least 5, twice"},
      {"cell 0 0 to 5 4.99|skin 0.5|disc 1 1 radius 1 m|disc 3 3 radius 1 m", "found 4.99"},
      {"cell 0 0 to 7 7|skin 1.5|disc 1 1 radius 1 m|disc 3 3 radius 1 m", NULL},
      {"cell 0 0 to 6.99 7|skin 1.5|disc 1 1 radius 1 m|disc 3 3 radius 1 m", "at least 7, twice"},
      {"cell 0 0 to 4.151 4.151|disc 1 1 radius 1 m|disc 3 3 radius 0.5 m", NULL},
      {"cell 0 0 to 4.149 4.151|disc 1 1 radius 1 m|disc 3 3 radius 0.5 m", "at least 4.15, twice"},
      {"cell 0 0 to 1 1|disc 1 1 radius 1 m", NULL},                      /* it has no neighbours */
      {"cell 0 0 to 1 1|disc 1 1 radius 1 m|disc 3 3 radius 1 n", "`n`"}, /* only the mistake of the particle */
      {"cell 0 0 to 1 1|disc 1 1 radius 1 m|disc 2 2 radius 1 m|disc 3 3 radius 1 n", "`n`"},
      {"cell 0 0 to 9 9|disc 1 1 radius 1 m|perturb wave 1 1 periods 1000000 -1000000", NULL},
      {"cell 0 0 to 9 9|disc 1 1 radius 1 m|perturb wave 1 1 periods -1000000 1000000", NULL},
      {"cell 0 0 to 9 9|disc 1 1 radius 1 m|perturb wave 1 1 periods 1000001 0", "found 1000001 and 0"},
      {"cell 0 0 to 9 9|disc 1 1 radius 1 m|perturb wave 1 1 periods 0 -1000001", "found 0 and -1000001"},
      {"cell 0 0 to 9 9|disc 1 1 radius 1 m|perturb wave 1 1 periods 0.5 0", "found 0.5 and 0"},
      {"cell 0 0 to 9 9|disc 1 1 radius 1 m|perturb wave 1 1 periods 0 0.5", "found 0 and 0.5"},
  };
  READ(rows, SCENE, RUN);
}

/* An angle of incidence is below 90 deg, and the particle has no velocity of its own. Without friction psi1 = 0 is the
 * only value; a contact without shear stiffness has an infinite compliance ratio. */
static void impacts(void) {
  static const struct row rows[] = {
      {"disc 0 2 radius 1 m|monitor C disc 1 with wall w|impact C speed 1 angle 0", NULL},
      {"disc 0 2 radius 1 m|monitor C disc 1 with wall w|impact C speed 1 angle (89.95*pi/180)", NULL},
      {"disc 0 2 radius 1 m|monitor C disc 1 with wall w|impact C speed 1 angle (pi/2)", "below 90 deg"},
      {"disc 0 2 radius 1 m|monitor C disc 1 with wall w|impact C speed 1 psi1 1", NULL},
      {"disc 0 2 radius 1 m velocity 1 0|monitor C disc 1 with wall w|impact C speed 1 angle 0", "without `velocity`"},
      {"disc 0 2 radius 1 m velocity 0 1|monitor C disc 1 with wall w|impact C speed 1 angle 0", "without `velocity`"},
      {"disc 0 2 radius 1 f|monitor C disc 1 with wall w|impact C speed 1 psi1 0", NULL},
      {"disc 0 2 radius 1 f|monitor C disc 1 with wall w|impact C speed 1 psi1 0.1", "friction and a shear"},
  };
  READ(rows, SCENE "material f density 1 kn 1\nwall w -9 0 to 9 0 m\n", RUN);
}

/* A statement about particles with a mistake: the number in a monitor below cannot be checked, so it is no mistake. */
static void incomplete_particles(void) {
  static const struct row rows[] = {
      {"disc 0 0 radius 1 m|monitor D disc 2", "from 1 to 1"},
      {"monitor D disc 2|disc 0 0 radius 1 m", "a particle that is defined above, found none"},
      {"disc 0 0 radius 1 m|sphere 0 9 radius 1 m|monitor D disc 2", "expected `sphere`, because particle 2 is one"},
      {"disc 0 0 radius 1 m|sphere 0 9 radius 1 m|monitor D sphere 1", "expected `disc`, because particle 1 is one"},
      {"disc 0 0 radius 1 m|sphere 0 9 radius 1 m|monitor D sphere 2 with disc 1", NULL},
      {"disc 0 0 radius 1 m|monitor D disc 1 with disc 1", "expected two different particles"},
      {"disc 0 0 radius 1 x|monitor D disc 2", "`x`"},
      {"sphere 0 0 radius 1 x|monitor D disc 2", "`x`"},
      {"lattice discs 2 by 2 radius 1 x|monitor D disc 2", "`x`"},
      {"fill discs circle 0 0 radius 9 x m seed 1 attempts 9 else skip|monitor D disc 2", "`x`"},
      {"packing x.tsv discs m|monitor D disc 2", "x.tsv"},
      {"disc 0 0 radius 1 m|disc 0 0 radius 1 x|monitor D disc 3 with sphere 4", "`x`"},
  };
  READ(rows, SCENE, RUN);
}

/* A scene has at most 10 million particles. The fillings stop after one particle of each size that does not fit. */
static void most_particles(void) {
#define FILL "|fill discs circle 0 0 radius 1 g m seed 1 attempts 1 else skip"
  static const struct row rows[] = {
      {"grading g 1 10000000" FILL, NULL},
      {"grading g 0.9 1 1 10000000" FILL, "found 10000001 with this statement"},
      {"disc 9 9 radius 1 m|grading g 1 9999999" FILL, NULL},
      {"disc 9 9 radius 1 m|grading g 1 10000000" FILL, "found 10000001 with this statement"},
      {"disc 9 9 radius 1 m|lattice discs 10000 by 1000 radius 1 m", "found 10000001 with this statement"},
      {"lattice discs 1000000000 by 1000000000 radius 1 m", "found 1000000000000000000 with this statement"},
      {"grading g 1 10000001", "from 1 to 10000000"},
  };
  READ(rows, SCENE, "\ndisc 9 0 radius 1 m" RUN);
}

/* The coordinates of a lattice are finite. Free particles need a density. */
static void particles(void) {
  static const struct row rows[] = {
      {"lattice discs 1 by 1 radius 1 m spacing 1e308", NULL},
      {"lattice discs 2 by 1 radius 1 m spacing 1e308", "finite coordinates"},
      {"lattice discs 1 by 2 radius 1 m spacing 1e308", "finite coordinates"},
      {"lattice discs square 2 by 1 from 20 20 radius 1 m", NULL},
      {"lattice discs hexagonal 2 by 1 from 20 20 radius 1 m", NULL},
      {"lattice discs square hexagonal 2 by 1 radius 1 m", "`square` or `hexagonal`, found both"},
      {"disc 5 5 radius 1 n fixed", NULL},
      {"disc 5 5 radius 1 n", "a material with a density for a free particle"},
      {"sphere 5 5 radius 1 n", "a material with a density for a free particle"},
      {"lattice discs 2 by 1 radius 1 n", "a material with a density for a free particle"},
      {"grading g 1 1|fill discs circle 0 0 radius 5 g n seed 1 attempts 9 else skip",
       "a material with a density for a free particle"},
      {"grading g 1 1|fill discs circle 0 0 radius 5 g m seed 1 attempts 1000000 else skip", NULL},
      {"grading g 1 1|fill discs circle 0 0 radius 5 g m seed 1 attempts 1000001 else skip",
       "at most 1000000 attempts"},
      {"grading g 1 1 2 1 1 3", "each radius once"},
      {"grading g 1 1|monitor G grading g|monitor H grading g radius 1", NULL},
      {"grading g 3 1 2 1 1 1|monitor A grading g radius 3|monitor B grading g radius 2|monitor C grading g radius 1",
       NULL},
      {"grading g 1 1|monitor G grading g radius 2", "expected one of the radii of the grading `g`"},
      {"grading g 1 1|monitor G grading h", "expected the name of a grading, found `h`"},
  };
  READ(rows, SCENE "material n kn 1\n", "\ndisc 0 0 radius 1 m" RUN);
}

/* A lattice begins at (R, R), and its particles touch, unless the statement says something else. */
static void lattices(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 1\nlattice discs 2 by 2 radius 3 m\n"
                   "lattice discs 2 by 1 radius 3 m from 50 60 spacing 7\n"
                   "lattice spheres hexagonal 1 by 2 radius 2 m from 80 90\n"
                   "step 1e-3\nrecord time\nstage a\ncycles 1\n");
  written_scene(&it, &page);
  static const double wanted[][3] = {{3, 3, 3},   {9, 3, 3},   {3, 9, 3},   {9, 9, 3},
                                     {50, 60, 3}, {57, 60, 3}, {80, 90, 2}, {82, 93.46410161513775, 2}}; /* 2 sqrt(3) */
  CU_ASSERT_EQUAL_FATAL(it.scene.particle_count, 8);
  for (size_t k = 0; k < 8; k++) {
    const struct nb_particle *particle = &it.scene.particles[k];
    CU_ASSERT_DOUBLE_EQUAL(particle->x, wanted[k][0], 1e-12);
    CU_ASSERT_DOUBLE_EQUAL(particle->y, wanted[k][1], 1e-12);
    CU_ASSERT_EQUAL(particle->radius, wanted[k][2]);
    CU_ASSERT_EQUAL(particle->shape, k < 6 ? NB_DISC : NB_SPHERE);
    CU_ASSERT_EQUAL(particle->line, k < 4 ? 4 : k < 6 ? 5 : 6);
  }
  written_free(&it);
}

/* ---- regions ---- */

static void regions(void) {
  static const struct row rows[] = {
      {"region A circle 0 0 radius 1 rings 1", NULL},
      {"region A circle 0 0 radius 1 rings 1000", NULL},
      {"region A circle 0 0 radius 1 rings 1001", "from 1 to 1000"},
      {"region A circle 0 0 radius 1 rings 0", "from 1 to 1000"},
      {"region A all rings 2", "expected the end of the line, or `from STAGE`"},
      {"region A box 0 0 to 1 1 rings 2", "expected the end of the line, or `from STAGE`"},
      {"boundary circle 0 0 radius 9|region A inside 1 rings 2", NULL},
      {"boundary circle 0 0 radius 9|region A inside 0", NULL},
      {"boundary circle 0 0 radius 9|region A inside 1.001", "from 0 to 1"},
      {"region A inside 0.5", "expected a scene with a boundary, found none"},
      {"region A inside 0.5|boundary circl 0 0 radius 9", "circl"},
      {"region A all from a", NULL},
      {"region A all from b", "expected the name of a stage of this page, found `b`"},
      {"region A all from a|region A all", "there is a region `A` already, on line 5"},
      {"monitor A disc 1|region A all", "there is a monitor `A` already, on line 5"},
      {"region A all|monitor A disc 1", "there is a region `A` already, on line 5"},
      {"monitor A disc 1|monitor A disc 1", "there is a monitor `A` already, on line 5"},
  };
  static const struct row later[] = {{"boundary circle 0 0 radius 9", NULL}, {"", "a scene with a boundary"}};
  static const struct row repeated[] = {
      {"repeat from a 1 more time", NULL},
      {"repeat from a x more times", "`x`"}, /* the name may be that of a repetition */
      {"stage b|cycles 1", "the name of a stage of this page, found `a-2`"}};
  READ(rows, SCENE "disc 0 0 radius 1 m\n", RUN);
  READ(repeated, SCENE "disc 0 0 radius 1 m\nregion A all from a-2" RUN, "\n");
  READ(later, SCENE "disc 0 0 radius 1 m\nregion A inside 0.5" RUN "stage b\ncycles 1\nstage c\ncycles 1\n", "\n");
}

static void shapes_of_regions(void) {
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nboundary circle 0 0 radius 9\n"
            "region A circle 1 2 radius 3 rings 4 from b\nregion B box 1 2 to 5 10 from c\nregion C inside 0.25\n"
            "region D all\nstep 1e-3\nrecord time\nstage a\ncycles 1\nstage b\ncycles 1\nstage c\ncycles 1\n");
  written_scene(&it, &page);
  CU_ASSERT_EQUAL_FATAL(it.scene.region_count, 4);
  const struct nb_region *a = &it.scene.regions[0], *b = a + 1, *c = a + 2, *d = a + 3;
  CU_ASSERT(a->kind == NB_REGION_CIRCLE && a->x == 1 && a->y == 2 && a->radius == 3 && a->rings == 4);
  CU_ASSERT(b->kind == NB_REGION_BOX && b->x == 3 && b->y == 6 && b->half_x == 2 && b->half_y == 4);
  CU_ASSERT(c->kind == NB_REGION_INSIDE && c->radius == 0.25 && c->rings == 0);
  CU_ASSERT_EQUAL(d->kind, NB_REGION_ALL);
  CU_ASSERT(b->ex == 1 && b->ey == 0 && d->ex == 1 && d->ey == 0);
  CU_ASSERT(a->stage == 1 && b->stage == 2 && c->stage == -1 && d->stage == -1);
  for (int k = 0; k < 4; k++) {
    CU_ASSERT_EQUAL(it.scene.monitors[k].kind, NB_MONITOR_REGION);
    CU_ASSERT_EQUAL(it.scene.monitors[k].a, k);
    CU_ASSERT_EQUAL(a[k].line, 6 + k);
  }
  written_free(&it);
}

/* ---- servo ---- */

static void targets_of_servos(void) {
  static const struct {
    const char *scene, *servo;
    bool controlled[3], mean, cell, box, affine, per_cycle;
    double stress[3], rate;
    unsigned long every;
  } rows[] = {
      {"cell 0 0 to 9 9", "isotropic 5 on cell through cell at most 2", {1, 1, 1}, 0, 1, 0, 0, 0, {5, 5, 0}, 2, 10},
      {"cell 0 0 to 9 9", "mean 5 on cell through cell at most 2", {1, 1, 1}, 1, 1, 0, 0, 0, {5, 5, 0}, 2, 10},
      {"cell 0 0 to 9 9", "xx 5 on cell through cell at most 2", {1, 0, 0}, 0, 1, 0, 0, 0, {5, 0, 0}, 2, 10},
      {"cell 0 0 to 9 9", "yy 6 on cell through cell at most 2", {0, 1, 0}, 0, 1, 0, 0, 0, {0, 6, 0}, 2, 10},
      {"cell 0 0 to 9 9", "xy 7 on cell through cell at most 2", {0, 0, 1}, 0, 1, 0, 0, 0, {0, 0, 7}, 2, 10},
      {"cell 0 0 to 9 9", "xx 5 xy 7 on cell through cell at most 2", {1, 0, 1}, 0, 1, 0, 0, 0, {5, 0, 7}, 2, 10},
      {"box 0 0 to 9 9 m", "isotropic 5 on box through box at most 2", {1, 1, 0}, 0, 0, 1, 0, 0, {5, 5, 0}, 2, 10},
      {"box 0 0 to 9 9 m", "yy 5 on walls through box at most 2", {0, 1, 0}, 0, 0, 1, 0, 0, {0, 5, 0}, 2, 10},
      {"boundary circle 4 4 radius 9",
       "isotropic 5 on boundary through boundary affine at most 2 per cycle every 3 cycles",
       {1, 1, 1},
       0,
       0,
       0,
       1,
       1,
       {5, 5, 0},
       2,
       3},
      {"boundary circle 4 4 radius 9",
       "xy 5 on M through boundary at most 2",
       {0, 0, 1},
       0,
       0,
       0,
       0,
       0,
       {0, 0, 5},
       2,
       10},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1 kn 1\n%s\ndisc 5 5 radius 1 m\nregion M all\nstep 1\nrecord time\n"
              "stage a\nservo %s\ncycles 1\n",
              rows[k].scene, rows[k].servo);
    written_scene(&it, &page);
    const struct nb_servo *servo = &it.scene.stages[0].servo;
    for (int c = 0; c < 3; c++) {
      CU_ASSERT_EQUAL(servo->controlled[c], rows[k].controlled[c]);
      CU_ASSERT_EQUAL(servo->stress[c], rows[k].stress[c]);
    }
    CU_ASSERT_EQUAL(servo->mean, rows[k].mean);
    CU_ASSERT_EQUAL(servo->cell, rows[k].cell);
    CU_ASSERT_EQUAL(servo->box, rows[k].box);
    CU_ASSERT_EQUAL(servo->affine, rows[k].affine);
    CU_ASSERT_EQUAL(servo->per_cycle, rows[k].per_cycle);
    CU_ASSERT_EQUAL(servo->max_rate, rows[k].rate);
    CU_ASSERT_EQUAL(servo->every, rows[k].every);
    CU_ASSERT_EQUAL(servo->line, 10);
    CU_ASSERT(servo->axis_x[0] == 1 && servo->axis_x[1] == 0 && servo->axis_y[0] == 0 && servo->axis_y[1] == 1);
    static const char *const parts[] = {"xx", "xy", "yx", "yy"};
    for (int c = 0; c < 4; c++) { /* the measured quantities are those of the place after `on` */
      char name[64], place[16];
      struct nb_quantity wanted;
      sscanf(strstr(rows[k].servo, "on "), "on %15s", place);
      snprintf(name, sizeof name, "%s.stress.%s", place, parts[c]);
      CU_ASSERT(nb_quantity_find(&wanted, &it.scene, name));
      CU_ASSERT_PTR_EQUAL(servo->quantity[c].kind, wanted.kind);
      CU_ASSERT_PTR_EQUAL(servo->quantity[c].suffix, wanted.suffix);
      CU_ASSERT_EQUAL(servo->quantity[c].monitor, wanted.monitor);
    }
    written_free(&it);
  }
}

/* ---- contact tests ---- */

/* A segment with `follow` has one step for each point of its file. --set follow=FILE replaces all segments of a page, which
 * may have none, by one, with a snapshot if any of them has one. */
static void files_of_points(void) {
  static const struct {
    const char *segments;
    bool set, snapshot;
  } rows[] = {
      {"segment a follow %s\n", false, false},
      {"segment a follow %s\nsnapshot\n", false, true},
      {"", true, false},
      {"segment a overlap to 1\nsegment b slip by 1\n", true, false},
      {"segment a overlap to 1\nsnapshot\nsegment b slip by 1\n", true, true},
      {"segment a overlap to 1\nsegment b slip by 1\nsnapshot\n", true, true},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    char path[] = "/tmp/nineball-points-XXXXXX", segments[256], setting[64];
    const char *settings[] = {setting, NULL};
    struct words page = {0};
    struct written it;
    FILE *file = written_file(path);
    fputs("approach/-\tslip/-\n1\t0\n2\t0.25\n3\t-0.5\n", file);
    fclose(file);
    snprintf(segments, sizeof segments, rows[k].segments, path);
    snprintf(setting, sizeof setting, "follow=%s", path);
    words_add(&page,
              "path\nunits none\nmaterial rock young 1 poisson 0.3 friction 0.5\nnormal hertz\n"
              "shear mindlin_deresiewicz\ncontact sphere 4 rock with wall rock\n%s",
              segments);
    written_scene_set(&it, &page, rows[k].set ? settings : NULL);
    CU_ASSERT_EQUAL_FATAL(it.scene.stage_count, 1);
    const struct nb_stage *stage = &it.scene.stages[0];
    CU_ASSERT_STRING_EQUAL(stage->name, rows[k].set ? "follow" : "a");
    CU_ASSERT_EQUAL(it.scene.path_replaced, rows[k].set);
    CU_ASSERT_EQUAL(stage->cycles, 3);
    CU_ASSERT_EQUAL(stage->record_interval, 1);
    CU_ASSERT_EQUAL(stage->snapshot, rows[k].snapshot);
    CU_ASSERT_EQUAL_FATAL(stage->segment.point_count, 3);
    CU_ASSERT_EQUAL(stage->segment.points[1].approach, 2);
    CU_ASSERT_EQUAL(stage->segment.points[2].slip, -0.5);
    const struct nb_wall *wall = &it.scene.walls[0]; /* along y, as long as the diameter of the particle */
    CU_ASSERT(wall->ex == 0 && wall->ey == 1 && wall->h1 == -4 && wall->h2 == 4);
    written_free(&it);
    unlink(path);
  }
}

/* What segments set: values or differences, forces or displacements, and 100 steps unless they say something else. */
static void parts_of_segments(void) {
  static const struct {
    const char *segment;
    struct nb_target normal, shear;
    unsigned long steps;
  } rows[] = {
#define KEPT {false, true, 0}
      {"overlap to 2", {false, false, 2}, KEPT, 100},
      {"overlap by 2", {false, true, 2}, KEPT, 100},
      {"normal to 2 in 7 steps", {true, false, 2}, KEPT, 7},
      {"normal by -2", {true, true, -2}, KEPT, 100},
      {"slip to -3", KEPT, {false, false, -3}, 100},
      {"slip by 3 in 1 step", KEPT, {false, true, 3}, 1},
      {"shear to -3 hold normal", {true, true, 0}, {true, false, -3}, 100},
      {"in 9 steps shear by 3 overlap to 1", {false, false, 1}, {true, true, 3}, 9},
      {"hold shear overlap by 1", {false, true, 1}, {true, true, 0}, 100},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "path\nunits none\nmaterial rock kn 1 ks 1 friction 0.5\ncontact disc 4 rock with disc 5 rock\n"
              "segment a %s\n",
              rows[k].segment);
    written_scene(&it, &page);
    const struct nb_segment *segment = &it.scene.stages[0].segment;
    const struct nb_target *got[] = {&segment->normal, &segment->shear}, *wanted[] = {&rows[k].normal, &rows[k].shear};
    for (int t = 0; t < 2; t++) {
      CU_ASSERT_EQUAL(got[t]->force, wanted[t]->force);
      CU_ASSERT_EQUAL(got[t]->relative, wanted[t]->relative);
      CU_ASSERT_EQUAL(got[t]->value, wanted[t]->value);
    }
    CU_ASSERT_EQUAL(it.scene.stages[0].cycles, rows[k].steps);
    written_free(&it);
  }
}

/* ---- damping ---- */

/* What statements set: `none` sets all five settings, a statement for contacts those of walls too, unless they have their
 * own. */
static void settings_of_damping(void) {
  static const struct {
    const char *statements;
    struct nb_damping wanted;
  } rows[] = {
      {"damping stiffness 0.1", {.contact_kind = NB_CONTACT_STIFFNESS, .contact = 0.1}},
      {"damping r89-fraction 0.2", {.contact_kind = NB_CONTACT_R89_FRACTION, .contact = 0.2}},
      {"damping ratio 0.3", {.contact_kind = NB_CONTACT_RATIO, .contact = 0.3}},
      {"damping ratio 30 %", {.contact_kind = NB_CONTACT_RATIO, .contact = 0.3}},
      {"damping walls stiffness 0.1", {.walls_separate = true, .walls_kind = NB_CONTACT_STIFFNESS, .walls = 0.1}},
      {"damping walls r89-fraction 0.2", {.walls_separate = true, .walls_kind = NB_CONTACT_R89_FRACTION, .walls = 0.2}},
      {"damping walls ratio 0.3|damping ratio 0.1",
       {.contact_kind = NB_CONTACT_RATIO,
        .contact = 0.1,
        .walls_separate = true,
        .walls_kind = NB_CONTACT_RATIO,
        .walls = 0.3}},
      {"damping ratio 0.1|damping walls none",
       {.contact_kind = NB_CONTACT_RATIO, .contact = 0.1, .walls_separate = true}},
      {"damping mass 2", {.global_kind = NB_GLOBAL_MASS, .global = 2}},
      {"damping con1 0.5 as cs79", {.global_kind = NB_GLOBAL_CON1_CS79, .global = 0.5}},
      {"damping con1 0.6 as velocity", {.global_kind = NB_GLOBAL_CON1_VELOCITY, .global = 0.6}},
      {"damping con1 0.7 as all", {.global_kind = NB_GLOBAL_CON1_ALL, .global = 0.7}},
      {"normal hertz|damping critical beyond overlap 7 %", {.deep = 0.07}},
      {"damping centred", {.centred = true}},
      {"damping late", {.centred = false}},
      {"damping none", {.centred = false}},
      {"normal hertz|damping ratio 0.3|damping mass 2|damping critical beyond overlap 0.1|damping centred",
       {.contact_kind = NB_CONTACT_RATIO,
        .contact = 0.3,
        .global_kind = NB_GLOBAL_MASS,
        .global = 2,
        .deep = 0.1,
        .centred = true}},
      {"normal hertz|damping ratio 0.3|damping walls ratio 0.2|damping mass 2|damping critical beyond overlap "
       "0.1|damping "
       "centred|stage s|damping none|cycles 1",
       {.centred = false}},
      {"normal hertz|damping ratio 0.3|damping mass 2|damping critical beyond overlap 0.1|damping centred|stage "
       "s|damping ratio "
       "0.2|damping late|cycles 1",
       {.contact_kind = NB_CONTACT_RATIO,
        .contact = 0.2,
        .global_kind = NB_GLOBAL_MASS,
        .global = 2,
        .deep = 0.1,
        .centred = false}},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1 kn 1 young 1\nsphere 0 2 radius 1 m\nstep 1\nrecord time\n%s%s\n",
              rows[k].statements, strstr(rows[k].statements, "stage") ? "" : "\nstage s\ncycles 1");
    for (char *c = page.text; (c = strchr(c, '|'));)
      *c = '\n';
    written_scene(&it, &page);
    const bool same = nb_damping_equal(&it.scene.stages[0].damping, &rows[k].wanted);
    if (!same)
      printf("# %s\n", rows[k].statements);
    CU_ASSERT(same);
    written_free(&it);
  }
}

/* Each of the five settings has at most one statement in the scene, and one in a stage. */
static void limits_of_damping(void) {
#define SPHERES "```scene\nunits none\nmaterial m density 1 kn 1 young 1\n"
  static const struct row rows[] = {
      {"damping stiffness 0", NULL},
      {"damping stiffness -1e-9", "0 or more"},
      {"damping ratio 0", NULL},
      {"damping ratio -1e-9", "0 or more"},
      {"damping r89-fraction 0", NULL},
      {"damping r89-fraction -1e-9", "0 or more"},
      {"damping walls ratio 0", NULL},
      {"damping walls ratio -1e-9", "0 or more"},
      {"damping mass 0", NULL},
      {"damping mass -1e-9", "0 or more"},
      {"damping con1 0 as all|damping ratio 1", NULL},
      {"damping con1 1 as all", NULL},
      {"damping con1 1.001 as all", "from 0 to 1"},
      {"damping con1 -0.001 as all", "from 0 to 1"},
      {"normal hertz|damping critical beyond overlap 1e-9", NULL},
      {"damping critical beyond overlap 0", "above 0"},
      {"damping ratio 1|damping stiffness 1", "the damping of contacts is given twice, first on line 4"},
      {"damping walls ratio 1|damping walls none", "contacts with walls is given twice, first on line 4"},
      {"damping mass 1|damping con1 1 as all", "the damping of all particles is given twice, first on line 4"},
      {"damping critical beyond overlap 1|damping critical beyond overlap 2", "`damping critical` is given twice"},
      {"damping late|damping centred", "the time of the dashpots' velocity is given twice, first on line 4"},
      {"damping ratio 1|damping none", "the damping of contacts is given twice, first on line 4"},
      {"damping mass 1|damping none", "the damping of all particles is given twice, first on line 4"},
      {"damping critical beyond overlap 1|damping none", "`damping critical` is given twice, first on line 4"},
      {"damping centred|damping none", "the time of the dashpots' velocity is given twice, first on line 4"},
      {"normal hertz|damping walls ratio 1|damping ratio 1|damping mass 1|damping critical beyond overlap 1|damping "
       "late",
       NULL},
  };
  static const struct row in_stage[] = {
      {"damping ratio 1", NULL},
      {"damping none", NULL},
      {"damping ratio 1|damping stiffness 1", "the damping of contacts is given twice, first on line 11"},
      {"damping walls ratio 1|damping walls none", "contacts with walls is given twice, first on line 11"},
      {"damping ratio 1|stage b|damping ratio 2|cycles 1", NULL},
  };
  READ(rows, SPHERES, "\nsphere 0 2 radius 1 m" RUN);
  READ(in_stage, SCENE "disc 0 2 radius 1 m\ndamping ratio 1\ndamping walls ratio 1" RUN, "\n");
}

/* A pair has one statement in the scene, in either order. A stage changes each property of a material or pair once. */
static void pairs(void) {
  static const struct row rows[] = {
      {"pair m n friction 1|pair m o ks 1|pair m m ks 1|pair n n ks 1", NULL},
      {"pair m n friction 1|pair m n ks 1", "this pair is defined already, on line 6"},
      {"pair m n friction 1|pair n m ks 1", "this pair is defined already, on line 6"},
      {"pair m m friction 1|pair m m ks 1", "this pair is defined already, on line 6"},
  };
  static const struct row changes[] = {
      {"material m friction 1|material m ks 2|material n friction 1", NULL},
      {"material m friction 1|material n ks 1|material m friction 2",
       "`friction` of this material already, on line 11"},
      {"pair m n friction 1|pair m n ks 2|pair m m friction 1|pair m o friction 1|material m friction 1", NULL},
      {"pair m n friction 1|pair m n friction 2", "`friction` of this pair already, on line 11"},
      {"pair m n friction 1|pair n m friction 2", "`friction` of this pair already, on line 11"},
      {"pair m m friction 1|pair n n friction 1|pair m m friction 2", "`friction` of this pair already, on line 11"},
  };
#define THREE SCENE "material n density 1 kn 1 ks 1\nmaterial o density 1 kn 1 ks 1\n"
  READ(rows, THREE, "\ndisc 0 2 radius 1 m" RUN);
  READ(changes, THREE "disc 0 2 radius 1 m" RUN, "\n");
}

/* `reverse velocities` is above the statements that move walls; `zero velocities` may be below them. */
static void stages(void) {
  static const struct row rows[] = {
      {"wall w velocity 1 0|zero velocities", NULL},
      {"reverse velocities|wall w velocity 1 0", NULL},
      {"wall w velocity 1 0|reverse velocities", "above the statements that move walls"},
      {"repeat from a 1 more time", NULL},
      {"repeat from a 1 more times", NULL},
      {"repeat from a 2 more times", NULL},
      {"repeat from a 0 more times", "from 1 to"},
      {"repeat from", "expected the name of a stage, found the end"},
      {"repeat from b 2 more times", "expected the name of a stage above, found `b`"},
      {"repeat from a 2 more times|repeat from a 1 more time", "expected a stage below the `repeat`"},
      {"repeat from a 2 more times|zero velocities", "expected `stage` below the `repeat`"},
  };
  static const struct row segments[] = {
      {"repeat from s 1 more time", NULL},
      {"repeat from", "expected the name of a segment, found the end"},
      {"repeat from b 2 more times", "expected the name of a segment above, found `b`"},
      {"repeat from s 2 more times|repeat from s 1 more time", "expected a segment below the `repeat`"},
      {"repeat from s 2 more times|record every 2 steps", "expected `segment` below the `repeat`"},
  };
  READ(rows, SCENE "wall w -9 0 to 9 0 m\ndisc 0 2 radius 1 m" RUN, "\n");
  READ(segments,
       "```contact-test\nunits none\nmaterial rock kn 1\ncontact disc 1 rock with wall rock\nsegment s overlap to 1\n",
       "\n");
}

/* A stage is repeated if a stage before it has the same line. */
static void repeated_stages(void) {
  static const bool repeated[] = {false, true, true, false, false, true, true, false};
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 1\ndisc 0 2 radius 1 m\nstep 1\nrecord time\n"
                   "stage a\ncycles 1\nrepeat from a 2 more times\n"
                   "stage b\ncycles 1\nstage c\ncycles 1\nrepeat from b 1 more time\nstage d\ncycles 1\n");
  written_scene(&it, &page);
  CU_ASSERT_EQUAL_FATAL(it.scene.stage_count, 8);
  for (size_t s = 0; s < 8; s++)
    CU_ASSERT_EQUAL(nb_is_repeated(&it.scene, s), repeated[s]);
  written_free(&it);
}

void suite_limits(void) {
  CU_pSuite suite = CU_add_suite("limits", NULL, NULL);
  CU_ADD_TEST(suite, corners);
  CU_ADD_TEST(suite, cells);
  CU_ADD_TEST(suite, impacts);
  CU_ADD_TEST(suite, incomplete_particles);
  CU_ADD_TEST(suite, most_particles);
  CU_ADD_TEST(suite, particles);
  CU_ADD_TEST(suite, lattices);
  CU_ADD_TEST(suite, regions);
  CU_ADD_TEST(suite, shapes_of_regions);
  CU_ADD_TEST(suite, targets_of_servos);
  CU_ADD_TEST(suite, files_of_points);
  CU_ADD_TEST(suite, parts_of_segments);
  CU_ADD_TEST(suite, settings_of_damping);
  CU_ADD_TEST(suite, limits_of_damping);
  CU_ADD_TEST(suite, pairs);
  CU_ADD_TEST(suite, stages);
  CU_ADD_TEST(suite, repeated_stages);
}
