/* nineball, the program: the tables of its commands and options.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <fcntl.h>
#include <getopt.h>
#include <math.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "commands.h"
#include "core/clean.h"
#include "core/guess.h"

static const struct {
  const char *name;
  enum nb_status (*run)(const struct nb_call *call);
  const char *arguments;
  const char *help;
} commands[] = {
    {"run", nb_command_run, "PAGE… [-o FOLDER]", "run pages, print the verdicts, write tables"},
    {"check", nb_command_check, "PAGE… [--tap]", "run pages, print the verdicts"},
    {"figure", nb_command_figure, "PAGE… [-o FOLDER]", "run pages, draw their figures with gnuplot"},
    {"report", nb_command_report, "PAGE… [-o FOLDER]",
     "run pages, draw figures, write a site with texts, results and figures"},
    {"explain", nb_command_explain, "PAGE…",
     "print the plan: passes and hooks, the lines that request them, the step, the cost"},
    {"advise", nb_command_advise, "PAGE --within TOLERANCE",
     "find the cheapest step and laws whose error in a quantity is within a tolerance, by running the page; or --all "
     "[PAGE… or FOLDER…]"},
    {"state", nb_command_state, "PAGE [-o FILE]", "run a page to the end of a stage, save its state in a file"},
    {"migrate", nb_command_migrate, "PAGE… [--in-place]", "rewrite pages of version 0.3 in the words of this one"},
    {"laws", nb_command_laws, "", "list the contact laws: equations, material parameters"},
    {"list", nb_command_list, "", "list the references"},
};
enum { COMMANDS = sizeof commands / sizeof *commands };

/* Lists of the commands that take an option. */
#define CHECKING "run, check, figure, report"
#define ALL CHECKING ", explain, advise, state"

