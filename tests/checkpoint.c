/* The run of every page is interrupted after its first cycle, in its middle and at the end of its first stage, and
 * continued from the checkpoint. The results and the last checkpoint must be those of the run without interruption, to
 * the last bit.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../src/input/reader.h"
#include "../src/run/checkpoint.h"
#include "../src/run/plan.h"
#include "../src/run/restart.h"
#include "every_page.h"
#include "suites.h"
#include "written.h"

static char folder[] = "/tmp/nineball-checkpoint-XXXXXX";

/* Options of a run that stops after this number of cycles (0: at its end) and, with `resume`, begins at the
 * checkpoint. */
static struct nb_options options_of(unsigned long stop_after, bool resume, int threads) {
  return (struct nb_options){.threads = threads,
                             .states = folder,
                             .checkpoint = {.seconds = 1e9, .resume = resume, .stop_after = stop_after, .key = 1}};
}

/* The name of the first part of the results that differs; NULL: the results are equal. */
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
  const size_t extremes = scene->stage_count * scene->column_count * sizeof *a->extremes;
  if (!a->extremes != !b->extremes || (a->extremes && memcmp(a->extremes, b->extremes, extremes) != 0))
    return "the extremes of all cycles";
  return !written_same_table(one, two)                                     ? "the table"
         : !written_same_snapshots(a, b)                                   ? "a snapshot"
         : a->cycles != b->cycles                                          ? "the number of cycles"
         : a->updates != b->updates                                        ? "the contact updates"
         : a->searches != b->searches                                      ? "the number of searches"
         : a->stability != b->stability                                    ? "the largest step over the stable one"
         : a->deep != b->deep || strcmp(a->deep_first, b->deep_first) != 0 ? "the deep overlaps"
                                                                           : NULL;
}

/* Continues the scene from its checkpoint at the cycle `from` (0: begins it), and stops after the cycle `to` (0: at the
 * end). */
static enum nb_status session(struct nb_result *result, const struct nb_scene *scene, unsigned long from,
                              unsigned long to, int threads, struct nb_error *error) {
  const struct nb_options options = options_of(to ? to - from : 0, from > 0, threads);
  return nb_run(result, scene, &options, NULL, error);
}

static void remove_checkpoint(const struct nb_scene *scene, unsigned long long key) {
  const struct nb_options options = options_of(0, false, 1);
  nb_checkpoint_remove(scene, &options, key);
}

/* The lines of the checkpoint with this key, without measured times and without the checksum. The caller frees the
 * text. */
static char *untimed(const struct nb_scene *scene, unsigned long long key) {
  static const char *const timed[] = {"end ", "store seconds ", "store stage_seconds ", "store cost "};
  struct nb_error error;
  char path[256];
  snprintf(path, sizeof path, "%s/%s-%016llx.checkpoint", folder, scene->page->name, key);
  size_t size, used = 0;
  char *text = nb_file_read(path, (size_t)1 << 30, &size, &error);
  for (char *line = text, *end; line && *line; line = end) {
    bool kept = true;
    end = line + strcspn(line, "\n"), end += *end == '\n';
    for (size_t k = 0; k < sizeof timed / sizeof *timed; k++)
      kept = kept && strncmp(line, timed[k], strlen(timed[k])) != 0;
    if (kept)
      memmove(text + used, line, (size_t)(end - line)), used += (size_t)(end - line);
  }
  if (text)
    text[used] = 0;
  return text;
}

/* Tests that the checkpoint of the interrupted run (key 1) equals that of a run without interruption (key 2): all
 * variables of the model, to the last bit. */
static void compare_checkpoints(const struct nb_scene *scene, const char *name) {
  char *whole = untimed(scene, 2), *interrupted = untimed(scene, 1);
  CU_ASSERT(whole && interrupted);
  size_t at = 0, line = 0;
  for (; whole && interrupted && whole[at] && whole[at] == interrupted[at]; at++)
    line = whole[at] == '\n' ? at + 1 : line;
  const bool same = whole && interrupted && whole[at] == interrupted[at];
  if (!same && whole && interrupted)
    printf("# %s: the checkpoint has %.60s, without interruption %.60s\n", name, interrupted + line, whole + line);
  CU_ASSERT(same);
  free(whole), free(interrupted);
}

