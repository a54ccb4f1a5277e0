#!/bin/sh
# Searches for inputs at which a reader fails, by libFuzzer with AddressSanitizer and UndefinedBehaviorSanitizer.
#
#   make fuzz                                       each reader for five minutes
#   make fuzz FUZZ_SECONDS=60 FUZZ_READERS=pages    one reader for a minute
#   make fuzz FUZZ=~/nights                         continues with the inputs that the folder has from earlier sessions
#
# The folder $FUZZ has the inputs found so far (READER/), those that failed (failed/), the program of each reader (build/)
# and one row for each session (sessions.tsv). The table of all sessions is printed, and written to report.md. The command
# fails if an input failed. Then repair the reader, and move the input from failed/ to tests/fuzz/corpus, with a name that
# describes the input.
#
#   make fuzz FUZZ_KEEP=yes                         then adds the fewest inputs that reach the same code to tests/fuzz/corpus
#   make fuzz FUZZ_KEEP=yes FUZZ_SECONDS=0          adds them without a search
#
# $srcdir is the top of the source tree, $FUZZ_CC a clang with libFuzzer.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu
unset MAKEFLAGS MFLAGS MAKELEVEL
here=$(cd "${srcdir:-.}" && pwd)
readers=${FUZZ_READERS:-pages expressions paths packings states checkpoints tables}
seconds=${FUZZ_SECONDS:-300}
export OMP_NUM_THREADS=1
export ASAN_OPTIONS=malloc_context_size=4:quarantine_size_mb=8:detect_leaks=1 UBSAN_OPTIONS=print_stacktrace=1

mkdir -p "${FUZZ:-fuzz}" && cd "${FUZZ:-fuzz}"
mkdir -p failed build
# Files of the readers are in memory, if the system has a folder in memory.
test ! -w /dev/shm || export TMPDIR=/dev/shm

# ---- the programs ----------------------------------------------------------------------------------------------------

coverage=-fsanitize-coverage=inline-8bit-counters,pc-table # comparisons are not traced, because this would halve the speed
checks=address,undefined,float-cast-overflow
flags="-g -O2 -fno-omit-frame-pointer -fno-sanitize-recover=all"
(
  cd build
  test -f Makefile || "$here/configure" -q CC="${FUZZ_CC:-clang}" CFLAGS="$flags $coverage -fsanitize=$checks"
  ${MAKE:-make} -j "$(nproc)" tests/fuzz/replay
  # A library, so that each program has only the code of its reader: after each input libFuzzer reads all counters.
  rm -f libfuzz.a
  ar rcs libfuzz.a tests/fuzz/[!r]*.o src/report/row_table.o # not replay.o
  for reader in $readers; do
    # shellcheck disable=SC2086
    ${FUZZ_CC:-clang} $flags -fsanitize="fuzzer,$checks" -fopenmp -DFUZZ_READER="fuzz_$reader" -o "$reader" \
      "$here/tests/fuzz/libfuzzer.c" libfuzz.a librefs.a libnineball.a -lgsl -lgslcblas -lm
  done
) >build.log 2>&1 || { tail build.log >&2; exit 1; }
build/tests/fuzz/replay --words >words

# ---- sessions --------------------------------------------------------------------------------------------------------

# Prints the folders with first inputs of a reader. Of a page of the tree only the title and the blocks are taken. Long pages and
# pages that need many attempts to fill are left out, because each session begins with reading all inputs.
sources() {
  rm -rf "seeds/$1" && mkdir -p "seeds/$1"
  build/tests/fuzz/replay --seeds "$1" "seeds/$1"
  if test "$1" != pages; then
    echo "seeds/$1 $here/tests/fuzz/corpus/$1"
    return
  fi
  cp "$here"/tests/fuzz/corpus/pages/* seeds/pages
  find "$here/tests/bad" "$here/tests/pages" "$here/cases" -name '*.md' | while read -r page; do
    awk 'NR == 1 || /^```[a-z]/ { print; inside = NR > 1; next } inside { print } /^```$/ { inside = 0 }' "$page" \
      >"seeds/pages/$(basename "$page")"
  done
  find seeds/pages -type f | while read -r page; do
    if test "$(wc -c <"$page")" -gt "$(longest pages)" || grep -qaE 'attempts +[0-9]{4}' "$page"; then rm "$page"; fi
  done
  echo seeds/pages
}

# Prints the largest number of bytes of an input. Short inputs are read faster, and their numbers and words are changed more often.
# The longest inputs are those that the program makes: a state with each kind of record.
longest() {
  case $1 in
    expressions) echo 256 ;;
    states) echo 12288 ;;
    checkpoints) echo 20480 ;;
    packings) echo 4096 ;;
    pages) echo 1024 ;;
    *) echo 512 ;;
  esac
}

# A row of sessions.tsv from what libFuzzer prints at its end.
row() {
  awk -v reader="$1" -v date="$(date +%F)" -v OFS='\t' '
    /^[0-9]+m[0-9.]+s [0-9]+m[0-9.]+s$/ { processor = 0 # the last such line counts
      for (k = 1; k <= 2; k++) { split($k, time, "m"); processor += 60 * time[1] + time[2] } }
    / cov: / { for (k = 1; k < NF; k++) { if ($k == "cov:") edges = $(k + 1); if ($k == "corp:") inputs = $(k + 1) } }
    /^stat::number_of_executed_units:/ { executions = $2 }
    /^#[0-9]+/ { last = substr($1, 2) }
    /ERROR: libFuzzer: timeout/ { timeouts++ }
    /ERROR: libFuzzer: out-of-memory/ { memory++ }
    /SUMMARY: / && !/timeout|out-of-memory/ { errors++ }
    END { sub(/\/.*/, "", inputs)
      print reader, executions ? executions : last + 0, inputs + 0, edges + 0, errors + 0, timeouts + 0, memory + 0, date, processor + 0 }
  ' "$1.log" >>sessions.tsv
}

