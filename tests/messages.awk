# Prints the messages in a C file: the string constants, adjacent ones joined, of statements that call one of the
# functions below, or that contain the word in the variable `speaks`. Each message is one line: LINE TAB TEXT. Escapes
# that are visible in a message are undone.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
function statement_ends() {
  if (calls && count)
    for (k = 1; k <= count; k++) print line[k] "\t" text[k]
  calls = count = 0
  joining = 0
}
BEGIN {
  if (!speaks) speaks = "(nb_mistake|nb_token_mistake|nb_line_mistake|nb_expected|nb_unknown_name|number_mistake|nb_scene_mistake|report_law|say|nb_take_token|nb_take_name|snprintf[(](hint|what))[(,]|(report)[(]"
}
/^#/ { next } # an #include is no message
{
  rest = $0
  while (rest != "") {
    if (in_comment) {
      if (!(at = index(rest, "*/"))) break
      rest = substr(rest, at + 2)
      in_comment = 0
    } else if (match(rest, /^"([^"\\]|\\.)*"/)) {
      piece = substr(rest, 2, RLENGTH - 2)
      gsub(/\\"/, "\"", piece)
      if (joining) text[count] = text[count] piece
      else { text[++count] = piece; line[count] = FNR }
      joining = 1
      rest = substr(rest, RLENGTH + 1)
    } else if (substr(rest, 1, 2) == "/*") {
      in_comment = 1
      rest = substr(rest, 3)
    } else if (match(rest, /^'([^'\\]|\\.)*'/)) {
      joining = 0
      rest = substr(rest, RLENGTH + 1)
    } else if (match(rest, /^[A-Za-z_0-9]+/)) {
      word = substr(rest, 1, RLENGTH)
      after = substr(rest, RLENGTH + 1)
      if ((word after) ~ "^" speaks) calls = 1
      joining = 0
      rest = after
    } else {
      c = substr(rest, 1, 1)
      if (c ~ /[;{}]/) statement_ends()
      else if (c !~ /[ \t]/) joining = 0
      rest = substr(rest, 2)
    }
  }
}
