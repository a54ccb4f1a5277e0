/* What the statements of scene blocks take: for each row of scene_table.c the values and clauses, their slots in the record,
 * and what the manual says of them. For scene_table.c alone.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_SCENE_FIELDS_H
#define NB_SCENE_FIELDS_H

#include "scene.h"

/* clang-format off */

/* Ways to write a row: what must be there has no default. Words and names say what they are; numbers which unit. */
#define NAME(at, what) {NULL, "NAME", NB_ARGUMENT_NAME, NB_UNIT_NUMBER, NB_ANY, at, 1, NULL, what}
#define WORD(shown, at, what) {NULL, shown, NB_ARGUMENT_WORD, NB_UNIT_NUMBER, NB_ANY, at, 1, NULL, what}
#define VALUE(shown, unit, range, at, help) {NULL, shown, NB_ARGUMENT_NUMBER, unit, range, at, 1, NULL, help}
#define CLAUSE(word, shown, unit, range, at, count, otherwise, help) \
  {word, shown, NB_ARGUMENT_NUMBER, unit, range, at, count, otherwise, help}
#define COUNT(word, shown, at, help) {word, shown, NB_ARGUMENT_COUNT, NB_UNIT_NUMBER, NB_ANY, at, 1, NULL, help}
#define FLAG(word, at, otherwise, help) {word, NULL, NB_ARGUMENT_FLAG, NB_UNIT_NUMBER, NB_ANY, at, 1, otherwise, help}
#define END {NULL, NULL, NB_ARGUMENT_FLAG, NB_UNIT_NUMBER, NB_ANY, 0, 0, NULL, NULL}

#define MATERIAL WORD("MATERIAL", AT_MATERIAL, "the name of a material")
#define RADIUS CLAUSE("radius", "R", NB_UNIT_LENGTH, NB_POSITIVE, AT_RADIUS, 1, NULL, "Radius.")
#define VELOCITY(otherwise) \
  CLAUSE("velocity", "VX VY", NB_UNIT_VELOCITY, NB_ANY, AT_VX, 2, otherwise, "Velocity to the east and to the north.")
