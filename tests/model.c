/* A model of a scene at time 0 (model.c): particles, walls, material pairs, the skin, and memory for what stages need.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "core/model.h"

#include <CUnit/CUnit.h>
#include <math.h>
#include <string.h>

#include "run/plan.h"
#include "suites.h"
#include "written.h"

static struct nb_model *made(struct written *it, const struct nb_options *options, const char *text) {
  struct words page = {0};
  words_add(&page, "units none\n%s", text);
  written_scene(it, &page);
  return written_model(it, options);
}

#define MATERIALS "material m density 3 kn 100\nmaterial n density 5 kn 300\nstep 0.01\nrecord cycle\n"
#define STAGE "stage a\ncycles 1\n"

/* A disc has the mass pi R^2 rho (thickness 1) and the moment of inertia m R^2/2; a sphere has 4/3 pi R^3 rho and
 * 2/5 m R^2. With `shuffle`, particles with even indices are stored from the front and the others from the back. */
static void particles_of_a_scene(void) {
  static const size_t slots[][5] = {{0, 1, 2, 3, 4}, {0, 1, 2, 3, 4}, {0, 4, 1, 3, 2}};
  static const double radius[] = {2, 0.5, 3, 1, 4}, spin[] = {0.25, 0, -2, 0, 0}, x[] = {1, 11, 22, 33, 44};
  const double pi = 3.14159265358979323846;
  const struct nb_options options[] = {{.threads = 1}, {.threads = 1, .shuffle = true}};
  for (int k = 0; k < 3; k++) {
    struct written it;
    struct nb_model *model = made(&it, k ? &options[k - 1] : NULL,
                                  MATERIALS "disc 1 2 radius 2 m velocity 3 4 spin 0.25\nsphere 11 3 radius 0.5 n\n"
                                            "disc 22 4 radius 3 n fixed velocity 5 6 spin -2\ndisc 33 5 radius 1 m\n"
                                            "disc 44 6 radius 4 m\n" STAGE);
    const struct nb_particles *particles = &model->particles;
    CU_ASSERT_EQUAL_FATAL(particles->count, 5);
    for (size_t p = 0; p < 5; p++) {
      const size_t i = slots[k][p];
      const bool sphere = p == 1, fixed = p == 2, n = p == 1 || p == 2;
      const double r = radius[p], mass = (n ? 5 : 3) * pi * r * r * (sphere ? 4 * r / 3 : 1);
      const double inertia = (sphere ? 0.4 : 0.5) * mass * r * r;
      CU_ASSERT_EQUAL(particles->slot[p], (int)i);
      CU_ASSERT_EQUAL(particles->number[i], (int)p + 1);
      CU_ASSERT(particles->position[i].x == x[p] && particles->position[i].y == 2 + (double)p);
      CU_ASSERT_EQUAL(particles->velocity[i].x, p == 0 ? 3 : fixed ? 5 : 0);
      CU_ASSERT_EQUAL(particles->velocity[i].y, p == 0 ? 4 : fixed ? 6 : 0);
      CU_ASSERT(particles->radius[i] == r && particles->spin[i] == spin[p]);
      CU_ASSERT_EQUAL(particles->surface_speed[i], spin[p] * r);
      CU_ASSERT_DOUBLE_EQUAL(particles->mass[i], mass, 1e-12 * mass);
      CU_ASSERT_DOUBLE_EQUAL(particles->inertia[i], inertia, 1e-12 * inertia);
      CU_ASSERT_EQUAL(particles->inverse_mass[i], fixed ? 0 : 1 / particles->mass[i]);
      CU_ASSERT_EQUAL(particles->inverse_inertia[i], fixed ? 0 : 1 / particles->inertia[i]);
      CU_ASSERT_EQUAL(particles->material[i], n);
    }
    CU_ASSERT_EQUAL(model->search.smallest_radius, 0.5);
    nb_model_free(model), written_free(&it);
  }
}

/* A wall from (1, 1) to (4, 5) has the direction (0.6, 0.8). It rotates about (1, 6), which is 3 to the left of the wall,
 * at 4 along it; so the wall is 3 to the right of this point, from -4 to 1. */
