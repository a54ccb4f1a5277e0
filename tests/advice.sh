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
# in a step, so the step may be 0.8 s, with 2 cycles and 3 rows of 2 columns.
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
record    D.vx D.y
step      0.1 s
stage     a
cycles    (n*k/(1 N/m))
```
END
run 0 advise flight.md --set 'k=4 N/m' --set 'u=1 m/s' --set n=16 --set refine=1 --set 'trade=laws none' --quantity D.vx --within '90 %' -o flight --trust
sed 's/^  time: .* median and range of 5 runs on .*/  time/; s/run: particle 1 .*/run: particle 1/; s/^  [0-9]* trials in .* s$/  trials/; /^status /d; /^Warning/d' "$why" |
  diff -u - /dev/fd/3 >given 3<<'END'
flight: D.vx within 90 %
  the cheapest setting within the tolerance: --set 'k=2 N/m' --set n=8 --set refine=0.125
    the step (0.8 s) is 8 times as long as that of the page; normal linear, shear none, k=2 N/m, n=8
  estimated error: at most 3.3 %; by the step alone 0 %
  cost: 6 recorded values and 4 contact and particle updates, 3.12 % of the 128 with the page's own setting
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
# Steps longer than 0.8 s move the disc, with the velocity 1.056 m/s, by more than its radius. Its 64 cycles
# divide by 64, but not by 128.
cut -f 1-5,7-13 flight/advice.tsv | sed 's/^# page .*/# page/; s/: particle 1 .*/: particle 1/' | tr '\t' '|' | diff -u - /dev/fd/3 >"$why" 3<<END
# nineball $("$nineball" --version | sed -n 's/^nineball //p')
# page
# D.vx within 90 %
# updates with the page's own setting: 128
normal|shear|refine|mean-step|updates|error/tolerance|error|error-of-step|result|worst-run|values|recorded
linear|none|0.125|0.8|16|0|0|0|within|-|-|18
linear|none|0.125|0.8|8|0.0263047|0.0236742|0|within|-|k=2 N/m|10
linear|none|0.125|0.8|8|0.0105219|0.0094697|0|within|-|n=8|10
linear|none|0.125|0.8|4|0.0368266|0.0331439|0|chosen|-|k=2 N/m, n=8|6
# not run: refine=0.015625: a longer step does not divide the stages of the page into whole numbers of cycles
# not run: refine=0.015625: particle 1
# not run: refine=0.03125: particle 1
# not run: refine=0.0625: particle 1
END
result $? 'the table of two traded values'
# The figure has the settings of each variant in a block of its own, and a block with the advice.
awk -F '\t' '/<< EOD/ { print $1 } NF == 13 && $1 != "normal" { print $12 }' flight/advice.gp | diff -u - /dev/fd/3 >"$why" 3<<'END'
$variant0 << EOD
-
$variant1 << EOD
k=2 N/m
$variant2 << EOD
n=8
$variant3 << EOD
k=2 N/m, n=8
$chosen << EOD
k=2 N/m, n=8
END
result $? 'the blocks of the figure'

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

# The velocity of realization k at 1 s is k, plus the step times k. So the mean, 4.5, is known to within a tenth, not to within a
# thousandth. The absolute tolerance of the expectation replaces only the first tolerance. The time at the end is 0.99 at the anchor, and
# 1.28, 1.12 and 1.04 with the three finest steps of the first search: the order is log2(0.29/0.05)/2.
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
rows mean/trades.tsv | cut -f 3-11,13-21 | tr '\t' '|' | sed 's/|`D.vy.*: the mean over 8 .*|-|-|-|-|-|/|M|/' | diff -u - /dev/fd/3 >"$why" 3<<'END'
-|seed|until|D.vy|10 %|yes|--set refine=0.25|0.26|13|0.0734885|%|--set refine=0.125|1.9107|1.27|linear|none|-|-
-|seed|until|D.vy|0.1 %|unknown|M|linear|none|-|-
END
result $? 'a mean over realizations, and the absolute tolerance'

