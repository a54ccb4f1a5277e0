/* Fault injection: functions shared by the two files of the test.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_FAULTS_H
#define NB_FAULTS_H

#include <stdbool.h>

int nineball_main(int count, char **words); /* main of the program, renamed */

/* From now on the n-th call that can fail fails, counted from 1, and if `lasting` all later ones too; 0: none. */
void faults_begin(unsigned long n, bool lasting);
unsigned long faults_calls(void); /* number of calls so far that could have failed */

#endif
