#!/bin/sh
# Tests `nineball migrate`. The pages tests/pages/old-*.md of version 0.3 use every word of the table of old words.
# Migrated pages are valid, contain no old word, and do not change when they are migrated again. TAP. $NINEBALL is the
# program, $srcdir the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
tab=$(printf '\t')

# The rows of the table as three columns: KIND, old form, new form.
sed -n "s/^ *{NB_OLD_\([A-Z]*\), \"\([^\"]*\)\", \"\([^\"]*\)\"}.*/\1$tab\2$tab\3/p" src/input/old_words.c >"$work/rows"
test "$(wc -l <"$work/rows")" -gt 5
result $? 'the table is read'

mkdir "$work/a" "$work/a/b" "$work/a/bad" && cp tests/bad/*.tsv "$work/a/bad"
for page in tests/pages/old-*.md; do
  new=$work/a/b/${page##*/}
  "$nineball" migrate "$page" >"$new" 2>"$work/said" && "$nineball" explain "$new" >/dev/null 2>>"$work/said"
  result $? "$page, migrated, is valid"
  ! grep -n "'known [A-Z]" "$new" >"$work/said"
  result $? 'the columns of its figures are migrated'
  "$nineball" migrate "$new" 2>&1 | diff "$new" - >"$work/said"
  result $? 'a second migration changes nothing'
  ! "$nineball" explain "$page" >/dev/null 2>"$work/said" && grep -q 'rewrites pages of version 0.3' "$work/said"
  result $? 'old words are errors, and the hint names the new ones'
done

# blocks PAGE...: the blocks that the program reads, without comments.
blocks() { sed -n '/^```[a-z]/,/^```$/p' "$@" | sed 's/#.*//'; }
blocks tests/pages/old-*.md >"$work/old"
blocks "$work"/a/b/old-*.md >"$work/new"
while IFS=$tab read -r kind old now; do
  for word in $old; do
    case $word in [A-Z]* | …) continue ;; esac
    grep -qF -e "$word" "$work/old" "$work/new" || echo "no page tests/pages/old-*.md has \`$word\` of \`$old\`"
  done
  for word in $now; do
    case $word in [A-Z]* | …) continue ;; esac
    grep -qF -e "$word" "$work/new" || echo "no migrated page has \`$word\` of \`$now\`"
  done
done <"$work/rows" >"$work/said"
test ! -s "$work/said"
result $? 'the pages contain every old word, and after migration every new one'

while IFS=$tab read -r kind old now; do
  for word in $old; do
    case $word in [A-Z]* | …) continue ;; esac
    case " $now " in *" $word "*) continue ;; esac
    "$nineball" --help "${word#.}" 2>&1 | grep -qF "\`$old\` of version 0.3 is \`$now\` now" || {
      "$nineball" --help "${word#.}" >/dev/null 2>&1 || echo "nineball --help $word is unknown"
    }
  done
done <"$work/rows" >"$work/said"
test ! -s "$work/said"
result $? 'nineball --help OLDWORD names the new word'

cat >"$work/wanted" <<EOF
lattice   discs 3 by 3  from 300 mm 0 mm  radius 5 mm  rock       # columns${tab}stay
lattice   spheres 3 by 3  from 100 mm 0 mm  radius 5 mm  rock
fill      spheres circle 100 mm 100 mm radius 20 mm  fine rock  seed 1  attempts 100  else skip
fill discs box 200 mm 100 mm  to 300 mm 200 mm  fine rock  seed 1  else skip  attempts 100 # no columns
EOF
sed -n '/^lattice.*columns/,/no columns/p' "$work/a/b/old-scene.md" | diff "$work/wanted" - >"$work/said"
result $? 'columns and comments stay'
sed -n '/^A block/,$p' tests/pages/old-scene.md >"$work/wanted"
sed -n '/^A block/,$p' "$work/a/b/old-scene.md" | diff "$work/wanted" - >"$work/said" &&
  grep -q 'no block: discs lattice 3 by 3, tries' "$work/a/b/old-scene.md"
result $? 'prose and examples in the text stay'

printf '```scene\nstep 20 %% of critical # a percentage\n```\n' >"$work/one.md"
"$nineball" migrate "$work/one.md" 2>"$work/said" | grep -qxF 'step 20 % of single-contact # a percentage'
result $? 'a percentage is one value'

printf '```scene\nstep\t20 %% of critical\t# a tab\n```\n```gnuplot\nprint "step.critical/s"\n```\n' >"$work/one.md"
printf '```scene\nstep\t20 %% of single-contact\t# a tab\n```\n```gnuplot\nprint "step.single-contact/s"\n```\n' >"$work/wanted"
"$nineball" migrate "$work/one.md" 2>"$work/said" | diff "$work/wanted" - >>"$work/said"
result $? 'tabs stay, and a quoted column keeps the signs of its name'

