# Force polygons: the contact forces on a particle, head to tail, in the order of the contacts around the particle, drawn at
# its centre [R89 sec. 4.1]. The polygon of a particle in equilibrium closes; a gap is drawn in orange. Before it loads this
# recipe, the page sets
#
#   particles = '$rest_particles'; contacts = '$rest_contacts'; longest = 0.0004    # longest side, in units of length
#   chosen(x, y) = 1                                                          # true where polygons are drawn
set size ratio -1
unset border
unset tics
unset grid
unset key
set offsets graph 0.08, graph 0.08, graph 0.08, graph 0.08
# columns of a table of contacts: particles 1 and 2, force on the first 14 and 15, direction to the second 16
stats @contacts using (sqrt($14**2 + $15**2)) name 'force' nooutput
stats @particles using 1 name 'particle' nooutput
array sides[int(particle_max)]
do for [i = 1:|sides|] { sides[i] = '' }
side(i, angle, fx, fy) = i > 0 ? (sides[i] = sides[i] . sprintf(' %.6f %.9g %.9g', angle - 2 * pi * floor(angle / 2 / pi), fx, fy)) : ''
stats @contacts using (side(int($1), $16, $14, $15), side(int($2), $16 + pi, -$14, -$15), 0) nooutput
number(i, k) = real(word(sides[i], k))
array at_x[|sides|]
array at_y[|sides|]
stats @particles using (at_x[int($1)] = $2, at_y[int($1)] = $3, 0) nooutput
set print $polygons
do for [i = 1:|sides|] {
  if (words(sides[i]) >= 6 && chosen(at_x[i], at_y[i])) {
    m = words(sides[i]) / 3
    array px[m + 1]
    array py[m + 1]
    px[1] = 0; py[1] = 0; last = -1; mx = 0; my = 0
    do for [k = 1:m] {
      next = 1; best = 7
      do for [j = 1:m] { if (number(i, 3 * j - 2) > last && number(i, 3 * j - 2) < best) { best = number(i, 3 * j - 2); next = j } }
      last = best
      px[k + 1] = px[k] + number(i, 3 * next - 1) / force_max * longest; mx = mx + px[k + 1] / m
      py[k + 1] = py[k] + number(i, 3 * next) / force_max * longest; my = my + py[k + 1] / m
    }
    do for [k = 1:m + 1] { print sprintf("%.9g\t%.9g\t%.9g\t%.9g", at_x[i] + px[k] - mx, at_y[i] + py[k] - my, k > m ? px[1] - px[k] : 0, k > m ? py[1] - py[k] : 0) }
    print ""
  }
}
unset print
set datafile nocolumnheaders
plot @particles every ::1 using 2:3:4 with circles lc rgb '#cccccc' fs empty, \
     $polygons using 1:2 with lines lw 1.2 lc rgb '#0072b2', \
     $polygons using 1:2:3:4 with vectors nohead lw 2.5 lc rgb '#d55e00'
set datafile columnheaders