/* Runs the scene up to a cycle without interruption, and compares its checkpoint with that of the interrupted run. */
static void check_last(const struct nb_scene *scene, const char *name, unsigned long cycle) {
  struct nb_error error;
  struct nb_result result;
  struct nb_options options = options_of(cycle, false, 1);
  options.checkpoint.key = 2;
  nb_run(&result, scene, &options, NULL, &error);
  nb_result_free(&result);
  compare_checkpoints(scene, name);
  remove_checkpoint(scene, 2);
}

/* Runs the scene in up to four sessions, on one thread and on two in turn, and compares it with an uninterrupted
 * run. */
static void interrupt_page(struct nb_scene *scene, const char *name) {
  struct nb_error error = {NB_OK, ""};
  struct nb_result whole, result;
  if (scene->contact_test || scene->start.stages > 0)
    return;
  for (size_t s = 0; s < scene->stage_count; s++)
    scene->stages[s].record_interval = 1 + s % 2; /* extremes of all cycles are kept in stages that leave cycles out */
  for (size_t c = 0; c < scene->column_count; c++)
    scene->columns[c].tracked = scene->columns[c].quantity.monitor >= 0;
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
  if (from > 1)
    check_last(scene, name, from);
  const enum nb_status status = session(&result, scene, from, 0, threads, &error);
  const char *what = status != wanted ? error.text : difference(scene, &whole, &result);
  if (what)
    printf("# %s, interrupted at cycles %lu, %lu and %lu of %lu: %s\n", name, cuts[0], cuts[1], cuts[2], whole.cycles,
           what);
  CU_ASSERT_PTR_NULL(what);
  nb_result_free(&result), nb_result_free(&whole);
  remove_checkpoint(scene, 1);
}

/* Scenes with features that no page has, or that no page combines: a servo beside a strain rate, ramps, and changes
 * since a stage. The run is interrupted in the middle of such a stage. */
static const char head[] =
    "units none\nmaterial m density 3 kn 5000 ks 4000 friction 0.3\nshear linear\nregion A all\nstep 0.001\n"
    "record time energy.balance work.balance energy.imposed energy.walls step.fracc step.stable step.single-contact "
    "A.stress.xx\n"
    "record A.strain.xx A.contacts.lost\nlattice discs 6 by 6 m radius 0.5 spacing 0.999 from 0.5 0.5\n";
