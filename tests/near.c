/* The neighbour list is compared with the distances of all pairs. Results must not depend on the cycles in which the
 * list was made.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <stdlib.h>
#include <string.h>

#include "../src/core/model.h"
#include "placed.h"
#include "suites.h"
#include "written.h"

enum { DISCS = 300 };

/* Writes a page with discs of different sizes and two materials in a square of side 20 with a corner at (x, y). Their
 * velocity components are at most `speed`. The discs hit each other and a moving wall, with friction. */
static void cloud(struct written *it, double x, double y, double speed, unsigned seed) {
  struct words page = {0};
  struct chance chance = chance_begin(seed);
  words_add(
      &page,
      "units none\nmaterial a density 1 kn 1e4 ks 8e3 friction 0.4\nmaterial b density 2 kn 3e4 ks 1e4 friction 0.2\n"
      "material c kn 1 ks 90 friction 0.3\npair a c kn 1e5\npair b c kn 1e5\n" /* so stiff that no disc crosses the wall */
      "shear linear\nstep 1e-4\nwall ramp %.17g %.17g to %.17g %.17g c velocity %.17g 0\n",
      x - 5, y - 5, x + 20, y - 0.8, speed);
  struct placed placed = {.fraction = 0.5};
  for (int k = 0; k < DISCS; k++) {
    const double *disc = placed.disc[k];
    placed_find(&placed, &chance, 0, 20, chance_scale(&chance, 0.2, 0.8));
    words_add(&page, "disc %.17g %.17g radius %.17g %s velocity %.17g %.17g spin %.17g%s\n", x + disc[0], y + disc[1],
              disc[2], k % 3 ? "a" : "b", chance_between(&chance, -speed, speed),
              chance_between(&chance, -speed, speed), chance_between(&chance, -9, 9), k % 20 == 7 ? " fixed" : "");
  }
  words_add(
      &page,
      "monitor A disc 1\nmonitor B disc 200\nrecord A.x A.y A.angle A.vx A.moment B.x B.y B.angle B.fx energy.kinetic "
      "contacts\nstage s\ncycles 300\n");
  written_scene(it, &page);
}

/* The gap between the surfaces of the particles i and j, or of particle i and wall j. */
static double gap(const struct nb_model *model, size_t i, size_t j, bool wall) {
  const struct nb_vec x = model->particles.position[i];
  if (!wall)
    return vec_length(vec_sub(model->particles.position[j], x)) - model->particles.radius[i] -
           model->particles.radius[j];
  const struct nb_vec p = model->walls.point[j], along = model->walls.along[j];
  const double s = fmin(fmax(vec_dot(vec_sub(x, p), along), model->walls.h1[j]), model->walls.h2[j]);
  return vec_length(vec_sub(vec_add(p, vec_scale(s, along)), x)) - model->particles.radius[i];
}

/* Asserts that the neighbour list has every pair with a gap below `within`, except pairs of fixed particles. The
 * particle with the smaller number must be the first one, and the material pair must be that of the two particles.
 * Returns the number of these pairs. */
static size_t compare(const struct nb_model *model, double within) {
  const struct nb_particles *particles = &model->particles;
  size_t wanted = 0;
  for (size_t i = 0; i < particles->count; i++) {
    for (size_t j = 0; j < particles->count; j++) {
      if (particles->number[j] <= particles->number[i] ||
          !(particles->inverse_mass[i] > 0 || particles->inverse_mass[j] > 0))
        continue;
      const long c = nb_contacts_find(model, (int)i, (int)j, false);
      if (gap(model, i, j, false) >= within)
        continue;
      wanted++;
      CU_ASSERT_FATAL(c >= 0);
      const struct nb_material_pair *material_pair = &model->material_pairs[model->contacts.material_pair[c]];
      const int a = particles->material[i], b = particles->material[j];
      CU_ASSERT(model->contacts.a[c] == (int)i && model->contacts.b[c] == (int)j);
      CU_ASSERT(!material_pair->wall && material_pair->a == (a < b ? a : b) && material_pair->b == (a < b ? b : a));
    }
    for (size_t w = 0; w < model->walls.count && particles->inverse_mass[i] > 0; w++)
      if (gap(model, i, w, true) < within) {
        wanted++;
        CU_ASSERT(nb_contacts_find(model, (int)i, (int)w, true) >= 0);
      }
  }
  return wanted;
}

