/* Between explain.c and explain_changes.c.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_EXPLAIN_H
#define NB_EXPLAIN_H

#include "core/model.h"
#include "laws/laws_now.h"

void nb_explain_gravity(FILE *out, const struct nb_gravity *gravity, const char *unit); /* nothing where none is said */
/* What the stage changes, beginning from what is `now`, which is moved on to its end; false: no memory. */
bool nb_explain_changes(FILE *out, const struct nb_model *model, const struct nb_stage *stage,
                        struct nb_properties *now);

/* explain_drive.c: what moves the assembly; nothing where nothing is said. */
void nb_explain_drive(FILE *out, const struct nb_model *model, const struct nb_stage *stage);
void nb_explain_circle(FILE *out, const struct nb_circle *circle, bool unitless);

/* explain_region.c: what is measured together, and who looks at it. */
void nb_explain_regions(FILE *out, const struct nb_model *model);

/* explain_fill.c: what became of every filling. */
void nb_explain_fills(FILE *out, const struct nb_scene *scene);

#endif
