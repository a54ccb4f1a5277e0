#!/bin/sh
# Tests whole outputs of `explain`, on pages with units. The numbers are computed by hand; comments say how. TAP.
# $NINEBALL is the program, ./nineball by default; $srcdir is the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
top=$(pwd)
cd "$work" || exit 1

# explained NAME TEXT [STATES]: `explain NAME.md` must print standard input. Measured times, the errors of ACCURACY.md and the numbers of
# attempts are not compared.
explained() {
  "$nineball" explain "$1.md" --isa plain --states "${3:-none}" 2>said |
    sed '/^cost/,$s/, [0-9.e-]* s$/, T s/; s/takes [0-9.e-]* us/takes T us/; s/verdict [0-9.e-]* s$/verdict T s/
      s/ in [0-9]* attempts/ in N attempts/; s/ the [0-9]* errors/ the N errors/; s/below [0-9.e-]* %/below E %/g; s/-[0-9a-f]\{16\}\.state/-HASH.state/; s/ *$//' >out
  test -s out && diff -u - out >"$why"
  result $? "$2"
}

# A pair of two materials has 2ab/(a + b), here 2 * 3 * 6/9 and 2 * 2 * 1/3 MN/m. The skin is a tenth of the mean radius, 13/4 mm. The
# small discs have m = 8 pi g: 2 (m/k)^(1/2) is shortest at the wall, and a collision, pi (m/(2k))^(1/2), between the two. Their dashpots
# slow the rotation with w = (6 k_s/m)^(1/2): the stable step is (2/w) ((1 + d^2)^(1/2) - d), d = 0.2 * 3^(1/2). The rectangle around all
# discs has the sides 26 and 44 mm. The servo may strain the box, so there is an affine motion.
cat >springs.md <<'END'
# Springs
```scene
units     si
material  rock  density 2000 kg/m3  kn 3 MN/m  ks 2 MN/m  friction 0.5  cohesion 7 N
material  lid   kn 6 MN/m  ks 1 MN/m
normal    linear
shear     linear
box       0 mm 0 mm  to 40 mm 60 mm  lid
disc      9 mm 8 mm  radius 2 mm  rock
disc      13.2 mm 8 mm  radius 2 mm  rock
disc      25 mm 44 mm  radius 6 mm  rock  velocity 1 m/s 0 m/s
disc      30 mm 20 mm  radius 3 mm  rock
damping   ratio 0.2
damping   walls stiffness 3 us
damping   mass 4 1/s
gravity   0 m/s2 -9 m/s2
region    A  all
region    C  circle 25 mm 44 mm  radius 10 mm
step      0.1 of stable
record    time A.stress.xx C.stress.yy energy.balance
stage     one
  servo   yy 5 kPa on box  through box  at most 1 1/s
  record  every 3 cycles
  cycles  7
stage     two
  box     strain 0.5 1/s -0.25 1/s
  material  rock friction 0.25
  ramp    pair rock lid kn 5 MN/m
  cycles  9
```
END
explained springs 'a page with springs' <<'END'
springs
particles
  4 particles, 4 walls
neighbour list
  1 pairs closer than 0.000325 m; rebuilt when a particle or wall has moved 0.0001625 m
loading and damping, at the start of the run
  line 16: gravity 0 m/s2 -9 m/s2
  damping ratio 0.2, line 13
  damping walls stiffness 3e-06 s, line 14
  mass-proportional damping 4 1/s, line 15
force passes at the start of the run, for each pair of materials
  rock with rock: 1 pair in the neighbour list; k_n 3e+06, k_s 2e+06, tan(phi) 0.5, c 7
    from stage `two` on (line 27): friction 0.25
    disc-disc, overlap and both increments
    normal linear                            line 6
    shear linear                             line 7
    dashpots, damping ratio                  line 13
    resolve, normal and shear
  rock with wall of lid: 0 pairs in the neighbour list; k_n 4e+06, k_s 1.33333e+06, tan(phi) 0, c 0
    in stage `two` linearly until its end (line 28): kn 5e+06
    disc-wall, overlap and normal increment
    single contact at wall vertices
    normal linear                            line 6
    dashpots, damping ratio                  line 13
    resolve, normal
    (no shear linear: the pair has neither friction nor cohesion)
hooks of the cycle, at the start of the run
  before the motion  energy balance
  after the motion   energy balance
  before the forces  stability check
  after the forces   energy balance
memory
  245 bytes a particle, 184 a contact (18 kept fields, 1 history variable of laws)
  1 block of up to 128 contacts, loops for plain, 1 thread
balances
  energy, updated every cycle by one thread
not used
  periodic cell, boundary
regions
  line 17: region A all: 4 particles now; area 0.001144 m2, that of the smallest rectangle around all particles, without the gaps at walls
  line 18: region C circle 25 mm 44 mm radius 10 mm: 1 particles now; area 0.000314159 m2
step
  6.51587e-06 s, line 19
  single contact, 2 sqrt(m/k): 0.000158533 s; the step is 0.041101 of it, the stable step 0.41101 of it
  stable: 6.51587e-05 s; the step is 0.1 of it; limited by rotation of particles 1 and 2
  collision, the shortest possible: 0.000203327 s; the step is 0.0320463 of it
  accuracy: with 16 to 32 steps per collision, half of the N errors in the cases were below E %, and 90 % of them below E % (docs/ACCURACY.md); for this page, use `nineball advise`
stages
  one, 7 cycles
    line 22: servo yy 5 kPa on box through box at most 1 1/s
    line 23: record every 3 cycles
    line 24: cycles 7
    gain of the servo: strain rate P = error/(2 B T), plus the time integral of P/(16 T); B is the bulk stiffness, T the travel time of a wave across the assembly; there are no contacts yet
  two, 9 cycles
    line 26: box strain 0.5 1/s -0.25 1/s
    line 27: material rock friction 0.25
    line 28: ramp pair rock lid kn 5 MN/m
    line 29: cycles 9
    a row every cycle: the `record` of stage `one` (line 23) holds only there
    line 26: xx +0.5 1/s: extension in x; yy -0.25 1/s: compression in y
cost
  16 cycles, 17 contact updates, T s
  a cycle with recording takes T us, measured just now; reading, start, reference, tables and verdict T s
END

# The effective modulus is 3/(2 (1 - 1/16)) GPa, the shear modulus G = 3/2.5 GPa, and G* = G/(2 (2 - 1/4)). The collision is that of
# [R89 4.28]: 2.94328 alpha/v, alpha = (5 m v^2/(4 K))^(2/5), K = 4/3 E* R^(1/2), with the reduced mass m and radius R. Rayleigh: pi R
# (density/G)^(1/2)/0.919402, with the root for nu = 0.25; the mean radius is 6.5 mm.
cat >spheres.md <<'END'
```scene
material  glass  density 2000 kg/m3  young 3 GPa  poisson 0.25 friction 0.1
normal    hertz
shear     mindlin
periodic cell 0 mm 0 mm to 60 mm 70 mm
sphere    10 mm 10 mm  radius 5 mm  glass  velocity 2 m/s 0 m/s
sphere    30 mm 10 mm  radius 8 mm  glass
region    A  all
step      0.1 of rayleigh
record    time A.stress.xx
stage     one
  cell    strain 0 1/s 0 1/s c21 -0.5 1/s
  cycles  7
stage     two
  cell    strain -2 1/s 0 1/s c12 0.25 1/s c21 0.25 1/s
  ramp    material glass friction 0.2
  cycles  8
stage     three
  cell    strain 0 1/s 0.5 1/s
  cycles  2
```
END
explained spheres 'a page with spheres in a cell' <<'END'
spheres
particles
  2 particles, 0 walls
