#!/bin/sh
# Tests `nineball migrate`. The pages tests/pages/old-*.md of version 0.3 use every word of the table of old words.
# Migrated pages are valid, contain no old word, and do not change when they are migrated again. TAP. $NINEBALL is the
# program, $srcdir the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
tab=$(printf '\t')

# The rows of the table as three columns: KIND, old form, new form.
sed -n "s/^ *{NB_OLD_\([A-Z]*\), \"\([^\"]*\)\", \"\([^\"]*\)\"}.*/\1$tab\2$tab\3/p" src/input/old_words.c >"$work/rows"
test "$(wc -l <"$work/rows")" -gt 5
result $? 'the table is read'

mkdir "$work/a" "$work/a/b" "$work/a/bad" && cp tests/bad/*.tsv "$work/a/bad"
for page in tests/pages/old-*.md; do
  new=$work/a/b/${page##*/}
  "$nineball" migrate "$page" >"$new" 2>"$work/said" && "$nineball" explain "$new" >/dev/null 2>>"$work/said"
  result $? "$page, migrated, is valid"
  ! grep -n "'known [A-Z]" "$new" >"$work/said"
  result $? 'the columns of its figures are migrated'
  "$nineball" migrate "$new" 2>&1 | diff "$new" - >"$work/said"
  result $? 'a second migration changes nothing'
  ! "$nineball" explain "$page" >/dev/null 2>"$work/said" && grep -q 'rewrites pages of version 0.3' "$work/said"
  result $? 'old words are errors, and the hint names the new ones'
done

# blocks PAGE...: the blocks that the program reads, without comments.
blocks() { sed -n '/^```[a-z]/,/^```$/p' "$@" | sed 's/#.*//'; }
blocks tests/pages/old-*.md >"$work/old"
blocks "$work"/a/b/old-*.md >"$work/new"
while IFS=$tab read -r kind old now; do
  for word in $old; do
    case $word in [A-Z]* | …) continue ;; esac
    grep -qF -e "$word" "$work/old" "$work/new" || echo "no page tests/pages/old-*.md has \`$word\` of \`$old\`"
  done
  for word in $now; do
    case $word in [A-Z]* | …) continue ;; esac
    grep -qF -e "$word" "$work/new" || echo "no migrated page has \`$word\` of \`$now\`"
  done
done <"$work/rows" >"$work/said"
test ! -s "$work/said"
result $? 'the pages contain every old word, and after migration every new one'

while IFS=$tab read -r kind old now; do
  for word in $old; do
    case $word in [A-Z]* | …) continue ;; esac
    case " $now " in *" $word "*) continue ;; esac
    "$nineball" --help "${word#.}" 2>&1 | grep -qF "\`$old\` of version 0.3 is \`$now\` now" || {
      "$nineball" --help "${word#.}" >/dev/null 2>&1 || echo "nineball --help $word is unknown"
    }
  done
done <"$work/rows" >"$work/said"
test ! -s "$work/said"
result $? 'nineball --help OLDWORD names the new word'
cat >"$work/wanted" <<'END'
  `.voids` of version 0.3 is `.void_ratio` now
  `unbalance` of version 0.3 is `unbalanced.max` now
  `.unbalance` of version 0.3 is `.unbalanced.mean` now
  `… servo stress xx` of version 0.3 is `… servo xx` now
  `… servo stress yy` of version 0.3 is `… servo yy` now
  `… servo stress xy` of version 0.3 is `… servo xy` now
  `… same over` of version 0.3 is `… constant with` now
  `… order P over` of version 0.3 is `… order P in` now
END
for word in W.voids unbalance stress over discs; do "$nineball" --help $word; done 2>&1 | grep 'version 0.3' | diff "$work/wanted" - >"$work/said"
result $? 'with the name of an owner, in all its rows, and not for a word that is still in use'

