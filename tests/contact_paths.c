/* Tests every contact law on random paths, and compares the exact law with a list of all rings. `make paths` writes the
 * document.
 *
 * contact_paths -o DOCUMENT FOLDER   writes docs/PATHS.md, and tables into the folder: ten million steps of each pair of
 *                                    laws on each kind of path
 * contact_paths                      tests a hundred thousand steps of each, and laws with planted errors that must be detected
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "paths/paths.h"

enum { SHORT = 100000, LONG = 10000000, EXACT = 500000 }; /* steps; EXACT: of the comparison with the list */
enum { COMPARED = KIND_DECADES };                         /* kinds of path for that comparison */

/* Tolerances of the error of T over mu N, for each kind of path and each recorded run (rows) and each number of pieces
 * (columns). Each is larger than the largest error in docs/PATHS.md. Where that error exceeds 1e-5, the tolerance is in
 * most cases three to ten times as large. If there is enough memory, the only errors are those of merges, each of which
 * changes T by less than 1e-7 mu N. */
static const double allowed[COMPARED + RUNS][MEMORIES] = {
    {0.3, 0.1, 0.01, 1e-5, 1e-7},      {0.1, 0.02, 2e-3, 2e-4, 1e-7},       {0.2, 0.03, 5e-3, 1e-3, 1e-7},
    {0.2, 0.03, 5e-3, 1e-3, 1e-7},     {0.3, 0.02, 1e-4, 1e-6, 1e-7},       {0.2, 0.1, 0.05, 0.02, 1e-7},
    {1e-4, 1e-7, 1e-10, 1e-10, 1e-10}, {1e-12, 1e-12, 1e-12, 1e-12, 1e-12}, {0.3, 0.1, 5e-3, 4e-4, 1e-7},
};

static void fail(const char *what) {
  fprintf(stderr, "contact_paths: %s\n", what);
  exit(2);
}

/* The findings on all kinds of path. Writes a row for each kind, if there is a table. */
static struct findings law_on_all_paths(const struct nb_law *normal, const struct nb_law *shear, long steps,
                                        FILE *table) {
  struct findings sum = {0};
  for (int kind = 0; kind < KINDS; kind++) {
    const struct findings one = law_on_paths(normal, shear, kind, steps);
    findings_add(&sum, &one);
    if (table)
      fprintf(table, "%s\t%s\t%s\t%ld\t%ld\t%.3g\t%.3g\t%.3g\t%.3g\n", normal->name, shear->name, kind_names[kind],
              one.steps, one.contacts, one.excess, one.created[0], one.created[1], one.grown);
  }
  return sum;
}

/* Calls `use` for each normal law with each shear law that can follow it. */
static void each_pair(void (*use)(const struct nb_law *normal, const struct nb_law *shear, void *data), void *data) {
  for (const struct nb_law *const *normal = nb_laws(); *normal; normal++)
    for (const struct nb_law *const *shear = nb_laws(); (*normal)->normal && *shear; shear++)
      if ((*shear)->shear && !((*shear)->elastic && !(*normal)->elastic))
        use(*normal, *shear, data);
}

static const struct nb_law *exact(void) { return nb_law_find("shear", "mindlin_deresiewicz"); }

/* The errors of the law on a path: the numbers below COMPARED are kinds of path, the others are recorded runs. */
static struct errors exact_by_number(const struct nb_law *shear, int number, long steps) {
  return number < COMPARED ? exact_on_paths(shear, number, steps) : exact_in_run(shear, number - COMPARED, steps);
}
static const char *name_of(int number) { return number < COMPARED ? kind_names[number] : run_names[number - COMPARED]; }
static bool is_allowed(const struct errors *errors, int number) {
  bool is = true;
  for (int k = 0; k < MEMORIES; k++)
    is = is && errors->of[k].worst <= allowed[number][k];
  return is;
}

/* ---- planted wrong laws ---- */

