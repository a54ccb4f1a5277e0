/* What a page would do, in words: what is switched on and which line of the page asked for it, what it weighs, what sets the step,
 * what every stage changes. Of a path: the contact on the bench, its laws, its legs.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "core/clock.h"
#include "core/model.h"
#include "core/names.h"
#include "laws/laws_now.h"
#include "loading/servo.h"
#include "measure/balance.h"
#include "measure/region.h"
#include "measure/step.h"
#include "run/bench.h"
#include "run/restart.h"

static const char *unit(const struct nb_scene *scene, const char *name) { return scene->unitless ? "" : name; }

/* ---- as the scene begins ---- */

/* What the page starts from, and what that starts from. */
static void explain_start(FILE *out, const struct nb_scene *scene, const struct nb_options *options) {
  static const char *const words[] = {
      [NB_THERE] = "there", [NB_STALE] = "stale, will be made anew", [NB_ABSENT] = "not there, will be made"};
  char path[4096];
  struct nb_error error;
  if (scene->start.stages > 0)
    fprintf(out, "start\n");
  for (const struct nb_scene *here = scene; here->start.stages > 0; here = here->start.scene) {
    const struct nb_start *start = &here->start;
    fprintf(out, "  at the end of stage `%s` of `%s`", start->scene->stages[start->scene->stage_count - 1].name,
            start->page->name);
    for (size_t k = 0; k < start->setting_count; k++)
      fprintf(out, "%s %s", k ? "," : " with", start->settings[k]);
    fprintf(out, " (line %d)\n    %s: %s\n", start->line,
            nb_start_path(path, sizeof path, here, options, &error) ? error.text : path,
            words[nb_start_look(here, options)]);
  }
}

/* Of a grading what was wanted, and what became of it. */
static void explain_fill(FILE *out, const struct nb_scene *scene, const struct nb_fill *fill) {
  const struct nb_grading *grading = &scene->gradings[fill->grading];
  fprintf(out, "  %s %s, seed %lu: %zu of %zu bodies in %llu tries, bodies %zu to %zu (line %d)\n",
          fill->circle ? "circle with" : "box with", grading->name, fill->seed, fill->count, grading->count, fill->made,
          fill->first + 1, fill->first + fill->count, fill->line);
  for (size_t s = 0; s < grading->size_count; s++) {
    const struct nb_size *size = &grading->sizes[s];
    size_t placed = 0;
    for (size_t k = fill->first; k < fill->first + fill->count; k++)
      placed += scene->bodies[k].radius == size->radius;
    fprintf(out, "    radius %g%s: %zu", size->radius, unit(scene, " m"), placed);
    if (placed < size->count)
      fprintf(out, ", %zu dropped: no place found", size->count - placed);
    fputc('\n', out);
  }
}

/* Bodies: how many, and those that the page has not said one by one. */
static void explain_bodies(FILE *out, const struct nb_scene *scene) {
  fprintf(out, "bodies\n  %zu free or fixed, %zu walls\n", scene->body_count, scene->wall_count);
  if (scene->fill_count > 0)
    fprintf(out, "filled\n");
  for (size_t f = 0; f < scene->fill_count; f++)
    explain_fill(out, scene, &scene->fills[f]);
  for (size_t p = 0; p < scene->packing_count; p++) {
    const struct nb_packing *packing = &scene->packings[p];
    fprintf(out, "%s  %s: %zu bodies, bodies %zu to %zu (line %d)\n", p ? "" : "packings\n", packing->path,
            packing->count, packing->first + 1, packing->first + packing->count, packing->line);
  }
}

static void explain_circle(FILE *out, const struct nb_scene *scene, const struct nb_circle *circle) {
  if (circle->line)
    fprintf(out, "    boundary begins: bodies %g%s from %g, %g or beyond, held (line %d)\n", circle->radius,
            unit(scene, " m"), circle->x, circle->y, circle->line);
}

