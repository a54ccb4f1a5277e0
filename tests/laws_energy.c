/* Rules for energies that every registered law must satisfy. The other rules are in laws.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <float.h>

#include "every_law.h"
#include "suites.h"

struct corner {
  double overlap, slip; /* overlap at the corner, slip on the way to it, m */
};

/* Moves a contact without shear force three times around a closed path, from the state `at`. The total work must not be
 * negative after any round. The error of the finite steps is estimated as four times the change of the work when the
 * number of steps is doubled. */
static void go_around(const struct contact *at, const struct corner *corners, int count) {
  struct contact coarse = *at, fine = *at;
  double work = 0, finer = 0, scale = 0;
  for (int round = 0; round < 3; round++) {
    for (int k = 0; k < count; k++) {
      const double before = fine.overlap;
      work += contact_lead(&coarse, corners[k].overlap, corners[k].slip, 128);
      finer += contact_lead(&fine, corners[k].overlap, corners[k].slip, 256);
      scale += fine.n.force * (fabs(fine.overlap - before) + fabs(corners[k].slip)) + fabs(finer);
    }
    CU_ASSERT(finer >= -4 * fabs(finer - work) - 256 * DBL_EPSILON * scale);
  }
}

static void closed_paths_give_no_energy(struct contact it, struct chance *chance) {
  if (it.normal->non_conservative || (it.shear && it.shear->non_conservative))
    return;
  const double low = chance_scale(chance, 1e-8, 1e-4), high = low * chance_between(chance, 1.1, 5);
  const double reach = low * chance_between(chance, 0.05, 4) * (chance_between(chance, -1, 1) < 0 ? -1 : 1);
  contact_lead(&it, low, 0, 128);
  go_around(&it, (struct corner[]){{high, 0}, {low, 0}}, 2);
  go_around(&it, (struct corner[]){{low, reach}, {low, -reach}}, 2);
  go_around(&it, (struct corner[]){{low, reach}, {low, -2 * reach}, {low, reach}}, 3);
  go_around(&it, (struct corner[]){{low, reach}, {high, 0}, {high, -reach}, {low, 0}}, 4);
  go_around(&it, (struct corner[]){{high, 0}, {high, reach}, {low, 0}, {low, -reach}}, 4);
  go_around(&it, (struct corner[]){{high, reach}, {low, -reach}}, 2);
  go_around(&it, (struct corner[]){{0, reach}, {low, -reach}}, 2);
}

/* In every segment of a path the stored energy increases by at most the work, and by exactly the work while the contact
 * does not slide. For a law that returns its dissipation, the increase is always the work minus the dissipation.
 *
 * The error of the finite steps is estimated as sixteen times the change of all terms when the number of steps is
 * halved. The factor is large because the error has a smooth part and a part from the step in which sliding begins.
 * These parts may cancel in the change.
 *
 * A law that merges pieces of its history changes its stored energy slightly, and returns this change as dissipation.
 * On these paths the change is below 1e-3 of the stored energy. */
static void stored_energy_is_the_work(struct contact it, struct chance *chance) {
  if (!it.normal->stored || (it.shear && !it.shear->stored))
    return;
  contact_lead(&it, chance_scale(chance, 1e-8, 1e-4), 0, 64);
  int stuck = 0;
  for (int segment = 0; segment < 40; segment++) {
    const double to = it.overlap * chance_between(chance, 0.7, 1.4);
    const double slip = chance_between(chance, -1, 1) * it.overlap * (segment % 2 ? 0.02 : 0.3);
    struct contact coarse = it;
    const double before = stored(&it), already = it.dissipated, work = contact_lead(&coarse, to, slip, 64);
    bool slid = false;
    double finer = 0;
    const double from = it.overlap;
    for (int k = 1; k <= 128; k++) {
      finer += contact_lead(&it, from + (to - from) * k / 128, slip / 128, 1);
      slid = slid || (it.s.sliding > 0 && !it.shear->dissipative);
    }
    const double dissipated = it.dissipated - already, less = coarse.dissipated - already;
    const double missing = finer - (stored(&it) - before);
    const double error = 16 * (fabs(finer - work) + fabs(stored(&it) - stored(&coarse)) + fabs(dissipated - less)) +
                         1024 * DBL_EPSILON * (before + stored(&it));
    const double joined = it.shear && it.shear->piece > 0 ? 1e-3 * (before + stored(&it)) : 0;
    CU_ASSERT(missing >= -error - joined && dissipated >= -error - joined);
    if (!slid)
      CU_ASSERT(fabs(missing - dissipated) <= error);
    stuck += !slid;
  }
  if (it.shear && it.pair.friction > 0.1)
    CU_ASSERT(stuck > 0);
}

OF_NORMAL(closed_paths_give_no_energy)
OF_NORMAL(stored_energy_is_the_work)
OF_SHEAR(closed_paths_give_no_energy)
OF_SHEAR(stored_energy_is_the_work)

void suite_laws_energy(void) {
  CU_pSuite suite = CU_add_suite("laws_energy", NULL, NULL);
  CU_add_test(suite, "normal: closed paths give no energy", normal_closed_paths_give_no_energy);
  CU_add_test(suite, "normal: stored energy is the work", normal_stored_energy_is_the_work);
  CU_add_test(suite, "shear: closed paths give no energy", shear_closed_paths_give_no_energy);
  CU_add_test(suite, "shear: stored energy is the work", shear_stored_energy_is_the_work);
}
