/* `nineball advise --all`: the cheapest settings of many pages. Writes a table with one row for each search, and a
 * figure of each page with advice for its first quantity.
 *
 * The command searches for settings for up to three quantities that a page expects, in the middle run of the sweeps.
 * With --quantity it does so for the quantities that the option names, in all runs. It tries the tolerances in their
 * order and stops at the first tolerance without advice. If a value is too uncertain for the first tolerance, for
 * example because it is near 0, the search uses the absolute tolerance of the expectation instead, if there is one.
 *
 * Every row is written when its search ends, and a later call adds the missing rows to the table. So a call that was
 * interrupted can be repeated.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <dirent.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "advise.h"
#include "commands.h"
#include "core/array.h"
#include "core/clean.h"
#include "core/clock.h"
#include "input/reader.h"
#include "row_table.h"

enum { QUANTITIES = 3, DEPTH_MAX = 16, TEXT_SIZE = 512 };
static const char default_tolerances[] = "10 %; 1 %; 0.1 %";
static const double exact = 1e-9; /* smaller errors are rounding errors */

struct search_all {
  const struct nb_call *call;
  double budget, began; /* budget of a search, s; time at which the command began, s */
  size_t realizations;
  char **paths; /* owned */
  size_t path_count;
  const char *folder;
  struct nb_row_table table;
  size_t searched, answered, kept;
  enum nb_status worst;
};

/* A quantity of a page, and the settings with which it is searched for. */
struct wanted {
  char measure[4 * NB_NAME_SIZE], condition[TEXT_SIZE];
  char absolute[NB_NAME_SIZE]; /* absolute tolerance of the expectation, or empty */
  const char *kind;
  const char **settings; /* NULL-terminated; owned */
};

static void note_status(struct search_all *all, enum nb_status status) { all->worst = nb_worse(all->worst, status); }

static bool no_memory(struct search_all *all) {
  struct nb_error error;
  nb_error_memory(&error);
  note_status(all, nb_print_plain_error(&error));
  return false;
}

/* ---- the pages ---- */

static bool add_path(struct search_all *all, const char *path) {
  char **added = NB_ARRAY_APPEND(all->paths, all->path_count);
  return added && (*added = strdup(path)) ? true : no_memory(all);
}

static bool is_page(const char *path) {
  struct nb_page page = {0};
  struct nb_mistakes mistakes = {0};
  const size_t length = strlen(path);
  const bool is = length > 3 && strcmp(path + length - 3, ".md") == 0 && !nb_page_read(&page, path, &mistakes) &&
                  (nb_page_fence(&page, NB_BLOCK_SCENE) || nb_page_fence(&page, NB_BLOCK_CONTACT_TEST));
  nb_page_free(&page), nb_mistakes_free(&mistakes);
  return is;
}

/* Adds a file, or all pages below a folder in alphabetical order. */
static bool add_paths(struct search_all *all, const char *path, int depth) {
  struct stat status;
  struct dirent **list;
  const bool is_folder = stat(path, &status) == 0 && S_ISDIR(status.st_mode);
  if (!is_folder)
    return depth > 0 && !is_page(path) ? true : add_path(all, path);
  const int count = depth < DEPTH_MAX ? scandir(path, &list, NULL, alphasort) : 0;
  bool good = true;
  for (int k = 0; k < count; k++) {
    char below[4096];
    const int length = snprintf(below, sizeof below, "%s/%s", path, list[k]->d_name);
    if (good && list[k]->d_name[0] != '.' && length < (int)sizeof below)
      good = add_paths(all, below, depth + 1);
    free(list[k]);
  }
  if (count > 0)
    free(list);
  return good;
}

/* ---- the table ---- */

static const char head[] =
    "page\thash\tcondition\tover\tkind\tquantity\ttolerance\tresult\tsetting\tcost\tupdates\tseconds\terror\tunit\tnext"
    "\tnext error/tolerance\torder\tnormal\tshear\tlaws enough\tlaws not enough\tsearch seconds\n";

static enum nb_status open_table(struct search_all *all, struct nb_error *error) {
  char path[4096], version[64];
  snprintf(path, sizeof path, "%.4000s/trades.tsv", all->folder);
  snprintf(version, sizeof version, "# nineball %s, advise --all\n", NB_VERSION);
  return nb_folder_create(all->folder, error) ? error->status
                                              : nb_row_table_open(&all->table, path, version, head, error);
}

