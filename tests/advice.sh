#!/bin/sh
# Tests whole outputs of `nineball advise` on pages whose numbers follow from their statements. Each search takes a second. TAP. $NINEBALL
# is the program, $srcdir the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
cases=$(pwd)/cases
cd "$work" || exit 1
rows() { grep -v '^#' "$1" | tail -n +2; }

# A disc that flies with the velocity u + k/100 + n/1000, in n k cycles of 0.1 s. With k = 4 and n = 16 the velocity is 1.056 m/s, in 64
# cycles; with k = 2 and n = 8 it is 1.028 m/s, in 16 cycles. The error is 1.25 (1.056 - 1.028)/1.056 = 3.31 %. A disc may move by its radius
# in a step, so the step may be 0.8 s, with 2 cycles and 3 rows.
cat >flight.md <<'END'
# A flight
```scene
units     si
let       u = 2 m/s
let       k = 3 N/m
let       n = 16
let       v = (u + k*(0.01 m2/N/s) + n*(0.001 m/s))
trade     k 2 N/m
trade     n 8
trade     laws none
material  m  density 1 kg/m3  kn $k
disc      0 m 0 m  radius 1 m  m  velocity $v 0 m/s
disc      99 m 0 m  radius 1 m  m  fixed
monitor   D  disc 1
record    D.vx
step      0.1 s
stage     a
cycles    (n*k/(1 N/m))
```
END
run 0 advise flight.md --set 'k=4 N/m' --set 'u=1 m/s' --quantity D.vx --within '90 %' -o flight --trust
sed 's/^  time: .* median and range of 5 runs on .*/  time/; s/run: particle 1 .*/run: particle 1/; s/^  [0-9]* trials in .* s$/  trials/; /^status /d; /^Warning/d' "$why" |
  diff -u - /dev/fd/3 >given 3<<'END'
flight: D.vx within 90 %
  the cheapest setting within the tolerance: --set 'k=2 N/m' --set n=8 --set refine=0.125
    the step (0.8 s) is 8 times as long as that of the page; normal linear, shear none, k=2 N/m, n=8
  estimated error: at most 3.3 %; by the step alone 0 %
  cost: 3 recorded values and 4 contact and particle updates, 3.12 % of the 128 with the page's own setting
  time
  the next longer step cannot be run: particle 1
to run it: nineball run flight.md --set 'u=1 m/s' --set 'k=2 N/m' --set n=8 --set refine=0.125
  checks of the page that have tighter tolerances may fail then
  this holds for this page alone; with other values another setting may be the cheapest
  trials
look at flight/advice.svg; all settings that were tried are in flight/advice.tsv
END
status=$?
cp given "$why"
result $status 'two traded values, and settings that the command replaces'
rows flight/advice.tsv | cut -f 1-5,7-13 | tr '\t' '|' | diff -u - /dev/fd/3 >"$why" 3<<'END'
linear|none|0.125|0.8|16|0|0|0|within|-|-|9
linear|none|0.125|0.8|8|0.0263047|0.0236742|0|within|-|k=2 N/m|5
linear|none|0.125|0.8|8|0.0105219|0.0094697|0|within|-|n=8|5
linear|none|0.125|0.8|4|0.0368266|0.0331439|0|chosen|-|k=2 N/m, n=8|3
END
result $? 'the table of two traded values'

# With 3 % the variant with both values misses the tolerance. It is the next cheaper setting, so the next longer step is not mentioned.
run 0 advise flight.md --set 'k=4 N/m' --set 'u=1 m/s' --quantity D.vx --within '3 %' -o flight --trust &&
  said "  the cheapest setting within the tolerance: --set 'k=2 N/m' --set refine=0.125" && ! said 'next longer step' &&
  said "  the next cheaper setting misses the tolerance: --set 'k=2 N/m' --set n=8 --set refine=0.125" && said '    estimated error: 3.3 %; by the step alone 0 %'
