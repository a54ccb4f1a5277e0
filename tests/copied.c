/* A page that starts from a stage of another page: what its scene takes from the scene of that page.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../src/input/scene.h"
#include "suites.h"
#include "written.h"

/* Writes a page with these statements to a file, and reads a page that starts from it: `%s` in `starts` is the name of
 * the file. `end` is the end of this name. */
static void read_both(struct written *it, const char *first, const char *starts, const char *end,
                      nb_settings settings) {
  char path[64], without[64];
  snprintf(path, sizeof path, "/tmp/nineball-copied-XXXXXX%s.md", end);
  const int descriptor = mkstemps(path, (int)strlen(end) + 3);
  CU_ASSERT_FATAL(descriptor >= 0);
  FILE *file = fdopen(descriptor, "w");
  CU_ASSERT_PTR_NOT_NULL_FATAL(file);
  fprintf(file, "```scene\n%s\n```\n", first);
  fclose(file);
  snprintf(without, sizeof without, "%.*s", (int)(strlen(path) - strlen(".md")), path);
  struct words words = {0};
  words_add(&words, starts, *end ? path : without);
  written_scene_set(it, &words, settings);
  unlink(path);
}

/* The first page has all statements that are copied, and stages of which each differs from a new stage. */
static const char *const first = "units none\n"
                                 "material m density 1 kn 3 young 100 poisson 0.3 friction 0.5\n"
                                 "material n density 2 kn 5 young 200 poisson 0.2\n"
                                 "pair m n friction 0.1\n"
                                 "grading g 1 2 0.5 3\n"
                                 "normal linear\n"
                                 "shear linear\n"
                                 "damping ratio 0.1\n"
                                 "gravity 0 -1\n"
                                 "allow unstable\n"
                                 "box -9 -9 to 9 9 m\n"
                                 "transform translate 2 3\n"
                                 "sphere 0 0 radius 1 m velocity 1 2\n"
                                 "fill spheres box 2 2 to 8 8 g n seed 1 attempts 1000 else stop\n"
                                 "monitor D sphere 1\n"
                                 "record time D.x\n"
                                 "step 0.1\n"
                                 "stage s\n"
                                 "wall north velocity 0 0.1\n"
                                 "wall south velocity 0 0.1\n"
                                 "material m friction 0.2\n"
                                 "material n friction 0.2\n"
                                 "remove sphere 2\n"
                                 "remove sphere 3\n"
                                 "snapshot from s\n"
                                 "record every 3 cycles\n"
                                 "until D.x above -5 and time above 0.1 every 2 cycles at most 10 cycles\n"
                                 "stage t\n"
                                 "step 0.2\n"
                                 "damping mass 2\n"
                                 "servo isotropic 1 on box through box at most 1e-6 per cycle\n"
                                 "snapshot from s\n"
                                 "cycles 3\n"
                                 "stage u\n"
                                 "step 0.3\n"
                                 "cycles 4\n";

#define ONE "units none\nstart %s stage t\nrecord time\nstage one\ncycles 2\n"

/* True if a copy differs from the original only in its line, which is that of `start`. */
#define SAME(to, from, things, count)                                                                                  \
  do {                                                                                                                 \
    CU_ASSERT_EQUAL_FATAL((to)->count, (from)->count);                                                                 \
    CU_ASSERT((to)->count > 0);                                                                                        \
    for (size_t k = 0; k < (to)->count; k++) {                                                                         \
      CU_ASSERT_EQUAL((to)->things[k].line, start);                                                                    \
      (from)->things[k].line = start;                                                                                  \
    }                                                                                                                  \
    CU_ASSERT((to)->things != (from)->things);                                                                         \
    CU_ASSERT_EQUAL(memcmp((to)->things, (from)->things, (to)->count * sizeof *(to)->things), 0);                      \
  } while (0)

