/* Writes and reads a saved state. Each record is a line: a word and its fields, separated by one space. The last line
 * is the checksum of all other lines. Numbers are written by %a and read back to the same bits.
 *
 * One function per kind of record both writes and reads the fields of a record in order. It writes them if there is an
 * output text; otherwise it reads and checks them. A file that is truncated or changed is refused. Every other
 * deviation from docs/STATE.md is an error with file, line, column and what was expected. A new record needs a row in
 * the table below, and one in docs/STATE.md.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "state_file.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "core/clean.h"
#include "laws/law.h"
#include "reader.h"
#include "text.h"

/* Tolerated error of the length of a unit vector: rounding errors accumulate while a wall rotates. */
static const double unit_error = 1e-9;

enum { CONTACTS_MAX = 1 << 30 };

struct stream {
  struct nb_saved *saved;
  struct nb_text *out; /* NULL: the state is read */
  size_t k;            /* index of the record among those of its kind, while writing */
  /* While reading: */
  const char *path;
  const char *line, *end; /* beginning and end of the current record */
  const char *at, *taken; /* next character; beginning of the last field, for messages */
  size_t number;          /* number of the line */
  unsigned seen, sources; /* sets of records, and of sources of imposed motion, that have been read */
  struct nb_error *error;
  bool fields, bad; /* the names of a contact's fields have been read; there was an error */
  bool members;     /* a record `members`, which may be empty, was read */
};

void nb_saved_free(struct nb_saved *saved) {
  free(saved->settings), free(saved->materials), free(saved->rules), free(saved->particles), free(saved->walls);
  free(saved->contacts), free(saved->history), free(saved->imposed), free(saved->ring.members);
  nb_store_free(&saved->store);
  *saved = (struct nb_saved){0};
}

enum nb_status nb_saved_setting(struct nb_saved *saved, const char *text, struct nb_error *error) {
  if (strlen(text) >= sizeof *saved->settings)
    return nb_error_set(error, NB_BAD_USE, "a state keeps settings shorter than %zu bytes, found `%.40s…`",
                        sizeof *saved->settings, text);
  char(*more)[2 * NB_NAME_SIZE] = NB_ARRAY_APPEND(saved->settings, saved->setting_count);
  if (!more)
    return nb_error_memory(error);
  strcpy(*more, text);
  return NB_OK;
}

/* ---- fields ---- */

/* Sets the error "PATH:7:12: expected a number, found `x`" at the last field, for the first mistake in the file. */
static void __attribute__((format(printf, 2, 3))) expected(struct stream *stream, const char *format, ...) {
  char what[160];
  va_list list;
  if (stream->bad || stream->out) /* while writing there are no errors: run/state.c reads the text again */
    return;
  stream->bad = true;
  va_start(list, format);
  vsnprintf(what, sizeof what, format, list);
  va_end(list);
  const char *from = stream->taken < stream->end ? stream->taken : stream->end;
  const int column = (int)(from - stream->line) + 1, length = (int)strcspn(from, " \n");
  if (length > 0)
    nb_error_set(stream->error, NB_BAD_USE, "%.150s:%zu:%d: expected %s, found `%.*s`", stream->path, stream->number,
                 column, what, length < 60 ? length : 60, from);
  else
    nb_error_set(stream->error, NB_BAD_USE, "%.150s:%zu:%d: expected %s, found the end of the line", stream->path,
                 stream->number, column, what);
}

static bool ended(const struct stream *stream) { return stream->at >= stream->end; }

/* Takes the next field. If there is none, `field` is empty and an error is set. */
static void take_field(struct stream *stream, char field[NB_STATE_FIELD], const char *what) {
  field[0] = 0;
  stream->taken = stream->at;
  const size_t length = ended(stream) ? 0 : strcspn(stream->at, " \n");
  if (length == 0 || length >= NB_STATE_FIELD) {
    expected(stream, "%s", what);
    return;
  }
  memcpy(field, stream->at, length);
  field[length] = 0;
  stream->at += length;
  if (!ended(stream))
    stream->at++;
}