static struct nb_shear call(const char *name, struct nb_pair p, struct nb_normal n, double ds, double m[]) {
  return nb_law_find("shear", name)->shear(p, n, ds, m);
}
static struct nb_shear above_limit(struct nb_pair p, struct nb_normal n, double ds, double m[]) {
  struct nb_shear s = call("linear", p, n, ds, m);
  s.force *= s.sliding > 0 ? 1 + 1e-12 : 1;
  return s;
}
static struct nb_shear nan_at_rest(struct nb_pair p, struct nb_normal n, double ds, double m[]) {
  struct nb_shear s = call("linear", p, n, ds, m);
  s.force = ds != 0 || n.force > 0 ? s.force : 0 / n.force;
  return s;
}
static struct nb_shear long_history(struct nb_pair p, struct nb_normal n, double ds, double m[]) {
  return call("mindlin_scaled", p, n, m[2] = ds, m);
}
static struct nb_shear one_piece_more(struct nb_pair p, struct nb_normal n, double ds, double m[]) {
  p.pieces++;
  return call("mindlin_deresiewicz", p, n, ds, m);
}
static struct nb_shear never_empty(struct nb_pair p, struct nb_normal n, double ds, double m[]) {
  const double before = m[0];
  struct nb_shear s = call("linear", p, n, ds, m);
  s.force = n.stiffness > 0 ? s.force : before;
  return s;
}
static struct nb_shear one_percent_less_back(struct nb_pair p, struct nb_normal n, double ds, double m[]) {
  p.ks *= m[0] * ds < 0 ? 0.99 : 1;
  return call("linear", p, n, ds, m);
}
static double too_much_stored(struct nb_pair p, struct nb_normal n, const double m[]) {
  return 1.01 * nb_law_find("shear", "linear")->stored(p, n, m);
}
static struct nb_shear half_the_memory(struct nb_pair p, struct nb_normal n, double ds, double m[]) {
  p.pieces /= 2;
  return call("mindlin_deresiewicz", p, n, ds, m);
}
/* A wrong law that removes the corner between the two outermost of three or more pieces when the contact slips back. */
static struct nb_shear drops_a_corner(struct nb_pair p, struct nb_normal n, double ds, double m[]) {
  if (m[0] > 2 && ds < 0) {
    double *last = m + 2 + 5 * ((int)m[0] - 1);
    memmove(last, last + 5, 5 * sizeof *last), m[0]--;
  }
  return call("mindlin_deresiewicz", p, n, ds, m);
}
static struct nb_shear slightly_stiff(struct nb_pair p, struct nb_normal n, double ds, double m[]) {
  return call("mindlin_deresiewicz", p, n, ds * (1 + 1e-6), m);
}

struct planted {
  const char *what, *law; /* the law that is changed */
  struct nb_shear (*shear)(struct nb_pair, struct nb_normal, double, double[]);
  double (*stored)(struct nb_pair, struct nb_normal, const double[]);
  const char *promise; /* the promise of laws that is then broken; NULL: the error of T becomes too large */
};
static const struct planted planted[] = {
    {"a force 1e-12 above the limit", "linear", above_limit, NULL, "the shear force exceeds mu N"},
    {"0/0 where nothing moves", "linear", nan_at_rest, NULL, "a number is not finite"},
    {"a third history variable of a law that declares two", "mindlin_scaled", long_history, NULL,
     "the history leaves its bounds"},
    {"one piece too many", "mindlin_deresiewicz", one_piece_more, NULL, "the history leaves its bounds"},
    {"a force of an open contact", "linear", never_empty, NULL, "an open contact has a force"},
    {"a law without scaling that promises to create no energy", "mindlin", NULL, NULL,
     "a contact returns more energy than it was given"},
    {"a spring 1 % softer on the way back", "linear", one_percent_less_back, NULL,
     "a contact returns more energy than it was given"},
    {"stored energy 1 % too large", "linear", NULL, too_much_stored, "the stored energy grows by more than the work"},
    {"half the memory", "mindlin_deresiewicz", half_the_memory, NULL, NULL},
    {"a corner dropped", "mindlin_deresiewicz", drops_a_corner, NULL, NULL},
    {"a displacement 1e-6 too long", "mindlin_deresiewicz", slightly_stiff, NULL, NULL},
};
enum { PLANTED = sizeof planted / sizeof *planted };

