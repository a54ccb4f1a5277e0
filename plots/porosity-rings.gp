# Porosity against the distance from the centre of a region with `rings` [R89 figure 6.5]: boxes for the rings, and a line for the
# whole circle within each radius. Before it loads this recipe, the page sets
#
#   rings = '$rest_rings'
set key
eval diagram
set autoscale
set offsets 0, 0, 0, 0
set xlabel 'distance from the centre'
set ylabel 'porosity'
plot [0:*] [0:*] @rings using (($2 + $3) / 2):4:($3 - $2) with boxes fs empty lw 1.5 lt 1 title 'in the ring', @rings using 3:5 with lines lw 2 lt 2 title 'within'