/* After an error whole_number returns `low`, and the functions for words and names return the index 0. */

enum range { FINITE, FROM_0, ABOVE_0, FROM_0_OR_INFINITE, FROM_0_OR_UNDEFINED /* `-` in the file, NAN */ };

static void number(struct stream *stream, double *value, enum range range) {
  char field[NB_STATE_FIELD], *end = field;
  if (stream->out && isnan(*value)) {
    nb_text_add(stream->out, " -");
  } else if (stream->out) {
    nb_text_add(stream->out, " %a", *value);
  } else {
    take_field(stream, field, "a number");
    const bool given = strcmp(field, "-") != 0;
    *value = given ? strtod(field, &end) : NAN;
    if (given ? *end || isnan(*value) : range != FROM_0_OR_UNDEFINED)
      expected(stream, "a number");
    if (isinf(*value) && range != FROM_0_OR_INFINITE)
      expected(stream, "a finite number");
    if (range == ABOVE_0 && !(*value > 0))
      expected(stream, "a number above 0");
    if (range != FINITE && *value < 0)
      expected(stream, "0 or more");
  }
}

static void vector(struct stream *stream, struct nb_vec *value) {
  number(stream, &value->x, FINITE), number(stream, &value->y, FINITE);
}

static void four_numbers(struct stream *stream, double *xx, double *xy, double *yx, double *yy) {
  number(stream, xx, FINITE), number(stream, xy, FINITE), number(stream, yx, FINITE), number(stream, yy, FINITE);
}
static void tensor_of(struct stream *stream, struct nb_tensor *value) {
  four_numbers(stream, &value->xx, &value->xy, &value->yx, &value->yy);
}

/* Functions with a parameter `now` write it, or return the value that they read. */
static unsigned long whole_number(struct stream *stream, unsigned long now, unsigned long low, unsigned long high) {
  char field[NB_STATE_FIELD], *end;
  if (stream->out)
    return nb_text_add(stream->out, " %lu", now), now;
  take_field(stream, field, "a whole number");
  const unsigned long value = strtoul(field, &end, 10);
  if (high < low) /* a field for the number of a particle, but the file has no such particle above */
    expected(stream, "a record `body %lu` above", low);
  else if (*end || field[0] < '0' || value < low || value > high)
    expected(stream, "a whole number from %lu to %lu", low, high);
  return stream->bad ? low : value;
}

/* A list of words, for a field that is one of them. */
#define WORDS(...) ((const char *const[]){__VA_ARGS__, NULL})
static int one_of(struct stream *stream, int now, const char *const words[]) {
  char field[NB_STATE_FIELD], list[NB_STATE_FIELD] = "";
  if (stream->out)
    return nb_text_add(stream->out, " %s", words[now]), now;
  for (int w = 0; words[w]; w++)
    nb_append_item(list, sizeof list, words[w], !words[w + 1]);
  take_field(stream, field, list);
  for (int w = 0; words[w]; w++)
    if (strcmp(field, words[w]) == 0)
      return w;
  expected(stream, "%s", list);
  return 0;
}
static bool one_of_two(struct stream *stream, bool now, const char *no, const char *yes) {
  return one_of(stream, now, WORDS(no, yes)) == 1;
}

static void name(struct stream *stream, char own[NB_NAME_SIZE], const char *what) {
  char field[NB_STATE_FIELD];
  if (stream->out) {
    nb_text_add(stream->out, " %s", own);
    return;
  }
  take_field(stream, field, what);
  if (strlen(field) >= NB_NAME_SIZE)
    expected(stream, "%s", what);
  snprintf(own, NB_NAME_SIZE, "%.*s", NB_NAME_SIZE - 1, field);
}

/* Index of a name in an array of structures that begin with their name. */
static int known_name(struct stream *stream, int now, const void *things, size_t count, size_t size, const char *what) {
  char field[NB_NAME_SIZE] = "";
  if (stream->out)
    memcpy(field, (const char *)things + (size_t)now * size, sizeof field);
  name(stream, field, what);
  const int found = stream->out ? now : nb_find(things, count, size, field);
  if (found < 0)
    expected(stream, "%s that stands above", what);
  return found < 0 ? 0 : found;
}

