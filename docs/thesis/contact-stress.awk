# Distribution of the contact stress: docs/thesis/fields.md. Reads one table of contacts that a snapshot has written, and
# prints, for the contacts in region A, the fractions within a tenth of the mean, within a standard deviation, and below
# a tenth of the mean.
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
!head {
  head = 1
  for (i = 1; i <= NF; i++) column[$i] = i
  next
}
$column["normal/N"] > 0 && $column["x/m"]^2 + $column["y/m"]^2 < radius[which]^2 {
  stress[++count] = $column["normal_stress/Pa"]
  sum += stress[count]
  squares += stress[count]^2
}
END {
  mean = sum / count
  deviation = sqrt(squares / count - mean * mean)
  for (k = 1; k <= count; k++) {
    near += stress[k] > 0.9 * mean && stress[k] < 1.1 * mean
    within += stress[k] > mean - deviation && stress[k] < mean + deviation
    low += stress[k] < 0.1 * mean
  }
  printf "%s\t%.3f\t%.3f\t%.3f\n", which, near / count, within / count, low / count
}
