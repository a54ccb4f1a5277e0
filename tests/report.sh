#!/bin/sh
# Tests `figure`, `report` and `state` with unusual pages and with failures: exit status, files, and the display of names. TAP.
# $NINEBALL is the program, $srcdir the top of the source tree.
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
  ! grep -q 'script>alert\|<b>' strange/index.html "strange/$strange/index.html" &&
  grep -q '&lt;b&gt;&amp;&quot;&#39;#%20?</a>' strange/index.html &&
  grep -q 'href="%3Cb%3E%26%22%27%23%2520%3F/index.html"' strange/index.html &&
  grep -q 'href="table.tsv"' "strange/$strange/index.html"
result $? 'characters of HTML in a name and a title are escaped'

run 0 report "$pages/warns.md" --set refine=0.5 --set refine=1 -o warns && cp warns/warns/index.html "$why" &&
  grep -qx '<p>Warning: --set refine=0.5 has no effect: --set refine=1 follows it</p>' "$why" &&
  grep -q '^<p>Warning: line 4: friction between' "$why"
result $? 'warnings of the report have the line of the page, if they have one'

mkdir one other
cp "$pages/passes.md" one/page.md
cp "$pages/passes.md" other/page.md
for command in run figure report; do
  run 2 $command one/page.md other/page.md && said 'one/page.md and other/page.md have the same name' &&
    test ! -e page.out && test ! -e report
  result $? "$command: two pages of one name do not share a folder"
done

mkdir -p two/here two/there
sed 's/^# .*/# First/' "$pages/asks-nothing.md" >two/here/first.md
sed 's/^# .*/# Second/' "$pages/asks-nothing.md" >two/there/second.md
run 2 report two/here/first.md two/there/second.md -o folders &&
  test "$(grep -o '<th colspan="4">[a-z]*</th>' folders/index.html | tr -d '\n')" = '<th colspan="4">here</th><th colspan="4">there</th>' &&
  grep -q '<script defer src="report.js"></script>' folders/index.html
result $? 'the index has the pages of each folder under its name, and its script'

# ---- existing files ----

cp one/page.md keep.md
run 2 state one/page.md -o keep.md && said 'keep.md is not a state' && cmp -s one/page.md keep.md
result $? 'state -o does not overwrite a page'
run 0 state one/page.md -o made.state && run 0 state one/page.md -o made.state
result $? 'state -o overwrites a state'
ln -s keep.md link.state
run 2 state one/page.md -o link.state && cmp -s one/page.md keep.md && test -h link.state
result $? 'state -o does not follow or replace a link'

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

ln -s ../mine left/nineball.lock
run 2 run one/page.md -o left && said 'cannot write left/nineball.lock' && test "$(cat mine)" = mine
result $? 'a lock follows no link'
rm left/nineball.lock
# 4 KiB are enough for a thread library and too few for the table. The messages go through a pipe, which has no limit of size.
sed 's/^cycles .*/cycles 1000/' one/page.md >long.md
(ulimit -f 8 && "$nineball" run long.md -o full 2>&1 >/dev/null || echo "status $?") | cat >"$why"
said 'cannot write full/table.tsv: File too large' && said 'status 2' && test -z "$(ls full)"
result $? 'a limit of the size of files: status 2, and no temporary file stays'

# ---- folders of a report ----

mkdir -p dots/.hidden mixture/own
for name in . ..; do
  cp one/page.md "dots/$name.md"
  run 2 report "dots/$name.md" -o dots/new && said "dots/$name.md has no name" && cmp -s one/page.md "dots/$name.md" && test ! -e dots/index.html
  result $? "report: a page with the name $name"
done
cp one/page.md mixture/own/README.md
echo mine >mixture/own/own.md
head -c 200000 /dev/zero >mixture/own/data.tsv
run 2 report mixture/own/README.md -o mixture && said 'mixture/own of mixture/own/README.md is a folder of pages' && test "$(cat mixture/own/own.md)" = mine
result $? 'report: the folder of a page is not its output folder'
cp one/page.md mixture/README.md
mkdir mixture/mixture && mv mixture/own/data.tsv mixture/mixture
run 0 report mixture/README.md -o mixture && test -s mixture/mixture/data.tsv
result $? 'report: a large table that the report has not written stays'
if command -v gnuplot >/dev/null; then
  grep -q 'src="README.svg"' mixture/mixture/index.html && grep -q 'href="README.png"' mixture/mixture/index.html && test -s mixture/mixture/README.svg
  result $? 'report: the figure of a README'
