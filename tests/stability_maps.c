/* Maps of stability, written by `make stability`: the steps at which the calculation cycle is stable, inaccurate or
 * unstable.
 *
 * stability_maps -o DOCUMENT FOLDER   writes docs/STABILITY.md, and one table per system into the folder
 * stability_maps                      tests a few columns of each system, also with planted errors that it must detect
 *
 * A column of a map is one system with one mass ratio, stiffness ratio and damping. Its limit is the step at which the
 * largest eigenvalue of dt^2 K + 2 dt C equals 4 (cases/refs/limit.c). Its points are steps, as fractions of the limit.
 * At each point the library runs an assembly that is at rest, except for a perturbation:
 *
 *   unstable     the perturbation grows. At first it moves particles by about 1e-9 R in a cycle. Later the changes of
 *                velocity in a cycle become more than `growth_limit` times as large as at first, while the same
 *                contacts are closed.
 *   inaccurate   within half a period of the slowest mode, or within 2000 times the limit if this is shorter, the
 *                displacement in this mode differs from that of a run with 1/64 of the limit as its step. The
 *                largest difference is more than `displacement_tolerance` times the largest displacement.
 *   stable       neither
 *
 * The program compares the limit with the step at which perturbations begin to grow, with the step at which the
 * spectral radius of the cycle as a matrix exceeds 1, and, for a disc in a wedge, with a closed form. It compares the
 * guaranteed stable step (the bound) with the limit, and with a run at the bound. It prints the comparisons that fail.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <gsl/gsl_blas.h>
#include <gsl/gsl_eigen.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../src/measure/step.h"
#include "../src/run/plan.h"
#include "chance.h"
#include "limit.h"

enum { MOST = 32, AXIS = 8, STEPS = 17, FINE = 64, GROWTH_CYCLES = 1500, LONGEST = 2000, KICK_CYCLES = 1000 };
static const double overlap = 1e-4; /* of each contact at rest, over the radius; not in the chain and the packing */
static const double perturbation = 1e-9; /* largest displacement in x, and in y, in the first cycle, over the radius */
/* Largest growth. Close to the limit the amplitude of a stable vibration rises and falls by a factor of about 10. */
static const double growth_limit = 100;
static const double displacement_tolerance = 0.01; /* as a fraction of the largest displacement */
static const double agreement = 0.01;              /* largest relative difference between the limit and runs */
static const double visible = 0.01;                /* energy residual or imbalance that a user would see */
/* Largest displacement in x, and in y, in the first cycle of a run that looks for symptoms, over the mean overlap. */
static const double kick_size = 0.03;
static const double steps[STEPS] = {1. / 32, 1. / 16, 0.125, 0.25, 0.5,  0.75, 0.875, 0.95, 0.99,
                                    1.01,    1.05,    1.1,   1.2,  1.35, 1.5,  1.75,  2};

/* ---- systems ---- */

struct axis {
  const char *name; /* NULL: none */
  double values[AXIS];
  int count;
};
/* `other` is a further axis of some systems: rotation, angle. `title` and `what` are the heading and the description of
 * the system in docs/STABILITY.md, and `anchor` is the target of links to it. */
struct system {
  const char *name, *title, *anchor, *what;
  void (*write)(FILE *page, const struct system *system, double mass, double other);
  struct axis mass, ratio, damping, other;
};
struct column {
  const struct system *system;
  double mass, ratio, damping, other;
  int place; /* in its panel of the figure */
};

static void materials(FILE *page, double mass) {
  /* Discs of radius 1 have the mass 1 if they are of material a, and the given mass if they are of material b. */
  const double pi = 3.14159265358979323846;
  fprintf(page, "material a density %.17g kn 1 ks $ratio friction 1\n", 1 / pi);
  fprintf(page, "material b density %.17g kn 1 ks $ratio friction 1\n", mass / pi);
}

/* A square lattice between four walls. All overlaps are equal, and the discs are alternately of materials a and b. */
static void write_lattice(FILE *page, int nx, int ny, double mass) {
  const double d = 2 - overlap;
  materials(page, mass);
  fprintf(page, "box 0 0 to %.17g %.17g a\n", nx * d - overlap, ny * d - overlap);
  for (int k = 0; k < nx * ny; k++)
    fprintf(page, "disc %.17g %.17g radius 1 %c\n", 1 - overlap + k % nx * d, 1 - overlap + k / nx * d,
            (k % nx + k / nx) % 2 ? 'b' : 'a');
}
/* A compressed row of discs buckles at a rate proportional to the square root of the overlap, so this row has smaller
 * overlaps. */
static void write_chain(FILE *page, const struct system *system, double mass, double other) {
  (void)system, (void)other;
  const double slight = overlap / 10;
  const double d = 2 - slight, end = 5 * d - slight;
  materials(page, mass);
  fprintf(page, "wall west 0 -1 to 0 1 a\nwall east %.17g -1 to %.17g 1 a\n", end, end);
  for (int k = 0; k < 5; k++)
    fprintf(page, "disc %.17g 0 radius 1 %c\n", 1 - slight + k * d, k % 2 ? 'b' : 'a');
}
static void write_nine(FILE *page, const struct system *system, double mass, double other) {
  (void)system, (void)other;
  write_lattice(page, 3, 3, mass);
}
static void write_rotation(FILE *page, const struct system *system, double mass, double other) {
  (void)system, (void)other;
  write_lattice(page, 2, 2, mass);
}
/* Six discs whose masses are a geometric series from 1 to the given one. The order puts light discs beside heavy ones. */
static void write_masses(FILE *page, const struct system *system, double mass, double other) {
  (void)system, (void)other;
  static const int order[6] = {0, 5, 1, 4, 2, 3};
  const double pi = 3.14159265358979323846, d = 2 - overlap;
  for (int k = 0; k < 6; k++)
    fprintf(page, "material m%d density %.17g kn 1 ks $ratio friction 1\n", k, pow(mass, k / 5.) / pi);
  fprintf(page, "box 0 0 to %.17g %.17g m0\n", 3 * d - overlap, 2 * d - overlap);
  for (int k = 0; k < 6; k++)
    fprintf(page, "disc %.17g %.17g radius 1 m%d\n", 1 - overlap + k % 3 * d, 1 - overlap + k / 3 * d, order[k]);
}
/* A disc on two walls whose normals are at `other` degrees from the vertical, held by its weight. */
static void write_wedge(FILE *page, const struct system *system, double mass, double other) {
  (void)system, (void)mass;
  const double angle = other * 3.14159265358979323846 / 180, s = sin(angle), c = cos(angle), h = 1 - overlap;
  materials(page, 1);
  fprintf(page, "disc 0 0 radius 1 a\ngravity 0 %.17g\n", -2 * overlap * c);
  for (int side = -1; side <= 1; side += 2)
    fprintf(page, "wall w%d %.17g %.17g to %.17g %.17g a\n", side + 1, side * h * s - 0.2 * c, -h * c - side * 0.2 * s,
            side * h * s + 0.2 * c, -h * c + side * 0.2 * s);
}

/* The random packing. A box is filled and made smaller without friction until the contacts carry a stress; then the
 * discs come to rest. The packing has no shear forces, so it is in equilibrium with any shear stiffness, masses and
 * damping. */
static struct nb_table packing_discs, packing_walls;
static const char packing_page[] =
    "units none\nmaterial m density (1/pi) kn 1\nnormal linear\nbox 0 0 to 9.2 9.2 m\n"
    "grading g 0.8 4 0.9 4 1 4 1.15 4\nfill discs box 0 0 to 9.2 9.2 g m seed 3 attempts 100000 else skip\n"
    "damping ratio 0.5\ndamping mass 0.02\nstep 0.5 of stable\nregion A all\nrecord A.stress.mean unbalanced.max\n"
    "stage squeeze\nbox strain -1e-5 per cycle -1e-5 per cycle\nuntil A.stress.mean above 1e-3 at most 100000 cycles\n"
    "stage rest\nwalls stop\ndamping ratio 0.5\ndamping mass 0.02\nuntil unbalanced.max below 1e-12 at most 1000000 "
    "cycles\nsnapshot\n";

