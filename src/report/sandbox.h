/* Runs a program with only the rights that it needs.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_SANDBOX_H
#define NB_SANDBOX_H

#include "core/error.h"

enum { NB_CONFINE_PATH = 4096, NB_CONFINE_WORDS = 96 };

enum nb_confinement { NB_CONFINE_LANDLOCK, NB_CONFINE_BWRAP, NB_CONFINE_NONE };

/* The program, and what it may read besides the libraries and fonts of the system. It may not write files: its output
 * goes to standard output. */
struct nb_confined {
  char program[NB_CONFINE_PATH];       /* real path */
  char loader[NB_CONFINE_PATH];        /* its ELF loader; empty: none */
  const char *folder, *file, *library; /* it starts in `folder`, and may read `file` there and the folder `library` */
  char *const *arguments;              /* without the name, NULL-terminated */
  enum nb_confinement method;
  int rules;                         /* of Landlock: file descriptor; -1: none */
  char wrap[NB_CONFINE_PATH];        /* path of bwrap */
  char *command[NB_CONFINE_WORDS];   /* the complete command; the strings are not owned */
  char text[2][2 * NB_CONFINE_PATH]; /* strings of the command */
};

/* Finds the program on PATH; returns its real path in `path`. */
bool nb_program_find(char *path, size_t size, const char *name);
/* Chooses the method and prepares it: Landlock, else bwrap, else none if the page is trusted, else an error. The caller
 * sets `program`, `folder`, `file`, `library` and `arguments`. NINEBALL_CONFINE=landlock|bwrap|none restricts the
 * choice. End it with nb_confine_end. */
enum nb_status nb_confine_begin(struct nb_confined *confined, bool trust, struct nb_error *error);
void nb_confine_end(struct nb_confined *confined);
/* Runs it with these files as standard output and error. Returns the status of waitpid, or -1 if it could not be
 * started. */
int nb_confine_run(const struct nb_confined *confined, int out, int errors);

#endif