neighbour list
  0 pairs closer than 0.00065 m; rebuilt when a particle or wall has moved 0.000325 m
force passes at the start of the run, for each pair of materials
  glass with glass: 0 pairs in the neighbour list; E* 1.6e+09, G* 3.42857e+08, tan(phi) 0.1, c 0
    in stage `two` linearly until its end (line 16): friction 0.2
    disc-image, overlap and both increments  line 5
    normal hertz                             line 3
    shear mindlin                            line 4
    large overlaps
    resolve, normal and shear
hooks of the cycle, at the start of the run
  before the forces  stability check
  after the forces   stability check of stiffening contacts
  after the forces   count of deep overlaps
memory
  149 bytes a particle, 124 a contact (9 kept fields, 1 history variable of laws)
  0 blocks of up to 128 contacts, loops for plain, 1 thread
not used
  dashpots, mass-proportional damping, balances of work and energy (96 bytes a particle), boundary, servo
regions
  line 8: region A all: 2 particles now; area 0.0042 m2, that of the cell
step
  2.20566e-06 s, line 9
  stable: unknown, elastic spheres without overlap have no stiffness
  collision, Hertz: 9.73208e-05 s, 44.1 steps; particle 1 and particle 2 at 2 m/s
  rayleigh, the travel time of a surface wave round half a sphere: smallest 2.20566e-05 s, mean 2.86736e-05 s; the step is 0.1 and 0.0769231 of it
  accuracy: with 32 to 64 steps per collision, half of the N errors in the cases were below E %, and 90 % of them below E % (docs/ACCURACY.md); for this page, use `nineball advise`
stages
  one, 7 cycles
    line 12: cell strain 0 1/s 0 1/s c21 -0.5 1/s
    line 13: cycles 7
    line 12: strain rate xx 0, c12 0, c21 -0.5, yy 0 1/s: simple shear, the engineering shear rate is -0.5 1/s; xy of a stress becomes positive
  two, 8 cycles
    line 15: cell strain -2 1/s 0 1/s c12 0.25 1/s c21 0.25 1/s
    line 16: ramp material glass friction 0.2
    line 17: cycles 8
    line 15: xx -2 1/s: compression in x
    line 15: strain rate xx -2, c12 0.25, c21 0.25, yy 0 1/s: pure shear, the engineering shear rate is twice c12, 0.5 1/s; simple shear at this rate is `c12 0.5 1/s`
  three, 2 cycles
    line 19: cell strain 0 1/s 0.5 1/s
    line 20: cycles 2
    line 19: yy +0.5 1/s: extension in y
cost
  17 cycles, 0 contact updates, T s
  a cycle with recording takes T us, measured just now; reading, start, reference, tables and verdict T s
spheres.md:4: warning: `shear mindlin` has no micro-slip at the edge of the contact, on which a collision without damping depends: the exact law is `shear mindlin_deresiewicz`
END

# Two pages that start one from the other, without states. Friction and stiffnesses are those at the end of stage `two`, where the ramp has
# ended; `soften` divides the stiffnesses by 3.
cat >on.md <<'END'
```scene
start springs stage two with refine=2 soften=3
record time
stage three
  record  every 3 cycles
  wall    south velocity 0 m/s 2 m/s
  until stage.time above 1 s at most 50 cycles
```
END
cat >further.md <<'END'
```scene
start on stage three
step 0.5 us
record time
stage four
  cycles 3
stage five
  servo   yy 5 kPa on box  through box  at most 1 1/s
  cycles 4
```
END
explained further 'a page whose state does not exist yet' <<'END'
further
start
  at the end of stage `three` of `on` (line 2)
    none/on-three-HASH.state: missing, will be computed
  at the end of stage `two` of `springs` with refine=2, soften=3 (line 2)
    none/springs-two-HASH.state: missing, will be computed
  `nineball check further.md` computes that state; then `explain` shows contacts, step and seconds, too
before stage `three` of `on` is run: laws and materials of its end, positions at time 0
particles
  4 particles, 4 walls
neighbour list
  1 pairs closer than 0.000325 m; rebuilt when a particle or wall has moved 0.0001625 m
loading and damping, at the start of the run
  line 2: start on stage three
  damping ratio 0.2, line 2
  damping walls stiffness 3e-06 s, line 2
  mass-proportional damping 4 1/s, line 2
force passes at the start of the run, for each pair of materials
  rock with rock: 1 pair in the neighbour list; k_n 1e+06, k_s 666667, tan(phi) 0.25, c 7
    disc-disc, overlap and both increments
    normal linear                            line 2
    shear linear                             line 2
    dashpots, damping ratio                  line 2
    resolve, normal and shear
  rock with wall of lid: 0 pairs in the neighbour list; k_n 1.66667e+06, k_s 444444, tan(phi) 0, c 0
    disc-wall, overlap and normal increment
    single contact at wall vertices
    normal linear                            line 2
    dashpots, damping ratio                  line 2
    resolve, normal
    (no shear linear: the pair has neither friction nor cohesion)
hooks of the cycle, at the start of the run
  before the forces  stability check
memory
  149 bytes a particle, 96 a contact (7 kept fields, 1 history variable of laws)
  1 block of up to 128 contacts, loops for plain, 1 thread
not used
  balances of work and energy (96 bytes a particle), periodic cell, boundary, regions
step
  5e-07 s
stages
  four, 3 cycles
    line 3: step 0.5 us
    line 4: record time
    line 6: cycles 3
    goes on from stage `three` of on, line 6: wall south velocity 0 m/s 2 m/s
  five, 4 cycles
    line 8: servo yy 5 kPa on box through box at most 1 1/s
    line 9: cycles 4
cost
  7 cycles
  the time of a cycle cannot be measured: the run begins with a state that does not exist yet
END

# A chain of three pages, first without states, then with one of them, then with both. Each disc has the mass pi. Stage `a` removes the
# third disc, so the region around the second and the third one has one particle. A shear force adds 8 bytes to a contact, rotation 16
# bytes to a particle, the affine motion 17, the removal 1. 2 (m/k)^(1/2) = 3.54491; two discs have 1/2^(1/2) of it, and a collision takes
# pi (m/(2k))^(1/2).
cat >first.md <<'END'
```scene
units     none
material  m  density 1  kn 1
material  n  density 1  kn 1
normal    linear
wall      w  0 -9 to 0 9  m
disc      5 5  radius 1  m
disc      5 7  radius 1  n
disc      5 9  radius 1  n
damping   mass 3
step      0.5
record    time
stage     z
  cycles  1
stage     a
  record  every 4 cycles
  shear   linear
  material n ks 1 friction 0.5
  wall    w velocity 1 0
  affine  strain 0.25 0
  damping mass 2
  remove  disc 3
  cycles  1
```
END
printf '```scene\nstart first stage a\nstep 0.25\nrecord time\nstage b\nrecord every 5 cycles\ncycles 2\n```\n' >second.md
cat >third.md <<'END'
```scene
start   second stage b
region  B  circle 5 8 radius 2.5
step    0.125
record  time
stage   c
  material n friction 0.75
  cycles 3
stage   d
  cycles 4
```
END
passes='  m with n: 1 pair in the neighbour list; k_n 1, k_s 0, tan(phi) 0, c 0
    disc-disc, overlap
    normal linear                            line 2
    resolve, normal
    (no shear linear: the pair has neither friction nor cohesion)
  n with n: 0 pairs in the neighbour list; k_n 1, k_s 1, tan(phi) 0.5, c 0
    from stage `c` on (line 7): friction 0.75
    disc-disc, overlap and both increments
    normal linear                            line 2
    shear linear                             line 2
    resolve, normal and shear
  m with wall of m: 0 pairs in the neighbour list; k_n 1, k_s 0, tan(phi) 0, c 0
    disc-wall, overlap
    normal linear                            line 2
    resolve, normal
    (no shear linear: the pair has neither friction nor cohesion)
  n with wall of m: 0 pairs in the neighbour list; k_n 1, k_s 0, tan(phi) 0, c 0
    disc-wall, overlap
    normal linear                            line 2
    resolve, normal
    (no shear linear: the pair has neither friction nor cohesion)'