static double cell(const struct nb_table *table, size_t row, const char *name) {
  for (size_t c = 0; c < table->column_count; c++)
    if (strcmp(table->names[c], name) == 0)
      return table->values[row * table->column_count + c];
  return NAN;
}
static void write_packing(FILE *page, const struct system *system, double mass, double other) {
  (void)system, (void)other;
  materials(page, mass);
  for (size_t k = 0; k < packing_walls.row_count; k++)
    fprintf(page, "wall w%zu %.17g %.17g to %.17g %.17g a\n", k, cell(&packing_walls, k, "x1"),
            cell(&packing_walls, k, "y1"), cell(&packing_walls, k, "x2"), cell(&packing_walls, k, "y2"));
  for (size_t k = 0; k < packing_discs.row_count; k++)
    fprintf(page, "disc %.17g %.17g radius %.17g %c\n", cell(&packing_discs, k, "x"), cell(&packing_discs, k, "y"),
            cell(&packing_discs, k, "radius"), k % 2 ? 'b' : 'a');
}

/* clang-format off */
#define MASSES {"mass ratio ", {1, 10, 100}, 3}
#define RATIOS {"ks/kn ", {0, 0.5, 1, 2}, 4}
#define DAMPING {"damping ratio ", {0, 0.1, 0.5, 1, 2}, 5}
/* clang-format on */
static const struct system systems[] = {
    {"chain",
     "Chain",
     "chain",
     "Five discs are in a row between two walls. Discs 2 and 4 have the other mass.",
     write_chain,
     MASSES,
     RATIOS,
     DAMPING,
     {NULL, {0}, 1}},
    {"nine-discs",
     "Nine discs",
     "nine-discs",
     "Three by three discs fill a box of four walls. Every second disc has the other mass.",
     write_nine,
     MASSES,
     RATIOS,
     DAMPING,
     {NULL, {0}, 1}},
    {"random-packing",
     "Random packing",
     "random-packing",
     "Sixteen discs of four sizes are compressed from random places in a box until they carry a stress. Every second\n"
     "disc has the other density.",
     write_packing,
     MASSES,
     RATIOS,
     DAMPING,
     {NULL, {0}, 1}},
    {"unlike-masses",
     "Unlike masses",
     "unlike-masses",
     "Three by two discs fill a box of four walls. Their masses are the terms of a geometric series, from 1 to the "
     "mass ratio.",
     write_masses,
     {"mass ratio ", {100, 1e4, 1e6}, 3},
     RATIOS,
     DAMPING,
     {NULL, {0}, 1}},
    {"rotation",
     "Rotation on and off",
     "rotation-on-and-off",
     "Two by two discs fill a box of four walls. Half of the columns have `rotation off`.",
     write_rotation,
     {"mass ratio ", {1, 100}, 2},
     RATIOS,
     DAMPING,
     {"rotation on (1) and off (0): ", {1, 0}, 2}},
    {"wedge",
     "Damped up to twice critical",
     "damped-up-to-twice-critical",
     "One disc lies in a wedge of two walls, held by its weight.",
     write_wedge,
     {NULL, {1}, 1},
     RATIOS,
     {"damping ratio ", {0, 0.25, 0.5, 0.75, 1, 1.5, 2}, 7},
     {"angle of the normals from the vertical, degrees: ", {20, 45, 70}, 3}},
};
enum { SYSTEMS = sizeof systems / sizeof *systems };

/* ---- pages and models ---- */

struct written {
  struct nb_page page;
  struct nb_scene scene;
};
static void fail(const char *what) {
  fprintf(stderr, "stability_maps: %s\n", what);
  exit(2);
}

static void read_text(struct written *it, const char *text) {
  char path[] = "/tmp/nineball-maps-XXXXXX";
  struct nb_mistakes mistakes = {0};
  const int descriptor = mkstemp(path);
  FILE *file = descriptor >= 0 ? fdopen(descriptor, "w") : NULL;
  if (!file)
    fail("cannot write to /tmp");
  fprintf(file, "```scene\n%s```\n", text);
  fclose(file);
  *it = (struct written){0};
  nb_page_read(&it->page, path, &mistakes);
  nb_scene_read(&it->scene, &it->page, 0, NULL, &mistakes);
  unlink(path);
  if (mistakes.count)
    fail(mistakes.text);
  nb_mistakes_free(&mistakes);
}
static void written_free(struct written *it) {
  nb_scene_free(&it->scene);
  nb_page_free(&it->page);
}

static void write_page(struct written *it, const struct column *column, const char *record) {
  char *text = NULL;
  size_t size = 0;
  FILE *page = open_memstream(&text, &size);
  if (!page)
    fail("no memory");
  fprintf(page, "units none\nlet ratio = %.17g\nnormal linear\nshear linear\n", column->ratio);
  column->system->write(page, column->system, column->mass, column->other);
  if (column->damping > 0)
    fprintf(page, "damping ratio %.17g\n", column->damping);
  const bool turns = column->system->write != write_rotation || column->other > 0;
  fprintf(page, "step 1\nallow unstable\nrecord %s\nstage s\n%scycles 1000000000\n", record,
          turns ? "" : "rotation off\n");
  fclose(page);
  read_text(it, text);
  free(text);
}

/* The model at rest with this step; free it with nb_model_free. */
static struct nb_model *model_of(struct written *it, double step) {
  static const struct nb_options options = {.threads = 1};
  struct nb_error error = {0};
  it->scene.step.value = it->scene.stages[0].step.value = step;
  struct nb_model *model = nb_model_create(&it->scene, &options, &error);
  if (!model || nb_stage_begin(model, &it->scene.stages[0], &error))
    fail(error.text);
  return model;
}
static double quantity(const struct nb_model *model, const char *name) {
  const struct nb_scene *scene = model->scene;
  for (size_t c = 0; c < scene->column_count; c++)
    if (strcmp(scene->columns[c].name, name) == 0)
      return nb_quantity_value(scene->columns[c].quantity, model);
  return NAN;
}

static size_t closed_contacts(const struct nb_model *model) {
  size_t count = 0;
  for (size_t c = 0; c < model->contacts.count; c++)
    count += nb_overlap(model, c) > 0;
  return count;
}
static double mean_overlap(const struct nb_model *model) {
  double sum = 0;
  for (size_t c = 0; c < model->contacts.count; c++)
    sum += fmax(nb_overlap(model, c), 0);
  return sum / (double)model->contacts.count; /* of all listed pairs */
}

/* Gives the particles random velocities at the start. `distance` is the largest displacement in a cycle, in x and in y. */
static void kick(struct written *it, double distance, double step, unsigned seed) {
  struct chance chance = chance_begin(seed);
  const bool rotates = it->scene.stages[0].rotation != NB_ROTATION_OFF;
  for (size_t k = 0; k < it->scene.particle_count; k++) {
    struct nb_particle *particle = &it->scene.particles[k];
    const double v = distance / step;
    particle->vx = chance_between(&chance, -v, v), particle->vy = chance_between(&chance, -v, v);
    particle->spin = rotates ? chance_between(&chance, -v, v) : 0;
  }
}

/* ---- growth ---- */

