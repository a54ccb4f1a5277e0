/* The manual of the page language, made from the tables by which the program reads pages: statements, expectations,
 * quantities, units. As Markdown it is docs/LANGUAGE.md, from which docs/man.sh makes the manual page. On a terminal it
 * is `nineball --help scene`, and for one word `nineball --help WORD`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "commands.h"
#include "core/clean.h"
#include "core/names.h"
#include "expect.h"
#include "input/expression.h"
#include "input/old_words.h"
#include "laws/law.h"
#include "reference.h"

/* Output file and format. */
struct manual {
  FILE *out;
  bool markdown;      /* true: Markdown; false: text for a terminal */
  bool whole;         /* prints the arguments of every statement, and examples */
  const void **shown; /* the rows that have been printed, up to a NULL; only for the help on words */
};

static bool is_new(const struct manual *to, const void *row) {
  const void **at = to->shown;
  while (*at && *at != row)
    at++;
  const bool is = !*at;
  *at = row;
  return is;
}

/* ---- formatting ---- */

/* Prints the text in lines of at most 100 characters; the first line begins at column `first`, the other lines at
 * column `other`. */
static void wrapped(FILE *out, int first, int other, const char *text) {
  enum { WIDEST = 100 };
  int column = first;
  fprintf(out, "%*s", first, "");
  for (const char *word = text; *word;) {
    const size_t length = strcspn(word, " ");
    int letters = 0;
    for (size_t k = 0; k < length; k++)
      letters += (word[k] & 0xC0) != 0x80;
    if (word > text && column + 1 + letters > WIDEST) {
      fprintf(out, "\n%*s", other, "");
      column = other;
    } else if (word > text) {
      fputc(' ', out);
      column++;
    }
    fwrite(word, 1, length, out);
    column += letters;
    word += length + strspn(word + length, " ");
  }
  fputc('\n', out);
}

static void section(const struct manual *to, const char *title) {
  fprintf(to->out, to->markdown ? "## %s\n\n" : "\n%s\n\n", title);
}

static void end(const struct manual *to) { fputc('\n', to->out); }

static void paragraph(const struct manual *to, const char *text) {
  if (to->markdown)
    fprintf(to->out, "%s\n", text);
  else
    wrapped(to->out, 2, 2, text);
  end(to);
}

/* Prints a list item, such as an argument of a statement; `unit` may be NULL. */
static void part(const struct manual *to, const char *name, const char *unit, const char *text) {
  char line[2048];
  snprintf(line, sizeof line, to->markdown ? "- `%s`%s%s: %s" : "%s%s%s: %s", name, unit ? ", " : "", unit ? unit : "",
           text);
  if (to->markdown)
    fprintf(to->out, "%s\n", line);
  else
    wrapped(to->out, 8, 10, line);
}

static void item(const struct manual *to, const char *word, const char *syntax, const char *help) {
  if (to->markdown) {
    fprintf(to->out, "### %s\n\n`%s`\n\n%s\n\n", word, syntax, help);
    return;
  }
  wrapped(to->out, 2, 4, syntax);
  wrapped(to->out, 6, 6, help);
}

/* Prints an example: lines of a block of the kind `block`. The last line has no newline. */
static void example(const struct manual *to, const char *block, const char *lines) {
  if (to->markdown) {
    fprintf(to->out, "\n```%s\n%s\n```\n", block, lines);
    return;
  }
  for (const char *line = lines; *line; line += strcspn(line, "\n"), line += *line == '\n')
    fprintf(to->out, "%s        %.*s\n", line == lines ? "\n" : "", (int)strcspn(line, "\n"), line);
}

/* ---- one statement ---- */

/* True if the word occurs in a line of syntax: `ratio` in "damping {walls} stiffness TIME|ratio X". */
static bool has_word(const char *syntax, const char *word) {
  static const char between[] = " {}[]|";
  for (size_t length; *syntax; syntax += length + strspn(syntax + length, between)) {
    length = strcspn(syntax, between);
    if (length == strlen(word) && strncmp(syntax, word, length) == 0)
      return true;
  }
  return false;
}

/* Length of the first sentence. A full stop without a space after it, as in the number of an equation, does not end a
 * sentence. */
static int first_sentence(const char *help) {
  const char *end = strstr(help, ". ");
  const size_t all = strlen(help);
  return (int)(end ? (size_t)(end - help) : all - (all > 0 && help[all - 1] == '.'));
}

