/* What statements set in a scene, and which values they refuse. Each expected value follows from the rule in the help of
 * the statement.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../src/input/reader.h"
#include "suites.h"
#include "written.h"

#define GO "step 0.1\nrecord time\nstage s\ncycles 1\n"

/* Reads a page with these statements, and asserts that the errors contain `wanted`; NULL: that there is no error. */
static void says(const char *statements, const char *wanted, nb_settings settings) {
  struct words words = {0};
  struct nb_page page = {0};
  struct nb_scene scene = {0};
  struct nb_mistakes mistakes = {0};
  const bool test = strncmp(statements, "path\n", 5) == 0;
  words_add(&words, "```%s\n%s\n```\n", test ? "contact-test" : "scene", statements + (test ? 5 : 0));
  nb_page_read_bytes(&page, "stated.md", words.text, words.length, &mistakes);
  nb_scene_read(&scene, &page, 0, settings, &mistakes);
  const bool as_wanted = wanted ? mistakes.text && strstr(mistakes.text, wanted) : mistakes.total == 0;
  if (!as_wanted)
    printf("# %s\n# said: %s\n", statements, mistakes.text ? mistakes.text : "nothing");
  CU_ASSERT(as_wanted);
  nb_mistakes_free(&mistakes), nb_scene_free(&scene), nb_page_free(&page), free(words.text);
}

/* ---- transform ---- */

/* Rotations by multiples of 90 deg up to 360 deg are exact. Counterclockwise, (3, 5) becomes (-5, 3), and so on. */
static void quarter_turns_are_exact(void) {
  static const double x[] = {3, -5, -3, 5}, y[] = {5, 3, -5, -3};
  for (int degrees = -360; degrees <= 360; degrees += 45) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "material m density 1 kg/m3 kn 1 N/m\ndisc 3 m 5 m radius 1 m m\ntransform rotate %d deg\nstep 1 us\n"
              "record time\nstage s\ncycles 1\n",
              degrees);
    written_scene(&it, &page);
    const struct nb_particle *const particle = &it.scene.particles[0];
    if (degrees % 90 == 0) {
      CU_ASSERT_EQUAL(particle->x, x[(degrees + 360) / 90 % 4]);
      CU_ASSERT_EQUAL(particle->y, y[(degrees + 360) / 90 % 4]);
    }
    const double angle = degrees * acos(-1) / 180;
    CU_ASSERT_DOUBLE_EQUAL(particle->x, 3 * cos(angle) - 5 * sin(angle), 4e-15); /* a few ulp of 5 */
    CU_ASSERT_DOUBLE_EQUAL(particle->y, 3 * sin(angle) + 5 * cos(angle), 4e-15);
    written_free(&it);
  }
}

/* A number that is not finite after `transform` is an error. Here a rotation by 45 deg makes (1.7 + 1.7) e308/2^(1/2) of
 * one component, which is above the largest number, 1.8e308. */
