/* The folder of saved states: names, outdated states, locks, and what is computed when a state is missing.
 *
 * Each test writes a page `first` with the stages a and z, and a scene that starts from its stage a.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../src/run/checkpoint.h"
#include "../src/run/output_file.h"
#include "../src/run/restart.h"
#include "core/clock.h"
#include "suites.h"
#include "written.h"

struct folder {
  char path[32], states[48], page[48];
  char notes[2048]; /* the notes of a run, each with a line end */
  int files;        /* number of open files when the test began */
  struct nb_options options;
  struct nb_progress progress;
};

static void add_note(void *data, const char *text) {
  char *notes = data;
  strcat(notes, text), strcat(notes, "\n");
}

/* The first report of progress. */
static void note_first(void *data, const char *stage, double fraction, double seconds) {
  double *done = data;
  (void)stage, (void)seconds;
  *done = *done == 0 ? fraction : *done;
}

static void folder_make(struct folder *folder) {
  *folder = (struct folder){.path = "/tmp/nineball-restart-XXXXXX", .files = written_open_files()};
  CU_ASSERT_PTR_NOT_NULL_FATAL(mkdtemp(folder->path));
  snprintf(folder->states, sizeof folder->states, "%s/states", folder->path);
  snprintf(folder->page, sizeof folder->page, "%s/first.md", folder->path);
  folder->options = (struct nb_options){.threads = 1, .states = folder->states};
  folder->progress = (struct nb_progress){.note = add_note, .data = folder->notes};
}

/* All files that were opened have been closed. */
static void folder_remove(const struct folder *folder) {
  char command[64];
  CU_ASSERT_EQUAL(written_open_files(), folder->files);
  snprintf(command, sizeof command, "rm -r %s", folder->path);
  CU_ASSERT_EQUAL(system(command), 0);
}

/* Writes the page `first`, whose stage a has the statement `statement`, and reads a scene that starts from this stage
 * with the settings `with`. */
static void scene_read(struct written *it, const struct folder *folder, const char *statement, const char *with) {
  FILE *file = fopen(folder->page, "w");
  CU_ASSERT_PTR_NOT_NULL_FATAL(file);
  fprintf(file,
          "```scene\nunits none\nlet v = 1\nlet w = 1\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m velocity $v $w\n"
          "step 0.1\nrecord time\nstage a\n%s\nstage z\ncycles 2\n```\n",
          statement);
  fclose(file);
  struct words words = {0};
  words_add(&words, "units none\nstart %s stage a %s\nmonitor D disc 1\nrecord D.x\nstage b\ncycles 1\n", folder->page,
            with);
  written_scene(it, &words);
}

static void path_of(char path[NB_STATE_PATH], const struct folder *folder, const struct written *it) {
  struct nb_error error;
  CU_ASSERT_EQUAL_FATAL(nb_start_path(path, NB_STATE_PATH, &it->scene, &folder->options, &error), NB_OK);
}

static bool present(const char *path) { return access(path, F_OK) == 0; }

/* Obtains the state, which is computed if it is missing, and frees it. */
static enum nb_status obtain(struct folder *folder, const struct written *it, struct nb_error *error) {
  struct nb_saved saved;
  folder->notes[0] = '\0';
  const enum nb_status status = nb_start_obtain(&saved, &it->scene, &folder->options, &folder->progress, true, error);
  CU_ASSERT(status || saved.particle_count == 1);
  nb_saved_free(&saved);
  return status;
}

/* The name has the page, the stage and the hash of the stage. */
static void names_of_states(void) {
  struct folder folder;
  struct written it;
  struct nb_error error = {NB_OK, ""};
  char path[NB_STATE_PATH], wanted[NB_STATE_PATH];
  folder_make(&folder);
  scene_read(&it, &folder, "cycles 3", "");
  const struct nb_stage *stage = &it.scene.start.scene->stages[0];
  CU_ASSERT_STRING_EQUAL(stage->name, "a");
  CU_ASSERT_STRING_EQUAL(nb_states_folder(NULL), "states");
  CU_ASSERT_STRING_EQUAL(nb_states_folder(&(struct nb_options){.threads = 1}), "states");
  CU_ASSERT_STRING_EQUAL(nb_states_folder(&folder.options), folder.states);
  snprintf(wanted, sizeof wanted, "%s/first-a-%016llx.state", folder.states, stage->hash);
  const size_t length = strlen(wanted);
  CU_ASSERT_EQUAL(nb_start_path(path, length + 1, &it.scene, &folder.options, &error), NB_OK);
  CU_ASSERT_STRING_EQUAL(path, wanted);
  CU_ASSERT_EQUAL(nb_start_path(path, length, &it.scene, &folder.options, &error), NB_BAD_USE);
  snprintf(wanted, sizeof wanted, "the name of the folder is too long: %s…", folder.states);
  CU_ASSERT_STRING_EQUAL(error.text, wanted);
  written_free(&it);
  folder_remove(&folder);
}

