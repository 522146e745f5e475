#include "device.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "client.h"
#include "fail.h"
#include "playhouse/c/generated/common.h"
#include "playhouse/c/generated/player.h"
#include "proxy.h"
#include "value.h"

static const ph_class kAnyClass = {.interface_name = "", .size = sizeof(ph_device)};

static const ph_class *class_for(const char *interface_name) {
  for (size_t i = 0; i < PH_CLASS_COUNT; ++i) {
    if (strcmp(ph_classes[i]->interface_name, interface_name) == 0) return ph_classes[i];
  }
  return &kAnyClass;
}

ph_session *ph_device_session(const ph_device *device) {
  return &device->client->session;
}

static const char *peer_of(const ph_device *device) {
  return ph_session_peer(ph_device_session(device));
}

// --- opening and closing

static ph_status refuse_interface(const char *interface_name, ph_error *error) {
  const char *known[128];
  size_t count = 0;
  for (unsigned code = 1; code < 1024 && count < 128; ++code) {
    const char *name = ph_interface_name((uint16_t)code);
    if (name != NULL) known[count++] = name;
  }
  char near[PH_NEAR_BYTES];
  return ph_fail(error, PH_INVALID_VALUE, "there is no interface \"%s\"%s", interface_name,
                 ph_did_you_mean(interface_name, known, count, near));
}

/** Requests another access; `driver` gets a copy of the driver's name. */
static ph_status set_access(ph_device *device, uint8_t access, char **driver, ph_error *error) {
  ph_session *session = ph_device_session(device);
  const char *verb = access == PH_PLAYER_CLOSE_MODE ? "close" : "open";
  const ph_player_device_req body = {.addr = {0, 0, device->code, device->index}, .access = access};
  ph_answer answer;
  ph_status status = ph_session_request(session, PH_PLAYER_CODE, 0, PH_PLAYER_REQ_DEV, &body,
                                        session->timeout, &answer, error);
  if (status == PH_REQUEST_REFUSED) {
    return ph_fail(error, status, "%s: there is no %s to %s", peer_of(device), device->name, verb);
  }
  if (status == PH_REQUEST_TIMEOUT) {
    return ph_fail(error, status, "%s: no answer in time: %s %s", peer_of(device), verb, device->name);
  }
  if (status != PH_OK) return status;
  ph_arena arena = {NULL};
  ph_player_device_req granted;
  status = ph_player_device_req_decode(&granted, answer.body, answer.header.size, &arena, error);
  if (status == PH_OK && granted.access == PH_PLAYER_ERROR_MODE) {
    status = ph_fail(error, PH_REQUEST_REFUSED, "%s: cannot %s %s", peer_of(device), verb, device->name);
  }
  if (status == PH_OK && driver != NULL) {
    *driver = ph_copy_text(granted.driver_name);
    if (*driver == NULL) status = ph_fail_no_memory(error);
  }
  ph_arena_free(&arena);
  return status;
}

static ph_device *make(ph_client *client, const ph_class *class_of, uint16_t code, int index,
                       ph_access access) {
  ph_device *made = calloc(1, class_of->size);
  if (made == NULL) return NULL;
  made->class_of = class_of;
  made->client = client;
  made->code = code;
  made->index = (uint16_t)index;
  made->access = access;
  ph_device_text(code, index, made->name);
  return made;
}

static ph_status open_and_prepare(ph_device *device, ph_error *error) {
  PH_TRY(set_access(device, (uint8_t)device->access, &device->driver, error));
  device->open = true;
  if (!ph_client_add(device->client, device)) return ph_fail_no_memory(error);
  if (device->class_of->prepare == NULL) return PH_OK;
  ph_error why;
  const ph_status prepared = device->class_of->prepare(device, &why);
  if (prepared == PH_OK || prepared == PH_REQUEST_REFUSED) return PH_OK;  // works without what it asked for
  return ph_fail_as(error, &why);
}

ph_device *ph_device_open(ph_client *client, const char *interface_name, int index, ph_access access,
                          ph_error *error) {
  const uint16_t code = ph_interface_code(interface_name);
  if (code == 0) {
    refuse_interface(interface_name, error);
    return NULL;
  }
  if (index < 0 || index > UINT16_MAX) {
    ph_fail(error, PH_INVALID_VALUE, "there is no %s:%d: indices are 0 to 65535", interface_name, index);
    return NULL;
  }
  ph_device *device = make(client, class_for(interface_name), code, index, access);
  if (device == NULL) {
    ph_fail_no_memory(error);
    return NULL;
  }
  if (open_and_prepare(device, error) == PH_OK) return device;
  if (device->open) {
    ph_device_free(device);
  } else {
    ph_device_release(device);
  }
  return NULL;
}

