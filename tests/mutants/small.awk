# Prints small changes to the arithmetic of a C file, one per line: LINE, COLUMN, LENGTH and the new text, separated by tabs.
# Changes are made only inside functions, and not in indices and counts: `[...]`, headers of `for`, `case`, `sizeof`, and
# statements with size_t.
#
#   a + b       a - b, and the other way; the same with += and -=, * and /, *= and /=, && and ||
#   -a, !a      a
#   a < b       a > b, and the other way; <= becomes >, >= becomes <, == becomes !=, != becomes ==
#   a number    a thousandth more; 0 becomes 1
#   a term      a thousandth more, if the term follows = return + - += -= ? : or an opening bracket or comma of arguments. If
#               the result does not compile (a pointer, a structure), it is not a mutant.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

function mutant(at, length_, text) { print NR "\t" at "\t" length_ "\t" text }

# True if this operator is binary.
function between() {
  if (last == ")" || last == "]" || last ~ /^[0-9.]/) return 1
  return last ~ /^[A-Za-z_]/ && last !~ /^(return|case|sizeof|const|double|int|void|char|bool|long|unsigned|size_t|nb_both)$/ && before != "struct"
}

# Adds a mutant if the term that begins here can be made larger by a thousandth.
function term(at, rest) {
  if (counting || rest !~ /^ *[A-Za-z_(]/ || rest ~ /^ *\((struct|size_t|void|const|double|int)/) return
  if (last ~ /^(isfinite|isnan|out)$/ || rest ~ /^ *[a-z]+->(a|b)[^a-z_[]/ || it == "return" && whole_answer) return # no integers
  if (rest ~ /^ *[a-z_]+ (\|\||&&)/) return # no logical values
  if (rest ~ /^[^;,?]*[<>=!]=? 0([^.0-9]|$)/ && rest !~ /^[^;,?]*([+]|-[^>])/) return # a term compared with 0: only its sign matters
  if (rest ~ /^ *(struct|sizeof|true|false|NULL|NB_[A-Z_0-9]*|[A-Z_0-9]+)([^a-z_A-Z]|$)/) return
  if (rest ~ /^ *(i|j|k|c|n|w|p|s|from|to|slot|part|parts|count|first|middle|end|out|wall|model|block|contact_forces|particles|error|scene|options|back)( *[-+,;)]|$)/ && rest !~ /^ *[a-z]+->/) return
  mutant(at, 0, rest ~ /^ / ? " 1.001 *" : "1.001 * ")
}

function token(at, it, rest) {
  if (it == "for") heads = 1
  if (it == "(") { round++; if (heads == 1) { heads = 2; head = round } }
  if (it == ")") { if (heads == 2 && round == head) heads = 0; round-- }
  if (it == "[") square++
  if (it == "]") square--
  if (it ~ /^(size_t|case|sizeof|enum)$/) index_ = 1
  if (!assigned && (it ~ /^(int|bool|char|unsigned|long)$/ || it == "*" && !between())) whole = 1
  counting = index_ || whole || square || heads == 2
  if (!(index_ || square || heads == 2)) {
    if (it ~ /^[0-9.]+([eE][-+]?[0-9]+)?$/ && it != ".") mutant(at, length(it), it + 0 == 0 ? "1" : last == "-" && negative ? "2" : "(" it " * 1.001)")
    else if (it == "+" && between()) mutant(at, 1, "-")
    else if (it == "-") mutant(at, 1, "+")
    else if (it == "*" && between()) mutant(at, 1, "/")
    else if (it == "/") mutant(at, 1, "*")
    else if (it in swap) mutant(at, length(it), swap[it])
    else if (it == "!") mutant(at, 1, " ")
  }
  if (it == "?") asked++
  if (it ~ /^[-+]$/ && between() || it ~ /^([-+]=|[?])$/ || it == ":" && asked ||
      (it ~ /^(=|return)$/ && rest !~ /^[^;,]*[?]/ && !pointed) || (it == "(" && last ~ /^[a-z_]+$/ && last !~ /^(if|while|for|switch|return|sizeof)$/) ||
      (it == "," && round + curly > 1) || (it == "{" && last == ")" && depth > 1))
    term(at + length(it), rest)
  if (it == ":" && asked) asked--
  if (it == "=") assigned = 1
  if (it ~ /^[;{}]$/ || it == ":" && last ~ /^[A-Z_0-9]+$/) { index_ = whole = assigned = pointed = asked = 0 }
  if (it == "struct" && !assigned) pointed = 1 # not for a whole structure
  negative = it == "-" && !between()
  before = last
  last = it
}

BEGIN {
  n = split("+= -= -= += *= /= /= *= < > > < <= > >= < == != != == && || || &&", pairs, " ")
  for (i = 1; i < n; i += 2) swap[pairs[i]] = pairs[i + 1]
}

{
  rest = $0
  at = 1
  if (continued || (!comment && rest ~ /^ *#/)) { # of the preprocessor
    continued = rest ~ /\\$/
    next
  }
  while (rest != "") {
    if (comment) {
      if (!match(rest, /\*\//)) break
      size = RSTART + 1
      comment = 0
    } else if (match(rest, /^[ \t]+/)) size = RLENGTH
    else if (rest ~ /^\/\*/) { comment = 1; size = 2 }
    else if (rest ~ /^\/\//) break
    else {
      if (!match(rest, /^"([^"\\]|\\.)*"/) && !match(rest, /^'([^'\\]|\\.)*'/) && !match(rest, /^[A-Za-z_][A-Za-z_0-9]*/) &&
          !match(rest, /^([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?/) &&
          !match(rest, /^(->|\+\+|--|\+=|-=|\*=|\/=|==|!=|<=|>=|&&|\|\||<<|>>)/))
        RLENGTH = 1
      size = RLENGTH
      it = substr(rest, 1, size)
      if (depth == 0) head_of = it ~ /^[;}]$/ ? "" : head_of " " it
      if (it == "{") { if (depth == 0) { inside = last == ")"; whole_answer = head_of ~ /^ (static |inline |NB_[A-Z_0-9]+ )*(int|bool|size_t|long|unsigned|enum) / } depth++ }
      if (it == "}") { depth--; if (depth == 0) { inside = 0; head_of = "" } }
      if (inside) token(at, it, substr(rest, size + 1))
      else { before = last; last = it }
    }
    at += size
    rest = substr(rest, size + 1)
  }
}
