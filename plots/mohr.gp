# Mohr's circle of a symmetric tensor that was recorded, in the last row of a table: the face to the east is X, that to the north Y; the ends of the
# diameter are the principal values, and X is at twice the angle from the major axis [R89 figure 4.1, 4.52-4.54]. The page says before
#
#   rows = '$table'; tensor = 'A.stress'; unit = 'Pa'    # its columns tensor.xx/unit, .xy, .yx, .yy; fabric: unit = '-'
unset key
set border 3
set tics nomirror
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
