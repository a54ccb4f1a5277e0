/* Output files: complete or absent, under their temporary names, and leftovers of killed processes.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../src/run/output_file.h"
#include "suites.h"
#include "written.h"

enum { PATH = 128 };
static char folder[] = "/tmp/nineball-output-XXXXXX";

static int files; /* number of open files before the first test */

static int make_folder(void) {
  files = written_open_files();
  return mkdtemp(folder) == NULL;
}
static int remove_folder(void) { return rmdir(folder); }

/* The text of an error has the reason of the system. If memory ran out, it says what to do instead. */
static void errors_of_the_system(void) {
  for (int memory = 0; memory < 2; memory++) {
    struct nb_error error;
    errno = memory ? ENOMEM : ENOSPC;
    CU_ASSERT_EQUAL(nb_error_system(&error, "cannot write %s", "a"), memory ? NB_NO_MEMORY : NB_BAD_USE);
    CU_ASSERT_STRING_EQUAL(error.text,
                           memory ? "out of memory; make fewer runs at the same time, for example with --jobs 1"
                                  : "cannot write a: No space left on device");
  }
}

static void all_files_are_closed(void) { CU_ASSERT_EQUAL(written_open_files(), files); }

/* The path of a file in the folder. */
static const char *in_folder(char path[PATH], const char *name) {
  snprintf(path, PATH, "%s/%s", folder, name);
  return path;
}

static bool present(const char *path) {
  struct stat status;
  return lstat(path, &status) == 0;
}

static bool is_locked(const char *path) {
  const int file = open(path, O_RDONLY);
  const bool locked = file >= 0 && flock(file, LOCK_EX | LOCK_NB) != 0;
  close(file);
  return locked;
}

/* The file is written as PATH.NUMBER.new, which is locked. NUMBER is that of the process, or the next one that no other
 * file has. The file gets its name at the end; if it is discarded, the old file stays. */
static void files_are_renamed(void) {
  char path[PATH], first[PATH + 32], second[PATH + 32];
  struct nb_save save, other;
  struct nb_error error = {NB_OK, ""};
  in_folder(path, "a");
  written_text(path, "old");
  snprintf(first, sizeof first, "%s.%ld.new", path, (long)getpid());
  snprintf(second, sizeof second, "%s.%ld.new", path, (long)getpid() + 1);
  for (int end = 0; end < 2; end++) {
    CU_ASSERT_EQUAL_FATAL(nb_save_begin(&save, path, &error), NB_OK);
    CU_ASSERT_EQUAL_FATAL(nb_save_begin(&other, path, &error), NB_OK);
    CU_ASSERT_STRING_EQUAL(save.path, path);
    CU_ASSERT_STRING_EQUAL(save.temporary, first);
    CU_ASSERT_STRING_EQUAL(other.temporary, second);
    CU_ASSERT(is_locked(first) && is_locked(second) && written_is(path, "old"));
    CU_ASSERT(fputs("new", save.file) >= 0 && fseek(save.file, 0, SEEK_SET) == 0);
    CU_ASSERT_EQUAL(fgetc(save.file), 'n'); /* the file can be read */
    CU_ASSERT(fseek(save.file, 0, SEEK_END) == 0 && fputs("er", save.file) >= 0);
    nb_save_cancel(&other);
    CU_ASSERT(present(first) && !present(second));
    if (end)
      CU_ASSERT_EQUAL(nb_save_end(&save, &error), NB_OK);
    if (!end)
      nb_save_cancel(&save);
    CU_ASSERT(written_is(path, end ? "newer" : "old") && !present(first));
    CU_ASSERT(!save.file && !save.path && !save.temporary);
  }
  unlink(path);
}

/* A temporary file is new, even if a link with its name leads to a file that does not exist. Other programs do not keep it
 * open. */
static void temporary_files_are_new(void) {
  char path[PATH], first[PATH + 32], other[PATH];
  struct stat status;
  struct nb_save save;
  struct nb_error error = {NB_OK, ""};
  snprintf(first, sizeof first, "%s.%ld.new", in_folder(path, "a"), (long)getpid());
  CU_ASSERT_EQUAL(symlink("b", first), 0);
  const mode_t mask = umask(0);
  CU_ASSERT_EQUAL_FATAL(nb_save_begin(&save, path, &error), NB_OK);
  umask(mask);
  CU_ASSERT(!present(in_folder(other, "b")) && strcmp(save.temporary, first) != 0);
  CU_ASSERT(stat(save.temporary, &status) == 0 && (status.st_mode & 07777) == 0666);
  CU_ASSERT((fcntl(fileno(save.file), F_GETFD) & FD_CLOEXEC) != 0);
  nb_save_cancel(&save);
  CU_ASSERT_EQUAL(unlink(first), 0);
}

