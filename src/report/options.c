/* The options of the command line, and which command takes which: one table, which parses, helps and refuses.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "options.h"

#include <getopt.h>
#include <stdlib.h>
#include <string.h>

enum { SET = 256, FOLLOW, STAGE, STATES, JOBS, THREADS, ISA, TRUST, TAP, VERSION };

#define CHECKING "run, check, figure, report"
#define ALL CHECKING ", explain, state"

static const struct {
  const char *name, *argument; /* NULL: it takes none */
  int key;                     /* a letter, or one of the above */
  const char *commands;        /* that take it; NULL: it stands alone */
  const char *help;
} options[] = {
    {"output", "FOLDER", 'o', "run, figure, report, state",
     "where files go (default: NAME.out; report: report); of `state` a FILE (NAME-STAGE.state)"},
    {"set", "NAME=VALUE", SET, ALL, "instead of the page's `let` or `sweep` NAME; also normal, shear, step"},
    {"follow", "FILE", FOLLOW, CHECKING ", explain",
     "take a page's contact along a path of your own: columns approach/m and slip/m"},
    {"stage", "NAME", STAGE, "state", "at the end of which stage (default: the last one)"},
    {"states", "FOLDER", STATES, ALL,
     "where the states lie that pages start from (default: $NINEBALL_STATES, or states)"},
    {"jobs", "N", JOBS, CHECKING, "runs of a sweep side by side (default: as many as there are processors)"},
    {"threads", "N", THREADS, ALL, "at most so many (default 1); the results do not depend on it"},
    {"isa", "NAME", ISA, ALL, "plain, avx2 or avx512 (default: the widest); nor on this"},
    {"trust", NULL, TRUST, "figure, report", "draw also where gnuplot cannot be confined, for pages that you trust"},
    {"tap", NULL, TAP, "check", "verdicts in the form that `make check` reads"},
    {"help", NULL, 'h', NULL, "this; all words of pages: nineball --help scene; one of them: nineball --help disc"},
    {"version", NULL, VERSION, NULL, "version and licence"},
};

enum { OPTIONS = sizeof options / sizeof *options };

void nb_options_help(FILE *out) {
  for (int k = 0; k < OPTIONS; k++) {
    const char *argument = options[k].argument, *commands = options[k].commands;
    const bool some = commands && strcmp(commands, ALL) != 0;
    const char letter[] = {'-', (char)options[k].key, ',', ' ', 0};
    char term[32];
    snprintf(term, sizeof term, "--%s%s%s", options[k].name, argument ? " " : "", argument ? argument : "");
    fprintf(out, "  %s%-19s %s%s%s%s\n", options[k].key < SET ? letter : "    ", term, options[k].help,
            some ? " (" : "", some ? commands : "", some ? ")" : "");
  }
}

enum nb_status nb_options_usage(const char *format, const char *word) {
  fputs("nineball: ", stderr);
  fprintf(stderr, format, word);
  fputs("; nineball --help tells\n", stderr);
  return NB_BAD_USE;
}

enum nb_status nb_options_no_memory(void) {
  struct nb_error error;
  nb_error_memory(&error);
  fprintf(stderr, "nineball: %s\n", error.text);
  return error.status;
}

static enum nb_status number_of(int *number, const char *format, const char *text) {
  char *end;
  const long value = strtol(text, &end, 10);
  *number = (int)value;
  return !*end && end != text && value >= 1 && value <= 256 ? NB_OK : nb_options_usage(format, text);
}

static enum nb_status set(struct nb_use *use, const char *setting) {
  size_t count = 0;
  while (use->settings[count])
    count++;
  use->settings[count] = setting;
  return NB_OK;
}

static enum nb_status follow(struct nb_use *use, const char *file) {
  const size_t size = sizeof "follow=" + strlen(file);
  free(use->follow);
  use->follow = malloc(size);
  if (!use->follow)
    return nb_options_no_memory();
  snprintf(use->follow, size, "follow=%s", file);
  return set(use, use->follow);
}

static enum nb_status take(struct nb_call *call, int key, const char *argument) {
  struct nb_use *use = &call->use;
  switch (key) {
  case 'o':
    use->folder = argument;
    break;
  case SET:
    return strchr(argument, '=') ? set(use, argument)
                                 : nb_options_usage("--set wants NAME=VALUE, found `%s`", argument);
  case FOLLOW:
    return follow(use, argument);
  case STAGE:
    use->stage = argument;
    break;
  case STATES:
    use->options.states = argument;
    break;
  case JOBS:
    return number_of(&use->options.jobs, "--jobs wants a number from 1 to 256, found `%s`", argument);
  case THREADS:
    return number_of(&use->options.threads, "--threads wants a number from 1 to 256, found `%s`", argument);
  case ISA:
    use->options.isa = argument;
    break;
  case TAP:
    use->tap = true;
    break;
  case TRUST:
    use->trust = true;
    break;
  case 'h':
    call->help = true;
    break;
  case VERSION:
    call->version = true;
    break;
  }
  return NB_OK;
}

enum nb_status nb_options_read(struct nb_call *call, int count, char **words) {
  struct option all[OPTIONS + 1] = {{NULL, 0, NULL, 0}};
  for (int k = 0; k < OPTIONS; k++)
    all[k] =
        (struct option){options[k].name, options[k].argument ? required_argument : no_argument, NULL, options[k].key};
  enum nb_status status = NB_OK;
  int key;
  while (!status && !call->version && (key = getopt_long(count, words, "o:h", all, NULL)) != -1) {
    for (int k = 0; k < OPTIONS; k++)
      call->given |= options[k].key == key ? 1U << k : 0;
    status = key == '?' ? NB_BAD_USE : take(call, key, optarg);
    if (key == '?') /* getopt has said what it did not like */
      fputs("nineball --help tells\n", stderr);
  }
  return status;
}

/* Whether the word is one of those of a list, which commas part. */
static bool lists(const char *list, const char *word) {
  const size_t length = strlen(word);
  for (; *list; list += strcspn(list, " "), list += strspn(list, " "))
    if (strncmp(list, word, length) == 0 && (list[length] == ',' || !list[length]))
      return true;
  return false;
}

enum nb_status nb_options_check(const struct nb_call *call, const char *command) {
  for (int k = 0; k < OPTIONS; k++)
    if (call->given & 1U << k && options[k].commands && !lists(options[k].commands, command)) {
      fprintf(stderr, "nineball: `nineball %s` does not use --%s, which belongs to: %s\n", command, options[k].name,
              options[k].commands);
      return NB_BAD_USE;
    }
  return NB_OK;
}
