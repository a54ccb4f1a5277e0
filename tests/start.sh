#!/bin/sh
# Tests pages that start from a stage of another page. The results are those of an uninterrupted run, whether the state
# is computed or found. Processes that need the same state compute it once. It is computed again when the page has
# changed, and an incomplete state is never left. TAP.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
pages=$work/pages
mkdir "$pages"
states=$work/states
cp cases/3-nine-discs/nine-discs.md cases/5-numerics/saved-stage.md "$pages"

# rows FOLDER STAGE: prints cycles and forces of the stage.
rows() { awk -F '\t' -v stage="$2" '/^#/ { next } !head { for (k = 1; k <= NF; k++) at[$k] = k; head = 1; next }
  $(at["stage"]) == stage { print $(at["cycle/-"]), $(at["C.normal/-"]) }' "$1/table.tsv"; }
run() {
  folder=$work/$1
  shift
  "$nineball" run "$@" --states "$states" -o "$folder" >"$work/out" 2>"$work/said"
}
made() { grep -c 'where this page starts$' "$work/said"; }

"$nineball" explain "$pages/saved-stage.md" --states "$states" >"$work/said" &&
  grep -q 'nine-discs-load-[0-9a-f]*.state: missing, will be computed' "$work/said" &&
  grep -qF "nineball check $pages/saved-stage.md" "$work/said"
result $? 'explain says that the state will be computed'

run whole cases/3-nine-discs/nine-discs.md
run now "$pages/saved-stage.md" && test "$(made)" -eq 1
result $? 'the state is computed'
rows "$work/whole" oscillate >"$work/wanted"
rows "$work/now" rest | sed 1d | head -n 400 | diff - "$work/wanted" >"$work/said" && test "$(wc -l <"$work/wanted")" -eq 400
result $? 'the results are those of the uninterrupted run'
run found "$pages/saved-stage.md" && test "$(made)" -eq 0 && cmp "$work/now/table.tsv" "$work/found/table.tsv"
result $? 'the results with an existing state are the same'
"$nineball" explain "$pages/saved-stage.md" --states "$states" >"$work/said" && grep -q 'state: present$' "$work/said"
result $? 'explain says that the state is present'
(cd "$work" && unset NINEBALL_STATES && "$nineball" explain "$pages/saved-stage.md") >"$work/said" && grep -q 'state: present$' "$work/said" &&
  NINEBALL_STATES=$states "$nineball" explain "$pages/saved-stage.md" >"$work/said" && grep -q 'state: present$' "$work/said" &&
  NINEBALL_STATES=$states "$nineball" explain "$pages/saved-stage.md" --states "$work/none" >"$work/said" && grep -q 'state: missing' "$work/said"
result $? 'the folder of the states: by default, from the environment, and from the command line'
run threads "$pages/saved-stage.md" --threads 3 --isa plain && cmp "$work/now/table.tsv" "$work/threads/table.tsv"
result $? 'the results with other threads and another instruction set are the same'

# ---- contacts of fixed particles, the time of the first page ----

cat >"$pages/held.md" <<'END'
# Fixed discs
```scene
units   none
material  m  density 1 kn 1
wall    w  -9 -1 to 9 -1  m
disc    0 0 radius 1.1 m fixed spin 1
disc    2 0 radius 1 m fixed
disc    0 2 radius 1 m
monitor A  disc 1 with wall w
monitor B  disc 1 with disc 2
monitor C  disc 1 with disc 3
step    0.01
record  time A.normal B.normal C.normal
stage   whole
until   time above 0.015 at most 9 cycles
```
END
cat >"$pages/later.md" <<'END'
# A page whose condition is on the time of the first page
```scene
start   held stage whole
record  time
stage   on
until   time above 0.035 and stage.time above 0 at most 9 cycles
```
END
cat >"$pages/compressed.md" <<'END'
# A cell that becomes narrower
```scene
units   none
material m  density 1  kn 100
periodic cell    0 0 to 4 4
disc    2 2 radius 0.5 m
step    0.01
record  time
stage   press
cell    strain -0.1 0
cycles  100
```
END
cat >"$pages/sheared.md" <<'END'
# A strain since the start of the first page: 0.0952 of the compression, and the rest in this stage
```scene
start   compressed stage press
record  cell.strain.xx
stage   on
cell    strain -0.1 0
until   cell.strain.xx below -0.1 at most 90 cycles
```
```expect
cell.strain.xx  expected -0.1 within 0.002 [the condition]
cell.strain.xx min  below -0.09
cell.strain.xx min  below cell.strain.xx max
```
END
run sheared "$pages/sheared.md" && grep -qF 'sheared.md:7: warning: `cell.strain.xx` counts from the start of the first page; a small strain of this stage alone is its rate times `stage.time`' "$work/said" &&
  awk '!/^#/ { n++ } END { exit !(n > 2 && n < 20) }' "$work/sheared/table.tsv"
result $? 'a condition on the strain of a cell after `start` is warned of, and counts from the first page'
for line in 10 11; do echo "sheared.md:$line: warning: \`cell.strain.xx\` counts from the start of the first page; the strain of the particles since stage \`on\` is \`S.strain.xx\`, with \`region S all from on\`"; done >"$work/wanted"
grep 'sheared.md:[0-9]*: warning.*particles' "$work/said" | sed 's/.*sheared/sheared/' | diff - "$work/wanted" >&2
result $? 'expectations that compare the strain of a cell with a number after `start` are warned of'
cat >"$pages/pressed.md" <<'END'
# A box that becomes smaller
```scene
units   none
material m  density 1  kn 100
box     0 0 to 4 4  m
disc    2 2 radius 0.5 m
step    0.01
record  time
stage   press
box     strain -0.1 -0.1
cycles  10
```
END
cat >"$pages/squeezed.md" <<'END'
# Strains of a box since the start of the first page
```scene
start   pressed stage press
record  box.strain.width box.strain.height
stage   on
cycles  10
```
```expect
box.strain.width  below 0
box.strain.height  below 0
```
END
"$nineball" explain "$pages/squeezed.md" --states "$states" >"$work/said" 2>&1
grep -qF '`box.strain.width` counts from the start of the first page; the strain of the particles since stage `on` is `S.strain.xx`' "$work/said" &&
  grep -qF '`box.strain.height` counts from the start of the first page; the strain of the particles since stage `on` is `S.strain.yy`' "$work/said"
result $? 'expectations that compare the strain of a box with a number after `start` are warned of'
run held "$pages/held.md" && grep -qF 'held.md:9: warning: this contact has no force: a `fixed` particle has no contact with a wall' "$work/said" &&
  grep -qF 'held.md:10: warning: this contact has no force: a `fixed` particle has no contact with another fixed one' "$work/said" &&
  test "$(grep -c warning "$work/said")" -eq 2 &&
  awk -F '\t' '/^#/ { next } !head { for (k = 1; k <= NF; k++) at[$k] = k; head = 1; next }
    { a += $(at["A.normal/-"]) + $(at["B.normal/-"]); c += $(at["C.normal/-"]) } END { exit !(head && a == 0 && c > 0) }' "$work/held/table.tsv"
result $? 'a fixed particle has no force with a wall and with another fixed one, and the page is warned'
run later "$pages/later.md" && grep -qF 'later.md:6: warning: `time` counts from the start of the first page, `stage.time` from that of the stage' "$work/said" &&
  test "$(tail -n 1 "$work/later/table.tsv" | tr '\t' '\n' | grep -c '^0\.04')" -eq 1
result $? 'a condition on `time` after `start` is warned of, and counts from the first page'

# ---- quantities of removed particles ----

cat >"$pages/less.md" <<'END'
# A page that removes a disc
```scene
units   none
material  m  density 1 kn 1
disc    0 0 radius 1 m
disc    9 0 radius 1 m
step    0.01
stage   whole
cycles  2
stage   half
remove  disc 2
cycles  2
```
END
cat >"$pages/gate.md" <<'END'
# A page that removes a wall of its box
```scene
units   none
material  m  density 1 kn 1
box     0 0 to 9 9  m
disc    4 4 radius 1 m  velocity 2 0
step    0.01
stage   whole
cycles  2
stage   open
remove  wall east
cycles  2
```
END
cat >"$pages/beyond.md" <<'END'
# The disc leaves the box through the removed wall
```scene
start   gate stage open
monitor   A  disc 1
monitor   W  wall east
record  A.x A.vx W.fx box.stress.xx
stage   beyond
cycles  600
```
```expect
A.x   expected 16.08 within 1e-12 [4 + 2*6.04]
A.vx  expected 2 within 0 [no force]
```
END
run beyond "$pages/beyond.md"
grep -qF 'beyond.md:3: warning: `W.fx` is 0, because stage `open` of `gate` removes its wall' "$work/said" &&
  grep -qF 'beyond.md:3: warning: `box.stress.xx` is computed from stage `open` on as if wall `east` were still in its place, without forces on it: that stage removes it' "$work/said" &&
  grep -qF '2 of 2 checks passed' "$work/out"
result $? 'a wall that another page has removed is absent, and warnings name that page'
for line in 'wall    east velocity 1 0' 'remove  wall east' 'box strain 0 1'; do
  sed "s/^stage   beyond/&\n$line/" "$pages/beyond.md" >"$pages/again.md"
  "$nineball" explain "$pages/again.md" --states "$states" >"$work/said" 2>&1
  test $? -eq 2 && case $line in
    box*) grep -qF 'again.md:8:1: error: expected a box of four walls, found that line 3 has removed wall `east`' "$work/said" ;;
    *) grep -qF 'again.md:8:1: error: wall `east` is removed already, on line 3' "$work/said" ;;
  esac
  result $? "a page that starts from a removed wall refuses: $line"
