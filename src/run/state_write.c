/* A saved state as text. A record is a word and its fields, one a line, fields parted by one blank. Numbers are written by
 * %a, which reads back to the same bits; a value that no rule gives is `-`. The last line is the checksum of all before it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>

#include "input/text.h"
#include "save.h"
#include "state.h"

static void number(struct nb_text *out, double value) {
  if (isnan(value))
    nb_text_add(out, " -");
  else
    nb_text_add(out, " %a", value);
}

static void vector(struct nb_text *out, struct nb_vec value) { number(out, value.x), number(out, value.y); }

static void write_head(struct nb_text *out, const struct nb_saved *saved) {
  nb_text_add(out, "nineball state 1\nprogram %s\npage %s\nhash %016llx\n", saved->program, saved->page, saved->hash);
  for (size_t k = 0; k < saved->setting_count; k++)
    nb_text_add(out, "setting %s\n", saved->settings[k]);
  nb_text_add(out, "stage %s\ncycle %lu %lu\ntime", saved->stage, saved->cycle, saved->stage_cycle);
  number(out, saved->time), number(out, saved->step);
  nb_text_add(out, "\nunits %s\ngravity", saved->unitless ? "none" : "si");
  vector(out, saved->gravity);
  nb_text_add(out, "\nlaw normal %s\nlaw shear %s %d\n", saved->normal, saved->shear, saved->pieces);
}

static void four(struct nb_text *out, struct nb_tensor value) {
  number(out, value.xx), number(out, value.xy), number(out, value.yx), number(out, value.yy);
}

const char *const nb_saved_carrier_words[NB_CARRIERS] = {[NB_CARRIER_NONE] = "nothing",
                                                         [NB_CARRIER_CONTINUUM] = "continuum",
                                                         [NB_CARRIER_BOUNDARY] = "boundary",
                                                         [NB_CARRIER_CELL] = "cell",
                                                         [NB_CARRIER_BOX] = "box"};

/* What the scene does not have, or is as it always is, is not written. */
static void write_outside(struct nb_text *out, const struct nb_saved *saved) {
  const struct nb_saved_cell *cell = &saved->cell;
  if (saved->inward.strength != 0) {
    nb_text_add(out, "inward");
    number(out, saved->inward.strength), vector(out, saved->inward.to);
    nb_text_add(out, "\n");
  }
  if (!saved->turns)
    nb_text_add(out, "rotation off\n");
  if (cell->is) {
    nb_text_add(out, "cell");
    four(out, cell->h), four(out, cell->parting);
    nb_text_add(out, "\n");
  }
  if (saved->carried_count == 0)
    return;
  nb_text_add(out, "centre");
  vector(out, saved->centre);
  nb_text_add(out, "\n");
  for (int c = NB_CARRIER_NONE + 1; c < NB_CARRIERS; c++) {
    const struct nb_saved_carrier *it = &saved->carriers[c];
    nb_text_add(out, "carrier %s %s", nb_saved_carrier_words[c], it->literal ? "literal" : "apart");
    four(out, it->rate);
    nb_text_add(out, "%s", it->asked.per_cycle ? " cycle" : " time");
    four(out, tensor(it->asked.xx, it->asked.xy, it->asked.yx, it->asked.yy));
    nb_text_add(out, "\n");
  }
}

/* What carries each of them, and the boundary that some of them are. */
static void write_carried(struct nb_text *out, const struct nb_saved *saved) {
  const struct nb_saved_ring *ring = &saved->ring;
  for (size_t k = 0; k < saved->carried_count; k++) {
    nb_text_add(out, "carried %zu %s", k + 1, nb_saved_carrier_words[saved->carried[k].by]);
    vector(out, saved->carried[k].along);
    nb_text_add(out, "\n");
  }
  if (!ring->is)
    return;
  nb_text_add(out, "boundary %s %s", ring->held ? "held" : "loose", ring->pressing ? "pressed" : "unpressed");
  number(out, ring->radius), four(out, ring->shape), four(out, ring->stress);
  nb_text_add(out, "\nmembers");
  for (size_t k = 0; k < ring->member_count; k++)
    nb_text_add(out, " %d", ring->members[k] + 1);
  nb_text_add(out, "\n");
}

