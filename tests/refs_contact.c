/* The reference one_contact: the shear dashpot of two rotating discs, compared with a closed form. The reference
 * changed_law: a contact with a wall in any direction.
 *
 * Two discs of density 1 with radii 1 and 2 overlap by 1e-3 and have the same spin w at the start, 1e-6. The mass of the
 * contact is M* = m_1 m_2/(m_1 + m_2), and R^2/I = 2/m for a disc. The slip s is then an oscillation,
 *
 *   s'' + (3/M*) (c_s s' + k_s s) = 0,   s(0) = 0,   s'(0) = -(R_1 + R_2) w,   F_s = k_s s
 *
 * The normal spring is 10^4 times softer than the shear spring. The distance of the centres grows by the fraction 2e-7
 * in the time of the test. The rotation of the contact changes s' by a fraction of this size. Terms of second order in w
 * are smaller.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>

#include "refs_scenes.h"
#include "suites.h"
#include "written.h"

static const double ks = 1e4, spin = 1e-6, duration = 0.05;

/* The shear force at the end, for this statement and this coefficient of the shear dashpot. */
static void shear_oscillates(const char *damping, double mass, double cs) {
  struct words page = {0};
  struct written it;
  struct refs_scene scene;
  words_add(&page,
            "units none\nmaterial m density 1 kn 1 ks %g cohesion 1e9\nnormal linear\nshear linear\ndamping %s\n"
            "disc 0 0 radius 1 m spin %g\ndisc 2.999 0 radius 2 m spin %g\nmonitor C disc 1 with disc 2\n"
            "step %g\nrecord C.shear\nstage s\ncycles 100\n",
            ks, damping, spin, spin, duration / 100);
  written_scene(&it, &page);
  scene.scene = it.scene;
  struct nb_solution solution = refs_solution("one_contact", &scene);
  const double decay = 1.5 * cs / mass, omega = sqrt(3 * ks / mass - decay * decay), largest = ks * 3 * spin / omega;
  const double shear = -largest * exp(-decay * duration) * sin(omega * duration);
  REFS_NEAR(refs_value(&solution, "C.shear"), shear, 1e-6, largest);
  solution_free(&solution);
  written_free(&it);
}

static void a_shear_dashpot_damps_rotation(void) {
  const double pi = 3.14159265358979323846, mass = 0.8 * pi; /* M* of the masses pi and 4 pi */
  shear_oscillates("stiffness 0.004", mass, 0.004 * ks);
  shear_oscillates("ratio 0.1", mass, 2 * 0.1 * sqrt(mass * ks));
  shear_oscillates("none", mass, 0);
}

/* A heavy sphere overlaps a wall by 0.01, and the wall moves along itself at 0.02: C.normal = kn 0.01, and the magnitude
 * of C.shear is ks 0.02 t. The direction of the wall does not matter. The shear force changes its sign with the
 * side on which the sphere is. */
static void a_wall_in_any_direction_shears_a_contact(void) {
  static const double radius = 2, overlap = 0.01, speed = 0.02, kn = 10, tangential = 7;
  for (int k = 0; k < 24; k++) {
    const double angle = k / 2 * 3.14159265358979323846 / 6, ex = cos(angle), ey = sin(angle), side = k % 2 ? -1 : 1;
    const double away = side * (radius - overlap), x = 3 - away * ey, y = -4 + away * ex;
    struct words page = {0};
    struct written it;
    struct refs_scene scene;
    words_add(&page,
              "units none\nmaterial m density 1e30 kn %g ks %g friction 9\n"
              "normal linear\nshear linear\nsphere %.17g %.17g radius %g m\n",
              kn, tangential, x + 0.3 * ex, y + 0.3 * ey, radius);
    words_add(&page,
              "wall w %.17g %.17g to %.17g %.17g m velocity %.17g %.17g\nmonitor C sphere 1 with wall w\n"
              "step 0.25\nrecord time C.normal C.shear\nstage s\ncycles 4\n",
              3 - 5 * ex, -4 - 5 * ey, 3 + 5 * ex, -4 + 5 * ey, speed * ex, speed * ey);
    written_scene(&it, &page);
    scene.scene = it.scene;
    struct nb_solution solution = refs_solution("changed_law", &scene);
    const struct nb_solution_curve *normal = solution_find_curve(&solution, "C.normal", "time");
    const struct nb_solution_curve *shear = solution_find_curve(&solution, "C.shear", "time");
    CU_ASSERT(normal && shear);
    if (normal && shear) {
      REFS_NEAR(normal->at(normal->data, 0.5), kn * overlap, 1e-11, kn * overlap);
      REFS_NEAR(shear->at(shear->data, 0.5), side * tangential * speed * 0.5, 1e-12, tangential * speed);
    }
    solution_free(&solution);
    written_free(&it);
  }
}

void suite_refs_contact(void) {
  CU_pSuite suite = CU_add_suite("refs_contact", NULL, NULL);
  CU_add_test(suite, "a shear dashpot damps the rotation of two discs", a_shear_dashpot_damps_rotation);
  CU_add_test(suite, "a wall in any direction shears a contact", a_wall_in_any_direction_shears_a_contact);
}
