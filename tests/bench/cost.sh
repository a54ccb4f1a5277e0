#!/bin/sh
# Measures the cost of each feature in a cycle, and proves that a page which does not use a feature does not pay for it.
#
#   cost.sh -o FILE             all pages, with times: writes the document FILE
#   cost.sh --proof PAGE ...    only the proof, for these pages of the table below ("all": every page)
#   cost.sh --page PAGE         prints this page
#   cost.sh --laws DOCUMENT     prints plots/law-costs.gp, from the times in the document
#
#   NINEBALL   the program, built with -g            srcdir   top of the source tree
#   SIDE       particles on a side, 32               CYCLES   cycles of the measured window, 200
#   FLAGS      the compiler and its flags, for the document
#
# Exit status: 0 the proof holds, 1 it does not, 2 wrong use, 77 something that it needs is missing.
#
# Every page runs twice under callgrind, with CYCLES and with twice as many cycles. The difference of the two profiles is
# the cost of the second half, because reading, start, later stages and end are the same in both runs. Callgrind attributes
# each instruction to its source line, also in inlined functions. It is an error if a page executes a line of
# a file that belongs only to features that the page does not use. It is also an error if a file of the simulator
# belongs to no feature, or if a page executes no line of a feature that it uses.
#
# Counts repeat exactly. Callgrind 3.19 knows AVX2 but not AVX-512.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu
LC_ALL=C
export LC_ALL
awk=${AWK:-awk}
nineball=$(cd "$(dirname "${NINEBALL:-./nineball}")" && pwd)/$(basename "${NINEBALL:-./nineball}")
top=$(cd "${srcdir:-.}" && pwd)
side=${SIDE:-32} cycles=${CYCLES:-200}
OMP_NUM_THREADS=1 OMP_WAIT_POLICY=passive
export OMP_NUM_THREADS OMP_WAIT_POLICY
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM

stop() {
  echo "cost.sh: $*" >&2
  exit 2
}

# The time of a contact update with each shear law of elastic spheres over that with `mindlin`.
laws() {
  echo "# Cost of a contact update over that with \`mindlin\`, from docs/COST.md; written by make cost."
  $awk -F ' *[|] *' -v names="linear none=hertz mindlin mindlin_scaled mindlin_deresiewicz=exact randall randall_literal" '
    /^## / { inside = $0 == "## Laws and forces" }
    inside && NF > 10 { ns[$2] = $(NF - 1) }
    END {
      n = split(names, name, " ")
      for (k = 1; k <= n; k++) {
        page = name[k]; sub(/.*=/, "", page); gsub(/_/, "-", page); sub(/=.*/, "", name[k])
        printf "%s%s %.2f", k == 1 ? "law_costs = '\''" : "  ", name[k], ns[page]/ns["mindlin"]
      }
      print "'\''"
    }' "$1"
}

