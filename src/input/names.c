/* Quantities by their names, for `record`, `until` and expectations. A row is one quantity or a family of quantities.
 *
 * `MONITOR.PART` is a quantity of a monitored object; a name without a monitor is a quantity of the whole scene.
 * Velocities are those at the time of positions and forces, the mean of two half steps [CS79 31]. Names of velocities
 * at the last half step end in `.half`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/clean.h"
#include "core/names.h"
#include "laws/law.h"
#include "loading/loading.h"
#include "measure/energy.h"
#include "reader.h"

/* ---- rows in other files ---- */

/* The last row of each array has no name. */
extern const struct nb_quantity_kind nb_step_kinds[];    /* step.c */
extern const struct nb_quantity_kind nb_loading_kinds[]; /* loading_quantities.c */
extern const struct nb_quantity_kind nb_impact_kinds[];  /* impact.c */
extern const struct nb_quantity_kind nb_fill_kinds[];    /* fill_quantities.c */
extern const struct nb_quantity_kind nb_wall_kinds[];    /* wall_quantities.c */
extern const struct nb_quantity_kind nb_region_kinds[];  /* region_quantities.c */

/* ---- the whole scene ---- */

NB_QUANTITY(cycle, (double)model->cycle)
NB_QUANTITY(time_, model->time)
NB_QUANTITY(stage_time, (double)model->stage_cycle * model->step)

static double touching_count(const struct nb_model *model, const struct nb_monitor *monitor) {
  (void)monitor;
  double count = 0;
  for (size_t c = 0; c < model->contacts.count; c++)
    count += model->contacts.kept[NB_OVERLAP][c] > 0;
  return count;
}
NB_QUANTITY(unbalanced_max, nb_unbalanced_max(model))
NB_QUANTITY(deep_count, (double)nb_deep_count(model))
NB_QUANTITY(kinetic_energy, nb_energy_kinetic(model))
NB_QUANTITY(stored_energy, nb_energy_stored(model))
NB_QUANTITY(frictional_dissipation, nb_balance_term(model, NB_TERM_FRICTIONAL))
NB_QUANTITY(sliding_dissipation, nb_balance_term(model, NB_TERM_SLIDING))
NB_QUANTITY(shear_work, nb_balance_term(model, NB_TERM_SHEAR))
NB_QUANTITY(damping_dissipation, nb_balance_term(model, NB_TERM_DAMPED))
NB_QUANTITY(wall_work, nb_balance_term(model, NB_TERM_WALLS))
NB_QUANTITY(gravity_work, nb_balance_term(model, NB_TERM_GRAVITY))
NB_QUANTITY(stage_work, nb_balance_term(model, NB_TERM_CHANGED))
NB_QUANTITY(imposed_work, nb_balance_term(model, NB_TERM_IMPOSED))
NB_QUANTITY(removed_energy, nb_balance_term(model, NB_TERM_REMOVED))
NB_QUANTITY(energy_residual, nb_balance_energy_residual(model))
NB_QUANTITY(work_residual, nb_balance_work_residual(model))
NB_QUANTITY(momentum_x, nb_momentum(model).x)
NB_QUANTITY(momentum_y, nb_momentum(model).y)
NB_QUANTITY(momentum_angular, nb_momentum_angular(model))

/* ---- a particle ---- */

static size_t slot(const struct nb_model *model, const struct nb_monitor *monitor) {
  return (size_t)model->particles.slot[monitor->a];
}
#define OF_PARTICLE(function, expression)                                                                              \
  static double function(const struct nb_model *model, const struct nb_monitor *monitor) {                             \
    const struct nb_particles *particles = &model->particles;                                                          \
    const size_t i = slot(model, monitor);                                                                             \
    (void)particles;                                                                                                   \
    return expression;                                                                                                 \
  }
OF_PARTICLE(particle_x, particles->position[i].x)
OF_PARTICLE(particle_y, particles->position[i].y)
OF_PARTICLE(particle_angle, particles->angle ? particles->angle[i] : 0)
OF_PARTICLE(particle_vx, nb_velocity_total(model, i).x)
OF_PARTICLE(particle_vy, nb_velocity_total(model, i).y)
OF_PARTICLE(particle_spin, nb_velocity_now(model, i).spin)
OF_PARTICLE(particle_vx_half, particles->velocity[i].x)
OF_PARTICLE(particle_vy_half, particles->velocity[i].y)
OF_PARTICLE(particle_spin_half, particles->spin ? particles->spin[i] : 0)
OF_PARTICLE(particle_fx, nb_force_on(model, i).force.x)
OF_PARTICLE(particle_fy, nb_force_on(model, i).force.y)
OF_PARTICLE(particle_moment, nb_force_on(model, i).moment)

/* ---- a contact: 0 while it is not in the neighbour list ---- */

static long contact_of(const struct nb_model *model, const struct nb_monitor *monitor) {
  const bool wall = monitor->kind == NB_MONITOR_PARTICLE_WALL;
  const int a = model->particles.slot[monitor->a], b = wall ? monitor->b : model->particles.slot[monitor->b];
  return nb_contacts_find(model, a, b, wall);
}
static double field(const struct nb_model *model, const struct nb_monitor *monitor, enum nb_field which) {
  return nb_field_of(model, contact_of(model, monitor), which);
}
static double total_shear(const struct nb_model *model, const struct nb_monitor *monitor) {
  const long contact = contact_of(model, monitor);
  return contact < 0 ? 0 : model->contacts.force[contact].shear;
}
NB_QUANTITY(pair_overlap, field(model, monitor, NB_OVERLAP))
NB_QUANTITY(pair_normal, field(model, monitor, NB_NORMAL))
NB_QUANTITY(pair_shear, field(model, monitor, NB_SHEAR))
NB_QUANTITY(pair_sliding, field(model, monitor, NB_SLIDING))
NB_QUANTITY(pair_dashpot_normal,
            model->plan.dashpots ? field(model, monitor, NB_TOTAL_NORMAL) - field(model, monitor, NB_NORMAL) : 0)
NB_QUANTITY(pair_dashpot_shear,
            model->plan.dashpots ? total_shear(model, monitor) - field(model, monitor, NB_SHEAR) : 0)

enum {
  PARTICLE = 1 << NB_MONITOR_PARTICLE,
  WALL = 1 << NB_MONITOR_WALL,
  GRADING = 1 << NB_MONITOR_GRADING,
  PAIR = 1 << NB_MONITOR_PARTICLE_PARTICLE | 1 << NB_MONITOR_PARTICLE_WALL
};

