/* The results of the runs of a sweep. Results beyond a limit of memory are written to a temporary file when a run ends.
 * The verdict and the output files read them again, one run at a time. So the memory of a sweep does not grow with its
 * results.
 *
 * The file has no name, so it ends with the process. The table of a run comes before its snapshots, because most
 * readers need the table only.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <errno.h>
#include <stdlib.h>
#include <unistd.h>

#include "measure/snapshot.h"
#include "outcome.h"

/* ---- one list of the recorded data of a result, by which the bytes are counted, written and read ---- */

struct transfer {
  FILE *file; /* NULL: the bytes are counted only */
  bool reading, failed, no_memory;
  size_t bytes;
};

static void transfer_bytes(struct transfer *it, void *at, size_t size) {
  it->bytes += size;
  if (!it->file || size == 0 || it->failed)
    return;
  if (it->reading)
    it->failed = fread(at, 1, size, it->file) != size;
  else
    it->failed = fwrite(at, 1, size, it->file) != size;
}

static void transfer_table(struct transfer *it, struct nb_table *table) {
  size_t columns = table->column_count, rows = table->row_count;
  bool exists = table->names != NULL;
  transfer_bytes(it, &exists, sizeof exists);
  transfer_bytes(it, &columns, sizeof columns);
  transfer_bytes(it, &rows, sizeof rows);
  if (it->failed || !exists)
    return;
  it->no_memory = it->reading && !nb_table_create(table, columns);
  while (!it->no_memory && table->row_count < rows)
    it->no_memory = !nb_table_row(table, 0, 0, 0);
  it->failed = it->no_memory;
  transfer_bytes(it, table->names, columns * sizeof *table->names);
  transfer_bytes(it, table->units, columns * sizeof *table->units); /* addresses in this process */
  transfer_bytes(it, table->values, rows * columns * sizeof *table->values);
  transfer_bytes(it, table->stage, rows * sizeof *table->stage);
  transfer_bytes(it, table->cycle, rows * sizeof *table->cycle);
  transfer_bytes(it, table->time, rows * sizeof *table->time);
}

static void transfer_snapshots(struct transfer *it, struct nb_result *result) {
  transfer_bytes(it, &result->snapshot_count, sizeof result->snapshot_count);
  if (it->reading && !it->failed) {
    result->snapshots = calloc(result->snapshot_count + 1, sizeof *result->snapshots);
    it->failed = it->no_memory = !result->snapshots;
  }
  if (it->reading && it->failed)
    result->snapshot_count = 0; /* there are no snapshots to free */
  for (size_t k = 0; k < result->snapshot_count && !it->failed; k++) {
    struct nb_snapshot *one = &result->snapshots[k];
    transfer_bytes(it, &one->stage, sizeof one->stage);
    struct nb_table *table;
    for (size_t part = 0; (table = nb_snapshot_table_at(one, part)); part++)
      transfer_table(it, table);
  }
}

/* ---- the file ---- */

static FILE *open_file(const char *folder) {
  char path[4096];
  if (snprintf(path, sizeof path, "%s/nineball-XXXXXX", folder) >= (int)sizeof path)
    return errno = ENAMETOOLONG, NULL;
  const int file = mkstemp(path);
  FILE *stream = file < 0 ? NULL : fdopen(file, "w+");
  if (file >= 0)
    unlink(path);
  if (file >= 0 && !stream)
    close(file);
  return stream;
}

static enum nb_status cannot_write(const struct nb_results_kept *limit, struct nb_error *error) {
  return nb_error_system(error, "the results stay in memory: cannot write a temporary file in %.300s", limit->folder);
}

static void free_recorded(struct nb_result *result) {
  nb_table_free(&result->table);
  nb_result_free_snapshots(result);
}

enum nb_status nb_spool_put(struct nb_spool *spool, struct nb_page_run *run, const struct nb_results_kept *limit,
                            struct nb_error *error) {
  struct transfer count = {NULL}, out = {.file = spool->file};
  transfer_table(&count, &run->result.table), transfer_snapshots(&count, &run->result);
  if (count.bytes <= limit->bytes - spool->kept) {
    spool->kept += count.bytes;
    return NB_OK;
  }
  if (!out.file && !(out.file = spool->file = open_file(limit->folder)))
    return cannot_write(limit, error);
  if (fseek(out.file, spool->end, SEEK_SET) != 0)
    return cannot_write(limit, error);
  transfer_table(&out, &run->result.table), transfer_snapshots(&out, &run->result);
  if (out.failed || fflush(out.file) != 0)
    return clearerr(out.file), cannot_write(limit, error);
  run->spool = spool, run->at = spool->end;
  spool->end += (long)out.bytes;
  free_recorded(&run->result);
  return NB_OK;
}

/* The result of a run, from memory or from the file. The file is not read again for the run that was read last.
 * `snapshots`: the snapshots are needed, too. */
static const struct nb_result *load(const struct nb_page_run *run, bool snapshots) {
  struct nb_spool *spool = run->spool;
  if (!spool)
    return &run->result;
  if (spool->loaded_run == run && (spool->has_snapshots || !snapshots))
    return &spool->loaded;
  struct transfer in = {.file = spool->file, .reading = true};
  free_recorded(&spool->loaded);
  errno = EIO;
  in.failed = fseek(in.file, run->at, SEEK_SET) != 0;
  transfer_table(&in, &spool->loaded.table);
  if (snapshots)
    transfer_snapshots(&in, &spool->loaded);
  spool->loaded_run = in.failed ? NULL : run, spool->has_snapshots = snapshots;
  if (in.failed && !spool->error.status)
    in.no_memory ? nb_error_memory(&spool->error)
                 : nb_error_system(&spool->error, "cannot read the temporary file with the results of the runs");
  return in.failed ? &run->result : &spool->loaded;
}

const struct nb_table *nb_run_table(const struct nb_page_run *run) { return &load(run, false)->table; }
const struct nb_result *nb_run_result(const struct nb_page_run *run) { return load(run, true); }

enum nb_status nb_spool_status(const struct nb_spool *spool, struct nb_error *error) {
  if (spool->error.status)
    *error = spool->error;
  return spool->error.status;
}

void nb_spool_free(struct nb_spool *spool) {
  if (spool->file)
    fclose(spool->file);
  free_recorded(&spool->loaded);
  *spool = (struct nb_spool){0};
}