stages='stages
  c, 3 cycles
    line 3: region B circle 5 8 radius 2.5
    line 4: step 0.125
    line 5: record time
    line 7: material n friction 0.75
    line 8: cycles 3
    goes on from stage `a` of first, line 20: affine strain 0.25 0
    goes on from stage `a` of first, line 19: wall w velocity 1 0
  d, 4 cycles
    line 10: cycles 4
    goes on from stage `a` of first, line 20: affine strain 0.25 0
    goes on from stage `a` of first, line 19: wall w velocity 1 0
cost'
# chain A B: the states of second.md and first.md are A and B; without the state of second.md the contacts of stage `a` are not known.
chain() {
  printf '%s\n' third start '  at the end of stage `b` of `second` (line 2)' "    states/second-b-HASH.state: $1" '  at the end of stage `a` of `first` (line 2)' "    states/first-a-HASH.state: $2"
  test "$1" = present || printf '%s\n' '  `nineball check third.md` computes that state; then `explain` shows contacts, step and seconds, too' \
    'before stage `b` of `second` is run: laws and materials of its end, positions at time 0'
}
for made in '' second third; do
  test -z "$made" || "$nineball" run $made.md --states states -o made >said 2>&1
  case $made in
  third)
    { chain present present && printf '%s\n' particles '  3 particles, 1 walls' 'neighbour list' '  1 pairs closer than 0.1; rebuilt when a particle or wall has moved 0.05' \
      'loading and damping, at the start of the run' '  mass-proportional damping 2, line 2' 'force passes at the start of the run, for each pair of materials' "$passes" \
      'hooks of the cycle, at the start of the run' '  before the motion  affine motion' '  before the forces  stability check' memory \
      '  150 bytes a particle, 60 a contact (3 kept fields, 1 history variable of laws)' '  1 block of up to 128 contacts, loops for plain, 1 thread' 'not used' \
      '  dashpots, balances of work and energy (96 bytes a particle), periodic cell, boundary, servo' regions \
      '  line 3: region B circle 5 8 radius 2.5: 1 particles now; area 19.635' step '  0.125, line 4' \
      '  single contact, 2 sqrt(m/k): 3.54491; the step is 0.0352618 of it, the stable step 0.707107 of it' \
      '  stable: 2.50663; the step is 0.0498678 of it; limited by normal motion of particles 1 and 2' \
      '  collision, the shortest possible: 3.9374; the step is 0.0317468 of it' "$stages"; } >wanted
    "$nineball" explain third.md --isa plain --states states 2>"$why" | sed '/^  accuracy/d; /^cost/q; s/-[0-9a-f]\{16\}\.state/-HASH.state/; s/ *$//' >out
    ;;
  *)
    if test -z "$made"; then chain 'missing, will be computed' 'missing, will be computed'; else chain 'missing, will be computed' present; fi >wanted
    { echo "$passes" | sed 's/n with n: 0 pairs/n with n: 1 pair/' && printf 'step\n  0.125\n%s\n' "$stages"; } >>wanted
    "$nineball" explain third.md --isa plain --states states 2>"$why" |
      sed '/^particles/,/^force passes/d; /^hooks/,/^  dashpots/d; /^cost/q; s/-[0-9a-f]\{16\}\.state/-HASH.state/; s/ *$//' >out
    ;;
  esac
  diff -u wanted out >>"$why"
  result $? "a chain of pages, after a run of ${made:-none}"
done

# Two discs of radius 4 mm do not fit into a circle of radius 7 mm; the small ones have space. Numbers count in the order of the lines.
printf 'x/mm\ty/mm\tradius/mm\n1\t1\t1\n4\t1\t1.5\n' >two.tsv
printf 'x/mm\ty/mm\tradius/mm\n30\t1\t1\n34\t1\t1.5\n38\t1\t1\n' >three.tsv
cat >placed.md <<'END'
```scene
material  rock  density 2000 kg/m3  kn 3 MN/m
grading   G  0.5 mm 3  4 mm 4
grading   H  1 mm 2
periodic cell 0 mm 0 mm to 60 mm 30 mm
disc      30 mm 10 mm  radius 1 mm  rock
packing   two.tsv discs rock
fill      discs circle 15 mm 20 mm radius 7 mm  G rock  seed 3  attempts 400  else skip
fill      spheres box 45 mm 10 mm to 50 mm 25 mm  H rock  seed 4  attempts 500  else stop
fill      discs cell  H rock  seed 5  attempts 60  else skip
packing   three.tsv spheres rock
step      0.1 of stable
record    time
stage     one
  cycles  1
```
END
"$nineball" explain placed.md 2>"$why" | sed '/^neighbour/,$d; s/ in [0-9]* attempts/ in N attempts/' | diff -u - /dev/fd/3 >>"$why" 3<<'END'
placed
particles
  14 particles, 0 walls
random fillings
  circle with G, seed 3: 4 of 7 particles placed in N attempts, particles 4 to 7 (line 8)
    radius 0.004 m: 1, 3 not placed, no space
    radius 0.0005 m: 3
  box with H, seed 4: 2 of 2 particles placed in N attempts, particles 8 to 9 (line 9)
    radius 0.001 m: 2
  cell with H, seed 5: 2 of 2 particles placed in N attempts, particles 10 to 11 (line 10)
    radius 0.001 m: 2
packings
  two.tsv: 2 particles, numbers 2 to 3 (line 7)
  three.tsv: 3 particles, numbers 12 to 14 (line 11)
END
result $? 'random fillings and packings'

# Without the state a step is known if it depends neither on contacts nor on velocities. The discs have m = 8 pi g. The shortest period is
# that of 5 MN/m at the wall, to which stage `two` ramps; the shortest collision, pi (m/(2k))^(1/2), is that of two discs with 3 MN/m.
for step in '0.25 of single-contact:  3.54491e-05 s' '0.25 of stable:  follows from that state' '2 us:  2e-06 s' '9 per collision:  2.25918e-05 s'; do
  printf '```scene\nstart springs stage two\nstep %s\nrecord time\nstage on\ncycles 1\n```\n' "${step%%:*}" >unknown.md
  "$nineball" explain unknown.md --states none 2>"$why" | tee -a "$why" | sed -n '/^step/{n;p;}' >out
  test "$(cat out)" = "${step#*:}"
  result $? "the step of a page whose state does not exist yet: ${step%%:*}"