/* Prints an argument: "a length above 0; without it: 2R. Distance of the centres; at 2R they touch." */
static void argument(const struct manual *to, const struct nb_argument *field) {
  char name[128], text[1024];
  const int first = first_sentence(field->help);
  snprintf(name, sizeof name, "%s%s%s", field->word ? field->word : "", field->word && field->value ? " " : "",
           field->value ? field->value : "");
  const bool number = field->kind == NB_ARGUMENT_NUMBER, count = field->kind == NB_ARGUMENT_COUNT;
  char otherwise[128] = "";
  if (field->otherwise)
    snprintf(otherwise, sizeof otherwise, "; without it: %s", field->otherwise + strspn(field->otherwise, "|+"));
  if (number || count)
    snprintf(text, sizeof text, "%s%s%s%s. %s", number ? nb_unit_kind_name(field->unit) : "a whole number, 1 or more",
             field->count > 1 ? " each" : "", number ? nb_range_words(field->range) : "", otherwise, field->help);
  else
    snprintf(text, sizeof text, "%.*s%s.%s", first, field->help, otherwise,
             field->help[first] == '.' ? field->help + first + 1 : "");
  part(to, name, NULL, text);
}

/* Prints the parts of a statement's tail (struct nb_keyword). They are the lines of the help after the first one,
 * "NAME: TEXT". `word`: prints only parts with this word in their names; NULL: all. Returns true if there was one. */
static bool tail_parts(const struct manual *to, const char *help, const char *word) {
  bool found = false;
  for (const char *line = strchr(help, '\n'); line; line = strchr(line, '\n')) {
    char name[128], text[512];
    line++;
    const char *const colon = strstr(line, ": ");
    snprintf(name, sizeof name, "%.*s", (int)(colon - line), line);
    snprintf(text, sizeof text, "%.*s", (int)strcspn(colon + 2, "\n"), colon + 2);
    if (word && !has_word(name, word))
      continue;
    part(to, name, NULL, text);
    found = true;
  }
  return found;
}

/* Appends where a statement may stand: " Place: the scene; a stage." */
static void append_place(char *text, size_t size, unsigned where) {
  static const struct {
    unsigned all, none; /* flags that the statement must have, and flags that it must not have */
    const char *words;
  } places[] = {
      {NB_IN_SCENE, 0, "the scene"},
      {NB_IN_START, 0, "a page with `start`, before its first stage"},
      {NB_IN_STAGE, 0, "a stage"},
      {NB_IN_RAMP, 0, "after `ramp`"},
      {NB_IN_CONTACT_TEST, NB_IN_SEGMENT, "a contact test, before its first segment"},
      {NB_IN_CONTACT_TEST | NB_IN_SEGMENT, 0, "a contact test"},
      {NB_IN_SEGMENT, NB_IN_CONTACT_TEST, "a segment of a contact test"},
  };
  const char *between = " Place: ", *end = "";
  for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
    const size_t used = strlen(text);
    if ((where & places[k].all) != places[k].all || where & places[k].none)
      continue;
    snprintf(text + used, size - used, "%s%s", between, places[k].words);
    between = "; ", end = ".";
  }
  const size_t used = strlen(text);
  snprintf(text + used, size - used, "%s", end);
}

/* The kind of block for the example of a statement. The examples of scenes and expectations together make
 * docs/LANGUAGE.md a page that can be run; other examples are blocks of text. */
static const char *block_of(const struct nb_keyword *keyword) {
  return keyword->where == NB_IN_EXPECT                 ? "expect"
         : keyword->where & NB_IN_CELL                  ? "text of a scene with a cell"
         : keyword->where & NB_OWN_EXAMPLE              ? "text of another page"
         : keyword->where & (NB_IN_SCENE | NB_IN_STAGE) ? "scene"
                                                        : "text of a contact test";
}

static void statement(const struct manual *to, const struct nb_keyword *keyword) {
  char syntax[512], help[2048];
  nb_keyword_syntax(syntax, sizeof syntax, keyword);
  snprintf(help, sizeof help, "%.*s", (int)strcspn(keyword->help, "\n"), keyword->help);
  append_place(help, sizeof help, keyword->where);
  item(to, keyword->word, syntax, help);
  if (!to->whole)
    return;
  for (const struct nb_argument *field = keyword->arguments; field->count; field++)
    argument(to, field);
  tail_parts(to, keyword->help, NULL);
  if (keyword->example)
    example(to, block_of(keyword), keyword->example);
  end(to);
}

