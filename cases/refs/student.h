/* Student's distribution, for what is said of samples.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef STUDENT_H
#define STUDENT_H

/* The mean of n values lies within so many times s/sqrt(n) of what they are drawn around, s their standard deviation, with a
 * confidence of `share`; infinite for n = 1. */
double student_quantile(double n, double fraction);

#endif