static void explain_gravity(FILE *out, const struct nb_scene *scene, const struct nb_gravity *gravity) {
  const char *of = unit(scene, " m/s2");
  if (gravity->line && gravity->inward != 0)
    fprintf(out, "%sgravity centripetal %g%s about %g, %g (line %d)\n", gravity->ramp ? "ramp " : "", gravity->inward,
            of, gravity->about_x, gravity->about_y, gravity->line);
  else if (gravity->line)
    fprintf(out, "%sgravity %g %g%s (line %d)\n", gravity->ramp ? "ramp " : "", gravity->x, gravity->y, of,
            gravity->line);
}

/* ---- the plan ---- */

static size_t bits(unsigned set) {
  size_t count = 0;
  for (; set; set &= set - 1)
    count++;
  return count;
}

/* Whether there are two to meet: a lone body has no pair of its own material. */
static bool can_meet(const struct nb_scene *scene, const struct nb_pairing *pairing) {
  size_t bodies = 0;
  for (size_t k = 0; k < scene->body_count; k++)
    bodies += scene->bodies[k].material == pairing->a;
  return pairing->wall || pairing->a != pairing->b || bodies > 1;
}

static void name_pairing(FILE *out, const struct nb_scene *scene, const struct nb_pairing *pairing) {
  fprintf(out, "%s with %s%s", scene->materials[pairing->a].name, pairing->wall ? "wall of " : "",
          scene->materials[pairing->b].name);
}

static void explain_pairing(FILE *out, const struct nb_model *model, const struct nb_pairing *pairing) {
  size_t contacts = 0;
  if (!can_meet(model->scene, pairing))
    return;
  for (size_t c = 0; c < model->contacts.count; c++)
    contacts += &model->pairings[model->contacts.pairing[c]] == pairing;
  fputs("  ", out);
  name_pairing(out, model->scene, pairing);
  fprintf(out, ": %zu near; k_n %g, k_s %g, tan(phi) %g, c %g\n", contacts, pairing->values.kn, pairing->values.ks,
          pairing->values.friction, pairing->values.cohesion);
  for (int p = 0; p < pairing->pass_count; p++) {
    const struct nb_planned *planned = &pairing->passes[p];
    fprintf(out, "    %-40s", planned->name);
    if (planned->line)
      fprintf(out, " line %d", planned->line);
    fputc('\n', out);
  }
  if (!pairing->shear && strcmp(model->laws.shear->name, "none") != 0)
    fprintf(out, "    (no shear %s: without friction and cohesion there is nothing to hold)\n",
            model->laws.shear->name);
}

static void explain_memory(FILE *out, const struct nb_model *model) {
  static const char *const isa_names[] = {"plain", "avx2", "avx512"};
  const struct nb_bodies *bodies = &model->bodies;
  const size_t memory = (size_t)(model->contacts.normal_memory.doubles + model->contacts.shear_memory.doubles);
  const size_t per_body = sizeof(double) * (bodies->spin ? 14 : 12) + 5 * sizeof(int);
  const size_t per_contact = sizeof(double) * (2 + bits(model->plan.kept) + memory) + 5 * sizeof(int);
  fprintf(out, "memory\n  %zu bytes a body%s, %zu a contact (%zu fields kept, %zu remembered by laws)\n", per_body,
          bodies->spin ? "" : " (no spin)", per_contact, bits(model->plan.kept) + 2, memory);
  fprintf(out, "  %zu blocks of up to %d contacts, loops for %s, %d thread%s\n", model->blocks.count, NB_BLOCK,
          isa_names[model->machine.isa], model->machine.busy, model->machine.busy == 1 ? "" : "s");
}

/* What a cycle does besides motion, search and forces, as the run begins. */
static void explain_hooks(FILE *out, const struct nb_model *model) {
  static const char *const when[NB_WHENS] = {[NB_BEFORE_MOTION] = "before the motion",
                                             [NB_AFTER_MOTION] = "after the motion",
                                             [NB_BEFORE_SEARCH] = "before the search",
                                             [NB_BEFORE_FORCES] = "before the forces",
                                             [NB_AFTER_FORCES] = "after the forces"};
  fputs("hooks of the cycle, as the run begins\n", out);
  for (int w = 0; w < NB_WHENS; w++)
    for (size_t h = 0; h < model->hooks[w].count; h++)
      fprintf(out, "  %-18s %s\n", when[w], model->hooks[w].list[h].name);
}

