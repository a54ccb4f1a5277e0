/* The command `report`: runs pages, draws their figures, and writes a static site about them. The site needs no server.
 * Each page is written as soon as it has run; the index is written at the end.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "report.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/clean.h"
#include "core/clock.h"
#include "input/reader.h"
#include "input/text.h"
#include "sandbox.h"

/* The largest sizes, in bytes, of a table or script that a report keeps, of a drawing that it keeps, and of report.css
 * and report.js. */
enum { TABLE_BYTES = 100000, DRAWING_BYTES = 300000, STYLE_BYTES = 100000 };

/* ---- the pages of a report ---- */

static bool is_readme(const char *path) {
  const char *name;
  return nb_page_name(path, &name) == strlen("README") && strncmp(name, "README", strlen("README")) == 0;
}

/* Sets the name of a page: the name of its file, or for a README in a folder the name of the folder. */
static void name_page(struct nb_report_page *page) {
  const char *name;
  unsigned byte;
  size_t length = nb_page_name(page->path, &name);
  if (is_readme(page->path) && page->real) {
    const char *end = strrchr(page->real, '/'), *begin = end;
    while (begin > page->real && begin[-1] != '/')
      begin--;
    if (begin < end)
      name = begin, length = (size_t)(end - begin);
  }
  snprintf(page->name, sizeof page->name, "%.*s", (int)length, name);
  nb_clean(page->name, strlen(page->name), &byte); /* no command has checked the name of the README's folder */
}

/* True if the page has no block of the page language, so that there is nothing to run. */
static bool is_document(const struct nb_page *page) {
  size_t k = 0;
  while (k < page->line_count && page->kind_of[k] == 0)
    k++;
  return page->line_count > 0 && k == page->line_count;
}

/* Reads the text of a page. For a document, and for a page that is not run, page->outcome keeps the text. */
static void survey(struct nb_report_page *page) {
  struct nb_mistakes mistakes = {0};
  struct nb_page content;
  page->real = realpath(page->path, NULL);
  name_page(page);
  if (nb_page_read(&content, page->path, &mistakes) == NB_OK) {
    snprintf(page->title, sizeof page->title, "%s", content.title);
    page->document = is_document(&content);
    if (page->document || page->unrun)
      page->outcome.page = content;
    else
      nb_page_free(&content);
  }
  nb_mistakes_free(&mistakes);
}

/* True if `folder` is the folder of a page: the report would overwrite files there. */
static bool has_page(const struct nb_report *report, const char *folder) {
  char *real = realpath(folder, NULL);
  const size_t length = real ? strlen(real) : 0;
  bool found = false;
  for (size_t k = 0; k < report->count && real && !found; k++) {
    const char *page = report->pages[k].real;
    found = page && strncmp(page, real, length) == 0 && strrchr(page, '/') == page + length;
  }
  free(real);
  return found;
}

/* False with a message if pages would overwrite each other's files, or other files, in the folder of the report. */
static bool has_own_folders(const struct nb_report *report) {
  for (size_t k = 0; k < report->count; k++) {
    const struct nb_report_page *page = &report->pages[k];
    char folder[4096];
    struct nb_error error = {NB_OK, ""};
    snprintf(folder, sizeof folder, "%.3900s/%s", report->folder, page->name);
    for (size_t j = 0; j < k; j++)
      if (strcmp(page->name, report->pages[j].name) == 0)
        nb_error_set(&error, NB_BAD_USE, "%s and %s have the same name, so the same output folder: rename one of them",
                     report->pages[j].path, page->path);
    if (strcmp(page->name, ".") == 0 || strcmp(page->name, "..") == 0)
      nb_error_set(&error, NB_BAD_USE, "%s has no name that an output folder can have: rename it", page->path);
    else if (!error.status && has_page(report, folder))
      nb_error_set(&error, NB_BAD_USE,
                   "the output folder %s of %s is a folder of pages, whose files would be overwritten: choose another "
                   "folder with -o",
                   folder, page->path);
    if (error.status)
      return nb_print_plain_error(&error), false;
  }
  return true;
}

