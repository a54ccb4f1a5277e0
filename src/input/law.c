/* Contact laws: `normal`, `shear`; and checks that the whole scene meets the requirements of its laws.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <string.h>

#include "core/model.h"
#include "laws/laws_now.h"
#include "statement.h"

enum { AT_NAME };
static const struct nb_argument law_fields[] = {WORD("LAW", AT_NAME, "the name of a law"), END};

static void report_unknown(struct nb_reader *reader, const char *kind, const struct nb_token *token) {
  char what[NB_NAME_SIZE], hint[NB_HINT_SIZE];
  struct nb_guess guess = nb_guess_begin(token->text);
  for (const struct nb_law *const *law = nb_laws(); *law; law++)
    if (strcmp((*law)->kind, kind) == 0)
      snprintf(what, sizeof what, "%s %s", kind, (*law)->name), nb_guess_offer(&guess, (*law)->name),
          nb_guess_offer(&guess, what);
  const char *near = nb_guess_hint(&guess, hint);
  snprintf(what, sizeof what, "the name of a `%s` law", kind);
  const bool rate = strcmp(kind, "shear") == 0 && (nb_number_length(token->text) || strcmp(token->text, "strain") == 0);
  if (!near && nb_pair_hint(hint, kind, token->text))
    near = hint;
  if (rate && nb_pair_hint(hint, kind, "rate"))
    nb_token_mistake(reader, token, hint, "expected %s, found `%s`", what, token->text);
  else
    nb_expected_at(reader, token, near ? near : "`nineball laws` lists the laws", what);
}

/* Words that users may write after the name of a law, because other programs expect parameters there. */
static const struct {
  char name[NB_NAME_SIZE];
} properties[] = {
#define ROW(name, ...) {#name},
    NB_PAIR_ROWS(ROW)
#undef ROW
        {"young"},
    {"poisson"},
    {"stiffness"},
    {"mu"},
    {"k"}};

/* Takes `memory K` after the name of a law, if the line has it. */
static void take_options(struct nb_reader *reader, const struct nb_law *law, bool shear, unsigned long *pieces) {
  const struct nb_token *next = nb_token_peek(reader);
  if (next && NB_FIND(properties, sizeof properties / sizeof *properties, next->text) >= 0)
    nb_token_mistake(reader, next,
                     "this property belongs to the material: `material rock  density 2000 kg/m3  kn 1 MN/m  ks 1 MN/m`",
                     "expected the end of the line, found `%s`", next->text);
  else if (shear && nb_token_is(reader, "memory") && law->piece == 0)
    nb_token_mistake(reader, next, NULL, "`shear %s` stores no history in pieces, so it takes no `memory`", law->name);
  else if (shear && next && nb_take_word(reader, "memory"))
    nb_take_count(reader, 2, NB_PIECES_MAX, pieces);
}

/* variant 0: normal, 1: shear */
NB_APPLY(apply_law) {
  struct nb_scene_reading *reading = subject;
  struct nb_scene *scene = reading->scene;
  const struct nb_token *token = record->value[AT_NAME].token;
  unsigned long pieces = 0;
  const char *kind = record->keyword->word;
  const bool shear = record->keyword->variant, setting = reader == &reading->setting;
  struct nb_stage *stage = setting ? NULL : nb_current_stage(scene);
  int *line = stage   ? shear ? &stage->laws.shear_line : &stage->laws.normal_line
              : shear ? &scene->shear_line
                      : &scene->normal_line;
  char *name = stage ? shear ? stage->laws.shear : stage->laws.normal : shear ? scene->shear : scene->normal;
  const struct nb_law *law = nb_law_find(kind, token->text);
  bool *set = &reading->law_set[shear];
  if (law)
    take_options(reader, law, shear, &pieces);
  else
    report_unknown(reader, kind, token);
  if (reader->bad || (!setting && (nb_given_twice(reader, *line) || *set)))
    return;
  *set = setting;
  if (shear)
    *(stage ? &stage->laws.pieces : &scene->pieces) = (int)pieces;
  *line = setting ? 0 : (int)reader->line;
  if (shear && !stage)
    reading->shear_written = !setting && !token->name;
  snprintf(name, NB_NAME_SIZE, "%s", token->text);
}