static const char *const scenes[] = {
    "boundary circle 3 3 radius 2.4\nstage shear\nboundary strain -4e-5 per cycle 2e-5 per cycle\n"
    "servo mean 20 on boundary through boundary at most 1e-5 per cycle\ncycles 40\nsnapshot\n",
    "boundary circle 3 3 radius 2.4\nstage shear\nboundary strain -4e-5 per cycle 2e-5 per cycle shear 3e-5 per "
    "cycle\ncycles 20\nstage press\nramp servo xx 30 yy 20 xy 9 on boundary through boundary at most 1e-4 per "
    "cycle\ncycles 40\nsnapshot\n",
    "region B circle 3 3 radius 2 rings 3\nboundary circle 3 3 radius 2.4\nstage shear\nboundary strain -4e-4 per "
    "cycle "
    "2e-4 per cycle\ncycles 10\nsnapshot\nstage more\ncycles 40\n",
    "gravity 0 -3\nbox 0 0 to 6 6 m\nstage press\nwalls inward 0.5\ncycles 10\nstage change\nramp material m friction "
    "0.01 kn 9000\n"
    "ramp gravity 0 -50\nramp walls inward -0.2\ncycles 60\nsnapshot from change\n",
    "stage run\ncycles 10\nstage met\nuntil time above 0.005  every 40 cycles  at most 90 cycles\n",
    "periodic cell 0 0 to 6 6\nstage press\nservo isotropic 900 on cell through cell at most 1e-9 per cycle\nuntil "
    "time above "
    "0.02  at most 90 cycles\n",
    "periodic cell 0 0 to 6 6\nstage press\nservo isotropic 9 on cell through cell at most 1 per cycle\ncycles 20\n",
    "box 0 0 to 6 6 m\nstage press\nwalls inward 0.5\ncycles 10\nstage slide\nwall south velocity 3 0\ncycles 60\n"
    "stage stop\nwalls stop\ncycles 20\nsnapshot from slide\n",
    "stage pull\ngravity centripetal 2 about 3 3\ncycles 10\nstage harder\n"
    "ramp gravity centripetal 90 about 3 3\ncycles 60\nsnapshot from harder\n",
    "gravity 0 -4\nperiodic cell 0 0 to 6 6\nstage strain\ncell strain 0.4 -0.4\ncycles 40\nstage fall\ncell strain 0 "
    "0\ncycles "
    "50\n",
    "stage coarse\nstep 0.1\nallow unstable\ncycles 8\n",
    "region B all from more\nrecord B.strain.yy B.contacts.lost\nboundary circle 3 3 radius 2.4\nstage shear\n"
    "boundary strain -4e-3 per cycle 2e-3 per cycle\ncycles 10\nstage more\ncycles 40\n",
};

/* Elastic spheres. In the first scene the overlaps are beyond the range of the theory. In the second one they grow so
 * slowly that the stability of the step must be checked again between the searches of the cycles 315 and 420. This run is
 * interrupted at cycle 330, before this check, and at cycle 370. */
static const char elastic[] =
    "units none\nmaterial m density 3 young 5000 poisson 0.2 friction 0.3\nnormal hertz\nshear mindlin\n"
    "record time energy.balance\n";
static const char *const spheres[] = {
    "box 0 0 to 6 6 m\nsphere 1 3 radius 0.5 m velocity 0.2 0\nsphere 1.85 3 radius 0.5 m\nsphere 2.9 3.1 radius 0.5 "
    "m\nstep 0.3 of "
    "stable\nstage free\ncycles 400\n",
    "damping ratio 0.3\nbox 0 0 to 2.94 6 m\nsphere 0.49 3 radius 0.5 m\nsphere 1.47 3 radius 0.5 m\nsphere 2.45 3 "
    "radius 0.5 m\n"
    "step 0.012\nstage press\nwall west velocity 0.02 0\nwall east velocity -0.02 0\ncycles 370\nstage rest\nwalls "
    "stop\ncycles 290\n",
};

/* A guard stops the second and the third run between two searches: two discs overlap too much at cycle 351, and a disc
 * passes through a wall at cycle 251. The first search has found that the guard must test every cycle, and no search
 * follows the interruption. The runs record no quantity of a contact, so their checkpoints have only the forces of
 * contacts.
 *
 * In the first run the program warns at the start that the resolution of the coordinate of disc 1 is too coarse,
 * because no discs overlap yet. During the overlap, when the run is interrupted, the resolution is fine enough, and
 * disc 2 is farther from the origin than disc 1. The continued run must not add a warning about disc 2. */
static const char soft[] = "units none\nmaterial m density 3 kn 0.001\nskin 4\nstep 0.001\nrecord time D.x\n";
static const char *const guarded[] = {
    "disc 1e10 0 radius 0.5 m\ndisc (1e10-3) 0.8 radius 0.5 m velocity 100 0\nmonitor D disc 2\nstage pass\ncycles "
    "60\n",
    "disc 0 0 radius 0.5 m velocity 1 0\ndisc 1.2 0 radius 0.5 m velocity -1 0\nmonitor D disc 1\n"
    "stage meet\ncycles 600\n",
    "disc 0 0 radius 0.5 m velocity 4 0\nwall w 1 -2 to 1 2 m\nmonitor D disc 1\nstage meet\ncycles 400\n",
};

