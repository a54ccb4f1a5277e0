/* The paths of all contacts in a run of the program. Each path is replayed with the exact law and with by_hand.h.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>

#include "../../src/run/plan.h"
#include "paths.h"

const char *const run_names[RUNS] = {"bounce", "incline", "sheared"};
const char *const run_titles[RUNS] = {
    "a sphere with a damped contact is thrown on a floor, bounces and comes to rest",
    "a sphere rolls down an incline, with vibrations that only micro-slip damps",
    "all contacts of an assembly of 60 spheres that is sheared forward and back",
};

/* A replay for each pair of a particle and a partner. Partners are first all particles, then all walls. */
struct replays {
  size_t particles, partners;
  struct replay **of;
  const struct nb_law *shear;
};

static struct replay *replay_of(struct replays *all, const struct nb_model *model, size_t c) {
  const struct nb_contacts *contacts = &model->contacts;
  const size_t a = (size_t)model->particles.number[contacts->a[c]] - 1;
  const size_t b = c < contacts->wall_from ? (size_t)model->particles.number[contacts->b[c]] - 1
                                           : all->particles + (size_t)contacts->b[c];
  struct replay **replay = &all->of[a * all->partners + b];
  if (!*replay)
    *replay = replay_new(all->shear);
  return *replay;
}

static void record(struct replays *all, const struct nb_model *model, struct errors *errors) {
  const struct nb_contacts *contacts = &model->contacts;
  for (size_t c = 0; c < contacts->count; c++) {
    const struct nb_pair values = model->material_pairs[contacts->material_pair[c]].values;
    const double overlap = contacts->kept[NB_OVERLAP][c];
    if (overlap > 0)
      replay_go(replay_of(all, model, c), nb_contact_constants(model, c, values), overlap,
                contacts->kept[NB_TANGENTIAL_INCREMENT][c], errors);
    else
      replay_begin(replay_of(all, model, c));
  }
}

static void fail(const char *why) {
  fprintf(stderr, "contact_paths: %s\n", why);
  exit(2);
}

static void run_stages(const struct nb_scene *scene, long cycles, struct replays *all, struct errors *errors) {
  static const struct nb_options options = {.threads = 1};
  struct nb_error error = {0};
  struct nb_model *model = nb_model_create(scene, &options, &error);
  long done = 0;
  for (size_t s = 0; model && s < scene->stage_count && done < cycles; s++) {
    if (nb_stage_begin(model, &scene->stages[s], &error))
      fail(error.text);
    for (unsigned long k = 0; k < scene->stages[s].cycles && done < cycles; k++, done++) {
      if (nb_cycle(model, &error))
        fail(error.text);
      record(all, model, errors);
    }
  }
  if (!model)
    fail(error.text);
  nb_model_free(model);
}

struct errors exact_in_run(const struct nb_law *shear, int run, long cycles) {
  char path[512];
  struct nb_mistakes mistakes = {0};
  struct nb_page page = {0};
  struct nb_scene scene = {0};
  struct errors errors = {0};
  snprintf(path, sizeof path, "%s/tests/pages/path-%s.md", NB_SRCDIR, run_names[run]);
  nb_page_read(&page, path, &mistakes);
  nb_scene_read(&scene, &page, 0, NULL, &mistakes);
  if (mistakes.count)
    fail(mistakes.text);
  nb_mistakes_free(&mistakes);
  struct replays all = {
      .particles = scene.particle_count, .partners = scene.particle_count + scene.wall_count, .shear = shear};
  all.of = calloc(all.particles * all.partners, sizeof *all.of);
  if (!all.of)
    fail("no memory");
  run_stages(&scene, cycles, &all, &errors);
  for (size_t k = 0; k < all.particles * all.partners; k++)
    replay_free(all.of[k]);
  free(all.of);
  nb_scene_free(&scene);
  nb_page_free(&page);
  return errors;
}
