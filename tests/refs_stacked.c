/* Two spheres between floor and ceiling: the ODE against the modes of two equal masses on three equal springs.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

#include "refs_scenes.h"
#include "suites.h"

/* R = 1, walls at 0 and 3.6, k = 100; masses of density 1 and `density`. */
static void stack(struct refs_scene *it, double density, double damping) {
  memset(it, 0, sizeof *it);
  it->materials[0] = (struct nb_material){.name = "a", .density = 1, .kn = 100};
  it->materials[1] = (struct nb_material){.name = "b", .density = density, .kn = 100};
  it->bodies[0] = (struct nb_body){.shape = NB_SPHERE, .radius = 1, .y = 0.9};
  it->bodies[1] = (struct nb_body){.shape = NB_SPHERE, .radius = 1, .y = 2.7, .material = 1};
  it->walls[0] = (struct nb_wall){.name = "floor", .ex = 1};
  it->walls[1] = (struct nb_wall){.name = "ceiling", .ex = 1, .y = 3.6};
  it->watches[0] = (struct nb_watch){.name = "A", .kind = NB_WATCH_BODY};
  it->watches[1] = (struct nb_watch){.name = "B", .kind = NB_WATCH_BODY, .a = 1};
  it->watches[2] = (struct nb_watch){.name = "C", .kind = NB_WATCH_BODY_BODY, .b = 1};
  it->scene.materials = it->materials, it->scene.material_count = 2;
  it->scene.bodies = it->bodies, it->scene.body_count = 2;
  it->scene.walls = it->walls, it->scene.wall_count = 2;
  it->scene.watches = it->watches, it->scene.watch_count = 3;
  strcpy(it->scene.normal, "linear"), strcpy(it->scene.shear, "none");
  if (damping > 0)
    it->scene.damping = (struct nb_damping){.contact_kind = NB_CONTACT_RATIO, .contact = damping};
}

static double at(const struct nb_known *known, const char *name, double t) {
  const struct nb_known_curve *curve = known_find_curve(known, name, "time");
  CU_ASSERT_PTR_NOT_NULL_FATAL(curve);
  return curve->at(curve->data, t);
}

/* d = 0.4 too little room: at rest each spring has d/3. From there the spheres move apart alike, at w^2 = 3 k/m, undamped; with
 * ratio b, c = 2 b sqrt(m k) at a wall and sqrt(1/2) of it between: c_in = c (1 + 2 sqrt(1/2)). */
static void equal_spheres_breathe(void) {
  for (int damped = 0; damped < 2; damped++) {
    struct refs_scene it;
    const double b = damped ? 0.1 : 0, m = 4 * M_PI / 3, w2 = 300 / m;
    stack(&it, 1, b);
    struct nb_known known = refs_known("stacked", &it);
    const double decay = b * sqrt(100 / m) * (1 + M_SQRT2), beat = sqrt(w2 - decay * decay);
    for (double t = 0; t < 5; t += 0.1) {
      const double swing = (0.1 - 0.4 / 3) * exp(-decay * t) * (cos(beat * t) + decay / beat * sin(beat * t));
      const double overlap = 0.4 / 3;
      REFS_NEAR(at(&known, "A.y", t), 1 - overlap - swing, 1e-11, 1.);
      REFS_NEAR(at(&known, "B.y", t), 2.6 + overlap + swing, 1e-11, 1.);
      REFS_NEAR(at(&known, "C.overlap", t), overlap - 2 * swing, 1e-11, 1.);
    }
    known_free(&known);
  }
}

/* Damped and with weight they come to rest where the springs bear F + (m_1 + m_2) g, F + m_2 g and F. */
static void they_come_to_rest_under_their_weight(void) {
  struct refs_scene it;
  stack(&it, 3, 0.5);
  it.scene.gravity = (struct nb_gravity){.y = -0.1, .line = 1};
  struct nb_known known = refs_known("stacked", &it);
  const double m1 = 4 * M_PI / 3, m2 = 3 * m1, g = 0.1, force = (100 * 0.4 - (m1 + 2 * m2) * g) / 3;
  REFS_NEAR(at(&known, "A.y", 60), 1 - (force + (m1 + m2) * g) / 100, 1e-10, 1.);
  REFS_NEAR(at(&known, "B.y", 60), 2.6 + force / 100, 1e-10, 1.);
  REFS_NEAR(at(&known, "A.vy", 60), 0, 1e-10, 1.);
  REFS_NEAR(at(&known, "B.vy", 1), (at(&known, "B.y", 1.001) - at(&known, "B.y", 0.999)) / 0.002, 1e-5, 1.);
  REFS_NEAR(at(&known, "A.vy", 1), (at(&known, "A.y", 1.001) - at(&known, "A.y", 0.999)) / 0.002, 1e-5, 1.);
  known_free(&known);
}

static void another_scene_is_refused(void) {
  struct refs_scene it;
  stack(&it, 1, 0);
  it.bodies[1].x = 0.1;
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("stacked", &it).text, "sphere 1 under sphere 2"));
  stack(&it, 1, 0);
  strcpy(it.scene.normal, "hertz");
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("stacked", &it).text, "`normal hertz`"));
  stack(&it, 1, 0);
  it.scene.damping.contact_kind = NB_CONTACT_BETA, it.scene.damping.contact = 0.1;
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("stacked", &it).text, "`damping stiffness`"));
}

void suite_refs_stacked(void) {
  CU_pSuite suite = CU_add_suite("refs_stacked", NULL, NULL);
  CU_add_test(suite, "equal spheres breathe", equal_spheres_breathe);
  CU_add_test(suite, "they come to rest under their weight", they_come_to_rest_under_their_weight);
  CU_add_test(suite, "another scene is refused", another_scene_is_refused);
}
