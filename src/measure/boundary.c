/* Area of the boundary of an assembly, and the stress on it.             [R89 sec. 6.4.1]
 *
 * The polygon through the centres of the boundary's particles has the area A = sum (x_i y_(i+1) - x_(i+1) y_i)/2, m2.
 * The stress of the assembly, compression positive, follows from the contact forces F on the boundary's particles at
 * the positions X relative to the boundary's centre; h is the thickness, m:
 *
 *   s_ij = sum F_i X_j / (A h)
 *
 * While the particles inside are in equilibrium, this equals the stress from all contacts, -sum f_i l_j / (A h). f is
 * the force on the first particle of a contact, N, and l the vector from the centre of the first particle to that of
 * the second, m.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "boundary.h"

double nb_boundary_area(const struct nb_model *model) {
  double twice = 0;
  for (size_t k = 0; k < model->boundary->ring.count; k++)
    twice += vec_cross(nb_boundary_position(model, k), nb_boundary_position(model, k + 1));
  return twice / 2;
}

double nb_boundary_radius(const struct nb_model *model) {
  const size_t count = model->boundary->ring.count;
  double sum = 0;
  for (size_t k = 0; k < count; k++)
    sum += vec_length(nb_boundary_position(model, k));
  return count ? sum / (double)count : 0;
}

double nb_boundary_roughness(const struct nb_model *model) {
  const size_t count = model->boundary->ring.count;
  const double mean = nb_boundary_radius(model);
  double sum = 0;
  for (size_t k = 0; k < count; k++) {
    const double error = vec_length(nb_boundary_position(model, k)) - mean;
    sum += error * error;
  }
  return count ? sqrt(sum / (double)count) / mean : 0;
}

struct nb_tensor nb_boundary_stress(const struct nb_model *model) {
  const struct nb_ring *ring = &model->boundary->ring;
  struct nb_tensor sum = tensor(0, 0, 0, 0);
  const double volume = nb_boundary_area(model) * nb_thickness(model);
  for (size_t k = 0; k < ring->count; k++)
    sum = tensor_add(sum,
                     tensor_outer(nb_force_on(model, (size_t)ring->member[k]).force, nb_boundary_position(model, k)));
  return volume > 0 ? tensor_scale(1 / volume, sum) : tensor(0, 0, 0, 0);
}