static const struct nb_quantity_kind kinds[] = {
    {"cycle", 0, "1", NB_REQUEST_CLOCK, cycle, "calculation cycles since the start", NB_AT_LEAST_0},
    {"time", 0, "s", NB_REQUEST_CLOCK, time_, "time since the start", NB_AT_LEAST_0},
    {"stage.time", 0, "s", NB_REQUEST_CLOCK, stage_time, "time since the stage began", NB_AT_LEAST_0},
    {"contacts", 0, "1", NB_BIT(NB_OVERLAP), touching_count, "number of contacts with an overlap",
     NB_AT_LEAST_0 | NB_COUNTED},
    {"contacts.deep", 0, "1", 0, deep_count,
     "contacts of elastic spheres that overlap by more than 7 % of the smaller diameter, summed over all cycles [R89 "
     "sec. 6.4.3]; the fraction of `damping critical` replaces the 7 %",
     NB_AT_LEAST_0},
    {"unbalanced.max", 0, "1", 0, unbalanced_max,
     "largest unbalanced force on a particle over largest contact force, dF/F of [CS79 table 1]; infinite if "
     "forces act but all contact forces are 0, 0 if no force acts. The force of an oscillation crosses zero in motion, "
     "so a wait for rest is `until unbalanced.max below 1e-4 and energy.kinetic below VALUE and contacts above 0`",
     NB_AT_LEAST_0},
    {"energy.kinetic", 0, "J", 0, kinetic_energy, "kinetic energy of all free particles, rotation included",
     NB_AT_LEAST_0},
    {"energy.stored", 0, "J", NB_OF_STORED | NB_REQUEST_STORED, stored_energy,
     "elastic energy of all contacts, from the laws' state functions"},
    {"energy.friction", 0, "J", NB_OF_BALANCE | NB_REQUEST_STORED, frictional_dissipation,
     "dissipated by friction since the start: shear force times sliding displacement; micro-slip included"},
    {"energy.sliding", 0, "J", NB_OF_BALANCE | NB_REQUEST_STORED, sliding_dissipation,
     "the part of energy.friction dissipated while contacts slide; the rest is micro-slip"},
    {"energy.shear", 0, "J", NB_OF_BALANCE, shear_work,
     "work done against shear forces since the start; for laws without stored energy"},
    {"energy.damped", 0, "J", NB_OF_BALANCE, damping_dissipation,
     "dissipated by dashpots and mass-proportional damping since the start"},
    {"energy.walls", 0, "J", NB_OF_BALANCE, wall_work,
     "supplied since the start by walls and by fixed particles that move, their force times their velocity"},
    {"energy.gravity", 0, "J", NB_OF_BALANCE, gravity_work, "supplied by gravity since the start"},
    {"energy.changed", 0, "J", NB_OF_BALANCE, stage_work,
     "supplied by changes of stages: velocities zeroed or reversed, loaded springs made stiffer or softer"},
    {"energy.imposed", 0, "J", NB_OF_BALANCE, imposed_work,
     "work of the imposed motion (cell, boundary, affine strain) and of a stress on a boundary; that of walls, also "
     "with `box strain`, is energy.walls"},
    {"energy.removed", 0, "J", NB_OF_BALANCE, removed_energy,
     "kinetic energy of particles that stages have removed or a boundary holds, and elastic energy of their contacts "
     "and of those of removed walls"},
    {"energy.balance", 0, "J", NB_OF_BALANCE, energy_residual,
     "kinetic, stored, frictional, damped and removed energy, less the initial and the supplied energy: the error of "
     "time integration"},
    {"work.balance", 0, "J", NB_REQUEST_WORK, work_residual,
     "kinetic energy at the half step, less its initial value and the work of all forces; it consists of rounding "
     "errors"},
    {"momentum.x", 0, "kg.m/s", 0, momentum_x, "momentum of all free particles"},
    {"momentum.y", 0, "kg.m/s", 0, momentum_y, "momentum of all free particles"},
    {"momentum.angular", 0, "kg.m2/s", 0, momentum_angular,
     "angular momentum of all free particles about the origin, counterclockwise"},
    {"x", PARTICLE, "m", 0, particle_x, "position of the centre"},
    {"y", PARTICLE, "m", 0, particle_y, "position of the centre"},
    {"angle", PARTICLE, "rad", 0, particle_angle, "rotation since the start, counterclockwise"},
    {"vx", PARTICLE, "m/s", 0, particle_vx, "velocity, mean of the two half steps [CS79 31]"},
    {"vy", PARTICLE, "m/s", 0, particle_vy, "velocity, mean of the two half steps"},
    {"spin", PARTICLE, "rad/s", 0, particle_spin, "angular velocity, counterclockwise, mean of the two half steps"},
    {"vx.half", PARTICLE, "m/s", 0, particle_vx_half, "velocity over the last step [CS79 22]"},
    {"vy.half", PARTICLE, "m/s", 0, particle_vy_half, "velocity over the last step"},
    {"spin.half", PARTICLE, "rad/s", 0, particle_spin_half, "angular velocity over the last step [CS79 23]"},
    {"fx", PARTICLE, "N", 0, particle_fx, "sum of the contact forces, dashpots included"},
    {"fy", PARTICLE, "N", 0, particle_fy, "sum of the contact forces"},
    {"moment", PARTICLE, "N.m", 0, particle_moment, "sum of the moments of the contact forces, counterclockwise"},
    {"overlap", PAIR, "m", NB_BIT(NB_OVERLAP), pair_overlap,
     "overlap of the two particles, or of the particle and the wall", NB_AT_LEAST_0},
    {"normal", PAIR, "N", NB_BIT(NB_NORMAL), pair_normal,
     "elastic normal force F_n without the dashpot; the whole normal force is `normal` plus `dashpot.normal`",
     NB_AT_LEAST_0_BY_LAW},
    {"shear", PAIR, "N", NB_BIT(NB_SHEAR), pair_shear,
     "elastic shear force F_s without the dashpot, `dashpot.shear`; above 0 if it pushes the first particle to the "
     "left of the direction to the second one or the wall"},
    {"sliding", PAIR, "1", NB_BIT(NB_SLIDING), pair_sliding, "1 while F_s is at its limit, else 0",
     NB_AT_LEAST_0 | NB_AT_MOST_1},
    {"dashpot.normal", PAIR, "N", NB_BIT(NB_NORMAL) | NB_BIT(NB_TOTAL_NORMAL), pair_dashpot_normal,
     "normal force of the dashpot, D_n [CS79 26]"},
    {"dashpot.shear", PAIR, "N", NB_BIT(NB_SHEAR), pair_dashpot_shear, "shear force of the dashpot, D_s [CS79 27]"},
    {0},
};

/* The tables of all rows. The last row of a table has no name. */
static const struct nb_quantity_kind *const tables[] = {
    kinds,           nb_step_kinds,         nb_wall_kinds, nb_loading_kinds, nb_fill_kinds, nb_impact_kinds,
    nb_region_kinds, nb_contact_test_kinds, NULL};

/* `kind`, or the first row of the next table if `kind` is the last row of **table; NULL after the last table. */
static const struct nb_quantity_kind *row_from(const struct nb_quantity_kind *const **table,
                                               const struct nb_quantity_kind *kind) {
  while (kind && !kind->name)
    kind = *++*table;
  return kind;
}

/* A loop over all rows: first those of this file, then those of the other files. */
#define FOR_EACH(kind)                                                                                                 \
  for (const struct nb_quantity_kind *const *table = tables, *kind = *table; (kind = row_from(&table, kind)); kind++)

