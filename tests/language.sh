#!/bin/sh
# Tests docs/LANGUAGE.md and the manual page: they are up to date and complete, every word has an example, and all
# examples run. TAP. $NINEBALL is the program, $srcdir the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
language=$work/LANGUAGE.md

"$nineball" --help language-md >"$language" && diff -u docs/LANGUAGE.md "$language" >"$work/said"
result $? "docs/LANGUAGE.md is up to date; make language renews it"

# The section of a word begins with `### WORD`. One line of its blocks must begin with the word, or contain it if the
# word follows a measure.
awk '
  function close_part() { if (word != "" && !shown) print word " has no example" }
  /^## / { close_part(); word = ""; expect = $2 == "Expectations" }
  /^### / { close_part(); word = $2; shown = 0; words++ }
  /^```/ { inside = $0 != "```"; next }
  inside && ($1 == word || (expect && index(" " $0 " ", " " word " "))) { shown = 1 }
  END { close_part(); if (words < 20) print "there are " words " words only" }' "$language" >"$work/said"
test ! -s "$work/said"
result $? 'every word has an example'

"$nineball" explain "$language" >/dev/null 2>"$work/said"
result $? 'all examples together are a valid page'

# Every quantity, or the family that it belongs to, `fabric` for `fabric.normal.xx`, is in the glossary.
sed -n '/^## Quantities/,/^## Numbers/s/^- `\([^`]*\)`.*/\1/p' "$language" | sort -u | awk '
  FNR == NR { line = $0; while (match(line, /`[^`]*`/)) { known[substr(line, RSTART + 1, RLENGTH - 2)]; line = substr(line, RSTART + RLENGTH) }; next }
  { family = $0; while (!(family in known) && sub(/\.[^.]*$/, "", family)) {} }
  !(family in known) { print $0 " is not in docs/GLOSSARY.md" }
  END { if (FNR < 100) print "there are " FNR " quantities only" }' docs/GLOSSARY.md - >"$work/said"
test ! -s "$work/said"
result $? 'every quantity, or its family, is in the glossary'

# Expectations with a reference are left out, because the reference belongs to another scene.
awk '/^### / { word = $2 } /^```/ { inside = $0 != "```" }
  !(inside && !/^```/ && word ~ /^(reference|within|versus|order)$/)' "$language" >"$work/runs.md"
"$nineball" check "$work/runs.md" >"$work/said" 2>&1
result $? 'all examples together run and pass their checks'

{
  printf '```scene\nmaterial steel density 7800 kg/m3 kn 1 MN/m\nlattice discs 4 by 4 radius 10 mm steel\nstep 0.1 of stable\n'
  awk '/^```/ { inside = $0 == "```text of a scene with a cell"; next } inside && !/^ /' "$language"
  printf 'record cell.stress.xx\nstage go\ncycles 10\n'
  awk '/^```/ { inside = $0 == "```text of a scene with a cell"; next } inside && /^ /' "$language"
  printf '```\n'
} >"$work/cell.md"
grep -q '^ *cell *strain' "$work/cell.md" && "$nineball" run "$work/cell.md" -o "$work/cell" >"$work/said" 2>&1
result $? 'the examples of scenes with a cell run'

sed -n 's/^### //p' "$language" | sort -u | while read -r word; do
  "$nineball" --help "$word" 2>&1 | grep -q "$word" || echo "nineball --help $word does not describe it"
done >"$work/said"
test ! -s "$work/said"
result $? 'nineball --help WORD describes each word'
# Every word of a line of syntax: the statement and its arguments, `record every N cycles | none`.
sed -n '/^### /{n;n;p;}' "$language" | tr -cs 'a-z0-9_-' '\n' | grep -E '^[a-z][a-z0-9_-]+$' | sort -u >"$work/words"
while read -r word; do
  "$nineball" --help "$word" >/dev/null 2>&1 || echo "nineball --help $word does not describe it"
done <"$work/words" >"$work/said"
test "$(wc -l <"$work/words")" -gt 100 && test ! -s "$work/said"
result $? 'nineball --help WORD describes each word within a statement'
for pair in energy:energy.sliding unbalanced:unbalanced.max kinetic:energy.kinetic "quantities:dashpot: .normal, .shear" "quantities dashpot:dashpot.normal" "quantities stress:stress.mean" units:kg/m3 expressions:hypot \
  sqrt:expressions MPa:pressure hertz:elastic "normal hertz:elastic" "shear rate:2 EXY" amplitude:largest at:TIME deg:angle; do
  "$nineball" --help "${pair%%:*}" 2>&1 | grep -qF -e "${pair#*:}" || echo "nineball --help ${pair%%:*} does not mention ${pair#*:}"
done >"$work/said"
test ! -s "$work/said"
result $? 'nineball --help describes families of quantities, topics, units, functions, laws and reducers'

# The explanation that a newcomer looks for is within the first three lines of the help.
for pair in "velocity:velocity VX VY" stiffness:young "refine:divides the step" "compress:box strain" "compression:cell strain" \
  "vertical:y points up" "horizontal:x points to the right" "order:order NUMBER in NAME" "advise:cheapest step" "within:MEASURE within" \
  "rate:cell strain" "seed:fill discs" "porosity:box.porosity" "strain:Which strain" "stage:Begins a stage" "budget:time for the search" \
  "psi:1 psi is 6.894757293 kPa" "inch:1 inch is 25.4 mm" "lb:1 lb is 4.448221615 N" "restitution:damping ratio" "fix:fixed" \
  "mindlin:mindlin_deresiewicz has it" "micro-slip:mindlin_deresiewicz" "reset:region S all from STAGE" \
  "slope:at 2 ms" "simple_shear:c12 0.1 1/s" "simple-shear:c12 0.1 1/s" "shear rate:c12 0.1 1/s" "pure shear:2 EXY" \
  "axial:box.strain.height" "axial strain:box.strain.height" "settle:damping mass" "run-out:snapshot"; do
  "$nineball" --help "${pair%%:*}" 2>&1 | head -n 3 | grep -qF -e "${pair#*:}" || echo "nineball --help ${pair%%:*} does not begin with ${pair#*:}"
done >"$work/said"
for command in $("$nineball" --help | sed -n 's/^  \([a-z][a-z]*\) .*/\1/p'); do
  "$nineball" --help "$command" 2>&1 | head -n 3 | grep -q "^  $command " || echo "nineball --help $command does not begin with the command"
done >>"$work/said"
test ! -s "$work/said" && test -n "$command"
result $? 'nineball --help begins with what a newcomer looks for, and with each command'
test "$("$nineball" --help strain | grep -cE '^ *(cell|box|boundary|affine) strain: moves ')" -eq 4
result $? 'nineball --help strain compares the four statements'
for words in 'blue disc' 'disc blue'; do # the help on one of two words is enough
  "$nineball" --help "$words" >"$work/said" 2>&1 && grep -q '^  disc X Y radius R' "$work/said"
  result $? "nineball --help '$words': only one of the words is known"
done
"$nineball" --help strain | tr -s ' \n' '  ' >"$work/said"
grep -qF 'With `region S all from STAGE`, `S.strain.xx`' "$work/said"
result $? 'nineball --help strain says how a strain counts from a stage'
"$nineball" --help gnuplot | tr -s ' \n' '  ' >"$work/said"
grep -qF "rows of all stages" "$work/said" && grep -qF "strcol('stage') eq 'load'" "$work/said"
result $? 'nineball --help gnuplot says how to plot one stage'
{ "$nineball" --help kn; "$nineball" --help cell.strain.xy; "$nineball" --help gnuplot; } | tr -s ' \n' '  ' >"$work/said"
grep -qF 'Between two materials: 2ab/(a+b).' "$work/said" && grep -qF 'xy is 0 as long as the cell is strained along x and y only' "$work/said" &&
  grep -qF "title 'reference'" "$work/said"
result $? 'nineball --help: the stiffness of two materials, the shear strain of a cell, a figure with a key'
"$nineball" --help material | tr -s ' \n' '  ' | grep -qF 'full `kn` and `ks`, not half of them' &&
  "$nineball" --help until | tr -s ' \n' '  ' | grep -qF 'far above 50 kPa, and only a servo holds it'
result $? 'nineball --help: the stiffness of equal materials, and a stress after a wait for rest'
{ "$nineball" --help monitor; "$nineball" --help packing; } | tr -s ' \n' '  ' >"$work/said"
grep -qF "in the order of the statements that add them" "$work/said" && grep -qF "There are two kinds of files." "$work/said"
result $? 'nineball --help: the numbers of particles, and the two kinds of files with a packing'

# Words of other programs: `nineball --help` of such a word must show all words of the page language that are in the same row.
grep '^    {"' src/input/guess.c | tr '{' '\n' | sed -n 's/^"\([^"]*\)", "\([^"]*\)".*$/\1|\2/p' >"$work/synonyms"
test "$(cut -d '|' -f 1 "$work/synonyms" | wc -w)" -eq 1830 && cut -d '|' -f 1 "$work/synonyms" | tr ' ' '\n' | sort | uniq -d >"$work/said" &&
  test ! -s "$work/said"
result $? 'the table has 1830 words of other programs, and none is in two rows'
# Nobody would find a typing error in one of these words. The sum says only that the table has not changed: after a change
# compare the row with the manual of the other program, and renew the sum.
sum=$(LC_ALL=C sort "$work/synonyms" | cksum)
echo "$sum" >"$work/said" && test "$sum" = '4214982378 30904'
result $? 'no row of words of other programs has changed since its review'
# Likewise the words of the patterns for whole lines of other programs.
sum=$(sed -n 's/^  {\(NB_\|BOTH\)[^"]*"\([^"]*\)", .*/\2/p' src/input/foreign.c | LC_ALL=C sort | cksum)
echo "$sum" >"$work/said" && test "$sum" = '3184521672 7346'
result $? 'no pattern for lines of other programs has changed since its review'
# The meaning of words in rows without an explanation, once more, because the test below reads it from the table.
cat >"$work/wanted" <<'END'
ball|disc, sphere
create|fill, lattice, disc, sphere
psd|grading
property|material, pair, let
define|let
coulomb|friction, linear
young_modulus|young
poisson_ratio|poisson
normal_stiffness|kn
plot|gnuplot
equilibrium|until, unbalanced.max
ratio|unbalanced.max, damping, poisson
critical|ratio, single-contact
no_contact|contacts
coordination_number|coordination
voidratio|void_ratio
contact|damping, monitor, region
calm|zero velocities
apply|gravity, boundary stress, servo, wall
confine|servo, boundary stress, stress.mean
compress|box strain, cell strain, boundary strain, walls, servo
shear_strain|strain.xy, strain.deviator
vertical_stress|stress.yy
move|wall, walls, transform
delete|remove
read_data|start, packing
assert|expected, within
tangential|shear, ks, slip
falls|decreases
less|below
greater|above
force|normal, shear, fx, fy
position|x, y
displacement|slip, x, y
void|void_ratio
hertz_mindlin|normal hertz, shear mindlin
hooke|normal linear, shear linear
degree|deg
false|off
true|on
quantity_p|stress.mean
quantity_q|stress.deviator
quantity_stress.q|stress.deviator
quantity_stress.p|stress.mean
quantity_floaters|rattlers
quantity_force_chains|chains
suffix_1|major
suffix_2|minor
suffix_11|xx
suffix_12|xy
suffix_21|yx
suffix_22|yy
quantity_e|void_ratio
quantity_n|porosity
quantity_z|coordination
quantity_sxx|stress.xx
quantity_syy|stress.yy
quantity_sxy|stress.xy
quantity_exx|strain.xx
quantity_eyy|strain.yy
quantity_ev|strain.volumetric
quantity_fn|normal, normal.mean
quantity_fs|shear, shear.mean
quantity_un|overlap
quantity_w|spin
quantity_theta|angle
quantity_v|vx, vy
quantity_xvel|vx
quantity_yvel|vy
quantity_xfob|fx
quantity_yfob|fy
quantity_torque|moment
quantity_Zm|coordination.mechanical
END
while IFS='|' read -r word ours; do
  awk -F '|' -v word="$word" -v ours="$ours" '(" " $1 " ") ~ (" " word " ") && $2 == ours { found = 1 } END { exit !found }' "$work/synonyms" ||
    echo "$word is not $ours"
done <"$work/wanted" >"$work/said"
test ! -s "$work/said"
result $? 'words of other programs have the meaning that they have there'
while IFS='|' read -r words ours; do
  for word in $words; do
    "$nineball" --help "$word" >"$work/help" 2>&1 || echo "nineball --help $word finds nothing"
    echo "$ours" | tr -s ',' '\n' | sed 's/^ //' | while read -r our; do
      case $our in nineball*) continue ;; esac
      grep -qE -e "[ {|]$our([] ,:}|]|\$)" "$work/help" || echo "nineball --help $word does not show $our"
    done
  done
done <"$work/synonyms" >"$work/said"
test ! -s "$work/said"
result $? 'words of other programs lead to words of pages'
# The whole explanation of words of other programs which no page in tests/bad has: WORD|EXPLANATION.
while IFS='|' read -r word text; do
  "$nineball" --help "$word" 2>&1 | head -n 1 | grep -qxF -e "  $text" || echo "nineball --help $word does not begin with: $text"
done >"$work/said" <<'END'
clump|there are no clumps, particles are single discs or spheres: `disc 0 m 0 m radius 5 mm MATERIAL`
generate|a random packing is two lines, `grading mixed 4 mm 67  5 mm 66  6 mm 67` (radius and number of each size) and `fill discs box 0 m 0 m to 0.2 m 0.2 m mixed MATERIAL seed 1 attempts 1000 else stop` (in a periodic cell `cell` in place of `box … to …`); there is no target porosity: compress with `walls inward 1 mm/s` and `until box.porosity below 0.16 at most 1000000 cycles`
pbc|periodic boundaries are `periodic cell 0 m 0 m to 1 m 1 m`, in place of walls; a cell is always periodic in x and in y
discs|several particles are `lattice discs 20 by 1 radius 5 mm MATERIAL`, or `fill discs`; a line `disc` is one particle
restitution|restitution is a result, not an input; for example, for a restitution of 0.7 write `damping ratio (-log(0.7)/hypot(pi, log(0.7)))` with `normal linear`, `damping ratio (-sqrt(5/6)*log(0.7)/hypot(pi, log(0.7)))` with `normal hertz`
print|a value is `report energy.kinetic max in STAGE`, in a block `expect`; a column of the table is `record time energy.kinetic`, in the scene
axial|y points up, so the axial strain of a box is `box.strain.height`, since time 0, extension positive. A stage with `box strain 0 1/s -0.01 1/s` reaches a strain of -5 % at `until stage.time above (log(0.95)/(-0.01 1/s)) at most 1000000 cycles`
settle|particles settle under `gravity 0 m/s2 -9.81 m/s2` with `damping mass 50 1/s` or `damping ratio 0.2`. The stage ends by `until unbalanced.max below 1e-4 and energy.kinetic below 1 nJ and contacts above 0 at most 1000000 cycles`
run_out|there is no quantity for a run-out distance: a stage with the line `snapshot` saves all particles at its end in STAGE-particles.tsv, and the distance follows from the largest `x/m` there. The place of one particle is `monitor A disc 1`, then `record A.x`
vel|a velocity is given by `velocity VX VY` and recorded as `A.vx` and `A.vy`
3d|the simulation is in the plane, x to the right and y up; spheres move in the plane, too
micro_slip|`shear mindlin_deresiewicz` is the exact law with micro-slip; `shear mindlin` has none, so at constant normal force its loops open only when the contact slides
SI|`units none`: all numbers are in SI, without units; `units si`: each number has its unit, `5 mm`
number|a grading has the number of particles of each radius: `grading sand 2 mm 100  1 mm 400`
disc_at|a statement `disc` takes no number and no word `at`; particles are numbered in the order of their lines. Begin with x and y of the centre: `disc 0 m 0 m radius 5 mm MATERIAL velocity 1 m/s 0 m/s`
lattice_x|the number in a row and the number of rows have `by` between them: `lattice discs 10 by 10 radius 5 mm MATERIAL`
servo_NUMBER|write `servo isotropic 50 kPa on box through box at most 1e-6 per cycle`; `xx P` and `yy P` control components, and `mean P` controls (xx + yy)/2
step_auto|write `step 0.3 of stable`, with elastic spheres `step 0.2 of rayleigh`
cycles_s|a stage of 2 s ends with `until stage.time above 2 s at most 1000000 cycles`
until_<|a condition is `QUANTITY below VALUE`
box_rate|two rates follow `box strain`, those in x and y: `box strain 0 1/s -0.1 1/s` compresses in y
boundary_shear|simple shear at the rate G = 0.1 1/s is `boundary strain 0 1/s 0 1/s  c12 0.1 1/s`; the clause `shear EXY` is pure shear, c12 = c21 = EXY
model_calm|in a stage write `zero velocities`
solve_ratio|in a stage write `until M.unbalanced.mean below 1e-4 and contacts above 0 at most 1000000 cycles`, with `region M all` in the scene: PFC's average ratio. `unbalanced.max`, the largest unbalanced force over the largest contact force, is stricter
ball_create|a particle is `disc 0 m 0 m radius 5 mm MATERIAL`, or `sphere` in place of `disc`
packing_in|a random packing is two lines, `grading mixed 4 mm 8  5 mm 8  6 mm 8` (radius and number of each size) and `fill discs circle 0 mm 0 mm radius 40 mm mixed MATERIAL seed 1 attempts 1000 else stop`; there is no target porosity
disc_omega|the angular velocity of a particle is `spin 1 rad/s`
scene_velocity|an initial velocity is a part of a particle: `disc 0 m 0 m radius 5 mm MATERIAL velocity 1 m/s 0 m/s`
expect_trend|a trend with a sweep is `A.vx max  increases with k`, or `decreases with k`
expect_approx|write `C.normal max  expected 3 N within 1 % [SOURCE]`
expect_rms|there is no such word; `nineball --help expect` lists the words that may follow a quantity
expect_conserved|to check that a quantity is constant in time, write `momentum.x amplitude in all  expected 0 kg.m/s within 1e-9 kg.m/s [SOURCE]`
of_contact_mobilised_friction|the mobilized friction of a contact is its shear force over its limit, friction times normal force: `record C.shear C.normal`; `C.sliding` is 1 at the limit
of_particle_kinetic_energy|the energy of one particle is no quantity: it follows from `record A.vx A.vy A.spin`; `energy.kinetic` is that of all free particles
quantity_box.pressure|the mean stress of a box is `box.stress.mean`
until_contact|to end a stage at the end of a contact, write `until C.overlap below 1e-12 m at most 1000000 cycles` in a stage that begins during the contact, with `monitor C disc 1 with disc 2` in the scene; to end a stage at the first cycle of the contact, write `until C.overlap above 0 m at most 1000000 cycles`
spheres|several particles are `lattice spheres 20 by 1 radius 5 mm MATERIAL`, or `fill spheres`; a line `sphere` is one particle
brick|particles are discs or spheres: `disc 0 m 0 m radius 5 mm MATERIAL`; a regular packing is `lattice discs hexagonal 20 by 20 radius 5 mm MATERIAL`
loop|there are no loops: several particles are `lattice discs 20 by 1 radius 5 mm MATERIAL`, a run for each value is `sweep mu 0.1 0.3`, and repeated stages are `repeat from STAGE 3 more times`
save|nothing has to be saved: a second page begins with `start THIS-PAGE stage NAME` and continues with all velocities and contact histories
fixed_spin|`rotation off`, a line of its own below a line `stage NAME`, prevents the rotation of all particles; `spin W` is an angular velocity at the start, which a `fixed` particle keeps: `disc 0 m 0 m radius 5 mm MATERIAL spin 0 rad/s`
sphere_at|a statement `sphere` takes no number and no word `at`; particles are numbered in the order of their lines. Begin with x and y of the centre: `sphere 0 m 0 m radius 5 mm MATERIAL velocity 1 m/s 0 m/s`
lattice_triangular|the rows of a lattice are `square`, or `hexagonal`, which is triangular: `lattice discs hexagonal 10 by 10 radius 5 mm MATERIAL`
wall_at|a wall is a line in the plane between two ends, without `at` and `normal`: `wall floor -1 m 0 m to 1 m 0 m MATERIAL`
lattice_fixed|only a line `disc` or `sphere` has `fixed`: `disc 0 m 0 m radius 5 mm MATERIAL fixed`; a straight row of fixed particles is a `wall`, and all particles along the edge are held by a `boundary circle` and `boundary fixed` in a stage
contact_test_sphere|the two particles are one line, `contact sphere 5 mm MATERIAL with sphere 5 mm MATERIAL`
contact_spheres|write `contact sphere 5 mm MATERIAL with sphere 5 mm MATERIAL`
scene_report|an expectation or a report belongs in a block `expect`, after the block `scene`: for example `report energy.kinetic max in STAGE`
model_new|a page needs no such line; the domain is `box 0 m 0 m to 1 m 1 m MATERIAL`, or `periodic cell 0 m 0 m to 1 m 1 m`
model_save|nothing has to be saved: a second page begins with `start THIS-PAGE stage NAME`
fix_NUMBER|motion is integrated without a statement; a wall is `wall floor -1 m 0 m to 1 m 0 m MATERIAL`, gravity is `gravity 0 m/s2 -9.81 m/s2`
expect_always|to check all rows of a stage write `A.vx min in STAGE  above -1 m/s` and `A.vx max in STAGE  below 3 m/s`; a value at one time is `A.vx at 0.1 s  expected 3 m/s within 1 % [SOURCE]`
expect_first|the first row of the run is `at 0 cycles`. The first row of a later stage, or after `start`, is `at N cycles`: `record cycle` and `report cycle min in STAGE` show N; `nineball --help expect` lists all such words
expect_range|the largest value minus the smallest one is twice the amplitude, `C.normal amplitude in STAGE  below 1 N`; for a range of values write two lines, one with `above` and one with `below`
expect_print|write `report energy.kinetic max in STAGE`
whole_time_of_max|there is no time of a maximum: let the event end a stage, `until C.normal above 1 N at most 1000000 cycles`, and with `record time` check `time last in STAGE  above 0 s`
quantity_rebound_height|the height of a rebound is the largest `A.y` after it, with `monitor A disc 1` and `record A.y`: one stage ends with the contact, `until C.overlap below 1e-12 m at most 1000000 cycles`, the next one at the top, `until A.vy below 0 m/s at most 1000000 cycles`, and `report A.y max in STAGE` has its height
drop|a drop begins with a particle above a wall: `wall floor -1 m 0 m to 1 m 0 m MATERIAL`, `disc 0 m 0.5 m radius 5 mm MATERIAL` and `gravity 0 m/s2 -9.81 m/s2`. Its height is the y of the centre less the radius
box_open|a box has four walls; open at the top it is three lines: `wall floor 0 m 0 m to 1 m 0 m MATERIAL`, `wall left 0 m 1 m to 0 m 0 m MATERIAL` and `wall right 1 m 0 m to 1 m 1 m MATERIAL`
END
test ! -s "$work/said"
result $? 'nineball --help explains words of other programs'
"$nineball" --help dics >/dev/null 2>"$work/said"
test $? -eq 2 && grep -q 'did you mean `disc`?' "$work/said"
result $? 'nineball --help suggests a word for a mistyped one'

# The manual page has the syntax of every statement, every option and every command in bold.
sh docs/man.sh "$nineball" >"$work/man" && {
  sed -n '/^### /{n;n;p;}' "$language" | tr -d '`'
  "$nineball" --help | sed -n 's/^ *\(.*[^ ]\)   *[^ ].*$/\1/p'
} | sed 's/\\/\\e/g; s/-/\\-/g; s/…/.../g' | while read -r term; do
  grep -qxF "\\fB$term\\fR" "$work/man" || echo "the manual page has no $term"
done >"$work/said" && test ! -s "$work/said"
result $? 'the manual page has every statement, option and command'
if command -v groff >/dev/null; then
  groff -man -Tutf8 -ww -z "$work/man" >"$work/said" 2>&1
  test ! -s "$work/said"
  result $? 'groff accepts the manual page'
else
  n=$((n + 1))
  echo "ok $n - groff accepts the manual page # SKIP groff is missing"
fi
echo "1..$n"