/* The change of all velocities since `last`, which is then updated: the root of the sum of mass times square. */
static double velocity_changes(const struct nb_model *model, double last[3 * MOST]) {
  double sum = 0;
  for (size_t slot = 0; slot < model->particles.count; slot++) {
    const struct nb_velocities v = nb_velocity_half(model, slot);
    const double now[3] = {v.velocity.x, v.velocity.y, v.spin};
    for (int k = 0; k < 3; k++) {
      const double change = now[k] - last[3 * slot + (size_t)k];
      sum += change * change * (k < 2 ? model->particles.mass[slot] : model->particles.inertia[slot]);
      last[3 * slot + (size_t)k] = now[k];
    }
  }
  return sqrt(sum);
}

/* The factor by which the velocity changes grow; `kept`: as many contacts are closed at the end as at the start. */
static double growth_of(struct written *it, double step, bool *kept) {
  kick(it, perturbation, step, 1);
  struct nb_model *model = model_of(it, step);
  struct nb_error error = {0};
  double last[3 * MOST] = {0}, first = INFINITY, most = 0;
  const size_t closed = closed_contacts(model);
  velocity_changes(model, last);
  for (int cycle = 0; cycle < GROWTH_CYCLES && !(most > growth_limit * first); cycle++) {
    if (nb_cycle(model, &error)) {
      most = INFINITY;
      break;
    }
    const double now = velocity_changes(model, last);
    if (cycle == 1) /* the first change of velocity: in cycle 0 the forces are still those at rest */
      first = now;
    most = cycle > 0 ? fmax(most, now) : 0;
  }
  *kept = closed_contacts(model) == closed;
  nb_model_free(model);
  return most / first;
}

/* The step, over the limit, at which perturbations begin to grow, to 0.2 %. NaN: it is not between `low` and `high`. */
static double boundary_of_runs(struct written *it, double limit, double low, double high) {
  bool kept;
  if (growth_of(it, low * limit, &kept) > growth_limit || !(growth_of(it, high * limit, &kept) > growth_limit))
    return NAN;
  while (high - low > 0.002) {
    const double middle = (low + high) / 2;
    *(growth_of(it, middle * limit, &kept) > growth_limit ? &high : &low) = middle;
  }
  return (low + high) / 2;
}

/* ---- modes ---- */

struct mode {
  gsl_vector *shape; /* of unit length, in the degrees of freedom of limit.h */
  double square;     /* eigenvalue */
};

/* The mode of the matrix a K + b C with the largest eigenvalue, or with the smallest one that is not a rounding error.
 * K is the matrix of the springs, C that of the dashpots. The caller frees `shape`. */
static struct mode mode_of(const struct limit *limit, double a, double b, bool largest) {
  const gsl_matrix *stretch = limit->lattice.stretch;
  const size_t n = stretch->size2;
  gsl_matrix *weighted = gsl_matrix_alloc(stretch->size1, n), *sum = gsl_matrix_alloc(n, n),
             *shapes = gsl_matrix_alloc(n, n);
  gsl_vector *values = gsl_vector_alloc(n);
  gsl_eigen_symmv_workspace *work = gsl_eigen_symmv_alloc(n);
  gsl_matrix_memcpy(weighted, stretch);
  for (size_t r = 0; r < stretch->size1; r++) {
    gsl_vector_view row = gsl_matrix_row(weighted, r);
    gsl_vector_scale(&row.vector,
                     a * gsl_vector_get(limit->lattice.springs, r) + b * gsl_vector_get(limit->dashpots, r));
  }
  gsl_blas_dgemm(CblasTrans, CblasNoTrans, 1, stretch, weighted, 0, sum);
  gsl_eigen_symmv(sum, values, shapes, work);
  gsl_eigen_symmv_sort(values, shapes, GSL_EIGEN_SORT_VAL_ASC);
  size_t which = n - 1;
  const double rounding = 1e-11 * gsl_vector_get(values, n - 1);
  if (!largest)
    for (which = 0; gsl_vector_get(values, which) <= rounding; which++)
      continue;
  struct mode mode = {.shape = gsl_vector_alloc(n), .square = gsl_vector_get(values, which)};
  gsl_matrix_get_col(mode.shape, shapes, which);
  gsl_eigen_symmv_free(work);
  gsl_vector_free(values);
  gsl_matrix_free(weighted), gsl_matrix_free(sum), gsl_matrix_free(shapes);
  return mode;
}

/* The cause of the limit `step`, from its mode u. The cause is "damping" if the dashpots make up more than half of
 * u'(dt^2 K + 2 dt C)u. Otherwise it is "rotation" if the rotations make up more than half of u'u, and else "normal" or
 * "tangential", whichever part is larger. */
static const char *cause_of(const struct limit *limit, double step) {
  struct mode mode = mode_of(limit, step * step, 2 * step, true);
  double parts[2] = {0}, dashpots = 0, rotation = 0, all = 0;
  gsl_vector *stretched = gsl_vector_alloc(limit->lattice.stretch->size1);
  gsl_blas_dgemv(CblasNoTrans, 1, limit->lattice.stretch, mode.shape, 0, stretched);
  for (size_t r = 0; r < stretched->size; r++) {
    const double e = gsl_vector_get(stretched, r), square = e * e;
    const double spring = step * step * gsl_vector_get(limit->lattice.springs, r) * square;
    const double dashpot = 2 * step * gsl_vector_get(limit->dashpots, r) * square;
    parts[r % 2] += spring + dashpot, dashpots += dashpot, all += spring + dashpot;
  }
  for (size_t k = 2; k < mode.shape->size; k += 3)
    rotation += pow(gsl_vector_get(mode.shape, k), 2);
  gsl_vector_free(stretched), gsl_vector_free(mode.shape);
  return dashpots > all / 2 ? "damping" : rotation > 0.5 ? "rotation" : parts[1] > parts[0] ? "tangential" : "normal";
}

/* ---- accuracy: the displacement in the slowest mode ---- */

struct slow {
  struct mode mode;
  double damping; /* damping ratio of the mode, u'Cu/(2 omega) */
  double *path;   /* path[n]: displacement at the time n limit/FINE */
  size_t count;
  double largest;
};

/* Starts the slowest mode with a velocity that moves it by about a thousandth of the overlap. */
static void start_mode(struct written *it, const struct mode *mode) {
  double most = 0;
  for (int set = 0; set < 2; set++)
    for (size_t k = 0; k < it->scene.particle_count; k++) {
      struct nb_particle *particle = &it->scene.particles[k];
      const double *u = gsl_vector_const_ptr(mode->shape, 3 * k), speed = 1e-3 * overlap * sqrt(mode->square) / most;
      const double root = sqrt(nb_particle_mass(&it->scene, particle)),
                   of_spin = sqrt(nb_particle_inertia(&it->scene, particle));
      if (set)
        particle->vx = speed * u[0] / root, particle->vy = speed * u[1] / root, particle->spin = speed * u[2] / of_spin;
      else
        most = fmax(most, fmax(hypot(u[0], u[1]) / root, fabs(u[2]) / of_spin));
    }
}
/* The displacement in a mode since the positions `rest`; `begin` stores the present positions in `rest` first. */
static double displacement(const struct nb_model *model, const struct mode *mode, double rest[3 * MOST], bool begin) {
  double sum = 0;
  for (size_t k = 0; k < model->particles.count; k++) {
    const size_t slot = (size_t)model->particles.slot[k];
    const struct nb_vec x = model->particles.position[slot];
    const double now[3] = {x.x, x.y, model->particles.angle ? model->particles.angle[slot] : 0};
    for (size_t i = 0; i < 3; i++) {
      if (begin)
        rest[3 * k + i] = now[i];
      sum += (now[i] - rest[3 * k + i]) * gsl_vector_get(mode->shape, 3 * k + i) *
             sqrt(i < 2 ? model->particles.mass[slot] : model->particles.inertia[slot]);
    }
  }
  return sum;
}