static void expectation(const struct manual *to, const struct nb_expectation_row *row) {
  item(to, row->word, row->syntax, row->help);
  if (!to->whole)
    return;
  example(to, "expect", row->example);
  end(to);
}

/* ---- lists ---- */

static void measures(const struct manual *to) {
  paragraph(
      to, "A MEASURE is `QUANTITY {REDUCER} {in STAGE}`: a quantity that the page records, and how the rows of a stage "
          "become one number. Without `in STAGE` the rows are those of the last stage that has rows, and for `at` "
          "those of all stages. REDUCER is one of:");
  for (const struct nb_reducer_row *row = nb_reducer_rows(); row->word; row++)
    part(to, row->word, NULL, row->help);
  end(to);
}

static void expectations(const struct manual *to) {
  const struct nb_keyword *keyword;
  section(to, "Expectations");
  measures(to);
  for (size_t k = 0; (keyword = nb_keyword_row(nb_expect_keywords(), k)); k++)
    if (keyword->word)
      statement(to, keyword);
  for (const struct nb_expectation_row *row = nb_expectation_rows(); row->word; row++)
    expectation(to, row);
}

static void figures(const struct manual *to) {
  static const char *const given[][2] = {
      {"$table",
       "the recorded rows of all stages of the run. `column('C.normal/N')` selects a column by its head. The column "
       "`stage` has the name of the stage of each row: `using (strcol('stage') eq 'load' ? column('time/s') : "
       "NaN):'C.normal/N'` plots only the rows of the stage `load`; in a contact test it has the name of the segment. "
       "The column `reference C.normal/N` has the reference at every row, for a quantity that an expectation compares "
       "with `versus`. With a sweep there is one table for each run, `$table_1`, `$table_2`, …, also when `--set` "
       "leaves only one value"},
      {"$values", "one row for each run: the swept values, then the computed value and the reference of every measure "
                  "of the expect blocks. The head of a column has the name and the unit, `v/m/s`, `C.normal max/N`, "
                  "`reference C.normal max/N`; `last` is left out: `M.porosity in load/-`"},
      {"runs", "the number of runs; `run[i]` are the swept values of run i: \"v=0.12, n=40\""},
      {"C_normal_max", "a variable for each measure of the expect blocks, here `C.normal max`: any character but a "
                       "letter or a digit becomes `_`. With a sweep `C_normal_max_1`, …"},
      {"reference_C_normal_max",
       "a variable for each value that the reference returns, with its name formed in the same way. There is none if "
       "the name would have more than 49 characters, because gnuplot would cut it"},
      {"$STAGE_particles",
       "the particles of a snapshot; also `$STAGE_walls` and `$STAGE_contacts`, with a boundary `$STAGE_boundary`, "
       "with rings of a region `$STAGE_rings`, with `snapshot from` `$STAGE_lattice`. A contact test has "
       "`$SEGMENT_traction` and `$SEGMENT_pieces` instead. With a sweep `$STAGE_particles_1`, …"},
      {"plots", "the folder of the recipes. A recipe needs the names of its data: for a stage `load` with `snapshot`, "
                "`particles = '$load_particles'; contacts = '$load_contacts'`, then `load plots.'force-chains.gp'`"},
      {"terminal", "SVG, then PNG, of 840 by 560 points; the program sets it and the output file. `eval canvas(1100, "
                   "760)` sets another size"},
  };
  section(to, "Figures");
  paragraph(to, "The blocks `gnuplot` of a page are a gnuplot script, which `nineball figure` and `report` run. Before "
                "the script gnuplot reads the style, plots/style.gp (colours as line types 1 to 6, tab-separated data "
                "with a head row). Because of the head rows gnuplot leaves out the first sample of `'+'`: begin its "
                "range one sample earlier, or plot a function. The legend is above the figure; `set key inside bottom "
                "right vertical` moves it. These names are defined:");
  for (size_t k = 0; k < sizeof given / sizeof *given; k++)
    part(to, given[k][0], NULL, given[k][1]);
  if (to->whole)
    example(to, "gnuplot",
            "set xlabel 'overlap, um'\nset ylabel 'normal force, N'\n"
            "plot for [i=1:runs] sprintf('$table_%d', i) using (column('C.overlap/m')*1e6):'C.normal/N' with lines "
            "title run[i]\n"
            "\n"
            "set key inside bottom right vertical\n"
            "set logscale x\n"
            "plot $values using 'v/m/s':'C.normal max/N' with points title 'computed', \\\n"
            "     $values using 'v/m/s':'reference C.normal max/N' with lines title 'reference'");
  end(to);
}