# ---- the pages ----
#
# NAME | page it is compared with | features it uses | particles | clauses of the material | lines of the scene | lines of the stage |
# lines after the stage | text of the table
# In lines, `;` separates statements. $M and $E are the middle and the edge of the lattice, mm; $C and $D are the corners of the
# cell, and $R is the radius of a circle inside the lattice. $P and $Q are the numbers of two neighbours in the middle, and $T is
# the time at which the measured stage ends. If a page has the same features as the page it is compared with, it declares
# something that the measured stage does not use.
pages() {
  cat <<'PAGES'
base | - | | frame discs | | | | | base page
spheres | base | | frame spheres | | | | | spheres instead of discs
spins | base | rotation | frame discs spins | | | | | rotation, without shear forces
rotation-off | linear | friction linear | frame discs | ks 10 MN/m friction 0.5 | shear linear | rotation off | | `rotation off`, with `shear linear`
linear | base | rotation friction linear | frame discs | ks 10 MN/m friction 0.5 | shear linear | | | `shear linear`, with rotation
hertz | spheres | elastic hertz | frame spheres | young 20 GPa poisson 0.2 | normal hertz | | | `normal hertz`
hertz-increment | spheres | elastic hertz_increment | frame spheres | young 20 GPa poisson 0.2 | normal hertz_increment | | | `normal hertz_increment`
mindlin | hertz | elastic hertz rotation friction mindlin | frame spheres | young 20 GPa poisson 0.2 friction 0.5 | normal hertz; shear mindlin | | | `shear mindlin`
mindlin-scaled | hertz | elastic hertz rotation friction mindlin_scaled | frame spheres | young 20 GPa poisson 0.2 friction 0.5 | normal hertz; shear mindlin_scaled | | | `shear mindlin_scaled`
randall | hertz | elastic hertz rotation friction randall | frame spheres | young 20 GPa poisson 0.2 friction 0.5 | normal hertz; shear randall | | | `shear randall`
randall-literal | hertz | elastic hertz rotation friction randall_literal | frame spheres | young 20 GPa poisson 0.2 friction 0.5 | normal hertz; shear randall_literal | | | `shear randall_literal`
exact | hertz | elastic hertz rotation friction mindlin_deresiewicz | frame spheres | young 20 GPa poisson 0.2 friction 0.5 | normal hertz; shear mindlin_deresiewicz | | | `shear mindlin_deresiewicz`
dashpots | base | dashpots | frame discs | | damping stiffness 1e-5 s | | | `damping stiffness`
dashpots-ratio | base | dashpots | frame discs | | damping ratio 0.01 | | | `damping ratio`
dashpots-shear | linear | rotation friction linear dashpots | frame discs | ks 10 MN/m friction 0.5 | shear linear; damping stiffness 1e-5 s | | | `damping stiffness`, with `shear linear`
mass | base | | frame discs | | damping mass 1 1/s | | | `damping mass`
gravity | base | gravity | frame discs | | gravity 0 m/s2 -9.81 m/s2 | | | `gravity`
central | base | central | frame discs | | | gravity centripetal 9.81 m/s2 about $M $M | | `gravity centripetal`
ramp | base | changes gravity | frame discs | | | ramp gravity 1e-3 m/s2 0 m/s2 | | `ramp gravity`
walls | base | walls vertices | free discs | | box -9.975 mm -9.975 mm to $E $E m | | | four walls
walls-ramp | walls | walls vertices changes | free discs | | box -9.975 mm -9.975 mm to $E $E m | ramp walls inward 1 um/s | | `ramp walls`
box | walls | walls vertices box | free discs | | box -9.975 mm -9.975 mm to $E $E m | box strain -1e-9 per cycle -1e-9 per cycle | | `box strain`
box-servo | walls | walls vertices box servo measures | free discs | | box -9.975 mm -9.975 mm to $E $E m | servo xx 1 MPa yy 1 MPa on box through box at most 1e-9 per cycle | | servo through the box, every 10 cycles
cell | base | cell | cell discs | | periodic cell $C $C to $D $D | | | periodic cell
cell-strain | cell | cell affine | cell discs | | periodic cell $C $C to $D $D | cell strain -1e-9 per cycle -1e-9 per cycle | | `cell strain`
cell-servo | cell | cell affine servo measures | cell discs | | periodic cell $C $C to $D $D | servo mean 1 MPa on cell through cell at most 1e-9 per cycle | | servo through the cell, every 10 cycles
affine | base | affine | frame discs | | | affine strain -1e-9 per cycle -1e-9 per cycle | | `affine strain`
boundary-fixed | base | boundary | frame discs | | boundary circle $M $M radius $R | boundary fixed | | `boundary fixed`
boundary-strain | boundary-fixed | boundary affine | frame discs | | boundary circle $M $M radius $R | boundary strain -1e-9 per cycle -1e-9 per cycle | | `boundary strain`
boundary-stress | boundary-fixed | boundary | frame discs slow | | boundary circle $M $M radius $R | boundary stress 25 kPa 25 kPa | | `boundary stress`
boundary-servo | boundary-fixed | boundary affine servo measures | frame discs | | boundary circle $M $M radius $R | boundary fixed; servo isotropic 1 MPa on boundary through boundary at most 1e-9 per cycle | | servo through the boundary, every 10 cycles
search | cell | cell search stability | cell discs moving | | periodic cell $C $C to $D $D | | | a search every 10 cycles
work | base | balance | frame discs | | record work.balance | | | balance of work
energy | base | balance | frame discs | | record energy.balance | | | balance of energy
energy-shear | linear | rotation friction linear balance | frame discs | ks 10 MN/m friction 0.5 | shear linear; record energy.balance | | | balance of energy, with `shear linear`
energy-dashpots | dashpots-shear | rotation friction linear dashpots balance | frame discs | ks 10 MN/m friction 0.5 | shear linear; damping stiffness 1e-5 s; record energy.balance | | | balance of energy, with `shear linear` and dashpots
fracc | mindlin | elastic hertz rotation friction mindlin fracc | frame spheres | young 20 GPa poisson 0.2 friction 0.5 | normal hertz; shear mindlin; record step.fracc | | | FRACC
sliding | linear | rotation friction linear configuration | frame discs | ks 10 MN/m friction 0.5 | shear linear | snapshot from measured | | sliding since a stage
until | base | conditions | frame discs | | | until time above $T at most 100000000 cycles | | `until`, a condition on time
record-time | base | records | frame discs | | record cycle time | record every 10 cycles | | `cycle time`
record-particle | base | records monitors | frame discs | | monitor A disc $P; record A.x A.vx | record every 10 cycles | | position and velocity of a particle
record-contact | base | records monitors | frame discs | | monitor C disc $P with disc $Q; record C.overlap C.normal | record every 10 cycles | | overlap and force of a contact
record-kinetic | base | records measures balance | frame discs | | record energy.kinetic | record every 10 cycles | | `energy.kinetic`
record-unbalanced | base | records measures | frame discs | | record unbalanced.max | record every 10 cycles | | `unbalanced.max`
record-stress | base | records measures | frame discs | | region A all; record A.stress.mean | record every 10 cycles | | `A.stress.mean`
record-stress-all | base | records measures | frame discs | | region A all; record A.stress.xx A.stress.xy A.stress.yy A.stress.mean A.stress.deviator | record every 10 cycles | | five components of the stress
record-fabric | base | records measures | frame discs | | region A all; record A.fabric.xx | record every 10 cycles | | `A.fabric.xx`
record-coordination | base | records measures | frame discs | | region A all; record A.coordination | record every 10 cycles | | `A.coordination`
record-porosity | base | records measures | frame discs | | region A circle $M $M radius $R; record A.porosity | record every 10 cycles | | `A.porosity` of a circle
record-strain | base | records measures | frame discs | | region A all; record A.strain.xx | record every 10 cycles | | `A.strain.xx`
record-chains | base | records measures | frame discs | | region A all; record A.chains | record every 10 cycles | | `A.chains`
unused-friction | base | | frame discs | ks 10 MN/m friction 0.5 | | | | friction, but no shear law
unused-shear | base | | frame discs | ks 10 MN/m | shear linear | | | `shear linear`, but no friction in any stage
unused-region | base | | frame discs | | region A all; monitor B disc $P; monitor C disc $P with disc $Q | | | a region and monitors, not recorded
unused-record | base | | frame discs | | region A all; monitor C disc $P with disc $Q; record time C.normal A.stress.mean A.fabric.xx unbalanced.max | | | quantities to record, with `record none`
later-record | base | | frame discs still | | record time unbalanced.max | | stage later; record every 1 cycle; cycles 1 | `record`
later-shear | base | | frame discs still | ks 10 MN/m friction 0.5 | | | stage later; shear linear; cycles 1 | `shear linear`
later-dashpots | base | | frame discs still | | | | stage later; damping stiffness 1e-5 s; cycles 1 | `damping stiffness`
later-mass | base | | frame discs still | | | | stage later; damping mass 1 1/s; cycles 1 | `damping mass`
later-gravity | base | | frame discs still | | | | stage later; gravity 0 m/s2 -9.81 m/s2; cycles 1 | `gravity`
later-affine | base | | frame discs still | | | | stage later; affine strain -1e-9 per cycle -1e-9 per cycle; cycles 1 | `affine strain`
later-boundary | base | | frame discs still | | | | stage later; boundary circle $M 1.3 mm radius $R; boundary strain -1e-9 per cycle -1e-9 per cycle; cycles 1 | `boundary strain`
later-remove | base | | frame discs still | | | | stage later; remove disc 1; cycles 1 | `remove`
later-ramp | base | | frame discs still | | | | stage later; ramp material m kn 20 MN/m; cycles 1 | `ramp material`
later-ratio | base | | frame discs still | | | | stage later; damping ratio 0.01; cycles 1 | `damping ratio`
later-rotation | rotation-off | friction linear | frame discs | ks 10 MN/m friction 0.5 | shear linear | rotation off | stage later; rotation on; cycles 1 | `rotation on`
later-box | walls | walls vertices | free discs | | box -9.975 mm -9.975 mm to $E $E m | | stage later; box strain -1e-9 per cycle -1e-9 per cycle; cycles 1 | `box strain`
later-cell | cell | cell | cell discs | | periodic cell $C $C to $D $D | | stage later; cell strain -1e-9 per cycle -1e-9 per cycle; cycles 1 | `cell strain`
later-snapshot | base | | frame discs still | | | | stage later; snapshot; cycles 1 | `snapshot`
PAGES
}