done
cat >"$pages/none.md" <<'END'
# A page that starts with one disc and removes it
```scene
start   less stage half
monitor   A  disc 1
monitor   B  disc 2
record  A.vx B.vx
stage   none
remove  disc 1
cycles  2
```
END
run none "$pages/none.md"
grep -qF 'none.md:8: warning: `A.vx` is 0 in all stages, because this line removes its particle in the first one' "$work/said" &&
  grep -qF 'none.md:3: warning: `B.vx` is 0, because stage `half` of `less` removes its particle' "$work/said"
result $? 'a warning names the page that removes a particle'

# ---- chains ----

cat >"$pages/third.md" <<'END'
# From a page that starts from another
```scene
start   saved-stage stage rest
monitor   C  disc 5 with disc 6
record  cycle C.normal
stage   more
cycles  10
```
END
run third "$pages/third.md" && test "$(made)" -eq 1 && test "$(rows "$work/third" more | tail -n 1 | cut -d ' ' -f 1)" -eq 4050
result $? 'chains: a state is computed from an earlier state'
rm "$states"/*
run third-anew "$pages/third.md" && test "$(made)" -eq 2 && cmp "$work/third/table.tsv" "$work/third-anew/table.tsv"
result $? 'chains: both states are computed'
sed 's/^start .*/start third stage more/; s/stage   more/stage again/' "$pages/third.md" >"$pages/fourth.md"
named() { "$nineball" explain "$pages/fourth.md" --states "$states" | sed -n 's/.*\(third-more-[0-9a-f]*\).*/\1/p'; }
first=$(named)
cp "$pages/saved-stage.md" "$work/kept.md"
sed 's/^\( *cycles\) .*/\1 7/' "$work/kept.md" >"$pages/saved-stage.md"
second=$(named)
cp "$work/kept.md" "$pages/saved-stage.md"
echo "before: $first; after the change: $second" >"$work/said"
test -n "$second" && test "$first" != "$second" && test "$first" = "$(named)"
result $? 'chains: a state depends on the last stage of the page in the middle'
sed 's/^start .*/start fourth stage again/' "$pages/saved-stage.md" >"$pages/other.md"
mv "$pages/other.md" "$pages/saved-stage.md"
"$nineball" explain "$pages/third.md" --states "$states" >"$work/out" 2>"$work/said"
test $? -eq 2 && grep -q 'would start from itself' "$work/said"
result $? 'a circular chain is an error'
cp cases/5-numerics/saved-stage.md "$pages"

