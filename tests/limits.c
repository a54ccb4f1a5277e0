/* Statements at the limits of their values: the last valid value and the first one that is refused.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <stdlib.h>
#include <string.h>

#include "../src/input/reader.h"
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

void suite_limits(void) {
  CU_pSuite suite = CU_add_suite("limits", NULL, NULL);
  CU_ADD_TEST(suite, corners);
  CU_ADD_TEST(suite, cells);
  CU_ADD_TEST(suite, impacts);
}
