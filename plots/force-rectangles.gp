# Contact forces as Cundall and Strack draw them [CS79 figure 5b, section Units]: a rectangle through each contact along its
# force. Its length is the sum of the two radii, its width is proportional to the force. Before it loads this recipe, the page sets
#
#   particles = '$rest_particles'; walls = '$rest_walls'; contacts = '$rest_contacts'    # snapshots, named by stage
#   widest = 20                                                                    # largest width, in units of length
set size ratio -1
unset border
unset tics
unset grid
unset key
# columns of a table of contacts: x 4, y 5, radii 6 and 7, force 14 and 15
force(c) = sqrt(column(14)**2 + column(15)**2)
along_x(c) = column(14) / force(c) * (column(6) + column(7)) / 2
along_y(c) = column(15) / force(c) * (column(6) + column(7)) / 2
stats @contacts using (force(0)) name 'force' nooutput
across_x(c) = -column(15) / force_max * widest / 2
across_y(c) =  column(14) / force_max * widest / 2
corner(c, a, b) = sprintf("%.9g\t%.9g\n", column(4) + a * along_x(c) + b * across_x(c), column(5) + a * along_y(c) + b * across_y(c))
array outline[force_records]
stats @contacts using (outline[int($0) + 1] = corner(0, 1, 1) . corner(0, 1, -1) . corner(0, -1, -1) . corner(0, -1, 1) . corner(0, 1, 1), 0) nooutput
set print $rectangles
do for [i = 1:force_records] {
  print outline[i]
  print ""
}
unset print
set datafile nocolumnheaders
plot $rectangles using 1:2 with filledcurves closed fc rgb '#0072b2' fs solid, \
     @particles every ::1 using 2:3:4 with circles lc rgb '#888888' fs empty, \
     @walls every ::1 using 2:3:($4-$2):($5-$3) with vectors nohead lw 2 lc rgb 'black'
set datafile columnheaders
