#!/bin/sh
# Tests that all tables of a page are the same, byte by byte, for 1, 2, 3, 4 and 7 threads and each instruction set, and that
# the program has no fused multiply-add. TAP. $NINEBALL is the program, ./nineball by default; $srcdir is the top of the
# source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

nineball=${NINEBALL:-./nineball}
export OMP_WAIT_POLICY=passive # there may be more threads than processors
page=${srcdir:-.}/tests/pages/same-bits.md
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT

# Runs the page and writes all tables, with their names, to one file.
run() {
  folder=$work/$1
  shift
  "$nineball" run "$page" -o "$folder" "$@" >"$work/out" 2>"$work/said" || return
  for file in "$folder"/*.tsv; do
    echo "== ${file##*/}"
    cat "$file"
  done >"$folder.all"
}

set -- '--threads 7' ''
for isa in plain avx2 avx512; do
  for threads in 1 2 3 4; do
    set -- "$@" "--threads $threads --isa $isa"
  done
done
echo "1..$(($# + 3))"

rows=0
if run first --threads 1 --isa plain; then
  rows=$(grep -c '[0-9]	rest	' "$work/first/table.tsv")
fi
# 10 rows of the last stage in each of two runs; in the second run a disc slides along a wall.
if test "$rows" -eq 20 && cut -f 28 "$work/first/table.tsv" | grep -qx 1; then
  echo "ok 1 - the page runs"
else
  echo "not ok 1 - the page runs"
  sed 's/^/# /' "$work/said"
fi

# With too few contacts there would be fewer threads, and all runs below would be the same run.
if ! grep -qE 'GOMP_parallel|__kmpc_fork' "$nineball"; then
  echo "ok 2 - the page has enough contacts for four threads # SKIP compiled without OpenMP"
elif "$nineball" explain "$page" --threads 4 | grep -q ' 4 threads'; then
  echo "ok 2 - the page has enough contacts for four threads"
else
  echo "not ok 2 - the page has enough contacts for four threads"
fi

# A fused multiply-add rounds once instead of twice. gcc makes some of them also with -ffp-contract=off.
name='3 - the program has no fused multiply-add'
if ! objdump -d --no-show-raw-insn "$nineball" >"$work/code" 2>"$work/said" || ! grep -q mulsd "$work/code"; then
  echo "ok $name # SKIP no x86 program, or no objdump"
elif awk '/>:$/ { name = $2 } /vfn?m(add|sub)/ { print "# " name " " $0 }' "$work/code" | grep . >"$work/said"; then
  echo "not ok $name"
  cat "$work/said"
else
  echo "ok $name"
fi

n=3
for options in "$@"; do
  n=$((n + 1))
  if run "$n" $options; then
    if cmp "$work/first.all" "$work/$n.all" >"$work/said" 2>&1; then
      echo "ok $n - ${options:-default options}"
    else
      echo "not ok $n - ${options:-default options}"
      sed 's/^/# /' "$work/said"
    fi
  elif grep -q 'this machine does not run' "$work/said"; then
    echo "ok $n - $options # SKIP not on this machine"
  else
    echo "not ok $n - $options"
    sed 's/^/# /' "$work/said"
  fi
done
