/* The readers of saved states and of checkpoints. About half of the inputs get a new checksum, so that their records
 * are read even if they were changed. A state that was read must be complete, and an error must have a position. If the
 * page accepts a state, it runs for a few cycles from this state: whatever the numbers are, the run must end with a
 * status.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../../src/core/model.h"
#include "../../src/input/reader.h"
#include "../../src/run/checkpoint.h"
#include "../../src/run/plan.h"
#include "fuzz.h"

enum { LONGEST = 32 << 10, CYCLES = 3 };

/* The statements before and after the state. Together the pages have every record, and every kind of history. */
static const struct {
  const char *first, *second;
} pages[] = {
    {"```scene\nunits none\nlet a = 2\nmaterial m density 3 young 5000 poisson 0.2 friction 0.3\nmaterial n density $a "
     "kn 1e4\n"
     "pair m m friction 0.2\nnormal hertz_increment\nshear mindlin_deresiewicz memory 3\nwall w -5 0 to 5 0 m\n"
     "lattice spheres 2 by 2 m radius 1 spacing 1.99 from 0 0.995\nsphere 9 1 radius 1 m fixed\ngravity 1 -1\n"
     "step 0.001\nstage a\ncycles 20\n",
     "stage b\nremove sphere 2\nmaterial m friction 0.1\nwall w velocity 0 0.1\ncycles 9\n"},
    {"```scene\nunits none\nmaterial m density 3 kn 4000 ks 2000 friction 0.3\nshear linear\nlattice discs 3 by 3 m "
     "radius 1 "
     "spacing 1.99 from -2 -2\nboundary circle 0 0 radius 2.5\nstep 0.001\nstage a\nboundary strain 0.1 -0.1\n"
     "affine strain 1e-4 per cycle 0 per cycle\nrotation off\ngravity centripetal 2 about 1 0\ncycles 20\n",
     "stage b\nrotation on\ncycles 9\n"},
    {"```scene\nunits none\nmaterial m density 3 young 5000 poisson 0.2 friction 0.3\nnormal hertz\nshear randall\n"
     "lattice spheres 3 by 3 m radius 1 spacing 1.99 from 0.1 0.2\nperiodic cell 0 0 to 5.97 5.97\nstep 0.001\nstage "
     "a\n"
     "cell strain 0.1 -0.1 c12 0.3 c21 0\ncycles 20\n",
     "stage b\ncycles 9\n"},
    {"```scene\nunits none\nmaterial m density 3 kn 5000 ks 4000 friction 0.3\nshear linear\nregion A all\nstep 0.001\n"
     "record time energy.balance energy.walls step.fracc step.stable A.stress.xx A.strain.xx A.contacts.lost\n"
     "lattice discs 2 by 2 m radius 0.5 spacing 0.999 from 0.5 0.5\nbox 0 0 to 2 2 m\nstage a\nwalls inward 0.5\n"
     "cycles 10\nsnapshot\n",
     "stage b\nramp material m friction 0.01 kn 9000\nramp gravity 0 -50\nramp walls inward -0.2\ncycles 20\n"
     "snapshot from a\n"},
    {"```scene\nunits none\nmaterial m density 3 kn 5000 ks 4000 friction 0.3\nshear linear\nregion A all\nstep 0.001\n"
     "record time A.stress.xx\nlattice discs 3 by 3 m radius 0.5 spacing 0.999 from 0.5 0.5\n"
     "boundary circle 1.5 1.5 radius 1.2\nstage a\ncycles 10\n",
     "stage b\nboundary strain -4e-5 per cycle 2e-5 per cycle\n"
     "servo mean 20 on boundary through boundary at most 1e-5 per cycle\ncycles 20\n"},
};
enum { PAGES = sizeof pages / sizeof *pages };

/* A page that continues from a state: all its stages, and the state after the first one. */
struct continued {
  struct nb_page page;
  struct nb_scene scene, whole; /* the scene that starts from the state; the scene with both stages */
  char *text;
  size_t size;
};

static void make_state(struct continued *it, const struct nb_scene *scene) {
  struct nb_saved saved;
  struct nb_error error = {NB_OK, ""};
  const enum nb_status status = nb_run_to(&saved, scene, NULL, NULL, &error);
  it->text = status ? NULL : nb_saved_text(&saved, &it->size);
  fuzz_hold(it->text && it->size <= LONGEST, "a state is saved");
  nb_saved_free(&saved);
}

/* Page number k. Its name is "seed" and this number, and the state contains this name. */
static const struct continued *page_of(int k) {
  static struct continued all[PAGES];
  struct continued *it = &all[k];
  if (it->text)
    return it;
  struct nb_page page;
  struct nb_scene scene;
  char statements[1500], name[NB_NAME_SIZE];
  snprintf(name, sizeof name, "seed%d.md", k);
  fuzz_read_page(&page, &scene, name, pages[k].first);
  make_state(it, &scene);
  nb_scene_free(&scene), nb_page_free(&page);
  snprintf(statements, sizeof statements, "%s%s", pages[k].first, pages[k].second);
  fuzz_read_page(&it->page, &it->scene, name, statements);
  nb_page_free(&it->page);
  fuzz_read_page(&it->page, &it->whole, name, statements);
  it->scene.start.stages = 1;
  return it;
}