static void the_scene_has_that_of_the_other_page(void) {
  struct written it;
  read_both(&it, first, ONE, "", NULL);
  struct nb_scene *to = &it.scene, *from = to->start.scene;
  const int start = to->start.line;
  SAME(to, from, materials, material_count);
  SAME(to, from, pair_rules, pair_rule_count);
  SAME(to, from, particles, particle_count);
  SAME(to, from, walls, wall_count);
  SAME(to, from, fills, fill_count);
  CU_ASSERT_EQUAL_FATAL(to->grading_count, 1);
  CU_ASSERT_EQUAL(to->gradings[0].line, start);
  CU_ASSERT_EQUAL_FATAL(to->gradings[0].size_count, 2);
  CU_ASSERT_EQUAL(memcmp(to->gradings[0].sizes, from->gradings[0].sizes, 2 * sizeof *to->gradings[0].sizes), 0);
  CU_ASSERT_STRING_EQUAL(to->normal, "linear");
  CU_ASSERT_STRING_EQUAL(to->shear, "linear");
  CU_ASSERT(to->allow_unstable);
  CU_ASSERT_EQUAL(to->damping.contact, 0.1);
  CU_ASSERT_EQUAL(to->gravity.y, -1);
  CU_ASSERT_EQUAL(to->origin_x, 2);
  CU_ASSERT_EQUAL(to->origin_y, 3);
  CU_ASSERT_EQUAL(to->step.value, 0.1);
  /* monitors and columns are those of this page */
  CU_ASSERT_EQUAL(to->monitor_count, 0);
  CU_ASSERT_EQUAL(to->column_count, 1);
  written_free(&it);
}

static void its_stages_are_those_of_the_other_page(void) {
  struct written it;
  read_both(&it, first, ONE, "", NULL);
  const struct nb_scene *to = &it.scene;
  struct nb_scene *from = to->start.scene;
  const int start = to->start.line;
  CU_ASSERT_EQUAL(to->start.stages, 2);
  CU_ASSERT_EQUAL_FATAL(to->stage_count, 3);
  CU_ASSERT_EQUAL_FATAL(from->stage_count, 2);
  const struct nb_stage *s = &to->stages[0], *t = &to->stages[1], *one = &to->stages[2];
  SAME(s, &from->stages[0], motions, motion_count);
  SAME(s, &from->stages[0], changes, change_count);
  SAME(s, &from->stages[0], removals, removal_count);
  CU_ASSERT_EQUAL_FATAL(s->condition_count, 2);
  for (size_t k = 0; k < 2; k++) {
    CU_ASSERT_EQUAL(s->conditions[k].line, start);
    CU_ASSERT_EQUAL(s->conditions[k].quantity.monitor, -1);
    CU_ASSERT_EQUAL(from->stages[0].conditions[k].line,
                    from->stages[0].record_line + 1); /* `until` is below `record` */
  }
  CU_ASSERT_STRING_EQUAL(s->conditions[0].name, "D.x");
  CU_ASSERT_EQUAL(s->cycles, 10);
  CU_ASSERT_EQUAL(s->step.value, 0.1);
  CU_ASSERT_EQUAL(t->cycles, 3);
  CU_ASSERT_EQUAL(t->step.value, 0.2);
  CU_ASSERT_EQUAL(t->damping.global, 2);
  for (size_t k = 0; k < 2; k++) { /* they write no rows and no snapshots */
    CU_ASSERT_EQUAL(to->stages[k].record_interval, 0);
    CU_ASSERT(!to->stages[k].snapshot);
    CU_ASSERT_EQUAL(to->stages[k].snapshot_from, -1);
    CU_ASSERT_EQUAL(to->stages[k].line, start);
    CU_ASSERT_EQUAL(to->stages[k].step.line, start);
    CU_ASSERT_EQUAL(from->stages[k].record_interval, 0);
    CU_ASSERT(!from->stages[k].snapshot);
    CU_ASSERT_EQUAL(from->stages[k].snapshot_from, -1);
  }
  CU_ASSERT_EQUAL(from->column_count, 0);
  CU_ASSERT(t->servo.box && from->stages[1].servo.line > 0); /* the servo would read quantities of the other page */
  CU_ASSERT_EQUAL(t->servo.line, 0);
  CU_ASSERT_EQUAL(t->servo.every, 0);
  /* the stage of this page begins with the step and the damping of the stage before, and with its own output */
  CU_ASSERT_STRING_EQUAL(one->name, "one");
  CU_ASSERT_EQUAL(one->step.value, 0.2);
  CU_ASSERT_EQUAL(one->damping.global, 2);
  CU_ASSERT_EQUAL(one->record_interval, 1);
  CU_ASSERT_EQUAL(one->check_interval, 1);
  CU_ASSERT_EQUAL(one->snapshot_from, -1);
  CU_ASSERT_STRING_EQUAL(one->laws.normal, "");
  CU_ASSERT_STRING_EQUAL(one->laws.shear, "");
  written_free(&it);
}

