#!/bin/sh
# Tests the commands as a user sees them: whole messages, streams and exit statuses, also for two pages in both orders. TAP. $NINEBALL is
# the program, $srcdir the top of the source tree.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
cd "$work" || exit 1

# page NAME LINES EXPECTATIONS STAGE: writes NAME.md, a disc that moves by 0.25 in one unit of time.
page() {
  printf '# Page %s\n```scene\nunits none\nlet v = 0.25\n%b\nmaterial m density 1 kn 1\ndisc 1 2 radius 0.5 m velocity $v 0\n' "$1" "$2" >"$1.md"
  printf 'monitor D disc 1\nstep 0.5\nrecord time D.x\nstage go\n%b\n```\n' "${4:-cycles 2}" >>"$1.md"
  test -z "$3" || printf '```expect\n%b\n```\n' "$3" >>"$1.md"
}
page good '' 'D.x expected 1.25 within 0 [1 + 0.25]'
page bad '' 'D.x expected 1.5 within 0 [a guess]\ntime expected 1 within 0 [two steps]'
page wrong 'allow nothing' ''
page ends '' 'D.x above 0' 'until D.x above 9 at most 2 cycles'
page empty '' ''
page 'no checks' '' ''
page noted '' 'report D.x max'
page 'a skip' 'sweep s 4' 'D.x increases with s'
page swept '' 'D.x increases with v\nD.x above 1.25'
sed 's/^let v = .*/sweep v 0.25 0.5/' swept.md >both.md && mv both.md swept.md
page spread '' 'D.x expected 1.25 over v [1 + 0.25]\nreport time'
sed 's/^let v = .*/sweep v 0.25 0.5/' spread.md >both.md && mv both.md spread.md
page mixed '' 'D.x expected 1.5 within 0 [a guess]\nreport time'
page late '' 'D.x above 0' 'cycles 2\nstage on\nuntil D.x above 9 at most 2 cycles'
page 'two words' '' 'D.x expected 1.5 within 0 [a guess]'
printf '\n```gnuplot\nplot $table using 2:3\n```\n' >>'two words.md'
printf '```contact-test\nmaterial m kn 1 MN/m\ncontact disc 1 m m with wall m\nsegment s normal to 1 N in 2 steps\n```\n' >touch.md
head -c 20 /dev/zero | cat good.md - >zeros.md
page first '' 'report time\nD.x max expected 1.25 within 0 [1 + 0.25]'
page refine 'let refine = 2' 'D.x above 0'
page many '' 'D.x above 0'
sed 's,^disc.*,lattice discs 51 by 1 radius 1 m spacing 3 from 0 0,' many.md >both.md && mv both.md many.md

# Each block below is a command, its standard output behind two spaces, its standard error behind `!`, and its exit status. Times are not
# compared.
command -v gnuplot >/dev/null && drawn=true || drawn=false
while IFS= read -r line; do
  case $line in
  '$ '*) command=${line#* } && : >wanted && eval "\"$nineball\" $command" >out 2>err </dev/null
    ended=$? ;;
  '= '*)
    {
      sed 's/, [0-9.e-]* s$/, T s/; s/verdict [0-9.e-]* s$/verdict T s/; s/about [0-9.]* [a-z]* left/about T left/; s/takes [0-9.e-]* us/takes T us/; s/^nineball [0-9.]*$/nineball VERSION/; s/ *$//; s/^/  /' out
      sed "s|^$nineball: |nineball: |; s/ *\$//; s/^/! /" err
      echo "= $ended"
    } >given
    echo "$line" >>wanted
    diff -u wanted given >"$why"
    { test $? -eq 0 || { test "$command" = "figure 'two words.md' --trust" && ! $drawn; }; }
    result $? "nineball $command"
    ;;
  *) echo "$line" >>wanted ;;
  esac
done <<'END'
$ check good.md
  good: Page good
    pass  D.x expected 1.25 within 0 [1 + 0.25]
          computed 1.25, expected 1.25, error 0, tolerance 0
    1 of 1 checks passed
= 0
$ check bad.md good.md
  bad: Page bad
    FAIL  D.x expected 1.5 within 0 [a guess]
          bad.md:15: computed 1.25, expected 1.5, error 0.25, tolerance 0
    pass  time expected 1 within 0 [two steps]
          computed 1, expected 1, error 0, tolerance 0
    1 of 2 checks passed
  good: Page good
    pass  D.x expected 1.25 within 0 [1 + 0.25]
          computed 1.25, expected 1.25, error 0, tolerance 0
    1 of 1 checks passed
= 1
$ check good.md bad.md
  good: Page good
    pass  D.x expected 1.25 within 0 [1 + 0.25]
          computed 1.25, expected 1.25, error 0, tolerance 0
    1 of 1 checks passed
  bad: Page bad
    FAIL  D.x expected 1.5 within 0 [a guess]
          bad.md:15: computed 1.25, expected 1.5, error 0.25, tolerance 0
    pass  time expected 1 within 0 [two steps]
          computed 1, expected 1, error 0, tolerance 0
    1 of 2 checks passed
= 1
$ check wrong.md bad.md
  bad: Page bad
    FAIL  D.x expected 1.5 within 0 [a guess]
          bad.md:15: computed 1.25, expected 1.5, error 0.25, tolerance 0
    pass  time expected 1 within 0 [two steps]
          computed 1, expected 1, error 0, tolerance 0
    1 of 2 checks passed
! wrong.md:5:7: error: expected `unstable`, found `nothing`
!     5 | allow nothing
!       |       ^~~~~~~
!   hint: for example `allow     unstable`
= 2
$ check bad.md wrong.md
  bad: Page bad
    FAIL  D.x expected 1.5 within 0 [a guess]
          bad.md:15: computed 1.25, expected 1.5, error 0.25, tolerance 0
    pass  time expected 1 within 0 [two steps]
          computed 1, expected 1, error 0, tolerance 0
    1 of 2 checks passed
! wrong.md:5:7: error: expected `unstable`, found `nothing`
!     5 | allow nothing
!       |       ^~~~~~~
!   hint: for example `allow     unstable`
= 2
$ check late.md wrong.md
! late.md: run aborted: stage `on` (line 13) did not end within 2 cycles: D.x is 1.5 and should be above 9
! wrong.md:5:7: error: expected `unstable`, found `nothing`
!     5 | allow nothing
!       |       ^~~~~~~
!   hint: for example `allow     unstable`
= 3
$ check wrong.md late.md
! wrong.md:5:7: error: expected `unstable`, found `nothing`
!     5 | allow nothing
!       |       ^~~~~~~
!   hint: for example `allow     unstable`
! late.md: run aborted: stage `on` (line 13) did not end within 2 cycles: D.x is 1.5 and should be above 9
= 3
$ check empty.md
  empty: Page empty
! empty.md: error: nothing was checked, because the page has no expectation; the run itself succeeded, and `nineball run empty.md` runs such a page; to check the page, add a line such as `QUANTITY max below VALUE` to a block `expect`: see `nineball --help expect`
= 2
$ check 'no checks.md'
  no checks: Page no checks
! no checks.md: error: nothing was checked, because the page has no expectation; the run itself succeeded, and `nineball run 'no checks.md'` runs such a page; to check the page, add a line such as `QUANTITY max below VALUE` to a block `expect`: see `nineball --help expect`
= 2
$ check noted.md
  noted: Page noted
    note  report D.x max
          computed 1.25
    1 noted
! noted.md: error: nothing was checked, because the page has no expectation; the run itself succeeded, and `nineball run noted.md` runs such a page and prints the values of its lines `report`; to check the page, add a line such as `QUANTITY max below VALUE` to a block `expect`: see `nineball --help expect`
= 2
$ check 'a skip.md'
  a skip: Page a skip
    1 expectation was not checked:
          line 15: D.x increases with s
          `s` has one value only, so there is nothing to compare
! a skip.md: error: nothing was checked, because no expectation of this page could fail; the run itself succeeded: see the notes and reasons above, or use `nineball run 'a skip.md'`
= 2
$ check spread.md
  spread: Page spread
    note  report time (v=0.25)
          computed 1
    note  report time (v=0.5)
          computed 1
    note  D.x expected 1.25 over v [1 + 0.25]
          expected 1.25, within the range of 2 runs over v: 1.25 to 1.5, mean 1.375, standard deviation 0.18; percentile 25
    3 noted
! spread.md: error: nothing was checked, because no expectation of this page could fail; the run itself succeeded: see the notes and reasons above, or use `nineball run spread.md`
= 2
$ check mixed.md
  mixed: Page mixed
    FAIL  D.x expected 1.5 within 0 [a guess]
          mixed.md:15: computed 1.25, expected 1.5, error 0.25, tolerance 0
    note  report time
          computed 1
    0 of 1 checks passed, 1 noted
= 1
$ check swept.md
  swept: Page swept
    FAIL  D.x above 1.25 (v=0.25)
          swept.md:16: computed 1.25 and 1.25
    pass  D.x above 1.25 (v=0.5)
          computed 1.5 and 1.25
    pass  D.x increases with v
          computed 1.25 at v = 0.25, 1.5 at 0.5
    2 of 3 checks passed
