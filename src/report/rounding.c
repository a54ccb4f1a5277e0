/* `check PAGE --rounding all`: the number of bits of the expected quantities that do not depend on the rounding mode.
 *
 * The page runs with the four rounding modes of IEEE 754. A mode applies to the cycles, or to the steps of a contact
 * test. The reader, reference solutions, recorded values and the verdict always round to nearest.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "bits.h"
#include "commands.h"
#include "core/model.h"

static const char *const mode_words[NB_ROUNDINGS] = {"nearest", "up", "down", "zero"};

/* The fewest bits of expectation number `index`, over all runs and all modes so far; `run` is the run that has them. */
struct least {
  int bits;
  size_t run, index;
};

static void lower_bits(struct least *least, const struct nb_outcome *outcome, const struct nb_outcome *nearest) {
  for (size_t r = 0; r < nearest->run_count; r++)
    for (size_t k = 0; k < nearest->runs[r].expectations.count; k++) {
      const int bits = nb_expected_bits(&outcome->runs[r], &nearest->runs[r], k);
      if (bits < least[k].bits)
        least[k] = (struct least){bits, r, k};
    }
}

static enum nb_status make(struct nb_outcome *outcome, const struct nb_call *call, const char *path,
                           struct nb_rounding rounding) {
  struct nb_options options = call->options;
  struct nb_progress_line line = {.page = path};
  const struct nb_progress progress = nb_print_progress(&line);
  options.rounding = rounding;
  if (!nb_outcome_read(outcome, path, call->settings)) /* nb_outcome_make would not keep all scenes */
    outcome->status = nb_outcome_run(outcome, &options, &progress);
  if (!outcome->status)
    outcome->status = nb_verdict(outcome);
  nb_print_progress_end(&line);
  return outcome->status;
}

/* Prints the statement of the page, without indentation and comment. */
static void print_statement(const struct nb_outcome *outcome, const struct nb_expectation *e) {
  const char *statement = outcome->page.lines[e->line - 1];
  statement += strspn(statement, " \t");
  size_t length = strcspn(statement, "#");
  while (strchr(" \t", statement[length - 1])) /* it has a word, so this ends */
    length--;
  printf("%.*s", (int)length, statement);
}

/* Prints the bits of each expectation, and the run in which it has the fewest. Returns the fewest of all
 * expectations. */
static struct least print_bits(const struct nb_outcome *nearest, const struct least *all, size_t count) {
  struct least least = {NB_ALL_BITS, 0, 0};
  puts("  bits that do not depend on the rounding mode, of 53:");
  for (size_t k = 0; k < count; k++) {
    const struct nb_page_run *run = &nearest->runs[all[k].run];
    char bits[8] = "-";
    if (nb_expected_has_bits(run, k))
      snprintf(bits, sizeof bits, "%d", all[k].bits);
    printf("    %2s  ", bits), print_statement(nearest, &run->expectations.list[k]);
    printf("%s%s%s\n", run->label[0] ? " (" : "", run->label, run->label[0] ? ")" : "");
    least = all[k].bits < least.bits ? all[k] : least;
  }
  return least;
}

/* Repeats the run with one part of the cycle rounded up, then down. Prints the smaller of the two numbers of bits of
 * expectation number `index`. */
static void try_part(const struct nb_call *call, const struct nb_page_run *nearest, size_t index, const char *part) {
  struct nb_options options = call->options;
  int bits = NB_ALL_BITS;
  for (int mode = NB_UPWARD; mode <= NB_DOWNWARD; mode++) {
    struct nb_page_run run = {.expectations.reference = NULL};
    options.rounding = (struct nb_rounding){.mode = mode, .part = part};
    const bool failed = nb_run(&run.result, &nearest->scene, &options, NULL, &run.error);
    const int now = failed ? 0 : nb_expected_bits(&run, nearest, index);
    bits = now < bits ? now : bits;
    nb_result_free(&run.result);
  }
  printf("    %2d  %s\n", bits, part);
}

enum { MOST_PARTS = 64 }; /* a model has about twenty */

/* Adds a part unless the list has it. The names of the parts belong to the model. */
static void add_part(const char **parts, size_t *count, const char *part) {
  size_t k = 0;
  while (k < *count && strcmp(parts[k], part) != 0)
    k++;
  if (k == *count && *count < MOST_PARTS)
    parts[(*count)++] = part;
}

