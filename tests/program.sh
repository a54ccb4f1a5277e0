#!/bin/sh
# Tests the program from outside: exit status, output, and files. TAP.
# $NINEBALL is the program, ./nineball by default; $srcdir is the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

nineball=${NINEBALL:-./nineball}
case $nineball in
/*) ;;
*) nineball=$(pwd)/$nineball ;;
esac
pages=$(cd "${srcdir:-.}/tests/pages" && pwd) || exit 1
cases=$(cd "${srcdir:-.}/cases" && pwd) || exit 1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
n=0

# verdict NAME: the result of the commands since the last verdict; their failures are in ./why.
verdict() {
  n=$((n + 1))
  if test -s why; then
    echo "not ok $n - $1"
    sed 's/^/# /' why out said
  else
    echo "ok $n - $1"
  fi
  rm -f why
}

# run STATUS ARGUMENT ...: the program must end with this status; out and said are its standard output and standard
# error.
run() {
  wanted=$1
  shift
  "$nineball" "$@" >out 2>said </dev/null
  status=$?
  test $status -eq "$wanted" || echo "status $status, wanted $wanted: nineball $*" >>why
}
out() { grep -qF -e "$1" out || echo "not on standard output: $1" >>why; }
said() { grep -qF -e "$1" said || echo "not on standard error: $1" >>why; }
quiet() { test ! -s "$1" || echo "something is on $1" >>why; }
there() { test -s "$1" || echo "missing or empty: $1" >>why; }
absent() { test ! -e "$1" || echo "left behind: $1" >>why; }
# column NAME FILE: the values of a column, one per line.
column() {
  awk -F '\t' -v name="$1" '
    /^#/ { next }
    !c { for (k = 1; k <= NF; k++) if ($k == name) c = k; next }
    { print $c }' "$2"
}

# ---- status ----
run 0 check "$pages/passes.md"
out '1 of 1 checks passed'
quiet said
absent passes.out
verdict 'a page that passes: status 0, no files'

run 0 check "$pages/filled-cell.md"
out '5 of 5 checks passed'
verdict 'a periodic cell that is filled across its edges, and compressed'

run 1 check "$pages/fails.md"
out 'FAIL  D.x expected 1.6'
out 'pass  time expected 1'
out '1 of 2 checks passed'
verdict 'a check that fails: status 1'

run 1 run "$pages/fails.md" -o fails
there fails/table.tsv
run 1 check "$pages/passes.md" "$pages/fails.md" "$pages/swept.md"
out '1 of 2 checks passed'
out 'D.x increases with v'
verdict 'several pages: all are run, the worst status counts'

run 2 run "$pages/mistaken.md" -o mistaken
said "$pages/mistaken.md:6:16: error: expected"
said 'did you mean `radius`?'
quiet out
absent mistaken
verdict 'an invalid page: status 2, with its position, no files'
run 2 run "$pages/mistaken.md" "$pages/passes.md"
there passes.out/table.tsv
rm -rf passes.out
verdict 'the pages after an invalid one are run'

run 3 check "$pages/nowhere.md"
said 'particle 2 (line 9): its position is NaN or infinite'
said 'after cycle 1, at time 1;'
run 3 run "$pages/nowhere.md" -o nowhere
out 'tables are in nowhere, up to where the run was stopped'
grep -q '^# incomplete: particle 2 (line 9)' nowhere/table.tsv || echo 'the table is not marked as incomplete' >>why
test "$(column D.x/- nowhere/table.tsv | wc -l)" -eq 1 || echo 'the table does not have the one row before NaN' >>why
verdict 'NaN: status 3, with particle, line and time'

run 3 run "$pages/past-each-other.md"
said 'particle 1 (line 7): in cycle 1, at time 0.000396333 s, it moved by 0.396333 m in one step of 0.000396333 s'
said 'its radius, 0.01 m'
verdict 'two discs that pass each other in one step: status 3, with particle, time and limit'

run 3 run "$pages/pushed-through.md"
said 'particle 1 (line 9) and particle 2 (line 10): at cycle '
said 's, they overlap by 0.01000'
said 'the smaller radius, 0.01 m'
verdict 'a disc that is pushed through another one: status 3, with both particles, time and limit'

run 3 run "$pages/whole-turn.md"
said 'wall `blade` (line 6): in cycle 1, at time 0.001 s, it turned by 6.28319 rad in one step of 0.001 s'
verdict 'a wall that rotates too far in one step: status 3, with wall, time and limit'

run 3 run "$pages/too-long-a-step.md"
said 'particle 1 (line 5): at cycle 0, time 0 s, the step 1 s is above the guaranteed stable one, 0.000792665 s'
said 'particles 1 and 2, as if they touched: write `step 0.00024 s`, or `allow unstable`; the proposal is 0.3 of the stable step, because further contacts make it shorter'
for step in '2 of stable:write `step 0.3 of stable`' '1 per collision:write `step 6 per collision`' '3 of single-contact:write `step 0.21 of single-contact`'; do
  run 3 check "$pages/too-long-a-step.md" --set step="${step%%:*}"
  said "${step#*:}"
done
run 0 explain "$pages/too-long-a-step.md"
out 'as if they touched; ABOVE it: the run will be aborted'
verdict 'a step that is too long for the first contact: status 3 before the contact'

run 0 check "$pages/warns.md"
for where in out said; do
  $where "$pages/warns.md:4: warning: friction between \`m\` and \`m\` has no effect: there is no \`shear\` law"
  $where "$pages/warns.md:5: warning: particle 1: its coordinate 9e+06 m has a resolution (ulp) of 1.86265e-09 m, that is 0.19 %"
done
run 0 explain "$pages/warns.md"
out "$pages/warns.md:4: warning: friction"
out "$pages/warns.md:5: warning: particle 1"
run 0 check "$pages/warns.md" --tap
out "# $pages/warns.md:4: warning: friction"
run 0 explain "$pages/warns.md" --set shear=linear
out 'their shear stiffness `ks` is 0'
sed 's/friction/ks 1 MN\/m friction/; s/^cycles/shear linear\ncycles/' "$pages/warns.md" >later.md
run 0 check later.md
grep -q 'warning: friction' said && echo 'warning of friction, although a stage has a shear law' >>why
sed 's/^cycles.*/&\nstage after\nmaterial m friction 0\nshear linear\ncycles 1/' "$pages/warns.md" >after.md
run 0 explain after.md
said 'after.md:4: warning: friction between `m` and `m` has no effect: there is no `shear` law in the stages with this friction'
verdict 'warnings: once on standard error, repeated by verdict and explain, no change of the status'

cat >oblique.md <<'END'
# An elastic sphere hits a wall at an angle
```scene
material  m  density 1 g/cm3  young 1 GPa  poisson 0.3  friction 0.3
sphere    0 mm 10.1 mm  radius 10 mm  m  velocity 1 m/s -1 m/s
wall      floor  -1 m 0 m  to 1 m 0 m  m
normal    hertz
shear     mindlin
step      0.2 of rayleigh
stage     fall
cycles    2
```
END
printf '```contact-test\nmaterial m young 1 GPa poisson 0.3 friction 0.3\ncontact sphere 10 mm m with sphere 10 mm m\nnormal hertz\nshear mindlin\n' >loop.md
printf 'segment press normal to 100 N in 9 steps\nsegment load shear to 20 N hold normal in 9 steps\n```\n' >>loop.md
run 0 explain oblique.md
said 'oblique.md:7: warning: `shear mindlin` has no micro-slip at the edge of the contact, on which a collision without damping depends: the exact law is `shear mindlin_deresiewicz`'
run 0 explain loop.md
said 'loop.md:5: warning: `shear mindlin` has no micro-slip at the edge of the contact, on which the result of this contact test depends: the exact law'
sed 's/  friction 0.3$/\npair m m friction 0.3/' oblique.md >pair.md
run 0 explain pair.md
said 'pair.md:8: warning: `shear mindlin` has no micro-slip'
for change in '/^stage/i gravity 0 m/s2 -9 m/s2' '/^stage/i damping ratio 0.1' '/^stage/a damping ratio 0.1' 's/friction 0.3/friction 0/' 's/velocity 1 m.s -1 m.s//' \
  's/mindlin/$law/; 2a let law mindlin' '/^segment load/d'; do
  for page in oblique loop; do
    sed "$change" $page.md >changed.md
    cmp -s $page.md changed.md && continue
    run 0 explain changed.md
    grep -q 'micro-slip at the edge' said && echo "a warning of micro-slip on the page $page after $change" >>why
  done
done
for motion in 'velocity 0 m/s -1 m/s' 'velocity 1 m/s 0 m/s' 'spin 1 rad/s'; do
  sed "s,velocity .*,$motion," oblique.md >moving.md
  run 0 explain moving.md
  said 'moving.md:7: warning: `shear mindlin` has no micro-slip'
done
run 0 explain oblique.md --set shear=mindlin
grep -q 'micro-slip at the edge' said && echo 'a warning of micro-slip with --set' >>why
verdict 'warnings: `shear mindlin` where micro-slip decides'

# The line that the hint proposes for a direction is valid in any units: the page is checked, and the check fails.
for units in 'none|||||' 'si| m| kg/m3| N/m| m/s| ms'; do
  IFS='|' read -r name m density kn v ms <<END
$units
END
  printf '```scene\nunits %s\nmaterial m density 1%s kn 1%s\ndisc 0%s 0%s radius 1%s m velocity 1%s 1%s\n' "$name" "$density" "$kn" "$m" "$m" "$m" "$v" "$v" >direction.md
  printf 'monitor A disc 1\nrecord A.vx A.vy\nstep 1%s\nstage a\ncycles 1\n```\n```expect\n' "$ms" >>direction.md
  cp direction.md heading.md
  printf 'A.heading expected 1 within 1 %% [x]\n```\n' >>heading.md
  run 2 check heading.md
  sed -n 's/.*write `\(A.vx last.*\)SOURCE\]`.*/\1geometry]\n```/p' said >>direction.md
  run 1 check direction.md
done
verdict 'the hint for a direction can be typed with any units'

cat >doubtful.md <<'END'
# What can hardly be meant
```scene
material  m  density 1 g/cm3  kn 1 MN/m
let       tilt = 20
let       a = sin(20)*1 mm
let       b = cos(-tilt)*1 mm
let       c = (sin(20 deg) + tan(0) + cos(pi/3) + cos(2*tilt) + exp(1))*1 mm
disc      0 mm 5 mm  radius 10 mm  m
disc      300 mm 0 mm  radius 10 mm  m
disc      315 mm 0 mm  radius 10 mm  m
wall      floor  -20 mm 0 mm  to 20 mm 0 mm  m
wall      blade  0 m 1 m  to 1 m 1 m  m  spin 1 rad/s
wall      gate   0 m 2 m  to 1 m 2 m  m
wall      fan    0 m 3 m  to 1 m 3 m  m  about (0*(a + b + c)) 3 m  spin 1 rad/s
region    A  all
step      1 us
record    A.porosity
stage     one
record    every 2 cycles
wall      gate  spin 1 rad/s
cycles    2
stage     two
cycles    2
stage     three
record    every 1 cycle
cycles    1
```
END
run 0 explain doubtful.md
said 'doubtful.md:5: warning: the argument of `sin()` has no unit, so it is in radians: write `20 deg` for degrees, or `20 rad`'
said 'doubtful.md:6: warning: the argument of `cos()` has no unit, so it is in radians: write `-20 deg` for degrees, or `-20 rad`'
out 'doubtful.md:8: warning: particle 1 overlaps wall `floor` (line 11) too much at the start: by 0.005 m, 25 % of the diameter; above 7 %'
said 'doubtful.md:12: warning: wall `blade` rotates about its middle: 0.5 m 1 m; its line in the scene has no `about X Y`'
said 'doubtful.md:20: warning: wall `gate` rotates about its middle: 0.5 m 2 m; its line in the scene has no `about X Y`'
test "$(grep -c warning out)" -eq 5 || echo 'not five warnings' >>why
out 'region A all: 3 particles now; area 0.008375 m2, that of the smallest rectangle around all particles, without the gaps at walls'
out '    a row every cycle: the `record` of stage `one` (line 19) holds only there'
test "$(grep -c 'a row every cycle' out)" -eq 1 || echo 'not for one stage' >>why
sed '/^wall *floor/d' doubtful.md >pair.md
run 0 explain pair.md
out 'pair.md:10: warning: particle 3 overlaps particle 2 (line 9) too much at the start: by 0.005 m, 25 % of the smaller diameter; above 7 % real particles deform plastically, and the force may be very large: move the particle away, or make it smaller'
sed 's/^disc *0 mm 5 mm/disc 0 mm 8.61 mm/; s/315 mm/318.61 mm/' doubtful.md >less.md
run 0 explain less.md
grep -q 'overlaps' out && echo 'a warning of an overlap below the limit' >>why
sed 's/^disc *0 mm 5 mm/disc 0 mm 8.59 mm/; s/315 mm/318.61 mm/' doubtful.md >more.md
run 0 explain more.md
out 'particle 1 overlaps wall `floor` (line 11) too much at the start: by 0.00141 m, 7'
for x in 312 318; do # the relatively larger one of two overlaps is named, whichever comes first
  sed "s/315 mm/$x mm/" doubtful.md >two.md
  run 0 explain two.md
  out "$(test $x = 312 && echo 'particle 3 overlaps particle 2' || echo 'particle 1 overlaps wall `floor`')"