done
# Without the state a stage with conditions has the cycles from its first test to its last one, which may be the first, too.
printf '```scene\nstart springs stage two\nrecord time\nstage on\nuntil stage.time above 1 s every 3 cycles at most 50 cycles\n```\n' >unknown.md
"$nineball" explain unknown.md --states none >out 2>"$why" && grep -qx '  on, 3 to 50 cycles: the condition on line 5 decides' out &&
  sed 's/every 3/every 99/' unknown.md >single.md && "$nineball" explain single.md --states none >out 2>"$why" && grep -qx '  on, 50 cycles' out
result $? 'the length of a stage whose state does not exist yet'
# A page whose step has no limit cannot be run, so no model shows what follows; `check` says why.
printf '```scene\nunits none\nmaterial m density 1\ndisc 0 0 radius 1 m\nstep 0.1 of single-contact\nrecord time\nstage a\ncycles 1\n```\n' >endless.md
printf '```scene\nstart endless stage a\nrecord time\nstage b\ncycles 1\n```\n' >beyond.md
"$nineball" explain beyond.md --states none >out 2>"$why" && test ! -s "$why" && test "$(wc -l <out)" -eq 5 && tail -n 1 out | grep -q 'check beyond.md` computes that state'
result $? 'a page that starts from one that cannot be run'
# Damping that the page before has ended is not used.
printf '```scene\nunits none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\ndisc 2 0 radius 1 m\nstep 0.1\nrecord time\nstage a\ndamping ratio 0.1\ndamping mass 1\ncycles 1\nstage b\ndamping none\ncycles 1\n```\n' >damped.md
printf '```scene\nstart damped stage b\nrecord time\nstage c\ncycles 1\n```\n' >undamped.md
"$nineball" explain undamped.md --states none >out 2>"$why" && sed -n '/^not used/{n;p;}' out | grep -q ', dashpots, mass-proportional damping, '
result $? 'damping that only the page before uses'
# Elastic spheres: the duration of a collision depends on the velocities, the Rayleigh step of `spheres` does not.
for step in '0.25 of rayleigh:  5.51415e-06 s' '9 per collision:  follows from that state'; do
  printf '```scene\nstart spheres stage three\nstep %s\nrecord time\nstage on\ncycles 1\n```\n' "${step%%:*}" >unknown.md
  "$nineball" explain unknown.md --states none 2>"$why" | tee -a "$why" | sed -n '/^step/{n;p;}' >out
  test "$(cat out)" = "${step#*:}"
  result $? "the step of elastic spheres whose state does not exist yet: ${step%%:*}"
done

printf '```scene\nunits none\nmaterial m density 1 young 1 poisson 0\nnormal hertz\nsphere 0 0 radius 1 m\ngravity 0 -9\nboundary circle 0 0 radius 9\nstep 0.1\nrecord time\n' >slowed.md
printf 'stage a\ndamping con1 0.125 as velocity\ndamping critical beyond overlap 2 %%\ndamping ratio 0.5\ncycles 1\n```\n' >>slowed.md
"$nineball" explain slowed.md 2>"$why" | sed -n '/^loading/,/^force/p' | diff -u - /dev/fd/3 >>"$why" 3<<'END'
loading and damping, at the start of the run
  line 7: boundary circle 0 0 radius 9
  line 6: gravity 0 -9
  damping ratio 0.5, line 13
  damping critical beyond overlap 2 %, line 12
  damping con1 0.125, line 11
force passes at the start of the run, for each pair of materials
END
result $? 'gravity, a boundary and three kinds of damping'
printf '```scene\nunits si\nmaterial m density 1 kg/m3 kn 1 N/m\ndisc 0 m 0 m radius 1 m m\n%%s\nstep 0.1 s\nrecord time\nstage a\ncycles 1\n```\n' >alone.md
for line in 'boundary circle 0 m 0 m radius 9 m=line 5: boundary circle 0 m 0 m radius 9 m' 'gravity 0 m/s2 -9 m/s2=line 5: gravity 0 m/s2 -9 m/s2' 'damping con1 0.125 as all=damping con1 0.125, line 5' \
  'damping mass 3 1/s=mass-proportional damping 3 1/s, line 5' 'damping ratio 0.5=damping ratio 0.5, line 5'; do
  sed "s,^%s$,${line%%=*}," alone.md >loaded.md
  "$nineball" explain loaded.md 2>"$why" | sed -n '/^loading/,/^force/p' | diff -u - /dev/fd/3 >>"$why" 3<<END
