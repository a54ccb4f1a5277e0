# The lists of Makefile.am: every source file, reference, page, suite and test of the tree.
#
# A new law, reference, page or suite of unit tests needs its file and one line in one of the first lists.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

# Each file is one contact law. The register, `nineball laws`, the word in pages and the tests of all laws are made from this list.
LAWS = \
  src/laws/normal_hertz.c \
  src/laws/normal_hertz_increment.c \
  src/laws/normal_linear.c \
  src/laws/shear_linear.c \
  src/laws/shear_mindlin.c \
  src/laws/shear_mindlin_scaled.c \
  src/laws/shear_mindlin_deresiewicz.c \
  src/laws/shear_none.c \
  src/laws/shear_randall.c \
  src/laws/shear_randall_literal.c

# Each file is one statement of the page language, or a family of statements. The register, help and manual are made from this list,
# in its order.
STATEMENTS = \
  src/input/let.c \
  src/input/start.c \
  src/input/material.c \
  src/input/law.c \
  src/input/damping.c \
  src/input/gravity.c \
  src/input/particle.c \
  src/input/fill.c \
  src/input/packing.c \
  src/input/wall.c \
  src/input/cell.c \
  src/input/monitor.c \
  src/input/region.c \
  src/input/impact.c \
  src/input/transform.c \
  src/input/step.c \
  src/input/record.c \
  src/input/stage.c \
  src/input/remove.c \
  src/input/servo.c \
  src/input/boundary.c \
  src/input/contact_test.c

# Each file is one reference solution.
REFERENCES = \
  cases/refs/momentum.c \
  cases/refs/contact_ladder.c \
  cases/refs/one_contact.c \
  cases/refs/time_reversal.c \
  cases/refs/oblique_impact.c \
  cases/refs/rigid_impact.c \
  cases/refs/mindlin_loops.c \
  cases/refs/path_no_slip.c \
  cases/refs/pinched.c \
  cases/refs/path_springs.c \
  cases/refs/path_randall.c \
  cases/refs/rebound.c \
  cases/refs/cohesion.c \
  cases/refs/free_fall.c \
  cases/refs/hertz_curve.c \
  cases/refs/hertz_damped.c \
  cases/refs/hertz_impact.c \
  cases/refs/hertz_increment.c \
  cases/refs/hertz_phase.c \
  cases/refs/incline.c \
  cases/refs/many_bounces.c \
  cases/refs/slide_to_roll.c \
  cases/refs/rotation_off.c \
  cases/refs/servo_lattice.c \
  cases/refs/stacked.c \
  cases/refs/speed_of_loading.c \
  cases/refs/nine_discs.c \
  cases/refs/nine_discs_distortion.c \
  cases/refs/nine_discs_slip.c \
  cases/refs/nine_discs_statics.c \
  cases/refs/hertz_deep.c \
  cases/refs/fracc.c \
  cases/refs/fracc_touch.c \
  cases/refs/rayleigh_cycle.c \
  cases/refs/rayleigh_step.c \
  cases/refs/lattice_moduli.c \
  cases/refs/lattice_waves.c \
  cases/refs/step_limit.c \
  cases/refs/filling.c \
  cases/refs/packing.c \
  cases/refs/zigzag.c \
  cases/refs/taken_out.c \
  cases/refs/changed_law.c \
  cases/refs/carried.c \
  cases/refs/centripetal.c \
  cases/refs/chain.c \
  cases/refs/force_chain.c \
  cases/refs/lattice_stress.c \
  cases/refs/literal_field.c \
  cases/refs/ring_strain.c \
  cases/refs/stress_ring.c \
  cases/refs/boxed_lattice.c \
  cases/refs/measures.c \
  cases/refs/turning_wall.c \
  cases/refs/two_wall_compression.c \
  cases/refs/two_wall_statics.c \
  cases/refs/hertz_row.c \
  cases/refs/wall_end.c \
  cases/refs/wedge.c

