#!/bin/sh
# Writes docs/TRADES.md and the figures docs/trades/*.svg from the table of `nineball advise --all`: the cheapest settings within 10 %, 1 % and
# 0.1 % on each case of at most 50 particles, and those of two small assemblies. Every number of that document comes from that table, from the tables
# docs/trades/*.tsv (ways.sh, softness.sh) or, for the instructions of laws, from docs/COST.md.
#
#   docs/trades.sh -o FOLDER [PAGE…]    writes FOLDER/TRADES.md and FOLDER/trades; without pages: all of cases
#
#   NINEBALL   the program                    BUDGET   seconds for each search, 60
#   RESULTS    folder of the table; a second call with the same program continues there. Default: a temporary one
#   ASSEMBLIES seconds for each search on an assembly, 1800
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
budget=${BUDGET:-60} assemblies=${ASSEMBLIES:-1800}
cksum <"$nineball" >"$work/program"
cmp -s "$work/program" "$results/program" || rm -rf "$results"/*
cp "$work/program" "$results/program"

# The named cases: NAME | title | quantity of the figure | its tolerances, the last one that of the figure | further quantities. Instead of an
# assembly a smaller one is searched, docs/trades/small-NAME.md.
named() {
  cat <<'NAMED'
two-wall-compression | Two-wall compression | B.normal at 6 cycles | 10 %; 1 %; 0.1 % | X.vx.half at 6 cycles |
mindlin-loops | Quasi-static Mindlin loops | work.shear in reload | 10 %; 1 %; 0.1 % | work.shear in back |
hertz-impact | Hertz normal impact | impact.duration | 10 %; 1 %; 0.1 % | C.normal max in strike; impact.restitution |
oblique-impact | Maw's oblique impact | impact.psi2 | 0.1; 0.01; 0.001 | impact.restitution; impact.duration |
restitution-angle | Restitution against angle | impact.restitution | 10 %; 1 %; 0.1 % | |
isotropic-compression | Isotropic compression | A.coordination.mechanical in friction | 5 % |
constant-volume-shear | Constant-volume shear | A.stress.sinphi mean in shear | 10 % |
NAMED
}

# What to see in the section of a named case. Numbers are added to it below.
seen() {
  case $1 in
  two-wall-compression)
    echo 'The walls move with a constant speed, and the springs are linear. The error of the force is of second order: twice the updates
leave a quarter of the error. `X.vx.half` is the velocity of half a step before, so its error is of first order, and a small error needs far more updates.' ;;
  mindlin-loops)
    echo 'The exact law gives the same force with any number of steps. Only the work has an error. The work is computed as the
sum, over the steps, of the mean force times the increment of displacement. This replaces each curve by straight pieces. The error is of
second order.' ;;
  hertz-impact)
    echo 'The force and its derivative vanish at both ends of the contact. So neither the first touch within a step nor the end of the contact causes
an error of first order, and the figure shows second order.' ;;
  oblique-impact)
    echo 'The tangential velocity `impact.psi2` follows from the history of micro-slip. No other law has the same limit within these tolerances over
the whole sweep, so the figure has one curve. Restitution and duration depend less on the shear force.' ;;
  restitution-angle)
    echo 'Restitution compares speeds, and the shear force changes only a part of them. Within 1 % a law without micro-slip is enough at every angle,
but not within 0.1 %.' ;;
  isotropic-compression)
    echo 'The search varies the strain rates of the case and the step. The quantity is the mechanical coordination number. The motion
of an assembly is chaotic, so only a mean over realizations has a limit.' ;;
  *)
    echo 'The search varies the rate of the shear and the step. The prepared assemblies are the same for all settings. The quantity is the mean of
sin Φ over the test, which ends at a deviator strain of 0.1 %.' ;;
  esac
}
# The page that is searched for a named case.
page_of() { if [ -f "docs/trades/small-$1.md" ]; then echo "docs/trades/small-$1.md"; else ls cases/*/"$1.md"; fi; }
is_small() { case $1 in docs/*) ;; *) false ;; esac; }
field() { echo "$1" | cut -d '|' -f "$2" | sed 's/^ *//; s/ *$//'; }

given=" $* "
is_given() { [ "$given" = '  ' ] || case $given in *" $1 "*) ;; *) false ;; esac; }

# ---- the searches ----

# Status 1: a search ended without advice. Without gnuplot there are no figures (2), but the table has all rows.
advise() { "$nineball" advise --all "$@" --budget "$budget" --trust -o "$results" >&2 || [ $? -le 2 ]; }

