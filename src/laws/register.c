/* The register of laws. The build makes laws-register.h from LAWS in build-aux/lists.mk, with one line such as
 * NB_LAW(normal_linear) for each law.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "law.h"

#define NB_LAW(name) extern const struct nb_law law_##name;
#include "laws-register.h"
#undef NB_LAW

static const struct nb_law *const laws[] = {
#define NB_LAW(name) &law_##name,
#include "laws-register.h"
#undef NB_LAW
    NULL,
};

const struct nb_law *const *nb_laws(void) { return laws; }

const struct nb_law *nb_law_find(const char *kind, const char *name) {
  for (const struct nb_law *const *law = laws; *law; law++)
    if (strcmp((*law)->kind, kind) == 0 && strcmp((*law)->name, name) == 0)
      return *law;
  return NULL;
}
