#include "playhouse/c/wire.h"

#include <string.h>

#include "big_endian.h"
#include "fail.h"
#include "generated/catalogue.h"
#include "memory.h"

/** Bytes of a scalar: on the wire, and in memory. */
static const struct {
  uint8_t wire, memory;
} kSizes[] = {
    [PH_TYPE_CHAR] = {4, 1},    [PH_TYPE_INT8] = {4, 1},   [PH_TYPE_UINT8] = {4, 1},
    [PH_TYPE_INT16] = {4, 2},   [PH_TYPE_UINT16] = {4, 2}, [PH_TYPE_INT32] = {4, 4},
    [PH_TYPE_UINT32] = {4, 4},  [PH_TYPE_INT64] = {8, 8},  [PH_TYPE_FLOAT32] = {4, 4},
    [PH_TYPE_FLOAT64] = {8, 8},
};

/** Whether a length precedes the elements on the wire. */
static bool has_length(const ph_field *field) {
  return field->shape >= PH_SHAPE_COUNTED;
}

/** Whether an array of these travels as raw bytes. */
static bool is_opaque(const ph_field *field) {
  return field->type <= PH_TYPE_UINT8;
}

static size_t element_bytes(const ph_field *field) {
  return field->type == PH_TYPE_STRUCT ? field->of->size : kSizes[field->type].memory;
}

// --- headers

void ph_header_encode(const ph_header *header, uint8_t bytes[PH_HEADER_BYTES]) {
  const uint32_t words[6] = {header->host,  header->robot, header->interface_code,
                             header->index, header->kind,  header->subtype};
  for (size_t i = 0; i < 6; ++i) ph_store32(bytes + 4 * i, words[i]);
  uint64_t timestamp = 0;
  memcpy(&timestamp, &header->timestamp, sizeof timestamp);
  ph_store64(bytes + 24, timestamp);
  ph_store32(bytes + 32, header->sequence);
  ph_store32(bytes + 36, header->size);
}

ph_header ph_header_decode(const uint8_t bytes[PH_HEADER_BYTES]) {
  ph_header header = {
      .host = ph_load32(bytes),
      .robot = ph_load32(bytes + 4),
      .interface_code = (uint16_t)ph_load32(bytes + 8),
      .index = (uint16_t)ph_load32(bytes + 12),
      .kind = (uint8_t)ph_load32(bytes + 16),
      .subtype = (uint8_t)ph_load32(bytes + 20),
      .sequence = ph_load32(bytes + 32),
      .size = ph_load32(bytes + 36),
  };
  const uint64_t timestamp = ph_load64(bytes + 24);
  memcpy(&header.timestamp, &timestamp, sizeof timestamp);
  return header;
}

// --- encoding

static void store_scalars(uint8_t type, const uint8_t *from, size_t count, uint8_t *to) {
  for (size_t i = 0; i < count; ++i) {
    switch ((ph_field_type)type) {
      case PH_TYPE_CHAR:
      case PH_TYPE_INT8:
        ph_store32(to + 4 * i, (uint32_t)(int32_t)(int8_t)from[i]);
        break;
      case PH_TYPE_UINT8:
        ph_store32(to + 4 * i, from[i]);
        break;
      case PH_TYPE_INT16: {
        int16_t value = 0;
        memcpy(&value, from + 2 * i, sizeof value);
        ph_store32(to + 4 * i, (uint32_t)(int32_t)value);
        break;
      }
      case PH_TYPE_UINT16: {
        uint16_t value = 0;
        memcpy(&value, from + 2 * i, sizeof value);
        ph_store32(to + 4 * i, value);
        break;
      }
      case PH_TYPE_INT32:
      case PH_TYPE_UINT32:
      case PH_TYPE_FLOAT32: {
        uint32_t value = 0;
        memcpy(&value, from + 4 * i, sizeof value);
        ph_store32(to + 4 * i, value);
        break;
      }
      case PH_TYPE_INT64:
      case PH_TYPE_FLOAT64: {
        uint64_t value = 0;
        memcpy(&value, from + 8 * i, sizeof value);
        ph_store64(to + 8 * i, value);
        break;
      }
      case PH_TYPE_STRUCT:
        break;
    }
  }
}

static ph_status write_word(ph_buffer *out, uint32_t value, ph_error *error) {
  uint8_t word[4];
  ph_store32(word, value);
  return ph_buffer_append(out, word, sizeof word) ? PH_OK : ph_fail_no_memory(error);
}

static ph_status write_struct(const ph_struct_type *type, const uint8_t *value, ph_buffer *out,
                              ph_error *error);

