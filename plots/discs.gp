# Particles coloured by their radius, several assemblies side by side from left to right. Before it loads this recipe, the page sets
#
#   assemblies = '$look_particles_1 $look_particles_2'    # snapshots of particles, named by stage and run
#   aside = 0.05                                    # distance of the origins of two neighbours, in units of length
set size ratio -1
unset border
unset tics
unset grid
unset key
unset colorbox
set offsets graph 0.02, graph 0.02, graph 0.03, graph 0.03 # the automatic range covers the centres, not the radii
set palette defined (0 '#dceaf4', 0.5 '#56b4e9', 1 '#00507d')
plot for [k = 1:words(assemblies)] word(assemblies, k) using (column(2) + (k - 1) * aside):3:4:4 with circles lc palette fs solid noborder, \
     for [k = 1:words(assemblies)] word(assemblies, k) using (column(2) + (k - 1) * aside):3:4 with circles lc rgb '#444444' lw 0.3 fs empty
