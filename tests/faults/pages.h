/* Small pages for the test of failing calls. Together they have a sweep, a reference, a figure, a state, a snapshot, a
 * packing, a periodic cell, a contact test, a law with a history, and errors.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#define STATEMENTS                                                                                                     \
  "material rock density 2000 kg/m3 young 1 GPa poisson 0.2 friction 0.3\n"                                            \
  "normal hertz\nshear mindlin_deresiewicz memory 4\nlattice spheres 2 by 1 rock radius 10 mm spacing 19.99 mm from "  \
  "10 mm 9.995 mm\nwall floor -1 m 0 mm to 1 m 0 mm rock\ngravity 1 m/s2 -9.81 m/s2\nmonitor A sphere 1\nregion W "    \
  "all\n"                                                                                                              \
  "step 0.1 of rayleigh\n"

static const struct {
  const char *name, *text;
} files[] = {
    {"first.md",
     "# First\n\n```scene\n" STATEMENTS "record A.y energy.kinetic\nstage load\n  ramp gravity 0 m/s2 -1 m/s2\n  "
     "cycles 4\n  snapshot\n```\n"},
    {"second.md",
     "# Second\n\n```scene\nstart first stage load\nmonitor A sphere 1\nrecord cycle A.y work.balance\nstage on\n  "
     "wall floor velocity 0 m/s 1 mm/s\n  remove sphere 2\n  material rock friction 0.2\n  cycles "
     "4\n```\n\n```expect\ncycle "
     "max  expected 8 within 1 %  [by hand]\n```\n"},
    {"packed.md",
     "# Packed\n\n```scene\nlet d = 20 mm\nmaterial rock density 2000 kg/m3 kn 1 MN/m\npacking list.tsv spheres rock\n"
     "sphere 5 m 0 m radius $d rock\nboundary circle 0 m 0 m radius 1 m\nstep 1 us\nrecord time\nstage go\n  "
     "boundary strain -1 1/s -1 1/s\n  cycles 3\n  snapshot\n```\n"},
    {"list.tsv", "x/m\ty/m\tradius/m\n0\t0\t0.1\n0.3\t0\t0.1\n"},
    {"cell.md", "# Cell\n\n```scene\nmaterial rock density 2000 kg/m3 kn 1 MN/m ks 1 MN/m friction 0.3\nshear linear\n"
                "periodic cell 0 m 0 m to 6 m 6 m\nlattice discs 3 by 3 rock radius 1 m\nregion W all from control\n"
                "step 0.1 of stable\nrecord W.stress.xx cell.stress.mean W.contacts.lost W.contacts.new "
                "energy.balance W.strain.xx step.fracc\n"
                "stage press\n  cell strain -1e-3 per cycle 0 per cycle\n  cycles 3\nstage control\n"
                "  servo isotropic 1 kPa on cell through cell at most 1e-4 per cycle\n  remove disc 9\n  cycles 3\n"
                "  snapshot from press\n```\n"},
    {"path.md",
     "# Path\n\n```contact-test\nmaterial rock young 1 GPa poisson 0.2 friction 0.3\nnormal hertz\nshear "
     "mindlin_deresiewicz memory 4\ncontact sphere 10 mm rock with wall rock\nsegment press overlap to 1 um in 3 "
     "steps\nsegment rub slip by 1 um in 3 steps\n  snapshot\n```\n"},
    {"fall.md",
     "# Fall\n\n```scene\nsweep g 1 2\nmaterial m density 1 kg/m3 kn 1 N/m\nsphere 0 m 2 m radius 1 m m\nwall floor -1 "
     "m "
     "0 m to 1 m 0 m m\ngravity 0 m/s2 -$g m/s2\nmonitor D sphere 1\nstep 1 ms\nrecord time D.y\nstage fall\n  cycles "
     "10\n```\n\n```expect\nreference free_fall\nD.y versus time within 1 %\nD.y min decreases with "
     "g\n```\n\n```gnuplot\nplot $table_1\n```\n"},
    {"meet.md", "# Meet\n\n```scene\nmaterial rock density 2000 kg/m3 young 1 GPa poisson 0.2\nnormal hertz\n"
                "sphere 0 m 0 m radius 1 m rock velocity 1 m/s 0 m/s\nsphere 3 m 0 m radius 1 m rock\n"
                "step 40 per collision\nrecord time\nstage go\n  cycles 3\nstage on\n  step 80 per collision\n"
                "  cycles 3\n```\n"},
    {"wrong.md",
     "# Wrong\n\n```scene\nmaterial rock density 2000\ndsc 0 m 0 m radius 1 m rock\nstep 1 us\nstage go\n```\n"},
};
enum { FILES = sizeof files / sizeof *files };

static const char *const cases[][8] = {
    {"nineball", "figure", "fall.md", "--jobs", "1"},
    {"nineball", "run", "second.md"},
    {"nineball", "run", "packed.md"},
    {"nineball", "run", "cell.md"},
    {"nineball", "run", "path.md"},
    {"nineball", "explain", "first.md"},
    {"nineball", "explain", "path.md"},
    {"nineball", "run", "meet.md"},
    {"nineball", "explain", "meet.md"},
    {"nineball", "state", "first.md"},
    {"nineball", "check", "wrong.md", "--set", "a=1"},
};
enum { CASES = sizeof cases / sizeof *cases };