#define AT(member) offsetof(struct nb_call, member)
static const struct option_row {
  const char *name, *value;                                 /* name; name of the value in the help, NULL: no value */
  int letter;                                               /* short form; 0: none */
  enum { TEXT, NUMBER, SECONDS, FLAG, SETTING, PAGE } kind; /* the value of SECONDS may be missing */
  size_t at;                                                /* offset in struct nb_call */
  const char *commands;                                     /* commands that take the option; NULL: it is used alone */
  const char *help;
} options[] = {
    {"output", "FOLDER", 'o', TEXT, AT(folder), "run, figure, report, advise, state",
     "output folder (default: NAME.out; report: report; advise --all: trades); for `state` a FILE (NAME-STAGE.state)"},
    {"set", "NAME=VALUE", 0, SETTING, 0, ALL,
     "replaces the value of the page's `let` or `sweep` NAME. NAME may also be normal, shear, step or damping; refine, "
     "a number that divides the step and multiplies the cycles; soften, a number that divides the stiffnesses; follow, "
     "a "
     "FILE with the points of a contact test"},
    {"stage", "NAME", 0, TEXT, AT(stage), "state", "the stage at whose end the state is taken (default: the last one)"},
    {"states", "FOLDER", 0, TEXT, AT(options.states), ALL,
     "folder of the saved states from which pages start (default: $NINEBALL_STATES, or states)"},
    {"all", NULL, 0, FLAG, AT(all), "advise",
     "search for advice on each page, also on those below a FOLDER (default: cases). --quantity and --within may be "
     "lists separated by `;`. Without --quantity, advice is about up to three quantities that the page expects, in the "
     "middle run of a sweep. Without --within, the tolerances are 10 %, 1 % and 0.1 %. The output folder (default: "
     "trades) gets a figure of each page and the table trades.tsv, to which a later call adds rows. Exit status 1: a "
     "search ended without advice"},
    {"quantity", "MEASURE", 0, TEXT, AT(quantity), "advise",
     "quantity whose error counts, as in an expect block (default: that of the first expectation of a single value)"},
    {"within", "TOLERANCE", 0, TEXT, AT(within), "advise",
     "largest error of the quantity: '1 %', or a number in its unit"},
    {"budget", "TIME", 0, TEXT, AT(budget), "advise", "time for the search, s (default: 60)"},
    {"over", "NAME", 0, TEXT, AT(over), "advise",
     "take the error of the mean over realizations; a realization is a run with NAME = 1, 2, …, where NAME is a `let` "
     "or "
     "`sweep` of the page"},
    {"realizations", "N", 0, NUMBER, AT(realizations), "advise", "number of realizations, 8 to 32 (default: 8)"},
    {"jobs", "N", 0, NUMBER, AT(options.jobs), CHECKING ", advise",
     "runs of a sweep, or trials, in parallel (default: the number of processors, divided by --threads)"},
    {"threads", "N", 0, NUMBER, AT(options.threads), ALL,
     "threads of one run (default 1); the results do not depend on it"},
    {"isa", "NAME", 0, TEXT, AT(options.isa), ALL,
     "instruction set: plain, avx2 or avx512 (default: the widest); the results do not depend on it"},
    {"checkpoint", "SECONDS", 0, SECONDS, AT(options.checkpoint.seconds), CHECKING,
     "save the run in the folder of states at the ends of stages, every SECONDS (--checkpoint=30; default: 60), and "
     "when it is interrupted by SIGINT or SIGTERM; refused if there is a checkpoint that --resume could continue"},
    {"resume", NULL, 0, FLAG, AT(options.checkpoint.resume), CHECKING,
     "continue from the last checkpoint, with the same results as a run without interruption; implies --checkpoint"},
    {"unrun", "PAGE", 0, PAGE, 0, "report", "show this page too, without running it; may be given many times"},
    {"trust", NULL, 0, FLAG, AT(trust), "figure, report, advise",
     "draw even where gnuplot cannot be confined, and copy linked texts and pictures from all folders: for pages that "
     "you trust"},
    {"in-place", NULL, 0, FLAG, AT(in_place), "migrate",
     "write the result into the pages (default: to standard output)"},
    {"rounding", "WHICH", 0, TEXT, AT(rounding), "check",
     "all: run under the four rounding modes, print how many bits of the expected quantities do not depend on them; "
     "parts: also for each part of the cycle alone"},
    {"tap", NULL, 0, FLAG, AT(tap), "check", "verdicts as TAP, which `make check` reads"},
    {"help", NULL, 'h', FLAG, AT(help), NULL,
     "this text; all words of pages: nineball --help scene; one word, also of another program: nineball --help disc; "
     "topics: expect, gnuplot, quantities, units, expressions"},
    {"version", NULL, 0, FLAG, AT(version), NULL, "version and licence"},
};
enum { OPTIONS = sizeof options / sizeof *options, LONG_OPTION = 256 };
static const double checkpoint_seconds = 60;

/* Set by SIGINT and SIGTERM in a run with checkpoints. */
static volatile sig_atomic_t stop_signal;
static void note_signal(int number) { stop_signal = number; }

/* In a run with checkpoints the first signal stops the run after the present cycle; a second one of the same kind ends
 * the process. */
static void catch_signals(struct nb_call *call) {
  struct sigaction action = {.sa_handler = note_signal, .sa_flags = (int)SA_RESETHAND};
  signal(SIGPIPE, SIG_IGN); /* output files are written even if nobody reads the verdict */
  signal(SIGXFSZ, SIG_IGN); /* a write beyond the limit of file sizes fails with an error */
  if (call->options.checkpoint.resume && !(call->options.checkpoint.seconds > 0))
    call->options.checkpoint.seconds = checkpoint_seconds;
  if (!(call->options.checkpoint.seconds > 0))
    return;
  call->options.checkpoint.stop = &stop_signal;
  sigaction(SIGINT, &action, NULL);
  sigaction(SIGTERM, &action, NULL);
}

/* Prints how to continue, or how to repeat a contact test. Returns the exit status of a process that a signal has
 * ended. */
