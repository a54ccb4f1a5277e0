#!/bin/sh
# Tests `nineball advise`: its estimated errors (claims) must not be below the errors against a reference that it does not use, its
# choice must be the cheapest setting within the tolerance, and it must refuse invalid calls. TAP. $NINEBALL is the program, $srcdir
# the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
pages=$(pwd)/tests/pages
cases=$(pwd)/cases
cd "$work" || exit 1

# rows TABLE: the rows of a table, without the comments and the line of names above them.
rows() { grep -v '^#' "$1" | tail -n +2; }

# ---- claims against Hertz's duration of an impact: closed form, not used by the search ----

hertz=$cases/2-hertz/hertz-impact.md
run 0 advise "$hertz" --set pair=equal --set h=0.04 --quantity impact.duration --within '0.05 %' -o duration &&
  said 'the cheapest setting within the tolerance: --set refine=' && said "to run it: nineball run $hertz"
result $? 'advice on the duration of an impact'

chosen=$(rows duration/advice.tsv | awk -F '\t' '$10 == "chosen" { print $3 }')
before=$(rows duration/advice.tsv | awk -F '\t' -v chosen="$chosen" '$3 == chosen / 2 { print $3, 100 * $8 }')
run 0 advise "$hertz" --set pair=equal --set h=0.04 --quantity impact.duration --within '0.05 %' -o again &&
  grep -A 1 "the next cheaper setting misses the tolerance: --set refine=${before% *}\$" "$why" |
    awk -v claim="${before#* }" '/ estimated error: / { d = $3 / claim - 1; found = d * d < 0.01 } END { exit !found }'
result $? 'the next cheaper setting and its error'

# The claim of each setting and its true error at eight phases of the first touch.
rows duration/advice.tsv | cut -f 3,8,10 >settings
: >errors
while read -r refine claim verdict; do
  for phase in 0 0.125 0.25 0.375 0.5 0.625 0.75 0.875; do
    sed "s/^impact .*/& phase $phase/" "$hertz" >phased.md
    "$nineball" run phased.md --set pair=equal --set h=0.04 --set "refine=$refine" -o run >/dev/null 2>&1
    grep -v '^#' run/values.tsv | awk -F '\t' -v refine="$refine" -v claim="$claim" -v verdict="$verdict" '
      NR == 1 { for (k = 1; k <= NF; k++) { if ($k == "impact.duration/s") a = k; if ($k == "reference impact.duration/s") b = k } }
      NR == 2 { e = $a / $b - 1; print refine, claim, verdict, e < 0 ? -e : e }' >>errors
  done
done <settings
cp errors "$why"
awk '{ n++; bad += !($2 >= $4) } END { exit !(n >= 32 && bad == 0) }' errors
result $? 'every claim is at least the true error, at eight phases'
awk '$3 == "chosen" { n++; bad += !($4 <= 0.0005) } $3 == "misses" { worst[$1] = worst[$1] > $4 ? worst[$1] : $4 }
  END { exit !(n == 8 && bad == 0) }' errors
result $? 'the chosen setting is within the tolerance'
# The choice is not much more expensive than the best one either: the cheapest setting whose true error is within the tolerance is
# at most twice as coarse.
awk '{ worst[$1] = worst[$1] > $4 ? worst[$1] : $4 } $3 == "chosen" { chosen = $1 }
  END { for (r in worst) if (worst[r] <= 0.0005 && r + 0 < chosen / 2) exit 1; exit !(chosen > 0) }' errors
result $? 'the chosen step is at least half as long as the longest one that is within the tolerance'
test -s duration/advice.svg && test -s duration/advice.png && grep -q '^plot \$variant0 using 5:' duration/advice.gp &&
  grep -q "title 'the advice'" duration/advice.gp && grep -q "^     0.05 with lines .* title 'tolerance'" duration/advice.gp &&
  test "$(sed -n '/^\$variant0 /,/^EOD/p' duration/advice.gp | grep -c '^hertz')" -eq "$(rows duration/advice.tsv | wc -l)"
result $? 'the figure'
rows duration/advice.tsv | awk -F '\t' '$10 == "chosen" { chosen = $5 } $10 == "within" && $5 < best { best = $5 } BEGIN { best = 1e99 }
  END { exit !(chosen > 0 && chosen <= best) }'
result $? 'no setting within the tolerance has fewer updates'

# ---- laws ----

# The shear laws differ in an oblique impact. `shear none` agrees with a reference that neglects friction, but not with
# the limit of the page.
oblique=$cases/4-oblique/oblique-impact.md
run 0 advise "$oblique" --set poisson=0.3 --set psi1=2 --quantity impact.psi2 --within 0.01 -o oblique &&
  said "$(grep -c '^# left out: .* times the tolerance' oblique/advice.tsv) other variants give values that differ too much; the one with the smallest difference is normal hertz"
result $? 'advice on an oblique impact'
cp oblique/advice.tsv "$why"
grep -q '^# left out: normal hertz, shear none: ' oblique/advice.tsv &&
  grep -q '^# left out: normal hertz, shear mindlin: its value differs from that of the page by .* times the tolerance' oblique/advice.tsv &&
  ! rows oblique/advice.tsv | cut -f 2 | grep -qxE 'none|mindlin'
result $? 'laws with other values are left out'
# A law that needs the same number of updates may need less memory, so it is tried at the step that the law of the page needs.
run 0 advise "$oblique" --set poisson=0.3 --set psi1=3.7 --quantity impact.psi2 --within '6 %' -o late
rows late/advice.tsv | cut -f 2,3,10 | tee "$why" |
  awk '$1 == "mindlin_deresiewicz" && $3 != "misses" { own = $2 } $1 == "mindlin" { other[$2] = 1 } END { exit !(own && own in other) }'
result $? 'another law is tried at the same step'
# The advice names the laws, and the options for them if they are not those of the page.
for within in '6 %' '20 %'; do
  run 0 advise "$oblique" --set poisson=0.3 --set psi1=3.7 --quantity impact.psi2 --within "$within" -o named
  rows named/advice.tsv | awk -F '\t' '$10 == "chosen" { print $1, $2, $3 }' >named/chosen
  read -r normal shear refine <named/chosen
  options="--set normal=$normal --set shear=$shear --set refine=$refine" laws="; normal $normal, shear $shear"
  test "$shear" = mindlin_deresiewicz && options="--set refine=$refine" laws="$laws, as in the page"
  grep -qx "  the cheapest setting within the tolerance: $options" "$why" && grep -q "$laws\$" "$why"
  result $? "the laws of the advice within $within"
