/* The figure of a page: one gnuplot script with the style, the tables and values of all runs, and the gnuplot blocks of
 * the page. The script can be edited and run by hand. `nineball --help gnuplot` (manual.c) lists the variables and data
 * that the script defines.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "commands.h"
#include "input/reader.h"
#include "measure/snapshot.h"

enum { STYLE_MAX = 1 << 20 }; /* largest size of style.gp, bytes */

/* The commands for gnuplot. They are constant, so that no text of a page is among the arguments of gnuplot. */
#define SETTINGS(terminal) "terminal = \"" terminal "\"; set terminal " terminal " size 840,560"

bool nb_page_has_figure(const struct nb_page *page) {
  for (size_t k = 0; k < page->line_count; k++)
    if (page->kind_of[k] == 1 + NB_BLOCK_GNUPLOT)
      return true;
  return false;
}

/* The character of a name of gnuplot for a character of a label. */
static char name_character(char c) { return isalnum((unsigned char)c) ? c : '_'; }

/* Writes a label as a valid name of gnuplot: C_normal_at_40_cycles for `C.normal at 40 cycles`. */
static void write_name(FILE *out, const char *label) {
  for (const char *c = label; *c; c++)
    fputc(name_character(*c), out);
}

/* gnuplot truncates names of more characters, so that two of them could become equal. Their values are left out. */
enum { VARIABLE_MAX = 49 };

static void write_value(FILE *out, const char *prefix, const char *label, const char *number, double value) {
  if (strlen(prefix) + strlen(label) + strlen(number) > VARIABLE_MAX)
    return;
  fputs(prefix, out);
  write_name(out, label);
  fprintf(out, isfinite(value) ? "%s = %.17g\n" : "%s = NaN\n", number, value);
}

static void write_measures(FILE *out, const struct nb_page_run *run, const char *number) {
  for (size_t k = 0; k < run->expectations.count; k++) {
    const struct nb_expectation *e = &run->expectations.list[k];
    struct nb_error error;
    double computed;
    if (e->kind != NB_VERSUS && nb_measure_value(&computed, &e->measure, nb_run_table(run), &error))
      write_value(out, "", e->measure.label, number, computed);
  }
  for (size_t k = 0; k < run->solution.value_count; k++)
    write_value(out, "reference_", run->solution.values[k].name, number, run->solution.values[k].value);
}

static bool has_sweep(const struct nb_scene *scene) {
  size_t k = 0;
  while (k < scene->binding_count && scene->bindings[k].sweep < 0)
    k++;
  return k < scene->binding_count;
}

/* Writes the values and tables of a run. If the page has a sweep, their names end in the number of the run. They do so
 * even if --set leaves only one value of the sweep, because the gnuplot blocks of the page use these names. */
static void write_run(FILE *out, const struct nb_outcome *outcome, size_t r) {
  const struct nb_page_run *run = &outcome->runs[r];
  char number[32] = "";
  if (has_sweep(&run->scene))
    snprintf(number, sizeof number, "_%zu", r + 1);
  write_measures(out, run, number);
  fprintf(out, "$table%s << EOD\n", number);
  nb_table_write_run(out, run);
  fputs("EOD\n", out);
  const struct nb_result *result = nb_run_result(run);
  for (size_t k = 0; k < result->snapshot_count; k++) {
    const struct nb_snapshot *snapshot = &result->snapshots[k];
    const struct nb_table *table;
    const char *part;
    for (int t = 0; nb_snapshot_part(snapshot, t, &part, &table); t++) {
      fputc('$', out);
      write_name(out, run->scene.stages[snapshot->stage].name);
      fprintf(out, "_%s%s << EOD\n", part, number);
      nb_table_write(out, table);
      fputs("EOD\n", out);
    }
  }
}

void nb_plots_find(char *plots, size_t size, struct nb_error *error) {
  char program[2048], style[4096];
  const ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
  program[length > 0 ? length : 0] = 0;
  char *slash = strrchr(program, '/');
  if (slash)
    *slash = 0;
  const char *const places[][2] = {{program, "/plots"}, {program, "/../share/nineball/plots"}, {NB_DATADIR, "/plots"}};
  plots[0] = 0;
  for (size_t k = slash ? 0 : 2; k < sizeof places / sizeof *places && !plots[0]; k++) {
    snprintf(style, sizeof style, "%s%s/style.gp", places[k][0], places[k][1]);
    char *real = realpath(style, NULL);
    if (real)
      snprintf(plots, size, "%.*s", (int)(strrchr(real, '/') - real + 1), real);
    free(real);
  }
  if (!plots[0])
    nb_error_set(error, NB_BAD_USE,
                 "the style of figures, plots/style.gp, is neither beside the program nor in %s/plots", NB_DATADIR);
}

/* Writes NAME = 'TEXT'. Gnuplot interprets nothing in single quotes; a quote in the text is doubled. */
static void write_quoted(FILE *out, const char *name, const char *text) {
  static const struct nb_escape quote[] = {{'\'', "''"}, {0, NULL}};
  fprintf(out, "%s = '", name);
  nb_print_escaped(out, text, quote);
  fputs("'\n", out);
}