# ---- the features and their files ----
#
# FEATURE ... : FILE or FILE:FUNCTION ... ; a function overrides its file; `*` stands for all functions of a file. A file of
# several features may be executed on the pages of any of them. Every page uses `cycle`; no cycle uses `never`.
features() {
  cat <<'FEATURES'
cycle : core/cycle.c core/team.c core/team.h core/motion.c core/motion.h core/guard.c core/model.h core/block.h core/vec.h core/clock.h core/cell.h core/boundary.h core/affine.h
cycle : run/hooks.c run/run.c run/result.c run/result.h
cycle : pass/disc_disc.c pass/disc_disc.h pass/disc_disc_wide.h pass/geometry.h pass/pass.h pass/resolve.c laws/law.h laws/law_batch.h
cycle : laws/normal_linear.c
rotation : core/motion.c:rotate
friction : pass/resolve.c:with_shear laws/shear_none.c
linear : laws/shear_linear.c
hertz : laws/normal_hertz.c
hertz_increment : laws/normal_hertz_increment.c
mindlin : laws/shear_mindlin.c
mindlin_scaled : laws/shear_mindlin_scaled.c
randall : laws/shear_randall.c
randall_literal : laws/shear_randall_literal.c
randall randall_literal : laws/randall.h
mindlin_deresiewicz : laws/shear_mindlin_deresiewicz.c laws/corners.h laws/law_stages.h
elastic : pass/deep.c
elastic search : core/deep.c
dashpots : pass/dashpots.c core/damping.c
dashpots stability search elastic : core/damping.c:nb_damping_contact_line
gravity : core/motion.c:add_weight
central : core/motion.c:add_central core/motion.h:nb_central_force
changes : run/stage.c
walls : core/walls.h pass/disc_wall.c
walls search : core/walls.c
vertices : pass/wall_vertices.c
vertices search : core/wall_vertices.c
cell : core/cell.c pass/periodic.c
affine : loading/affine.c pass/affine_twice.c core/motion.c:add_affine core/motion.c:move_search_positions core/cell.c:nb_cell_move
boundary : loading/boundary.c core/motion.c:add_boundary_force
boundary measures : measure/boundary.c measure/boundary.h
box : loading/box.c
box changes : loading/box.c:nb_box_is_strained
servo : loading/servo.c
balance : measure/balance.c measure/balance.h measure/balance_steps.c core/energy_terms.h
balance measures : measure/energy.c measure/energy.h
balance monitors measures fracc : core/velocity.c
fracc : measure/fracc.c
configuration : measure/configuration.c measure/configuration.h
conditions : run/run.c:nb_condition_met run/run.c:conditions_met
records : run/result.c:nb_result_add_row core/table.c
records conditions servo : input/names.c core/families.c
measures : measure/areas.c measure/areas.h measure/chains.c measure/coordination.c measure/fabric.c
measures : measure/loads.c measure/region.c measure/region.h measure/region_quantities.c measure/snapshot.c measure/snapshot.h
measures : measure/strain.c measure/stress.c measure/directions.c measure/moduli.c measure/impact.c measure/impact.h core/names.h loading/loading_quantities.c
monitors measures : measure/wall_quantities.c
search : core/neighbours.c core/grid.c core/grid.h core/mesh.c core/mesh.h core/blocks.c
search records : core/array.h core/array.c
search servo balance fracc configuration measures monitors elastic boundary : core/contacts.h
search stability measures monitors : core/contacts.c core/history.c core/incidence.c
stability search elastic : measure/stability.c measure/stable_step.c laws/properties.c core/hertz_impact.h
stability search elastic changes : laws/laws_now.c laws/laws_now.h
stability search elastic fracc : measure/step.h
cell affine boundary box walls measures search balance : core/tensor.h
measures servo boundary : core/materials.c
stability : core/guard.c:nb_guard_resolution core/guard.c:coordinate core/guard.c:ulp measure/step.c
never : core/clean.c core/clean.h core/error.c core/error.h core/guess.h core/machine.c core/warning.c laws/register.c loading/loading.h
never : loading/remove.c measure/collision.c measure/rayleigh_step.c packing/* run/contact_test.c run/contact_test.h run/contact_test_quantities.c
never : core/store.c core/store.h run/checkpoint.c run/checkpoint.h run/run.c:check_in run/run.c:store_run
never : run/model.c run/output_file.c run/output_file.h run/plan.c run/plan.h run/restart.c run/restart.h run/state.c run/state.h
FEATURES
}

# Field $2 of page $1.
field() { pages | $awk -F ' *[|] *' -v name="$1" -v k="$2" '$1 == name { print $k }'; }

# Page $1, whose measured stage has $2 cycles.
write_page() {
  pages | $awk -F ' *[|] *' -v name="$1" -v cycles="$2" -v n="$side" '
    function lines(text, list, count, k) {
      count = split(text, list, / *; */)
      for (k = 1; k <= count; k++) if (list[k] != "") print list[k]
    }
    function replaced(text) {
      gsub(/[$]M/, sprintf("%.3f mm", (n - 1) * d / 2), text)
      gsub(/[$]E/, sprintf("%.3f mm", (n - 0.5) * d), text)
      gsub(/[$]C/, sprintf("%.3f mm", -d / 2), text)
      gsub(/[$]D/, sprintf("%.3f mm", (n - 0.5) * d), text)
      gsub(/[$]R/, sprintf("%.3f mm", (n - 3) * d / 2), text)
      gsub(/[$]P/, int(n / 2) * n + int(n / 2), text)
      gsub(/[$]Q/, int(n / 2) * n + int(n / 2) + 1, text)
      gsub(/[$]T/, sprintf("%.17g s", (cycles - 0.5) * dt), text)
      return text
    }
    # random numbers that are the same on every machine: a linear congruence below 2^16
    function next_random() { seed = (seed * 1103 + 12345) % 65536; return seed / 65536 - 0.5 }
    BEGIN { d = 19.95; dt = 1e-5; seed = 12345 } # spacing of the lattice, mm, of particles of radius 10 mm; step, s
    $1 == name {
      if ($4 ~ /slow/) dt = 1e-7
      kind = $4 ~ /spheres/ ? "sphere" : "disc"
      print "# " name "\n\n```scene\nmaterial m density " (kind == "disc" ? 2000 : 150000) " kg/m3 kn 10 MN/m " $5
      for (j = 0; j < n; j++)
        for (i = 0; i < n; i++) {
          edge = i == 0 || j == 0 || i == n - 1 || j == n - 1
          vx = next_random() * 0.1; vy = next_random() * 0.1
          if ($4 ~ /moving/) { vx = 5.2; vy = 0 } # half the skin, 0.5 mm, in ten steps
          if ($4 ~ /still/) vx = vy = 0 # at rest, so that the later stage costs the same after N and after 2 N cycles
          motion = sprintf("velocity %.5f m/s %.5f m/s", vx, vy)
          if ($4 ~ /spins/) motion = motion sprintf(" spin %.5f rad/s", next_random())
          print kind, i * d " mm", j * d " mm", "radius 10 mm m", $4 ~ /frame/ && edge ? "fixed" : motion
        }
      lines(replaced($6))
      print "step " dt " s\nstage measured"
      if ($7 !~ /record/) print "record none"
      if ($7 !~ /until/) print "cycles " cycles
      lines(replaced($7))
      if ($8 != "") { if ($8 !~ /record/) $8 = $8 "; record none"; lines(replaced($8)) }
      print "```"
    }'
}

