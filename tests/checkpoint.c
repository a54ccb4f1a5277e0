/* Every page interrupted after its first cycle, in the middle and at the end of a stage, and continued from the
 * checkpoint: all that the run returns is that of the run without interruption, to the last bit.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#define _POSIX_C_SOURCE 200809L

#include <CUnit/CUnit.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../src/measure/snapshot.h"
#include "../src/run/checkpoint.h"
#include "every_page.h"
#include "suites.h"
#include "written.h"

static char folder[] = "/tmp/nineball-checkpoint-XXXXXX";

static struct nb_options options_of(unsigned long stop_after, bool resume, int threads) {
  return (struct nb_options){.threads = threads,
                             .states = folder,
                             .checkpoint = {.seconds = 1e9, .resume = resume, .stop_after = stop_after, .key = 1}};
}

static bool same_table(const struct nb_table *a, const struct nb_table *b) {
  const size_t rows = a->row_count, numbers = rows * a->column_count;
  if (rows != b->row_count || a->column_count != b->column_count)
    return false;
  return rows == 0 || ((numbers == 0 || memcmp(a->values, b->values, numbers * sizeof *a->values) == 0) &&
                       memcmp(a->cycle, b->cycle, rows * sizeof *a->cycle) == 0 &&
                       memcmp(a->time, b->time, rows * sizeof *a->time) == 0 &&
                       memcmp(a->stage, b->stage, rows * sizeof *a->stage) == 0);
}

static bool same_snapshots(const struct nb_result *a, const struct nb_result *b) {
  bool same = a->snapshot_count == b->snapshot_count;
  for (size_t k = 0; same && k < a->snapshot_count; k++) {
    const char *name, *other;
    const struct nb_table *one, *two;
    bool more = true;
    same = a->snapshots[k].stage == b->snapshots[k].stage;
    for (int part = 0; same && more; part++) {
      more = nb_snapshot_part(&a->snapshots[k], part, &name, &one);
      same = nb_snapshot_part(&b->snapshots[k], part, &other, &two) == more && (!more || same_table(one, two));
    }
  }
  return same;
}

/* The name of the first thing that differs; NULL: nothing. */
static const char *difference(const struct nb_scene *scene, const struct nb_result *a, const struct nb_result *b) {
  static char column[1024];
  const struct nb_table *one = &a->table, *two = &b->table;
  for (size_t k = 0; k < one->row_count * one->column_count && one->row_count == two->row_count; k++)
    if (memcmp(&one->values[k], &two->values[k], sizeof *one->values) != 0) {
      snprintf(column, sizeof column, "%s at cycle %.0f: %.17g instead of %.17g",
               scene->columns[k % one->column_count].name, one->cycle[k / one->column_count], two->values[k],
               one->values[k]);
      return column;
    }
  for (size_t s = 0; s < scene->stage_count; s++)
    if (a->stages[s].cycles != b->stages[s].cycles || a->stages[s].updates != b->stages[s].updates ||
        a->stages[s].step != b->stages[s].step)
      return "the cost of a stage";
  if (a->warnings.count != b->warnings.count ||
      memcmp(a->warnings.list, b->warnings.list, a->warnings.count * sizeof *a->warnings.list) != 0)
    return "the warnings";
  return !same_table(one, two)                                             ? "the table"
         : !same_snapshots(a, b)                                           ? "a snapshot"
         : a->cycles != b->cycles                                          ? "the number of cycles"
         : a->updates != b->updates                                        ? "the contact updates"
         : a->searches != b->searches                                      ? "the number of searches"
         : a->deep != b->deep || strcmp(a->deep_first, b->deep_first) != 0 ? "the deep overlaps"
                                                                           : NULL;
}

/* Runs the scene up to a cycle, from the last checkpoint; 0: to its end. */
static enum nb_status session(struct nb_result *result, const struct nb_scene *scene, unsigned long from,
                              unsigned long to, int threads, struct nb_error *error) {
  const struct nb_options options = options_of(to ? to - from : 0, from > 0, threads);
  return nb_run(result, scene, &options, NULL, error);
}

