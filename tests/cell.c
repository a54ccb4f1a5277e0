/* The periodic cell: its contacts, strain, gaps and regions. The contacts found are compared with a search over all
 * images. Results must not depend on the skin, threads, storage order or instruction set. On the image of a particle
 * that the page gives they may depend only by rounding (1e-8).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <stdlib.h>
#include <string.h>

#include "../src/core/contacts.h"
#include "placed.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

enum { DISCS = 150 };

struct radii {
  double least, greatest;
};

/* A gas of discs of these radii with friction in a cell that is strained. `more`: further statements. If `wander` is 1,
 * the page gives another image of every particle. */
static void gas_of(struct written *it, struct radii radii, const char *strain, const char *more, int wander,
                   unsigned seed) {
  struct words page = {0};
  struct chance chance = chance_begin(seed), copies = chance_begin(99);
  words_add(&page,
            "units none\nmaterial a density 1 kn 3e3 ks 2e3 friction 0.4\nmaterial b density 2 kn 9e3 ks 3e3 friction "
            "0.2\nshear linear\nstep 1e-3\nperiodic cell -8 -8 to 8 8\n%s",
            more);
  struct placed placed = {.fraction = 0.5, .side = 16};
  for (int k = 0; k < DISCS; k++) {
    const double r = chance_scale(&chance, radii.least, radii.greatest), vx = chance_between(&chance, -5, 5);
    const double spin = chance_between(&chance, -9, 9), vy = chance_between(&chance, -5, 5);
    placed_find(&placed, &chance, -8, 8, r);
    const double x = placed.disc[k][0], y = placed.disc[k][1];
    const double to_x = 16 * round(chance_between(&copies, -3, 3)), to_y = 16 * round(chance_between(&copies, -3, 3));
    words_add(&page, "disc %.17g %.17g radius %.17g %s velocity %.17g %.17g spin %.17g\n", x + wander * to_x,
              y + wander * to_y, r, k % 3 ? "a" : "b", vx, vy, spin);
  }
  words_add(&page,
            "monitor A disc 1\nrecord A.x A.angle contacts cell.stress.xx cell.stress.xy cell.stress.yx "
            "energy.kinetic energy.balance work.balance momentum.x\nstage s\n%s\ncycles 3000\n",
            strain);
  written_scene(it, &page);
}

static const struct radii different = {0.2, 0.8}, similar = {0.35, 0.65}; /* similar discs are sorted by box: mesh.h */
static void gas(struct written *it, const char *strain, const char *more, int wander, unsigned seed) {
  gas_of(it, different, strain, more, wander, seed);
}

/* The gap between i and the nearest of all images of j within five sides. *count: number of images with a gap below
 * `within`. */
static double nearest(const struct nb_model *model, size_t i, size_t j, double within, int *count) {
  const struct nb_wrap wrap = nb_cell_wrap(model->cell);
  const struct nb_vec a = nb_wrapped(&wrap, model->particles.position[i]),
                      b = nb_wrapped(&wrap, model->particles.position[j]);
  double least = INFINITY;
  *count = 0;
  for (int m = -5; m <= 5; m++)
    for (int n = -5; n <= 5; n++) {
      const struct nb_vec apart = vec_sub(vec_add(b, tensor_times(wrap.h, vec(m, n))), a);
      const double gap = vec_length(apart) - model->particles.radius[i] - model->particles.radius[j];
      least = fmin(least, gap), *count += gap < within;
    }
  return least;
}

/* The gap of contact c, with the image that the contact stores. */
static double gap_of(const struct nb_model *model, size_t c) {
  const int i = model->contacts.a[c], j = model->contacts.b[c];
  const struct nb_vec shift = tensor_times(model->cell->h, model->contacts.image[c]);
  const struct nb_vec apart = vec_add(vec_sub(model->particles.position[j], model->particles.position[i]), shift);
  return vec_length(apart) - model->particles.radius[i] - model->particles.radius[j];
}

/* Every pair with a gap less than `within` must be listed once, with the image at this gap. Returns the number of these
 * pairs. */
