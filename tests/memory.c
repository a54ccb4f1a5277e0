/* Memory for the history of contacts: one field per variable if there are few variables, one row per contact if there
 * are many. The last test checks arrays that stay when other arrays of their owner are freed.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>

#include "../src/core/model.h"
#include "suites.h"

enum { CONTACTS = 40000, FEW = NB_HISTORY, MANY = 20 };

/* Sets the history variables of a contact to first, first + 1, ... */
static void put(struct nb_history *memory, size_t contact, double first) {
  for (int m = 0; m < memory->doubles; m++)
    *(memory->rows ? &memory->rows[contact * (size_t)memory->doubles + (size_t)m] : &memory->field[m][contact]) =
        first + m;
}

/* Asserts that the first `doubles` history variables of a contact are first, first + 1, ... */
static void holds(const struct nb_history *memory, size_t contact, double first, int doubles) {
  double room[NB_HISTORY];
  const double *seen = nb_history_read(memory, contact, room);
  for (int m = 0; m < doubles; m++)
    CU_ASSERT_EQUAL(seen[m], first + m);
}

static void kept(int doubles) {
  struct nb_owner owner = {NULL};
  struct nb_history memory = nb_history_create(&owner, doubles, CONTACTS);
  CU_ASSERT_FATAL(!owner.failed);
  CU_ASSERT_EQUAL(memory.doubles, doubles);
  CU_ASSERT_EQUAL(memory.rows != NULL, doubles > NB_HISTORY);
  for (size_t c = 0; c < CONTACTS; c++)
    put(&memory, c, 100. * (double)c);
  for (size_t c = 0; c < CONTACTS; c += 777)
    holds(&memory, c, 100. * (double)c, doubles);
  const struct nb_history from = nb_history_from(&memory, 300);
  holds(&from, 7, 30700, doubles);
  nb_history_copy(&memory, 5, &memory, 9);
  holds(&memory, 5, 900, doubles);
  holds(&memory, 4, 400, doubles);
  holds(&memory, 6, 600, doubles);
  nb_history_forget(&memory, 5);
  double room[NB_HISTORY];
  CU_ASSERT_EQUAL(nb_history_read(&memory, 5, room)[0], 0);
  if (doubles <= NB_HISTORY)
    for (int m = 0; m < NB_HISTORY; m++)
      CU_ASSERT_EQUAL(nb_history_read(&memory, 5, room)[m], 0);
  holds(&memory, 4, 400, doubles);
  holds(&memory, 6, 600, doubles);
  nb_owner_free(&owner);
  CU_ASSERT_EQUAL(owner.count, 0);
}

static void few(void) {
  for (int doubles = 0; doubles <= FEW; doubles++)
    kept(doubles);
}
static void many(void) {
  kept(FEW + 1);
  kept(MANY);
  struct nb_owner owner = {NULL};
  struct nb_history memory = nb_history_create(&owner, NB_HISTORY_MAX, 1);
  CU_ASSERT_FATAL(!owner.failed);
  CU_ASSERT_EQUAL(memory.doubles, NB_HISTORY_MAX);
  nb_owner_free(&owner);
}

/* A variable without a field reads as 0. Between histories of different lengths, only the variables that both have are
 * copied. */
static void different_lengths(void) {
  static const int sizes[][2] = {{1, FEW}, {FEW, 1}, {FEW + 1, MANY}, {MANY, FEW + 1}};
  for (int k = 0; k < 4; k++) {
    double room[NB_HISTORY];
    const int both = sizes[k][0] < sizes[k][1] ? sizes[k][0] : sizes[k][1];
    struct nb_owner owner = {NULL};
    struct nb_history from = nb_history_create(&owner, sizes[k][0], 5), to = nb_history_create(&owner, sizes[k][1], 5);
    CU_ASSERT_FATAL(!owner.failed);
    put(&from, 2, 10), put(&from, 3, 50), put(&to, 2, 200), put(&to, 1, 100), put(&to, 3, 300);
    nb_history_copy(&to, 2, &from, 3);
    holds(&to, 2, 50, both);
    holds(&to, 1, 100, sizes[k][1]);
    holds(&to, 3, 300, sizes[k][1]);
    const double *seen = nb_history_read(&to, 2, room);
    for (int m = both; m < sizes[k][1]; m++)
      CU_ASSERT_EQUAL(seen[m], 200 + m);
    for (int m = sizes[k][0]; m < NB_HISTORY && k < 2; m++)
      CU_ASSERT_EQUAL(nb_history_read(&from, 3, room)[m], 0);
    nb_owner_free(&owner);
  }
}

/* Nothing is copied between fields and rows. */
static void fields_and_rows(void) {
  for (int rows = 0; rows < 2; rows++) {
    struct nb_owner owner = {NULL};
    struct nb_history from = nb_history_create(&owner, rows ? MANY : FEW, 5);
    struct nb_history to = nb_history_create(&owner, rows ? FEW : MANY, 5);
    CU_ASSERT_FATAL(!owner.failed);
    put(&from, 3, 50), put(&to, 2, 200);
    nb_history_copy(&to, 2, &from, 3);
    holds(&to, 2, 200, to.doubles);
    nb_owner_free(&owner);
  }
}

/* nb_owner_keep frees all arrays of an owner except the listed ones, and sets the owner's pointers to the freed arrays
 * to NULL. AddressSanitizer reports an array that is freed twice or never. */
static void listed_arrays_stay(void) {
  struct nb_owner owner = {NULL};
  double *array[4];
  for (int k = 0; k < 4; k++)
    array[k] = nb_own(&owner, 100, sizeof(double));
  CU_ASSERT_FATAL(!owner.failed);
  array[1][99] = 7, array[3][99] = 9;
  void *const kept[] = {array[3], NULL, array[1]};
  nb_owner_keep(&owner, kept, sizeof kept / sizeof *kept);
  CU_ASSERT_PTR_NULL(owner.list[0]);
  CU_ASSERT_PTR_EQUAL(owner.list[1], array[1]);
  CU_ASSERT_PTR_NULL(owner.list[2]);
  CU_ASSERT_PTR_EQUAL(owner.list[3], array[3]);
  CU_ASSERT_EQUAL(array[1][99] + array[3][99], 16);
  nb_owner_keep(&owner, NULL, 0);
  CU_ASSERT_PTR_NULL(owner.list[1]);
  nb_owner_free(&owner);
  CU_ASSERT_EQUAL(owner.count, 0);
}

void suite_memory(void) {
  CU_pSuite suite = CU_add_suite("memory", NULL, NULL);
  CU_add_test(suite, "history of few variables", few);
  CU_add_test(suite, "history of many variables", many);
  CU_add_test(suite, "copies between histories of different lengths", different_lengths);
  CU_add_test(suite, "no copies between fields and rows", fields_and_rows);
  CU_add_test(suite, "listed arrays stay", listed_arrays_stay);
}