cat >"$work/wanted" <<'EOF'
```gnuplot
print reference_D_x_1
plot $table_1 using 'time/s':'reference D.x/m' with lines title 'known'
print column('reference D.x max in fall/m')
```
EOF
sed -n '/^```gnuplot/,/^```$/p' "$work/a/b/old-expect.md" | diff "$work/wanted" - >"$work/said"
result $? 'in a figure columns and variables change, other words stay'
printf '```gnuplot\nprint known_M_strain_turn, M_strain_turn_1\n```\n' >"$work/one.md"
"$nineball" migrate "$work/one.md" 2>"$work/said" | grep -qxF 'print reference_M_strain_rotation, M_strain_rotation_1'
result $? 'the name of a variable has _ between its parts'

printf '```scene\r\ndiscs lattice 1 by 1 radius 1 m rock\r\n```\r\nlast' >"$work/one.md"
printf '```scene\r\nlattice discs 1 by 1 radius 1 m rock\r\n```\r\nlast' >"$work/wanted"
cp "$work/one.md" "$work/two.md"
"$nineball" migrate "$work/one.md" "$work/two.md" --in-place >"$work/said" 2>&1 &&
  cmp "$work/one.md" "$work/wanted" >>"$work/said" 2>&1 && cmp "$work/two.md" "$work/wanted" >>"$work/said" 2>&1
result $? '--in-place keeps the line ends'
inode=$(ls -i "$work/one.md")
"$nineball" migrate "$work/one.md" --in-place >"$work/said" 2>&1 && test "$(ls -i "$work/one.md")" = "$inode" && test ! -s "$work/said"
result $? '--in-place does not write a page that does not change'
printf '```scene\ndiscs lattice 1 by 1 radius 1 m rock\n```\n' >"$work/page.md"
{ chmod 1640 "$work/page.md" || chmod 640 "$work/page.md"; } 2>"$work/said" && ln -s page.md "$work/link.md"
before=$(ls -l "$work/page.md" | cut -c 1-10)
"$nineball" migrate --in-place "$work/link.md" >"$work/said" 2>&1 && test -L "$work/link.md" &&
  grep -q '^lattice discs' "$work/page.md" && test "$(ls -l "$work/page.md" | cut -c 1-10)" = "$before"
result $? '--in-place keeps links and permissions'
"$nineball" migrate "$work/one.md" "$work/two.md" >/dev/null 2>"$work/said"
test $? -eq 2 && grep -q 'with --in-place' "$work/said"
result $? 'several pages need --in-place'
printf '# a\n```scene\nlet  kind literal\nlet b $a\nsweep word tries 4 pieces\nlet d 5 mm\nlet e discs\nsweep f $a\n```\nlet kind literal\n' >"$work/one.md"
"$nineball" migrate "$work/one.md" >"$work/new" 2>"$work/said"
test $? -eq 0 && grep -qxF 'let d = 5 mm' "$work/new" && cat >"$work/wanted" <<EOF && diff "$work/wanted" "$work/said"
$work/one.md:3:11: warning: \`literal\` is not rewritten: with \$kind, \`continuum … literal\` is \`affine … accumulated\` now
$work/one.md:4:7: warning: if \`\$a\` is a number, write \`let b = a\`
$work/one.md:5:12: warning: \`tries\` is not rewritten: with \$word, \`fill … tries\` is \`fill … attempts\` now
$work/one.md:5:20: warning: \`pieces\` is not rewritten: with \$word, \`shear … pieces\` is \`shear … memory\` now
EOF
result $? 'old words that come by way of $NAME are named with line and column'
cat >"$work/one.md" <<'END'
~~~scene
```
let d 5 mm
~~~
let e 6 mm
````scene
```
let f 7 mm
~~~~
let g 8 mm
`````
let h 9 mm
END
sed 's/let \([dfg]\)/let \1 =/' "$work/one.md" >"$work/wanted"
"$nineball" migrate "$work/one.md" 2>"$work/said" | diff "$work/wanted" - >>"$work/said"
result $? 'a block ends at a line of as many of the same signs'
printf 'a\0b' >"$work/one.md"
cp "$work/one.md" "$work/wanted"
"$nineball" migrate --in-place "$work/one.md" 2>"$work/said"
test $? -eq 2 && grep -q 'not text' "$work/said" && cmp "$work/one.md" "$work/wanted"
result $? 'a file that is not text stays unchanged'
"$nineball" migrate "$work/none.md" 2>"$work/said"
test $? -eq 2 && grep -q 'cannot be read' "$work/said"
result $? 'a missing page'
"$nineball" migrate --in-place "$work/none.md" "$work/two.md" 2>"$work/said"
test $? -eq 2 && grep -q 'none.md.*cannot be read' "$work/said"
result $? 'a missing page before a valid one'
echo "1..$n"