static int stopped(const struct nb_call *call, char **words) {
  fputs(*call->repeats ? "to repeat:" : "to continue:", stderr);
  for (; *words; words++) {
    char word[4096] = "";
    nb_append_word(word, sizeof word, *words);
    fprintf(stderr, " %s", word);
  }
  fputs(call->options.checkpoint.resume || *call->repeats ? "\n" : " --resume\n", stderr);
  return 128 + (int)stop_signal;
}

static enum nb_status usage(const char *format, ...) __attribute__((format(printf, 1, 2)));
static enum nb_status usage(const char *format, ...) {
  va_list words;
  fputs("nineball: ", stderr);
  va_start(words, format);
  vfprintf(stderr, format, words);
  va_end(words);
  fputs("; see nineball --help\n", stderr);
  return NB_BAD_USE;
}

static enum nb_status out_of_memory(void) {
  struct nb_error error;
  nb_error_memory(&error);
  return nb_print_plain_error(&error);
}

/* ---- help ---- */

static void print_command(FILE *out, int k) {
  char term[64];
  snprintf(term, sizeof term, "%s %s", commands[k].name, commands[k].arguments);
  int width = 28; /* columns of the text, plus the extra bytes of its UTF-8 characters */
  for (const char *c = term; *c; c++)
    width += (*c & 0xC0) == 0x80;
  fprintf(out, "  %-*s %s\n", width, term, commands[k].help);
}

static void print_option(FILE *out, int k) {
  char term[64];
  const char letter[] = {'-', (char)options[k].letter, ',', 0}, *users = options[k].commands;
  const bool restricted = users && strcmp(users, ALL) != 0;
  snprintf(term, sizeof term, "--%s %s", options[k].name, options[k].value ? options[k].value : "");
  fprintf(out, "  %-3s %-19s %s%s%s%s\n", letter[1] ? letter : "", term, options[k].help, restricted ? " (" : "",
          restricted ? users : "", restricted ? ")" : "");
}

static void print_help(FILE *out) {
  fputs("nineball simulates discs and spheres in the plane by the distinct element method, and checks the results\n\n"
        "usage: nineball COMMAND …\n\n",
        out);
  for (int k = 0; k < COMMANDS; k++)
    print_command(out, k);
  fputc('\n', out);
  for (int k = 0; k < OPTIONS; k++)
    print_option(out, k);
  fputs("\nexit status: 0 passed, 1 a check failed, 2 bad use or a mistake in a page, 3 run aborted, 4 out of memory; "
        "`figure` ends with 0 also if a check failed, and says so\n",
        out);
}

/* True if the word is in the comma-separated list. */
static bool list_contains(const char *list, const char *word) {
  const size_t length = strlen(word);
  for (; *list; list += strcspn(list, " "), list += strspn(list, " "))
    if (strncmp(list, word, length) == 0 && (list[length] == ',' || !list[length]))
      return true;
  return false;
}

static int find_command(const char *word) {
  for (int k = 0; k < COMMANDS; k++)
    if (strcmp(commands[k].name, word) == 0)
      return k;
  return -1;
}

/* Prints the option with this name, or the option that takes the word: `--set refine=R`. False: there is none. */
static bool print_options(const char *word) {
  char taken[NB_HINT_SIZE];
  bool found = false;
  snprintf(taken, sizeof taken, "; %.200s, ", word);
  for (int k = 0; k < OPTIONS; k++)
    if (strcmp(options[k].name, word) == 0 || strstr(options[k].help, taken))
      print_option(stdout, k), found = true;
  return found;
}

/* Prints the help of `nineball --help WORD …`: a command with its options; a word of pages; an option, or a word that
 * an option takes. */