# ---- one page under callgrind ----

# Prints the profile: one line for each source line, `FILE:LINE INSTRUCTIONS`. Files of the tree are relative to src/.
profile() {
  $awk '
    function file_name(text, id) {
      sub(/^c?f[a-z]=/, "", text)
      if (match(text, /^\([0-9]+\)/)) {
        id = substr(text, 1, RLENGTH)
        if (length(text) > RLENGTH) named[id] = substr(text, RLENGTH + 2)
        return named[id]
      }
      return text
    }
    # The part of the path after the last src/, if a folder of the simulator follows.
    function short(text, at, rest) {
      for (at = length(text) - 3; at > 0 && !rest; at--) if (substr(text, at, 4) == "src/" && (at == 1 || substr(text, at - 1, 1) == "/")) rest = substr(text, at + 4)
      return rest ~ /^(core|input|laws|loading|measure|packing|pass|report|run)\// ? rest : "system"
    }
    /^f[lie]=/ { file = short(file_name($0)); next }
    /^cf[li]=/ { file_name($0); next }
    /^calls=/ { inclusive = 1; next }
    /^[0-9+*-]/ {
      if ($1 ~ /^[+]/) line += substr($1, 2); else if ($1 ~ /^-/) line -= substr($1, 2); else if ($1 != "*") line = $1 + 0
      if (!inclusive) cost[file == "system" ? file ":0" : file ":" line] += $2
      inclusive = 0
    }
    END { for (place in cost) printf "%s %.0f\n", place, cost[place] }' "$1"
}

