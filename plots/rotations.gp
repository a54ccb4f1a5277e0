# How far bodies have turned since the reference: orange counterclockwise, blue clockwise, the deepest colour the largest turn.
# The page says before
#
#   bodies = '$rest_bodies'    # of `snapshot from STAGE`
set size ratio -1
unset border
unset tics
unset grid
unset key
unset colorbox
set offsets graph 0.04, graph 0.04, graph 0.04, graph 0.04
set palette defined (-1 '#0072b2', 0 '#ffffff', 1 '#d55e00')
stats @bodies using (abs(column('turned/rad'))) name 'turned' nooutput
set cbrange [-turned_max:turned_max]
plot @bodies using 2:3:4:(column('turned/rad')) with circles lc palette fs solid border lc rgb '#444444'
