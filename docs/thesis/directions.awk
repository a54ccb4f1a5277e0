# Sliding contacts by direction: docs/thesis/obliquity-and-sliding.md. Reads tables of contacts that snapshots have
# written. A contact is along extension (x) or compression (y) if its normal is within 22.5 degrees of the axis, else
# oblique: these are a quarter, a quarter and a half of all directions. It slides at 0.99 of its friction limit.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

# Radius of region A, 0.85 of the mean radius of the boundary, m.
BEGIN {
  FS = "\t"
  radius["uniform"] = 0.0134
  radius["graded"] = 0.0138
}
/^# run which=/ { split($0, part, /[=,]/); which = part[2]; next }
/^#/ { next }
!(FILENAME in head) {
  head[FILENAME] = 1
  for (i = 1; i <= NF; i++) column[$i] = i
  names = names (index(" " names, " " which " ") ? "" : which " ")
  runs[which]++
  run = which SUBSEP runs[which]
  next
}
$column["normal/N"] <= 0 || $column["x/m"]^2 + $column["y/m"]^2 > radius[which]^2 { next }
{
  cos2 = $column["ex/-"]^2 - $column["ey/-"]^2
  class = cos2 > sqrt(0.5) ? "extension" : cos2 < -sqrt(0.5) ? "compression" : "oblique"
  contacts[run, class]++
  if (($column["shear/N"] < 0 ? -1 : 1) * $column["shear/N"] >= 0.99 * $column["limit/N"]) {
    sliding[run, class]++
    slides[run]++
  }
}
# Prints mean and standard deviation over the runs of an assembly.
function statistics(what, which, class,    k, x, sum, squares) {
  for (k = 1; k <= runs[which]; k++) {
    x = sliding[which, k, class] / (what == "of sliding" ? slides[which, k] : contacts[which, k, class]) * 100
    sum += x; squares += x * x
  }
  sum /= runs[which]
  printf "%s\t%s\t%s\t%.1f\t%.1f\n", which, class, what, sum, sqrt((squares / runs[which] - sum * sum) * runs[which] / (runs[which] - 1))
}
END {
  print "which\tdirection\tper cent\tmean\tstandard deviation"
  count = split(names, assembly, " ")
  for (a = 1; a <= count; a++) {
    statistics("of sliding", assembly[a], "oblique")
    for (k = split("compression oblique extension", way, " "); k > 0; k--) statistics("that slide", assembly[a], way[k])
  }
}
