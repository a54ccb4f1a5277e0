#!/bin/bash
# Measures the quantities for which docs/PERFORMANCE.md has goals, except the comparison with LAMMPS, and writes the table FILE.
#
#   goals.sh -o FILE
#
#   NINEBALL   the program, built with -g -O3        REPEATS   repeats, 5; the table has the median, the least and the greatest
#   ONLY       the rows to measure, "nine exact threads busy moving million sample"
# Each line of the table: goal, number of particles, the quantity and its unit, median, least, greatest. Rows that are not
# measured stay. The packings are those of packing.awk, and the sample is that of the page preparation-price. Exit status: 0,
# 2 wrong use or a failed run.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -euo pipefail
export LC_ALL=C
case $#$1 in 2-o) ;; *) echo 'usage: goals.sh -o FILE' >&2 && exit 2 ;; esac
program=$(realpath "${NINEBALL:-./nineball}") folder=$(realpath "$(dirname "$0")") repeats=${REPEATS:-5} awk=${AWK:-awk}
touch "$2" && table=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# packing SIDE KIND LAW CYCLES: writes page.md.
packing() { $awk -v n="$1" -v kind="$2" -v law="$3" -v cycles="$4" -v folder=. -f "$folder/packing.awk"; }
# clock FORMAT OPTION ...: the time of one run of page.md, s; `%e` elapsed, `%U` of the processor; `%M` memory, KiB.
clock() { command time -f "$1" -o clock "$program" figure page.md --jobs 1 "${@:2}" >said 2>&1 || { cat said >&2 && exit 2; }; cat clock; }
# keep GOAL PARTICLES QUANTITY: the line of the table from the numbers of the input.
keep() {
  sort -n | $awk -v head="$1	$2	$3" '{ x[NR] = $1 } END { printf "%s\t%.4g\t%.4g\t%.4g\n", head, x[int((NR + 1) / 2)], x[1], x[NR] }' >line
  grep -vF "$1	$2	$3	" "$table" >rest || :
  cat rest line >"$table"
}
# cycle_time WRITE CYCLES: the time of a cycle in ns, without reading and start. The command `WRITE N` writes page.md with N
# cycles.
cycle_time() {
  "$1" 1 && clock %U --threads 1 >short
  "$1" "$2" && clock %U --threads 1 | $awk -v short="$(cat short)" -v cycles="$2" '{ print ($1 - short) / cycles * 1e9 }'
}
nine_discs() {
  printf '```scene\nunits none\nmaterial rock density 1000 kn 1.35e9 ks 1.35e9 friction 2\nbox 0 0 to 300 300 rock\n' >page.md
  printf 'lattice discs 3 by 3 radius 50 rock\nstep 0.12 of single-contact\nstage load\nrecord none\nwalls inward 0.12\ncycles 40\n' >>page.md
  printf 'stage oscillate\nrecord none\nwalls stop\ncycles %d\n```\n' "$1" >>page.md
}
exact() { packing "$side" "$kind" exact "$1"; }
# sheared RATE CYCLES: writes page.md, the random packing in a periodic cell, which is relaxed and then sheared at this rate, 1/s.
sheared() {
  packing "$side" random linear 1
  $awk -v n="$side" -v rate="$1" -v cycles="$2" '
    /^step/ {
      d = 0.01995; h = d * sqrt(3) / 2
      printf "%s\nperiodic cell %.9g m %.9g m to %.9g m %.9g m\n", $0, -d / 4, -h / 2, d * n - d / 4, h * n - h / 2
      printf "stage relax\nrecord none\ncycles 3000\nstage run\nrecord none\n"
      if (rate > 0) printf "cell strain 0 1/s 0 1/s c12 %g 1/s\n", rate
      printf "cycles %d\n```\n", cycles
      exit
    }
    { sub(/ fixed$/, ""); print }' page.md >moved && mv moved page.md
}
# update_time RATE CYCLES: the time of a contact update in the sheared packing, ns.
update_time() {
  for length in 1 "$2"; do
    sheared "$1" "$length"
    command time -f %U -o clock "$program" run page.md -o out --jobs 1 --threads 1 >said 2>&1 || { cat said >&2 && exit 2; }
    echo "$(cat clock) $(sed -n 's/.* cycles, \([^ ]*\) contact updates.*/\1/p' said)"
  done | $awk '{ time[NR] = $1; updates[NR] = $2 } END { print (time[2] - time[1]) / (updates[2] - updates[1]) * 1e9 }'
}
# sample SEED RATE PART: prepares and shears a sample of preparation-price with these values of its sweeps, and writes the number of
# cycles to the file cycles.
sample() {
  command time -f %U -o clock "$program" run "$folder/../../cases/7-assemblies/preparation-price.md" -o out --jobs 1 --threads 1 \
    --set seed="$1" --set rate="$2" --set part="$3" >said 2>&1 || { cat said >&2 && exit 2; }
  sed -n 's/^ *\([0-9]*\) cycles, .*/\1/p' said >cycles
}

