#!/bin/sh
# Tests the confinement of gnuplot: whatever the gnuplot block of a page says, `figure` reads no file of the user,
# writes only the figure, and runs no command. Every attack is run unconfined first, which shows that it would
# have an effect. TAP. $NINEBALL is the program, $srcdir the top of the source tree. With NINEBALL_CONFINE_REQUIRED set
# (as in .ci/run) it fails if this machine cannot confine gnuplot.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

. "${srcdir:-.}/tests/tap"
top=$(pwd)

if ! command -v gnuplot >/dev/null; then
  echo "1..0 # SKIP gnuplot is missing"
  test -z "${NINEBALL_CONFINE_REQUIRED:-}"
  exit
fi

skip() {
  n=$((n + 1))
  echo "ok $n - $1 # SKIP $2"
}

# Files of the user.
mkdir -p "$work/home" "$work/plots" && cd "$work" || exit 1
home=$work/home
printf '1 2 TOPSECRET\n' >"$home/secret"
printf "system('touch $work/harm')\n" | tee "$home/.gnuplot" "$home/evil.gp" >plots/style.gp

# page NAME: writes cases/NAME with the gnuplot lines of standard input. The folder plots is beside cases, as in the source tree.
page() {
  mkdir -p cases
  {
    sed '/^```gnuplot/,$d' "$top/tests/pages/passes.md"
    printf '```gnuplot\n'
    cat
    printf 'plot sin(x)\n```\n'
  } >"cases/$1"
}

# attack NAME: writes a page with the attack on standard input, and adds it to $attacks.
attacks=
attack() {
  page "$1.md"
  attacks="$attacks $1"
}
attack nothing </dev/null
attack system <<EOF2
system("touch $work/harm")
EOF2
attack eval <<EOF2
eval 'x = sys'.'tem("touch $work/harm")'
EOF2
attack backticks <<EOF2
x = "\`touch $work/harm\`"
EOF2
attack exclamation <<EOF2
! touch "$work/harm"
EOF2
attack output-pipe <<EOF2
set output '|cat >$work/harm'
plot x
unset output
EOF2
attack data-pipe <<EOF2
plot '<touch $work/harm; echo 1 2' using 1:2
EOF2
attack load <<EOF2
load '$home/evil.gp'
EOF2
attack load-pipe <<EOF2
load '<touch $work/harm'
EOF2
attack print <<EOF2
set print '$work/harm'
print 'x'
unset print
EOF2
attack print-pipe <<EOF2
set print '|cat >$work/harm'
print 'x'
unset print
EOF2
attack save <<EOF2
save '$work/harm'
EOF2
attack save-pipe <<EOF2
save '|cat >$work/harm'
EOF2
attack output <<EOF2
set output '$work/harm'
plot x
unset output
EOF2
attack output-beside <<EOF2
set output 'harm'
plot x
unset output
EOF2
attack table <<EOF2
set table '$work/harm'
plot x
unset table
EOF2
attack fit-log <<EOF2
set fit logfile '$work/harm'
f(x) = a * x
fit f(x) '+' using 1:(\$1) via a
EOF2
attack read-home <<EOF2
set datafile separator whitespace nocolumnheaders
plot '$home/secret' using 1:2:3 with labels
EOF2
attack read-system <<EOF2
set datafile separator ':' nocolumnheaders
plot '/etc/passwd' using 3:4:1 with labels
EOF2
attack read-page <<EOF2
set datafile separator whitespace nocolumnheaders
plot '../home/secret' using 1:2:3 with labels
EOF2
attack start-up </dev/null
attack style </dev/null