/* Temporary files that no process has locked are removed. So are named pipes. Files with other names, links and
 * folders are kept. */
static void leftovers_are_removed(void) {
  static const struct {
    const char *name;
    bool removed;
  } rows[] = {{"a.1.new", true},   {"a.1234567890.new", true}, {"a.new", false},   {"a..new", false},
              {"a.x.new", false},  {"a.1x.new", false},        {"a.1.ne", false},  {"a.1.newer", false},
              {"a1.new", false},   {"ab.1.new", false},        {"b.1.new", false}, {"a-1.new", false},
              {"a.1.new.1", false}};
  char path[PATH], other[PATH], before[PATH];
  struct nb_save save;
  struct nb_error error = {NB_OK, ""};
  CU_ASSERT_PTR_NOT_NULL_FATAL(getcwd(before, sizeof before));
  in_folder(path, "a");
  for (int here = 0; here < 2; here++) { /* the path has no folder if it is in the current one */
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
      written_text(in_folder(other, rows[k].name), "");
    CU_ASSERT_EQUAL(symlink("b.1.new", in_folder(other, "a.2.new")), 0);
    CU_ASSERT_EQUAL(mkdir(in_folder(other, "a.3.new"), 0777), 0);
    CU_ASSERT_EQUAL(mkfifo(in_folder(other, "a.5.new"), 0666), 0); /* to open it would wait */
    written_text(in_folder(other, "a.4.new"), "");
    const int held = open(other, O_RDONLY);
    CU_ASSERT(held >= 0 && flock(held, LOCK_EX | LOCK_NB) == 0);
    CU_ASSERT_EQUAL_FATAL(here ? chdir(folder) : 0, 0);
    CU_ASSERT_EQUAL_FATAL(nb_save_begin(&save, here ? "a" : path, &error), NB_OK);
    nb_save_cancel(&save);
    CU_ASSERT_EQUAL_FATAL(chdir(before), 0);
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
      CU_ASSERT_EQUAL(present(in_folder(other, rows[k].name)), !rows[k].removed);
      unlink(other);
    }
    CU_ASSERT(present(in_folder(other, "a.4.new")) && unlink(other) == 0);
    CU_ASSERT(present(in_folder(other, "a.3.new")) && rmdir(other) == 0);
    CU_ASSERT(present(in_folder(other, "a.2.new")) && unlink(other) == 0);
    CU_ASSERT(!present(in_folder(other, "a.5.new")));
    close(held);
  }
}

/* After an error there is no temporary file, and nothing to free. */
static void files_that_cannot_be_written(void) {
  char path[PATH], wanted[2 * PATH];
  struct nb_save save;
  struct nb_error error = {NB_OK, ""};
  in_folder(path, "none/a");
  CU_ASSERT_EQUAL(nb_save_begin(&save, path, &error), NB_BAD_USE);
  snprintf(wanted, sizeof wanted, "cannot write %s: No such file or directory", path);
  CU_ASSERT_STRING_EQUAL(error.text, wanted);
  CU_ASSERT(!save.file && !save.path && !save.temporary);
  in_folder(path, "a");
  CU_ASSERT_EQUAL(mkdir(path, 0777), 0);
  CU_ASSERT_EQUAL_FATAL(nb_save_begin(&save, path, &error), NB_OK);
  CU_ASSERT_EQUAL(nb_save_end(&save, &error), NB_BAD_USE);
  snprintf(wanted, sizeof wanted, "cannot write %s: Is a directory", path);
  CU_ASSERT_STRING_EQUAL(error.text, wanted);
  CU_ASSERT(!save.file && !save.path && !save.temporary);
  CU_ASSERT_EQUAL(rmdir(path), 0);
}

/* The message has the reason of the system, whether the write fails at once (many bytes) or when the buffer is flushed
 * (a few bytes). */
static void files_that_become_too_large(void) {
  static const size_t sizes[] = {100000, 10};
  char path[PATH], wanted[2 * PATH];
  in_folder(path, "a");
  snprintf(wanted, sizeof wanted, "cannot write %s: File too large", path);
  for (int k = 0; k < 2; k++) {
    int status;
    fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
      struct nb_save save;
      struct nb_error error = {NB_OK, ""};
      signal(SIGXFSZ, SIG_IGN);
      setrlimit(RLIMIT_FSIZE, &(struct rlimit){5, 5});
      if (nb_save_begin(&save, path, &error))
        _exit(1);
      for (size_t n = 0; n < sizes[k]; n++)
        fputc('x', save.file);
      _exit(nb_save_end(&save, &error) == NB_BAD_USE && strcmp(error.text, wanted) == 0 ? 0 : 2);
    }
    CU_ASSERT(waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0);
    CU_ASSERT(!present(path));
    snprintf(path + strlen(path), sizeof path - strlen(path), ".%ld.new", (long)child);
    CU_ASSERT(!present(path));
    in_folder(path, "a");
  }
}

