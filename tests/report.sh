#!/bin/sh
# Tests `figure`, `report` and `state` with unusual pages and with failures: exit status, files, and how names are
# shown. TAP. $NINEBALL is the program, $srcdir the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
pages=$(pwd)/tests/pages
cd "$work" || exit 1

# ---- names ----

bell=$(printf 'a\033]0;b\007.md')
newline="a
system('touch harm')"
cp "$pages/passes.md" "$bell"
cp "$pages/passes.md" "$newline.md"
for command in run check figure report explain state; do
  run 2 $command "$bell" && said 'a?]0;b?.md' && ! LC_ALL=C grep -q "$(printf '[\033\007]')" "$why" && test ! -e report
  result $? "$command: control characters in the name of a page are refused and not shown"
done
run 2 report "$newline.md" && said "a?system('touch harm').md" && test ! -e harm
result $? 'a line end in the name of a page'
run 2 check "$pages/passes.md" --set "v=$(printf '1\033[2J')" && said 'v=1?[2J' && ! LC_ALL=C grep -q "$(printf '\033')" "$why"
result $? 'control characters in --set'
NINEBALL_STATES=$(printf 'x\033[2J') run 2 check "$pages/passes.md" && ! LC_ALL=C grep -q "$(printf '\033')" "$why"
result $? 'control characters in NINEBALL_STATES'
rm -f "$bell" "$newline.md"

strange="<b>&\"'#%20?"
sed 's/^# .*/# <script>alert(1)<\/script>/' "$pages/asks-nothing.md" >"$strange.md"
run 2 report "$strange.md" -o strange && said 'nothing was checked' &&
  test "$(grep -c '<script>\|<b>' strange/index.html)" -eq 0 &&
  grep -q '&lt;b&gt;&amp;&quot;&#39;#%20?</a>' strange/index.html &&
  grep -q 'href="%3Cb%3E%26%22%27%23%2520%3F/table.tsv"' strange/index.html
result $? 'characters of HTML in a name and a title are escaped'

run 0 report "$pages/warns.md" --set refine=0.5 --set refine=1 -o warns && cp warns/index.html "$why" &&
  grep -qx '<p>Warning: --set refine=0.5 has no effect: --set refine=1 follows it</p>' warns/index.html &&
  grep -q '^<p>Warning: line 4: friction between' warns/index.html
result $? 'warnings of the report have the line of the page, if they have one'

mkdir one other
cp "$pages/passes.md" one/page.md
cp "$pages/passes.md" other/page.md
for command in run figure report; do
  run 2 $command one/page.md other/page.md && said 'one/page.md and other/page.md have the same name' &&
    test ! -e page.out && test ! -e report
  result $? "$command: two pages of one name do not share a folder"
done

# ---- existing files ----

cp one/page.md keep.md
run 2 state one/page.md -o keep.md && said 'keep.md is not a state' && cmp -s one/page.md keep.md
result $? 'state -o does not overwrite a page'
run 0 state one/page.md -o made.state && run 0 state one/page.md -o made.state
result $? 'but it overwrites a state'
ln -s keep.md link.state
run 2 state one/page.md -o link.state && cmp -s one/page.md keep.md && test -h link.state
result $? 'it does not follow or replace a link'

# The name of a temporary file contains the process number: links are made for all numbers that the process can get.
mkdir links
echo mine >mine
sh -c 'p=$$; k=0; while test $k -lt 2000; do ln -s ../mine links/table.tsv.$((p + k)).new; k=$((k + 1)); done; exec "$0" run one/page.md -o links' "$nineball" >"$why" 2>&1
test "$(cat mine)" = mine && ! test -h links/table.tsv
result $? 'a temporary file follows no link'
mkdir left
: >left/table.tsv.1.new
: >left/table.tsv.999999.new
: >left/other.tsv.1.new
run 0 run one/page.md -o left && test ! -e left/table.tsv.1.new && test ! -e left/table.tsv.999999.new && test -e left/other.tsv.1.new
result $? 'temporary files of ended processes are removed'
(
  flock 9
  run 0 run one/page.md -o left && test -e left/table.tsv.7.new
) 9>left/table.tsv.7.new
result $? 'the temporary file of a running process stays'

# ---- status ----

