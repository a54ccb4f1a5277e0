/* nineball, the program: the table of contents.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#define _POSIX_C_SOURCE 200809L

#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#include "commands.h"
#include "core/clean.h"
#include "core/guess.h"

static const struct {
  const char *name;
  enum nb_status (*run)(const struct nb_use *use);
  const char *arguments;
  const char *help;
} commands[] = {
    {"run", nb_command_run, "PAGE… [-o FOLDER]", "run pages, print the verdicts, write tables"},
    {"check", nb_command_check, "PAGE… [--tap]", "run pages, print the verdicts, write nothing"},
    {"figure", nb_command_figure, "PAGE… [-o FOLDER]", "run pages, draw their figures with gnuplot"},
    {"report", nb_command_report, "PAGE… [-o FOLDER]", "all of these, and one page about all of them"},
    {"explain", nb_command_explain, "PAGE…", "the plan: what is switched on, what asked for it, step, cost"},
    {"state", nb_command_state, "PAGE [-o FILE]",
     "run a page to the end of a stage, keep its bodies and all else in a file"},
    {"laws", nb_command_laws, "", "the contact laws, with their equations"},
    {"list", nb_command_list, "", "the references, and the quantities that a page can record"},
};
enum { COMMANDS = sizeof commands / sizeof *commands };

static const struct {
  const char *term, *help;
} option_rows[] = {
    {"-o, --output FOLDER", "where files go (default: NAME.out; report: report); of `state` a FILE (NAME-STAGE.state)"},
    {"--set NAME=VALUE", "instead of the page's `let` or `sweep` NAME; also normal, shear, step"},
    {"--follow FILE", "take a page's contact along a path of your own: columns approach/m and slip/m"},
    {"--stage NAME", "of `state`: at the end of which stage (default: the last one)"},
    {"--states FOLDER", "where the states lie that pages start from (default: $NINEBALL_STATES, or states)"},
    {"--jobs N", "runs of a sweep side by side (default: as many as there are processors)"},
    {"--threads N", "at most so many (default 1); the results do not depend on it"},
    {"--isa NAME", "plain, avx2 or avx512 (default: the widest); nor on this"},
    {"--trust", "of `figure` and `report`: draw also where gnuplot cannot be confined, for pages that you trust"},
    {"--tap", "verdicts in the form that `make check` reads"},
    {"-h, --help", "this; all words of pages: nineball --help scene; one of them: nineball --help disc"},
    {"--version", "version and licence"},
};

static void print_help(FILE *out) {
  fputs("nineball: discs and spheres in the plane, by the distinct element method; every page marks itself\n\n"
        "usage: nineball COMMAND …\n\n",
        out);
  for (int k = 0; k < COMMANDS; k++) {
    char call[64];
    snprintf(call, sizeof call, "%s %s", commands[k].name, commands[k].arguments);
    int width = 28; /* columns; a character of several bytes takes one of them */
    for (const char *c = call; *c; c++)
      width += (*c & 0xC0) == 0x80;
    fprintf(out, "  %-*s %s\n", width, call, commands[k].help);
  }
  fputc('\n', out);
  for (size_t k = 0; k < sizeof option_rows / sizeof *option_rows; k++) {
    const bool has_letter = option_rows[k].term[1] != '-';
    fprintf(out, "  %s%-*s %s\n", has_letter ? "" : "    ", has_letter ? 23 : 19, option_rows[k].term,
            option_rows[k].help);
  }
  fputs("\nexit status: 0 passed, 1 a check failed, 2 bad use or a mistake in a page, 3 run aborted, 4 out of "
        "memory\n",
        out);
}

/* `nineball --help WORD`. */
static enum nb_status print_help_of(const char *word) {
  char near[2 * NB_NAME_SIZE];
  const bool markdown = strcmp(word, "language-md") == 0;
  if (markdown || strcmp(word, "scene") == 0) {
    nb_manual(stdout, markdown);
  } else if (!nb_manual_word(stdout, word, near)) {
    fprintf(
        stderr,
        "nineball: no page knows the word `%s`%s%s%s; nineball --help scene lists all words, nineball laws the laws\n",
        word, near[0] ? "; did you mean `" : "", near, near[0] ? "`?" : "");
    return NB_BAD_USE;
  }
  return NB_OK;
}

static void print_version(void) {
  puts("nineball " NB_VERSION "\n"
       "Copyright (C) 2026 the nineball authors.\n"
       "GPL-3.0-or-later: free software, without any warranty.");
}

static enum nb_status usage(const char *format, const char *word) {
  fprintf(stderr, "nineball: ");
  fprintf(stderr, format, word);
  fputs("; nineball --help tells\n", stderr);
  return NB_BAD_USE;
}

static enum nb_status no_memory(void) {
  struct nb_error error;
  nb_error_memory(&error);
  fprintf(stderr, "nineball: %s\n", error.text);
  return error.status;
}

enum {
  OPTION_SET = 256,
  OPTION_FOLLOW,
  OPTION_JOBS,
  OPTION_STAGE,
  OPTION_STATES,
  OPTION_THREADS,
  OPTION_ISA,
  OPTION_TAP,
  OPTION_TRUST,
  OPTION_VERSION
};

