/* The quantity that a newcomer means by a name of several words: `max_velocity`, `A.position.y`, `box.q`. The name is
 * split into parts, each part is compared with the parts of all names of quantities, and the table of words of other
 * programs gives parts of the same meaning. The order of the parts does not matter.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <ctype.h>
#include <string.h>

#include "core/clean.h"
#include "core/names.h"
#include "reader.h"

enum { PARTS_MAX = 8 };

/* A part of a name, and the keywords with the meaning of this part. */
struct part {
  char text[NB_NAME_SIZE];
  const struct nb_synonym *meaning;
};
struct parts {
  struct part part[PARTS_MAX];
  size_t count;
};

/* How well the name of a quantity fits: all parts of the searched name must fit some part of it, but for words that do
 * not distinguish quantities. */
struct fit {
  bool owner;   /* the quantity belongs to the monitor with which the searched name begins */
  bool begins;  /* the first part of the quantity fits */
  size_t equal; /* those that are equal to a part of the quantity */
  size_t left;  /* parts of the quantity that fit no part of the searched name */
};

static void split(struct parts *parts, const char *text, bool meanings) {
  for (parts->count = 0; *text && parts->count < PARTS_MAX; text += strspn(text, "._-")) {
    struct part *const part = &parts->part[parts->count++];
    size_t length = strcspn(text, "._-");
    snprintf(part->text, sizeof part->text, "%.*s", (int)length, text);
    text += length;
    for (char *c = part->text; *c; c++)
      *c = (char)tolower((unsigned char)*c);
    part->meaning = meanings ? nb_pair_synonym("quantity", part->text) : NULL;
    if (meanings && !part->meaning)
      part->meaning = nb_synonym(part->text);
  }
}

/* True if a list like "fabric.xx, x" has the word as a part of an item. */
static bool has_part(const char *list, const char *word) {
  const size_t length = strlen(word);
  for (const char *at = list; *at; at += strcspn(at, "., "), at += strspn(at, "., "))
    if (strcspn(at, "., ") == length && strncmp(at, word, length) == 0)
      return true;
  return false;
}

/* True if two words have the same beginning of at least five letters, and at most four other letters each:
 * `friction` and `frictional`. */
static bool same_stem(const char *a, const char *b) {
  size_t n = 0;
  while (a[n] && a[n] == b[n])
    n++;
  return n >= 5 && strlen(a) - n <= 4 && strlen(b) - n <= 4;
}

static bool same_but_for_plural(const char *a, const char *b) {
  const size_t m = strlen(a), n = strlen(b), shorter = m < n ? m : n;
  return strncmp(a, b, shorter) == 0 && strcmp(m < n ? b + m : a + n, m == n ? "" : "s") == 0;
}

static bool fits(const struct part *searched, const char *known) {
  const char *const word = searched->text;
  const bool axis = strchr("xy", word[0]) && !word[1] && known[0] && known[1] == word[0] && !known[2];
  return same_but_for_plural(word, known) || axis || (searched->meaning && has_part(searched->meaning->ours, known)) ||
         (!searched->meaning && same_stem(word, known));
}

/* True for a word that does not distinguish quantities. */
static bool is_filler(const char *word) {
  return has_part(
      "of the mean average number count total value quantity all system scene assembly sample particle particles ball "
      "balls disc discs sphere spheres contact contacts fraction component",
      word);
}

/* Compares a searched name with the name of a quantity; false: it does not fit. */
static bool compare(struct fit *fit, const struct parts *searched, const struct parts *known) {
  bool used[PARTS_MAX] = {false};
  *fit = (struct fit){.left = known->count};
  for (size_t s = 0; s < searched->count; s++) {
    const struct part *const part = &searched->part[s];
    bool found = false, equal = false;
    for (size_t k = 0; k < known->count; k++)
      if (fits(part, known->part[k].text)) {
        fit->left -= !used[k];
        used[k] = found = true;
        fit->begins = fit->begins || (k == 0 && !is_filler(part->text));
        equal = equal || strcmp(part->text, known->part[k].text) == 0;
      }
    if (!found && !is_filler(part->text))
      return false;
    fit->equal += equal;
  }
  return fit->left < known->count;
}