[ $# -gt 0 ] || set -- cases
advise "$@"

# The named cases: all runs of their sweeps. Assemblies: means over realizations, with one tolerance.
named >"$work/named"
while read -r line; do
  name=$(field "$line" 1)
  page=$(page_of "$name")
  is_given "$page" || continue
  if is_small "$page"; then
    (
      budget=$assemblies
      advise "$page" --over seed --quantity "$(field "$line" 3)" --within "$(field "$line" 4)" </dev/null
    )
  else
    [ -z "$(field "$line" 5)" ] || advise "$page" --quantity "$(field "$line" 5)" </dev/null
    advise "$page" --quantity "$(field "$line" 3)" --within "$(field "$line" 4)" </dev/null
  fi
  figure=$results/$(basename "$page" .md).svg
  [ ! -s "$figure" ] || cp "$figure" "$folder/trades/$name.svg"
done <"$work/named"

# The rows of the pages as they are now. Columns: 1 page, 2 hash, 3 condition, 4 over, 5 kind (-: a named case), 6 quantity, 7 tolerance, 8 result,
# 9 setting or reason, 10 cost, 13 error, 14 unit, 15 next cheaper setting, 16 its error over tolerance, 17 order, 18 normal, 19 shear law of the
# page, 20 laws that are enough, 21 laws that are not. Assemblies that need realizations are left out.
awk -F '\t' -v OFS='\t' '
  /^#/ || /^page\t/ { next }
  NR == FNR { hash[$1] = $2; next }
  hash[$1] == $2 && $9 !~ /^expected a page of at most/ {
    gsub(/--set /, "", $9); gsub(/--set /, "", $15)
    sub("normal=" $18 " ", "", $9); sub("normal=" $18 " ", "", $15)
    if ($8 != "yes") $9 = $8 == "budget" ? "the budget was used up" : $8 == "unknown" ? "the limit is not known well enough" : $9
    print
  }' "$results/trades.tsv" "$results/trades.tsv" >"$work/rows"

# ---- numbers for the prose ----

# The quantile ($2) of the numbers of standard input, as $1 prints it.
quantile() { sort -g | awk -v format="$1" -v q="$2" '{ v[NR] = $1 } END { if (NR == 0) print "–"; else printf format "\n", v[int(q*(NR - 1) + 1.5)] }'; }
# swept prints the rows of single conditions, and lessons prints those of them whose error depends on the setting. count
# CONDITION prints how many of the latter satisfy a condition of awk.
swept() { awk -F '\t' '$5 != "-"' "$work/rows"; }
lessons() { swept | awk -F '\t' '{ row[NR] = $0; key[NR] = $1 $6; if ($8 == "yes" && $13 < 1e-9) exact[$1 $6] = 1 } END { for (k = 1; k <= NR; k++) if (!(key[k] in exact)) print row[k] }'; }
count() { lessons | awk -F '\t' "$1"' { n++ } END { print n + 0 }'; }
share() { awk -v a="$1" -v b="$2" 'BEGIN { if (b > 0) printf "%d of %d (%.0f %%)\n", a, b, 100*a/b; else print "none" }'; }

# Cost at the tolerance $2 over that at the tolerance $1, of each quantity that has both.
cost_ratios() {
  lessons | awk -F '\t' -v a="$1" -v b="$2" '
    $8 == "yes" && $10 > 0 { if ($7 == a) first[$1, $6] = $10; if ($7 == b) second[$1, $6] = $10 }
    END { for (k in second) if (k in first) print second[k]/first[k] }'
}

# Those ratios of standard input that differ from 1 by more than 5 %.
decided() { awk '$1 > 1.05 || $1 < 0.95'; }

# The order of each quantity at its smallest tolerance: KIND, order, and 1 if the forces depend on a velocity of half a
# step before, as with dashpots, or on increments, as with laws that add increments of the force.
orders() {
  lessons | awk -F '\t' '
    $8 == "yes" && $17 != "-" { order[$1 "\t" $6] = $17; kind[$1 "\t" $6] = $5; late[$1 "\t" $6] = $18 $19 ~ /increment|randall/; page[$1 "\t" $6] = $1 }
    END {
      for (key in order) {
        while ((getline line < page[key]) > 0) if (line ~ /^ *damping /) late[key] = 1
        close(page[key])
        print kind[key] "\t" order[key] "\t" late[key]
      }
    }'
}

# Whether another law is enough, for the quantities of the pages with the exact law: LAW, TOLERANCE, 1 or 0, quantity,
# page.
other_laws() {
  lessons | awk -F '\t' '
    $8 == "yes" && $19 == "mindlin_deresiewicz" {
      for (c = 20; c <= 21; c++) { n = split($c, law, " "); for (k = 1; k <= n; k++) if (law[k] != "-") print law[k] "\t" $7 "\t" (c == 20) "\t" $6 "\t" $1 }
    }'
}

# ---- the document ----

# Prints rows of the list of results as a table, with a column for the page if $1 is 1. Pages and quantities are not
# repeated.
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
      result = $9 "|" $10 "|" $13 "|" $15
      same = $1 == page && $6 == measure
      if (!same || result != last) {
        flush()
        condition = $3
        gsub(/(^|, )[A-Za-z_0-9]+=[0-9.]*[0-9][0-9][0-9][0-9][0-9][0-9][0-9][0-9][0-9][^,]*/, "", condition) # a computed value
        sub(/^, /, "", condition)
        case_cell = $1 == page ? "" : "[" name "](../" $1 ")" (condition == "-" || condition == "" ? "" : ", " condition)
        measure_cell = same ? "" : code($6)
      }
      last = result; page = $1; measure = $6
      tolerances = tolerances (tolerances == "" ? "" : ", ") $7
      rest = $8 != "yes" ? "no advice: " $9 " | | |" : code($9) " | " ($10 == "-" || $10 == "nan" ? "–" : short($10)) " | " \
        short($14 == "%" ? 100*$13 : $13) ($14 == "1" ? "" : " " $14) " | " ($15 == "-" ? "–" : code($15) ": " short($16))
    }
    END { flush() }'
}