/* A contact is found by its partners. Particles and walls are numbered separately, so a wall may have the number of a
 * particle. */
static void contacts_are_found_by_their_partners(void) {
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 1\nskin 0.2\nstep 0.1\nwall far 0 -9 to 1 -9 m\n"
                   "box 0 0 to 6.1 6.1 m\nlattice discs 3 by 3 m radius 1 spacing 2.05 from 1 1\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  for (int shuffle = 0; shuffle < 2; shuffle++) {
    struct nb_model *model = written_model(&it, &(struct nb_options){.threads = 1, .shuffle = shuffle});
    const struct nb_contacts *contacts = &model->contacts;
    size_t found = 0;
    for (int i = 0; i < (int)model->particles.count; i++)
      for (int wall = 0; wall < 2; wall++)
        for (int j = 0; j < (int)(wall ? model->walls.count : model->particles.count); j++) {
          long wanted = -1;
          for (size_t c = 0; c < contacts->count; c++)
            if (model->material_pairs[contacts->material_pair[c]].wall == wall &&
                ((contacts->a[c] == i && contacts->b[c] == j) || (!wall && contacts->a[c] == j && contacts->b[c] == i)))
              wanted = (long)c;
          if (wall || j != i)
            CU_ASSERT_EQUAL(nb_contacts_find(model, i, j, wall), wanted);
          found += wanted >= 0;
        }
    CU_ASSERT_EQUAL(contacts->count, 12 + 12);
    CU_ASSERT_EQUAL(found, 2 * 12 + 12); /* a contact of two particles is found from each of them */
    nb_model_free(model);
  }
  written_free(&it);
}

static void all_pairs_are_found(void) {
  static const double places[][2] = {{0, 0}, {-10, -10}, {1e6, -3e5}, {-4e8, 7e8}};
  for (unsigned p = 0; p < 4; p++)
    for (int shuffle = 0; shuffle < 2; shuffle++) {
      struct written it;
      cloud(&it, places[p][0], places[p][1], 1, p + 1);
      struct nb_model *model = written_model(&it, &(struct nb_options){.threads = 1, .shuffle = shuffle});
      const size_t wanted = compare(model, model->search.skin);
      CU_ASSERT(wanted > DISCS / 2 && wanted == model->contacts.count); /* these pairs and no others are listed */
      nb_model_free(model);
      written_free(&it);
    }
}

/* All pairs that touch are listed in every cycle, also in cycles without a search. */
static void touching_pairs_are_listed(void) {
  struct written it;
  cloud(&it, 1e3, -1e3, 5, 5);
  struct nb_model *model = written_model(&it, NULL);
  for (int cycle = 0; cycle < 120; cycle++) {
    written_cycles(model, 1);
    CU_ASSERT(compare(model, 0) > DISCS / 4);
  }
  CU_ASSERT(model->search.count > 3 && model->search.count < 100);
  nb_model_free(model);
  written_free(&it);
}

/* Discs of similar size. Alone they are sorted by box (core/mesh.h); with one more disc far away they are not. Both
 * searches find all pairs, and measure the same number of distances. */
static void similar_sizes(void) {
  enum { ALIKE = 400 };
  static const double places[][2] = {{0, 0}, {-1e6, 3e5}};
  for (int p = 0; p < 2; p++)
    for (int shuffle = 0; shuffle < 2; shuffle++) {
      size_t contacts[2];
      unsigned long long candidates[2];
      for (int far = 0; far < 2; far++) {
        struct words page = {0};
        struct chance chance = chance_begin(5);
        struct placed placed = {.fraction = 0.5};
        struct written it;
        words_add(&page, "units none\nmaterial a density 1 kn 1\nmaterial b density 2 kn 3\nstep 1e-6\nskin 0.2\n"
                         "wall w -9 -9 to 9 -9 a\n");
        for (int k = 0; k < ALIKE; k++) {
          placed_find(&placed, &chance, 0, 40, chance_scale(&chance, 0.7, 1));
          words_add(&page, "disc %.17g %.17g radius %.17g %s%s\n", places[p][0] + placed.disc[k][0],
                    places[p][1] + placed.disc[k][1], placed.disc[k][2], k % 3 ? "a" : "b", k % 9 ? "" : " fixed");
        }
        if (far)
          words_add(&page, "disc 4e9 0 radius 0.8 a fixed\n");
        words_add(&page, "record cycle\nstage s\ncycles 1\n");
        written_scene(&it, &page);
        struct nb_model *model = written_model(&it, &(struct nb_options){.threads = 1, .shuffle = shuffle});
        contacts[far] = model->contacts.count, candidates[far] = model->search.candidates;
        CU_ASSERT_EQUAL(compare(model, model->search.skin), contacts[far]);
        nb_model_free(model);
        written_free(&it);
      }
      CU_ASSERT(contacts[0] > ALIKE / 2 && contacts[0] == contacts[1]);
      CU_ASSERT(candidates[0] > contacts[0] && candidates[0] == candidates[1]);
    }
}