done
# A computed angle is no bare number, and none is a number with an operator after it.
sed 's/cos(2\*tilt)/cos(tilt*2) + sin(turn) + tan(30)/; s/^let *c /let turn = 2*tilt\n&/' doubtful.md >computed.md
run 0 explain computed.md
test "$(grep 'in radians' said | sed 's/.*of `\(.*\)()`.*write `\(.*\) deg`.*/\1 \2/' | tr '\n' ' ')" = 'sin 20 cos -20 tan 30 ' || echo 'other angles' >>why
printf '```scene\nunits none\nmaterial m density 1 kn 1\nlet a = sin(20)\ndisc $a 0 radius 1 m\nstep 0.1\nstage one\ncycles 1\n```\n' >bare.md
run 0 explain bare.md
grep -q 'radians' said && echo 'a warning of an angle on a page without units' >>why
printf '```scene\nmaterial m density 1 g/cm3 kn 1 MN/m\nbox 0 m 0 m to 0.3 m 0.3 m m\n' >outside.md
printf 'lattice discs 4 by 3 radius 50 mm m\ntransform rotate 1 rad\nstep 1 us\nstage one\ncycles 1\n```\n' >>outside.md
run 0 explain outside.md
said 'outside.md:4: warning: 3 particles begin outside the box; the first is particle 4'
printf '```scene\nstart outside stage one\nrecord time\nstage on\ncycles 1\n```\n' >from-outside.md
run 0 explain from-outside.md
grep -q 'outside the box' said && echo 'the particles of another page are said to begin outside the box' >>why
sed 's/4 by 3/3 by 3/; s/^transform.*/disc 0.1 m 0.301 m radius 1 mm m\ndisc 0.1 m 0.5 m radius 1 mm m fixed/' outside.md >single.md
for at in '0.1 m 0.301 m' '0.1 m -0.001 m' '0.301 m 0.1 m' '-0.001 m 0.1 m'; do
  sed "s/^disc 0.1 m 0.301 m/disc $at/" single.md >side.md
  run 0 explain side.md
  said 'side.md:5: warning: particle 10 begins outside the box'
done
sed 's/0.301/0.298/' single.md >within.md
run 0 explain within.md
grep -q 'outside the box' said && echo 'a particle in the box or a fixed one counts as outside' >>why
verdict 'warnings: overlaps at the start, angles without a unit, walls that rotate about their middle; explained: area of a region, rows of a stage'

cat >signs.md <<'END'
# Negative pressures, a damping ratio in percent, and a wall of a box that rotates
```scene
units     si
material  m  density 1 g/cm3  kn 1 MN/m
box       0 mm 0 mm  to 100 mm 100 mm  m
lattice   discs 2 by 2  radius 10 mm  m  from 20 mm 20 mm
region    M  all
damping   ratio 30
damping   walls ratio 1.01
let       zeta = 2
step      1 us
record    box.stress.mean box.stress.xx box.stress.yy box.stress.major box.stress.minor M.stress.xy M.stress.shear.xx
stage     one
damping   ratio 200 %
until     box.stress.mean below -100 kPa at most 2 cycles
stage     two
damping   ratio $zeta
servo     yy -1 kPa on box through box at most 1e-6 per cycle
until     box.stress.mean above -100 kPa and M.stress.xy below -1 kPa at most 2 cycles
stage     three
wall      south  spin 1 rad/s
wall      north  spin -1 rad/s
cycles    1
stage     four
wall      north  spin 1 rad/s
cycles    1
```
```expect
box.stress.xx max  below -1 kPa
box.stress.xx max  expected -1 kPa within 1 % [a guess]
box.stress.xx min  above -1 kPa
M.stress.xy max    below -1 kPa
M.stress.shear.xx  below -1 kPa
box.stress.xx max  expected -2 of box.stress.mean max within 1 % [a ratio is not a pressure]
box.stress.yy      below -1 kPa
box.stress.major   below -1 kPa
box.stress.minor   below -1 kPa
```
END
run 0 explain signs.md
said 'signs.md:8: warning: a damping ratio above 1 is more than critical damping: 30 is 3000 % of it; if that is meant, write `ratio 3000 %`, otherwise `ratio 30 %`'
said 'signs.md:9: warning: a damping ratio above 1 is more than critical damping: 1.01 is 101 % of it'
said 'signs.md:21: warning: wall `south` rotates about its middle: 0.05 m 0 m; its line in the scene is a `box`; only a line `wall` can have `about X Y`'
said 'signs.md:22: warning: wall `north` rotates'
tension='with a negative value means tension, because stress is positive in compression: for a pressure write'
said "signs.md:15: warning: \`box.stress.mean below\` $tension \`box.stress.mean above 100000 Pa\`"
said "signs.md:18: warning: \`servo yy\` $tension \`servo yy 1000 Pa\`"
said "signs.md:19: warning: \`box.stress.mean above\` $tension \`box.stress.mean below 100000 Pa\`"
said "signs.md:29: warning: \`box.stress.xx below\` $tension \`box.stress.xx above 1000 Pa\`"
said "signs.md:30: warning: \`box.stress.xx expected\` $tension \`box.stress.xx expected 1000 Pa\`"
said "signs.md:35: warning: \`box.stress.yy below\` $tension \`box.stress.yy above 1000 Pa\`"
said "signs.md:36: warning: \`box.stress.major below\` $tension \`box.stress.major above 1000 Pa\`"
said "signs.md:37: warning: \`box.stress.minor below\` $tension \`box.stress.minor above 1000 Pa\`"
test "$(grep -c 'warning' said)" -eq 12 || echo 'not twelve warnings' >>why
sed 's/ratio 30/ratio 1/; s/ratio 1.01/r89-fraction 30/; s/spin -1/spin 1/; s/-1 kPa/1 kPa/; s/-100 kPa/100 kPa/' signs.md >plus.md
run 0 explain plus.md
quiet said
verdict 'warnings: tension in place of a pressure, more than critical damping, a wall of a box that rotates'

cat >cohesive.md <<'END'
```scene
units     si
material  rock  density 2500 kg/m3  kn 1 kN/m  ks 1 kN/m  friction 0.3  cohesion 1 mN
normal    linear
shear     linear
disc      0 mm 0 mm     radius 5 mm  rock
disc      9.99 mm 0 mm  radius 5 mm  rock
monitor   C  disc 1 with disc 2
step      0.01 of single-contact
record    C.normal C.shear
stage     pull
cycles    2
```
```expect
C.normal min  expected -1 mN within 10 % [cohesion]
C.normal min  expected 1 mN within 10 % [a guess]
C.shear min   expected -1 mN within 10 % [a guess]
C.normal min  below -1 mN
C.normal min  above -1 mN
```
END
run 0 explain cohesive.md
said 'cohesive.md:15: warning: `C.normal` is 0 or more with all laws of nineball: there are no bonds and no tension, and `cohesion`'
said 'cohesive.md:18: warning: `C.normal` is 0 or more'
said 'cohesive.md:19: warning: `C.normal` is 0 or more with all laws of nineball: there are no bonds and no tension, and `cohesion` in `material` is added to the limit of the shear force. So this expectation always holds'
test "$(grep -c 'always holds' said)" -eq 1 || echo 'another expectation always holds' >>why
test "$(grep -c 'warning' said)" -eq 3 || echo 'not three warnings' >>why
verdict 'a warning of a tensile normal force'

cat >rows.md <<'END'
```scene
units none
material m density 1 kn 100
disc 0 0 radius 1 m velocity 1 0
step 1e-6
record time
stage before
cycles 400000
stage long
cycles 599990
stage after
cycles 10
```
END
run 0 run rows.md -o rows
said 'rows.md:9: warning: table.tsv has 1000001 rows, most of them of stage `long`: write `record every 10 cycles` in it'
sed 's/^stage long/&\nrecord every 10 cycles/' rows.md >fewer.md
run 0 run fewer.md -o fewer
grep 'warning: table' said >>why
printf '```contact-test\nmaterial m kn 1 MN/m\ncontact disc 1 m m with wall m\nrecord overlap\nsegment s normal to 1 N in 1000000 steps\n```\n' >steps.md
run 0 run steps.md -o rows
said 'steps.md:5: warning: table.tsv has 1000001 rows, most of them of stage `s`: write `record every 10 steps` in it'
rm -rf rows fewer
verdict 'a warning of a table of a million rows'

cat >strains.md <<'END'
```scene
units none
material m density 1 kn 100
box 0 0 to 9 9 m
disc 3 3 radius 1 m
region M all
step 0.1 of stable
record time
stage a
box strain 0 -0.1
until M.strain.yy above 0.1 at most 9 cycles
stage b
until box.strain.height above 0.2 at most 9 cycles
stage c
box strain 0.1 -0.1
until M.strain.xx below -0.1 at most 9 cycles
stage right
until M.strain.xx above 0.1 and box.strain.height below -0.1 at most 9 cycles
stage servo
servo yy 1 on walls through box at most 1
until M.strain.yy above 0.1 at most 9 cycles
```
END
run 0 explain strains.md
said 'strains.md:11: warning: stage `a` compresses in y, and extension is positive: in place of `M.strain.yy above 0.1` write `M.strain.yy below -0.1`'
said 'strains.md:13: warning: stage `b` compresses in y, and extension is positive: in place of `box.strain.height above 0.2` write `S.strain.yy below -0.2`, with `region S all from b` in the scene'
said 'strains.md:16: warning: stage `c` extends in x, and extension is positive: in place of `M.strain.xx below -0.1` write `S.strain.xx above 0.1`, with `region S all from c` in the scene'
test "$(grep -c 'extension is positive' said)" -eq 3 || echo 'not three warnings' >>why
cat >pressed.md <<'END'
```scene
units none
material m density 1 kn 100
disc 1 1 radius 1 m
disc 1 3 radius 1 m
wall bottom -9 0 to 9 0 m
wall top -9 4 to 9 4 m velocity 0 -0.1
wall side 2.5 -9 to 2.5 9 m velocity 0 -0.1
wall other 3 -9 to 3 9 m velocity 0 0.1
region M all
step 0.1 of stable
record time
stage a
until M.strain.yy above 0.1 and M.strain.xx below -0.1 at most 9 cycles
stage b
wall top velocity 0 0.1
until M.strain.yy below -0.1 at most 9 cycles
stage less
until M.strain.yy below 0.5 at most 9 cycles
stage right
wall top velocity 0 -0.1
until M.strain.yy below -0.1 and M.strain.xx above 0.1 at most 9 cycles
stage more
until M.strain.yy above -0.5 at most 9 cycles
stage both
wall bottom velocity 0 -0.2
until M.strain.yy above 0.1 at most 9 cycles
stage again
wall bottom velocity 0 0
until M.strain.yy above 0.2 at most 9 cycles
repeat from again 2 more times
```
END
run 0 explain pressed.md
said 'pressed.md:14: warning: stage `a` compresses in y, and extension is positive: in place of `M.strain.yy above 0.1` write `M.strain.yy below -0.1`'
said 'pressed.md:17: warning: stage `b` extends in y, and extension is positive: in place of `M.strain.yy below -0.1` write `S.strain.yy above 0.1`, with `region S all from b` in the scene'
said 'pressed.md:30: warning: stage `again` compresses in y, and extension is positive: in place of `M.strain.yy above 0.2`'
test "$(grep -c 'extension is positive' said)" -eq 3 || echo 'not three warnings of walls that move' >>why
verdict 'warnings: a condition on a strain of the other sign than the strain rate'

