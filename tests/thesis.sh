#!/bin/sh
# docs/THESIS.md has a row for each figure of chapter 6 of R89, and its links lead to cases. If a row has a verdict,
# one of its cases cites the figure below its title. TAP. $srcdir is the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
table=docs/THESIS.md

# The figures named in a text: `figures 6.31–6.33, 6.35` gives 6.31 6.32 6.33 6.35.
figures() {
  sed 's/–/ - /g; s/[^0-9. -]/ /g' | awk '{
    for (k = 1; k <= NF; k++) {
      if ($k == "-") { range = 1; continue }
      if ($k !~ /^[0-9]\.[0-9]+$/) { range = 0; continue }
      split($k, now, "."); split(last, before, ".")
      if (range && now[1] == before[1])
        for (f = before[2] + 1; f < now[2]; f++) print now[1] "." f
      print last = $k
      range = 0
    }
  }'
}

grep -E '^\| ([0-9]|section)' $table >"$work/rows" # the rows of figures, and of other statements

{ echo 4.1 && awk 'BEGIN { for (f = 1; f <= 43; f++) print "6." f }'; } >"$work/wanted"
grep '^| [0-9]' "$work/rows" | cut -d '|' -f 2 | figures >"$work/there"
diff "$work/wanted" "$work/there" >"$work/said"
result $? "one row for each figure, in their order"

while IFS= read -r row; do
  mine=$(echo "$row" | grep '^| [0-9]' | cut -d '|' -f 2 | figures)
  shown=$(echo "$row" | cut -d '|' -f 3 | grep -o 'cases/[^)]*\.md')
  verdict=$(echo "$row" | cut -d '|' -f 6)
  for page in $(echo "$row" | grep -o 'cases/[^)]*\.md'); do
    grep -q "^  $page\( \\\\\)*$" build-aux/lists.mk || echo "${row%%" |"*}: $page is not a case"
  done
  case $verdict in
  *'**holds**'* | *'**in part**'* | *'**does not hold**'*)
    for figure in $mine; do
      for page in $shown; do
        grep -m 1 '^\[' "$page" | grep -o 'figure.*' | sed 's/section.*//' | figures
      done | grep -Fqx "$figure" || echo "$figure: no case of its row cites it"
    done
    ;;
  *'**not shown**'*) ;;
  *) echo "${row%%" |"*}: no verdict" ;;
  esac
done <"$work/rows" >"$work/said"
test ! -s "$work/said"
result $? "every row links to cases that cite the figure, and has a verdict"

echo "1..$n"