/* ---- large files ---- */

/* Removes a file that the program has written if the file is large, and appends its name to `dropped`. */
static void drop_if_large(struct nb_report_page *page, struct nb_text *dropped, const char *folder, const char *name) {
  char path[8192];
  struct stat status;
  const off_t most = strcmp(strrchr(name, '.'), ".svg") == 0 ? DRAWING_BYTES : TABLE_BYTES;
  snprintf(path, sizeof path, "%s/%s", folder, name);
  if (lstat(path, &status) != 0 || !S_ISREG(status.st_mode) || status.st_size <= most || remove(path) != 0)
    return;
  nb_text_add(dropped, "%s%s", dropped->length > 0 ? ", " : "", name);
  if (page->drawn && strcmp(name, page->figure) == 0)
    strcpy(strrchr(page->figure, '.'), ".png");
}

/* Removes large tables, scripts and drawings, so that the report stays small. `names`: the files that were written, one
 * per line. If the SVG is removed, the figure is the PNG. */
static enum nb_status drop_large_files(struct nb_report_page *page, const char *folder, struct nb_text *names,
                                       struct nb_error *error) {
  struct nb_text dropped = {0};
  nb_text_add(names, "%s.gp\n%s.svg\n", page->outcome.page.name, page->outcome.page.name);
  char *rest = names->at;
  for (char *name; (name = strsep(&rest, "\n")) && name[0];)
    drop_if_large(page, &dropped, folder, name);
  page->dropped = dropped.at;
  return names->failed || dropped.failed ? nb_error_memory(error) : NB_OK;
}

/* ---- a page ---- */

static void write_neighbour(FILE *out, const struct nb_report_page *page, const char *relation, const char *arrow) {
  char address[4 * NB_NAME_SIZE] = "";
  nb_html_address(address, sizeof address, page->name);
  fprintf(out, "<a rel=\"%s\" href=\"../%s/index.html\">%s ", relation, address, arrow);
  nb_html_text(out, "", page->name, "</a>\n");
}

static void write_navigation(FILE *out, const struct nb_report *report, size_t k) {
  fputs("<nav><a href=\"../index.html\">contents</a>\n", out);
  if (k > 0)
    write_neighbour(out, &report->pages[k - 1], "prev", "previous:");
  if (k + 1 < report->count)
    write_neighbour(out, &report->pages[k + 1], "next", "next:");
  fputs("</nav>\n", out);
}

/* Writes the verdict, the error message and the warnings, which come before the text. */
static void write_state(FILE *out, const struct nb_report_page *page) {
  char verdict[NB_NAME_SIZE * 2];
  fprintf(out, "<p class=\"%s\">", nb_html_verdict(verdict, sizeof verdict, page));
  nb_html_text(out, "", verdict, "</p>\n");
  if (page->unrun && !page->document)
    nb_html_text(out, "<p>The report was made without running this page. To run it, type <code>nineball check ",
                 page->path, "</code>.</p>\n");
  if (page->message[0])
    nb_html_text(out, "<pre class=\"fail\">", page->message, "</pre>\n");
  for (size_t k = 0; k < page->outcome.warnings.count; k++) {
    const struct nb_warning *warning = &page->outcome.warnings.list[k];
    fputs("<p>Warning: ", out);
    if (warning->line)
      fprintf(out, "line %d: ", warning->line);
    nb_html_text(out, "", warning->text, "</p>\n");
  }
}

static void write_file(FILE *out, const struct nb_report *report, const struct nb_report_page *page, const char *name) {
  char path[8192], address[4 * NB_NAME_SIZE] = "";
  snprintf(path, sizeof path, "%.4000s/%s/%s", report->folder, page->name, name);
  if (access(path, R_OK) != 0)
    return;
  nb_html_address(address, sizeof address, name);
  fprintf(out, "<a href=\"%s\">", address);
  nb_html_text(out, "", name, "</a>\n");
}

