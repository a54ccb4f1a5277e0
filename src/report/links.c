/* The targets of a page's links in the report: another page, or a copy of a file.
 *
 * A page may come from a stranger, and a report may be published. So a file is copied only if it is a small picture or
 * text. It must also be in the folder of the page or below and not be hidden, unless the pages are trusted.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/clean.h"
#include "input/reader.h"
#include "input/text.h"
#include "report.h"

/* largest size of the list of a page's links, and of a file that is copied */
enum { LIST_BYTES = 100000, FILE_BYTES = 300000 };

static bool has_ending(const char *name, const char *endings) {
  const char *dot = strrchr(name, '.');
  char item[NB_NAME_SIZE];
  while (dot && nb_item(&endings, item))
    if (strcmp(dot + 1, item) == 0)
      return true;
  return false;
}

/* The name of a copied file: the last two parts of its path, joined by `-`. A text gets the ending .txt, because a
 * browser shows a file as text only with this ending. If another file has the name, a number comes before it. The
 * caller frees the name; NULL: out of memory. */
static char *file_name(const struct nb_report *report, const char *real, bool picture) {
  const size_t size = strlen(real) + 32;
  char *name = malloc(size);
  const char *slash = strrchr(real, '/'), *from = slash;
  while (from > real && from[-1] != '/')
    from--;
  if (!name)
    return NULL;
  snprintf(name, size, "%.*s-%s%s", (int)(slash - from), from, slash + 1, picture ? "" : ".txt");
  for (size_t k = 0; k < report->file_count; k++)
    if (strcmp(report->files[k].name, name) == 0)
      snprintf(name, size, "%zu-%.*s-%s%s", report->file_count, (int)(slash - from), from, slash + 1,
               picture ? "" : ".txt");
  return name;
}

static bool save_file(const struct nb_report *report, const char *name, const char *bytes, size_t size) {
  char folder[4096];
  struct nb_error error;
  struct nb_save save;
  snprintf(folder, sizeof folder, "%.4000s/files", report->folder);
  if (nb_folder_create(folder, &error) || nb_save_begin_in(&save, &error, folder, "%s", name))
    return false;
  fwrite(bytes, 1, size, save.file);
  return !nb_save_end(&save, &error);
}

/* Copies a file to the report, unless it has been copied. Returns its name there; NULL: it is not a small picture or
 * text, or it could not be read or copied. */
static const char *copy_file(struct nb_report *report, const char *real) {
  const bool picture = has_ending(real, "svg, png, jpg, jpeg, gif, webp");
  struct nb_error error;
  size_t size;
  for (size_t k = 0; k < report->file_count; k++)
    if (strcmp(report->files[k].real, real) == 0)
      return report->files[k].name;
  char *bytes = nb_file_read(real, FILE_BYTES, &size, &error);
  struct nb_report_file file = {NULL, NULL}, *own = NULL;
  if (bytes && (picture || !memchr(bytes, 0, size)))
    file = (struct nb_report_file){strdup(real), file_name(report, real, picture)};
  if (file.real && file.name && save_file(report, file.name, bytes, size))
    own = NB_ARRAY_APPEND(report->files, report->file_count);
  if (own)
    *own = file;
  else
    free(file.real), free(file.name);
  free(bytes);
  return own ? own->name : NULL;
}

/* True if the file is in the folder of the page or below, and neither it nor a folder between them is hidden: a page may
 * be in the home folder, and hidden files there have passwords and keys. */
static bool is_below(const char *real, const char *page) {
  const size_t length = (size_t)(strrchr(page, '/') - page);
  return strncmp(real, page, length + 1) == 0 && !strstr(real + length, "/.");
}

/* Writes the address of a target in the report and, if it is a page, the verdict on it; false: the target is neither a
 * page of the report nor a file that was copied. */
static bool resolve(struct nb_report *report, const struct nb_report_page *page, const char *target, char *address,
                    const char **class, char *verdict, size_t size) {
  char path[4096];
  const char *copy;
  bool found = false;
  *class = "";
  address[0] = verdict[0] = 0;
  snprintf(path, sizeof path, "%.*s%.1000s", (int)(strrchr(page->real, '/') - page->real) + 1, page->real, target);
  char *real = realpath(path, NULL);
  for (size_t k = 0; k < report->count && real && !found; k++)
    if (report->pages[k].real && strcmp(report->pages[k].real, real) == 0) {
      found = true;
      nb_html_address(address, size, report->pages[k].name);
      nb_append(address, size, "/index.html");
      *class = nb_html_verdict(verdict, size, &report->pages[k]);
    }
  if (real && !found && (report->trust || is_below(real, page->real)) && (copy = copy_file(report, real))) {
    found = true;
    nb_append(address, size, "files/");
    nb_html_address(address, size, copy);
  }
  free(real);
  return found;
}

/* Takes the next target of the line, without its fragment: `](TARGET)` or `](TARGET "title")`. NULL: none is left. */
static const char *next_target(const char **line, char *target, size_t size) {
  while ((*line = strstr(*line, "]("))) {
    *line += 2;
    const size_t length = strcspn(*line, " )#\t");
    if (length >= size || memchr(*line, ':', length))
      continue;
    memcpy(target, *line, length);
    target[length] = 0;
    return target;
  }
  return NULL;
}

char *nb_report_links(struct nb_report *report, const struct nb_report_page *page, const char *top, bool verdicts) {
  char target[1000], address[1000], verdict[1000];
  const char *class;
  struct nb_text list = {0};
  const struct nb_page *content = &page->outcome.page;
  nb_text_add(&list, "%s", ""); /* an empty list is not NULL */
  for (size_t k = 0; !list.failed && page->real && k < content->line_count && list.length < LIST_BYTES; k++)
    for (const char *at = content->lines[k]; content->kind_of[k] == 0 && next_target(&at, target, sizeof target);)
      if (resolve(report, page, target, address, &class, verdict, sizeof address))
        nb_text_add(&list, "%s\t%s%s\t%s\t%s\n", target, top, address, class, verdicts ? verdict : "");
  return list.at;
}