/* A missing state is computed, and then read. The file has the hash and the settings; the lock is removed. */
static void a_missing_state_is_computed(void) {
  struct folder folder;
  struct written it;
  struct nb_error error = {NB_OK, ""};
  struct nb_saved saved;
  char path[NB_STATE_PATH], lock[NB_STATE_PATH + 8], wanted[NB_STATE_PATH + 64];
  folder_make(&folder);
  scene_read(&it, &folder, "cycles 3", "with v=2 w=3");
  path_of(path, &folder, &it);
  snprintf(lock, sizeof lock, "%s.lock", path);
  CU_ASSERT_EQUAL(nb_start_presence(&it.scene, &folder.options), NB_STATE_MISSING);
  CU_ASSERT_EQUAL(nb_start_obtain(&saved, &it.scene, &folder.options, NULL, false, &error), NB_BAD_USE);
  snprintf(wanted, sizeof wanted, "expected the state %s: `nineball run` writes it", path);
  CU_ASSERT_STRING_EQUAL(error.text, wanted);
  CU_ASSERT(!present(folder.states) && saved.particle_count == 0 && saved.particles == NULL);
  CU_ASSERT_PTR_NULL(nb_start_model(&it.scene, &folder.options, &error));
  CU_ASSERT_STRING_EQUAL(error.text, wanted);
  for (int again = 0; again < 2; again++) {
    folder.notes[0] = '\0';
    CU_ASSERT_EQUAL_FATAL(nb_start_obtain(&saved, &it.scene, &folder.options, &folder.progress, !again, &error), NB_OK);
    CU_ASSERT_STRING_EQUAL(folder.notes,
                           again ? "" : "first running `first` to the end of stage `a`, where this page starts\n");
    CU_ASSERT(present(path) && !present(lock));
    CU_ASSERT_EQUAL(nb_start_presence(&it.scene, &folder.options), NB_STATE_PRESENT);
    CU_ASSERT_EQUAL(saved.hash, it.scene.start.scene->stages[0].hash);
    CU_ASSERT(saved.cycle == 3 && saved.setting_count == 2);
    CU_ASSERT_STRING_EQUAL(saved.settings[0], "v=2");
    CU_ASSERT_STRING_EQUAL(saved.settings[1], "w=3");
    CU_ASSERT_DOUBLE_EQUAL(saved.particles[0].position.x, 3 * 0.1 * 2, 1e-15);
    nb_saved_free(&saved);
  }
  struct nb_model *model = nb_model_create(&it.scene, &folder.options, &error); /* by nb_start_model */
  CU_ASSERT_PTR_NOT_NULL_FATAL(model);
  CU_ASSERT(model->cycle == 3 && written_now(model, "D.x") == model->particles.position[0].x);
  nb_model_free(model);
  double done = 0; /* the first cycle of four: those of the first page do not count */
  struct nb_result result;
  it.scene.stages[it.scene.stage_count - 1].cycles = 4;
  CU_ASSERT_EQUAL(nb_run(&result, &it.scene, &folder.options, &(struct nb_progress){note_first, NULL, &done}, &error),
                  NB_OK);
  CU_ASSERT_EQUAL(done, 0.25);
  nb_result_free(&result);
  written_free(&it);
  folder_remove(&folder);
}

/* A page without `start` needs no state. A page with `start` is ready if its state is present, even if another text of
 * the page has one. */