/* True if monitor w has the quantity; w = -1: the whole scene has it. */
static bool applies(const struct nb_quantity_kind *kind, const struct nb_scene *scene, int w) {
  if (scene->contact_test)
    return kind->monitors == NB_OF_CONTACT_TEST;
  if (w >= 0)
    return kind->monitors & 1u << scene->monitors[w].kind;
  return !kind->monitors || (kind->monitors == NB_OF_IMPACT && scene->impact.line) ||
         (kind->monitors == NB_OF_CELL && scene->cell.line) ||
         (kind->monitors == NB_OF_BOX && nb_box_first_wall(scene) >= 0);
}

/* Sets *suffix to the suffix of the s-th quantity of a row, to NULL if the row is a scalar. False after the last
 * quantity. */
static bool nth_suffix(const struct nb_quantity_kind *kind, size_t s, const struct nb_suffix **suffix) {
  *suffix = kind->family == NB_SCALAR ? NULL : nb_suffix(kind->family, s);
  return *suffix || (kind->family == NB_SCALAR && s == 0);
}

/* Writes the name of a quantity: NAME, or NAME.SUFFIX. */
static void name_of(char *text, size_t size, const struct nb_quantity_kind *kind, const struct nb_suffix *suffix) {
  snprintf(text, size, "%s%s%s", kind->name, suffix ? "." : "", suffix ? suffix->name : "");
}

/* True if a name is one of the names of a row; *suffix is then its suffix. */
static bool matches(const struct nb_quantity_kind *kind, const char *name, const struct nb_suffix **suffix) {
  const size_t length = strlen(kind->name);
  if (strncmp(kind->name, name, length) != 0)
    return false;
  for (size_t s = 0; nth_suffix(kind, s, suffix); s++)
    if (*suffix ? name[length] == '.' && strcmp((*suffix)->name, name + length + 1) == 0 : name[length] == '\0')
      return true;
  return false;
}

/* Writes the name of the quantity that is equal to a text but for capitals and for `_` or `-` in place of a dot; false:
 * there is none. A text of one letter is no name in another spelling. */
static bool spelt(char name[2 * NB_NAME_SIZE], const char *text) {
  const struct nb_suffix *suffix;
  FOR_EACH (kind)
    for (size_t s = 0; nth_suffix(kind, s, &suffix); s++) {
      name_of(name, 2 * NB_NAME_SIZE, kind, suffix);
      if (text[0] && text[1] && nb_same_spelling(name, text))
        return true;
    }
  return false;
}

bool nb_is_quantity(const char *name) {
  const struct nb_suffix *suffix;
  FOR_EACH (kind)
    if (matches(kind, name, &suffix))
      return true;
  return false;
}

/* Finds a quantity of monitor w by the name after the dot; w = -1: a quantity of the whole scene. */
static bool find_quantity(struct nb_quantity *quantity, const struct nb_scene *scene, int w, const char *name) {
  const struct nb_suffix *suffix;
  FOR_EACH (kind)
    if (applies(kind, scene, w) && matches(kind, name, &suffix)) {
      *quantity = (struct nb_quantity){kind, w, suffix};
      return true;
    }
  return false;
}

/* True if a hint may propose the quantity. Every scene has the quantities `boundary.…`, but a hint proposes them only if
 * the scene has a boundary. `owned`: the searched word is a quantity of a region or a monitor, and then a hint proposes
 * no quantity of the scene. */
static bool is_offered(const struct nb_quantity_kind *kind, const struct nb_scene *scene, int w, bool owned) {
  const bool boundary = strncmp(kind->name, "boundary.", strlen("boundary.")) == 0;
  return applies(kind, scene, w) && (boundary ? scene->circle.line : kind->monitors || !owned);
}

/* Offers the names of all quantities of monitor w; w = -1: of the whole scene. */
static void offer_names(struct nb_guess *guess, const struct nb_scene *scene, int w) {
  char name[NB_NAME_SIZE], whole[3 * NB_NAME_SIZE];
  const struct nb_suffix *suffix;
  const bool owned = nb_is_quantity(guess->word);
  FOR_EACH (kind)
    for (size_t s = 0; is_offered(kind, scene, w, owned) && nth_suffix(kind, s, &suffix); s++) {
      name_of(name, sizeof name, kind, suffix);
      snprintf(whole, sizeof whole, "%s%s%s", w < 0 ? "" : scene->monitors[w].name, w < 0 ? "" : ".", name);
      nb_guess_offer(guess, whole);
    }
}

/* Index of the monitor with this name, which has `length` bytes; -1: none. */
static int monitor_named(const struct nb_scene *scene, const char *name, size_t length) {
  int w = (int)scene->monitor_count - 1;
  while (w >= 0 && (strncmp(scene->monitors[w].name, name, length) != 0 || scene->monitors[w].name[length]))
    w--;
  return w;
}

bool nb_quantity_find(struct nb_quantity *quantity, const struct nb_scene *scene, const char *text) {
  *quantity = (struct nb_quantity){.monitor = -1};
  if (find_quantity(quantity, scene, -1, text))
    return true;
  const size_t length = strcspn(text, "."); /* a monitor's name has no dot */
  const int w = text[length] ? monitor_named(scene, text, length) : -1;
  return w >= 0 && find_quantity(quantity, scene, w, text + length + 1);
}

/* ---- bounds ---- */

/* Whether the bounds of a quantity decide the comparison `below` or `above` a value. */
enum decision { OPEN, NEVER, ALWAYS };
static enum decision decide(unsigned bounds, enum nb_relation relation, double value) {
  const double least = bounds & NB_AT_LEAST_0 ? 0 : -INFINITY, most = bounds & NB_AT_MOST_1 ? 1 : INFINITY;
  if (relation == NB_BELOW)
    return value <= least ? NEVER : value > most ? ALWAYS : OPEN;
  return value >= most ? NEVER : value < least ? ALWAYS : OPEN;
}

const char *nb_count_hint(char *hint, const char *name, double fraction) {
  const char *const dot = strchr(name, '.');
  const int whole = (int)strcspn(name, " "), owner = dot ? (int)(dot - name) : 0;
  snprintf(hint, NB_HINT_SIZE, "`%.*s` is a count: write a number", whole, name);
  if (dot && strncmp(name, "boundary.", strlen("boundary.")) != 0) /* of a region */
    nb_append(
        hint, NB_HINT_SIZE,
        ", or, in the block `expect`, at most a fraction of another count, `%.*s last expected 0 within %.6g %% of "
        "%.*s.%s last [SOURCE]`",
        whole, name, 100 * fraction, owner, name, strncmp(dot, ".contacts", 9) ? "particles" : "contacts");
  return hint;
}

/* Refuses a percentage that is compared with a count. */
static bool is_share_of_count(struct nb_reader *reader, const struct nb_comparison *it) {
  const size_t after = (size_t)(it->token - reader->tokens) + 1;
  const char *const unit = after < reader->count ? reader->tokens[after].text : "";
  char hint[NB_HINT_SIZE];
  return it->bounds & NB_COUNTED && (strcmp(unit, "%") == 0 || strcmp(unit, "ppm") == 0) &&
         !nb_token_mistake(reader, it->token, nb_count_hint(hint, it->name, it->value),
                           "expected a number without unit, found `%s %s`", it->token->text, unit);
}

