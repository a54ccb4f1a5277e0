/* Moduli of a region if all particles moved with one uniform strain.          [Bathurst and Rothenburg 1988]
 *
 * With the strain eps the centres of two particles in contact, at the distance l, approach each other by l n.eps.n and
 * slide on each other by l t.eps.n. The energy of all contact springs in the volume V is
 *
 *   W = 1/(2V) sum (k_n (l n.eps.n)^2 + k_s (l t.eps.n)^2)
 *
 * so with W = K/2 (eps_1 + eps_2)^2 for an isotropic strain and W = G/2 (eps_1 - eps_2)^2 for the shear eps_1 = -eps_2
 * along x and y
 *
 *   bulk    K = 1/(4V) sum l^2 k_n
 *   shear   G = 1/(4V) sum l^2 (k_n cos^2 2 theta + k_s sin^2 2 theta)
 *
 *   k_n, k_s   present tangent stiffnesses of the contact, without dashpots, N/m; k_s = 0 without friction
 *   theta      direction of the contact normal n; t is normal to it
 *   V          area times thickness, m3; a contact of two particles inside counts once, others with the part of l inside
 *
 * Equilibrium has the least energy of all motions with the same displacements of the boundary [theorem of minimum
 * potential energy], so a uniform strain gives upper bounds, for contacts that neither open nor close nor slide.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "region.h"

void nb_measure_moduli(const struct nb_model *model, struct nb_region_state *region) {
  const struct nb_contacts *contacts = &model->contacts;
  const double volume = region->area * region->thickness;
  double bulk = 0, shear = 0;
  struct nb_end end;
  for (struct nb_ends ends = nb_ends_begin(model, region); nb_ends_next(&ends, &end);) {
    const bool has_shear = model->material_pairs[contacts->material_pair[end.contact]].shear;
    const double kn = contacts->kept[NB_STIFFNESS][end.contact];
    const double ks = has_shear ? contacts->kept[NB_SHEAR_STIFFNESS][end.contact] : 0;
    const double l = end.arm + (end.partner < 0 ? 0 : nb_contact_arm(model, end.contact, (size_t)end.partner));
    const double cos2 = end.e.x * end.e.x - end.e.y * end.e.y, sin2 = 2 * end.e.x * end.e.y;
    bulk += end.arm * l * kn;
    shear += end.arm * l * (kn * cos2 * cos2 + ks * sin2 * sin2);
  }
  region->moduli.bulk = volume > 0 ? bulk / (4 * volume) : 0;
  region->moduli.shear = volume > 0 ? shear / (4 * volume) : 0;
}