done
cat >head-on.md <<'EOF'
# Two spheres that collide head-on

```scene
units none
material m density 1 young 1000 poisson 0.3 friction 0.5
normal hertz
sphere 0 0 radius 1 m velocity 0.1 0
sphere 2.1 0 radius 1 m fixed
monitor C sphere 1 with sphere 2
record C.normal
step 0.01
stage a
until C.normal above 0 at most 100000 cycles
stage b
until C.normal below 1e-300 at most 100000 cycles
```
EOF
run 0 advise head-on.md --quantity 'C.normal max in b' --within '5 %' -o head-on &&
  grep -qx '  [0-9]* other variants give the same values as another variant' "$why" &&
  grep -qxF '  (a variant is the page with other contact laws, softer contacts, centred dashpots, or other values of the names in its `trade` statements)' "$why" &&
  test "$(rows head-on/advice.tsv | cut -f 1,2 | sort -u | wc -l)" -eq 2
result $? 'laws that change nothing are not tried'

# ---- the command ----

run 0 advise "$hertz" --set pair=equal --set h=0.04 --set refine=4 --quantity impact.duration --within '0.05 %' -o refined
refined=$(rows refined/advice.tsv | awk -F '\t' '$10 == "chosen" { print $3 }')
test -n "$refined" && test "$refined" = "$(rows duration/advice.tsv | awk -F '\t' '$10 == "chosen" { print $3 }')"
result $? 'the advice does not depend on the step of the page'
run 0 advise "$hertz" --set pair=equal --set h=0.04 --within '5 %' && test -s hertz-impact.out/advice.tsv && said 'C.overlap in strike within 5 %'
result $? 'by default the first expectation and the folder of the page'
run 0 advise "$hertz" --set pair=equal --set h=0.04 --quantity 'C.normal max in strike' --within '20 N' -o newton && said 'estimated error: at most' && said ' N'
result $? 'a tolerance in the unit of the quantity'
run 1 advise "$hertz" --set pair=equal --set h=0.04 --quantity impact.duration --within '0.05 %' --budget 1e-6 -o small && said 'choose a larger --budget'
result $? 'a budget that is too small'
cat >still.md <<'EOF'
# A quantity near 0

```scene
units none
material m density 1 kn 1
disc 0 0 radius 1 m velocity 0.1 0
disc 2.5 0 radius 1 m fixed
monitor D disc 1
record D.vx D.vy
step 0.01
stage a
until D.vx below 0 at most 100000 cycles
```
EOF
run 1 advise still.md --quantity D.vy --within '1 %' && said 'is not known well enough' && said 'an absolute tolerance if the value is near 0'
result $? 'a percentage of a quantity whose limit is 0'
sed 's/^record .*/& energy.balance/' still.md >residual.md
run 2 advise residual.md --quantity energy.balance --within '1 %' && said 'expected an absolute tolerance, because the reference value is 0'
result $? 'a percentage of a residual'
run 1 advise "$cases/5-numerics/changed-law.md" --quantity 'C.normal max in steps' --within '10 %' && said 'the value is 0, and a percentage of 0 allows no error' &&
  ! grep -q nan "$why"
result $? 'a percentage of a quantity that is 0 with each step'
sed 's/^disc 0 0 .*/disc 0 0 radius 1 m velocity 0.1 $vy/; s/^units none/&\nsweep vy 0 0.01/' still.md >still-swept.md
run 1 advise still-swept.md --quantity D.vy --within '1 %' && said 'the value is 0, and a percentage of 0 allows no error, in run vy=0'
result $? 'a percentage of a quantity that is 0 in the first run of a sweep'
run 0 advise still.md --quantity D.vx --within 0.1 && said 'within 0.1'
result $? 'an absolute tolerance'
# The whole output of a call. The numbers follow from the table: `chosen` is its row, and the next cheaper setting is that with the most
# updates below it. Times are not compared.
cat >si.md <<'EOF'
# Two discs that collide at two speeds

```scene
sweep     v  0.1 m/s 0.2 m/s
let       k = 1 N/m
trade     k 2 N/m
trade     laws none
material  m  density 1 kg/m3  kn $k
disc      0 m 0 m  radius 1 m  m  velocity $v 0 m/s
disc      2.1 m 0 m  radius 1 m  m  fixed
monitor   D  disc 1
record    D.x
step      0.1 s
stage     a
until     D.x above 0.2 m at most 100000 cycles
```
EOF
whole() { sed 's/^  time: .* s (.* to .*) instead of .* s (.* to .*), median and range of 5 runs on .*/  time/; s/^  [0-9]* trials in .* s$/  trials/; /^status /d' "$why"; }
run 0 advise si.md --quantity 'D.x max' --within '2 %' -o si --jobs 1 && whole >given && sed -n '/ trials in /s/ in .*//p' "$why" >trials
rows si/advice.tsv | awk -F '\t' -v quote="'" '
  { row[NR] = $0; updates[NR] = $5 }
  $10 == "chosen" { c = NR }
  $3 == 1 && $12 == "-" { own = $5 }
  END {
    split(row[c], a)
    for (k in row) if (updates[k] < a[5] && !(updates[k] < updates[n])) n = k
    split(row[n], b)
    print "si: D.x max within 2 %\n  the cheapest setting within the tolerance: --set refine=" a[3]
    printf "    the step (%.3g s) is %d times as short as that of the page; normal linear, shear none, as in the page\n", a[4], a[3]
    printf "  estimated error: at most %.2g %%, in run %s; by the step alone %.2g %%\n", 100*a[8], a[11], 100*a[9]
    printf "  cost: %.0f recorded values and %.0f contact and particle updates in all 2 runs of the page, ", a[13], a[5]
    printf "%.3g %% of the %.0f with the page%ss own setting\n  time\n", 100*a[5]/own, own, quote
    printf "  the next cheaper setting misses the tolerance: --set %s%s%s --set refine=%s\n", quote, b[12], quote, b[3]
    printf "    estimated error: %.2g %%, in run %s; by the step alone %.2g %%\n", 100*b[8], b[11], 100*b[9]
    print "to run it: nineball run si.md --set refine=" a[3]
    print "  this holds for the 2 runs of the page; with other values another setting may be the cheapest\n  trials"
    print "look at si/advice.svg; all settings that were tried are in si/advice.tsv"
  }' | diff -u - given >"$why" && grep -q 'set .k=2 N/m. --set refine=4$' given && grep -q 'refine=8$' given
