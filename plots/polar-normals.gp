# Polar histogram of contact directions, ten degrees per bin; each contact counts at both of its ends
# [R89 figures 6.15, 6.16, 6.36-6.41]. Before it loads this recipe, the page sets
#
#   contacts = '$rest_contacts'; weight = 'all'    # or 'normal': weighted by the normal force; 'sliding': sliding contacts only;
#                                                  # 'near': those with a shear force of at least 0.99 of its limit
set size ratio -1
unset border
unset tics
unset key
unset grid
# columns of a table of contacts: wall 3, normal force 11, sliding 13, angle 16, obliquity 22; contacts with walls are left out
array bins[36]
do for [i = 1:36] { bins[i] = 0 }
weight_of(w) = column(3) > 0 ? 0 : w eq 'normal' ? column(11) : w eq 'sliding' ? column(13) : w eq 'near' ? column(22) >= 0.99 : 1
bin(a) = int(floor((a + 720) / 10)) % 36 + 1
put(i, w) = (bins[i] = bins[i] + w)
both(a, w) = put(bin(a), w) + put(bin(a + 180), w)
stats @contacts using (both(column(16) * 180 / pi, weight_of(weight)), 0) nooutput
most = 0
do for [i = 1:36] { most = bins[i] > most ? bins[i] : most }
set print $wedges
do for [i = 1:36] {
  print "0\t0"
  do for [k = 0:5] { print sprintf("%.9g\t%.9g", bins[i] * cos((10 * (i - 1) + 2 * k) * pi / 180), bins[i] * sin((10 * (i - 1) + 2 * k) * pi / 180)) }
  print "0\t0"
  print ""
}
unset print
set datafile nocolumnheaders
set xrange [-1.05 * (most > 0 ? most : 1) : 1.05 * (most > 0 ? most : 1)]
set yrange [-1.05 * (most > 0 ? most : 1) : 1.05 * (most > 0 ? most : 1)]
plot $wedges using 1:2 with filledcurves closed fc rgb '#0072b2' fs solid, '+' every ::::0 using (0):(0):(most > 0 ? most : 1) with circles lc rgb '#888888' fs empty
set xrange [*:*]
set yrange [*:*]
set datafile columnheaders