# Runs page $1 with $2 cycles; the profile is in $3.
callgrind() {
  write_page "$1" "$2" >"$work/page.md"
  rm -rf "$work/page.out" # an existing folder would make the program execute other lines
  (cd "$work" && valgrind --tool=callgrind --callgrind-out-file="$work/callgrind" "$nineball" figure page.md --isa avx2 --jobs 1 \
    >"$work/said" 2>&1) || {
    grep -v '^==' "$work/said" >&2
    stop "page $1 failed"
  }
  profile "$work/callgrind" >"$3"
}

# Writes the instructions of the measured window of page $1, per source line, to $work/$1.cost.
measure() {
  test ! -e "$work/$1.cost" || return 0
  callgrind "$1" "$cycles" "$work/one"
  callgrind "$1" $((2 * cycles)) "$work/two"
  $awk 'NR == FNR { before[$1] = $2; next }
    { more = $2 - before[$1]; if (more != 0) printf "%s %.0f\n", $1, more }' "$work/one" "$work/two" | sort >"$work/$1.cost"
}

# ---- the proof ----

# Prints one line for each function that the list of features names: FILE:FUNCTION FIRST LAST.
functions() {
  features | tr ' ' '\n' | grep ':.' | sort -u | while IFS=: read -r file name; do
    $awk -v file="$file" -v name="$name" '
      !first && $0 ~ "^[a-z].*[ *]" name "\\(" && !/;$/ { first = FNR }
      first && !last && (/^}/ || (FNR == first && /}$/)) { last = FNR }
      END { if (last) print file ":" name, first, last; else { print "cost.sh: src/" file " has no function " name >"/dev/stderr"; exit 1 } }' \
      "$top/src/$file" || exit 1
  done
}

# Tests that every file of the simulator belongs to a feature, and that every file of the list exists.
complete() {
  features | sed 's/.* : //' | tr ' ' '\n' | sed 's/:.*//' | sort -u >"$work/listed"
  (cd "$top/src" && ls core/*.[ch] laws/*.[ch] pass/*.[ch] measure/*.[ch] loading/*.[ch] packing/*.[ch] run/*.[ch]) |
    $awk 'NR == FNR { listed[$1] = 1; next }
      { folder = $1; sub(/\/.*/, "/*", folder); there[$1] = there[folder] = 1
        if (!($1 in listed) && !(folder in listed)) print "src/" $1 " belongs to no feature of tests/bench/cost.sh" }
      END { for (file in listed) if (!(file in there) && file !~ /^input/) print "src/" file " of tests/bench/cost.sh is not there" }' "$work/listed" -
}

# Prints the lines that page $1 executed of features that it does not use, and the features of the page of which it executed no
# line.
#
# The compiler moves some instructions of an inlined function, such as the computation of an address, out of its condition. These
# instructions are executed once for each batch of particles in each cycle. A cycle may execute at most 24 of them per 256
# particles.
violations() {
  features | $awk -v page="$1" -v uses="cycle $(field "$1" 3)" -v allowed=$((24 * cycles * (side * side + 255) / 256)) '
    FILENAME == "-" {
      for (k = 1; $k != ":"; k++) if (!index(feature_of[""], " " $k " ")) feature_of[""] = feature_of[""] " " $k " "
      owners = $0; sub(/ : .*/, "", owners); sub(/^.* : /, "")
      for (k = 1; k <= NF; k++) feature_of[$k] = feature_of[$k] " " owners " "
      next
    }
    FILENAME ~ /functions$/ { place = $1; sub(/:.*/, "", place); n++; file[n] = place; name[n] = $1; first[n] = $2; last[n] = $3; next }
    {
      place = $1; line = $1; sub(/:.*/, "", place); sub(/.*:/, "", line)
      if (place == "system") next
      sources++
      key = place
      for (k = 1; k <= n; k++) if (file[k] == place && line + 0 >= first[k] && line + 0 <= last[k]) key = name[k]
      if (!(key in feature_of)) { folder = key; sub(/\/.*/, "/*", folder); key = folder in feature_of ? folder : key }
      used = 0
      count = split(uses, used_list, " ")
      for (k = 1; k <= count; k++) if (index(feature_of[key], " " used_list[k] " ")) { used = 1; executed[used_list[k]] = 1 }
      if (!used) { cost[key] += $2; where[key] = where[key] " " line }
    }
    END {
      for (key in cost) {
        if (key ~ /:/ && cost[key] <= allowed) continue
        owners = key in feature_of ? "a file of: " feature_of[key] : "a file of no feature"
        gsub(/ +/, " ", owners)
        print "page " page " executes src/" key ", " owners ": " cost[key] " instructions, lines" where[key]
      }
      count = split(uses, used_list, " ")
      for (k = 1; k <= count; k++) if (!(used_list[k] in executed)) print "page " page " executes nothing of " used_list[k]
      if (!sources) print "page " page " executes no line of src: is the program built with -g?"
    }' - "$work/functions" "$work/$1.cost"
}