/* Prints the quantities of one owner, from row k on. */
static void quantities_of(const struct manual *to, const char *owner, size_t k) {
  struct nb_quantity_row row;
  char text[64];
  snprintf(text, sizeof text, "Of %s:", owner);
  paragraph(to, text);
  for (; nb_quantity_row(&row, k); k++)
    if (strcmp(row.of, owner) == 0)
      part(to, row.name, strcmp(row.unit, "1") == 0 ? NULL : row.unit, row.help);
  end(to);
}

static void quantities(const struct manual *to) {
  enum { OWNERS_MAX = 16 };
  struct nb_quantity_row row;
  const char *owners[OWNERS_MAX]; /* owners that have been printed */
  size_t count = 0;
  section(to, "Quantities");
  paragraph(to,
            "These quantities are for `record`, `until` and expectations. A quantity of the whole scene is written by "
            "its name alone, a quantity of a monitored particle, contact, wall, grading or region as `MONITOR.NAME`.");
  for (size_t k = 0; nb_quantity_row(&row, k); k++) {
    size_t o = 0;
    while (o < count && strcmp(owners[o], row.of) != 0)
      o++;
    if (o < count || count == OWNERS_MAX)
      continue;
    owners[count++] = row.of;
    quantities_of(to, row.of, k);
  }
}

/* Prints one line for the family of row k, `energy: .kinetic, .stored, …`, unless an earlier row is of the same family. */
static void family(const struct manual *to, const struct nb_quantity_row *rows, size_t count, size_t k) {
  enum { WIDEST = 80 };
  const size_t length = strcspn(rows[k].name, ".");
  const char *between = rows[k].name[length] ? ": " : ", ";
  char line[2 * WIDEST];
  snprintf(line, sizeof line, "%.*s", (int)length, rows[k].name);
  for (size_t j = 0; j < count; j++) {
    const bool same = strcmp(rows[j].of, rows[k].of) == 0 && strcspn(rows[j].name, ".") == length &&
                      strncmp(rows[j].name, rows[k].name, length) == 0;
    if (same && j < k)
      return;
    if (!same || !rows[j].name[length] || !*between)
      continue;
    const bool more = strlen(line) + strlen(rows[j].name + length) > WIDEST;
    nb_append(line, sizeof line, "%s%s", more ? ", " : between, more ? "…" : rows[j].name + length);
    between = more ? "" : ", ";
  }
  if (rows[k].name[length])
    fprintf(to->out, "        %s\n", line);
  else
    part(to, line, NULL, rows[k].help);
}

/* Prints an overview of the quantities: one line for each family. */
static void families(const struct manual *to) {
  enum { MOST = 1000 };
  struct nb_quantity_row *rows = calloc(MOST, sizeof *rows);
  size_t count = 0;
  while (rows && count < MOST && nb_quantity_row(&rows[count], count))
    count++;
  paragraph(to, "Quantities for `record`, `until` and expectations, by families. `nineball --help quantities FAMILY` "
                "describes each quantity of a family, such as `nineball --help quantities stress`.");
  for (size_t k = 0; k < count; k++) {
    size_t before = 0;
    while (strcmp(rows[before].of, rows[k].of) != 0)
      before++;
    if (before < k)
      continue;
    fprintf(to->out, "  Of %s", rows[k].of);
    fprintf(to->out, rows[k].statement ? ", `%s`, written `%sNAME`:\n" : ":\n", rows[k].statement, rows[k].prefix);
    for (size_t j = k; j < count; j++)
      if (strcmp(rows[j].of, rows[k].of) == 0)
        family(to, rows, count, j);
  }
  free(rows);
}