static void pages_that_are_ready(void) {
  struct folder folder;
  struct written it, other;
  struct words words = {0};
  struct nb_error error = {NB_OK, ""};
  folder_make(&folder);
  words_add(&words,
            "units none\nmaterial m density 1 kn 1\ndisc 0 0 radius 1 m\nrecord time\nstep 1\nstage b\ncycles 1\n");
  written_scene(&it, &words);
  CU_ASSERT(nb_start_is_ready(&it.scene, &folder.options));
  written_free(&it);
  scene_read(&it, &folder, "cycles 3", "");
  CU_ASSERT(!nb_start_is_ready(&it.scene, &folder.options));
  CU_ASSERT_EQUAL(obtain(&folder, &it, &error), NB_OK);
  CU_ASSERT(nb_start_is_ready(&it.scene, &folder.options));
  scene_read(&other, &folder, "cycles 4", "");
  CU_ASSERT_EQUAL(nb_start_presence(&other.scene, &folder.options), NB_STATE_OUTDATED);
  CU_ASSERT(!nb_start_is_ready(&other.scene, &folder.options));
  char *const states = malloc(NB_STATE_PATH + 1); /* a folder whose name is too long has no state */
  memset(states, 'x', NB_STATE_PATH), states[NB_STATE_PATH] = '\0';
  CU_ASSERT_EQUAL(nb_start_presence(&it.scene, &(struct nb_options){.states = states}), NB_STATE_MISSING);
  free(states);
  written_free(&other), written_free(&it);
  folder_remove(&folder);
}

/* A state is outdated if its name differs only in the hash, and if it has the same settings. Outdated states are deleted
 * when the new state is written; all other files are kept. */
static void states_that_are_outdated(void) {
  static const struct {
    const char *name; /* of the file; %H stands for the hash of the older text */
    const char *with; /* settings of the older text */
    bool outdated;
  } rows[] = {
      {"first-a-%H.state", "with v=2", true},
      {"first-a-0123456789abcdef.state", "with v=2", true},
      {"first-a-%H.state", "", false},
      {"first-a-%H.state", "with v=3", false},
      {"first-a-%H.state", "with w=2", false},
      {"first-a-%H.state", "with v=2 w=1", false},
      {"first-a-0%H.state", "with v=2", false},
      {"first-a-0123456789abcde.state", "with v=2", false},
      {"first-a-0123456789abcdeg.state", "with v=2", false},
      {"first-a-0123456789ABCDEF.state", "with v=2", false},
      {"first-a-%H.states", "with v=2", false},
      {"first-a-%H.stat", "with v=2", false},
      {"first-b-%H.state", "with v=2", false},
      {"first-z-%H.state", "with v=2", false},
      {"hirst-a-%H.state", "with v=2", false},
      {"first-a-%H.state damaged", "with v=2", false},
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct folder folder;
    struct written before, it;
    struct nb_error error = {NB_OK, ""};
    char old[NB_STATE_PATH], path[NB_STATE_PATH], hash[20], name[64];
    folder_make(&folder);
    scene_read(&before, &folder, "cycles 3", rows[k].with);
    CU_ASSERT_EQUAL(obtain(&folder, &before, &error), NB_OK);
    path_of(old, &folder, &before);
    snprintf(hash, sizeof hash, "%016llx", before.scene.start.scene->stages[0].hash);
    const size_t begin = strcspn(rows[k].name, "%"), end = begin + 2 * (rows[k].name[begin] == '%');
    snprintf(name, sizeof name, "%.*s%s%s", (int)begin, rows[k].name, end > begin ? hash : "", rows[k].name + end);
    const bool damaged = strstr(name, " damaged") != NULL;
    name[strcspn(name, " ")] = '\0';
    snprintf(path, sizeof path, "%s/%s", folder.states, name);
    CU_ASSERT_EQUAL(rename(old, path), 0);
    if (damaged)
      written_text(path, "nineball state 1\n");
    scene_read(&it, &folder, "cycles 4", "with v=2");
    const enum nb_state_presence found = nb_start_presence(&it.scene, &folder.options);
    if (found != (rows[k].outdated ? NB_STATE_OUTDATED : NB_STATE_MISSING))
      printf("# %s, %s: %d\n", rows[k].name, rows[k].with, (int)found);
    CU_ASSERT_EQUAL(found, rows[k].outdated ? NB_STATE_OUTDATED : NB_STATE_MISSING);
    CU_ASSERT(present(path));
    CU_ASSERT_EQUAL(obtain(&folder, &it, &error), NB_OK);
    CU_ASSERT_EQUAL(present(path), !rows[k].outdated);
    path_of(path, &folder, &it);
    CU_ASSERT(present(path));
    written_free(&before), written_free(&it);
    folder_remove(&folder);
  }
}

