# The figures of docs/STABILITY.md: gnuplot -e "folder='docs/stability'; plots='plots'" docs/stability/draw.gp
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
terminal = 'svg'
load plots.'/style.gp'

# A panel for each ks/kn. Bars: stable, inaccurate, unstable; marks: symptoms that are rare.
array systems[6] = ['chain', 'nine-discs', 'random-packing', 'unlike-masses', 'rotation', 'wedge']
array titles[6] = ['Chain: mass ratios 1, 10, 100', 'Nine discs: mass ratios 1, 10, 100', 'Random packing: mass ratios 1, 10, 100', \
  'Unlike masses: mass ratios 100, 10^4, 10^6', 'Rotation on: mass ratios 1, 100; rotation off: the same', 'One disc in a wedge: normals at 20°, 45°, 70° from the vertical']
array ratios[4] = [0, 0.5, 1, 2]
legend = "\n{/=11 green: stable, orange: inaccurate, red: unstable; ◆ bound; symptoms other than the energy: × message, ▲ imbalance, ○ silent}"
green = '#009e73'; orange = '#e69f00'; red = '#d55e00'; blue = '#0072b2'

limit(s, r, value) = strcol('system') eq systems[s] && column('ratio') == ratios[r] ? value : NaN
letter(s) = toupper(substr(strcol('cause'), 1, 1))
toupper(c) = c eq 'n' ? 'N' : c eq 't' ? 'T' : c eq 'r' ? 'R' : 'D'
shown(r, shows) = column('ratio') == ratios[r] && strcol('class') eq 'unstable' && strcol('shows') eq shows ? column('f') : NaN

do for [s = 1:6] {
  points = folder.'/'.systems[s].'.tsv'; limits = folder.'/limits.tsv'
  set terminal svg size 1000,720 font 'sans,12' background rgb 'white'
  set output folder.'/'.systems[s].'.svg'
  set multiplot layout 2,2 title titles[s].legend margins 0.065,0.985,0.09,0.86 spacing 0.06,0.13
  set yrange [-0.25:2.3]
  set ytics 0,0.5,2
  set grid noxtics ytics
  unset xtics
  set xrange [-0.7:*]
  set xlabel offset 0,-0.7
  set ylabel offset 1,0
  do for [r = 1:4] {
    set title sprintf('k_s/k_n = %g', ratios[r]) offset 0,-0.7
    set xlabel (r > 2 ? 'damping ratio of the contacts' : '')
    set ylabel (r % 2 ? 'step / limit' : '')
    unset key
    plot limits using 'place':(limit(s, r, 0)):(0):'accurate' with vectors nohead lw 7 lc rgb green, \
         '' using 'place':(limit(s, r, column('accurate'))):(0):(1 - column('accurate')) with vectors nohead lw 7 lc rgb orange, \
         '' using 'place':(limit(s, r, 1)):(0):(1) with vectors nohead lw 7 lc rgb red, \
         '' using 'place':(limit(s, r, column('bound'))) with points pt 13 ps 0.6 lc rgb blue, \
         points using 'place':(shown(r, 'message')) with points pt 2 ps 0.5 lc rgb 'black', \
         '' using 'place':(shown(r, 'imbalance')) with points pt 9 ps 0.5 lc rgb 'black', \
         '' using 'place':(shown(r, 'silent')) with points pt 6 ps 0.5 lc rgb 'black', \
         limits using 'place':(limit(s, r, 2.13)):(letter(s)) with labels font ',10', \
         '' using 'place':(limit(s, r, -0.12)):(strcol('damping')) with labels font ',9', \
         1 with lines lc rgb 'black'
  }
  unset multiplot
}

reset
load plots.'/style.gp'
set terminal svg size 1000,420 font 'sans,12' background rgb 'white'
set output folder.'/soft.svg'
set xlabel 'step / limit'
set xrange [0.45:1.8]
set logscale y
set arrow from 1, graph 0 to 1, graph 1 nohead dt 2 lc rgb 'black'
set format y '10^{%L}'
soft = folder.'/soft.tsv'
at(d, what) = strcol('system') eq 'nine-discs' && column('damping') == d ? column(what) : NaN
set multiplot layout 1,2
set yrange [1e-4:1e8]
set title 'Nine discs: largest energy.balance / initial energy'
plot soft using 'f':(at(0, 'energy')) with linespoints ls 1 pt 7 title 'damping 0', \
     '' using 'f':(at(0.1, 'energy')) with linespoints ls 2 pt 7 title '0.1', \
     '' using 'f':(at(1, 'energy')) with linespoints ls 3 pt 7 title '1'
set title 'Nine discs: unbalanced.max at the end'
set yrange [1e-17:10]
plot soft using 'f':(at(0, 'imbalance')) with linespoints ls 1 pt 7 title 'damping 0', \
     '' using 'f':(at(0.1, 'imbalance')) with linespoints ls 2 pt 7 title '0.1', \
     '' using 'f':(at(1, 'imbalance')) with linespoints ls 3 pt 7 title '1'
unset multiplot
