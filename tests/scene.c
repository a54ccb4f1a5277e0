/* The scene that a page describes: particles, walls, materials, stages, and defaults.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../src/core/model.h"
#include "../src/core/names.h"
#include "../src/laws/law.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

struct read {
  struct nb_page page;
  struct nb_scene scene;
  struct nb_mistakes mistakes;
};

/* Reads a page with these statements, and its scene. An error ends the test. */
static struct read read_scene(const char *statements) {
  struct read read = {0};
  char path[] = "/tmp/nineball-scene-XXXXXX";
  FILE *file = written_file(path);
  fprintf(file, "```scene\n%s\n```\n", statements);
  fclose(file);
  nb_page_read(&read.page, path, &read.mistakes);
  nb_scene_read(&read.scene, &read.page, 0, NULL, &read.mistakes);
  unlink(path);
  if (read.mistakes.text)
    printf("# %s", read.mistakes.text);
  CU_ASSERT_EQUAL_FATAL(read.mistakes.count, 0);
  return read;
}

static void done(struct read *read) {
  nb_scene_free(&read->scene);
  nb_page_free(&read->page);
  nb_mistakes_free(&read->mistakes);
}

#define ROCK "material rock density 2000 kg/m3 kn 3 kN/m ks 1 kN/m friction 0.5\n"
#define END "step 1 us\nstage go\n cycles 10\n"

static void lattice(void) {
  struct read read = read_scene(ROCK "disc 9 m 9 m radius 1 m rock\nlattice discs 3 by 2 radius 5 mm rock\n"
                                     "lattice spheres 2 by 2 from 1 m 2 m spacing 3 m radius 1 m rock\n" END);
  const struct nb_particle *particles = read.scene.particles;
  CU_ASSERT_EQUAL_FATAL(read.scene.particle_count, 11);
  static const double x[] = {5, 15, 25, 5, 15, 25}, y[] = {5, 5, 5, 15, 15, 15}; /* mm */
  for (size_t i = 0; i < 6; i++) {
    CU_ASSERT_DOUBLE_EQUAL(particles[i + 1].x, x[i] / 1000, 1e-17);
    CU_ASSERT_DOUBLE_EQUAL(particles[i + 1].y, y[i] / 1000, 1e-17);
    CU_ASSERT(particles[i + 1].shape == NB_DISC && particles[i + 1].radius == 0.005 && particles[i + 1].line == 4);
  }
  CU_ASSERT(particles[7].x == 1 && particles[7].y == 2 && particles[8].x == 4 && particles[8].y == 2);
  CU_ASSERT(particles[9].x == 1 && particles[9].y == 5 && particles[10].shape == NB_SPHERE);
  done(&read);
}

