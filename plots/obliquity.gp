# Shear force T against normal force N of each contact, both over the mean normal force, and the friction limit; contacts on
# the line slide [R89 figure 6.19]. Before it loads this recipe, the page sets
#
#   contacts = '$rest_contacts'; friction = 0.3
unset key
eval diagram
set xlabel 'N over mean N'
set ylabel 'T over mean N'
stats @contacts using 11 name 'normal' nooutput
plot [0:*] [0:*] @contacts using ($11 / normal_mean):(abs($12) / normal_mean) with points pt 7 ps 0.5 lc rgb '#0072b2', \
     friction * x with lines lc rgb '#888888'