static void values(const struct manual *to) {
  char text[1024];
  section(to, "Numbers, units and expressions");
  paragraph(to, "A value in a statement is a number with its sign, `$NAME` or `-$NAME`, or an expression in "
                "parentheses; one unit may follow each. Operators and functions stand in parentheses: `radius (R/2)`, "
                "`cycles (2*n)`, `velocity (v*cos(angle)) m/s 0 m/s`. Where a whole number is needed, the value of an "
                "expression may differ from it by rounding, that is by up to 1e-12 of it: `cycles (0.1 ms/dt)`.");
  paragraph(to,
            "A unit is one word after a space. It is made of m, s, g, N, Pa, J, rad and deg, with a prefix n, u or µ, "
            "m, c, k, M, G (deg has none) and powers from 1 to 9. These are joined by `.` (times) and `/` (over): `0.3 "
            "mm`, `2.7 g/cm3`, `4 N.m`, `5 1/s`. `%` and `ppm` are factors, rad is 1 and deg is pi/180. `0.3 mm` is "
            "the double nearest to 0.0003: all units but deg are powers of ten of the SI unit. With `units none` all "
            "numbers are written without a unit; `%` and `ppm` may still follow them, and angles are radians.");
  snprintf(
      text, sizeof text,
      "Expressions are in parentheses, after `let NAME =` and in `--set NAME=`. In them NAME without `$` is the value "
      "that `let` or `sweep` gives to it. The constant is `pi`, and the functions are %s. Operators, highest "
      "precedence first: a unit; `^`, from right to left; a sign, so that -2^2 is -4; `*` and `/`; `+` and `-`. The "
      "power of a value with a unit is written `(3 mm)^2`: `3 mm^2`, which may also mean `3 mm2`, is refused. A number "
      "and a name side by side are not multiplied: `2 N` is two newtons, and `2*N` is twice the value of the name N.",
      nb_function_names);
  paragraph(to, text);
  paragraph(
      to,
      "Dimensions are checked: both sides of `+` and `-` must have the same one, and so must the arguments of hypot, "
      "atan2, min and max. Exponents and the arguments of other functions are numbers, except those of sqrt and abs. "
      "An angle or an angular velocity that is written as a number needs its unit, `30 deg` or `2 rad/s`. The value of "
      "an expression for an angle may also be a number without unit, and the value of one for an angular velocity may "
      "be in 1/s. Expressions are computed in double precision, operation by operation as they are written. The C "
      "library computes functions and powers. A value that is not finite is a mistake.");
  paragraph(to, "Units that are usual for each kind of number:");
  for (int kind = 0; kind < NB_UNIT_KINDS; kind++)
    part(to, nb_unit_kind_name((enum nb_unit_kind)kind), NULL,
         kind == NB_UNIT_NUMBER ? "without a unit, or with % or ppm" : nb_unit_list((enum nb_unit_kind)kind));
  end(to);
}

static void grammar(const struct manual *to) {
  char text[1024];
  section(to, "Words");
  paragraph(to, "A page is a Markdown file. The program reads its fenced blocks `scene` or `contact-test`, `expect` "
                "and `gnuplot`; all else is prose. Several blocks of one kind are read as one block, in their order. A "
                "statement is one line of words with spaces between them; `#` begins a comment.");
  paragraph(
      to,
      "Each section shows the syntax of a statement, what it does, where it may stand, its arguments and an "
      "example. In the syntax, CAPITALS stand for a value, a part in `{...}` may be left out, and `a|b` means a or "
      "b. Clauses (a word and its values) may be in any order; only `every N cycles` of `servo` is always the last. "
      "In the list of arguments, `without it` gives the default; an argument without default is required, unless "
      "`|` in the syntax makes it one of several. `$NAME` stands for the value that a line `let` or `sweep` above "
      "gives to NAME.");
  snprintf(text, sizeof text,
           "A name has fewer than %d characters. It begins with a letter (a to z, A to Z); letters, digits, `_` and "
           "`-` may follow, but the name of a value has no `-`. A number is decimal: `-1.5e3`. A page may have at most "
           "%d MiB, lines of %d bytes and %d "
           "words, %d runs, %d particles, %d materials, and %d of each other thing that has a name. All lines with a "
           "mistake are reported at once, most of them up to their first mistake. Each message "
           "says the line, what was expected and, if a known word is similar, the word that was probably meant.",
           NB_NAME_SIZE, NB_PAGE_MAX >> 20, NB_LINE_MAX, NB_TOKENS_MAX - 1, NB_RUNS_MAX, NB_PARTICLES_MAX,
           NB_MATERIALS_MAX, NB_NAMED_MAX);
  paragraph(to, text);
  paragraph(to, "`Place` says where a statement may stand. The scene is the part of the page before the first `stage`. "
                "In a page with `start` the scene is short, because most of it comes from the other page. A stage is "
                "everything below a line `stage NAME`, up to the next `stage`; a segment of a contact test likewise.");
}