static bool is_seen(const struct planted *it) {
  struct nb_law law = *nb_law_find("shear", it->law);
  law.shear = it->shear ? it->shear : law.shear;
  law.stored = it->stored ? it->stored : law.stored;
  law.non_conservative = false;
  if (!it->promise) {
    const struct errors errors = exact_on_paths(&law, KIND_WALK, SHORT);
    return !is_allowed(&errors, KIND_WALK);
  }
  const struct findings findings = law_on_all_paths(nb_law_find("normal", "hertz"), &law, SHORT / 4, NULL);
  const char *broken = broken_promise(&findings, law.piece > 0);
  if (!broken || strcmp(broken, it->promise) != 0)
    printf("# %s: %s\n", it->what, broken ? broken : "nothing is broken");
  return broken && strcmp(broken, it->promise) == 0;
}

/* ---- the test, TAP ---- */

static int tests;

static void result(bool good, const char *what, const char *of) {
  printf("%s %d - %s%s%s\n", good ? "ok" : "not ok", ++tests, of, of[0] ? ": " : "", what);
}

static void test_pair(const struct nb_law *normal, const struct nb_law *shear, void *data) {
  (void)data;
  const struct findings findings = law_on_all_paths(normal, shear, SHORT, NULL);
  const char *broken = broken_promise(&findings, shear->piece > 0);
  char pair[128];
  snprintf(pair, sizeof pair, "normal %s, shear %s", normal->name, shear->name);
  result(!broken, broken ? broken : "holds on random paths", pair);
}

static void run_tests(void) {
  each_pair(test_pair, NULL);
  for (int number = 0; number < COMPARED + RUNS - 1; number++) { /* not the assembly, which takes long */
    const struct errors errors = exact_by_number(exact(), number, number < COMPARED ? SHORT : EXACT);
    result(is_allowed(&errors, number), "the exact law with each memory", name_of(number));
  }
  for (int k = 0; k < PLANTED; k++)
    result(is_seen(&planted[k]), planted[k].what, "is detected");
  printf("1..%d\n", tests);
}

/* ---- docs/PATHS.md ---- */

struct files {
  FILE *out, *table;
  int complaints;
};

static FILE *opened(const char *folder, const char *name) {
  char path[512];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  FILE *file = fopen(path, "w");
  if (!file)
    fail(path);
  return file;
}
static void closed(FILE *file) {
  if (fclose(file))
    fail("cannot write a file");
}

static void complain(struct files *files, const char *what, const char *of) {
  fprintf(stderr, "contact_paths: %s: %s\n", of, what);
  files->complaints++;
}

static void write_number(FILE *out, double value) {
  if (value > 0)
    fprintf(out, " %.1e |", value);
  else
    fputs(" 0 |", out);
}

static void write_pair(const struct nb_law *normal, const struct nb_law *shear, void *data) {
  struct files *files = data;
  const struct findings findings = law_on_all_paths(normal, shear, LONG, files->table);
  const char *broken = broken_promise(&findings, shear->piece > 0);
  if (broken)
    complain(files, broken, shear->name);
  fprintf(files->out, "| `%s` | `%s` | %s |", normal->name, shear->name, shear->non_conservative ? "no" : "yes");
  write_number(files->out, findings.excess);
  write_number(files->out, findings.created[0]);
  write_number(files->out, findings.created[1]);
  if (shear->stored)
    write_number(files->out, findings.grown);
  else
    fputs(" – |", files->out);
  fprintf(files->out, " %s |\n", broken ? broken : "");
}

