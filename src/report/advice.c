/* `nineball advise`: prints the result of the search; writes a table of all settings with an estimated error, and a
 * figure of this error against cost.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "advise.h"
#include "commands.h"
#include "core/clean.h"
#include "core/clock.h"

/* Appends ` --set NAME=VALUE`, quoted for the shell. */
static void append_setting(char *text, size_t size, const char *name, const char *value) {
  char setting[1024];
  snprintf(setting, sizeof setting, "%s=%s", name, value);
  nb_append(text, size, "%s--set ", text[0] ? " " : "");
  nb_append_word(text, size, setting);
}

/* Appends the values that a variant takes from the statements `trade`: "rate=3, E=7 GPa", or
 * `--set rate=3 --set E='7 GPa'`. */
static void append_values(char *text, size_t size, const struct nb_advice *advice, const struct nb_variant *variant,
                          bool options) {
  const struct nb_scene *scene = &advice->page.runs[0].scene;
  for (size_t k = 0; k < scene->trade_count; k++) {
    const struct nb_trade *trade = &scene->trades[k];
    const char *value = variant->value[k] ? trade->values[variant->value[k] - 1] : NULL;
    if (value && options)
      append_setting(text, size, trade->name, value);
    else if (value)
      nb_append(text, size, "%s%s=%s", text[0] ? ", " : "", trade->name, value);
  }
}

/* The value of --set refine at a level. */
static double refine_of(const struct nb_advice *advice, int level) {
  return advice->page.runs[0].scene.refine * nb_level_refine(advice, level);
}

void nb_advice_options(char *text, size_t size, const struct nb_advice *advice, const struct nb_setting *setting) {
  const struct nb_variant *variant = &advice->variants[setting->variant];
  text[0] = 0;
  if (variant->normal[0])
    nb_append(text, size, "--set normal=%s --set shear=%s", variant->normal, variant->shear);
  if (variant->soften > 0)
    nb_append(text, size, "--set soften=%g", advice->page.runs[0].scene.soften * variant->soften);
  if (variant->centred)
    nb_append(text, size, "--set damping=centred");
  append_values(text, size, advice, variant, true);
  nb_append(text, size, "%s--set refine=%.10g", text[0] ? " " : "", refine_of(advice, setting->level));
}

/* Prints the options of this call that the suggested command also needs: --set NAME=VALUE, except `trade` and names to
 * which `options` gives another value. */
static void print_own_options(const struct nb_advice *advice, const char *options) {
  for (size_t k = 0; advice->query->settings[k]; k++) {
    const char *setting = advice->query->settings[k];
    char text[1024] = "", name[NB_NAME_SIZE], plain[sizeof "--set =" + NB_NAME_SIZE], quoted[sizeof plain + 1];
    snprintf(name, sizeof name, "%.*s", (int)strcspn(setting, "="), setting);
    snprintf(plain, sizeof plain, "--set %s=", name);
    snprintf(quoted, sizeof quoted, "--set '%s=", name);
    if (strcmp(name, "trade") != 0 && !strstr(options, plain) && !strstr(options, quoted)) {
      append_setting(text, sizeof text, name, strchr(setting, '=') + 1);
      printf(" %s", text);
    }
  }
}

/* The unit of the quantity, or "". */
static const char *unit_of_value(const struct nb_advice *advice) {
  return advice->page.runs[0].scene.unitless || !advice->unit || strcmp(advice->unit, "1") == 0 ? "" : advice->unit;
}

const char *nb_advice_unit(const struct nb_advice *advice) {
  return advice->tolerance.kind == NB_RELATIVE ? "%" : unit_of_value(advice);
}

static void error_text(char text[NB_NAME_SIZE], const struct nb_advice *advice, double ratio) {
  const double factor = advice->tolerance.kind == NB_RELATIVE ? 100 : 1;
  const char *unit = nb_advice_unit(advice);
  snprintf(text, NB_NAME_SIZE, "%.2g%s%s", ratio * advice->tolerance.value * factor, unit[0] ? " " : "", unit);
}

static const char *word(const char *law, const char *own) { return law[0] ? law : own; }

/* Writes the name of a variant: "normal hertz, shear mindlin, rate=3". */
static void name_variant(char *text, size_t size, const struct nb_advice *advice, const struct nb_variant *variant) {
  const struct nb_scene *scene = &advice->page.runs[0].scene;
  snprintf(text, size, "normal %s, shear %s", word(variant->normal, scene->normal), word(variant->shear, scene->shear));
  if (variant->soften > 0)
    nb_append(text, size, ", stiffness divided by %g", variant->soften);
  if (variant->centred)
    nb_append(text, size, ", damping centred");
  append_values(text, size, advice, variant, false);
}

