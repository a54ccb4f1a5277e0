/* Mass and moment of inertia of particles and constants of a contact, computed from the numbers of the page. The
 * references never call the functions of the simulator for these numbers, so that an error in either of the two is
 * found.
 *
 *   disc     a cylinder 1 m long    m = rho pi R^2,          I = m R^2/2        any textbook of mechanics
 *   sphere                          m = rho (4/3) pi R^3,    I = 2 m R^2/5
 *
 *   k        stiffness, N/m: each particle contributes a spring 2 k of its own material, and the two are in series:
 *            1/k = 1/(2 k_a) + 1/(2 k_b)
 *   mu, c    friction and cohesion: the smaller ones [CS79 19]
 *   E*       1/E* = (1 - nu_a^2)/E_a + (1 - nu_b^2)/E_b                         [R89 4.7]
 *   G*       1/G* = (2 - nu_a)/G_a + (2 - nu_b)/G_b,   G = E/(2 (1 + nu))       [R89 4.8-4.10]
 *   R*       1/R* = 1/R_a + 1/R_b, with 1/R_b = 0 for a wall                    Johnson, Contact Mechanics, 4.2
 *
 * The numbers of a `pair` statement replace k, mu and c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "nineball.h"

double matter_mass(const struct nb_scene *scene, const struct nb_particle *particle);    /* kg */
double matter_inertia(const struct nb_scene *scene, const struct nb_particle *particle); /* kg m2 */

struct matter_pair {
  double kn, ks;   /* N/m */
  double friction; /* 1 */
  double cohesion; /* N */
  double young;    /* E*, Pa; 0 if a material has no `young` */
  double shear;    /* G*, Pa */
};
struct matter_pair matter_pair(const struct nb_scene *scene, int material_a, int material_b);

double matter_radius(double a, double b); /* R*, m; the radius of a wall is INFINITY */