static size_t compare(const struct nb_model *model, double within) {
  size_t wanted = 0;
  for (size_t k = 0; k < DISCS; k++)
    for (size_t l = k + 1; l < DISCS; l++) {
      int count;
      const size_t i = (size_t)model->particles.slot[k], j = (size_t)model->particles.slot[l];
      const double gap = nearest(model, i, j, within, &count);
      if (!(gap < within))
        continue;
      wanted++;
      const long c = nb_contacts_find(model, (int)i, (int)j, false);
      CU_ASSERT_EQUAL(count, 1);
      CU_ASSERT_FATAL(c >= 0);
      CU_ASSERT_DOUBLE_EQUAL(gap_of(model, (size_t)c), gap, 1e-11);
    }
  return wanted;
}

static void images_are_found(struct radii radii) {
  static const char *const strains[] = {"cell strain 0 0 c12 0.9", "cell strain 0.1 -0.1 shear 0.2",
                                        "cell strain -0.03 -0.05", "cell strain 0 0 c12 -0.7 c21 0.1"};
  for (unsigned s = 0; s < 4; s++)
    for (int shuffle = 0; shuffle < 2; shuffle++) {
      struct written it;
      struct nb_error error;
      gas_of(&it, radii, strains[s], "", s % 2, s + 1);
      struct nb_model *model = written_model(&it, &(struct nb_options){.threads = 1, .shuffle = shuffle});
      CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
      for (int round = 0; round < 12; round++) {
        CU_ASSERT_EQUAL_FATAL(nb_neighbours_search(model, &error), NB_OK);
        const size_t wanted = compare(model, model->search.skin);
        CU_ASSERT(wanted > 20 && wanted == model->contacts.count);
        for (int cycle = 0; cycle < 250; cycle++) {
          CU_ASSERT_EQUAL_FATAL(nb_cycle(model, &error), NB_OK);
          if (cycle % 25 == 24)
            CU_ASSERT(compare(model, 0) > 3); /* between searches: all pairs that touch */
        }
      }
      CU_ASSERT(model->search.count > 15 && model->search.count < 1500);
      nb_model_free(model);
      written_free(&it);
    }
}
static void all_images_are_found(void) { images_are_found(different); }
static void all_images_of_similar_discs_are_found(void) { images_are_found(similar); }

/* Forces, velocities and angles of the particles, by number, and the shear of the cell. */
static void outcome(const struct nb_model *model, double state[DISCS][8]) {
  for (size_t k = 0; k < DISCS; k++) {
    const size_t i = (size_t)model->particles.slot[k];
    const struct nb_force force = nb_force_on(model, i);
    const struct nb_vec v = nb_velocity_half(model, i).velocity;
    const double values[8] = {
        force.force.x,    force.force.y, force.moment, v.x, v.y, model->particles.spin[i], model->particles.angle[i],
        model->cell->h.xy};
    memcpy(state[k], values, sizeof values);
  }
}

static double wanted[DISCS][8], seen[DISCS][8];

static struct nb_model *run(const struct written *it, const struct nb_options *options, int cycles) {
  struct nb_error error;
  struct nb_model *model = nb_model_create(&it->scene, options, &error);
  if (!model)
    return NULL;
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it->scene.stages[0], &error), NB_OK);
  for (int cycle = 0; cycle < cycles; cycle++)
    CU_ASSERT_EQUAL_FATAL(nb_cycle(model, &error), NB_OK);
  return model;
}

/* A page may give any image of a particle: the results agree except for rounding errors, which grow with every
 * collision. */
static void another_image_changes_results_only_by_rounding(void) {
  for (int wander = 0; wander < 2; wander++) {
    struct written it;
    gas(&it, "cell strain 0.02 0 c12 0.3", "", wander, 7);
    struct nb_model *model = run(&it, NULL, 200);
    outcome(model, wander ? seen : wanted);
    CU_ASSERT(fabs(model->particles.position[0].x) > 0);
    nb_model_free(model);
    written_free(&it);
  }
  for (int k = 0; k < DISCS; k++)
    for (int v = 0; v < 8; v++)
      CU_ASSERT_DOUBLE_EQUAL(seen[k][v], wanted[k][v], 1e-8);
}

