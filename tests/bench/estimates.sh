#!/bin/sh
# Checks the times that `nineball explain` and `nineball run` expect, on pages whose time is mostly that of rows, snapshots, files,
# reading, or contacts that come later. expected.sh compares the times of the cases, in which the cycles take most of it. A busy
# machine may count too much time, so the limits are factors of 1.25 to 10. TAP. It takes half a minute.
#
# $NINEBALL is the program, $srcdir the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
cd "$work" || exit 1

# rest PAGE: the time in which `explain` expects all but the cycles, s. last: the time at the end of each page's line of costs.
rest() { "$nineball" explain "$1" 2>>"$why" | sed -n 's/^  a cycle.* verdict \([0-9.e-]*\) s$/\1/p'; }
last() { sed -n 's/^.* cycles, .* contact updates, \([0-9.e-]*\) s$/\1/p' "$@"; }
page() { printf '```scene\nunits none\nmaterial m density 1 kn 100\n'"$1"'\n```\n'; }

# Writing a row takes the same time whether each cycle has one or every hundredth, and a million rows take most of the time.
for interval in 'every 1 cycles' 'every 100 cycles' none; do
  page "disc 0 0 radius 1 m\nmonitor D disc 1\nstep 0.01\nrecord time D.x D.y D.vx D.vy\nstage a\nrecord $interval\ncycles 1000000" >rows.md
  rest rows.md
done >out
cat out >>"$why"
awk '{ t[NR] = $1 } END { all = t[1] - t[3]; some = 100*(t[2] - t[3]); exit !(NR == 3 && all > 20*t[3] && all < 3*some && some < 3*all) }' out
result $? 'the time of writing rows'

# A snapshot of 10000 discs takes longer than the state from which it is written takes to read.
page 'lattice discs 100 by 100 radius 1 m spacing 2 from 0 0\nstep 0.01\nrecord time\nstage a\ncycles 1\nsnapshot' >saves.md
sed '/^snapshot/d' saves.md >less.md
for name in saves less; do rest $name.md; done >out
cat out >"$why"
awk '{ t[NR] = $1 } END { exit !(NR == 2 && t[1] > 1.5*t[2]) }' out
result $? 'the time of writing a snapshot'

# Most of the time of 200 short runs is that of reading the page, writing files, and start. The time of a page does not contain that of
# the page before it, which is much longer here.
page 'sweep u SWEPT\ndisc 0 0 radius 1 m velocity (u/1000) 0\nstep 0.01\nrecord time\nstage a\ncycles 2' >short.md
sed 's/SWEPT/1/' short.md >one.md
sed -i "s/SWEPT/$(seq -s ' ' 200)/" short.md
page 'disc 0 0 radius 1 m\nstep 0.01\nrecord time\nstage a\ncycles 1000000' >rows.md
{ "$nineball" explain one.md && "$nineball" explain rows.md one.md && "$nineball" explain short.md; } 2>>"$why" | last >out
"$nineball" run short.md 2>>"$why" | last >>out
cat out >"$why"
awk '{ t[NR] = $1 } END { exit !(NR > 4 && t[3] < 10*t[1] && t[NR-1] < 10*t[NR] && t[NR] < 10*t[NR-1]) }' out
result $? 'the expected time of a second page, and of many runs'

# An affine motion brings discs with a gap of 0.4 to overlaps within a long run. The contacts make most of its cycles slower than those of
# the trial, so the run says the time that was expected.
page 'material s density 1 kn 100 ks 50 friction 0.5\nshear linear\ndamping ratio 0.2\nlattice discs 20 by 20 radius 1 s spacing 2.4 from -21 -21\nstep 0.01\nrecord time\nstage a\nrecord every 50000 cycles\naffine strain -0.0001 -0.0001\ncycles 250000' >grows.md
"$nineball" run grows.md --isa plain >"$why" 2>&1
sed -n 's/^  250000 cycles, .* contact updates, \(.*\) s; expected \(.*\) s$/\1 \2/p' "$why" | awk '{ good = $2 < 0.8*$1 && $2 > 0.1*$1 } END { exit !good }'
result $? 'the expected time of a long run'
echo "1..$n"
