#!/bin/sh
# Tests packings: `packing` reads what `nineball state` writes, to the last bit, and lists of columns from other
# programs. TAP.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
pages=$work/pages
states=$work/states
mkdir "$pages"

# particles FILE: the fields of the particles of a state that a packing takes.
particles() { grep '^body ' "$1" | cut -d ' ' -f 1-8; }

"$nineball" state cases/3-nine-discs/nine-discs.md --stage load -o "$work/nine.state" >"$work/said" 2>&1 &&
  for file in "$work/nine.state" cases/packings/nine-discs-load.state; do
    grep -v '^program \|^hash \|^end ' "$file" >"$work/$(basename "$file").numbers"
  done
diff "$work/nine.state.numbers" "$work/nine-discs-load.state.numbers" >>"$work/said"
result $? 'the packing stored with the cases is the one that nine-discs computes'

"$nineball" run cases/7-assemblies/photoelastic-discs.md --set seed=5 -o "$work/photo" >"$work/said" 2>&1 && {
  sed -n '1,/^x/p' cases/packings/photo-5.tsv
  awk -F'\t' 'FILENAME ~ /walls/ && $1 == 1 { south = $3 } FILENAME ~ /walls/ && $1 == 4 { west = $2 }
    FILENAME ~ /particles/ && /^[0-9]/ { printf "%.1f\t%.1f\t%g\n", $2 - west, $3 - south, $4 }' \
    "$work/photo/A-walls.tsv" "$work/photo/A-particles.tsv"
} >"$work/photo-5.tsv"
diff "$work/photo-5.tsv" cases/packings/photo-5.tsv >>"$work/said"
result $? 'photo-5.tsv holds the positions of photoelastic-discs at stage A, rounded'

cp tests/bad/packing-small.state "$pages"
printf '```scene\nmaterial rock kn 1 MN/m\nmaterial sand density 1 g/cm3 kn 1 MN/m\npacking packing-small.state\nrecord time\nstep 1 us\nstage go\ncycles 1\n```\n' >"$pages/fixed.md"
"$nineball" explain "$pages/fixed.md" >"$work/out" 2>"$work/said"
result $? 'the material of a fixed particle needs no density'

# Randomly placed spheres of two materials, one fixed, one removed; they move for 500 cycles.
cat >"$pages/made.md" <<'END'
# At random
```scene
material  rock  density 2650 kg/m3  young 70 GPa  poisson 0.25
material  sand  density 1000 kg/m3  young 7 GPa  poisson 0.1
normal    hertz
grading   g  0.92 mm 3  0.61 mm 10  0.46 mm 12
fill   spheres circle 0 mm 0 mm radius 6 mm  g rock  seed 3  attempts 1000  else skip
fill   spheres box 0.1 m 0 mm to 0.11 m 9 mm  g sand  seed 4  attempts 1000  else skip
sphere    0.2 m 0 m  radius 1 mm  sand  fixed
box       -7 mm -7 mm to 0.21 m 10 mm  rock
gravity   1 m/s2 -9.81 m/s2
step      0.1 of rayleigh
record    time
stage     fall
  remove  sphere 2
  cycles  500
  record  none
  snapshot
END
echo '```' >>"$pages/made.md"
"$nineball" state "$pages/made.md" -o "$pages/heap.state" >"$work/said" 2>&1 && test "$(particles "$pages/heap.state" | wc -l)" -eq 51
result $? 'a state is written'

# A message on a particle of a state names the line of `packing`.
printf '```scene\nunits none\nnormal hertz\nmaterial rock density 1 young 1 poisson 0.3\npacking nine.state\nrecord time\nstep 1\nstage go\ncycles 1\n```\n' >"$pages/elastic.md"
cp "$work/nine.state" "$pages"
"$nineball" explain "$pages/elastic.md" >/dev/null 2>"$work/said"
grep -q '/elastic.md:5:1: error: expected spheres for `normal hertz`, found a disc' "$work/said"
result $? 'the line of a particle of a state'