# A stage that changes the friction: `explain` says from which stage on.
sed 's/^start .*/&\nmaterial rock friction 0/; /^```expect/,/^```$/d' "$pages/saved-stage.md" >"$pages/smooth.md"
"$nineball" explain "$pages/smooth.md" --states "$states" >"$work/said" &&
  test "$(grep -c '^    from stage `rest` on (line [0-9]*): friction 0; no shear force without friction and cohesion$' "$work/said")" -eq 2
result $? 'explain says which stage changes the friction, for each pair of materials'

# plan PAGE: what `explain` prints except positions, contacts, step and seconds.
plan() {
  "$nineball" explain "$1" --states "$states" |
    sed -n 's/ *[0-9]* pairs* in the neighbour list//; /k_n\|bytes a \|^    [a-z(]\|^  [a-z]*, .*cycles/p' | grep -v '\.state: '
}
sed 's/^start .*/start smooth stage rest\nstep 0.05 of single-contact/; s/^stage .*/stage more/; s/^cycles .*/until time above 1e9 at most 9 cycles/; /^```expect/,/^```$/d' "$pages/saved-stage.md" >"$pages/smoother.md"
plan "$pages/smoother.md" | sed 's/ 1 to 9 cycles.*/ does not end: the condition on line 32 does not hold within 9 cycles/' >"$work/before"
"$nineball" explain "$pages/smoother.md" --states "$states" >"$work/out" && grep -q 'before stage `rest` of `smooth` is run' "$work/out" && grep -q '^  1 to 9 cycles$' "$work/out"
result $? 'explain shows the plan before the state exists, with bounds of the cycles'
step=$(sed -n '/^step$/{n;p}' "$work/out")
"$nineball" run "$pages/smoother.md" --states "$states" -o "$work/smoother" >"$work/out" 2>"$work/said"
plan "$pages/smoother.md" >"$work/after" && test "$(grep -c 'tan(phi) 0' "$work/after")" -eq 2 && diff "$work/before" "$work/after" >"$work/said" &&
  "$nineball" explain "$pages/smoother.md" --states "$states" | grep -q "^$step, line"
result $? 'explain shows the same plan when the state exists'

# The shortest collision of two discs of the mass 1 and the stiffness 1/2 lasts pi sqrt((1/2)/(1/2)) = pi, whatever the state is.
printf '```scene\nunits none\nmaterial m density (1/pi) kn 0.5\ndisc 0 0 radius 1 m\ndisc 9 0 radius 1 m\nstep 0.1\nrecord time\nstage a\ncycles 8\n```\n' >"$pages/lone.md"
printf '```scene\nunits none\nstart lone stage a\nstep 40 per collision\nrecord time\nstage b\ncycles 8\n```\n' >"$pages/collision.md"
"$nineball" explain "$pages/collision.md" --states "$states" >"$work/said" && sed -n '/^step$/{n;p}' "$work/said" | grep -qxF '  0.0785398'
result $? 'explain shows the step of a collision of linear springs before the state exists'
printf '```scene\nstart lone stage a\nrecord time\nstage b\ncycles 8\n```\n' >"$pages/kept.md"
"$nineball" explain "$pages/kept.md" --set refine=2 --states "$states" >"$work/said" 2>&1 && sed -n '/^step$/{n;p}' "$work/said" | grep -qxF '  0.05'
result $? '--set refine=2 halves a step in seconds that the page keeps from the other one'

# A page with `impact`, a second page that starts from it, and a third page that starts from the second; each runs with and without
# saved states.
cat >"$pages/hit.md" <<'EOF'
```scene
units none
material m density 1 young 1000 poisson 0.3
normal hertz
sphere 0 0 radius 1 m
sphere 0 2 radius 1 m fixed
monitor C sphere 1 with sphere 2
monitor D sphere 1
impact C speed 0.3 angle 0.4 phase 0.3
record impact.time
step 0.02
stage strike
until impact.time above 1.02 at most 100000 cycles
```
EOF
printf '```scene\nunits none\nstart hit stage strike\nmonitor D sphere 1\nrecord D.y\nstage away\ncycles 9\n```\n' >"$pages/away.md"
printf '```scene\nunits none\nstart away stage away\nmonitor D sphere 1\nrecord D.y\nstage farther\ncycles 9\n```\n' >"$pages/farther.md"
for page in away farther; do
  run "hit-$page" "$pages/$page.md" && test "$(made)" -eq 1 && run "again-$page" "$pages/$page.md" && test "$(made)" -eq 0 &&
    cmp "$work/hit-$page/table.tsv" "$work/again-$page/table.tsv" >>"$work/said" 2>&1 || break
done
test "$page" = farther && test -s "$work/again-$page/table.tsv"
result $? 'pages that start from one with an impact run again from its state'

