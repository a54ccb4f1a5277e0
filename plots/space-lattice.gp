# Space lattice of an assembly: lines between the centres of particles in contact. Contacts that are new since the reference
# configuration are thick and orange, lost ones dashed and blue [R89 figure 6.35]. Before it loads this recipe, the page sets
#
#   lattice = '$rest_lattice'    # of `snapshot from STAGE`
set size ratio -1
unset border
unset tics
unset grid
unset key
set offsets graph 0.04, graph 0.04, graph 0.04, graph 0.04
line_of(kind, value) = column(8) == kind ? value : NaN
plot @lattice using (line_of(0, $4)):5:($6 - $4):($7 - $5) with vectors nohead lw 0.7 lc rgb '#888888', \
     @lattice using (line_of(-1, $4)):5:($6 - $4):($7 - $5) with vectors nohead lw 2.5 dt (3,2) lc rgb '#0072b2', \
     @lattice using (line_of(1, $4)):5:($6 - $4):($7 - $5) with vectors nohead lw 3.5 lc rgb '#d55e00'
