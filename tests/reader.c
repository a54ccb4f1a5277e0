/* The reader: numbers, pages and their blocks, names of values, and the scene that a page describes. Messages about
 * invalid pages are tested by tests/mistakes.sh.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../src/input/reader.h"
#include "suites.h"
#include "written.h"

/* A page from a text, and one of its runs. */
struct read {
  struct nb_page page;
  struct nb_scene scene;
  struct nb_mistakes mistakes;
  enum nb_status status;
};

/* Reads a page with these bytes from a temporary file, and one of its runs with these settings. */
static struct read read_bytes(const char *bytes, size_t size, size_t run, nb_settings settings) {
  struct read read = {.status = NB_BAD_USE};
  char path[] = "/tmp/nineball-reader-XXXXXX";
  FILE *file = written_file(path);
  CU_ASSERT_EQUAL_FATAL(fwrite(bytes, 1, size, file), size);
  fclose(file);
  if (nb_page_read(&read.page, path, &read.mistakes) == NB_OK)
    read.status = nb_scene_read(&read.scene, &read.page, run, settings, &read.mistakes);
  unlink(path);
  return read;
}

static struct read read_scene(const char *statements, size_t run, nb_settings settings) {
  char text[8192];
  int size = snprintf(text, sizeof text, "```scene\n%s\n```\n", statements);
  CU_ASSERT_FATAL(size > 0 && (size_t)size < sizeof text);
  return read_bytes(text, (size_t)size, run, settings);
}

static void done(struct read *read) {
  nb_scene_free(&read->scene);
  nb_page_free(&read->page);
  nb_mistakes_free(&read->mistakes);
}

static bool says(const struct read *read, const char *what) {
  return read->mistakes.text && strstr(read->mistakes.text, what);
}

#define ROCK "material rock density 2000 kg/m3 kn 3 kN/m ks 1 kN/m friction 0.5\n"

static void numbers(void) {
  static const char *const none[] = {"",    "+",   ".",   "-.",   "0x5",   "inf", "-inf", "nan",   "1e",
                                     "1e+", "1,5", "5mm", "1e5x", "1.2.3", " 1",  "1 ",   "1e1.5", "--1"};
  double value;
  for (size_t i = 0; i < sizeof none / sizeof *none; i++)
    CU_ASSERT_EQUAL(nb_number_read(&value, none[i], 0), NB_NO_NUMBER);
  CU_ASSERT(nb_number_read(&value, "-1.5e3", 0) == NB_READ && value == -1500);
  CU_ASSERT(nb_number_read(&value, "+.5", 0) == NB_READ && value == 0.5);
  CU_ASSERT(nb_number_read(&value, "5.", 0) == NB_READ && value == 5);
  CU_ASSERT(nb_number_read(&value, "2E-2", 3) == NB_READ && value == 20);
  CU_ASSERT(nb_number_read(&value, "0e-999999999999999999999", 0) == NB_READ && value == 0);
  CU_ASSERT_EQUAL(nb_number_read(&value, "1e308", 3), NB_TOO_LARGE);
  CU_ASSERT_EQUAL(nb_number_read(&value, "-1e999999999999999999999", 0), NB_TOO_LARGE);
  CU_ASSERT_EQUAL(nb_number_read(&value, "1e-400", 0), NB_TOO_SMALL);
}

static void blocks(void) {
  static const char text[] =
      "\xEF\xBB\xBF# Nine discs\n## Not this\n~~~~ scene\none\n```\n~~~~\n````text\n```scene\n```\n````\n"
      "   ```expect\ntwo\n   ```` \n    ```scene\nprose ```scene\n";
  static const unsigned char kinds[] = {0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0};
  struct read read = read_bytes(text, sizeof text - 1, 0, NULL);
  CU_ASSERT_EQUAL_FATAL(read.page.line_count, sizeof kinds);
  CU_ASSERT_EQUAL(memcmp(read.page.kind_of, kinds, sizeof kinds), 0);
  CU_ASSERT_STRING_EQUAL(read.page.title, "Nine discs");
  CU_ASSERT_EQUAL(strncmp(read.page.name, "nineball-reader-", 16), 0);
  CU_ASSERT_EQUAL(nb_page_fence(&read.page, NB_BLOCK_EXPECT), 11);
  done(&read);
}

/* The title is the first heading outside a block, in any line. */
/* Lines that are no fence, and blocks `expect` that are not read because they are in a quote or a list: the kind of each
 * line, 0 for prose and fences, 5 for a line of a hidden block. */