# The balance of work begins with the state. The velocity of a disc that falls differs between t_N and half a step before.
printf '```scene\nunits none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\ngravity 0 -1\nstep 0.015625\nrecord time\nstage a\ncycles 8\n```\n' >"$pages/fell.md"
printf '```scene\nunits none\nstart fell stage a\nrecord work.balance\nstage b\ncycles 8\n```\n```expect\nwork.balance min expected 0 within 1e-12 [weight]\nwork.balance max expected 0 within 1e-12 [weight]\n```\n' >"$pages/falls.md"
"$nineball" check "$pages/falls.md" --states "$states" >"$work/said" 2>&1
result $? 'the balance of work of a page that starts from another one'
rm "$states"/*.state
run again "$pages/saved-stage.md"

# The state of a changed page is renamed to the expected name. The hash in the file still differs.
right=$(basename "$states"/nine-discs-load-*.state)
rm "$states/$right"
sed 's/^walls .*inward.*/&\nallow unstable/' cases/3-nine-discs/nine-discs.md >"$pages/nine-discs.md"
run other "$pages/saved-stage.md"
cp cases/3-nine-discs/nine-discs.md "$pages"
other=$(basename "$states"/nine-discs-load-*.state)
mv "$states/$other" "$states/$right"
run renamed "$pages/saved-stage.md"
test $? -eq 2 && test "$other" != "$right" && grep -q "$right:4:6: expected the hash that is in the name of the file: the file was renamed" "$work/said"
result $? 'a state with the name of another one is refused'

# The process that holds the lock may hang.
rm "$states"/*.state
: >"$states/$("$nineball" explain "$pages/saved-stage.md" --states "$states" | sed -n 's/.*\(nine-discs-load-[0-9a-f]*.state\).*/\1/p').lock"
flock "$states"/*.lock sleep 60 &
holder=$!
sleep 1
NINEBALL_WAIT=0.5 timeout 30 "$nineball" run "$pages/saved-stage.md" --states "$states" -o "$work/late" >"$work/out" 2>"$work/said"
test $? -eq 2 && grep -q 'an unknown process has held .*state.lock for 0.5 s: `fuser .*state.lock` names it' "$work/said"
result $? 'the wait for a lock is limited'
echo "$holder" >"$(echo "$states"/*.lock)"
NINEBALL_WAIT=0.5 timeout 30 "$nineball" run "$pages/saved-stage.md" --states "$states" -o "$work/late" >"$work/out" 2>"$work/said"
test $? -eq 2 && grep -q "process $holder has held .*state.lock for 0.5 s: \`ps -p $holder\` shows what this process does" "$work/said"
result $? 'the message names the process that wrote its number into the lock'
kill "$holder"
rm -f "$states"/*
run again "$pages/saved-stage.md"

# ---- loading ----

# in_two NAME: makes the pages NAME and NAME-on. The second one starts from stage `shear` of the first. Standard input
# has the text of both, with a line --- between them.
in_two() {
  cat >"$work/text"
  { sed '/^---$/d' "$work/text"; echo '```'; } >"$pages/$1.md"
  { sed -n '1,/^```scene/p' "$work/text"; echo "units none"; echo "start $1 stage shear"; grep '^region\|^monitor\|^record' "$work/text"; sed '1,/^---$/d' "$work/text"
    echo '```'; } >"$pages/$1-on.md"
  run "$1" "$pages/$1.md" && run "$1-on" "$pages/$1-on.md" && test "$(made)" -eq 1 &&
    grep '^on' "$work/$1/table.tsv" >"$work/wanted" && grep '^on' "$work/$1-on/table.tsv" | sed 1d | diff - "$work/wanted" >"$work/said" &&
    test "$(wc -l <"$work/wanted")" -eq 300
}
in_two ring <<'END'
# Spheres in a ring
```scene
units     none
material  m density 3 friction 0.3 young 50000 poisson 0.2
normal    hertz
shear     mindlin
grading   g  0.9 8  0.7 25  0.5 30
fill   spheres circle 0.1 0.2 radius 7 g m seed 1 attempts 100000 else skip
boundary  circle 0.1 0.2 radius 6.3
region    A inside 0.9
monitor     G grading g
monitor     H grading g radius 0.5
record    time A.stress.xx A.stress.yy boundary.radius boundary.stress.mean G.attempts H.placed
step      0.001
stage     shear
  boundary  strain -4e-5 per cycle -5e-5 per cycle
  affine strain -4e-5 per cycle -5e-5 per cycle
  servo     mean 20 on A through boundary affine at most 1e-5 per cycle
  rotation  off
  cycles    2000
---
stage     on
  gravity   centripetal 1 about 0 0
  step      0.0007
  cycles    300
END
result $? 'a boundary with affine motion, after a servo'
in_two cell <<'END'
# Spheres in a cell
```scene
units     none
material  m density 3 friction 0.3 young 50000 poisson 0.2
normal    hertz
shear     mindlin
periodic cell      0 0 to 8 8
lattice   spheres 4 by 4 m radius 1 spacing 2 from 1 1
region    A all
record    time A.stress.xx A.stress.yy cell.xx cell.strain.volumetric
step      0.001
stage     shear
  cell      strain -4e-5 per cycle -5e-5 per cycle c12 1e-5 per cycle c21 0 per cycle
  cycles    500
---
stage     on
  step      0.0007
  cycles    300
END
result $? 'a cell'
in_two unstable <<'END'
# A step above the stable one, which the first page allows
```scene
units     none
material  m density 1 kn 4
allow     unstable
disc      0 0 radius 1 m fixed
disc      1.9 0 radius 1 m
monitor   D  disc 2
record    time D.x
step      1.2 of stable
stage     shear
  cycles  3
---
stage     on
  cycles  300
END
result $? 'an unstable step, which the first page allows'
in_two stable <<'END'
# A stable step, for which two discs count that are listed and have moved apart by more than the skin
```scene
units     none
material  m density 1 kn 4
disc      -0.02 0 radius 1 m velocity -0.01 0
disc      2.075 0 radius 1 m
disc      4.17 0 radius 1 m velocity -0.002 0
monitor   D  disc 1
monitor   E  disc 2 with disc 3
record    time step D.x E.overlap
step      0.2 of stable
stage     shear
  cycles  20
---
stage     on
  cycles  300
END
result $? 'a step in units of the stable step'
in_two box <<'END'
# Spheres between walls that follow a servo, and rest afterwards
```scene
units     none
material  m density 3 friction 0.3 young 50000 poisson 0.2
normal    hertz
shear     mindlin
box       0 0 to 8 8 m
lattice   spheres 4 by 4 m radius 1 spacing 2 from 1 1
region    A all
record    time A.stress.xx A.stress.yy box.width box.stress.yy
step      0.001
stage     shear
  servo     xx 20 yy 10 on box through box at most 1e-5 per cycle
  cycles    500
---
stage     on
  step      0.0007
  cycles    300
END
result $? 'walls after a servo'

in_two moved <<'END'
# Discs about an origin that `transform` has moved
```scene
units     none
material  m density 3 kn 100
disc      3 1 radius 1 m
disc      -2 4 radius 1 m
transform translate 0.5 0.25
monitor   D disc 1
monitor   E disc 2
record    time D.x D.y E.x E.y
step      0.001
stage     shear
  cycles    5
---
stage     on
  affine    strain 1e-3 2e-3
  cycles    300
END
result $? 'affine motion about an origin that the other page has moved'

# Values by --set have the units of the other page, if this page does not state units.
printf '```scene\nstart hit stage strike\nlet y = 2\nmonitor D sphere 1\nrecord time D.y\nstage away\ncycles 3\n```\n' >"$pages/bare.md"
run bare "$pages/bare.md" --set y=0.5
"$nineball" run "$pages/bare.md" --set 'y=0.5 m' --states "$states" -o "$work/none" >"$work/out" 2>>"$work/said"
test $? -eq 2 && test -s "$work/bare/table.tsv" && grep -q '^--set: error: expected a unit or an operator, found `m`' "$work/said"
result $? 'a value of a page without `units` that starts from one with `units none`'

# A step that `with` sets is the step of the other page, not of the stages of this page.
sed 's/^start .*/start hit stage strike with step=0.01/' "$pages/bare.md" >"$pages/finer.md"
run finer "$pages/finer.md"
"$nineball" explain "$pages/finer.md" --states "$states" >>"$work/said" && grep -q '^  0.01, line 2$' "$work/said"
result $? 'explain names the line of a step that the other page got by `with`'