loading and damping, at the start of the run
  ${line#*=}
force passes at the start of the run, for each pair of materials
END
  result $? "one kind of loading or damping: ${line%%=*}"
done
sed '/^%s$/d' alone.md >lone.md # no `search` and no shear force that a message names
"$nineball" explain lone.md >out 2>"$why" && ! grep '(no shear\|inf' out &&
  grep -qx '  rotation (16 bytes a particle), shear forces, dashpots, mass-proportional damping, balances of work and energy (96 bytes a particle), search, periodic cell, boundary, servo, regions' out &&
  grep -qx '  116 bytes a particle (without rotation), 52 a contact (3 kept fields, 0 history variables of laws)' out
result $? 'what a page with one disc does not use'

# Shear forces are used, although only a later stage has a shear law. A step of --set has no line.
printf '```scene\nunits none\nmaterial m density 1 kn 1 ks 1 friction 1\ndisc 0 0 radius 1 m\ndisc 2 0 radius 1 m\nstep 0.1\nrecord time\n' >later.md
printf 'stage a\ncycles 1\nstage b\nshear linear\ncycles 1\n```\n' >>later.md
"$nineball" explain later.md --set step=0.25 >out 2>"$why" && grep -qx '  0.25, --set' out &&
  grep -qx '  dashpots, mass-proportional damping, balances of work and energy (96 bytes a particle), periodic cell, boundary, servo, regions' out
result $? 'a later shear law, and a step of --set'

# A pair of materials without `kn` has elastic moduli, also before a stage with an elastic law. Of the monitors only regions are regions.
sed 's/kn 1 ks 1/young 3 poisson 0/; s/disc/sphere/; s/^record .*/&\nmonitor D sphere 1\nregion A all/; s/^shear linear/normal hertz/' later.md >hertz.md
"$nineball" explain hertz.md >out 2>"$why" && grep -qx '  m with m: 1 pair in the neighbour list; E[*] 1.5, G[*] 0.375, tan(phi) 1, c 0' out &&
  test "$(sed -n '/^regions/,/^step/p' out | wc -l)" -eq 3
result $? 'a later elastic law, and a monitor that is no region'

# Choices among several stages, motions and conditions. A feature of one stage is used, also if a later stage ends it. The strain of the
# box replaces the motions of its four walls, not those of the walls before and after it. A shear rate c12 + c21 = 1/2 1/s reaches an
# engineering shear strain of 10 % in 0.2 s, 15 % in 0.3 s; 3e-3 per cycle reach 10 % in 34 cycles.
cat >several.md <<'END'
```scene
units     none
material  m  density 1  kn 3  ks 2
normal    linear
shear     linear
wall      before  -9 -9 to -9 99  m
box       0 0 to 40 60  m
wall      after  90 -9 to 90 99  m
disc      3 3  radius 1  m
disc      9 9  radius 1  m
step      0.1
record    time
stage     a
  record  every 3 cycles
  damping ratio 0.1
  damping mass 2
  material m friction 0.5
  wall    before spin 1
  wall    south velocity 0 1
  wall    east velocity 2 0
  wall    north velocity 0 3
  wall    west velocity 4 0
  wall    after velocity 0 -5
  cycles  1
stage     b
  damping none
  cycles  2
stage     c
  record  every 1 cycles
  box     strain 0 1
  cycles  3
stage     d
  cycles  4
stage     e
  record  every 4 cycles
  wall    before spin 0
  cycles  5
stage     f
  record  every 5 cycles
  wall    before velocity 1 0
  cycles  6
stage     g
  wall    before velocity 2 0
  cycles  7
```
END
"$nineball" explain several.md 2>"$why" | sed -n '/^not used/{p;n;p;}; /^stages/,/^cost/{/^cost/!p;}' | diff -u - /dev/fd/3 >>"$why" 3<<'END'
not used
  balances of work and energy (96 bytes a particle), periodic cell, boundary, servo, regions
stages
  a, 1 cycles
    line 14: record every 3 cycles
    line 15: damping ratio 0.1
    line 16: damping mass 2
    line 17: material m friction 0.5
    line 18: wall before spin 1
    line 19: wall south velocity 0 1
    line 20: wall east velocity 2 0
    line 21: wall north velocity 0 3
    line 22: wall west velocity 4 0
    line 23: wall after velocity 0 -5
    line 24: cycles 1
  b, 2 cycles
    line 26: damping none
    line 27: cycles 2
    a row every cycle: the `record` of stage `a` (line 14) holds only there
    goes on from stage `a`, line 18: wall before spin 1
    goes on from stage `a`, line 19: wall south velocity 0 1
    goes on from stage `a`, line 20: wall east velocity 2 0
    goes on from stage `a`, line 21: wall north velocity 0 3
    goes on from stage `a`, line 22: wall west velocity 4 0
    goes on from stage `a`, line 23: wall after velocity 0 -5
  c, 3 cycles
    line 29: record every 1 cycles
    line 30: box strain 0 1
    line 31: cycles 3
    goes on from stage `a`, line 18: wall before spin 1
    goes on from stage `a`, line 23: wall after velocity 0 -5
    line 30: yy +1: extension in y
  d, 4 cycles
    line 33: cycles 4
    goes on from stage `c`, line 30: box strain 0 1
    goes on from stage `a`, line 18: wall before spin 1
    goes on from stage `a`, line 23: wall after velocity 0 -5
  e, 5 cycles
    line 35: record every 4 cycles
    line 36: wall before spin 0
    line 37: cycles 5
    goes on from stage `c`, line 30: box strain 0 1
    goes on from stage `a`, line 23: wall after velocity 0 -5
  f, 6 cycles
    line 39: record every 5 cycles
    line 40: wall before velocity 1 0
    line 41: cycles 6
    goes on from stage `c`, line 30: box strain 0 1
    goes on from stage `a`, line 23: wall after velocity 0 -5
  g, 7 cycles
    line 43: wall before velocity 2 0
    line 44: cycles 7
    a row every cycle: the `record` of stage `f` (line 39) holds only there
    goes on from stage `c`, line 30: box strain 0 1
    goes on from stage `a`, line 23: wall after velocity 0 -5
END
result $? 'stages of which some have motions, strains, damping and records'
cat >until.md <<'END'
```scene
units     si
material  m  density 1 kg/m3  kn 3 N/m
periodic  cell 0 m 0 m to 9 m 9 m
disc      3 m 3 m  radius 1 m  m
region    A  all
step      1 us
record    time
stage     a
  cell    strain 0.1 1/s 0 1/s c12 0.3 1/s c21 0.2 1/s
  until   A.strain.xx above 7 % and cell.strain.xy above 10 % and A.strain.yy above 9 % and A.strain.xy above 15 % at most 9 cycles
stage     b
  cell    strain 0 per cycle 0 per cycle c12 -3e-3 per cycle
  until   cell.strain.xy below -10 % at most 9 cycles
stage     c
  cell    strain 0 1/s 0 1/s c12 0.5 1/s
  until   cell.strain.xy above -10 % and A.strain.xy above 20 % and A.stress.xy above 2 Pa at most 9 cycles
stage     d
  cell    strain 0 1/s 0 1/s c21 -0.5 1/s
  until   cell.strain.xy below 10 % and A.strain.xy below 0 and A.strain.xy below -20 % at most 9 cycles
```
END
"$nineball" explain until.md 2>"$why" | sed -n '/^stages/,/^cost/{/^cost/!p;}' | diff -u - /dev/fd/3 >>"$why" 3<<'END'
stages
  a, 1 to 9 cycles: the condition on line 11 decides
    line 10: cell strain 0.1 1/s 0 1/s c12 0.3 1/s c21 0.2 1/s
    line 11: until A.strain.xx above 7 % and cell.strain.xy above 10 % and A.strain.yy above 9 % and A.strain.xy above 15 % at most 9 cycles
    line 10: xx +0.1 1/s: extension in x
    line 10: strain rate xx 0.1, c12 0.3, c21 0.2, yy 0 1/s: shear with rotation, the engineering shear rate is 0.5 1/s; xy of a stress becomes negative
    line 11: `cell.strain.xy` is the component of the tensor, half the engineering shear strain; for an engineering shear strain of 10 % within this stage write `stage.time above 0.2 s`
    line 11: `A.strain.xy` is the component of the tensor, half the engineering shear strain; for an engineering shear strain of 15 % within this stage write `stage.time above 0.3 s`
  b, 1 to 9 cycles: the condition on line 14 decides
    line 13: cell strain 0 per cycle 0 per cycle c12 -3e-3 per cycle
    line 14: until cell.strain.xy below -10 % at most 9 cycles
    line 13: strain rate xx 0, c12 -0.003, c21 0, yy 0 per cycle: simple shear, the engineering shear rate is -0.003 per cycle; xy of a stress becomes positive
    line 14: `cell.strain.xy` is the component of the tensor, half the engineering shear strain; for an engineering shear strain of -10 % within this stage write `cycles 34`
  c, 1 to 9 cycles: the condition on line 17 decides
    line 16: cell strain 0 1/s 0 1/s c12 0.5 1/s
    line 17: until cell.strain.xy above -10 % and A.strain.xy above 20 % and A.stress.xy above 2 Pa at most 9 cycles
    line 16: strain rate xx 0, c12 0.5, c21 0, yy 0 1/s: simple shear, the engineering shear rate is 0.5 1/s; xy of a stress becomes negative
    line 17: `A.strain.xy` is the component of the tensor, half the engineering shear strain; for an engineering shear strain of 20 % within this stage write `stage.time above 0.4 s`
  d, 1 to 9 cycles: the condition on line 20 decides
    line 19: cell strain 0 1/s 0 1/s c21 -0.5 1/s
    line 20: until cell.strain.xy below 10 % and A.strain.xy below 0 and A.strain.xy below -20 % at most 9 cycles
    line 19: strain rate xx 0, c12 0, c21 -0.5, yy 0 1/s: simple shear, the engineering shear rate is -0.5 1/s; xy of a stress becomes positive
    line 20: `A.strain.xy` is the component of the tensor, half the engineering shear strain; for an engineering shear strain of -20 % within this stage write `stage.time above 0.4 s`
END
result $? 'conditions on shear strains, among others'
for rate in 'boundary strain' 'affine strain'; do
  printf '```scene\nunits si\nmaterial m density 1 kg/m3 kn 3 N/m\ndisc 3 m 3 m radius 1 m m\nregion A all\nboundary circle 0 m 0 m radius 9 m\nstep 1 us\nrecord time\nstage a\n%s 0 1/s 0 1/s c21 0.4 1/s\nuntil A.strain.xy above 10 %% at most 9 cycles\n```\n' "$rate" >shear.md
  "$nineball" explain shear.md >out 2>"$why"
  test "$(grep -c 'half the engineering' out)" -eq 1 && grep -qx '    line 11: `A.strain.xy` .* strain of 10 % within this stage write `stage.time above 0.25 s`' out &&
    grep -qx '    line 10: strain rate xx 0, c12 0, c21 0.4, yy 0 1/s: simple shear, the engineering shear rate is 0.4 1/s; xy of a stress becomes negative' out
  result $? "a condition on a shear strain: $rate"
done
# A rotation has no engineering shear rate, so no strain xy ends it.
sed 's/c21 0.4/c12 0.4 1\/s c21 -0.4/' shear.md >turned.md
"$nineball" explain turned.md >out 2>"$why" && ! grep 'half the engineering' out &&
  grep -qx '    line 10: strain rate xx 0, c12 0.4, c21 -0.4, yy 0 1/s: shear with rotation, the engineering shear rate is 0 1/s' out
result $? 'a rotation'

# Two materials with the moduli E_1, E_2: 1/E* is the sum of (1 - nu^2)/E, 1/G* that of 2 (2 - nu) (1 + nu)/E.
cat >elastic.md <<'END'
```contact-test
material  m  young 70 GPa  poisson 0.25  friction 0.3
material  n  young 7 GPa  poisson 0  friction 0.2
contact   sphere 2 mm m with wall n
normal    hertz
shear     mindlin
segment   press  normal to 2 N  in 10 steps
END
{ cat elastic.md && echo '```'; } >wall.md
explained wall 'a contact test of a sphere and a wall' <<'END'
wall
contact test
  sphere of m, radius 0.002 m, with a wall of n
  R* 0.002 m, E* 6.4e+09 Pa, G* 1.57746e+09 Pa, friction 0.2
laws
  normal hertz: elastic spheres, N = (4/3) E* R*^(1/2) overlap^(3/2) [R89 3.13], line 5
    0 history variables; reports its stored energy
  shear mindlin: elastic spheres without micro-slip (mindlin_deresiewicz has it): T += 8 G* a ds, |T| <= mu N + c [R89 3.27], line 6
    1 history variable; does not report stored energy; may create energy
segments
  press, 10 steps
    line 7: segment press normal to 2 N in 10 steps
cost
  10 steps, 10 contact updates, T s
  a step with recording takes T us, measured just now; reading, start, reference, tables and verdict T s
END
sed 's/^contact .*/contact disc 2 mm m with disc 3 mm n/; s/young 70.*friction/kn 3 MN\/m ks 2 MN\/m cohesion 4 N friction/
  s/young 7 .*friction/kn 6 MN\/m ks 1 MN\/m cohesion 5 N friction/; s/hertz/linear/; s/mindlin/linear/' wall.md >discs.md
"$nineball" explain discs.md >out 2>"$why" && grep -qx '  disc of m, radius 0.002 m, with disc of n, radius 0.003 m' out &&
  grep -qx '  k_n 4e+06, k_s 1.33333e+06, friction 0.2, cohesion 4' out
result $? 'a contact test of two discs'

sed 's/^segment  *press.*/sweep n 4 6\nsegment press normal to 2 N in $n steps/' wall.md >swept.md
"$nineball" explain swept.md 2>"$why" | sed -n '/^cost/,/^$/s/ contact updates.*//p; /^all 2 runs$/,$p' | sed 's/, [0-9.e-]* s$/, T s/; /warning/d' >out
printf '  %s\n' '4 steps, 4' '6 steps, 6' | sed '$a\all 2 runs\n  10 steps, 10 contact updates, T s' | diff -u - out >"$why"
result $? 'the cost of two contact tests'

# The arrays that a cycle uses, in bytes. Of a particle: 12 doubles and 5 integers; of a contact: a force of 3 doubles, 5 integers and a
# double for each field beyond two. The columns are: lines of the scene, quantities, lines of the stage, line after the stage; bytes of a
# particle and of a contact; number of fields; what else a page uses.
lean='rotation (16 bytes a particle), shear forces, dashpots, mass-proportional damping, balances of work and energy (96 bytes a particle), periodic cell, boundary, servo, regions'
while IFS='|' read -r scene quantity stage end particle contact kept less; do
  printf '```scene\nunits none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\ndisc 2 0 radius 1 m\ndisc 9 0 radius 1 m\n%b\nstep 0.1\n' "$scene" >bytes.md
  printf 'record time %s\nstage a\n%b\ncycles 1\n%b\n```\n' "$quantity" "$stage" "$end" >>bytes.md
  "$nineball" explain bytes.md >out 2>"$why"
  grep -q "^  $(($particle)) bytes a particle.*, $(($contact)) a contact (\($kept\) kept fields, " out &&
    grep -qxF "  $(echo "$lean" | sed "s/$less//; s/, \$//")" out && ! grep '(no shear none' out
  result $? "memory: $(echo "$scene$quantity$stage$end" | tr "\n" ";")"
done <<'END'
||||116|24+8+20|3|@
pair m m friction 1 ks 1\nshear linear||||116+16|24+8+20+8|3|rotation.*shear forces, 
damping ratio 0.1\ndamping centred||||116+32|24+16+20|4|dashpots, 
damping mass 0.1||||116|24+8+20|3|mass-proportional damping, 
||remove disc 1||116+1|24+8+20|3|@
boundary circle 0 0 radius 10||||116+17+8|24+8+20|3|boundary, 
boundary circle 0 0 radius 10||boundary stress 1 1||116+17+8+16|24+8+20|3|boundary, 
|work.balance|||116+96|24+8+20|3|balances[^)]*), 
|energy.balance|||116+96|24+88+20|13|balances[^)]*), 
|step.fracc|||116+8|24+8+20|3|@
||snapshot|stage b\ncycles 1\nsnapshot from a|116+24|24+72+20+8|11|@
periodic cell -9 -9 to 19 19||||116+17|24+8+20+16|3|periodic cell, 
||affine strain 1 1||116+17|24+8+20|3|@
box -9 -9 to 19 19 m||servo xx 1 on box through box at most 1||116+17|24+24+20+4|5|servo, 
region A all||||116|24+8+20|3|, regions
END
for balances in 'work.balance:work' 'energy.balance:energy' 'energy.balance work.balance:work and energy'; do
  printf '```scene\nunits none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nstep 0.1\nrecord %s\nstage a\ncycles 1\n```\n' "${balances%:*}" >balances.md
  "$nineball" explain balances.md >out 2>"$why" && grep -qx "  ${balances#*:}, updated every cycle by one thread" out
  result $? "the balances of ${balances#*:}"
