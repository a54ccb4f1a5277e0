/* Makes every call fail that can fail. The program runs small pages, each time in a new process and folder, and the
 * n-th call fails, for each n. The run may have the status of the undisturbed run only if all files are the same to the
 * last byte. Otherwise it must have another status, a message, and no incomplete file; if the call failed for lack of
 * memory, the status is that of lack of memory. Signals, reports of a sanitizer and leaks are failures.
 *
 *   tests/faults/run [CASE [N]]    all cases; one case; only the N-th call of one case, and the folder stays
 *
 * Prints TAP, the Test Anything Protocol. Builds without sanitizers skip this test. A function of the test replaces
 * gnuplot.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "faults.h"
#include "nineball.h"
#include "pages.h"

#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#undef main /* main of the program is nineball_main */

#if defined __has_feature
#if __has_feature(address_sanitizer)
#define SANITIZED 1
#endif
#elif defined __SANITIZE_ADDRESS__
#define SANITIZED 1
#endif

enum { PATH_SIZE = 4096, REPORTED = 99, SECONDS = 60 };

/* ---- files ---- */

static char top[PATH_SIZE]; /* folder of the test */

static void die(const char *what) {
  printf("Bail out! %s: %s\n", what, strerror(errno));
  exit(1);
}

/* The contents of a file, with a terminating zero; *size becomes the size of the file. NULL if there is no file. */
static char *bytes_of(const char *path, size_t *size) {
  FILE *file = fopen(path, "r");
  struct stat status;
  if (!file || fstat(fileno(file), &status) != 0)
    return file ? fclose(file), NULL : NULL;
  char *bytes = malloc((size_t)status.st_size + 1);
  *size = bytes ? fread(bytes, 1, (size_t)status.st_size, file) : 0;
  if (bytes)
    bytes[*size] = 0;
  fclose(file);
  return bytes;
}

static void put(const char *folder, const char *name, const char *text, mode_t mode) {
  char path[PATH_SIZE];
  snprintf(path, sizeof path, "%.2000s/%.1000s", folder, name);
  const int file = open(path, O_WRONLY | O_CREAT | O_TRUNC, mode);
  if (file < 0 || write(file, text, strlen(text)) != (ssize_t)strlen(text) || close(file) != 0)
    die(path);
}

static int remove_one(const char *path, const struct stat *status, int kind, struct FTW *at) {
  (void)status, (void)kind, (void)at;
  return remove(path);
}
static void clear(const char *folder) { nftw(folder, remove_one, 8, FTW_DEPTH | FTW_PHYS); }

/* A walk through a folder, which is compared with another one. */
static struct {
  const char *folder, *other;
  size_t files;
  char odd[PATH_SIZE]; /* the first file that is missing in the other folder or differs from the file there */
} walk;

/* Removes all numbers from each line with a measured time, unless this time is 0 s. Returns the new size. */
static size_t without_times(char *text) {
  char *to = text;
  for (char *line = text, *end; *line; line = end) {
    end = line + strcspn(line, "\n"), end += *end == '\n';
    const char kept = *end;
    *end = 0;
    const bool timed =
        (strstr(line, "measured just now") || strstr(line, " contact updates, ")) && !strstr(line, ", 0 s");
    *end = kept;
    for (char *c = line; c < end; c++)
      if (!timed || !strchr("0123456789.e+-", *c))
        *to++ = *c;
  }
  *to = 0;
  return (size_t)(to - text);
}

static int compare_one(const char *path, const struct stat *status, int kind, struct FTW *at) {
  char other[PATH_SIZE];
  (void)status, (void)at;
  if (kind != FTW_F)
    return 0;
  const char *name = path + strlen(walk.folder);
  snprintf(other, sizeof other, "%.2000s%.2000s", walk.other, name);
  size_t size = 0, wanted = 0;
  char *mine = bytes_of(path, &size), *its = bytes_of(other, &wanted);
  if (mine && its && strcmp(name, "/out") == 0)
    size = without_times(mine), wanted = without_times(its);
  if (strcmp(name, "/said") != 0) {
    walk.files++;
    if ((!mine || !its || size != wanted || memcmp(mine, its, size) != 0) && !walk.odd[0])
      snprintf(walk.odd, sizeof walk.odd, "%s", name);
  }
  free(mine), free(its);
  return 0;
}

