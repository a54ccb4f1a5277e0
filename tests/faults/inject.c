/* Replacements of calls that can fail: allocation, and opening, writing, flushing and renaming files. The linker
 * replaces calls of the C library by these (--wrap) in the objects of this program only, not in the C library itself or
 * in the sanitizers.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#define _GNU_SOURCE /* fopencookie */

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "../../src/report/commands.h"
#include "faults.h"

static struct {
  unsigned long calls, turn; /* number of calls so far; number of the call that fails, 0: none */
  bool lasting;              /* all later calls fail too */
  int reason;                /* errno of the last call that failed */
} faults;

void faults_begin(unsigned long n, bool lasting) {
  faults.calls = 0, faults.turn = n, faults.lasting = lasting, faults.reason = 0;
}
unsigned long faults_calls(void) { return faults.calls; }
int faults_reason(void) { return faults.reason; }

/* Counts a call. True if this call must fail; errno is then `why`. */
static bool fails(int why) {
  faults.calls++;
  if (!faults.turn || (faults.lasting ? faults.calls < faults.turn : faults.calls != faults.turn))
    return false;
  errno = faults.reason = why;
  return true;
}

/* Defines the replacement of the function `name`. A call that fails returns `failed`, and errno is `why`. */
#define WRAP(type, name, why, failed, declared, given)                                                                 \
  type __real_##name declared;                                                                                         \
  type __wrap_##name declared;                                                                                         \
  type __wrap_##name declared { return fails(why) ? failed : __real_##name given; }

WRAP(void *, malloc, ENOMEM, NULL, (size_t size), (size))
WRAP(void *, calloc, ENOMEM, NULL, (size_t count, size_t size), (count, size))
WRAP(void *, realloc, ENOMEM, NULL, (void *old, size_t size), (old, size))
WRAP(void *, aligned_alloc, ENOMEM, NULL, (size_t line, size_t size), (line, size))
WRAP(char *, strdup, ENOMEM, NULL, (const char *text), (text))
WRAP(DIR *, opendir, ENOMEM, NULL, (const char *path), (path))
WRAP(int, rename, EIO, -1, (const char *from, const char *to), (from, to))
WRAP(int, mkdir, ENOSPC, -1, (const char *path, mode_t mode), (path, mode))

/* Does not flush to the disk, which would be slow. */
int __wrap_fsync(int file);
int __wrap_fsync(int file) {
  (void)file;
  return fails(EIO) ? -1 : 0;
}

/* Output streams write through this function, so each write can fail. */
enum { STREAMS = 8 };
static struct {
  FILE *stream;
  int file;
} streams[STREAMS];

static ssize_t write_out(void *cookie, const char *bytes, size_t size) {
  return fails(ENOSPC) ? 0 : write(*(int *)cookie, bytes, size);
}
static ssize_t read_in(void *cookie, char *bytes, size_t size) { return read(*(int *)cookie, bytes, size); }
static int seek(void *cookie, off64_t *to, int from) {
  *to = lseek(*(int *)cookie, *to, from);
  return *to < 0 ? -1 : 0;
}
static int close_out(void *cookie) {
  for (int k = 0; k < STREAMS; k++)
    if (cookie == &streams[k].file)
      streams[k].stream = NULL;
  return close(*(int *)cookie);
}

/* Replaces a stream for writing by one that writes through write_out; returns a stream for reading unchanged. */
static FILE *own(FILE *plain, const char *mode) {
  int k = 0;
  while (k < STREAMS && streams[k].stream)
    k++;
  if (!plain || mode[0] != 'w' || k == STREAMS)
    return plain;
  streams[k].file = dup(fileno(plain));
  fclose(plain);
  return streams[k].stream =
             fopencookie(&streams[k].file, mode, (cookie_io_functions_t){read_in, write_out, seek, close_out});
}

FILE *__real_fopen(const char *path, const char *mode);
FILE *__wrap_fopen(const char *path, const char *mode);
FILE *__wrap_fopen(const char *path, const char *mode) {
  return fails(ENOMEM) ? NULL : own(__real_fopen(path, mode), mode);
}
FILE *__real_fdopen(int file, const char *mode);
FILE *__wrap_fdopen(int file, const char *mode);
FILE *__wrap_fdopen(int file, const char *mode) { return fails(ENOMEM) ? NULL : own(__real_fdopen(file, mode), mode); }

/* Replaces gnuplot, which is not tested here. */
enum nb_status __wrap_nb_gnuplot_run(const struct nb_gnuplot *drawing, struct nb_error *error);
enum nb_status __wrap_nb_gnuplot_run(const struct nb_gnuplot *drawing, struct nb_error *error) {
  const char *drawn = strstr(drawing->commands, "png") ? "\x89PNG" : "<?xml"; /* the first bytes of a drawing */
  if (!fails(EIO) && write(drawing->figure, drawn, strlen(drawn)) == (ssize_t)strlen(drawn))
    return NB_OK;
  return nb_error_system(error, "gnuplot cannot be run");
}

int __real_fileno(FILE *stream);
int __wrap_fileno(FILE *stream);
int __wrap_fileno(FILE *stream) {
  for (int k = 0; k < STREAMS; k++)
    if (streams[k].stream == stream)
      return streams[k].file;
  return __real_fileno(stream);
}
