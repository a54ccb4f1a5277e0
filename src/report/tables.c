/* Tables as tab-separated text: preamble lines that begin with `#`, one head row `name/unit`, and rows of numbers. In
 * table.tsv a row also has the name of its stage, and verdict.tsv has texts. Computed numbers are written by %.17g, so
 * that the same double is read back.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdarg.h>
#include <string.h>

#include "commands.h"
#include "input/hash.h"
#include "input/reader.h"
#include "measure/snapshot.h"

static const char *unit_word(const char *unit, bool unitless) {
  return unitless || strcmp(unit, "1") == 0 ? "-" : unit;
}

void nb_preamble_write(FILE *out, const struct nb_outcome *outcome) {
  fprintf(out, "# nineball %s\n# page %s", NB_VERSION, outcome->page.name);
  unsigned long long hash = outcome->page.hash;
  for (size_t k = 0; outcome->settings && outcome->settings[k]; k++) {
    hash = nb_hash(hash, outcome->settings[k], strlen(outcome->settings[k]) + 1);
    fprintf(out, ", %s", outcome->settings[k]);
  }
  fprintf(out, ", FNV-1a %016llx\n", hash);
  if (outcome->status > NB_FAILED)
    fprintf(out, "# incomplete: %s\n", outcome->error.text);
}

/* Writes the swept values, or their names: "0.12 m/s" becomes 0.12 in the column v/m/s. A sweep that --set reduces to
 * one value keeps its column, because figures use it. */
static void write_swept_values(FILE *out, const struct nb_page_run *run, bool names) {
  for (size_t k = 0; k < run->scene.binding_count; k++) {
    const struct nb_binding *binding = &run->scene.bindings[k];
    const int digits = (int)strcspn(binding->text, " ");
    const char *unit = binding->text[digits] ? binding->text + digits + 1 : "-";
    if (binding->sweep >= 0 && names)
      fprintf(out, "%s/%s\t", binding->name, unit);
    else if (binding->sweep >= 0)
      fprintf(out, "%.*s\t", digits, binding->text);
  }
}

static void write_head(FILE *out, const struct nb_page_run *run) {
  const struct nb_table *table = nb_run_table(run);
  if (!table->names)
    return; /* the run was not started because another one failed */
  fputs("stage", out);
  for (size_t c = 0; c < table->column_count; c++)
    fprintf(out, "\t%s/%s", table->names[c], unit_word(table->units[c], run->scene.unitless));
  for (size_t k = 0; k < run->expectations.count; k++) {
    const struct nb_expectation *e = &run->expectations.list[k];
    if (e->kind == NB_VERSUS)
      fprintf(out, "\treference %s/%s", table->names[e->measure.column],
              unit_word(table->units[e->measure.column], run->scene.unitless));
  }
  fputc('\n', out);
}

static void write_row(FILE *out, const struct nb_page_run *run, size_t r) {
  const struct nb_table *table = nb_run_table(run);
  const double *values = table->values + r * table->column_count;
  fputs(run->scene.stages[table->stage[r]].name, out);
  for (size_t c = 0; c < table->column_count; c++)
    fprintf(out, "\t%.17g", values[c]);
  for (size_t k = 0; k < run->expectations.count; k++) {
    const struct nb_expectation *e = &run->expectations.list[k];
    if (e->kind != NB_VERSUS)
      continue;
    const struct nb_solution_curve *curve =
        solution_find_curve(&run->solution, table->names[e->measure.column], e->against);
    fprintf(out, "\t%.17g", curve ? curve->at(curve->data, values[e->column]) : NAN);
  }
  fputc('\n', out);
}

void nb_table_write_run(FILE *out, const struct nb_page_run *run) {
  write_head(out, run);
  for (size_t r = 0; r < nb_run_table(run)->row_count; r++)
    write_row(out, run, r);
}

void nb_table_write(FILE *out, const struct nb_table *table) {
  for (size_t c = 0; c < table->column_count; c++)
    fprintf(out, "%s%s/%s", c ? "\t" : "", table->names[c], unit_word(table->units[c], false));
  fputc('\n', out);
  for (size_t r = 0; r < table->row_count; r++)
    for (size_t c = 0; c < table->column_count; c++)
      fprintf(out, "%.17g%c", table->values[r * table->column_count + c], c + 1 < table->column_count ? '\t' : '\n');
}

static void write_all_runs(FILE *out, const struct nb_outcome *outcome) {
  for (size_t r = 0; r < outcome->run_count; r++) {
    const struct nb_page_run *run = &outcome->runs[r];
    if (r == 0) {
      write_swept_values(out, run, true);
      write_head(out, run);
    }
    for (size_t k = 0; k < nb_run_table(run)->row_count; k++) {
      write_swept_values(out, run, false);
      write_row(out, run, k);
    }
  }
}

/* ---- values ---- */

/* True if the expectation gets a column: it has a single value, and no earlier expectation with a single value has the
 * same label. */
static bool first_of_its_name(const struct nb_expectations *expectations, size_t index) {
  for (size_t k = 0; k < index; k++)
    if (expectations->list[k].kind != NB_VERSUS &&
        strcmp(expectations->list[k].measure.label, expectations->list[index].measure.label) == 0)
      return false;
  return expectations->list[index].kind != NB_VERSUS;
}

/* The reference of expectation `index`: the value that the reference solution returns; or else the value that this or a
 * later expectation with the same label gives; or else 0 for a residual. NaN: there is none. */
