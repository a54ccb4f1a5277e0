/* What there is, first half: materials and pairs of them, laws, walls.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "laws/law.h"
#include "scene.h"

static int find_material(const struct nb_scene *scene, const char *name) {
  for (size_t i = 0; i < scene->material_count; i++)
    if (strcmp(scene->materials[i].name, name) == 0)
      return (int)i;
  return -1;
}

static int find_wall(const struct nb_scene *scene, const char *name) {
  for (size_t i = 0; i < scene->wall_count; i++)
    if (strcmp(scene->walls[i].name, name) == 0)
      return (int)i;
  return -1;
}

void nb_not_known(struct nb_reader *reader, const struct nb_token *token, const char *hint, const char *what) {
  reader->next = (size_t)(token - reader->tokens);
  nb_expected(reader, hint, "%s", what);
}

int nb_material_of(const struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *token) {
  char hint[NB_HINT_SIZE];
  int index = find_material(scene, token->text);
  if (index >= 0)
    return index;
  struct nb_guess guess = nb_guess_begin(token->text);
  for (size_t i = 0; i < scene->material_count; i++)
    nb_guess_offer(&guess, scene->materials[i].name);
  const char *did_you_mean = nb_guess_hint(&guess, hint);
  nb_not_known(reader, token, did_you_mean ? did_you_mean : "define it above with `material NAME …`",
               "the name of a material");
  return -1;
}

int nb_wall_of(const struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *token) {
  char hint[NB_HINT_SIZE];
  int index = find_wall(scene, token->text);
  if (index >= 0)
    return index;
  struct nb_guess guess = nb_guess_begin(token->text);
  for (size_t i = 0; i < scene->wall_count; i++)
    nb_guess_offer(&guess, scene->walls[i].name);
  const char *did_you_mean = nb_guess_hint(&guess, hint);
  nb_not_known(reader, token, did_you_mean ? did_you_mean : "define it above with `wall NAME …` or `box …`",
               "the name of a wall");
  return -1;
}

NB_APPLY(nb_apply_material) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_value *value = record->value;
  const struct nb_token *name = value[AT_NAME].token;
  if (!name)
    return;
  int same = find_material(scene, name->text);
  if (same >= 0) {
    nb_token_mistake(reader, name, NULL, "there is a material `%s` already, on line %d", name->text,
                     scene->materials[same].line);
    return;
  }
  if (nb_too_many(reader, scene->material_count, NB_MATERIALS_MAX, "materials"))
    return;
  struct nb_material *materials = nb_room(scene->materials, scene->material_count, 1, sizeof *materials);
  if (!materials) {
    nb_no_memory(reader);
    return;
  }
  scene->materials = materials;
  struct nb_material *material = &materials[scene->material_count++];
  *material = (struct nb_material){
      .density = reader->bad ? NAN : value[AT_DENSITY].number, /* not a number: not known, which is not the same as 0 */
#define ROW(name, ...) .name = value[AT_##name].number,
      NB_PAIR_ROWS(ROW)
#undef ROW
          .young = value[AT_RIGID].token ? INFINITY : value[AT_YOUNG].number,
      .poisson = value[AT_POISSON].number,
      .line = (int)reader->line,
  };
  if (value[AT_RIGID].token && value[AT_YOUNG].token)
    nb_token_mistake(reader, value[AT_RIGID].token, NULL, "expected `rigid` or `young`, not both");
  snprintf(material->name, sizeof material->name, "%s", name->text);
}

NB_APPLY(nb_apply_pair) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_value *value = record->value;
  int a = nb_material_of(scene, reader, value[AT_NAME].token);
  int b = reader->bad ? -1 : nb_material_of(scene, reader, value[AT_NAME2].token);
  if (reader->bad)
    return;
  for (size_t i = 0; i < scene->pair_rule_count; i++) {
    const struct nb_pair_rule *rule = &scene->pair_rules[i];
    if ((rule->a == a && rule->b == b) || (rule->a == b && rule->b == a)) {
      nb_token_mistake(reader, &reader->tokens[0], NULL, "this pair is given already, on line %d", rule->line);
      return;
    }
  }
  struct nb_pair_rule *rules = nb_room(scene->pair_rules, scene->pair_rule_count, 1, sizeof *rules);
  if (!rules) {
    nb_no_memory(reader);
    return;
  }
  scene->pair_rules = rules;
  rules[scene->pair_rule_count++] = (struct nb_pair_rule){
      .a = a,
      .b = b,
#define ROW(name, ...) .name = value[AT_##name].token ? value[AT_##name].number : NAN,
      NB_PAIR_ROWS(ROW)
#undef ROW
          .line = (int)reader->line,
  };
}