static void fences(void) {
  static const char *const rows[][2] = {{"```scene `x`\na\n", "00"},
                                        {"```\tscene\na\n```\nb\n", "0100"},
                                        {"```scheme\na\n```\n", "000"},
                                        {"```export\na\n```\n", "000"}, /* two letters from `expect` */
                                        {"- ```expect\n  a\n  ```\nb\n", "0500"},
                                        {"+ ```expect\n  a\n  ```\nb\n", "0500"},
                                        {"* ```expect\n  a\n  ```\nb\n", "0500"},
                                        {"> ```expect\n> a\n> ```\n> b\n", "0500"},
                                        {">\t```expect\n>\ta\n>\t```\n> b\n", "0500"}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct read read = read_bytes(rows[k][0], strlen(rows[k][0]), 0, NULL);
    CU_ASSERT_EQUAL_FATAL(read.page.line_count, strlen(rows[k][1]));
    for (size_t line = 0; line < read.page.line_count; line++)
      CU_ASSERT_EQUAL(read.page.kind_of[line], rows[k][1][line] - '0');
    done(&read);
  }
}

/* The name of a page is that of its file, without `.md`. */
static void names_of_pages(void) {
  static const char *const rows[][2] = {{"a/b/case.md", "case"}, {"case", "case"}, {"a.md/.md", ".md"}, {"x.md", "x"}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    const char *name;
    const size_t length = nb_page_name(rows[k][0], &name);
    CU_ASSERT(length == strlen(rows[k][1]) && strncmp(name, rows[k][1], length) == 0);
  }
}

static void titles(void) {
  static const char *const rows[][2] = {{"# A", "A"},
                                        {"\nwords\n# B\n# C\n", "B"},
                                        {"```text\n# not this\n```\n# D\n", "D"},
                                        {"## not this\n#nor this\n", ""}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct read read = read_bytes(rows[k][0], strlen(rows[k][0]), 0, NULL);
    CU_ASSERT_STRING_EQUAL(read.page.title, rows[k][1]);
    done(&read);
  }
  /* A title has room for 127 bytes. A longer one ends between two characters: `ü` has two bytes. */
  for (int letters = 125; letters <= 128; letters++) {
    char text[140], title[140];
    memset(title, 'a', sizeof title);
    snprintf(text, sizeof text, "# %.*sü\n", letters, title);
    struct read read = read_bytes(text, strlen(text), 0, NULL);
    snprintf(text, sizeof text, "%.*s%s", letters < 127 ? letters : 127, title, letters < 126 ? "ü" : "");
    CU_ASSERT_STRING_EQUAL(read.page.title, text);
    done(&read);
  }
}

static void hash(void) { /* the test vectors of Fowler, Noll and Vo */
  struct read a = read_bytes("a", 1, 0, NULL), foobar = read_bytes("foobar", 6, 0, NULL);
  CU_ASSERT_EQUAL(a.page.hash, 0xaf63dc4c8601ec8cULL);
  CU_ASSERT_EQUAL(foobar.page.hash, 0x85944171f73967e8ULL);
  done(&a);
  done(&foobar);
}

static void line_ends(void) {
  static const char dos[] = "# T\r\n```scene\r\n"
                            "units none\r\nmaterial rock density 1\r\ndisc 0 0 radius 1 rock\r\n"
                            "step 1\r\nstage go\r\ncycles 3\r\n```\r\n# no line end";
  struct read read = read_bytes(dos, sizeof dos - 1, 0, NULL);
  CU_ASSERT_EQUAL_FATAL(read.status, NB_OK);
  CU_ASSERT_STRING_EQUAL(read.page.title, "T");
  CU_ASSERT_STRING_EQUAL(read.page.lines[9], "# no line end");
  CU_ASSERT_STRING_EQUAL(read.scene.materials[0].name, "rock");
  CU_ASSERT(read.scene.unitless);
  done(&read);
}

