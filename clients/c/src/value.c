#include "value.h"

#include <stdlib.h>

#include "fail.h"
#include "memory.h"

/** A value with its owners; `shared` is first, so that one is the other. */
typedef struct owned_value {
  ph_value shared;
  size_t owners;
  ph_arena arena;
} owned_value;

ph_status ph_value_decode(const ph_message_type *message, const void *body, size_t size, double timestamp,
                          ph_value **value, ph_error *error) {
  owned_value *made = calloc(1, sizeof *made);
  if (made == NULL) return ph_fail_no_memory(error);
  made->owners = 1;
  void *data = ph_arena_take(&made->arena, 1, message->payload->size);
  const ph_status status = data == NULL ? ph_fail_no_memory(error)
                                        : ph_decode(message->payload, data, body, size, &made->arena, error);
  made->shared = (ph_value){message, data, timestamp};
  if (status != PH_OK) {
    ph_value_free(&made->shared);
  } else {
    *value = &made->shared;
  }
  return status;
}

ph_value *ph_value_keep(const ph_value *value) {
  owned_value *owned = (owned_value *)(uintptr_t)value;
  ++owned->owners;
  return &owned->shared;
}

void ph_value_free(ph_value *value) {
  owned_value *owned = (owned_value *)value;
  if (owned == NULL || --owned->owners > 0) return;
  ph_arena_free(&owned->arena);
  free(owned);
}
