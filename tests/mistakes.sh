#!/bin/sh
# Tests error messages. Every page in tests/bad must be refused with exactly the messages of its block `mistake` and
# status 2; the word `mistake` may be followed by options. Then pages at the limits of the language are made and tested.
# Finally every message in the sources that read pages must have occurred: a new message needs a page. TAP. $NINEBALL is
# the program, ./nineball by default; $srcdir is the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
why=$work/why

# ---- one page for each error ----

: >"$work/heard"
for page in tests/bad/*.md; do
  sed -n '/^```mistake/,/^```$/{/^```/!p;}' "$page" >"$work/wanted"
  options=$(sed -n 's/^```mistake//p' "$page")
  eval "\"\$nineball\" explain $options \"\$page\"" >"$work/out" 2>"$work/said"
  status=$?
  cat "$work/said" >>"$work/heard"
  echo "status $status, expected 2; expected lines (-) and actual lines (+):" >"$work/why"
  diff -u "$work/wanted" "$work/said" >>"$work/why" && test -s "$work/wanted" && test $status -eq 2
  result $? "$page"
done

# An editor of another system may end lines in CR LF: the messages are the same.
page=tests/bad/length-for-velocity.md
sed 's/$/\r/' "$page" >"$work/dos.md"
sed -n '/^```mistake/,/^```$/{/^```/!p;}' "$page" >"$work/wanted"
"$nineball" explain "$work/dos.md" 2>&1 >"$work/out" | sed "s|^$work/dos.md|$page|" | diff -u "$work/wanted" - >"$work/why" &&
  test -s "$work/wanted" && test "$(tr -dc '\r' <"$work/dos.md" | wc -c)" -gt 9
result $? 'lines that end in CR LF'

# ---- limits: the largest valid and the smallest invalid page ----

# page LINE: prints a valid page with this line added.
page() {
  printf '```scene\nmaterial rock density 2000 kg/m3 kn 1 MN/m\n%s\ndisc 0 m 0 m radius 1 m rock\nstep 1 us\n' "$1"
  printf 'record time\nstage go\n cycles 10\n```\n'
}
# many N TEXT: prints the text N times.
many() { awk -v n="$1" -v text="$2" 'BEGIN { for (k = 0; k < n; k++) printf "%s", text }'; }

# limit NAME TEXT: $work/right.md must be valid, and $work/wrong.md must be refused with a message that contains the
# text.
limit() {
  "$nineball" explain "$work/right.md" >"$work/out" 2>"$work/why" &&
    ! "$nineball" explain "$work/wrong.md" >"$work/out" 2>"$work/said" && grep -qF -e "$2" "$work/said"
  status=$?
  cut -c1-200 "$work/said" | head -n 20 >>"$work/why"
  cat "$work/said" >>"$work/heard"
  result $status "$1"
}

page "# $(many 4094 x)" >"$work/right.md"
page "# $(many 4095 x)" >"$work/wrong.md"
limit 'bytes in a line' 'expected at most 4096 bytes in a line, found 4097'

page "let a = 1 # $(many 300 'x ')" >"$work/right.md"
page "sweep a $(many 254 '1 ')" >"$work/wrong.md"
limit 'words in a line' 'expected at most 255 words in a line, found more'

page "sweep a$(awk 'BEGIN { for (k = 1; k < 16; k++) printf " with a%d", k }') $(many 16 '1 ')" >"$work/right.md"
page "sweep a$(awk 'BEGIN { for (k = 1; k < 17; k++) printf " with a%d", k }') $(many 17 '1 ')" >"$work/wrong.md"
limit 'names in a sweep' 'expected at most 16 names in a sweep'

page 'material clay density 1 g/cm3 young 1 MPa poisson 0.5' >"$work/right.md"
page 'material clay density 1 g/cm3 young 1 MPa poisson 0.500001' >"$work/wrong.md"
limit "Poisson's ratio" 'expected a number from 0 to 0.5'
page 'material clay density 1 g/cm3 young 1 MPa poisson 0' >"$work/right.md"
page 'material clay density 1 g/cm3 young 1 MPa poisson -0.000001' >"$work/wrong.md"
limit "the smallest Poisson's ratio" 'expected a number from 0 to 0.5'

page 'boundary circle 0 m 0 m radius 2 m
region A inside 1' >"$work/right.md"
page 'boundary circle 0 m 0 m radius 2 m
region A inside 1.000001' >"$work/wrong.md"
limit 'a fraction' 'expected a number from 0 to 1'
page 'boundary circle 0 m 0 m radius 2 m
region A inside 0' >"$work/right.md"
page 'boundary circle 0 m 0 m radius 2 m
region A inside -0.000001' >"$work/wrong.md"
limit 'the smallest fraction' 'expected a number from 0 to 1'

page "let $(many 63 a) = 1" >"$work/right.md"
page "let $(many 64 a) = 1" >"$work/wrong.md"
limit 'letters in a name' 'fewer than 64 characters'

page "let a $(many 63 a)" >"$work/right.md"
page "let a $(many 64 a)" >"$work/wrong.md"
limit 'letters in a value' 'expected a value shorter than 64 bytes'

page "record A.$(many 10 a)" | sed 's/^record A.*/record step/' >"$work/right.md"
page "record A.$(many 130 a)" >"$work/wrong.md"
limit 'letters in a quantity' 'expected a name shorter than 128 bytes'
page "record $(many 128 a)" >"$work/wrong.md"
limit '128 letters in a quantity' 'expected a name shorter than 128 bytes'
page "record $(many 127 a)" >"$work/wrong.md"
limit '127 letters in a quantity' 'expected a quantity, found `aaa'