static enum nb_status print_word_help(const char *word) {
  char suggestion[NB_HINT_SIZE];
  const int command = find_command(word);
  const bool markdown = strcmp(word, "language-md") == 0;
  if (markdown || strcmp(word, "scene") == 0)
    return nb_manual(stdout, markdown), NB_OK;
  if (command >= 0)
    fputs("usage: nineball COMMAND …\n\n", stdout), print_command(stdout, command);
  for (int k = 0; k < OPTIONS; k++)
    if (command >= 0 && options[k].commands && list_contains(options[k].commands, word))
      print_option(stdout, k);
  const bool found = nb_manual_word(stdout, word, suggestion) || command >= 0;
  if (print_options(word) || found)
    return NB_OK;
  fprintf(
      stderr,
      "nineball: `%s` is not a word of pages%s%s%s; nineball --help scene lists all words, nineball laws the laws\n",
      word, suggestion[0] ? "; did you mean `" : "", suggestion, suggestion[0] ? "`?" : "");
  return NB_BAD_USE;
}

/* ---- the command line ---- */

static bool parse_number(int *number, const char *text) {
  char *end;
  const long value = strtol(text, &end, 10);
  *number = (int)value;
  return !*end && value >= 1 && value <= 256;
}

/* Appends a word to a list that ends in NULL and is long enough. */
static void append(const char **list, const char *word) {
  while (*list)
    list++;
  *list = word;
}

static enum nb_status set_option(struct nb_call *call, const struct option_row *row, char *value) {
  void *at = (char *)call + row->at;
  char *end = value;
  switch (row->kind) {
  case TEXT:
    *(const char **)at = value;
    break;
  case FLAG:
    *(bool *)at = true;
    break;
  case NUMBER:
    if (!parse_number(at, value))
      return usage("expected a number from 1 to 256 after --%s, found `%s`", row->name, value);
    break;
  case SECONDS:
    *(double *)at = value ? strtod(value, &end) : checkpoint_seconds;
    if ((value && *end) || !(*(double *)at > 0) || !isfinite(*(double *)at))
      return usage("expected a number of seconds above 0 after --%s=, found `%s`", row->name, value);
    break;
  case PAGE:
    append(call->unrun, value);
    break;
  case SETTING:
    if (!strchr(value, '='))
      return usage("expected NAME=VALUE after --set, found `%s`", value);
    append(call->settings, value);
    break;
  }
  return NB_OK;
}

static enum nb_status read_options(struct nb_call *call, int count, char **words) {
  struct option list[OPTIONS + 1] = {{NULL, 0, NULL, 0}};
  enum nb_status status = NB_OK;
  for (int k = 0; k < OPTIONS; k++)
    list[k] = (struct option){options[k].name,
                              !options[k].value            ? no_argument
                              : options[k].kind == SECONDS ? optional_argument
                                                           : required_argument,
                              NULL, options[k].letter ? options[k].letter : LONG_OPTION + k};
  for (int found; !status && (found = getopt_long(count, words, "o:h", list, NULL)) != -1;) {
    int k = 0;
    while (k < OPTIONS && found != list[k].val)
      k++;
    if (k == OPTIONS) { /* getopt has printed the error */
      fputs("nineball: see nineball --help\n", stderr);
      return NB_BAD_USE;
    }
    call->given |= 1U << k;
    status = set_option(call, &options[k], optarg);
  }
  return status;
}

static enum nb_status no_command(const char *word) {
  if (strcmp(word, "compare") == 0 || strcmp(word, "diff") == 0)
    return usage("there is no command `%s`; compare runs in one page: `sweep mu 0.2 0.6`, a line with `$mu`, and in a "
                 "block `expect` for example `M.coordination last in STAGE  constant with mu within 1 %%`",
                 word);
  char hint[NB_HINT_SIZE];
  struct nb_guess guess = nb_guess_begin(word);
  for (int k = 0; k < COMMANDS; k++)
    nb_guess_offer(&guess, commands[k].name);
  const char *suggestion = nb_guess_hint(&guess, hint);
  return usage("there is no command `%s`%s%s", word, suggestion ? "; " : "", suggestion ? suggestion : "");
}

