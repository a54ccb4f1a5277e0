/* A page's figure: its gnuplot block, behind everything that was seen and known, as one script that can be read, changed and run
 * again by hand.
 *
 *   $table      the rows, for gnuplot's `using 'time/s':'C.normal/N'`; with a sweep $table_1, $table_2, … one a run
 *   $values     one row a run: swept values, measures seen and known
 *   runs        how many; run[i] is "v=0.12"
 *   NAME        each measure by name, C_normal_mean, and all that is known, known_C_normal_mean; of a sweep run by run, …_1, …_2
 *   $STAGE_bodies, $STAGE_walls, $STAGE_contacts   snapshots, with a sweep …_1, …_2; of a path $LEG_traction, $LEG_pieces;
 *   $STAGE_body_averages, $STAGE_contact_averages, of regions $STAGE_types, $STAGE_rings;
 *   of `snapshot from` $STAGE_lattice
 *   plots       folder of the recipes: load plots.'force-rectangles.gp'
 *   canvas(w, h)   a size of its own, of style.gp: eval canvas(1100, 760)
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#define _POSIX_C_SOURCE 200809L

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "state/save.h"
#include "tables.h"

extern char **environ;

static bool has_figure(const struct nb_page *page) {
  for (size_t k = 0; k < page->line_count; k++)
    if (page->kind_of[k] == 1 + NB_BLOCK_GNUPLOT)
      return true;
  return false;
}

/* A name that gnuplot takes: C.normal at 40 cycles, _3 -> C_normal_at_40_cycles_3. */
static void variable(char *text, size_t size, const char *prefix, const char *label, const char *number) {
  snprintf(text, size, "%s%s%s", prefix, label, number);
  for (char *c = text; *c; c++)
    if (!isalnum((unsigned char)*c))
      *c = '_';
}

static void write_number(FILE *out, const char *name, double value) {
  if (isfinite(value))
    fprintf(out, "%s = %.17g\n", name, value);
  else
    fprintf(out, "%s = NaN\n", name);
}

static void write_measures(FILE *out, const struct nb_page_run *run, const char *number) {
  char name[4 * NB_NAME_SIZE];
  for (size_t k = 0; k < run->expectations.count; k++) {
    const struct nb_expectation *e = &run->expectations.list[k];
    struct nb_error error;
    double seen;
    if (e->kind == NB_ALONG)
      continue;
    variable(name, sizeof name, "", e->measure.label, number);
    if (nb_measure_seen(&seen, &e->measure, &run->result.table, &error))
      write_number(out, name, seen);
  }
  for (size_t k = 0; k < run->known.value_count; k++) {
    variable(name, sizeof name, "known_", run->known.values[k].name, number);
    write_number(out, name, run->known.values[k].value);
  }
}

static void write_run(FILE *out, const struct nb_outcome *outcome, size_t r) {
  const struct nb_page_run *run = &outcome->runs[r];
  char number[32] = "";
  if (outcome->run_count > 1)
    snprintf(number, sizeof number, "_%zu", r + 1);
  write_measures(out, &outcome->runs[r], number);
  fprintf(out, "$table%s << EOD\n", number);
  nb_table_write_run(out, run);
  fputs("EOD\n", out);
  for (size_t k = 0; k < run->result.snapshot_count; k++) {
    const struct nb_snapshot *snapshot = &run->result.snapshots[k];
    const struct nb_table *table;
    const char *part;
    for (int t = 0; nb_snapshot_part(snapshot, t, &part, &table); t++) {
      char stage[NB_NAME_SIZE];
      variable(stage, sizeof stage, "", run->scene.stages[snapshot->stage].name, "");
      fprintf(out, "$%s_%s%s << EOD\n", stage, part, number);
      nb_table_write(out, table);
      fputs("EOD\n", out);
    }
  }
}

static bool copy_file(FILE *out, const char *path) {
  FILE *in = fopen(path, "r");
  if (!in)
    return false;
  char buffer[4096];
  size_t n;
  while ((n = fread(buffer, 1, sizeof buffer, in)) > 0)
    fwrite(buffer, 1, n, out);
  fclose(in);
  return true;
}

