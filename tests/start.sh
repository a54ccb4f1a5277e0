#!/bin/sh
# Pages that start from another page's stage: the same bytes as without the interruption, whether the state is made now or found; once for
# all who want it at the same time; made anew when the page has changed; and no state where it could not be made whole. TAP.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
pages=$work/pages
mkdir "$pages"
states=$work/states
cp cases/3-nine-discs/nine-discs.md cases/5-numerics/saved-stage.md "$pages"

# rows FOLDER STAGE: the numbers of that stage.
rows() { awk -F '\t' -v stage="$2" '/^#/ { next } !head { for (k = 1; k <= NF; k++) at[$k] = k; head = 1; next }
  $(at["stage"]) == stage { print $(at["cycle/-"]), $(at["C.normal/-"]) }' "$1/table.tsv"; }
run() {
  folder=$work/$1
  shift
  "$nineball" run "$@" --states "$states" -o "$folder" >"$work/out" 2>"$work/said"
}
made() { grep -c 'is made$' "$work/said"; }

"$nineball" explain "$pages/saved-stage.md" --states "$states" >"$work/said" &&
  grep -q 'nine-discs-load-[0-9a-f]*.state: missing, will be computed' "$work/said" &&
  grep -qF "nineball check $pages/saved-stage.md" "$work/said"
result $? 'explain says that it will be made'

run whole cases/3-nine-discs/nine-discs.md
run now "$pages/saved-stage.md" && test "$(made)" -eq 1
result $? 'the state is made'
rows "$work/whole" swing >"$work/wanted"
rows "$work/now" rest | sed 1d | head -n 400 | diff - "$work/wanted" >"$work/said" && test "$(wc -l <"$work/wanted")" -eq 400
result $? 'the numbers are those of the page without interruption'
run found "$pages/saved-stage.md" && test "$(made)" -eq 0 && cmp "$work/now/table.tsv" "$work/found/table.tsv"
result $? 'and the same when it is found'
"$nineball" explain "$pages/saved-stage.md" --states "$states" >"$work/said" && grep -q 'state: present$' "$work/said"
result $? 'explain says that it is there'
run threads "$pages/saved-stage.md" --threads 3 --isa plain && cmp "$work/now/table.tsv" "$work/threads/table.tsv"
result $? 'with other threads and instruction set too'

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
result $? 'chains: the nearer state is made from the farther one'
rm "$states"/*
run third-anew "$pages/third.md" && test "$(made)" -eq 2 && cmp "$work/third/table.tsv" "$work/third-anew/table.tsv"
result $? 'or both are'
sed 's/^start .*/start third stage more/; s/stage   more/stage again/' "$pages/third.md" >"$pages/fourth.md"
sed 's/^start .*/start fourth stage again/' "$pages/saved-stage.md" >"$pages/other.md"
mv "$pages/other.md" "$pages/saved-stage.md"
"$nineball" explain "$pages/third.md" --states "$states" >"$work/out" 2>"$work/said"
test $? -eq 2 && grep -q 'starts from itself in the end' "$work/said"
result $? 'a chain that bites its tail is a mistake'
cp cases/5-numerics/saved-stage.md "$pages"

# A stage that changes the friction: `explain` says from which stage on.
sed 's/^start .*/&\nmaterial rock friction 0/; /^```expect/,/^```$/d' "$pages/saved-stage.md" >"$pages/smooth.md"
"$nineball" explain "$pages/smooth.md" --states "$states" >"$work/said" &&
  test "$(grep -c '^    from stage `rest` on (line [0-9]*): friction 0; no shear force, for want of friction and cohesion$' "$work/said")" -eq 2
result $? 'explain says which stage changes the friction, for each pair of materials'

# Whoever makes a state may have been stopped.
rm "$states"/*.state
: >"$states/$("$nineball" explain "$pages/saved-stage.md" --states "$states" | sed -n 's/.*\(nine-discs-load-[0-9a-f]*.state\).*/\1/p').lock"
flock "$states"/*.lock sleep 60 &
holder=$!
sleep 1
NINEBALL_WAIT=0.5 timeout 30 "$nineball" run "$pages/saved-stage.md" --states "$states" -o "$work/late" >"$work/out" 2>"$work/said"
test $? -eq 2 && grep -q 'has held .*state.lock for 0.5 s: see what it does by' "$work/said"
result $? 'a lock is not waited for without end'
kill "$holder"
rm -f "$states"/*
run again "$pages/saved-stage.md"

# ---- what moves an assembly ----

# in_two NAME: pages NAME and NAME-on in $pages, of which the second goes on behind stage `shear` of the first; the text of both on standard
# input, with a line --- in the place of `start`.
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
result $? 'a boundary, its affine motion, and behind a servo'
in_two cell <<'END'
# Spheres in a cell
```scene
units     none
material  m density 3 friction 0.3 young 50000 poisson 0.2
normal    hertz
shear     mindlin
cell      0 0 to 8 8
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
in_two box <<'END'
# Spheres between walls that follow a servo, and rest behind it
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
result $? 'walls that follow a servo'

# ---- another text of the page ----

sed 's/^walls     inward 0.12/walls     inward 0.11/' cases/3-nine-discs/nine-discs.md >"$pages/nine-discs.md"
"$nineball" explain "$pages/saved-stage.md" --states "$states" >"$work/said" && grep -q 'out of date, will be computed again' "$work/said"
result $? 'a page that has changed makes its state stale'
run changed "$pages/saved-stage.md"
test "$(made)" -eq 1 && ! cmp -s "$work/now/table.tsv" "$work/changed/table.tsv" &&
  test "$(ls "$states" | grep -c '^nine-discs-load-')" -eq 1
result $? 'it is made anew, and the old one goes'
cp cases/3-nine-discs/nine-discs.md "$pages"
run back "$pages/saved-stage.md" && test "$(made)" -eq 1 &&
  sed 's/^walls     inward 0.12/walls     inward 0.12   # as ever/; s/^cycles    4000/cycles    7/; s/^record .*/record time/' \
    cases/3-nine-discs/nine-discs.md >"$pages/nine-discs.md" &&
  run again "$pages/saved-stage.md" && test "$(made)" -eq 0
result $? 'what is only looked at, remarks and what comes later make no difference'

# ---- sweeps, and several at once ----

cat >"$pages/sweep.md" <<'END'
# Runs side by side, two of which want the same state
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
test "$(made)" -eq 0 && test "$(grep -c 'is made, run' "$work/said")" -eq 2 && test "$(ls "$states" | wc -l)" -eq 2
result $? 'runs of a sweep make each state once'

# Names that take their values together: one chooses the others.
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
result $? 'a value of several that go together chooses the others'
run turns "$pages/turns.md" --set v=0.5 --set x=7 --set n=4 && test "$(tail -n 1 "$work/turns/table.tsv")" = '7	0.5	4	go	7.25'
result $? 'a value that no turn has takes the place of its own'

# A state that takes a while.
sed 's/^cycles    40$/cycles    800000/; s/inward 0.12/inward 1e-5/; s/^record .*/record time/; s/^stage     load/&\nrecord none/' cases/3-nine-discs/nine-discs.md >"$pages/nine-discs.md"
sed 's/^cycles    4000/cycles    10/; /^```expect/,/^```$/d' cases/5-numerics/saved-stage.md >"$pages/saved-stage.md"
rm "$states"/*
for k in 1 2 3; do
  "$nineball" run "$pages/saved-stage.md" --states "$states" -o "$work/at-once-$k" >"$work/out-$k" 2>"$work/said-$k" &
done
wait
cat "$work"/said-[123] >"$work/said"
test "$(made)" -eq 1 && test "$(grep -c 'note: waits for process [0-9]*, which makes' "$work/said")" -ge 1 &&
  cmp "$work/at-once-1/table.tsv" "$work/at-once-2/table.tsv" && cmp "$work/at-once-1/table.tsv" "$work/at-once-3/table.tsv" &&
  test "$(ls "$states" | wc -l)" -eq 1
result $? 'three at once: one makes it, the others wait for it'

rm "$states"/*
"$nineball" run "$pages/saved-stage.md" --states "$states" -o "$work/killed" >"$work/out" 2>"$work/said" &
maker=$!
while kill -0 $maker 2>/dev/null && ! ls "$states"/*.lock >/dev/null 2>&1; do sleep 0.01; done
kill -9 $maker
wait $maker 2>/dev/null
test -z "$(ls "$states" | grep '\.state$')"
result $? 'who is killed while making it leaves none'
touch "$states/$(basename "$(ls "$states"/*.lock)" .lock).12345.new" # as if he had begun to write
run after-kill "$pages/saved-stage.md" && test "$(made)" -eq 1 && ! grep -q waits "$work/said" &&
  cmp "$work/after-kill/table.tsv" "$work/at-once-1/table.tsv" && test "$(ls "$states" | wc -l)" -eq 1
result $? 'and nobody waits for him'

# ---- what is damaged, what cannot be written ----

state=$(ls "$states"/*.state)
sed 's/^body 3 disc/body 3 sphere/' "$state" >"$work/damaged" && cp "$work/damaged" "$state"
run damaged "$pages/saved-stage.md"
test $? -eq 2 && grep -q 'expected another checksum: something in the file has changed' "$work/said"
result $? 'a damaged state is not used'
rm "$states"/*
(ulimit -f 1 && trap '' XFSZ && run full "$pages/saved-stage.md")
test $? -eq 2 && grep -q 'cannot write .*state' "$work/said" && test -z "$(ls "$states")"
result $? 'a full disk: an error, and nothing is left'
"$nineball" run "$pages/saved-stage.md" --states /dev/null/states -o "$work/none" >"$work/out" 2>"$work/said"
test $? -eq 2 && grep -q 'cannot make the folder' "$work/said"
result $? 'no folder: an error'

# ---- where a page is found by its name ----

# base NAME: a small page that has a stage `go` with one disc; on NAME FROM: one that goes on there.
base() { printf '# Base\n```scene\nunits none\nmaterial m density 1 kn 100\ndisc 0 0 radius 1 m\nstep 0.1\nrecord time\nstage go\n  cycles %d\n```\n' "$1"; }
on() { printf '# On\n```scene\nstart %s stage go\nrecord cycle\nstage more\n  cycles 1\n```\n' "$1"; }
house=$work/house
mkdir -p "$house/cases/1-one/deeper" "$house/cases/2-two" "$house/cases/3-three/cases/inner" "$house/other" "$house/outside"
base 3 >"$house/cases/1-one/deeper/far.md"
base 4 >"$house/cases/1-one/both.md"
base 5 >"$house/cases/2-two/both.md"
base 6 >"$house/cases/1-one/twice.md"
cp "$house/cases/1-one/twice.md" "$house/cases/1-one/deeper/twice.md"
cp "$house/cases/1-one/twice.md" "$house/cases/3-three"
base 7 >"$house/outside/linked.md"
mkdir "$house/cases/.kept" && base 8 >"$house/cases/.kept/hidden.md"
ln -s .. "$house/cases/1-one/up"
ln -s ../../outside "$house/cases/1-one/out"
ln -s ../../outside/linked.md "$house/cases/1-one/alias.md"
base 9 >"$house/cases/3-three/cases/inner/near.md"
# cycle_of PAGE: the cycle in which it ends.
cycle_of() {
  "$nineball" run "$@" --states "$states" -o "$work/found" >"$work/out" 2>"$work/said" && tail -n 1 "$work/found/table.tsv" | cut -f 2
}
# no PAGE TEXT: is refused with status 2 and this text.
no() {
  "$nineball" explain "$1" >"$work/out" 2>"$work/said"
  test $? -eq 2 && grep -qF -e "$2" "$work/said"
}

on both >"$house/cases/2-two/page.md"
test "$(cycle_of "$house/cases/2-two/page.md")" = 6
result $? 'a page is found beside, whatever else is below `cases`'
on far >"$house/cases/2-two/page.md"
test "$(cycle_of "$house/cases/2-two/page.md")" = 4
result $? 'else below `cases`, also deeper'
(cd "$house/cases/2-two" && test "$(cycle_of page.md)" = 4) && (cd "$house/cases" && test "$(cycle_of ./2-two/page.md)" = 4) &&
  (cd "$house/outside" && test "$(cycle_of ../cases/1-one/../2-two/page.md)" = 4) && (cd "$house" && test "$(cycle_of cases/2-two/page.md)" = 4)
result $? 'from wherever the program is called'
on deeper/far.md >"$house/cases/2-two/page.md"
test "$(cycle_of "$house/cases/2-two/page.md")" = 4
result $? 'and by a name with a folder'
on twice >"$house/cases/2-two/page.md"
no "$house/cases/2-two/page.md" "page.md:3:7: error: expected a file that is there once, found \`$house/cases/1-one/deeper/twice.md\` and \`$house/cases/1-one/twice.md\`"
result $? 'a name that is there twice is a mistake that says where'
on 1-one/twice >"$house/cases/2-two/page.md" && test "$(cycle_of "$house/cases/2-two/page.md")" = 7 &&
  on ../1-one/twice >"$house/cases/2-two/page.md" && test "$(cycle_of "$house/cases/2-two/page.md")" = 7
result $? 'until its folder is named'
missed=
for name in linked hidden alias ../2-two/far 1-one/../1-one/both nowhere; do
  on $name >"$house/cases/2-two/page.md"
  no "$house/cases/2-two/page.md" "cases/2-two/$name.md: error: cannot be read: No such file" || missed="$missed $name"
done
echo "$missed" >"$work/said"
test -z "$missed"
result $? 'no link is followed; what is in a hidden folder, or nowhere, is not found'
on far >"$house/cases/3-three/cases/page.md" && no "$house/cases/3-three/cases/page.md" 'cases/3-three/cases/far.md: error: cannot be read' &&
  on near >"$house/cases/3-three/cases/page.md" && test "$(cycle_of "$house/cases/3-three/cases/page.md")" = 10
result $? 'the nearest folder `cases` is searched, and no other one'
on far >"$house/other/page.md" && no "$house/other/page.md" 'other/far.md: error: cannot be read' &&
  no "$house/cases/../other/page.md" 'other/far.md: error: cannot be read' &&
  mkdir "$house/casesnot" "$house/notcases" && cp "$house/other/page.md" "$house/casesnot" && cp "$house/other/page.md" "$house/notcases" &&
  mkdir -p "$house/casesnot/b" "$house/notcases/b" &&
  cp "$house/cases/1-one/deeper/far.md" "$house/casesnot/b" && cp "$house/cases/1-one/deeper/far.md" "$house/notcases/b" &&
  no "$house/casesnot/page.md" 'cannot be read' && no "$house/notcases/page.md" 'cannot be read'
result $? 'outside of `cases` a page is found beside alone'
deep=$house/cases/2-two/3/4/5/6/7/8/9
mkdir -p "$deep/10" && base 3 >"$deep/end.md" && base 3 >"$deep/10/over.md" && on end >"$house/cases/1-one/page.md" &&
  test "$(cycle_of "$house/cases/1-one/page.md")" = 4 && on over >"$house/cases/1-one/page.md" && no "$house/cases/1-one/page.md" 'cannot be read'
result $? 'eight folders deep, and no deeper'
printf 'x/m\ty/m\tradius/m\n0\t0\t1\n' >"$house/cases/1-one/deeper/list.tsv"
printf '# P\n```scene\nunits none\nmaterial m density 1 kn 100\npacking deeper/list.tsv discs m\nstep 0.1\nrecord cycle\nstage more\n cycles 3\n```\n' >"$house/cases/2-two/packed.md"
sed 's/deeper.list/list/' "$house/cases/2-two/packed.md" >"$house/cases/2-two/also.md"
sed -i 's/x.m/x\/-/; s/y.m/y\/-/; s/us.m/us\/-/' "$house/cases/1-one/deeper/list.tsv"
test "$(cycle_of "$house/cases/2-two/packed.md")" = 3 && test "$(cycle_of "$house/cases/2-two/also.md")" = 3
result $? 'a packing likewise'
find cases -name '*.md' ! -name README.md | sed 's|.*/||' | sort | uniq -d >"$work/said"
test ! -s "$work/said"
result $? 'in the tree every page has a name of its own'
echo "1..$n"