= 1
$ check swept.md --set v=0.5
  swept: Page swept
    pass  D.x above 1.25
          computed 1.5 and 1.25
    1 of 1 checks passed
    1 expectation was not checked:
          line 15: D.x increases with v
          `v` has one value only, so there is nothing to compare
= 0
$ check good.md --tap
  1..1
  ok 1 - D.x expected 1.25 within 0 [1 + 0.25]
  # line 15: computed 1.25, expected 1.25, error 0, tolerance 0
= 0
$ check bad.md --tap
  1..2
  not ok 1 - D.x expected 1.5 within 0 [a guess]
  # line 15: computed 1.25, expected 1.5, error 0.25, tolerance 0
  ok 2 - time expected 1 within 0 [two steps]
  # line 16: computed 1, expected 1, error 0, tolerance 0
= 1
$ check wrong.md --tap
  1..1
  not ok 1 - wrong.md has mistakes
  #
! wrong.md:5:7: error: expected `unstable`, found `nothing`
!     5 | allow nothing
!       |       ^~~~~~~
!   hint: for example `allow     unstable`
= 2
$ check late.md --tap
  1..1
  not ok 1 - late.md did not run
  # stage `on` (line 13) did not end within 2 cycles: D.x is 1.5 and should be above 9
! late.md: run aborted: stage `on` (line 13) did not end within 2 cycles: D.x is 1.5 and should be above 9
= 3
$ check empty.md --tap
  1..1
  not ok 1 - empty.md did not run
  # nothing was checked, because the page has no expectation; the run itself succeeded, and `nineball run empty.md` runs such a page; to check the page, add a line such as `QUANTITY max below VALUE` to a block `expect`: see `nineball --help expect`
! empty.md: error: nothing was checked, because the page has no expectation; the run itself succeeded, and `nineball run empty.md` runs such a page; to check the page, add a line such as `QUANTITY max below VALUE` to a block `expect`: see `nineball --help expect`
= 2
$ check noted.md --tap
  1..2
  ok 1 - report D.x max # SKIP noted, not checked
  # line 15: computed 1.25
  not ok 2 - noted.md was not checked
  # nothing was checked, because the page has no expectation; the run itself succeeded, and `nineball run noted.md` runs such a page and prints the values of its lines `report`; to check the page, add a line such as `QUANTITY max below VALUE` to a block `expect`: see `nineball --help expect`
! noted.md: error: nothing was checked, because the page has no expectation; the run itself succeeded, and `nineball run noted.md` runs such a page and prints the values of its lines `report`; to check the page, add a line such as `QUANTITY max below VALUE` to a block `expect`: see `nineball --help expect`
= 2
$ check 'a skip.md' --tap
  1..2
  ok 1 - D.x increases with s # SKIP `s` has one value only, so there is nothing to compare
  # line 15: `s` has one value only, so there is nothing to compare
  not ok 2 - a skip.md was not checked
  # nothing was checked, because no expectation of this page could fail; the run itself succeeded: see the notes and reasons above, or use `nineball run 'a skip.md'`
! a skip.md: error: nothing was checked, because no expectation of this page could fail; the run itself succeeded: see the notes and reasons above, or use `nineball run 'a skip.md'`
= 2
$ check none.md
! none.md: error: cannot be read: No such file or directory
= 2
$ run good.md
  good: Page good
    pass  D.x expected 1.25 within 0 [1 + 0.25]
          computed 1.25, expected 1.25, error 0, tolerance 0
    1 of 1 checks passed
    2 cycles, 0 contact updates, T s
  tables are in good.out
= 0
$ run bad.md good.md
  bad: Page bad
    FAIL  D.x expected 1.5 within 0 [a guess]
          bad.md:15: computed 1.25, expected 1.5, error 0.25, tolerance 0
    pass  time expected 1 within 0 [two steps]
          computed 1, expected 1, error 0, tolerance 0
    1 of 2 checks passed
    2 cycles, 0 contact updates, T s
  tables are in bad.out
  good: Page good
    pass  D.x expected 1.25 within 0 [1 + 0.25]
          computed 1.25, expected 1.25, error 0, tolerance 0
    1 of 1 checks passed
    2 cycles, 0 contact updates, T s
  tables are in good.out
= 1
$ run good.md wrong.md
  good: Page good
    pass  D.x expected 1.25 within 0 [1 + 0.25]
          computed 1.25, expected 1.25, error 0, tolerance 0
    1 of 1 checks passed
    2 cycles, 0 contact updates, T s
  tables are in good.out
! wrong.md:5:7: error: expected `unstable`, found `nothing`
!     5 | allow nothing
!       |       ^~~~~~~
!   hint: for example `allow     unstable`
= 2
$ run wrong.md good.md
  good: Page good
    pass  D.x expected 1.25 within 0 [1 + 0.25]
          computed 1.25, expected 1.25, error 0, tolerance 0
    1 of 1 checks passed
    2 cycles, 0 contact updates, T s
  tables are in good.out
! wrong.md:5:7: error: expected `unstable`, found `nothing`
!     5 | allow nothing
!       |       ^~~~~~~
!   hint: for example `allow     unstable`
= 2
$ run late.md bad.md
    4 cycles, 0 contact updates, T s
  tables are in late.out, up to where the run was stopped
  bad: Page bad
    FAIL  D.x expected 1.5 within 0 [a guess]
          bad.md:15: computed 1.25, expected 1.5, error 0.25, tolerance 0
    pass  time expected 1 within 0 [two steps]
          computed 1, expected 1, error 0, tolerance 0
    1 of 2 checks passed
    2 cycles, 0 contact updates, T s
  tables are in bad.out
! late.md: run aborted: stage `on` (line 13) did not end within 2 cycles: D.x is 1.5 and should be above 9
= 3
$ run bad.md late.md
  bad: Page bad
    FAIL  D.x expected 1.5 within 0 [a guess]
          bad.md:15: computed 1.25, expected 1.5, error 0.25, tolerance 0
    pass  time expected 1 within 0 [two steps]
          computed 1, expected 1, error 0, tolerance 0
    1 of 2 checks passed
    2 cycles, 0 contact updates, T s
  tables are in bad.out
    4 cycles, 0 contact updates, T s
  tables are in late.out, up to where the run was stopped
! late.md: run aborted: stage `on` (line 13) did not end within 2 cycles: D.x is 1.5 and should be above 9
= 3
$ run 'two words.md'
  two words: Page two words
    FAIL  D.x expected 1.5 within 0 [a guess]
          two words.md:15: computed 1.25, expected 1.5, error 0.25, tolerance 0
    0 of 1 checks passed
    2 cycles, 0 contact updates, T s
  tables are in two words.out
  to draw the figure: nineball figure 'two words.md'
= 1
$ run empty.md noted.md
  empty: Page empty
    2 cycles, 0 contact updates, T s
  tables are in empty.out
  noted: Page noted
    note  report D.x max
          computed 1.25
    1 noted
    2 cycles, 0 contact updates, T s
  tables are in noted.out
= 0
$ run good.md ./good.md
! nineball: good.md and ./good.md have the same name, so the same output folder: run them one at a time, with -o
= 2
$ run bad.md sub/good.md good.md
! nineball: sub/good.md and good.md have the same name, so the same output folder: run them one at a time, with -o
= 2
$ run good.md go.md
  good: Page good
    pass  D.x expected 1.25 within 0 [1 + 0.25]
          computed 1.25, expected 1.25, error 0, tolerance 0
    1 of 1 checks passed
    2 cycles, 0 contact updates, T s
  tables are in good.out
! go.md: error: cannot be read: No such file or directory
= 2
$ run good.md bad.md -o x
! nineball: -o FOLDER takes one page at a time; `nineball report` takes many
= 2
$ figure good.md wrong.md
  good.md has no `gnuplot` block, so there is no figure
! wrong.md:5:7: error: expected `unstable`, found `nothing`
!     5 | allow nothing
!       |       ^~~~~~~
!   hint: for example `allow     unstable`
= 2
$ figure wrong.md good.md
  good.md has no `gnuplot` block, so there is no figure
! wrong.md:5:7: error: expected `unstable`, found `nothing`
!     5 | allow nothing
!       |       ^~~~~~~
!   hint: for example `allow     unstable`
= 2
$ figure 'two words.md' --trust
  look at two words.out/two words.svg
  a check of this page failed: type `nineball check 'two words.md'`
= 0
$ figure bad.md
  bad.md has no `gnuplot` block, so there is no figure
  a check of this page failed: type `nineball check bad.md`
= 0
$ figure late.md
  late.md has no `gnuplot` block, so there is no figure
