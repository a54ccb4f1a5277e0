# Mohr's circle of a recorded symmetric tensor, from the last row of a table. X is the face with its normal in x, Y the face with
# its normal in y; the ends of the horizontal diameter are the principal values. The angle of X from the major axis is doubled
# [R89 figure 4.1, 4.52-4.54]. Before it loads this recipe, the page sets
#
#   rows = '$table'; tensor = 'A.stress'; unit = 'Pa'    # columns tensor.xx/unit, .xy, .yx, .yy; fabric: unit = '-'
unset key
eval diagram
set size ratio -1
set autoscale
set offsets 0, 0, 0, 0
stats @rows using (xx = column(tensor.'.xx/'.unit), yy = column(tensor.'.yy/'.unit), xy = (column(tensor.'.xy/'.unit) + column(tensor.'.yx/'.unit)) / 2, 0) nooutput
middle = (xx + yy) / 2; radius = sqrt(((xx - yy) / 2)**2 + xy**2)
set xlabel 'normal component'
set ylabel 'shear component'
plot [middle - 1.6 * radius:middle + 1.6 * radius] [-1.6 * radius:1.6 * radius] '+' every ::::0 using (middle):(0):(radius) with circles lw 1.5 lc rgb '#0072b2', \
     '+' every ::::0 using (xx):(xy):(yy - xx):(-2 * xy) with vectors nohead lw 1.5 lc rgb '#d55e00', \
     '+' every ::::0 using (xx + 0.2 * (xx - middle)):(1.2 * xy):('X') with labels, '+' every ::::0 using (yy + 0.2 * (yy - middle)):(-1.2 * xy):('Y') with labels, \
     '+' every ::::0 using (middle - radius):(0):(2 * radius):(0) with vectors nohead lc rgb '#888888', \
     '+' every ::::0 using (middle + 0.85 * radius):(0.15 * radius):('1') with labels, '+' every ::::0 using (middle - 0.85 * radius):(0.15 * radius):('2') with labels
