#!/bin/sh
# Compares the speed of nineball and LAMMPS, and writes docs/PERFORMANCE.md.
#
#   performance.sh -o FILE TIMES INSTRUCTIONS GOALS     measures, and writes the times to the file TIMES, and GOALS
#   performance.sh -t FILE TIMES INSTRUCTIONS GOALS     writes the document again, from the times measured before
#
# INSTRUCTIONS is the table of instructions.sh, and GOALS that of goals.sh.
#
#   NINEBALL   the program, built with -g -O3        SIDES     particles on a side, "5 32 100 280"
#   FLAGS      its compiler and flags                REPEATS   interleaved repeats of each program, 5
#
# LAMMPS is installed with apt-get if it is missing and this user may do so. Exit status: 0, 77 LAMMPS is missing.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu
export LC_ALL=C
case $#$1 in 5-o | 5-t) ;; *) echo 'usage: performance.sh -o|-t FILE TIMES INSTRUCTIONS GOALS' >&2 && exit 2 ;; esac
nineball=$(cd "$(dirname "${NINEBALL:-./nineball}")" && pwd)/$(basename "${NINEBALL:-./nineball}")
folder=$(dirname "$0") times=$3 instructions=$4 goals=$5
if test "$1" = -o; then
  command -v lmp >/dev/null || { apt-get update && apt-get install -y --no-install-recommends lammps; } >&2 ||
    { echo 'performance.sh: this needs lmp, of the package lammps' >&2 && exit 77; }
  {
    printf 'machine\t%s\n' "$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)"
    printf 'nineball\t%s\n' "${FLAGS:-flags unknown}"
    printf 'LAMMPS\t%s\n' "$(dpkg-query -W -f '${Package} ${Version}' lammps 2>/dev/null || echo unknown)"
    printf 'repeats\t%s\n' "${REPEATS:-5}"
    bash "$folder/interleaved.sh" "${SIDES:-5 32 100 280}" "lattice random" "linear hertz" "${REPEATS:-5}" "$nineball" lmp |
      tr ' ' '\t'
  } >"$times-t"
  mv "$times-t" "$times"
  NINEBALL=$nineball bash "$folder/goals.sh" -o "$goals"
fi
told() { awk -F '\t' -v name="$1" '$1 == name { print $2 }' "$times"; }
repeats=$(told repeats)

times_table() {
  echo '| particles | packing | law | nineball | least to greatest | LAMMPS | least to greatest | ratio |'
  echo '| --- | --- | --- | --- | --- | --- | --- | --- |'
  awk '$1 + 0 { printf "| %d | %s | %s | %.2f | %.2f to %.2f | %.2f | %.2f to %.2f | %.1f |\n", $1, $2, $3, $4 / 1e3, $5 / 1e3, $6 / 1e3, $7 / 1e3, $8 / 1e3, $9 / 1e3, $7 / $4 }' "$times"
}
commands_table() {
  echo '```sh'
  awk '$1 + 0 { side = int(sqrt($1 / ($2 == "random" ? 0.9 : 1)) + 0.5); if ($2 == "lattice") last = side
    printf "bash tests/bench/interleaved.sh %d %s %s '"$repeats"' build/nineball lmp     # %d particles\n", last, $2, $3, $1 }' "$times"
  echo '```'
}
instructions_table() {
  echo '| law | function | instructions a contact | instructions a particle |'
  echo '| --- | --- | --- | --- |'
  awk -F '\t' 'NR > 1 { printf "| %s | `%s` | %s | %s |\n", $2, $3, $4, $5 }' "$instructions"
}
rate_table() {
  echo '| particles | law | instructions in a nanosecond | instructions a particle | for a ratio of 8 |'
  echo '| --- | --- | --- | --- | --- |'
  awk 'NR == FNR { if ($3 == "all") of[$2] = $5; next }
    $2 == "lattice" && $1 >= 1000 { printf "| %d | %s | %.1f | %.0f | %.0f |\n", $1, $3, of[$3] * $1 / $4, of[$3], of[$3] * $7 / $4 / 8 }' "$instructions" "$times"
}
# The goals: first the ratios to LAMMPS, the least and the greatest of the packings of a size, then the table of goals.sh.
goals_table() {
  echo '| particles | quantity | goal | measured | least to greatest | command |'
  echo '| --- | --- | --- | --- | --- | --- |'
  awk -F '\t' '
    function row(n, what, goal, value, low, high, command) { printf "| %d | %s | %s | %s | %s to %s | `%s` |\n", n, what, goal, value, low, high, command }
    NR == FNR { if ($1 + 0) { size = $1 < 100 ? 25 : $1 < 2000 ? 1000 : $1 < 20000 ? 10000 : 100000; r = $7 / $4
        if (!(size in low) || r < low[size]) low[size] = r
        if (r > high[size]) high[size] = r }
      next }
    FNR == 1 { for (size = 1000; size <= 100000; size *= 10)
        row(size, "times the speed of LAMMPS", size < 50000 ? "at least 8" : "at least 6", sprintf("%.1f to %.1f", low[size], high[size]), sprintf("%.1f", low[size]), sprintf("%.1f", high[size]), "make bench") }
    { goal["nine"] = "at most 220"; goal["exact"] = "at least 30"; goal["threads"] = "at least 1.7, and 0.95 beside other programs"
      goal["elapsed"] = "at most 3"; goal["processor"] = "-"; goal["memory"] = "at most 400"
      row($2, $3, goal[$1], $4, $5, $6, "ONLY=" ($1 ~ /elapsed|processor|memory/ ? "million" : $1) " bash tests/bench/goals.sh -o goals.tsv") }' "$times" "$goals"
}