/* `refine` divides the steps of this page only, those that it has taken over and its own. */
static void refine_is_of_this_page(void) {
  static const char *const refine[] = {"refine=2", NULL};
  static const char *const starts[] = {ONE,
                                       "start %s stage t\nrecord time\nstage one\nstep 0.2 of collision\ncycles 2\n"};
  for (int k = 0; k < 2; k++) {
    struct written it;
    read_both(&it, first, starts[k], "", refine);
    CU_ASSERT(it.scene.stages[1].step.value == 0.2 && it.scene.stages[1].cycles == 3);
    CU_ASSERT(it.scene.stages[2].step.value == 0.1 && it.scene.stages[2].cycles == 4);
    written_free(&it);
  }
}

/* Laws and steps that --set gives apply to the stages of this page only. */
static void settings_are_of_this_page(void) {
  static const char *const normal[] = {"normal=hertz", "shear=none", "step=0.05", NULL};
  struct written it;
  read_both(&it, first, ONE, "", normal);
  CU_ASSERT_STRING_EQUAL(it.scene.stages[2].laws.normal, "hertz");
  CU_ASSERT_STRING_EQUAL(it.scene.stages[2].laws.shear, "none");
  CU_ASSERT_EQUAL(it.scene.stages[2].step.value, 0.05);
  CU_ASSERT_STRING_EQUAL(it.scene.normal, "linear");
  CU_ASSERT_STRING_EQUAL(it.scene.shear, "linear");
  CU_ASSERT_EQUAL(it.scene.stages[1].step.value, 0.2);
  written_free(&it);
}

/* So does the memory of a shear law that stores pieces. */
static void memory_of_the_shear_law(void) {
  static const char *const more[] = {"shear=mindlin_deresiewicz memory 5", NULL};
  static const char spheres[] = "units none\nmaterial m density 1 young 100 poisson 0.3 friction 0.5\nnormal hertz\n"
                                "shear mindlin_deresiewicz memory 8\nsphere 0 0 radius 1 m\nstep 0.1\nrecord time\n"
                                "stage t\ncycles 3\n";
  for (int k = 0; k < 2; k++) {
    struct written it;
    read_both(&it, spheres, ONE, "", k ? more : NULL);
    CU_ASSERT_EQUAL(it.scene.pieces, 8);
    CU_ASSERT_EQUAL(it.scene.stages[1].laws.pieces, k ? 5 : 0);
    written_free(&it);
  }
}

