# Stress path of a region: half the difference of the principal stresses against their mean, one line per table
# [R89 figure 6.27]. The broken line has the given slope, sin Phi. Before it loads this recipe, the page sets
#
#   tables = '$table'; region = 'A'; unit = 'Pa'; slope = 0.3    # recorded: region.stress.mean and .deviator
unset key
eval diagram
set autoscale
set offsets 0, 0, 0, 0
set xlabel 'mean stress'
set ylabel '(σ_1 - σ_2)/2'
plot [0:*] [0:*] for [k = 1:words(tables)] word(tables, k) using (column(region.'.stress.mean/'.unit)):(column(region.'.stress.deviator/'.unit) / 2) with lines lw 1.5 lt k, \
     slope * x with lines dt 2 lc rgb '#888888'
