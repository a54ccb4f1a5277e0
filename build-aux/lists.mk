# The lists of Makefile.am: every source file, reference, page, suite and test of the tree.
#
# A new law, reference, page or suite of unit tests is its file and one word in one of the first lists.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

# One law each; the register, `nineball laws`, the word in pages and the contract tests come from this list.
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

# One judge each: what theory says of a scene.
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
  cases/refs/two_wall_statics.c

# One case each: handout, input, check, figure and exercise. `make check` runs every one as a test.
PAGES = \
  cases/two-wall-compression.md \
  cases/two-wall-statics.md \
  cases/free-fall.md \
  cases/many-bounces.md \
  cases/slide-to-roll.md \
  cases/rotation-off.md \
  cases/hertz-curve.md \
  cases/hertz-curve-bench.md \
  cases/hertz-impact.md \
  cases/hertz-impact-wall.md \
  cases/hertz-phase.md \
  cases/hertz-increment.md \
  cases/hertz-damped.md \
  cases/chung-ooi-1.md \
  cases/chung-ooi-2.md \
  cases/chung-ooi-3.md \
  cases/mfix-dem-01.md \
  cases/mfix-dem-02.md \
  cases/mfix-dem-03.md \
  cases/mfix-dem-04.md \
  cases/incline.md \
  cases/cohesion.md \
  cases/nine-discs.md \
  cases/nine-discs-damping.md \
  cases/nine-discs-speed.md \
  cases/nine-discs-soft.md \
  cases/nine-discs-step.md \
  cases/nine-discs-statics.md \
  cases/nine-discs-slip.md \
  cases/energy-balance.md \
  cases/as-generated.md \
  cases/fill-tries.md \
  cases/force-chain-turn.md \
  cases/plots-of-an-assembly.md \
  cases/taken-out.md \
  cases/changed-law.md \
  cases/saved-stage.md \
  cases/packing.md \
  cases/order.md \
  cases/half-step.md \
  cases/damping-walls.md \
  cases/glancing-discs.md \
  cases/momentum.md \
  cases/time-reversal.md \
  cases/invariance.md \
  cases/invariance-far.md \
  cases/invariance-scale.md \
  cases/turning-wall.md \
  cases/nine-discs-distortion.md \
  cases/nine-discs-friction-15.md \
  cases/nine-discs-friction-30.md \
  cases/lattice-moduli.md \
  cases/scaled-springs.md \
  cases/lattice-hertz.md \
  cases/periodic-compression.md \
  cases/servo-lattice.md \
  cases/compression-and-shear.md \
  cases/cyclic-shear.md \
  cases/periodic-shear.md \
  cases/literal-continuum.md \
  cases/chain.md \
  cases/force-chain.md \
  cases/lattice-stress.md \
  cases/lattice-waves.md \
  cases/ring-strain.md \
  cases/ring-strain-literal.md \
  cases/stress-ring.md \
  cases/box-servo.md \
  cases/biaxial.md \
  cases/rotated-copies.md \
  cases/turned-assembly.md \
  cases/chain-wave.md \
  cases/step-limit.md \
  cases/rayleigh-step.md \
  cases/rayleigh-mean.md \
  cases/overlap-deep.md \
  cases/fracc.md \
  cases/fracc-touch.md \
  cases/step-growth.md \
  cases/nine-discs-path.md \
  cases/speed-of-loading.md \
  cases/stiff-and-soft.md \
  cases/mindlin-loops.md \
  cases/nested-loops.md \
  cases/normal-and-shear.md \
  cases/contact-ladder.md \
  cases/closed-squares.md \
  cases/closed-squares-r89.md \
  cases/traction.md \
  cases/oblique-impact.md \
  cases/oblique-impact-phase.md \
  cases/oblique-impact-forces.md \
  cases/oblique-impact-small-angle.md \
  cases/oblique-impact-laws.md \
  cases/oblique-impact-work.md \
  cases/oblique-impact-rigid.md \
  cases/restitution-angle.md \
  cases/spin-wall.md \
  cases/spin-gears.md \
  cases/spin-pair.md \
  cases/grazing.md \
  cases/chung-ooi-4.md \
  cases/chung-ooi-5.md \
  cases/chung-ooi-6.md \
  cases/chung-ooi-7.md \
  cases/chung-ooi-8.md \
  cases/mfix-dem-05.md \
  cases/oblique-impact-regimes.md