static void the_skin_changes_no_bit(void) {
  static const char *const skins[] = {"", "skin 1e-3\n", "skin 1\n"};
  unsigned long long searches[3];
  for (int s = 0; s < 3; s++) {
    struct written it;
    gas(&it, "cell strain 0.02 0 c12 0.9", skins[s], 1, 8);
    struct nb_model *model = run(&it, NULL, 1000);
    outcome(model, s ? seen : wanted);
    searches[s] = model->search.count;
    CU_ASSERT(!s || memcmp(seen, wanted, sizeof seen) == 0);
    nb_model_free(model);
    written_free(&it);
  }
  CU_ASSERT(searches[1] > 900 && searches[0] < 800 && searches[2] < 60);
}

static void storage_threads_and_instructions_change_no_bit(void) {
  static const struct nb_options all[] = {
      {.threads = 1, .isa = "plain"},  {.threads = 1, .shuffle = true}, {.threads = 2},
      {.threads = 7, .shuffle = true}, {.threads = 1, .isa = "avx2"},   {.threads = 2, .isa = "avx512"},
  };
  struct written it;
  gas(&it, "cell strain -0.01 0.02 c12 0.6", "", 0, 9);
  for (size_t o = 0; o < sizeof all / sizeof *all; o++) {
    struct nb_model *model = run(&it, &all[o], 500);
    if (!model) { /* this machine lacks the instructions */
      CU_ASSERT(o > 0 && all[o].isa);
      continue;
    }
    outcome(model, o ? seen : wanted);
    CU_ASSERT(!o || memcmp(seen, wanted, sizeof seen) == 0);
    nb_model_free(model);
  }
  written_free(&it);
}

/* Without forces the particles follow the strain: x = H s with constant s, where the columns of H are the sides of the
 * cell. They have no velocity of their own. */
static void a_strain_is_uniform(void) {
  struct written it;
  struct words page = {0};
  words_add(&page,
            "units none\nmaterial a density 1 kn 1\nperiodic cell 0 0 to 20 10\nlattice discs 4 by 2 from 3 3 radius 1 "
            "spacing 4 a\n"
            "disc 38 -5 radius 1 a\nstep 0.01\nmonitor A disc 9\nrecord A.x A.vx A.vx.half cell.xx cell.xy cell.yy "
            "cell.strain.xx cell.strain.xy energy.kinetic\nstage s\ncell strain 0.01 -0.02 c12 0.05\ncycles 100\n");
  written_scene(&it, &page);
  struct nb_model *model = run(&it, NULL, 100);
  const double xx = pow(1.0001, 100), yy = pow(0.9998, 100);
  double xy = 0;
  for (int n = 0; n < 100; n++)
    xy += 0.01 * (0.01 * xy + 0.05 * pow(0.9998, n));
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "cell.xx"), 20 * xx, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "cell.xy"), 10 * xy, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "cell.yy"), 10 * yy, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "cell.strain.xx"), xx - 1, 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "cell.strain.xy"), xy / 2, 1e-14);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.x"), 10 + xx * 28 - xy * 10, 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "A.vx"), 0.01 * xx * 28 - 10 * (0.01 * xy + 0.05 * yy), 1e-3);
  CU_ASSERT(fabs(written_now(model, "energy.kinetic")) < 1e-25);
  CU_ASSERT(model->search.count < 40);
  nb_model_free(model);
  written_free(&it);
}

/* The equivalent cell with the shortest sides has the same images, and its sides a and b satisfy |a.b| <= min(a^2,
 * b^2)/2. */