# Each file is one case: handout, input, check, figure and exercise. `make check` runs every case as a test.
PAGES = \
  cases/1-two-discs/two-wall-compression.md \
  cases/1-two-discs/two-wall-statics.md \
  cases/1-two-discs/free-fall.md \
  cases/1-two-discs/many-bounces.md \
  cases/1-two-discs/slide-to-roll.md \
  cases/1-two-discs/rotation-off.md \
  cases/1-two-discs/incline.md \
  cases/1-two-discs/cohesion.md \
  cases/1-two-discs/damping-walls.md \
  cases/1-two-discs/taken-out.md \
  cases/1-two-discs/turning-wall.md \
  cases/1-two-discs/wedge.md \
  cases/1-two-discs/wall-end.md \
  cases/2-hertz/hertz-curve.md \
  cases/2-hertz/hertz-curve-bench.md \
  cases/2-hertz/hertz-impact.md \
  cases/2-hertz/hertz-impact-wall.md \
  cases/2-hertz/hertz-range.md \
  cases/2-hertz/hertz-contrast.md \
  cases/2-hertz/stiff-in-soft.md \
  cases/2-hertz/hertz-phase.md \
  cases/2-hertz/hertz-increment.md \
  cases/2-hertz/hertz-damped.md \
  cases/2-hertz/overlap-deep.md \
  cases/3-nine-discs/nine-discs.md \
  cases/3-nine-discs/nine-discs-statics.md \
  cases/3-nine-discs/nine-discs-damping.md \
  cases/3-nine-discs/nine-discs-speed.md \
  cases/3-nine-discs/nine-discs-soft.md \
  cases/3-nine-discs/nine-discs-step.md \
  cases/3-nine-discs/nine-discs-slip.md \
  cases/3-nine-discs/nine-discs-path.md \
  cases/3-nine-discs/nine-discs-distortion.md \
  cases/3-nine-discs/nine-discs-friction-15.md \
  cases/3-nine-discs/nine-discs-friction-30.md \
  cases/3-nine-discs/speed-of-loading.md \
  cases/3-nine-discs/stiff-and-soft.md \
  cases/4-oblique/mindlin-loops.md \
  cases/4-oblique/mindlin-loops-walls.md \
  cases/4-oblique/nested-loops.md \
  cases/4-oblique/normal-and-shear.md \
  cases/4-oblique/two-normal-forces.md \
  cases/4-oblique/contact-ladder.md \
  cases/4-oblique/closed-squares.md \
  cases/4-oblique/closed-squares-r89.md \
  cases/4-oblique/traction.md \
  cases/4-oblique/traction-rolling.md \
  cases/4-oblique/traction-increments.md \
  cases/4-oblique/oblique-impact.md \
  cases/4-oblique/oblique-impact-phase.md \
  cases/4-oblique/oblique-impact-forces.md \
  cases/4-oblique/oblique-impact-small-angle.md \
  cases/4-oblique/oblique-impact-small-angle-r89.md \
  cases/4-oblique/oblique-impact-laws.md \
  cases/4-oblique/oblique-impact-work.md \
  cases/4-oblique/oblique-impact-rigid.md \
  cases/4-oblique/oblique-impact-regimes.md \
  cases/4-oblique/restitution-angle.md \
  cases/4-oblique/spin-wall.md \
  cases/4-oblique/spin-gears.md \
  cases/4-oblique/spin-pair.md \
  cases/4-oblique/grazing.md \
  cases/4-oblique/friction-extremes.md \
  cases/4-oblique/frictionless.md \
  cases/5-numerics/order.md \
  cases/5-numerics/half-step.md \
  cases/5-numerics/centred-dashpots.md \
  cases/5-numerics/glancing-discs.md \
  cases/5-numerics/step-limit.md \
  cases/5-numerics/critical-step-shear.md \
  cases/5-numerics/step-growth.md \
  cases/5-numerics/nine-discs-growth.md \
  cases/5-numerics/rayleigh-step.md \
  cases/5-numerics/rayleigh-mean.md \
  cases/5-numerics/fracc.md \
  cases/5-numerics/fracc-touch.md \
  cases/5-numerics/momentum.md \
  cases/5-numerics/energy-balance.md \
  cases/5-numerics/time-reversal.md \
  cases/5-numerics/invariance.md \
  cases/5-numerics/invariance-far.md \
  cases/5-numerics/invariance-scale.md \
  cases/5-numerics/saved-stage.md \
  cases/5-numerics/packing.md \
  cases/5-numerics/changed-law.md \
  cases/6-lattices/chain.md \
  cases/6-lattices/chain-wave.md \
  cases/6-lattices/force-chain.md \
  cases/6-lattices/force-chain-turn.md \
  cases/6-lattices/lattice-moduli.md \
  cases/6-lattices/lattice-hertz.md \
  cases/6-lattices/lattice-waves.md \
  cases/6-lattices/lattice-stress.md \
  cases/6-lattices/rotated-copies.md \
  cases/6-lattices/turned-assembly.md \
  cases/6-lattices/ring-strain.md \
  cases/6-lattices/ring-strain-literal.md \
  cases/6-lattices/literal-continuum.md \
  cases/6-lattices/periodic-shear.md \
  cases/6-lattices/stress-ring.md \
  cases/6-lattices/box-servo.md \
  cases/6-lattices/servo-lattice.md \
  cases/7-assemblies/as-generated.md \
  cases/7-assemblies/fill-tries.md \
  cases/7-assemblies/isotropic-compression.md \
  cases/7-assemblies/constant-volume-shear.md \
  cases/7-assemblies/compression-and-shear.md \
  cases/7-assemblies/thesis-preparation.md \
  cases/7-assemblies/cyclic-shear.md \
  cases/7-assemblies/periodic-compression.md \
  cases/7-assemblies/biaxial.md \
  cases/7-assemblies/photoelastic-discs.md \
  cases/7-assemblies/photoelastic-positions.md \
  cases/7-assemblies/scaled-springs.md \
  cases/7-assemblies/plots-of-an-assembly.md \
  cases/7-assemblies/numbers-and-boxes.md \
  cases/8-published/chung-ooi-1.md \
  cases/8-published/chung-ooi-2.md \
  cases/8-published/chung-ooi-3.md \
  cases/8-published/chung-ooi-4.md \
  cases/8-published/chung-ooi-5.md \
  cases/8-published/chung-ooi-6.md \
  cases/8-published/chung-ooi-7.md \
  cases/8-published/chung-ooi-8.md \
  cases/8-published/mfix-dem-01.md \
  cases/8-published/mfix-dem-02.md \
  cases/8-published/mfix-dem-03.md \
  cases/8-published/mfix-dem-04.md \
  cases/8-published/mfix-dem-05.md

