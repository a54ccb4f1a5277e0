# Contact forces of an assembly: a line through each contact from centre to centre, in four widths, by its force over the mean one: to a half, to
# one, to two, beyond. The page says before
#
#   bodies = '$rest_bodies'; contacts = '$rest_contacts'    # snapshots, by the name of their stage
set size ratio -1
unset border
unset tics
unset grid
unset key
stats @contacts using (sqrt(column('fx/N')**2 + column('fy/N')**2)) name 'force' nooutput
strong(from, to) = (f = sqrt(column('fx/N')**2 + column('fy/N')**2) / force_mean, f > from && f <= to)
array from[4] = [0, 0.5, 1, 2]
array to[4] = [0.5, 1, 2, 1e9]
array width[4] = [0.3, 0.8, 1.8, 3.5]
# between the two outlines is x, y: half an overlap, which no one sees, beside the end of the radius
plot @bodies using 'x/m':'y/m':'radius/m' with circles lc rgb '#bbbbbb' lw 0.3 fs empty, \
     for [k = 1:4] @contacts using (strong(from[k], to[k]) ? column('x/m') - column('ra/m') * column('ex/-') : NaN):(column('y/m') - column('ra/m') * column('ey/-')):((column('ra/m') + column('rb/m')) * column('ex/-')):((column('ra/m') + column('rb/m')) * column('ey/-')) with vectors nohead lw width[k] lc rgb '#0072b2'