/* The name of the last of `count` structures, which must differ from all others. */
static void new_name(struct stream *stream, char *own, const void *things, size_t count, size_t size,
                     const char *what) {
  name(stream, own, what);
  if (!stream->out && !nb_is_name(own))
    expected(stream, "%s", what);
  if (!stream->out && nb_find(things, count - 1, size, own) >= 0)
    expected(stream, "%s that no record above has", what);
}

/* The rest of the line, with spaces. */
static void rest_of_line(struct stream *stream, char *text, size_t size) {
  if (stream->out) {
    nb_text_add(stream->out, " %s", text);
    return;
  }
  stream->taken = stream->at;
  const size_t length = ended(stream) ? 0 : (size_t)(stream->end - stream->at);
  if (length == 0 || length >= size)
    expected(stream, "a text shorter than %zu bytes", size);
  snprintf(text, size, "%.*s", (int)(length < size ? length : 0), stream->at);
  stream->at = stream->end;
}

/* Appends an element to an array; NULL with an error if there are too many or no memory. */
static void *append(struct stream *stream, void *array, size_t *count, size_t size, size_t most) {
  if (*count >= most) {
    expected(stream, "at most %zu such records", most);
    return NULL;
  }
  void *element = nb_array_add(array, count, size);
  if (!element && !stream->bad) {
    stream->bad = true;
    nb_error_memory(stream->error);
  }
  return element;
}
/* The element to write, or a new one to read. */
#define ELEMENT(stream, things, count, most)                                                                           \
  ((stream)->out                                                                                                       \
       ? &(stream)->saved->things[(stream)->k]                                                                         \
       : append(stream, &(stream)->saved->things, &(stream)->saved->count, sizeof *(stream)->saved->things, most))

/* ---- records ---- */

static void program(struct stream *stream) { name(stream, stream->saved->program, "the version of the program"); }
static void page(struct stream *stream) { rest_of_line(stream, stream->saved->page, sizeof stream->saved->page); }
static void stage(struct stream *stream) { name(stream, stream->saved->stage, "the name of a stage"); }
static void gravity(struct stream *stream) { vector(stream, &stream->saved->gravity); }
static void centre(struct stream *stream) { vector(stream, &stream->saved->centre); }

static void hash(struct stream *stream) {
  char field[NB_STATE_FIELD], *end;
  if (stream->out) {
    nb_text_add(stream->out, " %016llx", stream->saved->hash);
    return;
  }
  take_field(stream, field, "16 hexadecimal digits");
  stream->saved->hash = strtoull(field, &end, 16);
  if (*end || strlen(field) != 16)
    expected(stream, "16 hexadecimal digits");
}

static void setting(struct stream *stream) {
  char(*it)[2 * NB_NAME_SIZE] = ELEMENT(stream, settings, setting_count, NB_NAMED_MAX);
  if (it)
    rest_of_line(stream, *it, sizeof *it);
}

static void cycle(struct stream *stream) {
  struct nb_saved *saved = stream->saved;
  saved->cycle = whole_number(stream, saved->cycle, 1, 1000000000000UL);
  saved->stage_cycle = whole_number(stream, saved->stage_cycle, 1, saved->cycle);
}

static void time_and_step(struct stream *stream) {
  number(stream, &stream->saved->time, ABOVE_0), number(stream, &stream->saved->step, ABOVE_0);
}

static void units(struct stream *stream) {
  stream->saved->unitless = one_of_two(stream, stream->saved->unitless, "si", "none");
}

static void law(struct stream *stream) {
  struct nb_saved *saved = stream->saved;
  const bool shear = one_of_two(stream, stream->k == 1, "normal", "shear");
  char *own = shear ? saved->shear : saved->normal;
  if (own[0])
    expected(stream, "such a record once");
  name(stream, own, "the name of a law");
  if (!nb_law_find(shear ? "shear" : "normal", own))
    expected(stream, "a law of this program");
  if (shear)
    saved->pieces = (int)whole_number(stream, (unsigned long)saved->pieces, 0, NB_PIECES_MAX);
}