for command in check run 'check --tap' explain; do
  "$nineball" $command "$pages/warns.md" >out 2>&1 </dev/null
  test "$(grep -c 'warns.md:4: warning: friction' out)" -eq 1 || echo "not once in a file: $command" >>why
  "$nineball" $command "$pages/warns.md" 2>&1 </dev/null | cat >out
  test "$(grep -c 'warns.md:4: warning: friction' out)" -eq 1 || echo "not once in a pipe: $command" >>why
done
{
  printf '```scene\nsweep far 9e6 m 9.5e6 m 10e6 m\n'
  sed "1,3d; s/disc *9000000.019999 m/disc (far + 19.999 mm)/; s/disc *9000000 m/disc \$far/; s/within 1 %/within 50 %/" "$pages/warns.md"
} >far.md
run 0 check far.md
test "$(grep -c 'has a resolution (ulp)' said)" -eq 1 || echo 'not once for the runs of a sweep' >>why
rm -rf warns.out
verdict 'warnings: once if standard output and standard error are one file or pipe'

if command -v script >/dev/null; then # both streams are the same terminal
  for command in check explain 'check --tap'; do
    script -qec "'$nineball' $command '$pages/warns.md'" /dev/null >out 2>&1 </dev/null
    test "$(grep -c 'warns.md:4: warning: friction' out)" -eq 1 || echo "not once on a terminal: $command" >>why
    script -qec "'$nineball' $command '$pages/warns.md' >repeated" /dev/null >out 2>&1 </dev/null
    test "$(grep -c 'warns.md:4: warning: friction' out)" -eq 1 && grep -q 'warning: friction' repeated ||
      echo "not in both: $command" >>why
  done
  verdict 'warnings: once on a terminal, twice if standard output is a file'
  sed 's/^cycles.*/cycles 1000000000/' "$pages/warns.md" >long.md
  timeout -s INT 4 script -qec "timeout -s INT 3 '$nineball' run long.md" /dev/null 2>&1 </dev/null | tr '\r' '\n' >out
  sed '/, stage .* s left/q' out | grep -q 'long.md:4: warning: friction' || echo 'no warning before the first line of progress' >>why
  test "$(grep -c 'long.md:4: warning: friction' out)" -eq 1 || echo 'not one warning' >>why
  grep -q ' s left' out || echo 'no progress' >>why
  rm -rf long.out
  verdict 'warnings: before the first line of progress'
fi

for page in 5-numerics/rayleigh-mean:gap='1e300 mm' 8-published/chung-ooi-6:beta=1e9; do # the references must not run forever
  run 2 check "$cases/${page%%:*}.md" --set "${page#*:}"
  said "$cases/${page%%:*}.md: error: "
done
verdict 'a reference without a solution reports an error'

run 3 check "$pages/never-ends.md"
said 'stage `wait` (line 10) did not end within 20 cycles: D.x is 5 and should be above 6'
run 3 run "$pages/never-ends.md" -o never
for file in table verdict wait-particles; do
  grep -q '^# incomplete: stage `wait`' "never/$file.tsv" || echo "$file is not marked as incomplete" >>why
done
test "$(column cycle/- never/table.tsv | tail -n 1)" = 20 || echo 'the last row is missing' >>why
verdict 'a stage that never ends: status 3, with its condition'

run 2 check "$pages/asks-nothing.md"
said 'error: nothing was checked, because the page has no expectation; the run itself succeeded, and `nineball run '
said 'asks-nothing.md` runs such a page; to check the page, add a line such as `QUANTITY max below VALUE` to a block `expect`'
run 0 run "$pages/asks-nothing.md"
there asks-nothing.out/table.tsv
sed 's/^step .*/&\nmonitor D disc 1\nrecord D.x/' "$pages/asks-nothing.md" >reports.md
printf '\n```expect\nreport D.x max\nreport D.x\n```\n' >>reports.md
run 2 check reports.md
said 'the page has no expectation; the run itself succeeded, and `nineball run reports.md` runs such a page and prints the values of its lines `report`'
out 'note  report D.x max'
out '        computed 1'
out '  2 noted'
run 0 run reports.md -o reports
test "$(column 'D.x max/-' reports/values.tsv)" = 1 || echo 'a reported measure is not in values.tsv' >>why
verdict 'a page without expectations does not pass but can be run; `report` is not an expectation'

# The reference of a measure in values.tsv is the expected value of this measure, also if a later line of the page gives it. If
# this line divides the measure by another one, the reference is the expected quotient times the other measure. The reference of
# a residual is 0, unless the page expects another value. An expectation without a value gives nan.
sed 's/^step .*/&\nmonitor D disc 1\nrecord D.x D.y energy.balance/' "$pages/asks-nothing.md" >expected.md
printf '\n```expect\nreport D.x max\nD.x max expected (1 + 1) within 3 [sum]\nD.x min expected (1/4) of D.y within 300 %% [quarter]\nD.y above -9\nenergy.balance expected 3 within 4 [three]\nreport energy.balance max\n```\n' >>expected.md
"$nineball" run expected.md -o expected >out 2>said
for pair in 'reference D.x max/-=2' 'reference D.x min/-=0.5' 'reference D.y/-=nan' \
  'reference energy.balance/-=3' 'reference energy.balance max/-=0'; do
  test "$(column "${pair%=*}" expected/values.tsv)" = "${pair#*=}" || echo "not $pair" >>why
done
verdict 'the references in values.tsv are the expected values'

# An expectation of a curve has no column in values.tsv. If the page also expects a value of the same quantity, only this
# value has a column.
sed 's/^cycles .*/cycles 500/; s/^D.y versus.*/&\nreport D.y\nD.y max above -1 m/; /^C.overlap max/d' \
  "$cases/1-two-discs/free-fall.md" >curves.md
"$nineball" run curves.md -o curves >out 2>said
head=$(grep -v '^#' curves/values.tsv | head -n 1 | tr '\t' ' ')
test "$head" = 'e/- off/- run D.y/m reference D.y/m D.y max/m reference D.y max/m' || echo "columns: $head" >>why
verdict 'values.tsv has a column for each value and none for a curve'

run 1 check --tap "$pages/fails.md"
out '1..2'
out 'not ok 1 - D.x expected 1.6'
out 'ok 2 - time expected 1'
run 2 check --tap "$pages/mistaken.md"
out 'not ok 1'
verdict 'TAP'

# ---- the command line ----
run 2
said 'usage: nineball COMMAND'
quiet out
run 2 chek "$pages/passes.md"
said 'there is no command `chek`'
said 'did you mean `check`?'
run 2 frobnicate
said 'there is no command `frobnicate`; see nineball --help'
run 2 compare a.md b.md
said 'there is no command `compare`; compare runs in one page: `sweep mu 0.2 0.6`'
run 2 check
said '`nineball check` needs a page'
verdict 'no command, an unknown command, a command without a page'

run 2 check "$work/none.md"
said "$work/none.md"
said 'No such file'
run 2 run "$work"
said "$work"
verdict 'a missing page, a folder as a page'

run 2 check --frobnicate "$pages/passes.md"
grep -qx 'nineball: see nineball --help' said || echo 'no reference to --help' >>why
run 0 -h
out 'usage: nineball COMMAND'
run 2 check --threads many "$pages/passes.md"
said 'found `many`'
run 2 check --threads 0 --tap "$pages/passes.md"
said 'after --threads'
run 2 check --isa mmx "$pages/passes.md"
said 'expected `--isa plain`, `avx2` or `avx512`, found `mmx`'
run 2 check --set v "$pages/passes.md"
said 'expected NAME=VALUE after --set, found `v`'
run 2 run -o both "$pages/passes.md" "$pages/swept.md"
said 'one page at a time'
absent both
verdict 'invalid options'

# Each command with an option that it does not use; the message names the commands that do.
for use in 'check -o out:--output, which is an option of: run, figure, report, advise, state' 'check --stage a:--stage, which is an option of: state' \
  'figure --tap:--tap, which is an option of: check' 'explain -o out:--output, which' 'explain --jobs 2:--jobs, which is an option of: run, check, figure, report, advise' \
  'run --within 1:--within, which is an option of: advise' 'check --quantity x:--quantity, which' 'explain --budget 1:--budget, which' \
  'state --jobs 2:--jobs, which' \
  'run --trust:--trust, which is an option of: figure, report, advise' 'laws --threads 2:--threads, which' 'list --isa plain:--isa, which' \
  'laws --set a=1:--set, which' 'list --states a:--states, which'; do
  command=${use%%:*}
  run 2 $command "$pages/passes.md"
  quiet out
  said "nineball: \`nineball ${command%% *}\` does not use ${use#*:}"
done
for command in run check figure report explain state; do # options of all commands
  run 0 $command "$pages/passes.md" --threads 1 --isa plain --states there
done
run 1 advise "$pages/passes.md" --within '1 %' --budget 1e-9 --threads 1 --isa plain --states there --jobs 2 --trust -o there
run 0 check "$pages/passes.md" --tap --jobs 2
run 0 figure "$pages/passes.md" --trust --jobs 2 -o drawn
rm -rf out passes.out report passes-*.state
verdict 'an option that a command does not use is an error'

