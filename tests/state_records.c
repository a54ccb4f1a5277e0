/* The records of a saved state, field by field: every value that docs/STATE.md does not allow is an error at that
 * field.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <stdlib.h>
#include <string.h>

#include "../src/input/reader.h"
#include "../src/input/state_file.h"
#include "state_text.h"
#include "suites.h"

static const char exact[] = "units none\nmaterial m density 3 friction 0.3 young 5000 poisson 0.2\nnormal "
                            "hertz\nshear mindlin_deresiewicz memory 3\n"
                            "wall w -5 0 to 5 0 m\nlattice spheres 2 by 1 m radius 1 spacing 1.99 from 0 "
                            "0.995\ngravity 1 -1\nstep 0.001\nstage a\ncycles 20\n";

static const char impact[] =
    "units none\nmaterial m density 3 young 5000 poisson 0.2\nnormal hertz\nwall w -5 0 to 5 0 m\n"
    "sphere 0 5 radius 1 m\nlattice spheres 3 by 1 m radius 0.3 spacing 0.59 from 2 0.29\nmonitor C sphere 1 with wall "
    "w\nimpact C speed 1 angle 0.5 phase 0.3\n"
    "step 0.001\nstage a\ncycles 20\n";

/* The kinds of the fields after the word of a record, one letter per field (see kinds). Further fields are not
 * tested. */
static const struct {
  const char *page, *record, *fields;
} records[] = {
    {state_plain, "program", "t"},
    {state_plain, "hash", "w"},
    {state_plain, "stage", "t"},
    {state_plain, "cycle", "oo"},
    {state_plain, "time", "pp"},
    {state_plain, "units", "w"},
    {state_plain, "gravity", "ff"},
    {state_plain, "law normal", "w"},
    {state_plain, "law shear", "wc"},
    {state_plain, "material", "wnnnnnyv"},
    {state_plain, "pair", "wwmmmm"},
    {state_plain, "body", "kwwwpffffff"},
    {state_plain, "wall", "wwffuufffffffff"},
    {state_plain, "fields", "wwwwwwwwwwwww"},
    {state_plain, "contact", "kwkwffnffffnnnfnnff"},
    {state_plain, "shear", "g"},
    {exact, "shear", "ggg"},
    {state_ring, "inward", "fff"},
    {impact, "impact", "n"},
    {state_ring, "rotation", "w"},
    {state_ring, "centre", "ff"},
    {state_ring, "carrier", "wwffffwffff"},
    {state_ring, "carried", "kwff"},
    {state_ring, "boundary", "wwpffffffff"},
    {state_ring, "members", "kkk"},
    {state_cell, "cell", "ffffffff"},
};

static const struct {
  char kind;
  const char *refused[9];
} kinds[] = {
    {'w', {"", "x!"}},                                                /* one of some words, or a name */
    {'t', {""}},                                                      /* any text without a space */
    {'g', {"x", "-", "inf", "-inf", "nan", "0x1p+0x"}},               /* finite; the field may be missing */
    {'f', {"", "x", "-", "inf", "-inf", "nan", "0x1p+0x"}},           /* finite */
    {'n', {"", "x", "-", "inf", "-inf", "nan", "-0x1p+0"}},           /* 0 or more */
    {'p', {"", "x", "-", "inf", "-inf", "nan", "-0x1p+0", "0x0p+0"}}, /* above 0 */
    {'m', {"", "x", "inf", "-inf", "nan", "-0x1p+0"}},                /* 0 or more, or `-` for none */
    {'y', {"", "x", "-", "-inf", "nan", "-0x1p+0"}},                  /* Young's modulus: 0 or more, or infinite */
    {'v', {"", "x", "-", "inf", "nan", "-0x1p+0", "0x1.00001p-1"}},   /* Poisson's ratio */
    {'u', {"", "x", "-", "inf", "nan", "0x1.000000044c0fbp+0"}},      /* a component of a unit vector: 1 + 1.0005e-9 */
    {'c', {"", "x", "-", "-1", "+1", "1x", "1000000000001", "99999999999999999999"}},   /* a whole number */
    {'o', {"", "x", "-", "-1", "+1", "1x", "0", "1000000000001"}},                      /* a number of cycles */
    {'k', {"", "x", "-", "-1", "+1", "1x", "0", "4000000000", "99999999999999999999"}}, /* from 1 on */
};