/* The values after `with`, as --set takes them. The name of the other page may end in .md, also a short one. */
static void values_of_the_other_page(void) {
  static const struct {
    const char *end, *with, *settings[3];
  } rows[] = {{"", "", {NULL}},
              {"x", "with v=3 m/s", {"v=3 m/s"}},
              {"x", "with v=3 m/s w=4 n=5", {"v=3 m/s", "w=4", "n=5"}},
              {"x", "with w=4 with v=3 m/s", {"w=4", "v=3 m/s"}},
              {"x", "with w=(1+1) n=1", {"w=(2)", "n=1"}}}; /* a computed value is in parentheses */
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct written it;
    char starts[256];
    snprintf(starts, sizeof starts, "start %%s stage s %s\nrecord time\nstage one\ncycles 2\n", rows[k].with);
    read_both(&it,
              "let v = 1 m/s\nlet w = 1\nlet n = 1\nmaterial m density $w kg/m3 kn 1 N/m\n"
              "disc 0 m 0 m radius 1 m m velocity $v 0 m/s\nstep 1 us\nstage s\ncycles $n\n",
              starts, rows[k].end, NULL);
    size_t count = 0;
    for (; count < 3 && rows[k].settings[count]; count++) {
      CU_ASSERT_FATAL(count < it.scene.start.setting_count);
      if (strcmp(it.scene.start.settings[count], rows[k].settings[count]) != 0)
        printf("# %s\n", it.scene.start.settings[count]);
      CU_ASSERT_STRING_EQUAL(it.scene.start.settings[count], rows[k].settings[count]);
    }
    CU_ASSERT_EQUAL(it.scene.start.setting_count, count);
    written_free(&it);
  }
}

/* ---- the hash that identifies a saved state ---- */

static unsigned long long hash_of(const char *first_page, const char *starts) {
  struct written it;
  read_both(&it, first_page, starts, "y", NULL);
  const unsigned long long hash = it.scene.stages[it.scene.stage_count - 1].hash;
  written_free(&it);
  return hash;
}

#define HEAD "units none\nmaterial m density 1 kn 1\n"
#define TAIL "step 0.1\nstage a\ncycles 3\nstage b\ncycles 4\nstage c\ncycles 5\n"
#define DISC "disc 1 12 radius 1 m\n"
#define ON "units none\nstart %s stage b\nrecord time\nstage one\ncycles 2\n"

/* The hash depends on each word of the statements of this page and of those of the other page up to its stage. It does
 * not depend on statements that only record or advise, on comments and on spaces. */
static void hash_of_the_statements(void) {
  static const struct {
    const char *first_page, *starts;
    bool same;
  } rows[] = {
      {HEAD DISC "record time\n" TAIL, ON, true},
      {HEAD DISC "# comment\n" TAIL, ON, true},
      {HEAD "disc  1   12  radius 1 m # comment\n" TAIL, ON, true},
      {HEAD DISC TAIL "stage d\ncycles 6\n", ON, true},
      {HEAD "disc 11 2 radius 1 m\n" TAIL, ON, false},
      {HEAD "sphere 1 12 radius 1 m\n" TAIL, ON, false},
      {HEAD "disc 1 12 radius 2 m\n" TAIL, ON, false},
      {HEAD DISC "skin 0.1\n" TAIL, ON, false},
      {HEAD DISC "step 0.1\nstage a\ncycles 2\nstage b\ncycles 4\n", ON, false},
      {HEAD DISC "step 0.1\nstage a\ncycles 3\nstage b\ncycles 5\n", ON, false},
      {HEAD DISC TAIL, "units none\nstart %s stage a\nrecord time\nstage one\ncycles 2\n", false},
      {HEAD DISC TAIL, "units none\nstart %s stage b\nrecord time cycle\nstage one\nsnapshot\ncycles 2\n", true},
      {HEAD DISC TAIL, "units none\nstart %s stage b\nrecord time\nstage one\ncycles 3\n", false},
      {HEAD DISC TAIL, "units none\nstart %s stage b\nskin 0.1\nrecord time\nstage one\ncycles 2\n", false},
  };
  const unsigned long long hash = hash_of(HEAD DISC TAIL, ON);
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    const bool same = hash_of(rows[k].first_page, rows[k].starts) == hash;
    if (same != rows[k].same)
      printf("# %zu: %s, %s\n", k, rows[k].first_page, rows[k].starts);
    CU_ASSERT_EQUAL(same, rows[k].same);
  }
}