run 0 --version
grep -Eqx 'nineball [0-9]+\.[0-9]+\.[0-9]+' out || echo 'no version' >>why
out 'GPL-3.0-or-later'
run 0 --help
for word in run check figure report explain state laws list --set --stage --threads --isa 'exit status'; do out "$word"; done
test "$(sed -n '/^usage/,/^  -/p' out | wc -l)" -eq 14 || echo 'not one line for each of the ten commands' >>why
run 0 check --help
out 'usage: nineball COMMAND'
out '      --jobs N'
grep -q -e '--quantity' out && echo 'an option that the command does not take' >>why
run 0 --help scene
for word in 'lattice' 'stage' 'MONITOR.NAME' 'increases with'; do out "$word"; done
run 0 --help transform
out '`x` changes the sign of x'
run 0 --help expect
for word in MEASURE amplitude 'reference NAME' within; do out "$word"; done
run 0 --help kn
out 'kn K: a stiffness, 0 or more; without it: 0.'
out 'kn K: a stiffness, 0 or more; without it: as it was.'
run 0 --help C.normal
out 'normal, quantity of a contact, in N: elastic normal force'
run 0 --help energy.balance
out 'energy.balance, quantity of the scene, in J: '
run 0 run --help
out 'usage: nineball COMMAND'
out '`run` of other programs is `cycles` or `until` here'
run 0 --help dashpot
test "$(grep -c 'stiffness TIME|ratio X' out)" -eq 1 || echo 'the statement is not shown once' >>why
run 0 --help unbalanced-force
out "PFC's average ratio"
out 'unbalanced.max, quantity of the scene'
run 0 --help mindlin_loops
out 'mindlin_loops, a reference'
run 0 --help contact-test
out 'contact disc|sphere R MATERIAL'
run 0 --help save
out 'nothing has to be saved'
run 0 --help cell strain
out 'The engineering shear rate is 2 EXY'
run 0 --help 'periodic cell'
out 'periodic  cell 0 mm 0 mm to 80 mm 80 mm'
run 0 --help max unbalanced
out 'unbalanced.max, quantity of the scene'
out 'max, after the quantity of an expectation'
run 0 --help over with
test "$(grep -c 'increases with NAME {over SAMPLE}$' out)" -eq 1 || echo 'an expectation with both words is not printed once' >>why
run 2 --help nothing such
run 0 --help thickness
out '1 m thick'
run 0 --help 'servo off'
out 'a servo ends with its stage'
run 0 --help reference
out 'Selects the reference solution of the page'
run 2 --help norma
said '`norma` is not a word of pages; did you mean `normal`?'
verdict '--version and --help'

run 0 laws
out 'normal  linear'
out 'shear   linear'
out 'parameters of the materials: ks, friction, cohesion'
out '[CS79 17-19]'
out 'has the kn and ks of this material'
run 0 list
out 'nine_discs'
verdict 'laws and list'

run 0 explain "$pages/same-bits.md"
out 'run friction=0'
out 'run friction=0.4'
out 'disc-disc, overlap and both increments'
out 'shear linear                             line 14'
out '0.05 of it'
out '133 bytes a particle, 128 a contact'
out '  shear forces (8 bytes a contact), balances of work and energy (96 bytes a particle), periodic cell, boundary, servo, regions'
out '133 bytes a particle, 144 a contact'
out '  balances of work and energy (96 bytes a particle), periodic cell, boundary, servo, regions'
out '  300 cycles, '
out 'all 2 runs'
out '  600 cycles, '
absent same-bits.out
printf '```scene\nunits none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nstep 0.1\nrecord time\nstage s\ncycles 1\n```\n' >alone.md
run 0 explain alone.md
out 'stable: no limit, because no contact with a stiffness can form'
out 'collision: none is possible'
grep -q ' inf' out && echo "a disc alone: $(grep ' inf' out)" >>why
out '  none: no particle can touch another one or a wall'
# Two spheres with the radii 1 and 3, G = 1 and nu = 0: the Rayleigh step of the first one is pi/0.874032 [R89 4.33], and that
# of a sphere with the mean radius is twice as long. The smallest rectangle around both has the sides 8 and 12.
printf '```scene\nunits none\nmaterial m density 1 young 2 poisson 0\nnormal hertz\nwall floor -9 0 to 9 0 m\nsphere 0 1 radius 1 m velocity 0 -1\nsphere 4 9 radius 3 m\nstep 0.2 of rayleigh\nregion A all\nrecord time work.balance\nstage s\ncycles 1\n```\n' >elastic.md
run 0 explain elastic.md
out '  1 pairs closer than 0.2; rebuilt when a particle or wall has moved 0.1'
out '  line 9: region A all: 2 particles now; area 96, that of the smallest rectangle around all particles, without the gaps at walls'
out '  stable: unknown, elastic spheres without overlap have no stiffness'
out '  rayleigh, the travel time of a surface wave round half a sphere: smallest 3.59437, mean 7.18874; the step is 0.2 and 0.1 of it'
out '  before the motion  energy balance'
out '  after the motion   energy balance'
out '  before the forces  stability check'
out '  after the forces   stability check of stiffening contacts'
out '  work, updated every cycle by one thread'
# A disc of mass 1 on a wall: the stiffness 16 limits the step to 2/16^(1/2), and a collision takes pi/16^(1/2).
printf '```scene\nunits none\nlet d = 1/pi\nmaterial m density $d kn 16 ks 4 friction 0.5\nnormal linear\nshear linear\ndisc 0 0.9375 radius 1 m\nwall w -9 0 to 9 0 m\nstep 0.1 of single-contact\nrecord time energy.balance\nstage s\nramp material m kn 32 ks 1 friction 0\ncycles 1\n```\n' >springs.md
run 0 explain springs.md
out '    in stage `s` linearly until its end (line 12): kn 32, ks 1, friction 0; no shear force without friction and cohesion'
out '  energy, updated every cycle by one thread'
out '  0.05, line 9'
out '  single contact, 2 sqrt(m/k): 0.5; the step is 0.1 of it, the stable step 1 of it'
out '  stable: 0.5; the step is 0.1 of it; limited by normal motion of particle 1 and wall w'
out '  collision, the shortest possible: 0.785398; the step is 0.063662 of it'
sed 's/^step .*/step 1\nallow unstable/; s/ energy.balance/ energy.balance work.balance/; s/ friction 0$/ friction 0.25/' springs.md >longer.md
run 0 explain longer.md --set step=0.75
out '(line 13): kn 32, ks 1, friction 0.25'
grep -q 'no shear force' out && echo 'friction that a stage reduces is called 0' >>why
out '  work and energy, updated every cycle by one thread'
out '  0.75, --set'
out '  stable: 0.5; the step is 1.5 of it; limited by normal motion of particle 1 and wall w; allowed to be unstable'
sed '/^allow unstable/d; s/^stage s$/&\nallow unstable/' longer.md >allowed.md
run 0 explain allowed.md
out '  stable: 0.5; the step is 2 of it; limited by normal motion of particle 1 and wall w; allowed to be unstable'
# A disc of mass 1 in a box, with springs of the length 0.9375 to two walls: B = 2*16*0.9375^2/(4*7.5), and with the fixed
# disc T = (2/B)^(1/2).
printf '```scene\nunits none\nlet d = 1/pi\nmaterial m density $d kn 16 ks 4\nmaterial n density $d kn 16 ks 4 friction 0.5\nnormal linear\nshear linear\nbox 0 0 to 1.875 4 m\ndisc 0.9375 2 radius 1 m\ndisc 9 9 radius 1 n fixed\nstep 0.1\nrecord time\nstage s\nservo xx 1 on box through box at most 1e-6\ncycles 1\n```\n' >squeezed.md
run 0 explain squeezed.md
out '    (no shear linear: the pair has neither friction nor cohesion)'
out '    gain of the servo: strain rate P = error/(2 B T), plus the time integral of P/(16 T); now the bulk stiffness B is 0.9375, the travel time T of a wave across the assembly 1.46059'
# One of two discs of radius 2 has space in a circle of radius 2.5.
printf '```scene\nunits none\nmaterial m density 1 kn 1\ngrading g 2 2 0.25 1\nfill discs circle 0 0 radius 2.5 g m seed 1 attempts 100 else skip\nstep 0.1\nrecord time\nstage s\ncycles 1\n```\n' >full.md
run 0 explain full.md
out '  circle with g, seed 1: 2 of 3 particles placed in '
out ' attempts, particles 1 to 2 (line 5)'
out '    radius 2: 1, 1 not placed, no space'
grep -qx '    radius 0.25: 1' out || echo 'the number of the small discs' >>why
# The duration of a collision [R89 4.28]: 2.94328 alpha/v, alpha = (5 m v^2/(4 K))^(2/5), K = 4/3 E* R^(1/2).
collides() { printf '```scene\nunits none\nmaterial m density 1 young 1000 poisson 0.2\nnormal hertz\n'"$1"'\nstep 0.001\nrecord time\nstage s\ncycles 1\n```\n' >collides.md; }
collides 'sphere 0 3 radius 1 m velocity 0 -1\nwall w -9 0 to 9 0 m'
run 0 explain collides.md
out '  collision, Hertz: 0.416654, 417 steps; particle 1 and wall w at 1'
collides 'sphere 0 3 radius 1 m velocity 1 0\nsphere 9 3 radius 1 m'
run 0 explain collides.md
grep -q '^  collision, Hertz: 0.362718, 363 steps; particle [12] and particle [12] at 1$' out || echo 'the collision of two spheres' >>why
collides 'sphere 0 3 radius 1 m velocity -1 0\nsphere 9 3 radius 1 m'
run 0 explain collides.md
out '  collision: no pair approaches'
sed 's/kn 1  ks 1 //; s/^shear .*//' "$pages/passes.md" >soft.md
run 0 explain soft.md
out 'single contact: none, no contact has a stiffness'
run 2 explain soft.md --set step='0.1 of single-contact'
said '--set: the step has no limit: a fraction needs a free particle, a partner that it could touch, and a material with'
sed 's/^step .*/ 	step 0.1 of single-contact/' soft.md >endless.md
run 2 check endless.md
said "endless.md:12:3: error: the step has no limit: "
run 2 check --tap endless.md
out "# line 12: the step has no limit: "
for page in endless.md "$pages/fails.md" "$pages/passes.md" "$pages/never-ends.md" "$pages/hidden.md"; do
  "$nineball" check --tap "$page" >out 2>&1
  test "$(grep -c -E '^(not )?ok ' out)" = "$(sed -n 's/^1[.][.]//p' out)" || echo "$page: another number of lines than planned" >>why
done
printf '```scene\nunits none\nstart endless stage flight\nrecord time\nstage on\ncycles 1\n```\n' >from-endless.md
run 2 check from-endless.md
said "endless, line 12, from which this page starts: the step has no limit: "
# Pairs in the neighbour list, by their materials: each kind of pair has another number of them.
cat >sorts.md <<'END'
```scene
units none
material a density 1 kn 1
material b density 1 kn 2
wall p -99 0 to 99 0 a
wall q -99 50 to 99 50 b
disc 0 1 radius 1 a
lattice discs 3 by 1 b radius 1 spacing 10 from 20 1
disc 8 51 radius 1 a
lattice discs 4 by 1 b radius 1 spacing 2 from 10 51
disc 18 51 radius 1 a
lattice discs 2 by 1 a radius 1 spacing 2 from 0 20
step 0.01
record time
stage s
cycles 1
```
END
run 0 explain sorts.md
for pairs in 'a with a: 1' 'a with b: 2' 'b with b: 3' 'a with wall of a: 1' 'a with wall of b: 2' 'b with wall of a: 3' 'b with wall of b: 4'; do
  test "${pairs##* }" -eq 1 && noun=pair || noun=pairs
  out "  $pairs $noun in the neighbour list;"
