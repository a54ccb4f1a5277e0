/* The geometry passes, which compute the kinematics of contacts: their results are compared with [CS79 8-15] computed
 * in long double. The last test checks the pass that computes forces.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <stdlib.h>
#include <string.h>

#include "../src/core/model.h"
#include "chance.h"
#include "core/cell.h"
#include "pass/pass.h"
#include "suites.h"

enum { N = NB_BLOCK_SIZE };

/* The input and output of a geometry pass, without a scene. */
struct bench {
  struct nb_model model;
  struct nb_vec position[2 * N], velocity[2 * N];
  double radius[2 * N], surface_speed[2 * N];
  struct nb_vec pivot[N], point[N], along[N], wall_velocity[N], wall_turn[N];
  double h1[N], h2[N];
  int a[N], b[N];
  _Alignas(64) double f[NB_FIELDS][N];
  struct nb_material_pair material_pair;
  struct nb_block block;
  bool began;
};

static struct bench *bench_create(bool wall) {
  struct bench *it = calloc(1, sizeof *it);
  CU_ASSERT_PTR_NOT_NULL_FATAL(it);
  it->model.particles = (struct nb_particles){.count = 2 * N,
                                              .position = it->position,
                                              .velocity = it->velocity,
                                              .radius = it->radius,
                                              .surface_speed = it->surface_speed};
  it->model.walls = (struct nb_walls){.count = N,
                                      .pivot = it->pivot,
                                      .point = it->point,
                                      .along = it->along,
                                      .h1 = it->h1,
                                      .h2 = it->h2,
                                      .velocity = it->wall_velocity,
                                      .turn = it->wall_turn};
  it->material_pair.wall = wall;
  it->block =
      (struct nb_block){.n = N, .a = it->a, .b = it->b, .began = &it->began, .material_pair = &it->material_pair};
  for (int f = 0; f < NB_FIELDS; f++)
    it->block.f[f] = it->f[f];
  return it;
}

/* Fills the input of each contact c with discs 2c and 2c + 1, or with disc 2c and wall c. The two partners are near
 * each other and far from the origin. */
static void bench_fill(struct bench *it, unsigned seed) {
  struct chance chance = chance_begin(seed);
  it->model.previous_step = chance_scale(&chance, 1e-6, 1e-2);
  for (int c = 0; c < N; c++) {
    const double x = chance_between(&chance, -1e3, 1e3), y = chance_between(&chance, -1e3, 1e3);
    const double turn = chance_between(&chance, 0, 6.283), reach = chance_between(&chance, 0.3, 1.3);
    it->a[c] = 2 * c, it->b[c] = it->material_pair.wall ? c : 2 * c + 1;
    for (int k = 2 * c; k < 2 * c + 2; k++) {
      const double radius = chance_scale(&chance, 0.1, 10), spin = chance_between(&chance, -3, 3);
      it->radius[k] = radius, it->surface_speed[k] = spin * radius;
      it->velocity[k] = vec(chance_between(&chance, -2, 2), chance_between(&chance, -2, 2));
      it->wall_velocity[c] = vec(chance_between(&chance, -2, 2), chance_between(&chance, -2, 2));
    }
    it->f[NB_RADIUS_SUM][c] = it->radius[2 * c] + (it->material_pair.wall ? 0 : it->radius[2 * c + 1]);
    const struct nb_vec faster = vec_sub(it->velocity[2 * c], it->velocity[2 * c + 1]);
    const double dn = vec_dot(faster, vec(cos(turn), sin(turn))) * it->model.previous_step;
    const double since = chance_between(&chance, 0.1, 0.9); /* every fourth approaching pair has touched in this step */
    const double apart = c % 4 == 0 && dn > 0 ? it->f[NB_RADIUS_SUM][c] - since * dn : reach * it->f[NB_RADIUS_SUM][c];
    it->position[2 * c] = vec(x, y);
    it->position[2 * c + 1] = vec(x + apart * cos(turn), y + apart * sin(turn));
    it->along[c] = vec(-sin(turn), cos(turn));
    const double length = it->radius[2 * c], where = chance_between(&chance, -2, 2) * length;
    it->h1[c] = -length, it->h2[c] = chance_between(&chance, 0.2, 1) * length;
    it->point[c] = vec_add(it->position[2 * c + 1], vec_scale(where, it->along[c]));
    it->pivot[c] = vec_add(it->point[c], vec_scale(chance_between(&chance, -2, 2), vec_clockwise(it->along[c])));
    it->wall_turn[c] = vec(c % 3 ? chance_between(&chance, 0, 1) : 0, c % 3 ? chance_between(&chance, -3, 3) : 0);
  }
}

