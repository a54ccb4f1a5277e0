/* `nineball explain` prints the state from which a page starts, its particles, the passes of a cycle with the lines of
 * the page that request them, and its hooks. Then it prints memory, the time step and what limits it, and the
 * statements of each stage with the values of this run. For a contact test it prints the contact, its laws and its
 * segments.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "core/clean.h"
#include "core/model.h"
#include "core/names.h"
#include "input/reader.h"
#include "laws/law.h"
#include "laws/laws_now.h"
#include "loading/loading.h"
#include "measure/balance.h"
#include "measure/configuration.h"
#include "measure/region.h"
#include "measure/step.h"
#include "report/cost.h"
#include "run/contact_test.h"
#include "run/plan.h"
#include "run/restart.h"

/* ---- statements of the page, with the values of this run ---- */

/* Reads a line of the page; false: the line is not a statement. */
static bool read_statement(struct nb_reader *reader, const struct nb_scene *scene, size_t line) {
  const unsigned char *kind = scene->page->kind_of;
  struct nb_mistakes none = {0}; /* the page has been read without mistakes */
  *reader = (struct nb_reader){.page = scene->page, .mistakes = &none};
  reader->bindings = scene->bindings, reader->binding_count = scene->binding_count;
  const bool read = kind[line - 1] == 1 + (scene->contact_test ? NB_BLOCK_CONTACT_TEST : NB_BLOCK_SCENE) &&
                    nb_line_read(reader, line);
  nb_mistakes_free(&none);
  reader->mistakes = NULL;
  return read;
}

static void print_statement(FILE *out, const struct nb_reader *reader) {
  fprintf(out, "line %zu:", reader->line);
  for (size_t k = 0; k < reader->count; k++)
    fprintf(out, " %s", reader->tokens[k].text);
}

/* Prints the statement on this line; nothing if line is 0 or no statement of the page. */
static void explain_statement(FILE *out, const struct nb_scene *scene, int line, const char *end) {
  struct nb_reader reader;
  if (line == 0 || !read_statement(&reader, scene, (size_t)line))
    return;
  fputs("  ", out);
  print_statement(out, &reader);
  fputs(end, out);
}

/* Prints the statements of a stage or a segment. Statements after `start` belong to the first stage. */
static void explain_statements(FILE *out, const struct nb_scene *scene, size_t stage) {
  const size_t line = (size_t)scene->stages[stage].line;
  const bool is_first = scene->start.line && stage == scene->start.stages;
  size_t end = line ? scene->page->line_count + 1 : 0; /* a segment of --set follow=FILE has no line */
  for (size_t s = scene->start.stages; s < scene->stage_count; s++)
    if ((size_t)scene->stages[s].line > line && (size_t)scene->stages[s].line < end)
      end = (size_t)scene->stages[s].line;
  struct nb_reader reader;
  for (size_t k = is_first ? (size_t)scene->start.line + 1 : line; k < end; k++) {
    if ((k == line && !scene->contact_test) || !read_statement(&reader, scene, k))
      continue;
    fputs("    ", out);
    print_statement(out, &reader);
    fputc('\n', out);
  }
}

/* ---- the beginning of the scene ---- */

/* Prints the state from which the page starts, then the state from which the page of that state starts, and so on. */
static void explain_start(FILE *out, const struct nb_scene *scene, const struct nb_options *options) {
  static const char *const words[] = {[NB_STATE_PRESENT] = "present",
                                      [NB_STATE_OUTDATED] = "out of date, will be computed again",
                                      [NB_STATE_MISSING] = "missing, will be computed"};
  char path[4096];
  struct nb_error error;
  if (scene->start.stages > 0)
    fprintf(out, "start\n");
  for (const struct nb_scene *stage_scene = scene; stage_scene->start.stages > 0;
       stage_scene = stage_scene->start.scene) {
    const struct nb_start *start = &stage_scene->start;
    fprintf(out, "  at the end of stage `%s` of `%s`", start->scene->stages[start->scene->stage_count - 1].name,
            start->page->name);
    for (size_t k = 0; k < start->setting_count; k++)
      fprintf(out, "%s %s", k ? "," : " with", start->settings[k]);
    fprintf(out, " (line %d)\n    %s: %s\n", start->line,
            nb_start_path(path, sizeof path, stage_scene, options, &error) ? error.text : path,
            words[nb_start_presence(stage_scene, options)]);
  }
}

/* Prints how many particles of each size of a grading were placed. */
static void explain_fill(FILE *out, const struct nb_scene *scene, const struct nb_fill *fill) {
  const struct nb_grading *grading = &scene->gradings[fill->grading];
  fprintf(out, "  %s %s, seed %lu: %zu of %zu particles placed in %llu attempts, particles %zu to %zu (line %d)\n",
          fill->circle      ? "circle with"
          : fill->width > 0 ? "cell with"
                            : "box with",
          grading->name, fill->seed, fill->count, grading->count, fill->attempts_made, fill->first + 1,
          fill->first + fill->count, fill->line);
  for (size_t s = 0; s < grading->size_count; s++) {
    const struct nb_size *size = &grading->sizes[s];
    size_t placed = 0;
    for (size_t k = fill->first; k < fill->first + fill->count; k++)
      placed += scene->particles[k].radius == size->radius;
    fprintf(out, "    radius %g%s: %zu", size->radius, nb_unit(scene, " m"), placed);
    if (placed < size->count)
      fprintf(out, ", %zu not placed, no space", size->count - placed);
    fputc('\n', out);
  }
}