result $? 'the whole output of a call'
# Each trial counts, whether it ran alone or beside others.
run 0 advise si.md --quantity 'D.x max' --within '2 %' --jobs 4 && sed -n '/ trials in /s/ in .*//p' "$why" >given && diff -u trials given >"$why" && test -s trials
result $? 'the number of trials does not depend on --jobs'
{ sed 's/^# page .*/# page/; 6,$d' si/advice.tsv && sed '1,/^\$chosen/d' si/advice.gp | sed '1,/^EOD/d'; } | diff -u - /dev/fd/3 >"$why" 3<<EOF
# nineball $("$nineball" --version | sed -n 's/^nineball //p')
# page
# D.x max within 2 %
# updates with the page's own setting: $(rows si/advice.tsv | awk -F '\t' '$3 == 1 && $12 == "-" { print $5 }')
normal	shear	refine	mean-step	updates	seconds	error/tolerance	error	error-of-step	result	worst-run	values	recorded
set datafile separator tab
set logscale xy
set format xy '10^{%T}'
set xrange [$(rows si/advice.tsv | cut -f 5 | sort -g | awk '{ u[NR] = $1 } END { printf "%.9g:%.9g", u[1]/2, 2*u[NR] }')]
set title 'D.x max within 2 %' noenhanced
set xlabel 'contact and particle updates of all runs'
set ylabel 'estimated error, %'
plot \$variant0 using 5:(\$8*100) with linespoints pt 7 lw 2 title 'normal linear, shear none' noenhanced, \\
     \$variant1 using 5:(\$8*100) with linespoints pt 7 lw 2 title 'normal linear, shear none, k=2 N/m' noenhanced, \\
     \$chosen using 5:(\$8*100) with points pt 6 ps 3 lw 2 lc rgb '#a3123a' title 'the advice', \\
     2 with lines dt 2 lc rgb 'black' title 'tolerance'
EOF
result $? 'the whole table and the whole figure'
# Values of k that the page refuses, that change nothing, and that change D.x max = 0.1 + v (m/k)^(1/2) by more than the tolerance; with
# 0.2 it is 0.1 (pi/0.2)^(1/2) + 0.1, that is 0.219/0.277 more than with 1, or 40 times the tolerance.
for values in '-1:1 other variant cannot be run with this page;' '1.0:1 other variant gives the same values as another variant;' \
  '-1 -2 1.0 0.1 0.2:1 other variant gives the same values as another variant;2 other variants cannot be run with this page;2 other variants give values that differ too much; the one with the smallest difference is normal linear, shear none, k=0.2 N/m: its value differs from that of the page by 40 times the tolerance;' \
  '0.2:1 other variant gives values that differ too much; the one with the smallest difference is normal linear, shear none, k=0.2 N/m: its value differs from that of the page by 40 times the tolerance;'; do
  sed "s,^trade  *k.*,trade k $(echo "${values%%:*}" | sed 's, , N/m ,g') N/m,; s,^sweep.*,let v = 0.1 m/s,; s,above 0.2 m,below 0.1 m and D.vx below 0 m/s," si.md >left.md
  run 0 advise left.md --quantity 'D.x max' --within '2 %' -o left
  { echo "${values#*:}" | sed 's/;$//; s/;\([0-9]\)/\n\1/g; s/^\|\n/&  /g'
    echo '  (a variant is the page with other contact laws, softer contacts, centred dashpots, or other values of the names in its `trade` statements)'; } >wanted
  sed -n '/^  [0-9] other variant/p; /^  (a variant/p' "$why" | diff -u - wanted >given
  sed -n 's/^# left out: normal linear, shear none, k=\([^:]*\): \(it gives the same.*\)*.*/\1 \2/p' left/advice.tsv >>given
  case $values in # the table has a row for each of them
  1.0:*) echo '1.0 N/m it gives the same values as the page' ;;
  -1\ *) printf '%s\n' '-1 N/m ' '-2 N/m ' '1.0 N/m it gives the same values as the page' '0.1 N/m ' '0.2 N/m ' ;;
  *) echo "${values%%:*} N/m " ;;
  esac | diff -u - given >>"$why"
  result $? "variants that are left out: k ${values%%:*}"
done
run 1 advise si.md --quantity 'D.x max' --within '1e-9 m' --set v='0.1 m/s' -o si &&
  sed 's/[0-9.e+]* times the/N times the/; /^status/d' "$why" >given && diff -u - given >"$why" <<'EOF'
si.md: error: `D.x max within 1e-9 m`: the value is not known well enough: with the step divided by 4096 its uncertainty is N times the tolerance. Choose a larger tolerance, an absolute tolerance if the value is near 0, or a larger --budget
EOF
result $? 'the whole message about a value that is not known well enough'
# The run that is named is that with the largest uncertainty, over the tolerance: at ten times the speed a step moves the disc ten times as
# far. So is the run in which a variant differs most: D.x max = 0.1 + v (m/k)^(1/2), so a percentage is exceeded more with the larger v.
for speeds in '0.02 m/s 0.2 m/s' '0.2 m/s 0.02 m/s'; do
  sed "s,^sweep.*,sweep v $speeds,; s/^trade  *k.*/trade k 0.2 N\/m/; s,above 0.2 m,below 0.1 m and D.vx below 0 m/s," si.md >decides.md
  run 1 advise decides.md --quantity 'D.x max' --within '1e-15 m' --budget 0.5 -o decides && said ' times the tolerance, in run v=0.2 m/s. Choose a larger tolerance' &&
    run 0 advise decides.md --quantity 'D.x max' --within '2 %' -o decides &&
    grep -Eq ', k=0.2 N/m: its value differs from that of the page by [0-9]* times the tolerance, in run v=0.2 m/s$' "$why"
  result $? "the run that decides: speeds $speeds"
done
# Each setting misses the tolerance or is within it, and its error is this ratio times the tolerance.
for table in duration:0.0005 late:0.06 si:0.02; do
  rows ${table%:*}/advice.tsv | tee "$why" | awk -F '\t' -v tolerance="${table#*:}" '
    { d = $8/($7*tolerance) - 1; bad += d*d > 1e-9 || $9 > $8 || ($10 == "misses") != ($7 > 1); n[$10]++ }
    END { exit !(n["chosen"] == 1 && n["misses"] && !bad && NR == n["chosen"] + n["misses"] + n["within"]) }'
  result $? "errors, and their ratios to the tolerance: ${table%:*}"