# Pages that take longer: `make check-long`.
PAGES_LONG = \
  cases/7-assemblies/photoelastic-tables.md \
  cases/7-assemblies/thesis-isotropic-compression.md \
  cases/7-assemblies/isotropic-compression-seeds.md \
  cases/7-assemblies/preparation-price.md \
  cases/7-assemblies/thesis-constant-volume-shear.md \
  cases/7-assemblies/shear-fields.md \
  cases/7-assemblies/constant-mean-stress-shear.md \
  cases/7-assemblies/volume-or-pressure.md \
  cases/7-assemblies/softness-price.md \
  cases/7-assemblies/load-unload-reload.md \
  cases/7-assemblies/linear-or-hertz.md \
  cases/7-assemblies/no-slip-or-exact.md \
  cases/7-assemblies/friction-series.md \
  cases/7-assemblies/friction-volume.md \
  cases/7-assemblies/barnes-discs.md \
  cases/7-assemblies/barnes-fields.md \
  cases/7-assemblies/continuum-shear.md \
  cases/7-assemblies/continuum-shear-far.md \
  cases/7-assemblies/continuum-shear-readings.md \
  cases/7-assemblies/continuum-shear-damped.md \
  cases/7-assemblies/continuum-shear-literal.md \
  cases/7-assemblies/centripetal-rest.md \
  cases/7-assemblies/centripetal-compaction.md \
  cases/7-assemblies/pinched-sphere.md \
  cases/7-assemblies/ejected-particle.md

