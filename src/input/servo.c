/* What makes an assembly follow a stress: `servo`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "statement.h"

enum { AT_P };
enum { AT_XX, AT_YY, AT_XY };
#define PLACE_AND_MEANS "on REGION|boundary|cell|box through boundary {affine}|cell|box at most RATE {every N cycles}"

/* clang-format off */
static const struct nb_argument pressure_fields[] = {
  VALUE("P", NB_UNIT_PRESSURE, NB_ANY, AT_P, "What it should be; compression is positive."),
  END
};
static const struct nb_argument stress_fields[] = {
  CLAUSE("xx", "S", NB_UNIT_PRESSURE, NB_ANY, AT_XX, 1, "left alone", "What it should be; compression is positive."),
  CLAUSE("yy", "S", NB_UNIT_PRESSURE, NB_ANY, AT_YY, 1, "left alone", "Likewise."),
  CLAUSE("xy", "S", NB_UNIT_PRESSURE, NB_ANY, AT_XY, 1, "left alone", "Likewise."),
  END
};
/* clang-format on */

/* `on REGION|boundary|cell|box`: the components of the stress that is looked at. */
static void take_place(struct nb_scene_reading *reading, struct nb_reader *reader, struct nb_servo *servo) {
  static const char *const parts[] = {"xx", "xy", "yx", "yy"};
  const char *what = "a region, `boundary`, `cell` or `box`";
  const struct nb_token *place = nb_take_word(reader, "on") ? nb_take(reader, what) : NULL;
  for (int k = 0; k < 4 && place; k++) {
    char name[3 * NB_NAME_SIZE];
    snprintf(name, sizeof name, "%.63s.stress.%s", place->text, parts[k]);
    if (!nb_quantity_find(&servo->quantity[k], reading->scene, name, NULL))
      nb_not_known(reader, place, NULL, what);
  }
}

/* `through boundary {affine}|cell|box at most RATE {every N cycles}` */
static void take_means(struct nb_reader *reader, struct nb_servo *servo) {
  const int by = nb_take_word(reader, "through") ? nb_take_choice(reader, "boundary|cell|box") : 0;
  servo->cell = by == 1, servo->box = by == 2;
  servo->continuum = by == 0 && nb_token_skip(reader, "affine");
  if (!nb_take_word(reader, "at") || !nb_take_word(reader, "most") ||
      !nb_take_number(reader, NB_UNIT_STRAIN_RATE, NB_POSITIVE, &servo->most))
    return;
  servo->per_cycle = strcmp(reader->tokens[reader->next - 1].text, NB_PER_CYCLE) == 0;
  if (nb_token_skip(reader, "every"))
    nb_take_counted(reader, "cycle", &servo->every);
}

/* variant 0: isotropic, 1: mean, 2: stress */
NB_APPLY(apply_servo) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  struct nb_stage *stage = nb_stage_now(scene);
  const struct nb_value *value = record->value;
  const int variant = record->keyword->variant;
  struct nb_servo servo = {
      .east = {1, 0}, .north = {0, 1}, .every = 10, .mean = variant == 1, .line = (int)reader->line};
  for (int k = 0; k < 3; k++) {
    servo.held[k] = variant < 2 || value[AT_XX + k].token;
    servo.stress[k] = variant == 2 ? value[AT_XX + k].number : k < 2 ? value[AT_P].number : 0;
  }
  take_place(reading, reader, &servo);
  take_means(reader, &servo);
  servo.held[2] = servo.held[2] && !(servo.box && variant == 0); /* walls do not turn */
  if (!servo.held[0] && !servo.held[1] && !servo.held[2])
    nb_token_mistake(reader, &reader->tokens[1], NULL, "expected `xx`, `yy` or `xy`, or several of them, found none");
  nb_said_twice(reader, stage->servo.line);
  if (servo.box && variant == 2 && servo.held[2])
    nb_token_mistake(reader, value[AT_XY].token, NULL, "expected `xx` or `yy` of a box: its walls do not turn");
  (servo.cell ? nb_lacks_cell : servo.box ? nb_lacks_box : nb_lacks_boundary)(scene, reader);
  if (!reader->bad)
    stage->servo = servo;
}

/* clang-format off */
NB_STATEMENTS(servo) = {
  {"servo isotropic", NB_IN_STAGE | NB_IN_RAMP, pressure_fields, PLACE_AND_MEANS, 0, false, apply_servo,
   "Adds to the boundary's strain rate, and to the affine motion's if it says so, or to the cell's or the box's, what brings the stress of a region, or that on the boundary, in the cell or on the box, to P in all directions: "
   "xx and yy to P, xy to 0 [R89 4.1], which the walls of a box leave alone: they follow its strain rate as with `box strain`, of xx and yy. The gain follows from the contacts' stiffness; `at most` bounds the rates that are added. For this stage.",
   "stage     even\n  servo   isotropic 1 kPa  on boundary  through boundary affine  at most 1e-6 per cycle\n  cycles  10"},
  {"servo mean", NB_IN_STAGE | NB_IN_RAMP, pressure_fields, PLACE_AND_MEANS, 1, false, apply_servo,
   "Holds (xx + yy)/2 alone, by a change of area: what the stage's own strain rates do to the shape goes on.",
   "stage     shear\n  servo   mean 1 kPa  on boundary  through boundary  at most 1e-6 per cycle  every 5 cycles\n  cycles  10"},
  {"servo stress", NB_IN_STAGE | NB_IN_RAMP, stress_fields, PLACE_AND_MEANS, 2, false, apply_servo,
   "Holds single components.",
   "stage     biaxial\n  servo   stress yy 2 kPa  on boundary  through boundary  at most 1e-6 per cycle\n  cycles  10\nstage     walled\n  servo   stress xx 2 kPa yy 1 kPa  on box  through box  at most 1e-6 per cycle\n  cycles  10"},
  {0},
};
/* clang-format on */
