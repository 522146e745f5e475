/** Encoding and decoding of Player's variant of XDR and of its message header; what the generated headers
 * need.
 *
 * Everything is big-endian and a multiple of four bytes; the rules are in docs/wire.md. Each generated
 * struct has PH_CODEC: functions to encode and decode it, and a table that describes it, for programs that
 * treat all alike. */
#ifndef PLAYHOUSE_C_WIRE_H
#define PLAYHOUSE_C_WIRE_H

#include <stddef.h>
#include <stdint.h>

#include "playhouse/c/error.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { PH_HEADER_BYTES = 40, PH_MAX_BODY_BYTES = 33554432 - PH_HEADER_BYTES };

/** Type of a message: the header's `kind`. */
typedef enum ph_kind {
  PH_KIND_DATA = 1,
  PH_KIND_CMD = 2,
  PH_KIND_REQ = 3,
  PH_KIND_ACK = 4,
  PH_KIND_SYNCH = 5,
  PH_KIND_NACK = 6
} ph_kind;

/** The 40 bytes before every body. `size` is the body's length in bytes, `timestamp` is in seconds. */
typedef struct ph_header {
  uint32_t host;
  uint32_t robot;
  uint16_t interface_code;
  uint16_t index;
  uint8_t kind;
  uint8_t subtype;
  double timestamp;
  uint32_t sequence;
  uint32_t size;
} ph_header;

void ph_header_encode(const ph_header *header, uint8_t bytes[PH_HEADER_BYTES]);
/** Narrow fields keep their low bits only, as in every Player receiver. */
ph_header ph_header_decode(const uint8_t bytes[PH_HEADER_BYTES]);

/** Memory of decoded lists, released at once. Begin with {NULL}. */
typedef struct ph_arena {
  void *newest;
} ph_arena;

void ph_arena_free(ph_arena *arena);

/** Bytes that grow at their end. Begin with {NULL, 0, 0}; ph_buffer_free() ends it. */
typedef struct ph_buffer {
  uint8_t *bytes;
  size_t size;
  size_t capacity;
} ph_buffer;

void ph_buffer_free(ph_buffer *buffer);

typedef enum ph_field_type {
  PH_TYPE_CHAR,
  PH_TYPE_INT8,
  PH_TYPE_UINT8,
  PH_TYPE_INT16,
  PH_TYPE_UINT16,
  PH_TYPE_INT32,
  PH_TYPE_UINT32,
  PH_TYPE_INT64,
  PH_TYPE_FLOAT32,
  PH_TYPE_FLOAT64,
  PH_TYPE_STRUCT
} ph_field_type;

typedef enum ph_shape {
  PH_SHAPE_ONE,
  PH_SHAPE_FIXED,   /**< an array of `limit` elements, without a length on the wire */
  PH_SHAPE_COUNTED, /**< a pointer and a count, at most `limit` elements */
  PH_SHAPE_DYNAMIC, /**< the same; only the size of a message limits it */
  PH_SHAPE_INLINE   /**< an array of `limit` elements with a count: how many of them are meant */
} ph_shape;

typedef struct ph_struct_type ph_struct_type;

/** One member of a struct. */
typedef struct ph_field {
  const char *name;
  uint8_t type;  /**< a ph_field_type */
  uint8_t shape; /**< a ph_shape */
  uint8_t early; /**< the number, from 1, of a field whose count precedes this field on the wire; 0: none */
  uint8_t count_is_early; /**< of that field: 1 */
  uint32_t limit;
  size_t offset;
  size_t count_offset;
  const ph_struct_type *of; /**< of PH_TYPE_STRUCT */
} ph_field;

/** What encodes and decodes a generated struct. */
struct ph_struct_type {
  const char *name; /**< for instance "position2d.CmdVel" */
  const ph_field *fields;
  size_t field_count;
  uint32_t min_bytes; /**< on the wire, with every list empty */
  size_t size;        /**< in memory */
};

/** One message type of one interface; without `payload` it has no body. */
typedef struct ph_message_type {
  uint16_t interface_code;
  uint8_t kind; /**< a ph_kind */
  uint8_t subtype;
  const char *name; /**< for instance "position2d.cmd.vel" */
  const ph_struct_type *payload;
} ph_message_type;

/** Appends the encoding of `value`, of this type, to `out`. PH_WIRE_ERROR: a list over its limit, or NULL as
 * a list of elements; `out` then has its old size. */
ph_status ph_encode(const ph_struct_type *type, const void *value, ph_buffer *out, ph_error *error);

/** Decodes a body into `value`, which has type->size bytes and is written only as far as it is decoded on an
 * error. Trailing bytes are ignored. Lists are in `arena`, a few times as many bytes as the body at most, and
 * texts there are NUL-terminated even if the body's are not. PH_WIRE_ERROR: the body is not of this type. */
ph_status ph_decode(const ph_struct_type *type, void *value, const void *body, size_t size, ph_arena *arena,
                    ph_error *error);

/** The row of a message, or NULL. Answers have the row of their request; shared messages apply to every
 * interface. */
const ph_message_type *ph_find_message(uint16_t interface_code, uint8_t kind, uint8_t subtype);

/** The name of an interface, NULL if there is none of this code. */
const char *ph_interface_name(uint16_t interface_code);
/** The code of an interface, 0 if there is none of this name. */
uint16_t ph_interface_code(const char *name);

/** The number of characters of a text on the wire, with its NUL: for a list of `char` that is a C string. */
uint32_t ph_text_count(const char *text);

/** The codec of a generated struct T: T_encode() and T_decode() are ph_encode() and ph_decode() of T_type. */
#define PH_CODEC(T)                                                                            \
  extern const ph_struct_type T##_type;                                                        \
  static inline ph_status T##_encode(const T *value, ph_buffer *out, ph_error *error) {        \
    return ph_encode(&T##_type, value, out, error);                                            \
  }                                                                                            \
  static inline ph_status T##_decode(T *value, const void *body, size_t size, ph_arena *arena, \
                                     ph_error *error) {                                        \
    return ph_decode(&T##_type, value, body, size, arena, error);                              \
  }

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_WIRE_H */
