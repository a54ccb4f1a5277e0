/* Writes docs/ACCURACY.md, the document of the calibration of `nineball advise`, from the rows of its results.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "results.h"

enum { KINDS = 16 };
static const char *const estimator_names[] = {"the whole estimator",
                                              "one phase",
                                              "no anchor",
                                              "difference of two steps",
                                              "the reference of each candidate",
                                              "always the finest, an eighth of the page's step"};
static const char *const mean_names[] = {"the whole estimator", "difference of the means alone",
                                         "difference of one realization"};

/* ---- rows ---- */

static double number(const char *text) { return text ? strtod(text, NULL) : NAN; }

static void take_draw(struct results *results, char **fields) {
  struct draw *draw = &results->draws[results->draw_count];
  const char *page = strsep(fields, "\t"), *kind = strsep(fields, "\t"), *result = strsep(fields, "\t");
  if (!result || results->draw_count == DRAWS_MAX)
    return;
  if (strcmp(result, "unresolved") == 0 || strcmp(result, "refused") == 0) {
    results->uncounted[strcmp(result, "refused") == 0]++;
    return;
  }
  *draw = (struct draw){.held_out = is_held_out(page)};
  snprintf(draw->page, sizeof draw->page, "%s", page);
  snprintf(draw->kind, sizeof draw->kind, "%s", kind);
  draw->met = number(strsep(fields, "\t")) > 0;
  draw->seconds = number(strsep(fields, "\t"));
  for (int e = 0; e < ESTIMATORS; e++) {
    draw->choices[e].error = number(strsep(fields, "\t"));
    draw->choices[e].cost = number(strsep(fields, "\t"));
    draw->choices[e].claim = number(strsep(fields, "\t"));
  }
  results->draw_count++;
}

static void take_mean(struct results *results, char **fields) {
  struct mean_draw *draw = &results->means[results->mean_count];
  if (results->mean_count == DRAWS_MAX)
    return;
  snprintf(draw->page, sizeof draw->page, "%s", strsep(fields, "\t"));
  draw->realizations = (size_t)number(strsep(fields, "\t"));
  for (int control = 0; control < MEAN_CONTROLS; control++)
    draw->errors[control] = number(strsep(fields, "\t"));
  draw->answered = !isnan(draw->errors[WITH_STUDENT]);
  draw->claim = number(strsep(fields, "\t"));
  draw->cost = number(strsep(fields, "\t"));
  results->mean_count++;
}

void take_row(struct results *results, char *row) {
  char *fields = row;
  const char *what = strsep(&fields, "\t");
  if (strcmp(what, "draw") == 0)
    take_draw(results, &fields);
  else if (strcmp(what, "mean") == 0)
    take_mean(results, &fields);
  else if (strcmp(what, "error") == 0) {
    const double bin = number(strsep(&fields, "\t")), value = number(strsep(&fields, "\t"));
    if (bin >= 0 && bin < BINS && results->error_count[(size_t)bin] < ERRORS_MAX)
      results->errors[(size_t)bin][results->error_count[(size_t)bin]++] = value;
  }
}

/* ---- the document ---- */

static void write_share(FILE *out, size_t part, size_t whole) {
  if (whole)
    fprintf(out, "%zu of %zu (%.*f %%)", part, whole, part < whole && 200 * part > 199 * whole ? 1 : 0,
            100 * (double)part / (double)whole);
  else
    fputs("none", out);
}

static void write_kinds(FILE *out, const struct results *results) {
  const struct draw *draws = results->draws;
  const size_t draw_count = results->draw_count;
  char kinds[KINDS][64];
  size_t kind_count = 0;
  fputs("| kind of page | draws | answered, of the draws that a setting meets | true error within the tolerance |\n"
        "| --- | --- | --- | --- |\n",
        out);
  for (size_t k = 0; k <= draw_count; k++) {
    size_t same = 0;
    const char *kind = k < draw_count ? draws[k].kind : "all";
    while (same < kind_count && strcmp(kinds[same], kind) != 0)
      same++;
    if (same < kind_count || kind_count == KINDS)
      continue;
    snprintf(kinds[kind_count++], 64, "%.63s", kind);
    const struct score score =
        k < draw_count ? score_of_kind(draws, draw_count, kind) : score_of(draws, draw_count, WHOLE, BOTH_HALVES);
    fprintf(out, "| %s | %zu | ", kind, score.draws);
    write_share(out, score.met_answered, score.met);
    fputs(" | ", out);
    write_share(out, score.within, score.answered);
    fputs(" |\n", out);
  }
}

