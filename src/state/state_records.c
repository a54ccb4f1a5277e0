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

static int take_wall(struct nb_state_reading *reading) {
  char name[NB_NAME_SIZE];
  nb_saved_name(reading, name, "the name of a wall");
  for (size_t w = 0; w < reading->saved->wall_count; w++)
    if (strcmp(reading->saved->walls[w].name, name) == 0)
      return (int)w;
  nb_saved_expected(reading, "the name of a wall that stands above");
  return 0;
}

/* One more at the end of an array of the state; NULL, and said, when there is no memory. */
static void *more(struct nb_state_reading *reading, void **array, size_t *count, size_t element) {
  void *room = nb_room(*array, *count, 1, element);
  if (!room) {
    reading->bad = true;
    nb_error_memory(reading->error);
    return NULL;
  }
  *array = room;
  return memset((char *)room + element * (*count)++, 0, element);
}
#define MORE(reading, things, count)                                                                                   \
  more(reading, (void **)&(reading)->saved->things, &(reading)->saved->count, sizeof *(reading)->saved->things)

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
  char(*setting)[2 * NB_NAME_SIZE] = MORE(reading, settings, setting_count);
  if (setting)
    nb_saved_rest(reading, *setting, sizeof *setting);
}

static void read_cycle(struct nb_state_reading *reading) {
  reading->saved->cycle = nb_saved_count(reading, 0, 1000000000000UL);
  reading->saved->stage_cycle = nb_saved_count(reading, 0, reading->saved->cycle);
}

static void read_time(struct nb_state_reading *reading) {
  reading->saved->time = nb_saved_finite(reading);
  reading->saved->step = nb_saved_finite(reading);
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
  it->h = take_four(reading), it->parting = take_four(reading);
}

static void read_centre(struct nb_state_reading *reading) { reading->saved->centre = nb_saved_vector(reading); }

static void read_carrier(struct nb_state_reading *reading) {
  struct nb_saved_carrier *it = &reading->saved->carriers[take_carrier(reading)];
  it->literal = nb_saved_one_of(reading, "apart", "literal", NULL) == 1;
  it->rate = take_four(reading);
  it->asked.per_cycle = nb_saved_one_of(reading, "time", "cycle", NULL) == 1;
  const struct nb_tensor asked = take_four(reading);
  it->asked.xx = asked.xx, it->asked.xy = asked.xy, it->asked.yx = asked.yx, it->asked.yy = asked.yy;
}

static void read_law(struct nb_state_reading *reading) {
  const bool shear = nb_saved_one_of(reading, "normal", "shear", NULL) == 1;
  char *name = shear ? reading->saved->shear : reading->saved->normal;
  nb_saved_name(reading, name, "the name of a law");
  if (!reading->bad && !nb_law_find(shear ? "shear" : "normal", name))
    nb_saved_expected(reading, "a law of this program");
  if (shear)
    reading->saved->pieces = (int)nb_saved_count(reading, 0, NB_PIECES_MAX);
}

static void read_material(struct nb_state_reading *reading) {
  struct nb_material *it = MORE(reading, materials, material_count);
  if (!it)
    return;
  nb_saved_name(reading, it->name, "the name of a material");
  it->density = nb_saved_finite(reading);
#define ROW(name, ...) it->name = nb_saved_finite(reading);
  NB_PAIR_ROWS(ROW)
#undef ROW
  it->young = nb_saved_number(reading), it->poisson = nb_saved_finite(reading);
}

static void read_pair(struct nb_state_reading *reading) {
  struct nb_pair_rule *it = MORE(reading, rules, rule_count);
  if (!it)
    return;
  it->a = take_material(reading), it->b = take_material(reading);
#define ROW(name, ...) it->name = nb_saved_number(reading);
  NB_PAIR_ROWS(ROW)
#undef ROW
}

static void read_body(struct nb_state_reading *reading) {
  struct nb_saved_body *it = MORE(reading, bodies, body_count);
  const size_t number = reading->saved->body_count;
  if (!it)
    return;
  nb_saved_count(reading, number, number);
  it->shape = nb_saved_one_of(reading, "disc", "sphere", NULL) ? NB_SPHERE : NB_DISC;
  it->material = take_material(reading);
  it->mobility = (enum nb_mobility)nb_saved_one_of(reading, "free", "fixed", "gone");
  it->radius = nb_saved_finite(reading);
  if (!(it->radius > 0))
    nb_saved_expected(reading, "a radius above 0");
  it->position = nb_saved_vector(reading), it->velocity = nb_saved_vector(reading);
  it->spin = nb_saved_finite(reading), it->angle = nb_saved_finite(reading);
}

static void read_carried(struct nb_state_reading *reading) {
  struct nb_saved_carried *it = MORE(reading, carried, carried_count);
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
  it->radius = nb_saved_finite(reading);
  it->shape = take_four(reading), it->stress = take_four(reading);
}