/* A state whose hash is not that in its name, and a damaged one, are refused. They are neither replaced nor removed. */
static void wrong_states_are_refused(void) {
  struct folder folder;
  struct written before, it;
  struct nb_error error = {NB_OK, ""};
  char old[NB_STATE_PATH], path[NB_STATE_PATH], wanted[NB_STATE_PATH + 128];
  folder_make(&folder);
  scene_read(&before, &folder, "cycles 3", "");
  CU_ASSERT_EQUAL(obtain(&folder, &before, &error), NB_OK);
  path_of(old, &folder, &before);
  scene_read(&it, &folder, "cycles 4", "");
  path_of(path, &folder, &it);
  CU_ASSERT_EQUAL(rename(old, path), 0);
  CU_ASSERT_EQUAL(obtain(&folder, &it, &error), NB_BAD_USE);
  snprintf(wanted, sizeof wanted, "%s:4:6: expected the hash that is in the name of the file: the file was renamed",
           path);
  CU_ASSERT_STRING_EQUAL(error.text, wanted);
  written_text(path, "nineball state 1\n");
  CU_ASSERT_EQUAL(obtain(&folder, &it, &error), NB_BAD_USE);
  CU_ASSERT_PTR_NOT_NULL(strstr(error.text, "the file is cut off"));
  CU_ASSERT(written_is(path, "nineball state 1\n"));
  written_free(&before), written_free(&it);
  folder_remove(&folder);
}

/* The message of an aborted run names the page, and the line if there is one. After an interruption the computation of
 * the state continues from its checkpoint, which is then removed. */
static void a_state_that_cannot_be_computed(void) {
  struct folder folder;
  struct written it;
  struct nb_error error = {NB_OK, ""};
  char path[NB_STATE_PATH], checkpoint[NB_STATE_PATH];
  folder_make(&folder);
  nb_note(NULL, "no one reads this"), nb_note(&(struct nb_progress){.data = NULL}, "nor this");
  scene_read(&it, &folder, "until time above 9 at most 2 cycles", "");
  CU_ASSERT_EQUAL(obtain(&folder, &it, &error), NB_BROKEN);
  CU_ASSERT_STRING_EQUAL(error.text,
                         "first, from which this page starts: stage `a` (line 9) did not end within 2 cycles: "
                         "time is 0.2 and should be above 9");
  path_of(path, &folder, &it);
  CU_ASSERT(!present(path));
  strcat(path, ".lock");
  CU_ASSERT(!present(path));
  written_free(&it);
  scene_read(&it, &folder, "step 40 per collision\ncycles 4", "");
  CU_ASSERT_EQUAL(obtain(&folder, &it, &error), NB_BAD_USE);
  if (strncmp(error.text, "first, line 10, from which this page starts: ", 45) != 0)
    printf("# %s\n", error.text);
  CU_ASSERT_EQUAL(strncmp(error.text, "first, line 10, from which this page starts: ", 45), 0);
  written_free(&it);

  scene_read(&it, &folder, "cycles 4", "");
  path_of(path, &folder, &it);
  snprintf(checkpoint, sizeof checkpoint, "%s/first-%016llx.checkpoint", folder.states,
           it.scene.start.scene->stages[0].hash);
  folder.options.checkpoint = (struct nb_checkpointing){.seconds = 1e9, .stop_after = 2};
  CU_ASSERT_EQUAL(obtain(&folder, &it, &error), NB_BROKEN);
  CU_ASSERT(present(checkpoint) && !present(path));
  folder.options.checkpoint = (struct nb_checkpointing){.seconds = 1e9, .resume = true};
  CU_ASSERT_EQUAL(obtain(&folder, &it, &error), NB_OK);
  CU_ASSERT(!present(checkpoint) && present(path));
  written_free(&it);
  folder_remove(&folder);
}

