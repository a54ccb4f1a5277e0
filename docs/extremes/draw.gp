# The figure of docs/EXTREMES.md: gnuplot -e "folder='docs/extremes'; plots='plots'" docs/extremes/draw.gp
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
terminal = 'svg'
load plots.'/style.gp'

set terminal svg size 900,560 font 'sans,12' background rgb 'white'
set output folder.'/endurance.svg'
set title 'Drift against the number of cycles'
set xlabel 'cycles'
set ylabel 'drift'
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
set xrange [1e3:1e9]
set yrange [1e-18:1]
set key outside right center vertical
eps = 2.2e-16
table = folder.'/endurance.tsv'
plot eps*sqrt(x) with lines dt 2 lw 1.5 lc rgb 'black' title 'ε √N', \
     eps*x with lines dt 3 lw 1.5 lc rgb 'black' title 'ε N', \
     for [k=2:7] table using 1:(abs(column(k))) with lines lw 1.5 lt k - 1 title columnheader(k)
