/* Runs gnuplot and pandoc, confined (sandbox.h).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/error.h"

/* A program that reads `file` in `folder` and the files of `library`, and writes to its standard output. */
struct nb_tool {
  const char *name, *package; /* "gnuplot", of the Debian package gnuplot-nox */
  const char *folder, *file;  /* folder of the file; name of the file without its folder */
  const char *library;
  char *const *arguments; /* arguments without the name of the program, NULL-terminated */
  int out;                /* file descriptor for the program's output */
  bool trust;             /* run it even if it cannot be confined */
};
/* Runs the program. *messages is a temporary file, rewound, with the program's messages; the caller closes it unless it
 * is NULL. *code receives the exit status of the program, if the program has run; an exit status other than 0 is no
 * error. Returns NB_BAD_USE if the program is missing, cannot be confined, or is stopped by a signal. */
enum nb_status nb_tool_run(const struct nb_tool *tool, FILE **messages, int *code, struct nb_error *error);
/* Reads a message into `line` without the line end, with `?` in place of control characters; false: the end. */
bool nb_tool_message(FILE *messages, char *line, int size);
