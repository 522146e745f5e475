#include "client.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fail.h"
#include "playhouse/c/generated/player.h"
#include "value.h"

static const double kClosingSeconds = 1.0;

enum { kTokenLetters = 32 };

static void retire(void *context, const ph_common_devaddr *address);
static ph_status authenticate(ph_client *client, const char *token, ph_error *error);

// --- connecting and closing

/** Host, with "udp:" in front if so, and port of an address; an IPv6 host is in brackets. The host is shorter than
 * the address and PH_DEFAULT_HOST together. */
static void split(const char *address, char *host, const char **port) {
  static const char default_port[] = "6665";
  const size_t way = strncmp(address, PH_UDP, strlen(PH_UDP)) == 0 ? strlen(PH_UDP) : 0;
  memcpy(host, address, way);
  host += way;
  address += way;
  const char *begin = address[0] == '[' ? address + 1 : address;
  const char *end = address[0] == '[' ? strchr(begin, ']') : strrchr(begin, ':');
  const size_t length = end != NULL ? (size_t)(end - begin) : strlen(begin);
  memcpy(host, begin, length);
  host[length] = '\0';
  if (length == 0) strcpy(host, PH_DEFAULT_HOST);
  if (end == NULL || (*end == ']' && end[1] == '\0')) {
    *port = default_port;
  } else {
    *port = *end == ']' ? end + 2 : end + 1;
  }
}

/** The number of a port, 0 if the word is not one. */
static uint16_t port_of(const char *word) {
  unsigned long port = 0;
  if (*word == '\0') return 0;
  for (; *word != '\0'; ++word) {
    if (*word < '0' || *word > '9' || port > UINT16_MAX) return 0;
    port = 10 * port + (unsigned long)(*word - '0');
  }
  return port <= UINT16_MAX ? (uint16_t)port : 0;
}

static ph_status open_session(ph_client *client, const char *address, double timeout, ph_error *error) {
  char *host = malloc(strlen(address) + sizeof PH_DEFAULT_HOST);
  if (host == NULL) return ph_fail_no_memory(error);
  const char *word = NULL;
  split(address, host, &word);
  const uint16_t port = port_of(word);
  const ph_status status =
      port == 0 ? ph_fail(error, PH_CONNECTION_LOST, "\"%s\" is not HOST or HOST:PORT", address)
                : ph_session_open(&client->session, host, port, timeout, error);
  free(host);
  return status;
}

ph_client *ph_connect(const char *address, const ph_options *options, ph_error *error) {
  static const ph_options defaults = PH_DEFAULT_OPTIONS;
  if (options == NULL) options = &defaults;
  ph_client *client = calloc(1, sizeof *client);
  if (client == NULL) {
    ph_fail_no_memory(error);
    return NULL;
  }
  client->session.connection.fd = -1;
  client->session.retire = retire;
  client->session.context = client;
  client->mode = PH_MODE_PUSH;  // initial mode of a server
  ph_status status =
      open_session(client, address != NULL ? address : PH_DEFAULT_HOST, options->timeout, error);
  if (status == PH_OK && options->token != NULL && options->token[0] != '\0')
    status = authenticate(client, options->token, error);
  if (status == PH_OK && options->mode != PH_MODE_PUSH)
    status = ph_client_set_mode(client, options->mode, error);
  if (status == PH_OK) return client;
  ph_client_free(client);
  return NULL;
}

void ph_client_close(ph_client *client) {
  while (client->open_count > 0) {  // the last of the last address, and so on
    ph_device *device = client->open[client->open_count - 1];
    while (device->same != NULL) device = device->same;
    ph_device_close(device, NULL);  // closing the connection closes it as well
  }
  ph_connection_close(&client->session.connection, kClosingSeconds);
}

void ph_client_free(ph_client *client) {
  if (client == NULL) return;
  ph_client_close(client);
  for (size_t i = 0; i < client->robot_count; ++i) ph_robot_free(client->robots[i]);
  while (client->newest != NULL) {
    ph_device *device = client->newest;
    client->newest = device->newer;
    ph_device_release(device);
  }
  ph_session_free(&client->session);
  ph_models_free(&client->models);
  ph_arena_free(&client->entries_arena);
  free(client->open);
  free(client->robots);
  free(client->listed);
  free(client);
}