static void numbers_that_transform_makes_infinite(void) {
#define BIG " 1.7e308 1.7e308"
  static const struct {
    const char *in_scene, *in_stage;
  } rows[] = {
      {"disc" BIG " radius 1 m", ""},
      {"disc 1.7e308 -1.7e308 radius 1 m", ""},
      {"disc 0 0 radius 1 m velocity" BIG, ""},
      {"disc 0 0 radius 1 m velocity 1.7e308 -1.7e308", ""},
      {"wall w" BIG " to 1.7e308 1.6e308 m", ""},
      {"wall w 0 0 to 1 0 m velocity" BIG, ""},
      {"region A circle" BIG " radius 1", ""},
      {"periodic cell" BIG " to 1.79e308 1.79e308", ""},
      {"gravity" BIG, ""},
      {"boundary circle" BIG " radius 1", ""},
      {"skin 1", "boundary circle" BIG " radius 1"},
      {"skin 1", "gravity" BIG},
      {"skin 1", "gravity centripetal 1 about" BIG},
      {"skin 1", "affine strain 1.7e308 -1.7e308 c12 1.7e308 c21 1.7e308"},
      {"periodic cell 0 0 to 9 9", "cell strain 1.7e308 -1.7e308 c12 1.7e308 c21 1.7e308"},
      {"boundary circle 0 0 radius 1", "boundary strain 1.7e308 -1.7e308 c12 1.7e308 c21 1.7e308"},
      {"boundary circle 0 0 radius 1", "boundary stress 1.7e308 1.7e308 shear 1.7e308"},
      {"wall w 0 0 to 1 0 m", "wall w velocity" BIG},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    for (int turned = 0; turned < 2; turned++) {
      char text[600];
      snprintf(
          text, sizeof text,
          "units none\nmaterial m density 1 kn 1\n%s\n%s\ndisc 5 5 radius 1 m\nstep 0.1\nrecord time\nstage s\n%s\n"
          "cycles 1\n",
          rows[k].in_scene, turned ? "transform rotate 0.7853981633974483" : "", rows[k].in_stage);
      says(text, turned ? "expected finite coordinates after `transform`; these are too large" : NULL, NULL);
    }
  static const char *const far[] = {"1.7e308 0", "0 1.7e308"};
  for (int k = 0; k < 4; k++) {
    char text[300];
    snprintf(text, sizeof text,
             "units none\nmaterial m density 1 kn 1\ndisc %s radius 1 m\ntransform translate %s\n" GO, far[k / 2],
             far[k % 2]);
    says(text, k / 2 == k % 2 ? "expected finite coordinates after `transform`" : NULL, NULL);
  }
}

/* ---- refine and soften ---- */

/* Reads the scene of these statements with one setting; free it with written_free. */
static void read_set(struct written *it, const char *statements, const char *setting) {
  const char *const settings[] = {setting, NULL};
  struct words page = {0};
  words_add(&page, "%s", statements);
  written_scene_set(it, &page, settings);
}

/* `--set soften=S` divides kn, ks and young of materials and pairs, and the values to which stages change them. */
static void soften_divides_stiffnesses(void) {
  struct written it;
  read_set(
      &it,
      "units none\nmaterial a density 1 kn 8 ks 12 friction 4 young 16 poisson 0.25\nmaterial b density 4 kn 20 ks 24\n"
      "pair a b kn 28 ks 32 friction 4\npair b b kn 36 ks 40\ndisc 0 0 radius 4 a\nstep 0.1\nrecord time\nstage s\n"
      "material a kn 44 ks 48 friction 4\npair a b kn 52 ks 56\ncycles 1\nstage t\nmaterial b kn 60 ks 64\ncycles 1\n",
      "soften=4");
  const struct nb_scene *const scene = &it.scene;
  const struct nb_change *const s = scene->stages[0].changes, *const t = scene->stages[1].changes;
  const double divided[] = {scene->materials[0].kn,
                            scene->materials[0].ks,
                            scene->materials[0].young,
                            scene->materials[1].kn,
                            scene->materials[1].ks,
                            scene->pair_rules[0].kn,
                            scene->pair_rules[0].ks,
                            scene->pair_rules[1].kn,
                            scene->pair_rules[1].ks,
                            s[0].kn,
                            s[0].ks,
                            s[1].kn,
                            s[1].ks,
                            t[0].kn,
                            t[0].ks};
  for (size_t k = 0; k < sizeof divided / sizeof *divided; k++)
    CU_ASSERT_EQUAL(divided[k], k < 2 ? 2 + (double)k : k == 2 ? 4 : 2 + (double)k);
  CU_ASSERT(scene->materials[0].friction == 4 && scene->pair_rules[0].friction == 4 && s[0].friction == 4);
  CU_ASSERT(scene->materials[1].density == 4 && scene->materials[0].poisson == 0.25 && scene->particles[0].radius == 4);
  written_free(&it);
}

/* A product of a number of cycles and R may be 1e9 and must be whole; after `at most` it is rounded up. An interval is
 * rounded to the nearest whole number, from 1 to 1e9; an interval of 1, and `none`, stay. */
static void refine_multiplies_numbers_of_cycles(void) {
  static const struct {
    const char *setting, *in_stage;
    unsigned long cycles, record, check;
    const char *wanted;
  } rows[] = {
      {"refine=2", "cycles 500000000", 1000000000, 1, 1, NULL},
      {"refine=2", "cycles 500000001", 0, 0, 0,
       "expected at most 1000000000 cycles in `s` with --set refine=2, found 1000000002"},
      {"refine=2", "until time above 1 at most 500000000 cycles", 1000000000, 1, 1, NULL},
      {"refine=2", "until time above 1 at most 500000001 cycles", 0, 0, 0,
       "expected at most 1000000000 cycles in `s` with"},
      {"refine=0.5", "cycles 3", 0, 0, 0, "expected a whole number of cycles in `s` with --set refine=0.5, found 1.5"},
      {"refine=0.5", "cycles 4", 2, 1, 1, NULL},
      {"refine=1e-10", "cycles 1", 0, 0, 0,
       "expected a whole number of cycles in `s` with --set refine=1e-10, found 1e-10"},
      {"refine=0.5", "until time above 1 at most 3 cycles", 2, 1, 1, NULL},
      {"refine=0.5", "until time above 1 at most 4 cycles", 2, 1, 1, NULL},
      {"refine=0.5", "until time above 1 at most 5 cycles", 3, 1, 1, NULL},
      {"refine=2", "record every 500000000 cycles\ncycles 1", 2, 1000000000, 1, NULL},
      {"refine=2", "record every 600000000 cycles\ncycles 1", 2, 1000000000, 1, NULL},
      {"refine=2", "record every 1 cycle\ncycles 1", 2, 1, 1, NULL},
      {"refine=2", "record none\ncycles 1", 2, 0, 1, NULL},
      {"refine=2", "record every 2 cycles\nuntil time above 1 every 3 cycles at most 1 cycle", 2, 4, 6, NULL},
      {"refine=0.25", "record every 3 cycles\ncycles 4", 1, 1, 1, NULL},  /* 0.75 */
      {"refine=0.125", "record every 3 cycles\ncycles 8", 1, 1, 1, NULL}, /* 0.375 */
      {"refine=0.5", "record every 7 cycles\ncycles 8", 4, 4, 1, NULL},   /* 3.5 */
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    const char *const settings[] = {rows[k].setting, NULL};
    char text[400];
    snprintf(text, sizeof text,
             "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nstep 0.1\nrecord time\nstage s\n%s\n",
             rows[k].in_stage);
    says(text, rows[k].wanted, settings);
    if (rows[k].wanted)
      continue;
    struct written it;
    read_set(&it, text, rows[k].setting);
    CU_ASSERT_EQUAL(it.scene.stages[0].cycles, rows[k].cycles);
    CU_ASSERT_EQUAL(it.scene.stages[0].record_interval, rows[k].record);
    CU_ASSERT_EQUAL(it.scene.stages[0].check_interval, rows[k].check);
    written_free(&it);
  }
  says("path\nunits none\nmaterial rock kn 1\ncontact disc 1 rock with disc 1 rock\nsegment a overlap to 1 in 3 steps",
       "expected a whole number of steps in `a` with --set refine=0.5, found 1.5",
       (const char *const[]){"refine=0.5", NULL});
}

/* R is written with a limited number of digits, so a product with a relative error of 1e-9 is whole. */
static void whole_products(void) {
  static const struct {
    double product, whole;
    bool is;
  } rows[] = {{1, 1, true},           {1 + 0.9e-9, 1, true},       {1 - 0.9e-9, 1, true},        {1 + 1.1e-9, 1, false},
              {1 - 1.1e-9, 1, false}, {1000 + 0.9e-6, 1000, true}, {1000 + 1.1e-6, 1000, false}, {1e-10, 0, false},
              {2.5, 2, false}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    double whole;
    CU_ASSERT_EQUAL(nb_refined_is_whole(rows[k].product, &whole), rows[k].is);
    CU_ASSERT_EQUAL(whole, rows[k].whole);
  }
}

/* The step, strains per cycle and numbers of cycles change; rates in time and other values do not. */
static void refine_changes_what_depends_on_the_step(void) {
  struct written it;
  read_set(
      &it,
      "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nbox -9 -9 to 9 9 m\nboundary circle 0 0 radius 1\n"
      "step 8\ndamping con1 0.5 as cs79\nrecord time\nstage s\nstep 16\ndamping con1 0.0625 as velocity\n"
      "boundary strain 2 per cycle 4 per cycle c12 6 per cycle c21 8 per cycle\naffine strain 2 4 c12 6 c21 8\n"
      "servo mean 1 on box through box at most 4 per cycle every 3 cycles\n"
      "until cycle above 5 and stage.time above 7 at most 9 cycles\n"
      "stage t\ndamping con1 0.25 as all\naffine strain 2 per cycle 4 per cycle\nboundary fixed\n"
      "servo mean 1 on box through box at most 4 every 1 cycle\ncycles 1\nstage u\ndamping mass 4\ncycles 1\n",
      "refine=2");
  const struct nb_scene *const scene = &it.scene;
  const struct nb_stage *const s = scene->stages, *const t = s + 1, *const u = s + 2;
  const struct nb_strain_rate *const strain = &s->boundary.strain, *const affine = &s->affine.strain;
  CU_ASSERT(scene->step.value == 4 && s->step.value == 8 && t->step.value == 8);
  CU_ASSERT(scene->damping.global == 0.75 && s->damping.global == 0.25 &&
            t->damping.global == 0.5); /* 1 - 0.5/2; roots */
  CU_ASSERT_EQUAL(u->damping.global, 4);
  CU_ASSERT(strain->xx == 1 && strain->yy == 2 && strain->xy == 3 && strain->yx == 4);
  CU_ASSERT(affine->xx == 2 && affine->yy == 4 && affine->xy == 6 && affine->yx == 8);
  CU_ASSERT(t->affine.strain.xx == 1 && t->affine.strain.yy == 2);
  CU_ASSERT(s->servo.max_rate == 2 && s->servo.every == 6 && t->servo.max_rate == 4 && t->servo.every == 1);
  CU_ASSERT(s->conditions[0].value == 10 && s->conditions[1].value == 7 && s->cycles == 18);
  written_free(&it);
}

/* ---- packing ---- */

/* `sorted` numbers the particles in rows as high as the largest particle, 2: from the smallest y, and in a row from the
 * smallest x, then the smallest y. Particles above the statement keep their places. */
static void a_sorted_packing(void) {
  static const double order[][3] = {{7, 9, 3},   {-1, -0.5, 0.25}, {1, 0.25, 1}, {1, 1.75, 0.5},
                                    {5, 0.5, 1}, {0, 2.25, 0.5},   {3, 2, 0.5}};
  char path[] = "/tmp/nineball-stated-XXXXXX";
  FILE *file = written_file(path);
  fputs("x/-\ty/-\tradius/-\n3\t2\t0.5\n5\t0.5\t1\n1\t1.75\t0.5\n0\t2.25\t0.5\n-1\t-0.5\t0.25\n1\t0.25\t1\n", file);
  fclose(file);
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 1\ndisc 7 9 radius 3 m\npacking %s discs m sorted\n" GO, path);
  written_scene(&it, &page);
  CU_ASSERT_EQUAL_FATAL(it.scene.particle_count, sizeof order / sizeof *order);
  for (size_t k = 0; k < it.scene.particle_count; k++) {
    const struct nb_particle *const particle = &it.scene.particles[k];
    CU_ASSERT(particle->x == order[k][0] && particle->y == order[k][1] && particle->radius == order[k][2]);
  }
  CU_ASSERT(it.scene.packings[0].first == 1 && it.scene.packings[0].count == 6);
  written_free(&it);
  unlink(path);
}

/* ---- stages ---- */

/* On a page that starts from another one, conditions on `time` and on strains of a cell or a box cause a warning, because
 * they count from the start of the first page. So does no other condition, and no condition of the first page. */
static void conditions_that_count_from_the_first_page(void) {
  static const struct {
    const char *object, *condition, *wanted;
  } rows[] = {
      {"skin 1", "time above 1", "`time` counts from the start of the first page, `stage.time` from that of the stage"},
      {"skin 1", "stage.time above 1", NULL},
      {"skin 1", "cycle above 1", NULL},
      {"periodic cell -9 -9 to 9 9", "cell.strain.xx below -1",
       "`cell.strain.xx` counts from the start of the first page; a small strain"},
      {"periodic cell -9 -9 to 9 9", "cell.stress.xx above 1", NULL},
      {"box -9 -9 to 9 9 m", "box.strain.width below -1",
       "`box.strain.width` counts from the start of the first page; a small"},
      {"box -9 -9 to 9 9 m", "box.stress.xx above 1", NULL},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    for (int starts = 0; starts < 2; starts++) {
      char path[] = "/tmp/nineball-stated-XXXXXX.md";
      const int descriptor = mkstemps(path, 3);
      CU_ASSERT_FATAL(descriptor >= 0);
      FILE *file = fdopen(descriptor, "w");
      CU_ASSERT_PTR_NOT_NULL_FATAL(file);
      fprintf(file, "# A page\n\n```scene\nunits none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\n%s\n" GO "```\n",
              rows[k].object);
      fclose(file);
      struct words page = {0};
      struct written it;
      if (starts)
        words_add(&page, "start %s stage s\n", path);
      else
        words_add(&page, "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\n%s\nstep 0.1\n", rows[k].object);
      words_add(&page, "record time\nstage t\nuntil %s at most 9 cycles\n", rows[k].condition);
      written_scene(&it, &page);
      const bool warned = it.scene.warnings.count == 1 && rows[k].wanted &&
                          strncmp(it.scene.warnings.list[0].text, rows[k].wanted, strlen(rows[k].wanted)) == 0;
      CU_ASSERT(starts && rows[k].wanted ? warned : it.scene.warnings.count == 0);
      written_free(&it);
      unlink(path);
    }
}

/* A name is at most 63 bytes long. The name of a repeated stage is cut where its number would not fit. */
static void names_of_repeated_stages(void) {
  for (int length = 59; length <= 63; length++) {
    char name[64], expected[64];
    memset(name, 'a', sizeof name), name[length] = 0;
    snprintf(expected, sizeof expected, "%.*s-2", length < 61 ? length : 61, name);
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nstep 0.1\nrecord time\nstage %s\ncycles 1\n"
              "repeat from %s 1 more time\n",
              name, name);
    written_scene(&it, &page);
    CU_ASSERT_EQUAL_FATAL(it.scene.stage_count, 2);
    CU_ASSERT_STRING_EQUAL(it.scene.stages[0].name, name);
    CU_ASSERT_STRING_EQUAL(it.scene.stages[1].name, expected);
    written_free(&it);
  }
}

/* ---- servo ---- */

/* `isotropic P` and `mean P` set the targets P, P and 0 of xx, yy and xy; components control only what they name. A servo
 * through a box does not control xy. */
static void targets_of_a_servo(void) {
  static const struct {
    const char *target;
    bool mean, controlled[3];
    double stress[3];
  } rows[] = {
      {"isotropic 2", false, {true, true, true}, {2, 2, 0}},   {"mean 2", true, {true, true, true}, {2, 2, 0}},
      {"xx 2", false, {true, false, false}, {2, 0, 0}},        {"yy 3", false, {false, true, false}, {0, 3, 0}},
      {"xy 4", false, {false, false, true}, {0, 0, 4}},        {"yy 3 xy 4", false, {false, true, true}, {0, 3, 4}},
      {"xx 2 yy 3 xy 4", false, {true, true, true}, {2, 3, 4}}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    for (int box = 0; box < 2; box++) {
      struct words page = {0};
      struct written it;
      if (box && strstr(rows[k].target, "xy"))
        continue;
      words_add(&page,
                "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nbox -9 -9 to 9 9 m\n"
                "boundary circle 0 0 radius 1\nstep 0.1\nrecord time\nstage s\nservo %s on %s at most 7%s\n"
                "cycles 1\n",
                rows[k].target, box ? "walls through box" : "boundary through boundary affine",
                box ? "" : " every 5 cycles");
      written_scene(&it, &page);
      const struct nb_servo *const servo = &it.scene.stages[0].servo;
      for (int c = 0; c < 3; c++) {
        CU_ASSERT_EQUAL(servo->controlled[c], rows[k].controlled[c] && !(box && c == 2));
        CU_ASSERT_EQUAL(servo->stress[c], rows[k].stress[c]);
      }
      CU_ASSERT_EQUAL(servo->mean, rows[k].mean);
      CU_ASSERT(servo->box == box && servo->affine == !box && !servo->cell && !servo->ramp && !servo->per_cycle);
      CU_ASSERT(servo->max_rate == 7 && servo->every == (box ? 10 : 5) && servo->line == 10);
      CU_ASSERT(servo->axis_x[0] == 1 && servo->axis_x[1] == 0 && servo->axis_y[0] == 0 && servo->axis_y[1] == 1);
      written_free(&it);
    }
  says(
      "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nbox -9 -9 to 9 9 m\nstep 0.1\nrecord time\nstage s\n"
      "servo mean 1 on walls through box affine at most 1\ncycles 1",
      "expected `affine` only with `through boundary`", NULL);
  static const char *const targets[] = {"isotropic", "mean", "xx", "yy", "xy"};
  for (int k = 0; k < 10; k++) { /* a negative normal stress is tension, and causes a warning */
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nboundary circle 0 0 radius 1\nstep 0.1\n"
              "record time\nstage s\nservo %s %d on boundary through boundary at most 7\ncycles 1\n",
              targets[k % 5], k < 5 ? -2 : 2);
    written_scene(&it, &page);
    CU_ASSERT_EQUAL(it.scene.warnings.count, k < 4);
    char expected[40];
    snprintf(expected, sizeof expected, "`servo %s 2`", targets[k % 5]);
    CU_ASSERT(k >= 4 || (it.scene.warnings.list[0].line == 9 && strstr(it.scene.warnings.list[0].text, expected)));
    written_free(&it);
  }
  static const char *const two[] = {"isotropic 1 mean 1", "isotropic 1 xx 1", "mean 1 yy 1", "mean 1 xy 1",
                                    "isotropic 1 xy 1"};
  for (size_t k = 0; k < sizeof two / sizeof *two; k++) {
    char text[400];
    snprintf(text, sizeof text,
             "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nboundary circle 0 0 radius 1\nstep 0.1\n"
             "record time\nstage s\nservo %s on boundary through boundary at most 1\ncycles 1\n",
             two[k]);
    says(text, "expected one target: `isotropic P`, `mean P`, or components `xx P`, `yy P`, `xy P`", NULL);
  }
}

/* The hint for a line `servo` with a mistake has the target of the line and the place that the scene has: a cell, a box or a
 * boundary, in this order, whose line may be indented. A word of a direction selects a component, the number has its
 * unit if the next word is one. Without a number of its own, or without a place, there is no such hint. */
static void hints_for_a_servo(void) {
#define ON_WALLS " on walls through box at most 1e-6 per cycle`; `xx P` and `yy P` control components"
#define ON(place)                                                                                                      \
  " on " place " through " place " at most 1e-6 per cycle`; `xx P`, `yy P` and `xy P` control components"
  static const char box[] = "box 0 m 0 m to 9 m 9 m rock", cell[] = "periodic cell 0 m 0 m to 9 m 9 m",
                    ring[] = "boundary circle 0 m 0 m radius 1 m", none[] = "skin 1 mm";
  static const struct {
    const char *object, *line, *wanted; /* wanted: the target and the place in the hint; NULL: there is no hint */
  } rows[] = {
      {box, "servo stress.yy 5 kPa", "yy 5 kPa" ON_WALLS},
      {"  box 0 m 0 m to 9 m 9 m rock", "servo stress.yy 5 kPa", "yy 5 kPa" ON_WALLS},
      {"box\t0 m 0 m to 9 m 9 m rock", "servo stress.yy 5 kPa", "yy 5 kPa" ON_WALLS},
      {cell, "servo stress.yy 5 kPa", "yy 5 kPa" ON("cell")},
      {ring, "servo stress.yy 5 kPa", "yy 5 kPa" ON("boundary")},
      {none, "servo stress.yy 5 kPa", NULL},
      {"```\nbox 0\n```scene", "servo stress.yy 5 kPa", NULL}, /* the line is not in the scene */
      {"boxes 0 m 0 m to 9 m 9 m rock", "servo stress.yy 5 kPa", NULL},
      {"boundary ring 0 m 0 m radius 1 m", "servo stress.yy 5 kPa", NULL},
      {box, "servo west 5 kPa", "xx 5 kPa" ON_WALLS},
      {box, "servo box.right 5 kPa", "xx 5 kPa" ON_WALLS},
      {cell, "servo stress.xy 5 kPa", "xy 5 kPa" ON("cell")},
      {box, "servo wall sid 5 kPa", "isotropic 5 kPa" ON_WALLS},
      {box, "servo mean stress 5 kPa", "mean 5 kPa" ON_WALLS},
      {box, "servo pressure 5 kPa", "isotropic 5 kPa" ON_WALLS},
      {box, "servo stress.yy 5", "yy 5" ON_WALLS},
      {box, "servo stress.yy 5 soon", "yy 5" ON_WALLS},
      {box, "servo wall at most 5", NULL},
      {box, "servo wall pressure", NULL},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    char text[600], wanted[200];
    snprintf(
        text, sizeof text,
        "material rock density 1 kg/m3 kn 1 N/m\n%s\ndisc 5 m 5 m radius 1 m rock\nstep 1 us\nrecord time\nstage s\n"
        "gravity centripetal 1 m/s2 about 0 m 0 m\n%s\ncycles 1\n",
        rows[k].object, rows[k].line);
    struct words words = {0};
    struct nb_page page = {0};
    struct nb_scene scene = {0};
    struct nb_mistakes mistakes = {0};
    words_add(&words, "```scene\n%s```\n", text);
    nb_page_read_bytes(&page, "stated.md", words.text, words.length, &mistakes);
    nb_scene_read(&scene, &page, 0, NULL, &mistakes);
    snprintf(wanted, sizeof wanted, "hint: write `servo %s", rows[k].wanted ? rows[k].wanted : "");
    const bool as_wanted = mistakes.text && (strstr(mistakes.text, wanted) != NULL) == (rows[k].wanted != NULL);
    if (!as_wanted)
      printf("# %s\n# %s\n", text, mistakes.text ? mistakes.text : "nothing");
    CU_ASSERT(as_wanted);
    nb_mistakes_free(&mistakes), nb_scene_free(&scene), nb_page_free(&page), free(words.text);
  }
  static const struct {
    const char *object, *on, *wanted;
  } places[] = {{cell, "walls", "expected `cell`, because the scene has a periodic cell, found `walls`"},
                {cell, "box", "expected `cell`, because the scene has a periodic cell, found `box`"},
                {box, "cell", "expected `box`, because the scene has a box of walls, found `cell`"},
                {box, "walls", NULL},
                {cell, "cell", NULL},
                {none, "cell", "expected a scene with a periodic cell, found none"},
                {none, "walls", "expected a scene with a box of walls, found none"}};
  for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
    char text[600];
    snprintf(
        text, sizeof text,
        "material rock density 1 kg/m3 kn 1 N/m\n%s\ndisc 5 m 5 m radius 1 m rock\nstep 1 us\nrecord time\nstage s\n"
        "servo isotropic 1 Pa on %s through %s at most 1 1/s\ncycles 1\n",
        places[k].object, places[k].on, strcmp(places[k].on, "cell") == 0 ? "cell" : "box");
    says(text, places[k].wanted, NULL);
  }
}