static const char *label_of(const struct nb_advice *advice, size_t run) { return advice->page.runs[run].label; }

/* Prints the estimated error: "0.0076, in run psi1=1; by the step alone 0.0062", or "0.0076; difference of the means
 * 0.0012". */
static void print_error_of(const struct nb_advice *advice, const struct nb_setting *setting) {
  char whole[NB_NAME_SIZE], step[NB_NAME_SIZE];
  const char *label = label_of(advice, setting->worst);
  error_text(whole, advice, setting->ratio);
  error_text(step, advice, setting->step_ratio);
  printf("%s%s%s; %s %s\n", whole, label[0] ? ", in run " : "", label,
         advice->query->over ? "difference of the means" : "by the step alone", step);
}

/* Prints the step and the laws in words. */
static void print_setting(const struct nb_advice *advice, const struct nb_setting *setting) {
  const struct nb_scene *scene = &advice->page.runs[0].scene;
  const double step = nb_point_at(advice, setting)->step;
  char length[NB_NAME_SIZE] = "", level[NB_NAME_SIZE], name[512];
  nb_refine_text(level, sizeof level, nb_level_refine(advice, setting->level));
  name_variant(name, sizeof name, advice, &advice->variants[setting->variant]);
  if (step > 0)
    snprintf(length, sizeof length, " (%.3g%s)", step, scene->unitless ? "" : " s");
  printf("    the step%s is %s; %s%s\n", length, level, name, setting->variant == 0 ? ", as in the page" : "");
}

static void print_cost(const struct nb_advice *advice, const struct nb_point *point) {
  const struct nb_point *own = &advice->variants[0].points[-NB_LEVEL_LOW];
  printf("  cost: %.0f recorded values and %.0f contact and particle updates", point->recorded, point->updates);
  if (advice->runs > 1)
    printf(" in all %zu runs of the page", advice->runs);
  if (advice->query->over)
    fputs(" for a realization", stdout);
  printf(", %.3g %% of the %.0f with the page's own setting\n", 100 * point->updates / own->updates, own->updates);
}

enum { REPEATS = 5 };
static const double longest_timing = 5; /* largest time for the measurement of times, s */

static void print_machine(void) {
  FILE *file = fopen("/proc/cpuinfo", "r");
  char line[256], name[128] = "this machine";
  while (file && fgets(line, sizeof line, file))
    if (sscanf(line, "model name : %127[^\n]", name) == 1)
      break;
  if (file)
    fclose(file);
  printf("on %s\n", name);
}

/* Measures the time of the chosen setting and of the page as it is. The two are run alternately. If that would take
 * longer than longest_timing, the times of the trials are printed instead. */
static void time_choice(struct nb_advice *advice, const struct nb_setting *chosen) {
  double times[2][REPEATS];
  const double one = nb_point_at(advice, chosen)->seconds, own = advice->variants[0].points[-NB_LEVEL_LOW].seconds;
  if (REPEATS * (one + own) > longest_timing) {
    printf("  time: %.3g s instead of %.3g s, the shortest of the trials\n", one, own);
    return;
  }
  for (int k = 0; k < REPEATS; k++) {
    times[0][k] = nb_trials_time(advice, &advice->variants[chosen->variant], chosen->level);
    times[1][k] = nb_trials_time(advice, &advice->variants[0], 0);
  }
  char text[2][2 * NB_NAME_SIZE];
  for (int k = 0; k < 2; k++)
    nb_times_text(text[k], sizeof text[k], times[k], REPEATS);
  printf("  time: %s instead of %s, median and range of %d runs ", text[0], text[1], REPEATS);
  print_machine();
}