/* The folder of style and recipes: beside the page's own folder, in a source tree as in an installed one; else the installed. */
static void find_plots(char *text, size_t size, const char *page) {
  const char *slash = strrchr(page, '/');
  char style[4096];
  snprintf(text, size, "%.*s../plots/", slash ? (int)(slash - page) + 1 : 0, page);
  snprintf(style, sizeof style, "%.4000sstyle.gp", text);
  if (access(style, R_OK) != 0)
    snprintf(text, size, "%s/plots/", NB_DATADIR);
}

static void write_script(FILE *out, const struct nb_outcome *outcome) {
  const struct nb_page *page = &outcome->page;
  char plots[4000], style[4096];
  find_plots(plots, sizeof plots, page->path);
  snprintf(style, sizeof style, "%sstyle.gp", plots);
  fprintf(out, "# %s, drawn from page %s, FNV-1a %016llx, by nineball %s\n", page->title, page->name, page->hash,
          NB_VERSION);
  fprintf(out, "plots = '%s'\n", plots);
  if (!copy_file(out, style))
    fputs("set datafile separator tab columnheaders\n", out);
  fprintf(out, "runs = %zu\narray run[runs]\n", outcome->run_count);
  for (size_t r = 0; r < outcome->run_count; r++)
    fprintf(out, "run[%zu] = \"%s\"\n", r + 1, outcome->runs[r].label);
  fputs("$values << EOD\n", out);
  nb_values_write(out, outcome);
  fputs("EOD\n", out);
  for (size_t r = 0; r < outcome->run_count; r++)
    write_run(out, outcome, r);
  for (size_t k = 0; k < page->line_count; k++)
    if (page->kind_of[k] == 1 + NB_BLOCK_GNUPLOT)
      fprintf(out, "%s\n", page->lines[k]);
}

/* gnuplot with one -e, then the script; its messages are for the user. */
static enum nb_status run_gnuplot(const char *settings, const char *script, struct nb_error *error) {
  char *arguments[] = {"gnuplot", "-e", (char *)settings, (char *)script, NULL};
  pid_t child;
  int status;
  const int problem = posix_spawnp(&child, "gnuplot", NULL, NULL, arguments, environ);
  if (problem)
    return nb_error_set(error, NB_BAD_USE, "gnuplot cannot be run: %s (its package is gnuplot-nox)", strerror(problem));
  while (waitpid(child, &status, 0) < 0 && errno == EINTR)
    continue;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
    return NB_OK;
  return nb_error_set(error, NB_BAD_USE, "gnuplot did not like %s; its message is above", script);
}

enum nb_status nb_figure_draw(const struct nb_outcome *outcome, const char *folder, bool *drawn,
                              struct nb_error *error) {
  const char *name = outcome->page.name;
  char script[4096], settings[5000];
  struct nb_save file;
  *drawn = false;
  if (!has_figure(&outcome->page))
    return NB_OK;
  if (nb_save_folder(folder, error))
    return error->status;
  if ((size_t)snprintf(script, sizeof script, "%s/%s.gp", folder, name) >= sizeof script)
    return nb_error_set(error, NB_BAD_USE, "the name of the folder is too long: %.200s…", folder);
  if (nb_save_begin(&file, script, error))
    return error->status;
  write_script(file.file, outcome);
  if (nb_save_end(&file, error))
    return error->status;
  static const char *const terminals[][2] = {{"svg font 'sans,13' background 'white'", "svg"},
                                             {"pngcairo font 'sans,11'", "png"}};
  for (size_t k = 0; k < sizeof terminals / sizeof *terminals; k++) {
    snprintf(settings, sizeof settings, "terminal = \"%s\"; set terminal %s size 840,560; set output \"%s/%s.%s\"",
             terminals[k][0], terminals[k][0], folder, name, terminals[k][1]);
    if (run_gnuplot(settings, script, error))
      return error->status;
  }
  *drawn = true;
  return NB_OK;
}