/* A page may change before its run is continued, but its statements `record` and `snapshot` may not, because the result
 * has the rows and snapshots from before the interruption too. */
static void other_records_are_refused(void) {
  struct words words = {0};
  struct written it;
  struct nb_result result;
  struct nb_error error = {NB_OK, ""};
  words_add(&words, "%s%s", head, scenes[2]);
  written_scene(&it, &words);
  struct nb_stage *const first = &it.scene.stages[0], was = *first;
  CU_ASSERT_EQUAL(session(&result, &it.scene, 0, 20, 1, &error), NB_BROKEN);
  nb_result_free(&result);
  for (int change = 0; change < 5; change++) {
    char *const name = it.scene.columns[0].name;
    first->record_interval += change == 0;
    first->snapshot = first->snapshot != (change == 1);
    first->snapshot_from += change == 2;
    name[0] = change == 3 ? 'T' : 't';
    CU_ASSERT_EQUAL(session(&result, &it.scene, 20, 0, 1, &error), change < 4 ? NB_BAD_USE : NB_OK);
    CU_ASSERT(change == 4 || strstr(error.text, "in a statement `record` or `snapshot`"));
    nb_result_free(&result);
    *first = was;
  }
  remove_checkpoint(&it.scene, 1);
  written_free(&it);
}

/* Expectations may change before a run is continued, and with them the columns whose extremes the run tracks. The
 * first column is tracked in all three sessions, the second one in the first and the last session, the third one in the
 * last two sessions, and the fourth one in none. Only the extremes of the first column are known. */
static void other_tracked_columns(void) {
  enum { SESSIONS = 3 };
  static const bool tracked[SESSIONS][4] = {
      {true, true, false, false}, {true, false, true, false}, {true, true, true, false}};
  struct words words = {0};
  struct written it;
  struct nb_result result;
  struct nb_error error = {NB_OK, ""};
  words_add(&words, "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m velocity 4 0\nmonitor A disc 1\nstep "
                    "0.25\nrecord A.x A.y A.vx A.vy\nstage one\nrecord every 10 cycles\ncycles 30\n");
  written_scene(&it, &words);
  for (int s = 0; s < SESSIONS; s++) {
    for (size_t c = 0; c < 4; c++)
      it.scene.columns[c].tracked = tracked[s][c];
    const unsigned long from = 10 * (unsigned long)s, to = s + 1 < SESSIONS ? from + 10 : 0;
    const enum nb_status status = session(&result, &it.scene, from, to, 1, &error);
    CU_ASSERT_EQUAL_FATAL(status, to ? NB_BROKEN : NB_OK);
    if (to)
      nb_result_free(&result);
  }
  CU_ASSERT_EQUAL(result.extremes[0].smallest, 1);
  CU_ASSERT_EQUAL(result.extremes[0].largest, 30);
  for (size_t c = 1; c < 4; c++) {
    CU_ASSERT_EQUAL(result.extremes[c].smallest, -INFINITY);
    CU_ASSERT_EQUAL(result.extremes[c].largest, INFINITY);
  }
  nb_result_free(&result);
  remove_checkpoint(&it.scene, 1);
  written_free(&it);
}

/* The last checkpoint of the scene is read into `saved`. Returns its path. */
static const char *last_checkpoint(char path[256], struct nb_saved *saved, const struct nb_scene *scene) {
  struct nb_error error;
  snprintf(path, 256, "%s/%s-%016llx.checkpoint", folder, scene->page->name, 1ULL);
  CU_ASSERT_EQUAL_FATAL(nb_saved_read(saved, path, &error), NB_OK);
  return path;
}

/* Returns the index of the part number `which`, from 0, of the parts with this name. */
static size_t part_index(const struct nb_store *store, const char *name, int which) {
  size_t k = 0;
  while (k < store->part_count && (strcmp(store->parts[k].name, name) != 0 || which-- > 0))
    k++;
  CU_ASSERT_FATAL(k < store->part_count);
  return k;
}

