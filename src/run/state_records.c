/* The records of a saved state. One that others need later is a row of the table below, and one in docs/STATE.md.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "state_reading.h"

static int take_material(struct nb_state_reading *reading) {
  char name[NB_NAME_SIZE];
  nb_saved_name(reading, name, "the name of a material");
  for (size_t m = 0; m < reading->saved->material_count; m++)
    if (strcmp(reading->saved->materials[m].name, name) == 0)
      return (int)m;
  nb_saved_expected(reading, "the name of a material that stands above");
  return 0;
}

/* A new name; `known` of them stand in an array of elements that begin with it. */
static void new_name(struct nb_state_reading *reading, char *name, const void *known, size_t count, size_t element,
                     const char *what) {
  nb_saved_name(reading, name, what);
  if (!nb_is_name(name))
    nb_saved_expected(reading, "%s", what);
  for (size_t k = 0; k < count; k++)
    if (strcmp((const char *)known + k * element, name) == 0)
      nb_saved_expected(reading, "%s, each once", what);
}

static void read_program(struct nb_state_reading *reading) {
  nb_saved_name(reading, reading->saved->program, "the version of the program");
}
static void read_page(struct nb_state_reading *reading) { nb_saved_rest(reading, reading->saved->page, NB_NAME_SIZE); }
static void read_stage(struct nb_state_reading *reading) {
  nb_saved_name(reading, reading->saved->stage, "the name of a stage");
}

static void read_hash(struct nb_state_reading *reading) {
  char field[NB_STATE_FIELD], *end;
  nb_saved_take_field(reading, field, "16 hexadecimal digits");
  reading->saved->hash = strtoull(field, &end, 16);
  if (*end || strlen(field) != 16)
    nb_saved_expected(reading, "16 hexadecimal digits");
}

static void read_setting(struct nb_state_reading *reading) {
  char(*setting)[2 * NB_NAME_SIZE] = NB_SAVED_MORE(reading, settings, setting_count, NB_NAMED_MAX);
  if (setting)
    nb_saved_rest(reading, *setting, sizeof *setting);
}

static void read_cycle(struct nb_state_reading *reading) {
  reading->saved->cycle = nb_saved_count(reading, 0, 1000000000000UL);
  reading->saved->stage_cycle = nb_saved_count(reading, 0, reading->saved->cycle);
}

static void read_time(struct nb_state_reading *reading) {
  reading->saved->time = nb_saved_not_negative(reading);
  reading->saved->step = nb_saved_above_0(reading);
}

static void read_units(struct nb_state_reading *reading) {
  reading->saved->unitless = nb_saved_one_of(reading, "si", "none", NULL) == 1;
}
static void read_gravity(struct nb_state_reading *reading) { reading->saved->gravity = nb_saved_vector(reading); }

static struct nb_tensor take_four(struct nb_state_reading *reading) {
  const struct nb_vec east = nb_saved_vector(reading);
  const struct nb_vec north = nb_saved_vector(reading);
  return tensor(east.x, east.y, north.x, north.y);
}

static enum nb_carrier take_carrier(struct nb_state_reading *reading) {
  char name[NB_NAME_SIZE];
  nb_saved_name(reading, name, "what carries along");
  for (int c = 0; c < NB_CARRIERS; c++)
    if (strcmp(nb_saved_carrier_words[c], name) == 0)
      return (enum nb_carrier)c;
  nb_saved_expected(reading, "`nothing`, `continuum`, `boundary`, `cell` or `box`");
  return NB_CARRIER_NONE;
}

static void read_inward(struct nb_state_reading *reading) {
  reading->saved->inward.strength = nb_saved_finite(reading);
  reading->saved->inward.to = nb_saved_vector(reading);
}

static void read_rotation(struct nb_state_reading *reading) {
  reading->saved->turns = nb_saved_one_of(reading, "off", "on", NULL) == 1;
}