static void sheared_cells_are_set_upright(void) {
  struct chance chance = chance_begin(3);
  for (int k = 0; k < 2000; k++) {
    struct nb_cell cell = {.h = tensor(chance_between(&chance, 1, 3), chance_between(&chance, -90, 90),
                                       chance_between(&chance, -0.9, 0.9), chance_between(&chance, 1, 3))};
    if (fabs(tensor_determinant(cell.h)) < 0.1)
      continue;
    const struct nb_wrap wrap = nb_cell_wrap(&cell);
    const struct nb_tensor same = tensor_product(cell.h, wrap.multiples);
    CU_ASSERT_DOUBLE_EQUAL(fabs(tensor_determinant(wrap.multiples)), 1, 0);
    CU_ASSERT_DOUBLE_EQUAL(same.xx, wrap.h.xx, 1e-10);
    CU_ASSERT_DOUBLE_EQUAL(same.xy, wrap.h.xy, 1e-10);
    CU_ASSERT_DOUBLE_EQUAL(same.yx, wrap.h.yx, 1e-10);
    CU_ASSERT_DOUBLE_EQUAL(same.yy, wrap.h.yy, 1e-10);
    const struct nb_vec a = vec(wrap.h.xx, wrap.h.yx), b = vec(wrap.h.xy, wrap.h.yy);
    CU_ASSERT(fabs(vec_dot(a, b)) <= 0.5000001 * fmin(vec_dot(a, a), vec_dot(b, b)));
  }
}

/* `gap` is the smallest gap of all pairs. Images of particles count, and so do pairs that are not listed but have
 * approached since the search. The gap between two fixed particles does not count. */
static void the_gap_is_that_of_the_nearest_two(void) {
  struct written it;
  struct nb_model *model;
  for (int k = 0; k < 3; k++) { /* wherever the centre of the cell is */
    struct words across = {0};
    const double x = 3 * k, y = -7 * k;
    words_add(&across,
              "units none\nmaterial m density 1 kn 1\ndisc %g %g radius 0.25 m\ndisc %g %g radius 0.5 m\n"
              "periodic cell %g %g to %g %g\nskin 1\nrecord gap\nstep 0.01\nstage s\ncycles 1\n",
              x - 4.5, y + 0.25, x + 4.5, y + 0.25, x - 5, y - 5, x + 5, y + 5);
    written_scene(&it, &across);
    model = written_model(&it, NULL);
    CU_ASSERT_EQUAL(written_now(model, "gap"), 0.25);
    nb_model_free(model), written_free(&it);
  }
  /* A listed pair has the gap 0.05; another one, with the gap 0.11, is not listed and approaches to 0.03. */
  struct words near = {0};
  words_add(&near,
            "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\ndisc 2.05 0 radius 1 m\n"
            "disc 0 9 radius 1 m velocity 0.04 0\ndisc 2.11 9 radius 1 m velocity -0.04 0\nskin 0.1\nrecord gap\n"
            "step 1\nstage s\ncycles 1\n");
  written_scene(&it, &near);
  model = written_model(&it, NULL);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "gap"), 0.05, 1e-15);
  written_cycles(model, 1);
  CU_ASSERT_EQUAL(model->search.count, 1);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "gap"), 0.03, 1e-15);
  nb_model_free(model), written_free(&it);
  for (int fixed = 0; fixed < 2; fixed++) {
    struct words flies = {0};
    const char *const kind = fixed ? " fixed" : "";
    words_add(&flies,
              "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m velocity 1 0\ndisc 4 0 radius 1 m%s\n"
              "disc 4 3.75 radius 1 m%s\nskin 3\nrecord gap\nstep 0.125\nstage s\ncycles 4\n",
              kind, kind);
    written_scene(&it, &flies);
    model = written_model(&it, NULL);
    CU_ASSERT_EQUAL(written_now(model, "gap"), fixed ? 2 : 1.75);
    written_cycles(model, 4);
    CU_ASSERT_EQUAL(written_now(model, "gap"), 1.5);
    nb_model_free(model), written_free(&it);
  }
}

