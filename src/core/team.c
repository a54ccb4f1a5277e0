/* A team of threads that share the work of a cycle. The threads live as long as the model. A cycle has two rounds, the
 * motion and the forces. The work of a round is divided into parts, several for each thread. The caller announces the
 * round; each thread does its own parts and then those that other threads have not begun. The caller goes on when all
 * parts are done. It does not wait for a thread that has begun no part, for example because the system runs another
 * program instead.
 *
 * A thread that waits looks for a change for 10 to 50 microseconds, because on an idle machine the next round begins
 * within this time. Then it sleeps, and its processor is free for a thread that the system has stopped.
 *
 * The system may also stop a thread within a part, for as long as other programs run. So the caller compares the time
 * that it waits with the time that the team saves. If the team has lost more than 0.2 ms, the caller does all parts,
 * for twenty times as long as the loss, but at most for 1 s. No result depends on which thread does a part.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "team.h"

#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

#include "array.h"
#include "clock.h"

/* Number of looks before a thread sleeps. With the pauses between them they take 10 to 50 us, as long as a part of a
 * cycle of ten thousand particles. With a fifth of this number a thread often slept while the last part was done, and
 * waking the thread took longer than that part. */
enum { LOOKS = 1000 };

/* A thread of the team; number 0 is the caller. */
struct member {
  struct nb_team *team;
  int number;
  pthread_t thread;
  /* Its parts of the present round that no thread has begun: from the number in the lower 32 bits to that in the upper
   * 32 bits minus 1. The lower number may exceed the upper one. */
  _Alignas(64) _Atomic uint64_t parts; /* in a cache line of its own */
};

/* What the team has saved. */
struct balance {
  double part;  /* duration of a part: the shortest of the last rounds, s */
  double saved; /* since the last rest, s; negative: lost */
  double rest;  /* time until which the caller does all parts, s */
};