# How the cost of each quantity of a named case grows from its first tolerance to its last.
summary() {
  awk -F '\t' '
    $8 == "yes" && $4 == "-" {
      if (!($6 in n)) { first[$6] = $10; from[$6] = $7; names[++count] = $6 }
      n[$6]++; last[$6] = $10; to[$6] = $7
    }
    END {
      for (k = 1; k <= count; k++) {
        q = names[k]
        if (n[q] > 1) printf "From %s to %s the cost of `%s` is multiplied by " (last[q] < 100*first[q] ? "%.2g" : "%.0f") ".\n", from[q], to[q], q, last[q]/first[q]
      }
    }' "$work/section"
}

section() {
  line=$1
  name=$(field "$line" 1)
  page=$(page_of "$name")
  is_given "$page" || return 0
  printf '\n### %s\n\n' "$(field "$line" 2)"
  if is_small "$page"; then
    echo "A search on [thesis-$name](../$(ls cases/*/"thesis-$name.md")) would take hours. [A page with a sixth of its spheres](../$page) is searched instead:"
    echo "about a hundred spheres, mean over eight realizations."
  else
    printf '[%s](../%s), the whole sweep.\n' "$name" "$page"
  fi
  seen "$name"
  for other in 0 1; do # the quantity of the figure first
    awk -F '\t' -v page="$page" -v first="$(field "$line" 3)" -v other=$other '$1 == page && $5 == "-" && ($6 != first) == other' "$work/rows"
  done >"$work/section"
  summary
  if [ -f "$folder/trades/$name.svg" ]; then printf '\n![%s: estimated error against cost](trades/%s.svg)\n' "$(field "$line" 2)" "$name"; fi
  echo
  table 0 <"$work/section"
  ! is_small "$page" || [ "$name" != isotropic-compression ] || cat <<TEXT

Two cases measure the loss of accuracy in larger assemblies:
[preparation-price](../cases/7-assemblies/preparation-price.md) with a faster preparation, and
[softness-price](../cases/7-assemblies/softness-price.md) with softer spheres and faster loading.
TEXT
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
      awk -F '\t' -v kind="$kind" -v late=$late '$1 == kind && $3 == late { print $2 }' "$work/orders" >"$work/of"
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
  printf '| `shear` | 10 %% | 1 %% | 0.1 %% | quantities for which it is enough within 1 %% |\n| --- | --- | --- | --- | --- |\n'
  for law in none linear mindlin mindlin_scaled randall randall_literal; do
    awk -F '\t' -v law="$law" '
      $1 == law { n[$2]++; good[$2] += $3; if ($2 == "1 %" && $3 && !(($4) in seen)) { seen[$4] = 1; list = list (list == "" ? "" : ", ") "`" $4 "`" } }
      function of(t) { return n[t] ? good[t] + 0 " of " n[t] : "–" }
      END { if (n["10 %"] + n["1 %"] + n["0.1 %"]) printf "| `%s` | %s | %s | %s | %s |\n", law, of("10 %"), of("1 %"), of("0.1 %"), list == "" ? "–" : list }' "$work/laws"
  done
}