static void product(void) {
  static const char good[] = "sweep R 1 mm 2 mm\nsweep c 10 20 30\nlet law linear\nnormal $law\n" ROCK
                             "disc -$R 0 m radius $R rock\nstep 1 us\nstage go\ncycles $c\n";
  for (size_t run = 0; run < 6; run++) { /* the last sweep varies fastest */
    struct read read = read_scene(good, run, NULL);
    CU_ASSERT_EQUAL_FATAL(read.status, NB_OK);
    CU_ASSERT_EQUAL(read.scene.runs, 6);
    CU_ASSERT_EQUAL(read.scene.particles[0].radius, run < 3 ? 0.001 : 0.002);
    CU_ASSERT_EQUAL(read.scene.particles[0].x, -read.scene.particles[0].radius);
    CU_ASSERT_EQUAL(read.scene.stages[0].cycles, 10 * (run % 3 + 1));
    CU_ASSERT_EQUAL_FATAL(read.scene.binding_count, 3);
    CU_ASSERT_STRING_EQUAL(read.scene.bindings[0].text, run < 3 ? "1 mm" : "2 mm");
    CU_ASSERT(read.scene.bindings[0].swept && !read.scene.bindings[2].swept);
    done(&read);
  }
}

/* A sweep with several units is in SI, also if the last value has the unit of the first one. */
static void units_of_a_sweep(void) {
  static const char text[] =
      "sweep r 1 mm 2 cm 3 mm\n" ROCK "disc 0 m 0 m radius $r rock\nstep 1 us\nstage go\ncycles 1\n";
  static const char *const wanted[] = {"0.001 m", "0.02 m", "0.003 m"};
  for (size_t run = 0; run < 3; run++) {
    struct read read = read_scene(text, run, NULL);
    CU_ASSERT_EQUAL_FATAL(read.status, NB_OK);
    CU_ASSERT_STRING_EQUAL(read.scene.bindings[0].text, wanted[run]);
    done(&read);
  }
}

/* A minus sign before a value that has a sign itself. */
static void signs_of_values(void) {
  static const char text[] =
      "sweep a +5 m -5 m 3 m\n" ROCK "disc -$a 0 m radius 1 m rock\ndisc 0 m (-a) radius 1 m rock\n"
      "step 1 us\nstage go\ncycles 1\n";
  for (size_t run = 0; run < 3; run++) {
    struct read read = read_scene(text, run, NULL);
    CU_ASSERT_EQUAL_FATAL(read.status, NB_OK);
    CU_ASSERT_EQUAL(read.scene.particles[0].x, run == 1 ? 5 : run == 0 ? -5 : -3);
    CU_ASSERT_EQUAL(read.scene.particles[1].y, run == 1 ? 5 : run == 0 ? -5 : -3);
    done(&read);
  }
}

static void tuples(void) {
  static const char text[] =
      "sweep v with n  0.12 m/s 40  0.04 m/s 120\n" ROCK "disc 0 m 0 m radius 1 mm rock velocity $v $v\n"
      "step 1 us\nstage go\ncycles $n\n";
  for (size_t run = 0; run < 2; run++) {
    struct read read = read_scene(text, run, NULL);
    CU_ASSERT_EQUAL_FATAL(read.status, NB_OK);
    CU_ASSERT_EQUAL(read.scene.runs, 2);
    CU_ASSERT_EQUAL(read.scene.particles[0].vy, run ? 0.04 : 0.12);
    CU_ASSERT_EQUAL(read.scene.stages[0].cycles, run ? 120 : 40);
    done(&read);
  }
}

/* The words of a sweep may also be names of units. A unit follows a number only, in `let`, `sweep` and --set. */
static void words_that_are_units(void) {
  static const char text[] = "sweep at A m kg\nsweep on s rad\n" ROCK
                             "disc 0 m 0 m radius 1 m rock\nstep 1 us\nstage $at\ncycles 1\nstage $on\ncycles 1\n";
  static const char *const at[] = {"A", "m", "kg"}, *const on[] = {"s", "rad"};
  for (size_t run = 0; run < 6; run++) {
    struct read read = read_scene(text, run, NULL);
    CU_ASSERT_EQUAL_FATAL(read.status, NB_OK);
    CU_ASSERT_EQUAL(read.scene.runs, 6);
    CU_ASSERT_STRING_EQUAL(read.scene.stages[0].name, at[run / 2]);
    CU_ASSERT_STRING_EQUAL(read.scene.stages[1].name, on[run % 2]);
    done(&read);
  }
  const char *const set[] = {"on=s m", NULL};
  struct read read = read_scene(text, 0, set);
  CU_ASSERT(says(&read, "expected the end of the value, found `m`"));
  done(&read);
  read = read_scene("let a b m\n" ROCK "disc 0 m 0 m radius 1 m rock\nstep 1 us\nstage $a\ncycles 1\n", 0, NULL);
  CU_ASSERT(says(&read, "expected the end of the line, found `m`"));
  done(&read);
}