/* ---- requirements of laws ---- */

/* Reports a mistake at the first word of a line. `what`: the format of the message, which contains `name`. */
static void report(struct nb_scene_reading *reading, int line, const char *hint, const char *what, const char *name) {
  nb_line_mistake(&reading->reader, (size_t)line, hint, what, name);
}

/* Writes a law and the stage in which it is active, for messages: "`normal hertz`", "`normal hertz` in stage
 * `more`". */
static const char *law_text(char text[NB_HINT_SIZE], const struct nb_law *law, const struct nb_stage *stage) {
  snprintf(text, NB_HINT_SIZE, "`%s %s`%s%s%s", law->kind, law->name, stage ? " in stage `" : "",
           stage ? stage->name : "", stage ? "`" : "");
  return text;
}

/* Reports the first contact that may have two rigid sides, of two materials or of one. The arrays have the numbers of
 * particles and of walls of each material. */
static void check_rigid(struct nb_scene_reading *reading, const int *on_particle, const int *on_wall) {
  const struct nb_scene *scene = reading->scene;
  for (size_t i = 0; i < scene->material_count; i++) {
    if (!isinf(scene->materials[i].young) || !on_particle[i])
      continue;
    for (size_t k = 0; k < scene->material_count; k++)
      if (isinf(scene->materials[k].young) &&
          (k == i ? on_particle[i] > 1 || on_wall[i] : on_particle[k] || on_wall[k])) {
        report(reading, scene->materials[i].line,
               k == i ? "write `young E  poisson NU` in place of `rigid`"
                      : "give one of the two materials `young E  poisson NU` in place of `rigid`",
               k == i
                   ? "expected at most one `rigid` side of a contact, found that both sides can be of `%s`"
                   : "expected at most one `rigid` side of a contact, found that this material can touch `%s`, which "
                     "is rigid too",
               scene->materials[k].name);
        return;
      }
  }
}

static void check_shapes(struct nb_scene_reading *reading, const char *law) {
  const struct nb_particle *const particles = reading->scene->particles;
  size_t k = 0;
  while (k < reading->scene->particle_count && particles[k].shape != NB_DISC)
    k++;
  if (k < reading->scene->particle_count)
    report(reading, particles[k].line, "use spheres, or `normal linear`", "expected spheres for %s, found a disc", law);
}

static void check_elastic(struct nb_scene_reading *reading, const char *law) {
  const struct nb_scene *scene = reading->scene;
  int on_particle[NB_MATERIALS_MAX] = {0}, on_wall[NB_MATERIALS_MAX] = {0};
  for (size_t k = 0; k < scene->particle_count; k++)
    on_particle[scene->particles[k].material]++;
  for (size_t w = 0; w < scene->wall_count; w++)
    on_wall[scene->walls[w].material]++;
  for (size_t m = 0; m < scene->material_count; m++)
    if (scene->materials[m].young == 0 && (on_particle[m] || on_wall[m]))
      report(reading, scene->materials[m].line, "add `young E  poisson NU`, or `rigid`",
             "expected a material with `young` for %s", law);
  check_shapes(reading, law);
  check_rigid(reading, on_particle, on_wall);
}

/* A line that gives a material or a pair cohesion; 0: none. */
static int cohesive_line(const struct nb_scene *scene) {
  for (size_t m = 0; m < scene->material_count; m++)
    if (scene->materials[m].cohesion > 0)
      return scene->materials[m].line;
  for (size_t r = 0; r < scene->pair_rule_count; r++)
    if (scene->pair_rules[r].cohesion > 0)
      return scene->pair_rules[r].line;
  for (size_t s = 0; s < scene->stage_count; s++)
    for (size_t c = 0; c < scene->stages[s].change_count; c++)
      if (scene->stages[s].changes[c].cohesion > 0)
        return scene->stages[s].changes[c].line;
  return 0;
}

