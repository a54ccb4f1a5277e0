#!/bin/sh
# Tests docs/trades.sh, which writes docs/TRADES.md: on two pages every row of its tables must equal the output of `nineball advise`.
# TAP. $NINEBALL is the program, $srcdir the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"

NINEBALL=$nineball OMP_NUM_THREADS=1 sh docs/trades.sh -o "$work/made" cases/1-two-discs/two-wall-compression.md cases/5-numerics/order.md >"$why" 2>&1
result $? 'the document of two pages'

# The rows of all cases: PAGE|CONDITION|QUANTITY|TOLERANCE|SETTING|COST|ERROR|NEXT|RATIO, one line for each tolerance. ERROR, NEXT
# and RATIO are those of the last tolerance of a row.
sed -n '/^## All cases/,$p' "$work/made/TRADES.md" | awk -F ' *[|] *' '
  /^\| (case|---)/ || !/^\|/ { next }
  {
    if ($2 != "") { page = $2; sub(/^[^(]*\(\.\.\//, "", page); sub(/\).*/, "", page); condition = $2; sub(/^[^)]*\)(, )?/, "", condition) }
    if ($3 != "") measure = $3
    gsub(/`/, ""); gsub(/`/, "", measure)
    next_one = $8; ratio = $8; sub(/:.*/, "", next_one); sub(/.*: /, "", ratio)
    m = split($4, tolerance, /, /)
    for (k = 1; k <= m; k++) print page "|" condition "|" measure "|" tolerance[k] "|" $5 "|" $6 "|" (k == m ? $7 : "-") "|" (k == m ? next_one : "-") "|" ratio
  }' >"$work/table"
cp "$work/table" "$why"
test "$(wc -l <"$work/table")" -eq 18 && test "$(cut -d '|' -f 1,3 "$work/table" | sort -u | wc -l)" -eq 6
result $? 'three quantities of each page with three tolerances each'

while IFS='|' read -r page condition measure tolerance setting cost error next ratio; do
  set --
  for one in $(echo "$condition" | sed 's/, / /g'); do set -- "$@" --set "$one"; done
  "$nineball" advise "$page" "$@" --quantity "$measure" --within "$tolerance" --trust -o "$work/advice" 2>/dev/null | sed 's/ --set / /g' >"$work/answer"
  options=$(sed -n 's/.*cheapest setting within the tolerance: //p' "$work/answer")
  test "$options" = "$setting" || echo "$measure within $tolerance: $options, the table has $setting"
  percent=$(sed -n 's/^  cost: .*, \([^ ]*\) % of the .*/\1/p' "$work/answer")
  awk -v cost="$cost" -v percent="$percent" 'BEGIN { d = percent/(100*cost) - 1; exit !(percent > 0 && d*d < 0.05^2) }' ||
    echo "$measure within $tolerance: another cost than $cost: $(grep '^  cost' "$work/answer")"
  test "$error" = - || grep -qF "estimated error: at most $error; " "$work/answer" || echo "$measure within $tolerance: another error than $error"
  case $next in
  -) ;;
  –) ! grep -q 'next cheaper' "$work/answer" || echo "$measure within $tolerance: there is a cheaper setting" ;;
  *)
    grep -A 1 "next cheaper setting misses the tolerance: $next\$" "$work/answer" | awk -v ratio="$ratio" -v tolerance="${tolerance% %}" '
      / estimated error: / { d = $3/(ratio*tolerance) - 1; found = d*d < 0.1^2 } END { exit !found }' ||
      echo "$measure within $tolerance: the next cheaper setting is not $next with $ratio times the tolerance"
    ;;
  esac
done <"$work/table" >"$why"
test ! -s "$why"
result $? 'every row is what the program advises'

# The lessons: the quotient of costs in the text follows from the numbers of the table.
sed -n 's/^.*From 1 % to 0.1 % it is multiplied by \([0-9.]*\).*/\1/p' "$work/made/TRADES.md" >"$work/stated"
awk -F '|' '{ c[$1 $3, $4] = $6; q[$1 $3] = 1 } END { for (k in q) print c[k, "0.1 %"]/c[k, "1 %"] }' "$work/table" | sort -g | awk '{ v[NR] = $1 } END { print v[4] }' >"$why"
test -s "$work/stated" && awk 'NR == FNR { stated = $1; next } { d = stated/$1 - 1; exit !(stated > 1 && d*d < 0.1^2) }' "$work/stated" "$why"
result $? 'the median of the quotients of costs'
grep -q '^| value at a given time or cycle | [1-9]' "$work/made/TRADES.md" && ! grep -q "^| .mindlin" "$work/made/TRADES.md"
result $? 'the tables of orders and of laws'
if command -v gnuplot >/dev/null; then
  test -s "$work/made/trades/two-wall-compression.svg" && grep -qF '](trades/two-wall-compression.svg)' "$work/made/TRADES.md"
  result $? 'the figure of a named case'
fi

# The section on other ways to trade: the committed document has the numbers of the tables.
sh docs/trades/ways.sh >"$work/ways" 2>"$why" && test "$(wc -l <"$work/ways")" -gt 40 &&
  sed -n '/^## Other ways to trade/,/^## All cases/p' docs/TRADES.md | sed '/^## All cases/d' | sed '$d' | diff - "$work/ways" >>"$why"
result $? 'the section on other ways to trade is up to date'
sh docs/trades/softness.sh >"$work/softness" 2>"$why" && test "$(wc -l <"$work/softness")" -gt 6 &&
  sed -n '/^\*\*Softer spheres in a shear test/,/^\*\*No advice/p' docs/TRADES.md | sed '$d' | sed '$d' | diff - "$work/softness" >>"$why"
result $? 'the lessons on softer spheres and faster loading are up to date'
echo "1..$n"