static void write_errors(struct files *files, int number) {
  const struct errors errors = exact_by_number(exact(), number, EXACT);
  if (!is_allowed(&errors, number))
    complain(files, "the error exceeds the allowed one", name_of(number));
  fprintf(files->out, "| %s | %.1e | %ld |", name_of(number), (double)errors.of[0].count, errors.of[0].rings);
  for (int k = 0; k < MEMORIES; k++) {
    const struct error *one = &errors.of[k];
    const double mean = sqrt(one->square / (double)one->count);
    fprintf(files->out, " %.0e (%.0e) |", one->worst, mean);
    fprintf(files->table, "%s\t%d\t%.3g\t%.3g\n", name_of(number), memories[k], one->worst, mean);
  }
  fputs("\n", files->out);
}

static void write_laws(struct files *files) {
  fprintf(
      files->out,
      "# Contact laws on random paths\n\n"
      "`make paths` writes this document ([contact_paths.c](../tests/contact_paths.c)). The program leads every\n"
      "contact law of `nineball laws` along random paths, and compares the exact law with a calculation that keeps\n"
      "all rings. [CONTACT](CONTACT.md) explains the laws. A test of `make check` uses shorter paths. It also runs\n"
      "laws with planted errors, which it must detect.\n\n"
      "## The paths\n\n"
      "A path is a series of points of overlap and tangential displacement. Each contact has its own random numbers,\n"
      "such as amplitude, decay and period, each from a range of about one to three decades. At the end\n"
      "of its path the contact opens, and the next contact begins.\n\n");
  for (int kind = 0; kind < KINDS; kind++)
    fprintf(files->out, "- **%s:** %s\n", kind_names[kind], kind_titles[kind]);
  fprintf(
      files->out,
      "\n## Every law\n\n"
      "Each combination of a normal and a shear law makes %.0e steps on each kind of path. The material of each\n"
      "contact is random. Its mean overlap is 1e-9 to 1e-3 of the effective radius, and the stiffnesses span sixteen\n"
      "decades. The friction is 0, 1e-12, 10, 1e6, or between 0.05 and 1. After each step the program checks that:\n\n"
      "- all forces, stiffnesses and history variables are finite numbers;\n"
      "- $\\lvert T \\rvert \\le \\mu N + c$ up to two roundings, with the cohesion $c$;\n"
      "- the history stays within its declared length, and a saved state would accept it;\n"
      "- an open contact has no force.\n\n"
      "**Energy.** Most laws promise that no closed path creates energy. With such a law a contact never returns more\n"
      "work than it was given since first touch, and the stored energy, where a law has one, never grows by more than\n"
      "the work. The path between two points is computed in four and in eight steps. Sixteen times the difference of\n"
      "the two works is taken as the error of the finite steps. Only energy in excess of this error counts. The path\n"
      "*decades* is left out, because its jumps are too large for this estimate. A law that joins pieces of its\n"
      "history may store more than the work, by up to %g of the energy given.\n\n"
      "The table has the largest values of all paths. *Excess* is the part of $\\lvert T \\rvert$ beyond its\n"
      "limit, divided by the limit. *Created* is the energy created by a contact over the energy that it was given. "
      "*Stored beyond work* is\n"
      "the growth of the stored energy that is not work, also over the energy given. The last column names the check "
      "that failed, if any.\n"
      "[laws.tsv](paths/laws.tsv) has each kind of path.\n\n"
      "| normal | shear | promises to create no energy | excess | created, friction ≤ 1 | created, friction ≥ 10 | "
      "stored beyond "
      "work | failed check |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n",
      (double)LONG, most_joined);
  fputs("normal\tshear\tkind\tsteps\tcontacts\texcess\tcreated\tcreated.high\tgrown\n", files->table);
  each_pair(write_pair, files);
}