static void refuse_fraction(struct nb_scene_reading *reading, int line, bool walls, const char *normal) {
  char hint[NB_HINT_SIZE];
  snprintf(hint, sizeof hint,
           "`r89-fraction` is relative to the single-contact step of linear springs; use `damping %sratio X`",
           walls ? "walls " : "");
  report(reading, line, hint, "expected no `damping r89-fraction` for %s", normal);
}

/* Reports damping that the normal law does not allow. stage NULL: the damping before the first stage. */
static void check_damping(struct nb_scene_reading *reading, const struct nb_damping *damping,
                          const struct nb_law *normal, const struct nb_stage *stage) {
  char text[NB_HINT_SIZE];
  if (!normal->elastic && damping->deep > 0)
    report(reading, damping->deep_line, "use `normal hertz`", "expected a normal law of elastic spheres for `%s`",
           "damping critical");
  if (normal->elastic && damping->contact_kind == NB_CONTACT_R89_FRACTION)
    refuse_fraction(reading, damping->contact_line, false, law_text(text, normal, stage));
  if (normal->elastic && damping->walls_separate && damping->walls_kind == NB_CONTACT_R89_FRACTION)
    refuse_fraction(reading, damping->walls_line, true, law_text(text, normal, stage));
}

/* Checks the laws that are active from `line` on. `other_normal`: the normal law is not the one that was checked
 * before. line 0: the laws are set by --set. stage NULL: the laws before the first stage. */
static void check_laws(struct nb_scene_reading *reading, const struct nb_active_laws *laws, bool other_normal, int line,
                       const struct nb_stage *stage) {
  char text[NB_HINT_SIZE];
  const struct nb_scene *scene = reading->scene;
  const int cohesive = cohesive_line(scene);
  if (laws->normal->elastic && other_normal)
    check_elastic(reading, law_text(text, laws->normal, stage));
  else if (!laws->normal->elastic && laws->shear->elastic)
    nb_line_mistake(line ? &reading->reader : &reading->setting,
                    line ? (size_t)line : nb_setting_find(reading, "shear"), "use `normal hertz`",
                    "expected a normal law of elastic spheres for `shear %s`", laws->shear->name);
  if (laws->shear->cohesionless && cohesive > 0)
    report(reading, cohesive,
           "remove `cohesion`, or use a law whose friction limit includes it, such as `shear mindlin`",
           "expected no cohesion for %s", law_text(text, laws->shear, stage));
}

/* ---- stiffnesses that are 0 ---- */

/* Bits of a pair of materials. FRICTION: it has friction in some stage. LAW: in such a stage it also has a shear law.
 * TRANSMITTED: in such a stage it has a shear law and a shear stiffness. REPELLED: in some stage it has a normal
 * stiffness. */
enum { FRICTION = 1, TRANSMITTED = 2, LAW = 4, REPELLED = 8 };

static void find_stiffnesses(unsigned char pairs[NB_MATERIALS_MAX][NB_MATERIALS_MAX], const struct nb_scene *scene,
                             const struct nb_properties *now, const struct nb_active_laws *laws) {
  const struct nb_law *const shear = laws->shear;
  for (int a = 0; a < (int)scene->material_count; a++)
    for (int b = 0; b < (int)scene->material_count; b++) {
      const struct nb_pair pair = nb_properties_pair(now, a, b);
      const bool law = strcmp(shear->name, "none") != 0, transmitted = law && (shear->elastic || pair.ks > 0);
      if (laws->normal->elastic || pair.kn > 0)
        pairs[a][b] |= REPELLED;
      if (pair.friction > 0)
        pairs[a][b] |= (unsigned char)(FRICTION | (law ? LAW : 0) | (transmitted ? TRANSMITTED : 0));
    }
}

