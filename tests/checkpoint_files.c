/* The files of checkpoints: their names, messages about them, and the times at which they are saved.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../src/run/checkpoint.h"
#include "core/clock.h"
#include "run/plan.h"
#include "suites.h"
#include "written.h"

#define TEXT 1024
#define PATH 256
#define OLD (PATH + 8)

static char folder[] = "/tmp/nineball-checkpoint-files-XXXXXX";

static struct nb_options options_of(bool resume) {
  return (struct nb_options){
      .threads = 1, .states = folder, .checkpoint = {.seconds = 5, .key = 0xab, .resume = resume}};
}

/* A scene of two stages; `path` and `old` receive the paths of its checkpoints. */
static void scene_read(struct written *it, char path[PATH], char old[OLD]) {
  struct words page = {0};
  words_add(&page,
            "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nstep 0.1\nrecord time\nstage a\ncycles 1\n"
            "stage b\ncycles 2\n");
  written_scene(it, &page);
  snprintf(path, PATH, "%s/%s-00000000000000ab.checkpoint", folder, it->scene.page->name);
  snprintf(old, OLD, "%s.old", path);
}

/* A run saves checkpoints if it has options, a time and a key. Only then it makes the folder. */
static void runs_that_save_checkpoints(void) {
  char path[PATH], old[OLD], sub[PATH];
  struct written it;
  struct nb_error error;
  scene_read(&it, path, old);
  snprintf(sub, sizeof sub, "%s/sub", folder);
  for (int k = 0; k < 4; k++) {
    struct nb_options options = options_of(false);
    struct nb_checkpoint checkpoint;
    options.states = sub;
    options.checkpoint.seconds = k == 1 ? 0 : 1, options.checkpoint.key = k == 2 ? 0 : 0xab;
    CU_ASSERT_EQUAL(nb_checkpoint_begin(&checkpoint, &it.scene, k ? &options : NULL, &error), NB_OK);
    CU_ASSERT_EQUAL(checkpoint.options, k == 3 ? &options.checkpoint : NULL);
    CU_ASSERT_EQUAL(checkpoint.scene, &it.scene);
    CU_ASSERT(checkpoint.cost == 2e-3 && nb_clock() - checkpoint.saved < 60); /* the first one after 0.02 s at least */
    CU_ASSERT_EQUAL(access(sub, F_OK) == 0, k == 3);
    if (k == 3)
      CU_ASSERT(strncmp(checkpoint.path, sub, strlen(sub)) == 0 &&
                strcmp(checkpoint.path + strlen(sub), path + strlen(folder)) == 0);
  }
  CU_ASSERT_EQUAL(rmdir(sub), 0);
  written_free(&it);
}

/* The path of a checkpoint and its final 0 need at most NB_STATE_PATH bytes. */
static void the_longest_path(void) {
  char path[PATH], old[OLD];
  struct written it;
  scene_read(&it, path, old);
  const size_t rest = strlen(path) - strlen(folder);
  for (size_t more = 0; more < 2; more++) {
    char states[NB_STATE_PATH + 1] = "";
    struct nb_options options = options_of(false);
    struct nb_error error = {NB_OK, ""};
    memset(states, 'x', NB_STATE_PATH - 1 - rest + more);
    options.states = states;
    CU_ASSERT_EQUAL(nb_checkpoint_absent(&it.scene, &options, &error), more ? NB_BAD_USE : NB_OK);
    CU_ASSERT_STRING_EQUAL(error.text, more ? "the name of the folder of states is too long" : "");
  }
  written_free(&it);
}

