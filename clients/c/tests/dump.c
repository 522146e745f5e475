/** Prints every message of a recorded stream as a line of JSON: its name, its value, and the bytes that the
 * value encodes to. dump FILE; clients/python/tests/test_conformance.py compares the lines with the values
 * decoded in Python. */
#include <math.h>
#include <playhouse/c.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "must.h"

enum { BANNER_BYTES = 32 };

static void print_text(const char *text) {
  putchar('"');
  for (; *text != '\0'; ++text) {
    if (*text == '"' || *text == '\\') putchar('\\');
    if ((unsigned char)*text < ' ') {
      printf("\\u%04x", (unsigned)*text);
    } else {
      putchar(*text);
    }
  }
  putchar('"');
}

static void print_number(double number, int digits) {
  if (isfinite(number)) {
    printf("%.*g", digits, number);
  } else {
    printf("null");
  }
}

static void print_scalar(uint8_t type, const uint8_t *at) {
  union {
    int16_t i16;
    uint16_t u16;
    int32_t i32;
    uint32_t u32;
    int64_t i64;
    float f32;
    double f64;
  } value;
  switch ((ph_field_type)type) {
    case PH_TYPE_CHAR:
    case PH_TYPE_INT8:
      printf("%d", (int)(int8_t)*at);
      break;
    case PH_TYPE_UINT8:
      printf("%d", (int)*at);
      break;
    case PH_TYPE_INT16:
      memcpy(&value, at, 2), printf("%d", (int)value.i16);
      break;
    case PH_TYPE_UINT16:
      memcpy(&value, at, 2), printf("%d", (int)value.u16);
      break;
    case PH_TYPE_INT32:
      memcpy(&value, at, 4), printf("%ld", (long)value.i32);
      break;
    case PH_TYPE_UINT32:
      memcpy(&value, at, 4), printf("%lu", (unsigned long)value.u32);
      break;
    case PH_TYPE_INT64:
      memcpy(&value, at, 8), printf("%lld", (long long)value.i64);
      break;
    case PH_TYPE_FLOAT32:
      memcpy(&value, at, 4), print_number((double)value.f32, 9);
      break;
    case PH_TYPE_FLOAT64:
      memcpy(&value, at, 8), print_number(value.f64, 17);
      break;
    case PH_TYPE_STRUCT:
      break;
  }
}

static size_t scalar_bytes(uint8_t type) {
  switch ((ph_field_type)type) {
    case PH_TYPE_INT16:
    case PH_TYPE_UINT16:
      return 2;
    case PH_TYPE_INT32:
    case PH_TYPE_UINT32:
    case PH_TYPE_FLOAT32:
      return 4;
    case PH_TYPE_INT64:
    case PH_TYPE_FLOAT64:
      return 8;
    default:
      return 1;
  }
}

static void print_struct(const ph_struct_type *type, const uint8_t *value);

static void print_elements(const ph_field *field, const uint8_t *at, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    if (i > 0) putchar(',');
    if (field->type == PH_TYPE_STRUCT) {
      print_struct(field->of, at + i * field->of->size);
    } else {
      print_scalar(field->type, at + i * scalar_bytes(field->type));
    }
  }
}

static void print_field(const ph_field *field, const uint8_t *value) {
  const uint8_t *elements = value + field->offset;
  uint32_t count = field->limit;
  if (field->shape == PH_SHAPE_ONE) {
    print_elements(field, elements, 1);
    return;
  }
  if (field->shape != PH_SHAPE_FIXED) {
    memcpy(&elements, value + field->offset, sizeof elements);
    memcpy(&count, value + field->count_offset, sizeof count);
  }
  if (field->type == PH_TYPE_CHAR) {
    char *text = must_have(calloc(count + (size_t)1, 1));
    if (count > 0) memcpy(text, elements, count);
    print_text(text);
    free(text);
    return;
  }
  putchar('[');
  print_elements(field, elements, count);
  putchar(']');
}

static void print_struct(const ph_struct_type *type, const uint8_t *value) {
  for (size_t i = 0; i < type->field_count; ++i) {
    printf("%c\"%s\":", i > 0 ? ',' : '{', type->fields[i].name);
    print_field(&type->fields[i], value);
  }
  putchar('}');
}

static void print_again(const ph_struct_type *type, const void *value) {
  ph_buffer again = {NULL, 0, 0};
  must(ph_encode(type, value, &again, &error));
  for (size_t i = 0; i < again.size; ++i) printf("%02x", again.bytes[i]);
  ph_buffer_free(&again);
}

static void print_message(const ph_header *header, const uint8_t *body) {
  const ph_message_type *row = ph_find_message(header->interface_code, header->kind, header->subtype);
  const ph_struct_type *type = row != NULL && header->size > 0 ? row->payload : NULL;
  ph_arena arena = {NULL};
  uint8_t *value = type != NULL ? must_have(malloc(type->size)) : NULL;
  const bool valid = type != NULL && ph_decode(type, value, body, header->size, &arena, NULL) == PH_OK;
  printf("{\"name\":\"%s\",\"value\":", row != NULL ? row->name : "");
  if (valid) {
    print_struct(type, value);
  } else {
    printf("null");
  }
  printf(",\"again\":\"");
  if (valid) print_again(type, value);
  printf("\"}\n");
  free(value);
  ph_arena_free(&arena);
}

static uint8_t *read_file(const char *path, size_t *size) {
  FILE *file = fopen(path, "rb");
  if (file == NULL || fseek(file, 0, SEEK_END) != 0) fail("cannot read the file");
  const long end = ftell(file);
  rewind(file);
  uint8_t *bytes = must_have(malloc((size_t)end + 1));
  *size = fread(bytes, 1, (size_t)end, file);
  fclose(file);
  return bytes;
}

int main(int argc, char **argv) {
  if (argc != 2) return 2;
  size_t size = 0;
  uint8_t *bytes = read_file(argv[1], &size);
  const size_t length = strlen(argv[1]);
  size_t at = length >= 4 && strcmp(argv[1] + length - 4, ".s2c") == 0 ? BANNER_BYTES : 0;
  while (size - at >= PH_HEADER_BYTES) {
    const ph_header header = ph_header_decode(bytes + at);
    at += PH_HEADER_BYTES;
    if (header.size > size - at) break;
    print_message(&header, bytes + at);
    at += header.size;
  }
  free(bytes);
  return 0;
}