# Realization k has the velocity k t, where t is the time at the end: 0.99 at the anchor, 1.04 with a quarter of refine, 1.12 with an eighth.
# For k = 1 to 8 the mean is 4.5 and the standard deviation 6^(1/2). The quantile of Student's distribution is 2.3646. So the errors of
# these settings are (4.5 + 2.3646 (6/8)^(1/2)) (t - 0.99)/(4.5*0.99) = 7.3 % and 19 %. 8 settings have 8 trials each.
run 0 advise mean.md --over seed --within '10 %' -o mean --trust
sed 's/^  time: .* median and range of 5 runs on .*/  time/; s/^  \([0-9]*\) trials in .* s$/  \1 trials/; /^status /d; /^Warning/d' "$why" |
  diff -u - /dev/fd/3 >given 3<<'END'
mean: D.vy within 10 %
  the cheapest setting within the tolerance: --set refine=0.25
    the step (0.08) is 4 times as long as that of the page; normal linear, shear none, as in the page
  estimated error: at most 7.3 %; difference of the means 5.1 %
  cost: 14 recorded values and 13 contact and particle updates for a realization, 26 % of the 50 with the page's own setting
  time
  the next cheaper setting misses the tolerance: --set refine=0.125
    estimated error: 19 %; difference of the means 13 %
to run it: nineball run mean.md --set refine=0.25
  checks of the page that have tighter tolerances may fail then
  this holds for the mean over realizations (seed = 1 to 8), with 95 % confidence; a single run is not covered, since runs scatter with a standard deviation of 2.5
  this holds for this page alone; with other values another setting may be the cheapest
  64 trials
look at mean/advice.svg; all settings that were tried are in mean/advice.tsv
END
status=$?
cp given "$why"
result $status 'the whole output of a mean over realizations'
# With 12 realizations the mean is 6.5, the standard deviation 13^(1/2), and the quantile 2.2010: the error is 0.0683.
run 0 advise --all mean.md --over seed --realizations 12 --within '10 %' -o twelve --trust
rows twelve/trades.tsv | cut -f 9,13 >"$why" && grep -qx -e '--set refine=0.25	0.0683[0-9]*' "$why"
result $? 'the number of realizations, for many pages'

# All trials of the anchor have their value, phases 0 and 4 of 8; phase 6 needs 1.06*99.5 > 105 cycles. Steps longer than that of the page move
# the disc, with the velocity 90, by more than its radius. So no setting has an error. The anchor has 4 trials, 7 longer steps have one, and the
# two steps that are left have those of the phases 1, 2, 3, 5 and 6.
cat >phases.md <<'END'
# Phases
```scene
units none
trade laws none
material m density 1 kn 1
disc 0 0 radius 1 m velocity 90 0
disc 999 0 radius 1 m fixed
monitor D disc 1
record D.vx
step 0.01
stage a
until time above 0.995 at most 105 cycles
```
END
run 1 advise phases.md --quantity D.vx --within 2 -o phases --trust --jobs 1
sed 's/^  \([0-9]*\) trials in .* s$/  \1 trials/; /^status /d; /^Warning/d' "$why" | diff -u - /dev/fd/3 >given 3<<'END'
phases: D.vx within 2
  no setting that was tried is within the tolerance
  choose a larger tolerance
  21 trials