done
run 0 explain "$pages/drives.md"
out '  line 9: boundary circle 0 0 radius 10'
out '157 bytes a particle (without rotation), 116 a contact'
out '  rotation (16 bytes a particle), shear forces, dashpots, mass-proportional damping, balances of work and energy (96 bytes a particle), periodic cell'
out '    line 15: boundary strain 1e-4 per cycle -1e-4 per cycle shear 2e-5 per cycle'
out '    line 15: strain rate xx 0.0001, c12 2e-05, c21 2e-05, yy -0.0001 per cycle: pure shear, the engineering shear rate is twice c12, 4e-05 per cycle; simple shear at this rate is `c12 4e-05 per cycle`'
out '    line 24: ramp servo mean 12 on boundary through boundary affine at most 1e-4 per cycle every 5 cycles'
out 'there are no contacts yet'
out '  c2, 1 to 10 cycles: the condition on line 32 decides'
out '  line 10: region A circle 1 2 radius 5 rings 3 from b: 1 particles now'
grep -c 'line 30:' out | grep -qx 1 || echo 'a statement is shown in several stages' >>why
! grep 'goes on' out >>why
sed '/^stage b/,/^stage c$/{ /^  boundary fixed/d; /^  affine none/d; }' "$pages/drives.md" >inherited.md
run 0 explain inherited.md
out '    goes on from stage `a`, line 15: boundary strain 1e-4 per cycle -1e-4 per cycle shear 2e-5 per cycle'
out '    goes on from stage `a`, line 16: affine strain 1e-2 3e-2 accumulated'
sed 's/shear 2e-5 per/c12 2e-5 per/' "$pages/drives.md" >simple.md
printf '```scene\nunits none\nmaterial m density 1 kn 1\nbox 0 0 to 9 9 m\ndisc 3 3 radius 1 m\nstep 1\nrecord time\nstage a\nwall east velocity 1 0\nwall west velocity 2 0\ncycles 1\nstage b\ncycles 1\nwall west velocity 0 0\nstage c\nbox strain 0 1\ncycles 1\nstage d\ncycles 1\n```\n' >moved.md
run 0 explain moved.md
grep 'goes on' out >goes-on
printf '```scene\nunits none\nmaterial m density 1 young 1.82 poisson 0.3\nsphere 0 0 radius 1 m\nsphere 2 0 radius 1 m\nstep 1\nrecord time\nstage a\nnormal hertz\ncycles 1\n```\n' >later.md
run 0 explain later.md
out '  m with m: 1 pair in the neighbour list; E* 1, G* '
sed 's/^wall east.*/walls inward 1/; /^wall west/d; /^box strain/d' moved.md >walls.md
run 0 explain walls.md
test "$(grep -c 'goes on from stage `a`, line 9: walls inward 1' out)" -eq 3 || echo 'a line for four walls is not shown once in each stage' >>why
printf '    goes on from stage `a`, line 9: wall east velocity 1 0\n    goes on from stage `c`, line 16: box strain 0 1\n' | diff - goes-on >>why
for stage in b d; do
  printf '```scene\nunits none\nstart moved stage %s\nrecord time\nstage e\ncycles 1\n```\n' $stage >from-moved.md
  "$nineball" explain from-moved.md | grep 'goes on'
done >goes-on 2>>why
printf '    goes on from stage `a` of moved, line 9: wall east velocity 1 0\n    goes on from stage `c` of moved, line 16: box strain 0 1\n' | diff - goes-on >>why
run 0 explain simple.md
out ' c12 2e-05, c21 0, yy -0.0001 per cycle: simple shear, the engineering shear rate is 2e-05 per cycle; xy of a stress becomes negative'
sed 's/shear 2e-5 per cycle/c12 2e-5 per cycle c21 1e-5 per cycle/' "$pages/drives.md" >turned.md
run 0 explain turned.md
out ': shear with rotation, the engineering shear rate is 3e-05 per cycle'
out '    line 15: xx +0.0001 per cycle: extension in x; yy -0.0001 per cycle: compression in y'
printf '```scene\nunits si\nmaterial a density 1 g/cm3 kn 1 N/m\nperiodic cell 0 m 0 m to 9 m 9 m\ndisc 1 m 1 m radius 1 m a\nstep 1 us\nrecord time\nstage shear\ncell strain 0 1/s 0 1/s c12 0.1 1/s\nuntil cell.strain.xy above 10 %% at most 9 cycles\n```\n' >half.md
run 0 explain half.md
out '    line 10: `cell.strain.xy` is the component of the tensor, half the engineering shear strain; for an engineering shear strain of 10 % within this stage write `stage.time above 1 s`'
sed 's/^until .*/until cell.strain.xx below -10 % at most 9 cycles/' half.md >half-no-shear.md
run 0 explain half-no-shear.md
grep -q 'half the engineering' out && echo 'a condition on the component xx is called one on a shear strain' >>why
sed 's,0.1 1/s,1e-3 per cycle,; s,0 1/s 0 1/s,0 per cycle 0 per cycle,' half.md >half-cycles.md
run 0 explain half-cycles.md
out 'an engineering shear strain of 10 % within this stage write `cycles 100`'
sed 's/shear 2e-5 per cycle//' "$pages/drives.md" >straight.md
run 0 explain straight.md
grep -q 'line 15: strain rate' out && echo 'a strain without shear has an engineering shear rate' >>why
printf '```scene\nunits none\nmaterial a density 1 kn 1 ks 1 friction 1\nmaterial b density 1 kn 1 ks 1 friction 1\ndisc 0 0 radius 1 a\ndisc 3 0 radius 1 b\ndisc 6 0 radius 1 b\nstep 0.1\nrecord time\nstage one\ncycles 1\nstage two\n%%s\ncycles 1\n```\n' >pairs.md
sed 's/^%s$/shear linear/' pairs.md >sheared.md # a law that a stage gives
run 0 explain sheared.md
grep -q '^  rotation\|shear forces' out && echo 'a law of a stage is not used' >>why
out '  a with b: '
out '  b with b: '
grep -q '  a with a: ' out && echo 'the only particle of a material touches itself' >>why
sed '/^%s$/d' pairs.md >smooth.md
run 0 explain smooth.md
out '  rotation (16 bytes a particle), shear forces, dashpots, '
# The particles of a packing are numbered after those above it.
sed 's/^step .*/grading g 2 3 1 2\nfill discs box 10 0 to 50 40 g a seed 1 attempts 999 else skip\nfill discs box 60 0 to 99 40 g b seed 2 attempts 999 else skip\n&/; /^%s$/d' pairs.md >filled.md
run 0 explain filled.md
out '  box with g, seed 1: 5 of 5 particles placed in '
out ' attempts, particles 4 to 8 (line '
out ' attempts, particles 9 to 13 (line '
sed 's/^%s$/damping none/; s/^step/damping mass 2\nstep/' pairs.md >slowed.md
run 0 explain slowed.md
out 'loading and damping, at the start of the run'
out '  mass-proportional damping 2, line '
grep -q '^  rotation.*mass-proportional' out && echo 'mass-proportional damping is used' >>why
sed '/^%s$/d; s/^step/damping con1 0.75 as all\nstep/' pairs.md >con1.md
run 0 explain con1.md
out '  damping con1 0.75, line '
run 0 explain smooth.md
out ', dashpots, mass-proportional damping, '
grep -q 'loading and damping' out && echo 'damping that the page does not have' >>why
sed '/^%s$/d; s/^step/damping ratio (sqrt(2)*0.1)\ndamping walls stiffness (1\/4)\nstep/' pairs.md >computed.md
run 0 explain computed.md
out '  damping ratio 0.141421, line '
out '  damping walls stiffness 0.25, line '
run 0 explain "$cases/2-hertz/overlap-deep.md"
out '  damping critical beyond overlap 7 %, line 39'
grep -q '  damping walls' out && echo 'contacts with walls have no damping of their own' >>why
sed '/^%s$/d; s/^step/damping ratio 0.1\ndamping walls none\nstep/' pairs.md >walls-none.md
run 0 explain walls-none.md
out '  damping ratio 0.1, line '
grep -q '  damping walls' out && echo 'damping at walls that the page does not have' >>why
printf '```scene\nstart slowed stage one\nrecord time\nstage on\ncycles 1\n```\n' >from-slowed.md
run 0 explain from-slowed.md
out '  mass-proportional damping 2, line 2'
verdict 'explain'

# The clock alone ends all stages but `some`. So the lengths of the stages before `some` are known; after it only bounds are
# known.
cat >clock.md <<'END'
# Stages that end by the clock
```scene
units none
material m density 1 kn 1
step 0.25
disc 4 4 radius 1 m velocity 1 0
disc 99 4 radius 1 m
monitor D disc 1
record cycle
stage fall
until time above 2 every 3 cycles at most 100 cycles
stage on
step 0.5
until time above 5 at most 6 cycles
stage more
record none
until cycle above 20 and time above 0 at most 7 cycles
stage some
until D.x above 3 at most 10 cycles
stage last
until time above 30 at most 100 cycles
```
END
run 0 explain clock.md
out '  fall, 9 cycles'
out '  on, 6 cycles'
out '  more, 6 cycles'
out '  some, 1 to 10 cycles: the condition on line 19 decides'
out '  last, 34 to 43 cycles: the condition on line 21 decides'
out '  56 to 74 cycles, '
sed '/^stage last/,$s/time above 30/cycle above 60/' clock.md >number.md # `last` begins after 22 to 31 cycles
run 0 explain number.md
out '  last, 30 to 39 cycles: the condition on line 21 decides'
run 0 run clock.md
out '  65 cycles, 0 contact updates, '
out ' s; expected 56 to 74 cycles'
{ cat clock.md && printf '```expect\ncycle max below 1\n```\n'; } >failed.md # also after a check that failed
run 1 run failed.md
out ' s; expected 56 to 74 cycles'
sed 's/^units none/&\nsweep v 1 0.5/; s/velocity 1 0/velocity $v 0/' clock.md >twice.md # the sums of two runs
for jobs in 1 2; do
  run 0 run twice.md --jobs $jobs
  out '  130 cycles, 0 contact updates, '
  out ' s; expected 112 to 148 cycles'
done
run 0 explain twice.md
out '  112 to 148 cycles, 0 contact updates, '
sed 's/step 0.5/step 0.2 of stable/; s/^stage some/stage never/; s/D.x above 3/time above 1e9/' clock.md >never.md
run 0 explain never.md
out '  on, about 6 cycles'
out '  never, does not end: the condition on line 19 does not hold within 10 cycles'
sed '/^stage last/,$s/100 cycles/40 cycles/' clock.md >late.md # if `some` takes one cycle, 40 cycles are too few
run 0 explain late.md
out '  last, 34 to 40 cycles: the condition on line 21 decides'
sed '/^stage last/,$s/100 cycles/34 cycles/' clock.md >last.md # the condition holds at the last cycle of the stage
run 0 explain last.md
out '  last, 34 cycles'
sed '/^stage last/,$s/100 cycles/33 cycles/' clock.md >short.md
run 0 explain short.md
out '  last, does not end: the condition on line 21 does not hold within 33 cycles'
out '  55 to 64 cycles, ' # it counts with its 33 cycles
# The condition is also tested in the last cycle of a stage, even if this cycle is no multiple of N in `every N cycles`.
for row in '1.4 3 8=6' '1.9 3 8=8' '1.4 10 8=8' '1.4 8 8=8' '0.9 4 9=4' '2.1 3 9=9'; do
  set -- ${row%=*}
  sed "/^stage fall/,/^until/s/above 2 every 3 cycles at most 100/above $1 every $2 cycles at most $3/" clock.md >every.md
  run 0 explain every.md
  out "  fall, ${row#*=} cycles"
done
# Between the last cycle, 8, and the next multiple of 3 no condition is tested: 2.1 s is not reached.
sed '/^stage fall/,/^until/s/above 2 every 3 cycles at most 100/above 2.1 every 3 cycles at most 8/' clock.md >between.md
run 0 explain between.md
out '  fall, does not end: the condition on line 11 does not hold within 8 cycles'
# A condition that the clock fulfils from the start ends a stage at its first test; this is not evaluated.
sed '/^stage fall/,/^until/s/above 2/below 2/' clock.md >below.md
run 0 explain below.md
out '  fall, 3 to 100 cycles: the condition on line 11 decides'
sed '/^stage on/,/^until/s/time above 5/stage.time above 2/; /^stage last/,$s/time above 30/stage.time above 3/' clock.md >own.md
run 0 explain own.md
out '  on, 5 cycles'
out '  last, 7 cycles'
# The step of a later stage is known unless it depends on the state or on what earlier stages change.
sed 's/step 0.5/step 0.2 of single-contact/' clock.md >known.md
run 0 explain known.md
out '  on, 4 cycles'
sed 's/step 0.5/step 0.2 of single-contact\nmaterial m kn 1/' clock.md >same.md # a change of the stage itself
run 0 explain same.md
out '  on, 4 cycles'
# The step of the first stage is known, here 0.4 (pi/2)^(1/2), of which 6 exceed 2 s.
sed 's/^step 0.25/step 0.2 of stable/' clock.md >first.md
run 0 explain first.md
out '  fall, 6 cycles'
sed 's/step 0.5/step 8 per collision/' clock.md >collision.md
run 0 explain collision.md
out '  on, about '
for line in 'remove disc 2' 'material m kn 2'; do
  sed "s/^stage fall/&\\n$line/" known.md >about.md
  run 0 explain about.md
  out '  on, about '
