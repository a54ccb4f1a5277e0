#!/bin/sh
# Counts the instructions of each pass for a contact update and for a particle, by callgrind, in the loops for AVX2.
#
#   instructions.sh -o FILE      writes the table FILE        instructions.sh -c FILE   compares with it
#
#   NINEBALL   the program, built with -g -O3            SIDE   particles on a side, 32
#
# The packings are the lattices of packing.awk. Each runs with 100 and with 300 cycles. The difference divided by 200 is the
# count of a cycle, in which reading and start cancel. The number of contacts is the one that `nineball explain` prints, with
# three digits. Functions with less than one instruction per particle are left out. Counts depend on the compiler, and repeat
# exactly, so a loop that has become slower is found without a timed test.
#
# Exit status: 0; with -c, 1 if a pass executes over 2 % more than the table says, 2 wrong use.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu
export LC_ALL=C OMP_NUM_THREADS=1 OMP_WAIT_POLICY=passive
case $#$1 in 2-o | 2-c) ;; *) echo 'usage: instructions.sh -o|-c FILE' >&2 && exit 2 ;; esac
awk=${AWK:-awk} side=${SIDE:-32}
nineball=$(cd "$(dirname "${NINEBALL:-./nineball}")" && pwd)/$(basename "${NINEBALL:-./nineball}")
folder=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# profile FILE: the instructions of each function of the simulator, without those of the functions that it calls.
profile() {
  $awk '
    function function_name(text, id) {
      sub(/^c?fn=/, "", text)
      id = text
      sub(/ .*/, "", id)
      if (text ~ / /) { sub(/^[^ ]* /, "", text); sub(/[.].*/, "", text); named[id] = text }
      return named[id]
    }
    /^fn=/ { name = function_name($0); next }
    /^cfn=/ { function_name($0); next }
    /^calls=/ { inclusive = 1; next }
    /^[0-9+*-]/ { if (!inclusive) sum[name] += $2; inclusive = 0 }
    END { for (name in sum) printf "%s %.0f\n", name, sum[name] }' "$1"
}

# measure KIND LAW: prints the lines of the table.
measure() {
  for cycles in 100 300; do
    $awk -v n="$side" -v kind="$1" -v law="$2" -v cycles=$cycles -v folder="$work" -f "$folder/packing.awk"
    (cd "$work" && valgrind --tool=callgrind --callgrind-out-file=counts "$nineball" figure page.md --isa avx2 --threads 1 \
      --jobs 1 >said 2>&1) || { cat "$work/said" >&2 && exit 2; }
    profile "$work/counts" >"$work/$cycles"
  done
  $awk -v kind="$1" -v law="$2" \
    -v updates="$("$nineball" explain "$work/page.md" | sed -n 's/.* cycles, \([^ ]*\) contact updates.*/\1/p')" \
    -v particles="$(sed -n 's/ atoms//p' "$work/data.txt")" '
    BEGIN { contacts = updates / 300 }
    NR == FNR { before[$1] = $2; next }
    { more = ($2 - before[$1]) / 200; all += more }
    more >= particles { printf "%s\t%s\t%s\t%.1f\t%.1f\n", kind, law, $1, more / contacts, more / particles }
    END { printf "%s\t%s\tall\t%.1f\t%.1f\n", kind, law, all / contacts, all / particles }' "$work/100" "$work/300" |
    sort -t '	' -k4,4nr
}

{
  printf 'packing\tlaw\tfunction\ta contact\ta particle\n'
  for law in linear hertz; do measure lattice $law; done
} >"$work/table"
if test "$1" = -o; then
  mv "$work/table" "$2"
else
  $awk -F '\t' 'NR == FNR { was[$1, $2, $3] = $4; next }
    FNR > 1 && was[$1, $2, $3] && $4 > 1.02 * was[$1, $2, $3] { print $3 ": " $4 " instructions a contact, not " was[$1, $2, $3]; bad = 1 }
    END { exit bad }' "$2" "$work/table"
fi