/* The start of the first line that begins with this word; there must be one. *end becomes the end of this line. */
static char *line_of(char *text, const char *word, char **end) {
  const size_t length = strlen(word);
  char *at = text;
  while (strncmp(at, word, length) != 0 || (at[length] != ' ' && at[length] != '\n'))
    at = strchr(at, '\n') + 1;
  *end = strchr(at, '\n');
  return at;
}

static size_t line_number(const char *text, const char *at) {
  size_t number = 1;
  for (; text < at; text++)
    number += *text == '\n';
  return number;
}

/* The text with the bytes from `from` to `to` replaced by the text `by`, and with its checksum; to be freed. */
static char *spliced(const char *text, const char *from, const char *to, const char *by, size_t *size) {
  char *other = malloc(strlen(text) + strlen(by) + 1);
  sprintf(other, "%.*s%s%s", (int)(from - text), text, by, to);
  char *sealed = state_sealed(other, strlen(other) - NB_STATE_END, size);
  free(other);
  return sealed;
}

/* Reads the text with the bytes from `from` to `to` replaced by the text `by`, and returns the error. */
static struct nb_error read_changed(const char *text, const char *from, const char *to, const char *by) {
  struct nb_saved saved;
  struct nb_error error = {NB_OK, ""};
  size_t size;
  char *sealed = spliced(text, from, to, by, &size);
  nb_saved_read_text(&saved, "a.state", sealed, size, &error);
  nb_saved_free(&saved);
  free(sealed);
  return error;
}

/* Tests that the state is refused if its field is replaced by the text `by`, with an error at this field. `vector`: the
 * field is a component of a unit vector. */
static void refused(const char *text, char *field, size_t length, const char *by, bool vector) {
  char where[32], *line = field;
  while (line > text && line[-1] != '\n')
    line--;
  snprintf(where, sizeof where, "a.state:%zu:%zu: ", line_number(text, field), (size_t)(field - line) + 1);
  where[vector ? strcspn(where, ":") + 1 : strlen(where)] = 0; /* the error is at the last component */
  const struct nb_error error = read_changed(text, field, field + length, by);
  if (strncmp(error.text, where, strlen(where)) != 0)
    printf("# `%s` in %.*s: expected %s…, found `%s`\n", by, (int)(strcspn(field, "\n") + (size_t)(field - line)), line,
           where, error.text);
  CU_ASSERT(strncmp(error.text, where, strlen(where)) == 0);
}

static void every_field(void) {
  char name[NB_NAME_SIZE + 1] = "", word[NB_STATE_FIELD + 1] = "";
  memset(name, 'x', sizeof name - 1), memset(word, '0', sizeof word - 1);
  for (size_t r = 0; r < sizeof records / sizeof *records; r++) {
    size_t size;
    char *text = state_of(records[r].page, &size), *end, *at = line_of(text, records[r].record, &end);
    at += strlen(records[r].record);
    CU_ASSERT_EQUAL(read_changed(text, text, text, "").status, NB_OK);
    for (const char *kind = records[r].fields; *kind && *at == ' '; kind++) {
      const size_t length = strcspn(++at, " \n");
      for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
        for (int b = 0; kinds[k].kind == *kind && b < 9 && kinds[k].refused[b]; b++)
          refused(text, at, length, kinds[k].refused[b], *kind == 'u');
      refused(text, at, length, name, false);
      refused(text, at, length, word, false);
      at += length;
    }
    free(text);
  }
}