/* Tests that all indices are in range, and that the state is the same after writing and reading. */
static void hold_saved(const struct nb_saved *saved) {
  struct nb_saved again;
  struct nb_error error = {NB_OK, ""};
  for (size_t c = 0; c < saved->contact_count; c++) {
    const struct nb_saved_contact *it = &saved->contacts[c];
    const size_t others = it->wall ? saved->wall_count : saved->particle_count;
    fuzz_hold(it->a >= 0 && (size_t)it->a < saved->particle_count && it->b >= 0 && (size_t)it->b < others,
              "a contact is between particles and walls of the state");
    for (int shear = 0; shear < 2; shear++) {
      const struct nb_saved_history memory = shear ? it->shear : it->normal;
      fuzz_hold(memory.count >= 0 && memory.at + (size_t)memory.count <= saved->history_count,
                "the history of a contact is in range");
    }
  }
  for (size_t k = 0; k < saved->particle_count; k++) {
    const struct nb_saved_particle *it = &saved->particles[k];
    const double numbers[] = {it->radius, it->position.x, it->position.y, it->velocity.x, it->velocity.y, it->spin};
    for (size_t n = 0; n < sizeof numbers / sizeof *numbers; n++)
      fuzz_hold(isfinite(numbers[n]), "the numbers of a particle are finite");
    fuzz_hold(it->radius > 0 && (size_t)it->material < saved->material_count, "a particle has a size and a material");
  }
  for (size_t k = 0; k < saved->ring.member_count; k++)
    fuzz_hold((size_t)saved->ring.members[k] < saved->particle_count, "a member is a particle");
  size_t size = 0, same = 0;
  char *text = nb_saved_text(saved, &size), *other = NULL;
  fuzz_hold(text && !nb_saved_read_text(&again, "again.state", text, size, &error), "a state can be written again");
  other = nb_saved_text(&again, &same);
  fuzz_hold(other && size == same && memcmp(text, other, size) == 0, "a state written again is the same");
  nb_saved_free(&again);
  free(text), free(other);
}

/* Runs the page from the state. True if all cycles were run. */
static bool go_on(const struct nb_scene *scene, struct nb_saved *saved) {
  struct nb_error error = {NB_OK, ""};
  struct nb_model *model = nb_model_resume(scene, &(struct nb_options){.threads = 1, .keep_all = true}, saved, &error);
  fuzz_hold(model || error.status, "without a model there is an error");
  enum nb_status status = model ? nb_stage_begin(model, &scene->stages[1], &error) : error.status;
  for (int k = 0; k < CYCLES && !status; k++)
    status = nb_cycle(model, &error);
  fuzz_hold(status != NB_NO_MEMORY && (status == NB_OK || error.text[0]), "an aborted run has a message");
  for (size_t i = 0; model && i < model->particles.count && !status; i++)
    fuzz_hold(isfinite(model->particles.position[i].x) && isfinite(model->particles.position[i].y),
              "positions are finite in a run without error");
  nb_model_free(model);
  return !status;
}

size_t fuzz_seal(char *text, size_t size) {
  if (nb_hash(NB_HASH_BEGIN, text, size) >> 40 & 1)
    return size;
  if (size > NB_STATE_END && memcmp(text + size - NB_STATE_END, "end ", 4) == 0)
    size -= NB_STATE_END;
  if (size == 0 || text[size - 1] != '\n')
    text[size++] = '\n';
  return size + (size_t)sprintf(text + size, "end %016llx\n", nb_hash(NB_HASH_BEGIN, text, size));
}

static const char *text_of(const unsigned char *bytes, size_t *size) {
  static char text[LONGEST + FUZZ_END];
  memcpy(text, bytes, *size);
  *size = fuzz_seal(text, *size);
  fuzz_begin(text, *size);
  return text;
}

/* Reads a text and tests the invariants. */
static bool read_text(struct nb_saved *saved, const char *text, size_t size) {
  struct nb_error error = {NB_OK, ""};
  const enum nb_status status = nb_saved_read_text(saved, "fuzz.state", text, size, &error);
  fuzz_hold(status == NB_OK || (status == NB_BAD_USE && strncmp(error.text, "fuzz.state:", 11) == 0),
            "an error of a state has a position");
  if (!status && fuzz_one_of(4))
    hold_saved(saved);
  return !status;
}

/* The page that the state names. */
static const struct continued *page_named(const struct nb_saved *saved) {
  int k = 0;
  return page_of(sscanf(saved->page, "seed%d", &k) == 1 && k > 0 && k < PAGES ? k : 0);
}

