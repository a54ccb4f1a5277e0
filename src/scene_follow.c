/* A path from a file: lines of tab-separated columns, under a head line that names them as our own tables do, `approach/m`
 * (or `overlap/m`, from such a table) and `slip/m`, in any unit of length. Other columns are passed over, and so are empty
 * lines and those that begin with `#`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "scene.h"

/* A field of a line: from its begin, `length` bytes; columns count characters from 1. */
struct field {
  const char *at;
  size_t length;
  int column;
};

/* Field number `index`, from 0; false: the line has fewer, and field is empty at its end. */
static bool find_field(struct field *field, const char *line, int index) {
  *field = (struct field){line, strcspn(line, "\t"), 1};
  for (; index > 0 && field->at[field->length]; index--) {
    for (size_t k = 0; k <= field->length; k++)
      field->column += (field->at[k] & 0xC0) != 0x80;
    field->at += field->length + 1;
    field->length = strcspn(field->at, "\t");
  }
  return index == 0;
}

static void say(struct nb_mistakes *mistakes, const struct nb_page *file, size_t line, struct field field,
                const char *expected) {
  const int shown = field.length < 80 ? (int)field.length : 80;
  if (field.length == 0)
    nb_mistake(mistakes, file, line, field.column, 1, NULL, "expected %s, found nothing", expected);
  else
    nb_mistake(mistakes, file, line, field.column, (int)field.length, NULL, "expected %s, found `%.*s`", expected,
               shown, field.at);
}

/* One of the two columns. */
struct column {
  int index; /* -1: not there */
  int shift; /* of its unit */
};

/* A field of the head: `slip/um`. */
static bool is_column(struct column *column, const struct field *field, const char *name, bool unitless) {
  char text[NB_NAME_SIZE];
  const size_t length = strlen(name);
  if (field->length <= length || field->length >= sizeof text || strncmp(field->at, name, length) != 0 ||
      field->at[length] != '/')
    return false;
  memcpy(text, field->at + length + 1, field->length - length - 1);
  text[field->length - length - 1] = '\0';
  const struct nb_unit *unit = nb_unit_find(text);
  column->shift = unit && !unitless ? unit->shift : 0;
  return unitless ? strcmp(text, "-") == 0 : unit && unit->kind == NB_UNIT_LENGTH;
}

static bool read_head(struct column columns[2], const struct nb_page *file, size_t line, bool unitless,
                      struct nb_mistakes *mistakes) {
  struct field field;
  columns[0].index = columns[1].index = -1;
  for (int k = 0; find_field(&field, file->lines[line - 1], k); k++) {
    if (is_column(&columns[0], &field, "approach", unitless) || is_column(&columns[0], &field, "overlap", unitless))
      columns[0].index = k;
    else if (is_column(&columns[1], &field, "slip", unitless))
      columns[1].index = k;
  }
  if (columns[0].index >= 0 && columns[1].index >= 0)
    return true;
  field = (struct field){file->lines[line - 1], strlen(file->lines[line - 1]), 1};
  say(mistakes, file, line, field,
      unitless ? "a head line with columns `approach/-` and `slip/-`"
               : "a head line with columns `approach/m` and `slip/m`, in a unit of length");
  return false;
}

static bool read_number(double *value, const struct nb_page *file, size_t line, struct column column, const char *what,
                        struct nb_mistakes *mistakes) {
  struct field field;
  char text[NB_NAME_SIZE] = "";
  if (!find_field(&field, file->lines[line - 1], column.index))
    field.column += (int)field.length, field.at += field.length, field.length = 0;
  if (field.length < sizeof text) {
    memcpy(text, field.at, field.length);
    text[field.length] = '\0';
  }
  if (nb_number_read(value, text, column.shift) == NB_READ)
    return true;
  say(mistakes, file, line, field, what);
  return false;
}

bool nb_follow_read(struct nb_leg *leg, const char *path, bool unitless, struct nb_mistakes *mistakes) {
  struct nb_page file;
  struct column columns[2];
  const size_t before = mistakes->made;
  bool head = false;
  if (nb_page_read(&file, path, mistakes))
    return false;
  leg->points = calloc(file.line_count + 1, sizeof *leg->points);
  for (size_t line = 1; line <= file.line_count && leg->points; line++) {
    const char *text = file.lines[line - 1];
    struct nb_point *point = &leg->points[leg->point_count];
    if (text[0] == '#' || !text[strspn(text, " \t")])
      continue;
    if (!head) {
      head = true;
      if (!read_head(columns, &file, line, unitless, mistakes))
        break;
      continue;
    }
    const bool whole = read_number(&point->approach, &file, line, columns[0], "a number for the approach", mistakes);
    leg->point_count += read_number(&point->slip, &file, line, columns[1], "a number for the slip", mistakes) && whole;
  }
  if (leg->point_count == 0 && mistakes->made == before)
    nb_mistake(mistakes, &file, 0, 0, 0, NULL, "expected a head line and rows of numbers below it, found none");
  nb_page_free(&file);
  return mistakes->made == before;
}

void nb_path_follow(struct nb_scene_reading *reading) {
  struct nb_scene *scene = reading->scene;
  struct nb_stage stage = {.name = "follow", .record = 1, .cycles = 1};
  for (size_t s = 0; s < scene->stage_count; s++) {
    stage.snapshot = stage.snapshot || scene->stages[s].snapshot;
    free(scene->stages[s].leg.points);
  }
  scene->stage_count = 0;
  scene->followed = true;
  struct nb_stage *stages = nb_room(scene->stages, 0, 1, sizeof *stages);
  if (!stages || !nb_follow_read(&stage.leg, reading->follow, reading->reader.unitless, reading->reader.mistakes)) {
    free(stage.leg.points);
    if (stages)
      scene->stages = stages;
    return;
  }
  stage.cycles = stage.leg.point_count;
  scene->stages = stages;
  scene->stages[scene->stage_count++] = stage;
}