static enum nb_status run_command(struct nb_call *call, const char *word) {
  const int command = find_command(word);
  for (int k = 0; k < OPTIONS && command >= 0; k++)
    if (call->given & 1U << k && options[k].commands && !list_contains(options[k].commands, word)) {
      fprintf(stderr, "nineball: `nineball %s` does not use --%s, which is an option of: %s\n", word, options[k].name,
              options[k].commands);
      return NB_BAD_USE;
    }
  if (command >= 0 && commands[command].arguments[0] && call->page_count == 0 && !call->all)
    return usage("`nineball %s` needs a page, such as cases/3-nine-discs/nine-discs.md", word);
  if (command >= 0 && !commands[command].arguments[0] && call->page_count > 0)
    return usage("`nineball %s` takes no page, found `%s`", word, call->pages[0]);
  if (command >= 0) {
    catch_signals(call);
    return commands[command].run(call);
  }
  return no_command(word);
}

static enum nb_status execute(struct nb_call *call, int count, char **words) {
  const enum nb_status status = read_options(call, count, words);
  const char *word = optind < count ? words[optind] : NULL;
  if (status)
    return status;
  if (call->version) {
    puts("nineball " NB_VERSION "\n"
         "Copyright (C) 2026 the nineball authors.\n"
         "GPL-3.0-or-later: free software, without any warranty.");
    return NB_OK;
  }
  if (call->help && word) {
    char text[NB_HINT_SIZE] = "";
    for (int k = optind; k < count; k++)
      nb_append(text, sizeof text, "%s%s", *text ? " " : "", words[k]);
    return print_word_help(text);
  }
  if (call->help || !word) {
    print_help(call->help ? stdout : stderr);
    return call->help ? NB_OK : NB_BAD_USE;
  }
  call->pages = words + optind + 1, call->page_count = (size_t)(count - optind - 1);
  return run_command(call, word);
}

/* NB_BAD_USE if a word of the command line has control characters, because names and values are printed to a
 * terminal. */
static enum nb_status check_text(const char *word) {
  char *shown = word ? strdup(word) : NULL;
  unsigned byte;
  enum nb_status status = word && !shown ? out_of_memory() : NB_OK;
  if (shown && nb_clean(shown, strlen(shown), &byte)) {
    fprintf(stderr, "nineball: expected text, found the byte 0x%02X (shown as `?`) in `%s`\n", byte, shown);
    status = NB_BAD_USE;
  }
  free(shown);
  return status;
}

/* Opens standard streams that are closed. Otherwise an output file would get the number of a stream, and messages would
 * be written into the file. The new streams can only be used in the wrong direction, so each use of them fails. */
static void open_closed_streams(void) {
  for (int file = STDIN_FILENO; file <= STDERR_FILENO; file++)
    if (fcntl(file, F_GETFD) < 0)
      open("/dev/null", file == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

int main(int count, char **words) {
  open_closed_streams();
  bool repeats = false;
  struct nb_call call = {.options = {.threads = 1}, .repeats = &repeats};
  call.options.states = getenv("NINEBALL_STATES");
  enum nb_status status = check_text(call.options.states);
  for (int k = 1; k < count && !status; k++)
    status = check_text(words[k]);
  if (status)
    return (int)status;
  call.settings = calloc((size_t)count + 1, sizeof *call.settings);
  call.unrun = calloc((size_t)count + 1, sizeof *call.unrun);
  if (!call.settings || !call.unrun)
    return free(call.settings), free(call.unrun), out_of_memory();
  char **command = calloc((size_t)count + 1, sizeof *command); /* getopt permutes the words */
  if (!command)
    return free(call.settings), free(call.unrun), out_of_memory();
  memcpy(command, words, (size_t)count * sizeof *command);
  status = execute(&call, count, words);
  const int code = stop_signal && status > NB_FAILED ? stopped(&call, command) : (int)status;
  free(command);
  free(call.settings), free(call.unrun);
  if (fflush(stdout) != 0 || ferror(stdout)) { /* a full disk, a closed pipe */
    fputs("nineball: the output could not be written\n", stderr);
    return NB_BAD_USE;
  }
  return code;
}
