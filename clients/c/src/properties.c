/** Properties and capabilities of a device. */
#include <string.h>

#include "device.h"
#include "fail.h"
#include "playhouse/c/generated/common.h"

/** A refusal, or an answer without a body, is that of a property that is not there. `kind` is its type in
 * errors. */
static ph_status get(ph_device *device, const ph_message_type *message, const void *question,
                     const char *kind, const char *key, ph_value **answer, ph_error *error) {
  const ph_status status = ph_device_request(device, message, question, PH_OWN_TIMEOUT, answer, error);
  if (status != PH_REQUEST_REFUSED && (status != PH_OK || *answer != NULL)) return status;
  return ph_fail(error, PH_REQUEST_REFUSED, "%s: %s has no %s property \"%s\"",
                 ph_session_peer(ph_device_session(device)), device->name, kind, key);
}

static ph_status set(ph_device *device, const ph_message_type *message, const void *body, const char *shown,
                     const char *key, ph_error *error) {
  const ph_status status = ph_device_tell(device, message, body, error);
  if (status != PH_REQUEST_REFUSED) return status;
  return ph_fail(error, status, "%s: %s refuses %s as \"%s\"", ph_session_peer(ph_device_session(device)),
                 device->name, shown, key);
}

ph_status ph_device_get_bool(ph_device *device, const char *key, bool *value, ph_error *error) {
  const ph_common_boolprop_req question = {.key = key, .key_count = ph_text_count(key)};
  ph_value *answer = NULL;
  PH_TRY(get(device, PH_COMMON_REQ_GET_BOOLPROP, &question, "bool", key, &answer, error));
  *value = ((const ph_common_boolprop_req *)answer->data)->value != 0;
  ph_value_free(answer);
  return PH_OK;
}

ph_status ph_device_get_int(ph_device *device, const char *key, int32_t *value, ph_error *error) {
  const ph_common_intprop_req question = {.key = key, .key_count = ph_text_count(key)};
  ph_value *answer = NULL;
  PH_TRY(get(device, PH_COMMON_REQ_GET_INTPROP, &question, "int", key, &answer, error));
  *value = ((const ph_common_intprop_req *)answer->data)->value;
  ph_value_free(answer);
  return PH_OK;
}

ph_status ph_device_get_double(ph_device *device, const char *key, double *value, ph_error *error) {
  const ph_common_dblprop_req question = {.key = key, .key_count = ph_text_count(key)};
  ph_value *answer = NULL;
  PH_TRY(get(device, PH_COMMON_REQ_GET_DBLPROP, &question, "float", key, &answer, error));
  *value = ((const ph_common_dblprop_req *)answer->data)->value;
  ph_value_free(answer);
  return PH_OK;
}

ph_status ph_device_get_string(ph_device *device, const char *key, const char **value, ph_error *error) {
  const ph_common_strprop_req question = {.key = key, .key_count = ph_text_count(key)};
  ph_value *answer = NULL;
  PH_TRY(get(device, PH_COMMON_REQ_GET_STRPROP, &question, "str", key, &answer, error));
  ph_value_free(device->text_answer);
  device->text_answer = answer;
  *value = ((const ph_common_strprop_req *)answer->data)->value;
  return PH_OK;
}

ph_status ph_device_why_refused(ph_device *device, const char **why, ph_error *error) {
  const ph_status status = ph_device_get_string(device, "refusal", why, error);
  if (status != PH_REQUEST_REFUSED) return status;
  *why = "";
  return PH_OK;
}

ph_status ph_device_set_bool(ph_device *device, const char *key, bool value, ph_error *error) {
  const ph_common_boolprop_req body = {key, ph_text_count(key), value};
  return set(device, PH_COMMON_REQ_SET_BOOLPROP, &body, value ? "True" : "False", key, error);
}

ph_status ph_device_set_int(ph_device *device, const char *key, int32_t value, ph_error *error) {
  const ph_common_intprop_req body = {key, ph_text_count(key), value};
  char shown[PH_NUMBER_BYTES];
  return set(device, PH_COMMON_REQ_SET_INTPROP, &body, ph_number_text(value, shown), key, error);
}

ph_status ph_device_set_double(ph_device *device, const char *key, double value, ph_error *error) {
  const ph_common_dblprop_req body = {key, ph_text_count(key), value};
  char shown[PH_NUMBER_BYTES];
  return set(device, PH_COMMON_REQ_SET_DBLPROP, &body, ph_number_text(value, shown), key, error);
}

ph_status ph_device_set_string(ph_device *device, const char *key, const char *value, ph_error *error) {
  const ph_common_strprop_req body = {key, ph_text_count(key), value, ph_text_count(value)};
  const ph_status status = ph_device_tell(device, PH_COMMON_REQ_SET_STRPROP, &body, error);
  if (status != PH_REQUEST_REFUSED) return status;
  return ph_fail(error, status, "%s: %s refuses '%s' as \"%s\"", ph_session_peer(ph_device_session(device)),
                 device->name, value, key);
}

ph_status ph_device_has_capability(ph_device *device, const ph_message_type *message, bool *has,
                                   ph_error *error) {
  const ph_common_capabilities_req question = {message->kind, message->subtype};
  ph_error why;
  const ph_status status = ph_device_tell(device, PH_COMMON_REQ_CAPABILITIES, &question, &why);
  if (status != PH_OK && status != PH_REQUEST_REFUSED) return ph_fail_as(error, &why);
  *has = status == PH_OK;
  return PH_OK;
}