/* True if the bounds of the quantity let the comparison hold and fail. */
static bool is_within_bounds(struct nb_reader *reader, const struct nb_comparison *it, const char *what) {
  const enum decision decision = decide(it->bounds, it->relation, it->value);
  const bool below = it->relation == NB_BELOW, never = decision == NEVER, zero = below == never; /* the bound is 0 */
  const bool number = strcmp(it->unit, "1") == 0 || reader->unitless;
  const char *const relation = below ? "below" : "above";
  char hint[NB_HINT_SIZE];
  snprintf(hint, sizeof hint, "`%s` is never %s %d: write a number %s, such as `%s %s %s%s%s`", it->name,
           zero ? "below" : "above", !zero,
           never  ? zero ? "above 0" : "below 1"
           : zero ? "of 0 or more"
                  : "of 1 or less",
           it->name, relation,
           never  ? !zero                        ? "0.999"
                    : strcmp(it->unit, "m") == 0 ? "1e-12" /* an overlap can be far below 1 nm in a whole contact */
                                                 : "1e-9"
           : zero ? "0"
                  : "1",
           number ? "" : " ", number ? "" : it->unit);
  return decision == OPEN || nb_token_mistake(reader, it->token, hint, "expected %s that can %s, found `%s %s %s`",
                                              what, never ? "hold" : "fail", it->name, relation, it->token->text);
}

bool nb_comparison_is_open(struct nb_reader *reader, const struct nb_comparison *it, const char *what) {
  return !is_share_of_count(reader, it) && is_within_bounds(reader, it, what);
}

void nb_comparison_warn(struct nb_warnings *warnings, int line, const struct nb_comparison *it) {
  const bool by_law = (it->bounds & (NB_AT_LEAST_0 | NB_AT_LEAST_0_BY_LAW)) == NB_AT_LEAST_0_BY_LAW;
  const enum decision decision = decide(by_law ? NB_AT_LEAST_0 : 0, it->relation, it->value);
  if (decision != OPEN)
    nb_warn(warnings, line,
            "`%s %s %s` %s, unless the contact law is one of your own with tensile forces: `%s` is 0 or more with all "
            "laws of nineball",
            it->name, it->relation == NB_BELOW ? "below" : "above", it->token->text,
            decision == NEVER ? "never holds" : "always holds", it->name);
}

/* True for a normal stress or the mean of two, such as `box.stress.xx` and `M.stress.mean`. */
static bool is_normal_stress(struct nb_quantity quantity) {
  static const char *const suffixes[] = {"xx", "yy", "major", "minor", "mean"};
  const char *const name = quantity.kind->name, *const dot = strrchr(name, '.');
  bool found = false;
  for (size_t k = 0; quantity.suffix && k < sizeof suffixes / sizeof *suffixes; k++)
    found = found || strcmp(quantity.suffix->name, suffixes[k]) == 0;
  return found && strcmp(dot ? dot + 1 : name, "stress") == 0;
}

void nb_tension_warn(struct nb_scene *scene, const struct nb_quantity *quantity, const char *name, const char *relation,
                     double value, int line) {
  const bool below = strcmp(relation, "below") == 0, above = strcmp(relation, "above") == 0;
  if (value < 0 && (!quantity || is_normal_stress(*quantity)))
    nb_warn(
        &scene->warnings, line,
        "`%s %s` with a negative value means tension, because stress is positive in compression: for a pressure write "
        "`%s %s %g%s`",
        name, relation, name,
        below   ? "above"
        : above ? "below"
                : relation,
        -value, scene->unitless ? "" : " Pa");
}

double nb_quantity_value(struct nb_quantity quantity, const struct nb_model *model) {
  return nb_quantity_now(quantity, model);
}

static const char *unit_of(const struct nb_quantity_kind *kind, const struct nb_suffix *suffix) {
  return suffix && suffix->unit ? suffix->unit : kind->unit;
}

const char *nb_quantity_unit(struct nb_quantity quantity) { return unit_of(quantity.kind, quantity.suffix); }

bool nb_quantity_is_residual(struct nb_quantity quantity) {
  const char *end = strrchr(quantity.kind->name, '.');
  return end && (strcmp(end, ".residual") == 0 || strcmp(end, ".balance") == 0);
}

/* Owners of quantities: a statement that defines one, and the beginning of the names of its quantities. */
static const struct owner {
  unsigned monitors; /* set of monitor kinds, as in struct nb_quantity_kind */
  const char *of, *statement, *name;
  const char *of_spheres; /* the statement in a scene of spheres; NULL: the same as for discs */
} owners[] = {
    {PARTICLE, "a particle", "monitor A disc 1", "A.", "monitor A sphere 1"},
    {WALL, "a wall", "monitor S wall NAME", "S.", NULL},
    {PAIR, "a contact", "monitor C disc 1 with disc 2", "C.", "monitor C sphere 1 with sphere 2"},
    {NB_OF_REGION, "a region", "region M all", "M.", NULL},
    {GRADING, "a grading", "monitor G grading NAME", "G.", NULL},
    {NB_OF_IMPACT, "an impact", "impact MONITOR speed V angle A", "", NULL},
    {NB_OF_CELL, "a periodic cell", "periodic cell X Y to X Y", "", NULL},
    {NB_OF_BOX, "a box of walls", "box X Y to X Y MATERIAL", "", NULL},
    {NB_OF_CONTACT_TEST, "a contact test", NULL, NULL, NULL},
    {0, "the scene", NULL, NULL, NULL},
};

static const struct owner *owner_of(unsigned monitors) {
  const struct owner *owner = owners;
  while (owner->monitors && !(owner->monitors & monitors))
    owner++;
  return owner;
}

bool nb_quantity_row(struct nb_quantity_row *it, size_t k) {
  const struct nb_suffix *suffix;
  FOR_EACH (kind)
    for (size_t s = 0; nth_suffix(kind, s, &suffix); s++)
      if (k-- == 0) {
        name_of(it->name, sizeof it->name, kind, suffix);
        snprintf(it->help, sizeof it->help, "%s%s%s", suffix ? suffix->help : "", suffix ? ": " : "", kind->help);
        it->key = (const char *)kind + s;
        const struct owner *const owner = owner_of(kind->monitors);
        it->unit = unit_of(kind, suffix), it->of = owner->of;
        it->statement = owner->statement, it->prefix = owner->name;
        return true;
      }
  return false;
}

/* True if an earlier row has the same monitors and the same first part of the name: `stress.sinphi` after `stress`. */
static bool is_of_earlier_family(const struct nb_quantity_kind *it) {
  const size_t length = strcspn(it->name, ".");
  FOR_EACH (kind) {
    if (kind == it)
      break;
    if (kind->monitors == it->monitors && strcspn(kind->name, ".") == length &&
        strncmp(kind->name, it->name, length) == 0)
      return true;
  }
  return false;
}

