#include "playhouse/c/opaque.h"

#include <string.h>

#include "playhouse/c/generated/opaque.h"
#include "proxy.h"

struct ph_opaque {
  ph_device device;
  ph_kept kept;
};

static void take(ph_device *device, const ph_value *value) {
  ph_kept_add(&((ph_opaque *)device)->kept, value);
}

static void forget(ph_device *device) {
  ph_kept_clear(&((ph_opaque *)device)->kept);
}

static void release(ph_device *device) {
  ph_kept_free(&((ph_opaque *)device)->kept);
}

const ph_class ph_opaque_class = {.interface_name = "opaque",
                                  .size = sizeof(ph_opaque),
                                  .take = take,
                                  .forget = forget,
                                  .release = release};
PH_DEFINE_PROXY(opaque)

/** PH_WIRE_ERROR if a message is too long even for its count. */
static ph_status check_size(size_t size, ph_error *error) {
  if (size <= PH_MAX_BODY_BYTES) return PH_OK;
  return ph_fail(error, PH_WIRE_ERROR, "data has %zu elements, over its limit of %d", size,
                 (int)PH_MAX_BODY_BYTES);
}

ph_status ph_opaque_send(ph_opaque *radio, const void *bytes, size_t size, ph_error *error) {
  PH_TRY(check_size(size, error));
  const ph_opaque_data message = {bytes, (uint32_t)size};
  return ph_device_command(&radio->device, PH_OPAQUE_CMD_DATA, &message, error);
}

ph_status ph_opaque_send_to(ph_opaque *radio, const char *address, const void *bytes, size_t size,
                            ph_error *error) {
  PH_TRY(check_size(size, error));
  ph_buffer joined = {NULL, 0, 0};
  ph_status status = PH_OK;
  if (!ph_buffer_append(&joined, address, strlen(address) + 1) || !ph_buffer_append(&joined, bytes, size)) {
    status = ph_fail_no_memory(error);
  } else {
    const ph_opaque_data message = {joined.bytes, (uint32_t)joined.size};
    status = ph_device_tell(&radio->device, PH_OPAQUE_REQ_DATA, &message, error);
  }
  ph_buffer_free(&joined);
  return status;
}

bool ph_opaque_take_message(ph_opaque *radio, const uint8_t **bytes, size_t *size) {
  const ph_value *value = ph_kept_take(&radio->kept);
  if (value == NULL) return false;
  const ph_opaque_data *data = value->data;
  *bytes = data->data;
  *size = data->data_count;
  return true;
}
