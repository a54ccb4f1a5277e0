# Figure of ways.txt: `gnuplot ways.gp` in this folder writes ways.svg.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set terminal svg size 1350,420 enhanced font 'serif,14' background '#ffffff'
set output 'ways.svg'
set encoding utf8
set datafile separator "\t"
set multiplot layout 1,3
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
kinds = 'contact-double both-double mass-best mass-strong local-0.5 local-0.7 local-0.8'
plot for [k = 1:7] sprintf("< grep '^%s	' local-discs.tsv", word(kinds, k)) using 6:5 \
       with linespoints lw 2 dt 1 + (k < 5) lt k pt 4 + k title word(kinds, k)
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
unset multiplot
