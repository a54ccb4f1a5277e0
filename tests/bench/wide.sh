#!/bin/sh
# Tests that the loop of every law is vectorised in every instruction set, according to the compiler.
#
#   CC=... FLAGS=... wide.sh LAW.c ...
#
# NB_FORMS makes functions NAME_plain, NAME_avx2 and NAME_avx512 of the loop of each law. Each is compiled here as in
# the library, with the compiler's report on vectorised loops. A law that declares BRANCHING is not tested. Prints one
# line for each function: its name and the bytes of its vectors, or NARROW.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Prints "FUNCTION BYTES" for each function of file $1 with a vectorised loop. The compiler must not replace loops by calls of
# memset, because the report does not have such loops.
ask_gcc() {
  : >"$work/account"
  $CC $FLAGS -fno-tree-loop-distribute-patterns -fdump-tree-vect-optimized="$work/account" -c -o "$work/law.o" "$1"
  awk '/^;; Function/ { name = $3 }
       match($0, /loop vectorized using [0-9]+/) { print name, substr($0, RSTART + 22, RLENGTH - 22) }' "$work/account"
}

ask_clang() {
  : >"$work/account"
  $CC $FLAGS -fsave-optimization-record -foptimization-record-passes=loop-vectorize \
    -foptimization-record-file="$work/account" -c -o "$work/law.o" "$1"
  awk '/^---/ { passed = $2 == "!Passed" }
       $1 == "Function:" { name = $2 }
       $2 == "VectorizationFactor:" && passed { gsub(/[^0-9]/, "", $3); print name, 8 * $3 }' "$work/account"
}

if $CC --version | grep -q clang; then ask=ask_clang; else ask=ask_gcc; fi

narrow=0
for law in "$@"; do
  name=$(basename "$law" .c)
  if grep -q '^#define BRANCHING' "$law"; then
    printf '%-36s declares BRANCHING, not tested\n' "$name"
    continue
  fi
  loops=$($CC $FLAGS -E "$law" | grep -oE 'static void [a-z0-9_]+_(plain|avx2|avx512)\(' | sed 's/.* //; s/(//')
  if [ -z "$loops" ]; then
    echo "$law: no loop found; does NB_FORMS still name them _plain, _avx2, _avx512?" >&2
    exit 1
  fi
  $ask "$law" >"$work/wide"
  for loop in $loops; do
    bytes=$(sed -n "s/^$loop //p" "$work/wide" | sort -n | tail -n 1)
    if [ -n "$bytes" ]; then
      printf '%-36s %3d bytes\n' "$loop" "$bytes"
    else
      printf '%-36s NARROW\n' "$loop"
      narrow=$((narrow + 1))
    fi
  done
done
if [ "$narrow" -gt 0 ]; then
  echo "$narrow loops are not vectorised; see \"Straight-line laws\" in src/laws/law.h, or let the law declare BRANCHING" >&2
  exit 1
fi
