# Histogram of a quantity of contacts, for several snapshots. Before it loads this recipe, the page sets
#
#   tables = '$rest_contacts $shear_contacts'; names = 'before after'    # one step line each
#   of(c) = column('shear/N') / column('limit/N'); low = -1; high = 1; bins = 20
#   curve(v) = NaN    # or a function to draw with the histogram
#
# `of` selects the quantity: obliquity, with the sliding contacts in the first and last bin [R89 figures 6.18-6.20], or mean
# normal contact stress [R89 figures 6.42, 6.43]. Values outside `low` to `high` are counted in the first and last bin.
eval diagram
set autoscale
set ylabel 'contacts'
bin(v) = v < low ? 1 : v >= high ? bins : int(1.0 * (v - low) / (high - low) * bins) + 1
array count[bins]
put(v) = v == v ? (count[bin(v)] = count[bin(v)] + 1) : 0
set print $histogram
do for [k = 1:words(tables)] {
  do for [i = 1:bins] { count[i] = 0 }
  stats word(tables, k) using (put(of(0)), 0) nooutput
  print sprintf("%.9g\t0", low)
  do for [i = 1:bins] { print sprintf("%.9g\t%d", low + (i - 1.0) * (high - low) / bins, count[i]) }
  print sprintf("%.9g\t0", high)
  print ""
  print ""
}
unset print
set datafile nocolumnheaders
plot [low:high] [0:*] for [k = 1:words(tables)] $histogram index k - 1 using 1:2 with steps lw 2 lt k title word(names, k), curve(x) with lines lw 1.5 dt 2 lc rgb '#888888' notitle
set datafile columnheaders