/* Finds the slowest mode, and runs the system with 1/FINE of the limit `longest` (s) as its step, for comparison. */
static void slow_begin(struct slow *slow, struct written *it, const struct limit *limit, double longest) {
  slow->mode = mode_of(limit, 1, 0, false);
  gsl_vector *stretched = gsl_vector_alloc(limit->lattice.stretch->size1);
  gsl_blas_dgemv(CblasNoTrans, 1, limit->lattice.stretch, slow->mode.shape, 0, stretched);
  slow->damping = 0;
  for (size_t r = 0; r < stretched->size; r++)
    slow->damping +=
        gsl_vector_get(limit->dashpots, r) * pow(gsl_vector_get(stretched, r), 2) / (2 * sqrt(slow->mode.square));
  gsl_vector_free(stretched);
  const double period = 3.14159265358979323846 / sqrt(slow->mode.square); /* half a period */
  slow->count = (size_t)ceil(FINE * fmin(period / longest, LONGEST)) + 4 * FINE;
  slow->path = calloc(slow->count, sizeof *slow->path);
  slow->largest = 0;
  double rest[3 * MOST];
  struct nb_error error = {0};
  start_mode(it, &slow->mode);
  struct nb_model *model = model_of(it, longest / FINE);
  displacement(model, &slow->mode, rest, true);
  for (size_t n = 1; n < slow->count && !nb_cycle(model, &error); n++) {
    slow->path[n] = displacement(model, &slow->mode, rest, false);
    slow->largest = fmax(slow->largest, fabs(slow->path[n]));
  }
  nb_model_free(model);
}
static void slow_end(struct slow *slow) {
  free(slow->path);
  gsl_vector_free(slow->mode.shape);
}

/* The largest error of the displacement in a run with the step `f` times the limit `longest`, over the largest
 * displacement. */
static double error_of(const struct slow *slow, struct written *it, double longest, double f) {
  double rest[3 * MOST], most = 0;
  struct nb_error error = {0};
  start_mode(it, &slow->mode);
  struct nb_model *model = model_of(it, f * longest);
  displacement(model, &slow->mode, rest, true);
  for (int n = 1; f * n * FINE < (double)slow->count - 2 && !nb_cycle(model, &error); n++) {
    const double at = f * n * FINE, before = floor(at);
    const double *path = slow->path + (size_t)before;
    const double exact = path[0] + (at - before) * (path[1] - path[0]);
    most = fmax(most, fabs(displacement(model, &slow->mode, rest, false) - exact));
  }
  nb_model_free(model);
  return most / slow->largest;
}

/* ---- symptoms: what a run above the limit shows ---- */

struct symptom {
  double energy;    /* largest energy.balance over the energy at the start */
  double imbalance; /* mean of unbalanced.max over the last tenth */
  double force;     /* mean contact force over that at rest, over the last half */
  double kinetic;   /* kinetic energy at the end over that at the start */
  char text[64];    /* names the guard that stops the run; empty: none does */
};
static const char *const kick_record = "unbalanced.max energy.balance energy.kinetic energy.stored";

/* The guard that printed the message; a message that names none is an error. */
static const char *guard_of(const char *text) {
  if (strstr(text, "passed through wall"))
    return "crossing";
  if (strstr(text, "they overlap by"))
    return "overlap";
  if (!strstr(text, "it moved by"))
    fail(text);
  return "motion";
}

/* Runs the scene with random velocities. `distance` is the largest displacement in the first cycle, in x and in y, over
 * the mean overlap. */
static struct symptom symptom_of(struct written *it, double step, double distance, int cycles) {
  struct symptom symptom = {0};
  struct nb_error error = {0};
  struct nb_model *model = model_of(it, step);
  const double rest = mean_overlap(model);
  nb_model_free(model);
  kick(it, distance * rest, step, 2);
  model = model_of(it, step);
  const double kinetic = quantity(model, "energy.kinetic"), energy = kinetic + quantity(model, "energy.stored");
  int late = 0, half = 0;
  for (int n = 0; n < cycles; n++) {
    if (nb_cycle(model, &error)) {
      snprintf(symptom.text, sizeof symptom.text, "%s", guard_of(error.text));
      symptom.energy = INFINITY;
      break;
    }
    symptom.energy = fmax(symptom.energy, fabs(quantity(model, "energy.balance")) / energy);
    if (n >= cycles - cycles / 10)
      symptom.imbalance += quantity(model, "unbalanced.max"), late++;
    if (n >= cycles / 2)
      symptom.force += mean_overlap(model) / rest, half++;
  }
  symptom.imbalance /= late ? late : 1, symptom.force /= half ? half : 1;
  symptom.kinetic = quantity(model, "energy.kinetic") / kinetic;
  nb_model_free(model);
  return symptom;
}

/* ---- one column ---- */

enum class { STABLE, INACCURATE, UNSTABLE, CLASSES };
static const char *const class_names[] = {"stable", "inaccurate", "unstable"};
struct point {
  double f, growth, error;
  bool kept;
  enum class class;
  const char *cause, *shows;
  struct symptom symptom;
};
struct result {
  double single, limit, bound, runs, planar; /* s; runs and bound over limit; planar: closed form, NAN: none */
  const char *cause;
  struct symptom usual; /* at half the limit */
  struct point points[STEPS + 1];
};
static double wrong_limit = 1, wrong_bound = 1; /* planted errors: factors of the limit and of the bound */
static size_t complaints;
static bool silent; /* complaints are only counted */

static void complain(const struct column *column, const char *what, double value) {
  complaints++;
  if (!silent)
    fprintf(stderr, "# %s, mass %g, ks/kn %g, damping %g, %g: %s %.6g\n", column->system->name, column->mass,
            column->ratio, column->damping, column->other, what, value);
}

/* The largest eigenvalue of dt^2 K + 2 dt C for a disc of mass 1 and radius 1 in a wedge; the limit is the step at
 * which it is 4. A contact has h = dt^2 k + 2 dt c, h_n normal and h_s tangential. The normal of each wall is at the
 * angle a from the vertical. Each wall adds h_n cos^2 a + h_s sin^2 a to the eigenvalue of the vertical motion. The
 * horizontal motion and the rotation are coupled: their eigenvalues are those of a symmetric matrix with two rows. */
static double planar_eigenvalue(const struct column *column, double dt) {
  const double angle = column->other * 3.14159265358979323846 / 180, s2 = pow(sin(angle), 2), c2 = 1 - s2;
  const double ks = column->ratio, inertia = 0.5;
  const double hn = dt * dt + 4 * dt * column->damping, hs = dt * dt * ks + 4 * dt * column->damping * sqrt(ks);
  const double vertical = 2 * (hn * c2 + hs * s2), a = 2 * (hn * s2 + hs * c2), b = 2 * hs / inertia;
  const double coupling = 2 * hs * sqrt(c2 / inertia);
  return fmax(vertical, (a + b) / 2 + hypot((a - b) / 2, coupling));
}
static double planar_limit(const struct column *column) {
  double low = 0, high = 4;
  for (int k = 0; k < 60; k++)
    *(planar_eigenvalue(column, (low + high) / 2) > 4 ? &high : &low) = (low + high) / 2;
  return low;
}

/* The symptom that a user would see, compared with the usual values of the column. */
static const char *shown(const struct symptom *symptom, const struct symptom *usual) {
  if (symptom->text[0])
    return "message";
  if (symptom->energy > visible && symptom->energy > 3 * usual->energy)
    return "energy";
  return symptom->imbalance > visible && symptom->imbalance > 3 * usual->imbalance ? "imbalance" : "silent";
}

