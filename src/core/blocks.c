/* The blocks that the force calculation goes through: contacts of one pairing, shared out to the threads.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "model.h"

static bool sure_begin(struct nb_model *model, size_t blocks) {
  model->blocks.sure = nb_own(&model->contacts.owner, blocks, sizeof *model->blocks.sure);
  for (size_t v = 0; model->blocks.sure && v < blocks; v++)
    model->blocks.sure[v].overlap = INFINITY; /* no step has been judged yet */
  return model->blocks.sure != NULL;
}

static struct nb_view view_of(const struct nb_model *model, size_t from, size_t to, double *scratch) {
  const struct nb_contacts *contacts = &model->contacts;
  struct nb_view view = {.n = to - from, .a = contacts->a + from, .b = contacts->b + from};
  view.force = contacts->force + from;
  view.image = contacts->image ? contacts->image + from : NULL;
  view.pairing = &model->pairings[contacts->pairing[from]];
  for (int f = 0; f < NB_FIELDS; f++)
    view.f[f] = contacts->kept[f] ? contacts->kept[f] + from : scratch + f * NB_BLOCK;
  view.f[NB_LOST] = contacts->kept[NB_LOST] ? view.f[NB_LOST] : NULL; /* nobody asks what is lost */
  if (!model->plan.dashpots)
    view.f[NB_PUSH] = view.f[NB_NORMAL], view.f[NB_DRAG] = view.f[NB_SHEAR];
  view.normal_memory = nb_memory_from(&contacts->normal_memory, from);
  view.shear_memory = nb_memory_from(&contacts->shear_memory, from);
  return view;
}

/* Where the blocks begin, runs of one pairing, and where the last one ends; how many they are. */
static size_t cut(size_t start[], const struct nb_contacts *contacts) {
  size_t n = 0;
  for (size_t c = 0; c < contacts->count; c++)
    if (c == 0 || contacts->pairing[c] != contacts->pairing[c - 1] || c - start[n - 1] == NB_BLOCK)
      start[n++] = c;
  start[n] = contacts->count;
  return n;
}

/* What is counted and watched block by block, where the plan asks for it. */
static bool make_counts(struct nb_model *model, size_t blocks) {
  const bool watched = model->plan.kept & NB_BIT(NB_SURE);
  if (!model->plan.elastic)
    nb_deep_end(model);
  model->blocks.sure = NULL;
  return (!model->plan.elastic || nb_deep_begin(model, blocks)) && (!watched || sure_begin(model, blocks));
}

/* Thread t of T works on views n t/T to n (t+1)/T, each thread in scratch of its own. */
enum nb_status nb_blocks_cut(struct nb_model *model, struct nb_error *error) {
  const struct nb_contacts *contacts = &model->contacts;
  const size_t share = contacts->count / NB_THREAD_SHARE; /* a thread with less to do waits longer than it works */
  model->machine.busy = share < 1 ? 1 : share < (size_t)model->machine.threads ? (int)share : model->machine.threads;
  size_t most = contacts->count / NB_BLOCK + model->pairing_count + 1;
  struct nb_owner *owner = &model->contacts.owner;
  model->blocks.views = nb_own(owner, most, sizeof *model->blocks.views);
  model->blocks.stiff = nb_own(owner, contacts->count, sizeof *model->blocks.stiff);
  size_t *start = nb_own(owner, most + 1, sizeof *start);
  const size_t n = start ? cut(start, contacts) : 0;
  if (owner->failed || !make_counts(model, n))
    return nb_error_memory(error);
  for (size_t v = 0; v < n; v++) {
    size_t thread = 0;
    while (n * (thread + 1) / (size_t)model->machine.busy <= v)
      thread++;
    model->blocks.views[v] =
        view_of(model, start[v], start[v + 1], model->blocks.scratch + thread * NB_FIELDS * NB_BLOCK);
    model->blocks.views[v].sure = model->blocks.sure ? model->blocks.sure + v : NULL;
    model->blocks.views[v].deep = model->deep.counts ? model->deep.counts + v * NB_DEEP_APART : NULL;
  }
  model->blocks.count = n;
  return NB_OK;
}