/* Five large discs among small ones, with radii from 30 to 0.01. The search must find all pairs and compute few
 * distances. With boxes as wide as the largest disc, it would compute the distances of every small disc to hundreds of
 * others. */
static void different_sizes(void) {
  enum { SMALL = 1500 };
  struct words page = {0};
  struct chance chance = chance_begin(11);
  struct written it;
  words_add(&page, "units none\nmaterial a density 1 kn 100\nstep 1e-6\nskin 0.02\n");
  struct placed placed = {
      .fraction = 0.9, .count = 5, .disc = {{0, 0, 12}, {26, -6, 12}, {40, 42, 30}, {60, -8, 12}, {-8, 60, 12}}};
  for (int k = 5; k < 5 + SMALL; k++)
    placed_find(&placed, &chance, 0, 60, chance_scale(&chance, 0.01, 1));
  for (int k = 0; k < 5 + SMALL; k++)
    words_add(&page, "disc %.17g %.17g radius %.17g a\n", placed.disc[k][0], placed.disc[k][1], placed.disc[k][2]);
  words_add(&page, "record cycle\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  for (int shuffle = 0; shuffle < 2; shuffle++) {
    struct nb_model *model = written_model(&it, &(struct nb_options){.threads = 1, .shuffle = shuffle});
    CU_ASSERT_EQUAL(model->search.skin, 0.02);
    const size_t wanted = compare(model, model->search.skin);
    CU_ASSERT(wanted > SMALL / 5 && wanted == model->contacts.count);
    /* at most the distances of each large disc to all small ones, and of each small disc to seven neighbours */
    if (!(model->search.candidates < 5 * SMALL + 7 * SMALL))
      printf("# %llu candidates for %zu pairs\n", model->search.candidates, wanted);
    CU_ASSERT(model->search.candidates < 5 * SMALL + 7 * SMALL);
    nb_model_free(model);
  }
  written_free(&it);
}

/* Returns the number of searches in 400 cycles. `candidates` becomes the number of distances between particles that
 * these searches computed. */
static unsigned long long searches_of(const char *statements, unsigned long long *candidates) {
  struct words page = {0};
  struct written it;
  words_add(&page,
            "units none\nmaterial m density 1 kn 10\nstep 0.01\n%s\nmonitor D disc 1\nrecord D.x D.y\nstage s\n"
            "cycles 400\n",
            statements);
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  written_cycles(model, 400);
  const unsigned long long searches = model->search.count;
  *candidates = model->search.candidates;
  nb_model_free(model);
  written_free(&it);
  return searches;
}

/* There is no search if the scene has a single particle and no wall, or fixed particles only. There is one search for
 * two particles at rest; it computes one distance. Contacts with a wall need more searches when the particle or the wall
 * moves, but no distances between particles. */
