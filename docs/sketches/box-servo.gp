# Discs in a box whose walls move until the stresses on them are those that are required.
eval canvas(-6.2, 6.2, -5.0, 5.0)
eval 'corners = 36'
do for [i = 0:3] { do for [j = 0:2] { eval disc(2 * i - 3, 2 * j - 2, 1) } }
eval wall(-4, 3, -4, -3)
eval wall(4, -3, 4, 3)
eval wall(-4, -3, 4, -3)
eval wall(4, 3, -4, 3)
do for [j = -1:1] {
  eval arrow(-5.5, 1.7 * j, -4.45, 1.7 * j, red)
  eval arrow(5.5, 1.7 * j, 4.45, 1.7 * j, red)
}
do for [i = -1:1] {
  eval arrow(2.5 * i, 4.5, 2.5 * i, 3.45, red)
  eval arrow(2.5 * i, -4.5, 2.5 * i, -3.45, red)
}
eval coloured(5.3, 0.8, sub('σ', 'xx'), red)
eval coloured(-5.3, 0.8, sub('σ', 'xx'), red)
eval coloured(0.6, 4.2, sub('σ', 'yy'), red)
eval coloured(0.6, -3.95, sub('σ', 'yy'), red)