! late.md: run aborted: stage `on` (line 13) did not end within 2 cycles: D.x is 1.5 and should be above 9
= 3
$ figure good.md bad.md -o x
! nineball: -o FOLDER takes one page at a time; `nineball report` takes many
= 2
$ explain wrong.md
! wrong.md:5:7: error: expected `unstable`, found `nothing`
!     5 | allow nothing
!       |       ^~~~~~~
!   hint: for example `allow     unstable`
= 2
$ explain good.md none.md >/dev/null
! none.md: error: cannot be read: No such file or directory
= 2
$ explain none.md good.md >/dev/null
! none.md: error: cannot be read: No such file or directory
= 2
$ state good.md
  the state at the end of stage `go` is in good-go.state
  a page beside it takes the particles, without velocities and contact histories, with: packing good-go.state
  a page that continues the run needs no such file: start good stage go
= 0
$ state good.md -o good.out/made.state
  the state at the end of stage `go` is in good.out/made.state
  a page beside it takes the particles, without velocities and contact histories, with: packing made.state
  a page that continues the run needs no such file: start good stage go
= 0
$ state swept.md
! nineball: swept.md has several runs: choose one, with --set NAME=VALUE for each sweep
= 2
$ state swept.md --set v=0.5 -o made.state
  the state at the end of stage `go` is in made.state
  a page beside it takes the particles, without velocities and contact histories, with: packing made.state
  a page that continues the run needs no such file: start swept stage go
= 0
$ state touch.md
! nineball: touch.md is a contact test: expected a page with a scene
= 2
$ state late.md --stage go -o sub.state
  the state at the end of stage `go` is in sub.state
  a page beside it takes the particles, without velocities and contact histories, with: packing sub.state
  a page that continues the run needs no such file: start late stage go
= 0
$ state good.md --stage g
! nineball: good.md has no stage `g` of its own
= 2
$ state good.md --stage goo
! nineball: good.md has no stage `goo` of its own; did you mean `go`?
= 2
$ state good.md -o good.out
! nineball: good.out is not a state, so it is not overwritten: expected the name of a state or of a new file
= 2
$ state good.md bad.md
! nineball: `nineball state` takes one page
= 2
$ state good.md -o bad.md
! nineball: bad.md is not a state, so it is not overwritten: expected the name of a state or of a new file
= 2
$ state good.md -o none/x.state
! nineball: good.md: cannot write none/x.state: No such file or directory
= 2
$ state late.md
! nineball: late.md: stage `on` (line 13) did not end within 2 cycles: D.x is 1.5 and should be above 9
= 3
$ state wrong.md
! wrong.md:5:7: error: expected `unstable`, found `nothing`
!     5 | allow nothing
!       |       ^~~~~~~
!   hint: for example `allow     unstable`
= 2
$ migrate good.md bad.md
! nineball: several pages can be rewritten only with --in-place: add it, or give one page
= 2
$ migrate zeros.md
! zeros.md: error: expected a page, found a file that is not text
= 2
$ migrate none.md bad.md --in-place
! none.md: error: cannot be read: No such file or directory
= 2
$ migrate good.md none.md --in-place
! none.md: error: cannot be read: No such file or directory
= 2
$ frobnicate
! nineball: there is no command `frobnicate`; see nineball --help
= 2
$ chek
! nineball: there is no command `chek`; did you mean `check`?; see nineball --help
= 2
$ diff a b
! nineball: there is no command `diff`; compare runs in one page: `sweep mu 0.2 0.6`, a line with `$mu`, and in a block `expect` for example `M.coordination last in STAGE  constant with mu within 1 %`; see nineball --help
= 2
$ compare
! nineball: there is no command `compare`; compare runs in one page: `sweep mu 0.2 0.6`, a line with `$mu`, and in a block `expect` for example `M.coordination last in STAGE  constant with mu within 1 %`; see nineball --help
= 2
$ check
! nineball: `nineball check` needs a page, such as cases/3-nine-discs/nine-discs.md; see nineball --help
= 2
$ state
! nineball: `nineball state` needs a page, such as cases/3-nine-discs/nine-discs.md; see nineball --help
= 2
$ list chain
! nineball: `nineball list` takes no page, found `chain`; see nineball --help
= 2
$ laws hertz linear
! nineball: `nineball laws` takes no page, found `hertz`; see nineball --help
= 2
$ check good.md --threads 257
! nineball: expected a number from 1 to 256 after --threads, found `257`; see nineball --help
= 2
$ check good.md --threads 256
  good: Page good
    pass  D.x expected 1.25 within 0 [1 + 0.25]
          computed 1.25, expected 1.25, error 0, tolerance 0
    1 of 1 checks passed
= 0
$ check good.md --threads 0
! nineball: expected a number from 1 to 256 after --threads, found `0`; see nineball --help
= 2
$ check good.md --threads 1x
! nineball: expected a number from 1 to 256 after --threads, found `1x`; see nineball --help
= 2
$ check good.md --threads ''
! nineball: expected a number from 1 to 256 after --threads, found ``; see nineball --help
= 2
$ check good.md --checkpoint=0
! nineball: expected a number of seconds above 0 after --checkpoint=, found `0`; see nineball --help
= 2
$ check good.md --checkpoint=x
! nineball: expected a number of seconds above 0 after --checkpoint=, found `x`; see nineball --help
= 2
$ check good.md --checkpoint=inf
! nineball: expected a number of seconds above 0 after --checkpoint=, found `inf`; see nineball --help
= 2
$ check good.md --set v
! nineball: expected NAME=VALUE after --set, found `v`; see nineball --help
= 2
$ check good.md --stage x
! nineball: `nineball check` does not use --stage, which is an option of: state
= 2
$ check good.md --rounding some
! nineball: expected `--rounding all` or `parts`, found `some`
= 2
$ check good.md --rounding all --tap
! nineball: expected `--rounding all` or `parts` without --tap, found `all`
= 2
$ check good.md --rounding all --resume
! nineball: --rounding takes neither --checkpoint nor --resume
= 2
$ check good.md --rounding all --checkpoint
! nineball: --rounding takes neither --checkpoint nor --resume
= 2
$ check good.md --rounding all
  good: Page good
    pass  D.x expected 1.25 within 0 [1 + 0.25]
          computed 1.25, expected 1.25, error 0, tolerance 0
    1 of 1 checks passed
    rounding up    1 of 1 checks passed
    rounding down  1 of 1 checks passed
    rounding zero  1 of 1 checks passed
    bits that do not depend on the rounding mode, of 53:
      53  D.x expected 1.25 within 0 [1 + 0.25]
= 0
$ check bad.md good.md --rounding all
  bad: Page bad
    FAIL  D.x expected 1.5 within 0 [a guess]
          bad.md:15: computed 1.25, expected 1.5, error 0.25, tolerance 0
    pass  time expected 1 within 0 [two steps]
          computed 1, expected 1, error 0, tolerance 0
    1 of 2 checks passed
    rounding up    1 of 2 checks passed
    rounding down  1 of 2 checks passed
    rounding zero  1 of 2 checks passed
    bits that do not depend on the rounding mode, of 53:
      53  D.x expected 1.5 within 0 [a guess]
      53  time expected 1 within 0 [two steps]
  good: Page good
    pass  D.x expected 1.25 within 0 [1 + 0.25]
          computed 1.25, expected 1.25, error 0, tolerance 0
    1 of 1 checks passed
    rounding up    1 of 1 checks passed
    rounding down  1 of 1 checks passed
    rounding zero  1 of 1 checks passed
    bits that do not depend on the rounding mode, of 53:
      53  D.x expected 1.25 within 0 [1 + 0.25]
= 1
$ check good.md bad.md --rounding all
  good: Page good
    pass  D.x expected 1.25 within 0 [1 + 0.25]
          computed 1.25, expected 1.25, error 0, tolerance 0
    1 of 1 checks passed
    rounding up    1 of 1 checks passed
    rounding down  1 of 1 checks passed
    rounding zero  1 of 1 checks passed
    bits that do not depend on the rounding mode, of 53:
      53  D.x expected 1.25 within 0 [1 + 0.25]
  bad: Page bad
    FAIL  D.x expected 1.5 within 0 [a guess]
          bad.md:15: computed 1.25, expected 1.5, error 0.25, tolerance 0
    pass  time expected 1 within 0 [two steps]
          computed 1, expected 1, error 0, tolerance 0
    1 of 2 checks passed
    rounding up    1 of 2 checks passed
    rounding down  1 of 2 checks passed
    rounding zero  1 of 2 checks passed
    bits that do not depend on the rounding mode, of 53:
      53  D.x expected 1.5 within 0 [a guess]
      53  time expected 1 within 0 [two steps]
= 1
$ check wrong.md bad.md --rounding parts
  bad: Page bad
    FAIL  D.x expected 1.5 within 0 [a guess]
          bad.md:15: computed 1.25, expected 1.5, error 0.25, tolerance 0
    pass  time expected 1 within 0 [two steps]
          computed 1, expected 1, error 0, tolerance 0
    1 of 2 checks passed
    rounding up    1 of 2 checks passed
    rounding down  1 of 2 checks passed
    rounding zero  1 of 2 checks passed
    bits that do not depend on the rounding mode, of 53:
      53  D.x expected 1.5 within 0 [a guess]
      53  time expected 1 within 0 [two steps]
