/* "Did you mean": the known word nearest to a misspelt one, and words of other programs and textbooks with those of the page language,
 * for hints and for `nineball --help WORD`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <ctype.h>
#include <string.h>

#include "reader.h"

/* ---- words of other programs ---- */

bool nb_item(const char **list, char item[NB_NAME_SIZE]) {
  const size_t length = strcspn(*list, ",");
  snprintf(item, NB_NAME_SIZE, "%.*s", (int)length, *list);
  *list += length + strspn(*list + length, ", ");
  return length > 0;
}

const struct nb_synonym *nb_synonym(const char *word) {
  /* clang-format off */
  static const struct nb_synonym synonyms[] = { /* each word once */
    {"ball balls disk disks particle particles grain grains body bodies clump", "disc, sphere"}, {"grid mesh regular", "lattice"},
    {"generate create create_atoms insert", "fill, lattice, disc, sphere"}, {"distribute pour random cloud", "fill"}, {"psd gradation", "grading"},
    {"facet facets plane plate", "wall"}, {"domain container create_box", "box, cell"}, {"periodic pbc", "cell"},
    {"contact_model cmat pair_style model", "normal, shear"}, {"property prop attribute set assign", "material, pair, let"},
    {"variable define parameter fish", "let"}, {"loop foreach for while", "sweep, repeat"}, {"bond bonds cement adhesion", "cohesion"},
    {"friction_coefficient friction_angle fric mu xmu coulomb", "friction"}, {"rho dens mass_density", "density"},
    {"young_modulus youngs_modulus youngs modulus emod E", "young"}, {"poisson_ratio poissons_ratio pois nu", "poisson"},
    {"normal_stiffness k_n", "kn"}, {"shear_stiffness tangential_stiffness k_s k_t kt kratio", "ks"}, {"stiffness spring", "kn, ks"},
    {"diameter r", "radius"}, {"g grav acceleration", "gravity"}, {"dt timestep time_step time-step", "step"},
    {"damp viscous dashpot gamma gamma_n dp_nratio dp_sratio beta", "damping, ratio, stiffness"}, {"neighbor verlet cutoff", "skin"},
    {"local nonviscous", "mass", "there is no local damping"}, {"dump", "record, snapshot"}, {"plot graph figure", "gnuplot"},
    {"restitution cor", "ratio, impact.restitution", "restitution is a result, not an input"},
    {"rolling rolling_friction rolling_resistance", "rotation off", "there is no rolling resistance"},
    {"history track trace thermo output probe", "monitor, record"}, {"measure measurement group range", "region"},
    {"run solve go iterate", "cycles, until"}, {"equilibrium converge unbal", "until, unbalanced.max"},
    {"calm relax quench", "zero velocities"}, {"fix freeze clamp", "fixed, servo, cell strain, boundary fixed, rotation off"},
    {"apply load", "gravity, boundary stress, servo, wall"}, {"confine membrane pressure", "servo, boundary stress, cell.stress.mean"},
    {"deform strain_rate shear_rate rate", "cell strain, box strain, boundary strain, affine strain"},
    {"move displace", "wall, walls, transform"}, {"delete kill erase", "remove"},
    {"save checkpoint write_restart", "nineball state"}, {"restore restart read_restart read_data import", "start, packing"},
    {"assert compare equals equal is = ==", "expected, within"}, {"less < <=", "below"}, {"greater more > >=", "above"},
    {"force contact_force forces", "normal, shear, fx, fy"}, {"position displacement pos disp", "x, y"}, {"vel", "velocity, vx, vy"},
    {"kinetic_energy ke", "energy.kinetic"}, {"inch inches ft", "m, mm"}, {"psi ksi bar atm", "Pa, kPa"}, {"lb lbf kgf", "N, kN"},
    {"degree degrees", "deg"}, {"rpm", "rad/s"},
  };
  /* clang-format on */
  const size_t length = strlen(word);
  for (size_t k = 0; k < sizeof synonyms / sizeof *synonyms && length; k++)
    for (const char *at = synonyms[k].words; (at = strstr(at, word)); at++)
      if ((at == synonyms[k].words || at[-1] == ' ') && (at[length] == ' ' || !at[length]))
        return &synonyms[k];
  return NULL;
}