static void central(struct stream *stream) {
  number(stream, &stream->saved->central.acceleration, FINITE), vector(stream, &stream->saved->central.point);
}

static void impact(struct stream *stream) {
  stream->saved->impact.is = true;
  number(stream, &stream->saved->impact.contact_time, FROM_0);
}

static void rotation(struct stream *stream) {
  stream->saved->rotates = one_of_two(stream, stream->saved->rotates, "off", "on");
}

static void cell(struct stream *stream) {
  struct nb_saved_cell *it = &stream->saved->cell;
  it->is = true;
  tensor_of(stream, &it->h);
  if (!(it->h.xx * it->h.yy - it->h.xy * it->h.yx > 0))
    expected(stream, "a cell with an area above 0");
  tensor_of(stream, &it->image_velocity);
}

static enum nb_affine_source affine_source_of(struct stream *stream, enum nb_affine_source now) {
  static const char *const words[NB_AFFINE_SOURCES + 1] = {[NB_AFFINE_NONE] = "nothing",
                                                           [NB_AFFINE_FREE] = "continuum",
                                                           [NB_AFFINE_BOUNDARY] = "boundary",
                                                           [NB_AFFINE_CELL] = "cell",
                                                           [NB_AFFINE_BOX] = "box"};
  return (enum nb_affine_source)one_of(stream, (int)now, words);
}

static void affine_source(struct stream *stream) {
  const enum nb_affine_source which =
      affine_source_of(stream, stream->out ? (enum nb_affine_source)(stream->k + 1) : NB_AFFINE_NONE);
  struct nb_saved_affine *it = &stream->saved->sources[which];
  if (stream->sources & 1U << which)
    expected(stream, "such a record once for each source of imposed motion");
  stream->sources |= 1U << which;
  const int coding = one_of(stream, it->accumulated + it->twice, WORDS("apart", "literal", "literal-twice"));
  it->accumulated = coding > 0, it->twice = coding > 1;
  tensor_of(stream, &it->rate);
  it->requested.per_cycle = one_of_two(stream, it->requested.per_cycle, "time", "cycle");
  four_numbers(stream, &it->requested.xx, &it->requested.xy, &it->requested.yx, &it->requested.yy);
}

static int material_of(struct stream *stream, int now) {
  const struct nb_saved *saved = stream->saved;
  return known_name(stream, now, saved->materials, saved->material_count, sizeof *saved->materials,
                    "the name of a material");
}

static void material(struct stream *stream) {
  struct nb_saved *saved = stream->saved;
  struct nb_material *it = ELEMENT(stream, materials, material_count, NB_MATERIALS_MAX);
  if (!it)
    return;
  new_name(stream, it->name, saved->materials, saved->material_count, sizeof *it, "the name of a material");
  number(stream, &it->density, FROM_0);
#define ROW(name, ...) number(stream, &it->name, FROM_0);
  NB_PAIR_ROWS(ROW)
#undef ROW
  number(stream, &it->young, FROM_0_OR_INFINITE);
  number(stream, &it->poisson, FROM_0);
  if (it->poisson > 0.5)
    expected(stream, "a number from 0 to 0.5");
}

static void pair(struct stream *stream) {
  struct nb_pair_rule *it = ELEMENT(stream, rules, rule_count, NB_MATERIALS_MAX * NB_MATERIALS_MAX);
  if (!it)
    return;
  it->a = material_of(stream, it->a), it->b = material_of(stream, it->b);
#define ROW(name, ...) number(stream, &it->name, FROM_0_OR_UNDEFINED);
  NB_PAIR_ROWS(ROW)
#undef ROW
}

