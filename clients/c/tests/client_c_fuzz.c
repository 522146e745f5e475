// Bytes from a server, behind its banner: headers and bodies. What decodes encodes again, to bytes that mean
// the same; the values of answers of a simulation are read as lists of models as well.

#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "models.h"
#include "playhouse/c/generated/simulation.h"
#include "value.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void insist(bool fact) {
  if (!fact) abort();
}

static void read_models(const ph_value *value) {
  const ph_simulation_property_req *told = value->data;
  char *lines = ph_copy_text(told->value);
  ph_models models = {.count = 0};
  if (lines != NULL) ph_models_parse(&models, lines, NULL);
  ph_models_free(&models);
  free(lines);
}

static void check_again(const ph_value *value) {
  ph_buffer first = {NULL, 0, 0}, second = {NULL, 0, 0};
  ph_value *again = NULL;
  insist(ph_encode(value->message->payload, value->data, &first, NULL) == PH_OK);
  insist(ph_value_decode(value->message, first.bytes, first.size, 0.0, &again, NULL) == PH_OK);
  insist(ph_encode(again->message->payload, again->data, &second, NULL) == PH_OK);
  insist(first.size == second.size && memcmp(first.bytes, second.bytes, first.size) == 0);
  ph_value_free(again);
  ph_buffer_free(&first);
  ph_buffer_free(&second);
}

static void read_body(const ph_header *header, const uint8_t *body) {
  const ph_message_type *row = ph_find_message(header->interface_code, header->kind, header->subtype);
  ph_value *value = NULL;
  if (row == NULL || row->payload == NULL) return;
  if (ph_value_decode(row, body, header->size, header->timestamp, &value, NULL) != PH_OK) return;
  check_again(value);
  if (row == PH_SIMULATION_REQ_GET_PROPERTY) read_models(value);
  ph_value_free(value);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  while (size >= PH_HEADER_BYTES) {
    const ph_header header = ph_header_decode(data);
    data += PH_HEADER_BYTES;
    size -= PH_HEADER_BYTES;
    if (header.size > size) break;
    read_body(&header, data);
    data += header.size;
    size -= header.size;
  }
  return 0;
}