// --- the lists of devices

/** The place of an address among the open ones, or their number. Messages come in the order of devices, so
 * the search goes on where the last one ended. */
static size_t find_open(ph_client *client, uint16_t code, uint16_t index) {
  for (size_t i = 0; i < client->open_count; ++i) {
    const size_t at = (client->cursor + i) % client->open_count;
    if (client->open[at]->code == code && client->open[at]->index == index) {
      client->cursor = at + 1;
      return at;
    }
  }
  return client->open_count;
}

bool ph_client_add(ph_client *client, ph_device *device) {
  device->newer = client->newest;
  client->newest = device;
  const size_t at = find_open(client, device->code, device->index);
  if (at == client->open_count) {
    if (!ph_grow(&client->open, at, &client->open_capacity, sizeof *client->open)) return false;
    client->open[client->open_count++] = device;
    return true;
  }
  bool replaces = false;
  ph_device *last = client->open[at];
  for (ph_device *each = last; each != NULL; each = each->same) {
    replaces = replaces || each->gone[0] != '\0';
    last = each;
  }
  if (replaces) ph_session_drop_waiting(&client->session, device->code, device->index);
  last->same = device;
  return true;
}

void ph_client_forget(ph_client *client, ph_device *device) {
  const size_t at = find_open(client, device->code, device->index);
  if (at == client->open_count) return;
  ph_device **link = &client->open[at];
  while (*link != NULL && *link != device) link = &(*link)->same;
  if (*link == NULL) return;
  *link = device->same;
  device->same = NULL;
  if (client->open[at] != NULL) return;
  --client->open_count;
  memmove(client->open + at, client->open + at + 1, (client->open_count - at) * sizeof *client->open);
  if (device->gone[0] != '\0') ph_session_drop_waiting(&client->session, device->code, device->index);
}

void ph_device_free(ph_device *device) {
  if (device == NULL) return;
  ph_client *client = device->client;
  ph_device_close(device, NULL);
  for (size_t i = 0; i < client->robot_count; ++i) ph_robot_forget(client->robots[i], device);
  device->to_free = true;
  if (client->reading) return;  // until the end of the read, which may be using it
  ph_device **link = &client->newest;
  while (*link != device) link = &(*link)->newer;
  *link = device->newer;
  ph_device_release(device);
}

/** Releases what callbacks have freed. */
static void sweep(ph_client *client) {
  ph_device **link = &client->newest;
  while (*link != NULL) {
    ph_device *each = *link;
    if (each->to_free) {
      *link = each->newer;
      ph_device_release(each);
    } else {
      link = &each->newer;
    }
  }
}

static void retire(void *context, const ph_common_devaddr *address) {
  ph_client *client = context;
  const size_t at = find_open(client, address->interf, address->index);
  if (at == client->open_count) return;
  for (ph_device *each = client->open[at]; each != NULL; each = each->same)
    ph_device_retire(each, address->robot);
}

// --- what it tells

const char *ph_client_banner(const ph_client *client) {
  return client->session.connection.banner;
}
const char *ph_client_peer(const ph_client *client) {
  return ph_session_peer(&client->session);
}
bool ph_client_connected(const ph_client *client) {
  return ph_connection_alive(&client->session.connection);
}
ph_mode ph_client_mode(const ph_client *client) {
  return client->mode;
}
uint64_t ph_client_overflow_count(const ph_client *client) {
  return client->session.overflow_count;
}
uint64_t ph_client_skipped_count(const ph_client *client) {
  return client->session.skipped_count;
}

const void *ph_client_refusal(const ph_client *client, size_t *size) {
  *size = client->session.refusal.size;
  return client->session.refusal.bytes;
}

// --- requests to the server

static ph_status ask_server(ph_client *client, const ph_message_type *message, const void *payload,
                            ph_answer *answer, ph_error *error) {
  ph_session *session = &client->session;
  return ph_session_request(session, PH_PLAYER_CODE, 0, message, payload, session->timeout, answer, error);
}