quantities=$(lessons | cut -f 1,6 | sort -u | wc -l)
pages=$(lessons | cut -f 1 | sort -u | wc -l)
answered() { count "\$7 == \"$1\" && \$8 == \"yes\""; }
coarsest=$(count '$7 == "10 %" && $8 == "yes" && $15 == "-"')
cheaper() { share "$(count "\$7 == \"$1\" && \$8 == \"yes\" && \$9 ~ /shear=|normal=/")" "$(answered "$1")"; }
chosen_with() { share "$(count "\$7 == \"$2\" && \$8 == \"yes\" && \$9 ~ /$1/")" "$(answered "$2")"; }
own_cost() { lessons | awk -F '\t' -v t="$1" '$7 == t && $8 == "yes" && $10 > 0 { print $10 }' | quantile %.2g "$2"; }
# Instructions of a contact update with a law of docs/COST.md, over those with `mindlin`.
law_cost() {
  awk -F ' *[|] *' -v law="$1" '$2 == law { a = $6 } $2 == "mindlin" { b = $6 } END { if (b > 0) printf "%.1f\n", a/b; else print "–" }' docs/COST.md
}
# The reasons and how often each occurs.
no_advice() {
  lessons | awk -F '\t' '
    $8 != "yes" { reason = $9 ~ /^(the limit|the budget|no setting)/ ? $9 : "the program refuses the page or the quantity"; n[reason]++ }
    END { for (r in n) print n[r] "\t- " r ": " n[r] }' | sort -k 1,1rn | cut -f 2-
}
low_order() { share "$(awk -F '\t' -v late="$1" '$3 == late && $2 < 1.5 { n++ } END { print n + 0 }' "$work/orders")" "$(awk -F '\t' -v late="$1" '$3 == late { n++ } END { print n + 0 }' "$work/orders")"; }

