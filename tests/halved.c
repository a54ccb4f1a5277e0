/* Every page with each of its stages cut into two halves. The second half has no statements, or repeats those of its
 * stage: the results must be the same, whatever the stage sets. Continuing from the state at the end of a half must
 * give the same bits at the end of the next half.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../src/core/names.h"
#include "../src/run/plan.h"
#include "../src/run/state.h"
#include "every_page.h"
#include "suites.h"

/* The results at the end of a stage. */
struct stage_end {
  char *state;
  double *values; /* of the columns */
  double step;
};

static const struct nb_options options = {.threads = 1, .keep_all = true};

/* Stores the present results of the model. */
static void look(struct stage_end *ends, const struct nb_model *model) {
  const struct nb_scene *scene = model->scene;
  struct nb_saved saved;
  struct nb_error error = {NB_OK, ""};
  size_t size;
  CU_ASSERT_EQUAL_FATAL(nb_saved_capture(&saved, model, &error), NB_OK);
  ends->state = nb_saved_text(&saved, &size);
  nb_saved_free(&saved);
  ends->values = calloc(scene->column_count, sizeof *ends->values);
  for (size_t c = 0; c < scene->column_count; c++)
    ends->values[c] = nb_quantity_value(scene->columns[c].quantity, model);
  ends->step = model->step;
}

static void forget(struct stage_end *ends, size_t count) {
  for (size_t s = 0; s < count; s++)
    free(ends[s].state), free(ends[s].values);
  free(ends);
}

/* Runs stage s to its last cycle; false if the run is aborted. */
static bool run_stage(struct nb_model *model, size_t s) {
  struct nb_error error = {NB_OK, ""};
  const struct nb_stage *stage = &model->scene->stages[s];
  enum nb_status status = nb_stage_begin(model, stage, &error);
  for (unsigned long k = 0; k < stage->cycles && !status; k++)
    status = nb_cycle(model, &error);
  if (status)
    printf("# stage %zu: %s\n", s + 1, error.text);
  return status == NB_OK;
}

/* The results at the end of each stage; *count: the number of stages that ran. */
static struct stage_end *run_all(const struct nb_scene *scene, size_t *count) {
  struct nb_error error = {NB_OK, ""};
  struct nb_model *model = nb_model_create(scene, &options, &error);
  CU_ASSERT_PTR_NOT_NULL_FATAL(model);
  struct stage_end *ends = calloc(scene->stage_count, sizeof *ends);
  for (*count = 0; *count < scene->stage_count && run_stage(model, *count); ++*count)
    look(&ends[*count], model);
  nb_model_free(model);
  return ends;
}

/* ---- halves ---- */

/* The second half of a stage, without statements. A servo and a ramp end with their stage. */
static struct nb_stage silent(const struct nb_stage *stage) {
  struct nb_stage half = *stage;
  half.motion_count = half.change_count = 0;
  half.servo.line = half.gravity.line = half.circle.line = half.boundary.line = half.affine.line = 0;
  half.cell_line = half.box_line = half.rotation_line = 0, half.rotation = NB_ROTATION_AS_BEFORE;
  half.laws.normal[0] = half.laws.shear[0] = '\0', half.laws.normal_line = half.laws.shear_line = 0;
  return half;
}

/* The halved stages of a scene: stage s becomes the stages 2 s and 2 s + 1. `again`: the second half repeats the
 * statements of the stage. */
static struct nb_stage *halves(const struct nb_scene *scene, bool again) {
  struct nb_stage *stages = calloc(2 * scene->stage_count, sizeof *stages);
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    struct nb_stage *first = &stages[2 * s], *second = first + 1;
    *first = *stage, *second = again ? *stage : silent(stage);
    first->cycles = stage->cycles / 2, second->cycles = stage->cycles - first->cycles;
    first->snapshot = false, first->snapshot_from = -1;
    second->snapshot_from = stage->snapshot_from < 0 ? -1 : 2 * stage->snapshot_from;
    /* A repeated `rotation` would divide the last half step again, with other rounding. */
    second->rotation = NB_ROTATION_AS_BEFORE, second->rotation_line = 0;
    second->removal_count = 0, second->zero_velocities = second->reverse_velocities = false, second->circle.line = 0;
  }
  return stages;
}

/* At least two cycles per stage, and no `until` conditions. */
static void two_cycles_each(struct nb_scene *scene) {
  for (size_t s = 0; s < scene->stage_count; s++) {
    struct nb_stage *stage = &scene->stages[s];
    stage->cycles = stage->cycles < 2 ? 2 : stage->cycles;
    stage->condition_count = 0;
  }
}

