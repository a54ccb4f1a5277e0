#!/bin/sh
# Compares the speed of nineball with that of LAMMPS, LIGGGHTS and YADE and with the limits of the machine, and writes
# docs/PERFORMANCE.md.
#
#   performance.sh -o FILE FOLDER     measures, writes the tables times.tsv, rows.tsv, others.tsv, machine.tsv, passes.tsv and
#                                     goals.tsv to FOLDER
#   performance.sh -t FILE FOLDER     writes the document again, from the tables measured before
#
# FOLDER/instructions.tsv is the table of instructions.sh.
#
#   NINEBALL   the program, built with -g -O3        SIDES     particles on a side, "5 32 100 280"
#   FLAGS      its compiler and flags                OTHERS    the same for LIGGGHTS and YADE, "32 100"
#   MACHINE    the program of machine.c              ROWS      the same for numbers in rows, "100 280"
#   PASSES     the program of passes.c               REPEATS   interleaved repeats of each program, 5
#
# Packages of other programs are installed with apt-get if they are missing and this user may do so. Exit status: 0, 2 a run failed,
# 77 a program is missing.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu
export LC_ALL=C
case $#$1 in 3-o | 3-t) ;; *) echo 'usage: performance.sh -o|-t FILE FOLDER' >&2 && exit 2 ;; esac
nineball=$(cd "$(dirname "${NINEBALL:-./nineball}")" && pwd)/$(basename "${NINEBALL:-./nineball}")
folder=$(dirname "$0") tables=$3
times=$tables/times.tsv rows=$tables/rows.tsv others=$tables/others.tsv machine=$tables/machine.tsv instructions=$tables/instructions.tsv goals=$tables/goals.tsv passes=$tables/passes.tsv
version() { echo "$1 $(dpkg-query -W -f '${Version}' "$1" 2>/dev/null || echo unknown)"; }
# compare FILE SIDES KINDS PROGRAM ...: the rows of interleaved.sh.
compare() {
  file=$1 sides=$2 kinds=$3
  shift 3
  bash "$folder/interleaved.sh" "$sides" "$kinds" "linear hertz" "${REPEATS:-5}" "$@" >"$file-rows"
  tr ' ' '\t' <"$file-rows" >>"$file-t"
  rm "$file-rows"
  mv "$file-t" "$file"
}
# pass_times SIDE KIND LAW ISA: the line of passes.tsv, from the least of three runs.
pass_times() {
  ${AWK:-awk} -v n="$1" -v kind="$2" -v law="$3" -v cycles=1 -v folder="$work" -f "$folder/packing.awk"
  for run in 1 2 3; do "${PASSES:-tests/bench/passes}" "$work/page.md" "$4" 2>&1; done | awk -v head="$2\t$3\t$4" '
    /particles$/ { particles = $(NF - 1); next }
    { name = /^disc/ ? "geometry" : /^large/ ? "large" : /^resolve/ ? "forces" : $1; sub(/,.*/, "", name)
      if (!(name in least) || $NF < least[name]) least[name] = $NF }
    END { if (particles) printf "%d\t%s\t%.1f\t%.1f\t%.1f\t%.1f\t%.1f\t%.1f\t%.1f\n", particles, head, least["geometry"], least["normal"],
      least["shear"] + least["large"], least["dashpots"], least["forces"], least["motion"], least["cycle"] }'
}
if test "$1" = -o; then
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  for program in lmp liggghts yade; do
    command -v $program >/dev/null || { apt-get update && apt-get install -y --no-install-recommends lammps liggghts yade; } >&2 ||
      { echo "performance.sh: this needs $program, of the packages lammps, liggghts and yade" >&2 && exit 77; }
  done
  "${MACHINE:-tests/bench/machine}" >"$machine-t"
  mv "$machine-t" "$machine"
  {
    printf 'machine\t%s\n' "$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)"
    printf 'nineball\t%s\n' "${FLAGS:-flags unknown}"
    printf 'packages\t%s, %s, %s\n' "$(version lammps)" "$(version liggghts)" "$(version yade)"
    printf 'repeats\t%s\n' "${REPEATS:-5}"
    printf 'load\t%s\n' "$(cut -d ' ' -f 1 /proc/loadavg)"
  } >"$times-t"
  compare "$times" "${SIDES:-5 32 100 280}" "lattice random" "$nineball" lmp
  : >"$rows-t"
  compare "$rows" "${ROWS:-100 280}" "random rows" "$nineball" lmp
  : >"$others-t"
  compare "$others" "${OTHERS:-32 100}" lattice "$nineball" lmp liggghts yade
  for row in "32 lattice linear" "32 random linear" "100 lattice linear" "100 random linear" "280 lattice linear" "280 random linear" \
    "32 lattice hertz" "100 lattice hertz" "280 lattice hertz"; do
    # shellcheck disable=SC2086
    for isa in avx2 avx512; do pass_times $row $isa; done
  done >"$passes-t"
  mv "$passes-t" "$passes"
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
rows_table() {
  echo '| particles | law | shuffled | in rows | least to greatest | shorter by | LAMMPS | ratio |'
  echo '| --- | --- | --- | --- | --- | --- | --- | --- |'
  awk '$2 == "random" { shuffled[$1, $3] = $4 }
    $2 == "rows" { printf "| %d | %s | %.0f | %.0f | %.0f to %.0f | %.0f %% | %.0f | %.1f |\n", $1, $3, shuffled[$1, $3] / 1e3, $4 / 1e3,
      $5 / 1e3, $6 / 1e3, 100 * (1 - $4 / shuffled[$1, $3]), $7 / 1e3, $7 / $4 }' "$rows"
}
others_table() {
  echo '| particles | packing | law | nineball | LAMMPS | ratio | LIGGGHTS | ratio | YADE | ratio |'
  echo '| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |'
  awk '{ printf "| %d | %s | %s | %.1f", $1, $2, $3, $4 / 1e3
    for (p = 7; p <= NF; p += 3) printf " | %.1f | %.1f", $p / 1e3, $p / $4
    print " |" }' "$others"
}
machine_table() {
  echo '| quantity | unit | AVX2 | AVX-512 |'
  echo '| --- | --- | --- | --- |'
  awk -F '\t' '{ printf "| %s | %s | %s | %s |\n", $1, $2, $3, $4 }' "$machine"
}
passes_table() {
  echo '| particles | packing | law | loops | geometry | normal law | shear law | dashpots | forces | motion | whole cycle |'
  echo '| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |'
  awk -F '\t' '{ sub(/avx2/, "AVX2"); sub(/avx512/, "AVX-512"); gsub(/\t/, " | "); print "| " $0 " |" }' "$passes"
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
    { goal["nine"] = "at most 220"; goal["exact"] = "at least 30"; goal["threads"] = "at least 1.7"; goal["busy"] = "at least 0.95"
      goal["elapsed"] = "at most 3"; goal["processor"] = "-"; goal["memory"] = "at most 400"
      goal["moving"] = "at most 1.3"; goal["sample"] = "at most 4"; goal["state"] = "at least 30"
      row($2, $3, goal[$1], $4, $5, $6, "ONLY=" ($1 ~ /elapsed|processor|memory/ ? "million" : $1 == "state" ? "sample" : $1) " bash tests/bench/goals.sh -o goals.tsv") }' "$times" "$goals"
}

