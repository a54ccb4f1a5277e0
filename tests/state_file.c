/* The file of a saved state: every error in the file is found, and a file is complete or absent.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../src/run/output_file.h"
#include "../src/run/state.h"
#include "state_text.h"
#include "suites.h"

static char *small(size_t *size) { return state_of(state_plain, size); }

static bool reads(const char *text, size_t size, struct nb_error *error) {
  struct nb_saved saved;
  const bool read = nb_saved_read_text(&saved, "a.state", text, size, error) == NB_OK;
  nb_saved_free(&saved);
  return read;
}

static void every_bit(void) {
  struct nb_error error;
  size_t size, unseen = 0;
  char *text = small(&size);
  CU_ASSERT(reads(text, size, &error));
  for (size_t bit = 0; bit < 8 * size; bit++) {
    text[bit / 8] ^= (char)(1 << bit % 8);
    unseen += reads(text, size, &error) || strncmp(error.text, "a.state:", 8) != 0;
    text[bit / 8] ^= (char)(1 << bit % 8);
  }
  CU_ASSERT_EQUAL(unseen, 0);
  free(text);
}

static void every_length(void) {
  struct nb_error error;
  size_t size, unseen = 0;
  char *text = small(&size);
  for (size_t length = 0; length < size; length++) {
    char *cut = malloc(length + 1); /* so that a sanitizer detects reads past its end */
    memcpy(cut, text, length);
    unseen += reads(cut, length, &error) || strncmp(error.text, "a.state:", 8) != 0 ||
              !strstr(error.text, length < 17 ? "this is not a saved state" : "the file is cut off");
    free(cut);
  }
  CU_ASSERT_EQUAL(unseen, 0);
  char last_line[32]; /* where the checksum is missing or wrong */
  size_t lines = 0;
  for (size_t k = 0; k < size; k++)
    lines += text[k] == '\n';
  snprintf(last_line, sizeof last_line, "a.state:%zu:1: ", lines);
  CU_ASSERT(!reads(text, size - 1, &error) && strncmp(error.text, last_line, strlen(last_line)) == 0);
  text[size - 2] ^= 1;
  CU_ASSERT(!reads(text, size, &error) && strncmp(error.text, last_line, strlen(last_line)) == 0);
  text[size - 2] ^= 1;
  char *longer = malloc(size + 1);
  memcpy(longer, text, size), longer[size] = '\n';
  CU_ASSERT(!reads(longer, size + 1, &error));
  free(longer), free(text);
}

/* A byte that is 0 is refused, although the checksum is right. The setting is on line 5. */
static void a_byte_that_is_0(void) {
  struct nb_error error;
  size_t size, sealed_size;
  char *text = small(&size);
  *strstr(text, "=0.1 m/s") = 0;
  char *sealed = state_sealed(text, size - NB_STATE_END, &sealed_size);
  CU_ASSERT(!reads(sealed, sealed_size, &error));
  CU_ASSERT_STRING_EQUAL(error.text, "a.state:5:1: expected text, found a byte that is 0");
  free(sealed), free(text);
}

struct mistake {
  const char *from, *to, *given; /* given: the message, or the end of it */
};

static void mistakes(const char *page, const struct mistake rows[], size_t count) {
  for (size_t k = 0; k < count; k++) {
    struct nb_error error = {NB_OK, ""};
    size_t size;
    char *text = state_changed(page, rows[k].from, rows[k].to, &size);
    CU_ASSERT(!reads(text, size, &error));
    const size_t said = strlen(error.text), given = strlen(rows[k].given);
    const char *const end = error.text + (said > given ? said - given : 0);
    if (strcmp(end, rows[k].given) != 0)
      printf("# said: %s\n# wanted: %s\n", error.text, rows[k].given);
    CU_ASSERT_STRING_EQUAL(end, rows[k].given);
    free(text);
  }
}
#define MISTAKES(page, rows) mistakes(page, rows, sizeof rows / sizeof *rows)