static void particle(struct stream *stream) {
  struct nb_saved_particle *it = ELEMENT(stream, particles, particle_count, NB_PARTICLES_MAX);
  if (!it)
    return;
  const size_t own = (size_t)(it - stream->saved->particles) + 1;
  whole_number(stream, own, own, own);
  it->shape = one_of_two(stream, it->shape == NB_SPHERE, "disc", "sphere") ? NB_SPHERE : NB_DISC;
  it->material = material_of(stream, it->material);
  it->mobility = (enum nb_mobility)one_of(stream, (int)it->mobility, WORDS("free", "fixed", "gone"));
  number(stream, &it->radius, ABOVE_0);
  vector(stream, &it->position), vector(stream, &it->velocity);
  number(stream, &it->spin, FINITE), number(stream, &it->angle, FINITE);
}

static void imposed_motion(struct stream *stream) {
  struct nb_saved_imposed *it = ELEMENT(stream, imposed, imposed_count, NB_PARTICLES_MAX);
  if (!it)
    return;
  const size_t own = (size_t)(it - stream->saved->imposed) + 1;
  if (own > stream->saved->particle_count)
    expected(stream, "such a record once for each body above");
  whole_number(stream, own, own, own);
  it->by = affine_source_of(stream, it->by);
  vector(stream, &it->along);
}

static void boundary(struct stream *stream) {
  struct nb_saved_ring *it = &stream->saved->ring;
  it->is = true;
  it->held = !one_of_two(stream, !it->held, "held", "loose");
  it->pressing = !one_of_two(stream, !it->pressing, "pressed", "unpressed");
  number(stream, &it->radius, ABOVE_0);
  tensor_of(stream, &it->shape), tensor_of(stream, &it->stress);
}

static void members(struct stream *stream) {
  struct nb_saved *saved = stream->saved;
  stream->members = true;
  for (size_t k = 0; stream->out && k < saved->ring.member_count; k++)
    nb_text_add(stream->out, " %d", saved->ring.members[k] + 1);
  while (!ended(stream) && !stream->bad) {
    const int member = (int)whole_number(stream, 0, 1, saved->particle_count) - 1;
    if (saved->particle_count == 0 || saved->particles[member].member)
      expected(stream, "each body once");
    else
      saved->particles[member].member = true;
    int *it = ELEMENT(stream, ring.members, ring.member_count, NB_PARTICLES_MAX);
    if (it)
      *it = member;
  }
}

static void wall(struct stream *stream) {
  struct nb_saved *saved = stream->saved;
  struct nb_saved_wall *it = ELEMENT(stream, walls, wall_count, NB_NAMED_MAX);
  if (!it)
    return;
  new_name(stream, it->name, saved->walls, saved->wall_count, sizeof *it, "the name of a wall");
  it->material = material_of(stream, it->material);
  vector(stream, &it->pivot), vector(stream, &it->along);
  if (!(fabs(hypot(it->along.x, it->along.y) - 1) < unit_error))
    expected(stream, "a vector of length 1");
  number(stream, &it->h0, FINITE), number(stream, &it->h1, FINITE), number(stream, &it->h2, FINITE);
  vector(stream, &it->velocity), number(stream, &it->spin, FINITE);
  vector(stream, &it->turn), number(stream, &it->angle, FINITE);
}

/* ---- records of contacts ---- */

static void fields(struct stream *stream) {
#define ROW(field, name, range) one_of(stream, 0, WORDS(name));
  NB_SAVED_FIELDS(ROW)
#undef ROW
  stream->fields = true;
}

static void write_history(struct stream *stream, const char *word, struct nb_saved_history it) {
  if (it.count > 0)
    nb_text_add(stream->out, "\n%s", word);
  for (int m = 0; m < it.count; m++)
    number(stream, &stream->saved->history[it.at + (size_t)m], FINITE);
}