! wrong.md:5:7: error: expected `unstable`, found `nothing`
!     5 | allow nothing
!       |       ^~~~~~~
!   hint: for example `allow     unstable`
= 2
$ check late.md wrong.md --rounding all
! late.md: run aborted: stage `on` (line 13) did not end within 2 cycles: D.x is 1.5 and should be above 9
! wrong.md:5:7: error: expected `unstable`, found `nothing`
!     5 | allow nothing
!       |       ^~~~~~~
!   hint: for example `allow     unstable`
= 3
$ check "$(printf 'ab.md')"
! nineball: expected text, found the byte 0x1B (shown as `?`) in `a?b.md`
= 2
$ check good.md --states "$(printf '')"
! nineball: expected text, found the byte 0x01 (shown as `?`) in `?`
= 2
$ -h frobnicate
! nineball: `frobnicate` is not a word of pages; nineball --help scene lists all words, nineball laws the laws
= 2
$ --help lattise
! nineball: `lattise` is not a word of pages; did you mean `lattice`?; nineball --help scene lists all words, nineball laws the laws
= 2
$ --help budget
        --budget TIME       time for the search, s (default: 60) (advise)
= 0
$ --help soften
        --set NAME=VALUE    replaces the value of the page's `let` or `sweep` NAME. NAME may also be normal, shear, step or damping; refine, a number that divides the step and multiplies the cycles; soften, a number that divides the stiffnesses; follow, a FILE with the points of a contact test
= 0
$ --help list
  usage: nineball COMMAND …
  
    list                         list the references
    a stage with the line `snapshot` writes its contacts at its end, each with its two particles and its forces, to the table STAGE-contacts.tsv, and the particles to STAGE-particles.tsv
    snapshot {from STAGE}
        Saves particles, walls and contacts at the end of the stage. In a contact test it saves the
        traction over the contact and the pieces of the contact's history, so the shear law must be
        one that stores pieces. Place: a stage; a segment of a contact test.
= 0
$ --help trade
    trade NAME VALUE …, or laws all|none
        Lists other values of a name, which `nineball advise` may choose if the run is then cheaper
        and the error stays within the tolerance. `trade` changes no run. On the command line: --set
        'trade=NAME VALUE …'. Place: the scene; a page with `start`, before its first stage; a contact
        test, before its first segment.
          NAME: the name of a value.
          VALUE …: other values of the name. The name `soften`, which a page need not define, divides
            all stiffnesses by the values.
          laws all|none: `all`: the advice may change the contact laws, also with `--over`; `none`: it
            keeps the contact laws of the page. Without this statement: `none` with `--over`, and
            where the page sweeps its laws; else `all`.
  
          let       rate = 1
          trade     rate 3 10
  
= 0
$ --help attempts
    fill discs|spheres {circle X Y} {radius R} {box X Y} {to X Y} {cell} GRADING MATERIAL seed N
      attempts N else stop|skip
          attempts N: a whole number, 1 or more. Largest number of random positions that are tried for
            each particle, up to 1000000.
    `monitor G grading NAME`, then `G.attempts`
          attempts, quantity of a grading: number of placement attempts, for all particles
= 0
$ --help amplitude
          amplitude, after the quantity of an expectation: half the difference between the largest and
            the smallest value
= 0
$ --help C.overlap
    `monitor C disc 1 with disc 2`, then `C.overlap`
          overlap, quantity of a contact, in m: overlap of the two particles, or of the particle and
            the wall
          overlap, quantity of a contact test, in m: overlap of the particles, or of particle and
            wall; 0 if there is a gap
= 0
$ --help at
    servo {isotropic P} {mean P} {xx P} {yy P} {xy P} on REGION|boundary|cell|box|walls through
      boundary|cell|box {affine} at most RATE {every N cycles}
          at most RATE: a strain rate above 0. Largest magnitude of the added strain rate.
    until QUANTITY above|below VALUE {and QUANTITY above|below VALUE …} {every N cycles} at most N
      cycles
          at most N cycles: a whole number, 1 or more. Largest length of the stage.
          at N cycles, after the quantity of an expectation: the row of that cycle, counted from the
            start of the run; in a contact test `at N steps`
          at TIME, after the quantity of an expectation: the value at that time, interpolated linearly
            between two rows
= 0
$ --help C.normal
    `monitor C disc 1 with disc 2`, then `C.normal`
          normal, quantity of a contact, in N: elastic normal force F_n without the dashpot; the whole
            normal force is `normal` plus `dashpot.normal`
    `region M all`, then `M.normal.mean`
          normal.mean, quantity of a region, in N: mean: elastic normal force of the contacts
          normal.max, quantity of a region, in N: largest value: elastic normal force of the contacts
          normal.min, quantity of a region, in N: smallest value: elastic normal force of the contacts
          normal.std, quantity of a region, in N: standard deviation: elastic normal force of the
            contacts
          normal, quantity of a contact test, in N: elastic normal force
= 0
$ --help dashpot
    `dashpot` of other programs is `damping`, `ratio` or `stiffness` here
    damping {walls} stiffness TIME|ratio X|r89-fraction X | walls none | critical beyond overlap F |
      mass RATE | con1 X as cs79|velocity|all | centred | late | none
        Sets the damping at contacts [CS79 28] [R89 4.3, 4.13], or of all particles [CS79 34] [R89
        sec. 6.5.1]; one statement for each kind of damping; default none. In a stage the damping
        changes from this stage on. Place: the scene; a page with `start`, before its first stage; a
        stage.
    `monitor C disc 1 with disc 2`, then `C.dashpot.normal`
          dashpot.normal, quantity of a contact, in N: normal force of the dashpot, D_n [CS79 26]
          dashpot.shear, quantity of a contact, in N: shear force of the dashpot, D_s [CS79 27]
= 0
$ --help friction
    material NAME {density D} {kn K} {ks K} {friction F} {cohesion N} {young E} {poisson NU} {rigid}
          friction F: a number, 0 or more; without it: 0. Tangent of the angle of friction [CS79 19].
            Between two materials: the smaller value.
    pair MATERIAL MATERIAL {kn K} {ks K} {friction F} {cohesion N}
          friction F: a number, 0 or more; without it: the smaller of the two values. Tangent of the
            angle of friction [CS79 19].
    material NAME {kn K} {ks K} {friction F} {cohesion N}
          friction F: a number, 0 or more; without it: as it was. Tangent of the angle of friction
            [CS79 19].
    pair MATERIAL MATERIAL {kn K} {ks K} {friction F} {cohesion N}
          friction F: a number, 0 or more; without it: as it was. Tangent of the angle of friction
            [CS79 19].
= 0
$ --help kinetic
    `kinetic` of other programs is `energy.kinetic` here
          energy.kinetic, quantity of the scene, in J: kinetic energy of all free particles, rotation
            included
= 0
$ --help hypot
          hypot, of expressions: see nineball --help expressions
= 0
$ --help MPa
          MPa, a unit; see nineball --help units: a pressure (Pa)
= 0
$ --help deg
          deg, a unit; see nineball --help units: an angle or an angular velocity
= 0
$ --help psi
    1 psi is 6.894757293 kPa; units are those of SI: see nineball --help units
= 0
$ --help mindlin_scaled
          shear mindlin_scaled, a contact law; see nineball laws: as mindlin, but T decreases with the
            contact radius when N falls
= 0
$ --help 'normal hertz'
          normal hertz, a contact law; see nineball laws: elastic spheres, N = (4/3) E* R*^(1/2)
            overlap^(3/2)
= 0
$ --help momentum
          momentum, a reference; see nineball list: free particles conserve momentum; without shear
            forces also angular momentum
          momentum.x, quantity of the scene, in kg.m/s: momentum of all free particles
          momentum.y, quantity of the scene, in kg.m/s: momentum of all free particles
          momentum.angular, quantity of the scene, in kg.m2/s: angular momentum of all free particles
            about the origin, counterclockwise
= 0
$ --help GX
    gravity GX GY
        Sets a uniform acceleration of all free particles; default none. In a stage it changes from
        this stage on.
= 0
$ --help SXX
    boundary stress SXX SYY {shear SXY}
        Makes the boundary's particles free and applies a stress to them, from this stage on. The
        force on each is this stress times the part of the polygon through their centres that belongs
        to the particle.
= 0
$ --help spacing
    lattice discs|spheres {square} {hexagonal} NX by NY {from X Y} radius R {spacing S} MATERIAL
          spacing S: a length above 0; without it: 2R. Distance of the centres; at 2R they touch.
= 0
$ --help 'amplitude max'
          max, after the quantity of an expectation: the largest value of the recorded rows
          max, of expressions: see nineball --help expressions
          amplitude, after the quantity of an expectation: half the difference between the largest and
            the smallest value
