# Contact forces of an assembly: a line through each contact from centre to centre, in four widths. The width depends on the
# force over the mean force: up to 0.5, up to 1, up to 2, above 2. Before it loads this recipe, the page sets
#
#   particles = '$rest_particles'; contacts = '$rest_contacts'    # snapshots, named by stage
set size ratio -1
unset border
unset tics
unset grid
unset key
# columns of a table of contacts: x 4, y 5, radii 6 and 7, direction 8 and 9, force 14 and 15
stats @contacts using (sqrt($14**2 + $15**2)) name 'force' nooutput
strong(from, to) = (f = sqrt(column(14)**2 + column(15)**2) / force_mean, f > from && f <= to)
array from[4] = [0, 0.5, 1, 2]
array to[4] = [0.5, 1, 2, 1e9]
array width[4] = [0.3, 0.8, 1.8, 3.5]
# the range of the axes follows from the centres, so the outermost circles need room
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
# the line begins at the centre of the first particle; x, y is the middle of the overlap, which is too small to matter here
plot @particles using 2:3:4 with circles lc rgb '#bbbbbb' lw 0.3 fs empty, \
     for [k = 1:4] @contacts using (strong(from[k], to[k]) ? $4 - $6 * $8 : NaN):($5 - $6 * $9):(($6 + $7) * $8):(($6 + $7) * $9) with vectors nohead lw width[k] lc rgb '#0072b2'
set offsets 0, 0, 0, 0
