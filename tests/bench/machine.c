/* Measures what one core of this machine can do at most: clock, arithmetic, square roots, divisions, gathers, and the
 * bandwidth of caches and memory. docs/PERFORMANCE.md compares the passes of a cycle with these rates.
 *
 * Each rate is the greatest of many short repeats, which other programs hardly disturb. This is not a test: it prints
 * one line for each rate, and fails only if there is not enough memory. Columns, separated by tabs: quantity, unit,
 * value with vectors of four doubles (AVX2), value with vectors of eight (AVX-512); `-`: this machine lacks these
 * instructions.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#if defined __x86_64__
#include <immintrin.h>

enum { REPEATS = 200, STEPS = 20000, CHAINS = 12, LINE = 8 };

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* The compiler must assume that this value is used and changed. */
#define OPAQUE(x) __asm__ volatile("" : "+v"(x))

typedef double four __attribute__((vector_size(32)));
typedef double eight __attribute__((vector_size(64)));

#define EACH(DO, ...)                                                                                                  \
  DO(0, __VA_ARGS__)                                                                                                   \
  DO(1, __VA_ARGS__)                                                                                                   \
  DO(2, __VA_ARGS__)                                                                                                   \
  DO(3, __VA_ARGS__)                                                                                                   \
  DO(4, __VA_ARGS__)                                                                                                   \
  DO(5, __VA_ARGS__)                                                                                                   \
  DO(6, __VA_ARGS__)                                                                                                   \
  DO(7, __VA_ARGS__)                                                                                                   \
  DO(8, __VA_ARGS__)                                                                                                   \
  DO(9, __VA_ARGS__)                                                                                                   \
  DO(10, __VA_ARGS__)                                                                                                  \
  DO(11, __VA_ARGS__)
#define BEGIN(k, VECTOR) VECTOR x##k = (VECTOR){0} + 1 + 1e-3 * k;
#define APPLY(k, F)                                                                                                    \
  x##k = F(x##k);                                                                                                      \
  OPAQUE(x##k);

/* Defines a function that applies F, which may use b and c, to CHAINS independent vectors, STEPS times. */
#define ARITHMETIC(NAME, TARGET, VECTOR, F)                                                                            \
  __attribute__((target(TARGET), noinline)) static void NAME(void) {                                                   \
    VECTOR b = (VECTOR){0} + 1.0000001, c = (VECTOR){0} + 1e-9;                                                        \
    EACH(BEGIN, VECTOR)                                                                                                \
    OPAQUE(b);                                                                                                         \
    OPAQUE(c);                                                                                                         \
    for (int s = 0; s < STEPS; s++) {                                                                                  \
      EACH(APPLY, F)                                                                                                   \
    }                                                                                                                  \
  }

#define SUM(x) (x) + c
#define PRODUCT(x) (x) * b
#define QUOTIENT(x) b / (x)
#define ROOT_FOUR(x) (four) _mm256_sqrt_pd((__m256d)(x))
#define ROOT_EIGHT(x) (eight) _mm512_sqrt_pd((__m512d)(x))
ARITHMETIC(sum_four, "avx2", four, SUM)
ARITHMETIC(sum_eight, "avx512f", eight, SUM)
ARITHMETIC(product_four, "avx2", four, PRODUCT)
ARITHMETIC(product_eight, "avx512f", eight, PRODUCT)
ARITHMETIC(quotient_four, "avx2", four, QUOTIENT)
ARITHMETIC(quotient_eight, "avx512f", eight, QUOTIENT)
ARITHMETIC(root_four, "avx2", four, ROOT_FOUR)
ARITHMETIC(root_eight, "avx512f", eight, ROOT_EIGHT)

/* A chain of dependent additions, one in each clock cycle. Both operands are registers, because some processors add a
 * constant in no time. */
static void dependent(void) {
  unsigned long x = 1, y = 3;
  __asm__ volatile("" : "+r"(y));
  for (int s = 0; s < STEPS; s++)
    _Pragma("GCC unroll 12") for (int k = 0; k < CHAINS; k++) {
      x += y;
      __asm__ volatile("" : "+r"(x));
    }
}

/* Gathers from an array in the first cache. */
static double table[512];
static int indices[512];
__attribute__((target("avx2"), noinline)) static void gather_four(void) {
  __m256d sum = _mm256_setzero_pd();
  for (int s = 0; s < STEPS; s++) {
    const __m128i at = _mm_loadu_si128((const __m128i *)(indices + 4 * (s % 128)));
    sum = _mm256_add_pd(sum, _mm256_i32gather_pd(table, at, 8));
  }
  OPAQUE(sum);
}
__attribute__((target("avx512f"), noinline)) static void gather_eight(void) {
  __m512d sum = _mm512_setzero_pd();
  for (int s = 0; s < STEPS; s++) {
    const __m256i at = _mm256_loadu_si256((const __m256i *)(indices + 8 * (s % 64)));
    sum = _mm512_add_pd(sum, _mm512_i32gather_pd(at, table, 8));
  }
  OPAQUE(sum);
}

/* read_NAME reads `length` doubles; copy_NAME copies the first half of them to the second half. */
static double *array;
static size_t length;
#define MEMORY(NAME, TARGET, VECTOR)                                                                                   \
  __attribute__((target(TARGET), noinline)) static void read_##NAME(void) {                                            \
    const VECTOR *from = (const VECTOR *)array, *end = from + length / (sizeof(VECTOR) / sizeof(double));              \
    VECTOR sum[LINE] = {{0}};                                                                                          \
    for (; from < end; from += LINE)                                                                                   \
      _Pragma("GCC unroll 8") for (int k = 0; k < LINE; k++) sum[k] += from[k];                                        \
    for (int k = 0; k < LINE; k++)                                                                                     \
      OPAQUE(sum[k]);                                                                                                  \
  }                                                                                                                    \
  __attribute__((target(TARGET), noinline)) static void copy_##NAME(void) {                                            \
    const VECTOR *from = (const VECTOR *)array, *end = from + length / 2 / (sizeof(VECTOR) / sizeof(double));          \
    VECTOR *to = (VECTOR *)(array + length / 2);                                                                       \
    for (; from < end; from += LINE, to += LINE)                                                                       \
      _Pragma("GCC unroll 8") for (int k = 0; k < LINE; k++) {                                                         \
        VECTOR v = from[k];                                                                                            \
        OPAQUE(v);                                                                                                     \
        to[k] = v;                                                                                                     \
      }                                                                                                                \
  }
