# An assembly in a periodic cell, the copies of particles at its edges dashed, and the strain rates of the cell.
eval canvas(-3.7, 3.7, -2.8, 2.8)
eval 'corners = 30'
packing = ''                                    # x, y, radius
packing = packing.' 1.19 0.03 0.46 1.20 0.97 0.46 0.39 1.41 0.46 3.88 2.18 0.46 2.99 1.03 0.46 2.10 0.79 0.46 0.50 0.51 0.38'
packing = packing.' 0.71 2.34 0.38 3.08 1.86 0.38 3.80 0.81 0.38 1.25 1.81 0.38 2.67 2.95 0.38 3.62 0.07 0.38 2.36 2.25 0.38'
packing = packing.' 2.00 0.04 0.30 1.73 2.50 0.30 0.27 2.86 0.30 2.46 1.57 0.30 3.63 1.47 0.30 3.21 2.53 0.30 1.86 1.52 0.30'
edge(x, r, l) = x < r ? l : x > l - r ? -l : 0  # how far away the copy is
copy(x, y, r) = r > 0 ? polygon(ring(x - 2, y - 1.5, r, corners), grey, 0.8, 'white') : ''
n = words(packing) / 3
do for [i = 0:n - 1] {
  x = real(word(packing, 3 * i + 1)); y = real(word(packing, 3 * i + 2)); r = real(word(packing, 3 * i + 3))
  a = edge(x, r, 4); b = edge(y, r, 3)
  if (a != 0) { eval copy(x + a, y, r) }
  if (b != 0) { eval copy(x, y + b, r) }
  if (a != 0 && b != 0) { eval copy(x + a, y + b, r) }
}
do for [i = 0:n - 1] { eval disc(real(word(packing, 3 * i + 1)) - 2, real(word(packing, 3 * i + 2)) - 1.5, real(word(packing, 3 * i + 3))) }
eval thin(-2, -1.5, 2, -1.5, black, 1.4, 'nohead dt (6,4)')
eval thin(2, -1.5, 2, 1.5, black, 1.4, 'nohead dt (6,4)')
eval thin(2, 1.5, -2, 1.5, black, 1.4, 'nohead dt (6,4)')
eval thin(-2, 1.5, -2, -1.5, black, 1.4, 'nohead dt (6,4)')
eval arrow(2.9, 0, 3.55, 0, blue)
eval arrow(-2.9, 0, -3.55, 0, blue)
eval arrow(0, 2.6, 0, 2.05, blue)
eval arrow(0, -2.6, 0, -2.05, blue)
eval coloured(3.25, 0.32, sub('ε', 'xx'), blue)
eval coloured(0.4, 2.45, sub('ε', 'yy'), blue)
