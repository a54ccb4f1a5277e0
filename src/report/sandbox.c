/* Confines a program that reads a page, by Landlock (Linux 5.13 and later, landlock(7)) or bubblewrap
 * (bwrap(1)).
 *
 * The program can read the libraries and fonts of the system, one file and one folder. It can write no file. It has no
 * shell and no environment variables of the user. With Landlock it can execute only itself and its ELF loader; with
 * bubblewrap also files in the folders of libraries. With bubblewrap it has no network; with Landlock it has no TCP if
 * the kernel has version 4 of the interface (Linux 6.7).
 *
 * Both methods let the program read the files of the list below. The system's headers may be older than the kernel. So
 * the constants of Landlock are defined here, and prepare_landlock asks the kernel for the version of the interface.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#define _GNU_SOURCE

#include "sandbox.h"

#include <errno.h>
#include <fcntl.h>
#include <link.h>
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

/* Files and folders that gnuplot, its graphics libraries and pandoc read, if they exist. */
static const char *const readable[] = {"/lib",
                                       "/lib64",
                                       "/usr/lib",
                                       "/usr/lib64",
                                       "/usr/local/lib",
                                       "/etc/ld.so.cache",
                                       "/etc/fonts",
                                       "/usr/share/fontconfig",
                                       "/usr/share/fonts",
                                       "/usr/local/share/fonts",
                                       "/usr/share/gnuplot",
                                       "/usr/share/libthai",
                                       "/usr/share/locale",
                                       "/usr/share/pandoc",
                                       "/var/cache/fontconfig"};
enum { READABLE = sizeof readable / sizeof *readable };

static char *const environment[] = {"PATH=/usr/bin:/bin", "HOME=/nonexistent", "LC_ALL=C.UTF-8", NULL};

bool nb_program_find(char *path, size_t size, const char *name) {
  const char *folders = getenv("PATH");
  for (const char *at = folders ? folders : "/usr/bin:/bin"; at;) {
    const size_t length = strcspn(at, ":");
    char *real;
    struct stat status;
    if (length > 0 && snprintf(path, size, "%.*s/%s", (int)length, at, name) < (int)size && access(path, X_OK) == 0 &&
        stat(path, &status) == 0 && S_ISREG(status.st_mode) && (real = realpath(path, NULL))) {
      const bool fits = snprintf(path, size, "%s", real) < (int)size;
      free(real);
      return fits;
    }
    at = at[length] ? at + length + 1 : NULL;
  }
  return false;
}

/* The loader that the header of an ELF program names (elf(5), PT_INTERP). */
static void find_loader(char *loader, const char *program) {
  ElfW(Ehdr) head;
  ElfW(Phdr) part;
  const int file = open(program, O_RDONLY | O_CLOEXEC);
  loader[0] = 0;
  if (file >= 0 && pread(file, &head, sizeof head, 0) == sizeof head && memcmp(head.e_ident, ELFMAG, SELFMAG) == 0)
    for (unsigned k = 0; k < head.e_phnum; k++)
      if (pread(file, &part, sizeof part, (off_t)(head.e_phoff + k * sizeof part)) == sizeof part &&
          part.p_type == PT_INTERP && part.p_filesz < NB_CONFINE_PATH &&
          pread(file, loader, part.p_filesz, (off_t)part.p_offset) == (ssize_t)part.p_filesz)
        loader[part.p_filesz] = 0;
  if (file >= 0)
    close(file);
}

/* ---- Landlock ---- */

#ifndef SYS_landlock_create_ruleset
#define SYS_landlock_create_ruleset 444
#define SYS_landlock_add_rule 445
#define SYS_landlock_restrict_self 446
#endif

/* From linux/landlock.h; the header of Debian 12 has only version 1 of the interface. */
struct ruleset {
  uint64_t fs, net, scoped; /* accesses that are forbidden unless a rule allows them */
};
struct path_rule {
  uint64_t allowed;
  int32_t parent;
} __attribute__((packed));
enum { ASK_VERSION = 1, PATH_BENEATH = 1 };
enum { EXECUTE = 1 << 0, READ_FILE = 1 << 2, READ_FOLDER = 1 << 3 };
static const struct {
  int version;
  struct ruleset forbidden;
} versions[] = {
    {1, {.fs = (1 << 13) - 1}},      /* all file accesses of Linux 5.13 */
    {2, {.fs = 1 << 13}},            /* link or rename into another folder */
    {3, {.fs = 1 << 14}},            /* truncate */
    {4, {.net = 1 << 0 | 1 << 1}},   /* TCP: bind, connect */
    {5, {.fs = 1 << 15}},            /* ioctl of devices */
    {6, {.scoped = 1 << 0 | 1 << 1}} /* abstract sockets and signals of other processes */
};

