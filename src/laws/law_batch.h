/* A law over a block, for each instruction set, and its row in the register. Included by the last line of a law's file, which
 * says before:
 *
 *   #define LAW     shear_linear            its function, and its file's name
 *   #define SHEAR   or  #define NORMAL      which of the two shapes it has
 *   #define TITLE   "..."                   one line
 *   #define SOURCE  "[CS79 17-19]"          where the equations come from
 *   #define MEMORY  1                       doubles it remembers per contact, up to 4
 *   #define NEEDS   NB_BIT(NB_CLOSING)      fields it reads besides the ones every law is given (optional)
 *   #define STORED  shear_linear_stored     its elastic energy (optional)
 *   #define BRANCHING, #define GAINS        (optional, see law.h)
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */

#define LAW_JOIN_(a, b) a##b
#define LAW_JOIN(a, b) LAW_JOIN_(a, b)
#define LAW_TEXT_(a) #a
#define LAW_TEXT(a) LAW_TEXT_(a)
#define LAW_FORMS(name) NB_FORMS(name)
#define LAW_LIST(name) NB_FORMS_LIST(name)
#define LAW_BLOCK LAW_JOIN(LAW, _block)

#ifndef NEEDS
#define NEEDS 0
#endif

#ifdef NORMAL
#define LAW_MEMORY view->normal_memory
#else
#define LAW_MEMORY view->shear_memory
#endif

static inline NB_FORM void LAW_BLOCK(const struct nb_model *model, const struct nb_view *view) {
  (void)model;
  const struct nb_pair p = *(const struct nb_pair *)view->pairing; /* a pairing begins with its constants */
  const double *overlap = view->f[NB_OVERLAP];
  double *const m0 = LAW_MEMORY[0], *const m1 = LAW_MEMORY[1], *const m2 = LAW_MEMORY[2], *const m3 = LAW_MEMORY[3];
#ifdef NORMAL
  const double *closing = view->f[NEEDS & NB_BIT(NB_CLOSING) ? NB_CLOSING : NB_OVERLAP];
  double *force = view->f[NB_NORMAL], *stiffness = view->f[NB_STIFFNESS], *radius = view->f[NB_RADIUS];
#else
  const double *slip = view->f[NB_SLIP], *normal = view->f[NB_NORMAL], *hardness = view->f[NB_STIFFNESS];
  const double *radius = view->f[NB_RADIUS];
  double *force = view->f[NB_SHEAR], *stiffness = view->f[NB_SHEAR_STIFFNESS], *sliding = view->f[NB_SLIDING];
#endif
#ifndef BRANCHING
  NB_WIDE
#endif
  for (size_t c = 0; c < view->n; c++) {
    double m[NB_MEMORY];
    m[0] = MEMORY > 0 ? m0[c] : 0, m[1] = MEMORY > 1 ? m1[c] : 0, m[2] = MEMORY > 2 ? m2[c] : 0,
    m[3] = MEMORY > 3 ? m3[c] : 0;
#ifdef NORMAL
    const struct nb_normal out = LAW(p, overlap[c], closing[c], m);
    radius[c] = out.radius;
#else
    const struct nb_shear out = LAW(p, (struct nb_normal){normal[c], hardness[c], radius[c]}, slip[c], m);
    sliding[c] = out.sliding;
#endif
    force[c] = out.force;
    stiffness[c] = out.stiffness;
    const bool touching = overlap[c] > 0; /* what is remembered ends with the contact */
    if (MEMORY > 0)
      m0[c] = touching ? m[0] : 0;
    if (MEMORY > 1)
      m1[c] = touching ? m[1] : 0;
    if (MEMORY > 2)
      m2[c] = touching ? m[2] : 0;
    if (MEMORY > 3)
      m3[c] = touching ? m[3] : 0;
  }
}

LAW_FORMS(LAW_BLOCK)

extern const struct nb_law LAW_JOIN(law_, LAW);
const struct nb_law LAW_JOIN(law_, LAW) = {
#ifdef NORMAL
    .kind = "normal",
    .name = &LAW_TEXT(LAW)[sizeof "normal_" - 1],
    .normal = LAW,
#else
    .kind = "shear",
    .name = &LAW_TEXT(LAW)[sizeof "shear_" - 1],
    .shear = LAW,
#endif
#ifdef BRANCHING
    .branching = true,
#endif
#ifdef GAINS
    .gains = true,
#endif
#ifdef STORED
    .stored = STORED,
#endif
    .title = TITLE,
    .source = SOURCE,
    .memory = MEMORY,
    .needs = NEEDS,
    .run = LAW_LIST(LAW_BLOCK),
};
