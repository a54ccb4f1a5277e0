#!/bin/sh
# Writes cases/README.md: the pages in reading order, and which feature each tries, read off the pages themselves.
#
#   docs/cases.sh >cases/README.md
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu
cd "$(dirname "$0")/.."

# The pages of the lists PAGES and PAGES_LONG of Makefile.am, in their order.
pages=$(awk '
  ($1 == "PAGES" || $1 == "PAGES_LONG") && $2 == "=" { inside = 1; $1 = $2 = "" }
  inside { more = sub(/\\$/, ""); for (i = 1; i <= NF; i++) if ($i != "") print $i; inside = more }' Makefile.am)

cat <<'TEXT'
# The cases

Every page here is a handout, an input and a test. `nineball check PAGE` runs it and says what came out; its figure is drawn by `nineball figure PAGE`.
This list is made by `docs/cases.sh` from the pages, which it names in the order in which they are best read.

| page | about | from |
| --- | --- | --- |
TEXT
for page in $pages; do
  awk -v file="$(basename "$page")" '
    /^# / && title == "" { title = substr($0, 3); next }
    /^\[/ && title != "" && source == "" { source = $0; sub(/^\[/, "", source); sub(/\]$/, "", source) }
    /^```/ { exit }
    END { name = file; sub(/\.md$/, "", name); printf "| [%s](%s) | %s | %s |\n", name, file, title, source }' "$page"
done

cat <<'TEXT'

## What is tried where

TEXT
awk '
  # A feature: its head, the block it is said in, and what a line of that block matches.
  function feature(head, block, pattern) { heads[++n] = head; blocks[n] = block; patterns[n] = pattern }
  BEGIN {
    feature("spheres", "scene", "^spheres? ")
    feature("shear", "scene", "^shear +[^n]")
    feature("gravity", "scene", "^(ramp +)?gravity ")
    feature("walls move", "scene", "^(walls +inward|(ramp +)?wall .*velocity)")
    feature("walls turn", "scene", "^(ramp +)?wall .*spin")
    feature("dashpots", "scene", "^damping +contact")
    feature("global damping", "scene", "^damping +(global|con1)")
    feature("unlike materials", "scene", "^(pair |material +[^ ]+ .*)")
    feature("sweep", "scene", "^sweep ")
    feature("until", "scene", "^until ")
    feature("energy", "expect", "^(energy|work|momentum)")
    feature("curve", "expect", " along ")
    feature("trend", "expect", " (rises|falls|same|below|above|order) ")
    feature("stated", "expect", " stated ")
    feature("picture", "scene", "^snapshot")
    printf "| page |"; for (k = 1; k <= n; k++) printf " %s |", heads[k]; printf "\n| --- |"
    for (k = 1; k <= n; k++) printf " --- |"; printf "\n"
    for (p = 1; p < ARGC; p++) {
      file = ARGV[p]; block = ""; delete has; materials = 0
      while ((getline line < file) > 0) {
        if (line ~ /^```/) { block = block == "" ? substr(line, 4) : ""; continue }
        if (block == "scene" && line ~ /^material /) materials++
        for (k = 1; k <= n; k++) if (block == blocks[k] && line ~ patterns[k]) has[k] = 1
      }
      close(file)
      name = file; sub(/.*\//, "", name); sub(/\.md$/, "", name)
      printf "| [%s](%s.md) |", name, name
      for (k = 1; k <= n; k++) printf " %s |", (heads[k] == "unlike materials" ? materials > 1 : (k in has)) ? "x" : ""
      printf "\n"
    }
    exit
  }' $pages

cat <<'TEXT'

A page of your own: [docs/TUTORIAL.md](../docs/TUTORIAL.md). How to add it here: [HACKING.md](../HACKING.md).
TEXT