static bool allow(int rules, const char *path, uint64_t access) {
  struct stat status;
  const int file = open(path, O_PATH | O_CLOEXEC);
  if (file < 0)
    return errno == ENOENT; /* a missing file needs no rule */
  if (fstat(file, &status) == 0 && !S_ISDIR(status.st_mode))
    access &= ~(uint64_t)READ_FOLDER;
  const struct path_rule rule = {access, file};
  const bool allowed = syscall(SYS_landlock_add_rule, rules, PATH_BENEATH, &rule, 0) == 0;
  close(file);
  return allowed;
}

/* Prepares the rules of Landlock. False with the reason if the kernel does not support it. */
static bool prepare_landlock(struct nb_confined *confined, const char **reason) {
  struct ruleset forbidden = {0};
  const long version = syscall(SYS_landlock_create_ruleset, NULL, 0, ASK_VERSION);
  *reason = "Landlock: the kernel does not have it, or it is switched off";
  if (version < 1)
    return false;
  for (size_t k = 0; k < sizeof versions / sizeof *versions; k++)
    if (versions[k].version <= version) {
      forbidden.fs |= versions[k].forbidden.fs;
      forbidden.net |= versions[k].forbidden.net;
      forbidden.scoped |= versions[k].forbidden.scoped;
    }
  confined->rules = (int)syscall(SYS_landlock_create_ruleset, &forbidden, sizeof forbidden, 0);
  if (confined->rules < 0)
    return false;
  bool allowed = fcntl(confined->rules, F_SETFD, FD_CLOEXEC) == 0;
  for (int k = 0; k < READABLE; k++)
    allowed = allowed && allow(confined->rules, readable[k], READ_FILE | READ_FOLDER);
  allowed = allowed && allow(confined->rules, confined->program, READ_FILE | EXECUTE);
  allowed = allowed && (!confined->loader[0] || allow(confined->rules, confined->loader, READ_FILE | EXECUTE));
  allowed = allowed && allow(confined->rules, confined->library, READ_FILE | READ_FOLDER);
  allowed = allowed && allow(confined->rules, confined->text[0], READ_FILE);
  *reason = "Landlock: the kernel refuses a rule";
  return allowed;
}

/* ---- the program, confined ---- */

/* Sets a resource limit, never above the current one. */
static void limit(int what, rlim_t maximum) {
  struct rlimit limits;
  if (getrlimit(what, &limits) == 0 && limits.rlim_max < maximum) /* RLIM_INFINITY is the largest value */
    maximum = limits.rlim_max;
  limits = (struct rlimit){maximum, maximum};
  setrlimit(what, &limits);
}

/* In the child process: drops rights and executes the program. Exits with status 126 if that fails, or 125 if its
 * message cannot be written either. */
_Noreturn static void exec_confined(const struct nb_confined *confined) {
  static const char message[] = "it could not be confined\n";
  const bool landlock = confined->method == NB_CONFINE_LANDLOCK, bwrap = confined->method == NB_CONFINE_BWRAP;
  limit(RLIMIT_CPU, 120);
  limit(RLIMIT_FSIZE, 200 << 20);
  signal(SIGXFSZ, SIG_DFL); /* the limit ends the program, although this process ignores the signal */
  limit(RLIMIT_AS, (rlim_t)4 << 30);
  limit(RLIMIT_CORE, 0);
  alarm(300); /* s of wall time, because a script may sleep */
  if (chdir(confined->folder) == 0 &&
      (bwrap || prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0) && /* bwrap calls this itself, later */
      (!landlock || syscall(SYS_landlock_restrict_self, confined->rules, 0) == 0)) {
    for (int file = 3; file < 1024; file++)
      close(file);
    execve(bwrap ? confined->wrap : confined->program, confined->command, environment);
  }
  if (write(STDERR_FILENO, message, sizeof message - 1) < 0)
    _exit(125);
  _exit(126);
}

