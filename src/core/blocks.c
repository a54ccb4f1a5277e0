/* The blocks of the force calculation: contacts of one material pair, divided among the threads.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "model.h"
#include "team.h"

enum { CACHE_LINE = 64 }; /* bytes; two threads must not write to the same line */

static bool stable_overlap_begin(struct nb_model *model, size_t blocks) {
  model->blocks.stable_overlap = nb_own(&model->contacts.owner, blocks, sizeof *model->blocks.stable_overlap);
  for (size_t v = 0; model->blocks.stable_overlap && v < blocks; v++)
    model->blocks.stable_overlap[v].overlap = INFINITY; /* no limit until the stability check sets one */
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
  if (!contacts->kept[NB_DISSIPATED])
    block.f[NB_DISSIPATED] = NULL; /* the laws do not compute it */
  if (!model->plan.dashpots)
    block.f[NB_TOTAL_NORMAL] = block.f[NB_NORMAL], block.f[NB_TOTAL_SHEAR] = block.f[NB_SHEAR];
  block.normal_history = nb_history_from(&contacts->normal_history, from);
  block.shear_history = nb_history_from(&contacts->shear_history, from);
  return block;
}

/* Sets start[b] to the first contact of block b, and the entry after the last block to the end of that block. Returns
 * the number of blocks. */
static size_t find_starts(size_t start[], const struct nb_contacts *contacts) {
  size_t n = 0;
  for (size_t c = 0; c < contacts->count; c++)
    if (c == 0 || contacts->material_pair[c] != contacts->material_pair[c - 1] || c - start[n - 1] == NB_BLOCK_SIZE)
      start[n++] = c;
  start[n] = contacts->count;
  return n;
}

/* Creates, for each block, the counters that the plan needs. False: out of memory. */
static bool create_counters(struct nb_model *model, size_t blocks) {
  const bool check_stable = model->plan.kept & NB_BIT(NB_STABLE_OVERLAP);
  if (!model->plan.elastic)
    nb_deep_end(model);
  model->blocks.stable_overlap = NULL;
  return (!model->plan.elastic || nb_deep_begin(model, blocks)) &&
         (!check_stable || stable_overlap_begin(model, blocks));
}

/* Of n blocks, part p of P consists of those from n p/P to n (p+1)/P - 1. Each part has its own scratch memory. */
enum nb_status nb_blocks_create(struct nb_model *model, struct nb_error *error) {
  const struct nb_contacts *contacts = &model->contacts;
  /* A thread with fewer than NB_CONTACTS_PER_THREAD contacts waits longer than it computes. */
  const size_t threads = contacts->count / NB_CONTACTS_PER_THREAD;
  model->machine.threads_used = threads < 1                                ? 1
                                : threads < (size_t)model->machine.threads ? (int)threads
                                                                           : model->machine.threads;
  if (model->machine.threads_used > 1)
    model->machine.team = nb_team_sized(model->machine.team, model->machine.threads_used);
  if (!model->machine.team)
    model->machine.threads_used = 1;
  const size_t parts = nb_parts(model->machine.threads_used);
  size_t max_blocks = contacts->count / NB_BLOCK_SIZE + model->material_pair_count + 1;
  struct nb_owner *owner = &model->contacts.owner;
  model->blocks.list = nb_own(owner, max_blocks, sizeof *model->blocks.list);
  size_t *start = nb_own(owner, max_blocks + 1, sizeof *start);
  bool *began = nb_own(owner, parts, CACHE_LINE);
  const size_t n = start ? find_starts(start, contacts) : 0;
  struct nb_rooted *rooted = contacts->kept[NB_NORMAL_ROOT] ? nb_own(owner, n, sizeof *rooted) : NULL;
  if (owner->failed || !create_counters(model, n)) {
    model->blocks.count = 0; /* the counters may already be those of the new blocks, which do not exist */
    return nb_error_memory(error);
  }
  for (size_t v = 0, part = 0; v < n; v++) {
    while (n * (part + 1) / parts <= v)
      part++;
    model->blocks.list[v] =
        block_of(model, start[v], start[v + 1], model->blocks.scratch + part * NB_FIELDS * NB_BLOCK_SIZE);
    model->blocks.list[v].began = began + part * CACHE_LINE;
    model->blocks.list[v].stable_overlap = model->blocks.stable_overlap ? model->blocks.stable_overlap + v : NULL;
    model->blocks.list[v].rooted = rooted ? rooted + v : NULL;
    model->blocks.list[v].deep = model->deep.counts ? model->deep.counts + v * NB_DEEP_STRIDE : NULL;
  }
  model->blocks.count = n;
  return NB_OK;
}
