/* Runs gnuplot: it reads one script and the recipes, and writes the figure to its standard output. It reads no start-up
 * files (-d).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "commands.h"
#include "core/clean.h"
#include "tool.h"

/* Appends the number of the line of the page to a message about a line of the script, `"./NAME.gp" line 812: …`. */
static void add_page_line(const struct nb_gnuplot *drawing, char *message, size_t size) {
  const char *const said = strstr(message, ".gp\" line ");
  size_t wanted, page = 0, at = 0, room = 0;
  char path[4096], *text = NULL;
  snprintf(path, sizeof path, "%.3000s/%s.gp", drawing->folder, drawing->name);
  FILE *const script = said && sscanf(said, ".gp\" line %zu", &wanted) == 1 ? fopen(path, "r") : NULL;
  for (size_t n = 1; script && n <= wanted && getline(&text, &room, script) >= 0; n++)
    if (sscanf(text, NB_PAGE_LINE, &page) == 1)
      at = n + 1;
  if (at)
    nb_append(message, size, " (line %zu of the page)", page + wanted - at);
  free(text);
  if (script)
    fclose(script);
}

/* Largest number of messages that are printed. Later messages do not get their line of the page either, because the
 * search for it reads the script, which may have large tables. */
enum { MESSAGES_SHOWN = 200 };

/* A part of gnuplot's message about a column that the data do not have. */
static const char missing[] = "no column with header";

/* Copies the messages of gnuplot to stderr if verbose. `reason` receives the error message: the last line that is not
 * blank. For gnuplot a missing column is only a warning, but the figure then lacks a curve; so `reason` receives this
 * warning, and the function returns true. */
static bool copy_messages(const struct nb_gnuplot *drawing, FILE *messages, char *reason, size_t size) {
  char line[1024];
  bool missing_column = false;
  reason[0] = 0;
  for (int count = 0; nb_tool_message(messages, line, sizeof line); count++) {
    if (count < MESSAGES_SHOWN)
      add_page_line(drawing, line, sizeof line);
    if (line[strspn(line, " \t^")] && !missing_column)
      snprintf(reason, size, "%s", line + strspn(line, " \t"));
    missing_column = missing_column || strstr(line, missing);
    if (drawing->verbose && count < MESSAGES_SHOWN)
      fprintf(stderr, "%s\n", line);
  }
  return missing_column;
}

/* The names of the data, for a message of gnuplot about data that it does not find; empty for other messages. */
static const char *data_hint(const char *reason) {
  if (strstr(reason, missing))
    return "; the name of a column ends with its unit, or with `/-`: `A.x/m`, `M.porosity/-`; the data are `$table`, "
           "with a sweep `$table_1`, `$table_2`, …: see `nineball --help gnuplot`";
  static const char *const about[] = {"No data in plot", "undefined variable", "no datablock", "range is invalid"};
  for (size_t k = 0; k < sizeof about / sizeof *about; k++)
    if (strstr(reason, about[k]))
      return "; the data are `$table`, with a sweep `$table_1`, `$table_2`, …, and `$values`, one row for each run, "
             "whose columns have names: see `nineball --help gnuplot`";
  return "";
}

/* Appends the heads of the columns of a data block, `$values << EOD`: the line after its name, with tabs. */
static void append_heads(char *list, size_t size, const char *heads) {
  for (size_t n; n = strcspn(heads, "\t\n"), n > 0; heads += n + (heads[n] == '\t'))
    nb_append(list, size, "%s`%.*s`", *list ? ", " : "", (int)n, heads);
}

/* Writes the heads of the columns for a message about a missing column: of `$values` if the page draws this block, or
 * else of the first `$table`. */
static void list_columns(char *list, size_t size, const struct nb_gnuplot *drawing, const char *reason) {
  char path[4096], *text = NULL, heads[2][1024] = {"", ""};
  size_t room = 0;
  int block = -1;
  bool of_values = false;
  *list = '\0';
  snprintf(path, sizeof path, "%.3000s/%s.gp", drawing->folder, drawing->name);
  FILE *const script = strstr(reason, missing) ? fopen(path, "r") : NULL;
  while (script && getline(&text, &room, script) >= 0) {
    if (block >= 0 && !*heads[block])
      append_heads(heads[block], sizeof heads[block], text);
    block = strncmp(text, "$values << EOD", 14) == 0 ? 0 : strncmp(text, "$table", 6) == 0 ? 1 : -1;
    of_values = of_values || (block < 0 && strstr(text, "$values"));
  }
  snprintf(list, size, "; the columns of `$%s` are %s", of_values ? "values" : "table", heads[!of_values]);
  if (!script || !*heads[!of_values])
    *list = '\0';
  free(text);
  if (script)
    fclose(script);
}

enum nb_status nb_gnuplot_run(const struct nb_gnuplot *drawing, struct nb_error *error) {
  char file[NB_NAME_SIZE + 8], argument[sizeof file + 2], reason[256];
  char *const words[] = {"-d", "-e", (char *)drawing->commands, argument, NULL};
  snprintf(file, sizeof file, "%s.gp", drawing->name);
  snprintf(argument, sizeof argument, "./%s", file);
  const struct nb_tool tool = {"gnuplot",        "gnuplot-nox", drawing->folder, file,
                               drawing->recipes, words,         drawing->figure, drawing->trust};
  FILE *messages;
  int code;
  enum nb_status status = nb_tool_run(&tool, &messages, &code, error);
  if (messages) {
    const bool missing_column = copy_messages(drawing, messages, reason, sizeof reason);
    if (!status && (code != 0 || missing_column)) {
      char columns[1200];
      list_columns(columns, sizeof columns, drawing, reason);
      status = nb_error_set(error, NB_BAD_USE, "gnuplot refused %.150s/%s: %s%s%s", drawing->folder, file, reason,
                            data_hint(reason), columns);
    }
    fclose(messages);
  }
  return status;
}