/* ---- conditions with a fraction of a size ---- */

/* The hint for `until box.height below 0.75 of box.height` has the strain rate of the stage, if the rate leads to this
 * fraction, is not per cycle, and no servo changes it; otherwise an example of the right sign. */
static void hints_for_a_fraction_of_a_size(void) {
  static const char box[] = "box 0 0 to 9 9 rock", cell[] = "periodic cell 0 0 to 9 9";
  static const struct {
    const char *object, *in_stage, *condition, *wanted;
  } rows[] = {
      {box, "box strain -0.25 -0.5", "box.height below 0.75 of box.height",
       "with a constant strain rate, here -0.5, the stage ends at a time: `until stage.time above (log(0.75)/(-0.5)) "
       "at most "
       "1000000 cycles`, with more cycles if the step is short. Or write a value: `until box.height below (0.75*L) at "
       "most "
       "1000000 cycles`, where `let L = …` in the scene is the height at the beginning of the stage"},
      {box, "box strain -0.25 -0.5", "box.width below 75 % of it",
       "rate, here -0.25, the stage ends at a time: `until stage.time above (log(0.75)/(-0.25)) at most 1000000 "
       "cycles`, with "
       "more cycles if the step is short. Or write a value: `until box.width below (0.75*L) at most 1000000 cycles`, "
       "where "
       "`let L = …` in the scene is the width at"},
      {box, "box strain 0.25 0.5", "box.width above 1.5 of it",
       "rate, here 0.25, the stage ends at a time: `until stage.time above (log(1.5)/(0.25)) at most 1000000 cycles`, "
       "with "
       "more cycles if the step is short. Or write a value: `until box.width above (1.5*L)"},
      {box, "box strain 0.25 0.5", "box.height below 0.75 of it",
       "for example -0.01, the stage ends at a time: `until stage.time above (log(0.75)/(-0.01))"},
      {box, "", "box.height above 1.5 of it",
       "for example 0.01, the stage ends at a time: `until stage.time above (log(1.5)/(0.01))"},
      {box, "box strain -0.25 per cycle -0.5 per cycle", "box.height below 0.75 of it", "for example -0.01,"},
      {box, "box strain -0.25 -0.5\nservo yy 1 on walls through box at most 1", "box.height below 0.75 of it",
       "for example -0.01,"},
      {box, "box strain -0.25 -0.5\nservo xx 1 on walls through box at most 1", "box.height below 0.75 of it",
       "here -0.5,"},
      {box, "box strain -0.25 -0.5\nservo xx 1 on walls through box at most 1", "box.width below 0.75 of it",
       "for example -0.01,"},
      {box, "box strain -0.25 -0.5\nservo yy 1 on walls through box at most 1", "box.width below 0.75 of it",
       "here -0.25,"},
      {cell, "cell strain -0.25 -0.5", "cell.yy below 0.75 of it", "here -0.5, the stage"},
      {cell, "cell strain -0.25 -0.5", "cell.xx below 0.75 of it", "here -0.25, the stage"},
      {cell, "cell strain -0.25 -0.5\nservo yy 1 on cell through cell at most 1", "cell.yy below 0.75 of it",
       "for example -0.01,"},
      {cell, "cell strain -0.25 -0.5\nservo yy 1 on cell through cell at most 1", "cell.xx below 0.75 of it",
       "here -0.25,"},
      {box, "", "box.height below 1 of it",
       "write the value, `until box.height below 1e-9 at most 1000000 cycles`; to wait for rest"},
      {box, "", "box.height below 0 of it", "write the value, `until box.height below 1e-9 at most"},
      {box, "", "box.height above -1 of it", "write the value, `until box.height above 1e-9 at most"},
      {box, "", "box.stress.xx above 0.5 of it", "write the value, `until box.stress.xx above 1e-9 at most"},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    char text[600];
    snprintf(
        text, sizeof text,
        "units none\nmaterial rock density 1 kn 1\n%s\ndisc 5 5 radius 1 rock\nstep 0.1\nrecord time\nstage s\n%s\n"
        "until %s at most 9 cycles\n",
        rows[k].object, rows[k].in_stage, rows[k].condition);
    says(text, rows[k].wanted, NULL);
  }
  says("material rock density 1 kg/m3 kn 1 N/m\nbox 0 m 0 m to 9 m 9 m rock\ndisc 5 m 5 m radius 1 m rock\nstep 1 "
       "us\nrecord "
       "time\nstage s\nbox strain 0 1/s -0.5 1/s\nuntil box.height below 0.75 of it at most 9 cycles\n",
       "here -0.5 1/s, the stage ends at a time: `until stage.time above (log(0.75)/(-0.5 1/s)) at most", NULL);
  says("units none\nmaterial rock density 1 kn 1\nbox 0 0 to 9 9 rock\ndisc 5 5 radius 1 rock\nboundary circle 5 5 "
       "radius 3\n"
       "step 1\nrecord time\nstage s\nbox strain 0 -0.5\nservo mean 1 on boundary through boundary at most 1\n"
       "until box.height below 0.75 of it at most 9 cycles\n",
       "here -0.5, the stage", NULL);
  says("material rock density 1 kg/m3 kn 1 N/m\nbox 0 m 0 m to 9 m 9 m rock\ndisc 5 m 5 m radius 1 m rock\nstep 1 "
       "us\nrecord "
       "time\nstage s\nuntil box.height below 5 m of it at most 9 cycles\n",
       "expected `and`, `every N cycles` or `at most N cycles`, found `of`", NULL);
}