# numbered N LINE: prints the line N times, with @ replaced by 1, 2, ...
numbered() { awk -v n="$1" -v line="$2" 'BEGIN { for (k = 1; k <= n; k++) { l = line; gsub("@", k, l); print l } }'; }
# counted LIMIT WHAT LINE: tests the limit of the number of such lines.
counted() {
  page "$(numbered "$1" "$3")" >"$work/right.md"
  page "$(numbered $(($1 + 1)) "$3")" >"$work/wrong.md"
  limit "$2" "expected at most ${4:-$1} $2, found more"
}
counted 2000 'names for values' 'let a@ = 1'
counted 199 'materials' 'material m@' 200 # one more is in the page
counted 2000 'walls' 'wall w@ @ m 9 m to @ m 10 m rock'
counted 2000 'gradings' 'grading g@ 1 m 1'
counted 2000 'monitors' 'disc @ m 9 m radius 0.1 m rock\nmonitor m@ disc @'
counted 1999 'columns' 'disc @ m 9 m radius 0.1 m rock\nmonitor m@ disc @\nrecord m@.x' 2000 # one more is in the page
# staged N: prints a page with N stages.
staged() {
  page '' | sed '$d'
  numbered $(($1 - 1)) 'stage s@\ncycles 1'
  echo '```'
}
staged 2000 >"$work/right.md"
staged 2001 >"$work/wrong.md"
limit 'stages' 'expected at most 2000 stages, found more'

# A mistake in a statement that makes particles causes no second message, about a particle that is missing.
while read -r line; do
  page "$line
monitor A disc 5" >"$work/wrong.md"
  "$nineball" explain "$work/wrong.md" >"$work/out" 2>"$why"
  test "$(grep -c ': error: ' "$why")" -eq 1
  result $? "one message: $line"
done <<'END'
disc 9 m
sphere 9 m
lattice discs 9
fill discs 9
packing none.tsv discs rock
END
printf '```scene\nstart none go\nrecord time\nstage on\nremove disc 5\ncycles 1\n```\n' >"$work/wrong.md"
"$nineball" explain "$work/wrong.md" >"$work/out" 2>"$why"
test "$(grep -c ': error: ' "$why")" -eq 1
result $? 'one message: start'

# path LINE: prints a valid contact test with this line added.
path() {
  printf '```contact-test\nmaterial rock kn 1 MN/m\ncontact disc 1 m rock with wall rock\n%s\n```\n' "$1"
}
path "$(numbered 2000 'segment l@ slip by 1 um in 1 step')" >"$work/right.md"
path "$(numbered 2001 'segment l@ slip by 1 um in 1 step')" >"$work/wrong.md"
limit 'segments' 'expected at most 2000 segments, found more'

# on FROM STAGE NAME: prints a page that starts from the stage STAGE of FROM and has one stage NAME.
on() { printf '```scene\nstart %s stage %s\nrecord time\nstage %s\ncycles 1\n```\n' "$1" "$2" "$3"; }
page '' >"$work/chain0.md"
on chain0 go s1 >"$work/chain1.md"
for k in $(seq 2 49); do
  on "chain$((k - 1))" "s$((k - 1))" "s$k" >"$work/chain$k.md"
done
on chain48 s48 last >"$work/right.md"
on chain49 s49 last >"$work/wrong.md"
limit 'pages that start from each other' 'expected a chain of at most 50 pages that start from each other'