# Pages that take longer than `make check` has time for: `make check-long`.
PAGES_LONG = \
  cases/isotropic-compression.md \
  cases/isotropic-compression-seeds.md \
  cases/constant-volume-shear.md \
  cases/shear-fields.md \
  cases/constant-mean-stress-shear.md \
  cases/volume-or-pressure.md \
  cases/linear-or-hertz.md \
  cases/no-slip-or-exact.md \
  cases/load-unload-reload.md \
  cases/pinched-sphere.md \
  cases/barnes-discs.md \
  cases/barnes-fields.md \
  cases/friction-series.md \
  cases/friction-volume.md \
  cases/continuum-shear.md \
  cases/continuum-shear-readings.md \
  cases/continuum-shear-damped.md \
  cases/continuum-shear-literal.md \
  cases/centripetal-rest.md \
  cases/centripetal-compaction.md \
  cases/ejected-particle.md

# One suite of unit tests each: tests/X.c defines suite_X.
SUITES = \
  tests/reader.c \
  tests/units.c \
  tests/scene.c \
  tests/statements.c \
  tests/refs.c tests/refs_covers.c tests/refs_features.c \
  tests/refs_nine.c \
  tests/refs_row.c \
  tests/refs_impact.c \
  tests/refs_damped.c \
  tests/law_change.c \
  tests/laws.c \
  tests/laws_energy.c \
  tests/exact.c \
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
  tests/energy.c \
  tests/cell.c \
  tests/near.c \
  tests/guard.c \
  tests/apart.c \
  tests/walls.c \
  tests/stable.c \
  tests/fracc.c \
  tests/watch.c \
  tests/steps.c \
  tests/rayleigh.c \
  tests/impact.c \
  tests/refs_chain.c \
  tests/refs_hertz.c \
  tests/refs_stacked.c \
  tests/changes.c \
  tests/carry.c \
  tests/box.c \
  tests/place.c \
  tests/begins.c \
  tests/waves.c \
  tests/drive.c \
  tests/driven.c \
  tests/servo.c \
  tests/removal.c \
  tests/properties.c \
  tests/memory.c \
  tests/fill.c \
  tests/run.c \
  tests/state.c \
  tests/state_driven.c \
  tests/state_file.c tests/state_records.c \
  tests/bench.c \
  tests/many.c \
  tests/tensor.c \
  tests/areas.c \
  tests/region.c \
  tests/recount.c \
  tests/recount_contacts.c \
  tests/edges.c \
  tests/region_sums.c \
  tests/summary.c \
  tests/chains.c \
  tests/since.c \
  tests/speeds.c \
  tests/reducers.c \
  tests/verdict.c \
  tests/verdict_sweep.c \
  tests/verdict_sample.c \
  tests/verdict_skip.c \
  tests/outcome.c

# Tests that are scripts and say TAP.
SHELL_TESTS = \
  tests/mistakes.sh \
  tests/program.sh \
  tests/confine.sh \
  tests/report.sh \
  tests/same-bits.sh \
  tests/start.sh \
  tests/packing.sh \
  tests/docs.sh \
  tests/thesis.sh \
  tests/recipes.sh \
  tests/equations.sh \
  tests/language.sh \
  tests/hacking.sh

# Recipes of figures, and their style.
PLOTS = \
  plots/discs.gp plots/force-chains.gp plots/force-polygons.gp plots/force-rectangles.gp plots/histogram.gp \
  plots/mohr.gp plots/obliquity.gp plots/polar-normals.gp plots/porosity-rings.gp plots/rotations.gp plots/slid.gp \
  plots/space-lattice.gp plots/stress-path.gp plots/style.gp plots/velocities.gp