# The introductions of the cases and of each chapter.
CASE_LISTS = \
  cases/README.md \
  cases/1-two-discs/README.md \
  cases/2-hertz/README.md \
  cases/3-nine-discs/README.md \
  cases/4-oblique/README.md \
  cases/5-numerics/README.md \
  cases/6-lattices/README.md \
  cases/7-assemblies/README.md \
  cases/8-published/README.md

# Documents that the report shows after the cases.
DOCUMENTS = \
  README.md \
  docs/TUTORIAL.md \
  docs/METHOD.md \
  docs/CONTACT.md \
  docs/GLOSSARY.md \
  docs/PAPERS.md \
  docs/papers/CS79.md \
  docs/papers/R89.md \
  docs/ACCURACY.md \
  docs/TRADES.md \
  docs/STABILITY.md \
  docs/EXTREMES.md \
  docs/PATHS.md \
  docs/ROUNDING.md \
  docs/COST.md \
  docs/PERFORMANCE.md \
  docs/FUZZING.md \
  docs/STATE.md \
  HACKING.md

# Files with particles for pages.
PACKINGS = \
  cases/packings/nine-discs-load.state \
  cases/packings/nine-discs-load.tsv \
  cases/packings/nine-discs-load.txt \
  cases/packings/photo-5.tsv \
  cases/packings/photo-7.tsv \
  cases/packings/photo-20.tsv \
  cases/packings/photo-32.tsv \
  cases/packings/photo-38.tsv

# Each file is one suite of unit tests: tests/X.c defines suite_X.
SUITES = \
  tests/reader.c \
  tests/units.c \
  tests/scene.c \
  tests/refine.c \
  tests/copied.c \
  tests/limits.c \
  tests/rounding.c \
  tests/statements.c \
  tests/stated.c \
  tests/refs.c tests/refs_covers.c tests/refs_features.c tests/refs_accepts.c \
  tests/refs_nine.c \
  tests/refs_networks.c \
  tests/refs_rotation.c \
  tests/refs_extremes.c \
  tests/refs_refuses.c \
  tests/refs_row.c \
  tests/refs_values.c \
  tests/refs_hertz_rows.c \
  tests/refs_hertz_motion.c \
  tests/refs_lattices.c \
  tests/refs_paths.c \
  tests/refs_motion.c \
  tests/refs_ladder.c \
  tests/refs_impact.c \
  tests/refs_loops.c \
  tests/refs_contact.c \
  tests/refs_damped.c \
  tests/law_change.c \
  tests/laws.c \
  tests/laws_energy.c \
  tests/exact.c \
  tests/expression.c \
  tests/corners.c \
  tests/laws_batch.c \
  tests/randall.c \
  tests/randall_exact.c \
  tests/ringing.c \
  tests/randall_text.c \
  tests/kinematics.c \
  tests/signs.c \
  tests/motion.c \
  tests/spin.c \
  tests/reach.c \
  tests/through.c \
  tests/damping.c \
  tests/deep.c \
  tests/elastic.c \
  tests/energy.c tests/accounts.c \
  tests/cell.c \
  tests/near.c \
  tests/guard.c \
  tests/apart.c \
  tests/walls.c \
  tests/stable.c \
  tests/fracc.c \
  tests/stability.c \
  tests/steps.c \
  tests/rayleigh.c \
  tests/impact.c \
  tests/refs_chain.c \
  tests/refs_hertz.c \
  tests/refs_stacked.c \
  tests/refs_variants.c \
  tests/changes.c \
  tests/affine.c \
  tests/box.c \
  tests/place.c \
  tests/begins.c \
  tests/waves.c \
  tests/drive.c tests/drive_crowd.c \
  tests/driven.c \
  tests/servo.c \
  tests/removal.c tests/removal_balance.c \
  tests/properties.c \
  tests/memory.c \
  tests/team.c \
  tests/team_late.c \
  tests/fill.c \
  tests/run.c tests/result.c tests/model.c tests/checkpoint_files.c \
  tests/hooks.c \
  tests/state.c \
  tests/state_driven.c \
  tests/state_file.c tests/state_records.c \
  tests/output_file.c tests/restart.c tests/state_fits.c \
  tests/contact_test.c \
  tests/many.c \
  tests/tensor.c \
  tests/areas.c \
  tests/region.c \
  tests/recount.c \
  tests/recount_contacts.c \
  tests/edges.c \
  tests/region_sums.c \
  tests/snapshot.c \
  tests/chains.c \
  tests/configuration.c \
  tests/speeds.c \
  tests/advise.c tests/advice.c \
  tests/estimate.c \
  tests/counts.c \
  tests/words.c \
  tests/reducers.c \
  tests/verdict.c \
  tests/verdict_sweep.c \
  tests/verdict_sample.c \
  tests/verdict_skip.c \
  tests/outcome.c tests/outcome_jobs.c \
  tests/scaled.c \
  tests/halved.c \
  tests/checkpoint.c