/* Writes the cost, and links to source, figure, script and tables. They come after the text. */
static void write_files(FILE *out, const struct nb_report *report, const struct nb_report_page *page) {
  static const char *const kinds[] = {".md", ".png", ".gp"};
  if (page->cost[0])
    nb_html_text(out, "<p>Cost: ", page->cost, "</p>\n");
  fputs("<p>Files: ", out);
  for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
    char name[NB_NAME_SIZE + 8];
    snprintf(name, sizeof name, "%s%s", k == 0 ? page->name : page->outcome.page.name, kinds[k]);
    write_file(out, report, page, name);
  }
  static const char *const tables[] = {"table.tsv", "values.tsv", "verdict.tsv"};
  for (size_t k = 0; page->saved && k < sizeof tables / sizeof *tables; k++)
    write_file(out, report, page, tables[k]);
  fputs("</p>\n", out);
  if (page->dropped && page->dropped[0]) {
    nb_html_text(out, "<p>Not kept here, because they are large: ", page->dropped, ".");
    nb_html_text(out, " They are written by <code>nineball run ", page->path, "</code> and");
    nb_html_text(out, " <code>nineball figure ", page->path, "</code>.</p>\n");
  }
}

/* Writes the Markdown file beside the page, for the link to the source. */
static enum nb_status save_source(const struct nb_report_page *page, const char *folder, struct nb_error *error) {
  struct nb_save file;
  if (nb_save_begin_in(&file, error, folder, "%s.md", page->name))
    return error->status;
  for (size_t k = 0; k < page->outcome.page.line_count; k++)
    fprintf(file.file, "%s\n", page->outcome.page.lines[k]);
  return nb_save_end(&file, error);
}

static enum nb_status write_page(struct nb_report *report, size_t k, struct nb_error *error) {
  const struct nb_report_page *page = &report->pages[k];
  char folder[4096];
  struct nb_save file;
  enum nb_status status = NB_OK;
  snprintf(folder, sizeof folder, "%.3900s/%s", report->folder, page->name);
  if (nb_folder_create(folder, error) || save_source(page, folder, error) ||
      nb_save_begin_in(&file, error, folder, "index.html"))
    return error->status;
  nb_html_begin(file.file, page->title[0] ? page->title : page->name, "../", NULL);
  write_navigation(file.file, report, k);
  fputs("<main>\n", file.file);
  write_state(file.file, page);
  if (page->outcome.page.line_count && page->real)
    status = nb_report_convert(file.file, report, page, "../", false, error);
  if (status)
    nb_html_text(file.file, "<p class=\"fail\">", error->text, "</p>\n");
  write_files(file.file, report, page);
  fputs("</main>\n<footer>", file.file);
  write_navigation(file.file, report, k);
  fputs("</footer></body></html>\n", file.file);
  struct nb_error saving;
  return nb_save_end(&file, &saving) ? (*error = saving).status : status;
}

/* ---- the index ---- */

static size_t folder_length(const char *path) {
  const char *slash = strrchr(path, '/');
  return slash ? (size_t)(slash - path) : 0;
}

static bool same_folder(const char *one, const char *other) {
  const size_t length = folder_length(one);
  return length == folder_length(other) && strncmp(one, other, length) == 0;
}

/* Writes the heading of the pages of a folder: the title of its README, or the name of the folder. */
static void write_folder(FILE *out, const struct nb_report *report, size_t first) {
  const char *path = report->pages[first].path;
  const size_t length = folder_length(path);
  char name[NB_NAME_SIZE] = ".";
  const char *title = name;
  for (size_t k = 0; k < report->count; k++)
    if (is_readme(report->pages[k].path) && report->pages[k].document && same_folder(path, report->pages[k].path))
      title = report->pages[k].title;
  if (length > 0) {
    size_t begin = length;
    while (begin > 0 && path[begin - 1] != '/')
      begin--;
    snprintf(name, sizeof name, "%.*s", (int)(length - begin), path + begin);
  }
  nb_html_text(out, "<tr><th colspan=\"4\">", title, "</th></tr>\n");
}

