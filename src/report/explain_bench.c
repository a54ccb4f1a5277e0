/* What a path does, in words: the contact on the bench, its laws and the lines that asked for them, its legs.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "run/bench.h"

static void explain_law(FILE *out, const struct nb_law *law, int doubles, int line) {
  fprintf(out, "  %s %s: %s %s", law->kind, law->name, law->title, law->source);
  if (line)
    fprintf(out, ", line %d", line);
  fprintf(out, "\n    remembers %d number%s%s%s%s\n", doubles, doubles == 1 ? "" : "s",
          law->stored ? "; knows its stored energy" : "; has no stored energy",
          law->loses ? "; says what it loses" : "", law->gains ? "; may create energy" : "");
}

static void explain_aim(FILE *out, const struct nb_aim *aim, bool shear, bool unitless) {
  const char *what = aim->force ? (shear ? "shear" : "normal") : shear ? "slip" : "overlap";
  const char *unit = unitless ? "" : aim->force ? " N" : " m";
  if (aim->by && aim->value == 0)
    fprintf(out, ", %s held", what);
  else
    fprintf(out, ", %s %s %g%s", what, aim->by ? "by" : "to", aim->value, unit);
}

void nb_explain_bench(FILE *out, const struct nb_scene *scene) {
  struct nb_bench bench;
  struct nb_error error;
  if (nb_bench_create(&bench, scene, &error)) {
    fprintf(out, "%s\n", error.text);
    return;
  }
  const struct nb_body *body = &scene->bodies[0];
  const char *length = scene->unitless ? "" : " m", *pressure = scene->unitless ? "" : " Pa";
  static const char *const shapes[] = {[NB_DISC] = "disc", [NB_SPHERE] = "sphere"};
  fprintf(out, "contact on the bench\n  %s of %s, radius %g%s, with ", shapes[body->shape],
          scene->materials[body->material].name, body->radius, length);
  if (scene->body_count > 1)
    fprintf(out, "%s of %s, radius %g%s\n", shapes[body[1].shape], scene->materials[body[1].material].name,
            body[1].radius, length);
  else
    fprintf(out, "a wall of %s\n", scene->materials[scene->walls[0].material].name);
  if (bench.normal->elastic)
    fprintf(out, "  R* %g%s, E* %g%s, G* %g%s, friction %g\n", bench.pair.radius, length, bench.pair.young, pressure,
            bench.pair.shear, pressure, bench.pair.friction);
  else
    fprintf(out, "  k_n %g, k_s %g, friction %g, cohesion %g\n", bench.pair.kn, bench.pair.ks, bench.pair.friction,
            bench.pair.cohesion);
  fprintf(out, "laws\n");
  explain_law(out, bench.normal, bench.normal_doubles, scene->normal_line);
  explain_law(out, bench.shear, bench.shear_doubles, scene->shear_line);
  fprintf(out, "legs\n");
  unsigned long steps = 0;
  for (size_t s = 0; s < scene->stage_count; s++) {
    const struct nb_stage *stage = &scene->stages[s];
    fprintf(out, "  %-20s %lu steps", stage->name, stage->cycles);
    if (stage->leg.points) {
      fprintf(out, ", from point to point of a file");
    } else {
      explain_aim(out, &stage->leg.normal, false, scene->unitless);
      explain_aim(out, &stage->leg.shear, true, scene->unitless);
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
}