ph_status ph_device_close(ph_device *device, ph_error *error) {
  if (!device->open) return PH_OK;
  const bool reachable = ph_connection_alive(&ph_device_session(device)->connection);
  if (reachable && device->gone[0] == '\0' && device->class_of->before_close != NULL) {
    device->class_of->before_close(device);
  }
  device->open = false;
  ph_client_forget(device->client, device);
  if (!ph_connection_alive(&ph_device_session(device)->connection) || device->gone[0] != '\0') return PH_OK;
  return set_access(device, PH_PLAYER_CLOSE_MODE, NULL, error);
}

void ph_device_release(ph_device *device) {
  if (device->class_of->release != NULL) device->class_of->release(device);
  for (size_t i = 0; i < device->latest_count; ++i) ph_value_free(device->latest[i]);
  ph_value_free(device->text_answer);
  free(device->latest);
  free(device->driver);
  free(device);
}

ph_device *ph_device_as(ph_device *device, const ph_class *class_of, ph_error *error) {
  if (device->class_of == class_of) return device;
  ph_fail(error, PH_INVALID_VALUE, "%s is not of interface %s", device->name, class_of->interface_name);
  return NULL;
}

// --- what it tells

const char *ph_device_name(const ph_device *device) {
  return device->name;
}
uint16_t ph_device_interface(const ph_device *device) {
  return device->code;
}
int ph_device_index(const ph_device *device) {
  return device->index;
}
ph_access ph_device_access(const ph_device *device) {
  return device->access;
}
const char *ph_device_driver(const ph_device *device) {
  return device->driver;
}
ph_client *ph_device_client(const ph_device *device) {
  return device->client;
}
bool ph_device_is_open(const ph_device *device) {
  return device->open;
}
bool ph_device_gone(const ph_device *device) {
  return device->gone[0] != '\0';
}
double ph_device_timestamp(const ph_device *device) {
  return device->timestamp;
}
bool ph_device_has_data(const ph_device *device) {
  return device->latest_count > 0;
}
bool ph_device_fresh(const ph_device *device) {
  return device->fresh;
}

bool ph_device_take_fresh(ph_device *device) {
  const bool fresh = device->fresh;
  device->fresh = false;
  return fresh;
}

const ph_value *ph_device_latest(const ph_device *device, const ph_message_type *message) {
  for (size_t i = 0; i < device->latest_count; ++i) {
    if (device->latest[i]->message->subtype == message->subtype) return device->latest[i];
  }
  return NULL;
}

void ph_device_on_data(ph_device *device, ph_on_data callback, void *context) {
  device->callback = callback;
  device->context = context;
}

ph_status ph_device_stamped(const ph_device *device, const ph_message_type *message, const ph_value **value,
                            ph_error *error) {
  *value = ph_device_latest(device, message);
  if (*value != NULL) return PH_OK;
  if (device->latest_count > 0) {
    return ph_fail(error, PH_NO_DATA, "%s: %s sends %s, not %s", peer_of(device), device->name,
                   device->latest[0]->message->name, message->name);
  }
  return ph_fail(error, PH_NO_DATA, "%s: %s has sent no data yet; next_data() waits for them",
                 peer_of(device), device->name);
}

// --- receiving

/** Keeps the value as the newest of its subtype. */
static bool set_latest(ph_device *device, const ph_value *value) {
  size_t at = 0;
  while (at < device->latest_count && device->latest[at]->message->subtype != value->message->subtype) ++at;
  if (at == device->latest_count) {
    if (!ph_grow(&device->latest, at, &device->latest_capacity, sizeof *device->latest)) return false;
    device->latest[device->latest_count++] = NULL;
  }
  ph_value_free(device->latest[at]);
  device->latest[at] = ph_value_keep(value);
  return true;
}

ph_status ph_device_take(ph_device *device, const ph_value *value, ph_error *error) {
  if (device->class_of->take != NULL) device->class_of->take(device, value);
  if (!set_latest(device, value)) return ph_fail_no_memory(error);
  device->timestamp = value->timestamp;
  device->fresh = true;
  if (device->callback != NULL) device->callback(device->context, value);
  return PH_OK;
}

bool ph_device_goes_back(const ph_device *device, const ph_value *value) {
  const ph_value *last = ph_device_latest(device, value->message);
  return last != NULL && value->timestamp < last->timestamp;
}

