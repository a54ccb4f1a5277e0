/* The plan, in words: what is switched on and which line of the page asked for it, what it weighs, what sets the step.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "core/clock.h"
#include "explain.h"
#include "measure/balance.h"
#include "measure/step.h"

static const char *const isa_names[] = {"plain", "avx2", "avx512"};

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

static void explain_pairing(FILE *out, const struct nb_model *model, const struct nb_pairing *pairing) {
  const struct nb_scene *scene = model->scene;
  size_t contacts = 0;
  if (!can_meet(scene, pairing))
    return;
  for (size_t c = 0; c < model->contacts.count; c++)
    contacts += &model->pairings[model->contacts.pairing[c]] == pairing;
  fprintf(out, "  %s with %s%s: %zu near; k_n %g, k_s %g, tan(phi) %g, c %g\n", scene->materials[pairing->a].name,
          pairing->wall ? "wall of " : "", scene->materials[pairing->b].name, contacts, pairing->values.kn,
          pairing->values.ks, pairing->values.friction, pairing->values.cohesion);
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
  const struct nb_bodies *bodies = &model->bodies;
  const size_t memory = (size_t)(model->contacts.normal_memory.doubles + model->contacts.shear_memory.doubles);
  const size_t per_body = sizeof(double) * (bodies->spin ? 14 : 12) + 5 * sizeof(int);
  const size_t per_contact = sizeof(double) * (2 + bits(model->plan.kept) + memory) + 5 * sizeof(int);
  fprintf(out, "memory\n  %zu bytes a body%s, %zu a contact (%zu fields kept, %zu remembered by laws)\n", per_body,
          bodies->spin ? "" : " (no spin)", per_contact, bits(model->plan.kept) + 2, memory);
  fprintf(out, "  %zu blocks of up to %d contacts, loops for %s, %d thread%s\n", model->blocks.count, NB_BLOCK,
          isa_names[model->machine.isa], model->machine.busy, model->machine.busy == 1 ? "" : "s");
}

static void explain_safe(FILE *out, const struct nb_model *model, const char *unit) {
  const struct nb_safe safe = nb_safe_begin(model);
  char what[3 * NB_NAME_SIZE];
  nb_safe_words(what, sizeof what, model, &safe);
  fprintf(out, "  safe: %g%s; the step is %g of it; set by %s%s\n", safe.step, unit, model->step / safe.step, what,
          model->step <= safe.step           ? ""
          : model->stability->allow_unstable ? "; allowed to be unstable"
                                             : "; ABOVE it: the run will stop at once");
}

static void explain_meeting(FILE *out, const struct nb_model *model, const char *unit) {
  const struct nb_meeting meeting = nb_meeting_shortest(model);
  if (meeting.a < 0) {
    fprintf(out, "  contact: nothing approaches\n");
    return;
  }
  fprintf(out, "  contact, Hertz: %g%s, %.3g steps; body %d meets ", meeting.duration, unit,
          meeting.duration / model->step, model->bodies.number[meeting.a]);
  if (meeting.wall)
    fprintf(out, "wall %s", model->scene->walls[meeting.b].name);
  else
    fprintf(out, "body %d", model->bodies.number[meeting.b]);
  fprintf(out, " at %g%s\n", meeting.speed, model->scene->unitless ? "" : " m/s");
}

static void explain_rayleigh(FILE *out, const struct nb_model *model, const char *unit) {
  const double smallest = nb_step_rayleigh(model, false, false), mean = nb_step_rayleigh(model, false, true);
  if (smallest < INFINITY)
    fprintf(out,
            "  rayleigh, a wave's time half round a sphere: smallest %g%s, mean %g%s; the step is %g and %g of it\n",
            smallest, unit, mean, unit, model->step / smallest, model->step / mean);
}

static void explain_step(FILE *out, const struct nb_model *model) {
  const struct nb_step *step = &model->scene->stages[model->scene->start.stages].step;
  const char *unit = model->scene->unitless ? "" : " s";
  fprintf(out, "step\n  %g%s", model->step, unit);
  if (step->set)
    fputs(", --set", out);
  else if (step->line)
    fprintf(out, ", line %d", step->line);
  fputc('\n', out);
  const double contact = nb_step_contact(model);
  if (!nb_step_elastic(model) && isinf(model->critical)) {
    fprintf(out, "  critical: none, no contact has a stiffness\n");
    return;
  }
  if (!nb_step_elastic(model))
    fprintf(out, "  critical, 2 sqrt(m/k): %g%s; the step is %g of it, the safe one %g of it\n", model->critical, unit,
            model->step / model->critical, nb_safe_begin(model).step / model->critical);
  if (nb_step_elastic(model) && !nb_step_pressed(model))
    fprintf(out, "  safe: not known, elastic spheres that are not pressed have no stiffness\n");
  else
    explain_safe(out, model, unit);
  if (!nb_step_elastic(model))
    fprintf(out, "  contact, the shortest there can be: %g%s; the step is %g of it\n", contact, unit,
            model->step / contact);
  else
    explain_meeting(out, model, unit);
  explain_rayleigh(out, model, unit);
}

/* Measured, not guessed: some cycles of a model of its own, at rest as the scene begins. */
static double seconds_a_cycle(const struct nb_scene *scene, const struct nb_model *model) {
  struct nb_error error;
  struct nb_model *trial =
      nb_model_create(scene, &(struct nb_options){.threads = model->machine.threads, .states = model->states}, &error);
  if (!trial)
    return 0;
  const double began = nb_clock();
  unsigned long cycles = 0;
  while (nb_clock() - began < 0.02 && !nb_cycle(trial, &error))
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
  for (size_t s = scene->start.stages; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    fprintf(out, "  %-20s %s %lu cycles", stage->name, stage->condition_count ? "at most" : "       ", stage->cycles);
    if (stage->record)
      fprintf(out, ", a row every %lu", stage->record);
    if (stage->snapshot)
      fprintf(out, ", snapshot at its end");
    if (stage->snapshot_from >= 0)
      fprintf(out, " from %s", scene->stages[stage->snapshot_from].name);
    fprintf(out, " (line %d)\n", stage->line);
    known = known && nb_explain_changes(out, model, stage, &now);
    cycles += stage->cycles;
  }
  nb_properties_free(&now);
  const double each = seconds_a_cycle(scene, model);
  fprintf(out, "cost\n  %lu cycles, %.3g s (%.3g us a cycle, measured just now)\n", cycles, each * (double)cycles,
          1e6 * each);
  return known;
}

