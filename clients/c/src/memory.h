/** Growing memory: the buffers and arenas of playhouse/c/wire.h, and lists of any element. */
#ifndef PLAYHOUSE_C_MEMORY_H
#define PLAYHOUSE_C_MEMORY_H

#include <stdbool.h>

#include "playhouse/c/wire.h"

/** Makes room for `more` bytes at the end; false without memory. */
bool ph_buffer_reserve(ph_buffer *buffer, size_t more);
bool ph_buffer_append(ph_buffer *buffer, const void *bytes, size_t size);

/** Zeroed memory of the arena for `count` elements; NULL without memory. */
void *ph_arena_take(ph_arena *arena, size_t count, size_t size);
/** A copy of `size` bytes with a NUL behind them. */
char *ph_arena_copy(ph_arena *arena, const void *bytes, size_t size);

/** Makes room for element number `count` in a list of `*capacity` elements of `size` bytes; false without
 * memory. */
bool ph_grow(void *list, size_t count, size_t *capacity, size_t size);

/** A copy of a text; NULL without memory. */
char *ph_copy_text(const char *text);

#endif /* PLAYHOUSE_C_MEMORY_H */