static void no_search_without_need(void) {
  unsigned long long candidates;
  CU_ASSERT_EQUAL(searches_of("disc 0 0 radius 1 m velocity 9 9", &candidates), 0);
  CU_ASSERT_EQUAL(searches_of("disc 0 0 radius 1 m velocity 9 9 fixed\ndisc 5 0 radius 1 m fixed\nwall w 0 9 to 9 9 m",
                              &candidates),
                  0);
  CU_ASSERT_EQUAL(candidates, 0);
  CU_ASSERT_EQUAL(searches_of("disc 0 0 radius 1 m\ndisc 2.01 0 radius 1 m", &candidates), 1);
  CU_ASSERT_EQUAL(candidates, 1);
  CU_ASSERT(searches_of("disc 0 0 radius 1 m velocity 1 0\nwall w 9 9 to 9 -9 m", &candidates) > 10);
  CU_ASSERT_EQUAL(candidates, 0);
  const unsigned long long wide =
      searches_of("skin 8\ndisc 0 0 radius 1 m velocity 1 0\nwall w 9 9 to 9 -9 m", &candidates);
  CU_ASSERT_EQUAL(wide, 1);
  CU_ASSERT(searches_of("disc 0 0 radius 1 m\nwall w 9 9 to 9 -9 m spin 1", &candidates) > 100);
  /* A disc or a wall that moves by 0.01 per cycle is beyond half of a skin of 0.07 in every fourth cycle. */
  CU_ASSERT_EQUAL(searches_of("skin 0.07\ndisc 0 0 radius 1 m velocity 1 0\nwall w 9 9 to 9 -9 m", &candidates), 101);
  CU_ASSERT_EQUAL(searches_of("skin 0.07\ndisc 0 0 radius 1 m\nwall w 9 9 to 9 -9 m velocity 1 0", &candidates), 101);
}

/* ---- the same bits ---- */

/* Copies the positions, velocities and forces to `state`, in the order of particle numbers. Frees the model. */
static void outcome(struct nb_model *model, double state[DISCS][8]) {
  for (size_t k = 0; k < DISCS; k++) {
    const size_t i = (size_t)model->particles.slot[k];
    const struct nb_force force = nb_force_on(model, i);
    const double values[8] = {model->particles.position[i].x,
                              model->particles.position[i].y,
                              model->particles.angle[i],
                              model->particles.velocity[i].x,
                              model->particles.velocity[i].y,
                              force.force.x,
                              force.force.y,
                              force.moment};
    memcpy(state[k], values, sizeof values);
  }
  nb_model_free(model);
}

static double wanted[DISCS][8], seen[DISCS][8];

/* With a wide skin searches are rare, with a narrow one they happen in nearly every cycle. Contact histories must
 * survive every search. */
static void the_skin_changes_no_bit(void) {
  static const double skins[] = {0.1, 1e-3, 3};
  unsigned long long searches[3];
  struct written it;
  cloud(&it, 50, 50, 5, 6);
  for (int s = 0; s < 3; s++) {
    struct nb_error error;
    struct nb_model *model = written_model(&it, NULL);
    model->search.skin = skins[s];
    CU_ASSERT_EQUAL_FATAL(nb_neighbours_search(model, &error), NB_OK);
    nb_forces(model);
    written_cycles(model, 300);
    searches[s] = model->search.count;
    outcome(model, s ? seen : wanted);
    if (s)
      CU_ASSERT(memcmp(seen, wanted, sizeof seen) == 0);
  }
  CU_ASSERT(searches[1] > 4 * searches[0] && searches[0] > searches[2]);
  written_free(&it);
}

/* The histories of normal and shear laws survive searches: forces have the same bits after many searches as after one. */
static void histories_survive_searches(void) {
  static const char *const laws[] = {"normal hertz_increment\nshear mindlin\n",
                                     "normal hertz_increment\nshear mindlin_deresiewicz\n"};
  for (size_t n = 0; n < sizeof laws / sizeof *laws; n++) {
    double forces[2][2];
    for (int often = 0; often < 2; often++) {
      struct words page = {0};
      struct written it;
      words_add(
          &page,
          "units none\nmaterial m density 1 young 100 poisson 0.25 friction 0.4\n%ssphere 0 0 radius 1 m velocity "
          "1 0.3\nsphere 2 0 radius 1 m\nsphere 9 9 radius 1 m velocity 5 5\nmonitor C sphere 1 with sphere 2\n"
          "record C.normal C.shear\nskin %g\nstep 0.002\nstage s\ncycles 100\n",
          laws[n], often ? 0.03 : 30.);
      written_scene(&it, &page);
      struct nb_model *model = written_model(&it, NULL);
      written_cycles(model, 100);
      forces[often][0] = written_now(model, "C.normal"), forces[often][1] = written_now(model, "C.shear");
      CU_ASSERT(often ? model->search.count > 50 : model->search.count == 1);
      nb_model_free(model);
      written_free(&it);
    }
    for (int k = 0; k < 2; k++) {
      CU_ASSERT_NOT_EQUAL(forces[0][k], 0);
      CU_ASSERT_EQUAL(forces[0][k], forces[1][k]);
    }
  }
}

