#!/bin/sh
# Tests the order of the modules of src/: no file includes one of a later module, and no object calls into one. TAP.
# The order is that of the lists in build-aux/lists.mk. $srcdir is the top of the source tree. The test runs in the build
# folder.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -u
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
srcdir=${srcdir:-.}

n=0
result() {
  n=$((n + 1))
  if [ "$1" -eq 0 ]; then
    echo "ok $n - $2"
  else
    sed 's/^/# /' "$work/said"
    echo "not ok $n - $2"
  fi
}

# The modules in the order in which the lists name them.
sed -n '/^CORE = /,$p' "$srcdir/build-aux/lists.mk" | grep -o 'src/[a-z]*/' | awk '!seen[$0]++' | sed 's|src/||; s|/||' >"$work/order"
ls "$srcdir"/src/*/*.[ch] | sed 's|/[^/]*$||; s|.*/||' | sort -u >"$work/folders"
sort "$work/order" | diff - "$work/folders" >"$work/said"
result $? "every folder of src is a module in the lists"

# One line `FILE MODULE MODULE2 HEADER` for each include: FILE of MODULE includes HEADER of MODULE2.
(cd "$srcdir/src" && grep -n '^#include "' */*.[ch]) | sed 's|^\([a-z]*\)/\([^:]*\):[0-9]*:#include "\(.*\)"|\1/\2 \1 \3|' |
  awk '{ split($3, p, "/"); print $1, $2, (p[2] ? p[1] : $2), $3 }' >"$work/includes"
upward() {
  awk 'FILENAME == ARGV[1] { level[$1] = NR; next }
       ($3 in level) && level[$3] > level[$2] { print $1, "needs", $4, "of", $3 }' "$work/order" "$1" >"$work/said"
  [ ! -s "$work/said" ]
}
[ -s "$work/includes" ] && upward "$work/includes"
result $? "no file includes one of a later module"

# The same test for compiled objects, because a prototype can be in the header of another module.
if command -v nm >/dev/null && ls src/core/*.o >/dev/null 2>&1; then
  for object in src/*/*.o; do
    module=${object#src/} file=${object##*/}
    test -f "$srcdir/src/${module%%/*}/$(echo "${file%.o}" | sed 's/^librefs_a-//').c" || continue
    nm "$object" 2>/dev/null | awk -v o="$object" -v m="${module%%/*}" 'NF == 3 && $2 ~ /[TDRB]/ { print "D", o, m, $3 } $1 == "U" { print "U", o, m, $2 }'
  done >"$work/symbols"
  awk '$1 == "D" { module[$4] = $3; next } { use[NR] = $0 }
       END { for (u in use) { split(use[u], w, " "); if (w[4] in module) print w[2], w[3], module[w[4]], w[4] } }' \
    "$work/symbols" >"$work/calls"
  [ -s "$work/calls" ] && upward "$work/calls"
  result $? "no object calls into a later module"
else
  n=$((n + 1))
  echo "ok $n - no object calls into a later module # SKIP no nm, or no objects here"
fi
echo "1..$n"