static void print_choice(struct nb_advice *advice, const struct nb_setting *chosen) {
  char options[256];
  const struct nb_point *point = nb_point_at(advice, chosen);
  nb_advice_options(options, sizeof options, advice, chosen);
  printf("  the cheapest setting within the tolerance: %s\n", options);
  print_setting(advice, chosen);
  fputs("  estimated error: at most ", stdout);
  print_error_of(advice, chosen);
  print_cost(advice, point);
  time_choice(advice, chosen);
  const struct nb_setting *cheaper = nb_advice_cheaper(advice, chosen);
  if (cheaper) {
    nb_advice_options(options, sizeof options, advice, cheaper);
    printf("  the next cheaper setting misses the tolerance: %s\n    estimated error: ", options);
    print_error_of(advice, cheaper);
  }
  const struct nb_point *coarser = chosen->level > NB_LEVEL_LOW ? point - 1 : NULL;
  if (!cheaper && coarser && coarser->reason[0])
    printf("  the next longer step cannot be run: %s\n", coarser->reason);
  nb_advice_options(options, sizeof options, advice, chosen);
  char path[4096] = "";
  nb_append_word(path, sizeof path, advice->query->path);
  printf("to run it: nineball run %s", path);
  print_own_options(advice, options);
  printf(" %s\n", options);
  if (nb_setting_loosens(chosen))
    puts("  checks of the page that have tighter tolerances may fail then");
}

static void print_conditions(const struct nb_advice *advice, const struct nb_setting *chosen) {
  if (advice->query->over)
    printf("  this holds for the mean over realizations (%s = 1 to %zu), with 95 %% confidence; a single run is not "
           "covered, since runs scatter with a standard deviation of %.2g%s%s\n",
           advice->query->over, advice->trials, nb_advice_scatter(advice, chosen), *unit_of_value(advice) ? " " : "",
           unit_of_value(advice));
  if (advice->runs > 1)
    printf("  this holds for the %zu runs of the page; with other values another setting may be the cheapest\n",
           advice->runs);
  else
    puts("  this holds for this page alone; with other values another setting may be the cheapest");
}

/* Prints "  2 other variants give …", or nothing if the count is 0. */
static void print_count(size_t count, const char *one, const char *several, const char *rest) {
  if (count)
    printf("  %zu other variant%s %s %s", count, count > 1 ? "s" : "", count > 1 ? several : one, rest);
}

/* Prints how many variants were left out for each of four reasons: they give the values of another variant, they cannot
 * be run, the budget was used up, or their values are too far from the anchor (estimate.h). Of the last kind it also
 * prints the nearest variant. */
static void print_left_out(const struct nb_advice *advice) {
  const struct nb_left_out out = nb_advice_left_out(advice);
  char name[512];
  print_count(out.equal, "gives", "give", "the same values as another variant\n");
  print_count(out.refused, "cannot", "cannot", "be run with this page\n");
  print_count(out.too_late, "has", "have", "no result, because the budget was used up\n");
  if (nb_advice_softness_is_useless(advice))
    puts("  softer contacts save nothing in this impact: the step is a fraction of the duration of the collision, and "
         "both grow by the same factor");
  print_count(out.farther, "gives", "give", "values that differ too much; ");
  if (out.nearest) {
    name_variant(name, sizeof name, advice, out.nearest);
    printf("the one with the smallest difference is %s: %s\n", name, out.nearest->reason);
  }
  if (out.equal + out.refused + out.too_late + out.farther)
    puts("  (a variant is the page with other contact laws, softer contacts, centred dashpots, or other values of the "
         "names in its `trade` statements)");
}

static void print_advice(struct nb_advice *advice) {
  printf("%s: %s\n", advice->page.page.name, advice->text);
  if (advice->chosen >= 0) {
    print_choice(advice, &advice->settings[advice->chosen]);
    print_conditions(advice, &advice->settings[advice->chosen]);
  } else {
    const struct nb_setting *best = nb_advice_most_accurate(advice);
    char options[256];
    puts("  no setting that was tried is within the tolerance");
    if (best) {
      nb_advice_options(options, sizeof options, advice, best);
      printf("  the most accurate one: %s\n    estimated error: ", options);
      print_error_of(advice, best);
    }
    printf("  %s\n", nb_advice_remedy(advice));
  }
  print_left_out(advice);
  printf("  %u trials in %.1f s%s\n", advice->measured, nb_clock() - advice->began,
         advice->exhausted ? ", the whole budget: not all settings were tried" : "");
}

/* ---- table and figure ---- */

/* Values of `which` besides the index of a variant: write_rows then writes the settings of all variants, or only the
 * chosen setting. */
