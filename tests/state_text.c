/* Small saved states as text, for the tests of the functions that read states.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "state_text.h"
#include "run/plan.h"

#include <CUnit/CUnit.h>
#include <stdlib.h>
#include <string.h>

#include "../src/run/state.h"
#include "written.h"

const char state_plain[] =
    "units none\nmaterial m density 3 kn 4000 friction 0.3 young 5000 poisson 0.2\npair m m friction 0.2\nnormal "
    "hertz_increment\nshear mindlin\nwall w -5 0 to 5 0 m\nlattice spheres 2 by 1 m radius 1 spacing 1.99 from "
    "0 0.995\ngravity 1 -1\nstep 0.001\nstage a\ncycles 20\n";
const char state_ring[] =
    "units none\nmaterial m density 3 kn 4000\nlattice discs 3 by 3 m radius 1 spacing 1.99 from -2 -2\nboundary "
    "circle 0 0 radius 2.5\nstep 0.001\nstage a\nboundary strain 0.1 -0.1\naffine "
    "strain 1e-4 per cycle 0 per cycle\nrotation off\ngravity centripetal 2 about 1 0\ncycles 20\n";
const char state_cell[] = "units none\nmaterial m density 3 kn 4000\nlattice discs 3 by 3 m radius 1 spacing 1.99 "
                          "from 0.1 0.2\nperiodic cell 0 0 to 5.97 "
                          "5.97\nstep 0.001\nstage a\ncell strain 0.1 -0.1 c12 0.3 c21 0\ncycles 20\n";

char *state_of(const char *statements, size_t *size) {
  struct words page = {0};
  struct written it;
  struct nb_saved saved;
  struct nb_error error;
  words_add(&page, "%s", statements);
  written_scene(&it, &page);
  struct nb_model *model = written_model(&it, &(struct nb_options){.keep_all = true, .threads = 1});
  CU_ASSERT_EQUAL_FATAL(nb_stage_begin(model, &it.scene.stages[0], &error), NB_OK);
  written_cycles(model, 20);
  CU_ASSERT_EQUAL_FATAL(nb_saved_capture(&saved, model, &error), NB_OK);
  CU_ASSERT(saved.contact_count > 2);
  saved.settings = calloc(1, sizeof *saved.settings);
  strcpy(saved.settings[0], "v=0.1 m/s"), saved.setting_count = 1;
  char *text = nb_saved_text(&saved, size);
  CU_ASSERT_PTR_NOT_NULL_FATAL(text);
  nb_saved_free(&saved);
  nb_model_free(model);
  written_free(&it);
  return text;
}
char *state_sealed(const char *text, size_t length, size_t *size) {
  char *sealed = malloc(length + NB_STATE_END + 1);
  memcpy(sealed, text, length);
  sprintf(sealed + length, "end %016llx\n", nb_hash(NB_HASH_BEGIN, text, length));
  *size = length + NB_STATE_END;
  return sealed;
}

char *state_changed(const char *statements, const char *from, const char *to, size_t *size) {
  size_t length;
  char *text = state_of(statements, &length), *at = strstr(text, from);
  CU_ASSERT_PTR_NOT_NULL_FATAL(at);
  char *other = malloc(length + strlen(to) + 1);
  sprintf(other, "%.*s%s%s", (int)(at - text), text, to, at + strlen(from));
  char *sealed = state_sealed(other, strlen(other) - NB_STATE_END, size);
  free(text), free(other);
  return sealed;
}