MEMORY(four, "avx2", four)
MEMORY(eight, "avx512f", eight)

/* Calls the function `repeats` times. Returns the greatest rate, in 1e9 units per second; one call does `units` of
 * them. */
static double rate(void (*function)(void), double units, int repeats) {
  double least = 1e300;
  for (int k = 0; k < repeats; k++) {
    const double begin = now();
    function();
    const double time = now() - begin;
    least = time < least ? time : least;
  }
  return units / least * 1e-9;
}

/* Prints a line of the output. The function `narrow` has vectors of four doubles and does `of_four` units in a call;
 * `wide` has vectors of eight and does `of_eight`. */
static void line(const char *what, const char *unit, void (*narrow)(void), double of_four, void (*wide)(void),
                 double of_eight, int repeats) {
  printf("%s\t%s\t", what, unit);
  if (__builtin_cpu_supports("avx2"))
    printf("%.3g\t", rate(narrow, of_four, repeats));
  else
    printf("-\t");
  if (__builtin_cpu_supports("avx512f"))
    printf("%.3g\n", rate(wide, of_eight, repeats));
  else
    printf("-\n");
}

int main(void) {
  const double steps = (double)STEPS * CHAINS;
  const double clock = rate(dependent, steps, REPEATS);
  printf("clock\tGHz\t%.3g\t%.3g\n", clock, clock);
  line("additions", "1e9/s", sum_four, 4 * steps, sum_eight, 8 * steps, REPEATS);
  line("multiplications", "1e9/s", product_four, 4 * steps, product_eight, 8 * steps, REPEATS);
  line("divisions", "1e9/s", quotient_four, 4 * steps, quotient_eight, 8 * steps, REPEATS);
  line("square roots", "1e9/s", root_four, 4 * steps, root_eight, 8 * steps, REPEATS);
  for (int k = 0; k < 512; k++)
    indices[k] = k * 197 % 512;
  line("gathered doubles, first cache", "1e9/s", gather_four, 4. * STEPS, gather_eight, 8. * STEPS, REPEATS);
  static const struct {
    size_t bytes;
    const char *read, *copy;
  } sizes[] = {{32 << 10, "read, 32 KiB", "copy, 32 KiB"},
               {1 << 20, "read, 1 MiB", "copy, 1 MiB"},
               {16 << 20, "read, 16 MiB", "copy, 16 MiB"},
               {512 << 20, "read, 512 MiB", "copy, 512 MiB"}};
  for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
    array = aligned_alloc(64, sizes[s].bytes);
    if (!array)
      return 3;
    length = sizes[s].bytes / sizeof *array;
    for (size_t k = 0; k < length; k++)
      array[k] = 1;
    const double bytes = (double)sizes[s].bytes;
    const int repeats = sizes[s].bytes > 100 << 20 ? 10 : REPEATS;
    line(sizes[s].read, "GB/s", read_four, bytes, read_eight, bytes, repeats);
    line(sizes[s].copy, "GB/s, read and written", copy_four, bytes, copy_eight, bytes, repeats);
    free(array);
  }
}
#else
int main(void) { fputs("machine: only processors of the x86-64 kind are measured\n", stderr); }
#endif
