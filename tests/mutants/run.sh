#!/bin/sh
# Do the checks see a small mistake? `make mutants` makes one after the other in a copy of the tree, compiles the one file, and
# runs the unit tests, then the invalid pages, then the cases, until one is red. It lists who caught which mistake; one that nobody caught makes it fail.
#
#   make mutants                          all; about a second each
#   make mutants MUTANTS=shear_linear     those whose file or description has the word
#   make mutants MUTANTS=loading          those of a module; the only way to them
#
# What is changed stands in tests/mutants/rules.txt. The copy is kept in mutants/ of the build folder, to build less the next time;
# `make clean` removes it. $NB_PAGES are the pages, $srcdir is the top of the source tree, $MAKE, $CC and $AWK are what they say.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -u
make=${MAKE:-make} awk=${AWK:-awk} only=${1-}
unset MAKEFLAGS MFLAGS MAKELEVEL
here=$(cd "${srcdir:-.}" && pwd) || exit 1
mkdir -p mutants && cd mutants || exit 1
work=$(pwd)
tree=$work/tree build=$work/build
tab=$(printf '\t')

stop() {
  echo "mutants: $*" >&2
  exit 2
}

# ---- the copy --------------------------------------------------------------------------------------------------------

# Times are kept at first, so that autotools do not run; later what differs comes anew, what a stopped run left among it.
entries() {
  cd "$here" || exit 1
  find setup autogen.sh configure.ac configure aclocal.m4 Makefile.am Makefile.in config.h.in README.md HACKING.md NEWS COPYING \
    .ci .clang-format src cases tests docs plots m4 build-aux \
    \( -name '*.o' -o -name .deps -o -name .dirstamp -o -name '*.log' -o -name '*.trs' \) -prune -o -type f -print
}
if test ! -f "$build/Makefile"; then
  rm -rf "$tree" "$build"
  mkdir "$tree" "$build"
  entries | (cd "$here" && tar -c -f - -T -) | tar -x -f - -C "$tree" || stop "the tree cannot be copied"
  chmod -R u+w "$tree"
  (cd "$build" && ../tree/configure -q ${CC:+CC="$CC"} CFLAGS=-O1) >said 2>&1 || stop "configure fails: $work/said"
fi
entries | while read -r file; do
  cmp -s "$here/$file" "$tree/$file" && continue
  case $file in */*) mkdir -p "$tree/${file%/*}" ;; esac
  cp "$here/$file" "$tree/$file"
done
trap 'exit 130' INT TERM

# ---- the checks ------------------------------------------------------------------------------------------------------

# The first red test, or nothing. A program that crashes says less than it planned. Seconds of the processor: a mistake may make a
# loop endless, a busy machine may not.
first_red() {
  (ulimit -t 120 2>/dev/null; exec "$@") 2>/dev/null | $awk '
    /^not ok/ { sub(/^not ok [0-9]* *-* */, ""); print; told = 1; exit }
    /^1\.\./ { planned = substr($0, 4) + 0 }
    /^ok/ { seen++ }
    END { if (!told && (seen < planned || !planned)) print "crashed, or took too long, after " seen + 0 " tests" }' 
}

# Who catches the mistake in the tree as it is: the answer in $by, "" for nobody. The suites that caught the last ones go first.
suites=
check() {
  by=
  for suite in $suites; do
    by=$(first_red ./tests/unit "$suite")
    test -z "$by" || break
  done
  test -n "$by" || by=$(first_red ./tests/unit)
  case $by in
  crashed*) by="unit, $by" && return ;;
  ?*)
    set -- "${by%%:*}" $suites
    suites=$1
    for suite in "$@"; do
      case " $suites " in *" $suite "* | *' '*' '*' '*) ;; *) suites="$suites $suite" ;; esac
    done
    by="unit, $by"
    return
    ;;
  esac
  $make -s nineball >>../said 2>&1 || { by="does not link" && return; }
  by=$(first_red env srcdir="$tree" NINEBALL=./nineball sh "$tree/tests/mistakes.sh")
  test -z "$by" || { by="mistakes.sh, $by" && return; }
  for page in $NB_PAGES; do
    by=$(first_red ./nineball check --tap "$tree/$page")
    test -z "$by" || { by="${page##*/}, ${by##*/tree/cases/}" && return; }
  done
}

cd "$build" || exit 1
echo "mutants: building what is right"
$make -s all >../said 2>&1 && $make -s tests/unit >../said 2>&1 || stop "the tree does not build: $work/said"
check
test -z "$by" || stop "red without any mistake: $by"

# ---- the mistakes ----------------------------------------------------------------------------------------------------

# Records of the table, one a line: KIND, words, file, old text, new text.
cd "$tree" || exit 1
$awk -v OFS="$tab" '
  function put() { if (kind) print kind, words, file, old, new; kind = old = new = file = "" }
  /^#/ || /^$/ { next }
  /^[a-z]+ / { key = $1; value = $0; sub(/^[a-z]+ +/, "", value) }
  key == "each" { put(); print key, "-", value, "-", "-"; key = ""; next }
  key == "module" { put(); module = value; sub(/ .*/, "", module); sub(/^[^ ]+ /, "", value); print key, module, value, "-", "-"; key = ""; next }
  key == "mutant" || key == "equal" { put(); kind = key; words = value; key = ""; next }
  key == "in" { file = value; key = ""; next }
  /^- / { old = substr($0, 3); sub(/^ +/, "", old); next }
  /^\+ / { new = substr($0, 3); sub(/^ +/, "", new); next }
  { print "mistake", NR, "-", "-", "-" }
  END { put() }' tests/mutants/rules.txt >../table
