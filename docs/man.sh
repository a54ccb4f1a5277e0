#!/bin/sh
# Prints the manual page nineball(1) in man(7): the text below, commands and options from the program's --help, and
# docs/LANGUAGE.md.
#
#   docs/man.sh PROGRAM
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu

# The lines of --help that begin with $1: "  run PAGE…    run pages, …" as "- `run PAGE…`: run pages, …".
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
- `2`: bad use, an invalid page, a figure that cannot be drawn, or a file that cannot be read or written
- `3`: run aborted: NaN, an unstable step, or a stage that never ended. The results up to then are written and marked as incomplete
- `4`: out of memory
- `130`, `143`: a run with --checkpoint was stopped by SIGINT or SIGTERM; the command to continue is on standard error

## Pages from others

A page's `gnuplot` block is a program. `figure` and `report` run it confined, by Landlock or by bubblewrap: it can read fonts, libraries and the installed recipes only, and write the figure only. It has no shell. Under Landlock it can start no other program; under bubblewrap it can start only programs in the folders of libraries. If neither is available, no figure is drawn unless `--trust` is given. Besides this, a page can only name files to be read (`packing`, `start`, `follow`).

## Environment

- `NINEBALL_STATES`: the folder of states, unless --states is given
- `NINEBALL_WAIT`: how long to wait for the lock of a state, in seconds; default 3600
- `NINEBALL_CONFINE`: how to confine gnuplot: landlock, bwrap or none (needs --trust); default: the first of landlock and bwrap that is available

## Files

- `NAME.out/table.tsv`: the recorded quantities, one row per cycle; numbers as %.17g, which restores the same bits
- `NAME.out/values.tsv`: every measure of the expect blocks, computed and reference, one row per run
- `NAME.out/verdict.tsv`: every expectation with its verdict
- `NAME.out/STAGE-particles.tsv, -walls.tsv, -contacts.tsv`: the tables of `snapshot`
- `states/NAME-KEY.checkpoint`: a run that has not ended, for --resume; KEY belongs to settings and sweep. The one before it ends in `.old`
- `NAME.out/NAME.gp, NAME.svg, NAME.png`: the figure, and the script that drew it

TEXT
  sed -n '/^## /,$p' "$top/docs/LANGUAGE.md"
  cat <<'TEXT'
## See also

`gnuplot`(1). docs/TUTORIAL.md: the first half hour. docs/METHOD.md: the method. docs/GLOSSARY.md: the terms. docs/LANGUAGE.md: the words of pages.

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
# Converts the Markdown of the text above and of LANGUAGE.md: headings, paragraphs, `code`, lists of `NAME`: TEXT, fenced blocks.
# A heading ### begins a statement: its syntax, one paragraph, and its clauses.
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