static ph_status write_elements(const ph_field *field, const uint8_t *from, size_t count, ph_buffer *out,
                                ph_error *error) {
  if (field->type == PH_TYPE_STRUCT) {
    for (size_t i = 0; i < count; ++i)
      PH_TRY(write_struct(field->of, from + i * field->of->size, out, error));
    return PH_OK;
  }
  if (is_opaque(field) && field->shape != PH_SHAPE_ONE) {
    static const uint8_t zeros[3] = {0};
    const bool done = ph_buffer_append(out, from, count) && ph_buffer_append(out, zeros, -count & 3);
    return done ? PH_OK : ph_fail_no_memory(error);
  }
  const size_t size = count * kSizes[field->type].wire;
  if (!ph_buffer_reserve(out, size)) return ph_fail_no_memory(error);
  store_scalars(field->type, from, count, out->bytes + out->size);
  out->size += size;
  return PH_OK;
}

static uint32_t count_of(const ph_field *field, const uint8_t *value) {
  uint32_t count = 0;
  memcpy(&count, value + field->count_offset, sizeof count);
  return count;
}

static ph_status write_count(const ph_field *field, const uint8_t *value, ph_buffer *out, ph_error *error) {
  const uint32_t count = count_of(field, value);
  if (count > field->limit) {
    return ph_fail(error, PH_WIRE_ERROR, "%s has %lu elements, over its limit of %lu", field->name,
                   (unsigned long)count, (unsigned long)field->limit);
  }
  return write_word(out, count, error);
}

static ph_status write_list(const ph_field *field, const uint8_t *value, ph_buffer *out, ph_error *error) {
  const uint8_t *elements = value + field->offset;
  if (field->shape != PH_SHAPE_INLINE) memcpy(&elements, value + field->offset, sizeof elements);
  if (!field->count_is_early) PH_TRY(write_count(field, value, out, error));
  PH_TRY(write_count(field, value, out, error));
  const uint32_t count = count_of(field, value);
  if (elements == NULL && count > 0) {
    return ph_fail(error, PH_WIRE_ERROR, "%s has %lu elements at NULL", field->name, (unsigned long)count);
  }
  return write_elements(field, elements, count, out, error);
}

static ph_status write_struct(const ph_struct_type *type, const uint8_t *value, ph_buffer *out,
                              ph_error *error) {
  for (size_t i = 0; i < type->field_count; ++i) {
    const ph_field *field = &type->fields[i];
    if (field->early != 0) PH_TRY(write_count(&type->fields[field->early - 1], value, out, error));
    if (has_length(field)) {
      PH_TRY(write_list(field, value, out, error));
    } else {
      PH_TRY(write_elements(field, value + field->offset, field->limit, out, error));
    }
  }
  return PH_OK;
}

ph_status ph_encode(const ph_struct_type *type, const void *value, ph_buffer *out, ph_error *error) {
  const size_t before = out->size;
  const ph_status status = write_struct(type, value, out, error);
  if (status != PH_OK) out->size = before;
  return status;
}

// --- decoding

/** Reads a body, front to back. */
typedef struct reader {
  const uint8_t *bytes;
  size_t at, size;
  ph_arena *arena;
  ph_error *error;
} reader;

static void load_scalars(uint8_t type, const uint8_t *from, size_t count, uint8_t *to) {
  for (size_t i = 0; i < count; ++i) {
    switch ((ph_field_type)type) {
      case PH_TYPE_CHAR:
      case PH_TYPE_INT8:
      case PH_TYPE_UINT8:
        to[i] = (uint8_t)ph_load32(from + 4 * i);
        break;
      case PH_TYPE_INT16:
      case PH_TYPE_UINT16: {
        const uint16_t value = (uint16_t)ph_load32(from + 4 * i);
        memcpy(to + 2 * i, &value, sizeof value);
        break;
      }
      case PH_TYPE_INT32:
      case PH_TYPE_UINT32:
      case PH_TYPE_FLOAT32: {
        const uint32_t value = ph_load32(from + 4 * i);
        memcpy(to + 4 * i, &value, sizeof value);
        break;
      }
      case PH_TYPE_INT64:
      case PH_TYPE_FLOAT64: {
        const uint64_t value = ph_load64(from + 8 * i);
        memcpy(to + 8 * i, &value, sizeof value);
        break;
      }
      case PH_TYPE_STRUCT:
        break;
    }
  }
}

/** The next `size` bytes of the body. */
static ph_status take(reader *in, size_t size, const uint8_t **bytes) {
  if (size > in->size - in->at) {
    return ph_fail(in->error, PH_WIRE_ERROR, "byte %zu: %zu bytes expected, %zu are left", in->at, size,
                   in->size - in->at);
  }
  *bytes = in->bytes + in->at;
  in->at += size;
  return PH_OK;
}

static ph_status read_word(reader *in, uint32_t *value) {
  const uint8_t *bytes = NULL;
  PH_TRY(take(in, 4, &bytes));
  *value = ph_load32(bytes);
  return PH_OK;
}

static ph_status read_struct(reader *in, const ph_struct_type *type, uint8_t *value);

static ph_status read_elements(reader *in, const ph_field *field, size_t count, uint8_t *to) {
  if (field->type == PH_TYPE_STRUCT) {
    for (size_t i = 0; i < count; ++i) PH_TRY(read_struct(in, field->of, to + i * field->of->size));
    return PH_OK;
  }
  const uint8_t *bytes = NULL;
  if (is_opaque(field) && field->shape != PH_SHAPE_ONE) {
    PH_TRY(take(in, count + (-count & 3), &bytes));
    if (count > 0) memcpy(to, bytes, count);
    return PH_OK;
  }
  PH_TRY(take(in, count * kSizes[field->type].wire, &bytes));
  load_scalars(field->type, bytes, count, to);
  return PH_OK;
}

