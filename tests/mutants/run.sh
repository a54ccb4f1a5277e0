#!/bin/sh
# Mutation testing: `make mutants` changes one place after the other in a copy of the tree, compiles, and runs the unit
# tests, the invalid pages and the cases until one fails. It lists which check killed which mutant, and fails if a
# mutant survives.
#
#   make mutants                          all mutants; about a second each
#   make mutants MUTANTS=shear_linear     the mutants whose file or description contains the word
#
# The mutants of other code are made by schemata.py.
#
# The rules are in tests/mutants/rules.txt. The copy stays in mutants/ of the build folder, so that the next run builds
# less; `make clean` removes it. $NB_PAGES are the pages, $srcdir is the top of the source tree, $MAKE, $CC and $AWK the
# programs.
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

# The first copy keeps the file times, so the autotools do not run. Later only files that differ are copied, which also
# restores what a stopped run left.
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

# Prints the first failed test, or nothing. A program that crashes prints fewer tests than planned. The limit is
# processor time: a mutant may loop forever, and the machine may be busy.
first_red() {
  (ulimit -t 120 2>/dev/null; exec "$@") 2>/dev/null | $awk '
    /^not ok/ { sub(/^not ok [0-9]* *-* */, ""); print; told = 1; exit }
    /^1\.\./ { planned = substr($0, 4) + 0 }
    /^ok/ { seen++ }
    END { if (!told && (seen < planned || !planned)) print "crashed, or took too long, after " seen + 0 " tests" }' 
}

# Finds the check that kills the mutant and sets $by, "" if it survives. The suites that killed the last mutants run
# first.
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
echo "mutants: building the unchanged tree"
$make -s all >../said 2>&1 && $make -s tests/unit >../said 2>&1 || stop "the tree does not build: $work/said"
check
test -z "$by" || stop "the unchanged tree fails: $by"

# ---- the mutants -----------------------------------------------------------------------------------------------------

# The rules, one per line: KIND, words, file, old text, new text.
cd "$tree" || exit 1
$awk -v OFS="$tab" '
  function put() { if (kind) print kind, words, file, old, new; kind = old = new = file = "" }
  /^#/ || /^$/ { next }
  /^[a-z]+ / { key = $1; value = $0; sub(/^[a-z]+ +/, "", value) }
  key == "each" { put(); print key, "-", value, "-", "-"; key = ""; next }
  key == "module" { put(); key = ""; next }
  key == "mutant" || key == "equal" { put(); kind = key; words = value; key = ""; next }
  key == "in" { file = value; key = ""; next }
  /^- / { old = substr($0, 3); sub(/^ +/, "", old); next }
  /^\+ / { new = substr($0, 3); sub(/^ +/, "", new); next }
  { print "invalid", NR, "-", "-", "-" }
  END { put() }' tests/mutants/rules.txt >../table
grep "^invalid" ../table && stop "invalid lines of tests/mutants/rules.txt; expected: each, module, mutant, equal, in, -, +"

# Lists the place of each mutant: LINE, COLUMN, LENGTH, new text. A rule whose text does not occur exactly once is out of
# date.
: >../list
: >../outdated
while IFS=$tab read -r kind words file old new; do
  case $kind in
  each)
    set -- $file
    test -f "$1" || echo "each $file: no such file" >>../outdated
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
      echo "$words: \`$old\` occurs $at times in $file" >>../outdated
    else
      printf 'mutant\t%s\t%s\t%s\t%s\t%s\t%s\n' "$words" "$file" "$line" "$at" "$size" "$new" >>../list
    fi
    ;;
  esac
done <../table

# Applies the mutant, keeps the original file in `right`, and sets $wrong to the changed line.
apply() {
  cp "$tree/$file" ../right
  text=$text $awk -v line="$line" -v at="$at" -v size="$size" '
    NR == line { $0 = substr($0, 1, at - 1) ENVIRON["text"] substr($0, at + size) } { print }' ../right >"$tree/$file"
  wrong=$(sed -n "${line}{s/^ *//;p;}" "$tree/$file")
}

# True if a rule `equal` names this mutant; the rule is noted as used.
equal() {
  wrong=$wrong $awk -F "$tab" -v file="$file" '$1 == "equal" && $3 == file && $5 == ENVIRON["wrong"] { print NR; exit }' \
    ../table >../met
  test -s ../met && cat ../met >>../equals
}

# ---- one after the other ---------------------------------------------------------------------------------------------

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
    if test "$kind" = mutant; then echo "$what: does not compile: $(grep -m 1 error ../said)" >>../outdated; fi
    none=$((none + 1))
    cp ../right "$tree/$file"
    continue
  fi
  check
  if (cd "$tree" && equal); then
    same=$((same + 1))
    test -z "$by" || echo "$what: an equivalent mutant according to the rules, but killed by $by" >>../outdated
    by="equivalent, see tests/mutants/rules.txt"
  elif test -z "$by"; then
    by="SURVIVES"
    echo "$what" >>../survivors
  else
    caught=$((caught + 1))
  fi
  printf '%d/%d, %d min left: %s\n      %s\n' "$n" "$count" "$left" "$what" "$by"
  cp ../right "$tree/$file"
done 3<../list

# A complete run must use every rule `equal`.
if test -z "$only"; then
  $awk -F "$tab" '
    FILENAME == "../equals" { met[$1] = 1; next }
    FILENAME == "../list" { tried[$3] = 1; next }
    $1 == "equal" && tried[$3] && !met[FNR] { print $3 ": no mutant makes `" $5 "`" }' \
    ../equals ../list ../table >>../outdated
fi
echo "mutants: $caught killed, $(wc -l <../survivors) survived, $same equivalent, $none do not compile; $(($(date +%s) - began)) s"
sed 's/^/survived: /' ../survivors
sed 's/^/rule out of date: /' ../outdated
test "$n" -gt 0 || stop "no mutant matches \`$only\`"
test ! -s ../survivors && test ! -s ../outdated
