/* Runs gnuplot confined: it reads one script and the recipes, and writes the figure to its standard output.
 *
 * The script contains code of the page. So gnuplot has only the rights of sandbox.c, reads no start-up files (-d), and
 * control characters are removed from its messages. No file name is part of a gnuplot command: the script is a separate
 * argument, and it begins with `./`, because gnuplot would run `<NAME` as a shell command.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#define _DEFAULT_SOURCE

#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

#include "commands.h"
#include "core/clean.h"
#include "sandbox.h"

/* Copies the messages of gnuplot to stderr if verbose. `reason` receives the error message: the last line that is not
 * blank. A missing column is only a warning for gnuplot, but the figure then lacks a curve: `reason` receives that
 * warning, and the function returns true. */
static bool copy_messages(FILE *messages, bool verbose, char *reason, size_t size) {
  char line[1024];
  unsigned byte;
  bool missing_column = false;
  reason[0] = 0;
  rewind(messages);
  for (int count = 0; fgets(line, sizeof line, messages); count++) {
    line[strcspn(line, "\n")] = 0;
    nb_clean(line, strlen(line), &byte);
    if (line[strspn(line, " \t^")] && !missing_column)
      snprintf(reason, size, "%s", line + strspn(line, " \t"));
    missing_column = missing_column || strstr(line, "no column with header");
    if (verbose && count < 200)
      fprintf(stderr, "%s\n", line);
  }
  return missing_column;
}

enum nb_status nb_gnuplot_run(const struct nb_gnuplot *drawing, struct nb_error *error) {
  char file[NB_NAME_SIZE + 8], reason[256];
  char *const words[] = {"-d", "-e", (char *)drawing->commands, file, NULL};
  char *folder = realpath(drawing->folder, NULL);
  struct nb_confined *confined = calloc(1, sizeof *confined);
  FILE *messages = tmpfile();
  enum nb_status status = NB_BAD_USE;
  snprintf(file, sizeof file, "./%s.gp", drawing->name);
  if (!confined || !folder || !messages) {
    status = nb_error_system(error, "cannot draw in %.300s", drawing->folder);
  } else if (!nb_program_find(confined->program, sizeof confined->program, "gnuplot")) {
    status = nb_error_set(error, NB_BAD_USE, "gnuplot cannot be run: not found (its package is gnuplot-nox)");
  } else {
    confined->folder = folder, confined->file = file, confined->library = drawing->recipes, confined->arguments = words;
    status = nb_confine_begin(confined, drawing->trust, error);
    if (!status) {
      const int end = nb_confine_run(confined, drawing->figure, fileno(messages));
      const bool missing_column = copy_messages(messages, drawing->verbose, reason, sizeof reason);
      const int code = WIFEXITED(end) ? WEXITSTATUS(end) : 0;
      const int fatal = WIFSIGNALED(end) ? WTERMSIG(end) : code > 128 ? code - 128 : 0; /* as bwrap reports a signal */
      if (fatal)
        status = nb_error_set(error, NB_BAD_USE, "gnuplot was stopped while it drew %.150s/%s: %s", drawing->folder,
                              file + 2, strsignal(fatal));
      else if (end != 0 || missing_column)
        status = nb_error_set(error, NB_BAD_USE, "gnuplot refused %.150s/%s: %s", drawing->folder, file + 2, reason);
    }
    nb_confine_end(confined);
  }
  if (messages)
    fclose(messages);
  free(confined);
  free(folder);
  return status;
}