bool nb_explain(FILE *out, const struct nb_scene *scene, const struct nb_model *model) {
  fprintf(out, "bodies\n  %zu free or fixed, %zu walls\n", scene->body_count, scene->wall_count);
  nb_explain_fills(out, scene);
  if (model->search.skin < INFINITY)
    fprintf(out, "contacts\n  %zu pairs near (closer than %g), searched again when something has moved %g\n",
            model->contacts.count, model->search.skin, model->search.skin / 2);
  else
    fprintf(out, "contacts\n  none, and no search: nothing is free to touch anything\n");
  if (scene->circle.line)
    fprintf(out, "boundary\n");
  nb_explain_circle(out, &scene->circle, scene->unitless);
  nb_explain_gravity(out, &scene->gravity, scene->unitless ? "" : " m/s2");
  fprintf(out, "passes of the force half, for each pairing of materials\n");
  for (size_t p = 0; p < model->pairing_count; p++)
    explain_pairing(out, model, &model->pairings[p]);
  explain_memory(out, model);
  if (model->balance)
    fprintf(out, "balances\n  %s%s%s, summed up every cycle by one thread\n", model->balance->works ? "work" : "",
            model->balance->works && model->balance->energies ? " and " : "", model->balance->energies ? "energy" : "");
  nb_explain_regions(out, model);
  explain_step(out, model);
  return explain_stages(out, model);
}