/* Removes a variable from the last checkpoint, as if an earlier version of the program had written it. Returns the
 * value of the variable. */
static double without_variable(const struct nb_scene *scene, const char *name) {
  struct nb_saved saved;
  struct nb_error error;
  char buffer[256];
  const char *path = last_checkpoint(buffer, &saved, scene);
  struct nb_store *const store = &saved.store;
  const size_t k = part_index(store, name, 0);
  CU_ASSERT_EQUAL_FATAL(store->parts[k].count, 1);
  const double value = store->values[store->parts[k].at];
  memmove(&store->parts[k], &store->parts[k + 1], (--store->part_count - k) * sizeof *store->parts);
  CU_ASSERT_EQUAL(nb_saved_write(&saved, path, &error), NB_OK);
  nb_saved_free(&saved);
  return value;
}

/* Each variable of a run is a record of its own: a checkpoint that lacks one is refused, whatever the others are. */
static void missing_variables_are_refused(void) {
  static const struct {
    const char *name;
    double value;
  } rows[] = {{"met_before", 1}, {"stage_ended", 0}, {"first_cycle", 0}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words words = {0};
    struct written it;
    struct nb_result result;
    struct nb_error error = {NB_OK, ""};
    words_add(&words, "%s%s", head, scenes[4]);
    written_scene(&it, &words);
    CU_ASSERT_EQUAL(session(&result, &it.scene, 0, 20, 1, &error), NB_BROKEN);
    nb_result_free(&result);
    CU_ASSERT_EQUAL(without_variable(&it.scene, rows[k].name), rows[k].value);
    CU_ASSERT_EQUAL(session(&result, &it.scene, 20, 0, 1, &error), NB_BAD_USE);
    CU_ASSERT_PTR_NOT_NULL(strstr(error.text, "is not a checkpoint of this page"));
    nb_result_free(&result);
    remove_checkpoint(&it.scene, 1);
    written_free(&it);
  }
}

/* Three discs in a row, the first one at the only wall, and two stages, of which the first one takes a snapshot. So the
 * checkpoint has the pairs 1-2, 2-3 and 1-wall, three numbers each: two indices and the index of the material pair. A
 * checkpoint with an index that the page does not have is refused, also a count of warnings for which there is no
 * memory. */
