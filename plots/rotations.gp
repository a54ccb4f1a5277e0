# Rotation of particles since the reference configuration [R89 sec. 4.1, sec. 4.2]. Before it loads this recipe, the page sets
#
#   particles = '$rest_particles'    # of `snapshot from STAGE`
#   turns = 'size'             # orange counterclockwise, blue clockwise; the deepest colour is the largest rotation
#   turns = 'direction'        # the two colours only
#   turns = 'vector'; longest = 0.001    # arrows: up if counterclockwise, down if clockwise; longest: of the longest arrow, in
#                                        # units of length
set size ratio -1
unset border
unset tics
unset grid
unset key
unset colorbox
set offsets graph 0.08, graph 0.08, graph 0.08, graph 0.08
set palette defined (-1 '#0072b2', 0 '#ffffff', 1 '#d55e00')
# columns of a table of particles: x 2, y 3, radius 4, turned 16
stats @particles using (abs($16)) name 'turned' nooutput
fraction(c) = turned_max > 0 ? column(16) / turned_max : 0
shade(c) = turns eq 'size' ? fraction(c) : turns eq 'direction' ? sgn(fraction(c)) : 0
set cbrange [-1:1]
plot @particles using 2:3:4:(shade(0)) with circles lc palette fs solid border lc rgb '#444444', \
     @particles using 2:3:(0):(turns eq 'vector' ? fraction(0) * longest : NaN) with vectors head filled size graph 0.02,20 lw 1.5 lc rgb '#0072b2'
