# The look of all sketches, and the shapes they are made of. Lengths are those of the canvas; `px` is the length of one pixel.
# A shape is a function that returns commands: eval disc(0, 0, 1). draw.sh draws all sketches.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set encoding utf8
unset border; unset tics; unset key
set margins 0, 0, 0, 0

# Okabe and Ito, as in plots/style.gp.
black = '#222222'; grey = '#666666'; blue = '#0072b2'; red = '#d55e00'; green = '#009e73'; purple = '#cc79a7'
pale = '#e3eef6'; darker = '#c3d9ea'
fill = pale
corners = 48                                   # of the polygon that stands for a circle

# The part of the plane that is drawn, 400 pixels wide.
canvas(x0, x1, y0, y1) = sprintf('px = %g; set terminal svg size 400,%d enhanced font "serif,17"; set xrange [%g:%g]; set yrange [%g:%g]', \
  (x1 - x0) / 400., int((y1 - y0) * 400. / (x1 - x0) + 0.5), x0, x1, y0, y1)

# Points of an arc about (x, y) from angle a to angle b, degrees.
at(x, y, r, a) = sprintf('%.4f,%.4f', x + r * cos(a * pi / 180), y + r * sin(a * pi / 180))
points(x, y, r, a, b, n) = n == 0 ? at(x, y, r, a) : at(x, y, r, a).' to '.points(x, y, r, a + (b - a) / real(n), b, n - 1)

ring(x, y, r, n) = points(x, y, r, 0, 360 - 360. / n, n - 1).' to '.at(x, y, r, 0)
polygon(outline, colour, wide, inside) = 'set object polygon from '.outline. \
  (inside eq '' ? ' fc rgb "white" fs transparent solid 0' : ' fc rgb "'.inside.'" fs solid').sprintf(' border rgb "%s" lw %g', colour, wide)
disc(x, y, r) = polygon(ring(x, y, r, corners), black, 1.2, fill)
circle(x, y, r, colour) = polygon(ring(x, y, r, corners), colour, 1.2, '')
dot(x, y) = polygon(ring(x, y, 2.2 * px, 12), black, 0.5, black)

thin(x0, y0, x1, y1, colour, wide, more) = \
  sprintf('set arrow from %.4f,%.4f to %.4f,%.4f %s lc rgb "%s" lw %g', x0, y0, x1, y1, more, colour, wide)
line(x0, y0, x1, y1) = thin(x0, y0, x1, y1, grey, 1, 'nohead dt solid')
# Thinner than a line: gnuplot makes one path of what has one colour and one width, dashed or not.
dashed(x0, y0, x1, y1) = thin(x0, y0, x1, y1, grey, 0.9, 'nohead dt (10,7)')
arrow(x0, y0, x1, y1, colour) = thin(x0, y0, x1, y1, colour, 1.6, sprintf('head filled size %g,20 dt solid', 10 * px))
# A length that is given: an arrowhead at each end.
dimension(x0, y0, x1, y1) = thin(x0, y0, x1, y1, grey, 1, sprintf('heads filled size %g,18 dt solid', 7 * px))

# An arc, and one that ends in an arrowhead. The arc goes there and back, since gnuplot closes polygons.
arc(x, y, r, a, b, colour) = polygon(points(x, y, r, a, b, 16).' to '.points(x, y, r, b, a, 16), colour, 1.3, '')
turn(x, y, r, a, b, colour) = arc(x, y, r, a, b, colour).'; '. \
  arrow(x + r * cos(head(r, a, b)), y + r * sin(head(r, a, b)), x + r * cos(b * pi / 180), y + r * sin(b * pi / 180), colour)
head(r, a, b) = b * pi / 180 - sgn(b - a) * 11 * px / r

# A wall, hatched on the right of one who walks from its first end to the second.
hatch(x, y, dx, dy, n) = n == 0 ? '' : line(x, y, x + (dy - dx) * 8 * px, y - (dx + dy) * 8 * px).'; '. \
  hatch(x + dx * 9 * px, y + dy * 9 * px, dx, dy, n - 1)
along(x0, y0, x1, y1, long) = hatch(x0 + (x1 - x0) / long * 7 * px, y0 + (y1 - y0) / long * 7 * px, (x1 - x0) / long, \
  (y1 - y0) / long, int((long / px - 7) / 9. + 1))
wall(x0, y0, x1, y1) = along(x0, y0, x1, y1, sqrt((x1 - x0)**2 + (y1 - y0)**2)).thin(x0, y0, x1, y1, black, 1.8, 'nohead dt solid')

# What two circles about (x, y) and (X, Y) both enclose, angle a being that from the first centre to the second.
lens(x, y, r, X, Y, R, a) = overlap(x, y, r, X, Y, R, a, sqrt((X - x)**2 + (Y - y)**2))
overlap(x, y, r, X, Y, R, a, d) = polygon(between(x, y, r, X, Y, R, a, half(r, R, d), half(R, r, d)), black, 1.2, darker)
half(r, R, d) = acos((r**2 + d**2 - R**2) / (2 * r * d)) * 180 / pi
between(x, y, r, X, Y, R, a, h, H) = points(x, y, r, a - h, a + h, 24).' to '.points(X, Y, R, a + 180 - H, a + 180 + H, 24).' to '.at(x, y, r, a - h)

text(x, y, words, colour, where) = sprintf('set label "%s" at %.4f,%.4f %s tc rgb "%s" front', words, x, y, where, colour)
label(x, y, words) = text(x, y, words, black, 'center')
left(x, y, words) = text(x, y, words, black, 'left')
right(x, y, words) = text(x, y, words, black, 'right')
coloured(x, y, words, colour) = text(x, y, words, colour, 'center')
# A symbol, and one with an index.
sym(a) = '{/:Italic '.a.'}'
sub(a, b) = sym(a).'_{'.b.'}'