static void write_row(FILE *out, const struct nb_report_page *page) {
  char address[4 * NB_NAME_SIZE] = "", verdict[NB_NAME_SIZE * 2];
  const char *class = nb_html_verdict(verdict, sizeof verdict, page);
  nb_html_address(address, sizeof address, page->name);
  fprintf(out, "<tr><td><a href=\"%s/index.html\">", address);
  nb_html_text(out, "", page->name, "</a></td>");
  nb_html_text(out, "<td>", page->title, "</td>");
  fprintf(out, "<td class=\"%s\">", class);
  nb_html_text(out, "", verdict, "");
  if (page->message[0])
    nb_html_text(out, "<br><small>", page->message, "</small>");
  fputs("</td>", out);
  if (page->seconds > 0)
    fprintf(out, "<td class=\"number\">%.3g s</td></tr>\n", page->seconds);
  else
    fputs("<td></td></tr>\n", out);
}

static void write_list(FILE *out, const struct nb_report *report) {
  fputs("<h2 id=\"pages-of-the-report\">All pages</h2>\n<p><label>Search names, titles and results: <input "
        "type=\"search\"></label></p>\n<p id=\"none\" hidden>No page has all of these words.</p>\n"
        "<table id=\"pages\"><thead><tr><th>page</th><th>title</th><th>checks</th><th>time</th></tr></thead><tbody>\n",
        out);
  for (size_t k = 0; k < report->count; k++) {
    if (k == 0 || !same_folder(report->pages[k - 1].path, report->pages[k].path))
      write_folder(out, report, k);
    write_row(out, &report->pages[k]);
  }
  fputs("</tbody></table>\n", out);
}

static bool is_wrong(const struct nb_report_page *page) {
  char verdict[NB_NAME_SIZE * 2];
  return strcmp(nb_html_verdict(verdict, sizeof verdict, page), "fail") == 0;
}

/* Writes the numbers of pages, checks and failures, and the pages that failed. */
static void write_summary(FILE *out, const struct nb_report *report) {
  size_t run = 0, checks = 0, failed = 0, wrong = 0;
  for (size_t k = 0; k < report->count; k++) {
    const struct nb_report_page *page = &report->pages[k];
    const size_t *count = page->outcome.mark_count;
    run += !page->document && !page->unrun, wrong += is_wrong(page);
    checks += count[NB_PASS] + count[NB_FAIL], failed += count[NB_FAIL];
  }
  fprintf(out, "<p>%zu pages were run: %zu checks, <span class=\"%s\">%zu failed</span>. ", run, checks,
          failed ? "fail" : "pass", failed);
  nb_html_text(out, "Made by nineball ", NB_VERSION,
               ". <a href=\"#pages-of-the-report\">Search and list of all pages</a></p>\n");
  if (wrong)
    fputs("<div class=\"failures\"><h2>What failed</h2><table><tbody>\n", out);
  for (size_t k = 0; k < report->count; k++)
    if (is_wrong(&report->pages[k]))
      write_row(out, &report->pages[k]);
  if (wrong)
    fputs("</tbody></table></div>\n", out);
}

static enum nb_status write_index(struct nb_report *report, struct nb_error *error) {
  const struct nb_report_page *front = report->pages[0].document ? &report->pages[0] : NULL;
  enum nb_status status = NB_OK;
  struct nb_save file;
  struct nb_error saving;
  if (nb_save_begin_in(&file, error, report->folder, "index.html"))
    return error->status;
  nb_html_begin(file.file, "nineball report", "", "report.js");
  fputs("<main>\n", file.file);
  if (!front)
    fputs("<h1>nineball report</h1>\n", file.file);
  write_summary(file.file, report);
  if (front && front->real)
    status = nb_report_convert(file.file, report, front, "", true, error);
  write_list(file.file, report);
  fputs("</main></body></html>\n", file.file);
  return nb_save_end(&file, &saving) ? (*error = saving).status : status;
}