# taken NAME LINE: runs a page with this packing for one cycle, so short that no bit of a position changes, and lists
# its particles.
taken() {
  cat >"$pages/$1.md" <<END
# Taken from a file
\`\`\`scene
material  sand  density 1000 kg/m3  young 7 GPa  poisson 0.1
material  rock  density 2650 kg/m3  young 70 GPa  poisson 0.25
normal    hertz
$2
step      1e-30 s
record    time
stage     look
  cycles  1
  record  none
  snapshot
\`\`\`
END
  "$nineball" state "$pages/$1.md" -o "$work/$1.state" >"$work/said" 2>&1 && particles "$work/$1.state" >"$work/$1"
}

# Particles after a removed one are renumbered.
particles "$pages/heap.state" | grep -v ' gone ' | awk '{ $2 = NR; print }' >"$work/wanted"
taken whole 'packing heap.state'
awk '{ print $1, $2, $3, $4, $5, $6 }' "$work/whole" >"$work/a" && awk '{ print $1, $2, $3, $4, $5, $6 }' "$work/wanted" | diff - "$work/a" >"$work/said" &&
  test "$(wc -l <"$work/a")" -eq 50
result $? 'kind, material, fixed and radius are those of the file, without the removed particle'

# A list like the tables of nineball, with 17 digits.
places() { awk -F '\t' '/^#/ { next } !h { for (k = 1; k <= NF; k++) at[$k] = k; h = 1; next } { print $(at["x/m"]), $(at["y/m"]), $(at["radius/m"]) }' "$1"; }
"$nineball" run "$pages/made.md" -o "$work/made" >"$work/said" 2>&1 && places "$work/made/fall-particles.tsv" >"$work/wanted"
{
  echo '# from elsewhere: other columns, blanks, in mm and um'
  echo ' name  radius/um  y/mm  x/m'
  awk '{ n = split($3, r, "e-"); print "  body" NR, r[1] "e" (n > 1 ? 6 - r[2] : 6), $2, $1 }' "$work/wanted" |
    awk '{ n = split($3, y, "e-"); print $1, $2, y[1] "e" (n > 1 ? 3 - y[2] : 3), $4 }'
} >"$pages/heap.txt"
cp "$work/made/fall-particles.tsv" "$pages/heap.tsv"
for file in state tsv txt; do
  taken "of-$file" "packing heap.$file spheres rock" && "$nineball" run "$pages/of-$file.md" -o "$work/of-$file.d" >"$work/said" 2>&1 &&
    places "$work/of-$file.d/look-particles.tsv" >"$work/seen" &&
    diff "$work/wanted" "$work/seen" >"$work/said" && test "$(wc -l <"$work/seen")" -eq 50
  result $? "positions and radii from heap.$file are the same to the last bit"
done

# The rows are as high as the largest particle, and the first one begins at y = 0.
taken sorted 'packing heap.state sorted' && "$nineball" run "$pages/sorted.md" -o "$work/sorted.d" >"$work/said" 2>&1 &&
  places "$work/sorted.d/look-particles.tsv" >"$work/seen" &&
  awk '$3 > r { r = $3 } { x[NR] = $1; y[NR] = $2; line[NR] = $0 }
    END { for (k = 1; k <= NR; k++) { row = y[k] / (2 * r); row = int(row) - (row < int(row)); printf "%d %.17g %s\n", row, x[k], line[k] } }' \
    "$work/wanted" | LC_ALL=C sort -k1,1n -k2,2g | cut -d ' ' -f 3- >"$work/in-rows" &&
  diff "$work/in-rows" "$work/seen" >"$work/said" && ! diff -q "$work/in-rows" "$work/wanted" >/dev/null
result $? '`sorted` numbers the particles in rows'
particles "$work/sorted.state" | cut -d ' ' -f 3- | sort >"$work/a" && cut -d ' ' -f 3- "$work/whole" | sort | diff - "$work/a" >"$work/said" &&
  test "$(wc -l <"$work/a")" -eq 50
result $? 'a sorted packing keeps kind, material, radius and position of each particle'

# The state of a page with a packing depends on the contents of the file.
sed '/^  snapshot/d' "$pages/of-txt.md" >"$pages/first.md"
printf '# Goes on\n```scene\nstart first stage look\nrecord time\nstage on\ncycles 1\n```\n' >"$pages/second.md"
"$nineball" run "$pages/second.md" --states "$states" -o "$work/second" >"$work/said" 2>&1 &&
  "$nineball" explain "$pages/second.md" --states "$states" | grep -q 'state: present$'
result $? 'a page can start from one with a packing'
cp "$pages/heap.txt" "$work/heap.txt"
for field in 2:radius 3:y 4:x; do
  awk -v field="${field%:*}" 'NR == 3 { $field *= 0.875 } { print }' "$work/heap.txt" >"$pages/heap.txt"
  "$nineball" explain "$pages/second.md" --states "$states" >"$work/said" 2>&1 && grep -q 'out of date, will be computed again' "$work/said"
  result $? "its state is out of date when the ${field#*:} of a particle has changed"
done

# A state has the same hash whether `nineball state` writes the state or a run of a page that starts from the state.
"$nineball" state "$pages/first.md" -o "$work/first.state" >"$work/said" 2>&1 && "$nineball" run "$pages/second.md" --states "$states" -o "$work/second" >"$work/said" 2>&1 &&
  hash=$(sed -n 's/^hash //p' "$work/first.state") && test "$hash" != 0000000000000000 && test -s "$states/first-look-$hash.state" &&
  grep -qx "hash $hash" "$states/first-look-$hash.state"
result $? 'the hash of a state written by command'

# A list can be longer than a page: 100,000 discs, 4.5 MB.
awk 'BEGIN { print "x/m\ty/m\tradius/m"; for (k = 0; k < 100000; k++) printf "%.17g\t%.17g\t0.004999\n", k % 400 * 0.01, int(k / 400) * 0.01 + 1e-9 * k }' >"$pages/many.tsv"
printf '# Many\n```scene\nmaterial rock density 2000 kg/m3 kn 1 MN/m\npacking many.tsv discs rock\nstep 1 us\nrecord time\nstage go\ncycles 1\n```\n' >"$pages/many.md"
timeout 60 "$nineball" explain "$pages/many.md" >"$work/said" 2>&1 && grep -q 'many.tsv: 100000 particles' "$work/said"
result $? 'a list of 100,000 discs'

# ---- messages of the command ----

refused() {
  "$nineball" state "$@" -o "$work/none" >"$work/out" 2>"$work/said"
  test $? -eq 2 && grep -qF -e "$text" "$work/said" && test ! -e "$work/none"
  result $? "refused: $text"
}
text='has no stage `laod` of its own; did you mean `load`?' refused cases/3-nine-discs/nine-discs.md --stage laod
text='has no stage `load` of its own' refused cases/5-numerics/saved-stage.md --stage load
text='is a contact test: expected a page with a scene' refused cases/4-oblique/mindlin-loops.md
text='has several runs' refused cases/7-assemblies/fill-tries.md
text='`nineball state` takes one page' refused cases/3-nine-discs/nine-discs.md cases/3-nine-discs/nine-discs.md
"$nineball" state cases/3-nine-discs/nine-discs.md -o "$work/no/folder/x.state" >"$work/out" 2>"$work/said"
test $? -eq 2 && grep -q 'No such file' "$work/said"
result $? 'a missing folder'
(cd "$work" && "$nineball" state "$OLDPWD/cases/3-nine-discs/nine-discs.md" --stage load --set ks=0.9e9) >"$work/out" 2>"$work/said" &&
  grep -qx 'setting ks=0.9e9' "$work/nine-discs-load.state"
result $? 'the file is named by page and stage, and contains the settings'
echo "1..$n"