= 0
$ --help MEASURE | sed -n '1,9p'
    write `region M circle 40 mm 40 mm radius 30 mm`, or `region M all`, then `record M.porosity M.coordination M.stress.mean`
    region NAME circle X Y radius R {rings N} {from STAGE} | box X1 Y1 to X2 Y2 {from STAGE} | inside
      F {rings N} {from STAGE} | all {from STAGE}
        Names a region of the plane for averages: `A.stress.mean`. A particle is inside if its centre
        is. Place: the scene; a page with `start`, before its first stage.
    report MEASURE
        Writes the measure to values.tsv and to the verdict, and checks nothing.
    MEASURE within TOLERANCE
        The computed value agrees with the reference; a residual should be 0. TOLERANCE: `0.1 %` or
= 0
$ --help COLUMN
    QUANTITY versus COLUMN {in STAGE} within TOLERANCE
        A curve agrees with that of the reference at every row. COLUMN is the independent variable.
        `0.5 % of peak` is a fraction of the largest magnitude of the reference.
= 0
$ --help lost
    `region M all`, then `M.contacts.lost`
          contacts.lost, quantity of a region: number of contacts lost since the stage that `from`
            names, else the start
    `lost` of version 0.3 is `dissipated` now
= 0
$ --help 'boundary fixed'
    boundary fixed
        Fixes the boundary's particles from this stage on. Place: a stage.
  
          stage     rest
            boundary fixed
            cycles  10
  
= 0
$ --help reverse
    reverse velocities
        Changes the sign of all velocities and spins, also those of walls, at the beginning of this
        stage. Without friction and damping the particles then retrace their motion. Place: a stage.
  
          stage     back
            reverse velocities
            cycles  10
  
= 0
$ --help stage
    stage NAME
        Begins a stage. The statements below belong to it, up to the next `stage`. Place: the scene; a
        page with `start`, before its first stage; a stage.
          NAME: a name for the stage.
  
          stage     strike
  
    start PAGE stage NAME {with NAME=VALUE …}
          stage NAME: The run begins at the end of that stage of the other page.
          stage.time, quantity of the scene, in s: time since the stage began
        --stage NAME        the stage at whose end the state is taken (default: the last one) (state)
= 0
$ --help unbalanced-force
    `unbalanced.max` is the largest unbalanced force over the largest contact force [CS79]; `M.unbalanced.mean`, with `region M all`, is the ratio of the means, PFC's average ratio
          unbalanced.max, quantity of the scene: largest unbalanced force on a particle over largest
            contact force, dF/F of [CS79 table 1]; infinite if forces act but all contact forces are
            0, 0 if no force acts. The force of an oscillation crosses zero in motion, so a wait for
            rest is `until unbalanced.max below 1e-4 and energy.kinetic below VALUE and contacts above
            0`
= 0
$ --help energy.kinetc
! nineball: `energy.kinetc` is not a word of pages; did you mean `energy.kinetic`?; nineball --help scene lists all words, nineball laws the laws
= 2
$ --help constnat
! nineball: `constnat` is not a word of pages; did you mean `constant`?; nineball --help scene lists all words, nineball laws the laws
= 2
$ --help strain | sed -n '1,26p'
  
  Which strain
  
    Four statements of a stage impose a strain rate. The list says what each of them moves, and when
    to use it:
  
          cell strain: moves the periodic cell and, with it, all particles. For a sample without walls
            or edges: compression and shear at uniform strain. Needs `periodic cell`.
          box strain: moves the four walls of a box, without shear; the walls push the particles. For
            a biaxial test between walls, as in the laboratory. Needs `box`.
          boundary strain: moves the outermost particles of an assembly; contacts carry the motion
            inwards. For the round assemblies of the thesis. Needs `boundary circle`.
          affine strain: moves the free particles inside, in addition to their own motion. Use it with
            `boundary strain` at the same rate, so that the assembly deforms as a whole at once. Needs
            no other statement; not possible with a cell.
  
    Strains count from the start of the run. With `region S all from STAGE`, `S.strain.xx` and
    `S.strain.yy` count from the beginning of STAGE. The height of a box after one stage and after an
    earlier one is compared in a block `expect`: `box.height last in LATER expected 0.98 of box.height
    last in EARLIER within 1 % [SOURCE]`; `box.width` likewise.
  
    cell strain EXX EYY {shear EXY} {c12 C} {c21 C}
        Strains the periodic cell about its centre, from this stage on. The strain rate is imposed on
        all particles as an affine motion [R89 4.43, 4.44]. Place: a stage.
    box strain EXX EYY
        Moves the four walls of the box with this strain rate about the centre of the box, from this
= 0
$ --help quantities dashpot
    `monitor C disc 1 with disc 2`, then `C.dashpot.normal`
          dashpot.normal, quantity of a contact, in N: normal force of the dashpot, D_n [CS79 26]
          dashpot.shear, quantity of a contact, in N: shear force of the dashpot, D_s [CS79 27]
= 0
$ --help quantities dashpots
! nineball: `quantities dashpots` is not a word of pages; nineball --help scene lists all words, nineball laws the laws
= 2
$ --help below
    until QUANTITY above|below VALUE {and QUANTITY above|below VALUE …} {every N cycles} at most N
      cycles
          QUANTITY above|below VALUE: a condition: a quantity, as in `record`, and a number with the
            unit of the quantity.
    MEASURE below MEASURE|NUMBER
        The measure is less than the second one of the same run, or than a number with its unit. Equal
        is not below, and NaN is neither below nor above.
  
          C.overlap in part  below  C.overlap max in strike
          energy.kinetic in part  below  1 MJ
  
= 0
$ --help quantities | sed -n '1,18p'
    Quantities for `record`, `until` and expectations, by families. `nineball --help quantities
    FAMILY` describes each quantity of a family, such as `nineball --help quantities stress`.
  
    Of the scene:
          cycle: calculation cycles since the start
          time: time since the start
          stage: .time
          contacts, .deep: number of contacts with an overlap
          unbalanced: .max
          energy: .kinetic, .stored, .friction, .sliding, .shear, .damped, .walls, .gravity, …
          work: .balance
          momentum: .x, .y, .angular
          step, .single-contact, .stable, .fracc, .rayleigh, .rayleigh-mean, .rayleigh-fit, …: the
            time step
          boundary: .particles, .radius, .area, .roughness, .stress.xx, .stress.xy, …
          gap: smallest gap between two particles, at most the skin; below 0: they overlap
    Of a particle, `monitor A disc 1`, written `A.NAME`:
          x: position of the centre
= 0
$ --help scene | sed -n '1,12p'
  
  Words
  
    A page is a Markdown file. The program reads its fenced blocks `scene` or `contact-test`, `expect`
    and `gnuplot`; all else is prose. Several blocks of one kind are read as one block, in their
    order. A statement is one line of words with spaces between them; `#` begins a comment.
  
    Each section shows the syntax of a statement, what it does, where it may stand, its arguments and
    an example. In the syntax, CAPITALS stand for a value, a part in `{...}` may be left out, and
    `a|b` means a or b. Clauses (a word and its values) may be in any order; only `every N cycles` of
    `servo` is always the last. In the list of arguments, `without it` gives the default; an argument
    without default is required, unless `|` in the syntax makes it one of several. `$NAME` stands for
= 0
$ --help units | sed -n '1,26p'
    units none|si
        Whether numbers have units. With `si`, the default, each number that has a dimension has a
        unit. With `none` all numbers are written without a unit, in consistent units such as those of
        SI. `units` holds for the whole page. Place: the scene; a contact test, before its first
        segment.
          none|si: `si`: numbers have units; `none`: they are written without units.
  
          units     si
  
  
  Numbers, units and expressions
  
    A value in a statement is a number with its sign, `$NAME` or `-$NAME`, or an expression in
    parentheses; one unit may follow each. Operators and functions stand in parentheses: `radius
    (R/2)`, `cycles (2*n)`, `velocity (v*cos(angle)) m/s 0 m/s`. Where a whole number is needed, the
    value of an expression may differ from it by rounding, that is by up to 1e-12 of it: `cycles (0.1
    ms/dt)`.
  
    A unit is one word after a space. It is made of m, s, g, N, Pa, J, rad and deg, with a prefix n, u
    or µ, m, c, k, M, G (deg has none) and powers from 1 to 9. These are joined by `.` (times) and `/`
    (over): `0.3 mm`, `2.7 g/cm3`, `4 N.m`, `5 1/s`. `%` and `ppm` are factors, rad is 1 and deg is
    pi/180. `0.3 mm` is the double nearest to 0.0003: all units but deg are powers of ten of the SI
    unit. With `units none` all numbers are written without a unit; `%` and `ppm` may still follow
    them, and angles are radians.
  
    Expressions are in parentheses, after `let NAME =` and in `--set NAME=`. In them NAME without `$`