# figure ARGUMENT ...: draws a figure. The home folder, and the folder where gnuplot looks for scripts, have the files of the user.
figure() {
  rm -rf out harm cases/harm
  HOME=$home GNUPLOT_LIB=$home "$nineball" figure "$@" >said 2>&1 </dev/null
}
# True if an attack wrote, ran or read something.
harmed() {
  find . -name harm -print | grep -q . && return
  root=$(awk -F : '$3 == 0 { print $1; exit }' /etc/passwd)
  cat out/*.svg said 2>/dev/null | grep -q -e TOPSECRET -e ">$root<"
}

for name in $attacks; do
  NINEBALL_CONFINE=none figure "cases/$name.md" -o out --trust
  case $name in
  nothing | start-up | style) ! harmed ;; # not read even with --trust
  *) harmed ;;
  esac
  result $? "unconfined, for comparison: $name"
done
NINEBALL_CONFINE=none figure cases/nothing.md -o out
test $? -eq 2 && grep -q 'give --trust' said && test ! -e out/nothing.svg && ! ls out/*.new 2>/dev/null
result $? 'no confinement and no trust: nothing is drawn, status 2'
NINEBALL_CONFINE=nonsense figure cases/nothing.md -o out --trust
test $? -eq 2 && grep -q 'expected landlock, bwrap or none, found `nonsense`' said
result $? 'NINEBALL_CONFINE with another word: status 2'

# ---- each method of confinement ----

ran=0
why=$work/said
for how in landlock bwrap; do
  NINEBALL_CONFINE=$how figure cases/nothing.md -o out
  if grep -q 'cannot be confined here' said; then
    # A kernel that has Landlock, of which syscall 444 returns the version, must confine gnuplot.
    # Where bubblewrap starts another program, it must start gnuplot, too.
    if test "$how" = bwrap && bwrap --ro-bind / / --unshare-all --cap-drop ALL true 2>/dev/null; then
      result 1 "bwrap starts gnuplot"
    elif test "$how" = landlock && perl -e 'exit(syscall(444, 0, 0, 1) < 1)' 2>/dev/null; then
      result 1 "Landlock confines gnuplot"
    else
      skip "$how" "$(sed 's/.*(//; s/).*//' said)"
    fi
    continue
  fi
  ran=$((ran + 1))
  for name in $attacks; do
    NINEBALL_CONFINE=$how figure "cases/$name.md" -o out
    status=$?
    case $name in
    nothing | start-up | style) test $status -eq 0 && grep -q '<svg' "out/$name.svg" ;;
    *) : ;;
    esac && ! harmed
    result $? "$how: $name"
  done

  # Where confinement is available, --trust does not switch it off.
  NINEBALL_CONFINE=$how figure cases/system.md -o out --trust
  ! harmed
  result $? "$how: --trust does not weaken it"

  # No file name is run as a command or becomes part of a gnuplot string.
  for name in "a'b" 'a"b' '$(touch harm)' '`touch harm`' '<touch harm' '|touch harm' 'a b;touch harm' '~' '%s%n' '-e' "';system('touch harm');'"; do
    cp cases/nothing.md "cases/$name.md"
    rm -rf "out" harm
    NINEBALL_CONFINE=$how figure "cases/$name.md" -o "out/$name"
    test $? -eq 0 && test -s "out/$name/$name.svg" && test -s "out/$name/$name.png" && ! harmed
    result $? "$how: a page called $(echo "$name" | tr '#' ' ')"
    rm -f "cases/$name.md"
  done

  # The figure is the same as without confinement: recipes and fonts can be read.
  NINEBALL_CONFINE=none "$nineball" figure "$top/cases/3-nine-discs/nine-discs-statics.md" -o free --trust >said 2>&1 &&
    NINEBALL_CONFINE=$how "$nineball" figure "$top/cases/3-nine-discs/nine-discs-statics.md" -o confined >said 2>&1 &&
    cmp free/nine-discs-statics.svg confined/nine-discs-statics.svg >said 2>&1 && cmp free/nine-discs-statics.png confined/nine-discs-statics.png >said 2>&1
  result $? "$how: the figure is the same, bit by bit"

  # Messages cannot control the terminal.
  printf 'print "\\033]0;harm\\007\\033[2J"\n' | page bell.md
  NINEBALL_CONFINE=$how figure cases/bell.md -o out
  ! LC_ALL=C grep -q "$(printf '\033')" said
  result $? "$how: control characters are removed from the output of a page"

  # Processor time and size of files are limited; smaller limits are used here than in the program.
  printf 'while (1) { x = 1 }\n' | page loop.md
  printf 'set print "-"\nwhile (1) { print "............................................................" }\n' | page flood.md
  for name in loop flood; do
    rm -rf out
    (
      ulimit -t 3
      ulimit -f 2000
      NINEBALL_CONFINE=$how "$nineball" figure "cases/$name.md" -o out >said 2>&1 </dev/null
      test $? -eq 2
    ) && grep -q 'gnuplot was stopped' said && test ! -e "out/$name.svg" && ! ls out/*.new >/dev/null 2>&1
    result $? "$how: limits of time and size: $name"
  done
done
echo "confined by $ran of 2 ways" >said
test $ran -gt 0 || test -z "${NINEBALL_CONFINE_REQUIRED:-}"
result $? "$ran of 2 methods of confinement were tested"

# ---- what the confined program gets ----

# Instead of gnuplot a script is run that prints its limits, files and environment. File sizes are in blocks of 512 bytes, memory in
# KiB. The alarm clock of a process goes on when it executes another
# program.
mkdir bin
cat >bin/gnuplot <<'EOF2'
#!/bin/sh
exec >&2
echo "processor $(ulimit -t) s, files $(ulimit -f), memory $(ulimit -v), core $(ulimit -c)"
for file in 0 3 5; do test -e /proc/$$/fd/$file && echo "file $file is open"; done
echo "$PATH $HOME $LC_ALL ${USER_SECRET-no secret}"
pwd | sed 's,.*/,,'
for word in "$@"; do echo "[$word]"; done
test -x /usr/bin/perl && exec /usr/bin/perl -e 'my $s = alarm(0); print $s >= 295 && $s <= 300 ? "alarm\n" : "alarm after $s\n"; exit 3'
echo alarm
exit 3
EOF2
chmod +x bin/gnuplot
USER_SECRET=x PATH=$work/bin:$PATH NINEBALL_CONFINE=none "$nineball" figure cases/nothing.md -o given --trust >out.txt 2>said 3</dev/null 5</dev/null
test $? -eq 2 && diff -u - said >why <<'EOF2'
processor 120 s, files 409600, memory 4194304, core 0
/usr/bin:/bin /nonexistent C.UTF-8 no secret
given
[-d]
[-e]
[terminal = "svg font 'sans,13' background 'white'"; set terminal svg font 'sans,13' background 'white' size 840,560]
[./nothing.gp]
alarm
nineball: gnuplot refused given/nothing.gp: alarm
EOF2
status=$?
why=why
result $status 'limits, environment and arguments of the program'
# The program is the first one in PATH that is a file that can be executed, or without PATH that of the system. It draws a second time,
# and its messages are not shown again.
mkdir folder plain
mkdir folder/gnuplot
: >plain/gnuplot
cp bin/gnuplot gnuplot
cat >bin/gnuplot <<EOF2
#!/bin/sh
echo "\$3" | tee -a $work/calls >&2
case \$3 in *svg*) echo '<?xml' ;; *) printf '\211PNG' ;; esac
EOF2
PATH=:$work/folder:$work/plain:bin:$PATH NINEBALL_CONFINE=none "$nineball" figure cases/nothing.md -o second --trust >out.txt 2>said
{ cat said calls && cat second/nothing.svg; } | diff -u - /dev/fd/3 >why 3<<'EOF2'
terminal = "svg font 'sans,13' background 'white'"; set terminal svg font 'sans,13' background 'white' size 840,560
terminal = "svg font 'sans,13' background 'white'"; set terminal svg font 'sans,13' background 'white' size 840,560
terminal = "pngcairo font 'sans,11'"; set terminal pngcairo font 'sans,11' size 840,560
<?xml
EOF2
status=$?
result $status 'the program in PATH, and its second call'
mv gnuplot bin/gnuplot
case $(command -v gnuplot) in
/usr/bin/* | /bin/*)
  (unset PATH && "$nineball" figure cases/nothing.md -o unset --trust >out.txt 2>why) && test -s unset/nothing.svg
  result $? 'without PATH'
  ;;
esac
cat >bin/bwrap <<'EOF2'
#!/bin/sh
for word in "$@"; do test "$word" = --version && exit 0; done
exec >&2
for word in "$@"; do echo "$word"; done
exit 3
EOF2
chmod +x bin/bwrap
PATH=$work/bin:$PATH NINEBALL_CONFINE=bwrap "$nineball" figure cases/nothing.md -o given >out.txt 2>said
plots=$(sed -n "s/^plots = '\(.*\)'$/\1/p" given/nothing.gp)
{
  printf '%s\n' --unshare-all --die-with-parent --new-session --cap-drop ALL
  for path in /lib /lib64 /usr/lib /usr/lib64 /usr/local/lib /etc/ld.so.cache /etc/fonts /usr/share/fontconfig /usr/share/fonts \
    /usr/local/share/fonts /usr/share/gnuplot /usr/share/libthai /usr/share/locale /usr/share/pandoc /var/cache/fontconfig \
    "$work/bin/gnuplot" "$plots"; do
    printf '%s\n' --ro-bind-try "$path" "$path"
  done
  printf '%s\n' --ro-bind-try "$work/given/./nothing.gp" /figure/./nothing.gp --chdir /figure -- "$work/bin/gnuplot" -d -e
} >wanted
sed '/^terminal = /,$d' said | diff -u wanted - >why
result $? 'the folders that bubblewrap binds'
rm bin/bwrap
PATH=$work/bin NINEBALL_CONFINE=bwrap "$nineball" figure cases/nothing.md -o given >out.txt 2>said
test $? -eq 2 && grep -qxF "nineball: gnuplot cannot be confined here (Landlock: not requested; bwrap: not installed (its package is bubblewrap)), and the page's gnuplot block could do whatever you can; if you trust the page, give --trust" said
status=$?
cp said why
result $status 'without bubblewrap: the whole message'
printf '#!/bin/sh\nexit 1\n' >bin/bwrap
chmod +x bin/bwrap
PATH=$work/bin NINEBALL_CONFINE=bwrap "$nineball" figure cases/nothing.md -o given >out.txt 2>said
test $? -eq 2 && grep -qF '(Landlock: not requested; bwrap: it cannot make a namespace here), and' said
status=$?
cp said why
result $status 'bubblewrap that does not work: the message'
PATH=$work/bin:$PATH NINEBALL_CONFINE=none "$nineball" figure cases/nothing.md -o given >out.txt 2>said
test $? -eq 2 && grep -qF '(Landlock: not requested; bwrap: not requested), and' said
status=$?
cp said why
result $status 'no confinement: the message'
# A program that a signal ends; bubblewrap would exit with 128 and the number of the signal. 15 is SIGTERM.
mkdir -p folder
for end in 'kill -TERM $$' 'exit 143'; do
  printf '#!/bin/sh\n%s\n' "$end" >bin/gnuplot
  PATH=$work/bin:$PATH NINEBALL_CONFINE=none "$nineball" figure cases/nothing.md -o folder --trust >out.txt 2>said
  test $? -eq 2 && test ! -s out.txt && echo 'nineball: gnuplot was stopped while it read folder/nothing.gp: Terminated' | diff - said >why
  result $? "a program that ends by $end"
done
printf '#!/bin/sh\necho no >&2\nexit 128\n' >bin/gnuplot
PATH=$work/bin:$PATH NINEBALL_CONFINE=none "$nineball" figure cases/nothing.md -o folder --trust >out.txt 2>said
test $? -eq 2 && printf 'no\nnineball: gnuplot refused folder/nothing.gp: no\n' | diff - said >why
result $? 'a program that ends with the status 128'
# With --checkpoint the first signal waits for the figure, and the second one ends the process.
printf '#!/bin/sh\n: >%s/started\nexec sleep 5\n' "$work" >bin/gnuplot
PATH=$work/bin:$PATH NINEBALL_CONFINE=none "$nineball" figure cases/nothing.md -o folder --trust --checkpoint --states states >out.txt 2>why &
while kill -0 $! && test ! -e started; do sleep 0.01; done
while kill -INT $! 2>/dev/null; do sleep 0.2; done
wait $!
test $? -eq 130 && test ! -s why
result $? 'a second signal ends the process'
echo "1..$n"