done
run 1 advise still.md --quantity D.vx --within 1e-5 --set trade='laws none' --set step=0.2 -o none &&
  whole | sed 's/\([ =]\)[0-9][0-9.e+-]*/\1N/g' >given && diff -u - given >"$why" <<'EOF'
still: D.vx within N
  no setting that was tried is within the tolerance
  the most accurate one: --set refine=N
    estimated error: N; by the step alone N
  choose a larger tolerance
  trials
look at none/advice.svg; all settings that were tried are in none/advice.tsv
EOF
result $? 'the whole output of a call without advice'
run 2 advise still.md --within '1 %' && said 'name a quantity that it records, by --quantity'
result $? 'a page that expects nothing'
run 2 advise "$hertz" && said '--within TOLERANCE'
result $? 'no tolerance'
run 2 advise "$hertz" --quantity C.force --within '1 %' && said 'quantity: error: expected a quantity that the page records, found `C.force`'
result $? 'an unknown quantity'
run 2 advise "$hertz" --quantity impact.duration --within '1 % x' && said 'expected the end of the text'
result $? 'text after the tolerance'
run 2 advise "$hertz" --quantity impact.duration --within '1 % of impact.duration' && said 'expected a tolerance like `1 %`'
result $? 'a fraction of a quantity'
run 2 advise "$hertz" --quantity impact.duration --within '0 %' && said 'expected a tolerance above 0'
result $? 'a tolerance of 0'
run 2 advise "$hertz" --quantity impact.duration --within '1 % of peak' && said 'expected a tolerance like `1 %`'
result $? 'a fraction of something else'
run 2 advise "$cases/7-assemblies/thesis-isotropic-compression.md" --within '1 %' && said 'expected a page of at most 50 particles'
result $? 'an assembly'
run 1 advise "$pages/too-long-a-step.md" --quantity D.x --within '1 %'
said 'the page cannot be run with its own step and with half of it: ' && said 'because further contacts make it shorter'
result $? 'a step above the stable one: the whole message'
run 2 advise "$hertz" --quantity impact.duration --within '1 %' --budget never && said 'with --budget a number of seconds above 0'
result $? 'a budget that is not a time'
for budget in '1e-6 s:1' 1e-6s:1 1e-6:1 :2 s:2 '5 x:2' '5 s x:2' inf:2 nan:2 -1:2 0:2; do
  run "${budget##*:}" advise still.md --quantity D.vx --within 0.1 --budget "${budget%:*}" -o budget && case $budget in *:1) said 'the budget is too small' ;; *) said 'with --budget a number of seconds above 0' ;; esac
  result $? "the budget '${budget%:*}'"
done
# 500 combinations, which run up to 500 times as many cycles as the page. A budget of a second is enough for the page, not for all of them.
awk '/^until/ { $0 = "cycles $all" } { print } /^units/ { print "trade laws none"; for (k = 1; k <= 3; k++) print "let n" k " = 1"
  print "trade n1 2 3 4 5 6 7 8 9 10"; print "trade n2 2 3 4 5 6 7 8 9 10"; print "trade n3 2 3 4 5"; print "let all = 1000*n1*n2*n3" }' still.md >ends.md
run 0 advise ends.md --quantity D.vx --within 0.1 --budget 1 -o ends && grep -Eqx '  [0-9]+ other variants have no result, because the budget was used up' "$why" &&
  grep -q '^  (a variant is the page with' "$why" && grep -Eqx '  [0-9]+ trials in [0-9.]+ s, the whole budget: not all settings were tried' "$why"
result $? 'a budget that ends the search'
# Without --quantity the first expectation with a single value counts: not a curve, and not a line `report`.
{ sed 's/^record .*/& D.x time/' still.md && printf '\n```expect\nreport D.x\nD.vy expected 0 within 0.4 [x]\nD.vx expected 0 within 0.4 [x]\n```\n'; } >first.md
run 0 advise first.md --within 0.1 -o first && said 'first: D.vy within 0.1'
result $? 'the first expectation with a single value'
sed 's/^units none/&\nlet refine = 2/' still.md >named.md
run 2 advise named.md --quantity D.vx --within 0.1 && said 'the page has a value named `refine`'
result $? 'a page whose own value is called refine'
sed 's/^until.*/record every 10 cycles\ncycles 7/; s/kn 1$/kn 1e-6/' still.md >cycles.md
run 0 advise cycles.md --quantity D.vx --within '1 %' -o cycles && said '--set refine=0.1428571429' && said '7 times as long as that of the page' &&
  said 'the next longer step cannot be run: a longer step does not divide the stages of the page into whole numbers of cycles' &&
  run 0 run cycles.md --set refine=0.1428571429 -o cycles && said '  1 cycles, '
result $? 'a page with a number of cycles that is not a power of two'
# Linear springs that are 1000 times as soft allow 1000^(1/2) = 32 times the step, if the quantity does not depend on the springs.
sed 's/^until.*/until time above 1 at most 100000 cycles/; s/kn 1$/kn 1e4/' still.md >soft.md
run 0 advise soft.md --quantity D.vx --within '1 %' -o soft && said 'the cheapest setting within the tolerance: --set soften=1000 --set refine=' &&
  said 'stiffness divided by 1000' && grep -q '^# not run: refine=0.0078125: particle 1 .* the step 1.28 is above the guaranteed stable one' soft/advice.tsv
result $? 'softer contacts'
# A page whose springs are divided by 4 already: its springs are divided by 1000 once more, and the command gives one value.
run 0 advise soft.md --set soften=4 --quantity D.vx --within '1 %' -o soft && said 'the cheapest setting within the tolerance: --set soften=4000 --set refine=' &&
  said 'stiffness divided by 1000' && said 'to run it: nineball run soft.md --set soften=4000 --set refine='
result $? 'softer contacts of a page that is softened'
run 0 advise "$hertz" --set pair=equal --set 'step=100 per collision' --quantity impact.duration --within '1 %' -o soft &&
  said '  softer contacts save nothing in this impact: the step is a fraction of the duration of the collision, and both grow by the same factor' && ! grep -q 'divided by' soft/advice.tsv
result $? 'softer contacts save nothing in an impact'
run 0 advise "$cases/2-hertz/hertz-damped.md" --set beta=0.2 --quantity impact.restitution --within '0.2 %' -o damped && said '--set damping=centred --set refine='
options=$(sed -n 's/.*to run it: .* --set beta=0.2 //p' "$why")
run 0 run "$cases/2-hertz/hertz-damped.md" --set beta=0.2 $options -o damped
grep -v '^#' damped/values.tsv | tee "$why" | awk -F '\t' '
  NR == 1 { for (k = 1; k <= NF; k++) { if ($k == "impact.restitution/-") a = k; if ($k == "reference impact.restitution/-") b = k } }
  NR == 2 { e = $a/$b - 1; good = e*e < 0.002^2 } END { exit !good }' && test -n "$options"