/* Writes one row of counts and the criteria that do not hold; returns their number. */
static size_t write_score(FILE *out, const char *name, const struct score *score) {
  fprintf(out, "| %s | ", name);
  write_share(out, score->within, score->answered);
  fprintf(out, " | %.0f %% | ", 100 * score->worst_fraction);
  write_share(out, score->met_answered, score->met);
  fprintf(out, " | %.2g; %.2g | %.2g; %.2g | ", score->cost[1], score->cost[2], score->claim[0], score->claim[1]);
  const size_t failures = write_failures(out, score);
  fputs(failures ? " |\n" : "all hold |\n", out);
  return failures;
}

static const char score_head[] =
    " | within the tolerance | in the worst kind | answered, of the draws that a setting meets | cost over the "
    "cheapest: median; 90 % | estimated over true error: 5 %; median | criteria that do not hold |\n"
    "| --- | --- | --- | --- | --- | --- | --- |\n";

/* Writes the scores. Returns true if the whole estimator passes and no control does. */
static bool write_scores(FILE *out, const struct results *results) {
  const struct draw *draws = results->draws;
  const size_t draw_count = results->draw_count;
  static const char *const halves[] = {"pages for tuning", "pages kept back", "all"};
  bool good = true;
  fputs("\n| pages", out);
  fputs(score_head, out);
  for (int half = 0; half <= BOTH_HALVES; half++) {
    const struct score score = score_of(draws, draw_count, WHOLE, (enum half)half);
    const size_t failures = write_score(out, halves[half], &score);
    if (half == BOTH_HALVES && failures > 0) {
      good = false;
      fputs("accuracy: criteria that do not hold: ", stderr);
      write_failures(stderr, &score);
      fputs("\n", stderr);
    }
  }
  fputs(
      "\nThe next table has the negative controls: the same draws with estimators that lack something. Each must fail\n"
      "at least one criterion. They are not asked about draws for which the whole estimator gives no advice.\n\n"
      "- One phase: everything is computed at one phase.\n"
      "- No anchor: Richardson's estimate $G$ alone. Nothing compares a candidate that has other laws with the page.\n"
      "- Difference of two steps: $|Q(n) - Q(2n)|$ at one phase, without an anchor.\n"
      "- The reference of each candidate: the coarsest step, up to that of the page, whose result agrees with the\n"
      "  reference solution of the page with the laws of the candidate.\n"
      "- Always the finest: no estimate. The tolerance counts as the estimated error, and the error at one phase as "
      "the\n"
      "  true error.\n\n"
      "| what chooses the setting",
      out);
  fputs(score_head, out);
  for (int e = 0; e < ESTIMATORS; e++) {
    const struct score score = score_of(draws, draw_count, (enum estimator)e, BOTH_HALVES);
    if (write_score(out, estimator_names[e], &score) == 0 && e != WHOLE) {
      good = false;
      fprintf(stderr, "accuracy: the negative control passes: %s\n", estimator_names[e]);
    }
  }
  return good;
}

/* Writes the errors by steps per collision to the document, and to the header for `nineball explain`. */
static void write_errors(FILE *out, FILE *header, struct results *results) {
  fputs("\n## The error of a step\n\n"
        "The table has the relative errors of the quantities of all draws, at one phase, by the number of time steps\n"
        "during the shortest collision. `nineball explain` prints the row that applies to a page.\n\n"
        "| steps per collision | number of errors | median error | 90 % |\n| --- | --- | --- | --- |\n",
        out);
  fputs("/* Relative errors by steps per collision; written by `make accuracy`, see docs/ACCURACY.md.\n"
        " *\n * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */\n/* clang-format off */\n",
        header);
  for (size_t b = 0; b < BINS; b++) {
    const double from = first_bin * exp2((double)b);
    if (results->error_count[b] < 30)
      continue;
    const double half = quantile(results->errors[b], results->error_count[b], 0.5),
                 most = quantile(results->errors[b], results->error_count[b], 0.9);
    fprintf(out, "| %g to %g | %zu | %.3g %% | %.3g %% |\n", from, 2 * from, results->error_count[b], 100 * half,
            100 * most);
    fprintf(header, "{%g, %zu, %.3g, %.3g},\n", from, results->error_count[b], half, most);
  }
}