/* Writes the values of all runs, and the gnuplot blocks of the page. */
static void write_page_figure(FILE *out, const struct nb_outcome *outcome, const void *data) {
  const struct nb_page *page = &outcome->page;
  (void)data;
  if (outcome->status > NB_FAILED)
    fputs("set label 9999 'INCOMPLETE: the run was stopped' at screen 0.99, screen 0.98 right noenhanced front tc rgb "
          "'#a3123a'\n",
          out);
  fprintf(out, "runs = %zu\narray run[runs]\n", outcome->run_count);
  for (size_t r = 0; r < outcome->run_count; r++) {
    char name[32];
    snprintf(name, sizeof name, "run[%zu]", r + 1);
    write_quoted(out, name, outcome->runs[r].label);
  }
  fputs("$values << EOD\n", out);
  nb_values_write(out, outcome);
  fputs("EOD\n", out);
  for (size_t r = 0; r < outcome->run_count; r++)
    write_run(out, outcome, r);
  for (size_t k = 0; k < page->line_count; k++)
    if (page->kind_of[k] == 1 + NB_BLOCK_GNUPLOT) {
      if (page->kind_of[k - 1] != page->kind_of[k]) /* the first line of a block; the line before it is the fence */
        fprintf(out, NB_PAGE_LINE "\n", k + 1);
      fprintf(out, "%s\n", page->lines[k]);
    }
}

static enum nb_status save_script(const struct nb_script *script, const char *folder, const char *plots,
                                  struct nb_error *error) {
  char path[4096];
  size_t size;
  struct nb_save file;
  snprintf(path, sizeof path, "%.4000sstyle.gp", plots);
  char *style = nb_file_read(path, STYLE_MAX, &size, error);
  if (!style)
    return error->status == NB_NO_MEMORY ? NB_NO_MEMORY : nb_error_set(error, NB_BAD_USE, "cannot read %.300s", path);
  enum nb_status status = nb_save_begin_in(&file, error, folder, "%s.gp", script->name);
  if (!status) {
    fprintf(file.file, "# %s\n", script->outcome->page.title);
    nb_preamble_write(file.file, script->outcome);
    write_quoted(file.file, "plots", plots);
    fputs(style, file.file);
    script->write(file.file, script->outcome, script->data);
    status = nb_outcome_save_end(script->outcome, &file, error);
  }
  free(style);
  return status;
}

/* Draws FOLDER/NAME.KIND with one terminal of gnuplot. `magic`: the first bytes of a file of this kind. */
static enum nb_status draw(struct nb_gnuplot *drawing, const char *kind, const char *magic, struct nb_error *error) {
  char begin[8] = "";
  struct nb_save file;
  if (nb_save_begin_in(&file, error, drawing->folder, "%s.%s", drawing->name, kind))
    return error->status;
  drawing->figure = fileno(file.file);
  enum nb_status status = nb_gnuplot_run(drawing, error);
  if (!status && (pread(drawing->figure, begin, strlen(magic), 0) < 0 || strcmp(begin, magic) != 0))
    status = nb_error_set(error, NB_BAD_USE, "%.200s/%s.gp draws nothing", drawing->folder, drawing->name);
  return status ? nb_save_cancel(&file), status : nb_save_end(&file, error);
}

enum nb_status nb_script_draw(const struct nb_script *script, const char *folder, bool trust, struct nb_error *error) {
  char plots[4096];
  nb_plots_find(plots, sizeof plots, error);
  if (!plots[0] || nb_folder_create(folder, error) || save_script(script, folder, plots, error))
    return error->status;
  struct nb_gnuplot drawing = {.folder = folder, .name = script->name, .recipes = plots, .trust = trust};
  drawing.commands = SETTINGS("svg font 'sans,13' background 'white'"), drawing.verbose = true;
  if (draw(&drawing, "svg", "<?xml", error))
    return error->status;
  drawing.commands = SETTINGS("pngcairo font 'sans,11'"), drawing.verbose = false;
  return draw(&drawing, "png", "\x89PNG", error);
}

/* The first line of a gnuplot block that draws the contacts of this snapshot; 0: none. A sweep adds `_1`, … to the name. */
static size_t line_of_contacts(const struct nb_page *page, const char *stage) {
  for (size_t k = 0; k < page->line_count; k++) {
    const char *at = page->kind_of[k] == 1 + NB_BLOCK_GNUPLOT ? page->lines[k] : "";
    while ((at = strchr(at, '$'))) {
      size_t n = 0;
      for (at++; stage[n] && at[n] == name_character(stage[n]); n++)
        ;
      if (!stage[n] && strncmp(at + n, "_contacts", strlen("_contacts")) == 0)
        return k + 1;
    }
  }
  return 0;
}

/* Warns of a contact network without contacts, which a figure draws as particles alone. The results of a sweep are read
 * from the temporary file only if the figure draws contacts. */
static void warn_of_no_contacts(const struct nb_outcome *outcome) {
  const struct nb_scene *const scene = &outcome->runs[0].scene;
  size_t last = 0;
  bool draws = false;
  for (size_t s = 0; s < scene->stage_count; s++)
    draws = draws || line_of_contacts(&outcome->page, scene->stages[s].name);
  for (size_t r = 0; r < outcome->run_count && draws; r++) {
    const struct nb_page_run *run = &outcome->runs[r];
    const struct nb_result *result = nb_run_result(run);
    for (size_t k = 0; k < result->snapshot_count; k++) {
      const char *const stage = run->scene.stages[result->snapshots[k].stage].name;
      const size_t line = result->snapshots[k].contacts.row_count ? 0 : line_of_contacts(&outcome->page, stage);
      if (line > last) {
        fprintf(stderr,
                "%s:%zu: warning: the figure draws no contact network: at the end of stage `%s` nothing touches\n",
                outcome->page.path, line, stage);
        last = line;
      }
    }
  }
}

enum nb_status nb_figure_draw(const struct nb_outcome *outcome, const char *folder, bool trust, bool *drawn,
                              struct nb_error *error) {
  const struct nb_script script = {outcome->page.name, outcome, write_page_figure, NULL};
  *drawn = false;
  if (!nb_page_has_figure(&outcome->page))
    return NB_OK;
  warn_of_no_contacts(outcome);
  const enum nb_status status = nb_script_draw(&script, folder, trust, error);
  *drawn = !status;
  return status;
}
