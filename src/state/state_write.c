/* A saved state as text. A record is a word and its fields, one a line, fields parted by one blank. Numbers are written by
 * %a, which reads back to the same bits; a value that no rule gives is `-`. The last line is the checksum of all before it.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#define _POSIX_C_SOURCE 200809L

#include <stdlib.h>

#include "save.h"
#include "state.h"

static void number(FILE *out, double value) {
  if (isnan(value))
    fputs(" -", out);
  else
    fprintf(out, " %a", value);
}

static void vector(FILE *out, struct nb_vec value) { number(out, value.x), number(out, value.y); }

static void write_head(FILE *out, const struct nb_saved *saved) {
  fprintf(out, "nineball state 1\nprogram %s\npage %s\nhash %016llx\n", saved->program, saved->page, saved->hash);
  for (size_t k = 0; k < saved->setting_count; k++)
    fprintf(out, "setting %s\n", saved->settings[k]);
  fprintf(out, "stage %s\ncycle %lu %lu\ntime", saved->stage, saved->cycle, saved->stage_cycle);
  number(out, saved->time), number(out, saved->step);
  fprintf(out, "\nunits %s\ngravity", saved->unitless ? "none" : "si");
  vector(out, saved->gravity);
  fprintf(out, "\nlaw normal %s\nlaw shear %s %d\n", saved->normal, saved->shear, saved->pieces);
}

static void four(FILE *out, struct nb_tensor value) {
  number(out, value.xx), number(out, value.xy), number(out, value.yx), number(out, value.yy);
}

const char *const nb_saved_carrier_words[NB_CARRIERS] = {[NB_CARRIER_NONE] = "nothing",
                                                         [NB_CARRIER_CONTINUUM] = "continuum",
                                                         [NB_CARRIER_BOUNDARY] = "boundary",
                                                         [NB_CARRIER_CELL] = "cell",
                                                         [NB_CARRIER_BOX] = "box"};

/* What the scene does not have, or is as it always is, is not written. */
static void write_outside(FILE *out, const struct nb_saved *saved) {
  const struct nb_saved_cell *cell = &saved->cell;
  if (saved->inward.strength != 0) {
    fputs("inward", out);
    number(out, saved->inward.strength), vector(out, saved->inward.to);
    fputc('\n', out);
  }
  if (!saved->turns)
    fputs("rotation off\n", out);
  if (cell->is) {
    fputs("cell", out);
    four(out, cell->h), four(out, cell->parting);
    fputc('\n', out);
  }
  if (saved->carried_count == 0)
    return;
  fputs("centre", out);
  vector(out, saved->centre);
  fputc('\n', out);
  for (int c = NB_CARRIER_NONE + 1; c < NB_CARRIERS; c++) {
    const struct nb_saved_carrier *it = &saved->carriers[c];
    fprintf(out, "carrier %s %s", nb_saved_carrier_words[c], it->literal ? "literal" : "apart");
    four(out, it->rate);
    fputs(it->asked.per_cycle ? " cycle" : " time", out);
    four(out, tensor(it->asked.xx, it->asked.xy, it->asked.yx, it->asked.yy));
    fputc('\n', out);
  }
}

/* What carries each of them, and the boundary that some of them are. */
static void write_carried(FILE *out, const struct nb_saved *saved) {
  const struct nb_saved_ring *ring = &saved->ring;
  for (size_t k = 0; k < saved->carried_count; k++) {
    fprintf(out, "carried %zu %s", k + 1, nb_saved_carrier_words[saved->carried[k].by]);
    vector(out, saved->carried[k].along);
    fputc('\n', out);
  }
  if (!ring->is)
    return;
  fprintf(out, "boundary %s %s", ring->held ? "held" : "loose", ring->pressing ? "pressed" : "unpressed");
  number(out, ring->radius), four(out, ring->shape), four(out, ring->stress);
  fputs("\nmembers", out);
  for (size_t k = 0; k < ring->member_count; k++)
    fprintf(out, " %d", ring->members[k] + 1);
  fputc('\n', out);
}

