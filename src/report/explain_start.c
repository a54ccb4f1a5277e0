/* What a page starts from, in words, and what that starts from.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "run/start.h"

void nb_explain_start(FILE *out, const struct nb_scene *scene, const struct nb_options *options) {
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