/* A stage that reverses the velocities and gives a strain rate has this rate, not the reversed one of the stage before. */
static void a_reversal_with_another_strain(void) {
  struct words page = {0};
  struct written it;
  struct nb_result result;
  words_add(&page, "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nperiodic cell -5 -5 to 5 5\nstep 0.25\n"
                   "record cell.xx\nstage s\ncell strain 0.5 0\ncycles 1\n"
                   "stage t\nreverse velocities\ncell strain 1 0\ncycles 1\n");
  written_scene(&it, &page);
  written_run(&result, &it, NULL);
  CU_ASSERT_EQUAL(written_last(&result, "cell.xx"), 10 * 1.125 * 1.25);
  nb_result_free(&result);
  written_free(&it);
}

/* A region that extends across the side of a cell has the images of the particles on the other side. */
static void regions_across_the_side_of_a_cell(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 1\ndisc 0.5 5 radius 0.25 m\ndisc 5 5 radius 0.25 m\n"
                   "periodic cell 0 0 to 10 10\nregion C circle 9.5 5 radius 2\nregion B box 8 4 to 11 6\n"
                   "record C.particles B.particles C.porosity B.porosity\nstep 0.1\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL(written_now(model, "C.particles"), 1);
  CU_ASSERT_EQUAL(written_now(model, "B.particles"), 1);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "C.porosity"), 1 - 1 / 64., 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(written_now(model, "B.porosity"), 1 - 3.14159265358979323846 / 16 / 6, 1e-15);
  nb_model_free(model), written_free(&it);
}

/* The smaller height of a parallelogram belongs to its longer side, whichever it is. */
static void the_width_is_the_smaller_height(void) {
  const struct nb_wrap first = {.h = tensor(4, 1, 3, 2)}, second = {.h = tensor(1, 4, 2, 3)}; /* sides (4, 3), (1, 2) */
  CU_ASSERT_DOUBLE_EQUAL(nb_wrap_width(&first), 1, 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(nb_wrap_width(&second), 1, 1e-15);
}

/* Two particles of radius 2 with an overlap of 0.1 press with 100 x 0.1 = 10 over the distance 3.9 of their centres, in a
 * volume of 20 x 20 times the thickness, which is 1 for discs and the diameter 4 for spheres. */
static void the_stress_of_a_cell_has_its_thickness(void) {
  static const struct {
    const char *kind;
    double thickness;
  } rows[] = {{"disc", 1}, {"sphere", 4}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words page = {0};
    struct written it;
    words_add(&page,
              "units none\nmaterial m density 1 kn 100\n%s 5 5 radius 2 m\n%s 8.9 5 radius 2 m\nperiodic cell 0 0 to "
              "20 20\nstep 0.001\nrecord cell.stress.xx\nstage s\ncycles 1\n",
              rows[k].kind, rows[k].kind);
    written_scene(&it, &page);
    struct nb_model *model = written_model(&it, NULL);
    CU_ASSERT_DOUBLE_EQUAL(written_now(model, "cell.stress.xx"), 10 * 3.9 / 400 / rows[k].thickness, 1e-14);
    nb_model_free(model), written_free(&it);
  }
}

void suite_cell(void) {
  CU_pSuite suite = CU_add_suite("cell", NULL, NULL);
  CU_ADD_TEST(suite, the_width_is_the_smaller_height);
  CU_ADD_TEST(suite, all_images_are_found);
  CU_ADD_TEST(suite, all_images_of_similar_discs_are_found);
  CU_ADD_TEST(suite, another_image_changes_results_only_by_rounding);
  CU_ADD_TEST(suite, the_skin_changes_no_bit);
  CU_ADD_TEST(suite, storage_threads_and_instructions_change_no_bit);
  CU_ADD_TEST(suite, a_strain_is_uniform);
  CU_ADD_TEST(suite, sheared_cells_are_set_upright);
  CU_ADD_TEST(suite, a_reversal_with_another_strain);
  CU_ADD_TEST(suite, regions_across_the_side_of_a_cell);
  CU_ADD_TEST(suite, the_gap_is_that_of_the_nearest_two);
  CU_ADD_TEST(suite, the_stress_of_a_cell_has_its_thickness);
}