/* The hash depends on the particles of a packing, not only on the name of its file. */
static void hash_of_a_packing(void) {
  static const struct {
    const char *columns;
    bool same;
  } files[] = {{"x/-\ty/-\tradius/-\n1\t2\t3\n10\t2\t4\n", true},
               {"# comment\nx/-\tz/-\ty/-\tradius/-\n1\t9\t2\t3\n10\t9\t2\t4\n", true},
               {"x/-\ty/-\tradius/-\n1.5\t2\t3\n10\t2\t4\n", false},
               {"x/-\ty/-\tradius/-\n1\t2.5\t3\n10\t2\t4\n", false},
               {"x/-\ty/-\tradius/-\n1\t2\t3.5\n10\t2\t4\n", false},
               {"x/-\ty/-\tradius/-\n1\t2\t3\n10\t2\t4.5\n", false},
               {"x/-\ty/-\tradius/-\n10\t2\t4\n1\t2\t3\n", false}};
  char path[] = "/tmp/nineball-copied-XXXXXX";
  unsigned long long first_hash = 0;
  fclose(written_file(path));
  for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
    struct words page = {0};
    struct written it;
    FILE *file = fopen(path, "w");
    CU_ASSERT_PTR_NOT_NULL_FATAL(file);
    fputs(files[k].columns, file);
    fclose(file);
    words_add(&page, HEAD "packing %s discs m\nstep 0.1\nrecord time\nstage a\ncycles 3\n", path);
    written_scene(&it, &page);
    first_hash = k == 0 ? it.scene.stages[0].hash : first_hash;
    CU_ASSERT_EQUAL(it.scene.stages[0].hash == first_hash, files[k].same);
    written_free(&it);
  }
  unlink(path);
}

/* Only settings that override statements change the hash by themselves. */
static void hash_of_the_settings(void) {
  static const char *const counts[] = {"normal=a", "shear=a", "step=a", "damping=a", "refine=2", "soften=2"};
  static const char *const other[] = {"v=1", "normal_=a", "norma=a", "xstep=a"};
  const unsigned long long none = nb_hash_settings(NULL);
  CU_ASSERT_EQUAL(nb_hash_settings((const char *const[]){NULL}), none);
  for (size_t k = 0; k < sizeof counts / sizeof *counts; k++) {
    const unsigned long long one = nb_hash_settings((const char *const[]){counts[k], NULL});
    CU_ASSERT_NOT_EQUAL(one, none);
    CU_ASSERT_EQUAL(nb_hash_settings((const char *const[]){"v=1", counts[k], "w=1", NULL}), one);
    for (size_t l = 0; l < k; l++)
      CU_ASSERT_NOT_EQUAL(nb_hash_settings((const char *const[]){counts[l], NULL}), one);
  }
  CU_ASSERT_NOT_EQUAL(nb_hash_settings((const char *const[]){"step=1", NULL}),
                      nb_hash_settings((const char *const[]){"step=2", NULL}));
  for (size_t k = 0; k < sizeof other / sizeof *other; k++)
    CU_ASSERT_EQUAL(nb_hash_settings((const char *const[]){other[k], NULL}), none);
}

void suite_copied(void) {
  CU_pSuite suite = CU_add_suite("copied", NULL, NULL);
  CU_ADD_TEST(suite, the_scene_has_that_of_the_other_page);
  CU_ADD_TEST(suite, its_stages_are_those_of_the_other_page);
  CU_ADD_TEST(suite, settings_are_of_this_page);
  CU_ADD_TEST(suite, refine_is_of_this_page);
  CU_ADD_TEST(suite, memory_of_the_shear_law);
  CU_ADD_TEST(suite, values_of_the_other_page);
  CU_ADD_TEST(suite, hash_of_the_statements);
  CU_ADD_TEST(suite, hash_of_a_packing);
  CU_ADD_TEST(suite, hash_of_the_settings);
}