static void read_cell(struct nb_state_reading *reading) {
  struct nb_saved_cell *it = &reading->saved->cell;
  it->is = true;
  it->h = take_four(reading);
  if (!(it->h.xx * it->h.yy - it->h.xy * it->h.yx > 0))
    nb_saved_expected(reading, "a cell with an area above 0");
  it->parting = take_four(reading);
}

static void read_centre(struct nb_state_reading *reading) { reading->saved->centre = nb_saved_vector(reading); }

static void read_carrier(struct nb_state_reading *reading) {
  const enum nb_carrier carrier = take_carrier(reading);
  struct nb_saved_carrier *it = &reading->saved->carriers[carrier];
  if (reading->carriers & 1U << carrier)
    nb_saved_expected(reading, "such a record once for each carrier");
  reading->carriers |= 1U << carrier;
  it->literal = nb_saved_one_of(reading, "apart", "literal", NULL) == 1;
  it->rate = take_four(reading);
  it->asked.per_cycle = nb_saved_one_of(reading, "time", "cycle", NULL) == 1;
  const struct nb_tensor asked = take_four(reading);
  it->asked.xx = asked.xx, it->asked.xy = asked.xy, it->asked.yx = asked.yx, it->asked.yy = asked.yy;
}

static void read_law(struct nb_state_reading *reading) {
  const bool shear = nb_saved_one_of(reading, "normal", "shear", NULL) == 1;
  char *name = shear ? reading->saved->shear : reading->saved->normal;
  if (name[0])
    nb_saved_expected(reading, "such a record once");
  nb_saved_name(reading, name, "the name of a law");
  if (!nb_law_find(shear ? "shear" : "normal", name))
    nb_saved_expected(reading, "a law of this program");
  if (shear)
    reading->saved->pieces = (int)nb_saved_count(reading, 0, NB_PIECES_MAX);
}

static void read_material(struct nb_state_reading *reading) {
  struct nb_material *it = NB_SAVED_MORE(reading, materials, material_count, NB_MATERIALS_MAX);
  if (!it)
    return;
  new_name(reading, it->name, reading->saved->materials, reading->saved->material_count - 1, sizeof *it,
           "the name of a material");
  it->density = nb_saved_not_negative(reading);
#define ROW(name, ...) it->name = nb_saved_not_negative(reading);
  NB_PAIR_ROWS(ROW)
#undef ROW
  it->young = nb_saved_not_negative_if_any(reading);
  if (isnan(it->young))
    nb_saved_expected(reading, "0 or more");
  it->poisson = nb_saved_not_negative(reading);
  if (it->poisson > 0.5)
    nb_saved_expected(reading, "a number from 0 to 0.5");
}

static void read_pair(struct nb_state_reading *reading) {
  struct nb_pair_rule *it = NB_SAVED_MORE(reading, rules, rule_count, NB_MATERIALS_MAX * NB_MATERIALS_MAX);
  if (!it)
    return;
  it->a = take_material(reading), it->b = take_material(reading);
#define ROW(name, ...) it->name = nb_saved_not_negative_if_any(reading);
  NB_PAIR_ROWS(ROW)
#undef ROW
}

static void read_body(struct nb_state_reading *reading) {
  struct nb_saved_body *it = NB_SAVED_MORE(reading, bodies, body_count, NB_BODIES_MAX);
  const size_t number = reading->saved->body_count;
  if (!it)
    return;
  nb_saved_count(reading, number, number);
  it->shape = nb_saved_one_of(reading, "disc", "sphere", NULL) ? NB_SPHERE : NB_DISC;
  it->material = take_material(reading);
  it->mobility = (enum nb_mobility)nb_saved_one_of(reading, "free", "fixed", "gone");
  it->radius = nb_saved_above_0(reading);
  it->position = nb_saved_vector(reading), it->velocity = nb_saved_vector(reading);
  it->spin = nb_saved_finite(reading), it->angle = nb_saved_finite(reading);
}