fi
echo secret >dots/.hidden/key
echo secret >dots/.key
sed 's/^The position/[a](.key) [b](.hidden\/key)/' one/page.md >dots/page.md
run 0 report dots/page.md -o dots/made && ! grep -q -r secret dots/made/files
result $? 'report: hidden files are not copied'

# ---- status ----

run 3 report "$pages/never-ends.md" "$pages/passes.md" -o some && said 'did not run to its end' &&
  grep -q 'href="table.tsv"' some/never-ends/index.html && test -s some/never-ends/wait-particles.tsv &&
  grep -q 'did not end within 20 cycles' some/index.html some/never-ends/index.html &&
  sed '/<h2>All pages/,$d; /id="pages-of/,$d' some/index.html | grep -q 'never-ends/index.html'
result $? 'report: an aborted run is status 3, and its tables are written'
run 2 report none.md "$pages/passes.md" -o some && grep -q '>none</a>' some/index.html
result $? 'report: a page that cannot be read has a line in the index'
mkdir -p taken/passes/index.html
run 2 report "$pages/passes.md" -o taken && said 'cannot write taken/passes/index.html'
result $? 'report: a page of the report that cannot be written is status 2'
run 0 report "$pages/hidden.md" -o some && said '2 checks, 0 failed' &&
  grep -q '<td class="pass">2 checks passed</td>' some/index.html &&
  grep -qE '<td class="number">[0-9.e-]+ s</td>' some/index.html &&
  grep -q '2 checks, 0 failed, 0 noted, 6 skipped' some/hidden/index.html
result $? 'report: skipped expectations are counted separately'
run 2 report "$pages/passes.md" "$pages/asks-nothing.md" -o some && said '0 checks, 0 failed; nothing was checked' &&
  test "$(grep -c '<td class="fail">nothing was checked</td>' some/index.html)" -eq 2
result $? 'report: a page on which nothing was checked has not passed'
run 2 report "$pages/fails.md" "$pages/mistaken.md" "$pages/passes.md" -o mixed && said '2 checks, 1 failed' &&
  grep -q '>fails</a>' mixed/index.html && grep -q '>mistaken</a>' mixed/index.html && grep -q '>passes</a>' mixed/index.html &&
  test -s mixed/fails/table.tsv && test -s mixed/passes/table.tsv && test ! -e mixed/mistaken/table.tsv &&
  grep -q 'mistaken.md:6:16: error: expected' mixed/index.html mixed/mistaken/index.html
result $? 'report: an invalid page is status 2, and the other pages are run'
sed 's/kn 1  ks 1 //; s/^shear .*//; s/^step .*/step 0.1 of single-contact/' "$pages/passes.md" >endless.md
run 2 report endless.md -o mixed && grep -q 'line 12: the step has no limit: ' mixed/endless/index.html
result $? 'report: an error at run time names its line'
run 3 report "$pages/mistaken.md" "$pages/never-ends.md" "$pages/fails.md" "$pages/passes.md" -o mixed &&
  test -s mixed/fails/table.tsv && test -s mixed/passes/table.tsv && test -s mixed/never-ends/table.tsv
result $? 'report: the status is the worst of all pages'
mkdir -p blocked/passes/table.tsv
run 2 report "$pages/passes.md" -o blocked && said 'no tables' && grep -q 'no tables' blocked/index.html
result $? 'report: tables that cannot be written are status 2'

# ---- the site ----

mkdir -p site/sub
cat >site/README.md <<'END'
# All about it