done

# Reading a page counts: this filling takes most of the time, because most of its attempts find no space.
for attempts in 1 300000; do
  printf '```scene\nunits none\nmaterial m density 1 kn 1\ngrading g 1 90\nfill discs box 0 0 to 20 20 g m seed 1 attempts %s else skip\nstep 0.01\nrecord time\nstage a\ncycles 1\n```\n' $attempts >filled.md
  "$nineball" explain filled.md 2>"$why" | sed -n 's/^  a cycle.* verdict \([0-9.e-]*\) s$/\1/p'
done >out
awk 'NR == 1 { short = $1 } END { exit !(NR == 2 && short > 0 && $1 > 3*short) }' out
result $? 'the time of reading a page'
sed 's/attempts 300000/attempts 1/' filled.md >one.md
"$nineball" explain one.md 2>"$why" | grep -qx 'random fillings'
result $? 'a page with one filling'

# The passes run in the loops and the threads that the options name. A machine may lack the wider loops.
printf '```scene\nunits none\nmaterial m density 1 kn 1\nlattice discs 40 by 40 radius 1 m spacing 1.99 from 0 0\nstep 0.1\nrecord time\nstage a\ncycles 1\n```\n' >wide.md
for option in 'isa plain' 'isa avx2' 'isa avx512' 'threads 1' 'threads 2' 'threads 3'; do
  "$nineball" explain wide.md --${option% *} ${option#* } >out 2>"$why"
  case $option in
  isa*) grep -q 'this machine does not run' "$why" || grep -q ", loops for ${option#* }, 1 thread\$" out ;;
  *) grep -q ", ${option#* } threads*\$" out && { grep -q ' threads$' out || test "$option" = 'threads 1'; } ;;
  esac
  result $? "explain --$option"
