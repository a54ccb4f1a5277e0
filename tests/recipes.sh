#!/bin/sh
# Tests the numbers that plot recipes compute before they draw, for contacts with known forces and directions. TAP.
# $NINEBALL is the program, $srcdir the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"

# The costs of laws in the recipe are those of docs/COST.md.
srcdir=. sh tests/bench/cost.sh --laws docs/COST.md >"$why" 2>&1 && cmp "$why" plots/law-costs.gp >>"$why" 2>&1 && grep -q "mindlin 1.00  mindlin_scaled 1[.]" plots/law-costs.gp
result $? 'plots/law-costs.gp is made from docs/COST.md'

if ! command -v gnuplot >/dev/null; then
  echo "1..$n" # the recipes need gnuplot
  exit 0
fi

# Two rows of three discs with fixed ends: the contact forces are 2 and 2 in one row, 2 and 1 in the other. A rotated disc on a
# wall has the force 1.
mkdir -p "$work/cases" && cd "$work/cases" || exit 1
cat >known.md <<'EOF'
# Known contacts

```scene
units    none
material m  density 1  kn 100  ks 80  friction 0.5
normal   linear
shear    linear
disc     0 0     radius 1  m  fixed
disc     1.98 0  radius 1  m
disc     3.96 0  radius 1  m  fixed
disc     0 9     radius 1  m  fixed
disc     1.98 9  radius 1  m
disc     3.97 9  radius 1  m  fixed
disc     9 0.99  radius 1  m  spin -1e-3
wall     floor  8 0 to 10 0  m
region   A  all
step     1e-9
record   A.fabric.xx A.fabric.xy A.fabric.yx A.fabric.yy
stage    look
  cycles 1
  snapshot from look
```

```gnuplot
particles = '$look_particles'; contacts = '$look_contacts'
weight = 'all'
load plots.'polar-normals.gp'
print sprintf('normals %g %g, the largest %g, of walls %g', bins[1], bins[19], most, bins[10] + bins[28])
weight = 'normal'
load plots.'polar-normals.gp'
print sprintf('weighted %.6f %.6f, the largest %.6f', bins[1], bins[19], most)
weight = 'near'
load plots.'polar-normals.gp'
print sprintf('near sliding %g', most)
tables = contacts; names = 'look'; of(c) = column('normal/-') / 2; low = -0.25; high = 1.75; bins = 4; curve(v) = NaN
load plots.'histogram.gp'
print sprintf('histogram %d %d %d %d', count[1], count[2], count[3], count[4])
longest = 0.5; chosen(x, y) = 1
load plots.'force-polygons.gp'
set datafile nocolumnheaders
stats $polygons using (sqrt($3**2 + $4**2)) name 'gap' nooutput
set datafile columnheaders
print sprintf('polygons %d corners, the widest gap %.6f, at y = %.6f', gap_records, gap_max, at_y[5])
rows = '$table'; tensor = 'A.fabric'; unit = '-'
load plots.'mohr.gp'
print sprintf('circle %.6f %.6f', middle, radius)
load plots.'force-chains.gp'
stats @contacts using (strong(1, 2) ? 1 : NaN) name 'chain' nooutput
print sprintf('chains: mean %.6f, %d of them strong', force_mean, chain_records)
turns = 'direction'
load plots.'rotations.gp'
stats @particles using (column('particle/-') == 7 ? shade(0) : 0) name 'shade' nooutput
print sprintf('turned %.0g from %g to %g', turned_max, shade_min, shade_max)
```
EOF
# The two rows have 4 contacts in x. The length 0.5 represents the force 2, so the gap of the polygon with 2 and 1 is
# 0.25.
cat >wanted <<'EOF'
normals 4 4, the largest 4, of walls 0
weighted 7.000000 7.000000, the largest 7.000000
near sliding 0
histogram 0 2 3 0
polygons 6 corners, the widest gap 0.250000, at y = 9.000000
circle 0.500000 0.388889
chains: mean 1.600000, 3 of them strong
turned 1e-12 from -1 to 0
EOF
"$nineball" figure known.md -o out --trust 2>said >"$why" # gnuplot prints to standard error
status=$?
cat said >>"$why"
result $status "the recipes draw"
diff wanted said >"$why" 2>&1
result $? "their numbers are right"

# A network without contacts: the discs are apart. The warning names the line of the block `gnuplot` that has the contacts,
# and only their stage; a network with contacts has none, as the test above shows.
cat >apart.md <<'EOF'
# Discs apart

```scene
units    none
material m  density 1  kn 100
disc     0 0  radius 1  m
disc     4 0  radius 1  m
step     1e-9
record   time
stage    looking
  cycles 1
  snapshot
stage    look
  cycles 1
  snapshot
stage    behind
  cycles 1
```

```gnuplot
particles = '$look_particles'
contacts = '$look_contacts'
load plots.'force-chains.gp'
```
EOF
"$nineball" figure apart.md -o apart --trust >"$why" 2>&1 &&
  test "$(grep 'draws no contact network' "$why")" = 'apart.md:22: warning: the figure draws no contact network: at the end of stage `look` nothing touches'
result $? "a contact network without contacts: a warning"
sed 's/^stage    look$/stage    look-at/; s/look_/look_at_/' apart.md >dash.md # a name of gnuplot has `_` for `-`
"$nineball" figure dash.md -o apart --trust >"$why" 2>&1 &&
  test "$(grep 'draws no contact network' "$why")" = 'dash.md:22: warning: the figure draws no contact network: at the end of stage `look-at` nothing touches'
result $? "a contact network without contacts in a stage whose name has a dash"
sed "s/^disc     4 0/sweep x 4 5 6\n&/; s/^disc     4/disc     \$x/; s/_particles'/_particles_1'/; s/_contacts'/_contacts_1'/" apart.md >apart-sweep.md
"$nineball" figure apart-sweep.md -o apart --trust >"$why" 2>&1 &&
  test "$(grep -cF 'apart-sweep.md:23: warning: the figure draws no contact network: at the end of stage `look` nothing touches' "$why")" = 1
result $? "a contact network without contacts in three runs: one warning"
echo "1..$n"
