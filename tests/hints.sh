#!/bin/sh
# Tests that the lines which hints propose are valid. Every text between backquotes in the table of words of other
# programs that has several words and begins like a statement, or is an expectation, is typed into pages, at each place
# where it may stand. In one of them the program must report no mistake in its line. Words in capitals, such as
# MATERIAL, are replaced by names of the page. TAP. $NINEBALL is the program, ./nineball by default; $srcdir is the top
# of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"

# The texts between backquotes, one in a line. A literal continues the one before. A text with a conversion or with `…`
# is not a whole line.
tr '\n' ' ' <src/input/guess.c | sed 's/" *\\* *"//g' | tr '`' '\n' | grep -vE '%[.*0-9]*[a-z]|…|["|()]=|nineball' >"$work/all"
# The words of statements, and the first words.
sed -n 's/^### //p' docs/LANGUAGE.md >"$work/names"
cut -d' ' -f1 "$work/names" | grep -vE '^(above|below|expected|within|increases|decreases|constant|order)$' | sort -u >"$work/verbs"
awk 'NR == FNR { verb[$1] = 1; next }
NF > 1 && (verb[$1] || /^[^ ]+[^`]* (expected|below|above) [-(0-9]/) && !/;|: | plus | times |^[a-z]+ in / ' "$work/verbs" "$work/all" |
  sort -u | grep -vxF -e 'fill discs' -e 'fill spheres' -f "$work/names" >"$work/texts"

materials='material  rock  density 2500 kg/m3  kn 1 MN/m  ks 1 MN/m  friction 0.3  young 1 GPa
let v = 1 m/s
let a = 1 m/s2
let b = 1 J
let d = 1 J
let c = 1 m/s
let f = 0.1
let mu = 0.3
let dt = 1 us
let k0 = 1
sweep k 1 2'
particles='lattice discs 20 by 1 radius 5 mm spacing 9.99 mm from 0.2 m 0.2 m rock'
names='monitor A disc 1
monitor P disc 1
monitor B disc 2
monitor C disc 1 with disc 2
region M all
region S all'
sizes='grading mixed 4 mm 2'
stages='step 1 us
record time A.x A.vx A.vy B.vx C.normal C.shear C.overlap momentum.x energy.kinetic energy.balance M.particles
stage load
cycles 10
stage approach
cycles 10
stage touch
cycles 10
stage bounce
cycles 10
stage unload
cycles 10'
box='box 0 m 0 m to 1 m 1 m rock'

# scene LINES...: prints a block `scene`.
scene() {
  printf '```scene\n'
  printf '%s\n' "$@"
  printf '```\n'
}

# typed PLACE LINE: prints a page with this line, which is marked by a comment.
typed() {
  marked="$2 # HERE"
  case $1 in
  scene) scene "$materials" "$marked" "$box" "$particles" "$names" "$stages" ;;
  below) scene "$materials" "$sizes" "$box" "$particles" "$marked" "$names" "$stages" ;;
  regions) scene "$materials" "$particles" 'region A all' "$marked" "$stages" ;;
  cells) scene "$materials" 'periodic cell 0 m 0 m to 1 m 1 m' "$particles" "$names" "$marked" "$stages" ;;
  spheres) scene "$materials" "$(echo "$particles" | sed 's/disc/sphere/g')" "$marked" "$stages" ;;
  walls) scene "$materials" "$box" "$(echo "$particles" | sed s/disc/sphere/g)" "$marked" "$stages" ;;
  impact) scene "$materials" "$particles" "$names" 'impact C speed 1 m/s angle 10 deg' "$marked" "$stages" ;;
  stage) scene "$materials" "$box" "$particles" "$names" "$stages" 'stage next' "$marked" 'cycles 10' ;;
  cell) scene "$materials" 'periodic cell 0 m 0 m to 1 m 1 m' "$particles" "$names" "$stages" 'stage next' "$marked" 'cycles 10' ;;
  circle) scene "$materials" 'boundary circle 0.2 m 0.2 m radius 1 mm' "$particles" "$names" "$stages" 'stage next' "$marked" 'cycles 10' ;;
  expect)
    scene "$materials" "$box" "$particles" "$names" 'monitor F wall south' "record $(echo "$2" | sed 's/^report *//; s/ .*//')" "$stages"
    printf '```expect\n%s\n```\n' "$marked"
    ;;
  expect-cell)
    scene "$materials" 'periodic cell 0 m 0 m to 1 m 1 m' "$particles" "$names" 'record cell.xy cell.yy' "$stages"
    printf '```expect\n%s\n```\n' "$marked"
    ;;
  test) printf '```contact-test\nmaterial rock kn 1 MN/m ks 1 MN/m friction 0.3\n%s\nsegment back normal to 1 N in 10 steps\n```\n' "$marked" ;;
  segment) printf '```contact-test\nmaterial rock kn 1 MN/m ks 1 MN/m friction 0.3\ncontact disc 1 m rock with wall rock\nsegment back normal to 1 N in 10 steps\n%s\n```\n' "$marked" ;;
  esac
}

