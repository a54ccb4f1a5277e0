/* Particles, alone and in lattices: `disc`, `sphere`, `lattice`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>

#include "packing/packing.h"
#include "statement.h"

enum { AT_X, AT_Y, AT_RADIUS, AT_MATERIAL, AT_VX, AT_VY, AT_SPIN, AT_FIXED };
enum { AT_SHAPE = AT_VX, AT_NX, AT_NY, AT_SPACING, AT_SQUARE, AT_HEXAGONAL };

/* clang-format off */
static const struct nb_argument particle_fields[] = {
  VALUE("X", NB_UNIT_LENGTH, NB_ANY, AT_X, "x of the centre."),
  VALUE("Y", NB_UNIT_LENGTH, NB_ANY, AT_Y, "y of the centre."),
  RADIUS(AT_RADIUS),
  MATERIAL(AT_MATERIAL),
  VELOCITY(AT_VX, "0 0"),
  CLAUSE("spin", "W", NB_UNIT_SPIN, NB_ANY, AT_SPIN, 1, "0", "Angular velocity, counterclockwise."),
  FLAG("fixed", AT_FIXED, "free", "Forces do not move the particle, and its mass counts as infinite: it keeps its `velocity` and its `spin`. Two fixed particles have no contact."),
  END
};
static const struct nb_argument lattice_fields[] = {
  SHAPE(AT_SHAPE),
  FLAG("square", AT_SQUARE, "`square`, unless `hexagonal` is given", "The rows are exactly above each other."),
  FLAG("hexagonal", AT_HEXAGONAL, "`square`", "Every second row is shifted by half a spacing in x, and the distance of rows is sqrt(3)/2 of the spacing: six neighbours at equal distance."),
  COUNT(NULL, "NX", AT_NX, NULL, "Number of particles in a row, in x."),
  COUNT("by", "NY", AT_NY, NULL, "Number of rows, in y."),
  CLAUSE("from", "X Y", NB_UNIT_LENGTH, NB_ANY, AT_X, 2, "R R", "Centre of the first particle, which has the smallest x and y."),
  RADIUS(AT_RADIUS),
  CLAUSE("spacing", "S", NB_UNIT_LENGTH, NB_POSITIVE, AT_SPACING, 1, "2R", "Distance of the centres; at 2R they touch."),
  MATERIAL(AT_MATERIAL),
  END
};
/* clang-format on */

bool nb_too_many_particles(struct nb_reader *reader, const struct nb_scene *scene, size_t more) {
  if (scene->particle_count + more > NB_PARTICLES_MAX)
    nb_token_mistake(reader, &reader->tokens[0], NULL, "expected at most %d particles, found %zu with this statement",
                     NB_PARTICLES_MAX, scene->particle_count + more);
  return reader->bad;
}

bool nb_particles_incomplete(const struct nb_scene_reading *reading) {
  static const char *const words[] = {"disc", "sphere", "lattice", "fill", "packing", "start"};
  bool incomplete = false;
  for (size_t k = 0; k < sizeof words / sizeof *words; k++)
    incomplete = incomplete || nb_statement_suppressed(reading->reader.mistakes, words[k]);
  return incomplete;
}

struct nb_particle nb_particle_of(struct nb_reader *reader, const struct nb_scene *scene, enum nb_shape shape,
                                  const struct nb_token *material, bool fixed, size_t count) {
  struct nb_particle particle = {.shape = shape, .fixed = fixed, .line = (int)reader->line};
  particle.material = nb_material_of(scene, reader, material);
  if (!reader->bad && scene->materials[particle.material].density == 0 && !fixed)
    nb_expected_at(reader, material,
                   "give the material a `density`, or hold the particle with `fixed` in a line `disc` or `sphere`",
                   "a material with a density for a free particle");
  nb_too_many_particles(reader, scene, count);
  return particle;
}

/* variant: enum nb_shape */
NB_APPLY(apply_particle) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_value *value = record->value;
  struct nb_particle one = nb_particle_of(reader, scene, (enum nb_shape)record->keyword->variant,
                                          value[AT_MATERIAL].token, value[AT_FIXED].token != NULL, 1);
  one.x = value[AT_X].number, one.y = value[AT_Y].number, one.radius = value[AT_RADIUS].number;
  one.vx = value[AT_VX].number, one.vy = value[AT_VY].number, one.spin = value[AT_SPIN].number;
  if (!reader->bad)
    NB_APPEND(reader, scene->particles, scene->particle_count, one);
}

NB_APPLY(apply_lattice) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_value *value = record->value;
  const double radius = value[AT_RADIUS].number;
  const bool from = value[AT_X].token != NULL, spaced = value[AT_SPACING].token != NULL;
  const struct nb_lattice like = {
      .nx = (size_t)value[AT_NX].number,
      .ny = (size_t)value[AT_NY].number,
      .x = from ? value[AT_X].number : radius,
      .y = from ? value[AT_Y].number : radius,
      .spacing = spaced ? value[AT_SPACING].number : 2 * radius,
      .hexagonal = value[AT_HEXAGONAL].token != NULL,
  };
  struct nb_particle one = nb_particle_of(reader, scene, (enum nb_shape)value[AT_SHAPE].number,
                                          value[AT_MATERIAL].token, false, like.nx * like.ny);
  const double far_x = like.x + like.spacing * (double)like.nx, far_y = like.y + like.spacing * (double)like.ny;
  one.radius = radius;
  if (value[AT_HEXAGONAL].token && value[AT_SQUARE].token)
    nb_token_mistake(reader, value[AT_HEXAGONAL].token, NULL, "expected `square` or `hexagonal`, found both");
  if (!(isfinite(far_x) && isfinite(far_y)))
    nb_token_mistake(reader, &reader->tokens[0], NULL,
                     "expected a lattice with finite coordinates; this one is too large");
  if (!reader->bad && !nb_fill_lattice(scene, like, one))
    nb_no_memory(reader);
}

/* clang-format off */
NB_STATEMENTS(particle) = {
  {"disc", NB_IN_SCENE, particle_fields, NULL, NB_DISC, false, apply_particle,
   "Adds one disc, a cylinder 1 m thick: its mass is the density times pi R^2 times 1 m. Particles are numbered from 1 in the order of the page.",
   "disc      35.02 mm 60 mm  radius 5 mm  steel  spin -3 rad/s  velocity -$speed 0 m/s"},
  {"sphere", NB_IN_SCENE, particle_fields, NULL, NB_SPHERE, false, apply_particle,
   "Adds one sphere, which moves in the plane: its mass is the density times 4/3 pi R^3. Particles are numbered from 1 in the order of the page.",
   "sphere    25 mm 60 mm  radius 5 mm  glass"},
  {"lattice", NB_IN_SCENE, lattice_fields, NULL, 0, false, apply_lattice,
   "Adds discs or spheres on a lattice. They are numbered along the first row in x, then along the next row in y, and so on.",
   "lattice   discs 3 by 2  from 15 mm 15 mm  radius 5 mm  spacing 12 mm  glass\n"
   "lattice   spheres hexagonal 2 by 1  from 15 mm 40 mm  radius 5 mm  steel"},
  {0},
};
/* clang-format on */