/* In four sessions, on one thread and on two. */
static void interrupt_page(struct nb_scene *scene, const char *name) {
  struct nb_error error = {NB_OK, ""};
  struct nb_result whole, result;
  if (scene->contact_test || scene->start.stages > 0)
    return;
  for (size_t s = 0; s < scene->stage_count; s++)
    scene->stages[s].record_interval = 1;
  const enum nb_status wanted = nb_run(&whole, scene, &(struct nb_options){.threads = 1}, NULL, &error);
  const unsigned long half = whole.cycles / 2, stage = whole.stages ? whole.stages[0].cycles : 0;
  const unsigned long cuts[] = {1, half < stage ? half : stage, half < stage ? stage : half};
  unsigned long from = 0;
  int threads = 1;
  for (size_t k = 0; k < sizeof cuts / sizeof *cuts; k++) {
    if (cuts[k] <= from || cuts[k] >= whole.cycles)
      continue;
    const bool stopped =
        session(&result, scene, from, cuts[k], threads, &error) == NB_BROKEN && strstr(error.text, "the checkpoint is");
    if (!stopped)
      printf("# %s, from cycle %lu to cycle %lu: %s\n", name, from, cuts[k], error.text);
    CU_ASSERT(stopped);
    nb_result_free(&result);
    from = cuts[k], threads = 3 - threads;
  }
  const enum nb_status status = session(&result, scene, from, 0, threads, &error);
  const char *what = status != wanted ? error.text : difference(scene, &whole, &result);
  if (what)
    printf("# %s, interrupted at cycles %lu, %lu and %lu of %lu: %s\n", name, cuts[0], cuts[1], cuts[2], whole.cycles,
           what);
  CU_ASSERT_PTR_NULL(what);
  nb_result_free(&result), nb_result_free(&whole);
  const struct nb_options options = options_of(0, false, 1);
  nb_checkpoint_remove(scene, &options, 1);
}

/* What no page has at once: a servo beside a strain rate, ramps, and changes since a stage, in the middle of which the run is
 * interrupted. */
static const char head[] =
    "units none\nmaterial m density 3 kn 5000 ks 4000 friction 0.3\nshear linear\nregion A all\nstep 0.001\n"
    "record time energy.residual work.residual energy.imposed energy.walls step.fracc step.stable A.stress.xx\n"
    "record A.strain.xx A.contacts.lost\nlattice discs 6 by 6 m radius 0.5 spacing 0.999 from 0.5 0.5\n";
static const char *const scenes[] = {
    "boundary circle 3 3 radius 2.4\nstage shear\nboundary strain -4e-5 per cycle 2e-5 per cycle\n"
    "servo mean 20 on boundary through boundary at most 1e-5 per cycle\ncycles 40\nsnapshot\n",
    "gravity 0 -3\nbox 0 0 to 6 6 m\nstage press\nwalls inward 0.5\ncycles 10\nstage change\nramp material m friction "
    "0.01 kn 9000\n"
    "ramp gravity 0 -50\nramp walls inward -0.2\ncycles 60\nsnapshot from change\n",
    "box 0 0 to 6 6 m\nstage press\nwalls inward 0.5\ncycles 10\nstage slide\nwall south velocity 3 0\ncycles 60\n"
    "stage stop\nwalls stop\ncycles 20\nsnapshot from slide\n",
};

static void interrupted_in_the_middle(void) {
  for (size_t k = 0; k < sizeof scenes / sizeof *scenes; k++) {
    struct words words = {0};
    struct written it;
    char name[32];
    snprintf(name, sizeof name, "scene %zu", k + 1);
    words_add(&words, "%s%s", head, scenes[k]);
    written_scene(&it, &words);
    interrupt_page(&it.scene, name);
    written_free(&it);
  }
}

static void every_page_interrupted(void) { every_page(interrupt_page, 400); }

static int make_folder(void) { return mkdtemp(folder) == NULL; }
static int remove_folder(void) { return rmdir(folder); }

void suite_checkpoint(void) {
  CU_pSuite suite = CU_add_suite("checkpoint", make_folder, remove_folder);
  CU_add_test(suite, "ramps, a servo and references interrupted", interrupted_in_the_middle);
  CU_add_test(suite, "every page interrupted and continued", every_page_interrupted);
}