/* Prints the four ways to impose a strain. */
static void strains(const struct manual *to) {
  static const char *const rows[][2] = {
      {"cell strain", "moves the periodic cell and, with it, all particles. For a sample without walls or edges: "
                      "compression and shear at uniform strain. Needs `periodic cell`."},
      {"box strain", "moves the four walls of a box, without shear; the walls push the particles. For a biaxial test "
                     "between walls, as in the laboratory. Needs `box`."},
      {"boundary strain", "moves the outermost particles of an assembly; contacts carry the motion inwards. For the "
                          "round assemblies of the thesis. Needs `boundary circle`."},
      {"affine strain",
       "moves the free particles inside, in addition to their own motion. Use it with `boundary strain` at the same "
       "rate, so that the assembly deforms as a whole at once. Needs no other statement; not possible with a cell."},
  };
  section(to, "Which strain");
  paragraph(
      to,
      "Four statements of a stage impose a strain rate. The list says what each of them moves, and when to use it:");
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    part(to, rows[k][0], NULL, rows[k][1]);
  end(to);
  paragraph(to, "Strains count from the start of the run. With `region S all from STAGE`, `S.strain.xx` and "
                "`S.strain.yy` count from the beginning of STAGE. The height of a box after one stage and after an "
                "earlier one is compared in a block `expect`: `box.height last in LATER  expected 0.98 of box.height "
                "last in EARLIER within 1 % [SOURCE]`; `box.width` likewise.");
}

/* Prints the statements that are allowed in `here` and not in `there`. */
static void statements(const struct manual *to, const struct nb_family *table, unsigned here, unsigned there) {
  const struct nb_keyword *keyword;
  for (size_t k = 0; (keyword = nb_keyword_row(table, k)); k++)
    if (keyword->word && keyword->where & here && !(keyword->where & there))
      statement(to, keyword);
}

/* The statements of contact tests. */
static void contact_tests(const struct manual *to) {
  section(to, "Contact test");
  paragraph(to, "A page with a block `contact-test` instead of `scene` tests one contact: it prescribes approach and "
                "slip, or forces. There is no motion and no time. In an expectation the name of a segment stands in "
                "place of a stage: `shear max in load`.");
  statements(to, nb_keywords(), NB_IN_CONTACT_TEST | NB_IN_SEGMENT, NB_IN_SCENE | NB_IN_STAGE);
}

void nb_manual(FILE *out, bool markdown) {
  const struct manual to = {out, markdown, markdown, NULL};
  if (markdown)
    fputs("# The language of pages\n\n"
          "This document lists all words of pages. The program writes it from the tables with which it reads pages; "
          "`make language` renews it. The document is itself a page: its examples, one after the other, are a scene, "
          "and `nineball explain docs/LANGUAGE.md` shows what this scene would run. On the terminal `nineball --help "
          "scene` prints a short form of it, and `nineball --help disc` describes one word. [GLOSSARY.md](GLOSSARY.md) "
          "explains "
          "the terms of the field.\n\n",
          out);
  grammar(&to);
  section(&to, "The scene");
  statements(&to, nb_keywords(), NB_IN_SCENE, 0);
  section(&to, "In a stage");
  statements(&to, nb_keywords(), NB_IN_STAGE, NB_IN_SCENE);
  strains(&to);
  contact_tests(&to);
  expectations(&to);
  figures(&to);
  quantities(&to);
  values(&to);
}

/* ---- one word ---- */

/* The first argument that has this word; if there is none, the last row, with count 0. */
static const struct nb_argument *clause_of(const struct nb_keyword *row, const char *word) {
  const struct nb_argument *field = row->arguments;
  while (field->count && !(field->word && has_word(field->word, word)))
    field++;
  return field;
}