/* Whether a computed value differs from the expected one by rounding errors only. The rounded numbers have the sizes
 * of `expected` and `scale`. */
static bool near(double computed, long double expected, double scale) {
  return fabsl(computed - expected) <= 16 * 2.2e-16L * (fabsl(expected) + scale);
}

/* Compares contact c with [CS79 8-15] for disc 2c and a partner at q with the radius `other`, the velocity u and the
 * surface speed `turning`. The partner is another disc, or the nearest point of a wall, whose radius is 0. */
static void compare(const struct bench *it, int c, const long double q[2], const long double u[2], long double other,
                    long double turning) {
  const struct nb_vec x = it->position[2 * c], v = it->velocity[2 * c];
  const long double dx = q[0] - x.x, dy = q[1] - x.y, distance = sqrtl(dx * dx + dy * dy);
  const long double e1 = dx / distance, e2 = dy / distance, t1 = e2, t2 = -e1;
  const long double rx = v.x - u[0], ry = v.y - u[1], dt = it->model.previous_step;
  const long double overlap = it->radius[2 * c] + other - distance;
  const double blur = 2000 / (double)distance; /* size of the rounded coordinates over the distance */
  CU_ASSERT(near(it->f[NB_OVERLAP][c], overlap > 0 ? overlap : 0, 2000));
  CU_ASSERT(near(it->f[NB_EX][c], e1, blur) && near(it->f[NB_EY][c], e2, blur));
  const long double dn = (rx * e1 + ry * e2) * dt,
                    slip = (rx * t1 + ry * t2 - (it->surface_speed[2 * c] + turning)) * dt;
  CU_ASSERT(near(it->f[NB_NORMAL_INCREMENT][c], dn, 8 * (1 + blur) * (double)dt));
  const bool met = overlap > 0 && overlap < dn; /* first touch in the last step: only the slip after it counts */
  const double fraction = met ? (double)(overlap / dn) : 1, share_blur = met ? 2000 / (double)dn : 0;
  CU_ASSERT(near(it->f[NB_TANGENTIAL_INCREMENT][c], fraction * slip,
                 80 * (1 + blur) * (double)dt + share_blur * fabs((double)slip)));
}

static void disc_disc(void) {
  struct bench *it = bench_create(false);
  int touching = 0, met = 0;
  for (unsigned seed = 1; seed <= 8; seed++) {
    bench_fill(it, seed);
    nb_pass_disc_disc[NB_APPROACH_TANGENTIAL].run[NB_PLAIN](&it->model, &it->block);
    for (int c = 0; c < N; c++) {
      const struct nb_vec y = it->position[2 * c + 1], u = it->velocity[2 * c + 1];
      compare(it, c, (long double[]){y.x, y.y}, (long double[]){u.x, u.y}, it->radius[2 * c + 1],
              it->surface_speed[2 * c + 1]);
      touching += it->f[NB_OVERLAP][c] > 0;
      met += nb_touch_began(it->f[NB_OVERLAP][c], it->f[NB_NORMAL_INCREMENT][c]);
    }
  }
  CU_ASSERT(touching > 2 * N && touching < 8 * N);
  CU_ASSERT(met > N / 2);
  free(it);
}