/* Writes "`c` is a contact; its quantities are overlap, normal, …": the first parts of all names. */
static const char *list_quantities(char *hint, const struct nb_scene *scene, int w) {
  const char *const name = scene->monitors[w].name, *between = "";
  char first[2 * NB_NAME_SIZE];
  struct nb_quantity quantity;
  *hint = '\0';
  FOR_EACH (kind) {
    if (!applies(kind, scene, w) || is_of_earlier_family(kind))
      continue;
    if (!*hint)
      snprintf(hint, NB_HINT_SIZE, "`%s` is %s; its quantities are ", name, owner_of(kind->monitors)->of);
    snprintf(first, sizeof first, "%s.%.*s", name, (int)strcspn(kind->name, "."), kind->name);
    nb_append(hint, NB_HINT_SIZE, "%s%s%s", between, first + strlen(name) + 1,
              nb_quantity_find(&quantity, scene, first) ? "" : ".…"); /* `speed` alone is no quantity */
    between = ", ";
  }
  nb_append(hint, NB_HINT_SIZE, ": see `nineball --help quantities`");
  return hint;
}

/* Appends the name with the monitors of the scene that have the quantity: `M.coordination`. */
static void append_own(char *list, size_t size, const struct nb_scene *scene, const struct nb_quantity_kind *kind,
                       const char *name) {
  char whole[3 * NB_NAME_SIZE];
  for (int w = 0; w < (int)scene->monitor_count; w++) {
    snprintf(whole, sizeof whole, "%s.%s", scene->monitors[w].name, name);
    if (applies(kind, scene, w) && strlen(list) + strlen(whole) + 4 < size)
      nb_append_item(list, size, whole, false);
  }
}

/* Writes "`normal.max` is a quantity of a region: `region M all`, then `M.normal.max`"; or "did you mean `A.normal.max`?" if
 * the scene has such an owner. NULL: no owner has a quantity of this name. */
static const char *owner_hint(char *hint, const struct nb_scene *scene, const char *text) {
  const bool spheres = scene->particle_count && scene->particles[0].shape == NB_SPHERE;
  const struct nb_suffix *suffix;
  char name[NB_NAME_SIZE], own[NB_HINT_SIZE / 4] = "";
  unsigned done = 0;
  const size_t length = strlen(text);
  size_t used = 0;
  FOR_EACH (kind) {
    if (!length || used >= NB_HINT_SIZE / 2)
      break;
    const struct owner *const owner = owner_of(kind->monitors);
    const bool begins = strncmp(kind->name, text, length) == 0 && strchr(".", kind->name[length]);
    if (!owner->statement || done & owner->monitors || !(matches(kind, text, &suffix) || begins))
      continue;
    if (begins)
      nth_suffix(kind, 0, &suffix);
    name_of(name, sizeof name, kind, suffix);
    append_own(own, sizeof own, scene, kind, name);
    used += (size_t)snprintf(hint + used, NB_HINT_SIZE - used, "%s`%s` is a quantity of %s: `%s`, then `%s%s`",
                             used ? "; " : "", name, owner->of,
                             spheres && owner->of_spheres ? owner->of_spheres : owner->statement, owner->name, name);
    done |= owner->monitors;
  }
  if (*own)
    snprintf(hint, NB_HINT_SIZE, "did you mean %s?", own);
  return used ? hint : NULL;
}

/* The entry of the table of words for another word for a quantity: for `p` the entry `quantity_p`, or else the entry `p`.
 * NULL: there is neither. */
static const struct nb_synonym *meaning(const char *word) {
  const struct nb_synonym *const synonym = nb_pair_synonym("quantity", word);
  return synonym ? synonym : nb_synonym(word);
}

/* Appends the quantities of a kind of monitor that a word may mean, for a monitor with the name `monitor`: for
 * `velocity` "`A.vx` or `A.vy`". */
static void list_meant(char *list, size_t size, unsigned kind, char monitor, const char *word) {
  const struct nb_synonym *const synonym = meaning(word);
  const char *items = synonym ? synonym->ours : "";
  char item[NB_NAME_SIZE];
  snprintf(item, sizeof item, "%s", word);
  do
    FOR_EACH (row)
      if (row->monitors & kind && strcmp(row->name, item) == 0)
        nb_append(list, size, "%s`%c.%s`", *list ? " or " : "", monitor, item);
  while (nb_item(&items, item));
}

/* True if a word means a particle: `disc`, `sphere`, `ball`. */
static bool means_particle(const char *word) {
  const struct nb_synonym *const synonym = nb_synonym(word);
  return strcmp(word, "disc") == 0 || strcmp(word, "sphere") == 0 || (synonym && strstr(synonym->ours, "disc, sphere"));
}

/* Writes what two words name, `disc 1` or `wall floor`, to `name`; the shape of a particle is that in the scene.
 * Returns the kind of monitor; 0: the words name neither a particle nor a wall. */
static unsigned named_by(char *name, size_t size, const struct nb_scene *scene, const char *word, const char *of) {
  const bool wall = strcmp(word, "wall") == 0, sphere = strcmp(word, "sphere") == 0;
  of = !wall && strcmp(of, "0") == 0 ? "1" : of; /* the first particle has the number 1 */
  const size_t number = strspn(of, "0123456789") == strlen(of) ? strtoul(of, NULL, 10) : 0;
  const bool is_sphere = number - 1 < scene->particle_count ? scene->particles[number - 1].shape == NB_SPHERE : sphere;
  snprintf(name, size, "%s %.63s", wall ? "wall" : is_sphere ? "sphere" : "disc", of);
  const bool known = NB_FIND(scene->walls, scene->wall_count, of) >= 0 || !meaning(of); /* `wall force` is no wall */
  return wall ? (known ? WALL : 0) : number && means_particle(word) ? PARTICLE : 0;
}

/* A letter that is not yet the name of a monitor, for a new monitor of `of`: A for disc 1, B for disc 2. */
static char free_name(const struct nb_scene *scene, unsigned kind, const char *of) {
  const size_t number = kind == PARTICLE ? strtoul(of + strcspn(of, "0123456789"), NULL, 10) : 1;
  char name = (char)('A' + (number < 24 ? number - 1 : 0));
  while (monitor_named(scene, &name, 1) >= 0 && name < 'Z')
    name++;
  return name;
}

/* True if a quantity begins with this owner and this name: `cell.` and `stress`. */
static bool is_beginning(const char *owner, const char *text) {
  const struct nb_suffix *suffix;
  char name[NB_NAME_SIZE];
  const size_t stem = strlen(owner), length = strlen(text);
  FOR_EACH (kind)
    for (size_t s = 0; nth_suffix(kind, s, &suffix); s++) {
      name_of(name, sizeof name, kind, suffix);
      if (strncmp(name, owner, stem) == 0 && strncmp(name + stem, text, length) == 0 &&
          strchr(".", name[stem + length]))
        return true;
    }
  return false;
}

/* True if the first n tokens are one phrase, and not several quantities: nothing but a condition follows, some word does
 * not mean a quantity by itself, and at most one begins the name of a quantity. */
