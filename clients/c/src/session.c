#define _POSIX_C_SOURCE 200809L

#include "session.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "fail.h"
#include "memory.h"
#include "playhouse/c/client.h"
#include "playhouse/c/generated/player.h"
#include "text.h"

/** Limit on data queued for the next read while a request waits for its answer: the queue length of a server
 * per client. The oldest are dropped and counted. */
enum { WAITING_LIMIT = 1024 };

/** Access in an unrequested answer to an open request: the device was retired. (Failed ones have
 * PH_PLAYER_ERROR_MODE.) */
enum { ERROR_LETTER = 'e' };

static bool same_key(ph_key a, ph_key b) {
  return a.code == b.code && a.index == b.index && a.subtype == b.subtype;
}

ph_status ph_session_open(ph_session *session, const char *host, uint16_t port, double timeout,
                          ph_error *error) {
  session->timeout = timeout;
  return ph_connection_open(&session->connection, host, port, timeout, error);
}

void ph_session_free(ph_session *session) {
  ph_session_drop_all_waiting(session);
  ph_connection_free(&session->connection);
  ph_buffer_free(&session->out);
  ph_buffer_free(&session->refusal);
  free(session->abandoned);
}

ph_status ph_session_seconds(const ph_session *session, double timeout, double *seconds, ph_error *error) {
  *seconds = timeout == PH_OWN_TIMEOUT ? session->timeout : timeout;
  return ph_check_seconds(*seconds, error);
}

const char *ph_session_peer(const ph_session *session) {
  return session->connection.peer;
}

uint32_t ph_session_server_port(const ph_session *session) {
  return session->server_port != 0 ? session->server_port : session->connection.port;
}

// --- sending

static double epoch_seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static ph_status send_numbered(ph_session *session, uint16_t code, uint16_t index,
                               const ph_message_type *message, const void *payload, uint32_t sequence,
                               ph_error *error) {
  ph_buffer *out = &session->out;
  out->size = 0;
  if (!ph_buffer_reserve(out, PH_HEADER_BYTES)) return ph_fail_no_memory(error);
  out->size = PH_HEADER_BYTES;
  if (payload != NULL && message->payload != NULL) PH_TRY(ph_encode(message->payload, payload, out, error));
  const size_t size = out->size - PH_HEADER_BYTES;
  if (size > PH_MAX_BODY_BYTES) {
    return ph_fail(error, PH_WIRE_ERROR, "a message of %zu bytes is over the wire's limit of %d", size,
                   (int)PH_MAX_BODY_BYTES);
  }
  const ph_header header = {
      // As in libplayerc: the port in messages to a device, 0 in messages to the server.
      .robot = code == PH_PLAYER_CODE ? 0 : session->connection.port,
      .interface_code = code,
      .index = index,
      .kind = message->kind,
      .subtype = message->subtype,
      .timestamp = epoch_seconds(),
      .sequence = sequence,
      .size = (uint32_t)size,
  };
  ph_header_encode(&header, out->bytes);
  return ph_connection_send(&session->connection, out->bytes, out->size, error);
}

ph_status ph_session_send(ph_session *session, uint16_t code, uint16_t index, const ph_message_type *message,
                          const void *payload, ph_error *error) {
  return send_numbered(session, code, index, message, payload, 0, error);
}

// --- what is received

static bool answers(const ph_header *header, ph_key key) {
  const ph_key its = {header->interface_code, header->index, header->subtype};
  return (header->kind == PH_KIND_ACK || header->kind == PH_KIND_NACK) && same_key(its, key);
}

/** Processes the notice that a device was retired; false for any other message. */
static bool take_notice(ph_session *session, const ph_answer *message) {
  const ph_key opening = {PH_PLAYER_CODE, 0, PH_PLAYER_REQ_DEV->subtype};
  if (message->header.kind != PH_KIND_ACK || !answers(&message->header, opening)) return false;
  ph_arena arena = {NULL};
  ph_player_device_req notice;
  const ph_status status =
      ph_player_device_req_decode(&notice, message->body, message->header.size, &arena, NULL);
  ph_arena_free(&arena);
  if (status != PH_OK || notice.access != ERROR_LETTER) return false;
  session->told = true;
  session->retire(session->context, &notice.addr);
  return true;
}

static void end_round(ph_session *session, const ph_answer *message) {
  session->round_open = false;
  session->round_waits = session->waiting_count > 0;
  if (message->header.subtype != PH_PLAYER_SYNCH_OVERFLOW->subtype) return;
  ph_common_uint32 lost = {0};
  ph_arena arena = {NULL};
  const ph_status status = ph_common_uint32_decode(&lost, message->body, message->header.size, &arena, NULL);
  session->overflow_count += status == PH_OK && lost.value > 1 ? lost.value : 1;
}

static ph_status queue(ph_session *session, const ph_answer *message, ph_error *error) {
  if (session->waiting_count == WAITING_LIMIT) {
    free(ph_session_next_waiting(session));
    ++session->overflow_count;
    ++session->unread_count;
  }
  ph_message *kept = malloc(sizeof *kept + message->header.size);
  if (kept == NULL) return ph_fail_no_memory(error);
  kept->next = NULL;
  kept->header = message->header;
  if (message->header.size > 0) memcpy(kept->body, message->body, message->header.size);
  if (session->newest != NULL) {
    session->newest->next = kept;
  } else {
    session->oldest = kept;
  }
  session->newest = kept;
  ++session->waiting_count;
  return PH_OK;
}