static void every_mistake(void) {
  static const struct mistake rows[] = {
      {"nineball state 1", "nineball state 2",
       "a.state:1:1: expected `nineball state 1`: this is not a saved state, or one of another version"},
      {" 0x1p+0 0x0p+0 ", " 0x1p+1 0x0p+0 ", "expected a vector of length 1, found `0x0p+0`"}, /* of the wall */
      {"units none", "unit none", "a.state:9:1: expected a record of this version, found `unit`"},
      {"units none", "units \033[2J\x80", "a.state:9:7: expected `si` or `none`, found `?[2J?`"},
      {"units none", "units 1234567890123456789012345678901234567890123456789012345678901",
       "found `123456789012345678901234567890123456789012345678901234567890`"}, /* at most 60 bytes */
      {"units none", "units ft", "a.state:9:7: expected `si` or `none`, found `ft`"},
      {"units none", "units none x", "a.state:9:12: expected the end of the line, found `x`"},
      {"gravity ", "gravity x ", "a.state:10:9: expected a number, found `x`"},
      {"gravity ", "gravity inf ", "a.state:10:9: expected a finite number, found `inf`"},
      {"law normal hertz_increment", "law normal glue", "a.state:11:12: expected a law of this program, found `glue`"},
      {"cycle 20 20", "cycle 20 21", "a.state:7:10: expected a whole number from 1 to 20, found `21`"},
      {"cycle 20 20", "cycle 20", "a.state:7:9: expected a whole number, found the end of the line"},
      {"pair m m", "pair m n", "a.state:14:8: expected the name of a material that stands above, found `n`"},
      {"body 2", "body 3", "a.state:16:6: expected a whole number from 2 to 2, found `3`"},
      {"sphere m free", "cube m free", "a.state:15:8: expected `disc` or `sphere`, found `cube`"},
      {"sphere m free", "sphere m loose", "a.state:15:17: expected `free`, `fixed` or `gone`, found `loose`"},
      {"free 0x1p+0", "free 0x0p+0", "a.state:15:22: expected a number above 0, found `0x0p+0`"},
      {"fields overlap", "fields depth", "a.state:18:8: expected `overlap`, found `depth`"},
      {"wall w heard", "wall v heard", "expected the name of a wall that stands above, found `v`"},
      {"body 2 heard", "body 1 heard", "expected a whole number from 2 to 2, found `1`"},
      {"heard", "seen", "expected `heard` or `muted`, found `seen`"},
      {"fields", "shear 0x1p+0\nfields", "a.state:18:1: expected such a record once, below its contact, found `shear`"},
      {"hash 0", "hash ", "expected 16 hexadecimal digits, found `000000000000000`"},
      {"units none\n", "", "expected a record `units` above, found `end`"},
      {"units none\n", "units none\nunits none\n", "expected such a record once, found `units`"},
      {"law shear mindlin 0\n", "", "expected such a record once, below its contact, found `shear`"},
      {"law shear mindlin 0\n", "law shear mindlin 0\nlaw shear mindlin 0\n",
       "a.state:13:5: expected such a record once, found `shear`"},
      {"material m 0x1.8p+1", "material m -0x1.8p+1", "a.state:13:12: expected 0 or more, found `-0x1.8p+1`"},
      {"material m", "material m 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 - 0x0p+0\nmaterial m",
       "expected a number, found `-`"},
      {"body 1", "material m 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0\nbody 1",
       "expected the name of a material that no record above has, found `m`"},
      {"fields overlap", "fields overlap overlap", "expected `closing`, found `overlap`"},
      {" drag\n", "\n", "expected `drag`, found the end of the line"},
      {"fields overlap closing", "setting a=1\nfields overlap", "a.state:19:16: expected `closing`, found `slip`"},
      {"\nnormal 0x", "\nnormal 0x0p+0 0x", "expected a contact history that the law can have, found `normal`"},
      {"setting v=0.1 m/s", "setting", "expected a text shorter than 128 bytes, found the end of the line"},
      {"setting v=0.1 m/s",
       "setting 7777777777777777777777777777777777777777777777777777777777777777"
       "7777777777777777777777777777777777777777777777777777777777777777",
       "expected a text shorter than 128 bytes, found `777777777777777777777777777777777777777777777777777777777777`"},
      {"hash 0000000000000000", "hash 000000000000000g", "expected 16 hexadecimal digits, found `000000000000000g`"},
      {"law shear mindlin 0", "law shear glue 0", "expected a law of this program, found `glue`"},
      {"law shear mindlin 0", "law shear hertz 0", "expected a law of this program, found `hertz`"},
      {"material m ", "material 3m ", "expected the name of a material, found `3m`"},
      {"wall w m ", "wall w! m ", "expected the name of a wall, found `w!`"},
      {"body 1",
       "material a 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0\n"
       "material a 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0\nbody 1",
       "expected the name of a material that no record above has, found `a`"},
      {"law shear mindlin 0", "law shear mindlin 257", "expected a whole number from 0 to 256, found `257`"},
      {"body 1", "members 1\nbody 1", "expected a record `body 1` above, found `1`"},
      {"\nfields ", "\nsetting ", "expected a record `fields` before the first contact, found `contact`"},
      /* fields that are missing */
      {"\nprogram ", "\nprogram\nsetting ",
       "a.state:2:8: expected the version of the program, found the end of the line"},
      {"\npage ", "\npage\nsetting ", "a.state:3:5: expected a text shorter than 64 bytes, found the end of the line"},
      {"\nhash ", "\nhash\nsetting ", "a.state:4:5: expected 16 hexadecimal digits, found the end of the line"},
      {"\nstage ", "\nstage\nsetting ", "a.state:6:6: expected the name of a stage, found the end of the line"},
      {"units none", "\nunits none", "a.state:9:1: expected a record, found the end of the line"},
      {"law normal ", "law normal\nsetting ", "a.state:11:11: expected the name of a law, found the end of the line"},
      {"0x1.999999999999ap-3\n", "0x1p+0\n", "expected a number from 0 to 0.5, found `0x1p+0`"}, /* Poisson's ratio */
      {"\nfields", "\nstore\nfields", "a.state:18:6: expected the name of a variable, found the end of the line"},
      {"\nfields", "\nstore a 1 x\nfields", "a.state:18:11: expected a number, found `x`"},
  };
  static const struct mistake of_rings[] = {
      {"inward 0x1p+1 ", "inward ", "a.state:13:21: expected a number, found the end of the line"},
      {"rotation off", "rotation slow", "a.state:14:10: expected `off` or `on`, found `slow`"},
      {"carrier boundary", "carrier wind",
       "a.state:17:9: expected `nothing`, `continuum`, `boundary`, `cell` or `box`, found `wind`"},
      {"continuum apart", "continuum near",
       "a.state:16:19: expected `apart`, `literal` or `literal-twice`, found `near`"},
      {" cycle 0x", " day 0x", "expected `time` or `cycle`, found `day`"},
      {"carried 9", "carried 8", "expected a whole number from 9 to 9, found `8`"},
      {"boundary held", "boundary broken", "expected `held` or `loose`, found `broken`"},
      {"held unpressed", "held tight", "expected `pressed` or `unpressed`, found `tight`"},
      {"members 9", "members 10", "expected a whole number from 1 to 9, found `10`"},
      {"\nmembers 9 ", "\nmembers ",
       "expected particle 9 to follow a cell or a boundary that the state has, found `end`"},
      {"carried 9 ", "setting 9 ", "expected a record `carried` for each body, or for none, found `end`"},
      {"\ncarrier cont",
       "\ncarrier boundary apart 0x0p+0 0x0p+0 0x0p+0 0x0p+0 time 0x0p+0 0x0p+0 0x0p+0 0x0p+0\ncarrier cont",
       "expected such a record once for each source of imposed motion, found `boundary`"},
      {"\nmembers 9 7 1 3\n", "\nmembers 9 7 1\n",
       "expected particle 3 to follow a cell or a boundary that the state has, found `end`"},
      {"members 9 7", "members 9 9", "expected each body once, found `9`"},
      {"boundary held", "carried 10 nothing 0x0p+0 0x0p+0\nboundary held",
       "expected such a record once for each body above, found `carried`"},
  };
  static const struct mistake of_cells[] = {
      {"\ncentre", " 0x0p+0\ncentre", "expected the end of the line, found `0x0p+0`"},
      {"\ncell ", "\ncell 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0\ncell ",
       "expected a cell with an area above 0, found `0x0p+0`"},
      {"\ncell ", "\ncell 0x1p+0 0x1p+1 0x1p+1 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0\ncell ",
       "expected a cell with an area above 0, found `0x1p+0`"},
      {"\ncell ", "\ncell x ", "a.state:13:6: expected a number, found `x`"},
  };
  /* The history of the exact law begins with its number of pieces, here 2. */
  static const struct mistake of_rows[] = {
      {"\nshear 0x1p+1 ", "\nshear 0x1p+9 ", "expected a contact history that the law can have, found `shear`"},
      {"\nshear 0x1p+1 ", "\nshear 0x1p+40 ", "expected a contact history that the law can have, found `shear`"},
      {"\nshear 0x1p+1 ", "\nshear -0x1p+0 ", "expected a contact history that the law can have, found `shear`"},
      {"\nshear 0x1p+1 ", "\nshear 0x1.8p+0 ", "expected a contact history that the law can have, found `shear`"},
      {"\nshear 0x1p+1 ", "\nshear 0x1p+1 0x1p+0 ", "expected a contact history that the law can have, found `shear`"},
  };
  static const char exact[] = "units none\nmaterial m density 3 friction 0.3 young 5000 poisson 0.2\nnormal "
                              "hertz\nshear mindlin_deresiewicz memory 3\n"
                              "wall w -5 0 to 5 0 m\nlattice spheres 2 by 1 m radius 1 spacing 1.99 from 0 "
                              "0.995\ngravity 1 -1\nstep 0.001\nstage "
                              "a\ncycles 20\n";
  MISTAKES(exact, of_rows);
  MISTAKES(state_plain, rows);
  MISTAKES(state_ring, of_rings);
  MISTAKES(state_cell, of_cells);
}