/* Writes the controls of means. Returns true if the fraction of answers within the tolerance is large enough with the
 * whole estimator, and with no control. */
static bool write_mean_controls(FILE *out, const struct results *results) {
  bool good = true;
  fputs("| what chooses the setting | true error within the tolerance | at least 95 % |\n| --- | --- | --- |\n", out);
  for (int control = 0; control < MEAN_CONTROLS; control++) {
    size_t within = 0, answered = 0;
    for (size_t d = 0; d < results->mean_count; d++)
      within += results->means[d].errors[control] <= 1, answered += !isnan(results->means[d].errors[control]);
    const bool holds = is_enough(within, answered);
    fprintf(out, "| %s | ", mean_names[control]);
    write_share(out, within, answered);
    fprintf(out, " | %s |\n", holds ? "yes" : "no");
    if (holds != (control == WITH_STUDENT)) {
      good = false;
      fprintf(stderr, "accuracy: means over realizations: %s: %zu of %zu are within the tolerance\n",
              mean_names[control], within, answered);
    }
  }
  return good;
}

/* Writes the answers by the number of realizations of the search. */
static void write_realizations(FILE *out, const struct results *results) {
  fputs("\n| realizations of a search | draws | answered | true error within the tolerance |\n"
        "| --- | --- | --- | --- |\n",
        out);
  for (int k = 0; k < REALIZATIONS; k++) {
    const size_t realizations = (size_t)NB_REALIZATIONS_MIN << k;
    size_t draws = 0, answered = 0, within = 0;
    for (size_t d = 0; d < results->mean_count; d++) {
      const struct mean_draw *draw = &results->means[d];
      const bool counts = draw->realizations == realizations;
      draws += counts, answered += counts && draw->answered;
      within += counts && draw->errors[WITH_STUDENT] <= 1;
    }
    fprintf(out, "| %zu | %zu | ", realizations, draws);
    write_share(out, answered, draws);
    fputs(" | ", out);
    write_share(out, within, answered);
    fputs(" |\n", out);
  }
}

static bool write_means(FILE *out, const struct results *results) {
  static double ratio[DRAWS_MAX], cost[DRAWS_MAX];
  size_t answered = 0, pages = 0, stopped = 0;
  for (size_t d = 0; d < results->mean_count; d++) {
    ratio[d] = results->means[d].claim, cost[d] = results->means[d].cost;
    answered += results->means[d].answered;
    stopped += isinf(results->means[d].errors[WITH_STUDENT]) != 0;
    pages += d == 0 || strcmp(results->means[d].page, results->means[d - 1].page) != 0;
  }
  fprintf(
      out,
      "\n## Means over realizations\n\n"
      "The advice with `--over seed` was tested on %zu pages of assemblies of about a hundred particles, with %d "
      "draws\n"
      "for each.\n"
      "Each draw has its own 8, 16 or 32 realizations. The pages trade a rate of loading or the stiffness. The truth "
      "is\n"
      "the mean over %d other realizations, with half the step of the page. The true error is the error of the mean "
      "over\n"
      "these realizations with the setting. The tolerance is drawn from a range, from the smallest to the largest true "
      "error of the\n"
      "traded values, with the page's step and with twice this step. The lower end is at least %g, and at least twice "
      "the\n"
      "standard error of the change that half the step makes to the mean over these %d realizations. The upper end is "
      "at least\n"
      "8 times the lower end.\n"
      "Of the draws, ",
      pages, MEAN_DRAWS, TRUTH_REALIZATIONS, lowest_of_mean, TRUTH_REALIZATIONS);
  write_share(out, answered, results->mean_count);
  fputs("\nare answered. The others have a tolerance below what the realizations of the search resolve. With more "
        "realizations\n"
        "more draws are answered:\n",
        out);
  write_realizations(out, results);
  fputs("\n", out);
  const bool good = write_mean_controls(out, results);
  fprintf(
      out,
      "\nThe guaranteed stable step differs between realizations. So advice needs a margin, which METHOD defines. In "
      "%zu of\n"
      "the draws the step of the advised setting is too long for at least one of the %d other realizations. Such a "
      "draw "
      "counts\n"
      "as an error above the tolerance.\n"
      "\nThe estimated error over the true one is %.2g in the median, and %.2g at 5 %%. The advised setting costs %.2g "
      "of the\n"
      "page's own setting in the median.\n",
      stopped, TRUTH_REALIZATIONS, quantile(ratio, results->mean_count, 0.5),
      quantile(ratio, results->mean_count, 0.05), quantile(cost, results->mean_count, 0.5));
  return good;
}