look at phases/advice.svg; all settings that were tried are in phases/advice.tsv
END
status=$?
cp given "$why"
result $status 'a page without any setting that has an error'
{ sed '1,4d; s/: particle 1 .*/: particle 1/' phases/advice.tsv && sed '1,/^EOD/d' phases/advice.gp; } | diff -u - /dev/fd/3 >"$why" 3<<'END'
normal	shear	refine	mean-step	updates	seconds	error/tolerance	error	error-of-step	result	worst-run	values	recorded
# not run: refine=0.0078125: particle 1
# not run: refine=0.015625: particle 1
# not run: refine=0.03125: particle 1
# not run: refine=0.0625: particle 1
# not run: refine=0.125: particle 1
# not run: refine=0.25: particle 1
# not run: refine=0.5: particle 1
# not run: refine=1: stage `a` (line 11) did not end within 105 cycles: time is 0.990566 and should be above 0.995
# not run: refine=2: stage `a` (line 11) did not end within 210 cycles: time is 0.990566 and should be above 0.995
set datafile separator tab
set logscale xy
set format xy '10^{%T}'
set title 'D.vx within 2' noenhanced
set xlabel 'contact and particle updates of all runs'
set ylabel 'estimated error'
plot 2 with lines dt 2 lc rgb 'black' title 'tolerance'
END
result $? 'its table and its figure'

# A disc of 12800 cycles needs a hundredth of them with the advice, so its shortest time is much shorter. Of three other values the first
# moves the disc by 1e7*5e-5, more than its radius, even with the step of the anchor; the second is a mistake of the page; the third gives
# twice the velocity.
model=$(sed -n 's/^model name[[:space:]]*: //p' /proc/cpuinfo 2>/dev/null | head -n 1)
cat >long.md <<'END'
# A long flight
```scene
units none
let k = 1
trade k 1e9 -1 2
trade laws none
material m density 1 kn $k
disc 0 0 radius 1 m velocity (0.01*k) 0
disc 2.5 0 radius 1 m fixed
monitor D disc 1
record D.vx
step 1e-4
stage a
cycles 12800
```
END
run 0 advise long.md --quantity D.vx --within '2 %' -o long --trust
grep -F " of 5 runs on $(printf '%.127s' "${model:-this machine}")" "$why" | sed -n 's/^  time: [0-9.e-]* s (\([0-9.e-]*\) to .*) instead of [0-9.e-]* s (\([0-9.e-]*\) to .*/\1 \2/p' |
  awk '{ good = $1 < $2/3 } END { exit !good }'
result $? 'the times of the advice and of the page, and the machine'
sed -n '/^  [0-9] other/,/^  (/p' "$why" >given
grep '^# left' long/advice.tsv | sed 's/\. The limit is .*//' >>given
diff -u - given >"$why" <<'END'
  2 other variants cannot be run with this page
  1 other variant gives values that differ too much; the one with the smallest difference is normal linear, shear none, k=2: its value differs from that of the page by 50 times the tolerance
  (a variant is the page with other contact laws, softer contacts, centred dashpots, or other values of the names in its `trade` statements)
# left out: normal linear, shear none, k=1e9: particle 1 (line 8): in cycle 1, at time 5e-05, it moved by 500 in one step of 5e-05
# left out: normal linear, shear none, k=-1: long.md:7:25: error: expected a stiffness, 0 or more, found `-1` (`$k`)
# left out: normal linear, shear none, k=2: its value differs from that of the page by 50 times the tolerance
END
result $? 'variants that are left out'

# Contacts that are 1000 times as soft as those of the call, which are three times as soft as those of the page: their stable step is
# 2 (m/k)^(1/2) = 1.94 s for k = 1e4/3000 N/m and a mass of pi kg, so the step of the call, 0.01 s, may be 128 times as long. Without the
# factor 3 it would be 1.12 s. The last trial divides this step by 1.07. The error has the unit of the quantity.
cat >soft.md <<'END'
# Soft contacts
```scene
let       w = 1
trade     w 2
material  m  density 1 kg/m3  kn 1e4 N/m
disc      0 m 0 m  radius 1 m  m  velocity 0.1 m/s 0 m/s
disc      2.7 m 0 m  radius 1 m  m  fixed
monitor   D  disc 1
record    D.vx
step      0.02 s
stage     a
until     time above (5 s / w) at most 100000 cycles
```
END
run 0 advise soft.md --set soften=3 --set refine=2 --quantity D.vx --within '0.01 m/s' -o soft --trust
sed -n '2,4p; /^to run/p' "$why" | diff -u - /dev/fd/3 >given 3<<'END'
  the cheapest setting within the tolerance: --set soften=3000 --set w=2 --set refine=0.015625
    the step (1.2 s) is 128 times as long as that of the page; normal linear, shear none, stiffness divided by 1000, w=2
  estimated error: at most 0 m/s; by the step alone 0 m/s