result $? 'centred dashpots'
run 0 advise "$cases/2-hertz/hertz-damped.md" --set beta=0.2 --quantity impact.restitution --within '0.2 %' -o damped && grep -q '^    the step.*; normal hertz, shear none, damping centred$' "$why" &&
  run 0 advise "$oblique" --set poisson=0.3 --set psi1=2 --quantity impact.psi2 --within 0.01 -o oblique && grep -Eq '^  estimated error: at most [0-9.e-]+; by the step alone [0-9.e-]+$' "$why"
result $? 'the name of centred dashpots, and an error without a unit'
run 2 check still.md --within 1 && said "does not use --within"
result $? 'an option of another command'

# ---- traded values, and means over realizations ----

cat >gas.md <<'EOF'
# Discs in a periodic cell that shrinks

```scene
units none
sweep seed 1 2 3
let rate = 0.01
let dt = 0.004
trade rate 0.02 0.005
material m density 1 kn 1000 ks 500 friction 0.5
normal linear
shear linear
periodic cell 0 0 to 9 9
grading g 1 6 0.7 8
fill discs cell g m seed $seed attempts 10000 else skip
region A all
record energy.kinetic A.porosity
step $dt
stage a
cell strain (-rate) -0.01
until time above 2 at most 100000 cycles
```
EOF
run 0 advise gas.md --over seed --quantity energy.kinetic --within '10 %' -o gas && whole | sed 's/\([ (=]\)[0-9][0-9.e-]*/\1N/g' >given &&
  diff -u - given >"$why" <<'EOF'
gas: energy.kinetic within N %
  the cheapest setting within the tolerance: --set refine=N
    the step (N) is N times as long as that of the page; normal linear, shear linear, as in the page
  estimated error: at most N %; difference of the means N %
  cost: N recorded values and N contact and particle updates for a realization, N % of the N with the page's own setting
  time
  the next cheaper setting misses the tolerance: --set rate=N --set refine=N
    estimated error: N %; difference of the means N %
to run it: nineball run gas.md --set refine=N
  checks of the page that have tighter tolerances may fail then
  this holds for the mean over realizations (seed = N to N), with N % confidence; a single run is not covered, since runs scatter with a standard deviation of N
  this holds for this page alone; with other values another setting may be the cheapest
  trials
look at gas/advice.svg; all settings that were tried are in gas/advice.tsv
EOF
result $? 'the whole advice on a mean over realizations'
run 0 advise gas.md --over seed --quantity energy.kinetic --within '10 %' -o gas &&
  said 'this holds for the mean over realizations (seed = 1 to 8), with 95 % confidence; a single run is not covered, since runs scatter with a standard deviation of 0.0'
result $? 'advice on a mean over realizations'
cp gas/advice.tsv "$why"
grep -qx '# energy.kinetic within 10 %, mean over seed = 1 to 8' gas/advice.tsv &&
  test "$(rows gas/advice.tsv | cut -f 12 | sort -u | tr '\n' ' ')" = '- rate=0.005 rate=0.02 ' &&
  test "$(rows gas/advice.tsv | cut -f 1,2 | sort -u)" = "$(printf 'linear\tlinear')"
result $? 'traded values are tried, laws are not'
# The table has the relative difference between the mean of a setting and the mean of the page with half its step. Single runs
# with these settings must give the same difference.
rows gas/advice.tsv | awk -F '\t' '$12 == "rate=0.02" { print $3, $9 }' | head -n 1 >setting
mean() {
  for seed in 1 2 3 4 5 6 7 8; do
    "$nineball" run gas.md --set "seed=$seed" "$@" -o run >/dev/null 2>&1
    rows=$(grep -v '^#' run/table.tsv | sed -n '1p;$p')
    echo "$rows" | awk -F '\t' 'NR == 1 { while ($++k !~ /^energy/); } NR == 2 { print $k }'
  done | awk '{ sum += $1 } END { printf "%.17g\n", sum / NR }'
}
read -r refine difference <setting
echo "$(mean --set refine=2) $(mean --set rate=0.02 --set "refine=$refine") $difference" >"$why"
awk '{ d = ($2 - $1) / $1; d = d < 0 ? -d : d; exit !($3 > 0.001 && d / $3 > 0.999 && d / $3 < 1.001) }' "$why"
result $? 'the difference of the means'
run 0 advise gas.md --over seed --realizations 12 --set trade='rate 0.04' --quantity energy.kinetic --within '10 %' -o set &&
  said '(seed = 1 to 12)' && rows set/advice.tsv | cut -f 12 >"$why" && grep -qx rate=0.04 "$why" && grep -qx rate=0.02 "$why"
result $? 'a trade on the command line adds to those of the page'
run 0 advise gas.md --set seed=1 --set trade='laws none' --quantity A.porosity --within '1 %' -o time &&
  sed -n 's/^  time: \(.*\) s (\(.*\) to \(.*\)) instead of \(.*\) s (\(.*\) to \(.*\)), median and range of 5 runs on .*/\1 \2 \3 \4 \5 \6/p' "$why" >times
cat times >>"$why"
awk '{ good = NF == 6 && 0 < $2 && $2 <= $1 && $1 <= $3 && 0 < $5 && $5 <= $4 && $4 <= $6 } END { exit !good }' times
result $? 'times, median and range'
# If five runs of both settings would take longer than 5 s, the times are those of the trials. The advice needs a hundredth of the cycles. On a
# machine that is fast enough the two are run five times.
cat >slow.md <<'EOF'
# A long flight

```scene
units none
trade laws none
material m density 1 kn 1
disc 0 0 radius 1 m velocity 0.01 0
disc 2.5 0 radius 1 m fixed
monitor D disc 1
record D.vx
step 1e-7
stage a
record every 12800 cycles
cycles 19660800
```
EOF
run 0 advise slow.md --quantity D.vx --within '2 %' --budget 600 -o slow &&
  sed -n 's/^  time: \([0-9.e-]*\) s.* instead of \([0-9.e-]*\) s\(.*\)/\1 \2\3/p' "$why" >times &&
  awk '{ good = $1 < $2/3 && (/, the shortest of the trials$/ ? 5*($1 + $2) > 5 : 5*($1 + $2) < 10) } END { exit !good }' times