static void disc_wall(void) {
  struct bench *it = bench_create(true);
  int inside = 0, first = 0, second = 0;
  for (unsigned seed = 1; seed <= 8; seed++) {
    bench_fill(it, seed);
    nb_pass_disc_wall[NB_APPROACH_TANGENTIAL].run[NB_PLAIN](&it->model, &it->block);
    for (int c = 0; c < N; c++) {
      const struct nb_vec x = it->position[2 * c], p = it->point[c], along = it->along[c], u = it->wall_velocity[c];
      long double h = ((long double)x.x - p.x) * along.x + ((long double)x.y - p.y) * along.y;
      first += h<it->h1[c], second += h> it->h2[c], inside += h > it->h1[c] && h < it->h2[c];
      h = h < it->h1[c] ? it->h1[c] : h > it->h2[c] ? it->h2[c] : h;
      const struct nb_vec turn = it->wall_turn[c];
      const long double q[2] = {p.x + h * along.x, p.y + h * along.y};
      const long double arm[2] = {q[0] - it->pivot[c].x, q[1] - it->pivot[c].y};
      const long double turning[2] = {turn.x * arm[0] - turn.y * arm[1], turn.y * arm[0] + turn.x * arm[1]};
      compare(it, c, q, (long double[]){u.x + turning[0], u.y + turning[1]}, 0, 0);
    }
  }
  CU_ASSERT(inside > N && first > N && second > N);
  free(it);
}

/* A form of a pass that computes fewer quantities gives the same bits for the quantities that it computes. */
static void forms_agree(void) {
  for (int wall = 0; wall < 2; wall++) {
    struct bench *all = bench_create(wall), *some = bench_create(wall);
    const struct nb_pass *passes = wall ? nb_pass_disc_wall : nb_pass_disc_disc;
    bench_fill(all, 9), bench_fill(some, 9);
    passes[NB_APPROACH_TANGENTIAL].run[NB_PLAIN](&all->model, &all->block);
    for (int approach = 0; approach <= NB_APPROACH_TANGENTIAL; approach++) {
      passes[approach].run[NB_PLAIN](&some->model, &some->block);
      for (int c = 0; c < N; c++) {
        CU_ASSERT(some->f[NB_OVERLAP][c] == all->f[NB_OVERLAP][c] && some->f[NB_EX][c] == all->f[NB_EX][c]);
        CU_ASSERT(some->f[NB_EY][c] == all->f[NB_EY][c]);
        CU_ASSERT(some->f[NB_NORMAL_INCREMENT][c] ==
                  (approach >= NB_APPROACH_NORMAL ? all->f[NB_NORMAL_INCREMENT][c] : 0));
        CU_ASSERT(some->f[NB_TANGENTIAL_INCREMENT][c] ==
                  (approach >= NB_APPROACH_TANGENTIAL ? all->f[NB_TANGENTIAL_INCREMENT][c] : 0));
      }
    }
    free(all), free(some);
  }
}

/* A pass gives the same bits with every instruction set of this machine, for any number of contacts. It writes nothing
 * after the last contact. */
static void instruction_sets_agree(void) {
  static const struct nb_pass *const kinds[] = {nb_pass_disc_disc, nb_pass_periodic, nb_pass_disc_wall};
  static struct nb_vec image[N];
  struct nb_cell cell = {.h = tensor(3, 0.2, -0.3, 2), .image_velocity = tensor(0.1, 0.7, -0.4, 0.3)};
  struct chance chance = chance_begin(11);
  struct nb_error error;
  for (int c = 0; c < N; c++)
    image[c] = vec(floor(chance_between(&chance, -1, 2)), floor(chance_between(&chance, -1, 2)));
  int met = 0;
  for (int kind = 0; kind < 3; kind++) {
    struct bench *plain = bench_create(kind == 2), *it = bench_create(kind == 2);
    CU_ASSERT_FATAL(nb_machine_choose(&it->model, NULL, &error) == NB_OK);
    for (int n = 1; n <= N; n++)
      for (int approach = 0; approach <= NB_APPROACH_TANGENTIAL; approach++)
        for (enum nb_isa isa = NB_PLAIN; isa <= it->model.machine.isa; isa++) {
          memset(plain->f, 0x55, sizeof plain->f), memset(it->f, 0x55, sizeof it->f);
          bench_fill(plain, (unsigned)n), bench_fill(it, (unsigned)n);
          for (int c = 0; c < N && kind == 1; c++) { /* the second disc is near as an image */
            const struct nb_vec moved = vec_sub(plain->position[2 * c + 1], tensor_times(cell.h, image[c]));
            plain->position[2 * c + 1] = it->position[2 * c + 1] = moved;
          }
          for (int c = 0; c < N && kind < 2; c += 3) /* exchange the two discs of every third pair */
            plain->a[c] = it->a[c] = 2 * c + 1, plain->b[c] = it->b[c] = 2 * c;
          plain->model.cell = it->model.cell = &cell;
          plain->block.image = it->block.image = image;
          plain->block.n = it->block.n = (size_t)n;
          kinds[kind][approach].run[NB_PLAIN](&plain->model, &plain->block);
          kinds[kind][approach].run[isa](&it->model, &it->block);
          CU_ASSERT(memcmp(plain->f, it->f, sizeof it->f) == 0);
          for (int c = 0; c < n && approach == NB_APPROACH_TANGENTIAL; c++)
            met += nb_touch_began(it->f[NB_OVERLAP][c], it->f[NB_NORMAL_INCREMENT][c]);
        }
    free(plain), free(it);
  }
  CU_ASSERT(met > N);
}

