#!/bin/sh
# Writes docs/EXTREMES.md: the messages of tests/aborted, and the long runs of docs/extremes/endurance.tsv.
#
#   docs/extremes.sh >FILE
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu
LC_ALL=C
export LC_ALL
cd "$(dirname "$0")/.."

cat <<'TEXT'
# Physics at the extremes

`make extremes` writes this document ([extremes.sh](extremes.sh)). It lists the range in which the program has
been tested, the messages of aborted runs, and how rounding errors add up in long runs. [STABILITY](STABILITY.md) has
maps of time steps, and [ROUNDING](ROUNDING.md) has results under other rounding modes.

## The tested range

| what | from | to | test |
| --- | --- | --- | --- |
| radius | 1 μm | 1 km | [hertz-range](../cases/2-hertz/hertz-range.md) |
| Young's modulus | 1 kPa | 1 TPa | [hertz-range](../cases/2-hertz/hertz-range.md) |
| speed of an impact | 0.01 nm/s | 1 km/s | [hertz-range](../cases/2-hertz/hertz-range.md) and [hertz-contrast](../cases/2-hertz/hertz-contrast.md) |
| greatest overlap over radius | 1e-12 | 0.45 | [hertz-contrast](../cases/2-hertz/hertz-contrast.md) and [hertz-range](../cases/2-hertz/hertz-range.md) |
| factors on lengths, speeds and stiffnesses, with results equal to the bit | 2⁻²⁰, 2⁻³⁰, 2⁻¹⁰⁰ | 2¹⁰, 2³⁰, 2¹⁰⁰ | [invariance-scale](../cases/5-numerics/invariance-scale.md) |
| ratio of radii | 1 | 1000 | [hertz-contrast](../cases/2-hertz/hertz-contrast.md) |
| ratio of masses | 1 | 10¹⁵ | [hertz-contrast](../cases/2-hertz/hertz-contrast.md) |
| ratio of moduli, of two spheres and within a row | 1 | 10⁶ | [hertz-contrast](../cases/2-hertz/hertz-contrast.md) and [stiff-in-soft](../cases/2-hertz/stiff-in-soft.md) |
| Poisson's ratio | 0 | 0.5 | [hertz-contrast](../cases/2-hertz/hertz-contrast.md) |
| friction | 0 | 10⁶ | [frictionless](../cases/4-oblique/frictionless.md) and [friction-extremes](../cases/4-oblique/friction-extremes.md) |
| cohesion over the largest shear force | 0 | 10¹⁹⁵ | [cohesion](../cases/1-two-discs/cohesion.md) and [glancing-discs](../cases/5-numerics/glancing-discs.md) |
| angle of incidence | 0.001° | 89.999° | [friction-extremes](../cases/4-oblique/friction-extremes.md) |
| surface speed of a spinning sphere over the speed of its centre | 0 | 10⁵ | [friction-extremes](../cases/4-oblique/friction-extremes.md) |
| opening angle of a wedge of two walls, with a common end or crossing | 0.2° | 179.8° | [wedge](../cases/1-two-discs/wedge.md) |
| impact parameter at the end of a wall over the radius | 0 | 0.999 | [wall-end](../cases/1-two-discs/wall-end.md) |
| cycles of one particle or contact | 1000 | 10⁹ | [endurance.c](../tests/endurance.c), below |

The range ends where the overlap exceeds the smaller radius, or where the overlap is no longer large compared with the
rounding error of the coordinates, about 1e-16 of their size.

## Messages of aborted runs, errors and warnings

Each message names what failed, and the particle, the moment and the limit where they exist. Each page below
causes the messages that follow it, and [aborted.sh](../tests/aborted.sh) requires exactly these words. The same test
requires a page for each message in the sources that aborts a run. The exit
status is 3 if the run was aborted, 2 if it could not begin, and 0 after a warning.

TEXT
for page in tests/aborted/*.md; do
  awk -v file="$page" '
    /^# / { title = substr($0, 3); next }
    /^```message/ { status = $2; message = 1; next }
    /^```/ { if (!scene) text = prose; scene = !scene; message = 0; next }
    message { messages = messages (messages ? "\n" : "") $0; next }
    !scene && NF { prose = prose (prose ? " " : "") $0 }
    END { printf "**[%s](../%s)**, status %d. %s\n\n```text\n%s\n```\n\n", title, file, status, text, messages }' "$page" |
    sed "s|^tests/aborted/||"
done | fold -s -w 118 | sed 's/ *$//'
cat <<'TEXT'
Without `allow unstable` a run is aborted as soon as its step exceeds the guaranteed stable one. With `allow unstable`
there is a range of steps in which the result is wrong and no message appears. At a hundred times the Rayleigh step the
ejected sphere still moves by less than a radius per step. [STABILITY](STABILITY.md#just-above-the-limit) shows which
quantities reveal the error.

## Long runs

One particle or one contact runs for up to 10⁹ cycles ([endurance.c](../tests/endurance.c)); the last row of the table
has the number of cycles of this document's run. N is the number of cycles, ε = 2.2e-16.

- **oscillation**: a disc oscillates between two walls and never leaves them. The scheme has an exact solution, from which the
  phase and the amplitude deviate by rounding alone. The phase drifts as ε N/80, because the rounded step and stiffness
  have the same error in all cycles. The amplitude drifts like a random walk, about 0.4 ε √N, and from 10⁷ cycles on as
  ε N/2000: the rounding of a periodic motion is not quite random.
- **bounce**: a disc bounces on a floor. The scheme, not rounding, causes the drift of the energy. The error of a bounce
  is of the order of $(\omega \Delta t)^{5/2}$, with a sign that depends on where in a step the contact begins. It adds
  up as the square root of the number of bounces. The work balance, kinetic energy minus the work of
  all forces (`work.balance`), has no such error. It drifts by rounding.
- **loop**: the tangential displacement of two spheres follows a closed loop of 40 steps. The forces at the end of each
  loop drift as ε N/40. The 40 increments are rounded, so their sum is not quite zero.

![Drift against the number of cycles, with the lines of a random walk and of a constant error](extremes/endurance.svg)

The phase is in radians. The other drifts are fractions of the squared amplitude, of the initial energy, and of the friction
limit.

TEXT
awk -F '\t' '
  NR == 1 { printf "| cycles |"; for (k = 2; k <= NF; k++) printf " %s |", $k; printf "\n|"; for (k = 1; k <= NF; k++) printf " --- |"; print ""; next }
  { most = $0 }
  $1 >= next_one { line($0) }
  function line(text,   field, k) {
    n = split(text, field, "\t")
    printf "| %.2g |", field[1]
    for (k = 2; k <= n; k++) printf " %.1e |", field[k] < 0 ? -field[k] : field[k]
    print ""
    last = text
    next_one = field[1] * 9
  }
  END { if (last != most) line(most) }' docs/extremes/endurance.tsv
cat <<'TEXT'

The program that writes the table fails if a drift is above its bound in any row. The bounds are ε N/2 for the phase and
the forces, and 10 ε √N + ε N/500 for the amplitude and the work balance. The bound of the energy is
$(\omega \Delta t)^{5/2}$ times the root of the number of bounces. `make check` runs a million cycles, and once more with
planted errors of 1e-6, which all six bounds must detect.
TEXT
