/* The statements of expect blocks, one row each: what an expectation may say behind what is measured, and how the
 * rows of a table become one number. What reads them, `nineball --help scene` and the manual come from here.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "expect_take.h"

/* ---- one number from many ---- */

static const struct nb_reducer_row reducers[] = {
    {"last", NB_LAST, "what was seen last; so it is without any of these words"},
    {"max", NB_MAX, "the largest"},
    {"min", NB_MIN, "the smallest"},
    {"mean", NB_MEAN, "the mean of all rows"},
    {"amplitude", NB_AMPLITUDE, "half of the largest less the smallest"},
    {"frequency", NB_FREQUENCY, "how often it rises through its mean, 1/s"},
    {NULL, NB_LAST, NULL},
};

const struct nb_reducer_row *nb_reducer_rows(void) { return reducers; }

/* ---- what is expected of it ---- */

static bool take_swept(struct nb_reader *reader, const struct nb_scene *scene, char name[2 * NB_NAME_SIZE]) {
  char hint[NB_HINT_SIZE];
  const struct nb_token *token = nb_take(reader, "the name of a `sweep`");
  if (!token)
    return false;
  snprintf(name, 2 * NB_NAME_SIZE, "%s", token->text);
  struct nb_guess guess = nb_guess_begin(token->text);
  for (size_t k = 0; k < scene->binding_count; k++) {
    const struct nb_binding *binding = &scene->bindings[k];
    if (binding->sweep < 0)
      continue;
    if (strcmp(binding->name, token->text) == 0)
      return true;
    nb_guess_offer(&guess, binding->name);
  }
  return nb_not_known(reader, token, nb_guess_hint(&guess, hint), "the name of a `sweep`");
}

/* `among NAME`, or nothing: the sweep whose runs are a sample. */
static bool take_among(struct nb_reader *reader, const struct nb_scene *scene, struct nb_expectation *expectation) {
  return !nb_token_skip(reader, "among") || take_swept(reader, scene, expectation->among);
}

/* `[CS79 figure 6]`, several tokens. */
static bool take_source(struct nb_reader *reader, struct nb_expectation *expectation) {
  const struct nb_token *token = nb_token_peek(reader);
  if (!token || token->text[0] != '[') {
    nb_expected(reader, "a number from a paper names its place: `[CS79 figure 6]`", "the source in brackets");
    return false;
  }
  while ((token = nb_token_peek(reader))) {
    const size_t length = strlen(expectation->source);
    snprintf(expectation->source + length, sizeof expectation->source - length, "%s%s", length ? " " : "", token->text);
    reader->next++;
    if (token->text[strlen(token->text) - 1] == ']')
      return true;
  }
  nb_expected(reader, NULL, "a closing bracket `]`");
  return false;
}

/* A percentage of a reference that is 0 allows no error, so it cannot have been meant. */
static bool refuse_share_of_zero(struct nb_reader *reader, const struct nb_expectation *expectation, bool zero,
                                 size_t at) {
  if (!zero || expectation->tolerance.kind != NB_RELATIVE || reader->bad)
    return true;
  nb_token_mistake(reader, &reader->tokens[at],
                   "give it a unit, or name what it is a share of: `within 1 % of energy.kinetic max`",
                   "expected a tolerance that is no share of 0, found `%s`", expectation->tolerance.text);
  return false;
}

static bool take_within(struct nb_reader *reader, const struct nb_scene *scene, struct nb_expectation *expectation) {
  const struct nb_measure *measure = &expectation->measure;
  const size_t at = reader->next + 1;
  return nb_take_tolerance(reader, scene, measure->unit, &expectation->tolerance) &&
         refuse_share_of_zero(reader, expectation, measure->vanishes, at);
}

static bool take_along(struct nb_reader *reader, const struct nb_scene *scene, struct nb_expectation *expectation) {
  reader->next++;
  const struct nb_token *token = nb_take(reader, "a quantity that the scene records");
  struct nb_quantity quantity;
  if (!token || !nb_find_column(reader, scene, token, &expectation->along_column, &quantity))
    return false;
  snprintf(expectation->along, sizeof expectation->along, "%s", token->text);
  return nb_take_stage(reader, scene, &expectation->measure) &&
         nb_take_tolerance(reader, scene, expectation->measure.unit, &expectation->tolerance);
}

static bool take_stated(struct nb_reader *reader, const struct nb_scene *scene, struct nb_expectation *expectation) {
  reader->next++;
  const struct nb_token *number = nb_token_peek(reader);
  const bool share = number && reader->next + 1 < reader->count &&
                     (strcmp(number[1].text, "of") == 0 || strcmp(number[1].text, "%") == 0);
  if (!(share ? nb_take_number(reader, NB_UNIT_NUMBER, NB_ANY, &expectation->stated)
              : nb_take_in(reader, expectation->measure.unit, &expectation->stated)))
    return false;
  expectation->has_scale = share;
  if (share && !nb_token_skip(reader, "of")) {
    nb_expected(reader, "a share is of something: `15 % of C.normal mean`", "`of` and a quantity");
    return false;
  }
  if (share && !nb_take_measure(reader, scene, &expectation->other))
    return false;
  if (!take_among(reader, scene, expectation))
    return false;
  const size_t at = reader->next + 1;
  return (expectation->among[0] ||
          (nb_take_tolerance(reader, scene, expectation->has_scale ? "1" : expectation->measure.unit,
                             &expectation->tolerance) &&
           refuse_share_of_zero(reader, expectation, expectation->stated == 0, at))) &&
         take_source(reader, expectation);
}