static void storage_threads_and_instructions_change_no_bit(void) {
  static const struct nb_options all[] = {
      {.threads = 1, .isa = "plain"}, {.threads = 1, .shuffle = true}, {.threads = 2}, {.threads = 7, .shuffle = true},
      {.threads = 1, .isa = "avx2"},  {.threads = 2, .isa = "avx512"}, {.threads = 0},
  };
  struct written it;
  cloud(&it, -70, 30, 5, 7);
  for (size_t o = 0; o < sizeof all / sizeof *all; o++) {
    struct nb_error error;
    struct nb_model *model = nb_model_create(&it.scene, &all[o], &error);
    if (!model) { /* allowed only if this machine lacks the instruction set */
      CU_ASSERT(o > 0 && all[o].isa && strstr(error.text, all[o].isa));
      continue;
    }
    written_cycles(model, 300);
    outcome(model, o ? seen : wanted);
    if (o && memcmp(seen, wanted, sizeof seen) != 0) {
      printf("# options %zu\n", o);
      CU_FAIL("other bits");
    }
  }
  written_free(&it);
}

/* The rank of a particle's partner at a contact. Particles are ranked by their numbers; walls come after all particles.
 * `slot` is the particle's index. */
static int rank_of_partner(const struct nb_model *model, int contact, int slot) {
  const int a = model->contacts.a[contact], b = model->contacts.b[contact];
  const struct nb_neighbour_pair pair = {a, b, model->contacts.material_pair[contact]};
  return a == slot ? nb_partner_rank(model, pair) : model->particles.number[a];
}

/* Two large discs with 40 and 20 neighbours, numbers that the sort of a batch (incidence.c) does not distinguish, and a row
 * of discs with at most two neighbours each, which fills several batches. */
enum { RING = 62, ROW = 700, LARGE_AND_SMALL = RING + ROW };
static void large_and_small(struct written *it) {
  struct words page = {0};
  words_add(&page, "units none\nmaterial m density 1 kn 1 ks 1 friction 0.5\nwall W -9 -11 to 9 -11 m\n"
                   "disc 0 0 radius 10 m\ndisc 40 0 radius 10 m\n");
  for (int k = 0; k < 60; k++) {
    const double turn = k < 40 ? NB_PI / 20 * k : NB_PI / 10 * k;
    words_add(&page, "disc %.12g %.12g radius 0.8 m\n", (k < 40 ? 0 : 40) + 10.8 * cos(turn), 10.8 * sin(turn));
  }
  for (int k = 0; k < ROW; k++)
    words_add(&page, "disc %d 30 radius 0.5 m\n", k);
  words_add(&page, "step 1e-3\nrecord time\nstage s\ncycles 1\n");
  written_scene(it, &page);
}

/* Each particle lists its contacts in the order of its partners' numbers, and the motion sums the forces of exactly
 * these contacts. */
