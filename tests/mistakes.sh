#!/bin/sh
# Every page in tests/bad must be refused with exactly the messages that its block `mistake` holds, and status 2.
# TAP. $NINEBALL is the program, ./nineball by default; $srcdir is where tests/bad lies.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

nineball=${NINEBALL:-./nineball}
case $nineball in
/*) ;;
*) nineball=$(pwd)/$nineball ;;
esac
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "${srcdir:-.}" || exit 1

set -- tests/bad/*.md
echo "1..$#"
n=0
for page in "$@"; do
  n=$((n + 1))
  tr -d '\r' <"$page" | sed -n '/^```mistake$/,/^```$/{/^```/!p;}' >"$work/wanted"
  "$nineball" explain "$page" >"$work/out" 2>"$work/said"
  status=$?
  if test -s "$work/wanted" && test $status -eq 2 && cmp -s "$work/wanted" "$work/said"; then
    echo "ok $n - $page"
  else
    echo "not ok $n - $page"
    echo "# status $status, wanted 2; lines wanted (-) and said (+):"
    diff -u "$work/wanted" "$work/said" | sed 's/^/# /'
  fi
done