/* Writes the first line of a text with spaces instead of tabs, because tabs and line ends separate columns and rows.
 * Then writes `end`. */
static void put_text(FILE *out, const char *text, const char *end) {
  for (const char *c = text[0] ? text : "-"; *c && *c != '\n'; c++)
    fputc(*c == '\t' ? ' ' : *c, out);
  fputs(end, out);
}

/* The order of convergence: the slope of the logarithm of the estimated error against the logarithm of the step, from
 * the first to the last of the three finest steps with the page's own laws and values. Rounding errors are left out.
 * NaN: fewer than three steps are left. */
static double order_of(const struct nb_advice *advice) {
  double error[3] = {0};
  int level[3] = {0};
  size_t count = 0;
  for (size_t k = 0; k < advice->setting_count; k++)
    if (advice->settings[k].variant == 0 && advice->settings[k].ratio * advice->tolerance.value > exact) {
      error[0] = error[1], error[1] = error[2], error[2] = advice->settings[k].ratio;
      level[0] = level[1], level[1] = level[2], level[2] = advice->settings[k].level;
      count++;
    }
  return count < 3 ? NAN : log2(error[0] / error[2]) / (level[2] - level[0]);
}

/* Whether the shear law of a variant in which only this law differs from the page is accurate enough: 1 yes, 0 no, -1
 * unknown. The search of a variant ends at the first level within the tolerance, so its last setting decides. */
static int is_enough(const struct nb_advice *advice, size_t variant) {
  const struct nb_variant *law = &advice->variants[variant];
  int enough = law->equal && strstr(law->reason, "the page") ? 1 : law->distance > 0 ? 0 : -1;
  for (size_t k = 0; k < advice->setting_count; k++)
    if (advice->settings[k].variant == variant)
      enough = advice->settings[k].ratio <= 1;
  return enough;
}

/* Writes the names of the other shear laws that, with the normal law of the page, are accurate enough (`enough` is 1)
 * or not accurate enough (0). */
static void put_laws(FILE *out, const struct nb_advice *advice, int enough) {
  char text[TEXT_SIZE] = "";
  for (size_t k = 1; k < advice->variant_count; k++) {
    const struct nb_variant *variant = &advice->variants[k];
    bool law_alone = strcmp(variant->normal, advice->page.runs[0].scene.normal) == 0;
    for (size_t t = 0; t < NB_TRADES; t++)
      law_alone = law_alone && variant->value[t] == 0;
    if (law_alone && is_enough(advice, k) == enough)
      nb_append(text, sizeof text, "%s%s", text[0] ? " " : "", variant->shear);
  }
  put_text(out, text, "\t");
}

/* Writes the columns from `setting` on. Without advice the column `setting` has the reason. */
static void put_result(FILE *out, const struct nb_advice *advice, const char *reason) {
  const struct nb_setting *chosen = advice->chosen < 0 ? NULL : &advice->settings[advice->chosen];
  const struct nb_setting *cheaper = chosen ? nb_advice_cheaper(advice, chosen) : NULL;
  const char *unit = nb_advice_unit(advice);
  char options[TEXT_SIZE];
  if (chosen) {
    const struct nb_point *point = nb_point_at(advice, chosen), *own = &advice->variants[0].points[-NB_LEVEL_LOW];
    nb_advice_options(options, sizeof options, advice, chosen);
    put_text(out, options, "\t");
    fprintf(out, "%.6g\t%.6g\t%.6g\t%.6g\t%s\t", point->updates / own->updates, point->updates, point->seconds,
            chosen->ratio * advice->tolerance.value, unit[0] ? unit : "1");
  } else {
    put_text(out, reason, "\t-\t-\t-\t-\t-\t");
  }
  if (cheaper)
    nb_advice_options(options, sizeof options, advice, cheaper);
  put_text(out, cheaper ? options : "-", "\t");
  fprintf(out, cheaper ? "%.6g\t" : "-\t", cheaper ? cheaper->ratio : 0);
  fprintf(out, isfinite(order_of(advice)) ? "%.3g\t" : "-\t", order_of(advice));
  const struct nb_scene *scene = advice->page.run_count ? &advice->page.runs[0].scene : NULL;
  fprintf(out, "%s\t%s\t", scene ? scene->normal : "-", scene ? scene->shear : "-");
  if (chosen)
    put_laws(out, advice, 1), put_laws(out, advice, 0);
  else
    fputs("-\t-\t", out);
  fprintf(out, "%.3g\n", nb_clock() - advice->began);
}

