#include "memory.h"

#include <stdlib.h>
#include <string.h>

enum { LEAST_CHUNK = 512 };

/** Memory of an arena; the bytes follow, aligned for everything. */
typedef union chunk {
  struct {
    union chunk *older;
    size_t used, capacity;
  } of;
  max_align_t aligned;
} chunk;

bool ph_buffer_reserve(ph_buffer *buffer, size_t more) {
  if (more > SIZE_MAX / 2 - buffer->size) return false;
  const size_t wanted = buffer->size + more;
  if (wanted <= buffer->capacity) return true;
  size_t capacity = buffer->capacity < 64 ? 64 : 2 * buffer->capacity;
  if (capacity < wanted) capacity = wanted;
  uint8_t *bytes = realloc(buffer->bytes, capacity);
  if (bytes == NULL) return false;
  buffer->bytes = bytes;
  buffer->capacity = capacity;
  return true;
}

bool ph_buffer_append(ph_buffer *buffer, const void *bytes, size_t size) {
  if (!ph_buffer_reserve(buffer, size)) return false;
  if (size > 0) memcpy(buffer->bytes + buffer->size, bytes, size);
  buffer->size += size;
  return true;
}

void ph_buffer_free(ph_buffer *buffer) {
  free(buffer->bytes);
  *buffer = (ph_buffer){NULL, 0, 0};
}

static chunk *add_chunk(ph_arena *arena, size_t size) {
  chunk *older = arena->newest;
  size_t capacity = older != NULL ? 2 * older->of.capacity : LEAST_CHUNK;
  if (capacity > 1 << 16) capacity = 1 << 16;  // a larger one holds one list
  if (capacity < size) capacity = size;
  chunk *made = malloc(sizeof(chunk) + capacity);
  if (made == NULL) return NULL;
  made->of.older = older;
  made->of.used = 0;
  made->of.capacity = capacity;
  arena->newest = made;
  return made;
}

void *ph_arena_take(ph_arena *arena, size_t count, size_t size) {
  const size_t unit = sizeof(max_align_t);
  if (count > (SIZE_MAX / 4) / size) return NULL;
  const size_t bytes = (count * size + unit - 1) / unit * unit;
  chunk *from = arena->newest;
  if (from == NULL || bytes > from->of.capacity - from->of.used) from = add_chunk(arena, bytes);
  if (from == NULL) return NULL;
  void *taken = (char *)(from + 1) + from->of.used;
  from->of.used += bytes;
  memset(taken, 0, bytes);
  return taken;
}

char *ph_arena_copy(ph_arena *arena, const void *bytes, size_t size) {
  char *copy = ph_arena_take(arena, size + 1, 1);
  if (copy != NULL && size > 0) memcpy(copy, bytes, size);
  return copy;
}

void ph_arena_free(ph_arena *arena) {
  chunk *each = arena->newest;
  while (each != NULL) {
    chunk *older = each->of.older;
    free(each);
    each = older;
  }
  arena->newest = NULL;
}

bool ph_grow(void *list, size_t count, size_t *capacity, size_t size) {
  if (count < *capacity) return true;
  const size_t wanted = *capacity < 8 ? 8 : 2 * *capacity;
  void *old = NULL;
  memcpy(&old, list, sizeof old);
  void *grown = realloc(old, wanted * size);
  if (grown == NULL) return false;
  memcpy(list, &grown, sizeof grown);
  *capacity = wanted;
  return true;
}

char *ph_copy_text(const char *text) {
  const size_t size = strlen(text) + 1;
  char *copy = malloc(size);
  if (copy != NULL) memcpy(copy, text, size);
  return copy;
}
