# Extracts commands and files from the fenced blocks of a Markdown file.
#
#   awk -f fences.awk FILE                 prints the commands, one per line, after their line number and a tab: lines of blocks
#                                          ```sh, and lines indented by four that call nineball or setup; and the lines of
#                                          blocks ```text output, after `>`
#   awk -v into=FOLDER -f fences.awk FILE  writes the files: blocks ```LANGUAGE NAME to FOLDER/NAME; prints the lines of blocks
#                                          ```LANGUAGE FILE LIST as `FILE LIST LINE`
#
# A fence can have more than three characters; the closing fence has as many.
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
inside && language == "text" && name == "output" && !into { print FNR "\t>" $0 }
!inside && /^    (nineball|build\/nineball|\.\/setup) / { command($0) }
