/* Between what carries an assembly (drive.c) and what makes it follow a stress (servo.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_SERVO_H
#define NB_SERVO_H

#include "drive.h"

void nb_servo_begin(struct nb_model *model); /* once the stage's other statements hold */
/* B, Pa, and T, s, that gains are made of now; false: there is nothing yet that a servo could move, or nothing is pressed. */
bool nb_servo_scales(const struct nb_model *model, const struct nb_servo *servo, double *b, double *t);
void nb_servo_set(struct nb_model *model); /* before a motion: the strain rates over the steps to come */

#endif
