# Sliding displacement of contacts since the reference configuration: a bar along the tangent of each contact [R89 sec. 4.2].
# Before it loads this recipe, the page sets
#
#   particles = '$rest_particles'; contacts = '$rest_contacts'    # of `snapshot from STAGE`
#   longest = 0.001                                               # length of the longest bar, in units of length
set size ratio -1
unset border
unset tics
unset grid
unset key
set offsets graph 0.08, graph 0.08, graph 0.08, graph 0.08
# columns of a table of contacts: x 4, y 5, direction 8 and 9, slid 23
stats @contacts using 23 name 'slid' nooutput
along(c) = slid_max > 0 ? column(c) / slid_max * longest : 0
plot @particles using 2:3:4 with circles lc rgb '#cccccc' fs empty, \
     @contacts using ($4 + $9 * along(23) / 2):($5 - $8 * along(23) / 2):(-$9 * along(23)):($8 * along(23)) with vectors nohead lw 2.5 lc rgb '#d55e00'