to run it: nineball run soft.md --set soften=3000 --set w=2 --set refine=0.015625
END
status=$?
cp given "$why"
result $status 'softer contacts together with a traded value'
# Many pages: a search over both runs of a sweep, with the settings of the call, and the unit of the error. With an eighth of refine the
# runs have one and two cycles of two discs.
cat >two.md <<'END'
# Two flights
```scene
sweep     c 1 2
let       v = 1 m/s
trade     laws none
material  m  density 1 kg/m3  kn 1 N/m
disc      0 m 0 m  radius 1 m  m  velocity $v 0 m/s
disc      9 m 0 m  radius 1 m  m  fixed
monitor   D  disc 1
record    D.vx
step      0.1 s
stage     a
cycles    (8*c)
```
END
run 0 advise --all two.md --set 'v=0.1 m/s' --quantity D.vx --within '0.01 m/s' -o two --trust
rows two/trades.tsv | cut -f 1,3-11,13-21 | tr '\t' '|' | diff -u - /dev/fd/3 >"$why" 3<<'END'
two.md|v=0.1 m/s|-|-|D.vx|0.01 m/s|yes|--set refine=0.125|0.125|6|0|m/s|-|-|-|linear|none|-|-
END
result $? 'a search over all runs'

# A page that continues another one at the time 0.7. Only its own stage counts: it has no number of cycles, so it has phases, and its step is
# that of its own rows. The last phase divides the step 3.2 by 1.07. The stable step is 2 (m/k)^(1/2) = 2 pi^(1/2).
cat >other.md <<'END'
# Another page
```scene
units none
material m density 1 kn 1
disc 0 0 radius 1 m velocity 0.01 0
disc 9 0 radius 1 m fixed
record time
step 0.1
stage a
cycles 7
```
END
cat >start.md <<'END'
# A continued page
```scene
start other.md stage a
trade laws none
monitor D disc 1
record D.vx
stage b
until time above 1.45 at most 100 cycles
```
END
run 0 advise start.md --quantity D.vx --within '1 %' -o start --trust
sed -n '3p; s/ stable one, 3.54491, .*/ stable one, 3.54491/; /^  cost/p; /^  the next/p' "$why" | diff -u - /dev/fd/3 >given 3<<'END'
    the step (2.99) is 32 times as long as that of the page; normal linear, shear none, as in the page
  cost: 2 recorded values and 2 contact and particle updates, 12.5 % of the 16 with the page's own setting
  the next longer step cannot be run: particle 1 (line 3): at cycle 7, time 0.7, the step 6.4 is above the guaranteed stable one, 3.54491