/* A file is replaced where it is, if a link leads to it, and keeps its permissions. A file that is missing is not
 * made. */
static void files_that_are_replaced(void) {
  char path[PATH], link[PATH], wanted[2 * PATH];
  struct stat status;
  struct nb_save save;
  struct nb_error error = {NB_OK, ""};
  in_folder(path, "a"), in_folder(link, "b");
  CU_ASSERT_EQUAL(symlink("a", link), 0);
  CU_ASSERT_EQUAL(nb_save_replace_begin(&save, link, &error), NB_BAD_USE);
  snprintf(wanted, sizeof wanted, "cannot write %s: No such file or directory", link);
  CU_ASSERT_STRING_EQUAL(error.text, wanted);
  written_text(path, "old");
  CU_ASSERT_EQUAL(chmod(path, 0741), 0);
  CU_ASSERT_EQUAL_FATAL(nb_save_replace_begin(&save, link, &error), NB_OK);
  fputs("new", save.file);
  CU_ASSERT_EQUAL(nb_save_end(&save, &error), NB_OK);
  CU_ASSERT(written_is(path, "new") && lstat(link, &status) == 0 && S_ISLNK(status.st_mode));
  CU_ASSERT(stat(path, &status) == 0 && (status.st_mode & 07777) == 0741);
  unlink(path), unlink(link);
}

/* A file without permission to write is not replaced, although its folder could be written. An administrator may write
 * everything, so the process gives up its rights. */
static void files_without_permission(void) {
  char path[PATH], wanted[2 * PATH];
  int status;
  in_folder(path, "a");
  snprintf(wanted, sizeof wanted, "cannot write %s: Permission denied", path);
  written_text(path, "old");
  CU_ASSERT(chmod(path, 0444) == 0 && chmod(folder, 0777) == 0);
  fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    struct nb_save save;
    struct nb_error error = {NB_OK, ""};
    if (geteuid() == 0 && setuid(65534) != 0)
      _exit(1);
    _exit(nb_save_replace_begin(&save, path, &error) == NB_BAD_USE && strcmp(error.text, wanted) == 0 ? 0 : 2);
  }
  CU_ASSERT(waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0);
  CU_ASSERT(written_is(path, "old") && unlink(path) == 0);
}

/* A folder is created with those above it. Folders that exist are accepted, also through a link; a file is refused. */
static void folders_are_created(void) {
  static const struct {
    const char *name, *reason; /* NULL: the folder is created */
  } rows[] = {{"x", NULL},       {"x", NULL},      {"x/y/z", NULL},        {"x/l", NULL},
              {"x/l/w/v", NULL}, {"x//y/u", NULL}, {"x/f", "File exists"}, {"x/f/g", "Not a directory"}};
  char path[PATH], command[PATH], wanted[2 * PATH];
  CU_ASSERT_EQUAL_FATAL(mkdir(in_folder(path, "x"), 0777), 0);
  CU_ASSERT_EQUAL(symlink(".", in_folder(path, "x/l")), 0);
  written_text(in_folder(path, "x/f"), "");
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_error error = {NB_BROKEN, ""};
    struct stat status;
    in_folder(path, rows[k].name);
    CU_ASSERT_EQUAL(nb_folder_create(path, &error), rows[k].reason ? NB_BAD_USE : NB_OK);
    CU_ASSERT_EQUAL(error.status, rows[k].reason ? NB_BAD_USE : NB_OK);
    snprintf(wanted, sizeof wanted, "cannot make the folder %s: %s", path, rows[k].reason ? rows[k].reason : "");
    CU_ASSERT_STRING_EQUAL(error.text, rows[k].reason ? wanted : "");
    CU_ASSERT(rows[k].reason || (stat(path, &status) == 0 && S_ISDIR(status.st_mode)));
  }
  snprintf(command, sizeof command, "rm -r %s/x", folder);
  CU_ASSERT_EQUAL(system(command), 0);
}

void suite_output_file(void) {
  CU_pSuite suite = CU_add_suite("output_file", make_folder, remove_folder);
  CU_ADD_TEST(suite, files_are_renamed);
  CU_ADD_TEST(suite, temporary_files_are_new);
  CU_ADD_TEST(suite, leftovers_are_removed);
  CU_ADD_TEST(suite, files_that_cannot_be_written);
  CU_ADD_TEST(suite, files_that_become_too_large);
  CU_ADD_TEST(suite, files_that_are_replaced);
  CU_ADD_TEST(suite, files_without_permission);
  CU_ADD_TEST(suite, folders_are_created);
  CU_ADD_TEST(suite, errors_of_the_system);
  CU_ADD_TEST(suite, all_files_are_closed);
}