/* Prints the syntax, and the arguments whose clause has the word; if there are none, the help. */
static void statement_part(const struct manual *to, const struct nb_keyword *row, const char *syntax,
                           const char *word) {
  const struct nb_argument *field = clause_of(row, word);
  if (!is_new(to, (const char *)row + (field->count ? 1 + (field - row->arguments) : 0)))
    return;
  wrapped(to->out, 2, 4, syntax);
  if (!field->count && !tail_parts(to, row->help, word)) {
    char help[2048];
    snprintf(help, sizeof help, "%.*s", (int)strcspn(row->help, "\n"), row->help);
    wrapped(to->out, 6, 6, help);
  }
  for (; field->count; field++)
    if (field->word && has_word(field->word, word))
      argument(to, field);
}

/* Prints the statements that begin with the word. For statements with the word inside their syntax, prints the syntax
 * and the argument, or the help. False: there are none. */
static bool find_statement(const struct manual *to, const char *word, struct nb_guess *guess) {
  const struct nb_family *const tables[] = {nb_keywords(), nb_expect_keywords()};
  const struct nb_keyword *row;
  char first[NB_NAME_SIZE], syntax[512];
  bool found = false;
  for (int t = 0; t < 6; t++) /* three times through both tables: first words, then clauses, then the words of tails */
    for (size_t k = 0; (row = nb_keyword_row(tables[t % 2], k)); k++) {
      nb_first_word(first, row->word ? row->word : "");
      nb_guess_offer(guess, first);
      nb_keyword_syntax(syntax, sizeof syntax, row);
      const bool verb = strcmp(first, word) == 0 || (row->word && strcmp(row->word, word) == 0);
      if (!row->word || !(verb || has_word(syntax, word)) || t / 2 != (verb ? 0 : clause_of(row, word)->count ? 1 : 2))
        continue;
      found = true;
      if (!verb)
        statement_part(to, row, syntax, word);
      else if (is_new(to, row))
        statement(to, row);
    }
  return found;
}

/* Prints expectations and reducers with the word in their syntax. False: there are none. */
static bool find_expectation(const struct manual *to, const char *word, struct nb_guess *guess) {
  const struct manual brief = {to->out, false, false, to->shown};
  bool found = false;
  for (const struct nb_expectation_row *row = nb_expectation_rows(); row->word; row++) {
    nb_guess_offer(guess, row->word);
    const bool is = has_word(row->syntax, word);
    if (is && is_new(to, row))
      expectation(strcmp(row->word, word) == 0 ? to : &brief, row);
    found = found || is;
  }
  for (const struct nb_reducer_row *row = nb_reducer_rows(); row->word; row++)
    if (has_word(row->word, word))
      part(to, row->word, "after the quantity of an expectation", row->help), found = true;
  return found;
}

/* Prints the statement that names the owner of a quantity, unless it is `last`, the statement of the previous quantity.
 * Returns the statement. */
static const char *own_line(const struct manual *to, const struct nb_quantity_row *row, const char *last) {
  if (row->statement && row->statement != last)
    fprintf(to->out, "  `%s`, then `%s%s`\n", row->statement, row->prefix, row->name);
  return row->statement;
}

/* Prints the quantities whose name is the word (`C.normal`, `normal`) or begins with it (`energy`). `part_of`: also
 * those whose name, after its first dot, is the word (`kinetic`). False: there are none. */
static bool find_quantity(const struct manual *to, const char *word, struct nb_guess *guess, bool part_of) {
  struct nb_quantity_row row;
  const char *const dot = strchr(word, '.'), *const names[] = {word, dot ? dot + 1 : word};
  char of[2 * NB_NAME_SIZE];
  bool found = false;
  const char *owner = NULL;
  for (size_t k = 0; nb_quantity_row(&row, k); k++) {
    const char *const rest = strchr(row.name, '.');
    bool is = part_of && rest && strcmp(rest + 1, word) == 0;
    for (int n = 0; n < 2; n++) {
      const size_t length = strlen(names[n]);
      is = is || (strncmp(row.name, names[n], length) == 0 && (!row.name[length] || row.name[length] == '.'));
    }
    nb_guess_offer(guess, row.name);
    snprintf(of, sizeof of, strcmp(row.unit, "1") == 0 ? "quantity of %s" : "quantity of %s, in %s", row.of, row.unit);
    found = found || is;
    if (!is || !is_new(to, row.key))
      continue;
    owner = own_line(to, &row, owner);
    part(to, row.name, of, row.help);
  }
  return found;
}

