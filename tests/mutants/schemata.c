/* Chooses the mutant whose number is in $NB_MUTANT. The file $NB_SITES has a byte for each site (schemata.h). The byte
 * becomes 1 when a program reaches the site. The file is mapped into memory, so processes can share it, and no mark is
 * lost if a process crashes.
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