/* Prints the number of particles, the random fillings and the packings. */
static void explain_particles(FILE *out, const struct nb_scene *scene) {
  fprintf(out, "particles\n  %zu particles, %zu walls\n", scene->particle_count, scene->wall_count);
  if (scene->fill_count > 0)
    fprintf(out, "random fillings\n");
  for (size_t f = 0; f < scene->fill_count; f++)
    explain_fill(out, scene, &scene->fills[f]);
  for (size_t p = 0; p < scene->packing_count; p++) {
    const struct nb_packing *packing = &scene->packings[p];
    fprintf(out, "%s  %s: %zu particles, numbers %zu to %zu (line %d)\n", p ? "" : "packings\n", packing->path,
            packing->count, packing->first + 1, packing->first + packing->count, packing->line);
  }
}

/* ---- the plan ---- */

/* True if a contact of the material pair can form. A material of only one particle has no contact with itself. */
static bool can_touch(const struct nb_scene *scene, const struct nb_material_pair *material_pair) {
  size_t particles = 0;
  for (size_t k = 0; k < scene->particle_count; k++)
    particles += scene->particles[k].material == material_pair->a;
  return material_pair->wall || material_pair->a != material_pair->b || particles > 1;
}

/* Prints the values that a change of a stage sets for the pair, if it sets any. */
static void explain_change(FILE *out, const struct nb_stage *stage, const struct nb_change *change,
                           struct nb_pair before, struct nb_pair after) {
  const char *between = "";
#define ROW(name, ...) between = before.name != after.name ? ":" : between;
  NB_PAIR_ROWS(ROW)
#undef ROW
  if (!between[0])
    return;
  fprintf(out, "    %s stage `%s`%s (line %d)", change->ramp ? "in" : "from", stage->name,
          change->ramp ? " linearly until its end" : " on", change->line);
#define ROW(name, ...)                                                                                                 \
  if (before.name != after.name)                                                                                       \
    fprintf(out, "%s " #name " %g", between, after.name), between = ",";
  NB_PAIR_ROWS(ROW)
#undef ROW
  fputs(nb_has_friction(before) && !nb_has_friction(after) ? "; no shear force without friction and cohesion\n" : "\n",
        out);
}

/* Prints the values of the pair that stages change, in the order of the run. False: out of memory. */
static bool explain_changes(FILE *out, const struct nb_scene *scene, const struct nb_material_pair *material_pair) {
  struct nb_properties now = {0};
  if (!nb_properties_create(&now, scene))
    return false;
  for (size_t s = 0; s < scene->stage_count; s++)
    for (size_t k = 0; k < scene->stages[s].change_count; k++) {
      const struct nb_change *change = &scene->stages[s].changes[k];
      const struct nb_pair before = nb_properties_pair(&now, material_pair->a, material_pair->b);
      nb_properties_change(&now, change, nb_properties_before(&now, change), 1);
      if (s >= scene->start.stages)
        explain_change(out, &scene->stages[s], change, before,
                       nb_properties_pair(&now, material_pair->a, material_pair->b));
    }
  nb_properties_free(&now);
  return true;
}

static bool explain_material_pair(FILE *out, const struct nb_model *model,
                                  const struct nb_material_pair *material_pair) {
  size_t contacts = 0;
  if (!can_touch(model->scene, material_pair))
    return true;
  for (size_t c = 0; c < model->contacts.count; c++)
    contacts += &model->material_pairs[model->contacts.material_pair[c]] == material_pair;
  const struct nb_material *const materials = model->scene->materials;
  const struct nb_pair *const values = &material_pair->values;
  fprintf(out, "  %s with %s%s: %zu %s in the neighbour list; ", materials[material_pair->a].name,
          material_pair->wall ? "wall of " : "", materials[material_pair->b].name, contacts,
          contacts == 1 ? "pair" : "pairs");
  if (model->laws.normal->elastic || (values->kn == 0 && values->young > 0)) /* a later stage may have an elastic law */
    fprintf(out, "E* %g, G* %g, ", values->young, values->shear);
  else
    fprintf(out, "k_n %g, k_s %g, ", values->kn, values->ks);
  fprintf(out, "tan(phi) %g, c %g\n", values->friction, values->cohesion);
  if (!explain_changes(out, model->scene, material_pair))
    return false;
  for (int p = 0; p < material_pair->pass_count; p++) {
    const struct nb_planned *planned = &material_pair->passes[p];
    fprintf(out, "    %-40s", planned->name);
    if (planned->line)
      fprintf(out, " line %d", planned->line);
    fputc('\n', out);
  }
  if (!material_pair->shear && strcmp(model->laws.shear->name, "none") != 0)
    fprintf(out, "    (no shear %s: the pair has neither friction nor cohesion)\n", model->laws.shear->name);
  return true;
}

/* Number of bytes of a particle that a cycle reads and writes, without the measures of regions and the workspace of the
 * stability check. */
static size_t bytes_per_particle(const struct nb_model *model) {
  const struct nb_particles *particles = &model->particles;
  return sizeof(double) * (particles->spin ? 14 : 12) + 5 * sizeof(int) +
         (particles->ahead ? sizeof *particles->ahead : 0) +
         (model->affine ? sizeof *particles->imposed + sizeof *model->affine->source : 0) +
         (model->boundary ? 2 * sizeof(int) : 0) +
         (model->boundary && model->boundary->boundary_force ? sizeof(struct nb_vec) : 0) +
         (particles->removed ? sizeof(bool) : 0) + (model->balance ? sizeof *model->balance->particles : 0) +
         (model->fracc ? sizeof(double) : 0) +
         nb_configuration_count(model->configuration) * (sizeof(struct nb_vec) + sizeof(double));
}

static size_t bytes_per_contact(const struct nb_model *model, size_t history) {
  const struct nb_contacts *contacts = &model->contacts;
  return sizeof *contacts->force +
         sizeof(double) * (nb_bit_count(model->plan.kept) + history + (size_t)contacts->slip_sum.doubles) +
         (contacts->image ? sizeof *contacts->image : 0) + (contacts->suppressed ? sizeof(int) : 0) + 5 * sizeof(int);
}

static void explain_memory(FILE *out, const struct nb_model *model) {
  static const char *const isa_names[] = {"plain", "avx2", "avx512"};
  const size_t history = (size_t)(model->contacts.normal_history.doubles + model->contacts.shear_history.doubles);
  fprintf(out, "memory\n  %zu bytes a particle%s, %zu a contact (%zu kept fields, %zu history variable%s of laws)\n",
          bytes_per_particle(model), model->particles.spin ? "" : " (without rotation)",
          bytes_per_contact(model, history), nb_bit_count(model->plan.kept) + 2, history, history == 1 ? "" : "s");
  fprintf(out, "  %zu block%s of up to %d contacts, loops for %s, %d thread%s\n", model->blocks.count,
          model->blocks.count == 1 ? "" : "s", NB_BLOCK_SIZE, isa_names[model->machine.isa],
          model->machine.threads_used, model->machine.threads_used == 1 ? "" : "s");
}

/* Prints the hooks of the cycle at the start of the run. */
static void explain_hooks(FILE *out, const struct nb_model *model) {
  static const char *const when[NB_WHENS] = {[NB_BEFORE_MOTION] = "before the motion",
                                             [NB_AFTER_MOTION] = "after the motion",
                                             [NB_BEFORE_SEARCH] = "before the search",
                                             [NB_BEFORE_FORCES] = "before the forces",
                                             [NB_AFTER_FORCES] = "after the forces"};
  fputs("hooks of the cycle, at the start of the run\n", out);
  for (int w = 0; w < NB_WHENS; w++)
    for (size_t h = 0; h < model->hooks[w].count; h++)
      fprintf(out, "  %-18s %s\n", when[w], model->hooks[w].list[h].name);
}

/* Prints the features that the scene does not use, and the memory that this saves. */
static void explain_absent(FILE *out, const struct nb_model *model) {
  const struct nb_scene *scene = model->scene;
  bool changes = false, servo = false, damped = false, slowed = false;
  for (size_t s = scene->start.stages; s < scene->stage_count; s++) {
    changes = changes || scene->stages[s].change_count > 0 || scene->stages[s].laws.shear[0];
    servo = servo || scene->stages[s].servo.line;
    damped = damped || nb_damping_contact_line(&scene->stages[s].damping);
    slowed = slowed || scene->stages[s].damping.global_kind;
  }
  const struct nb_pair none = {.pieces = model->laws.pieces};
  const size_t shear = (size_t)nb_law_history(model->laws.shear, none);
  const struct {
    bool present;
    const char *name, *of;
    size_t bytes; /* 0: the feature needs no memory, or the number is not known without the feature */
  } parts[] = {{model->particles.spin, "rotation", "particle", 2 * sizeof(double)},
               {model->plan.has_friction || changes, "shear forces", "contact", sizeof(double) * shear},
               {damped, "dashpots", "", 0},
               {slowed, "mass-proportional damping", "", 0},
               {model->balance, "balances of work and energy", "particle", sizeof *model->balance->particles},
               {model->search.skin < INFINITY, "search", "", 0},
               {model->cell, "periodic cell", "", 0},
               {model->boundary, "boundary", "", 0},
               {servo, "servo", "", 0},
               {scene->region_count, "regions", "", 0}};
  const char *between = "not used\n  ";
  for (size_t k = 0; k < sizeof parts / sizeof *parts; k++) {
    if (parts[k].present)
      continue;
    fprintf(out, "%s%s", between, parts[k].name), between = ", ";
    if (parts[k].bytes)
      fprintf(out, " (%zu bytes a %s)", parts[k].bytes, parts[k].of);
  }
  if (between[0] == ',')
    fputc('\n', out);
}

/* Prints the damping of contacts with the value of its coefficient, which the page may give as an expression. */
static void explain_dashpots(FILE *out, const struct nb_scene *scene, const struct nb_damping *damping) {
  static const char *const words[] = {
      [NB_CONTACT_STIFFNESS] = "stiffness", [NB_CONTACT_R89_FRACTION] = "r89-fraction", [NB_CONTACT_RATIO] = "ratio"};
  const int kinds = damping->walls_separate ? 2 : 1; /* 0: between particles; 1: with walls */
  for (int wall = 0; wall < kinds; wall++) {
    double value;
    const enum nb_contact_damping kind = nb_damping_at(damping, wall, &value);
    if (kind != NB_CONTACT_UNDAMPED)
      fprintf(out, "  damping %s%s %g%s, line %d\n", wall ? "walls " : "", words[kind], value,
              kind == NB_CONTACT_STIFFNESS ? nb_unit(scene, " s") : "",
              wall ? damping->walls_line : damping->contact_line);
  }
  if (damping->deep > 0)
    fprintf(out, "  damping critical beyond overlap %g %%, line %d\n", 100 * damping->deep, damping->deep_line);
}

/* Prints the loading and the damping that act at the start of the run and are not hooks. */
static void explain_loading(FILE *out, const struct nb_scene *scene) {
  const struct nb_damping *damping = &scene->stages[scene->start.stages].damping;
  if (scene->circle.line || scene->gravity.line || damping->global_kind || nb_damping_contact_line(damping))
    fputs("loading and damping, at the start of the run\n", out);
  explain_statement(out, scene, scene->circle.line, "\n");
  explain_statement(out, scene, scene->gravity.line, "\n");
  explain_dashpots(out, scene, damping);
  if (damping->global_kind)
    fprintf(out, "  %s %g%s, line %d\n",
            damping->global_kind == NB_GLOBAL_MASS ? "mass-proportional damping" : "damping con1", damping->global,
            damping->global_kind == NB_GLOBAL_MASS ? nb_unit(scene, " 1/s") : "", damping->global_line);
}

static bool explain_plan(FILE *out, const struct nb_model *model) {
  const char *m = nb_unit(model->scene, " m");
  if (model->search.skin < INFINITY)
    fprintf(out, "neighbour list\n  %zu pairs closer than %g%s; rebuilt when a particle or wall has moved %g%s\n",
            model->contacts.count, model->search.skin, m, model->search.skin / 2, m);
  else
    fprintf(out, "neighbour list\n  none: no particle can touch another one or a wall\n");
  explain_loading(out, model->scene);
  fprintf(out, "force passes at the start of the run, for each pair of materials\n");
  for (size_t p = 0; p < model->material_pair_count; p++)
    if (!explain_material_pair(out, model, &model->material_pairs[p]))
      return false;
  explain_hooks(out, model);
  explain_memory(out, model);
  if (model->balance)
    fprintf(out, "balances\n  %s%s%s, updated every cycle by one thread\n",
            (model->plan.requested & NB_REQUEST_WORK) ? "work" : "",
            (model->plan.requested & NB_REQUEST_WORK) && model->terms ? " and " : "", model->terms ? "energy" : "");
  explain_absent(out, model);
  return true;
}

/* ---- regions ---- */

static size_t count_inside(const struct nb_model *model, int region) {
  const struct nb_region_state *now = nb_region_state(model, region);
  size_t count = 0;
  for (size_t i = 0; i < model->particles.count; i++)
    count += nb_region_contains(model, now, i);
  return count;
}

static void explain_regions(FILE *out, const struct nb_model *model) {
  const struct nb_scene *scene = model->scene;
  if (scene->region_count > 0)
    fputs("regions\n", out);
  for (size_t w = 0; w < scene->monitor_count; w++) {
    const struct nb_monitor *monitor = &scene->monitors[w];
    if (monitor->kind != NB_MONITOR_REGION)
      continue;
    explain_statement(out, scene, scene->regions[monitor->a].line, "");
    const bool all = scene->regions[monitor->a].kind == NB_REGION_ALL;
    const double area = nb_region_state(model, monitor->a)->area;
    fprintf(out, ": %zu particles now; area %g%s%s\n", count_inside(model, monitor->a), area, nb_unit(scene, " m2"),
            !all          ? ""
            : model->cell ? ", that of the cell"
                          : ", that of the smallest rectangle around all particles, without the gaps at walls");
  }
}

/* ---- the step ---- */

static void explain_stable_step(FILE *out, const struct nb_model *model, const char *s) {
  const struct nb_stable stable = nb_stable_step_stage(model);
  char what[3 * NB_NAME_SIZE];
  if (isinf(stable.step)) {
    fputs("  stable: no limit, because no contact with a stiffness can form\n", out);
    return;
  }
  nb_stable_text(what, sizeof what, model, &stable);
  fprintf(out, "  stable: %g%s; the step is %g of it; limited by %s%s\n", stable.step, s, model->step / stable.step,
          what,
          model->step <= stable.step         ? ""
          : model->stability->allow_unstable ? "; allowed to be unstable"
                                             : "; ABOVE it: the run will be aborted");
}

static void explain_single_contact(FILE *out, const struct nb_model *model, const char *s) {
  const double stable = nb_stable_step_stage(model).step / model->critical;
  fprintf(out, "  single contact, 2 sqrt(m/k): %g%s; the step is %g of it", model->critical, s,
          model->step / model->critical);
  if (isfinite(stable))
    fprintf(out, ", the stable step %g of it", stable);
  fputc('\n', out);
}

static void explain_collision(FILE *out, const struct nb_model *model, const struct nb_collision *collision,
                              const char *s) {
  if (collision->a < 0) {
    fprintf(out, "  collision: no pair approaches\n");
    return;
  }
  fprintf(out, "  collision, Hertz: %g%s, %.3g steps; particle %d and ", collision->duration, s,
          collision->duration / model->step, model->particles.number[collision->a]);
  if (collision->wall)
    fprintf(out, "wall %s", model->scene->walls[collision->b].name);
  else
    fprintf(out, "particle %d", model->particles.number[collision->b]);
  fprintf(out, " at %g%s\n", collision->speed, nb_unit(model->scene, " m/s"));
}

/* Prints how large the errors in the cases were with about this number of steps per collision (docs/ACCURACY.md). */
static void explain_accuracy(FILE *out, double steps) {
  static const struct {
    double steps; /* steps per collision: this number or more, up to twice as many */
    unsigned count;
    double half, most; /* half of the relative errors are below `half`, 90 % of them below `most` */
  } rows[] = {
#include "accuracy_rows.h"
  };
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    if (steps >= rows[k].steps && steps < 2 * rows[k].steps)
      fprintf(
          out,
          "  accuracy: with %g to %g steps per collision, half of the %u errors in the cases were below %.3g %%, and "
          "90 %% of them below %.3g %% (docs/ACCURACY.md); for this page, use `nineball advise`\n",
          rows[k].steps, 2 * rows[k].steps, rows[k].count, 100 * rows[k].half, 100 * rows[k].most);
}

/* Prints the duration of a collision and the other times with which a step is compared. */
static enum nb_status explain_times(FILE *out, const struct nb_model *model, const char *s, struct nb_error *error) {
  struct nb_collision shortest;
  if (nb_step_collision(&shortest, model, error))
    return error->status;
  if (nb_step_elastic(model))
    explain_collision(out, model, &shortest, s);
  else if (isinf(shortest.duration))
    fputs("  collision: none is possible\n", out);
  else
    fprintf(out, "  collision, the shortest possible: %g%s; the step is %g of it\n", shortest.duration, s,
            model->step / shortest.duration);
  const double smallest = nb_step_rayleigh(model, false, false), mean = nb_step_rayleigh(model, false, true);
  if (smallest < INFINITY)
    fprintf(out,
            "  rayleigh, the travel time of a surface wave round half a sphere: smallest %g%s, mean %g%s; the step is "
            "%g and %g of it\n",
            smallest, s, mean, s, model->step / smallest, model->step / mean);
  explain_accuracy(out, shortest.duration / model->step);
  return NB_OK;
}

static enum nb_status explain_step(FILE *out, const struct nb_model *model, struct nb_error *error) {
  const struct nb_step *step = &model->scene->stages[model->scene->start.stages].step;
  const char *s = nb_unit(model->scene, " s");
  const bool elastic = nb_step_elastic(model);
  fprintf(out, "step\n  %g%s", model->step, s);
  if (step->set)
    fputs(", --set", out);
  else if (step->line)
    fprintf(out, ", line %d", step->line);
  fputc('\n', out);
  if (!elastic && isinf(model->critical)) {
    fprintf(out, "  single contact: none, no contact has a stiffness\n");
    return NB_OK;
  }
  if (!elastic)
    explain_single_contact(out, model, s);
  if (elastic && !nb_step_loaded(model))
    fprintf(out, "  stable: unknown, elastic spheres without overlap have no stiffness\n");
  else
    explain_stable_step(out, model, s);
  return explain_times(out, model, s, error);
}

/* ---- stages ---- */

/* Prints the gain of a servo, with B and T of servo.c at the start of the run if there are contacts. */
static void explain_gain(FILE *out, const struct nb_model *model, const struct nb_servo *servo) {
  const struct nb_scene *scene = model->scene;
  double b, t;
  fputs("    gain of the servo: strain rate P = error/(2 B T), plus the time integral of P/(16 T); ", out);
  if (nb_servo_scales(model, servo, &b, &t))
    fprintf(out, "now the bulk stiffness B is %g%s, the travel time T of a wave across the assembly %g%s\n", b,
            nb_unit(scene, " Pa"), t, nb_unit(scene, " s"));
  else
    fputs("B is the bulk stiffness, T the travel time of a wave across the assembly; there are no contacts yet\n", out);
}

/* Prints the normal components of a strain rate with the words extension and compression, because a strain is positive
 * in extension, and a stress in compression. */
static void explain_growth(FILE *out, int line, const struct nb_strain_rate *rate, const char *unit) {
  const double rates[] = {rate->xx, rate->yy};
  const char *between = "";
  for (int k = 0; k < 2 && line; k++) {
    if (rates[k] == 0)
      continue;
    fprintf(out, *between ? "%s" : "%s    line %d: ", between, line);
    fprintf(out, "%s %+g%s: %s in %c", k ? "yy" : "xx", rates[k], unit, rates[k] > 0 ? "extension" : "compression",
            k ? 'y' : 'x');
    between = "; ";
  }
  fputs(*between ? "\n" : "", out);
}

/* Prints the normal components of the strain rate of a line and, if it has a shear, the whole tensor: c12 and c21 are
 * easily mistaken for one another. */
static void explain_strain_rate(FILE *out, const struct nb_scene *scene, int line, const struct nb_strain_rate *rate) {
  const char *const unit = rate->per_cycle ? " per cycle" : nb_unit(scene, " 1/s");
  const double sum = rate->xy + rate->yx;
  explain_growth(out, line, rate, unit);
  if (!line || (rate->xy == 0 && rate->yx == 0))
    return;
  fprintf(out, "    line %d: strain rate xx %g, c12 %g, c21 %g, yy %g%s: ", line, rate->xx, rate->xy, rate->yx,
          rate->yy, unit);
  if (rate->xy == rate->yx)
    fprintf(out, "pure shear, the engineering shear rate is twice c12, %g%s; simple shear at this rate is `c12 %g%s`\n",
            sum, unit, sum, unit);
  else
    fprintf(out, "%s, the engineering shear rate is %g%s%s\n",
            rate->xy == 0 || rate->yx == 0 ? "simple shear" : "shear with rotation", sum, unit,
            sum > 0   ? "; xy of a stress becomes negative"
            : sum < 0 ? "; xy of a stress becomes positive"
                      : "");
}

/* A stage with shear may end when the component xy of a strain, half the engineering shear strain, passes a value. If the
 * shear has the sign of this value, this function prints the statement that ends the stage when the engineering shear
 * strain has this value. */
static void explain_shear_end(FILE *out, const struct nb_scene *scene, const struct nb_stage *stage) {
  static const char xy[] = ".strain.xy";
  const struct nb_strain_rate *const rate = stage->cell_line       ? &stage->cell
                                            : stage->boundary.line ? &stage->boundary.strain
                                                                   : &stage->affine.strain;
  const double sum = rate->xy + rate->yx;
  for (size_t k = 0; k < stage->condition_count; k++) {
    const struct nb_condition *const condition = &stage->conditions[k];
    const size_t length = strlen(condition->name), tail = strlen(xy);
    if (length < tail || strcmp(condition->name + length - tail, xy) != 0 || !(condition->value * sum > 0))
      continue;
    fprintf(
        out,
        "    line %d: `%s` is the component of the tensor, half the engineering shear strain; for an engineering shear "
        "strain of %g %% within this stage write ",
        condition->line, condition->name, 100 * condition->value);
    if (rate->per_cycle)
      fprintf(out, "`cycles %.0f`\n", ceil(condition->value / sum));
    else
      fprintf(out, "`stage.time above %g%s`\n", condition->value / sum, nb_unit(scene, " s"));
  }
}

/* The scene of the page that has the stage: `scene`, or one from which `scene` starts. */
static const struct nb_scene *scene_of(const struct nb_scene *scene, size_t stage) {
  while (stage < scene->start.stages)
    scene = scene->start.scene;
  return scene;
}

/* Prints the statement of an earlier stage that still moves something. `scene` is the scene of the page that has the
 * statement; `here` is true if this is the page that is explained. */
static void print_inherited(FILE *out, const struct nb_scene *scene, size_t from, int line, bool here) {
  struct nb_reader reader;
  if (!read_statement(&reader, scene, (size_t)line))
    return;
  fprintf(out, "    goes on from stage `%s`%s%s, ", scene->stages[from].name, here ? "" : " of ",
          here ? "" : scene->page->name);
  print_statement(out, &reader);
  fputc('\n', out);
}

/* True if motion `m` of stage `from` does not act in stage `s`, because a later motion of the wall, or the strain of
 * its box, replaces it. */
static bool is_replaced(const struct nb_scene *scene, size_t from, const struct nb_wall_motion *m, size_t s) {
  const int first = nb_box_first_wall(scene);
  bool replaced = first >= 0 && m->wall >= first && m->wall < first + 4 && nb_box_strained_in(scene, s);
  for (size_t k = from + 1; k <= s; k++)
    for (size_t n = 0; n < scene->stages[k].motion_count; n++)
      replaced = replaced || scene->stages[k].motions[n].wall == m->wall;
  return replaced;
}

/* Prints the strain rates and the motions of walls that go on from earlier stages. */
static void explain_inherited(FILE *out, const struct nb_scene *scene, size_t s) {
  for (int line, source = NB_AFFINE_FREE; source < NB_AFFINE_SOURCES; source++) {
    const int from = nb_affine_inherited(scene, s, source, &line);
    if (from < 0)
      continue;
    const struct nb_scene *of = scene_of(scene, (size_t)from);
    nb_affine_given(&of->stages[from], source, &line); /* for a stage of another page, `line` was the line of `start` */
    print_inherited(out, of, (size_t)from, line, of == scene);
  }
  for (size_t from = 0; from < s; from++) {
    const struct nb_scene *of = scene_of(scene, from);
    int printed = 0; /* the line printed last: `walls` sets the motion of several walls */
    for (size_t n = 0; n < scene->stages[from].motion_count; n++) {
      const struct nb_wall_motion *m = &scene->stages[from].motions[n];
      const int line = of->stages[from].motions[n].line;
      if (line == printed || (m->vx == 0 && m->vy == 0 && m->spin == 0) || is_replaced(scene, from, m, s))
        continue;
      print_inherited(out, of, from, line, of == scene);
      printed = line;
    }
  }
}

static void explain_strain_rates(FILE *out, const struct nb_scene *scene, const struct nb_stage *stage) {
  explain_strain_rate(out, scene, stage->box_line, &stage->box);
  explain_strain_rate(out, scene, stage->cell_line, &stage->cell);
  explain_strain_rate(out, scene, stage->boundary.line, &stage->boundary.strain);
  explain_strain_rate(out, scene, stage->affine.line, &stage->affine.strain);
  explain_shear_end(out, scene, stage);
}

/* Says that the `record` of the stage before does not last, if stage `s` has none. */
static void explain_record(FILE *out, const struct nb_scene *scene, size_t s) {
  const struct nb_stage *const before = s > scene->start.stages ? &scene->stages[s - 1] : NULL;
  if (before && before->record_line && before->record_interval != 1 && !scene->stages[s].record_line)
    fprintf(out, "    a row every cycle: the `record` of stage `%s` (line %d) holds only there\n", before->name,
            before->record_line);
}

static void explain_stages(FILE *out, const struct nb_model *model, const struct nb_cost *cost) {
  const struct nb_scene *scene = model->scene;
  fputs("stages\n", out);
  for (size_t s = scene->start.stages; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    fprintf(out, "  %s, ", stage->name);
    nb_cost_print_length(out, &cost->lengths[s], stage);
    fputc('\n', out);
    explain_statements(out, scene, s);
    explain_record(out, scene, s);
    explain_inherited(out, scene, s);
    explain_strain_rates(out, scene, stage);
    if (stage->servo.line && cost->seconds.to > 0)
      explain_gain(out, model, &stage->servo);
  }
}

static void explain_cost(FILE *out, const struct nb_cost *cost, const struct nb_error *error, bool contact_test) {
  const char *cycle = contact_test ? "step" : "cycle";
  fputs("cost\n  ", out);
  nb_cost_print(out, cost, contact_test ? " steps" : " cycles");
  if (cost->measured.to > 0)
    fprintf(out,
            "\n  a %s with recording takes %.3g us, measured just now; reading, start, reference, tables and verdict "
            "%.3g s\n",
            cycle, 1e6 * cost->measured.to / cost->cycles.to, cost->seconds.to - cost->measured.to);
  else
    fprintf(out, "\n  the time of a %s cannot be measured: %s\n", cycle, error->text);
  if (cost->measured.to > 0 && cost->aborts)
    fprintf(out, "  the run will be aborted: %s\n", error->text);
  if (cost->reference.status)
    fprintf(out, "  the run will be aborted, because its reference fails: %s\n", cost->reference.text);
}

/* ---- contact test ---- */

static void explain_contact_test_law(FILE *out, const struct nb_law *law, int doubles, int line) {
  fprintf(out, "  %s %s: %s %s", law->kind, law->name, law->title, law->source);
  if (line)
    fprintf(out, ", line %d", line);
  fprintf(out, "\n    %d history variable%s%s%s%s\n", doubles, doubles == 1 ? "" : "s",
          law->stored ? "; reports its stored energy" : "; does not report stored energy",
          law->dissipative ? "; reports its dissipation" : "", law->non_conservative ? "; may create energy" : "");
}

static void explain_contact(FILE *out, const struct nb_scene *scene, const struct nb_contact_test *contact_test) {
  static const char *const shapes[] = {[NB_DISC] = "disc", [NB_SPHERE] = "sphere"};
  const char *m = nb_unit(scene, " m"), *pa = nb_unit(scene, " Pa");
  fputs("contact test\n  ", out);
  for (size_t k = 0; k < scene->particle_count; k++) {
    const struct nb_particle *particle = &scene->particles[k];
    fprintf(out, "%s%s of %s, radius %g%s", k ? ", with " : "", shapes[particle->shape],
            scene->materials[particle->material].name, particle->radius, m);
  }
  if (scene->particle_count == 1)
    fprintf(out, ", with a wall of %s", scene->materials[scene->walls[0].material].name);
  fputc('\n', out);
  if (contact_test->normal->elastic)
    fprintf(out, "  R* %g%s, E* %g%s, G* %g%s, friction %g\n", contact_test->pair.radius, m, contact_test->pair.young,
            pa, contact_test->pair.shear, pa, contact_test->pair.friction);
  else
    fprintf(out, "  k_n %g, k_s %g, friction %g, cohesion %g\n", contact_test->pair.kn, contact_test->pair.ks,
            contact_test->pair.friction, contact_test->pair.cohesion);
}

static enum nb_status explain_contact_test(FILE *out, const struct nb_scene *scene, const struct nb_cost *cost,
                                           struct nb_error *error) {
  struct nb_contact_test contact_test;
  const struct nb_error unmeasured = *error;
  if (nb_contact_test_create(&contact_test, scene, error))
    return error->status;
  explain_contact(out, scene, &contact_test);
  fprintf(out, "laws\n");
  explain_contact_test_law(out, contact_test.normal, contact_test.normal_doubles, scene->normal_line);
  explain_contact_test_law(out, contact_test.shear, contact_test.shear_doubles, scene->shear_line);
  fprintf(out, "segments\n");
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    fprintf(out, "  %s, %lu steps%s\n", stage->name, stage->cycles, stage->segment.points ? ", read from a file" : "");
    explain_statements(out, scene, s);
  }
  explain_cost(out, cost, &unmeasured, true);
  nb_contact_test_free(&contact_test);
  return NB_OK;
}