static void explain_plan(FILE *out, const struct nb_model *model) {
  if (model->search.skin < INFINITY)
    fprintf(out, "contacts\n  %zu pairs near (closer than %g), searched again when something has moved %g\n",
            model->contacts.count, model->search.skin, model->search.skin / 2);
  else
    fprintf(out, "contacts\n  none, and no search: nothing is free to touch anything\n");
  if (model->scene->circle.line)
    fprintf(out, "boundary\n");
  explain_circle(out, model->scene, &model->scene->circle);
  explain_gravity(out, model->scene, &model->scene->gravity);
  fprintf(out, "passes of the force half, for each pairing of materials\n");
  for (size_t p = 0; p < model->pairing_count; p++)
    explain_pairing(out, model, &model->pairings[p]);
  explain_hooks(out, model);
  explain_memory(out, model);
  if (model->balance)
    fprintf(out, "balances\n  %s%s%s, summed up every cycle by one thread\n",
            (model->plan.asked & NB_ASKS_WORK) ? "work" : "",
            (model->plan.asked & NB_ASKS_WORK) && model->terms ? " and " : "", model->terms ? "energy" : "");
}

/* ---- regions ---- */

static size_t inside(const struct nb_model *model, int region) {
  const struct nb_region_now *now = nb_region_now(model, region);
  size_t count = 0;
  for (size_t i = 0; i < model->bodies.count; i++)
    count += !nb_gone(model, i) && nb_region_holds(model, now, i);
  return count;
}

static void explain_shape(FILE *out, const struct nb_scene *scene, const struct nb_region *it) {
  const char *of = unit(scene, " m");
  switch (it->kind) {
  case NB_REGION_CIRCLE:
    fprintf(out, "circle of %g%s about %g, %g", it->radius, of, it->x, it->y);
    break;
  case NB_REGION_BOX:
    fprintf(out, "box of %g by %g%s about %g, %g", 2 * it->half_x, 2 * it->half_y, of, it->x, it->y);
    break;
  case NB_REGION_INSIDE:
    fprintf(out, "inside %g of the boundary's mean radius", it->radius);
    break;
  case NB_REGION_ALL:
    fputs("all there is", out);
    break;
  }
}

static void explain_regions(FILE *out, const struct nb_model *model) {
  const struct nb_scene *scene = model->scene;
  if (scene->region_count > 0)
    fputs("regions\n", out);
  for (size_t w = 0; w < scene->watch_count; w++) {
    const struct nb_watch *watch = &scene->watches[w];
    if (watch->kind != NB_WATCH_REGION)
      continue;
    const struct nb_region *it = &scene->regions[watch->a];
    fprintf(out, "  %s: ", watch->name);
    explain_shape(out, scene, it);
    fprintf(out, ": %zu bodies now; strain since %s%s", inside(model, watch->a), it->stage < 0 ? "the start" : "stage ",
            it->stage < 0 ? "" : scene->stages[it->stage].name);
    if (it->rings)
      fprintf(out, "; %d rings", it->rings);
    fprintf(out, " (line %d)\n", it->line);
  }
}

/* ---- the step ---- */

static void explain_safe(FILE *out, const struct nb_model *model, const char *s) {
  const struct nb_safe safe = nb_safe_begin(model);
  char what[3 * NB_NAME_SIZE];
  nb_safe_words(what, sizeof what, model, &safe);
  fprintf(out, "  safe: %g%s; the step is %g of it; set by %s%s\n", safe.step, s, model->step / safe.step, what,
          model->step <= safe.step           ? ""
          : model->stability->allow_unstable ? "; allowed to be unstable"
                                             : "; ABOVE it: the run will stop at once");
}

static void explain_meeting(FILE *out, const struct nb_model *model, const char *s) {
  const struct nb_meeting meeting = nb_meeting_shortest(model);
  if (meeting.a < 0) {
    fprintf(out, "  contact: nothing approaches\n");
    return;
  }
  fprintf(out, "  contact, Hertz: %g%s, %.3g steps; body %d meets ", meeting.duration, s,
          meeting.duration / model->step, model->bodies.number[meeting.a]);
  if (meeting.wall)
    fprintf(out, "wall %s", model->scene->walls[meeting.b].name);
  else
    fprintf(out, "body %d", model->bodies.number[meeting.b]);
  fprintf(out, " at %g%s\n", meeting.speed, unit(model->scene, " m/s"));
}