static bool is_one_phrase(const struct nb_token *tokens, size_t n, size_t count) {
  const char *const after = n < count ? tokens[n].text : "above";
  bool all = true;
  int quantities = 0;
  for (size_t k = 0; k < n; k++) {
    all = all && nb_pair_synonym("quantity", tokens[k].text);
    quantities += is_beginning("", tokens[k].text);
    if (strpbrk(tokens[k].text, "._0123456789")) /* a name of parts, not a word */
      return false;
  }
  return !all && quantities < 2 && (strcmp(after, "above") == 0 || strcmp(after, "below") == 0);
}

/* The hint for several words that together mean a quantity, `mechanical coordination number`; NULL: they do not. */
static const char *words_hint(char *hint, const struct nb_scene *scene, const struct nb_token *tokens, size_t count) {
  enum { WORDS_MAX = 5 };
  char joined[2 * NB_NAME_SIZE], known[2 * NB_NAME_SIZE];
  struct nb_quantity quantity;
  if (scene->contact_test || nb_quantity_find(&quantity, scene, tokens[0].text))
    return NULL;
  for (size_t n = count < WORDS_MAX ? count : WORDS_MAX; n > 1; n--) {
    *joined = '\0';
    for (size_t k = 0; k < n; k++)
      nb_append(joined, sizeof joined, "%s%.30s", k ? "_" : "", tokens[k].text);
    if (meaning(joined) || nb_pair_synonym("whole", joined) || spelt(known, joined) ||
        (is_one_phrase(tokens, n, count) && nb_parts_hint(hint, scene, joined, -1)))
      return nb_quantity_hint(hint, scene, joined);
  }
  return NULL;
}

const char *nb_phrase_hint(char *hint, const struct nb_scene *scene, const struct nb_token *tokens, size_t count) {
  char of[4 * NB_NAME_SIZE] = "", name[2 * NB_NAME_SIZE], names[NB_HINT_SIZE / 4] = "", monitor[] = "A";
  unsigned kind = 0, other;
  for (size_t k = 0; k + 1 < count && kind != PAIR; k++)
    if ((other = named_by(name, sizeof name, scene, tokens[k].text, tokens[k + 1].text))) {
      nb_append(of, sizeof of, "%s%s", kind ? " with " : "", name);
      kind = kind ? PAIR : other;
    }
  if (!kind && count > 1)
    return words_hint(hint, scene, tokens, count);
  *monitor = free_name(scene, kind, of);
  for (size_t k = 0; k < count; k++)
    list_meant(names, sizeof names, kind, *monitor, tokens[k].text);
  if (!*names)
    list_meant(names, sizeof names, kind, *monitor, "force");
  snprintf(hint, NB_HINT_SIZE, "define a monitor before the stages, `monitor %s %s`; then write %s", monitor, of,
           names);
  return kind ? hint : NULL;
}

/* Appends the same quantity of a boundary, a cell or a box: `cell.stress.xx` for `stress.xx`. After "did you mean" only
 * that of the scene. */
static void add_namesakes(char *hint, const struct nb_scene *scene, const char *text) {
  static const char *const owners_here[] = {"boundary.", "cell.", "box."};
  const bool own = strncmp(hint, "did you mean", strlen("did you mean")) == 0;
  char whole[3 * NB_NAME_SIZE];
  for (size_t o = 0; o < sizeof owners_here / sizeof *owners_here; o++) {
    const char *const owner = owners_here[o];
    struct nb_quantity quantity;
    snprintf(whole, sizeof whole, "%s%s", owner, text);
    const bool has = nb_quantity_find(&quantity, scene, whole) && (o > 0 || scene->circle.line);
    if (own && has)
      snprintf(strrchr(hint, '?'), NB_HINT_SIZE - strlen(hint), " or `%s`?", whole);
    else if (!own && is_beginning(owner, text))
      nb_append(hint, NB_HINT_SIZE, "; of a %.*s `%s`", (int)strlen(owner) - 1, owner, whole);
  }
}

/* Writes the note on the same quantity of a box, which has another name: for `strain.volumetric` that on
 * `box.strain.volumetric`. False: the scene has no box, or there is no such note. */
static bool box_note(char *hint, const struct nb_scene *scene, const char *text) {
  char name[3 * NB_NAME_SIZE];
  snprintf(name, sizeof name, "box.%s", text);
  const struct nb_synonym *const synonym = nb_pair_synonym("quantity", name);
  return nb_is_quantity(text) && nb_box_first_wall(scene) >= 0 && synonym && synonym->note &&
         nb_pair_hint(hint, "quantity", name);
}

/* The hint for the name of a quantity whose owner is missing. The text may be such a name, also with `-` for `_`; it
 * may have such a name after its first dot; or it may be another word for such a name. */
static const char *owned_hint(char *hint, const struct nb_scene *scene, const char *text) {
  const struct nb_synonym *const synonym = meaning(text);
  const char *items = synonym ? synonym->ours : "", *const rest = strchr(text, '.');
  char item[NB_NAME_SIZE];
  snprintf(item, sizeof item, "%s", text);
  for (char *dash = item; (dash = strchr(dash, '-'));)
    *dash = '_';
  const char *found = owner_hint(hint, scene, item);
  if (found)
    add_namesakes(hint, scene, item);
  while (!found && nb_item(&items, item)) {
    if (box_note(hint, scene, item))
      return hint;
    found = owner_hint(hint, scene, item);
    if (found)
      add_namesakes(hint, scene, item);
  }
  return found || !rest ? found : owner_hint(hint, scene, rest + 1);
}

/* The hint for a quantity that needs a monitor: `north.fx` of a wall, also as `box.top.fx`, or `disc1.vx`. NULL: the
 * text is no such quantity. */
static const char *unmonitored(char *hint, const struct nb_scene *scene, const char *text) {
  text += strncmp(text, "box.", 4) == 0     ? 4
          : strncmp(text, "wall.", 5) == 0  ? 5
          : strncmp(text, "walls.", 6) == 0 ? 6
                                            : 0;
  const size_t stem = strcspn(text, "."), letters = strcspn(text, ".0123456789");
  char word[NB_NAME_SIZE], of[NB_NAME_SIZE];
  snprintf(word, sizeof word, "%.*s", (int)letters, text);
  snprintf(of, sizeof of, "%.*s", (int)(stem - letters), text + letters);
  static const struct {
    char name[NB_NAME_SIZE];
  } sides[] = {{"south"}, {"east"}, {"north"}, {"west"}, {"bottom"}, {"right"}, {"top"}, {"left"}};
  const int side = NB_FIND(sides, 8, word), given = NB_FIND(scene->walls, scene->wall_count, word);
  const bool wall = given >= 0 || side >= 0;
  if (given < 0 && side >= 0)
    snprintf(word, sizeof word, "%s", sides[side % 4].name);
  if (wall && letters == stem)
    snprintf(of, sizeof of, "%s", word), strcpy(word, "wall");
  if (wall && nb_pair_hint(hint, "of_wall", text + stem + (text[stem] == '.')))
    return hint;
  const struct nb_token tokens[] = {{.text = word}, {.text = of}, {.text = text + stem + (text[stem] == '.')}};
  return *of && stem < strlen(text) ? nb_phrase_hint(hint, scene, tokens, 3) : NULL;
}

/* True if the text, which is no quantity of the scene, is one of a cell, a box or an impact: the scene has no such
 * object. False in a contact test. */