static void settings(void) {
  static const char text[] =
      "sweep v with n  1 m/s 40  2 m/s 120\nlet R = 1 mm\nlet s = 2\nshear none\n" ROCK
      "disc 0 m 0 m radius $R rock velocity $v $v\nstep 1 us\nstage go\ncycles $n\nstage on\nstep 2 us\ncycles 1\n";
  const char *const some[] = {"R=1 mm", "v=7 m/s", "R=3 mm # wider", "shear=linear", "step=0.1 of single-contact",
                              NULL};
  struct read read = read_scene(text, 1, some);
  CU_ASSERT_EQUAL_FATAL(read.status, NB_OK);
  CU_ASSERT_EQUAL(read.scene.runs, 2); /* the sweep of n still has two values */
  CU_ASSERT_EQUAL(read.scene.particles[0].vx, 7);
  CU_ASSERT_EQUAL(read.scene.particles[0].radius, 0.003); /* the last setting of a name is used */
  CU_ASSERT_EQUAL(read.scene.stages[0].cycles, 120);
  CU_ASSERT_EQUAL(read.scene.bindings[3].value, 2); /* `step=` only begins like the name s */
  CU_ASSERT_FALSE(read.scene.bindings[0].swept);
  CU_ASSERT_STRING_EQUAL(read.scene.shear, "linear");
  CU_ASSERT(read.scene.stages[1].step.kind == NB_STEP_SINGLE_CONTACT && read.scene.stages[1].step.value == 0.1);
  done(&read);
  const char *const all[] = {"v=7 m/s", "n=5", NULL};
  read = read_scene(text, 0, all);
  CU_ASSERT_EQUAL(read.scene.runs, 1);
  done(&read);
  const char *const second[] = {"n=120", NULL}; /* selects the second row by its second value */
  read = read_scene(text, 0, second);
  CU_ASSERT(read.status == NB_OK && read.scene.runs == 1 && read.scene.particles[0].vx == 2);
  done(&read);
  const char *const wrong[] = {"r=1 mm", NULL};
  read = read_scene(text, 0, wrong);
  CU_ASSERT(says(&read, "--set: error: ") && says(&read, "      | r=1 mm\n      | ^\n  hint: did you mean `R`?"));
  CU_ASSERT_EQUAL(read.scene.runs, 2);
  done(&read);
}

static void columns(void) {
  struct nb_binding value = {.name = "R", .text = "50 mm", .value = 0.05, .dimension = {60, 0, 0}};
  char line[] = "disc\t-$R \xC3\xBC $R# $R", *lines[] = {line}, path[] = "p";
  unsigned char kinds[] = {1};
  struct nb_mistakes mistakes = {0};
  struct nb_page page = {.path = path, .lines = lines, .line_count = 1, .kind_of = kinds};
  struct nb_reader *reader = calloc(1, sizeof *reader);
  CU_ASSERT_PTR_NOT_NULL_FATAL(reader);
  reader->page = &page;
  reader->mistakes = &mistakes;
  reader->bindings = &value;
  reader->binding_count = 1;
  CU_ASSERT(nb_line_read(reader, 1));
  static const struct {
    const char *text;
    int column, length;
  } wanted[] = {{"disc", 1, 4}, {"-50", 6, 3}, {"mm", 6, 3}, {"\xC3\xBC", 10, 1}, {"50", 12, 2}, {"mm", 12, 2}};
  CU_ASSERT_EQUAL_FATAL(reader->count, sizeof wanted / sizeof *wanted);
  for (size_t i = 0; i < reader->count; i++) {
    CU_ASSERT_STRING_EQUAL(reader->tokens[i].text, wanted[i].text);
    CU_ASSERT_EQUAL(reader->tokens[i].column, wanted[i].column);
    CU_ASSERT_EQUAL(reader->tokens[i].length, wanted[i].length);
  }
  CU_ASSERT_EQUAL(mistakes.count, 0);
  free(reader);
}

static void order(void) { /* mistakes are listed in the order of the page */
  char one[] = "one", two[] = "two", *lines[] = {one, two}, path[] = "p";
  unsigned char kinds[] = {1, 1};
  struct nb_mistakes mistakes = {0};
  struct nb_page page = {.path = path, .lines = lines, .line_count = 2, .kind_of = kinds};
  nb_mistake(&mistakes, &page, 2, 1, 1, NULL, "c");
  nb_mistake(&mistakes, &page, 1, 2, 2, "h", "b");
  nb_mistake(&mistakes, &page, 1, 1, 1, NULL, "a");
  CU_ASSERT_EQUAL(mistakes.count, 3);
  CU_ASSERT_STRING_EQUAL(mistakes.text, "p:1:1: error: a\n    1 | one\n      | ^\n"
                                        "p:1:2: error: b\n    1 | one\n      |  ^~\n  hint: h\n"
                                        "p:2:1: error: c\n    2 | two\n      | ^\n");
  for (int i = 1; i <= 1100; i++)
    nb_mistake(&mistakes, &page, 2, i, 1, NULL, "d");
  CU_ASSERT_EQUAL(mistakes.count, 1001);
  nb_mistakes_free(&mistakes);
}

