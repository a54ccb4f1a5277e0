#!/bin/sh
# Prints the section of docs/TRADES.md on other ways to trade. Every measured number comes from a table *.tsv of this
# folder, whose first lines name the command. springs.sh writes the tables linear-springs*.tsv. The other tables were
# measured with the commit that their first lines name, and no command makes them again.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu
LC_ALL=C
export LC_ALL
cd "$(dirname "$0")"

# of TABLE PROGRAM [-v VARIABLE=VALUE …]: runs an awk program over the rows of a table.
# value("name") is the number there. compare(a, b) sets the difference of the means of a[seed] and b[seed], and the half-width of its
# 95 % confidence interval by Student's t, paired.
of() {
  table=$1 program=$2
  shift 2
  grep -v '^#' "$table" | awk -F '\t' "$@" '
    function value(name) { if (!(name in columns)) { print "no column " name >"/dev/stderr"; exit 1 } return $columns[name] }
    function mean(a, k, sum, size) { for (k in a) { sum += a[k]; size++ } return sum/size }
    function compare(a, b, k, d, squares, size) {
      difference = 0
      for (k in a) { size++; difference += a[k] - b[k] }
      difference /= size
      for (k in a) { d = a[k] - b[k] - difference; squares += d*d }
      if (size != 8) { print "expected 8 realizations, found " size >"/dev/stderr"; exit 1 }
      interval = 2.3646*sqrt(squares/(size - 1)/size) # Student, 7 degrees of freedom
    }
    function thousands(x, digits) {
      x = sprintf("%.0f", x/digits)*digits
      return x < 1e6 ? sprintf("%d %03d", x/1000, x % 1000) : sprintf("%d %03d %03d", x/1e6, x % 1e6/1000, x % 1000)
    }
    function signed(x, decimals, text) { text = sprintf("%+." decimals "f", x); sub(/^-/, "−", text); return text }
    NR == 1 { for (k = 1; k <= NF; k++) columns[$k] = k; next }
    '"$program"
}

# Prints the least and the largest ratio of the updates with late dashpots to those with centred dashpots, within a
# tolerance, and the number of ratios.
late_over_centred() {
  of centred-dashpots.tsv '
    value("tolerance") == within && value("result") == "chosen" { n[value("page") value("setting") value("quantity"), value("timing")] = value("updates") }
    END {
      for (k in n) if (sub(SUBSEP "late$", "", k)) {
        ratio = n[k, "late"]/n[k, "centred"]
        if (!count++ || ratio < least) least = ratio
        if (ratio > most) most = ratio
      }
      printf "%.0f %.0f %d\n", least, most, count
    }' -v within="$1"
}
set -- $(late_over_centred 0.1%) $(late_over_centred 1%)
centred_least=$1 centred_most=$2 centred_quantities=$3 centred_most_at_1=$5

discs() { of local-discs.tsv 'value("kind") == kind && value("limit") == "0.00001" { print value("cycles") }' -v kind="$1"; }
best_mass=$(of local-discs.tsv 'value("kind") ~ /^mass/ && value("limit") == "0.00001" && (!best || value("cycles") < best) { best = value("cycles") } END { print best }')
masses=$(of local-discs.tsv 'value("kind") ~ /^mass/ && value("limit") == "0.00001"' | wc -l)

# The mean of a column over the realizations of one kind.
local_mean() { of local-assemblies.tsv 'value("kind") == kind { a[value("seed")] = value(name) } END { print digits ? thousands(mean(a), digits) : mean(a) }' -v kind="$1" -v name="$2" -v digits="${3:-0}"; }
local_difference() {
  of local-assemblies.tsv '
    value("kind") == "local-0.7" { a[value("seed")] = value(name) }
    value("kind") == "contact-0.1" { b[value("seed")] = value(name) }
    END { compare(a, b); if (digits) print thousands(difference, digits) " ± " thousands(interval, digits); else printf "%s ± %.4f\n", signed(difference, 4), interval }' -v name="$1" -v digits="${2:-0}"
}
ratio() { awk -v a="$1" -v b="$2" 'BEGIN { printf "%.1f\n", a/b }'; }

plan() { of stage-step.tsv 'value("plan") == plan { a[value("seed")] = value("cycles") } END { print thousands(mean(a), 1000) }' -v plan="$1"; }

