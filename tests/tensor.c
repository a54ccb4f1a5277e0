/* Plane tensors, compared with their definitions.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <gsl/gsl_eigen.h>
#include <math.h>

#include "../src/core/tensor.h"
#include "chance.h"
#include "suites.h"

static const double pi = 3.14159265358979323846;

static void sums_and_products(void) {
  const struct nb_tensor a = tensor(1, 2, 3, 4), b = tensor(10, 20, 40, 70);
  const struct nb_tensor sum = tensor_add(a, b), rest = tensor_sub(b, a), twice = tensor_scale(2, b);
  CU_ASSERT(sum.xx == 11 && sum.xy == 22 && sum.yx == 43 && sum.yy == 74);
  CU_ASSERT(rest.xx == 9 && rest.xy == 18 && rest.yx == 37 && rest.yy == 66);
  CU_ASSERT(twice.xx == 20 && twice.xy == 40 && twice.yx == 80 && twice.yy == 140);
  const struct nb_vec v = tensor_times(a, vec(5, 7));
  CU_ASSERT(v.x == 5 + 14 && v.y == 15 + 28);
  const struct nb_tensor outer = tensor_outer(vec(2, 3), vec(5, 7));
  CU_ASSERT(outer.xx == 10 && outer.xy == 14 && outer.yx == 15 && outer.yy == 21);
  const struct nb_tensor even = tensor_symmetric(b);
  CU_ASSERT(even.xx == 10 && even.xy == 30 && even.yx == 30 && even.yy == 70);
  CU_ASSERT(tensor_trace(b) == 80 && tensor_mean(b) == 40);
}

/* Principal values are eigenvalues of the symmetric part; the direction is the eigenvector of the major one. */
static void principal(void) {
  gsl_eigen_symmv_workspace *room = gsl_eigen_symmv_alloc(2);
  gsl_matrix *matrix = gsl_matrix_alloc(2, 2), *vectors = gsl_matrix_alloc(2, 2);
  gsl_vector *values = gsl_vector_alloc(2);
  struct chance dice = chance_begin(1);
  for (int n = 0; n < 200; n++) {
    double part[4];
    for (int k = 0; k < 4; k++)
      part[k] = chance_between(&dice, -1, 1);
    const struct nb_tensor a = tensor(part[0], part[1], part[2], part[3]);
    gsl_matrix_set(matrix, 0, 0, a.xx);
    gsl_matrix_set(matrix, 0, 1, (a.xy + a.yx) / 2);
    gsl_matrix_set(matrix, 1, 0, (a.xy + a.yx) / 2);
    gsl_matrix_set(matrix, 1, 1, a.yy);
    gsl_eigen_symmv(matrix, values, vectors, room);
    gsl_eigen_symmv_sort(values, vectors, GSL_EIGEN_SORT_VAL_DESC);
    CU_ASSERT_DOUBLE_EQUAL(tensor_major(a), gsl_vector_get(values, 0), 1e-14);
    CU_ASSERT_DOUBLE_EQUAL(tensor_minor(a), gsl_vector_get(values, 1), 1e-14);
    CU_ASSERT_DOUBLE_EQUAL(tensor_radius(a), (gsl_vector_get(values, 0) - gsl_vector_get(values, 1)) / 2, 1e-14);
    const double angle = tensor_angle(a); /* an eigenvector may point either way */
    const double across = cos(angle) * gsl_matrix_get(vectors, 1, 0) - sin(angle) * gsl_matrix_get(vectors, 0, 0);
    CU_ASSERT_DOUBLE_EQUAL(across, 0, 1e-15 / tensor_radius(a) + 1e-14);
    CU_ASSERT(angle > -pi / 2 && angle <= pi / 2);
  }
  gsl_eigen_symmv_free(room);
  gsl_matrix_free(matrix);
  gsl_matrix_free(vectors);
  gsl_vector_free(values);
}

static void directions(void) {
  CU_ASSERT(tensor_angle(tensor(2, 0, 0, 1)) == 0);
  CU_ASSERT_DOUBLE_EQUAL(tensor_angle(tensor(1, 0, 0, 2)), pi / 2, 0);
  CU_ASSERT_DOUBLE_EQUAL(tensor_angle(tensor(1, -0., -0., 2)), pi / 2, 0);
  CU_ASSERT_DOUBLE_EQUAL(tensor_angle(tensor(0, 1, 1, 0)), pi / 4, 1e-16);
  CU_ASSERT_DOUBLE_EQUAL(tensor_angle(tensor(0, -1, -1, 0)), -pi / 4, 1e-16);
  CU_ASSERT(tensor_angle(tensor(3, 0, 0, 3)) == 0);
  CU_ASSERT(tensor_angle(tensor(0, 1, -1, 0)) == 0); /* a rotation stretches nothing */
}

static void largest_component(void) {
  CU_ASSERT_EQUAL(tensor_largest(tensor(0, 0, 0, 0)), 0);
  CU_ASSERT_EQUAL(tensor_largest(tensor(-9, 1, 2, -3)), 9);
  CU_ASSERT_EQUAL(tensor_largest(tensor(1, -8, 2, 3)), 8);
  CU_ASSERT_EQUAL(tensor_largest(tensor(-1, 2, -7, 3)), 7);
  CU_ASSERT_EQUAL(tensor_largest(tensor(1, -2, 3, -6)), 6);
}

void suite_tensor(void) {
  CU_pSuite suite = CU_add_suite("tensor", NULL, NULL);
  CU_add_test(suite, "sums and products by components", sums_and_products);
  CU_add_test(suite, "principal values and direction are eigenvalues and eigenvector", principal);
  CU_add_test(suite, "direction of the major value in every quadrant", directions);
  CU_add_test(suite, "the largest component", largest_component);
}