/* True if the stage has a ramp or a servo: its halves together then differ from the whole. */
static bool ramps(const struct nb_stage *stage) {
  bool any = stage->gravity.ramp || stage->servo.line;
  for (size_t k = 0; k < stage->motion_count; k++)
    any = any || stage->motions[k].ramp;
  for (size_t k = 0; k < stage->change_count; k++)
    any = any || stage->changes[k].ramp;
  return any;
}

/* ---- what must be the same ---- */

static bool begins(const char *text, const char *with) { return strncmp(text, with, strlen(with)) == 0; }

/* True for quantities that a continued run does not reproduce: sums since the start of the run or of the stage,
 * quantities that need the previous step, and quantities that depend on which pairs are listed, because a run begins
 * with a search. */
static bool counted(const char *name) {
  const bool strain = strstr(name, ".strain.") && !begins(name, "cell.") && !begins(name, "boundary.");
  return strstr(name, ".new") || strstr(name, ".lost") || begins(name, "energy.") || begins(name, "work.") ||
         strcmp(name, "contacts.deep") == 0 || strain || strcmp(name, "step.fracc") == 0 ||
         strcmp(name, "step.stable") == 0;
}

/* True for times, which are summed from the beginning of the stage and so round differently. */
static bool timed(const char *name) {
  return strcmp(name, "time") == 0 || strcmp(name, "impact.time") == 0 || strcmp(name, "impact.duration") == 0;
}

static bool same(double a, double b, double fraction) {
  return a == b || (isnan(a) && isnan(b)) || fabs(a - b) <= fraction * fmax(fabs(a), fabs(b));
}

/* Compares the quantities. `counts`: also those that a continued run does not reproduce; `rounds`: without
 * residuals. */
static bool same_values(const struct nb_scene *scene, const struct stage_end *a, const struct stage_end *b,
                        const char *name, const char *what, bool counts, bool rounds) {
  bool held = true;
  for (size_t c = 0; c < scene->column_count && held; c++) {
    const char *column = scene->columns[c].name;
    const bool of_stage = strcmp(column, "stage.time") == 0; /* the stages of the two runs begin at different times */
    if (of_stage || (!counts && counted(column)) || (rounds && nb_quantity_is_residual(scene->columns[c].quantity)))
      continue;
    held = same(a->values[c], b->values[c], timed(column) ? 1e-12 : 0);
    if (!held)
      printf("# %s, %s: %s is %.17g, expected %.17g\n", name, what, column, b->values[c], a->values[c]);
  }
  return held;
}

/* Compares two texts and moves both pointers to the first difference. The sign of a zero does not count, because it
 * affects no other result. */
static bool same_text(const char **a, const char **b) {
  static const char zero[] = "-0x0p+0";
  for (; **a && **b; ++*a, ++*b) {
    *a += strncmp(*a, zero, sizeof zero - 1) == 0, *b += strncmp(*b, zero, sizeof zero - 1) == 0;
    if (**a != **b)
      return false;
  }
  return **a == **b;
}

/* Compares all records before the checksum. Without `times` compares only the records from `units` on; names and times
 * come before `units`. */
static bool same_states(const struct stage_end *a, const struct stage_end *b, const char *name, const char *what,
                        bool times) {
  const char *one = times ? a->state : strstr(a->state, "\nunits"),
             *other = times ? b->state : strstr(b->state, "\nunits");
  if (same_text(&one, &other) || !strstr(one, "\nend "))
    return true;
  printf("# %s, %s: the states differ: `%.60s` and `%.60s`\n", name, what, one, other);
  return false;
}

static void check_halves(struct nb_scene *scene, const char *name, bool again) {
  const size_t count = scene->stage_count;
  struct nb_stage *stages = scene->stages;
  bool one_way = true;
  size_t whole, parts;
  struct stage_end *uncut = run_all(scene, &whole);
  struct nb_stage *cut = halves(scene, again);
  for (size_t s = 0; s < whole; s++)
    for (size_t h = 0; h < 2; h++)
      cut[2 * s + h].step.kind = NB_STEP_TIME, cut[2 * s + h].step.value = uncut[s].step;
  scene->stages = cut, scene->stage_count = 2 * whole;
  for (size_t r = 0; r < scene->region_count; r++)
    scene->regions[r].stage *= scene->regions[r].stage > 0 ? 2 : 1;
  struct stage_end *ends = run_all(scene, &parts);
  for (size_t s = 0; s < whole && one_way && 2 * s + 1 < parts; s++) {
    char what[64];
    snprintf(what, sizeof what, "stage %zu in two%s", s + 1, again ? ", statements repeated" : "");
    one_way = !ramps(&stages[s]);
    if (one_way) {
      CU_ASSERT(same_values(scene, &uncut[s], &ends[2 * s + 1], name, what, true, again));
      CU_ASSERT(same_states(&uncut[s], &ends[2 * s + 1], name, what, false));
    }
  }
  for (size_t r = 0; r < scene->region_count; r++)
    scene->regions[r].stage /= scene->regions[r].stage > 0 ? 2 : 1;
  scene->stages = stages, scene->stage_count = count;
  forget(uncut, count), forget(ends, 2 * whole);
  free(cut);
}