static void altered_values_are_refused(void) {
  enum { WARNING = sizeof(struct nb_warning) };
  static const struct {
    const char *name;
    int which, index;
    double value;
    bool refused;
  } rows[] = {{"contacts", 0, 0, -1, true}, {"contacts", 0, 3, 3, true},  {"contacts", 0, 1, -1, true},
              {"contacts", 0, 1, 3, true},  {"contacts", 0, 2, -1, true}, {"contacts", 0, 8, 2, true},
              {"contacts", 0, 6, 3, true},  {"contacts", 0, 7, 1, true},  {"contacts", 0, 6, 0, false},
              {"rows", 0, 1, -1, true},     {"rows", 0, 1, 2, true},      {"rows", 0, 1, 1, false},
              {"snapshot", 0, 0, -1, true}, {"snapshot", 0, 0, 2, true},  {"snapshot", 0, 0, 1, true},
              {"snapshot", 0, 0, 0, false}, {"warnings", 0, 0, -1, true}, {"warnings", 0, 0, NB_WARNINGS + 1, true},
              {"warnings", 0, 0, 16, false}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct words words = {0};
    struct written it;
    struct nb_result result;
    struct nb_error error = {NB_OK, ""};
    struct nb_saved saved;
    char buffer[256];
    words_add(&words, "units none\nmaterial m density 1 kn 90\nwall w 0 0 to 0 9 m\ndisc 0.99 4 radius 1 m\n"
                      "disc 2.97 4 radius 1 m\ndisc 4.95 4 radius 1 m\nstep 0.001\nrecord time\nstage a\ncycles 2\n"
                      "snapshot\nstage b\ncycles 9\n");
    written_scene(&it, &words);
    CU_ASSERT_EQUAL(session(&result, &it.scene, 0, 5, 1, &error), NB_BROKEN);
    nb_result_free(&result);
    const char *path = last_checkpoint(buffer, &saved, &it.scene);
    struct nb_store *const store = &saved.store;
    struct nb_store_part *const part = &store->parts[part_index(store, rows[k].name, rows[k].which)];
    store->values[part->at + (size_t)rows[k].index] = rows[k].value;
    if (strcmp(rows[k].name, "warnings") == 0 && rows[k].value > 0) { /* the texts of so many warnings */
      const size_t more = (size_t)rows[k].value * WARNING;
      store->values = realloc(store->values, (store->value_count + more) * sizeof *store->values);
      CU_ASSERT_PTR_NOT_NULL_FATAL(store->values);
      memset(store->values + store->value_count, 0, more * sizeof *store->values);
      part[1].at = store->value_count, part[1].count = more, store->value_count += more;
    }
    CU_ASSERT_EQUAL(nb_saved_write(&saved, path, &error), NB_OK);
    nb_saved_free(&saved);
    const enum nb_status status = session(&result, &it.scene, 5, 0, 1, &error);
    const char *const text = strcmp(rows[k].name, "contacts") == 0
                                 ? "the checkpoint has contacts that the page does not have"
                                 : "is not a checkpoint of this page";
    const bool as_wanted = rows[k].refused ? status == NB_BAD_USE && strstr(error.text, text) : status == NB_OK;
    CU_ASSERT(as_wanted);
    if (!as_wanted)
      printf("# %s %d: %g, status %d, %s\n", rows[k].name, rows[k].index, rows[k].value, (int)status, error.text);
    nb_result_free(&result);
    remove_checkpoint(&it.scene, 1);
    written_free(&it);
  }
}

/* A checkpoint only reads the variables of the model: a second one, without a cycle between them, equals the first. */
static void saving_changes_nothing(void) {
  struct words words = {0};
  struct written it;
  struct nb_error error;
  struct nb_store stores[2] = {{0}, {0}};
  words_add(&words, "%s%s", elastic, spheres[0]);
  written_scene(&it, &words);
  struct nb_model *model = written_model(&it, NULL);
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  written_cycles(model, 3); /* no search since the first deep overlap */
  CU_ASSERT(nb_deep_count(model) > 0);
  for (int k = 0; k < 2; k++)
    nb_model_store(&stores[k], model);
  CU_ASSERT_EQUAL_FATAL(stores[0].value_count, stores[1].value_count);
  CU_ASSERT_EQUAL(memcmp(stores[0].values, stores[1].values, stores[0].value_count * sizeof *stores[0].values), 0);
  nb_store_free(&stores[0]), nb_store_free(&stores[1]);
  nb_model_free(model);
  written_free(&it);
}

static void interrupted_in_the_middle(void) {
  static const struct {
    const char *head;
    const char *const *scenes;
    size_t count;
  } lists[] = {{head, scenes, sizeof scenes / sizeof *scenes},
               {elastic, spheres, sizeof spheres / sizeof *spheres},
               {soft, guarded, sizeof guarded / sizeof *guarded}};
  for (size_t k = 0; k < sizeof lists / sizeof *lists; k++)
    for (size_t s = 0; s < lists[k].count; s++) {
      struct words words = {0};
      struct written it;
      char name[64];
      snprintf(name, sizeof name, "list %zu, scene %zu", k + 1, s + 1);
      words_add(&words, "%s%s", lists[k].head, lists[k].scenes[s]);
      written_scene(&it, &words);
      interrupt_page(&it.scene, name);
      written_free(&it);
    }
}