{
  cat <<TEXT
# Speed of a cycle, compared with other programs and with the machine

\`make bench\` writes this document ([tests/bench/performance.sh](../tests/bench/performance.sh)).

## Method

All programs read the same spheres ([tests/bench/packing.awk](../tests/bench/packing.awk)), and make the same steps
with the same stiffnesses. In the packing \`lattice\` neighbours in a triangular lattice overlap by 0.5 % of the radius.
In the packing \`random\` every tenth place is empty, the radii differ by up to 0.2 %, and the numbers are shuffled. The
outermost spheres are fixed. The law \`linear\` is \`gran/hooke/history\` in LAMMPS, and \`hertz\` with \`shear mindlin\`
is \`gran/hertz/history\`. Both laws have friction and dashpots. The dashpots of nineball and LAMMPS depend differently on mass
and stiffness; in the lattice their constants are equal. LIGGGHTS has the models \`hooke/stiffness\` and \`hertz/stiffness\`
with tangential history. In two dimensions its particles are discs: they get the masses of the spheres, but the moments
of inertia of discs. YADE has \`Law2_ScGeom_ViscElPhys_Basic\` and \`Law2_ScGeom_MindlinPhys_Mindlin\`
([tests/bench/yade.py](../tests/bench/yade.py)). The first forces on the free spheres were compared once, in the packing
\`random\` with 133 spheres. With the linear law all four programs agree within 1e-14 of the largest force. With
Hertz's law nineball agrees within 1e-14 with YADE, within 5e-10 with LIGGGHTS and within 5e-7 with LAMMPS. The
constants in the inputs of LIGGGHTS have nine digits, and those of LAMMPS six.

Times are user and system times of one thread. The time of a cycle is the difference of the times of a long
and a short run, divided by the difference of their numbers of cycles, so reading and start cancel. The programs take turns. The table has medians of
$repeats repeats, with the least and the greatest.

Machine: $(told machine), load $(told load) at the beginning. nineball: $(told nineball). The others are Debian's packages
$(told packages).

## Times of a cycle

Times are in microseconds. The ratio is the median of LAMMPS over that of nineball.

TEXT
  times_table
  printf '\nThe commands of the rows, which print nanoseconds:\n\n'
  commands_table
  cat <<TEXT

## Order of the numbers

The packing \`random\` once more, with shuffled numbers and with numbers in rows. Times are in microseconds; the ratio is that
of LAMMPS to numbers in rows. LAMMPS sorts its particles from time to time; nineball does not. A contact needs the data of two
particles. If their numbers are far apart, their data are far apart in memory. The clause \`sorted\` of \`packing\` numbers the
particles of a file in rows. The command of a row is that of the rows above with \`random rows\` as packings.

TEXT
  rows_table
  cat <<TEXT

## Other programs

This table adds LIGGGHTS and YADE, for the lattice. Times are in microseconds; each ratio is the median of the program on its
left divided by that of nineball. The command is that of the rows above, with \`lmp liggghts yade\` instead of \`lmp\`.

TEXT
  others_table
  printf '\n## Goals\n\nThe goals were set for the design of the program. Except in the first three rows, the column `measured` has medians. The commands need `NINEBALL=build/nineball`.\n\n'
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

The times above are those of the widest loops of the processor. So this count divided by them is only an estimate of
the rate at which the machine executes instructions. The last column
is the number of instructions per particle that it could execute at this rate in an eighth of the time of LAMMPS:

TEXT
  rate_table
  cat <<TEXT

## Limits of the machine

[tests/bench/machine.c](../tests/bench/machine.c) measures the greatest rates of one core. Each bandwidth is that of arrays of
the size in its row. Arrays of 32 KiB fit into the first cache and arrays of 1 MiB into the second. Arrays of 512 MiB fit only
into memory.

TEXT
  machine_table
  cat <<TEXT

## Cycles of the processor

\`tests/bench/passes PAGE\` repeats each pass of a cycle alone on the arrays of a run, and takes the least of the times
([passes.c](../tests/bench/passes.c)). Other programs hardly change the least time. The table has the processor's clock cycles per
contact, the least of three runs. The shear law of Hertz's rows is \`mindlin\`, and its column includes the test for
large overlaps. \`motion\` is the sum of forces and the integration. The whole cycle is the least time of one without a
search. A processor without AVX-512 has no such rows.

TEXT
  passes_table
  cat "$folder/tried.md"
} >"$2-t"
mv "$2-t" "$2"