/* True if a free particle of material a may touch a particle or a wall of material b. */
static bool may_touch(const struct nb_scene *scene, int a, int b) {
  size_t of_a = 0, of_b = 0;
  for (size_t k = 0; k < scene->particle_count; k++)
    of_a += scene->particles[k].material == a && !scene->particles[k].fixed, of_b += scene->particles[k].material == b;
  for (size_t w = 0; w < scene->wall_count; w++)
    of_b += scene->walls[w].material == b;
  return of_a > 0 && of_b > (a == b ? 1 : 0);
}

static int line_of_pair(const struct nb_scene *scene, int a, int b) {
  for (size_t r = 0; r < scene->pair_rule_count; r++) {
    const struct nb_pair_rule *rule = &scene->pair_rules[r];
    if ((rule->a == a && rule->b == b) || (rule->a == b && rule->b == a))
      return rule->line;
  }
  return scene->materials[a].line;
}

/* Warns of a pair that never has a normal stiffness. This is not an error, because particles may be meant to move
 * without contact forces. */
static void warn_not_repelled(struct nb_scene *scene, unsigned char bits, int a, int b) {
  if (!(bits & REPELLED))
    nb_warn(&scene->warnings, line_of_pair(scene, a, b),
            "contacts between `%s` and `%s` have no force, because their normal stiffness `kn` is 0%s",
            scene->materials[a].name, scene->materials[b].name,
            scene->materials[a].young > 0 || scene->materials[b].young > 0 ? "; `young` is for `normal hertz`" : "");
}

/* Warns of friction that causes no shear force, because there is no shear law or the shear stiffness is 0. This is not
 * an error, because a page may leave out the shear law on purpose. */
static void warn_unused_friction(struct nb_scene *scene, unsigned char bits, int a, int b) {
  if (bits & FRICTION && !(bits & TRANSMITTED))
    nb_warn(&scene->warnings, line_of_pair(scene, a, b), "friction between `%s` and `%s` has no effect: %s",
            scene->materials[a].name, scene->materials[b].name,
            bits & LAW             ? "their shear stiffness `ks` is 0"
            : nb_laws_shear(scene) ? "there is no `shear` law in the stages with this friction"
                                   : "there is no `shear` law, such as `shear linear`");
}

/* Warns of stiffnesses that are 0. */
static void warn_of_stiffnesses(struct nb_scene_reading *reading) {
  struct nb_scene *scene = reading->scene;
  unsigned char pairs[NB_MATERIALS_MAX][NB_MATERIALS_MAX] = {{0}};
  struct nb_properties now = {0};
  struct nb_active_laws laws = nb_laws_initial(scene);
  if (!nb_properties_create(&now, scene)) {
    nb_no_memory(&reading->reader);
    return;
  }
  find_stiffnesses(pairs, scene, &now, &laws);
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    laws = nb_laws_of(stage, laws);
    nb_properties_end_stage(&now, stage);
    find_stiffnesses(pairs, scene, &now, &laws);
  }
  nb_properties_free(&now);
  for (int a = 0; a < (int)scene->material_count; a++)
    for (int b = 0; b < (int)scene->material_count; b++) {
      if (!may_touch(scene, a, b) || (b < a && may_touch(scene, b, a)))
        continue;
      warn_not_repelled(scene, pairs[a][b], a, b);
      warn_unused_friction(scene, pairs[a][b], a, b);
    }
}

/* ---- an elastic contact without micro-slip ---- */

/* True if a segment of a contact test moves or loads the contact tangentially. */
static bool has_tangential_segment(const struct nb_scene *scene) {
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_segment *segment = &scene->stages[s].segment;
    if (segment->points || !segment->shear.relative || segment->shear.value != 0)
      return true;
  }
  return false;
}

/* True if the page gives particles a velocity or a spin, and no stage has damping or gravity. `impact` has set the
 * velocity of its particle. */