/* Classifies a point. The scheme shortens the period by the fraction (omega dt)^2/24, and a dashpot whose force lags by
 * half a step acts like a mass that is smaller by c dt/2. The larger of these two effects is the cause of an inaccurate
 * point. */
static void classify(struct point *point, const struct result *result, const struct slow *slow) {
  point->class = point->growth > growth_limit ? UNSTABLE : point->error > displacement_tolerance ? INACCURATE : STABLE;
  const double rate = sqrt(slow->mode.square) * point->f * result->limit;
  point->cause = point->class == UNSTABLE        ? result->cause
                 : point->class == STABLE        ? "-"
                 : slow->damping / 2 > rate / 24 ? "dashpot lag"
                                                 : "period";
  point->shows = point->class == STABLE ? "-" : shown(&point->symptom, &result->usual);
}

static void make_points(struct result *result, const struct column *column, const struct limit *limit) {
  struct written quiet, watched;
  struct slow slow;
  write_page(&quiet, column, "step");
  write_page(&watched, column, kick_record);
  struct nb_model *model = model_of(&quiet, result->limit / FINE);
  result->bound = wrong_bound * nb_stable_step(model).step / result->limit;
  nb_model_free(model);
  result->runs = boundary_of_runs(&quiet, result->limit, 0.95, 1.05);
  result->usual = symptom_of(&watched, result->limit / 2, kick_size, KICK_CYCLES);
  slow_begin(&slow, &quiet, limit, result->limit);
  for (int k = 0; k <= STEPS; k++) {
    struct point *point = &result->points[k];
    *point = (struct point){.f = k < STEPS ? steps[k] : result->bound};
    point->growth = growth_of(&quiet, point->f * result->limit, &point->kept);
    point->error = point->growth > growth_limit ? NAN : error_of(&slow, &quiet, result->limit, point->f);
    if (point->growth > growth_limit || point->error > displacement_tolerance)
      point->symptom = symptom_of(&watched, point->f * result->limit, kick_size, KICK_CYCLES);
    classify(point, result, &slow);
  }
  slow_end(&slow);
  written_free(&quiet), written_free(&watched);
}

/* Tests the comparisons that must hold in each column. */
static void compare(const struct column *column, const struct limit *limit, const struct result *result) {
  const double inside = limit_radius(limit, 0.995 * result->limit),
               outside = limit_radius(limit, 1.005 * result->limit);
  if (!(fabs(result->runs - 1) <= agreement))
    complain(column, "perturbations begin to grow at another fraction of the limit:", result->runs);
  if (!(inside <= 1 + 1e-6) || !(outside > 1 + 1e-6))
    complain(column, "the spectral radius disagrees with the limit; above it is", outside);
  if (!isnan(result->planar) && !(fabs(result->planar / result->limit - 1) < 1e-9))
    complain(column, "the closed form over the limit is", result->planar / result->limit);
  if (!(result->bound <= 1 + 1e-9))
    complain(column, "the bound is above the limit:", result->bound);
  if (result->points[STEPS].class == UNSTABLE)
    complain(column, "a run at the bound grows; bound over limit", result->bound);
  for (int k = 0; k < STEPS; k++)
    if ((result->points[k].class == UNSTABLE) != (result->points[k].f > 1))
      complain(column, "a point is on the wrong side of the limit:", result->points[k].f);
    else if (result->points[k].class == UNSTABLE && !result->points[k].kept)
      complain(column, "contacts opened before the growth was seen:", result->points[k].f);
}

static void run_column(struct result *result, const struct column *column) {
  struct written it;
  struct limit limit;
  struct nb_error error = {0};
  write_page(&it, column, "step");
  if (limit_build(&limit, &it.scene, &it.scene.damping, 0, &error))
    fail(error.text);
  if (it.scene.stages[0].rotation == NB_ROTATION_OFF)
    for (size_t spin = 2; spin < limit.lattice.freedom_count; spin += 3) {
      gsl_vector_view freedom = gsl_matrix_column(limit.lattice.stretch, spin);
      gsl_vector_set_zero(&freedom.vector);
    }
  result->single = limit.single_contact;
  result->limit = wrong_limit * limit_of_modes(&limit);
  result->planar = column->system->write == write_wedge ? planar_limit(column) : NAN;
  result->cause = cause_of(&limit, result->limit);
  make_points(result, column, &limit);
  compare(column, &limit, result);
  limit_free(&limit);
  written_free(&it);
}

/* ---- all columns ---- */

enum { COMMON = 4 };
static const double common_damping[COMMON] = {0, 0.5, 1, 2}; /* damping ratios that all systems have */
struct map {
  size_t points[CLASSES];
  double runs[2];          /* least and largest: step at which perturbations begin to grow, over the limit */
  double bound[COMMON][2]; /* least and largest: the bound over the limit, for each damping */
  double planar;           /* largest difference of the closed form from the limit, over the limit */
  struct count {
    const char *name;
    size_t number;
  } causes[8], shows[8], shows_inaccurate[8];
};

static void count(struct count counts[8], const char *name) {
  size_t k = 0;
  while (k < 7 && counts[k].name && strcmp(counts[k].name, name) != 0)
    k++;
  counts[k].name = name, counts[k].number++;
}
static void widen(double range[2], double value) { range[0] = fmin(range[0], value), range[1] = fmax(range[1], value); }

static void write_axes(FILE *out, const struct column *column) {
  fprintf(out, "%d\t%g\t%.4g\t%.4g\t%g", column->place, column->mass, column->ratio, column->damping, column->other);
}

/* The largest step, over the limit, up to which all points are stable. */
static double accurate_below(const struct result *result) {
  double f = 0;
  for (int k = 0; k < STEPS && result->points[k].class == STABLE; k++)
    f = result->points[k].f;
  return f;
}

static void write_point(FILE *out, const struct column *column, const struct result *result,
                        const struct point *point) {
  write_axes(out, column);
  fprintf(out, "\t%.4g\t%.4g\t%s\t%s\t%s", point->f * result->limit / result->single, point->f,
          class_names[point->class], point->cause, point->shows);
  if (point->class == UNSTABLE)
    fprintf(out, "\t-\t%.1g\t%.1g\n", point->symptom.energy, point->symptom.imbalance);
  else
    fprintf(out, "\t%.1g\t-\t-\n", point->error);
}

static void add_column(struct map *map, const struct column *column, const struct result *result, FILE *points,
                       FILE *limits) {
  widen(map->runs, result->runs);
  for (int d = 0; d < COMMON; d++)
    if (fabs(column->damping - common_damping[d]) < 1e-12)
      widen(map->bound[d], result->bound);
  if (!isnan(result->planar))
    map->planar = fmax(map->planar, fabs(result->planar / result->limit - 1));
  for (int k = 0; k <= STEPS; k++) {
    const struct point *point = &result->points[k];
    map->points[point->class]++;
    if (point->class != STABLE)
      count(map->causes, point->cause);
    if (point->class != STABLE)
      count(point->class == UNSTABLE ? map->shows : map->shows_inaccurate, point->shows);
    if (points)
      write_point(points, column, result, point);
  }
  if (limits) {
    fprintf(limits, "%s\t", column->system->name);
    write_axes(limits, column);
    fprintf(limits, "\t%.5g\t%.4f\t%.4f\t%.4g\t%s\n", result->limit / result->single, result->runs, result->bound,
            accurate_below(result), result->cause);
  }
}

/* True if a column is computed. m, r, d and o are its indices on the axes: mass, ratio, damping, other. `brief`: two or
 * three columns of each system; otherwise all. */
static bool taken(const struct system *system, int m, int r, int d, int o, bool brief) {
  return !brief || (m == system->mass.count - 1 && r == 2 && d % 2 == 1 && o == system->other.count - 1);
}