static void explain_step(FILE *out, const struct nb_model *model) {
  const struct nb_step *step = &model->scene->stages[model->scene->start.stages].step;
  const char *s = unit(model->scene, " s");
  const bool elastic = nb_step_elastic(model);
  fprintf(out, "step\n  %g%s", model->step, s);
  if (step->set)
    fputs(", --set", out);
  else if (step->line)
    fprintf(out, ", line %d", step->line);
  fputc('\n', out);
  if (!elastic && isinf(model->critical)) {
    fprintf(out, "  critical: none, no contact has a stiffness\n");
    return;
  }
  if (!elastic)
    fprintf(out, "  critical, 2 sqrt(m/k): %g%s; the step is %g of it, the safe one %g of it\n", model->critical, s,
            model->step / model->critical, nb_safe_begin(model).step / model->critical);
  if (elastic && !nb_step_pressed(model))
    fprintf(out, "  safe: not known, elastic spheres that are not pressed have no stiffness\n");
  else
    explain_safe(out, model, s);
  const double contact = nb_step_contact(model);
  if (elastic)
    explain_meeting(out, model, s);
  else
    fprintf(out, "  contact, the shortest there can be: %g%s; the step is %g of it\n", contact, s,
            model->step / contact);
  const double smallest = nb_step_rayleigh(model, false, false), mean = nb_step_rayleigh(model, false, true);
  if (smallest < INFINITY)
    fprintf(out,
            "  rayleigh, a wave's time half round a sphere: smallest %g%s, mean %g%s; the step is %g and %g of it\n",
            smallest, s, mean, s, model->step / smallest, model->step / mean);
}

/* ---- what a stage changes ---- */

static void explain_rate(FILE *out, const struct nb_scene *scene, const char *what, const struct nb_strain_rate *strain,
                         const char *more, int line) {
  fprintf(out, "    %s carried by xx %g, yy %g, xy %g, yx %g%s%s (line %d)\n", what, strain->xx, strain->yy, strain->xy,
          strain->yx, strain->per_cycle ? " per cycle" : unit(scene, " 1/s"), more, line);
}

static void explain_boundary(FILE *out, const struct nb_scene *scene, const struct nb_boundary *to) {
  switch (to->control) {
  case NB_CONTROL_STRAIN:
    explain_rate(out, scene, "boundary", &to->strain, "", to->line);
    break;
  case NB_CONTROL_STRESS:
    fprintf(out, "    boundary free, under a stress of xx %g, yy %g, xy %g%s (line %d)\n", to->sxx, to->syy, to->sxy,
            unit(scene, " Pa"), to->line);
    break;
  case NB_CONTROL_NONE:
    fprintf(out, "    boundary none: its bodies are free (line %d)\n", to->line);
    break;
  }
}

/* What is held, on which region, boundary, cell or box, by which of them, and the gain: B and T as the scene begins, where
 * something is pressed then. */
static void explain_servo(FILE *out, const struct nb_model *model, const struct nb_servo *servo) {
  static const char *const parts[] = {"xx", "yy", "xy"};
  const struct nb_scene *scene = model->scene;
  const struct nb_quantity *seen = &servo->quantity[0];
  const char *name = seen->watch < 0 ? seen->kind->name : scene->watches[seen->watch].name;
  double b, t;
  fprintf(out, "    %sservo holds", servo->ramp ? "ramp " : "");
  if (servo->mean)
    fprintf(out, " (xx + yy)/2 at %g", servo->stress[0]);
  for (int k = 0; k < 3 && !servo->mean; k++)
    if (servo->held[k])
      fprintf(out, " %s at %g", parts[k], servo->stress[k]);
  fprintf(out, "%s on %.*s by %s, looked at every %lu cycles, at most %g%s (line %d)\n", unit(scene, " Pa"),
          (int)strcspn(name, "."), name,
          servo->cell        ? "the cell"
          : servo->box       ? "the walls of the box"
          : servo->continuum ? "boundary and continuum"
                             : "the boundary",
          servo->every, servo->most, servo->per_cycle ? " per cycle" : unit(scene, " 1/s"), servo->line);
  fputs("      gain: rate = off/(2 B T), and what has gathered of it over 16 T; ", out);
  if (nb_servo_scales(model, servo, &b, &t))
    fprintf(out, "now B is %g%s, from the contacts' stiffness, and T %g%s, a wave's time across\n", b,
            unit(scene, " Pa"), t, unit(scene, " s"));
  else
    fputs("B from the contacts' stiffness, T a wave's time across; nothing is pressed yet\n", out);
}

