#!/bin/sh
# docs/sketches/draw.sh [INTO]: gnuplot draws every sketch, NAME.gp beside this file, as NAME.svg, here or in the folder INTO.
#
# The script removes what depends on the version of gnuplot: definitions that no sketch uses, empty groups, and decimals
# without a visible effect. An outline and the area inside it become one path.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
into=$(cd "${1:-$here}" && pwd)

tidy() {
  awk '
    function value(tag, name,  rest) {      # of an attribute
      if (!match(tag, "[ \n\t]" name " *= *[\"\047]")) return ""
      rest = substr(tag, RSTART + RLENGTH)
      return substr(rest, 1, match(rest, /["\047]/) - 1)
    }
    function round(numbers,  out) {         # to a tenth of a pixel
      while (match(numbers, /-?[0-9]+\.[0-9]+/)) {
        out = out substr(numbers, 1, RSTART - 1) shorter(substr(numbers, RSTART, RLENGTH))
        numbers = substr(numbers, RSTART + RLENGTH)
      }
      return out numbers
    }
    function shorter(number,  s) {
      s = sprintf("%.1f", number + 0); sub(/\.0$/, "", s)
      return s == "-0" ? "0" : s
    }
    function colour(c,  part) {             # rgb(213, 94, 0) as #d55e00
      gsub(/rgb\(|\)| /, "", c)
      if (split(c, part, ",") < 3) return c
      return sprintf("#%02x%02x%02x", part[1], part[2], part[3])
    }
    function flush() {
      if (path != "") printf "<path d=\"%s\" fill=\"%s\"%s/>\n", path, inside, stroke
      path = ""; stroke = ""
    }
    function line(tag,  d, dashes) {
      d = value(tag, "d"); gsub(/[ \n\t]*Z[ \n\t]*$/, "Z", d); gsub(/[ \n\t]+/, " ", d); sub(/ $/, "", d); d = round(d); gsub(/ ?L/, "L", d)
      bare = d; sub(/Z$/, "", bare)
      was = path; sub(/Z$/, "", was)
      if (was != bare) { flush(); inside = "none"; path = d }
      dashes = value(tag, "stroke-dasharray")
      stroke = sprintf(" stroke=\"%s\" stroke-width=\"%s\"%s", colour(value(tag, "stroke")), wide, dashes ? " stroke-dasharray=\"" dashes "\"" : "")
    }
    function area(tag,  d) {
      flush()
      if (value(tag, "fill-opacity") != "" && value(tag, "fill-opacity") + 0 == 0) return
      d = value(tag, "points"); gsub(/^[ \n\t]+|[ \n\t]+$/, "", d); gsub(/[ \n\t]+/, "L", d)
      path = round("M" d) "Z"; inside = colour(value(tag, "fill"))
    }
    BEGIN { RS = "<" }
    /^svg/ {
      width = value($0, "width"); height = value($0, "height")
      printf "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%s\" height=\"%s\" viewBox=\"0 0 %s %s\">\n", width, height, width, height
      printf "<rect width=\"%s\" height=\"%s\" fill=\"white\"/>\n", width, height
      print "<g font-family=\"Times New Roman, Nimbus Roman, Liberation Serif, serif\" font-size=\"17\">"
    }
    /^defs/ { skip = 1 }
    /^\/defs/ { skip = 0; next }
    skip { next }
    /^g / && value($0, "stroke-width") != "" { wide = value($0, "stroke-width") + 0 }
    /^g transform/ { split(round(value($0, "transform")), place, /[(,)]/); ink = colour(value($0, "fill")); anchor = value($0, "text-anchor") }
    /^polygon/ { area($0) }
    /^path/ { line($0) }
    /^text/ {
      flush()
      printf "<text x=\"%s\" y=\"%s\" fill=\"%s\" text-anchor=\"%s\">", place[2], place[3], ink, anchor
      sub(/^text[^>]*>/, ""); gsub(/[\n\t]/, ""); printf "%s", $0; inside_text = 1
    }
    /^tspan/ { gsub(/ *font-family="[^"]*"/, ""); sub(/ +>/, ">"); gsub(/  +/, " "); printf "<%s", $0 }
    /^\/tspan/ { printf "</tspan>%s", substr($0, 8) }
    /^\/text/ { print "</text>" }
    END { flush(); print "</g>\n</svg>" }'
}

for script in "$here"/*.gp; do
  name=$(basename "$script" .gp)
  test "$name" != style || continue
  (cd "$here" && gnuplot -e "load 'style.gp'" -e "load '$name.gp'" -e 'plot NaN notitle') | tidy >"$into/$name.svg-t"
  mv "$into/$name.svg-t" "$into/$name.svg"
done
