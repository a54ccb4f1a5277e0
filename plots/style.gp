# The style of all figures. The colours can be distinguished by colour-blind readers (Okabe and Ito).
set datafile separator tab
set datafile columnheaders
set encoding utf8
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#dddddd'
set key noenhanced tmargin left horizontal Left reverse samplen 2
set style line 1 lc rgb '#0072b2' lw 2
set style line 2 lc rgb '#d55e00' lw 2
set style line 3 lc rgb '#009e73' lw 2
set style line 4 lc rgb '#cc79a7' lw 2
set style line 5 lc rgb '#e69f00' lw 2
set style line 6 lc rgb '#56b4e9' lw 2
set linetype 1 lc rgb '#0072b2'
set linetype 2 lc rgb '#d55e00'
set linetype 3 lc rgb '#009e73'
set linetype 4 lc rgb '#cc79a7'
set linetype 5 lc rgb '#e69f00'
set linetype 6 lc rgb '#56b4e9'
set linetype cycle 6
# For another size of the figure a page calls eval canvas(1100, 760).
if (!exists('terminal')) terminal = GPVAL_TERM
canvas(wide, high) = sprintf('set terminal %s size %d,%d', terminal, wide, high)
# A recipe that draws a diagram begins with eval diagram, because the panel before it may have no axes. Without `set tics`
# before it, `set tics nomirror` would mirror tics that were unset.
diagram = 'set size noratio; set border 3; set tics; set tics nomirror'