static const struct option options[] = {
    {"output", required_argument, NULL, 'o'},
    {"set", required_argument, NULL, OPTION_SET},
    {"follow", required_argument, NULL, OPTION_FOLLOW},
    {"stage", required_argument, NULL, OPTION_STAGE},
    {"states", required_argument, NULL, OPTION_STATES},
    {"jobs", required_argument, NULL, OPTION_JOBS},
    {"threads", required_argument, NULL, OPTION_THREADS},
    {"isa", required_argument, NULL, OPTION_ISA},
    {"tap", no_argument, NULL, OPTION_TAP},
    {"trust", no_argument, NULL, OPTION_TRUST},
    {"help", no_argument, NULL, 'h'},
    {"version", no_argument, NULL, OPTION_VERSION},
    {NULL, 0, NULL, 0},
};

static bool number_of(int *number, const char *text) {
  char *end;
  const long value = strtol(text, &end, 10);
  *number = (int)value;
  return !*end && end != text && value >= 1 && value <= 256;
}

/* NB_OK to go on; anything else is the end, `done` when it is a good one. */
static enum nb_status read_options(struct nb_use *use, int count, char **words, bool *done) {
  int option;
  size_t settings = 0;
  while ((option = getopt_long(count, words, "o:h", options, NULL)) != -1)
    switch (option) {
    case 'o':
      use->folder = optarg;
      break;
    case OPTION_SET:
      if (!strchr(optarg, '='))
        return usage("--set wants NAME=VALUE, found `%s`", optarg);
      use->settings[settings++] = optarg;
      break;
    case OPTION_FOLLOW: {
      const size_t size = sizeof "follow=" + strlen(optarg);
      free(use->follow);
      use->follow = malloc(size);
      if (!use->follow)
        return no_memory();
      snprintf(use->follow, size, "follow=%s", optarg);
      use->settings[settings++] = use->follow;
      break;
    }
    case OPTION_STAGE:
      use->stage = optarg;
      break;
    case OPTION_STATES:
      use->options.states = optarg;
      break;
    case OPTION_JOBS:
      if (!number_of(&use->options.jobs, optarg))
        return usage("--jobs wants a number from 1 to 256, found `%s`", optarg);
      break;
    case OPTION_THREADS:
      if (!number_of(&use->options.threads, optarg))
        return usage("--threads wants a number from 1 to 256, found `%s`", optarg);
      break;
    case OPTION_ISA:
      use->options.isa = optarg;
      break;
    case OPTION_TAP:
      use->tap = true;
      break;
    case OPTION_TRUST:
      use->trust = true;
      break;
    case 'h':
      *done = true;
      break;
    case OPTION_VERSION:
      print_version();
      *done = true;
      return NB_FAILED;
    default: /* getopt has said what it did not like */
      fputs("nineball --help tells\n", stderr);
      return NB_BAD_USE;
    }
  return NB_OK;
}

static int command_of(const char *word) {
  for (int k = 0; k < COMMANDS; k++)
    if (strcmp(commands[k].name, word) == 0)
      return k;
  return -1;
}

static int find_command(const char *word) {
  const int command = command_of(word);
  if (command >= 0)
    return command;
  char hint[NB_HINT_SIZE];
  struct nb_guess guess = nb_guess_begin(word);
  for (int k = 0; k < COMMANDS; k++)
    nb_guess_offer(&guess, commands[k].name);
  const char *near = nb_guess_hint(&guess, hint);
  fprintf(stderr, "nineball: there is no command `%s`%s%s; nineball --help tells\n", word, near ? "; " : "",
          near ? near : "");
  return -1;
}

/* Names and values go to the terminal and into files: none may hold what a terminal would obey. */
static enum nb_status check_word(const char *word) {
  char *shown = word ? strdup(word) : NULL;
  unsigned byte;
  enum nb_status status = word && !shown ? no_memory() : NB_OK;
  if (shown && nb_clean(shown, strlen(shown), &byte)) {
    fprintf(stderr, "nineball: expected text, found the byte 0x%02X (shown as `?`) in `%s`\n", byte, shown);
    status = NB_BAD_USE;
  }
  free(shown);
  return status;
}

int main(int count, char **words) {
  struct nb_use use = {.options = {.threads = 1}};
  use.options.states = getenv("NINEBALL_STATES");
  enum nb_status status = check_word(use.options.states);
  for (int k = 1; k < count && !status; k++)
    status = check_word(words[k]);
  if (status)
    return (int)status;
  use.settings = calloc((size_t)count + 1, sizeof *use.settings);
  if (!use.settings)
    return no_memory();
  bool done = false;
  status = read_options(&use, count, words, &done);
  if (!status && done) {
    if (optind < count && command_of(words[optind]) < 0)
      status = print_help_of(words[optind]);
    else
      print_help(stdout);
  } else if (!status && optind >= count) {
    print_help(stderr);
    status = NB_BAD_USE;
  } else if (!status) {
    const int command = find_command(words[optind]);
    use.pages = words + optind + 1, use.page_count = (size_t)(count - optind - 1);
    status = command < 0 ? NB_BAD_USE
             : commands[command].arguments[0] && use.page_count == 0
                 ? usage("`nineball %s` wants the name of a page", words[optind])
                 : commands[command].run(&use);
  }
  free(use.settings);
  free(use.follow);
  if (fflush(stdout) != 0 || ferror(stdout)) { /* a full disk, a closed pipe */
    fputs("nineball: the output could not be written\n", stderr);
    return NB_BAD_USE;
  }
  return done && status == NB_FAILED ? NB_OK : (int)status;
}
