/* Bounds of the moduli of a region.                                  [Bathurst and Rothenburg 1988; Agnolin and Roux 2007]
 *
 * Suppose that all particles move with one uniform strain eps. The centres of two particles in contact, at the distance
 * l, m, then approach each other by l n.eps.n, and the particles slide on each other by l t.eps.n. The energy of all
 * contact springs per volume V is
 *
 *   W = 1/(2V) sum (k_n (l n.eps.n)^2 + k_s (l t.eps.n)^2)
 *
 * With W = K/2 (eps_1 + eps_2)^2 for an isotropic strain, and W = G/2 (eps_1 - eps_2)^2 for the shear eps_1 = -eps_2
 * along x and y, the moduli are
 *
 *   bulk         K = 1/(4V) sum l^2 k_n
 *   shear        G = 1/(4V) sum l^2 (k_n cos^2 2 theta + k_s sin^2 2 theta)
 *
 * Of all motions with the same displacements of the boundary, the motion to equilibrium has the least energy, so these
 * moduli are upper bounds. Contact forces that all grow in the same proportion stay in equilibrium. Of all forces in
 * equilibrium with the same stress, the true ones have the least energy of the springs. So, with the mean stress p, Pa,
 *
 *   bulk.lower   K = p^2 V / sum (N^2/k_n + T^2/k_s)
 *
 * is a lower bound. All bounds hold for contacts that neither open nor close nor slide.
 *
 *   k_n, k_s   current tangent stiffnesses of the contact, without dashpots, N/m; k_s is 0 without friction
 *   N, T       normal and shear force, dashpots included, N
 *   theta      direction of the contact normal n, rad; t is the unit vector at right angles to n
 *   V          area of the region times thickness, m3; a contact of two particles inside counts once, another contact
 *              with the fraction of l that is inside the region
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "region.h"

void nb_measure_moduli(const struct nb_model *model, struct nb_region_state *region) {
  const struct nb_contacts *contacts = &model->contacts;
  const double volume = region->area * region->thickness;
  double bulk = 0, shear = 0, stress = 0, compliance = 0;
  struct nb_end end;
  for (struct nb_ends ends = nb_ends_begin(model, region); nb_ends_next(&ends, &end);) {
    const double kn = contacts->kept[NB_STIFFNESS][end.contact];
    const double ks = contacts->kept[NB_SHEAR_STIFFNESS][end.contact]; /* 0 without friction */
    const double l = end.arm + (end.partner < 0 ? 0 : nb_contact_arm(model, end.contact, (size_t)end.partner));
    const double cos2 = end.e.x * end.e.x - end.e.y * end.e.y, sin2 = 2 * end.e.x * end.e.y;
    bulk += end.arm * l * kn;
    stress += end.arm * end.total_normal / (2 * volume);
    compliance += end.arm / l *
                  (end.total_normal * end.total_normal / kn + (ks > 0 ? end.total_shear * end.total_shear / ks : 0));
    shear += end.arm * l * (kn * cos2 * cos2 + ks * sin2 * sin2);
  }
  region->moduli.bulk = volume > 0 ? bulk / (4 * volume) : 0;
  region->moduli.bulk_lower = compliance > 0 ? stress * stress * volume / compliance : 0;
  region->moduli.shear = volume > 0 ? shear / (4 * volume) : 0;
}