/** The length before the elements of a list: at most `limit`, and no more elements than fit into what is
 * left. */
static ph_status read_length(reader *in, const ph_field *field, uint32_t limit, uint32_t *length) {
  PH_TRY(read_word(in, length));
  const size_t left = in->size - in->at;
  if (*length > limit) {
    return ph_fail(in->error, PH_WIRE_ERROR, "byte %zu: %s has a length of %lu, over its limit of %lu",
                   in->at, field->name, (unsigned long)*length, (unsigned long)limit);
  }
  const uint32_t least = is_opaque(field)                ? 1
                         : field->type == PH_TYPE_STRUCT ? field->of->min_bytes
                                                         : kSizes[field->type].wire;
  if ((uint64_t)*length * least > left) {
    return ph_fail(in->error, PH_WIRE_ERROR, "byte %zu: %s claims %lu elements, but %zu bytes are left",
                   in->at, field->name, (unsigned long)*length, left);
  }
  return PH_OK;
}

static ph_status read_list(reader *in, const ph_field *field, uint32_t early_count, uint8_t *value) {
  uint32_t count = early_count, length = 0;
  if (!field->count_is_early) PH_TRY(read_word(in, &count));
  PH_TRY(read_length(in, field, field->shape == PH_SHAPE_DYNAMIC ? count : field->limit, &length));
  memcpy(value + field->count_offset, &length, sizeof length);
  if (field->shape == PH_SHAPE_INLINE) return read_elements(in, field, length, value + field->offset);
  const size_t nul = field->type == PH_TYPE_CHAR ? 1 : 0;  // texts are C strings
  uint8_t *elements = NULL;
  if (length + nul > 0) {
    elements = ph_arena_take(in->arena, length + nul, element_bytes(field));
    if (elements == NULL) return ph_fail_no_memory(in->error);
    PH_TRY(read_elements(in, field, length, elements));
  }
  memcpy(value + field->offset, &elements, sizeof elements);
  return PH_OK;
}

static ph_status read_struct(reader *in, const ph_struct_type *type, uint8_t *value) {
  uint32_t early_count = 0;
  for (size_t i = 0; i < type->field_count; ++i) {
    const ph_field *field = &type->fields[i];
    if (field->early != 0) PH_TRY(read_word(in, &early_count));
    if (has_length(field)) {
      PH_TRY(read_list(in, field, early_count, value));
    } else {
      PH_TRY(read_elements(in, field, field->limit, value + field->offset));
    }
  }
  return PH_OK;
}

ph_status ph_decode(const ph_struct_type *type, void *value, const void *body, size_t size, ph_arena *arena,
                    ph_error *error) {
  reader in = {body, 0, size, arena, error};
  memset(value, 0, type->size);
  const ph_status status = read_struct(&in, type, value);
  if (status == PH_WIRE_ERROR && error != NULL)
    return ph_fail(error, status, "%s: %s", type->name, error->text);
  return status;
}

// --- the catalogue

static const ph_message_type *find_in(const ph_interface *interface, uint8_t kind, uint8_t subtype) {
  for (size_t i = 0; i < interface->message_count; ++i) {
    const ph_message_type *row = &interface->messages[i];
    if (row->kind == kind && row->subtype == subtype) return row;
  }
  return NULL;
}

/** By binary search; NULL if there is none. */
static const ph_interface *find_interface(uint16_t code) {
  size_t low = 1, high = PH_INTERFACE_COUNT;  // the first has the shared messages
  while (low < high) {
    const size_t middle = (low + high) / 2;
    if (ph_interfaces[middle].code == code) return &ph_interfaces[middle];
    if (ph_interfaces[middle].code < code) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return NULL;
}

const ph_message_type *ph_find_message(uint16_t interface_code, uint8_t kind, uint8_t subtype) {
  if (kind == PH_KIND_ACK || kind == PH_KIND_NACK) kind = PH_KIND_REQ;
  const ph_message_type *row = find_in(&ph_interfaces[0], kind, subtype);
  if (row != NULL) return row;
  const ph_interface *interface = find_interface(interface_code);
  return interface != NULL ? find_in(interface, kind, subtype) : NULL;
}

const char *ph_interface_name(uint16_t interface_code) {
  const ph_interface *interface = find_interface(interface_code);
  return interface != NULL ? interface->name : NULL;
}

uint16_t ph_interface_code(const char *name) {
  for (size_t i = 1; i < PH_INTERFACE_COUNT; ++i) {
    if (strcmp(ph_interfaces[i].name, name) == 0) return ph_interfaces[i].code;
  }
  return 0;
}

uint32_t ph_text_count(const char *text) {
  return (uint32_t)strlen(text) + 1;
}
