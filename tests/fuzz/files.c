/* Tests the readers of saved states and of lists of columns with random changes. A changed state gets its new checksum,
 * so its records are read. What is read must be complete, and an error must have a position. If the page accepts a
 * state, it runs for a few cycles from it: for any numbers the run must end with a status.
 *
 *   tests/fuzz/files [STATE]   changes states of small pages some thousand times, or runs this state; TAP
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#define _POSIX_C_SOURCE 200809L

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../../src/core/model.h"
#include "../../src/input/columns.h"
#include "../../src/run/plan.h"
#include "../../src/run/restart.h"
#include "../../src/run/state.h"
#include "fuzz.h"

enum { LONGEST = 64 << 10, STATES = 20000, LISTS = 3000, CHANGES_MAX = 2, CYCLES = 3, END_SIZE = 21 };

/* Half of the changes are of numbers. Returns the new size. */
static size_t change(unsigned char *text, size_t size, size_t most, unsigned long long *chance) {
  for (unsigned long long more = 1 + fuzz_chance(chance) % CHANGES_MAX; more > 0; more--)
    size = (fuzz_chance(chance) % 2 ? fuzz_change : fuzz_change_number)(text, size, most, chance);
  return size;
}

/* ---- states ---- */

/* The statements before and after the state. Together the pages have every record, and every kind of history. */
static const struct {
  const char *first, *second;
} pages[] = {
    {"units none\nlet a = 2\nmaterial m density 3 young 5000 poisson 0.2 friction 0.3\nmaterial n density $a kn 1e4\n"
     "pair m m friction 0.2\nnormal hertz_increment\nshear mindlin_deresiewicz memory 3\nwall w -5 0 to 5 0 m\n"
     "lattice spheres 2 by 2 m radius 1 spacing 1.99 from 0 0.995\nsphere 9 1 radius 1 m fixed\ngravity 1 -1\n"
     "step 0.001\nstage a\ncycles 20\n",
     "stage b\nremove sphere 2\nmaterial m friction 0.1\nwall w velocity 0 0.1\ncycles 9\n"},
    {"units none\nmaterial m density 3 kn 4000 ks 2000 friction 0.3\nshear linear\nlattice discs 3 by 3 m radius 1 "
     "spacing 1.99 from -2 -2\nboundary circle 0 0 radius 2.5\nstep 0.001\nstage a\nboundary strain 0.1 -0.1\n"
     "affine strain 1e-4 per cycle 0 per cycle\nrotation off\ngravity centripetal 2 about 1 0\ncycles 20\n",
     "stage b\nrotation on\ncycles 9\n"},
    {"units none\nmaterial m density 3 young 5000 poisson 0.2 friction 0.3\nnormal hertz\nshear randall\n"
     "lattice spheres 3 by 3 m radius 1 spacing 1.99 from 0.1 0.2\ncell 0 0 to 5.97 5.97\nstep 0.001\nstage a\n"
     "cell strain 0.1 -0.1 c12 0.3 c21 0\ncycles 20\n",
     "stage b\ncycles 9\n"},
};
enum { PAGES = sizeof pages / sizeof *pages };

struct seed {
  struct nb_page page;
  struct nb_scene scene; /* of both parts; it continues from the state */
  char *text;
  size_t size;
};

static void read_page(struct nb_page *page, struct nb_scene *scene, const char *first, const char *second) {
  struct nb_mistakes mistakes = {0};
  char text[2000];
  const int n = snprintf(text, sizeof text, "# Seed\n\n```scene\n%s%s```\n", first, second);
  if (nb_page_read_bytes(page, "seed.md", text, (size_t)n, &mistakes) ||
      nb_scene_read(scene, page, 0, NULL, &mistakes)) {
    printf("%sBail out! a page of this test is wrong\n", mistakes.text);
    exit(1);
  }
}

static void make_seed(struct seed *seed, const char *first, const char *second) {
  struct nb_page page;
  struct nb_scene scene;
  struct nb_saved saved;
  struct nb_error error = {NB_OK, ""};
  read_page(&page, &scene, first, "");
  const enum nb_status status = nb_run_to(&saved, &scene, NULL, NULL, &error);
  seed->text = status ? NULL : nb_saved_text(&saved, &seed->size);
  if (!seed->text || seed->size > LONGEST / 2) {
    printf("Bail out! no state: %s\n", error.text);
    exit(1);
  }
  nb_saved_free(&saved), nb_scene_free(&scene), nb_page_free(&page);
  read_page(&seed->page, &seed->scene, first, second);
  seed->scene.start.stages = 1;
}

static void free_seed(struct seed *seed) {
  seed->scene.start.stages = 0;
  nb_scene_free(&seed->scene), nb_page_free(&seed->page), free(seed->text);
}

/* All indices are in range, and the state is the same after writing and reading. */
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

/* Runs the page from the state. Returns whether all cycles were run. */
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

static bool read_state(const struct seed *seed, const char *text, size_t size) {
  struct nb_saved saved;
  struct nb_error error = {NB_OK, ""};
  fuzz_begin(text, size);
  const enum nb_status status = nb_saved_read_text(&saved, "fuzz.state", text, size, &error);
  fuzz_hold(status == NB_OK || (status == NB_BAD_USE && strncmp(error.text, "fuzz.state:", 11) == 0),
            "an error of a state has a position");
  if (!status)
    hold_saved(&saved);
  const bool ran = !status && !nb_saved_fits(&saved, &seed->scene, "fuzz.state", &error) && go_on(&seed->scene, &saved);
  nb_saved_free(&saved);
  return ran;
}

