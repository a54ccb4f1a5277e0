/* Runs gnuplot: it reads one script and the recipes, and writes the figure to its standard output. It reads no start-up
 * files (-d).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "commands.h"
#include "tool.h"

/* Copies the messages of gnuplot to stderr if verbose. `reason` receives the error message: the last line that is not
 * blank. For gnuplot a missing column is only a warning, but the figure then lacks a curve; so `reason` receives this
 * warning, and the function returns true. */
static bool copy_messages(FILE *messages, bool verbose, char *reason, size_t size) {
  char line[1024];
  bool missing_column = false;
  reason[0] = 0;
  for (int count = 0; nb_tool_message(messages, line, sizeof line); count++) {
    if (line[strspn(line, " \t^")] && !missing_column)
      snprintf(reason, size, "%s", line + strspn(line, " \t"));
    missing_column = missing_column || strstr(line, "no column with header");
    if (verbose && count < 200)
      fprintf(stderr, "%s\n", line);
  }
  return missing_column;
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
    const bool missing_column = copy_messages(messages, drawing->verbose, reason, sizeof reason);
    if (!status && (code != 0 || missing_column))
      status = nb_error_set(error, NB_BAD_USE, "gnuplot refused %.150s/%s: %s", drawing->folder, file, reason);
    fclose(messages);
  }
  return status;
}