/* `repeat` counts the repetitions, not the runs. The hint for a line without `more` gives both readings. */
static void hints_for_the_number_of_repetitions(void) {
  static const struct {
    int times;
    const char *wanted;
  } rows[] = {
      {1, "hint: write `repeat from s 1 more time`\n"},
      {2,
       "hint: write `repeat from s 2 more times`; with the first run that makes 3, so for 2 in all write `repeat from "
       "s 1 more time`\n"},
      {3,
       "hint: write `repeat from s 3 more times`; with the first run that makes 4, so for 3 in all write `repeat from "
       "s 2 more times`\n"}};
  for (size_t k = 0; k < 2 * (sizeof rows / sizeof *rows); k++) {
    char text[300];
    snprintf(text, sizeof text,
             "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\n" GO "repeat from s %d%s\n",
             rows[k / 2].times, k % 2 ? " times" : "");
    says(text, rows[k / 2].wanted, NULL);
    says(text, k % 2 ? "expected `more times`, found `times`" : "expected `more times`, found the end of the line",
         NULL);
  }
}

/* ---- laws ---- */

/* Of the two sides of a contact at most one may be rigid. Walls do not touch walls, and a single particle does not touch
 * itself. */
static void at_most_one_rigid_side(void) {
#define ONE "sphere 0 0 radius 1 hard\n"
#define SAME "expected at most one `rigid` side of a contact, found that both sides can be of `hard`"
#define OTHER                                                                                                          \
  "expected at most one `rigid` side of a contact, found that this material can touch `rock`, which is rigid too"
  static const struct {
    const char *things, *wanted;
  } rows[] = {
      {ONE, NULL},
      {ONE "sphere 9 0 radius 1 soft\nwall w -9 -9 to 9 -9 soft\n", NULL},
      {ONE "sphere 9 0 radius 1 hard\n", SAME},
      {ONE "wall w -9 -9 to 9 -9 hard\n", SAME},
      {ONE "sphere 9 0 radius 1 rock\n", OTHER},
      {ONE "wall w -9 -9 to 9 -9 rock\n", OTHER},
      {"sphere 0 0 radius 1 soft\nwall v -9 9 to 9 9 hard\nwall w -9 -9 to 9 -9 hard\n", NULL},
      {"sphere 0 0 radius 1 soft\nwall v -9 9 to 9 9 hard\nwall w -9 -9 to 9 -9 rock\n", NULL},
      {"sphere 0 0 radius 1 rock\nwall v -9 9 to 9 9 hard\n",
       "found that this material can touch `hard`, which is rigid too"},
      {"sphere 0 0 radius 1 none\n", "expected a material with `young` for `normal hertz`"},
      {ONE "wall v -9 9 to 9 9 none\n", "expected a material with `young` for `normal hertz`"},
      {ONE "disc 9 9 radius 1 soft\n", "expected spheres for `normal hertz`, found a disc"},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    char text[500];
    snprintf(
        text, sizeof text,
        "units none\nmaterial soft density 1 young 1\nmaterial hard density 1 rigid\nmaterial rock density 1 rigid\n"
        "material none density 1 kn 1\nnormal hertz\n%s" GO,
        rows[k].things);
    says(text, rows[k].wanted, NULL);
  }
}

/* A material without `young` is reported once, however many particles and walls have it. */
static void a_material_is_reported_once(void) {
  struct words words = {0};
  struct nb_page page = {0};
  struct nb_scene scene = {0};
  struct nb_mistakes mistakes = {0};
  words_add(&words,
            "```scene\nunits none\nmaterial a density 1 kn 1\nmaterial b density 1 kn 1\nnormal hertz\nlattice spheres "
            "3 by 1 radius 1 a\nwall v -9 -9 to 9 -9 a\nwall w -9 -5 to 9 -5 b\n" GO "```\n");
  nb_page_read_bytes(&page, "stated.md", words.text, words.length, &mistakes);
  nb_scene_read(&scene, &page, 0, NULL, &mistakes);
  CU_ASSERT_EQUAL(mistakes.count, 2);
  CU_ASSERT(mistakes.text && strstr(mistakes.text, "stated.md:3:1: ") && strstr(mistakes.text, "stated.md:4:1: "));
  nb_mistakes_free(&mistakes), nb_scene_free(&scene), nb_page_free(&page), free(words.text);
}

/* `shear mindlin` has no micro-slip. There is a warning where micro-slip decides: in a contact test with a segment that
 * loads tangentially, and in a collision without damping and gravity. There is none without friction, without motion, or
 * if the law is the value of a name or of --set. */