/* A run that does not resume is refused if there is a checkpoint. */
static void an_interrupted_run(void) {
  char path[PATH], old[OLD], wanted[TEXT];
  struct written it;
  scene_read(&it, path, old);
  for (int k = 0; k < 8; k++) {
    const bool last = k & 1, before = k & 2;
    const struct nb_options options = options_of(k & 4);
    struct nb_error error = {NB_OK, ""};
    if (last)
      written_text(path, "x");
    if (before)
      written_text(old, "x");
    const bool refused = (last || before) && !options.checkpoint.resume;
    CU_ASSERT_EQUAL(nb_checkpoint_absent(&it.scene, &options, &error), refused ? NB_BAD_USE : NB_OK);
    snprintf(wanted, sizeof wanted,
             "the run of this page was interrupted; its checkpoint is %s: --resume continues from this checkpoint; to "
             "start from the beginning, remove this file%s",
             last ? path : old, last && before ? " and the file with `.old` after its name" : "");
    CU_ASSERT_STRING_EQUAL(error.text, refused ? wanted : "");
    struct nb_options off = options;
    off.checkpoint.seconds = 0;
    nb_checkpoint_remove(&it.scene, NULL, 0xab), nb_checkpoint_remove(&it.scene, &off, 0xab);
    nb_checkpoint_remove(&it.scene, &options, 0xac);
    CU_ASSERT((access(path, F_OK) == 0) == last && (access(old, F_OK) == 0) == before);
    nb_checkpoint_remove(&it.scene, &options, 0xab);
    CU_ASSERT(access(path, F_OK) != 0 && access(old, F_OK) != 0);
  }
  written_free(&it);
}

/* The lock of a page is on a file beside its checkpoint. A second lock is refused, also in the same process. */
static void the_lock_of_a_page(void) {
  char path[PATH], old[OLD], wanted[TEXT];
  struct written it;
  struct nb_lock lock, second;
  struct nb_error error = {NB_OK, ""};
  const struct nb_options options = options_of(false);
  scene_read(&it, path, old);
  CU_ASSERT_EQUAL_FATAL(nb_checkpoint_lock(&lock, &it.scene, &options, 0xab, &error), NB_OK);
  CU_ASSERT_EQUAL(nb_checkpoint_lock(&second, &it.scene, &options, 0xab, &error), NB_BAD_USE);
  snprintf(wanted, sizeof wanted,
           "process %ld runs this page with these settings and saves checkpoints, %s.lock: wait for its end, or choose "
           "another folder with --states",
           (long)getpid(), path);
  CU_ASSERT_STRING_EQUAL(error.text, wanted);
  nb_lock_release(&lock);
  written_free(&it);
}

static void add_note(void *data, const char *text) { snprintf(data, TEXT, "%s", text); }

/* Reads the checkpoint of the scene with --resume; `note` receives the last note. */
static enum nb_status read_again(char note[TEXT], const struct nb_scene *scene, bool resume, struct nb_error *error) {
  const struct nb_options options = options_of(resume);
  const struct nb_progress progress = {.note = add_note, .data = note};
  struct nb_checkpoint checkpoint = {.scene = scene, .options = &options.checkpoint};
  struct nb_saved saved;
  snprintf(checkpoint.path, sizeof checkpoint.path, "%s/%s-00000000000000ab.checkpoint", folder, scene->page->name);
  *note = 0, *error = (struct nb_error){NB_OK, ""};
  const enum nb_status status = nb_checkpoint_read(&saved, &checkpoint, &progress, error);
  if (!status)
    CU_ASSERT_EQUAL(saved.store.part_count > 0, resume && !strstr(note, "there is no checkpoint"));
  nb_saved_free(&saved);
  return status;
}

static void save(const struct written *it, const char *path) {
  const struct nb_options options = options_of(true);
  struct nb_model *model = written_model(it, &(struct nb_options){.keep_all = true});
  struct nb_checkpoint checkpoint = {.scene = &it->scene, .options = &options.checkpoint, .cost = -1};
  struct nb_store store = {0};
  struct nb_error error;
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it->scene.stages[0], &error), NB_OK);
  written_cycles(model, 1);
  snprintf(checkpoint.path, sizeof checkpoint.path, "%s", path);
  const double began = nb_clock();
  CU_ASSERT_EQUAL(nb_checkpoint_save(&checkpoint, model, &store, &error), NB_OK);
  CU_ASSERT(checkpoint.saved >= began && checkpoint.saved <= nb_clock());
  CU_ASSERT(checkpoint.cost >= 0 && checkpoint.cost <= checkpoint.saved - began);
  nb_model_free(model);
}

