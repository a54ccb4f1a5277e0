/* The text of a page as HTML. Pandoc reads the Markdown and typesets the formulas as MathML. The pandoc filter
 * plots/report.lua adapts the figure, the checks and the links to the report.
 *
 * Pandoc runs no code of the page (--sandbox), so the program runs pandoc even where pandoc cannot be confined
 * (sandbox.h).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "report.h"
#include "tool.h"

/* True for a message that can be ignored: pandoc has no translation of the word "Abstract", which pages do not use. */
static bool is_expected(const char *message) { return strstr(message, "ranslations") || strstr(message, "Abstract"); }

/* Copies the messages of pandoc to stderr, such as one about a formula that cannot be typeset. `last` receives the last
 * copied message, or is empty. */
static void copy_messages(FILE *messages, const char *path, char *last, size_t size) {
  char line[1024];
  last[0] = 0;
  while (nb_tool_message(messages, line, sizeof line))
    if (!is_expected(line)) {
      fprintf(stderr, "%s: warning: pandoc: %s\n", path, line);
      snprintf(last, size, "%.250s", line);
    }
}

static enum nb_status run_pandoc(FILE *out, const struct nb_report_page *page, const char *metadata,
                                 struct nb_error *error) {
  char plots[4096], filter[4200], figure[2 * NB_NAME_SIZE + 16] = "figure=", file[4096], folder[4096], last[256];
  nb_plots_find(plots, sizeof plots, error);
  if (!plots[0])
    return error->status;
  snprintf(filter, sizeof filter, "--lua-filter=%sreport.lua", plots);
  if (page->drawn)
    nb_html_address(figure, sizeof figure, page->figure);
  const char *name = strrchr(page->real, '/') + 1;
  snprintf(folder, sizeof folder, "%.*s", (int)(name - page->real), page->real);
  snprintf(file, sizeof file, "./%s", name);
  char *const words[] = {"--sandbox",
                         "--from=gfm+tex_math_dollars",
                         "--to=html5",
                         "--mathml",
                         filter,
                         "-M",
                         (char *)metadata,
                         "-M",
                         figure,
                         file,
                         NULL};
  const struct nb_tool tool = {"pandoc", "pandoc", folder, name, plots, words, fileno(out), true};
  FILE *messages;
  int code;
  enum nb_status status = nb_tool_run(&tool, &messages, &code, error);
  if (messages) {
    copy_messages(messages, page->path, last, sizeof last);
    if (!status && code != 0)
      status = nb_error_set(error, NB_BAD_USE, "pandoc refused %.300s: %s", page->path, last);
    fclose(messages);
  }
  return status;
}

enum nb_status nb_report_convert(FILE *out, struct nb_report *report, const struct nb_report_page *page,
                                 const char *top, bool verdicts, struct nb_error *error) {
  static const char place[] = "<!--nineball: checks-->";
  char *links = nb_report_links(report, page, top, verdicts), *metadata = NULL, *line = NULL;
  FILE *text = tmpfile();
  size_t size = 0;
  bool placed = false;
  enum nb_status status = NB_OK;
  if (links && (metadata = malloc(strlen(links) + sizeof "links=")))
    strcat(strcpy(metadata, "links="), links);
  if (!metadata || !text)
    status = nb_error_memory(error);
  else
    status = run_pandoc(text, page, metadata, error);
  if (text)
    rewind(text);
  while (!status && getline(&line, &size, text) >= 0) {
    const bool here = strncmp(line, place, strlen(place)) == 0;
    if (here)
      nb_html_checks(out, &page->outcome), placed = true;
    else
      fputs(line, out);
  }
  if (!placed)
    nb_html_checks(out, &page->outcome);
  if (text)
    fclose(text);
  free(line), free(metadata), free(links);
  return status;
}
