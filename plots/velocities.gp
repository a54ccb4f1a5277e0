# Velocities of particles as arrows from their centres [R89 figure 6.31]. Before it loads this recipe, the page sets
#
#   particles = '$rest_particles'; longest = 2    # length of the largest arrow, in units of length
set size ratio -1
unset border
unset tics
unset grid
unset key
set offsets graph 0.08, graph 0.08, graph 0.08, graph 0.08
stats @particles using (sqrt($6**2 + $7**2)) name 'speed' nooutput
plot @particles using 2:3:4 with circles lc rgb '#cccccc' fs empty, \
     @particles using 2:3:(longest * $6 / speed_max):(longest * $7 / speed_max) with vectors head filled size graph 0.02,20 lc rgb '#0072b2'
