/* The lines `grading` and `fill` that a line of another program means, such as `random discs 200 radius 2 mm porosity 0.2`
 * or `ball generate number 300 radius 0.002 0.003`. Number and sizes of the particles, the place and the porosity are
 * those of the line. What it does not say follows from the box or the cell of the page, and from a solid fraction at which
 * particles can be placed at random. If the place is too small for the particles, a box is enlarged, and a circle or a
 * cell gets fewer particles.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/clean.h"
#include "core/vec.h"
#include "reader.h"

/* Discs placed at random one after the other fill at most 0.547 of an area; up to SOLID a disc needs at
 * most some hundreds of attempts. Above MOST the 1000 attempts of the proposed line may not be enough. */
#define SOLID 0.4
#define MOST 0.45

struct wanted {
  bool spheres, has_porosity;
  double count, porosity;
  double radii[2];              /* m; 0: not given; the second one is 0 if all particles have the same radius */
  char place[2 * NB_NAME_SIZE]; /* `box 0 m 0 m to 1 m 1 m`, `circle …` or `cell`; "": none */
  double area;                  /* of the place, m2; 0: not known */
  bool walls;                   /* the place is the box of the page */
  bool enlarged;                /* the box of the line or of the page is too small, so the place is a larger one */
  double asked;                 /* number of the line, if a circle or the cell has room for fewer; else 0 */
};

/* Which values follow a word. */
enum values { SIZES, DIAMETERS, PLACE, CIRCLE, POROSITY, IGNORED };

static enum values values_after(const char *word, enum values now) {
  static const struct {
    const char *words;
    enum values values;
  } rows[] = {{" radius rad radii r size sizes between from ", SIZES},
              {" diameter diameters diam d ", DIAMETERS},
              {" box cell domain region in within inside x y xlim ylim range-x range-y ", PLACE},
              {" circle ", CIRCLE},
              {" porosity poros n ", POROSITY},
              {" number count N num ", SIZES},
              {" seed attempts tries id group spacing ", IGNORED}};
  char padded[NB_NAME_SIZE + 2];
  snprintf(padded, sizeof padded, " %.60s ", word);
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    if (strstr(rows[k].words, padded))
      return rows[k].values;
  return now;
}

/* Reads the number in token k and its unit, if it is followed by one; *next: the token after them. False: the token is no
 * number. */
static bool read_value(const struct nb_reader *reader, size_t k, double *value, bool *has_unit, size_t *next) {
  struct nb_unit unit = {0};
  const char *const text = reader->tokens[k].text;
  *has_unit = k + 1 < reader->count && nb_unit_read(&unit, reader->tokens[k + 1].text);
  *next = k + 1 + *has_unit;
  return *has_unit ? nb_quantity_read(value, text, reader->tokens[k].computed, &unit) == NB_READ
                   : nb_number_read(value, text, 0) == NB_READ;
}

/* Takes a length of the sizes; the first two are the smallest and the largest radius. */
static void take_radius(struct wanted *wanted, double radius) {
  if (wanted->radii[0] == 0)
    wanted->radii[0] = radius;
  else if (wanted->radii[1] == 0 && radius != wanted->radii[0])
    wanted->radii[1] = radius;
}

/* The four lengths of a box or the three of a circle, as `box 0 m 0 m to 1 m 1 m`. Two programs write both x first:
 * `box -1 1 -1 1`, without `to`. */
static void take_place(struct wanted *wanted, const double *lengths, size_t count, enum values values, bool to,
                       const char *unit) {
  const double *const l = lengths;
  const bool corners = to || count < 4; /* x y to x1 y1, or x x1 y y1 */
  if (values == PLACE && count == 4) {
    const double x = l[0], y = l[corners ? 1 : 2], x1 = l[corners ? 2 : 1], y1 = l[3];
    if (!(x1 > x && y1 > y))
      return;
    wanted->area = (x1 - x) * (y1 - y);
    snprintf(wanted->place, sizeof wanted->place, "box %g%s %g%s to %g%s %g%s", x, unit, y, unit, x1, unit, y1, unit);
  } else if (values == CIRCLE && count == 3 && l[2] > 0) {
    wanted->area = NB_PI * l[2] * l[2];
    snprintf(wanted->place, sizeof wanted->place, "circle %g%s %g%s radius %g%s", l[0], unit, l[1], unit, l[2], unit);
  }
}

/* What the next number of the line means, and the lengths of the line's box or circle that have been read. */
struct reading {
  enum values values, place;
  double lengths[4];
  size_t count;
  bool to; /* the place has corners */
};

