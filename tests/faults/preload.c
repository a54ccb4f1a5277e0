/* A shared object for LD_PRELOAD, which makes an allocation of a process fail, in any library. tests/faults/run makes
 * only calls of the program itself fail.
 *
 *   FAIL_AT=N     the N-th call of malloc, calloc or realloc fails, counted from 1
 *   FAIL_AT=N+    this call and all later ones fail
 *   FAIL_COUNT=FILE     at the end the number of calls is written to FILE
 *
 * For the C library of GNU only. Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

extern char **environ;
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *old, size_t size);

/* getenv may not be called before the C library is ready. */
static const char *setting(const char *name) {
  const size_t length = strlen(name);
  for (char **entry = environ; entry && *entry; entry++)
    if (strncmp(*entry, name, length) == 0)
      return *entry + length;
  return NULL;
}

static unsigned long calls;

static bool fails(void) {
  static unsigned long at;
  static bool read, lasting;
  if (!read) {
    const char *text = setting("FAIL_AT=");
    for (; text && *text >= '0' && *text <= '9'; text++)
      at = 10 * at + (unsigned long)(*text - '0');
    lasting = text && *text == '+';
    read = true;
  }
  const unsigned long call = __atomic_add_fetch(&calls, 1, __ATOMIC_RELAXED);
  if (at == 0 || !(call == at || (lasting && call > at)))
    return false;
  errno = ENOMEM;
  return true;
}

void *malloc(size_t size) { return fails() ? NULL : __libc_malloc(size); }
void *calloc(size_t count, size_t size) { return fails() ? NULL : __libc_calloc(count, size); }
void *realloc(void *old, size_t size) { return fails() ? NULL : __libc_realloc(old, size); }

__attribute__((destructor)) static void write_count(void) {
  const char *path = setting("FAIL_COUNT=");
  const int file = path ? open(path, O_WRONLY | O_CREAT | O_TRUNC, 0600) : -1;
  if (file < 0)
    return;
  char digits[24];
  size_t begin = sizeof digits;
  for (unsigned long rest = calls; rest > 0; rest /= 10)
    digits[--begin] = (char)('0' + rest % 10);
  if (write(file, digits + begin, sizeof digits - begin) < 0)
    abort();
  close(file);
}