result $? 'a cheaper setting that misses the tolerance'
run 0 advise --all flight.md --set 'k=4 N/m' --set 'u=1 m/s' --quantity D.vx --within '90 %' -o all --trust
rows all/trades.tsv | cut -f 1,3-11,13-21 | tr '\t' '|' | diff -u - /dev/fd/3 >"$why" 3<<'END'
flight.md|k=4 N/m, u=1 m/s|-|-|D.vx|90 %|yes|--set 'k=2 N/m' --set n=8 --set refine=0.125|0.03125|4|0.0331439|%|-|-|-|linear|none|-|-
END
result $? 'a row with cost and error'
# The shear law `linear` changes nothing, nor does the name `w`. Of the variants that the table names only the law differs from the page. An
# error of 0 has no figure.
sed 's/^trade .*//; s/^let  *n.*/&\nlet w = 1\ntrade w 2\ntrade laws all/' flight.md >laws.md
run 0 advise --all laws.md --quantity D.vx --within '90 %' -o all --trust
rows all/trades.tsv | tail -n 1 | cut -f 1,13,20,21 | tr '\t' '|' >given && cp given "$why"
test "$(cat given)" = 'laws.md|0|linear|-' && test ! -e all/laws.gp
result $? 'laws that are enough, of a page with other traded values'

# The velocity of realization k at 1 s is k, plus the step times k. So the mean, 4.5, is known to within a tenth, not to within a thousandth. The
# absolute tolerance of the expectation replaces only the first tolerance.
cat >mean.md <<'END'
# A fall
```scene
units none
let seed = 1
trade laws none
material m density 1 kn 1
disc 0 0 radius 1 m
monitor D disc 1
gravity 0 $seed
record D.vy
step 0.02
stage a
until time above 0.985 at most 1000 cycles
```
```expect
D.vy expected 1 within 0.5 [x]
```
END
run 1 advise --all mean.md --over seed --within '10 %; 0.1 %' -o mean --trust
rows mean/trades.tsv | cut -f 3-8 | tr '\t' '|' | diff -u - /dev/fd/3 >"$why" 3<<'END'
-|seed|until|D.vy|10 %|yes
-|seed|until|D.vy|0.1 %|unknown
END
result $? 'a mean over realizations, and the absolute tolerance'

# A contact test has no time, so its step has no length. Its figure has the word `normal` of the law.
cat >contact.md <<'END'
# A contact
```contact-test
units none
material rock young 100 poisson 0 friction 1
contact sphere 1 rock with wall rock
normal hertz
shear mindlin_deresiewicz
record shear normal
segment p normal to 1 in 16 steps
segment s slip by 0.001 in 16 steps
```
END
run 0 advise contact.md --quantity 'shear max' --within '1 %' -o contact --trust &&
  grep -qx '    the step is 16 times as long as that of the page; normal hertz, shear mindlin' "$why"
result $? 'a contact test'

# A variant that the reference solution of the page does not cover is left out, because `run` would refuse it.
run 0 advise "$cases/2-hertz/hertz-impact.md" --set pair=equal --set h=0.04 --quantity impact.duration --within '5 %' -o covered --trust
cp covered/advice.tsv "$why"
grep -q '^# left out: normal hertz, shear mindlin: the reference .hertz_impact. does not cover .shear mindlin.; it covers .shear none.$' covered/advice.tsv &&
  rows covered/advice.tsv | cut -f 1,2 | sort -u | diff - /dev/fd/3 3<<END
hertz	none
hertz_increment	none
END
result $? 'laws that the reference does not cover'

# Without advice the figure has no point for it. A quantity without a unit has an axis without one.
cat >still.md <<'END'
# A bounce
```scene
units none
trade laws none
material m density 1 kn 1
disc 0 0 radius 1 m velocity 0.1 0
disc 2.5 0 radius 1 m fixed
monitor D disc 1
record D.vx
step 0.2
stage a
until D.vx below 0 at most 100000 cycles
```
END
run 1 advise still.md --quantity D.vx --within 1e-5 -o none --trust && said 'no setting that was tried is within the tolerance' &&
  grep -qx "set ylabel 'estimated error'" none/advice.gp && grep -q '^plot .variant0 ' none/advice.gp && ! grep 'the advice' none/advice.gp
result $? 'the figure of a search without advice'
echo "1..$n"