static bool lacks_owner(const struct nb_scene *scene, const char *text) {
  const unsigned owners_without_name = NB_OF_CELL | NB_OF_BOX | NB_OF_IMPACT;
  const struct nb_suffix *suffix;
  FOR_EACH (kind)
    if (kind->monitors & owners_without_name && matches(kind, text, &suffix))
      return !scene->contact_test;
  return false;
}

/* Writes the note that the table of words has on a text which other programs use as the name of a quantity. The text is
 * a whole name, such as `box.strain.xx`, or the part after the monitor, such as `duration` of `C.duration`. The note
 * says what to write. False: there is no note. */
static bool meant_line(char *hint, const char *text) {
  const struct nb_synonym *const synonym = nb_pair_synonym("quantity", text);
  return synonym && synonym->note && nb_pair_hint(hint, "quantity", text);
}

/* Writes the hint for the force on a wall by the word of a contact, `F.shear`; false: the owner or the word is
 * another. */
static bool wall_force_hint(char *hint, const struct nb_scene *scene, const char *rest, int owner) {
  const char *const name = scene->monitors[owner].name;
  if (scene->monitors[owner].kind != NB_MONITOR_WALL ||
      (strcmp(rest, "shear") != 0 && strcmp(rest, "normal") != 0 && strcmp(rest, "tangential") != 0))
    return false;
  snprintf(hint, NB_HINT_SIZE,
           "the force on a wall has a component in x and one in y: did you mean `%s.fx` or `%s.fy`?", name, name);
  return true;
}

/* Writes "did you mean `M.coordination`?" for `M.cn`, whose second part is a word of other programs; otherwise a list
 * of the quantities of the owner. */
static const char *owned_by_hint(char *hint, const struct nb_scene *scene, const char *text, int owner) {
  const char *const dot = text + strcspn(text, ".");
  const struct nb_synonym *const synonym = *dot ? meaning(dot + 1) : NULL;
  const char *items = synonym ? synonym->ours : "";
  char item[NB_NAME_SIZE], name[3 * NB_NAME_SIZE];
  struct nb_quantity quantity;
  bool found = false;
  *hint = '\0';
  if (*dot && wall_force_hint(hint, scene, dot + 1, owner))
    return hint;
  if (synonym && synonym->note)
    nb_append(hint, NB_HINT_SIZE, "%s: ", synonym->note);
  while (nb_item(&items, item)) {
    snprintf(name, sizeof name, "%.*s.%s", (int)(dot - text), text, item);
    if (nb_quantity_find(&quantity, scene, name))
      nb_append(hint, NB_HINT_SIZE, "%s`%s`", found ? " or " : "did you mean ", name), found = true;
  }
  nb_append(hint, NB_HINT_SIZE, "?");
  return found                                                   ? hint
         : synonym && synonym->note && meant_line(hint, dot + 1) ? hint
                                                                 : list_quantities(hint, scene, owner);
}

/* Writes the hint for a text that neither is the name of a quantity nor resembles one. */
static void unknown_hint(char *hint, const struct nb_scene *scene, const char *text) {
  const char *const rest = scene->contact_test ? NULL : strchr(text, '.');
  if (!nb_synonym_hint(hint, text) && !(rest && meant_line(hint, rest + 1)))
    snprintf(hint, NB_HINT_SIZE,
             strchr(text, '"') ? NB_NO_QUOTES
             : rest ? "there is no monitor or region `%.*s`: define it with `monitor NAME …` or `region NAME …`"
                    : "see `nineball --help quantities`",
             (int)strcspn(text, "."), text);
}

/* True if the nearest name has the owner of the searched one, but for typing errors: `M.x` is no error for `A.x`. */
static bool same_owner(const struct nb_guess *guess) {
  char searched[2 * NB_NAME_SIZE], best[2 * NB_NAME_SIZE];
  snprintf(searched, sizeof searched, "%.*s", (int)strcspn(guess->word, "."), guess->word);
  snprintf(best, sizeof best, "%.*s", (int)strcspn(guess->best, "."), guess->best);
  struct nb_guess owner = nb_guess_begin(searched);
  nb_guess_offer(&owner, best);
  return !strchr(guess->word, '.') || nb_guess_found(&owner);
}

/* Writes the hint with the owner that the scene lacks, or with the nearest name; false: there is neither. A word with
 * another meaning is no typing error: `sxx` is a stress, not `S.x`. */
static bool near_hint(char *hint, const struct nb_scene *scene, const struct nb_guess *guess, int owner) {
  if (lacks_owner(scene, guess->word))
    return owner_hint(hint, scene, guess->word);
  return (!guess->synonym || guess->marked || owner >= 0) && nb_guess_hint(guess, hint);
}

/* Writes the hint for a name by its parts; false: there is none. `first`: before other hints, if the name has several
 * parts. A meaning of the whole name in the table of words has priority. */
static bool parts_hint(char *hint, const struct nb_scene *scene, const char *text, int owner, bool first) {
  const char *const name = owner >= 0 ? text + strcspn(text, ".") + 1 : text;
  const struct nb_synonym *const whole = meaning(name);
  return !nb_is_quantity(text) && !(whole && (first || owner < 0 || whole->note)) && (!first || strpbrk(name, "._-")) &&
         nb_parts_hint(hint, scene, text, owner);
}

/* Writes the hint for a text that is not the name of a quantity. */
static void hint_of(char *hint, const struct nb_scene *scene, const char *text) {
  const char *const rest = strchr(text, '.');
  const int owner = monitor_named(scene, text, strcspn(text, "."));
  char stem[2 * NB_NAME_SIZE]; /* `energy` of `energy.potential` */
  snprintf(stem, sizeof stem, "%.*s", rest && owner < 0 ? (int)(strrchr(text, '.') - text) : 0, text);
  struct nb_guess guess = nb_guess_begin(text), of_stem = nb_guess_begin(stem);
  guess.synonym = meaning(text);
  for (int w = -1; w < (int)scene->monitor_count; w++)
    offer_names(&guess, scene, w), offer_names(&of_stem, scene, w);
  if (box_note(hint, scene, text) || parts_hint(hint, scene, text, owner, true) ||
      near_hint(hint, scene, &guess, owner))
    return;
  if (parts_hint(hint, scene, text, owner, false))
    return;
  if (owner >= 0) {
    owned_by_hint(hint, scene, text, owner);
    return;
  }
  const bool found = !scene->contact_test &&
                     (unmonitored(hint, scene, text) || owned_hint(hint, scene, text) ||
                      (same_owner(&of_stem) && nb_guess_hint(&of_stem, hint)) || owner_hint(hint, scene, stem));
  if (!found)
    unknown_hint(hint, scene, text);
}

/* Replaces the last part of a name, a word of another program, by the word of this program, and writes the result to
 * `name`: `stress.major` for `stress.1`. Returns the note on this word, or "". False in *found: there is no such
 * quantity. */