static double reference_of(const struct nb_page_run *run, size_t index) {
  const struct nb_expectation *const list = run->expectations.list;
  const double *solution = nb_measure_solution(&list[index].measure, &run->solution);
  struct nb_error error;
  if (solution)
    return *solution;
  for (size_t k = index; k < run->expectations.count; k++) {
    double scale = 1;
    if (list[k].kind == NB_EXPECTED && strcmp(list[k].measure.label, list[index].measure.label) == 0 &&
        (!list[k].has_scale || nb_measure_value(&scale, &list[k].other, nb_run_table(run), &error)))
      return list[k].number * scale;
  }
  return list[index].measure.is_residual ? 0 : NAN;
}

void nb_values_write(FILE *out, const struct nb_outcome *outcome) {
  for (size_t r = 0; r < outcome->run_count; r++) {
    const struct nb_page_run *run = &outcome->runs[r];
    const struct nb_expectations *all = &run->expectations;
    if (r == 0) {
      write_swept_values(out, run, true);
      fputs("run", out);
      for (size_t k = 0; k < all->count; k++)
        if (first_of_its_name(all, k)) {
          const char *unit = unit_word(all->list[k].measure.unit, run->scene.unitless);
          fprintf(out, "\t%s/%s\treference %s/%s", all->list[k].measure.label, unit, all->list[k].measure.label, unit);
        }
      fputc('\n', out);
    }
    write_swept_values(out, run, false);
    fprintf(out, "%zu", r + 1);
    for (size_t k = 0; k < all->count; k++) {
      struct nb_error error;
      double computed;
      if (!first_of_its_name(all, k))
        continue;
      nb_measure_value(&computed, &all->list[k].measure, nb_run_table(run), &error);
      fprintf(out, "\t%.17g\t%.17g", computed, reference_of(run, k));
    }
    fputc('\n', out);
  }
}

static void write_verdict(FILE *out, const struct nb_outcome *outcome) {
  fputs("verdict\tline\texpected\tcomputed\n", out);
  for (size_t k = 0; k < outcome->check_count; k++) {
    const struct nb_check *check = &outcome->checks[k];
    fprintf(out, "%s\t%d\t%s\t%s\n", nb_mark_word(check->mark), check->line, check->label, check->message);
  }
}

/* ---- files ---- */

enum nb_status nb_save_begin_in(struct nb_save *file, struct nb_error *error, const char *folder, const char *format,
                                ...) {
  char path[4096];
  va_list name;
  const size_t length = (size_t)snprintf(path, sizeof path, "%s/", folder), left = sizeof path - length;
  va_start(name, format);
  const bool fits = length < sizeof path && (size_t)vsnprintf(path + length, left, format, name) < left;
  va_end(name);
  if (!fits)
    return nb_error_set(error, NB_BAD_USE, "the name of the folder is too long: %.200s…", folder);
  return nb_save_begin(file, path, error);
}

enum nb_status nb_outcome_save_end(const struct nb_outcome *outcome, struct nb_save *file, struct nb_error *error) {
  if (nb_spool_status(&outcome->spool, error))
    return nb_save_cancel(file), error->status;
  return nb_save_end(file, error);
}

static enum nb_status save(const char *folder, const char *name, void (*write)(FILE *, const struct nb_outcome *),
                           const struct nb_outcome *outcome, struct nb_text *names, struct nb_error *error) {
  struct nb_save file;
  nb_text_add(names, "%s\n", name);
  if (nb_save_begin_in(&file, error, folder, "%s", name))
    return error->status;
  nb_preamble_write(file.file, outcome);
  write(file.file, outcome);
  return nb_outcome_save_end(outcome, &file, error);
}

static enum nb_status save_snapshot(const struct nb_outcome *outcome, size_t r, const struct nb_snapshot *snapshot,
                                    const char *folder, struct nb_text *names, struct nb_error *error) {
  const struct nb_page_run *run = &outcome->runs[r];
  const struct nb_table *table;
  const char *part;
  char number[32] = "", name[3 * NB_NAME_SIZE];
  if (outcome->run_count > 1)
    snprintf(number, sizeof number, "-%zu", r + 1);
  for (int k = 0; nb_snapshot_part(snapshot, k, &part, &table); k++) {
    struct nb_save file;
    snprintf(name, sizeof name, "%s-%s%s.tsv", run->scene.stages[snapshot->stage].name, part, number);
    nb_text_add(names, "%s\n", name);
    if (nb_save_begin_in(&file, error, folder, "%s", name))
      return error->status;
    nb_preamble_write(file.file, outcome);
    if (run->label[0])
      fprintf(file.file, "# run %s\n", run->label);
    nb_table_write(file.file, table);
    if (nb_save_end(&file, error))
      return error->status;
  }
  return NB_OK;
}

static enum nb_status save_snapshots(const struct nb_outcome *outcome, size_t r, const char *folder,
                                     struct nb_text *names, struct nb_error *error) {
  const struct nb_result *result = nb_run_result(&outcome->runs[r]);
  for (size_t k = 0; k < result->snapshot_count; k++)
    if (save_snapshot(outcome, r, &result->snapshots[k], folder, names, error))
      return error->status;
  return nb_spool_status(&outcome->spool, error);
}

enum nb_status nb_tables_save(const struct nb_outcome *outcome, const char *folder, struct nb_text *names,
                              struct nb_error *error) {
  if (nb_folder_create(folder, error) || save(folder, "table.tsv", write_all_runs, outcome, names, error) ||
      save(folder, "values.tsv", nb_values_write, outcome, names, error) ||
      save(folder, "verdict.tsv", write_verdict, outcome, names, error))
    return error->status;
  for (size_t r = 0; r < outcome->run_count; r++)
    if (save_snapshots(outcome, r, folder, names, error))
      return error->status;
  return names->failed ? nb_error_memory(error) : NB_OK;
}