# ---- requirements ----

# Status 77: the proof cannot be made here.
lack() {
  echo "cost.sh: $*" >&2
  exit 77
}
if [ "${1:-}" = --page ]; then
  write_page "$2" "$cycles"
  exit
fi
if [ "${1:-}" = --laws ]; then
  laws "$2"
  exit
fi
command -v valgrind >/dev/null || lack "valgrind is missing: install it, on Debian with apt install valgrind"
test -x "$nineball" || stop "there is no program $nineball: run make first"
if grep -q __asan_init "$nineball"; then lack "valgrind cannot run a program that is built with a sanitizer"; fi
grep -q '[.]debug_line' "$nineball" || lack "the program has no debugging information: configure with -g in CFLAGS"
grep -qw avx2 /proc/cpuinfo 2>/dev/null || lack "the pages run with AVX2, which this machine lacks"
runs=true
valgrind --tool=none "$nineball" --version >"$work/said" 2>&1 || runs=false
if grep -q 'unhandled dwarf' "$work/said"; then
  lack "this valgrind cannot read the debugging information of this compiler; with clang, add -gdwarf-4 to CFLAGS"
fi
$runs || lack "valgrind cannot run the program: $(grep -v '^==[0-9]*== *$' "$work/said" | tail -n 1)"
functions >"$work/functions" || exit 1

status=0
prove() {
  complete >"$work/wrong"
  for page in "$@"; do
    test ! -t 2 || printf '%s\r' "$page             " >&2
    measure "$page"
    violations "$page" >>"$work/wrong"
  done
  if [ -s "$work/wrong" ]; then
    cat "$work/wrong" >&2
    status=1
  fi
}

if [ "${1:-}" = --proof ]; then
  shift
  [ "$*" != all ] || set -- $(pages | cut -d ' ' -f 1)
  prove "$@"
  exit $status
