#!/bin/sh
# Coverage of the verdict by its tests. `make coverage` builds everything in coverage/ of the build folder with counters
# for lines and branches. It runs the unit tests of the verdict, the invalid pages and the test of the program, and
# fails if they execute less than 95 % of the branches. $srcdir is the top of the source tree, $CC the compiler.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu
suites="reducers verdict verdict_sweep verdict_sample verdict_skip outcome"
wanted=95 # per cent of the branches

unset MAKEFLAGS MFLAGS MAKELEVEL
here=$(cd "${srcdir:-.}" && pwd)
command -v gcovr >/dev/null || { echo "coverage: gcovr is not there; SECTIONS=ci ./setup installs it" >&2; exit 2; }
mkdir -p coverage && cd coverage
test -f Makefile || "$here/configure" -q ${CC:+CC="$CC"} CFLAGS='-g -O0 --coverage'
${MAKE:-make} -j "$(nproc)" nineball tests/unit >said 2>&1 || { tail said >&2; exit 1; }
find . -name '*.gcda' -exec rm -f {} +

export NINEBALL="$(pwd)/nineball" srcdir="$here"
for test in "tests/unit $suites" "sh $here/tests/mistakes.sh" "sh $here/tests/program.sh"; do
  $test >said 2>&1 || true
  if grep '^not ok' said >&2 || ! grep -q '^ok' said; then exit 1; fi
done

counted() { gcovr -r "$here" --object-directory . "$@" 2>said || { cat said >&2; return 1; }; }
counted --filter "$here/src/report/(expect|outcome|reducers|verdict)" --json -o coverage.json
counted -a coverage.json
counted -a coverage.json --branches --fail-under-branch "$wanted"