/* The checkpoint before the last one is kept, and read if the last one is damaged or missing. */
static void the_last_two_checkpoints(void) {
  char path[PATH], old[OLD], note[TEXT], wanted[TEXT];
  struct written it;
  struct nb_error error;
  scene_read(&it, path, old);
  CU_ASSERT_EQUAL(read_again(note, &it.scene, true, &error), NB_OK);
  snprintf(wanted, sizeof wanted, "there is no checkpoint %s: the run starts from the beginning", path);
  CU_ASSERT_STRING_EQUAL(note, wanted);
  save(&it, path);
  CU_ASSERT(access(path, F_OK) == 0 && access(old, F_OK) != 0);
  save(&it, path);
  CU_ASSERT(access(path, F_OK) == 0 && access(old, F_OK) == 0);
  for (int resume = 0; resume < 2; resume++) {
    CU_ASSERT_EQUAL(read_again(note, &it.scene, resume, &error), NB_OK);
    CU_ASSERT_STRING_EQUAL(note, "");
  }
  written_text(path, "x");
  CU_ASSERT_EQUAL(read_again(note, &it.scene, true, &error), NB_OK);
  CU_ASSERT(strncmp(note, path, strlen(path)) == 0);
  CU_ASSERT_PTR_NOT_NULL(strstr(note, "; the run continues from the checkpoint before it"));
  unlink(path);
  CU_ASSERT_EQUAL(read_again(note, &it.scene, true, &error), NB_OK);
  CU_ASSERT_STRING_EQUAL(note, "");
  written_text(path, "x"), unlink(old);
  CU_ASSERT_EQUAL(read_again(note, &it.scene, true, &error), NB_BAD_USE);
  CU_ASSERT_STRING_EQUAL(note, "");
  unlink(path);
  written_free(&it);
}

/* The checkpoint of a page with other statements or records is refused. The error names the first stage that differs, and
 * the files to remove. */
static void a_page_that_has_changed(void) {
  char path[PATH], old[OLD], note[TEXT], wanted[TEXT];
  struct written it;
  struct nb_error error;
  scene_read(&it, path, old);
  struct nb_stage *a = &it.scene.stages[0], *b = &it.scene.stages[1];
  const struct nb_stage first = *a, second = *b;
  static const char *const places[] = {"in stage `a` (line 7) or above this stage",
                                       "in stage `b` (line 9) or above this stage",
                                       "in a statement `record` or `snapshot`"};
  static const char *const files[] = {"", " and the file with `.old` after its name", "",
                                      " and the file without `.old` at the end of its name"};
  save(&it, path), save(&it, path);
  static const int place_of[] = {0, 1, 2, 2, 2, 2, 1};
  for (int kind = 0; kind < 7; kind++)
    for (int k = 0; k < 4; k++) {
      unlink(path), unlink(old);
      it.scene.stage_count = kind == 6 ? 1 : 2; /* the last kind: stage `b` is new */
      save(&it, k < 2 ? path : old);
      it.scene.stage_count = 2;
      if (k == 1 || k == 3)
        written_text(k == 1 ? old : path, "x");
      if (kind == 0)
        a->hash++;
      if (kind < 2)
        b->hash++;
      if (kind == 2)
        it.scene.columns[0].name[0]++;
      b->record_interval += kind == 3, b->snapshot += kind == 4, b->snapshot_from += kind == 5;
      CU_ASSERT_EQUAL(read_again(note, &it.scene, true, &error), NB_BAD_USE);
      snprintf(
          wanted, sizeof wanted,
          "the page has changed since %s was saved, %s: restore the text of the page, or remove this file%s and run "
          "the page without --resume",
          k < 2 ? path : old, places[place_of[kind]], files[k]);
      CU_ASSERT_STRING_EQUAL(error.text, wanted);
      *a = first, *b = second;
      it.scene.columns[0].name[0] = 't'; /* `time` */
    }
  unlink(path), unlink(old);
  written_free(&it);
}