# Every line that changes.
cat >"$work/wanted" <<EOF
lattice   discs 4 by 4  radius 1  m
periodic  cell  0 0 to 8 8
perturb wave  0 1  periods 1 0
monitor   D  disc 1
servo     isotropic 1  on cell  through cell  at most 1e-6 per cycle
repeat    from load 1 more time
ramp      servo mean 1  on cell  through cell  at most 1e-6 per cycle
repeat    from more 2 more times
damping   critical beyond overlap 7 %
monitor   D  disc 1
record    time D.x D.vx energy.balance work.balance
D.x   expected 0 m within 1 m [it moves]    # columns
D.x   expected 10 um over seed [it moves, stated among two]
D.x   increases with v
D.x   increases with v over seed
D.x   decreases  with v
D.vx  constant with seed over v within 1 m/s
D.x   versus time within 1 m
energy.balance order 1 in v within 9
print reference_D_x_1
plot \$table_1 using 'time/s':'reference D.x/m' with lines title 'known'
print column('reference D.x max in fall/m')
packing ../bad/packing-good.tsv discs rock
\`\`\`contact-test
shear     mindlin_deresiewicz  memory 8
segment   press  overlap to 10 um  in 5 steps
segment   back   overlap to 0 um
fill      spheres box 100 mm 100 mm  to 200 mm 200 mm  fine rock  seed 1  attempts 9  else stop
monitor   G grading fine
record    time unbalanced.max W.unbalanced.mean W.unbalanced.force W.void_ratio W.normal.std W.strain.rotation W.strain.volumetric
record    W.stress.normal.fraction W.chains.fraction W.chains.bend W.coordination.mechanical W.speed.imposed W.particles G.attempts
record    boundary.particles boundary.roughness energy.imposed energy.friction step.stable step.single-contact W.contacts.lost W.fabric.lost.xx
W.contacts.lost  expected 0 within 1 [no quantity of a contact test]
unbalanced.max   expected 0 within 1 [balance]
particles = '\$load_particles'
plot @particles using 'x/m':'y/m':'radius/m' with circles, \$table using 'particle/1':'W.normal.std/N' title 'bodies, body', \\
print unbalanced_max_max, W_void_ratio_final, step_single_contact_final
let       grip = 0.3                                             # a number
lattice   discs 3 by 3  from 300 mm 0 mm  radius 5 mm  rock       # columns${tab}stay
lattice   spheres 3 by 3  from 100 mm 0 mm  radius 5 mm  rock
fill      spheres circle 100 mm 100 mm radius 20 mm  fine rock  seed 1  attempts 100  else skip
fill discs box 200 mm 100 mm  to 300 mm 200 mm  fine rock  seed 1  else skip  attempts 100 # no columns
packing ../bad/packing-good.tsv spheres rock
damping   ratio 0.1
damping   walls stiffness 1 us
transform mirror x  rotate 90 deg  translate 1 m 0 m
monitor   D  disc 1
step      0.1 of stable
step      100 per collision
damping   mass 2 1/s
damping   r89-fraction 0.1
zero velocities
reverse velocities
step      0.1 of collision
damping   con1 0.99 as cs79
boundary  fixed
affine strain 0 per cycle 0 per cycle  accumulated
step      0.1 of single-contact
servo     xx 1 kPa yy 1 kPa  on boundary  through boundary  at most 1e-6 per cycle
affine none
ramp      servo mean 1 kPa  on boundary  through boundary affine  at most 1e-6 per cycle
servo     yy 1 kPa  on boundary  through boundary  at most 1e-6 per cycle
ramp      servo xy 1 kPa  on boundary  through boundary  at most 1e-6 per cycle
\`\`\`contact-test
record    shear dissipated
segment   press  normal to 1 N
segment   move   slip by 1 um  hold normal
EOF
for page in tests/pages/old-*.md; do diff "$page" "$work/a/b/${page##*/}" | sed -n 's/^> //p'; done | diff "$work/wanted" - >"$work/said"
result $? 'every line that changes'

# A number may have a sign or a `%`. A row applies once, and words that are already new stay. Only whole parts of a name change,
# and only if the new name is one of a quantity. In an expectation a word after `in` is a stage. In a figure a quoted
# name needs a unit.
sed 's/^| *$//; s/^| //' >"$work/one.md" <<'EOF'
| ```scene
| let       a -5 mm        # signs
| let       b +5
| let       c = 5 mm
| let       d red
| step      20 % of safe
| step      0.1 of stable
| record    time voids A.voids A.voidsx A.strain.turn A.x.lost lost A.unbalance  # lost
| record    A.chains.share.turn
| until     lost above 2 J  and unbalance below 1  at most 9 cycles
| place     mirror x  turn 90 deg  turn 5 deg
| damping   walls contact-ratio 0.1
|   still   # halt
| shear     randall pieces 8
| fill      discs box 0 m 0 m to 1 m 1 m  g rock  tries 5  tries 6
| wave      0 1 periods 1 0
| ```
|
| ```expect
| lost in lost  stated 0 J within 1 J  [lost, stated]
| lost max among a   same over b among c
| A.voids       stated 1   within 1 [voids]
| time          along time
| ```
|
| ```gnuplot
| set title 'lost body'  # known
| plot $press_bodies using "body/1":'lost/J':'C.normal/N ', body_1, lost_max, known, known_lost
| print "known lost/J", 'known lost', known lost/J, "it's lost/J", A_unbalance_1, unbalance_1, '@bodies', voids_1
| print 'A.strain.turn at 5 cycles/-', 'A.strain.turn /-', A.strain.turn
| ```
EOF
sed 's/^| *$//; s/^| //' >"$work/wanted" <<'EOF'
| ```scene
| let       a = -5 mm      # signs
| let       b = +5
| let       c = 5 mm
| let       d red
| step      20 % of stable
| step      0.1 of stable
| record    time voids A.void_ratio A.voidsx A.strain.rotation A.x.lost dissipated A.unbalanced.mean # lost
| record    A.chains.share.turn
| until     dissipated above 2 J  and unbalanced.max below 1  at most 9 cycles
| transform mirror x  rotate 90 deg  turn 5 deg
| damping   walls ratio 0.1
|   zero velocities # halt
| shear     randall memory 8
| fill      discs box 0 m 0 m to 1 m 1 m  g rock  attempts 5  tries 6
| perturb wave  0 1 periods 1 0
| ```
|
| ```expect
| dissipated in lost  expected 0 J within 1 J [lost, stated]
| dissipated max over a  constant with b among c
| A.void_ratio  expected 1  within 1 [voids]
| time          versus time
| ```
|
| ```gnuplot
| set title 'lost body'  # known
| plot $press_particles using "particle/1":'dissipated/J':'C.normal/N ', body_1, dissipated_max, known, reference_lost
| print "reference dissipated/J", 'known lost', known lost/J, "it's dissipated/J", A_unbalanced_mean_1, unbalanced_max_1, '@particles', voids_1
| print 'A.strain.rotation at 5 cycles/-', 'A.strain.turn /-', A.strain.turn
| ```
EOF
"$nineball" migrate "$work/one.md" 2>"$work/said" | diff "$work/wanted" - >>"$work/said"
result $? 'lines at the limits of the rules'

sed -n '/^A block/,$p' tests/pages/old-scene.md >"$work/wanted"
sed -n '/^A block/,$p' "$work/a/b/old-scene.md" | diff "$work/wanted" - >"$work/said" &&
  grep -q 'no block: discs lattice 3 by 3, tries' "$work/a/b/old-scene.md"
result $? 'prose and examples in the text stay'

printf '```scene\nstep 20 %% of critical # a percentage\n```\n' >"$work/one.md"
"$nineball" migrate "$work/one.md" 2>"$work/said" | grep -qxF 'step 20 % of single-contact # a percentage'
result $? 'a percentage is one value'

