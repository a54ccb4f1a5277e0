/* Runs gnuplot and pandoc, confined to the rights that sandbox.c grants.
 *
 * No text of a page can become a command. The programs are run without a shell. A file name is an argument of its own
 * and begins with `./`, because gnuplot would run `<NAME` as a shell command. The links of a page reach pandoc as the
 * value of an option.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "tool.h"

#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

#include "core/clean.h"
#include "sandbox.h"

bool nb_tool_message(FILE *messages, char *line, int size) {
  unsigned byte;
  if (!fgets(line, size, messages))
    return false;
  line[strcspn(line, "\n")] = 0;
  nb_clean(line, strlen(line), &byte);
  return true;
}

/* Checks how the program ended; `end` is the status that nb_confine_run returned. bwrap reports a signal as an exit
 * status above 128. */
static enum nb_status check_end(const struct nb_tool *tool, int end, int *code, struct nb_error *error) {
  *code = WIFEXITED(end) ? WEXITSTATUS(end) : 1;
  const int fatal = WIFSIGNALED(end) ? WTERMSIG(end) : *code > 128 ? *code - 128 : 0;
  return fatal ? nb_error_set(error, NB_BAD_USE, "%s was stopped while it read %.150s/%s: %s", tool->name, tool->folder,
                              tool->file, strsignal(fatal))
               : NB_OK;
}

enum nb_status nb_tool_run(const struct nb_tool *tool, FILE **messages, int *code, struct nb_error *error) {
  char file[NB_CONFINE_PATH];
  char *folder = realpath(tool->folder, NULL);
  struct nb_confined *confined = calloc(1, sizeof *confined);
  enum nb_status status = NB_BAD_USE;
  *messages = tmpfile();
  snprintf(file, sizeof file, "./%s", tool->file);
  if (!confined || !folder || !*messages) {
    status = nb_error_system(error, "cannot run %s in %.300s", tool->name, tool->folder);
  } else if (!nb_program_find(confined->program, sizeof confined->program, tool->name)) {
    status =
        nb_error_set(error, NB_BAD_USE, "%s cannot be run: not found (its package is %s)", tool->name, tool->package);
  } else {
    confined->folder = folder, confined->file = file, confined->library = tool->library;
    confined->arguments = tool->arguments;
    status = nb_confine_begin(confined, tool->trust, error);
    if (!status)
      status = check_end(tool, nb_confine_run(confined, tool->out, fileno(*messages)), code, error);
    nb_confine_end(confined);
    rewind(*messages);
  }
  free(confined);
  free(folder);
  return status;
}