static void walls_of_a_scene(void) {
  struct written it;
  struct nb_model *model = made(&it, NULL,
                                MATERIALS "disc 50 50 radius 1 m\nwall v 0 0 to 0 -2 n\n"
                                          "wall w 1 1 to 4 5 m velocity 2 3 spin 0.5 about 1 6\n" STAGE);
  const struct nb_walls *walls = &model->walls;
  CU_ASSERT_EQUAL_FATAL(walls->count, 2);
  CU_ASSERT(walls->pivot[1].x == 1 && walls->pivot[1].y == 6);
  CU_ASSERT_DOUBLE_EQUAL(walls->along[1].x, 0.6, 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(walls->along[1].y, 0.8, 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(walls->h0[1], -3, 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(walls->h1[1], -4, 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(walls->h2[1], 1, 1e-14);
  for (int end = 0; end < 2; end++) {
    const struct nb_vec at = nb_wall_end(walls, 1, end), other = nb_wall_end(walls, 0, end);
    CU_ASSERT_DOUBLE_EQUAL(at.x, end ? 4 : 1, 1e-14);
    CU_ASSERT_DOUBLE_EQUAL(at.y, end ? 5 : 1, 1e-14);
    CU_ASSERT_DOUBLE_EQUAL(other.x, 0, 1e-15);
    CU_ASSERT_DOUBLE_EQUAL(other.y, end ? -2 : 0, 1e-15);
  }
  CU_ASSERT(walls->velocity[1].x == 2 && walls->velocity[1].y == 3 && walls->spin[1] == 0.5);
  CU_ASSERT(walls->velocity[0].x == 0 && walls->velocity[0].y == 0 && walls->spin[0] == 0);
  nb_model_free(model), written_free(&it);
}

/* There is a pair for any two materials of particles, and for each of them with each material of a wall. */
static void material_pairs_of_a_scene(void) {
  static const struct {
    const char *scene, *pairs;
  } rows[] = {{"disc 1 1 radius 1 m\n", "mm"},
              {"disc 1 1 radius 1 n\n", "nn"},
              {"disc 1 1 radius 1 n\nwall w 9 9 to 8 9 m\n", "nn nwm"},
              {"disc 1 1 radius 1 m\nwall w 9 9 to 8 9 m\n", "mm mwm"},
              {"disc 1 1 radius 1 n\ndisc 5 1 radius 1 m\n", "mm mn nn"},
              {"disc 1 1 radius 1 n\ndisc 5 1 radius 1 m\nwall w 9 9 to 8 9 n\nwall v 9 9 to 8 9.5 o\n",
               "mm mn nn mwn mwo nwn nwo"}};
  for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
    char text[256], pairs[64] = "";
    struct written it;
    snprintf(text, sizeof text, MATERIALS "material o density 1 kn 700\n%s" STAGE, rows[r].scene);
    struct nb_model *model = made(&it, NULL, text);
    for (size_t p = 0; p < model->material_pair_count; p++) {
      const struct nb_material_pair *pair = &model->material_pairs[p];
      static const double kn[] = {100, 300, 700};
      sprintf(pairs + strlen(pairs), "%s%c%s%c", p ? " " : "", 'm' + pair->a, pair->wall ? "w" : "", 'm' + pair->b);
      const double wanted = 2 * kn[pair->a] * kn[pair->b] / (kn[pair->a] + kn[pair->b]); /* two springs in series */
      CU_ASSERT_DOUBLE_EQUAL(pair->values.kn, wanted, 1e-13 * wanted);
    }
    CU_ASSERT_STRING_EQUAL(pairs, rows[r].pairs);
    nb_model_free(model), written_free(&it);
  }
}

/* The skin is a tenth of the mean radius, or that of the page. It is infinite if nothing can meet. */
static void skins(void) {
  static const struct {
    const char *scene;
    double skin;
  } rows[] = {{"disc 1 1 radius 1 m\ndisc 9 1 radius 3 m\n", 0.2},
              {"disc 1 1 radius 1 m\ndisc 9 1 radius 3 m\nskin 0.7\n", 0.7},
              {"disc 1 1 radius 1 m fixed\ndisc 9 1 radius 3 m fixed\nskin 0.7\n", INFINITY},
              {"disc 1 1 radius 1 m fixed\ndisc 9 1 radius 3 m\n", 0.2},
              {"disc 1 1 radius 1 m\ndisc 9 1 radius 3 m fixed\n", 0.2},
              {"disc 1 1 radius 3 m\n", INFINITY},
              {"disc 1 1 radius 3 m\nwall w 9 9 to 8 9 m\n", 0.3}};
  for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
    char text[256];
    struct written it;
    snprintf(text, sizeof text, MATERIALS "%s" STAGE, rows[r].scene);
    struct nb_model *model = made(&it, NULL, text);
    CU_ASSERT(model->search.skin == rows[r].skin || fabs(model->search.skin - rows[r].skin) < 1e-15);
    nb_model_free(model), written_free(&it);
  }
}

/* There is memory for removed particles or walls if a stage removes some; for centred dashpots if the same stage has
 * dashpots; for rotation if some particle has a spin. */
static void memory_for_stages(void) {
  static const struct {
    const char *stages;
    bool removed, ahead, spin;
  } rows[] = {{"stage a\ncycles 1\nstage b\ncycles 1\n", false, false, false},
              {"stage a\nremove disc 1\ncycles 1\nstage b\ncycles 1\n", true, false, false},
              {"stage a\ncycles 1\nstage b\nremove disc 1\ncycles 1\n", true, false, false},
              {"damping stiffness 0.1\n" STAGE, false, false, false},
              {"damping mass 0.1\ndamping centred\n" STAGE, false, false, false},
              {"damping stiffness 0.1\ndamping centred\n" STAGE, false, true, false},
              {"stage a\ncycles 1\nstage b\ndamping stiffness 0.1\ndamping centred\ncycles 1\n", false, true, false},
              {"wall v 20 0 to 20 9 m\nwall w 30 0 to 30 9 m\nstage a\ncycles 1\nstage b\nwall v velocity 1 0\n"
               "remove wall w\ncycles 1\n",
               false, false, false},
              {"disc 1 7 radius 1 m spin 1\ndisc 7 7 radius 1 m\n" STAGE, false, false, true},
              {"disc 1 7 radius 1 m\ndisc 7 7 radius 1 m spin 1\n" STAGE, false, false, true}};
  for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
    char text[256];
    struct written it;
    snprintf(text, sizeof text, MATERIALS "disc 1 1 radius 1 m\ndisc 9 1 radius 1 m\n%s", rows[r].stages);
    struct nb_model *model = made(&it, NULL, text);
    CU_ASSERT_EQUAL(model->particles.removed != NULL, rows[r].removed);
    CU_ASSERT_EQUAL(model->particles.ahead != NULL, rows[r].ahead);
    CU_ASSERT_EQUAL(model->particles.spin != NULL, rows[r].spin);
    CU_ASSERT_EQUAL(model->particles.angle != NULL, rows[r].spin);
    CU_ASSERT_EQUAL(model->walls.removed != NULL, strstr(rows[r].stages, "remove wall") != NULL);
    nb_model_free(model), written_free(&it);
  }
}

/* Laws that do not exist are refused with their names. */
static void laws_that_do_not_exist(void) {
  static const char *const laws[][3] = {{"linear", "none", ""},
                                        {"cubic", "none", "there is no law `normal cubic`"},
                                        {"linear", "sticky", "there is no law `shear sticky`"},
                                        {"cubic", "sticky", "there is no law `normal cubic`"}};
  for (int k = 0; k < 4; k++) {
    struct words page = {0};
    struct written it;
    struct nb_error error = {NB_OK, ""};
    words_add(&page, "units none\n" MATERIALS "disc 1 1 radius 1 m\n" STAGE);
    written_scene(&it, &page);
    strcpy(it.scene.normal, laws[k][0]), strcpy(it.scene.shear, laws[k][1]);
    struct nb_model *model = nb_model_create(&it.scene, NULL, &error);
    CU_ASSERT_EQUAL(model != NULL, k == 0);
    CU_ASSERT_EQUAL(error.status, k ? NB_BAD_USE : NB_OK);
    CU_ASSERT_STRING_EQUAL(error.text, laws[k][2]);
    nb_model_free(model), written_free(&it);
  }
}

/* A model at time 0 has the warnings about overlaps and regions at the start. */
static void warnings_at_the_start(void) {
  static const struct {
    const char *scene, *begin; /* "": no warning */
    const char *stage;         /* a second stage */
  } rows[] = {
      {"disc 1 1 radius 1 m\ndisc 2.95 1 radius 1 m\n", ""},
      {"disc 1 1 radius 1 m\ndisc 2.5 1 radius 1 m\n", "particle 2 overlaps particle 1"},
      {"disc 1 1 radius 1 m\nregion A circle 9 9 radius 1\n", "region `A` is empty: no particle centre is inside at "
                                                              "the start"},
      /* `inside` is no region until the boundary exists */
      {"disc 1 1 radius 1 m\nregion A inside 0.5\n", "", "stage later\nboundary circle 1 1 radius 9\ncycles 1\n"}};
  for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
    char text[256];
    struct written it;
    snprintf(text, sizeof text, MATERIALS "%s" STAGE "%s", rows[r].scene, rows[r].stage ? rows[r].stage : "");
    struct nb_model *model = made(&it, NULL, text);
    CU_ASSERT_EQUAL_FATAL(model->warnings.count, *rows[r].begin ? 1 : 0);
    if (*rows[r].begin)
      CU_ASSERT_NSTRING_EQUAL(model->warnings.list[0].text, rows[r].begin, strlen(rows[r].begin));
    nb_model_free(model), written_free(&it);
  }
}

void suite_model(void) {
  CU_pSuite suite = CU_add_suite("model", NULL, NULL);
  CU_ADD_TEST(suite, particles_of_a_scene);
  CU_ADD_TEST(suite, walls_of_a_scene);
  CU_ADD_TEST(suite, material_pairs_of_a_scene);
  CU_ADD_TEST(suite, skins);
  CU_ADD_TEST(suite, memory_for_stages);
  CU_ADD_TEST(suite, laws_that_do_not_exist);
  CU_ADD_TEST(suite, warnings_at_the_start);
}