static void contact(struct stream *stream) {
  const struct nb_saved *saved = stream->saved;
  struct nb_saved_contact *it = ELEMENT(stream, contacts, contact_count, CONTACTS_MAX);
  if (!it)
    return;
  if (!stream->fields)
    expected(stream, "a record `fields` before the first contact");
  it->a = (int)whole_number(stream, (unsigned long)it->a + 1, 1, saved->particle_count) - 1;
  it->wall = one_of_two(stream, it->wall, "body", "wall");
  if (it->wall)
    it->b = known_name(stream, it->b, saved->walls, saved->wall_count, sizeof *saved->walls, "the name of a wall");
  else
    it->b = (int)whole_number(stream, (unsigned long)it->b + 1, (unsigned long)it->a + 2, saved->particle_count) - 1;
  it->suppressed = one_of_two(stream, it->suppressed, "heard", "muted");
  vector(stream, &it->force);
#define ROW(which, name, range) number(stream, &it->field[which], range);
  NB_SAVED_FIELDS(ROW)
#undef ROW
  if (stream->out)
    write_history(stream, "normal", it->normal), write_history(stream, "shear", it->shear);
}

static bool history_valid(const struct nb_saved *saved, const struct nb_law *law, struct nb_saved_history it) {
  return law->valid ? law->valid(saved->history + it.at, it.count, saved->pieces) : it.count == law->history;
}

/* Reads the contact history of a law, for the contact of the record above. */
static void read_history(struct stream *stream, bool shear) {
  struct nb_saved *saved = stream->saved;
  struct nb_saved_contact *above = saved->contact_count ? &saved->contacts[saved->contact_count - 1] : NULL;
  struct nb_saved_history *it = !above ? NULL : shear ? &above->shear : &above->normal;
  const struct nb_law *law = nb_law_find(shear ? "shear" : "normal", shear ? saved->shear : saved->normal);
  if (!it || !law || it->count > 0) {
    expected(stream, "such a record once, below its contact");
    return;
  }
  it->at = saved->history_count;
  while (!ended(stream) && !stream->bad) {
    double *value = ELEMENT(stream, history, history_count, CONTACTS_MAX);
    if (value)
      number(stream, value, FINITE);
    if (++it->count > NB_HISTORY_MAX)
      expected(stream, "at most %d numbers", NB_HISTORY_MAX);
  }
  if (!stream->bad && !history_valid(saved, law, *it)) {
    stream->taken = stream->line;
    expected(stream, "a contact history that the law can have");
  }
}
static void normal(struct stream *stream) { read_history(stream, false); }
static void shear(struct stream *stream) { read_history(stream, true); }

/* ---- records of a checkpoint ---- */

/* A number that may be infinite or NaN, with its sign. */
static void any_number(struct stream *stream, double *value) {
  char field[NB_STATE_FIELD], *end;
  if (stream->out) {
    nb_text_add(stream->out, " %a", *value);
    return;
  }
  take_field(stream, field, "a number");
  *value = strtod(field, &end);
  if (*end)
    expected(stream, "a number");
}

static void store(struct stream *stream) {
  struct nb_store_part *it = ELEMENT(stream, store.parts, store.part_count, CONTACTS_MAX);
  if (!it)
    return;
  name(stream, it->name, "the name of a variable");
  for (size_t k = 0; stream->out && k < it->count; k++)
    any_number(stream, &stream->saved->store.values[it->at + k]);
  it->at = stream->out ? it->at : stream->saved->store.value_count;
  for (double *value; !ended(stream) && !stream->bad; it->count++)
    if ((value = ELEMENT(stream, store.values, store.value_count, CONTACTS_MAX)))
      any_number(stream, value);
}

/* ---- the whole file ---- */

/* Each row has the word of a record, its function, how often the record must occur in a file, and how many are written.
 * A record of an object that the scene does not have is not written, nor is one AT_MOST_ONCE with a default value. The
 * history of a law is written with its contact. */