static void warnings_of_a_law_without_micro_slip(void) {
#define TEST                                                                                                           \
  "path\nunits none\nmaterial rock young 1 friction 0.5\nnormal hertz\n%s\ncontact sphere 1 rock with sphere 1 rock\n"
#define MINDLIN "shear mindlin"
  static const char scene[] =
      "units none\nmaterial rock density 1 young 1 friction %s\n%s\nnormal hertz\n%s\nstep 0.1\nrecord "
      "time\nstage s\n%s\ncycles 1\n";
  static const struct {
    const char *friction, *law, *things, *in_stage;
    bool warned;
  } rows[] = {
      {"0.5", MINDLIN, "sphere 0 0 radius 1 rock velocity 1 0", "", true},
      {"0.5", MINDLIN, "sphere 0 0 radius 1 rock velocity 0 1", "", true},
      {"0.5", MINDLIN, "sphere 0 0 radius 1 rock spin 1", "", true},
      {"0.5", MINDLIN, "sphere 0 0 radius 1 rock", "", false},
      {"0.5", MINDLIN, "sphere 0 0 radius 1 rock\nsphere 5 0 radius 1 rock velocity 1 0", "", true},
      {"0.5", MINDLIN, "sphere 0 0 radius 1 rock velocity 1 0\nsphere 5 0 radius 1 rock", "", true},
      {"0.5", MINDLIN,
       "sphere 0 0 radius 1 rock\nsphere 5 0 radius 1 rock\nmonitor C sphere 1 with sphere 2\nimpact C speed 1 angle 0",
       "", true},
      {"0", MINDLIN, "sphere 0 0 radius 1 rock velocity 1 0", "", false},
      {"0", MINDLIN, "sphere 0 0 radius 1 rock velocity 1 0\npair rock rock friction 0.5", "", true},
      {"0.5", MINDLIN, "sphere 0 0 radius 1 rock velocity 1 0\nmaterial last density 1 young 1", "", true},
      {"0.5", MINDLIN, "sphere 0 0 radius 1 rock velocity 1 0\ndamping ratio 0.1", "", false},
      {"0.5", MINDLIN, "sphere 0 0 radius 1 rock velocity 1 0\ngravity 0 -1", "", false},
      {"0.5", MINDLIN, "sphere 0 0 radius 1 rock velocity 1 0\ndamping ratio 0.1", "damping none", true},
      {"0.5", MINDLIN, "sphere 0 0 radius 1 rock velocity 1 0", "damping mass 1", false},
      {"0.5", MINDLIN, "sphere 0 0 radius 1 rock velocity 1 0", "gravity 0 -1", false},
      {"0.5", MINDLIN, "sphere 0 0 radius 1 rock velocity 1 0", "gravity 0 -1\ncycles 1\nstage t", false},
      {"0.5", "let law mindlin\nshear $law", "sphere 0 0 radius 1 rock velocity 1 0", "", false},
      {"0.5", MINDLIN "\nlet law mindlin", "sphere 0 0 radius 1 rock velocity 1 0", "shear $law", true},
      {"0.5", "shear mindlin_deresiewicz", "sphere 0 0 radius 1 rock velocity 1 0", "", false},
  };
  static const struct {
    const char *segments;
    bool warned;
  } tests[] = {{"segment a overlap to 0.1", false},
               {"segment a overlap to 0.1\nsegment b slip by 0.1", true},
               {"segment a slip by 0", false},
               {"segment a overlap to 0.1\nsegment b slip to 0", true},
               {"segment a overlap to 0.1\nsegment b shear by 0.1\nsegment c overlap to 0.2", true}};
  char text[600];
  for (size_t k = 0; k < sizeof rows / sizeof *rows + sizeof tests / sizeof *tests; k++) {
    const size_t other = k - sizeof rows / sizeof *rows;
    const bool test = k >= sizeof rows / sizeof *rows, wanted = test ? tests[other].warned : rows[k].warned;
    if (test)
      snprintf(text, sizeof text, TEST "%s\n", MINDLIN, tests[other].segments);
    else
      snprintf(text, sizeof text, scene, rows[k].friction, rows[k].law, rows[k].things, rows[k].in_stage);
    struct written it;
    struct words page = {0};
    words_add(&page, "%s", text);
    written_scene(&it, &page);
    size_t found = 0;
    for (size_t w = 0; w < it.scene.warnings.count; w++)
      found += strstr(it.scene.warnings.list[w].text,
                      test ? "`shear mindlin` has no micro-slip at the edge of the contact, on "
                             "which the result of this contact test depends"
                           : "on which a collision without damping depends") != NULL;
    if (found != wanted)
      printf("# %s\n", text);
    CU_ASSERT_EQUAL(found, wanted);
    written_free(&it);
  }
  struct written it;
  snprintf(text, sizeof text, scene, "0.5", MINDLIN, "sphere 0 0 radius 1 rock velocity 1 0", "");
  read_set(&it, text, "shear=mindlin");
  CU_ASSERT_EQUAL(it.scene.warnings.count, 0);
  written_free(&it);
}

/* A law that is not known has a hint: the nearest name; what other programs mean; after `shear` a number or `strain` is
 * meant as a rate. `memory K` is for a shear law that stores pieces, and K is from 2 to 256. */
static void names_and_options_of_laws(void) {
  static const char rate[] = "hint: simple shear at the rate", list[] = "hint: `nineball laws` lists the laws";
  static const struct {
    const char *line, *wanted;
  } rows[] = {
      {"shear strain 0.1", rate},
      {"shear 0.1", rate},
      {"normal 0.1", list},
      {"normal strain", list},
      {"normal none", list},
      {"normal normal_hertz", "hint: did you mean `normal hertz`?"},
      {"normal lineal", "hint: did you mean `linear`?"},
      {"shear hertz", "hint: the shear law of elastic spheres is `shear mindlin` or `shear mindlin_deresiewicz`"},
      {"normal linear memory 4", "expected the end of the line, found `memory`"},
      {"shear linear memory 4", "`shear linear` stores no history in pieces, so it takes no `memory`"},
      {"shear linear friction 0.5", "hint: this property belongs to the material"},
      {"shear linear young 5", "hint: this property belongs to the material"},
      {"normal linear kn 5", "hint: this property belongs to the material"},
      {"normal linear\nnormal linear", "`normal` is given twice, first on line 4"},
      {"shear linear\nshear linear", "`shear` is given twice, first on line 4"},
      {"normal linear\nshear linear", NULL},
      {"normal hertz\nshear mindlin_deresiewicz memory 2", NULL},
      {"normal hertz\nshear mindlin_deresiewicz memory 256", NULL},
      {"normal hertz\nshear mindlin_deresiewicz memory 1", "2"},
      {"normal hertz\nshear mindlin_deresiewicz memory 257", "256"},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    char text[300];
    snprintf(text, sizeof text,
             "units none\nmaterial rock density 1 kn 1 ks 1 young 1\n%s\nsphere 0 0 radius 1 rock\n" GO, rows[k].line);
    says(text, rows[k].wanted, NULL);
  }
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial rock density 1 young 1\nnormal hertz\nshear mindlin_deresiewicz memory 4\nsphere 0 0 "
            "radius 1 rock\n" GO
            "stage t\nnormal hertz\nshear mindlin_deresiewicz memory 8\ncycles 1\nstage u\nshear mindlin\n"
            "cycles 1\nstage v\nnormal hertz_increment\ncycles 1\n");
  written_scene(&it, &page);
  const struct nb_scene *const scene = &it.scene;
  const struct nb_stage *const s = scene->stages, *const t = s + 1, *const u = s + 2, *const v = s + 3;
  CU_ASSERT(scene->pieces == 4 && scene->normal_line == 4 && scene->shear_line == 5);
  CU_ASSERT(t->laws.pieces == 8 && t->laws.normal_line == 12 && t->laws.shear_line == 13);
  CU_ASSERT(u->laws.pieces == 0 && u->laws.normal_line == 0 && u->laws.shear_line == 16);
  CU_ASSERT(v->laws.normal_line == 19 && v->laws.shear_line == 0 && s->laws.normal_line == 0 &&
            s->laws.shear_line == 0);
  CU_ASSERT(!s->laws.normal[0] && !s->laws.shear[0] && !u->laws.normal[0] && !v->laws.shear[0]);
  CU_ASSERT_STRING_EQUAL(scene->normal, "hertz");
  CU_ASSERT_STRING_EQUAL(scene->shear, "mindlin_deresiewicz");
  CU_ASSERT_STRING_EQUAL(t->laws.normal, "hertz");
  CU_ASSERT_STRING_EQUAL(t->laws.shear, "mindlin_deresiewicz");
  CU_ASSERT_STRING_EQUAL(u->laws.shear, "mindlin");
  CU_ASSERT_STRING_EQUAL(v->laws.normal, "hertz_increment");
  written_free(&it);
}

/* The last of several settings of one law counts, and a law of a setting overrides the page. */
static void the_last_setting_of_a_law_counts(void) {
  const char *const settings[] = {"shear=none", "shear=linear", NULL};
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 1\nshear none\ndisc 0 0 radius 1 m\n" GO);
  written_scene_set(&it, &page, settings);
  CU_ASSERT_STRING_EQUAL(it.scene.shear, "linear");
  CU_ASSERT_EQUAL(it.scene.shear_line, 0);
  written_free(&it);
}

/* ---- damping ---- */

/* Each statement sets the damping of all contacts, of contacts with walls, of deep contacts, of all particles, or the time
 * of the dashpots' velocity; `none` ends all of them, `walls none` that of the walls. */
