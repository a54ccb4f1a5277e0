#!/bin/sh
# Tests the messages of runs that are aborted. Every page in tests/aborted must end with the status and exactly the
# messages of its block `message`; docs/EXTREMES.md shows them. Then every message in the sources that aborts a run must
# have occurred: a new one needs a page. TAP. $NINEBALL is the program, ./nineball by default; $srcdir is the top of the
# source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
why=$work/why

for page in tests/aborted/*.md; do
  sed -n '/^```message/,/^```$/{/^```/!p;}' "$page" >"$work/wanted"
  wanted=$(sed -n 's/^```message //p' "$page")
  "$nineball" run "$page" -o "$work/results" >/dev/null 2>"$work/said"
  status=$?
  cat "$work/said" >>"$work/heard"
  echo "status $status, expected $wanted; expected lines (-) and actual lines (+):" >"$why"
  diff -u "$work/wanted" "$work/said" >>"$why" && test $status -eq "$wanted"
  result $? "$page"
  step=$(sed -n 's/.*write `step \([^`]*\)`, or `allow unstable`.*/\1/p' "$work/said")
  if [ "$step" ]; then
    "$nineball" run "$page" --set step="$step" -o "$work/results" >/dev/null 2>"$why"
    result $? "$page: the step that the message proposes is stable"
  fi
done

# tests/checkpoint.sh tests the messages about signals.
unheard='^stopped by a signal'
for source in $(grep -l 'NB_BROKEN' src/core/*.c src/measure/*.c src/loading/*.c src/run/*.c); do
  awk -v speaks=NB_BROKEN -f tests/messages.awk "$source" | while IFS='	' read -r line text; do
    echo "$text" | grep -qE "$unheard" && continue
    grep -qE -e "$(printf '%s\n' "$text" | as_pattern)" "$work/heard" || echo "no page in tests/aborted causes: $source:$line: $text"
  done >"$why"
  test ! -s "$why"
  result $? "every message of $source has its page"
done
sh docs/extremes.sh | diff -u docs/EXTREMES.md - >"$why"
result $? 'docs/EXTREMES.md has these pages and this table: `make extremes`, or docs/extremes.sh >docs/EXTREMES.md'
echo "1..$n"