enum { ALL_VARIANTS = -1, CHOSEN = -2 };
static void write_rows(FILE *out, const struct nb_advice *advice, int which) {
  const struct nb_scene *scene = &advice->page.runs[0].scene;
  for (size_t k = 0; k < advice->setting_count; k++) {
    const struct nb_setting *setting = &advice->settings[k];
    const struct nb_variant *variant = &advice->variants[setting->variant];
    const struct nb_point *point = nb_point_at(advice, setting);
    char values[512] = "";
    append_values(values, sizeof values, advice, variant, false);
    if (which == CHOSEN ? (int)k != advice->chosen : which != ALL_VARIANTS && (int)setting->variant != which)
      continue;
    fprintf(out, "%s\t%s\t%.10g\t%.6g\t%.6g\t%.6g\t%.6g\t%.6g\t%.6g\t%s\t%s\t%s\t%.0f\n",
            word(variant->normal, scene->normal), word(variant->shear, scene->shear), refine_of(advice, setting->level),
            point->step, point->updates, point->seconds, setting->ratio, setting->ratio * advice->tolerance.value,
            setting->step_ratio * advice->tolerance.value,
            (int)k == advice->chosen ? "chosen"
            : setting->ratio <= 1    ? "within"
                                     : "misses",
            label_of(advice, setting->worst)[0] ? label_of(advice, setting->worst) : "-", values[0] ? values : "-",
            point->recorded);
  }
}

static const char head[] = "normal\tshear\trefine\tmean-step\tupdates\tseconds\terror/"
                           "tolerance\terror\terror-of-step\tresult\tworst-run\tvalues\trecorded\n";

static bool has_settings(const struct nb_advice *advice, size_t variant) {
  for (size_t k = 0; k < advice->setting_count; k++)
    if (advice->settings[k].variant == variant)
      return true;
  return false;
}

static void write_figure(FILE *out, const struct nb_outcome *page, const void *data) {
  const struct nb_advice *advice = data;
  (void)page;
  const double factor = advice->tolerance.kind == NB_RELATIVE ? 100 : 1;
  const char *unit = nb_advice_unit(advice);
  const char *between = "plot ";
  for (size_t p = 0; p < advice->variant_count; p++)
    if (has_settings(advice, p)) {
      fprintf(out, "$variant%zu << EOD\n%s", p, head);
      write_rows(out, advice, (int)p);
      fputs("EOD\n", out);
    }
  fprintf(out, "$chosen << EOD\n%s", head);
  write_rows(out, advice, CHOSEN);
  fputs("EOD\n", out);
  double least = INFINITY, most = 0;
  for (size_t k = 0; k < advice->setting_count; k++) {
    const double updates = nb_point_at(advice, &advice->settings[k])->updates;
    least = fmin(least, updates), most = fmax(most, updates);
  }
  fputs("set datafile separator tab\nset logscale xy\nset format xy '10^{%T}'\n", out);
  if (most > 0)
    fprintf(out, "set xrange [%.9g:%.9g]\n", least / 2, 2 * most);
  static const struct nb_escape quote[] = {{'\'', "''"}, {0, NULL}};
  fputs("set title '", out);
  nb_print_escaped(out, advice->text, quote);
  fprintf(out,
          "' noenhanced\nset xlabel 'contact and particle updates of all runs%s'\nset ylabel 'estimated error%s%s'\n",
          advice->query->over ? ", mean over realizations" : "", unit[0] ? ", " : "", unit);
  for (size_t p = 0; p < advice->variant_count; p++)
    if (has_settings(advice, p)) {
      char name[512];
      name_variant(name, sizeof name, advice, &advice->variants[p]);
      fprintf(out, "%s$variant%zu using 5:($8*%g) with linespoints pt 7 lw 2 title '", between, p, factor);
      nb_print_escaped(out, name, quote);
      fputs("' noenhanced", out);
      between = ", \\\n     ";
    }
  if (advice->chosen >= 0)
    fprintf(out, "%s$chosen using 5:($8*%g) with points pt 6 ps 3 lw 2 lc rgb '#a3123a' title 'the advice'", between,
            factor),
        between = ", \\\n     ";
  fprintf(out, "%s%.9g with lines dt 2 lc rgb 'black' title 'tolerance'\n", between, advice->tolerance.value * factor);
}

enum nb_status nb_advice_draw(const struct nb_advice *advice, const char *folder, const char *name, bool trust,
                              struct nb_error *error) {
  const struct nb_script script = {name, &advice->page, write_figure, advice};
  return nb_script_draw(&script, folder, trust, error);
}