/* ---- nb_explain ---- */

/* A model of a page that starts from a state which does not exist yet. The model has the particles of that state's page
 * at time 0, and the laws and the properties at the end of the stages before the state. */
static struct nb_model *model_before_start(const struct nb_scene *scene, const struct nb_options *options,
                                           struct nb_error *error) {
  struct nb_model *model = nb_model_resume(scene, options, NULL, error);
  for (size_t s = 0; s < scene->start.stages && model; s++) {
    model->next_laws = nb_laws_of(&scene->stages[s], model->next_laws);
    nb_properties_end_stage(&model->properties, &scene->stages[s]);
  }
  if (!model)
    return NULL;
  nb_properties_apply(model);
  nb_laws_change(model);
  model->critical = nb_step_single_contact(model);
  if (!nb_plan(model, error) && !nb_neighbours_search(model, error))
    return model;
  nb_model_free(model);
  return NULL;
}

/* Prints the plan of a page that starts from a state which does not exist yet, as far as the plan follows from the
 * scene. If no model can be made, prints only the state; then only NB_NO_MEMORY is reported. */
static enum nb_status explain_before_start(FILE *out, const struct nb_scene *scene, const struct nb_options *options,
                                           struct nb_cost *cost, struct nb_error *error) {
  const struct nb_start *start = &scene->start;
  struct nb_model *model = model_before_start(scene, options, error);
  char path[4096] = "";
  nb_append_word(path, sizeof path, scene->page->path);
  explain_start(out, scene, options);
  fprintf(out, "  `nineball check %s` computes that state; then `explain` shows contacts, step and seconds, too\n",
          path);
  if (!model)
    return error->status == NB_NO_MEMORY ? error->status : NB_OK;
  fprintf(out, "before stage `%s` of `%s` is run: laws and materials of its end, positions at time 0\n",
          start->scene->stages[start->scene->stage_count - 1].name, start->page->name);
  explain_particles(out, scene);
  enum nb_status status = explain_plan(out, model) ? nb_cost_bounds(cost, scene, error) : nb_error_memory(error);
  if (!status) {
    const struct nb_step *step = &scene->stages[start->stages].step;
    struct nb_error unknown;
    if (step->kind != NB_STEP_STABLE && !(step->kind == NB_STEP_COLLISION && nb_step_elastic(model)) &&
        !nb_step_set(model, step, &unknown))
      fprintf(out, "step\n  %g%s\n", model->step, nb_unit(scene, " s"));
    else
      fputs("step\n  follows from that state\n", out);
    explain_stages(out, model, cost);
    explain_cost(out, cost, &(struct nb_error){NB_OK, "the run begins with a state that does not exist yet"}, false);
  }
  nb_model_free(model);
  return status;
}

