/* Files that are written completely or not at all: written under a temporary name, flushed to the disk, then renamed.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "core/error.h"

struct nb_save {
  FILE *file; /* open for writing and reading */
  char *path, *temporary;
};

/* Errors are NB_BAD_USE with the reason that the system gives, or NB_NO_MEMORY. After an error of nb_save_begin there
 * is nothing to free. The file at `path` appears, or replaces the old one, when nb_save_end returns NB_OK. nb_save_end
 * frees everything in any case. */
enum nb_status nb_save_begin(struct nb_save *save, const char *path, struct nb_error *error);
/* Does the same for a file that exists and is writable. Symbolic links to the file and its permissions are kept. */
enum nb_status nb_save_replace_begin(struct nb_save *save, const char *path, struct nb_error *error);
enum nb_status nb_save_end(struct nb_save *save, struct nb_error *error);
void nb_save_cancel(struct nb_save *save); /* discards the file; called instead of nb_save_end */
/* Creates the folder and those above it if they do not exist. `error` must not be NULL: its status becomes NB_OK if the
 * folder exists. */
enum nb_status nb_folder_create(const char *path, struct nb_error *error);
