#!/bin/sh
# Tests docs/equations.sh: every tag of the sources is in its table, with its file, and every equation of CS79 has a
# file. TAP. $srcdir is the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"

sh docs/equations.sh . >"$work/table" 2>"$work/said"
result $? "every tag can be read"

# A check that does not use the script: each plain tag such as `[CS79 17]` in FILE is in the row of that equation.
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

grep -E '^\| [0-9.]+a? \|  \|' "$work/table" >"$work/said"
test ! -s "$work/said"
result $? "every equation has a subject"

# The tags of texts and tests. A number of R89 that follows neither `sec.` nor `figure` is an equation: it must have two parts, and
# the chapter must have at least that many equations. The number that follows `sec.` is a section.
sections=$(sed -n 's/.*sections = "\(.*\)".*/\1/p' docs/equations.sh)
not_equations() {
  grep -roE '\[[^][]*R89 [^][]*\]' "$@" | sed 's/–/-/g; s/…/.../g' | awk -v sections=" $sections " '
    function equations(chapter) { return chapter == 3 ? 98 : chapter == 4 ? 54 : chapter == 5 ? 16 : 0 }
    {
      at = index($0, ":["); tag = substr($0, at + 1); file = substr($0, 1, at - 1)
      sub(/:.*/, "", tag) # the words after a colon are a quotation
      sub(/^.*R89 /, "", tag); sub(/CS79.*/, "", tag)
      n = split(tag, item, /[,;] */)
      figures = 0
      for (k = 1; k <= n; k++) {
        if (item[k] ~ /figure|table/) figures = 1
        else if (item[k] !~ /^[0-9]/) figures = 0
        if (item[k] ~ /^(end of )?sec\. /) {
          number = item[k]; sub(/^.*sec\. /, "", number); sub(/[^0-9.].*/, "", number)
          if (index(sections, " " number " ") == 0) print file ": " item[k] " in " $0
        }
        if (figures || item[k] !~ /^[0-9]/) continue
        m = split(item[k], end, "-")
        for (e = 1; e <= m; e++) {
          number = end[e]; sub(/[^0-9.].*/, "", number); split(number, part, ".")
          if (end[e] ~ /^[0-9]/ && (number !~ /^[0-9]\.[0-9]+$/ || part[2] > equations(part[1]))) print file ": " item[k] " in " $0
        }
      }
    }'
}
not_equations cases docs src tests --include='*.md' --include='*.[ch]' --include='*.sh' --exclude=equations.sh >"$work/said"
test ! -s "$work/said"
result $? "sections of R89 are marked in every tag"
printf '[R89 4.13, 6.4.3]\n[R89 2.3]\n[R89 figures 6.4, 6.5; 4.1]\n[R89 sec. 6.4.3, 5.12: about 2.3]\n[R89 3.99]\n[R89 4.53-4.55]\n[R89 sec. 6.6]\n' >"$work/marks.md"
not_equations "$work/marks.md" -H >"$work/said"
test "$(wc -l <"$work/said")" -eq 5
result $? "a section without its mark, and a number that does not exist, are found"

# Invalid tags, and a valid one with several items.
mkdir -p "$work/tree/src" "$work/tree/cases/refs"
echo '/* [CS79 about 3] */' >"$work/tree/src/a.c"
! sh docs/equations.sh "$work/tree" >"$work/out" 2>"$work/said" && grep -qF 'src/a.c: cannot read `about 3`' "$work/said"
result $? "a tag with any other text is an error"
for tag in 'R89 3.99|R89 has no equation 3.99' 'R89 6.4|R89 has no equation 6.4' 'CS79 37|CS79 has no equation 37' 'R89 sec. 6.6|R89 has no section 6.6' \
  'R89 6.4.3|cannot read `6.4.3`' 'R89 sec. 3.2-3.7|R89 has no section 3.7'; do
  echo "/* [${tag%|*}] */" >"$work/tree/src/a.c"
  ! sh docs/equations.sh "$work/tree" >"$work/out" 2>"$work/said" && grep -qF "src/a.c: ${tag#*|} in" "$work/said" || break
done
test "$tag" = 'R89 sec. 3.2-3.7|R89 has no section 3.7' && grep -qF "src/a.c: ${tag#*|} in" "$work/said"
result $? "an equation or a section that a paper does not have is an error"
echo '/* [R89 4.13; CS79 8-9, figure 1] */' >"$work/tree/src/a.c"
sh docs/equations.sh "$work/tree" >"$work/said" && grep -q '^| 4.13 .*| src/a.c |$' "$work/said" &&
  test "$(grep -c '| src/a.c |$' "$work/said")" -eq 4
result $? "a tag of both papers, with a range and a figure, is in four rows"
echo "1..$n"