static void kinds_of_damping(void) {
  static const struct {
    const char *lines;
    struct nb_damping wanted;
  } rows[] = {
      {"damping stiffness 2", {.contact_kind = NB_CONTACT_STIFFNESS, .contact = 2, .contact_line = 1}},
      {"damping ratio 0.5", {.contact_kind = NB_CONTACT_RATIO, .contact = 0.5, .contact_line = 1}},
      {"damping ratio 50 %", {.contact_kind = NB_CONTACT_RATIO, .contact = 0.5, .contact_line = 1}},
      {"damping r89-fraction 3", {.contact_kind = NB_CONTACT_R89_FRACTION, .contact = 3, .contact_line = 1}},
      {"damping walls stiffness 2",
       {.walls_separate = true, .walls_kind = NB_CONTACT_STIFFNESS, .walls = 2, .walls_line = 1}},
      {"damping walls ratio 0.5",
       {.walls_separate = true, .walls_kind = NB_CONTACT_RATIO, .walls = 0.5, .walls_line = 1}},
      {"damping walls r89-fraction 3",
       {.walls_separate = true, .walls_kind = NB_CONTACT_R89_FRACTION, .walls = 3, .walls_line = 1}},
      {"damping ratio 0.5\ndamping walls none",
       {.contact_kind = NB_CONTACT_RATIO, .contact = 0.5, .contact_line = 1, .walls_separate = true, .walls_line = 2}},
      {"damping walls ratio 0.5\ndamping ratio 0.25",
       {.contact_kind = NB_CONTACT_RATIO,
        .contact = 0.25,
        .contact_line = 2,
        .walls_separate = true,
        .walls_kind = NB_CONTACT_RATIO,
        .walls = 0.5,
        .walls_line = 1}},
      {"damping mass 4", {.global_kind = NB_GLOBAL_MASS, .global = 4, .global_line = 1}},
      {"damping con1 0.75 as cs79", {.global_kind = NB_GLOBAL_CON1_CS79, .global = 0.75, .global_line = 1}},
      {"damping con1 0.75 as velocity", {.global_kind = NB_GLOBAL_CON1_VELOCITY, .global = 0.75, .global_line = 1}},
      {"damping con1 0.75 as all", {.global_kind = NB_GLOBAL_CON1_ALL, .global = 0.75, .global_line = 1}},
      {"damping centred", {.centred = true, .centred_line = 1}},
      {"damping late", {.centred_line = 1}},
      {"damping none", {.contact_line = 1, .deep_line = 1, .centred_line = 1, .global_line = 1}},
      {"damping ratio 0.5\ndamping mass 4\ndamping centred\nstage s\ndamping none\ncycles 1",
       {.contact_line = 5, .deep_line = 5, .centred_line = 5, .global_line = 5}},
      {"damping walls ratio 0.5\nstage s\ndamping none\ncycles 1",
       {.contact_line = 3,
        .deep_line = 3,
        .centred_line = 3,
        .global_line = 3,
        .walls_line = 1,
        .walls_kind = NB_CONTACT_RATIO,
        .walls = 0.5}},
      {"damping centred\nstage s\ndamping late\ndamping mass 1\ncycles 1",
       {.centred_line = 3, .global_kind = NB_GLOBAL_MASS, .global = 1, .global_line = 4}},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    const bool in_stage = strstr(rows[k].lines, "stage") != NULL;
    struct words page = {0};
    struct written it;
    words_add(&page, "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nstep 0.1\nrecord time\n%s\n%s",
              rows[k].lines, in_stage ? "" : "stage s\ncycles 1\n");
    written_scene(&it, &page);
    struct nb_damping found = it.scene.stages[0].damping;
    const struct nb_damping *const wanted = &rows[k].wanted;
    const int lines[][2] = {{found.contact_line, wanted->contact_line},
                            {found.walls_line, wanted->walls_line},
                            {found.deep_line, wanted->deep_line},
                            {found.centred_line, wanted->centred_line},
                            {found.global_line, wanted->global_line}};
    for (size_t l = 0; l < sizeof lines / sizeof *lines; l++)
      CU_ASSERT_EQUAL(lines[l][0], lines[l][1] ? lines[l][1] + 6 : 0);
    const bool same = found.contact_kind == wanted->contact_kind && found.contact == wanted->contact &&
                      found.walls_separate == wanted->walls_separate && found.walls_kind == wanted->walls_kind &&
                      found.walls == wanted->walls && found.centred == wanted->centred && found.deep == wanted->deep &&
                      found.global_kind == wanted->global_kind && found.global == wanted->global;
    if (!same)
      printf("# %s\n", rows[k].lines);
    CU_ASSERT(same);
    written_free(&it);
  }
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial m density 1 young 1\nnormal hertz\nsphere 0 0 radius 1 m\ndamping critical beyond "
            "overlap 7 %%\n" GO "stage t\ndamping none\ncycles 1\n");
  written_scene(&it, &page);
  CU_ASSERT(it.scene.damping.deep == 0.07 && it.scene.damping.deep_line == 6 &&
            it.scene.stages[0].damping.deep == 0.07);
  CU_ASSERT_EQUAL(it.scene.stages[1].damping.deep, 0);
  written_free(&it);
}

/* Each kind of damping may be given once in the scene, and once more in each stage. */
static void damping_given_twice(void) {
  static const struct {
    const char *lines, *wanted;
  } rows[] = {
      {"damping ratio 0.1\ndamping stiffness 0.1", "the damping of contacts is given twice, first on line 7"},
      {"damping walls ratio 0.1\ndamping walls none",
       "the damping of contacts with walls is given twice, first on line 7"},
      {"damping mass 1\ndamping con1 1 as all", "the damping of all particles is given twice, first on line 7"},
      {"damping centred\ndamping late", "the time of the dashpots' velocity is given twice, first on line 7"},
      {"damping none\ndamping mass 1", "the damping of all particles is given twice, first on line 7"},
      {"damping ratio 0.1\ndamping walls ratio 0.1\ndamping mass 1\ndamping late", NULL},
      {"damping ratio 0.1\nstage s\ndamping ratio 0.2\ncycles 1\nstage t\ndamping ratio 0.1", NULL},
      {"stage s\ndamping ratio 0.2\ndamping ratio 0.1", "the damping of contacts is given twice, first on line 8"},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    char text[400];
    snprintf(text, sizeof text,
             "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nstep 0.1\nrecord time\n%s\n%scycles 1\n",
             rows[k].lines, strstr(rows[k].lines, "stage") ? "" : "stage s\n");
    says(text, rows[k].wanted, NULL);
  }
}

/* ---- regions, monitors, removals ---- */

static void regions_and_their_values(void) {
  struct words page = {0};
  struct written it;
  words_add(
      &page,
      "units none\nmaterial m density 1 kn 1\ngrading g 2 3 1 4\nlattice discs 3 by 1 radius 1 m\nsphere 9 9 radius 1 "
      "m\n"
      "wall w -9 -9 to 9 -9 m\nboundary circle 0 0 radius 1\nregion A circle 1 2 radius 3 rings 4 from t\n"
      "monitor D disc 2\nregion B box 1 2 to 5 10 from s\nregion C inside 0.5 rings 1000\nregion E all from t\n"
      "monitor F disc 1 with disc 3\nmonitor G disc 2 with sphere 4\nmonitor H sphere 4 with wall w\nmonitor I wall w\n"
      "monitor J grading g\nmonitor K grading g radius 1\nmonitor L grading g radius 2\n" GO
      "stage t\nremove disc 2\nremove sphere 4\ncycles 1\nstage u\nremove discs 1 to 1\nremove discs 3 to 3\ncycles "
      "1\n");
  written_scene(&it, &page);
  const struct nb_region *const r = it.scene.regions;
  CU_ASSERT(r[0].kind == NB_REGION_CIRCLE && r[0].x == 1 && r[0].y == 2 && r[0].radius == 3 && r[0].rings == 4);
  CU_ASSERT(r[1].kind == NB_REGION_BOX && r[1].x == 3 && r[1].y == 6 && r[1].half_x == 2 && r[1].half_y == 4);
  CU_ASSERT(r[1].ex == 1 && r[1].ey == 0 && r[1].rings == 0 && r[3].ex == 1 && r[3].ey == 0);
  CU_ASSERT(r[2].kind == NB_REGION_INSIDE && r[2].radius == 0.5 && r[2].rings == 1000 && r[3].kind == NB_REGION_ALL);
  CU_ASSERT(r[0].stage == 1 && r[1].stage == 0 && r[2].stage == -1 && r[3].stage == 1);
  CU_ASSERT(r[0].line == 9 && r[1].line == 11 && r[3].line == 13);
  static const struct nb_monitor wanted[] = {{"A", NB_MONITOR_REGION, 0, -1, 9},
                                             {"D", NB_MONITOR_PARTICLE, 1, -1, 10},
                                             {"B", NB_MONITOR_REGION, 1, -1, 11},
                                             {"C", NB_MONITOR_REGION, 2, -1, 12},
                                             {"E", NB_MONITOR_REGION, 3, -1, 13},
                                             {"F", NB_MONITOR_PARTICLE_PARTICLE, 0, 2, 14},
                                             {"G", NB_MONITOR_PARTICLE_PARTICLE, 1, 3, 15},
                                             {"H", NB_MONITOR_PARTICLE_WALL, 3, 0, 16},
                                             {"I", NB_MONITOR_WALL, 0, -1, 17},
                                             {"J", NB_MONITOR_GRADING, 0, -1, 18},
                                             {"K", NB_MONITOR_SIZE, 0, 1, 19},
                                             {"L", NB_MONITOR_SIZE, 0, 0, 20}};
  CU_ASSERT_EQUAL_FATAL(it.scene.monitor_count, sizeof wanted / sizeof *wanted);
  for (size_t k = 0; k < it.scene.monitor_count; k++) {
    const struct nb_monitor *const m = &it.scene.monitors[k];
    CU_ASSERT_STRING_EQUAL(m->name, wanted[k].name);
    CU_ASSERT(m->kind == wanted[k].kind && m->a == wanted[k].a && m->b == wanted[k].b && m->line == wanted[k].line);
  }
  const struct nb_removal *const t = it.scene.stages[1].removals, *const u = it.scene.stages[2].removals;
  CU_ASSERT(t[0].from == 1 && t[0].to == 1 && t[0].line == 26 && t[1].from == 3 && t[1].to == 3);
  CU_ASSERT(u[0].from == 0 && u[0].to == 0 && u[1].from == 2 && u[1].to == 2 && u[1].line == 31);
  written_free(&it);
}