run 3 report "$pages/never-ends.md" "$pages/passes.md" -o some && said 'did not run to its end' &&
  grep -q 'href="never-ends/table.tsv"' some/index.html && test -s some/never-ends/wait-particles.tsv &&
  grep -q 'did not end within 20 cycles' some/index.html
result $? 'report: an aborted run is status 3, and its tables are written'
run 2 report none.md "$pages/passes.md" -o some && grep -q '>none</a>' some/index.html
result $? 'report: a page that cannot be read has a line'
run 0 report "$pages/hidden.md" -o some && said '2 checks, 0 failed' &&
  grep -q '<td>2</td><td class="pass">0</td><td>0</td><td>6</td>' some/index.html &&
  grep -q '2 checks, 0 failed, 0 noted, 6 skipped' some/index.html
result $? 'report: skipped expectations are counted separately'
run 2 report "$pages/passes.md" "$pages/asks-nothing.md" -o some && said '0 checks, 0 failed; nothing was checked' &&
  grep -q '<td>0</td><td class="fail">0, nothing was checked</td>' some/index.html &&
  grep -q '1 on which nothing was checked' some/index.html
result $? 'report: a page on which nothing was checked has not passed'
run 2 report "$pages/fails.md" "$pages/mistaken.md" "$pages/passes.md" -o mixed &&
  grep -q '>fails</a>' mixed/index.html && grep -q '>mistaken</a>' mixed/index.html && grep -q '>passes</a>' mixed/index.html &&
  test -s mixed/fails/table.tsv && test -s mixed/passes/table.tsv && test ! -e mixed/mistaken &&
  grep -q 'mistaken.md:6:16: error: expected' mixed/index.html
result $? 'report: an invalid page is status 2, and the other pages are run'
sed 's/kn 1  ks 1 //; s/^shear .*//; s/^step .*/step 0.1 of single-contact/' "$pages/passes.md" >endless.md
run 2 report endless.md -o mixed && grep -q 'line 12: the step is computed as inf: ' mixed/index.html
result $? 'report: an error at run time names its line'
run 3 report "$pages/mistaken.md" "$pages/never-ends.md" "$pages/fails.md" "$pages/passes.md" -o mixed &&
  test -s mixed/fails/table.tsv && test -s mixed/passes/table.tsv && test -s mixed/never-ends/table.tsv
result $? 'report: the status is the worst of all pages'
mkdir -p blocked && : >blocked/passes
run 2 report "$pages/passes.md" -o blocked && said 'no tables' && grep -q 'no tables' blocked/index.html
result $? 'report: tables that cannot be written are status 2'

if command -v gnuplot >/dev/null; then
  sed 's/^plot .*/plot $nothing/' "$pages/passes.md" >broken.md
  run 2 report broken.md -o some && said 'no datablock named $nothing' && said 'no figure' &&
    grep -q 'no datablock named' some/index.html && test ! -e some/broken/broken.svg
  result $? 'report: a figure that cannot be drawn is status 2, and says why'
  sed 's/^plot .*//' "$pages/passes.md" >empty.md
  run 2 figure empty.md -o some && said 'draws nothing'
  result $? 'figure: a block that draws nothing is status 2'
  printf '\n```gnuplot\nplot $table using "cycle/-":"D.x/-" with points\n```\n' | cat "$pages/never-ends.md" - >stopped.md
  run 3 figure stopped.md -o some && said 'look at some/stopped.svg, up to where the run was stopped' &&
    grep -q INCOMPLETE some/stopped.svg
  result $? 'figure: an aborted run is drawn, and the figure says so'
  printf '\n```gnuplot\nplot $table using "time/-":"D.x/-" with points\n```\n' | cat "$pages/fails.md" - >failed.md
  run 0 figure failed.md -o some && said 'look at some/failed.svg' && ! said 'up to where' &&
    ! grep -q INCOMPLETE some/failed.svg && ! grep -q INCOMPLETE some/failed.gp
  result $? 'figure: a page that fails is complete'
  # If the first run of a sweep is aborted, the others are not started and have no tables.
  run 3 figure "$pages/../../cases/8-published/chung-ooi-3.md" --set 'step=1 s' --jobs 1 -o some &&
    said 'look at some/chung-ooi-3.svg, up to where the run was stopped'
  result $? 'figure: a sweep whose first run is aborted'
fi
echo "1..$n"
