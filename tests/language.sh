#!/bin/sh
# Tests docs/LANGUAGE.md and the manual page: they are up to date and complete, every word has an example, and all
# examples run. TAP. $NINEBALL is the program, $srcdir the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
language=$work/LANGUAGE.md

"$nineball" --help language-md >"$language" && diff -u docs/LANGUAGE.md "$language" >"$work/said"
result $? "docs/LANGUAGE.md is up to date; make language renews it"

# The section of a word begins with `### WORD`. One line of its blocks must begin with the word, or contain it if the
# word follows a measure.
awk '
  function close_part() { if (word != "" && !shown) print word " has no example" }
  /^## / { close_part(); word = ""; expect = $2 == "Expectations" }
  /^### / { close_part(); word = $2; shown = 0; words++ }
  /^```/ { inside = $0 != "```"; next }
  inside && ($1 == word || (expect && index(" " $0 " ", " " word " "))) { shown = 1 }
  END { close_part(); if (words < 20) print "there are " words " words only" }' "$language" >"$work/said"
test ! -s "$work/said"
result $? 'every word has an example'

"$nineball" explain "$language" >/dev/null 2>"$work/said"
result $? 'all examples together are a valid page'

# Every quantity, or the family that it belongs to, `fabric` for `fabric.normal.xx`, is in the glossary.
sed -n '/^## Quantities/,/^## Numbers/s/^- `\([^`]*\)`.*/\1/p' "$language" | sort -u | awk '
  FNR == NR { line = $0; while (match(line, /`[^`]*`/)) { known[substr(line, RSTART + 1, RLENGTH - 2)]; line = substr(line, RSTART + RLENGTH) }; next }
  { family = $0; while (!(family in known) && sub(/\.[^.]*$/, "", family)) {} }
  !(family in known) { print $0 " is not in docs/GLOSSARY.md" }
  END { if (FNR < 100) print "there are " FNR " quantities only" }' docs/GLOSSARY.md - >"$work/said"
test ! -s "$work/said"
result $? 'every quantity, or its family, is in the glossary'

# Expectations with a reference are left out, because the reference belongs to another scene.
awk '/^### / { word = $2 } /^```/ { inside = $0 != "```" }
  !(inside && !/^```/ && word ~ /^(reference|within|versus|order)$/)' "$language" >"$work/runs.md"
"$nineball" check "$work/runs.md" >"$work/said" 2>&1
result $? 'all examples together run and pass their checks'

{
  printf '```scene\nmaterial steel density 7800 kg/m3 kn 1 MN/m\nlattice discs 4 by 4 radius 10 mm steel\nstep 0.1 of stable\n'
  awk '/^```/ { inside = $0 == "```text of a scene with a cell"; next } inside && !/^ /' "$language"
  printf 'record cell.stress.xx\nstage go\ncycles 10\n'
  awk '/^```/ { inside = $0 == "```text of a scene with a cell"; next } inside && /^ /' "$language"
  printf '```\n'
} >"$work/cell.md"
grep -q '^ *cell *strain' "$work/cell.md" && "$nineball" run "$work/cell.md" -o "$work/cell" >"$work/said" 2>&1
result $? 'the examples of scenes with a cell run'

sed -n 's/^### //p' "$language" | sort -u | while read -r word; do
  "$nineball" --help "$word" 2>&1 | grep -q "$word" || echo "nineball --help $word does not describe it"
done >"$work/said"
test ! -s "$work/said"
result $? 'nineball --help WORD describes each word'
# Every word of a line of syntax: the statement and its arguments, `record every N cycles | none`.
sed -n '/^### /{n;n;p;}' "$language" | tr -cs 'a-z0-9_-' '\n' | grep -E '^[a-z][a-z0-9_-]+$' | sort -u >"$work/words"
while read -r word; do
  "$nineball" --help "$word" >/dev/null 2>&1 || echo "nineball --help $word does not describe it"
done <"$work/words" >"$work/said"
test "$(wc -l <"$work/words")" -gt 100 && test ! -s "$work/said"
result $? 'nineball --help WORD describes each word within a statement'
for pair in energy:energy.sliding unbalanced:unbalanced.max kinetic:energy.kinetic "quantities:dashpot: .normal, .shear" "quantities dashpot:dashpot.normal" "quantities stress:stress.mean" units:kg/m3 expressions:hypot \
  sqrt:expressions MPa:pressure hertz:elastic "normal hertz:elastic" "shear rate:2 EXY" amplitude:largest at:TIME deg:angle; do
  "$nineball" --help "${pair%%:*}" 2>&1 | grep -qF -e "${pair#*:}" || echo "nineball --help ${pair%%:*} does not mention ${pair#*:}"
done >"$work/said"
test ! -s "$work/said"
result $? 'nineball --help describes families of quantities, topics, units, functions, laws and reducers'

# The explanation that a newcomer looks for is within the first three lines of the help.
for pair in "velocity:velocity VX VY" stiffness:young "refine:divides the step" "compress:box strain" "compression:cell strain" \
  "vertical:y points up" "horizontal:x points to the right" "order:order NUMBER in NAME" "advise:cheapest step" "within:MEASURE within" \
  "rate:cell strain" "seed:fill discs" "porosity:box.porosity" "strain:Which strain" "stage:Begins a stage" "budget:time for the search" \
  "psi:1 psi is 6.894757293 kPa" "inch:1 inch is 25.4 mm" "lb:1 lb is 4.448221615 N" "restitution:damping ratio" "fix:fixed" \
  "mindlin:mindlin_deresiewicz has it" "micro-slip:mindlin_deresiewicz" "reset:region S all from STAGE" \
  "slope:at 2 ms" "simple_shear:c12 0.1 1/s" "simple-shear:c12 0.1 1/s" "shear rate:c12 0.1 1/s" "pure shear:2 EXY" \
  "axial:box.strain.height" "axial strain:box.strain.height" "settle:damping mass" "run-out:snapshot"; do
  "$nineball" --help "${pair%%:*}" 2>&1 | head -n 3 | grep -qF -e "${pair#*:}" || echo "nineball --help ${pair%%:*} does not begin with ${pair#*:}"
done >"$work/said"
for command in $("$nineball" --help | sed -n 's/^  \([a-z][a-z]*\) .*/\1/p'); do
  "$nineball" --help "$command" 2>&1 | head -n 3 | grep -q "^  $command " || echo "nineball --help $command does not begin with the command"
done >>"$work/said"
test ! -s "$work/said" && test -n "$command"
result $? 'nineball --help begins with what a newcomer looks for, and with each command'
test "$("$nineball" --help strain | grep -cE '^ *(cell|box|boundary|affine) strain: moves ')" -eq 4
result $? 'nineball --help strain compares the four statements'
"$nineball" --help strain | tr -s ' \n' '  ' >"$work/said"
grep -qF 'With `region S all from STAGE`, `S.strain.xx`' "$work/said"
result $? 'nineball --help strain says how a strain counts from a stage'
"$nineball" --help gnuplot | tr -s ' \n' '  ' >"$work/said"
grep -qF "rows of all stages" "$work/said" && grep -qF "strcol('stage') eq 'load'" "$work/said"
result $? 'nineball --help gnuplot says how to plot one stage'
{ "$nineball" --help kn; "$nineball" --help cell.strain.xy; "$nineball" --help gnuplot; } | tr -s ' \n' '  ' >"$work/said"
grep -qF 'Between two materials: 2ab/(a+b).' "$work/said" && grep -qF 'xy is 0 as long as the cell is strained along x and y only' "$work/said" &&
  grep -qF "title 'reference'" "$work/said"
result $? 'nineball --help: the stiffness of two materials, the shear strain of a cell, a figure with a key'
"$nineball" --help material | tr -s ' \n' '  ' | grep -qF 'full `kn` and `ks`, not half of them' &&
  "$nineball" --help until | tr -s ' \n' '  ' | grep -qF 'far above 50 kPa, and only a servo holds it'
result $? 'nineball --help: the stiffness of equal materials, and a stress after a wait for rest'
{ "$nineball" --help monitor; "$nineball" --help packing; } | tr -s ' \n' '  ' >"$work/said"
grep -qF "in the order of the statements that add them" "$work/said" && grep -qF "There are two kinds of files." "$work/said"
result $? 'nineball --help: the numbers of particles, and the two kinds of files with a packing'

# Words of other programs: `nineball --help` of such a word must show all words of the page language that are in the same row.
grep '^    {"' src/input/guess.c | tr '{' '\n' | sed -n 's/^"\([^"]*\)", "\([^"]*\)".*$/\1|\2/p' >"$work/synonyms"
test "$(wc -l <"$work/synonyms")" -gt 30 && cut -d '|' -f 1 "$work/synonyms" | tr ' ' '\n' | sort | uniq -d >"$work/said" &&
  test ! -s "$work/said"
result $? 'no word of another program is in two rows'
while IFS='|' read -r words ours; do
  for word in $words; do
    "$nineball" --help "$word" >"$work/help" 2>&1 || echo "nineball --help $word finds nothing"
    echo "$ours" | tr -s ',' '\n' | sed 's/^ //' | while read -r our; do
      case $our in nineball*) continue ;; esac
      grep -qE -e "[ {|]$our([] ,:}|]|\$)" "$work/help" || echo "nineball --help $word does not show $our"
    done
  done
done <"$work/synonyms" >"$work/said"
test ! -s "$work/said"
result $? 'words of other programs lead to words of pages'
"$nineball" --help dics >/dev/null 2>"$work/said"
test $? -eq 2 && grep -q 'did you mean `disc`?' "$work/said"
result $? 'nineball --help suggests a word for a mistyped one'

# The manual page has the syntax of every statement, every option and every command in bold.
sh docs/man.sh "$nineball" >"$work/man" && {
  sed -n '/^### /{n;n;p;}' "$language" | tr -d '`'
  "$nineball" --help | sed -n 's/^ *\(.*[^ ]\)   *[^ ].*$/\1/p'
} | sed 's/\\/\\e/g; s/-/\\-/g; s/…/.../g' | while read -r term; do
  grep -qxF "\\fB$term\\fR" "$work/man" || echo "the manual page has no $term"
done >"$work/said" && test ! -s "$work/said"
result $? 'the manual page has every statement, option and command'
if command -v groff >/dev/null; then
  groff -man -Tutf8 -ww -z "$work/man" >"$work/said" 2>&1
  test ! -s "$work/said"
  result $? 'groff accepts the manual page'
else
  n=$((n + 1))
  echo "ok $n - groff accepts the manual page # SKIP groff is missing"
fi
echo "1..$n"