/* Replaces or adds the last line with the right checksum. Returns the new size. */
static size_t seal(char *text, size_t size) {
  if (size > END_SIZE && memcmp(text + size - END_SIZE, "end ", 4) == 0)
    size -= END_SIZE;
  if (size == 0 || text[size - 1] != '\n')
    text[size++] = '\n';
  return size + (size_t)sprintf(text + size, "end %016llx\n", nb_hash(NB_HASH_BEGIN, text, size));
}

static void change_states(void) {
  static char text[LONGEST + END_SIZE + 2];
  struct seed seeds[PAGES];
  unsigned long long chance = 1;
  int ran = 0;
  for (int k = 0; k < PAGES; k++) {
    make_seed(&seeds[k], pages[k].first, pages[k].second);
    fuzz_hold(read_state(&seeds[k], seeds[k].text, seeds[k].size), "a page continues from its state");
  }
  for (int n = 0; n < STATES; n++) {
    const struct seed *seed = &seeds[fuzz_chance(&chance) % PAGES];
    size_t size = seed->size;
    memcpy(text, seed->text, size);
    size = change((unsigned char *)text, size, LONGEST, &chance);
    ran += read_state(seed, text, seal(text, size));
  }
  printf("ok 1 - %d changed states\n# %d of them ran\n", STATES, ran);
  for (int k = 0; k < PAGES; k++)
    free_seed(&seeds[k]);
}

/* ---- lists ---- */

static const struct {
  const char *text;
  bool unitless;
} lists[] = {
    {"# made by hand\nx/mm\ty/mm\tradius/mm\n0\t0\t10\n20\t0\t10\n\n1e1\t17.3\t9.99\n-40\t0.5\t1e-3\n", false},
    {"radius/um z/um y/m x/m\n10 7 0 0\n  20  7 0.5 -0.25\n30 7 1e-3 2\n", false},
    {"x/-\ty/-\tradius/-\n0\t0\t1\n2\t0\t1\n", true},
};

static bool read_list(const char *text, size_t size, const char *path, bool unitless) {
  static const struct nb_wanted_column wanted[] = {{"x", NULL, false}, {"y", "z", false}, {"radius", NULL, true}};
  struct nb_mistakes mistakes = {0};
  double *lengths;
  size_t rows;
  FILE *file = fopen(path, "wb");
  fuzz_hold(file && fwrite(text, 1, size, file) == size && fclose(file) == 0, "the list can be written");
  fuzz_begin(text, size);
  const bool whole = nb_columns_read(&lengths, &rows, path, wanted, 3, unitless, &mistakes);
  fuzz_hold_mistakes(&mistakes, whole ? NB_OK : NB_BAD_USE);
  fuzz_hold(!whole || rows > 0, "a list has rows");
  for (size_t k = 0; whole && k < 3 * rows; k++)
    fuzz_hold(isfinite(lengths[k]) && (k % 3 != 2 || lengths[k] > 0), "lengths are finite, and radii above 0");
  free(lengths);
  nb_mistakes_free(&mistakes);
  return whole;
}

static void change_lists(void) {
  static char text[LONGEST];
  const char *folder = getenv("TMPDIR");
  char path[NB_PATH_SIZE];
  unsigned long long chance = 1;
  int whole = 0;
  snprintf(path, sizeof path, "%s/nineball-list-XXXXXX", folder ? folder : "/tmp");
  const int file = mkstemp(path);
  fuzz_hold(file >= 0 && close(file) == 0, "a temporary file can be made");
  for (size_t k = 0; k < sizeof lists / sizeof *lists; k++)
    fuzz_hold(read_list(lists[k].text, strlen(lists[k].text), path, lists[k].unitless), "a list is read");
  for (int n = 0; n < LISTS; n++) {
    const size_t from = (size_t)(fuzz_chance(&chance) % (sizeof lists / sizeof *lists));
    size_t size = strlen(lists[from].text);
    memcpy(text, lists[from].text, size);
    size = change((unsigned char *)text, size, sizeof text, &chance);
    whole += read_list(text, size, path, lists[from].unitless);
  }
  printf("ok 2 - %d changed lists\n# %d of them were valid\n1..2\n", LISTS, whole);
  remove(path);
}

/* Reads the file with each of the pages. */
static void replay(const char *path) {
  struct nb_error error = {NB_OK, ""};
  size_t size = 0;
  char *text = nb_file_read(path, NB_FILE_MAX, &size, &error);
  for (int k = 0; text && k < PAGES; k++) {
    struct seed seed;
    make_seed(&seed, pages[k].first, pages[k].second);
    read_state(&seed, text, size);
    free_seed(&seed);
  }
  printf("%sok 1 - %s %s\n1..1\n", text ? "" : "not ", path, error.text);
  free(text);
}

int main(int count, char **words) {
  if (count > 1) {
    replay(words[1]);
    return 0;
  }
  change_states();
  change_lists();
  return 0;
}
