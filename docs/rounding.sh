#!/bin/sh
# Runs `nineball check --rounding parts` on every short case, and writes docs/ROUNDING.md. The parts of assemblies are
# left out. Every number of that document comes from here.
#
#   docs/rounding.sh -o FILE PAGE…
#
#   NINEBALL   the program
#   RESULTS    folder of the results of the pages; a second call with the same program continues there. Default: a temporary one
#
# Status 1: a page that keeps fewer than 30 bits does not state why, in a sentence with the words `rounding mode`.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu
LC_ALL=C
export LC_ALL
test "${1:-}" = -o && test $# -ge 3 || {
  echo 'usage: rounding.sh -o FILE PAGE…' >&2
  exit 2
}
file=$2
shift 2
nineball=$(cd "$(dirname "${NINEBALL:-./nineball}")" && pwd)/$(basename "${NINEBALL:-./nineball}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
results=${RESULTS:-$work/results}
mkdir -p "$results"
cksum <"$nineball" >"$work/program"
cmp -s "$work/program" "$results/program" || rm -f "$results"/*.txt
cp "$work/program" "$results/program"
NINEBALL_STATES=${NINEBALL_STATES:-$results/states}
export NINEBALL_STATES

# One line for each page: name, chapter, fewest bits, expectation, failing checks in the other modes, then bits and parts.
for page; do
  name=$(basename "$page" .md)
  which=parts
  case $page in */7-assemblies/*) which=all ;; esac # these would take an hour
  test -s "$results/$name.txt" || {
    status=0
    "$nineball" check "$page" --rounding $which >"$work/one" 2>"$work/errors" || status=$?
    case $status in
    0 | 1) ;;
    3) sed -n 's/^nineball: with \(rounding .*\):$/  \1 aborts the run/p' "$work/errors" >>"$work/one" ;;
    *)
      cat "$work/errors" >&2
      exit 1
      ;;
    esac
    mv "$work/one" "$results/$name.txt"
    echo "$name" >&2
  }
  awk -v name="$name" -v chapter="$(basename "$(dirname "$page")")" '
    /^  rounding .* aborts the run$/ { fewest = 0; text = $0; sub(/^ */, "", text); next }
    /^  rounding (up|down|zero) / { split($3, a, "of"); failed += $5 - $3; next }
    /^  bits that do not depend/ { list = 1; next }
    /^  with one part/ { list = 2; next }
    list && $1 !~ /^[0-9-]+$/ { list = 0 }
    list == 1 && $1 != "-" && (fewest == "" || $1 + 0 < fewest) { fewest = $1 + 0; text = $0; sub(/^ *[0-9]+ +/, "", text) }
    list == 2 { bits = $1; part = $0; sub(/^ *[0-9]+ +/, "", part); if (bits < 53) parts = parts "\t" bits "\t" part }
    END { gsub(/ +/, " ", text); printf "%s\t%s\t%s\t%s\t%d%s\n", name, chapter, fewest, text, failed, parts }' "$results/$name.txt"
done >"$work/rows"

silent=0
for name in $(awk -F '\t' '$3 != "" && $3 < 30 { print $1 }' "$work/rows"); do
  for page; do
    case $page in
    */"$name".md) tr '\n' ' ' <"$page" | grep -q 'rounding mode' || {
      echo "$page keeps fewer than 30 bits: it should state why, in a sentence with the words \`rounding mode\`" >&2
      silent=1
    } ;;
    esac
  done
done

awk -F '\t' '
  function median(list, n,   i, j, t) { for (i = 2; i <= n; i++) for (j = i; j > 1 && list[j - 1] > list[j]; j--) { t = list[j]; list[j] = list[j - 1]; list[j - 1] = t }
    return n % 2 ? list[(n + 1) / 2] : (list[n / 2] + list[n / 2 + 1]) / 2 }
  { pages++; if ($3 == "") { none++; next }
    bits[++n] = $3; few += $3 < 30; failing += $5 > 0
    rows[n] = sprintf("| [%s](../cases/%s/%s.md) | %d | `%s` | %s |", $1, $2, $1, $3, $4, $5 ? $5 : "")
    worst = ""; least = 53; for (k = 6; k < NF; k += 2) if ($k + 0 < least) { least = $k + 0; worst = $(k + 1) }
    if (worst == "") next
    with++; motion += worst == "motion"; for (k = 6; k < NF; k += 2) if ($(k + 1) ~ /^disc-/ && (!($1 in geometry) || $k + 0 < geometry[$1])) geometry[$1] = $k + 0 }
  END {
    print "# Rounding\n"
    print "`make rounding` writes this document ([rounding.sh](rounding.sh)). Each short case runs under the four rounding modes of"
    print "IEEE 754: to nearest, up, down and towards zero. The mode holds in the cycles and in the steps of contact tests. Pages,"
    print "references, recorded values and the verdict are always computed with rounding to nearest. `nineball check PAGE --rounding all` does the same for"
    print "one page.\n"
    print "The table gives the number of leading bits of a result that are the same in all modes. A double has 53 bits."
    print "[METHOD](METHOD.md#rounding) defines the count.\n"
    printf "- The median over %d cases is %g bits. %d cases keep fewer than 30 bits; the page of each states why.\n", pages, median(bits, n), few
    printf "- In %d cases each part of the cycle was also run alone in another mode. In %d of them the motion costs the most bits.\n", with, motion
    print "  The motion adds a small displacement to a large coordinate, and the overlap is the small difference of two such coordinates. The bits of a"
    print "  force are at most those of a coordinate minus log2(coordinate/overlap)."
    printf "- In %d cases some check fails in another mode. Some of these checks require equality to the last bit, for example of a run\n", failing
    print "  and its mirror image. Rounding up is not symmetric: where one of the two is rounded away from zero, the other one is rounded"
    print "  towards zero. Rounding towards zero is symmetric.\n"
    if ("invariance-far" in geometry)
      printf "**Far from the origin**, at 1 km, [invariance-far](../cases/5-numerics/invariance-far.md) keeps fewer bits than the same scene at the\norigin. With the geometry alone in another mode it keeps %d bits. So even if the motion had no rounding errors,\nonly %d bits would remain, as long as the geometry is computed from rounded coordinates.\n\n**Two-part coordinates** were tried: each coordinate of a particle or wall got a second double with the part that rounding cuts\noff, and the geometry used both parts. At 1 km this scene kept 27 bits instead of 19, and near the origin 37 instead of 29.\nForty bits are out of reach in doubles: the overlap is $2^{-12}$ of the distance of two centres. A single step therefore leaves at\nmost 41 of 53 bits, and the errors of many steps add up. So two-part coordinates are not in the program.\n\n", geometry["invariance-far"], geometry["invariance-far"]
    print "| case | bits | expectation with the fewest | checks that fail in the other modes |"
    print "| --- | --- | --- | --- |"
    for (k = 1; k <= n; k++) print rows[k] }' "$work/rows" | cat -s >"$work/document"
cp "$work/document" "$file"
echo "look at $file"
exit $silent