#define ROW(name, ...) it->name,
static void write_materials(struct nb_text *out, const struct nb_saved *saved) {
  for (size_t m = 0; m < saved->material_count; m++) {
    const struct nb_material *it = &saved->materials[m];
    const double values[] = {it->density, NB_PAIR_ROWS(ROW) it->young, it->poisson};
    nb_text_add(out, "material %s", it->name);
    for (size_t k = 0; k < sizeof values / sizeof *values; k++)
      number(out, values[k]);
    nb_text_add(out, "\n");
  }
  for (size_t r = 0; r < saved->rule_count; r++) {
    const struct nb_pair_rule *it = &saved->rules[r];
    nb_text_add(out, "pair %s %s", saved->materials[it->a].name, saved->materials[it->b].name);
    const double values[] = {NB_PAIR_ROWS(ROW)};
    for (size_t k = 0; k < sizeof values / sizeof *values; k++)
      number(out, values[k]);
    nb_text_add(out, "\n");
  }
}
#undef ROW

static void write_bodies(struct nb_text *out, const struct nb_saved *saved) {
  static const char *const shapes[] = {[NB_DISC] = "disc", [NB_SPHERE] = "sphere"};
  static const char *const mobilities[] = {[NB_FREE] = "free", [NB_FIXED] = "fixed", [NB_GONE] = "gone"};
  for (size_t k = 0; k < saved->body_count; k++) {
    const struct nb_saved_body *it = &saved->bodies[k];
    nb_text_add(out, "body %zu %s %s %s", k + 1, shapes[it->shape], saved->materials[it->material].name,
                mobilities[it->mobility]);
    number(out, it->radius), vector(out, it->position), vector(out, it->velocity);
    number(out, it->spin), number(out, it->angle);
    nb_text_add(out, "\n");
  }
}

static void write_walls(struct nb_text *out, const struct nb_saved *saved) {
  for (size_t w = 0; w < saved->wall_count; w++) {
    const struct nb_saved_wall *it = &saved->walls[w];
    nb_text_add(out, "wall %s %s", it->name, saved->materials[it->material].name);
    vector(out, it->pivot), vector(out, it->along);
    number(out, it->h0), number(out, it->h1), number(out, it->h2);
    vector(out, it->velocity), number(out, it->spin), vector(out, it->turn), number(out, it->angle);
    nb_text_add(out, "\n");
  }
}

static void write_memory(struct nb_text *out, const char *word, const double *memory, int doubles) {
  if (doubles == 0)
    return;
  nb_text_add(out, "%s", word);
  for (int m = 0; m < doubles; m++)
    number(out, memory[m]);
  nb_text_add(out, "\n");
}

static void write_contacts(struct nb_text *out, const struct nb_saved *saved) {
#define NAMED(field, name) " " name
  if (saved->contact_count)
    nb_text_add(out, "fields" NB_SAVED_FIELDS(NAMED) "\n");
  for (size_t c = 0; c < saved->contact_count; c++) {
    const struct nb_saved_contact *it = &saved->contacts[c];
    if (it->wall)
      nb_text_add(out, "contact %d wall %s", it->a + 1, saved->walls[it->b].name);
    else
      nb_text_add(out, "contact %d body %d", it->a + 1, it->b + 1);
    nb_text_add(out, "%s", it->muted ? " muted" : " heard");
    vector(out, it->force);
#define WRITTEN(which, name) number(out, it->field[which]);
    NB_SAVED_FIELDS(WRITTEN)
    nb_text_add(out, "\n");
    write_memory(out, "normal", saved->memory + it->normal_at, it->normal);
    write_memory(out, "shear", saved->memory + it->shear_at, it->shear);
  }
}

char *nb_saved_text(const struct nb_saved *saved, size_t *size) {
  struct nb_text text = {0};
  write_head(&text, saved);
  write_outside(&text, saved);
  write_materials(&text, saved);
  write_bodies(&text, saved);
  write_carried(&text, saved);
  write_walls(&text, saved);
  write_contacts(&text, saved);
  if (!text.failed)
    nb_text_add(&text, "end %016llx\n", nb_hash(NB_HASH_BEGIN, text.at, text.length));
  *size = text.length;
  return text.at;
}

/* What has been written must be what reading accepts: else the next page would find a state that it cannot use. */
static enum nb_status check(const char *path, const char *text, size_t size, struct nb_error *error) {
  struct nb_saved again;
  const enum nb_status status = nb_saved_read_text(&again, path, text, size, error);
  nb_saved_free(&again);
  return status;
}

enum nb_status nb_saved_write(const struct nb_saved *saved, const char *path, struct nb_error *error) {
  struct nb_save file;
  size_t size = 0;
  char *text = nb_saved_text(saved, &size);
  if (!text)
    return nb_error_memory(error);
  enum nb_status status = check(path, text, size, error);
  if (!status)
    status = nb_save_begin(&file, path, error);
  if (!status) {
    fwrite(text, 1, size, file.file); /* nb_save_end tells whether it could be written */
    status = nb_save_end(&file, error);
  }
  free(text);
  return status;
}