/* A particle is removed once, and its statement names its shape. */
static void particles_that_cannot_be_removed(void) {
  static const struct {
    const char *first, *second, *wanted; /* of five discs and one sphere, number 6 */
  } rows[] = {
      {"remove discs 2 to 3", "remove disc 1", NULL},
      {"remove discs 2 to 3", "remove discs 4 to 5", NULL},
      {"remove discs 2 to 3", "remove disc 2", "particle 2 is removed already, on line 9"},
      {"remove discs 2 to 3", "remove disc 3", "particle 3 is removed already, on line 9"},
      {"remove discs 2 to 3", "remove discs 1 to 2", "particle 2 is removed already, on line 9"},
      {"remove discs 2 to 3", "remove discs 3 to 5", "particle 3 is removed already, on line 9"},
      {"remove discs 2 to 3", "remove discs 1 to 5", "particle 2 is removed already, on line 9"},
      {"remove discs 2 to 4", "remove disc 3", "particle 3 is removed already, on line 9"},
      {"remove disc 1\nremove disc 3", "remove disc 3", "particle 3 is removed already, on line 10"},
      {"remove sphere 6", "remove disc 5", NULL},
      {"remove sphere 5", "", "expected only numbers of spheres, but particle 5 is a disc"},
      {"remove disc 6", "", "expected only numbers of discs, but particle 6 is a sphere"},
      {"remove discs 4 to 6", "", "expected only numbers of discs, but particle 6 is a sphere"},
      {"remove spheres 4 to 6", "", "expected only numbers of spheres, but particle 4 is a disc"},
      {"remove discs 1 to 5", "remove spheres 6 to 6", NULL},
      {"remove disc 7", "", "from 1 to 6"},
      {"remove disc 0", "", "from 1 to 6"},
      {"remove discs 3 to 2", "", "from 3 to 6"},
      {"remove discs 3 to 7", "", "from 3 to 6"},
      {"remove w", "", "`disc N`, `discs N to M`, `sphere N`, `spheres N to M` or `wall NAME`"},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    for (int later = 0; later < 2; later++) {
      char text[400];
      snprintf(text, sizeof text,
               "units none\nmaterial m density 1 kn 1\nlattice discs 5 by 1 radius 1 m\nsphere 90 0 radius 1 m\nstep "
               "0.1\nrecord time\nstage s %s\n%s\ncycles 1\n%s%s\n%s",
               later ? "" : "# one stage only", rows[k].first, later ? "stage t\n" : "", rows[k].second,
               later ? "cycles 1\n" : "");
      if (!later && !rows[k].wanted)
        continue;
      says(text, rows[k].wanted, NULL);
    }
}

/* ---- walls ---- */

/* The hint for the unknown name of a wall lists at most eight walls. */
static void the_list_of_walls_in_a_hint(void) {
  for (int count = 0; count <= 9; count++) {
    char expected[300] = "", name[16];
    struct words page = {0};
    words_add(&page, "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\n");
    for (int k = 0; k < count; k++) {
      words_add(&page, "wall w%d -9 %d to 9 %d m\n", k, -20 - k, -20 - k);
      snprintf(name, sizeof name, "%s`w%d`", k ? ", " : "", k);
      if (k < 8)
        strcat(expected, name);
    }
    char wanted[400];
    snprintf(wanted, sizeof wanted, "hint: %s%s%s%sdefine it above with `wall NAME …` or `box …`\n",
             count ? "the scene has the walls " : "", expected, count > 8 ? ", …" : "", count ? "; " : "");
    words_add(&page, "monitor S wall roof\n" GO);
    says(page.text, wanted, NULL);
    free(page.text);
  }
}

/* A statement that needs an object whose own statement has a mistake is not reported, because it may be right. */
static void statements_below_a_mistake(void) {
  static const struct {
    const char *wrong, *scene, *stage;
  } rows[] = {
      {"box 9 9 to 0 0 m", "monitor S wall south", ""},
      {"box 9 9 to 0 0 m", "", "wall south velocity 0 1"},
      {"box 9 9 to 0 0 m", "", "walls inward 1"},
      {"box 9 9 to 0 0 m", "", "walls stop"},
      {"wall w 0 0 to 0 0 m", "", "walls stop"},
      {"box 9 9 to 0 0 m", "", "box strain 0 1"},
      {"box 9 9 to 0 0 m", "", "servo mean 1 on box through box at most 1"},
      {"periodic cell 9 9 to 0 0", "", "cell strain 0 1"},
      {"periodic cell 9 9 to 0 0", "perturb wave 1 1 periods 1 1", ""},
      {"boundary circle 0 0", "", "boundary fixed"},
      {"boundary circle 0 0", "region A inside 0.5", ""},
      {"lattice discs", "monitor D disc 7", ""},
      {"lattice discs", "", "remove disc 7"},
  };
  for (size_t k = 0; k < 2 * (sizeof rows / sizeof *rows); k++) {
    const bool wrong = k % 2;
    struct words words = {0};
    struct nb_page page = {0};
    struct nb_scene scene = {0};
    struct nb_mistakes mistakes = {0};
    words_add(&words,
              "```scene\nunits none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\n%s\n%s\nstep 0.1\nrecord "
              "time\nstage s\n%s\n"
              "cycles 1\n```\n",
              wrong ? rows[k / 2].wrong : "", rows[k / 2].scene, rows[k / 2].stage);
    nb_page_read_bytes(&page, "stated.md", words.text, words.length, &mistakes);
    nb_scene_read(&scene, &page, 0, NULL, &mistakes);
    if (mistakes.count != 1)
      printf("# %s\n# said: %s\n", words.text, mistakes.text ? mistakes.text : "nothing");
    CU_ASSERT_EQUAL(mistakes.count, 1); /* the wrong line, or the line that lacks an object */
    CU_ASSERT(mistakes.text && (strncmp(mistakes.text, "stated.md:5:", 12) == 0) == wrong);
    nb_mistakes_free(&mistakes), nb_scene_free(&scene), nb_page_free(&page), free(words.text);
  }
}

/* A name is given once, also that of the first object of its kind. */
static void names_that_exist(void) {
  static const struct {
    const char *scene, *stages, *wanted;
  } rows[] = {
      {"material m density 1", "", "there is a material `m` already, on line 3"},
      {"grading g 1 1\ngrading g 1 1", "", "there is a grading `g` already, on line 5"},
      {"wall w 0 9 to 1 9 m\nwall w 0 8 to 1 8 m", "", "there is a wall `w` already, on line 5"},
      {"wall south 0 9 to 1 9 m\nbox -9 -9 to 9 9 m", "", "there is a wall `south` already, on line 5"},
      {"box -9 -9 to 9 9 m\nwall north 0 9 to 1 9 m", "", "there is a wall `north` already, on line 5"},
      {"box -9 -9 to 9 9 m\nbox -9 -9 to 9 9 m", "", "there is a wall `south` already, on line 5"},
      {"monitor A disc 1\nmonitor A disc 1", "", "there is a monitor `A` already, on line 5"},
      {"monitor A disc 1\nregion A all", "", "there is a monitor `A` already, on line 5"},
      {"region A all\nmonitor A disc 1", "", "there is a region `A` already, on line 5"},
      {"region A all\nregion A all", "", "there is a region `A` already, on line 5"},
      {"", "stage s\ncycles 1", "there is a stage `s` already, on line 8"},
      {"periodic cell -9 -9 to 9 9\nperiodic cell -9 -9 to 9 9", "", "`periodic cell` is given twice, first on line 5"},
      {"gravity 0 1\ngravity 0 1", "", "`gravity` is given twice, first on line 5"},
      {"boundary circle 0 0 radius 1\nboundary circle 0 0 radius 1", "", "`boundary` is given twice, first on line 5"},
      {"transform rotate 1\ntransform rotate 1", "", "`transform` is given twice, first on line 5"},
      {"skin 1\nskin 1", "", "expected one `skin`, found a second one"},
      {"wall w 0 9 to 1 9 m\nwall v 0 8 to 1 8 m\nmonitor A wall w\nregion B all", "stage t\ncycles 1", NULL},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    char text[500];
    snprintf(text, sizeof text, "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\n%s\n" GO "%s\n",
             rows[k].scene, rows[k].stages);
    says(text, rows[k].wanted, NULL);
  }
  static const char *const twice[] = {
      "gravity 0 1\ngravity 0 1",
      "normal linear\nnormal linear",
      "shear linear\nshear none",
      "rotation off\nrotation on",
      "affine none\naffine none",
      "cycles 1\ncycles 1",
      "cycles 1\nuntil time above 1 at most 1 cycle",
      "record none\nrecord none",
      "box strain 0 0\nbox strain 0 0",
      "boundary fixed\nboundary none",
      "material m kn 1\nmaterial m kn 2",
      "material m kn 1 ks 2\nmaterial m friction 1 ks 2",
      "pair m n kn 1\npair n m kn 2",
      "wall w spin 1\nwall w spin 2",
      "wall w velocity 1 0\nwall w velocity 0 1",
      "wall w velocity 1 0\nwalls stop",
      "walls stop\nwalls inward 1",
      "servo mean 1 on box through box at most 1\nservo mean 1 on box through box at most 1"};
  static const char *const once[] = {"gravity 0 1",
                                     "normal linear\nshear linear",
                                     "rotation off",
                                     "material m kn 1\nmaterial m ks 2",
                                     "material m kn 1\nmaterial n kn 1",
                                     "material m kn 1\npair m m kn 1",
                                     "pair m n kn 1\npair m m kn 1\npair n n kn 1",
                                     "pair m n kn 1\npair n m ks 1",
                                     "wall w spin 1\nwall w velocity 1 0",
                                     "wall w spin 1\nwall v spin 1",
                                     "walls stop\nwall w velocity 1 0\nwall w spin 1",
                                     "walls inward 1\nwall south velocity 0 2"};
  for (size_t k = 0; k < sizeof twice / sizeof *twice + sizeof once / sizeof *once; k++) {
    const bool wrong = k < sizeof twice / sizeof *twice;
    const char *const lines = wrong ? twice[k] : once[k - sizeof twice / sizeof *twice];
    char text[600];
    snprintf(text, sizeof text,
             "units none\nmaterial m density 1 kn 1\nmaterial n kn 1\ndisc 0 0 radius 1 m\nbox -9 -9 to 9 9 m\nwall v "
             "0 5 to 1 "
             "5 m\nwall w 0 6 to 1 6 m\nboundary circle 0 0 radius 1\nstep 0.1\nrecord time\nstage s\n%s\n%s",
             lines, strstr(lines, "cycle") ? "" : "cycles 1\n");
    says(text, wrong ? "error: " : NULL, NULL);
  }
}

/* The second corner of a box, a cell or a region has larger x and y than the first, at a finite distance. */
static void corners(void) {
  static const struct {
    const char *corners, *wanted;
  } rows[] = {{"1 -2 to 4 -1", NULL},
              {"1000 0 to 1000.5 9", NULL},
              {"0 1000 to 9 1000.5", NULL},
              {"0 0 to 0 3", "expected a second corner with larger x and larger y than the first corner"},
              {"0 0 to 2 0", "expected a second corner with larger x"},
              {"0 0 to -2 3", "expected a second corner with larger x"},
              {"0 0 to 2 -3", "expected a second corner with larger x"},
              {"-1.7e308 0 to 1.7e308 3", "expected two corners at a finite distance; these are too far apart"},
              {"0 -1.7e308 to 2 1.7e308", "expected two corners at a finite distance"}};
  for (size_t k = 0; k < 3 * (sizeof rows / sizeof *rows); k++) {
    char text[300], line[100];
    snprintf(line, sizeof line,
             k % 3 == 0   ? "box %s m"
             : k % 3 == 1 ? "periodic cell %s"
                          : "region A box %s",
             rows[k / 3].corners);
    snprintf(text, sizeof text, "units none\nmaterial m density 1 kn 1\n%s\ndisc 1 1 radius 0.1 m fixed\n" GO, line);
    says(text, rows[k / 3].wanted, NULL);
  }
}

/* A particle on a wall of the box is inside. */
static void a_particle_on_a_wall_is_inside_the_box(void) {
  static const char *const places[] = {"0 4", "8 4", "4 0", "4 8", "0 0", "8 8"};
  for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page, "units none\nmaterial m density 1 kn 1\nbox 0 0 to 8 8 m\ndisc %s radius 1 m\n" GO, places[k]);
    written_scene(&it, &page);
    CU_ASSERT_EQUAL(it.scene.warnings.count, 0);
    written_free(&it);
  }
}