# A state has the same bytes whether `nineball state` writes it or a run of a page that starts from it.
cat >"$pages/pair.md" <<'END'
# A disc and two stages
```scene
units   none
material  m  density 1 kn 1
let     v = 1
let     w = 0
disc    0 0 radius 1 m velocity $v $w
step    0.01
record  time
stage   one
cycles  2
stage   two
cycles  3
```
END
: >"$work/differing"
for call in 'one' 'two' 'two with v=3 w=2:--set v=3 --set w=2'; do
  stage=${call%% *}
  printf '# Goes on\n```scene\nstart pair stage %s\nrecord time\nstage on\ncycles 1\nstage after\ncycles 1\n```\n' "${call%%:*}" >"$pages/goes-on.md"
  rm -f "$states"/pair-*
  run goes-on "$pages/goes-on.md" && "$nineball" state "$pages/pair.md" $(expr "$call" : '.*:\(.*\)') --stage "$stage" -o "$work/$stage.state" >"$work/said" 2>&1 &&
    diff "$states"/pair-"$stage"-*.state "$work/$stage.state" >>"$work/differing" || echo "stage $call" >>"$work/differing"
done
cp "$work/differing" "$work/said" && test ! -s "$work/differing"
result $? 'a state written by command is that of a page that starts from this stage'
# The command takes the stages of the page itself. A name is also found after stages of the other page, and the last stage is the default.
"$nineball" state "$pages/goes-on.md" --states "$states" --stage one -o "$work/none.state" >"$work/said" 2>&1
test $? -eq 2 && grep -qF 'goes-on.md has no stage `one` of its own' "$work/said" && test ! -e "$work/none.state" &&
  "$nineball" state "$pages/goes-on.md" --states "$states" --stage on -o "$work/on.state" >"$work/said" 2>&1 &&
  grep -qF "the state at the end of stage \`on\` is in $work/on.state" "$work/said" &&
  "$nineball" state "$pages/goes-on.md" --states "$states" -o "$work/after.state" >"$work/said" 2>&1 && grep -qF "end of stage \`after\` is" "$work/said"
result $? 'the stages of a page that starts from another one'

# ---- the page has changed ----