/* During a stage a checkpoint is due after the seconds of the options and ten times the cost of the last one; at the end
 * of a stage, after fifty times this cost. */
static void times_of_checkpoints(void) {
  static const struct {
    double passed, cost;
    bool stage_ends, due;
  } rows[] = {{900, 100, false, false}, {1100, 100, false, true}, {400, 1, false, false}, {600, 1, false, true},
              {4900, 100, true, false}, {5100, 100, true, true},  {100, 1, true, true},   {40, 1, true, false}};
  const struct nb_checkpointing options = {.seconds = 500};
  for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
    struct nb_checkpoint checkpoint = {.options = &options, .saved = nb_clock() - rows[r].passed, .cost = rows[r].cost};
    CU_ASSERT_EQUAL(nb_checkpoint_is_due(&checkpoint, rows[r].stage_ends), rows[r].due);
  }
}

/* A run that is asked to stop saves a checkpoint and stops, also at the end of a stage. At the end of the last stage it is
 * complete and does not stop. The stages have 1 and 2 cycles. */
static void cycles_after_which_a_run_stops(void) {
  char path[PATH], old[OLD], wanted[TEXT], found[TEXT];
  struct written it;
  scene_read(&it, path, old);
  for (int stop = 1; stop <= 4; stop++) {
    struct nb_result result;
    struct nb_error error = {NB_OK, ""};
    struct nb_options options = options_of(false);
    options.checkpoint.seconds = 1e9, options.checkpoint.stop_after = (unsigned long)stop;
    CU_ASSERT_EQUAL(nb_run(&result, &it.scene, &options, NULL, &error), stop < 3 ? NB_BROKEN : NB_OK);
    CU_ASSERT(result.cycles == (stop < 3 ? (unsigned long)stop : 3) && result.table.row_count == result.cycles + 1);
    snprintf(wanted, sizeof wanted, "stopped by a signal after cycle %d (%d %%, at most", stop, stop == 1 ? 33 : 67);
    snprintf(found, sizeof found, " s left); the checkpoint is %s", path);
    CU_ASSERT(stop >= 3 || (strncmp(error.text, wanted, strlen(wanted)) == 0 && strstr(error.text, found)));
    CU_ASSERT(stop >= 3 || access(path, F_OK) == 0);
    nb_checkpoint_remove(&it.scene, &options, 0xab);
    nb_result_free(&result);
  }
  written_free(&it);
}

/* A run stops if a signal has set the flag. */
static void a_run_that_is_stopped(void) {
  volatile sig_atomic_t stop = 0;
  struct nb_checkpointing options = {.seconds = 5};
  const struct nb_checkpoint checkpoint = {.options = &options};
  CU_ASSERT_FALSE(nb_checkpoint_stops(&checkpoint));
  options.stop = &stop;
  CU_ASSERT_FALSE(nb_checkpoint_stops(&checkpoint));
  stop = 1;
  CU_ASSERT_TRUE(nb_checkpoint_stops(&checkpoint));
}

/* Saves an integer of a type, and restores this number in its place. Returns whether it is taken, with its value. */
#define RESTORES(type)                                                                                                 \
  static bool restores_##type(double value) {                                                                          \
    type it = 0;                                                                                                       \
    struct nb_store store = {0};                                                                                       \
    NB_STORE_INTEGERS(&store, "it", &it, 1);                                                                           \
    store.values[0] = value, store.restoring = true;                                                                   \
    NB_STORE_INTEGERS(&store, "it", &it, 1);                                                                           \
    const bool taken = !store.failed;                                                                                  \
    CU_ASSERT(!taken || !(value >= 0) || ((double)it >= value && (double)it <= value));                                \
    nb_store_free(&store);                                                                                             \
    return taken;                                                                                                      \
  }
