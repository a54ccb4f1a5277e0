/* Statements at the limits of their values: the last valid value and the first one that is refused.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
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
static void corners_of_a_filled_box(void) {
  static const struct row rows[] = {
      {"grading g 0.1 1|fill discs box 5 0 to 6 1 g m seed 1 attempts 9 else skip", NULL},
      {"grading g 0.1 1|fill discs box 1000 1000 to 1000.5 1000.5 g m seed 1 attempts 9 else skip", NULL},
      {"grading g 0.1 1|fill discs box 1000.5 1000 to 1000 1000.5 g m seed 1 attempts 9 else skip", "corner"},
      {"grading g 0.1 1|fill discs box 1000 1000.5 to 1000.5 1000 g m seed 1 attempts 9 else skip", "corner"},
  };
  READ(rows, SCENE, "\ndisc 1 1 radius 0.1 m" RUN);
}

/* A side of the cell is at least 2 (2 R + skin), R the largest radius. The skin is a tenth of the mean radius. */
static void cells(void) {
  static const struct row rows[] = {
      {"periodic cell 0 0 to 5 5|skin 0.5|disc 1 1 radius 1 m|disc 3 3 radius 1 m", NULL},
      {"periodic cell 0 0 to 4.99 5|skin 0.5|disc 1 1 radius 1 m|disc 3 3 radius 1 m", "at least 5, twice"},
      {"periodic cell 0 0 to 5 4.99|skin 0.5|disc 1 1 radius 1 m|disc 3 3 radius 1 m", "found 4.99"},
      {"periodic cell 0 0 to 7 7|skin 1.5|disc 1 1 radius 1 m|disc 3 3 radius 1 m", NULL},
      {"periodic cell 0 0 to 6.99 7|skin 1.5|disc 1 1 radius 1 m|disc 3 3 radius 1 m", "at least 7, twice"},
      {"periodic cell 0 0 to 4.151 4.151|disc 1 1 radius 1 m|disc 3 3 radius 0.5 m", NULL},
      {"periodic cell 0 0 to 4.149 4.151|disc 1 1 radius 1 m|disc 3 3 radius 0.5 m", "at least 4.15, twice"},
      {"periodic cell 0 0 to 1 1|disc 1 1 radius 1 m", NULL}, /* it has no neighbours */
      {"periodic cell 0 0 to 1 1|disc 1 1 radius 1 m|disc 3 3 radius 1 n",
       "`n`"}, /* only the mistake of the particle */
      {"periodic cell 0 0 to 1 1|disc 1 1 radius 1 m|disc 2 2 radius 1 m|disc 3 3 radius 1 n", "`n`"},
      {"periodic cell 0 0 to 9 9|disc 1 1 radius 1 m|perturb wave 1 1 periods 1000000 -1000000", NULL},
      {"periodic cell 0 0 to 9 9|disc 1 1 radius 1 m|perturb wave 1 1 periods -1000000 1000000", NULL},
      {"periodic cell 0 0 to 9 9|disc 1 1 radius 1 m|perturb wave 1 1 periods 1000001 0", "found 1000001 and 0"},
      {"periodic cell 0 0 to 9 9|disc 1 1 radius 1 m|perturb wave 1 1 periods 0 -1000001", "found 0 and -1000001"},
      {"periodic cell 0 0 to 9 9|disc 1 1 radius 1 m|perturb wave 1 1 periods 0.5 0", "found 0.5 and 0"},
      {"periodic cell 0 0 to 9 9|disc 1 1 radius 1 m|perturb wave 1 1 periods 0 0.5", "found 0 and 0.5"},
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

/* With `sorted` the particles of a packing are in rows as high as the largest one, here 0.5, with increasing x in a row, and
 * increasing y at the same x. Without it they are in the order of the file. */
static void rows_of_a_sorted_packing(void) {
  enum { COUNT = 40 };
  char path[] = "/tmp/nineball-limits-XXXXXX";
  FILE *file = written_file(path);
  fputs("x/-\ty/-\tradius/-\n", file);
  for (int k = 0; k < COUNT; k++)
    fprintf(file, "%d\t%g\t%g\n", 7 * k % 5 - 2, 0.2 * (3 * k % 8), k ? 0.1 : 0.25);
  fclose(file);
  for (int sorted = 0; sorted < 2; sorted++) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1 kn 1\npacking %s discs m%s\nstep 1\nrecord time\nstage a\ncycles 1\n",
              path, sorted ? " sorted" : "");
    written_scene(&it, &page);
    CU_ASSERT_EQUAL_FATAL(it.scene.particle_count, COUNT);
    const struct nb_particle *p = it.scene.particles;
    for (int k = 0; k < COUNT; k++) {
      if (!sorted)
        CU_ASSERT(p[k].x == 7 * k % 5 - 2 && p[k].radius == (k ? 0.1 : 0.25));
      if (!sorted || k == 0)
        continue;
      const double row = floor(p[k].y / 0.5), before = floor(p[k - 1].y / 0.5);
      CU_ASSERT(before < row ||
                (before == row && (p[k - 1].x < p[k].x || (p[k - 1].x == p[k].x && p[k - 1].y < p[k].y))));
    }
    written_free(&it);
  }
  unlink(path);
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

/* ---- damping ---- */

/* The ranges of the values, and the settings that a second statement gives twice; `none` gives all. */
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
      {"damping critical beyond overlap 1|damping critical beyond overlap 2", "`damping critical` is given twice"},
      {"damping ratio 1|damping none", "the damping of contacts is given twice, first on line 4"},
      {"damping mass 1|damping none", "the damping of all particles is given twice, first on line 4"},
      {"damping critical beyond overlap 1|damping none", "`damping critical` is given twice, first on line 4"},
      {"damping centred|damping walls none", NULL},
      {"damping centred|damping none", "the time of the dashpots' velocity is given twice, first on line 4"},
      {"normal hertz|damping walls ratio 1|damping ratio 1|damping mass 1|damping critical beyond overlap 1|damping "
       "late",
       NULL},
  };
  /* `none` also ends the damping of contacts with walls, so a later law does not refuse it. */
  static const struct row changes[] = {
      {"damping none|normal hertz", NULL},
      {"damping walls none|normal hertz", NULL},
      {"damping ratio 1|normal hertz", "no `damping r89-fraction` for `normal hertz` in stage `b`"},
      {"normal hertz", "no `damping r89-fraction` for `normal hertz` in stage `b`"},
      {"shear linear", NULL},
  };
  READ(rows, SPHERES, "\nsphere 0 2 radius 1 m" RUN);
  READ(changes, SPHERES "sphere 0 2 radius 1 m\ndamping walls r89-fraction 1" RUN "stage b\n", "\ncycles 1\n");
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
      {"step 2e-3|repeat from a 1 more time", NULL},
      {"damping mass 1|repeat from a 1 more time", NULL},
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
  CU_ADD_TEST(suite, corners_of_a_filled_box);
  CU_ADD_TEST(suite, cells);
  CU_ADD_TEST(suite, impacts);
  CU_ADD_TEST(suite, incomplete_particles);
  CU_ADD_TEST(suite, most_particles);
  CU_ADD_TEST(suite, particles);
  CU_ADD_TEST(suite, lattices);
  CU_ADD_TEST(suite, rows_of_a_sorted_packing);
  CU_ADD_TEST(suite, regions);
  CU_ADD_TEST(suite, files_of_points);
  CU_ADD_TEST(suite, limits_of_damping);
  CU_ADD_TEST(suite, pairs);
  CU_ADD_TEST(suite, stages);
  CU_ADD_TEST(suite, repeated_stages);
}