#define RECORDS(X)                                                                                                     \
  X("program", program, ONCE, 1)                                                                                       \
  X("page", page, ONCE, 1)                                                                                             \
  X("hash", hash, ONCE, 1)                                                                                             \
  X("setting", setting, ANY_TIMES, saved->setting_count)                                                               \
  X("stage", stage, ONCE, 1)                                                                                           \
  X("cycle", cycle, ONCE, 1)                                                                                           \
  X("time", time_and_step, ONCE, 1)                                                                                    \
  X("units", units, ONCE, 1)                                                                                           \
  X("gravity", gravity, ONCE, 1)                                                                                       \
  X("law", law, ONCE_OR_MORE, 2)                                                                                       \
  X("inward", central, AT_MOST_ONCE, saved->central.acceleration != 0)                                                 \
  X("impact", impact, AT_MOST_ONCE, saved->impact.is)                                                                  \
  X("rotation", rotation, AT_MOST_ONCE, !saved->rotates)                                                               \
  X("cell", cell, AT_MOST_ONCE, saved->cell.is)                                                                        \
  X("centre", centre, AT_MOST_ONCE, saved->imposed_count > 0)                                                          \
  X("carrier", affine_source, ANY_TIMES, saved->imposed_count > 0 ? NB_AFFINE_SOURCES - 1 : 0)                         \
  X("material", material, ANY_TIMES, saved->material_count)                                                            \
  X("pair", pair, ANY_TIMES, saved->rule_count)                                                                        \
  X("body", particle, ONCE_OR_MORE, saved->particle_count)                                                             \
  X("carried", imposed_motion, ANY_TIMES, saved->imposed_count)                                                        \
  X("boundary", boundary, AT_MOST_ONCE, saved->ring.is)                                                                \
  X("members", members, AT_MOST_ONCE, saved->ring.is)                                                                  \
  X("wall", wall, ANY_TIMES, saved->wall_count)                                                                        \
  X("fields", fields, AT_MOST_ONCE, saved->contact_count > 0)                                                          \
  X("contact", contact, ANY_TIMES, saved->contact_count)                                                               \
  X("normal", normal, ANY_TIMES, 0)                                                                                    \
  X("shear", shear, ANY_TIMES, 0)                                                                                      \
  X("store", store, ANY_TIMES, saved->store.part_count)

static const struct {
  const char *word;
  void (*walk)(struct stream *stream);
  enum { ANY_TIMES, AT_MOST_ONCE, ONCE, ONCE_OR_MORE } times;
} records[] = {
#define ROW(word, walk, times, many) {word, walk, times},
    RECORDS(ROW)
#undef ROW
};
enum { COUNT = sizeof records / sizeof *records };

static const char head[] = "nineball state 1\n";
static const size_t any_version = sizeof "nineball state " - 1; /* length of the first words of all versions */

bool nb_saved_is(FILE *file) {
  char begin[sizeof head];
  return fread(begin, 1, any_version, file) == any_version && memcmp(begin, head, any_version) == 0;
}

char *nb_saved_text(const struct nb_saved *saved, size_t *size) {
#define ROW(word, walk, times, many) many,
  const size_t many[COUNT] = {RECORDS(ROW)};
#undef ROW
  struct nb_saved copy = *saved;
  struct nb_text text = {0};
  struct stream stream = {.saved = &copy, .out = &text};
  nb_text_add(&text, "%s", head);
  for (size_t r = 0; r < COUNT; r++)
    for (stream.k = 0; stream.k < many[r]; stream.k++) {
      nb_text_add(&text, "%s", records[r].word);
      records[r].walk(&stream);
      nb_text_add(&text, "\n");
    }
  if (!text.failed)
    nb_text_add(&text, "end %016llx\n", nb_hash(NB_HASH_BEGIN, text.at, text.length));
  *size = text.length;
  return text.at;
}

static void read_record(struct stream *stream) {
  char word[NB_STATE_FIELD];
  size_t r = 0;
  stream->at = stream->line;
  take_field(stream, word, "a record");
  while (r < COUNT && strcmp(records[r].word, word) != 0)
    r++;
  if (r == COUNT) {
    expected(stream, "a record of this version");
    return;
  }
  if (stream->seen & 1U << r && (records[r].times == ONCE || records[r].times == AT_MOST_ONCE))
    expected(stream, "such a record once");
  stream->seen |= 1U << r;
  records[r].walk(stream);
  stream->taken = stream->at;
  if (!ended(stream))
    expected(stream, "the end of the line");
}

/* True if the state has the cell that imposes the motion of a particle, or if the particle belongs to the boundary that
 * imposes it. Other sources need no record. */
