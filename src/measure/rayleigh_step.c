/* The Rayleigh step: the time in which a surface wave travels half round a sphere.                 [R89 4.29-4.34]
 *
 *   t_R = pi R (rho/G)^(1/2) / alpha                                   [R89 4.33]
 *
 *   t_R    Rayleigh step, s
 *   R      radius of the sphere with the shortest t_R, or the mean of all radii with the means of rho, G and nu, m
 *   rho    density, kg/m3
 *   G      shear modulus E/(2 (1 + nu)), Pa, from Young's modulus E and Poisson's ratio nu
 *   alpha  speed of Rayleigh waves over the speed of shear waves, c_2 = (G/rho)^(1/2), m/s; the root of
 *
 *            (2 - alpha^2)^2 = 4 (1 - alpha^2)^(1/2) (1 - q alpha^2)^(1/2),   q = c_2^2/c_1^2 = (1 - 2 nu)/(2 (1 - nu))
 *
 *          between 0.87 (nu = 0: 0.874032) and 0.96 (nu = 0.5: 0.955313), where c_1 is the speed of compression waves,
 *          m/s. [R89 4.32] is the square of this equation, which has further roots. R89 uses the straight line
 *          0.1631 nu + 0.876605 [R89 4.34], which is between 0.22 % too small and 0.30 % too large.
 *
 * Range      t_R does not depend on contacts. Divided by the duration of a collision, t_R is proportional to v^(1/5),
 *            where v is the approach velocity, m/s (hertz_impact.h). Fixed particles and rigid materials are left out.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "step.h"

double nb_rayleigh_root(double poisson) {
  const double q = (1 - 2 * poisson) / (2 * (1 - poisson));
  double low = 0.87, high = 0.96;
  for (;;) { /* below the root the left side is smaller */
    const double alpha = low + (high - low) / 2, square = alpha * alpha, left = (2 - square) * (2 - square);
    if (!(alpha > low && alpha < high))
      return low;
    if (left < 4 * sqrt((1 - square) * (1 - q * square)))
      low = alpha;
    else
      high = alpha;
  }
}

double nb_rayleigh_fit(double poisson) { return 0.1631 * poisson + 0.876605; }

/* The properties of a sphere, or the means of all spheres. */
struct sphere {
  double radius, density, shear, poisson;
};

static double time_of(struct sphere sphere, bool fit) {
  const double alpha = fit ? nb_rayleigh_fit(sphere.poisson) : nb_rayleigh_root(sphere.poisson);
  return NB_PI * sphere.radius * sqrt(sphere.density / sphere.shear) / alpha;
}

double nb_step_rayleigh(const struct nb_model *model, bool fit, bool mean) {
  const struct nb_particles *particles = &model->particles;
  struct sphere sum = {0};
  double shortest = INFINITY, count = 0;
  for (size_t k = 0; k < particles->count; k++) { /* the sums run in the order of numbers */
    const int i = particles->slot[k];
    const struct nb_material *material = &model->scene->materials[particles->material[i]];
    if (!(particles->inverse_mass[i] > 0 && material->young > 0 && material->young < INFINITY))
      continue;
    const double nu = material->poisson;
    const struct sphere sphere = {particles->radius[i], material->density, material->young / (2 * (1 + nu)), nu};
    if (!mean) {
      const double time = time_of(sphere, fit);
      shortest = time < shortest ? time : shortest;
    }
    sum.radius += sphere.radius, sum.density += sphere.density, sum.shear += sphere.shear, sum.poisson += nu;
    count++;
  }
  if (!mean || !(count > 0))
    return shortest;
  return time_of((struct sphere){sum.radius / count, sum.density / count, sum.shear / count, sum.poisson / count}, fit);
}
