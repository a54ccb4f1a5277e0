/* Macros for the tables of a statement: its arguments and its words. Only the files of STATEMENTS include this header.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "scene.h"

/* Rows of arguments; `at` is a slot of the record. Required arguments have no default. */
/* clang-format off */
#define NAME(at, what) {NULL, "NAME", NB_ARGUMENT_NAME, NB_UNIT_NUMBER, NB_ANY, at, 1, NULL, what}
#define WORD(shown, at, what) {NULL, shown, NB_ARGUMENT_WORD, NB_UNIT_NUMBER, NB_ANY, at, 1, NULL, what}
#define CHOICE(word, words, at, otherwise, what) \
  {word, words, NB_ARGUMENT_CHOICE, NB_UNIT_NUMBER, NB_ANY, at, 1, otherwise, what}
#define VALUE(shown, unit, range, at, help) {NULL, shown, NB_ARGUMENT_NUMBER, unit, range, at, 1, NULL, help}
#define CLAUSE(word, shown, unit, range, at, count, otherwise, help) \
  {word, shown, NB_ARGUMENT_NUMBER, unit, range, at, count, otherwise, help}
#define COUNT(word, shown, at, otherwise, help) \
  {word, shown, NB_ARGUMENT_COUNT, NB_UNIT_NUMBER, NB_ANY, at, 1, otherwise, help}
#define FLAG(word, at, otherwise, help) {word, NULL, NB_ARGUMENT_FLAG, NB_UNIT_NUMBER, NB_ANY, at, 1, otherwise, help}
#define END {NULL, NULL, NB_ARGUMENT_FLAG, NB_UNIT_NUMBER, NB_ANY, 0, 0, NULL, NULL}
/* Arguments common to several statements. */
#define MATERIAL(at) WORD("MATERIAL", at, "the name of a material")
#define SHAPE(at) CHOICE(NULL, "discs|spheres", at, NULL, "`discs` or `spheres`") /* as enum nb_shape */
#define RADIUS(at) CLAUSE("radius", "R", NB_UNIT_LENGTH, NB_POSITIVE, at, 1, NULL, "Radius, half the diameter.")
#define VELOCITY(at, otherwise) \
  CLAUSE("velocity", "VX VY", NB_UNIT_VELOCITY, NB_ANY, at, 2, otherwise, "Velocity in x and y.")
#define CORNERS(at, other) \
  VALUE("X", NB_UNIT_LENGTH, NB_ANY, at, "x of the corner with the smallest x and y."), \
  VALUE("Y", NB_UNIT_LENGTH, NB_ANY, at + 1, "y of this corner."), \
  CLAUSE("to", "X Y", NB_UNIT_LENGTH, NB_ANY, other, 2, NULL, "The opposite corner.")
#define STRAIN_SIDES \
  VALUE("EXX", NB_UNIT_STRAIN_RATE, NB_ANY, NB_AT_XX, "Strain rate in x: above 0 extension, below 0 compression; a stress is above 0 in compression."), \
  VALUE("EYY", NB_UNIT_STRAIN_RATE, NB_ANY, NB_AT_YY, "Strain rate in y: above 0 extension, below 0 compression.")
#define STRAIN \
  STRAIN_SIDES, \
  CLAUSE("shear", "EXY", NB_UNIT_STRAIN_RATE, NB_ANY, NB_AT_XY, 1, "0", "Pure shear: c_12 = c_21 = EXY, without rotation. The engineering shear rate is 2 EXY; simple shear is `c12 G`."), \
  CLAUSE("c12", "C", NB_UNIT_STRAIN_RATE, NB_ANY, NB_AT_C12, 1, "0", "Velocity in x per unit of y."), \
  CLAUSE("c21", "C", NB_UNIT_STRAIN_RATE, NB_ANY, NB_AT_C21, 1, "0", "Velocity in y per unit of x.")
/* clang-format on */

/* A function that applies a statement; subject is the struct nb_scene_reading. A statement without arguments does not
 * use its record. */
#define NB_APPLY(name)                                                                                                 \
  static void name(struct nb_reader *reader, const struct nb_record *record __attribute__((unused)), void *subject)
/* The statements of a file, by the file's name; the last row is {0}. */
#define NB_STATEMENTS(file) const struct nb_keyword nb_statements_##file[]