printf '```scene\nstep\t20 %% of critical\t# a tab\n```\n```gnuplot\nprint "step.critical/s"\n```\n' >"$work/one.md"
printf '```scene\nstep\t20 %% of single-contact\t# a tab\n```\n```gnuplot\nprint "step.single-contact/s"\n```\n' >"$work/wanted"
"$nineball" migrate "$work/one.md" 2>"$work/said" | diff "$work/wanted" - >>"$work/said"
result $? 'tabs stay, and a quoted column keeps the signs of its name'

printf '```gnuplot\nprint known_M_strain_turn, M_strain_turn_1\n```\n' >"$work/one.md"
"$nineball" migrate "$work/one.md" 2>"$work/said" | grep -qxF 'print reference_M_strain_rotation, M_strain_rotation_1'
result $? 'the name of a variable has _ between its parts'

printf '```gnuplot\nset title "M.voids of the sand / a fraction"\n```\n' >"$work/one.md"
"$nineball" migrate "$work/one.md" 2>"$work/said" | diff "$work/one.md" - >>"$work/said"
result $? 'a title with a division is not the name of a column'

printf '```scene\r\ndiscs lattice 1 by 1 radius 1 m rock\r\n```\r\nlast' >"$work/one.md"
printf '```scene\r\nlattice discs 1 by 1 radius 1 m rock\r\n```\r\nlast' >"$work/wanted"
cp "$work/one.md" "$work/two.md"
"$nineball" migrate "$work/one.md" "$work/two.md" --in-place >"$work/said" 2>&1 &&
  cmp "$work/one.md" "$work/wanted" >>"$work/said" 2>&1 && cmp "$work/two.md" "$work/wanted" >>"$work/said" 2>&1