static bool take_other(struct nb_reader *reader, const struct nb_scene *scene, struct nb_expectation *expectation) {
  reader->next++;
  return nb_take_measure(reader, scene, &expectation->other);
}

static bool take_trend(struct nb_reader *reader, const struct nb_scene *scene, struct nb_expectation *expectation) {
  reader->next++;
  return nb_take_word(reader, "with") && take_swept(reader, scene, expectation->along) &&
         take_among(reader, scene, expectation);
}

static bool take_same(struct nb_reader *reader, const struct nb_scene *scene, struct nb_expectation *expectation) {
  reader->next++;
  return nb_take_word(reader, "over") && take_swept(reader, scene, expectation->along) &&
         take_among(reader, scene, expectation) &&
         nb_take_tolerance(reader, NULL, expectation->measure.unit, &expectation->tolerance);
}

static bool take_order(struct nb_reader *reader, const struct nb_scene *scene, struct nb_expectation *expectation) {
  reader->next++;
  return nb_take_number(reader, NB_UNIT_NUMBER, NB_ANY, &expectation->stated) && nb_take_word(reader, "over") &&
         take_swept(reader, scene, expectation->along) && nb_take_tolerance(reader, NULL, "1", &expectation->tolerance);
}

/* clang-format off */
static const struct nb_expectation_row rows[] = {
  {"within", NB_WITHIN, "MEASURE within TOLERANCE", take_within,
   "What was seen is what the reference knows; a residual should be 0. TOLERANCE: `0.1 %` or `10 ppm` of it, `2 nm` with "
   "a unit, a bare `1e-12` of what has none, `1e-12 of energy.kinetic max` of another measure.",
   "C.normal max in strike  within 0.1 %"},
  {"along", NB_ALONG, "QUANTITY along COLUMN {in STAGE} within TOLERANCE", take_along,
   "The same of a curve, at every row; COLUMN is what the reference knows it along. `0.5 % of peak`: of the largest "
   "known value.",
   "C.normal along time in strike  within 0.5 % of peak"},
  {"stated", NB_STATED, "MEASURE stated NUMBER {of MEASURE} within TOLERANCE [SOURCE]", take_stated,
   "What was seen is a number that somebody states, and SOURCE says who. With `of` it is a share of another measure. "
   "`stated NUMBER among NAME [SOURCE]`: where it lies among the runs of a sweep, one draw among many; that is said, and fails "
   "nothing.",
   "time at 0 cycles  stated 0 s within 0 s  [the clock starts]\n"
   "C.normal in part  stated 0 of C.normal max in strike within 0.01  [the discs part]"},
  {"below", NB_LESS, "MEASURE below MEASURE", take_other, "Two measures of the same run.",
   "C.overlap in part  below  C.overlap max in strike"},
  {"above", NB_MORE, "MEASURE above MEASURE", take_other, "Likewise.",
   "C.normal max in strike  above  C.normal mean in strike"},
  {"rises", NB_RISES, "MEASURE rises with NAME {among SAMPLE}", take_trend,
   "NAME is a sweep: from each of its values to the next, while other sweeps stay where they are. With `among` the runs of the "
   "sweep SAMPLE are a sample of the same: the mean of their differences is above 0 with 95 % confidence (Student).",
   "C.normal max in strike  rises with speed"},
  {"falls", NB_FALLS, "MEASURE falls with NAME {among SAMPLE}", take_trend, "Likewise.",
   "A.vx in strike  falls with speed"},
  {"same", NB_SAME, "MEASURE same over NAME {among SAMPLE} within TOLERANCE", take_same,
   "For all values of a sweep: the largest less the smallest; a share is of their mean. With `among`: the interval of 95 % "
   "confidence of every mean difference lies within.",
   "time at 100 cycles in strike  same over speed within 1 ns"},
  {"order", NB_ORDER, "MEASURE order NUMBER over NAME within TOLERANCE", take_order,
   "The error goes with this power of the swept NAME: the slope of the best straight line through log(error) against "
   "log(NAME). The "
   "error is seen less known; a residual is an error by itself.",
   "C.normal max in strike  order 2 over speed  within 0.1"},
  {NULL, NB_WITHIN, NULL, NULL, NULL, NULL},
};
/* clang-format on */

const struct nb_expectation_row *nb_expectation_rows(void) { return rows; }
