/* The blocks of the force calculation: contacts of one material pair, divided among the threads.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "model.h"

static bool stable_overlap_begin(struct nb_model *model, size_t blocks) {
  model->blocks.stable_overlap = nb_own(&model->contacts.owner, blocks, sizeof *model->blocks.stable_overlap);
  for (size_t v = 0; model->blocks.stable_overlap && v < blocks; v++)
    model->blocks.stable_overlap[v].overlap = INFINITY; /* until the step has been checked */
  return model->blocks.stable_overlap != NULL;
}

static struct nb_block block_of(const struct nb_model *model, size_t from, size_t to, double *scratch) {
  const struct nb_contacts *contacts = &model->contacts;
  struct nb_block block = {.n = to - from, .a = contacts->a + from, .b = contacts->b + from};
  block.force = contacts->force + from;
  block.image = contacts->image ? contacts->image + from : NULL;
  block.material_pair = &model->material_pairs[contacts->material_pair[from]];
  for (int f = 0; f < NB_FIELDS; f++)
    block.f[f] = contacts->kept[f] ? contacts->kept[f] + from : scratch + f * NB_BLOCK_SIZE;
  block.f[NB_DISSIPATED] = contacts->kept[NB_DISSIPATED] ? block.f[NB_DISSIPATED] : NULL; /* not requested */
  if (!model->plan.dashpots)
    block.f[NB_TOTAL_NORMAL] = block.f[NB_NORMAL], block.f[NB_TOTAL_SHEAR] = block.f[NB_SHEAR];
  block.normal_history = nb_history_from(&contacts->normal_history, from);
  block.shear_history = nb_history_from(&contacts->shear_history, from);
  return block;
}

/* Starts of the blocks, and the end of the last one; returns their number. */
static size_t find_starts(size_t start[], const struct nb_contacts *contacts) {
  size_t n = 0;
  for (size_t c = 0; c < contacts->count; c++)
    if (c == 0 || contacts->material_pair[c] != contacts->material_pair[c - 1] || c - start[n - 1] == NB_BLOCK_SIZE)
      start[n++] = c;
  start[n] = contacts->count;
  return n;
}

/* Counters for each block, as far as the plan needs them. */
static bool create_counters(struct nb_model *model, size_t blocks) {
  const bool watched = model->plan.kept & NB_BIT(NB_STABLE_OVERLAP);
  if (!model->plan.elastic)
    nb_deep_end(model);
  model->blocks.stable_overlap = NULL;
  return (!model->plan.elastic || nb_deep_begin(model, blocks)) && (!watched || stable_overlap_begin(model, blocks));
}

/* Thread t of T computes blocks n t/T to n (t+1)/T, with scratch memory of its own. */
enum nb_status nb_blocks_create(struct nb_model *model, struct nb_error *error) {
  const struct nb_contacts *contacts = &model->contacts;
  const size_t fraction = contacts->count / NB_CONTACTS_PER_THREAD; /* a thread with fewer waits longer than it works */
  model->machine.threads_used = fraction < 1                                ? 1
                                : fraction < (size_t)model->machine.threads ? (int)fraction
                                                                            : model->machine.threads;
  size_t most = contacts->count / NB_BLOCK_SIZE + model->material_pair_count + 1;
  struct nb_owner *owner = &model->contacts.owner;
  model->blocks.list = nb_own(owner, most, sizeof *model->blocks.list);
  model->blocks.coefficients = nb_own(owner, contacts->count, sizeof *model->blocks.coefficients);
  size_t *start = nb_own(owner, most + 1, sizeof *start);
  const size_t n = start ? find_starts(start, contacts) : 0;
  if (owner->failed || !create_counters(model, n))
    return nb_error_memory(error);
  for (size_t v = 0; v < n; v++) {
    size_t thread = 0;
    while (n * (thread + 1) / (size_t)model->machine.threads_used <= v)
      thread++;
    model->blocks.list[v] =
        block_of(model, start[v], start[v + 1], model->blocks.scratch + thread * NB_FIELDS * NB_BLOCK_SIZE);
    model->blocks.list[v].stable_overlap = model->blocks.stable_overlap ? model->blocks.stable_overlap + v : NULL;
    model->blocks.list[v].deep = model->deep.counts ? model->deep.counts + v * NB_DEEP_STRIDE : NULL;
  }
  model->blocks.count = n;
  return NB_OK;
}