void ph_device_forget_data(ph_device *device) {
  if (device->class_of->forget != NULL) device->class_of->forget(device);
  while (device->latest_count > 0) ph_value_free(device->latest[--device->latest_count]);
  device->timestamp = 0.0;
  device->fresh = false;
}

void ph_device_retire(ph_device *device, uint32_t port) {
  if (device->gone[0] != '\0') return;
  snprintf(device->gone, sizeof device->gone, "%lu:%s is gone: the server retired it", (unsigned long)port,
           device->name);
}

ph_status ph_device_insist_on_open(const ph_device *device, ph_error *error) {
  if (!device->open)
    return ph_fail(error, PH_DEVICE_CLOSED, "%s: %s is closed", peer_of(device), device->name);
  if (device->gone[0] != '\0') return ph_fail(error, PH_DEVICE_GONE, "%s", device->gone);
  return PH_OK;
}

ph_status ph_device_next_data(ph_device *device, double timeout, ph_error *error) {
  double seconds = 0.0;
  PH_TRY(ph_session_seconds(ph_device_session(device), timeout, &seconds, error));
  const double deadline = ph_now() + seconds;
  while (!device->fresh) {
    PH_TRY(ph_device_insist_on_open(device, error));
    const ph_status status = ph_client_read(device->client, fmax(deadline - ph_now(), 0.0), NULL, error);
    const bool late = status == PH_REQUEST_TIMEOUT || (!device->fresh && ph_now() >= deadline);
    if (status != PH_OK && status != PH_REQUEST_TIMEOUT) return status;
    if (late) {  // also if reading is busy with other devices
      char number[PH_NUMBER_BYTES];
      return ph_fail(error, PH_REQUEST_TIMEOUT, "%s: no data of %s in %s s", peer_of(device), device->name,
                     ph_number_text(seconds, number));
    }
  }
  device->fresh = false;
  return PH_OK;
}

// --- sending

ph_status ph_device_command(ph_device *device, const ph_message_type *message, const void *payload,
                            ph_error *error) {
  PH_TRY(ph_device_insist_on_open(device, error));
  return ph_session_send(ph_device_session(device), device->code, device->index, message, payload, error);
}

ph_status ph_device_request(ph_device *device, const ph_message_type *message, const void *payload,
                            double timeout, ph_value **answer, ph_error *error) {
  ph_session *session = ph_device_session(device);
  double seconds = 0.0;
  ph_answer received;
  ph_value *value = NULL;
  PH_TRY(ph_device_insist_on_open(device, error));
  PH_TRY(ph_session_seconds(session, timeout, &seconds, error));
  PH_TRY(
      ph_session_request(session, device->code, device->index, message, payload, seconds, &received, error));
  if (message->payload != NULL && received.header.size > 0) {
    PH_TRY(ph_value_decode(message, received.body, received.header.size, received.header.timestamp, &value,
                           error));
  }
  if (answer != NULL) {
    *answer = value;
  } else {
    ph_value_free(value);
  }
  return PH_OK;
}

ph_status ph_device_ask(ph_device *device, const ph_message_type *message, const void *payload,
                        ph_value **answer, ph_error *error) {
  PH_TRY(ph_device_request(device, message, payload, PH_OWN_TIMEOUT, answer, error));
  return *answer != NULL ? PH_OK : ph_fail(error, PH_WIRE_ERROR, "an answer came without its contents");
}

ph_status ph_device_tell(ph_device *device, const ph_message_type *message, const void *payload,
                         ph_error *error) {
  return ph_device_request(device, message, payload, PH_OWN_TIMEOUT, NULL, error);
}

// --- values that mean nothing

ph_status ph_insist_on_finite(const ph_device *device, const ph_named *values, size_t count,
                              ph_error *error) {
  for (size_t i = 0; i < count; ++i) {
    if (isfinite(values[i].value)) continue;
    char number[PH_NUMBER_BYTES];
    return ph_fail(error, PH_INVALID_VALUE, "%s: %s is %s, not a finite number", device->name, values[i].name,
                   ph_number_text(values[i].value, number));
  }
  return PH_OK;
}

ph_status ph_to_float(const ph_device *device, double value, float *rounded, ph_error *error) {
  if (fabs(value) > (double)FLT_MAX) {
    char number[PH_NUMBER_BYTES];
    return ph_fail(error, PH_WIRE_ERROR, "%s: %s is too large for the wire", device->name,
                   ph_number_text(value, number));
  }
  *rounded = (float)value;
  return PH_OK;
}
