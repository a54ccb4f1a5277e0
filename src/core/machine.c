/* Selects the instruction set and the number of threads, on which no result depends, and sets the rounding mode, on
 * which results depend.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <fenv.h>
#include <string.h>

#include "model.h"
#ifdef _OPENMP
#include <omp.h>
#endif

static enum nb_isa widest_isa(void) {
#if defined __x86_64__ && defined __GNUC__
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
    return NB_AVX512;
  if (__builtin_cpu_supports("avx2"))
    return NB_AVX2;
#endif
  return NB_PLAIN;
}

static const char *const isa_names[NB_ISAS] = {"plain", "avx2", "avx512"};

enum nb_status nb_machine_choose(struct nb_model *model, const struct nb_options *options, struct nb_error *error) {
  model->machine.isa = widest_isa();
  if (options && options->isa) {
    enum nb_isa isa = NB_PLAIN;
    while (isa < NB_ISAS && strcmp(isa_names[isa], options->isa) != 0)
      isa = (enum nb_isa)(isa + 1);
    if (isa == NB_ISAS)
      return nb_error_set(error, NB_BAD_USE, "expected `--isa plain`, `avx2` or `avx512`, found `%s`", options->isa);
    if (isa > model->machine.isa)
      return nb_error_set(error, NB_BAD_USE, "this machine does not run `--isa %s`; the widest that it runs is `%s`",
                          options->isa, isa_names[model->machine.isa]);
    model->machine.isa = isa;
  }
  model->machine.threads = options ? options->threads : 1;
  if (options)
    model->machine.rounding = options->rounding;
#ifdef _OPENMP
  if (model->machine.threads <= 0)
    model->machine.threads = omp_get_max_threads();
#endif
  if (model->machine.threads <= 0)
    model->machine.threads = 1;
  if (model->machine.threads > NB_THREADS)
    model->machine.threads = NB_THREADS;
  return NB_OK;
}

void nb_rounding_set(const struct nb_rounding *rounding, const char *part) {
  static const int modes[NB_ROUNDINGS] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
  const bool chosen = part && (!rounding->part || strcmp(part, rounding->part) == 0);
  fesetround(modes[chosen ? rounding->mode : NB_TO_NEAREST]);
}
