#!/bin/sh
# Tests docs/sketches: every sketch is as its script draws it, and no file is too large. TAP.
# $srcdir is the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"

# Other versions of gnuplot may round a coordinate differently.
version='gnuplot 5.4'

for script in docs/sketches/*.gp; do
  name=$(basename "$script" .gp)
  test "$name" = style || test -f "docs/sketches/$name.svg" || echo "$script: there is no docs/sketches/$name.svg; make sketches"
done >"$work/said"
for sketch in docs/sketches/*.svg; do
  test -f "${sketch%.svg}.gp" || echo "$sketch: there is no ${sketch%.svg}.gp that draws it"
  test "$(wc -c <"$sketch")" -lt 20000 || echo "$sketch has 20000 bytes or more"
done >>"$work/said"
test ! -s "$work/said"
result $? 'every sketch has a script and is small'

drawn='the sketches are as docs/sketches/draw.sh draws them'
case $(gnuplot --version 2>/dev/null) in
"$version "*)
  mkdir "$work/drawn"
  docs/sketches/draw.sh "$work/drawn" >"$work/said" 2>&1 && for sketch in docs/sketches/*.svg; do
    cmp "$sketch" "$work/drawn/$(basename "$sketch")"
  done >>"$work/said" 2>&1
  test ! -s "$work/said"
  result $? "$drawn"
  ;;
'') n=$((n + 1)) && echo "ok $n - $drawn # SKIP gnuplot is missing" ;;
*) n=$((n + 1)) && echo "ok $n - $drawn # SKIP the sketches were drawn by $version" ;;
esac
echo "1..$n"