static bool has_source(const struct nb_saved *saved, size_t particle) {
  const enum nb_affine_source by = saved->imposed[particle].by;
  return by == NB_AFFINE_CELL ? saved->cell.is : by != NB_AFFINE_BOUNDARY || saved->particles[particle].member;
}

/* Checks, at the last line, that required records are there and agree. */
static void check_whole(struct stream *stream) {
  const struct nb_saved *saved = stream->saved;
  stream->taken = stream->line;
  for (size_t r = 0; r < COUNT; r++)
    if (records[r].times >= ONCE && !(stream->seen & 1U << r))
      expected(stream, "a record `%s` above", records[r].word);
  if (!saved->normal[0] || !saved->shear[0])
    expected(stream, "records `law normal` and `law shear` above");
  if (saved->imposed_count != 0 && saved->imposed_count != saved->particle_count)
    expected(stream, "a record `carried` for each body, or for none");
  for (size_t k = 0; k < saved->imposed_count; k++)
    if (!has_source(saved, k))
      expected(stream, "particle %zu to follow a cell or a boundary that the state has", k + 1);
  if (saved->ring.is != stream->members)
    expected(stream, "records `boundary` and `members`, or neither");
}

static enum nb_status damaged(const char *path, const char *text, size_t last, const char *what,
                              struct nb_error *error) {
  size_t line = 1;
  for (size_t i = 0; i < last; i++)
    line += text[i] == '\n';
  return nb_error_set(error, NB_BAD_USE, "%.200s:%zu:1: %s", path, line, what);
}

enum nb_status nb_saved_read_text(struct nb_saved *saved, const char *path, const char *text, size_t size,
                                  struct nb_error *error) {
  char end[NB_STATE_END + 1];
  *saved = (struct nb_saved){.rotates = true};
  if (size < sizeof head - 1 || memcmp(text, head, sizeof head - 1) != 0)
    return damaged(path, text, 0, "expected `nineball state 1`: this is not a saved state, or one of another version",
                   error);
  const size_t last = size - NB_STATE_END;
  if (size < sizeof head - 1 + NB_STATE_END || memcmp(text + last, "end ", 4) != 0)
    return damaged(path, text, size, "expected a last line `end` with its checksum: the file is cut off", error);
  snprintf(end, sizeof end, "end %016llx\n", nb_hash(NB_HASH_BEGIN, text, last));
  if (text[last - 1] != '\n' || memcmp(text + last, end, NB_STATE_END) != 0)
    return damaged(path, text, last,
                   "expected the checksum of the lines above, found another one: the file has been changed", error);
  const char *zero = memchr(text, 0, size); /* a zero byte would end a name */
  if (zero)
    return damaged(path, text, (size_t)(zero - text), "expected text, found a byte that is 0", error);

  struct stream stream = {.saved = saved, .path = path, .number = 1, .error = error, .line = text + sizeof head - 1};
  while (stream.line < text + last && !stream.bad) {
    /* not NULL: the last line ends in `\n` */
    stream.end = memchr(stream.line, '\n', (size_t)(text + last - stream.line));
    stream.number++;
    read_record(&stream);
    stream.line = stream.end + 1;
  }
  stream.end = text + size - 1, stream.number++;
  if (!stream.bad)
    check_whole(&stream);
  if (!stream.bad)
    return NB_OK;
  nb_saved_free(saved);
  return error->status;
}

enum nb_status nb_saved_read(struct nb_saved *saved, const char *path, struct nb_error *error) {
  size_t size;
  *saved = (struct nb_saved){0};
  char *text = nb_file_read(path, NB_FILE_MAX, &size, error);
  const struct nb_error why = text ? (struct nb_error){NB_OK, ""} : *error;
  if (why.status == NB_BAD_USE)
    nb_error_set(error, NB_BAD_USE, "%.200s: %.200s", path, why.text);
  const enum nb_status status = text ? nb_saved_read_text(saved, path, text, size, error) : why.status;
  free(text);
  return status;
}
