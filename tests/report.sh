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

mkdir -p two/here two/then
sed 's/^# .*/# First/' "$pages/asks-nothing.md" >two/here/first.md
sed 's/^# .*/# Second/' "$pages/asks-nothing.md" >two/then/second.md
run 2 report two/here/first.md two/then/second.md -o folders &&
  test "$(grep -o '<th colspan="4">[a-z]*</th>' folders/index.html | tr -d '\n')" = '<th colspan="4">here</th><th colspan="4">then</th>' &&
  grep -q '<script defer src="report.js"></script>' folders/index.html && grep -qx '<h1>nineball report</h1>' folders/index.html
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
  run 2 report "dots/$name.md" -o dots/new && said "dots/$name.md has no name that an output folder can have: rename it" && cmp -s one/page.md "dots/$name.md" && test ! -e dots/index.html
  result $? "report: a page with the name $name"
done
cp one/page.md mixture/own/README.md
echo mine >mixture/own/own.md
head -c 200000 /dev/zero >mixture/own/data.tsv
run 2 report mixture/own/README.md one/page.md -o mixture && said 'the output folder mixture/own of mixture/own/README.md is a folder of pages, whose files would be overwritten: choose another folder with -o' && test "$(cat mixture/own/own.md)" = mine
result $? 'report: the folder of a page is not its output folder'
mkdir -p input1/sub1 && cp one/page.md input1/sub1/page.md # its path is as long as that of its output folder
run 0 report input1/sub1/page.md -o output && run 0 report input1/sub1/page.md -o output
result $? 'report: its output folder may exist'
cp one/page.md mixture/README.md
mkdir mixture/mixture && mv mixture/own/data.tsv mixture/mixture
run 0 report mixture/README.md -o mixture && test -s mixture/mixture/data.tsv && grep -q '<th colspan="4">mixture</th>' mixture/index.html
result $? 'report: a large table that the report has not written stays'
cp one/page.md README.md && run 0 report README.md -o root && grep -q '<th colspan="4">\.</th>' root/index.html && grep -q '<h1>nineball report' root/index.html && rm README.md
result $? 'report: a README in the present folder that is no document'
bell=$(printf 'a\033b')
mkdir "$bell" && cp one/page.md "$bell/README.md"
(cd "$bell" && run 0 report README.md -o "$work/root") && grep -q '>a?b</a>' root/index.html && ! LC_ALL=C grep -q "$(printf '\033')" root/index.html "$why"
result $? 'report: control characters in the name of the folder of a README'
rm -r "$bell"
if command -v gnuplot >/dev/null; then
  grep -q 'src="README.svg"' mixture/mixture/index.html && grep -q 'href="README.png"' mixture/mixture/index.html && test -s mixture/mixture/README.svg
  result $? 'report: the figure of a README'
fi
echo secret >dots/.hidden/key
echo secret >dots/.key
sed 's/^The position/[a](.key) [b](.hidden\/key)/' one/page.md >dots/page.md
run 0 report dots/page.md -o dots/made && ! grep -q -r secret dots/made/files
result $? 'report: hidden files are not copied'
sed 's/^The position/[a](key)/' one/page.md >dots/.hidden/page.md
run 0 report dots/.hidden/page.md -o dots/made && grep -q secret dots/made/files/.hidden-key.txt
result $? 'report: files beside a page in a hidden folder are copied'

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
run 2 report "$pages/passes.md" -o blocked && grep -qx 'passes *1 checks, 0 failed; no tables' "$why" && grep -q 'no tables' blocked/index.html &&
  ! grep -q 'href="table.tsv"' blocked/passes/index.html
result $? 'report: tables that cannot be written are status 2'

# ---- the site ----

mkdir -p site/sub site-2
echo secret >site-2/data.tsv
cat >site/README.md <<'END'
# All about it

