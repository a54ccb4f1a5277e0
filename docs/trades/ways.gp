# Figure of ways.sh: `gnuplot -c ways.gp FILE.svg` in this folder; docs/trades.sh calls it.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set terminal svg size 1350,860 enhanced font 'serif,14' background '#ffffff'
set output ARG1
set encoding utf8
set datafile separator "\t"
set multiplot layout 2,3
set bmargin 7
set xlabel offset 0,0.7
set logscale xy
set format xy '10^{%L}'
set title 'Late (dashed) and centred dashpots'
set xlabel 'updates'
set ylabel 'estimated error'
set key bmargin center horizontal maxrows 4 font ',11'
array page[3] = ['hertz-damped	beta=0.4	impact.restitution', 'damping-walls	beta=0.3	A.vy', 'many-bounces	kn=1e6	D.y in up1']
array name[3] = ['restitution, Hertz', 'rebound, linear', 'height after bounces']
rows(k, timing) = sprintf("< grep '^%s	0.1%%	%s' centred-dashpots.tsv", page[k], timing)
plot for [k = 1:3] rows(k, 'late') using 7:8 with linespoints lw 2 dt 2 lt k pt 4 + k notitle, \
     for [k = 1:3] rows(k, 'centred') using 7:8 with linespoints lw 2 lt k pt 4 + k title name[k]
set title 'Nine discs: cycles to rest'
set xlabel 'cycles after the walls stop'
set ylabel 'unbalanced.max'
unset logscale x
set format x '%g'
set xrange [0:*]
set yrange [5e-6:2e-2]
array kind[7] = ['dashpots', 'dashpots and mass', 'mass 12', 'mass 25', 'local 0.5', 'local 0.7', 'local 0.8']
kinds = 'contact-double both-double mass-best mass-strong local-0.5 local-0.7 local-0.8'
plot for [k = 1:7] sprintf("< grep '^%s	' local-discs.tsv", word(kinds, k)) using 6:5 \
       with linespoints lw 2 dt 1 + (k < 5) lt k pt 4 + k title kind[k]
set title 'Hertz impact: Hertz (dashed), linear springs'
set xlabel 'updates'
set ylabel 'estimated error'
set logscale x
set format x '10^{%L}'
set xrange [100:1e4]
set yrange [1e-4:1]
array result[3] = ['impact.duration', 'C.normal max in strike', 'C.overlap max in strike']
array title[3] = ['duration', 'largest force', 'largest overlap']
tried(k, law) = sprintf("< grep '^%s	.*	%s	' linear-springs.tsv | sort -u -t'	' -k5,5n", result[k], law)
plot for [k = 1:3] tried(k, 'hertz') using 5:6 with linespoints lw 2 dt 2 lt k pt 4 + k notitle, \
     for [k = 1:3] tried(k, 'linear') using 5:6 with linespoints lw 2 lt k pt 4 + k title title[k]
# One point for each number of cycles: means over the realizations.
set title 'Shear test: one density (dashed), density scaling'
set xlabel 'cycles'
set ylabel 'unbalanced force over contact force'
set xrange [1e3:1e5]
set yrange [2e-4:2e-2]
mean(power) = sprintf("< grep -v '^#' density.tsv | awk -F '\t' '$1 == \"%d\" { n[$2]++; c[$2] += $5 - $4; u[$2] += $10 } END { for (k = 1; k <= 16; k *= 4) print c[k]/n[k] \"\t\" u[k]/n[k] }'", power)
plot mean(0) using 1:2 with linespoints lw 2 dt 2 lt 1 pt 5 notitle, mean(2) using 1:2 with linespoints lw 2 lt 1 pt 5 title 'density proportional to r^{-2}, three speeds'
set title 'Steps of a preparation and a shear test'
set xlabel 'cycles'
set ylabel 'sin Φ during the shear'
unset logscale
set format xy '%g'
set xrange [0:8e5]
set xtics 2e5
set yrange [0.25:0.43]
plan(k) = word('one hand bound', k)
array step[3] = ['one step', 'two steps by hand', 'from the stable bound']
plot for [k = 1:3] sprintf("< grep '^%s	' stage-step.tsv", plan(k)) using 3:6 with points lw 2 lt k pt 4 + k title step[k]
set title 'Preparation with and without relaxation'
set xlabel 'cycles and evaluations until 100 kPa at rest'
set ylabel 'sin Φ at 0.25 %'
set logscale x
set format x '10^{%L}'
set xtics autofreq
set mxtics 10
set xrange [1e4:1e7]
set yrange [0.28:0.42]
plot for [k = 1:2] sprintf("< grep '^relaxed	%s	' relaxation.tsv", word('uniform graded', k)) using 4:12 with points lw 2 lt k pt 4 + k title word('Uniform Graded', k) . ', relaxed', \
     for [k = 1:2] sprintf("< grep '^ordinary	%s	' relaxation.tsv", word('uniform graded', k)) using 4:12 with points lw 2 lt k + 2 pt 6 + k title word('Uniform Graded', k)
unset multiplot