/* Disc 1 is to the left of disc 2, so e points in +x, and t, clockwise of e, points in -y. The tangential increment has
 * the signs of [CS79 15]. */
static void signs_of_slip(void) {
  struct bench *it = bench_create(false);
  it->block.n = 4;
  it->model.previous_step = 1;
  for (int c = 0; c < 4; c++) {
    it->a[c] = 2 * c, it->b[c] = 2 * c + 1;
    it->position[2 * c + 1] = vec(2, 0);
    it->radius[2 * c] = it->radius[2 * c + 1] = 1;
    it->surface_speed[2 * c] = it->surface_speed[2 * c + 1] = 0;
  }
  it->velocity[0] = vec(0, -3); /* disc 1 moves in -y, along t */
  it->velocity[3] = vec(0, 3);  /* disc 2 moves in +y: the same slip */
  it->surface_speed[4] = 5;     /* disc 1 rotates counterclockwise: its surface moves in +y at the contact */
  it->surface_speed[7] = 5;     /* disc 2 rotates counterclockwise: its surface moves in -y there */
  nb_pass_disc_disc[NB_APPROACH_TANGENTIAL].run[NB_PLAIN](&it->model, &it->block);
  CU_ASSERT(it->f[NB_TANGENTIAL_INCREMENT][0] == 3 && it->f[NB_TANGENTIAL_INCREMENT][1] == 3);
  CU_ASSERT(it->f[NB_TANGENTIAL_INCREMENT][2] == -5 && it->f[NB_TANGENTIAL_INCREMENT][3] == -5);
  free(it);
}

/* The force on the first disc is -(F_n e + F_s t), with and without a shear force. [CS79, The force-displacement law] */
static void force_in_components(void) {
  static struct nb_contact_force force[N];
  struct bench *it = bench_create(false);
  struct chance chance = chance_begin(10);
  it->block.force = force;
  for (int shear = 0; shear < 2; shear++) {
    for (int c = 0; c < N; c++) {
      const double turn = chance_between(&chance, 0, 6.283);
      it->f[NB_EX][c] = cos(turn), it->f[NB_EY][c] = sin(turn);
      it->f[NB_TOTAL_NORMAL][c] = chance_between(&chance, -9, 9);
      it->f[NB_TOTAL_SHEAR][c] = shear ? chance_between(&chance, -9, 9) : NAN; /* must not be read */
    }
    nb_pass_resolve[shear].run[NB_PLAIN](&it->model, &it->block);
    for (int c = 0; c < N; c++) {
      const long double e1 = it->f[NB_EX][c], e2 = it->f[NB_EY][c], fn = it->f[NB_TOTAL_NORMAL][c];
      const long double fs = shear ? it->f[NB_TOTAL_SHEAR][c] : 0;
      CU_ASSERT(near(force[c].x, -(fn * e1 + fs * e2), 9) && near(force[c].y, -(fn * e2 - fs * e1), 9));
      CU_ASSERT_EQUAL(force[c].shear, (double)fs);
    }
  }
  free(it);
}

void suite_kinematics(void) {
  CU_pSuite suite = CU_add_suite("kinematics", NULL, NULL);
  CU_add_test(suite, "disc and disc", disc_disc);
  CU_add_test(suite, "disc and wall, inside and at both ends", disc_wall);
  CU_add_test(suite, "forms with fewer quantities agree", forms_agree);
  CU_add_test(suite, "instruction sets agree", instruction_sets_agree);
  CU_add_test(suite, "signs of slip", signs_of_slip);
  CU_add_test(suite, "force in components", force_in_components);
}