static void write_beginning(FILE *out, const struct results *results) {
  static double seconds[DRAWS_MAX];
  for (size_t d = 0; d < results->draw_count; d++)
    seconds[d] = results->draws[d].seconds;
  fputs("# How far the advice can be trusted\n\n"
        "`make accuracy` writes this document ([tests/accuracy.c](../tests/accuracy.c)). A draw is a page, a\n"
        "quantity of its expectations, a condition (one run of the sweep, or all runs) and a relative tolerance.\n"
        "For each draw the program is asked for advice. The true error of the advice is the largest difference,\n"
        "over all runs and phases, from the limit of the page for small steps.\n"
        "[METHOD](METHOD.md#the-accuracy-of-a-step) defines the terms. A setting meets a draw if its true error is\n"
        "within the tolerance. In this document a number *at 5 %* or *at 90 %* is this quantile.\n\n",
        out);
  fprintf(out,
          "There are at most %d draws for each of %zu pages. The tolerance is drawn from %g to %g, uniformly in its "
          "logarithm.\n"
          "The search may take %g s of computing time. It takes %.2g s in the median, and %.2g s at 90 %%.\n\n",
          DRAWS, results->pages, lowest_tolerance, highest_tolerance, search_time,
          quantile(seconds, results->draw_count, 0.5), quantile(seconds, results->draw_count, 0.9));
}

bool write_document(FILE *out, FILE *header, struct results *results) {
  const struct score whole = score_of(results->draws, results->draw_count, WHOLE, BOTH_HALVES);
  size_t zero = 0;
  double largest = 0; /* largest true error among those too small to be known */
  for (size_t d = 0; d < results->draw_count; d++) {
    const struct choice *choice = &results->draws[d].choices[WHOLE];
    if (!isnan(choice->error) && isnan(choice->claim))
      largest = fmax(largest, choice->error), zero += choice->error == 0;
  }
  write_beginning(out, results);
  write_kinds(out, results);
  fprintf(
      out,
      "\nThere is no advice where the anchor is not known well enough, or where no setting is within the\n"
      "tolerance. %zu draws are not counted, because the limit is not known well enough after %g s of computing\n"
      "time. The program refuses %zu more, because the page has more than fifty particles or the quantity cannot be\n"
      "computed.\n"
      "\n## The criteria\n\n"
      "The cheapest setting is the one with the fewest updates of contacts and particles of all settings whose true "
      "error,\n"
      "over all phases and runs, is within the tolerance. An exhaustive grid finds it. The grid has all contact laws, "
      "three\n"
      "softer stiffnesses (a tenth, a hundredth and a thousandth), centred dashpots, and steps a factor of √2 apart. "
      "The steps of advice are a factor of 2 apart. The grid of a draw may take\n"
      "%g s of computing time. The cost is counted for the %zu of %zu answers whose grid was completed.\n\n"
      "The ratio of the estimated to the true error is counted for %zu of %zu answers. Their true error is at\n"
      "least %g times the last change of the limit when the step was halved. The true error of the others is zero "
      "(%zu\n"
      "answers), or at most %.1g of the tolerance. It is due to rounding, or to the small motion that remains in a\n"
      "state of rest. No step makes such an error smaller, and the estimate need not contain it.\n\n"
      "The factors of the estimator come from other draws, which an earlier program made. Half of the pages, by a\n"
      "hash of their names, are kept back: no number may be changed because of their draws. `make accuracy`\n"
      "fails if one of these criteria does not hold for all draws together:\n\n"
      "- At least 95 %% of the answers are within the tolerance, and at least 90 %% in each kind of page.\n"
      "- At least 70 %% of the draws that a setting meets are answered.\n"
      "- The cost over the cheapest is at most 2 in the median, and at most 4 at 90 %%.\n"
      "- The estimated over the true error is 1 to 3 in the median, and at least 1 at 5 %%.\n",
      results->uncounted[UNRESOLVED], truth_time, results->uncounted[REFUSED], grid_time, whole.costs, whole.answered,
      whole.claims, whole.answered, truth_margin, zero, largest);
  bool good = write_scores(out, results);
  write_errors(out, header, results);
  if (results->mean_count)
    good = write_means(out, results) && good;
  return good;
}