/* A space inside parentheses does not end a word. A parenthesis that closes nothing does not count. */
static void words_with_parentheses(void) {
  static const char *const rows[][2] = {{"skin )(1 mm + 2 mm) b", "found `)(1 mm + 2 mm)`"},
                                        {"skin ((1 mm) + 2 mm))( b", "expected a space after `)`, found `)( b`"},
                                        {"skin x(1 mm) b", "found `x(1 mm)`"}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct read read = read_scene(rows[k][0], 0, NULL);
    CU_ASSERT(says(&read, rows[k][1]));
    done(&read);
  }
}

static void limits_of_size(void) {
  size_t size = NB_PAGE_MAX + 1;
  char *large = malloc(size);
  CU_ASSERT_PTR_NOT_NULL_FATAL(large);
  memset(large, '\n', size);
  struct read read = read_bytes(large, size, 0, NULL);
  CU_ASSERT(says(&read, "expected at most 4194304 bytes, found 4194305"));
  done(&read);
  memset(large, 'x', NB_LINE_MAX + 1);
  read = read_bytes(large, NB_LINE_MAX, 0, NULL);
  CU_ASSERT_FALSE(says(&read, "bytes in a line"));
  done(&read);
  read = read_bytes(large, NB_LINE_MAX + 1, 0, NULL);
  CU_ASSERT(says(&read, "expected at most 4096 bytes in a line, found 4097"));
  done(&read);
  free(large);
}

static void table(void) {
  char syntax[512];
  const struct nb_keyword *row;
  for (size_t k = 0; (row = nb_keyword_row(nb_keywords(), k)); k++) {
    size_t length = strlen(row->help);
    int count = 0;
    CU_ASSERT(length > 0 && row->help[length - 1] == '.');
    for (const struct nb_argument *a = row->arguments; a->count; a++, count++)
      CU_ASSERT(a->help[0] && a->slot >= 0 && a->slot + a->count <= NB_SLOTS);
    CU_ASSERT(count < 32); /* each argument is a bit of reader->given */
    nb_keyword_syntax(syntax, sizeof syntax, row);
    CU_ASSERT_EQUAL(strncmp(syntax, row->word, strlen(row->word)), 0);
    if (strcmp(row->word, "sphere") == 0)
      CU_ASSERT_STRING_EQUAL(syntax, "sphere X Y radius R MATERIAL {velocity VX VY} {spin W} {fixed}");
  }
}

/* A known word is suggested if at most one letter differs in a word of 3 to 5 letters, two in a word of 6 to 9 letters, or
 * three in a longer word. */
static void suggested_words(void) {
  static const char word[] = "bcdfghjklmnp";
  for (size_t length = 1; length <= 12; length++)
    for (size_t wrong = 0; wrong <= 4 && wrong <= length; wrong++) {
      char known[16], typed[16];
      snprintf(known, sizeof known, "%.*s", (int)length, word);
      snprintf(typed, sizeof typed, "%.*s", (int)length, word);
      for (size_t k = 0; k < wrong; k++)
        typed[length - 1 - k] = 'z';
      struct nb_guess guess = nb_guess_begin(typed);
      nb_guess_offer(&guess, known);
      const size_t allowed = length < 3 ? 0 : length < 6 ? 1 : length < 10 ? 2 : 3;
      CU_ASSERT_EQUAL(nb_guess_found(&guess), wrong <= allowed);
    }
}

#define LONG "wwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwww"

/* A letter too many, a missing letter, another letter and two exchanged letters are one error each. Upper and lower case
 * are equal. A very long word is near to none. */