/* Copies a file of the folder plots into the report. */
static enum nb_status copy_style(const struct nb_report *report, const char *name, struct nb_error *error) {
  char plots[4096], path[8192];
  struct nb_save file;
  size_t size;
  nb_plots_find(plots, sizeof plots, error);
  snprintf(path, sizeof path, "%s%s", plots, name);
  char *bytes = plots[0] ? nb_file_read(path, STYLE_BYTES, &size, error) : NULL;
  if (!bytes || nb_save_begin_in(&file, error, report->folder, "%s", name))
    return free(bytes), error->status;
  fwrite(bytes, 1, size, file.file);
  free(bytes);
  return nb_save_end(&file, error);
}

/* ---- the command ---- */

static void put_message(struct nb_report_page *page) {
  const struct nb_outcome *outcome = &page->outcome;
  const char *const text = outcome->mistakes.text ? outcome->mistakes.text : outcome->error.text;
  char place[NB_NAME_SIZE] = "";
  if (outcome->error.line)
    snprintf(place, sizeof place, "line %d: ", outcome->error.line);
  snprintf(page->message, sizeof page->message, "%s%.447s", place, text);
}

/* Stores the line about the cost that nb_cost_print_actual writes. */
static void put_cost(struct nb_report_page *page, double seconds, const struct nb_options *options) {
  FILE *line = fmemopen(page->cost, sizeof page->cost, "w");
  if (!line)
    return;
  nb_cost_print_actual(line, &page->outcome, seconds, options);
  fclose(line);
  page->cost[sizeof page->cost - 1] = 0;
  page->cost[strcspn(page->cost, "\n")] = 0;
}

static void add_message(struct nb_report_page *page, const struct nb_error *error) {
  nb_print_plain_error(error);
  nb_append(page->message, sizeof page->message, "%s%s", page->message[0] ? "; " : "", error->text);
}

/* Removes what print_progress has written, so that a message begins a line. */
static void remove_progress(void) {
  if (isatty(STDERR_FILENO))
    fputs("\r\033[K", stderr);
}

/* Runs one page, writes its tables, and draws its figure. */
static enum nb_status run(const struct nb_call *call, struct nb_report *report, struct nb_report_page *page) {
  struct nb_outcome *outcome = &page->outcome;
  struct nb_error error = {NB_OK, ""};
  char folder[4096];
  const double began = nb_cost_clock();
  snprintf(folder, sizeof folder, "%.3900s/%s", report->folder, page->name);
  nb_run_page(outcome, call, page->path, folder);
  remove_progress();
  nb_print_errors(outcome, page->path);
  if (outcome->status > NB_FAILED)
    put_message(page);
  if (nb_outcome_has_rows(outcome)) {
    put_cost(page, (nb_cost_clock() - began) / call->options.threads, &call->options);
    struct nb_text names = {0};
    page->saved = !nb_tables_save(outcome, folder, &names, &error);
    if (page->saved)
      nb_figure_draw(outcome, folder, call->trust, &page->drawn, &error);
    snprintf(page->figure, sizeof page->figure, "%s.svg", outcome->page.name);
    if (error.status)
      add_message(page, &error);
    if (drop_large_files(page, folder, &names, &error))
      add_message(page, &error);
    free(names.at);
  }
  for (size_t r = 0; r < outcome->run_count; r++)
    page->seconds += outcome->runs[r].result.seconds;
  nb_remove_checkpoints(outcome, nb_worse(outcome->status, error.status), call);
  nb_outcome_free_runs(outcome);
  return nb_worse(nb_outcome_is_unchecked(outcome) ? NB_BAD_USE : outcome->status, error.status);
}

