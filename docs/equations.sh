#!/bin/sh
# Which file carries which equation: reads the tags [CS79 8-15], [R89 4.13] of the sources and writes the
# table of them, which the build keeps in docs/EQUATIONS.md.
#
#   docs/equations.sh [TOP]      the top of the source tree; default: where this script lies, and one up
#
# In a tag, after the paper: equations and ranges of them; `figure 1`, `figures 5, 6`; `table 1`; sections of R89, which
# have three numbers; sections of CS79 by their titles. `X = Y` is a remark. One tag may hold both papers, with `;`
# between them. A tag that says anything else is told, and the exit status is 1.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu
LC_ALL=C
export LC_ALL
cd "${1:-$(dirname "$0")/..}"

# What the equations are about; the ones without a line here have no words in the table.
words() {
  cat <<'WORDS'
CS79|1|force of the first overlap, k_n v dt
CS79|2|sums of force on two discs in a row
CS79|3|their accelerations
CS79|4|their velocities after one step
CS79|5|relative displacement at the first wall
CS79|6|relative displacement between the discs
CS79|7|relative displacement at the second wall
CS79|8|when two discs touch
CS79|9|unit vector from the first centre to the second
CS79|10|tangent, that vector turned clockwise
CS79|11|relative velocity at the contact
CS79|12|its normal part
CS79|13|its tangential part
CS79|14|normal displacement over a step
CS79|15|tangential displacement over a step
CS79|16|increment of the normal force
CS79|17|increment of the shear force
CS79|18|sums of the increments
CS79|19|largest shear force
CS79|20|Newton's law, centre
CS79|21|Newton's law, spin
CS79|22|velocity at the next half step
CS79|22a|position at the next step
CS79|23|spin at the next half step
CS79|23a|rotation at the next step
CS79|24|velocity, with contact damping
CS79|25|spin, with contact damping
CS79|26|normal dashpot
CS79|27|shear dashpot
CS79|28|coefficients of the dashpots, beta k
CS79|29|motion with global damping, centre
CS79|30|motion with global damping, spin
CS79|31|velocity at a whole step
CS79|32|velocity at the next half step, with C
CS79|33|spin at the next half step, with C*
CS79|34|C and C* in proportion to mass and inertia
CS79|35|velocity at the next half step, with alpha
CS79|36|spin at the next half step, with alpha
R89|4.3|damped normal force by a share of the critical step
R89|4.4|damped shear force by the same
R89|4.6|reduced mass
R89|3.11|radius of the contact circle, a^2 = R* alpha
R89|3.13|Hertz: N = (4/3) E* R*^(1/2) alpha^(3/2)
R89|3.24|front of slip in a contact that is loaded
R89|3.25|tangential displacement, loading at constant N
R89|3.28|front of the slip when it is unloaded
R89|3.40|tangential displacement, unloading at constant N
R89|3.50|tangential displacement, reloading at constant N
R89|3.56|contact radius after a change of N
R89|3.61|front of an increment of slip
R89|3.64|stiffness of an increment on the contact with the new N
R89|3.65|slip that a new ring takes with it
R89|3.68|loading, N rising
R89|3.69|theta of loading
R89|3.70|loading that lags behind its ring
R89|3.76|theta of unloading
R89|3.82|theta of reloading
R89|3.94|tangential stiffness, all cases in one
R89|3.95|theta, loading
R89|3.96|theta, unloading
R89|3.97|theta, reloading
R89|3.98|theta where the new ring sticks
R89|4.5|equivalent radius R*
R89|4.7|equivalent Young's modulus E*
R89|4.8|equivalent shear modulus G*
R89|4.9|of the first body
R89|4.10|of the second body
R89|4.11|force increment at first touch
R89|4.12|force increment, dN = 2 E* a dn
R89|4.14|contact radius from the force
R89|4.15|increment of the tangential force
R89|4.16|critical slip ds_c
R89|4.17|deficit DD
R89|4.18|deficit DD, N falling
R89|4.19|damped tangential force
R89|4.20|T* moves with N
R89|4.21|T** moves with N
R89|4.22|theta, THE1 = 1, loading
R89|4.23|theta, THE1 = 2, unloading
R89|4.24|theta, THE1 = 3, reloading
R89|4.25|theta, THE1 = 4, the new ring sticks
R89|4.26|critical step, normal
R89|4.27|critical step, shear
R89|4.28|step as a fraction of it
R89|4.29|speed of pressure waves
R89|4.30|speed of shear waves
R89|4.31|speed of Rayleigh waves
R89|4.32|Rayleigh's equation
R89|4.33|step of the Rayleigh wave
R89|4.34|linear fit of its root
R89|4.35|stiffness that a body has met
R89|4.36|way of a body in a step
R89|4.37|critical step of a body from these
R89|4.38|change of the force sum
R89|4.39|size of the force sum
R89|4.40|FRACC, step over critical step
R89|5.5|equation of the normal impact
R89|5.9|largest overlap of a normal impact
R89|5.10|time against overlap
R89|5.11|duration of the contact
R89|5.12|the same in numbers
R89|5.13|traction by annuli
R89|5.14|chi
R89|5.15|psi, angle of incidence made free of size
R89|5.16|angle of incidence
R89|4.13|damped normal force by a share of critical damping
WORDS
}

# One line a tag: FILE [CS79 8-15]. What law_batch.h has are examples.
tags() {
  find src cases/refs -name '*.[ch]' ! -name law_batch.h | sort |
    xargs awk '{
      line = $0
      while (match(line, /\[(CS79|R89)[^]]*\]/)) {
        print FILENAME, substr(line, RSTART, RLENGTH)
        line = substr(line, RSTART + RLENGTH)
      }
    }'
}