# What references share.
REFERENCES_SHARED = \
  cases/refs/coverage.c cases/refs/coverage.h cases/refs/hertz.c cases/refs/hertz.h cases/refs/hertz_corner.c \
  cases/refs/hertz_corner.h cases/refs/hertz_motion.c cases/refs/hertz_motion.h cases/refs/impact_damped.c \
  cases/refs/impact_laws.c cases/refs/impact_springs.c cases/refs/impact_springs.h cases/refs/known.c \
  cases/refs/lattice.c cases/refs/lattice.h cases/refs/lattice_path.c cases/refs/lattice_path.h \
  cases/refs/lattice_rest.c cases/refs/lattice_row.c cases/refs/lattice_row.h cases/refs/lattice_swing.c \
  cases/refs/lattice_tell.c cases/refs/lattice_tell.h cases/refs/lattice_walls.c cases/refs/limit.c \
  cases/refs/limit.h cases/refs/matter.c cases/refs/matter.h cases/refs/path.c cases/refs/path.h \
  cases/refs/reference.h cases/refs/single.c cases/refs/single.h cases/refs/student.c cases/refs/student.h \
  cases/refs/waves.h

# ---- the modules of src, from below: no file includes one of a later list ------------------------------------------

# Particles, walls, contacts, the list of near pairs, the calculation cycle.
CORE = \
  src/core/array.c \
  src/core/array.h \
  src/core/block.h \
  src/core/blocks.c \
  src/core/boundary.h \
  src/core/carry.h \
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
  src/core/error.c \
  src/core/guard.c \
  src/core/guess.h \
  src/core/hertz_impact.h \
  src/core/joints.c \
  src/core/joints.h \
  src/core/machine.c \
  src/core/materials.c \
  src/core/memory.c \
  src/core/model.h \
  src/core/motion.c \
  src/core/motion.h \
  src/core/names.h \
  src/core/near.c \
  src/core/near.h \
  src/core/near_pairs.c \
  src/core/table.c \
  src/core/tensor.h \
  src/core/vec.h \
  src/core/velocity.c \
  src/core/walls.c \
  src/core/walls.h \
  src/core/warning.c \
  src/nineball.h

# What all laws are made with.
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

# The passes of the force calculation.
PASS = \
  src/pass/dashpots.c \
  src/pass/deep.c \
  src/pass/disc_disc.c \
  src/pass/disc_disc.h \
  src/pass/disc_wall.c \
  src/pass/joints.c \
  src/pass/pass.h \
  src/pass/periodic.c \
  src/pass/resolve.c

# What is measured of an assembly: stress, fabric, energy, the stable step. Changes nothing.
MEASURE = \
  src/measure/areas.c \
  src/measure/areas.h \
  src/measure/balance.c \
  src/measure/balance.h \
  src/measure/balance_bodies.c \
  src/measure/balance_carry.c \
  src/measure/balance_entry.c \
  src/measure/balance_jumps.c \
  src/measure/balance_steps.c \
  src/measure/boundary.c \
  src/measure/boundary.h \
  src/measure/chains.c \
  src/measure/coordination.c \
  src/measure/energy.c \
  src/measure/energy.h \
  src/measure/fabric.c \
  src/measure/fracc.c \
  src/measure/loads.c \
  src/measure/meet.c \
  src/measure/parted.c \
  src/measure/porosity.c \
  src/measure/rayleigh.c \
  src/measure/region.c \
  src/measure/region.h \
  src/measure/since.c \
  src/measure/since.h \
  src/measure/snapshot.c \
  src/measure/snapshot.h \
  src/measure/speeds.c \
  src/measure/stable.c \
  src/measure/step.c \
  src/measure/step.h \
  src/measure/step_kinds.c \
  src/measure/strain.c \
  src/measure/stress.c \
  src/measure/summary.c \
  src/measure/watch.c

