#!/bin/sh
# The documents are true: links lead somewhere, and every command that is
# shown can be given and ends as the text says. TAP. $NINEBALL is the program, $srcdir the top of the source tree.
#
# A command must end with status 0, or with the one its comment names: `nineball check mine.md  # exit status 1`. Those
# of one document run one after the other in a folder of their own that has cases/ and plots/. What installs, configures
# or builds is not run here: of setup and make the targets must exist, of other programs of the tree the file.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
top=$(pwd)
PATH=$(dirname "$nineball"):$PATH
documents="README.md HACKING.md NEWS $(echo docs/*.md cases/*.md cases/*/*.md)"

# ---- links ----

for document in $documents; do
  grep -o '](\([^)#]*\)[^)]*)' "$document" | sed 's/^](//; s/[)#].*//' | grep -v '^[a-z]*:' | sort -u |
    while read -r link; do
      [ -z "$link" ] || [ -e "$(dirname "$document")/$link" ] || echo "$document links to $link, which is not there"
    done
done >"$work/said"
test ! -s "$work/said"
result $? "links between documents"

# ---- recipes of figures ----

for recipe in plots/*.gp; do
  name=${recipe#plots/}
  test "$name" = style.gp || grep -qF "load plots.'$name'" cases/*/*.md || echo "no page draws $recipe"
  grep -qF "$recipe" build-aux/lists.mk || echo "$recipe is not installed"
done >"$work/said"
grep -n '^ *set term' cases/*/*.md plots/*.gp | sed 's/$/: eval canvas(WIDE, HIGH) draws the PNG as well/' >>"$work/said"
test ! -s "$work/said"
result $? "recipes of figures are drawn by a page, and installed"

docs/cases.sh >"$work/README.md" && diff -u cases/README.md "$work/README.md" >"$work/said"
result $? 'cases/README.md is what docs/cases.sh makes'

# ---- commands ----

# Is it a target of make?
is_target() {
  case $1 in
  all | check | clean | dist | distcheck | distclean | install | installcheck | uninstall) true ;;
  nineball | tests/unit) true ;;
  *) grep -q "^$1:" Makefile.am ;;
  esac
}

# What is not run: `./setup check && make -C build report`. Every part must name what exists.
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

# HACKING.md ends with an example that has a test of its own, which changes the tree.
without_example() { sed '/^## A worked example/,$d' "$1"; }

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
    case $command in
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