done
# If the step of a stage is not known, the length of a later stage that ends by the clock is not known either, whatever step it
# has.
sed 's/step 0.5/step 0.2 of stable/; s/^until cycle above 20.*/step 0.25\nuntil time above 9 at most 70 cycles/' clock.md >behind.md
run 0 explain behind.md
out '  more, about '
out '  some, 1 to 10 cycles: ' # its condition does not read the clock
sed 's/time above 9 at most/time above 9 and D.x above 0 at most/' behind.md >both.md
run 0 explain both.md
out '  more, about '
sed 's/^stage fall/&\nmaterial m kn 2/; s/^until cycle above 20.*/step 0.2 of single-contact\nuntil time above 9 at most 70 cycles/' clock.md >changed.md
run 0 explain changed.md
out '  on, 6 cycles'
out '  more, about '
# Of several conditions the last one to hold ends the stage; one that reads more than the clock leaves bounds.
sed 's/cycle above 20 and time above 0/time above 0 and cycle above 20/' clock.md >order.md
run 0 explain order.md
out '  more, 6 cycles'
for conditions in 'D.x above 3 and cycle above 25' 'cycle above 25 and D.x above 3'; do
  sed "s/D.x above 3/$conditions/" clock.md >mixed.md
  run 0 explain mixed.md
  out '  some, 5 to 10 cycles: the condition on line 19 decides'
done
sed '/^stage some/,/^until/d; /^stage last/,/^until/d' clock.md >fixed.md
run 0 run fixed.md
out '  21 cycles, '
grep -q '; expected' out && echo 'a fixed number of cycles is compared' >>why
sed '/^stage fall/,/^until cycle/d; /^stage last/,/^until/d' clock.md >state.md # no condition reads the clock
run 0 run state.md
out ' s; expected 1 to 10 cycles'
# Pages of one cycle: the contact updates at the start of a run belong to no cycle.
for page in 6-lattices/lattice-stress 4-oblique/traction; do
  run 0 explain "$cases/$page.md"
  expected=$(sed -n 's/^  \([0-9]* [a-z]*, [^ ]* contact updates\), .* s$/\1/p' out | tail -n 1)
  run 0 run "$cases/$page.md" --jobs 1
  actual=$(sed -n 's/^  \([0-9]* [a-z]*, [^ ]* contact updates\), .* s$/\1/p' out)
  test -n "$expected" && test "$actual" = "$expected" || echo "$page: expected $expected, actual $actual" >>why
done
run 0 run "$cases/4-oblique/oblique-impact.md" # conditions on impact.time
cycles=$(sed -n 's/^\(  [0-9]* cycles\), .* s$/\1/p' out)
run 0 explain "$cases/4-oblique/oblique-impact.md"
out "${cycles:-no cycles}, "
run 0 explain "$pages/contact-test.md"
out ' steps, '
run 0 explain "$pages/too-long-a-step.md"
out 'the time of a cycle cannot be measured: particle 1 '
verdict 'explain: the number of cycles, contact updates and seconds; after a run what was expected'

# The reference accepts the features of the page, but not its numbers. Then `check` aborts, and `explain` says why.
cat >overdamped.md <<'END'
# A disc falls on a dashpot with twice the critical damping
```scene
units none
material m density 1 kn 1000
disc 0 1.5 radius 1 m
wall floor -9 0 to 9 0 m
gravity 0 -1
damping ratio 2
monitor D disc 1
step 0.001
record time D.y
stage fall
cycles 20
```
```expect
reference free_fall
D.y versus time within 1 %
```
END
cat >unloaded.md <<'END'
# A normal force that decreases
```contact-test
material  m young 70 GPa poisson 0.25 friction 0.3
normal    hertz
shear     mindlin_scaled
contact   sphere 1 mm m with sphere 1 mm m
record    step shear
segment   press  normal to 2 N  in 10 steps
segment   less   normal to 1 N  in 10 steps
segment   load   slip by 1 nm   in 10 steps
```
```expect
reference mindlin_loops
shear versus step within 1 % of peak
```
END
for page in 'overdamped less than critical damping' 'unloaded a normal force that is constant once there is shear'; do
  name=${page%% *}
  run 2 check "$name.md"
  said " is for ${page#* }"
  run 0 explain "$name.md"
  out ', measured just now; '
  out '  the run will be aborted, because its reference fails: the reference `'
  out " is for ${page#* }"
done
sed 's/damping ratio 2/damping ratio 0.2/' overdamped.md >underdamped.md
run 0 explain underdamped.md
grep -q 'reference fails' out && echo 'the reference does not fail' >>why
verdict 'explain: the error of a reference that does not cover the numbers of the page'

# Nine discs: 1/0.108 = 9.3 steps per collision; with a quarter of the step 37.
for steps in 8:1 32:4; do
  from=${steps%:*}
  run 0 explain "$cases/3-nine-discs/nine-discs.md" --set refine="${steps#*:}"
  row=$(grep "^| $from to $((2 * from)) | " "$cases/../docs/ACCURACY.md") || echo "no row for $from steps" >>why
  out "$(echo "$row" | awk -F ' *[|] *' '{ printf "with %s steps per collision, half of the %s errors in the cases were below %s, and 90 %% of them below %s (docs/ACCURACY.md)", $2, $3, $4, $5 }')"
done
run 0 explain "$pages/contact-test.md"
grep -q 'steps per collision' out && echo 'a contact test has no collision' >>why
verdict 'explain: the accuracy to expect of the step'

# A reference refuses a law without the stiffness that it needs.
run 2 check "$cases/4-oblique/grazing.md" --set law=mindlin --set 'theta=85 deg' --set normal=linear --set shear=linear
said 'the reference `rebound` is for a contact with friction'
verdict 'a contact without normal stiffness for the theory of an impact'

# ---- files of a run ----
run 0 run "$pages/passes.md"
out 'tables are in passes.out'
for file in table values verdict; do there passes.out/$file.tsv; done
test "$(column D.x/- passes.out/table.tsv | tail -n 1)" = 1.5 || echo 'D.x does not end at 1.5' >>why
test "$(column time/- passes.out/table.tsv | wc -l)" -eq 9 || echo 'not 9 rows' >>why
test "$(column verdict passes.out/verdict.tsv) $(column line passes.out/verdict.tsv)" = 'pass 19' || echo 'not the verdict and its line' >>why
column expected passes.out/verdict.tsv | grep -qx 'D.x expected 1.5 within 1e-15 .*' || echo 'not the expectation in verdict.tsv' >>why
column computed passes.out/verdict.tsv | grep -qx 'computed 1.5, .* tolerance 1e-15' || echo 'not its result in verdict.tsv' >>why
run 0 run "$pages/passes.md" -o one/two/three
there one/two/three/table.tsv
run 0 run "$cases/1-two-discs/free-fall.md" -o fall
grep -v '^#' fall/table.tsv | head -n 1 | cut -f 3- | tr '\t' ' ' >head
grep -qx 'stage time/s D.y/m D.vy/m/s C.overlap/m reference D.y/m reference D.vy/m/s' head || cat head >>why
sed 's/^record    time D.y D.vy C.overlap/record    D.vy C.overlap D.y time/' "$cases/1-two-discs/free-fall.md" >order.md
run 0 run order.md -o order
for name in D.y/m D.vy/m/s; do
  column "reference $name" fall/table.tsv >wanted
  column "$name" fall/table.tsv | paste - wanted | awk -v name="$name" '
    { error = ($1 - $2) ^ 2; most = error > most ? error : most; peak = $2 ^ 2 > peak ? $2 ^ 2 : peak }
    END { if (!(most <= 1e-4 * peak)) print name " is not within 1 % of its curve" }' >>why
  column "reference $name" order/table.tsv | cmp -s wanted - && test "$(sort -u wanted | wc -l)" -gt 9 || echo "another curve of $name" >>why
done
verdict 'tables in the default folder and in a new folder'

run 1 run "$pages/passes.md" -o set --set v=0.25
test "$(column D.x/- set/table.tsv | tail -n 1)" = 1.25 || echo '--set v=0.25 has no effect' >>why
run 1 run "$pages/passes.md" -o set --set v=1 --set v=0.25
test "$(column D.x/- set/table.tsv | tail -n 1)" = 1.25 || echo 'the last --set of a name has no effect' >>why
said 'warning: --set v=1 has no effect: --set v=0.25 follows it'
run 0 run "$pages/passes.md" -o set --set 'step=0.0625' --set v=1
test "$(column step/- set/table.tsv | tail -n 1)" = 0.0625 || echo '--set step has no effect' >>why
test "$(column D.x/- set/table.tsv | tail -n 1)" = 1.5 || echo 'two --set have no effect' >>why
grep -qx '# page passes, step=0.0625, v=1, FNV-1a [0-9a-f]*' set/table.tsv || echo 'the table lacks the settings' >>why
run 0 run "$pages/passes.md" -o other --set step=0.0625 --set v=1.0
sed -n 's/.*FNV-1a //p' passes.out/table.tsv set/table.tsv other/table.tsv | sort | uniq -d >>why
run 0 explain "$pages/same-bits.md" --set shear=none
out 'normal linear'
grep -q 'shear linear  ' out && echo '--set shear=none has no effect' >>why
run 2 explain "$pages/passes.md" --set shear=liner
said 'did you mean `linear`?'
run 2 run "$pages/passes.md" --set w=1
said '`w`'
verdict '--set: a value, the step, a law, an unknown name'

# ---- a path from a file ----
printf 'approach/um\tslip/m\tnote\n# out\n1\t0\ta\n\n1\t1e-7\tb\n2\t-1e-7\tc\n' >path.tsv
run 0 run "$pages/contact-test.md" -o path
quiet said # no note on checkpoints, which nobody asked for
out '1 of 1 checks passed'
test "$(column overlap/m path/table.tsv | tail -n 1)" = 3.0000000000000001e-06 || echo 'the segments of the page were not followed' >>why
there path/press-traction.tsv
there path/press-pieces.tsv
run 0 run "$pages/contact-test.md" --set follow=path.tsv -o path
test "$(column slip/m path/table.tsv | tr '\n' ' ')" = '0 0 9.9999999999999995e-08 -9.9999999999999995e-08 ' || echo 'the path was not followed' >>why
test "$(column overlap/m path/table.tsv | tail -n 1)" = 1.9999999999999999e-06 || echo 'the unit of the path was ignored' >>why
column stage path/table.tsv | grep -qv follow && echo 'a segment of the page is left' >>why
there path/follow-traction.tsv
there path/follow-pieces.tsv
{
  sed '/^segment/,$d' "$pages/contact-test.md"
  printf 'segment user follow path.tsv\nsegment on slip by 1 um in 1 step\n```\n```expect\nslip in user expected -0.1 um within 0 um [path.tsv]\n```\n'
} >own.md
run 0 check own.md
out '1 of 1 checks passed'
run 0 run own.md -o own
test "$(column slip/m own/table.tsv | tr '\n' ' ')" = '0 0 9.9999999999999995e-08 -9.9999999999999995e-08 8.9999999999999996e-07 ' || echo 'the segment did not follow its file' >>why
run 0 run "$pages/contact-test.md" --set follow=none.tsv --set follow=path.tsv -o path
run 0 explain "$pages/contact-test.md" --set follow=path.tsv
out ', read from a file'
run 2 check "$pages/contact-test.md" --set follow=path.tsv
out '`follow` replaces the segments of the page'
said 'no expectation of this page could fail'
printf 'approach/m\tslip/m\n1e-6\tnought\n' >path.tsv
run 2 run "$pages/contact-test.md" --set follow=path.tsv -o bad
said 'path.tsv:2:6: error: expected a number in the column `slip`, found `nought`'
absent bad
run 2 run "$pages/passes.md" --set follow=path.tsv
said 'expected a page with a contact test for `follow`'
verdict '--set follow: the contact of the page on another path, and invalid paths'