/* Writes FOLDER/advice.tsv, advice.gp, advice.svg and advice.png. */
static enum nb_status save_advice(const struct nb_advice *advice, const char *folder, bool trust,
                                  struct nb_error *error) {
  struct nb_save file;
  char name[512];
  if (nb_folder_create(folder, error) || nb_save_begin_in(&file, error, folder, "advice.tsv"))
    return error->status;
  nb_preamble_write(file.file, &advice->page);
  fprintf(file.file, "# %s", advice->text);
  if (advice->query->over)
    fprintf(file.file, ", mean over %s = 1 to %zu", advice->query->over, advice->trials);
  fprintf(file.file, "\n# updates with the page's own setting: %.6g\n%s",
          advice->variants[0].points[-NB_LEVEL_LOW].updates, head);
  write_rows(file.file, advice, ALL_VARIANTS);
  for (int level = NB_LEVEL_LOW; level <= NB_LEVEL_HIGH; level++)
    if (advice->variants[0].points[level - NB_LEVEL_LOW].reason[0])
      fprintf(file.file, "# not run: refine=%.10g: %s\n", refine_of(advice, level),
              advice->variants[0].points[level - NB_LEVEL_LOW].reason);
  for (size_t k = 1; k < advice->variant_count; k++)
    if (advice->variants[k].reason[0]) {
      name_variant(name, sizeof name, advice, &advice->variants[k]);
      fprintf(file.file, "# left out: %s: %s\n", name, advice->variants[k].reason);
    }
  if (nb_save_end(&file, error))
    return error->status;
  return nb_advice_draw(advice, folder, "advice", trust, error);
}

/* ---- the command ---- */

static bool read_realizations(size_t *count, const struct nb_call *call) {
  *count = call->realizations ? (size_t)call->realizations : NB_REALIZATIONS_MIN;
  return (call->over || !call->realizations) && *count >= NB_REALIZATIONS_MIN && *count <= NB_TRIALS;
}

static bool read_budget(double *seconds, const char *text) {
  char *end;
  *seconds = text ? strtod(text, &end) : 60;
  if (!text)
    return true;
  if (strcmp(end, " s") == 0 || strcmp(end, "s") == 0)
    end += strlen(end);
  return end != text && !*end && *seconds > 0 && isfinite(*seconds);
}

static enum nb_status save_and_print(struct nb_advice *advice, const struct nb_call *call) {
  struct nb_error error;
  char name[NB_NAME_SIZE + 8];
  snprintf(name, sizeof name, "%s.out", advice->page.page.name);
  const char *folder = call->folder ? call->folder : name;
  print_advice(advice);
  if (save_advice(advice, folder, call->trust, &error))
    return nb_print_plain_error(&error);
  printf("look at %s/advice.svg; all settings that were tried are in %s/advice.tsv\n", folder, folder);
  return advice->chosen < 0 ? NB_FAILED : NB_OK;
}

enum nb_status nb_command_advise(const struct nb_call *call) {
  struct nb_progress_line line = {.page = call->page_count ? call->pages[0] : NULL};
  struct nb_advise_query query = {.path = call->page_count ? call->pages[0] : NULL,
                                  .settings = call->settings,
                                  .options = call->options,
                                  .quantity = call->quantity,
                                  .within = call->within,
                                  .over = call->over,
                                  .progress = nb_print_progress(&line)};
  struct nb_advice advice;
  struct nb_error error = {0};
  if ((!call->all && (call->page_count != 1 || !call->within)) || !read_budget(&query.budget, call->budget)) {
    fputs("nineball: expected one page and --within TOLERANCE, as in `nineball advise PAGE --within '1 %'`, and with "
          "--budget a number of seconds above 0; for many pages write `nineball advise --all`\n",
          stderr);
    return NB_BAD_USE;
  }
  if (!read_realizations(&query.realizations, call)) {
    fprintf(stderr, "nineball: expected --realizations from %d to %d, together with --over NAME\n", NB_REALIZATIONS_MIN,
            NB_TRIALS);
    return NB_BAD_USE;
  }
  if (call->all)
    return nb_command_advise_all(call, query.budget, query.realizations);
  enum nb_status status = nb_advise(&advice, &query, &error);
  nb_print_progress_end(&line);
  if (advice.page.status)
    nb_print_errors(&advice.page, query.path);
  else if (status)
    nb_print_error(&error, &advice.page.page, query.path);
  else
    status = save_and_print(&advice, call);
  nb_advice_free(&advice);
  return status;
}