static void print_line(const struct nb_report_page *page) {
  const size_t *count = page->outcome.mark_count;
  if (page->document || page->unrun || (isatty(STDOUT_FILENO) && !is_wrong(page)))
    return;
  printf("%-28s %4zu checks, %zu failed%s%s\n", page->name, count[NB_PASS] + count[NB_FAIL], count[NB_FAIL],
         page->outcome.status > NB_FAILED          ? "; did not run to its end"
         : nb_outcome_is_unchecked(&page->outcome) ? "; nothing was checked"
                                                   : "",
         page->outcome.status > NB_FAILED || !page->message[0] ? ""
         : page->saved                                         ? "; no figure"
                                                               : "; no tables");
  fflush(stdout);
}

/* Prints the page that is next, and the time left if the other pages take, on average, as long as the pages so far. */
static void print_progress(const struct nb_report *report, size_t k, double elapsed) {
  if (!isatty(STDERR_FILENO))
    return;
  fprintf(stderr, "\r\033[K%zu of %zu: %s", k + 1, report->count, report->pages[k].name);
  if (k > 0 && elapsed > 2)
    fprintf(stderr, ", about %.0f s left", elapsed * (double)(report->count - k) / (double)k);
}

static enum nb_status make(const struct nb_call *call, struct nb_report *report) {
  enum nb_status worst = NB_OK;
  struct nb_error error;
  const double began = nb_clock();
  if (nb_folder_create(report->folder, &error) || copy_style(report, "report.css", &error) ||
      copy_style(report, "report.js", &error))
    return nb_print_plain_error(&error);
  for (size_t k = 0; k < report->count; k++) {
    struct nb_report_page *page = &report->pages[k];
    print_progress(report, k, nb_clock() - began);
    if (!page->document && !page->unrun) {
      page->unrun = nb_is_stopped(&call->options); /* a page that follows an interrupted one is not run */
      worst = nb_worse(worst, page->unrun ? NB_BROKEN : run(call, report, page));
    }
    if (write_page(report, k, &error))
      add_message(page, &error), worst = nb_worse(worst, error.status);
    print_line(page);
  }
  remove_progress();
  if (write_index(report, &error))
    worst = nb_worse(worst, nb_print_plain_error(&error));
  printf("look at %s/index.html\n", report->folder);
  return worst;
}

enum nb_status nb_command_report(const struct nb_call *call) {
  size_t unrun = 0;
  while (call->unrun[unrun])
    unrun++;
  struct nb_report report = {.folder = call->folder ? call->folder : "report",
                             .count = call->page_count + unrun,
                             .trust = call->trust,
                             .pages = calloc(call->page_count + unrun, sizeof *report.pages)};
  char pandoc[NB_CONFINE_PATH];
  struct nb_error error;
  enum nb_status status = NB_BAD_USE;
  if (!report.pages)
    return nb_error_memory(&error), nb_print_plain_error(&error);
  for (size_t k = 0; k < report.count; k++) {
    report.pages[k].unrun = k >= call->page_count;
    report.pages[k].path = k < call->page_count ? call->pages[k] : call->unrun[k - call->page_count];
    survey(&report.pages[k]);
  }
  if (!nb_program_find(pandoc, sizeof pandoc, "pandoc"))
    fputs("nineball: a report needs pandoc, which was not found (its package is pandoc)\n", stderr);
  else if (has_own_folders(&report))
    status = make(call, &report);
  for (size_t k = 0; k < report.count; k++) {
    nb_outcome_free(&report.pages[k].outcome);
    free(report.pages[k].real), free(report.pages[k].dropped);
  }
  for (size_t k = 0; k < report.file_count; k++)
    free(report.files[k].real), free(report.files[k].name);
  free(report.files), free(report.pages);
  return status;
}