# What moves an assembly from outside: boundary, cell, box, servo; what is taken out.
LOADING = \
  src/loading/box.c \
  src/loading/box.h \
  src/loading/box_kinds.c \
  src/loading/carry.c \
  src/loading/carry.h \
  src/loading/cell_kinds.c \
  src/loading/drive.c \
  src/loading/drive.h \
  src/loading/drive_kinds.c \
  src/loading/remove.c \
  src/loading/ring.c \
  src/loading/servo.c \
  src/loading/servo.h

# Lattices and random filling.
PACKING = \
  src/packing/fill.c \
  src/packing/fill_kinds.c \
  src/packing/lattice.c \
  src/packing/packing.h \
  src/packing/random.c \
  src/packing/random.h

# A page, line by line, to struct nb_scene.
INPUT = \
  src/input/columns.c \
  src/input/columns.h \
  src/input/file.c \
  src/input/hash.h \
  src/input/keywords.c \
  src/input/mistakes.c \
  src/input/names.c \
  src/input/page.c \
  src/input/reader.h \
  src/input/scene.c \
  src/input/scene.h \
  src/input/scene_bodies.c \
  src/input/scene_box.c \
  src/input/scene_cell.c \
  src/input/scene_changes.c \
  src/input/scene_drive.c \
  src/input/scene_fields.h \
  src/input/scene_fill.c \
  src/input/scene_follow.c \
  src/input/scene_free.c \
  src/input/scene_impact.c \
  src/input/scene_laws.c \
  src/input/scene_packing.c \
  src/input/scene_path.c \
  src/input/scene_place.c \
  src/input/scene_region.c \
  src/input/scene_remove.c \
  src/input/scene_repeat.c \
  src/input/scene_servo.c \
  src/input/scene_stages.c \
  src/input/scene_start.c \
  src/input/scene_step.c \
  src/input/scene_table.c \
  src/input/scene_values.c \
  src/input/scene_whole.c \
  src/input/scene_world.c \
  src/input/text.c \
  src/input/text.h \
  src/input/units.c \
  src/input/units.h \
  src/input/values.c \
  src/input/verbs.c \
  src/input/words.c

# Plan, stages, states, tables, and one contact alone.
RUN = \
  src/run/bench.c \
  src/run/bench.h \
  src/run/bench_leg.c \
  src/run/bench_names.c \
  src/run/bench_run.c \
  src/run/bench_traction.c \
  src/run/hooks.c \
  src/run/impact.c \
  src/run/impact.h \
  src/run/model.c \
  src/run/observe.c \
  src/run/observe.h \
  src/run/plan.c \
  src/run/plan.h \
  src/run/run.c \
  src/run/save.c \
  src/run/save.h \
  src/run/stage.c \
  src/run/start.c \
  src/run/start.h \
  src/run/state.c \
  src/run/state.h \
  src/run/state_contacts.c \
  src/run/state_driven.c \
  src/run/state_read.c \
  src/run/state_reading.h \
  src/run/state_records.c \
  src/run/state_write.c

# What a page would make the program do.
EXPLAIN = \
  src/report/explain.c

# What a page expects, and what came of it.
VERDICT = \
  src/report/expect.c \
  src/report/expect.h \
  src/report/expect_table.c \
  src/report/expect_take.c \
  src/report/expect_take.h \
  src/report/outcome.c \
  src/report/outcome.h \
  src/report/reducers.c \
  src/report/verdict.c \
  src/report/verdict.h \
  src/report/verdict_sample.c \
  src/report/verdict_sweep.c

# The command line.
PROGRAM = \
  src/report/command_state.c \
  src/report/commands.c \
  src/report/commands.h \
  src/report/confine.c \
  src/report/confine.h \
  src/report/figure.c \
  src/report/gnuplot.c \
  src/report/main.c \
  src/report/manual.c \
  src/report/options.c \
  src/report/options.h \
  src/report/print.c \
  src/report/report.c \
  src/report/tables.c \
  src/report/tables.h