/* What moves the assembly from outside. */
static void explain_drive(FILE *out, const struct nb_model *model, const struct nb_stage *stage) {
  const struct nb_scene *scene = model->scene;
  explain_circle(out, scene, &stage->circle);
  if (stage->boundary.line)
    explain_boundary(out, scene, &stage->boundary);
  if (stage->continuum.line)
    explain_rate(out, scene, "continuum", &stage->continuum.strain, stage->continuum.literal ? ", literal" : "",
                 stage->continuum.line);
  if (stage->cell_line)
    explain_rate(out, scene, "cell", &stage->cell, "", stage->cell_line);
  if (stage->box_line)
    explain_rate(out, scene, "walls of the box", &stage->box, "", stage->box_line);
  if (stage->rotation_line)
    fprintf(out, "    rotation %s (line %d)\n", stage->rotation == NB_ROTATION_ON ? "on" : "off", stage->rotation_line);
  if (stage->servo.line)
    explain_servo(out, model, &stage->servo);
}

static void explain_law(FILE *out, const char *kind, const struct nb_law *old, const struct nb_law *new, int line) {
  fprintf(out, "    %s %s instead of %s: contacts remember nothing of it (line %d)\n", kind, new->name,
          old == new ? "so many pieces" : old->name, line);
}

/* Which laws are in force before the stage, and which from it on. */
static void explain_laws(FILE *out, const struct nb_model *model, const struct nb_stage *stage) {
  struct nb_in_force old = nb_laws_at_start(model->scene);
  for (const struct nb_stage *s = model->scene->stages; s < stage; s++)
    old = nb_laws_of(s, old);
  const struct nb_in_force now = nb_laws_of(stage, old);
  if (now.normal != old.normal)
    explain_law(out, "normal", old.normal, now.normal, now.normal_line);
  if (now.shear != old.shear || now.pieces != old.pieces)
    explain_law(out, "shear", old.shear, now.shear, now.shear_line);
}

static void explain_value(FILE *out, const char *word, double to) {
  if (!isnan(to))
    fprintf(out, " %s %g", word, to);
}

static void explain_change(FILE *out, const struct nb_scene *scene, const struct nb_change *change) {
  fprintf(out, "    %s%s%s", change->ramp ? "ramp " : "", change->b < 0 ? "material " : "pair ",
          scene->materials[change->a].name);
  if (change->b >= 0)
    fprintf(out, " %s", scene->materials[change->b].name);
#define ROW(name, ...) explain_value(out, #name, change->name);
  NB_PAIR_ROWS(ROW)
#undef ROW
  fprintf(out, " (line %d)\n", change->line);
}

/* Which pairings have friction or cohesion now; into a list of as many as the model has. */
static void rubbing(bool *rubs, const struct nb_model *model, const struct nb_properties *now) {
  for (size_t p = 0; p < model->pairing_count; p++) {
    const struct nb_pair pair = nb_properties_pair(now, model->pairings[p].a, model->pairings[p].b);
    rubs[p] = pair.friction > 0 || pair.cohesion > 0;
  }
}

/* The stage's changes of materials, each carried out, and what they do to the plan. */
static bool explain_changes(FILE *out, const struct nb_model *model, const struct nb_stage *stage,
                            struct nb_properties *now) {
  const char *shear = model->laws.shear->name;
  bool *rubs = calloc(2 * model->pairing_count + 1, sizeof *rubs), *after = rubs + model->pairing_count;
  if (!rubs)
    return false;
  rubbing(rubs, model, now);
  for (size_t k = 0; k < stage->change_count; k++) {
    explain_change(out, model->scene, &stage->changes[k]);
    nb_properties_change(now, &stage->changes[k], nb_properties_before(now, &stage->changes[k]), 1);
  }
  rubbing(after, model, now);
  for (size_t p = 0; p < model->pairing_count && strcmp(shear, "none") != 0; p++) {
    if (rubs[p] == after[p])
      continue;
    fputs("    ", out);
    name_pairing(out, model->scene, &model->pairings[p]);
    fprintf(out, ": shear %s is switched %s, %s\n", shear, after[p] ? "on" : "off",
            after[p] ? "remembering nothing" : "and forgets");
  }
  free(rubs);
  return true;
}

