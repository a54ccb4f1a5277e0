/* The periodic cell, how stages strain it, and waves in it: `periodic cell`, `perturb wave`, `cell strain`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "core/vec.h"
#include "statement.h"

enum { AT_X, AT_Y, AT_X1, AT_Y1 };
enum { AT_VX, AT_VY };

/* clang-format off */
static const struct nb_argument cell_fields[] = {CORNERS(AT_X, AT_X1), END};
static const struct nb_argument wave_fields[] = {
  VALUE("VX", NB_UNIT_VELOCITY, NB_ANY, AT_VX, "Amplitude in x."),
  VALUE("VY", NB_UNIT_VELOCITY, NB_ANY, AT_VY, "Amplitude in y."),
  END
};
static const struct nb_argument strain_fields[] = {STRAIN, END};
/* clang-format on */

NB_APPLY(apply_cell) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_value *value = record->value;
  const double x = value[AT_X].number, y = value[AT_Y].number, x1 = value[AT_X1].number, y1 = value[AT_Y1].number;
  if (!nb_set_twice(reader, "`periodic cell`", scene->cell.line) && !nb_corners_swapped(reader, x, y, x1, y1))
    scene->cell = (struct nb_scene_cell){
        .x = x + (x1 - x) / 2, .y = y + (y1 - y) / 2, .h = {x1 - x, 0, 0, y1 - y}, .line = (int)reader->line};
}

bool nb_lacks_cell(const struct nb_scene *scene, struct nb_reader *reader) {
  if (!scene->cell.line && nb_statement_suppressed(reader->mistakes, "periodic"))
    nb_fail_silently(reader);
  if (!scene->cell.line)
    nb_token_mistake(reader, &reader->tokens[0],
                     reader->starts
                         ? "the page from which this page starts has none"
                         : NB_DEFINE(reader, "define it above, before the stages, with `periodic cell X Y to X Y`"),
                     "expected a scene with a periodic cell, found none");
  return reader->bad;
}

NB_APPLY(apply_strain) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  struct nb_stage *stage = nb_current_stage(scene);
  if (nb_lacks_cell(scene, reader))
    return;
  stage->cell = nb_strain_rate_of(reader, record->value);
  stage->cell_line = (int)reader->line;
}

NB_APPLY(apply_wave) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_value *value = record->value;
  const double most = 1e6; /* the argument of the sine then has an error of about 1e-9 */
  double nx, ny;
  if (nb_lacks_cell(scene, reader) || !nb_take_word(reader, "periods") ||
      !nb_take_number(reader, NB_UNIT_NUMBER, NB_ANY, &nx) || !nb_take_number(reader, NB_UNIT_NUMBER, NB_ANY, &ny))
    return;
  const bool good_x = nx == round(nx) && fabs(nx) <= most, good_y = ny == round(ny) && fabs(ny) <= most;
  if (!good_x || !good_y)
    nb_token_mistake(reader, &reader->tokens[reader->next - (good_x ? 1 : 2)], NULL,
                     "expected whole numbers of periods, from -1e6 to 1e6, found %.15g and %.15g", nx, ny);
  for (size_t i = 0; i < scene->particle_count; i++) {
    struct nb_particle *particle = &scene->particles[i];
    const double sine = sin(2 * NB_PI *
                            (nx * (particle->x - scene->cell.x) / scene->cell.h[0] +
                             ny * (particle->y - scene->cell.y) / scene->cell.h[3]));
    if (particle->fixed)
      continue;
    particle->vx += sine * value[AT_VX].number;
    particle->vy += sine * value[AT_VY].number;
  }
}

/* Reports a mistake of the whole cell, at the line of the statement `periodic cell`. */
static void report(struct nb_scene_reading *reading, const char *hint, const char *what) {
  nb_line_mistake(&reading->reader, (size_t)reading->scene->cell.line, hint, "%s", what);
}

void nb_cell_check(struct nb_scene_reading *reading) {
  const struct nb_scene *scene = reading->scene;
  double largest = 0, sum = 0;
  char what[2 * NB_NAME_SIZE];
  if (!scene->cell.line)
    return;
  if (scene->wall_count > 0)
    report(reading, "a periodic cell has no walls: remove the walls, or the cell",
           "expected a cell or walls, found both");
  for (size_t i = 0; i < scene->particle_count; i++)
    largest = fmax(largest, scene->particles[i].radius), sum += scene->particles[i].radius;
  const double skin = scene->skin > 0 ? scene->skin : 0.1 * sum / (double)scene->particle_count;
  const double least = 2 * (2 * largest + skin), width = fmin(scene->cell.h[0], scene->cell.h[3]);
  const char *unit = reading->reader.unitless ? "" : " m";
  if (nb_particles_incomplete(reading) || scene->particle_count < 2 || width >= least)
    return;
  snprintf(what, sizeof what,
           "expected cell sides of at least %g%s, twice the sum of the largest diameter and the skin, found %g%s",
           least, unit, width, unit);
  report(reading,
         "make the cell larger: in a smaller one a particle could have two images of another particle as neighbours",
         what);
}

/* clang-format off */
NB_STATEMENTS(cell) = {
  {"periodic cell", NB_IN_SCENE | NB_IN_CELL, cell_fields, NULL, 0, false, apply_cell,
   "Makes the scene periodic. Images of the cell fill the plane, and particles touch the images of others across the sides of the cell. All particles belong to the cell, wherever they are. A scene with a cell has no walls. The quantities of the cell are called `cell.NAME`.",
   "periodic  cell 0 mm 0 mm to 80 mm 80 mm"},
  {"perturb wave", NB_IN_SCENE | NB_IN_CELL, wave_fields, "periods NX NY", 0, false, apply_wave,
   "Adds a plane wave to the velocities of the free particles that are defined above. The added velocity is the amplitude times sin(2 pi (NX x/LX + NY y/LY)). Here x and y are measured from the centre of the cell, and the cell is LX by LY.\n"
   "periods NX NY: whole numbers from -1000000 to 1000000. Numbers of waves in x and in y.",
   "perturb   wave 0 m/s 1 mm/s  periods 1 0"},
  {"cell strain", NB_IN_STAGE | NB_IN_CELL, strain_fields, NULL, 0, false, apply_strain,
   "Strains the periodic cell about its centre, from this stage on. The strain rate is imposed on all particles as an affine motion [R89 4.43, 4.44].",
   "  cell    strain -0.01 1/s -0.01 1/s"},
  {0},
};
/* clang-format on */