/* ---- a search ---- */

/* Returns the result of a search in one word: "yes" if there is advice, else "none", "budget", "unknown" (the value is
 * too uncertain) or "refused". *reason then receives the reason. */
static const char *result_of(const struct nb_advice *advice, enum nb_status status, const struct nb_error *error,
                             const char **reason) {
  const char *mistakes = advice->page.mistakes.text ? strstr(advice->page.mistakes.text, "error: ") : NULL;
  *reason = mistakes                   ? mistakes + strlen("error: ")
            : status || error->text[0] ? error->text
            : advice->exhausted        ? "the budget was used up"
                                       : "no setting that was tried is within the tolerance";
  if (status)
    return status != NB_FAILED ? "refused" : advice->exhausted ? "budget" : "unknown";
  return advice->chosen >= 0 ? "yes" : advice->exhausted ? "budget" : "none";
}

/* Draws FOLDER/NAME.svg and .png. */
static void draw(struct search_all *all, const struct nb_advice *advice) {
  struct nb_error error;
  if (nb_advice_draw(advice, all->folder, advice->page.page.name, all->call->trust, &error))
    note_status(all, nb_print_plain_error(&error));
}

/* Searches for the cheapest setting, unless the table has a row of this search. `first`: the quantity is the first one
 * of the page, for which the figure is drawn. Returns the first letter of the result; 0: memory ran out. */
static char search_one(struct search_all *all, const struct nb_page *page, const struct wanted *wanted,
                       const char *tolerance, bool first) {
  char key[4096];
  snprintf(key, sizeof key, "%s\t%016llx\t%s\t%s\t%s\t%s\t%s\t", page->path, page->hash,
           wanted->condition[0] ? wanted->condition : "-", all->call->over ? all->call->over : "-", wanted->kind,
           wanted->measure, tolerance);
  all->searched++;
  const char *row = nb_row_table_find(&all->table, key);
  if (row) {
    const bool answered = strncmp(row, "yes\t", 4) == 0;
    all->kept++, all->answered += answered;
    note_status(all, answered ? NB_OK : NB_FAILED);
    return row[0];
  }
  const struct nb_advise_query query = {.path = page->path,
                                        .settings = wanted->settings,
                                        .options = all->call->options,
                                        .quantity = wanted->measure,
                                        .within = tolerance,
                                        .over = all->call->over,
                                        .realizations = all->realizations,
                                        .budget = all->budget};
  struct nb_advice advice;
  struct nb_error error = {0};
  const char *reason;
  const enum nb_status status = nb_advise(&advice, &query, &error);
  const char *result = result_of(&advice, status, &error, &reason);
  if (status != NB_NO_MEMORY) {
    if (first && advice.chosen >= 0 && advice.settings[advice.chosen].ratio * advice.tolerance.value > exact)
      draw(all, &advice);
    fprintf(all->table.file, "%s%s\t", key, result);
    put_result(all->table.file, &advice, reason);
    if (strcmp(result, "refused") == 0)
      printf("  %s within %s: ", wanted->measure, tolerance), put_text(stdout, reason, "\n");
    fflush(all->table.file);
    all->answered += result[0] == 'y';
  }
  note_status(all, status == NB_NO_MEMORY ? status : result[0] == 'y' ? NB_OK : NB_FAILED);
  nb_advice_free(&advice);
  return status == NB_NO_MEMORY ? 0 : result[0];
}

/* Writes the next text of a list whose texts are separated by `;`, without spaces around it, and moves *list behind it.
 * False: there is none. */
static bool next_text(char *text, size_t size, const char **list) {
  const char *at = *list + strspn(*list, " ;");
  size_t length = strcspn(at, ";");
  *list = at + length;
  while (length > 0 && at[length - 1] == ' ')
    length--;
  snprintf(text, size, "%.*s", (int)length, at);
  return length > 0;
}

/* Searches with the tolerances in their order, up to the first one without advice. False: memory ran out. */
static bool search_tolerances(struct search_all *all, const struct nb_page *page, const struct wanted *wanted,
                              bool first) {
  const char *list = all->call->within ? all->call->within : default_tolerances;
  char tolerance[NB_NAME_SIZE], result = 'y';
  for (bool coarsest = true; result == 'y' && next_text(tolerance, sizeof tolerance, &list); coarsest = false) {
    result = search_one(all, page, wanted, tolerance, first);
    if (coarsest && result == 'u' && wanted->absolute[0])
      return search_one(all, page, wanted, wanted->absolute, first) != 0;
  }
  return result != 0;
}

