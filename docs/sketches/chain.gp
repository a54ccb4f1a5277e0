# A row of five discs between two walls; dashed where each is at rest.
eval canvas(-0.9, 10.9, -2.1, 1.75)
eval wall(0, 1.3, 0, -1.3)
eval wall(10, -1.3, 10, 1.3)
array u[5] = [0.16, 0.28, 0.16, -0.14, -0.22]
do for [l = 1:5] { eval disc(2 * l - 1 + u[l], 0, 0.97) }
do for [l = 1:5] {
  eval dashed(2 * l - 1, -1.45, 2 * l - 1, 1.1)
  eval dot(2 * l - 1 + u[l], 0)
  eval arrow(2 * l - 1, -1.25, 2 * l - 1 + 4 * u[l], -1.25, blue)
  eval coloured(2 * l - 1 + 2 * u[l], -1.62, sub('u', sprintf('%d', l)), blue)
}