typedef unsigned char byte;
RESTORES(bool)
RESTORES(byte)
RESTORES(int)
RESTORES(unsigned)
RESTORES(size_t)
#undef RESTORES

/* A number of a checkpoint must be an integer in the range of its type; for 8 bytes, one that a double represents. */
static void integers_of_a_checkpoint(void) {
  static const struct {
    bool (*restores)(double value);
    double most;
  } types[] = {{restores_bool, 1},
               {restores_byte, 255},
               {restores_int, 2147483647},
               {restores_unsigned, 2147483647},
               {restores_size_t, 0x1p53}};
  for (size_t k = 0; k < sizeof types / sizeof *types; k++) {
    CU_ASSERT(types[k].restores(0) && types[k].restores(1) && types[k].restores(types[k].most));
    CU_ASSERT_FALSE(types[k].restores(types[k].most + (k == 4 ? 2 : 1)));
    CU_ASSERT_FALSE(types[k].restores(0.5));
    CU_ASSERT_FALSE(types[k].restores(NAN));
    CU_ASSERT(k > 1 || !types[k].restores(-1));
  }
  CU_ASSERT(restores_int(-2147483647) && !restores_int(-2147483648.));
}

/* The parts of a checkpoint are read in their order, each with its name and its length. */
static void parts_of_a_checkpoint(void) {
  static const struct {
    const char *name;
    size_t count;
    bool taken;
  } rows[] = {{"two", 2, true}, {"two", 1, false}, {"two", 3, false}, {"one", 1, false}, {"twos", 2, false}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_store store = {0};
    double out[] = {5, 7, 0}, in[] = {1, 2, 3};
    nb_store_doubles(&store, "two", out, 2), nb_store_doubles(&store, "one", out, 1);
    CU_ASSERT_EQUAL(nb_store_length(&store, "any", 6), 6);
    CU_ASSERT(nb_store_find(&store, "one") == &store.parts[1] && !nb_store_find(&store, "on"));
    store.restoring = true;
    CU_ASSERT_EQUAL(nb_store_length(&store, rows[k].name, 6), strcmp(rows[k].name, "two") == 0 ? 2 : 0);
    nb_store_doubles(&store, rows[k].name, in, rows[k].count);
    CU_ASSERT_EQUAL(!store.failed, rows[k].taken);
    CU_ASSERT(in[0] == (rows[k].taken ? 5 : 1) && in[1] == (rows[k].taken ? 7 : 2) && in[2] == 3);
    nb_store_doubles(&store, "one", in, 1);
    CU_ASSERT_EQUAL(!store.failed, rows[k].taken);
    nb_store_doubles(&store, "one", in, 1); /* there are two parts */
    CU_ASSERT(store.failed && nb_store_length(&store, "one", 6) == 0);
    nb_store_free(&store);
  }
}

static int make_folder(void) { return mkdtemp(folder) == NULL; }
static int remove_folder(void) { return rmdir(folder); }

void suite_checkpoint_files(void) {
  CU_pSuite suite = CU_add_suite("checkpoint_files", make_folder, remove_folder);
  CU_ADD_TEST(suite, runs_that_save_checkpoints);
  CU_ADD_TEST(suite, the_longest_path);
  CU_ADD_TEST(suite, an_interrupted_run);
  CU_ADD_TEST(suite, the_lock_of_a_page);
  CU_ADD_TEST(suite, the_last_two_checkpoints);
  CU_ADD_TEST(suite, a_page_that_has_changed);
  CU_ADD_TEST(suite, times_of_checkpoints);
  CU_ADD_TEST(suite, a_run_that_is_stopped);
  CU_ADD_TEST(suite, cycles_after_which_a_run_stops);
  CU_ADD_TEST(suite, integers_of_a_checkpoint);
  CU_ADD_TEST(suite, parts_of_a_checkpoint);
}
