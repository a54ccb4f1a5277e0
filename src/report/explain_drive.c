/* What moves the assembly in a stage, in words: circle, boundary, continuum, cell, rotation, servo.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "core/names.h"
#include "explain.h"
#include "loading/servo.h"

static void rate(FILE *out, const char *what, const struct nb_strain_rate *strain, bool unitless, const char *more,
                 int line) {
  fprintf(out, "    %s carried by xx %g, yy %g, xy %g, yx %g%s%s (line %d)\n", what, strain->xx, strain->yy, strain->xy,
          strain->yx,
          strain->per_cycle ? " per cycle"
          : unitless        ? ""
                            : " 1/s",
          more, line);
}

static void explain_boundary(FILE *out, const struct nb_boundary *to, bool unitless) {
  switch (to->control) {
  case NB_CONTROL_STRAIN:
    rate(out, "boundary", &to->strain, unitless, "", to->line);
    break;
  case NB_CONTROL_STRESS:
    fprintf(out, "    boundary free, under a stress of xx %g, yy %g, xy %g%s (line %d)\n", to->sxx, to->syy, to->sxy,
            unitless ? "" : " Pa", to->line);
    break;
  case NB_CONTROL_NONE:
    fprintf(out, "    boundary none: its bodies are free (line %d)\n", to->line);
    break;
  }
}

/* The region that is looked at, or `boundary`, `cell`, `box`: what stands before `.stress` or is watched. */
static void explain_place(FILE *out, const struct nb_scene *scene, const struct nb_servo *servo) {
  const struct nb_quantity *seen = &servo->quantity[0];
  const char *name = seen->watch < 0 ? seen->kind->name : scene->watches[seen->watch].name;
  fprintf(out, " on %.*s", (int)strcspn(name, "."), name);
}

/* B and T as the scene begins, where something is pressed then. */
static void explain_gain(FILE *out, const struct nb_model *model, const struct nb_servo *servo) {
  double b, t;
  fputs("      gain: rate = off/(2 B T), and what has gathered of it over 16 T; ", out);
  if (nb_servo_scales(model, servo, &b, &t))
    fprintf(out, "now B is %g%s, from the contacts' stiffness, and T %g%s, a wave's time across\n", b,
            model->scene->unitless ? "" : " Pa", t, model->scene->unitless ? "" : " s");
  else
    fputs("B from the contacts' stiffness, T a wave's time across; nothing is pressed yet\n", out);
}

static void explain_servo(FILE *out, const struct nb_model *model, const struct nb_servo *servo) {
  static const char *const parts[] = {"xx", "yy", "xy"};
  const bool unitless = model->scene->unitless;
  fprintf(out, "    %sservo holds", servo->ramp ? "ramp " : "");
  if (servo->mean)
    fprintf(out, " (xx + yy)/2 at %g", servo->stress[0]);
  for (int k = 0; k < 3 && !servo->mean; k++)
    if (servo->held[k])
      fprintf(out, " %s at %g", parts[k], servo->stress[k]);
  fputs(unitless ? "" : " Pa", out);
  explain_place(out, model->scene, servo);
  fprintf(out, " by %s, looked at every %lu cycles, at most %g%s (line %d)\n",
          servo->cell        ? "the cell"
          : servo->box       ? "the walls of the box"
          : servo->continuum ? "boundary and continuum"
                             : "the boundary",
          servo->every, servo->most,
          servo->per_cycle ? " per cycle"
          : unitless       ? ""
                           : " 1/s",
          servo->line);
  explain_gain(out, model, servo);
}

void nb_explain_drive(FILE *out, const struct nb_model *model, const struct nb_stage *stage) {
  const bool unitless = model->scene->unitless;
  nb_explain_circle(out, &stage->circle, unitless);
  if (stage->boundary.line)
    explain_boundary(out, &stage->boundary, unitless);
  if (stage->continuum.line)
    rate(out, "continuum", &stage->continuum.strain, unitless, stage->continuum.literal ? ", literal" : "",
         stage->continuum.line);
  if (stage->cell_line)
    rate(out, "cell", &stage->cell, unitless, "", stage->cell_line);
  if (stage->box_line)
    rate(out, "walls of the box", &stage->box, unitless, "", stage->box_line);
  if (stage->rotation_line)
    fprintf(out, "    rotation %s (line %d)\n", stage->rotation == NB_ROTATION_ON ? "on" : "off", stage->rotation_line);
  if (stage->servo.line)
    explain_servo(out, model, &stage->servo);
}

void nb_explain_circle(FILE *out, const struct nb_circle *circle, bool unitless) {
  if (circle->line)
    fprintf(out, "    boundary begins: bodies %g%s from %g, %g or beyond, held (line %d)\n", circle->radius,
            unitless ? "" : " m", circle->x, circle->y, circle->line);
}