= 0
$ --help expect | sed -n '1,30p'
  
  Expectations
  
    A MEASURE is `QUANTITY {REDUCER} {in STAGE}`: a quantity that the page records, and how the rows
    of a stage become one number. Without `in STAGE` the rows are those of the last stage that has
    rows, and for `at` those of all stages. REDUCER is one of:
  
          last: the last row; the default
          max: the largest value of the recorded rows
          min: the smallest value of the recorded rows
          mean: the mean of all rows
          amplitude: half the difference between the largest and the smallest value
          frequency: number of upward crossings of the mean, minus one, over the time from the first
            to the last of them, 1/s
          at N cycles: the row of that cycle, counted from the start of the run; in a contact test `at
            N steps`
          at TIME: the value at that time, interpolated linearly between two rows
          in all: in place of `in STAGE`: the rows of all stages
  
    reference NAME
        Selects the reference solution of the page, with which `within`, `versus` and `order` compare
        the results. `nineball list` lists the references; they are computed from theory, in the files
        of cases/refs.
          NAME: the name of a reference.
  
          reference  two_wall_compression
  
    report MEASURE
        Writes the measure to values.tsv and to the verdict, and checks nothing.
  
= 0
$ --help contact-test | sed -n '1,20p'
  
  Contact test
  
    A page with a block `contact-test` instead of `scene` tests one contact: it prescribes approach
    and slip, or forces. There is no motion and no time. In an expectation the name of a segment
    stands in place of a stage: `shear max in load`.
  
    repeat from SEGMENT N more times
        Repeats the lines from the beginning of SEGMENT down to this line N times, after they have run
        once. The repeated segments are called SEGMENT-2, SEGMENT-3 and so on. Place: a segment of a
        contact test.
          from SEGMENT: the name of a segment above.
          N times: a whole number, 1 or more. How often the lines run in addition to the first time.
  
          repeat    from load 2 more times
  
    contact disc|sphere R MATERIAL with disc|sphere R MATERIAL | with wall MATERIAL
        Defines the contact that is tested, between two particles or between a particle and a wall. At
        the start they just touch. Place: a contact test, before its first segment.
          disc|sphere R MATERIAL: a length above 0, the radius, and the name of a material.
= 0
$ check none.md --version --help
  nineball VERSION
  Copyright (C) 2026 the nineball authors.
  GPL-3.0-or-later: free software, without any warranty.
= 0
$ --version
  nineball VERSION
  Copyright (C) 2026 the nineball authors.
  GPL-3.0-or-later: free software, without any warranty.
= 0
$ --help
  nineball simulates discs and spheres in the plane by the distinct element method, and checks the results
  
  usage: nineball COMMAND …
  
    run PAGE… [-o FOLDER]        run pages, print the verdicts, write tables
    check PAGE… [--tap]          run pages, print the verdicts
    figure PAGE… [-o FOLDER]     run pages, draw their figures with gnuplot
    report PAGE… [-o FOLDER]     run pages, draw figures, write a site with texts, results and figures
    explain PAGE…                print the plan: passes and hooks, the lines that request them, the step, the cost
    advise PAGE --within TOLERANCE find the cheapest step and laws whose error in a quantity is within a tolerance, by running the page; or --all [PAGE… or FOLDER…]
    state PAGE [-o FILE]         run a page to the end of a stage, save its state in a file
    migrate PAGE… [--in-place]   rewrite pages of version 0.3 in the words of this one
    laws                         list the contact laws: equations, material parameters
    list                         list the references
  
    -o, --output FOLDER     output folder (default: NAME.out; report: report; advise --all: trades); for `state` a FILE (NAME-STAGE.state) (run, figure, report, advise, state)
        --set NAME=VALUE    replaces the value of the page's `let` or `sweep` NAME. NAME may also be normal, shear, step or damping; refine, a number that divides the step and multiplies the cycles; soften, a number that divides the stiffnesses; follow, a FILE with the points of a contact test
        --stage NAME        the stage at whose end the state is taken (default: the last one) (state)
        --states FOLDER     folder of the saved states from which pages start (default: $NINEBALL_STATES, or states)
        --all               search for advice on each page, also on those below a FOLDER (default: cases). --quantity and --within may be lists separated by `;`. Without --quantity, advice is about up to three quantities that the page expects, in the middle run of a sweep. Without --within, the tolerances are 10 %, 1 % and 0.1 %. The output folder (default: trades) gets a figure of each page and the table trades.tsv, to which a later call adds rows. Exit status 1: a search ended without advice (advise)
        --quantity MEASURE  quantity whose error counts, as in an expect block (default: that of the first expectation of a single value) (advise)
        --within TOLERANCE  largest error of the quantity: '1 %', or a number in its unit (advise)
        --budget TIME       time for the search, s (default: 60) (advise)
        --over NAME         take the error of the mean over realizations; a realization is a run with NAME = 1, 2, …, where NAME is a `let` or `sweep` of the page (advise)
        --realizations N    number of realizations, 8 to 32 (default: 8) (advise)
        --jobs N            runs of a sweep, or trials, in parallel (default: the number of processors, divided by --threads) (run, check, figure, report, advise)
        --threads N         threads of one run (default 1); the results do not depend on it
        --isa NAME          instruction set: plain, avx2 or avx512 (default: the widest); the results do not depend on it
        --checkpoint SECONDS save the run in the folder of states at the ends of stages, every SECONDS (--checkpoint=30; default: 60), and when it is interrupted by SIGINT or SIGTERM; refused if there is a checkpoint that --resume could continue (run, check, figure, report)
        --resume            continue from the last checkpoint, with the same results as a run without interruption; implies --checkpoint (run, check, figure, report)
        --unrun PAGE        show this page too, without running it; may be given many times (report)
        --trust             draw even where gnuplot cannot be confined, and copy linked texts and pictures from all folders: for pages that you trust (figure, report, advise)
        --in-place          write the result into the pages (default: to standard output) (migrate)
        --rounding WHICH    all: run under the four rounding modes, print how many bits of the expected quantities do not depend on them; parts: also for each part of the cycle alone (check)
        --tap               verdicts as TAP, which `make check` reads (check)
    -h, --help              this text; all words of pages: nineball --help scene; one word, also of another program: nineball --help disc; topics: expect, gnuplot, quantities, units, expressions
        --version           version and licence
  
  exit status: 0 passed, 1 a check failed, 2 bad use or a mistake in a page, 3 run aborted, 4 out of memory; `figure` ends with 0 also if a check failed, and says so
= 0
$ laws | sed -n '/mindlin_deresiewicz  /,/history/p; /^normal  linear/,/history/p; /^shear   mindlin  /,/history/p; /^A contact/,$p'
  normal  linear                linear spring, F_n = k_n overlap  [CS79 16, 18]
                                parameters of the materials: kn
                                0 history variables; reports its stored energy
  shear   mindlin               elastic spheres without micro-slip (mindlin_deresiewicz has it): T += 8 G* a ds, |T| <= mu N + c  [R89 3.27]
                                parameters of the materials: young, poisson, friction, cohesion
                                1 history variable; does not report stored energy; may create energy
  shear   mindlin_deresiewicz   exact law of elastic spheres with micro-slip, by Cattaneo and Mindlin, for any loading history  [R89 sec. 3.2-3.5]
                                parameters of the materials: young, poisson, friction
                                332 history variables or as many as `memory` asks for; reports its stored energy
  A contact of two particles of one material has the kn and ks of this material. A contact of two materials
  with the stiffnesses a and b has 2ab/(a+b), twice that of two springs in series (PFC), unless `pair` gives
  another stiffness.
= 0
$ list | sed -n '1,3p;$p'
  references, for `reference NAME` in a page:
    momentum                 free particles conserve momentum; without shear forces also angular momentum  [CS79 20-23]
    contact_ladder           shear laws along a path of slip at constant normal force in closed form, and their errors in an impact  [R89 3.25, 3.40, 3.50]
    wedge                    a particle at rest in a wedge of two walls without friction: statics, and the guaranteed step  [CS79 20-25]