# Density scaling: the shear test alone, means over realizations. The faster test without scaling is the one with an
# equal unbalanced force. Its number of cycles is interpolated: the logarithm of this number is taken as linear in that
# of the force.
density() {
  of density.tsv '
    { k = value("power") " " value("speed"); n[k]++; cycles[k] += value("cycles.shear") - value("cycles.friction"); step[k] += value("step"); force[k] += value("unbalanced")
      if (value("speed") == 1) { if (value("power") == 2) a[value("seed")] = value("sinphi"); else b[value("seed")] = value("sinphi") } }
    END {
      scaled = cycles["2 1"]/n["2 1"]; plain = cycles["0 1"]/n["0 1"]
      share = log(force["2 1"]/force["0 1"])/log(force["0 4"]/force["0 1"])
      faster = plain*exp(share*log(cycles["0 4"]/cycles["0 1"]))
      compare(a, b)
      printf "%.1f|%s|%s|%.1f|%s|%.0f|%s ± %.3f\n", step["2 1"]/step["0 1"], thousands(scaled, 1000), thousands(plain, 1000), force["2 1"]/force["0 1"], thousands(faster, 1000), 100*(1 - scaled/faster), signed(difference, 3), interval
    }'
}
IFS='|' read -r density_step density_cycles density_plain density_force density_faster density_saved density_sinphi <<END
$(density)
END

# Prints the number of searches with linear springs. Then the one search in which springs need at least 10 % fewer
# updates than Hertz's law: quantity, tolerance, updates with springs, updates with Hertz's law.
springs() {
  of linear-springs.tsv '
    { k = value("quantity") "|" value("within"); searches[k]; if (value("result") != "misses" && (!((k, value("normal")) in least) || value("updates") < least[k, value("normal")])) least[k, value("normal")] = value("updates") }
    END {
      for (k in searches) {
        all++
        if ((k, "linear") in least && least[k, "linear"] < 0.9*least[k, "hertz"]) { saved++; which = k "|" sprintf("%.0f|%.0f", least[k, "linear"], least[k, "hertz"]) }
      }
      if (saved != 1) { print "the text is about one search, found " saved >"/dev/stderr"; exit 1 }
      print all "|" which
    }'
}
IFS='|' read -r searches saved_quantity saved_within saved_linear saved_hertz <<END
$(springs)
END
test "$saved_quantity" = impact.duration

# The same over the angles of incidence. Prints the number of searches for other quantities than the duration; in none
# of them springs may save 10 % of the updates. Then the least updates for the duration with springs and with Hertz's
# law, within 10 % and within 0.1 %.
springs_angle() {
  of linear-springs-angle.tsv '
    { k = value("quantity") "|" value("within"); searches[k]; if (value("result") != "misses" && (!((k, value("normal")) in least) || value("updates") < least[k, value("normal")])) least[k, value("normal")] = value("updates") }
    END {
      for (k in searches) {
        if (k ~ /^impact.duration/) continue
        all++
        if ((k, "linear") in least && least[k, "linear"] < 0.9*least[k, "hertz"]) { print "the text has no saving, found " k >"/dev/stderr"; exit 1 }
      }
      printf "%d|%.0f|%.0f|%.0f|%.0f\n", all, least["impact.duration|10 %", "linear"], least["impact.duration|10 %", "hertz"],
        least["impact.duration|0.1 %", "linear"], least["impact.duration|0.1 %", "hertz"]
    }'
}
IFS='|' read -r angle_searches angle_linear_10 angle_hertz_10 angle_linear_01 angle_hertz_01 <<END
$(springs_angle)
END

relaxed() {
  of relaxation.tsv '
    value("samples") != "difference" { k = value("samples") " " value("grading"); n[k]++; cycles[k] += value("cycles"); if (value("samples") == "relaxed") { all++; if (value("cycles") > 150000) long++; if (value("drift") > drift) drift = value("drift") } }
    value("samples") == "difference" { for (c = columns["porosity"]; c <= NF; c++) { d = $c < 0 ? -$c : $c; if (d > largest) largest = d } ; strength[value("grading")] = value("sinphi.025") }
    END {
      printf "%d|%s|%s|%s|%s|%d|%.3f|%s|%s\n", all, thousands(cycles["relaxed uniform"]/n["relaxed uniform"], 1000), thousands(cycles["ordinary uniform"]/n["ordinary uniform"], 1000),
        thousands(cycles["relaxed graded"]/n["relaxed graded"], 1000), thousands(cycles["ordinary graded"]/n["ordinary graded"], 1000), long, 100*drift, strength["uniform"] + 0, strength["graded"] + 0
    }'
}
IFS='|' read -r samples relaxed_uniform ordinary_uniform relaxed_graded ordinary_graded long drift strength_uniform strength_graded <<END
$(relaxed)
END

cat <<TEXT
## Other ways to trade

Six more ways to exchange accuracy for cost were measured. One of them became part of the program. The intervals are at 95 % confidence.

