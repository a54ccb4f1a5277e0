/* Included before everything in a file with mutants. A site is an expression that is mutated. The site s with the
 * mutant n becomes `(NB_SITE(s) nb_mutant == n ? mutated : original)`.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#ifndef NB_SCHEMATA_H
#define NB_SCHEMATA_H

extern int nb_mutant;                  /* the chosen mutant; 0: none */
extern unsigned char *nb_site_reached; /* for each site, whether the program has reached it */

#define NB_SITE(s) nb_site_reached[s] = 1,

#endif