result $? 'times of the trials'
run 0 advise gas.md --over seed --set trade='dt 0.016' --quantity energy.kinetic --within '500 %' -o longer &&
  cut -f 3,12 longer/advice.tsv >"$why" && grep -qx "0.25	-" "$why" && grep -qx "1	dt=0.016" "$why" &&
  grep -q '^# not run: refine=0.125: its step is .* of the guaranteed stable step in the mean, and this ratio scatters between realizations: another realization may be aborted$' longer/advice.tsv
result $? 'a variant that needs a shorter step than the page is tried with it'
run 0 advise gas.md --over seed --set dt=0.002 --quantity energy.kinetic --within '10 %' -o own && said 'nineball run gas.md --set dt=0.002 --set refine='
result $? 'the command to run has the settings of the caller'
run 1 advise gas.md --over seed --quantity energy.kinetic --within '0.001 %' &&
  grep -q '^gas.md: error: `energy.kinetic within 0.001 %`: the mean over 8 realizations is not known well enough: the mean with half the step differs from it by up to [0-9.e+]* times the tolerance. Choose more --realizations, at most 32, or a larger tolerance$' "$why"
result $? 'a mean that is not known well enough'
run 2 advise gas.md --over seed --set seed=2 --quantity energy.kinetic --within '10 %' && said '--over seed and --set seed=2 exclude each other'
result $? 'realizations of one seed'
run 2 advise gas.md --over sead --quantity energy.kinetic --within '10 %' && said 'did you mean `seed`?'
result $? 'realizations of an unknown name'
run 2 advise gas.md --over see --set seed=2 --quantity energy.kinetic --within '10 %' && said 'expected after --over a name that the page defines'
result $? 'realizations of the beginning of a name'
grep -q "^set xlabel 'contact and particle updates of all runs, mean over realizations'" gas/advice.gp
result $? 'the figure of a mean'
sed "s,^sweep.*,let seed = 1\nlet v = (0.1 m/s * seed)," si.md >mean.md
run 0 advise mean.md --over seed --quantity 'D.x max' --within '90 %' -o mean && grep -Eq ' runs scatter with a standard deviation of [0-9.e-]+ m$' "$why"
result $? 'the unit of the standard deviation'
run 2 advise gas.md --over seed --realizations 4 --quantity energy.kinetic --within '10 %' && said 'expected --realizations from 8 to 32' &&
  run 2 advise gas.md --over seed --realizations 33 --quantity energy.kinetic --within '10 %' && said 'expected --realizations from 8 to 32' &&
  run 1 advise gas.md --over seed --realizations 32 --quantity energy.kinetic --within '10 %' --budget 1e-6 && said 'the budget is too small' &&
  run 2 advise gas.md --realizations 9 --quantity energy.kinetic --within '10 %' && said 'with --over NAME'
result $? 'too few realizations'
sed 's/^let rate/let stiff = 1000\n&/; s/kn 1000/kn $stiff/; s/^trade .*/trade stiff 1000 500/' gas.md >soft.md
run 0 advise soft.md --set seed=1 --quantity energy.kinetic --within '20 %' -o soft && said 'other variants give the same values as another variant' &&
  rows soft/advice.tsv | cut -f 12 | grep -qx stiff=500
result $? 'a traded value of a single run; that of the page itself is left out'
sed 's/^trade .*/trade laws none/' gas.md >no-laws.md
run 0 advise no-laws.md --set seed=1 --quantity A.porosity --within '1 %' -o no-laws && test "$(rows no-laws/advice.tsv | cut -f 1,2 | sort -u | wc -l)" -eq 1
result $? 'a page that does not trade its laws'
many='trade rate 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16'
for names in 'a b' 'a b c d e f g h i'; do
  awk -v names="$names" -v many="$many" '/^trade/ { n = split(names, name, " "); for (k = 1; k <= n; k++) { print "let", name[k], "= 1"
    row = many; sub("rate", name[k], row); if (n > 2) row = "trade " name[k] " 2"; print row } next } { print }' gas.md >many.md
  run 2 advise many.md --set seed=1 --quantity A.porosity --within '1 %' && said 'expected at most 8 statements `trade` and 500 combinations' || break
done
result $? 'too many combinations'

# ---- many pages ----

mkdir -p folder/below
cp "$cases/2-hertz/hertz-impact.md" folder/below/b.md
sed 's/^units none/&\nsweep speed 0.1 0.2 0.3/; s/velocity 0.1 0/velocity $speed 0/; s/^record .*/record time D.x D.vx D.vy/; s/^until .*/until time above 5 at most 100000 cycles/; s/^# .*/# A page/' still.md >folder/a.md
printf '\n```expect\nD.vx expected 0 within 0.4 [x]\ntime expected 9 within 99 [x]\nD.x max in a expected 0.7 within 10 %% [x]\nD.vy expected 0 within 0.05 [x]\nD.vx expected 0 within 0.3 [x]\n```\n' >>folder/a.md
echo '# No page' >folder/README.md
printf '# Wrong\n```scene\nunits none\nnonsense\n```\n' >wrong.md
column() { rows "$1" | cut -f "$2"; }

run 1 advise --all folder/a.md still.md -o all && said '1 of 2, a: 8 searches, 7 with advice; about ' && said '2 of 2, still: 0 searches' &&
  said 'still has no expectation of a single value' && said '8 searches, 7 with advice; look at all/trades.tsv'
result $? 'advice on many pages'
cp all/trades.tsv "$why"
head -n 1 all/trades.tsv | grep -q '^# nineball .*, advise --all$' && test "$(grep -v '^#' all/trades.tsv | head -n 1 | tr '\t' '|')" = \
  'page|hash|condition|over|kind|quantity|tolerance|result|setting|cost|updates|seconds|error|unit|next|next error/tolerance|order|normal|shear|laws enough|laws not enough|search seconds' &&
  test "$(awk -F '\t' '!/^#/ { print NF }' all/trades.tsv | sort -u)" = 22 &&
  test "$(column all/trades.tsv 1 | sort -u)" = folder/a.md && test "$(column all/trades.tsv 3 | sort -u)" = speed=0.2
result $? 'one row for each search, at the middle run'
test "$(rows all/trades.tsv | cut -f 5-8 | tr '\t\n' '|;')" = \
  'until|D.vx|10 %|yes;until|D.vx|1 %|yes;until|D.vx|0.1 %|yes;extreme|D.x max in a|10 %|yes;extreme|D.x max in a|1 %|yes;extreme|D.x max in a|0.1 %|yes;until|D.vy|10 %|unknown;until|D.vy|0.05|yes;'