static void read_members(struct nb_state_reading *reading) {
  struct nb_saved *saved = reading->saved;
  while (!nb_saved_ended(reading) && !reading->bad) {
    const int member = (int)nb_saved_count(reading, 1, saved->body_count) - 1;
    for (size_t k = 0; k < saved->ring.member_count; k++)
      if (saved->ring.members[k] == member)
        nb_saved_expected(reading, "each body once");
    int *it = MORE(reading, ring.members, ring.member_count);
    if (it)
      *it = member;
  }
}

static void read_wall(struct nb_state_reading *reading) {
  struct nb_saved_wall *it = MORE(reading, walls, wall_count);
  if (!it)
    return;
  nb_saved_name(reading, it->name, "the name of a wall");
  it->material = take_material(reading);
  it->pivot = nb_saved_vector(reading), it->along = nb_saved_vector(reading);
  it->h0 = nb_saved_finite(reading), it->h1 = nb_saved_finite(reading), it->h2 = nb_saved_finite(reading);
  it->velocity = nb_saved_vector(reading), it->spin = nb_saved_finite(reading);
  it->turn = nb_saved_vector(reading), it->angle = nb_saved_finite(reading);
}

static void read_fields(struct nb_state_reading *reading) {
  static const struct {
    enum nb_field field;
    const char *name;
  } known[] = {
#define ROW(field, name) {field, name},
      NB_SAVED_FIELDS(ROW)};
  for (reading->field_count = 0; !nb_saved_ended(reading) && !reading->bad;) {
    char name[NB_NAME_SIZE];
    size_t k = 0;
    nb_saved_name(reading, name, "the name of a field");
    while (k < sizeof known / sizeof *known && strcmp(known[k].name, name) != 0)
      k++;
    if (k == sizeof known / sizeof *known || reading->field_count == NB_FIELDS)
      nb_saved_expected(reading, "the name of a contact's field");
    else
      reading->fields[reading->field_count++] = known[k].field;
  }
}

static void read_contact(struct nb_state_reading *reading) {
  struct nb_saved_contact *it = MORE(reading, contacts, contact_count);
  const size_t bodies = reading->saved->body_count;
  if (!it)
    return;
  it->a = (int)nb_saved_count(reading, 1, bodies) - 1;
  it->wall = nb_saved_one_of(reading, "body", "wall", NULL) == 1;
  it->b = it->wall ? take_wall(reading) : (int)nb_saved_count(reading, (unsigned long)it->a + 2, bodies) - 1;
  it->muted = nb_saved_one_of(reading, "heard", "muted", NULL) == 1;
  it->force = nb_saved_vector(reading);
  for (int f = 0; f < reading->field_count && !reading->bad; f++)
    it->field[reading->fields[f]] = nb_saved_finite(reading);
}

/* What a law remembers of the contact above. */
static void read_memory(struct nb_state_reading *reading, bool shear) {
  struct nb_saved *saved = reading->saved;
  struct nb_saved_contact *it = saved->contact_count ? &saved->contacts[saved->contact_count - 1] : NULL;
  if (!it || *(shear ? &it->shear : &it->normal)) {
    reading->taken = reading->line;
    nb_saved_expected(reading, "such a record once, below its contact");
    return;
  }
  *(shear ? &it->shear_at : &it->normal_at) = saved->memory_count;
  while (!nb_saved_ended(reading) && !reading->bad) {
    double *value = MORE(reading, memory, memory_count);
    if (value)
      *value = nb_saved_finite(reading);
    if (++*(shear ? &it->shear : &it->normal) > NB_MEMORY_MAX)
      nb_saved_expected(reading, "at most %d numbers", NB_MEMORY_MAX);
  }
}
static void read_normal(struct nb_state_reading *reading) { read_memory(reading, false); }
static void read_shear(struct nb_state_reading *reading) { read_memory(reading, true); }

static const struct {
  const char *word;
  nb_state_record *read;
} records[] = {
    {"program", read_program}, {"page", read_page},       {"hash", read_hash},         {"setting", read_setting},
    {"stage", read_stage},     {"cycle", read_cycle},     {"time", read_time},         {"units", read_units},
    {"gravity", read_gravity}, {"inward", read_inward},   {"rotation", read_rotation}, {"cell", read_cell},
    {"centre", read_centre},   {"carrier", read_carrier}, {"law", read_law},           {"material", read_material},
    {"pair", read_pair},       {"body", read_body},       {"carried", read_carried},   {"boundary", read_boundary},
    {"members", read_members}, {"wall", read_wall},       {"fields", read_fields},     {"contact", read_contact},
    {"normal", read_normal},   {"shear", read_shear}};
enum { RECORDS = sizeof records / sizeof *records };

nb_state_record *nb_state_record_of(const char *word) {
  for (size_t k = 0; k < RECORDS; k++)
    if (strcmp(records[k].word, word) == 0)
      return records[k].read;
  return NULL;
}
