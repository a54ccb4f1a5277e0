/* nineball, the program: the table of contents.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#define _POSIX_C_SOURCE 200809L

#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#include "core/clean.h"
#include "core/guess.h"
#include "options.h"

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
  nb_options_help(out);
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
  enum nb_status status = word && !shown ? nb_options_no_memory() : NB_OK;
  if (shown && nb_clean(shown, strlen(shown), &byte)) {
    fprintf(stderr, "nineball: expected text, found the byte 0x%02X (shown as `?`) in `%s`\n", byte, shown);
    status = NB_BAD_USE;
  }
  free(shown);
  return status;
}

static enum nb_status carry_out(struct nb_call *call, const char *word) {
  const int command = find_command(word);
  if (command < 0 || nb_options_check(call, word))
    return NB_BAD_USE;
  if (commands[command].arguments[0] && call->use.page_count == 0)
    return nb_options_usage("`nineball %s` wants the name of a page", word);
  return commands[command].run(&call->use);
}

int main(int count, char **words) {
  struct nb_call call = {.use.options.threads = 1};
  struct nb_use *use = &call.use;
  use->options.states = getenv("NINEBALL_STATES");
  enum nb_status status = check_word(use->options.states);
  for (int k = 1; k < count && !status; k++)
    status = check_word(words[k]);
  if (status)
    return (int)status;
  use->settings = calloc((size_t)count + 1, sizeof *use->settings);
  if (!use->settings)
    return nb_options_no_memory();
  status = nb_options_read(&call, count, words);
  const char *word = optind < count ? words[optind] : NULL;
  if (!status && call.version) {
    print_version();
  } else if (!status && call.help) {
    if (word && command_of(word) < 0)
      status = print_help_of(word);
    else
      print_help(stdout);
  } else if (!status && !word) {
    print_help(stderr);
    status = NB_BAD_USE;
  } else if (!status) {
    use->pages = words + optind + 1, use->page_count = (size_t)(count - optind - 1);
    status = carry_out(&call, word);
  }
  free(use->settings);
  free(use->follow);
  if (fflush(stdout) != 0 || ferror(stdout)) { /* a full disk, a closed pipe */
    fputs("nineball: the output could not be written\n", stderr);
    return NB_BAD_USE;
  }
  return (int)status;
}