/* Tests that the changed state has the same text after it has been read and written. */
static void same_text(const char *text, const char *from, const char *to, const char *by) {
  struct nb_saved saved;
  struct nb_error error = {NB_OK, ""};
  size_t size, again_size;
  char *sealed = spliced(text, from, to, by, &size);
  CU_ASSERT_EQUAL_FATAL(nb_saved_read_text(&saved, "a.state", sealed, size, &error), NB_OK);
  char *again = nb_saved_text(&saved, &again_size);
  CU_ASSERT_EQUAL(again_size, size);
  CU_ASSERT_STRING_EQUAL(again, sealed);
  nb_saved_free(&saved);
  CU_ASSERT_EQUAL(saved.program[0], 0);
  free(again), free(sealed);
}

/* The largest and the smallest numbers, and the longest name, that fields accept. A state that has been read is written
 * with the same text. */
static void fields_at_their_limits(void) {
  static const struct {
    const char *page, *record, *by;
  } rows[] = {
      {impact, "impact", "impact 0x0p+0"}, /* before the first contact */
      {state_plain, "law shear", "law shear mindlin 256"},
      {state_plain, "cycle", "cycle 1000000000000 1"},
      {state_plain, "stage", "stage xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx"}, /* 63 bytes */
      {state_plain, "material", "material m 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 inf 0x1p-1"},
      {state_plain, "pair", "pair m m - - 0x0p+0 0x1p+0"},
      {state_cell, "cell", "cell 0x1p+0 0x1p+0 0x1.8p+0 0x1p+1 0x1p+0 0x1p+1 0x1p+2 0x1p+3"}, /* area 1/2 */
      {state_plain, "cycle", "cycle 1000000000000 1000000000000"},
      {state_plain, "wall",
       "wall w m 0x0p+0 0x0p+0 0x1.000000044af64p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 "
       "0x0p+0"},
      {state_plain, "wall",
       "wall w m -0x1p+0 -0x1p+0 -0x1p+0 0x0p+0 -0x1p+0 -0x1p+0 -0x1p+0 -0x1p+0 -0x1p+0 -0x1p+0 -0x1p+0 -0x1p+0 "
       "-0x1p+0"},
      {state_plain, "shear", "shear -0x1p+0"},
      {state_ring, "inward", "inward -0x1p+0 -0x1p+0 -0x1p+0"},
  };
  for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
    size_t size;
    char *text = state_of(rows[r].page, &size), *end, *at = line_of(text, rows[r].record, &end);
    const struct nb_error error = read_changed(text, at, end, rows[r].by);
    if (error.status)
      printf("# %s: %s\n", rows[r].by, error.text);
    CU_ASSERT_EQUAL(error.status, NB_OK);
    same_text(text, at, end, rows[r].by);
    free(text);
  }
}

/* Each of these records is removed, which is an error if it is required, and doubled, which is an error. */
static void every_record(void) {
  static const struct {
    const char *page, *record;
    const char *removed; /* error without it, NULL: none */
  } rows[] = {
      {state_plain, "program", "expected a record `program` above, found `end`"},
      {state_plain, "page", "expected a record `page` above, found `end`"},
      {state_plain, "hash", "expected a record `hash` above, found `end`"},
      {state_plain, "stage", "expected a record `stage` above, found `end`"},
      {state_plain, "cycle", "expected a record `cycle` above, found `end`"},
      {state_plain, "time", "expected a record `time` above, found `end`"},
      {state_plain, "units", "expected a record `units` above, found `end`"},
      {state_plain, "gravity", "expected a record `gravity` above, found `end`"},
      {state_cell, "law normal", "expected records `law normal` and `law shear` above, found `end`"},
      {state_cell, "law shear", "expected records `law normal` and `law shear` above, found `end`"},
      {state_plain, "fields", "expected a record `fields` before the first contact, found `contact`"},
      {state_plain, "shear", NULL},
      {state_ring, "inward", NULL},
      {impact, "impact", NULL},
      {state_ring, "rotation", NULL},
      {state_ring, "centre", NULL},
      {state_ring, "boundary", "expected records `boundary` and `members`, or neither, found `end`"},
      {state_ring, "members", "expected particle 1 to follow a cell or a boundary that the state has, found `end`"},
      {state_cell, "cell", "expected particle 1 to follow a cell or a boundary that the state has, found `end`"},
  };
  for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
    size_t size;
    char *text = state_of(rows[r].page, &size), *end, *at = line_of(text, rows[r].record, &end), twice[1024];
    snprintf(twice, sizeof twice, "%.*s\n%.*s\n", (int)(end - at), at, (int)(end - at), at);
    struct nb_error error = read_changed(text, at, end + 1, twice);
    CU_ASSERT_PTR_NOT_NULL(strstr(error.text, strcmp(rows[r].record, "shear") == 0
                                                  ? "expected such a record once, below its contact, found `shear`"
                                                  : "expected such a record once, found `"));
    error = read_changed(text, at, end + 1, "");
    CU_ASSERT(rows[r].removed ? strstr(error.text, rows[r].removed) != NULL : error.status == NB_OK);
    free(text);
  }
}