/* Compares two folders. Returns the number of files of the first one; walk.odd is a file that differs. */
static size_t compare(const char *folder, const char *other) {
  walk.folder = folder, walk.other = other, walk.files = 0, walk.odd[0] = 0;
  nftw(folder, compare_one, 8, FTW_PHYS);
  return walk.files;
}

/* ---- one run ---- */

static void prepare(const char *folder) {
  clear(folder);
  if (mkdir(folder, 0777) != 0)
    die(folder);
  for (int k = 0; k < FILES; k++)
    put(folder, files[k].name, files[k].text, 0666);
}

static int to_file(const char *name, int as) {
  const int file = open(name, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  return file < 0 ? -1 : dup2(file, as);
}

/* The number of calls of a run that could have failed, and errno of the call that was made to fail. */
struct made {
  unsigned long calls;
  int reason;
};

/* Runs a case in which call n fails, and if `lasting` all later calls. Returns the status that waitpid gives. */
static int run(int number, const char *folder, unsigned long n, bool lasting, struct made *made) {
  int ends[2], status;
  prepare(folder);
  if (pipe(ends) != 0)
    die("pipe");
  fflush(stdout);
  const pid_t child = fork();
  if (child < 0)
    die("fork");
  if (child == 0) {
    char *words[9] = {NULL};
    int count = 0;
    for (; cases[number][count]; count++)
      words[count] = (char *)cases[number][count];
    alarm(SECONDS);
    if (chdir(folder) != 0 || to_file("out", 1) < 0 || to_file("said", 2) < 0)
      _exit(98);
    faults_begin(n, lasting);
    const int mine = nineball_main(count, words);
    *made = (struct made){faults_calls(), faults_reason()};
    faults_begin(0, false);
    if (write(ends[1], made, sizeof *made) != sizeof *made)
      _exit(97);
    exit(mine); /* the sanitizer looks for leaks here */
  }
  close(ends[1]);
  if (read(ends[0], made, sizeof *made) != sizeof *made)
    *made = (struct made){0};
  close(ends[0]);
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR)
      die("waitpid");
  return status;
}

/* The reason why a run with this status of waitpid and these files in `folder` fails the test; NULL: it passes. The run
 * without failing calls had the exit status `undisturbed` and left `whole` files in the folder `wanted`. `memory`: only
 * one call failed, for lack of memory. */
static const char *verdict(int status, int undisturbed, bool memory, const char *folder, const char *wanted,
                           size_t whole) {
  static char what[2 * PATH_SIZE];
  char path[PATH_SIZE];
  size_t size = 0;
  snprintf(path, sizeof path, "%.2000s/said", folder);
  char *given = bytes_of(path, &size);
  const bool reported = given && (strstr(given, "Sanitizer") || strstr(given, "runtime error"));
  free(given);
  if (WIFSIGNALED(status))
    return snprintf(what, sizeof what, "signal %d", WTERMSIG(status)), what;
  if (reported || WEXITSTATUS(status) == REPORTED)
    return "a report of a sanitizer";
  if (WEXITSTATUS(status) != undisturbed && size == 0)
    return "no message";
  if (WEXITSTATUS(status) != undisturbed && memory && WEXITSTATUS(status) != NB_NO_MEMORY)
    return snprintf(what, sizeof what, "status %d, expected %d: no memory", WEXITSTATUS(status), NB_NO_MEMORY), what;
  if (WEXITSTATUS(status) != undisturbed) { /* standard output may be incomplete */
    snprintf(path, sizeof path, "%.2000s/out", folder);
    remove(path);
  }
  const size_t files_there = compare(folder, wanted);
  if (walk.odd[0])
    return snprintf(what, sizeof what, "status %d, and a wrong file: %s", WEXITSTATUS(status), walk.odd), what;
  if (WEXITSTATUS(status) == undisturbed && files_there != whole)
    return snprintf(what, sizeof what, "status %d with %zu of %zu files", undisturbed, files_there, whole), what;
  return NULL;
}