Read [the page](first.md#theory), [data](sub/data.tsv), [code](../secret.c), [mail](mailto:a@b.c), [bad](javascript:alert(1)),
[away](https://example.org/x) and [none](nothing.md). <script>alert(2)</script> <b onclick="alert(3)">bold</b>

![picture](sub/p.svg) ![outside](../secret.svg)
END
sed 's/^# .*/# First \& <last>\n\nThe root is $\\sqrt{2}$, see [all](README.md) and [second](second.md)./' "$pages/passes.md" >site/first.md
cp "$pages/swept.md" site/second.md
printf '1\t2\n' >site/sub/data.tsv
printf '<svg xmlns="http://www.w3.org/2000/svg"/>' | tee site/sub/p.svg >secret.svg
echo 'int secret;' >secret.c
run 0 report site/README.md site/first.md site/second.md -o made && cp made/index.html "$why" &&
  grep -q 'href="first/index.html#theory"' made/index.html && grep -q 'title="1 check passed"' made/index.html &&
  grep -q 'href="files/sub-data.tsv.txt"' made/index.html && cmp -s site/sub/data.tsv made/files/sub-data.tsv.txt &&
  grep -q 'src="files/sub-p.svg"' made/index.html && grep -q 'href="mailto:a@b.c"' made/index.html &&
  grep -q 'href="https://example.org/x"' made/index.html
result $? 'report: links to pages and to files below the folder of the page; the first document is the index'
! grep -q -i 'secret\|javascript:\|alert(2)</script\|onclick\|nothing.md' made/index.html && test "$(ls made/files | wc -l)" -eq 2
result $? 'report: no raw HTML, no script, no file outside of the folder of the page'
# Files whose last two folders have the same names: the second one gets a number, and each keeps its ending.
mkdir -p two/a/sub two/b/sub
for folder in a b; do
  echo "$folder" >two/$folder/sub/data.tsv
  printf '<svg xmlns="http://www.w3.org/2000/svg" id="%s"/>' $folder >two/$folder/sub/p.svg
done
printf '# Two\n\n[a](a/sub/data.tsv), [b](b/sub/data.tsv), ![a](a/sub/p.svg), ![b](b/sub/p.svg)\n' >two/README.md
run 0 report two/README.md -o both && ls both/files >"$why" && test "$(wc -l <"$why")" -eq 4 &&
  cmp -s two/a/sub/data.tsv both/files/sub-data.tsv.txt && cmp -s two/b/sub/data.tsv both/files/[0-9]*-sub-data.tsv.txt &&
  cmp -s two/a/sub/p.svg both/files/sub-p.svg && cmp -s two/b/sub/p.svg both/files/[0-9]*-sub-p.svg
result $? 'report: files of the same name in different folders'
run 0 report site/README.md site/first.md site/second.md -o made --trust && grep -q 'files/.*-secret.c.txt' made/index.html
result $? 'report --trust copies any file to which a page links'
grep -q '<math.*<msqrt>' made/first/index.html && grep -q '<h1 [^>]*>First &amp; &lt;last&gt;</h1>\|<h1 [^>]*>First &amp;' made/first/index.html &&
  grep -q 'href="../second/index.html"' made/first/index.html && grep -q '<a rel="next"' made/first/index.html &&
  grep -q '<a rel="prev"' made/second/index.html && cmp -s site/first.md made/first/first.md
result $? 'report: typeset mathematics, previous and next page, the source'
awk '/```expect/ { checks = NR } END { exit !checks }' site/second.md && grep -q '<circle' made/second/index.html
result $? 'report: a trend shows its points'
run 0 report site/first.md --unrun site/second.md -o unrun && grep -q 'not run' unrun/index.html &&
  grep -q 'nineball check site/second.md' unrun/second/index.html && test ! -e unrun/second/table.tsv
result $? 'report: a page that is not run says how to run it'
run 2 report site/first.md other/../site/first.md -o unrun && said 'have the same name'
result $? 'report: a page that is given twice'
PATH=$work/none run 2 report site/first.md -o without && said 'needs pandoc' && test ! -e without
result $? 'report: without pandoc nothing is run'
sed 's/^cycles .*/cycles 40000/' "$pages/passes.md" >long.md
run 1 report long.md -o long && test ! -e long/long/table.tsv && test ! -e long/long/long.gp && test -e long/long/values.tsv &&
  grep -q 'Not kept here, because they are large: ' long/long/index.html && ! grep -q 'href="table.tsv"' long/long/index.html
result $? 'report: a large table is not kept, and the page says how to make it'

if command -v gnuplot >/dev/null; then
  sed 's/^plot .*/plot $nothing/' "$pages/passes.md" >broken.md
  run 2 report broken.md -o some && said 'no datablock named $nothing' && said 'no figure' &&
    grep -q 'no datablock named' some/broken/index.html && test ! -e some/broken/broken.svg
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
    said 'a check of this page failed: type `nineball check failed.md`' &&
    ! grep -q INCOMPLETE some/failed.svg && ! grep -q INCOMPLETE some/failed.gp
  result $? 'figure: a page with a failed check is drawn as complete'
  # If the first run of a sweep is aborted, the others are not started and have no tables.
  run 3 figure "$pages/../../cases/8-published/chung-ooi-3.md" --set 'step=1 s' --jobs 1 -o some &&
    said 'look at some/chung-ooi-3.svg, up to where the run was stopped'
  result $? 'figure: a sweep whose first run is aborted'
fi
echo "1..$n"
