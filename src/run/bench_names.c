/* What can be recorded and expected of the contact on the bench, one row each.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "bench.h"
#include "core/names.h"

#define ON_BENCH(function, expression)                                                                                 \
  static double function(const struct nb_bench *bench) { return expression; }
ON_BENCH(step, (double)bench->step)
ON_BENCH(approach, bench->now.approach)
ON_BENCH(overlap, bench->now.n.overlap)
ON_BENCH(slip, bench->now.slip)
ON_BENCH(normal, bench->now.n.force)
ON_BENCH(shear, bench->now.s.force)
ON_BENCH(limit, bench->pair.friction * bench->now.n.force + bench->pair.cohesion)
ON_BENCH(sliding, bench->now.s.sliding)
ON_BENCH(radius, bench->now.n.radius)
ON_BENCH(normal_stiffness, bench->now.n.stiffness)
ON_BENCH(shear_stiffness, bench->now.s.stiffness)
ON_BENCH(work, bench->work_normal + bench->work_shear)
ON_BENCH(work_normal, bench->work_normal)
ON_BENCH(work_shear, bench->work_shear)
ON_BENCH(stored_normal, bench->normal->stored(bench->pair, bench->now.n, bench->now.normal_memory))
ON_BENCH(stored_shear, bench->shear->stored(bench->pair, bench->now.n, bench->now.shear_memory))
ON_BENCH(stored, stored_normal(bench) + stored_shear(bench))
ON_BENCH(lost, bench->lost)
ON_BENCH(pieces, nb_bench_history(bench).count)
ON_BENCH(stick, nb_bench_stick_radius(bench))
ON_BENCH(traction, nb_bench_traction_force(bench))

static const struct {
  struct nb_quantity_kind row;
  double (*value)(const struct nb_bench *bench);
} kinds[] = {
    {{"step", NB_OF_BENCH, "1", 0, NULL, "steps made since the start"}, step},
    {{"approach", NB_OF_BENCH, "m", 0, NULL, "how far the outlines have come together; below 0: a gap"}, approach},
    {{"overlap", NB_OF_BENCH, "m", 0, NULL, "the same, 0 where there is a gap"}, overlap},
    {{"slip", NB_OF_BENCH, "m", 0, NULL, "tangential displacement since the start"}, slip},
    {{"normal", NB_OF_BENCH, "N", 0, NULL, "elastic normal force"}, normal},
    {{"shear", NB_OF_BENCH, "N", 0, NULL, "shear force, in the sense of the slip that makes it"}, shear},
    {{"limit", NB_OF_BENCH, "N", 0, NULL,
      "friction times the normal force, and cohesion: what the shear force cannot exceed"},
     limit},
    {{"sliding", NB_OF_BENCH, "1", 0, NULL, "1 while the shear force is at its limit, else 0"}, sliding},
    {{"radius", NB_OF_BENCH, "m", 0, NULL, "of the contact circle, a; 0 for laws that know none"}, radius},
    {{"radius.stick", NB_OF_BENCH, "m", NB_ASKS_PIECES, NULL,
      "within it nothing slipped in the step behind, c; for laws that keep pieces"},
     stick},
    {{"stiffness.normal", NB_OF_BENCH, "N/m", 0, NULL, "by which the normal force grows with overlap"},
     normal_stiffness},
    {{"stiffness.shear", NB_OF_BENCH, "N/m", 0, NULL, "by which the shear force grows with slip while it sticks"},
     shear_stiffness},
    {{"work", NB_OF_BENCH, "J", 0, NULL, "done on the contact since the start, both sides"}, work},
    {{"work.normal", NB_OF_BENCH, "J", 0, NULL, "mean normal force of each step's two ends times its closing"},
     work_normal},
    {{"work.shear", NB_OF_BENCH, "J", 0, NULL, "mean shear force of each step's two ends times its slip"}, work_shear},
    {{"stored", NB_OF_BENCH, "J", NB_ASKS_STORE, NULL, "elastic energy, a state function of the laws that know theirs"},
     stored},
    {{"stored.normal", NB_OF_BENCH, "J", NB_ASKS_STORE, NULL, "that of the normal law"}, stored_normal},
    {{"stored.shear", NB_OF_BENCH, "J", NB_ASKS_STORE, NULL, "that of the shear law"}, stored_shear},
    {{"lost", NB_OF_BENCH, "J", NB_ASKS_LOSS, NULL,
      "to micro-slip and sliding since the start, by a shear law that says it"},
     lost},
    {{"pieces", NB_OF_BENCH, "1", NB_ASKS_PIECES, NULL, "how many pieces of its history the shear law keeps"}, pieces},
    {{"traction.force", NB_OF_BENCH, "N", NB_ASKS_PIECES, NULL,
      "the traction summed over the contact, by quadrature: the shear force, or it is wrong"},
     traction},
};

enum { KINDS = sizeof kinds / sizeof *kinds };

const struct nb_quantity_kind *nb_bench_row(size_t k) { return k < KINDS ? &kinds[k].row : NULL; }

double nb_quantity_on_bench(struct nb_quantity quantity, const struct nb_bench *bench) {
  for (size_t k = 0; k < KINDS; k++)
    if (&kinds[k].row == quantity.kind)
      return kinds[k].value(bench);
  return NAN;
}