search() {
  mkdir -p "$1"
  # shellcheck disable=SC2046
  set -- "$1" $(sources "$1")
  (
    status=0
    nice -n "${FUZZ_NICE:-10}" "build/$1" -max_total_time="$seconds" -timeout=60 -report_slow_units=60 -rss_limit_mb=3000 \
      -max_len="$(longest "$1")" -dict=words -print_funcs=0 -entropic=0 -print_final_stats=1 \
      -artifact_prefix="failed/$1-" "$@" || status=$?
    times
    exit "$status"
  ) >"$1.log" 2>&1 && status=0 || status=$?
  row "$1"
  test "$status" -eq 0 || echo "fuzz: $1 failed; look at $(pwd)/$1.log"
}

# All sessions of all readers. Executions per second are of processor time, because a session at a low priority may run
# for a hundredth of the time that passes. A failed input counts once for each session that found it.
report() {
  echo '| reader | executions | per second | inputs kept | edges reached | errors | timeouts | memory limits |'
  echo '| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |'
  awk -F '\t' '
    { if (!($1 in sum)) order[++n] = $1
      sum[$1] += $2; timed[$1] += $9 ? $2 : 0; processor[$1] += $9; if ($3) inputs[$1] = $3; if ($4 > edges[$1]) edges[$1] = $4; errors[$1] += $5; timeouts[$1] += $6; memory[$1] += $7 }
    END {
      for (k = 1; k <= n; k++) { r = order[k]; total += sum[r]
        printf "| %s | %.0f | %.0f | %d | %d | %d | %d | %d |\n", r, sum[r], processor[r] ? timed[r] / processor[r] : 0, inputs[r], edges[r], errors[r], timeouts[r], memory[r] }
      printf "| all | %.0f |\n", total }' sessions.tsv
}

# Replaces the inputs that libFuzzer has named by a hash, and keeps inputs with other names. The inputs that the program makes and
# the pages of the tree are not stored, because `make check` reads them anyway. A short input is kept if it reaches a line more
# often than other inputs do, a long input only if it reaches a new line.
keep() {
  corpus=$here/tests/fuzz/corpus/$1 counters=1 most=512
  rm -rf least && mkdir least
  sources "$1" >/dev/null
  find "seeds/$1" -type f -exec cp {} least \;
  case $1 in
    pages) cp "$here"/tests/bad/*.md least && counters=0 most=1024 ;;
    packings) most=4096 ;;
    states | checkpoints) counters=0 most=8192 ;;
  esac
  "build/$1" -set_cover_merge=1 -use_counters=$counters -max_len=$most least "$corpus" "$1" >"$1.log" 2>&1
  for folder in "$corpus" least; do
    ls "$folder" | grep -xE '[0-9a-f]{40}' | while read -r file; do
      if test "$folder" = least; then mv "least/$file" "$corpus"; else rm "$folder/$file"; fi
    done
  done
}

test "$seconds" -eq 0 || for reader in $readers; do search "$reader"; done
if test -n "${FUZZ_KEEP:-}"; then
  for reader in $readers; do keep "$reader"; done
fi
report | tee report.md
test -z "$(ls failed)" || {
  echo "fuzz: inputs that failed; read one with $(pwd)/build/tests/fuzz/replay READER FILE"
  ls failed
  exit 1
}
