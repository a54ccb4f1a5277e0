/* A program that is run with no rights but those it needs.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_SANDBOX_H
#define NB_SANDBOX_H

#include "core/error.h"

enum { NB_CONFINE_PATH = 4096, NB_CONFINE_WORDS = 96 };

enum nb_confinement { NB_CONFINE_LANDLOCK, NB_CONFINE_BWRAP, NB_CONFINE_NONE };

/* What runs, and what it may read besides the libraries and fonts of the system. Nothing may be written: what the program
 * makes goes to its standard output. */
struct nb_confined {
  char program[NB_CONFINE_PATH]; /* by its real path */
  char loader[NB_CONFINE_PATH];  /* the ELF loader that its header names; empty: none */
  const char *folder, *file,
      *library;           /* it begins in `folder` and reads `file` in it, and all in the folder `library` */
  char *const *arguments; /* its arguments after the name, NULL-terminated */
  enum nb_confinement method;
  int rules;                         /* of Landlock: file descriptor; -1: none */
  char wrap[NB_CONFINE_PATH];        /* bwrap by its path */
  char *command[NB_CONFINE_WORDS];   /* what is executed in the end: strings of others */
  char text[2][2 * NB_CONFINE_PATH]; /* for them */
};

/* The program of this name on PATH by its real path; false: none. */
bool nb_program_find(char *path, size_t size, const char *name);
/* Chooses how and prepares it: Landlock, else bwrap, else not at all if the page is trusted, else an error. `program`, `folder`,
 * `file`, `library` and `words` are given. NINEBALL_CONFINE=landlock|bwrap|none restricts the choice. End it with nb_confine_end. */
enum nb_status nb_confine_begin(struct nb_confined *confined, bool trust, struct nb_error *error);
void nb_confine_end(struct nb_confined *confined);
/* Runs it, with these files as standard output and error; the status that waitpid answers, -1: it could not be started. */
int nb_confine_run(const struct nb_confined *confined, int out, int errors);

#endif
