#include <string.h>

#include "exchange.h"

void playerc_device_init(playerc_device_t *device, playerc_client_t *client, int code, int index,
                         playerc_putmsg_fn_t putmsg) {
  device->id = device;
  device->client = client;
  device->addr.interf = (uint16_t)code;
  device->addr.index = (uint16_t)index;
  device->putmsg = putmsg;
  if (client != NULL) playerc_client_adddevice(client, device);
}

void playerc_device_term(playerc_device_t *device) {
  if (device->client != NULL) playerc_client_deldevice(device->client, device);
}

void *playerc_proxy_create(size_t size, playerc_client_t *client, int code, int index,
                           playerc_putmsg_fn_t putmsg) {
  playerc_device_t *device = calloc(1, size);
  if (device == NULL) {
    playerc_fail_no_memory();
    return NULL;
  }
  playerc_device_init(device, client, code, index, putmsg);
  return device;
}

void playerc_proxy_destroy(playerc_device_t *device) {
  playerc_device_term(device);
  free(device);
}

int playerc_device_subscribe(playerc_device_t *device, int access) {
  const int result = playerc_client_subscribe(device->client, device->addr.interf, device->addr.index, access,
                                              device->drivername, sizeof device->drivername);
  if (result == 0) device->subscribed = access;
  return result;
}

int playerc_device_unsubscribe(playerc_device_t *device) {
  device->subscribed = 0;
  return playerc_client_unsubscribe(device->client, device->addr.interf, device->addr.index);
}

// --- sending

int playerc_command(playerc_device_t *device, uint8_t subtype, const void *payload) {
  return playerc_client_write(device->client, device, subtype, (void *)(uintptr_t)payload, NULL);
}

int playerc_tell(playerc_device_t *device, uint8_t subtype, const void *payload) {
  return playerc_client_request(device->client, device, subtype, payload, NULL);
}

int playerc_ask(playerc_device_t *device, uint8_t subtype, const void *payload, void *answer) {
  void *reply = NULL;
  const int result = playerc_client_request(device->client, device, subtype, payload, &reply);
  if (result != 0) return result;
  if (reply == NULL)
    return playerc_fail("%s:%d answers without its contents", interf_to_str(device->addr.interf),
                        device->addr.index);
  memcpy(answer, &reply, sizeof reply);
  return 0;
}

uint32_t playerc_text_count(const char *text) {
  return (uint32_t)strlen(text) + 1;
}

// --- lists

bool playerc_room(void *list, size_t count, size_t size) {
  void *old = NULL;
  memcpy(&old, list, sizeof old);
  void *room = realloc(old, count > 0 ? count * size : size);
  if (room == NULL) return false;
  memcpy(list, &room, sizeof room);
  return true;
}

bool playerc_keep(void *list, const void *from, size_t count, size_t size) {
  if (!playerc_room(list, count, size)) return false;
  void *room = NULL;
  memcpy(&room, list, sizeof room);
  if (count > 0) memcpy(room, from, count * size);
  return true;
}

// --- capabilities and properties

int playerc_device_hascapability(playerc_device_t *device, uint32_t type, uint32_t subtype) {
  const player_capabilities_req_t question = {type, subtype};
  return playerc_tell(device, PLAYER_CAPABILITIES_REQ, &question);
}

/** playerc_device_get_NAMEprop() and its counterpart for a property that is a number of type T. */
#define NUMBER_PROPERTY(NAME, CONSTANT, T, STORED)                                                           \
  int playerc_device_get_##NAME##prop(playerc_device_t *device, const char *property, T *value) {            \
    const player_##NAME##prop_req_t question = {playerc_text_count(property), playerc_text(property), 0};    \
    player_##NAME##prop_req_t *answer = NULL;                                                                \
    const int result = playerc_ask(device, PLAYER_GET_##CONSTANT##PROP_REQ, &question, &answer);             \
    if (result != 0) return result;                                                                          \
    *value = answer->value;                                                                                  \
    player_##NAME##prop_req_t_free(answer);                                                                  \
    return 0;                                                                                                \
  }                                                                                                          \
  int playerc_device_set_##NAME##prop(playerc_device_t *device, const char *property, T value) {             \
    const player_##NAME##prop_req_t wanted = {playerc_text_count(property), playerc_text(property), STORED}; \
    return playerc_tell(device, PLAYER_SET_##CONSTANT##PROP_REQ, &wanted);                                   \
  }
NUMBER_PROPERTY(bool, BOOL, BOOL, (char)(value != 0))
NUMBER_PROPERTY(int, INT, int32_t, value)
NUMBER_PROPERTY(dbl, DBL, double, value)

int playerc_device_get_strprop(playerc_device_t *device, const char *property, char **value) {
  const player_strprop_req_t question = {playerc_text_count(property), playerc_text(property), 0, NULL};
  player_strprop_req_t *answer = NULL;
  const int result = playerc_ask(device, PLAYER_GET_STRPROP_REQ, &question, &answer);
  if (result != 0) return result;
  *value = answer->value;  // the text is the caller's now
  answer->value = NULL;
  answer->value_count = 0;
  player_strprop_req_t_free(answer);
  return *value != NULL ? 0 : playerc_fail_no_memory();
}

int playerc_device_set_strprop(playerc_device_t *device, const char *property, const char *value) {
  const player_strprop_req_t wanted = {playerc_text_count(property), playerc_text(property),
                                       playerc_text_count(value), playerc_text(value)};
  return playerc_tell(device, PLAYER_SET_STRPROP_REQ, &wanted);
}