/* All that is said in the stage; the materials are moved on to its end. */
static bool explain_stage(FILE *out, const struct nb_model *model, const struct nb_stage *stage,
                          struct nb_properties *now) {
  const struct nb_scene *scene = model->scene;
  fprintf(out, "  %-20s %s %lu cycles", stage->name, stage->condition_count ? "at most" : "       ", stage->cycles);
  if (stage->record)
    fprintf(out, ", a row every %lu", stage->record);
  if (stage->snapshot)
    fprintf(out, ", snapshot at its end");
  if (stage->snapshot_from >= 0)
    fprintf(out, " from %s", scene->stages[stage->snapshot_from].name);
  fprintf(out, " (line %d)\n", stage->line);
  explain_laws(out, model, stage);
  explain_drive(out, model, stage);
  if (stage->still)
    fprintf(out, "    still: all bodies stop\n");
  for (size_t k = 0; k < stage->removal_count; k++) {
    const struct nb_removal *it = &stage->removals[k];
    fprintf(out, "    remove body %zu", it->from + 1);
    if (it->to > it->from)
      fprintf(out, " to %zu", it->to + 1);
    fprintf(out, " (line %d)\n", it->line);
  }
  if (stage->gravity.line)
    fprintf(out, "    ");
  explain_gravity(out, scene, &stage->gravity);
  return stage->change_count == 0 || explain_changes(out, model, stage, now);
}

/* Measured, not guessed: some cycles of a model of its own, at rest as the scene begins. Seconds a cycle; 0 and an error when
 * not even one could be made. */
static double seconds_a_cycle(const struct nb_scene *scene, const struct nb_model *model, struct nb_error *error) {
  struct nb_model *trial =
      nb_model_create(scene, &(struct nb_options){.threads = model->machine.threads, .states = model->states}, error);
  const double began = nb_clock();
  unsigned long cycles = 0;
  while (trial && (cycles == 0 || nb_clock() - began < 0.02) && !nb_cycle(trial, error))
    cycles++;
  const double seconds = nb_clock() - began;
  nb_model_free(trial);
  return cycles ? seconds / (double)cycles : 0;
}

static bool explain_stages(FILE *out, const struct nb_model *model) {
  const struct nb_scene *scene = model->scene;
  unsigned long cycles = 0;
  struct nb_properties now = {0};
  bool known = nb_properties_create(&now, scene);
  for (size_t s = 0; known && s < scene->start.stages; s++)
    for (size_t k = 0; k < scene->stages[s].change_count; k++)
      nb_properties_change(&now, &scene->stages[s].changes[k], nb_properties_before(&now, &scene->stages[s].changes[k]),
                           1);
  fprintf(out, "stages\n");
  for (size_t s = scene->start.stages; known && s < scene->stage_count; s++) {
    known = explain_stage(out, model, &scene->stages[s], &now);
    cycles += scene->stages[s].cycles;
  }
  nb_properties_free(&now);
  struct nb_error error = {NB_OK, ""};
  const double each = known ? seconds_a_cycle(scene, model, &error) : 0;
  fprintf(out, "cost\n  %lu cycles", cycles);
  if (each > 0)
    fprintf(out, ", %.3g s (%.3g us a cycle, measured just now)\n", each * (double)cycles, 1e6 * each);
  else
    fprintf(out, "; the time of a cycle cannot be measured: %s\n", known ? error.text : "out of memory");
  return known && error.status != NB_NO_MEMORY;
}

/* ---- a path ---- */