static void write_causes(FILE *out) {
  fputs(
      "\n**Causes.**\n\n"
      "- `mindlin` keeps the shear force when the normal force falls, although a part of the contact has separated. "
      "It\n"
      "  returns more than it was given when the displacement is applied at a large overlap and taken back at a\n"
      "  small one.\n"
      "- `randall` stores two reversals and one number for all rings that stuck while the overlap grew. A reversal\n"
      "  deletes that number, so the law forgets rings that still carry a force. With a friction of 10 or more a\n"
      "  contact hardly slips, and the energy given is small. The law adds $(1 - \\theta) \\mu \\Delta N$\n"
      "  to $T$. Here the slip factor $\\theta$ should be nearly 1, but $\\mu \\Delta N$ is large, so a small error of "
      "$\\theta$\n"
      "  causes a large error of $T$.\n"
      "- `randall_literal` has the errors of the printed text as well.\n"
      "- `mindlin_deresiewicz` joins pieces when its memory is full. A join changes the stored energy slightly, in\n"
      "  either direction. The law counts this change as dissipated.\n",
      out);
}

static void write_exact(struct files *files) {
  fputs(
      "\n## The exact law and its memory\n\n"
      "The law `mindlin_deresiewicz` stores at most $K$ pieces of its history. Here the same path goes to the law "
      "with\n"
      "several $K$ and to an independent list of all rings ([by_hand.h](../tests/by_hand.h)), which has no limit. The\n"
      "error is that of $T$, divided by the present $\\mu N$. The last paths come from runs of the program:\n\n",
      files->out);
  for (int run = 0; run < RUNS; run++)
    fprintf(files->out, "- **%s:** %s ([path-%s](../tests/pages/path-%s.md)).\n", run_names[run], run_titles[run],
            run_names[run], run_names[run]);
  fputs("\nThe table has the largest error, and the root mean square in parentheses. The column *rings* is the length\n"
        "of the longest list, and the columns after it are the values of $K$. With 4096 pieces nearly all joins\n"
        "are those that change $T$ by less than 1e-7 of $\\mu N$.\n\n"
        "| path | steps | rings |",
        files->out);
  fputs("path\tmemory\tworst\tmean\n", files->table);
  for (int k = 0; k < MEMORIES; k++)
    fprintf(files->out, " %d |", memories[k]);
  fputs("\n| --- | --- | --- |", files->out);
  for (int k = 0; k < MEMORIES; k++)
    fputs(" --- |", files->out);
  fputs("\n", files->out);
  for (int number = 0; number < COMPARED + RUNS; number++)
    write_errors(files, number);
  fputs(
      "\n![Largest error of the shear force against the memory of the exact law](paths/memory.svg)\n\n"
      "**Causes.**\n\n"
      "- If a path has more reversals than the law has pieces, the law loses some of them: it joins the two pieces "
      "whose\n"
      "  join would change $T$ least. With 64 pieces this happens on the six paths with more than "
      "64\n"
      "  rings.\n"
      "- In *rolling* the overlap falls to a small part of its largest value at the end. The error of inner pieces\n"
      "  remains, and it is divided by a $\\mu N$ that is much smaller. So with 32 and 64 pieces *rolling* has the "
      "largest "
      "error.\n"
      "- Cycles that repeat erase their own corners. So *ratchet* needs few pieces, however long it is.\n"
      "- The contacts of *bounce* and *incline* mostly slide or vibrate with overlap and displacement in phase. Their\n"
      "  paths have few corners.\n",
      files->out);
}

static int write_document(const char *document, const char *folder) {
  struct files files = {.out = fopen(document, "w")};
  if (!files.out)
    fail(document);
  files.table = opened(folder, "laws.tsv");
  write_laws(&files);
  closed(files.table);
  write_causes(files.out);
  files.table = opened(folder, "memory.tsv");
  write_exact(&files);
  closed(files.table);
  closed(files.out);
  return files.complaints > 0;
}

int main(int argc, char **words) {
  if (argc == 4 && strcmp(words[1], "-o") == 0)
    return write_document(words[2], words[3]);
  if (argc > 1)
    fail("usage: contact_paths [-o DOCUMENT FOLDER]");
  run_tests();
  return 0;
}