/* Opens the file and locks it, as another process does. The caller closes the file. */
static int locked(const char *path, const char *text) {
  written_text(path, text);
  const int file = open(path, O_RDWR);
  CU_ASSERT_FATAL(file >= 0 && flock(file, LOCK_EX | LOCK_NB) == 0);
  return file;
}

/* A lock without waiting: the file has the number of the process. A lock of another process is refused; so is a path
 * that cannot be opened, or that is a link. */
static void locks_without_waiting(void) {
  static const struct {
    const char *text, *holder;
  } rows[] = {{"123\n456\n", "123"},
              {"9", "9"},
              {"", "?"},
              {"x1", "?"},
              {"1234567890123456789012345678901234567890", "1234567890123456789012345678901"}}; /* at most 31 digits */
  struct folder folder;
  struct nb_lock lock;
  struct nb_error error = {NB_OK, ""};
  char path[64], file[80], wanted[256], process[32];
  folder_make(&folder);
  snprintf(path, sizeof path, "%s/a", folder.path), snprintf(file, sizeof file, "%s.lock", path);
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    const int held = locked(file, rows[k].text);
    CU_ASSERT_EQUAL(nb_lock_own(&lock, path, "sorts coins", "--purse", &error), NB_BAD_USE);
    snprintf(wanted, sizeof wanted,
             "process %s sorts coins, %s: wait for its end, or choose another folder with --purse", rows[k].holder,
             file);
    CU_ASSERT_STRING_EQUAL(error.text, wanted);
    CU_ASSERT(written_is(file, rows[k].text));
    close(held);
  }
  unlink(file);
  const mode_t mask = umask(0);
  CU_ASSERT_EQUAL_FATAL(nb_lock_own(&lock, path, "sorts coins", "--purse", &error), NB_OK);
  umask(mask);
  struct stat status;
  CU_ASSERT(stat(file, &status) == 0 && (status.st_mode & 07777) == 0666);
  CU_ASSERT((fcntl(lock.file, F_GETFD) & FD_CLOEXEC) != 0); /* programs that the process starts do not hold the lock */
  close(lock.file);
  written_text(file, "99999999999999999999\nlonger\n");
  CU_ASSERT_EQUAL_FATAL(nb_lock_own(&lock, path, "sorts coins", "--purse", &error), NB_OK);
  snprintf(process, sizeof process, "%ld\n", (long)getpid());
  CU_ASSERT(written_is(file, process));
  const int other = open(file, O_RDONLY);
  CU_ASSERT(other >= 0 && flock(other, LOCK_EX | LOCK_NB) != 0);
  nb_lock_release(&lock);
  CU_ASSERT(!present(file) && flock(other, LOCK_EX | LOCK_NB) == 0);
  close(other);
  written_text(file, ""), lock.file = -1; /* no lock to release */
  nb_lock_release(&lock);
  CU_ASSERT(present(file));
  unlink(file);
  CU_ASSERT_EQUAL(symlink("nowhere", file), 0);
  CU_ASSERT_EQUAL(nb_lock_own(&lock, path, "sorts coins", "--purse", &error), NB_BAD_USE);
  snprintf(wanted, sizeof wanted, "cannot write %s: ", file);
  CU_ASSERT_EQUAL(strncmp(error.text, wanted, strlen(wanted)), 0);
  folder_remove(&folder);
  CU_ASSERT_EQUAL(nb_lock_own(&lock, path, "sorts coins", "--purse", &error), NB_BAD_USE);
  CU_ASSERT_EQUAL(strncmp(error.text, wanted, strlen(wanted)), 0);
}

