#!/bin/sh
# Tests `nineball check --rounding`: the bits, verdicts and parts that it prints, and the calls that it refuses. TAP. $NINEBALL is
# the program, $srcdir the top of the source tree. tests/rounding.c tests the rounding modes themselves.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
top=$(pwd)
cd "$work" || exit 1

# Positions that are binary fractions are the same in each mode. For disc 2 v dt is not a binary fraction. Each of the 2^12 additions to x
# differs by at most one unit in the last place, so x keeps at least 53-13 bits. Errors of directed rounding have one sign: they
# amount to at least 2^12/2^7 units, so x keeps at most 53-6 bits.
page() {
  cat <<'PAGE'
# Free discs

```scene
units none
material a density 1 kn 1
disc 0 0 radius 1 a velocity 0.25 0
disc 8 100 radius 1 a velocity 0.7 0
disc 8 -100 radius 1 a velocity 0.7 0
step 0.5
monitor A disc 1
monitor B disc 2
monitor C disc 3
record every cycle A.x B.x B.y energy.kinetic
stage s
cycles 4096
```

```expect
A.x expected 512 within 0 [exact]        # in each mode
B.x expected 1441.6 within 1e-9 [v t]
B.y expected 100 within 0 [exact]
B.x above A.x
```
PAGE
}
page | sed 's/^record every cycle/record/' >free.md

# bits N: the number before expectation N of the list.
bits() { sed -n '/bits that do not depend/,$p' "$why" | sed -n "$(($1 + 1))p" | awk '{ print $1 }'; }

run 0 check free.md --rounding all && test "$(grep -c '  rounding .* 4 of 4 checks passed' "$why")" -eq 3 &&
  grep -q 'rounding up  ' "$why" && grep -q 'rounding down' "$why" && grep -q 'rounding zero' "$why" && said '  4 of 4 checks passed'
result $? 'verdicts of the four modes'
test "$(bits 1)" = 53 && test "$(bits 3)" = 53 && test "$(bits 2)" -ge 40 && test "$(bits 2)" -le 47 && test "$(bits 4)" = "$(bits 2)"
result $? 'bits of exact and of rounded quantities'
sed -n '/bits that do not depend/,$p' "$why" | grep -q '^    53  A.x expected 512 within 0 .exact.$'
result $? 'an expectation is printed without its comment'
sed 's/^A.x expected/ \t&/; s/exact.  *#/exact] \t #/' free.md >tabs.md
run 0 check tabs.md --rounding all && sed -n '/bits that do not depend/,$p' "$why" | grep -q '^    53  A.x expected 512 within 0 .exact.$'
result $? 'an expectation is printed without the tabs around it'

sed 's/^disc 0 0 .*/&\ndisc 0 1 radius 1 a/' free.md >deep.md
run 1 check deep.md --rounding all && test "$(grep -c '^deep.md:[0-9]*: warning: particle 2 overlaps particle 1 (line 6) too much at the start' "$why")" -eq 1
result $? 'the warnings of the page, once'

run 0 check free.md --rounding parts && sed -n '/with one part/,$p' "$why" >parts &&
  grep -qx '  with one part of the cycle rounded up and down, bits of: B.x expected 1441.6 within 1e-9 .v t.' parts && grep -q "^    4[0-7]  motion$" parts && grep -q '^    53  search$' parts &&
  test "$(sed 's/^ *[0-9]*  //' parts | sort | uniq -d | wc -l)" -eq 0
result $? 'parts of the cycle'
# The passes of two pairs of materials, each once. Nothing touches the wall.
sed 's/^disc 0 0/material b density 1 kn 2\n&/; s/^step 0.5/wall w -9000 -900 to 9000 -900 b\n&/' free.md >wall.md
run 0 check wall.md --rounding parts && sed -n '/with one part/,$s/^    \([0-9]*  \)/\1/p' "$why" | sed 's/^4[0-7]/42/' >parts
diff -u - parts >"$why" <<'END'
42  motion
53  search
53  stability check
53  disc-disc, overlap
53  normal linear
53  resolve, normal
53  disc-wall, overlap
END
result $? 'all parts of a page with a wall of another material'
sed 's/^stage s/boundary circle 0 0 radius 9000\nstage s/' free.md >ring.md
run 0 check ring.md --rounding parts && said '    53  boundary takes in particles'
result $? 'parts before the motion'
sed 's/kn 1$/young 1 poisson 0\nnormal hertz/; s/\bdisc\b/sphere/; s/^record /record step.fracc /' free.md >spheres.md
run 0 check spheres.md --rounding parts && said '    53  stability check of stiffening contacts' &&
  said '    53  count of deep overlaps' && said '    53  FRACC'
result $? 'each of several parts after the forces'