Read [the page](first.md#theory), [data](sub/data.tsv), [code](../secret.c), [mail](mailto:a@b.c), [bad](javascript:alert(1)),
[away](https://example.org/x), [beside](../site-2/data.tsv) and [none](nothing.md). <script>alert(2)</script> <b onclick="alert(3)">bold</b>

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
# Pictures by their ending, and texts, which have no zero byte, of at most 300000 bytes are copied. A text gets the ending .txt.
mkdir -p linked/in
for name in a.svg b.png c.jpg d.jpeg e.gif f.webp g.bin; do printf 'x\0' >linked/in/$name; done
echo text >linked/in/h.bin
head -c 300000 /dev/zero | tr '\0' x >linked/in/most.txt
{ cat linked/in/most.txt && printf x; } >linked/in/more.txt
{
  printf '# Links\n\n```text\n[no](in/h.bin)\n```\n\n'
  for file in linked/in/*; do printf '[link](in/%s#part "a title") and [again](in/%s)\n' "${file##*/}" "${file##*/}"; done
} >linked/README.md
run 0 report linked/README.md -o linked-site && ls linked-site/files | tr '\n' ' ' >given
printf 'in-a.svg in-b.png in-c.jpg in-d.jpeg in-e.gif in-f.webp in-h.bin.txt in-most.txt.txt ' | diff - given >"$why" &&
  test "$(grep -o 'href="files/in-[^"]*"' linked-site/index.html | sed 's/.*in-\(.*\)"/\1/' | tr '\n' ' ')" = \
    'a.svg#part a.svg b.png#part b.png c.jpg#part c.jpg d.jpeg#part d.jpeg e.gif#part e.gif f.webp#part f.webp h.bin.txt h.bin.txt most.txt.txt most.txt.txt '
result $? 'report: the kinds and the largest size of files that are copied'
run 0 report site/README.md site/first.md site/second.md -o made --trust && grep -q 'files/.*-secret.c.txt' made/index.html
result $? 'report --trust copies any file to which a page links'
grep -q '<math.*<msqrt>' made/first/index.html && grep -q '<h1 [^>]*>First &amp; &lt;last&gt;</h1>\|<h1 [^>]*>First &amp;' made/first/index.html &&
  grep -q 'href="../second/index.html"' made/first/index.html && grep -q '<a rel="next"' made/first/index.html &&
  grep -q '<a rel="prev"' made/second/index.html && cmp -s site/first.md made/first/first.md
result $? 'report: typeset mathematics, previous and next page, the source'
awk '/```expect/ { checks = NR } END { exit !checks }' site/second.md && grep -q '<circle' made/second/index.html
result $? 'report: a trend shows its points'
run 0 report site/first.md --unrun site/second.md --unrun "$pages/hidden.md" -o unrun && grep -q 'not run' unrun/index.html &&
  grep -q 'nineball check site/second.md' unrun/second/index.html && test ! -e unrun/second/table.tsv && test -e unrun/hidden/index.html
result $? 'report: a page that is not run says how to run it'
run 2 report site/first.md other/../site/first.md -o unrun && said 'have the same name'
result $? 'report: a page that is given twice'
PATH=$work/none run 2 report site/first.md -o without && said 'nineball: a report needs pandoc, which was not found (its package is pandoc)' && test ! -e without
result $? 'report: without pandoc nothing is run'
sed 's/^cycles .*/cycles 40000/' "$pages/passes.md" >long.md
run 1 report long.md -o long && test ! -e long/long/table.tsv && test ! -e long/long/long.gp && test -e long/long/values.tsv &&
  grep -q 'Not kept here, because they are large: ' long/long/index.html && ! grep -q 'href="table.tsv"' long/long/index.html
result $? 'report: a large table is not kept, and the page says how to make it'

# ---- the whole site ----

# site_page TITLE SWEEP EXPECTATIONS: prints a page with discs that move by v and by -1 in each direction.
site_page() {
  printf '# %s\n\n```scene\nunits none\nsweep v %s\nmaterial m density 1 kn 1\ndisc 1 2 radius 0.5 m velocity $v -1\nmonitor D disc 1\n' "$1" "$2"
  printf 'step 0.5\nrecord time D.x D.y\nstage go\ncycles 2\n```\n\n```expect\n%b\n```\n' "$3"
}
mkdir -p whole/sub
printf '# All & more\n' >whole/README.md
site_page 'First' '1 4 64' 'D.x increases with v\nD.y expected 1 within 0 [2 - 1]\nreport D.y' >whole/a.md
site_page 'Second' '1 4 31' 'D.x decreases with v\nD.y constant with v within 0\nD.x above D.x max' >whole/sub/b.md
site_page 'Third' '1' 'D.y above 0' >whole/sub/c.md
site_page 'Fourth' '1' 'D.x above 0' | sed 's/^step .*/step -1/' >whole/sub/d.md
site_page 'Fifth' '1' 'D.x above 0\nD.y increases with v' | sed 's/^cycles.*/until D.x above 9 at most 2 cycles/' >whole/sub/e.md
"$nineball" report whole/README.md whole/a.md whole/sub/b.md whole/sub/d.md whole/sub/e.md --unrun whole/sub/c.md -o whole-site >out 2>/dev/null </dev/null
echo "status $?" >>out
# What pandoc makes of the blocks of a page is not compared, nor are times. Head and foot are compared of the index and of one page.
for name in . a whole b c d e; do
  case $name in . | a) parts='' ;; *) parts='1,4d; /<footer>/,$d' ;; esac
  sed "/<pre class=\"expect.*<\/pre>/d; /<pre class=\"scene/,/<\/pre>/d; /<pre class=\"expect/,/<\/pre>/d; s/\(number\">\|updates, \)[0-9.e-]* s</\1T s</
    s/nineball [0-9]*\.[0-9]*\.[0-9]*/nineball VERSION/; $parts" "whole-site/$name/index.html"
done >>out
# The picture of a trend has 140 by 50 units and margins of 5. A scale is logarithmic if the values span more than 1.5 decades: 4 is at a
# third of 1 to 64, and 5 at log(2.5)/log(32.5) of 2 to 65; but 4 is at a tenth of 1 to 31, and 5 at a tenth of 2 to 32.
diff -u - out >"$why" <<'END'
a                               4 checks, 0 failed
b                               5 checks, 4 failed
d                               0 checks, 0 failed; did not run to its end
e                               0 checks, 0 failed; did not run to its end
look at whole-site/index.html
status 3
<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src 'self' file:; style-src 'self' file: 'unsafe-inline'; script-src 'self' file:">
<title>nineball report</title>
<link rel="stylesheet" href="report.css">
<script defer src="report.js"></script>
</head><body>
<main>
<p>4 pages were run: 9 checks, <span class="fail">4 failed</span>. Made by nineball VERSION. <a href="#pages-of-the-report">Search and list of all pages</a></p>
<div class="failures"><h2>What failed</h2><table><tbody>
<tr><td><a href="b/index.html">b</a></td><td>Second</td><td class="fail">4 of 5 checks failed</td><td class="number">T s</td></tr>
<tr><td><a href="d/index.html">d</a></td><td>Fourth</td><td class="fail">did not run to its end<br><small>whole/sub/d.md:9:6: error: expected a time above 0, found `-1`
    9 | step -1
      |      ^~
</small></td><td></td></tr>
<tr><td><a href="e/index.html">e</a></td><td>Fifth</td><td class="fail">did not run to its end<br><small>stage `go` (line 11) did not end within 2 cycles: D.x is 2 and should be above 9</small></td><td class="number">T s</td></tr>
</tbody></table></div>
<h1 id="all--more">All &amp; more</h1>
<h2 id="pages-of-the-report">All pages</h2>
<p><label>Search names, titles and results: <input type="search"></label></p>
<p id="none" hidden>No page has all of these words.</p>
<table id="pages"><thead><tr><th>page</th><th>title</th><th>checks</th><th>time</th></tr></thead><tbody>
<tr><th colspan="4">All &amp; more</th></tr>
<tr><td><a href="whole/index.html">whole</a></td><td>All &amp; more</td><td class="none"></td><td></td></tr>
<tr><td><a href="a/index.html">a</a></td><td>First</td><td class="pass">4 checks passed</td><td class="number">T s</td></tr>
<tr><th colspan="4">sub</th></tr>
<tr><td><a href="b/index.html">b</a></td><td>Second</td><td class="fail">4 of 5 checks failed</td><td class="number">T s</td></tr>
<tr><td><a href="d/index.html">d</a></td><td>Fourth</td><td class="fail">did not run to its end<br><small>whole/sub/d.md:9:6: error: expected a time above 0, found `-1`
    9 | step -1
      |      ^~
</small></td><td></td></tr>
<tr><td><a href="e/index.html">e</a></td><td>Fifth</td><td class="fail">did not run to its end<br><small>stage `go` (line 11) did not end within 2 cycles: D.x is 2 and should be above 9</small></td><td class="number">T s</td></tr>
<tr><td><a href="c/index.html">c</a></td><td>Third</td><td class="none">not run</td><td></td></tr>
</tbody></table>
</main></body></html>
<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src 'self' file:; style-src 'self' file: 'unsafe-inline'; script-src 'self' file:">
<title>First</title>
<link rel="stylesheet" href="../report.css">
</head><body>
<nav><a href="../index.html">contents</a>
<a rel="prev" href="../whole/index.html">previous: whole</a>
<a rel="next" href="../b/index.html">next: b</a>
</nav>
<main>
<p class="pass">4 checks passed</p>
<h1 id="first">First</h1>
<details open><summary>Results: 4 checks, 0 failed, 3 noted, 0 skipped</summary>
<table><thead><tr><th></th><th>expectation</th><th>computed</th><th>reference</th><th>error</th><th>tolerance</th></tr></thead><tbody>
<tr><td class="pass">pass</td><td>D.y expected 1 within 0 [2 - 1] (v=1)</td><td class="number">1</td><td class="number">1</td><td class="number">0</td><td class="number">0</td></tr>
<tr><td class="note">note</td><td>report D.y (v=1)</td><td colspan="4">computed 1</td></tr>
<tr><td class="pass">pass</td><td>D.y expected 1 within 0 [2 - 1] (v=4)</td><td class="number">1</td><td class="number">1</td><td class="number">0</td><td class="number">0</td></tr>
<tr><td class="note">note</td><td>report D.y (v=4)</td><td colspan="4">computed 1</td></tr>
<tr><td class="pass">pass</td><td>D.y expected 1 within 0 [2 - 1] (v=64)</td><td class="number">1</td><td class="number">1</td><td class="number">0</td><td class="number">0</td></tr>
<tr><td class="note">note</td><td>report D.y (v=64)</td><td colspan="4">computed 1</td></tr>
<tr><td class="pass">pass</td><td>D.x increases with v</td><td colspan="4"><svg class="points" role="img" aria-label="computed 2 at v = 1, 5 at 4, 65 at 64" viewBox="0 0 140 50"><polyline fill="none" points="5.0,45.0 48.3,34.5 135.0,5.0 "/><circle cx="5.0" cy="45.0" r="2"/><circle cx="48.3" cy="34.5" r="2"/><circle cx="135.0" cy="5.0" r="2"/></svg><br>computed 2 at v = 1, 5 at 4, 65 at 64</td></tr>
</tbody></table></details>
<p>Cost: 6 cycles, 0 contact updates, T s</p>
<p>Files: <a href="a.md">a.md</a>
<a href="table.tsv">table.tsv</a>
<a href="values.tsv">values.tsv</a>
<a href="verdict.tsv">verdict.tsv</a>
</p>
</main>
<footer><nav><a href="../index.html">contents</a>
<a rel="prev" href="../whole/index.html">previous: whole</a>
<a rel="next" href="../b/index.html">next: b</a>
</nav>
</footer></body></html>
<title>All &amp; more</title>
<link rel="stylesheet" href="../report.css">
</head><body>
<nav><a href="../index.html">contents</a>
<a rel="next" href="../a/index.html">next: a</a>
</nav>
<main>
<p class="none"></p>
<h1 id="all--more">All &amp; more</h1>
<p>Files: <a href="whole.md">whole.md</a>
</p>
</main>
<title>Second</title>
<link rel="stylesheet" href="../report.css">
</head><body>
<nav><a href="../index.html">contents</a>
<a rel="prev" href="../a/index.html">previous: a</a>
<a rel="next" href="../d/index.html">next: d</a>
</nav>
<main>
<p class="fail">4 of 5 checks failed</p>
<h1 id="second">Second</h1>
<details open><summary>Results: 5 checks, 4 failed, 0 noted, 0 skipped</summary>
<table><thead><tr><th></th><th>expectation</th><th>computed</th><th>reference</th><th>error</th><th>tolerance</th></tr></thead><tbody>
<tr><td class="fail">FAIL</td><td>D.x above D.x max (v=1)</td><td colspan="4">computed 2 and 2</td></tr>
<tr><td class="fail">FAIL</td><td>D.x above D.x max (v=4)</td><td colspan="4">computed 5 and 5</td></tr>
<tr><td class="fail">FAIL</td><td>D.x above D.x max (v=31)</td><td colspan="4">computed 32 and 32</td></tr>
<tr><td class="fail">FAIL</td><td>D.x decreases with v</td><td colspan="4"><svg class="points" role="img" aria-label="computed 2 at v = 1, 5 at 4, 32 at 31" viewBox="0 0 140 50"><polyline fill="none" points="5.0,45.0 18.0,41.0 135.0,5.0 "/><circle cx="5.0" cy="45.0" r="2"/><circle cx="18.0" cy="41.0" r="2"/><circle cx="135.0" cy="5.0" r="2"/></svg><br>computed 2 at v = 1, 5 at 4, 32 at 31</td></tr>
<tr><td class="pass">pass</td><td>D.y constant with v within 0</td><td colspan="4"><svg class="points" role="img" aria-label="computed 1 at v = 1, 1 at 4, 1 at 31, largest difference 0, tolerance 0" viewBox="0 0 140 50"><polyline fill="none" points="5.0,25.0 18.0,25.0 135.0,25.0 "/><circle cx="5.0" cy="25.0" r="2"/><circle cx="18.0" cy="25.0" r="2"/><circle cx="135.0" cy="25.0" r="2"/></svg><br>computed 1 at v = 1, 1 at 4, 1 at 31, largest difference 0, tolerance 0</td></tr>
</tbody></table></details>
<p>Cost: 6 cycles, 0 contact updates, T s</p>
<p>Files: <a href="b.md">b.md</a>
<a href="table.tsv">table.tsv</a>
<a href="values.tsv">values.tsv</a>
<a href="verdict.tsv">verdict.tsv</a>
</p>
</main>
<title>Third</title>
<link rel="stylesheet" href="../report.css">
</head><body>
<nav><a href="../index.html">contents</a>
<a rel="prev" href="../e/index.html">previous: e</a>
</nav>
<main>
<p class="none">not run</p>
<p>The report was made without running this page. To run it, type <code>nineball check whole/sub/c.md</code>.</p>
<h1 id="third">Third</h1>
<p>Files: <a href="c.md">c.md</a>
</p>
</main>
<title>Fourth</title>
<link rel="stylesheet" href="../report.css">
</head><body>
<nav><a href="../index.html">contents</a>
<a rel="prev" href="../b/index.html">previous: b</a>
<a rel="next" href="../e/index.html">next: e</a>
</nav>
<main>
<p class="fail">did not run to its end</p>
<pre class="fail">whole/sub/d.md:9:6: error: expected a time above 0, found `-1`
    9 | step -1
      |      ^~
</pre>
<h1 id="fourth">Fourth</h1>
<p>Files: <a href="d.md">d.md</a>
</p>
</main>
<title>Fifth</title>
<link rel="stylesheet" href="../report.css">
</head><body>
<nav><a href="../index.html">contents</a>
<a rel="prev" href="../d/index.html">previous: d</a>
<a rel="next" href="../c/index.html">next: c</a>
</nav>
<main>
<p class="fail">did not run to its end</p>
<pre class="fail">stage `go` (line 11) did not end within 2 cycles: D.x is 2 and should be above 9</pre>
<h1 id="fifth">Fifth</h1>
<p>Cost: 2 cycles, 0 contact updates, T s</p>
<p>Files: <a href="e.md">e.md</a>
<a href="table.tsv">table.tsv</a>
<a href="values.tsv">values.tsv</a>
<a href="verdict.tsv">verdict.tsv</a>
</p>
</main>
END
result $? 'report: the whole index and the pages: passed, failed, invalid, aborted and not run, a trend with a linear and a logarithmic scale'
# A list of more than 20 checks is folded if none of them failed.
site_page 'Short' "$(seq -s ' ' 20)" 'D.y expected 1 within 0 [2 - 1]' >short.md
site_page 'Long' "$(seq -s ' ' 21)" 'D.y expected 1 within 0 [2 - 1]' >long.md
site_page 'Failed' "$(seq -s ' ' 21)" 'D.x below 22' >failed.md
run 1 report short.md long.md failed.md "$pages/../../cases/5-numerics/order.md" -o lists
grep -o '<details.*Results: [^,]*, [^,]*' lists/short/index.html lists/long/index.html lists/failed/index.html | diff -u - /dev/fd/3 >"$why" 3<<'END'
lists/short/index.html:<details open><summary>Results: 20 checks, 0 failed
lists/long/index.html:<details><summary>Results: 21 checks, 0 failed
lists/failed/index.html:<details open><summary>Results: 21 checks, 1 failed
END
result $? 'report: a long list without failures is folded'
grep -q '^<tr><td class="pass">pass</td><td>D.x order 2 in h within 0.003<br><small>errors [0-9.e-]* at h = 0.002, [0-9.e-]* at .*</small></td><td colspan="4"><svg ' \
  lists/order/index.html
result $? 'report: the part of a message behind the tolerance'
# The scales of a trend are linear if the smallest value is 0 or negative: x = 0, 3, 6 and y = -1, 2, 5.
site_page 'Negative' '0 3 6' 'D.x increases with v' | sed 's/^disc 1/disc -1/' >negative.md
run 0 report negative.md -o lists && cp lists/negative/index.html "$why" &&
  grep -qF '<polyline fill="none" points="5.0,45.0 70.0,25.0 135.0,5.0 "/><circle cx="5.0" cy="45.0" r="2"/>' "$why"
result $? 'report: a trend of values of both signs'
printf '# Text\n' >text.md
site_page 'Two' '1 2' 'D.x increases with v' >two-points.md
run 0 report two-points.md --unrun one/page.md --unrun text.md -o lists && cp lists/two-points/index.html "$why" &&
  grep -qF '<polyline fill="none" points="5.0,45.0 135.0,5.0 "/><circle cx="5.0" cy="45.0" r="2"/><circle cx="135.0" cy="5.0" r="2"/>' "$why" &&
  test "$(grep -o 'index.html">[^<]*' lists/index.html | tr '\n' ' ')" = 'index.html">two-points index.html">page index.html">text '
result $? 'report: a trend of two points; two pages that are not run'
# The folder of a page may be above the folders of other pages. A file without text is a page with a mistake. A page that does not exist
# is no target of a link.
mkdir -p odd/negative/sub
cp negative.md odd/negative/sub/other.md
: >nothing.md
printf '\n[text](text.md) [none](no-page.md)\n' | cat negative.md - >linked.md
"$nineball" report negative.md odd/negative/sub/other.md no-page.md nothing.md linked.md --unrun text.md -o odd >out 2>given
test $? -eq 2 && diff -u - out >"$why" <<'END'
negative                        1 checks, 0 failed
other                           1 checks, 0 failed
no-page                         0 checks, 0 failed; did not run to its end
nothing                         0 checks, 0 failed; did not run to its end
linked                          1 checks, 0 failed
look at odd/index.html
END
result $? 'report: pages in folders of the report, and pages that are missing or empty'
grep -q '<a href="../text/index.html">text</a>' odd/linked/index.html && grep -q '<span>none</span>' odd/linked/index.html &&
  grep -q '<title>no-page</title>' odd/no-page/index.html && ! grep 'without running' odd/text/index.html
result $? 'report: links to a text that is not run, and to a missing page'
# A table of 100000 bytes is kept, one of 100001 is not: a longer name of the page makes the first lines of its table longer.
site_page 'Rows' 1 'cycle above 1' | sed 's/^record .*/record cycle/; s/^stage .*/stage s/; s/^cycles .*/cycles 13875/; /^sweep/d; s/\$v/1/' >k.md
run 0 run k.md -o kept
more=$((100000 - $(wc -c <kept/table.tsv)))
kept=k$(printf '%0*d' $more 0)
cp k.md "$kept.md" && cp k.md "${kept}0.md"
run 0 report "$kept.md" "${kept}0.md" -o kept && test "$(wc -c <"kept/$kept/table.tsv")" -eq 100000 && test ! -e "kept/${kept}0/table.tsv" &&
  grep -qx "<p>Not kept here, because they are large: table.tsv. They are written by <code>nineball run ${kept}0.md</code> and <code>nineball figure ${kept}0.md</code>.</p>" \
    "kept/${kept}0/index.html"
result $? 'report: the largest table that is kept'
if command -v gnuplot >/dev/null; then
  # A drawing of 300000 bytes is kept. Its size increases linearly with the number of points.
  points() { sed '$a\\n```gnuplot\nset samples '"$2"'\nplot [0:9] sin(x) with points\n```' site/first.md >"$1.md"; }
  for size in 2000 4000; do points "points$size" $size && run 0 figure "points$size.md" --trust -o points; done
  one=$(wc -c <points/points2000.svg) two=$(wc -c <points/points4000.svg)
  points under $(((297000 - one) * 2000 / (two - one) + 2000))
  points over $(((303000 - one) * 2000 / (two - one) + 2000))
  run 0 report under.md over.md --trust -o points && test -e points/under/under.svg && grep -q 'src="under.svg"' points/under/index.html &&
    test ! -e points/over/over.svg && grep -q 'src="over.png"' points/over/index.html && grep -q 'because they are large: over.svg\.' points/over/index.html
  result $? 'report: the largest drawing that is kept'
fi

# ---- names and folders of pages that are similar ----

mkdir -p alike/own
printf '# Notes\n' >alike/notes.md
cp one/page.md alike/README-old.md
cp one/page.md alike/own/second.md
run 2 report alike/README-old.md alike/notes.md alike/README.md -o alike-site && said 'alike/README.md: ' &&
  grep -o '<th colspan.*\|index.html">[^<]*' alike-site/index.html | diff -u /dev/fd/3 - >"$why" 3<<'END'
index.html">README
<th colspan="4">alike</th></tr>
index.html">README-old
index.html">notes
index.html">README
END
result $? 'report: only README gets the name of its folder, and only its title is that of the folder; a README that is missing'
run 2 report one/page.md "$pages/passes.md" other/page.md -o alike-site && said 'nineball: one/page.md and other/page.md have the same name, so the same output folder: rename one of them'
result $? 'report: the first and the last page have the same name'
cp one/page.md own.md
run 2 report own.md alike/own/second.md -o alike && said 'the output folder alike/own of own.md is a folder of pages, whose files would be overwritten' && test ! -e alike/index.html
result $? 'report: the output folder of a page is the folder of another page'

# ---- files of the site ----

for name in index.html report.css report.js; do
  mkdir -p "without-$name/$name"
  run 2 report one/page.md -o "without-$name" && said "nineball: cannot write without-$name/$name: "
  result $? "report: $name cannot be written"
done
run 0 report one/page.md && said 'look at report/index.html' && cmp "$pages/../../plots/report.css" report/report.css && cmp "$pages/../../plots/report.js" report/report.js &&
  grep -q '^<p>1 pages were run: 1 checks, <span class="pass">0 failed</span>\. Made' report/index.html && ! grep -q 'What failed' report/index.html && rm -r report
result $? 'report: its default folder, its style, and the summary of pages that all pass'

# Files that are not kept are listed, also those of a snapshot: 3600 particles, each with more than 28 characters. The drawing is small.
sed 's/^cycles .*/cycles 1\nsnapshot/; s/^disc .*/&\nlattice discs 60 by 60 m radius 1 from 9 9/; s/^plot .*/plot x/; s/within 1e-15/within 999/' one/page.md >much.md
run 0 report much.md --trust -o much && cp much/much/index.html "$why" && test -s much/much/table.tsv && test ! -e much/much/much.gp &&
  test ! -e much/much/flight-particles.tsv && said '<p>Not kept here, because they are large: flight-particles.tsv, much.gp. They' &&
  { ! command -v gnuplot >/dev/null || {
    said 'src="much.svg"' && test -s much/much/much.svg && sed -n '/^<p>Files/,/<.p>/s/.*href="\([^"]*\)".*/\1/p' "$why" | tr '\n' ' ' >given &&
      echo 'much.md much.png table.tsv values.tsv verdict.tsv ' | tr -d '\n' | cmp - given
  }; }
result $? 'report: a large snapshot and script are not kept'
# The time of a page is the sum of its runs: here the first one has 180000 cycles, the others one.
site_page 'Times' '1e-6 1 2' 'D.x above 0' | sed 's/^cycles.*/record every 100000 cycles\nuntil D.x above 1.09 at most 200000 cycles/' >times.md
run 0 report times.md -o times && cp times/index.html "$why" && grep '<td class="number">' times/index.html | awk -F 'number">' '{ seconds = $2 } END { exit !(seconds + 0 > 0.003) }'
result $? 'report: the time of a page is that of all its runs'

# Files with the same two last names get a number. A target may have 999 characters and no colon. A tab may end it.
mkdir -p targets/in targets/more/in targets/third/in
echo text | tee targets/in/h.bin >targets/in/c:d.txt
for folder in more third; do echo $folder >targets/$folder/in/h.bin; done
printf '# Targets\n\n[no](in/%01000d) [c](in/c:d.txt) [h](in/h.bin\t"a title") [m](more/in/h.bin) [t](third/in/h.bin) [again](more/in/h.bin)\n' 0 >targets/README.md
echo text >targets/only.txt
sed 's/^units.*/& # [a](only.txt)/' one/page.md >targets/page.md # a comment has no links
run 0 report targets/README.md targets/page.md -o targets-site && grep . targets-site/files/* | sed 's,.*/,,' >given &&
  tr '\n' ' ' <targets-site/index.html | grep -o '<p><span>.*again</a></p>' | cat given - | diff -u /dev/fd/3 - >"$why" 3<<'END'
1-in-h.bin.txt:more
2-in-h.bin.txt:third
in-h.bin.txt:text
<p><span>no</span> <span>c</span> <a href="files/in-h.bin.txt">h</a> <a href="files/1-in-h.bin.txt">m</a> <a href="files/2-in-h.bin.txt">t</a> <a href="files/1-in-h.bin.txt">again</a></p>
END
result $? 'report: targets of links'

# An interrupted report does not run the pages that follow. The checkpoint of a page that has run to its end is removed.
sed 's/^cycles .*/cycles 1000000000\nrecord none/' one/page.md >forever.md
cp one/page.md before.md
"$nineball" report before.md forever.md "$pages/passes.md" -o interrupted --checkpoint=0.01 --states states >out 2>given &
while kill -0 $! && ! ls states/forever-*.checkpoint; do sleep 0.05; done >"$why" 2>&1
kill -INT $!
wait $!
echo "status $?" >>out
{ cat out && grep -o '<p>[0-9].*</span>' interrupted/index.html && grep -o '<td>A disc.*\(passed<\|run<\|/small>\)' interrupted/index.html && ls states | grep -v old; } |
  sed 's/after cycle [0-9]* ([^)]*)/after cycle N/; s/-[0-9a-f]*\.checkpoint/.checkpoint/' | diff -u /dev/fd/3 - >"$why" 3<<'END'
before                          1 checks, 0 failed
forever                         0 checks, 0 failed; did not run to its end
look at interrupted/index.html
status 130
<p>2 pages were run: 1 checks, <span class="pass">0 failed</span>
<td>A disc in free flight</td><td class="fail">did not run to its end<br><small>stopped by a signal after cycle N; the checkpoint is states/forever.checkpoint</small>
<td>A disc in free flight</td><td class="pass">1 check passed<
<td>A disc in free flight</td><td class="fail">did not run to its end<br><small>stopped by a signal after cycle N; the checkpoint is states/forever.checkpoint</small>
<td>A disc in free flight</td><td class="none">not run<
forever.checkpoint
END
result $? 'report: an interrupted page, and the pages before and behind it'

# ---- pandoc: a script in its place ----

mkdir -p scripts typeset
cat >scripts/pandoc <<'END'
#!/bin/sh
{
  for word in "$@"; do echo "[$word]" | sed 's,\(--lua-filter=\)/.*/,\1,'; done
  pwd | sed 's,.*/,,'
  echo '[WARNING] The term Abstract has no translation defined.'
  echo 'Could not load translations for en'
} >&2
echo '<p>before</p>'
echo '<!--nineball: checks--> <!-- -->'
echo '<p>behind</p>'
test ! -e fails
END
chmod +x scripts/pandoc
sed '/^```gnuplot/,/^```$/d' "$pages/passes.md" >typeset/first.md
sed 's/^# .*/# Second\n\n[a](data.tsv) [b](first.md)\n/' typeset/first.md >typeset/second.md
echo 1 >typeset/data.tsv
mkdir -p folders/pandoc # a folder is no program
typeset() { PATH=$work/folders:$work/scripts:$PATH NINEBALL_CONFINE=none "$nineball" report typeset/first.md typeset/second.md -o typeset-site >out 2>given; }
typeset && sed '1,/first.md: warning: pandoc: typeset$/d' given | diff -u /dev/fd/3 - >"$why" 3<<'END'
typeset/second.md: warning: pandoc: [--sandbox]
typeset/second.md: warning: pandoc: [--from=gfm+tex_math_dollars]
typeset/second.md: warning: pandoc: [--to=html5]
typeset/second.md: warning: pandoc: [--mathml]
typeset/second.md: warning: pandoc: [--lua-filter=report.lua]
typeset/second.md: warning: pandoc: [-M]
typeset/second.md: warning: pandoc: [links=data.tsv	../files/typeset-data.tsv.txt		
typeset/second.md: warning: pandoc: first.md	../first/index.html	pass	
typeset/second.md: warning: pandoc: ]
typeset/second.md: warning: pandoc: [-M]
typeset/second.md: warning: pandoc: [figure=]
typeset/second.md: warning: pandoc: [./second.md]
typeset/second.md: warning: pandoc: typeset
END
result $? 'report: the arguments and the messages of pandoc'
sed -n '/<main>/,/<p>Cost/p' typeset-site/second/index.html | grep -v '<t[rdh]\|^<table\|<p>Cost' | diff -u /dev/fd/3 - >"$why" 3<<'END'
<main>
<p class="pass">1 check passed</p>
<p>before</p>
<details open><summary>Results: 1 checks, 0 failed, 0 noted, 0 skipped</summary>
</tbody></table></details>
<p>behind</p>
END
result $? 'report: the results are where the filter wants them'
: >typeset/fails
typeset
test $? -eq 2 && cp given "$why" && grep -qx 'nineball: pandoc refused typeset/second.md: typeset' given &&
  grep -qx '<p class="fail">pandoc refused typeset/second.md: typeset</p>' typeset-site/second/index.html &&
  grep -q '<details open>' typeset-site/second/index.html && grep -qx 'first *1 checks, 0 failed; no figure' out
result $? 'report: a page that pandoc refuses'

printf '# Front\n' >typeset/README.md
PATH=$work/scripts:$PATH NINEBALL_CONFINE=none run 2 report typeset/README.md -o typeset-site &&
  test "$(grep -cx 'nineball: pandoc refused typeset/README.md: typeset' "$why")" -eq 2 && grep -q '>All pages<' typeset-site/index.html
result $? 'report: an index whose text pandoc refuses'
rm typeset/fails
# The kernel limits an argument to 131072 bytes, so the list ends at 100000 bytes: a link has 41 bytes on the page, and 38 in the index.
{ printf '# Many\n\n' && yes '[a](data.tsv)' | head -n 3500; } >typeset/many.md
PATH=$work/scripts:$PATH NINEBALL_CONFINE=none run 0 report typeset/many.md -o typeset-site && test "$(grep -c 'data.tsv	' "$why")" -eq $((100000 / 41 + 1 + 100000 / 38 + 1))
result $? 'report: the list of links of a page is limited'

if command -v gnuplot >/dev/null; then
  sed 's/^plot .*/plot $nothing/' "$pages/passes.md" >broken.md
  run 2 report broken.md -o some && said 'no datablock named $nothing' && grep -qx 'broken *1 checks, 0 failed; no figure' "$why" &&
    grep -q 'no datablock named' some/broken/index.html && test ! -e some/broken/broken.svg &&
    grep -q '<td class="fail">no figure<br><small>gnuplot refused some/broken/broken.gp: ' some/index.html
  result $? 'report: a figure that cannot be drawn is status 2, and says why'
  cp "$pages/passes.md" 'a&b #1%.md'
  run 0 report 'a&b #1%.md' -o some && test -s 'some/a&b #1%/a&b #1%.svg' && cp 'some/a&b #1%/index.html' "$why" && said 'src="a%26b%20%231%25.svg"'
  result $? 'report: the figure of a page whose name has signs'
  sed 's/^plot .*//' "$pages/passes.md" >empty.md
  run 2 figure empty.md -o some && said 'nineball: some/empty.gp draws nothing'
  result $? 'figure: a block that draws nothing is status 2'
  printf '\n```gnuplot\nplot $table using "cycle/-":"D.x/-" with points\n```\n' | cat "$pages/never-ends.md" - >stopped.md
  run 3 figure stopped.md -o some && said 'look at some/stopped.svg, up to where the run was stopped' &&
    grep -q INCOMPLETE some/stopped.svg && grep -qxF "set label 9999 'INCOMPLETE: the run was stopped' at screen 0.99, screen 0.98 right noenhanced front tc rgb '#a3123a'" some/stopped.gp
  result $? 'figure: an aborted run is drawn, and the figure says so'
  printf '\n```gnuplot\nplot $table using "time/-":"D.x/-" with points\n```\n' | cat "$pages/fails.md" - >failed.md
  run 0 figure failed.md -o some && said 'look at some/failed.svg' && ! said 'up to where' &&
    said 'a check of this page failed: type `nineball check failed.md`' &&
    ! grep -q INCOMPLETE some/failed.svg && ! grep -q INCOMPLETE some/failed.gp
  result $? 'figure: a page with a failed check is drawn as complete'
  sed 's/^plot .*/plot $nothing/' stopped.md >both.md
  run 3 report both.md -o some && cp some/both/index.html "$why" &&
    grep -qF 'above 6; gnuplot refused some/both/both.gp: ' "$why" && grep -q 'stage `wait` (line 10) did not end within 20 cycles' "$why"
  result $? 'report: an aborted run whose figure cannot be drawn'
  # If the first run of a sweep is aborted, the others are not started and have no tables.
  run 3 figure "$pages/../../cases/8-published/chung-ooi-3.md" --set 'step=1 s' --jobs 1 -o some &&
    said 'look at some/chung-ooi-3.svg, up to where the run was stopped'
  result $? 'figure: a sweep whose first run is aborted'
fi
echo "1..$n"
