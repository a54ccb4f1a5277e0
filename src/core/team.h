/* A team of threads for the two parallel parts of a cycle: team.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

struct nb_team;

/* Returns a team of `threads` threads: `team` itself if it has this size, else a new one; the old one is then freed. A
 * team starts `threads` - 1 threads, which wait for work; the caller of nb_team_run is the remaining member. If the
 * system starts fewer threads, these and the caller do all parts. NULL: no memory. The caller frees the team. */
struct nb_team *nb_team_sized(struct nb_team *team, int threads);
void nb_team_free(struct nb_team *team); /* ends the threads; team may be NULL */

/* Calls work(data, part) once for each part from 0 to parts - 1, in parallel, and returns when all parts are done. Any
 * thread may do any part. Without a team (NULL), or as long as the team loses time, the caller does all parts. */
void nb_team_run(struct nb_team *team, int parts, void (*work)(void *data, int part), void *data);