struct nb_team {
  void (*work)(void *data, int part); /* of the present round; so are the next two members */
  void *data;
  int parts;
  atomic_bool ends;  /* the threads end when the next round begins */
  atomic_uint round; /* number of rounds so far */
  atomic_int done;   /* parts of the present round that are done */
  pthread_mutex_t lock;
  pthread_cond_t begun, finished; /* a round has begun; all its parts are done */
  struct balance balance;         /* only the caller uses it */
  int size;                       /* number of threads that was asked for, with the caller */
  int count;                      /* number of threads that the system has started */
  struct member *members;         /* `size` of them */
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

static void await_parts(struct nb_team *team) {
  for (int k = 0; k < LOOKS; k++, pause_briefly())
    if (atomic_load(&team->done) == team->parts)
      return;
  pthread_mutex_lock(&team->lock);
  while (atomic_load(&team->done) < team->parts)
    pthread_cond_wait(&team->finished, &team->lock);
  pthread_mutex_unlock(&team->lock);
}

/* Begins the next part of a member, and returns its number; -1: all parts of the member have been begun. The round
 * cannot end before this part is done, so `work`, `data` and `parts` are those of its round until then. */
static int begin_part(struct member *owner) {
  const uint64_t parts = atomic_fetch_add(&owner->parts, 1);
  return (uint32_t)parts < parts >> 32 ? (int)(uint32_t)parts : -1;
}

/* Does parts until all parts have been begun: first those of the member `self`, then those of the others. Returns the
 * number of parts that it has done. */
static int do_parts(struct nb_team *team, int self) {
  int count = 0;
  for (int k = 0; k < team->size; k++) {
    struct member *owner = &team->members[(self + k) % team->size];
    for (int part = begin_part(owner); part >= 0; part = begin_part(owner), count++) {
      const int parts = team->parts;
      team->work(team->data, part);
      if (atomic_fetch_add(&team->done, 1) + 1 == parts && self > 0) {
        pthread_mutex_lock(&team->lock);
        pthread_cond_signal(&team->finished);
        pthread_mutex_unlock(&team->lock);
      }
    }
  }
  return count;
}

static void begin_round(struct nb_team *team, int parts) {
  atomic_store(&team->done, 0);
  for (int m = 0; m < team->size; m++) {
    const uint64_t from = (uint64_t)(parts * m / team->size), to = (uint64_t)(parts * (m + 1) / team->size);
    atomic_store(&team->members[m].parts, to << 32 | from);
  }
  pthread_mutex_lock(&team->lock);
  atomic_fetch_add(&team->round, 1);
  pthread_cond_broadcast(&team->begun);
  pthread_mutex_unlock(&team->lock);
}

static void *run_member(void *argument) {
  const struct member *member = argument;
  struct nb_team *team = member->team;
  for (unsigned last = 0;;) {
    await_round(team, last);
    last = atomic_load(&team->round);
    if (atomic_load(&team->ends)) /* read after `round`: after the round that ends the threads, no other one follows */
      return NULL;
    do_parts(team, member->number);
  }
}

void nb_team_free(struct nb_team *team) {
  if (!team)
    return;
  atomic_store(&team->ends, true);
  begin_round(team, 0);
  for (int m = 1; m <= team->count; m++)
    pthread_join(team->members[m].thread, NULL);
  pthread_mutex_destroy(&team->lock);
  pthread_cond_destroy(&team->begun);
  pthread_cond_destroy(&team->finished);
  free(team->members);
  free(team);
}

struct nb_team *nb_team_sized(struct nb_team *old, int threads) {
  if (old && old->size == threads)
    return old;
  nb_team_free(old);
  struct nb_team *team = calloc(1, sizeof *team);
  struct member *members = nb_array((size_t)threads, sizeof *members);
  if (!team || !members) {
    free(team), free(members);
    return NULL;
  }
  team->size = threads;
  team->members = members;
  team->balance.part = INFINITY;
  pthread_mutex_init(&team->lock, NULL);
  pthread_cond_init(&team->begun, NULL);
  pthread_cond_init(&team->finished, NULL);
  for (int m = 1; m < threads; m++) {
    members[m].team = team, members[m].number = m;
    if (pthread_create(&members[m].thread, NULL, run_member, &members[m]) != 0)
      break;
    team->count++;
  }
  return team;
}

/* ---- whether the team saves time ---- */

static const double most_saved = 0.02, /* s; larger savings count as this, so that old ones are forgotten */
    most_lost = 0.0002,                /* s; after a larger loss the caller does all parts */
    rests_per_loss = 20, /* time in which the caller does all parts, over the loss: losses of less than 50 ms make a run
                          * at most 1/20 longer */
    longest_rest = 1,    /* s; no rest is longer, not even after a larger loss or if the clock is set back */
    growth = 1.02;       /* factor per round of the stored duration of a part, so that an old one is forgotten */

/* Times at which a round has begun, has been announced, the caller has done its parts, and all parts are done, s. */
struct times {
  double begin, announced, worked, end;
};

/* Adds what a round has saved: the time of the parts that the caller did not do, minus the time of announcing and
 * waiting. `own`: number of the parts that the caller did. The duration of a part is the shortest one, because the
 * caller may have been stopped too. */
static void add_round(struct balance *balance, const struct times *times, int own, int parts) {
  const double part = own > 0 ? (times->worked - times->announced) / own : INFINITY;
  if (part > 0)
    balance->part = fmin(balance->part * growth, part);
  if (!(balance->part < INFINITY))
    return;
  balance->saved += balance->part * (parts - own) - (times->announced - times->begin) - (times->end - times->worked);
  balance->saved = fmin(balance->saved, most_saved);
  if (balance->saved < -most_lost) {
    balance->rest = times->end + fmin(-rests_per_loss * balance->saved, longest_rest);
    balance->saved = 0;
  }
}

static bool rests(const struct balance *balance, double now) {
  return now < balance->rest && balance->rest - now <= longest_rest;
}

void nb_team_run(struct nb_team *team, int parts, void (*work)(void *data, int part), void *data) {
  struct times times = {.begin = team && parts > 1 ? nb_clock() : 0};
  if (!team || parts < 2 || team->count == 0 || rests(&team->balance, times.begin)) {
    for (int part = 0; part < parts; part++)
      work(data, part);
    return;
  }
  team->work = work, team->data = data, team->parts = parts;
  begin_round(team, parts);
  times.announced = nb_clock();
  const int own = do_parts(team, 0);
  times.worked = nb_clock();
  await_parts(team);
  times.end = nb_clock();
  add_round(&team->balance, &times, own, parts);
}