# Tests that are scripts and print TAP.
SHELL_TESTS = \
  tests/aborted.sh \
  tests/mistakes.sh \
  tests/program.sh \
  tests/explain.sh \
  tests/commands.sh \
  tests/confine.sh \
  tests/report.sh \
  tests/advice.sh \
  tests/advise.sh \
  tests/cost.sh \
  tests/rounding.sh \
  tests/trades.sh \
  tests/same-bits.sh \
  tests/start.sh \
  tests/checkpoint.sh \
  tests/packing.sh \
  tests/docs.sh \
  tests/sketches.sh \
  tests/papers.sh \
  tests/recipes.sh \
  tests/equations.sh \
  tests/hints.sh \
  tests/language.sh \
  tests/migrate.sh \
  tests/layers.sh \
  tests/hacking.sh \
  tests/memory.sh

# Plot recipes, and the style of figures.
PLOTS = \
  plots/discs.gp plots/force-chains.gp plots/force-polygons.gp plots/force-rectangles.gp plots/histogram.gp plots/law-costs.gp \
  plots/mohr.gp plots/numbers.gp plots/obliquity.gp plots/polar-normals.gp plots/porosity-rings.gp plots/rotations.gp plots/slid.gp \
  plots/report.css plots/report.js plots/report.lua plots/space-lattice.gp plots/stress-path.gp plots/style.gp \
  plots/velocities.gp

# Files that references share.
REFERENCES_SHARED = \
  cases/refs/coverage.c cases/refs/coverage.h cases/refs/hertz.c cases/refs/hertz.h cases/refs/hertz_corner.c \
  cases/refs/hertz_corner.h cases/refs/hertz_motion.c cases/refs/hertz_motion.h cases/refs/impact_damped.c \
  cases/refs/impact_laws.c cases/refs/impact_springs.c cases/refs/impact_springs.h cases/refs/solution.c \
  cases/refs/lattice.c cases/refs/lattice.h cases/refs/lattice_path.c cases/refs/lattice_path.h \
  cases/refs/lattice_equilibrium.c cases/refs/lattice_row.c cases/refs/lattice_row.h cases/refs/lattice_oscillation.c \
  cases/refs/lattice_values.c cases/refs/lattice_values.h cases/refs/lattice_walls.c cases/refs/limit.c \
  cases/refs/limit.h cases/refs/matter.c cases/refs/matter.h cases/refs/path.c cases/refs/path.h \
  cases/refs/reference.h cases/refs/single.c cases/refs/single.h cases/refs/student.c cases/refs/student.h \
  cases/refs/waves.h