static ph_status authenticate(ph_client *client, const char *token, ph_error *error) {
  const size_t letters = strlen(token);
  if (letters > kTokenLetters)
    return ph_fail(error, PH_INVALID_VALUE, "a token has %d letters at most, not %zu", kTokenLetters,
                   letters);
  const ph_player_device_auth_req key = {(const uint8_t *)token, (uint32_t)letters};
  const ph_status status = ask_server(client, PH_PLAYER_REQ_AUTH, &key, NULL, error);
  if (status != PH_REQUEST_REFUSED) return status;
  return ph_fail(error, status, "%s: the token is refused; a run without --guests needs none",
                 ph_client_peer(client));
}

ph_status ph_client_lost_count(ph_client *client, uint64_t *count, ph_error *error) {
  const ph_common_intprop_req question = {.key = "lost", .key_count = sizeof "lost"};
  ph_answer answer;
  PH_TRY(ask_server(client, PH_COMMON_REQ_GET_INTPROP, &question, &answer, error));
  ph_arena arena = {NULL};
  ph_common_intprop_req told;
  const ph_status status =
      ph_common_intprop_req_decode(&told, answer.body, answer.header.size, &arena, error);
  ph_arena_free(&arena);
  if (status == PH_OK)
    *count = (uint64_t)told.value + client->session.unread_count + client->session.connection.lost_count;
  return status;
}

ph_status ph_client_set_mode(ph_client *client, ph_mode mode, ph_error *error) {
  if (mode != PH_MODE_PUSH && mode != PH_MODE_PULL)
    return ph_fail(error, PH_INVALID_VALUE, "a mode is PH_MODE_PUSH or PH_MODE_PULL, not %d", (int)mode);
  const ph_player_device_datamode_req body = {(uint8_t)mode};
  PH_TRY(ask_server(client, PH_PLAYER_REQ_DATAMODE, &body, NULL, error));
  client->mode = mode;
  return PH_OK;
}

ph_status ph_client_set_replace_rule(ph_client *client, ph_rule rule, const ph_rule_scope *scope,
                                     ph_error *error) {
  static const ph_rule_scope every = PH_EVERY_MESSAGE;
  if (scope == NULL) scope = &every;
  const ph_player_add_replace_rule_req body = {scope->interface_code, scope->index, scope->kind,
                                               scope->subtype, (int32_t)rule};
  return ask_server(client, PH_PLAYER_REQ_ADD_REPLACE_RULE, &body, NULL, error);
}

// --- reading

/** Whether a device takes a message. The last data of a retired device belong to it, unless a new device has
 * its address. */
static bool takes(const ph_device *device, bool any_there) {
  return device->open && (device->gone[0] == '\0' || !any_there);
}

/** Drops the data of devices whose last are later than this time (s): of a run that is over when time goes
 * back. */
static void forget_later(ph_client *client, double timestamp) {
  for (size_t i = 0; i < client->open_count; ++i) {
    for (ph_device *each = client->open[i]; each != NULL; each = each->same) {
      if (each->timestamp > timestamp) ph_device_forget_data(each);
    }
  }
}

void ph_client_forget_run(ph_client *client) {
  ph_session_drop_all_waiting(&client->session);
  forget_later(client, -INFINITY);
}

/** Hands a value to the devices of its address, as they are before the first callback. */
static ph_status hand_out(ph_client *client, size_t at, const ph_value *value, ph_error *error) {
  bool any_there = false, goes_back = false;
  size_t count = 0;
  for (ph_device *each = client->open[at]; each != NULL; each = each->same) {
    goes_back = goes_back || ph_device_goes_back(each, value);
    any_there = any_there || each->gone[0] == '\0';
    ++count;
  }
  if (goes_back) forget_later(client, value->timestamp);  // another client restarted or rewound the run
  ph_device *few[8], **takers = count <= 8 ? few : malloc(count * sizeof *takers);
  if (takers == NULL) return ph_fail_no_memory(error);
  count = 0;
  for (ph_device *each = client->open[at]; each != NULL; each = each->same) {
    if (takes(each, any_there)) takers[count++] = each;
  }
  ph_status status = PH_OK;
  for (size_t i = 0; i < count && status == PH_OK; ++i) {
    if (takers[i]->open) status = ph_device_take(takers[i], value, error);
  }
  if (takers != few) free(takers);
  return status;
}