result $? 'quantities and tolerances'
# Each row equals the advice of a single search.
rows all/trades.tsv | cut -f 6,7,9,11,13,15,16 | while IFS='	' read -r measure tolerance setting updates error cheaper ratio; do
  case $setting in --set*) ;; *) continue ;; esac
  run 0 advise folder/a.md --set speed=0.2 --quantity "$measure" --within "$tolerance" -o one
  rows one/advice.tsv | awk -F '\t' -v setting="${setting##*refine=}" -v updates="$updates" -v error="$error" -v cheaper="${cheaper##*refine=}" -v ratio="$ratio" '
    $10 == "chosen" { good = $3 == setting && $5 == updates && $8 - error <= 1e-5*error && error - $8 <= 1e-5*error }
    $3 == cheaper && $10 == "misses" { next_good = $7 - ratio < 1e-5*ratio && ratio - $7 < 1e-5*ratio }
    END { exit !(good && (next_good || cheaper == "-")) }' || echo "$measure within $tolerance"
done >differing
cp differing "$why"
test ! -s differing && awk -F '\t' '!/^#/ && $8 == "yes" { n++; cost[$6, $7] = $10; step += $10 <= 0 || $14 != ($7 ~ /%/ ? "%" : "1") } END { exit !(n == 7 && step == 0) }' all/trades.tsv
result $? 'every row is the advice of a search alone'
# Orders: the slope over the three finest steps of the table of the last search.
run 0 advise "$cases/1-two-discs/two-wall-compression.md" --set density=500 --quantity 'X.fx at 1 cycles' --within '0.01 %' -o slope
rows slope/advice.tsv | awk -F '\t' '$2 == "none" { e[++n] = $8; r[n] = $3 } END { print log(e[n-2]/e[n])/log(r[n]/r[n-2]) }' >order
run 0 advise --all "$cases/1-two-discs/two-wall-compression.md" --set density=500 --quantity 'X.fx at 1 cycles' --within ' 10 %;0.01 % ' -o orders &&
  test "$(rows orders/trades.tsv | wc -l)" -eq 2
result $? 'quantity and tolerances of the caller'
paste order orders/trades.tsv >"$why"
awk 'NR == FNR { slope = $1; next } { split($0, c, "\t") } c[7] == "0.01 %" { d = c[17]/slope - 1; good = d*d < 1e-4 && c[17] > 1 } END { exit !good }' order orders/trades.tsv &&
  rows orders/trades.tsv | awk -F '\t' '$7 == "0.01 %" { good = $18 == "linear" && $19 == "none" && $20 == "linear" && $21 == "-" && $3 == "density=500" } END { exit !good }'
result $? 'order of convergence, and the laws that are enough'
run 0 advise --all "$oblique" --set poisson=0.3 --set psi1=2 --quantity impact.psi2 --within 0.01 -o laws
rows laws/trades.tsv | cut -f 20,21 | tee "$why" | awk -F '\t' '$1 == "-" && (" " $2 " ") ~ / randall / && (" " $2 " ") ~ / mindlin / { good = 1 } END { exit !good }'
result $? 'the laws that are not enough'
if command -v gnuplot >/dev/null; then
  test -s all/a.svg && test -s all/a.png && grep -q 'D.vx within 0.1 %' all/a.svg && test ! -e all/still.svg
  result $? 'a figure of the first quantity of each page'
fi

# The last row is the search with the absolute tolerance; it follows a search whose value is near 0.
mkdir -p last
sed '$d' all/trades.tsv >last/trades.tsv
run 1 advise --all folder/a.md -o last
test "$(rows last/trades.tsv | cut -f 5-8)" = "$(rows all/trades.tsv | cut -f 5-8)"
result $? 'a later call continues one that was interrupted before the absolute tolerance'
# A table of a call that was interrupted in the fifth row.
mkdir cut
rows=$(wc -l <all/trades.tsv)
{ head -n 6 all/trades.tsv && sed -n '7s/\(.*yes\).*/\1/p' all/trades.tsv | tr -d '\n'; } >cut/trades.tsv
run 1 advise --all folder/a.md -o cut && said '8 searches, 7 with advice, 4 of them from an earlier call' &&
  test "$(wc -l <cut/trades.tsv)" -eq "$rows" && test "$(cut -f 1-11 cut/trades.tsv)" = "$(cut -f 1-11 all/trades.tsv)" &&
  test "$(head -n 6 cut/trades.tsv)" = "$(head -n 6 all/trades.tsv)"
result $? 'a later call continues an interrupted one'
echo >>folder/a.md
run 1 advise --all folder/a.md -o cut && said '8 searches, 7 with advice; look' && test "$(rows cut/trades.tsv | wc -l)" -eq 16
result $? 'a later call does not continue the table of a page that has changed'
echo mine >cut/trades.tsv
run 2 advise --all folder/a.md -o cut && said 'nineball: cut/trades.tsv is not a table that this version wrote: remove it, or choose another folder with -o' && test "$(cat cut/trades.tsv)" = mine
result $? 'another file is not overwritten'

# The kinds of quantities, at most three of each page. The budget is spent at once.
mkdir kinds
# kinds NAME STAGE EXPECTATION...
kinds() {
  page=kinds/$1.md
  printf '# A page\n\n```scene\nunits none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m velocity 1 2\ndisc 9 9 radius 1 m velocity 1 2\n' >"$page"
  printf 'monitor A disc 1\nmonitor B disc 2\nstep 0.1\nrecord time step cycle A.x A.y A.vx A.vy B.x energy.balance\nstage a\n%b\n```\n\n```expect\n' "$2" >>"$page"
  shift 2
  printf '%s\n' "$@" >>"$page"
  echo '```' >>"$page"
}
kinds 1 'cycles 9' 'A.x amplitude above 0' 'A.y min above 0' 'A.vx mean above 0'
kinds 2 'cycles 9' 'A.x frequency expected 0 within 9 [x]' 'A.y at 3 cycles above 0' 'A.vx at 0.35 above 0'
kinds 3 'cycles 9' 'A.x above 0' 'B.x above 0' 'A.y in a above 0' 'A.x max above 0' 'A.vy above 0'
kinds 4 'until A.x above 0.3 at most 9 cycles\nstage b\ncycles 9' 'time above 0' 'step above 0' 'report A.vx' 'energy.balance expected 0 within 1 [x]' 'A.x in a above 0' 'A.x above 0' 'A.vx above 0'
printf '# A path\n```contact-test\nunits none\nmaterial rock young 100 poisson 0 friction 1\ncontact sphere 1 rock with wall rock\nnormal hertz\nshear mindlin\nrecord shear normal\n' >kinds/5.md
printf 'segment p normal to 1 in 9 steps\nsegment s slip by 0.001 in 9 steps\n```\n```expect\nshear max above 0\nnormal above 0\n```\n' >>kinds/5.md
{
  printf '# An impact\n```scene\nunits none\nmaterial rock density 1 young 1000 poisson 0\nnormal hertz\nsphere 0 0 radius 1 rock\nsphere 0 2 radius 1 rock fixed\n'
  printf 'monitor C sphere 1 with sphere 2\nimpact C speed 0.3 angle 0\nrecord impact.duration C.normal\nstep 0.01\nstage a\nuntil impact.time above 1.02 at most 1000 cycles\n'
  printf '```\n```expect\nimpact.duration above 0\nC.normal max above 0\n```\n'
} >kinds/6.md
run 1 advise --all kinds/[1-6].md --budget 1e-9 -o kinds
test "$(rows kinds/trades.tsv | cut -f 1,5-9 | sed 's,^kinds/\(.\).md,\1,' | tr '\t' '|' | sed 's/|10 %|budget|the page cannot be run with its own step and with half of it: the budget is too small; choose a larger --budget$//')" = \
  '1|extreme|A.x amplitude
