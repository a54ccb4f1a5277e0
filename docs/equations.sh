#!/bin/sh
# Reads the tags of the sources, such as [CS79 8-15] and [R89 4.13], and prints a table of equations and source files. The build
# writes it to docs/EQUATIONS.md.
#
#   docs/equations.sh [TOP]      the top of the source tree; default: the parent of the folder of this script
#
# A tag contains, after the paper: equations and ranges of equations; `figure 1`, `figures 5, 6`; `table 1`; sections of R89
# as `sec. 4.4` or `sec. 3.2-3.5`; sections of CS79 by their titles. `X = Y` is a comment. One tag can contain both papers,
# separated by `;`. Any other text, and an equation or a section that the paper does not have, is an error: it is reported, and
# the exit status is 1.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu
LC_ALL=C
export LC_ALL
cd "${1:-$(dirname "$0")/..}"

# The subject of each equation. 
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
CS79|9|normal, from the first centre to the second
CS79|10|tangent, the normal rotated clockwise
CS79|11|relative velocity at the contact
CS79|12|its normal part
CS79|13|its tangential part
CS79|14|normal displacement over a step
CS79|15|tangential displacement over a step
CS79|16|increment of the normal force
CS79|17|increment of the shear force
CS79|18|sums of the increments
CS79|19|largest shear force
CS79|20|Newton's law, translation
CS79|21|Newton's law, rotation
CS79|22|velocity at the next half step
CS79|22a|position at the next step
CS79|23|angular velocity at the next half step
CS79|23a|rotation at the next step
CS79|24|velocity, with contact damping
CS79|25|angular velocity, with contact damping
CS79|26|normal dashpot
CS79|27|shear dashpot
CS79|28|coefficients of the dashpots, beta k
CS79|29|translation with mass-proportional damping
CS79|30|rotation with mass-proportional damping
CS79|31|velocity at a whole step
CS79|32|velocity at the next half step, with C
CS79|33|angular velocity at the next half step, with C*
CS79|34|C and C* in proportion to mass and inertia
CS79|35|velocity at the next half step, with alpha
CS79|36|angular velocity at the next half step, with alpha
R89|4.3|damped normal force, fraction of the critical step
R89|4.4|damped shear force, fraction of the critical step
R89|4.6|reduced mass
R89|3.12|radius of the contact circle, a^2 = R* alpha
R89|3.13|Hertz: N = (4/3) E* R*^(1/2) alpha^(3/2)
R89|3.15|stiffness dN/d(alpha) = 2 E* a
R89|3.24|radius of the stick region on loading
R89|3.25|tangential displacement, loading at constant N
R89|3.28|radius of the stick region on unloading
R89|3.40|tangential displacement, unloading at constant N
R89|3.50|tangential displacement, reloading at constant N
R89|3.56|contact radius after a change of N
R89|3.61|radius of the stick region of an increment
R89|3.64|tangential stiffness of an increment, with the new N
R89|3.65|tangential displacement at which a new ring slips
R89|3.68|loading with increasing N
R89|3.69|theta of loading
R89|3.70|loading, increment below the critical displacement
R89|3.76|theta of unloading
R89|3.82|theta of reloading
R89|3.94|tangential stiffness, all cases in one
R89|3.95|theta, loading
R89|3.96|theta, unloading
R89|3.97|theta, reloading
R89|3.98|theta where the new ring sticks
R89|4.5|effective radius R*
R89|4.7|effective Young's modulus E*
R89|4.8|effective shear modulus G*
R89|4.9|of the first particle
R89|4.10|of the second particle
R89|4.11|force increment at first touch
R89|4.12|force increment, dN = 2 E* a dn
R89|4.14|contact radius from the force
R89|4.15|increment of the tangential force
R89|4.16|critical displacement ds_c
R89|4.17|deficit DD
R89|4.18|deficit DD, decreasing N
R89|4.19|damped tangential force
R89|4.20|change of T* with N
R89|4.21|change of T** with N
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
R89|4.33|Rayleigh step
R89|4.34|linear fit of the root
R89|4.35|apparent stiffness of a particle
R89|4.36|displacement of a particle in a step
R89|4.37|critical step of a particle
R89|4.38|change of the force sum
R89|4.39|magnitude of the force sum
R89|4.40|FRACC, step over critical step
R89|5.5|N = K alpha^(3/2)
R89|5.6|equation of the normal impact
R89|5.9|largest overlap of a normal impact
R89|5.10|time against overlap
R89|5.11|duration of the contact
R89|5.12|duration of the contact, numerical
R89|5.13|traction by annuli
R89|5.14|chi
R89|5.15|psi, dimensionless angle of incidence
R89|5.16|angle of incidence
R89|3.23|shear force from the radius of the stick region, loading
R89|3.27|stiffness of a contact that sticks everywhere, 8 G* a
R89|3.35|shear force from the radii of slip, unloading
R89|3.71|when the new ring has slipped
R89|4.41|affine motion, an increment of position
R89|4.42|relative velocity at a contact
R89|4.43|affine motion, an increment of velocity, x
R89|4.44|affine motion, an increment of velocity, y
R89|4.45|fabric tensor
R89|4.46|contact density F_kk
R89|4.47|structural anisotropy, mean of n_i n_j
R89|4.48|structural anisotropy, a sum over contacts
R89|4.49|x component of the contact normal
R89|4.50|y component of the contact normal
R89|4.51|distance of the centres
R89|4.52|major principal value
R89|4.53|minor principal value
R89|4.54|direction of the major principal value
R89|5.1|approach velocity in a normal impact
R89|5.2|accelerations of the two spheres
R89|5.3|relative acceleration
R89|5.4|reduced mass of an impact
R89|5.7|energy of a normal impact
R89|5.8|speed before the impact
R89|4.13|damped normal force, damping ratio
WORDS
}