# ---- the modules of src in order: no file includes one of a later list ----------------------------------------------

# Particles, walls, contacts, neighbour list, calculation cycle.
CORE = \
  src/core/array.c \
  src/core/array.h \
  src/core/block.h \
  src/core/blocks.c \
  src/core/boundary.h \
  src/core/affine.h \
  src/core/cell.c \
  src/core/cell.h \
  src/core/clean.c \
  src/core/clean.h \
  src/core/clock.h \
  src/core/contacts.c \
  src/core/contacts.h \
  src/core/cycle.c \
  src/core/damping.c \
  src/core/deep.c \
  src/core/energy_terms.h \
  src/core/error.c \
  src/core/error.h \
  src/core/families.c \
  src/core/grid.c \
  src/core/grid.h \
  src/core/guard.c \
  src/core/guess.h \
  src/core/hertz_impact.h \
  src/core/wall_vertices.c \
  src/core/machine.c \
  src/core/materials.c \
  src/core/mesh.c \
  src/core/mesh.h \
  src/core/history.c \
  src/core/incidence.c \
  src/core/model.h \
  src/core/motion.c \
  src/core/motion.h \
  src/core/names.h \
  src/core/neighbours.c \
  src/core/store.c \
  src/core/store.h \
  src/core/table.c \
  src/core/team.c \
  src/core/team.h \
  src/core/tensor.h \
  src/core/vec.h \
  src/core/velocity.c \
  src/core/walls.c \
  src/core/walls.h \
  src/core/warning.c \
  src/nineball.h

# Files that laws share.
LAWS_SHARED = \
  src/laws/corners.h \
  src/laws/law.h \
  src/laws/law_batch.h \
  src/laws/law_stages.h \
  src/laws/laws_now.c \
  src/laws/laws_now.h \
  src/laws/properties.c \
  src/laws/randall.h \
  src/laws/register.c

# The kernels of the force calculation.
PASS = \
  src/pass/affine_twice.c \
  src/pass/dashpots.c \
  src/pass/deep.c \
  src/pass/disc_disc.c \
  src/pass/disc_disc.h \
  src/pass/disc_disc_wide.h \
  src/pass/disc_wall.c \
  src/pass/geometry.h \
  src/pass/wall_vertices.c \
  src/pass/pass.h \
  src/pass/periodic.c \
  src/pass/resolve.c

# Pages with several seeds; docs/papers/R89.md states their results.
THESIS = \
  docs/thesis/barnes.md \
  docs/thesis/damped.md \
  docs/thesis/fields.md \
  docs/thesis/laws.md \
  docs/thesis/literal-damped.md \
  docs/thesis/literal-twice.md \
  docs/thesis/obliquity-and-sliding.md \
  docs/thesis/preparation.md \
  docs/thesis/regions.md

# Measures of an assembly: stress, fabric, energy, stable step. They change nothing.
MEASURE = \
  src/measure/areas.c \
  src/measure/areas.h \
  src/measure/balance.c \
  src/measure/balance.h \
  src/measure/balance_steps.c \
  src/measure/boundary.c \
  src/measure/boundary.h \
  src/measure/chains.c \
  src/measure/collision.c \
  src/measure/coordination.c \
  src/measure/directions.c \
  src/measure/energy.c \
  src/measure/energy.h \
  src/measure/fabric.c \
  src/measure/fracc.c \
  src/measure/impact.c \
  src/measure/impact.h \
  src/measure/loads.c \
  src/measure/moduli.c \
  src/measure/rayleigh_step.c \
  src/measure/region.c \
  src/measure/region.h \
  src/measure/region_quantities.c \
  src/measure/configuration.c \
  src/measure/configuration.h \
  src/measure/snapshot.c \
  src/measure/snapshot.h \
  src/measure/stable_step.c \
  src/measure/step.c \
  src/measure/step.h \
  src/measure/strain.c \
  src/measure/stress.c \
  src/measure/stability.c \
  src/measure/wall_quantities.c

