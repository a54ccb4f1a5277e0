# The space lattice that is equivalent to an assembly: lines between the centres of bodies that touch; those that are new since
# the reference thick, those that are lost dashed [R89 figure 6.35]. The page says before
#
#   lattice = '$rest_lattice'    # of `snapshot from STAGE`
set size ratio -1
unset border
unset tics
unset grid
unset key
set offsets graph 0.04, graph 0.04, graph 0.04, graph 0.04
line_of(kind, value) = column(8) == kind ? value : NaN
plot @lattice using (line_of(0, $4)):5:($6 - $4):($7 - $5) with vectors nohead lw 1 lc rgb '#444444', \
     @lattice using (line_of(-1, $4)):5:($6 - $4):($7 - $5) with vectors nohead lw 1 dt 2 lc rgb '#999999', \
     @lattice using (line_of(1, $4)):5:($6 - $4):($7 - $5) with vectors nohead lw 4 lc rgb '#d55e00'