{
  cat <<TEXT
# Speed of a cycle, compared with LAMMPS

\`make bench\` writes this document ([tests/bench/performance.sh](../tests/bench/performance.sh)).

## Method

Both programs read the same spheres ([tests/bench/packing.awk](../tests/bench/packing.awk)), and make the same steps
with the same stiffnesses. In the packing \`lattice\` neighbours in a triangular lattice overlap by 0.5 % of the radius.
In the packing \`random\` every tenth place is empty, the radii differ by up to 0.2 %, and the numbers are shuffled. The
outermost spheres are fixed. The law \`linear\` is \`gran/hooke/history\` in LAMMPS, and \`hertz\` with \`shear mindlin\`
is \`gran/hertz/history\`. Both have friction and dashpots. The dashpots of the two programs depend differently on mass
and stiffness; the constants agree in the lattice.

Times are user and system times of one thread. The time of a cycle is the difference of the times of a long
and a short run, over the difference of their cycles, so reading and start cancel. The programs take turns. The table has medians of
$repeats repeats, with the least and the greatest. Other programs ran on this machine at the same time, so the spread
belongs to every number.

Machine: $(told machine). nineball: $(told nineball). LAMMPS: Debian's $(told LAMMPS).

## Times of a cycle

Times are in microseconds. The ratio is the median of LAMMPS over that of nineball.

TEXT
  times_table
  printf '\nThe commands of the rows, which print nanoseconds:\n\n'
  commands_table
  printf '\n## Goals\n\nThese are goals of the design. The table has medians. The commands need `NINEBALL=build/nineball`.\n\n'
  goals_table
  cat "$folder/goals.md"
  printf "\n## Instructions\n\n"
  cat <<TEXT
\`make bench-self\` counts the instructions of a cycle by callgrind
([tests/bench/instructions.sh](../tests/bench/instructions.sh)) and compares them with
[the recorded table](performance/instructions.tsv). It fails if a function needs over 2 % more. The packing is the
lattice with 1024 spheres, and the loops are those for AVX2. \`sum\` sums the forces on each particle, and \`move\` integrates
the motion. \`with_tangential_increment\` is the geometry of two particles, and \`with_shear\` resolves the forces.

TEXT
  instructions_table
  cat <<TEXT

The quotient of this count and the times above is the rate at which the machine executes instructions. The last column
is the number of instructions that it could execute at this rate in an eighth of the time of LAMMPS, per particle:

TEXT
  rate_table
  cat "$folder/tried.md"
} >"$2-t"
mv "$2-t" "$2"
