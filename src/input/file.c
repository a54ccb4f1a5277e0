/* Input files: how a page's file names are resolved; only regular files are read.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "reader.h"

FILE *nb_file_open(const char *path, struct nb_error *error) {
  struct stat status;
  const int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC); /* a pipe without a writer would block */
  FILE *file = NULL;
  if (descriptor < 0 || fstat(descriptor, &status) != 0)
    nb_error_system(error, "cannot be read");
  else if (!S_ISREG(status.st_mode))
    nb_error_set(error, NB_BAD_USE, "cannot be read: it is %s",
                 S_ISDIR(status.st_mode) ? "a folder" : "a pipe or a device; a regular file is expected");
  else if (!(file = fdopen(descriptor, "rb")))
    nb_error_system(error, "cannot be read");
  if (descriptor >= 0 && !file)
    close(descriptor);
  return file;
}

char *nb_file_read(const char *path, size_t most, size_t *size, struct nb_error *error) {
  struct stat status;
  FILE *file = nb_file_open(path, error);
  char *bytes = NULL;
  if (!file)
    return NULL;
  if (fstat(fileno(file), &status) != 0)
    nb_error_system(error, "cannot be read");
  else if ((*size = (size_t)status.st_size) > most)
    nb_error_set(error, NB_BAD_USE, "expected at most %zu bytes, found %zu", most, *size);
  else if (!(bytes = malloc(*size + 1)))
    nb_error_memory(error);
  else if (fread(bytes, 1, *size, file) != *size) {
    if (ferror(file))
      nb_error_system(error, "cannot be read");
    else
      nb_error_set(error, NB_BAD_USE, "cannot be read: it became shorter while it was read");
    free(bytes), bytes = NULL;
  } else {
    bytes[*size] = 0;
  }
  fclose(file);
  return bytes;
}

/* ---- a file by its name ---- */

enum { DEPTH_MAX = 8 }; /* levels of folders below `cases` that are searched */

struct search {
  const char *name;
  char path[NB_PATH_SIZE];     /* the folder that is searched */
  char found[2][NB_PATH_SIZE]; /* the first two files in alphabetical order; the order of readdir is arbitrary */
  size_t count;
  bool no_memory;
};

static bool has_type(const char *path, mode_t type) {
  struct stat status;
  return lstat(path, &status) == 0 && (status.st_mode & S_IFMT) == type;
}

static void add_found(struct search *search) {
  const size_t place = search->count > 0 && strcmp(search->path, search->found[0]) > 0;
  if (place == 0)
    strcpy(search->found[1], search->found[0]);
  if (place == 0 || search->count == 1 || strcmp(search->path, search->found[1]) < 0)
    strcpy(search->found[place], search->path);
  search->count++;
}

/* Searches a folder, then the folders in it. The search follows no links, so that it ends, and skips folders that
 * cannot be read. */
static void search_folder(struct search *search, int depth) {
  const size_t length = strlen(search->path), room = sizeof search->path - length;
  char *end = search->path + length;
  if ((size_t)snprintf(end, room, "/%s", search->name) < room && has_type(search->path, S_IFREG))
    add_found(search);
  *end = 0;
  DIR *folder = depth < DEPTH_MAX ? opendir(search->path) : NULL;
  search->no_memory = search->no_memory || (!folder && depth < DEPTH_MAX && errno == ENOMEM);
  for (struct dirent *entry; folder && (entry = readdir(folder));) {
    const bool fits = entry->d_name[0] != '.' && (size_t)snprintf(end, room, "/%s", entry->d_name) < room;
    if (fits && has_type(search->path, S_IFDIR))
      search_folder(search, depth + 1);
    *end = 0;
  }
  if (folder)
    closedir(folder);
}

/* Truncates a path after its last folder `cases`; false if it has no such folder. */
static bool truncate_after_cases(char *path) {
  static const char name[] = "cases";
  const size_t length = sizeof name - 1;
  char *end = NULL;
  for (char *at = path; (at = strstr(at, name)); at++)
    if ((at == path || at[-1] == '/') && (at[length] == '/' || at[length] == 0))
      end = at + length;
  if (end)
    *end = 0;
  return end;
}

/* Sets `cases` to the nearest folder `cases` above a page, in the given path or else in the real path of the page's
 * folder. False: there is none. */
static bool find_cases(char *cases, const char *page) {
  const char *slash = strrchr(page, '/');
  snprintf(cases, NB_PATH_SIZE, "%.*s", slash ? (int)(slash - page) : 1, slash ? page : ".");
  if (!strstr(cases, "..") && truncate_after_cases(cases))
    return true;
  char *whole = realpath(cases, NULL);
  const bool found = whole && strlen(whole) < NB_PATH_SIZE && truncate_after_cases(strcpy(cases, whole));
  free(whole);
  return found;
}

bool nb_file_find(struct nb_reader *reader, const struct nb_token *token, const char *ending, char *path) {
  const char *page = reader->page->path, *slash = strrchr(page, '/');
  const bool whole = token->text[0] == '/', upward = strncmp(token->text, "../", 3) == 0 || strstr(token->text, "/../");
  char name[NB_LINE_MAX];
  struct search search = {.name = name};
  snprintf(name, sizeof name, "%s%s", token->text, ending);
  if (snprintf(path, NB_PATH_SIZE, "%.*s%s", whole || !slash ? 0 : (int)(slash - page) + 1, page, name) >= NB_PATH_SIZE)
    return nb_token_mistake(reader, token, NULL, "expected a path shorter than %d bytes", NB_PATH_SIZE);
  if (whole || upward || access(path, F_OK) == 0 || !find_cases(search.path, page))
    return true;
  search_folder(&search, 0);
  if (search.no_memory)
    return nb_no_memory(reader);
  if (search.count > 1)
    return nb_token_mistake(reader, token, "give its path from the folder of this page",
                            "expected one file of this name, found `%.400s` and `%.400s`", search.found[0],
                            search.found[1]);
  if (search.count == 1)
    strcpy(path, search.found[0]);
  return true;
}