#define PAIR_CLAUSE(name, shown, unit, range, otherwise, help) \
  CLAUSE(#name, shown, NB_UNIT_##unit, NB_##range, AT_##name, 1, otherwise, help),
#define OF_MATERIAL(name, shown, unit, range, otherwise, rule, help) PAIR_CLAUSE(name, shown, unit, range, otherwise, help)
#define OF_PAIR(name, shown, unit, range, otherwise, rule, help) PAIR_CLAUSE(name, shown, unit, range, MAKES_##rule, help)
#define OF_CHANGE(name, shown, unit, range, otherwise, rule, help) PAIR_CLAUSE(name, shown, unit, range, "as it was", help)
#define MAKES_series "2ab/(a+b)"
#define MAKES_smaller "the smaller one"

static const struct nb_argument nothing[] = {END};
static const struct nb_argument units[] = {WORD("none|si", AT_NAME, "`none` or `si`"), END};
static const struct nb_argument name_of_value[] = {NAME(AT_NAME, "a name for the value"), END};
static const struct nb_argument law[] = {WORD("LAW", AT_NAME, "the name of a law"), END};
static const struct nb_argument shear_law[] = {
  WORD("LAW", AT_NAME, "the name of a law"),
  {"pieces", "K", NB_ARGUMENT_COUNT, NB_UNIT_NUMBER, NB_ANY, AT_PIECES, 1, "as many as the law likes best",
   "How much of a contact's history is kept, by a law that keeps it."},
  END
};
static const struct nb_argument material[] = {
  NAME(AT_NAME, "a name for the material"),
  CLAUSE("density", "D", NB_UNIT_DENSITY, NB_NOT_NEGATIVE, AT_DENSITY, 1, "0",
         "Mass per volume; a free body needs it."),
  NB_PAIR_ROWS(OF_MATERIAL)
  CLAUSE("young", "E", NB_UNIT_PRESSURE, NB_POSITIVE, AT_YOUNG, 1, "none",
         "Young's modulus, for the laws of elastic spheres [R89 4.7]."),
  CLAUSE("poisson", "NU", NB_UNIT_NUMBER, NB_HALF, AT_POISSON, 1, "0", "Poisson's ratio, 0 to 0.5."),
  FLAG("rigid", AT_RIGID, "elastic", "Of infinite Young's modulus: what touches it has all the deformation."),
  END
};
static const struct nb_argument pair[] = {
  WORD("MATERIAL", AT_NAME, "the name of a material"),
  WORD("MATERIAL", AT_NAME2, "the name of a material"),
  NB_PAIR_ROWS(OF_PAIR)
  END
};
static const struct nb_argument material_change[] = {
  WORD("NAME", AT_NAME, "the name of a material"),
  NB_PAIR_ROWS(OF_CHANGE)
  END
};
static const struct nb_argument pair_change[] = {
  WORD("MATERIAL", AT_NAME, "the name of a material"),
  WORD("MATERIAL", AT_NAME2, "the name of a material"),
  NB_PAIR_ROWS(OF_CHANGE)
  END
};
static const struct nb_argument gravity[] = {
  VALUE("GX", NB_UNIT_ACCELERATION, NB_ANY, AT_X, "Acceleration to the east."),
  VALUE("GY", NB_UNIT_ACCELERATION, NB_ANY, AT_Y, "Acceleration to the north."),
  END
};
static const struct nb_argument centripetal[] = {
  VALUE("G", NB_UNIT_ACCELERATION, NB_ANY, AT_SPEED, "Acceleration towards the point, the same at any distance."),
  CLAUSE("about", "X Y", NB_UNIT_LENGTH, NB_ANY, AT_X, 2, NULL, "The point."),
  END
};
static const struct nb_argument circle[] = {
  VALUE("X", NB_UNIT_LENGTH, NB_ANY, AT_X, "Centre, to the east."),
  VALUE("Y", NB_UNIT_LENGTH, NB_ANY, AT_Y, "Centre, to the north."),
  RADIUS,
  END
};
#define STRAIN \
  VALUE("EXX", NB_UNIT_STRAIN_RATE, NB_ANY, AT_X, "Of length to the east; extension is positive."), \
  VALUE("EYY", NB_UNIT_STRAIN_RATE, NB_ANY, AT_Y, "Of length to the north."), \
  CLAUSE("shear", "EXY", NB_UNIT_STRAIN_RATE, NB_ANY, AT_SHEAR, 1, "0", "Of shape: c_12 = c_21 = EXY, which turns nothing."), \
  CLAUSE("c12", "C", NB_UNIT_STRAIN_RATE, NB_ANY, AT_C12, 1, "0", "Velocity to the east for a unit of way to the north."), \
  CLAUSE("c21", "C", NB_UNIT_STRAIN_RATE, NB_ANY, AT_C21, 1, "0", "Velocity to the north for a unit of way to the east.")
static const struct nb_argument strain[] = {STRAIN, END};
static const struct nb_argument box_strain[] = {
  VALUE("EXX", NB_UNIT_STRAIN_RATE, NB_ANY, AT_X, "Of length to the east; extension is positive."),
  VALUE("EYY", NB_UNIT_STRAIN_RATE, NB_ANY, AT_Y, "Of length to the north."),
  END
};
static const struct nb_argument continuum_strain[] = {
  STRAIN,
  FLAG("apart", AT_APART, "apart", "What carries a body along is no part of its own velocity [R89 4.41]."),
  FLAG("literal", AT_LITERAL, "apart",
       "The equations as R89 codes them: what carries a body along is added to its velocity in every cycle and stays there."),
  END
};
static const struct nb_argument pressure[] = {
  VALUE("P", NB_UNIT_PRESSURE, NB_ANY, AT_SPEED, "What it should be; compression is positive."),
  END
};
static const struct nb_argument servo_stress[] = {
  CLAUSE("xx", "S", NB_UNIT_PRESSURE, NB_ANY, AT_X, 1, "left alone", "What it should be; compression is positive."),
  CLAUSE("yy", "S", NB_UNIT_PRESSURE, NB_ANY, AT_Y, 1, "left alone", "Likewise."),
  CLAUSE("xy", "S", NB_UNIT_PRESSURE, NB_ANY, AT_SHEAR, 1, "left alone", "Likewise."),
  END
};
static const struct nb_argument stress[] = {
  VALUE("SXX", NB_UNIT_PRESSURE, NB_ANY, AT_X, "Compression is positive."),
  VALUE("SYY", NB_UNIT_PRESSURE, NB_ANY, AT_Y, "Likewise."),
  CLAUSE("shear", "SXY", NB_UNIT_PRESSURE, NB_ANY, AT_SHEAR, 1, "0", "The same on both pairs of sides."),
  END
};
static const struct nb_argument body[] = {
  VALUE("X", NB_UNIT_LENGTH, NB_ANY, AT_X, "Centre, to the east."),
  VALUE("Y", NB_UNIT_LENGTH, NB_ANY, AT_Y, "Centre, to the north."),
  RADIUS,
  MATERIAL,
  VELOCITY("0 0"),
  CLAUSE("spin", "W", NB_UNIT_SPIN, NB_ANY, AT_SPIN, 1, "0", "Angular velocity, counterclockwise."),
  FLAG("fixed", AT_FIXED, "free", "Held where it is; its mass counts as infinite."),
  END
};
static const struct nb_argument grading[] = {NAME(AT_NAME, "a name for the grading"), END};
#define FILLING \
  WORD("GRADING", AT_GRADING, "the name of a grading"), \
  MATERIAL, \
  COUNT("seed", "N", AT_SEED, "Which of all random packings it is."), \
  COUNT("tries", "N", AT_TRIES, "How many places are tried for each body, at most 1000000."), \
  {"else", "stop|skip", NB_ARGUMENT_WORD, NB_UNIT_NUMBER, NB_ANY, AT_ELSE, 1, NULL, "`stop` or `skip`"}
static const struct nb_argument fill_circle[] = {
  VALUE("X", NB_UNIT_LENGTH, NB_ANY, AT_X, "Centre of the circle, to the east."),
  VALUE("Y", NB_UNIT_LENGTH, NB_ANY, AT_Y, "Centre of the circle, to the north."),
  CLAUSE("radius", "R", NB_UNIT_LENGTH, NB_POSITIVE, AT_RADIUS, 1, NULL, "Radius of the circle."),
  FILLING,
  END
};
static const struct nb_argument fill_box[] = {
  VALUE("X", NB_UNIT_LENGTH, NB_ANY, AT_X, "South-west corner, to the east."),
  VALUE("Y", NB_UNIT_LENGTH, NB_ANY, AT_Y, "South-west corner, to the north."),
  CLAUSE("to", "X Y", NB_UNIT_LENGTH, NB_ANY, AT_X1, 2, NULL, "North-east corner."),
  FILLING,
  END
};
#define FILE_NAME WORD("FILE", AT_NAME, "the name of a file")
static const struct nb_argument packing[] = {FILE_NAME, END};
static const struct nb_argument packing_of[] = {FILE_NAME, MATERIAL, END};
static const struct nb_argument lattice[] = {
  FLAG("square", AT_SQUARE, "the same", "Rows above each other."),
  FLAG("hexagonal", AT_HEXAGONAL, "square", "Every second row half a spacing to the east, rows sqrt(3)/2 of it apart: six neighbours, equally far."),
  COUNT(NULL, "NX", AT_NX, "How many from west to east."),
  COUNT("by", "NY", AT_NY, "How many rows, from south to north."),
  CLAUSE("from", "X Y", NB_UNIT_LENGTH, NB_ANY, AT_X, 2, "R R", "Centre of the first one, in the south-west."),
  RADIUS,
  CLAUSE("spacing", "S", NB_UNIT_LENGTH, NB_POSITIVE, AT_SPACING, 1, "2R", "From centre to centre; 2R: touching."),
  MATERIAL,
  END
};
static const struct nb_argument box[] = {
  VALUE("X", NB_UNIT_LENGTH, NB_ANY, AT_X, "South-west corner, to the east."),
  VALUE("Y", NB_UNIT_LENGTH, NB_ANY, AT_Y, "South-west corner, to the north."),
  CLAUSE("to", "X Y", NB_UNIT_LENGTH, NB_ANY, AT_X1, 2, NULL, "North-east corner."),
  MATERIAL,
  END
};
static const struct nb_argument wall[] = {
  NAME(AT_NAME, "a name for the wall"),
  VALUE("X", NB_UNIT_LENGTH, NB_ANY, AT_X, "First end, to the east."),
  VALUE("Y", NB_UNIT_LENGTH, NB_ANY, AT_Y, "First end, to the north."),
  CLAUSE("to", "X Y", NB_UNIT_LENGTH, NB_ANY, AT_X1, 2, NULL, "Second end."),
  MATERIAL,
  CLAUSE("about", "X Y", NB_UNIT_LENGTH, NB_ANY, AT_ABOUT_X, 2, "its middle",
         "The point P that it turns about and whose velocity is given [CS79 figure 4]; it need not be on the wall."),
  VELOCITY("0 0"),
  CLAUSE("spin", "W", NB_UNIT_SPIN, NB_ANY, AT_SPIN, 1, "0", "Angular velocity about P, counterclockwise."),
  END
};
static const struct nb_argument cell[] = {
  VALUE("X", NB_UNIT_LENGTH, NB_ANY, AT_X, "South-west corner, to the east."),
  VALUE("Y", NB_UNIT_LENGTH, NB_ANY, AT_Y, "South-west corner, to the north."),
  CLAUSE("to", "X Y", NB_UNIT_LENGTH, NB_ANY, AT_X1, 2, NULL, "North-east corner."),
  END
};
static const struct nb_argument wave[] = {
  VALUE("VX", NB_UNIT_VELOCITY, NB_ANY, AT_VX, "To the east, where it is largest."),
  VALUE("VY", NB_UNIT_VELOCITY, NB_ANY, AT_VY, "To the north, where it is largest."),
  END
};
static const struct nb_argument skin[] = {VALUE("LENGTH", NB_UNIT_LENGTH, NB_POSITIVE, AT_SKIN, "How near."), END};
static const struct nb_argument place[] = {
  {"mirror", "none|x|y", NB_ARGUMENT_WORD, NB_UNIT_NUMBER, NB_ANY, AT_NAME, 1, "none", "`none`, `x` or `y`"},
  CLAUSE("turn", "ANGLE", NB_UNIT_ANGLE, NB_ANY, AT_ANGLE, 1, "0", "Counterclockwise; quarters of a turn are exact."),
  CLAUSE("shift", "X Y", NB_UNIT_LENGTH, NB_ANY, AT_X, 2, "0 0", "To the east and to the north."),
  END
};
static const struct nb_argument watch[] = {NAME(AT_NAME, "a name for what is watched"), END};
static const struct nb_argument region[] = {NAME(AT_NAME, "a name for the region"), END};
static const struct nb_argument impact[] = {
  WORD("WATCH", AT_NAME, "the name of a watched contact"),
  CLAUSE("speed", "V", NB_UNIT_VELOCITY, NB_POSITIVE, AT_SPEED, 1, NULL,
         "Of the sphere's centre, relative to what it strikes."),
  CLAUSE("angle", "A", NB_UNIT_ANGLE, NB_NOT_NEGATIVE, AT_ANGLE, 1, "from `psi1`",
         "Between that velocity and the normal of the contact, below 90 deg."),
  CLAUSE("psi1", "P", NB_UNIT_NUMBER, NB_NOT_NEGATIVE, AT_PSI1, 1, "from `angle`",
         "The same as a pure number, V_T/(mu kappa V_N) of the point that will touch, spin included [R89 5.15]: kappa = "
         "E*/(4 G*), or k_n/k_s of linear springs."),
  CLAUSE("phase", "F", NB_UNIT_NUMBER, NB_SHARE, AT_PHASE, 1, "0", "It first touches when this much of the first step is over."),
  END
};
static const struct nb_argument start[] = {
  WORD("PAGE", AT_NAME, "the name of another page"),
  {"stage", "NAME", NB_ARGUMENT_WORD, NB_UNIT_NUMBER, NB_ANY, AT_NAME2, 1, NULL, "Where it begins: at the end of that stage of the other page."},
  END
};
static const struct nb_argument stage[] = {NAME(AT_NAME, "a name for the stage"), END};
static const struct nb_argument leg[] = {NAME(AT_NAME, "a name for the leg"), END};
static const struct nb_argument walls[] = {
  CLAUSE("inward", "V", NB_UNIT_VELOCITY, NB_ANY, AT_INWARD, 1, "none",
         "Each wall of the box along its normal to the inside."),
  FLAG("stop", AT_STOP, "none", "All walls stand still."),
  END
};
static const struct nb_argument wall_motion[] = {
  WORD("NAME", AT_NAME, "the name of a wall"),
  VELOCITY("as before"),
  CLAUSE("spin", "W", NB_UNIT_SPIN, NB_ANY, AT_SPIN, 1, "as before", "Angular velocity about P, counterclockwise."),
  END
};
static const struct nb_argument cycles[] = {COUNT(NULL, "N", AT_CYCLES, "a number of cycles"), END};

/* clang-format on */

#endif
