/* A team of threads that share the parts of a cycle. The threads live as long as the model. Each of the two parallel
 * parts of a cycle is a round of several parts for each thread: the caller announces the work, and each thread does its
 * own parts and then those that other threads have not begun. The caller goes on when all parts are done. It does not
 * wait for a thread that has begun none of them, for example because the system runs another program instead.
 *
 * A thread that waits looks for a change for some ten microseconds, because on an idle machine the next round begins
 * within this time. Then it sleeps, and its processor is free for a thread that the system has stopped.
 *
 * A thread may also be stopped within a part, for as long as other programs run. So the caller compares the time that
 * it waits with the time that it saves. If the team has lost time, the caller does all parts, for twenty times as long
 * as the loss. Who does a part changes no result.
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

/* Looks before a thread sleeps. With the pauses between them they take 10 to 50 us, as long as a part of a cycle of ten
 * thousand particles. With a fifth of them a thread often slept while the last part was done, and waking it took
 * longer. */
enum { LOOKS = 1000 };

/* A thread of the team; number 0 is the caller. */
struct member {
  struct nb_team *team;
  int number;
  pthread_t thread;
  /* Its parts of the present round that nobody has begun: the end in the upper half, the first one in the lower half.
   * The lower half may exceed the upper one. */
  _Alignas(64) _Atomic uint64_t parts; /* in a cache line of its own */
};

/* What the team has saved, s. */
struct balance {
  double part;  /* duration of a part: the least of the last ones, s */
  double saved; /* since the last rest, s; negative: lost */
  double rest;  /* time until which the caller does all parts, s */
};

struct nb_team {
  void (*work)(void *data, int part); /* of the present round; so are the next two members */
  void *data;
  int parts;
  atomic_bool ends;  /* the next round is the end of the threads */
  atomic_uint round; /* number of rounds so far */
  atomic_int done;   /* parts of the present round that are done */
  pthread_mutex_t lock;
  pthread_cond_t begun, finished; /* a round has begun; all its parts are done */
  struct balance balance;         /* only the caller uses it */
  int size;                       /* threads asked for, with the caller */
  int count;                      /* threads that the system has started */
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

/* The next part of a member that nobody has begun; -1: there is none. While a part that was begun is not done, the
 * round cannot end, so `work`, `data` and `parts` are those of this part. */
static int begin_part(struct member *owner) {
  const uint64_t parts = atomic_fetch_add(&owner->parts, 1);
  return (uint32_t)parts < parts >> 32 ? (int)(uint32_t)parts : -1;
}

/* Does parts until all have been begun: first those of the thread itself. Returns their number. */
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

static void *live(void *argument) {
  const struct member *member = argument;
  struct nb_team *team = member->team;
  for (unsigned last = 0;;) {
    await_round(team, last);
    last = atomic_load(&team->round);
    if (atomic_load(&team->ends)) /* read after `round`: the last round is that of the end, and no other one follows */
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
    if (pthread_create(&members[m].thread, NULL, live, &members[m]) != 0)
      break;
    team->count++;
  }
  return team;
}

/* ---- whether the team saves time ---- */

static const double most_saved = 0.02, /* s; earlier savings do not count any more */
    most_lost = 0.0002,                /* s; then the caller does all parts */
    rests_per_loss = 20, /* time in which the caller does all parts, over the loss: a run takes at most 1/20 longer */
    longest_rest = 1,    /* s; the clock may have been set, or the machine may have been suspended */
    growth = 1.02;       /* of the duration of a part in a round, so that an old least duration is forgotten */

/* Times of a round, s. */
struct times {
  double begin, announced, worked, end;
};

/* Adds what a round has saved: the time of the parts that the caller did not do, minus that of announcing and waiting.
 * The duration of a part is the least one, because the caller may have been stopped too. */
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
