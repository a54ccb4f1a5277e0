/* Small saved states as text, for the tests of the functions that read states.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include <stddef.h>

/* Statements of pages whose states together contain every kind of record. */
extern const char state_plain[], state_ring[], state_cell[];

/* The state of this page after twenty cycles; the caller frees the text. *size becomes its length in bytes, here and
 * below. */
char *state_of(const char *statements, size_t *size);
/* Such a state with the first `from` replaced by `to`, and with the right checksum; the caller frees the text. */
char *state_changed(const char *statements, const char *from, const char *to, size_t *size);
/* The first `length` bytes of this text of a state, with their checksum; the caller frees the result. */
char *state_sealed(const char *text, size_t length, size_t *size);
