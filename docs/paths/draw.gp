# The figure of docs/PATHS.md: gnuplot -e "folder='docs/paths'; plots='plots'" docs/paths/draw.gp
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
terminal = 'svg'
load plots.'/style.gp'

set terminal svg size 800,500 font 'sans,12' background rgb 'white'
set output folder.'/memory.svg'
set title 'Largest error of the shear force of the exact law'
set xlabel 'memory, pieces'
set ylabel 'error of T / μN'
set logscale xy
set format y '10^{%L}'
set xrange [7:75]
set yrange [1e-7:1]
set xtics (8, 16, 32, 64)
set key outside right top vertical Left reverse
table = folder.'/memory.tsv'
paths = 'walk impact ringing both ratchet rolling bounce sheared'
plot for [p = 1:words(paths)] table using (strcol('path') eq word(paths, p) && column('memory') < 100 ? column('memory') : NaN):'worst' \
  with linespoints lc p pt p + 3 title word(paths, p)
