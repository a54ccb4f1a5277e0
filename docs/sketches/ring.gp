# A ring of boundary particles around an inner one; the polygon through their centres follows a strain rate.
eval canvas(-3.4, 3.4, -3.0, 3.0)
do for [k = 0:5] { eval disc(1.5 * cos(k * pi / 3), 1.5 * sin(k * pi / 3), 0.75) }
fill = darker
eval disc(0, 0, 0.75)
do for [k = 0:5] {
  eval dashed(1.5 * cos(k * pi / 3), 1.5 * sin(k * pi / 3), 1.5 * cos((k + 1) * pi / 3), 1.5 * sin((k + 1) * pi / 3))
  eval dot(1.5 * cos(k * pi / 3), 1.5 * sin(k * pi / 3))
}
eval arrow(2.4, 0, 3.1, 0, blue)
eval arrow(-2.4, 0, -3.1, 0, blue)
eval arrow(0, 2.85, 0, 2.2, blue)
eval arrow(0, -2.85, 0, -2.2, blue)
eval coloured(2.85, 0.3, sub('ε', 'xx'), blue)
eval coloured(0.4, 2.6, sub('ε', 'yy'), blue)
