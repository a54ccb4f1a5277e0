# A square and a hexagonal lattice of equal discs, each in a periodic cell.
eval canvas(-5.4, 5.4, -2.3, 2.9)
h = sqrt(3) / 2
eval 'corners = 30'
do for [i = 0:3] { do for [j = 0:3] { eval disc(-4.5 + i, -1.5 + j, 0.5) } }
do for [j = 0:3] { do for [i = 0:3] { eval disc(1 + i + (j % 2) * 0.5, (j - 1.5) * h, 0.5) } }
eval dashed(-5, -2, -1, -2); eval dashed(-1, -2, -1, 2); eval dashed(-1, 2, -5, 2); eval dashed(-5, 2, -5, -2)
eval dashed(0.5, -2 * h, 4.5, -2 * h); eval dashed(4.5, -2 * h, 4.5, 2 * h); eval dashed(4.5, 2 * h, 0.5, 2 * h); eval dashed(0.5, 2 * h, 0.5, -2 * h)
eval dimension(-3.5, 2.25, -2.5, 2.25)
eval line(-3.5, 1.5, -3.5, 2.4); eval line(-2.5, 1.5, -2.5, 2.4)
eval label(-3, 2.52, sym('s'))