# If sums are rounded up, x exceeds the expected value by more than the tolerance.
sed 's/within 1e-9/within 1e-10/' free.md >tight.md
run 1 check tight.md --rounding all && said 'rounding up    3 of 4 checks passed'
result $? 'a check that fails in another mode'
# Only rounding up brings x above 1441.6 by more than 1e-10; the modes after it pass.
sed 's/^B.x expected.*/B.x below 1441.6000000001/; /^B.x above/d' free.md >above.md
run 1 check above.md --rounding all && said 'rounding up    2 of 3 checks passed' && said 'rounding zero  3 of 3 checks passed'
result $? 'the status of a mode that is not the last one'
# No part is tried if no mode changes a bit, or if there is no cycle.
sed '/^B.x expected/d; /^B.x above/d' free.md >exact.md
printf '# A path\n```contact-test\nunits none\nmaterial a kn 0.7 ks 0.7 friction 1\ncontact disc 1 a with disc 1 a\nnormal linear\nrecord work.normal\nsegment s overlap to 0.3 in 30 steps\n```\n```expect\nwork.normal expected 0.0315 within 1 %% [k x^2/2]\n```\n' >path.md
run 0 check exact.md --rounding parts && said 'bits that do not' && ! said 'with one part' && run 0 check path.md --rounding parts && said 'bits that do not' && ! said 'with one part' && ! grep -q '^    53' "$why"
result $? 'pages of which no part is tried'

# Two runs: 0.5 v is a binary fraction only in the first one, and the label names the run with fewer bits.
sed 's/^disc 8 100 radius 1 a velocity 0.7 0/sweep v 0.5 0.7\ndisc 8 100 radius 1 a velocity $v 0/; /^B.x expected/d' free.md >swept.md
sed -i 's/^B.x above A.x/B.x above A.x\nB.x decreases with v/; s/decreases/increases/' swept.md
run 0 check swept.md --rounding all && grep -q '^    4[0-9]  B.x increases with v (v=0.7)$' "$why"
result $? 'the run with the fewest bits'
sed 's/0.5 0.7$/0.5 0.7 1/' swept.md >three.md
run 0 check three.md --rounding all && grep -q '^    4[0-9]  B.x increases with v (v=0.7)$' "$why" &&
  grep -q '^    53  A.x expected 512 within 0 .exact. (v=0.5)$' "$why" # with as many bits in each run, the first one
result $? 'the run with the fewest bits is not the last one'
# Each cycle adds 0.5 + 5e-14 to x > 2^13, whose unit in the last place is 2^-39: only rounding up is not the same as rounding to
# nearest, by one unit in each of 2^12 cycles. If the disc moves to the left, only rounding down and to zero differ.
for motion in '9000 1.0000000000001 11048' '12000 -1.0000000000001 9952'; do
  set -- $motion
  sed "s/^disc 8 100 .*/disc $1 100 radius 1 a velocity $2 0/; s/expected 1441.6 within 1e-9/expected $3 within 1e-3/; /^B.x above/d" free.md >one-mode.md
  run 0 check one-mode.md --rounding parts && test "$(bits 2)" -ge 40 && test "$(bits 2)" -le 42 && grep -q '^    4[0-2]  motion$' "$why"
  result $? "the mode with the fewest bits: velocity $2"
done
for pages in 'tight.md free.md' 'free.md tight.md'; do
  run 1 check $pages --rounding all && test "$(grep -c 'bits that do not depend' "$why")" -eq 2
  result $? "the status of two pages: $pages"
done

# A residual, and a value that is zero within its tolerance, have no bits.
{
  sed '/^```expect/,$d; s/^record /record C.vy A.vy /; s/velocity 0.7 0/velocity 0.7 1e-14/' free.md
  printf '```expect\nC.vy expected 0 within 1e-12 [rest]\nA.x expected 512 within 0 [exact]\nA.vy expected 0 within 0 [exact]\n```\n'
} >zero.md
run 0 check zero.md --rounding all && grep -q '^     -  C.vy expected 0 within 1e-12 .rest.$' "$why" && test "$(bits 2)" = 53 && test "$(bits 3)" = 53
result $? 'a value of zero has no bits'

