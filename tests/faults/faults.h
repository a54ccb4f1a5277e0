/* Fault injection: functions shared by the two files of the test.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stdbool.h>

int nineball_main(int count, char **words); /* the function main of the program, renamed */

/* From now on the calls that can fail are counted from 1, and call n fails; n = 0: none fails. `lasting`: all later
 * ones fail too. */
void faults_begin(unsigned long n, bool lasting);
unsigned long faults_calls(void); /* number of calls so far that could have failed */
int faults_reason(void);          /* errno of the last call that was made to fail; 0: none */