result $? '--in-place keeps the line ends'
inode=$(ls -i "$work/one.md")
"$nineball" migrate "$work/one.md" --in-place >"$work/said" 2>&1 && test "$(ls -i "$work/one.md")" = "$inode" && test ! -s "$work/said"
result $? '--in-place does not write a page that does not change'
printf '```scene\ndiscs lattice 1 by 1 radius 1 m rock\n```\n' >"$work/page.md"
{ chmod 1640 "$work/page.md" || chmod 640 "$work/page.md"; } 2>"$work/said" && ln -s page.md "$work/link.md"
before=$(ls -l "$work/page.md" | cut -c 1-10)
"$nineball" migrate --in-place "$work/link.md" >"$work/said" 2>&1 && test -L "$work/link.md" &&
  grep -q '^lattice discs' "$work/page.md" && test "$(ls -l "$work/page.md" | cut -c 1-10)" = "$before"
result $? '--in-place keeps links and permissions'
"$nineball" migrate "$work/one.md" "$work/two.md" >/dev/null 2>"$work/said"
test $? -eq 2 && grep -q 'with --in-place' "$work/said"
result $? 'several pages need --in-place'
printf '# a\n```scene\nlet  kind literal\nlet b $a\nsweep word tries 4 pieces\nlet d 5 mm\nlet e discs\nlet g = $a\nsweep f $a\n```\nlet kind literal\n' >"$work/one.md"
"$nineball" migrate "$work/one.md" >"$work/new" 2>"$work/said"
test $? -eq 0 && grep -qxF 'let d = 5 mm' "$work/new" && cat >"$work/wanted" <<EOF && diff "$work/wanted" "$work/said"
$work/one.md:3:11: warning: \`literal\` is not rewritten: with \$kind, \`continuum … literal\` is \`affine … accumulated\` now
$work/one.md:4:7: warning: if \`\$a\` is a number, write \`let b = a\`
$work/one.md:5:12: warning: \`tries\` is not rewritten: with \$word, \`fill … tries\` is \`fill … attempts\` now
$work/one.md:5:20: warning: \`pieces\` is not rewritten: with \$word, \`shear … pieces\` is \`shear … memory\` now
EOF
result $? 'old words that come by way of $NAME are named with line and column'
cat >"$work/one.md" <<'END'
~~~scene
```
let d 5 mm
~~~
let e 6 mm
````scene
```
let f 7 mm
~~~~
let g 8 mm
`````
let h 9 mm
END
sed 's/let \([dfg]\)/let \1 =/' "$work/one.md" >"$work/wanted"
"$nineball" migrate "$work/one.md" 2>"$work/said" | diff "$work/wanted" - >>"$work/said"
result $? 'a block ends at a line of as many of the same signs'
printf 'a\0b' >"$work/one.md"
cp "$work/one.md" "$work/wanted"
"$nineball" migrate --in-place "$work/one.md" 2>"$work/said"
test $? -eq 2 && grep -q 'not text' "$work/said" && cmp "$work/one.md" "$work/wanted"
result $? 'a file that is not text stays unchanged'
"$nineball" migrate "$work/none.md" 2>"$work/said"
test $? -eq 2 && grep -q 'cannot be read' "$work/said"
result $? 'a missing page'
"$nineball" migrate --in-place "$work/none.md" "$work/two.md" 2>"$work/said"
test $? -eq 2 && grep -q 'none.md.*cannot be read' "$work/said"
result $? 'a missing page before a valid one'
echo "1..$n"