fi
[ "${1:-}" = -o ] && [ $# -eq 2 ] || stop "usage: cost.sh -o FILE | --proof all|PAGE ... | --page PAGE | --laws DOCUMENT"
document=$2

# ---- the document ----

# The processor time of a cycle of page $1, us, which `explain` measures in a trial run of some milliseconds.
time_cycle() {
  write_page "$1" 100000 >"$work/page.md"
  "$nineball" explain "$work/page.md" --isa avx2 >"$work/$1.plan" 2>"$work/said" || stop "page $1 cannot be explained"
  echo "$1" "$(sed -n 's/^  a cycle .*takes \([0-9.e+]*\) us, .*/\1/p' "$work/$1.plan")"
}

# Prints one line for page $1: name, instructions per cycle, contacts, bytes per particle and per contact, us per cycle, and the
# instructions without those of the C library, which prints tables after the run.
describe() {
  $awk -v name="$1" -v cycles="$cycles" -v us="$(sed -n "s/^$1 //p" "$work/times" | sort -g | sed -n 3p)" '
    FILENAME ~ /[.]cost$/ { sum += $2; if ($1 !~ /^system:/) own += $2; next }
    / pairs? in the neighbour list;/ { sub(/.*: /, ""); contacts += $1 }
    /^  [0-9]+ bytes a particle/ { particle = $1; match($0, /[0-9]+ a contact/); contact = substr($0, RSTART) + 0 }
    END { printf "%s %.17g %d %d %d %s %.17g\n", name, sum / cycles, contacts, particle, contact, us, own / cycles }' "$work/$1.cost" "$work/$1.plan"
}

# list_rows PROGRAM PAGE ...: a table. The awk program gets for each page its name, the page that it is compared with,
# and what it adds. value[PAGE, K] are the numbers of the pages, n is the number of particles.
list_rows() {
  program=$1
  shift
  for page in "$@"; do
    echo "$page|$(field "$page" 2)|$(field "$page" 9)"
  done | $awk -F '|' -v n=$((side * side)) '
    FILENAME != "-" { split($0, part, " "); for (k = 2; k <= 7; k++) value[part[1], k] = part[k]; next }'"$program" "$work/table" -
}

# Rows of the main table for these pages.
rows() {
  list_rows '
    FNR == 1 {
      print "| page | adds | to | contacts | instructions a contact | more | instructions a particle | bytes a particle | bytes a contact | ns a contact |"
      print "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"
    }
    {
      cost = value[$1, 2] / value[$1, 3]
      more = "-"
      if ($2 != "-") {
        from = value[$2, 2] / value[$2, 3]
        more = sprintf("%+.1f (%+.0f %%)", cost - from, 100 * (cost / from - 1))
        gsub(/[-+]0 %/, "0 %", more); sub(/^[-+]0[.]0 /, "0.0 ", more)
      }
      printf "| %s | %s | %s | %d | %.1f | %s | %.1f | %d | %d | %.2f |\n", $1, $3, $2, value[$1, 3], cost, more, value[$1, 2] / n, value[$1, 4], value[$1, 5],
        1000 * value[$1, 6] / value[$1, 3]
    }' "$@"
}

# Rows for the measures that are computed when a row is recorded, every ten cycles.
record_rows() {
  list_rows '
    FNR == 1 {
      print "| page | records | instructions a row | a particle | cycles of the base page | more bytes a contact |"
      print "| --- | --- | --- | --- | --- | --- |"
    }
    {
      row = 10 * (value[$1, 2] - value[$2, 2])
      printf "| %s | %s | %.0f | %.1f | %.2f | %d |\n", $1, $3, row, row / n, row / value["base", 2], value[$1, 5] - value[$2, 5]
    }' "$@"
}

# Rows for features that are declared and not used in the measured stage.
unused_rows() {
  list_rows '
    FNR == 1 {
      print "| page | declares | to | more instructions a cycle | a contact | more bytes a particle | more bytes a contact |"
      print "| --- | --- | --- | --- | --- | --- | --- |"
    }
    {
      more = value[$1, 7] - value[$2, 7]
      printf "| %s | %s | %s | %.0f | %.1f | %d | %d |\n", $1, $3, $2, more, more / value[$1, 3], value[$1, 4] - value[$2, 4], value[$1, 5] - value[$2, 5]
    }' "$@"
}

# more A B: the additional cost of an update of page A over one of page B, in percent; ratio A B: the quotient of these costs.
more() { $awk -v a="$1" -v b="$2" '$1 == a { x = $2 / $3 } $1 == b { y = $2 / $3 } END { printf "%.0f %%", 100 * (x / y - 1) }' "$work/table" | sed 's/^-0/0/'; }
ratio() { $awk -v a="$1" -v b="$2" '$1 == a { x = $2 / $3 } $1 == b { y = $2 / $3 } END { printf "%.1f", x / y }' "$work/table"; }
value() { $awk -v a="$1" -v k="$2" '$1 == a { print $k }' "$work/table"; }
# in_cycles A B: the cost of one record of page A in cycles of page B; a record is made every ten cycles.
in_cycles() { $awk -v a="$1" -v b="$2" '$1 == a { x = $2 } $1 == b { y = $2 } END { printf "%.2g", 10 * (x - y) / y }' "$work/table"; }
# Longest over shortest time of the pages that execute as many instructions as the base page.
spread() {
  $awk '$1 == "base" { cost = $2 } $2 == cost { if (!least || $6 < least) least = $6; if ($6 > most) most = $6 } END { printf "%.2f", most / least }' \
    "$work/table"
}
cycle_of() { $awk -v cycles="$cycles" '{ sum += $2 } END { printf "%.17g\n", sum / cycles }' "$work/$1.cost"; }

laws="base spheres spins rotation-off linear hertz hertz-increment mindlin mindlin-scaled randall randall-literal exact dashpots dashpots-ratio
  dashpots-shear mass gravity central"
loading="walls walls-ramp box box-servo cell cell-strain cell-servo affine boundary-fixed boundary-strain boundary-stress boundary-servo ramp search"
measures="work energy energy-shear energy-dashpots fracc sliding until"
records=$(pages | cut -d ' ' -f 1 | grep '^record-')
unused=$(pages | cut -d ' ' -f 1 | grep '^unused-')
later=$(pages | cut -d ' ' -f 1 | grep '^later-')

prove $(pages | cut -d ' ' -f 1)
all="$laws $loading $measures $records $unused $later"
for k in 1 2 3 4 5; do
  for page in $all; do time_cycle "$page"; done
done >"$work/times"
for page in $all; do describe "$page"; done >"$work/table"

# A cycle costs a + b N instructions on periodic lattices of N particles whose blocks and batches are full. Reports of progress
# read the clock, which costs a few instructions in some cycles.
for side in 16 32 48; do
  rm -f "$work/cell.cost"
  measure cell
  cycle_of cell
done >"$work/sizes"
side=${SIDE:-32}
tr '\n' ' ' <"$work/sizes" | $awk '{
  one = ($2 - $1) / (32 * 32 - 16 * 16); two = ($3 - $2) / (48 * 48 - 32 * 32)
  printf "%.0f, %.0f and %.0f|%.0f + %.2f N|%d\n", $1, $2, $3, $1 - 256 * one, one, (two / one > 0.9999 && two / one < 1.0001) }' >"$work/line"
if ! grep -q '|1$' "$work/line"; then
  echo "the cost of a particle depends on the size of the scene: $(cat "$work/line")" >&2
  status=1
fi

# One stability check: the window from cycle 501 to 1000 contains one.
rm -f "$work/base.cost"
cycles=500
measure base
check=$(cycle_of base | $awk -v base="$(value base 2)" '{ printf "%.0f", 500 * ($1 - base) }')
cycles=${CYCLES:-200}
unequal=$(for page in $unused $later; do
  $awk -v a="$page" -v b="$(field "$page" 2)" '$1 == a { x = $7 } $1 == b { y = $7 } END { if (x != y) print a }' "$work/table"
done)
if [ "$unequal" ]; then
  echo "these pages declare what they do not use, and pay for it:" $unequal >&2
  status=1
fi
[ $status -eq 0 ] || exit $status

cat >"$work/document" <<DOCUMENT
# What each feature costs

