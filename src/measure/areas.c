/* Area of a disc inside a circle or a polygon, exact, by closed forms.
 *
 * The common area A of two intersecting circles consists of two circular segments. The circles have the radii r and R,
 * and their centres are d apart:
 *   A = r^2 (a - sin a cos a) + R^2 (b - sin b cos b)
 * a and b are half the angles that the common chord subtends at the centres of the circles of radii r and R. The
 * formula
 *   tan^2(a/2) = (R^2 - (d - r)^2)/((d + r)^2 - R^2),      and for b the same with r and R exchanged,
 * avoids the cancellation that the cosine of a suffers if the circles hardly intersect. R - r is computed first, so
 * that circles of nearly equal radii lose no digits.
 *
 * The common area of a disc and a polygon is a sum over the edges of the polygon. Each term is the area that the disc
 * shares with the triangle of the disc's centre and the edge, negative if the edge runs clockwise. The part of an edge
 * outside the disc contributes a sector, and the part inside the disc a triangle.
 *
 *   areas m2, lengths m, angles rad
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "areas.h"

double nb_area_of_disc(double radius) { return NB_PI * radius * radius; }

/* Area of the part of the circle of radius r that lies beyond the common chord, inside the circle of radius R, m2; d:
 * distance of the centres, m, between |R - r| and R + r. No factor is then negative, also when rounded. */
static double segment(double r, double R, double d) {
  const double difference = R - r, numerator = (R + r - d) * (d + difference),
               denominator = (d - difference) * (d + r + R);
  const double a = 2 * atan2(sqrt(numerator), sqrt(denominator));
  return r * r * (a - sin(a) * cos(a));
}

double nb_area_of_lens(double radius_a, double radius_b, double distance) {
  const double smaller = fmin(radius_a, radius_b), larger = fmax(radius_a, radius_b);
  if (distance >= larger + smaller)
    return 0;
  if (distance <= larger - smaller)
    return nb_area_of_disc(smaller);
  return segment(radius_a, radius_b, distance) + segment(radius_b, radius_a, distance);
}

/* Area of the sector of the circle of radius r between the directions a and b, m2; negative if clockwise. */
static double sector(struct nb_vec a, struct nb_vec b, double r) {
  return r * r * atan2(vec_cross(a, b), vec_dot(a, b)) / 2;
}

/* Area that the disc of radius r about the origin shares with the triangle of the origin, a and b, m2; negative if the
 * edge from a to b runs clockwise. */
static double area_at_edge(struct nb_vec a, struct nb_vec b, double r) {
  const struct nb_vec along = vec_sub(b, a);
  const double square = vec_dot(along, along), middle = vec_dot(a, along);
  const double root = middle * middle - square * (vec_dot(a, a) - r * r);
  if (!(root > 0))
    return sector(a, b, r);
  const double from = (-middle - sqrt(root)) / square, to = (-middle + sqrt(root)) / square;
  if (to <= 0 || from >= 1)
    return sector(a, b, r);
  const struct nb_vec in = from > 0 ? vec_add(a, vec_scale(from, along)) : a;
  const struct nb_vec out = to < 1 ? vec_add(a, vec_scale(to, along)) : b;
  return (from > 0 ? sector(a, in, r) : 0) + vec_cross(in, out) / 2 + (to < 1 ? sector(out, b, r) : 0);
}

double nb_area_in_polygon(struct nb_vec centre, double radius, const struct nb_vec corners[], size_t count) {
  double area = 0;
  for (size_t k = 0; k < count; k++)
    area += area_at_edge(vec_sub(corners[k], centre), vec_sub(corners[(k + 1) % count], centre), radius);
  return area;
}
