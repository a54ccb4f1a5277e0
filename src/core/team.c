/* A team of threads that share the parts of a cycle. The threads live as long as the model. Each of the two parallel parts
 * of a cycle is a round: the caller announces the work, does part 0, and waits until all members are done.
 *
 * A member that waits looks at the number of the round for some microseconds, because on an idle machine the next round
 * begins within this time. Then it sleeps. So when the system has stopped a member, the waiting ones do not occupy the
 * processor that this member needs to go on.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "team.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>

enum { LOOKS = 200 }; /* looks at the number before a member sleeps; they take 2 to 10 us, with pauses between them */

struct member {
  struct nb_team *team;
  int part;
  pthread_t thread;
};

struct nb_team {
  void (*work)(void *data, int part); /* of the present round; so are the next two members */
  void *data;
  int parts;
  bool ends;         /* the next round is the end of the threads */
  atomic_uint round; /* number of rounds so far */
  atomic_int busy;   /* members that have not finished the present round */
  pthread_mutex_t lock;
  pthread_cond_t begun, done; /* a round has begun; all members are done */
  int size;                   /* threads asked for, with the caller */
  int count;                  /* threads that the system has started */
  struct member members[];
};

static void pause_briefly(void) {
#if defined __x86_64__ && defined __GNUC__
  __builtin_ia32_pause();
#endif
}

static void await_round(struct nb_team *team, unsigned last) {
  for (int k = 0; k < LOOKS; k++, pause_briefly())
    if (atomic_load(&team->round) != last)
      return;
  pthread_mutex_lock(&team->lock);
  while (atomic_load(&team->round) == last)
    pthread_cond_wait(&team->begun, &team->lock);
  pthread_mutex_unlock(&team->lock);
}

static void await_members(struct nb_team *team) {
  for (int k = 0; k < LOOKS; k++, pause_briefly())
    if (atomic_load(&team->busy) == 0)
      return;
  pthread_mutex_lock(&team->lock);
  while (atomic_load(&team->busy) > 0)
    pthread_cond_wait(&team->done, &team->lock);
  pthread_mutex_unlock(&team->lock);
}

static void begin_round(struct nb_team *team) {
  atomic_store(&team->busy, team->count);
  pthread_mutex_lock(&team->lock);
  atomic_fetch_add(&team->round, 1);
  pthread_cond_broadcast(&team->begun);
  pthread_mutex_unlock(&team->lock);
}

static void *live(void *argument) {
  const struct member *member = argument;
  struct nb_team *team = member->team;
  for (unsigned last = 0;; last++) {
    await_round(team, last);
    if (team->ends)
      return NULL;
    if (member->part < team->parts)
      team->work(team->data, member->part);
    if (atomic_fetch_sub(&team->busy, 1) == 1) {
      pthread_mutex_lock(&team->lock);
      pthread_cond_signal(&team->done);
      pthread_mutex_unlock(&team->lock);
    }
  }
}

void nb_team_free(struct nb_team *team) {
  if (!team)
    return;
  team->ends = true;
  begin_round(team);
  for (int m = 0; m < team->count; m++)
    pthread_join(team->members[m].thread, NULL);
  pthread_mutex_destroy(&team->lock);
  pthread_cond_destroy(&team->begun);
  pthread_cond_destroy(&team->done);
  free(team);
}

struct nb_team *nb_team_sized(struct nb_team *old, int threads) {
  if (old && old->size == threads)
    return old;
  nb_team_free(old);
  struct nb_team *team = calloc(1, sizeof *team + (size_t)threads * sizeof *team->members);
  if (!team)
    return NULL;
  team->size = threads;
  pthread_mutex_init(&team->lock, NULL);
  pthread_cond_init(&team->begun, NULL);
  pthread_cond_init(&team->done, NULL);
  for (int part = 1; part < threads; part++) {
    struct member *member = &team->members[team->count];
    *member = (struct member){.team = team, .part = part};
    if (pthread_create(&member->thread, NULL, live, member) != 0)
      break;
    team->count++;
  }
  return team;
}

void nb_team_run(struct nb_team *team, int parts, void (*work)(void *data, int part), void *data) {
  const int count = team && parts > 1 ? team->count : 0;
  if (count > 0) {
    team->work = work, team->data = data, team->parts = parts;
    begin_round(team);
  }
  work(data, 0);
  for (int part = count + 1; part < parts; part++)
    work(data, part);
  if (count > 0)
    await_members(team);
}