for row in ${ONLY:-nine exact threads busy moving million sample}; do case $row in
  nine) for ((k = 0; k < repeats; k++)); do cycle_time nine_discs 3000000; done | keep nine 9 "ns a cycle" ;;
  exact)
    for kind in lattice random; do for side in 3 32 100 265; do
      exact 1
      count=$(grep -c ^sphere page.md) updates=$("$program" explain page.md | sed -n 's/.* cycles, \([^ ]*\) contact updates.*/\1/p')
      test "$updates" != 0 || continue # the random packing of 9 spheres has no contact
      for ((k = 0; k < repeats; k++)); do # the forces of the start and of one cycle: two updates a contact
        cycle_time exact $((60000000 / (3 * side * side) + 1)) | $awk -v u="$updates" '{ print 1e3 * u / 2 / $1 }'
      done | keep exact "$count" "million updates a second, $kind packing"
    done; done ;;
  threads)
    for side in 100 290; do
      packing $side lattice linear $((30000000 / (side * side)))
      for ((k = 0; k < repeats; k++)); do
        clock %e --threads 1 >one && clock %e --threads 2 | $awk -v one="$(cat one)" '{ print one / $1 }'
      done | keep threads $((side * side)) "times the speed of one thread"
    done ;;
  busy) # beside as many programs as there are processors
    packing 100 lattice linear 3000
    for ((k = 0; k < $(nproc); k++)); do while :; do :; done & done
    for ((k = 0; k < repeats; k++)); do
      clock %e --threads 1 >one && clock %e --threads 2 | $awk -v one="$(cat one)" '{ print one / $1 }'
    done | keep busy 10000 "times the speed of one thread, beside other programs"
    kill $(jobs -p) ;;
  moving) # the inertial numbers of these rates are 1e-5, 1e-3 and 1e-2 at the pressure of the lattice
    for side in 32 100; do
      sheared 0 1
      count=$(grep -c ^sphere page.md)
      for ((k = 0; k < repeats; k++)); do
        rest=$(update_time 0 $((60000000 / count)))
        for rate in 0.0166 1.66 16.6; do
          update_time $rate $((60000000 / count)) | $awk -v rest="$rest" '{ print $1 / rest }' >>"rate-$rate-$count"
        done
      done
      for rate in 0.0166 1.66 16.6; do
        keep moving "$count" "times as long as at rest, sheared at $rate 1/s" <"rate-$rate-$count"
      done
    done ;;
  sample)
    for ((k = 1; k <= repeats; k++)); do sample $k 10 0.6 && cat clock; done >samples
    keep sample 300 "s of the processor, prepared and sheared" <samples
    command -v lmp >/dev/null || continue
    of_lammps=$(bash "$folder/interleaved.sh" 18 random hertz "$repeats" "$program" lmp | cut -d ' ' -f 7)
    for ((k = 1; k <= repeats; k++)); do
      sample $k 1 0.3 && $awk -v cycles="$(cat cycles)" -v of_lammps="$of_lammps" -v own="$(sed -n ${k}p samples)" \
        'BEGIN { print cycles * of_lammps / 1e9 / own }'
    done | keep state 300 "times less than all cycles of the thesis with LAMMPS" ;;
  million)
    packing 1000 lattice linear 2 # a page may have 4 MiB, so the spheres are in a list
    { echo 'x/m	y/m	radius/m' && sed -n 's/^sphere \([^ ]*\) m \([^ ]*\) m radius \([^ ]*\) m.*/\1	\2	\3/p' page.md; } >list.tsv
    sed '/^sphere/d; s/^damping ratio.*/&\npacking list.tsv spheres m/' page.md >short && mv short page.md
    for ((k = 0; k < repeats; k++)); do clock '%e %U %S %M' --threads 1; done >runs
    $awk '{ print $1 }' runs | keep elapsed 1000000 "s elapsed, read and started"
    $awk '{ print $2 + $3 }' runs | keep processor 1000000 "s of the processor, read and started"
    $awk '{ print $4 * 1024 / 1e6 }' runs | keep memory 1000000 "bytes a particle" ;;
  *) echo "goals.sh: there is no row $row" >&2 && exit 2 ;;
esac; done
