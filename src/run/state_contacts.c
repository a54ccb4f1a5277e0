/* The records of a saved state that tell of contacts: their fields, and what laws remember of them.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "laws/law.h"
#include "state_reading.h"

static int take_wall(struct nb_state_reading *reading) {
  char name[NB_NAME_SIZE];
  nb_saved_name(reading, name, "the name of a wall");
  for (size_t w = 0; w < reading->saved->wall_count; w++)
    if (strcmp(reading->saved->walls[w].name, name) == 0)
      return (int)w;
  nb_saved_expected(reading, "the name of a wall that stands above");
  return 0;
}

void nb_state_fields(struct nb_state_reading *reading) {
  static const struct {
    enum nb_field field;
    const char *name;
  } known[] = {
#define ROW(field, name) {field, name},
      NB_SAVED_FIELDS(ROW)};
  enum { KNOWN = sizeof known / sizeof *known };
  for (reading->field_count = 0; !nb_saved_ended(reading) && !reading->bad;) {
    char name[NB_NAME_SIZE];
    size_t k = 0;
    nb_saved_name(reading, name, "the name of a field");
    while (k < KNOWN && strcmp(known[k].name, name) != 0)
      k++;
    for (int f = 0; f < reading->field_count && k < KNOWN; f++)
      if (reading->fields[f] == known[k].field)
        k = KNOWN;
    if (k == KNOWN)
      nb_saved_expected(reading, "the name of a contact's field, each once");
    else
      reading->fields[reading->field_count++] = known[k].field;
  }
  reading->taken = reading->end;
  if (reading->field_count < (int)KNOWN)
    nb_saved_expected(reading, "all fields of a contact");
}

void nb_state_contact(struct nb_state_reading *reading) {
  struct nb_saved_contact *it = NB_SAVED_MORE(reading, contacts, contact_count, NB_SAVED_MANY);
  const size_t bodies = reading->saved->body_count;
  if (!it)
    return;
  if (reading->field_count == 0)
    nb_saved_expected(reading, "a record `fields` before the first contact");
  it->a = (int)nb_saved_count(reading, 1, bodies) - 1;
  it->wall = nb_saved_one_of(reading, "body", "wall", NULL) == 1;
  it->b = it->wall ? take_wall(reading) : (int)nb_saved_count(reading, (unsigned long)it->a + 2, bodies) - 1;
  it->muted = nb_saved_one_of(reading, "heard", "muted", NULL) == 1;
  it->force = nb_saved_vector(reading);
  for (int f = 0; f < reading->field_count && !reading->bad; f++) {
    const enum nb_field field = reading->fields[f];
    const unsigned signs = NB_BIT(NB_CLOSING) | NB_BIT(NB_SLIP) | NB_BIT(NB_EX) | NB_BIT(NB_EY) | NB_BIT(NB_SHEAR) |
                           NB_BIT(NB_PUSH) | NB_BIT(NB_DRAG);
    it->field[field] = signs & NB_BIT(field) ? nb_saved_finite(reading) : nb_saved_not_negative(reading);
  }
}

/* What a law remembers of the contact above. */
static void read_memory(struct nb_state_reading *reading, bool shear) {
  struct nb_saved *saved = reading->saved;
  struct nb_saved_contact *it = saved->contact_count ? &saved->contacts[saved->contact_count - 1] : NULL;
  const struct nb_law *law = nb_law_find(shear ? "shear" : "normal", shear ? saved->shear : saved->normal);
  if (!it || !law || *(shear ? &it->shear : &it->normal)) {
    reading->taken = reading->line;
    nb_saved_expected(reading, "such a record once, below its contact");
    return;
  }
  *(shear ? &it->shear_at : &it->normal_at) = saved->memory_count;
  while (!nb_saved_ended(reading) && !reading->bad) {
    double *value = NB_SAVED_MORE(reading, memory, memory_count, NB_SAVED_MANY);
    if (value)
      *value = nb_saved_finite(reading);
    if (++*(shear ? &it->shear : &it->normal) > NB_MEMORY_MAX)
      nb_saved_expected(reading, "at most %d numbers", NB_MEMORY_MAX);
  }
  const int count = *(shear ? &it->shear : &it->normal);
  if (!reading->bad && !(law->valid ? law->valid(saved->memory + saved->memory_count - count, count, saved->pieces)
                                    : count == law->memory)) {
    reading->taken = reading->line;
    nb_saved_expected(reading, "numbers that the law can have remembered");
  }
}
void nb_state_normal(struct nb_state_reading *reading) { read_memory(reading, false); }
void nb_state_shear(struct nb_state_reading *reading) { read_memory(reading, true); }
