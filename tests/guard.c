/* The guards that stop a run before particles pass through each other or through walls, just below and just above each
 * limit; and the warnings about a page and about the resolution of coordinates.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "../src/core/model.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

#define HEAD "units none\nmaterial m density 1 kn 1\nallow unstable\nstep 0.5\n"

/* Makes the model and runs `cycles` cycles of one stage. Returns the status; *done is the number of cycles made. The
 * counters of the stage differ from those of the run, as in a later stage. */
static enum nb_status outcome(struct nb_error *error, const char *statements, unsigned long cycles,
                              unsigned long *done) {
  struct words page = {0};
  struct written it;
  *error = (struct nb_error){0};
  words_add(&page, "%s\nstage s\ncycles 1\n", statements);
  written_scene(&it, &page);
  struct nb_model *model = nb_model_create(&it.scene, NULL, error);
  if (model) {
    nb_stage_begin(model, &it.scene.stages[0], error);
    model->stage_cycle += 4, model->stage_time -= 4 * model->step;
  }
  while (model && !error->status && model->cycle < cycles)
    nb_cycle(model, error);
  *done = model ? model->cycle : 0;
  nb_model_free(model);
  written_free(&it);
  return error->status;
}

static bool has(const struct nb_error *error, const char *words) {
  if (!strstr(error->text, words))
    printf("# `%s` is not in: %s\n", words, error->text);
  return strstr(error->text, words) != NULL;
}

/* Radii 2 and 1 at the distance 2: the overlap is the smaller radius, 1, which is just allowed. The discs are in either
 * order, or one of them is an image in a cell. In the third case both radii and the distance are 1, and one disc is
 * fixed. */
static void overlap_at_the_start(void) {
  static const struct {
    const char *below, *above;
  } cases[] = {
      {"disc 0 0 radius 2 m\ndisc 2 0 radius 1 m", "disc 0 0 radius 2 m\ndisc 1.9999999999999996 0 radius 1 m"},
      {"disc 0 0 radius 1 m\ndisc 0 2 radius 2 m", "disc 0 0 radius 1 m\ndisc 0 1.9999999999999996 radius 2 m"},
      {"disc 0 0 radius 1 m fixed\ndisc 0 1 radius 1 m",
       "disc 0 0 radius 1 m fixed\ndisc 0 0.9999999999999998 radius 1 m"},
      {"periodic cell -8 -8 to 8 8\ndisc 7 0 radius 2 m\ndisc -7 0 radius 1 m",
       "periodic cell -8 -8 to 8 8\ndisc 7 0 radius 2 m\ndisc -7.000000000000002 0 radius 1 m"},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    char text[512];
    struct nb_error error;
    unsigned long done;
    snprintf(text, sizeof text, HEAD "%s", cases[k].below);
    CU_ASSERT_EQUAL(outcome(&error, text, 0, &done), NB_OK);
    snprintf(text, sizeof text, HEAD "%s", cases[k].above);
    CU_ASSERT_EQUAL(outcome(&error, text, 0, &done), NB_BAD_USE);
    CU_ASSERT(has(&error, k == 3 ? "particle 2 overlaps particle 1 (line 7) by 1"
                                 : "particle 2 overlaps particle 1 (line 6) by 1"));
    CU_ASSERT_EQUAL(error.line, k == 3 ? 8 : 7);
    CU_ASSERT(has(&error, "smaller radius, 1:"));
  }
  struct nb_error error;
  unsigned long done;
  /* Two fixed particles form no contact. */
  CU_ASSERT_EQUAL(
      outcome(&error, HEAD "disc 0 0 radius 1 m fixed\ndisc 0 0 radius 1 m fixed\ndisc 9 9 radius 1 m", 1, &done),
      NB_OK);
}

/* A search that finds n coincident particles names the first two and lists none of their n^2/2 pairs. */
static void coincident_particles(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, HEAD "lattice discs 100 by 5 from 1 1 radius 1 spacing 4 m\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, &(struct nb_options){.threads = 1, .shuffle = true});
  for (size_t i = 0; i < model->particles.count; i++)
    if (model->particles.number[i] != 1)
      model->particles.position[i] = vec(7, 9);
  CU_ASSERT_EQUAL(nb_neighbours_search(model, &error), NB_BAD_USE);
  CU_ASSERT(has(&error, "particle 3 overlaps particle 2 (line 6) by 2. Expected at most the smaller radius, 1:"));
  CU_ASSERT_EQUAL(model->contacts.count, 0);
  model->cycle = 7;
  CU_ASSERT_EQUAL(nb_neighbours_search(model, &error), NB_BROKEN);
  CU_ASSERT(has(&error, "particle 2 (line 6) and particle 3 (line 6): at cycle 7, time 0, they overlap by 2."));
  CU_ASSERT_EQUAL(error.line, 0); /* not the line of the error before */
  nb_model_free(model);
  written_free(&it);
}

/* The first particle, in the order of the numbers, whose position is NaN or infinite is named. */
static void positions_that_are_not_finite(void) {
  static const struct nb_vec bad[] = {{NAN, 0}, {0, NAN}, {INFINITY, 0}, {0, -INFINITY}};
  struct words page = {0};
  struct written it;
  struct nb_error error;
  words_add(&page, HEAD "disc 1 1 radius 1 m\ndisc 5 1 radius 1 m\ndisc 9 1 radius 1 m\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, &(struct nb_options){.threads = 1, .shuffle = true});
  CU_ASSERT_EQUAL(nb_guard_positions(model, &error), NB_OK);
  model->cycle = 7, model->stage_cycle = 3, model->time = 3.5, model->stage_time = 2, model->critical = 0.75;
  model->step = 0.25, model->previous_step = 0.5;
  for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
    model->particles.position[model->particles.slot[1]] = bad[k];
    model->particles.position[model->particles.slot[2]] = vec(NAN, 0);
    CU_ASSERT_EQUAL(nb_guard_positions(model, &error), NB_BROKEN);
    CU_ASSERT_STRING_EQUAL(error.text, "particle 2 (line 7): its position is NaN or infinite after cycle 7, at time "
                                       "3.5; the step is 0.25, the single-contact step is 0.75: try a smaller step");
  }
  nb_model_free(model);
  written_free(&it);
}

/* With the radius 1 and the step 1/2 the limit is 2 m/s, in any direction, also for fixed particles and with any
 * skin. */
static void displacement_in_a_step(void) {
  static const struct {
    const char *statements;
    bool broken;
  } cases[] = {
      {"disc 0 0 radius 1 m velocity 2 0\ndisc 90 0 radius 3 m", false},
      {"disc 0 0 radius 1 m velocity 0 -2.0000000000000004\ndisc 90 0 radius 3 m", true},
      {"disc 0 0 radius 1 m velocity 1.2 1.6\ndisc 90 0 radius 1 m", false},
      {"disc 0 0 radius 1 m velocity 1.3 1.6\ndisc 90 0 radius 1 m", true},
      {"disc 0 0 radius 1 m fixed velocity 2.1 0\ndisc 90 0 radius 1 m", true},
      {"skin 30\ndisc 0 0 radius 1 m velocity 2 0\ndisc 90 0 radius 3 m", false},
      {"skin 30\ndisc 0 0 radius 1 m velocity 2.1 0\ndisc 90 0 radius 3 m", true},
      {"skin 1\ndisc 0 0 radius 1 m velocity 2.1 0\ndisc 90 0 radius 3 m", true},
      {"disc 0 0 radius 1 m velocity 99 0", false}, /* alone: there is nothing to pass through */
      {"disc 0 0 radius 1 m velocity 99 0 fixed\ndisc 9 0 radius 1 m fixed", false},
      {"periodic cell -8 -8 to 8 8\ndisc 0 0 radius 1 m velocity 1.9 0\ndisc 4 4 radius 1 m", false},
      {"periodic cell -8 -8 to 8 8\ndisc 0 0 radius 1 m velocity 2.1 0\ndisc 4 4 radius 1 m", true},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    char text[512];
    struct nb_error error;
    unsigned long done;
    snprintf(text, sizeof text, HEAD "%s", cases[k].statements);
    const enum nb_status status = outcome(&error, text, 2, &done);
    CU_ASSERT_EQUAL(status, cases[k].broken ? NB_BROKEN : NB_OK);
    if ((status == NB_BROKEN) != cases[k].broken)
      printf("# %s: %s\n", cases[k].statements, error.text);
    CU_ASSERT_EQUAL(done, cases[k].broken ? 1 : 2);
    CU_ASSERT(!cases[k].broken || has(&error, "in cycle 1, at time 0.5, it moved by 1"));
    CU_ASSERT(!cases[k].broken || has(&error, "its radius, 1:"));
  }
  /* Of several particles the first that moves too far is named. */
  struct nb_error error;
  unsigned long done;
  CU_ASSERT_EQUAL(outcome(&error,
                          HEAD "disc 9 0 radius 1 m\ndisc 90 0 radius 1 m velocity 2.2 0\n"
                               "disc 0 90 radius 1 m velocity 0 2.4\ndisc 0 9 radius 1 m",
                          2, &done),
                  NB_BROKEN);
  CU_ASSERT(has(&error, "particle 2 (line 7): in cycle 1, at time 0.5, it moved by 1.1 in one step of 0.5."));
}

/* A strained cell moves images far from its centre by more than a radius in a step. This is allowed, because all images
 * move together. */
