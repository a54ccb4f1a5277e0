#!/bin/sh
# Compares the cost that `nineball explain` expects of a page with the cost of `nineball run`: cycles, contact updates, processor
# time.
#
#   expected.sh PAGE…            one line for each page whose length is fixed: name, and three quotients, expected over actual
#   expected.sh -o FILE PAGE…    also replaces the section "What `explain` expects" of the document FILE
#
#   NINEBALL   the program          REPEATS   calls of each command, 5; the shortest time counts, because other programs may run
#
# Exit status: 0 at least 95 % of the pages have all three quotients within 20 %, 1 fewer have, 2 wrong use.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu
LC_ALL=C OMP_NUM_THREADS=1 OMP_WAIT_POLICY=passive
export LC_ALL OMP_NUM_THREADS OMP_WAIT_POLICY
document=
if [ "${1:-}" = -o ] && [ $# -ge 2 ]; then
  document=$2
  shift 2
fi
[ $# -gt 0 ] || {
  echo 'usage: expected.sh [-o FILE] PAGE…' >&2
  exit 2
}
nineball=${NINEBALL:-./nineball}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
NINEBALL_STATES=${NINEBALL_STATES:-$work/states} # the states of pages that start from another page
export NINEBALL_STATES
section='## What `explain` expects'

# Prints the line of costs, "1200 cycles, 3.6e+03 contact updates, 0.01 s", as three numbers.
numbers() { sed -n 's/^  *\([^ ]*\) \(cycles\|steps\), \([^ ]*\) contact updates, \([^ ]*\) s\(;.*\)*$/\1 \3 \4/p' | tail -n 1; }

for page; do
  "$nineball" explain "$page" >"$work/plan" 2>/dev/null || continue
  # A length that a condition decides is printed as "5 to 10", and a length that depends on a later state as "about 5".
  ! grep -qE '^  .*[0-9] to [0-9.e+]+ (cycles|steps), |^  .*, about |: the condition on line|does not end' "$work/plan" || continue
  k=0
  while [ $k -lt "${REPEATS:-5}" ]; do
    k=$((k + 1))
    "$nineball" run "$page" --jobs 1 -o "$work/out" 2>/dev/null | numbers >>"$work/actual"
    "$nineball" explain "$page" 2>/dev/null | awk '/^cost$/ || /^all [0-9]* runs$/ { getline; last = $0 } END { print last }' | numbers >>"$work/expected"
  done
  awk -v name="$(basename "$page" .md)" '
    NF < 3 { next }
    { cycles[FILENAME] = $1; updates[FILENAME] = $2; if (!(FILENAME in s) || $3 < s[FILENAME]) s[FILENAME] = $3 }
    END {
      e = ARGV[1]; a = ARGV[2]
      if (s[a] > 0) printf "%s\t%.3g\t%.3g\t%.3g\t%s\n", name, cycles[e]/cycles[a], (updates[a] > 0 ? updates[e]/updates[a] : 1), s[e]/s[a], s[a]
    }' "$work/expected" "$work/actual" | tee -a "$work/rows"
  rm -f "$work/actual" "$work/expected"
done

# Quantiles of a column, and the number of rows within 20 %.
quantile() { cut -f "$1" "$work/rows" | sort -g | awk -v q="$2" '{ v[NR] = $1 } END { printf "%.2f\n", v[int(q*(NR - 1) + 1.5)] }'; }
close() { awk -F '\t' -v from="$1" -v to="$2" '{ good = 1; for (k = from; k <= to; k++) if ($k < 0.8 || $k > 1.2) good = 0; n += good } END { print n + 0 }' "$work/rows"; }
count=$(($(wc -l <"$work/rows")))
row() { echo "| $1 | $(quantile "$2" 0) | $(quantile "$2" 0.05) | $(quantile "$2" 0.5) | $(quantile "$2" 0.95) | $(quantile "$2" 1) | $(close "$2" "$2") of $count |"; }
if [ "$document" ]; then
  awk -v section="$section" '$0 == section { skip = 1; next } /^## / { skip = 0 } !skip { line[++n] = $0 }
    END { while (n && line[n] == "") n--; for (k = 1; k <= n; k++) print line[k] }' "$document" >"$work/document"
  cat >>"$work/document" <<TEXT

$section

\`nineball explain\` prints the cycles, contact updates and processor time that a run will take, in total over a sweep. \`nineball run\`
prints what it has taken. The table compares them on the $count short cases whose number of cycles is fixed or follows from a condition on time
([expected.sh](../tests/bench/expected.sh)). The commands were called in turn, $((${REPEATS:-5})) times each, and the shortest time
of each counts, because other programs ran on the machine. The columns are quantiles of expected over actual.

| | smallest | 5 % | median | 95 % | largest | within 20 % |
| --- | --- | --- | --- | --- | --- | --- |
$(row cycles 2)
$(row 'contact updates' 3)
$(row 'processor time' 4)

All three are within 20 % on $(close 2 4) of $count cases.$(awk -F '\t' '$2 < 0.8 || $2 > 1.2 || $3 < 0.8 || $3 > 1.2 || $4 < 0.8 || $4 > 1.2 { list = list (list == "" ? "" : ", ") sprintf("%s (%.2f; %s ms)", $1, $4, 1000*$5) } END { if (list != "") print " The others, with their quotient of times and the time of a run: " list "." }' "$work/rows")
A run of a few milliseconds consists mostly of the start of the program, reading, and writing of files.
TEXT
  cp "$work/document" "$document"
fi
test "$(($(close 2 4)*100))" -ge $((count*95))
