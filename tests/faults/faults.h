/* Faults that are injected: what the two files of the test share.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_FAULTS_H
#define NB_FAULTS_H

#include <stdbool.h>

int nineball_main(int count, char **words); /* main of the program, in whose files the word is replaced */

/* From here on the n-th call that can fail does, counted from 1, and if `lasting` every one after it; 0: none. */
void faults_begin(unsigned long n, bool lasting);
unsigned long faults_calls(void); /* that could have failed so far */

#endif
