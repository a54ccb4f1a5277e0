# Lists sentences of more than 35 words in documents: FILE:LINE, the number of words, and the beginning of the sentence. Blocks of
# code, tables, headings and indented commands are not sentences; a formula, a piece of code and a link count as one word each.
#
#   awk -f .ci/sentences.awk EXCEPTIONS FILE...
#
# A line of EXCEPTIONS is FILE, a tab, the beginning of the sentence, a tab, and the reason.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

function words_in(sentence, n, words, k, count) {
  n = split(sentence, words, /[ \t]+/)
  for (k = 1; k <= n; k++) if (words[k] ~ /[A-Za-z0-9]/) count++
  return count
}
# The paragraph so far ends: each of its sentences is counted.
function flush(  text, at, sentence, count, start) {
  text = clean(paragraph) " "
  while (text != "") {
    at = match(text, /[.!?]["”)*]*[ ]+/)
    sentence = at ? substr(text, 1, at + RLENGTH - 1) : text
    text = at ? substr(text, at + RLENGTH) : ""
    # an abbreviation or an initial does not end a sentence, nor does a full stop before a small letter
    if (at && (sentence ~ /(^|[.,*:(] |and |by )[A-Z]\.[ ]+$/ || sentence ~ /(^| )(e\.g|i\.e|cf|Fig|Figs|eq|eqs|No|Vol|pp?|sec|al|vs|etc)\.["”)*]*[ ]+$/ || text ~ /^[a-z]/)) {
      held = held sentence
      continue
    }
    sentence = held sentence
    held = ""
    count = words_in(sentence)
    if (count > 35) {
      start = substr(sentence, 1, 60)
      for (key in except) if (index(key, FILE_ SUBSEP) == 1 && index(sentence, substr(key, length(FILE_) + 2)) == 1) { used[key] = 1; start = "" }
      if (start != "") print FILE_ ":" first ": " count " words: " start "..."
    }
  }
  paragraph = held = ""
}
function clean(line) {
  gsub(/\$\$[^$]*\$\$/, "Formula", line)
  gsub(/`[^`]*`/, "Code", line)
  gsub(/\$[^$]+\$/, "Formula", line)
  gsub(/!\[[^]]*\]\([^)]*\)/, "", line)
  while (match(line, /\]\([^)]*\)/)) line = substr(line, 1, RSTART - 1) substr(line, RSTART + RLENGTH)
  gsub(/\[/, "", line)
  return line
}
FNR == 1 { if (NR != 1) flush(); fence = display = 0 }
NR == FNR { if ($0 !~ /^#/ && $0 != "") { split($0, part, "\t"); except[part[1], part[2]] = 1 } next }
{ FILE_ = FILENAME }
# A block of code ends with as many signs as it begins with, or more; it may hold shorter ones.
match($0, /^ *(```+|~~~+)/) {
  flush()
  if (!fence) fence = RLENGTH
  else if (RLENGTH >= fence && $0 ~ /^ *[`~]+ *$/) fence = 0
  next
}
fence { next }
/^\$\$/ && !/^\$\$.*\$\$/ { display = !display; if (!display && /\.\$\$$|\. *\$\$$/) paragraph = paragraph "."; next }
display { if (/\$\$ *$/) display = 0; next }
/^ *$/ || /^#/ || /^\|/ || /^<!--/ || /^\[[^]]*\]$/ { if (/^ *$/ || !/^\$\$/) flush(); next }
/^    / && paragraph == "" { next }
/^ *([-*]|[0-9]+\.) / { flush() }
{ if (paragraph == "") first = FNR; paragraph = paragraph " " $0; sub(/^ /, "", paragraph)
  # a piece of code, a formula or a link may span two lines, so they are replaced when the paragraph is complete
}
END { flush(); for (key in except) if (!(key in used)) { split(key, part, SUBSEP); print ".ci/sentences: no sentence of more than 35 words in " part[1] " begins with: " part[2] } }
