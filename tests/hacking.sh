#!/bin/sh
# Follows the worked example of HACKING.md, and the law of docs/TUTORIAL.md, in a copy of the source tree: writes their
# files, adds their lines to the lists of build-aux/lists.mk, and runs their commands. TAP. $srcdir is the top of the
# source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
command -v automake >/dev/null || {
  echo "1..0 # SKIP automake is missing; it is needed when a list of build-aux/lists.mk changes"
  exit 0
}
tree=$work/tree
unset MAKEFLAGS MFLAGS MAKELEVEL srcdir # of the make that runs this test

# need STATUS NAME: as result, but without this the rest of the test makes no sense.
need() {
  result "$@"
  [ "$1" -eq 0 ] || {
    echo "1..$n"
    exit 1
  }
}

# The copy contains no files of a build. File times are kept, so the autotools run only for files that have changed.
mkdir "$tree"
for entry in setup autogen.sh configure.ac Makefile.am README.md HACKING.md NEWS COPYING .ci .clang-format src cases tests docs plots \
  m4 build-aux configure Makefile.in aclocal.m4 config.h.in; do
  test ! -e "$entry" || echo "$entry"
done | tar -c -f - --exclude='*.o' --exclude=.deps --exclude=.dirstamp -T - | tar -x -f - -C "$tree" >"$work/said" 2>&1
chmod -R u+w "$tree"
test -f "$tree/Makefile.am"
need $? "the tree is copied"

{
  sed -n '/^## A worked example/,$p' HACKING.md
  sed -n '/^## Write a page of your own/,/^## Write a loading programme/p' docs/TUTORIAL.md
} >"$work/example.md"
awk -v into="$tree" -f tests/fences.awk "$work/example.md" >"$work/lists" && test -s "$work/lists"
need $? "the files of the examples are written"

# `FILE LIST LINE`: the line is inserted after the first `LIST = \` of a Makefile, `#define LIST(ROW) \`,
# `#include LIST`, `struct LIST {` or `LIST[] = {`.
while read -r file list line; do
  list=$list line=$line awk '
    { print }
    !found && ($0 == ENVIRON["list"] " = \\" || index($0, "#define " ENVIRON["list"] "(") == 1 || $0 == "#include " ENVIRON["list"] ||
               $0 == "struct " ENVIRON["list"] " {" || index($0, ENVIRON["list"] "[] = {")) { print "  " ENVIRON["line"]; found = 1 }
    END { if (!found) print "there is no list " ENVIRON["list"] >"/dev/stderr" }' "$tree/$file" >"$work/file"
  cat "$work/file" >"$tree/$file"
done <"$work/lists" 2>"$work/said"
test ! -s "$work/said"
need $? "the lines of the examples are in the lists"

cd "$tree" || exit 1
{
  if test -f configure; then automake; else ./autogen.sh; fi && mkdir build && (cd build && ../configure CFLAGS=-O1)
} >"$work/said" 2>&1
need $? "configure"

# Of the tutorial only the commands about the law are run; tests/docs.sh runs the others.
sed '/^## Write a page of your own/,/^## Add a law of your own/d' "$work/example.md" | awk -f tests/fences.awk >"$work/commands"
test -s "$work/commands"
need $? "the examples have commands"
PATH=$tree/build:$PATH
while IFS='	' read -r line command; do
  wanted=$(echo "$command" | sed -n 's/.*#.*exit status \([0-9]\).*/\1/p')
  eval "$command" >"$work/said" 2>&1 </dev/null
  status=$?
  echo "exit status $status, wanted ${wanted:-0}" >>"$work/said"
  test $status -eq "${wanted:-0}"
  need $? "$(echo "$command" | sed 's/ *#.*//')"
done <"$work/commands"

# The suites that test all laws of the register include the new ones.
suites=$(grep -lE 'nb_laws|OF_NORMAL' tests/*.c | xargs grep -l '^void suite_' | tr '\n' ' ')
if grep -q "^CUNIT_LIBS = ." build/Makefile && test -n "$suites"; then
  sed -i "/^SUITES = /,/[^\\\\]\$/d" build-aux/lists.mk
  echo "SUITES = $suites" >>build-aux/lists.mk
  { make -C build suites-register.h && make -C build -j2 tests/unit; } >"$work/said" 2>&1 && build/tests/unit >"$work/said" 2>&1
  need $? "the laws pass the tests of all laws"
fi
echo "1..$n"