static const char *with_other_part(char name[2 * NB_NAME_SIZE], bool *found, const char *text) {
  const char *const dot = strrchr(text, '.');
  char part[2 * NB_NAME_SIZE];
  snprintf(part, sizeof part, "suffix_%s", dot ? dot + 1 : "");
  const struct nb_synonym *const synonym = nb_synonym(part);
  const char *items = synonym ? synonym->ours : "";
  char item[NB_NAME_SIZE];
  *found = nb_item(&items, item);
  if (*found)
    snprintf(name, 2 * NB_NAME_SIZE, "%.*s.%s", (int)(dot - text), text, item);
  *found = *found && (nb_is_quantity(name) || nb_is_quantity(name + strcspn(name, ".") + 1));
  return synonym && synonym->note ? synonym->note : "";
}

/* Writes the hint for a name whose last part is a word of another program; false: it is no such name. */
static bool part_hint(char *hint, const struct nb_scene *scene, const char *text) {
  char name[2 * NB_NAME_SIZE];
  struct nb_quantity quantity;
  bool found;
  const char *const note = with_other_part(name, &found, text);
  if (!found)
    return false;
  if (*note)
    snprintf(hint, NB_HINT_SIZE, "%s", note);
  else if (nb_quantity_find(&quantity, scene, name))
    snprintf(hint, NB_HINT_SIZE, "did you mean `%s`?", name);
  else
    nb_quantity_hint(hint, scene, name);
  return true;
}

/* Writes the hint for a known name in another spelling, `fabric_xx` or `Stress.xx`; false: the text is no such name. */
static bool spelling_hint(char *hint, const struct nb_scene *scene, const char *text) {
  const size_t stem = strcspn(text, ".");
  const bool owned = text[stem] && monitor_named(scene, text, stem) >= 0;
  char known[2 * NB_NAME_SIZE], name[3 * NB_NAME_SIZE];
  if (!spelt(known, owned ? text + stem + 1 : text))
    return false;
  struct nb_quantity quantity;
  snprintf(name, sizeof name, "%.*s%s", owned ? (int)stem + 1 : 0, text, known);
  if (strcmp(name, text) == 0)
    return false;
  if (nb_quantity_find(&quantity, scene, name))
    snprintf(hint, NB_HINT_SIZE, "did you mean `%s`?", name);
  else
    nb_quantity_hint(hint, scene, name);
  return true;
}

static bool is_part_end(char c) { return !c || strchr("._- ", c); }

/* True if a text is the name of a material, or `contacts` and such a name: `contacts.steel.glass`. */
static bool names_material(const struct nb_scene *scene, const char *text) {
  const size_t stem = strncmp(text, "contacts", strlen("contacts")) == 0 ? strlen("contacts") : 0;
  text += stem + (stem && is_part_end(text[stem]) && text[stem]);
  for (size_t k = 0; k < scene->material_count; k++) {
    const size_t length = strlen(scene->materials[k].name);
    if (strncmp(text, scene->materials[k].name, length) == 0 && (stem ? is_part_end(text[length]) : !text[length]))
      return true;
  }
  return false;
}

/* Writes the note of the table of words on a whole name, `height`, without an owner, or on a word after the name of a
 * monitor, `vy` of `F.vy` for a wall; false: there is no such note. */
static bool whole_hint(char *hint, const struct nb_scene *scene, const char *text) {
  const char *const rest = strchr(text, '.');
  const int owner = rest ? monitor_named(scene, text, strcspn(text, ".")) : -1;
  if (scene->contact_test)
    return false;
  if (names_material(scene, text))
    return nb_pair_hint(hint, "whole", "contacts_by_material");
  static const char *const places[NB_MONITOR_SIZE] = {
      [NB_MONITOR_PARTICLE] = "of_particle",
      [NB_MONITOR_WALL] = "of_wall",
      [NB_MONITOR_PARTICLE_PARTICLE] = "of_contact",
      [NB_MONITOR_PARTICLE_WALL] = "of_contact",
      [NB_MONITOR_REGION] = "whole",
  };
  const char *const place = owner >= 0 ? places[scene->monitors[owner].kind] : NULL;
  return place ? nb_pair_hint(hint, place, rest + 1) : nb_pair_hint(hint, "whole", text);
}

/* Appends what the proposed strain, or the proposed force on wall w, means. */
static void add_meaning(char *hint, const struct nb_scene *scene, int w) {
  if (strstr(hint, ".fy`") && w >= 0 && scene->monitors[w].kind == NB_MONITOR_WALL)
    nb_append(hint, NB_HINT_SIZE,
              " (the force of the particles on the wall: on a floor under gravity `%s.fy` is below 0)",
              scene->monitors[w].name);
  if (strstr(hint, "strain.xy`"))
    nb_append(hint, NB_HINT_SIZE, " (xy is half the engineering shear strain)");
  for (size_t k = 0; k < 2 && scene->stage_count > 1; k++)
    if (strstr(hint, k ? "cell.strain.yy`" : "cell.strain.xx`"))
      nb_append(hint, NB_HINT_SIZE,
                " (a strain of the cell counts from time 0: that of a later stage is (1 + END)/(1 + BEGIN) - 1, or "
                "`S.strain.%s` of the particles with `region S all from STAGE`)",
                k ? "yy" : "xx");
}

/* Changes a hint that proposes the stored energy if a law of the scene has none. */
static void stored_hint(char *hint, const struct nb_scene *scene) {
  const struct nb_law *const laws[] = {nb_law_find("normal", scene->normal), nb_law_find("shear", scene->shear)};
  for (size_t k = 0; k < 2; k++)
    if (laws[k] && !laws[k]->stored)
      snprintf(hint, NB_HINT_SIZE, "`%s %s` has no stored energy: the work of the shear forces is `energy.shear`",
               laws[k]->kind, laws[k]->name);
}

const char *nb_quantity_hint(char *hint, const struct nb_scene *scene, const char *text) {
  const size_t stem = strcspn(text, ".");
  if (whole_hint(hint, scene, text))
    return hint;
  if (!scene->contact_test && (part_hint(hint, scene, text) || spelling_hint(hint, scene, text)))
    return hint;
  const int owner = text[stem] && nb_pair_synonym("quantity", text + stem + 1) ? monitor_named(scene, text, stem) : -1;
  if (owner >= 0) /* `A.w` means the spin, not `A.x` */
    return owned_by_hint(hint, scene, text, owner);
  if (!scene->contact_test && meant_line(hint, text))
    return hint;
  if (strchr(text, '(')) {
    char name[2 * NB_NAME_SIZE];
    struct nb_quantity quantity;
    snprintf(name, sizeof name, "%.*s", (int)strcspn(strchr(text, '(') + 1, "),"), strchr(text, '(') + 1);
    if (!nb_quantity_find(&quantity, scene, name))
      strcpy(name, "A.x");
    snprintf(hint, NB_HINT_SIZE,
             "record the quantity alone, `record %s`; in a block `expect` `max`, `mean` or another reducer follows the "
             "quantity: `%s max`",
             name, name);
    return hint;
  }
  hint_of(hint, scene, text);
  if (strstr(hint, "`energy.stored`"))
    stored_hint(hint, scene);
  add_meaning(hint, scene, monitor_named(scene, text, stem));
  return hint;
}