static bool better(const struct fit *a, const struct fit *b) {
  return a->owner != b->owner     ? a->owner
         : a->begins != b->begins ? a->begins
         : a->left != b->left     ? a->left < b->left
                                  : a->equal > b->equal;
}

/* The search for the best quantities: their whole names if the scene has them, else the first one without its owner. */
struct search {
  struct fit best;
  size_t count;
  bool known; /* the scene has the quantities */
  char first[NB_NAME_SIZE], names[NB_RELATED_MAX][3 * NB_NAME_SIZE];
};

/* Offers a quantity, whose whole name in the scene is `whole`; NULL: the scene lacks it. */
static void offer(struct search *search, const struct fit *fit, const char *name, const char *whole) {
  const bool known = whole != NULL, first = !search->count || better(fit, &search->best) ||
                                            (!better(&search->best, fit) && known && !search->known);
  if (!first && (better(&search->best, fit) || known != search->known))
    return;
  if (first) {
    *search = (struct search){.best = *fit, .known = known};
    snprintf(search->first, sizeof search->first, "%s", name);
  }
  for (size_t k = 0; known && k < search->count && k < NB_RELATED_MAX; k++)
    if (strcmp(search->names[k], whole) == 0)
      return;
  if (known && search->count < NB_RELATED_MAX)
    snprintf(search->names[search->count], sizeof *search->names, "%s", whole);
  search->count++;
}

/* Offers a quantity of the scene, or of each monitor that has it. */
static void offer_owned(struct search *search, const struct nb_scene *scene, int owner, struct fit fit,
                        const char *name) {
  struct nb_quantity quantity;
  char whole[3 * NB_NAME_SIZE];
  bool found = false;
  for (int w = -1; w < (int)scene->monitor_count; w++) {
    if (w >= 0 && owner >= 0 && w != owner)
      continue; /* `A.x` is not meant by `C.displacement` */
    snprintf(whole, sizeof whole, "%s%s%s", w < 0 ? "" : scene->monitors[w].name, w < 0 ? "" : ".", name);
    if (!nb_quantity_find(&quantity, scene, whole) || quantity.monitor != w)
      continue;
    fit.owner = owner >= 0 && w == owner;
    offer(search, &fit, name, whole);
    found = true;
  }
  if (!found)
    offer(search, &fit, name, NULL);
}

/* True if a newcomer may mean the quantity: nothing of a boundary or a contact test that is not there. */
static bool is_meant(const struct nb_quantity_row *row, const struct nb_scene *scene) {
  return strcmp(row->of, "a contact test") != 0 &&
         (scene->circle.line || strncmp(row->name, "boundary.", strlen("boundary.")) != 0);
}

static void list_found(char *hint, const struct search *search) {
  const size_t shown = search->count < NB_RELATED_MAX ? search->count : NB_RELATED_MAX;
  char list[NB_HINT_SIZE / 2] = "";
  for (size_t k = 0; k < shown; k++)
    nb_append_item(list, sizeof list, search->names[k], k + 1 == search->count);
  snprintf(hint, NB_HINT_SIZE, "did you mean %s%s?", list, shown < search->count ? ", …" : "");
}

bool nb_parts_hint(char *hint, const struct nb_scene *scene, const char *text, int owner) {
  struct search search = {0};
  struct parts searched, known;
  struct nb_quantity_row row;
  struct fit fit;
  split(&searched, owner >= 0 ? text + strcspn(text, ".") + 1 : text, true);
  for (size_t k = 0; !scene->contact_test && nb_quantity_row(&row, k); k++) {
    split(&known, row.name, false);
    if (is_meant(&row, scene) && compare(&fit, &searched, &known))
      offer_owned(&search, scene, owner, fit, row.name);
  }
  if (!search.count || search.best.left > 2 ||
      (searched.count == 1 && !(search.known && (search.best.begins || search.best.owner))))
    return false;
  if (search.known)
    list_found(hint, &search);
  else
    nb_quantity_hint(hint, scene, search.first);
  return true;
}
