/* `servo`: stress control.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */

#include "statement.h"

enum { AT_ISOTROPIC, AT_MEAN, AT_XX, AT_YY, AT_XY, AT_ON, AT_THROUGH, AT_AFFINE, AT_MOST };
#define PLACE "a region, `boundary`, `cell`, `box` or `walls`"
#define TARGET(word, at, help) CLAUSE(word, "P", NB_UNIT_PRESSURE, NB_ANY, at, 1, "|not controlled", help)

/* clang-format off */
static const struct nb_argument servo_fields[] = {
  TARGET("isotropic", AT_ISOTROPIC, "Target of xx and yy; the target of xy is 0 [R89 sec. 4.1]. Through a box xy is not controlled, because its walls do not rotate. Compression is positive."),
  TARGET("mean", AT_MEAN, "Target of (xx + yy)/2. The servo changes the area only, so that the shape follows the stage's own strain rates."),
  TARGET("xx", AT_XX, "Target of this component. Give one or more of xx, yy and xy."),
  TARGET("yy", AT_YY, "Target of this component."),
  TARGET("xy", AT_XY, "Target of this component."),
  {"on", "REGION|boundary|cell|box|walls", NB_ARGUMENT_WORD, NB_UNIT_NUMBER, NB_ANY, AT_ON, 1, NULL, PLACE},
  CHOICE("through", "boundary|cell|box", AT_THROUGH, NULL, "what the added strain rate moves: the boundary, the cell or the walls of the box"),
  FLAG("affine", AT_AFFINE, "the boundary alone", "With `through boundary`: the added strain rate is also imposed as an affine motion on the particles inside."),
  CLAUSE("at most", "RATE", NB_UNIT_STRAIN_RATE, NB_POSITIVE, AT_MOST, 1, NULL, "Largest magnitude of the added strain rate."),
  END
};
/* clang-format on */

/* Finds the quantities of the measured stress components. */
static void find_stress(struct nb_scene_reading *reading, struct nb_reader *reader, const struct nb_token *place,
                        struct nb_servo *servo) {
  static const char *const parts[] = {"xx", "xy", "yx", "yy"};
  for (int k = 0; k < 4; k++) {
    char name[3 * NB_NAME_SIZE];
    snprintf(name, sizeof name, "%.63s.stress.%s", place->text, parts[k]);
    if (!nb_quantity_find(&servo->quantity[k], reading->scene, name))
      nb_unknown_name(reader, place, NULL, PLACE);
  }
}

/* Takes the target: `isotropic`, `mean`, or components of the stress. */
static void take_target(struct nb_reader *reader, const struct nb_value *value, struct nb_servo *servo) {
  const bool isotropic = value[AT_ISOTROPIC].token,
             components = value[AT_XX].token || value[AT_YY].token || value[AT_XY].token;
  servo->mean = value[AT_MEAN].token;
  if (isotropic + servo->mean + components != 1)
    nb_token_mistake(reader, &reader->tokens[0], NULL,
                     "expected one target: `isotropic P`, `mean P`, or components `xx P`, `yy P`, `xy P`");
  for (int k = 0; k < 3; k++) {
    const int at = components ? AT_XX + k : isotropic ? AT_ISOTROPIC : AT_MEAN;
    servo->controlled[k] = !components || value[at].token;
    servo->stress[k] = components || k < 2 ? value[at].number : 0;
  }
}

NB_APPLY(apply_servo) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  struct nb_stage *stage = nb_current_stage(scene);
  const struct nb_value *value = record->value;
  const int through = (int)value[AT_THROUGH].number;
  struct nb_servo servo = {.axis_x = {1, 0},
                           .axis_y = {0, 1},
                           .every = 10,
                           .max_rate = value[AT_MOST].number,
                           .per_cycle = nb_value_per_cycle(reader, &value[AT_MOST]),
                           .cell = through == 1,
                           .box = through == 2,
                           .affine = value[AT_AFFINE].token,
                           .line = (int)reader->line};
  take_target(reader, value, &servo);
  find_stress(reading, reader, value[AT_ON].token, &servo);
  if (servo.affine && through != 0)
    nb_token_mistake(reader, value[AT_AFFINE].token, NULL, "expected `affine` only with `through boundary`");
  if (nb_token_skip(reader, "every"))
    nb_take_count_of(reader, "cycle", &servo.every);
  nb_given_twice(reader, stage->servo.line);
  if (servo.box && value[AT_XY].token)
    nb_token_mistake(reader, value[AT_XY].token, NULL,
                     "expected `xx` or `yy` for a box, whose walls do not rotate, found `xy`");
  servo.controlled[2] = servo.controlled[2] && !servo.box;
  (servo.cell ? nb_lacks_cell : servo.box ? nb_lacks_box : nb_lacks_boundary)(scene, reader);
  if (!reader->bad)
    stage->servo = servo;
}

/* clang-format off */
NB_STATEMENTS(servo) = {
  {"servo", NB_IN_STAGE | NB_IN_RAMP, servo_fields, "{every N cycles}", 0, false, apply_servo,
   "Controls a stress in this stage: the stress of a region, on the boundary, in the cell or on the box, or the mean traction of the box's walls. The servo adds a strain rate to that of the boundary, the cell or the box. Components that are not named are not controlled. The program computes the gain from the stiffness of the contacts.\n"
   "every N cycles: a whole number, 1 or more; without it: 10. How often the added strain rate is updated.",
   "stage     walled\n  servo   isotropic 1 kPa  on box  through box  at most 1e-6 per cycle\n  cycles  10\n"
   "stage     even\n  servo   isotropic 1 kPa  on boundary  through boundary affine  at most 1e-6 per cycle\n  cycles  10\n"
   "stage     shear\n  servo   mean 1 kPa  on boundary  through boundary  at most 1e-6 per cycle  every 5 cycles\n  cycles  10\n"
   "stage     biaxial\n  servo   yy 2 kPa  on boundary  through boundary  at most 1e-6 per cycle\n  cycles  10"},
  {0},
};
/* clang-format on */
