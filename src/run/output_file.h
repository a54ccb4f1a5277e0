/* A file that is there whole or not at all: written beside, flushed to the disk, then renamed.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_SAVE_H
#define NB_SAVE_H

#include "core/error.h"

struct nb_save {
  FILE *file; /* write here; it can be read too */
  char *path, *temporary;
};

/* NB_BAD_USE and an error with the system's reason when it cannot be. Nothing is at `path` until nb_save_end says NB_OK;
 * what was there before stays until then. nb_save_end frees everything whatever it answers. */
enum nb_status nb_save_begin(struct nb_save *save, const char *path, struct nb_error *error);
/* The same over a file that exists and may be written: links to it and its permissions stay. */
enum nb_status nb_save_over(struct nb_save *save, const char *path, struct nb_error *error);
enum nb_status nb_save_end(struct nb_save *save, struct nb_error *error);
void nb_save_drop(struct nb_save *save); /* instead of nb_save_end: nothing was written */
/* Makes the folder, and those above it, unless they are there. */
enum nb_status nb_save_folder(const char *path, struct nb_error *error);

#endif