run 0 run "$pages/swept.md" -o swept
test "$(column v/- swept/table.tsv | sort -u | wc -l)" -eq 3 || echo 'no column v' >>why
run 0 run "$pages/swept.md" --set v=1 -o left
test "$(column v/- left/values.tsv)" = 1 || echo 'no column v with one value by --set' >>why
test "$(column D.x/- swept/table.tsv | wc -l)" -eq 27 || echo 'not 3 runs of 9 rows' >>why
run 2 check "$pages/swept.md" --set v=1
run 0 run "$pages/passes.md" -o again --set v=0.5
grep -v '^#' again/table.tsv >again.tsv
grep -v '^#' passes.out/table.tsv | cmp -s - again.tsv || echo 'the same value gives another table' >>why
verdict 'sweeps'

cat >several.md <<'END'
# Checks of each run come before those of all runs
```scene
sweep     v  1 m/s 2 m/s
sweep     h  1 us 2 us
material  m  density 1 g/cm3  kn 1 MN/m
disc      0 m 0 m  radius 10 mm  m  velocity $v 0 m/s
monitor   D  disc 1
step      $h
record    D.vx
stage     go
cycles    2
```
```expect
D.vx  increases with v
D.vx  expected 1.00100105 m/s within 0.1 % [error just above the tolerance]
```
END
run 1 check several.md
awk '/ D.vx increases/ { up = 1 } / D.vx expected/ && up { bad = 1 } END { exit bad || !up }' out || echo 'wrong order' >>why
out 'error 0.1000049 %, tolerance 0.1 %'
verdict 'checks of several runs follow those of each run; error and tolerance are printed with digits that differ'

# Each of three runs leaves its snapshots of two stages: the disc is where its speed has brought it in 1 and in 2 s.
sed 's/^cycles .*/cycles 8\nsnapshot\nstage further\ncycles 8\nsnapshot/' "$pages/swept.md" >snapped.md
run 0 run snapped.md -o snapped
ls snapped | grep -c particles >many
test "$(cat many)" = 6 || echo "$(cat many) tables of particles, wanted 6" >>why
for r in 1 2 3; do
  speed=$(echo "0.5 1 2" | cut -d ' ' -f $r)
  for stage in flight-1 further-2; do
    x=$(column x/- "snapped/${stage%-*}-particles-$r.tsv")
    test "$x" = "$(awk -v v="$speed" -v t="${stage#*-}" 'BEGIN { print 1 + v * t }')" || echo "$stage, run $r: x = $x" >>why
  done
done
# Two runs leave two tables of each stage, one run leaves one without a number.
for runs in 2 1; do
  speeds=$(echo "0.5 1" | cut -d ' ' -f 1-$runs)
  sed "s/^sweep .*/sweep v $speeds/" snapped.md >fewer.md
  run 0 run fewer.md -o "snapped$runs"
  ls "snapped$runs" | grep particles | tr '\n' ' ' >many
  case $runs in
  2) wanted='flight-particles-1.tsv flight-particles-2.tsv further-particles-1.tsv further-particles-2.tsv ' ;;
  1) wanted='flight-particles.tsv further-particles.tsv ' ;;
  esac
  test "$(cat many)" = "$wanted" || echo "$runs runs have the tables $(cat many)" >>why
done
verdict 'snapshots of a sweep'

# The lines of each segment are under the name of the segment. Hertz's law stores energy and dissipates none; the law of Mindlin and
# Deresiewicz does both.
sed 's/^  snapshot/&\nsegment  back  overlap to 0 um  in 3 steps/; /^```expect/,$d' "$pages/contact-test.md" >segments.md
run 0 explain segments.md
sed -n '/^segments/,/^cost/s/^    \(line [0-9]*\): \([a-z]* *[a-z]*\).*/\1 \2/p; s/^  \(press\|back\),.*/\1/p' out | tr '\n' ';' >given
test "$(cat given)" = 'press;line 8 segment press;line 9 snapshot;back;line 10 segment back;' || cat given >>why
sed -n '/^  normal hertz/{n;p;}' out | grep -q '; reports its stored energy$' || echo 'normal hertz' >>why
sed -n '/^  shear mindlin_deresiewicz/{n;p;}' out | grep -q '; reports its stored energy; reports its dissipation$' || echo 'the exact law' >>why
run 0 explain segments.md --set shear=mindlin
sed -n '/^  shear mindlin/{n;p;}' out | grep -q '; does not report stored energy; may create energy$' || echo 'shear mindlin' >>why
verdict 'explain: the laws and the statements of each segment'

run 0 check "$pages/sample.md"
out 'expected 3, within the range of 4 runs over seed: 2 to 5, mean 3.5, standard deviation 1.3; percentile 38'
out 'note  D.x expected 70 over seed [a number outside] (T=1, n=8)'
out 'note  D.x expected 3 over seed [a number within] (T=1, n=8)'
out 'pass  D.x increases with T over seed'
out 'from 1 to 2: mean difference +2.5, 95 % confidence 0.4457 to 4.554, mean 4.75'
out '2 of 2 checks passed, 6 noted'
run 0 check "$pages/sample.md" --tap
out 'ok 3 - D.x expected 0.5 of D.x max over seed [a fraction; it is 1 in all runs] (T=1, n=8) # SKIP noted, not checked'
run 1 check "$pages/sample.md" --set push=-2 # all differences are smaller by 3: the interval contains 0 and ends below 4.6
out 'FAIL  D.x increases with T over seed'
out 'from 1 to 2: mean difference -0.5, 95 % confidence -2.554 to 1.554'
run 1 check "$pages/sample.md" --set push=0.1
out 'FAIL  D.x constant with T over seed within 4.6'
run 2 check "$pages/sample.md" --set seed=1 # no sample is left
verdict 'samples: the range of an expected number, and differences with confidence intervals'

# ---- no expectation is lost ----
run 0 check "$pages/hidden.md"
out '2 of 2 checks passed'
out '6 expectations were not checked:'
out 'line 22: D.x expected 99 within 0 [in a quote]'
out 'line 27: D.x expected 98 within 0 [indented]'
out 'line 29: D.x above time'
out 'line 35: D.x expected 97 within 0 [in a list]'
out 'line 45: D.x constant with v within 0'
out '`w` has one value only, so there is nothing to compare'
run 0 check "$pages/hidden.md" --tap
out '1..8'
out 'ok 3 - D.x constant with v within 0 # SKIP `v` has one value only, so there is nothing to compare'
run 0 run "$pages/hidden.md" -o hidden
grep -q '^skip	45	' hidden/verdict.tsv || echo 'verdict.tsv does not have it' >>why
run 0 report "$pages/hidden.md" -o hidden
grep -q '<td class="skip">skip</td><td>D.x constant with v' hidden/hidden/index.html || echo 'the report does not have it' >>why
run 2 check "$pages/swept.md" --set v=1
out '1 expectation was not checked:'
said 'no expectation of this page could fail'
run 2 check --tap "$pages/swept.md" --set v=1
out 'not ok 2'
sed -n '/^D.x *expected.* over/!p' "$pages/sample.md" | grep -v '^D.x  *[ic]' >unasked.md
printf '```expect\nD.x expected 3 over seed [alone]\n```\n' >>unasked.md
run 2 check unasked.md
out ' noted'
said 'no expectation of this page could fail'
verdict 'expectations that are not checked are reported; a page with no others does not pass'

for jobs in 1 2 3; do
  run 0 run "$pages/swept.md" -o "jobs$jobs" --jobs $jobs
  grep -v '^#' "jobs$jobs/table.tsv" >"jobs$jobs.tsv"
done
cmp -s jobs1.tsv jobs2.tsv && cmp -s jobs1.tsv jobs3.tsv || echo 'parallel runs give another table' >>why
sed 's/^sweep.*/sweep v 0 0.01 0.02/; s/^cycles .*/until D.x above 1.02 at most 8 cycles/' "$pages/swept.md" >ends.md
run 3 check ends.md --jobs 2 # the first run never ends, the others end late
said 'D.x is 1 and should be above 1.02 (run v=0)'
run 2 check "$pages/swept.md" --jobs 0
said 'expected a number from 1 to 256 after --jobs, found `0`'
run 0 check "$pages/swept.md" --jobs 256
run 2 check "$pages/swept.md" --jobs 257
said 'expected a number from 1 to 256 after --jobs, found `257`'
verdict '--jobs: parallel runs, the same rows, and the first aborted run is reported'

# ---- failures of writing ----
: >file
run 2 run "$pages/passes.md" -o file/under
said 'cannot make the folder file/under: Not a directory'
run 2 run "$pages/passes.md" -o file
said 'cannot make the folder file'
verdict 'a folder that cannot be created'

sed 's/^stage .*/&\n  rotation off/' "$pages/../../cases/8-published/chung-ooi-6.md" >held.md
run 2 check held.md
said "held.md: error: the reference \`rebound\` does not cover \`rotation off\` (line $(sed -n '/^  rotation off/=' held.md)); it covers \`disc\`, \`sphere\`, "
verdict 'a feature that a reference does not cover is refused, with its line'

run 0 run "$pages/same-bits.md" -o kept
cp -r kept before
(
  trap '' XFSZ # a file above the limit is then an error like a full disk
  ulimit -f 8  # 4 KiB: enough for the beginning of a table and for a thread library
  "$nineball" run "$pages/same-bits.md" --set friction=0.1 -o kept 2>&1 >/dev/null
  echo "status $?"
) | cat >said
said 'cannot write kept/table.tsv'
said 'status 2'
diff -r before kept >>why
verdict 'a full disk: status 2, and the old tables stay'

if test -w /dev/full; then
  "$nineball" list >/dev/full 2>said
  test $? -eq 2 || echo 'the status is not 2' >>why
  said 'nineball: the output could not be written'
  "$nineball" check "$pages/passes.md" >/dev/full 2>said
  test $? -eq 2 || echo 'the status of check is not 2' >>why
  verdict 'standard output on a full disk: status 2'
else
  n=$((n + 1))
  echo "ok $n - standard output on a full disk # SKIP there is no /dev/full"
fi

{
  sleep 0.2
  trap '' PIPE
  "$nineball" list 2>said
  echo $? >status
} | :
test "$(cat status)" -eq 2 || echo "status $(cat status), wanted 2" >>why
said 'the output could not be written'
"$nineball" list >&- 2>said
test $? -eq 2 || echo 'closed standard output: the status is not 2' >>why
"$nineball" run "$pages/passes.md" -o closed >&- 2>said
test $? -eq 2 || echo 'closed standard output of run: the status is not 2' >>why
verdict 'a pipe without a reader, a closed standard output: status 2'

# ---- figures ----
path=$PATH
PATH=$work/nothing
run 2 figure "$pages/passes.md" -o drawn
PATH=$path
said 'gnuplot cannot be run'
said 'gnuplot-nox'
there drawn/passes.gp
verdict 'no gnuplot: the message names the package'