# One line for each thing a tag names: PAPER|KIND|SORT KEY|NAME|FILE; KIND is 1 for equations, 2 for all else.
named() {
  awk '
    function key(text) { split(text, part, "."); return sprintf("%05d%05d%s", part[1], part[2], text ~ /a$/ ? "a" : "0") }
    function say(kind, sort, name) { print paper "|" kind "|" sort "|" name "|" file }
    function range(text, at, from, to, head) {
      at = index(text, "-")
      from = at ? substr(text, 1, at - 1) : text
      to = at ? substr(text, at + 1) : text
      head = ""
      if (paper == "R89") { head = from; sub(/[0-9]+$/, "", head); sub(/^.*\./, "", from); sub(/^.*\./, "", to) }
      if (from == to) { say(1, key(head from), head from); return }
      for (i = from + 0; i <= to + 0; i++) {
        say(1, key(head i), head i)
        if (paper == "CS79" && (i == 22 || i == 23) && i < to + 0) say(1, key(i "a"), i "a")
      }
      if (to ~ /a$/) say(1, key(to), to)
    }
    function things(thing, text, ends, count, head, i) { # 5-7, or with their chapter: 5.11-5.13
      count = split(text, ends, "-")
      head = ""
      if (text ~ /\./) { head = ends[1]; sub(/[0-9]+$/, "", head) }
      sub(/^.*\./, "", ends[1]); sub(/^.*\./, "", ends[count])
      for (i = ends[1] + 0; i <= ends[count] + 0; i++) say(2, (thing == "figure" ? "1" : "2") key(head i), thing " " head i)
    }
    function item(text) {
      sub(/^ +/, "", text); sub(/ +$/, "", text)
      if (text == "" || text ~ /=/) return
      if (text ~ /^(figure|table)s? [0-9]+(\.[0-9]+)?(-[0-9]+(\.[0-9]+)?)?$/) {
        thing = text; sub(/s? .*/, "", thing)
        many = text ~ /s [0-9.-]+$/
        sub(/.* /, "", text)
        things(thing, text)
      } else if (many && text ~ /^[0-9]+(\.[0-9]+)?(-[0-9]+(\.[0-9]+)?)?$/) things(thing, text)
      else if (paper == "CS79" && text ~ /^[0-9]+a?(-[0-9]+a?)?$/) range(text)
      else if (paper == "R89" && text ~ /^[0-9]+\.[0-9]+(-[0-9]+\.[0-9]+)?$/) range(text)
      else if (paper == "R89" && text ~ /^[0-9]+\.[0-9]+\.[0-9]+$/) say(2, "0" text, "section " text)
      else if (paper == "R89" && text ~ /^section [0-9]+\.[0-9]+$/) say(2, "0" substr(text, 9), text)
      else if (text ~ /^[A-Z][A-Za-z -]*$/) say(2, "3" text, "*" text "*")
      else { print "equations.sh: " file ": cannot read `" text "` in " tag >"/dev/stderr"; bad = 1 }
    }
    {
      file = $1
      tag = substr($0, length(file) + 2)
      inside = substr(tag, 2, length(tag) - 2)
      papers = split(inside, each, ";")
      for (p = 1; p <= papers; p++) {
        text = each[p]
        sub(/^ +/, "", text)
        paper = text ~ /^R89/ ? "R89" : "CS79"
        sub(/^(CS79|R89)/, "", text)
        many = 0
        items = split(text, list, ",")
        for (n = 1; n <= items; n++) item(list[n])
      }
    }
    END { exit bad }'
}

# The rows of one paper and kind, as a table. Equations of CS79 stand there even when no file has them.
table() {
  { words | awk -F '|' -v paper="$1" -v kind="$2" '
      function key(text) { split(text, part, "."); return sprintf("%05d%05d%s", part[1], part[2], text ~ /a$/ ? "a" : "0") }
      $1 == paper && kind == 1 { print key($2) "|0|" $2 "|" $3 }'
    echo "$found" | awk -F '|' -v paper="$1" -v kind="$2" '$1 == paper && $2 == kind { print $3 "|1|" $4 "|" $5 }'
  } | sort -u | awk -F '|' -v paper="$1" -v kind="$2" '
    function flush() {
      if (name == "" || (paper == "R89" && files == "")) return # of the thesis, what is used
      if (kind == 1) printf "| %s | %s | %s |\n", name, about, files == "" ? "nowhere" : files
      else printf "| %s | %s |\n", name, files
    }
    $3 != name { flush(); name = $3; about = ""; files = "" }
    $2 == 0 { about = $4 }
    $2 == 1 { files = files (files == "" ? "" : ", ") $4 }
    END { flush() }'
}

found=$(tags | named)

cat <<'HEAD'
# Equations, and the files they stand in

Made by `docs/equations.sh` from the tags in the sources; the symbols are those of the papers, see docs/METHOD.md. Files are named
from the top of the source tree.

## CS79: Cundall and Strack (1979)

| equation | about | files |
| --- | --- | --- |
HEAD
table CS79 1
printf '\n| also | files |\n| --- | --- |\n'
table CS79 2
cat <<'HEAD'

## R89: Randall (1989)

| equation | about | files |
| --- | --- | --- |
HEAD
table R89 1
printf '\n| also | files |\n| --- | --- |\n'
table R89 2