sed 's/^walls     inward 0.12/walls     inward 0.11/' cases/3-nine-discs/nine-discs.md >"$pages/nine-discs.md"
"$nineball" explain "$pages/saved-stage.md" --states "$states" >"$work/said" && grep -q 'out of date, will be computed again' "$work/said"
result $? 'the state of a changed page is out of date'
old=$(ls "$states"/nine-discs-load-*.state)
alike=$states/nine-disks-load-${old##*-}
cp "$old" "$alike" && cp "$old" "$old.kept"
run changed "$pages/saved-stage.md"
test "$(made)" -eq 1 && ! cmp -s "$work/now/table.tsv" "$work/changed/table.tsv" &&
  test "$(ls "$states" | grep -c '^nine-discs-load-.*state$')" -eq 1
result $? 'the state of a changed page is computed again, and the old state is removed'
cmp "$alike" "$old.kept" >>"$work/said" 2>&1
result $? 'the state of another page, and a file that is not a state, are not removed'
rm -f "$alike" "$old.kept"
cp cases/3-nine-discs/nine-discs.md "$pages"
run back "$pages/saved-stage.md" && test "$(made)" -eq 1 &&
  sed 's/^walls     inward 0.12/walls     inward 0.12   # as ever/; s/^cycles    4000/cycles    7/; s/^record .*/record time/' \
    cases/3-nine-discs/nine-discs.md >"$pages/nine-discs.md" &&
  run again "$pages/saved-stage.md" && test "$(made)" -eq 0
result $? 'records, comments and later stages do not change the state'

# ---- sweeps, and several at once ----

cat >"$pages/sweep.md" <<'END'
# Parallel runs, two of which need the same state
```scene
sweep   ks 1.35e9 0.9e9
sweep   n  5 7
start   nine-discs stage load  with ks=$ks
monitor   C  disc 5 with disc 6
record  cycle C.normal
stage   rest
walls   stop
cycles  $n
```
END
rm "$states"/*
run sweep "$pages/sweep.md" --jobs 4
test "$(made)" -eq 0 && test "$(grep -c 'where this page starts, run' "$work/said")" -eq 2 && test "$(ls "$states" | wc -l)" -eq 2
result $? 'the runs of a sweep compute each state once'

# Several names in one sweep: the value of one name selects the values of the others.
cat >"$pages/turns.md" <<'END'
# Two turns of two names
```scene
units     none
sweep     x with v  1 0.25  2 0.5
sweep     n  4 8
material  m density 3 kn 100
disc      $x 0 radius 1 m velocity $v 0
monitor     D disc 1
record    D.x
step      0.125
stage     go
  cycles  $n
```
END
cat >"$pages/turn.md" <<'END'
# From one of them
```scene
sweep     x 2 1
start     turns stage go with x=$x with n=8
monitor     D disc 1
record    D.x
stage     more
  cycles  8
```
END
run turn "$pages/turn.md" && test "$(cut -f 3 "$work/turn/table.tsv" | tail -n 1)" = 1.5 && grep -q '^2	more	3$' "$work/turn/table.tsv"
result $? 'one of several names in a sweep selects the values of the others'
run turns "$pages/turns.md" --set v=0.5 --set x=7 --set n=4 && test "$(tail -n 1 "$work/turns/table.tsv")" = '7	0.5	4	go	7.25'
result $? 'a value that is not in the sweep replaces only its own name'

# A state belongs to its settings: the states of a page with no, one and two settings are three files that stay.
cat >"$pages/counted.md" <<'END'
# Two values
```scene
units     none
let       n = 3
let       v = 2
material  m density 3 kn 100
disc      0 0 radius 1 m velocity $v 0
step      0.125
stage     go
  cycles  $n
```
END
# from FILE SETTINGS: writes the page FILE, which starts from `counted` with the settings.
from() { printf '# From\n```scene\nstart counted stage go %s\nmonitor D disc 1\nrecord cycle D.vx\nstage more\n  cycles 1\n  snapshot from more\n```\n' "$2" >"$pages/$1.md"; }
from with-1 ''
from with-2 'with n=5'
from with-3 'with n=5 with v=7'
settings_stay() {
  said=
  for k in 1 2 3 2 1; do
    run "with-$k" "$pages/with-$k.md" && said="$said $(made) $(tail -n 1 "$work/with-$k/table.tsv" | cut -f 2,3 | tr '\t' :)" || return 1
  done
  test "$said" = ' 1 4:2 1 6:2 1 6:7 0 6:2 0 4:2' && test "$(ls "$states" | grep -c '^counted-go-')" -eq 3
}
settings_stay
result $? 'states with other settings are not out of date'
sed 's/^  cycles  .n/&\n  snapshot\n  record every 2 cycles/' "$pages/counted.md" >"$work/t" && mv "$work/t" "$pages/counted.md"
run with-1 "$pages/with-1.md" && test "$(made)" -eq 0 && test "$(ls "$states" | grep -c '^counted-go-')" -eq 3
result $? 'snapshots do not change the state'
cp "$(ls "$states"/counted-go-*.state | head -n 1)" "$states/counted-go-kept-as-a-backup.state" # as long as a hash
sed 's/radius 1 m/radius 2 m/' "$pages/counted.md" >"$work/t" && mv "$work/t" "$pages/counted.md"
for k in 1 2 3; do run "with-$k" "$pages/with-$k.md" || break; done && test -s "$states/counted-go-kept-as-a-backup.state" &&
  test "$(ls "$states" | grep -c '^counted-go-')" -eq 4
result $? 'only files with the name of a state are removed'

# Damping, step, gravity and properties of the last stage hold in the page that starts from it.
cat >"$pages/changed.md" <<'END'
# What stages change
```scene
units     none
material  m density 3 kn 100 ks 80 friction 0.5
disc      0 0 radius 1 m velocity 2 0.5 spin 1
disc      2.1 0 radius 1 m
monitor   D disc 1
record    cycle D.x D.vx D.vy D.spin
step      0.125
stage     first
  cycles  3
stage     go
  damping mass 0.8
  damping ratio 0.2
  step    0.0625
  gravity 0 -1
  shear   linear
  material m kn 50
  cycles  9
stage     more
  cycles  20
```
END
printf '# On\n```scene\nstart changed stage go\nmonitor D disc 1\nrecord cycle D.x D.vx D.vy D.spin\nstage more\n  cycles 20\n```\n' >"$pages/on.md"
run whole "$pages/changed.md" && run on "$pages/on.md" && grep '^more' "$work/whole/table.tsv" >"$work/wanted" &&
  grep '^more' "$work/on/table.tsv" | tail -n 20 | diff "$work/wanted" - >>"$work/said" && test "$(wc -l <"$work/wanted")" -eq 20
result $? 'what stages have changed holds in the page that starts from them'
"$nineball" explain "$pages/on.md" --states "$states" >"$work/said" && grep -q '^  mass-proportional damping 0.8, line ' "$work/said" &&
  grep -q '^  damping ratio 0.2, line ' "$work/said"
result $? 'explain shows the damping of the stage from which the page starts'

# A state that takes some time to compute.
sed 's/^cycles    40$/cycles    800000/; s/inward 0.12/inward 1e-5/; s/^record .*/record time/; s/^stage     load/&\nrecord none/' cases/3-nine-discs/nine-discs.md >"$pages/nine-discs.md"
sed 's/^cycles    4000/cycles    10/; /^```expect/,/^```$/d' cases/5-numerics/saved-stage.md >"$pages/saved-stage.md"
rm "$states"/*
for k in 1 2 3; do
  "$nineball" run "$pages/saved-stage.md" --states "$states" -o "$work/at-once-$k" >"$work/out-$k" 2>"$work/said-$k" &
done
wait
cat "$work"/said-[123] >"$work/said"
test "$(made)" -eq 1 && test "$(grep -c 'note: waiting for process [0-9]*, which writes' "$work/said")" -ge 1 &&
  cmp "$work/at-once-1/table.tsv" "$work/at-once-2/table.tsv" && cmp "$work/at-once-1/table.tsv" "$work/at-once-3/table.tsv" &&
  test "$(ls "$states" | wc -l)" -eq 1
result $? 'three processes: one computes the state, the others wait'

rm "$states"/*
"$nineball" run "$pages/saved-stage.md" --states "$states" -o "$work/killed" >"$work/out" 2>"$work/said" &
maker=$!
while kill -0 $maker 2>/dev/null && ! ls "$states"/*.lock >/dev/null 2>&1; do sleep 0.01; done
kill -9 $maker
wait $maker 2>/dev/null
test -z "$(ls "$states" | grep '\.state$')"
result $? 'a killed process leaves no state'
touch "$states/$(basename "$(ls "$states"/*.lock)" .lock).12345.new" # a temporary file that the process could have left
run after-kill "$pages/saved-stage.md" && test "$(made)" -eq 1 && ! grep -q waits "$work/said" &&
  cmp "$work/after-kill/table.tsv" "$work/at-once-1/table.tsv" && test "$(ls "$states" | wc -l)" -eq 1
result $? 'no process waits for a killed one'

# ---- damaged states and failures of writing ----

state=$(ls "$states"/*.state)
sed 's/^body 3 disc/body 3 sphere/' "$state" >"$work/damaged.state" && cp "$work/damaged.state" "$state"
run damaged "$pages/saved-stage.md"
test $? -eq 2 && grep -q 'expected the checksum of the lines above, found another one: the file has been changed' "$work/said"
result $? 'a damaged state is not used'
"$nineball" explain "$pages/saved-stage.md" --states "$states" >"$work/out" 2>"$work/said"
test $? -eq 2 && grep -q 'expected the checksum of the lines above, found another one' "$work/said"
result $? 'explain says that a state is damaged'
rm "$states"/*
(ulimit -f 8 && trap '' XFSZ && run full "$pages/saved-stage.md")
test $? -eq 2 && grep -q 'cannot write .*state' "$work/said" && test -z "$(ls "$states")"
result $? 'a full disk: an error, and no file is left'
"$nineball" run "$pages/saved-stage.md" --states /dev/null/states -o "$work/none" >"$work/out" 2>"$work/said"
test $? -eq 2 && grep -q 'cannot make the folder' "$work/said"
result $? 'no folder: an error'
"$nineball" run "$pages/saved-stage.md" --states "$(awk 'BEGIN { for (k = 0; k < 500; k++) printf "/long-name" }')" -o "$work/none" >"$work/out" 2>"$work/said"
test $? -eq 2 && grep -q 'the name of the folder is too long: /long-name/' "$work/said"
result $? 'the name of the folder is too long: an error'

# ---- pages found by name ----

# base CYCLES: prints a small page with a stage `go` of one disc. on NAME: prints a page that starts from it.
base() { printf '# Base\n```scene\nunits none\nmaterial m density 1 kn 100\ndisc 0 0 radius 1 m\nstep 0.1\nrecord time\nstage go\n  cycles %d\n```\n' "$1"; }
on() { printf '# On\n```scene\nstart %s stage go\nrecord cycle\nstage more\n  cycles 1\n```\n' "$1"; }
base 3 >"$work/base.md" && on base >"$work/on.md"
"$nineball" run "$work/on.md" --states "$work/bare" --set step=0.0625 -o "$work/bare-step" >"$work/out" 2>"$work/said" &&
  grep -q '^more	4$' "$work/bare-step/table.tsv" &&
  ! "$nineball" run "$work/on.md" --states "$work/bare" --set step='0.0625 s' -o "$work/bare-step" >"$work/out" 2>"$work/said" &&
  grep -q 'expected a time as a number without a unit (the scene says `units none`), found `0.0625 s`' "$work/said" &&
  sed 's/^record.*/record time/' "$work/on.md" >"$work/on-time.md" &&
  "$nineball" run "$work/on-time.md" --states "$work/bare" --set step=0.0625 -o "$work/bare-step" >"$work/out" 2>"$work/said" &&
  awk '$1 == "more" { last = $2 } END { exit !(last > 0.3624 && last < 0.3626) }' "$work/bare-step/table.tsv"
result $? '--set step of a page without `units` that starts from one with `units none`: a number without a unit'
root=$work/root
mkdir -p "$root/cases/1-one/deeper" "$root/cases/2-two" "$root/cases/3-three/cases/inner" "$root/other" "$root/outside"
base 3 >"$root/cases/1-one/deeper/far.md"
base 4 >"$root/cases/1-one/both.md"
base 5 >"$root/cases/2-two/both.md"
base 6 >"$root/cases/1-one/twice.md"
cp "$root/cases/1-one/twice.md" "$root/cases/1-one/deeper/twice.md"
cp "$root/cases/1-one/twice.md" "$root/cases/3-three"
base 7 >"$root/outside/linked.md"
mkdir "$root/cases/.kept" && base 8 >"$root/cases/.kept/hidden.md"
ln -s .. "$root/cases/1-one/up"
ln -s ../../outside "$root/cases/1-one/out"
ln -s ../../outside/linked.md "$root/cases/1-one/alias.md"
base 9 >"$root/cases/3-three/cases/inner/near.md"
# cycle_of PAGE: runs the page and prints its last cycle.
cycle_of() {
  "$nineball" run "$@" --states "$states" -o "$work/found" >"$work/out" 2>"$work/said" && tail -n 1 "$work/found/table.tsv" | cut -f 2
}
# no PAGE TEXT: the page is refused with status 2 and a message that contains the text.
no() {
  "$nineball" explain "$1" >"$work/out" 2>"$work/said"
  test $? -eq 2 && grep -qF -e "$2" "$work/said"
}

on both >"$root/cases/2-two/page.md"
test "$(cycle_of "$root/cases/2-two/page.md")" = 6
result $? 'a page in the same folder is found first'
on far >"$root/cases/2-two/page.md"
test "$(cycle_of "$root/cases/2-two/page.md")" = 4
result $? 'otherwise a page in any folder below `cases` is found'
(cd "$root/cases/2-two" && test "$(cycle_of page.md)" = 4) && (cd "$root/cases" && test "$(cycle_of ./2-two/page.md)" = 4) &&
  (cd "$root/outside" && test "$(cycle_of ../cases/1-one/../2-two/page.md)" = 4) && (cd "$root" && test "$(cycle_of cases/2-two/page.md)" = 4)
result $? 'a page is found from any working folder'
on deeper/far.md >"$root/cases/2-two/page.md"
test "$(cycle_of "$root/cases/2-two/page.md")" = 4
result $? 'a page is found by its name with a folder'
on twice >"$root/cases/2-two/page.md"
no "$root/cases/2-two/page.md" "page.md:3:7: error: expected one file of this name, found \`$root/cases/1-one/deeper/twice.md\` and \`$root/cases/1-one/twice.md\`"
result $? 'an ambiguous name is an error that names both files'
# The search finds a file of a folder before those of its folders: here in the order 1, 3, 2 of the alphabet.
mkdir -p "$root/cases/4-four/d/a"
for folder in . d d/a; do cp "$root/cases/1-one/twice.md" "$root/cases/4-four/$folder/chain.md"; done
on chain >"$root/cases/2-two/page.md"
no "$root/cases/2-two/page.md" "page.md:3:7: error: expected one file of this name, found \`$root/cases/4-four/chain.md\` and \`$root/cases/4-four/d/a/chain.md\`"
result $? 'of three files with this name it names the first two in alphabetical order'
on 1-one/twice >"$root/cases/2-two/page.md" && test "$(cycle_of "$root/cases/2-two/page.md")" = 7 &&
  on ../1-one/twice >"$root/cases/2-two/page.md" && test "$(cycle_of "$root/cases/2-two/page.md")" = 7
result $? 'a name with its folder is not ambiguous'
missed=
for name in linked hidden alias ../2-two/far 1-one/../1-one/both nowhere; do
  on $name >"$root/cases/2-two/page.md"
  no "$root/cases/2-two/page.md" "cases/2-two/$name.md: error: cannot be read: No such file" || missed="$missed $name"
done
echo "$missed" >"$work/said"
test -z "$missed"
result $? 'links are not followed, hidden folders are not searched'
on far >"$root/cases/3-three/cases/page.md" && no "$root/cases/3-three/cases/page.md" 'cases/3-three/cases/far.md: error: cannot be read' &&
  on near >"$root/cases/3-three/cases/page.md" && test "$(cycle_of "$root/cases/3-three/cases/page.md")" = 10
result $? 'only the nearest folder `cases` is searched'
on far >"$root/other/page.md" && no "$root/other/page.md" 'other/far.md: error: cannot be read' &&
  no "$root/cases/../other/page.md" 'other/far.md: error: cannot be read' &&
  mkdir "$root/casesnot" "$root/notcases" && cp "$root/other/page.md" "$root/casesnot" && cp "$root/other/page.md" "$root/notcases" &&
  mkdir -p "$root/casesnot/b" "$root/notcases/b" &&
  cp "$root/cases/1-one/deeper/far.md" "$root/casesnot/b" && cp "$root/cases/1-one/deeper/far.md" "$root/notcases/b" &&
  no "$root/casesnot/page.md" 'cannot be read' && no "$root/notcases/page.md" 'cannot be read'
result $? 'outside of `cases` only the same folder is searched'
deep=$root/cases/2-two/3/4/5/6/7/8/9
mkdir -p "$deep/10" && base 3 >"$deep/end.md" && base 3 >"$deep/10/over.md" && on end >"$root/cases/1-one/page.md" &&
  test "$(cycle_of "$root/cases/1-one/page.md")" = 4 && on over >"$root/cases/1-one/page.md" && no "$root/cases/1-one/page.md" 'cannot be read'
result $? 'the search is eight folders deep'
printf 'x/m\ty/m\tradius/m\n0\t0\t1\n' >"$root/cases/1-one/deeper/list.tsv"
printf '# P\n```scene\nunits none\nmaterial m density 1 kn 100\npacking deeper/list.tsv discs m\nstep 0.1\nrecord cycle\nstage more\n cycles 3\n```\n' >"$root/cases/2-two/packed.md"
sed 's/deeper.list/list/' "$root/cases/2-two/packed.md" >"$root/cases/2-two/also.md"
sed -i 's/x.m/x\/-/; s/y.m/y\/-/; s/us.m/us\/-/' "$root/cases/1-one/deeper/list.tsv"
test "$(cycle_of "$root/cases/2-two/packed.md")" = 3 && test "$(cycle_of "$root/cases/2-two/also.md")" = 3
result $? 'a packing is found in the same way'
find cases -name '*.md' ! -name README.md | sed 's|.*/||' | sort | uniq -d >"$work/said"
test ! -s "$work/said"
result $? 'all pages of the tree have different names'
echo "1..$n"
