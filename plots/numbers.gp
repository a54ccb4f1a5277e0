# Particles with their numbers, on a grid of boxes, and the polygon of the boundary, as the program BALL plots them
# [R89 sec. 4.2]. Before it loads this recipe, the page sets
#
#   particles = '$rest_particles'
#   box = 3                              # side of the boxes, in units of length; 0: no boxes
#   boundary = '$rest_boundary'          # '': no boundary
set size ratio -1
unset border
unset tics
unset grid
unset key
stats @particles using 2:3 name 'centre' nooutput
stats @particles using 4 name 'radius' nooutput
low(x) = box > 0 ? box*floor((x - radius_max)/box) : x - radius_max
high(x) = box > 0 ? box*ceil((x + radius_max)/box) : x + radius_max
set xrange [low(centre_min_x):high(centre_max_x)]
set yrange [low(centre_min_y):high(centre_max_y)]
unset arrow
if (box > 0) {
  do for [k = floor(low(centre_min_x)/box + 0.5):floor(high(centre_max_x)/box + 0.5)] {
    set arrow from k*box, low(centre_min_y) to k*box, high(centre_max_y) nohead lw 0.7 lc rgb '#bbbbbb' back
  }
  do for [k = floor(low(centre_min_y)/box + 0.5):floor(high(centre_max_y)/box + 0.5)] {
    set arrow from low(centre_min_x), k*box to high(centre_max_x), k*box nohead lw 0.7 lc rgb '#bbbbbb' back
  }
}
if (boundary ne '') {
  # The last side joins the last particle of the boundary to the first one.
  stats @boundary using (column(0) == 0 ? (first_x = $2, first_y = $3, 0) : (last_x = $2, last_y = $3, 0)) nooutput
  set arrow from last_x, last_y to first_x, first_y nohead lw 2 lc rgb '#d55e00' front
}
outline = boundary eq '' ? particles : boundary
shown = boundary eq '' ? NaN : 0
plot @particles using 2:3:4 with circles lc rgb '#444444' lw 1 fs empty, \
     @particles using 2:3:(sprintf('%d', $1)) with labels font ',9', \
     @outline using ($2 + shown):3 with lines lc rgb '#d55e00' lw 2