static void without_particles(void) {
  static const char text[] =
      "nineball state 1\nprogram 1\npage a\nhash 0000000000000000\nstage a\ncycle 1 1\n"
      "time 0x1p+0 0x1p+0\nunits si\ngravity 0x0p+0 0x0p+0\nlaw normal linear\nlaw shear none 0\n"
      "end 0000000000000000\n";
  const struct nb_error error = read_changed(text, text, text, "");
  CU_ASSERT_STRING_EQUAL(error.text, "a.state:12:1: expected a record `body` above, found `end`");
  static const char empty[] = "nineball state 1\nend 0000000000000000\n";
  CU_ASSERT_STRING_EQUAL(read_changed(empty, empty, empty, "").text,
                         "a.state:2:1: expected a record `program` above, found `end`");
  /* No line end between the last record and `end`, with the right checksum. */
  const char *end = strstr(text, "\nend ");
  CU_ASSERT_PTR_NOT_NULL(strstr(read_changed(text, end, end + 1, "").text, "expected the checksum of the lines above"));
}

/* The largest number of records, the largest number of numbers in a record, and one more of each. */
static void at_most(void) {
  size_t size;
  char *text = state_of(state_plain, &size), *end, *at = line_of(text, "units", &end);
  char *many = calloc(NB_NAMED_MAX + 1, 16);
  for (int k = 0; k + 1 < NB_NAMED_MAX; k++) /* state_of has made one */
    strcat(many, "setting a=1\n");
  CU_ASSERT_EQUAL(read_changed(text, at, at, many).status, NB_OK);
  strcat(many, "setting a=1\n");
  CU_ASSERT_PTR_NOT_NULL(
      strstr(read_changed(text, at, at, many).text, "expected at most 2000 such records, found `setting`"));
  free(many);
  at = line_of(text, "shear", &end);
  many = calloc(NB_HISTORY_MAX + 3, 3);
  strcpy(many, "shear");
  for (int k = 0; k < NB_HISTORY_MAX; k++)
    strcat(many, " 0");
  CU_ASSERT_PTR_NOT_NULL(strstr(read_changed(text, at, end, many).text, "a contact history that the law can have"));
  strcat(many, " 0");
  CU_ASSERT_PTR_NOT_NULL(strstr(read_changed(text, at, end, many).text, "expected at most 1292 numbers, found `0`"));
  free(many), free(text);
}

/* A tensor is written as xx, xy, yx, yy, as docs/STATE.md says: the cell is strained at xx 0.1, xy 0.3, yx 0, yy -0.1. */
static void the_components_of_a_tensor_have_their_order(void) {
  size_t size;
  char *text = state_of(state_cell, &size);
  const char *record = strstr(text, "\ncarrier cell apart ");
  double at[8];
  CU_ASSERT_PTR_NOT_NULL_FATAL(record);
  CU_ASSERT_EQUAL_FATAL(sscanf(record, "\ncarrier cell apart %lf %lf %lf %lf time %lf %lf %lf %lf", &at[0], &at[1],
                               &at[2], &at[3], &at[4], &at[5], &at[6], &at[7]),
                        8);
  for (int k = 0; k < 8; k += 4)
    CU_ASSERT(at[k] == 0.1 && at[k + 1] == 0.3 && at[k + 2] == 0 && at[k + 3] == -0.1);
  free(text);
}

