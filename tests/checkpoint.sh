#!/bin/sh
# Tests runs that are interrupted or killed and then continued from a checkpoint: their tables must be those of an uninterrupted
# run. Every failure with the files of checkpoints must have a message of its own. NINEBALL_KILLS is the number of kills. TAP.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
states=$work/'saved states'
page=$work/falling.md
cat >"$page" <<'END'
# Spheres fall into a box
```scene
units     none
sweep     friction  0.3 0.6
material  m density 3 friction $friction young 50000 poisson 0.2
normal    hertz
shear     mindlin_deresiewicz
damping   ratio 0.2
box       0 0 to 8 8 m
lattice   spheres 5 by 4 m radius 0.8 spacing 1.6 from 0.8 2
region    A all
record    time A.porosity A.strain.yy energy.damped energy.balance work.balance
gravity   0 -10
step      0.002
stage     fall
  cycles  6000
  snapshot
stage     press
  walls   inward 0.01
  ramp    material m friction 0.1
  cycles  12000
  record  every 100 cycles
  snapshot from fall
```
```expect
time  expected 36 within 1 ppm  [18000 cycles]
```
END
start() { "$nineball" run "$page" --states "$states" -o "$work/out" --jobs 1 "$@" >"$work/printed" 2>"$why" & }
# again ARGUMENTS: continues the run to its end.
again() {
  start --resume "$@"
  wait $!
}
same() {
  diff -rq "$work/whole" "$work/out" >>"$why"
}
# last: prints the names of the checkpoints. until_saved: waits until the last process has saved a checkpoint or has ended.
last() { ls "$states"/*.checkpoint 2>/dev/null; }
until_saved() { while kill -0 $! 2>/dev/null && [ -z "$(last)" ]; do sleep 0.01; done; }

"$nineball" run "$page" -o "$work/whole" --jobs 1 >"$work/printed" 2>"$why"
result $? 'a run without checkpoints'

for signal in TERM INT; do
  start --checkpoint=0.01
  until_saved
  kill -$signal $!
  wait $!
  status=$?
  test $status -eq $([ $signal = TERM ] && echo 143 || echo 130) && said 'stopped by a signal after cycle' && said ' s left); the checkpoint is ' &&
    grep -qxF "to continue: $nineball run $page --states '$states' -o $work/out --jobs 1 --checkpoint=0.01 --resume" "$why"
  result $? "SIG$signal: the run is saved, and the command to continue is shown"
  again && same && test -z "$(ls "$states")"
  result $? 'it continues with the same results, and the checkpoints are removed'
done

# The pages after an interrupted one are not run. An option --resume is not doubled.
"$nineball" check "$page" none.md --states "$states" --jobs 1 --resume >"$work/printed" 2>"$why" &
until_saved
kill -INT $!
wait $!
test $? -eq 130 && ! said 'none.md: error' && grep -qxF "to continue: $nineball check $page none.md --states '$states' --jobs 1 --resume" "$why" &&
  test -n "$(last)"
result $? 'the pages after an interrupted one are not run'
rm -rf "$states"

sed 's/^time  expected 36/time  expected 35/; s/^sweep .*/let friction = 0.3/' "$page" >"$work/failing.md"
"$nineball" check "$work/failing.md" --states "$states" --checkpoint=0.01 >"$work/printed" 2>"$why"
test $? -eq 1 && test -d "$states" && test -z "$(ls "$states")"
result $? 'the checkpoints of a page with a failed check are removed at its end'
rm -rf "$states"

# A contact test has no checkpoints: the first signal ends it.
cat >"$work/pressed.md" <<'END'
# Pressed
```contact-test
material  glass  young 70 GPa  poisson 0.25  friction 0.3
normal    hertz
shear     mindlin
contact   sphere 1 mm glass with sphere 1 mm glass
segment   press  overlap to 1 um  in 10 steps
segment   load   slip by 1 um  in 1000000000 steps
  record  none
```
END
"$nineball" run "$work/pressed.md" -o "$work/pressed" --checkpoint >"$work/printed" 2>"$why" &
sleep 0.5
kill -INT $!
for k in 1 2 3 4 5 6 7 8 9 10; do kill -0 $! 2>/dev/null && sleep 0.5; done
kill -9 $! 2>/dev/null
wait $!
test $? -eq 130 && said 'stopped by a signal after step' && said '; a contact test cannot be continued, so run it again' &&
  said 'a contact test has no checkpoints, because it takes seconds' && grep -q '^to repeat: .* --checkpoint$' "$why"
result $? 'SIGINT ends a contact test, and the command to repeat it is shown'

# ---- kill -9 ----

kills=${NINEBALL_KILLS:-6}
start --checkpoint=0.01
k=0
while [ $k -lt "$kills" ]; do
  sleep "0.$(awk -v seed="$$$k" 'BEGIN { srand(seed); printf "%03d", 30 + 400 * rand() }')"
  if kill -9 $! 2>/dev/null; then
    wait $! 2>/dev/null
  else
    wait $! && same || break
    rm -rf "$states" "$work/out"
  fi
  k=$((k + 1))
  start --resume --checkpoint=0.01
done 2>/dev/null
test $k -eq "$kills" && wait $! && same
result $? "killed at $kills random moments, it continues with the same results"

# ---- damaged files, a changed page ----

# interrupted: leaves two checkpoints of the first run.
interrupted() {
  rm -rf "$states" "$work/out"
  start --checkpoint=0.01
  while kill -0 $! && ! ls "$states"/*.old; do sleep 0.01; done >"$work/ls" 2>&1
  kill -TERM $!
  wait $!
  ls "$states"/*.checkpoint | head -n 1 >"$work/name"
  file=$(cat "$work/name")
  test -s "$file" && test -s "$file.old"
}
interrupted && cp -r "$states" "$work/kept"
"$nineball" run "$page" --states "$states" -o "$work/out" --checkpoint >"$work/printed" 2>"$why"
test $? -eq 2 && said "the run of this page was interrupted; its checkpoint is $file: --resume continues from this checkpoint; to start from the beginning, remove this file and the file with \`.old\` after its name" && diff -r "$states" "$work/kept" >>"$why"
result $? '--checkpoint without --resume does not replace a checkpoint: an error with its name'
rm "$file" && "$nineball" run "$page" --states "$states" -o "$work/out" --checkpoint >"$work/printed" 2>"$why"
test $? -eq 2 && said "its checkpoint is $file.old: --resume continues from this checkpoint; to start from the beginning, remove this file" && ! said 'this file and'
result $? 'an error, too, if only the checkpoint before it is left: the error names that file'
rm -rf "$states" && cp -r "$work/kept" "$states" && rm "$file.old"
"$nineball" run "$page" --states "$states" -o "$work/out" --checkpoint >"$work/printed" 2>"$why"
test $? -eq 2 && said "its checkpoint is $file: --resume continues from this checkpoint; to start from the beginning, remove this file" && ! said 'this file and'
result $? 'an error if there is only one checkpoint: it names no other file'
rm -rf "$states" && cp -r "$work/kept" "$states"
size=$(wc -c <"$file")
head -c $((size / 2)) "$file" >"$work/half" && cp "$work/half" "$file" && again && said 'the file is cut off; the run continues from the checkpoint before it' && same
result $? 'a checkpoint that is cut off: the one before it is used'
rm -rf "$states" && cp -r "$work/kept" "$states"
sed 's/^body 3 sphere m free 0x1/body 3 sphere m free 0x0/' "$file" >"$work/flipped" && ! cmp -s "$work/flipped" "$file" && cp "$work/flipped" "$file" &&
  again && said 'the file has been changed; the run continues from the checkpoint before it' && same
result $? 'a checkpoint with a changed byte: the one before it is used'
rm -rf "$states" && cp -r "$work/kept" "$states" && cp "$work/half" "$file" && cp "$work/half" "$file.old"
again
test $? -eq 2 && said 'the file is cut off'
result $? 'both are damaged: an error'
rm -rf "$states" && cp -r "$work/kept" "$states" && cp "$page" "$work/text"
sed 's/inward 0.01/inward 0.02/' "$work/text" >"$page"
again
test $? -eq 2 && said "the page has changed since $file was saved, in stage \`press\` (line 18) or above this stage: " &&
  said 'or remove this file and the file with `.old` after its name and run the page without --resume'
result $? 'the page has changed: an error that says where'
cp "$work/half" "$file"
again
test $? -eq 2 && said "the page has changed since $file.old was saved" &&
  said 'or remove this file and the file without `.old` at the end of its name and run the page without --resume'
result $? 'the page has changed, and the last checkpoint is damaged: the error names both files'
rm "$file"
again
test $? -eq 2 && said "the page has changed since $file.old was saved" && said 'or remove this file and run the page without --resume'
result $? 'the page has changed, and only the checkpoint before the last one is left: the error names that file'
sed 's/^record .*/record time/' "$work/text" >"$page"
again
test $? -eq 2 && said 'in a statement `record` or `snapshot`'
result $? 'other columns: an error'
sed 's/snapshot from fall/snapshot/' "$work/text" >"$page"
again
test $? -eq 2 && said 'in a statement `record` or `snapshot`'
result $? 'a snapshot from another stage: an error'
sed 's/^# Spheres.*/# Spheres in a box/; s/1 ppm/2 ppm/' "$work/text" >"$page"
again && ! said 'there is no checkpoint' || said ', run friction=0.6'
result $? 'another title or tolerance: it continues'
cp "$work/text" "$page"

# The disc collides with the wall between two rows of stage `hit`, and the run is interrupted in stage `wait`. `max` tracks all
# cycles.
cat >"$work/hit.md" <<'END'
# A disc hits a wall
```scene
units    none
material m density 1 kn 1000
wall     w -9 0 to 9 0 m
disc     0 1.4 radius 1 m velocity 0 -1
monitor  C disc 1 with wall w
step     0.001
record   C.normal
stage    hit
  cycles 1000
  record every 1000 cycles
stage    wait
  cycles 4000000
  record every 100000 cycles
```
```expect
C.normal max in hit below 1
```
END
cp "$work/hit.md" "$work/hit.max" && sed 's/ max / last /' "$work/hit.max" >"$work/hit.last"
page=$work/hit.md
# edited BEFORE AFTER: interrupts the run with the expectation BEFORE and continues it with the expectation AFTER.
edited() {
  rm -rf "$states" "$work/out"
  cp "$work/hit.$1" "$page"
  start --checkpoint=0.01
  until_saved
  kill -TERM $!
  wait $!
  test $? -eq 143 && cp "$work/hit.$2" "$page" && again && ! said 'there is no checkpoint'
}
edited last max && ! said 'in all cycles'
result $? 'an expectation that needs values of all cycles is added: it continues, without a warning about cycles that it does not know'
edited max last && ! said 'in all cycles'
result $? 'an expectation that needs values of all cycles is removed: it continues'
edited max max && said 'in all cycles'
result $? 'the expectation is unchanged: the warning knows the cycles before the interruption'
# Checkpoints by time follow that at the end of stage `hit`, which becomes the one before.
rm -rf "$states"
start --resume --checkpoint=0.01
while kill -0 $! 2>/dev/null && ! ls "$states"/*.old >"$work/ls" 2>&1; do sleep 0.01; done
kill -TERM $! 2>>"$why"
wait $!
test $? -eq 143
result $? '--resume keeps the interval of --checkpoint'
page=$work/falling.md

# ---- files that cannot be written ----

rm -rf "$states" && cp -r "$work/kept" "$states"
(ulimit -f 8 && trap '' XFSZ && "$nineball" check "$page" --states "$states" --jobs 1 --resume --checkpoint=0.3 >"$work/printed" 2>"$why")
test $? -eq 0 && said 'cannot write'
result $? 'a full disk: a note, and the run goes on'
rm -rf "$states" && cp -r "$work/kept" "$states"
(
  ulimit -f 8 && trap '' XFSZ
  start --resume
  sleep 0.2
  kill -TERM $!
  wait $!
)
test $? -eq 143 && said 'without a checkpoint' && again && same
result $? 'stopped on a full disk: an error, and the checkpoint before it can be used'
"$nineball" check "$page" --states /dev/null/states --checkpoint >"$work/printed" 2>"$why"
test $? -eq 2 && said 'cannot make the folder'
result $? 'no folder: an error'
if test -d /sys; then
  "$nineball" run "$page" -o /sys >"$work/printed" 2>"$why"
  test $? -eq 2 && said 'cannot write /sys/nineball.lock: ' && test ! -s "$work/printed"
  result $? 'a folder that is read-only: an error before the runs, not after them'
fi
rm -rf "$states" "$work/out"
"$nineball" check "$page" --states "$states" --jobs 1 --checkpoint=0.01 2>"$why" | true
again && ! said 'there is no checkpoint' && same
result $? 'a closed pipe: the verdict is lost, the runs are not'
rm -rf "$work/out"
"$nineball" run "$page" -o "$work/out" --jobs 1 2>"$why" | true
said 'the output could not be written' && same
result $? 'a closed pipe: an error, and the tables are written'
# Limits of the memory in kB, from ample to too small. At some of them memory runs out, and the checkpoints stay.
rm -rf "$states" && cp -r "$work/kept" "$states"
for limit in 400000 100000 60000 40000 30000 24000 20000 17000 15000 13000 11000 9000 5000; do
  (ulimit -v $limit && "$nineball" check "$page" --states "$states" --jobs 1 --resume --checkpoint=9 >"$work/printed" 2>>"$work/limits") 2>>"$work/limits" && cp -r "$work/kept/." "$states"
done
again && same
result $? 'a memory limit: the checkpoints can be used afterwards'
rm -rf "$states"
start --checkpoint=0.01
first=$!
until_saved
"$nineball" check "$page" --states "$states" --checkpoint >"$work/printed" 2>"$why"
test $? -eq 2 && said "process $first runs this page with these settings and saves checkpoints"
result $? 'two runs of one page: an error names the first one'
wait $first && same
result $? 'the first one is not disturbed'
rm -rf "$work/out"
start
first=$!
while kill -0 $first && [ ! -s "$work/out/nineball.lock" ]; do sleep 0.01; done # the process has written its number
"$nineball" figure "$page" --set friction=0.1 -o "$work/out" >"$work/printed" 2>"$why"
test $? -eq 2 && said "process $first writes into this folder, $work/out/nineball.lock: wait for its end, or choose another folder with -o"
result $? 'two runs with one output folder: an error names the first one'
wait $first && same
result $? 'the folder has the files of the first one'
# A second process is refused even between two runs of the sweep, when no run is locked. The test makes many attempts while the first
# process is running.
start --checkpoint=0.01
first=$!
until_saved
refused=0
while kill -0 $first 2>/dev/null && [ $refused -lt 20 ]; do
  "$nineball" check "$page" --states "$states" --checkpoint >"$work/second" 2>"$work/refused"
  test $? -eq 2 || kill -0 $first 2>/dev/null || break
  refused=$((refused + 1))
done
wait $first && same && test $refused -gt 0
result $? 'a second process is refused between two runs of a sweep, too'

# ---- the memory of a sweep ----

# 20 runs with 25000 rows of 32 numbers of 8 bytes need 128 MB. Up to 32 MB stay in memory, and the program alone needs less than
# 60 MB.
awk 'BEGIN { print "```scene\nunits none"; printf "sweep g"; for (k = 1; k <= 20; k++) printf " %d", k
  print "\nmaterial m density 1 kn 1\ngravity 0 -$g\nstep 1e-3"
  for (k = 1; k <= 8; k++) printf "disc %d 0 radius 1 m\nmonitor D%d disc %d\nrecord D%d.x D%d.y D%d.vx D%d.vy\n", 3 * k, k, k, k, k, k, k
  print "stage fall\ncycles 25000\n```\n```expect\nD8.vy expected (-25*g) within 1e-9 [g t]\nD8.vy decreases with g\n```" }' >"$work/many.md"
limited() { (ulimit -v 120000 && "$nineball" "$@"); }
if limited list >"$work/printed" 2>&1; then
  limited check "$work/many.md" --jobs 1 >"$work/printed" 2>"$why" && grep -q '21 of 21 checks passed' "$work/printed"
  result $? 'the results of a sweep do not stay in memory'
fi

# ---- a page that starts from another one ----

cat >"$work/on.md" <<'END'
# From the box
```scene
start   falling stage press  with friction=0.6
record  time
stage   rest
  cycles 5
```
END
rm -rf "$states"
"$nineball" run "$work/on.md" --states "$states" -o "$work/out" --checkpoint=0.01 >"$work/printed" 2>"$why" &
until_saved
kill -TERM $!
wait $!
test $? -eq 143 && "$nineball" run "$work/on.md" --states "$states" -o "$work/out" --resume >"$work/printed" 2>"$why" &&
  "$nineball" run "$work/on.md" --states "$work/others" -o "$work/on" >"$work/printed" 2>>"$why" && cmp "$work/on/table.tsv" "$work/out/table.tsv" &&
  diff -r "$work/others" "$states" >>"$why"
result $? 'the run that computes a state is continued too'

"$nineball" check "$page" --checkpoint=0 >"$work/printed" 2>"$why"
test $? -eq 2 && said 'expected a number of seconds above 0'
result $? 'an interval that is not a time: an error'
"$nineball" check "$page" --checkpoint --rounding all >"$work/printed" 2>"$why"
test $? -eq 2 && said 'takes neither --checkpoint nor --resume'
result $? 'rounding modes have no checkpoints'
echo "1..$n"
