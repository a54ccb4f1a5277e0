/* Waves in a lattice: the velocities of `perturb wave`, and the reference (cases/refs/waves.h), in which the speeds of
 * long waves must follow from the elastic moduli.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>

#include "../cases/refs/waves.h"
#include "suites.h"
#include "written.h"

static const double pi = 3.14159265358979323846;

/* `perturb wave` adds V sin(2 pi (NX (x - x_0)/width + NY (y - y_0)/height)) to the velocity of every free particle
 * that the page defines above this statement. (x_0, y_0) is the centre of the cell. Two waves add up. */
static void a_wave_is_a_sine_from_the_centre(void) {
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial m density 1 kn 1\nperiodic cell 2 1 to 42 17\n"
            "lattice discs 5 by 3 from 4 3 radius 0.9 spacing 5 m\ndisc 40 16 radius 0.5 m fixed\n"
            "disc 7 6 radius 0.5 m velocity 3 4\nperturb wave 0.2 -0.1 periods 2 -1\nperturb wave 0 0.5 periods 0 3\n"
            "disc 10 6 radius 0.5 m velocity 1 2\nstep 1\nrecord time\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  CU_ASSERT_EQUAL_FATAL(it.scene.particle_count, 18);
  for (size_t k = 0; k < 18; k++) {
    const struct nb_particle *particle = &it.scene.particles[k];
    const double one = sin(2 * pi * (2 * (particle->x - 22) / 40 - (particle->y - 9) / 16));
    const double two = sin(2 * pi * 3 * (particle->y - 9) / 16), above = k < 17 && !particle->fixed;
    const double vx = k == 16 ? 3 : k == 17 ? 1 : 0, vy = k == 16 ? 4 : k == 17 ? 2 : 0;
    CU_ASSERT_DOUBLE_EQUAL(particle->vx, vx + above * 0.2 * one, 1e-14);
    CU_ASSERT_DOUBLE_EQUAL(particle->vy, vy + above * (-0.1 * one + 0.5 * two), 1e-14);
  }
  CU_ASSERT(fabs(it.scene.particles[0].vx) > 0.01);
  written_free(&it);
}

/* Sets `slow` and `fast` to rho c^2 of the two waves in the direction `angle`, with the density rho and the speed c.
 * The lattice is hexagonal or square, its discs can rotate if `turns`, and its shear stiffness is `ks`. The wave number
 * q and the spacing s satisfy q s = 1e-3. The finite wavelength changes rho c^2 by a fraction of about (q s)^2/12. */
static void speeds(bool hexagonal, bool turns, double angle, double ks, double *slow, double *fast) {
  const double s = 2, q = 1e-3 / s, density = 4 / (s * s * (hexagonal ? sqrt(0.75) : 1));
  const struct waves_lattice lattice = {
      .kn = 7, .ks = ks, .mass = 4, .inertia = 2, .radius = 1, .spacing = s, .hexagonal = hexagonal, .rotates = turns};
  const struct waves_modes modes = waves_modes(&lattice, q * cos(angle), q * sin(angle));
  CU_ASSERT_EQUAL(modes.count, turns ? 3 : 2);
  *slow = density * modes.omega[0] * modes.omega[0] / (q * q);
  *fast = density * modes.omega[1] * modes.omega[1] / (q * q);
}

static void long_waves_follow_from_the_moduli(void) {
  const double kn = 7, ks = 3, third = sqrt(3) / 4;
  double slow, fast;
  for (int k = 0; k < 7; k++) { /* a hexagonal lattice is isotropic */
    speeds(true, true, k * 0.3, ks, &slow, &fast);
    CU_ASSERT_DOUBLE_EQUAL(fast, third * (3 * kn + ks), 1e-5);
    CU_ASSERT_DOUBLE_EQUAL(slow, third * (kn + ks), 1e-5);
    speeds(true, false, k * 0.3, ks, &slow, &fast);
    CU_ASSERT_DOUBLE_EQUAL(fast, third * (3 * kn + ks), 1e-5);
    CU_ASSERT_DOUBLE_EQUAL(slow, third * (kn + 3 * ks), 1e-5);
  }
  speeds(false, true, 0, ks, &slow, &fast);
  CU_ASSERT_DOUBLE_EQUAL(fast, kn, 1e-5);
  CU_ASSERT_DOUBLE_EQUAL(slow, ks / 2, 1e-5);
  speeds(false, false, pi / 2, ks, &slow, &fast);
  CU_ASSERT_DOUBLE_EQUAL(fast, kn, 1e-5);
  CU_ASSERT_DOUBLE_EQUAL(slow, ks, 1e-5);
  speeds(false, true, pi / 4, ks, &slow, &fast); /* along a diagonal: (C_11 + C_12)/2 + G, (C_11 - C_12)/2 */
  CU_ASSERT_DOUBLE_EQUAL(fast, kn / 2 + ks / 2, 1e-5);
  CU_ASSERT_DOUBLE_EQUAL(slow, kn / 2, 1e-5);
}

/* At the edge of the Brillouin zone neighbours move against each other with omega^2 = 4 k_n/m. At q = 0 all discs
 * rotate in the same way with omega^2 = 16 k_s/m. */
static void short_waves(void) {
  const struct waves_lattice lattice = {
      .kn = 7, .ks = 3, .mass = 4, .inertia = 2, .radius = 1, .spacing = 2, .rotates = true};
  struct waves_modes modes = waves_modes(&lattice, pi / 2, 0);
  CU_ASSERT_DOUBLE_EQUAL(modes.omega[2] * modes.omega[2], 7, 1e-12);
  modes = waves_modes(&lattice, 0, 0);
  CU_ASSERT_DOUBLE_EQUAL(modes.omega[2] * modes.omega[2], 12, 1e-12);
  for (int a = 0; a < 3; a++)
    for (int b = 0; b < 3; b++) {
      double sum = 0;
      for (int i = 0; i < 3; i++)
        sum += modes.shape[a][i] * modes.weight[b][i];
      CU_ASSERT_DOUBLE_EQUAL(sum, a == b, 1e-12);
    }
}

void suite_waves(void) {
  CU_pSuite suite = CU_add_suite("waves", NULL, NULL);
  CU_add_test(suite, "a wave is a sine from the centre", a_wave_is_a_sine_from_the_centre);
  CU_add_test(suite, "speeds of long waves follow from the moduli", long_waves_follow_from_the_moduli);
  CU_add_test(suite, "short waves, and orthogonal modes", short_waves);
}