/* Reads the state of a page with another text for a record. */
static void read_with(struct nb_saved *saved, const char *page, const char *record, const char *by) {
  size_t size;
  struct nb_error error;
  char *text = state_of(page, &size), *end, *at = line_of(text, record, &end);
  char *sealed = spliced(text, at, end, by, &size);
  CU_ASSERT_EQUAL_FATAL(nb_saved_read_text(saved, "a.state", sealed, size, &error), NB_OK);
  free(sealed), free(text);
}

/* The numbers of a record have the order of docs/STATE.md: they are 1, 2, 4, 8 … in the file. */
#define ORDER(page, record, numbers, ...)                                                                              \
  do {                                                                                                                 \
    struct nb_saved it;                                                                                                \
    read_with(&it, page, record, record numbers);                                                                      \
    const double found[] = {__VA_ARGS__};                                                                              \
    for (size_t k = 0; k < sizeof found / sizeof *found; k++)                                                          \
      CU_ASSERT_EQUAL(found[k], (double)(1UL << k));                                                                   \
    nb_saved_free(&it);                                                                                                \
  } while (0)
#define VECTOR(v) (v).x, (v).y
#define TENSOR(t) (t).xx, (t).xy, (t).yx, (t).yy

static void numbers_have_the_order_of_the_document(void) {
  ORDER(state_plain, "cycle", " 2 1", (double)it.stage_cycle, (double)it.cycle);
  ORDER(state_plain, "time", " 0x1p+0 0x1p+1", it.time, it.step);
  ORDER(state_plain, "gravity", " 0x1p+0 0x1p+1", VECTOR(it.gravity));
  ORDER(state_plain, "material", " m 0x1p+0 0x1p+1 0x1p+2 0x1p+3 0x1p+4 0x1p+5 0x0p+0", it.materials->density,
        it.materials->kn, it.materials->ks, it.materials->friction, it.materials->cohesion, it.materials->young);
  ORDER(state_plain, "pair", " m m 0x1p+0 0x1p+1 0x1p+2 0x1p+3", it.rules->kn, it.rules->ks, it.rules->friction,
        it.rules->cohesion);
  ORDER(state_plain, "body", " 1 sphere m free 0x1p+0 0x1p+1 0x1p+2 0x1p+3 0x1p+4 0x1p+5 0x1p+6", it.particles->radius,
        VECTOR(it.particles->position), VECTOR(it.particles->velocity), it.particles->spin, it.particles->angle);
  ORDER(state_plain, "wall",
        " w m 0x1p+0 0x1p+1 0x1p+0 0x0p+0 0x1p+2 0x1p+3 0x1p+4 0x1p+5 0x1p+6 0x1p+7 0x1p+8 0x1p+9 0x1p+10",
        VECTOR(it.walls->pivot), it.walls->h0, it.walls->h1, it.walls->h2, VECTOR(it.walls->velocity), it.walls->spin,
        VECTOR(it.walls->turn), it.walls->angle);
  ORDER(state_plain, "wall",
        " w m 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 "
        "0x0p+0",
        it.walls->along.x);
  ORDER(state_ring, "inward", " 0x1p+0 0x1p+1 0x1p+2", it.central.acceleration, VECTOR(it.central.point));
  ORDER(state_ring, "centre", " 0x1p+0 0x1p+1", VECTOR(it.centre));
  ORDER(state_ring, "carrier", " continuum literal 0x1p+0 0x1p+1 0x1p+2 0x1p+3 cycle 0x1p+4 0x1p+5 0x1p+6 0x1p+7",
        TENSOR(it.sources[NB_AFFINE_FREE].rate), TENSOR(it.sources[NB_AFFINE_FREE].requested));
  ORDER(state_ring, "carried", " 1 boundary 0x1p+0 0x1p+1", VECTOR(it.imposed->along));
  ORDER(state_ring, "boundary", " loose unpressed 0x1p+0 0x1p+1 0x1p+2 0x1p+3 0x1p+4 0x1p+5 0x1p+6 0x1p+7 0x1p+8",
        it.ring.radius, TENSOR(it.ring.shape), TENSOR(it.ring.stress));
  ORDER(state_cell, "cell", " 0x1p+0 0x1p+1 0x1p+2 0x1p+4 0x1p+4 0x1p+5 0x1p+6 0x1p+7", it.cell.h.xx, it.cell.h.xy,
        it.cell.h.yx, it.cell.h.yy / 2, TENSOR(it.cell.image_velocity));
  ORDER(state_plain, "contact",
        " 1 body 2 heard 0x1p+0 0x1p+1 0x1p+2 0x1p+3 0x1p+4 0x1p+5 0x1p+6 0x1p+7 0x1p+8 0x1p+9 0x1p+10 0x1p+11 0x1p+12 "
        "0x1p+13 0x1p+14",
        VECTOR(it.contacts->force), it.contacts->field[NB_OVERLAP], it.contacts->field[NB_NORMAL_INCREMENT],
        it.contacts->field[NB_TANGENTIAL_INCREMENT], it.contacts->field[NB_EX], it.contacts->field[NB_EY],
        it.contacts->field[NB_NORMAL], it.contacts->field[NB_STIFFNESS], it.contacts->field[NB_RADIUS],
        it.contacts->field[NB_SHEAR], it.contacts->field[NB_SHEAR_STIFFNESS], it.contacts->field[NB_SLIDING],
        it.contacts->field[NB_TOTAL_NORMAL], it.contacts->field[NB_TOTAL_SHEAR]);
}

