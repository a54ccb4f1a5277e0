#!/bin/sh
# What softer spheres and faster loading do to a shear test: prints two paragraphs of docs/TRADES.md from softness.tsv in this folder.
#
#   docs/trades/softness.sh           prints them
#   docs/trades/softness.sh --run     writes the table first, from a run of cases/7-assemblies/softness-price.md: three minutes.
#                                     $NINEBALL is the program
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu
LC_ALL=C
export LC_ALL
top=$(cd "$(dirname "$0")/../.." && pwd)

if [ "${1:-}" = --run ]; then
  nineball=$(cd "$(dirname "${NINEBALL:-./nineball}")" && pwd)/$(basename "${NINEBALL:-./nineball}")
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  "$nineball" run "$top/cases/7-assemblies/softness-price.md" -o "$work/out" --states "$work/states" >"$work/said" || { cat "$work/said" >&2; exit 1; }
  {
    echo '# softness-price: Young modulus divided by soft, rate times speed; means over the second half of the test, cycles with preparation.'
    echo '# command: docs/trades/softness.sh --run'
    awk -F '\t' -v OFS='\t' '
      /^#/ { next }
      !head { for (k = 1; k <= NF; k++) at[$k] = k; head = 1; print "soft", "speed", "seed", "coordination", "porosity", "sinphi", "cycles"; next }
      { print $at["soft/-"], $at["speed/-"], $at["seed/-"], $at["A.coordination mean in late/-"], $at["A.porosity mean in late/-"],
          $at["A.stress.sinphi mean in late/-"], $at["cycle in late/-"] }' "$work/out/values.tsv"
  } >"$work/table"
  cp "$work/table" "$top/docs/trades/softness.tsv"
fi

# Means over eight realizations, and the half-width of the 95 % confidence interval of a mean of paired differences (Student, 7 degrees of
# freedom).
grep -v '^#' "$top/docs/trades/softness.tsv" | awk -F '\t' '
  NR == 1 { next }
  { run = $1 " " $2; seeds[$3]; n[run]++; z[run] += $4; void[run] += $5; cycles[run] += $7; phi[run, $3] = $6 }
  function ratio(a, b) { return cycles[a]/cycles[b] }
  function difference(a, b, s, sum, squares, m, d) {
    for (s in seeds) { m++; sum += phi[a, s] - phi[b, s] }
    for (s in seeds) { d = phi[a, s] - phi[b, s] - sum/m; squares += d*d }
    if (m != 8) { print "expected 8 realizations, found " m >"/dev/stderr"; exit 1 }
    d = sprintf("%+.3f ± %.3f", sum/m, 2.3646*sqrt(squares/(m - 1)/m))
    sub(/^-/, "−", d)
    return d
  }
  END {
    glass = "1 1"
    printf "**Softer spheres in a shear test.** With a tenth, a hundredth and a thousandth of Young'"'"'s modulus the preparation and shear of 300 spheres\n"
    printf "need %.1f, %.1f and %.1f times fewer cycles ([softness-price](../cases/7-assemblies/softness-price.md),\n", ratio(glass, "10 1"), ratio(glass, "100 1"), ratio(glass, "1000 1")
    printf "[softness.tsv](trades/softness.tsv), eight realizations). In the second half of the test the mean coordination number rises from %.2f to %.2f, %.2f and\n", z[glass]/8, z["10 1"]/8, z["100 1"]/8
    printf "%.2f, and the porosity falls from %.3f to %.3f, %.3f and %.3f. $\\sin \\Phi$ changes less clearly, by\n", z["1000 1"]/8, void[glass]/8, void["10 1"]/8, void["100 1"]/8, void["1000 1"]/8
    printf "%s, %s and %s (95 %% confidence).\n\n", difference("10 1", glass), difference("100 1", glass), difference("1000 1", glass)
    printf "**Faster loading.** At 3, 10 and 100 times the rate the same preparation and test of glass need %.1f, %.1f and %.1f times fewer\n", ratio(glass, "1 3"), ratio(glass, "1 10"), ratio(glass, "1 100")
    printf "cycles. In the second half of the test $\\sin \\Phi$ changes by %s, %s and %s. The preparation still needs all its cycles;\n", difference("1 3", glass), difference("1 10", glass), difference("1 100", glass)
    printf "[preparation-price](../cases/7-assemblies/preparation-price.md) varies its rates.\n"
  }'