**Dashpots with the velocity at the time of the force.** Within 0.1 % \`damping centred\` needs $centred_least to $centred_most times fewer updates
than CS79's dashpots for each of $centred_quantities quantities, and within 1 % up to $centred_most_at_1 times fewer
([centred-dashpots.tsv](trades/centred-dashpots.tsv), eight moments of first touch each). The error becomes one of second order
([centred-dashpots](../cases/5-numerics/centred-dashpots.md)). \`damping centred\` is part of the program; the default stays that of the
paper.

**Local damping** (P. A. Cundall, in *Analytical and Computational Methods in Engineering Rock Mechanics*, 1987) adds a force to every component of the
unbalanced force on a particle. The added force is a fraction of the magnitude of this component and acts against the velocity. It was tried and left out ([local-discs.tsv](trades/local-discs.tsv),
[local-assemblies.tsv](trades/local-assemblies.tsv)). Nine discs come to rest in $(discs local-0.7) cycles with the usual fraction 0.7,
and in $best_mass with the best of $masses values of \`damping mass\`. The fraction of local damping need not be adapted to the scene.
With local damping, eight assemblies need $(local_mean local-0.7 cycles 1000) cycles on average until they are at rest with friction. With \`damping ratio 0.1\`
they need $(local_mean contact-0.1 cycles 1000); the difference is $(local_difference cycles 1000). The differences of porosity, coordination number and
\$\\sin \\Phi\$ are $(local_difference porosity), $(local_difference z) and $(local_difference sinphi). During the shear
the mean unbalanced force is $(ratio "$(local_mean local-0.7 unbalanced)" "$(local_mean contact-0.1 unbalanced)") times as large.

**A step from the stable bound at the beginning of each stage** saves little ([stage-step.tsv](trades/stage-step.tsv), eight
realizations). With 0.85 to 0.9 of the stable step in the stages after the compression, the preparation and the shear test
take $(plan bound) cycles instead of $(plan hand) with two steps chosen by hand. One step for all stages takes $(plan one). While
contacts form and stiffen, the bound falls: steps of 0.75, 0.7 and 0.6 of the bound at the beginning of the compression to 100 kPa
were too long later. The program needs no new feature: a page writes \`step F of stable\` in a stage.

**Density scaling** makes small spheres heavier, so that spheres of all sizes limit the step alike ([density.tsv](trades/density.tsv), eight
realizations). With densities proportional to \$r^{-2}\$ the step in the shear test is $density_step times as long. The test takes
$density_cycles cycles instead of $density_plain, and the mean unbalanced force is $density_force times as large. By interpolation, a faster test without scaling has the
same unbalanced force with $density_faster cycles, so scaling saves $density_saved %. The difference of \$\\sin \\Phi\$ is $density_sinphi.
A larger density of all spheres alike has the same effect as a faster test, because it changes only the inertial number. The program needs no new feature: a page can give each size a material of its own.

**Relaxation without time** replaces the last stage of a preparation by the minimizer FIRE, towards an isotropic stress
([relaxation.tsv](trades/relaxation.tsv), ten realizations of each grading). It was tried after a compression with ten times the usual strain rates.
*Uniform* needs $relaxed_uniform cycles and force calculations on average instead of $ordinary_uniform, and *Graded* $relaxed_graded instead of
$ordinary_graded; $long of the $samples samples needs more than 150 000. Afterwards the stress drifts by at most $drift %. But the samples are stronger than those of the usual
preparation: at a deviator strain of 0.25 % the difference of \$\\sin \\Phi\$ is $strength_uniform and $strength_graded standard errors. So it was left out.

**Linear springs with a stiffness from the modulus** save almost nothing in an impact, except for its duration
([linear-springs.tsv](trades/linear-springs.tsv), [the page](trades/linear-springs.md)). The stiffness
\$k_n = \\pi^2 m^*/T_c^2\$ gives the impact of two particles with the reduced mass \$m^*\$ the duration \$T_c\$ of
[Hertz's](../cases/2-hertz/hertz-impact.md), at one approach speed. The largest force is then $(awk 'BEGIN { printf "%.3f", 4*atan2(0, -1)/(5*2.943275) }') of Hertz's, and the largest overlap $(awk 'BEGIN { printf "%.3f", 2.943275/atan2(0, -1) }'), in the limit of small steps. Within $saved_within
the duration needs $saved_linear updates instead of $saved_hertz. Of $((searches - 1)) other searches, with four quantities within 20 %, 10 %, 1 % and
0.1 %, none needs fewer updates with springs. Over thirteen angles of incidence
([linear-springs-angle.tsv](trades/linear-springs-angle.tsv), [the page](trades/linear-springs-angle.md)) the duration needs
$angle_linear_10 updates instead of $angle_hertz_10 within 10 %, and $angle_linear_01 instead of $angle_hertz_01 within 0.1 %. None of
$angle_searches searches for the restitution and for \$\\psi_2\$ needs fewer updates with springs.
Assemblies with linear springs have the right moduli at one pressure only
([linear-or-hertz](../cases/7-assemblies/linear-or-hertz.md)). The program needs no new feature: where a material has \$k_n\$ as well,
\`advise\` tries the springs.

![Six figures of the ways above: error or unbalanced force against cost, and strength against the cost of a preparation](trades/ways.svg)
TEXT