{ page '' && many 65536 "$(many 63 x)
"; } | head -c 4194304 >"$work/right.md"
{ cat "$work/right.md" && echo x; } >"$work/wrong.md"
limit 'bytes in a page' 'expected at most 4194304 bytes, found 4194306'

page '' >"$work/right.md"
page "$(many 1200 'frobnicate
')" >"$work/wrong.md"
limit 'mistakes of a page' 'more than 1000 mistakes; the others are not shown'
test "$(grep -c ': error: ' "$work/said")" -eq 1001 &&
  test "$(tail -n 1 "$work/said")" = "$work/wrong.md: error: more than 1000 mistakes; the others are not shown"
result $? 'only 1000 errors are reported, and then that there are more'

page '' >"$work/$(many 63 n).md"
cp "$work/$(many 63 n).md" "$work/right.md"
page '' >"$work/$(many 64 n).md"
"$nineball" explain "$work/$(many 63 n).md" >"$work/out" 2>"$work/why" &&
  ! "$nineball" explain "$work/$(many 64 n).md" 2>>"$work/heard"
result $? 'letters in the name of a file'
tail -n 1 "$work/heard" >"$work/why"
test "$(cat "$work/why")" = "$work/$(many 64 n).md: error: expected a file name shorter than 64 bytes"
result $? 'letters in the name of a file: the message'

"$nineball" explain "$work/none.md" 2>>"$work/heard"
tail -n 1 "$work/heard" >"$work/why"
grep -q 'none.md: error: cannot be read: ' "$work/heard"
result $? 'a missing page'

page '' >"$work/whole.md"
"$nineball" explain "$work/whole" 2>"$work/why"
cat "$work/why" >>"$work/heard"
grep -qF "hint: did you mean \`$work/whole.md\`?" "$work/why"
result $? 'the name of a page without .md'

mkdir "$work/both" && cp "$work/whole.md" "$work/both.md"
"$nineball" explain "$work/both" 2>"$why"
grep -qF 'error: cannot be read: it is a folder' "$why" && ! grep -q 'hint' "$why"
result $? 'a folder beside a page of its name'

"$nineball" advise tests/pages/passes.md --within '1 % x' >/dev/null 2>"$why"
cat "$why" >>"$work/heard"
grep -qF 'expected the end of the text, found `x`' "$why"
result $? 'text after the tolerance of advise'
"$nineball" advise cases/1-two-discs/free-fall.md --within 1 >/dev/null 2>"$work/given"
cat "$work/given" >>"$work/heard"
diff -u - "$work/given" >"$why" <<'EOF'
quantity: error: expected a length and its unit (m, mm, um, nm, cm, km), or a percentage, found `1`
      | C.overlap max within 1
      |                      ^
  hint: write `1 m` or `1 mm`; a relative tolerance is a percentage, `1 %`
EOF
result $? 'a tolerance of advise without a unit'

# ---- `transform` makes a number infinite ----

# moved ANGLE NUMBER SCENE STAGE: prints a page with this statement in the scene, or in the stage, and this number for each @.
moved() {
  printf '```scene\nunits none\nmaterial m density 1 kn 1\nwall w 0 0 to 1 0 m\ndisc 0 9 radius 1 m\n%s\nstep 1\nrecord time\ntransform rotate (%s*pi/180)\nstage go\n%s\ncycles 1\n```\n' \
    "$3" "$1" "$4" | sed "s/@/$2/g"
}
# A vector of two numbers of 1.7e308, rotated by 45 or -45 degrees, has a component that is larger than the largest double.
while IFS='|' read -r in_scene in_stage; do
  for angle in 45 -45; do
    moved $angle 1 "$in_scene" "$in_stage" >"$work/right.md"
    moved $angle 17e307 "$in_scene" "$in_stage" >"$work/wrong.md"
    limit "rotated by $angle degrees: $in_scene$in_stage" 'expected finite coordinates after `transform`; these are too large'
  done
done <<'END'
disc @ @ radius 1 m
disc 5 5 radius 1 m velocity @ @
wall v 5 5 to 6 5 m velocity @ @
wall v 5 5 to 6 5 m about @ @
region A circle @ @ radius 1
gravity @ @
boundary circle @ @ radius 1
|gravity @ @
|gravity centripetal 1 about @ @
|boundary circle @ @ radius 1
|wall w velocity @ @
|affine strain @ @ shear @
boundary circle 0 0 radius 1|boundary strain @ @ shear @
boundary circle 0 0 radius 1|boundary stress @ @ shear @
END

# ---- lines of a file of columns that are not read ----

printf '# a comment\n\n \t\nx/m\ty/m\tradius/m\n1\t2\t0.1\n\t\n# another\n3\t4\t0.1\n' >"$work/lines.tsv"
page 'packing lines.tsv discs rock' >"$work/page.md"
"$nineball" explain "$work/page.md" >"$why" 2>&1 && grep -qxF '  3 particles, 0 walls' "$why"
result $? 'comments and empty lines of a packing'

# ---- pipes, devices and folders: reading a pipe could block forever ----

mkfifo "$work/pipe.md" "$work/pipe.tsv" && mkdir "$work/folder.md"
# refused NAME TEXT COMMAND...: the command must end at once with status 2 and a message that contains the text.
refused() {
  name=$1 text=$2
  shift 2
  timeout 20 "$@" >"$work/out" 2>"$work/why"
  test $? -eq 2 && grep -qF -e "$text" "$work/why"
  result $? "$name"
}
no_file='it is a pipe or a device; a regular file is expected'
refused 'a pipe as a page' "$no_file" "$nineball" check "$work/pipe.md"
refused 'a device as a page' "$no_file" "$nineball" check /dev/zero
refused 'a folder as a page' 'it is a folder' "$nineball" check "$work/folder.md"
page 'packing pipe.tsv discs rock' >"$work/page.md"
refused 'a pipe as a packing' "$no_file" "$nineball" check "$work/page.md"
path 'segment l follow pipe.tsv' >"$work/page.md"
refused 'a pipe as a path' "$no_file" "$nineball" check "$work/page.md"
printf '```scene\nstart pipe stage go\nrecord time\nstage on\ncycles 1\n```\n' >"$work/page.md"
refused 'a pipe as the page that another starts from' "$no_file" "$nineball" check "$work/page.md"

# ---- ambiguous files, and paths that are too long ----

mkdir -p "$work/cases/a" "$work/cases/b" "$work/cases/c"
page '' | tee "$work/cases/a/twice.md" >"$work/cases/b/twice.md"
on twice go on >"$work/cases/c/wrong.md"
on a/twice go on >"$work/cases/c/right.md"
twice="expected one file of this name, found \`$work/cases/a/twice.md\` and \`$work/cases/b/twice.md\`"
"$nineball" explain "$work/cases/c/wrong.md" >"$work/out" 2>"$work/said"
test $? -eq 2 && grep -qF "cases/c/wrong.md:2:7: error: $twice" "$work/said" && grep -qF "hint: give its path from the folder of this page" "$work/said" &&
  "$nineball" explain "$work/cases/c/right.md" >"$work/out" 2>"$work/why"
result $? 'an ambiguous page'
page 'packing twice.md discs rock' >"$work/cases/c/wrong.md"
cat "$work/said" >>"$work/heard"
"$nineball" explain "$work/cases/c/wrong.md" >"$work/out" 2>"$work/said"
test $? -eq 2 && grep -qF "cases/c/wrong.md:3:9: error: $twice" "$work/said"
result $? 'an ambiguous packing'
page "packing $(many 4076 x) discs r" >"$work/wrong.md"
"$nineball" explain "$work/wrong.md" >"$work/out" 2>"$work/why"
test $? -eq 2 && grep -qF 'expected a path shorter than 4096 bytes' "$work/why"
result $? 'a path that is too long'
cat "$work/why" >>"$work/heard"

# ---- every message has occurred ----

# Messages that cannot occur here: the command line reports a --set without `=`.
unheard='^expected NAME=VALUE'

for source in $(grep -lE '"(input/)?(reader|scene)\.h"' src/*/*.c | grep -v manual); do
  awk -f tests/messages.awk "$source" | grep '[a-z]' | while IFS='	' read -r line text; do
    bare=$(echo "$text" | sed 's/%[-+ 0#]*[0-9]*\(\.[0-9*]*\)*[lzh]*[a-zA-Z]//g')
    case $bare in
    *[a-z]*) ;;
    *) continue ;;
    esac
    echo "$text" | grep -qE "$unheard" && continue
    pattern=$(printf '%s\n' "$text" | as_pattern)
    grep -qE -e "$pattern" "$work/heard" || echo "no page in tests/bad causes: $source:$line: $text"
  done >"$work/why"
  test ! -s "$work/why"
  result $? "every message of $source has its page"
done
echo "1..$n"