# One line for each tag: FILE [CS79 8-15]. The tags in law_batch.h are examples.
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

# One line for each item of a tag: PAPER|KIND|SORT KEY|NAME|FILE; KIND is 1 for equations, 2 for all others.
named() {
  awk '
    function key(text) { split(text, part, "."); return sprintf("%05d%05d%s", part[1], part[2], text ~ /a$/ ? "a" : "0") }
    function say(kind, sort, name) { print paper "|" kind "|" sort "|" name "|" file }
    function wrong(what) { print "equations.sh: " file ": " what " in " tag >"/dev/stderr"; bad = 1 }
    # The number of equations of a chapter of R89; CS79 has 36.
    function equations(chapter) { return chapter == 3 ? 98 : chapter == 4 ? 54 : chapter == 5 ? 16 : 0 }
    function check(text, part, n) {
      n = split(text, part, ".")
      if (paper == "R89" ? part[2] > equations(part[1]) : part[1] + 0 > 36 || part[1] + 0 < 1) wrong(paper " has no equation " text)
    }
    BEGIN { sections = "2.1 2.2 2.2.1 2.2.2 2.3 3.1 3.2 3.2.1 3.2.2 3.2.3 3.3 3.4 3.4.1 3.4.2 3.4.3 3.5 3.5.1 3.5.2 3.5.3 3.6 4.1 4.2 4.3 4.3.1 4.3.2 4.4 4.5 4.5.1 4.5.2 4.6 4.7 5.1 5.2 5.3 5.3.1 5.3.2 5.4 6.1 6.2 6.3 6.4 6.4.1 6.4.2 6.4.3 6.5 6.5.1 6.5.2" }
    function range(text, at, from, to, head) {
      at = index(text, "-")
      from = at ? substr(text, 1, at - 1) : text
      to = at ? substr(text, at + 1) : text
      head = ""
      check(from)
      check(to)
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
      else if (paper == "R89" && text ~ /^sec\. [0-9.]+(-[0-9.]+)?$/) {
        sub(/^sec\. /, "", text)
        count = split(text, ends, "-")
        for (i = 1; i <= count; i++) if (index(" " sections " ", " " ends[i] " ") == 0) wrong("R89 has no section " ends[i])
        say(2, "0" text, (count > 1 ? "sections " : "section ") text)
      }
      else if (text ~ /^[A-Z][A-Za-z -]*$/) say(2, "3" text, "*" text "*")
      else wrong("cannot read `" text "`")
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

# The table of one paper and kind. It has all equations of CS79, even if no file has them.
table() {
  { words | awk -F '|' -v paper="$1" -v kind="$2" '
      function key(text) { split(text, part, "."); return sprintf("%05d%05d%s", part[1], part[2], text ~ /a$/ ? "a" : "0") }
      $1 == paper && kind == 1 { print key($2) "|0|" $2 "|" $3 }'
    echo "$found" | awk -F '|' -v paper="$1" -v kind="$2" '$1 == paper && $2 == kind { print $3 "|1|" $4 "|" $5 }'
  } | sort -u | awk -F '|' -v paper="$1" -v kind="$2" '
    function flush() {
      if (name == "" || (paper == "R89" && files == "")) return # of R89 only equations that are used
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
# Equations and their source files

Made by `docs/equations.sh` from the tags in the sources. The symbols are those of the papers, see docs/METHOD.md. Paths begin at
the top of the source tree.

## CS79: Cundall and Strack (1979)

| equation | subject | files |
| --- | --- | --- |
HEAD
table CS79 1
printf '\n| also | files |\n| --- | --- |\n'
table CS79 2
cat <<'HEAD'

## R89: Randall (1989)

| equation | subject | files |
| --- | --- | --- |
HEAD
table R89 1
printf '\n| also | files |\n| --- | --- |\n'
table R89 2