static bool holds(const char *path, const char *text) {
  char bytes[64] = "";
  FILE *file = fopen(path, "r");
  const bool same = file && fgets(bytes, sizeof bytes, file) && strcmp(bytes, text) == 0;
  if (file)
    fclose(file);
  return same;
}

/* The old file stays until the new one is complete, even if the disk is full or the process is killed while it
 * writes. */
static void complete_or_absent(void) {
  char folder[] = "/tmp/nineball-state-XXXXXX", path[64], command[64];
  struct nb_saved saved;
  struct nb_error error;
  size_t size;
  char *text = small(&size);
  CU_ASSERT_PTR_NOT_NULL_FATAL(mkdtemp(folder));
  CU_ASSERT_EQUAL_FATAL(nb_saved_read_text(&saved, "a.state", text, size, &error), NB_OK);
  snprintf(path, sizeof path, "%s/a.state", folder);
  FILE *old = fopen(path, "w");
  fputs("old\n", old);
  fclose(old);
  for (int kill = 0; kill < 2; kill++) {
    int status;
    fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
      if (kill) {
        struct nb_save file;
        if (!nb_save_begin(&file, path, &error) && fwrite(text, 1, size / 2, file.file) && !fflush(file.file))
          raise(SIGKILL);
        _exit(9);
      }
      signal(SIGXFSZ, SIG_IGN);
      setrlimit(RLIMIT_FSIZE, &(struct rlimit){size / 2, size / 2});
      _exit(nb_saved_write(&saved, path, &error) == NB_BAD_USE && strstr(error.text, "cannot write") ? 5 : 9);
    }
    waitpid(child, &status, 0);
    CU_ASSERT(kill ? WIFSIGNALED(status) : WIFEXITED(status) && WEXITSTATUS(status) == 5);
    CU_ASSERT(holds(path, "old\n"));
  }
  CU_ASSERT_EQUAL(nb_saved_write(&saved, path, &error), NB_OK);
  CU_ASSERT(holds(path, "nineball state 1\n"));
  CU_ASSERT_EQUAL(nb_saved_write(&saved, "/dev/full/a.state", &error), NB_BAD_USE);
  nb_saved_free(&saved);
  CU_ASSERT_EQUAL(nb_saved_read(&saved, folder, &error), NB_BAD_USE);
  CU_ASSERT_EQUAL(nb_saved_read(&saved, "/nowhere/a.state", &error), NB_BAD_USE);
  CU_ASSERT_STRING_EQUAL(error.text, "/nowhere/a.state: cannot be read: No such file or directory");
  CU_ASSERT_EQUAL(nb_folder_create("", &error), NB_BAD_USE);
  snprintf(command, sizeof command, "rm -r %s", folder);
  CU_ASSERT_EQUAL(system(command), 0);
  free(text);
}