/* The wait for a lock ends after NINEBALL_WAIT seconds. The message names the process that the file names. */
static void the_wait_is_limited(void) {
  struct folder folder;
  struct written it;
  struct nb_error error = {NB_OK, ""};
  char path[NB_STATE_PATH], lock[NB_STATE_PATH + 8], wanted[3 * NB_STATE_PATH];
  folder_make(&folder);
  scene_read(&it, &folder, "cycles 3", "");
  path_of(path, &folder, &it);
  snprintf(lock, sizeof lock, "%s.lock", path);
  CU_ASSERT_EQUAL(nb_folder_create(folder.states, &error), NB_OK);
  setenv("NINEBALL_WAIT", "0.2", 1);
  for (int named = 0; named < 2; named++) {
    const int held = locked(lock, named ? "123\n" : "");
    const double began = nb_clock();
    CU_ASSERT_EQUAL(obtain(&folder, &it, &error), NB_BAD_USE);
    CU_ASSERT(nb_clock() - began >= 0.19);
    if (named)
      snprintf(wanted, sizeof wanted,
               "process 123 has held %s for 0.2 s: `ps -p 123` shows what this process does; if it is stopped, `kill "
               "-CONT 123` lets it continue and `kill -KILL 123` ends it; NINEBALL_WAIT=SECONDS waits longer",
               lock);
    else
      snprintf(wanted, sizeof wanted,
               "an unknown process has held %s for 0.2 s: `fuser %s` names it; NINEBALL_WAIT=SECONDS waits longer",
               lock, lock);
    CU_ASSERT_STRING_EQUAL(error.text, wanted);
    snprintf(wanted, sizeof wanted, "waiting for process %s, which writes %s\n", named ? "123" : "?", path);
    CU_ASSERT_STRING_EQUAL(folder.notes, wanted);
    CU_ASSERT(!present(path) && present(lock));
    close(held);
  }
  unsetenv("NINEBALL_WAIT");
  written_free(&it);
  folder_remove(&folder);
}

/* A process that waits gets the lock when the other process ends. If the other process has written the state, the
 * waiting process reads this state; otherwise it computes the state. */
static void waiting_for_another_process(void) {
  enum { ENDS, REMOVES_LOCK, WRITES_STATE, CASES };
  for (int what = 0; what < CASES; what++) {
    struct folder folder;
    struct written it;
    struct nb_error error = {NB_OK, ""};
    char path[NB_STATE_PATH], lock[NB_STATE_PATH + 8], ready[64], byte;
    int pipes[2], status;
    folder_make(&folder);
    scene_read(&it, &folder, "cycles 3", "");
    path_of(path, &folder, &it);
    snprintf(lock, sizeof lock, "%s.lock", path), snprintf(ready, sizeof ready, "%s/ready", folder.path);
    CU_ASSERT_EQUAL(obtain(&folder, &it, &error), NB_OK);
    CU_ASSERT(rename(path, ready) == 0 && pipe(pipes) == 0);
    fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
      const int file = open(lock, O_RDWR | O_CREAT, 0666);
      if (flock(file, LOCK_EX) != 0 || write(file, "123\n", 4) != 4 || write(pipes[1], "x", 1) != 1)
        _exit(1);
      usleep(200000);
      if (what == WRITES_STATE && rename(ready, path) != 0)
        _exit(1);
      if (what != ENDS)
        unlink(lock);
      _exit(0);
    }
    CU_ASSERT_EQUAL(read(pipes[0], &byte, 1), 1);
    close(pipes[0]), close(pipes[1]);
    CU_ASSERT_EQUAL(obtain(&folder, &it, &error), NB_OK);
    CU_ASSERT(waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0);
    CU_ASSERT_EQUAL(strncmp(folder.notes, "waiting for process 123, which writes ", 38), 0);
    CU_ASSERT_EQUAL(strstr(folder.notes, "first running") == NULL, what == WRITES_STATE);
    CU_ASSERT(present(path) && !present(lock));
    written_free(&it);
    folder_remove(&folder);
  }
}

void suite_restart(void) {
  CU_pSuite suite = CU_add_suite("restart", NULL, NULL);
  CU_ADD_TEST(suite, names_of_states);
  CU_ADD_TEST(suite, a_missing_state_is_computed);
  CU_ADD_TEST(suite, pages_that_are_ready);
  CU_ADD_TEST(suite, states_that_are_outdated);
  CU_ADD_TEST(suite, wrong_states_are_refused);
  CU_ADD_TEST(suite, a_state_that_cannot_be_computed);
  CU_ADD_TEST(suite, locks_without_waiting);
  CU_ADD_TEST(suite, the_wait_is_limited);
  CU_ADD_TEST(suite, waiting_for_another_process);
}