static void take_word(struct reading *reading, struct wanted *wanted, const char *word) {
  const enum values after = values_after(word, reading->values);
  reading->to = reading->to || (strcmp(word, "to") == 0 && reading->values == PLACE);
  wanted->spheres = wanted->spheres || strncmp(word, "sphere", 6) == 0;
  if (reading->values != CIRCLE || after != SIZES || reading->count != 2) /* `radius` of the circle */
    reading->values = after;
  if (reading->values == PLACE || reading->values == CIRCLE)
    reading->place = reading->values;
}

static void take_value(struct reading *reading, struct wanted *wanted, double value, bool has_unit) {
  const enum values values = reading->values;
  const bool length = has_unit || value < 1;
  if (values == reading->place && values != SIZES && reading->count < 4)
    reading->lengths[reading->count++] = value;
  else if (values == POROSITY)
    wanted->porosity = value, wanted->has_porosity = value > 0 && value < 1;
  else if (values <= DIAMETERS && length && value > 0)
    take_radius(wanted, values == DIAMETERS ? value / 2 : value);
  else if (values != IGNORED && value >= 2 && value == floor(value) && wanted->count == 0)
    wanted->count = value;
}

/* Reads what the tokens of a line say. */
static void read_line(struct wanted *wanted, const struct nb_reader *reader) {
  struct reading reading = {.values = SIZES, .place = SIZES};
  double value;
  bool has_unit;
  for (size_t k = 0, next; k < reader->count; k = next)
    if (read_value(reader, k, &value, &has_unit, &next))
      take_value(&reading, wanted, value, has_unit);
    else
      take_word(&reading, wanted, reader->tokens[k].text), next = k + 1;
  take_place(wanted, reading.lengths, reading.count, reading.place, reading.to, reader->unitless ? "" : " m");
}

/* Finds the place of the page: its cell, or its box of walls. */
static void read_place(struct wanted *wanted, const struct nb_reader *reader) {
  static const char *const verbs[] = {"periodic", "box"};
  const char *rest;
  for (size_t v = 0; v < 2 && !*wanted->place; v++)
    for (size_t k = 1; k <= reader->page->line_count && !*wanted->place; k++) {
      if (k == reader->line || !nb_page_statement(reader->page, k, verbs[v], &rest))
        continue;
      struct nb_reader *line = malloc(sizeof *line);
      struct nb_mistakes unheard = {0};
      struct wanted found = {0};
      if (!line)
        return;
      *line = *reader;
      line->mistakes = &unheard;
      if (nb_line_read(line, k) && !line->bad)
        read_line(&found, line);
      nb_mistakes_free(&unheard);
      free(line);
      if (found.area == 0)
        continue;
      wanted->area = found.area, wanted->walls = v == 1;
      snprintf(wanted->place, sizeof wanted->place, "%s", v ? found.place : "cell");
    }
}

/* Appends a length with three digits, in the unit that suits it. */
static void append_length(char *text, const struct nb_reader *reader, double length) {
  const bool none = reader->unitless;
  const double scale = none || length >= 1 ? 1 : length >= 1e-3 ? 1e-3 : 1e-6;
  nb_append(text, NB_HINT_SIZE, "%.3g%s", length / scale, none ? "" : scale == 1 ? " m" : scale < 1e-3 ? " um" : " mm");
}

/* Rounds a length to two digits: down, or up. */
static double rounded(double length, bool up) {
  const double unit = pow(10, floor(log10(length)) - 1);
  return (up ? ceil(length / unit) : floor(length / unit)) * unit;
}

/* Number of sizes of the proposed grading: one, or three, a, (a + b)/2 and b, between two radii a and b. */
static int size_count(const struct wanted *wanted) {
  const bool few = wanted->count > 0 && wanted->count < 3;
  return wanted->radii[1] > 0 && !few ? 3 : 1;
}

/* The mean area of a particle: all sizes are equally frequent. */
static double mean_area(const struct wanted *wanted) {
  const double a = wanted->radii[0], b = size_count(wanted) > 1 ? wanted->radii[1] : a;
  return NB_PI * (5 * a * a + 2 * a * b + 5 * b * b) / 12;
}

