/* Chooses the mutant from $NB_MUTANT. The sites that a program reaches are noted in the file $NB_SITES, which has a byte
 * for each. It is mapped into memory, so processes can share it and one that crashes loses nothing.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "schemata.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

static unsigned char without_file[NB_SITES_MOST];
int nb_mutant;
unsigned char *nb_site_reached = without_file;

__attribute__((constructor)) static void choose_mutant(void) {
  const char *number = getenv("NB_MUTANT"), *path = getenv("NB_SITES");
  nb_mutant = number ? atoi(number) : 0;
  const int file = path ? open(path, O_RDWR) : -1;
  if (file < 0)
    return;
  void *bytes = mmap(NULL, sizeof without_file, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  if (bytes != MAP_FAILED)
    nb_site_reached = bytes;
  close(file);
}