static struct map map_of(const struct system *system, FILE *points, FILE *limits, bool brief) {
  struct map map = {.runs = {INFINITY, -INFINITY}};
  for (int d = 0; d < COMMON; d++)
    map.bound[d][0] = INFINITY, map.bound[d][1] = -INFINITY;
  if (points)
    fputs("place\tmass\tratio\tdamping\tother\tstep\tf\tclass\tcause\tshows\terror\tenergy\timbalance\n", points);
  for (int o = 0; o < system->other.count; o++)
    for (int m = 0; m < system->mass.count; m++)
      for (int r = 0; r < system->ratio.count; r++)
        for (int d = 0; d < system->damping.count; d++) {
          const struct column column = {system,
                                        system->mass.values[m],
                                        system->ratio.values[r],
                                        system->damping.values[d],
                                        system->other.values[o],
                                        (o * system->mass.count + m) * (system->damping.count + 1) + d};
          struct result result;
          if (!taken(system, m, r, d, o, brief))
            continue;
          run_column(&result, &column);
          add_column(&map, &column, &result, points, limits);
        }
  return map;
}

static void prepare_packing(void) {
  struct written it;
  struct nb_result result;
  struct nb_error error = {0};
  const struct nb_options options = {.threads = 1};
  read_text(&it, packing_page);
  if (nb_run(&result, &it.scene, &options, NULL, &error))
    fail(error.text);
  packing_discs = result.snapshots[0].particles, packing_walls = result.snapshots[0].walls;
  result.snapshots[0].particles = result.snapshots[0].walls = (struct nb_table){0};
  nb_result_free(&result);
  written_free(&it);
}

/* ---- just above and just below the limit: nine discs ---- */

static const double soft_steps[] = {0.5, 0.9, 0.99, 1.01, 1.02, 1.05, 1.1, 1.2, 1.3, 1.4, 1.5, 1.75, 2};
static const double soft_damping[] = {0, 0.1, 1}, soft_zone = 1.5, force_zone = 1.3;
enum {
  SOFT_STEPS = sizeof soft_steps / sizeof *soft_steps,
  SOFT_DAMPING = 3,
  SOFT_CYCLES = 5000,
  NINE = 1,
  PACKING = 2
};

/* Largest values below the limit; least and largest values above it, up to soft_zone (forces: force_zone) times the
 * limit. The imbalance is used only with damping. */
struct soft {
  double energy_below, energy[2], imbalance_below, imbalance[2], force[2];
  bool stopped;
};

static double limit_of(struct written *it) {
  struct limit limit;
  struct nb_error error = {0};
  if (limit_build(&limit, &it->scene, &it->scene.damping, 0, &error))
    fail(error.text);
  const double step = limit_of_modes(&limit);
  limit_free(&limit);
  return step;
}

static void note(struct soft *soft, double damping, double f, const struct symptom *shows) {
  if (f < 1) {
    soft->energy_below = fmax(soft->energy_below, shows->energy);
    soft->imbalance_below = fmax(soft->imbalance_below, damping > 0 ? shows->imbalance : 0);
  } else if (f <= soft_zone && shows->text[0]) {
    soft->stopped = true;
  } else if (f <= soft_zone) {
    widen(soft->energy, shows->energy);
    if (f <= force_zone)
      widen(soft->force, shows->force);
    if (damping > 0)
      widen(soft->imbalance, shows->imbalance);
  }
}

static void write_soft(FILE *out, FILE *table, struct soft *soft, const struct system *system, double ratio) {
  *soft = (struct soft){
      .energy = {INFINITY, -INFINITY}, .imbalance = {INFINITY, -INFINITY}, .force = {INFINITY, -INFINITY}};
  fputs("| damping ratio | step over limit | force over that at rest | `unbalanced.max` | `energy.balance` | "
        "`energy.kinetic` |\n| --- | --- | --- | --- | --- | --- |\n",
        out);

  for (int d = 0; d < SOFT_DAMPING; d++) {
    const struct column column = {system, 1, ratio, soft_damping[d], 0, 0};
    struct written it;
    write_page(&it, &column, kick_record);
    const double limit = limit_of(&it);
    for (int k = 0; k < SOFT_STEPS; k++) {
      const struct symptom shows = symptom_of(&it, soft_steps[k] * limit, kick_size, SOFT_CYCLES);
      note(soft, soft_damping[d], soft_steps[k], &shows);
      fprintf(out, "| %g | %g ", soft_damping[d], soft_steps[k]);
      if (shows.text[0])
        fprintf(out, "| stopped: %s | | | |\n", shows.text);
      else
        fprintf(out, "| %.3g | %.2g | %.2g | %.2g |\n", shows.force, shows.imbalance, shows.energy, shows.kinetic);
      if (!shows.text[0])
        fprintf(table, "%s\t%g\t%g\t%.4g\t%.3g\t%.3g\t%.3g\n", system->name, soft_damping[d], soft_steps[k],
                shows.force, shows.imbalance, shows.energy, shows.kinetic);
    }
    written_free(&it);
  }
}

/* Largest velocity changes in each tenth of the cycles, divided by that in the first tenth. */
static void write_long(FILE *out, double f, unsigned long cycles) {
  const struct column column = {&systems[NINE], 1, 1, 0, 0, 0};
  struct written it;
  struct nb_error error = {0};
  double last[3 * MOST] = {0}, most[10] = {0};
  write_page(&it, &column, "step");
  const double step = f * limit_of(&it);
  kick(&it, perturbation, step, 3);
  struct nb_model *model = model_of(&it, step);
  velocity_changes(model, last);
  for (unsigned long n = 0; n < cycles; n++) {
    if (nb_cycle(model, &error))
      fail(error.text);
    double *tenth = &most[n / (cycles / 10)];
    *tenth = fmax(*tenth, velocity_changes(model, last));
  }
  nb_model_free(model);
  written_free(&it);
  fprintf(out, "| %g ", f);
  for (int k = 1; k < 10; k += 2)
    fprintf(out, "| %.4f ", most[k] / most[0]);
  fputs("|\n", out);
  if (!(most[9] < 1.1 * most[0]))
    complain(&column, "the vibration below the limit grows over many cycles to", most[9] / most[0]);
}

/* ---- docs/STABILITY.md ---- */