static void each_particle_sums_its_contacts(void) {
  struct written it;
  large_and_small(&it);
  for (int threads = 1; threads <= 3; threads += 2) {
    struct nb_model *model = written_model(&it, &(struct nb_options){.threads = threads, .shuffle = threads > 1});
    struct nb_particles *particles = &model->particles;
    struct nb_vec before[LARGE_AND_SMALL];
    size_t entries = 0, most = 0;
    CU_ASSERT_EQUAL_FATAL(particles->count, LARGE_AND_SMALL);
    CU_ASSERT(model->contacts.incidence.batches >= (size_t)threads);
    for (size_t c = 0; c < model->contacts.count; c++)
      model->contacts.force[c] = (struct nb_contact_force){.x = sin((double)c), .y = cos((double)c)};
    for (int i = 0; i < LARGE_AND_SMALL; i++) {
      const struct nb_contact_range range = nb_contact_range(&model->contacts.incidence, (size_t)i);
      const size_t count = (size_t)(range.end - range.first);
      entries += count, most = count > most ? count : most;
      for (const int *entry = range.first; entry < range.end; entry++) {
        CU_ASSERT_EQUAL(model->contacts.a[*entry] == i, entry >= range.middle);
        CU_ASSERT(entry == range.first || rank_of_partner(model, entry[-1], i) < rank_of_partner(model, *entry, i));
      }
      before[i] = particles->velocity[i];
    }
    CU_ASSERT(most > 30);
    CU_ASSERT_EQUAL(entries, model->contacts.count + model->contacts.wall_from);
    for (int part = 0; part < threads; part++)
      nb_motion_part(model, part, threads);
    for (size_t i = 0; i < LARGE_AND_SMALL; i++) {
      const double kick = model->step / 2 * particles->inverse_mass[i];
      const struct nb_vec force = nb_force_on(model, i).force;
      CU_ASSERT_EQUAL(particles->velocity[i].x, before[i].x + kick * force.x);
      CU_ASSERT_EQUAL(particles->velocity[i].y, before[i].y + kick * force.y);
    }
    nb_model_free(model);
  }
  written_free(&it);
}

/* A saved list of pairs is restored. This fails if any of its three pairs has a particle, a wall or a material pair that
 * the model does not have. There are more walls than particles. */
static void restored_pairs_exist(void) {
  static const struct nb_neighbour_pair invalid[] = {{0, 3, 0},  {3, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 1, 2},
                                                     {0, 1, -1}, {0, 5, 1}, {3, 0, 1},  {0, -1, 1}};
  struct words page = {0};
  struct written it;
  words_add(&page, "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\ndisc 2 0 radius 1 m\n"
                   "disc 4 0 radius 1 m\nwall a 9 0 to 9 1 m\nwall b 9 2 to 9 3 m\nwall c 9 4 to 9 5 m\n"
                   "wall d 9 6 to 9 7 m\nwall e 9 8 to 9 9 m\nstep 1e-3\nrecord time\nstage s\ncycles 1\n");
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL(model->material_pair_count, 2);
  CU_ASSERT(!model->material_pairs[0].wall && model->material_pairs[1].wall);
  for (size_t k = 0; k <= sizeof invalid / sizeof *invalid; k++)
    for (size_t at = 0; at < 3; at++) {
      struct nb_neighbour_pair list[3] = {{0}};
      struct nb_neighbour_pairs pairs = {list, 3}, restored = {NULL, 0};
      for (size_t p = 0; p < 3; p++)
        list[p] = p == at ? (struct nb_neighbour_pair){0, 4, 1} : (struct nb_neighbour_pair){0, 1, 0};
      if (k > 0)
        list[at] = invalid[k - 1];
      struct nb_store store = {0};
      nb_pairs_store(&store, "pairs", &pairs, model);
      store.restoring = true;
      nb_pairs_store(&store, "pairs", &restored, model);
      CU_ASSERT_EQUAL(store.failed, k > 0);
      CU_ASSERT_EQUAL(restored.count, 3);
      free(restored.list);
      nb_store_free(&store);
    }
  nb_model_free(model);
  written_free(&it);
}

void suite_near(void) {
  CU_pSuite suite = CU_add_suite("near", NULL, NULL);
  CU_add_test(suite, "all pairs are found, and no others", all_pairs_are_found);
  CU_add_test(suite, "each particle sums its contacts, in the order of numbers", each_particle_sums_its_contacts);
  CU_add_test(suite, "restored pairs exist", restored_pairs_exist);
  CU_add_test(suite, "contacts are found by their partners", contacts_are_found_by_their_partners);
  CU_add_test(suite, "pairs that touch are listed", touching_pairs_are_listed);
  CU_add_test(suite, "similar sizes, with and without a distant disc", similar_sizes);
  CU_add_test(suite, "a few large discs among many small ones", different_sizes);
  CU_add_test(suite, "no search without need", no_search_without_need);
  CU_add_test(suite, "the skin changes no bit", the_skin_changes_no_bit);
  CU_add_test(suite, "histories survive searches", histories_survive_searches);
  CU_add_test(suite, "storage, threads and instructions change no bit", storage_threads_and_instructions_change_no_bit);
}
