#!/bin/sh
# The manual page, nineball(1), on standard output, in man(7): what stands below, commands and options as the program's --help has
# them, and docs/LANGUAGE.md.
#
#   docs/man.sh PROGRAM
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu

# The lines of --help that begin so: "  run PAGE…    run pages, …" as "- `run PAGE…`: run pages, …".
rows() { "$program" --help | sed -n "/^ *$1/s/^ *\(.*[^ ]\)   *\([^ ].*\)\$/- \`\1\`: \2/p"; }

page() {
  cat <<'TEXT'
## Description

`nineball` runs pages. A page is a Markdown file with a simulation (blocks `scene`), the expected results (blocks `expect`) and a figure (block `gnuplot`). The computed results are compared with a reference solution.

## Commands

TEXT
  rows '[a-z]'
  printf '\n## Options\n\n'
  rows -
  cat <<'TEXT'

## Exit status

- `0`: all checks passed
- `1`: a check failed
- `2`: bad use, a mistake in a page, a figure that cannot be drawn, or a file that cannot be read or written
- `3`: run aborted: NaN, an unstable step, a stage that never ended; results up to then are kept, and marked as incomplete
- `4`: out of memory

## Pages of others

A page's `gnuplot` block is a program. `figure` and `report` run it confined, by Landlock or by bubblewrap: it can read fonts, libraries and the installed recipes only, write nothing but the figure, and start no other program. Where neither is available nothing is drawn, unless `--trust` is given. All else that a page can do is to have files read that it names in `packing`, `start` and `follow`.

## Environment

- `NINEBALL_STATES`: the folder of states, unless --states says one
- `NINEBALL_WAIT`: how many seconds the lock of a state is waited for, 3600 where it is not set
- `NINEBALL_CONFINE`: landlock, bwrap or none: the only way in which gnuplot may be confined, instead of the first of the two that is available; without any, --trust must be given

## Files

- `NAME.out/table.tsv`: what the page records, a row a cycle; numbers as %.17g, which read back to the same bits
- `NAME.out/values.tsv`: every measure of the expect blocks, computed and reference, a row a run
- `NAME.out/verdict.tsv`: every expectation, and whether it passed
- `NAME.out/STAGE-particles.tsv, -walls.tsv, -contacts.tsv`: what `snapshot` keeps
- `NAME.out/NAME.gp, NAME.svg, NAME.png`: the figure, and the script that drew it

TEXT
  sed -n '/^## /,$p' "$top/docs/LANGUAGE.md"
  cat <<'TEXT'
## See also

`gnuplot`(1). The method: docs/METHOD.md; a first half hour: docs/TUTORIAL.md; this language as a page: docs/LANGUAGE.md.

## Copyright

Copyright (C) 2026 the nineball authors. GPL-3.0-or-later: free software, without any warranty.
TEXT
}

top=$(dirname "$0")/..
program=$1
cat <<'HEAD'
.\" Made by docs/man.sh
.TH NINEBALL 1 "" nineball "User Commands"
.SH NAME
nineball \- discs and spheres in the plane, by the distinct element method
.SH SYNOPSIS
.B nineball
\fICOMMAND\fR [\fIOPTION\fR ...] [\fIPAGE\fR ...]
.br
.B nineball \-\-help
[\fBscene\fR|\fIWORD\fR]
HEAD
# Of Markdown what stands above and in LANGUAGE.md: headings, paragraphs, `code`, lists of `NAME`: TEXT, fenced blocks. A
# heading ### begins a statement: its syntax, one paragraph, and what belongs to it.
page | awk '
  function roff(text) {
    gsub(/\\/, "\\e", text); gsub(/-/, "\\-", text); gsub(/…/, "...", text)
    while (!inside && match(text, /`[^`]*`/))
      text = substr(text, 1, RSTART - 1) "\\fB" substr(text, RSTART + 1, RLENGTH - 2) "\\fR" substr(text, RSTART + RLENGTH)
    return (text ~ /^[.\x27]/ ? "\\&" : "") text
  }
  function close_item() { if (part == "parts") print ".RE"; part = "" }
  /^```/ { inside = !inside; print inside ? ".PP\n.EX" : ".EE"; next }
  inside { print roff($0); next }
  $0 == "" { next }
  /^## / { close_item(); print ".SH " toupper(substr($0, 4)); next }
  /^### / { close_item(); part = "syntax"; next }
  /^- `/ { print ".TP\n" roff(substr($0, 3, index(substr($0, 4), "`") + 1))
           text = substr($0, index(substr($0, 4), "`") + 4); sub(/^(, |: )/, "", text); print roff(text); next }
  part == "syntax" { print ".TP\n" roff($0); part = "help"; next }
  part == "help" { print roff($0) "\n.RS"; part = "parts"; next }
  { print ".PP\n" roff($0) }
  END { close_item() }'
