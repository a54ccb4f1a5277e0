/* libFuzzer with one reader, FUZZ_READER.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "fuzz.h"

int LLVMFuzzerInitialize(int *count, char ***words);
int LLVMFuzzerTestOneInput(const unsigned char *bytes, size_t size);
size_t LLVMFuzzerCustomMutator(unsigned char *bytes, size_t size, size_t most, unsigned seed);
size_t LLVMFuzzerMutate(unsigned char *bytes, size_t size, size_t most);

int LLVMFuzzerInitialize(int *count, char ***words) {
  (void)count, (void)words;
  fuzz_saves_time = true;
  return 0;
}

int LLVMFuzzerTestOneInput(const unsigned char *bytes, size_t size) {
  if (size > FUZZ_READER.longest)
    return -1; /* not read, so not kept */
  fuzz_begin(bytes, size);
  FUZZ_READER.read(bytes, size);
  return 0;
}

/* Half of the changes are those of change.c, of a byte, a word, a line or a number; the other half are libFuzzer's own. */
size_t LLVMFuzzerCustomMutator(unsigned char *bytes, size_t size, size_t most, unsigned seed) {
  unsigned long long chance = seed * 2654435761ULL + 1;
  return seed % 2 ? LLVMFuzzerMutate(bytes, size, most)
                  : (seed % 4 ? fuzz_change : fuzz_change_number)(bytes, size, most, &chance);
}