static enum nb_status explain_scene(FILE *out, const struct nb_scene *scene, const struct nb_page_run *run,
                                    const struct nb_options *options, struct nb_warnings *warnings,
                                    struct nb_cost *cost, struct nb_error *error) {
  struct nb_model *model = nb_model_create(scene, options, error);
  if (!model)
    return error->status;
  struct nb_error unknown;
  /* A model that continues from a state has the step of the previous stage, not that of the first stage here. */
  if (nb_step_set(model, &scene->stages[scene->start.stages].step, &unknown) == NB_NO_MEMORY) {
    nb_model_free(model);
    return nb_error_memory(error);
  }
  explain_start(out, scene, options);
  explain_particles(out, scene);
  enum nb_status status = explain_plan(out, model) ? NB_OK : nb_error_memory(error);
  if (!status) {
    explain_regions(out, model);
    status = explain_step(out, model, error);
  }
  if (!status)
    status = nb_cost_expect(cost, run, model, options, error);
  if (!status) {
    explain_stages(out, model, cost);
    explain_cost(out, cost, error, false);
  }
  for (size_t k = 0; k < model->warnings.count; k++)
    nb_warnings_add(warnings, &model->warnings.list[k]);
  nb_model_free(model);
  return status;
}

enum nb_status nb_explain(FILE *out, const struct nb_scene *scene, const struct nb_page_run *run,
                          const struct nb_options *options, struct nb_warnings *warnings, struct nb_cost *sum,
                          struct nb_error *error) {
  struct nb_cost cost = {.reading = sum->reading};
  enum nb_status status = NB_OK;
  if (scene->contact_test) {
    status = nb_cost_expect(&cost, run, NULL, options, error);
    status = status ? status : explain_contact_test(out, scene, &cost, error);
  } else if (nb_start_is_ready(scene, options)) {
    status = explain_scene(out, scene, run, options, warnings, &cost, error);
  } else {
    status = explain_before_start(out, scene, options, &cost, error);
  }
  nb_cost_add(sum, &cost);
  free(cost.lengths);
  return status;
}
