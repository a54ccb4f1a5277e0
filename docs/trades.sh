#!/bin/sh
# Asks `nineball advise` for the cheapest setting within 10 %, 1 % and 0.1 % on every case of at most 50 particles, and writes
# docs/TRADES.md with the figures docs/trades/*.svg. Every number of that document comes from here.
#
#   docs/trades.sh -o FOLDER [PAGE…]    writes FOLDER/TRADES.md and FOLDER/trades; without pages: the list PAGES and the named cases
#
#   NINEBALL   the program                    BUDGET   seconds for each search, 60
#   RESULTS    folder of the results of the searches; a second call with the same program continues there. Default: a temporary one
#   ASSEMBLIES seconds for each search on an assembly; 0, the default: none
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu
LC_ALL=C
export LC_ALL
folder=
if [ "${1:-}" = -o ] && [ $# -ge 2 ]; then
  mkdir -p "$2"
  folder=$(cd "$2" && pwd)
  shift 2
fi
test "$folder" || {
  echo 'usage: trades.sh -o FOLDER [PAGE…]' >&2
  exit 2
}
nineball=$(cd "$(dirname "${NINEBALL:-./nineball}")" && pwd)/$(basename "${NINEBALL:-./nineball}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
results=${RESULTS:-$work/results}
mkdir -p "$results" "$folder/trades"
results=$(cd "$results" && pwd)
NINEBALL_STATES=${NINEBALL_STATES:-$results/states} # of pages that start from another one
export NINEBALL_STATES
cd "$(dirname "$0")/.."
budget=${BUDGET:-60} assemblies=${ASSEMBLIES:-0}
cksum <"$nineball" >"$work/program"
cmp -s "$work/program" "$results/program" || rm -rf "$results"/*
cp "$work/program" "$results/program"

# The named cases: NAME | title | quantity of the figure | its tolerances, the last one that of the figure | further quantities. An assembly has
# its settings in the sixth field.
named() {
  cat <<'NAMED'
two-wall-compression | Two-wall compression | B.normal at 6 cycles | 10 %; 1 %; 0.1 % | X.vx.half at 6 cycles |
mindlin-loops | Quasi-static Mindlin loops | work.shear in reload | 10 %; 1 %; 0.1 % | work.shear in back |
hertz-impact | Hertz normal impact | impact.duration | 10 %; 1 %; 0.1 % | C.normal max in strike; impact.restitution |
oblique-impact | Maw's oblique impact | impact.psi2 | 0.1; 0.01; 0.001 | impact.restitution; impact.duration |
restitution-angle | Restitution against angle | impact.restitution | 10 %; 1 %; 0.1 % | |
isotropic-compression | Isotropic compression | A.coordination.mechanical in friction | 1 % | | which=uniform
constant-volume-shear | Constant-volume shear | A.stress.sinphi in shear | 10 % | | which=uniform
NAMED
}

# What to see in the section of a named case. Numbers are added to it below.
seen() {
  case $1 in
  two-wall-compression)
    echo 'The walls move with a constant speed, and the springs are linear. The error of the force is of second order: twice the updates
leave a quarter of it. The velocity `X.vx.half` is that of half a step before, so its error is of first order and costs much more.' ;;
  mindlin-loops)
    echo 'The exact law gives the same force with any number of steps. Only the work has an error, because it is the sum of mean force times slip, so
each curve is replaced by straight pieces. That error is of second order.' ;;
  hertz-impact)
    echo 'The force and its derivative vanish at both ends of the contact. So neither the first touch within a step nor the end of the contact costs
first order, and the figure shows second order.' ;;
  oblique-impact)
    echo 'The tangential velocity `impact.psi2` follows from the history of micro-slip. No other law has the same limit within these tolerances over
the whole sweep, so the figure has one curve. Restitution and duration depend less on the shear force.' ;;
  restitution-angle)
    echo 'Restitution compares speeds, and the shear force changes only a part of them. Within 1 % a law without micro-slip is enough at every angle,
but not within 0.1 %.' ;;
  *)
    echo 'The motion of an assembly is chaotic, so only a mean over realizations has a limit. One search runs eight realizations with several steps.' ;;
  esac
}
field() { echo "$1" | cut -d '|' -f "$2" | sed 's/^ *//; s/ *$//'; }

if [ $# -eq 0 ]; then
  set -- $(awk '
    $1 == "PAGES" && $2 == "=" { inside = 1; $1 = $2 = "" }
    inside { more = sub(/\\$/, ""); for (i = 1; i <= NF; i++) if ($i != "") print $i; inside = more }' build-aux/lists.mk) \
    $(for name in isotropic-compression constant-volume-shear; do ls cases/*/$name.md; done)
fi

# ---- the searches ----

# Single values of the expect blocks, at most three of different quantities: KIND | MEASURE | ABSOLUTE TOLERANCE or nothing. The kind
# says what the error depends on: an impact quantity, an extreme value, or the end of the stage.
quantities() {
  awk '
    /^```/ { block = block == "" ? substr($0, 4) : ""; if (block == "contact-test") test = 1; next }
    { sub(/[ \t]#.*/, "") }
    block ~ /^scene/ && $1 == "stage" { last = $2; ends[last] = "count" }
    block ~ /^scene/ && $1 == "until" { ends[last] = "until" }
    block == "expect" { line[++lines] = $0 }
    END {
      for (k = 1; k <= lines && n < 3; k++) {
        text = line[k]
        if (text ~ /^ *(reference|report) / || text ~ / versus / || text ~ /residual/ || text ~ /^time / || text ~ /^step/) continue
        if (!match(text, / +(within|expected|below|above|increases|decreases|constant|order) /)) continue
        measure = substr(text, 1, RSTART - 1)
        sub(/^ +/, "", measure); gsub(/ +/, " ", measure)
        if (measure == "" || measure ~ /\$/) continue
        split(measure, word, " ")
        name = word[1]; sub(/^[^.]*\./, "", name)
        way = measure ~ / (max|min|amplitude)/ ? "extreme" : measure ~ / (mean|frequency)/ ? "mean" : measure ~ / at / ? "time" : "end"
        if ((name, way) in taken) continue
        taken[name, way] = 1
        stage = last
        if (match(measure, / in [^ ]+$/)) stage = substr(measure, RSTART + 4)
        if (stage == "all") stage = last
        kind = test ? "contact test" : measure ~ /^impact\./ ? "impact" : way != "end" ? way : ends[stage] == "until" ? "until" : "time"
        absolute = ""
        if (match(text, / within [-+.0-9e]+( [A-Za-z\/0-9.]+)?/)) {
          absolute = substr(text, RSTART + 8, RLENGTH - 8)
          rest = substr(text, RSTART + RLENGTH)
          if (absolute ~ / (of|ppm)$/ || rest ~ /^ *(%|of )/) absolute = ""
        }
        print kind "|" measure "|" absolute
        n++
      }
    }' "$1"
}

# advise PAGE ID TOLERANCE MEASURE CONDITION OVER BUDGET KIND: one search, unless it has been made; adds a line to the list. CONDITION has
# the settings, separated by ", "; OVER is the name of --over, or nothing.
advise() {
  page=$1 to=$results/$2 tolerance=$3 measure=$4 condition=$5 over=$6 seconds=$7 kind=$8
  if [ ! -f "$to/status" ]; then
    set --
    [ -z "$over" ] || set -- --over "$over"
    echo "$condition" | sed 's/, /\n/g' >"$work/settings"
    while read -r setting; do
      [ -z "$setting" ] || set -- "$@" --set "$setting"
    done <"$work/settings"
    mkdir -p "$to"
    status=0 programs=/nowhere # without gnuplot: drawing takes longer than most searches
    [ "$kind" != named ] || programs=$PATH
    PATH=$programs "$nineball" advise "$page" "$@" --quantity "$measure" --within "$tolerance" --budget "$seconds" --trust -o "$to" \
      >"$to/said" 2>&1 </dev/null || status=$?
    echo $status >"$to/status"
  fi
  printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$page" "${condition:--}" "$kind" "$measure" "$tolerance" "$to" "${over:--}" >>"$work/list"
  test -f "$to/advice.tsv" && grep -q "$(printf '\tchosen\t')" "$to/advice.tsv"
}

# search PAGE ID CONDITION KIND MEASURE ABSOLUTE: with all tolerances. If the value is 0 or not known to 10 %, the page's own tolerance
# counts, if it is absolute.
search() {
  if advise "$1" "$2.10" '10 %' "$5" "$3" '' "$budget" "$4"; then
    if advise "$1" "$2.1" '1 %' "$5" "$3" '' "$budget" "$4"; then advise "$1" "$2.01" '0.1 %' "$5" "$3" '' "$budget" "$4" || :; fi
  elif [ "${6%% *}" ] && [ "${6%% *}" != 0 ] && grep -q 'not known well enough' "$results/$2.10/said"; then
    sed '$d' "$work/list" >"$work/list-t" && mv "$work/list-t" "$work/list"
    advise "$1" "$2.own" "$6" "$5" "$3" '' "$budget" "$4" || :
  fi
}

given=" $* "
: >"$work/list"
for page; do
  name=$(basename "$page" .md)
  echo "$name" >&2
  plan=$results/$name.plan
  test -f "$plan" || { "$nineball" explain "$page" >"$work/plan" 2>/dev/null && mv "$work/plan" "$plan"; } || continue
  most=$(awk '/^  [0-9]+ particles,/ && $1 > most { most = $1 } END { print most + 0 }' "$plan")
  [ "$most" -le 50 ] || continue
  sed -n "s/^$name, run //p" "$plan" >"$work/runs"
  middle=$(sed -n "$((($(wc -l <"$work/runs") + 1) / 2))p" "$work/runs" 2>/dev/null || :)
  quantities "$page" >"$work/quantities"
  k=0
  while IFS='|' read -r kind measure absolute; do
    k=$((k + 1))
    case $measure in impact.psi1 | impact.angle) continue ;; esac # given by the page
    search "$page" "$name.$k" "$middle" "$kind" "$measure" "$absolute"
  done <"$work/quantities"
done

# The named cases among the pages: the whole sweep. Assemblies: means over realizations, with one tolerance.
named | while read -r line; do
  name=$(field "$line" 1)
  page=$(ls cases/*/"$name.md")
  settings=$(field "$line" 6)
  case $given in *" $page "*) ;; *) continue ;; esac
  { field "$line" 3 && field "$line" 5 | sed 's/; */\n/g'; } | sed '/^$/d' >"$work/quantities"
  k=0
  while read -r measure; do
    k=$((k + 1))
    field "$line" 4 | sed 's/; */\n/g' >"$work/tolerances"
    [ $k -eq 1 ] || printf '10 %%\n1 %%\n0.1 %%\n' >"$work/tolerances"
    j=0
    while read -r tolerance; do
      j=$((j + 1))
      if [ -z "$settings" ]; then
        advise "$page" "$name.all.$k.$j" "$tolerance" "$measure" '' '' "$budget" named || break
      elif [ "$assemblies" != 0 ]; then
        advise "$page" "$name.all.$k.$j" "$tolerance" "$measure" "$settings" seed "$assemblies" named || break
      fi
      [ $k -gt 1 ] || [ ! -s "$results/$name.all.$k.$j/advice.svg" ] || cp "$results/$name.all.$k.$j/advice.svg" "$folder/trades/$name.svg"
    done <"$work/tolerances"
  done <"$work/quantities"
done

# ---- one row for each search ----
#
# page, condition, kind, quantity, tolerance, result, setting, cost over that of the page, estimated error, its unit (% or 1), what the next
# cheaper setting is, its error over the tolerance, other laws (1: yes), shear law of the page, folder, over
rows() {
  awk -F '\t' '
    function settings(normal, shear, values, refine,  text) {
      if (normal != own_normal) text = text "normal=" normal " "
      if (shear != own_shear) text = text "shear=" shear " "
      if (values != "-") { gsub(/, /, " ", values); text = text values " " }
      return text "refine=" refine
    }
    function message(text) { # the first error, without the name of the page
      sub(/^.*error: /, "", text); sub(/^nineball: /, "", text); gsub(/[ \t]+/, " ", text)
      sub(/ +$/, "", text)
      return length(text) > 90 ? substr(text, 1, 90) "…" : text
    }
    {
      file = $6 "/advice.tsv"; n = chosen = 0; own = 0; text = ""
      while ((getline line < file) > 0) {
        if (line ~ /^# updates with the page/) { own = line; sub(/.*: /, "", own) }
        if (line ~ /^#/ || line ~ /^normal\t/) continue
        split(line, c, "\t")
        n++; normal[n] = c[1]; shear[n] = c[2]; refine[n] = c[3]; updates[n] = c[5]; ratio[n] = c[7]; claim[n] = c[8]; values[n] = c[12]
        if (c[10] == "chosen") chosen = n
      }
      close(file)
      own_normal = normal[1]; own_shear = shear[1]
      result = chosen ? "yes" : "no"
      reason = "-"; setting = cost = error = next_setting = next_ratio = "-"; other = 0
      if (!chosen) {
        while ((getline line < ($6 "/said")) > 0) text = text line " "
        close($6 "/said")
        reason = text ~ /--budget/ && text ~ /budget (was used|is too small)/ ? "the budget was used up" \
               : text ~ /not known well enough/ ? "the limit is not known well enough" \
               : text ~ /no setting that was tried/ ? "no setting that was tried is within the tolerance" : message(text)
        setting = reason
      } else {
        best = 0
        for (k = 1; k <= n; k++)
          if (updates[k] + 0 < updates[chosen] + 0 && (!best || updates[k] + 0 > updates[best] + 0 || (updates[k] == updates[best] && ratio[k] + 0 < ratio[best] + 0))) best = k
        setting = settings(normal[chosen], shear[chosen], values[chosen], refine[chosen])
        cost = own > 0 ? updates[chosen]/own : "-"
        error = claim[chosen]
        if (best) { next_setting = settings(normal[best], shear[best], values[best], refine[best]); next_ratio = ratio[best] }
        other = normal[chosen] != own_normal || shear[chosen] != own_shear
      }
      unit = $5 ~ /%/ ? "%" : $5 ~ / / ? substr($5, index($5, " ") + 1) : "1"
      print $1 "\t" $2 "\t" $3 "\t" $4 "\t" $5 "\t" result "\t" setting "\t" cost "\t" error "\t" unit "\t" next_setting "\t" next_ratio "\t" other "\t" own_shear "\t" $6 "\t" $7
    }' "$work/list"
}
rows >"$work/rows"

# ---- numbers for the prose ----

# The quantile ($2) of the numbers of standard input, as $1 prints it.
quantile() { sort -g | awk -v format="$1" -v q="$2" '{ v[NR] = $1 } END { if (NR == 0) print "–"; else printf format "\n", v[int(q*(NR - 1) + 1.5)] }'; }
# The rows of single conditions; those of them whose error depends on the setting, for the lessons; how many satisfy a condition of awk.
swept() { awk -F '\t' '$3 != "named"' "$work/rows"; }
lessons() { swept | awk -F '\t' '{ row[NR] = $0; key[NR] = $1 $4; if ($6 == "yes" && $9 < 1e-9) exact[$1 $4] = 1 } END { for (k = 1; k <= NR; k++) if (!(key[k] in exact)) print row[k] }'; }
count() { lessons | awk -F '\t' "$1"' { n++ } END { print n + 0 }'; }
share() { awk -v a="$1" -v b="$2" 'BEGIN { if (b > 0) printf "%d of %d (%.0f %%)\n", a, b, 100*a/b; else print "none" }'; }

# Cost at the tolerance $2 over that at the tolerance $1, of each quantity that has both.
cost_ratios() {
  lessons | awk -F '\t' -v a="$1" -v b="$2" '
    $6 == "yes" && $8 > 0 { if ($5 == a) first[$1, $4] = $8; if ($5 == b) second[$1, $4] = $8 }
    END { for (k in second) if (k in first) print second[k]/first[k] }'
}

# Those quotients that are not 1.
decided() { awk '$1 > 1.05 || $1 < 0.95'; }

# The order of each quantity: the slope of log(estimated error) against log(step) over the three finest steps with the page's own laws.
# KIND, order, page, quantity, and 1 if a velocity of half a step before or an increment enters the forces: dashpots, and laws that add
# increments of the force.
orders() {
  lessons | awk -F '\t' '
    $6 == "yes" { folder[$1 "\t" $4] = $15; kind[$1 "\t" $4] = $3 }
    END {
      for (key in folder) {
        n = 0; file = folder[key] "/advice.tsv"
        while ((getline line < file) > 0) {
          if (line ~ /^#/ || line ~ /^normal\t/) continue
          split(line, c, "\t")
          if (n == 0 && laws == "") laws = c[1] c[2] c[12]
          if (c[1] c[2] c[12] == laws && c[8] > 1e-9) { n++; refine[n] = c[3]; claim[n] = c[8] }
        }
        close(file)
        late = laws ~ /increment|randall/; laws = ""
        split(key, part, "\t")
        while ((getline line < part[1]) > 0) if (line ~ /^ *damping /) late = 1
        close(part[1])
        if (n >= 3) print kind[key] "\t" log(claim[n - 2]/claim[n])/log(refine[n]/refine[n - 2]) "\t" key "\t" late
      }
    }'
}

# Which other law would do, on the quantities of the pages with the exact law: LAW, TOLERANCE, 1 or 0, quantity, page. A law that gives another
# limit is left out of the search, and one whose settings all miss the tolerance does not do either. A law that gives the values of the
# page does.
other_laws() {
  lessons | awk -F '\t' '
    $6 == "yes" && $14 == "mindlin_deresiewicz" {
      file = $15 "/advice.tsv"; normal = ""; split("", fits)
      while ((getline line < file) > 0) {
        if (line ~ /^normal\t/) continue
        if (line !~ /^#/) {
          split(line, c, "\t")
          if (normal == "") normal = c[1]
          if (c[1] == normal && c[2] != $14 && c[12] == "-") fits[c[2]] = fits[c[2]] + (c[10] != "misses")
        } else if (line ~ /^# left out: .*(its value differs|same values as the page$)/) {
          law = line; sub(/^# left out: normal /, "", law); sub(/:.*/, "", law); split(law, part, ", shear ")
          if (part[1] == normal && part[2] !~ /,/) fits[part[2]] = line ~ /same values/
        }
      }
      close(file)
      for (law in fits) print law "\t" $5 "\t" (fits[law] > 0) "\t" $4 "\t" $1
    }'
}

# ---- the document ----

# Prints rows of the list of results as a table: page or not ($1: 1 or 0). Pages and quantities are not repeated.
table() {
  awk -F '\t' -v pages="$1" '
    function short(x) { return sprintf(x < 100 ? "%.2g" : "%.0f", x) }
    function code(text) { return text == "-" ? "–" : "`" text "`" }
    BEGIN {
      printf "|%s quantity | tolerance | setting | cost | estimated error | next cheaper setting: its error over the tolerance |\n", pages ? " case |" : ""
      printf "|%s --- | --- | --- | --- | --- | --- |\n", pages ? " --- |" : ""
    }
    function flush() {
      if (tolerances == "") return
      printf "|%s %s | %s | %s |\n", pages ? " " case_cell " |" : "", measure_cell, tolerances, rest
      tolerances = ""
    }
    {
      name = $1; sub(/.*\//, "", name); sub(/\.md$/, "", name)
      same = $1 == page && $4 == measure
      if (!same || $7 != last) {
        flush()
        condition = $2
        gsub(/(^|, )[A-Za-z_0-9]+=[0-9.]*[0-9][0-9][0-9][0-9][0-9][0-9][0-9][0-9][0-9][^,]*/, "", condition) # a computed value
        sub(/^, /, "", condition)
        case_cell = $1 == page ? "" : "[" name "](../" $1 ")" (condition == "-" || condition == "" ? "" : ", " condition)
        measure_cell = same ? "" : code($4)
      }
      last = $7; page = $1; measure = $4
      tolerances = tolerances (tolerances == "" ? "" : ", ") $5
      rest = $6 == "no" ? "no advice: " $7 " | | |" : code($7) " | " ($8 == "-" ? "–" : short($8)) " | " \
        short($10 == "%" ? 100*$9 : $9) ($10 == "1" ? "" : " " $10) " | " ($11 == "-" ? "–" : code($11) ": " short($12))
    }
    END { flush() }'
}

# What the cost and the order of the quantities of a named case are.
summary() {
  awk -F '\t' -v page="$1" '
    $1 == page && $3 == "named" && $6 == "yes" && $16 == "-" {
      if (!($4 in n)) { first[$4] = $8; from[$4] = $5; names[++count] = $4 }
      n[$4]++; last[$4] = $8; to[$4] = $5
    }
    END {
      for (k = 1; k <= count; k++) {
        q = names[k]
        if (n[q] > 1) printf "From %s to %s the cost of `%s` is multiplied by " (last[q] < 100*first[q] ? "%.2g" : "%.0f") ".\n", from[q], to[q], q, last[q]/first[q]
      }
    }' "$work/rows"
}

section() {
  line=$1
  name=$(field "$line" 1)
  page=$(ls cases/*/"$name.md")
  case $given in *" $page "*) ;; *) return 0 ;; esac
  printf '\n### %s\n\n' "$(field "$line" 2)"
  printf '[%s](../%s), %s.\n' "$name" "$page" "$(if [ "$(field "$line" 6)" ]; then echo "$(field "$line" 6), mean over eight realizations"; else echo 'the whole sweep'; fi)"
  seen "$name"
  summary "$page"
  if [ -f "$folder/trades/$name.svg" ]; then printf '\n![%s: estimated error against cost](trades/%s.svg)\n' "$(field "$line" 2)" "$name"; fi
  if grep -q "^$page.*	named	" "$work/rows"; then
    echo
    grep "^$page.*	named	" "$work/rows" | table 0
  else
    cat <<TEXT

It was not made here, because it takes too long: \`nineball advise $page --set $(field "$line" 6) --over seed\`
with \`--quantity '$(field "$line" 3)' --within '$(field "$line" 4)' --budget 3600\`.

Two cases measure prices of assemblies: [preparation-price](../cases/7-assemblies/preparation-price.md) those of a faster
preparation, and [softness-price](../cases/7-assemblies/softness-price.md) those of softer spheres and faster loading.
TEXT
  fi
}

orders >"$work/orders"
other_laws >"$work/laws"
kinds='impact|`impact.…`, the result of an impact
until|value at the end of a stage that ends by `until`
time|value at a given time or cycle
extreme|`max`, `min`, `amplitude`
mean|`mean`, `frequency`
contact test|work and force of a contact test'

# The table of orders: median and quartiles, without and with dashpots or increments.
order_table() {
  printf '| kind of quantity | without dashpots and increments | with them |\n| --- | --- | --- |\n'
  echo "$kinds" | while IFS='|' read -r kind text; do
    printf '| %s |' "$text"
    for late in 0 1; do
      awk -F '\t' -v kind="$kind" -v late=$late '$1 == kind && $5 == late { print $2 }' "$work/orders" >"$work/of"
      n=$(($(wc -l <"$work/of")))
      if [ $n -eq 0 ]; then printf ' – |'; else
        printf ' %s (%s to %s; %d) |' "$(quantile %.1f 0.5 <"$work/of")" "$(quantile %.1f 0.25 <"$work/of")" "$(quantile %.1f 0.75 <"$work/of")" $n
      fi
    done
    echo
  done
}

# The quantities for which no other law that was tried is enough within 1 %.
no_other_law() {
  awk -F '\t' '
    $2 == "1 %" { key = $5 "\t" $4; best[key] = best[key] > $3 ? best[key] : $3 }
    END {
      for (key in best) if (!best[key]) {
        split(key, part, "\t"); name = part[1]; sub(/.*\//, "", name); sub(/\.md$/, "", name)
        print "`" part[2] "` of [" name "](../" part[1] ")"
      }
    }' "$work/laws" | sort | sed ':a; N; $!ba; s/\n/, /g'
}

# The table of laws that can replace the exact one.
law_table() {
  printf '| `shear` | 10 %% | 1 %% | 0.1 %% | where it does within 1 %% |\n| --- | --- | --- | --- | --- |\n'
  for law in none linear mindlin mindlin_scaled randall randall_literal; do
    awk -F '\t' -v law="$law" '
      $1 == law { n[$2]++; good[$2] += $3; if ($2 == "1 %" && $3 && !(($4) in seen)) { seen[$4] = 1; list = list (list == "" ? "" : ", ") "`" $4 "`" } }
      function of(t) { return n[t] ? good[t] + 0 " of " n[t] : "–" }
      END { if (n["10 %"] + n["1 %"] + n["0.1 %"]) printf "| `%s` | %s | %s | %s | %s |\n", law, of("10 %"), of("1 %"), of("0.1 %"), list == "" ? "–" : list }' "$work/laws"
  done
}

quantities=$(lessons | cut -f 1,4 | sort -u | wc -l)
pages=$(lessons | cut -f 1 | sort -u | wc -l)
answered() { count "\$5 == \"$1\" && \$6 == \"yes\""; }
asked() { count "\$5 == \"$1\""; }
coarsest=$(count '$5 == "10 %" && $6 == "yes" && $11 == "-"')
cheaper() { share "$(count "\$5 == \"$1\" && \$6 == \"yes\" && \$13 == 1")" "$(answered "$1")"; }
own_cost() { lessons | awk -F '\t' -v t="$1" '$5 == t && $6 == "yes" && $8 > 0 { print $8 }' | quantile %.2g "$2"; }
# Instructions of a contact update with a law of docs/COST.md, over those with `mindlin`.
law_cost() {
  awk -F ' *[|] *' -v law="$1" '$2 == law { a = $6 } $2 == "mindlin" { b = $6 } END { if (b > 0) printf "%.1f\n", a/b; else print "–" }' docs/COST.md
}
# The reasons and how often each occurs.
no_advice() {
  lessons | awk -F '\t' '
    $6 == "no" { reason = $7 ~ /^(the limit|the budget|no setting)/ ? $7 : "the program refuses the page or the quantity"; n[reason]++ }
    END { for (r in n) print "- " n[r] ": " r }' | sort -t ' ' -k 2,2rn
}
low_order() { share "$(awk -F '\t' -v late="$1" '$5 == late && $2 < 1.5 { n++ } END { print n + 0 }' "$work/orders")" "$(awk -F '\t' -v late="$1" '$5 == late { n++ } END { print n + 0 }' "$work/orders")"; }

{
  cat <<TEXT
# The price of accuracy

\`make trades\` writes this document ([trades.sh](trades.sh)). For each case of at most fifty particles \`nineball advise\`
searched for the cheapest setting that keeps the error of a quantity within a tolerance. It did so for up to three quantities
of the case, and for 10 %, 1 % and 0.1 %. [METHOD](METHOD.md#the-accuracy-of-a-step) says how the error is
estimated, [ACCURACY](ACCURACY.md) how often such an estimate holds.

- **Setting:** what \`--set\` changes on the page. \`refine=4\` divides the step by four, \`refine=0.25\` multiplies it by four.
- **Cost:** the number of contact and particle updates over that with the page's own setting. Where two laws need nearly
  the same number, the one that takes less time is chosen.
- **Estimated error:** the largest one over eight moments of first touch within a step, relative to the limit of the case
  for a small step. It covers the laws as well as the step.
- A dash in the last column means that no cheaper setting can be run: the step is at the stability limit, or the number
  of cycles cannot be divided.

## Lessons

There are $quantities quantities of $pages cases, each at one condition in the middle of the sweep. Left out are
$(share $(($(swept | cut -f 1,4 | sort -u | wc -l) - quantities)) "$(swept | cut -f 1,4 | sort -u | wc -l)") quantities that the step does not change, such as those of time 0.

**What accuracy costs.** From 10 % to 1 % the cost is multiplied by $(cost_ratios '10 %' '1 %' | quantile %.2g 0.5) in the median, with the upper
quartile at $(cost_ratios '10 %' '1 %' | quantile %.2g 0.75). From 1 % to 0.1 % it is multiplied by $(cost_ratios '1 %' '0.1 %' | quantile %.2g 0.5), with the upper quartile at
$(cost_ratios '1 %' '0.1 %' | quantile %.2g 0.75). An error of second order costs a factor of $(awk 'BEGIN { printf "%.1f", sqrt(10) }') for each digit, one of first order a factor of ten.

Where the tolerance decides the step at all, the factors are larger. For $(share "$(cost_ratios '10 %' '1 %' | decided | wc -l)" "$(cost_ratios '10 %' '1 %' | wc -l)") of the quantities the
cost changes from 10 % to 1 %, in the median by a factor of $(cost_ratios '10 %' '1 %' | decided | quantile %.2g 0.5). For $(share "$(cost_ratios '1 %' '0.1 %' | decided | wc -l)" "$(cost_ratios '1 %' '0.1 %' | wc -l)") it changes from 1 % to
0.1 %, in the median by a factor of $(cost_ratios '1 %' '0.1 %' | decided | quantile %.2g 0.5).

**A step that can be run is often good enough for 10 %.** For $(share "$coarsest" "$(answered '10 %')") of the quantities with advice within 10 %, no cheaper
setting than the chosen one can be run. Its step is at the stability limit, or the page has a fixed number of cycles.

**What the pages spend.** Within 1 % the chosen setting costs $(own_cost '1 %' 0.5) of the page's own in the median, with quartiles at
$(own_cost '1 %' 0.25) and $(own_cost '1 %' 0.75). Most pages check a theory to many digits, so their steps are shorter than an engineering
result needs.

**Where first order bites.** The order is the slope of the estimated error against the step, over the three finest steps
that were tried. The table has the median, in brackets the quartiles and the number of quantities, without dashpots and increments, and with them. Dashpots use
the velocity of half a step before, and some laws add up increments of the force (\`hertz_increment\`, \`randall\`).

$(order_table)

The order is below 1.5 for $(low_order 0) of the quantities without dashpots and increments, and for
$(low_order 1) with them.

- A stage that ends by \`until\` ends after a whole cycle, up to one step late. The error is of first order if the quantity still
  changes there.
- A first touch happens within a step. At a given time after it the quantity is early or late by a part of a step.
- A largest value is sampled once per step, but it is flat there. The sampling costs only second order.
- The result of an impact does not change any more when the particles have separated, so it has the order of the forces.

**Where the exact law is needed.** On cases with \`shear mindlin_deresiewicz\`, the table has the number of quantities for which
another law gives the same limit within the tolerance, at no more updates. It counts a law only where the reference of the case covers it.
Each quantity is taken at one condition. If the contact slides during the whole impact, every law with friction gives the same
result. Over a whole sweep of angles fewer laws are enough ([below](#maws-oblique-impact)).

$(law_table)

No other law is enough within 1 % for: $(no_other_law).

The chosen setting has other laws than the page for $(cheaper '10 %') of all quantities within 10 %, for
$(cheaper '1 %') within 1 %, and for $(cheaper '0.1 %') within 0.1 %. Of laws with equal numbers of updates the fastest one is chosen. An update with the
exact law takes $(law_cost exact) times the instructions of one with \`mindlin\`, and an update with \`randall\` $(law_cost randall) times ([COST](COST.md)).

**No advice.** $(lessons | awk -F '\t' '$6 == "no"' | wc -l) searches ended without advice:

$(no_advice)

## The seven named cases

Each figure shows the estimated error against the cost, one curve for each set of laws. The ring is the advice, and the
dashed line the tolerance.
TEXT
  named | while read -r line; do section "$line"; done
  echo
  cat docs/trades/ways.txt # written by hand: measurements of other ways, with a table and a figure beside it
  printf '\n## All cases\n'
  swept | cut -d / -f 2 | sort -u | while read -r chapter; do
    printf '\n### %s\n\n' "$(sed -n '1s/^# //p' "cases/$chapter/README.md")"
    swept | grep "^cases/$chapter/" | table 1
  done
} >"$work/document"
cp "$work/document" "$folder/TRADES.md"
