/* Assemblies that continue from a saved state: with a boundary, imposed affine motion, a servo, a cell, a box. Most
 * stages are followed by a stage `...-on` that changes little but the step. So the state must have everything that the
 * first of the two stages has set.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>

#include "continued.h"
#include "run/plan.h"
#include "suites.h"

static void same(const char *what, const char *page, const char *damping) {
  struct words words = {0};
  struct written it;
  words_add(&words, page, damping);
  written_scene(&it, &words);
  continued_same(&it, what);
  written_free(&it);
}

#define GRAINS                                                                                                         \
  "units none\nmaterial m density 3 friction 0.3 young 50000 poisson 0.2\nnormal hertz\nshear mindlin\n"               \
  "grading g 0.9 8 0.7 25 0.5 30\nstep 0.001\n%s\n"

/* Sixty-three spheres. After each stage there are contacts with shear forces. */
static const char ring[] = GRAINS
    "fill spheres circle 0.1 0.2 radius 7 g m seed 1 attempts 100000 else skip\nboundary circle 0.1 0.2 radius 6.3\n"
    "region A inside 0.9\nrecord time A.stress.mean\n"
    "stage gather\nboundary strain -4e-5 per cycle -5e-5 per cycle\naffine strain -4e-5 per cycle -5e-5 per "
    "cycle\ncycles 2500\n"
    "stage gather-on\nstep 0.0007\ncycles 200\n"
    "stage shear\nboundary strain -0.01 0.008 c12 0.01 c21 -0.003\naffine strain 0 0.005 shear 0.01\n"
    "cycles 200\n"
    "stage shear-on\nstep 0.001\nramp material m friction 0.4\ncycles 100\n"
    "stage accumulated\naffine strain -1e-5 per cycle 1e-5 per cycle accumulated\ncycles 30\n"
    "stage literal-on\nstep 0.0011\ncycles 20\n"
    "stage twice\naffine strain -1e-5 per cycle 1e-5 per cycle accumulated-twice\ncycles 30\n"
    "stage twice-on\nstep 0.001\ncycles 20\n"
    "stage rigid\naffine none\nboundary fixed\nrotation off\ncycles 100\n"
    "stage rigid-on\nstep 0.0008\ncycles 50\n"
    "stage servo\nservo isotropic 20 on A through boundary affine at most 1e-5 per cycle every 7 cycles\ncycles "
    "100\n"
    "stage ramped\nboundary strain 1e-5 per cycle -1e-5 per cycle\nramp servo mean 40 on A through boundary at most "
    "1e-5 per cycle\ncycles 100\n"
    "stage servo-off\nstep 0.001\ncycles 50\n"
    "stage pressed\nrotation on\nboundary stress 30 20 shear 2\ncycles 150\n"
    "stage pressed-on\nstep 0.0009\ncycles 100\n"
    "stage pull\nboundary none\ngravity centripetal 2 about 0.3 -0.2\naffine strain 0.001 0.002\ncycles 100\n"
    "stage pull-on\nstep 0.001\ncycles 100\n"
    "stage again\nboundary circle 0.3 -0.1 radius 5\nboundary strain 0.01 -0.01\ncycles 100\n"
    "stage less\nremove spheres 20 to 30\ncycles 100\n"
    "stage less-on\nstep 0.0012\ncycles 100\n";

static void a_ring(void) {
  same("ring", ring, "");
  same("ring, con1", ring, "damping con1 0.99 as cs79");
  same("ring, ratio", ring, "damping ratio 0.1");
}

static const char cell[] =
    GRAINS "periodic cell 0 0 to 12 12\nfill spheres box 0.5 0.5 to 11.5 11.5 g m seed 2 attempts 100000 "
           "else skip\ngravity 0.01 0\nrecord time "
           "cell.stress.mean\n"
           "stage gather\ncell strain -5e-5 per cycle -6e-5 per cycle\ncycles 2500\n"
           "stage gather-on\nstep 0.0007\ncycles 200\n"
           "stage shear\ncell strain 0 0 c12 0.1 c21 0.02\ncycles 300\n"
           "stage shear-on\nstep 0.001\ncycles 2000\n"
           "stage back\nreverse velocities\ncycles 100\n"
           "stage less\nremove sphere 20\nrotation off\ncycles 100\n"
           "stage less-on\nstep 0.0012\ncycles 100\n";

static void a_cell(void) {
  same("cell", cell, "");
  same("cell, con1", cell, "damping con1 0.99 as velocity");
  same("cell, ratio", cell, "damping ratio 0.1");
}

static const char box[] =
    GRAINS "box 0 0 to 12 12 m\nfill spheres box 0.1 0.1 to 11.9 11.9 g m seed 2 attempts 100000 "
           "else skip\ngravity 0.01 0\nrecord time box.stress.mean box.width\n"
           "stage gather\nbox strain -5e-5 per cycle -6e-5 per cycle\ncycles 2500\n"
           "stage gather-on\nstep 0.0007\ncycles 200\n"
           "stage servo\nservo isotropic 20 on box through box at most 1e-5 per cycle every 7 cycles\n"
           "cycles 100\nstage servo-on\nstep 0.001\ncycles 100\n"
           "stage push\nwalls inward 0.01\ncycles 100\n"
           "stage again\nservo mean 30 on box through box at most 1e-5 per cycle\ncycles 100\n"
           "stage still\nwalls stop\ncycles 50\nstage still-on\nstep 0.0012\ncycles 50\n"
           "stage open\nremove wall east\nwalls inward 0.01\ncycles 50\nstage open-on\ncycles 50\n";

static void a_box(void) {
  same("box", box, "");
  same("box, ratio", box, "damping ratio 0.1");
}

/* Central gravity that points away from a point. */
static void away_from_a_point(void) {
  same("away",
       "units none\nmaterial m density 3 kn 4000\nlattice discs 3 by 3 m radius 1 spacing 1.99 from -2 -2\n"
       "wall w -5 -3 to 5 -3 m\nrecord time\nstep 0.001\n"
       "stage a\ngravity centripetal -2 about 1 0\ncycles 20\nstage b\nstep 0.0008\ncycles 20\n",
       "");
}

/* One stage changes the shear law, and the stage after it still has the new law. */
static void a_changed_law(void) {
  same("changed law",
       "units none\nmaterial m density 3 young 1e5 poisson 0.3 friction 0.3\nnormal hertz\nshear mindlin\n"
       "lattice spheres 3 by 3 m radius 1 spacing 1.99 from -2 -2\nwall w -5 -3 to 5 -3 m\nrecord time\n"
       "step 0.1 of rayleigh\ngravity 3 -9\nstage a\ncycles 20\n"
       "stage b\nshear mindlin_deresiewicz memory 8\ncycles 20\nstage c\ncycles 20\n",
       "");
}

void suite_state_driven(void) {
  CU_pSuite suite = CU_add_suite("state_driven", NULL, NULL);
  CU_add_test(suite, "continued runs have the same bits with a boundary", a_ring);
  CU_add_test(suite, "continued runs have the same bits in a periodic cell", a_cell);
  CU_add_test(suite, "continued runs have the same bits in a box", a_box);
  CU_add_test(suite, "continued runs have the same bits with gravity away from a point", away_from_a_point);
  CU_ADD_TEST(suite, a_changed_law);
}