static void imposed_by_a_cell(void) {
  struct nb_error error;
  unsigned long done;
  struct words page = {0};
  struct written it;
  words_add(&page,
            HEAD "periodic cell -8 -8 to 8 8\ndisc 160 160 radius 1 m\ndisc 4 4 radius 1 m\nstage s\ncell strain -0.1 "
                 "-0.1\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  CU_ASSERT_EQUAL(nb_cycle(model, &error), NB_OK);
  done = model->cycle;
  CU_ASSERT(done == 1 && fabs(model->particles.position[0].x - 152) < 1e-12); /* moved by 8 in one step */
  nb_model_free(model);
  written_free(&it);
}

/* The limit of the rotation in a step is angle^2 h = 8 r, with the smallest radius r = 0.5. h is the distance of
 * the wall's line from the pivot plus the distance along the line to the farther end, but at least r. */
static void rotation_in_a_step(void) {
  static const struct {
    const char *wall;
    double h;
  } walls[] = {{"-3 0 to 1 0 m about 0 0", 3},
               {"-1 0 to 4 0 m about 0 0", 4},
               {"-1 2 to 3 2 m about 0 0", 5},
               {"-1 -2 to 3 -2 m about 0 0", 5},
               {"-0.1 0 to 0.1 0 m about 0 0", 0.5}};
  for (size_t k = 0; k < sizeof walls / sizeof *walls; k++)
    for (int sign = -1; sign < 2; sign += 2) {
      struct words page = {0};
      struct written it;
      words_add(&page, HEAD "disc 90 0 radius 3 m\ndisc 80 0 radius 0.5 m\nwall w %s\nstage s\ncycles 1\n",
                walls[k].wall);
      written_scene(&it, &page);
      struct nb_model *model = written_model(&it, NULL);
      const double limit = sign * sqrt(8 * 0.5 / walls[k].h);
      CU_ASSERT_FALSE(nb_rotates_too_far(model, 0, limit * (1 - 1e-12)));
      CU_ASSERT(nb_rotates_too_far(model, 0, limit * (1 + 1e-12)));
      nb_model_free(model);
      written_free(&it);
    }
  struct nb_error error;
  unsigned long done;
#define BLADE HEAD "disc 90 0 radius 3 m\ndisc 80 0 radius 0.5 m\nwall blade -2 0 to 2 0 m spin "
  CU_ASSERT_EQUAL(outcome(&error, BLADE "-2.828", 2, &done), NB_OK); /* 2^(1/2) rad in a step of 1/2 */
  CU_ASSERT_EQUAL(outcome(&error, BLADE "-2.829", 2, &done), NB_BROKEN);
  CU_ASSERT(
      has(&error, "wall `blade` (line 8): in cycle 1, at time 0.5, it turned by -1.4145 rad in one step of 0.5 and"));
  CU_ASSERT(has(&error, "smallest radius, 0.5:"));
  CU_ASSERT_EQUAL(outcome(&error, BLADE "25.132741228718345", 2, &done), NB_BROKEN); /* two revolutions in a step */
  CU_ASSERT_EQUAL(outcome(&error, HEAD "disc 90 0 radius 3 m fixed\nwall w -2 0 to 2 0 m spin 99", 2, &done), NB_OK);
  /* Of several walls the first that turns too far is named. */
  CU_ASSERT_EQUAL(outcome(&error,
                          HEAD
                          "disc 90 0 radius 3 m\ndisc 80 0 radius 0.5 m\nwall rest -2 9 to 2 9 m\n"
                          "wall blade -2 0 to 2 0 m spin 3\nwall fan -2 40 to 2 40 m spin 4\nwall v 0 60 to 2 60 m",
                          2, &done),
                  NB_BROKEN);
  CU_ASSERT(has(&error, "wall `blade` (line 9): in cycle 1, at time 0.5, it turned by 1.5 rad"));
}

/* In a step of 1/2 a wall may move by 1e9 times the smallest radius, 1/2, so its speed is at most 1e9. It moves along
 * itself, so that it does not pass through the discs. Of several walls the first that moves too far is named. */
static void translation_of_walls(void) {
  struct nb_error error;
  unsigned long done;
#define WALL HEAD "disc 90 0 radius 3 m\ndisc 80 0 radius 0.5 m\nwall rest -2 9 to 2 9 m\n"
  CU_ASSERT_EQUAL(outcome(&error, WALL "wall w -2 0 to 2 0 m velocity -1e9 0", 2, &done), NB_OK);
  CU_ASSERT_EQUAL(outcome(&error, WALL "wall w -2 0 to 2 0 m velocity -1.0000001e9 0", 2, &done), NB_BROKEN);
  CU_ASSERT_EQUAL(outcome(&error, WALL "wall w -3 -4 to 3 4 m velocity 5.99e8 7.99e8", 2, &done), NB_OK);
  CU_ASSERT_EQUAL(outcome(&error,
                          WALL "wall w -3 -4 to 3 4 m velocity 12e8 16e8\nwall v -2 -9 to 2 -9 m velocity 3e9 0\n"
                               "wall still -2 -20 to 2 -20 m",
                          2, &done),
                  NB_BROKEN);
  CU_ASSERT_EQUAL(done, 1);
  CU_ASSERT(
      has(&error, "wall `w` (line 9): in cycle 1, at time 0.5, it moved by 1e+09 in one step of 0.5 and may have"));
  CU_ASSERT(has(&error, "The limit is 1e+09 times the smallest radius, 0.5. Try"));
}

/* In a step of 1/2 a cell may be strained by 1/2, so the root of the sum of the squares of its strain rates is at most
 * 1. A cell with one disc of radius 1, free or fixed, is at least 2 (2 + skin) wide, and the skin is a tenth of the
 * radius; a cell that shrinks by 0.1 in each step, from 8.4, reaches 4.1 in step 7: 8.4*0.9^7 = 4.02. */
static void strain_of_a_cell(void) {
  static const struct {
    const char *cell, *strain;
    unsigned long cycles; /* without an error; 9: all */
  } cases[] = {{"16 16", "1 0", 9},        {"16 16", "-1 0", 9},           {"16 16", "0 -1.000001", 0},
               {"16 16", "1.000001 0", 0}, {"16 16", "0.6 0 c12 0.79", 9}, {"16 16", "0.6 0 c12 -0.81", 0},
               {"16 16", "-0.7 -0.72", 0}, {"16 4.21", "0 0", 9},          {"16 8.4", "0 -0.2", 6}};
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
    for (int fixed = 0; fixed < 2; fixed++) {
      char text[512];
      struct nb_error error;
      unsigned long done;
      snprintf(text, sizeof text,
               HEAD "periodic cell 0 0 to %s\ndisc 3 2 radius 1 m%s\nstage a\ncell strain %s\ncycles 1", cases[k].cell,
               fixed ? " fixed" : "", cases[k].strain);
      const unsigned long most = cases[k].cycles == 9 ? 1 : 8;
      CU_ASSERT_EQUAL(outcome(&error, text, most, &done), cases[k].cycles == 9 ? NB_OK : NB_BROKEN);
      CU_ASSERT_EQUAL(done, cases[k].cycles == 9 ? 1 : cases[k].cycles + 1);
      if (cases[k].cycles == 0)
        CU_ASSERT(has(&error, "the periodic cell (line 6): in cycle 1, at time 0.5, it was strained by 50"));
      if (cases[k].cycles == 6)
        CU_ASSERT(has(&error, "at cycle 7, at time 3.5"));
    }
  struct nb_error error;
  unsigned long done;
  CU_ASSERT_EQUAL(outcome(&error, HEAD "periodic cell 0 0 to 16 4.19\ndisc 3 2 radius 1 m", 0, &done), NB_BAD_USE);
  CU_ASSERT(has(&error, "the cell is 4.19 wide at cycle 0"));
}

/* A fixed disc moves by 1/16 in each step into a disc too heavy to move: the overlap is the smaller radius after 16
 * cycles and exceeds it after 17. With a wide skin this happens between two searches. */
static void overlap_during_the_run(void) {
  static const char *const skins[] = {"", "skin 0.01\n", "skin 0.9\n", "skin 1\n", "skin 7\n"};
  for (size_t k = 0; k < 2 * (sizeof skins / sizeof *skins); k++) {
    const int radius = 1 + (int)k % 2; /* of the heavy disc */
    char text[512];
    struct nb_error error;
    unsigned long done;
    snprintf(text, sizeof text,
             HEAD "material heavy density 1e30 kn 1\n%sdisc 0 0 radius 1 m fixed velocity 0.125 0\ndisc %d 0 radius %d "
                  "heavy\ndisc 2 40 radius 1 m\ndisc 4 40 radius 1 m",
             skins[k / 2], 1 + radius, radius);
    CU_ASSERT_EQUAL(outcome(&error, text, 16, &done), NB_OK);
    CU_ASSERT_EQUAL(outcome(&error, text, 99, &done), NB_BROKEN);
    CU_ASSERT_EQUAL(done, 17);
    CU_ASSERT(has(&error, "and particle 2 (line "));
    CU_ASSERT(has(&error, "at cycle 17, time 8.5, they overlap by 1.0625. The limit is the smaller radius, 1:"));
  }
}

/* All warnings of the scene and of the model of this page, in one text. */
static const char *warned(char text[2000], const char *statements) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\n%s\n%sstage s\ncycles 1\n", statements,
            strstr(statements, "\nstep ") ? "" : "step 1e-6\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  text[0] = 0;
  for (int of_model = 0; of_model < 2; of_model++) {
    const struct nb_warnings *warnings = of_model ? &model->warnings : &it.scene.warnings;
    for (size_t k = 0; k < warnings->count; k++)
      snprintf(text + strlen(text), 2000 - strlen(text), "%d: %s\n", warnings->list[k].line, warnings->list[k].text);
  }
  nb_model_free(model);
  written_free(&it);
  return text;
}

/* The warnings of the statements begin with `wanted`; "": there is none. */
static void begins(const char *statements, const char *wanted) {
  char text[2000];
  warned(text, statements);
  const bool as_wanted = *wanted ? strncmp(text, wanted, strlen(wanted)) == 0 : !*text;
  if (!as_wanted)
    printf("# %s\n# said: %s\n", statements, text);
  CU_ASSERT(as_wanted);
}

/* Statements and a part of the only warning that they cause; NULL: there is none. */
struct warning_case {
  const char *statements, *wanted;
};

static void warns_once(const struct warning_case *it) {
  char text[2000];
  warned(text, it->statements);
  const bool as_wanted = it->wanted ? strstr(text, it->wanted) && strchr(text, '\n')[1] == 0 : !text[0];
  if (!as_wanted)
    printf("# %s: %s\n", it->statements, text);
  CU_ASSERT(as_wanted);
}