/* Prints the help on a law, a reference, a function or constant of expressions, or a unit. False: the word is none of
 * these. */
static bool find_name(const struct manual *to, const char *word) {
  struct nb_unit unit;
  char of[2 * NB_NAME_SIZE];
  bool found = false;
  const bool reserved = nb_name_reserved(word), is_unit = nb_unit_read(&unit, word);
  const struct nb_foreign_unit *const foreign = nb_unit_foreign(word, NULL);
  nb_dimension_words(of, sizeof of, unit.dimension);
  for (const struct nb_law *const *law = nb_laws(); *law; law++) {
    char whole[2 * NB_NAME_SIZE];
    snprintf(whole, sizeof whole, "%s %s", (*law)->kind, (*law)->name);
    if (strcmp(word, (*law)->name) == 0 || strcmp(word, whole) == 0)
      part(to, whole, "a contact law; see nineball laws", (*law)->title), found = true;
  }
  const struct nb_reference *const reference = nb_reference_find(word);
  if (reference)
    part(to, word, "a reference; see nineball list", reference->title);
  if (reserved)
    part(to, word, "of expressions", "see nineball --help expressions");
  if (is_unit)
    part(to, word, "a unit; see nineball --help units", unit.angle ? "an angle or an angular velocity" : of);
  if (foreign)
    fprintf(to->out, "  1 %s is %.10g %s; units are those of SI: see nineball --help units\n", word, foreign->factor,
            foreign->ours);
  return found || reference || reserved || is_unit || foreign;
}

/* Prints all meanings of the word in a page. False: it has none. */
static bool find(const struct manual *to, const char *word, struct nb_guess *guess) {
  static const struct {
    const char *word;
    void (*write)(const struct manual *to);
  } topics[] = {{"expect", expectations},
                {"gnuplot", figures},
                {"quantities", families},
                {"expressions", values},
                {"contact-test", contact_tests}};
  for (size_t k = 0; k < sizeof topics / sizeof *topics; k++)
    if (strcmp(topics[k].word, word) == 0)
      return topics[k].write(to), true;
  bool found = find_statement(to, word, guess);
  found = find_expectation(to, word, guess) || found;
  found = find_name(to, word) || found;
  found = find_quantity(to, word, guess, !found) || found;
  if (strcmp(word, "units") == 0)
    values(to);
  return found;
}

/* Prints the help on one word. For several words, the last one comes first, because it is the noun in `contact
 * damping`. False: there is no help. */
static bool words_help(const struct manual *to, const char *text, struct nb_guess *guess) {
  const struct manual brief = {to->out, false, false, to->shown};
  const struct nb_synonym *const synonym = nb_synonym(text);
  const char *const space = strchr(text, ' ');
  struct nb_guess none = nb_guess_begin("");
  char hint[NB_HINT_SIZE], item[NB_NAME_SIZE];
  bool found = strcmp(text, "strain") == 0;
  if (found) {
    strains(to);
  } else if (synonym && nb_synonym_hint(hint, text)) {
    const char *const see = strstr(hint, " see `nineball"); /* the reference to this help is left out */
    fprintf(to->out, "  %.*s\n", see ? (int)(see - 1 - hint) : NB_HINT_SIZE, hint);
  }
  for (const char *list = synonym ? synonym->ours : ""; nb_item(&list, item);)
    find(&brief, item, &none);
  found = find(to, text, guess) || found;
  found = nb_old_help(to->out, text) || found;
  if (space && !found) {
    nb_first_word(item, text);
    found = words_help(to, space + 1, guess);
    return words_help(to, item, guess) || found;
  }
  return found || synonym;
}

bool nb_manual_word(FILE *out, const char *text, char *hint) {
  const void *shown[2048] = {NULL}; /* more rows than all tables have */
  const struct manual to = {out, false, true, shown};
  struct nb_guess guess = nb_guess_begin(text);
  const size_t topic = strlen("quantities ");
  const bool family = strncmp(text, "quantities ", topic) == 0;
  const bool found = family ? find_quantity(&to, text + topic, &guess, true) : words_help(&to, text, &guess);
  snprintf(hint, NB_HINT_SIZE, "%s", nb_guess_found(&guess) ? guess.best : "");
  return found;
}