static void read_carried(struct nb_state_reading *reading) {
  struct nb_saved_carried *it = NB_SAVED_MORE(reading, carried, carried_count, NB_BODIES_MAX);
  const size_t number = reading->saved->carried_count;
  if (!it)
    return;
  if (number > reading->saved->body_count)
    nb_saved_expected(reading, "such a record once for each body above");
  nb_saved_count(reading, number, number);
  it->by = take_carrier(reading);
  it->along = nb_saved_vector(reading);
}

static void read_boundary(struct nb_state_reading *reading) {
  struct nb_saved_ring *it = &reading->saved->ring;
  it->is = true;
  it->held = nb_saved_one_of(reading, "held", "loose", NULL) == 0;
  it->pressing = nb_saved_one_of(reading, "pressed", "unpressed", NULL) == 0;
  it->radius = nb_saved_above_0(reading);
  it->shape = take_four(reading), it->stress = take_four(reading);
}

static void read_members(struct nb_state_reading *reading) {
  struct nb_saved *saved = reading->saved;
  while (!nb_saved_ended(reading) && !reading->bad) {
    const int member = (int)nb_saved_count(reading, 1, saved->body_count) - 1;
    if (saved->body_count == 0 || saved->bodies[member].member)
      nb_saved_expected(reading, "each body once");
    else
      saved->bodies[member].member = true;
    int *it = NB_SAVED_MORE(reading, ring.members, ring.member_count, NB_BODIES_MAX);
    if (it)
      *it = member;
  }
}

static void read_wall(struct nb_state_reading *reading) {
  struct nb_saved_wall *it = NB_SAVED_MORE(reading, walls, wall_count, NB_NAMED_MAX);
  if (!it)
    return;
  new_name(reading, it->name, reading->saved->walls, reading->saved->wall_count - 1, sizeof *it, "the name of a wall");
  it->material = take_material(reading);
  it->pivot = nb_saved_vector(reading), it->along = nb_saved_unit_vector(reading);
  it->h0 = nb_saved_finite(reading), it->h1 = nb_saved_finite(reading), it->h2 = nb_saved_finite(reading);
  it->velocity = nb_saved_vector(reading), it->spin = nb_saved_finite(reading);
  it->turn = nb_saved_vector(reading), it->angle = nb_saved_finite(reading);
}

const struct nb_state_record nb_state_records[] = {{"program", read_program, NB_ONCE},
                                                   {"page", read_page, NB_ONCE},
                                                   {"hash", read_hash, NB_ONCE},
                                                   {"stage", read_stage, NB_ONCE},
                                                   {"cycle", read_cycle, NB_ONCE},
                                                   {"time", read_time, NB_ONCE},
                                                   {"units", read_units, NB_ONCE},
                                                   {"gravity", read_gravity, NB_ONCE},
                                                   {"law", read_law, NB_MORE},
                                                   {"body", read_body, NB_MORE},
                                                   {"setting", read_setting, NB_ANY_TIMES},
                                                   {"inward", read_inward, NB_AT_MOST_ONCE},
                                                   {"rotation", read_rotation, NB_AT_MOST_ONCE},
                                                   {"cell", read_cell, NB_AT_MOST_ONCE},
                                                   {"centre", read_centre, NB_AT_MOST_ONCE},
                                                   {"carrier", read_carrier, NB_ANY_TIMES},
                                                   {"material", read_material, NB_ANY_TIMES},
                                                   {"pair", read_pair, NB_ANY_TIMES},
                                                   {"carried", read_carried, NB_ANY_TIMES},
                                                   {"boundary", read_boundary, NB_AT_MOST_ONCE},
                                                   {"members", read_members, NB_AT_MOST_ONCE},
                                                   {"wall", read_wall, NB_ANY_TIMES},
                                                   {"fields", nb_state_fields, NB_AT_MOST_ONCE},
                                                   {"contact", nb_state_contact, NB_ANY_TIMES},
                                                   {"normal", nb_state_normal, NB_ANY_TIMES},
                                                   {"shear", nb_state_shear, NB_ANY_TIMES},
                                                   {NULL, NULL, NB_ANY_TIMES}};
