#!/bin/sh
# Renews the lists in cases/README.md and in the README.md of every chapter, between two marker lines: the chapters and their
# cases in reading order, and an index of the cases by word, law and quantity. Words come from docs/LANGUAGE.md, laws from src/laws.
# The rest of these files is written by hand.
#
#   docs/cases.sh            writes them in the tree
#   docs/cases.sh FOLDER     writes them to FOLDER/cases, for a comparison
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu
cd "$(dirname "$0")/.."
into=${1:-.}

# The pages of the lists PAGES and PAGES_LONG of build-aux/lists.mk, in their order.
pages=$(awk '
  ($1 == "PAGES" || $1 == "PAGES_LONG") && $2 == "=" { inside = 1; $1 = $2 = "" }
  inside { more = sub(/\\$/, ""); for (i = 1; i <= NF; i++) if ($i != "") print $i; inside = more }' build-aux/lists.mk)

# The cases of a chapter, in the order of the lists.
cases_of() {
  for page in $pages; do
    case $page in "$1"/*) echo "$page" ;; esac
  done
}

# The table of the cases of a chapter.
chapter_list() {
  printf '\n| case | subject | source |\n| --- | --- | --- |\n'
  for page in $(cases_of "$1"); do
    awk -v file="${page##*/}" '
      /^# / && title == "" { title = substr($0, 3); next }
      /^\[/ && title != "" && source == "" { source = $0; sub(/^\[/, "", source); sub(/\]$/, "", source) }
      /^```/ { exit }
      END { name = file; sub(/\.md$/, "", name); printf "| [%s](%s) | %s | %s |\n", name, file, title, source }' "$page"
  done
  echo
}

# The chapters: title and first paragraph of their README.md, and their cases.
chapters() {
  printf '\n## Chapters\n\n| chapter | cases |\n| --- | --- |\n'
  for chapter in cases/[1-9]-*; do
    name=${chapter#cases/}
    title=$(sed -n '1s/^# //p' "$chapter/README.md")
    about=$(awk 'NR > 2 && !NF { exit } NR > 2 { printf "%s%s", separator, $0; separator = " " }' "$chapter/README.md")
    links=
    for page in $(cases_of "$chapter"); do
      case=${page##*/}
      links="$links${links:+, }[${case%.md}]($name/$case)"
    done
    echo "| [${name%%-*}. $title]($name/README.md): $about | $links |"
  done
}

# Features and the cases that use them.
features() {
  cat <<'TEXT'

## Features and the cases that use them

These tables give the cases that use each word of the language and each law, or the number of these cases if there are more than a dozen. The last table gives the cases with an expectation that begins with the quantity. A case that starts from another case is not listed for the words of that case. Words without a case are covered by other tests.
TEXT
awk '
  # ---- rows: words from docs/LANGUAGE.md, laws from their files, others from the lists below ----
  function row(part, name) { if (!((part, name) in is_row)) { is_row[part, name] = 1; parts[++n] = part; names[n] = name } }
  function word_rows(  line, part, word, of) {
    while ((getline line < "docs/LANGUAGE.md") > 0) {
      if (line ~ /^## /) part = substr(line, 4)
      if (line ~ /^### /) {
        word = substr(line, 5)
        row(part, word)
        if (part != "Expectations") known[word] = 1
      }
      if (line ~ /Place: the scene;(.*;)? a stage[;.]/ && word != "stage") row("In a stage", word)
      if (part == "Quantities" && line ~ /^Of .*:$/) of = substr(line, 4, length(line) - 4)
      if (part == "Quantities" && of != "" && line ~ /^- `/) {
        word = substr(line, 4, index(substr(line, 4), "`") - 1)
        sub(/\..*/, "", word)
        row(checked, of ": " word)
        if (of !~ /particle|wall|pair|region|grading|contact test/ || of == "a box of walls") alone[word] = of
      }
    }
  }
  function law_rows(  i, law) {
    for (i = 1; i <= law_count; i++) {
      law = laws[i]
      sub(/.*\//, "", law); sub(/\.c$/, "", law); sub(/_/, " ", law)
      row("Laws", law)
    }
  }
  function kinds(part, verb, list,  i, m, all) {
    m = split(list, all, " ")
    for (i = 1; i <= m; i++) row(part, verb " … " all[i])
  }
  # ---- the words of a page ----
  function use(part, name) { if (!((part, name, page) in has)) { has[part, name, page] = 1; pages[part, name] = pages[part, name] " " page; count[part, name]++ } }
  # The longest word of the language that the line begins with.
  function statement_of(text,  m, all, k, try, best) {
    m = split(text, all, /[ \t]+/)
    for (k = 1; k <= m && k <= 3; k++) {
      try = try (k > 1 ? " " : "") all[k]
      if (try in known) best = try
    }
    return best
  }
  function contains(text, word) { return index(" " text " ", " " word " ") > 0 }
  function kind_of(text) {
    if (text ~ /^region /) return "a region"
    if (text ~ / grading /) return "a grading"
    if (text ~ / with /) return "a contact"
    return text ~ /^monitor +[^ ]+ +wall / ? "a wall" : "a particle"
  }
  function scene_line(text, place,  verb, i, m, all) {
    if (text ~ /^ramp /) { use("In a stage", "ramp"); sub(/^ramp +/, "", text) }
    verb = statement_of(text)
    if (verb == "") return
    use(place, verb)
    split(text, all, /[ \t]+/)
    if (verb == "monitor" || verb == "region") kind[all[2]] = kind_of(text)
    if (verb == "sweep" || verb == "let") swept = swept " " text
    if (verb == "normal" || verb == "shear") {
      m = split(text, all, /[ \t]+/)
      if (all[2] !~ /^\$/) use("Laws", verb " " all[2])
      else chosen[verb] = 1
    }
    for (i = 1; i <= n; i++)
      if (names[i] ~ / … / && parts[i] == "Clauses" && substr(names[i], 1, index(names[i], " …") - 1) == statement_kind(verb) && contains(text, substr(names[i], index(names[i], "… ") + 4)))
        use(parts[i], names[i])
  }
  function statement_kind(verb) { return verb ~ /^servo / ? "servo" : verb }
  function expect_line(text, path,  i, all, word, of) {
    for (i = 1; i <= n; i++)
      if (parts[i] == "Expectations" && contains(text, names[i])) use(parts[i], names[i])
    if (text ~ /^reference /) return
    split(text, all, /[ \t]+/)
    word = all[1]
    of = index(word, ".") ? kind[substr(word, 1, index(word, ".") - 1)] : ""
    if (of != "") sub(/^[^.]*\./, "", word)
    sub(/\..*/, "", word)
    if (path) of = "a contact test"
    if (of == "") of = alone[word]
    use(checked, of ": " word)
  }
  function read_page(file,  line, block, place, path, i) {
    page = file; sub(/.*\//, "", page); sub(/\.md$/, "", page); path_of[page] = substr(file, 7)
    swept = ""; delete chosen; delete kind; path = 0; place = "The scene"; block = ""
    while ((getline line < file) > 0) {
      if (line ~ /^```/) { block = block == "" ? substr(line, 4) : ""; continue }
      sub(/#.*/, "", line); gsub(/^[ \t]+|[ \t\r]+$/, "", line)
      if (line == "") continue
      if (block == "contact-test") path = 1
      if (block == "contact-test" && line ~ /^(contact|segment|repeat) /) place = "Contact test"
      if (block == "scene" || block == "contact-test") scene_line(line, line ~ /^stage / ? "The scene" : place)
      if (block == "scene" && line ~ /^stage /) place = "In a stage"
      if (block == "expect") expect_line(line, path)
    }
    close(file)
    for (i = 1; i <= n; i++) # laws named by a sweep
      if (parts[i] == "Laws" && (substr(names[i], 1, index(names[i], " ") - 1) in chosen) && contains(swept, substr(names[i], index(names[i], " ") + 1)))
        use("Laws", names[i])
  }
  function links(list,  m, all, k, text) {
    m = split(list, all, " ")
    for (k = 1; k <= m; k++) text = text (k > 1 ? ", " : "") "[" all[k] "](" path_of[all[k]] ")"
    return text
  }
  BEGIN {
    while ((("ls src/laws/normal_*.c src/laws/shear_*.c") | getline line) > 0) laws[++law_count] = line
    checked = "Quantities in expectations"
    word_rows()
    law_rows()
    kinds("Clauses", "damping", "stiffness r89-fraction ratio walls critical mass con1")
    kinds("Clauses", "step", "per stable single-contact collision rayleigh rayleigh-mean rayleigh-fit rayleigh-fit-mean")
    kinds("Clauses", "region", "circle box inside all rings from")
    kinds("Clauses", "servo", "boundary cell box affine")
    kinds("Clauses", "snapshot", "from")
    kinds("Clauses", "units", "none")
    row("Expectations", "over"); row("Expectations", "of peak")
    for (k = 1; k < ARGC; k++) read_page(ARGV[k])
    split("The scene|In a stage|Contact test|Laws|Clauses|Expectations|" checked, order, "|")
    for (p = 1; p <= 7; p++) {
      printf "\n### %s\n\n| feature | cases |\n| --- | --- |\n", order[p]
      for (i = 1; i <= n; i++) {
        if (parts[i] != order[p]) continue
        c = count[parts[i], names[i]] + 0
        printf "| %s | %s |\n", names[i] ~ /: / ? names[i] : "`" names[i] "`", (c == 0 ? "none" : c > 12 ? c " cases" : links(pages[parts[i], names[i]]))
      }
    }
    exit
  }' $pages

}

# renew README COMMAND...: puts the output of the command between the two marker lines of the file.
renew() {
  readme=$1
  shift
  "$@" >"$work/list"
  awk -v list="$work/list" '
    /^<!-- to here -->$/ { inside = 0 }
    !inside { print }
    /^<!-- made by docs\/cases.sh, from here -->$/ { inside = found = 1; while ((getline line < list) > 0) print line }
    END { exit !found || inside }' "$readme" >"$work/README.md" || {
    echo "$readme lacks a marker line for the beginning or the end of its list" >&2
    exit 1
  }
  mkdir -p "$into/${readme%/*}"
  test -f "$into/$readme" && cmp -s "$work/README.md" "$into/$readme" || cp "$work/README.md" "$into/$readme"
}
all_lists() { chapters && features && echo; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
renew cases/README.md all_lists
for chapter in cases/[1-9]-*; do
  renew "$chapter/README.md" chapter_list "$chapter"
done