{
  cat <<TEXT
# The cost of accuracy

\`make trades\` writes this document ([trades.sh](trades.sh)). For each case of at most fifty particles \`nineball advise --all\`
searched for the cheapest setting that keeps the error of a quantity within a tolerance. It did so for up to three quantities
of the case, and for the tolerances 10 %, 1 % and 0.1 %. For any page, \`nineball advise --all PAGE -o FOLDER\` writes the table
FOLDER/trades.tsv, and the figure FOLDER/NAME.svg of the error against the cost. Seven figures are [below](#the-seven-named-cases).
[METHOD](METHOD.md#the-accuracy-of-a-step) says how the error is estimated, and [ACCURACY](ACCURACY.md) how often such an estimate holds.

- **Setting:** what \`--set\` changes on the page. \`refine=4\` divides the step by four, \`refine=0.25\` multiplies it by four.
- **Cost:** the number of contact and particle updates, divided by the number that the page's own setting needs. Settings whose
  numbers differ by less than 10 % count as equally expensive. Of these the one with the stiffer contacts is chosen, and of equal
  stiffnesses the one whose laws store less per contact.
- **Estimated error:** an estimate of the difference from the *limit*: the result of the page with its own laws and a very small
  step. So it includes the error of other laws. In an impact it covers eight moments of first touch within a step.
- A dash in the last column means that no cheaper setting could be tried. In most cases its step would exceed the stability limit
  or not give a whole number of cycles.

## Lessons

There are $quantities quantities of $pages cases, each at one condition in the middle of the sweep. Not counted are
$(share $(($(swept | cut -f 1,6 | sort -u | wc -l) - quantities)) "$(swept | cut -f 1,6 | sort -u | wc -l)") quantities that the step does not change, such as those at time 0.

**What accuracy costs.** From 10 % to 1 % the cost is multiplied by $(cost_ratios '10 %' '1 %' | quantile %.2g 0.5) in the median, with the upper
quartile at $(cost_ratios '10 %' '1 %' | quantile %.2g 0.75). From 1 % to 0.1 % it is multiplied by $(cost_ratios '1 %' '0.1 %' | quantile %.2g 0.5), with the upper quartile at
$(cost_ratios '1 %' '0.1 %' | quantile %.2g 0.75). An error of second order costs a factor of $(awk 'BEGIN { printf "%.1f", sqrt(10) }') for each further digit, one of first order a factor of ten.

For some quantities one setting satisfies two tolerances. For the others the factors are larger. For $(share "$(cost_ratios '10 %' '1 %' | decided | wc -l)" "$(cost_ratios '10 %' '1 %' | wc -l)") of the quantities the
cost changes from 10 % to 1 %, in the median by a factor of $(cost_ratios '10 %' '1 %' | decided | quantile %.2g 0.5). For $(share "$(cost_ratios '1 %' '0.1 %' | decided | wc -l)" "$(cost_ratios '1 %' '0.1 %' | wc -l)") it changes from 1 % to
0.1 %, in the median by a factor of $(cost_ratios '1 %' '0.1 %' | decided | quantile %.2g 0.5).

**The longest step that can be run is often good enough for 10 %.** For $(share "$coarsest" "$(answered '10 %')") of the quantities with advice within 10 %, no cheaper
setting than the chosen one could be tried.

**What the pages spend.** Within 1 % the chosen setting costs $(own_cost '1 %' 0.5) of the page's own in the median, with quartiles at
$(own_cost '1 %' 0.25) and $(own_cost '1 %' 0.75). Most pages check a theory to many digits, so their steps are shorter than an engineering
result needs.

**Where the error is of first order.** The order is the slope of the logarithm of the estimated error against that of
the step, over the three finest steps that were tried. The table has the median, and in parentheses the quartiles and the number of quantities. The first column is for
pages that have neither dashpots nor laws that add up increments of the force (\`hertz_increment\`, \`randall\`). The second column
is for the other pages. Dashpots use the velocity of half a step before, unless the page has \`damping centred\`.

$(order_table)

The order is below 1.5 for $(low_order 0) of the quantities without dashpots and increments, and for
$(low_order 1) with them.

- A stage that ends by \`until\` ends after a whole cycle, up to one step late. The error is of first order if the quantity still
  changes there.
- A first touch happens within a step. So the later motion is early or late by a fraction of a step, and a quantity at a given time
  has an error of first order.
- A largest value is sampled once per step, but the curve is flat there. The sampling error is only of second order.
- The result of an impact does not change after the particles have separated. So its error has the order of the error of the
  forces.

**Where the exact law is needed.** On cases with the exact law, \`shear mindlin_deresiewicz\`, other shear laws were tried. The table
has the number of quantities for which another law is enough: it gives the same limit within the tolerance, with no more updates.
A law is tried only where the reference of the case is valid for it.
Each quantity is taken at one condition. If the contact slides during the whole impact, every law with friction gives the same
result. Over a whole sweep of angles fewer laws are enough ([below](#maws-oblique-impact)).

$(law_table)

No other law is enough within 1 % for: $(no_other_law).

The chosen setting has another law than the page for $(cheaper '10 %') of the quantities with advice within 10 %.
Within 1 % this holds for $(cheaper '1 %'), and within 0.1 % for $(cheaper '0.1 %'). Of laws with equal numbers of updates the one that stores less per contact is chosen. An update with the
exact law takes $(law_cost exact) times the instructions of one with \`mindlin\`, and an update with \`randall\` $(law_cost randall) times ([COST](COST.md)).
In quasi-static shear of an assembly the mean of \$\\sin \\Phi\$ differs between the exact law and \`mindlin\` by
0.0003 ± 0.0001 over ten pairs of runs ([no-slip-or-exact](../cases/7-assemblies/no-slip-or-exact.md)).

**Softer contacts and centred dashpots.** Softer contacts are the choice for $(chosen_with soften= '10 %') of the quantities with advice within 10 %,
for $(chosen_with soften= '1 %') within 1 %, and for $(chosen_with soften= '0.1 %') within 0.1 %. Most quantities of an impact depend on
the stiffness. Where the step is given as a fraction of the duration of the collision, softer contacts save nothing. Centred
dashpots are the choice within the three tolerances for $(chosen_with damping=centred '10 %'), $(chosen_with damping=centred '1 %') and $(chosen_with damping=centred '0.1 %').

$(sh docs/trades/softness.sh)

**No advice.** $(lessons | awk -F '\t' '$8 != "yes"' | wc -l) searches ended without advice:

$(no_advice)

## The seven named cases

Each figure shows the estimated error against the number of updates, one curve for each set of laws. The ring marks the setting that the advice
chooses, and the dashed line the tolerance.
TEXT
  while read -r line; do section "$line"; done <"$work/named"
  echo
  sh docs/trades/ways.sh
  printf '\n## All cases\n'
  swept | cut -d / -f 2 | sort -u | while read -r chapter; do
    printf '\n### %s\n\n' "$(sed -n '1s/^# //p' "cases/$chapter/README.md")"
    swept | grep "^cases/$chapter/" | table 1
  done
} >"$work/document"
cp "$work/document" "$folder/TRADES.md"
! command -v gnuplot >/dev/null || (cd docs/trades && gnuplot -c ways.gp "$folder/trades/ways.svg")