: >"$work/wrong"
while IFS= read -r text; do
  line=$(echo "$text" | sed 's/\<MATERIAL\>/rock/g; s/\<STAGE\>/load/g; s/\<LATER\>/unload/g; s/\<EARLIER\>/load/g
    s/wall NAME/wall south/; s/material NAME/material rock/; s/\[SOURCE\]/[a guess]/; s/\<X Y\>/0.5 m 0.5 m/
    s/\<VX VY\>/1 m\/s 0 m\/s/; s/radius R\>/radius 5 mm/; s/\<VALUE\>/1/; s/-X$/-1 N/')
  echo "$line" | grep -qE '\<[A-Z]{2,}\>' && continue
  valid=false places='scene below stage cell circle regions cells spheres walls impact test segment'
  echo "$line" | grep -qE '^report | (expected|below|above) ' && ! echo "$line" | grep -q '^until' && places='expect expect-cell'
  : >"$work/errors"
  for place in $places; do
    typed "$place" "$line" >"$work/page.md"
    number=$(grep -n '# HERE' "$work/page.md" | cut -d: -f1)
    "$nineball" explain "$work/page.md" >/dev/null 2>"$work/heard"
    grep -q "page.md:$number:[0-9]*: error" "$work/heard" || { valid=true && break; }
    grep "page.md:$number:" -A 4 "$work/heard" >>"$work/errors"
  done
  $valid || { echo "$line" && grep -h 'error' "$work/errors" | sed 's/.*page.md:/    /'; } >>"$work/wrong"
done <"$work/texts"
cp "$work/wrong" "$why"
test ! -s "$work/wrong"
result $? "the $(wc -l <"$work/texts") lines that hints propose are valid"

# Whole lines of other programs: in the pages tests/bad/whole-lines-*.md each hint proposes the line to type, or two lines,
# with the numbers and names of the page. Typed in place of the wrong line they must have no mistake.

# proposed PAGE: prints the number of each line of the page with a hint, and the lines that the hint proposes, after tabs.
proposed() {
  "$nineball" explain "$1" 2>&1 >/dev/null | awk -v page="$1" '
    index($0, page ":") == 1 { split(substr($0, length(page) + 2), part, ":"); number = part[1] }
    /^  hint: (write|a random packing is two lines,) `/ && !/`, in the scene/ {
      text = $0
      sub(/^[^`]*`/, "", text)
      for (lines = number; match(text, /`/); text = substr(text, RSTART + RLENGTH)) {
        lines = lines "\t" substr(text, 1, RSTART - 1)
        text = substr(text, RSTART)
        if (!match(text, /^`( \(radius and number\))? and `/))
          break
      }
      print lines
    }'
}
printf 'x/m y/m radius/m\n0.05 0.05 0.001\n' >"$work/grains.txt"
: >"$work/wrong" >"$work/typed"
for page in tests/bad/whole-lines-*.md tests/bad/random-packing*.md; do
  proposed "$page" >"$work/proposed"
  while IFS= read -r proposal; do
    echo "$proposal" >>"$work/typed"
    number=${proposal%%	*}
    echo "$proposal" | cut -f2- | tr '\t' '\n' >"$work/lines"
    last=$((number + $(wc -l <"$work/lines") - 1))
    sed -e "${number}r $work/lines" -e "${number}d" "$page" >"$work/page.md"
    "$nineball" explain "$work/page.md" >/dev/null 2>"$work/heard"
    for line in $(seq "$number" $last); do
      grep -A 2 "page.md:$line:[0-9]*: error" "$work/heard" >>"$work/wrong"
    done
  done <"$work/proposed"
done
cp "$work/wrong" "$why"
test ! -s "$work/wrong" && test "$(wc -l <"$work/typed")" -gt 90
result $? "the $(wc -l <"$work/typed") lines that hints propose for lines of other programs are valid"
echo "1..$n"
