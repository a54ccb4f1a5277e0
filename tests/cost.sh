#!/bin/sh
# Tests under callgrind that a cycle executes no line of a feature that the page does not use: a small version of `make cost`, with 64
# particles and 20 cycles. TAP. $NINEBALL is the program, $srcdir the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

top=$(cd "${srcdir:-.}" && pwd)
. "${srcdir:-.}/tests/tap"

NINEBALL=$nineball srcdir=$top SIDE=8 CYCLES=20
export NINEBALL srcdir SIDE CYCLES

sh "$top/tests/bench/cost.sh" --proof base >"$why" 2>&1
status=$?
if [ $status -eq 77 ]; then
  echo "1..0 # SKIP $(sed 's/^cost.sh: //' "$why" | head -n 1)"
  exit
fi
result $status "the smallest page executes no line of an optional feature"
sh "$top/tests/bench/cost.sh" --proof linear dashpots >"$why" 2>&1
result $? "pages with friction or dashpots execute no line of any other optional feature"

sh "$top/tests/bench/cost.sh" --proof later-dashpots later-affine later-cell >"$why" 2>&1
result $? "pages of which only a later stage uses a feature execute no line of it before"

# A page uses a feature that it does not declare: the proof must find it.
sed 's/^base | - | | frame discs | |/base | - | | frame discs | | gravity 0 m\/s2 -1 m\/s2/; s/^linear | base | rotation/linear | base | walls rotation/' \
  "$top/tests/bench/cost.sh" >"$work/wrong.sh"
sh "$work/wrong.sh" --proof base >"$why" 2>&1
test $? -eq 1 && grep -q '^page base executes src/core/motion.c:add_weight, a file of: gravity : [0-9]* instructions' "$why"
result $? "gravity on the smallest page is found"
sh "$work/wrong.sh" --proof linear >"$why" 2>&1
test $? -eq 1 && grep -q '^page linear executes nothing of walls$' "$why"
result $? "a declared feature of which no line is executed is found"
echo "1..$n"