/* Completes number and radius, each from the other one and the place. */
static void complete_particles(struct wanted *wanted, double solid) {
  const bool radius = wanted->radii[0] > 0, place = wanted->area > 0;
  if (wanted->count == 0)
    wanted->count = radius && place ? fmax(floor(solid * wanted->area / mean_area(wanted)), 1) : 200;
  if (!radius)
    wanted->radii[0] = place ? rounded(sqrt(solid * wanted->area / (wanted->count * NB_PI)), false) : 5e-3;
}

/* The side of a box with 2 + 2 sqrt(2) radii: a second particle has a place wherever the first one is. */
static double least_side(const struct wanted *wanted) {
  return (2 + sqrt(8)) * wanted->radii[size_count(wanted) > 1 ? 1 : 0];
}

/* Completes the place from number and radius, or enlarges a box or reduces the number. */
static void complete_place(struct wanted *wanted, double solid, const char *unit) {
  const double needed = wanted->count * mean_area(wanted);
  const double side = rounded(fmax(sqrt(needed / solid), least_side(wanted)), true);
  const bool full = wanted->area > 0 && needed > MOST * wanted->area, box = strncmp(wanted->place, "box", 3) == 0;
  wanted->enlarged = full && box;
  if (full && !box)
    wanted->asked = wanted->count, wanted->count = fmax(floor(solid * wanted->area / mean_area(wanted)), 1);
  if (*wanted->place && !(full && box))
    return;
  snprintf(wanted->place, sizeof wanted->place, "box 0%s 0%s to %.3g%s %.3g%s", unit, unit, side, unit, side, unit);
  wanted->area = side * side;
}

/* Appends the grading: one size, or three between the smallest and the largest radius. */
static void append_grading(char *hint, const struct nb_reader *reader, const struct wanted *wanted) {
  const int sizes = size_count(wanted);
  nb_append(hint, NB_HINT_SIZE, "`grading mixed");
  for (int s = 0; s < sizes; s++) {
    const double third = floor(wanted->count / sizes), rest = wanted->count - sizes * third;
    nb_append(hint, NB_HINT_SIZE, s ? "  " : " ");
    append_length(hint, reader, wanted->radii[0] + (wanted->radii[1] - wanted->radii[0]) * s / 2 * (sizes > 1));
    nb_append(hint, NB_HINT_SIZE, " %.0f", third + (s < rest));
  }
  nb_append(hint, NB_HINT_SIZE, "`");
}

/* Appends how the particles are compressed to a porosity. */
static void append_target(char *hint, const struct wanted *wanted) {
  if (!wanted->has_porosity)
    return;
  if (wanted->porosity > 1 - MOST) {
    nb_append(hint, NB_HINT_SIZE, "; the porosity is then %.3g", 1 - wanted->count * mean_area(wanted) / wanted->area);
    return;
  }
  const bool cell = strcmp(wanted->place, "cell") == 0;
  nb_append(hint, NB_HINT_SIZE,
            ". Random placing is loose, so a stage compresses to the porosity %g: `%s strain -2e-6 per cycle -2e-6 per "
            "cycle` and `until %s.porosity below %g at most 1000000 cycles`%s",
            wanted->porosity, cell ? "cell" : "box", cell ? "M" : "box", wanted->porosity,
            cell                                ? ", with `region M all`"
            : wanted->walls || wanted->enlarged ? ""
                                                : ", with a `box` of walls in the scene");
}

const char *nb_fill_hint(char *hint, const struct nb_reader *reader) {
  struct wanted wanted = {0};
  read_line(&wanted, reader);
  if (!*wanted.place)
    read_place(&wanted, reader);
  const double solid = wanted.has_porosity && wanted.porosity > 1 - MOST ? 1 - wanted.porosity : SOLID;
  complete_particles(&wanted, solid);
  complete_place(&wanted, solid, reader->unitless ? "" : " m");
  snprintf(hint, NB_HINT_SIZE, "a random packing is two lines, ");
  append_grading(hint, reader, &wanted);
  nb_append(hint, NB_HINT_SIZE, " (radius and number) and `fill %s %s mixed MATERIAL seed 1 attempts 1000 else stop`",
            wanted.spheres ? "spheres" : "discs", wanted.place);
  if (wanted.enlarged)
    nb_append(hint, NB_HINT_SIZE, ", with `%s MATERIAL`: random placing fills at most half of a box", wanted.place);
  if (wanted.asked > 0)
    nb_append(hint, NB_HINT_SIZE, ", with %.0f in place of %.0f: random placing fills at most half of a %s",
              wanted.count, wanted.asked, strcmp(wanted.place, "cell") == 0 ? "cell" : "circle");
  append_target(hint, &wanted);
  return hint;
}