static void particles(void) {
  struct read read =
      read_scene(ROCK "material air\nsphere 1 m 2 m rock fixed spin -3 rad/s velocity 4 m/s 5 mm/s radius 6 cm\n"
                      "disc 0 m 0 m radius 1 m air fixed\ndisc 5 m 5 m radius 1 m rock\n" END);
  const struct nb_particle *particle = &read.scene.particles[0];
  CU_ASSERT(particle->x == 1 && particle->y == 2 && particle->radius == 0.06 && particle->vx == 4 &&
            particle->vy == 0.005);
  CU_ASSERT(particle->spin == -3 && particle->fixed && particle->shape == NB_SPHERE && particle->material == 0);
  CU_ASSERT(read.scene.particles[1].fixed && read.scene.particles[1].material == 1);
  CU_ASSERT(!read.scene.particles[2].fixed && read.scene.particles[2].vx == 0 && read.scene.particles[2].spin == 0);
  CU_ASSERT_DOUBLE_EQUAL(nb_particle_mass(&read.scene, particle), 4.0 / 3 * acos(-1) * 2.16e-4 * 2000, 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(nb_particle_inertia(&read.scene, particle),
                         0.4 * 0.0036 * nb_particle_mass(&read.scene, particle), 1e-17);
  particle = &read.scene.particles[2];
  CU_ASSERT_DOUBLE_EQUAL(nb_particle_mass(&read.scene, particle), 2000 * acos(-1), 1e-11);
  CU_ASSERT_DOUBLE_EQUAL(nb_particle_inertia(&read.scene, particle), 1000 * acos(-1), 1e-11);
  done(&read);
}

static void walls(void) {
  struct read read =
      read_scene(ROCK "box 1 m 2 m to 5 m 4 m rock\nwall ramp 0 m 0 m to 3 m 4 m rock velocity 1 m/s 2 m/s\n"
                      "disc 3 m 3 m radius 1 m rock\n" END);
  static const struct nb_wall wanted[] = {
      {.name = "south", .x = 3, .y = 2, .ex = 1, .h2 = 2, .iny = 1},
      {.name = "east", .x = 5, .y = 3, .ey = 1, .h2 = 1, .inx = -1},
      {.name = "north", .x = 3, .y = 4, .ex = -1, .h2 = 2, .iny = -1},
      {.name = "west", .x = 1, .y = 3, .ey = -1, .h2 = 1, .inx = 1},
      {.name = "ramp", .x = 1.5, .y = 2, .ex = 0.6, .ey = 0.8, .h2 = 2.5, .vx = 1, .vy = 2},
  };
  CU_ASSERT_EQUAL_FATAL(read.scene.wall_count, 5);
  for (size_t i = 0; i < 5; i++) {
    const struct nb_wall *w = &read.scene.walls[i], *v = &wanted[i];
    CU_ASSERT_STRING_EQUAL(w->name, v->name);
    CU_ASSERT(w->x == v->x && w->y == v->y && w->ex == v->ex && w->ey == v->ey && w->vx == v->vx && w->vy == v->vy);
    CU_ASSERT(w->h1 == -v->h2 && w->h2 == v->h2 && w->inx == v->inx && w->iny == v->iny);
  }
  done(&read);
}

static void pairs(void) {
  struct read read = read_scene(ROCK "material clay kn 6 kN/m ks 1 kN/m friction 0.25 cohesion 2 N\nmaterial air\n"
                                     "pair air rock friction 0 kn 7 N/m\ndisc 0 m 0 m radius 1 m rock\n" END);
  struct nb_pair like = nb_scene_pair(&read.scene, 0, 0), unlike = nb_scene_pair(&read.scene, 0, 1);
  struct nb_pair ruled = nb_scene_pair(&read.scene, 0, 2), soft = nb_scene_pair(&read.scene, 1, 2);
  CU_ASSERT(like.kn == 3000 && like.ks == 1000 && like.friction == 0.5 && like.cohesion == 0);
  CU_ASSERT(unlike.kn == 4000 && unlike.ks == 1000 && unlike.friction == 0.25 && unlike.cohesion == 0);
  CU_ASSERT(ruled.kn == 7 && ruled.ks == 0 && ruled.friction == 0);
  CU_ASSERT(soft.kn == 0 && nb_scene_pair(&read.scene, 2, 2).kn == 0); /* and not 0/0 */
  done(&read);
}

static void defaults(void) {
  struct read read = read_scene(ROCK "disc 0 m 0 m radius 1 m rock\n" END);
  const struct nb_stage *stage = &read.scene.stages[0];
  CU_ASSERT_STRING_EQUAL(read.scene.normal, "linear");
  CU_ASSERT_STRING_EQUAL(read.scene.shear, "none");
  CU_ASSERT(!read.scene.unitless && read.scene.column_count == 0 && read.scene.materials[0].cohesion == 0);
  CU_ASSERT(stage->record_interval == 1 && !stage->snapshot && stage->cycles == 10 && stage->condition_count == 0);
  CU_ASSERT(stage->damping.contact_kind == NB_CONTACT_UNDAMPED && stage->damping.global_kind == NB_GLOBAL_UNDAMPED);
  CU_ASSERT(stage->step.kind == NB_STEP_TIME && stage->step.value == 1e-6 && stage->motion_count == 0);
  done(&read);
}

/* The step may stand in the first stage, even if this is the only one. */
static void a_step_in_the_first_stage(void) {
  struct read read = read_scene(ROCK "disc 0 m 0 m radius 1 m rock\nstage go\nstep 1 us\ncycles 10\n");
  CU_ASSERT(read.scene.stages[0].step.kind == NB_STEP_TIME && read.scene.stages[0].step.value == 1e-6);
  done(&read);
}

static void stages(void) {
  struct read read = read_scene(
      ROCK "box 0 m 0 m to 9 m 9 m rock\nwall mid 1 m 1 m to 2 m 1 m rock\nlattice discs 2 by 1 radius 1 m rock\n"
           "record time C.normal\nmonitor C disc 1 with disc 2\nstep 0.1 of single-contact\ndamping ratio 5 %\n"
           "damping con1 0.99 as all\nstage a\nwalls inward 2 m/s\nwall east velocity 3 m/s 4 m/s\ncycles 7\nstage b\n"
           "step 2 us\ndamping mass 3 1/s\nwalls stop\nrecord every 5 cycles\nsnapshot\n"
           "until C.normal above 2 kN and time below 3 ms at most 99 cycles\nstage c\n"
           "damping stiffness 1 us\nrecord none\ncycles 1\nstage d\ndamping none\ncycles 1\n");
  const struct nb_stage *a = &read.scene.stages[0], *b = a + 1, *c = b + 1, *d = c + 1;
  static const double v[4][2] = {{0, 2}, {3, 4}, {0, -2}, {2, 0}};
  CU_ASSERT_EQUAL_FATAL(read.scene.stage_count, 4);
  CU_ASSERT_EQUAL_FATAL(a->motion_count, 4); /* `mid` is not a wall of the box */
  for (int i = 0; i < 4; i++)
    CU_ASSERT(a->motions[i].wall == i && a->motions[i].vx == v[i][0] && a->motions[i].vy == v[i][1]);
  CU_ASSERT(a->step.kind == NB_STEP_SINGLE_CONTACT && a->step.value == 0.1 && a->damping.contact == 0.05 &&
            a->cycles == 7);
  CU_ASSERT(a->damping.global_kind == NB_GLOBAL_CON1_ALL && a->damping.global == 0.99);
  CU_ASSERT(b->motion_count == 5 && b->motions[1].vx == 0 && b->record_interval == 5 && b->snapshot && b->cycles == 99);
  CU_ASSERT(b->step.kind == NB_STEP_TIME && b->damping.contact_kind == NB_CONTACT_RATIO);
  CU_ASSERT(b->damping.global_kind == NB_GLOBAL_MASS && b->damping.global == 3);
  CU_ASSERT_EQUAL_FATAL(b->condition_count, 2);
  CU_ASSERT(b->conditions[0].relation == NB_ABOVE && b->conditions[0].value == 2000);
  CU_ASSERT(b->conditions[1].relation == NB_BELOW && b->conditions[1].value == 0.003);
  CU_ASSERT(c->step.value == 2e-6 && c->record_interval == 0 && c->damping.contact_kind == NB_CONTACT_STIFFNESS);
  CU_ASSERT(c->damping.contact == 1e-6 && c->damping.global_kind == NB_GLOBAL_MASS); /* as the stage before */
  CU_ASSERT(d->damping.contact_kind == NB_CONTACT_UNDAMPED && d->damping.global_kind == NB_GLOBAL_UNDAMPED);
  CU_ASSERT(read.scene.step.kind == NB_STEP_SINGLE_CONTACT && read.scene.column_count == 2);
  CU_ASSERT_STRING_EQUAL(read.scene.columns[1].name, "C.normal"); /* although C is defined later */
  CU_ASSERT(read.scene.columns[1].quantity.monitor == 0 && read.scene.monitors[0].b == 1);
  done(&read);
}

/* The number of runs follows from the sweeps, also from one that is indented or whose first word is a value. */
static void runs_of_a_sweep(void) {
  static const char *const sweeps[] = {"sweep v 1 2 3", "  sweep v 1 2 3", "\tsweep v 1 2 3",
                                       "let word sweep\n$word v 1 2 3"};
  for (size_t k = 0; k < sizeof sweeps / sizeof *sweeps; k++) {
    char text[256];
    snprintf(text, sizeof text, "%s\n" ROCK "disc 0 m 0 m radius 1 m rock\n" END, sweeps[k]);
    struct read read = read_scene(text);
    CU_ASSERT_EQUAL(read.scene.runs, 3);
    done(&read);
  }
}

/* The stages of the other page come first, and each stage of this page is added. An array of stages grows at 8, 16 and
 * 32 stages. */
static void stages_after_those_of_another_page(void) {
  static const int counts[] = {1, 7, 8, 9, 15, 16, 17, 32};
  for (size_t k = 0; k < sizeof counts / sizeof *counts; k++) {
    char path[] = "/tmp/nineball-scene-XXXXXX.md", text[1024];
    const int descriptor = mkstemps(path, 3);
    CU_ASSERT_FATAL(descriptor >= 0);
    FILE *file = fdopen(descriptor, "w");
    CU_ASSERT_PTR_NOT_NULL_FATAL(file);
    fputs("# A page\n\n```scene\nunits none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nstep 0.25\nrecord time\n",
          file);
    for (int s = 0; s < counts[k]; s++)
      fprintf(file, "stage s%d\ncycles %d\n", s, s + 1);
    fputs("```\n", file);
    fclose(file);
    snprintf(text, sizeof text, "start %s stage s%d\nrecord time\nstage one\ncycles 100\nstage two\ncycles 200", path,
             counts[k] - 1);
    struct read read = read_scene(text);
    const struct nb_scene *scene = &read.scene;
    CU_ASSERT_EQUAL(scene->start.stages, (size_t)counts[k]);
    CU_ASSERT_EQUAL_FATAL(scene->stage_count, (size_t)counts[k] + 2);
    for (int s = 0; s < counts[k]; s++) {
      char name[16];
      snprintf(name, sizeof name, "s%d", s);
      CU_ASSERT_STRING_EQUAL(scene->stages[s].name, name);
      CU_ASSERT_EQUAL(scene->stages[s].cycles, (unsigned long)s + 1);
    }
    CU_ASSERT_STRING_EQUAL(scene->stages[counts[k]].name, "one");
    CU_ASSERT_EQUAL(scene->stages[counts[k]].cycles, 100);
    CU_ASSERT_STRING_EQUAL(scene->stages[counts[k] + 1].name, "two");
    CU_ASSERT_EQUAL(scene->stages[counts[k] + 1].cycles, 200);
    done(&read);
    unlink(path);
  }
}

/* A statement that a page takes from another one by `start` has the line of `start`, which messages show. A statement that
 * the other page does not have has no line. */
static void statements_of_another_page_have_the_line_of_start(void) {
  static const char *const more[] = {
      "",
      "gravity 0 -1\nperiodic cell -9 -9 to 9 9\nnormal linear\ndamping ratio 0.1\nstage s\ncell strain 0.1 0\ncycles "
      "1",
      ("boundary circle 0 0 radius 9\nshear linear\ndamping mass 1\npair m m ks 1\nstage s\nboundary strain 0.1 0\n"
       "affine strain 0.1 0\nrotation off\ngravity 0 -1\ncycles 1"),
      "box -9 -9 to 9 9 m\nstage s\nbox strain 0.1 0\nshear linear\nnormal linear\ncycles 1",
      ("normal hertz\ndamping walls ratio 0.1\ndamping critical beyond overlap 0.1\ndamping centred\n"
       "stage s\ncycles 1")};
  for (size_t k = 0; k < sizeof more / sizeof *more; k++) {
    char path[] = "/tmp/nineball-scene-XXXXXX.md", text[1024];
    const int descriptor = mkstemps(path, 3);
    CU_ASSERT_FATAL(descriptor >= 0);
    FILE *file = fdopen(descriptor, "w");
    CU_ASSERT_PTR_NOT_NULL_FATAL(file);
    fprintf(file,
            "\n\n```scene\nunits none\nmaterial m density 1 kn 1 young 1\ngrading g 1 9\nsphere 0 0 radius 1 m\nstep "
            "0.25\n%s\n%s```\n",
            more[k], k ? "" : "stage s\ncycles 1\n");
    fclose(file);
    snprintf(text, sizeof text, "start %s stage s\nrecord time\nstage one\ncycles 1", path);
    struct read read = read_scene(text);
    const struct nb_scene *of = &read.scene, *other = of->start.scene;
    const struct nb_stage *a = &of->stages[0], *b = &other->stages[0];
    const int lines[][2] = {{of->gravity.line, other->gravity.line},
                            {of->cell.line, other->cell.line},
                            {of->circle.line, other->circle.line},
                            {of->normal_line, other->normal_line},
                            {of->shear_line, other->shear_line},
                            {of->materials[0].line, other->materials[0].line},
                            {of->gradings[0].line, other->gradings[0].line},
                            {of->particles[0].line, other->particles[0].line},
                            {of->wall_count ? of->walls[3].line : 0, other->wall_count ? other->walls[3].line : 0},
                            {a->line, b->line},
                            {a->gravity.line, b->gravity.line},
                            {a->damping.contact_line, b->damping.contact_line},
                            {a->damping.global_line, b->damping.global_line},
                            {a->damping.walls_line, b->damping.walls_line},
                            {a->damping.deep_line, b->damping.deep_line},
                            {a->damping.centred_line, b->damping.centred_line},
                            {a->step.line, b->step.line},
                            {a->boundary.line, b->boundary.line},
                            {a->affine.line, b->affine.line},
                            {a->rotation_line, b->rotation_line},
                            {a->cell_line, b->cell_line},
                            {a->box_line, b->box_line},
                            {a->laws.normal_line, b->laws.normal_line},
                            {a->laws.shear_line, b->laws.shear_line}};
    CU_ASSERT(of->gradings[0].sizes != other->gradings[0].sizes); /* each scene frees its own */
    for (size_t l = 0; l < sizeof lines / sizeof *lines; l++) {
      if (lines[l][0] != (lines[l][1] ? of->start.line : 0))
        printf("# %zu, %zu: %d, %d\n", k, l, lines[l][0], lines[l][1]);
      CU_ASSERT_EQUAL(lines[l][0], lines[l][1] ? of->start.line : 0);
    }
    done(&read);
    unlink(path);
  }
}

/* Two names are distinguished even if one is the beginning of the other. A name may contain `_`. */
static void monitors_whose_names_begin_alike(void) {
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial m density 1 kn 1\ndisc 1 0 radius 1 m\ndisc 4 0 radius 1 m\ndisc 7 0 radius 1 m\n"
            "monitor AB disc 2\nmonitor A disc 1\nmonitor A_B disc 3\nrecord A.x AB.x A_B.x\nstep 0.01\n"
            "stage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL(written_now(model, "A.x"), 1);
  CU_ASSERT_EQUAL(written_now(model, "AB.x"), 4);
  CU_ASSERT_EQUAL(written_now(model, "A_B.x"), 7);
  nb_model_free(model);
  written_free(&it);
}

/* The hash of a stage identifies the state at its end. Statements that concern only output or advice do not change this
 * hash. All other statements change it. */
static void hash_of_a_stage(void) {
  static const struct {
    const char *head, *stage;
    bool same;
  } rows[] = {{"", "", true},
              {"record time\n", "", true},
              {"trade s 2 3\n", "", true},
              {"", "snapshot\n", true},
              {"record time\n", "record every 2 cycles\n", true},
              {"skin 0.2\n", "", false},
              {"gravity 0 1\n", "", false},
              {"", "gravity 0 1\n", false},
              {"", "damping ratio 0.1\n", false},
              {"", "allow unstable\n", false}};
  /* Values that differ in the last digit only, and values whose digits are the same without the spaces. */
  static const char *const values[] = {"gravity 0 1\n", "gravity 0 2\n", "gravity 1 11\n", "gravity 11 1\n"};
  enum { VALUES = sizeof values / sizeof *values };
  unsigned long long first = 0, hash[VALUES];
  for (int k = 0; k < VALUES; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page, "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nstep 0.1\nstage a\n%scycles 1\n",
              values[k]);
    written_scene(&it, &page);
    hash[k] = it.scene.stages[0].hash;
    for (int other = 0; other < k; other++)
      CU_ASSERT(hash[k] != hash[other]);
    written_free(&it);
  }
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nlet s = 1\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\n%sstep 0.1\nstage a\n%s"
              "cycles 1\n",
              rows[k].head, rows[k].stage);
    written_scene(&it, &page);
    first = k ? first : it.scene.stages[0].hash;
    if ((it.scene.stages[0].hash == first) != rows[k].same)
      printf("# %s%s\n", rows[k].head, rows[k].stage);
    CU_ASSERT_EQUAL(it.scene.stages[0].hash == first, rows[k].same);
    written_free(&it);
  }
}

