#!/bin/sh
# Tests the documents: every link leads to a file or heading, and every command ends with the exit status that the text
# says. TAP. $NINEBALL is the program, $srcdir the top of the source tree.
#
# A command must end with status 0, or with the status that its comment names: `nineball check mine.md  # exit status 1`. Its
# output must have the lines of the next block ```text output. The commands of one document run one after the other, in a folder
# of their own with cases/ and plots/. Commands that install, configure or build are not run: the test only requires that their
# targets of setup and make, and their files, exist. A page whose comment says that it takes minutes is explained instead of run;
# make check-long runs it.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
top=$(pwd)
PATH=$(dirname "$nineball"):$PATH
documents="README.md HACKING.md NEWS $(echo docs/*.md cases/*.md cases/*/*.md)"

# ---- links ----

# Prints the anchors of a document, as a forge makes them from the headings: small letters, spaces as -, no punctuation; the
# second anchor of the same name ends in -1.
anchors() {
  awk '/^(```|~~~)/ { inside = !inside; next }
    !inside && /^#+ / {
      sub(/^#+ +/, ""); gsub(/\]\([^)]*\)/, ""); $0 = tolower($0); gsub(/[][!-,.\/:-@\\^`{|}~]|–|—|…|’|“|”/, ""); gsub(/ /, "-")
      print $0 (seen[$0]++ ? "-" seen[$0] - 1 : "") }' "$1"
}

# links DOCUMENT...: prints the broken links.
links() {
  for document in "$@"; do
    grep -o ']([^) ]*)' "$document" | sed 's/^](//; s/)$//' | grep -v '^[a-z]*:' | sort -u |
      while read -r link; do
        file=$(dirname "$document")/${link%%#*}
        test "${link%%#*}" || file=$document
        case $link in
        *#*) anchors "$file" 2>/dev/null | grep -qxF -e "${link#*#}" || echo "$document links to $link: there is no such heading" ;;
        *) test -e "$file" || echo "$document links to $link: there is no such file" ;;
        esac
      done
  done
}
links $documents >"$work/said"
test ! -s "$work/said"
result $? "links between documents"

# Two of these four links to files are broken, and two of these five anchors.
mkdir "$work/links"
printf '# A *small* `thing`: [what](b.md) it is\n## Twice\n## Twice\n## Figures 1–3\n[b](b.md) [c](c.md) [d](../links/b.md) [e](d/b.md)\n' >"$work/links/a.md"
printf '[1](a.md#a-small-thing-what-it-is) [2](a.md#twice-1) [3](a.md#twice-2) [4](#here) [5](a.md#figures-13)\n```\n# Here\n```\n' >"$work/links/b.md"
links "$work/links/a.md" "$work/links/b.md" | sed 's/.* to //; s/: .*//' | tr '\n' ' ' >"$work/said"
test "$(cat "$work/said")" = 'c.md d/b.md #here a.md#twice-2 '
result $? "broken links are found"

# ---- recipes of figures ----

for recipe in plots/*.gp; do
  name=${recipe#plots/}
  test "$name" = style.gp || grep -qF "load plots.'$name'" cases/*/*.md || echo "no page draws $recipe"
  grep -qF "$recipe" build-aux/lists.mk || echo "$recipe is not installed"
done >"$work/said"
grep -n '^ *set term' cases/*/*.md plots/*.gp | sed 's/$/: eval canvas(WIDE, HIGH) draws the PNG as well/' >>"$work/said"
test ! -s "$work/said"
result $? "recipes of figures are drawn by a page, and installed"

docs/cases.sh "$work/renewed" >"$work/said" 2>&1 && for list in cases/README.md cases/*/README.md; do
  diff -u "$list" "$work/renewed/$list"
done >"$work/said"
test ! -s "$work/said"
result $? 'the lists of cases are as docs/cases.sh makes them'

# ---- commands ----

# True if the word is a target of make.
is_target() {
  case $1 in
  all | check | clean | dist | distcheck | distclean | install | installcheck | uninstall) true ;;
  nineball | tests/unit) true ;;
  *) grep -q "^$1:" Makefile.am ;;
  esac
}

# A command that is not run, such as `./setup check && make -C build report`: every part of it must exist.
exists() {
  echo "$1" | sed 's/&&/\n/g' | while read -r program arguments; do
    case $program in
    ./setup | make)
      test "$program" = make || test -x setup || echo "there is no setup"
      skip=
      for word in $arguments; do
        case $skip$word in
        -C | -j) skip=x ;;
        -* | *=* | x*) skip= ;;
        *) is_target "$word" || echo "there is no target $word" ;;
        esac
      done
      ;;
    cd | mkdir | apt* | git) ;;
    ./configure | ../configure) test -f configure.ac || echo "there is no configure.ac" ;;
    sh | bash) test -f "${arguments%% *}" || echo "there is no ${arguments%% *}" ;;
    *) test -x "$program" || echo "there is no $program" ;;
    esac
  done >"$work/said"
  test ! -s "$work/said"
}

run() {
  wanted=$(echo "$1" | sed -n 's/.*#.*exit status \([0-9]\).*/\1/p')
  (cd "$folder" && eval "$1") >"$work/said" 2>&1 </dev/null
  status=$?
  echo "exit status $status, wanted ${wanted:-0}" >>"$work/said"
  test $status -eq "${wanted:-0}"
}

# The examples that add files to the tree are run by tests/hacking.sh.
without_example() { sed '/^## A worked example/,$d; /^## Add a law of your own/,/^## Write a loading programme/d' "$1"; }

for document in $documents; do
  without_example "$document" >"$work/document"
  awk -f tests/fences.awk "$work/document" >"$work/commands"
  test -s "$work/commands" || continue
  folder=$work/$(echo "$document" | tr / -).d
  mkdir -p "$folder/build" && cp -R cases plots "$folder" && chmod -R u+w "$folder"
  ln -s "$nineball" "$folder/build/nineball"
  awk -v into="$folder" -f "$top/tests/fences.awk" "$work/document" >/dev/null
  while IFS='	' read -r line command; do
    name=$(echo "$document:$line: $command" | sed 's/ *#.*//')
    case $command in *'# takes '*minute*) command=$(echo "$command" | sed 's/nineball [a-z]* /nineball explain /') ;; esac
    case $command in
    '>'*)
      grep -qF -e "${command#>}" "$work/said"
      result $? "$document:$line: a line of the output of the command above"
      ;;
    ./setup* | make* | ./autogen.sh* | *configure* | apt* | git* | .ci/* | bash* | sh\ * | docs/*)
      exists "$(echo "$command" | sed 's/ #.*//')"
      result $? "$name"
      ;;
    *'nineball figure'* | *'nineball report'*)
      if command -v gnuplot >/dev/null; then
        run "$command"
        status=$?
        if grep -q 'cannot be confined here' "$work/said"; then
          n=$((n + 1))
          echo "ok $n - $name # SKIP gnuplot cannot be confined here"
        else
          result $status "$name"
        fi
      else
        n=$((n + 1))
        echo "ok $n - $name # SKIP gnuplot is missing"
      fi
      ;;
    *)
      run "$command"
      result $? "$name"
      ;;
    esac
  done <"$work/commands"
done
echo "1..$n"