run 2 check free.md --rounding sideways && said 'expected `--rounding all` or `parts`, found `sideways`'
result $? 'an unknown word'
run 2 check free.md --rounding all --tap && said 'without --tap'
result $? '--rounding is refused with --tap'
run 2 run free.md --rounding all && said 'which is an option of: check'
result $? '--rounding is an option of check only'
sed 's/^step/stop/' free.md >wrong.md
run 2 check wrong.md --rounding all && said 'wrong.md:9:1' && ! said 'bits that'
result $? 'a mistake in the page'
run 2 check none.md --rounding all && said 'none.md: error: ' && ! said 'bits that'
result $? 'a page that does not exist'
# Nothing oscillates, so neither the frequency nor a fraction of it is known.
{
  sed '/^```expect/,$d; s/^record /record A.y /' free.md
  printf '```expect\nA.y frequency expected 1 within 1 %% [x]\nB.x expected 1441.6 within 1 %% of A.y frequency [v t]\n```\n'
} >no-value.md
run 1 check no-value.md --rounding all && test "$(bits 1)" = 0 && test "$(bits 2)" = 0
result $? 'a value that is not known has no bits in common'
# A run that is aborted in every mode.
sed 's/^disc 8 100 .*/disc 1000 0 radius 1 a velocity -0.25 0/; s/cycles 4096/cycles 9000/; s/^step 0.5/step 8/; s/^units none/units none\nallow unstable/' free.md >broken.md
run 3 check broken.md --rounding all && ! said 'bits that'
result $? 'a run that is aborted'
# The disc ends at 1441.6 - 4e-14 if rounded to nearest, and beyond the position below which the stage ends if rounded up.
sed 's/^cycles 4096/cycles 4095\nstage t\nuntil B.x below 1441.59999999995 at most 1 cycles/; /^A.x expected/d; /^B.x expected/d' free.md >up.md
run 3 check up.md --rounding all && said 'nineball: with rounding up:' && said 'up.md: run aborted: stage `t` (line ' && ! said 'bits that' && ! said 'rounding down'
result $? 'a run that is aborted in one mode'

# ---- docs/rounding.sh, which writes docs/ROUNDING.md ----

document() { NINEBALL=$nineball sh "$top/docs/rounding.sh" -o rounding.md "$@" >"$why" 2>&1; }
mkdir 9-free && cp free.md tight.md swept.md 9-free
document 9-free/free.md 9-free/tight.md 9-free/swept.md
test $? -eq 0 && grep -q '^| \[free\](../cases/9-free/free.md) | 42 | `B.x expected 1441.6 within 1e-9 .v t.` |  |$' rounding.md &&
  grep -q '^| \[tight\](.*) | 42 | .* | [123] |$' rounding.md && grep -q '^| \[swept\](.*) | 4[0-9] | `B.x above A.x (v=0.7)` |  |$' rounding.md &&
  grep -q '^- The median over 3 cases is 4[0-9] bits. 0 cases keep fewer than 30' rounding.md && grep -q 'In 3 of them the motion costs the most bits' rounding.md &&
  grep -q '^- In 1 cases some check' rounding.md
result $? 'docs/rounding.sh: a row for each page'
# A condition that does not hold with rounding up: 4096 roundings carry the disc beyond the position below which the stage ends,
# so the run is aborted.
sed '/^stage s/,$d; s/velocity 0.7 0/velocity 0.7 0/' free.md >9-free/stops.md
printf 'stage s\ncycles 4095\nstage t\nuntil B.x below %s at most 1 cycles\n```\n```expect\nB.y expected 100 within 0 [rest]\n```\n' 1441.59999999995 >>9-free/stops.md
document 9-free/stops.md
test $? -eq 1 && grep -q '^| \[stops\](.*) | 0 | `rounding up aborts the run` |  |$' rounding.md
result $? 'docs/rounding.sh: a run that a mode aborts'
# Few bits: a position near 0 that is the difference of large numbers. The bits are relative to the small position.
sed 's/^disc 8 100 radius 1 a velocity 0.7 0/disc -1433.6 100 radius 1 a velocity 0.7 0/; s/^B.x expected 1441.6 within 1e-9/B.x expected 1e-9 of A.x within 1/' free.md |
  sed 's/^B.x above A.x/B.x below A.x/' >9-free/few.md
document 9-free/few.md
test $? -eq 1 && said 'few.md keeps fewer than 30 bits: it should state why'
result $? 'docs/rounding.sh: few bits without a reason'
printf '\nFew bits depend on the rounding\nmode here.\n' >>9-free/few.md
document 9-free/few.md
result $? 'docs/rounding.sh: few bits with a reason'
# The committed document has a row for each short case, except those whose checks have no bits because all of these checks compare
# with zero.
without_bits='periodic-shear'
sed -n '/^PAGES =/,/[^\\]$/s/^ *\(cases[^ ]*\).*/\1/p' "$top/build-aux/lists.mk" | sed 's,.*/,,; s/[.]md$//' | while read -r name; do
  case " $without_bits " in *" $name "*) continue ;; esac
  grep -qF "| [$name](" "$top/docs/ROUNDING.md" || echo "docs/ROUNDING.md has no row for $name: make rounding, or add what \`nineball check --rounding all\` prints"
done >"$why"
test ! -s "$why"
result $? 'docs/ROUNDING.md has a row for each short case'
echo "1..$n"