done

# The history variables are those of both laws: `hertz_increment` has one, `mindlin` one, and `mindlin_deresiewicz` a row. A page without
# friction saves 8 bytes for each variable of its shear law.
for law in 'mindlin' 'mindlin_deresiewicz' 'mindlin_deresiewicz memory 8'; do
  for friction in 0 1; do
    printf '```scene\nunits none\nmaterial m density 1 young 1 poisson 0 friction %s\nnormal hertz_increment\nshear %s\nsphere 0 0 radius 1 m\nsphere 2 0 radius 1 m\nstep 0.1\nrecord time\nstage a\ncycles 1\n```\n' $friction "$law" >"smooth$friction.md"
    "$nineball" explain "smooth$friction.md" 2>"$why"
  done >out
  awk '/ history variables? of laws/ { sub(/.*fields, /, ""); n[++k] = $1 } / shear forces \(/ { sub(/.*shear forces \(/, ""); bytes = $1 }
    END { exit !(k == 2 && n[1] == 1 && n[2] > 1 && bytes == 8*(n[2] - 1)) }' out
  result $? "history variables of $law"
done

# The shortest collision is that of the spheres which the text names: 2.94328 alpha/v as in `spheres`, with neither the first particle
# nor the first wall.
cat >meet.md <<'END'
```scene
units none
material m density 1 young 1000 poisson 0.2
normal hertz
wall w -9 0 to 9 0 m
wall v 9 0 to 9 9 m
sphere 0 7 radius 1 m
sphere 3 3 radius 1 m velocity 2 0
sphere 20 20 radius 1 m
sphere 30 20 radius 1 m velocity -9 0
step 0.01
record time
stage a
cycles 1
```
END
"$nineball" explain meet.md >out 2>"$why" && grep -Eqx '  collision, Hertz: 0.233733, 23.4 steps; particle (3 and particle 4|4 and particle 3) at 9' out &&
  sed 's/velocity -9 0/fixed/' meet.md >rests.md && "$nineball" explain rests.md >out 2>"$why" && grep -qx '  collision, Hertz: 0.362718, 36.3 steps; particle 2 and wall v at 2' out
result $? 'the names of those that collide'

# The rows of errors are for numbers of steps from 2^k up to 2^(k + 1), without this end. Their numbers are those of the table, in %.
sed -n 's/^{\(.*\)},$/\1/p' "$top/src/report/accuracy_rows.h" | while IFS=', ' read -r steps count half most; do
  "$nineball" explain springs.md --set step="$steps per collision" 2>"$why" | sed -n 's/^  accuracy: with \(.*\) (docs.*/\1/p'
  awk "BEGIN { printf \"$steps to %d steps per collision, half of the $count errors in the cases were below %.3g %%, and 90 %% of them below %.3g %%\\n\", 2*$steps, 100*$half, 100*$most }" >&3
done >out 3>wanted
test "$(wc -l <wanted)" -ge 8 && diff -u wanted out >>"$why"
result $? 'errors at the edges of all rows'

# Spheres that overlap have a stiffness, so there is a stable step: N' = 2 E* (R* overlap)^(1/2) with the modulus E* = 1000/(2 * 0.96), and
# 2 (m/(2 N'))^(1/2) with m = 4 pi/3.
sed 's/^sphere 20 20.*/sphere 28.1 20 radius 1 m/; s/velocity -9 0//' meet.md >pressed.md
"$nineball" explain pressed.md >out 2>"$why" && grep -qx '  stable: 0.18965; .* limited by normal motion of particles 3 and 4' out && ! grep 'stable: unknown' out
result $? 'the stable step of spheres that overlap'

# A law with stiffnesses shows them; where a pair has none and only a later stage has an elastic law, the moduli are shown.
cat >later.md <<'END'
```scene
units none
material m density 1 kn 3 young 100 poisson 0
material n density 1 young 100 poisson 0
sphere 0 0 radius 1 m
sphere 5 0 radius 1 n
sphere 9 9 radius 1 m
step 0.01
record time
stage a
cycles 1
stage b
normal hertz
cycles 2
```
END
"$nineball" explain later.md 2>"$why" | grep ' with [mn]: ' | diff -u - /dev/fd/3 >>"$why" 3<<'END'
  m with m: 0 pairs in the neighbour list; k_n 3, k_s 0, tan(phi) 0, c 0
  m with n: 0 pairs in the neighbour list; E* 50, G* 12.5, tan(phi) 0, c 0
END
result $? 'a pair that has no stiffness before its elastic law'
"$nineball" explain later.md --set normal=hertz 2>"$why" | grep -c ' with [mn]: .*; E[*] 50, G[*] 12.5, ' >out && test "$(cat out)" -eq 2
result $? 'an elastic law does not use the stiffness of a material'

# The changes of each stage, also of the first one. A value that stays as it was is not shown. Between two materials the friction is the
# smaller one, so that of `m` alone changes nothing between `m` and `n`.
cat >changes.md <<'END'
```scene
units none
material m density 1 kn 3
material n density 1
disc 0 0 radius 1 n
disc 5 0 radius 1 m
disc 9 9 radius 1 m
disc 19 9 radius 1 n
step 1 of stable
record time
stage a
material m friction 0.5
cycles 1
stage b
material m friction 0.5 kn 4
pair m n kn 2
material n friction 0.75
cycles 1
```
END
"$nineball" explain changes.md 2>"$why" >changed && sed -n '/^force/,/^hooks/p' changed | grep ' with \|stage' | diff -u - /dev/fd/3 >>"$why" 3<<'END'
  m with m: 0 pairs in the neighbour list; k_n 3, k_s 0, tan(phi) 0, c 0
    from stage `a` on (line 12): friction 0.5
    from stage `b` on (line 15): kn 4
  m with n: 0 pairs in the neighbour list; k_n 0, k_s 0, tan(phi) 0, c 0
    from stage `b` on (line 16): kn 2
    from stage `b` on (line 17): friction 0.5
  n with n: 0 pairs in the neighbour list; k_n 0, k_s 0, tan(phi) 0, c 0
    from stage `b` on (line 17): friction 0.75
END
result $? 'the changes of two stages'
# A step at its limit is stable. Two discs of mass pi with k = 3: 2 (m/(2k))^(1/2).
grep -qx '  stable: 1.4472; the step is 1 of it; limited by normal motion of particles 2 and 3, as if they touched' changed
result $? 'a step at its limit'
# A page that starts at the end of the first stage has its changes, also before this stage is run.
printf '```scene\nstart changes stage a\nrecord time\nstage c\ncycles 1\n```\n' >changed.md
"$nineball" explain changed.md --states none 2>"$why" | sed '/^particles/,/^force/d; s/-[0-9a-f]\{16\}\.state/-HASH.state/; /^  m with m/q' | diff -u - /dev/fd/3 >>"$why" 3<<'END'
changed
start
  at the end of stage `a` of `changes` (line 2)
    none/changes-a-HASH.state: missing, will be computed
  `nineball check changed.md` computes that state; then `explain` shows contacts, step and seconds, too