#define ROW(name, ...) it->name,
static void write_materials(FILE *out, const struct nb_saved *saved) {
  for (size_t m = 0; m < saved->material_count; m++) {
    const struct nb_material *it = &saved->materials[m];
    const double values[] = {it->density, NB_PAIR_ROWS(ROW) it->young, it->poisson};
    fprintf(out, "material %s", it->name);
    for (size_t k = 0; k < sizeof values / sizeof *values; k++)
      number(out, values[k]);
    fputc('\n', out);
  }
  for (size_t r = 0; r < saved->rule_count; r++) {
    const struct nb_pair_rule *it = &saved->rules[r];
    fprintf(out, "pair %s %s", saved->materials[it->a].name, saved->materials[it->b].name);
    const double values[] = {NB_PAIR_ROWS(ROW)};
    for (size_t k = 0; k < sizeof values / sizeof *values; k++)
      number(out, values[k]);
    fputc('\n', out);
  }
}
#undef ROW

static void write_bodies(FILE *out, const struct nb_saved *saved) {
  static const char *const shapes[] = {[NB_DISC] = "disc", [NB_SPHERE] = "sphere"};
  static const char *const mobilities[] = {[NB_FREE] = "free", [NB_FIXED] = "fixed", [NB_GONE] = "gone"};
  for (size_t k = 0; k < saved->body_count; k++) {
    const struct nb_saved_body *it = &saved->bodies[k];
    fprintf(out, "body %zu %s %s %s", k + 1, shapes[it->shape], saved->materials[it->material].name,
            mobilities[it->mobility]);
    number(out, it->radius), vector(out, it->position), vector(out, it->velocity);
    number(out, it->spin), number(out, it->angle);
    fputc('\n', out);
  }
}

static void write_walls(FILE *out, const struct nb_saved *saved) {
  for (size_t w = 0; w < saved->wall_count; w++) {
    const struct nb_saved_wall *it = &saved->walls[w];
    fprintf(out, "wall %s %s", it->name, saved->materials[it->material].name);
    vector(out, it->pivot), vector(out, it->along);
    number(out, it->h0), number(out, it->h1), number(out, it->h2);
    vector(out, it->velocity), number(out, it->spin), vector(out, it->turn), number(out, it->angle);
    fputc('\n', out);
  }
}

static void write_memory(FILE *out, const char *word, const double *memory, int doubles) {
  if (doubles == 0)
    return;
  fputs(word, out);
  for (int m = 0; m < doubles; m++)
    number(out, memory[m]);
  fputc('\n', out);
}

static void write_contacts(FILE *out, const struct nb_saved *saved) {
#define NAMED(field, name) " " name
  if (saved->contact_count)
    fputs("fields" NB_SAVED_FIELDS(NAMED) "\n", out);
  for (size_t c = 0; c < saved->contact_count; c++) {
    const struct nb_saved_contact *it = &saved->contacts[c];
    if (it->wall)
      fprintf(out, "contact %d wall %s", it->a + 1, saved->walls[it->b].name);
    else
      fprintf(out, "contact %d body %d", it->a + 1, it->b + 1);
    fputs(it->muted ? " muted" : " heard", out);
    vector(out, it->force);
#define WRITTEN(which, name) number(out, it->field[which]);
    NB_SAVED_FIELDS(WRITTEN)
    fputc('\n', out);
    write_memory(out, "normal", saved->memory + it->normal_at, it->normal);
    write_memory(out, "shear", saved->memory + it->shear_at, it->shear);
  }
}

char *nb_saved_text(const struct nb_saved *saved, size_t *size) {
  char *text = NULL;
  FILE *out = open_memstream(&text, size);
  if (!out)
    return NULL;
  write_head(out, saved);
  write_outside(out, saved);
  write_materials(out, saved);
  write_bodies(out, saved);
  write_carried(out, saved);
  write_walls(out, saved);
  write_contacts(out, saved);
  bool whole = fflush(out) == 0; /* which makes the text and its size known */
  if (whole)
    fprintf(out, "end %016llx\n", nb_hash(NB_HASH_BEGIN, text, *size));
  whole = !ferror(out) && whole;
  if (fclose(out) == 0 && whole)
    return text;
  free(text);
  return NULL;
}

enum nb_status nb_saved_write(const struct nb_saved *saved, const char *path, struct nb_error *error) {
  struct nb_save file;
  size_t size = 0;
  char *text = nb_saved_text(saved, &size);
  if (!text)
    return nb_error_set(error, NB_BROKEN, "out of memory for %s", path);
  enum nb_status status = nb_save_begin(&file, path, error);
  if (!status) {
    fwrite(text, 1, size, file.file); /* nb_save_end tells whether it could be written */
    status = nb_save_end(&file, error);
  }
  free(text);
  return status;
}