END
status=$?
cp given "$why"
result $status 'a page that continues another one'
# The tolerance of an expectation replaces the first one only if it is an absolute one, and then no other one is tried.
for tolerance in 0.5:0.5=yes '50 %:'; do
  sed "s/within 0.5/within ${tolerance%:*}/" mean.md >unknown.md
  run 1 advise --all unknown.md --over seed --within '0.1 %; 10 %' -o unknown --trust
  rows unknown/trades.tsv | cut -f 1,7,8 | tail -n +2 | tr '\t\n' '= ' >given
  rm unknown/trades.tsv
  cp given "$why"
  case "$(cat given)" in "unknown.md=${tolerance#*:} " | ${tolerance#*:}) ;; *) false ;; esac
  result $? "a value that is too uncertain for the first tolerance: ${tolerance%:*}"
done

# A curve, a line `report`, and the tolerance of an order of convergence, which is not one of the quantity, say nothing about a value. A second
# page expects nothing.
cat >order.md <<'END'
# A fall
```scene
units none
sweep h 1 2
trade laws none
material m density 1 kn 1000
gravity 0 -1
sphere 0 5 radius 1 m
wall floor -9 0 to 9 0 m
monitor D sphere 1
record time D.x D.y D.vy
step (0.01*h)
stage a
cycles (8/h)
```
```expect
reference free_fall
D.y versus time within 1 % of peak
report D.y
D.x order 2 in h within 0.5
D.vy within 1 %
```
END
run 1 advise --all order.md two.md --within '1 %' -o order --trust
sed '/^status/d; s/; about [0-9][0-9]* s left$/; about N s left/' "$why" >given
rows order/trades.tsv | cut -f 3,5-8 | tr '\t' '|' >>given
diff -u - given >"$why" <<'END'
1 of 2, order: 2 searches, 1 with advice; about N s left
  two has no expectation of a single value that depends on the step
2 of 2, two: 0 searches, 0 with advice
2 searches, 1 with advice; look at order/trades.tsv
h=1|time|D.x|1 %|unknown
h=1|time|D.vy|1 %|yes
END
result $? 'expectations that have no value, and the output for many pages'
# The error of the step s is 1.25 (s - a) + 3 a with the anchor a, which is 0.002 for the steps 0.016 and 0.008, and 0.001 for 0.004. These
# are the three finest steps of the page, and the errors 0.0235, 0.0135 and 0.00675: the order is log2(0.0235/0.00675)/2. The variant does
# not count.
cat >steps.md <<'END'
# Steps
```scene
units none
let e = 1
trade e 3
trade laws none
material m density 1 kn 1000
disc 0 0 radius 1 m
disc 9 0 radius 1 m
record step
step (0.016*e)
stage a
cycles 64
```
END
run 0 advise --all steps.md --quantity step --within 0.0124 -o steps --trust
rows steps/trades.tsv | cut -f 1,3-11,13-21 | tr '\t' '|' | diff -u - /dev/fd/3 >"$why" 3<<'END'
steps.md|-|-|-|step|0.0124|yes|--set refine=4|4|512|0.00675|1|--set refine=2|1.08871|0.9|linear|none|-|-
END
result $? 'the order of convergence'

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
# Laws that give the values of another one are neither enough nor not enough.
run 0 advise --all contact.md --quantity 'shear max' --within '1 %' -o contact --trust
rows contact/trades.tsv | cut -f 5,6,18-21 | tr '\t' '|' | diff -u - /dev/fd/3 >"$why" 3<<'END'
-|shear max|hertz|mindlin_deresiewicz|mindlin|linear
END
result $? 'laws that are enough for a contact test'

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

# Calls that are refused.
use='nineball: expected one page and --within TOLERANCE, as in `nineball advise PAGE --within '"'1 %'"'`, and with --budget a number of seconds above 0; for many pages write `nineball advise --all`'
for call in still.md 'still.md mean.md --within 1' 'still.md --within 1 --budget 0' '--all --budget 0'; do
  run 2 advise $call && test "$(head -n 1 "$why")" = "$use"
  result $? "a call that is refused: $call"
done
for call in '--over seed --realizations 7' '--over seed --realizations 33' '--realizations 8' '--all --realizations 8'; do
  run 2 advise mean.md --within 1 $call && test "$(head -n 1 "$why")" = 'nineball: expected --realizations from 8 to 32, together with --over NAME'
  result $? "a call that is refused: $call"
done
run 2 advise mean.md --within 1 --over seed --set seed=2 && said 'mean.md: error: --over seed and --set seed=2 exclude each other: remove one of the two'
result $? 'a name with one value and many'
echo "1..$n"