/* 127 bytes of NAME=VALUE are kept, one more is refused. */
static void settings_are_not_cut(void) {
  struct nb_saved saved = {0};
  struct nb_error error = {NB_OK, ""};
  char text[129];
  memset(text, 'a', sizeof text), text[1] = '=', text[128] = 0;
  CU_ASSERT_EQUAL(nb_saved_setting(&saved, text + 1, &error), NB_OK);
  CU_ASSERT(saved.setting_count == 1 && strcmp(saved.settings[0], text + 1) == 0);
  CU_ASSERT_EQUAL(nb_saved_setting(&saved, text, &error), NB_BAD_USE);
  CU_ASSERT(saved.setting_count == 1 &&
            strstr(error.text, "a state keeps settings shorter than 128 bytes, found `a=aa"));
  nb_saved_free(&saved);
}

void suite_state_file(void) {
  CU_pSuite suite = CU_add_suite("state_file", NULL, NULL);
  CU_add_test(suite, "every flipped bit is found", every_bit);
  CU_add_test(suite, "a file that is cut off anywhere is found", every_length);
  CU_ADD_TEST(suite, a_byte_that_is_0);
  CU_add_test(suite, "every error is reported with file, line and column", every_mistake);
  CU_add_test(suite, "settings are kept whole, or refused", settings_are_not_cut);
  CU_add_test(suite, "a file is complete or absent", complete_or_absent);
}