/* The step, 1/40 of a collision, is set by --set. When the second stage begins, the sphere has rebounded and there is
 * no collision from which a step could be computed. So the continued run must know that the step has been computed
 * before. */
static void a_collision_step_that_is_set(void) {
  static const char *const settings[] = {"step=40 per collision", NULL};
  struct words words = {0};
  struct written it;
  words_add(
      &words,
      "units none\nmaterial m density 3 young 5000 poisson 0.2\nnormal hertz\nsphere 0 1.1 radius 1 m velocity 0 -1\n"
      "wall w -9 0 to 9 0 m\nstep 1\nrecord time\nstage hit\ncycles 200\nstage off\nstep 2\ncycles 50\n");
  written_scene_set(&it, &words, settings);
  interrupt_page(&it.scene, "a collision step that is set");
  written_free(&it);
}

/* A run that does not resume must not replace the checkpoint of an interrupted one, nor the checkpoint before it. The
 * computation of a state for another page relies on this test. */
static void a_checkpoint_is_not_replaced(void) {
  struct words words = {0};
  struct written it;
  struct nb_result result;
  struct nb_error error = {NB_OK, ""};
  char path[256], old[264];
  words_add(&words, "%s%s", head, scenes[2]);
  written_scene(&it, &words);
  snprintf(path, sizeof path, "%s/%s-%016llx.checkpoint", folder, it.scene.page->name, 1ULL);
  snprintf(old, sizeof old, "%s.old", path);
  CU_ASSERT_EQUAL(session(&result, &it.scene, 0, 20, 1, &error), NB_BROKEN);
  nb_result_free(&result);
  for (int is_old = 0; is_old < 2; is_old++) {
    if (is_old) {
      remove(old);
      CU_ASSERT_EQUAL(rename(path, old), 0);
    }
    CU_ASSERT_EQUAL(session(&result, &it.scene, 0, 30, 1, &error), NB_BAD_USE);
    CU_ASSERT_PTR_NOT_NULL(strstr(error.text, "the run of this page was interrupted"));
    CU_ASSERT_PTR_NOT_NULL(strstr(error.text, is_old ? old : path));
    nb_result_free(&result);
  }
  CU_ASSERT_EQUAL(session(&result, &it.scene, 20, 0, 1, &error), NB_OK);
  nb_result_free(&result);
  remove_checkpoint(&it.scene, 1);
  written_free(&it);
}

/* Sets the time of the run and that of its stage in the last checkpoint, s. */
static void set_seconds(const struct nb_scene *scene, double run, double stage) {
  struct nb_saved saved;
  struct nb_error error;
  char buffer[256];
  const char *path = last_checkpoint(buffer, &saved, scene);
  saved.store.values[saved.store.parts[part_index(&saved.store, "seconds", 0)].at] = run;
  saved.store.values[saved.store.parts[part_index(&saved.store, "stage_seconds", 0)].at] = stage;
  CU_ASSERT_EQUAL(nb_saved_write(&saved, path, &error), NB_OK);
  nb_saved_free(&saved);
}

/* The error of a run that stops after `done` of its 50 cycles, in cycle 20 + done, says how much is done. The time that
 * is left follows from the time of the run so far, 600 s in its checkpoint. */
static bool says_what_is_left(const char *text, unsigned long done) {
  unsigned long cycle = 0;
  double percent = 0, left = 0;
  const double fraction = (double)done / 50, longest = 610 * (1 - fraction) / fraction;
  const int read = sscanf(text, "stopped by a signal after cycle %lu (%lf %%, at most %lf s left); the checkpoint is",
                          &cycle, &percent, &left);
  return read == 3 && cycle == 20 + done && percent == (double)(2 * done) && left <= longest &&
         (done == 10 || left >= longest * 0.98);
}

/* A page that starts from a stage of another one continues from its own checkpoint, not from the saved state of the
 * other page, and needs this state no more. */