static void kinds_of_typing_errors(void) {
  static const struct {
    const char *typed, *known;
    bool found;
  } rows[] = {{"walls", "wall", true},      {"wal", "wall", true},       {"all", "wall", true},
              {"wxll", "wall", true},       {"wlal", "wall", true},      {"awll", "wall", true},
              {"WALL", "wall", true},       {"wall", "waller", false},   {"wallr", "wal", false},
              {"llwa", "wall", false},      {"wxxl", "wall", false},     {"xxall", "wall", false},
              {"lwal", "wall", false},      {"gravty", "gravity", true}, {"ravty", "gravity", false},
              {"rgavtiy", "gravity", true}, {"wal", "walx", true},       {"wabl", "wxal", false},
              {"awhs", "wash", false},      {"hsaw", "wash", false},     {LONG LONG LONG, "wall", false}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_guess guess = nb_guess_begin(rows[k].typed);
    nb_guess_offer(&guess, rows[k].known);
    CU_ASSERT_EQUAL(nb_guess_found(&guess), rows[k].found);
  }
}

/* A part of a name with dots, of at least three letters, leads to the whole name, and its last part, of at least two,
 * is found in a longer name. */
static void parts_of_names(void) {
  static const struct {
    const char *typed, *known;
    bool found;
  } rows[] = {{"energy", "energy.kinetic", true}, {"kinetic", "energy.kinetic", true},
              {"normal", "M.normal.max", true},   {"max", "M.normal.max", true},
              {"nor", "M.normal.max", false},     {"yy", "M.stress.yy", false},
              {"stress.yy", "yy", true},          {"stress.y", "y", false},
              {"stress.yy", "xx", false},         {"ener", "energy.kinetic", false}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    struct nb_guess guess = nb_guess_begin(rows[k].typed);
    nb_guess_offer(&guess, rows[k].known);
    CU_ASSERT_EQUAL(nb_guess_found(&guess), rows[k].found);
  }
}

/* Words of other programs: with another separator, in capitals, in the plural, or with arguments. A letter alone is
 * another word as a capital: `g` is gravity, and `G` the shear modulus. */
static void spellings_of_other_programs(void) {
  static const char *const same[] = {"friction_angle", "friction-angle",  "friction angle",    "friction.angle",
                                     "Friction_Angle", "friction_angles", "friction_angle(2)", "FRICTION_ANGLE"};
  const struct nb_synonym *const angle = nb_synonym(same[0]);
  CU_ASSERT_PTR_NOT_NULL_FATAL(angle);
  for (size_t k = 0; k < sizeof same / sizeof *same; k++)
    CU_ASSERT_PTR_EQUAL(nb_synonym(same[k]), angle);
  CU_ASSERT_PTR_NULL(nb_synonym("friction_anglesx"));
  CU_ASSERT_STRING_EQUAL(nb_synonym("psds")->ours,
                         "grading"); /* of `psd`; the plural of two letters would be too short */
  CU_ASSERT_PTR_NULL(nb_synonym("mus"));
  CU_ASSERT_PTR_NULL(nb_synonym(""));
  CU_ASSERT_STRING_EQUAL(nb_synonym("g")->ours, "gravity");
  CU_ASSERT_STRING_EQUAL(nb_synonym("G")->ours, "young");
}

void suite_reader(void) {
  CU_pSuite suite = CU_add_suite("reader", NULL, NULL);
  CU_add_test(suite, "texts that are numbers, and texts that are not", numbers);
  CU_add_test(suite, "blocks of a page", blocks);
  CU_add_test(suite, "fences, and blocks that are not read", fences);
  CU_add_test(suite, "names of pages", names_of_pages);
  CU_add_test(suite, "title of a page", titles);
  CU_add_test(suite, "parts of names", parts_of_names);
  CU_add_test(suite, "spellings of words of other programs", spellings_of_other_programs);
  CU_add_test(suite, "hash of a page", hash);
  CU_add_test(suite, "line ends of DOS", line_ends);
  CU_add_test(suite, "several sweeps give all combinations of their values", product);
  CU_add_test(suite, "a sweep of several names", tuples);
  CU_add_test(suite, "a sweep with several units", units_of_a_sweep);
  CU_add_test(suite, "words that are units", words_that_are_units);
  CU_add_test(suite, "a minus before a value with a sign", signs_of_values);
  CU_add_test(suite, "--set replaces values, a law and the step", settings);
  CU_add_test(suite, "typing errors with which a word is still suggested", suggested_words);
  CU_add_test(suite, "kinds of typing errors", kinds_of_typing_errors);
  CU_add_test(suite, "columns of tokens after a $NAME", columns);
  CU_add_test(suite, "messages are in line order, and at most 1001", order);
  CU_add_test(suite, "limits of size", limits_of_size);
  CU_add_test(suite, "words with parentheses", words_with_parentheses);
  CU_add_test(suite, "the table of keywords", table);
}