= 0
$ advise good.md
! nineball: expected one page and --within TOLERANCE, as in `nineball advise PAGE --within '1 %'`, and with --budget a number of seconds above 0; for many pages write `nineball advise --all`
= 2
$ advise good.md bad.md --within '1 %'
! nineball: expected one page and --within TOLERANCE, as in `nineball advise PAGE --within '1 %'`, and with --budget a number of seconds above 0; for many pages write `nineball advise --all`
= 2
$ advise good.md --within '1 %' --budget 0
! nineball: expected one page and --within TOLERANCE, as in `nineball advise PAGE --within '1 %'`, and with --budget a number of seconds above 0; for many pages write `nineball advise --all`
= 2
$ advise good.md --within '1 %' --realizations 9
! nineball: expected --realizations from 8 to 32, together with --over NAME
= 2
$ advise good.md --within '1 %' --over v --realizations 7
! nineball: expected --realizations from 8 to 32, together with --over NAME
= 2
$ advise good.md --within '1 %' --over v --realizations 33
! nineball: expected --realizations from 8 to 32, together with --over NAME
= 2
$ advise wrong.md --within '1 %'
! wrong.md:5:7: error: expected `unstable`, found `nothing`
!     5 | allow nothing
!       |       ^~~~~~~
!   hint: for example `allow     unstable`
= 2
$ advise empty.md --within '1 %'
! empty.md: error: the page has no expectation of a single value: name a quantity that it records, by --quantity
= 2
$ advise good.md --quantity D.q --within '1 %'
! quantity: error: expected a quantity that the page records, found `D.q`
!       | D.q within 1 %
!       | ^~~
!   hint: `D` is a particle; its quantities are x, y, angle, vx, vy, spin, fx, fy, moment: see `nineball --help quantities`
= 2
$ advise good.md --quantity 'D.x max' --within '1 % x'
! quantity: error: expected the end of the text, found `x`
!       | D.x max within 1 % x
!       |                    ^
= 2
$ advise good.md --within '1 % of peak'
! good.md: error: expected a tolerance like `1 %`, or a number in the unit of the quantity
= 2
$ advise good.md --within '1 % of D.x max'
! good.md: error: expected a tolerance like `1 %`, or a number in the unit of the quantity
= 2
$ advise good.md --within '0 %'
! good.md: error: expected a tolerance above 0
= 2
$ advise good.md --within -1
! quantity: error: expected a tolerance of 0 or more, found `-1`
!       | D.x within -1
!       |            ^~
= 2
$ advise good.md --within '1 %' --over w
! good.md: error: expected after --over a name that the page defines by `let` or `sweep`, found `w`
= 2
$ advise good.md --within '1 %' --over vv
! good.md: error: expected after --over a name that the page defines by `let` or `sweep`, found `vv`
= 2
$ advise good.md --within '1 %' --over v --set v=1
! good.md: error: --over v and --set v=1 exclude each other: remove one of the two
= 2
$ advise good.md --within '1 %' --over v --set vv=1
! --set: error: expected a name that the page defines by `let` or `sweep`, or `normal`, `shear`, `step`, `damping`, `trade`, `refine`, `soften` or `follow`, found `vv`
!       | vv=1
!       | ^~
= 2
$ advise good.md --within '1 %' --budget 1e-9
! good.md: error: the page cannot be run with its own step and with half of it: the budget is too small; choose a larger --budget
= 1
$ advise good.md --within '1 %' --set step=-1
! --set: error: expected a time above 0, found `-1`
!       | step=-1
!       |      ^~
= 2
$ advise refine.md --within '1 %'
! refine.md: error: the page has a value named `refine`, which hides --set refine=R: rename this value
= 2
$ advise many.md --within '1 %'
! many.md: error: expected a page of at most 50 particles, found 51: the motion of many particles is chaotic, so the results of one run have no limit for a step towards zero. A mean over realizations has such a limit: name the seed of the random packing, `let seed = 1` and `seed $seed`, and add `--over seed`
= 2
$ advise --all wrong.md refine.md -o all
  1 of 2, wrong: 0 searches, 0 with advice; about T left
    D.x within 10 %: the page has a value named `refine`, which hides --set refine=R: rename this value
  2 of 2, refine: 1 searches, 0 with advice
  1 searches, 0 with advice; look at all/trades.tsv
! wrong.md:5:7: error: expected `unstable`, found `nothing`
!     5 | allow nothing
!       |       ^~~~~~~
!   hint: for example `allow     unstable`
! refine.md:5: warning: no line uses `$refine`: write `$refine` where the value belongs
= 2
$ advise --all refine.md wrong.md -o all
  1 of 2, refine: 1 searches, 0 with advice; about T left
  2 of 2, wrong: 0 searches, 0 with advice
  1 searches, 0 with advice, 1 of them from an earlier call; look at all/trades.tsv
! refine.md:5: warning: no line uses `$refine`: write `$refine` where the value belongs
! wrong.md:5:7: error: expected `unstable`, found `nothing`
!     5 | allow nothing
!       |       ^~~~~~~
!   hint: for example `allow     unstable`
= 2
$ advise --all empty.md -o all
    empty has no expectation of a single value that depends on the step
  1 of 1, empty: 0 searches, 0 with advice
  0 searches, 0 with advice; look at all/trades.tsv
= 0
$ advise noted.md --within '1 %'
! noted.md: error: the page has no expectation of a single value: name a quantity that it records, by --quantity
= 2
$ advise first.md --within '1 %' 2>&1 | sed -n 1p
  first: D.x max within 1 %
= 0
$ advise --all noted.md -o all
    noted has no expectation of a single value that depends on the step
  1 of 1, noted: 0 searches, 0 with advice
  0 searches, 0 with advice; look at all/trades.tsv
= 0
$ report good.md sub/good.md
! nineball: good.md and sub/good.md have the same name, so the same output folder: rename one of them
= 2
END

# ---- tables, and the script of a figure ----

cat >data.md <<'END'
# It's data

```scene
units     si
sweep     v  0.25 m/s 0.5 m/s
material  m  density 1 kg/m3  kn 1 N/m
disc      1 m 2 m  radius 0.5 m  m  velocity $v -1 m/s
monitor   D  disc 1
step      0.5 s
record    time D.x D.y
stage     go-on
cycles    2
snapshot
stage     more
record    every 2 cycles
cycles    3
```

```expect
D.x max in go-on  above 1.25 m
D.x               expected 2 m within 0.5 m [a guess]
D.y max           increases with v
report D.x
```

```gnuplot
plot $table_1 using 2:3, \
     $table_2 using 2:3
```

```gnuplot
set title 'It'
```
END
# written FILE...: prints files, without the style of figures, the values of hashes, and the tables of walls and contacts.
written() {
  for file in "$@"; do
    echo "== $file"
    sed "/^plots = /,/^diagram = /{/^plots = /!d;}; /^\$go_on_[wc]/,/^EOD/d
      s/FNV-1a [0-9a-f]\{16\}$/FNV-1a HASH/; s/^# nineball [0-9.]*$/# nineball VERSION/; s,^plots = '/.*/',plots = '/'," "$file"
  done
}
"$nineball" run data.md -o data >out 2>err </dev/null
test $? -eq 1 && { PATH=$work/none "$nineball" figure data.md -o data >out 2>err </dev/null || test $? -eq 2; } &&
  grep -qxF 'nineball: gnuplot cannot be run: not found (its package is gnuplot-nox)' err && test ! -s out &&
  written data/table.tsv data/values.tsv data/verdict.tsv data/go-on-particles-1.tsv data/go-on-particles-2.tsv data/data.gp >given &&
  diff -u - given >"$why" <<'END'
== data/table.tsv
# nineball VERSION
# page data, FNV-1a HASH
v/m/s	stage	time/s	D.x/m	D.y/m
0.25	go-on	0	1	2
0.25	go-on	0.5	1.125	1.5
0.25	go-on	1	1.25	1
0.25	more	2	1.5	0
0.25	more	2.5	1.625	-0.5
0.5	go-on	0	1	2
0.5	go-on	0.5	1.25	1.5
0.5	go-on	1	1.5	1
0.5	more	2	2	0
0.5	more	2.5	2.25	-0.5
== data/values.tsv
# nineball VERSION
# page data, FNV-1a HASH
v/m/s	run	D.x max in go-on/m	reference D.x max in go-on/m	D.x/m	reference D.x/m	D.y max/m	reference D.y max/m
0.25	1	1.25	nan	1.625	2	0	nan
0.5	2	1.5	nan	2.25	2	0	nan
== data/verdict.tsv
# nineball VERSION
# page data, FNV-1a HASH
verdict	line	expected	computed
FAIL	20	D.x max in go-on above 1.25 m (v=0.25 m/s)	computed 1.25 m and 1.25 m
pass	21	D.x expected 2 m within 0.5 m [a guess] (v=0.25 m/s)	computed 1.625 m, expected 2 m, error 0.375 m, tolerance 0.5 m
note	23	report D.x (v=0.25 m/s)	computed 1.625 m
pass	20	D.x max in go-on above 1.25 m (v=0.5 m/s)	computed 1.5 m and 1.25 m
pass	21	D.x expected 2 m within 0.5 m [a guess] (v=0.5 m/s)	computed 2.25 m, expected 2 m, error 0.25 m, tolerance 0.5 m
note	23	report D.x (v=0.5 m/s)	computed 2.25 m
FAIL	22	D.y max increases with v	computed 0 m at v = 0.25 m/s, 0 m at 0.5 m/s
== data/go-on-particles-1.tsv
# nineball VERSION
# page data, FNV-1a HASH
# run v=0.25 m/s
particle/-	x/m	y/m	radius/m	angle/rad	vx/m/s	vy/m/s	fx/N	fy/N	moment/N.m	spin/rad/s	contacts/-	fixed/-
1	1.25	1	0.5	0	0.25	-1	0	0	0	0	0	0
== data/go-on-particles-2.tsv
# nineball VERSION
# page data, FNV-1a HASH
# run v=0.5 m/s
particle/-	x/m	y/m	radius/m	angle/rad	vx/m/s	vy/m/s	fx/N	fy/N	moment/N.m	spin/rad/s	contacts/-	fixed/-
1	1.5	1	0.5	0	0.5	-1	0	0	0	0	0	0
== data/data.gp
# It's data
# nineball VERSION
# page data, FNV-1a HASH
plots = '/'
runs = 2
array run[runs]
run[1] = 'v=0.25 m/s'
run[2] = 'v=0.5 m/s'
$values << EOD
v/m/s	run	D.x max in go-on/m	reference D.x max in go-on/m	D.x/m	reference D.x/m	D.y max/m	reference D.y max/m
0.25	1	1.25	nan	1.625	2	0	nan
0.5	2	1.5	nan	2.25	2	0	nan
EOD
D_x_max_in_go_on_1 = 1.25
D_x_1 = 1.625
D_y_max_1 = 0
D_x_1 = 1.625
$table_1 << EOD
stage	time/s	D.x/m	D.y/m
go-on	0	1	2
go-on	0.5	1.125	1.5
go-on	1	1.25	1
more	2	1.5	0
more	2.5	1.625	-0.5
EOD
$go_on_particles_1 << EOD
particle/-	x/m	y/m	radius/m	angle/rad	vx/m/s	vy/m/s	fx/N	fy/N	moment/N.m	spin/rad/s	contacts/-	fixed/-
1	1.25	1	0.5	0	0.25	-1	0	0	0	0	0	0
EOD
D_x_max_in_go_on_2 = 1.5
D_x_2 = 2.25
D_y_max_2 = 0
D_x_2 = 2.25
$table_2 << EOD
stage	time/s	D.x/m	D.y/m
go-on	0	1	2
go-on	0.5	1.25	1.5
go-on	1	1.5	1
more	2	2	0
more	2.5	2.25	-0.5
EOD
$go_on_particles_2 << EOD
particle/-	x/m	y/m	radius/m	angle/rad	vx/m/s	vy/m/s	fx/N	fy/N	moment/N.m	spin/rad/s	contacts/-	fixed/-
1	1.5	1	0.5	0	0.5	-1	0	0	0	0	0	0
EOD
# line 27 of the page:
plot $table_1 using 2:3, \
     $table_2 using 2:3