int nb_confine_run(const struct nb_confined *confined, int out, int errors) {
  int status = -1;
  fflush(NULL);
  const pid_t child = fork();
  if (child == 0) {
    if (dup2(out, STDOUT_FILENO) < 0 || dup2(errors, STDERR_FILENO) < 0)
      _exit(126);
    close(STDIN_FILENO);
    exec_confined(confined);
  }
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
    continue;
  return status;
}

/* ---- bubblewrap ---- */

struct list {
  char **at;
  int count;
};

static void add(struct list *list, const char *word) { list->at[list->count++] = (char *)word; }

static void add_all(struct list *list, char *const words[]) {
  for (; *words; words++)
    add(list, *words);
  add(list, NULL);
}

static void add_binding(struct list *list, const char *from, const char *to) {
  add(list, "--ro-bind-try"), add(list, from), add(list, to);
}

static bool prepare_bwrap(struct nb_confined *confined, const char **reason) {
  static const char *const fixed[] = {"--unshare-all", "--die-with-parent", "--new-session", "--cap-drop", "ALL"};
  struct list list = {confined->command, 0};
  *reason = "bwrap: not installed (its package is bubblewrap)";
  if (!nb_program_find(confined->wrap, sizeof confined->wrap, "bwrap"))
    return false;
  add(&list, "bwrap");
  for (size_t k = 0; k < sizeof fixed / sizeof *fixed; k++)
    add(&list, fixed[k]);
  for (int k = 0; k < READABLE; k++)
    add_binding(&list, readable[k], readable[k]);
  add_binding(&list, confined->program, confined->program);
  add_binding(&list, confined->library, confined->library);
  snprintf(confined->text[1], sizeof confined->text[1], "/figure/%s", confined->file);
  add_binding(&list, confined->text[0], confined->text[1]);
  add(&list, "--chdir"), add(&list, "/figure"), add(&list, "--"), add(&list, confined->program);
  /* Test whether bwrap works, because containers often forbid namespaces. */
  const int first = list.count;
  add(&list, "--version"), add(&list, NULL);
  const int null = open("/dev/null", O_WRONLY);
  const bool works = null >= 0 && nb_confine_run(confined, null, null) == 0;
  if (null >= 0)
    close(null);
  *reason = "bwrap: it cannot make a namespace here";
  list.count = first;
  add_all(&list, confined->arguments);
  return works;
}

/* ---- choice of the method ---- */

enum nb_status nb_confine_begin(struct nb_confined *confined, bool trust, struct nb_error *error) {
  const char *choice = getenv("NINEBALL_CONFINE"), *landlock = "Landlock: not requested",
             *bwrap = "bwrap: not requested";
  confined->rules = -1;
  if (choice && strcmp(choice, "landlock") != 0 && strcmp(choice, "bwrap") != 0 && strcmp(choice, "none") != 0)
    return nb_error_set(error, NB_BAD_USE, "NINEBALL_CONFINE: expected landlock, bwrap or none, found `%.100s`",
                        choice);
  find_loader(confined->loader, confined->program);
  snprintf(confined->text[0], sizeof confined->text[0], "%s/%s", confined->folder, confined->file);
  confined->method = NB_CONFINE_LANDLOCK;
  if ((!choice || strcmp(choice, "landlock") == 0) && prepare_landlock(confined, &landlock))
    ;
  else if ((!choice || strcmp(choice, "bwrap") == 0) &&
           (confined->method = NB_CONFINE_BWRAP, prepare_bwrap(confined, &bwrap)))
    return NB_OK;
  else if (trust)
    confined->method = NB_CONFINE_NONE;
  else
    return nb_error_set(error, NB_BAD_USE,
                        "gnuplot cannot be confined here (%s; %s), and the page's gnuplot block could do whatever you "
                        "can; if you trust the page, give --trust",
                        landlock, bwrap);
  struct list list = {confined->command, 0};
  add(&list, confined->program);
  add_all(&list, confined->arguments);
  return NB_OK;
}

void nb_confine_end(struct nb_confined *confined) {
  if (confined->rules >= 0)
    close(confined->rules);
  confined->rules = -1;
}