/* Tries the parts of the cycle at the start of the run: motion, search, hooks, passes. */
static enum nb_status try_parts(const struct nb_call *call, const struct nb_outcome *nearest, struct least least) {
  struct nb_error error;
  const struct nb_page_run *run = &nearest->runs[least.run];
  const char *parts[MOST_PARTS] = {"motion", "search"};
  size_t count = 2;
  struct nb_model *model = nb_model_create(&run->scene, &call->options, &error);
  if (!model) {
    nb_print_error(&error, &nearest->page, nearest->page.path);
    return error.status;
  }
  for (int w = 0; w < NB_WHENS; w++)
    for (size_t h = 0; h < model->hooks[w].count; h++)
      add_part(parts, &count, model->hooks[w].list[h].name);
  for (size_t p = 0; p < model->material_pair_count; p++)
    for (int k = 0; k < model->material_pairs[p].pass_count; k++)
      add_part(parts, &count, model->material_pairs[p].passes[k].name);
  fputs("  with one part of the cycle rounded up and down, bits of: ", stdout);
  print_statement(nearest, &run->expectations.list[least.index]), puts("");
  for (size_t k = 0; k < count; k++)
    try_part(call, run, least.index, parts[k]);
  nb_model_free(model);
  return NB_OK;
}

/* Runs the page in the other modes. */
static enum nb_status try_modes(struct least *least, const struct nb_call *call, const struct nb_outcome *nearest) {
  enum nb_status worst = nearest->status;
  for (int mode = NB_UPWARD; mode < NB_ROUNDINGS && worst <= NB_FAILED; mode++) {
    struct nb_outcome outcome;
    const size_t *marks = outcome.mark_count;
    const enum nb_status status = make(&outcome, call, nearest->page.path, (struct nb_rounding){.mode = mode});
    if (status > NB_FAILED) {
      fprintf(stderr, "nineball: with rounding %s:\n", mode_words[mode]);
      nb_print_errors(&outcome, nearest->page.path);
    } else {
      lower_bits(least, &outcome, nearest);
      printf("  rounding %-4s  %zu of %zu checks passed\n", mode_words[mode], marks[NB_PASS],
             marks[NB_PASS] + marks[NB_FAIL]);
    }
    worst = nb_worse(worst, status);
    nb_outcome_free(&outcome);
  }
  return worst;
}

static enum nb_status check_page(const struct nb_call *call, const char *path, bool parts) {
  struct nb_outcome nearest;
  struct nb_error error;
  enum nb_status status = make(&nearest, call, path, (struct nb_rounding){NB_TO_NEAREST, NULL});
  const size_t count = nearest.run_count ? nearest.runs[0].expectations.count : 0;
  struct least *all = malloc((count + 1) * sizeof *all);
  if (!all)
    nb_error_memory(&error), status = nb_print_plain_error(&error);
  for (size_t k = 0; k < count && all; k++)
    all[k] = (struct least){NB_ALL_BITS, 0, k};
  nb_print_errors(&nearest, path);
  if (status <= NB_FAILED) {
    nb_print_verdict(&nearest);
    status = try_modes(all, call, &nearest);
  }
  if (status <= NB_FAILED) {
    const struct least least = print_bits(&nearest, all, count);
    if (parts && least.bits < NB_ALL_BITS && !nearest.runs[0].scene.contact_test)
      status = nb_worse(status, try_parts(call, &nearest, least));
  }
  free(all);
  nb_outcome_free(&nearest);
  return status;
}

enum nb_status nb_rounding_check(const struct nb_call *call) {
  enum nb_status worst = NB_OK;
  const bool parts = strcmp(call->rounding, "parts") == 0;
  if (call->tap || (!parts && strcmp(call->rounding, "all") != 0)) {
    fprintf(stderr, "nineball: expected `--rounding all` or `parts`%s, found `%s`\n", call->tap ? " without --tap" : "",
            call->rounding);
    return NB_BAD_USE;
  }
  if (call->options.checkpoint.seconds > 0) {
    fputs("nineball: --rounding takes neither --checkpoint nor --resume\n", stderr);
    return NB_BAD_USE;
  }
  for (size_t k = 0; k < call->page_count; k++)
    worst = nb_worse(worst, check_page(call, call->pages[k], parts));
  return worst;
}