static bool is_free_collision(const struct nb_scene *scene) {
  bool moving = false, undisturbed = !scene->gravity.line;
  for (size_t k = 0; k < scene->particle_count && !moving; k++)
    moving = scene->particles[k].vx != 0 || scene->particles[k].vy != 0 || scene->particles[k].spin != 0;
  for (size_t s = 0; s < scene->stage_count; s++)
    undisturbed = undisturbed && nb_damping_none(&scene->stages[s].damping) && !scene->stages[s].gravity.line;
  return moving && undisturbed;
}

/* Warns of `shear mindlin`, whose name suggests the exact law, where micro-slip decides: in a contact test with
 * tangential segments, and in a collision without damping. There is no warning if the law is the value of a name or of
 * --set, because such a page compares laws. */
static void warn_no_micro_slip(struct nb_scene_reading *reading) {
  struct nb_scene *scene = reading->scene;
  bool friction = false;
  for (size_t m = 0; m < scene->material_count; m++)
    friction = friction || scene->materials[m].friction > 0;
  for (size_t r = 0; r < scene->pair_rule_count; r++)
    friction = friction || scene->pair_rules[r].friction > 0;
  if (reading->shear_written && strcmp(scene->shear, "mindlin") == 0 && friction &&
      (scene->contact_test ? has_tangential_segment(scene) : is_free_collision(scene)))
    nb_warn(&scene->warnings, scene->shear_line,
            "`shear mindlin` has no micro-slip at the edge of the contact, on which %s depends: the exact law is "
            "`shear mindlin_deresiewicz`",
            scene->contact_test ? "the result of this contact test" : "a collision without damping");
}

void nb_laws_check(struct nb_scene_reading *reading, bool complete) {
  char text[NB_HINT_SIZE];
  struct nb_scene *scene = reading->scene;
  struct nb_active_laws now = nb_laws_initial(scene);
  if (!complete && now.normal->elastic && !nb_name_suppressed(reading->reader.mistakes, "normal"))
    check_shapes(reading, law_text(text, now.normal, NULL));
  if (!complete)
    return;
  check_laws(reading, &now, true, now.shear_line, NULL);
  check_damping(reading, &scene->damping, now.normal, NULL);
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    const struct nb_damping *before = s ? &scene->stages[s - 1].damping : &scene->damping;
    const struct nb_active_laws old = now;
    now = nb_laws_of(stage, now);
    if (old.normal != now.normal || old.shear != now.shear)
      check_laws(reading, &now, old.normal != now.normal,
                 stage->laws.shear_line ? stage->laws.shear_line : stage->laws.normal_line, stage);
    if (old.normal != now.normal || !nb_damping_equal(before, &stage->damping)) /* each mistake is reported once */
      check_damping(reading, &stage->damping, now.normal, stage);
  }
  warn_of_stiffnesses(reading);
  warn_no_micro_slip(reading);
}

/* clang-format off */
NB_STATEMENTS(law) = {
  {"normal", NB_IN_SCENE | NB_IN_CONTACT_TEST | NB_IN_STAGE | NB_IN_START, law_fields, "", 0, false, apply_law,
   "Selects the contact law of the normal force; default `linear`. --set normal=LAW overrides the law everywhere. `nineball laws` lists the laws with their equations. In a stage the law changes from this stage on, and another law begins with empty histories of the normal force.",
   "normal    linear"},
  {"shear", NB_IN_SCENE | NB_IN_CONTACT_TEST | NB_IN_STAGE | NB_IN_START, law_fields, "{memory K}", 1, false, apply_law,
   "Selects the contact law of the shear force; default `none`. --set shear=LAW overrides the law everywhere. `nineball laws` lists the laws with their equations. Of the laws of elastic spheres `mindlin` has no micro-slip, so at constant normal force it dissipates energy only while the contact slides; `mindlin_deresiewicz` is the exact law with micro-slip. In a stage the law changes from this stage on, and another law begins with empty histories of the shear force.\n"
   "memory K: a whole number from 2 to 256, for a law that stores its history in pieces; without it: the default of the law. Largest number of pieces of a contact's history.",
   "shear     linear"},
  {0},
};
/* clang-format on */
