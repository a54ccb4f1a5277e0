# What the fenced blocks of a Markdown file hold for tests: commands and files.
#
#   awk -f fences.awk FILE                 the commands, one a line, each behind its line number and a tab: lines of blocks
#                                          that begin with ```sh, and lines indented by four that call nineball or setup
#   awk -v into=FOLDER -f fences.awk FILE  writes the files: blocks that begin with ```LANGUAGE NAME go to FOLDER/NAME;
#                                          says what goes into a list of one of them, ```LANGUAGE FILE LIST: `FILE LIST LINE`, one a line
#
# A fence may be longer than three, and is closed by one that is as long.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

function command(text) {
  sub(/^ +/, "", text)
  if (text == "" || text ~ /^#/) return
  if (!into) print (started ? started : FNR) "\t" before text
  before = ""
  started = 0
}

/^(```+)[^`]*$/ {
  match($0, /^`+/)
  if (!inside) {
    inside = RLENGTH
    language = substr($1, RLENGTH + 1)
    name = $2
    list = $3
    if (into && name != "" && list == "") printf "" >(into "/" name)
    next
  }
  if (RLENGTH >= inside && NF == 1 && length($1) == RLENGTH) {
    inside = 0
    if (into && name != "" && list == "") close(into "/" name)
    next
  }
}

inside && into && name != "" && list == "" { print >(into "/" name) }
inside && into && list != "" { print name, list, $0 }
inside && language == "sh" && /\\$/ {
  if (!started) started = FNR
  sub(/\\$/, "")
  sub(/^ +/, "")
  before = before $0
  next
}
inside && language == "sh" { command($0) }
!inside && /^    (nineball|build\/nineball|\.\/setup) / { command($0) }
