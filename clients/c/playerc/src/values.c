#include "values.h"

#include <stdlib.h>
#include <string.h>

/** Bytes of an element in memory. */
static size_t element_bytes(const ph_field *field) {
  static const uint8_t sizes[] = {
      [PH_TYPE_CHAR] = 1,    [PH_TYPE_INT8] = 1,    [PH_TYPE_UINT8] = 1,  [PH_TYPE_INT16] = 2,
      [PH_TYPE_UINT16] = 2,  [PH_TYPE_INT32] = 4,   [PH_TYPE_UINT32] = 4, [PH_TYPE_INT64] = 8,
      [PH_TYPE_FLOAT32] = 4, [PH_TYPE_FLOAT64] = 8,
  };
  return field->type == PH_TYPE_STRUCT ? field->of->size : sizes[field->type];
}

static size_t count_of(const ph_field *field, const uint8_t *value) {
  if (field->shape != PH_SHAPE_DYNAMIC) return field->limit;
  uint32_t count = 0;
  memcpy(&count, value + field->count_offset, sizeof count);
  return count;
}

/** The elements of a field, wherever they are. */
static uint8_t *elements_of(const ph_field *field, uint8_t *value) {
  uint8_t *elements = value + field->offset;
  if (field->shape == PH_SHAPE_DYNAMIC) memcpy(&elements, value + field->offset, sizeof elements);
  return elements;
}

void playerc_value_cleanup(const ph_struct_type *type, void *value) {
  for (size_t i = 0; i < type->field_count; ++i) {
    const ph_field *field = &type->fields[i];
    uint8_t *elements = elements_of(field, value);
    if (elements == NULL) continue;
    for (size_t k = 0; field->type == PH_TYPE_STRUCT && k < count_of(field, value); ++k)
      playerc_value_cleanup(field->of, elements + k * field->of->size);
    if (field->shape != PH_SHAPE_DYNAMIC) continue;
    free(elements);
    memset((uint8_t *)value + field->offset, 0, sizeof(void *));
    memset((uint8_t *)value + field->count_offset, 0, sizeof(uint32_t));
  }
}

/** Gives each list of a value, which it shares with another one so far, memory of its own. A list that there is no
 * memory for is empty then. */
static bool unshare(const ph_struct_type *type, uint8_t *value) {
  bool done = true;
  for (size_t i = 0; i < type->field_count; ++i) {
    const ph_field *field = &type->fields[i];
    const size_t count = count_of(field, value);
    uint8_t *elements = elements_of(field, value);
    if (field->shape == PH_SHAPE_DYNAMIC) {
      const size_t bytes = count * element_bytes(field);
      uint8_t *own = elements != NULL ? malloc(bytes + 1) : NULL;  // texts get a NUL behind them
      if (own != NULL) {
        memcpy(own, elements, bytes);
        own[bytes] = 0;
      } else {
        done = done && elements == NULL;
        memset(value + field->count_offset, 0, sizeof(uint32_t));
      }
      memcpy(value + field->offset, &own, sizeof own);
      elements = own;
    }
    for (size_t k = 0; field->type == PH_TYPE_STRUCT && elements != NULL && k < count; ++k)
      done = unshare(field->of, elements + k * field->of->size) && done;
  }
  return done;
}

bool playerc_value_copy(const ph_struct_type *type, void *to, const void *from) {
  memcpy(to, from, type->size);
  if (unshare(type, to)) return true;
  playerc_value_cleanup(type, to);
  memset(to, 0, type->size);
  return false;
}

void *playerc_value_clone(const ph_struct_type *type, const void *value) {
  void *made = malloc(type->size);
  if (made != NULL && playerc_value_copy(type, made, value)) return made;
  free(made);
  return NULL;
}

void playerc_value_free(const ph_struct_type *type, void *value) {
  if (value == NULL) return;
  playerc_value_cleanup(type, value);
  free(value);
}