before stage `a` of `changes` is run: laws and materials of its end, positions at time 0
  m with m: 0 pairs in the neighbour list; k_n 3, k_s 0, tan(phi) 0.5, c 0
END
result $? 'the changes of the first stage of another page'

# The trial ends in stage `a`. The steps of later stages that the page gives are known all the same: 1.1 takes 5 steps of 0.25. The
# step of stage `d` follows from a trial, so its number of cycles is about that with the step before.
cat >early.md <<'END'
```scene
units none
material m density 1 kn 1
disc 0 0 radius 1 m
monitor D disc 1
step 0.5
record time D.x
stage a
until D.x above 3 at most 10 cycles
stage b
step 0.25
until stage.time above 1.1 at most 50 cycles
stage c
until stage.time above 1.1 at most 50 cycles
stage d
step 0.1 of single-contact
until stage.time above 1.1 at most 50 cycles
stage e
until stage.time below 1.1 at most 50 cycles
```
END
"$nineball" explain early.md 2>"$why" | sed -n 's/^  \([a-e]\), /\1: /p' | diff -u - /dev/fd/3 >>"$why" 3<<'END'
a: 1 to 10 cycles: the condition on line 9 decides
b: 5 cycles
c: 5 cycles
d: about 5 cycles
e: 1 to 50 cycles: the condition on line 19 decides
END
result $? 'the lengths of stages that the trial does not reach'

# The step of stage `b` is known before the run, unless it depends on contacts and velocities, or on what stage `a` changes or removes. A
# tenth of 2 (m/k)^(1/2) is 0.177 with the small disc, and 0.354 without it.
while IFS='|' read -r change step wanted; do
  printf '```scene\nunits none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\ndisc 9 0 radius 0.5 m\nstep 0.01\nrecord time\n' >known.md
  printf 'stage a\n%s\ncycles 2\nstage b\nstep %s\nuntil stage.time above 1.1 at most 500 cycles\n```\n' "$change" "$step" >>known.md
  "$nineball" explain known.md 2>"$why" | sed -n '/^  b, /{s///; s/about [0-9]*/about N/; s/ cycles$//p;}' >out
  echo "$wanted" | diff -u - out >>"$why"
  result $? "the length of a stage: $change, step $step"
done <<'END'
zero velocities|0.1 of single-contact|7
remove disc 2|0.1 of single-contact|about N
material m kn 2|0.1 of single-contact|about N
remove disc 2|0.25|5
material m kn 2|0.25|5
zero velocities|0.1 of stable|about N
zero velocities|6 per collision|about N
END

# Both warnings of the start of a run: a deep overlap, and a coordinate whose resolution is 0.2 % of the mean overlap.
printf '```scene\nunits none\nmaterial m density 1 kn 1\ndisc 9e12 0 radius 1 m\ndisc 9e12 1 radius 1 m\nstep 0.01\nrecord time\nstage a\ncycles 1\n```\n' >doubtful.md
"$nineball" explain doubtful.md >out 2>"$why" && grep -q '^doubtful.md:5: warning: particle 2 overlaps particle 1 (line 4) too much at the start: by 1, 50 %' out && grep -q '^doubtful.md:4: warning: particle 1: its coordinate 9e+12 ' out
result $? 'two warnings of the start'

sed 's/^segment .*/segment slide shear to 9 N hold normal in 9 steps/' wall.md >slides.md
"$nineball" explain slides.md >out 2>"$why" && sed -n '/^cost/,$p' out | grep -qx '  the time of a step cannot be measured: segment `slide` (line 7), step 1 of 9: a shear force of 1 N cannot be reached; .*' && ! grep 'will be aborted' out
result $? 'a contact test that fails in its first step'

# The trial was aborted before it shortened a stage, so the run will be, too. A trial that shortened one says nothing.
for page in unreachable overlap; do
  "$nineball" explain "$top/tests/aborted/$page.md" >out 2>"$why" &&
    message=$(sed -n 's/^.*: run aborted: //p' "$top/tests/aborted/$page.md") && test -n "$message" &&
    grep -qxF "  the run will be aborted: $message" out
  result $? "explain $page.md: the run will be aborted"
done
printf '```scene\nunits none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nmonitor D disc 1\nstep 1e-3\nrecord time\nstage a\nrecord every 1000000 cycles\ncycles 100000000\nstage b\nuntil D.x above 1 at most 10 cycles\n```\n' >late.md
"$nineball" explain late.md >out 2>"$why" && grep -q 'measured just now' out && ! grep 'will be aborted' out
result $? 'a trial that shortened a stage before it was aborted'

# A contact test warns of friction that has no effect, as a scene does; the contact is between two materials, or one and itself.
for pair in 'disc 1 n:`m` and `n`' 'wall m:`m` and `m`'; do
  printf '```contact-test\nunits none\nmaterial m kn 1 ks 0 friction 0.3\nmaterial n kn 1 ks 1 friction 0.2\ncontact disc 1 m with %s\nshear linear\nsegment a slip by 1 overlap to 1\n```\n' "${pair%%:*}" >frictionless.md
  "$nineball" explain frictionless.md >out 2>"$why" && grep -qF "frictionless.md:3: warning: friction between ${pair#*:} has no effect: their shear stiffness \`ks\` is 0" out
  result $? "a contact test without shear stiffness: ${pair%%:*}"
done

# The seconds of each run are its cycles times the time of a cycle, plus the rest that is printed; the last line sums the runs. The lattice
# has 180 contacts. The time of a cycle agrees with that of a run within a factor of 5.
cat >timed.md <<'END'
```scene
units none
sweep n 20000 50000
material m density 1 kn 100
lattice discs 10 by 10 radius 1 m spacing 2 from 0 0
step 0.1 of stable
record time
stage a
record every 100 cycles
cycles $n
```
END
for try in 1 2 3; do # a busy machine may count too much time
  "$nineball" explain timed.md >out 2>"$why" && "$nineball" run timed.md -o timed --jobs 1 >ran 2>>"$why"
  awk '
  function differs(a, b) { return a > 1.015*b || b > 1.015*a }
  FNR == NR && /^  [0-9]* cycles, .* s$/ { cycles = $1; seconds = $(NF - 1); updates = $3; all_cycles += $1; all += seconds; all_updates += updates; runs++ }
  FNR == NR && /^all 2 runs$/ { sum = runs; expected = all; wanted = all_cycles; most = all_updates }
  FNR == NR && /^  a cycle with recording takes/ {
    bad += differs(seconds, cycles*$6/1e6 + $(NF - 1)) || !($(NF - 1) > 0 && $(NF - 1) < seconds) || cycles != (++shown == 1 ? 20000 : 50000) || differs(updates, 180*cycles) }
  FNR != NR && / cycles, / { took = $(NF - 1); bad += $1 != wanted }
  END { bad += sum != 2 || runs != 3 || all_cycles != 140000 || differs(seconds, expected) || differs(updates, most) || took > 5*seconds || seconds > 5*took; exit !!bad }' out ran
  status=$?
  test $status -eq 0 && break
done
cat out ran >"$why"
result $status 'the expected time of two runs'
echo "1..$n"
