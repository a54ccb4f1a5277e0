#!/bin/sh
# Tests docs/papers. It must have a row for each figure and table of CS79, and for each figure of chapters 3 to 6 of R89, in the
# order of the papers. Each row must have a verdict, and its links must lead to files and cases. A row with a verdict on a statement
# must have a case that cites the figure below its title. TAP. $srcdir is the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"

# Prints the figures and tables that a text names, one per line: `figures 9a, 11–13; table 2` gives 9a 11 12 13 T2, and `6.31–6.33`
# gives 6.31 6.32 6.33. Numbers after other words are ignored: `section 5.4` gives nothing.
named() {
  sed 's/–/ - /g; s/[],;:()[]/ & /g' | awk '{
    kind = $1 ~ /^[0-9]/ ? "" : "-"
    for (k = 1; k <= NF; k++) {
      word = $k
      if (word == "-") { range = 1; continue }
      if (word ~ /^[0-9]+(\.[0-9]+)?[a-z]?$/) {
        if (kind == "-") continue
        n = split(word, now, "."); m = split(last, before, ".")
        if (range && n == m && (n == 1 || now[1] == before[1]))
          for (f = before[n] + 1; f < now[n] + 0; f++) print kind (n == 2 ? now[1] "." : "") f
        print kind (last = word)
        range = 0
      } else if (word ~ /^[Ff]igures?$/) kind = ""
      else if (word ~ /^[Tt]ables?$/) kind = "T"
      else if (word !~ /^(and|,)$/) kind = "-"
    }
  }'
}
# rows prints the rows of a document, first the figures in the first column of a row, and cases the pages to which the second column
# links.
rows() { grep '^|' "docs/papers/$1.md" | grep -v '^| \(where\|figure\) |\|^| ---'; }
first() { cut -d '|' -f 2 | sed 's/^ *//'; }
cases() { cut -d '|' -f 3 | grep -o '(\.\./[^)#]*' | sed 's/^(//'; }

{ for k in 1 2 3 4 5a 5b 6 7a 7b 8 9a 9b 10 11 T1 12 T2 13 T3; do echo $k; done; } >"$work/wanted"
rows CS79 | first | named | uniq >"$work/there"
diff "$work/wanted" "$work/there" >"$work/said"
result $? "CS79: each figure and table, in their order"

awk 'BEGIN {
  for (f = 1; f <= 19; f++) print "3." f; print "4.1"; for (f = 1; f <= 17; f++) print "5." f; for (f = 1; f <= 43; f++) print "6." f }' >"$work/wanted"
rows R89 | grep '^| [0-9]' | first | named >"$work/there"
diff "$work/wanted" "$work/there" >"$work/said"
result $? "R89: each figure of chapters 3 to 6, in their order"

for paper in CS79 R89; do
  rows $paper | while IFS= read -r row; do
    name=$(printf '%s\n' "$row" | first)
    columns=$(printf '%s\n' "$row" | awk -F '|' '{ print NF }')
    for page in $(printf '%s\n' "$row" | cases); do
      case $page in
      ../../cases/*) grep -q "^  ${page#../../}\( \\\\\)*$" build-aux/lists.mk || echo "$name: $page is not a case" ;;
      *) test -f "docs/papers/$page" || echo "$name: there is no $page" ;;
      esac
    done
    test "$columns" -eq 7 || { test "$columns" -eq 5 && printf '%s\n' "$row" | grep -q '^| section 2'; } || echo "$name: $columns columns"
    test "$columns" -eq 7 || continue
    case $(printf '%s\n' "$row" | cut -d '|' -f 6) in
    *'**holds**'* | *'**in part**'* | *'**does not hold**'*)
      echo "$name" | named | while IFS= read -r figure; do
        for page in $(printf '%s\n' "$row" | cases); do
          grep -m 1 '^\[' "docs/papers/$page" | sed 's/^/tag /' | named
        done | grep -qx "$figure\|${figure%[ab]}" || echo "$figure: no case of its row cites it"
      done
      ;;
    *'**drawn**'* | *'**not shown**'*) ;;
    *) echo "$name: no verdict" ;;
    esac
  done
done >"$work/said"
test ! -s "$work/said"
result $? "every row links to cases that cite the figure, and has a verdict"

for document in docs/PAPERS.md docs/papers/CS79.md docs/papers/R89.md; do
  sed -n '/^DOCUMENTS = /,/[^\\]$/p' build-aux/lists.mk | grep -q "^  $document\( \\\\\)*$" || echo "$document is not in the report"
done >"$work/said"
test ! -s "$work/said"
result $? "the report has a page for each paper"

echo "1..$n"