/* ---- contact tests ---- */

/* A segment has a target for the normal and one for the tangential direction: a value or a change, of a displacement or a
 * force. Without its own target a displacement stays, and `hold` keeps a force: a change of 0. */
static void targets_of_segments(void) {
  static const struct {
    const char *line;
    struct nb_target normal, shear;
    unsigned long steps;
  } rows[] = {
      {"overlap to 2 in 3 steps", {false, false, 2}, {false, true, 0}, 3},
      {"overlap by -2", {false, true, -2}, {false, true, 0}, 100},
      {"normal to 2", {true, false, 2}, {false, true, 0}, 100},
      {"normal to 0", {true, false, 0}, {false, true, 0}, 100},
      {"normal by -2 slip to 3", {true, true, -2}, {false, false, 3}, 100},
      {"slip by 3 overlap to -1 in 1 step", {false, false, -1}, {false, true, 3}, 1},
      {"shear to -4 hold normal", {true, true, 0}, {true, false, -4}, 100},
      {"in 7 steps shear by 4", {false, true, 0}, {true, true, 4}, 7},
      {"hold shear overlap by 5", {false, true, 5}, {true, true, 0}, 100},
      {"hold normal hold shear", {true, true, 0}, {true, true, 0}, 100},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    words_add(
        &page,
        "path\nunits none\nmaterial rock kn 1 ks 1 friction 1\nshear linear\ncontact disc 1 rock with disc 1 rock\n"
        "segment a %s\n",
        rows[k].line);
    written_scene(&it, &page);
    const struct nb_stage *const stage = &it.scene.stages[0];
    const struct nb_target *const found[] = {&stage->segment.normal, &stage->segment.shear}, *const wanted[] = {
                                                                                                 &rows[k].normal,
                                                                                                 &rows[k].shear};
    for (int d = 0; d < 2; d++)
      CU_ASSERT(found[d]->force == wanted[d]->force && found[d]->relative == wanted[d]->relative &&
                found[d]->value == wanted[d]->value);
    CU_ASSERT(stage->cycles == rows[k].steps && stage->record_interval == 1 && !stage->segment.points);
    written_free(&it);
  }
  static const struct {
    const char *line, *wanted;
  } wrong[] = {
      {"overlap to 1 normal to 2", "only one of `overlap`, `normal` and `hold normal` in a segment"},
      {"hold normal overlap to 2", "only one of `overlap`, `normal` and `hold normal` in a segment"},
      {"slip to 1 hold shear", "only one of `slip`, `shear` and `hold shear` in a segment"},
      {"shear to 1 slip to 2", "only one of `slip`, `shear` and `hold shear` in a segment"},
      {"in 3 steps in 4 steps overlap to 1", "only one `in N steps` in a segment"},
      {"normal to -1", "expected a force, 0 or more, found `-1`"},
      {"in 3 steps", "expected `overlap`, `normal`, `slip`, `shear` or `hold`, found the end of the line"},
      {"", "expected `overlap`, `normal`, `slip`, `shear`, `hold` or `follow FILE`, found the end of the line"},
      {"press", "expected `overlap`, `normal`, `slip`, `shear`, `hold`, `in N steps` or `follow FILE`, found `press`"},
      {"overlap to 1 press",
       "expected `overlap`, `normal`, `slip`, `shear`, `hold`, `in N steps` or the end of the line"},
      {"overlap to 1 follow x",
       "expected `overlap`, `normal`, `slip`, `shear`, `hold`, `in N steps` or the end of the line"},
      {"hold overlap", "hint: overlap and slip stay constant where the segment does not name them"},
      {"hold norml", "hint: did you mean `normal`?"},
      {"overlap 1", "expected `to` or `by`, found `1`"},
      {"overlap 1", "hint: write `overlap to VALUE`, or for a change `overlap by VALUE`"},
      {"shear", "hint: write `shear to VALUE`, or for a change `shear by VALUE`"},
  };
  for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
    char text[400];
    snprintf(
        text, sizeof text,
        "path\nunits none\nmaterial rock kn 1 ks 1\nshear linear\ncontact disc 1 rock with disc 1 rock\nsegment a %s\n",
        wrong[k].line);
    says(text, wrong[k].wanted, NULL);
  }
}

/* The two sides of the contact. The wall is as long as the diameter of the particle. */
static void sides_of_a_contact(void) {
  struct words page = {0};
  struct written it;
  words_add(
      &page,
      "path\nunits none\nmaterial rock kn 1\nmaterial clay kn 1\ncontact sphere 2 rock with disc 3 clay\nsegment a "
      "overlap to 1\n");
  written_scene(&it, &page);
  const struct nb_particle *const particles = it.scene.particles;
  CU_ASSERT(it.scene.particle_count == 2 && it.scene.wall_count == 0 && it.scene.contact_test);
  CU_ASSERT(particles[0].shape == NB_SPHERE && particles[0].radius == 2 && particles[0].material == 0);
  CU_ASSERT(particles[1].shape == NB_DISC && particles[1].radius == 3 && particles[1].material == 1);
  CU_ASSERT(particles[0].line == 5 && particles[1].line == 5);
  static const char *const columns[] = {"step", "overlap", "slip", "normal", "shear"};
  CU_ASSERT_EQUAL_FATAL(it.scene.column_count, 5);
  for (int k = 0; k < 5; k++)
    CU_ASSERT_STRING_EQUAL(it.scene.columns[k].name, columns[k]);
  written_free(&it);
  words_add(
      &page,
      "path\nunits none\nmaterial rock kn 1\nmaterial clay kn 1\ncontact disc 2 rock with wall clay\nrecord slip\n"
      "segment a overlap to 1\n");
  written_scene(&it, &page);
  const struct nb_wall *const wall = &it.scene.walls[0];
  CU_ASSERT(it.scene.particle_count == 1 && it.scene.wall_count == 1 && it.scene.column_count == 1);
  CU_ASSERT(wall->material == 1 && wall->ex == 0 && wall->ey == 1 && wall->h1 == -2 && wall->h2 == 2 &&
            wall->line == 5);
  CU_ASSERT(wall->x == 0 && wall->y == 0);
  written_free(&it);
}

void suite_stated(void) {
  CU_pSuite suite = CU_add_suite("stated", NULL, NULL);
  CU_ADD_TEST(suite, quarter_turns_are_exact);
  CU_ADD_TEST(suite, numbers_that_transform_makes_infinite);
  CU_ADD_TEST(suite, soften_divides_stiffnesses);
  CU_ADD_TEST(suite, refine_multiplies_numbers_of_cycles);
  CU_ADD_TEST(suite, whole_products);
  CU_ADD_TEST(suite, refine_changes_what_depends_on_the_step);
  CU_ADD_TEST(suite, a_sorted_packing);
  CU_ADD_TEST(suite, conditions_that_count_from_the_first_page);
  CU_ADD_TEST(suite, names_of_repeated_stages);
  CU_ADD_TEST(suite, targets_of_a_servo);
  CU_ADD_TEST(suite, hints_for_a_servo);
  CU_ADD_TEST(suite, hints_for_a_fraction_of_a_size);
  CU_ADD_TEST(suite, hints_for_the_number_of_repetitions);
  CU_ADD_TEST(suite, names_and_options_of_laws);
  CU_ADD_TEST(suite, at_most_one_rigid_side);
  CU_ADD_TEST(suite, the_list_of_walls_in_a_hint);
  CU_ADD_TEST(suite, corners);
  CU_ADD_TEST(suite, targets_of_segments);
  CU_ADD_TEST(suite, sides_of_a_contact);
  CU_ADD_TEST(suite, names_that_exist);
  CU_ADD_TEST(suite, statements_below_a_mistake);
  CU_ADD_TEST(suite, a_particle_on_a_wall_is_inside_the_box);
  CU_ADD_TEST(suite, a_material_is_reported_once);
  CU_ADD_TEST(suite, the_last_setting_of_a_law_counts);
  CU_ADD_TEST(suite, kinds_of_damping);
  CU_ADD_TEST(suite, damping_given_twice);
  CU_ADD_TEST(suite, regions_and_their_values);
  CU_ADD_TEST(suite, particles_that_cannot_be_removed);
  CU_ADD_TEST(suite, warnings_of_a_law_without_micro_slip);
}
