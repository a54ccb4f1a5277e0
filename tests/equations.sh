#!/bin/sh
# docs/EQUATIONS.md is what docs/equations.sh makes of the tags in the sources, and every equation of CS79 has a file.
# TAP. $srcdir is the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "${srcdir:-.}" || exit 1

echo 1..3
if sh docs/equations.sh . >"$work/now" 2>"$work/said"; then
  echo "ok 1 - every tag can be read"
else
  echo "not ok 1 - every tag can be read"
  sed 's/^/# /' "$work/said"
  echo "Bail out! there is no table to compare"
  exit 1
fi
if diff -u docs/EQUATIONS.md "$work/now" >"$work/said"; then
  echo "ok 2 - docs/EQUATIONS.md is up to date"
else
  echo "not ok 2 - docs/EQUATIONS.md is up to date"
  echo "# docs/equations.sh >docs/EQUATIONS.md makes it so; what would change:"
  grep '^[-+]|' "$work/said" | sed 's/^/# /'
fi
if grep '| nowhere |' "$work/now" >"$work/said"; then
  echo "not ok 3 - every equation of CS79 has a file"
  sed 's/^/# /' "$work/said"
else
  echo "ok 3 - every equation of CS79 has a file"
fi
