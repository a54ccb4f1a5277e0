#!/bin/sh
# Tests docs/equations.sh: every tag of the sources is in its table, with its file, and every equation of CS79 has a
# file. TAP. $srcdir is the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"

sh docs/equations.sh . >"$work/table" 2>"$work/said"
result $? "every tag can be read"

# Independent of the script: plain tags such as `[CS79 17]` in FILE are in the row of that equation.
grep -roE '\[(CS79 [0-9]+a?|R89 [0-9]+\.[0-9]+)\]' src cases/refs --include='*.[ch]' --exclude=law_batch.h |
  sed 's/^\(.*\):\[\(.*\) \(.*\)\]$/\1 \2 \3/' | sort -u >"$work/tags"
while read -r file paper number; do
  sed -n "/^## $paper/,/^| also/p" "$work/table" | grep -F "| $number |" | tr -d , | grep -qw -e "$file" ||
    echo "[$paper $number] of $file is not in the table"
done <"$work/tags" >"$work/said"
test "$(wc -l <"$work/tags")" -gt 100 || wc -l "$work/tags" >>"$work/said"
test ! -s "$work/said"
result $? "every plain tag is in the row of its equation"

sh docs/equations.sh . | grep '| nowhere |' >"$work/said"
test ! -s "$work/said"
result $? "every equation of CS79 has a file"

# An invalid tag, and a valid one with several items.
mkdir -p "$work/tree/src" "$work/tree/cases/refs"
echo '/* [CS79 about 3] */' >"$work/tree/src/a.c"
! sh docs/equations.sh "$work/tree" >"$work/out" 2>"$work/said" && grep -qF 'src/a.c: cannot read `about 3`' "$work/said"
result $? "a tag with any other text is an error"
echo '/* [R89 4.13; CS79 8-9, figure 1] */' >"$work/tree/src/a.c"
sh docs/equations.sh "$work/tree" >"$work/said" && grep -q '^| 4.13 .*| src/a.c |$' "$work/said" &&
  test "$(grep -c '| src/a.c |$' "$work/said")" -eq 4
result $? "a tag of both papers, with a range and a figure, is in four rows"
echo "1..$n"