grep "^mistake" ../table && stop "lines of tests/mutants/rules.txt that are none of: each, module, mutant, equal, in, -, +"

# Where each stands: LINE, COLUMN, LENGTH, new text. A text that is not there, or twice, is a rule that has rotted.
: >../list
: >../rotten
while IFS=$tab read -r kind words file old new; do
  case $kind in
  each | module)
    test "$kind" = module && test -z "$only" && continue
    set -- $file
    test -f "$1" || echo "each $file: no such file" >>../rotten
    for path in "$@"; do
      $awk -f tests/mutants/small.awk "$path" | while IFS=$tab read -r line at size text; do
        printf 'each\t%s\t%s\t%s\t%s\t%s\t%s\n' "$words" "$path" "$line" "$at" "$size" "$text"
      done >>../list
    done
    ;;
  mutant)
    old=$old $awk -v OFS="$tab" '
      BEGIN { old = ENVIRON["old"] }
      { rest = $0; at = 0
        while ((found = index(rest, old)) > 0) {
          n++; line = NR; column = at + found
          at += found; rest = substr(rest, found + 1) } }
      END { if (n == 1) print line, column, length(old); else print "times", n + 0 }' "$file" >../place
    IFS=$tab read -r line at size <../place
    if test "$line" = times; then
      echo "$words: \`$old\` occurs $at times in $file" >>../rotten
    else
      printf 'mutant\t%s\t%s\t%s\t%s\t%s\t%s\n' "$words" "$file" "$line" "$at" "$size" "$new" >>../list
    fi
    ;;
  esac
done <../table

# Puts the mistake into the tree, what was right into `right`; answers the line as it then is in $wrong.
apply() {
  cp "$tree/$file" ../right
  text=$text $awk -v line="$line" -v at="$at" -v size="$size" '
    NR == line { $0 = substr($0, 1, at - 1) ENVIRON["text"] substr($0, at + size) } { print }' ../right >"$tree/$file"
  wrong=$(sed -n "${line}{s/^ *//;p;}" "$tree/$file")
}

# Is this mistake said to be none? Marks the rule as met.
equal() {
  wrong=$wrong $awk -F "$tab" -v file="$file" '$1 == "equal" && $3 == file && $5 == ENVIRON["wrong"] { print NR; exit }' \
    ../table >../met
  test -s ../met && cat ../met >>../equals
}

# ---- one after the other ---------------------------------------------------------------------------------------------

# A file may be in two modules.
$awk -F "$tab" -v only="$only" '
  only != "" && !index(tolower($2), tolower(only)) && !index(tolower($3), tolower(only)) { next }
  !seen[$3, $4, $5, $6, $7]++' ../list >../some
mv ../some ../list
count=$(wc -l <../list)
began=$(date +%s)
n=0 caught=0 none=0 same=0
: >../survivors
: >../equals
cd "$build" || exit 1
while IFS=$tab read -r kind words file line at size text <&3; do
  n=$((n + 1))
  apply
  left=$((($(date +%s) - began) * (count - n + 1) / n / 60))
  what="$file:$line: $wrong"
  test "$kind" = each || what="$what    # $words"
  if ! $make -s tests/unit >../said 2>&1; then
    if test "$kind" = mutant; then echo "$what: does not compile: $(grep -m 1 error ../said)" >>../rotten; fi
    none=$((none + 1))
    cp ../right "$tree/$file"
    continue
  fi
  check
  if (cd "$tree" && equal); then
    same=$((same + 1))
    test -z "$by" || echo "$what: is said to be no mistake, but is caught by $by" >>../rotten
    by="no mistake, see tests/mutants/rules.txt"
  elif test -z "$by"; then
    by="SURVIVES"
    echo "$what" >>../survivors
  else
    caught=$((caught + 1))
  fi
  printf '%d/%d, %d min left: %s\n      %s\n' "$n" "$count" "$left" "$what" "$by"
  cp ../right "$tree/$file"
done 3<../list

# A whole run must have met every mistake that is said to be none.
if test -z "$only"; then
  $awk -F "$tab" '
    FILENAME == "../equals" { met[$1] = 1; next }
    FILENAME == "../list" { tried[$3] = 1; next }
    $1 == "equal" && tried[$3] && !met[FNR] { print $3 ": no mutant makes `" $5 "`" }' \
    ../equals ../list ../table >>../rotten
fi
echo "mutants: $caught caught, $(wc -l <../survivors) survived, $same no mistakes, $none that are no C; $(($(date +%s) - began)) s"
sed 's/^/survived: /' ../survivors
sed 's/^/rotten rule: /' ../rotten
test "$n" -gt 0 || stop "none has to do with \`$only\`"
test ! -s ../survivors && test ! -s ../rotten
