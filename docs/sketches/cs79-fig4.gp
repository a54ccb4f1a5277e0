# CS79 figure 4: a disc and a wall that moves and turns.
eval canvas(-3.5, 3.5, -1.2, 2.35)
b = 12.; c = cos(b * pi / 180); s = sin(b * pi / 180)
Q = 0.75                                        # of the nearest point, along the wall from P
h = 0.92                                        # distance of the disc
fill = pale
eval disc(Q * c - h * s, Q * s + h * c, 1.15)
eval thin(-3 * c, -3 * s, 3 * c, 3 * s, black, 1.8, 'nohead dt solid')
eval dot(-1.2 * c, -1.2 * s)
eval label(-1.2 * c + 0.1, -1.2 * s - 0.28, sym('P'))
eval label(-3 * c - 0.05, -3 * s + 0.28, 'A')
eval label(3 * c + 0.05, 3 * s + 0.28, 'B')
eval dot(Q * c, Q * s)
eval label(Q * c + 0.32, Q * s - 0.38, sym('Q'))
eval dot(Q * c - h * s, Q * s + h * c)
eval label(Q * c - h * s - 0.2, Q * s + h * c + 0.15, sym('x'))
eval arrow(Q * c - h * s, Q * s + h * c, Q * c - (h - 0.6) * s, Q * s + (h - 0.6) * c, green)
eval coloured(Q * c - h * s + 0.28, Q * s + h * c - 0.35, '{/:Bold e}', green)
eval arrow(1.75 * c, 1.75 * s, 2.45 * c, 2.45 * s, green)
eval coloured(2.1 * c + 0.1, 2.1 * s - 0.3, '{/:Bold e}_w', green)
eval arrow(-1.2 * c, -1.2 * s, -1.2 * c - 0.2, -1.2 * s + 0.8, blue)
eval coloured(-1.2 * c - 0.5, -1.2 * s + 0.75, '{/:Bold v}_P', blue)
eval turn(-1.2 * c, -1.2 * s, 1.0, 140., 215., blue)
eval coloured(-1.2 * c - 1.22, -1.2 * s + 0.5, sub('ω', 'w'), blue)