1|extreme|A.y min
1|mean|A.vx mean
2|mean|A.x frequency
2|time|A.y at 3 cycles
2|time|A.vx at 0.35
3|time|A.x
3|time|A.y in a
3|extreme|A.x max
4|until|A.x in a
4|time|A.x
4|time|A.vx
5|contact test|shear max
5|contact test|normal
6|impact|impact.duration
6|extreme|C.normal max' && test "$(rows kinds/trades.tsv | cut -f 10-17,20,21 | sort -u | tr '\t' '|')" = '-|-|-|-|-|-|-|-|-|-' &&
  test "$(rows kinds/trades.tsv | sed -n '1p;13p' | cut -f 3,4,18,19 | tr '\t\n' '|;')" = '-|-|linear|none;-|-|hertz|mindlin;'
result $? 'the kinds of quantities, and rows without advice'
# Below a folder only files NAME.md with a scene or a contact test are pages, in the order of the alphabet. A file that is named is searched.
cp kinds/1.md kinds/.hidden.md && cp kinds/1.md kinds/1.txt && cp folder/README.md kinds
run 1 advise --all kinds --budget 1e-9 && test "$(column trades/trades.tsv 1 | uniq | tr '\n' ' ')" = 'kinds/1.md kinds/2.md kinds/3.md kinds/4.md kinds/5.md kinds/6.md ' &&
  grep -qx '6 of 6, 6: 2 searches, 0 with advice' "$why" && grep -qx '16 searches, 0 with advice; look at trades/trades.tsv' "$why"
result $? 'the pages of a folder, and the folder of the table'
run 2 advise --all kinds/README.md -o none && said 'kinds/README.md: error: expected a block of kind `scene`'
result $? 'a file that is no page'
# Of an even number of runs the middle one is the first one of the two in the middle; several swept values are named, and no other ones.
sed 's/^sweep .*/sweep speed 0.1 0.2\nsweep kn 1 2\nlet d = 1/; s/density 1 kn 1$/density $d kn $kn/; s/^trade.*//' folder/a.md >even.md
run 1 advise --all even.md --budget 1e-9 -o even && test "$(column even/trades.tsv 3 | uniq)" = 'speed=0.1, kn=2'
result $? 'the middle one of four runs'
run 1 advise --all still.md --quantity 'D.vx; D.x' --within 1e-5 --set step=0.2 --set 'trade=laws none' -o never
rows never/trades.tsv | cut -f 3,6-10 | tee "$why" | head -n 1 | grep -qx 'step=0.2, trade=laws none	D.vx	1e-5	none	no setting that was tried is within the tolerance	-'
result $? 'a search in which no setting is within the tolerance'

run 0 advise --all folder --quantity D.vx --within '50 %' --set speed=0.2 -o below
cp below/trades.tsv "$why"
test "$(column below/trades.tsv 1)" = folder/a.md
result $? 'pages below a folder'
long=$(printf 'long%.0s' 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25)/below
mkdir -p "$long" && cp folder/a.md "$long"
run 0 advise --all "$long" --quantity D.vx --within '50 %' --set speed=0.2 -o longer && test "$(column longer/trades.tsv 1)" = "$long/a.md" &&
  run 0 advise --all "$long" --quantity D.vx --within '50 %' --set speed=0.2 -o longer && said '1 searches, 1 with advice, 1 of them from an earlier call'
result $? 'a page with a long path, and a second call'

# Exit status: 2 for a page with mistakes; the others are searched. A search that is refused is a result.
run 2 advise --all wrong.md folder/a.md --quantity D.vx --within '50 %' -o all && said 'wrong.md:4:1: error: ' && said '2 of 2, a: 1 searches, 1 with advice'
result $? 'a page with mistakes'
run 1 advise --all folder/a.md --quantity 'D.force; D.vx' --within '50 %' -o all && said '  D.force within 50 %: expected a quantity that the page records' &&
  said '2 searches, 1 with advice' && grep -q '	D.force	50 %	refused	expected a quantity' all/trades.tsv
result $? 'a page that does not record the quantity'
mkdir empty
run 2 advise --all empty && said 'nineball: there is no page below that folder: expected a page, or a folder with pages' && run 2 advise --all -o none && said 'cases: error: ' && run 2 advise --all folder --budget 0 && said 'with --budget a number of seconds above 0'
result $? 'no page'
run 2 advise folder/a.md still.md --within '1 %' && said 'for many pages write `nineball advise --all`'
result $? 'many pages without --all'
run 0 advise --all "$cases/1-two-discs/two-wall-compression.md" --set "density=500" --set "trade=laws none" --quantity 'X.fx at 1 cycles' --within '10 %' -o "it's" &&
  test "$(column "it's/trades.tsv" 3)" = 'density=500, trade=laws none'
result $? 'settings of the caller'
cp still.md "it's.md"
run 0 advise "it's.md" --set "trade=laws none" --set 'step=(0.02 * 1)' --quantity D.vx --within 0.1 -o quoted && said "to run it: nineball run 'it'\\''s.md' --set 'step=(0.02 * 1)' --set refine="
result $? 'the command is quoted for the shell'
echo "1..$n"