/* ---- the quantities of a page ---- */

/* The kind of a measure, which decides how its error depends on the step: a quantity of a contact test or of an impact,
 * an extreme value, a mean or a frequency, or a value at a given time, at the end of a stage of N cycles, or at the end
 * of a stage with conditions. */
static const char *kind_of(const struct nb_measure *measure, const struct nb_scene *scene) {
  static const char *const kinds[] = {
      [NB_MAX] = "extreme",    [NB_MIN] = "extreme",   [NB_AMPLITUDE] = "extreme", [NB_MEAN] = "mean",
      [NB_FREQUENCY] = "mean", [NB_AT_CYCLE] = "time", [NB_AT_TIME] = "time",      [NB_LAST] = NULL};
  const size_t stage = measure->stage >= 0 ? (size_t)measure->stage : scene->stage_count - 1;
  if (scene->contact_test || strncmp(measure->label, "impact.", 7) == 0)
    return scene->contact_test ? "contact test" : "impact";
  return kinds[measure->reducer]                    ? kinds[measure->reducer]
         : scene->stages[stage].condition_count > 0 ? "until"
                                                    : "time";
}

/* The name of the quantity without its monitor, `normal` of `C.normal max`. *length receives the length of the name. */
static const char *bare_name(const struct nb_measure *measure, size_t *length) {
  const size_t word = strcspn(measure->label, " "), dot = strcspn(measure->label, ".");
  const char *name = dot < word ? measure->label + dot + 1 : measure->label;
  *length = (size_t)(measure->label + word - name);
  return name;
}

static bool is_searched(const struct nb_expectation *e) {
  return e->kind != NB_VERSUS && e->kind != NB_REPORTED && !e->measure.is_residual && e->measure.unit &&
         strncmp(e->measure.label, "time", 4) != 0 && strncmp(e->measure.label, "step", 4) != 0;
}

/* True if an earlier expectation that is searched has the same quantity, of any monitor, and a reducer of the same
 * kind. */
static bool is_repeated(const struct nb_expectations *list, size_t index, const struct nb_scene *scene) {
  const struct nb_measure *this = &list->list[index].measure;
  size_t length, other_length;
  const char *name = bare_name(this, &length);
  for (size_t k = 0; k < index; k++) {
    const struct nb_measure *other = &list->list[k].measure;
    const char *other_name = bare_name(other, &other_length);
    if (is_searched(&list->list[k]) && length == other_length && strncmp(name, other_name, length) == 0 &&
        strcmp(kind_of(this, scene), kind_of(other, scene)) == 0)
      return true;
  }
  return false;
}

/* Sets wanted->settings to those of the caller and, if `run` is not NULL, those that choose this run. False: memory ran
 * out. */
static bool choose_run(struct wanted *wanted, const struct search_all *all, const struct nb_page_run *run) {
  const char **given = all->call->settings;
  size_t count = 0;
  while (given[count])
    nb_append(wanted->condition, sizeof wanted->condition, "%s%s", count ? ", " : "", given[count]), count++;
  const size_t swept = run ? run->scene.binding_count : 0;
  wanted->settings = calloc(count + swept + 1, sizeof *wanted->settings);
  if (!wanted->settings)
    return false;
  memcpy(wanted->settings, given, count * sizeof *given);
  for (size_t k = 0; k < swept; k++) {
    const struct nb_binding *binding = &run->scene.bindings[k];
    const size_t size = strlen(binding->name) + strlen(binding->text) + 2;
    if (!binding->swept)
      continue;
    char *text = malloc(size);
    if (!text)
      return false;
    snprintf(text, size, "%s=%s", binding->name, binding->text);
    nb_append(wanted->condition, sizeof wanted->condition, "%s%s", count ? ", " : "", text);
    wanted->settings[count++] = text;
  }
  return true;
}

static void free_run(struct wanted *wanted, const struct search_all *all) {
  size_t count = 0;
  while (all->call->settings[count])
    count++;
  for (size_t k = count; wanted->settings && wanted->settings[k]; k++)
    free((char *)wanted->settings[k]);
  free(wanted->settings);
}