static void explain_bench_law(FILE *out, const struct nb_law *law, int doubles, int line) {
  fprintf(out, "  %s %s: %s %s", law->kind, law->name, law->title, law->source);
  if (line)
    fprintf(out, ", line %d", line);
  fprintf(out, "\n    remembers %d number%s%s%s%s\n", doubles, doubles == 1 ? "" : "s",
          law->stored ? "; knows its stored energy" : "; has no stored energy",
          law->loses ? "; says what it loses" : "", law->gains ? "; may create energy" : "");
}

static void explain_aim(FILE *out, const struct nb_scene *scene, const struct nb_aim *aim, bool shear) {
  const char *what = aim->force ? (shear ? "shear" : "normal") : shear ? "slip" : "overlap";
  if (aim->by && aim->value == 0)
    fprintf(out, ", %s held", what);
  else
    fprintf(out, ", %s %s %g%s", what, aim->by ? "by" : "to", aim->value, unit(scene, aim->force ? " N" : " m"));
}

static void explain_contact(FILE *out, const struct nb_scene *scene, const struct nb_bench *bench) {
  static const char *const shapes[] = {[NB_DISC] = "disc", [NB_SPHERE] = "sphere"};
  const char *m = unit(scene, " m"), *pa = unit(scene, " Pa");
  fputs("contact on the bench\n  ", out);
  for (size_t k = 0; k < scene->body_count; k++) {
    const struct nb_body *body = &scene->bodies[k];
    fprintf(out, "%s%s of %s, radius %g%s", k ? ", with " : "", shapes[body->shape],
            scene->materials[body->material].name, body->radius, m);
  }
  if (scene->body_count == 1)
    fprintf(out, ", with a wall of %s", scene->materials[scene->walls[0].material].name);
  fputc('\n', out);
  if (bench->normal->elastic)
    fprintf(out, "  R* %g%s, E* %g%s, G* %g%s, friction %g\n", bench->pair.radius, m, bench->pair.young, pa,
            bench->pair.shear, pa, bench->pair.friction);
  else
    fprintf(out, "  k_n %g, k_s %g, friction %g, cohesion %g\n", bench->pair.kn, bench->pair.ks, bench->pair.friction,
            bench->pair.cohesion);
}

static enum nb_status explain_bench(FILE *out, const struct nb_scene *scene, struct nb_error *error) {
  struct nb_bench bench;
  if (nb_bench_create(&bench, scene, error))
    return error->status;
  explain_contact(out, scene, &bench);
  fprintf(out, "laws\n");
  explain_bench_law(out, bench.normal, bench.normal_doubles, scene->normal_line);
  explain_bench_law(out, bench.shear, bench.shear_doubles, scene->shear_line);
  fprintf(out, "legs\n");
  unsigned long steps = 0;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    fprintf(out, "  %-20s %lu steps", stage->name, stage->cycles);
    if (stage->leg.points) {
      fprintf(out, ", from point to point of a file");
    } else {
      explain_aim(out, scene, &stage->leg.normal, false);
      explain_aim(out, scene, &stage->leg.shear, true);
    }
    if (stage->snapshot)
      fprintf(out, ", snapshot at its end");
    if (stage->line)
      fprintf(out, " (line %d)", stage->line);
    fputc('\n', out);
    steps += stage->cycles;
  }
  fprintf(out, "cost\n  %lu steps; one that goes to a force tries some hundred places first\n", steps);
  nb_bench_free(&bench);
  return NB_OK;
}

/* ---- all of it ---- */

enum nb_status nb_explain(FILE *out, const struct nb_scene *scene, const struct nb_options *options,
                          struct nb_warnings *warnings, struct nb_error *error) {
  if (scene->path)
    return explain_bench(out, scene, error);
  if (!nb_start_there(scene, options)) {
    explain_start(out, scene, options);
    fputs("  the plan can be told when it is there\n", out);
    return NB_OK;
  }
  struct nb_model *model = nb_model_create(scene, options, error);
  if (!model)
    return error->status;
  explain_start(out, scene, options);
  explain_bodies(out, scene);
  explain_plan(out, model);
  explain_regions(out, model);
  explain_step(out, model);
  const bool done = explain_stages(out, model);
  for (size_t k = 0; k < model->warnings.count; k++)
    nb_warnings_add(warnings, &model->warnings.list[k]);
  nb_model_free(model);
  return done ? NB_OK : nb_error_memory(error);
}
