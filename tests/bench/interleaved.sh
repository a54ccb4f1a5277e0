#!/bin/bash
# Measures the processor time of a cycle of several programs on the same packings, in interleaved repeats, as the time of a long
# run minus that of a short run.
#
#   interleaved.sh SIDES KINDS LAWS REPEATS PROGRAM ...      lists are in quotes
#
# A program of the name `lmp` is LAMMPS, `liggghts` LIGGGHTS and `yade` YADE; others are nineball.
#
# Prints a line for each packing and law: particles, kind, law, then for each program the median, the least and the greatest time
# of a cycle, ns. The time is user and system time of one thread, which other processes disturb less than elapsed time. Exit
# status: 0, 2 a run failed.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -euo pipefail
export LC_ALL=C OMP_NUM_THREADS=1 OMP_WAIT_POLICY=passive
folder=$(cd "$(dirname "$0")" && pwd) sides=$1 kinds=$2 laws=$3 repeats=$4
shift 4
for program in "$@"; do # runs are in other folders
  command -v "$program" >/dev/null || { echo "interleaved.sh: there is no program $program" >&2 && exit 2; }
  case $program in */*) program=$(cd "$(dirname "$program")" && pwd)/$(basename "$program") ;; esac
  set -- "${@:2}" "$program"
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
TIMEFORMAT='%3U %3S'

# User and system time of one run of the program in the folder, s.
run() {
  cd "$work/$2"
  case $(basename "$1") in
  lmp) set -- "$1" -in in.txt -log none -screen none ;;
  liggghts) set -- "$1" -in liggghts.txt -log none -screen none ;;
  yade) set -- "$1" -n -x -j1 "$folder/yade.py" ;;
  *) set -- "$1" figure page.md --threads 1 --jobs 1 ;;
  esac
  if ! { time "$@" >"$work/said" 2>&1; } 2>"$work/clock"; then
    echo "interleaved.sh: this run failed: $*" >&2 && cat "$work/said" >&2
    exit 2
  fi
  awk '{ print $1 + $2 }' "$work/clock"
}

for side in $sides; do for kind in $kinds; do for law in $laws; do
  short=$((1000000 / (side * side + 100) + 1)) long=$((11 * (1000000 / (side * side + 100) + 1)))
  for length in short long; do
    mkdir -p "$work/$length"
    ${AWK:-awk} -v n="$side" -v kind="$kind" -v law="$law" -v cycles="${!length}" -v folder="$work/$length" \
      -f "$folder/packing.awk"
  done
  for ((k = 0; k < repeats; k++)); do
    for ((p = 1; p <= $#; p++)); do
      of_long=$(run "${!p}" long)
      of_short=$(run "${!p}" short)
      echo "$p $of_long $of_short"
    done
  done | awk -v programs=$# -v cycles=$((long - short)) '{ printf "%d %.1f\n", $1, ($2 - $3) / cycles * 1e9 }' | sort -k1,1n -k2,2n >"$work/times"
  awk -v head="$(sed -n 's/ atoms//p' "$work/long/data.txt") $kind $law" '
    { time[$1, ++count[$1]] = $2; programs = $1 }
    END {
      printf "%s", head
      for (p = 1; p <= programs; p++) {
        n = count[p]; median = n % 2 ? time[p, (n + 1) / 2] : (time[p, n / 2] + time[p, n / 2 + 1]) / 2
        printf " %.0f %.0f %.0f", median, time[p, 1], time[p, n]
      }
      print ""
    }' "$work/times"
done; done; done