NB_APPLY(nb_apply_law) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  const struct nb_token *token = record->value[AT_NAME].token;
  const char *kind = record->keyword->word;
  bool shear = record->keyword->variant, setting = reader == &reading->setting;
  struct nb_stage *stage = setting ? NULL : nb_stage_now(scene);
  int *line = stage   ? shear ? &stage->laws.shear_line : &stage->laws.normal_line
              : shear ? &scene->shear_line
                      : &scene->normal_line;
  bool *set = shear ? &reading->shear_set : &reading->normal_set;
  if (!nb_law_find(kind, token->text)) {
    char what[NB_NAME_SIZE], hint[NB_HINT_SIZE];
    struct nb_guess guess = nb_guess_begin(token->text);
    for (const struct nb_law *const *law = nb_laws(); *law; law++)
      if (strcmp((*law)->kind, kind) == 0)
        nb_guess_offer(&guess, (*law)->name);
    const char *did_you_mean = nb_guess_hint(&guess, hint);
    snprintf(what, sizeof what, "a law of kind `%s`", kind);
    nb_not_known(reader, token, did_you_mean ? did_you_mean : "`nineball laws` lists them", what);
    return;
  }
  const struct nb_value *pieces = &record->value[AT_PIECES];
  if (shear && pieces->token && nb_law_find(kind, token->text)->piece == 0)
    nb_token_mistake(reader, pieces->token, NULL, "`shear %s` keeps no pieces of history", token->text);
  else if (shear && pieces->token && (pieces->number < 2 || pieces->number > NB_PIECES_MAX))
    nb_token_mistake(reader, pieces->token, NULL, "expected 2 to %d pieces", NB_PIECES_MAX);
  if (*line && !setting) {
    nb_token_mistake(reader, &reader->tokens[0], NULL, "`%s` is said twice: first on line %d", kind, *line);
    return;
  }
  if (*set && !setting)
    return;
  *set = setting;
  if (shear)
    *(stage ? &stage->laws.pieces : &scene->pieces) = pieces->token ? (int)pieces->number : 0;
  *line = setting ? 0 : (int)reader->line;
  snprintf(stage   ? shear ? stage->laws.shear : stage->laws.normal
           : shear ? scene->shear
                   : scene->normal,
           NB_NAME_SIZE, "%s", token->text);
}

/* A wall from one end to the other. It is defined even when the statement is wrong, for those who name it. */
static void add_wall(struct nb_scene *scene, struct nb_reader *reader, const struct nb_token *place, const char *name,
                     struct nb_wall wall, double x1, double y1) {
  int same = find_wall(scene, name);
  if (same >= 0) {
    nb_token_mistake(reader, place, NULL, "there is a wall `%s` already, on line %d", name, scene->walls[same].line);
    return;
  }
  double length = hypot(x1 - wall.x, y1 - wall.y);
  if (!reader->bad && !isfinite(length))
    nb_token_mistake(reader, place, NULL, "expected a wall whose length a double can hold, this one is too long");
  else if (!reader->bad && !isnormal(length)) /* the direction of a shorter one would not have length 1 */
    nb_token_mistake(reader, place, NULL, "expected a wall with two ends, the ends of this one are the same point");
  if (nb_too_many(reader, scene->wall_count, NB_NAMED_MAX, "walls"))
    return;
  struct nb_wall *walls = nb_room(scene->walls, scene->wall_count, 1, sizeof *walls);
  if (!walls) {
    nb_no_memory(reader);
    return;
  }
  scene->walls = walls;
  wall.ex = (x1 - wall.x) / length;
  wall.ey = (y1 - wall.y) / length;
  wall.x = wall.x + (x1 - wall.x) / 2;
  wall.y = wall.y + (y1 - wall.y) / 2;
  wall.h1 = -length / 2;
  wall.h2 = length / 2;
  wall.line = (int)reader->line;
  snprintf(wall.name, sizeof wall.name, "%s", name);
  walls[scene->wall_count++] = wall;
}

/* Moves P from the middle of the wall to x, y; a point that is on the wall's line but for rounding counts as on it. */
static void turn_about(struct nb_wall *wall, double x, double y) {
  const double dx = wall->x - x, dy = wall->y - y, along = dx * wall->ex + dy * wall->ey;
  const double left = dy * wall->ex - dx * wall->ey;
  wall->h0 = fabs(left) > 1e-12 * (wall->h2 + hypot(dx, dy)) ? left : 0;
  wall->h1 += along;
  wall->h2 += along;
  wall->x = x;
  wall->y = y;
}

NB_APPLY(nb_apply_wall) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_value *value = record->value;
  const struct nb_token *name = value[AT_NAME].token;
  if (!name)
    return;
  struct nb_wall wall = {
      .x = value[AT_X].number, .y = value[AT_Y].number, .vx = value[AT_VX].number, .vy = value[AT_VY].number};
  wall.material = reader->bad ? -1 : nb_material_of(scene, reader, value[AT_MATERIAL].token);
  wall.spin = value[AT_SPIN].number;
  const size_t before = scene->wall_count;
  add_wall(scene, reader, name, name->text, wall, value[AT_X1].number, value[AT_Y1].number);
  if (value[AT_ABOUT_X].token && scene->wall_count > before)
    turn_about(&scene->walls[before], value[AT_ABOUT_X].number, value[AT_ABOUT_Y].number);
}

/* Counterclockwise from the south-west corner, so that the inside is to the left of e. */
NB_APPLY(nb_apply_box) {
  struct nb_scene *scene = ((struct nb_scene_reading *)subject)->scene;
  const struct nb_value *value = record->value;
  double x0 = value[AT_X].number, y0 = value[AT_Y].number, x1 = value[AT_X1].number, y1 = value[AT_Y1].number;
  const struct nb_token *verb = &reader->tokens[0];
  int m = reader->bad ? -1 : nb_material_of(scene, reader, value[AT_MATERIAL].token);
  if (!reader->bad && !(x1 > x0 && y1 > y0))
    nb_token_mistake(reader, verb, NULL,
                     "expected the south-west corner and then the north-east one, found them the other way");
  reader->muted = reader->bad;
  add_wall(scene, reader, verb, "south", (struct nb_wall){.x = x0, .y = y0, .iny = 1, .material = m}, x1, y0);
  reader->muted = reader->muted || reader->bad; /* a second box is one mistake, not four */
  add_wall(scene, reader, verb, "east", (struct nb_wall){.x = x1, .y = y0, .inx = -1, .material = m}, x1, y1);
  add_wall(scene, reader, verb, "north", (struct nb_wall){.x = x1, .y = y1, .iny = -1, .material = m}, x0, y1);
  add_wall(scene, reader, verb, "west", (struct nb_wall){.x = x0, .y = y1, .inx = 1, .material = m}, x0, y0);
}
