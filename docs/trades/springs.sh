#!/bin/sh
# Writes linear-springs.tsv and linear-springs-angle.tsv in this folder: the settings that `nineball advise` tries on the pages
# linear-springs.md and linear-springs-angle.md. $NINEBALL is the program. Takes a minute.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu
LC_ALL=C
export LC_ALL
nineball=$(cd "$(dirname "${NINEBALL:-./nineball}")" && pwd)/$(basename "${NINEBALL:-./nineball}")
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# search PAGE QUANTITY TOLERANCE ...
search() {
  page=$1 quantity=$2
  shift 2
  for within in "$@"; do
    "$nineball" advise "docs/trades/$page.md" --quantity "$quantity" --within "$within" -o "$work" >/dev/null 2>&1 || test $? -eq 1
    awk -F '\t' -v OFS='\t' -v quantity="$quantity" -v within="$within" '
      /^#/ || $1 == "normal" { next } { print quantity, within, $1, $3, $5, $8, $9, $10, $2 }' "$work/advice.tsv"
  done
}

# head WHAT PAGE
head() {
  cat <<HEAD
# $1: the settings that advise tried.
# command: docs/trades/springs.sh, which runs nineball advise docs/trades/$2.md --quantity QUANTITY --within TOLERANCE
# refine   the step of the page over this one        updates   of contacts and particles, all runs        error   estimated
# step     the part of the error that is due to the step alone
HEAD
  printf 'quantity\twithin\tnormal\trefine\tupdates\terror\tstep\tresult\tshear\n'
}

{
  head "hertz-impact with Hertz's law, and with linear springs whose stiffness gives the same duration of the impact" linear-springs
  for quantity in impact.duration 'C.normal max in strike' 'C.overlap max in strike' impact.restitution; do
    search linear-springs "$quantity" '20 %' '10 %' '1 %' '0.1 %'
  done
} >"$work/impact"
{
  head "restitution-angle with Hertz's law, and with linear springs whose stiffness gives the same duration of the impact" linear-springs-angle
  search linear-springs-angle impact.restitution '10 %' '1 %' '0.1 %'
  search linear-springs-angle impact.psi2 0.5 0.1 0.01
  search linear-springs-angle impact.duration '10 %' '1 %' '0.1 %'
} >"$work/angle"
cp "$work/impact" docs/trades/linear-springs.tsv
cp "$work/angle" docs/trades/linear-springs-angle.tsv