static void friction_without_effect(void) {
  static const struct warning_case cases[] = {
      {"material m density 1 kn 1 friction 0.5\ndisc 0 0 radius 1 m\ndisc 3 0 radius 1 m",
       "3: friction between `m` and `m` has no effect: there is no `shear` law"},
      {"material m density 1 kn 1 friction 0\ndisc 0 0 radius 1 m\ndisc 3 0 radius 1 m", NULL},
      {"material m density 1 kn 1 friction 0.5\ndisc 0 0 radius 1 m", NULL}, /* alone */
      {"material m density 1 kn 1 friction 0.5\ndisc 0 0 radius 1 m\nwall w -9 -9 to 9 -9 m",
       "3: friction between `m` and `m`"},
      {"material m density 1 kn 1 ks 1 friction 0.5\nshear linear\ndisc 0 0 radius 1 m\ndisc 3 0 radius 1 m", NULL},
      {"material m density 1 kn 1 ks 0 friction 0.5\nshear linear\ndisc 0 0 radius 1 m\ndisc 3 0 radius 1 m",
       "has no effect: their shear stiffness `ks` is 0"},
      {"material m density 1 kn 1 ks 1 friction 0.5\ndisc 0 0 radius 1 m\ndisc 3 0 radius 1 m",
       "3: friction between `m` and `m` has no effect: there is no `shear` law"},
      {"material m density 1 kn 1 ks 1 friction 0.5\nshear linear\nmaterial n density 1 kn 1 friction 0.5\n"
       "disc 0 0 radius 1 m\ndisc 3 0 radius 1 m\ndisc 6 0 radius 1 n",
       "3: friction between `m` and `n` has no effect: their shear stiffness `ks` is 0\n"}, /* harmonic mean of 1 and 0 */
      {"material m density 1 kn 1\nmaterial n density 1 kn 1\npair n m friction 0.5\ndisc 0 0 radius 1 m\n"
       "wall w -9 -9 to 9 -9 n",
       "5: friction between `m` and `n`"},
      {"material m density 1 kn 1 friction 0.5\nmaterial n density 1 kn 1 friction 0.5\ndisc 0 0 radius 1 n\n"
       "wall w -9 -9 to 9 -9 m",
       "4: friction between `n` and `m`"},
      {"material m density 1 kn 1\nmaterial n density 1 kn 1\npair m m friction 0\npair m n friction 0.5\n"
       "disc 0 0 radius 1 m\ndisc 3 0 radius 1 m\ndisc 6 0 radius 1 n",
       "6: friction between `m` and `n`"},
      {"material m density 1 kn 1\nmaterial n density 1 kn 1\nmaterial k density 1 kn 1\npair k n friction 0\n"
       "pair m n friction 0.5\ndisc 0 0 radius 1 m\ndisc 3 0 radius 1 n",
       "7: friction between `m` and `n`"},
      {"material m density 1 kn 1\nmaterial n density 1 kn 1\nmaterial k density 1 kn 1\npair n k friction 0\n"
       "pair n m friction 0.5\ndisc 0 0 radius 1 m\ndisc 3 0 radius 1 n",
       "7: friction between `m` and `n`"},
      {"material m density 1 kn 1 friction 0.5\ndisc 0 0 radius 1 m\ndisc 3 0 radius 1 m\nstep 1e-7\nstage a\n"
       "material m friction 0\ncycles 1", /* never used */
       "3: friction between `m` and `m`"},
      {"material m density 1 kn 1\nmaterial n density 1 kn 1 friction 0.5\ndisc 0 0 radius 1 m\n"
       "wall v -9 -9 to 9 -9 n\nwall w -9 9 to 9 9 n", /* walls do not touch walls */
       NULL},
      {"material m density 1 kn 1\npair m m friction 0.5\ndisc 0 0 radius 1 m\ndisc 3 0 radius 1 m",
       "4: friction between"},
      {"material m density 1 young 1 poisson 0.3 friction 0.5\nnormal hertz\nshear mindlin\nsphere 0 0 radius 1 "
       "m\nsphere 3 0 radius 1 m",
       NULL},
      {"material m density 1 kn 1 friction 0.5\nmaterial n density 1 kn 1\ndisc 0 0 radius 1 m\ndisc 3 0 radius 1 n",
       NULL}, /* the smaller friction, 0, counts */
      {"material m density 1 kn 1 friction 0.5\ndisc 0 0 radius 1 m\ndisc 3 0 radius 1 m\nstep 1e-7\nstage a\nmaterial "
       "m ks 1\nshear linear\ncycles 1",
       NULL},
      {"material m density 1 kn 1 ks 1\ndisc 0 0 radius 1 m\ndisc 3 0 radius 1 m\nstep 1e-7\nstage a\nshear linear\n"
       "cycles 1\nstage b\ncycles 1\nstage c\nmaterial m friction 0.5\ncycles 1", /* the law of `a` stays */
       NULL},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
    warns_once(&cases[k]);
}

/* Contacts without a normal stiffness: particles pass through each other. */
static void contacts_without_force(void) {
  static const struct warning_case cases[] = {
      {"material m density 1 young 1 poisson 0.3\ndisc 0 0 radius 1 m\nwall w -9 -9 to 9 -9 m",
       "3: contacts between `m` and `m` have no force, because their normal stiffness `kn` is 0; `young` is for "
       "`normal hertz`\n"},
      {"material m density 1 young 1 poisson 0.3\nnormal hertz\nsphere 0 0 radius 1 m\nsphere 3 0 radius 1 m", NULL},
      {"material m density 1\ndisc 0 0 radius 1 m", NULL}, /* alone */
      {"material m density 1 kn 1\nmaterial n density 1\npair m n kn 2\ndisc 0 0 radius 1 m\ndisc 3 0 radius 1 n "
       "fixed\ndisc 6 0 radius 1 n fixed\nwall w -9 -9 to 9 -9 n",
       NULL}, /* fixed particles touch neither each other nor walls */
      {"material m density 1\ndisc 0 0 radius 1 m\nwall w -9 -9 to 9 -9 m",
       "3: contacts between `m` and `m` have no force, because their normal stiffness `kn` is 0\n"},
      {"material m density 1 kn 1\nmaterial n density 1\ndisc 0 0 radius 1 m\ndisc 3 0 radius 1 m\nwall w -9 -9 to 9 "
       "-9 n",
       "3: contacts between `m` and `n` have no force"},
      {"material m density 1 kn 1\nmaterial n density 1\npair n m kn 2\ndisc 0 0 radius 1 m\nwall w -9 -9 to 9 -9 n",
       NULL},
      {"material m density 1\ndisc 0 0 radius 1 m\ndisc 3 0 radius 1 m\nstep 1e-7\nstage a\nmaterial m kn 1\ncycles 1",
       NULL}, /* it has a stiffness later */
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
    warns_once(&cases[k]);
}

/* An overlap above 7 % of the smaller diameter at the start. The warning has the line of the particle with the larger
 * number, and names the deepest contact. */
static void overlaps_at_the_start_above_the_limit(void) {
#define TOO_MUCH                                                                                                       \
  "diameter; above 7 % real particles deform plastically, and the force may be very large: move the particle away, "   \
  "or "                                                                                                                \
  "make it smaller\n"
  static const struct warning_case cases[] = {
      {"material m density 1 kn 1\ndisc 0 0 radius 1 m\ndisc 2.7 0 radius 2 m",
       "5: particle 2 overlaps particle 1 (line 4) too much at the start: by 0.3, 15 % of the smaller " TOO_MUCH},
      {"material m density 1 kn 1\ndisc 0 0 radius 2 m\ndisc 2.7 0 radius 1 m",
       "5: particle 2 overlaps particle 1 (line 4) too much at the start: by 0.3, 15 % of the smaller " TOO_MUCH},
      {"material m density 1 kn 1\ndisc 9 9 radius 1 m\ndisc 0 1.4 radius 2 m\nwall w -9 0 to 9 0 m",
       "5: particle 2 overlaps wall `w` (line 6) too much at the start: by 0.6, 15 % of the " TOO_MUCH},
      /* the deepest of three by the ratio, not the first, the last or the longest overlap */
      {"material m density 1 kn 1\ndisc 0 0 radius 1 m\ndisc 1.7 0 radius 1 m\ndisc 3 0 radius 0.5 m\n"
       "disc 4.4 0 radius 1 m",
       "6: particle 3 overlaps particle 2 (line 5) too much at the start: by 0.2, 20 % of the smaller " TOO_MUCH},
      /* the first of two equal ones; elastic laws count deep contacts instead */
      {"material m density 1 kn 1\ndisc 0 0 radius 1 m\ndisc 1.5 0 radius 1 m\ndisc 3 0 radius 1 m",
       "5: particle 2 overlaps particle 1 (line 4) too much at the start: by 0.5, 25 % of the smaller " TOO_MUCH},
      {"material m density 1 young 1 poisson 0\nnormal hertz\nsphere 0 0 radius 1 m\nsphere 1.5 0 radius 1 m", NULL},
      {"material m density 1 kn 1\ndisc 0 0 radius 1 m\ndisc 2.861 0 radius 2 m", NULL},
      {"material m density 1 kn 1\ndisc 0 0 radius 1 m\ndisc 2.859 0 radius 2 m", "by 0.141, 7"},
  };
#undef TOO_MUCH
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
    warns_once(&cases[k]);
}

/* Some conditions are always or never met, except with a law of the user's own that has tensile forces. They are allowed
 * and cause a warning. */
static void conditions_on_tensile_forces(void) {
  static const struct {
    const char *condition, *wanted;
  } cases[] = {
      {"C.normal below 0", "9: `C.normal below 0` never holds, unless the contact law is one of your own with tensile "
                           "forces: `C.normal` is 0 or more with all laws of nineball\n"},
      {"C.normal above -1",
       "9: `C.normal above -1` always holds, unless the contact law is one of your own with tensile "
       "forces: `C.normal` is 0 or more with all laws of nineball\n"},
      {"C.normal above 0", ""},
      {"C.normal below 1e-9", ""},
      {"C.dashpot.normal below 0", ""},
      {"C.shear below 0", ""},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    char text[2000], statements[256];
    snprintf(statements, sizeof statements,
             "material m density 1 kn 1\ndisc 0 0 radius 1 m\ndisc 3 0 radius 1 m\nmonitor C disc 1 with disc 2\nstep "
             "1e-6\nstage a\nuntil %s  at most 9 cycles",
             cases[k].condition);
    if (strcmp(warned(text, statements), cases[k].wanted) != 0)
      printf("# %s: %s\n", cases[k].condition, text);
    CU_ASSERT_STRING_EQUAL(text, cases[k].wanted);
  }
}

/* With friction at the walls the stress of a box is not the traction of its walls. A stage whose servo controls one of
 * them and whose condition is on the other gets a warning, which has the line of the condition. */
static void conditions_on_another_stress_than_the_servo(void) {
  static const struct {
    const char *friction, *shear, *later, *on, *condition, *wanted; /* the first words of the warning */
  } cases[] = {
      {"0.5", "linear", "", "walls", "box.stress.mean",
       "11: the servo of stage `a` controls `walls.stress`, and this "
       "condition is on `box.stress.mean`"},
      {"0.5", "linear", "", "box", "walls.stress.xx",
       "11: the servo of stage `a` controls `box.stress`, and this "
       "condition is on `walls.stress.xx`"},
      {"0", "linear", "material m friction 0.5\n", "walls", "box.stress.mean", "12: the servo of stage `a` controls"},
      {"0.5", "linear", "", "walls", "walls.stress.mean", ""},
      {"0.5", "linear", "", "box", "box.stress.mean", ""},
      {"0", "linear", "", "walls", "box.stress.mean", ""},
      {"0.5", "linear", "", "walls", "box.width", ""},
      {"0.5", "linear", "", "M", "box.stress.xx", ""},
      {"0.5", "linear", "", "M", "walls.stress.xx", ""},
      {"0.5", "linear", "", "walls", "M.stress.xx",
       "11: the servo of stage `a` controls `walls.stress`, and this condition is on `M.stress.xx`: with friction at "
       "the "
       "walls the two differ, and the condition may never hold; write `on M` in the servo\n"},
      {"0.5", "linear", "", "box", "M.stress.xx", ""},
      {"0.5", "linear", "shear none\n", "walls", "box.stress.xx", ""},
      {"0.5", "linear", "boundary circle 1 1 radius 0.5\n", "boundary through boundary", "walls.stress.xx", ""},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    char statements[512];
    snprintf(statements, sizeof statements,
             "material m density 1 kn 1 ks 1 friction %s\nshear %s\nbox 0 0 to 2 2 m\ndisc 1 1 radius 1 m\nregion M "
             "all\nstep 1e-6\nstage a\n%sservo isotropic 1 on %s%s at most 1\nuntil %s above 0.5 at most 9 "
             "cycles",
             cases[k].friction, cases[k].shear, cases[k].later, cases[k].on,
             strchr(cases[k].on, ' ') ? "" : " through box", cases[k].condition);
    begins(statements, cases[k].wanted);
  }
}

/* A statement below `cycles` or `until` acts when its stage begins, which causes a warning. */
static void changes_below_the_end_of_a_stage(void) {
  static const char expected[] =
      "` stands below the `cycles` or `until` of stage `a`, but acts when this stage begins: for a change at "
      "the end, begin a new stage above this line; for a change at the beginning, move this line above them\n";
  static const char cell[] = "periodic cell 0 0 to 9 9", box[] = "box 0 0 to 9 9 m",
                    ring[] = "boundary circle 0 0 radius 1";
  static const struct {
    const char *scene, *change;
  } cases[] = {
      {cell, "remove disc 1"}, {cell, "zero velocities"}, {cell, "reverse velocities"},
      {cell, "rotation off"},  {cell, "material m kn 2"}, {cell, "pair m m kn 2"},
      {cell, "gravity 0 -1"},  {cell, "cell strain 1 1"}, {cell, "normal linear"},
      {cell, "shear none"},    {cell, "damping mass 1"},  {box, "box strain 1 1"},
      {box, "walls inward 1"}, {ring, "boundary fixed"},  {box, "wall north velocity 0 -1"},
      {ring, "affine none"},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
    for (int below = 0; below < 3; below++) {
      const char *const change = cases[k].change, *const end =
                                                      below == 1 ? "until time above 1 at most 3 cycles" : "cycles 1";
      char text[2000], statements[500], wanted[300] = "";
      snprintf(statements, sizeof statements,
               "material m density 1 kn 1 friction 0.5\nshear none\n%s\ndisc 1 1 radius 1 m\nstep "
               "1e-6\nrecord time\nstage a\n%s\nrecord none\n%s\nstage b\ncycles 1",
               cases[k].scene, below ? end : change, below ? change : end);
      warned(text, statements);
      if (below)
        snprintf(wanted, sizeof wanted, "12: `%.*s%s", (int)strcspn(change, " "), change, expected);
      const bool as_wanted = below ? strstr(text, wanted) != NULL : strstr(text, "stands below") == NULL;
      if (!as_wanted)
        printf("# %s: %s\n", change, text);
      CU_ASSERT(as_wanted);
    }
}

/* A servo ends with its stage. A strain rate that was given beside it and goes on without it causes a warning. */
static void strain_rates_without_their_servo(void) {
  static const char box[] = "box 0 0 to 9 9 m", cell[] = "periodic cell 0 0 to 9 9",
                    ring[] = "boundary circle 0 0 radius 1";
  static const char beside[] = "boundary strain 1 -1\nservo mean 1 on boundary through boundary at most 1";
  static const struct {
    const char *scene, *first, *second, *third, *wanted;
  } cases[] = {
      {ring, "", beside, "",
       "14: the servo of stage `b` ended with it, and the `boundary strain` of stage `b` goes on in stage `c`: write a "
       "`servo` in this stage, or, if the stress is to be free, the `boundary strain` once more\n"},
      {ring, beside, "", "",
       "11: the servo of stage `a` ended with it, and the `boundary strain` of stage `a` goes on"},
      {ring, beside, "servo mean 1 on boundary through boundary at most 1", "",
       "14: the servo of stage `b` ended with it, and the `boundary strain` of stage `a` goes on in stage `c`"},
      {ring, "", beside, "boundary strain 1 -1", ""},
      {ring, "", beside, "boundary fixed", ""},
      {ring, "", beside, "servo mean 1 on boundary through boundary at most 1",
       "17: the servo of stage `c` ended with it"},
      {ring, "", "servo mean 1 on boundary through boundary at most 1", "", ""},
      {ring, "", "boundary strain 0 0\nservo mean 1 on boundary through boundary at most 1", "", ""},
      {ring, "", "boundary strain 1 -1", "", ""},
      {ring, "boundary strain 1 -1", "servo mean 1 on boundary through boundary at most 1", "", ""},
      {cell, "", "cell strain 1 -1\nservo mean 1 on cell through cell at most 1", "", "14: the servo of stage `b` "},
      {box, "", "box strain 1 -1\nservo mean 1 on box through box at most 1", "", "14: the servo of stage `b` "},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    char statements[700];
    snprintf(statements, sizeof statements,
             "material m density 1 kn 1\n%s\ndisc 1 1 radius 1 m\nstep 1e-6\nstage a\n%s\ncycles 1\nstage b\n%s\n"
             "cycles 1\nstage c\n%s\ncycles 1",
             cases[k].scene, cases[k].first, cases[k].second, cases[k].third);
    begins(statements, cases[k].wanted);
  }
}

/* A strain rate of an earlier stage that goes on in a component that a servo controls causes a warning. */
static void strain_rates_against_a_servo(void) {
  static const char box[] = "box 0 0 to 9 9 m", cell[] = "periodic cell 0 0 to 9 9",
                    ring[] = "boundary circle 0 0 radius 1";
  static const struct {
    const char *scene, *before, *servo, *wanted;
  } cases[] = {
      {box, "box strain -1 -1", "servo isotropic 1 on box through box",
       "11: the servo of stage `b` works against the `box strain` of stage `a`, which goes on; end it by `box strain 0 "
       "0` "
       "in stage `b`\n"},
      {box, "box strain -1 -1", "box strain 0 0\nservo isotropic 1 on box through box", ""},
      {box, "box strain -1 -1", "box strain -1 -1\nservo isotropic 1 on box through box",
       "14: the servo of stage `b` ended"},
      {box, "box strain 0 -1", "servo xx 1 on box through box", ""},
      {box, "box strain -1 0", "servo xx 1 on box through box", "11: the servo"},
      {box, "box strain -1 0", "servo yy 1 on walls through box", ""},
      {box, "wall south velocity 0 1", "servo yy 1 on walls through box", ""},
      {cell, "cell strain 1 -1", "servo mean 1 on cell through cell", ""},
      {cell, "cell strain 1 -2", "servo mean 1 on cell through cell", "11: the servo"},
      {cell, "cell strain 0 0 c12 1", "servo xx 1 on cell through cell", ""},
      {cell, "cell strain 0 0 c12 1", "servo isotropic 1 on cell through cell", "11: the servo"},
      {cell, "cell strain 0 0 c21 1", "servo isotropic 1 on cell through cell", "11: the servo"},
      {"transform rotate 1.5707963267948966\nperiodic cell 0 0 to 9 9", "cell strain -1 0",
       "servo xx 1 on cell through cell", "12: the servo"},
      {"transform rotate 1.5707963267948966\nperiodic cell 0 0 to 9 9", "cell strain -1 0",
       "servo yy 1 on cell through cell", ""},
      {ring, "boundary strain -1 0", "servo xx 1 on boundary through boundary", "11: the servo"},
      {ring, "boundary strain -1 0", "boundary fixed\nservo xx 1 on boundary through boundary", ""},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    char statements[512];
    snprintf(
        statements, sizeof statements,
        "material m density 1 kn 1\n%s\ndisc 1 1 radius 1 m\nstep 1e-6\nstage a\n%s\ncycles 1\nstage b\n%s at most "
        "1\ncycles 1",
        cases[k].scene, cases[k].before, cases[k].servo);
    begins(statements, cases[k].wanted);
  }
}

/* A condition on a strain whose sign is the opposite of that of the strain rate causes a warning. The rate is the sum of
 * all imposed strain rates except those that a servo changes. Without one it is the motion of the walls towards the mean
 * position of the particles (compression) or away from it: here x = 2, y = 20. In the condition `$` is a strain of
 * 0.25. */
static void conditions_on_strains_of_the_other_sign(void) {
  static const char flat[] = "wall w -9 21 to 9 21 m", under[] = "wall w -9 19 to 9 19 m",
                    right[] = "wall w 2.5 -9 to 2.5 99 m", left[] = "wall w 1.5 99 to 1.5 -9 m", plain[] = "skin 1",
                    cell[] = "periodic cell 0 0 to 99 99", box[] = "box -99 -99 to 99 99 m",
                    ring[] = "boundary circle 0 0 radius 1";
  static const struct {
    const char *scene, *motion, *condition;
    const char *wanted; /* a part of the only warning of this kind; "": there is none */
    const char *from;   /* the stage from which the strains of P and Q count; NULL: `a` */
  } cases[] = {
      /* walls */
      {flat, "wall w velocity 0 -1", "M.strain.yy above 0.25",
       "compresses in y, and extension is positive: in place of `M.strain.yy above 0.25` write `M.strain.yy below "
       "-0.25`\n"},
      {flat, "wall w velocity 0 -1", "M.strain.yy below -0.25", ""},
      {flat, "wall w velocity 0 -1", "M.strain.yy above 0", ""},
      {flat, "wall w velocity 0 -1", "M.strain.yy above -0.25", ""},
      {flat, "wall w velocity 0 -1", "M.strain.yy below 0.25", ""},
      {flat, "wall w velocity 0 1", "M.strain.yy below -0.25",
       "extends in y, and extension is positive: in place of `M.strain.yy below -0.25` write `M.strain.yy above "
       "0.25`\n"},
      {flat, "wall w velocity 0 1", "M.strain.yy above 0.25", ""},
      {flat, "wall w velocity 0 1", "M.strain.yy below 0", ""},
      {flat, "wall w velocity 1 0", "M.strain.yy above 0.25", ""},
      {flat, "wall w velocity -1 0", "M.strain.yy above 0.25", ""},
      {flat, "wall w velocity 0 -1", "M.strain.xx above 0.25", ""},
      {flat, "wall w velocity -1 0", "M.strain.xx above 0.25", ""}, /* this wall does not face x */
      {flat, "wall w velocity 0 -1", "time above 0.25", ""},
      {flat, "wall w velocity 0 -1", "M.strain.xy above 0.25", ""},
      {flat, "zero velocities", "M.strain.yy above 0.25", ""},
      {flat, "zero velocities", "M.strain.yy below -0.25", ""},
      {under, "wall w velocity 0 1", "M.strain.yy above 0.25", "compresses in y"},
      {under, "wall w velocity 0 -1", "M.strain.yy below -0.25", "extends in y"},
      {right, "wall w velocity -1 0", "M.strain.xx above 0.25",
       "compresses in x, and extension is positive: in place of `M.strain.xx above 0.25` write `M.strain.xx below "
       "-0.25`\n"},
      {right, "wall w velocity 1 0", "M.strain.xx below -0.25", "extends in x"},
      {right, "wall w velocity -1 0", "M.strain.yy above 0.25", ""},
      {right, "wall w velocity 0 -1", "M.strain.yy above 0.25", ""},
      {left, "wall w velocity 1 0", "M.strain.xx above 0.25", "compresses in x"},
      {left, "wall w velocity -1 0", "M.strain.xx below -0.25", "extends in x"},
      {"wall w 4 31 to 14 41 m", "wall w velocity -1 -1", "M.strain.yy above 0.25", ""}, /* at 45 degrees */
      {"wall w 4 31 to 14 41 m", "wall w velocity -1 -1", "M.strain.xx above 0.25", ""},
      {"wall w 4 31 to 14 40 m", "wall w velocity -1 -1", "M.strain.yy above 0.25", "compresses in y"},
      {"wall w 4 31 to 13 41 m", "wall w velocity -1 -1", "M.strain.xx above 0.25", "compresses in x"},
      {"wall v -9 19 to 9 19 m velocity 0 -1\nwall w -9 21 to 9 21 m", "wall w velocity 0 -1", "M.strain.yy above 0.25",
       ""}, /* one wall compresses, the other extends */
      {"wall v -9 19 to 9 19 m velocity 0 -1\nwall w -9 21 to 9 21 m", "wall w velocity 0 -1",
       "M.strain.yy below -0.25", ""},
      {"wall v -9 19 to 9 19 m velocity 0 1\nwall w -9 21 to 9 21 m", "wall w velocity 0 -1", "M.strain.yy above 0.25",
       "compresses in y"},
      {"wall v -9 19 to 9 19 m velocity 0 -1\nwall w -9 21 to 9 21 m", "wall w velocity 0 1", "M.strain.yy below -0.25",
       "extends in y"},
      {"wall v -9 21 to 9 21 m velocity 0 -1\nwall w 2.5 -9 to 2.5 99 m", "wall w velocity -1 0",
       "M.strain.yy above 0.25", "compresses in y"},
      {"wall v -9 21 to 9 21 m velocity 0 -1\nwall w 2.5 -9 to 2.5 99 m", "wall w velocity 0 1",
       "M.strain.yy above 0.25", "compresses in y"}, /* a vertical wall does not extend in y */
      {"wall v -9 21 to 9 21 m", "cycles 1\nstage b\nwall v velocity 0 -1\ncycles 1\nstage c", "M.strain.yy above 0.25",
       ": stage `c` compresses in y", "c"}, /* the motion of an earlier stage goes on */
      {"wall v -9 21 to 9 21 m velocity 0 -1", "zero velocities",
       "M.strain.yy above 0.25 at most 9 cycles\nstage b\nwall v velocity 0 1\nuntil M.strain.yy above 0.5",
       "compresses in y"},
      {"wall v -9 21 to 9 21 m", "zero velocities",
       "M.strain.yy above 0.25 at most 9 cycles\nstage b\nwall v velocity 0 -1\nuntil time above 0.5",
       ""}, /* a later stage does not count */
      /* imposed strain rates */
      {plain, "affine strain 0 -1", "M.strain.yy above 0.25", "compresses in y"},
      {plain, "affine strain 0 1", "M.strain.yy below -0.25", "extends in y"},
      {plain, "affine strain -1 0", "M.strain.xx above 0.25", "compresses in x"},
      {plain, "affine strain -1 0", "M.strain.yy above 0.25", ""},
      {plain, "affine strain 0 -1", "M.strain.xx above 0.25", ""},
      {plain, "affine strain -1 1", "M.strain.yy above 0.25", ""},
      {plain, "affine strain -1 1", "M.strain.xx above 0.25", "compresses in x"},
      {plain, "affine strain 0 0 shear -1", "M.strain.xx above 0.25", ""},
      {ring, "boundary strain 0 -1", "M.strain.yy above 0.25", "compresses in y"},
      {ring, "boundary strain 0 -1\naffine strain 0 2", "M.strain.yy above 0.25", ""},
      {ring, "boundary strain 0 -1\naffine strain 0 2", "M.strain.yy below -0.25", "extends in y"},
      {ring, "boundary strain 0 2\naffine strain 0 -1", "M.strain.yy below -0.25", "extends in y"},
      {ring, "boundary strain 0 1\naffine strain 0 -1", "M.strain.yy below -0.25", ""},
      {cell, "cell strain 0 -1", "cell.strain.yy above 0.25",
       "compresses in y, and extension is positive: in place of `cell.strain.yy above 0.25` write `cell.strain.yy "
       "below -0.25`\n"},
      {cell, "cell strain -1 0", "cell.strain.xx above 0.25", "compresses in x"},
      {box, "box strain 0 -1", "box.strain.height above 0.25", "compresses in y"},
      {box, "box strain -1 0", "box.strain.width above 0.25", "compresses in x"},
      {box, "box strain -1 0", "box.strain.height above 0.25", ""},
      {flat, "wall w velocity 0 -1\naffine strain 0 1", "M.strain.yy above 0.25", ""}, /* the rate comes before walls */
      {flat, "wall w velocity 0 -1\naffine strain 0 1", "M.strain.yy below -0.25", "extends in y"},
      /* servos */
      {box, "box strain 0 -1\nservo yy 1 on walls through box at most 1", "box.strain.height above 0.25", ""},
      {box, "box strain 0 -1\nservo xx 1 on walls through box at most 1", "box.strain.height above 0.25", "compresses"},
      {box, "box strain -1 0\nservo xx 1 on walls through box at most 1", "box.strain.width above 0.25", ""},
      {"box -99 -99 to 99 99 m\nwall w -9 21 to 9 21 m", "wall w velocity 0 -1", "M.strain.yy above 0.25",
       "compresses in y"},
      {"box -99 -99 to 99 99 m\nwall w -9 21 to 9 21 m",
       "wall w velocity 0 -1\nservo xx 1 on walls through box at most 1", "M.strain.yy above 0.25", ""},
      /* strains that count from an earlier time, and repeated stages */
      {plain, "cycles 1\nstage b\naffine strain 0 -1", "M.strain.yy above 0.25",
       "in place of `M.strain.yy above 0.25` write `S.strain.yy below -0.25`, with `region S all from b` in the scene: "
       "the strain then counts from the beginning of this stage\n",
       "b"},
      {plain, "cycles 1\nstage b\naffine strain 1 0", "M.strain.xx below -0.25",
       "in place of `M.strain.xx below -0.25` write `S.strain.xx above 0.25`, with `region S all from b` in the scene: "
       "the strain then counts",
       "b"},
      {plain, "cycles 1\nstage b\naffine strain 0 -1", "P.strain.yy above 0.25",
       "in place of `P.strain.yy above 0.25` write `P.strain.yy below -0.25`\n", "b"},
      {plain, "cycles 1\nstage b\naffine strain 0 -1", "Q.strain.yy above 0.25",
       "in place of `Q.strain.yy above 0.25` write `Q.strain.yy below -0.25`\n", "b"},
      {plain, "cycles 1\nstage c\ncycles 1\nstage b\naffine strain 0 -1", "P.strain.yy above 0.25",
       "in place of `P.strain.yy above 0.25` write `P.strain.yy below -0.25`\n", "b"},
      {plain, "cycles 1\nstage b\ncycles 1\nstage c\naffine strain 0 -1", "P.strain.yy above 0.25",
       "in place of `P.strain.yy above 0.25` write `S.strain.yy below -0.25`", "b"},
      {cell, "cycles 1\nstage b\ncell strain 0 -1", "cell.strain.yy above 0.25",
       "in place of `cell.strain.yy above 0.25` write `S.strain.yy below -0.25`, with `region S all from b`", "b"},
      {plain, "affine strain 0 -1\ncycles 1\nstage b", "M.strain.yy above 0.25", "stage `b` compresses in y",
       "b"}, /* inherited */
      {plain, "affine strain 0 -1\ncycles 1\nstage b\naffine none", "M.strain.yy above 0.25", ""},
      {plain, "affine strain 0 -1",
       "M.strain.yy above 0.25 at most 9 cycles\nrepeat from a 2 more times\nstage c\nuntil time above 1",
       "compresses in y, and extension is positive: in place of `M.strain.yy above 0.25` write `M.strain.yy below "
       "-0.25`\n"},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    char text[2000], statements[800];
    const char *const wanted = cases[k].wanted, *const from = cases[k].from ? cases[k].from : "a";
    snprintf(
        statements, sizeof statements,
        "material m density 1 kn 1\ndisc 1 10 radius 0.1 m\ndisc 3 30 radius 0.1 m\n%s\nregion P all from %s\nmonitor "
        "D disc 1\nregion M all\nregion Q all from %s\nstep 1e-6\nstage a\n%s\nuntil %s at most 9 cycles",
        cases[k].scene, from, from, cases[k].motion, cases[k].condition);
    const char *const sign = "extension is positive", *const first = strstr(warned(text, statements), sign);
    const bool as_wanted = *wanted ? first && strstr(text, wanted) && !strstr(first + 1, sign) : !first;
    if (!as_wanted)
      printf("# %s\n# said: %s\n", statements, text);
    CU_ASSERT(as_wanted);
  }
}

/* A wall that rotates about its middle because its line has no `about` causes a warning. Opposite walls of a box may rotate
 * alike, which distorts the box. */
static void walls_that_rotate_about_their_middles(void) {
#define NO_ABOUT "; its line in the scene has no `about X Y`, which sets the centre\n"
#define OF_BOX "; its line in the scene is a `box`; only a line `wall` can have `about X Y`, which sets the centre\n"
  static const char box[] = "wall v -90 0 to -80 0 m\nbox 0 0 to 8 6 m";
  static const struct {
    const char *walls, *a, *b, *wanted;
  } cases[] = {
      {"wall w 0 1 to 4 3 m spin 1", "", "", "4: wall `w` rotates about its middle: 2 2" NO_ABOUT},
      {"wall w 0 1 to 4 3 m spin -1", "", "", "4: wall `w` rotates about its middle: 2 2" NO_ABOUT},
      {"wall u 0 -5 to 4 -5 m\nwall w 0 1 to 4 3 m spin 1", "", "",
       "5: wall `w` rotates about its middle: 2 2" NO_ABOUT},
      {"wall w 0 1 to 4 3 m", "", "", ""},
      {"wall w 0 1 to 4 3 m about 2 2 spin 1", "", "", ""},
      {"wall w 0 1 to 4 3 m", "wall w spin 1", "", "8: wall `w` rotates about its middle: 2 2" NO_ABOUT},
      {"wall w 0 1 to 4 3 m", "", "wall w spin 1", "10: wall `w` rotates about its middle: 2 2" NO_ABOUT},
      {"wall w 0 1 to 4 3 m", "wall w spin 0", "", ""},
      {"wall w 0 1 to 4 3 m", "wall w velocity 1 0", "", ""},
      {"wall w 0 1 to 4 3 m about 9 9", "wall w spin 1", "", ""},
      {box, "wall south spin 1", "", "9: wall `south` rotates about its middle: 4 0" OF_BOX},
      {box, "wall west spin 1", "", "9: wall `west` rotates about its middle: 0 3" OF_BOX},
      {box, "wall v spin 1", "", "9: wall `v` rotates about its middle: -85 0" NO_ABOUT},
      {box, "wall south spin 1\nwall north spin 1", "", ""},
      {box, "wall north spin 1\nwall south spin 1", "", ""},
      {box, "wall east spin 1\nwall west spin 1", "", ""},
      {box, "wall south spin 1\nwall north spin -1", "", "9: wall `south` rotates"},
      {box, "wall south spin 1\nwall east spin 1", "", "9: wall `south` rotates"},
      {box, "wall south spin 1\nwall north spin 1", "wall south spin 2", "13: wall `south` rotates"},
      {box, "wall south spin 1\nwall north spin 1", "wall south spin 1", ""},
      {box, "wall south spin 1\nwall north spin 1", "wall south spin 2\nwall north spin 2", ""},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    char statements[500];
    snprintf(
        statements, sizeof statements,
        "material m density 1 kn 1\n%s\ndisc 4 5 radius 0.1 m\nstep 1e-6\nstage a\n%s%scycles 1\nstage b\n%s\ncycles 1",
        cases[k].walls, cases[k].a, *cases[k].a ? "\n" : "", cases[k].b);
    begins(statements, cases[k].wanted);
  }
}

/* A free particle whose centre is outside the box causes a warning. The centre may be on a wall. */
static void particles_outside_the_box(void) {
  static const struct {
    const char *particles, *wanted;
  } cases[] = {
      {"disc 0 4 radius 0.1 m fixed\ndisc 4 4 radius 1 m", ""},
      {"disc 4 4 radius 1 m\ndisc 9 4 radius 0.5 m", "7: particle 2 begins outside the box\n"},
      {"disc -1 4 radius 0.5 m", "6: particle 1 begins outside the box\n"},
      {"disc 4 9 radius 0.5 m", "6: particle 1 begins outside the box\n"},
      {"disc 4 -1 radius 0.5 m", "6: particle 1 begins outside the box\n"},
      {"disc 4 -1 radius 0.5 m fixed", ""},
      {"disc 4 4 radius 1 m\ndisc 4 -1 radius 0.5 m\ndisc 4 -9 radius 0.5 m\ndisc 4 6 radius 0.5 m",
       "7: 2 particles begin outside the box; the first is particle 2\n"},
      {"disc 4 4 radius 1 m\ntransform rotate 1", ""},
      {"disc 9 4 radius 0.5 m\ntransform rotate 1", "6: particle 1 begins outside the box\n"},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    char statements[500];
    snprintf(statements, sizeof statements,
             "material m density 1 kn 1\nwall v -90 -90 to -80 -90 m\nbox 0 0 to 8 8 m\n%s", cases[k].particles);
    begins(statements, cases[k].wanted);
  }
  begins("material m density 1 kn 1\nwall v -90 -90 to -80 -90 m\ndisc 9 9 radius 1 m", ""); /* there is no box */
}

/* A fixed particle has no contact with a wall or with another fixed particle. */
static void contacts_of_fixed_particles(void) {
  static const struct warning_case cases[] = {
      {"monitor C disc 1 with disc 2",
       "8: this contact has no force: a `fixed` particle has no contact with another fixed one\n"},
      {"monitor C disc 2 with wall w", "8: this contact has no force: a `fixed` particle has no contact with a wall\n"},
      {"monitor C disc 3 with wall w", NULL},
      {"monitor C disc 1 with disc 3", NULL},
      {"monitor C disc 3 with disc 2", NULL},
      {"monitor C disc 1", NULL},
      {"monitor C wall w", NULL},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    char statements[500];
    snprintf(statements, sizeof statements,
             "material m density 1 kn 1\ndisc 0 0 radius 1 m fixed\ndisc 3 0 radius 1 m fixed\ndisc 6 0 radius 1 m\n"
             "wall w -9 -9 to 9 -9 m\n%s",
             cases[k].statements);
    warns_once(&(struct warning_case){statements, cases[k].wanted});
  }
}

/* Gravity upwards, and away from all walls and fixed particles, causes a warning. There is none if a wall or a fixed
 * particle is in its direction, if something else moves the particles or the walls, or if there is no wall at all. */
static void gravity_away_from_walls(void) {
  static const char floor[] = "wall w -9 0 to 9 0 m", ceiling[] = "wall w -9 9 to 9 9 m",
                    below[] = "disc 0 -5 radius 1 m fixed";
  static const struct {
    const char *obstacle, *gravity, *particle, *stage;
    bool warned;
  } cases[] = {
      {floor, "gravity 0 9.81", "disc 0 2 radius 1 m", "", true},
      {floor, "gravity 0 -9.81", "disc 0 2 radius 1 m", "", false},
      {floor, "gravity 1 0", "disc 0 2 radius 1 m", "", false},       /* the wall ends at x = 9 */
      {floor, "gravity 1 0", "disc 9.5 2 radius 1 m", "", false},     /* not upwards */
      {ceiling, "gravity 0 -9.81", "disc 0 2 radius 1 m", "", false}, /* free fall */
      {"wall w 9 -9 to -9 -9 m", "gravity 0 9.81", "disc 0 2 radius 1 m", "", true},
      {floor, "gravity 0 9.81", "disc 0 2 radius 1 m", "cycles 1\nstage b\nreverse velocities", false},
      {ceiling, "gravity 0 9.81", "disc 0 2 radius 1 m", "", false},
      {ceiling, "gravity 0 -9.81", "disc 0 2 radius 1 m velocity 0 1", "", false},
      {below, "gravity 0 9.81", "disc 0 2 radius 1 m", "", true},
      {below, "gravity 0 -9.81", "disc 0 2 radius 1 m", "", false},
      {"box -9 -9 to 9 9 m", "gravity 0 9.81", "disc 0 2 radius 1 m", "", false},
      {"# no wall", "gravity 0 9.81", "disc 0 2 radius 1 m", "", false},
      {floor, "# none", "disc 0 2 radius 1 m", "gravity 0 9.81\ncycles 1\nstage b", true},
      {floor, "# none", "disc 0 2 radius 1 m", "ramp gravity 0 9.81\ncycles 1\nstage b", false},
      {floor, "gravity 0 9.81", "disc 0 2 radius 1 m", "cycles 1\nstage b\ngravity 0 -9.81", false},
      {floor, "gravity 0 -9.81", "disc 0 2 radius 1 m", "cycles 1\nstage b\ngravity 0 9.81", false},
      {floor, "gravity 0 9.81", "disc 0 2 radius 1 m", "wall w velocity 0 1", false},
      {floor, "gravity 0 0", "disc 0 2 radius 1 m", "", false},
      {ceiling, "gravity 0 -9.81\ntransform rotate (pi)", "disc 0 2 radius 1 m", "", false},
      {floor, "gravity 0 9.81", "disc 0 2 radius 1 m\ndisc 9 -2 radius 1 m", "", false},
      /* The obstacle is the wall, not the point P that its line names. */
      {"wall w -9 9 to 9 9 m about 0 -5", "gravity 0 9.81", "disc 0 2 radius 1 m", "", false},
      {"wall w -9 0 to 9 0 m about 0 5", "gravity 0 9.81", "disc 0 2 radius 1 m", "", true},
      {"wall w 20 -9 to 20 9 m about -30 0", "gravity 1 1", "disc 0 2 radius 1 m", "", false},
      /* The first end of the wall, or the top of the fixed disc, is as high as the free disc or higher. */
      {"wall w 3 20 to 3 -9 m", "gravity 0 9.81", "disc 0 2 radius 1 m", "", false},
      {"disc 0 -5 radius 7 m fixed", "gravity 0 9.81", "disc 20 2 radius 1 m", "", false},
      /* The disc is above the box. Something else moves walls or particles, or places particles, or no particle is free. */
      {"box -9 -9 to 9 9 m", "gravity 0 9.81", "disc 0 20 radius 1 m", "", true},
      {"box -9 -9 to 9 9 m", "gravity 0 9.81", "disc 0 20 radius 1 m", "box strain 0 1", false},
      {"box -9 -9 to 9 9 m", "gravity 0 9.81", "disc 0 20 radius 1 m", "servo mean 1 on box through box at most 1",
       false},
      {floor, "gravity 0 9.81", "disc 0 2 radius 1 m", "boundary circle 0 0 radius 50", false},
      {floor, "gravity 0 9.81", "disc 0 2 radius 1 m", "affine strain 0 1", false},
      {floor, "gravity 0 9.81", "disc 0 2 radius 1 m\nboundary circle 0 0 radius 50", "", false},
      {floor, "gravity 0 9.81", "grading g 1 1\nfill discs box 0 5 to 9 15 g m seed 1 attempts 9 else skip", "", false},
      {"periodic cell -20 -20 to 20 20", "gravity 0 9.81", "disc 0 -5 radius 1 m fixed\ndisc 0 2 radius 1 m", "",
       false},
      {"wall w -9 0 to 9 0 m velocity 1 0", "gravity 0 9.81", "disc 0 2 radius 1 m", "", false},
      {"wall w -9 0 to 9 0 m velocity 0 1", "gravity 0 9.81", "disc 0 2 radius 1 m", "", false},
      {"wall w -9 0 to 9 0 m about 0 0 spin 1", "gravity 0 9.81", "disc 0 2 radius 1 m", "", false},
      {floor, "gravity 0 9.81", "disc 0 2 radius 1 m velocity 0 1", "", false},
      {floor, "gravity 0 9.81", "disc 0 2 radius 1 m velocity 1 0", "", false},
      {floor, "gravity 0 9.81", "disc 0 2 radius 1 m fixed", "", false},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    char text[2000], statements[500], wanted[300];
    const char *const outside = strstr(cases[k].particle, "disc 0 20 ") ? "6: particle 1 begins outside the box\n" : "";
    snprintf(wanted, sizeof wanted, "%s", outside);
    if (cases[k].warned)
      snprintf(
          wanted, sizeof wanted,
          "%s%d: gravity moves all free particles upwards, and away from all walls and fixed particles; y points up: "
          "gravity downwards is `gravity 0 -9.81`\n",
          outside, *cases[k].gravity == '#' ? 9 : 5);
    snprintf(statements, sizeof statements, "material m density 1 kn 1\n%s\n%s\n%s\nstep 1e-6\nstage a\n%s\ncycles 1",
             cases[k].obstacle, cases[k].gravity, cases[k].particle, cases[k].stage);
    const bool as_wanted = strcmp(warned(text, statements), wanted) == 0;
    if (!as_wanted)
      printf("# %s\n# said: %s\n", statements, text);
    CU_ASSERT(as_wanted);
  }
}

/* A page that records rows without a quantity gets a warning, because the rows would be empty. */
static void empty_rows(void) {
  static const struct {
    const char *records, *in_stage;
    const char *wanted;
  } cases[] = {{"", "record every 1 cycle", "8: `record every` writes empty rows: no quantity is recorded\n"},
               {"", "record none", ""},
               {"record time", "record every 5 cycles", ""}};
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    char text[2000], statements[256];
    snprintf(statements, sizeof statements,
             "material m density 1 kn 1\ndisc 0 0 radius 1 m\nstep 1e-6\n%s\nstage a\n%s\ncycles 9", cases[k].records,
             cases[k].in_stage);
    if (strcmp(warned(text, statements), cases[k].wanted) != 0)
      printf("# %s\n", text);
    CU_ASSERT_STRING_EQUAL(text, cases[k].wanted);
  }
}

/* A warning is due if the ulp of a coordinate is more than a thousandth of the overlap. ulp(2^23) = 2^-29 is a
 * thousandth of the overlap 1000 x 2^-29. */
static void resolution_of_coordinates(void) {
  char text[2000];
  static const struct {
    double overlap, at;
    bool warns;
  } cases[] = {
      {2000. / 536870912, 8388608, false},
      {900. / 536870912, 8388608, true},
      {900. / 536870912, -8388700, true},
      {900. / 536870912, 4194304 - 4, false},
      {-0.5, 8388608, false}, /* no overlap yet: 1e-3 is assumed, whose thousandth is above 2^-29 */
      {-0.5, 8589934592., true},
      {0, 0, false},
  };
  static const double sizes[] = {1, 0x1p-10, 0x1p10};
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
    for (int n = 0; n < 6; n++) {
      const int axis = n % 2;
      const double size = sizes[n / 2]; /* multiplies all lengths, and the result stays the same */
      char statements[500];
      snprintf(statements, sizeof statements,
               axis ? "material m density 1 kn 1\ndisc 0 %.17g radius %.17g m\ndisc 0 %.17g radius %.17g m\n"
                    : "material m density 1 kn 1\ndisc %.17g 0 radius %.17g m\ndisc %.17g 0 radius %.17g m\n",
               size * cases[k].at, size, size * (cases[k].at + 2 - cases[k].overlap), size);
      warned(text, statements);
      CU_ASSERT_EQUAL(text[0] != 0, cases[k].warns);
      CU_ASSERT(!cases[k].warns || (strstr(text, "of the mean overlap") != NULL) == (cases[k].overlap > 0));
      if ((text[0] != 0) != cases[k].warns)
        printf("# %s%s\n", statements, text);
    }
}

/* Three discs in a row with overlaps of 700 x 2^-29: the mean counts, not the sum. Of the first particles of the two
 * contacts, the one farthest from the origin is named, in either order of the row. */
static void resolution_and_mean_overlap(void) {
  const double x[] = {8388608, 8388610 - 700. / 536870912, 8388612 - 1400. / 536870912};
  for (int reverse = 0; reverse < 2; reverse++) {
    char text[2000], statements[500];
    snprintf(statements, sizeof statements,
             "material m density 1 kn 1\ndisc %.17g 0 radius 1 m\ndisc %.17g 0 radius 1 m\ndisc %.17g 0 radius 1 m\n",
             x[reverse ? 2 : 0], x[1], x[reverse ? 0 : 2]);
    CU_ASSERT_PTR_NOT_NULL(strstr(warned(text, statements), reverse ? "4: particle 1: its coordinate 8.38861e+06 has"
                                                                    : "5: particle 2: its coordinate 8.38861e+06 has"));
  }
  /* An overlap of at most 1e-9 of the radius comes from rounding and does not count in the mean. */
  for (int touch = 0; touch < 2; touch++) {
    char text[2000], statements[500];
    snprintf(
        statements, sizeof statements,
        "material m density 1 kn 1\ndisc 8388608 0 radius %d m\ndisc %.17g 0 radius %d m\ndisc %.17g 0 radius %d m\n",
        touch ? 4 : 1, 8388608 + (touch ? 8 : 2) - 1500. / 536870912, touch ? 4 : 1,
        8388608 + (touch ? 16 : 4) - 1501. / 536870912, touch ? 4 : 1);
    CU_ASSERT_EQUAL(warned(text, statements)[0] != 0, !touch);
  }
}

/* The warning is given once in a run: not again when another particle is farther from the origin. Here the ulp is
 * 2^-19, and the expected overlap a thousandth of the smaller radius. */
static void resolution_is_reported_once(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 1\ndisc 1e10 0 radius 1 m\ndisc 0 0 radius 0.5 m\nstep 1e-9\n"
                   "record time\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL_FATAL(model->warnings.count, 1);
  CU_ASSERT_STRING_EQUAL(
      model->warnings.list[0].text,
      "particle 1: its coordinate 1e+10 has a resolution (ulp) of 1.90735e-06, that is 0.38 % of the "
      "expected overlap, a thousandth of the smallest radius, 0.0005, at cycle 0. The relative error "
      "of the forces is of this size (limit: 0.1 %): put the scene nearer to the origin");
  CU_ASSERT_EQUAL(model->warnings.list[0].line, 4);
  model->particles.position[model->particles.slot[1]].x = 3e10;
  nb_guard_resolution(model);
  CU_ASSERT_EQUAL(model->warnings.count, 1);
  nb_model_free(model);
  written_free(&it);
}

/* Two heavy discs with an overlap of 900 x 2^-29 move together by 0.5 in a cycle, which is more than half the skin. The
 * first disc begins at 2^23 - 4 and is at 2^23 after 8 cycles. Below 2^23 the ulp is 2^-30, which is fine enough for
 * the overlap. */
static void resolution_that_gets_coarse(void) {
  struct words page = {0};
  struct written it;
  struct nb_error error = {0};
  words_add(&page,
            "units none\nmaterial m density 1e12 kn 1\ndisc 8388604 0 radius 1 m velocity 0.5 0\n"
            "disc %.17g 0 radius 1 m velocity 0.5 0\nstep 1\nrecord time\nstage s\ncycles 10\n",
            8388606 - 900. / 536870912);
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  written_cycles(model, 7);
  CU_ASSERT_EQUAL(model->warnings.count, 0);
  written_cycles(model, 2);
  CU_ASSERT_EQUAL_FATAL(model->warnings.count, 1);
  CU_ASSERT_PTR_NOT_NULL(strstr(model->warnings.list[0].text, "particle 1: its coordinate 8.38861e+06 has"));
  nb_model_free(model);
  written_free(&it);
}

/* In a scene with units every length and time of a message has its unit. */
static void messages_with_units(void) {
#define SI "material m density 1e9 kg/m3 kn 1 N/m\nallow unstable\nstep 0.5 s\n"
  static const struct {
    const char *page, *text;
  } errors[] = {
      {"disc 0 m 0 m radius 1 m m velocity 2.2 m/s 0 m/s\ndisc 9 m 0 m radius 1 m m",
       "particle 1 (line 5): in cycle 1, at time 0.5 s, it moved by 1.1 m in one step of 0.5 s. The limit is its "
       "radius, 1 "
       "m: beyond"},
      {"disc -5 m 5 m radius 1 m m\nwall w 0 m 0 m to 9 m 0 m m about 0 m 0 m spin 2 rad/s",
       "wall `w` (line 6): in cycle 1, at time 0.5 s, it turned by 1 rad in one step of 0.5 s and may have passed "
       "through "
       "a particle. The limit is the smallest radius, 1 m: the arc"},
      {"disc 0 m 0 m radius 2 m m\ndisc 1.5 m 0 m radius 1 m m",
       "particle 2 overlaps particle 1 (line 5) by 1.5 m. Expected at most the smaller radius, 1 m: move"},
      {"disc 0 m 0 m radius 2 m m\ndisc 3.1 m 0 m radius 1 m m velocity -1.8 m/s 0 m/s",
       "particle 1 (line 5) and particle 2 (line 6): at cycle 2, time 1 s, they overlap by 1.7 m. The limit is the "
       "smaller "
       "radius, 1 m: beyond"},
      {"disc 0 m 0.5 m radius 1 m m velocity 0 m/s -1.8 m/s\nwall w -9 m 0 m to 9 m 0 m m",
       "particle 1 (line 5) passed through wall `w` (line 6) in cycle 1, at time 0.5 s: its centre is now on the other "
       "side. The limit of the overlap with a wall is the particle's radius, 1 m; in this step of 0.5 s it moved 0.9 m "
       "relative to the wall: try a smaller step"},
  };
  static const struct {
    const char *page, *text;
  } warnings[] = {
      {"disc 1e10 m 0 m radius 1 m m\ndisc 0 m 0 m radius 0.5 m m",
       "particle 1: its coordinate 1e+10 m has a resolution (ulp) of 1.90735e-06 m, that is 0.38 % of the expected "
       "overlap, a thousandth of the smallest radius, 0.0005 m, at cycle 0."},
      {"disc 0 m 0 m radius 1 m m\ndisc 2.7 m 0 m radius 2 m m",
       "particle 2 overlaps particle 1 (line 5) too much at the start: by 0.3 m, 15 % of the smaller diameter"},
  };
  struct nb_error error;
  unsigned long done;
  for (size_t k = 0; k < sizeof errors / sizeof *errors; k++) {
    char page[400];
    snprintf(page, sizeof page, SI "%s", errors[k].page);
    CU_ASSERT(outcome(&error, page, 2, &done) != NB_OK);
    CU_ASSERT(has(&error, errors[k].text));
    CU_ASSERT_EQUAL(error.line, k == 2 ? 6 : 0);
  }
  struct words deep = {0};
  struct written deep_scene;
  words_add(&deep,
            "material m density 1e9 kg/m3 young 1 Pa poisson 0\nallow unstable\nstep 0.5 s\nnormal hertz\nshear none\n"
            "sphere 0 m 0 m radius 1 m m\nsphere 2.05 m 0 m radius 1 m m velocity -0.6 m/s 0 m/s\nstage s\n"
            "cycles 1\n");
  written_scene(&deep_scene, &deep);
  struct nb_model *deep_model = written_model(&deep_scene, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(deep_model, &deep_scene.scene.stages[0], &error), NB_OK);
  written_cycles(deep_model, 1);
  CU_ASSERT_STRING_EQUAL(deep_model->deep.first, "particle 1 and particle 2, in cycle 1, at time 0.5 s");
  nb_model_free(deep_model), written_free(&deep_scene);
  for (int cycle = 0; cycle < 8; cycle += 7) { /* before the first step a narrow cell is a mistake of the page */
    struct words page = {0};
    struct written it;
    words_add(&page,
              SI "disc 0 m 0 m radius 1 m m\nperiodic cell 0 m 0 m to 9 m 9 m\ndisc 1 m 5 m radius 1 m m\nstage s\n"
                 "cycles 1\n");
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    model->cell->h.xx = 4.2 * (1 + 1e-12), error.line = 0;
    CU_ASSERT_EQUAL(nb_cell_check_width(model, &error), NB_OK);
    model->cell->h.xx = 4, model->cycle = (unsigned long)cycle, model->time = 0.5 * cycle;
    CU_ASSERT_EQUAL(nb_cell_check_width(model, &error), cycle ? NB_BROKEN : NB_BAD_USE);
    CU_ASSERT_EQUAL(error.line, 6);
    CU_ASSERT(has(&error, cycle ? "the cell is 4 m wide at cycle 7, at time 3.5 s: a particle could have"
                                : "the cell is 4 m wide at cycle 0, at time 0 s: a particle could have"));
    CU_ASSERT(has(&error, "Expected at least twice the sum of the largest diameter and the skin, 4.2 m: make"));
    nb_model_free(model);
    written_free(&it);
  }
  for (size_t k = 0; k < sizeof warnings / sizeof *warnings; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page, SI "%s\nstage s\ncycles 1\n", warnings[k].page);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_EQUAL_FATAL(model->warnings.count, 1);
    CU_ASSERT_PTR_NOT_NULL(strstr(model->warnings.list[0].text, warnings[k].text));
    if (k == 1) {
      model->critical = 2, model->particles.position[0].y = NAN;
      CU_ASSERT_EQUAL(nb_guard_positions(model, &error), NB_BROKEN);
      CU_ASSERT(has(&error,
                    "(line 5): its position is NaN or infinite after cycle 0, at time 0 s; the step is 0.5 s, the "
                    "single-contact step is 2 s: try"));
    }
    nb_model_free(model);
    written_free(&it);
  }
#undef SI
}

static void each_warning_once(void) {
  struct nb_warnings warnings = {0};
  nb_warn(&warnings, 3, "a: 1"), nb_warn(&warnings, 3, "b: 1"), nb_warn(&warnings, 3, "a: 2");
  CU_ASSERT(warnings.count == 2 && strcmp(warnings.list[0].text, "a: 1") == 0);
  CU_ASSERT(strcmp(warnings.list[1].text, "b: 1") == 0);
  warnings.count = 0;
  for (int k = 0; k < 40; k++)
    nb_warn(&warnings, k / 2, "the %dth", k / 4);
  CU_ASSERT_EQUAL(warnings.count, NB_WARNINGS);
  CU_ASSERT(warnings.list[0].line == 0 && warnings.list[1].line == 1 && strcmp(warnings.list[1].text, "the 0th") == 0);
  CU_ASSERT(warnings.list[15].line == 15 && strcmp(warnings.list[15].text, "the 7th") == 0);
}

void suite_guard(void) {
  CU_pSuite suite = CU_add_suite("guard", NULL, NULL);
  CU_add_test(suite, "overlap at the start", overlap_at_the_start);
  CU_add_test(suite, "coincident particles", coincident_particles);
  CU_add_test(suite, "displacement in a step", displacement_in_a_step);
  CU_add_test(suite, "displacement imposed by a cell", imposed_by_a_cell);
  CU_add_test(suite, "rotation in a step", rotation_in_a_step);
  CU_add_test(suite, "translation of walls in a step", translation_of_walls);
  CU_add_test(suite, "strain of a cell in a step, and its width", strain_of_a_cell);
  CU_add_test(suite, "overlap during the run", overlap_during_the_run);
  CU_add_test(suite, "friction without effect", friction_without_effect);
  CU_add_test(suite, "contacts without force", contacts_without_force);
  CU_add_test(suite, "gravity away from all walls", gravity_away_from_walls);
  CU_add_test(suite, "rows without a quantity", empty_rows);
  CU_add_test(suite, "conditions that only a tensile law can meet", conditions_on_tensile_forces);
  CU_add_test(suite, "conditions on another stress than the servo controls",
              conditions_on_another_stress_than_the_servo);
  CU_add_test(suite, "changes below the end of a stage", changes_below_the_end_of_a_stage);
  CU_add_test(suite, "strain rates that go on without their servo", strain_rates_without_their_servo);
  CU_add_test(suite, "strain rates of earlier stages against a servo", strain_rates_against_a_servo);
  CU_add_test(suite, "conditions on strains of the other sign", conditions_on_strains_of_the_other_sign);
  CU_add_test(suite, "walls that rotate about their middles", walls_that_rotate_about_their_middles);
  CU_add_test(suite, "particles outside the box", particles_outside_the_box);
  CU_add_test(suite, "contacts of fixed particles", contacts_of_fixed_particles);
  CU_ADD_TEST(suite, overlaps_at_the_start_above_the_limit);
  CU_ADD_TEST(suite, positions_that_are_not_finite);
  CU_add_test(suite, "resolution of coordinates", resolution_of_coordinates);
  CU_add_test(suite, "resolution that gets coarse", resolution_that_gets_coarse);
  CU_add_test(suite, "resolution and mean overlap", resolution_and_mean_overlap);
  CU_add_test(suite, "resolution is reported once", resolution_is_reported_once);
  CU_ADD_TEST(suite, messages_with_units);
  CU_add_test(suite, "each warning once", each_warning_once);
}