/* A scene has the quantities of an impact, a cell or a box only if it has such an object. */
static void quantities_of_objects(void) {
  static const struct {
    const char *of, *statement;
  } rows[] = {{"impact.", "wall w -9 0 to 9 0 m\nmonitor C disc 1 with wall w\nimpact C speed 1 angle 0"},
              {"cell", "periodic cell -5 -5 to 5 5"},
              {"box.", "box -5 -5 to 5 5 m"},
              {"walls.", "box -5 -5 to 5 5 m"}};
  for (size_t k = 0; k < 2 * sizeof rows / sizeof *rows; k++) {
    const bool there = k % 2;
    const char *const of = rows[k / 2].of;
    struct words page = {0};
    struct written it;
    struct nb_quantity quantity;
    struct nb_quantity_row row;
    size_t count = 0;
    words_add(&page, "units none\nmaterial m density 1 kn 1\ndisc 0 1 radius 1 m\n%s\nstep 0.1\nstage a\ncycles 1\n",
              there ? rows[k / 2].statement : "");
    written_scene(&it, &page);
    for (size_t n = 0; nb_quantity_row(&row, n); n++)
      if (!(row.prefix && *row.prefix) && strncmp(row.name, of, strlen(of)) == 0) {
        if (nb_quantity_find(&quantity, &it.scene, row.name) != there)
          printf("# %s\n", row.name);
        CU_ASSERT_EQUAL(nb_quantity_find(&quantity, &it.scene, row.name), there);
        count++;
      }
    CU_ASSERT(count > 1);
    written_free(&it);
  }
}

void suite_scene(void) {
  CU_pSuite suite = CU_add_suite("scene", NULL, NULL);
  CU_add_test(suite, "a lattice is numbered from its lower left corner", lattice);
  CU_add_test(suite, "particles, their mass and inertia", particles);
  CU_add_test(suite, "walls and boxes", walls);
  CU_add_test(suite, "pairs of materials", pairs);
  CU_add_test(suite, "defaults", defaults);
  CU_add_test(suite, "quantities of an impact, a cell and a box", quantities_of_objects);
  CU_add_test(suite, "statements that change the hash of a stage", hash_of_a_stage);
  CU_add_test(suite, "what stages set, and what they inherit", stages);
  CU_ADD_TEST(suite, a_step_in_the_first_stage);
  CU_ADD_TEST(suite, runs_of_a_sweep);
  CU_add_test(suite, "stages after those of another page", stages_after_those_of_another_page);
  CU_ADD_TEST(suite, statements_of_another_page_have_the_line_of_start);
  CU_add_test(suite, "monitors whose names begin alike", monitors_whose_names_begin_alike);
}