\`make cost\` writes this document ([tests/bench/cost.sh](../tests/bench/cost.sh)). It counts the instructions of a cycle
with callgrind, and fails if a page pays for a feature that it does not use.

## Method

The base page has $((side * side)) discs in a square lattice. They overlap by 0.5 % of their radius. The outermost ones are
fixed, and the others begin with random velocities. The normal law is linear, and there is no friction. Each
other page adds one feature to the page in the column \`to\`. Every pair in the neighbour list touches. A contact
update is the work of one cycle for one contact, including its fraction of the motion of the particles.

Each page runs with $cycles and with $((2 * cycles)) cycles. The difference of the two counts, divided by $cycles, is the cost
of a cycle. So reading, start and printing cancel. All pages run with \`--isa avx2\` and one thread, because callgrind
does not know AVX-512. Counts repeat exactly on one machine. They depend on the compiler, here
$FLAGS.

Bytes are those that \`nineball explain\` prints under \`memory\`: what a cycle reads and writes. Times are processor times of the trial run of \`explain\`: the median of five, on one
core of a machine with $(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1). Other programs ran at the same
time. Pages that execute exactly as many instructions as the base page differ in time by a factor of up to $(spread). Smaller
differences of time mean nothing, and a single time can be an outlier.

## Laws and forces

$(rows $laws)

The cost of \`randall\`, \`randall_literal\` and \`mindlin_deresiewicz\` depends on the history of the contacts, because these
laws branch. Here the particles oscillate, the mean shear force is an eighth of its limit, and no contact slides as a
whole.

## Loading

$(rows $loading)

Pairs of particles that a boundary holds are not in the neighbour list. So the pages with a boundary have fewer
contacts, and the cost of the motion is divided among fewer contacts.

## Measures of every cycle

$(rows $measures)

## Records

The pages write a row every ten cycles. The cost of a row is ten times the difference from the base page.

$(record_rows $records)

## The proof

\`make cost\` fails if one of these four statements does not hold.

**No foreign lines.** Callgrind attributes each instruction to its source line, also within inlined functions. A list
says to which features each file of the simulator belongs. No page executes a line of a file that belongs only to
features that the page does not use. Every page executes lines of each feature that it uses. Some features are
functions in a shared loop, such as the rotation in [motion.c](../src/core/motion.c). The compiler may move the computation
of an address out of the condition of such a function. A cycle may execute at most 24 such instructions per 256
particles.

**No cost of declarations.** A page that declares something without using it executes exactly as many instructions as
the page without it:

$(unused_rows $unused)

**No cost of later stages.** Force passes, hooks and the motion belong to a stage. So a page whose later stage uses a feature
executes exactly as many instructions in the stages before as the page without that stage. The C library, which writes the tables
after the run, is not counted:

$(unused_rows $later)

Memory is that of the whole run. The arrays of a particle that a later stage needs exist from the start, and so do the fields of
contacts that a row or a snapshot reads in any stage. \`damping\` of a later stage needs no more memory.

**No cost of size.** Periodic lattices of 16, 32 and 48 discs on a side need $(cut -d '|' -f 1 "$work/line") instructions
a cycle. Within 0.01 %, these are $(cut -d '|' -f 2 "$work/line") for N discs.

## What follows

- **Rotation** costs $(more spins base) without shear forces. Spheres cost as much as discs.
- **\`shear linear\`**, rotation included, costs $(more linear base), with \`rotation off\` $(more rotation-off base).
- **A periodic cell** costs $(more cell base), and $(more cell-strain base) while it is strained.
- **Hertz's law** costs $(more hertz spheres) more than the linear spring, and Hertz's law by increments $(more hertz-increment spheres) more.
- **Simple shear laws of elastic spheres**: \`mindlin\` costs $(more mindlin hertz) and \`mindlin_scaled\` $(more mindlin-scaled hertz) more than
  Hertz's law without friction, rotation included.
- **Laws with micro-slip** are expensive. An update with \`randall\` costs $(ratio randall hertz) times that of Hertz's law without
  friction, and one with the exact law, \`mindlin_deresiewicz\`, $(ratio exact hertz) times.
- **Dashpots** cost $(more dashpots base) without shear forces and $(more dashpots-shear linear) with them. Mass-proportional damping costs $(more mass base).
- **The balance of energy** multiplies the cost by $(ratio energy base) on the base page and by $(ratio energy-shear linear) with \`shear linear\`. The balance of
  work multiplies it by $(ratio work base).
- **Rows** of a particle or a contact cost $(in_cycles record-particle base) cycles of the base page or less. A row with the stress of all particles costs
  $(in_cycles record-stress base) cycles, with the fabric $(in_cycles record-fabric base). Other components of the same tensor cost almost nothing more.
- **A search**, with the stability check after it, costs as much as $(in_cycles search cell) cycles of the page with a periodic cell.
- **The stability check** is made at least every 1000 cycles. On the base page it takes $check instructions, $($awk -v a="$check" -v b="$(value base 2)" 'BEGIN { printf "%.1f %%", a / b / 10 }') of 1000 cycles.
DOCUMENT
# Another script (make expected) writes the section about the costs that `explain` expects; the section stays.
$awk '/^## / { keep = $0 == "## What `explain` expects" } keep { print (lines++ ? "" : "\n") $0 }' "$document" >"$work/expected"
cat "$work/document" "$work/expected" >"$document"
laws "$document" >"$top/plots/law-costs.gp"