static void write_beginning(FILE *out) {
  fputs(
      "# Stability of the calculation cycle\n\n"
      "`make stability` writes this document ([tests/stability_maps.c](../tests/stability_maps.c)). It maps where the\n"
      "calculation cycle is stable, inaccurate or unstable. [METHOD](METHOD.md#the-time-step) explains the limit and\n"
      "the guaranteed stable step. In this document the *bound* is the guaranteed stable step, which a run checks.\n\n"
      "A *column* of a map is one system with one value of each parameter, such as the mass ratio, the stiffness\n"
      "ratio $k_s/k_n$ and the damping ratio of the contacts. Its *limit* is the step at which the largest eigenvalue "
      "of $\\Delta t^2 K + 2 \\Delta t C$ "
      "equals\n"
      "4. $K$ and $C$ are the matrices of the assembly at rest, scaled so that $M = 1$. A point is one step of a\n"
      "column. For each point the program runs the assembly at rest with a perturbation:\n\n",
      out);
  fprintf(
      out,
      "- **Unstable:** a random perturbation grows. At first it moves particles by up to %g of the radius in a cycle,\n"
      "  in x and in y. Its velocity changes become more than %g times as large as at first, within %d cycles, while\n"
      "  the same contacts are closed.\n"
      "- **Inaccurate:** the displacement in the slowest mode is wrong by more than %g %% of its largest value. The\n"
      "  run is compared with one whose step is 1/%d of the limit, over half a period, or over %d limits if that is\n"
      "  shorter.\n"
      "- **Stable:** neither of the two.\n\n",
      perturbation, growth_limit, (int)GROWTH_CYCLES, 100 * displacement_tolerance, (int)FINE, (int)LONGEST);
  fprintf(out,
          "The steps are %d fractions of the limit from 1/32 to 2, and the bound. The overlaps at rest are %g of the\n"
          "radius, a tenth of that in the chain, and about 0.001 in the random packing.\n\n",
          (int)STEPS, overlap);
  fputs(
      "**Causes.** The cause of growth is the mode that leaves the unit circle first. It is *damping* if the dashpots\n"
      "make up more than half of its eigenvalue. Otherwise it is *rotation* if more than half of its kinetic energy "
      "is\n"
      "rotation, else *normal* or *tangential*, whichever part is larger. The scheme shortens the *period* by\n"
      "the fraction $(\\omega \\Delta t)^2/24$, and a dashpot lags by half a step. The larger of these two effects on\n"
      "the slowest mode is the cause of inaccuracy.\n\n",
      out);
  fprintf(
      out,
      "**Symptoms.** Points that are unstable or inaccurate are run again with `allow unstable` for %d cycles. Random\n"
      "velocities move the discs by up to %g of the mean overlap in a cycle, in x and in y. The symptom is the first "
      "of\n"
      "these:\n\n"
      "- *message*: a guard stops the run.\n"
      "- *energy*: the largest `energy.balance` exceeds %g %% of the initial energy.\n"
      "- *imbalance*: the mean `unbalanced.max` at the end exceeds %g %%.\n"
      "- *silent*: none of these.\n\n"
      "Energy and imbalance must also be three times as large as in the same run at half the limit.\n",
      (int)KICK_CYCLES, kick_size, 100 * visible, 100 * visible);
}

static void write_counts(FILE *out, const struct count counts[8]) {
  for (int k = 0; k < 8 && counts[k].name; k++)
    fprintf(out, "%s%s %zu", k ? ", " : "", counts[k].name, counts[k].number);
}

static void write_summary(FILE *out, const struct map maps[SYSTEMS]) {
  fputs("\n## Summary\n\n"
        "*Runs over limit* is the step at which perturbations begin to grow in runs, found by bisection, divided by "
        "the limit.\n\n"
        "| system | points | stable | inaccurate | unstable | runs over limit | causes | symptoms of inaccurate points "
        "| of "
        "unstable points |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
        out);
  for (int s = 0; s < SYSTEMS; s++) {
    const struct map *map = &maps[s];
    fprintf(out, "| [%s](#%s) | %zu | %zu | %zu | %zu | %.4f to %.4f | ", systems[s].title, systems[s].anchor,
            map->points[STABLE] + map->points[INACCURATE] + map->points[UNSTABLE], map->points[STABLE],
            map->points[INACCURATE], map->points[UNSTABLE], map->runs[0], map->runs[1]);
    write_counts(out, map->causes);
    fputs(" | ", out);
    write_counts(out, map->shows_inaccurate);
    fputs(" | ", out);
    write_counts(out, map->shows);
    fputs(" |\n", out);
  }
  fputs(
      "\nUnstable points are silent where few particles vibrate. The energy of these particles is small compared with "
      "that of\n"
      "all particles. Their unbalanced forces are not unusual while the other particles still move.\n",
      out);
  fputs("\n## The cost of the bound\n\n"
        "The table has the bound over the limit, the least and the largest of all columns with this damping ratio. A "
        "run at the\n"
        "bound needs more cycles than one at the limit, by the reciprocal of this factor. The bound also counts pairs\n"
        "that are listed but do not touch.\n\n| system | damping 0 | 0.5 | 1 | 2 |\n| --- | --- | --- | --- | --- |\n",
        out);
  for (int s = 0; s < SYSTEMS; s++) {
    fprintf(out, "| %s ", systems[s].title);
    for (int d = 0; d < COMMON; d++)
      fprintf(out, "| %.2f to %.2f ", maps[s].bound[d][0], maps[s].bound[d][1]);
    fputs("|\n", out);
  }
}

static void write_checks(FILE *out, const struct map maps[SYSTEMS]) {
  fprintf(
      out,
      "\n## What is checked\n\n"
      "The program that makes the maps requires in each column:\n\n"
      "- The step at which perturbations begin to grow in runs is within %g %% of the limit. The bisection resolves "
      "0.2 %%.\n"
      "- The spectral radius of the cycle is at most 1 at 0.995 of the limit and above 1 at 1.005 of it. The cycle is "
      "written\n"
      "  as a matrix with velocity-dependent terms half a step late, and GSL computes all eigenvalues.\n"
      "- No point below the limit is unstable, and all points above it are.\n"
      "- The bound does not exceed the limit, and in a run with the bound as step no perturbation grows.\n"
      "- For a disc in a wedge the limit equals a closed form. The largest relative difference is %.0e.\n\n"
      "If anything disagrees, the program prints the column and ends with status 1. `make check` runs a part of the "
      "maps. It\n"
      "also plants limits that are wrong by 2 %%, and a bound that is too long, and requires an error message for\n"
      "each system.\n",
      100 * agreement, maps[SYSTEMS - 1].planar);
  fputs(
      "\n### The planar result for damped contacts\n\n"
      "Burns and Hanley (*Int. J. Numer. Meth. Engng* 110 (2017) 186–200) study one planar body with linear springs\n"
      "and dashpots, in collisions that are not collinear. Only the abstract of their paper could be read for this\n"
      "document. It states that the critical step is proportional to $\\sqrt{m/k}$, with a factor of known physical\n"
      "parameters. Damping and non-collinear impact change the factor, and initial conditions do not.\n\n"
      "The formula here is derived for the cycle of this program. Contact forces on a disc act along its normal or at\n"
      "right angles to it, so a single contact is collinear. The simplest coupled case is a disc that touches two\n"
      "walls. Let their normals have the angle $\\theta$ from the vertical, and let\n\n"
      "$$ h_n = \\Delta t^2 k_n + 2 \\Delta t c_n, \\qquad h_s = \\Delta t^2 k_s + 2 \\Delta t c_s . $$\n\n"
      "The vertical motion has the eigenvalue $2 (h_n \\cos^2 \\theta + h_s \\sin^2 \\theta)/m$. The horizontal motion "
      "and\n"
      "the rotation are coupled, and their largest eigenvalue is\n\n"
      "$$ \\lambda = \\frac{A + B}{2} + \\sqrt{\\left( \\frac{A - B}{2} \\right)^2 + D^2}, \\qquad\n"
      "   A = \\frac{2}{m} (h_n \\sin^2 \\theta + h_s \\cos^2 \\theta), \\quad B = \\frac{2 R^2 h_s}{I}, \\quad\n"
      "   D = \\frac{2 R h_s \\cos \\theta}{\\sqrt{m I}} . $$\n\n"
      "The limit is the step at which the larger of the two eigenvalues is 4. With $c = 2 \\beta \\sqrt{m k}$ both "
      "depend "
      "on\n"
      "$\\Delta t \\sqrt{k_n/m}$, $k_s/k_n$, $\\beta$ and $\\theta$ only. So the limit is proportional to "
      "$\\sqrt{m/k_n}$, as\n"
      "the abstract says. The runs of [Damped up to twice critical](#damped-up-to-twice-critical) agree with this "
      "limit.\n",
      out);
}

static FILE *opened(const char *folder, const char *name) {
  char path[512];
  snprintf(path, sizeof path, "%s/%s.tsv", folder, name);
  FILE *file = fopen(path, "w");
  if (!file)
    fail(path);
  return file;
}
static void closed(FILE *file) {
  if (fclose(file))
    fail("cannot write a table");
}

