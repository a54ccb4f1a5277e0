/* Runs a program with only the rights that it needs.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/error.h"

enum { NB_CONFINE_PATH = 4096, NB_CONFINE_WORDS = 96 };

enum nb_confinement { NB_CONFINE_LANDLOCK, NB_CONFINE_BWRAP, NB_CONFINE_NONE };

/* The program, and the files that it may read besides the libraries and fonts of the system. The program may not write
 * files, unless `method` is NB_CONFINE_NONE. Its output goes to standard output. */
struct nb_confined {
  char program[NB_CONFINE_PATH];       /* real path */
  char loader[NB_CONFINE_PATH];        /* its ELF loader; empty: none */
  const char *folder, *file, *library; /* it starts in `folder`, and may read `file` there and the folder `library` */
  char *const *arguments;              /* arguments without the name of the program, NULL-terminated */
  enum nb_confinement method;
  int rules;                         /* file descriptor of the rules of Landlock; -1: none */
  char wrap[NB_CONFINE_PATH];        /* path of bwrap */
  char *command[NB_CONFINE_WORDS];   /* the complete command; the strings are not owned */
  char text[2][2 * NB_CONFINE_PATH]; /* strings of the command */
};

/* Finds the program on PATH; returns its real path in `path`. False: there is none, or its path is too long. */
bool nb_program_find(char *path, size_t size, const char *name);
/* Chooses the method and prepares it: Landlock, or else bwrap. If neither works, a trusted page is not confined, and
 * any other page is an error. The caller sets `program`, `folder`, `file`, `library` and `arguments`, and calls
 * nb_confine_end at the end, also after an error. NINEBALL_CONFINE=landlock|bwrap|none restricts the choice. */
enum nb_status nb_confine_begin(struct nb_confined *confined, bool trust, struct nb_error *error);
void nb_confine_end(struct nb_confined *confined);
/* Runs the program with these files as standard output and standard error. Returns the status of waitpid, or -1 if
 * there is no process for the program. The exit status is 126 if the program could not be confined or executed. */
int nb_confine_run(const struct nb_confined *confined, int out, int errors);