static void a_page_that_starts_from_another(void) {
  static const unsigned long cuts[] = {0, 10, 30, 35, 0};
  char path[] = "/tmp/nineball-checkpoint-XXXXXX.md", state[NB_STATE_PATH];
  const int descriptor = mkstemps(path, 3);
  CU_ASSERT_FATAL(descriptor >= 0);
  FILE *file = fdopen(descriptor, "w");
  CU_ASSERT_PTR_NOT_NULL_FATAL(file);
  fputs("# A page\n\n```scene\nunits none\nmaterial m density 3 kn 5000\ndisc 0 0 radius 1 m velocity 1 0\n"
        "disc 1.9 0.3 radius 1 m\nstep 0.001\nrecord time\nstage a\ncycles 20\n```\n",
        file);
  fclose(file);
  struct words words = {0};
  struct written it;
  struct nb_result whole, result;
  struct nb_error error = {NB_OK, ""};
  words_add(&words,
            "start %s stage a\nmonitor D disc 2\nrecord time D.x D.y energy.kinetic\nstage b\ncycles 30\nstage c\n"
            "damping mass 3\ncycles 20\n",
            path);
  written_scene(&it, &words);
  const struct nb_options options = {.threads = 1, .states = folder};
  CU_ASSERT_EQUAL_FATAL(nb_run(&whole, &it.scene, &options, NULL, &error), NB_OK);
  CU_ASSERT_EQUAL(whole.cycles, 50);
  CU_ASSERT_EQUAL_FATAL(nb_start_path(state, sizeof state, &it.scene, &options, &error), NB_OK);
  for (size_t k = 0; k + 1 < sizeof cuts / sizeof *cuts; k++) {
    const unsigned long to = cuts[k + 1];
    if (k == 2)
      CU_ASSERT_EQUAL(unlink(state), 0);
    CU_ASSERT_EQUAL(session(&result, &it.scene, cuts[k], to, 1, &error), to ? NB_BROKEN : NB_OK);
    const char *what = !strstr(error.text, "the checkpoint is") ? error.text
                       : to                                     ? NULL
                                                                : difference(&it.scene, &whole, &result);
    if (what)
      printf("# from cycle %lu: %s\n", cuts[k], what);
    CU_ASSERT_PTR_NULL(what);
    CU_ASSERT_EQUAL(result.cycles, to ? to : whole.cycles);
    CU_ASSERT(!to || says_what_is_left(error.text, to));
    if (k == 0)
      set_seconds(&it.scene, 600, 300); /* in stage `b`, which ends in the next session */
    if (!to)
      CU_ASSERT(result.seconds >= 600 && result.stages[1].seconds >= 300 && result.stages[2].seconds < 300);
    CU_ASSERT_EQUAL(access(state, F_OK) == 0, k < 2); /* the run does not compute it again */
    nb_result_free(&result);
  }
  nb_result_free(&whole);
  remove_checkpoint(&it.scene, 1);
  written_free(&it);
  unlink(path);
}

static void every_page_interrupted(void) { every_page(interrupt_page, 400); }

static int make_folder(void) { return mkdtemp(folder) == NULL; }
static int remove_folder(void) { return rmdir(folder); }

void suite_checkpoint(void) {
  CU_pSuite suite = CU_add_suite("checkpoint", make_folder, remove_folder);
  CU_add_test(suite, "other records are refused", other_records_are_refused);
  CU_ADD_TEST(suite, other_tracked_columns);
  CU_add_test(suite, "checkpoints that lack a variable are refused", missing_variables_are_refused);
  CU_ADD_TEST(suite, altered_values_are_refused);
  CU_add_test(suite, "special scenes interrupted and continued", interrupted_in_the_middle);
  CU_ADD_TEST(suite, saving_changes_nothing);
  CU_ADD_TEST(suite, a_collision_step_that_is_set);
  CU_ADD_TEST(suite, a_checkpoint_is_not_replaced);
  CU_ADD_TEST(suite, a_page_that_starts_from_another);
  CU_add_test(suite, "every page interrupted and continued", every_page_interrupted);
}