# line 32 of the page:
set title 'It'
END
result $? 'the tables of a run, and the script of its figure without gnuplot'

# A table may have a million rows, here one at the start, 300000 of stage `a` and the others of stage `b`.
for last in 2099997:quiet 2100000:said; do
  printf '```scene\nunits none\nmaterial m density 1 kn 100\ndisc 0 0 radius 1 m velocity 1 0\nstep 1e-6\nrecord time\nstage a\ncycles 300000\n' >rows.md
  printf 'stage b\nrecord every 3 cycles\ncycles %s\n```\n' "${last%:*}" >>rows.md
  "$nineball" run rows.md -o rows >out 2>"$why" </dev/null
  echo 'rows.md:9: warning: table.tsv has 1000001 rows, most of them of stage `b`: write `record every 30 cycles` in it' >wanted
  case $last in *quiet) : >wanted ;; esac
  diff wanted "$why" >out
  result $? "a table of a million rows: $last"
done

# Three stages have 333334 rows or less. The first of the largest two is named, with an interval that makes its table smaller.
printf '```scene\nunits none\nmaterial m density 1 kn 100\ndisc 0 0 radius 1 m velocity 1 0\nstep 1e-6\nrecord time\n' >rows.md
printf 'stage a\ncycles 333332\nstage b\ncycles 333334\nstage c\ncycles 333334\n```\n' >>rows.md
"$nineball" run rows.md good.md >out 2>"$why" </dev/null
echo 'rows.md:9: warning: table.tsv has 1000001 rows, most of them of stage `b`: write `record every 10 cycles` in it' | diff - "$why" >wanted
result $? 'a table of a million rows in stages of equal length'
awk '/ cycles, .* s$/ { t[++n] = $(NF - 1) } END { exit !(n == 2 && 2*t[2] < t[1]) }' out && cp out "$why"
result $? 'the time of the second page does not count that of the first one'

# 2 runs of 150000 rows with 12 quantities of 8 bytes, with stage, cycle and time, need more than 32 MB, so a temporary file gets the rest.
# The first run alone stays in memory. The file is in the output folder, or without one in $TMPDIR, or in /tmp if that is empty. The
# results are complete without the file, too.
printf '```scene\nunits none\nsweep v 1 2\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m velocity $v 0\nmonitor D disc 1\nstep 1e-6\n' >large.md
printf 'record time stage.time D.x D.y D.vx D.vy D.fx D.fy D.moment D.spin D.angle cycle\nstage a\ncycles 150000\n```\n```expect\nD.x increases with v\n```\n' >>large.md
for call in none:check "none:run -o large" :check; do
  TMPDIR=${call%%:*} "$nineball" ${call#*:} large.md --jobs 1 >out 2>"$why" </dev/null
  test $? -eq 0 && grep -q '1 of 1 checks passed' out || echo 'the check fails' >>"$why"
  case $call in
  none:check) echo 'large.md: note: the results stay in memory: cannot write a temporary file in none: No such file or directory, run v=2' >wanted ;;
  *) : >wanted ;;
  esac
  diff wanted "$why" >out && test ! -e none
  result $? "the folder of the temporary file: TMPDIR=$call"
done

# A search on a terminal writes its progress over one line, as a fraction of the budget, which is the time so far, and the rest of the
# budget: P % of 400 s are 4 P s. It removes the line at its end. The step may be 128 times as long, the longest that is tried. The run of
# the page takes more than a second, so it is not timed again: 2.6 s or more by the cost of a cycle, which may be measured too large.
cat >slow.md <<'END'
```scene
units none
trade laws none
material m density 1 kn 1
disc 0 0 radius 1 m velocity 1 0
monitor D disc 1
let n = 1048576
step 1e-6
record D.x
stage a
record every (n/16) cycles
cycles $n
```
END
if command -v script >/dev/null; then
  cycles=$("$nineball" explain slow.md | awk '/^  a cycle with recording takes/ { n = 1048576; while (n * $6 < 2.6e6) n *= 2; printf "%d", n }')
  script -qec "'$nineball' advise slow.md --set n=$cycles --quantity D.x --within 1 --budget 400 -o slow --trust" /dev/null </dev/null 2>&1 |
    tr '\r' '\n' >"$why"
  awk -v clear="$(printf '\033[K')" '
    / s left/ { seen++; d = 4*$4 + $6 - 400; bad += !/^slow.md, stage search: [ 0-9][ 0-9][0-9] %, [0-9]* s left   $/ || $4 < 1 || d > 3 || d < -3 }
    $0 == clear "slow: D.x within 1" { cleared = seen }
    /^  time: [0-9.e-]* s instead of [0-9.e-]* s, the shortest of the trials$/ { timed = $2 < $6/32 && $6 > 1 }
    END { exit !(seen && cleared == seen && timed && !bad) }' "$why"
  result $? 'the progress of a search on a terminal, and its times'

  script -qec "'$nineball' state slow.md --set n=$cycles -o slow.state" /dev/null </dev/null 2>&1 | tr '\r' '\n' >"$why"
  awk -v clear="$(printf '\033[K')" '
    / s left/ { seen++; bad += !/^slow.md, stage a: [ 0-9][ 0-9][0-9] %, [0-9]* s left   $/ }
    $0 == clear "the state at the end of stage `a` is in slow.state" { cleared = seen }
    END { exit !(seen && cleared == seen && !bad) }' "$why"
  result $? 'the progress of a state on a terminal'

  # A report writes the page that is next. When k pages took more than 2 s, the n - k others take (n - k)/k of this time, here 2 and 1/2.
  # After 2 s and then every half a second it writes the fraction P of the run, and the rest L of its time: L*P/(100 - P) is the time so far.
  # Of the pages it prints only those that failed, each on a line of its own.
  if command -v pandoc >/dev/null; then
    sed "s/^let n.*/let n = $((2 * cycles))/" slow.md >first.md
    began=$(date +%s)
    script -qec "'$nineball' report first.md good.md bad.md -o site" /dev/null </dev/null 2>&1 | tr '\r' '\n' >"$why"
    sed "s/$(printf '\033\[K')/|/; s/, about [0-9]* s left/, LEFT/; /, stage a: .* s left   $/d; /^|*$/d" "$why" | diff -u - /dev/fd/3 >out 3<<'END'
|1 of 3: first
|first                           0 checks, 0 failed; nothing was checked
|2 of 3: good, LEFT
|3 of 3: bad, LEFT
|bad                             2 checks, 1 failed
|look at site/index.html
END
    test ! -s out && sed -n 's/.* about \([0-9]*\) s left.*/\1/p' "$why" | tr '\n' ' ' |
      awk -v whole=$(($(date +%s) - began)) '{ exit !(NF == 2 && $1 >= 4 && $1 <= 4*$2 + 3 && 2*$2 <= whole + 2) }' &&
      awk -v whole=$(($(date +%s) - began)) '
        /^first.md, stage a: / { n++; last = $4; bad += !/^first.md, stage a: [ 0-9][ 0-9][0-9] %, [0-9]+ s left   $/ }
        /^first.md, stage a: / && $4 >= 20 && $4 <= 60 { middle++; t = $6*$4/(100 - $4); bad += t < 1.2 || t > whole + 2 }
        END { exit !(!bad && n > 0 && n <= 2*whole && last >= 60 && (n < 5 || middle)) }' "$why"
    result $? 'the progress of a report on a terminal'
  fi
fi
echo "1..$n"