static void halves_are_the_whole(struct nb_scene *scene, const char *name) {
  if (scene->contact_test || scene->start.stages > 0)
    return;
  two_cycles_each(scene);
  for (int again = 0; again < 2; again++)
    check_halves(scene, name, again);
}

static void every_stage_in_two(void) { every_page(halves_are_the_whole, 1.2e4); }

/* ---- from a state ---- */

/* Continues from the state at the end of stage s, and compares the results at the end of the next one. */
static void go_on(struct nb_scene *scene, const struct stage_end *from, const struct stage_end *to, size_t s,
                  const char *name) {
  struct nb_saved saved;
  struct nb_error error = {NB_OK, ""};
  struct stage_end here, there;
  char what[64];
  snprintf(what, sizeof what, "from half %zu", s + 1);
  scene->start.stages = s + 1;
  if (nb_saved_read_text(&saved, "a.state", from->state, strlen(from->state), &error) ||
      nb_saved_fits(&saved, scene, "a.state", &error))
    printf("# %s, %s: %s\n", name, what, error.text);
  CU_ASSERT_EQUAL_FATAL(error.status, NB_OK);
  struct nb_model *model = nb_model_resume(scene, &options, &saved, &error);
  nb_saved_free(&saved);
  if (!model)
    printf("# %s, %s: %s\n", name, what, error.text);
  CU_ASSERT_PTR_NOT_NULL_FATAL(model);
  look(&here, model);
  CU_ASSERT(same_states(from, &here, name, what, true));
  CU_ASSERT(same_values(scene, from, &here, name, what, false, false));
  free(here.state), free(here.values);
  CU_ASSERT_FATAL(run_stage(model, s + 1));
  look(&there, model);
  CU_ASSERT(same_states(to, &there, name, what, true));
  CU_ASSERT(same_values(scene, to, &there, name, what, false, false));
  free(there.state), free(there.values);
  nb_model_free(model);
  scene->start.stages = 0;
}

/* Optional records of a state. Each of them must occur in the state of some page. */
static const char *const records[] = {"impact",   "rotation", "cell", "centre", "carrier", "pair",  "carried",
                                      "boundary", "members",  "wall", "fields", "contact", "shear", "inward"};
enum { RECORDS = sizeof records / sizeof *records };
static bool written[RECORDS];

static void note_records(const char *state) {
  char word[32];
  for (int r = 0; r < RECORDS; r++) {
    snprintf(word, sizeof word, "\n%s ", records[r]);
    written[r] = written[r] || strstr(state, word);
  }
}

static void states_go_on(struct nb_scene *scene, const char *name) {
  if (scene->contact_test || scene->start.stages > 0)
    return;
  struct nb_stage *stages = scene->stages, *cut;
  const size_t count = scene->stage_count;
  size_t parts;
  two_cycles_each(scene);
  scene->stages = cut = halves(scene, false), scene->stage_count = 2 * count;
  struct stage_end *ends = run_all(scene, &parts);
  for (size_t s = 0; s + 1 < parts; s++)
    note_records(ends[s].state), go_on(scene, &ends[s], &ends[s + 1], s, name);
  scene->stages = stages, scene->stage_count = count;
  forget(ends, 2 * count);
  free(cut);
}

static void every_half_from_a_state(void) {
  every_page(states_go_on, 1.2e4);
  for (int r = 0; r < RECORDS; r++) {
    if (!written[r])
      printf("# in no state of a page: %s\n", records[r]);
    CU_ASSERT(written[r]);
  }
}

void suite_halved(void) {
  CU_pSuite suite = CU_add_suite("halved", NULL, NULL);
  CU_add_test(suite, "every stage of every page in two halves", every_stage_in_two);
  CU_add_test(suite, "every half continued from the state of the half before", every_half_from_a_state);
}