static ph_status sort(ph_session *session, const ph_answer *message, ph_error *error) {
  const ph_key data = {PH_PLAYER_CODE, 0, PH_PLAYER_REQ_DATA->subtype};
  if (message->header.kind == PH_KIND_DATA) return queue(session, message, error);
  if (message->header.kind == PH_KIND_SYNCH) {
    end_round(session, message);
  } else if (!answers(&message->header, data)) {
    ++session->skipped_count;
  } else if (message->header.kind == PH_KIND_NACK) {
    session->round_open = false;
    session->round_refused = true;
  }
  return PH_OK;
}

ph_message *ph_session_next_waiting(ph_session *session) {
  ph_message *taken = session->oldest;
  if (taken == NULL) return NULL;
  session->oldest = taken->next;
  if (session->oldest == NULL) session->newest = NULL;
  --session->waiting_count;
  return taken;
}

void ph_session_drop_all_waiting(ph_session *session) {
  for (ph_message *each = ph_session_next_waiting(session); each != NULL;
       each = ph_session_next_waiting(session)) {
    free(each);
  }
}

void ph_session_drop_waiting(ph_session *session, uint16_t code, uint16_t index) {
  ph_message **link = &session->oldest, *kept = NULL;
  while (*link != NULL) {
    ph_message *each = *link;
    if (each->header.interface_code == code && each->header.index == index) {
      *link = each->next;
      free(each);
      --session->waiting_count;
      ++session->skipped_count;
    } else {
      kept = each;
      link = &each->next;
    }
  }
  session->newest = kept;
}

// --- requests

/** The place of an abandoned request of this key, or their number. */
static size_t find_abandoned(const ph_session *session, ph_key key) {
  size_t at = 0;
  while (at < session->abandoned_count && !same_key(session->abandoned[at], key)) ++at;
  return at;
}

/** 0 is the number of requests before the first time-out, and of servers that do not return numbers. */
static bool is_ours(const ph_session *session, uint32_t sequence, ph_key key) {
  if (sequence != 0) return sequence == session->sequence;
  return find_abandoned(session, key) == session->abandoned_count;
}

/** From now on requests are numbered, so that a late answer to this one is not matched to another. */
static void abandon(ph_session *session, ph_key key, bool settled) {
  ++session->sequence;
  if (settled) return;  // a missing answer came meanwhile: as many as before are missing
  if (!ph_grow(&session->abandoned, session->abandoned_count, &session->abandoned_capacity, sizeof key))
    return;
  session->abandoned[session->abandoned_count++] = key;
}

/** Skips a late answer to an abandoned request; true if one of this key was missing. */
static bool settle(ph_session *session, ph_key key) {
  ++session->skipped_count;
  const size_t at = find_abandoned(session, key);
  if (at == session->abandoned_count) return false;
  session->abandoned[at] = session->abandoned[--session->abandoned_count];
  return true;
}

static ph_status receive(ph_session *session, double deadline, ph_answer *message, ph_error *error) {
  return ph_connection_receive(&session->connection, deadline, &message->header, &message->body, error);
}

static ph_status await_answer(ph_session *session, ph_key key, double deadline, ph_answer *answer,
                              ph_error *error) {
  bool settled = false;
  for (;;) {
    ph_status status = receive(session, deadline, answer, error);
    if (status == PH_OK && take_notice(session, answer)) continue;
    if (status == PH_OK && answers(&answer->header, key)) {
      if (is_ours(session, answer->header.sequence, key)) return PH_OK;
      settled = settle(session, key) || settled;
      continue;
    }
    if (status == PH_OK) status = sort(session, answer, error);
    if (status != PH_OK) {
      abandon(session, key, settled);
      return status;
    }
  }
}

ph_status ph_session_request(ph_session *session, uint16_t code, uint16_t index,
                             const ph_message_type *message, const void *payload, double seconds,
                             ph_answer *answer, ph_error *error) {
  ph_answer unused;
  if (answer == NULL) answer = &unused;
  PH_TRY(send_numbered(session, code, index, message, payload, session->sequence, error));
  const ph_key key = {code, index, message->subtype};
  char device[PH_NAME_BYTES], number[PH_NUMBER_BYTES];
  ph_device_text(code, index, device);
  const ph_status status = await_answer(session, key, ph_now() + seconds, answer, error);
  if (status == PH_REQUEST_TIMEOUT) {
    return ph_fail(error, status, "%s: no answer to %s of %s in %s s", ph_session_peer(session),
                   message->name, device, ph_number_text(seconds, number));
  }
  if (status != PH_OK) return status;
  session->server_port = answer->header.robot;
  if (answer->header.kind != PH_KIND_NACK) return PH_OK;
  session->refusal.size = 0;
  if (!ph_buffer_append(&session->refusal, answer->body, answer->header.size))
    return ph_fail_no_memory(error);
  return ph_fail(error, PH_REQUEST_REFUSED, "%s: %s of %s was refused", ph_session_peer(session),
                 message->name, device);
}

// --- rounds

ph_status ph_session_begin_round(ph_session *session, ph_error *error) {
  const bool here = session->round_waits && session->waiting_count > 0;
  session->round_waits = false;
  const bool may_be_lost = session->connection.datagrams;  // by UDP: what a read left open is asked for again
  if ((session->round_open && !may_be_lost) || here) return PH_OK;
  session->round_open = true;
  session->round_refused = false;
  ph_error why;
  const ph_status status =
      send_numbered(session, PH_PLAYER_CODE, 0, PH_PLAYER_REQ_DATA, NULL, session->sequence, &why);
  // Data from before a disconnection are still to be received, then the same error.
  const bool later = status == PH_OK || status == PH_CONNECTION_LOST || status == PH_RUN_ENDED;
  return later ? PH_OK : ph_fail_as(error, &why);
}

ph_status ph_session_sort_next(ph_session *session, double deadline, ph_error *error) {
  ph_answer message;
  PH_TRY(receive(session, deadline, &message, error));
  return take_notice(session, &message) ? PH_OK : sort(session, &message, error);
}