/* The three ways in which a free particle stores its imposed motion. */
static void codings_of_an_imposed_motion(void) {
  static const struct {
    const char *word;
    bool accumulated, twice;
  } rows[] = {{"apart", false, false}, {"literal", true, false}, {"literal-twice", true, true}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    char to[64];
    size_t size;
    struct nb_saved saved;
    struct nb_error error;
    snprintf(to, sizeof to, "\ncarrier continuum %s ", rows[k].word);
    char *text = state_changed(state_ring, "\ncarrier continuum apart ", to, &size);
    CU_ASSERT_EQUAL_FATAL(nb_saved_read_text(&saved, "a.state", text, size, &error), NB_OK);
    CU_ASSERT_EQUAL(saved.sources[NB_AFFINE_FREE].accumulated, rows[k].accumulated);
    CU_ASSERT_EQUAL(saved.sources[NB_AFFINE_FREE].twice, rows[k].twice);
    CU_ASSERT(!saved.sources[NB_AFFINE_BOUNDARY].accumulated && !saved.sources[NB_AFFINE_BOUNDARY].twice);
    nb_saved_free(&saved);
    free(text);
  }
}

/* The sources of an imposed motion may have any order. */
static void sources_in_another_order(void) {
  size_t size;
  char *text = state_of(state_ring, &size), *end, *first = line_of(text, "carrier continuum", &end), *after;
  line_of(text, "carrier box", &after);
  char *by = malloc(size);
  sprintf(by, "%.*s\n%.*s", (int)(after - end - 1), end + 1, (int)(end - first), first);
  CU_ASSERT_EQUAL(read_changed(text, first, after, by).status, NB_OK);
  free(by), free(text);
}

void suite_state_records(void) {
  CU_pSuite suite = CU_add_suite("state_records", NULL, NULL);
  CU_add_test(suite, "invalid fields are refused at their place", every_field);
  CU_add_test(suite, "fields at their limits", fields_at_their_limits);
  CU_ADD_TEST(suite, the_components_of_a_tensor_have_their_order);
  CU_ADD_TEST(suite, numbers_have_the_order_of_the_document);
  CU_ADD_TEST(suite, codings_of_an_imposed_motion);
  CU_ADD_TEST(suite, sources_in_another_order);
  CU_add_test(suite, "missing and doubled records", every_record);
  CU_add_test(suite, "no particles, or no line end before `end`", without_particles);
  CU_add_test(suite, "largest numbers of records and of numbers", at_most);
}