if command -v gnuplot >/dev/null; then
  mkdir -p tree/cases
  sed 's/^plot /eval canvas(300, 200)\n&/' "$pages/passes.md" >tree/cases/large.md
  run 0 figure tree/cases/large.md -o drawn --trust
  grep -q 'width="300" height="200"' drawn/large.svg || echo 'the figure is not as large as the page says' >>why
  head -c 4 drawn/large.png | grep -q PNG || echo 'large.png is not a PNG file' >>why
  grep -q 'rgb(221, 221, 221)\|#dddddd' drawn/large.svg || echo 'a page outside of the tree does not have the style' >>why
  verdict 'a figure of the size of the page, as SVG and PNG'

  sed "s|^plot .*|&\nprint 'a message'|" "$pages/passes.md" >tree/cases/says.md
  "$nineball" figure tree/cases/says.md -o drawn --trust >&- 2>&-
  there drawn/says.svg
  grep -q 'a message' drawn/says.svg && echo 'the message is in the figure' >>why
  verdict 'closed standard streams: messages are not written into a figure'

  # Of many messages the first 200 are shown, once for both drawings.
  sed 's|^plot .*|&\ndo for [i=1:300] { print i }|' "$pages/passes.md" >tree/cases/says.md
  run 0 figure tree/cases/says.md -o drawn --trust
  seq 200 | diff - said >>why
  # The reason of an error is the last message. Behind 200 messages the line of the page is not looked for.
  for count in 199 200; do
    sed "s|^plot .*|set xlabel 'x'\n\`\`\`\n\n\`\`\`gnuplot\ndo for [i=1:$count] { print i }\nplot \$nothing\nplot x|" "$pages/passes.md" >tree/cases/says.md
    run 2 figure tree/cases/says.md -o drawn --trust
    where=''
    test $count -eq 200 || where=' (line 28 of the page)'
    sed -n 's/ line [0-9]*: / line N: /; s/; the data are.*//; /^nineball/p' said |
      diff - /dev/fd/3 >>why 3<<END
nineball: gnuplot refused drawn/says.gp: "./says.gp" line N: no datablock named \$nothing$where
END
  done
  verdict 'the number of messages of a figure'

  sed "s|^plot .*|&, \$table using 'time/-':'D.y/-' with lines|" "$pages/passes.md" >tree/cases/lacks.md
  run 2 figure tree/cases/lacks.md -o lacks --trust
  said 'gnuplot refused lacks/lacks.gp: '
  said 'no column with header "D.y/-" (line 23 of the page)'
  said '; the name of a column ends with its unit, or with `/-`: `A.x/m`, `M.porosity/-`; the data are `$table`, with a sweep `$table_1`, `$table_2`, …: see `nineball --help gnuplot`; the columns of `$table` are `stage`, `time/-`, `D.x/-`, `step/-`'
  absent lacks/lacks.svg
  sed "s|^plot .*|&, \$values using 'D.y/m':'D.y/-'|" "$pages/passes.md" >tree/cases/lacks.md
  run 2 figure tree/cases/lacks.md -o lacks --trust
  said 'the columns of `$values` are `run`, `D.x/-`, `reference D.x/-`'
  # The first missing column is the reason, and the columns of a sweep are listed once.
  sed "s|^disc |sweep s 1 2\n&|; s|^plot .*|plot \$table_1 using 'D.y/-':'time/-', \$table_2 using 'time/-':'D.z/-'|" "$pages/passes.md" >tree/cases/lacks.md
  run 2 figure tree/cases/lacks.md -o lacks --trust
  grep -q '^nineball: gnuplot refused lacks/lacks.gp: .* no column with header "D.y/-" (line 24 of the page); the name' said || echo 'not the first column' >>why
  said 'the columns of `$table` are `stage`, `time/-`, `D.x/-`, `step/-`'
  grep -q 'step/-`, ' said && echo 'columns are listed twice' >>why
  verdict 'a figure with a missing column'
  sed "s|^plot .*|plot 'table.tsv'|" "$pages/passes.md" >tree/cases/lacks.md
  run 2 figure tree/cases/lacks.md -o lacks --trust
  said '; the data are `$table`, with a sweep `$table_1`, `$table_2`, …, and `$values`, one row for each run, whose columns have names: see `nineball --help gnuplot`'
  sed "s|^plot .*|plot \$nothing|" "$pages/passes.md" >tree/cases/lacks.md
  run 2 figure tree/cases/lacks.md -o lacks --trust
  said '; the data are `$table`'
  sed "s|^plot .*|plot x*undefined|" "$pages/passes.md" >tree/cases/lacks.md
  run 2 figure tree/cases/lacks.md -o lacks --trust
  said '; the data are `$table`'
  sed "s|^plot .*|plot \$table using 99:100|" "$pages/passes.md" >tree/cases/lacks.md
  run 2 figure tree/cases/lacks.md -o lacks --trust
  said ' range is invalid (line 23 of the page); the data are `$table`'
  sed "s|^plot .*|set titel 'x'|" "$pages/passes.md" >tree/cases/lacks.md
  run 2 figure tree/cases/lacks.md -o lacks --trust
  grep -q 'the data are' said && echo 'a mistake without data has the hint about data' >>why
  verdict 'a figure with data that gnuplot does not find'

  # A page that uses all variables of --help gnuplot.
  sed '/^```gnuplot/,/^```$/d; s/^stage  *strike/stage STAGE\n  snapshot/; s/ in strike//
    s/^sweep  *wall .*/let Estar = E\/(2*(1 - nu^2))/; s/^sweep  *h .*/let h = 0.04\nlet cycles = 20/; / order 2 in h /d' \
    "$cases/2-hertz/hertz-impact-wall.md" | sed 's/\$wall/steel/' >tree/cases/given.md
  names=$("$nineball" --help gnuplot | sed -n 's/^        \([^ :]*\): .*/\1/p')
  {
    echo '```gnuplot'
    for name in $names; do
      case $name in '$'*) echo "if (|$name| < 2) exit error '$name is empty'" ;; *) echo "print $name" ;; esac
    done
    printf 'plot x\n```\n'
  } >>tree/cases/given.md
  test "$(echo "$names" | wc -l)" -ge 8 || echo 'nineball --help gnuplot names less than it should' >>why
  run 0 figure tree/cases/given.md -o drawn --trust
  grep -q "^[$]table << EOD" drawn/given.gp || echo 'there are several runs' >>why
  verdict 'a page gets all variables of --help gnuplot'

  # The example of --help gnuplot, as it is printed.
  {
    printf '```scene\nmaterial m density 1 kg/m3 kn 100 N/m\nsweep v 1 m/s 2 m/s\ndisc 0 m 0 m radius 1 m m velocity $v 0 m/s\n'
    printf 'disc 2 m 0 m radius 1 m m\nmonitor C disc 1 with disc 2\nstep 0.1 of stable\nrecord time C.overlap C.normal\n'
    printf 'stage a\ncycles 10\n```\n\n```expect\nC.normal max expected 1 N within 100 N [a test]\n```\n\n```gnuplot\n'
    "$nineball" --help gnuplot | sed -n '/^ *set xlabel/,$p'
    echo '```'
  } >tree/cases/example.md
  run 0 figure tree/cases/example.md -o drawn --trust
  verdict 'the example of --help gnuplot is a valid script'

  # The names of the data blocks of a sweep end in numbers, even if --set leaves one value, so that the figure still works.
  {
    sed '/^```gnuplot/,/^```$/d; s/^let .*/sweep v 0.5 1/; s/^cycles .*/&\nsnapshot/' "$pages/passes.md"
    printf '```gnuplot\nprint "numbered:", D_x_1 > 0 && |$flight_particles_1| == 2 && !exists("D_x")\n'
    printf "plot for [i=1:runs] sprintf('\$table_%%d', i) using 'time/-':'D.x/-' with lines title run[i]\n\`\`\`\n"
  } >tree/cases/single.md
  run 0 figure tree/cases/single.md -o drawn --trust --set v=0.5
  said 'numbered: 1'
  verdict 'the figure of a sweep with a single run'

  # Names of 49 and of 50 characters; gnuplot keeps 49. The name may begin with `reference_` and end with the number of the run.
  long=$(printf 'm%046d' 0 | tr 0 x)
  {
    sed '/^```gnuplot/,/^```$/d' "$pages/passes.md" | sed "s/^monitor .* D .*/&\nmonitor $long disc 1\nmonitor x$long disc 1/" |
      sed "s/^record .*/& $long.x x$long.x/"
    printf '```expect\nreport %s.x\nreport x%s.x\n```\n```gnuplot\nplot x\n```\n' "$long" "$long"
  } >tree/cases/long.md
  run 0 figure tree/cases/long.md -o drawn --trust
  grep -q "^${long}_x = " drawn/long.gp || echo 'a name of 49 characters has no variable' >>why
  ! grep -q "^x${long}_x = " drawn/long.gp || echo 'a name of 50 characters has a variable' >>why
  long=$(printf 'm%029d' 0 | tr 0 x)
  {
    printf '```scene\nunits none\nsweep s 1 2\nmaterial m density 1 kn 1\ngrading g 1 1\n'
    printf 'fill discs circle 0 0 radius 9 g m seed $s attempts 9 else stop\nstep 1\n'
    for name in "" x xxxxxxxxxx xxxxxxxxxxx; do printf 'monitor %s grading g\nrecord %s.placed\n' $name$long $name$long; done
    printf 'stage s\ncycles 1\n```\n```expect\nreference filling\n'
    for name in "" x xxxxxxxxxx xxxxxxxxxxx; do echo "$name$long.placed within 0"; done
    printf '```\n```gnuplot\nplot x\n```\n'
  } >tree/cases/long.md
  run 0 figure tree/cases/long.md -o drawn --trust
  sed -n "s/${long}_placed/LONG/; s/^\([a-z_]*LONG_2 =\).*/\1/p" drawn/long.gp | sort | tr '\n' ' ' >variables
  test "$(cat variables)" = 'LONG_2 = reference_LONG_2 = xLONG_2 = xxxxxxxxxxLONG_2 = ' || cat variables >>why
  verdict 'variables with names that gnuplot would cut are left out'
fi

mkdir alone && cp "$nineball" alone/nineball
alone/nineball figure "$pages/passes.md" -o drawn >out 2>said
test $? -eq 2 || echo 'another status than 2' >>why
grep -q '^nineball: the style of figures, plots/style.gp, is neither beside the program nor in /.*/nineball/plots$' said || echo 'another message' >>why
verdict 'a program without the style of figures'

# The style is beside the program, or else in share/nineball. A quote in the name of its folder is doubled in the script.
mkdir -p "it's/bin" "it's/share/nineball"
cp "$nineball" "it's/bin/nineball"
for place in share/nineball bin; do
  cp -r "$cases/../plots" "it's/$place/plots"
  echo "# of $place" >>"it's/$place/plots/style.gp"
  PATH=$work/nothing "it's/bin/nineball" figure "$pages/passes.md" -o found >out 2>said
  grep -qx "plots = '/.*/it''s/$place/plots/'" found/passes.gp && grep -qx "# of $place" found/passes.gp || echo "not the style in $place" >>why
done
rm -r "it's/bin/plots" && mkdir -p "it's/bin/plots/style.gp"
run_in=$nineball nineball="it's/bin/nineball"
run 2 figure "$pages/passes.md" -o found
nineball=$run_in
grep -qx "nineball: cannot read /.*/it's/bin/plots/style.gp" said || echo 'a folder in the place of the style' >>why
verdict 'the places of the style of figures'

run 0 figure "$pages/swept.md" -o drawn
out 'has no `gnuplot` block'
run 0 run "$pages/passes.md" -o drawn
out 'to draw the figure: nineball figure '
run 0 run "$pages/swept.md" -o drawn
! grep 'to draw the figure' out >>why
verdict 'a page without a figure'

echo "1..$n"
