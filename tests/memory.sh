# Makes each allocation of the whole process fail, also those of the C library, which tests/faults/run does not reach: first each
# alone, then each with all later ones. A run may have status 0 only if its output and all its files are the same to the last byte.
# Otherwise it must have a status from 2 to 4, and a message. TAP. The test is skipped where the allocations of the program cannot
# be replaced, as with a sanitizer, and with the OpenMP of LLVM.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
. "${srcdir:-.}/tests/tap"

preload=$(dirname "$nineball")/tests/faults/preload.so
cat >"$work/page.md" <<'END'
# Two impacts on a floor

```scene
material  m  density 1000 kg/m3  kn 1e6 N/m
wall      floor -1 m 0 m to 1 m 0 m  m
sphere    0 m 0.099 m  radius 0.1 m  m
monitor   D sphere 1
sweep     e  0.1 0.2
damping   ratio $e
gravity   0 m/s2 -9.81 m/s2
step      0.1 of stable
record    time D.y D.vy
stage     fall
  cycles  20
```

```expect
D.y max  expected 0.1 m within 0.01 m [a guess]
```

```gnuplot
plot for [i=1:runs] sprintf('$table_%d', i) using 'time/s':'D.y/m' with lines
```
END
# The state of this page is longer than the buffers of the C library.
cat >"$work/large.md" <<'END'
# A lattice

```scene
material  m  density 1000 kg/m3  kn 1e6 N/m
lattice   discs 20 by 20  radius 0.1 m  m
step      0.1 of stable
stage     rest
  cycles  2
```
END
export NINEBALL_STATES=states

# try FOLDER SETTING COMMAND ...: runs the program in a new folder; its output, `said`, has no times. Returns its status.
try() {
  folder=$1 setting=$2
  shift 2
  rm -rf "$folder" && mkdir "$folder" && cp "$work/page.md" "$work/large.md" "$folder" || return 99
  (cd "$folder" && env FAIL_AT="$setting" FAIL_COUNT="$work/count" LD_PRELOAD="$preload" timeout 60 "$nineball" "$@" >printed 2>message)
  tried=$?
  grep -vE '[0-9.]+ s$' "$folder/printed" >"$folder/said"
  rm "$folder/printed"
  return $tried
}

# each MARK COMMAND ...: every allocation fails, in one run after the other. With MARK + all later allocations of the
# run fail, too; else MARK is empty.
each() {
  mark=$1
  shift
  try "$work/whole" 0 "$@" || { echo "# without failures: status $?" >"$why" && return 1; }
  calls=$(cat "$work/count") call=0 wrong=0
  : >"$why"
  test "$calls" -gt 20 || { echo "# $calls allocations" >"$why" && return 1; }
  while [ $call -lt "$calls" ]; do
    call=$((call + 1))
    try "$work/part" "$call$mark" "$@"
    ended=$?
    case $ended in
    1) grep -q '^libgomp: ' "$work/part/message" && continue ;; # of OpenMP, before the program begins
    0) rm "$work/part/message" && cp "$work/whole/message" "$work/part" && diff -r "$work/whole" "$work/part" >/dev/null && continue ;;
    2 | 3 | 4) test -s "$work/part/message" && continue ;;
    esac
    wrong=$((wrong + 1))
    echo "# call $call$mark: status $ended" >>"$why"
    head -n 3 "$work/part/message" >>"$why"
  done
  test $wrong -eq 0
}

# Without memory LLVM's OpenMP aborts, or waits for itself forever.
if ldd "$nineball" 2>/dev/null | grep -q 'libomp\.'; then
  echo '1..0 # SKIP the OpenMP of LLVM does not survive a failed allocation'
  exit 0
fi
rm -f "$work/count"
if ! test -f "$preload" || ! try "$work/whole" 0 --version || ! test -s "$work/count"; then
  echo '1..0 # SKIP allocations of this program cannot be replaced'
  exit 0
fi
for mark in '' +; do
  of=${mark:+", and all later ones"}
  each "$mark" check page.md
  result $? "check: each allocation$of"
  each "$mark" run page.md -o out
  result $? "run: each allocation$of"
  each "$mark" figure page.md -o out
  result $? "figure: each allocation$of"
  each "$mark" explain page.md
  result $? "explain: each allocation$of"
  each "$mark" state large.md -o end.state
  result $? "state: each allocation$of"
done

# The test must notice a lost character, and a failure without a message. So two scripts replace the program: one that ignores a
# failure and prints less, and one that prints no message.
cat >"$work/deaf" <<'END'
#!/bin/sh
test "$FAIL_AT" = 3 && echo "half" || echo "whole"
echo 30 >"$FAIL_COUNT"
END
sed 's/echo "half"/exit 4/' "$work/deaf" >"$work/mute"
chmod +x "$work/deaf" "$work/mute"
preload=
for nineball in "$work/deaf" "$work/mute"; do
  ! each '' run page.md
  result $? "${nineball##*/}: a program that fails in silence is noticed"
done
echo "1..$n"