# Loading of an assembly: boundary, cell, box, servo, removal of particles.
LOADING = \
  src/loading/box.c \
  src/loading/boundary.c \
  src/loading/affine.c \
  src/loading/loading.h \
  src/loading/loading_quantities.c \
  src/loading/remove.c \
  src/loading/servo.c

# Lattices and random filling.
PACKING = \
  src/packing/fill.c \
  src/packing/fill_quantities.c \
  src/packing/lattice.c \
  src/packing/packing.h \
  src/packing/random_numbers.c \
  src/packing/random_numbers.h

# Reads a page line by line into struct nb_scene.
INPUT = \
  src/input/contact_test_quantities.h \
  src/input/columns.c \
  src/input/columns.h \
  src/input/expression.c \
  src/input/expression.h \
  src/input/file.c \
  src/input/fill_hint.c \
  src/input/foreign.c \
  src/input/guess.c \
  src/input/hash.h \
  src/input/line.c \
  src/input/mistakes.c \
  src/input/migrate.c \
  src/input/name_parts.c \
  src/input/names.c \
  src/input/old_words.c \
  src/input/old_words.h \
  src/input/page.c \
  src/input/page_names.c \
  src/input/reader.h \
  src/input/refine.c \
  src/input/scene.c \
  src/input/scene.h \
  src/input/state_file.c \
  src/input/state_file.h \
  src/input/statement.c \
  src/input/statement.h \
  src/input/text.c \
  src/input/text.h \
  src/input/units.c \
  src/input/units.h \
  src/input/value.c

# Plan, stages, states, tables, contact test.
RUN = \
  src/run/checkpoint.c \
  src/run/checkpoint.h \
  src/run/contact_test.c \
  src/run/contact_test.h \
  src/run/contact_test_quantities.c \
  src/run/hooks.c \
  src/run/model.c \
  src/run/result.c \
  src/run/result.h \
  src/run/output_file.c \
  src/run/output_file.h \
  src/run/plan.c \
  src/run/plan.h \
  src/run/restart.c \
  src/run/restart.h \
  src/run/run.c \
  src/run/stage.c \
  src/run/state.c \
  src/run/state.h

# Expectations and verdict.
VERDICT = \
  src/report/advise.c \
  src/report/advise.h \
  src/report/bits.c \
  src/report/bits.h \
  src/report/estimate.c \
  src/report/estimate.h \
  src/report/expect.c \
  src/report/expect.h \
  src/report/outcome.c \
  src/report/outcome.h \
  src/report/reducers.c \
  src/report/spool.c \
  src/report/trials.c \
  src/report/verdict.c \
  src/report/verdict.h \
  src/report/verdict_rows.c \
  src/report/verdict_sweep.c

# The command line.
PROGRAM = \
  src/report/accuracy_rows.h \
  src/report/advice.c \
  src/report/advise_all.c \
  src/report/commands.c \
  src/report/commands.h \
  src/report/convert.c \
  src/report/cost.c \
  src/report/cost.h \
  src/report/explain.c \
  src/report/figure.c \
  src/report/gnuplot.c \
  src/report/html.c \
  src/report/links.c \
  src/report/main.c \
  src/report/manual.c \
  src/report/print.c \
  src/report/report.c \
  src/report/report.h \
  src/report/rounding.c \
  src/report/row_table.c \
  src/report/row_table.h \
  src/report/sandbox.c \
  src/report/sandbox.h \
  src/report/tables.c \
  src/report/tool.c \
  src/report/tool.h

