#define _POSIX_C_SOURCE 200809L

#include "exchange.h"

#include <errno.h>
#include <math.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "fail.h"
#include "memory.h"
#include "player_types.h"
#include "values.h"

static const double kConnectSeconds = 5.0;
static const double kClosingSeconds = 1.0;

// --- messages

static int order(const ph_message_type *row, uint16_t code, uint8_t kind, uint8_t subtype) {
  if (row->interface_code != code) return row->interface_code < code ? -1 : 1;
  if (row->kind != kind) return row->kind < kind ? -1 : 1;
  return (row->subtype > subtype) - (row->subtype < subtype);
}

static const ph_message_type *find_in_order(uint16_t code, uint8_t kind, uint8_t subtype) {
  size_t low = 0, high = PLAYER_MESSAGE_COUNT;
  while (low < high) {
    const size_t middle = (low + high) / 2;
    const int where = order(&player_messages[middle], code, kind, subtype);
    if (where == 0) return &player_messages[middle];
    if (where < 0) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return NULL;
}

const ph_message_type *playerc_find_message(uint16_t code, uint8_t kind, uint8_t subtype) {
  const ph_message_type *row = find_in_order(0, kind, subtype);
  return row != NULL ? row : find_in_order(code, kind, subtype);
}

/** The answer's body as an allocated value. */
static int decode_reply(const ph_message_type *row, const ph_answer *answer, void **reply) {
  if (row->payload == NULL || answer->header.size == 0) return 0;
  ph_arena arena = {NULL};
  ph_error error;
  void *value = malloc(row->payload->size);
  ph_status status = PH_NO_MEMORY;
  if (value != NULL) {
    status = ph_decode(row->payload, value, answer->body, answer->header.size, &arena, &error);
    *reply = status == PH_OK ? playerc_value_clone(row->payload, value) : NULL;
    if (status == PH_OK && *reply == NULL) status = PH_NO_MEMORY;
  }
  free(value);
  ph_arena_free(&arena);
  if (status == PH_NO_MEMORY) return playerc_fail_no_memory();
  return status == PH_OK ? 0 : playerc_fail_as(&error);
}

int playerc_request(playerc_client_t *client, uint16_t code, uint16_t index, uint8_t subtype,
                    const void *payload, void **reply) {
  if (reply != NULL) *reply = NULL;
  const ph_message_type *row = playerc_find_message(code, PH_KIND_REQ, subtype);
  if (client->session == NULL)
    return playerc_fail("there is no connection to %s:%d", client->host, client->port);
  if (row == NULL) return playerc_fail("%s has no request %d", interf_to_str(code), subtype);
  ph_error error;
  ph_answer answer;
  if (ph_session_request(&client->session->wire, code, index, row, payload, client->request_timeout, &answer,
                         &error) != PH_OK) {
    return playerc_fail_as(&error);
  }
  return reply != NULL ? decode_reply(row, &answer, reply) : 0;
}

static int ask_server(playerc_client_t *client, uint8_t subtype, const void *payload, void **reply) {
  return playerc_request(client, PLAYER_PLAYER_CODE, 0, subtype, payload, reply);
}

// --- making and connecting

playerc_client_t *playerc_client_create(playerc_mclient_t *mclient, const char *host, int port) {
  playerc_client_t *client = calloc(1, sizeof *client);
  if (client == NULL || (client->host = ph_copy_text(host)) == NULL) {
    free(client);
    playerc_fail_no_memory();
    return NULL;
  }
  client->id = client;
  client->port = port;
  client->transport = PLAYERC_TRANSPORT_TCP;
  client->mode = PLAYER_DATAMODE_PUSH;
  client->sock = -1;
  client->request_timeout = 5.0;
  client->retry_time = 2.0;
  if (mclient != NULL && playerc_mclient_addclient(mclient, client) != 0) {
    playerc_client_destroy(client);
    return NULL;
  }
  return client;
}

void playerc_client_destroy(playerc_client_t *client) {
  if (client == NULL) return;
  playerc_client_disconnect(client);
  free(client->host);
  free(client);
}

void playerc_client_set_transport(playerc_client_t *client, unsigned int transport) {
  client->transport = (int)transport;
}
void playerc_client_set_request_timeout(playerc_client_t *client, uint32_t seconds) {
  client->request_timeout = seconds;
}
void playerc_client_set_retry_limit(playerc_client_t *client, int limit) {
  client->retry_limit = limit;
}
void playerc_client_set_retry_time(playerc_client_t *client, double time) {
  client->retry_time = time;
}

/** A retired device sends nothing more, and the server refuses requests to it. */
static void retire(void *context, const ph_common_devaddr *address) {
  (void)context;
  (void)address;
}

/** Its host, as a session takes it; the caller frees it. */
static char *host_of(const playerc_client_t *client) {
  const char *way = client->transport == PLAYERC_TRANSPORT_UDP ? PH_UDP : "";
  const size_t size = strlen(way) + strlen(client->host) + 1;
  char *host = malloc(size);
  if (host != NULL) snprintf(host, size, "%s%s", way, client->host);
  return host;
}

static int open_session(playerc_client_t *client) {
  if (client->transport != PLAYERC_TRANSPORT_TCP && client->transport != PLAYERC_TRANSPORT_UDP)
    return playerc_fail("invalid transport %d: %d (TCP) and %d (UDP) are valid", client->transport,
                        PLAYERC_TRANSPORT_TCP, PLAYERC_TRANSPORT_UDP);
  if (client->port <= 0 || client->port > UINT16_MAX)
    return playerc_fail("invalid port %d: 1 to 65535 are valid", client->port);
  client->session = calloc(1, sizeof *client->session);
  if (client->session == NULL) return playerc_fail_no_memory();
  ph_session *wire = &client->session->wire;
  ph_error error;
  wire->connection.fd = -1;
  wire->retire = retire;
  char *host = host_of(client);
  if (host == NULL) return playerc_fail_no_memory();
  const ph_status opened = ph_session_open(wire, host, (uint16_t)client->port, kConnectSeconds, &error);
  free(host);
  if (opened != PH_OK) return playerc_fail_as(&error);
  client->sock = wire->connection.fd;
  client->connected = 1;
  return 0;
}

int playerc_client_disconnect(playerc_client_t *client) {
  client->connected = 0;
  client->sock = -1;
  if (client->session == NULL) return 0;
  ph_connection_close(&client->session->wire.connection, kClosingSeconds);
  ph_session_free(&client->session->wire);
  free(client->session);
  client->session = NULL;
  return 0;
}

int playerc_client_connect(playerc_client_t *client) {
  playerc_client_disconnect(client);
  if (open_session(client) == 0 && playerc_client_datamode(client, PLAYER_DATAMODE_PULL) == 0) return 0;
  playerc_client_disconnect(client);
  return -1;
}

static bool reopen(playerc_client_t *client) {
  if (playerc_client_connect(client) != 0) return false;
  for (int i = 0; i < client->device_count; ++i) {
    playerc_device_t *device = client->device[i];
    if (device->subscribed != 0 && playerc_device_subscribe(device, device->subscribed) != 0) return false;
  }
  return true;
}

int playerc_client_disconnect_retry(playerc_client_t *client) {
  playerc_client_disconnect(client);
  for (int tries = 0; client->retry_limit < 0 || tries < client->retry_limit; ++tries) {
    const struct timespec pause = {(time_t)client->retry_time, (long)(1e9 * fmod(client->retry_time, 1.0))};
    if (tries > 0) nanosleep(&pause, NULL);
    if (reopen(client)) return 0;
  }
  return -1;
}

int playerc_client_datamode(playerc_client_t *client, uint8_t mode) {
  const player_device_datamode_req_t wanted = {mode};
  const int result = ask_server(client, PLAYER_PLAYER_REQ_DATAMODE, &wanted, NULL);
  if (result == 0) client->mode = mode;
  return result;
}

int playerc_client_set_replace_rule(playerc_client_t *client, int interf, int index, int type, int subtype,
                                    int replace) {
  const player_add_replace_rule_req_t rule = {interf, index, type, subtype, replace};
  return ask_server(client, PLAYER_PLAYER_REQ_ADD_REPLACE_RULE, &rule, NULL);
}

// --- devices

int playerc_client_adddevice(playerc_client_t *client, playerc_device_t *device) {
  if (client->device_count >= PLAYER_MAX_DEVICES)
    return playerc_fail("a client has %d proxies at most", PLAYER_MAX_DEVICES);
  client->device[client->device_count++] = device;
  return 0;
}

int playerc_client_deldevice(playerc_client_t *client, playerc_device_t *device) {
  for (int i = 0; i < client->device_count; ++i) {
    if (client->device[i] != device) continue;
    --client->device_count;
    memmove(client->device + i, client->device + i + 1,
            (size_t)(client->device_count - i) * sizeof *client->device);
    return 0;
  }
  return playerc_fail("the proxy is none of this client");
}

int playerc_client_addcallback(playerc_client_t *client, playerc_device_t *device,
                               playerc_callback_fn_t callback, void *data) {
  (void)client;
  const int most = sizeof device->callback / sizeof *device->callback;
  if (device->callback_count >= most) return playerc_fail("a proxy has %d callbacks at most", most);
  device->callback[device->callback_count] = callback;
  device->callback_data[device->callback_count++] = data;
  return 0;
}

int playerc_client_delcallback(playerc_client_t *client, playerc_device_t *device,
                               playerc_callback_fn_t callback, void *data) {
  (void)client;
  for (int i = 0; i < device->callback_count; ++i) {
    if (device->callback[i] != callback || device->callback_data[i] != data) continue;
    --device->callback_count;
    for (; i < device->callback_count; ++i) {
      device->callback[i] = device->callback[i + 1];
      device->callback_data[i] = device->callback_data[i + 1];
    }
    return 0;
  }
  return playerc_fail("the proxy has no such callback");
}

static int fill_driver(playerc_client_t *client, playerc_device_info_t *info) {
  const player_device_driverinfo_t question = {.addr = info->addr};
  void *answer = NULL;
  const int result = ask_server(client, PLAYER_PLAYER_REQ_DRIVERINFO, &question, &answer);
  if (result != 0) return result;
  player_device_driverinfo_t *told = answer;
  snprintf(info->drivername, sizeof info->drivername, "%.*s",
           told != NULL ? (int)sizeof told->driver_name : 0, told != NULL ? told->driver_name : "");
  player_device_driverinfo_t_free(told);
  return 0;
}

int playerc_client_get_devlist(playerc_client_t *client) {
  void *answer = NULL;
  int result = ask_server(client, PLAYER_PLAYER_REQ_DEVLIST, NULL, &answer);
  player_device_devlist_t *list = answer;
  client->devinfo_count = 0;
  for (uint32_t i = 0; result == 0 && list != NULL && i < list->devices_count; ++i) {
    playerc_device_info_t *info = &client->devinfos[i];
    info->addr = list->devices[i];
    result = fill_driver(client, info);
    if (result == 0) ++client->devinfo_count;
  }
  player_device_devlist_t_free(list);
  return result;
}

static int set_access(playerc_client_t *client, int code, int index, int access, char *drivername,
                      size_t length) {
  const player_device_req_t wanted = {.addr = {.interf = (uint16_t)code, .index = (uint16_t)index},
                                      .access = (uint8_t)access};
  void *answer = NULL;
  int result = ask_server(client, PLAYER_PLAYER_REQ_DEV, &wanted, &answer);
  player_device_req_t *granted = answer;
  const char *verb = access == PLAYER_CLOSE_MODE ? "close" : "open";
  if (result == -2) {
    result = playerc_fail("%s:%d: there is no %s:%d", client->host, client->port,
                          interf_to_str((uint16_t)code), index);
  } else if (granted != NULL && granted->access == PLAYER_ERROR_MODE) {
    result = playerc_fail("%s:%d: cannot %s %s:%d", client->host, client->port, verb,
                          interf_to_str((uint16_t)code), index);
  }
  if (result == 0 && drivername != NULL && length > 0) {
    snprintf(drivername, length, "%.*s", granted != NULL ? (int)sizeof granted->driver_name : 0,
             granted != NULL ? granted->driver_name : "");
  }
  player_device_req_t_free(granted);
  return result;
}

int playerc_client_subscribe(playerc_client_t *client, int code, int index, int access, char *drivername,
                             size_t len) {
  return set_access(client, code, index, access, drivername, len);
}

int playerc_client_unsubscribe(playerc_client_t *client, int code, int index) {
  return set_access(client, code, index, PLAYER_CLOSE_MODE, NULL, 0);
}

int playerc_client_request(playerc_client_t *client, playerc_device_t *device, uint8_t reqtype,
                           const void *req_data, void **rep_data) {
  return playerc_request(client, device->addr.interf, device->addr.index, reqtype, req_data, rep_data);
}

int playerc_client_write(playerc_client_t *client, playerc_device_t *device, uint8_t subtype, void *cmd,
                         double *timestamp) {
  (void)timestamp;
  const ph_message_type *row = playerc_find_message(device->addr.interf, PH_KIND_CMD, subtype);
  if (client->session == NULL)
    return playerc_fail("there is no connection to %s:%d", client->host, client->port);
  if (row == NULL) return playerc_fail("%s has no command %d", interf_to_str(device->addr.interf), subtype);
  ph_error error;
  if (ph_session_send(&client->session->wire, device->addr.interf, device->addr.index, row, cmd, &error) ==
      PH_OK)
    return 0;
  return playerc_fail_as(&error);
}

// --- reading

static void hand_to(playerc_device_t *device, const player_msghdr_t *header, void *data) {
  device->lasttime = device->datatime;
  device->datatime = header->timestamp;
  device->fresh = 1;
  if (device->putmsg != NULL) device->putmsg(device, (char *)(uintptr_t)header, data);
  for (int i = 0; i < device->callback_count; ++i) device->callback[i](device->callback_data[i]);
}

/** Hands the value to the proxies of its address; returns the last one's id, NULL if there is none. */
static void *hand_out(playerc_client_t *client, const ph_header *from, void *data) {
  const player_msghdr_t header = {.addr = {from->host, from->robot, from->interface_code, from->index},
                                  .type = from->kind,
                                  .subtype = from->subtype,
                                  .timestamp = from->timestamp,
                                  .seq = from->sequence,
                                  .size = from->size};
  void *got = NULL;
  client->lasttime = client->datatime;
  client->datatime = from->timestamp;
  for (int i = 0; i < client->device_count; ++i) {
    playerc_device_t *device = client->device[i];
    if (device->addr.interf != from->interface_code || device->addr.index != from->index) continue;
    got = device->id;
    hand_to(device, &header, data);
  }
  return got;
}

/** Delivers a message; a proxy that was destroyed since, or an unknown message, is no error. */
static void *deliver(playerc_client_t *client, const ph_message *message) {
  const ph_header *header = &message->header;
  const ph_message_type *row = playerc_find_message(header->interface_code, PH_KIND_DATA, header->subtype);
  if (row == NULL || row->payload == NULL) return NULL;
  ph_arena arena = {NULL};
  void *value = malloc(row->payload->size), *got = NULL;
  if (value != NULL && ph_decode(row->payload, value, message->body, header->size, &arena, NULL) == PH_OK)
    got = hand_out(client, header, value);
  free(value);
  ph_arena_free(&arena);
  return got;
}

static void count_overflow(playerc_client_t *client) {
  struct playerc_session *session = client->session;
  client->overflow_count += (uint32_t)(session->wire.overflow_count - session->overflow_seen);
  session->overflow_seen = session->wire.overflow_count;
}

/** In push mode: the next message for a proxy. */
static ph_status read_message(playerc_client_t *client, double deadline, void **got, ph_error *error) {
  ph_session *wire = &client->session->wire;
  while (*got == NULL) {
    ph_message *message = ph_session_next_waiting(wire);
    if (message != NULL) {
      *got = deliver(client, message);
      free(message);
      continue;
    }
    const ph_status status = ph_session_sort_next(wire, deadline, error);
    if (status != PH_OK) return status;
  }
  return PH_OK;
}

/** In pull mode: a round of messages. */
static ph_status read_round(playerc_client_t *client, double deadline, void **got, ph_error *error) {
  ph_session *wire = &client->session->wire;
  ph_status status = ph_session_begin_round(wire, error);
  while (status == PH_OK) {
    for (ph_message *each = ph_session_next_waiting(wire); each != NULL;
         each = ph_session_next_waiting(wire)) {
      deliver(client, each);
      free(each);
    }
    if (!wire->round_open) break;
    status = ph_session_sort_next(wire, deadline, error);
  }
  if (status == PH_OK && wire->round_refused)
    status = ph_fail(error, PH_REQUEST_REFUSED, "%s: the server refuses to send data", ph_session_peer(wire));
  if (status == PH_OK) *got = client->id;
  return status;
}

/** 1: `*got` is set, 0: there is nothing yet, -1: error. */
static int read_until(playerc_client_t *client, double deadline, void **got) {
  *got = NULL;
  if (client->session == NULL)
    return playerc_fail("there is no connection to %s:%d", client->host, client->port);
  ph_error error;
  const ph_status status = client->mode == PLAYER_DATAMODE_PULL ? read_round(client, deadline, got, &error)
                                                                : read_message(client, deadline, got, &error);
  count_overflow(client);
  if (status == PH_OK) return 1;
  if (status == PH_REQUEST_TIMEOUT) return 0;
  playerc_fail_as(&error);
  const bool lost = status == PH_CONNECTION_LOST || status == PH_RUN_ENDED;
  if (lost && client->retry_limit != 0 && playerc_client_disconnect_retry(client) == 0)
    return read_until(client, deadline, got);
  return -1;
}

void *playerc_client_read(playerc_client_t *client) {
  void *got = NULL;
  read_until(client, INFINITY, &got);
  return got;
}

int playerc_client_read_nonblock_withproxy(playerc_client_t *client, void **proxy) {
  void *got = NULL;
  const int result = read_until(client, ph_now(), &got);
  if (proxy != NULL) *proxy = got;
  return result;
}

int playerc_client_read_nonblock(playerc_client_t *client) {
  return playerc_client_read_nonblock_withproxy(client, NULL);
}

int playerc_client_requestdata(playerc_client_t *client) {
  if (client->session == NULL)
    return playerc_fail("there is no connection to %s:%d", client->host, client->port);
  if (client->mode != PLAYER_DATAMODE_PULL) return 0;
  ph_error error;
  return ph_session_begin_round(&client->session->wire, &error) == PH_OK ? 0 : playerc_fail_as(&error);
}

int playerc_client_internal_peek(playerc_client_t *client, int timeout) {
  if (client->session == NULL)
    return playerc_fail("there is no connection to %s:%d", client->host, client->port);
  ph_session *wire = &client->session->wire;
  if (wire->waiting_count > 0 || ph_connection_buffered(&wire->connection)) return 1;
  struct pollfd there = {.fd = client->sock, .events = POLLIN};
  const int count = poll(&there, 1, timeout);
  if (count >= 0 || errno == EINTR) return count > 0;
  return playerc_fail("cannot wait for data: %s", strerror(errno));
}

int playerc_client_peek(playerc_client_t *client, int timeout) {
  return playerc_client_requestdata(client) == 0 ? playerc_client_internal_peek(client, timeout) : -1;
}