static bool read_state(const unsigned char *bytes, size_t size) {
  struct nb_saved saved;
  struct nb_error error = {NB_OK, ""};
  const char *text = text_of(bytes, &size);
  bool valid = read_text(&saved, text, size);
  if (valid) {
    const struct nb_scene *scene = &page_named(&saved)->scene;
    valid = !nb_saved_fits(&saved, scene, "fuzz.state", &error) && go_on(scene, &saved);
  }
  nb_saved_free(&saved);
  return valid;
}

static size_t seed_state(size_t k, char *text) {
  if (k >= PAGES)
    return 0;
  const struct continued *it = page_of((int)k);
  memcpy(text, it->text, it->size);
  return it->size;
}

const struct fuzz_reader fuzz_states = {"states", LONGEST, 10000, read_state, seed_state};

/* ---- checkpoints ---- */

static char folder[NB_STATE_PATH / 2];

static void remove_folder(void) { rmdir(folder); }

static struct nb_options options_of(unsigned long stop_after) {
  if (!folder[0]) {
    const char *above = getenv("TMPDIR");
    snprintf(folder, sizeof folder, "%s/nineball-fuzz-XXXXXX", above ? above : "/tmp");
    fuzz_hold(mkdtemp(folder) != NULL, "a folder can be made");
    atexit(remove_folder);
  }
  return (struct nb_options){.threads = 1,
                             .states = folder,
                             .checkpoint = {.seconds = 1e9, .resume = !stop_after, .stop_after = stop_after, .key = 1}};
}

static void checkpoint_path(char path[NB_STATE_PATH], const struct continued *it) {
  snprintf(path, NB_STATE_PATH, "%s/%s-%016x.checkpoint", folder, it->page.name, 1);
}

static void hold_result(const struct nb_result *result, const struct nb_scene *scene) {
  for (size_t k = 0; k < result->table.row_count; k++)
    fuzz_hold(result->table.stage[k] >= 0 && (size_t)result->table.stage[k] < scene->stage_count,
              "a row belongs to a stage");
  for (size_t k = 0; k < result->snapshot_count; k++)
    fuzz_hold(result->snapshots[k].stage >= 0 && (size_t)result->snapshots[k].stage < scene->stage_count,
              "a snapshot belongs to a stage");
  for (size_t k = 0; k < result->warnings.count; k++)
    fuzz_hold(memchr(result->warnings.list[k].text, 0, sizeof result->warnings.list[k].text) != NULL,
              "a warning is a text");
  fuzz_hold(memchr(result->deep_first, 0, sizeof result->deep_first) != NULL, "the first deep contact is a text");
}

/* Runs the page from the checkpoint to its end. */
static bool resume(const struct continued *it, const char *text, size_t size) {
  const struct nb_options options = options_of(0);
  struct nb_error error = {NB_OK, ""};
  struct nb_result result;
  char path[NB_STATE_PATH];
  checkpoint_path(path, it);
  FILE *file = fopen(path, "wb");
  fuzz_hold(file && fwrite(text, 1, size, file) == size && fclose(file) == 0, "the checkpoint can be written");
  const enum nb_status status = nb_run(&result, &it->whole, &options, NULL, &error);
  fuzz_hold(status != NB_NO_MEMORY && (status == NB_OK || error.text[0]), "an aborted run has a message");
  if (status != NB_BAD_USE)
    hold_result(&result, &it->whole);
  nb_result_free(&result);
  nb_checkpoint_remove(&it->whole, &options, 1);
  return !status;
}

static bool read_checkpoint(const unsigned char *bytes, size_t size) {
  struct nb_saved saved;
  const char *text = text_of(bytes, &size);
  const bool valid = read_text(&saved, text, size) && resume(page_named(&saved), text, size);
  nb_saved_free(&saved);
  return valid;
}

/* Makes two checkpoints of each page, one inside its first stage and one inside its second stage. */
static size_t seed_checkpoint(size_t k, char *text) {
  if (k >= 2 * (size_t)PAGES)
    return 0;
  const struct continued *it = page_of((int)k / 2);
  const struct nb_options options = options_of(k % 2 ? it->whole.stages[0].cycles + 5 : 5);
  struct nb_error error = {NB_OK, ""};
  struct nb_result result;
  char path[NB_STATE_PATH];
  size_t size;
  checkpoint_path(path, it);
  fuzz_hold(nb_run(&result, &it->whole, &options, NULL, &error) == NB_BROKEN, "a run stops");
  nb_result_free(&result);
  char *saved = nb_file_read(path, LONGEST, &size, &error);
  fuzz_hold(saved != NULL, "a run saves a checkpoint");
  memcpy(text, saved, size);
  free(saved), nb_checkpoint_remove(&it->whole, &options, 1);
  return size;
}

const struct fuzz_reader fuzz_checkpoints = {"checkpoints", LONGEST, 3000, read_checkpoint, seed_checkpoint};