/* Searches for settings for the first quantities that the page expects, at most QUANTITIES. */
static void search_expected(struct search_all *all, const struct nb_outcome *page, struct wanted *wanted) {
  const struct nb_page_run *run = &page->runs[(page->run_count - 1) / 2];
  size_t count = 0;
  for (size_t k = 0; k < run->expectations.count && count < QUANTITIES; k++) {
    const struct nb_expectation *e = &run->expectations.list[k];
    if (!is_searched(e) || is_repeated(&run->expectations, k, &run->scene))
      continue;
    /* the tolerance of an order of convergence is not one of the quantity */
    const bool absolute = e->kind != NB_ORDER && e->tolerance.kind == NB_ABSOLUTE && e->tolerance.value > 0;
    snprintf(wanted->measure, sizeof wanted->measure, "%s", e->measure.label);
    snprintf(wanted->absolute, sizeof wanted->absolute, "%s", absolute ? e->tolerance.text : "");
    wanted->kind = kind_of(&e->measure, &run->scene);
    if (!search_tolerances(all, &page->page, wanted, count++ == 0))
      return;
  }
  if (count == 0)
    printf("  %s has no expectation of a single value that depends on the step\n", page->page.name);
}

static void search_page(struct search_all *all, const char *path) {
  const char *list = all->call->quantity;
  struct nb_outcome page;
  struct wanted wanted = {.kind = "-"};
  nb_outcome_read(&page, path, all->call->settings);
  nb_print_errors(&page, path);
  note_status(all, page.status);
  if (!page.status && !choose_run(&wanted, all, list ? NULL : &page.runs[(page.run_count - 1) / 2])) {
    no_memory(all);
  } else if (!page.status && list) {
    for (bool first = true; next_text(wanted.measure, sizeof wanted.measure, &list); first = false)
      if (!search_tolerances(all, &page.page, &wanted, first))
        break;
  } else if (!page.status) {
    search_expected(all, &page, &wanted);
  }
  free_run(&wanted, all);
  nb_outcome_free(&page);
}

/* ---- the command ---- */

/* Prints "12 of 129, nine-discs: 9 searches, 8 with advice; about 4 min left". */
static void print_progress(const struct search_all *all, size_t done, size_t searched, size_t answered) {
  const double left = (nb_clock() - all->began) * (double)(all->path_count - done) / (double)done;
  const char *name;
  const int length = (int)nb_page_name(all->paths[done - 1], &name);
  printf("%zu of %zu, %.*s: %zu searches, %zu with advice", done, all->path_count, length, name, searched, answered);
  if (done < all->path_count)
    printf(left < 100 ? "; about %.0f s left" : "; about %.0f min left", left < 100 ? left : left / 60);
  putchar('\n');
  fflush(stdout);
}

static void search_pages(struct search_all *all) {
  for (size_t k = 0; k < all->path_count && all->worst < NB_NO_MEMORY; k++) {
    const size_t searched = all->searched, answered = all->answered;
    search_page(all, all->paths[k]);
    print_progress(all, k + 1, all->searched - searched, all->answered - answered);
  }
  printf("%zu searches, %zu with advice", all->searched, all->answered);
  if (all->kept)
    printf(", %zu of them from an earlier call", all->kept);
  printf("; look at %s/trades.tsv\n", all->folder);
}

enum nb_status nb_command_advise_all(const struct nb_call *call, double budget, size_t realizations) {
  struct search_all all = {.call = call,
                           .budget = budget,
                           .realizations = realizations,
                           .began = nb_clock(),
                           .folder = call->folder ? call->folder : "trades"};
  struct nb_error error = {0};
  bool good = true;
  for (size_t k = 0; k < call->page_count && good; k++)
    good = add_paths(&all, call->pages[k], 0);
  if (call->page_count == 0)
    good = add_paths(&all, "cases", 0);
  if (good && all.path_count == 0) {
    fputs("nineball: there is no page below that folder: expected a page, or a folder with pages\n", stderr);
    note_status(&all, NB_BAD_USE);
  } else if (good && open_table(&all, &error)) {
    note_status(&all, nb_print_plain_error(&error));
  } else if (good) {
    search_pages(&all);
  }
  if (!nb_row_table_close(&all.table)) {
    fprintf(stderr, "nineball: %s/trades.tsv could not be written\n", all.folder);
    note_status(&all, NB_BAD_USE);
  }
  for (size_t k = 0; k < all.path_count; k++)
    free(all.paths[k]);
  free(all.paths);
  return all.worst;
}
