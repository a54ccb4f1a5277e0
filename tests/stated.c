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
      {"cell" BIG " to 1.79e308 1.79e308", ""},
      {"gravity" BIG, ""},
      {"boundary circle" BIG " radius 1", ""},
      {"skin 1", "boundary circle" BIG " radius 1"},
      {"skin 1", "gravity" BIG},
      {"skin 1", "gravity centripetal 1 about" BIG},
      {"skin 1", "affine strain 1.7e308 -1.7e308 c12 1.7e308 c21 1.7e308"},
      {"cell 0 0 to 9 9", "cell strain 1.7e308 -1.7e308 c12 1.7e308 c21 1.7e308"},
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

void suite_stated(void) {
  CU_pSuite suite = CU_add_suite("stated", NULL, NULL);
  CU_ADD_TEST(suite, quarter_turns_are_exact);
  CU_ADD_TEST(suite, numbers_that_transform_makes_infinite);
}