/** Delivers one message; PH_WIRE_ERROR if it is for nobody or does not decode. */
static ph_status deliver_one(ph_client *client, const ph_message *message, ph_error *error) {
  const ph_header *header = &message->header;
  const ph_message_type *row = ph_find_message(header->interface_code, PH_KIND_DATA, header->subtype);
  const size_t at = find_open(client, header->interface_code, header->index);
  if (row == NULL || row->payload == NULL || at == client->open_count) return PH_WIRE_ERROR;
  ph_value *value = NULL;
  PH_TRY(ph_value_decode(row, message->body, header->size, header->timestamp, &value, NULL));
  const ph_status status = hand_out(client, at, value, error);
  ph_value_free(value);
  return status;
}

/** Delivers what is queued and adds the number of messages to `delivered`. */
static ph_status deliver(ph_client *client, size_t *delivered, ph_error *error) {
  for (ph_message *each = ph_session_next_waiting(&client->session); each != NULL;
       each = ph_session_next_waiting(&client->session)) {
    const ph_status status = deliver_one(client, each, error);
    free(each);
    if (status == PH_NO_MEMORY) return ph_fail_no_memory(error);
    if (status == PH_OK) {
      ++*delivered;
    } else {
      ++client->session.skipped_count;
    }
  }
  return PH_OK;
}

static bool wants_more(const ph_client *client, size_t delivered) {
  const ph_session *session = &client->session;
  if (session->told && delivered == 0) return false;
  if (client->mode == PH_MODE_PULL) return session->round_open;
  return delivered == 0 || ph_connection_buffered(&session->connection);
}

/** Delivers queued messages, and new ones while more are wanted. A disconnection after data is left to the
 * next call, so that the data are delivered first. */
static ph_status receive(ph_client *client, double deadline, size_t *delivered, ph_error *error) {
  ph_session *session = &client->session;
  PH_TRY(deliver(client, delivered, error));
  while (wants_more(client, *delivered)) {
    ph_error why;
    const ph_status status = ph_session_sort_next(session, deadline, &why);
    const bool ends = status == PH_CONNECTION_LOST || status == PH_RUN_ENDED || status == PH_REQUEST_TIMEOUT;
    if (ends && *delivered > 0) return PH_OK;
    if (status == PH_REQUEST_TIMEOUT) {
      return ph_fail(error, status, "%s: no data in time", ph_session_peer(session));
    }
    if (status != PH_OK) return ph_fail_as(error, &why);
    PH_TRY(deliver(client, delivered, error));
  }
  return PH_OK;
}

static ph_status read_some(ph_client *client, double deadline, size_t *delivered, ph_error *error) {
  ph_session *session = &client->session;
  if (client->mode == PH_MODE_PULL) PH_TRY(ph_session_begin_round(session, error));
  PH_TRY(receive(client, deadline, delivered, error));
  if (client->mode == PH_MODE_PULL && session->round_refused && *delivered == 0) {
    return ph_fail(error, PH_REQUEST_REFUSED, "%s: the server refuses to send data",
                   ph_session_peer(session));
  }
  return PH_OK;
}

ph_status ph_client_read(ph_client *client, double timeout, size_t *count, ph_error *error) {
  if (client->reading) {
    return ph_fail(error, PH_MISUSED, "read() was called from a callback that read() itself is running");
  }
  double seconds = 0.0;
  size_t delivered = 0;
  PH_TRY(ph_session_seconds(&client->session, timeout, &seconds, error));
  client->reading = true;
  client->session.told = false;
  const ph_status status = read_some(client, ph_now() + seconds, &delivered, error);
  client->reading = false;
  sweep(client);
  if (status == PH_OK && count != NULL) *count = delivered;
  return status;
}

ph_status ph_client_deliver_pushed(ph_client *client, ph_error *error) {
  if (client->mode != PH_MODE_PUSH || client->reading) return PH_OK;
  size_t delivered = 0;
  client->reading = true;
  const ph_status status = deliver(client, &delivered, error);
  client->reading = false;
  sweep(client);
  return status;
}