/* Lists the marked words of the page language: "`fill`, `disc` or `sphere`". */
static void list_ours(char list[NB_HINT_SIZE / 2], const struct nb_synonym *synonym, unsigned marked) {
  char item[NB_NAME_SIZE];
  size_t used = 0;
  for (const char *at = synonym->ours; nb_item(&at, item); marked >>= 1)
    if (marked & 1)
      used += (size_t)snprintf(list + used, NB_HINT_SIZE / 2 - used, "%s`%s`",
                               !used               ? ""
                               : marked > 1 && *at ? ", "
                                                   : " or ",
                               item);
}

const char *nb_synonym_hint(char *hint, const char *word) {
  const struct nb_synonym *synonym = nb_synonym(word);
  char list[NB_HINT_SIZE / 2];
  if (!synonym)
    return NULL;
  list_ours(list, synonym, ~0u);
  if (synonym->note)
    snprintf(hint, NB_HINT_SIZE, "%s: see `nineball --help %s`", synonym->note, word);
  else
    snprintf(hint, NB_HINT_SIZE, "`%s` of other programs is %s here: see `nineball --help %s`", word, list, word);
  return hint;
}

/* ---- the nearest word ---- */

/* Number of insertions, deletions, changes and swaps of letters between a and b (optimal string alignment distance), upper and lower
 * case being equal. */
static int distance(const char *a, const char *b) {
  enum { LONGEST = 2 * NB_NAME_SIZE };
  int row[3][LONGEST + 1];
  size_t m = strlen(a), n = strlen(b);
  if (m >= LONGEST || n >= LONGEST)
    return LONGEST;
  int *two = row[0], *one = row[1], *now = row[2];
  for (size_t j = 0; j <= n; j++)
    one[j] = (int)j;
  for (size_t i = 1; i <= m; i++) {
    now[0] = (int)i;
    for (size_t j = 1; j <= n; j++) {
      int x = tolower((unsigned char)a[i - 1]), y = tolower((unsigned char)b[j - 1]);
      int best = one[j - 1] + (x != y);
      if (one[j] + 1 < best)
        best = one[j] + 1;
      if (now[j - 1] + 1 < best)
        best = now[j - 1] + 1;
      bool swapped = i > 1 && j > 1 && x == tolower((unsigned char)b[j - 2]) && y == tolower((unsigned char)a[i - 2]);
      if (swapped && x != y && two[j - 2] + 1 < best)
        best = two[j - 2] + 1;
      now[j] = best;
    }
    int *spare = two;
    two = one;
    one = now;
    now = spare;
  }
  return one[n];
}

struct nb_guess nb_guess_begin(const char *word) {
  return (struct nb_guess){.word = word, .synonym = nb_synonym(word), .distance = 2 * NB_NAME_SIZE};
}

/* Marks the suggested words that begin with the known one; false: there are none. */
static bool mark(struct nb_guess *guess, const char *known) {
  const char *list = guess->synonym ? guess->synonym->ours : "";
  char item[NB_NAME_SIZE];
  const size_t length = strlen(known);
  bool found = false;
  for (unsigned bit = 1; nb_item(&list, item); bit <<= 1)
    if (strncmp(item, known, length) == 0 && (!item[length] || item[length] == ' '))
      guess->marked |= bit, found = true;
  return found;
}

void nb_guess_offer(struct nb_guess *guess, const char *known) {
  const size_t length = strlen(guess->word);
  const bool begins = length > 2 && strncmp(known, guess->word, length) == 0 && known[length] == '.';
  const int d = mark(guess, known) ? 0
                : begins           ? 1
                                   : distance(guess->word, known); /* `energy` is near to `energy.kinetic` */
  if (d >= guess->distance || strlen(known) >= sizeof guess->best)
    return;
  guess->distance = d;
  strcpy(guess->best, known);
}

/* Whether the best word is near: about one typing error in three letters, none in words of one or two letters. */
bool nb_guess_found(const struct nb_guess *guess) {
  size_t length = strlen(guess->word);
  int allowed = length < 3 ? 0 : length < 6 ? 1 : length < 10 ? 2 : 3;
  return guess->best[0] && guess->distance <= allowed;
}

const char *nb_guess_hint(const struct nb_guess *guess, char *text) {
  if (!nb_guess_found(guess))
    return NULL;
  char list[NB_HINT_SIZE / 2];
  snprintf(list, sizeof list, "`%s`", guess->best);
  if (guess->marked)
    list_ours(list, guess->synonym, guess->marked);
  const char *const note = guess->marked && guess->synonym->note ? guess->synonym->note : "";
  snprintf(text, NB_HINT_SIZE, "%s%sdid you mean %s?", note, *note ? ": " : "", list);
  return text;
}