/* Tests every call of a case, or only the call number `only` if this is not 0. True if all calls pass. */
static bool inject(int number, unsigned long only) {
  char wanted[PATH_SIZE], folder[PATH_SIZE];
  unsigned long wrong = 0;
  struct made all, made;
  snprintf(wanted, sizeof wanted, "%.2000s/wanted", top);
  snprintf(folder, sizeof folder, "%.2000s/now", top);
  const int undisturbed = run(number, wanted, 0, false, &all);
  const unsigned long calls = all.calls;
  const size_t whole = compare(wanted, wanted);
  const int meant = strcmp(cases[number][2], "wrong.md") == 0 ? 2 : 0;
  if (!WIFEXITED(undisturbed) || WEXITSTATUS(undisturbed) != meant || calls == 0)
    return printf("# the undisturbed run has the wait status %d after %lu calls\n", undisturbed, calls), false;
  for (unsigned long n = only ? only : 1; n <= (only ? only : calls); n++)
    for (int lasting = 0; lasting < (only || n % 8 == 1 ? 2 : 1); lasting++) {
      const int status = run(number, folder, n, lasting, &made);
      const char *what =
          verdict(status, WEXITSTATUS(undisturbed), !lasting && made.reason == ENOMEM, folder, wanted, whole);
      if (what && wrong++ < 20)
        printf("# call %lu of %lu%s: %s\n", n, calls, lasting ? " and all after it" : "", what);
      if (what && only)
        return false;
    }
  printf("# %lu calls, %lu wrong\n", calls, wrong);
  return wrong == 0;
}

const char *__asan_default_options(void);
const char *__asan_default_options(void) { return "exitcode=99:detect_leaks=1"; }

int main(int count, char **words) {
#ifndef SANITIZED
  (void)inject;
  puts("1..0 # SKIP no sanitizer would see an error: configure with CFLAGS=\"-g -O1 -fsanitize=address,undefined\"");
  return count > 99 && words;
#else
  const char *folder = getenv("TMPDIR");
  char plots[PATH_SIZE];
  bool all = true;
  snprintf(top, sizeof top, "%.1000s/nineball-faults-XXXXXX", folder ? folder : "/tmp");
  if (!mkdtemp(top))
    die(top);
  unsetenv("NINEBALL_STATES");
  snprintf(plots, sizeof plots, "%s/plots", getenv("srcdir") ? getenv("srcdir") : ".");
  char *recipes = realpath(plots, NULL), *own = realpath("/proc/self/exe", NULL);
  if (!recipes || !own)
    die(plots);
  snprintf(plots, sizeof plots, "%.*s/plots", (int)(strrchr(own, '/') - own),
           own); /* the program looks here for the style of figures */
  if (symlink(recipes, plots) != 0 && errno != EEXIST)
    die(plots);
  free(recipes), free(own);
  printf("1..%d\n", CASES);
  for (int k = 0; k < CASES; k++)
    if (count < 2 || atoi(words[1]) == k + 1) {
      fflush(stdout);
      const bool good = inject(k, count > 2 ? strtoul(words[2], NULL, 10) : 0);
      printf("%sok %d - nineball %s %s\n", good ? "" : "not ", k + 1, cases[k][1], cases[k][2]);
      all = all && good;
    }
  remove(plots);
  if (count < 3)
    clear(top);
  else
    printf("# see %s\n", top);
  return !all;
#endif
}