static void write_zone(FILE *out, FILE *table, int system, double ratio) {
  struct soft soft;
  fprintf(out, "\n### %s with ks/kn = %g\n\n", systems[system].title, ratio);
  write_soft(out, table, &soft, &systems[system], ratio);
  fprintf(
      out,
      "\nUp to %g times the limit %s.\n\n"
      "- Up to %g times the limit the mean contact force is %.2f to %.2f of that at rest.\n"
      "- `energy.balance` is at most %.2g of the initial energy below the limit, and %.2g to %.2g above it, "
      "up to %g times the limit.\n"
      "- With damping `unbalanced.max` is at most %.0e below the limit, and %.2g to %.2g above it, up to %g times the "
      "limit.\n",
      soft_zone, soft.stopped ? "a guard stops some of the runs, and the others go on" : "no guard stops a run",
      force_zone, soft.force[0], soft.force[1], soft.energy_below, soft.energy[0], soft.energy[1], soft_zone,
      soft.imbalance_below, soft.imbalance[0], soft.imbalance[1], soft_zone);
}

static void write_above(FILE *out, const char *folder) {
  FILE *table = opened(folder, "soft");
  fprintf(
      out,
      "\n## Just above the limit\n\n"
      "Two systems with equal densities and friction 1 are run for %d cycles. Random velocities move the discs by up "
      "to "
      "%g\n"
      "of the overlap in the first cycle, in x and in y. The tables show what a user could record. The force is the "
      "mean of all\n"
      "contacts over the last half of the cycles, and `unbalanced.max` is averaged over the last tenth.\n"
      "`energy.balance` is the largest residual divided by the initial energy, and `energy.kinetic` the last kinetic\n"
      "energy divided by the first. *Stopped* names the guard that stopped the run. *motion*: a particle moved by more "
      "than its\n"
      "radius in one step. *overlap*: two particles overlapped by more than the smaller radius. *crossing*: the "
      "centre\n"
      "of a particle crossed a wall.\n\n"
      "Above the limit the vibration grows until contacts slide and open, which often bounds its amplitude. The run "
      "then\n"
      "goes on, and its results are wrong. With damping `unbalanced.max` shows this: below the limit it falls to "
      "rounding "
      "errors, "
      "above\n"
      "the limit it stays at about 1 %% or more. Without damping the vibrations never end, and `energy.balance` "
      "shows\n"
      "the growth. In the damped packing only few discs vibrate up to 1.02 times the limit. The imbalance is then "
      "about 1 "
      "to\n"
      "5 %%, and neither the energy nor the mean contact force shows anything. Far above the limit a run may even "
      "come\n"
      "to rest in another arrangement with a small imbalance. Without `allow unstable` the stability check stops all\n"
      "runs above the limit before the first cycle.\n\n"
      "![Quantities that show that the step of nine discs is above the limit](stability/soft.svg)\n",
      (int)SOFT_CYCLES, kick_size);
  fputs("system\tdamping\tf\tforce\timbalance\tenergy\tkinetic\n", table);
  write_zone(out, table, NINE, 1);
  write_zone(out, table, PACKING, 0.5);
  closed(table);
}

static void write_below(FILE *out, unsigned long cycles) {
  fprintf(out,
          "\n## Just below the limit\n\n"
          "Nine discs with $k_s = k_n$ and no damping vibrate for %lu million cycles. The table has the largest "
          "velocity change in\n"
          "five of ten parts of the run, divided by that in the first part. Nothing grows.\n\n"
          "| step over limit | part 2 | part 4 | part 6 | part 8 | part 10 |\n| --- | --- | --- | --- | --- | --- |\n",
          cycles / 1000000);
  write_long(out, 0.99, cycles);
  write_long(out, 0.999, cycles);
}

static void write_systems(FILE *out) {
  fputs(
      "\n## The systems\n\n"
      "Each figure has one panel for each $k_s/k_n$ and one bar for each column. The bars are grouped by the other\n"
      "parameters, in the order of the list below the heading of each system. The numbers below the bars are damping\n"
      "ratios. A bar is green while all points are stable, orange up to the limit, and red where all points are\n"
      "unstable. The letter above it says which mode\n"
      "grows first: normal, tangential, rotation, or damping. Black marks are unstable points with another symptom "
      "than\n"
      "*energy*. [limits.tsv](stability/limits.tsv) has the limit of each column over $2 \\sqrt{m/k}$ of the lightest\n"
      "disc, the bound over the limit and the cause.\n",
      out);
  for (int s = 0; s < SYSTEMS; s++) {
    const struct system *system = &systems[s];
    const struct axis *axes[] = {&system->other, &system->mass, &system->ratio, &system->damping};
    fprintf(out, "\n### %s\n\n%s\n", system->title, system->what);
    for (int a = 0; a < 4; a++)
      for (int k = 0; axes[a]->count > 1 && k < axes[a]->count; k++)
        fprintf(out, "%s%s%g", k ? ", " : "\n- ", k ? "" : axes[a]->name, axes[a]->values[k]);
    fprintf(out, "\n\n[%s.tsv](stability/%s.tsv) has all points.\n\n![Stability of the system %s](stability/%s.svg)\n",
            system->name, system->name, system->title, system->name);
  }
}

static void write_document(const char *document, const char *folder) {
  struct map maps[SYSTEMS];
  FILE *out = fopen(document, "w"), *limits = opened(folder, "limits");
  if (!out)
    fail(document);
  fputs("system\tplace\tmass\tratio\tdamping\tother\tlimit\truns\tbound\taccurate\tcause\n", limits);
  for (int s = 0; s < SYSTEMS; s++) {
    FILE *points = opened(folder, systems[s].name);
    maps[s] = map_of(&systems[s], points, limits, false);
    closed(points);
  }
  closed(limits);
  write_beginning(out);
  write_summary(out, maps);
  write_checks(out, maps);
  write_above(out, folder);
  write_below(out, 10000000);
  write_systems(out);
  closed(out);
}

/* ---- the test, TAP ---- */

/* Tests that the system causes no complaint. With a planted factor of the limit or of the bound it must cause one. */
static void test(int number, const struct system *system, const char *what, double of_limit, double of_bound) {
  const bool planted = of_limit > 1 || of_limit < 1 || of_bound > 1;
  wrong_limit = of_limit, wrong_bound = of_bound, complaints = 0, silent = planted;
  map_of(system, NULL, NULL, true);
  printf("%s %d - %s, %s\n", (complaints > 0) == planted ? "ok" : "not ok", number, system->name, what);
}

static void run_tests(void) {
  static const struct {
    const char *what;
    double limit, bound;
  } tests[] = {
      {"runs, eigenvalues and bound agree", 1, 1},
      {"a limit that is 2 % too long is detected", 1.02, 1},
      {"a limit that is 2 % too short is detected", 0.98, 1},
      {"a bound that is 2.2 times as long is detected", 1, 2.2},
  };
  enum { TESTS = sizeof tests / sizeof *tests };
  printf("1..%d\n", (int)(TESTS * SYSTEMS));
  for (int t = 0; t < TESTS; t++)
    for (int s = 0; s < SYSTEMS; s++)
      test(t * SYSTEMS + s + 1, &systems[s], tests[t].what, tests[t].limit, tests[t].bound);
}

int main(int argc, char **words) {
  const bool writes = argc == 4 && strcmp(words[1], "-o") == 0;
  if (argc > 1 && !writes)
    fail("usage: stability_maps [-o DOCUMENT FOLDER]");
  prepare_packing();
  if (writes)
    write_document(words[2], words[3]);
  else
    run_tests();
  nb_table_free(&packing_discs), nb_table_free(&packing_walls);
  return writes && complaints > 0;
}
